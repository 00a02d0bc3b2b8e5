"""Functions in formulas of models that are written in Python: `from freebody.functions import cos, sin`.

They take parameters, measures and formulas of these, as `Model.parameters` and `Model.measure` give them, or numbers.
"""

from __future__ import annotations

from collections.abc import Callable

from freebody.language.expression import Call, Expr, Operand, number


def _of(name: str) -> Callable[[Operand], Expr]:
    def function(of: Operand) -> Expr:
        return Call(name, number(of) if isinstance(of, (int, float)) else of)  # pyrefly: ignore[bad-argument-type]

    function.__name__ = function.__qualname__ = name
    function.__doc__ = f"{name} of a formula."
    return function


sqrt, exp, log = _of("sqrt"), _of("exp"), _of("log")
sin, cos, tan = _of("sin"), _of("cos"), _of("tan")
asin, acos, atan = _of("asin"), _of("acos"), _of("atan")
