"""Linear differential equations x' = A(t) x + B(t) by the places of Gauss in panels (`tangent.collocation`)."""

# pyright: basic

from __future__ import annotations

from freebody.numeric.kernels.arrays import Floats, Floats2, Ints
from freebody.numeric.kernels.declaring import entry, kernel
from freebody.numeric.kernels.dense import factor_dense, solve_dense


@kernel
def write_system(F, at, f, h, x, before, a, system, slopes):
    """(1 - h a A) slopes = A x + B at the places of a panel, whose rows of F begin at `at`."""
    s, n = len(a), len(system)
    for i in range(n):
        for j in range(n):
            system[i, j] = 1.0 if i == j else 0.0
    for i in range(s):
        for m in range(f):
            row = at + i * f + m
            for j in range(s):
                for g in range(f):
                    system[i * f + m, j * f + g] -= h * a[i, j] * F[row, g]
            for c in range(slopes.shape[1]):
                total = F[row, f + c]
                for g in range(f):
                    total += F[row, g] * x[before + g, c]
                slopes[i * f + m, c] = total


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
    slopes: Floats2,
    x: Floats2,
    off: Floats2,
) -> bool:
    """x at the ends of all panels, f rows each, from its first rows; off (n_panels, k): see `end_panel`. F: rows (A, B)
    at all instants, the ends and the places between them. system, slopes: room. False where a panel has no solution."""
    s = len(b)
    f = len(system) // s
    for panel in range(len(ends) - 1):
        h, at, before = ends[panel + 1] - ends[panel], (panel * (s + 1) + 1) * f, panel * f
        write_system(F, at, f, h, x, before, a, system, slopes)
        if not factor_dense(system, 0, len(system), 1.0, pivots):
            return False
        solve_dense(system, 0, len(system), pivots, slopes, slopes.shape[1])
        end_panel(F, at, f, h, x, before, b, last, slopes, off, panel)
    return True
