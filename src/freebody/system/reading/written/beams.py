"""A beam as it is written in books: its length, supports and loads by their distances from its left end.

    beam: {length: 6 m}
    supports: [{type: pin, at: 0}, {type: roller, at: 5 m}]          also {A: {pin: 0 m}, B: {roller: 5 m}}
    loads: [{type: distributed, from: 0, to: 3 m, value: q}, {type: point, at: 6 m, value: F}, {type: moment, ...}]
                                                                     also {P: F, x: 6 m}, {w: q, from: 0, to: 3 m},
                                                                     {F: 5 kN at 6 m}, {q: 2 kN/m from 0 to 3 m}

    supports: {A: 0, B: 6 m}                                         the first one a pin, the others rollers
    beam: {length: 8 m, hinges: [5 m]}                               rods beam_1, beam_2 that are hinged (beam_parts.py)

The beam lies level and begins at the origin; supports without names are A, B ... Loads act downwards and couples turn
counter-clockwise where they say no direction, which is told. Supports and loads by names of points, `beam.end`, are
those of every model, and are left alone.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from string import ascii_uppercase
from typing import Any, cast

from freebody.language.document.tree import Place
from freebody.language.expression import name_problem
from freebody.language.folded import folded
from freebody.language.sentences import Message, in_turn
from freebody.language.units import FORCE, LENGTH, TORQUE
from freebody.measures.geometry import GROUND
from freebody.system.reading.sections import SAYS_KIND
from freebody.system.reading.written.beam_parts import HINGES, Parts
from freebody.system.reading.written.dimensions import dimension_said, value_said
from freebody.system.reading.written.form import SAYS_NAME, Entry, Vocabulary, Written
from freebody.system.reading.written.numbers_given import weigh, wrong_unit
from freebody.tolerances import ROUNDED

_BEAMS = ("beam", "balken", "traeger", "girder")
_SUPPORTS = ("supports", "lager", "auflager")
_LOADS = ("loads", "lasten", "belastung", "forces", "kraefte")
_ENGLISH = {
    **{"typ": "type", "art": "type", "laenge": "length", "masse": "mass", "wert": "value", "groesse": "value"},
    **{"von": "from", "bis": "to", "nach": "to", "bei": "at", "ort": "at", "richtung": "direction"},
}
_PINNED = ("pin", "pinned", "hinge", "hinged", "fixed_hinge", "festlager")
_ROLLERS = ("roller", "rolling", "loslager")
_CLAMPS = ("fixed", "clamp", "clamped", "fixed_end", "einspannung", "weld")
_POINTS = ("point", "force", "point_load", "point_force", "concentrated", "kraft", "einzelkraft", "load")
_SPREAD = ("distributed", "distributed_load", "uniform", "udl", "uniform_load", "line_load", "streckenlast")
_COUPLES = ("moment", "couple", "torque", "drehmoment")
_SUPPORTED = re.compile(r"(?P<type>[\w ]+?) (?:at|bei) (?P<at>.+)")
_SAID = re.compile(
    r"(?P<value>\S.*?)(?: (?P<direction>up|down|upwards|downwards))?"
    r"(?: (?:at|bei) (?:x ?= ?)?(?P<at>\S.*)| (?:from|von) (?P<from>\S.*?) (?:to|bis) (?P<to>\S.*))"
)
_AT = ("at", "x", "position", "distance", "pos", "location", "a")
_SIZES = ("value", "magnitude", "force", "moment", "load", "intensity", "q", "w", "F", "M", "P", "size")

_FROM = {"from": ("from", "start", "x1"), "to": ("to", "end", "x2")}
_WAY, _LENGTH, _MASS = ("direction", "along"), ("length", "L", "l"), ("mass", "m")
VOCABULARY = Vocabulary(
    (*_BEAMS, *_SUPPORTS, *_LOADS),
    (
        *(*_ENGLISH, *_PINNED, *_ROLLERS, *_CLAMPS, *_POINTS, *_SPREAD, *_COUPLES, *_AT, *_SIZES, *_WAY, *_LENGTH),
        *(*_MASS, *HINGES, *SAYS_KIND, *SAYS_NAME, *_FROM["from"], *_FROM["to"]),
    ),
)


def with_beam(w: Written) -> None:
    """Puts a beam that is a section of its own, with its supports and loads, among the bodies and connections."""
    beams = [key for key in w.data if folded(key) in _BEAMS and not w.data.get("bodies")]
    if w.space or len(beams) != 1 or w.data.get("connections") or w.data.get("ground"):
        return
    given = w.data[beams[0]]
    if isinstance(given, dict) and not _lift(w, beams[0], cast("Entry", given)):
        return
    at, on = (next((key for key in w.data if folded(key) in words), "") for words in (_SUPPORTS, _LOADS))
    given = w.data[beams[0]]
    fields = _in_english(cast("Entry", given)) if isinstance(given, dict) else {"length": given}
    word, length = next(((key, fields[key]) for key in _LENGTH if key in fields), ("", None))
    hinge = next((key for key in fields if folded(key) in HINGES), "")
    beam = _Beam(beams[0], str(length), w)
    able = length is not None and fields.keys() <= {*_LENGTH, *_MASS, hinge}
    if at and length is not None and (why := wrong_unit(w, word, length, LENGTH)) is not None:
        w.refuse(why, beam.name, *([word] if isinstance(given, dict) else []))
    if at and not able and not beam.is_of_points(w.data.get(at)):
        strange = [key for key in fields if key not in (*_LENGTH, *_MASS, hinge)]
        w.refuse(_no_word(Message("a beam"), strange, ("length", "mass", "hinges", "supports", "loads")), beam.name)
    if able and at and not beam.is_of_points(w.data.get(at)):
        beam.parts = Parts(w, beam.name, str(length), fields.get(hinge), hinge)
    if not (able and beam.supports(w.data.get(at), at) and beam.loads(w.data.get(on), on)):
        return
    masses = [fields[key] for key in _MASS if key in fields and value_said(w, fields[key]) != 0]
    beam.connections |= beam.parts.joints()
    bodies = beam.parts.bodies(masses[0] if masses else None)
    rest = {key: value for key, value in w.data.items() if key not in (beam.name, at, on)}
    ground = {"ground": {"points": beam.ground}} if beam.ground else {}
    w.data = {**rest, **ground, "bodies": bodies, "connections": beam.connections}
    w.data |= {"loads": beam.pushed} if beam.pushed else {}
    if masses:
        weigh(w)
    w.moved |= {**{("bodies", name): (beam.name,) for name in bodies}, **beam.moved}
    w.moved |= {("connections", name): (beam.name, hinge) for name in beam.parts.hinges}
    w.assumed.append(
        Message(
            "the {beam} lies level from the origin to the right; loads without a direction act downwards, couples "
            "turn counter-clockwise",
            beam=beam.name,
        )
    )
    if beam.parts.hinges:
        told = Message("{beam} is {parts}, joined by hinges", beam=beam.name, parts=in_turn(list(bodies)))
        w.assumed.append(told)


def _lift(w: Written, name: str, given: Entry) -> bool:
    """Puts supports and loads that stand inside the beam beside it; whether they stand in one place only."""
    inside = [key for key in given if folded(key) in (*_SUPPORTS, *_LOADS)]
    if any(folded(key) in map(folded, w.data) for key in inside):
        return False
    w.data = {**w.data, name: {key: value for key, value in given.items() if key not in inside}}
    w.data |= {key: given[key] for key in inside}
    w.moved |= {(key,): (name, key) for key in inside}
    return True


class _Beam:
    """What a beam comes to while its supports and loads are read."""

    def __init__(self, name: str, length: str, w: Written) -> None:
        self.name, self.length, self.w = name, length, w
        self.parts = Parts(w, name, length, None, "")
        self.ground: Entry = {}
        self.connections: Entry = {}
        self.pushed: Entry = {}
        self.moved: dict[Place, Place] = {}

    def is_of_points(self, given: Any) -> bool:
        """Whether supports or loads name points, as in every model."""
        return given is None or re.search(rf"\b({re.escape(GROUND)}|{re.escape(self.name)})\.", str(given)) is not None

    def supports(self, given: Any, section: str) -> bool:
        """Whether there are supports by their distances. Raises ModelError where one cannot be read."""
        items = [*_items(given, plain="at")]
        free = (letter for letter in ascii_uppercase if all(letter != name for _step, name, _fields in items))
        if self.is_of_points(given):
            return False
        by_place = [_one(fields, _AT) for _step, _name, fields in items if _kind(fields) is None]
        for step, said, fields in items:
            word, at = _kind(fields), _one(fields, _AT)
            name = said or next(free)
            if strange := [key for key in fields if key not in (*SAYS_KIND, *_AT)]:
                self.w.refuse(_no_word(Message("a support of a beam"), strange, ("type", "at")), section, step)
            if word is None and at is not None and len(by_place) == len(items):
                word = _PINNED[0] if step == items[0][0] else _ROLLERS[0]
            if word is None or at is None or name_problem(name) is not None:
                told = Message(
                    "say how it holds and where: {name}: {{pin: 0 m}}, or roller, or fixed", name=said or "A"
                )
                self.w.refuse(told, section, step)
            self._check_place(at, name, section, step)
            point, there = self.parts.point(name, at), f"ground.{name}"
            self.ground[name] = [at, 0]
            if word in _ROLLERS:
                held: Entry = {"slot": {"pin": point, "through": there, "along": "right"}}
            elif word in (*_PINNED, *_CLAMPS):
                held = {"pin" if word in _PINNED else "weld": [there, point]}
            else:
                told = Message("a beam has no support {kind}: supports are pin, roller and fixed", kind=word)
                self.w.refuse(told, section, step)
            self.connections[name] = held
            self.moved["connections", name] = (*self.w.stood((section,)), step)
        if by_place:
            told = Message("the supports say where they are: the first one is a pin, the others are rollers")
            self.w.assumed.append(told)
        return bool(items)

    def loads(self, given: Any, section: str) -> bool:
        """Whether all loads could be read. Raises ModelError where one says what no load of a beam does."""
        for k, (step, said, fields) in enumerate(_items(given), 1):
            fields = self._in_words(given[step]) or fields
            size = _one(fields, _SIZES) or _varying(fields)
            word = _kind(fields) or self._by_unit(size)
            name = said or (f"{word}_{k}" if word else f"load_{k}")
            if word in (*_POINTS, *_SPREAD, *_COUPLES) and not self.is_of_points(given[step]):
                for words in (_AT, *_FROM.values()):
                    self._check_place(_one(fields, words), name, section, step)
            known = (*SAYS_KIND, *_SIZES, *_AT, *_WAY, *_FROM["from"], *_FROM["to"])
            strange = [key for key in fields if key not in known and not isinstance(fields[key], dict)]
            if strange and word in (*_POINTS, *_SPREAD, *_COUPLES) and not self.is_of_points(given[step]):
                takes = ("type", "value", "at", "from", "to", "direction")
                self.w.refuse(_no_word(Message("a load of a beam"), strange, takes), section, step)
            if word is None and size is not None and not isinstance(size, list) and not self.is_of_points(given[step]):
                told = Message("{value} is no force (N), no load per length (N/m) and no couple (N m)", value=str(size))
                self.w.refuse(told, section, step)
            if name in self.pushed or name_problem(name) is not None:
                return False
            is_able = word is not None and size is not None
            read = self._load(name, word, size if isinstance(size, list) else str(size), fields) if is_able else {}
            self.pushed |= read or {name: given[step]}  # what cannot be read is told where it stands
            self.moved |= {("loads", each): (*self.w.stood((section,)), step) for each in read or (name,)}
        return True

    def _load(self, name: str, word: str, size: Any, fields: Entry) -> dict[str, Entry]:
        """By their names the loads that one is, more than one where it runs over a hinge; none that cannot be read."""
        way, at = fields.get("direction", fields.get("along")), _one(fields, _AT)
        if word in _SPREAD:
            start, end = (_one(fields, words) for words in _FROM.values())
            if start is None or end is None:
                start = end = None
            ends = value_said(self.w, start), value_said(self.w, end)
            if ends[0] is not None and ends[1] is not None and ends[0] > ends[1]:  # told from the right
                start, end, size = end, start, size[::-1] if isinstance(size, list) else size
            spread = {"along": way or "down", "intensity": size}
            pieces = self.parts.spread(name, start, end, size)
            return {each: {"distributed": {"between": points, **spread}} for each, points in pieces.items()}
        if at is None or isinstance(size, list):
            return {}
        if word in _POINTS:
            return {name: {"force": {"at": self.parts.point(name, at), "along": way or "down", "magnitude": size}}}
        if word in _COUPLES:
            turned = {} if way is None else {"direction": way}
            point = self.parts.point(name, at, of_couple=True)
            return {name: {"torque": {"on": point, "magnitude": size, **turned}}}
        return {}

    def _check_place(self, at: Any, name: str, *place: str | int) -> None:
        """Raises ModelError where a distance from the left end has no unit, or another one, or leads off the beam."""
        if at is None:
            return
        if str(at) != "0" and (why := wrong_unit(self.w, "at", at, LENGTH)) is not None:
            self.w.refuse(why, *place)
        there, whole = value_said(self.w, at), value_said(self.w, self.length)
        if there is None or whole is None or 0.0 <= there <= whole * (1.0 + ROUNDED):
            return
        told = Message(
            "{name} is at {at}, which is not on {beam}: places count from its left end, from 0 to {length}",
            name=name,
            at=str(at),
            beam=self.name,
            length=self.length,
        )
        self.w.refuse(told, *place)

    def _in_words(self, given: Any) -> Entry:
        """`5 kN at 6 m`, `2 kN/m from 0 to 3 m`; nothing where the unit says no load, or no place stands there."""
        found = _SAID.fullmatch(given.strip()) if isinstance(given, str) else None
        fields = {} if found is None else {key: each for key, each in found.groupdict().items() if each}
        return fields if fields and self._by_unit(fields["value"]) is not None else {}

    def _by_unit(self, size: Any) -> str | None:
        """`{P: 10 kN, x: 2 m}`, `{w: 2 kN/m, from: 3 m, to: 6 m}`: the unit says what a load is."""
        dimension = dimension_said(self.w, size[-1] if isinstance(size, list) and size else size)
        meant = {FORCE: _POINTS[0], FORCE / LENGTH: _SPREAD[0], TORQUE: _COUPLES[0]}
        return None if dimension is None else meant.get(dimension)


def _no_word(what: Message, strange: list[str], known: tuple[str, ...]) -> Message:
    return Message("{what} has no {key}; it has {known}", what=what, key=in_turn(strange), known=in_turn(list(known)))


def _items(given: Any, plain: str = "") -> Iterator[tuple[str | int, str, Entry]]:
    """Items of a list or a mapping: where each stands, its name and fields; `{pin: 0 m}` says kind and place. plain:
    what a value without fields says."""
    listed = cast("list[Any]", given if isinstance(given, list) else [])
    pairs = [*cast("Entry", given).items()] if isinstance(given, dict) else [*enumerate(listed)]
    for step, item in pairs:
        fields = _in_english(cast("Entry", item)) if isinstance(item, dict) else {}
        kinds = [key for key in fields if folded(key) in (*_POINTS, *_SPREAD, *_COUPLES)]
        if len(kinds) == 1 < len(fields) and not fields.keys() & {*SAYS_KIND}:
            fields = {"type": kinds[0], "value": fields.pop(kinds[0]), **fields}
        named = next((str(fields.pop(key)) for key in SAYS_NAME if key in fields), "")
        if isinstance(item, str) and (said := _SUPPORTED.fullmatch(item.strip())):
            fields = {"type": said["type"], "at": said["at"]}
        elif plain and isinstance(item, str | int | float):
            is_kind = folded(str(item)) in (*_PINNED, *_ROLLERS, *_CLAMPS)
            fields = {"type" if is_kind else plain: item}
            yield step, named or (step if isinstance(step, str) else ""), fields
            continue
        if len(fields) == 1 and not isinstance(next(iter(fields.values())), dict):
            ((word, at),) = fields.items()
            fields = {"type": word, "at": at}
        yield step, named or (step if isinstance(step, str) else ""), fields


def _in_english(fields: Entry) -> Entry:
    return {_ENGLISH.get(folded(key), key): value for key, value in fields.items()}


def _kind(fields: Entry) -> str | None:
    return next((folded(str(fields[key])) for key in SAYS_KIND if key in fields), None)


def _varying(fields: Entry) -> list[Any] | None:
    """`value: [0, q]` of a load that rises evenly."""
    found = [fields[word] for word in _SIZES if isinstance(fields.get(word), list)]
    return found[0] if len(found) == 1 else None


def _one(fields: Entry, words: tuple[str, ...]) -> Any:
    """The value under one of some words."""
    found = [fields[word] for word in words if word in fields]
    return found[0] if len(found) == 1 and not isinstance(found[0], dict | list) else None
