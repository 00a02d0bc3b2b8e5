"""A law of the user's own: a named measure pushed by an expression."""

from __future__ import annotations

import random
from typing import TYPE_CHECKING, Any

from freebody.errors import ExpressionError, InputError
from freebody.language.expression import (
    ZERO,
    Expr,
    differentiate,
    evaluate,
    free_symbols,
    replace_rates,
    substitute,
)
from freebody.language.units import DIMENSIONLESS, FORCE, TIME, TORQUE, Dimension
from freebody.loads.base import Load
from freebody.measures.base import Measure
from freebody.measures.combination import Composed
from freebody.model.elements import RATE, VALUE, Push
from freebody.model.spec import Formula

if TYPE_CHECKING:
    from freebody.model.names import Names

Used = tuple[tuple[str, Measure], ...]


def law(names: Names, value: Any, dimension: Dimension, *path: str | int) -> tuple[Expr, Used]:
    """An expression in parameters, time `t`, named measures and their rates."""
    extra = {"t": TIME} | {n: m.dimension for n, m in names.measures.items()}
    expr = names.formula(value, dimension, *path, extra=extra)
    return expr, tuple((n, names.measures[n]) for n in sorted(free_symbols(expr) & set(names.measures)))


class Law(Load, kind="law"):
    """`law: {measure: stretch, force: -k*stretch^3}`: the force (or torque, for an angle) in the direction in
    which the measure grows, as an expression in measures, their rates (`rate(x)`) and time `t`."""

    measure: str | dict[str, Any]
    force: Formula

    stores_energy = True
    example = """
bodies: {ball: {particle: {mass: 1 kg}}}
measures: {x: x of ball}
parameters: {k: 5 N/m^3}
loads: {it: {law: {measure: x, force: -k*x^3}}}
"""

    def pushes(self, names: Names) -> list[Push]:
        measure = names.measure(self.measure, "measure")
        if measure is None:
            return []
        dimension = TORQUE if measure.dimension == DIMENSIONLESS else FORCE
        expr, used = law(names, self.force, dimension, "force")
        own = [name for name, other in used if other == measure]
        for name in own:  # the law of the measure itself, not of another one
            expr = substitute(replace_rates(expr, {name: RATE}), {name: VALUE})
        rest = tuple(item for item in used if item[0] not in own)
        alone = _in_the_measure(expr, measure, [name for name, _measure in rest])
        return [Push("", measure, expr, rest) if alone is None else Push("", measure, alone)]


def _in_the_measure(expr: Expr, measure: Measure, used: list[str]) -> Expr | None:
    """A law in several measures that contains them only as its own measure is made of them: k*(x2 - x1) as a law of
    x2 - x1. None where it is not of that form."""
    if not used or not isinstance(measure, Composed) or replace_rates(expr, dict.fromkeys(used, RATE)) != expr:
        return None
    for name in used:
        slope = differentiate(measure.expression, name)
        if free_symbols(slope) & set(used) or slope == ZERO:
            continue
        try:
            offset = substitute(measure.expression, {name: ZERO})
            turned = substitute(expr, {name: (VALUE - offset) / slope})
            if all(_is_free_of(turned, other) for other in used):
                return substitute(turned, dict.fromkeys(used, ZERO))
        except (ZeroDivisionError, ExpressionError):
            continue
    return None


def _is_free_of(expr: Expr, name: str) -> bool:
    """Whether the derivative by a name is zero at random numbers."""
    slope = differentiate(expr, name)
    rng = random.Random(3)
    for _ in range(5):
        values = {symbol: rng.uniform(0.3, 1.7) for symbol in free_symbols(expr) | {name}}
        try:
            if abs(float(evaluate(slope, values))) > 1e-9:
                return False
        except (ValueError, ArithmeticError, InputError):
            return False
    return True
