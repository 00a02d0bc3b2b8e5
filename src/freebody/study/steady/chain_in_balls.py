"""A chain of formulas in an angle, enclosed in balls together with its slope along the angle.

The angles of loops come as 2 atan(a/b): where b vanishes +-pi/2 - atan(b/a) goes on in its place, and differs by half a
turn, so by a whole one of the angle. In sines and cosines that counts for nothing.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import suppress
from functools import cached_property
from typing import Any

import flint

from freebody.language.expression import (
    Call,
    Expr,
    PowerOf,
    ProductOf,
    Sum,
    Symbol,
    add,
    children,
    evaluate,
    multiply,
    number,
    power,
    rate_key,
    whole_exponent,
)
from freebody.study.answering.named_formulas import Chain
from freebody.symbolic.decide.slopes import FUNCTIONS, two_terms

_flint: Any = flint
_ATAN = "atan of a quotient"
_SERIES = ("sqrt", "sin", "cos", "tan", "asin", "acos", "atan", "abs", "exp", "log", "sinh", "cosh", "tanh")


class ChainInBalls:
    """`name`: the angle; known: the numbers of the other names that the chain begins with."""

    def __init__(self, chain: Chain, name: str, known: Mapping[str, float]) -> None:
        self.chain, self.name, self.known = chain, name, known
        self._steps = [(rate_key(step.name), _with_quotients(step.formula)) for step in chain.named]
        self._result = _with_quotients(chain.result[0])

    def enclosed(self, middle: float, half: float) -> tuple[Any, Any]:
        """(value, slope) in an interval of the angle; balls that are not finite where nothing can be said."""
        with two_terms():
            values: dict[str, Any] = {key: _flint.arb_series([x]) for key, x in self.known.items()}
            values[self.name] = _flint.arb_series([_flint.arb(middle, half), 1])
            with suppress(ArithmeticError, ValueError):  # of a divisor that may vanish there
                for key, formula in self._steps:
                    values[key] = evaluate(formula, values, _FUNCTIONS)
                found = _flint.arb_series(evaluate(self._result, values, _FUNCTIONS))
                return found[0], found[1]
            return _flint.arb.nan(), _flint.arb.nan()

    @cached_property
    def counts_no_turns(self) -> bool:
        """Whether every angle that an atan tells stands in sines and cosines alone."""
        formulas = [*(step.formula for step in self.chain.named), *self.chain.result]
        keys = [rate_key(step.name) for step in self.chain.named if "atan" in set(_functions_in(step.formula))]
        return not any(_stands_bare(x, key) for x in formulas for key in keys)


def _with_quotients(e: Expr) -> Expr:
    """With atan(a/b) as a function of a and b."""
    if isinstance(e, Call):
        if e.function == "rate":
            return e
        parts = _quotient(e.argument) if e.function == "atan" else None
        return e.of(_with_quotients) if parts is None else Call(_ATAN, *map(_with_quotients, parts))
    if isinstance(e, ProductOf):
        return multiply(*map(_with_quotients, e.factors))
    if isinstance(e, PowerOf):
        return power(_with_quotients(e.base), e.exponent)
    return add(*map(_with_quotients, e.terms)) if isinstance(e, Sum) else e


def _quotient(e: Expr) -> tuple[Expr, Expr] | None:
    """What stands above and below the bar; None without one."""
    above, below = list[Expr](), list[Expr]()
    for factor in e.factors if isinstance(e, ProductOf) else (e,):
        n = whole_exponent(factor) if isinstance(factor, PowerOf) else None
        if isinstance(factor, PowerOf) and n is not None and n < 0:
            below.append(power(factor.base, number(-n)))
        else:
            above.append(factor)
    return (multiply(*above), multiply(*below)) if below else None


def _atan_of_quotient(above: Any, below: Any) -> Any:
    a, b = _flint.arb_series(above), _flint.arb_series(below)
    if not b[0].contains(0):
        return (a / b).atan()
    right = _flint.arb_series([_flint.arb.pi() / 2])
    return (right if a[0] > 0 else -right) - (b / a).atan()


_FUNCTIONS: dict[str, Any] = {
    **{name: getattr(FUNCTIONS, name) for name in _SERIES},
    _ATAN: _atan_of_quotient,
    "pi": _flint.arb.pi(),
    "number": lambda x: _flint.arb_series([_flint.arb(_flint.fmpq(x.numerator, x.denominator))]),
}


def _functions_in(e: Expr) -> Iterator[str]:
    if isinstance(e, Call):
        yield e.function
    for part in children(e):
        yield from _functions_in(part)


def _stands_bare(e: Expr, key: str) -> bool:
    """Whether a name stands in a formula outside of sines and cosines."""
    if isinstance(e, Call) and e.function in ("sin", "cos", "rate"):
        return False
    if isinstance(e, Symbol):
        return e.name == key
    return any(_stands_bare(part, key) for part in children(e))
