"""What follows on a blow in mid-motion: connections that close and impulses that act at an event.

First the blow, with what only pushes or pulls left out; then a contact whose gap it makes shrink collides, one whose
gap it makes grow parts, and one that it leaves alone keeps touching, as at a start that is a blow.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.study.phases.home import Home
from freebody.study.phases.impact import SuddenBlow
from freebody.study.phases.nodes import JustBefore, PhaseEnd, PhaseImpact, PhaseNode, PhaseStart
from freebody.study.phases.numbers import Chosen
from freebody.symbolic.state import SymbolicState
from freebody.tolerances import ROUND_OFF


def after_blow(
    home: Home, node: PhaseNode, edge: PhaseEnd, instant: PhaseStart
) -> Iterator[tuple[PhaseStart, tuple[str, ...], Chosen]]:
    """The states after the blow with which a phase ends, what collides in each, and the sets for which it is that
    state. instant: the state just before. Raises CannotAnswer where the blow has no closed form."""
    phase, first = node.phase, edge.first
    assert first is not None
    blow = next(b for b in home.system.blows if b.name == first.watch.name)
    struck = SuddenBlow(home.system, blow, phase.mode.past, instant.placed, home.sets.some(edge.sets, 3))
    _refuse_gaps(home, struck, edge.sets)
    _refuse_friction(home, struck)
    setup, state = struck.setup, struck.after
    impulses = {name: home.to_home(setup, x) for name, x in struck.impulses.items()}
    before = JustBefore(phase, SymbolicState(phase.model, {**phase.still, **first.zero.values}))
    impact = PhaseImpact((), impulses, before, phase.mode.closed, struck, struck.unknown)
    placed = replace(home.placed(setup, struck.start.values), since=instant.placed.since)
    after = replace(instant, placed=placed, impact=impact, past=phase.mode.past | {blow.name})
    after = replace(after, n_impacts=node.n_impacts)
    touching = phase.mode.closed - _held_anyway(home, struck, phase.mode.closed)
    rows = {name: home.bound_row(name) for name in sorted(touching)}
    rates = {name: row.sign * home.to_home(setup, state.rate(row.measure)) for name, row in rows.items()}
    slips = {r.name: home.to_home(setup, state.rate(r.row.measure)) for r in home.rubbing(touching)}
    for signs, sets in home.by_sign({n: x for n, x in rates.items() if not x.is_zero()}, edge.sets):
        hits = tuple(sorted(name for name, sign in signs.items() if sign < 0))
        closed = touching - {name for name, sign in signs.items() if sign}
        given = home.conditions([(sign * rates[n], ">", "") for n, sign in signs.items() if sign], sets)
        own = {} if hits else {r.name: slips[r.name] for r in home.rubbing(closed)}
        yield replace(after, closed=closed, slips=own, given=tuple(given)), hits, sets


def _held_anyway(home: Home, struck: SuddenBlow, names: Iterable[str]) -> set[str]:
    """Contacts whose gaps no motion changes that the connections allow after the blow, as where a pin catches the
    corner that slides on the floor: the pin takes the force, and how they would share it is not determined."""
    anywhere = SymbolicState(struck.setup.model)
    return {name for name in names if anywhere.rate(home.bound_row(name).measure).is_zero()}


def _refuse_gaps(home: Home, struck: SuddenBlow, sets: Chosen) -> None:
    """What closes must fit where it does."""
    for name, gap in struck.gaps.items():
        if (np.abs(home.numbers(home.to_home(struck.setup, gap))[sets]) > ROUND_OFF).any():
            raise CannotAnswer(
                Message(
                    "{connection} cannot close when {event}: what it joins does not meet there",
                    connection=name.partition(".")[0],
                    event=struck.blow.name,
                )
            )


def _refuse_friction(home: Home, struck: SuddenBlow) -> None:
    """Dry friction in joints acts in a blow that loads it."""
    loads = {name for rub in home.system.dry_friction if not rub.of for name in rub.load}
    for row in struck.setup.system.constraint_rows:
        if row.name in loads and not (row.name in struck.impulses and struck.impulses[row.name].is_zero()):
            raise CannotAnswer(
                Message(
                    "the blow when {event} loads {connection}, whose dry friction acts in it as well: such a blow "
                    "is not solved",
                    event=struck.blow.name,
                    connection=row.connection,
                )
            )
