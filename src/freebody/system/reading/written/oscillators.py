"""Masses on springs along one line, of which the file says no lengths and no places.

    mass: {mass: m}                           guide_of_mass: {slider: {body: mass, along: right}}
    spring: {between: [wall, mass], k: k}     ground: {points: {wall: [-l_spring, 0]}}, spring: {..., length: l_spring}
    start: {x: x0}                            measures: {x: x of mass}, start: {x: x0}

Where all springs are relaxed the masses stand one behind the other, so far apart as the springs are long: l_spring is a
parameter without a value, which drops out of what depends on displacements alone. The first mass is at the origin
there, so that its x is its displacement. What lies or rolls on a level line has its middle at its height above that,
and so have the springs, where it is the same for all masses. Sources: Thomson, Theory of Vibration, sec. 2.2;
Meirovitch, Fundamentals of Vibrations, ch. 5.
"""

from __future__ import annotations

import re
from typing import Any, cast

from freebody.language.folded import folded
from freebody.language.sentences import Message
from freebody.measures.geometry import GROUND
from freebody.model.names import is_of_surroundings
from freebody.model.spec import Spec
from freebody.model.written_kinds import written_kind
from freebody.system.reading.written.form import Entry, Written, are_mappings, kinds_of, shape_of
from freebody.system.reading.written.pulleys import is_named

_SPRING, _DAMPER, _GRAVITY = "spring", "damper", "gravity"
_SLIDER, _CONTACT, _ROLLING = "slider", "contact", "rolling"
_POINT, _BLOCK, _ROUND = "particle", "rectangle", "radius"  # two shapes, and the size of one that rolls
_LENGTHS = ("length", "preload", "only")
_PUT = ("at", "near", "angle", "fixed", "velocity", "points")
_SECTIONS = ("connections", "ground", "parameters", "measures", "start")
_LEVEL = ("right", "left", "horizontal", "floor", "table", "x")
_PLACES = ("x", "displacement", "position", "initial_displacement", "initial_position", "x0", "x_0", "auslenkung")
_SPEEDS = ("v", "velocity", "speed", "initial_velocity", "initial_speed", "v0", "v_0", "geschwindigkeit")
_OWN = ("initial_displacement", "displacement", "x0", "auslenkung")  # that a body says of itself


def stretch_springs(w: Written) -> None:
    """Puts masses on springs without lengths side by side, with the lengths of the springs left open."""
    bodies, loads = w.data.get("bodies"), w.data.get("loads")
    if w.space or not isinstance(bodies, dict) or not isinstance(loads, dict) or not are_mappings(w, *_SECTIONS):
        return
    springs = {name: ends for name, ends in _pairs(w, _SPRING) if ends}
    chain = _Chain(w, cast("Entry", bodies), springs)
    if springs and len(springs) == sum(1 for _ in _pairs(w, _SPRING)) and chain.is_told():
        chain.write()


def _pairs(w: Written, wanted: str) -> list[tuple[str, tuple[str, str] | None]]:
    """The loads of a kind between two things, with their ends; None where one says how long it is."""
    found: list[tuple[str, tuple[str, str] | None]] = []
    for name, entry in cast("Entry", w.data["loads"]).items():
        for word, value in cast("Entry", entry).items() if isinstance(entry, dict) and len(entry) == 1 else ():
            kind = written_kind(word, value, kinds_of("loads"), space=False)
            if kind == wanted:
                fields = kinds_of("loads")[kind].from_plain(value)
                ends = fields.get("first"), fields.get("second")
                is_plain = all(isinstance(end, str) for end in ends) and not fields.keys() & {*_LENGTHS}
                first, second = (str(end).removesuffix(".center") for end in ends)
                found.append((name, (first, second) if is_plain else None))
    return found


class _Chain:
    """Masses and springs, one behind the other."""

    def __init__(self, w: Written, bodies: Entry, springs: dict[str, tuple[str, str]]) -> None:
        self.w, self.bodies, self.springs = w, bodies, springs
        self.masses = [name for name in bodies if any(name in ends for ends in springs.values())]
        self.places: dict[str, list[str]] = {}  # the springs on the way from the first mass
        self.lengths: dict[str, str] = {}  # by the springs: the parameters
        self.height: str | int | None = 0  # of all the middles

    def is_told(self) -> bool:
        """Whether all of it can be read so."""
        w = self.w
        ends = {end for pair in self.springs.values() for end in pair} - {*self.masses}
        dampers = _pairs(w, _DAMPER)
        pairs = {frozenset(pair) for pair in self.springs.values()}
        if not self.masses or not ends or not all(_is_surroundings(w, end) for end in ends):
            return False
        if any(pair is None or frozenset(pair) not in pairs for _name, pair in dampers):
            return False
        guides = [self._is_guided(name) for name in self.masses]
        if None in guides or not all(_is_unplaced(self.bodies[name]) for name in self.masses):
            return False
        heights = {self._height(name) for name in self.masses}
        if None in heights or len(heights) > 1:
            return False
        self.height = heights.pop()
        is_pulled = any(self._kind(entry) == _GRAVITY for entry in cast("Entry", w.data["loads"]).values())
        if (is_pulled and not all(guides)) or self._measures_otherwise():
            return False
        return self._follow(ends)

    def _kind(self, entry: Any) -> str | None:
        words = [*cast("Entry", entry).items()] if isinstance(entry, dict) else []
        return written_kind(words[0][0], words[0][1], kinds_of("loads"), space=False) if len(words) == 1 else None

    def _held_by(self, name: str) -> list[Any]:
        """The connections that name a mass."""
        each = cast("Entry", self.w.data.get("connections") or {}).values()
        return [entry for entry in each if is_named(name, {"": entry})]

    def _kinds(self, holding: list[Any]) -> set[str | None]:
        words = {word for each in holding for word in (each if isinstance(each, dict) else ())}
        return {written_kind(word, None, kinds_of("connections"), space=False) for word in words}

    def _is_guided(self, name: str) -> bool | None:
        """Whether something guides a mass along a level line; None where it is held otherwise."""
        holding = self._held_by(name)
        if not holding:
            return False
        texts = [text for each in holding for text in re.findall(r"\w+", str(each))]
        is_level = len(holding) == 1 and bool({*_LEVEL} & {*texts})
        able = {_SLIDER, _CONTACT, _ROLLING}
        return True if is_level and self._kinds(holding) <= able and "through" not in texts else None

    def _height(self, name: str) -> str | int | None:
        """How high the middle of a mass is above what it lies on, the line through the origin; None where it is not
        told, or where it is round and nothing leads it."""
        entry = cast("Entry", self.bodies[name])
        shape = cast("type[Spec]", shape_of(entry))
        word = next(word for word in entry if written_kind(word, entry[word], kinds_of("bodies"), space=False))
        sizes = shape.from_plain(entry[word])
        kinds = self._kinds(self._held_by(name))
        if _ROUND in shape.model_fields:
            radius = sizes.get(_ROUND)
            if kinds == {_SLIDER}:
                return 0
            return None if not kinds or radius is None or self._has_lines() else str(radius)
        if shape.kind == _POINT or kinds <= {_SLIDER}:
            return 0
        height = sizes.get("height")
        return None if height is None or self._has_lines() else f"({height})/2"

    def _has_lines(self) -> bool:
        """Whether the file has lines of its own, which may go through other points than the origin."""
        ground = self.w.data.get("ground")
        return bool(cast("Entry", ground).get("lines")) if isinstance(ground, dict) else ground is not None

    def _measures_otherwise(self) -> bool:
        """Whether the file measures from elsewhere, as from the wall."""
        given = self.w.data.get("measures") or {}
        texts = [str(each) for each in cast("Entry", given).values()] if isinstance(given, dict) else [str(given)]
        return any(re.fullmatch(r"\{?'?(x|travel) of \w+.*", text) is None for text in texts)

    def _follow(self, ends: set[str]) -> bool:
        """Finds the way from mass to mass, and to what does not move."""
        first = next(
            (name for name in self.masses if any({name} | ends >= {*pair} for pair in self.springs.values())), ""
        )
        if not first:
            return False
        parallel: dict[frozenset[str], str] = {}
        for spring, pair in self.springs.items():
            self.lengths[spring] = parallel.setdefault(frozenset(pair), f"l_{spring}")
        self.places[first] = []
        wall = next(end for pair in self.springs.values() if first in pair for end in pair if end in ends)
        for spring, pair in self.springs.items():
            if {*pair} == {first, wall}:
                self.places.setdefault(wall, [f"-{self.lengths[spring]}"])
        grown = True
        while grown:
            grown = False
            for spring, (a, b) in self.springs.items():
                for known, other in ((a, b), (b, a)):
                    if known in self.places and known not in ends and other not in self.places:
                        self.places[other] = [*self.places[known], self.lengths[spring]]
                        grown = True
        is_line = all(
            self.places.get(a) is not None
            and self.places.get(b) is not None
            and (abs(len(self._steps(a)) - len(self._steps(b))) == 1)
            for a, b in self.springs.values()
        )
        return is_line and not {*self.lengths.values()} & {*cast("Entry", self.w.data.get("parameters") or {})}

    def _steps(self, name: str) -> list[str]:
        return self.places[name]

    def write(self) -> None:
        w = self.w
        for spring in self.springs:
            entry = cast("Entry", w.data["loads"][spring])
            ((word, value),) = entry.items()
            fields = kinds_of("loads")[_SPRING].from_plain(value)
            w.data["loads"] = {**w.data["loads"], spring: {word: {**fields, "length": self.lengths[spring]}}}
        parameters = cast("Entry", w.data.get("parameters") or {})
        w.data["parameters"] = {**parameters, **dict.fromkeys(self.lengths.values(), "m")}
        ground = cast("Entry", w.data.get("ground") or {})
        ends = {name.removeprefix(f"{GROUND}."): self._at(name) for name in self.places if name not in self.bodies}
        w.data["ground"] = {**ground, "points": {**cast("Entry", ground.get("points") or {}), **ends}}
        held = {}
        for name in self.masses:
            entry = cast("Entry", w.data["bodies"][name])
            if self.places[name]:
                entry = {**entry, "at": self._at(name)}
            elif self.height:  # where it is along the line the start may say
                entry = {**entry, "near": {"at": self._at(name)}}
            w.data["bodies"] = {**w.data["bodies"], name: entry}
            if not self._is_guided(name):
                held[f"guide_of_{name}"] = {_SLIDER: {"body": name, "along": "right"}}
        w.data["connections"] = {**cast("Entry", w.data.get("connections") or {}), **held}
        w.moved |= {("connections", guide): w.stood(("bodies", guide.removeprefix("guide_of_"))) for guide in held}
        told = Message(
            "{masses} move along one line, on which the springs are relaxed at the lengths {lengths}",
            masses=", ".join(self.masses),
            lengths=", ".join(dict.fromkeys(self.lengths.values())),
        )
        if len(self.masses) == 1:
            told = Message(
                "{mass} moves along one line, and its x counts from where the springs are relaxed ({lengths} long)",
                mass=self.masses[0],
                lengths=", ".join(dict.fromkeys(self.lengths.values())),
            )
            self._start(self.masses[0])
        w.assumed.append(told)

    def _at(self, name: str) -> list[Any]:
        return [" + ".join(self.places[name]) or 0, self.height]

    def _start(self, name: str) -> None:
        """Of a single mass: its displacement and its speed at the start, by the measure x."""
        w = self.w
        given = w.data.get("measures") or {}
        if (
            given
            or "x" in cast("Entry", w.data.get("parameters") or {})
            or not isinstance(w.data.get("start") or {}, dict)
        ):
            return
        w.data["measures"] = {"x": f"x of {name}"}
        start: Entry = {}
        for key, value in cast("Entry", w.data.get("start") or {}).items():
            said = folded(str(key))
            field = "x" if said in _PLACES else "rate(x)" if said in _SPEEDS else key
            start[field] = value
            w.moved["start", field] = w.stood(("start", key))
        body = cast("Entry", w.data["bodies"][name])
        for key in [key for key in body if folded(str(key)) in _OWN and "x" not in start]:
            start["x"] = body[key]
            w.moved["start", "x"] = w.stood(("bodies", name, key))
            w.data["bodies"] = {**w.data["bodies"], name: {k: each for k, each in body.items() if k != key}}
        if start:
            w.data["start"] = start


def _is_surroundings(w: Written, end: str) -> bool:
    """Whether an end of a spring is a point of the ground of which no place is told."""
    point = end.removeprefix(f"{GROUND}.")
    ground = w.data.get("ground")
    points = cast("Entry", ground).get("points") if isinstance(ground, dict) else None
    is_free = (not isinstance(points, dict) or point not in points) and point not in (ground or {})
    return is_free and (end.startswith(f"{GROUND}.") or is_of_surroundings(point))


def _is_unplaced(entry: Any) -> bool:
    shape = shape_of(entry)
    known = shape is not None and (shape.kind in (_POINT, _BLOCK) or _ROUND in shape.model_fields)
    return known and not {*_PUT} & {*cast("Entry", entry)}
