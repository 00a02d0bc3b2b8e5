"""Extremes of a quantity that follows one measure, a + b s, where s is a sum of coordinates that moves by a law of its
own: the force in a spring between two bodies that both move.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from freebody.errors import CannotAnswer, NeverHappens
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.questions.base import Quantity
from freebody.study.answering.crosscheck import MOTION_TOLERANCE, CrossCheck, broken
from freebody.study.answering.draws import Draw
from freebody.study.answering.finding import Finding, NotHere
from freebody.study.answering.motion_values import extremes_over_cycle
from freebody.study.answering.repeated import checked, held_throughout
from freebody.study.setup import Setup
from freebody.symbolic.conditions import Condition, insisted
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign, sign_of


@dataclass(frozen=True)
class FollowedMeasure:
    """What a quantity follows: quantity = rest + slope * measure, slope and rest being constant."""

    measure: Measure
    name: str
    rest: Ratio
    slope: Ratio


def measure_followed(setup: Setup, of: Quantity) -> FollowedMeasure | None:
    """The named measure in several coordinates on which alone, and linearly, a quantity of the state depends."""
    model, f = setup.model, setup.model.field
    value = of.value(setup.system, setup.state)
    if isinstance(value, tuple):
        return None
    x = f.lowest_terms(model.in_independent_speeds(f.element(value)))
    if any(c.speed in f.ingredients(x) for c in model.coordinates):
        return None
    for name, measure in setup.system.measures.items():
        s = model.value_of(measure)
        inside = [c for c in model.coordinates if c.index in f.ingredients(s)]
        if len(inside) < 2:
            continue
        rise = f.partial(s, inside[0].index)
        if rise.is_zero():  # a distance: it is a root of them
            continue
        slope = f.lowest_terms(f.partial(x, inside[0].index) / rise)
        rest = f.lowest_terms(x - slope * s)
        if not slope.is_zero() and slope.is_constant() and rest.is_constant():
            return FollowedMeasure(measure, name, rest, slope)
    return None


def find(setup: Setup, question: str, of: Quantity, followed: FollowedMeasure, sides: Sequence[int]) -> Finding:
    """The closed form. sides: -1 for the least value, +1 for the greatest, in the order in which they are wanted.
    Raises CannotAnswer where the sign of the slope is open, or the motion does not come back."""
    f, rises = setup.model.field, sign_of(followed.slope)
    if not rises.is_strict:
        raise CannotAnswer(Message("which way the measure grows depends on the parameter values"))
    value, up = setup.model.value_of(followed.measure), 1 if rises is Sign.POSITIVE else -1
    found = [setup.motion.extent_of_sum(value, followed.name, up * side) for side in sides]
    values = tuple(f.lowest_terms(followed.rest + followed.slope * reached.at) for reached in found)
    never = NeverHappens(Message("it does not turn"))
    needs = (Condition(x, r, Message("it turns")) for reached in found for x, r in reached.conditions)
    conditions = [*insisted(needs, never), *held_throughout(setup)]

    def numbers(draw: Draw) -> tuple[float, ...]:
        low, high = extremes_over_cycle(setup, draw, followed.measure, of)
        return tuple(low if side < 0 else high for side in sides)

    check = CrossCheck(question, Message("numerical integration over a cycle of the motion"), MOTION_TOLERANCE)
    evidence = checked(setup, check, values, conditions, numbers)
    if evidence is None:
        needs = ", ".join(broken(setup, conditions))
        raise NotHere(Message("the motion is another one at the model's own values: that needs {x}", x=needs))
    return Finding(values if len(values) > 1 else next(iter(values)), evidence, conditions)
