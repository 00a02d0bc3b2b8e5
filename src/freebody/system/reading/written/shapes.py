"""Bodies that say their fields and no shape: where only one shape can be meant it is that.

load: {mass: m, at: [0, h]}                load: {particle: {mass: m}, at: [0, h]}
bar: {mass: m, length: L}                  bar: {rod: {mass: m, length: L}}
crate: {type: block, mass: m, on: slope}   crate: {block: {mass: m}, on: slope}

A mass alone is a particle where nothing in the file names a point of the body, or says how it turns; that is told.
"""

from __future__ import annotations

import re
from difflib import get_close_matches
from typing import Any, cast

from freebody.language.folded import folded
from freebody.language.sentences import Message
from freebody.model.shapes.base import Shape
from freebody.model.spec import SAME, Spec
from freebody.model.written_kinds import takes, written_kind
from freebody.system.reading.sections import SAYS_KIND
from freebody.system.reading.written.form import JOINED, Entry, Written, as_option, keys_beside, takes_as
from freebody.system.reading.written.vectors import SPEEDS

_TURNS = ("angular_velocity", "angle", "turned", "points", "lines", "outline")
_ALIKE = 0.7  # of a word to that of a field: a slip of the pen
_DISK, _ROD = "disk", "rod"
_ENDS = (("from", "to"), ("start", "end"), ("von", "nach"))
_ANGLE, _NEAR = "angle", "near"
_WAYS = {
    **dict.fromkeys(("right", "rechts", "horizontal", "level", "waagerecht"), 0),
    **dict.fromkeys(("up", "upward", "upwards", "oben"), "90 deg"),
    **dict.fromkeys(("left", "links"), "180 deg"),
    **dict.fromkeys(("down", "downward", "downwards", "unten"), "-90 deg"),
}
_LENGTH = "length"  # what says that alone is a rod
_FEWEST = 2  # fields by which one shape is known; a mass alone is one of all of them


def with_shape(w: Written, name: str, entry: Entry) -> Entry:
    """The entry of a body with its shape, where it has none and can have one only, and beside it what no shape has."""
    beside = keys_beside("bodies", space=w.space)
    entry = entry if w.space else _of_known_inertia(turned_in_words(w, entry))
    entry = _between_ends(w, name, entry)
    fields = {key: value for key, value in entry.items() if not as_option(key, beside)}
    said = next((key for key in SAYS_KIND if isinstance(fields.get(key), str)), None)
    if said is not None and fields[said] in fields:  # `type: mass, mass: m`
        entry = {key: value for key, value in entry.items() if key != said}
        fields = {key: value for key, value in fields.items() if key != said}
    elif said is not None:
        return _of_type(w, name, entry, fields, said)
    word = name.rstrip("_0123456789") or name
    if not fields or any(written_kind(key, value, Shape.kinds, space=w.space) for key, value in fields.items()):
        return entry
    if takes_as(word, fields, Shape.kinds, space=w.space):
        return entry
    kinds = [kind for kind in Shape.kinds.values() if w.space or not kind.space_only]
    own = {key: value for key, value in fields.items() if any(_knows(kind, key) for kind in kinds)}
    if own.keys() < fields.keys() and takes_as(word, own, Shape.kinds, space=w.space):
        return _with(
            w, name, entry, word, own
        )  # what it is called says its shape, and what no shape has stays beside it
    taking = [kind for kind in kinds if own and _takes_exactly(kind, own)]
    able = [kind for kind in taking if kind.also] or taking
    if len(able) > 1 and "radius" in own and ("mass" not in own or "inertia" in own):
        able = [
            kind for kind in able if kind.kind == _DISK
        ]  # what is round and light, or of a known inertia, moves alike
    whole = [kind for kind in able if len(kind.model_fields) == len(own)]
    if len(own) < _FEWEST and [kind.kind for kind in able] != [_DISK]:
        is_long = _LENGTH in {_LENGTH if _LENGTH in kind.meant(key) else key for kind in able for key in own}
        plainest = sorted(able, key=lambda kind: len(kind.model_fields))[:1] if is_long else []
        able = plainest or [kind for kind in whole if not _is_more_than_a_point(w, name, entry)]
    if len(able) != 1 or _is_called_otherwise(w, name, able[0]):
        return entry
    shape = able[0].kind
    w.assumed.append(
        Message("{name} says {fields} and no shape: it is a {kind}", name=name, fields=", ".join(own), kind=shape)
    )
    return _with(w, name, entry, shape, own)


def _of_known_inertia(entry: Entry) -> Entry:
    """`wheel: {mass: m, radius: R, inertia: J}`: a disk and a hoop of the same inertia move alike."""
    disk = Shape.kinds[_DISK]
    for word, value in entry.items():
        is_open = word in disk.called and written_kind(word, value, Shape.kinds, space=False) is None
        if is_open and takes(disk, value) and "inertia" in disk.from_plain(value):
            return {_DISK if key == word else key: each for key, each in entry.items()}
    return entry


def turned_in_words(w: Written, entry: Entry) -> Entry:
    """`angle: down` of a body of the plane: the way of its x axis, as a direction says it."""
    given = w.data.get("parameters")
    known = cast("Entry", given) if isinstance(given, dict) else {}
    angle = entry.get(_ANGLE)
    if isinstance(angle, str) and angle not in known and (turned := _WAYS.get(folded(angle))) is not None:
        entry = {**entry, _ANGLE: turned}
    near = entry.get(_NEAR)
    if isinstance(near, dict) and (turned := turned_in_words(w, cast("Entry", near))) is not near:
        entry = {**entry, _NEAR: turned}
    return entry


def _between_ends(w: Written, name: str, entry: Entry) -> Entry:
    """`{from: A, to: B, mass: m}`: what is put by its two ends is a rod, where it says no other shape."""
    pair = next((pair for pair in _ENDS if {*pair} <= entry.keys()), None)
    if pair is None or "at" in entry:
        return entry
    rest = {key: value for key, value in entry.items() if key not in pair}
    at = {end: entry[key] for end, key in zip(("start", "end"), pair, strict=True)}
    w.moved["bodies", name, "at"] = (*w.stood(("bodies", name)), pair[0])
    if any(key in SAYS_KIND or written_kind(key, rest[key], Shape.kinds, space=w.space) for key in rest):
        return {**rest, "at": at}
    own = {key: value for key, value in rest.items() if _knows(Shape.kinds[_ROD], key)}
    told = Message("{name} says {fields} and no shape: it is a {kind}", name=name, fields=", ".join(pair), kind=_ROD)
    w.assumed.append(told)
    return {_ROD: own or None, **{key: value for key, value in rest.items() if key not in own}, "at": at}


def _of_type(w: Written, name: str, entry: Entry, fields: Entry, said: str) -> Entry:
    """`{type: block, mass: m, on: slope}`: what no shape has stays beside it; a field that is misspelt is one of it."""
    word = fields[said]
    called = [kind for kind_name, kind in Shape.kinds.items() if word == kind_name or word in kind.also]
    own = {key: value for key, value in fields.items() if key != said and any(_knows(kind, key) for kind in called)}
    left = [key for key in fields if key != said and key not in own]
    known = [field for kind in called for field in kind.model_fields]
    is_misspelt = any(get_close_matches(key, known, n=1, cutoff=_ALIKE) for key in left)
    if not left or is_misspelt or written_kind(word, own or None, Shape.kinds, space=w.space) is None:
        return entry
    return _with(w, name, {key: value for key, value in entry.items() if key != said}, word, own)


def _with(w: Written, name: str, entry: Entry, word: str, own: Entry) -> Entry:
    w.moved["bodies", name, word] = w.stood(("bodies", name))
    return {word: own or None, **{key: value for key, value in entry.items() if key not in own}}


def _knows(kind: type[Spec], key: str) -> bool:
    return key in kind.model_fields or bool(kind.meant(key)) or key in kind.elsewhere


def _takes_exactly(kind: type[Spec], fields: Entry) -> bool:
    known = {info.alias or key: info for key, info in kind.model_fields.items()}
    meant = {key if key in known else kind.meant(key)[0] if key in SAME and kind.meant(key) else "" for key in fields}
    needed = {key for key, info in known.items() if info.is_required()}
    return "" not in meant and len(meant) == len(fields) and needed <= meant


def _is_more_than_a_point(w: Written, name: str, entry: Entry) -> bool:
    """Whether the file says how it turns, or names one of its points."""
    texts: Any = [w.data.get(section) for section in (*JOINED, "measures", "questions", "start")]
    named = re.search(rf"\b{re.escape(name)}\.(?!mass_center|center)\w", str(texts))
    turns = [key for key in _TURNS if key in entry]
    is_thrown = turns == ["angle"] and any(key in entry for key in SPEEDS)  # the angle of its velocity
    return (bool(turns) and not is_thrown) or named is not None


def _is_called_otherwise(w: Written, name: str, shape: type[Spec]) -> bool:
    """Whether its name is a word for another shape."""
    called = folded(name).strip("_0123456789")
    kinds = [kind for kind in Shape.kinds.values() if kind is not shape and (w.space or not kind.space_only)]
    others = (word for kind in kinds for word in (kind.kind, *kind.also, *kind.called))
    return called not in map(folded, (*shape.also, *shape.called)) and called in map(folded, others)
