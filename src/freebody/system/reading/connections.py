"""The section `connections`: rows that hold, measures that are offered, contacts, limits and dry friction."""

from __future__ import annotations

from collections.abc import Container, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any, cast

from freebody.connections.base import Connection
from freebody.connections.pairs import OutlinePair
from freebody.language.expression import free_symbols, substitute
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.measures.distance import Bearing
from freebody.measures.geometry import GROUND
from freebody.model.carriers import is_distance_kept
from freebody.model.curves import CurvePlace
from freebody.model.elements import Attitude, ConstraintRow, DryFriction, UnilateralConstraint
from freebody.model.named_angles import offered_name
from freebody.model.names import Names
from freebody.model.phrases import direction_angle
from freebody.model.surfaces import SurfacePlace
from freebody.questions.event import AskedEvent, read_event
from freebody.system.reading.loads import happening
from freebody.system.reading.parameters import forms
from freebody.system.reading.sections import CLOSES
from freebody.system.reading.source import Source

MOST_ASKED = 40
_AT_START = ("at start", "start")


def closing_at_start(source: Source) -> frozenset[str]:
    """The connections that close when the motion begins: `{weld: [bullet, block], closes: at start}`."""
    return frozenset(name for name, value in _closings(source) if value in _AT_START)


def closing_when(source: Source) -> dict[str, AskedEvent]:
    """The connections that close in mid-motion, `{pin: [peg, rod.notch], closes: when theta = 0}`, and at which
    event."""
    found: dict[str, AskedEvent] = {}
    for name, value in _closings(source):
        if value in _AT_START:
            continue
        if not isinstance(value, str) or not value.startswith("when "):
            told = Message("say when it closes: {closes}: at start, or {closes}: when x = d", closes=CLOSES)
            source.names.problem(told, "connections", name, CLOSES)
            continue
        event = read_event(source.names, happening(value), ("connections", name, CLOSES))
        if event is not None:
            found[name] = event
    return found


def _closings(source: Source) -> Iterator[tuple[str, object]]:
    """What the model says of the connections that close."""
    for name, entry in source.mapping("connections").items():
        if isinstance(entry, dict) and CLOSES in entry:
            yield name, cast("dict[str, Any]", entry)[CLOSES]


def parted(
    names: Names, held: Sequence[ConstraintRow], closing: Container[str]
) -> tuple[list[ConstraintRow], list[ConstraintRow]]:
    """The rows that are held from the start on, and those that close in mid-motion."""
    later = [row for row in held if row.connection in closing]
    for row in later:
        told = None
        if row.unilateral or row.needs:
            told = Message(
                "{connection} can only pull, or only push, and closes by itself where it is reached; a string that is "
                "slack at first is given its length by a stop",
                connection=row.connection,
            )
        elif row.is_driven:
            told = Message("{connection} is driven in time, and cannot close in mid-motion", connection=row.connection)
        elif names.space:
            told = Message("connections close in mid-motion in models of the plane only; in space write at start")
        if told is not None:
            names.problem(told, "connections", row.connection, CLOSES)
    return [row for row in held if row.connection not in closing], later


def read_rows(
    names: Names,
    connections: Mapping[str, Connection],
    closing: Container[str] = (),
    later: Container[str] = (),
) -> tuple[list[ConstraintRow], list[tuple[str, Measure]]]:
    """The rows that connections hold, and the measures that they offer. closing, later: connections that close at the
    start, and in mid-motion."""
    rows: list[ConstraintRow] = []
    offered: list[tuple[str, Measure]] = []
    for name, connection in connections.items():
        with names.reading("connections", name, connection.kind):
            n_before = len(names.problems)
            if names.space and connection.is_in_plane(names):
                _check_plane(names, connection, connections)
            held = connection.rows(names)
            if (name in closing or name in later) and not held and len(names.problems) == n_before:
                told = Message("a {kind} holds nothing by itself that could close", kind=connection.kind)
                names.problem(told)
            rows += [_in_numbers(names, replace(row, connection=name, closes=name in closing)) for row in held]
            if len(names.problems) == n_before:
                offered += [(offered_name(name, key, m), m) for key, m in connection.offers(names)]
    if names.problems:
        return rows, offered
    swinging = (name for name in connections if not names.measures and name not in closing and name not in later)
    offered += [(offered_name(name, "angle", m), m) for name in swinging for m in _swung(names, name, connections)]
    kept = [row for row in rows if not row.if_needed]
    always = tuple(row for row in kept if row.connection not in later)
    for row in sorted(rows, key=lambda row: row.name):
        if not row.if_needed or any(row.measure == other.measure for other in kept):
            continue
        if not is_distance_kept(names.bodies, always, row.measure):
            kept.append(row)
    order = {id(row): k for k, row in enumerate(rows)}
    return sorted(kept, key=lambda row: order[id(row)]), offered


def _swung(names: Names, name: str, connections: Mapping[str, Connection]) -> Iterator[Measure]:
    """How far a link or a string between a point of the ground and a particle that nothing else holds is turned from
    hanging straight down."""
    ends = connections[name].straight_between(names)
    if ends is None or names.space:
        return
    fixed, free = sorted(ends, key=lambda end: not names.known(end.body).fixed)
    held = [other for other, one in connections.items() if free.body in one.mentions(names)]
    if names.known(fixed.body).fixed and not names.known(free.body).turns and held == [name]:
        yield Bearing(fixed, free, GROUND, direction_angle(names.compass["down"]))


def read_feet(names: Names, connections: Mapping[str, Connection]) -> dict[str, CurvePlace | SurfacePlace]:
    """Where connections keep points beside curves and surfaces; what is wrong with them their rows have told."""
    with names.quietly():
        found = {name: connection.foot(names) for name, connection in connections.items()}
    return {name: place for name, place in found.items() if place is not None}


def read_attitudes(names: Names, connections: Mapping[str, Connection]) -> tuple[Attitude, ...]:
    """How the joints of space let bodies turn."""
    found = ((name, connection.attitude(names)) for name, connection in connections.items())
    return tuple(replace(a, connection=name) for name, a in found if a is not None)


def _check_plane(names: Names, connection: Connection, connections: Mapping[str, Connection]) -> None:
    """In space, connections of the plane join bodies that stay in it."""
    flat = {body for c in connections.values() if c.keeps_flat(names) for body in c.mentions(names)}
    free = sorted(b for b in connection.mentions(names) - flat if not names.known(b).fixed)
    if free and connection.in_space_take is not None:
        told = Message(
            "{kind} is a connection of the plane: in space {instead}. Or hold {names} in the plane of x and y by a "
            "planar joint",
            kind=connection.kind,
            instead=connection.in_space_take,
            names=", ".join(free),
        )
        names.problem(told)
    elif free:
        names.problem(
            Message(
                "{kind} is a connection of the plane; in space it joins bodies that stay in the plane of "
                "x and y: hold {names} there by a planar joint, or use a joint of space (revolute, "
                "spherical, prismatic, cylindrical, universal ...)",
                kind=connection.kind,
                names=", ".join(free),
            )
        )


def read_bounds(
    names: Names, connections: Mapping[str, Connection], later: Container[str] = ()
) -> tuple[tuple[OutlinePair, ...], tuple[UnilateralConstraint, ...], tuple[DryFriction, ...]]:
    """What may touch, other limits, and dry friction. later: connections that close in mid-motion."""
    contacts: list[OutlinePair] = []
    limits: list[UnilateralConstraint] = []
    brakes: list[DryFriction] = []
    by_form = forms(names)
    for name, connection in connections.items():
        with names.reading("connections", name, connection.kind):
            contacts += connection.pairs(names, name)
            bounds, dry_friction = connection.bounds(names, name)
            if name in later and (bounds or dry_friction):
                told = Message("a connection that closes in mid-motion has no friction and no limits; leave them out")
                names.problem(told)
            limits += (replace(bound, row=_in_numbers(names, bound.row)) for bound in bounds)
            for rub in dry_friction:
                static, kinetic = (substitute(e, by_form) for e in (rub.static, rub.kinetic))
                brakes.append(replace(rub, static=static, kinetic=kinetic))
    return tuple(contacts), tuple(limits), tuple(brakes)


def _in_numbers(names: Names, row: ConstraintRow) -> ConstraintRow:
    """A row with the forms of functions of time in its target."""
    by_form = forms(names)
    if row.target is None or not free_symbols(row.target) & by_form.keys():
        return row
    return replace(row, target=substitute(row.target, by_form), general=row.target)


def rows_to_ask_for(
    contacts: tuple[OutlinePair, ...], limits: tuple[UnilateralConstraint, ...], brakes: tuple[DryFriction, ...]
) -> list[ConstraintRow]:
    """Rows that questions can name; of a crowd of contacts nobody asks for one."""
    bounds, dry_friction = list(limits), list(brakes)
    for pair in contacts if len(contacts) <= MOST_ASKED else ():
        more_bounds, more_rubs = pair.elements()
        bounds += more_bounds
        dry_friction += more_rubs
    return [*(bound.row for bound in bounds), *(row for rub in dry_friction for row in rub.rows)]
