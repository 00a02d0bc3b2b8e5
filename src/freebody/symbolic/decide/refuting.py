"""That an element is not zero at given numbers, proved by balls: the enclosure of its value is without zero.

Doubles leave some fifteen digits of a value, and of terms that cancel none; with 256 bits a difference that is not zero
shows itself. Source: Johansson, Arb, IEEE Trans. Comput. 66, 2017, 1281-1292.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import flint

from freebody.symbolic.decide.picture import BallFunctions
from freebody.symbolic.ratio import Ratio

_flint: Any = flint
_BITS = 256


def is_proved_not_zero(x: Ratio, numbers: Mapping[int, float]) -> bool:
    """numbers: exact values of the free generators. False where zero is in the enclosure, or there is none."""
    field, functions = x.field, BallFunctions()
    with _flint.ctx.workprec(_BITS):
        values: dict[int, Any] = {}
        try:
            for g in sorted(field.ingredients(x)):
                compute = field.generators[g].compute
                values[g] = _flint.arb(numbers[g]) if compute is None else compute(values, functions)
            value = _flint.arb(field.evaluate(x.numerator(), values))
        except (KeyError, ValueError, ArithmeticError):
            return False
        return bool(value > 0 or value < 0)
