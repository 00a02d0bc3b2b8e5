"""What stands still in space: directions that joints keep, angles about them, and places along them.

A joint that says how it lets its bodies turn (`Attitude`) carries a direction from one to the other if it does not turn
them, or about that direction alone. So a direction of the ground is one of every body that gets to it by such joints,
and how far that body has turned about it is the sum of their angles. Along a direction that does not turn, a point is
where the rows of a joint put it beside a point of the other body. On what turns, as on the jib of a crane, the same is
asked of its own directions: there the ground is a body as others are.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations
from typing import TYPE_CHECKING

from freebody.connections.standing import is_zero, number_of
from freebody.language.expression import Expr, add, multiply, negate, substitute
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, ONE, ZERO, Components, Direction, Point
from freebody.measures.turn import Alignment
from freebody.model.elements import Attitude, ConstraintRow, NonholonomicForm, RigidBody
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


@dataclass(frozen=True)
class KeptDirection:
    """A direction as a body carries it, and by how much that body has turned about it."""

    components: Components
    turned: AngleTerms = ()


@dataclass(frozen=True)
class Standing:
    """How far along a direction a point is from a body's reference point, or on the ground its origin."""

    body: str
    far: Expr


@dataclass(frozen=True)
class _Joint:
    """A connection that holds places from the start on: strings, which hang on those, do not."""

    connection: Joining
    bodies: frozenset[str]
    attitude: Attitude | None
    displaced: tuple[ConstraintRow, ...]  # rows of displacements


class StandingInSpace:
    """What the joints of a model keep still, read once."""

    def __init__(self, names: Names) -> None:
        self.names = names
        self._kept: dict[tuple[str, Components], dict[str, KeptDirection]] = {}

    @cached_property
    def _joints(self) -> dict[str, list[_Joint]]:
        """The joints of each body."""
        found: dict[str, list[_Joint]] = {name: [] for name in self.names.bodies}
        with self.names.quietly():  # of a joint they are told where it stands
            for name, connection in self.names.connections.items():
                if name in self.names.closing_later or connection.lets_hang or connection.follows_joints:
                    continue
                rows = (row for row in connection.rows(self.names) if isinstance(row.measure, Displacement))
                kept = tuple(row for row in rows if not row.unilateral and not row.is_driven)
                bodies = frozenset(connection.mentions(self.names))
                joint = _Joint(connection, bodies, connection.attitude(self.names), kept)
                for body in bodies & found.keys():
                    found[body].append(joint)
        return found

    @cached_property
    def _flat(self) -> set[str]:
        """The bodies that stay in the plane of x and y."""
        joints = self.names.connections.values()
        return {body for c in joints if c.keeps_flat(self.names) for body in c.mentions(self.names)}

    # -- directions -------------------------------------------------------------------------------
    def carried(self, along: Direction) -> dict[str, KeptDirection]:
        """A direction on all bodies that keep it, by name; their angles are counted from its own body."""
        components = (*along.components, ZERO)[:3]  # those of the plane have two
        key = along.body, components
        if key not in self._kept:
            found = {along.body: KeptDirection(components)}
            waiting = [along.body]
            while waiting:
                body = waiting.pop()
                for other, kept in self._neighbours(body, found[body]):
                    if other not in found:
                        found[other] = kept
                        waiting.append(other)
            self._kept[key] = found
        return self._kept[key]

    def on_ground(self, along: Direction) -> tuple[Direction, AngleTerms] | None:
        """The direction of the ground along which one of a body stays, and by how much the body has turned about it;
        None where it does not stay."""
        return self.on(GROUND, along)

    def on(self, frame: str, along: Direction) -> tuple[Direction, AngleTerms] | None:
        """The direction of a body along which one of another stays, and by how much the other has turned about it on
        that; None where it does not stay."""
        here = self.carried(along).get(frame)
        if here is None:
            return None
        turned = tuple((negate(share), angle) for share, angle in here.turned)
        return Direction(frame, here.components, along.name), turned

    def lowest(self, *directions: Direction) -> str | None:
        """Of the bodies that keep all of these directions, the one that the fewest joints part from the ground."""
        kept = set.intersection(*(set(self.carried(along)) for along in directions))
        order = [name for name in self._depths if name in kept]
        return min(order, key=lambda name: self._depths[name], default=None)

    @cached_property
    def _depths(self) -> dict[str, int]:
        """How many joints part each body from the ground, at least; infinitely many are one more than there are."""
        found = {GROUND: 0} | {name: 0 for name, body in self.names.bodies.items() if body.fixed}
        joints = [joint for joints in self._joints.values() for joint in joints]
        for depth in range(1, len(self.names.bodies) + 1):
            near = {b for joint in joints if joint.bodies & found.keys() for b in joint.bodies} - found.keys()
            found |= dict.fromkeys((name for name in self.names.bodies if name in near), depth)
        return found | {name: len(found) for name in self.names.bodies if name not in found}

    def _neighbours(self, body: str, kept: KeptDirection) -> Iterator[tuple[str, KeptDirection]]:
        """The bodies that joints turn against this one about the direction alone, or not at all."""
        names = self.names
        if body == GROUND:
            for other in names.bodies.values():
                if other.fixed and other.name != GROUND:
                    yield (
                        other.name,
                        KeptDirection(applied(transposed(axes_at_start(other)), kept.components), kept.turned),
                    )
                elif other.name in self._flat and other.turns and self._is_along_z(kept.components):
                    share = ONE if number_of(names, kept.components[2]) > 0.0 else negate(ONE)
                    yield other.name, KeptDirection(kept.components, (*kept.turned, (share, Angle(other.name))))
        elif names.known(body).fixed:
            yield GROUND, KeptDirection(applied(axes_at_start(names.known(body)), kept.components), kept.turned)
        elif body in self._flat and self._is_along_z(kept.components):
            share = negate(ONE) if number_of(names, kept.components[2]) > 0.0 else ONE
            yield GROUND, KeptDirection(kept.components, (*kept.turned, (share, Angle(body))))
        for joint in self._joints.get(body, ()):
            if joint.attitude is not None and body in (joint.attitude.first, joint.attitude.second):
                beyond = self._beyond(joint.attitude, body, kept)
                if beyond is not None:
                    yield beyond

    def _is_along_z(self, v: Components) -> bool:
        return is_zero(self.names, v[0]) and is_zero(self.names, v[1])

    def _beyond(self, attitude: Attitude, body: str, kept: KeptDirection) -> tuple[str, KeptDirection] | None:
        """The direction on the other body of a joint."""
        if len(attitude.turns) > 1:
            return None
        is_first = body == attitude.first
        own, others = (attitude.before, attitude.after) if is_first else (attitude.after, attitude.before)
        seen, turned = applied(transposed(own), kept.components), kept.turned
        if attitude.turns:
            ((axis, _name, angle),) = attitude.turns
            if any(not is_zero(self.names, c) for c in vector_product(seen, axis)):
                return None
            is_along = (number_of(self.names, dot(seen, axis)) > 0.0) == is_first
            turned = (*turned, (ONE if is_along else negate(ONE), angle))
        other = attitude.second if is_first else attitude.first
        if not attitude.turns:  # -b . c' is zero, of the rate w . n: with it nothing that turns a wheel acts on this
            b, c = perpendiculars(kept.components)
            beyond = Direction(other, applied(others, applied(transposed(own), c)))
            turned = (*turned, (negate(ONE), Alignment(beyond, Direction(body, b))))
        return other, KeptDirection(applied(others, seen), turned)

    # -- places along a direction -------------------------------------------------------------------
    def standing(self, point: Point, along: Direction) -> Standing:
        """Where joints keep a point along a direction: on the body whose direction it is, where they do, else beside
        the first body that moves that way."""
        return self._standing(point, along, frozenset())

    def _standing(self, point: Point, along: Direction, seen: frozenset[str]) -> Standing:
        body = self.names.known(point.body)
        if body.name == along.body:
            return Standing(along.body, dot(point.offset, (*along.components, ZERO)[:3]))
        if body.fixed and body.name != GROUND and along.body == GROUND:
            return Standing(GROUND, dot(placed_at_start(body, point), along.components))
        best = self._beside(body, point, along)
        if body.name in seen:
            return best
        for of, origin, target in self._held_along(body.name, along):
            aside = self._between(body, of, point, along)
            if aside is None:
                continue
            found = self._standing(origin, along, seen | {body.name})
            here = Standing(found.body, add(found.far, target, aside))
            if found.body == along.body:
                return here
            if found.body != origin.body or origin.body not in seen:
                best = here
        return best

    def _beside(self, body: RigidBody, point: Point, along: Direction) -> Standing:
        """A point beside the reference point of its body, where the direction is one of the body; else the point itself
        stands for it, by an offset of zero, which compares with nothing but itself."""
        own = self.carried(along).get(body.name)
        if own is not None:
            return Standing(body.name, dot(point.offset, own.components))
        return Standing(f"{body.name} at {point.offset}", ZERO)

    def _between(self, body: RigidBody, start: Point, end: Point, along: Direction) -> Expr | None:
        """How far one point of a body is from another along the direction; None where that changes: where the body
        keeps neither that nor, as the axis about which it turns, the line through both."""
        if start.offset == end.offset:
            return ZERO
        arm = tuple(a - b for a, b in zip(end.offset, start.offset, strict=True))
        own = self.carried(along).get(body.name)
        if own is not None:
            return dot(arm, own.components)
        kept = self.on(along.body, Direction(body.name, arm))
        return None if kept is None else dot(kept[0].components, (*along.components, ZERO)[:3])

    def _held_along(self, body: str, along: Direction) -> Iterator[tuple[Point, Point, Expr]]:
        """The points of a body that joints keep beside others along a direction, and how far from them: by rows along
        perpendicular directions e_i, in whose span the direction d is, sum (d . e_i) times what they hold. Points that
        coincide do so along any direction."""
        for joint in self._joints.get(body, ()):
            held: dict[tuple[Point, Point], list[tuple[Components, Expr]]] = {}
            n_met: dict[tuple[Point, Point], int] = {}
            for row in joint.displaced:
                d = row.measure
                assert isinstance(d, Displacement)
                if body not in (d.of.body, d.origin.body) or d.of.body == d.origin.body:
                    continue
                if row.target is None and d.along.body == GROUND and d.along.components in UNIT:
                    n_met[d.of, d.origin] = n_met.get((d.of, d.origin), 0) + 1
                still = self.on(along.body, d.along)
                if still is not None:
                    held.setdefault((d.of, d.origin), []).append((still[0].components, row.target or ZERO))
            for of, origin in (pair for pair, n in n_met.items() if n == len(UNIT)):
                yield (of, origin, ZERO) if of.body == body else (origin, of, ZERO)
            for (of, origin), rows in held.items():
                shares = [dot(along.components, e) for e, _target in rows]
                if not is_zero(self.names, add(ONE, *(negate(multiply(s, s)) for s in shares))):
                    continue
                target = add(*(multiply(s, t) for s, (_e, t) in zip(shares, rows, strict=True)))
                yield (of, origin, target) if of.body == body else (origin, of, negate(target))

    def distance_along(self, start: Point, end: Point, along: Direction) -> Expr | None:
        """How far the second point is from the first along a direction, where that never changes."""
        first, second = self.standing(start, along), self.standing(end, along)
        return add(second.far, negate(first.far)) if first.body == second.body else None

    def begins(self, point: Point, along: Direction) -> Expr | None:
        """How far along a direction a point is at the start from the origin of the body that keeps that: where joints
        hold it, or where a named measure or a driver lets what carries it start."""
        place = self.standing(point, along)
        if place.body == along.body:
            return place.far
        for measure, begun in self._beginnings:
            if not isinstance(measure, Displacement):
                continue
            seen = self.on(along.body, measure.along)
            if seen is None or not self._are_parallel(seen[0], along):
                continue
            of, origin = self.standing(measure.of, along), self.standing(measure.origin, along)
            if of.body == place.body and origin.body == along.body:
                way = multiply(dot(seen[0].components, along.components), begun)
                return add(origin.far, way, place.far, negate(of.far))
        return None

    def _are_parallel(self, first: Direction, second: Direction) -> bool:
        return all(is_zero(self.names, c) for c in vector_product(first.components, second.components))

    @cached_property
    def _beginnings(self) -> list[tuple[Measure, Expr]]:
        """Measures with where they start: those that the file lets start somewhere, and those that drivers move."""
        names = self.names
        joints = [c for c in names.connections.values() if not (c.lets_hang or c.follows_joints)]
        with names.quietly():
            rows = [row for c in joints for row in c.rows(names)]
        driving = (row for row in rows if row.reaction.startswith("driving "))
        driven = ((row.measure, substitute(row.target or ZERO, {"t": ZERO})) for row in driving)
        named = ((names.measures.get(name), begun) for name, begun in names.placed_at_start.items())
        begun = [*named, *driven]
        return [(m, place) for m, place in begun if m is not None and not isinstance(m, NonholonomicForm)]

    def line_of(self, point: Point, normal: Direction) -> Direction | None:
        """The direction along which a point moves in the plane of a normal, seen from the body of that, where joints
        let it move along that alone; None also where it does not move."""
        found: list[Components] = []
        for m in self._across(point, normal):
            is_new = all(any(not is_zero(self.names, c) for c in vector_product(m, other)) for other in found)
            if is_new and self.standing(point, Direction(normal.body, m)).body == normal.body:
                found.append(m)
        return Direction(normal.body, vector_product(found[0], normal.components)) if len(found) == 1 else None

    def _across(self, point: Point, normal: Direction) -> Iterator[Components]:
        """Directions of a plane in which joints may keep a point: those of their rows, and what is across the line
        which two rows leave it."""
        n = normal.components
        yield from perpendiculars(n)
        for joint in self._joints.get(point.body, ()):
            rows = (row.measure for row in joint.displaced)
            still = (self.on(normal.body, d.along) for d in rows if isinstance(d, Displacement))
            held = [found[0].components for found in still if found is not None]
            yield from (e for e in held if is_zero(self.names, dot(e, n)))
            for one, other in combinations(held, 2):
                line = vector_product(one, other)
                if is_zero(self.names, dot(one, other)) and is_zero(self.names, dot(line, n)):
                    yield vector_product(n, line)

    def started(self, point: Point, frame: str = GROUND, seen: frozenset[str] = frozenset()) -> list[float] | None:
        """Where a point starts in numbers, as a body sees it, of one that turns on that about one axis by an angle that
        the file lets start, R_2 = R_1 before turn after^T, or that is joined to such a one there."""
        names = self.names
        held = [self.standing(point, Direction(frame, axis)) for axis in UNIT]
        if all(place.body == frame for place in held):
            return [number_of(names, place.far) for place in held]
        for joint in self._joints.get(point.body, ()):
            bearing, attitude = joint.connection.bearing(names), joint.attitude
            if bearing is None or attitude is None or bearing[0].body == point.body:
                continue
            first, second = bearing[:2]
            turn = self._turned_at_start(attitude) if first.body == frame else None
            if turn is not None:
                ((axis, _name, _angle),) = attitude.turns
                turned = product(product(attitude.before, rotation(axis, turn)), transposed(attitude.after))
                arm = applied(turned, tuple(a - b for a, b in zip(point.offset, second.offset, strict=True)))
                return [number_of(names, a + b) for a, b in zip(first.offset, arm, strict=True)]
            if second.offset == point.offset and first.body not in seen | {frame}:
                return self.started(first, frame, seen | {point.body})
        return None

    def _turned_at_start(self, attitude: Attitude) -> Expr | None:
        """The angle of a joint that turns about one axis at the start: that of a named measure, or of a driver."""
        ((_axis, _name, angle),) = attitude.turns
        return next((begun for measure, begun in self._beginnings if measure == angle), None)


def axes_at_start(body: RigidBody) -> tuple[Components, Components, Components]:
    """The axes of a body on the ground, as the file turns it."""
    return UNIT if body.start.turned is None else columns_of(body.start.turned)


def placed_at_start(body: RigidBody, point: Point) -> Components:
    """Where a point of a body is, as the file puts it."""
    name, place = body.start.at or (body.default_point, (ZERO, ZERO, ZERO))
    arm = applied(axes_at_start(body), tuple(a - b for a, b in zip(point.offset, body.points[name], strict=True)))
    return tuple(a + b for a, b in zip(place, arm, strict=True))


def opposite(along: Direction) -> Direction:
    """The direction against another one, without a name of its own."""
    return Direction(along.body, reversed_(along.components))
