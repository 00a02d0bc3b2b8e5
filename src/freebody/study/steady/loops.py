"""Angles that a closed loop binds, put in explicitly where the loop is linear in their cosine and sine.

With a cos q + b sin q + d = 0 and w = b cos q - a sin q = +-sqrt(a^2 + b^2 - d^2), the sign that of the branch:

    cos q = (b w - a d)/(a^2 + b^2),    sin q = -(a w + b d)/(a^2 + b^2).
"""

from __future__ import annotations

import math

from freebody.errors import CannotAnswer
from freebody.symbolic.field import Ratio
from freebody.symbolic.model import Coordinate, SymbolicModel

_SMALL = 1e-9


def explicit(model: SymbolicModel, x: Ratio) -> Ratio:
    """The element by independent coordinates. Raises CannotAnswer where a loop is more than one such equation."""
    for _ in model.dependent:
        bound = [d for d in model.dependent if d.index in model.field.ingredients(x)]
        if not bound:
            break
        x = _without(model, x, bound)
    bound = [d for d in model.dependent if d.index in model.field.ingredients(x)]
    if bound:
        raise _too_closed(bound)
    return x


def _without(model: SymbolicModel, x: Ratio, bound: list[Coordinate]) -> Ratio:
    f = model.field
    dependent = {d.index for d in model.dependent}
    for d in bound:
        for loop in model.loops:
            if set(f.ingredients(loop.value)) & dependent == {d.index}:
                parts = _linear_in(model, loop.value.numerator(), d.index)
                if parts is not None:
                    cos, sin = _by_cosine_and_sine(model, d.index, *parts)
                    c, s = f.pair_of(d.index) or (-1, -1)
                    values = {c: cos, s: sin}
                    if d.index in f.ingredients(x) and d.index in x.generators():
                        values[d.index] = f.angle_with(cos, sin)
                    return f.lowest_terms(f.follow(x, values))
    raise _too_closed(bound)


def _too_closed(bound: list[Coordinate]) -> CannotAnswer:
    names = ", ".join(d.name for d in bound)
    return CannotAnswer(f"it depends on {names}, which follow only through closed loops that have no short solution")


def _linear_in(model: SymbolicModel, value: Ratio, index: int) -> tuple[Ratio, Ratio, Ratio] | None:
    """a, b, d of a cos + b sin + d."""
    pair = model.field.pair_of(index)
    if pair is None or index in value.generators():
        return None
    in_cos = value.coefficients(pair[0])
    in_sin = in_cos[0].coefficients(pair[1])
    a = in_cos[1] if len(in_cos) > 1 else model.field.zero
    b = in_sin[1] if len(in_sin) > 1 else model.field.zero
    if len(in_cos) > 2 or len(in_sin) > 2 or pair[1] in a.generators():
        return None
    return a, b, in_sin[0]


def _by_cosine_and_sine(model: SymbolicModel, index: int, a: Ratio, b: Ratio, d: Ratio) -> tuple[Ratio, Ratio]:
    f = model.field
    c, s = (f.variable(i) for i in f.pair_of(index) or (-1, -1))
    signs = {v > 0 for v in model.at_samples(b * c - a * s) if not math.isnan(v) and abs(v) > _SMALL}
    if len(signs) != 1:
        raise CannotAnswer("which way the loop is assembled depends on the parameter values")
    square = f.lowest_terms(a * a + b * b)
    w = f.sqrt(f.lowest_terms(square - d * d)) * (1 if signs.pop() else -1)
    return f.lowest_terms((b * w - a * d) / square), f.lowest_terms(-(a * w + b * d) / square)
