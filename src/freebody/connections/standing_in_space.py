"""What stands still in space: directions that joints keep, angles about them, and places along them.

A joint that says how it lets its bodies turn (`Attitude`) carries a direction from one to the other if it does not turn
them, or about that direction alone. So a direction of the ground is one of every body that gets to it by such joints,
and how far that body has turned about it is the sum of their angles. Along a direction that does not turn, a point is
where the rows of a joint put it beside a point of the other body.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations
from typing import TYPE_CHECKING

from freebody.connections.standing import is_zero, number_of
from freebody.language.expression import Expr, add, multiply, negate
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, ONE, ZERO, Components, Direction, Point
from freebody.model.elements import Attitude, RigidBody
from freebody.model.rotations import (
    UNIT,
    applied,
    columns_of,
    dot,
    perpendiculars,
    product,
    reversed_,
    rotation,
    transposed,
    vector_product,
)

if TYPE_CHECKING:
    from freebody.model.names import Joining, Names

AngleTerms = tuple[tuple[Expr, Measure], ...]
# what keeps a point in two directions: three of them at the most are looked at
_MOST_DIRECTIONS = 3


@dataclass(frozen=True)
class KeptDirection:
    """A direction as a body carries it, and by how much that body has turned about it."""

    components: Components
    turned: AngleTerms = ()


def carried(names: Names, along: Direction) -> dict[str, KeptDirection]:
    """A direction on all bodies that keep it, by name; their angles are counted from its own body."""
    components = (*along.components, ZERO)[:3]  # those of the plane have two
    found = {along.body: KeptDirection(components)}
    flat = _flat(names)
    waiting = [along.body]
    while waiting:
        body = waiting.pop()
        for other, kept in _neighbours(names, body, found[body], flat):
            if other not in found:
                found[other] = kept
                waiting.append(other)
    return found


def on_ground(names: Names, along: Direction) -> tuple[Direction, AngleTerms] | None:
    """The direction of the ground along which one of a body stays, and by how much the body has turned about it; None
    where it does not stay."""
    here = carried(names, along).get(GROUND)
    if here is None:
        return None
    turned = tuple((negate(share), angle) for share, angle in here.turned)
    return Direction(GROUND, here.components, along.name), turned


def _flat(names: Names) -> set[str]:
    return {body for c in names.connections.values() if c.keeps_flat(names) for body in c.mentions(names)}


def _neighbours(names: Names, body: str, kept: KeptDirection, flat: set[str]) -> Iterator[tuple[str, KeptDirection]]:
    """The bodies that joints turn against this one about the direction alone, or not at all."""
    if body == GROUND:
        for other in names.bodies.values():
            if other.fixed and other.name != GROUND:
                yield other.name, KeptDirection(applied(transposed(_of_fixed(other)), kept.components), kept.turned)
            elif other.name in flat and other.turns and _is_along_z(names, kept.components):
                share = ONE if number_of(names, kept.components[2]) > 0.0 else negate(ONE)
                yield other.name, KeptDirection(kept.components, (*kept.turned, (share, Angle(other.name))))
    elif names.known(body).fixed:
        yield GROUND, KeptDirection(applied(_of_fixed(names.known(body)), kept.components), kept.turned)
    elif body in flat and _is_along_z(names, kept.components):
        share = negate(ONE) if number_of(names, kept.components[2]) > 0.0 else ONE
        yield GROUND, KeptDirection(kept.components, (*kept.turned, (share, Angle(body))))
    for connection in _joints_of(names, body):
        attitude = connection.attitude(names)
        if attitude is not None and body in (attitude.first, attitude.second):
            beyond = _beyond(names, attitude, body, kept)
            if beyond is not None:
                yield beyond


def _is_along_z(names: Names, v: Components) -> bool:
    return is_zero(names, v[0]) and is_zero(names, v[1])


def _of_fixed(body: RigidBody) -> tuple[Components, Components, Components]:
    """The axes of a body that is fixed, on the ground."""
    return UNIT if body.start.turned is None else columns_of(body.start.turned)


def _joints_of(names: Names, body: str) -> Iterator[Joining]:
    """What joins a body to others from the start on and holds its places: strings, which hang on these, do not."""
    for name, connection in names.connections.items():
        if name not in names.closing_later and not connection.lets_hang and body in connection.mentions(names):
            yield connection


def _beyond(names: Names, attitude: Attitude, body: str, kept: KeptDirection) -> tuple[str, KeptDirection] | None:
    """The direction on the other body of a joint."""
    if len(attitude.turns) > 1:
        return None
    is_first = body == attitude.first
    own, others = (attitude.before, attitude.after) if is_first else (attitude.after, attitude.before)
    seen = applied(transposed(own), kept.components)
    turned = kept.turned
    if attitude.turns:
        ((axis, _name, angle),) = attitude.turns
        if any(not is_zero(names, c) for c in vector_product(seen, axis)):
            return None
        is_along = (number_of(names, dot(seen, axis)) > 0.0) == is_first
        turned = (*turned, (ONE if is_along else negate(ONE), angle))
    other = attitude.second if is_first else attitude.first
    return other, KeptDirection(applied(others, seen), turned)


# -- places along a direction -------------------------------------------------------------------
@dataclass(frozen=True)
class Standing:
    """How far along a direction of the ground a point is from a body's reference point, or on the ground its origin."""

    body: str
    far: Expr


def standing(names: Names, point: Point, along: Direction) -> Standing:
    """Where joints keep a point along a direction of the ground: on the ground, where they do, else beside the first
    body that moves that way."""
    kept = carried(names, along)
    return _standing(names, point, along, kept, frozenset())


def _standing(
    names: Names, point: Point, along: Direction, kept: dict[str, KeptDirection], seen: frozenset[str]
) -> Standing:
    body = names.known(point.body)
    if body.name == GROUND:
        return Standing(GROUND, dot(point.offset, along.components))
    if body.fixed:
        at = _placed(body, point)
        return Standing(body.name, ZERO) if at is None else Standing(GROUND, dot(at, along.components))
    best = _beside(body, point, kept)
    if body.name in seen:
        return best
    for of, origin, target in _held_along(names, body.name, along):
        aside = _between(body, of, point, kept)
        if aside is None:
            continue
        found = _standing(names, origin, along, kept, seen | {body.name})
        here = Standing(found.body, add(found.far, target, aside))
        if found.body == GROUND:
            return here
        if found.body != origin.body or origin.body not in seen:
            best = here
    return best


def _placed(body: RigidBody, point: Point) -> Components | None:
    """Where a point of a fixed body is."""
    axes = _of_fixed(body)
    name, place = body.start.at or (body.default_point, (ZERO, ZERO, ZERO))
    arm = applied(axes, tuple(a - b for a, b in zip(point.offset, body.points[name], strict=True)))
    return tuple(a + b for a, b in zip(place, arm, strict=True))


def _beside(body: RigidBody, point: Point, kept: dict[str, KeptDirection]) -> Standing:
    """A point beside the reference point of its body, where the direction is one of the body; else the point itself
    stands for it, by an offset of zero, which compares with nothing but itself."""
    own = kept.get(body.name)
    if own is not None:
        return Standing(body.name, dot(point.offset, own.components))
    return Standing(f"{body.name} at {point.offset}", ZERO)


def _between(body: RigidBody, start: Point, end: Point, kept: dict[str, KeptDirection]) -> Expr | None:
    """How far one point of a body is from another along the direction; None where that changes."""
    if start.offset == end.offset:
        return ZERO
    own = kept.get(body.name)
    if own is None:
        return None
    return dot(tuple(a - b for a, b in zip(end.offset, start.offset, strict=True)), own.components)


def _held_along(names: Names, body: str, along: Direction) -> Iterator[tuple[Point, Point, Expr]]:
    """The points of a body that joints keep beside others along a direction of the ground, and how far from them: by
    rows along perpendicular directions e_i, in whose span the direction d is, sum (d . e_i) times what they hold."""
    for connection in _joints_of(names, body):
        held: dict[tuple[Point, Point], list[tuple[Components, Expr]]] = {}
        for row in connection.rows(names):
            d = row.measure
            if row.unilateral or row.is_driven or not isinstance(d, Displacement):
                continue
            if body not in (d.of.body, d.origin.body) or d.of.body == d.origin.body:
                continue
            still = on_ground(names, d.along)
            if still is not None and not still[1]:
                held.setdefault((d.of, d.origin), []).append((still[0].components, row.target or ZERO))
        for (of, origin), rows in held.items():
            shares = [dot(along.components, e) for e, _target in rows[:_MOST_DIRECTIONS]]
            rest = add(ONE, *(negate(multiply(s, s)) for s in shares))
            if not is_zero(names, rest):
                continue
            target = add(*(multiply(s, t) for s, (_e, t) in zip(shares, rows, strict=False)))
            yield (of, origin, target) if of.body == body else (origin, of, negate(target))


def distance_along(names: Names, start: Point, end: Point, along: Direction) -> Expr | None:
    """How far the second point is from the first along a direction of the ground, where that never changes."""
    first, second = standing(names, start, along), standing(names, end, along)
    return add(second.far, negate(first.far)) if first.body == second.body else None


def line_of(names: Names, point: Point, normal: Direction) -> Direction | None:
    """The direction of the ground along which a point moves in the plane of a normal, where joints let it move along
    that alone; None also where it does not move."""
    found: list[Components] = []
    for m in _across(names, point, normal):
        is_new = all(any(not is_zero(names, c) for c in vector_product(m, other)) for other in found)
        if is_new and standing(names, point, Direction(GROUND, m)).body == GROUND:
            found.append(m)
    return Direction(GROUND, vector_product(found[0], normal.components)) if len(found) == 1 else None


def _across(names: Names, point: Point, normal: Direction) -> Iterator[Components]:
    """Directions of a plane in which joints may keep a point: those of their rows, and what is across the line which
    two rows leave it."""
    n = normal.components
    yield from perpendiculars(n)
    for connection in _joints_of(names, point.body):
        rows = (row.measure for row in connection.rows(names))
        still = (on_ground(names, d.along) for d in rows if isinstance(d, Displacement))
        held = [found[0].components for found in still if found is not None]
        yield from (e for e in held if is_zero(names, dot(e, n)))
        for one, other in combinations(held, 2):
            line = vector_product(one, other)
            if is_zero(names, dot(one, other)) and is_zero(names, dot(line, n)):
                yield vector_product(n, line)


def started_place(names: Names, point: Point) -> list[float] | None:
    """Where a point starts in numbers, of a body that turns on the ground about one axis by an angle that the file
    lets start: R_2 = R_1 before turn after^T."""
    for connection in _joints_of(names, point.body):
        bearing, attitude = connection.bearing(names), connection.attitude(names)
        if bearing is None or attitude is None or {bearing[0].body, bearing[1].body} != {GROUND, point.body}:
            continue
        ((axis, _name, angle),) = attitude.turns
        begun = (x for name, x in names.placed_at_start.items() if names.measures.get(name) == angle)
        turn = next(begun, None)
        if turn is None or bearing[0].body != GROUND:
            continue
        turned = product(product(attitude.before, rotation(axis, turn)), transposed(attitude.after))
        arm = applied(turned, tuple(a - b for a, b in zip(point.offset, bearing[1].offset, strict=True)))
        return [number_of(names, a + b) for a, b in zip(bearing[0].offset, arm, strict=True)]
    return None


def opposite(along: Direction) -> Direction:
    """The direction against one of the ground, without a name of its own."""
    return Direction(along.body, reversed_(along.components))
