"""The potential of a load: minus the integral of its law over its measure.

    V(x) = -int_0^x f(s) ds,        so that the force is  f = -dV/dx

A law has one if it depends on nothing that moves but its own measure. The integral is taken numerically.
Source: Davis & Rabinowitz, Methods of Numerical Integration, 2nd ed. 1984, sec. 2.7 (Gauss-Legendre).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.expression import FLOAT_FUNCTIONS, FRESNEL, Call, Expr, children, evaluate, free_symbols
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.model.elements import RATE, VALUE, AppliedLoad, NonholonomicForm
from freebody.numeric.checks import finite, named
from freebody.numeric.jets import Array
from freebody.numeric.system import NumericSystem
from freebody.tolerances import ROUNDED


def potential(reference: NumericSystem, push: AppliedLoad, value: Callable[[Measure], float]) -> float:
    """Minus the integral of the law over its measure from 0 (for a measure of which only changes mean
    something: from the start; of a law with a pole at 0 that fades out: from infinity) to its value [J]. Raises
    CannotAnswer where the law has no potential."""
    law, needed = push.law, free_symbols(push.law) - set(reference.frame.values) - {VALUE.name}
    own = {name for name, measure in push.measures if measure == push.measure}
    if isinstance(push.measure, NonholonomicForm):
        raise CannotAnswer(Message("{load} has no potential: its direction turns with a body", load=push.name))
    if needed - own or _has_rate(law):
        told = (name for name in sorted(needed - own - {RATE.name}) if not name.startswith("@"))  # others are its own
        names = ", ".join(told) or Message("a rate")
        raise CannotAnswer(Message("{load} has no potential: its law depends on {names}", load=push.name, names=names))
    origin = reference.start_value(push.measure)

    def force(x: Array) -> Array:
        names: dict[str, Any] = {**reference.frame.values, VALUE.name: x}
        names |= dict.fromkeys(own, x + origin)
        return np.broadcast_to(evaluate(law, names, ARRAY_FUNCTIONS), x.shape)

    x = value(push.measure) - origin
    with named(push.name):
        try:
            return -_integral(force, x)
        except (ValueError, ArithmeticError):
            if origin or x <= 0.0:
                raise
            # with s = x/u:  V = integral of f(s) ds from x to infinity
            return _integral(lambda u: force(x / u) * x / (u * u), 1.0)


def work_between(reference: NumericSystem, push: AppliedLoad, start: float, end: float) -> float:
    """The work of a load that is a law of its own measure alone, from one value of the measure to another [J]."""
    origin = reference.start_value(push.measure)  # pyrefly: ignore[bad-argument-type]

    def force(x: Array) -> Array:
        names: dict[str, Any] = {**reference.frame.values, VALUE.name: x + (start - origin)}
        return np.broadcast_to(evaluate(push.law, names, ARRAY_FUNCTIONS), x.shape)

    with named(push.name):
        return _integral(force, end - start)


def _has_rate(expr: Expr) -> bool:
    is_rate = isinstance(expr, Call) and expr.function == "rate"
    return is_rate or any(_has_rate(part) for part in children(expr))


ARRAY_FUNCTIONS: Mapping[str, Any] = {
    **{name: getattr(np, name) for name in ("sqrt", "sin", "cos", "tan", "exp", "log", "sinh", "cosh", "tanh")},
    **{"asin": np.arcsin, "acos": np.arccos, "atan": np.arctan, "abs": np.abs, "sign": np.sign},
    **{name: np.vectorize(FLOAT_FUNCTIONS[name], otypes=[float]) for name in FRESNEL},
    "pi": math.pi,
    "number": float,
}


def _integral(f: Callable[[Array], Array], upper: float) -> float:
    """Integral of f from 0 by Gauss-Legendre panels of order 40; where f is not smooth at 0, panels halve
    towards it. Raises ValueError if that does not converge."""
    nodes, weights = np.polynomial.legendre.leggauss(20)

    def panels(edges: Array) -> tuple[float, float]:
        half = 0.5 * np.diff(edges)[:, None]
        x = edges[:-1, None] + half * (1.0 + nodes)
        parts = upper * half * weights * f(upper * x)
        return float(parts.sum()), float(np.abs(parts).sum())

    with np.errstate(divide="raise", invalid="raise", over="raise"):
        for first, second in ((1, 2), (80, 100)):
            coarse, _ = panels(np.append(0.0, 0.5 ** np.arange(first - 1.0, -1.0, -1.0)))
            fine, size = panels(np.append(0.0, 0.5 ** np.arange(second - 1.0, -1.0, -1.0)))
            if abs(fine - coarse) <= ROUNDED * size:
                return finite(fine)
    raise ValueError("its law cannot be integrated from 0")
