"""Forces of contacts, friction and constraints at an instant.

A guess (the previous mode, then lasting contact) is tried first, then Lemke's pivots propose a mode, and where modes
are few all of them are tried, which finds out whether none or several are consistent. Whatever proposed a mode, its
forces are solved from the equations of that mode and checked against every condition.

A rub at rest starts to slip if it cannot stick with its static coefficient: the problem is solved with static
coefficients, those that slip get their kinetic ones for good, and so on until no more start.
Sources: Pfeiffer & Glocker 1996, ch. 6; Painleve's paradoxes: Champneys & Varkonyi, IMA J. Appl. Math. 81 (2016).
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

import numpy as np

from freebody.numeric.contact.cones import is_flat, pointed
from freebody.numeric.contact.coulomb import lemke_guess
from freebody.numeric.contact.modes import (
    ModeSolution,
    Rules,
    all_modes,
    checked,
    departures,
    is_pressed,
    n_modes,
    rub_states,
    solve_mode,
    worst_changed,
)
from freebody.numeric.contact.parts import Part, separate
from freebody.numeric.contact.problem import (
    SLIPPING,
    Choice,
    ContactProblem,
    ForceOutcome,
    Mode,
    OutcomeCount,
    RowState,
)
from freebody.numeric.contact.reduction import ReducedProblem, reduced
from freebody.numeric.contact.sieve import plausible
from freebody.numeric.contact.uniqueness import is_certainly_unique
from freebody.tolerances import ROUNDED

MOST_MODES = 4096
MOST_CHANGES = 100  # of a mode, one after another, where there are too many to try them all
_BARELY = 1e-10  # of the terms of a row, and
_OF_LARGEST = 1e-13  # of those of the largest: accelerations and slips that are none
_SAME = 1e-8  # accelerations that differ by less, relative to their terms, are one outcome


def contact_forces(
    problem: ContactProblem,
    previous: Mode | None = None,
    forbidden: Iterable[Choice] = (),
    *,
    check_others: bool = True,
    most_others: int = MOST_MODES,
) -> ForceOutcome:
    """The consistent forces of a contact problem; see `ForceOutcome` for shapes.

    `previous`: the mode to try first, and to keep if several are consistent. `forbidden`: states a row must not have,
    for instants where two are consistent to rounding; the conditions of such a row are met to 1e-8, all others to 1e-11
    of the terms of the row. Without `check_others`, or with more modes than `most_others`, the first consistent mode is
    taken, and not proven to be the only one. Never raises for lack of a solution: see `status`. Held rows that
    contradict each other have none. Parts of a problem that have nothing to do with each other are solved one by one.
    """
    forbidden = tuple(forbidden)
    if not is_flat(problem):
        return pointed(problem, forbidden)
    parts = separate(problem)
    if len(parts) < 2:
        return _together(problem, previous, forbidden, most_others if check_others else 0)
    outcomes: list[ForceOutcome] = []
    for part in parts:
        place = {row: k for k, row in enumerate(part.rows)}
        own = None if previous is None else tuple(previous[row] for row in part.rows)
        banned = tuple((place[row], state) for row, state in forbidden if row in place)
        outcomes.append(_together(part.problem, own, banned, most_others if check_others else 0))
    return _joined(problem, parts, outcomes)


def is_admissible(problem: ContactProblem, mode: Mode) -> bool:
    """Whether some forces meet every condition of a mode, unique or not."""
    rules = Rules()
    for part in separate(problem):
        system = reduced(part.problem)
        own = tuple(mode[part.rows[row]] for row in part.problem.free_rows)
        if not system.is_consistent or solve_mode(system, own, rules) is None:
            return False
    return True


def _joined(problem: ContactProblem, parts: list[Part], outcomes: list[ForceOutcome]) -> ForceOutcome:
    """The outcome of all parts together; an alternative of one part goes with the chosen modes of all others."""
    is_proven = all(o.is_proven for o in outcomes)
    for status in (OutcomeCount.NONE, OutcomeCount.NOT_FOUND):
        if any(o.status is status for o in outcomes):
            return _nothing(problem, status, is_proven=any(o.status is status and o.is_proven for o in outcomes))
    mode = [RowState.HELD] * problem.n
    forces, accelerations = np.zeros(problem.n), np.zeros(problem.n)
    for part, outcome in zip(parts, outcomes, strict=True):
        forces[list(part.rows)], accelerations[list(part.rows)] = outcome.forces, outcome.accelerations
        for row, state in zip(part.rows, outcome.mode, strict=True):
            mode[row] = state
    others: list[Mode] = []
    for part, outcome in zip(parts, outcomes, strict=True):
        for other in outcome.alternatives:
            changed = mode.copy()
            for row, state in zip(part.rows, other, strict=True):
                changed[row] = state
            others.append(tuple(changed))
    status = OutcomeCount.SEVERAL if any(o.status is OutcomeCount.SEVERAL for o in outcomes) else OutcomeCount.UNIQUE
    return ForceOutcome(status, tuple(mode), forces, accelerations, tuple(others), is_proven)


def _together(
    problem: ContactProblem, previous: Mode | None, forbidden: Iterable[Choice], most_others: int
) -> ForceOutcome:
    system = reduced(problem)
    if not system.is_consistent:
        return _nothing(problem, OutcomeCount.NONE, is_proven=True)
    rules = _starting_rules(system, forbidden)
    guess = tuple(previous[row] for row in problem.free_rows) if previous is not None else None
    first = _search_one(system, rules, guess)
    if first is not None and most_others and is_certainly_unique(system):
        return _outcome(system, [first], is_proven=True)
    if n_modes(system) > (MOST_MODES if first is None else most_others):
        return _outcome(system, [first] if first is not None else [], is_proven=False)
    found = _search_all(system, rules) or _without_breaking_away(system, rules)
    if first is not None:
        # one outcome has many names where a rub neither slips nor holds back: the one that lasts is kept
        alike = [k for k, other in enumerate(found) if _is_same(system, first, other)]
        for k in alike:
            found[k] = min(found[k], first, key=lambda s: departures(s.mode))
        if not alike:
            found.append(first)
    found.sort(key=lambda s: (s.mode != guess, departures(s.mode), _effort(system, s)))
    if first is not None and first.mode == guess and _is_same(system, first, found[0]):
        found[0] = first
    return _outcome(system, found, is_proven=not any(len(p) > 1 for f in system.frictions for p, _ in f.groups))


def _starting_rules(system: ReducedProblem, forbidden: Iterable[Choice]) -> Rules:
    """The caller's exclusions in reduced rows; a rub that can only slip one way has its kinetic coefficient at once."""
    place = {row: k for k, row in enumerate(system.problem.free_rows)}
    rules = Rules(frozenset((place[row], state) for row, state in forbidden))
    forced: list[Choice] = []
    for friction in system.frictions if rules.forbidden else ():
        states = [s for s in (RowState.STICKING, *SLIPPING) if rules.allows(friction.row, s)]
        if len(states) == 1 and states[0] in SLIPPING and not friction.rub.sliding:
            forced.append((friction.row, states[0]))
    return replace(rules, slipping=tuple(forced))


def _search_one(system: ReducedProblem, rules: Rules, guess: Mode | None) -> ModeSolution | None:
    """One consistent mode by guesses, then by Lemke; rubs that break away are solved again with kinetic friction."""
    while True:
        found = _first(system, rules, guess)
        if found is None:
            return None
        started = _breaking_away(system, rules, found)
        if not started:
            return found
        rules = replace(rules, slipping=rules.slipping + started)
        guess = found.mode


def _first(system: ReducedProblem, rules: Rules, guess: Mode | None) -> ModeSolution | None:
    for mode in (guess, lasting_mode(system, rules)):
        fitting = _fitted(system, rules, mode) if mode is not None else None
        found = solve_mode(system, fitting, rules) if fitting is not None else None
        if found is not None:
            return _lasting(system, rules, found)
    proposed = lemke_guess(system, rules)
    found = None
    if proposed is not None:
        x, mode = proposed
        found = solve_mode(system, mode, rules) or checked(system, mode, rules, x)
    if found is None and n_modes(system) > MOST_MODES:
        found = _walked(system, rules, guess)
    return _lasting(system, rules, found) if found is not None else None


def _walked(system: ReducedProblem, rules: Rules, guess: Mode | None) -> ModeSolution | None:
    """A consistent mode found by changing, one after another, the row that breaks its condition the most."""
    starts = (guess, lasting_mode(system, rules))
    for start in starts:
        mode = _fitted(system, rules, start) if start is not None else None
        seen: set[Mode] = set()
        while mode is not None and mode not in seen and len(seen) < MOST_CHANGES:
            seen.add(mode)
            found = solve_mode(system, mode, rules)
            if found is not None:
                return found
            changed = [m for m in worst_changed(system, mode, rules) if m not in seen]
            mode = _fitted(system, rules, changed[0]) if changed else None
    return None


def lasting_mode(system: ReducedProblem, rules: Rules) -> Mode:
    """Every contact closed and every rub at rest sticking, as far as the rules allow."""
    gaps = tuple(
        RowState.CLOSED if rules.allows(i, RowState.CLOSED) else RowState.OPEN for i in range(system.n_normals)
    )
    rest = (rub_states(friction, gaps, rules) for friction in system.frictions)
    return (*gaps, *(states[0] if states else RowState.ABSENT for states in rest))


def _fitted(system: ReducedProblem, rules: Rules, mode: Mode) -> Mode | None:
    """The guess with what is known by now: rubs that slide, that nothing presses, or that are held to a state."""
    gaps = mode[: system.n_normals]
    if any(not rules.allows(i, s) or s not in (RowState.OPEN, RowState.CLOSED) for i, s in enumerate(gaps)):
        return None
    states: list[RowState] = []
    for friction in system.frictions:
        possible = rub_states(friction, gaps, rules)
        if not possible:
            return None
        states.append(mode[friction.row] if mode[friction.row] in possible else possible[0])
    return (*gaps, *states)


def _lasting(system: ReducedProblem, rules: Rules, found: ModeSolution) -> ModeSolution:
    """The same outcome with contacts that neither press nor part called closed, and rubs that barely slip sticking."""
    sizes = system.magnitude @ abs(found.x) + system.size
    small = _BARELY * sizes + _OF_LARGEST * float(sizes.max(initial=0.0))
    mode = list(found.mode)
    for i in range(system.n_normals):
        if mode[i] is RowState.OPEN and found.a[i] <= small[i] and rules.allows(i, RowState.CLOSED):
            mode[i] = RowState.CLOSED
    for friction in system.frictions:
        i = friction.row
        rests = not friction.rub.sliding and abs(found.a[i]) <= small[i]
        if mode[i] in SLIPPING and rests and rules.allows(i, RowState.STICKING):
            mode[i] = RowState.STICKING
    fitting = _fitted(system, rules, tuple(mode)) if tuple(mode) != found.mode else None
    other = solve_mode(system, fitting, rules) if fitting is not None else None
    return other if other is not None and _is_same(system, other, found) else found


def _breaking_away(system: ReducedProblem, rules: Rules, found: ModeSolution) -> tuple[Choice, ...]:
    """Rubs at rest that slip with a static coefficient which is not the kinetic one."""
    return tuple(
        (f.row, found.mode[f.row])
        for f in system.frictions
        if found.mode[f.row] in SLIPPING
        and not f.rub.sliding
        and not rules.is_kinetic
        and (f.row, found.mode[f.row]) not in rules.slipping
        and f.rub.static != f.rub.kinetic
    )


def _search_all(system: ReducedProblem, rules: Rules) -> list[ModeSolution]:
    """Every outcome, by trying all modes; each set of rubs that break away is followed on its own."""
    found: list[ModeSolution] = []
    for solution in _consistent_modes(system, rules):
        started = _breaking_away(system, rules, solution)
        further = replace(rules, slipping=rules.slipping + started)
        more = _search_all(system, further) if started else [solution]
        found += [s for s in more if not any(_is_same(system, s, other) for other in found)]
    return found


def _consistent_modes(system: ReducedProblem, rules: Rules) -> list[ModeSolution]:
    found: list[ModeSolution] = []
    turns = (1.0, -1.0) if any(f.groups for f in system.frictions) else (1.0,)
    for mode in plausible(system, rules, all_modes(system, rules)):
        for turned in turns:
            solution = solve_mode(system, mode, rules, turned)
            if solution is not None and not any(_is_same(system, solution, other) for other in found):
                found.append(solution)
    return found


def _without_breaking_away(system: ReducedProblem, rules: Rules) -> list[ModeSolution]:
    """If that leads nowhere: modes that stick with static and slip with kinetic friction, those with fewest slips."""
    if all(f.rub.static == f.rub.kinetic or f.rub.sliding for f in system.frictions):
        return []
    found = _consistent_modes(system, replace(rules, is_kinetic=True))
    fewest = min((departures(s.mode)[1] for s in found), default=0)
    return [s for s in found if departures(s.mode)[1] == fewest]


def _effort(system: ReducedProblem, found: ModeSolution) -> float:
    """By which outcomes that are alike in all else are told apart in any order of rows: Gauss's constraint,
    lambda.A lambda, to eight digits."""
    effort, size = float(found.x @ system.A @ found.x), float(np.abs(found.x) @ system.magnitude @ np.abs(found.x))
    return round(effort / (size or 1.0), 8)


def _is_same(system: ReducedProblem, one: ModeSolution, other: ModeSolution) -> bool:
    """Whether all accelerations agree: A (x - x') = 0 also means that every body moves alike."""
    sizes = system.magnitude @ np.maximum(abs(one.x), abs(other.x)) + system.size
    return bool((abs(one.a - other.a) <= _SAME * sizes + ROUNDED * sizes.max(initial=0.0)).all())


def _outcome(system: ReducedProblem, found: list[ModeSolution], *, is_proven: bool) -> ForceOutcome:
    problem = system.problem
    if not found:
        has_magnitudes = any(f.groups for f in system.frictions)
        if is_proven and not has_magnitudes:
            return _nothing(problem, OutcomeCount.NONE, is_proven=True)
        return _nothing(problem, OutcomeCount.NOT_FOUND, is_proven=False)
    modes = [_full_mode(system, s.mode) for s in found]
    forces = system.forces(found[0].x)
    accelerations = np.zeros(problem.n)
    accelerations[system.rows] = found[0].a / system.scale
    accelerations[[state in (RowState.CLOSED, RowState.STICKING) for state in modes[0]]] = 0.0
    status = OutcomeCount.UNIQUE if len(found) == 1 else OutcomeCount.SEVERAL
    return ForceOutcome(status, modes[0], forces, accelerations, tuple(modes[1:]), is_proven)


def _full_mode(system: ReducedProblem, mode: Mode) -> Mode:
    full = [RowState.HELD] * system.problem.n
    for row, state in zip(system.problem.free_rows, mode, strict=True):
        full[row] = state
    for friction in system.frictions:
        if not is_pressed(friction, mode):
            full[friction.rub.row] = RowState.ABSENT
    return tuple(full)


def _nothing(problem: ContactProblem, status: OutcomeCount, *, is_proven: bool) -> ForceOutcome:
    mode = [RowState.HELD] * problem.n
    for row in problem.normals:
        mode[row] = RowState.OPEN
    for rub in problem.dry_friction:
        mode[rub.row] = RowState.ABSENT
    undefined = np.full(problem.n, np.nan)
    return ForceOutcome(status, tuple(mode), undefined, undefined.copy(), (), is_proven)
