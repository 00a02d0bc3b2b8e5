"""Parts of a system that know nothing of each other.

Which bodies belong together a system knows itself (`System.groups`). Its equations of motion fall apart along these
groups, and so do those of its start.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from freebody.measures.geometry import GROUND
from freebody.system.system import System


def cut_out(system: System, group: frozenset[str]) -> System:
    """The system with the bodies of a group, and those that do not move, alone."""
    kept = group | {b.name for b in system.bodies.values() if b.fixed} | {GROUND}

    def stays(bodies: Iterable[str]) -> bool:
        return set(bodies) <= kept

    measures = {name: m for name, m in system.measures.items() if stays(m.bodies())}
    held = tuple(row for row in system.constraint_rows if stays(system.ends_of(row)))
    applied_loads = tuple(push for push in system.applied_loads if stays(push.measure.bodies()))
    impulses = tuple(push for push in system.impulses if stays(push.measure.bodies()))
    blows = tuple(blow for blow in system.blows if stays(system.ends_of_blow(blow)))
    gone = {row.connection for row in system.rows if not stays(system.ends_of(row))}
    struck = (push for blow in blows for push in blow.impulses)
    loads = {push.load for push in (*applied_loads, *impulses, *struck)}
    return replace(
        system,
        bodies={name: body for name, body in system.bodies.items() if name in kept},
        constraint_rows=held,
        applied_loads=applied_loads,
        impulses=impulses,
        blows=blows,
        measures=measures,
        states={name: state for name, state in system.states.items() if state.carrier in kept},
        feet={name: foot for name, foot in system.feet.items() if foot.carrier in kept},
        offered=tuple((name, m) for name, m in system.offered if stays(m.bodies())),
        start={name: e for name, e in system.start.items() if name in measures},
        start_rates={name: e for name, e in system.start_rates.items() if name in measures},
        connections={name: c for name, c in system.connections.items() if name not in gone},
        loads={name: load for name, load in system.loads.items() if name in loads},
        contacts=tuple(pair for pair in system.contacts if pair.connection not in gone),
        limits=tuple(bound for bound in system.limits if stays(bound.row.measure.bodies())),
        brakes=tuple(rub for rub in system.brakes if stays(rub.row.measure.bodies())),
        validities=tuple(v for v in system.validities if stays(v.measure.bodies())),
        attitudes=tuple(a for a in system.attitudes if stays((a.first, a.second))),
    )
