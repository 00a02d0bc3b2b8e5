"""Signs of field elements under the declared signs of the parameters.

Sufficient tests, never guesses: a polynomial whose terms all have one sign has it; a product has the product of
the signs of its factors; with c^2 + s^2 = 1 either square may be replaced; a number has the sign of its value; a
trigonometric polynomial is bounded by the sum of its amplitudes.
"""

from __future__ import annotations

import math
from enum import Enum
from fractions import Fraction

from freebody.language.expression import LAMBERT
from freebody.symbolic.field import Field
from freebody.symbolic.functions import cos_sin
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.waves import Terms, fourier, sine_form, square_variants
from freebody.tolerances import ROUND_OFF


class Sign(Enum):
    """What is known of an element for all admissible values."""

    POSITIVE = "positive"
    NONNEGATIVE = "not negative"
    NEGATIVE = "negative"
    NONPOSITIVE = "not positive"
    ZERO = "zero"
    UNKNOWN = "unknown"

    def __neg__(self) -> Sign:
        return _OPPOSITE[self]

    @property
    def is_strict(self) -> bool:
        return self in (Sign.POSITIVE, Sign.NEGATIVE)


_MOST_WAVES = 100_000  # that a sum of products of sines and cosines is taken apart into

_OPPOSITE = {
    Sign.POSITIVE: Sign.NEGATIVE,
    Sign.NEGATIVE: Sign.POSITIVE,
    Sign.NONNEGATIVE: Sign.NONPOSITIVE,
    Sign.NONPOSITIVE: Sign.NONNEGATIVE,
    Sign.ZERO: Sign.ZERO,
    Sign.UNKNOWN: Sign.UNKNOWN,
}


def sign_of(x: Ratio) -> Sign:
    """The sign of an element, where it can be told."""
    field = x.field
    result = _product(field, x.num)
    if x.den is not None:
        result = times(result, _product(field, x.den))
    return result


def sign_is_positive(x: Ratio) -> bool:
    return sign_of(x) is Sign.POSITIVE


def sign_is_negative(x: Ratio) -> bool:
    return sign_of(x) in (Sign.NEGATIVE, Sign.NONPOSITIVE)


def times(a: Sign, b: Sign) -> Sign:
    if Sign.ZERO in (a, b):
        return Sign.ZERO
    if Sign.UNKNOWN in (a, b):
        return Sign.UNKNOWN
    negative = (a in (Sign.NEGATIVE, Sign.NONPOSITIVE)) != (b in (Sign.NEGATIVE, Sign.NONPOSITIVE))
    if a.is_strict and b.is_strict:
        return Sign.NEGATIVE if negative else Sign.POSITIVE
    return Sign.NONPOSITIVE if negative else Sign.NONNEGATIVE


def _product(field: Field, poly: object) -> Sign:
    """The sign of a polynomial, found once: nearly all are asked for again and again."""
    text = str(poly)  # FLINT's polynomials have no hash
    found = field.known_signs.get(text)
    if found is None:
        found = field.known_signs[text] = _of_product(field, poly)
    return found


def _of_product(field: Field, poly: object) -> Sign:
    element = Ratio(field, poly, None)
    if element.is_zero():
        return Sign.ZERO
    whole = _sum(field, field.terms(poly))
    if whole is not Sign.UNKNOWN:
        return whole
    unit, factors = field.factor_by_degree(poly) or field.factor(poly)
    result = Sign.POSITIVE if unit > 0 else Sign.NEGATIVE
    for base, exponent in factors:
        own = _sum(field, field.terms(base.num))
        if exponent % 2 == 0:
            own = Sign.POSITIVE if own.is_strict else Sign.NONNEGATIVE
        result = times(result, own)
    return result


def is_positive(field: Field, g: int) -> bool:
    """True for generators that are positive for all admissible values."""
    generator = field.generators[g]
    if generator.kind == "root" and generator.made_of:
        if g not in field.positive_roots:
            field.positive_roots[g] = sign_of(field.radicand(g)) is Sign.POSITIVE
        return field.positive_roots[g]
    return generator.positive


def _with_root(field: Field, terms: Terms) -> Sign:
    """a + b r with a root r >= 0: the common sign of a and b, else the sign of the larger of a^2 and b^2 r^2."""
    roots = sorted({g for m in terms for g, _e in m if _is_root(field, g)}, reverse=True)
    if not roots:
        return Sign.UNKNOWN
    r = roots[0]
    parts = field.polynomial(terms).coefficients(r)
    if len(parts) != 2:
        return Sign.UNKNOWN
    a, b = sign_of(parts[0]), sign_of(parts[1])
    if Sign.UNKNOWN in (a, b):
        return Sign.UNKNOWN
    if parts[0].is_zero():
        return times(b, Sign.POSITIVE if is_positive(field, r) else Sign.NONNEGATIVE)
    negative_a, negative_b = (s in (Sign.NEGATIVE, Sign.NONPOSITIVE) for s in (a, b))
    if negative_a == negative_b:
        if a.is_strict:
            return a
        return Sign.NONPOSITIVE if negative_a else Sign.NONNEGATIVE
    larger = sign_of(parts[0] * parts[0] - parts[1] * parts[1] * field.radicand(r))
    if larger in (Sign.POSITIVE, Sign.NONNEGATIVE):
        return times(larger, a)
    if larger in (Sign.NEGATIVE, Sign.NONPOSITIVE):
        return times(-larger, b)
    return Sign.UNKNOWN


def _sum(field: Field, terms: Terms) -> Sign:
    if any(_is_root(field, g) for m in terms for g, _e in m):
        found = _with_root(field, terms)
        if found is not Sign.UNKNOWN:
            return found
    for variant in square_variants(field, terms):
        found = _terms(field, variant)
        if found is not Sign.UNKNOWN:
            return found
    for way in (_number, _acute_angles, _amplitudes, _function):
        found = way(field, terms)
        if found is not Sign.UNKNOWN:
            return found
    return Sign.UNKNOWN


# functions that only rise: where they are what, if that decides a sign
_RISING = {"log": 1, "atan": 0, "asin": 0, "acos": None}  # the argument at which they vanish; acos only falls
_FALLING = {"acos"}


def _function(field: Field, terms: Terms) -> Sign:
    """a exp(u) + b exp(u)^2 + ... + r by the sign of u, since exp(u) > 1 where u > 0; a f(u) and a (f(u) - f(v)) for a
    function f that only rises by where the argument is, or by that of u - v."""
    used = sorted({g for m in terms for g, _e in m if g in field.arguments}, reverse=True)
    x = field.polynomial(terms)
    for g in used:
        way = {"exp": _exponential, **dict.fromkeys(LAMBERT, _lambert)}.get(field.arguments[g][0])
        if way is not None and (found := way(field, x, g)) is not Sign.UNKNOWN:
            return found
    names = {field.arguments[g][0] for g in used}
    if len(names) != 1 or not names <= _RISING.keys() or len(used) > 2:
        return Sign.UNKNOWN
    (name,) = names
    parts = x.coefficients(used[0])
    if len(parts) != 2:
        return Sign.UNKNOWN
    rest, slope = parts
    if len(used) == 1:
        zero, u = _RISING[name], field.arguments[used[0]][1]
        if rest.is_zero() and zero is not None:
            return times(sign_of(slope), sign_of(u - zero))
        against = field.lowest_terms(-rest / slope)
        turns = (against / field.pi).fraction()
        if name == "log":
            return Sign.UNKNOWN
        if turns is None and (edge := acute_argument(name, against)) is not None:
            found = times(sign_of(slope), sign_of(u - edge))
            return -found if name in _FALLING else found
        return Sign.UNKNOWN if turns is None else times(sign_of(slope), _arc(name, u, turns))
    below = rest.coefficients(used[1])
    if len(below) != 2 or not below[0].is_zero() or not (below[1] + slope).is_zero():
        return Sign.UNKNOWN
    first, second = (field.arguments[g][1] for g in used)
    found = times(sign_of(slope), sign_of(first - second))
    return -found if name in _FALLING else found


ARC_RANGES = {name: (Fraction(-1, 2), Fraction(1, 2)) for name in ("asin", "atan")} | {
    "acos": (Fraction(0), Fraction(1))
}


def arc_argument(name: str, field: Field, part: Fraction) -> Ratio | None:
    """Where asin, acos or atan is a part of pi; None beyond its range, and where it only tends to that."""
    low, high = ARC_RANGES[name]
    if part < low or part > high or (name == "atan" and part in (low, high)):
        return None
    cos, sin = cos_sin(field, field.pi * part.numerator / part.denominator)
    edge = {"asin": sin, "acos": cos}.get(name)
    return sin / cos if edge is None else edge


def acute_argument(name: str, angle: Ratio) -> Ratio | None:
    """Where asin, acos or atan is an acute angle that is given; None of any other."""
    field = angle.field
    if len(angle.generators()) != 1 or not all(field.acute(g) for g in angle.generators()):
        return None
    if angle != field.variable(min(angle.generators())):
        return None
    cos, sin = cos_sin(field, angle)
    return {"asin": sin, "acos": cos, "atan": sin / cos}.get(name)


def _acute_angles(field: Field, terms: Terms) -> Sign:
    """A sum of acute angles and right ones, by the ends of its range: pi/2 - a, 2 a - pi, pi - a - b."""
    low = high = Fraction(0)  # in right angles; neither end is reached
    is_open = False
    for monomial, coefficient in terms.items():
        if len(monomial) != 1 or monomial[0][1] != 1:
            return Sign.UNKNOWN
        ((g, _power),) = monomial
        if g == field.index(field.pi):
            low, high = low + 2 * coefficient, high + 2 * coefficient
        elif field.acute(g):
            low, high, is_open = low + min(coefficient, 0), high + max(coefficient, 0), True
        else:
            return Sign.UNKNOWN
    if is_open and low >= 0:
        return Sign.POSITIVE
    return Sign.NEGATIVE if is_open and high <= 0 else Sign.UNKNOWN


def _arc(name: str, u: Ratio, part: Fraction) -> Sign:
    """asin u, acos u or atan u against a part of pi: by the range of the arc, else by where u is."""
    low, high = ARC_RANGES[name]
    edge = arc_argument(name, u.field, part)
    if edge is None:
        return Sign.POSITIVE if part <= low else Sign.NEGATIVE
    found = sign_of(u - edge)
    found = -found if name in _FALLING else found
    if found is Sign.UNKNOWN and part in (low, high):
        return Sign.NONNEGATIVE if part == low else Sign.NONPOSITIVE
    return found


def _exponential(field: Field, x: Ratio, g: int) -> Sign:
    """Of a polynomial in exp(u), by its coefficients in exp(u) - 1, or in exp(-u) - 1 where u is negative."""
    argument = sign_of(field.arguments[g][1])
    if argument in (Sign.UNKNOWN, Sign.ZERO):
        return Sign.UNKNOWN
    parts = x.coefficients(g)
    if argument in (Sign.NEGATIVE, Sign.NONPOSITIVE):
        parts = parts[::-1]
    shifted = [sum((math.comb(j, k) * parts[j] for j in range(k, len(parts))), field.zero) for k in range(len(parts))]
    signs = [sign_of(c) for c in shifted if not c.is_zero()]
    for sign, wide in ((Sign.POSITIVE, Sign.NONNEGATIVE), (Sign.NEGATIVE, Sign.NONPOSITIVE)):
        if all(s in (sign, wide) for s in signs):
            at_zero = not shifted[0].is_zero() and signs[0] is sign
            return sign if at_zero or (argument.is_strict and sign in signs) else wide
    return Sign.UNKNOWN


def _lambert(field: Field, x: Ratio, g: int) -> Sign:
    """Of a (W + c), since W_0 >= -1 has the sign of its argument and W_-1 <= -1."""
    name, argument = field.arguments[g]
    parts = x.coefficients(g)
    if len(parts) != 2:
        return Sign.UNKNOWN
    slope = sign_of(parts[1])
    if name == "lambert_W0" and parts[0].is_zero():
        return times(slope, sign_of(argument))
    beyond = sign_of(field.lowest_terms(parts[0] / parts[1]) - 1)
    if name == "lambert_W0" and beyond in (Sign.POSITIVE, Sign.NONNEGATIVE, Sign.ZERO):
        is_strict = beyond is Sign.POSITIVE or _is_off_branch_point(field, argument)
        return times(slope, Sign.POSITIVE if is_strict else Sign.NONNEGATIVE)
    if name == "lambert_Wm1" and beyond in (Sign.NEGATIVE, Sign.NONPOSITIVE, Sign.ZERO):
        is_strict = beyond is Sign.NEGATIVE or _is_off_branch_point(field, argument)
        return times(slope, Sign.NEGATIVE if is_strict else Sign.NONPOSITIVE)
    return Sign.UNKNOWN


def _is_off_branch_point(field: Field, z: Ratio) -> bool:
    """Whether z > -1/e: z is not negative, or it is -k e^q with k > 0 and log k + q + 1 < 0, which log k <= k - 1 (with
    equality for k = 1 only) shows where k + q < 0, or k + q = 0 and k is not 1."""
    if sign_of(z) in (Sign.POSITIVE, Sign.NONNEGATIVE, Sign.ZERO):
        return True
    atoms = [g for g in z.generators() if field.arguments.get(g, ("",))[0] == "exp"]
    if len(atoms) != 1:
        return False
    g, q = atoms[0], field.arguments[atoms[0]][1]
    for power in (1, -1):
        k = field.lowest_terms(-z / field.variable(g) ** power)
        if g in k.generators():
            continue
        rest, unit = sign_of(field.lowest_terms(k + power * q)), sign_of(k - 1)
        return sign_of(k) is Sign.POSITIVE and (
            rest is Sign.NEGATIVE or (rest in (Sign.ZERO, Sign.NONPOSITIVE) and unit.is_strict)
        )
    return False


def _number(field: Field, terms: Terms) -> Sign:
    """9 pi - 16: a number, told by its value where that is beyond round-off."""
    values: dict[int, float] = {}
    used = {g for monomial in terms for g, _e in monomial}
    for g in sorted(used.union(*(field.generators[g].made_of for g in used))):
        compute = field.generators[g].compute
        if compute is None or not field.is_constant_generator(g):
            return Sign.UNKNOWN
        try:
            values[g] = float(compute(values, math))
        except (KeyError, ValueError, ArithmeticError):
            return Sign.UNKNOWN
    value, size = field.numerator_and_size(field.polynomial(terms), values)
    if abs(value) <= ROUND_OFF * size:
        return Sign.UNKNOWN
    return Sign.POSITIVE if value > 0 else Sign.NEGATIVE


def _terms(field: Field, terms: Terms) -> Sign:
    """All terms of one sign; strict if one term is."""
    signs: set[bool] = set()
    strict = False
    for monomial, coefficient in terms.items():
        odd = [g for g, e in monomial if e % 2]
        if not all(is_positive(field, g) for g in odd if not _is_root(field, g)):
            return Sign.UNKNOWN
        signs.add(coefficient > 0)
        strict = strict or all(is_positive(field, g) for g, _e in monomial)
    if len(signs) != 1:
        return Sign.UNKNOWN
    positive = signs.pop()
    if strict:
        return Sign.POSITIVE if positive else Sign.NEGATIVE
    return Sign.NONNEGATIVE if positive else Sign.NONPOSITIVE


def _is_root(field: Field, g: int) -> bool:
    return field.generators[g].kind == "root" and bool(field.generators[g].made_of)


def _amplitudes(field: Field, terms: Terms) -> Sign:
    """constant + sum of waves >= constant - sum of amplitudes. Unknown where these would be too many waves."""
    trigs = [[e + 1 for g, e in m if field.generators[g].kind in ("cos", "sin")] for m in terms]
    if sum(map(math.prod, trigs)) > _MOST_WAVES:
        return Sign.UNKNOWN
    constant: dict[tuple[tuple[int, int], ...], object] = {}
    total = field.zero
    for monomial, coefficient in terms.items():
        trig = tuple(i for i in monomial if field.generators[i[0]].kind in ("cos", "sin"))
        fixed = tuple(i for i in monomial if field.generators[i[0]].kind not in ("cos", "sin"))
        if not all(is_positive(field, g) for g, e in fixed if e % 2):
            return Sign.UNKNOWN
        for (is_sine, frequencies), share in fourier(field, trig).items():
            constant.setdefault((fixed, is_sine, frequencies), field.zero)  # pyrefly: ignore[no-matching-overload]
            constant[fixed, is_sine, frequencies] += field.element(share * coefficient)  # pyrefly: ignore[bad-index, unsupported-operation]
    lower = upper = total
    # amplitudes of one wave are added over the fixed monomials before their size is taken
    waves: dict[object, list[tuple[object, Ratio]]] = {}
    for (fixed, is_sine, frequencies), share in constant.items():
        waves.setdefault((is_sine, frequencies), []).append((fixed, share))  # pyrefly: ignore[bad-argument-type]
    for (_is_sine, frequencies), parts in waves.items():  # pyrefly: ignore[not-iterable]
        for fixed, share in parts:
            term = field.polynomial({fixed: 1}) * share  # pyrefly: ignore[bad-assignment]
            if not frequencies:
                lower, upper = lower + term, upper + term
            else:
                value = share.fraction() or 0
                size = term if value > 0 else -term
                lower, upper = lower - size, upper + size
    low, high = _terms_of(field, lower), _terms_of(field, upper)
    if low in (Sign.POSITIVE, Sign.NONNEGATIVE):
        return low
    if high in (Sign.NEGATIVE, Sign.NONPOSITIVE):
        return high
    return Sign.UNKNOWN


def _terms_of(field: Field, x: Ratio) -> Sign:
    if x.is_zero():
        return Sign.NONNEGATIVE
    own = _of_one_sign(field, field.terms(x.num))
    if x.den is not None:
        own = times(own, _of_one_sign(field, field.terms(x.den)))
    return own


def _of_one_sign(field: Field, terms: Terms) -> Sign:
    found = _terms(field, terms)
    return _number(field, terms) if found is Sign.UNKNOWN else found


__all__ = ["Sign", "sign_of", "sine_form", "times"]
