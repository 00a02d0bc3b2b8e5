"""Link: a massless rod hinged at both ends keeps two points at a constant distance."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, ClassVar

from freebody.connections.base import Connection
from freebody.connections.standing import place_of
from freebody.language.sentences import Message
from freebody.language.units import LENGTH
from freebody.measures.combination import Combination
from freebody.measures.distance import Distance
from freebody.measures.geometry import ONE, Point
from freebody.model import glyphs
from freebody.model.elements import ConstraintRow
from freebody.model.glyphs import Glyph
from freebody.model.spec import Formula

if TYPE_CHECKING:
    from freebody.model.names import Names


class Link(Connection, kind="link"):
    """`link: [ground.A, bob, L]`; without a length, the distance at the start. The force in
    it is positive when it pulls (1 row)."""

    called: ClassVar[tuple[str, ...]] = ("rod", "bar", "strut")
    also: ClassVar[tuple[str, ...]] = ("bar", "strut", "rod")

    instead: ClassVar[Mapping[str, str]] = dict.fromkeys(
        ("bead", "bead_on", "bead_on_wire", "threaded", "threaded_on", "slides_on", "on_wire", "wire"),
        Message(
            "a bead on a ring keeps its distance from the middle: link: [ring, bead, R]; on a straight rod it is a "
            "slot: {{pin: bead, on: rod, along: rod}}, on a curve a curved_rail: {{body: bead, y: x^2/a}}"
        ),
    )

    first: str
    second: str
    length: Formula | None = None

    example = """
bodies: {bob: {particle: {mass: 1 kg}, at: [0, -1 m]}}
connections: {it: {link: [ground.A, bob]}}
"""

    def rows(self, names: Names) -> list[ConstraintRow]:
        first, second = names.point(self.first, "first"), names.point(self.second, "second")
        if first.body == second.body:
            names.problem(Message("links {body} to itself; name points of two bodies", body=first.body))
            return []
        places = [place_of(names, point) for point in (first, second)]
        if self.length is None and places[0] is not None and places[0] == places[1]:
            names.problem(
                Message(
                    "at the start {first} and {second} are in one place, where the link has no length and no "
                    "direction: give its length, or put them apart (at)",
                    first=first,
                    second=second,
                )
            )
            return []
        distance = Distance(first, second)
        length = names.length_or(self, "length")
        held = distance if length is not None else Combination(((ONE, distance),), LENGTH)
        return [ConstraintRow("length", "tension", held, length, sign=-1, ends=(first.body, second.body))]

    def straight_between(self, names: Names) -> tuple[Point, Point]:
        return names.point(self.first, "first"), names.point(self.second, "second")

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        length = names.length_or(self, "length")
        yield glyphs.Rod(names.point(self.first), names.point(self.second), length)
