"""The closed form of a limit of rest: which constraints decide is known, so equilibrium is a linear system.

At the limit every contact is in one of three states, read off the motion by which the system would fail:

    opens     N = 0 and, where there is friction, T = 0
    slips     T = -c L where the slip grows, T = +c L where it falls; L the load of the friction
    stays     nothing is known of its reaction

Together with Q + J^T lambda = 0 these are more equations than reactions: eliminating the reactions leaves conditions
on the parameters alone. A parameter that solves them is the limit. The reactions at the limit, where they are then
unique, say how far the other contacts are from failing, and the motion, from

    J v = 0 of held rows and contacts that stay,      opening = c |slip| where it slips,

how the contacts move that fail: both are the conditions under which this and no other failure comes first.
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from freebody.model.elements import DryFriction
from freebody.symbolic.field import Field, Ratio
from freebody.symbolic.linear import RHS, Row, determinant, reduced
from freebody.symbolic.parameter_roots import Values, slope, without_roots_below
from freebody.symbolic.state import SymbolicState

Slot = tuple[str, str]
MOST_LEFT = 4  # unknowns in a determinant
MOST_DETERMINANTS = 8


@dataclass(frozen=True)
class Failure:
    """The states of the contacts that do not stay, by row name: what opens, and which way what slips does; `signs` of
    the loads of friction that two-sided rows carry, by row."""

    opens: frozenset[str] = frozenset()
    slips: tuple[tuple[str, int], ...] = ()
    signs: tuple[tuple[str, int], ...] = ()


@dataclass(frozen=True)
class ReducedColumns:
    """An elimination: pivot columns by the free ones, and what must vanish besides."""

    pivots: dict[int, Row]
    free: tuple[int, ...]
    residuals: tuple[Ratio, ...]


class RestEquations:
    """The equations of a system at rest in its start pose, over the field of a symbolic model."""

    def __init__(
        self, state: SymbolicState, dry_friction: Sequence[DryFriction], asked: tuple[str, Ratio] | None = None
    ) -> None:
        """asked: a row whose reaction (positive as people count it) is taken as given by an element."""
        self.state = state
        self.asked = asked
        self.field: Field = state.model.field
        self.system = state.model.system
        self.dry_friction = {rub.name: rub for rub in dry_friction}
        self.rows = {row.name: row for row in (*self.system.constraint_rows, *(rub.row for rub in dry_friction))}
        self.sized: list[str] = []
        self._number_columns()
        self.dry_friction = {rub.name: self._along_one(rub) for rub in dry_friction}
        # the load of friction that a force with two components makes has a column of its own
        self.sized = [rub.name for rub in self.dry_friction.values() if len(rub.load) > 1]
        self._number_columns()

    def _number_columns(self) -> None:
        self.names = [*self.rows, *map(_size_of, self.sized)]
        self.columns = {name: k for k, name in enumerate(self.names)}

    def _along_one(self, rub: DryFriction) -> DryFriction:
        """A friction whose load has two components, one of which equilibrium alone makes vanish: the other is its size
        up to the sign, and the equations stay linear (a vertical force in a journal)."""
        if len(rub.load) < 2:
            return rub
        reduced = eliminate(self.field, self.equilibrium(), list(self.columns.values()))
        forces = {name: self.reaction(reduced, name) for name in rub.load}
        left = tuple(name for name, force in forces.items() if force is None or not force.is_zero())
        return replace(rub, load=left) if len(left) == 1 else rub

    # -- what the model says ------------------------------------------------------------------
    @cached_property
    def slots(self) -> list[Slot]:
        order = self.state.model.bodies.slots
        return [(b.name, s) for b in self.system.all_moving for s in order if b.turns or s in ("x", "y", "z")]

    @cached_property
    def gradients(self) -> dict[str, dict[Slot, Ratio]]:
        """Of every row, in the start pose."""
        moving = set(self.slots)
        found: dict[str, dict[Slot, Ratio]] = {}
        for name, row in self.rows.items():
            slopes = {
                slot: self.here(x) for slot, x in self.state.model.gradient(row.measure).items() if slot in moving
            }
            found[name] = {slot: x for slot, x in slopes.items() if not x.is_zero()}
        return found

    @cached_property
    def loads(self) -> dict[Slot, Ratio]:
        """Forces and moments of the loads, at rest."""
        order = self.state.model.bodies.slots
        wrenches = self.state.model.loads.wrenches
        return {slot: self.here(wrenches[slot[0]][order.index(slot[1])]) for slot in self.slots}

    def here(self, x: Ratio) -> Ratio:
        """In the start pose and at rest."""
        return without_roots_below(self.field.lowest_terms(self.state.here(x)))

    def coefficient(self, rub: DryFriction, direction: int) -> Ratio:
        names = {name: self.here(m.value(self.state.model.geometry)) for name, m in rub.measures}
        return self.here(self.state.model.geometry.apply(rub.coefficient(direction, at_rest=True), names))

    def load(self, rub: DryFriction, failure: Failure) -> tuple[Row, Ratio]:
        """The load of dry friction as multipliers with coefficients, and a constant."""
        if not rub.load:
            return {}, self.field.one
        if len(rub.load) > 1:
            return {self.columns[_size_of(rub.name)]: self.field.one}, self.field.zero
        row = self.rows[next(iter(rub.load))]
        sign = row.sign if row.unilateral else dict(failure.signs).get(row.name, 1)
        return {self.columns[row.name]: self.field.element(sign)}, self.field.zero

    def drive(
        self, failure: Failure, motion: Mapping[Slot, Ratio], at_end: ReducedColumns, parameter: int
    ) -> Ratio | None:
        """How the power along a motion changes with the parameter, the reactions held: positive where
        a larger parameter drives it. None where the reactions are not unique or the derivative is not known."""
        forces = {name: self.reaction(at_end, name) for name in self.rows}
        total = self.field.zero
        for slot in motion:
            parts = [(self.loads[slot], self.field.one)]
            for name, slopes in self.gradients.items():
                if slot in slopes and parameter in self.field.ingredients(slopes[slot]):
                    force = forces[name]
                    if force is None:
                        return None
                    parts.append((slopes[slot], force))
            for x, factor in parts:
                change = slope(self.field, x, parameter)
                if change is None:
                    return None
                total = total + change * factor * motion[slot]
        for name, direction in failure.slips:
            rub = self.dry_friction[name]
            change = slope(self.field, self.coefficient(rub, direction), parameter)
            pressing, load = self.load(rub, failure)
            for column, share in pressing.items():
                force = forces[self.names[column]]
                if force is None:
                    return None
                load = load + share * force
            if change is None:
                return None
            total = total - direction * change * load * self.rate(name, motion)
        return total

    # -- equations ----------------------------------------------------------------------------
    def equilibrium(self) -> list[Row]:
        """Q + J^T lambda = 0, body by body."""
        rows: list[Row] = []
        for slot in self.slots:
            row: Row = {self.columns[n]: slopes[slot] for n, slopes in self.gradients.items() if slot in slopes}
            if not self.loads[slot].is_zero():
                row[RHS] = -self.loads[slot]
            if row:
                rows.append(row)
        return rows

    def decided(self, failure: Failure) -> list[Row]:
        """What the states of the contacts say of the reactions."""
        one = self.field.one
        rows: list[Row] = [{self.columns[name]: one} for name in sorted(failure.opens)]
        slips = dict(failure.slips)
        for name, rub in self.dry_friction.items():
            if rub.load and set(rub.load) <= failure.opens:
                rows.append({self.columns[name]: one})
            elif name in slips:
                direction = slips[name]
                pressing, constant = self.load(rub, failure)
                c = direction * self.coefficient(rub, direction)
                row: Row = {self.columns[name]: one}
                row |= {k: c * x for k, x in pressing.items()}
                if not (c * constant).is_zero():
                    row[RHS] = -c * constant
                rows.append({k: x for k, x in row.items() if not x.is_zero()})
        return rows

    def reactions(self, failure: Failure, at: Values | None = None) -> ReducedColumns:
        """All reactions in a failure, at a value of the parameter; the residuals are what must vanish for it."""
        rows = self._rows(failure)
        if at:
            rows = [{k: y for k, x in row.items() if not (y := self.field.follow(x, at)).is_zero()} for row in rows]
        return eliminate(self.field, rows, self._unknown(failure))

    def conditions(self, failure: Failure, parameter: int) -> list[Ratio]:
        """What the parameter must make vanish for a failure to be possible."""
        columns = self._unknown(failure)
        slips = dict(failure.slips)
        sized = [self.dry_friction[name] for name in self.sized if name in slips]
        found = overdetermined(self.field, self._rows(failure), columns, parameter)
        if sized:
            reduced = self.reactions(failure)
            for rub in sized:
                square, size = self.square(reduced, rub.name), self.size(reduced, rub.name)
                if square is not None and size is not None:
                    found.append(square - size * size)
        return found

    def _rows(self, failure: Failure) -> list[Row]:
        return [self._given(row) for row in (*self.equilibrium(), *self.decided(failure))]

    def _unknown(self, failure: Failure) -> list[int]:
        """The columns of the reactions that are not given."""
        slipping = {_size_of(name) for name, _direction in failure.slips}
        asked = None if self.asked is None else self.asked[0]
        return [k for name, k in self.columns.items() if name != asked and (name in self.rows or name in slipping)]

    def square(self, reduced: ReducedColumns, rub: str) -> Ratio | None:
        """The square of the force that loads dry friction with two components; None if it is not unique."""
        parts = [self.reaction(reduced, name) for name in self.dry_friction[rub].load]
        total = self.field.zero
        for part in parts:
            if part is None:
                return None
            total = total + part * part
        return self.field.lowest_terms(total)

    def size(self, reduced: ReducedColumns, rub: str) -> Ratio | None:
        """The load of dry friction that slips, as its own column has it."""
        return self.reaction(reduced, _size_of(rub))

    def _given(self, row: Row) -> Row:
        """An equation with the reaction that is asked for put in."""
        if self.asked is None:
            return row
        name, value = self.asked
        column = self.columns[name]
        if column not in row:
            return row
        rest = {k: x for k, x in row.items() if k not in (column, RHS)}
        right = row.get(RHS, self.field.zero) - row[column] * self.rows[name].sign * value
        return rest if right.is_zero() else rest | {RHS: right}

    def power(self, failure: Failure, motion: Mapping[Slot, Ratio]) -> Ratio:
        """What the loads do along a motion, less what friction of a given size and a given reaction take: positive
        where nothing holds the system."""
        total = self.field.zero
        for slot, load in self.loads.items():
            if slot in motion:
                total = total + load * motion[slot]
        given = {} if self.asked is None else {self.columns[self.asked[0]]: self.asked[1]}
        for name, direction in failure.slips:
            pressing, constant = self.load(self.dry_friction[name], failure)
            known = constant
            for column, share in pressing.items():
                if column in given:
                    known = known + share * self.rows[self.names[column]].sign * given[column]
            total = total - direction * self.coefficient(self.dry_friction[name], direction) * known * self.rate(
                name, motion
            )
        if self.asked is not None:
            name, value = self.asked
            total = total + self.rows[name].sign * value * self.rate(name, motion)
        return self.field.lowest_terms(total)

    def reaction(self, reduced: ReducedColumns, name: str) -> Ratio | None:
        """A multiplier; None where it is not unique."""
        column = self.columns[name]
        if column not in reduced.pivots or set(reduced.pivots[column]) - {RHS}:
            return None
        return reduced.pivots[column].get(RHS, self.field.zero)

    def opening(self, name: str, motion: Mapping[Slot, Ratio]) -> Ratio:
        """The rate at which a row that cannot pull opens."""
        return self.rows[name].sign * self.rate(name, motion)

    def rate(self, name: str, motion: Mapping[Slot, Ratio]) -> Ratio:
        total = self.field.zero
        for slot, gradient in self.gradients[name].items():
            if slot in motion:
                total = total + gradient * motion[slot]
        return self.field.lowest_terms(total)

    def motion(self, failure: Failure, at: Values) -> dict[Slot, Ratio] | None:
        """The motion of a failure, up to its size; None if the states do not determine it.

        By the flow rule of limit analysis: v is orthogonal to all reactions that the states leave possible."""
        if any(name in self.sized for name, _direction in failure.slips):
            return None
        columns = {slot: k for k, slot in enumerate(self.slots)}
        states = self.decided(failure)
        if self.asked is not None:
            states.append({self.columns[self.asked[0]]: self.field.one})
        reduced = eliminate(self.field, states, [self.columns[name] for name in self.rows])
        rows: list[Row] = []
        # a basis of the reactions: one for every free column, sum over rows of (J v) times it vanishes
        for free in reduced.free:
            basis = {free: self.field.one}
            for column, row in reduced.pivots.items():
                if free in row:
                    basis[column] = row[free]
            total: Row = {}
            for column, share in basis.items():
                for slot, gradient in self.gradients[self.names[column]].items():
                    k = columns[slot]
                    x = self.field.follow(share * gradient, at)
                    total[k] = total[k] + x if k in total else x
            rows.append({k: x for k, x in total.items() if not x.is_zero()})
        found = eliminate(self.field, rows, list(columns.values()))
        if len(found.free) != 1:
            return None
        free = found.free[0]
        v = {slot: found.pivots[k].get(free, self.field.zero) for slot, k in columns.items() if k in found.pivots}
        v[self.slots[free]] = self.field.one
        return v


def _size_of(rub: str) -> str:
    return f"@load of {rub}"


def eliminate(field: Field, rows: Sequence[Row], columns: Sequence[int]) -> ReducedColumns:
    """Reduces sum of entry * column = RHS completely, the simplest entries as pivots; what is left of rows without
    columns are the residuals."""
    done, left = _reduced(field, rows, columns, None)
    solved = {c for c, _row in done}
    pivots = {column: {c: x if c == RHS else -x for c, x in row.items()} for column, row in done}
    return ReducedColumns(
        pivots, tuple(c for c in columns if c not in solved), tuple(row[RHS] for row in left if RHS in row)
    )


def overdetermined(field: Field, rows: Sequence[Row], columns: Sequence[int], parameter: int) -> list[Ratio]:
    """What must vanish for equations to have a solution, as functions of a parameter.

    Only entries without it are pivots, since others may vanish where a solution exists. What is left, n equations in
    k < n unknowns, has one if the determinants of any k + 1 of them, right-hand side included, vanish."""
    _done, left = _reduced(field, rows, columns, parameter)
    left = [row for row in left if row]
    unknown = sorted({c for row in left for c in row if c != RHS})
    if len(unknown) > MOST_LEFT or len(left) <= len(unknown):
        return []
    chosen = itertools.islice(itertools.combinations(left, len(unknown) + 1), MOST_DETERMINANTS)
    full = [*unknown, RHS]
    found = [determinant([[row.get(c, field.zero) for c in full] for row in some]) for some in chosen]
    return [x for x in found if not x.is_zero()]


def _reduced(
    field: Field, rows: Sequence[Row], columns: Sequence[int], without: int | None
) -> tuple[list[tuple[int, Row]], list[Row]]:
    """Pivot rows, completely reduced, and the rows that are left; no pivot contains the generator `without`."""
    order = {c: k for k, c in enumerate(columns)}

    def worth(column: int, entry: Ratio, row: Row) -> tuple[int, ...] | None:
        if without is not None and without in field.ingredients(entry):
            return None
        return (1 + entry.n_terms if entry.generators() else 0, len(row), order[column])

    def kept(x: Ratio) -> Ratio | None:
        least = field.lowest_terms(x)
        return None if least.is_zero() else least

    done, left = reduced(field, rows, worth, kept)
    return done, [row for _k, row in left]
