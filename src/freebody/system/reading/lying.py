"""A rod of which nothing says how it is turned, and which what holds it keeps as it is put: it lies level.

A cable to the tip of a boom, a weld and a link without a length keep what they find at the start. Where nothing but
those keeps a rod on its hinge from turning, its angle is one that nobody has given: it is zero, which is told. A ladder
between a wall and the floor would slide down to that angle: it has to be asked for.
"""

from __future__ import annotations

from collections.abc import Sequence

from freebody.connections.standing import is_parallel
from freebody.language.sentences import Message
from freebody.measures.geometry import GROUND
from freebody.model.elements import ConstraintRow, NonholonomicForm, RigidBody
from freebody.model.names import Names

_OF_A_HINGE = 2  # rows


def tell_what_lies_level(names: Names, held: Sequence[ConstraintRow]) -> None:
    """Notes an assumption for each rod that lies level because nothing else is said."""
    if names.space:
        return
    measured = {body for measure in names.measures.values() for body in measure.bodies()}
    kept = [row for row in held if not row.closes]
    for body in names.bodies.values():
        if body.name in measured | names.hung or not _is_open_rod(body):
            continue
        own = [row for row in kept if body.name in row.measure.bodies()]
        as_found = [row for row in own if _keeps_what_it_finds(row)]
        if not own and _leans(names, body):
            told = Message(
                "nothing says how steep {body} stands: write e.g. {body}: {{angle: 60 deg}}, from right to {end} as "
                "seen from {start}",
                body=body.name,
                start=f"{body.name}.start",
                end=f"{body.name}.end",
            )
            names.problem(told, "bodies", body.name)
        if as_found and len(own) - len(as_found) <= _OF_A_HINGE:
            told = Message(
                "nothing says how {body} is turned: it lies level, {start} to the left (else say its angle, {body}: "
                "{{angle: 30 deg}})",
                body=body.name,
                start=f"{body.name}.start",
            )
            names.assumptions.append(told)


def _is_open_rod(body: RigidBody) -> bool:
    """Whether it is a rod whose angle the file leaves open."""
    start = body.start
    is_rod = body.name != GROUND and body.turns and not body.fixed and body.corners == ("start", "end")
    return is_rod and start.angle is None and start.near is None and not start.turned


def _leans(names: Names, body: RigidBody) -> bool:
    """Whether it touches two lines of the ground that are not parallel."""
    found = [connection.lies_along(names, body.name) for connection in names.connections.values()]
    along = [direction for direction in found if direction is not None]
    return any(not is_parallel(names, along[0], other) for other in along[1:])


def _keeps_what_it_finds(row: ConstraintRow) -> bool:
    return row.target is None and not isinstance(row.measure, NonholonomicForm) and row.measure.incremental
