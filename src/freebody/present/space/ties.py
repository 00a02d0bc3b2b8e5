"""What joins and pushes the bodies of a system in space, read from the measures that it holds and pushes.

Nothing here asks for the kind of a connection: a joint is known by how many displacements and how many alignments it
holds, and along what. A measure that is none of these is not drawn.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby
from typing import TYPE_CHECKING

import numpy as np

from freebody.language.expression import evaluate, free_symbols
from freebody.measures.base import Measure
from freebody.measures.combination import Combination, Composed
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Distance
from freebody.measures.geometry import Direction
from freebody.measures.lead import Lead
from freebody.measures.turn import Alignment, Turn
from freebody.model.elements import RATE, VALUE, Component, Held, Push, RateMeasure
from freebody.present.figures import Array
from freebody.present.ropes import is_rope
from freebody.present.space.figures import Arrow, Coil, Heading, Joint, Place, Sheet, Spring, Ties, Triple
from freebody.system.system import System

if TYPE_CHECKING:
    from freebody.present.space.scene import Places

Found = Measure | RateMeasure


def read_ties(system: System, places: Places) -> tuple[Ties, Array | None, frozenset[str]]:
    """All ties, the direction of gravity (3,) if there is any, and the bodies that are gear wheels."""
    reader = _Reader(places)
    for name, group in groupby(system.held, key=lambda row: row.connection):
        is_flat = name in system.connections and system.connections[name].in_plane
        reader.connection(list(group), is_flat=is_flat)
    gravity = None
    for _name, group in groupby(system.pushes, key=lambda push: push.load):
        pushes = list(group)
        if pushes[0].component and isinstance(pushes[0].measure, Displacement):  # a field: it pushes every body
            gravity = np.array(places.vector(pushes[0].measure.along.components))
            continue
        for push in pushes:
            reader.load(push)
    for body in system.bodies.values():
        for plane in body.planes.values():
            reader.ties.sheets.append(Sheet(places.place(plane.through), places.heading(plane.normal), plane.name))
    return reader.ties, gravity, frozenset(reader.wheels)


class _Reader:
    """Gathers ties row by row."""

    def __init__(self, places: Places) -> None:
        self.place, self.heading, self.vector = places.place, places.heading, places.vector
        self.index, self.number = places.index, places.number
        self.ties = Ties()
        self.wheels: set[str] = set()

    # -- connections --------------------------------------------------------------------------
    def connection(self, rows: Sequence[Held], *, is_flat: bool) -> None:
        """What the rows of one connection show; in a flat one the bodies stay in the plane of x and y anyway."""
        strings = [row for row in rows if is_rope(row)]
        if strings:
            self.ties.strings.append(self._string(strings))
            return
        measures = [row.measure for row in rows if not _is_driven(row)]
        distances = [inner for m in measures if isinstance(inner := sole(m), Distance)]
        self.ties.links.extend((self.place(d.start), self.place(d.end)) for d in distances)
        for m in measures:
            turns = [part for _c, part in m.terms if isinstance(part, Turn)] if isinstance(m, Combination) else []
            if len(turns) == 2:
                self.wheels.update(turn.of.body for turn in turns)
        across = [m for m in measures if isinstance(m, Displacement)]
        if across and not any(isinstance(m, RateMeasure) for m in measures):
            self.ties.joints.append(self._joint(across, measures, is_flat=is_flat))

    def _joint(self, across: Sequence[Displacement], measures: Sequence[Found], *, is_flat: bool) -> Joint:
        """By what is held of the way and of the turn between two bodies."""
        first, second = self.place(across[0].origin), self.place(across[0].of)
        aligned = [m for m in measures if isinstance(m, Alignment)]
        even = [m for m in measures if isinstance(m, Composed) and len(m.measures) == 2]
        threads = any(isinstance(m, Combination) and len(m.terms) == 2 for m in measures)
        n_turns = len(aligned) + len(even)
        if len(across) == 3 and len(aligned) == 1:
            arms = self.heading(aligned[0].along), self.heading(aligned[0].of)
            return Joint(first, second, 3, 1, arms=arms)
        axis = None
        if len(across) == 2:
            axis = self._normal(across[0].along, across[1].along)
            if is_flat:
                return Joint(first, second, 3, 2, axis)
        elif len(across) == 1:
            axis = self.heading(across[0].along)
            if is_flat:  # a guide along the line of which this is the normal
                x, y, _z = axis.along
                return Joint(first, second, 2, 3, Heading(axis.body, (y, -x, 0.0)))
        elif len(aligned) == 2:
            axis = self._normal(aligned[0].along, aligned[1].along)
        return Joint(first, second, len(across), n_turns, axis, has_thread=threads)

    def _normal(self, b: Direction, c: Direction) -> Heading:
        """b x c, for two directions across an axis."""
        along = np.cross(self.vector(b.components), self.vector(c.components))
        return Heading(self.index[b.body], _triple(along / (float(np.linalg.norm(along)) or 1.0)))

    def _string(self, rows: Sequence[Held]) -> tuple[Place, ...]:
        """The places that a string runs by, one after the other."""
        way: list[Place] = []
        for row in rows:
            assert isinstance(row.measure, Combination)
            for _coefficient, measure in row.measure.terms:
                if isinstance(measure, Lead):
                    way += [self.place(measure.start), self.place(measure.end)]
                elif isinstance(measure, Displacement):
                    way += [self.place(measure.origin), self.place(measure.of)]
        return tuple(place for place, _same in groupby(way))

    # -- loads --------------------------------------------------------------------------------
    def load(self, push: Push) -> None:
        measure = sole(push.measure)
        used = free_symbols(push.law)
        if isinstance(measure, Distance):
            ends = self.place(measure.start), self.place(measure.end)
            self.ties.springs.append(Spring(*ends, VALUE.name in used, RATE.name in used))
        elif isinstance(measure, Turn) and used & {VALUE.name, RATE.name}:
            axis = self._normal(measure.start, measure.side)
            self.ties.coils.append(Coil(self.index[measure.of.body], axis))
        elif isinstance(measure, Displacement) and not used & {VALUE.name, RATE.name}:
            self.ties.arrows.append(Arrow(self.place(measure.of), self.heading(measure.along)))
        elif isinstance(measure, RateMeasure):
            self.ties.arrows.extend(self._follower(measure))

    def _follower(self, measure: RateMeasure) -> Iterator[Arrow]:
        """A force along a direction that turns with a body, or a torque about an axis (see `model.spins`)."""
        coefficient, rate = measure.terms[0]
        if isinstance(coefficient, Component) and isinstance(rate, Displacement):
            yield Arrow(self.place(rate.of), self.heading(coefficient.direction))
        elif isinstance(coefficient, Composed) and isinstance(rate, Alignment):
            name, other = coefficient.measures[0]
            sign = evaluate(coefficient.expression, {name: 1.0})
            assert isinstance(other, Alignment)
            axis = self._normal(rate.of, other.of)
            body = rate.along.body if sign < 0 else rate.of.body
            yield Arrow(Place(self.index[body], (0.0, 0.0, 0.0)), axis, turns=True)


def sole(measure: Found) -> Found:
    """The only measure in a combination or an expression of one measure."""
    if isinstance(measure, Combination) and len(measure.terms) == 1:
        return sole(measure.terms[0][1])
    if isinstance(measure, Composed) and len(measure.measures) == 1:
        return measure.measures[0][1]
    return measure


def _is_driven(row: Held) -> bool:
    return row.target is not None and "t" in free_symbols(row.target)


def _triple(v: Array) -> Triple:
    x, y, z = v
    return float(x), float(y), float(z)
