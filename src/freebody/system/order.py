"""One order of the elements of a system, whatever the order in which its file lists them.

Coordinates are chosen, and terms of a sum are written, in the order of the elements; so that no answer and no
formula hangs on the order of a file, the symbolic route sees every system in this one:

- bodies by how many others they are joined to, the most first: where loops bind them, the others follow from these
  in the fewest steps. Of those that are joined to as many, as one walks from the ground along the connections: each as
  soon as a body next to it has been met, and on from there before others (depth first), so that a four-bar linkage is
  crank, coupler, rocker; of several by name;
- named measures: first those that the start gives values, which is what the user calls the configuration; in the
  plane lengths before angles, in space angles before lengths; then by name;
- connections by how many rows they hold, the most first: a pin puts a point where another one is, which a slot needs to
  know; then by name, as measures that connections offer and loads are.

Names are compared as people read them: `b2` before `b10`.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import replace
from typing import TypeVar

from freebody.language.natural import natural
from freebody.language.units import DIMENSIONLESS
from freebody.model.states import state_name
from freebody.system.blows import BlowEvent
from freebody.system.system import System

_T = TypeVar("_T")


def in_one_order(system: System) -> System:
    """The same system, its elements in the order that this module defines."""
    names = sorted((body.name for body in system.all_moving), key=natural)
    # what reads a single moving body leads to it from the ground; in what reads several, the ground is only what
    # directions are measured in
    joined = [set(row.measure.bodies()) & set(names) for row in system.constraint_rows]
    beside = {name: set[str]().union(*(ends for ends in joined if name in ends)) for name in names}
    on_ground = [name for name in names if {name} in joined]
    walk = {name: k for k, name in enumerate(_walk(names, beside, on_ground))}
    given = system.start.keys() | system.start_rates.keys()

    n_rows = Counter(row.connection for row in system.constraint_rows)

    def rank_of_body(name: str) -> tuple[object, ...]:
        if system.bodies[name].fixed:
            return -math.inf, natural(name)
        if state_name(name):  # what carries a state comes after all bodies, by whose places others count
            return math.inf, natural(name)
        return -len(beside[name] - {name}) - (name in on_ground), walk[name]

    def rank_of_measure(name: str) -> tuple[object, ...]:
        is_angle = system.measures[name].dimension == DIMENSIONLESS
        return name not in given, is_angle != system.space, natural(name)

    return replace(
        system,
        bodies=_sorted(system.bodies, rank_of_body),
        measures=_sorted(system.measures, rank_of_measure),
        offered=tuple(sorted(system.offered, key=lambda entry: natural(entry[0]))),
        constraint_rows=tuple(
            sorted(system.constraint_rows, key=lambda row: (-n_rows[row.connection], natural(row.connection)))
        ),
        states=_sorted(system.states, natural),
        feet=_sorted(system.feet, natural),
        attitudes=tuple(sorted(system.attitudes, key=lambda attitude: natural(attitude.connection))),
        applied_loads=tuple(
            sorted(system.applied_loads, key=lambda push: (natural(push.load), natural(push.component)))
        ),
        impulses=tuple(sorted(system.impulses, key=lambda push: natural(push.load))),
        blows=tuple(map(_blow_in_order, system.blows)),
    )


def _blow_in_order(blow: BlowEvent) -> BlowEvent:
    rows = sorted(blow.rows, key=lambda row: natural(row.connection))
    return replace(blow, rows=tuple(rows), impulses=tuple(sorted(blow.impulses, key=lambda push: natural(push.load))))


def _walk(names: Sequence[str], beside: Mapping[str, Collection[str]], on_ground: Sequence[str]) -> list[str]:
    """The moving bodies in the order in which they are met. names: in the order in which they are looked at; beside: to
    which others each is joined."""
    met: dict[str, None] = {}
    waiting = [*reversed(names), *reversed(on_ground)]  # the last is met first
    while waiting:
        name = waiting.pop()
        if name not in met:
            met[name] = None
            waiting += [other for other in reversed(names) if other in beside[name]]
    return list(met)


def _sorted(entries: Mapping[str, _T], key: Callable[[str], object]) -> dict[str, _T]:
    return {name: entries[name] for name in sorted(entries, key=key)}  # pyrefly: ignore[no-matching-overload]
