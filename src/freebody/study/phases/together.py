"""Slips that are one motion: two corners of one body on one plane slide together, or not at all."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress

from freebody.errors import CannotAnswer
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.state import SymbolicState
from freebody.system.system import System

Group = list[tuple[str, int]]  # frictions, each with the sense in which it slips when the first slips forward


def slip_rates(system: System, state: SymbolicState) -> dict[str, Ratio]:
    """Of all frictions that have one, whatever the speeds are."""
    model, found = state.model, dict[str, Ratio]()
    for rub in system.dry_friction:
        with suppress(CannotAnswer):
            found[rub.name] = model.field.lowest_terms(model.in_independent_speeds(state.rate(rub.row.measure)))
    return found


def slipping_together(names: Sequence[str], rates: Mapping[str, Ratio]) -> list[Group]:
    """Frictions in groups of one motion. rates: of their slips while all stays closed that is closed now, or more."""
    groups: list[Group] = []
    for name in names:
        for group in groups:
            if sense := _alike(rates.get(group[0][0]), rates.get(name)):
                group.append((name, sense))
                break
        else:
            groups.append([(name, 1)])
    return groups


def _alike(first: Ratio | None, second: Ratio | None) -> int:
    """The sense in which one slips as the other does, 0 where it may slip otherwise."""
    if first is None or second is None or first.is_zero():
        return 0
    return next((sense for sense in (1, -1) if (second - sense * first).is_zero()), 0)
