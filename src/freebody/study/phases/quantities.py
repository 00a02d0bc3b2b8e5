"""Quantities in one mode, stated once for both routes: what a friction does is a held row where it sticks, a load where
it slides, and nothing where its contact is open."""

from __future__ import annotations

import operator
from collections.abc import Iterable, Sequence
from dataclasses import replace
from functools import reduce, singledispatch
from typing import Any, Protocol, runtime_checkable

from freebody.errors import CannotAnswer
from freebody.language.expression import ONE
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.measures.combination import is_of_turning
from freebody.measures.geometry import Direction
from freebody.model.elements import AppliedLoad, ConstraintRow, NonholonomicForm
from freebody.model.state import State
from freebody.questions.arithmetic import Joined
from freebody.questions.base import Quantity
from freebody.questions.blow import ImpulsiveWrench
from freebody.questions.energy import resists
from freebody.questions.loads import Extension, LoadForce, Power
from freebody.questions.reactions import Wrench, whole_only
from freebody.questions.reactions_by_component import ReactionComponent
from freebody.questions.vectors import component
from freebody.study.conservation.balance import is_conservative
from freebody.system.system import System


@runtime_checkable
class Totals(Protocol):
    """A state that knows a sum of reactions, also where only the sum is unique."""

    def total(self, parts: Sequence[tuple[float, ConstraintRow]]) -> Any: ...


@runtime_checkable
class TotalImpulses(Protocol):
    """A state just after a blow that knows a sum of impulses, also where only the sum is unique."""

    def total_impulse(self, parts: Sequence[tuple[Any, ConstraintRow]]) -> Any: ...

    def gradient(self, measure: Measure, body: str) -> Any: ...


def value_in_mode(quantity: Quantity, base: System, system: System, state: State[Any]) -> Any:
    """The quantity at an instant of a mode; `base` is the system with its contacts, `system` the mode."""
    return _value(quantity, base, system, state)


@singledispatch
def _value(quantity: Quantity, base: System, system: System, state: State[Any]) -> Any:
    return quantity.value(plain(system), state)


@_value.register(Joined)
def _joined(quantity: Joined, base: System, system: System, state: State[Any]) -> Any:
    return quantity.made_of(tuple(_value(q, base, system, state) for q in quantity.inner), state)


@_value.register(ReactionComponent)
def _component(quantity: ReactionComponent, base: System, system: System, state: State[Any]) -> Any:
    if quantity.further and isinstance(state, Totals):
        held = {row.name: row for row in system.constraint_rows}
        own = [row for row in base.rows if row.name in (quantity.row, *quantity.further)]
        if not quantity.less and all(row.name in held for row in own):
            return state.total([(row.sign, held[row.name]) for row in own])
    whole = frozenset((quantity.row, *quantity.further))
    found = reaction(quantity.row, quantity.less, base, system, state, whole)
    return reduce(operator.add, (_reaction(name, base, system, state, whole) for name in quantity.further), found)


@_value.register(Wrench)
def _wrench(quantity: Wrench, base: System, system: System, state: State[Any]) -> Any:
    if _is_contact(quantity.connection, base):
        return _force(quantity, base, system, state)
    if _is_open(quantity.connection, base, system):
        is_vector = quantity.along is None and not (quantity.size or quantity.moment)
        return (_zero(state), _zero(state)) if is_vector else _zero(state)
    return quantity.value(plain(system), state)


@_value.register(ImpulsiveWrench)
def _impulse(quantity: ImpulsiveWrench, base: System, system: System, state: State[Any]) -> Any:
    if _is_contact(quantity.connection, base):
        rows = [row for row in base.rows if row.connection == quantity.connection]
        if isinstance(state, TotalImpulses) and not quantity.moment:
            body = _pushed(quantity, base)
            slopes = [state.gradient(row.measure, body) for row in rows]
            n = 3 if base.space else 2
            whole = [state.total_impulse([(g[k], row) for g, row in zip(slopes, rows, strict=True)]) for k in range(n)]
            return component(tuple(whole), quantity.along, quantity.size, state, quantity.basis)
        return _resultant(quantity, base, [(row.measure, state.impulse(row)) for row in rows], state)
    return quantity.value(plain(system), state)


@_value.register(Extension)
def _extension(quantity: Extension, base: System, system: System, state: State[Any]) -> Any:
    return quantity.by_force(_value(quantity.force, base, system, state), state)


@_value.register(Power)
def _power(quantity: Power, base: System, system: System, state: State[Any]) -> Any:
    if _is_contact(quantity.of, base):
        slides = [
            r
            for r in system.constraint_rows
            if r.connection == quantity.of and any(r is rub.row for rub in base.dry_friction)
        ]
        powers = [state.law(p) * state.rate(p.measure) for p in _frictions(quantity.of, system)]
        powers += [state.multiplier(row) * state.rate(row.measure) for row in slides]  # as a simulation has them
        return sum(powers, _zero(state))
    return quantity.value(plain(system), state)


@_value.register(LoadForce)
def _of_load(quantity: LoadForce, base: System, system: System, state: State[Any]) -> Any:
    is_left_out = all(push.load != quantity.load for push in system.applied_loads)
    if is_left_out and any(row.connection == quantity.load for row in base.borders.values()):  # short of its border
        return _zero(state)
    return quantity.value(plain(system), state)


def plain(system: System) -> System:
    """Without the loads of frictions, which are no loads of the model."""
    return replace(system, applied_loads=tuple(p for p in system.applied_loads if p.load in system.loads))


def _is_contact(name: str, base: System) -> bool:
    return any(r.connection == name for r in (*(b.row for b in base.bounds), *(r.row for r in base.dry_friction)))


def _is_open(name: str, base: System, system: System) -> bool:
    """Whether a connection that closes in mid-motion has not closed yet."""
    is_meant = any(name in blow.closing for blow in base.blows)
    return is_meant and all(row.connection != name for row in system.constraint_rows)


def frictions(system: System) -> list[AppliedLoad]:
    """The dry friction that slides in a mode."""
    return [p for p in system.applied_loads if p.load not in system.loads]


def _frictions(connection: str, system: System) -> list[AppliedLoad]:
    return [p for p in frictions(system) if connection_of(p) == connection]


def only_friction_takes_energy(system: System) -> bool:
    """Whether what friction turns into heat is what the mechanical energy loses: nothing is driven, and all other loads
    store what they take."""
    stores = all(is_conservative(system, p) for p in plain(system).applied_loads)
    return stores and not any(row.is_driven for row in system.constraint_rows)


def only_takes_energy(system: System) -> bool:
    """The same where drag and dampers take energy, too: what is not stored is lost."""
    loads = plain(system).applied_loads
    takes = all(resists(system, p.load) or is_conservative(system, p) for p in loads)
    return takes and not any(row.is_driven for row in system.constraint_rows)


def taking_energy(system: System) -> set[str]:
    """The connections in which energy may be lost: that rub, or collide."""
    rubbing = {d.name.partition(".")[0] for d in system.dry_friction} | set(map(connection_of, frictions(system)))
    return rubbing | {bound.row.connection for bound in system.bounds}


def connection_of(push: AppliedLoad) -> str:
    """Of dry friction that slides: where it rubs."""
    return push.load.partition(".")[0]


def reaction(
    row: str,
    less: Iterable[str],
    base: System,
    system: System,
    state: State[Any],
    whole: frozenset[str] = frozenset(),
) -> Any:
    """The reaction of a row, less those of others; whole: the rows of the sum of which it is a part. Raises
    CannotAnswer where only the sum with rows that are not in it is determined."""
    parts = (_reaction(name, base, system, state, whole) for name in less)
    return reduce(operator.sub, parts, _reaction(row, base, system, state, whole))


def _reaction(name: str, base: System, system: System, state: State[Any], whole: frozenset[str]) -> Any:
    row = next(row for row in base.rows if row.name == name)
    across = {rub.across.name: rub.name for rub in base.dry_friction if rub.across is not None}
    for held in system.constraint_rows:
        if name in (held.name, *held.stands_for):
            whole_only([held], whole | {name})
            return row.sign * state.multiplier(held) if held.name == name else _zero(state)
    for push in system.applied_loads:
        if push.load == row.name or (name in across and push.load == across[name]):
            return row.sign * state.law(push) * _share(push, row, base, state)
    return _zero(state)


def _share(push: AppliedLoad, row: ConstraintRow, base: System, state: State[Any]) -> Any:
    """How much of a friction force is along one of the two rows that it has in a plane, which are at right angles."""
    if push.measure == row.measure or not base.space:
        return state.scalar(ONE)
    body = next(b for b in row.measure.bodies() if not base.bodies[b].fixed)
    ways = zip(state.gradient(push.measure, body)[:3], state.gradient(row.measure, body)[:3], strict=True)
    return sum((a * b for a, b in ways), _zero(state))


def _force(quantity: Wrench, base: System, system: System, state: State[Any]) -> Any:
    """The force of a contact on a body: its rows, and its friction where that slides."""
    rows = [row for row in system.constraint_rows if row.connection == quantity.connection and quantity.counts(row)]
    quantity.must_have_whole(system.constraint_rows, _pushed(quantity, base), 3 if base.space else 2, state)
    if base.space and isinstance(state, Totals):
        body = _pushed(quantity, base)
        slopes = [state.gradient(row.measure, body)[:3] for row in rows]
        whole = (state.total([(float(g[k]), row) for g, row in zip(slopes, rows, strict=True)]) for k in range(3))
        return component(tuple(whole), quantity.along, quantity.size, state, quantity.basis)
    pushes = [(row.measure, state.multiplier(row)) for row in rows]
    counted = {row.name for row in base.rows if quantity.counts(row)}
    rubs = [push for push in _frictions(quantity.connection, system) if push.load in counted]
    pushes += [(push.measure, state.law(push)) for push in rubs]
    return _resultant(quantity, base, pushes, state)


def _resultant(
    quantity: Wrench, base: System, pushes: Iterable[tuple[Measure | NonholonomicForm, Any]], state: State[Any]
) -> Any:
    """What pushes of measures, forces or impulses, are on a body together."""
    body = _pushed(quantity, base)
    if base.space:
        force: tuple[Any, ...] = (_zero(state),) * 3
        for measure, size in pushes:
            force = tuple(f + g * size for f, g in zip(force, state.gradient(measure, body), strict=False))
        return component(force, quantity.along, quantity.size, state, quantity.basis)
    fx, fy, couple = _zero(state), _zero(state), _zero(state)
    for measure, size in pushes:
        gx, gy, g = state.gradient(measure, body)
        fx, fy, couple = fx + gx * size, fy + gy * size, couple + g * size
    if quantity.moment:
        return state.sqrt(couple * couple) if quantity.size else couple
    if quantity.size:
        return state.sqrt(fx * fx + fy * fy)
    if quantity.along is None:
        return fx, fy
    ex, ey = _unit(quantity.along, state)
    return fx * ex + fy * ey


def _pushed(quantity: Wrench, base: System) -> str:
    """The body on which the force of a contact is asked: the one named, else the first that moves. Raises CannotAnswer
    where its moment is asked and it is no couple."""
    pushed = [row.measure for row in base.rows if row.connection == quantity.connection]
    if quantity.moment and (base.space or not all(map(is_of_turning, pushed))):
        raise CannotAnswer(
            Message("the moment of a contact is asked by its forces; ask for its normal and friction force")
        )
    touched = dict.fromkeys(b for r in base.rows if r.connection == quantity.connection for b in r.measure.bodies())
    moving = [b for b in touched if not base.bodies[b].fixed]
    if not quantity.on and not moving:
        raise CannotAnswer(Message("{connection} acts on nothing that moves", connection=quantity.connection))
    return quantity.on or moving[0]


def _unit(along: Direction, state: State[Any]) -> tuple[Any, Any]:
    from freebody.measures.displacement import Displacement
    from freebody.measures.geometry import RIGHT, UP, ZERO, Point

    tip, foot = Point(along.body, along.components), Point(along.body, (ZERO, ZERO))
    return state.value(Displacement(tip, foot, RIGHT)), state.value(Displacement(tip, foot, UP))


def _zero(state: State[Any]) -> Any:
    from freebody.language.expression import ZERO

    return state.scalar(ZERO)
