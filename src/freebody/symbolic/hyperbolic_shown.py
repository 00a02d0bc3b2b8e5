"""Exponential functions that stand with their inverses, as people write them: (E^2 + 1)/(2 E) is cosh(u), E = exp(u).

With a divisor b E^d and a dividend c_0 + c_d E^d + c_2d E^2d

    c_2d = c_0    (2 c_2d cosh(d u) + c_d)/b,        c_2d = -c_0    (2 c_2d sinh(d u) + c_d)/b.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from freebody.language.expression import Call, Expr, add, multiply, number
from freebody.symbolic.ratio import Ratio


def in_hyperbolic_functions(x: Ratio, shown: Callable[[Ratio], Expr]) -> Iterator[Expr]:
    """The same element with one hyperbolic function, where it has such a form; shown: how its parts are written."""
    field = x.field
    if x.den is None:
        return
    below = x.denominator()
    exponentials = [g for g in below.generators() if field.arguments.get(g, ("",))[0] == "exp"]
    if len(exponentials) != 1:
        return
    (e,) = exponentials
    under, over = below.coefficients(e), x.numerator().coefficients(e)
    d = len(under) - 1
    if d < 1 or len(over) != 2 * d + 1 or any(not c.is_zero() for c in under[:-1]):
        return
    if any(not c.is_zero() for k, c in enumerate(over) if k % d):
        return
    first, middle, last, divisor = over[0], over[d], over[-1], under[-1]
    if not ((last - first).is_zero() or (last + first).is_zero()):
        return
    argument = shown(field.lowest_terms(d * field.arguments[e][1]))
    function = Call("cosh" if (last - first).is_zero() else "sinh", argument)
    front, rest = (field.lowest_terms(part / divisor) for part in (2 * last, middle))
    share = field.lowest_terms(rest / front).fraction()
    if share is not None:
        yield multiply(shown(front), add(function, number(share)) if share else function)
    else:
        yield add(multiply(shown(front), function), shown(rest))
