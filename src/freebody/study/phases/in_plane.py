"""Slips in a plane: while a slip keeps its direction e, dry friction in a plane is that along a line,

    slip s = u . e,    force -c N e,    as long as the other component of du/dt is zero.

What slips goes on in the direction that its slip has; what begins to slip does so against the friction that would be
needed to hold it. Source: Coriolis, Theorie mathematique des effets du jeu de billard, 1835, ch. I.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from freebody.language.expression import ONE, ZERO, Expr
from freebody.model.elements import DryFriction
from freebody.study.phases.home import Home
from freebody.study.phases.nodes import PhaseStart
from freebody.study.phases.numbers import Chosen
from freebody.study.phases.placed import Given
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.start import start_state
from freebody.symbolic.state import SymbolicState
from freebody.system.modes import ContactMode, Way, in_mode

Rates = Callable[[Any], Ratio]  # of a measure, in the field that all phases share


@dataclass(frozen=True)
class Slips:
    """Slips by name, and in which direction of its plane each is counted that has two components."""

    sizes: dict[str, Ratio]
    ways: dict[str, Way]


def slips_of(home: Home, rubs: Iterable[DryFriction], rate: Rates) -> Slips:
    """Of frictions in a state, by the rates of their rows there."""
    found = Slips({}, {})
    for rub in rubs:
        if rub.across is None:
            found.sizes[rub.name] = rate(rub.row.measure)
            continue
        found.sizes[rub.name], way = directed(home, rate(rub.row.measure), rate(rub.across.measure))
        if not found.sizes[rub.name].is_zero():
            found.ways[rub.name] = way
    return found


def directed(home: Home, first: Ratio, second: Ratio) -> tuple[Ratio, Way]:
    """Two components as one along a direction. Along one of the rows it keeps its sign."""
    if second.is_zero():
        return first, (ONE, ZERO)
    if first.is_zero():
        return second, (ZERO, ONE)
    f = home.home.model.field
    size = home.home.state.sqrt(f.lowest_terms(first * first + second * second))
    one, other = (f.expression(f.lowest_terms(x / size)) for x in (first, second))
    return f.lowest_terms(size), (one, other)


def ways_of_onset(home: Home, instant: PhaseStart, indices: Chosen) -> dict[str, Way]:
    """In which direction what is at rest in its plane would begin to slip: against the forces that would hold it."""
    rubs = {rub.name: rub for rub in home.system.dry_friction}
    resting = [n for n, x in instant.slips.items() if x.is_zero() and rubs[n].across is not None]
    if not resting:
        return {}
    states = {name: _sense(home, x, indices) for name, x in instant.slips.items()}
    mode = ContactMode.of(instant.closed, states, instant.past, instant.ways)
    phase = home.begun(mode, instant.placed, indices)
    found: dict[str, Way] = {}
    for name in resting:
        forces = [phase.model.reactions.multiplier(phase.rows[row.name]) for row in rubs[name].rows]
        first, second = (-home.to_home(phase, phase.start_instant.here(force)) for force in forces)
        if not (first.is_zero() and second.is_zero()):
            found[name] = directed(home, first, second)[1]
    return found


def ways_of_impact(
    home: Home, instant: PhaseStart, hits: Sequence[str], values: Sequence[Mapping[str, float]]
) -> dict[str, Way]:
    """In which direction of its plane what collides slips just before; along the first row where it does not slip."""
    rubs = [rub for rub in home.system.dry_friction if rub.of in hits and rub.across is not None]
    if not rubs:
        return {}
    system, _loads = in_mode(instant.placed.put_into(home.system), ContactMode.of(instant.closed, {}, instant.past))
    setup = Given(system, values)
    start = start_state(setup.model, dict(system.all_start), dict(system.all_start_rates))
    now = SymbolicState(setup.model, start.values)
    slips = slips_of(home, rubs, lambda measure: home.to_home(setup, setup.model.field.lowest_terms(now.rate(measure))))
    return {rub.name: slips.ways.get(rub.name, (ONE, ZERO)) for rub in rubs}


def _sense(home: Home, slip: Ratio, indices: Chosen) -> int:
    if slip.is_zero():
        return 0
    return 1 if home.numbers(slip)[indices[0]] > 0 else -1


def with_ways(states: Mapping[str, int], ways: Mapping[str, Way]) -> dict[str, tuple[Expr, Expr]]:
    """The directions of what slides."""
    return {name: way for name, way in ways.items() if states.get(name)}
