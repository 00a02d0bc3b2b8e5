"""Sines and cosines of parts of a turn: pi p/q with whole p, q.

Multiples of 15 degrees are exact. Of others those of the first quadrant are atoms (as roots, sin(pi/5) =
sqrt(10 - 2 sqrt(5))/4, their products are long). Of a cosine that is a sum of others which are there already, as
cos(2 pi/5) = cos(pi/5) - 1/2, the field keeps that sum, to put it in where an element is shorter with it. With
T_k the polynomials of Chebyshev, cos(k pi/q) = T_k(cos(pi/q)), and modulo the minimal polynomial of cos(pi/q), of the
degree phi(2 q)/2, all of them are vectors of fractions. So 1 + cos(2 pi/7) + ... + cos(12 pi/7) is 0, as it is for any
number of equal parts. Source: Watkins & Zeitlin, The minimal polynomial of cos(2 pi/n), Am. Math. Monthly 100, 1993.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import cache

from freebody.symbolic.field import Field
from freebody.symbolic.ratio import Ratio

Complex = tuple[Ratio, Ratio]
Vector = tuple[Fraction, ...]
MOST_PARTS = 24  # of half a turn; of more parts each angle is one of its own


def times(a: Complex, b: Complex) -> Complex:
    return a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]


def part_of_a_turn(field: Field, base: Ratio) -> Fraction | None:
    """base / pi, if that is a fraction."""
    pi = field.pi
    return (base / pi).fraction() if base.generators() == frozenset({field.index(pi)}) else None


def of_a_part(field: Field, share: Fraction, atom: Callable[[Fraction], Complex]) -> Complex:
    """Cosine and sine of share * pi. atom: the generators of a share of the first quadrant."""
    halves, rest = divmod(share, 1)
    turned = -1 if halves % 2 else 1  # by pi
    mirrored = rest > Fraction(1, 2)  # at a right angle, which keeps the denominator
    cosine, sine = _first_quadrant(field, 1 - rest if mirrored else rest, atom)
    return -turned * cosine if mirrored else turned * cosine, turned * sine


def _first_quadrant(field: Field, share: Fraction, atom: Callable[[Fraction], Complex]) -> Complex:
    if (12 * share).denominator == 1:
        return _fifteenths(field, int(12 * share))
    cosine, sine = atom(share)
    if share.denominator <= MOST_PARTS and cosine.generators():
        _note_sum(field, share, field.index(cosine))
    return cosine, sine


def _fifteenths(field: Field, n: int) -> Complex:
    """Cosine and sine of n pi/12, n <= 6."""
    half = field.one / 2
    root2, root3 = field.sqrt(field.element(2)), field.sqrt(field.element(3))
    table: dict[int, Complex] = {
        0: (field.one, field.zero),
        1: (root2 * (root3 + 1) / 4, root2 * (root3 - 1) / 4),
        2: (root3 / 2, half),
        3: (root2 / 2, root2 / 2),
        4: (half, root3 / 2),
        5: (root2 * (root3 - 1) / 4, root2 * (root3 + 1) / 4),
        6: (field.zero, field.one),
    }
    return table[n]


def _note_sum(field: Field, share: Fraction, cosine: int) -> None:
    """Keeps cos(pi p/q) as a sum of those with the same q that were there before, if it is one."""
    p, q = share.numerator, share.denominator
    known = field.equal_parts.setdefault(q, {})
    if p in known or cosine in field.sums_of_parts:
        return
    found = _combination([_vector(0, q), *(_vector(k, q) for k in known)], _vector(p, q))
    if found is None:
        known[p] = cosine
        return
    parts = [field.one, *map(field.variable, known.values())]
    field.sums_of_parts[cosine] = sum(
        (field.element(a) * part for a, part in zip(found, parts, strict=True)), field.zero
    )


@cache
def _vector(k: int, q: int) -> Vector:
    """2 cos(k pi/q) in powers of x = 2 cos(pi/q): t_k = x t_{k-1} - t_{k-2}, modulo the minimal polynomial."""
    least = _minimal(q)
    n = len(least) - 1

    def shifted(v: Sequence[Fraction]) -> Vector:
        return tuple(below - v[-1] * a for below, a in zip((Fraction(0), *v[:-1]), least[:-1], strict=True))

    one = (Fraction(1), *(Fraction(0),) * (n - 1))
    before, here = tuple(2 * a for a in one), shifted(one)
    for _ in range(k):
        before, here = here, tuple(a - b for a, b in zip(shifted(here), before, strict=True))
    return before


@cache
def _minimal(q: int) -> Vector:
    """The minimal polynomial of 2 cos(pi/q), the constant first: of degree phi(2 q)/2, with whole coefficients."""
    roots = [2 * math.cos(math.pi * k / q) for k in range(1, q) if math.gcd(k, 2 * q) == 1]
    found = [1.0]
    for root in roots:
        found = [below - root * here for below, here in zip((0.0, *found), (*found, 0.0), strict=True)]
    return tuple(Fraction(round(a)) for a in found)


def _combination(columns: Sequence[Vector], wanted: Vector) -> list[Fraction] | None:
    """Numbers a with sum of a columns = wanted, the columns independent; None where there are none."""
    rows = [[column[i] for column in columns] + [wanted[i]] for i in range(len(wanted))]
    n = len(columns)
    for at in range(n):
        pivot = next(i for i in range(at, len(rows)) if rows[i][at])
        rows[at], rows[pivot] = rows[pivot], rows[at]
        rows[at] = [a / rows[at][at] for a in rows[at]]
        for i, row in enumerate(rows):
            if i != at and row[at]:
                rows[i] = [a - row[at] * b for a, b in zip(row, rows[at], strict=True)]
    return None if any(row[n] for row in rows[n:]) else [row[n] for row in rows[:n]]
