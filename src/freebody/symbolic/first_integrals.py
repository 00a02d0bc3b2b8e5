"""The speed of one coordinate as a function of it: energy, and the momenta of the coordinates that nothing depends on;
beside drivers Jacobi's integral.

Where neither the masses nor the potential know of a coordinate x_c (cyclic), its generalized momentum stays,

    p_c = sum_k M_ck u_k,       so that the other speeds are  u_c = a_c(q) + b_c(q) u ;

put into the energy this leaves one equation in the speed u of the one coordinate q that is left,

    sum_jk M_jk u_j u_k/2 + V = E:      A(q) + B(q) u^2/2 + V(q) = E,

whose linear term vanishes. Where a_c does not change, the integral of u_c over the way gives the other places as well.

Beside drivers T = T2 + T1 + T0 by the degree in the speed u of the one coordinate q, and Lagrange's equation is

    d/dt (dT2/du) - dT2/dq = dT0/dq - dV/dq - dT1/dt    (the last at q held).

Where the time is in none of these, but for what depends on it alone, T2 - T0 + V + int dT1/dt dq stays what it is at
the start: Jacobi's integral, and beside a drive that accelerates evenly the potential of the inertia force as well.
Other coordinates that are cyclic have their momenta p_c = sum_k M_ck u_k + n_c, n_c from T1; with their speeds put in,
the linear term of T2 - T0 = sum_k u_k dT/du_k - T vanishes again.

A load without a potential of its own (one that turns with a body, or whose law names other measures) has one along the
motion where its generalized force depends on one coordinate only: V = -int Q dq.
Source: Goldstein, Poole & Safko, Classical Mechanics, 3rd ed. 2002, sec. 2.7 (energy function), 8.2 and 8.3 (cyclic
coordinates, Routh's procedure).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from freebody.errors import CannotAnswer, FormulaTooLong
from freebody.language.sentences import Message
from freebody.model.elements import AppliedLoad, NonholonomicForm
from freebody.questions.energy import Energy
from freebody.symbolic.antiderivative import antiderivative
from freebody.symbolic.closure import Closure
from freebody.symbolic.linear import RHS, Row, solve
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import sign_of
from freebody.symbolic.start import StartState
from freebody.symbolic.state import SymbolicState
from freebody.symbolic.unknowns import Coordinate
from freebody.tolerances import ROUND_OFF

_DRIVEN = Message("a driver or a velocity constraint is at work, so energy is no first integral")
_MOST_TERMS = 150  # of the square of a speed through a closed loop


class FirstIntegrals:
    """Energy and momenta of a model from its start on. Everything raises CannotAnswer where they are none, or do not
    suffice."""

    def __init__(self, model: SymbolicModel, start: StartState, apart: Sequence[Coordinate] = ()) -> None:
        """apart: coordinates that neither act on the others nor feel them; they count as if they rested."""
        self.model = model
        self.apart = {g: x for c in apart for g, x in ((c.index, start.of(c.index)), (c.speed, model.field.zero))}
        self.start = replace(start, values={**start.values, **self.apart}) if apart else start
        self.keeps_side = False  # of a motion that is followed only as long as it stays on the side of its start
        self.field = model.field

    def suffice_for(self, c: Coordinate) -> bool:
        """Whether they give the speed of a coordinate."""
        try:
            self.speed_squared(c, self.field.variable(c.index))
        except FormulaTooLong:
            return True
        except CannotAnswer:
            return False
        return True

    def speed_squared(self, c: Coordinate, at: Ratio) -> Ratio:
        """u^2 at q = at."""
        f = self.field
        if is_driven(self.model):
            return self._beside_drivers(c, at)
        mass, rest = (f.follow(x, {c.index: at}) for x in self._reduced(c))
        M, u0 = self.model.dynamics.mass_matrix, [self.start.of(k.speed) for k in self.model.coordinates]
        total = f.zero
        for j, row in enumerate(M):
            for k, entry in enumerate(row):
                total = total + f.follow(self._explicit(entry), self.start.values) * u0[j] * u0[k]
        before, now = (self.potential(values) for values in (self.start.values, {**self._held, c.index: at}))
        square = self.on_its_line((total - rest + 2 * (before - now)) / mass)
        if self.model.dependent and len(square.num) > _MOST_TERMS:
            raise FormulaTooLong(Message("through the closed loop the speed would be a formula that is too long"))
        return square

    def _reduced(self, c: Coordinate) -> tuple[Ratio, Ratio]:
        """2 T = mass u^2 + rest with the speeds of all others by the momenta that stay: mass and rest."""
        f, speeds = self.field, self.speeds(c)
        kinetic = f.zero
        for j, row in zip(self.model.coordinates, self.model.dynamics.mass_matrix, strict=True):
            for k, entry in zip(self.model.coordinates, row, strict=True):
                kinetic = kinetic + self._explicit(entry) * speeds[j.speed] * speeds[k.speed]
        kinetic = f.lowest_terms(kinetic)
        parts = (*kinetic.numerator().coefficients(c.speed), f.zero, f.zero)
        return parts[2] / kinetic.denominator(), parts[0] / kinetic.denominator()

    def momentum(self, k: Coordinate) -> tuple[Ratio, Ratio]:
        """The generalized momentum of a coordinate by the speeds, and what it is at the start."""
        f, row = self.field, self.model.coordinates.index(k)
        now = self._led_momentum(k)
        before = f.follow(now, self.start.values)
        for entry, other in zip(self.model.dynamics.mass_matrix[row], self.model.coordinates, strict=True):
            entry = self._explicit(entry)
            now = now + entry * (f.zero if other.index in self._held else f.variable(other.speed))
            before = before + f.follow(entry, self.start.values) * self.start.of(other.speed)
        return now, before

    def _led_momentum(self, k: Coordinate) -> Ratio:
        """What drives add to the momentum of a coordinate, whatever the speeds."""
        f = self.field
        if not is_driven(self.model):
            return f.zero
        still = {c.speed: f.zero for c in self.model.coordinates}
        return self._without_time(f.lowest_terms(f.follow(f.derivative(self._kinetic, k.speed), still)))

    @cached_property
    def _kinetic(self) -> Ratio:
        """The kinetic energy in coordinates and their speeds, those of drives put in."""
        return self.field.lowest_terms(
            self.field.element(Energy("kinetic").value(self.model.system, SymbolicState(self.model)))
        )

    def coasts(self, c: Coordinate) -> bool:
        """Whether the one freedom of a model keeps the kinetic energy that it has at the start."""
        if is_driven(self.model) or len(self.model.coordinates) != 1 or self.start.of(c.speed).is_zero():
            return False
        change = self.potential({}) - self.potential(self.start.values)
        return self.field.lowest_terms(change).is_zero()

    def _beside_drivers(self, c: Coordinate, at: Ratio) -> Ratio:
        """By Jacobi's integral."""
        parts = self.by_degree(c)
        f, start = self.field, {c.index: self.start.of(c.index)}
        u0 = self.start.of(c.speed)
        here = {c.index: at}
        total = f.follow(parts.second * u0 * u0 + parts.rest, start) - f.follow(parts.rest, here)
        square = total / f.follow(parts.second, here)
        return self.on_its_line(self._without_time(f.lowest_terms(square)))

    def terms(self, c: Coordinate) -> tuple[Ratio, Ratio]:
        """The conserved sum as a factor of u^2, and what is free of u."""
        if is_driven(self.model):
            parts = self.by_degree(c)
            return parts.second, self._in_place(parts.rest, c)
        if len(self.model.coordinates) > 1:
            mass, rest = self._reduced(c)
            return mass / 2, self.field.lowest_terms(rest / 2 + self.potential(dict(self._held)))
        return self.model.dynamics.mass_matrix[0][0] / 2, self.potential({})

    def by_degree(self, c: Coordinate) -> JacobiParts:
        """T2 by the square of the one speed that is left, what else T2 - T0 has, V and what the time in T1 adds. Raises
        CannotAnswer where the time is in what is conserved."""
        if self.model.dependent:
            raise CannotAnswer(_DRIVEN)
        f, q, speeds = self.field, c.index, self.speeds(c)
        kept = -self._kinetic  # T2 - T0
        for k in self.model.coordinates:
            kept = kept + f.variable(k.speed) * f.derivative(self._kinetic, k.speed)
        degrees = [*f.lowest_terms(f.follow(kept, speeds)).coefficients(c.speed), f.zero, f.zero][:3]
        potential = self._potential(SymbolicState(self.model))
        inertia = f.lowest_terms(f.derivative(f.derivative(self._kinetic, c.speed), f.index(f.time)))
        slopes = [f.derivative(degrees[0], q), f.derivative(potential, q), inertia, degrees[2]]
        if any(self._in_time & f.ingredients(f.lowest_terms(x)) for x in slopes):
            raise CannotAnswer(_DRIVEN)
        led = antiderivative(inertia, q)
        if led is None:
            raise CannotAnswer(_DRIVEN)
        return JacobiParts(degrees[2], -degrees[0], potential, led)

    def _in_place(self, x: Ratio, c: Coordinate) -> Ratio:
        """Without what is the same in all places, such as the height to which a drive has led everything by now."""
        f = self.field
        alone = f.follow(x, {c.index: self.start.of(c.index)})
        return f.lowest_terms(x - alone if self._in_time & f.ingredients(alone) else x)

    @property
    def _in_time(self) -> set[int]:
        return {g for g, generator in self.field.generators.items() if generator.kind == "time"}

    def _without_time(self, x: Ratio) -> Ratio:
        if self._in_time & self.field.ingredients(x):
            raise CannotAnswer(_DRIVEN)
        return x

    def on_its_line(self, x: Ratio) -> Ratio:
        """Where other coordinates stay at rest a distance in a plane may be one along a line, sqrt(y^2) = y, on the
        side of the start. A coordinate that is a distance itself is never on the other side."""
        f, samples = self.field, self.model.samples
        roots = {g: f.radicand(g) for g in x.generators() if f.generators[g].kind == "root" and f.generators[g].made_of}
        if not (self.keeps_side and self._held):
            roots = {g: square for g, square in roots.items() if self._keeps_sign(square)}
        plain = {g: x for g, x in roots.items() if all(n % 2 == 0 for _base, n in f.factor(x.num)[1])}
        if any(abs(value) < ROUND_OFF for x in plain.values() for value in samples.at_starts(x)):
            return x  # it begins where it has no side
        taken = {g: f.sqrt(square, samples.is_negative) for g, square in plain.items()}
        return f.lowest_terms(f.substitute(x, taken)) if taken else x

    def _keeps_sign(self, square: Ratio) -> bool:
        """Whether what a square is of has one sign: a product of coordinates that are never negative."""
        measures, f = self.model.system.measures, self.field
        sizes = {c.index for c in self.model.coordinates if c.name in measures and measures[c.name].is_size}
        bases = [base for base, _n in f.factor(square.num)[1]]
        return all(any(base == f.variable(g) for g in sizes) or sign_of(base).is_strict for base in bases)

    def _explicit(self, x: Ratio) -> Ratio:
        """Without the angles that closed loops bind, and with what stays at rest where it is."""
        x = self._closure.explicit(x) if self.model.dependent else x
        return self.field.follow(x, self._held) if self._held else x

    @cached_property
    def resting(self) -> dict[int, Ratio]:
        """The coordinates, by generator, that stay where they start, and their speeds: they start at rest, and while
        all of them are there none is accelerated, whatever the others do."""
        if self.model.dependent or is_driven(self.model) or len(self.model.coordinates) < 2:
            return {}
        return {g: x for g, x in staying_of(self.model, self.start).items() if g not in self.apart}

    @cached_property
    def _held(self) -> dict[int, Ratio]:
        """What is no variable here: what stays at rest, and what moves apart."""
        return self.resting | self.apart

    @cached_property
    def _closure(self) -> Closure:
        return Closure(self.model)

    def speeds_at(self, c: Coordinate, at: Ratio, speed: Ratio) -> dict[int, Ratio]:
        """The speeds of the other coordinates, by generator, where one of them has a value and a speed; nothing where
        they do not follow."""
        try:
            speeds = self.speeds(c)
        except CannotAnswer:
            return {}
        own = {c.index: at, c.speed: speed}
        return {k: self.field.follow(x, own) for k, x in speeds.items() if k != c.speed and k not in self.apart}

    def places_at(self, c: Coordinate, at: Ratio, time: Ratio | None) -> dict[int, Ratio]:
        """The other coordinates, by generator, where one of them has a value: dq_k/dt = a + b(q) dq/dt is integrated
        where a does not change, over the way and, unless a is zero, over time (a momentum that stays zero keeps the
        mass centre where it is)."""
        f, found = self.field, dict[int, Ratio]()
        try:
            speeds = self.speeds(c)
        except CannotAnswer:
            return {}
        for k in self.model.coordinates:
            if k is c or k.index in self.apart:
                continue
            speed = speeds[k.speed]
            along = f.partial(speed, c.speed)
            drift = f.lowest_terms(speed - along * f.variable(c.speed))
            way = antiderivative(f.lowest_terms(along), c.index)
            if way is None or not drift.is_constant() or (time is None and not drift.is_zero()):
                continue
            begins, ends = (f.follow(way, {c.index: q}) for q in (self.start.of(c.index), at))
            moved = ends - begins if time is None else ends - begins + drift * time
            found[k.index] = f.lowest_terms(self.start.of(k.index) + moved)
        return found

    def _check(self, c: Coordinate) -> None:
        others = [k for k in self.model.coordinates if k is not c and k.index not in self._held]
        if any(k.index in self._needed for k in others):
            raise CannotAnswer(
                Message(
                    "there are {n} degrees of freedom; energy alone gives the speed of one",
                    n=self.model.degrees_of_freedom,
                )
            )
        if self.model.dependent and not self._has_solved_loops:
            names = ", ".join(d.name for d in self.model.dependent)
            raise CannotAnswer(Message("{names} follow from {x} only through the closed loop", names=names, x=c.name))

    @cached_property
    def _has_solved_loops(self) -> bool:
        try:
            self._closure.at({})
        except (CannotAnswer, ZeroDivisionError):
            return False
        return True

    @cached_property
    def _needed(self) -> set[int]:
        """The coordinates on which masses and potential depend; with one freedom there are no others to ask for."""
        if self.model.degrees_of_freedom == 1:
            return set()
        if self.model.dependent and not self._has_solved_loops:
            return {k.index for k in self.model.coordinates}
        if is_driven(self.model):
            elements = [self._kinetic, self._potential(SymbolicState(self.model))]
        else:
            entries = [self._explicit(x) for row in self.model.dynamics.mass_matrix for x in row]
            elements = [*entries, self.potential(dict(self._held))]
        return set[int]().union(*map(self.field.ingredients, elements))

    def speeds(self, c: Coordinate) -> dict[int, Ratio]:
        """All speeds by that of one coordinate, as the momenta of the others give them."""
        self._check(c)
        f, names = self.field, self.model.coordinates
        own = names.index(c)
        others = [k for k in range(len(names)) if k != own and names[k].index not in self._held]
        rows: list[Row] = []
        for k in others:
            line = [self._explicit(x) for x in self.model.dynamics.mass_matrix[k]]
            _now, momentum = self.momentum(names[k])
            row = {names[j].speed: line[j] for j in others if not line[j].is_zero()}
            right = momentum - self._led_momentum(names[k]) - line[own] * f.variable(c.speed)
            rows.append(row if right.is_zero() else {**row, RHS: right})
        solved = solve(f, rows, [names[k].speed for k in others], lambda x: x.is_zero())
        if solved.free or solved.contradictory:
            raise CannotAnswer(Message("the momenta do not give the speeds of the other coordinates"))
        found = {k: f.lowest_terms(line.get(RHS, f.zero)) for k, line in solved.pivots.items()}
        still = {k.speed: f.zero for k in names if k.index in self._held}
        return {**still, **found, c.speed: f.variable(c.speed)}

    def potential(self, values: dict[int, Ratio]) -> Ratio:
        """Minus the work function of all loads; each must be a function of its own measure."""
        if self.model.dependent and self._has_solved_loops:
            places = {c.index: values[c.index] for c in self.model.coordinates if c.index in values}
            values = self._closure.at(places) | values
        state = SymbolicState(self.model, values)
        if is_driven(self.model):
            raise CannotAnswer(_DRIVEN)
        return self._potential(state)

    def potential_by_loads(self) -> Ratio:
        """The potential energy in coordinates, those that loops bind among them."""
        return self._potential(SymbolicState(self.model))

    def _potential(self, state: SymbolicState) -> Ratio:
        total = self.field.zero
        for push in self.model.system.applied_loads:
            total = total + self.potential_of(push, state)
        self._check_forms(total)
        return total

    def _check_forms(self, potential: Ratio) -> None:
        """What holds velocities at zero does no work; but the energy gives a speed only where there is one, and where
        neither mass nor potential knows of a place that velocities alone lead to (how far a disk has turned)."""
        model, f = self.model, self.field
        forms = [row for row in model.system.constraint_rows if isinstance(row.measure, NonholonomicForm)]
        if not forms:
            return
        looped = set[int]().union(*(f.ingredients(e.value) for e in model.loops))
        led = {d.index for d in model.dependent} - looped
        used = [potential, *(x for row in model.dynamics.mass_matrix for x in row)]
        is_led = any(led & f.ingredients(f.lowest_terms(x)) for x in used)
        if is_led or model.degrees_of_freedom != 1 or any(row.in_symbols is not None for row in forms):
            raise CannotAnswer(_DRIVEN)

    def potential_of(self, push: AppliedLoad, state: SymbolicState) -> Ratio:
        """Of one load; along the motion, where it has none of its own."""
        try:
            return state.potential(push)
        except CannotAnswer:
            way = self.work_function(push)
            if way is None:
                raise
            return -state.here(way)

    def work_function(self, push: AppliedLoad) -> Ratio | None:
        """The integral of the generalized force of a load over the one coordinate that it moves and depends on."""
        f, model = self.field, self.model
        if model.dependent:
            return None
        law, forces = model.loads.law(push), list[tuple[Coordinate, Ratio]]()
        for k, c in enumerate(model.coordinates):
            if c.index in self.apart:
                continue
            force = f.zero
            for (body, slot), slope in model.gradient(push.measure).items():
                if body in model.kinematics.partial_velocities:
                    part = model.kinematics.partial_velocities[body][k][model.bodies.slots.index(slot)]
                    force = force + law * slope * part
            if not (force := f.lowest_terms(force)).is_zero():
                forces.append((c, force))
        if not forces:
            return f.zero
        if len(forces) > 1:
            return None
        ((c, force),) = forces
        moving = {g for k in model.coordinates for g in (k.index, k.speed)} - {c.index}
        if f.ingredients(force) & (moving | self._in_time):
            return None
        return antiderivative(force, c.index)


@dataclass(frozen=True)
class JacobiParts:
    """The factor of u^2 in the kinetic energy, what of it is free of u (T0, less what momenta keep), the potential
    energy, and the potential of the inertia force that a drive which accelerates brings."""

    second: Ratio
    free: Ratio
    potential: Ratio
    led: Ratio

    @property
    def rest(self) -> Ratio:
        """What of the conserved sum is free of u."""
        return self.potential - self.free + self.led


def is_driven(model: SymbolicModel) -> bool:
    """True where something is held at a function of time."""
    return any(row.general is not None or row.is_driven for row in model.system.constraint_rows)


def staying_of(model: SymbolicModel, start: StartState) -> dict[int, Ratio]:
    """The independent coordinates, by generator, that stay where they start, and their speeds: they start at rest, and
    while all of them are there none is accelerated, whatever the others do."""
    f, solved = model.field, model.dynamics.solved_accelerations
    pairs = [(c, a) for c, a in zip(model.coordinates, model.accelerations, strict=True) if start.of(c.speed).is_zero()]
    begun = {k: x for c, _a in pairs for k, x in ((c.index, start.of(c.index)), (c.speed, f.zero))}
    pairs = [(c, a) for c, a in pairs if not model.samples.is_nonzero_where(solved[a], begun)]
    while pairs:
        there = {k: x for c, _a in pairs for k, x in ((c.index, start.of(c.index)), (c.speed, f.zero))}
        still = [(c, a) for c, a in pairs if f.lowest_terms(f.follow(solved[a], there)).is_zero()]
        if len(still) == len(pairs):
            return there
        pairs = still
    return {}
