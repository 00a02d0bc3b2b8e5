"""Helical gears: wheels on parallel axes whose teeth wind round them with the helix angle beta.

On a wheel with the axis a, at the pitch point with n away from its axis and t = a x n, a right-handed tooth runs along
cos(beta) a + sin(beta) t. Its flank presses along t - tan(beta) a in the plane that touches both pitch cylinders, and
with the pressure angle alpha of the normal section

    F_t tangential,    F_a = F_t tan(beta) axial,    F_r = F_t tan(alpha)/cos(beta) parts the gears.

The thrust on a right-handed driver points as its turn, right-handed about the axis; on the other wheel it is opposite.
Source: Shigley, Mechanical Engineering Design, sec. 13-16; Niemann & Winter, Maschinenelemente II.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import TYPE_CHECKING

from freebody.connections.pitch_point import BornWheel, between, born_wheel, combined, meshing, shared
from freebody.connections.shared_by_copies import SharedByCopies
from freebody.connections.standing import is_near, number_of
from freebody.connections.teeth import read_pressure_angle, read_teeth
from freebody.language.expression import ONE, ZERO, Call, Expr, divide, negate, number
from freebody.language.sentences import Message
from freebody.language.units import LENGTH
from freebody.measures.combination import Combination
from freebody.measures.geometry import GROUND, Components
from freebody.model import glyphs
from freebody.model.elements import ConstraintRow
from freebody.model.glyphs import Glyph
from freebody.model.pressed_side import flank_of
from freebody.model.rotations import dot, vector_product
from freebody.model.spec import Formula
from freebody.tolerances import ROUNDED

if TYPE_CHECKING:
    from freebody.model.names import Names


class HelicalGears(SharedByCopies, kind="helical_gears"):
    """`helical_gears: {first: pinion, second: wheel, teeth: [z1, z2], radius: r, helix_angle: beta}`: two wheels in
    revolute joints with parallel axes on a common carrier (`on`, default the ground), which mesh from outside. `radius`
    is the pitch radius of the first, whose teeth are right-handed (`left_handed: true`); they act in the middle of its
    face. The tooth force is positive when it resists a turn of the first that is right-handed about its axis; with a
    `pressure_angle`, that of the normal section, it is positive, or negative with `other_flank: true` (1 row)."""

    space_only = True
    in_plane_take = "gear_mesh"

    first: str
    second: str
    teeth: list[Formula]
    radius: Formula
    helix_angle: Formula
    on: str = GROUND
    pressure_angle: Formula | None = None
    other_flank: bool = False
    left_handed: bool = False

    has_contact_point = True
    example = """
space: true
ground: {points: {A: [0, 0, 0], B: [0, 0.3 m, 0]}}
bodies:
  a: {disk: {mass: 1 kg, radius: 0.1 m, axis: x}}
  b: {disk: {mass: 1 kg, radius: 0.2 m, axis: x}}
connections:
  p: {revolute: {first: ground.A, second: a, about: x}}
  q: {revolute: {first: ground.B, second: b, about: x}}
  it: {helical_gears: {first: a, second: b, teeth: [20, 40], radius: 0.1 m, helix_angle: 15 deg}}
"""

    def rows(self, names: Names) -> list[ConstraintRow]:
        if not self._is_sound(names):
            return []
        pairs = [self._wheels(names, *pair) for pair in self.pairs_of_gears(names)]
        found = [pair for pair in pairs if pair is not None]
        if len(found) < len(pairs):
            return []
        self._look_at_distance(names, found[0], names.above_zero(self, "radius", LENGTH))
        flank = 0 if read_pressure_angle(names, self) is None else -1 if self.other_flank else 1
        measure, other = (shared([self._mesh(names, pair, side) for pair in found]) for side in (flank, -flank))
        turns = {wheel.held.body: wheel.turn() for pair in found for wheel in pair}
        teeth = ConstraintRow("teeth", "tooth force", measure, sign=-1, pressed=flank_of(flank, other))
        return [teeth, *self.alike(names, turns)]

    def _mesh(self, names: Names, wheels: tuple[BornWheel, BornWheel], flank: int) -> Combination:
        """The way by which the flanks of two wheels would pass into each other."""
        axis, outwards = wheels[0].axis.components, self._outwards(names, wheels)
        alpha, beta = read_pressure_angle(names, self), self._helix(names)
        radius = names.above_zero(self, "radius", LENGTH)
        hand = number(-1 if self.left_handed else 1)
        along = combined((ONE, vector_product(axis, outwards)), (negate(hand * Call("tan", beta)), axis))
        if alpha is not None:
            along = combined((ONE, along), (number(flank) * divide(Call("tan", alpha), Call("cos", beta)), outwards))
        place = combined((ONE, self._middle(names, wheels[0])), (radius, outwards))
        return meshing(wheels, place, along)

    def _is_sound(self, names: Names) -> bool:
        bodies = (names.body(getattr(self, field), field).name for field in ("first", "second", "on"))
        if len({*bodies}) < 3:
            names.problem(Message("a gear pair needs two wheels and another body that carries their bearings"))
            return False
        return True

    def _wheels(self, names: Names, one: str, other: str) -> tuple[BornWheel, BornWheel] | None:
        """Both in their bearings, with axes that point the same way."""
        first, second = (
            born_wheel(names, wheel, self.on, field) for wheel, field in ((one, "first"), (other, "second"))
        )
        if first is None or second is None:
            return None
        a1, a2 = first.axis.components, second.axis.components
        turned = number_of(names, dot(a1, a2))
        if abs(abs(turned) - 1.0) > ROUNDED:
            names.problem(Message("the axes of helical gears are parallel; take bevel_gears, worm_gear or gear_pair"))
            return None
        return first, second.outwards(reverse=turned < 0)

    def _middle(self, names: Names, wheel: BornWheel) -> Components:
        """The point of the axis in the middle of the face: beside the centre of the wheel."""
        body = names.known(wheel.held.body)
        aside = dot(between(body.center.offset, wheel.held.offset), wheel.own_axis.components)
        return combined((ONE, wheel.at), (aside, wheel.axis.components))

    def _outwards(self, names: Names, wheels: tuple[BornWheel, BornWheel]) -> Components:
        """From the axis of the first to that of the second, of length 1."""
        one, two = wheels
        gap, axis = between(two.at, one.at), one.axis.components
        aside = combined((ONE, gap), (negate(dot(gap, axis)), axis))
        if sum(c != ZERO for c in aside) == 1:
            return tuple(ZERO if c == ZERO else number(math.copysign(1, number_of(names, c))) for c in aside)
        return combined((divide(ONE, Call("sqrt", dot(aside, aside))), aside))

    def _look_at_distance(self, names: Names, wheels: tuple[BornWheel, BornWheel], radius: Expr) -> None:
        apart = names.numeric(dot(between(wheels[1].at, wheels[0].at), self._outwards(names, wheels)))
        z1, z2 = self._numbers_of_teeth(names)
        needed = names.numeric(radius * (ONE + divide(z2, z1)))
        if apart is None or needed is None or is_near(apart, needed):
            return
        told = Message(
            "the axes of {first} and {second} are {apart:.4g} m apart, and the teeth need {needed:.4g} m",
            first=self.first,
            second=self.second,
            apart=apart,
            needed=needed,
        )
        names.problem(told, "radius")

    def _numbers_of_teeth(self, names: Names) -> tuple[Expr, Expr]:
        return read_teeth(names, self.teeth)

    def _helix(self, names: Names) -> Expr:
        return names.angle(self.helix_angle, "helix_angle")

    def parts(self, names: Names) -> dict[str, Expr]:
        alpha, beta = read_pressure_angle(names, self), self._helix(names)
        thrust = Call("tan", beta)
        if alpha is None:
            return {"tangential": ONE, "axial": thrust}
        cosine = Call("cos", beta)
        return {
            "tangential": ONE,
            "radial": divide(Call("tan", alpha), cosine),
            "axial": thrust,
            "normal": divide(ONE, Call("cos", alpha) * cosine),
        }

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        for first, second in self.pairs_of_gears(names):
            yield glyphs.Toothed((names.body(first).center, names.body(second).center))
