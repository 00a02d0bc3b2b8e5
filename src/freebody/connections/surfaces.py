"""Surfaces z = f(x, y) as connections state them, and what is drawn of them."""

from __future__ import annotations

import math
from collections.abc import Iterable
from fractions import Fraction
from typing import TYPE_CHECKING

from freebody.connections.curves import put_at
from freebody.language.expression import (
    ONE,
    ZERO,
    Call,
    Expr,
    Number,
    PowerOf,
    ProductOf,
    Sum,
    Symbol,
    free_symbols,
    number,
    power,
    substitute,
)
from freebody.language.units import LENGTH
from freebody.measures.base import Measure
from freebody.measures.distance import Bearing
from freebody.measures.geometry import AXES, GROUND, Point
from freebody.model import glyphs
from freebody.model.elements import RigidBody
from freebody.model.glyphs import Glyph
from freebody.model.spec import Formula
from freebody.model.spins import body_axes
from freebody.model.surfaces import SQUARE, Surface, from_axis
from freebody.tolerances import ROUNDED

if TYPE_CHECKING:
    from freebody.model.names import Names

_N_MERIDIANS, _N_CIRCLES, _N_ALONG, _N_ROUND = 4, 3, 24, 48  # lines that are drawn, and stretches of one
_RHO = Symbol("rho")


def surface_of(names: Names, z: Formula, base: RigidBody) -> Surface | None:
    """The surface of a body that is written; None with a problem noted."""
    n = len(names.problems)
    given = names.formula(z, LENGTH, "z", extra={"x": LENGTH, "y": LENGTH, "rho": LENGTH})
    if len(names.problems) > n:
        return None
    height = without_rho(given)
    origin = base.center if base.name != GROUND else names.ground_origin
    x, y, up = AXES if base.name == GROUND else body_axes(base.name)
    return Surface(height, not {"x", "y"} & free_symbols(given), origin, (x, y, up))


def without_rho(e: Expr) -> Expr:
    """A formula in x and y alone, in which even powers of rho are powers of x^2 + y^2."""
    if e == _RHO:
        return Call("sqrt", SQUARE)
    if isinstance(e, PowerOf) and e.base == _RHO and isinstance(e.exponent, Number):
        return power(SQUARE, Number(e.exponent.value / 2))
    if isinstance(e, PowerOf):
        return power(without_rho(e.base), without_rho(e.exponent))
    if isinstance(e, Call):
        return e.of(without_rho)
    if isinstance(e, Sum):
        return sum((without_rho(term) for term in e.terms), start=number(0))
    if isinstance(e, ProductOf):
        found = ONE
        for factor in e.factors:
            found = found * without_rho(factor)
        return found
    return e


def polar(names: Names, surface: Surface, point: Point) -> Iterable[tuple[str, Measure]]:
    """rho and phi of a point that goes round the axis of a surface of revolution at the start. They have no place on
    the axis, so where nothing goes round it x and y remain."""
    if surface.is_round and _goes_round(names, point):
        yield "rho", from_axis(point, surface.origin, surface.axes)
        yield "angle", Bearing(surface.origin, point, surface.origin.body)


def _goes_round(names: Names, point: Point) -> bool:
    """Whether what the model says of the start of a body has it go round the z axis of the ground."""
    start = names.known(point.body).start
    if start.at is None or start.velocity is None:
        return False
    (_at, (x, y, *_z)), (u, v, *_w) = start.at, start.velocity
    around = x * v - y * u
    value = names.numeric(around)
    return around != ZERO and (value is None or abs(value) > ROUNDED)


def drawn(names: Names, surface: Surface, point: Point, reach: Formula | None) -> Iterable[Glyph]:
    """Lines through the axis, and circles about it, as far as the model says, else farther than the point is put."""
    far = reach_of(names, point, reach)
    base = surface.origin.offset

    def at(share: Expr, angle: float) -> Point:
        x, y = (number(_rounded(turned)) * share * far for turned in (math.cos(angle), math.sin(angle)))
        place = x, y, substitute(surface.height, {"x": x, "y": y})
        return Point(surface.origin.body, tuple(a + b for a, b in zip(base, place, strict=True)))

    whole = 2.0 * math.pi
    for k in range(_N_MERIDIANS):
        shares = [number(2 * j - _N_ALONG) / number(_N_ALONG) for j in range(_N_ALONG + 1)]
        yield glyphs.Relation(tuple(at(share, 0.5 * whole * k / _N_MERIDIANS) for share in shares), is_of_net=True)
    for k in range(1, _N_CIRCLES + 1):
        share = number(k) / number(_N_CIRCLES)
        yield glyphs.Relation(tuple(at(share, whole * j / _N_ROUND) for j in range(_N_ROUND + 1)), is_of_net=True)


def reach_of(names: Names, point: Point, reach: Formula | None) -> Expr:
    """How far from the axis a surface is drawn."""
    return _reach(names, point) if reach is None else names.formula(reach, LENGTH, "reach")


def _rounded(x: float) -> Fraction:
    return Fraction(x).limit_denominator(10**6)


def _reach(names: Names, point: Point) -> Expr:
    """Somewhat farther from the axis than a point is put."""
    put = [names.numeric(c) for c in put_at(names, point) or ()]
    far = math.hypot(*(c for c in put[:2] if c is not None))
    return number(Fraction(1.5 * far).limit_denominator(1000)) if far else ONE
