"""Closed forms of rest and of small oscillations about it: what an equilibrium needs, and what is to be said of it."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import replace

from freebody.errors import CannotAnswer
from freebody.language.expression import FLOAT_FUNCTIONS, ZERO, Expr, Symbol, evaluate, free_symbols, n_operations
from freebody.language.notation import compared, joined, reworded, to_text
from freebody.language.sentences import Message, further
from freebody.language.units import FORCE, TORQUE
from freebody.measures.base import Measure
from freebody.questions.base import Quantity, Wanted
from freebody.questions.event_base import QuestionEvent
from freebody.questions.motion import OfMeasure
from freebody.questions.reading import Question
from freebody.questions.small_motion import Equilibrium, RestValue, SmallOscillations
from freebody.questions.turned_round import ValueFor
from freebody.study.answering.draws import Draw
from freebody.study.answering.finding import Elements, Finding
from freebody.study.setup import Setup
from freebody.symbolic.conditions import Condition, insisted, require
from freebody.symbolic.decide import decide
from freebody.symbolic.equilibrium import (
    ClosedFormRest,
    StateOfRest,
    bound_at,
    equilibria,
    find_equilibrium,
    lies_in_family,
)
from freebody.symbolic.linearised import stand_still, swing_of, timed_in
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign, sign_of
from freebody.symbolic.small_motion import FreeOscillations, free_oscillations, place_of_mode
from freebody.symbolic.state import SymbolicState
from freebody.symbolic.tidy import tidy
from freebody.symbolic.validity import texts
from freebody.system.modes import depends_on_time, with_loads
from freebody.system.system import System

_STEP = 0.1  # [SI] from pose to pose on the way to another one
_SAME = 1e-6  # of the size: poses are one
_MOST_SHOWN = 40  # operations of a load that is told
_MOST_RESTS = 4  # that are named beside the one that is meant


def oscillations(setup: Setup, question: Question, q: SmallOscillations) -> Finding:
    """Frequencies and period of small oscillations about the equilibrium that is meant."""
    from freebody.study.answering import at_equilibrium

    model = setup.model
    found = free_oscillations(model, setup.start, setup.rest_of_small_motion)
    f = model.field
    resting = needs_of_rest(setup, found.rest, ">")
    squares, notes = [found.squares[k] for k in found.swinging], list(found.notes)
    meant = found.swinging if q.number is None else (place_of_mode(len(found.squares), q.number),)
    if q.measure is not None:
        meant = _swinging_with(found, q.measure, q.name)
        squares = [found.squares[k] for k in meant]
    wanted = [
        x
        for k in (found.swinging if q.measure else meant)
        if not found.squares[k].is_zero()
        for x in found.positive(found.modes[k])
    ]
    unstable = CannotAnswer(further(*found.notes, Message("there is no oscillation about it: it is unstable")))
    swings = insisted((Condition(x, ">", Message("oscillates")) for x in dict.fromkeys(wanted)), unstable)
    if not found.squares:
        raise CannotAnswer(further(*found.notes, at_equilibrium.NOTHING_DRIVES_BACK))
    if q.what == "frequencies":
        squares = list(found.squares)
    elif q.number is not None:
        squares = [found.squares[meant[0]]]
        resting += _in_order(found, meant[0])
        if q.what == "period" and squares[0].is_zero():
            raise CannotAnswer(at_equilibrium.NOTHING_DRIVES_BACK)
    elif not squares:
        raise CannotAnswer(further(*found.notes, at_equilibrium.NOTHING_DRIVES_BACK))
    elif not all((x - squares[0]).is_zero() for x in squares):
        raise CannotAnswer(Message("there are {n} natural frequencies; ask for natural frequencies", n=len(squares)))
    else:
        if len(squares) > 1:
            notes.append(Message("{n} motions that are independent of one another have it", n=len(squares)))
        if len(found.swinging) < len(found.squares):
            notes.append(Message("beside it there is a motion that nothing drives back to first order"))
        del squares[1:]
    if any(not x.is_zero() for row in found.linear.damping for x in row):
        notes.append(Message("without damping; the damped frequency and the damped period take it into account"))
    if q.what == "period" and "small" not in question.text:
        notes.append(Message("of small oscillations; that of the motion as it starts is the period of a measure"))
    is_negative = _turning([*resting, *swings])
    if q.what == "period":
        roots = [f.sqrt(1 / squares[0], is_negative), f.lowest_terms(1 / f.sqrt(squares[0], is_negative))]
        element: Elements = 2 * f.pi * min(roots, key=lambda x: n_operations(tidy(x)))
    else:
        roots = [f.sqrt(s, is_negative) for s in squares]
        element = roots[0] if len(roots) == 1 else tuple(roots)
    evidence = at_equilibrium.small_oscillations(setup, question.text, q, element, found.equilibrium, resting, swings)
    return Finding(element, evidence, [*resting, *swings], notes, may_be_complex=found.are_real_by_symmetry)


def _in_order(found: FreeOscillations, place: int) -> list[Condition]:
    """That no slower mode of another factor comes behind one, and no faster one before: which is the first may depend
    on the parameters. Roots of one factor keep their order."""
    meant, needs = found.modes[place], list[Condition | None]()
    for k, other in enumerate(found.modes):
        if other.factor != meant.factor:
            x = found.model.field.lowest_terms((meant.square - other.square) * (1 if k < place else -1))
            needs.append(require(x, ">=", Message("the modes are in this order"))[0])
    return [c for c in needs if c is not None]


def _swinging_with(found: FreeOscillations, measure: Measure, name: str) -> tuple[int, ...]:
    """The modes in which a measure oscillates to first order. Raises CannotAnswer where it does not, or may move by
    what nothing drives back."""
    slopes = found.slopes(measure)
    if all(slope.is_zero() for slope in slopes):
        raise CannotAnswer(Message("to first order {x} does not move in small oscillations", x=name))
    if len(found.swinging) < len(found.squares) and not found.is_without_neutral(slopes):
        raise CannotAnswer(
            Message(
                "beside what oscillates there is a motion that nothing drives back to first order, which {x} may have "
                "a part in; ask for the period of small oscillations",
                x=name,
            )
        )
    return found.swinging_with(slopes)


def _turning(premises: Sequence[Condition]) -> Callable[[Ratio], bool | None]:
    """Whether something has a sign to turn; None where the parameters decide it, so that its size is meant."""

    def is_negative(x: Ratio) -> bool | None:
        sign = sign_of(x)
        if sign is Sign.UNKNOWN:
            return next((turned for turned in (False, True) if decide(-x if turned else x, ">", premises)), None)
        return sign in (Sign.NEGATIVE, Sign.NONPOSITIVE)

    return is_negative


def equilibrium(setup: Setup, question: Question, q: Equilibrium) -> Finding:
    """Where a measure comes to rest, whether that is stable, and where else it may."""
    from freebody.study.answering import at_equilibrium

    model = setup.model
    rest, *others = equilibria(model, setup.start, stable_first=False)
    x = SymbolicState(model, rest.values).value(q.measure)
    if any(x.field.generators[g].kind == "time" for g in x.field.ingredients(x)):
        raise CannotAnswer(Message("{x} is driven: it does not come to rest", x=q.name))
    conditions = needs_of_rest(setup, rest)
    evidence = at_equilibrium.at_rest(setup, question.text, rest.values, x, conditions)
    notes = [*_stability(setup, rest), *_as_loads_are(setup)]
    if lies_in_family(model, rest.values, q.measure):
        notes.append(Message("one of a family: free to rest anywhere along {names}", names=q.name))
    return Finding(x, evidence, conditions, notes + _other_rests(setup, q, x, others))


def as_balanced(system: System, question: Question, q: Wanted) -> tuple[System, Question] | None:
    """That a named measure rests at a place that is given, as the same system that starts there at rest and does not
    accelerate: the place is known then, and the equation is one in the parameter. None where something else is to have
    a value."""
    of = q.of
    if not of.is_place_of_rest or q.relation != "=":
        return None
    assert isinstance(of, Equilibrium)
    assert isinstance(q, ValueFor)
    if of.name not in system.measures:
        return None
    there = replace(system, start={of.name: q.target}, start_rates={of.name: ZERO})
    accelerates = replace(q, of=OfMeasure(of.measure, 2, of.name), target=ZERO)
    return there, replace(question, quantity=accelerates, at_start=True, options={}, key=None)


def value(setup: Setup, question: Question, q: RestValue) -> Finding:
    """What a quantity is at rest, at the equilibrium that is meant."""
    from freebody.study.answering import at_equilibrium

    rest = find_equilibrium(setup.model, setup.start)
    state: SymbolicState = StateOfRest(setup.model, rest.values)
    if q.of.is_of_pose_in_motion and setup.model.degrees_of_freedom == 1:  # the pose, passed in the one way there is
        speeds = {c.speed for c in (*setup.model.coordinates, *setup.model.dependent)}
        state = SymbolicState(setup.model, {k: x for k, x in rest.values.items() if k not in speeds})
    element: Elements = q.of.value(setup.system, state)
    conditions = needs_of_rest(setup, rest)
    evidence = at_equilibrium.value_at_rest(setup, question.text, q.of, rest.values, element, conditions)
    return Finding(element, evidence, conditions, _stability(setup, rest))


def value_where_it_starts(setup: Setup, question: Question, q: Quantity) -> Finding | None:
    """What a quantity is in the pose of the start, made in that pose alone, where the loads balance at rest there: it
    stays. None where something moves, or where no instant is asked of."""
    from freebody.study.answering import at_equilibrium

    model = setup.model
    if q.scope != "instant" or not q.is_of_state or depends_on_time(setup.system):
        return None
    at = _still_start(setup)
    if at is None:
        return None
    state = StateOfRest(model, at)
    if not model.reactions.balance_at_rest(state.here):
        return None
    element: Elements = q.value(setup.system, state)
    conditions = needs_of_rest(setup, ClosedFormRest(at))
    evidence = at_equilibrium.value_at_rest(setup, question.text, q, at, element, conditions)
    notes: list[str] = [Message("the loads balance in the pose of the start: it rests there")]
    return Finding(element, evidence, conditions, notes, is_complete=True)


def placed_at(setup: Setup, question: Question) -> System | None:
    """The same system that starts in the pose which the event of a question names, by the one coordinate; None where
    that is something else."""
    system, event = setup.system, question.event
    if not isinstance(event, QuestionEvent) or event.order or len(setup.model.coordinates) != 1:
        return None
    (c,) = setup.model.coordinates
    if c.name not in system.measures or system.measures[c.name] != event.measure or depends_on_time(system):
        return None
    if any(system.start_rates.values()) or system.all_start_rates:
        return None
    return replace(system, start={**system.start, c.name: event.value})


def is_reached(setup: Setup, there: Setup) -> bool:
    """Whether the loops of a system that is placed elsewhere are assembled as motion from the start leads them."""
    (c,) = setup.model.coordinates
    measure = setup.model.measure_of(c)
    assert measure is not None
    for draw in there.draws[:3]:
        begin = Draw.of(setup.system, draw.values)
        reference, q = begin.reference, begin.q
        here, goal = (reference.snapshot(x, 0.0 * x).value(measure) for x in (q, draw.q))
        n = max(1, math.ceil(abs(goal - here) / _STEP))
        for k in range(1, n + 1):
            q = reference.pose_near(q, [(measure, here + (goal - here) * k / n)])
        if float(reference.sizes.relative(reference.frame.difference(q, draw.q)).max(initial=0.0)) > _SAME:
            return False
    return True


def _still_start(setup: Setup) -> dict[int, Ratio] | None:
    """The pose of the start, by generator; None where it is not told, or something moves there."""
    model, start = setup.model, setup.start
    moving = (*model.coordinates, *model.dependent)
    if any(c.speed in start.values and not start.values[c.speed].is_zero() for c in moving):
        return None
    if not all(c.index in start.values for c in model.coordinates):
        return None
    at = {c.index: start.of(c.index) for c in model.coordinates}
    at |= bound_at(model, at, start)
    return at if all(c.index in at for c in moving) else None


def balanced_by_a_load(setup: Setup) -> tuple[System, str] | None:
    """The system with the load of which the size is open as it balances the others in the pose of the start, and what
    is to be said of it; None where no load is open, or none can. Of several the one that is named last: a machine is
    given what goes in, and asked for what comes out."""
    model = setup.model
    if not is_given_pose(setup) or (at := _still_start(setup)) is None:
        return None
    f = model.field
    still = at | {c.speed: f.zero for c in (*model.coordinates, *model.dependent)}
    forces = [model.dynamics.generalized_force(c) for c in model.coordinates]
    forces = [x for x in (f.lowest_terms(f.follow(force, still)) for force in forces) if not x.is_zero()]
    for name in open_loads(setup):
        if (x := balancing_all(setup, forces, name)) is not None:
            size = tidy(x)
            told = Message("in the pose of the start, where {name} balances the other loads", name=name)
            if n_operations(size) <= _MOST_SHOWN:
                told = Message("in the pose of the start, with the balance {x}", x=compared(Symbol(name), "=", size))
            return with_loads(_with_number(setup.system, name, size), {name: size}), told
    return None


def _with_number(system: System, name: str, size: Expr) -> System:
    """The system with the number of a formula for a parameter without a value, where the file gives all it needs."""
    given = {p.name: p.value for p in system.parameters.values() if p.value is not None and p.form is None}
    if free_symbols(size) - given.keys() - {"pi"}:
        return system
    with suppress(ArithmeticError, ValueError):
        number = float(evaluate(size, {"pi": math.pi, **given}, FLOAT_FUNCTIONS))
        valued = replace(system.parameters[name], value=number)
        return replace(system, parameters={**system.parameters, name: valued})
    return system


def is_given_pose(setup: Setup) -> bool:
    """Whether the start is the pose of a machine at rest: no mass moves, or somebody said so of its one freedom."""
    system, model = setup.system, setup.model
    if not model.coordinates or depends_on_time(system) or any(system.all_start_rates.values()):
        return False
    if model.dynamics.moves_no_mass:
        return True
    return len(model.coordinates) == 1 and model.coordinates[0].name in system.start


def open_loads(setup: Setup) -> list[str]:
    """The parameters that are forces or torques of loads and have no value, the last one first."""
    in_loads = {name for push in setup.system.applied_loads for name in free_symbols(push.law)}
    given = setup.system.parameters.values()
    found = [p for p in given if p.value is None and p.form is None and p.name in in_loads]
    return [p.name for p in reversed(found) if p.dimension in (FORCE, TORQUE)]


def balancing(setup: Setup, force: Ratio, name: str) -> Ratio | None:
    """The size of a load with which a generalized force vanishes that is linear in it; None where it is not."""
    f = setup.model.field
    own = f.index(setup.model.parameters[name])
    parts = force.numerator().coefficients(own)
    if len(parts) != 2 or own in f.ingredients(parts[0]) | f.ingredients(parts[1]):
        return None
    return f.lowest_terms(-parts[0] / parts[1])


def balancing_all(setup: Setup, forces: Sequence[Ratio], name: str) -> Ratio | None:
    """The same of several generalized forces, as of pliers that float: one size makes all of them vanish."""
    sizes = list[Ratio]()
    for force in forces:
        if (size := balancing(setup, force, name)) is None or (sizes and not (size - sizes[0]).is_zero()):
            return None
        sizes.append(size)
    return sizes[0] if sizes else None


def _other_rests(setup: Setup, q: Equilibrium, x: Ratio, others: Sequence[ClosedFormRest]) -> list[str]:
    """Where the measure may rest as well, with what that needs."""
    model = setup.model
    notes: list[str] = []
    known = [x]
    for rest in others[:_MOST_RESTS]:
        value = SymbolicState(model, rest.values).value(q.measure)
        is_still = all(value.field.generators[g].kind != "time" for g in value.field.ingredients(value))
        if is_still and all(value != other for other in known):
            known.append(value)
            where = joined(texts([*rest.exists, *(replace(c, purpose="") for c in rest.stable)]))
            shown = to_text(tidy(value))
            if rest.is_stable is False or not where:
                notes.append(reworded(Message("it may rest at {value}, too", value=shown), shown))
            else:
                told = Message("it may rest at {value}, too, stable if {where}", value=shown, where=where)
                notes.append(reworded(told, where))
    return notes


def needs_of_rest(setup: Setup, rest: ClosedFormRest, clear: str = ">=") -> list[Condition]:
    """What an equilibrium needs: that it exists, and that what the formulas take to be positive is so there, what
    is to pull pulls, what is to touch presses, what is open does not reach beyond its limit; about an equilibrium
    that is to swing it has room (clear: >)."""
    mean = {} if swing_of(setup.model) is None else stand_still(setup.model)  # of what swings
    state = StateOfRest(setup.model, rest.values | mean)
    holding = setup.holding(state, with_contacts=bool(setup.system.applied_loads))
    return [*rest.exists, *holding, *setup.clearances(state, clear)]


def _as_loads_are(setup: Setup) -> list[str]:
    """That loads which vary in time otherwise than in one wave are taken as they are at the start."""
    dynamics = setup.model.dynamics
    varies = any(timed_in(setup.model, x) for x in (*dynamics.forcing_near_rest, *dynamics.parts_of_inertia))
    told = Message("with the loads as they are at t = 0: they vary with time, and where they balance, too")
    return [told] if varies and swing_of(setup.model) is None else []


def _stability(setup: Setup, rest: ClosedFormRest) -> list[str]:
    """What is to be said of it, with the condition where there is one."""
    if rest.is_stable is None:
        return [Message("whether this equilibrium is stable does not follow from the linearised equations")]
    where = joined(texts([replace(c, purpose="") for c in rest.stable]))
    if rest.neutral and rest.is_stable and not where:
        return [
            Message("apart from {names}, along which equilibria go on, it is stable", names=", ".join(rest.neutral))
        ]
    if not where:
        return [] if rest.is_stable else [Message("this equilibrium is not stable")]
    if not setup.has_values:
        return [reworded(Message("this equilibrium is stable if {condition}", condition=where), where)]
    verdict = (
        Message("this equilibrium is stable if {condition}: with the given numbers it is stable", condition=where)
        if rest.is_stable
        else Message(
            "this equilibrium is stable if {condition}: with the given numbers it is not stable", condition=where
        )
    )
    return [reworded(verdict, where)]
