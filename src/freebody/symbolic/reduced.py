"""Formulas without what no root or sign of them needs: roots of squares, and even powers."""

from __future__ import annotations

from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio


def without_square_roots(model: SymbolicModel, x: Ratio) -> Ratio:
    """Roots of squares by their values: sqrt(cos^2) is cos, with the sign that it has at the start, which is noted."""
    f = model.field
    plain: dict[int, Ratio] = {}
    for index in sorted(x.generators()):
        if f.generators[index].kind == "root" and f.generators[index].made_of:
            root = f.sqrt(f.radicand(index), model.samples.is_negative)
            if index not in root.generators():
                plain[index] = root
    return f.lowest_terms(f.substitute(x, plain)) if plain else x


def odd_part(x: Ratio) -> Ratio:
    """An element of the same sign without factors that occur an even number of times, where these do not vanish."""
    f = x.field
    num, below = f.lift(x, x.denominator())
    unit, factors = f.factor(num * below)
    result = f.element(1 if unit > 0 else -1)
    for base, exponent in factors:
        result = result * base if exponent % 2 else result
    return result
