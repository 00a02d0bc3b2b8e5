"""Where strings pull at bodies: at both ends of every lead, on the circle that it leaves."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from freebody.measures.angle import Angle
from freebody.measures.combination import Combination
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import Point, position
from freebody.measures.lead import Lead
from freebody.model.elements import Held
from freebody.numeric.jets import Array
from freebody.numeric.reference import Reference, Snapshot
from freebody.present.figures import GROUND, Heading, Place, turned
from freebody.present.layout import headings
from freebody.present.places import Places
from freebody.present.ropes import rope

Pull = tuple[str, str, Array, Array]  # body, the body at the other end, where, pull per unit of tension


def pulls(rows: Sequence[Held], reference: Reference, snapshot: Snapshot) -> Iterator[tuple[Held, list[Pull]]]:
    """For each row of a string, in order: its pulls at bodies."""
    if not rows:
        return
    system = reference.system
    places = Places(system, reference.number)

    def rim(place: Place) -> float | None:
        for body in system.bodies.values():
            if body.radius is not None and _is_near(places.place(body.center), place):
                return reference.number(body.radius)
        return None

    way = rope(rows, places.place, places.heading, reference.number, rim)
    if way is None:
        yield from ((row, []) for row in rows)
        return
    poses = np.array([reference.pose(snapshot.q, body.name) for body in system.moving]).reshape(1, -1, 3)
    bearings = headings(way, poses)[0]
    k = 0
    for row in rows:
        assert isinstance(row.measure, Combination)
        found: list[Pull] = []
        for coefficient, measure in row.measure.terms:
            if isinstance(measure, Angle):
                continue
            assert isinstance(measure, Lead | Displacement)
            ends = (measure.start, measure.end) if isinstance(measure, Lead) else (measure.origin, measure.of)
            share = abs(reference.number(coefficient))
            heading = way.leads[k]
            bearing = float(bearings[k]) if heading is None else _fixed(heading, poses)
            e, n = turned(bearing, 1.0, 0.0), turned(bearing, 0.0, 1.0)
            for j, sign in ((0, 1.0), (1, -1.0)):
                node = way.nodes[k + j]
                at = _position(reference, snapshot, ends[j]) - node.arm * n
                found.append((ends[j].body, ends[1 - j].body, at, sign * share * e))
            k += 1
        yield row, found


def _fixed(heading: Heading, poses: Array) -> float:
    """The bearing of a lead of constant direction, however far its ends are from that."""
    return heading.angle + (0.0 if heading.body == GROUND else float(poses[0, heading.body, 2]))


def _position(reference: Reference, snapshot: Snapshot, point: Point) -> Array:

    r = position(snapshot.geometry, point)
    return np.array([r.x.value, r.y.value])


def _is_near(a: Place, b: Place) -> bool:
    return a.body == b.body and abs(a.x - b.x) < 1e-9 and abs(a.y - b.y) < 1e-9
