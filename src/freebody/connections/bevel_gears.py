"""Bevel gears: pitch cones roll on each other, whose axes meet in their common apex.

With the shaft angle Sigma between the axes, taken away from the apex, and z_1, z_2 teeth, the half angles of the cones
are tan(delta_1) = sin(Sigma)/(z_2/z_1 + cos(Sigma)) and delta_2 = Sigma - delta_1. At the mean radius r_1 of the first,
F_t = T_1/r_1 is tangential; the teeth part by F_t tan(alpha), of which the first feels cos(delta_1) towards its axis
and sin(delta_1) along it, away from the apex. Source: Shigley, Mechanical Engineering Design, sec. 13-15.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from freebody.connections.pitch_point import BornWheel, between, born_wheel, combined, meshing, shared
from freebody.connections.shared_by_copies import SharedByCopies
from freebody.connections.standing import number_of
from freebody.connections.teeth import parting_slope, read_pressure_angle, read_teeth
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


class BevelGears(SharedByCopies, kind="bevel_gears"):
    """`bevel_gears: {first: pinion, second: crown, teeth: [z1, z2], radius: r, pressure_angle: 20 deg}`: two wheels in
    revolute joints on a common carrier (`on`, default the ground), whose axes meet. `radius` is the mean pitch radius
    of the first. The tooth force acts where the pitch cones touch, at the mean radius, and is positive when it resists
    a turn of the first that is right-handed about its axis, seen from the apex outwards; with a `pressure_angle` it is
    positive, or negative with `other_flank: true`. Radial and axial part are those on the first (1 row)."""

    space_only = True
    in_plane_take = "gear_mesh"

    first: str
    second: str
    teeth: list[Formula]
    radius: Formula
    on: str = GROUND
    pressure_angle: Formula | None = None
    other_flank: bool = False

    has_contact_point = True
    example = """
space: true
ground: {points: {A: [0.3 m, 0, 0], B: [0, 0.2 m, 0]}}
bodies:
  a: {disk: {mass: 1 kg, radius: 0.2 m, axis: x}}
  b: {disk: {mass: 1 kg, radius: 0.3 m, axis: y}}
connections:
  p: {revolute: {first: ground.A, second: a, about: x}}
  q: {revolute: {first: ground.B, second: b, about: y}}
  it: {bevel_gears: {first: a, second: b, teeth: [20, 30], radius: 0.18 m}}
"""

    def rows(self, names: Names) -> list[ConstraintRow]:
        if not self._is_sound(names):
            return []
        pairs = [self._wheels(names, *pair) for pair in self.pairs_of_gears(names)]
        found = [pair for pair in pairs if pair is not None]
        if len(found) < len(pairs):
            return []
        flank = 0 if self._slope(names) == ZERO else -1 if self.other_flank else 1
        measure, other = (shared([self._mesh(names, pair, side) for pair in found]) for side in (flank, -flank))
        turns = {wheel.held.body: wheel.turn() for pair in found for wheel in pair}
        self._tell_sides(names, found[0])
        teeth = ConstraintRow("teeth", "tooth force", measure, sign=-1, pressed=flank_of(flank, other))
        return [teeth, *self.alike(names, turns)]

    def _mesh(self, names: Names, wheels: tuple[BornWheel, BornWheel], flank: int) -> Combination:
        """The way by which the flanks of two wheels would pass into each other."""
        apex, slope = self._apex(names, wheels), self._slope(names)
        one, two = (self._away(names, wheel, apex) for wheel in wheels)
        a1, a2 = one.axis.components, two.axis.components
        sine, cosine = self._half_angle(names, a1, a2)
        tangent = combined((divide(ONE, _size(vector_product(a1, a2))), vector_product(a1, a2)))
        across = vector_product(tangent, a1)  # from the first axis towards the second
        line = combined((cosine, a1), (sine, across))
        outwards = combined((negate(sine), a1), (cosine, across))  # from the first cone into the second
        radius = names.above_zero(self, "radius", LENGTH)
        place = combined((ONE, apex), (divide(radius, sine), line))
        return meshing((one, two), place, combined((ONE, tangent), (number(flank) * slope, outwards)))

    def _is_sound(self, names: Names) -> bool:
        bodies = (names.body(getattr(self, field), field).name for field in ("first", "second", "on"))
        if len({*bodies}) < 3:
            names.problem(Message("a gear pair needs two wheels and another body that carries their bearings"))
            return False
        return True

    def _wheels(self, names: Names, first: str, second: str) -> tuple[BornWheel, BornWheel] | None:
        one, two = (born_wheel(names, wheel, self.on, field) for wheel, field in ((first, "first"), (second, "second")))
        return None if one is None or two is None else (one, two)

    def _slope(self, names: Names) -> Expr:
        return parting_slope(read_pressure_angle(names, self))

    def _apex(self, names: Names, wheels: tuple[BornWheel, BornWheel]) -> Components:
        """Where the axes meet: at Q_1 + s a_1, s = ((Q_2 - Q_1) x a_2) . (a_1 x a_2)/|a_1 x a_2|^2."""
        one, two = wheels
        a1, a2, apart = one.axis.components, two.axis.components, between(two.at, one.at)
        normal = vector_product(a1, a2)
        size, miss = dot(normal, normal), number_of(names, dot(apart, normal))
        if abs(number_of(names, size)) < ROUNDED:
            names.problem(Message("the axes are parallel and meet nowhere; take gear_mesh for spur gears"))
            return one.at
        if abs(miss) > ROUNDED:
            told = Message(
                "the axes of bevel gears meet in one point; these miss each other by {miss:.4g} m. For crossed axes "
                "take worm_gear or gear_pair",
                miss=abs(miss) / number_of(names, size) ** 0.5,
            )
            names.problem(told)
        return combined((ONE, one.at), (divide(dot(vector_product(apart, a2), normal), size), a1))

    def _away(self, names: Names, wheel: BornWheel, apex: Components) -> BornWheel:
        """With its axis from the apex towards the wheel; as the joint has it where nothing tells the side."""
        return wheel.outwards(reverse=self._side(names, wheel, apex) < 0)

    def _side(self, names: Names, wheel: BornWheel, apex: Components) -> int:
        """On which side of the apex along the axis of its joint a wheel lies: by its bearing or, where that is in the
        apex, by its centre; 0 where both are there."""
        center = names.known(wheel.held.body).center.offset
        lies = (between(wheel.at, apex), wheel.axis), (between(center, wheel.held.offset), wheel.own_axis)
        along = (number_of(names, dot(apart, axis.components)) for apart, axis in lies)
        return next((1 if x > 0.0 else -1 for x in along if abs(x) > ROUNDED), 0)

    def _tell_sides(self, names: Names, wheels: tuple[BornWheel, BornWheel]) -> None:
        """Notes which side is assumed of a wheel whose side nothing tells."""
        apex = self._apex(names, wheels)
        for wheel, partner in (wheels, wheels[::-1]):
            if self._side(names, wheel, apex) or self._faces_another(names, wheel, partner):
                continue
            told = Message(
                "bevel gear {wheel}: its bearing lies in the apex of the pitch cones, and the wheel is taken to lie on "
                "the side to which the axis of its joint points. If it lies on the other side, reverse that axis "
                "(about: -x), or put the bearing where the wheel is",
                wheel=wheel.held.body,
            )
            if told not in names.assumptions:
                names.assumptions.append(told)

    def _faces_another(self, names: Names, wheel: BornWheel, partner: BornWheel) -> bool:
        """Whether the partner meshes with another wheel, whose axis is written the other way."""
        meshes = [mesh for mesh in names.connections.values() if isinstance(mesh, BevelGears) and mesh.on == self.on]
        pairs = [{names.known(mesh.first).name, names.known(mesh.second).name} for mesh in meshes]
        others = {name for pair in pairs if partner.held.body in pair for name in pair}
        for name in sorted(others - {partner.held.body, wheel.held.body}):
            with names.quietly():
                other = born_wheel(names, name, self.on, "first")
            if (
                other is not None
                and number_of(names, dot(other.axis.components, wheel.axis.components)) < ROUNDED - 1.0
            ):
                return True
        return False

    def _half_angle(self, names: Names, a1: Components, a2: Components) -> tuple[Expr, Expr]:
        """Sine and cosine of delta_1."""
        z1, z2 = read_teeth(names, self.teeth)
        # a right angle leaves sin = z_1/sqrt(z_1^2 + z_2^2)
        rise, run = z1 * _size(vector_product(a1, a2)), z2 + z1 * dot(a1, a2)
        slant = Call("sqrt", rise * rise + run * run)
        return divide(rise, slant), divide(run, slant)

    def parts(self, names: Names) -> dict[str, Expr]:
        alpha = read_pressure_angle(names, self)
        wheels = self._wheels(names, self.first, self.second)
        if alpha is None or wheels is None:
            return {"tangential": ONE}
        apex = self._apex(names, wheels)
        one, two = (self._away(names, wheel, apex) for wheel in wheels)
        sine, cosine = self._half_angle(names, one.axis.components, two.axis.components)
        slope = Call("tan", alpha)
        return {
            "tangential": ONE,
            "radial": slope * cosine,
            "axial": slope * sine,
            "normal": divide(ONE, Call("cos", alpha)),
        }

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        radius = names.above_zero(self, "radius", LENGTH)
        z1, z2 = read_teeth(names, self.teeth)
        radii = (radius, divide(radius * z2, z1))
        for first, second in self.pairs_of_gears(names):
            yield glyphs.Toothed((names.body(first).center, names.body(second).center), radii)


def _size(v: Components) -> Expr:
    """The length of a vector, which is 1 where numbers say so."""
    square = dot(v, v)
    return ONE if square == ONE else Call("sqrt", square)
