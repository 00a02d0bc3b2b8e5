"""Which modes may follow on a state of the contacts, and what makes one of them consistent there.

At an instant every closed bound and every friction without slip is up for decision. A mode is consistent if

    closed   N >= 0                        open at gap 0    gap'' > 0 (gap' > 0)
    sticks   -mu_s N <= T <= mu_s N        slides           s slip' > 0, or slip' = 0 and s slip'' > 0

Source of the cases: Pfeiffer & Glocker, Multibody Dynamics with Unilateral Contacts, 1996, ch. 5.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator

import numpy as np

from freebody.budgets import allowed
from freebody.language.sentences import Message
from freebody.study.phases.decide import Inequality
from freebody.study.phases.home import Home
from freebody.study.phases.nodes import PhaseStart
from freebody.study.phases.numbers import Chosen
from freebody.study.phases.phase import Phase
from freebody.system.modes import ContactMode

MAX_CANDIDATES = 48


def candidates(home: Home, instant: PhaseStart, indices: Chosen) -> Iterator[ContactMode]:
    """Modes in the order in which they are tried: all closed, sticking before sliding."""
    closed, slips, before, excluded = instant.closed, instant.slips, instant.before, instant.excluded
    choices: list[list[tuple[str, int | None]]] = []
    for name in sorted(closed):
        open_now = excluded == (name, 0)
        choices.append([(name, None)] if open_now else [(name, 1), (name, None)])
    for name, slip in slips.items():
        signs: list[int]
        if slip.is_zero():
            signs = [0, 1, -1]
            if excluded is not None and excluded[0] == name:
                signs = [excluded[1]] if excluded[1] else signs
        else:
            numbers = home.numbers(slip)[indices]
            signs = [s for s in (1, -1) if np.any(s * numbers > 0)]
            if np.any(numbers == 0):
                signs.append(0)
        choices.append([(name, s) for s in signs])
    tried = itertools.islice(itertools.product(*choices), 4 * allowed(MAX_CANDIDATES))
    seen: set[ContactMode] = set()
    modes: list[tuple[int, int, ContactMode]] = []
    for k, combination in enumerate(tried):
        still = {n for n, s in combination if n in closed and s is not None}
        still |= {n for n in closed if n not in dict(combination)}
        dry_friction = {n: s for n, s in combination if n in slips and s is not None and _touches(home, n, still)}
        mode = ContactMode.of(still, dry_friction, instant.past)
        if mode not in seen:
            seen.add(mode)
            n_changes = sum(before.get(n, s) != s for n, s in dry_friction.items()) + 3 * (len(closed) - len(still))
            modes.append((n_changes, k, mode))
    modes.sort(key=lambda item: item[:2])
    yield from (mode for _n, _k, mode in modes[: allowed(MAX_CANDIDATES)])


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
        if watch.kind == "opens":
            yield here(watch.element), ">=", Message("{contact} keeps touching", contact=watch.connection)
        elif watch.kind == "slips":
            yield here(watch.element), ">=", Message("{contact} does not slip", contact=watch.connection)
        elif watch.kind == "changes sign":
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
            yield here(second), ">", Message("{contact} opens", contact=name.partition(".")[0])
        else:
            yield rate, ">", Message("{contact} opens", contact=name.partition(".")[0])


def without_slip(mode: ContactMode, instant: PhaseStart) -> list[Inequality]:
    """What sticks from the start on although a slip is possible there must have none."""
    states = mode.states
    return [
        (x, "=", Message("{contact} does not slip", contact=name.partition(".")[0]))
        for name, x in instant.slips.items()
        if states.get(name) == 0 and not x.is_zero()
    ]
