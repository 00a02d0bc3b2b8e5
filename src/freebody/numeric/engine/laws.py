"""What is known of the law of a load before the motion."""

from __future__ import annotations

from collections.abc import Mapping

from freebody.language.expression import ZERO, Expr, differentiate, free_symbols, has_jump, substitute
from freebody.model.elements import RATE, VALUE, AppliedLoad, NonholonomicForm
from freebody.numeric.engine.tapes import constant_value


def linear_law(law: Expr, values: Mapping[str, float]) -> tuple[float, float, float] | None:
    """(c0, c1, c2) of a law c0 + c1 value + c2 rate; None for any other."""
    names = free_symbols(law) - values.keys() - {"pi"}
    if not names <= {VALUE.name, RATE.name} or has_jump(law, names):
        return None
    c1, c2 = differentiate(law, VALUE.name), differentiate(law, RATE.name)
    if (free_symbols(c1) | free_symbols(c2)) & {VALUE.name, RATE.name}:
        return None
    c0 = substitute(law, {VALUE.name: ZERO, RATE.name: ZERO})
    found = [constant_value(c, values) for c in (c0, c1, c2)]
    a, b, c = found
    return None if a is None or b is None or c is None else (a, b, c)


def stored_law(load: AppliedLoad, values: Mapping[str, float]) -> tuple[float, float] | None:
    """(c0, c1) of a load whose law is c0 + c1 value, so that its energy is stored; None for others, whose work is
    integrated with the motion."""
    linear = linear_law(load.law, values)
    if linear is None or linear[2] != 0.0 or isinstance(load.measure, NonholonomicForm):
        return None
    return linear[:2]
