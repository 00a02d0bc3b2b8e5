"""From text to the tree, by YAML's event stream alone: no object is built from a tag, no alias is followed.

Every refusal is noted with its place, and all of them are raised together.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any, NoReturn

from ruamel.yaml import YAML
from ruamel.yaml.error import YAMLError
from ruamel.yaml.events import (
    AliasEvent,
    DocumentStartEvent,
    MappingEndEvent,
    ScalarEvent,
    SequenceEndEvent,
    SequenceStartEvent,
)

from freebody.errors import ModelError, Problem
from freebody.language.document.scalars import resolved
from freebody.language.document.syntax_errors import key_problem, squeezed_colon, syntax_problem
from freebody.language.document.tree import (
    MAX_BYTES,
    MAX_DEPTH,
    MAX_LINE,
    MAX_VALUES,
    DocumentNode,
    DocumentStep,
    Key,
    Place,
    Scalar,
    kind_of,
)
from freebody.messages import Message

_SHORT = 20_000  # characters of a text whose tree is kept
_BEGINNING = Message("a model begins with a section such as 'bodies:'")


def compose(text: str, file: str | None) -> DocumentNode:
    """The tree of a text. Raises ModelError with all its problems. Trees of short texts are kept: a model that is being
    worked on is read again and again."""
    return _kept(text, file) if len(text) <= _SHORT else _Composer(text, file).compose()


@lru_cache(maxsize=128)
def _kept(text: str, file: str | None) -> DocumentNode:
    return _Composer(text, file).compose()


class _RestUnread(Exception):
    """The rest of the text is not worth reading."""


@dataclass
class _Composer:
    """Builds the tree of one text, or raises all its problems."""

    text: str
    file: str | None
    problems: list[Problem] = field(default_factory=list["Problem"])
    n_values: int = 0
    _last: Any = None

    def compose(self) -> DocumentNode:
        root: DocumentNode | None = None
        try:
            self._check_lines()
            root = self._document()
        except _RestUnread:
            pass
        except YAMLError as error:
            found = syntax_problem(error, self.text, self._last)
            if all(told.message != found.message for told in self.problems):  # what a key tells already
                self.problems.append(found)
        except (ValueError, OverflowError):
            # ruamel.yaml lets chr() and int() fail on an escape such as "\UFFFFFFFF".
            self._note((), self._last, Message("an escape here stands for no character; write the character itself"))
        if root is None or self.problems:
            self.problems.sort(key=lambda p: (p.line or 0, p.column or 0))
            raise ModelError(self.problems, self.file)
        return root

    def _check_lines(self) -> None:
        """Refuses what YAML would read at length or with another meaning, before it is scanned."""
        if len(self.text) > MAX_BYTES:
            self._stop(
                Problem(
                    (),
                    Message("{n} characters; a model has at most {most}", n=len(self.text), most=MAX_BYTES),
                )
            )
        for number, line in enumerate(self.text.removeprefix("\ufeff").splitlines(), 1):
            if len(line) > MAX_LINE:
                message = Message(
                    "a line of {n} characters; write at most {most} in one line", n=len(line), most=MAX_LINE
                )
                self._stop(Problem((), message, number, 1))
            if line.startswith("%"):
                self._stop(
                    Problem(
                        (),
                        Message("a line must not begin with '{beginning}'", beginning=line.split()[0][:20]),
                        number,
                        1,
                    )
                )

    def _document(self) -> DocumentNode | None:
        parser: Any = YAML(typ="safe", pure=True)
        events = self._watched(parser.parse(self.text))
        next(events)
        if not _is(next(events), DocumentStartEvent):
            self._stop(Problem((), Message("the file is empty; {hint}", hint=_BEGINNING), 1, 1))
        root = self._node(next(events), events, (), 1)
        next(events)
        following = next(events)
        if _is(following, DocumentStartEvent):
            message = Message("a second document begins here; one file holds one model, so split it or delete '---'")
            self._note((), following, message)
        if not isinstance(root.content, dict) and not (root.content is None and self.problems):
            self._note((), root, _no_mapping(root, self.text))
        return root

    def _watched(self, events: Iterator[Any]) -> Iterator[Any]:
        for event in events:
            self._last = event
            yield event

    def _node(self, event: Any, events: Iterator[Any], path: Place, depth: int) -> DocumentNode:
        self.n_values += 1
        if self.n_values > MAX_VALUES:
            self._note(path, event, Message("more than {most} values; is this the right file?", most=MAX_VALUES))
            raise _RestUnread
        if _is(event, AliasEvent):
            self._note(
                path,
                event,
                Message("'*{anchor}' repeats another part of the file; write it out twice", anchor=event.anchor),
            )
            return self._made(None, event, event)
        self._check_marks(event, path)
        if _is(event, ScalarEvent):
            return self._made(self._scalar(event, path), event, event)
        if depth > MAX_DEPTH:
            self._note(
                (),
                event,
                Message("lists and mappings stand more than {most} deep in each other", most=MAX_DEPTH),
            )
            raise _RestUnread
        if _is(event, SequenceStartEvent):
            return self._sequence(event, events, path, depth)
        return self._mapping(event, events, path, depth)

    def _check_marks(self, event: Any, path: Place) -> None:
        if event.anchor is not None:
            message = Message(
                "'&{anchor}' marks a part to be repeated; delete the mark and write it out twice", anchor=event.anchor
            )
            self._note(path, event, message)
        if event.tag is not None:
            tag = str(event.tag).replace("tag:yaml.org,2002:", "!!")
            self._note(
                path, event, Message("the tag '{tag}' is not allowed; delete it and write the plain value", tag=tag)
            )

    def _sequence(self, event: Any, events: Iterator[Any], path: Place, depth: int) -> DocumentNode:
        items: list[DocumentNode] = []
        for inner in events:
            if _is(inner, SequenceEndEvent):
                return self._made(items, event, inner, items[-1] if items else None)
            items.append(self._node(inner, events, (*path, len(items)), depth + 1))
        raise _RestUnread

    def _mapping(self, event: Any, events: Iterator[Any], path: Place, depth: int) -> DocumentNode:
        entries: dict[str, DocumentStep] = {}
        last: DocumentNode | None = None
        for inner in events:
            if _is(inner, MappingEndEvent):
                return self._made(entries, event, inner, last)
            name = self._key(inner, events, path, depth)
            at = path if name is None else (*path, name)
            last = self._node(next(events), events, at, depth + 1)
            if name is None:
                continue
            key = Key(inner.start_mark.line + 1, inner.start_mark.column + 1, inner.end_mark.index)
            if told := None if inner.style else key_problem(name, last.is_empty, self._line_of(inner)):
                self._note(at, inner, told)
            if last.is_empty:
                last = self._empty(key)
            step = entries.setdefault(name, DocumentStep(key, last))
            if (first := step.key) is not None and first is not key:
                message = Message(
                    "the key {name} stands in line {line} already; keep one of the two, or give one of them another "
                    "name",
                    name=name,
                    line=first.line,
                )
                if step.node.is_empty and first.line == key.line - 1:
                    message = Message(
                        "{name} in line {line} is empty, and what belongs to it stands beside it: begin this line with "
                        "two more spaces",
                        name=name,
                        line=first.line,
                    )
                self._note(at, inner, message)
        raise _RestUnread

    def _key(self, event: Any, events: Iterator[Any], path: Place, depth: int) -> str | None:
        """A key's text as written, so that `on`, `1` and `null` name themselves; None where it is no text."""
        node = self._node(event, events, path, depth + 1) if not _is(event, ScalarEvent) else None
        if _is(event, AliasEvent):
            return None
        if node is None and (event.value or event.style):
            self._check_marks(event, path)
            self._check_text(event, path)
            return str(event.value)
        found = Message("empty") if node is None else kind_of(node.plain())
        self._note(path, event, Message("this key is {found}; a key must be plain text", found=found))
        return None

    def _empty(self, key: Key) -> DocumentNode:
        """An empty value, right after its colon, or its key in `{only a key}`; YAML marks it further on."""
        colon = re.compile(r"\s*:").match(self.text, key.end)
        at = key.end if colon is None else colon.end()
        return DocumentNode(None, key.line, key.column, at, at)

    def _scalar(self, event: Any, path: Place) -> Scalar:
        self._check_text(event, path)
        value = event.value if event.style else resolved(event.value)
        if isinstance(value, float) and not math.isfinite(value):
            shown = event.value if len(event.value) <= 20 else event.value[:20] + "..."
            self._note(path, event, Message("{value} is not a finite number", value=shown))
        return value

    def _check_text(self, event: Any, path: Place) -> None:
        if re.search("[\ud800-\udfff]", event.value):
            self._note(path, event, Message("half a character (a surrogate escape); write the character itself"))

    def _made(self, content: Any, first: Any, last: Any, inner: DocumentNode | None = None) -> DocumentNode:
        """A block collection ends with its last value; its own end mark lies after the comments below."""
        mark = first.start_mark
        is_block = getattr(first, "flow_style", None) is False
        end = inner.end if is_block and inner is not None else last.end_mark.index
        span = self.text[mark.index : end]
        return DocumentNode(
            content,
            mark.line + 1,
            mark.column + 1,
            mark.index,
            mark.index + len(span.rstrip(" \t\r\n")),
            is_block,
        )

    def _note(self, path: Place, at: Any, message: Message) -> None:
        if isinstance(at, DocumentNode):
            line, column = at.line, at.column
        else:
            line, column = at.start_mark.line + 1, at.start_mark.column + 1
        self.problems.append(Problem(path, message, line, column))

    def _line_of(self, event: Any) -> str:
        """The text from an event to the end of its line."""
        return self.text[event.start_mark.index :].split("\n", 1)[0]

    def _stop(self, problem: Problem) -> NoReturn:
        self.problems.append(problem)
        raise _RestUnread


def _is(event: Any, kind: type[Any]) -> bool:
    return isinstance(event, kind)


def _no_mapping(root: DocumentNode, text: str) -> Message:
    if root.content is None:
        return Message("the file is empty; {hint}", hint=_BEGINNING)
    squeezed = squeezed_colon(text[root.start : root.end])
    if squeezed:
        return Message("a space is missing after the colon in '{squeezed}'", squeezed=squeezed)
    return Message("the file is {found}; {hint}", found=kind_of(root.plain()), hint=_BEGINNING)
