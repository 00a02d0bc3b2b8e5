"""Where strings pull at bodies: at both ends of every lead, on the circle that it leaves."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from freebody.language.expression import Expr, number
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.combination import Combination
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Distance
from freebody.measures.geometry import Direction, Point, position
from freebody.measures.lead import Lead
from freebody.model.elements import ConstraintRow
from freebody.model.glyphs import Rope, ShownGlyph, in_numbers
from freebody.numeric.jets import Array
from freebody.numeric.snapshot import Snapshot
from freebody.numeric.system import NumericSystem
from freebody.present.figures import GROUND, Heading, turned
from freebody.present.layout import headings
from freebody.present.places import Places
from freebody.system.system import System

Glyph = ShownGlyph[Point, Direction, Expr]
Pull = tuple[str, str, Array, Array]  # body, the body at the other end, where, pull per unit of tension


def rope_of(system: System, connection: str) -> Glyph | None:
    """What a connection draws as a string, if it is one."""
    own = (shown for shown in system.glyphs if shown.owner == connection and not shown.is_load)
    return next((shown for shown in own if isinstance(shown.sign, Rope)), None)


def pulls(
    rope: Glyph, rows: Sequence[ConstraintRow], reference: NumericSystem, snapshot: Snapshot
) -> Iterator[tuple[ConstraintRow, list[Pull]]]:
    """For each row of a string, in order: its pulls at bodies."""
    system = reference.system
    places = Places(system, reference.number)
    shown = in_numbers(rope, places.place, places.heading, reference.number)
    way = shown.sign
    assert isinstance(way, Rope)
    poses = np.array([reference.pose(snapshot.q, body.name) for body in system.moving]).reshape(1, -1, 3)
    bearings = headings(way, poses)[0]
    for row in rows:
        k = next(k for k, lead in enumerate(way.leads) if lead.row == row.component)
        found: list[Pull] = []
        for coefficient, measure in _parts(row):
            if isinstance(measure, Angle):
                continue
            ends = _ends(measure)
            share = abs(reference.number(coefficient))
            heading = way.leads[k].along
            bearing = float(bearings[k]) if heading is None else _fixed(heading, poses)
            e, n = turned(bearing, 1.0, 0.0), turned(bearing, 0.0, 1.0)
            for j, sign in ((0, 1.0), (1, -1.0)):
                node = way.nodes[k + j]
                at = _position(reference, snapshot, ends[j]) - node.arm * n
                found.append((ends[j].body, ends[1 - j].body, at, sign * share * e))
            k += 1
        yield row, found


def _parts(row: ConstraintRow) -> Sequence[tuple[Expr, Measure]]:
    """What the length of a string is made of; with a length between two points it is their distance."""
    if isinstance(row.measure, Combination):
        return row.measure.terms
    assert isinstance(row.measure, Distance)
    return ((number(1), row.measure),)


def _ends(lead: Measure) -> tuple[Point, Point]:
    assert isinstance(lead, Lead | Distance | Displacement)
    return (lead.origin, lead.of) if isinstance(lead, Displacement) else (lead.start, lead.end)


def _fixed(heading: Heading, poses: Array) -> float:
    """The bearing of a lead of constant direction, however far its ends are from that."""
    return heading.angle + (0.0 if heading.body == GROUND else float(poses[0, heading.body, 2]))


def _position(reference: NumericSystem, snapshot: Snapshot, point: Point) -> Array:

    r = position(snapshot.geometry, point)
    return np.array([r.x.value, r.y.value])
