"""Gear pair between any two axes: bevel, worm, hypoid. Each wheel turns against its carrier; the ratio is theirs."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from freebody.connections.joints import own_direction
from freebody.connections.pitch_point import born_wheel
from freebody.connections.shared_by_copies import SharedByCopies, gathered
from freebody.connections.standing import number_of
from freebody.connections.teeth import read_teeth
from freebody.language.expression import Expr, divide
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS
from freebody.measures.combination import Combination
from freebody.measures.geometry import GROUND, ONE, Direction
from freebody.measures.turn import Turn
from freebody.model import glyphs
from freebody.model.elements import ConstraintRow
from freebody.model.glyphs import Glyph
from freebody.model.rotations import dot, perpendiculars
from freebody.model.spec import Formula, Heading

if TYPE_CHECKING:
    from freebody.model.names import Names


class GearPair(SharedByCopies, kind="gear_pair"):
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
        axes = {w.name: self._axis(names, w.name, carrier, k) for w, k in zip(wheels, ("first", "second"), strict=True)}
        turns = {name: self._turn(names, name, axis) for name, axis in axes.items()}
        for wheel in wheels:
            for copy in wheel.copies:
                turns |= self._turn_of_copy(names, copy, wheel.name, axes[wheel.name])
        if any(name not in turns for pair in self.pairs_of_gears(names) for name in pair):
            return []
        ways = [((ONE, turns[other]), (-ratio, turns[one])) for one, other in self.pairs_of_gears(names)]
        mesh = Combination(gathered(term for way in ways for term in way), DIMENSIONLESS)
        return [ConstraintRow("teeth", "tooth moment", mesh), *self.alike(names, turns)]

    def _axis(self, names: Names, wheel: str, carrier: str, field: str) -> Direction:
        """On the carrier."""
        axis = own_direction(names, getattr(self, f"{field}_axis"), carrier, f"{field}_axis")
        return Direction(carrier, axis.components, axis.name) if axis.body == wheel else axis

    def _turn(self, names: Names, wheel: str, axis: Direction) -> Turn:
        b, c = (Direction(axis.body, v) for v in perpendiculars(axis.components))
        across, _ = perpendiculars(names.known(wheel).axis or axis.components)
        return Turn(Direction(wheel, across), b, c)

    def _turn_of_copy(self, names: Names, copy: str, wheel: str, axis: Direction) -> dict[str, Turn]:
        """About its own bearing, in the sense in which the axis of the first is that of the first's bearing."""
        born, own = born_wheel(names, copy, axis.body, "second"), born_wheel(names, wheel, axis.body, "second")
        if born is None or own is None:
            return {}
        reverse = number_of(names, dot(axis.components, own.axis.components)) < 0
        return {copy: born.outwards(reverse=reverse).turn()}

    def _ratio(self, names: Names) -> Expr:
        if (self.ratio is None) == (self.teeth is None):
            names.problem(Message("give ratio, the turns of second for one of first, or teeth: [z1, z2]"))
            return ONE
        if self.teeth is None:
            return names.formula(self.ratio, DIMENSIONLESS, "ratio")
        first, second = read_teeth(names, self.teeth)
        return -divide(first, second)

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        for first, second in self.pairs_of_gears(names):
            yield glyphs.Toothed((names.body(first).center, names.body(second).center))
