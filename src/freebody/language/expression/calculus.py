"""Trees from trees: other expressions put in for names, and partial derivatives.

    (f + g)' = f' + g'        (f g)' = f' g + f g'        (f(u))' = f'(u) u'
    (b^e)'   = e b^(e-1) b' + b^e log(b) e'

Nothing is tidied beyond what `add`, `multiply` and `power` do.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from freebody.errors import ExpressionError
from freebody.language.expression.inspection import free_symbols
from freebody.language.expression.tree import (
    ELLIPTIC,
    LAMBERT,
    MINUS_ONE,
    ONE,
    PI,
    ZERO,
    Call,
    Expr,
    GivenCall,
    Number,
    PowerOf,
    ProductOf,
    Sum,
    Symbol,
    add,
    children,
    multiply,
    power,
)
from freebody.messages import Message


def substitute(expr: Expr, replacements: Mapping[str, Expr]) -> Expr:
    """The expression with all replacements made at once; the rate of a number is 0.

    Raises ExpressionError when anything but a symbol or a number would have to stand inside rate(...).
    """
    match expr:
        case Number():
            return expr
        case Symbol(name):
            return replacements.get(name, expr)
        case Sum(terms):
            return add(*[substitute(term, replacements) for term in terms])
        case ProductOf(factors):
            return multiply(*[substitute(factor, replacements) for factor in factors])
        case PowerOf(base, exponent):
            return power(substitute(base, replacements), substitute(exponent, replacements))
        case Call("rate", argument):
            inner = substitute(argument, replacements)
            if isinstance(inner, Number):
                return ZERO
            if isinstance(inner, Symbol) or (isinstance(inner, Call) and inner.function == "rate"):
                return Call("rate", inner)
            names = ", ".join(sorted(free_symbols(argument)))
            raise ExpressionError(
                Message("{names} is in rate(...), where only a name or a number can replace it", names=names)
            )
        case Call():
            return expr.of(lambda x: substitute(x, replacements))


def differentiate(expr: Expr, name: str) -> Expr:
    """The partial derivative; rate(x) does not depend on x."""
    match expr:
        case Number():
            return ZERO
        case Symbol(other):
            return ONE if other == name else ZERO
        case Sum(terms):
            return add(*[differentiate(term, name) for term in terms])
        case ProductOf(factors):
            changes = [differentiate(factor, name) for factor in factors]
            return add(
                *[
                    multiply(*factors[:i], change, *factors[i + 1 :])
                    for i, change in enumerate(changes)
                    if change != ZERO
                ]
            )
        case PowerOf(base, exponent):
            return _differentiate_power(base, exponent, name)
        case Call(function) if function in ELLIPTIC:
            if all(differentiate(x, name) == ZERO for x in children(expr)):
                return ZERO
            raise ExpressionError(Message("elliptic integrals are not differentiated here"))
        case GivenCall(argument=argument):
            change, slope = differentiate(argument, name), expr.derivative()
            return ZERO if change == ZERO or slope is None else multiply(slope, change)
        case Call(function, argument):
            change = ZERO if function == "rate" else differentiate(argument, name)
            return ZERO if change == ZERO else multiply(_DERIVATIVES[function](argument), change)


def _differentiate_power(base: Expr, exponent: Expr, name: str) -> Expr:
    # (b^e)' = e b^(e-1) b' + b^e log(b) e'
    of_base, of_exponent = differentiate(base, name), differentiate(exponent, name)
    terms: list[Expr] = []
    if of_base != ZERO:
        terms.append(multiply(exponent, power(base, add(exponent, MINUS_ONE)), of_base))
    if of_exponent != ZERO:
        terms.append(multiply(PowerOf(base, exponent), Call("log", base), of_exponent))
    return add(*terms)


def _of_lambert(name: str) -> Callable[[Expr], Expr]:
    """W' = W/(u (1 + W))."""
    return lambda u: Call(name, u) / (u * (1 + Call(name, u)))


_DERIVATIVES: Mapping[str, Callable[[Expr], Expr]] = {
    "sqrt": lambda u: 1 / (2 * Call("sqrt", u)),
    "sin": lambda u: Call("cos", u),
    "cos": lambda u: -Call("sin", u),
    "tan": lambda u: 1 + Call("tan", u) ** 2,
    "asin": lambda u: 1 / Call("sqrt", 1 - u**2),
    "acos": lambda u: -1 / Call("sqrt", 1 - u**2),
    "atan": lambda u: 1 / (1 + u**2),
    "exp": lambda u: Call("exp", u),
    "log": lambda u: 1 / u,
    "sinh": lambda u: Call("cosh", u),
    "cosh": lambda u: Call("sinh", u),
    "tanh": lambda u: 1 - Call("tanh", u) ** 2,
    "fresnel_c": lambda u: Call("cos", PI * u**2 / 2),
    "fresnel_s": lambda u: Call("sin", PI * u**2 / 2),
    **{name: _of_lambert(name) for name in LAMBERT},
    "abs": lambda u: Call("sign", u),
    "sign": lambda u: ZERO,
}
