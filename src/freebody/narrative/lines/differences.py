"""Derivatives in numbers, by central differences of formulas that have been checked before.

dT/du is taken with everything else kept; d/dt follows the motion: every symbol changes with its rate, rates with
theirs.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Iterator, Mapping
from typing import Any

from freebody.language.expression import FLOAT_FUNCTIONS, Expr, Symbol, evaluate, rate_key
from freebody.present.report.blocks import Derivative, Difference, Side

STEP = 1e-4

Shifts = Mapping[str, float]


class SymbolValues(Mapping[str, Any]):
    """Symbols in numbers, and the formulas that some of them stand for."""

    @property
    @abstractmethod
    def formulas(self) -> Mapping[str, Expr]: ...


class _Shifted(Mapping[str, float]):
    """A world with some symbols changed by a little."""

    def __init__(self, world: SymbolValues, shifts: Shifts, along: float) -> None:
        self.world, self.shifts, self.along = world, shifts, along

    def __getitem__(self, name: str) -> float:
        value = float(self.world[name]) + self.shifts.get(name, 0.0)
        if self.along:
            value += self.along * self._rate(name) + 0.5 * self.along**2 * self._rate(f"rate({name})")
        return value

    def _rate(self, name: str) -> float:
        """How fast a symbol changes; parameters do not."""
        if name == "t":
            return 1.0
        if name == "rate(t)" or name.count("rate(") > 2:
            return 0.0
        key = f"rate({name})"
        return float(self.world[key]) if key in self.world else 0.0

    def __contains__(self, name: object) -> bool:
        return name in self.world

    def __iter__(self) -> Iterator[str]:
        return iter(self.world)

    def __len__(self) -> int:
        return len(self.world)


def value_of(side: Side, world: SymbolValues) -> float:
    """A derivative, or a difference of such."""
    return _value(side, world, {}, 0.0)


def _value(side: Side, world: SymbolValues, shifts: Shifts, along: float) -> float:
    match side:
        case Difference(first, second):
            return _value(first, world, shifts, along) - _value(second, world, shifts, along)
        case Derivative(of, by, is_partial):
            name = rate_key(by)
            if not is_partial and name == "t":
                values = [_value(of, world, shifts, along + h) for h in (-STEP, STEP)]
            else:
                values = [_value(of, world, {**shifts, name: shifts.get(name, 0.0) + h}, along) for h in (-STEP, STEP)]
            return (values[1] - values[0]) / (2 * STEP)
        case tuple():
            raise TypeError("a vector has no derivative here")
        case _:
            return float(evaluate(_formula(side, world), _Shifted(world, shifts, along), FLOAT_FUNCTIONS))


def _formula(side: Expr, world: SymbolValues) -> Expr:
    """What a symbol was found to be."""
    return world.formulas.get(side.name, side) if isinstance(side, Symbol) else side
