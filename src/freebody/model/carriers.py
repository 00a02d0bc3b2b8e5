"""Which distances do the joints keep by themselves?

Points that a pin makes coincide share a place; a place carries the bodies that meet there. Two places with a
common body keep their distance, so a gear mesh between them need not hold it again.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from freebody.measures.base import Measure
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Distance
from freebody.measures.geometry import GROUND, Components, Point
from freebody.model.elements import ConstraintRow, NonholonomicForm, RigidBody

Place = tuple[str, Components]


def _place(bodies: Mapping[str, RigidBody], point: Point) -> Place:
    """A point as (body, components); on a fixed body as the ground point where it stands."""
    body = bodies[point.body]
    if body.name == GROUND or not body.fixed:
        return body.name, point.offset
    at = body.start.at
    if body.start.turned:
        return body.name, point.offset
    if at is None:
        return GROUND, point.offset
    return GROUND, tuple(a + x - r for a, r, x in zip(at[1], body.points[at[0]], point.offset, strict=True))


def is_distance_kept(
    bodies: Mapping[str, RigidBody], rows: Sequence[ConstraintRow], measure: Measure | NonholonomicForm
) -> bool:
    """True if the measure is a distance whose ends are carried by one body."""
    if not isinstance(measure, Distance):
        return False
    groups: list[set[Place]] = []
    for first, second in _coincident(rows):
        joined = {_place(bodies, first), _place(bodies, second)}
        for group in [g for g in groups if g & joined]:
            groups.remove(group)
            joined |= group
        groups.append(joined)

    def carriers(point: Point) -> set[str]:
        place = _place(bodies, point)
        group: set[Place] = next((g for g in groups if place in g), {place})
        return {body for body, _offset in group}

    return bool(carriers(measure.start) & carriers(measure.end))


def _coincident(rows: Sequence[ConstraintRow]) -> list[tuple[Point, Point]]:
    """Pairs of points held together along both axes."""
    seen: dict[tuple[str, Point, Point], int] = {}
    for row in rows:
        m = row.measure
        if isinstance(m, Displacement) and row.target is None and m.along.body == GROUND:
            key = row.connection, m.origin, m.of
            seen[key] = seen.get(key, 0) + 1
    return [(first, second) for (_name, first, second), count in seen.items() if count == 2]
