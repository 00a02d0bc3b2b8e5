"""Belt drive between two pulleys, open or crossed, without slip."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, ClassVar

from freebody.connections.base import Connection
from freebody.connections.circles import own_radius, touching
from freebody.language.sentences import Message
from freebody.model import glyphs
from freebody.model.elements import ConstraintRow
from freebody.model.glyphs import Glyph
from freebody.model.spec import Formula

if TYPE_CHECKING:
    from freebody.model.names import Names


class Belt(Connection, kind="belt"):
    """`belt: [motor, drum]`, `belt: {first: motor, second: drum, crossed: true}`. An open belt turns both pulleys
    the same way, a crossed one opposite ways; bearings or a carrier keep the centres apart. The belt force is the
    difference of the tensions of its two runs (their sum is the pretension, which the motion does not fix),
    positive when it resists a counter-clockwise turn of the first pulley (1 row)."""

    called: ClassVar[tuple[str, ...]] = ("band",)

    first: str
    second: str
    crossed: bool = False
    first_radius: Formula | None = None
    second_radius: Formula | None = None

    in_plane = True
    example = """
bodies: {a: {disk: {mass: 1 kg, radius: 1 m}}, b: {disk: {mass: 1 kg, radius: 2 m}, at: [5 m, 0]}}
ground: {points: {A: [0, 0], B: [5 m, 0]}}
connections: {p: {pin: [ground.A, a]}, q: {pin: [ground.B, b]}, it: {belt: [a, b]}}
"""

    def rows(self, names: Names) -> list[ConstraintRow]:
        first, second = names.body(self.first, "first"), names.body(self.second, "second")
        if first.name == second.name:
            names.problem(Message("a belt needs two pulleys, not {first} twice", first=first.name))
            return []
        # on a carrier of constant length an open belt couples angles as an internal mesh does
        _distance, _total, rolled = touching(
            first.center,
            own_radius(names, self, "first"),
            second.center,
            own_radius(names, self, "second"),
            internal=not self.crossed,
        )
        return [ConstraintRow("belt", "belt force", rolled, sign=-1)]

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        centers = names.body(self.first).center, names.body(self.second).center
        radii = own_radius(names, self, "first"), own_radius(names, self, "second")
        yield glyphs.Belt(*centers, radii, is_crossed=self.crossed)
