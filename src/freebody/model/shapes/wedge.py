"""Wedge: a uniform right-angled triangle with a slope.

With the base L and the height h = L tan(alpha) its mass centre is L/3 and h/3 from the right angle, and

    I = m (L^2 + h^2)/18.

Source: Beer, Johnston & Cornwell, Vector Mechanics for Engineers: Dynamics, app. B; Meriam & Kraige, Statics,
table D/3.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, ClassVar, Literal

from freebody.language.expression import ONE, Call, Expr, divide, multiply, negate, number
from freebody.language.sentences import Message
from freebody.language.units import LENGTH, MASS
from freebody.measures.geometry import ZERO, Components
from freebody.model.shapes.base import Build, Shape, plate_tensor, square
from freebody.model.solids import PLATE
from freebody.model.spec import Formula

if TYPE_CHECKING:
    from freebody.model.names import Names


class Wedge(Shape, kind="wedge"):
    """`wedge: {mass: M, angle: alpha, length: L}`: a right-angled triangle on its base of the length L, with a slope
    that rises to the right, or `rises: left`; `height` in place of the length. Points: the corners `toe`, `heel` (of
    the right angle) and `top`, and the middles `base`, `back` and `face` of its sides, which others may lie on or slide
    along (`along: wedge.face`). A length that is left out is zero, unless one of these points is used."""

    called: ClassVar[tuple[str, ...]] = ("ramp", "slope", "incline", "triangle")
    also: ClassVar[tuple[str, ...]] = ("ramp",)

    mass: Formula = 0
    angle: Formula
    length: Formula | None = None
    height: Formula | None = None
    rises: Literal["right", "left"] = "right"

    open_lengths: ClassVar[dict[str, tuple[str, ...]]] = {"length": ("toe", "heel", "top", "base", "back", "face")}

    example = "{mass: 1 kg, angle: 30 deg, length: 0.4 m}"

    def lengths_left_open(self) -> Mapping[str, tuple[str, ...]]:
        return self.open_lengths if self.height is None else {}

    def build(self, names: Names) -> Build:
        m, alpha = names.positive(self, "mass", MASS), names.angle(self.angle, "angle")
        L, h = self._legs(names, alpha)
        way = ONE if self.rises == "right" else number(-1)

        def at(x: Expr, y: Expr) -> Components:
            """A place by what it is from the right angle: towards the toe, and up."""
            return multiply(way, divide(L, number(3)) - x), y - divide(h, number(3))

        half_length, half_height = divide(L, number(2)), divide(h, number(2))
        points = {
            "toe": at(L, ZERO),
            "heel": at(ZERO, ZERO),
            "top": at(ZERO, h),
            "base": at(half_length, ZERO),
            "back": at(ZERO, half_height),
            "face": at(half_length, half_height),
        }
        cos, sin = Call("cos", alpha), Call("sin", alpha)
        sides = {"base": (number(-1), ZERO), "back": (ZERO, negate(way)), "face": (cos, multiply(way, sin))}
        if self.rises == "left":
            sides = {side: sides[side] for side in ("base", "face", "back")}
        second = multiply(way, divide(m * L * h, number(36)))
        return Build(
            m,
            divide(m * (square(L) + square(h)), number(18)),
            points=points,
            corners=("toe", "heel", "top") if self.rises == "right" else ("heel", "toe", "top"),
            sides={side: (*way, ZERO) for side, way in sides.items()} if names.space else sides,
            tensor=plate_tensor(m * square(h) / 18, m * square(L) / 18, negate(second)) if names.space else (),
            solid=PLATE,
        )

    def _legs(self, names: Names, alpha: Expr) -> tuple[Expr, Expr]:
        """Base and height."""
        value = names.numeric(alpha)
        if value is not None and not 0.0 < value < 1.5707963:
            names.problem(Message("the slope of a wedge is between 0 and 90 deg"), "angle")
        L, h = (names.optional(self, side, LENGTH) for side in ("length", "height"))
        if L is not None and h is not None:
            names.problem(Message("angle and length give the height: leave out one of the three"), "height")
        if L is None and h is not None:
            return divide(h, Call("tan", alpha)), h
        L = ZERO if L is None else L
        return L, multiply(L, Call("tan", alpha))
