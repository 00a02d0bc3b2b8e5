"""Elements of the field as polynomials over a box, whose zeros are the only places where the elements change sign.

    positive parameter                  v in (0, oo); what only scales everything is set to 1
    cosine and sine of one angle        (1 - t^2)/(1 + t^2) and 2 t/(1 + t^2), t real; t in (0, 1) where it is acute
    of n times this angle               the parts of (1 + i t)^(2 n)/(1 + t^2)^n
    root g of R                         the norm: a + b g vanishes only where a^2 - b^2 R does, and ends where R does
    pi, cos(pi/7) and other constants   a variable in a short interval around the number
    asin u, exp u and other atoms       a variable of its own in the range of the function

The last two say less than there is to know, so what is found to hold holds.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cached_property
from typing import Any

import flint

from freebody.errors import FormulaTooLong
from freebody.language.expression import ELLIPTIC, LAMBERT
from freebody.symbolic.decide.cells import Interval, Poly, Polynomials, TooLarge, points
from freebody.symbolic.field import Field
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import is_positive

_flint: Any = flint
_MOST_VARIABLES = 7
_MOST_MULTIPLE = 4
_MOST_DEGREE = 24  # of a trigonometric polynomial in the tangent of half the angle
_DIGITS = 10**12
_POSITIVE: Interval = (Fraction(0), None)
_REAL: Interval = (None, None)
_HALF_PI = Fraction(1570796326795, 10**12)  # a little more than pi/2
_RANGES: dict[str, Interval] = {
    "exp": _POSITIVE,
    "cosh": (Fraction(1), None),
    "asin": (-_HALF_PI, _HALF_PI),
    "atan": (-_HALF_PI, _HALF_PI),
    "acos": (Fraction(0), 2 * _HALF_PI),
    "lambert_W0": (Fraction(-1), None),
    "lambert_Wm1": (None, Fraction(-1)),
}


class BallFunctions:
    """The elementary functions on balls, by the names that generators use."""

    @staticmethod
    def number(value: Fraction) -> Any:
        return _ball(value)

    def __getattr__(self, name: str) -> Any:
        if name == "pi":
            return _flint.arb.pi()

        def function(first: Any, *others: Any) -> Any:
            if name in LAMBERT:
                return _flint.arb(first).lambertw(branch=-LAMBERT.index(name))
            if name in ELLIPTIC:
                return _elliptic(first, *others)
            return getattr(_flint.arb, name)(_flint.arb(first), *map(_flint.arb, others))

        return function


def _elliptic(*arguments: Any) -> Any:
    """K(k), or F(phi, k), on balls; flint has them of m = k^2, as complex functions."""
    *angle, modulus = map(_flint.arb, arguments)
    parameter = _flint.acb(modulus * modulus)
    value = _flint.acb.elliptic_f(_flint.acb(angle[0]), parameter) if angle else parameter.elliptic_k()
    return value.real


class CellDecomposition:
    """Some elements together: variables, a box for them, and the polynomials that cut it into cells."""

    def __init__(self, field: Field, elements: Sequence[Ratio]) -> None:
        self.field = field
        self.roots: set[int] = set()
        self.circles: set[int] = set()  # generators of cosines
        self.multiples: dict[int, tuple[int, int]] = {}  # of other angles than these: cosine of which, how many times
        self.free: dict[int, Interval] = {}
        self._seen: set[int] = set()
        plain: list[Ratio] = []
        try:
            for x in elements:
                plain += self._norms(x)
        except FormulaTooLong as error:
            raise TooLarge from error
        self._plain = plain
        self._relate()
        self._slots = {g: k for k, g in enumerate((*sorted(self.circles), *sorted(self.free)))}
        if len(self._slots) > _MOST_VARIABLES:
            raise TooLarge

    # -- what there is ------------------------------------------------------------------------
    def _norms(self, x: Ratio) -> list[Ratio]:
        """Polynomials without roots that vanish wherever the element or its divisor does, or a radicand in it."""
        found: list[Ratio] = []
        for poly in (x.num, x.den):
            if poly is None:
                continue
            part = Ratio(self.field, self.field.current(poly), None)
            self._visit(part)
            while roots := [g for g in part.generators() if g in self.roots]:
                g = max(roots)
                a, b = (*part.coefficients(g), self.field.zero)[:2]
                part = (a * a - b * b * self.field.radicand(g)).numerator()
            found.append(part)
        return found + self._radicands(x)

    def _radicands(self, x: Ratio) -> list[Ratio]:
        found: list[Ratio] = []
        for g in x.generators():
            if g in self.roots:
                found += self._norms(self.field.radicand(g))
        return found

    def _visit(self, x: Ratio) -> None:
        f = self.field
        for g in x.generators() - self._seen:
            generator = f.generators[g]
            self._seen.add(g)
            if generator.kind == "root":
                self.roots.add(g)
                self._visit(f.radicand(g))
            elif generator.kind in ("cos", "sin"):
                cos = g if generator.kind == "cos" else g - 1
                self.circles.add(cos)
                self._seen |= {cos, cos + 1}
            else:
                self.free[g] = self._range(g)

    def _relate(self) -> None:
        """Angles that are whole multiples of others are told by these."""
        angles = self.field.angles
        for cos in sorted(self.circles):
            for base in sorted(self.circles - {cos}):
                ratio = (angles[cos] / angles[base]).fraction()
                if ratio is not None and ratio.denominator == 1 and 1 < ratio <= _MOST_MULTIPLE:
                    self.circles.discard(cos)
                    self.multiples[cos] = base, int(ratio)
                    break
        for cos, (base, n) in self.multiples.items():
            while base in self.multiples:
                base, m = self.multiples[base]
                n *= m
            self.multiples[cos] = base, n

    def _powers(self, powers: Mapping[int, int]) -> Iterator[tuple[int, int, int, int]]:
        """Of the circles in a monomial: which, how many times its angle, the powers of cosine and sine."""
        for cos, (base, n) in [*((c, (c, 1)) for c in self.circles), *self.multiples.items()]:
            i, j = powers.get(cos, 0), powers.get(cos + 1, 0)
            if i or j:
                yield base, n, i, j

    def _range(self, g: int) -> Interval:
        f = self.field
        if self._is_number(g):
            return _around(self._number(g))
        if g in f.arguments:
            return _RANGES.get(f.arguments[g][0], _REAL)
        if f.acute(g):
            return Fraction(0), _HALF_PI
        return _POSITIVE if is_positive(f, g) or g in f.nonnegative else _REAL

    def _is_number(self, g: int) -> bool:
        return is_made(self.field, g) and all(self._is_number(k) for k in self.field.generators[g].made_of - {g})

    def _number(self, g: int) -> Any:
        values = {k: self._number(k) for k in sorted(self.field.generators[g].made_of - {g})}
        compute = self.field.generators[g].compute
        assert compute is not None
        return _flint.arb(compute(self.field.complete(values, BallFunctions()), BallFunctions()))

    # -- the polynomials ----------------------------------------------------------------------
    @cached_property
    def _scaled(self) -> dict[int, Fraction]:
        """Positive variables that may be set to 1: scaling all by some weights only multiplies the polynomials."""
        free = sorted(self.free)
        rows: list[list[Fraction]] = []
        for x in self._plain:
            exponents = [tuple(dict(m).get(g, 0) for g in free) for m in self.field.terms(x.num)]
            rows += [[Fraction(a - b) for a, b in zip(e, exponents[0], strict=True)] for e in exponents[1:]]
        return {free[k]: Fraction(1) for k in _scalable(rows, [self._may_scale(g) for g in free])}

    def _may_scale(self, g: int) -> bool | None:
        """True where it can be set to 1, False where only its size may change, None where nothing may."""
        if self.free[g] == _POSITIVE:
            return True
        return False if self.free[g] == _REAL else None

    @cached_property
    def _ring(self) -> Polynomials:
        return Polynomials(len(self._slots))

    def _poly(self, x: Ratio) -> Poly:
        """In the variables of the ring: half-angle tangents put in, times powers of 1 + t^2."""
        ring, f = self._ring, self.field
        degrees = dict.fromkeys(self.circles, 0)
        terms = f.terms(x.num)
        for m in terms:
            own = dict.fromkeys(self.circles, 0)
            for cos, n, i, j in self._powers(dict(m)):
                own[cos] += n * (i + j)
            degrees = {cos: max(degrees[cos], own[cos]) for cos in degrees}
        if any(2 * d > _MOST_DEGREE for d in degrees.values()):
            raise TooLarge
        parts: list[Poly] = []
        for m, coefficient in terms.items():
            powers, term = dict(m), ring.constant(coefficient)
            left = dict(degrees)
            for cos, n, i, j in self._powers(powers):
                real, imaginary = _turned(ring.variables[self._slots[cos]], ring.constant(1), ring.constant(0), n)
                term = term * real**i * imaginary**j
                left[cos] -= n * (i + j)
            for cos, degree in left.items():
                term = term * (1 + ring.variables[self._slots[cos]] ** 2) ** degree
            for g, e in powers.items():
                if g in self.free and g not in self._scaled:
                    term = term * ring.variables[self._slots[g]] ** e
            parts.append(term)
        return _summed(parts, ring.constant(0))

    def _domains(self) -> list[Interval]:
        found: list[Interval] = []
        for g in self._slots:
            if g in self.circles:
                found.append(self._tangent_range(g))
            else:
                found.append(_POSITIVE if g in self._scaled else self.free[g])
        return found

    @property
    def is_without_gaps(self) -> bool:
        """False where the box leaves out something: half a turn, of which the tangent is infinite, or a parameter that
        is zero."""
        whole = all(self._is_number(c) or self.field.generators[c].positive for c in self.circles)
        return whole and not self.field.nonnegative & self.free.keys()

    def _tangent_range(self, cos: int) -> Interval:
        """Of the tangent of half the angle."""
        if self._is_number(cos):
            c, s = self._number(cos), self._number(cos + 1)
            return _around(s / (1 + c))
        return (Fraction(0), Fraction(1)) if self.field.generators[cos].positive else _REAL

    def values(self) -> Iterator[dict[int, Any]]:
        """Values of all generators, as balls, at one point of every cell; roots that are not real are left out.
        Raises TooLarge."""
        polys = [self._poly(x) for x in self._plain]
        for point in points(self._ring, polys, self._domains()):
            found: dict[int, Any] = {}
            for g, k in self._slots.items():
                value = _ball(self._scaled.get(g, point[k]))
                if g in self.circles:
                    found[g] = (1 - value * value) / (1 + value * value)
                    found[g + 1] = 2 * value / (1 + value * value)
                else:
                    found[g] = value
            for cos, (base, n) in self.multiples.items():
                t = _ball(self._scaled.get(base, point[self._slots[base]]))
                real, imaginary = _turned(t, _ball(Fraction(1)), _ball(Fraction(0)), n)
                found[cos], found[cos + 1] = real / (1 + t * t) ** n, imaginary / (1 + t * t) ** n
            self._add_roots(found)
            yield found

    def _add_roots(self, values: dict[int, Any]) -> None:
        for g in sorted(self.roots):
            try:
                inside = self.field.evaluate(self.field.radicand(g), values)
            except KeyError:
                continue
            if _flint.arb(inside) > 0:
                values[g] = _flint.arb(inside).sqrt()


def _turned(t: Any, one: Any, zero: Any, n: int) -> tuple[Any, Any]:
    """Real and imaginary part of (1 + i t)^(2 n)."""
    real, imaginary = one, zero
    for _ in range(2 * n):
        real, imaginary = real - imaginary * t, imaginary + real * t
    return real, imaginary


def is_made(field: Field, g: int) -> bool:
    """True for what has no value of its own: pi, a cosine, a root, a function of other generators."""
    generator = field.generators[g]
    return generator.compute is not None and generator.kind in ("parameter", "cos", "sin", "root", "function")


def sign_at(x: Ratio, values: Mapping[int, Any]) -> int | None:
    """The sign of an element in numbers; None where it is not real. Raises TooLarge where the balls are too wide."""
    try:
        value = _flint.arb(x.field.evaluate(x, values))
    except KeyError:
        return None
    if value > 0:
        return 1
    if value < 0:
        return -1
    raise TooLarge


def _ball(value: Fraction) -> Any:
    return _flint.arb(_flint.fmpq(value.numerator, value.denominator))


def _around(ball: Any) -> Interval:
    if not ball.is_finite():  # what has no real value, as log(-1)
        raise TooLarge
    low, high = (int(end.floor().unique_fmpz()) for end in ((ball * _DIGITS).lower(), (ball * _DIGITS).upper()))
    return Fraction(low - 1, _DIGITS), Fraction(high + 2, _DIGITS)


def _scalable(rows: list[list[Fraction]], may: list[bool | None]) -> list[int]:
    """Columns that can be set to 1: a weight w with R w = 0 for each, w_k = 1 there and 0 at the others chosen.

    The columns that elimination leaves without a pivot are free; columns where nothing may change count as rows of
    their own, and those that may not be set to 1 get their pivots first."""
    n = len(may)
    rows = [*rows, *([Fraction(int(j == k)) for j in range(n)] for k in range(n) if may[k] is None)]
    order = sorted(range(n), key=lambda k: may[k] is True)
    distinct = dict.fromkeys(tuple(row[k] for k in order) for row in rows)
    if not distinct:
        return [k for k in range(n) if may[k] is True]
    entries = [_flint.fmpq(x.numerator, x.denominator) for row in distinct for x in row]
    reduced, rank = _flint.fmpq_mat(len(distinct), n, entries).rref()
    pivots = {order[next(j for j in range(n) if reduced[i, j] != 0)] for i in range(rank)}
    return [k for k in range(n) if k not in pivots and may[k] is True]


def _summed(parts: list[Poly], zero: Poly) -> Poly:
    """Two and two, since a long sum is copied with each term that is added to it."""
    while len(parts) > 1:
        left = parts[-1:] if len(parts) % 2 else []
        parts = [a + b for a, b in zip(parts[::2], parts[1::2], strict=False)] + left
    return parts[0] if parts else zero
