"""Angles that closed loops bind, put into a formula where the pose is known and the formula stays readable.

Otherwise the answer keeps them, beside the equations of the loop.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction

from freebody.errors import CannotAnswer
from freebody.language.expression import ZERO, Expr, Symbol, children, number
from freebody.language.notation import compared, joined, reworded
from freebody.language.sentences import Message
from freebody.present.lines import number_text, symbol_text
from freebody.study.answering.chain import loop_angles
from freebody.study.answering.finding import Elements
from freebody.study.answering.named_formulas import Chain
from freebody.study.eom import primitive_part
from freebody.study.setup import Setup
from freebody.symbolic.closure import Closure
from freebody.symbolic.loop_angles import LoopAngles
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign, sign_of
from freebody.symbolic.state import SymbolicState
from freebody.symbolic.tidy import tidy

READABLE = 60  # operations and symbols of a formula that is read at a glance
_MOST_TERMS = 200  # multiplied out: no form of so many is read at a glance
SHORT = 12  # operations of a condition in which the angles of loops are put in
_LONGEST = 120  # of an angle that a loop binds, as a formula of its own
_LONGER = 1.25  # times as long as with the bound angles a formula may become in any case


def length(element: Elements) -> int:
    """How long a formula is as it is shown: its operations and symbols."""
    return sum(_size(tidy(part)) for part in (element if isinstance(element, tuple) else (element,)))


def n_terms(element: Elements) -> int:
    """How many terms there are, multiplied out."""
    return sum(part.n_terms for part in (element if isinstance(element, tuple) else (element,)))


def _size(e: Expr) -> int:
    return 1 + sum(map(_size, children(e)))


def bound_in(setup: Setup, element: Elements) -> bool:
    """Whether a formula contains coordinates that loops bind."""
    bound = {d.index for d in setup.model.dependent}
    parts = element if isinstance(element, tuple) else (element,)
    return any(setup.model.field.ingredients(part) & bound for part in parts)


def solved(setup: Setup, element: Elements, state: SymbolicState) -> tuple[Elements, list[str], list[Ratio]] | None:
    """A formula with the angles that loops bind in the pose of a state, on which branch that is, and what is positive
    on it; None where the loops have no short solution, or the formula becomes too long."""
    if not setup.model.loops or not bound_in(setup, element):
        return None
    closure, whole = Closure(setup.model), without_bound_rates(setup, element, state)
    try:
        values = closure.at(state.values)
        for form in (whole, element):  # else rates that loops bind are told beside it
            found = _followed(form, values)
            if (
                not bound_in(setup, found)
                and length(found) <= _longest(setup, element)
                and n_terms(found) <= _MOST_TERMS
            ):
                rates = [] if form is whole else _rates(setup, found, state, values)
                return None if rates is None else (found, [*branch(closure.sides), *rates], closure.sides)
    except (CannotAnswer, ZeroDivisionError):
        pass
    return None


def _longest(setup: Setup, element: Elements) -> float:
    """How long a formula may become in which the angles of loops are put."""
    angles = (setup.model.field.variable(d.index) for d in setup.model.dependent)
    is_angle = isinstance(element, Ratio) and any(element == angle for angle in angles)
    return _LONGEST if is_angle else max(READABLE, _LONGER * length(element))


def _rates(setup: Setup, element: Elements, state: SymbolicState, values: dict[int, Ratio]) -> list[str] | None:
    """What the rates in it are that loops bind; None where one of them is long."""
    model, told = setup.model, list[str]()
    parts = element if isinstance(element, tuple) else (element,)
    inside = set[int]().union(*map(model.field.ingredients, parts))
    for speed in (d.speed for d in model.dependent if d.speed in inside):
        own = model.field.variable(speed)
        rate = _followed(without_bound_rates(setup, own, state), values)
        assert isinstance(rate, Ratio)
        if length(rate) > _LONGEST or rate == own:
            return None
        told.append(compared(tidy(own), "=", tidy(rate)))
    return [reworded(Message("with {zero}", zero=x), x) for x in told]


def without_bound_rates(setup: Setup, element: Elements, state: SymbolicState) -> Elements:
    """With the rates of what loops bind by those of the coordinates, or of drives."""
    model = setup.model
    rates = {d.speed for d in model.dependent}

    def by_free(x: Ratio) -> Ratio:
        return state.here(model.in_independent_speeds(x)) if rates & model.field.ingredients(x) else x

    return tuple(map(by_free, element)) if isinstance(element, tuple) else by_free(element)


def _followed(element: Elements, values: dict[int, Ratio]) -> Elements:
    if isinstance(element, tuple):
        return tuple(part.field.lowest_terms(part.field.follow(part, values)) for part in element)
    return element.field.lowest_terms(element.field.follow(element, values))


def branch(sides: Sequence[Ratio]) -> list[str]:
    """How the loops are assembled, as a note. sides: what is positive then."""
    if not sides:
        return []
    told = joined(map(_positive, sides))
    return [reworded(Message("as it is assembled: {condition}", condition=told), told)]


def _positive(x: Ratio) -> str:
    """That an element is positive, without factors whose signs are known."""
    short = primitive_part(x)
    front = sign_of(x / short)
    if not front.is_strict:
        return compared(tidy(x), ">", ZERO)
    return compared(tidy(short), ">" if front is Sign.POSITIVE else "<", ZERO)


def loops_in(setup: Setup, element: Elements, state: SymbolicState | None, chain: Chain | None = None) -> list[str]:
    """Where an answer contains coordinates that closed loops bind: what they are in the pose of a state; or the
    equations of the loops, where they have no short solution, or where a chain has it."""
    told = [] if chain is None else loop_angles(setup, chain)
    if not bound_in(setup, element) and not told:
        return []
    model, closure = setup.model, Closure(setup.model)
    if told:
        LoopAngles(closure)
        numbers = ", ".join(f"{symbol_text(name)} = {number_text(math.degrees(x))}°" for name, x in told)
        values = joined(compared(Symbol(name), "=", number(Fraction(f"{x:.6g}"))) for name, x in told)
        numeric = reworded(Message("with the given numbers: {case}", case=numbers), values)
        return [*_equations(setup), *branch(closure.sides), numeric]
    found = None if state is None else angles(setup, element, state, closure)
    if found is None:
        return _equations(setup)
    formulas = [compared(tidy(model.field.variable(d)), "=", tidy(value)) for d, value in found.items()]
    rates = [] if state is None else _rates(setup, element, state, {}) or []
    return [*(reworded(Message("with {zero}", zero=x), x) for x in formulas), *rates, *branch(closure.sides)]


def _equations(setup: Setup) -> list[str]:
    """Those of the loops in which something moves: the length of a rope that stands still is no equation of a pose."""
    model = setup.model
    moving = [loop.value for loop in model.loops if model.field.ingredients(loop.value) & model.moving]
    zeros = [compared(ZERO, "=", tidy(primitive_part(value))) for value in moving]
    return [reworded(Message("with {zero}", zero=zero), zero) for zero in zeros]


def angles(setup: Setup, element: Elements, state: SymbolicState, closure: Closure) -> dict[int, Ratio] | None:
    """The bound angles of an element as formulas, by generator; None where one of them has no short one."""
    try:
        values = closure.at(state.values)
    except (CannotAnswer, ZeroDivisionError):
        return None
    parts = element if isinstance(element, tuple) else (element,)
    inside = set[int]().union(*map(setup.model.field.ingredients, parts))
    bound = [d.index for d in setup.model.dependent if d.index in inside]
    for index in bound:
        if index not in values or bound_in(setup, values[index]) or length(values[index]) > _LONGEST:
            return None
    return {index: values[index] for index in bound}
