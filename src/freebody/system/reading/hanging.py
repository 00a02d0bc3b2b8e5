"""What is struck, or thrown, where it hangs: a bob on a rod of which the file does not say where it is.

A ballistic pendulum hangs at rest until the bullet comes. Where something strikes or moves at the start, a body that
one link or one hinge alone holds to what stands still, and of whose place nothing is said, hangs along gravity below
the point that holds it, its mass centre lowest. That is taken for granted, and told.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from freebody.connections.standing import number_of, stands_at
from freebody.language.expression import ZERO, Expr, Symbol, add, multiply, negate
from freebody.language.sentences import Message
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Distance
from freebody.measures.geometry import GROUND, Direction, Point
from freebody.measures.turned import points_in
from freebody.model.elements import ConstraintRow, RigidBody, Start
from freebody.model.names import Names
from freebody.model.rotations import UNIT

_QUARTER = Symbol("pi") / 2


def hang_what_is_struck(names: Names, held: Sequence[ConstraintRow], told: Collection[str]) -> None:
    """Gives bodies that hang the place, or the angle, where they do. told: measures with a value at the start."""
    fields = [along for along, _g in names.fields if along.body == GROUND]
    if names.lets_go_from_rest or len(names.fields) != 1 or not fields:
        return
    said = {body for name in told if name in names.measures for body in names.measures[name].bodies()}
    kept = [row for row in held if not row.closes]
    for body in [*names.bodies.values()]:
        own = [row for row in kept if body.name in row.measure.bodies()]
        if body.name in said or body.fixed or body.name == GROUND or not _is_open(body):
            continue
        near = _on_a_hinge(names, body, own, fields[0]) if body.turns else _on_a_link(names, body, own, fields[0])
        if near is not None:
            start, pivot = near
            names.bodies[body.name] = replace(body, start=replace(body.start, near=start))
            names.hung.add(body.name)
            what = Message(
                "nothing says where {body} is at the start: it hangs below {pivot}", body=body.name, pivot=pivot
            )
            names.assumptions.append(what)


def _is_open(body: RigidBody) -> bool:
    """Whether the file says nothing of its place."""
    start = body.start
    return start.at is None and start.angle is None and start.near is None and not start.turned and not body.chain


def _on_a_link(
    names: Names, body: RigidBody, own: Sequence[ConstraintRow], down: Direction
) -> tuple[Start, Point] | None:
    """A particle at the end of a link: its place, and the other end of that."""
    if len(own) != 1 or not isinstance(own[0].measure, Distance) or own[0].target is None:
        return None
    ends = own[0].measure.start, own[0].measure.end
    pivot = next(end for end in ends if end.body != body.name)
    n = len(names.origin)
    axes = [Direction(GROUND, unit[:n]) for unit in UNIT[:n]]
    places = [stands_at(names, pivot, axis) for axis in axes]
    at = [
        add(place, multiply(own[0].target, c))
        for place, c in zip(places, down.components, strict=True)
        if place is not None
    ]
    return (Start(at=(body.default_point, tuple(at))), pivot) if len(at) == len(axes) else None


def _on_a_hinge(
    names: Names, body: RigidBody, own: Sequence[ConstraintRow], down: Direction
) -> tuple[Start, Point] | None:
    """A body of the plane that is hinged to the ground at a point on one of its axes, and all that is joined to it on
    the same side: its angle, and the point of the ground."""
    hinges = [row.measure for row in own if set(row.measure.bodies()) == {body.name, GROUND}]
    if names.space or len(hinges) != 2 or down != names.compass["down"]:
        return None
    first, second = hinges
    if not isinstance(first, Displacement) or not isinstance(second, Displacement):
        return None
    pivots = {point for row in (first, second) for point in (row.of, row.origin)}
    at = {point.offset for point in pivots if point.body == body.name}
    if len(pivots) != 2 or len(at) != 1:
        return None
    (offset,) = at
    others = [p.offset for row in own for p in points_in(row.measure) if p.body == body.name and p.offset != offset]
    for k, quarter in ((0, ZERO), (1, _QUARTER)):
        arms = [[number_of(names, c - o) for c, o in zip(arm, offset, strict=True)] for arm in ((ZERO, ZERO), *others)]
        sides = {arm[k] > 0 for arm in arms}
        if len(sides) == 1 and not any(arm[1 - k] for arm in arms) and arms[0][k]:
            turn: Expr = negate(quarter + _QUARTER) if sides == {True} else _QUARTER - quarter
            return Start(angle=turn), next(point for point in pivots if point.body == GROUND)
    return None
