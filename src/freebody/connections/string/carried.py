"""Leads that keep their direction on a body that carries both of their ends: along the jib of a crane from a trolley on
it to a sheave at its end.

With n a direction of the carrier across a guide of it, and e the one along it, the lead stays along e where

    n . (C_2 - C_1) = rho

whatever the parameters are (see `measures.lead`). So it is taken to do where the guide leads a body that is put
nowhere, as along a guide on the ground. Its angle a is that of the carrier then, and l = e . (C_2 - C_1).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from freebody.connections.standing import along_of, is_parallel, is_zero, number_of, vanishes
from freebody.connections.string.laying import StringRun
from freebody.language.expression import Expr, add, negate
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, RIGHT, UP, ZERO, Direction, Point

if TYPE_CHECKING:
    from freebody.model.names import Names


@dataclass(frozen=True)
class Kept:
    """What keeps a point on a carrier: at a place of it, or so far from its reference along a direction of it."""

    carrier: str
    at: Point | None = None
    across: Direction | None = None
    far: Expr = ZERO

    def along(self, names: Names, direction: Direction) -> Expr | None:
        """How far along a direction of the carrier the point is."""
        if self.carrier != direction.body:
            return None
        if self.at is not None:
            return along_of(self.at.offset, direction)
        if self.across is None or not is_parallel(names, self.across, direction):
            return None
        sense = number_of(names, along_of(self.across.components, direction))
        return self.far if sense > 0.0 else negate(self.far)


def with_carried_leads(names: Names, run: StringRun) -> StringRun:
    """The run with directions of carriers for the leads that keep these, or that a guide on a carrier leads."""
    leads = [lead or _carried(names, run, k) for k, lead in enumerate(run.leads)]
    return replace(run, leads=leads)


def askew_on_carriers(names: Names, run: StringRun) -> Iterator[tuple[Point, Point, str]]:
    """Leads that are taken to run along a guide on a carrier, although their ends do not stand so; and the carrier."""
    for k, lead in enumerate(run.leads):
        if lead is None or lead.body == GROUND:
            continue
        points = run.way[k].point, run.way[k + 1].point
        places = [_place(names, [*_keepers(names, point)], lead.normal()) for point in points]
        if None in places or not is_zero(names, _gap(run, k, places)):
            yield *points, lead.body


def _carried(names: Names, run: StringRun, k: int) -> Direction | None:
    """The direction of its carrier that a lead keeps; None where it has none, or nobody says which way it runs."""
    points = run.way[k].point, run.way[k + 1].point
    ends = [[*_keepers(names, point)] for point in points]
    led = [kept.across for kept in (*ends[0], *ends[1]) if kept.across is not None]
    axes = [Direction(kept.carrier, axis.components) for kept in ends[0] for axis in (UP, RIGHT)]
    for across in dict.fromkeys((*led, *axes)):
        places = [_place(names, end, across) for end in ends]
        if None in places:
            continue
        is_led = across in led and all(names.known(point.body).start.at is None for point in points)
        if not is_led and not vanishes(names, _gap(run, k, places)):
            continue
        along = across.normal().reversed()
        far = [_begins(names, point, end, along) for point, end in zip(points, ends, strict=True)]
        if far[0] is None or far[1] is None:
            continue
        ahead = number_of(names, add(far[1], negate(far[0])))
        return replace(along if ahead > 0.0 else along.reversed(), name="")
    return None


def _gap(run: StringRun, k: int, places: list[Expr | None]) -> Expr:
    """n . (C_2 - C_1) - rho."""
    return add(places[1] or ZERO, negate(places[0] or ZERO), negate(run.aside(k)))


def _place(names: Names, end: list[Kept], direction: Direction) -> Expr | None:
    """How far along a direction of its carrier an end is kept."""
    return next((p for kept in end if (p := kept.along(names, direction)) is not None), None)


def _keepers(names: Names, point: Point) -> Iterator[Kept]:
    """What keeps a point on bodies that may move."""
    if point.body != GROUND:
        yield Kept(point.body, point)
    for connection in names.connections.values():
        if connection.lets_hang or point.body not in connection.mentions(names):
            continue
        with names.quietly():
            joined = connection.joined_points(names)
            for own, other in () if joined is None else (joined, joined[::-1]):
                if own == point and other.body != GROUND:
                    yield Kept(other.body, other)
            for row in connection.rows(names):
                across = row.measure
                if not isinstance(across, Displacement) or across.of != point or across.along.body == GROUND:
                    continue
                if across.origin.body == across.along.body:
                    far = along_of(across.origin.offset, across.along)
                    yield Kept(across.along.body, None, across.along, add(far, row.target or ZERO))


def _begins(names: Names, point: Point, keepers: list[Kept], along: Direction) -> Expr | None:
    """How far along a direction of a carrier a point is, or starts."""
    if (place := _place(names, keepers, along)) is not None:
        return place
    for name, begun in names.placed_at_start.items():
        measure = names.measures.get(name)
        if not isinstance(measure, Displacement) or measure.of != point or measure.origin.body != along.body:
            continue
        if is_parallel(names, measure.along, along):
            sense = number_of(names, along_of(measure.along.components, along))
            return add(along_of(measure.origin.offset, along), begun if sense > 0.0 else negate(begun))
    return None
