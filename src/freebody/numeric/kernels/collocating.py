"""Linear differential equations x' = A(t) x + B(t) by the places of Gauss in panels (`tangent.collocation`)."""

# pyright: basic

from __future__ import annotations

import math

from freebody.numeric.kernels.arrays import Floats, Floats2, Ints
from freebody.numeric.kernels.declaring import entry, kernel
from freebody.numeric.kernels.dense import factor_dense, solve_dense

N_ITERATIONS = 40
SETTLED = 1e-15  # of the size of the slopes


@kernel
def write_given(F, at, f, s, x, before, given):
    """A x + B at the places of a panel, whose rows of F begin at `at`."""
    for i in range(s * f):
        for c in range(given.shape[1]):
            total = F[at + i, f + c]
            for g in range(f):
                total += F[at + i, g] * x[before + g, c]
            given[i, c] = total


@kernel
def write_system(F, at, f, h, a, system):
    """1 - h a A at the places of a panel."""
    s, n = len(a), len(system)
    for i in range(n):
        for j in range(n):
            system[i, j] = 1.0 if i == j else 0.0
    for i in range(s):
        for m in range(f):
            for j in range(s):
                for g in range(f):
                    system[i * f + m, j * f + g] -= h * a[i, j] * F[at + i * f + m, g]


@kernel
def iterate(F, at, f, h, a, given, moved, slopes):
    """slopes = given + h a A slopes by putting them in again and again, place after place. False where that settles too
    slowly."""
    s, k, before = len(a), slopes.shape[1], math.inf
    for _ in range(N_ITERATIONS):
        change, size = 0.0, 0.0
        for i in range(s):
            for g in range(f):
                for c in range(k):
                    moved[g, c] = 0.0
                for j in range(s):
                    for c in range(k):
                        moved[g, c] += h * a[i, j] * slopes[j * f + g, c]
            for m in range(f):
                row = i * f + m
                for c in range(k):
                    total = given[row, c]
                    for g in range(f):
                        total += F[at + row, g] * moved[g, c]
                    change = max(change, abs(total - slopes[row, c]))
                    size = max(size, abs(total))
                    slopes[row, c] = total
        if change <= SETTLED * size and size < math.inf:
            return True
        if not change < 2.0 * before:
            return False
        before = change
    return False


@kernel
def solve_panel(F, at, f, h, a, given, system, pivots, slopes):
    """The slopes at the places of a panel, (1 - h a A) slopes = given: by iteration where there is much that is free,
    else, and where that does not settle, by elimination. False where there are none."""
    k = slopes.shape[1]
    for i in range(len(slopes)):
        for c in range(k):
            slopes[i, c] = given[i, c]
    if f > 2 * k and iterate(F, at, f, h, a, given, system, slopes):
        return True
    for i in range(len(slopes)):
        for c in range(k):
            slopes[i, c] = given[i, c]
    write_system(F, at, f, h, a, system)
    if not factor_dense(system, 0, len(system), 1.0, pivots):
        return False
    solve_dense(system, 0, len(system), pivots, slopes, k)
    return True


@kernel
def end_panel(F, at, f, h, x, before, b, last, slopes, off, panel):
    """x at the end of a panel, and how far the slope continued to there is from the one of the equation."""
    s = len(b)
    for m in range(f):
        for c in range(slopes.shape[1]):
            total = 0.0
            for i in range(s):
                total += b[i] * slopes[i * f + m, c]
            x[before + f + m, c] = x[before + m, c] + h * total
    for m in range(f):
        for c in range(slopes.shape[1]):
            gap = -F[at + s * f + m, f + c]
            for g in range(f):
                gap -= F[at + s * f + m, g] * x[before + f + g, c]
            for i in range(s):
                gap += last[i] * slopes[i * f + m, c]
            off[panel, c] = max(off[panel, c], h * abs(gap))


@entry
def collocated(
    ends: Floats,
    F: Floats2,
    a: Floats2,
    b: Floats,
    last: Floats,
    system: Floats2,
    pivots: Ints,
    given: Floats2,
    slopes: Floats2,
    x: Floats2,
    off: Floats2,
) -> bool:
    """x at the ends of all panels, f rows each, from its first rows; off (n_panels, k): see `end_panel`. F: rows (A, B)
    at all instants, the ends and the places between them. system, given, slopes: room. False where a panel has no
    solution."""
    s = len(b)
    f = len(system) // s
    for panel in range(len(ends) - 1):
        h, at, before = ends[panel + 1] - ends[panel], (panel * (s + 1) + 1) * f, panel * f
        write_given(F, at, f, s, x, before, given)
        if not solve_panel(F, at, f, h, a, given, system, pivots, slopes):
            return False
        end_panel(F, at, f, h, x, before, b, last, slopes, off, panel)
    return True
