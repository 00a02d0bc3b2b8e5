"""Disc and cone clutches and brakes: the torque that their faces carry by dry friction, from force and radii.

A ring of the face at the radius rho is pressed with p dA, dA = 2 pi rho d(rho), and carries mu rho p dA:

    new faces, p constant             T = 2/3 mu F (R^3 - r^3)/(R^2 - r^2)
    worn in, wear ~ p rho constant    T = mu F (R + r)/2

for every pair of faces; on a cone, of half the angle alpha, the faces are pressed 1/sin(alpha) times as hard. Source:
Shigley, Mechanical Engineering Design, sec. 16-5 and 16-7; Meriam & Kraige, Statics, sec. 6/7.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any, ClassVar

from freebody.connections.base import Connection
from freebody.language.expression import Call, Expr, divide, multiply, number, power
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, FORCE, LENGTH, TIME
from freebody.measures.angle import Angle
from freebody.model import glyphs
from freebody.model.elements import ConstraintRow, DryFriction, UnilateralConstraint
from freebody.model.friction import read_friction
from freebody.model.glyphs import Glyph
from freebody.model.spec import Formula

if TYPE_CHECKING:
    from freebody.model.names import Names


class DiscClutch(Connection, kind="disc_clutch"):
    """`disc_clutch: {between: [flywheel, shaft], force: F, friction: mu, inner_radius: r, outer_radius: R}`: faces that
    are pressed on each other with F resist a relative turn by mu F (R + r)/2; with the ground it is a brake. `faces: n`
    pairs of them (a plate between two disks has 2); `pressure: uniform` for new faces,
    2/3 mu F (R^3 - r^3)/(R^2 - r^2); `cone_angle: alpha`, the angle between the faces and the axis, for a cone. The
    force may depend on time `t`."""

    called: ClassVar[tuple[str, ...]] = ("clutch", "brake", "disc brake", "cone clutch")
    also: ClassVar[tuple[str, ...]] = ("clutch", "plate_clutch", "plates", "disk_clutch", "friction_clutch")
    instead: ClassVar[Mapping[str, str]] = {
        **dict.fromkeys(
            ("cone_clutch", "cone", "Kegelkupplung"),
            Message(
                "it is a disc_clutch with the angle between its faces and the axis beside the rest: cone_angle: 12 deg"
            ),
        ),
    }
    elsewhere: ClassVar[Mapping[str, str]] = {
        **dict.fromkeys(
            ("plates", "discs", "disks", "number", "n"),
            Message("faces is the number of pairs of faces that rub: a plate between two disks has 2"),
        ),
        "torque": Message(
            "a clutch by the torque that it can transmit is brake: {{between: [drum, shaft], torque: T}}"
        ),
    }

    between: list[str]
    force: Formula
    friction: Formula | dict[str, Any]
    inner_radius: Formula
    outer_radius: Formula
    faces: Formula = 1
    pressure: str = "worn"
    cone_angle: Formula | None = None

    is_chosen = True
    in_plane = True
    example = """
bodies: {drum: {disk: {mass: 1 kg, radius: 0.1 m}}}
connections:
  p: {pin: [ground.A, drum]}
  it: {disc_clutch: {between: [drum, ground], force: 10 N, friction: 0.3, inner_radius: 40 mm, outer_radius: 80 mm}}
"""

    def bounds(self, names: Names, connection: str) -> tuple[list[UnilateralConstraint], list[DryFriction]]:
        if len(self.between) != 2:
            names.problem(Message("a clutch is between two bodies, e.g. between: [flywheel, shaft]"), "between")
            return [], []
        first, second = (names.body(name, "between", k) for k, name in enumerate(self.between))
        if first is second and first.name not in names.broken:
            told = Message("joins {body} to itself; name two bodies", body=first.name)
            names.problem(told, "between")
        for k, body in enumerate((first, second)):
            if not body.turns:
                names.problem(Message("{body} is a particle and does not turn", body=body.name), "between", k)
        arm = self._arm(names)
        friction = read_friction(names, self.friction, DIMENSIONLESS)
        row = ConstraintRow("torque", "friction torque", Angle(first.name, second.name), connection=connection)
        return [], [DryFriction(row, multiply(friction.static, arm), multiply(friction.kinetic, arm))]

    def _arm(self, names: Names) -> Expr:
        """What the coefficient of friction is multiplied by: the force on all faces times their mean radius."""
        force = names.formula(self.force, FORCE, "force", extra={"t": TIME})
        r, R = names.positive(self, "inner_radius", LENGTH), names.positive(self, "outer_radius", LENGTH)
        inner, outer = names.numeric(r), names.numeric(R)
        if inner is not None and outer is not None and inner > outer:
            told = Message(
                "inner_radius is {inner:.4g} m, more than outer_radius; it is at most {outer:.4g} m",
                inner=inner,
                outer=outer,
            )
            names.problem(told, "inner_radius")
        if self.pressure not in ("worn", "uniform"):
            names.problem(Message("pressure is worn (wear alike all over) or uniform (new faces)"), "pressure")
        mean = divide(R + r, number(2))
        if self.pressure == "uniform":  # (R^3 - r^3)/(R^2 - r^2), both by R - r
            mean = divide(2 * (power(R, number(2)) + R * r + power(r, number(2))), 3 * (R + r))
        faces = names.formula(self.faces, DIMENSIONLESS, "faces")
        arm = multiply(faces, force, mean)
        return arm if self.cone_angle is None else divide(arm, Call("sin", names.angle(self.cone_angle, "cone_angle")))

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        first, second = (names.body(name) for name in self.between)
        yield glyphs.Shoe(first.center, second.center)
