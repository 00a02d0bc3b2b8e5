"""The rate of a momentum or an energy, from the principle that governs it.

    linear momentum along e         d(P.e)/dt = F.e                      + P.de/dt where e turns with a body
    angular momentum about O        dH_O/dt = M_O - v_O x P              O may move; M_O of all that acts from outside;
                                                                         along e in space as above
    energy                          d(T + V)/dt = power of what stores no energy
    generalized momentum            dp/dt = Q + sum of m v . d(dv/du)/dt

F and M_O are summed over the loads and the reactions of those connections that reach outside the bodies that are meant.
The same rate follows by differentiating the quantity and putting in the accelerations: `by_differentiation`. Both are
reduced to independent coordinates and speeds, where they must be equal.
Source: Ginsberg, Engineering Dynamics (2008), sec. 5.1; Kane & Levinson, Dynamics (1985), ch. 6 and 7.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, singledispatchmethod

from freebody.errors import CannotAnswer
from freebody.language.expression import free_symbols
from freebody.language.sentences import Message
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, Direction
from freebody.model.elements import AppliedLoad, ConstraintRow, NonholonomicForm
from freebody.questions.base import Quantity
from freebody.questions.conservation import GeneralizedMomentum, JacobiIntegral
from freebody.questions.energy import Energy
from freebody.questions.momentum import AngularMomentum, Momentum, point_about
from freebody.questions.vectors import Group, components_of, cross, dot, is_among, place
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.state import SymbolicState, law_polynomial
from freebody.symbolic.unknowns import Coordinate
from freebody.system.system import System

Wrench = tuple[Ratio, ...]  # force, then moment about the mass centre: three in the plane, six in space


CARRIED = "-v × P"  # the part of the rate of an angular momentum about a point that moves with v


class IsVector(CannotAnswer):
    """A vector was asked for where a scalar is meant."""

    def __init__(self) -> None:
        super().__init__(Message("a vector is conserved along some directions and not along others; name one"))


@dataclass(frozen=True)
class RatePrinciple:
    """A rate as a sum of named parts."""

    statement: str
    parts: tuple[tuple[str, Ratio], ...]

    def total(self, zero: Ratio) -> Ratio:
        return sum((part for _name, part in self.parts), start=zero)


class RateBalance:
    """One quantity of one system: the quantity itself, and its rate in two ways."""

    def __init__(self, quantity: Quantity, system: System, state: SymbolicState, name: str = "quantity") -> None:
        self.quantity = quantity
        self.name = name
        self.system = system
        self.state = state
        self.model: SymbolicModel = state.model
        self.field = state.model.field

    # -- the quantity -------------------------------------------------------------------------
    @cached_property
    def value(self) -> Ratio:
        """The quantity in coordinates and independent speeds. Raises CannotAnswer for a vector."""
        return self._value(self.quantity)

    @singledispatchmethod
    def _value(self, q: Quantity) -> Ratio:
        """By the kind of quantity: what is stated over a state, and what needs the coordinates or potentials."""
        found = q.value(self.system, self.state)
        if isinstance(found, tuple):
            raise IsVector
        return self.field.lowest_terms(self.field.element(found))

    def _coordinate(self, name: str) -> Coordinate:
        for c in self.model.coordinates:
            if c.name == name:
                return c
        known = ", ".join(c.name for c in self.model.coordinates)
        raise CannotAnswer(
            Message(
                "{name} is no generalized coordinate of this system; these are: {known}",
                name=name,
                known=known or Message("none"),
            )
        )

    @_value.register(GeneralizedMomentum)
    def _value_of_conjugate(self, q: GeneralizedMomentum) -> Ratio:
        return self._conjugate(self._coordinate(q.coordinate))

    def _conjugate(self, c: Coordinate) -> Ratio:
        """p = sum of m v . dv/du"""
        k = self.model.coordinates.index(c)
        total = self.field.zero
        for name, partials in self.model.kinematics.partial_velocities.items():
            for momentum, slope in zip(self._momentum_of(name), partials[k], strict=True):
                total = total + momentum * slope
        return self.field.lowest_terms(total)

    @_value.register(Energy)
    def _energy(self, q: Energy) -> Ratio:
        if q.is_up_to_constant and self.unwritten:
            names = ", ".join(dict.fromkeys(push.load for push in self.unwritten))
            raise CannotAnswer(Message("the potential energy of {loads} has no closed form here", loads=names))
        kinetic = self.field.element(Energy("kinetic", q.body).value(self.system, self.state))
        potential = self.field.zero
        for push in self.storing:
            if q.body is None or q.body in set(push.measure.bodies()):
                potential = potential + self.state.potential(push)
        if q.what == "kinetic":
            return self.field.lowest_terms(kinetic)
        return self.field.lowest_terms(potential if q.what == "potential" else kinetic + potential)

    @_value.register(JacobiIntegral)
    def _jacobi(self, q: JacobiIntegral) -> Ratio:
        """h = sum u p - L"""
        kinetic = self.field.element(Energy("kinetic").value(self.system, self.state))
        total = sum((self.state.potential(push) for push in self.storing), start=self.field.zero) - kinetic
        for c in self.model.coordinates:
            total = total + self.field.variable(c.speed) * self._conjugate(c)
        return self.field.lowest_terms(total)

    @cached_property
    def storing(self) -> tuple[AppliedLoad, ...]:
        """The loads whose work is a potential energy."""
        return tuple(push for push in self.system.applied_loads if is_conservative(self.system, push))

    @cached_property
    def unwritten(self) -> tuple[AppliedLoad, ...]:
        """Those of them whose potential is not written down: an integral of the law."""
        return tuple(push for push in self.storing if not is_polynomial_law(push))

    # -- its rate -----------------------------------------------------------------------------
    @cached_property
    def rate(self) -> Ratio:
        """By differentiation, the accelerations put in. Where closed loops bind the coordinates these have no short
        form: then by the principle, as far as that needs none of them (energy, and momentum that no connection passes
        on). Raises CannotAnswer otherwise."""
        m = self.model
        has_potential = self.quantity.is_up_to_constant
        is_of_pose = self.quantity.kinematic_order == 0
        if (m.loops and not is_of_pose) or (has_potential and self.unwritten):
            principle = self.by_principle() if has_potential or self._is_isolated(self.quantity) else None
            if principle is None:
                raise CannotAnswer(Message("closed loops bind the coordinates, so its rate has no short form"))
            return m.field.lowest_terms(principle.total(m.field.zero))
        rate = m.in_independent_speeds(m.rate(self.value))
        if rate.generators() & set(m.accelerations):
            rate = m.in_independent_speeds(m.field.substitute(rate, m.dynamics.solved_accelerations))
        return m.field.lowest_terms(rate)

    @singledispatchmethod
    def _is_isolated(self, q: Quantity) -> bool:
        """Whether no connection reaches from outside to the bodies of a momentum."""
        return False

    @_is_isolated.register(Momentum)
    @_is_isolated.register(AngularMomentum)
    def _no_row_reaches(self, q: Momentum | AngularMomentum) -> bool:
        return not any(self.reaches_outside(row, q.body) for row in self.system.constraint_rows)

    def by_principle(self) -> RatePrinciple | None:
        """By the principle; None for a quantity without one of its own. Raises CannotAnswer where a reaction that
        reaches outside is not unique."""
        return self._principle(self.quantity)

    @singledispatchmethod
    def _principle(self, q: Quantity) -> RatePrinciple | None:
        return None

    @_principle.register(Momentum)
    def _of_momentum(self, q: Momentum) -> RatePrinciple:
        assert q.along is not None
        e = components_of(q.along, self.state, self._n)
        parts = [(name, dot(push[: self._n], e)) for name, push in self._from_outside(q.body)]
        statement = Message("dP/dt along a fixed direction is the force from outside along it")
        if self._turns(q.along):
            momentum = Momentum(q.body).value(self.system, self.state)
            parts.append((Message("P·de/dt, since the direction turns"), dot(momentum, self._rates(e))))
            statement = "d(P·e)/dt = F·e + P·de/dt"
        return RatePrinciple(statement, tuple(parts))

    @_principle.register(AngularMomentum)
    def _of_spin(self, q: AngularMomentum) -> RatePrinciple:
        n = self._n
        about, velocity = point_about(self.system, self.state, q)
        e = components_of(q.along, self.state, n) if q.along is not None else (self.field.one,)
        parts: list[tuple[str, Ratio]] = []
        for name, body, push in self._wrenches(q.body):
            center = place(self.system, self.state, self.system.bodies[body].mass_center)
            arm = tuple(c - o for c, o in zip(center, about, strict=True))
            moment = tuple(m + x for m, x in zip(push[n:], cross(arm, push[:n]), strict=True))
            parts.append((Message("moment of {load}", load=name), dot(moment, e)))
        momentum = Momentum(q.body).value(self.system, self.state)
        along = dot(cross(velocity, momentum), e)
        carried = self.field.lowest_terms(-self.field.element(along))
        statement = Message("dH/dt = M about this point")
        extra: list[tuple[str, Ratio]] = []
        if not carried.is_zero():
            statement = Message("dH/dt = M - v × P about the moving point")
            extra.append((CARRIED, carried))
        if q.along is not None and self._turns(q.along):
            whole = replace(q, along=None).value(self.system, self.state)
            extra.append((Message("H·de/dt, since the direction turns"), dot(whole, self._rates(e))))
            statement = Message("{law}, and H·de/dt along the turning direction", law=statement)
        return RatePrinciple(statement, (*_merged(parts, self.field.zero), *extra))

    @property
    def _n(self) -> int:
        """Components of a force."""
        return 3 if self.system.space else 2

    def _turns(self, direction: Direction) -> bool:
        return direction.body != GROUND and not self.system.bodies[direction.body].fixed

    def _rates(self, e: Sequence[Ratio]) -> tuple[Ratio, ...]:
        return tuple(self._in_speeds(self.model.rate(self.field.element(c))) for c in e)

    @_principle.register(Energy)
    def _of_energy(self, q: Energy) -> RatePrinciple | None:
        if q.what != "total" or q.body is not None:
            return None
        parts: list[tuple[str, Ratio]] = []
        for push in self.system.applied_loads:
            if push not in self.storing:
                parts.append((f"power of {push.load}", self.state.law(push) * self.state.rate(push.measure)))
        for row in self.system.constraint_rows:
            rate = self.state.rate(row.measure)
            if not rate.is_zero() and row.target is not None:
                parts.append((f"power of {row.connection}", self.state.multiplier(row) * rate))
        return RatePrinciple(
            Message("d(T + V)/dt is the power of what stores no energy"), _merged(parts, self.field.zero)
        )

    @_principle.register(GeneralizedMomentum)
    def _of_conjugate(self, q: GeneralizedMomentum) -> RatePrinciple:
        c = self._coordinate(q.coordinate)
        m, k = self.model, self.model.coordinates.index(c)
        force, change = m.dynamics.generalized_force(c), self.field.zero
        for name, partials in m.kinematics.partial_velocities.items():
            turning = map(self._in_speeds, m.dynamics.turning_momentum(name))
            for momentum, slope, gyroscopic in zip(self._momentum_of(name), partials[k], turning, strict=True):
                # along turning axes dT/dq is not the momentum times the rate of dv/du alone
                change = change + momentum * self._in_speeds(m.rate(slope)) - gyroscopic * slope
        parts = ((Message("generalized force along {x}", x=c.name), self._in_speeds(force)), (f"dT/d{c.name}", change))
        return RatePrinciple("dp/dt = Q + dT/dq", parts)

    def _momentum_of(self, body: str) -> tuple[Ratio, ...]:
        """Along the slots of a body, in independent speeds."""
        return self.model.dynamics.momentum(body, tuple(map(self._in_speeds, self.model.kinematics.velocities[body])))

    # -- what acts ----------------------------------------------------------------------------
    def _in_speeds(self, x: Ratio) -> Ratio:
        return self.model.in_independent_speeds(x)

    def _from_outside(self, group: Group) -> tuple[tuple[str, Wrench], ...]:
        """Forces by name, summed over the bodies."""
        total: dict[str, Wrench] = {}
        for name, _body, push in self._wrenches(group):
            known = total.get(name, (self.field.zero,) * len(push))
            total[name] = tuple(a + b for a, b in zip(known, push, strict=True))
        return tuple(total.items())

    def _wrenches(self, group: Group) -> Iterator[tuple[str, str, Wrench]]:
        """(load or connection, body, what it exerts on it); connections inside the group cancel and are left out."""
        for push in self.system.applied_loads:
            yield from self._acting(push.load, push.measure, self.state.law(push), group)
        for row in self.system.constraint_rows:
            if self.reaches_outside(row, group):
                yield from self._acting(row.connection, row.measure, self.state.multiplier(row), group)

    def _acting(
        self, name: str, measure: Displacement | NonholonomicForm | object, size: Ratio, group: Group
    ) -> Iterator[tuple[str, str, Wrench]]:
        for body in self._touched(measure):
            if is_among(body, group):
                push = self.state.gradient(measure, body)  # pyrefly: ignore[bad-argument-type]
                yield name, body, tuple(g * size for g in push)

    def _touched(self, measure: object) -> Iterable[str]:
        moving = {b.name for b in self.system.moving}
        return dict.fromkeys(b for b, _slot in self.model.gradient(measure) if b in moving)  # pyrefly: ignore[bad-argument-type]

    def reaches_outside(self, row: ConstraintRow, group: Group) -> bool:
        """Whether a row exerts anything on a body that is not meant, the ground among these: the sum of its forces and
        moments on those that are meant does not vanish."""
        touched = list(self._touched(row.measure))
        if not any(is_among(b, group) for b in touched):
            return False
        n = self._n
        total: tuple[Ratio, ...] = (self.field.zero,) * (6 if self.system.space else 3)
        for body in touched:
            if is_among(body, group):
                push = self.state.gradient(row.measure, body)
                center = place(self.system, self.state, self.system.bodies[body].mass_center)
                moment = (m + x for m, x in zip(push[n:], cross(center, push[:n]), strict=True))
                total = tuple(a + b for a, b in zip(total, (*push[:n], *moment), strict=True))
        return not all(self.model.samples.vanishes(part) for part in total)


def _merged(parts: Iterable[tuple[str, Ratio]], zero: Ratio) -> tuple[tuple[str, Ratio], ...]:
    """Parts of one name added; those that vanish are left out."""
    total: dict[str, Ratio] = {}
    for name, part in parts:
        total[name] = total.get(name, zero) + part
    return tuple((name, zero.field.lowest_terms(part)) for name, part in total.items() if not part.is_zero())


def is_conservative(system: System, push: AppliedLoad) -> bool:
    """Whether a load is a law of its own measure alone: then its work is that of a potential, in closed form or not.
    Forces and torques that are applied from outside are not counted among these."""
    if not system.loads[push.load].stores_energy:
        return False
    if isinstance(push.measure, NonholonomicForm) or push.measures or push.general is not None:
        return False
    symbols = free_symbols(push.law)
    return not {"@rate", "t"} & symbols and "rate(" not in str(push.law)


def is_polynomial_law(push: AppliedLoad) -> bool:
    try:
        law_polynomial(push)
    except CannotAnswer:
        return False
    return True
