"""A text as the page needs it: what is in it and where, what is wrong, and how to mend it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from difflib import SequenceMatcher
from pathlib import Path
from typing import Any, cast

from freebody.errors import FreebodyError, ModelError, Problem
from freebody.language.document import Document, Place
from freebody.messages import Message
from freebody.studio.meanings import letters, typeset
from freebody.studio.nudged import nudged
from freebody.studio.telling import told
from freebody.studio.wire.said import Language, Span
from freebody.studio.wire.texts import Asked, Element, Fix, Leaf, Parameter, ReadAnswer, ReadRequest, Remark
from freebody.system.system import System

# sections whose entries have names, by their path
_SECTIONS: tuple[tuple[str, ...], ...] = (
    ("parameters",),
    ("ground", "points"),
    ("ground", "lines"),
    ("bodies",),
    ("connections",),
    ("loads",),
    ("measures",),
    ("start",),
    ("questions",),
)
_HINT, _ONE_OF = " Did you mean {x}?", " Did you mean one of {names}?"
_MOST = 200  # remarks that anybody would read


class Places:
    """Where things stand in a text, in UTF-16 units from 0."""

    def __init__(self, text: str) -> None:
        self.text = text
        self._is_plain = text.isascii()
        self.lines = [0]
        for line in text.splitlines(keepends=True):
            self.lines.append(self.lines[-1] + len(line))

    def span(self, start: int, end: int) -> Span:
        return Span(start=self._units(start), end=self._units(end))

    def _units(self, index: int) -> int:
        return index if self._is_plain else len(self.text[:index].encode("utf-16-le", "surrogatepass")) // 2

    def word(self, line: int, column: int) -> tuple[int, int]:
        """From a place, both from 1, to the end of its line without spaces and comments."""
        if not 1 <= line < len(self.lines):
            return len(self.text), len(self.text)
        start, end = self.lines[line - 1] + column - 1, self.lines[line]
        rest = self.text[start:end].split(" #")[0].rstrip()
        return start, start + max(1, len(rest)) if end > start else end


def read(request: ReadRequest) -> ReadAnswer:
    """What a text says, and all that is wrong with it."""
    places = Places(request.text)
    document: Document | None = None
    system: System | None = None
    remarks: list[Remark] = []
    try:
        document = document_of(request.text)
        system = System.from_document(document)
    except ModelError as error:
        remarks = [_remark(problem, "error", places, document, request.language) for problem in error.problems[:_MOST]]
    if system is not None:
        remarks = [_remark(p, "warning", places, document, request.language) for p in _warnings(system)]
    elements = [] if document is None else list(_elements(document, places))
    return ReadAnswer(
        is_model=system is not None,
        title="" if system is None else system.title,
        about="" if system is None else system.about,
        is_spatial=system is not None and system.space,
        remarks=remarks,
        elements=elements,
        parameters=[] if document is None else list(parameters_of(document, system, places)),
        questions=[]
        if system is None
        else [Asked(id=q.id, text=told(q.text, request.language)) for q in system.questions],
        moving=[] if system is None else [body.name for body in system.moving],
    )


def _warnings(system: System) -> list[Problem]:
    from freebody.study.model_warnings import warnings_of

    try:
        return [warning.problem for warning in warnings_of(system)]
    except (FreebodyError, ArithmeticError):
        return []  # where the model cannot be assembled its motion says so


def _remark(problem: Problem, severity: Any, places: Places, document: Document | None, language: Language) -> Remark:
    start, end = _where(problem, places, document)
    return Remark(
        severity=severity,
        message=told(problem.message, language),
        where=".".join(map(str, problem.path)),
        line=problem.line or 0,
        span=places.span(start, end),
        fixes=list(_fixes(problem.message, places, (start, end), language)),
    )


def _where(problem: Problem, places: Places, document: Document | None) -> tuple[int, int]:
    """The indices of what a problem is about: its key where that is misspelt, else its value."""
    if document is not None and problem.path:
        key, value = document.key_span(problem.path), document.span(problem.path)
        words = {str(word) for word in _arguments(problem.message)}
        if key is not None and (value is None or str(problem.path[-1]) in words):
            return key
        if value is not None:
            return value
        around = document.span(problem.path[:-1])  # an entry of a list may be called by its field
        if around is not None and places.text[around[0] : around[0] + 1] == "[":
            return around
    return places.word(problem.line or 1, problem.column or 1)


def _arguments(message: str) -> Iterator[object]:
    """All that stands in the places of a message, and of those within it."""
    for argument in getattr(message, "arguments", {}).values():
        yield argument
        yield from _arguments(argument)


def _fixes(message: str, places: Places, span: tuple[int, int], language: Language) -> Iterator[Fix]:
    """Where a name is misspelt, the one that is meant in its place."""
    part = places.text[span[0] : span[1]]
    for inner in (message, *(a for a in _arguments(message) if isinstance(a, Message))):
        if not isinstance(inner, Message) or inner.template not in (_HINT, _ONE_OF):
            continue
        known = str(next(iter(inner.arguments.values()))).split(", ")
        wrong = _misspelt(part, known, [str(a) for a in _arguments(message)])
        if wrong is None:
            continue
        for name in known:
            label = told(Message("replace {wrong} by {right}", wrong=part[slice(*wrong)], right=name), language)
            yield Fix(label=label, span=places.span(span[0] + wrong[0], span[0] + wrong[1]), text=name)


def _misspelt(part: str, known: Sequence[str], words: Sequence[str]) -> tuple[int, int] | None:
    """Where in a part of the text the word stands that a message is about: the likest to what is meant."""
    found = [word for word in words if word and word not in known and " " not in word and part.count(word) == 1]
    if not found:
        return None
    word = max(found, key=lambda each: SequenceMatcher(None, each, known[0]).ratio())
    return part.index(word), part.index(word) + len(word)


def _elements(document: Document, places: Places) -> Iterator[Element]:
    data = document.data
    for section in _SECTIONS:
        found: Any = data
        for part in section:
            found = mapping_of(found).get(part)
        for key, value in entries_of(found):
            path: Place = (*section, key)
            span, name = document.span(path), document.key_span(path)
            if span is None:
                continue
            whole = name or span
            yield Element(
                section=section[-1] if section[0] != "ground" else "ground",
                name=_name_of(key, value),
                kind=_kind_of(value),
                path=list(path),
                name_span=places.span(*whole),
                span=places.span(whole[0], span[1]),
                leaves=list(_leaves(document, places, path, value)),
            )


def entries_of(value: Any) -> list[tuple[str | int, Any]]:
    """The entries of a mapping or a list, with their keys; none of anything else."""
    if isinstance(value, list):
        return list(enumerate(cast("list[Any]", value)))
    return list(mapping_of(value).items())


def _name_of(key: str | int, value: Any) -> str:
    """Questions in a list are named by their id."""
    if isinstance(key, str):
        return key
    entry = mapping_of(value)
    return str(entry.get("id") or entry.get("find") or value)


def _kind_of(value: Any) -> str:
    return str(next(iter(mapping_of(value)), ""))


def _leaves(document: Document, places: Places, path: Place, value: Any) -> Iterator[Leaf]:
    """Every single value under a path."""
    if isinstance(value, dict | list):
        for key, each in entries_of(cast("Any", value)):
            yield from _leaves(document, places, (*path, key), each)
        return
    span = document.span(path)
    if span is not None:
        words = [f"{part + 1}" if isinstance(part, int) else part for part in path[1:]]
        text = "" if value is None else str(value) if isinstance(value, str) else places.text[slice(*span)]
        yield Leaf(path=list(path), label=".".join(words[1:]) or words[0], text=text, span=places.span(*span))


def parameters_of(document: Document, system: System | None, places: Places) -> Iterator[Parameter]:
    """Parameters and values of the start that have a number, with where it stands."""
    for name, value in mapping_of(document.data.get("parameters")).items():
        path: Place = ("parameters", name, "value") if isinstance(value, dict) else ("parameters", name)
        known = None if system is None else system.parameters.get(name)
        if known is None or known.value is not None:
            is_positive = known is None or known.sign != "any"
            yield from _number(document, places, "parameters", path, is_positive=is_positive)
    for name in mapping_of(document.data.get("start")):
        yield from _number(document, places, "start", ("start", name), is_positive=False)


def mapping_of(value: Any) -> dict[str, Any]:
    """A part of a document that should be a mapping; an empty one where it is none."""
    return cast("dict[str, Any]", value) if isinstance(value, dict) else {}


def _number(document: Document, places: Places, section: Any, path: Place, *, is_positive: bool) -> Iterator[Parameter]:
    span = document.span(path)
    if span is not None and span[0] < span[1]:
        text = places.text[slice(*span)]
        name = str(path[1])
        math = typeset(name) if name.isidentifier() else ""
        at = places.span(*span)
        yield Parameter(
            name=name,
            symbol=letters(math),
            math=math,
            section=section,
            text=text,
            span=at,
            is_positive=is_positive,
        )


_latest: list[Document] = []  # what was read last: a slider moves one number of it
_systems: list[System] = []  # the one of it
_folders: list[Path] = []  # in which the files are that a text names


def look_in(folders: Iterable[str]) -> None:
    """Where the files are that models name: set once, when a worker starts."""
    _folders[:] = map(Path, folders)
    _latest.clear()
    _systems.clear()


def document_of(text: str) -> Document:
    """The document of a text. Raises ModelError."""
    _latest[:] = [_latest[0].reread(text) if _latest else Document.read(text, folders=_folders)]
    return _latest[0]


def checked_system(text: str) -> System:
    """The system of a text. Raises ModelError."""
    _systems[:] = [System.from_document(document_of(text))]
    return _systems[0]


def passing_system(text: str) -> System:
    """The system of a text for a motion that is soon replaced. Raises ModelError."""
    document = document_of(text)
    _systems[:] = [(nudged(_systems[0], document) if _systems else None) or System.from_document(document)]
    return _systems[0]
