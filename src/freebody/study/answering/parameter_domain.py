"""Where a parameter may be, as conditions on a value for it."""

from __future__ import annotations

import math
import re
from fractions import Fraction

from freebody.language.sentences import Message
from freebody.model.elements import Parameter
from freebody.symbolic.conditions import Condition
from freebody.symbolic.functions import functions
from freebody.symbolic.ratio import Ratio
from freebody.system.system import System
from freebody.tolerances import ROUND_OFF

_ARCS = {  # the ranges of their values, in half turns
    "asin": (Fraction(-1, 2), Fraction(1, 2)),
    "acos": (Fraction(0), Fraction(1)),
    "atan": (Fraction(-1, 2), Fraction(1, 2)),
}
_RISING = ("asin", "atan", "log")


def domain_of(parameter: Parameter, value: Ratio) -> list[Condition]:
    """What the parameter is said to be."""
    found, name = list[Condition](), parameter.name
    if parameter.sign == "positive":
        found.append(Condition(above(value), ">", Message("{name} is positive", name=name)))
    elif parameter.sign == "nonnegative":
        found.append(Condition(value, ">=", Message("{name} is not negative", name=name)))
    if parameter.acute:
        below = above(value.field.pi / 2 - value)
        found.append(Condition(below, ">", Message("{name} is less than a right angle", name=name)))
    if parameter.is_share:
        found.append(Condition(1 - value, ">=", Message("{name} is at most 1", name=name)))
    return found


def above(x: Ratio) -> Ratio:
    """What has the sign of x: of a root's multiple without the root, of an arc function and a share of pi something of
    its argument alone."""
    field = x.field
    for g in x.generators():
        if field.generators[g].kind == "root" and x.numerator().coefficients(g)[0].is_zero():
            return field.lowest_terms(x * field.variable(g))  # the root is not negative
    arcs = [g for g in x.generators() if field.arguments.get(g, ("", x))[0] in _ARCS]
    if len(arcs) != 1 or x.denominator().generators():
        return x
    (rest, slope, *more), (name, argument) = x.coefficients(arcs[0]), field.arguments[arcs[0]]
    turns, factor = (rest / field.pi).fraction(), slope.fraction()
    if more or turns is None or factor is None:
        return x
    # factor arc + turns pi > 0: the arc lies above its value at 0, or below it
    edge, (low, high) = -turns / factor, _ARCS[name]
    if not (low <= edge <= high if name != "atan" else low < edge < high):
        return field.element(1 if (factor > 0) == (edge <= low) else -1)
    fn = functions(field)
    wave = {"asin": "sin", "acos": "cos", "atan": "tan"}[name]
    beyond = argument - fn[wave](edge.numerator * field.pi / edge.denominator)
    return beyond if (factor > 0) == (name != "acos") else -beyond


def after(a: Ratio, b: Ratio) -> Ratio:
    """What has the sign of b - a: of two arcs the difference of what they are arcs of."""
    f = a.field
    arcs = [
        next((f.arguments[g] for g in x.generators() if g in f.arguments and x == f.variable(g)), None) for x in (a, b)
    ]
    if arcs[0] is not None and arcs[1] is not None and arcs[0][0] == arcs[1][0] and arcs[0][0] in _RISING:
        return above(f.lowest_terms(arcs[1][1] - arcs[0][1]))
    return above(f.lowest_terms(b - a))


def for_every(system: System, parameter: Parameter, asked: str) -> str:
    """That something is so wherever a parameter may be, or that the model has no such parameter but by name, nor what
    is asked (when theta = beta)."""
    name = parameter.name
    model = {
        key: value for key, value in system.document.data.items() if key not in ("parameters", "questions", "title")
    }
    said = re.compile(rf"\b{re.escape(name)}\b")
    if not said.search(str(model)) and len(said.findall(asked)) <= 1:
        return Message(
            "nothing in the model depends on {name}: write it where it belongs, as a coefficient of friction in a "
            "contact",
            name=name,
        )
    if parameter.acute:
        return Message("that is so for every acute angle {name}", name=name)
    if parameter.is_share:
        return Message("that is so for every value of {name} up to 1", name=name)
    if parameter.sign == "positive":
        return Message("that is so for every positive value of {name}", name=name)
    return Message("that is so for every value of {name}", name=name)


def is_within(parameter: Parameter, number: float) -> bool:
    if parameter.acute and not 0.0 < number < math.pi / 2:
        return False
    if parameter.is_share and number > 1.0 + ROUND_OFF:
        return False
    return number > 0.0 or (number == 0.0 and parameter.sign == "nonnegative") or parameter.sign == "any"
