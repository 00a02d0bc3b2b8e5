"""The rods that a beam in a few lines is: one, or several that hinges join (a Gerber beam).

    beam: {length: 8 m, hinges: [5 m]}          also hinge: 5 m, hinges: {G: 5 m}, hinges: [{at: 5 m, name: G}]
        bodies: {beam_1: {rod: {length: 5 m}, ...}, beam_2: {rod: {length: 8 m - (5 m)}, ...}}
        connections: {hinge: {pin: [beam_1.end, beam_2.start]}}

A place at a hinge belongs to the part on its left. A load that runs over a hinge is one load for each part. Which part
a place belongs to is told by the numbers of the file. Source: Gross, Hauger, Schroeder, Wall, Technische Mechanik 1,
ch. 5.3.
"""

from __future__ import annotations

from itertools import pairwise
from typing import Any, NamedTuple, cast

from freebody.language.sentences import Message
from freebody.language.units import LENGTH
from freebody.system.reading.written.dimensions import value_said
from freebody.system.reading.written.form import SAYS_NAME, Entry, Written
from freebody.system.reading.written.numbers_given import wrong_unit

HINGES = ("hinges", "hinge", "gerber_hinge", "gerber_hinges", "internal_hinge", "internal_hinges", "gelenke", "gelenk")
_AT = ("at", "x", "position")


class Part(NamedTuple):
    """A rod of a beam, from where to where it goes, and the points that it has."""

    name: str
    start: str
    end: str
    points: Entry

    @property
    def length(self) -> str:
        return self.end if self.start == "0" else f"({self.end}) - ({self.start})"

    def point(self, name: str, at: Any) -> str:
        own = f"({at})" if self.start == "0" else f"({at}) - ({self.start})"
        self.points[name] = [f"{own} - ({self.length})/2", 0]
        return f"{self.name}.{name}"


class Parts:
    """The parts of a beam from its left to its right end."""

    def __init__(self, w: Written, beam: str, length: str, hinges: Any, key: str) -> None:
        self.w, self.beam, self.key = w, beam, key
        self.hinges = dict(self._hinges(hinges))
        ends = ["0", *map(str, self.hinges.values()), length]
        self.values = [value_said(w, end) for end in ends]
        known = [value for value in self.values if value is not None]
        if self.hinges and (len(known) < len(ends) or any(a >= b for a, b in pairwise(known))):
            told = Message("hinges stand from left to right between the ends of {beam}, at known places", beam=beam)
            w.refuse(told, beam, key)
        names = [beam] if not self.hinges else [f"{beam}_{k}" for k in range(1, len(ends))]
        self.each = [Part(name, a, b, {}) for name, (a, b) in zip(names, pairwise(ends), strict=True)]

    def _hinges(self, given: Any) -> list[tuple[str, Any]]:
        items = [*cast("Entry", given).items()] if isinstance(given, dict) and not {*given} & {*_AT} else None
        listed = cast("list[Any]", given) if isinstance(given, list) else [] if given is None else [given]
        found: list[tuple[str, Any]] = []
        for k, (name, item) in enumerate(items or [("", each) for each in listed], 1):
            fields = cast("Entry", item) if isinstance(item, dict) else {"at": item}
            at = next((fields[word] for word in _AT if word in fields), None)
            said = next((str(fields[word]) for word in SAYS_NAME if word in fields), str(name))
            if at is None or fields.keys() - {*_AT, *SAYS_NAME}:
                self.w.refuse(Message("a hinge of a beam says where it is: hinges: {{G: 5 m}}"), self.beam, self.key)
            if (why := wrong_unit(self.w, "at", at, LENGTH)) is not None:
                self.w.refuse(why, self.beam, self.key)
            found.append((said or ("hinge" if len(items or listed) == 1 else f"hinge_{k}"), at))
        return found

    def point(self, name: str, at: Any, *, of_couple: bool = False) -> str:
        """A point at a distance from the left end of the beam."""
        place = value_said(self.w, at)
        if len(self.each) == 1:
            return self.each[0].point(name, at)
        if place is None or (of_couple and place in self.values[1:-1]):
            told = Message(
                "on which side of its hinges {name} acts on {beam} is open: say its place as a number, and that of a "
                "couple just beside the hinge",
                name=name,
                beam=self.beam,
            )
            self.w.refuse(told, self.beam, self.key)
        k = next((k for k, end in enumerate(self.values[1:]) if end is not None and place <= end), len(self.each) - 1)
        return self.each[k].point(name, at)

    def spread(self, name: str, start: Any, end: Any, size: Any) -> dict[str, list[str]]:
        """By the names of loads, one for each part that a load lies on, its ends."""
        if start is None and len(self.each) == 1:
            return {name: [f"{self.beam}.start", f"{self.beam}.end"]}
        start, end = "0" if start is None else start, self.each[-1].end if end is None else end
        sizes = [value_said(self.w, start), value_said(self.w, end)]
        if len(self.each) == 1 or None in sizes:
            part = self.each[0]
            return {name: [part.point(f"{name}_from", start), part.point(f"{name}_to", end)]}
        low, high = cast("list[float]", sizes)
        bounds = cast("list[float]", self.values)
        borne = [k for k in range(len(self.each)) if max(low, bounds[k]) < min(high, bounds[k + 1])]
        if len(borne) > 1 and isinstance(size, list):
            told = Message(
                "{name} varies and runs over a hinge of {beam}: write one load for each part", name=name, beam=self.beam
            )
            self.w.refuse(told, self.beam, self.key)
        found: dict[str, list[str]] = {}
        for k in borne:
            part = self.each[k]
            a = start if low > bounds[k] else part.start
            b = end if high < bounds[k + 1] else part.end
            called = name if len(borne) == 1 else f"{name}_on_{part.name}"
            found[called] = [part.point(f"{name}_from", a), part.point(f"{name}_to", b)]
        return found

    def bodies(self, mass: Any) -> Entry:
        """The rods; their masses are as their lengths."""
        whole = self.each[-1].end
        found: Entry = {}
        for part in self.each:
            own = mass if len(self.each) == 1 or mass is None else f"({mass})*({part.length})/({whole})"
            rod = {"length": part.length, **({} if own is None else {"mass": own})}
            place = [0 if part.start == "0" else part.start, 0]
            found[part.name] = {"rod": rod, "at": {"start": place}, "angle": 0, "points": part.points}
        return found

    def joints(self) -> Entry:
        """The hinges."""
        pairs = zip(self.hinges, pairwise(self.each), strict=False)
        return {name: {"pin": [f"{left.name}.end", f"{right.name}.start"]} for name, (left, right) in pairs}
