"""Writing a `ModelArrays`: what was entered in a `Packing`, as arrays.

All rows are written once; which of them are held, and along which of them friction slides, makes a layout of its own
(`Written.layout`). The layouts of a system share every array that does not depend on that.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from freebody.language.expression import Expr, free_symbols
from freebody.language.units import LENGTH
from freebody.measures.base import Measure
from freebody.model.elements import VALUE, AppliedLoad, DryFriction, NonholonomicForm
from freebody.numeric.engine.complement import held_entries, schur_complement
from freebody.numeric.engine.lending import lent_sizes
from freebody.numeric.engine.operations import Program
from freebody.numeric.engine.ordering import elimination_order
from freebody.numeric.engine.packed import Composition, Where
from freebody.numeric.engine.packing import Packing
from freebody.numeric.engine.programs import Writer
from freebody.numeric.engine.rows_written import MeasurePlaces, RowSlots
from freebody.numeric.engine.tapes import Tapes
from freebody.numeric.kernels import solving
from freebody.numeric.kernels.arrays import ModelArrays, floats, ints, pointers

# what presses a sliding friction, and what is watched; see `sliding` and `guarding`
BY_LAW, BY_ONE, BY_SIZE = 0, 1, 2
OF_VALUE, OF_RATE, OF_MULTIPLIER, OF_RESERVE, OF_SHARE = range(5)


@dataclass(frozen=True)
class Guard:
    """Something that a mode needs to be positive. of_value: sign (row - offset); of_rate: sign times the rate of a row,
    of slip in a plane that along a direction, sign times the rate of row + sign_across times that of row_across;
    of_multiplier: sign times that of a held row; of_reserve: what dry friction can carry beyond what it does, with the
    shares that follow: friction along the same slip, held by one row."""

    kind: int
    row: int = -1  # row, or place among the rows that may be held
    friction: int = -1
    sign: float = 1.0
    offset: float = 0.0
    n_shares: int = 0
    row_across: int = -1
    sign_across: float = 0.0


class ArrayBuilder:
    """The arrays of a system that do not depend on what is held."""

    def __init__(self, packing: Packing) -> None:
        self.packing = packing
        self.n_bodies = packing.n_bodies
        self.width = packing.measures.width
        self._tapes = Tapes(packing.numbers.values)
        self._writer = Writer(packing.numbers, packing.bearing_of, self._setting)
        self._programs: dict[tuple[int, int, float, int, float], Program] = {}
        self._places = MeasurePlaces(packing)
        self._write()

    # -- everything but what is held ----------------------------------------------------------
    def _write(self) -> None:
        p, places, tapes = self.packing, self._places, self._tapes
        rows = RowSlots(places.n_entries)
        for base in p.bases:
            rows.add_base([(b, o, c) for k, c in base.terms for b, o in places.slots(k)])
        self._number: dict[Where, int] = {("base", k): k for k in range(len(p.bases))}
        composed, read = self._compositions(rows)
        products, multiplied = self._products(rows)
        # whose rates are asked for: what expressions and products read, and what is watched
        rated = {*read, *multiplied, *(self._number[where] for where in p.watched)}
        applied_loads = self._pushes(rated)
        self._held = [self._hold(k) for k in range(len(p.held))]
        self._held_slots: list[list[tuple[int, int]]] = [rows.slots[held["row"]] for held in self._held]
        self._limits = [self._limit(slide.friction, rated) for slide in p.dry_friction]
        self._masses = self._masses_of(self._driven())
        base_terms = [[(places.new[k], c) for k, c in base.terms] for base in p.bases]
        self.rows = {measure: self._number[where] for measure, where in p.by_measure.items()}
        self._measures = {row: measure for measure, row in self.rows.items()}
        for entry, held in zip(p.held, self._held, strict=True):
            self._measures.setdefault(held["row"], entry.held.measure)
        self._fixed: dict[str, Any] = {
            **self._masses,
            "constant_force": p.constant_force.ravel().copy(),
            "kinds": ints(places.kinds),
            "starts": ints(places.starts[:-1]),
            "measure_bodies": ints(places.bodies, 2),
            "measure_numbers": floats(places.numbers),
            "term_ptr": pointers(base_terms),
            "term_measure": ints([k for terms in base_terms for k, _c in terms]),
            "term_coefficient": floats([c for terms in base_terms for _k, c in terms]),
            "row_constant": floats([b.constant for b in p.bases] + [0.0] * (len(rows.slots) - len(p.bases))),
            "slot_ptr": pointers(rows.slots),
            "slots": ints([slot for slots in rows.slots for slot in slots], 2),
            "mix": ints([m[:2] for m in rows.mix], 2),
            "mix_coefficient": floats([m[2] for m in rows.mix]),
            "cleared": ints(rows.cleared),
            "rated": ints(sorted(r for r in rated if r < len(p.bases))),
            "product": ints(products, 2, 3),
            "product_mix": ints(rows.product_mix, 2, 3),
            "composed": ints(composed, 2),
            "composed_mix": ints(rows.composed_mix, 2, 4),
            "tape_ptr": ints(tapes.ptr),
            "tape": ints(list(zip(tapes.ops, tapes.left, tapes.right, strict=True)), 2, 3),
            "tape_number": floats(tapes.constants),
            "load": ints([(load["row"], load["tape"], load["works"]) for load in applied_loads], 2, 3),
            "load_law": floats(np.array([load["law"] for load in applied_loads]).reshape(-1, 3)),
        }

    def _compositions(self, rows: RowSlots) -> tuple[list[tuple[int, int]], set[int]]:
        """Rows that are expressions, as (row, tape), and the rows that they read."""
        composed: list[tuple[int, int]] = []
        read: set[int] = set()
        for k, other in enumerate(self.packing.other):
            if isinstance(other, Composition):
                r = self._number["other", k] = len(rows.slots)
                used = sorted(set(other.inputs.values()))
                read |= set(used)
                tape = self._tapes.write(other.expr, {n: (row, 0.0) for n, row in other.inputs.items()})
                rows.add_composed(len(composed), used)
                composed.append((r, tape))
        return composed, read

    def _products(self, rows: RowSlots) -> tuple[list[tuple[int, int, int]], set[int]]:
        """Products of a coefficient and the rate of a measure, as (row of the sum, coefficient, measure), and the rows
        that they read."""
        products: list[tuple[int, int, int]] = []
        read: set[int] = set()
        for k, other in enumerate(self.packing.other):
            if not isinstance(other, Composition):
                r = self._number["other", k] = len(rows.slots)
                terms = [(self._number[c], self._number[m]) for c, m in other.terms]
                read |= {x for pair in terms for x in pair}
                rows.add_product([(len(products) + j, m) for j, (_c, m) in enumerate(terms)])
                products += [(r, c, m) for c, m in terms]
        return products, read

    def _driven(self) -> set[int]:
        """Coordinates on which a row that may be held, or a load, can act."""
        p = self.packing
        wheres = [held.where for held in p.held] + [applied[0] for applied in p.applied_loads]
        pieces = {k for where in wheres for k in p.pieces_of(where)}
        entries = [(3 * cell + i, o + i) for k in pieces for cell, o in self._places.slots(k) for i in range(3)]
        constant = np.flatnonzero(p.constant_force)
        return {c for c, o in entries if self._places.unchanging.get(o) != 0.0} | set(constant.tolist())

    def _masses_of(self, driven: set[int]) -> dict[str, Any]:
        """Inverse masses, and what is lent where a body has none: but not to the spin of a thin rod that nothing turns
        about its own axis, which goes on as it is."""
        numbers, cells, n = self.packing.numbers, self.packing.cells, 3 * self.width
        masses = np.zeros((self.n_bodies + 1, n))
        turns = np.zeros((self.n_bodies + 1, n), dtype=bool)
        gyration: list[tuple[float, ...]] = []
        for k, b in enumerate(numbers.system.all_moving):
            masses[k], turns[k] = cells.masses(b)
            gyration += cells.gyration(b)
        is_driven = np.isin(np.arange(masses.size).reshape(masses.shape), sorted(driven)) | (self.width == 1)
        lacks = turns & (masses == 0.0) & is_driven
        lent = np.where(lacks, self.packing.part_lent * lent_sizes(numbers, cells, masses), 0.0)
        used = masses + lent
        inverse = np.divide(1.0, used, out=np.zeros_like(used), where=turns & (used > 0.0))
        return {
            "inverse_mass": inverse.ravel(),
            "mass_gap": lent.ravel(),
            "has_gap": ints([solving.LENDS * int(lent.any())]),
            "gyration": floats(np.array(gyration).reshape(-1, 3)),
        }

    def _hold(self, k: int) -> dict[str, Any]:
        """One row that may be held."""
        p = self.packing
        entry = p.held[k]
        target = entry.target
        other = p.other[entry.where[1]] if entry.where[0] == "other" else None
        moves = isinstance(other, Composition) and "t" in free_symbols(other.expr)
        return {
            "row": self._number[entry.where],
            "tape": -1 if target is None else self._tapes.write(target, {}),
            "is_place": entry.is_place,
            "works": target is not None or moves,
            "scale": 1.0 / p.numbers.length if entry.held.measure.dimension == LENGTH else 1.0,
        }

    def _pushes(self, rated: set[int]) -> list[dict[str, Any]]:
        p = self.packing
        written: list[dict[str, Any]] = []
        for where, load, linear, works in p.applied_loads:
            r = self._number[where]
            tape = -1
            if works or (linear is not None and linear[2] != 0.0):
                rated.add(r)
            if linear is None:
                is_place = not isinstance(load.measure, NonholonomicForm)
                origin = p.numbers.start_value(load.measure) if is_place else 0.0  # pyrefly: ignore[bad-argument-type]
                inputs = {VALUE.name: (r, -origin)}
                tape = self._law(load.law, load, inputs, {"@rate": r}, rated)
            written.append({"row": r, "tape": tape, "law": linear or (0.0, 0.0, 0.0), "works": works})
        return written

    def _law(
        self,
        law: Expr,
        of: AppliedLoad | DryFriction,
        inputs: dict[str, tuple[int, float]],
        rates: dict[str, int],
        rated: set[int] | None = None,
    ) -> int:
        """The tape of a law in time and in the measures of a load or of dry friction."""
        for name, other in of.measures:
            row = self._number[self.packing.row(other)]
            inputs[name], rates[f"rate({name})"] = (row, 0.0), row
            if rated is not None:
                rated.add(row)
        return self._tapes.write(law, inputs, rates)

    def _limit(self, friction: DryFriction, rated: set[int]) -> tuple[int, int]:
        """The tapes of the limits, at rest and in motion, of dry friction that nothing presses; else -1."""
        if friction.load:
            return -1, -1
        static, kinetic = (self._law(law, friction, {}, {}, rated) for law in (friction.static, friction.kinetic))
        return static, kinetic

    # -- what is held -------------------------------------------------------------------------
    def layout(
        self,
        chosen: Sequence[int] | None = None,
        sliding: Sequence[tuple[int, int]] = (),
        guards: Sequence[Guard] = (),
    ) -> tuple[ModelArrays, list[int]]:
        """The layout with the chosen rows held (all of them if nothing is said), friction sliding along (friction,
        direction), and the given guards; and the order of the held rows, places among the chosen ones. Friction in a
        plane is pointed afterwards (`point`)."""
        held = list(range(len(self._held))) if chosen is None else list(chosen)
        sequence = elimination_order([frozenset(c // self.width for c, _o in self._held_slots[k]) for k in held])
        sorted_held = [held[k] for k in sequence]
        place = {k: n for n, k in enumerate(sorted_held)}
        entries = [
            held_entries(self._held_slots[k], self._places.unchanging, self._masses["inverse_mass"])
            for k in sorted_held
        ]
        rows = [self._held[k] for k in sorted_held]
        slides: list[tuple[tuple[int, ...], tuple[float, ...]]] = []
        for friction, direction in sliding:
            slides += self._slides(friction, direction, place, len(slides))
        watched = [self._guard(guard, place) for guard in guards]
        layout = ModelArrays(
            **self._fixed,
            held=ints([(h["row"], h["tape"], h["is_place"], h["works"]) for h in rows], 2, 4),
            held_scale=floats([h["scale"] for h in rows]),
            held_ptr=pointers(entries),
            held_slots=ints([(c, o) for slots in entries for c, o, _fixed in slots], 2),
            slide=ints([slide[0] for slide in slides], 2, 7),
            slide_factor=floats(np.array([slide[1] for slide in slides]).reshape(-1, 4)),
            guard=ints([guard[0] for guard in watched], 2, 7),
            guard_factor=floats(np.array([guard[1] for guard in watched]).reshape(-1, 4)),
            **schur_complement(entries, self._masses["inverse_mass"]),
        )
        return layout, sequence

    def keep(self, friction: int, value: float) -> None:
        """What a sticking friction keeps its measure at from now on, in all layouts."""
        self.keep_at(self.packing.dry_friction[friction].keeps, value)

    def keep_across(self, friction: int, value: float) -> None:
        """The same of its row across."""
        self.keep_at(self.packing.dry_friction[friction].keeps_across, value)

    def keep_at(self, place: int, value: float) -> None:
        """What a row at a place among those that may be held keeps its measure at from now on, in all layouts."""
        where = self.packing.held[place].where
        if where[0] == "base":
            self._fixed["row_constant"][where[1]] = self.packing.bases[where[1]].constant - value

    def put(self, measure: Measure, value: float) -> None:
        """What a setting is from now on, in all layouts. Programs, in which it is a number, are those of layouts that
        are made from now on."""
        constants, row = self._fixed["row_constant"], self.packing.settings[measure]
        if constants[row] != value:
            constants[row] = value
            self._programs.clear()
            self._writer.forget()

    def _setting(self, measure: Measure) -> float | None:
        """What a setting is now; None of another measure."""
        row = self.packing.settings.get(measure)
        return None if row is None else float(self._fixed["row_constant"][row])

    def row_of_friction(self, friction: int) -> int:
        """The row of the slip of dry friction."""
        return self._number[self.packing.dry_friction[friction].where]

    def across_of_friction(self, friction: int) -> int:
        """The row of its slip across, or -1."""
        across = self.packing.dry_friction[friction].across
        return -1 if across is None else self._number[across]

    def program(self, row: int, order: int, sign: float = 1.0, across: int = -1, sign_across: float = 0.0) -> Program:
        """The value (order 0) or the rate (order 1) of a row, up to a constant, by a sign; with another row by another
        sign."""
        key = row, order, sign, across, sign_across
        if key not in self._programs:
            parts = [(self._measures[row], sign)]
            parts += [(self._measures[across], sign_across)] if across >= 0 else []
            self._programs[key] = self._writer.program(order, parts)
        return self._programs[key]

    def row_of_held(self, k: int) -> int:
        """The row that may be held at a place."""
        return self._held[k]["row"]

    def limit_tapes(self, friction: int) -> tuple[int, int]:
        """The tapes of the limits, at rest and in motion, of dry friction that nothing presses."""
        return self._limits[friction]

    def _loads(self, friction: int, place: Mapping[int, int]) -> tuple[int, int, int]:
        slide = self.packing.dry_friction[friction]
        a, b = (*(place.get(k, -1) for k in slide.loads), -1, -1)[:2]
        return (BY_LAW if not slide.loads else BY_SIZE if len(slide.loads) > 1 else BY_ONE), a, b

    def _slides(
        self, friction: int, direction: int, place: Mapping[int, int], n_before: int
    ) -> list[tuple[tuple[int, ...], tuple[float, ...]]]:
        """The rows along which a friction slides; two of one in a plane."""
        slide = self.packing.dry_friction[friction]
        kind, a, b = self._loads(friction, place)
        c = 1.0 if kind == BY_LAW else self.packing.numbers.number(slide.friction.coefficient(direction))
        across, tape = self.across_of_friction(friction), self._limits[friction][1]
        factors = -direction * c, float(slide.sign), 0.0, 0.0
        rows = [(self.row_of_friction(friction), -1)]
        if across >= 0:
            rows = [(rows[0][0], n_before + 1), (across, n_before)]
        return [((row, kind, a, b, tape, 1, other), factors) for row, other in rows]

    def _guard(self, guard: Guard, place: Mapping[int, int]) -> tuple[tuple[int, ...], tuple[float, ...]]:
        if guard.kind == OF_MULTIPLIER:
            return (guard.kind, place[guard.row], -1, -1, -1, 0, -1), (guard.sign, 0.0, 0.0, 0.0)
        if guard.kind in (OF_VALUE, OF_RATE):
            factors = guard.sign, guard.offset, guard.sign_across, 0.0
            return (guard.kind, guard.row, guard.row_across, -1, -1, 0, -1), factors
        slide = self.packing.dry_friction[guard.friction]
        kind, a, b = self._loads(guard.friction, place)
        # a positive multiplier resists a falling measure
        down, up = (
            1.0 if kind == BY_LAW else self.packing.numbers.number(slide.friction.coefficient(d, at_rest=True))
            for d in (-1, 1)
        )
        at = -1 if guard.kind == OF_SHARE else place[slide.keeps]
        across = -1 if guard.kind == OF_SHARE or slide.across is None else place[slide.keeps_across]
        return (guard.kind, at, a, b, self._limits[guard.friction][0], guard.n_shares, across), (
            float(slide.sign),
            down,
            up,
            float(kind),
        )
