"""Parts of a system that know nothing of each other.

Two bodies belong together if a connection, a load, a contact or a given start value joins them; the ground and fixed
bodies join nothing, since they do not move. The equations of motion of a system fall apart along its parts, and so do
those of its start.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from freebody.measures.geometry import GROUND
from freebody.model.elements import ConstraintRow

if TYPE_CHECKING:
    from freebody.system.system import System


def groups_of(system: System) -> list[set[str]]:
    """The moving bodies, as sets of those that belong together."""
    return joined([{b.name} for b in system.moving], _ties(system))


def joined(groups: Sequence[set[str]], ties: Iterable[set[str]]) -> list[set[str]]:
    """Groups of bodies, those merged that a tie joins. ties: sets of bodies, of which some may be in no group."""
    found = list(groups)
    for tie in ties:
        touched = [group for group in found if group & tie]
        if len(touched) > 1:
            found = [group for group in found if not group & tie] + [set[str]().union(*touched)]
    return found


def _ties(system: System) -> Iterator[set[str]]:
    """Bodies that a connection, load, contact, attitude, frame or start value joins."""
    of_connection: dict[str, set[str]] = {}
    connection_of = {row.name: row.connection for row in system.rows}
    for row in system.rows:
        of_connection.setdefault(row.connection, set()).update(bodies_of(system, row))
    yield from of_connection.values()
    for bound in system.bounds:
        yield set(bound.row.measure.bodies()).union(*(span.measure.bodies() for span in bound.within))
    for rub in system.rubs:
        yield set(rub.row.measure.bodies()).union(*(m.bodies() for _n, m in rub.measures))
        loaded = [connection_of[name] for name in (*rub.load, rub.of) if name in connection_of]
        yield set[str]().union(of_connection[rub.row.connection], *(of_connection[c] for c in loaded))
    for push in system.pushes:
        yield set(push.measure.bodies()).union(*(m.bodies() for _n, m in push.measures))
    for attitude in system.attitudes:
        yield {attitude.first, attitude.second}
    for body in system.bodies.values():
        yield {body.name, body.frame}
    for name in (*system.start, *system.start_rates):
        yield set(system.measures[name].bodies())


def bodies_of(system: System, row: ConstraintRow) -> set[str]:
    """The bodies between which a row is; of its ends, some are called by lines."""
    return {*row.measure.bodies(), *(end for end in row.ends if end in system.bodies)}


def cut_out(system: System, group: set[str]) -> System:
    """The system with the bodies of a group, and those that do not move, alone."""
    kept = group | {b.name for b in system.bodies.values() if b.fixed} | {GROUND}

    def stays(bodies: Iterable[str]) -> bool:
        return set(bodies) <= kept

    measures = {name: m for name, m in system.measures.items() if stays(m.bodies())}
    held = tuple(row for row in system.held if stays(bodies_of(system, row)))
    pushes = tuple(push for push in system.pushes if stays(push.measure.bodies()))
    gone = {row.connection for row in system.rows if not stays(bodies_of(system, row))}
    loads = {push.load for push in pushes}
    return replace(
        system,
        bodies={name: body for name, body in system.bodies.items() if name in kept},
        held=held,
        pushes=pushes,
        measures=measures,
        offered=tuple((name, m) for name, m in system.offered if stays(m.bodies())),
        start={name: e for name, e in system.start.items() if name in measures},
        start_rates={name: e for name, e in system.start_rates.items() if name in measures},
        connections={name: c for name, c in system.connections.items() if name not in gone},
        loads={name: load for name, load in system.loads.items() if name in loads},
        contacts=tuple(pair for pair in system.contacts if pair.connection not in gone),
        limits=tuple(bound for bound in system.limits if stays(bound.row.measure.bodies())),
        brakes=tuple(rub for rub in system.brakes if stays(rub.row.measure.bodies())),
        attitudes=tuple(a for a in system.attitudes if stays((a.first, a.second))),
    )
