"""Common factors that show only once c^2 + s^2 = 1 is used.

With T = tan(angle/2), c = (1 - T^2)/(1 + T^2) and s = 2T/(1 + T^2), a quotient of polynomials in c and s becomes one of
plain polynomials in T, whose greatest common divisor FLINT finds. Back again, T^j/(1 + T^2)^n is
((1 - c)/2)^a ((1 + c)/2)^b (s/2)^odd. The generators c and s themselves serve as T on the way.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import flint

from freebody.symbolic.polynomials import Poly, PolynomialRing, Terms

_flint: Any = flint
_PRIME = 2**61 - 1
_MOST_FACTORED = 400  # terms in T of what is factored
_LIMIT = 1_000_000  # terms times the growth that half-angle tangents may bring

Pair = tuple[int, int]  # the generators of the cosine and the sine of an angle


def cancelled(ring: PolynomialRing, num: Poly, den: Poly, pairs: Sequence[Pair]) -> tuple[Poly, Poly] | None:
    """Both polynomials without what they share; None where that is nothing, or would take too long to find."""
    size = len(num) + len(den)
    if not pairs or size > _LIMIT or _growth((num, den), pairs) * size > _LIMIT:
        return None
    num, den = ring.current(num), ring.current(den)
    if not _may_share(ring, num, den, pairs):
        return None
    for pair in pairs:
        num, den = _in_tangent(ring, num, den, pair)
    divisor = num.gcd(den)
    if divisor.is_constant():
        return None
    num, den = num / divisor, den / divisor
    for pair in pairs:
        num, den = _from_tangent(ring, num, den, pair)
    return num, den


def factors_in_tangent(ring: PolynomialRing, poly: Poly, pair: Pair) -> tuple[list[list[Poly]], bool] | None:
    """The factors of a polynomial in T = tan(angle/2), as coefficients of its powers, lowest first; and whether it
    vanishes at half a turn, where T has no value. None where that would take too long."""
    n = len(poly)
    if n > _MOST_FACTORED or _growth((poly, poly), [pair]) * n > _MOST_FACTORED:
        return None
    poly = ring.current(poly)
    at_top = max(i + j for i, j in ring.split_by_pair(poly, pair))
    inside, _one = _in_tangent(ring, poly, ring.constant(1), pair)
    split = [ring.split(factor, pair[0]) for factor, _exponent in ring.irreducible(inside)[1]]
    return [parts for parts in split if len(parts) > 1], len(ring.split(inside, pair[0])) <= 2 * at_top


def _growth(both: tuple[Poly, Poly], pairs: Sequence[Pair]) -> int:
    """A term of degree n in one angle becomes up to 2n + 1 terms."""
    growth = 1
    for c, s in pairs:
        degree = 0
        for poly in both:
            last, degrees = poly.context().nvars() - 1, poly.degrees()
            degree = max(degree, int(degrees[last - c]) + int(degrees[last - s]))
        growth *= 2 * degree + 1
    return growth


# -- whether it is worth it -------------------------------------------------------------------
def _may_share(ring: PolynomialRing, num: Poly, den: Poly, pairs: Sequence[Pair]) -> bool:
    """Whether both may have a common factor with T = tan(angle/2) of a pair: seen modulo a prime, where everything
    else is a number, cosines and sines on the circle. Factors without any T they cannot share: those divide the
    elements as they are."""
    known: dict[int, int] = {}
    for index in ring.used(num) | ring.used(den):
        known[index] = _scattered(index)
    for c, s in pairs:
        t = _scattered(c)
        below = pow(1 + t * t, -1, _PRIME)
        known[c], known[s] = (1 - t * t) * below % _PRIME, 2 * t * below % _PRIME
    terms = [ring.terms(poly) for poly in (num, den)]
    return any(_shares_tangent(terms, pair, known) for pair in pairs)


def _shares_tangent(both: Sequence[Terms], pair: Pair, known: Mapping[int, int]) -> bool:
    """Whether two polynomials have a common factor with the T of a pair, the other generators being numbers."""
    c, s = pair
    seen: list[dict[tuple[int, int], int]] = []
    for terms in both:
        parts: dict[tuple[int, int], int] = {}
        for monomial, coefficient in terms.items():
            i = j = 0
            for index, exponent in monomial:
                if index == c:
                    i = exponent
                elif index == s:
                    j = exponent
                else:
                    coefficient = coefficient * pow(known[index], exponent, _PRIME) % _PRIME
            parts[i, j] = (parts.get((i, j), 0) + coefficient) % _PRIME
        seen.append(parts)
    degree = max(i + j for parts in seen for i, j in parts)
    plus, minus, double = (_flint.nmod_poly(list(k), _PRIME) for k in ((1, 0, 1), (1, 0, -1), (0, 2)))
    found: list[Any] = []
    for parts in seen:
        total = _flint.nmod_poly([], _PRIME)
        for (i, j), coefficient in parts.items():
            total = total + coefficient * minus**i * double**j * plus ** (degree - i - j)
        found.append(total)
    return found[0].gcd(found[1]).degree() > 0


def _scattered(k: int) -> int:
    """A number for a generator, other for every one, in no simple relation with others."""
    return 2 + 30011 * (k + 1) % 65537


# -- there and back ---------------------------------------------------------------------------
def _in_tangent(ring: PolynomialRing, num: Poly, den: Poly, pair: Pair) -> tuple[Poly, Poly]:
    """Both polynomials times (1 + T^2)^degree, T written as the cosine's generator."""
    tangent = ring.variables[pair[0]]
    split = [ring.split_by_pair(poly, pair) for poly in (num, den)]
    degree = max((i + j for parts in split for i, j in parts), default=0)
    plus, minus = 1 + tangent**2, 1 - tangent**2
    result: list[Poly] = []
    for parts in split:
        total = ring.constant(0)
        for (i, j), rest in parts.items():
            total = total + rest * minus**i * (2 * tangent) ** j * plus ** (degree - i - j)
        result.append(total)
    return result[0], result[1]


def _from_tangent(ring: PolynomialRing, num: Poly, den: Poly, pair: Pair) -> tuple[Poly, Poly]:
    """Both polynomials times (2/(1 + T^2))^n, in cosine and sine again."""
    c, s = ring.variables[pair[0]], ring.variables[pair[1]]
    parts = [ring.split(poly, pair[0]) for poly in (num, den)]
    n = (max(len(p) for p in parts)) // 2
    result: list[Poly] = []
    for coefficients in parts:
        total = ring.constant(0)
        for j, rest in enumerate(coefficients):
            if rest == 0:
                continue
            a, odd = divmod(j, 2)
            b = n - a - odd
            # everything times 2^n
            total = total + rest * (1 - c) ** a * (1 + c) ** b * (s if odd else 1)
        result.append(ring.reduce(total))
    return result[0], result[1]
