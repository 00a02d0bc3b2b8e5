"""How a heavy rope lies: the places that it runs over, the lengths between them, and what drives a part of it."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from freebody.connections.standing import number_of, stands_at
from freebody.language.expression import ONE, PI, ZERO, Expr, Number, add, divide, multiply, negate, number
from freebody.language.sentences import Message
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, RIGHT, UP, Direction, Point
from freebody.model.elements import RigidBody
from freebody.model.phrases import direction_angle
from freebody.model.transmitted import CutTension
from freebody.tolerances import ROUNDED

if TYPE_CHECKING:
    from freebody.model.names import Names

Linear = tuple[Expr, Expr]  # constant, and what multiplies the way
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

    def touched(self, along: Direction) -> tuple[Expr, ...]:
        """Where a lead touches its circle, on the ground: C - s R n."""
        normal = along.normal().components
        return tuple(add(c, negate(multiply(self.arm, n))) for c, n in zip(self.center.offset, normal, strict=False))


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
) -> RopePlace | None:
    """A point of the ground, or a wheel that stands there: fixed, or pinned at its centre. usual: the sense in which it
    runs round where its leads are parallel, or it is wound up. None with a problem noted."""
    point = names.point(text, *field)
    body = names.known(point.body)
    if body.name == GROUND:
        return RopePlace(text, body.name, point, ZERO, ZERO, into, out, turns_with=False)
    n_before = len(names.problems)
    radius = names.radius(body.name, *field)
    x, y = stands_at(names, body.center, RIGHT), stands_at(names, body.center, UP)
    if len(names.problems) > n_before:
        return None
    if x is None or y is None:
        told = Message(
            "a heavy rope runs over what stands still: pin the centre of {wheel} to a point of the ground, or make it "
            "fixed",
            wheel=body.name,
        )
        names.problem(told, *field)
        return None
    center = Point(GROUND, (x, y, *names.origin[2:]), text)
    sense = usual if into is None else _sense(names, into, out) or usual
    arm, turns_with = multiply(number(sense), radius), body.turns and not body.fixed
    arc = ZERO if into is None else multiply(arm, _bend(names, into, out, sense))
    return RopePlace(text, body.name, center, arm, arc, into, out, turns_with)


def sense_of_drum(names: Names, out: Direction, side: str) -> int:
    """In which sense a rope runs off a drum on one side of it: it touches at C - s R n, n its lead turned by a quarter
    turn."""
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
