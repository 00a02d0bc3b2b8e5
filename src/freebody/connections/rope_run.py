"""How a heavy rope lies: the places that it runs over, the lengths between them, and what drives a part of it.

In space a wheel has the plane across its axis n, and both its leads are in that; over an edge a rope runs in any way. A
quarter turn of a lead e in the plane is n x e, so that it touches the wheel at C - s R n x e.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

from freebody.connections.standing import number_of, stands_at
from freebody.connections.standing_in_space import StandingInSpace
from freebody.connections.string.in_space import wheel_plane
from freebody.connections.string.node import WheelPlane
from freebody.language.expression import ONE, PI, ZERO, Expr, Number, add, divide, multiply, negate, number
from freebody.language.sentences import Message
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, RIGHT, UP, Direction, Point
from freebody.model.elements import RigidBody
from freebody.model.phrases import direction_angle
from freebody.model.rotations import UNIT, dot, perpendiculars, vector_product
from freebody.model.transmitted import CutTension
from freebody.tolerances import ROUND_OFF, ROUNDED

if TYPE_CHECKING:
    from freebody.model.names import Names

Linear = tuple[Expr, Expr]  # constant, and what multiplies the way
_TOWARD = {"top": "up", "bottom": "down"}
_SIDES = {"right": (1.0, 0.0), "left": (-1.0, 0.0), "top": (0.0, 1.0), "bottom": (0.0, -1.0)}


@dataclass(frozen=True)
class RopePlace:
    """A place on its way. arm: +R where it runs counter-clockwise round a circle, -R clockwise, 0 at a point; into: the
    lead before it, None where it is wound up there; arc: [m] what lies on it, less than a full turn."""

    called: str
    body: str
    center: Point  # on the ground
    arm: Expr
    arc: Expr
    into: Direction | None
    out: Direction
    turns_with: bool
    plane: WheelPlane | None = None  # in space that of a wheel

    def touched(self, along: Direction) -> tuple[Expr, ...]:
        """Where a lead touches its circle, on the ground: C - s R n."""
        if self.arm == ZERO:
            return self.center.offset
        normal = self._quarter_turn(along).components
        return tuple(add(c, negate(multiply(self.arm, n))) for c, n in zip(self.center.offset, normal, strict=False))

    def aside(self, along: Direction, *, in_space: bool) -> tuple[tuple[Direction, Expr], ...]:
        """The directions across a lead, and how far along each of them from the middle it runs."""
        if not in_space:
            return ((along.normal(), negate(self.arm)),)
        if self.plane is None:
            return tuple((Direction(GROUND, v), ZERO) for v in perpendiculars(along.components))
        return (self._quarter_turn(along), negate(self.arm)), (self.plane.normal, ZERO)

    def _quarter_turn(self, along: Direction) -> Direction:
        if self.plane is None:
            return along.normal()
        return Direction(GROUND, vector_product(self.plane.normal.components, along.components))

    @property
    def turned(self) -> tuple[tuple[Expr, Measure], ...]:
        """By how much its wheel turns counter-clockwise, in space as seen against the axis."""
        return ((ONE, Angle(self.body)),) if self.plane is None else self.plane.turned


@dataclass(frozen=True)
class RopeRun:
    """A rope on its way; the last lead is as long as the way of its last end from the last place."""

    rope: RigidBody
    places: tuple[RopePlace, ...]

    @property
    def way(self) -> Displacement:
        last = self.places[-1]
        return Displacement(self.rope.center, last.center, last.out)

    @property
    def length(self) -> Expr:
        return self.rope.sizes[0]

    @property
    def density(self) -> Expr:
        return divide(self.rope.mass, self.length)

    def between(self, k: int) -> Expr:
        """[m] the lead from place k to the next one."""
        here, there = self.places[k], self.places[k + 1]
        apart = (add(b, negate(a)) for a, b in zip(here.center.offset, there.center.offset, strict=True))
        return add(*(multiply(d, e) for d, e in zip(apart, here.out.components, strict=False)))

    @property
    def laid(self) -> Expr:
        """[m] what lies on places and between them."""
        arcs = (place.arc for place in self.places)
        return add(ZERO, *arcs, *(self.between(k) for k in range(len(self.places) - 1)))

    def first_length(self, way: Expr) -> Expr:
        """[m] what is left of it before the first place."""
        return add(self.length, negate(self.laid), negate(way))

    def part_behind(self, k: int, *, with_arc: bool) -> Linear:
        """(constant, by way) [m] the length from place k to the last end."""
        n = len(self.places)
        arcs = (place.arc for place in self.places[k if with_arc else k + 1 :])
        return add(ZERO, *arcs, *(self.between(j) for j in range(k, n - 1))), ONE

    def drop_behind(self, k: int, along: Direction, *, with_arc: bool) -> Linear:
        """(constant, by way) [m] by how much it goes along a direction from place k to its last end: what drives that
        part of the rope is rho g times it."""
        here, last = self.places[k], self.places[-1]
        lead = here.into if with_arc and here.into is not None else here.out
        start, end = here.touched(lead), last.touched(last.out)
        gone = (add(b, negate(a)) for a, b in zip(start, end, strict=True))
        return add(*(multiply(d, e) for d, e in zip(gone, along.components, strict=False))), _dot(last.out, along)

    def drop(self, along: Direction) -> Linear:
        """(constant, by way) [m] the same of all of it that is not wound up."""
        first = self.places[0]
        constant, by_way = self.drop_behind(0, along, with_arc=True)
        if first.into is None:
            return constant, by_way
        share = _dot(first.into, along)
        left = add(self.length, negate(self.laid))
        return add(constant, multiply(share, left)), add(by_way, negate(share))

    def cut(
        self, k: int, fields: Iterable[tuple[Direction, Expr]], rows: tuple[str, ...], *, with_arc: bool
    ) -> CutTension:
        """The tension at place k, before its arc or behind it."""
        constant, by_way = ZERO, ZERO
        for along, strength in fields:
            fixed, running = self.drop_behind(k, along, with_arc=with_arc)
            constant = add(constant, multiply(self.density, strength, fixed))
            by_way = add(by_way, multiply(self.density, strength, running))
        length, running = self.part_behind(k, with_arc=with_arc)
        mass, mass_by_way = multiply(self.density, length), multiply(self.density, running)
        return CutTension(rows, self.way, constant, by_way, mass, mass_by_way)


def place_on_way(
    names: Names,
    text: str,
    field: tuple[str | int, ...],
    into: Direction | None,
    out: Direction,
    usual: int,
    still: StandingInSpace | None = None,
) -> RopePlace | None:
    """A point of the ground, or a wheel that stands there: fixed, or pinned at its centre. usual: the sense in which it
    runs round where its leads are parallel, or it is wound up. still: in space. None with a problem noted."""
    point = names.point(text, *field)
    body = names.known(point.body)
    if body.name == GROUND:
        return RopePlace(text, body.name, point, ZERO, ZERO, into, out, turns_with=False)
    n_before = len(names.problems)
    radius = names.radius(body.name, *field)
    if still is not None:
        return _in_space(still, body, radius, (text, field), into, out, usual)
    x, y = stands_at(names, body.center, RIGHT), stands_at(names, body.center, UP)
    if len(names.problems) > n_before:
        return None
    if x is None or y is None:
        names.problem(_moves(body.name), *field)
        return None
    center = Point(GROUND, (x, y, *names.origin[2:]), text)
    sense = usual if into is None else _sense(names, into, out) or usual
    arm, turns_with = multiply(number(sense), radius), body.turns and not body.fixed
    arc = ZERO if into is None else multiply(arm, _bend(names, into, out, sense))
    return RopePlace(text, body.name, center, arm, arc, into, out, turns_with)


def _moves(wheel: str) -> Message:
    return Message(
        "a heavy rope runs over what stands still: pin the centre of {wheel} to a point of the ground, or make it "
        "fixed",
        wheel=wheel,
    )


def _in_space(
    still: StandingInSpace,
    body: RigidBody,
    radius: Expr,
    written: tuple[str, tuple[str | int, ...]],
    into: Direction | None,
    out: Direction,
    usual: int,
) -> RopePlace | None:
    """A wheel whose axis and middle stand still on the ground. None with a problem noted."""
    names, (text, field) = still.names, written
    n_before = len(names.problems)
    plane = wheel_plane(still, body.name)
    if plane is None or len(names.problems) > n_before:
        return None
    where = [still.standing(body.center, Direction(GROUND, axis)) for axis in UNIT]
    if plane.normal.body != GROUND or any(place.body != GROUND for place in where):
        names.problem(_moves(body.name), *field)
        return None
    for lead in (out,) if into is None else (into, out):
        lean = number_of(names, dot(lead.components, plane.normal.components))
        if abs(lean) > ROUNDED:
            told = Message(
                "a lead to {wheel} leaves its plane by {angle:.4g} deg: it runs off the wheel. Leads are perpendicular "
                "to the axis",
                wheel=body.name,
                angle=math.degrees(math.asin(min(1.0, abs(lean)))),
            )
            names.problem(told, *field)
            return None
    center = Point(GROUND, tuple(place.far for place in where), text)
    sense, bend = usual, ZERO
    if into is not None:
        before, after = _within(plane, into), _within(plane, out)
        sense = _sense(names, before, after) or usual
        bend = _bend(names, before, after, sense)
    arm, turns_with = multiply(number(sense), radius), body.turns and not body.fixed
    arc = multiply(arm, bend)
    return RopePlace(text, body.name, center, arm, arc, into, out, turns_with, plane)


def _within(plane: WheelPlane, lead: Direction) -> Direction:
    """A lead by its components in the plane of a wheel."""
    return Direction(GROUND, tuple(dot(lead.components, axis.components) for axis in (plane.along, plane.side)))


def aside_of_leads(names: Names, run: RopeRun) -> Iterator[tuple[str, str, float]]:
    """Neighbouring places that do not stand on one lead, and by how much [m] the second is aside of it."""
    for here, there in pairwise(run.places):
        gone = [add(b, negate(a)) for a, b in zip(here.touched(here.out), there.touched(here.out), strict=True)]
        ahead = dot(tuple(gone), here.out.components)
        beside = [
            number_of(names, add(g, negate(multiply(ahead, e)))) for g, e in zip(gone, here.out.components, strict=True)
        ]
        if (far := math.hypot(*beside)) > ROUND_OFF:
            yield here.called, there.called, far


def sense_of_drum(names: Names, drum: str, out: Direction, side: str, still: StandingInSpace | None = None) -> int:
    """In which sense a rope runs off a drum on one side of it: it touches at C - s R n, n its lead turned by a quarter
    turn; in space with the n of the drum across its axis."""
    if still is not None:
        plane = wheel_plane(still, drum)
        if plane is None:
            return 0
        toward = names.compass[_TOWARD.get(side, side)].components
        ahead = number_of(names, dot(out.components, vector_product(plane.normal.components, toward)))
        return 0 if abs(ahead) <= ROUND_OFF else 1 if ahead > 0.0 else -1
    nx, ny = (number_of(names, c) for c in out.normal().components[:2])
    sx, sy = _SIDES[side]
    return -1 if sx * nx + sy * ny > 0 else 1


def _sense(names: Names, into: Direction, out: Direction) -> int:
    """+1 where the way bends to the left, -1 to the right, 0 where it turns back or goes straight on."""
    (ax, ay, *_), (bx, by, *_) = into.components, out.components
    bend = number_of(names, add(multiply(ax, by), negate(multiply(ay, bx))))
    return 0 if abs(bend) < ROUNDED else 1 if bend > 0 else -1


def _bend(names: Names, into: Direction, out: Direction, sense: int) -> Expr:
    """[rad] by how much the lead turns there, between nothing and a full turn in its own sense."""
    bend = add(direction_angle(out), negate(direction_angle(into)))
    return bend if sense * number_of(names, bend) > ROUNDED else add(bend, multiply(number(2 * sense), PI))


def _dot(a: Direction, b: Direction) -> Expr:
    found = add(*(multiply(x, y) for x, y in zip(a.components, b.components, strict=False)))
    return ZERO if isinstance(found, Number) and found.value == 0 else found
