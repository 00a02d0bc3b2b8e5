"""The closed form of a limit of rest: which constraints decide is known, so equilibrium is a linear system.

At the limit every contact is in one of three states, read off the motion by which the system would fail:

    opens     N = 0 and, where there is friction, T = 0
    slips     T = -c L where the slip grows, T = +c L where it falls; L the load of the friction;
              in a plane T_1^2 + T_2^2 = c^2 L^2, with the slip against T
    stays     nothing is known of its reaction

Together with Q + J^T lambda = 0 these are more equations than reactions: eliminating the reactions leaves conditions
on the parameters alone. A parameter that solves them is the limit. The reactions at the limit, where they are then
unique, say how far the other contacts are from failing, and the motion, from

    J v = 0 of held rows and contacts that stay,      opening = c |slip| where it slips,

how the contacts move that fail: both are the conditions under which this and no other failure comes first. In a plane
the motion is that of the plane that touches the circular cone at T, t_1 T_1 + t_2 T_2 = c^2 L l with t and l the forces
at the limit.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.model.elements import DryFriction
from freebody.symbolic.field import Field
from freebody.symbolic.linear import RHS, Row
from freebody.symbolic.parameter_roots import Values, slope, without_roots_below
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.state import SymbolicState
from freebody.symbolic.surplus import ReducedColumns, combined, eliminate, overdetermined

Slot = tuple[str, str]


@dataclass(frozen=True)
class Failure:
    """The states of the contacts that do not stay, by row name: what opens, and which way what slips does; `signs` of
    the loads of friction that two-sided rows carry, by row."""

    opens: frozenset[str] = frozenset()
    slips: tuple[tuple[str, int], ...] = ()
    signs: tuple[tuple[str, int], ...] = ()


class RestEquations:
    """The equations of a system at rest in its start pose, over the field of a symbolic model."""

    def __init__(
        self,
        state: SymbolicState,
        dry_friction: Sequence[DryFriction],
        inertia: Mapping[str, Sequence[Ratio]],
        asked: tuple[str, Ratio] | None = None,
    ) -> None:
        """inertia: M a by body, along its slots, of what goes along with a drive; asked: a row whose reaction (positive
        as people count it) is taken as given by an element."""
        self.state = state
        self.inertia = inertia
        self.asked = asked
        self.field: Field = state.model.field
        self.system = state.model.system
        self.dry_friction = {rub.name: rub for rub in dry_friction}
        rubbing = (row for rub in dry_friction for row in rub.rows)
        self.rows = {row.name: row for row in (*self.system.constraint_rows, *rubbing)}
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
        """Forces and moments of the loads, at rest; beside a drive less M a (d'Alembert)."""
        order = self.state.model.bodies.slots
        wrenches, inertia = self.state.model.loads.wrenches, self.inertia
        found: dict[Slot, Ratio] = {}
        for body, of in self.slots:
            load = self.here(wrenches[body][order.index(of)])
            found[body, of] = load if body not in inertia else load - inertia[body][order.index(of)]
        return found

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
            slip = self.slip(failure, name, motion, at_end)
            if change is None or slip is None:
                return None
            total = total - change * load * slip
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
                rows += [{self.columns[row.name]: one} for row in rub.rows]
            elif name in slips and rub.across is None:
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
        turning = self.turning(failure)
        if sized or turning:
            reduced = self.reactions(failure)
            found += [-x for rub in turning if (x := self.cone(reduced, rub, failure)) is not None]
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

    def turning(self, failure: Failure) -> list[DryFriction]:
        """The frictions that slip in a plane."""
        return [rub for n, _d in failure.slips if (rub := self.dry_friction[n]).across is not None]

    def together(self, rub: DryFriction, failure: Failure) -> list[DryFriction]:
        """The frictions that slip in one plane with the same coefficient: the feet of a body that does not turn. Their
        forces are parallel, so that with their sums the law of one holds for all."""

        def of(one: DryFriction) -> object:
            ways = [{s: x for s, x in self.gradients[row.name].items() if s[1] in "xyz"} for row in one.rows]
            return ways, self.coefficient(one, 1)

        if not any(slot[1] in "xyz" for row in rub.rows for slot in self.gradients[row.name]):
            return [rub]  # a moment
        alike = [other for other in self.turning(failure) if other.load and of(other) == of(rub)]
        return alike if rub in alike else [rub]

    def forces(self, reduced: ReducedColumns, rub: DryFriction, failure: Failure) -> tuple[Ratio, Ratio, Ratio] | None:
        """Both components of a friction in a plane and its load, summed over what slips together with it; None where
        the sums are not unique."""
        alike, one = self.together(rub, failure), self.field.one
        loads = [self.load(other, failure) for other in alike]
        sums: list[Row] = [{self.columns[other.rows[k].name]: one for other in alike} for k in range(2)]
        sums.append({column: share for shares, _constant in loads for column, share in shares.items()})
        first, second, load = (combined(self.field, reduced, total) for total in sums)
        if first is None or second is None or load is None:
            return None
        return first, second, load + sum((c for _shares, c in loads), self.field.zero)

    def cone(
        self, reduced: ReducedColumns, rub: DryFriction, failure: Failure, at: Values | None = None
    ) -> Ratio | None:
        """How far a friction force in a plane is inside its cone, c^2 L^2 - T_1^2 - T_2^2; None if it is not unique."""
        known = self.forces(reduced, rub, failure)
        if known is None:
            return None
        c = self.field.follow(self.coefficient(rub, 1), at or {})
        return self.field.lowest_terms((c * known[2]) ** 2 - known[0] ** 2 - known[1] ** 2)

    def slip(
        self, failure: Failure, name: str, motion: Mapping[Slot, Ratio], at_end: ReducedColumns | None
    ) -> Ratio | None:
        """The speed of a slip along a motion, positive where it goes the way it is meant to. In a plane that is the way
        against the friction force T at the limit: -(T_1 s_1 + T_2 s_2)/|T|. None where this is not unique."""
        rub = self.dry_friction[name]
        if rub.across is None:
            return dict(failure.slips)[name] * self.rate(name, motion)
        known = None if at_end is None else self.forces(at_end, rub, failure)
        if known is None:
            return None
        size = self.state.sqrt(self.field.lowest_terms(known[0] ** 2 + known[1] ** 2))
        total = known[0] * self.rate(rub.row.name, motion) + known[1] * self.rate(rub.across.name, motion)
        return None if size.is_zero() else self.field.lowest_terms(-total / size)

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

    def power(self, failure: Failure, motion: Mapping[Slot, Ratio], at_end: ReducedColumns | None = None) -> Ratio:
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
            if known.is_zero():
                continue
            slip = self.slip(failure, name, motion, at_end)
            if slip is None:
                raise CannotAnswer(
                    Message("the friction forces of {contact} are not unique", contact=self.rows[name].connection)
                )
            total = total - self.coefficient(self.dry_friction[name], direction) * known * slip
        if self.asked is not None:
            name, value = self.asked
            total = total + self.rows[name].sign * value * self.rate(name, motion)
        return self.field.lowest_terms(total)

    def reaction(self, reduced: ReducedColumns, name: str) -> Ratio | None:
        """A multiplier; None where it is not unique."""
        return combined(self.field, reduced, {self.columns[name]: self.field.one})

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
        touching = self._touching_planes(failure, at)
        if touching is None:
            return None
        states += touching
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
        motions: list[dict[Slot, Ratio]] = []
        for free in found.free:
            v = {slot: found.pivots[k].get(free, self.field.zero) for slot, k in columns.items() if k in found.pivots}
            v[self.slots[free]] = self.field.one
            motions.append(v)
        if len(motions) > 1:  # what moves no row, as the spin of a can about its axis, has no part in a failure
            moves = [any(not self.field.follow(self.rate(n, v), at).is_zero() for n in self.rows) for v in motions]
            motions = [v for v, is_moved in zip(motions, moves, strict=True) if is_moved]
        return motions[0] if len(motions) == 1 else None

    def _touching_planes(self, failure: Failure, at: Values) -> list[Row] | None:
        """Of every friction that slips in a plane, the plane that touches its cone at the forces of the limit."""
        turning = self.turning(failure)
        at_end = self.reactions(failure, at) if turning else None
        found: list[Row] = []
        for rub in turning:
            known = None if at_end is None else self.forces(at_end, rub, failure)
            if known is None:
                return None
            c = self.field.follow(self.coefficient(rub, 1), at)
            row: Row = {self.columns[row.name]: force for row, force in zip(rub.rows, known[:2], strict=True)}
            for column, share in self.load(rub, failure)[0].items():
                row[column] = self.field.lowest_terms(-c * c * known[2] * share)
            found.append({k: x for k, x in row.items() if not x.is_zero()})
        return found


def _size_of(rub: str) -> str:
    return f"@load of {rub}"
