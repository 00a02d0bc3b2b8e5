"""A blow as elements: impulses, and connections that close, change the velocities at once.

The start of the model says how everything moves just before. There all bodies move each for itself: with V their
velocities along their slots, J0 the gradients of what is held before and A those of the given rates,

    J0 V = target',   A V = rates,   p(V) = J0^T lambda + A^T mu     (Gauss: the least kinetic energy).

With P the wrenches of the impulses and S = dV/du the partial velocities of what is held afterwards,

    S^T (p(V) - p(V before) - P) = 0                                 (Kane)

for the speeds u after the blow; the impulses Lambda of what is held follow body by body from

    J^T Lambda = p(V) - p(V before) - P.

Forces of finite size do nothing in no time, and no place changes.
Source: Kane & Levinson, Dynamics: Theory and Applications (1985), ch. 7.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.measures.geometry import SpatialPose, Vector
from freebody.model.elements import ConstraintRow, NonholonomicForm, RigidBody
from freebody.symbolic.bodies import Parts
from freebody.symbolic.linear import RHS, Row, Solved, solve
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio

_Given = tuple[Row, Ratio]  # a row over the slots of the bodies, and what it comes to


class Blow:
    """The blow at the start of a model. places: its coordinates there, and the time, by generator."""

    def __init__(
        self,
        model: SymbolicModel,
        known_rates: Mapping[str, Expr],
        places: Mapping[int, Ratio],
        before: Mapping[tuple[str, str], Ratio] | None = None,
    ) -> None:
        """before: the velocities just before, where they are known, by body and slot."""
        self.model, self.field = model, model.field
        self._places = dict(places)
        self._columns = {
            (body.name, slot): k
            for k, (body, slot) in enumerate((b, s) for b in model.system.all_moving for s in self._slots(b))
        }
        self._known = before
        self._before = self._least(list(self._rows_before(known_rates))) if before is None else None
        self.speeds = self._speeds_after()

    # -- just before --------------------------------------------------------------------------
    def momentum_before(self, body: str) -> Parts:
        """Along the slots of a body. Raises CannotAnswer where the start does not say how it moves."""
        return self._momentum(body, self._velocity_before)

    @cached_property
    def energy_before(self) -> Ratio:
        """The kinetic energy just before the blow."""
        total = self.field.zero
        for body in self.model.system.all_moving:
            for p, slot in zip(self.momentum_before(body.name), self.model.bodies.slots, strict=True):
                if not p.is_zero():
                    total = total + p * self._velocity_before(body.name, slot) / 2
        return self.field.lowest_terms(total)

    def rate_before(self, measure: Measure | NonholonomicForm) -> Ratio:
        """The rate of a measure just before the blow."""
        slots = {column: slot for slot, column in self._columns.items()}
        total = self.field.zero
        for column, slope in self._row_of(measure).items():
            total = total + slope * self._velocity_before(*slots[column])
        return self.field.lowest_terms(total)

    def _velocity_before(self, body: str, slot: str) -> Ratio:
        if self._known is not None:
            return self._here(self._known.get((body, slot), self.field.zero))
        column = self._columns.get((body, slot))
        if column is None or self._before is None:
            return self.field.zero
        row = self._before.pivots.get(column)
        if row is None or row.keys() - {RHS}:
            raise CannotAnswer(
                Message("the start does not say how {body} moves before the blow; give its velocity", body=body)
            )
        return row.get(RHS, self.field.zero)

    def _rows_before(self, known_rates: Mapping[str, Expr]) -> list[_Given]:
        """What is held before the blow, and the rates and velocities that the model gives."""
        model, scalar = self.model, self.model.geometry.scalar
        found: list[_Given] = []
        for row in model.system.constraint_rows:
            if not row.closes:
                target = row.in_symbols
                running = self.field.zero if target is None else self._here(model.rate(scalar(target)))
                found.append((self._row_of(row.measure), running))
        for name, rate in known_rates.items():
            found.append((self._row_of(model.system.all_measures[name]), self._here(scalar(rate))))
        for body in model.system.all_moving:
            found += self._given_to(body)
        return found

    def _given_to(self, body: RigidBody) -> list[_Given]:
        """The velocities that a body is given, along its slots."""
        start, scalar, slots = body.start, self.model.geometry.scalar, self.model.bodies.slots
        given: list[_Given] = []
        for slot, rate in zip(slots, start.velocity or (), strict=False):
            given.append(({self._columns[body.name, slot]: self.field.one}, self._here(scalar(rate))))
        if body.turns and start.angular_velocity is not None and not self.model.system.space:
            given.append(
                ({self._columns[body.name, "angle"]: self.field.one}, self._here(scalar(start.angular_velocity)))
            )
        if body.turns and start.rates is not None:
            omega = Vector(*(self._here(scalar(e)) for e in start.rates))
            if not start.rates_in_body:
                omega = self._in_body(body.name, omega)
            for slot, w in zip(slots[3:], (omega.x, omega.y, omega.z), strict=True):
                given.append(({self._columns[body.name, slot]: self.field.one}, self.field.zero if w is None else w))
        return given

    def _in_body(self, body: str, v: Vector[Ratio]) -> Vector[Ratio]:
        """Components along the ground, along the axes of a body."""
        pose = self.model.poses[body]
        assert isinstance(pose, SpatialPose)
        vz = self.field.zero if v.z is None else v.z

        def along(axis: Vector[Ratio]) -> Ratio:
            x, y, z = (self._here(self.field.zero if c is None else c) for c in (axis.x, axis.y, axis.z))
            return self.field.lowest_terms(v.x * x + v.y * y + vz * z)

        return Vector(*(along(axis) for axis in pose.axes))

    def _least(self, given: Sequence[_Given]) -> Solved | None:
        """The velocities of least kinetic energy; None where everything is at rest."""
        if all(value.is_zero() for _row, value in given):
            return None
        rows: list[Row] = []
        n = len(self._columns)
        for row, value in given:
            rows.append(dict(row) if value.is_zero() else {**row, RHS: value})
        for body, slot in self._columns:
            row = self._inertia_row(body, slot)
            for k, (line, _value) in enumerate(given):
                if self._columns[body, slot] in line:
                    row[n + k] = -line[self._columns[body, slot]]
            rows.append(row)
        unknowns = list(range(n + len(given)))
        solved = solve(self.field, rows, unknowns, lambda x: self.field.lowest_terms(x).is_zero())
        if solved.contradictory:
            raise CannotAnswer(Message("the velocities of the start contradict each other"))
        return solved

    def _inertia_row(self, body: str, slot: str) -> Row:
        """The momentum along a slot, as a row over the slots of the body."""
        slots, k = self.model.bodies.slots, self.model.bodies.slots.index(slot)
        row: Row = {}
        for j, other in enumerate(slots):
            if (body, other) in self._columns:
                unit = tuple(self.field.one if i == j else self.field.zero for i in range(len(slots)))
                entry = self.model.dynamics.momentum(body, unit)[k]
                if not entry.is_zero():
                    row[self._columns[body, other]] = self._here(entry)
        return row

    # -- just after ---------------------------------------------------------------------------
    @cached_property
    def _wrenches(self) -> dict[tuple[str, str], Ratio]:
        """The impulses on every body, along its slots."""
        total: dict[tuple[str, str], Ratio] = {}
        for push in self.model.system.impulses:
            impulse = self.model.geometry.scalar(push.law)
            for slot, slope in self.model.gradient(push.measure).items():
                if slot in self._columns:
                    total[slot] = total.get(slot, self.field.zero) + impulse * self._here(slope)
        return total

    def _brought(self, body: str) -> Parts:
        """Momentum before and impulses of a body."""
        slots, zero = self.model.bodies.slots, self.field.zero
        return tuple(
            self.field.lowest_terms(p + self._wrenches.get((body, slot), zero))
            for p, slot in zip(self.momentum_before(body), slots, strict=True)
        )

    @cached_property
    def balances(self) -> list[tuple[Ratio, Ratio]]:
        """For each coordinate the momentum that belongs to it after the blow, in the speeds, and what the motion before
        and the impulses bring."""
        model, f = self.model, self.field
        names = list(model.kinematics.velocities)
        momenta = {name: self._momentum(name, lambda body, slot: self._velocity(body)[slot]) for name in names}
        found: list[tuple[Ratio, Ratio]] = []
        for k in range(len(model.coordinates)):
            after, brought = f.zero, f.zero
            for name in names:
                slopes = map(self._here, model.kinematics.partial_velocities[name][k])
                for p, given, slope in zip(momenta[name], self._brought(name), slopes, strict=True):
                    if not slope.is_zero():
                        after, brought = after + p * slope, brought + given * slope
            found.append((f.lowest_terms(after), f.lowest_terms(brought)))
        return found

    def _velocity(self, body: str) -> dict[str, Ratio]:
        """Of a body along its slots, in the pose of the blow, in the speeds."""
        model = self.model
        parts = model.kinematics.velocities[body]
        return {
            slot: self._here(model.in_independent_speeds(v)) for slot, v in zip(model.bodies.slots, parts, strict=True)
        }

    def _speeds_after(self) -> dict[int, Ratio]:
        model, f = self.model, self.field
        speeds = [c.speed for c in model.coordinates]
        rows: list[Row] = []
        for after, brought in self.balances:
            row: Row = {s: f.lowest_terms(x) for s in speeds if not (x := f.partial(after, s)).is_zero()}
            rest = f.lowest_terms(brought - f.follow(after, dict.fromkeys(speeds, f.zero)))
            rows.append(row if rest.is_zero() else {**row, RHS: rest})
        solved = solve(f, rows, speeds, Ratio.is_zero)
        if solved.free:
            names = ", ".join(c.name for c in model.coordinates if c.speed in solved.free)
            raise CannotAnswer(
                Message("nothing with mass moves with {x}, so how fast it is after the blow is not determined", x=names)
            )
        return {s: f.lowest_terms(solved.pivots[s].get(RHS, f.zero)) for s in speeds}

    # -- what the connections do --------------------------------------------------------------
    def impulse(self, row: ConstraintRow) -> Ratio:
        """The impulse of a held row: it pushes in the direction in which its measure grows. Raises CannotAnswer naming
        the connections where it is not unique."""
        found = self._impulses.get(row.name)
        if found is None:
            raise CannotAnswer(
                Message(
                    "{name} transmits no more than a bounded force or torque, which has no impulse in a blow",
                    name=row.connection,
                )
            )
        if isinstance(found, CannotAnswer):
            raise found
        return found

    @cached_property
    def _impulses(self) -> dict[str, Ratio | CannotAnswer]:
        model, f = self.model, self.field
        after = {**self._places, **self.speeds}

        def now(x: Ratio) -> Ratio:
            return f.lowest_terms(f.follow(model.in_independent_speeds(x), after))

        def rest(body: str) -> Parts:
            momentum = self._momentum(body, lambda name, slot: now(self._velocity(name)[slot]))
            return tuple(f.lowest_terms(p - q) for p, q in zip(momentum, self._brought(body), strict=True))

        return model.reactions.impulses(rest, now)

    # -- slots --------------------------------------------------------------------------------
    def _slots(self, body: RigidBody) -> tuple[str, ...]:
        bodies = self.model.bodies
        return tuple(bodies.slots) if body.turns else tuple(bodies.slots[: bodies.n_places])

    def _momentum(self, body: str, velocity: Callable[[str, str], Ratio]) -> Parts:
        """Along the slots of a body; what has no inertia needs no velocity."""
        zero = self.field.zero
        found: list[Ratio] = []
        for slot in self.model.bodies.slots:
            total = zero
            row = self._inertia_row(body, slot) if (body, slot) in self._columns else {}
            for other in self.model.bodies.slots:
                column = self._columns.get((body, other))
                if column in row:
                    total = total + row[column] * velocity(body, other)
            found.append(self.field.lowest_terms(total))
        return tuple(found)

    def _row_of(self, measure: Measure | NonholonomicForm) -> Row:
        """The rate of a measure as a row over the slots of the bodies."""
        found = {slot: self._here(x) for slot, x in self.model.gradient(measure).items() if slot in self._columns}
        return {self._columns[slot]: x for slot, x in found.items() if not x.is_zero()}

    def _here(self, x: Ratio) -> Ratio:
        return self.field.lowest_terms(self.field.follow(x, self._places))
