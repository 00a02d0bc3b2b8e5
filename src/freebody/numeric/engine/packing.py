"""Packing: a system becomes arrays. Everything that is known before the motion is decided here."""

from __future__ import annotations

from dataclasses import fields, replace
from functools import cache
from typing import Any

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.expression import ZERO, Expr, Symbol, differentiate, free_symbols, has_jump, number, substitute
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.measures.combination import Combination, Composed
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, ONE, Direction, Point
from freebody.measures.lead import Lead
from freebody.measures.turn import Alignment
from freebody.model.elements import (
    AppliedLoad,
    Component,
    ConstraintRow,
    DryFriction,
    NonholonomicForm,
    UnilateralConstraint,
)
from freebody.numeric.engine.cells import cells_of
from freebody.numeric.engine.laws import linear_law, stored_law
from freebody.numeric.engine.packed import Base, Composition, Hold, MeasureKey, RowProduct, Slide, Where, summed
from freebody.numeric.kernels.arrays import Floats
from freebody.numeric.numbers import Numbers


@cache
def _fields_of(measure: type[Any]) -> tuple[str, ...]:
    return tuple(f.name for f in fields(measure))


class Packing:
    """Collects measures, rows, held rows and loads of a system; `written` makes arrays of them."""

    def __init__(self, numbers: Numbers) -> None:
        self.counted: dict[int, tuple[Measure, float]] = {}  # from where measures count that were asked, by identity
        self._start_value = numbers.start_value
        self.numbers = numbers = replace(numbers, start_value=self._counted_from)
        self.cells = cells_of(numbers)
        self.measures = self.cells.measures
        self._kind_names = frozenset(kind.name for kind in self.measures.kinds)
        self._bodies = {body.name: k for k, body in enumerate(numbers.system.all_moving)}
        self.n_bodies = len(self._bodies)
        self.constant_force = np.zeros((self.n_bodies + 1, 3 * self.measures.width))
        self._measures: list[dict[MeasureKey, int]] = [{} for _ in self.measures.kinds]
        self.pieces: list[tuple[int, MeasureKey]] = []
        self._gradients: dict[tuple[int, MeasureKey], Floats] = {}
        self.part_lent = 1.0  # of what massless bodies are lent
        self.reads_turns = False  # whether held rows or loads depend on turns
        self._with_bearing: dict[int, tuple[Measure, float, float | None]] = {}
        self._base: dict[Base, int] = {}
        self._known_slopes: dict[tuple[Expr, tuple[str, ...]], dict[str, Expr] | None] = {}
        self.bases: list[Base] = []
        self.other: list[Composition | RowProduct] = []
        self.by_measure: dict[Measure | NonholonomicForm, Where] = {}
        self.settings: dict[Measure, int] = {}  # base rows of numbers that a motion sets
        self.held: list[Hold] = []
        self.dry_friction: list[Slide] = []
        self.watched: list[Where] = []
        self.applied_loads: list[tuple[Where, AppliedLoad, tuple[float, float, float] | None, bool]] = []

    def _counted_from(self, measure: Measure) -> float:
        value = self._start_value(measure)
        if measure.incremental:
            self.counted[id(measure)] = measure, value
        return value

    def is_of(self, numbers: Numbers) -> bool:
        """Whether another packing of the same rows and loads would be the same: with these numbers as well."""
        own = self.numbers
        return (numbers.values, numbers.length, numbers.fixed) == (own.values, own.length, own.fixed) and all(
            numbers.start_value(measure) == value for measure, value in self.counted.values()
        )

    # -- measures -----------------------------------------------------------------------------
    def _body(self, name: str) -> int:
        return self._bodies.get(name, self.n_bodies)

    def _elementary(self, measure: Measure) -> Base | None:
        """A row of one elementary measure, entered in the arrays of its kind."""
        name, kinds = type(measure).__name__, self.measures.kinds
        if name not in self._kind_names:
            return None
        values = [(f, getattr(measure, f)) for f in _fields_of(type(measure))]
        bodies: list[int] = []
        numbers: list[float] = []
        constant = 0.0
        on_ground: set[str] = set()
        for field, value in values:
            if isinstance(value, Point):
                body, components = self._body(value.body), self.cells.point(value)
            elif isinstance(value, Direction):
                body, components = self._body(value.body), self.cells.direction(value)
            elif isinstance(value, str):
                body, components = self._body(value), self.cells.axes(value)
                if body == self.n_bodies:  # the angle of a fixed body is a number
                    constant += self._fixed_angle(field, value)
            else:
                numbers.append(self.numbers.number(value))
                continue
            bodies.append(body)
            numbers += components
            if body == self.n_bodies:
                on_ground.add(field)
        index = next(i for i, kind in enumerate(kinds) if kind.name == name and set(kind.fixed) <= on_ground)
        kind = kinds[index]
        names = [field for field, value in values if isinstance(value, (Point, Direction, str))]
        bodies = [b for n, b in zip(names, bodies, strict=True) if n not in kind.fixed]
        key = (tuple(bodies), tuple(numbers))
        known = self._measures[index]
        if key not in known:
            known[key] = len(self.pieces)
            self.pieces.append((index, key))
            if kind.has_bearing and name != "Distance":
                rho = self.numbers.number(measure.rho) if isinstance(measure, Lead) else None
                self._with_bearing[known[key]] = (measure, constant, rho)
        return Base(constant, ((known[key], 1.0),))

    def _fixed_angle(self, field_name: str, body: str) -> float:
        """What the angle of a fixed body adds to a measure that reads it: measures are linear in angles."""
        angle = self.cells.fixed_angle(body)
        return angle if field_name == "of" else -angle

    # -- rows ---------------------------------------------------------------------------------
    def _linear(self, measure: Measure) -> Base | None:
        """A measure as a combination of elementary ones with constant coefficients, if it is one."""
        if measure in self.settings:
            return None
        if isinstance(measure, Combination):
            total = Base(0.0, ())
            for coefficient, part in measure.terms:
                inner = self._linear(part)
                if inner is None or "t" in free_symbols(coefficient):
                    return None
                total = summed(total, inner, self.numbers.number(coefficient))
            return total
        if isinstance(measure, Composed):
            names = dict(measure.measures)
            slopes = self._slopes(measure.expression, tuple(names))
            if slopes is None:
                return None
            rest = substitute(measure.expression, dict.fromkeys(names, ZERO))
            if "t" in free_symbols(rest):
                return None
            total = Base(self.numbers.number(rest), ())
            for name, part in names.items():
                inner = self._linear(part)
                if inner is None:
                    return None
                total = summed(total, inner, self.numbers.number(slopes[name]))
            return total
        return self._elementary(measure)

    def _slopes(self, expression: Expr, names: tuple[str, ...]) -> dict[str, Expr] | None:
        """The constant coefficients of an expression that is linear in the names; None of another."""
        key = expression, names
        if key not in self._known_slopes:
            self._known_slopes[key] = _slopes_in(expression, names)
        return self._known_slopes[key]

    def row(self, measure: Measure | NonholonomicForm) -> Where:
        """The row of a measure, made when it is first asked for."""
        known = self.by_measure.get(measure)
        if known is None:
            known = self.by_measure[measure] = self._new_row(measure)
        return known

    def setting(self, measure: Measure) -> None:
        """Enters a number that a motion sets (`Written.set`): a row of its own, of no pose."""
        self.settings[measure] = len(self.bases)
        self.bases.append(Base(0.0, ()))

    def _new_row(self, measure: Measure | NonholonomicForm) -> Where:
        if measure in self.settings:
            return "base", self.settings[measure]
        if isinstance(measure, NonholonomicForm):
            terms = [(self._coefficient(c), self.row(m)) for c, m in measure.terms]
            self.other.append(RowProduct(terms))
            return "other", len(self.other) - 1
        linear = self._linear(measure)
        if linear is not None:
            return "base", self._enter(linear)
        inputs: dict[str, int] = {}
        expr = self._expression(measure, inputs)
        self.other.append(Composition(expr, inputs))
        return "other", len(self.other) - 1

    def _enter(self, base: Base) -> int:
        place = self._base.setdefault(base, len(self.bases))
        if place == len(self.bases):
            self.bases.append(base)
        return place

    def _coefficient(self, coefficient: Component | Measure) -> Where:
        return self.row(coefficient if not isinstance(coefficient, Component) else _component(coefficient))

    def _expression(self, measure: Measure, inputs: dict[str, int]) -> Expr:
        """A measure as an expression in base rows, which are entered in `inputs` under names of their own."""
        linear = self._linear(measure)
        if linear is not None or measure in self.settings:
            row = self.settings[measure] if linear is None else self._enter(linear)
            inputs[f"@row{row}"] = row
            return Symbol(f"@row{row}")
        if isinstance(measure, Composed):
            return substitute(measure.expression, {n: self._expression(m, inputs) for n, m in measure.measures})
        if isinstance(measure, Combination):
            total: Expr = ZERO
            for coefficient, part in measure.terms:
                total = total + coefficient * self._expression(part, inputs)
            return total
        if isinstance(measure, Alignment):  # in the plane, which has no kernel for it: a . b by components
            return sum(
                (
                    self._expression(_component(Component(measure.of, axis)), inputs)
                    * self._expression(_component(Component(measure.along, axis)), inputs)
                    for axis in ("x", "y")
                ),
                ZERO,
            )
        raise CannotAnswer(
            Message(
                "no kernel is written for the measure {name}; run tools/write_kernels.py", name=type(measure).__name__
            )
        )

    def bearings(self) -> list[tuple[int, Measure, float, float | None]]:
        """Measures that count turns: their place in the layout, the measure, what the angle of a fixed body adds to it,
        and, for a lead, its rho."""
        place = self._places()
        found = [(place[old], *rest) for old, rest in self._with_bearing.items()]
        return [item for item in found if item[3] is None or item[3] != 0.0]

    def bearing_of(self, measure: Measure) -> int:
        """The place in the layout of an elementary measure that counts turns; -1 of another."""
        if all(kind.name != type(measure).__name__ or not kind.has_bearing for kind in self.measures.kinds):
            return -1
        base = self._elementary(measure)
        return -1 if base is None else self._places()[base.terms[0][0]]

    def keys(self) -> dict[tuple[int, MeasureKey], int]:
        """Measures that count turns, with their place in the layout: the same measure has the same key everywhere."""
        return {self.pieces[old]: place for old, place in self._places().items() if old in self._with_bearing}

    def _places(self) -> dict[int, int]:
        order = sorted(range(len(self.pieces)), key=lambda k: self.pieces[k][0])
        return {old: new for new, old in enumerate(order)}

    # -- held rows and loads ------------------------------------------------------------------
    def hold(self, held: ConstraintRow) -> int:
        """Enters a row that may be held, and gives its place among them; what it is held at, as far as it is constant,
        becomes part of the row."""
        row, target = self.row(held.measure), held.target
        if isinstance(held.measure, NonholonomicForm):
            return self._hold(row, target, held)
        offset = 0.0
        if target is None:
            offset = self.numbers.start_value(held.measure)
        elif not held.is_driven:
            offset, target = self.numbers.number(target), None
        if offset and row[0] == "base":
            base = self.bases[row[1]]
            row = "base", self._enter(Base(base.constant - offset, base.terms))
        elif offset:
            composed = self.other[row[1]]
            assert isinstance(composed, Composition)
            self.other.append(Composition(composed.expr - _exact(offset), composed.inputs))
            row = "other", len(self.other) - 1
        return self._hold(row, target, held)

    def _hold(self, row: Where, target: Expr | None, held: ConstraintRow, *, is_place: bool = True) -> int:
        is_place = is_place and not isinstance(held.measure, NonholonomicForm)
        self.held.append(Hold(row, target, held, is_place))
        return len(self.held) - 1

    def bound(self, bound: UnilateralConstraint) -> int:
        """Enters a row that is held while a bound is closed, and what says where the contact exists."""
        place = self.hold(bound.row)
        self.watched.append(self.held[place].where)
        for span in bound.within:
            self.watch(span.measure)
        if bound.spinning is not None:
            self.watch(bound.spinning)
        return place

    def friction(self, friction: DryFriction, loads: tuple[int, ...], sign: int) -> int:
        """Enters dry friction, and gives the place of the row that keeps it where it is; what that is, `Written.keep`
        says. loads: places of the rows whose multipliers press; sign: of a single one that can only push."""
        where, keeps = self._kept(friction.row)
        across, keeps_across = (None, -1) if friction.across is None else self._kept(friction.across)
        for _name, measure in friction.measures:
            self.row(measure)
        self.watched += [where] if across is None else [where, across]
        self.dry_friction.append(Slide(where, friction, keeps, loads, sign, across, keeps_across))
        return keeps

    def _kept(self, row: ConstraintRow) -> tuple[Where, int]:
        """A row that may be held where it is."""
        where = self.row(row.measure)
        if where[0] == "base":  # a row of its own, which can be held at any value
            self.bases.append(self.bases[where[1]])
            return where, self._hold(("base", len(self.bases) - 1), None, row)
        return where, self._hold(where, None, row, is_place=False)

    def closing(self, row: ConstraintRow) -> int:
        """Enters a row that is held from some instant on, and gives its place; one of which only changes mean something
        is held where it is then, which `Written.keep_at` says."""
        if isinstance(row.measure, NonholonomicForm) or row.target is not None or not row.measure.incremental:
            place = self.hold(row)
            self.watched.append(self.held[place].where)
            return place
        where = self.row(row.measure)
        self.watched.append(where)
        if where[0] == "base":  # a row of its own, which can be held at any value
            self.bases.append(self.bases[where[1]])
            return self._hold(("base", len(self.bases) - 1), None, row)
        return self._hold(where, None, row, is_place=False)

    def watch(self, measure: Measure | NonholonomicForm) -> None:
        """Enters a measure whose value and rate are wanted."""
        self.watched.append(self.row(measure))

    def load(self, load: AppliedLoad) -> None:
        """Enters a load. One that never changes becomes a constant force."""
        linear = linear_law(load.law, self.numbers.values)
        if linear is not None and not isinstance(load.measure, NonholonomicForm):
            if linear[1:] == (0.0, 0.0) and self._is_constant(load.measure, linear[0]):
                return
            origin = self.numbers.start_value(load.measure)
            linear = (linear[0] - linear[1] * origin, linear[1], linear[2])
        for _name, other in load.measures:
            self.row(other)
        works = stored_law(load, self.numbers.values) is None
        self.applied_loads.append((self.row(load.measure), load, linear, works))

    def _is_constant(self, measure: Measure, force: float) -> bool:
        """Adds the generalized force of a constant load along a measure with a constant gradient."""
        linear = self._linear(measure)
        if linear is None:
            return False
        forces = np.zeros_like(self.constant_force)
        for k, coefficient in linear.terms:
            index, (bodies, _numbers) = self.pieces[k]
            gradient = self.constant_gradient(index, self.pieces[k][1])
            for j, body in enumerate(bodies):
                if body != self.n_bodies:
                    own = gradient[j * forces.shape[1] : (j + 1) * forces.shape[1]]
                    if np.isnan(own).any():
                        return False
                    forces[body] += coefficient * own
        self.constant_force += force * forces
        return True

    def constant_gradient(self, index: int, key: MeasureKey) -> Floats:
        """The gradient of a measure of a kind, as far as it is the same in every pose; NaN where it changes."""
        if (index, key) not in self._gradients:
            self._gradients[index, key] = self._constant_gradient(index, key)
        return self._gradients[index, key]

    def _constant_gradient(self, index: int, key: MeasureKey) -> Floats:
        kind, (_bodies, numbers) = self.measures.kinds[index], key
        n = 3 * self.measures.width * kind.n_bodies
        gradient = np.zeros(n)
        counts = (np.arange(len(self.measures.kinds) + 1) > index).astype(int)
        self.measures.fill(counts, np.zeros(len(counts), dtype=int), np.array([numbers]), gradient)
        still = {*kind.unchanging, *(j for j, those in kind.vanishing if not any(numbers[i] for i in those))}
        gradient[[j for j in range(n) if j not in still]] = np.nan
        return gradient

    def pieces_of(self, where: Where) -> set[int]:
        """The elementary measures of which a row is made."""
        if where[0] == "base":
            return {k for k, _c in self.bases[where[1]].terms}
        other = self.other[where[1]]
        inner = (
            [("base", row) for row in other.inputs.values()]
            if isinstance(other, Composition)
            else [m for _c, m in other.terms]
        )
        return {k for part in inner for k in self.pieces_of(part)}


def _exact(value: float) -> Expr:
    return number(value)


def _component(component: Component) -> Displacement:
    """A ground component of a direction d as a measure: how far the point at d lies from the origin of d's body."""
    d = component.direction
    tip, foot = Point(d.body, d.components), Point(d.body, tuple(ZERO for _ in d.components))
    axis = tuple(ONE if name == component.axis else ZERO for name in "xyz"[: len(d.components)])
    return Displacement(tip, foot, Direction(GROUND, axis))


def _slopes_in(expression: Expr, names: tuple[str, ...]) -> dict[str, Expr] | None:
    if has_jump(expression, names):
        return None
    slopes: dict[str, Expr] = {}
    for name in names:
        slopes[name] = differentiate(expression, name)
        if free_symbols(slopes[name]) & {*names, "t"}:
            return None
    return slopes
