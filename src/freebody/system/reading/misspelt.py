"""Misspelt words of a file: one mistake is told once, by the word that is meant.

    memebrs: {AB: [A, B]}        there is no section memebrs. Did you mean members?

What a wrong word leads to shows in many places: a truss without its members has no loads, and nothing that is asked of
them. So a file that cannot be read is read once more with the known word that is nearest to one that nobody knows. The
word is what was meant if fewer mistakes are left, and then only these are told beside it. A name that somebody gives is
not looked at where it can be told from a word.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any, cast

from freebody.budgets import allowed
from freebody.errors import FreebodyError, ModelError, Problem
from freebody.language.document import Document
from freebody.language.document.tree import Place
from freebody.language.folded import folded
from freebody.language.sentences import Message
from freebody.system.reading.sections import MEANT_SECTIONS, OF_GROUND
from freebody.system.reading.vocabulary import FEWEST, nearest, slips, words_inside, words_of_sections
from freebody.system.reading.written.form import JOINED

_READINGS, _KEYS_READ = 40, 20_000  # of one file; keys of all of them together
_NAMED = ("bodies", *JOINED, "parameters", "measures", "start", "states", "options", *OF_GROUND)  # what holds names


@dataclass(frozen=True)
class _Word:
    """A word that nobody knows, where it stands, and one that may be meant."""

    place: Place
    written: str
    meant: str

    def told(self) -> Problem:
        hint = Message(" Did you mean {x}?", x=self.meant)
        path = (*self.place, self.written)
        if not self.place:
            return Problem(path, Message("there is no section {key}.{hint}", key=self.written, hint=hint))
        if len(self.place) == len(("section", "name")) and self.place[0] in JOINED:
            kind = Message("connection") if self.place[0] == "connections" else Message("load")
            told = Message("{kind} is no kind of {what}.{hint}", kind=self.written, what=kind, hint=hint)
            return Problem(path, told)
        what = next((str(step) for step in reversed(self.place) if isinstance(step, str)), "")
        return Problem(path, Message("{what} has no {key}.{hint}", what=what, key=self.written, hint=hint))


def told_by_what_is_meant(document: Document, error: ModelError, read: Callable[[Document], Any]) -> ModelError:
    """The mistakes of a document, those that follow from a misspelt word by the word alone."""
    left = [*error.problems]
    corrected: list[Problem] = []
    trials = min(allowed(_READINGS), allowed(_KEYS_READ) // (1 + sum(1 for _ in _keys(document.data, ()))))
    now, again = document, True
    while left and again:
        again = False
        for words in _unknown(now.data):
            trials -= len(words)
            if trials < 0:
                break
            best = _best(now, words, read)
            if best is not None and (_is_better(best[0], left, best[2]) or _hides(best[0], left, best[2])):
                word, now, found = best
                corrected.append(_already_told(word, left) or document.locate(word.told()))
                left, again = found, True
                break
    if not corrected:
        return error
    problems = sorted([*corrected, *left], key=lambda p: (p.line or 0, p.column or 0))
    return ModelError(problems, error.file)


def _best(
    document: Document, words: list[_Word], read: Callable[[Document], Any]
) -> tuple[_Word, Document, list[Problem]] | None:
    """Of words one of which may be meant, the one that leaves the fewest mistakes, with the document that has it."""
    tried: list[tuple[_Word, Document, list[Problem]]] = []
    for word in words:
        meant = _with(document, word)
        if (found := _problems(meant, read)) is not None:
            tried.append((word, meant, found))
    return min(tried, key=lambda each: len(each[2]), default=None)


def _is_better(word: _Word, before: list[Problem], after: list[Problem]) -> bool:
    """Whether a word explains mistakes: more than one, or one that does not name it, and brings no other ones."""
    if any(problem.path[: len(word.place) + 1] == (*word.place, word.meant) for problem in after):
        return len(after) + 1 < len(before)
    is_less = {problem.message for problem in after} < {problem.message for problem in before}
    return len(after) + 1 < len(before) or (
        len(after) + 1 == len(before) and is_less and _already_told(word, before) is None
    )


def _hides(word: _Word, before: list[Problem], after: list[Problem]) -> bool:
    """Whether a word with one slip, of which is told what is meant, hides mistakes inside of what it stands for, and
    with the right one nothing else is wrong that was not."""
    if slips(folded(word.written), folded(word.meant)) != 1 or (told := _already_told(word, before)) is None:
        return False
    kept = {problem.message for problem in before if problem is not told}
    new = [problem for problem in after if problem.message not in kept]
    inside = (*word.place, word.meant)
    return bool(new) and all(problem.path[: len(inside)] == inside for problem in new)


def _already_told(word: _Word, problems: list[Problem]) -> Problem | None:
    """The mistake as it is told where it stands, if that names the word that is meant."""
    at = [p for p in problems if p.path[-1:] == (word.written,) and f" {word.meant}" in str(p.message)]
    return at[0] if at else None


def _problems(document: Document, read: Callable[[Document], Any]) -> list[Problem] | None:
    """What is wrong with a document; None where it cannot be told."""
    try:
        read(document)
    except ModelError as error:
        return [*error.problems]
    except FreebodyError:
        return None
    return []


def _with(document: Document, word: _Word) -> Document:
    """The document with the word that is meant."""
    data = document.data
    entry: Any = data
    for step in word.place:
        entry = entry[step]
    renamed = {word.meant if key == word.written else key: value for key, value in entry.items()}
    entry.clear()
    entry.update(renamed)
    return document.rewritten(data, {(*word.place, word.meant): (*word.place, word.written)})


def _unknown(data: Mapping[str, Any]) -> Iterator[list[_Word]]:
    """The words that nobody knows, those of sections first, each with the nearest ones that are known."""
    named = (data[section] for section in ("bodies", "parameters", "measures") if isinstance(data.get(section), dict))
    given = {str(name) for section in named for name in section}
    for place, entry in sorted(_keys(data, ()), key=lambda each: len(each[0])):
        known = words_inside() if place else words_of_sections()
        if place == ("ground",):  # beside these it has names
            known = {word: word for word in OF_GROUND}
        for key in entry:
            form = folded(key)
            if len(form) >= FEWEST and form not in known and not _is_name(place) and key not in given:
                yield [_Word(place, key, meant) for meant in nearest(key, known) if meant not in entry]


def _is_name(place: Place) -> bool:
    """Whether what stands at a place has names that somebody gives."""
    return bool(place) and (place[-1] in _NAMED or (len(place) == 1 and MEANT_SECTIONS.get(str(place[0])) in _NAMED))


def _keys(value: Any, place: Place) -> Iterator[tuple[Place, dict[str, Any]]]:
    """The mappings of a document, each with its place."""
    if isinstance(value, dict):
        entry = cast("dict[str, Any]", value)
        yield place, entry
        for key, each in entry.items():
            yield from _keys(each, (*place, key))
    elif isinstance(value, list):
        for k, each in enumerate(cast("list[Any]", value)):
            yield from _keys(each, (*place, k))
