"""What may touch in a system: surfaces and what runs on them, stops, and who touches whom."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from freebody.connections.outlines import Outline, Straight
from freebody.language.expression import ZERO
from freebody.measures.angle import Angle
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import ONE, Direction
from freebody.model.elements import Bound
from freebody.present.figures import GROUND, Halt, Heading, Pair, Place, Surface, Tip, TurnHalt
from freebody.present.places import Places
from freebody.system.system import System


class Touching:
    """Reads the contacts and stops of a system as places and numbers."""

    def __init__(self, system: System, places: Places) -> None:
        self.system = system
        self.number = places.number
        self.place, self.heading, self.index = places.place, places.heading, places.index
        self.ordered = [
            *((p.first, p.second) for p in system.contacts),
            *((p.second, p.first) for p in system.contacts),
        ]

    # -- who ----------------------------------------------------------------------------------
    def outside(self, body: str) -> tuple[str, ...]:
        """Bodies that may touch the outside of a body."""
        found = (b.body for a, b in self.ordered if a.body == body and not a.hollows)
        return tuple(dict.fromkeys(found))

    def inside(self, body: str) -> tuple[str, ...]:
        """Bodies that may touch the inside of a ring."""
        return tuple(dict.fromkeys(b.body for a, b in self.ordered if a.body == body and a.hollows))

    def pairs(self) -> Iterator[tuple[int, int]]:
        """The moving bodies that may touch each other, by index, or the ground."""
        for pair in self.system.contacts:
            yield self.index.get(pair.first.body, GROUND), self.index.get(pair.second.body, GROUND)

    # -- surfaces -----------------------------------------------------------------------------
    def surfaces(self) -> Iterator[Surface]:
        """Each line once, with all that may touch it."""
        found: dict[tuple[float, ...], Surface] = {}
        for solid, other in self.ordered:
            for straight in solid.straights:
                if straight.length is not None:
                    continue
                surface = self._surface(straight, other)
                key = _key(surface)
                if key in found:
                    surface = replace(found[key], tips=(*found[key].tips, *surface.tips))
                found[key] = surface
        yield from found.values()

    def _surface(self, straight: Straight, other: Outline) -> Surface:
        line = straight.line
        through, along = self.place(line.through), self.heading(line.direction)
        tips = tuple(Tip(self.place(r.center), self.number(r.radius), r.body) for r in other.rounds)
        return Surface(through, along, tips, self._edge(straight.body, through, along))

    def _edge(self, name: str, through: Place, along: Heading) -> Pair | None:
        """From where to where a line is an edge of the polygon, or the axis of the rod, that it is fixed in."""
        body = self.system.bodies[name]
        if not body.corners:
            return None
        corners = np.array([self.place(body.point(c))[1:] for c in body.corners]) - np.array(through[1:])
        e = np.array(along[1:])
        across = corners @ np.array([-e[1], e[0]])
        on_it = np.abs(across) < 1e-6 * (float(np.ptp(corners, axis=0).max()) or 1.0)
        if on_it.sum() < 2 or (across[~on_it] > 0).any():
            return None
        travel = corners[on_it] @ e
        return float(travel.min()), float(travel.max())

    # -- stops --------------------------------------------------------------------------------
    def halts(self) -> Iterator[Halt | TurnHalt]:
        """Stops of displacements along a direction of the body they are counted from, and of angles."""
        for bound in self.system.limits:
            measure, target = bound.row.measure, bound.row.target
            if target is None:
                continue
            if isinstance(measure, Displacement):
                yield from self._halt(bound, measure, self.number(target))
            elif isinstance(measure, Angle) and measure.of in self.index:
                axis = self.heading(Direction(measure.origin, (ONE, ZERO)))
                limit = self.number(target) + self.number(measure.reference) + axis.angle
                yield TurnHalt(self.index[measure.of], axis.body, limit, bound.row.sign)

    def _halt(self, bound: Bound, measure: Displacement, limit: float) -> Iterator[Halt]:
        point, origin, along = self.place(measure.of), self.place(measure.origin), self.heading(measure.along)
        if origin.body == along.body != point.body:
            yield Halt(point, origin, along, limit, bound.row.sign)


def _key(surface: Surface) -> tuple[float, ...]:
    """What is the same for two descriptions of one line."""
    e = surface.along
    level = surface.through.y * e.x - surface.through.x * e.y
    return (e.body, *(round(v, 9) for v in (e.x, e.y, level)))
