"""Which modes may follow on a state of the contacts, and what makes one of them consistent there.

At an instant every closed bound and every friction without slip is up for decision. A mode is consistent if

    closed   N >= 0                        open at gap 0    gap'' > 0 (gap' > 0)
    sticks   -mu_s N <= T <= mu_s N        slides           s slip' > 0, or slip' = 0 and s slip'' > 0

Source of the cases: Pfeiffer & Glocker, Multibody Dynamics with Unilateral Contacts, 1996, ch. 5.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping
from contextlib import suppress

import numpy as np

from freebody.budgets import allowed
from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.study.phases.decide import Inequality
from freebody.study.phases.home import Home
from freebody.study.phases.in_plane import ways_of_onset
from freebody.study.phases.nodes import PhaseStart
from freebody.study.phases.numbers import Chosen
from freebody.study.phases.phase import Phase, PhaseWatch
from freebody.study.phases.together import slipping_together
from freebody.study.phases.words import at_border
from freebody.symbolic.conditions import closed as while_closed
from freebody.symbolic.ratio import Ratio
from freebody.system.modes import ContactMode

MAX_CANDIDATES = 48


def candidates(home: Home, instant: PhaseStart, indices: Chosen) -> Iterator[ContactMode]:
    """Modes in the order in which they are tried: all closed, sticking before sliding."""
    closed, before = instant.closed, instant.before
    ways = {**instant.ways, **ways_of_onset(home, instant, indices)}
    in_planes = {rub.name for rub in home.system.dry_friction if rub.across is not None}
    allowed_states = {name: _states(home, instant, name, indices) for name in instant.slips}
    seen: set[ContactMode] = set()
    modes: list[tuple[int, int, ContactMode]] = []
    combined = (
        (still, rubbing, {**instant.acting, **sides})
        for still, rubbing in _combined(home, instant, allowed_states)
        for sides in sides_at_borders(home, instant)
    )
    tried = itertools.islice(combined, 4 * allowed(MAX_CANDIDATES))
    for k, (still, dry_friction, acting) in enumerate(tried):
        mode = ContactMode.of(still, dry_friction, instant.past, ways, acting)
        if any(state and name in in_planes - ways.keys() for name, state in dry_friction.items()):
            continue  # nothing drives it in any direction
        if mode not in seen:
            seen.add(mode)
            n_changes = sum(before.get(n, s) != s for n, s in dry_friction.items()) + 3 * (len(closed) - len(still))
            modes.append((n_changes, k, mode))
    modes.sort(key=lambda item: item[:2])
    yield from (mode for _n, _k, mode in modes[: allowed(MAX_CANDIDATES)])


def _states(home: Home, instant: PhaseStart, name: str, indices: Chosen) -> list[int]:
    """The states that a friction may take: sticking, or sliding in the direction that its slip has or takes up."""
    slip, excluded = instant.slips[name], instant.excluded
    if slip.is_zero():
        is_let_go = excluded is not None and excluded[0] == name and excluded[1]
        return [excluded[1]] if is_let_go and excluded is not None else [0, 1, -1]
    numbers = home.numbers(slip)[indices]
    signs = [s for s in (1, -1) if np.any(s * numbers > 0)]
    return [*signs, 0] if np.any(numbers == 0) else signs


def _combined(
    home: Home, instant: PhaseStart, states: Mapping[str, list[int]]
) -> Iterator[tuple[set[str], dict[str, int]]]:
    """What stays closed, with the states of what rubs there. Slips that are one motion share their state."""
    names = sorted(instant.closed)
    kept = [(False,) if instant.excluded == (name, 0) else (True, False) for name in names]
    for stays in itertools.product(*kept):
        still = {name for name, is_closed in zip(names, stays, strict=True) if is_closed}
        rubbing = [name for name in states if _touches(home, name, still)]
        groups = slipping_together(rubbing, home.slip_rates if still >= home.closed else {})
        choices = [
            [
                {name: sense * s for name, sense in group}
                for s in states[group[0][0]]
                if all(sense * s in states[name] for name, sense in group)
            ]
            for group in groups
        ]
        for chosen in itertools.product(*choices):
            yield still, {name: s for part in chosen for name, s in part.items()}


def sides_at_borders(home: Home, instant: PhaseStart) -> list[dict[str, bool]]:
    """The sides of the borders at which a motion begins."""
    open_ones = sorted(home.system.borders.keys() - instant.acting.keys())
    return [
        dict(zip(open_ones, sides, strict=True)) for sides in itertools.product((True, False), repeat=len(open_ones))
    ]


def _touches(home: Home, rub: str, closed: set[str]) -> bool:
    of = next(r.of for r in home.system.dry_friction if r.name == rub)
    return not of or of in closed


def checks(phase: Phase, instant: PhaseStart) -> Iterator[Inequality]:
    """Inequalities between elements of the parameters that make the mode consistent at its start. What an event has
    just let go of, by a force that falls through its limit, goes on of itself."""
    closed, slips, excluded = instant.closed, instant.slips, instant.excluded
    here, model = phase.start_instant.here, phase.model
    if phase.determinant is not None:
        yield here(phase.determinant), ">", Message("friction forces exist")
    yield from ((x, ">", Message("it moves by this law")) for x in phase.sides)
    for watch in phase.watches:
        if watch.name in phase.base.borders:
            if watch.name not in instant.acting:
                yield _leaves_its_border(phase, watch)
        elif watch.kind == "opens":
            row = next((row for row in phase.base.rows if row.name == watch.name), None)
            reaction = "normal force" if row is None or row.reaction != "tension" else row.reaction
            yield _at_first(phase, watch.element), ">=", while_closed(watch.connection, reaction)
        elif watch.kind == "slips":
            yield here(watch.element), ">=", Message("{contact} does not slip", contact=watch.connection)
        elif watch.kind in ("changes sign", "is left"):
            yield here(watch.element), ">=", watch.purpose
        elif watch.kind == "slip ends":
            slip = slips[watch.name]
            sign = phase.mode.states[watch.name]
            if excluded is not None and excluded[0] == watch.name:
                continue
            if slip.is_zero():
                rub = phase.dry_friction[watch.name]
                yield (
                    sign * here(phase.state.acceleration(rub.row.measure)),
                    ">",
                    Message("{contact} slips", contact=watch.connection),
                )
            else:
                yield here(watch.element), ">", Message("{contact} slips", contact=watch.connection)
    let_go = "" if excluded is None else excluded[0]
    for name in sorted(closed - phase.mode.closed - {let_go}):
        gap = phase.gap(phase.base_row(name))
        rate = here(model.in_independent_speeds(model.rate(gap)))
        if rate.is_zero():
            second = model.field.substitute(model.rate(model.rate(gap)), model.dynamics.solved_accelerations)
            yield _at_first(phase, second), ">", Message("{contact} opens", contact=name.partition(".")[0])
        else:
            yield rate, ">", Message("{contact} opens", contact=name.partition(".")[0])


def _at_first(phase: Phase, x: Ratio) -> Ratio:
    """What has the sign of an element just after the start: its value there, or where that is zero its rate. Two feet
    whose pressures vanish at the same instant leave the floor together."""
    model, here = phase.model, phase.start_instant.here
    value = here(x)
    if not value.is_zero():
        return value
    with suppress(CannotAnswer):
        rate = model.in_independent_speeds(model.rate(model.in_independent_speeds(x)))
        return here(model.field.substitute(rate, model.dynamics.solved_accelerations))
    return value


def _leaves_its_border(phase: Phase, watch: PhaseWatch) -> Inequality:
    """Where a motion begins at a border, it is on the side to which it goes."""
    here, model = phase.start_instant.here, phase.model
    rate = model.in_independent_speeds(model.rate(watch.element))
    if here(rate).is_zero():
        rate = model.field.substitute(model.rate(rate), model.dynamics.solved_accelerations)
    return here(rate), ">", at_border(phase.base.borders[watch.name], acts=watch.kind == "opens")


def without_slip(mode: ContactMode, instant: PhaseStart) -> list[Inequality]:
    """What sticks from the start on although a slip is possible there must have none."""
    states = mode.states
    return [
        (x, "=", Message("{contact} does not slip", contact=name.partition(".")[0]))
        for name, x in instant.slips.items()
        if states.get(name) == 0 and not x.is_zero()
    ]
