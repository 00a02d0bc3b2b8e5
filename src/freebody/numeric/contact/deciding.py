"""What stays closed and what sticks: the contact problem in accelerations, of barriers at gap zero and rate zero and of
friction at rest."""

from __future__ import annotations

from freebody.language.sentences import Message, in_turn
from freebody.numeric.contact.after import HELD_ALONE, After, Choice
from freebody.numeric.contact.bounded import Bounded
from freebody.numeric.contact.cones import is_flat
from freebody.numeric.contact.forces import contact_forces, is_admissible
from freebody.numeric.contact.problem import MOST_OTHERS, ForceOutcome, RowState
from freebody.numeric.contact.rows import ContactInstant, ModeOf, RowProblem
from freebody.numeric.contact.stillness import STILL, MotionSpeeds
from freebody.numeric.kernels.arrays import Floats


def decide(
    still_at: MotionSpeeds,
    result: After,
    now: ContactInstant,
    touching: list[int],
    mode: ModeOf | None,
    forbidden: tuple[Choice, ...],
) -> ForceOutcome:
    """The mode of the barriers at gap zero and rate zero, and of friction, put into the result. mode: the one before;
    forbidden: states that the motion has shown to be impossible."""
    b = still_at.bounded
    speed = still_at.speed(result.y, now)
    closed = [
        k for k in touching if abs(b.ends.opening(k, now)) <= STILL * speed and ("closed", k, None) not in forbidden
    ]
    while True:
        drags = still_at.drags_on(now, closed, speed)
        problem = b.problem(now, closed, drags, of_rates=False)
        previous = _previous(problem, mode)
        banned = _banned(problem, forbidden)
        outcome = contact_forces(problem.matrices, previous, banned, most_others=MOST_OTHERS)
        if not outcome.is_found and banned:
            outcome = contact_forces(problem.matrices, previous, most_others=MOST_OTHERS)
        if not outcome.is_found:
            result.status = outcome.status
            names = [b.barriers[k].name for k in closed]
            names += [b.drags[k].name for k in drags if b.drags[k].of not in closed]
            result.why = Message("contact and friction at {names}", names=in_turn(names)) if names else HELD_ALONE
            return outcome
        still = [k for k in closed if outcome.mode[problem.row_of_barrier(k)] is RowState.CLOSED]
        if len(still) < len(closed) and any(b.barriers[k].grips for k in closed if k not in still):
            closed = still  # an ideal contact that opens does not grip either
            continue
        break
    states: list[int | None] = [None] * len(b.drags)
    directions, ways = dict(outcome.directions), dict(problem.ways)
    for k in drags:
        state = outcome.mode[problem.row_of_drag(k)]
        is_on = b.drags[k].of < 0 or b.drags[k].of in still
        known = {RowState.STICKING: 0, RowState.FORWARD: 1, RowState.BACKWARD: -1}
        states[k] = known.get(state) if is_on else None
        if is_on and states[k] is None and b.drags[k].of < 0:
            states[k] = drags[k] or 1  # nothing presses it: it slides without force
        if states[k] and k in problem.across:
            ways[k] = directions[problem.row_of_drag(k)]
    chosen = tuple((k, ways[k]) for k in drags if states[k] and k in ways)
    result.mode = ModeOf(frozenset(still), tuple(states), ways=chosen, pivots=b.ends.settings(still))
    return outcome


def lasts(bounded: Bounded, y: Floats, t: float, near: Floats, mode: ModeOf) -> bool:
    """Whether a mode can go on in a state: some distribution of its forces, unique or not, is admissible."""
    now = bounded.instant(y, t, near)
    drags = {k: state for k, state in enumerate(mode.drags) if state is not None}
    problem = bounded.problem(now, sorted(mode.closed), drags, of_rates=False)
    if not is_flat(problem.matrices):
        return _is_kept(problem)
    states = _previous(problem, mode)
    return states is not None and is_admissible(problem.matrices, states)


def _is_kept(problem: RowProblem) -> bool:
    """Whether there are forces with which all that is closed stays so, and all that sticks in planes."""
    found = contact_forces(problem.matrices, check_others=False)
    normals = (found.mode[problem.row_of_barrier(k)] for k in problem.closed)
    at_rest = (found.mode[problem.row_of_drag(k)] for k in problem.across)
    return found.is_found and RowState.OPEN not in normals and RowState.FORWARD not in at_rest


def _previous(problem: RowProblem, mode: ModeOf | None) -> tuple[RowState, ...] | None:
    if mode is None:
        return None
    states = [RowState.HELD] * problem.matrices.n
    for k in problem.closed:
        states[problem.row_of_barrier(k)] = RowState.CLOSED if k in mode.closed else RowState.OPEN
    known = {0: RowState.STICKING, 1: RowState.FORWARD, -1: RowState.BACKWARD, None: RowState.ABSENT}
    for k in problem.drags:
        states[problem.row_of_drag(k)] = known[mode.drags[k]]
        if k in problem.across:
            states[problem.across[k]] = known[0 if mode.drags[k] is not None else None]
    return tuple(states)


def _banned(problem: RowProblem, forbidden: tuple[Choice, ...]) -> list[tuple[int, RowState]]:
    known = {0: RowState.STICKING, 1: RowState.FORWARD, -1: RowState.BACKWARD}
    found: list[tuple[int, RowState]] = []
    for what, k, state in forbidden:
        if what == "drag" and k in problem.drags and state is not None:
            found.append((problem.row_of_drag(k), known[state]))
        elif what == "open" and k in problem.closed:
            found.append((problem.row_of_barrier(k), RowState.OPEN))
    return found
