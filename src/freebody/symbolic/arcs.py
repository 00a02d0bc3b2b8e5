"""Inverse functions of sines, cosines and tangents over the field.

An arc is told as the angle that it is where that is known: of numbers, multiples of 15 degrees, and of functions of an
acute angle, that angle. asin u and acos u = pi/2 - asin u have one atom, and so have opposite arguments.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from freebody.symbolic.atoms import function_atom
from freebody.symbolic.field import Field
from freebody.symbolic.numbers_with_roots import in_roots
from freebody.symbolic.ratio import Ratio


def arc(
    field: Field, name: str, argument: Ratio, slope: Callable[[Ratio], Ratio], rate: Callable[[], Ratio] | None = None
) -> Ratio:
    def again(u: Ratio) -> Ratio:
        return arc_or_known(field, name, u, slope)

    return function_atom(field, name, argument, lambda _f, u: slope(u), again, rate)


def known_arc(field: Field, name: str, x: Ratio) -> Ratio | None:
    """An inverse function at a number where it is a multiple of 15 degrees, or of a function of an acute angle."""
    if (acute := _of_acute(field, name, x)) is not None:
        return acute
    number = of_roots(x)
    part = None if number is None else _twelfths(1 / (1 + x * x) if name == "atan" else x * x)
    if number is None or part is None:
        return None
    upright = {"acos": part, "asin": 6 - part, "atan": part}[name]
    return field.pi * (upright if number >= 0 else 12 - upright if name == "acos" else -upright) / 12


def of_roots(x: Ratio) -> float | None:
    """The value of what has nothing but roots of numbers in it."""
    field = x.field
    if all(field.generators[g].kind == "root" for g in field.ingredients(x)):
        return float(field.evaluate(x, field.complete({})))
    return None


# the angles of which a double one has these cosines, in parts of pi/12
_TWELFTHS: dict[tuple[tuple[int, Fraction], ...], int] = {
    ((1, Fraction(1)),): 0,
    ((3, Fraction(1, 2)),): 1,
    ((1, Fraction(1, 2)),): 2,
    (): 3,
    ((1, Fraction(-1, 2)),): 4,
    ((3, Fraction(-1, 2)),): 5,
    ((1, Fraction(-1)),): 6,
}


def _twelfths(square: Ratio) -> int | None:
    """An angle of the first quadrant by the square of its cosine, in parts of pi/12: cos 2 a = 2 cos^2 a - 1."""
    double = in_roots(2 * square - 1)
    return None if double is None else _TWELFTHS.get(tuple(double.items()))


def _of_acute(field: Field, name: str, x: Ratio) -> Ratio | None:
    """The angle itself, or what it lacks of a right angle: acos(sin b) = pi/2 - b, atan(cos b/sin b) = pi/2 - b."""
    for c, s in field.pairs(x.generators()):
        if not field.generators[c].positive or not field.generators[s].positive:
            continue
        angle, cos, sin = field.angles[c], field.variable(c), field.variable(s)
        own, other = {"asin": (sin, cos), "acos": (cos, sin), "atan": (sin / cos, cos / sin)}[name]
        for sign in (1, -1):
            if x in (sign * own, sign * other):
                known = angle if x == sign * own else field.pi / 2 - angle
                return known if sign > 0 else field.pi - known if name == "acos" else -known
    return None


def arc_or_known(field: Field, name: str, x: Ratio, slope: Callable[[Ratio], Ratio]) -> Ratio:
    """An inverse function: where it is known, else an atom of its own, that of an argument that is not a sum of
    negative terms: asin and atan are odd, and acos(-x) = pi - acos(x); since asin u + acos u = pi/2, both have one
    atom."""
    known = known_arc(field, name, x)
    if known is not None:
        return known
    if name != "atan" and (other := _by_complement(field, name, x)) is not None:
        return other
    if all(c < 0 for c in field.terms(x.num).values()):
        return field.pi - arc_or_known(field, name, -x, slope) if name == "acos" else -arc(field, name, -x, slope)
    if name == "acos" and (half := _half_cosine(field, x)) is not None:
        return 2 * arc_or_known(field, name, half, slope)
    return arc(field, name, x, slope)


def complement_atom(field: Field, name: str, u: Ratio) -> Ratio:
    """asin u or acos u as an atom of its own, beside that of the other name: for what is shown alone."""
    root = field.sqrt(1 - u * u)
    return arc(field, name, u, lambda _u: (1 if name == "asin" else -1) / root)


def _by_complement(field: Field, name: str, x: Ratio) -> Ratio | None:
    """asin or acos by an atom of the other one, or of the opposite argument, where there is one."""
    for g, (known, u) in field.arguments.items():
        is_opposite = known in ("asin", "acos") and u == -x
        if not is_opposite and (known not in ("asin", "acos") or u != x):
            continue
        if known == name and not is_opposite:
            return field.variable(g)
        upright = field.pi / 2 - field.variable(g)  # of the other name at u
        if is_opposite:
            at_u = field.variable(g) if known == name else upright
            return -at_u if name == "asin" else field.pi - at_u
        return upright
    return None


def _half_cosine(field: Field, x: Ratio) -> Ratio | None:
    """c with x = 2 c^2 - 1, if it is a quotient of parameters and not negative: acos(2 c^2 - 1) = 2 acos c."""
    square = field.lowest_terms((1 + x) / 2)
    if square.is_constant() and square.fraction() is None:
        root = field.sqrt(square)
        if all(field.generators[g].kind == "parameter" for g in root.generators()):
            return root
    return None
