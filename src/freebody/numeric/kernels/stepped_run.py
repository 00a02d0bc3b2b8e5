"""What a motion by explicit steps has under way: its clock, its counts, its states, and the tableau of the method."""

# pyright: basic

from __future__ import annotations

from typing import NamedTuple

from freebody.numeric.kernels.arrays import Floats, Floats2, Ints

N_CLOCK = 16
(
    NOW,
    STEP,
    END,
    TOLERANCE,
    SPEED,
    LONGEST,
    PLACE_GAP,
    MOTION_GAP,
    BEFORE,
    DONE_STEP,
    BEST_PIVOT,
    LOWEST_PIVOT,
    ALLOWED,
    MOVED,
) = range(14)
N_COUNT = 13
(
    STEPS,
    EVALUATIONS,
    REJECTED,
    OUTPUTS,
    REGULARISED,
    IS_WATCHED,
    STIFF,
    NOT_STIFF,
    DENSE_READY,
    TROUBLE,
    IS_CAREFUL,
    LEFT_OUT,
    KEPT,
) = range(13)
# what `advance` returns
REACHED, PAUSED, LOOK, TOO_SMALL, STIFF_FOUND = 0, 1, 2, 3, 4
STIFF_STEPS = 15  # so many whose size stability bounds are taken for stiffness
# what was in the way of the last step (`TROUBLE`)
NOTHING, ERROR_LARGE, NOT_FINITE, NOT_HELD = 0, 1, 2, 3
Y, OLD, NEW, STAGE, HELD, FIRST = range(6)  # rows of `Run.states`
EPSILON = 2.220446049250313e-16


class Tableau(NamedTuple):
    """An explicit Runge-Kutta method in arrays (`engine.tableaus`)."""

    a: Floats2  # (n + extra + 1, n + extra + 1)
    c: Floats
    b: Floats
    error: Floats2  # (2, n + 1): the second row is zero if there is one embedded formula only
    dense: Floats2  # (n_terms, n + extra + 1)
    sizes: Ints  # number of stages, extra stages, order, is adaptive, error needs the slope at the new point


class SteppedRun(NamedTuple):
    """A motion under way."""

    clock: Floats
    count: Ints
    states: (
        Floats2  # (6, n_y): the state, that before the last step, the new one, a stage, that as it is held, the start
    )
    slopes: Floats2  # (stages, len(y)); the first is that of y
    dense: Floats2  # (terms, len(y)) of the last step
    unit: Floats  # size of every entry of q: a length or a radian
    multiplier: Floats  # at y
    out_t: Floats
    out_y: Floats2
    out_a: Floats2
    out_multiplier: Floats2
    # steps that are kept until they are looked at together, a row each (a row for each term of `dense`)
    kept_old: Floats2
    kept_dense: Floats2
    kept_clock: Floats2
    kept_near: Floats2
