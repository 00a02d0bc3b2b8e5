"""Reactions that are not unique: the least and the largest value of each at an instant of a motion.

The accelerations of the motion are given; `ranges` solves two linear programs a row over all forces that produce them.
"""

from __future__ import annotations

import numpy as np

from freebody.numeric.contact.bounded import Bounded
from freebody.numeric.contact.problem import RowState
from freebody.numeric.contact.ranges import Feasible, force_ranges
from freebody.numeric.contact.record import ABSENT
from freebody.numeric.engine.course import Trajectory
from freebody.tolerances import ROUNDED

_STATE_OF_SLIP = {0: RowState.STICKING, 1: RowState.FORWARD, -1: RowState.BACKWARD}


def admissible_reactions(bounded: Bounded, course: Trajectory, k: int) -> dict[str, tuple[float, float]]:
    """By the name of its row the least and the largest reaction at output k, positive as it is named, of every row that
    is held or rubs there: infinite where nothing bounds it, the same twice where it is unique. {} if none exist."""
    assert course.contact is not None
    engine = bounded.free
    y = engine.state_at(course, k)
    after = {blow.name for blow in course.contact.blows if blow.time > course.times[k]}
    bounded.hold_past(course.contact.past - after)
    now = bounded.instant(y, float(course.times[k]), course.near)
    # the contact problem at this instant, in the mode of the motion
    closed = [int(i) for i in np.flatnonzero(course.contact.states[k])]
    slips = {int(i): int(s) for i, s in enumerate(course.contact.slips[k]) if s != ABSENT}
    problem = bounded.problem(now, closed, slips, of_rates=False)
    matrices = problem.matrices
    if not matrices.n:
        return {}
    mode = [RowState.HELD] * matrices.n
    for i in closed:
        mode[problem.row_of_barrier(i)] = RowState.CLOSED
    for i, slip in slips.items():
        mode[problem.row_of_drag(i)] = _STATE_OF_SLIP[slip]
    # the accelerations (n_rows,) of its rows, as the motion has them, positive where a gap opens
    held = [*bounded.always, *(grip for i in closed for grip in bounded.barriers[i].grips)]
    places = [*held, *(bounded.barriers[i].place for i in closed), *(bounded.drags[i].keeps for i in slips)]
    signs = np.ones(len(places))
    signs[len(held) : len(held) + len(closed)] = [bounded.barriers[i].sign for i in closed]
    gradients = now.gradients[places]
    accelerations = signs * (gradients @ engine.accelerations(course)[k] + now.biases[places])
    found = force_ranges(matrices, accelerations, tuple(mode))
    if found.feasible is not Feasible.YES:
        return {}
    # by the names of the rows, positive as each is named; what round-off leaves of zero is zero
    both = np.append(found.low, found.high)
    size = float(np.abs(both[np.isfinite(both)]).max(initial=0.0))
    named: dict[str, tuple[float, float]] = {}
    for row, place in enumerate(places):
        sign = bounded.rows[place].sign * signs[row]
        ends = sorted(0.0 if abs(x) < ROUNDED * size else float(sign * x) for x in (found.low[row], found.high[row]))
        named[bounded.rows[place].name] = ends[0], ends[1]
    return named
