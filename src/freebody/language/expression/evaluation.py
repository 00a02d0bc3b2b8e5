"""The value of an expression, in whatever arithmetic its names have values of: floats, jets, balls, field
elements. One walk over the tree serves them all."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any, TypeVar

from freebody.errors import ExpressionError
from freebody.language.expression.elliptic import elliptic_F, elliptic_K
from freebody.language.expression.fresnel import fresnel_c, fresnel_s
from freebody.language.expression.lambert import lambert_W0, lambert_Wm1
from freebody.language.expression.tree import (
    ELEMENTARY,
    PLACE,
    Call,
    Expr,
    GivenCall,
    Number,
    PowerOf,
    ProductOf,
    Sum,
    Symbol,
    children,
    whole_exponent,
)
from freebody.messages import Message

T = TypeVar("T")
_COMPUTED = "computed so far"  # no name of a function


def _sign(x: float) -> float:
    return float((x > 0) - (x < 0))


FLOAT_FUNCTIONS: Mapping[str, Any] = {
    **{name: getattr(math, name) for name in ELEMENTARY},
    "fresnel_c": fresnel_c,
    "fresnel_s": fresnel_s,
    "elliptic_K": elliptic_K,
    "elliptic_F": elliptic_F,
    "lambert_W0": lambert_W0,
    "lambert_Wm1": lambert_Wm1,
    "abs": abs,
    "sign": _sign,
    "pi": math.pi,
    "number": float,
}


def evaluate(expr: Expr, values: Mapping[str, T], functions: Mapping[str, Any] | None = None) -> T:
    """The value in the arithmetic of `values`: floats, or whatever `functions` are made for.

    `functions` maps function names to callables, "pi" to its value and "number" to the conversion of a
    Fraction; without the last two pi and numbers are floats. A rate is looked up in `values` as "rate(x)",
    then asked of functions["rate"]. Integer powers are taken by `**int`, negative ones by division.

    Raises ExpressionError naming a symbol or function without a value; ValueError or ArithmeticError
    where the mathematics is undefined, as sqrt(-1) or 1/0 in floats.
    """
    return _evaluate(expr, values, FLOAT_FUNCTIONS if functions is None else functions)


def evaluate_sharing(expr: Expr, values: Mapping[str, T], functions: Mapping[str, Any]) -> T:
    """As `evaluate`, with each function of an expression computed once: in formulas that are made from elements of the
    field the same node stands wherever it is meant, in many terms and nested."""
    computed: dict[int, T] = {}
    return _evaluate(expr, values, {**functions, _COMPUTED: computed})


# this is what most programs do most of the time: classes are asked for one by one, as patterns take twice as long
def _evaluate(expr: Expr, values: Mapping[str, Any], functions: Mapping[str, Any]) -> Any:
    if isinstance(expr, Symbol):
        return _named(expr.name, values, functions)
    if isinstance(expr, Number):
        return functions.get("number", float)(expr.value)
    if isinstance(expr, ProductOf):
        return _evaluate_product(expr.factors, values, functions)
    if isinstance(expr, PowerOf):
        return _evaluate_power(expr, expr.base, expr.exponent, values, functions)
    if isinstance(expr, Sum):
        total = _evaluate(expr.terms[0], values, functions)
        for term in expr.terms[1:]:
            total = total + _evaluate(term, values, functions)
        return total
    return _evaluate_call(expr, values, functions)


def _named(name: str, values: Mapping[str, Any], functions: Mapping[str, Any]) -> Any:
    if name == "pi":
        return functions.get("pi", math.pi)
    if name not in values:
        raise ExpressionError(Message("'{name}' has no value; known are {values}", name=name, values=_listed(values)))
    return values[name]


def _evaluate_product(factors: Sequence[Expr], values: Mapping[str, Any], functions: Mapping[str, Any]) -> Any:
    result = None
    for factor in factors:
        if isinstance(factor, PowerOf) and (n := whole_exponent(factor)) is not None and n < 0:
            below = _whole_power(_evaluate(factor.base, values, functions), -n)
            above = functions.get("number", float)(Fraction(1)) if result is None else result
            result = above / below
        else:
            value = _evaluate(factor, values, functions)
            result = value if result is None else result * value
    return result


def _evaluate_call(expr: Call, values: Mapping[str, Any], functions: Mapping[str, Any]) -> Any:
    if expr.function == "rate":
        key = rate_key(expr)
        if key in values:
            return values[key]
        if "rate" not in functions:
            raise ExpressionError(
                Message("{key} has no value here; known are {values}", key=key, values=_listed(values))
            )
        return functions["rate"](_evaluate(expr.argument, values, functions))
    computed = functions.get(_COMPUTED)
    if computed is None:
        return _evaluate_function(expr, values, functions)
    key = id(expr)  # the expression lives as long as this
    if key not in computed:
        computed[key] = _evaluate_function(expr, values, functions)
    return computed[key]


def _evaluate_function(expr: Call, values: Mapping[str, Any], functions: Mapping[str, Any]) -> Any:
    if isinstance(expr, GivenCall):
        place = _evaluate(expr.argument, values, functions)
        if "given" in functions:
            return functions["given"](expr, place)
        return value_of_given(expr, place, functions)
    if expr.function not in functions:
        raise ExpressionError(
            Message("the function {function} is not known to this arithmetic", function=expr.function)
        )
    return functions[expr.function](*(_evaluate(x, values, functions) for x in children(expr)))


def value_of_given(call: GivenCall, argument: Any, functions: Mapping[str, Any]) -> Any:
    """A function that is given in numbers, by its form."""
    if functions.get(_COMPUTED) is not None:  # the form is one node, whatever its place is
        functions = {name: f for name, f in functions.items() if name != _COMPUTED}
    place = _evaluate(call.place, {PLACE.name: argument}, functions)
    return _evaluate(call.forms[0], {PLACE.name: place}, functions)


def _evaluate_power(
    expr: PowerOf, base: Expr, exponent: Expr, values: Mapping[str, Any], functions: Mapping[str, Any]
) -> Any:
    below = _evaluate(base, values, functions)
    n = whole_exponent(expr)
    if n is not None and n > 0:
        return _whole_power(below, n)
    if n is not None:
        return functions.get("number", float)(Fraction(1)) / _whole_power(below, -n)
    result = below ** _evaluate(exponent, values, functions)
    if isinstance(result, complex) and isinstance(below, float):
        raise ValueError(f"{below} has no real power with a broken exponent")
    return result


def _whole_power(base: Any, n: int) -> Any:
    return base if n == 1 else base**n


def rate_key(expr: Expr) -> str:
    """The name under which `evaluate` looks up a rate: "rate(x)", "rate(rate(x))"."""
    match expr:
        case Symbol(name):
            return name
        case Call("rate", argument):
            return f"rate({rate_key(argument)})"
        case _:
            raise ExpressionError(Message("rate(...) takes the name of a measure"))


def _listed(values: Mapping[str, Any]) -> str:
    names = sorted(values)
    return ", ".join(names[:12]) + (", ..." if len(names) > 12 else "") if names else "no names at all"
