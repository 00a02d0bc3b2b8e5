"""The rows of one step: what may close in it, as gradients over the coordinates that can move.

A row is a list of (coordinate, entry of J), and its response (`responses`) a list of (coordinate, entry of the velocity
that a unit impulse along the row brings about), so that a contact impulse and the impulses in joints that it calls for
come together.
"""

# pyright: basic

from __future__ import annotations

from typing import NamedTuple

from freebody.numeric.kernels.arrays import Floats, Floats2, Ints, Ints2
from freebody.numeric.kernels.declaring import kernel, part

# kinds of row
NORMAL, FRICTION = 0, 1
# columns of `Rows.what`; a load is a row, or -1: none, or -2 - k: the held row k
KIND, IS_COUPLED, LOAD_A, LOAD_B, ORIGIN, SOURCE, COLUMN = range(7)
N_WHAT = 7
# where a row comes from: a candidate, a bound of the layout, a friction of the layout
OF_SITE, OF_BOUND, OF_FRICTION = range(3)
# columns of `Rows.number`: the impulse; the row of a normal is J v + bias >= 0; J M^-1 J^T, that without held rows, and
# that with the next row; limits of friction against a growing and a falling measure, by the load or as impulses; the
# rate at the start of the step; what the rate at its end is more than J v; the gap at the start; what closes the gap at
# the end; 1 for an impact; the impulse before a sweep, and the direction of the iteration
IMPULSE, BIAS, OWN, BARE, CROSS, FORWARD, BACK, BEFORE, OPEN, DRIFTING, SHIFT, NEED, IS_IMPACT, LAST, ALONG = range(15)
N_NUMBER = 15
NO_LIMIT = 1e12  # a coefficient of friction that always holds


class Fixtures(NamedTuple):
    """One-sided rows and friction of the layout: stops, strings, brakes."""

    bound: Ints2  # (n, 6): row, sign, tape of the target (-1: a number), rows of two spans (-1: none), has a rate
    bound_number: Floats2  # (n, 6): target, restitution, lows and highs of the spans
    bound_memory: Floats  # impulse of the last step
    friction: (
        Ints2  # (n, 6): row, loads a and b (bounds, or -2 - k: held rows, -1: none), tapes of static and kinetic limit
    )
    friction_number: Floats2  # (n, 4): coefficients, static and kinetic against a growing measure, then a falling one
    friction_memory: Floats
    tape_ptr: Ints
    tape: Ints2
    tape_number: Floats
    registers: Floats2
    row_of_bound: Ints  # in this step; -1: open


class ClosedRows(NamedTuple):
    """The closed rows of one step."""

    count: Ints  # rows, entries, entries of responses, steps of the iteration, closed bounds
    ptr: Ints
    coordinate: Ints
    entry: Floats
    response_ptr: Ints
    response_at: Ints
    response: Floats
    what: Ints2  # (capacity, N_WHAT)
    number: Floats2  # (capacity, N_NUMBER)
    local: Floats  # scratch of one row
    wide: Floats  # scratch of one response


@part
def begin_row(X, kind, origin, source, column, impulse):
    """A new row without entries; its number."""
    r = X.count[0]
    X.count[0] += 1
    X.what[r, KIND], X.what[r, IS_COUPLED], X.what[r, LOAD_A], X.what[r, LOAD_B] = kind, 0, -1, -1
    X.what[r, ORIGIN], X.what[r, SOURCE], X.what[r, COLUMN] = origin, source, column
    for j in range(N_NUMBER):
        X.number[r, j] = 0.0
    X.number[r, IMPULSE] = impulse
    X.ptr[r] = X.ptr[r + 1] = X.count[1]
    return r


@part
def add_entry(L, X, r, coordinate, value):
    if value != 0.0 and L.inverse_mass[coordinate] > 0.0:
        p = X.count[1]
        X.coordinate[p], X.entry[p] = coordinate, value
        X.count[1] += 1
        X.ptr[r + 1] = X.count[1]


@part
def add_local(L, X, r, a, b):
    for i in range(3):
        add_entry(L, X, r, 3 * a + i, X.local[i])
    for i in range(3):
        add_entry(L, X, r, 3 * b + i, X.local[3 + i])


@part
def rate_of(X, r, v):
    """J v of a row."""
    total = 0.0
    for p in range(X.ptr[r], X.ptr[r + 1]):
        total += X.entry[p] * v[X.coordinate[p]]
    return total


@part
def set_rates(X, r, drift, bias, v, h):
    """Rates at the ends of the step. J is that of the middle: the rate at the start is J v + drift - h/2 bias, that at
    the end J v+ + drift + h/2 bias, with the second derivative `bias` of the measure where nothing accelerates."""
    X.number[r, BEFORE] = rate_of(X, r, v) + drift - 0.5 * h * bias
    X.number[r, BIAS] = X.number[r, DRIFTING] = drift + 0.5 * h * bias


@part
def approach(rate, speed, gained, gap_at_middle, bias, restitution, h):
    """What a normal with the given rate at the start asks for: 0: nothing, its gap cannot close within the step; 1: to
    close no further than to zero; 2: to bounce; and the gap at the start. speed: what the rate could be if all
    velocities were against each other; gained: what loads can add to that. An approach that loads bring about within
    two steps is no impact: a body at rest would bounce forever."""
    gap = gap_at_middle - 0.5 * h * (rate + 0.25 * h * bias)
    if gap > h * (abs(rate) + speed + 2.0 * gained):
        return 0, gap
    if restitution > 0.0 and rate < -2.0 * gained:
        return (0 if gap_at_middle > 0.0 else 2), gap
    return 1, gap


@part
def set_normal(X, n, what, gap, restitution, h):
    """The demand of a normal: u+ >= -e u for an impact, else gap + h u+ >= 0."""
    X.number[n, OPEN] = gap
    if what == 2:
        X.number[n, BIAS] += restitution * X.number[n, BEFORE]
        X.number[n, IS_IMPACT] = 1.0
    else:
        X.number[n, BIAS] += max(gap, 0.0) / h


@kernel
def drop_row(X, n):
    """Takes back the last row."""
    X.count[0], X.count[1] = n, X.ptr[n]
