"""The sign of an element at given numbers, proved by balls: the enclosure of its value is without zero.

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


class Enclosed:
    """Elements of one field at one point."""

    def __init__(self, numbers: Mapping[int, float], there: Mapping[int, Ratio] | None = None) -> None:
        """numbers: exact values of the free generators; there: those that are elements in others."""
        self.numbers, self.there = numbers, there or {}
        self._values: dict[int, Any] = {}
        self._signs: dict[Any, int] = {}

    def sign(self, x: Ratio) -> int:
        """+1 or -1; 0 where zero is in the enclosure, or there is none."""
        key = x.key()
        if key not in self._signs:
            self._signs[key] = self._sign(x)
        return self._signs[key]

    def _sign(self, x: Ratio) -> int:
        with _flint.ctx.workprec(_BITS):
            try:
                self._fill(x)
                value = _flint.arb(x.field.evaluate(x, self._values))
            except (KeyError, ValueError, ArithmeticError):
                return 0
            return int(value > 0) - int(value < 0)

    def _fill(self, x: Ratio) -> None:
        field, functions = x.field, BallFunctions()
        for g in sorted(field.ingredients(x) - self._values.keys()):
            compute = field.generators[g].compute
            if g in self.there:
                self._fill(self.there[g])
                self._values[g] = _flint.arb(field.evaluate(self.there[g], self._values))
            else:
                self._values[g] = _flint.arb(self.numbers[g]) if compute is None else compute(self._values, functions)


def is_proved_not_zero(x: Ratio, numbers: Mapping[int, float]) -> bool:
    """numbers: exact values of the free generators. False where zero is in the enclosure, or there is none."""
    return Enclosed(numbers).sign(x.numerator()) != 0
