"""Where points stand that nothing moves along a direction: the place of an axle, of a guide, of what hangs.

A connection that keeps a point from moving along a direction of the ground says where (`Connection.keeps_at`): a pin by
the point it joins, a guide across itself, a string with leads of constant directions beside the pulley. What it says is
read from the model alone, in its parameters.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from freebody.language.expression import Call, Expr, add, evaluate, multiply, negate
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import AXES, GROUND, ONE, ZERO, Direction, Point
from freebody.model.elements import RigidBody
from freebody.tolerances import ROUND_OFF

if TYPE_CHECKING:
    from freebody.model.names import Names

_AS_WRITTEN = 1e-2  # of a length: with three digits it is meant to be the same
_TRIALS = (0.3, 0.7)  # what parameters without a value are taken to be, where directions and places are compared


def stands_at(names: Names, point: Point, along: Direction, seen: frozenset[str] = frozenset()) -> Expr | None:
    """How far along a direction of the ground a point is from its origin, where nothing moves it that way; None where
    the model does not tell. seen: bodies whose places are being asked for."""
    body = names.known(point.body)
    if body.name in seen or body.is_placeholder:
        return None
    if body.name == GROUND:
        nowhere = names.free_ground_points if len(names.free_ground_points) > 1 else {}  # a single one is the origin
        return None if point.name.rpartition(".")[2] in nowhere else along_of(point.offset, along)
    if body.fixed:
        return _of_fixed(body, point, along)
    if names.standing is None:
        return _kept_at(names, point, along, seen)
    # nothing changes while the way of a string is being found, but which strings place nothing yet
    key = (point.body, point.offset, along, seen, tuple(id(string) for string in names.laying))
    if key not in names.standing:
        names.standing[key] = _kept_at(names, point, along, seen)
    return names.standing[key]


def _kept_at(names: Names, point: Point, along: Direction, seen: frozenset[str]) -> Expr | None:
    """Where the connections of a body keep a point of it."""
    for connection in names.connections.values():
        place = connection.keeps_at(names, point, along, seen | {point.body})
        if place is not None:
            return place
    return None


def along_of(components: tuple[Expr, ...], along: Direction) -> Expr:
    """The component of a ground vector along a direction."""
    return add(*(multiply(c, e) for c, e in zip(components, along.components, strict=False)))


def _of_fixed(body: RigidBody, point: Point, along: Direction) -> Expr | None:
    start = body.start
    if start.at is None:
        return along_of(point.offset, along) if start.angle is None and not start.turned else None
    name, place = start.at
    if body.points[name] == point.offset:
        return along_of(place, along)
    if start.angle is not None or start.turned:
        return None
    moved = tuple(add(p, o, -q) for p, o, q in zip(place, point.offset, body.points[name], strict=True))
    return along_of(moved, along)


def place_of(names: Names, point: Point) -> tuple[float, ...] | None:
    """Where a point is at the start in numbers, if the model says so: by its body's `at`, or by what holds it."""
    body = names.known(point.body)
    if body.start.at is not None and not body.fixed:
        name, place = body.start.at
        if body.points[name] != point.offset:
            return None
        return tuple(number_of(names, x) for x in place)
    along = [stands_at(names, point, axis) for axis in (AXES if names.space else AXES[:2])]
    found = tuple(number_of(names, x) for x in along if x is not None)
    return found if len(found) == len(along) else None


def starts_at(names: Names, point: Point, along: Direction) -> Expr | None:
    """How far along a direction of the ground a point is from its origin at the start: where it is held, where its body
    is put or lies on a line, or where the file lets a named measure of it start."""
    body = names.known(point.body)
    if body.start.at is not None and not body.fixed:
        name, place = body.start.at
        return along_of(place, along) if body.points[name] == point.offset else None
    if (held := stands_at(names, point, along)) is not None:
        return held
    borne = (connection.bears_at(names, point, along) for connection in names.connections.values())
    if (place := next((x for x in borne if x is not None), None)) is not None:
        return place
    return begins_at(names, point, along)


def begins_at(names: Names, point: Point, along: Direction) -> Expr | None:
    """How far along a direction of the ground the file lets a named measure of a point start."""
    named = ((names.measures.get(name), begun) for name, begun in names.placed_at_start.items())
    places = (begun_by(names, measure, begun, point, along) for measure, begun in named)
    return next((place for place in places if place is not None), None)


def begun_by(names: Names, measure: object, begun: Expr, point: Point, along: Direction) -> Expr | None:
    """How far along a direction of the ground a point is where a measure has a value; None where the measure is no
    displacement of the point that way."""
    if not isinstance(measure, Displacement) or measure.origin.body != GROUND:
        return None
    is_of_point = (measure.of.body, measure.of.offset) == (point.body, point.offset)
    if not is_of_point or not is_parallel(names, measure.along, along):
        return None
    sense = ONE if same_way(names, measure.along, along) else negate(ONE)
    return add(along_of(measure.origin.offset, along), multiply(sense, begun))


def begins_without_turning(names: Names, point: Point, along: Direction) -> Expr | None:
    """How far along a direction of the ground a point of a body that does not turn starts: as the body is put, or as
    a measure of it starts or is driven."""
    body = names.known(point.body)
    if body.start.at is not None and not body.fixed:
        named, place = body.start.at
        arm = arm_on_ground(body, body.points[named], point.offset)
        return along_of(tuple(add(p, a) for p, a in zip(place, arm, strict=True)), along)
    if (held := stands_at(names, point, along)) is not None:
        return held
    measured = (m.of for m in names.measures.values() if isinstance(m, Displacement) and m.of.body == body.name)
    for own in dict.fromkeys((point, *measured)):
        borne = (connection.bears_at(names, own, along) for connection in names.connections.values())
        begun = next((x for x in borne if x is not None), None) or begins_at(names, own, along)
        if begun is not None:
            return add(begun, along_of(arm_on_ground(body, own.offset, point.offset), along))
    return None


def arm_on_ground(body: RigidBody, start: tuple[Expr, ...], end: tuple[Expr, ...]) -> tuple[Expr, ...]:
    """From one point of a body that does not turn to another one, by components of the ground, in the plane."""
    x, y, *_ = (add(q, negate(p)) for p, q in zip(start, end, strict=True))
    if body.start.angle is None:
        return x, y
    cos, sin = (Call(name, body.start.angle) for name in ("cos", "sin"))
    return add(multiply(cos, x), negate(multiply(sin, y))), add(multiply(sin, x), multiply(cos, y))


def moves_out_of_plane(names: Names, bodies: Iterable[str]) -> bool:
    """In space: whether one of the bodies moves, and nothing keeps it in the plane of x and y."""
    flat = {body for c in names.connections.values() if c.keeps_flat(names) for body in c.mentions(names)}
    return any(not names.bodies[b].fixed and b not in flat for b in bodies)


def distance_between(names: Names, first: Point, second: Point) -> float | None:
    """How far two points are apart at the start in numbers [m], if the model says so and no parameter is open."""
    if any(p.value is None and p.form is None for p in names.parameters.values()):
        return None
    places = place_of(names, first), place_of(names, second)
    return None if places[0] is None or places[1] is None else math.dist(places[0], places[1])


def ground_guide_of(names: Names, body: str, *, turning: bool) -> Direction | None:
    """The direction of the ground along which a connection guides a body. turning: also where it may turn."""
    with names.quietly():  # of a guide they are told where it stands
        found = [connection.guide_of(names, body, turning=turning) for connection in names.connections.values()]
    return next((along for along in found if along is not None), None)


def carriage_point(names: Names, point: Point) -> Point | None:
    """The point of a guided body on which a point turns that goes with it: of a trolley that of the axle of a wheel."""
    found = (connection.carried_by(names, point) for connection in names.connections.values())
    return next((other for other in found if other is not None), None)


def carriage_line(names: Names, point: Point) -> Direction | None:
    """The direction of the ground along which a point goes with the guided body on which it turns."""
    other = carriage_point(names, point)
    return None if other is None else ground_guide_of(names, other.body, turning=False)


def apart_at_start(names: Names, first: Point, second: Point, along: Direction) -> Expr | None:
    """How far a point is from another one along a direction of the ground at the start: where both are carried by one
    body, or by where both start."""
    carried = carriage_point(names, first), carriage_point(names, second)
    if carried[0] is not None and carried[1] is not None and carried[0].body == carried[1].body:
        body = names.known(carried[0].body)
        return along_of(arm_on_ground(body, carried[0].offset, carried[1].offset), along)
    start, end = (starts_at(names, point, along) for point in (first, second))
    return None if start is None or end is None else add(end, negate(start))


def ground_pivot_of(names: Names, body: str) -> Point | None:
    """The point of the ground about which a body turns, if one connection pins it there."""
    joined = (connection.joined_points(names) for connection in names.connections.values())
    ends = [pair for pair in joined if pair is not None]
    turned = [*ends, *((second, first) for first, second in ends)]
    return next((own for own, other in turned if own.body == GROUND and other.body == body), None)


def ground_line_under(names: Names, body: str) -> Direction | None:
    """The direction of a line of the ground that bears a body, if it bears one and nothing is said of its velocity."""
    if names.known(body).start.velocity is not None:
        return None
    found = (connection.lies_along(names, body) for connection in names.connections.values())
    return next((along for along in found if along is not None), None)


def is_near(length: float, other: float) -> bool:
    """Whether two lengths that people have written are meant to be the same."""
    return abs(length - other) <= _AS_WRITTEN * max(abs(length), abs(other))


def is_parallel(names: Names, first: Direction, second: Direction) -> bool:
    """Whether two directions of the ground are on one line."""
    return first.body == second.body and all(is_zero(names, x) for x in _cross(first, second))


def same_way(names: Names, first: Direction, second: Direction) -> bool:
    """Whether two parallel directions of the ground point the same way."""
    return number_of(names, along_of(first.components, second)) > 0


def _cross(first: Direction, second: Direction) -> Iterator[Expr]:
    """The components of the vector product, which in the plane is the last one."""
    a, b = ((*d.components, ZERO)[:3] for d in (first, second))
    for i, j in ((1, 2), (2, 0), (0, 1)):
        yield add(multiply(a[i], b[j]), -multiply(a[j], b[i]))


def is_zero(names: Names, x: Expr) -> bool:
    """Whether an expression in the parameters vanishes at the model's values, or at two sets of arbitrary ones."""
    return all(abs(number_of(names, x, trial)) < ROUND_OFF for trial in _TRIALS)


def vanishes(names: Names, x: Expr) -> bool:
    """Whether an expression in the parameters is zero whatever their values are, not at those of the model alone."""
    return all(abs(number_of(names, x, stretch=stretch)) < ROUND_OFF for stretch in (0.0, 0.03, 0.07))


def number_of(names: Names, x: Expr, trial: float = _TRIALS[0], stretch: float = 0.0) -> float:
    """An expression in numbers; parameters without a value are taken small, positive and different. stretch: by which
    share the first parameter is larger than its value, the second by twice that, and so on."""
    given = names.numbers_in(x)
    values = {
        name: given.get(name, trial + 0.1 * k / (k + 1)) * (1.0 + stretch * (k + 1))
        for k, name in enumerate(names.parameters)
    }
    return float(evaluate(x, values))
