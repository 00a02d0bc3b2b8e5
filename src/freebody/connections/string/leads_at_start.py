"""How the leads of a string run at the start: in the plane by x and y, in space as the planes of its wheels see them.

The angle a of a lead is counted in the plane of the wheel at its end, from the first of two directions there. Leads
along a common tangent see both of their wheels in one plane; one that keeps its direction has an angle of its own at
each end, as from wheels to others whose axes are not parallel.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from freebody.connections.standing import is_zero, number_of, starts_at
from freebody.connections.standing_in_space import StandingInSpace, opposite
from freebody.connections.string.in_space import SpatialRun
from freebody.connections.string.laying import StringRun, where_at_start
from freebody.connections.string.node import StringNode
from freebody.connections.string.way_in_space import WaySeen
from freebody.language.expression import Call, Expr, Symbol, add, divide, multiply, negate, number
from freebody.measures.geometry import DOWN, GROUND, LEFT, RIGHT, UP, ZERO, Direction
from freebody.model.phrases import direction_angle
from freebody.model.rotations import UNIT, dot
from freebody.tolerances import ROUND_OFF

if TYPE_CHECKING:
    from freebody.model.names import Names

Quarters = tuple[Direction, Direction, Direction, Direction]  # each a quarter turn on from the one before


@dataclass(frozen=True)
class LeadAtStart:
    """A lead at the start. angles: of its direction at both ends; axis: the quarter turns from which that of one along
    a tangent is counted; along: the constant angles, of one that keeps its direction."""

    angles: tuple[float, float]
    axis: int
    along: tuple[Expr, Expr] | None

    def counted_from(self, end: int) -> Expr:
        """The angle from which that of a lead is counted, at its first end (0) or at its last (1)."""
        if self.along is not None:
            return self.along[end]
        return divide(multiply(number(self.axis), Symbol("pi")), number(2))


class LeadsAtStart:
    """Of a string in the plane."""

    def __init__(self, names: Names, run: StringRun) -> None:
        self.names, self.run = names, run

    def rho(self, k: int) -> Expr:
        return self.run.aside(k)

    def quarters(self, k: int) -> Quarters:
        """The axes of the plane in which a lead runs along the tangent."""
        return (RIGHT, UP, LEFT, DOWN)

    def seen(self, k: int) -> LeadAtStart | None:
        """None where the places of its ends do not tell, or are too near to each other."""
        along = self.run.leads[k]
        if along is not None:
            angle = direction_angle(along)
            now = number_of(self.names, angle)
            return LeadAtStart((now, now), 0, (angle, angle))
        away, rho = self._away(k), number_of(self.names, self.rho(k))
        if away is None or math.hypot(*away) <= abs(rho) + ROUND_OFF:
            return None
        x, y, *_ = away
        angle = math.atan2(y, x) - math.atan2(rho, math.sqrt(max(x * x + y * y - rho * rho, 0.0)))
        axis = round(angle / (math.pi / 2)) % 4
        # counted from that axis the angle is at most an eighth of a turn
        off = math.remainder(angle - axis * math.pi / 2, 2 * math.pi)
        return LeadAtStart((axis * math.pi / 2 + off,) * 2, axis, None)

    def _away(self, k: int) -> Sequence[float] | None:
        """From one end of a lead to the other in numbers, along the axes of its plane."""
        first, second = (where_at_start(self.names, node) for node in self.run.way[k : k + 2])
        return None if first is None or second is None else (second[0] - first[0], second[1] - first[1])

    # -- by formulas of where the model puts its ends ---------------------------------------------------
    def between(self, k: int, axis: Direction) -> Expr | None:
        """How far the last end of a lead is from the first along an axis."""
        first, second = (starts_at(self.names, node.point, axis) for node in self.run.way[k : k + 2])
        return None if first is None or second is None else add(second, negate(first))

    def length(self, k: int) -> Expr | None:
        """Of a lead; None where the model does not tell it."""
        along, rho = self.run.leads[k], self.rho(k)
        if along is not None:
            return self.between(k, along)
        sides = [self.between(k, axis) for axis in self._axes(k)]
        known = [x for x in sides if x is not None]
        if len(known) < len(sides):
            return None
        return Call("sqrt", add(*(multiply(x, x) for x in known), negate(multiply(rho, rho))))

    def _axes(self, k: int) -> Sequence[Direction]:
        return self.quarters(k)[:2]

    def angle(self, k: int, lead: LeadAtStart, end: int) -> Expr:
        """tan(a/2) = sin(a)/(1 + cos(a)), of the components along the nearest axis and across it."""
        if lead.along is not None:
            return lead.along[end]
        quarters, length, rho = self.quarters(k), self.length(k), self.rho(k)
        x, y = (self.between(k, quarters[(lead.axis + n) % 4]) for n in (0, 1))
        assert length is not None
        assert x is not None
        assert y is not None
        cos = add(multiply(length, x), multiply(rho, y))  # times |v|^2
        sin = add(multiply(length, y), negate(multiply(rho, x)))
        square = add(multiply(x, x), multiply(y, y))
        return add(lead.counted_from(end), multiply(number(2), Call("atan", divide(sin, add(square, cos)))))


class SpatialLeadsAtStart(LeadsAtStart):
    """Of a string in space, whose wheels of one plane see it by the same axes."""

    def __init__(self, names: Names, run: SpatialRun, still: StandingInSpace) -> None:
        super().__init__(names, run)
        self.still, self.beyond = still, run.swivels
        self.way = WaySeen(still, run.way)

    def quarters(self, k: int) -> Quarters:
        first, second = self.run.way[k : k + 2]
        plane = first.plane or second.plane
        assert plane is not None
        return (plane.along, plane.side, opposite(plane.along), opposite(plane.side))

    def seen(self, k: int) -> LeadAtStart | None:
        first, along = self.run.leads[k], None
        if first is not None:
            ends = (first, self.beyond.get(k, first))
            along = tuple(self._constant(n, e) for n, e in zip(self.run.way[k : k + 2], ends, strict=True))
            return LeadAtStart((along[0][0], along[1][0]), 0, (along[0][1], along[1][1]))
        return super().seen(k)

    def _constant(self, node: StringNode, e: Direction) -> tuple[float, Expr]:
        """The angle of a constant direction in the plane of a wheel, in numbers and as a formula; at a point none."""
        plane = node.plane
        seen = None if plane is None else self.still.on(plane.normal.body, e)
        if plane is None or seen is None:
            return 0.0, ZERO
        x, y = (dot(seen[0].components, axis.components) for axis in (plane.along, plane.side))
        now = math.atan2(*(number_of(self.names, c) for c in (y, x)))
        axis = round(now / (math.pi / 2))
        for _quarter in range(axis % 4):
            x, y = y, negate(x)
        # from the nearest axis on, by the half angle
        off = ZERO if is_zero(self.names, y) else multiply(number(2), Call("atan", divide(y, add(number(1), x))))
        return now, add(divide(multiply(number(axis), Symbol("pi")), number(2)), off)

    def _away(self, k: int) -> Sequence[float] | None:
        axes = self._axes(k)
        first, second = (self.way.where(j, axes[0].body) for j in (k, k + 1))
        if first is None or second is None:
            return None
        return [
            sum((q - p) * number_of(self.names, c) for p, q, c in zip(first, second, axis.components, strict=True))
            for axis in axes
        ]

    def between(self, k: int, axis: Direction) -> Expr | None:
        kept = self.still.distance_along(self.run.way[k].point, self.run.way[k + 1].point, axis)
        if kept is not None:
            return kept
        first, second = (self._begins(node, axis) for node in self.run.way[k : k + 2])
        return None if first is None or second is None else add(second, negate(first))

    def _begins(self, node: StringNode, axis: Direction) -> Expr | None:
        """Where a place is along an axis, as joints and measures let it start, or as it is put on the ground."""
        begun, body = self.still.begins(node.point, axis), self.names.known(node.point.body)
        if begun is not None or axis.body != GROUND or body.start.at is None:
            return begun
        name, at = body.start.at
        if body.points[name] != node.point.offset and (body.turns or body.start.turned):
            return None
        arm = (add(p, negate(q)) for p, q in zip(node.point.offset, body.points[name], strict=True))
        return dot(tuple(add(p, q) for p, q in zip(at, arm, strict=True)), axis.components)

    def _axes(self, k: int) -> Sequence[Direction]:
        if any(node.plane is not None for node in self.run.way[k : k + 2]):
            return super()._axes(k)
        return tuple(Direction(GROUND, e) for e in UNIT)


def with_equal_axes(names: Names, run: SpatialRun) -> SpatialRun:
    """The same string, in which wheels of parallel planes count angles from the same axis."""
    way = list(run.way)
    for k in range(1, len(way)):
        before, plane = way[k - 1].plane, way[k].plane
        if before is None or plane is None or before.normal.body != plane.normal.body:
            continue
        gaps = (a - b for a, b in zip(before.normal.components, plane.normal.components, strict=True))
        if all(is_zero(names, gap) for gap in gaps):
            way[k] = replace(way[k], plane=replace(plane, along=before.along, side=before.side))
    return replace(run, way=way)
