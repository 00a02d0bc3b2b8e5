"""Clothoid: the transition curve of roads and railways, whose curvature grows in proportion to its length.

Its natural equation is kappa = s/A^2, so that its heading is s^2/(2 A^2), and with Fresnel's integrals

    x = int_0^s cos(u^2/(2 A^2)) du = A sqrt(pi) C(s/(A sqrt(pi))),        y = A sqrt(pi) S(s/(A sqrt(pi))).

s is the length of the curve from where it is straight; at the speed v its normal force is m v^2 s/A^2, and grows by m
v^3/A^2 in each second. Source: Abramowitz & Stegun, Handbook of Mathematical Functions, 1964, 7.3; Lautenbach &
Schwarz, Strassenplanung (RAS-L 1995, sec. 4.2).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from freebody.connections.rails import Rail
from freebody.language.expression import PI, Call, Expr, Symbol, divide, negate, number
from freebody.language.sentences import Message
from freebody.language.units import LENGTH
from freebody.model.curves import PARAMETER, Curve
from freebody.model.spec import Formula

if TYPE_CHECKING:
    from freebody.model.names import Names

_SIDES = ("left", "right")


class Clothoid(Rail, kind="clothoid"):
    """`clothoid: {point: car, scale: A}`: a point stays on a clothoid of another body (`on`, default the ground), which
    starts straight along its x axis at its reference point and has the curvature s/A² after the length s; `bends: left`
    (the default) or `right` (1 row, in space 2). `parameter of track` is s, as a measure. The normal force is positive
    when it pushes to the left of the way. `leaves`, `friction` and `ends` are those of a `curved_rail`."""

    called: ClassVar[tuple[str, ...]] = ("spiral", "transition", "track", "curve")

    scale: Formula
    bends: str = "left"

    example = """
bodies: {car: {particle: {mass: 1 kg}, near: {at: [1 m, 0.05 m]}}}
parameters: {A: 2 m}
connections: {it: {clothoid: {point: car, scale: A}}}
"""

    def told_range(self, names: Names) -> tuple[Expr, Expr]:
        """To where it is turned by a right angle."""
        return number(0), names.positive(self, "scale", LENGTH) * Call("sqrt", PI)

    def curve(self, names: Names) -> Curve:
        if self.bends not in _SIDES:
            names.problem(Message("bends is one of {names}", names=", ".join(_SIDES)), "bends")
        origin, axes = self.placed(names)
        size = names.above_zero(self, "scale", LENGTH) * Call("sqrt", PI)
        along = divide(Symbol(PARAMETER), size)
        y = size * Call("fresnel_s", along)
        return Curve(size * Call("fresnel_c", along), y if self.bends == "left" else negate(y), LENGTH, origin, axes)
