"""Packing: a system becomes arrays. Everything that is known before the motion is decided here."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, fields
from typing import Any

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.expression import ZERO, Expr, Symbol, differentiate, free_symbols, has_jump, substitute
from freebody.language.units import LENGTH
from freebody.measures.base import Measure
from freebody.measures.combination import Combination, Composed
from freebody.measures.geometry import Direction, Point
from freebody.model.elements import RATE, VALUE, Component, Held, Push, RateMeasure
from freebody.numeric.engine.complement import held_entries, schur_complement
from freebody.numeric.engine.laws import linear_law, stored_law
from freebody.numeric.engine.layout import Floats, Layout, floats, ints, pointers
from freebody.numeric.engine.measures_planar import KINDS, MAX_BODIES, MAX_NUMBERS, fill
from freebody.numeric.engine.ordering import elimination_order
from freebody.numeric.engine.tapes import Tapes
from freebody.numeric.numbers import Numbers

Terms = tuple[tuple[int, float], ...]  # (measure, coefficient)
_MASSLESS = 1e-4  # mass lent to a body without any, by the typical mass of the others


@dataclass(frozen=True)
class _Base:
    """constant + sum of coefficient * measure."""

    constant: float
    terms: Terms


@dataclass
class _Composed:
    """An expression in base rows and time."""

    expr: Expr
    inputs: dict[str, int]


@dataclass
class _Product:
    """Sum of c(pose) dm/dt, both c and m rows of their own."""

    terms: list[tuple[tuple[str, int], tuple[str, int]]]


_Key = tuple[tuple[int, ...], tuple[float, ...]]  # bodies and numbers of a measure
_Where = tuple[str, int]  # "base" or "other", and the place there


class Packing:
    """Collects measures, rows, held rows and loads of a system, then makes a `Layout` of them."""

    def __init__(self, numbers: Numbers) -> None:
        self.numbers = numbers
        self._bodies = {body.name: k for k, body in enumerate(numbers.system.moving)}
        self.n_bodies = len(self._bodies)
        self._constant_force = np.zeros((self.n_bodies + 1, 3))
        self._measures: list[dict[_Key, int]] = [{} for _ in KINDS]
        self._pieces: list[tuple[int, _Key]] = []
        self._with_bearing: dict[int, tuple[Measure, float, float | None]] = {}
        self._base: dict[_Base, int] = {}
        self._bases: list[_Base] = []
        self._other: list[_Composed | _Product] = []
        self._by_measure: dict[Measure | RateMeasure, _Where] = {}
        self._held: list[tuple[_Where, Expr | None, Held]] = []
        self._watched: list[_Where] = []
        self._pushes: list[tuple[_Where, Push, tuple[float, float, float] | None, bool]] = []

    # -- measures -----------------------------------------------------------------------------
    def _body(self, name: str) -> int:
        return self._bodies.get(name, self.n_bodies)

    def _point(self, point: Point) -> tuple[int, tuple[float, float]]:
        """Body and components of a point; one of a fixed body is one of the ground."""
        x, y = (self.numbers.number(c) for c in point.offset)
        if point.body in self._bodies:
            return self._bodies[point.body], (x, y)
        gx, gy, c, s = self.numbers.fixed_pose(point.body)
        return self.n_bodies, (gx + c * x - s * y, gy + s * x + c * y)

    def _direction(self, direction: Direction) -> tuple[int, tuple[float, float]]:
        x, y = (self.numbers.number(c) for c in direction.components)
        if direction.body in self._bodies:
            return self._bodies[direction.body], (x, y)
        _x, _y, c, s = self.numbers.fixed_pose(direction.body)
        return self.n_bodies, (c * x - s * y, s * x + c * y)

    def _elementary(self, measure: Measure) -> _Base | None:
        """A row of one elementary measure, entered in the arrays of its kind."""
        name = type(measure).__name__
        if all(kind.name != name for kind in KINDS):
            return None
        bodies: list[int] = []
        numbers: list[float] = []
        constant = 0.0
        on_ground: set[str] = set()
        for f in fields(measure):  # type: ignore[arg-type]
            value: Any = getattr(measure, f.name)
            if isinstance(value, Point):
                body, components = self._point(value)
            elif isinstance(value, Direction):
                body, components = self._direction(value)
            elif isinstance(value, str):
                body, components = self._body(value), ()
                if body == self.n_bodies:  # the angle of a fixed body is a number
                    constant += self._fixed_angle(measure, f.name, value)
            else:
                numbers.append(self.numbers.number(value))
                continue
            bodies.append(body)
            numbers += components
            if body == self.n_bodies:
                on_ground.add(f.name)
        index = next(i for i, kind in enumerate(KINDS) if kind.name == name and set(kind.fixed) <= on_ground)
        kind = KINDS[index]
        names = [f.name for f in fields(measure) if isinstance(getattr(measure, f.name), (Point, Direction, str))]  # type: ignore[arg-type]
        bodies = [b for n, b in zip(names, bodies, strict=True) if n not in kind.fixed]
        key = (tuple(bodies), tuple(numbers))
        known = self._measures[index]
        if key not in known:
            known[key] = len(self._pieces)
            self._pieces.append((index, key))
            if kind.has_bearing and name != "Distance":
                self._with_bearing[known[key]] = (measure, constant, numbers[-1] if name == "Lead" else None)
        return _Base(constant, ((known[key], 1.0),))

    def _fixed_angle(self, measure: Measure, field_name: str, body: str) -> float:
        """What the angle of a fixed body adds to a measure that reads it: measures are linear in angles."""
        angle = self.numbers.fixed_angle(body)
        return angle if field_name == "of" else -angle

    # -- rows ---------------------------------------------------------------------------------
    def _linear(self, measure: Measure) -> _Base | None:
        """A measure as a combination of elementary ones with constant coefficients, if it is one."""
        if isinstance(measure, Combination):
            total = _Base(0.0, ())
            for coefficient, part in measure.terms:
                inner = self._linear(part)
                if inner is None or "t" in free_symbols(coefficient):
                    return None
                total = _sum(total, inner, self.numbers.number(coefficient))
            return total
        if isinstance(measure, Composed):
            names = dict(measure.measures)
            slopes = {name: differentiate(measure.expression, name) for name in names}
            if any(free_symbols(s) & (names.keys() | {"t"}) for s in slopes.values()) or has_jump(
                measure.expression, names
            ):
                return None
            rest = substitute(measure.expression, dict.fromkeys(names, ZERO))
            if "t" in free_symbols(rest):
                return None
            total = _Base(self.numbers.number(rest), ())
            for name, part in names.items():
                inner = self._linear(part)
                if inner is None:
                    return None
                total = _sum(total, inner, self.numbers.number(slopes[name]))
            return total
        return self._elementary(measure)

    def row(self, measure: Measure | RateMeasure) -> _Where:
        """The row of a measure, made when it is first asked for."""
        if measure not in self._by_measure:
            self._by_measure[measure] = self._new_row(measure)
        return self._by_measure[measure]

    def _new_row(self, measure: Measure | RateMeasure) -> _Where:
        if isinstance(measure, RateMeasure):
            terms = [(self._coefficient(c), self.row(m)) for c, m in measure.terms]
            self._other.append(_Product(terms))
            return "other", len(self._other) - 1
        linear = self._linear(measure)
        if linear is not None:
            return "base", self._enter(linear)
        inputs: dict[str, int] = {}
        expr = self._expression(measure, inputs)
        self._other.append(_Composed(expr, inputs))
        return "other", len(self._other) - 1

    def _enter(self, base: _Base) -> int:
        if base not in self._base:
            self._base[base] = len(self._bases)
            self._bases.append(base)
        return self._base[base]

    def _coefficient(self, coefficient: Component | Measure) -> _Where:
        if not isinstance(coefficient, Component):
            return self.row(coefficient)
        from freebody.measures.displacement import Displacement
        from freebody.measures.geometry import RIGHT, UP, ZERO

        d = coefficient.direction
        tip, foot = Point(d.body, d.components), Point(d.body, (ZERO, ZERO))
        return self.row(Displacement(tip, foot, RIGHT if coefficient.axis == "x" else UP))

    def _expression(self, measure: Measure, inputs: dict[str, int]) -> Expr:
        """A measure as an expression in base rows, which are entered in `inputs` under names of their own."""
        linear = self._linear(measure)
        if linear is not None:
            row = self._enter(linear)
            inputs[f"@row{row}"] = row
            return Symbol(f"@row{row}")
        if isinstance(measure, Composed):
            return substitute(measure.expression, {n: self._expression(m, inputs) for n, m in measure.measures})
        if isinstance(measure, Combination):
            total: Expr = ZERO
            for coefficient, part in measure.terms:
                total = total + coefficient * self._expression(part, inputs)
            return total
        raise CannotAnswer(f"no kernel is written for the measure {type(measure).__name__}; run tools/write_kernels.py")

    def bearings(self) -> list[tuple[int, Measure, float, float | None]]:
        """Measures that count turns: their place in the layout, the measure, what the angle of a fixed body adds to it,
        and, for a lead, its rho."""
        place = self._places()
        found = [(place[old], *rest) for old, rest in self._with_bearing.items()]
        return [item for item in found if item[3] is None or item[3] != 0.0]

    def keys(self) -> dict[tuple[int, _Key], int]:
        """Measures that count turns, with their place in the layout: the same measure has the same key everywhere."""
        return {self._pieces[old]: place for old, place in self._places().items() if old in self._with_bearing}

    def _places(self) -> dict[int, int]:
        order = sorted(range(len(self._pieces)), key=lambda k: self._pieces[k][0])
        return {old: new for new, old in enumerate(order)}

    @property
    def pushes(self) -> list[Push]:
        """The loads that are not constant forces."""
        return [push for _where, push, _linear, _works in self._pushes]

    # -- held rows and loads ------------------------------------------------------------------
    def hold(self, held: Held) -> None:
        """Enters a held row; what it is held at, as far as it is constant, becomes part of the row."""
        row, target = self.row(held.measure), held.target
        if isinstance(held.measure, RateMeasure):
            self._held.append((row, target, held))
            return
        offset = 0.0
        if target is None:
            offset = self.numbers.start_value(held.measure)
        elif "t" not in free_symbols(target):
            offset, target = self.numbers.number(target), None
        if offset and row[0] == "base":
            base = self._bases[row[1]]
            row = "base", self._enter(_Base(base.constant - offset, base.terms))
        elif offset:
            composed = self._other[row[1]]
            assert isinstance(composed, _Composed)
            self._other.append(_Composed(composed.expr - _exact(offset), composed.inputs))
            row = "other", len(self._other) - 1
        self._held.append((row, target, held))

    def watch(self, measure: Measure | RateMeasure) -> None:
        """Enters a measure whose value and rate are wanted."""
        self._watched.append(self.row(measure))

    def push(self, push: Push) -> None:
        """Enters a load. One that never changes becomes a constant force."""
        linear = linear_law(push.law, self.numbers.values)
        if linear is not None and not isinstance(push.measure, RateMeasure):
            if linear[1:] == (0.0, 0.0) and self._is_constant(push.measure, linear[0]):
                return
            origin = self.numbers.start_value(push.measure)
            linear = (linear[0] - linear[1] * origin, linear[1], linear[2])
        for _name, other in push.measures:
            self.row(other)
        works = stored_law(push, self.numbers.values) is None
        self._pushes.append((self.row(push.measure), push, linear, works))

    def _is_constant(self, measure: Measure, force: float) -> bool:
        """Adds the generalized force of a constant push along a measure with a constant gradient."""
        linear = self._linear(measure)
        if linear is None:
            return False
        forces = np.zeros_like(self._constant_force)
        for k, coefficient in linear.terms:
            index, (bodies, numbers) = self._pieces[k]
            name = KINDS[index].name
            if name == "Angle":
                forces[bodies[0], 2] += coefficient
                forces[bodies[1], 2] -= coefficient
            elif name == "Displacement" and KINDS[index].fixed:
                for body, offset, sign in ((bodies[0], numbers[:2], 1.0), (bodies[1], numbers[2:4], -1.0)):
                    if body != self.n_bodies and any(offset):
                        return False
                    forces[body, 0] += sign * coefficient * numbers[4]
                    forces[body, 1] += sign * coefficient * numbers[5]
            else:
                return False
        self._constant_force += force * forces
        self._constant_force[self.n_bodies] = 0.0
        return True

    # -- the layout ---------------------------------------------------------------------------
    def layout(self) -> tuple[Layout, list[int], dict[Any, int]]:
        """The arrays; the order of the held rows (places in the order in which they were entered); and the row of
        every measure that was asked for."""
        order = sorted(range(len(self._pieces)), key=lambda k: self._pieces[k][0])
        new_place = {old: new for new, old in enumerate(order)}
        counts = [sum(1 for index, _ in self._pieces if index == i) for i in range(len(KINDS))]
        kinds = np.concatenate(([0], np.cumsum(counts)))
        starts = np.concatenate(([0], np.cumsum([3 * k.n_bodies * c for k, c in zip(KINDS, counts, strict=True)])))
        n_entries = int(starts[-1])
        measure_bodies = np.zeros((len(order), MAX_BODIES))
        measure_numbers = np.zeros((len(order), MAX_NUMBERS))
        for new, old in enumerate(order):
            _index, (bodies, numbers) = self._pieces[old]
            measure_bodies[new, : len(bodies)] = bodies
            measure_numbers[new, : len(numbers)] = numbers

        def slots_of_measure(old: int) -> list[tuple[int, int]]:
            index, (bodies, _numbers) = self._pieces[old]
            begin = int(starts[index]) + 3 * len(bodies) * (new_place[old] - int(kinds[index]))
            return [(b, begin + 3 * j) for j, b in enumerate(bodies) if b != self.n_bodies]

        rows = _Rows(n_entries)
        bases = self._bases
        for base in bases:
            pieces = [(b, o, c) for k, c in base.terms for b, o in slots_of_measure(k)]
            rows.add_base(pieces)
        number = {("base", k): k for k in range(len(bases))}
        tapes = Tapes(self.numbers.values)
        products: list[tuple[int, int, int]] = []
        composed: list[tuple[int, int]] = []
        rated: set[int] = set()
        for k, other in enumerate(self._other):
            if isinstance(other, _Composed):
                r = number["other", k] = len(rows.slots)
                used = sorted(set(other.inputs.values()))
                rated |= set(used)
                tape = tapes.write(other.expr, {n: (row, 0.0) for n, row in other.inputs.items()})
                rows.add_composed(len(composed), used)
                composed.append((r, tape))
        for k, other in enumerate(self._other):
            if isinstance(other, _Product):
                r = number["other", k] = len(rows.slots)
                terms = [(number[c], number[m]) for c, m in other.terms]
                rated |= {x for pair in terms for x in pair}
                rows.add_product([(len(products) + j, m) for j, (_c, m) in enumerate(terms)])
                products += [(r, c, m) for c, m in terms]
        rated |= {number[where] for where in self._watched}
        pushes = self._written_pushes(tapes, number, rated)
        held = self._written_held(tapes, number)
        held_slots: list[list[tuple[int, int]]] = [rows.slots[h["row"]] for h in held]
        sequence = elimination_order([frozenset(b for b, _o in s) for s in held_slots])
        held = [held[k] for k in sequence]
        held_slots = [held_slots[k] for k in sequence]
        masses = self._masses()
        unchanging = self._unchanging(n_entries, kinds, starts, measure_numbers)
        entries = [held_entries(slots, unchanging, masses["inverse_mass"]) for slots in held_slots]
        base_terms = [[(new_place[k], c) for k, c in base.terms] for base in bases]
        layout = Layout(
            **masses,
            constant_force=self._constant_force.ravel().copy(),
            kinds=ints(kinds),
            starts=ints(starts[:-1]),
            measure_bodies=ints(measure_bodies, 2),
            measure_numbers=floats(measure_numbers),
            term_ptr=pointers(base_terms),
            term_measure=ints([k for terms in base_terms for k, _c in terms]),
            term_coefficient=floats([c for terms in base_terms for _k, c in terms]),
            row_constant=floats([b.constant for b in bases] + [0.0] * (len(rows.slots) - len(bases))),
            slot_ptr=pointers(rows.slots),
            slots=ints([slot for slots in rows.slots for slot in slots], 2),
            mix=ints([m[:2] for m in rows.mix], 2),
            mix_coefficient=floats([m[2] for m in rows.mix]),
            cleared=ints(rows.cleared),
            rated=ints(sorted(r for r in rated if r < len(bases))),
            product=ints(products, 2, 3),
            product_mix=ints(rows.product_mix, 2, 3),
            composed=ints(composed, 2),
            composed_mix=ints(rows.composed_mix, 2, 4),
            tape_ptr=ints(tapes.ptr),
            tape=ints(list(zip(tapes.ops, tapes.left, tapes.right, strict=True)), 2, 3),
            tape_number=floats(tapes.constants),
            held=ints([(h["row"], h["tape"], h["is_place"], h["works"]) for h in held], 2, 4),
            held_scale=floats([h["scale"] for h in held]),
            held_ptr=pointers(entries),
            held_slots=ints([(c, o) for slots in entries for c, o, _fixed in slots], 2),
            push=ints([(p["row"], p["tape"], p["works"]) for p in pushes], 2, 3),
            push_law=floats(np.array([p["law"] for p in pushes]).reshape(-1, 3)),
            **schur_complement(entries, masses["inverse_mass"]),
        )
        found = {measure: number[where] for measure, where in self._by_measure.items()}
        return layout, sequence, found

    def _unchanging(self, n_entries: int, kinds: Any, starts: Any, numbers: Floats) -> dict[int, float]:
        """Gradient entries of measures that are the same in every pose, with their values."""
        gradient = np.zeros(n_entries)
        fill(ints(kinds), ints(starts), numbers, gradient)
        found: dict[int, float] = {}
        for index, kind in enumerate(KINDS):
            size = 3 * kind.n_bodies
            for k in range(int(kinds[index]), int(kinds[index + 1])):
                begin = int(starts[index]) + size * (k - int(kinds[index]))
                found |= {begin + j: float(gradient[begin + j]) for j in kind.unchanging}
        return found

    def _masses(self) -> dict[str, Any]:
        """Inverse masses, and what is lent to bodies that have none."""
        masses = np.zeros((self.n_bodies + 1, 3))
        turns = np.zeros((self.n_bodies + 1, 3), dtype=bool)
        for body, k in self._bodies.items():
            b = self.numbers.system.bodies[body]
            masses[k, :2] = self.numbers.number(b.mass)
            masses[k, 2] = self.numbers.number(b.inertia) if b.turns else 0.0
            turns[k] = (True, True, b.turns)
        mass = float(masses[:, 0].max(initial=0.0)) or 1.0
        typical = np.array([mass, mass, mass * self.numbers.length**2])
        lent = np.where(turns & (masses == 0.0), _MASSLESS * typical, 0.0)
        used = masses + lent
        inverse = np.divide(1.0, used, out=np.zeros_like(used), where=turns & (used > 0.0))
        return {"inverse_mass": inverse.ravel(), "mass_gap": lent.ravel(), "has_gap": ints([int(lent.any())])}

    def _written_held(self, tapes: Tapes, number: Mapping[_Where, int]) -> list[dict[str, Any]]:
        written: list[dict[str, Any]] = []
        for where, target, held in self._held:
            is_place = not isinstance(held.measure, RateMeasure)
            other = self._other[where[1]] if where[0] == "other" else None
            moves = isinstance(other, _Composed) and "t" in free_symbols(other.expr)
            written.append(
                {
                    "row": number[where],
                    "tape": -1 if target is None else tapes.write(target, {}),
                    "is_place": is_place,
                    "works": target is not None or moves,
                    "scale": 1.0 / self.numbers.length if held.measure.dimension == LENGTH else 1.0,
                }
            )
        return written

    def _written_pushes(self, tapes: Tapes, number: Mapping[_Where, int], rated: set[int]) -> list[dict[str, Any]]:
        written: list[dict[str, Any]] = []
        for where, push, linear, works in self._pushes:
            r = number[where]
            tape = -1
            if works or (linear is not None and linear[2] != 0.0):
                rated.add(r)
            if linear is None:
                is_place = not isinstance(push.measure, RateMeasure)
                origin = self.numbers.start_value(push.measure) if is_place else 0.0  # type: ignore[arg-type]
                inputs, rates = {VALUE.name: (r, -origin)}, {RATE.name: r}
                for name, other in push.measures:
                    inputs[name] = (number[self.row(other)], 0.0)
                    rates[f"rate({name})"] = number[self.row(other)]
                    rated.add(rates[f"rate({name})"])
                tape = tapes.write(push.law, inputs, rates)
            written.append({"row": r, "tape": tape, "law": linear or (0.0, 0.0, 0.0), "works": works})
        return written


class _Rows:
    """The slots of rows, and what must be added up to fill them."""

    def __init__(self, n_entries: int) -> None:
        self.n_entries = n_entries
        self.slots: list[list[tuple[int, int]]] = []
        self.cleared: list[int] = []
        self.mix: list[tuple[int, int, float]] = []
        self.product_mix: list[tuple[int, int, int]] = []
        self.composed_mix: list[tuple[int, int, int, int]] = []

    def _own(self, bodies: Iterable[int]) -> dict[int, int]:
        """Entries of its own for a row, one for each body."""
        own: dict[int, int] = {}
        for body in bodies:
            if body not in own:
                own[body] = self.n_entries
                self.cleared.append(self.n_entries)
                self.n_entries += 3
        self.slots.append(list(own.items()))
        return own

    def add_base(self, pieces: Sequence[tuple[int, int, float]]) -> None:
        """A row of measures: (body, entries, coefficient). A single measure lends it its own entries."""
        bodies = [b for b, _o, _c in pieces]
        if len(set(bodies)) == len(bodies) and all(c == 1.0 for _b, _o, c in pieces):
            self.slots.append([(b, o) for b, o, _c in pieces])
            return
        own = self._own(bodies)
        self.mix += [(own[b], o, c) for b, o, c in pieces]

    def add_product(self, terms: Sequence[tuple[int, int]]) -> None:
        """A row of products: (product, measure row)."""
        own = self._own(b for _p, m in terms for b, _o in self.slots[m])
        self.product_mix += [(own[b], p, o) for p, m in terms for b, o in self.slots[m]]

    def add_composed(self, k: int, used: Sequence[int]) -> None:
        """A row that is an expression in the rows `used`."""
        own = self._own(b for m in used for b, _o in self.slots[m])
        for m in used:
            pieces = [(own[b], k, o, m) for b, o in self.slots[m]]
            self.composed_mix += pieces or [(0, k, -1, m)]


# -- small things -----------------------------------------------------------------------------


def _exact(value: float) -> Expr:
    from freebody.language.expression import number

    return number(value)


def _sum(a: _Base, b: _Base, factor: float) -> _Base:
    """a + factor * b, measures in the order in which they first occur."""
    terms = dict(a.terms)
    for k, c in b.terms:
        terms[k] = terms.get(k, 0.0) + factor * c
    return _Base(a.constant + factor * b.constant, tuple(terms.items()))
