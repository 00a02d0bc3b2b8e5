"""A system as time stepping sees it: what is held, what may touch, and the arrays of both."""

from __future__ import annotations

import math
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from freebody.numeric.engine.evaluator import Packed
from freebody.numeric.engine.packing import Packing
from freebody.numeric.kernels.arrays import Floats
from freebody.numeric.kernels.near import close_circles
from freebody.numeric.kernels.rows import N_NUMBER, N_WHAT, ClosedRows
from freebody.numeric.numbers import Numbers
from freebody.numeric.timestepping import near
from freebody.numeric.timestepping.candidates import Built, built, keep_memory
from freebody.numeric.timestepping.fixtures import SystemParts
from freebody.numeric.timestepping.shapes import Outlines
from freebody.numeric.timestepping.templates import Template

KEPT = 1e-2  # part of the mass lent to massless bodies that they keep here, where nothing takes it back
SLOP = 1e-6  # by the size of the smallest outline: gaps below count as closed, penetrations as none
SKIN = 0.35  # by the size of the smallest outline
FEW = 16  # so many pairs are all looked at in every step


class ContactScene:
    """The contact data of a system, packed. Raises CannotAnswer where a measure has no kernel."""

    def __init__(self, numbers: Numbers) -> None:
        system = numbers.system
        self.numbers = numbers
        self.parts = SystemParts.of(system.constraint_rows, system.limits, system.brakes)
        packing = Packing(numbers)
        packing.part_lent = KEPT
        self.parts.enter(packing)
        for load in system.applied_loads:
            packing.load(load)
        for measure in system.all_measures.values():
            packing.watch(measure)
        self.packed = Packed(numbers, packing)
        self.n_bodies = self.packed.n_bodies
        self.place_of = np.empty(len(self.packed.order), np.intp)
        self.place_of[self.packed.order] = np.arange(len(self.packed.order))
        self.fixtures = self.parts.fixtures(numbers, self.packed.rows, [int(k) for k in self.place_of])
        self._read_contacts()
        self._grow(64)

    @property
    def lent(self) -> tuple[str, ...]:
        """The bodies without mass that have a little of it here."""
        gap = self.packed.layout.mass_gap.reshape(self.n_bodies + 1, -1)
        return tuple(body.name for body, own in zip(self.numbers.system.all_moving, gap, strict=False) if own.any())

    @property
    def is_jointed(self) -> NDArray[np.int32]:
        """For every body whether held rows are on it."""
        found = np.zeros(self.n_bodies + 1, np.int32)
        found[self.packed.layout.held_slots[:, 0] // 3] = 1
        return found

    # -- what may touch -----------------------------------------------------------------------
    def _read_contacts(self) -> None:
        pairs = self.numbers.system.contacts
        bodies = {body.name: k for k, body in enumerate(self.numbers.system.all_moving)}
        self.outlines = Outlines.of(pairs, self.numbers, bodies, self.n_bodies)
        o, n = self.outlines, len(self.outlines.outlines)
        self.ends = (
            np.array([o.number_of(pair.first) for pair in pairs], np.intp),
            np.array([o.number_of(pair.second) for pair in pairs], np.intp),
        )
        surfaces: dict[int, tuple[float, ...]] = {}
        for pair in pairs:
            s = pair.surface
            if id(s) not in surfaces:
                exprs = (s.friction.static, s.friction.kinetic, s.restitution, s.rolling_resistance)
                surfaces[id(s)] = tuple(self.numbers.number(e) for e in exprs)
        self.surfaces = np.array([surfaces[id(pair.surface)] for pair in pairs]).reshape(-1, 4)
        self._pair_of = np.full((n, n), -1, np.int32)
        numbers = np.arange(len(pairs), dtype=np.int32)
        self._pair_of[self.ends[0], self.ends[1]] = numbers
        self._pair_of[self.ends[1], self.ends[0]] = numbers
        self.templates: dict[tuple[int, int], Template] = {}
        is_hollow = np.array([o.shapes[k].n_hollows > 0 for k in map(int, o.shape)], bool)
        is_round = np.isfinite(o.radius) & ~is_hollow
        self._circles = np.flatnonzero(is_round)
        self._others = np.flatnonzero(~is_round)
        self._order = np.arange(len(self._circles), dtype=np.int32)
        moving = np.flatnonzero(np.isfinite(o.radius) & (o.body < self.n_bodies))
        self.circle_body = o.body[moving].astype(np.int32)
        self.circle = np.ascontiguousarray(o.center[moving])
        sizes = o.radius[is_round & (o.radius > 0.0)]
        self.size = float(sizes.min()) if len(sizes) else self.numbers.length
        self.slop = SLOP * self.size
        self.built = self._built(np.zeros(0, np.intp))
        self._room = np.zeros((max(64, 8 * n), 1), np.int32)

    def look(self, q: Floats, margin: float) -> tuple[Built, Floats]:
        """The candidates of a pose, and where the circles about outlines are in it."""
        o = self.outlines
        where = near.placed(q, o.body, o.center)
        found = self._near(q, where, margin)
        new = self._built(found)
        keep_memory(new, self.built)
        self.built = new
        return new, np.ascontiguousarray(near.placed(q, self.circle_body, self.circle))

    def _near(self, q: Floats, where: Floats, margin: float) -> NDArray[np.intp]:
        """Numbers of near pairs, ascending."""
        o, circles = self.outlines, self._circles
        found: list[NDArray[np.intp]] = []
        if len(circles) > 1:
            pair_of = self._pair_of if len(circles) == len(o.outlines) else self._circle_pairs
            centers, radii = np.ascontiguousarray(where[circles]), np.ascontiguousarray(o.radius[circles])
            n = close_circles(centers, radii, self._order, margin, pair_of, self._room)
            while n > len(self._room):
                self._room = np.zeros((2 * n, 1), np.int32)
                n = close_circles(centers, radii, self._order, margin, pair_of, self._room)
            found.append(self._room[:n, 0].astype(np.intp))
        for other in self._others:
            k = int(other)
            pairs = self._pair_of[k]
            partners = np.flatnonzero(pairs >= 0)
            at, radii = where[partners], o.radius[partners]
            shape, row = o.shapes[int(o.shape[k])], o.values[int(o.shape[k])][int(o.place[k])]
            if shape.n_hollows:
                is_near = near.close_to_ring(at, radii, where[k], o.radius[k], margin)
            elif shape.is_fixed and len(shape.straights) == 1 and not shape.rounds:
                is_near = near.close_to_line(at, radii, row[0:2], row[2:4], margin)
            else:
                is_near = np.ones(len(partners), bool)
            found.append(pairs[partners[is_near]].astype(np.intp))
        return np.unique(np.concatenate(found)) if found else np.zeros(0, np.intp)

    @cached_property
    def _circle_pairs(self) -> NDArray[np.int32]:
        return np.ascontiguousarray(self._pair_of[np.ix_(self._circles, self._circles)])

    def _built(self, found: NDArray[np.intp]) -> Built:
        return built(self.outlines, self.templates, found, self.ends, self.surfaces, self.n_bodies)

    def skin(self, fastest: float, step: float) -> float:
        """The margin with which candidates are looked for: a part of the smallest outline, or some steps' way."""
        if len(self.ends[0]) <= FEW:
            return math.inf
        return max(SKIN * self.size, 4.0 * step * fastest)

    # -- room ---------------------------------------------------------------------------------
    def _grow(self, n_rows: int) -> None:
        wide = 3 * (self.n_bodies + 1)
        per_row = max(9, wide if len(self.packed.layout.held) else 9)
        longest = max([9, *(3 * int(n) for n in np.diff(self.packed.layout.slot_ptr))])
        self.rows = ClosedRows(
            count=np.zeros(8, np.int32),
            ptr=np.zeros(n_rows + 2, np.int32),
            coordinate=np.zeros(n_rows * longest, np.int32),
            entry=np.zeros(n_rows * longest),
            response_ptr=np.zeros(n_rows + 2, np.int32),
            response_at=np.zeros(n_rows * max(per_row, longest), np.int32),
            response=np.zeros(n_rows * max(per_row, longest)),
            what=np.zeros((n_rows, N_WHAT), np.int32),
            number=np.zeros((n_rows, N_NUMBER)),
            local=np.zeros(6),
            wide=np.zeros(wide),
        )

    def grow(self) -> None:
        """Twice the room for rows."""
        self._grow(2 * len(self.rows.what))

    # -- names --------------------------------------------------------------------------------
    def site_name(self, pair: int, place: int) -> str:
        """What the model calls a site."""
        bounds, _friction = self.numbers.system.contacts[pair].elements()
        return bounds[place].name
