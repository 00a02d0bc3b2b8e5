"""Keys as people spell them: `Disk`, `koerper`, `hinge-joint`, where the words are `disk`, `Körper`, `hinge`.

Only keys that stand for sections, kinds, options and fields are looked at; names that somebody gives stay as they are.
One letter is a name: `m` and `M` are not the same.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cache
from typing import Any, cast

from freebody.language.document.tree import Place
from freebody.language.folded import folded
from freebody.model.friction import AT_REST, IN_MOTION
from freebody.model.spec import MEANT
from freebody.system.reading.sections import CLOSES, MEANT_SECTIONS, OF_GROUND, SAYS_KIND, SECTIONS
from freebody.system.reading.written.form import JOINED, Entry, Written, keys_beside, kinds_of, shape_of

_NAMED_INSIDE = ("points", "lines", "planes", "at", "near", "measures")  # what holds names
_FEWEST = 3  # letters of a word
_OTHER_WORDS = {"typ": "type", "art": "type", "auf": "on", "bei": "at", "ueber": "over", "unter": "under"}
_OF_SECTION = {"bodies": {"koerper": "body"}}  # which is a field elsewhere
_JOINT = "_joint"
_WORLD = "world"
_FACE, _SLOPES = "face", ("slope", "incline", "hypotenuse", "inclined_face")


def spell_sections(w: Written) -> None:
    """The keys beside the sections and of them."""
    known = _by_folded((*SECTIONS, *OF_GROUND, *MEANT_SECTIONS, *_words("connections"), *_words("loads")))
    w.data = _spelt(w, (), w.data, known)


def spell_entry(w: Written, section: str, place: Place, entry: Any) -> Any:
    """One entry of bodies, connections or loads: its keys, and the keys of the mappings in it."""
    if not isinstance(entry, dict) or section not in ("bodies", *JOINED):
        return entry
    known = _vocabulary(section, space=w.space)
    read = _spelt(w, place, cast("Entry", entry), known)
    for key, value in read.items():
        if isinstance(value, dict) and key not in _NAMED_INSIDE:
            read[key] = _spelt(w, (*place, key), cast("Entry", value), known)
        elif key in SAYS_KIND and isinstance(value, str):
            read[key] = _word(value, known)
    return read


def ground_for_world(w: Written) -> None:
    """`pin: [world, arm.start]`: who does not call a body so means the ground."""
    bodies = w.data.get("bodies")
    if isinstance(bodies, dict | list) and _WORLD not in str(bodies):
        for section in JOINED:
            if section in w.data:
                w.data[section] = _with_ground(w.data[section])


def sides_as_called(w: Written) -> None:
    """`on: wedge.slope`: the slope of a wedge is its face, where the file names none so."""
    bodies = w.data.get("bodies")
    wedges = [
        name
        for name, entry in (cast("Entry", bodies).items() if isinstance(bodies, dict) else ())
        if (shape := shape_of(entry)) is not None
        and _FACE in getattr(shape, "open_lengths", {}).get("length", ())
        and not any(word in str(entry.get(key)) for word in _SLOPES for key in ("points", "lines"))
    ]
    called = {f"{name}.{word}": f"{name}.{_FACE}" for name in wedges for word in _SLOPES}
    for section in ("bodies", *JOINED) if called else ():
        if section in w.data:
            w.data[section] = _called(w.data[section], called)
    for section in ("measures", "questions") if called else ():
        if section in w.data:
            w.data[section] = _said_with(w.data[section], called)


def _said_with(value: Any, names: dict[str, str]) -> Any:
    """Sentences with the names in them."""
    if isinstance(value, dict):
        return {key: _said_with(each, names) for key, each in cast("Entry", value).items()}
    if isinstance(value, list):
        return [_said_with(each, names) for each in cast("list[Any]", value)]
    for name, meant in names.items() if isinstance(value, str) else ():
        value = re.sub(rf"(?<![\w.]){re.escape(name)}\b", meant, value)
    return value


def _called(value: Any, names: dict[str, str]) -> Any:
    if isinstance(value, dict):
        return {key: _called(each, names) for key, each in cast("Entry", value).items()}
    if isinstance(value, list):
        return [_called(each, names) for each in cast("list[Any]", value)]
    return names.get(value, value) if isinstance(value, str) else value


def _with_ground(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _with_ground(each) for key, each in cast("Entry", value).items()}
    if isinstance(value, list):
        return [_with_ground(each) for each in cast("list[Any]", value)]
    return "ground" if value == _WORLD else value


def _spelt(w: Written, place: Place, entry: Entry, known: dict[str, str]) -> Entry:
    read: Entry = {}
    for key, value in entry.items():
        word = _word(key, known)
        word = key if word in entry or word in read else word
        read[word] = value
        if word != key:
            w.moved[*place, word] = (*w.stood(place), key)
    return read


def _word(key: Any, known: dict[str, str]) -> Any:
    """The word that is meant by a key, the key itself where it is none."""
    if not isinstance(key, str) or len(key) < _FEWEST or key in known.values():
        return key
    form = folded(key)
    joint = known.get(form.removesuffix(_JOINT), key) if form.endswith(_JOINT) else key
    return known.get(form, joint)


@cache
def _vocabulary(section: str, *, space: bool) -> dict[str, str]:
    """What the keys of an entry of a section may be."""
    at = JOINED if section in JOINED else (section,)
    fields = (
        word
        for each in at
        for kind in kinds_of(each).values()
        for word in (*(f.alias or name for name, f in kind.model_fields.items()), *kind.more_words, *kind.elsewhere)
    )
    beside = keys_beside(section, space=space)
    words = [word for each in at for word in _words(each)]
    known = _by_folded((*words, *fields, *MEANT, *AT_REST, *IN_MOTION, *beside, *SAYS_KIND, CLOSES))
    return known | _OTHER_WORDS | _OF_SECTION.get(section, {})


def _words(section: str) -> list[str]:
    return [word for name, kind in kinds_of(section).items() for word in (name, *kind.also)]


def _by_folded(words: Iterable[str]) -> dict[str, str]:
    """By their common form: the words, of several of one form the one in small letters."""
    found: dict[str, str] = {}
    for word in words:
        form = folded(word)
        if len(word) >= _FEWEST and (form not in found or word == form):
            found[form] = word
    return found
