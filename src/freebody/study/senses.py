"""The sense in which a reaction is drawn, and counted positive in a derivation.

Where a force may act either way along its line, a lecturer draws it as it acts: friction up the slope on a disk that
rolls down, so that F is positive and Coulomb's law reads F = mu N. The sense is that at the start, with the numbers of
the file. What a convention settles keeps it: a tension pulls, what touches pushes, components point along their axes,
and couples turn counter-clockwise.

The question `friction force of CONTACT` keeps the sign of its row, which does not hang on numbers; a derivation ends by
saying how that is counted.
"""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import replace
from functools import lru_cache

from freebody.errors import FreebodyError
from freebody.model.elements import ConstraintRow
from freebody.study.pictures.instant import instant_of, start_of
from freebody.system.symbols import ReactionSymbol, reaction_symbols
from freebody.system.system import System

_NOTHING = 1e-7  # of the largest reaction: what is smaller has no sense
_MOST_ROWS = 2_000  # of a system that is set in motion for this


def drawn_symbols(system: System, *, base: System | None = None) -> Mapping[str, ReactionSymbol]:
    """`reaction_symbols` of a system, by row, with the sign that makes a reaction positive at the start. base: the
    system of which it is one mode, whose start counts."""
    symbols = reaction_symbols(system)
    senses = _senses(base or system)
    return {name: replace(s, sign=s.sign * senses.get(name, 1)) for name, s in symbols.items()}


@lru_cache(maxsize=8)
def _senses(system: System) -> Mapping[str, int]:
    """-1 for rows that may push either way and whose reaction is negative at the start."""
    free = [row for row in system.rows if _may_act_either_way(row)]
    if not free or len(system.rows) > _MOST_ROWS:
        return {}
    values: Mapping[str, float] = {}
    with suppress(FreebodyError):  # without a start or values everything keeps its own sign
        values = _at_start(system, free)
    largest = max(map(abs, values.values()), default=0.0)
    return {row.name: -1 for row in free if values.get(row.name, 0.0) < -_NOTHING * largest}


@lru_cache(maxsize=8)
def load_senses(system: System) -> Mapping[str, int]:
    """-1 for loads whose force is, at the start, against the sense in which they are drawn otherwise: a spring that is
    pressed together pushes."""
    if not system.has_values:
        return {}
    with suppress(FreebodyError):
        snapshot = start_of(system).snapshot
        own = {name: load.drawn_sign for name, load in system.loads.items()}
        values = {p.name: own.get(p.load, 1) * snapshot.law(p) for p in system.applied_loads}
        largest = max(map(abs, values.values()), default=0.0)
        return {name: -1 for name, value in values.items() if value < -_NOTHING * largest}
    return {}


def _may_act_either_way(row: ConstraintRow) -> bool:
    """Whether no convention says how its reaction is counted."""
    is_component = bool(row.axis)
    is_couple = "moment" in row.reaction or "torque" in row.reaction
    return not (row.unilateral or is_component or is_couple or row.reaction == "tension")


def _at_start(system: System, free: list[ConstraintRow]) -> Mapping[str, float]:
    """[N] by row."""
    if system.has_values:
        return instant_of(system, None, in_motion=True).reactions
    if system.bounds or system.dry_friction:
        return {}
    snapshot = start_of(system).snapshot
    return {row.name: row.sign * snapshot.multiplier(row) for row in free}
