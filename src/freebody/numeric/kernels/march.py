"""What a motion by time stepping has under way: its clock, its counts, its poses and velocities."""

# pyright: basic

from __future__ import annotations

from typing import NamedTuple

from freebody.numeric.kernels.arrays import Floats, Floats2, Ints

# what `advance` returns
DONE, REBUILD, FULL, NOT_FINITE, NOT_HELD = range(5)
# `March.clock`: time, length of a step, what is asked of the iteration (by the speeds), the most a gap may be negative;
# how far something may move before candidates are made anew; results
(
    NOW,
    STEP,
    TOLERANCE,
    SLOP,
    SKIN,
    RESIDUAL,
    WORST_RESIDUAL,
    DEEPEST,
    WORK,
    LOSS,
    PLACE_GAP,
    ACCELERATION,
    FASTEST,
    WORST_SHARE,
) = range(14)
N_CLOCK = 14
# `March.count`
STEPS, SWEEPS, MOST_SWEEPS, CAPPED, SOFTENED, MOST_CLOSED, REBUILDS, LAST_SWEEPS = range(8)
N_COUNT = 8


class March(NamedTuple):
    """A motion under way."""

    clock: Floats
    count: Ints
    q: Floats2  # (n_bodies + 1, 3)
    v: Floats2
    middle: Floats2  # pose at the middle of the step
    free: Floats2  # velocities without contact
    bare: Floats2  # velocities without contact and without held rows
    new: Floats2
    held_impulse: Floats
    is_jointed: Ints  # for every body: it has held rows
    is_whole: Ints  # for every body: it moves by h v+, not by the mean of v and v+
    circle_body: Ints
    circle: Floats2  # centres of circles about outlines, on their bodies
    circle_built: Floats2  # where they were when candidates were made
