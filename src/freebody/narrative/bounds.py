"""Conditions in which one name stands beside numbers alone: what it is compared with, as a number with its unit."""

from __future__ import annotations

from collections.abc import Mapping

from freebody.errors import ExpressionError
from freebody.language.expression import FLOAT_FUNCTIONS, ZERO, Expr, Symbol, evaluate, free_symbols
from freebody.language.notation import Stated
from freebody.language.raising import raised
from freebody.language.sentences import Argument, Message, Sentence
from freebody.language.units import DIMENSIONLESS, Dimension
from freebody.narrative.context import Context
from freebody.narrative.lines.glossary import unit_of_rate
from freebody.narrative.lines.script import ready
from freebody.tolerances import ROUND_OFF

_TURNED = {">": "<", "≥": "≤", "<": ">", "≤": "≥"}


def with_unit(context: Context, condition: str) -> Argument:
    """The condition as it is told: 25 F sin 20° ≤ 981 as F ≤ 114.7 N, anything else as it stands."""
    words = condition.words if isinstance(condition, Stated) else condition
    inner = words.arguments.get("condition") if isinstance(words, Message) else condition
    bound = _bound(context, inner) if isinstance(inner, Stated) else None
    if bound is None:
        return ready(condition)
    if isinstance(words, Message):
        return Sentence("result.bound_for", {"bound": bound, "purposes": ready(str(words.arguments["purposes"]))})
    return bound


def _bound(context: Context, condition: Stated) -> Sentence | None:
    if condition.sides is None or condition.sides[1] not in _TURNED:
        return None
    left, relation, right = condition.sides
    names = sorted((free_symbols(left) | free_symbols(right)) - {"pi"})
    dimensions = _dimensions(context)
    if len(names) != 1 or dimensions.get(names[0], DIMENSIONLESS) == DIMENSIONLESS:
        return None
    (name,) = names
    try:
        at = [_number(left, name, x) - _number(right, name, x) for x in (0.0, 1.0, 2.0)]
    except (ExpressionError, ArithmeticError, ValueError):
        return None
    slope = at[1] - at[0]
    if slope == 0.0 or abs(at[2] - at[1] - slope) > ROUND_OFF * max(map(abs, at)):
        return None
    sign = relation if slope > 0 else _TURNED[relation]
    unit, end = raised(str(dimensions[name])), -at[0] / slope + 0.0  # no -0
    return Sentence("result.bound", {"name": Symbol(name), "sign": f"@{sign}", "value": f"@{end:.4g} {unit}"})


def _number(e: Expr, name: str, x: float) -> float:
    return float(evaluate(e, {name: x}, FLOAT_FUNCTIONS))


def _dimensions(context: Context) -> Mapping[str, Dimension]:
    system = context.system
    found = {p.name: p.dimension for p in system.parameters.values()}
    return found | {name: measure.dimension for name, measure in system.measures.items()}


def number_with_unit(value: Expr, dimension: Dimension, order: int = 0) -> Argument:
    """A value of a measure, or of its rate of an order: a formula as it stands, a number with its unit in SI; an angle
    has none."""
    if free_symbols(value) or value == ZERO or (dimension == DIMENSIONLESS and not order):
        return value
    unit = unit_of_rate(dimension, order)
    return Sentence("result.number", {"value": f"@{float(evaluate(value, {})):.6g}", "unit": f"@{unit}"})
