"""Worm gear: the thread of a worm slides along the teeth of a wheel on a crossed axis, with or without friction.

With the lead angle lambda at the mean radius r_1 of the worm, z_1 threads and z_2 teeth, the wheel has the radius r_2 =
r_1 tan(lambda) z_2/z_1. Unrolled, the thread holds

    r_1 tan(lambda) theta_1 +- r_2 theta_2 = 0    by S along the axis of the worm, the tangential force of the wheel,
    r_1 theta_1 -+ tan(lambda) r_2 theta_2        is the slip along the thread over cos(lambda); its friction round the
                                                  axis of the worm is mu' S, mu' = mu/cos(alpha_n),

as in a screw (see `screw`). The flanks part the two by S tan(alpha_n)/cos(lambda). With tan(phi') = mu' the worm drives
with the efficiency tan(lambda)/tan(lambda + phi'), and locks itself where phi' >= lambda: then no moment of the wheel
turns it. Source: Shigley, Mechanical Engineering Design, sec. 13-11, 13-17; Niemann & Winter, Maschinenelemente III.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from freebody.connections.base import Connection
from freebody.connections.pitch_point import BornWheel, between, born_wheel, combined, meshing
from freebody.connections.standing import is_near, number_of
from freebody.connections.teeth import read_pressure_angle
from freebody.language.expression import ONE, ZERO, Call, Expr, divide, free_symbols, negate, number
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, LENGTH
from freebody.measures.combination import Combination
from freebody.measures.geometry import GROUND, Components
from freebody.model import glyphs
from freebody.model.elements import ConstraintRow, DryFriction, UnilateralConstraint
from freebody.model.friction import read_friction
from freebody.model.glyphs import Glyph
from freebody.model.pressed_side import flank_of
from freebody.model.rotations import dot, vector_product
from freebody.model.spec import Formula
from freebody.model.thread import Thread
from freebody.tolerances import ROUNDED

if TYPE_CHECKING:
    from freebody.model.names import Names


class WormGear(Connection, kind="worm_gear"):
    """`worm_gear: {worm: screw, wheel: wheel, starts: 2, teeth: 40, radius: r, lead_angle: lambda, friction: mu}`: a
    right-handed worm (`left_handed: true`) of the mean radius r, both in revolute joints on a common carrier (`on`,
    default the ground) whose axes cross at a right angle (1 row). The tooth force is the tangential one of the wheel,
    and is positive when it resists a right-handed turn of the worm about its axis. `pressure_angle` is that of the
    normal section; with it the tooth force is positive, or negative with `other_flank: true`. The worm locks itself
    where mu/cos(alpha) is at least tan(lambda); the friction force is its part round the axis of the worm."""

    space_only = True
    in_plane_take = "gear_mesh"

    worm: str
    wheel: str
    teeth: Formula
    radius: Formula
    lead_angle: Formula
    starts: Formula = 1
    on: str = GROUND
    friction: Formula | dict[str, Any] = 0
    pressure_angle: Formula | None = None
    other_flank: bool = False
    left_handed: bool = False

    has_contact_point = True
    example = """
space: true
ground: {points: {A: [0, 0, 0.1 m], B: [0, 0, -0.1 m]}}
bodies:
  worm: {cylinder: {mass: 1 kg, radius: 50 mm, length: 0.2 m, axis: x}}
  wheel: {disk: {mass: 1 kg, radius: 0.15 m, axis: y}}
connections:
  p: {revolute: {first: ground.A, second: worm, about: x}}
  q: {revolute: {first: ground.B, second: wheel, about: y}}
  it: {worm_gear: {worm: worm, wheel: wheel, starts: 1, teeth: 30, radius: 50 mm, lead_angle: atan(1/10)}}
"""

    def rows(self, names: Names) -> list[ConstraintRow]:
        wheels = self._wheels(names)
        if wheels is None:
            return []
        place, apart, e = self._pitch_point(names, wheels)
        alpha, along = read_pressure_angle(names, self), self._normal(names, wheels, e)
        flank = 0 if alpha is None else -1 if self.other_flank else 1
        radial = ZERO if alpha is None else divide(Call("tan", alpha), Call("cos", self._lead(names)))
        measure, other = (
            meshing(wheels, place, combined((ONE, along), (negate(number(side) * radial), apart)) if side else along)
            for side in (flank, -flank)
        )
        return [ConstraintRow("teeth", "tooth force", measure, sign=-1, pressed=flank_of(flank, other))]

    def _normal(self, names: Names, wheels: tuple[BornWheel, BornWheel], e: Components) -> Components:
        """Across the thread in the plane that touches both pitch surfaces, its part along the worm of length 1."""
        hand = number(-1 if self.left_handed else 1)
        return combined((negate(hand), wheels[0].axis.components), (negate(Call("tan", self._lead(names))), e))

    def bounds(self, names: Names, connection: str) -> tuple[list[UnilateralConstraint], list[DryFriction]]:
        friction = read_friction(names, self.friction, DIMENSIONLESS)
        with names.quietly():
            wheels = self._wheels(names)
        if friction.is_none or wheels is None:
            return [], []
        with names.quietly():
            place, _apart, e = self._pitch_point(names, wheels)
            hand, slope = number(-1 if self.left_handed else 1), Call("tan", self._lead(names))
            slip: Combination = meshing(
                wheels, place, combined((negate(ONE), e), (hand * slope, wheels[0].axis.components))
            )
        rough = self.thread(names)
        row = ConstraintRow("slip", "friction force", slip, connection=connection)
        return [], [DryFriction(row, rough.static, rough.kinetic, (f"{connection}.teeth",))]

    def thread(self, names: Names) -> Thread:
        with names.quietly():
            friction, alpha = read_friction(names, self.friction, DIMENSIONLESS), read_pressure_angle(names, self)
            wedged = ONE if alpha is None else divide(ONE, Call("cos", alpha))
            return Thread(Call("tan", self._lead(names)), friction.static * wedged, friction.kinetic * wedged)

    def _lead(self, names: Names) -> Expr:
        return names.angle(self.lead_angle, "lead_angle")

    def _wheels(self, names: Names) -> tuple[BornWheel, BornWheel] | None:
        carrier = names.body(self.on, "on").name
        if len({self.worm, self.wheel, carrier}) < 3:
            names.problem(Message("a gear pair needs two wheels and another body that carries their bearings"))
            return None
        bodies = {field: names.body(getattr(self, field), field).name for field in ("worm", "wheel")}
        worm, wheel = (born_wheel(names, body, carrier, field) for field, body in bodies.items())
        return None if worm is None or wheel is None else (worm, wheel)

    def _pitch_point(
        self, names: Names, wheels: tuple[BornWheel, BornWheel]
    ) -> tuple[Components, Components, Components]:
        """Where the two touch, p from the wheel to the worm, and a_1 x p."""
        worm, wheel = wheels
        a1, a2 = worm.axis.components, wheel.axis.components
        if abs(number_of(names, dot(a1, a2))) > ROUNDED:
            names.problem(Message("the axes of a worm gear cross at a right angle; take gear_pair for others"))
            return worm.at, a1, a2
        normal, gap = vector_product(a1, a2), between(worm.at, wheel.at)
        side = number(-1 if number_of(names, dot(gap, normal)) < 0 else 1)
        p = combined((side, normal))
        radius, starts = names.above_zero(self, "radius", LENGTH), names.above_zero(self, "starts", DIMENSIONLESS)
        teeth = names.above_zero(self, "teeth", DIMENSIONLESS)
        names.counts.update(free_symbols(starts), free_symbols(teeth))
        self._look_at_distance(names, dot(gap, p), radius, radius * Call("tan", self._lead(names)) * teeth / starts)
        # the point of the worm's axis that is nearest to that of the wheel, and r_1 from there
        foot = combined((ONE, worm.at), (negate(dot(gap, a1)), a1))
        return combined((ONE, foot), (negate(radius), p)), p, vector_product(a1, p)

    def _look_at_distance(self, names: Names, distance: Expr, worm: Expr, wheel: Expr) -> None:
        apart, needed = names.numeric(distance), names.numeric(worm + wheel)
        if apart is None or needed is None or is_near(apart, needed):
            return
        told = Message(
            "the axes of {worm} and {wheel} are {apart:.4g} m apart, and the teeth need {needed:.4g} m: {r1:.4g} m of "
            "the worm and {r2:.4g} m of the wheel",
            worm=self.worm,
            wheel=self.wheel,
            apart=apart,
            needed=needed,
            r1=names.numeric(worm),
            r2=names.numeric(wheel),
        )
        names.problem(told)

    def parts(self, names: Names) -> dict[str, Expr]:
        alpha = read_pressure_angle(names, self)
        if alpha is None:
            return {"tangential": ONE}
        cosine = Call("cos", self._lead(names))
        return {
            "tangential": ONE,
            "radial": divide(Call("tan", alpha), cosine),
            "normal": divide(ONE, Call("cos", alpha) * cosine),
        }

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        yield glyphs.Toothed((names.body(self.worm).center, names.body(self.wheel).center))
