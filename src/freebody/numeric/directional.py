"""Derivatives of smooth functions along a line, by central differences of order 8 that watch themselves.

    f'(0) = sum_k c_k (f(k h) - f(-k h))/h,        c = 4/5, -1/5, 4/105, -1/280

The formula of order 6 from the same values says whether f is smooth on the stencil: for a smooth f the two agree.
If they do not, h is reduced by tens. A function whose slope has a kink (x |x|) shows by a difference that shrinks
with h, and the slope is extrapolated to h = 0; one with a jump or a kink of its own has no derivative.
Source: Fornberg, Math. Comp. 51 (1988) 699-706.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.numeric.jets import Array
from freebody.tolerances import LEAST

_ORDER_8 = (4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0)
_ORDER_6 = (3.0 / 4.0, -3.0 / 20.0, 1.0 / 60.0, 0.0)
_STEPS = (5e-3, 5e-4, 5e-5, 5e-6)
_EPSILON = 2.3e-16


def derivative(f: Callable[[float], Array], scale: Array) -> Array:
    """df/ds at s = 0, where s = 1 is a move by the size of the system (a radian). `scale` is what the terms of f come
    to, by which it is rounded. Raises CannotAnswer if f has no derivative there."""
    before: tuple[Array, Array] | None = None
    for h in _STEPS:
        try:
            slope, gap = _slope(f, h, scale)
        except (CannotAnswer, ArithmeticError, ValueError):
            before = None  # the stencil reaches where f has no value
            continue
        if not (gap > 0.0).any():
            return slope
        if before is not None and h == _STEPS[-1] and bool((gap <= 0.2 * before[1] + LEAST).all()):
            return (10.0 * slope - before[0]) / 9.0
        before = slope, gap
    raise CannotAnswer(
        Message(
            "the loads are not smooth in this pose (a friction or a stop that switches, or a point of a given curve), "
            "so they have no linear law of small motions there"
        )
    )


def _slope(f: Callable[[float], Array], h: float, scale: Array) -> tuple[Array, Array]:
    """The derivative at a step, and by how much f is not smooth there (zero: by no more than rounding)."""
    here = f(0.0)
    ahead = [f(k * h) for k in (1, 2, 3, 4)]
    behind = [f(-k * h) for k in (1, 2, 3, 4)]
    odd = [a - b for a, b in zip(ahead, behind, strict=True)]
    slope = sum((c * d for c, d in zip(_ORDER_8, odd, strict=True)), np.zeros_like(here)) / h
    lower = sum((c * d for c, d in zip(_ORDER_6, odd, strict=True)), np.zeros_like(here)) / h
    rounded = 200.0 * _EPSILON * np.max(np.abs([scale, here, *ahead, *behind]), axis=0) / h
    steepest = np.max(np.abs([d / (2.0 * k) for k, d in enumerate(odd, 1)]), axis=0) / h
    gap = np.abs(slope - lower)
    gap[gap <= 1e-8 * steepest + rounded] = 0.0
    # the even part of a smooth function grows with h^2
    even = [a + b - 2.0 * here for a, b in zip(ahead[:2], behind[:2], strict=True)]
    bend = np.abs(4.0 * even[0] - even[1]) / h
    bend[bend <= 0.02 * np.abs(even[1]) / h + rounded + 1e-3 * h * steepest] = 0.0
    return slope, np.maximum(gap, bend)
