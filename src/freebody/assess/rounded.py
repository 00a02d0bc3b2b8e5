"""Formulas whose coefficients are rounded: 0.667 g for 2/3 g."""

from __future__ import annotations

from collections.abc import Sequence

from freebody.assess.comparing import ComponentPair
from freebody.language.expression import Expr, Number, children

ROUGH = 2e-3  # relative difference by rounding to three digits


def numbers_in(expr: Expr) -> list[Number]:
    """All numbers of an expression."""
    if isinstance(expr, Number):
        return [expr]
    return [x for part in children(expr) for x in numbers_in(part)]


def rounded_by(pairs: Sequence[ComponentPair], exprs: Sequence[Expr]) -> float | None:
    """By how much a formula with decimal coefficients is off everywhere, if that is by their rounding."""
    decimals = [x for expr in exprs for x in numbers_in(expr) if x.value.denominator > 1 and _is_decimal(x)]
    if not decimals or any(pair.setting.up_to_constant for pair in pairs):
        return None
    largest = 0.0
    for pair in pairs:
        points = pair.setting.poses() if pair.is_looped else list(pair.setting.points(pair.option.conditions))[:12]
        for point in points:
            difference, scale = pair.difference(point)
            if not (difference.is_finite() and abs(difference) <= scale * ROUGH):
                return None
            if abs(scale) > 0:
                largest = max(largest, float(abs(difference) / scale) * 2)
    return largest or None


def _is_decimal(x: Number) -> bool:
    """Whether a number looks as if it were rounded: a decimal with three digits or more."""
    below = x.value.denominator
    for p in (2, 5):
        while below % p == 0:
            below //= p
    return below == 1 and len(str(x.value.numerator)) >= 3
