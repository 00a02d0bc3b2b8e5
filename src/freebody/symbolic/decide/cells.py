"""A rational point in every open cell in which no polynomial of a set changes its sign.

Cylindrical algebraic decomposition without its lower-dimensional cells: variables are eliminated one after the other by
leading coefficients, discriminants, resultants and values at the ends of an interval; between their zeros the roots of
the polynomials in the eliminated variable are continuous, distinct and never cross, so that one point between each two
neighbours stands for its whole cell. What is strict, or holds by continuity in the closure, is decided by these points.
Source: McCallum, Solving polynomial strict inequalities using cylindrical algebraic decomposition, The Computer Journal
36 (1993); Strzebonski, Solving systems of strict polynomial inequalities, J. Symbolic Computation 29 (2000).
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from itertools import combinations
from typing import Any, TypeAlias

import flint

_flint: Any = flint
Poly: TypeAlias = Any
Interval = tuple[Fraction | None, Fraction | None]  # open; None: no end

_MOST_POINTS = 3000
_MOST_POLYS = 40  # at one level
_MOST_WORK = 250_000  # terms of a discriminant or resultant, roughly
_MOST_TERMS = 400
_PRECISION = 192


class TooLarge(Exception):
    """The decomposition would have more cells, or larger polynomials, than are worth the effort."""


class Polynomials:
    """A ring of polynomials with integer coefficients over n variables."""

    def __init__(self, n: int) -> None:
        self.names = [f"v{k}" for k in range(n)]
        self._context = _flint.fmpz_mpoly_ctx.get(self.names or ["v"], _flint.Ordering.lex)
        self.variables: list[Poly] = list(self._context.gens())
        self.n = n

    def constant(self, value: int) -> Poly:
        return self._context.constant(value)

    def irreducible(self, polys: Iterable[Poly]) -> list[Poly]:
        """The different irreducible factors that are not numbers."""
        found: dict[str, Poly] = {}
        for p in polys:
            if p == 0 or p.is_constant():
                continue
            if len(p) > _MOST_TERMS:
                raise TooLarge
            try:
                factors = p.factor()[1]
            except OverflowError as error:  # exponents beyond those of the machine
                raise TooLarge from error
            for base, _exponent in factors:
                found[str(base)] = base
        return list(found.values())

    def at(self, p: Poly, k: int, value: Fraction) -> Poly:
        """With a number for one variable, times a power of its denominator."""
        degree = int(p.degrees()[k])
        terms: dict[tuple[int, ...], int] = {}
        for monomial, coefficient in p.to_dict().items():
            rest = list(map(int, monomial))
            e, rest[k] = rest[k], 0
            scaled = int(coefficient) * value.numerator**e * value.denominator ** (degree - e)
            terms[tuple(rest)] = terms.get(tuple(rest), 0) + scaled
        return self._context.from_dict(terms)

    def leading(self, p: Poly, k: int) -> Poly:
        degree = int(p.degrees()[k])
        terms: dict[tuple[int, ...], int] = {}
        for monomial, coefficient in p.to_dict().items():
            if int(monomial[k]) == degree:
                rest = list(map(int, monomial))
                rest[k] = 0
                terms[tuple(rest)] = int(coefficient)
        return self._context.from_dict(terms)


def points(ring: Polynomials, polys: Sequence[Poly], domains: Sequence[Interval]) -> Iterator[tuple[Fraction, ...]]:
    """One point in every open cell of the box `domains` on which none of the polynomials vanishes.

    Raises TooLarge, before the first point or on the way, where there are too many."""
    levels = _tower(ring, ring.irreducible(polys), domains)
    for count, found in enumerate(_lifted(ring, levels, domains, {})):
        if count == _MOST_POINTS:
            raise TooLarge
        yield tuple(found[k] for k in range(ring.n))


def _tower(ring: Polynomials, polys: list[Poly], domains: Sequence[Interval]) -> list[tuple[int, list[Poly]]]:
    """(variable, the polynomials in it and in variables further up the list), the first to be given a number first."""
    left, levels = set(range(ring.n)), list[tuple[int, list[Poly]]]()
    while left:
        k = min(left, key=lambda k: _difficulty(polys, k))
        own = [p for p in polys if p.degrees()[k] > 0]
        rest = [p for p in polys if p.degrees()[k] == 0]
        if len(polys) > _MOST_POLYS:
            raise TooLarge
        levels.append((k, own))
        left.remove(k)
        polys = rest
        if left:
            polys = ring.irreducible([*rest, *_projection(ring, own, k, domains[k])])
    return levels[::-1]


def _difficulty(polys: list[Poly], k: int) -> tuple[int, int, int]:
    """Brown's order: variables of low degree and in few terms go first."""
    own = [p for p in polys if p.degrees()[k] > 0]
    highest = max((int(p.degrees()[k]) for p in own), default=0)
    return highest, max((int(p.total_degree()) for p in own), default=0), sum(len(p) for p in own)


def _projection(ring: Polynomials, own: list[Poly], k: int, domain: Interval) -> Iterator[Poly]:
    """What must not vanish below, for the roots in variable k to stay apart, finite and inside of the interval."""
    name = ring.names[k]
    for p in own:
        yield ring.leading(p, k)
        if p.degrees()[k] > 1:
            _check_work(p, p, k)
            yield p.discriminant(name)
        for end in domain:
            if end is not None:
                yield ring.at(p, k, end)
    for p, q in combinations(own, 2):
        _check_work(p, q, k)
        yield p.resultant(q, name)


def _check_work(p: Poly, q: Poly, k: int) -> None:
    degree = int(p.degrees()[k]) + int(q.degrees()[k])
    others = sum(1 for j, (a, b) in enumerate(zip(p.degrees(), q.degrees(), strict=True)) if j != k and a + b > 0)
    if degree > 16 or (len(p) + len(q)) * degree ** (1 + min(others, 4)) > _MOST_WORK:
        raise TooLarge


def _lifted(
    ring: Polynomials, levels: list[tuple[int, list[Poly]]], domains: Sequence[Interval], found: dict[int, Fraction]
) -> Iterator[dict[int, Fraction]]:
    if len(found) == len(levels):
        yield found
        return
    k, own = levels[len(found)]
    product = _flint.fmpz_poly([1])
    for p in own:
        product *= _univariate(p, k, found)
    for value in between_roots(product, domains[k]):
        yield from _lifted(ring, levels, domains, {**found, k: value})


def _univariate(p: Poly, k: int, values: dict[int, Fraction]) -> Any:
    """With numbers for all other variables, without denominators."""
    coefficients: dict[int, Fraction] = {}
    for monomial, coefficient in p.to_dict().items():
        term = Fraction(int(coefficient))
        for j, e in enumerate(map(int, monomial)):
            if e and j != k:
                term *= values[j] ** e
        e = int(monomial[k])
        coefficients[e] = coefficients.get(e, Fraction(0)) + term
    common = math.lcm(*(c.denominator for c in coefficients.values()))
    return _flint.fmpz_poly([int(coefficients.get(e, 0) * common) for e in range(max(coefficients) + 1)])


def between_roots(p: Any, domain: Interval) -> list[Fraction]:
    """A number of small height in every part of an interval that the real roots of a polynomial leave."""
    low, high = domain
    cuts: list[tuple[Fraction, Fraction]] = []
    with _flint.ctx.workprec(_PRECISION):
        for root, _multiplicity in p.complex_roots() if p.degree() > 0 else ():
            if root.imag != 0:
                continue
            a, b = _rational(root.real.lower()), _rational(root.real.upper())
            if (low is not None and b <= low) or (high is not None and a >= high):
                continue
            if (low is not None and a < low) or (high is not None and b > high):
                end = low if low is not None and a < low else high
                assert end is not None
                if p(_flint.fmpq(end.numerator, end.denominator)) != 0:
                    raise TooLarge  # a root too close to the end of the interval to be told from it
                continue
            cuts.append((a, b))
    cuts.sort()
    found: list[Fraction] = []
    left = low
    for a, b in cuts:
        if left is not None and a <= left:
            if a < left:
                raise TooLarge
            left = b
            continue
        found.append(_simplest(left, a))
        left = b
    if left is None or high is None or left < high:
        found.append(_simplest(left, high))
    return found


def _rational(x: Any) -> Fraction:
    mantissa, exponent = x.man_exp()
    m, e = int(mantissa), int(exponent)
    return Fraction(m) * 2**e if e >= 0 else Fraction(m, 2**-e)


def _simplest(low: Fraction | None, high: Fraction | None) -> Fraction:
    """The fraction of least denominator between two numbers."""
    if low is None and high is None:
        return Fraction(0)
    if low is None:
        assert high is not None
        return -_simplest(-high, None)
    if high is None:
        return Fraction(math.floor(low) + 1)
    if low < 0 < high:
        return Fraction(0)
    if high <= 0:
        return -_simplest(-high, -low)
    whole = math.floor(low)
    if whole + 1 < high:
        return Fraction(whole + 1)
    if low == whole:
        # between n and n + h: n + 1/k with 1/k < h
        return whole + Fraction(1, math.floor(1 / (high - whole)) + 1)
    return whole + 1 / _simplest(1 / (high - whole), 1 / (low - whole))
