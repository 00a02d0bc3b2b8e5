"""Parts of a system that know nothing of each other.

Two bodies belong together if a connection, a load, a contact or a given start value joins them; the ground and fixed
bodies join nothing, since they do not move. The equations of motion of a system fall apart along its parts, so a
question about one part is answered in it: what else stands in the file cannot block or change the answer.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import fields, is_dataclass, replace
from typing import Any, cast

from freebody.measures.geometry import GROUND, Direction, Point
from freebody.model.elements import ConstraintRow
from freebody.questions.base import Quantity
from freebody.questions.reading import Question
from freebody.system.system import System


def part_for(system: System, groups: Sequence[set[str]], question: Question) -> System | None:
    """The part of a system that a question is about; None if that is the whole system, or several parts. groups: of the
    bodies that belong together."""
    if len(groups) < 2 or system.mode is not None or system.unspecified:
        return None
    asked = (question.quantity, question.event, question.transition)
    if any(_is_of_all(item) for item in _inside(asked)):
        return None
    if question.transition is not None and not question.transition.of:
        return None
    named = set(_bodies_in(system, asked)) & {b.name for b in system.moving}
    meant = [group for group in groups if group & named]
    if len(meant) != 1:
        return None
    part = _cut_out(system, meant[0])
    words = {w for text in question.options.values() for w in re.findall(r"[A-Za-z_]\w*", str(text))}
    return None if words & (system.measures.keys() - part.measures.keys()) else part


def _is_of_all(item: Any) -> bool:
    return isinstance(item, Quantity) and item.is_of_whole


# -- which bodies belong together -------------------------------------------------------------
def groups_of(system: System) -> list[set[str]]:
    """The moving bodies, as sets of those that belong together."""
    moving = {b.name for b in system.moving}
    groups: list[set[str]] = [{b.name} for b in system.moving]
    for joined in _joined(system):
        mine = joined & moving
        touched = [group for group in groups if group & mine]
        if len(touched) > 1:
            groups = [group for group in groups if not group & mine] + [set[str]().union(*touched)]
    return groups


def _joined(system: System) -> Iterator[set[str]]:
    """Bodies that a connection, load, contact, attitude, frame or start value joins."""
    of_connection: dict[str, set[str]] = {}
    connection_of = {row.name: row.connection for row in system.rows}
    for row in system.rows:
        of_connection.setdefault(row.connection, set()).update(_bodies_of(system, row))
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


def _bodies_of(system: System, row: ConstraintRow) -> set[str]:
    """The bodies between which a row is; of its ends, some are called by lines."""
    return {*row.measure.bodies(), *(end for end in row.ends if end in system.bodies)}


# -- what a question is about -----------------------------------------------------------------
def _inside(value: Any) -> Iterator[Any]:
    """A description with all that it is made of."""
    yield value
    if isinstance(value, (tuple, list)):
        for item in cast("Iterable[Any]", value):
            yield from _inside(item)
    elif is_dataclass(value) and not hasattr(value, "bodies") and not isinstance(value, (Point, Direction)):
        for field in fields(value):
            yield from _inside(getattr(value, field.name))


def _bodies_in(system: System, asked: Any) -> Iterator[str]:
    """Names of the bodies that a description mentions, by itself, its connections, loads and measures."""
    for item in _inside(asked):
        if isinstance(item, (Point, Direction)):
            yield item.body
        elif hasattr(item, "bodies"):
            yield from item.bodies()
        elif isinstance(item, str):
            yield from _named(system, item)


def _named(system: System, name: str) -> Iterator[str]:
    if name in system.bodies:
        yield name
    if name in system.measures:
        yield from system.measures[name].bodies()
    for row in system.rows:
        if row.connection == name:
            yield from _bodies_of(system, row)
    for push in system.pushes:
        if push.load == name:
            yield from push.measure.bodies()


# -- cutting ----------------------------------------------------------------------------------
def _cut_out(system: System, group: set[str]) -> System:
    """The system with the bodies of a group, and those that do not move, alone."""
    kept = group | {b.name for b in system.bodies.values() if b.fixed} | {GROUND}

    def stays(bodies: Iterable[str]) -> bool:
        return set(bodies) <= kept

    measures = {name: m for name, m in system.measures.items() if stays(m.bodies())}
    held = tuple(row for row in system.held if stays(_bodies_of(system, row)))
    pushes = tuple(push for push in system.pushes if stays(push.measure.bodies()))
    gone = {row.connection for row in system.rows if not stays(_bodies_of(system, row))}
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
