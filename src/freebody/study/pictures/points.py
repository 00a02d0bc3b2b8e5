"""The points that a measure names, and where what it holds touches."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

import numpy as np

from freebody.language.expression import ONE, Expr
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.combination import Combination, Composed
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Bearing, Distance
from freebody.measures.geometry import Direction, Point
from freebody.measures.lead import Lead
from freebody.model.elements import ConstraintRow, NonholonomicForm
from freebody.numeric.jets import Array
from freebody.system.system import System

Number = Callable[[Expr], float]
_ALIKE = 1e-9


def own_measures(measure: Measure | NonholonomicForm) -> Iterator[tuple[Expr, Measure]]:
    """The measures that a measure is made of, with their coefficients."""
    match measure:
        case Combination(terms):
            for coefficient, part in terms:
                yield from ((coefficient, own) for _one, own in own_measures(part))
        case Composed():
            for _name, part in measure.measures:
                yield from own_measures(part)
        case NonholonomicForm(terms):
            for _coefficient, part in terms:
                yield from own_measures(part)
        case _:
            yield ONE, measure


def points_of(measure: Measure | NonholonomicForm) -> tuple[Point, ...]:
    """In the order of the measure; of a displacement first what is displaced."""
    found: list[Point] = []
    for _coefficient, own in own_measures(measure):
        match own:
            case Displacement(of, origin, _):
                found += [of, origin]
            case Distance(start, end) | Lead(start, end, _) | Bearing(start, end):
                found += [start, end]
            case _:
                pass
    return tuple(dict.fromkeys(found))


def touching_point(
    row: ConstraintRow,
    siblings: Sequence[ConstraintRow],
    system: System,
    number: Number,
    place: Callable[[Point], Array],
) -> Array | None:
    """(2 or 3,) [m] where a circle touches a line, a plane or another circle, if that is what a row holds."""
    own = [measure for _coefficient, measure in own_measures(row.measure)]
    if len(own) != 1 or row.target is None:
        return None
    target = number(row.target)
    match own[0]:
        case Displacement(of, _, along) if abs(target) > _ALIKE and _is_center(system, of, number):
            return place(of) - target * _heading(along, place)
        case Distance(start, end) if target > _ALIKE:
            return _between(start, end, target, siblings, system, number, place)
        case _:
            return None


def _heading(along: Direction, place: Callable[[Point], Array]) -> Array:
    zero = tuple(0 * c for c in along.components)
    return place(Point(along.body, along.components)) - place(Point(along.body, zero))


def _between(
    start: Point,
    end: Point,
    target: float,
    siblings: Sequence[ConstraintRow],
    system: System,
    number: Number,
    place: Callable[[Point], Array],
) -> Array | None:
    """Where two circles touch whose centres are held apart by the sum or the difference of their radii."""
    way = (place(end) - place(start)) / target
    for r1, r2 in (*_rolling_radii(siblings, start, end, number), _radii(system, start, end, number)):
        if r1 + abs(r2) < _ALIKE:
            continue
        if abs(abs(r1 + r2) - target) < 1e-6 * target:
            return place(start) + r1 * way
        if abs(abs(r1 - r2) - target) < 1e-6 * target:  # one inside the other
            return place(start) + (r1 if r1 > r2 else -r1) * way
    return None


def _rolling_radii(
    siblings: Sequence[ConstraintRow], start: Point, end: Point, number: Number
) -> Iterator[tuple[float, float]]:
    """Radii of the circles that roll off in another row of the same connection; negative for the inner one."""
    for row in siblings:
        own = list(own_measures(row.measure))
        if any(isinstance(m, Bearing) for _c, m in own):
            by_body = {m.of: number(c) for c, m in own if isinstance(m, Angle)}
            yield by_body.get(start.body, 0.0), by_body.get(end.body, 0.0)


def _radii(system: System, start: Point, end: Point, number: Number) -> tuple[float, float]:
    first, second = (_radius(system, point, number) for point in (start, end))
    return first, second


def _radius(system: System, point: Point, number: Number) -> float:
    body = system.bodies[point.body]
    if body.radius is None or not _is_center(system, point, number):
        return 0.0
    return number(body.radius)


def _is_center(system: System, point: Point, number: Number) -> bool:
    """Whether a point is the centre of a round body."""
    body = system.bodies[point.body]
    if body.radius is None:
        return False
    away = [number(a) - number(b) for a, b in zip(point.offset, body.center.offset, strict=False)]
    return bool(np.abs(away).max() < _ALIKE)
