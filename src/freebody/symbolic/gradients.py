"""Derivatives of closed forms by parameters, exact and in lowest terms.

In a field of its own the parameter runs evenly, as time does: its rate is one, and that of everything else follows from
it by the chain rule, so that the rate of the formula is its derivative.
"""

from __future__ import annotations

from collections.abc import Mapping

from freebody.errors import CannotAnswer, ExpressionError
from freebody.language.expression import Expr, differentiate, free_symbols
from freebody.language.sentences import Message
from freebody.model.elements import Parameter
from freebody.symbolic.functions import element
from freebody.symbolic.signed_field import SignedField
from freebody.symbolic.tidy import tidy


def derivative(expr: Expr, by: str, parameters: Mapping[str, Parameter]) -> Expr:
    """d(expr)/d(by). parameters: the names in it, with their signs. Raises CannotAnswer where there is none."""
    try:
        return _in_field(expr, by, parameters)
    except (CannotAnswer, ExpressionError, ArithmeticError, KeyError, ValueError):
        pass  # an exponent that is a parameter, say: by the rules for the tree then
    try:
        return differentiate(expr, by)
    except (ExpressionError, KeyError) as error:
        raise CannotAnswer(Message("the derivative by {name} has no closed form here", name=by)) from error


def _in_field(expr: Expr, by: str, parameters: Mapping[str, Parameter]) -> Expr:
    field = SignedField()
    values = {"pi": field.pi}
    for name in sorted(free_symbols(expr) - {"pi"}):
        parameter = parameters[name]
        values[name] = field.parameter(name, positive=parameter.sign == "positive")
        if parameter.acute:
            field.acute_angles.add(field.index(values[name]))
    if by not in values:
        return tidy(field.zero)
    field.set_rate(values[by], field.one)
    return tidy(field.lowest_terms(field.rate(element(field, expr, values))))
