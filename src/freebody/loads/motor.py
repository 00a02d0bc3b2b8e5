"""Motor: a torque that falls with the speed along a straight line, from stall to no load.

    T = T_0 (1 - omega/omega_0)      power T omega, greatest at omega_0/2: T_0 omega_0/4

It runs up a wheel by omega = omega_0 (1 - exp(-T_0 t/(J omega_0))). Source: Norton, Design of Machinery, sec. 2.19
(permanent magnet DC motor); Shigley, Mechanical Engineering Design.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, ClassVar

from freebody.language.expression import ONE, divide, multiply
from freebody.language.sentences import Message
from freebody.language.units import ANGULAR_VELOCITY, TORQUE
from freebody.loads.base import Load
from freebody.loads.spring import turn_about
from freebody.measures.geometry import GROUND
from freebody.model import glyphs
from freebody.model.elements import RATE, AppliedLoad
from freebody.model.glyphs import Glyph
from freebody.model.spec import Formula, Heading

if TYPE_CHECKING:
    from freebody.model.names import Names


class Motor(Load, kind="motor"):
    """`motor: {on: rotor, stall_torque: T_0, no_load_speed: omega_0}`: the torque T_0 (1 - omega/omega_0), omega the
    speed against `reacts_on` (default the ground), counter-clockwise positive; beyond omega_0 it brakes. Negative
    values of both turn it round. In space `about` says the axis, fixed in the body that it reacts on."""

    also: ClassVar[tuple[str, ...]] = ("dc_motor",)

    on: str
    stall_torque: Formula
    no_load_speed: Formula
    reacts_on: str = GROUND
    about: Heading | None = None

    is_chosen = True
    example = """
bodies: {wheel: {disk: {mass: 1 kg, radius: 1 m}}}
loads: {it: {motor: {on: wheel, stall_torque: 2 N m, no_load_speed: 50 rad/s}}}
"""

    def applied_loads(self, names: Names) -> list[AppliedLoad]:
        body = names.body(self.on, "on")
        if not body.turns:
            names.problem(Message("{body} is a particle and cannot take a torque", body=body.name), "on")
        turned = turn_about(names, self.on, self.reacts_on, self.about)
        torque = names.formula(self.stall_torque, TORQUE, "stall_torque")
        speed = names.formula(self.no_load_speed, ANGULAR_VELOCITY, "no_load_speed")
        numbers = names.numeric(torque), names.numeric(speed)
        if None not in numbers and (numbers[0] or 0.0) * (numbers[1] or 0.0) <= 0.0:
            names.problem(
                Message("stall_torque and no_load_speed act the same way round; give both positive, or both negative"),
                "no_load_speed",
            )
            return []
        return [AppliedLoad("", turned, multiply(torque, ONE - divide(RATE, speed)))]

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        axis = names.direction(self.about, "about", body=self.reacts_on) if names.space and self.about else None
        yield glyphs.MomentArrow(names.body(self.on).mass_center, axis)
