"""Another name for a part of a model, wherever its text has it; comments and order stay.

A name may also be a unit (m) or a word of the grammar (x of ball). What stands behind a number is its unit. Of all else
the reader is the judge: where a value cannot be read with the new name, that word was another one, and it stays; the
whole has to be a model that lacks no more than before. The new name is no word of the text and of no grammar, so it
cannot be taken for anything else.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any, cast

from freebody.errors import FreebodyError, InputError, ModelError
from freebody.language.document import Document, Place
from freebody.language.units import is_unit, parse_quantity
from freebody.measures.geometry import GROUND
from freebody.messages import Message
from freebody.questions.reserved import reserved_words
from freebody.studio.reading import checked_system, entries_of
from freebody.studio.wire.texts import RenameRequest, TextAnswer

_TOLD = ("title", "about", "source", "freebody")  # of a model, in its reader's words
_NOTES = ("id", "text")  # of a question, the same
_OWN = ("points", "lines", "planes")  # of a body: their names are their own, and stand behind its name
_UNITS_BEFORE = re.compile(r"\d\s*(?:[A-Za-zµμ°%]+(?:\^-?\d+)?[\s*/]+)*$")
Edit = tuple[int, int, str]


def rename(request: RenameRequest) -> TextAnswer:
    """Raises InputError where the name will not do, and ModelError where the text is no model."""
    system, text, path = checked_system(request.text), request.text, tuple(request.path)
    old, new = str(path[-1]), request.name.strip()
    if not new.isidentifier() or new == GROUND:
        raise InputError(Message("{name} is no name: letters, digits and _, a letter first", name=new))
    if re.search(rf"\b{new}\b", text) or new.lower() in reserved_words():
        raise InputError(Message("{name} is taken: it stands in the model, or is a word of its language", name=new))
    word = re.compile(rf"(?<![\w.]){GROUND}\.{old}\b" if path[:2] == (GROUND, "points") else rf"(?<![\w.]){old}\b")
    document = system.document
    key = document.key_span(path)
    if key is None:
        raise InputError(Message("{name} has no name of its own", name=old))
    found = {(each, is_key): edits for each, is_key, edits in _edits(document, text, word, (old, new)) if edits}
    left = set(system.unspecified)
    while True:
        changed = _spliced(text, [(*key, new), *(edit for edits in found.values() for edit in edits)])
        try:
            renamed = checked_system(changed)
        except ModelError as error:
            problems = [tuple(old if part == new else part for part in p.path) for p in error.problems]
            others = [at for at in found if any(_is_about(problem, at[0]) for problem in problems)]
            if not others:
                raise
            # a field of an element may have the name that its value is to lose: module: module
            for each in [at for at in others if at[1]] or others:
                del found[each]
            continue
        if {new if name == old else name for name in left} != set(renamed.unspecified):
            raise InputError(Message("{name} cannot be renamed: it is also a unit or a word in a formula", name=old))
        return TextAnswer(text=changed)


def _is_about(problem: Place, edited: Place) -> bool:
    """Whether a problem is about a value that was changed, its parts, or the element it is in."""
    n = min(len(problem), len(edited))
    return n > 1 and problem[:n] == edited[:n]


def _edits(
    document: Document, text: str, word: re.Pattern[str], names: tuple[str, str]
) -> Iterator[tuple[Place, bool, list[Edit]]]:
    """What the new name would change, by the path of the value it stands in, or of its key. word: what to look for,
    which ends with the old name; names: old, new"""
    old, new = names

    def within(start: int, end: int) -> list[Edit]:
        part = text[start:end]
        words = [found for found in word.finditer(part) if not _is_behind_number(part[: found.start()])]
        return [(start + found.end() - len(old), start + found.end(), new) for found in words]

    def walk(value: Any, path: Place) -> Iterator[tuple[Place, bool, list[Edit]]]:
        if (path and path[0] in _TOLD) or (len(path) > 2 and path[0] == "questions" and path[-1] in _NOTES):
            return
        if isinstance(value, dict | list):
            for name, each in entries_of(cast("Any", value)):
                key = document.key_span((*path, name))
                # keys are fields, kinds or new names, but in these sections, deep inside, and where one is a phrase
                is_deep = len(path) >= 3 and path[-1] not in _OWN
                is_named = path[:1] in (("start",), ("drawing",)) or is_deep or each is None
                if key is not None and is_named:
                    yield (*path, name), True, within(*key)
                yield from walk(each, (*path, name))
            return
        span = document.span(path)
        if span is not None and isinstance(value, str) and not _is_quantity(value):
            yield path, False, within(*span)

    yield from walk(document.data, ())


def _is_behind_number(before: str) -> bool:
    """Whether what follows goes on with the units of a number: 3 kg ..., not 0 when ...."""
    found = _UNITS_BEFORE.search(before)
    return found is not None and all(map(is_unit, re.findall(r"[A-Za-zµμ°%]+", found.group())))


def _is_quantity(text: str) -> bool:
    try:
        parse_quantity(text)
    except FreebodyError:
        return False
    return True


def _spliced(text: str, edits: list[Edit]) -> str:
    for start, end, new in sorted(edits, reverse=True):
        text = text[:start] + new + text[end:]
    return text
