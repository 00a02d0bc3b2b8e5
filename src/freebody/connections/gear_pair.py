"""Gear pair between any two axes: bevel, worm, hypoid. Each wheel turns against its carrier; the ratio is theirs."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from freebody.connections.base import Connection
from freebody.connections.joints import own_direction
from freebody.language.expression import Expr, divide
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS
from freebody.measures.combination import Combination
from freebody.measures.geometry import GROUND, ONE, Direction
from freebody.measures.turn import Turn
from freebody.model import glyphs
from freebody.model.elements import ConstraintRow
from freebody.model.glyphs import Glyph
from freebody.model.rotations import perpendiculars
from freebody.model.spec import Formula, Heading

if TYPE_CHECKING:
    from freebody.model.names import Names


class GearPair(Connection, kind="gear_pair"):
    """`gear_pair: {first: pinion, second: crown, on: carrier, first_axis: x, second_axis: y, ratio: -1/3}`: the second
    wheel turns `ratio` times as fast as the first, both seen from the body that carries their bearings (`on`, default
    the ground), right-handed about their axes, given by components on that body. `teeth: [z1, z2]` for bevel gears
    whose axes point away from where they meet: ratio -z1/z2. The teeth react on the carrier too (1 row)."""

    space_only = True
    in_plane_take = "gear_mesh"

    first: str
    second: str
    first_axis: Heading
    second_axis: Heading
    on: str = GROUND
    ratio: Formula | None = None
    teeth: list[Formula] | None = None

    example = """
space: true
ground: {points: {A: [0, 0, 0]}}
bodies:
  a: {disk: {mass: 1 kg, radius: 0.2 m, axis: x}}
  b: {disk: {mass: 1 kg, radius: 0.2 m, axis: y}}
connections:
  p: {revolute: {first: ground.A, second: a, about: x}}
  q: {revolute: {first: ground.A, second: b, about: y}}
  it: {gear_pair: {first: a, second: b, first_axis: x, second_axis: y, ratio: 2}}
"""

    def rows(self, names: Names) -> list[ConstraintRow]:
        wheels = [names.body(self.first, "first"), names.body(self.second, "second")]
        carrier = names.body(self.on, "on").name
        ratio = self._ratio(names)
        if len({wheels[0].name, wheels[1].name, carrier}) < 3:
            names.problem(Message("a gear pair needs two wheels and another body that carries their bearings"))
            return []
        turns: list[Turn] = []
        for wheel, heading, key in zip(
            wheels, (self.first_axis, self.second_axis), ("first_axis", "second_axis"), strict=True
        ):
            axis = own_direction(names, heading, carrier, key)
            if axis.body == wheel.name:
                axis = Direction(carrier, axis.components, axis.name)
            b, c = (Direction(carrier, v) for v in perpendiculars(axis.components))
            across, _ = perpendiculars(wheel.axis or axis.components)
            turns.append(Turn(Direction(wheel.name, across), b, c))
        mesh = Combination(((ONE, turns[1]), (-ratio, turns[0])), DIMENSIONLESS)
        return [ConstraintRow("teeth", "tooth moment", mesh)]

    def _ratio(self, names: Names) -> Expr:
        if (self.ratio is None) == (self.teeth is None):
            names.problem(Message("give ratio, the turns of second for one of first, or teeth: [z1, z2]"))
            return ONE
        if self.teeth is None:
            return names.formula(self.ratio, DIMENSIONLESS, "ratio")
        if len(self.teeth) != 2:
            names.problem(Message("teeth are two numbers, [z1, z2]"), "teeth")
            return ONE
        first, second = (names.formula(z, DIMENSIONLESS, "teeth", k) for k, z in enumerate(self.teeth))
        return -divide(first, second)

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        yield glyphs.Toothed((names.body(self.first).center, names.body(self.second).center))
