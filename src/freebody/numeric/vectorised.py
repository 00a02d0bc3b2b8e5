"""Expressions compiled to functions of whole arrays: a list of operations, of which none is done twice.

The one walk over the tree (`evaluate`) is made once, in an arithmetic whose numbers are registers: what it would
compute it writes down. Played with arrays, the list gives the expressions at all of their points at once, and where an
expression has no real value there, NaN.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from freebody.language.expression import FLOAT_FUNCTIONS, Expr, evaluate, free_symbols
from freebody.language.truth import Comparison, Statement, comparisons, truth
from freebody.numeric.jets import Array
from freebody.numeric.potential import ARRAY_FUNCTIONS

Operation = Callable[..., Any]


@dataclass(frozen=True, eq=False, slots=True)
class _Register:
    """A number that is known when the list is played."""

    tape: VectorFunction
    index: int

    def _with(self, operation: Operation, other: _Register | float, *, is_left: bool = True) -> _Register:
        register = other if isinstance(other, _Register) else self.tape.constant(float(other))
        pair = (self.index, register.index) if is_left else (register.index, self.index)
        return self.tape.emit(operation, *pair)

    def __add__(self, other: _Register | float) -> _Register:
        return self._with(np.add, other)

    def __radd__(self, other: float) -> _Register:
        return self._with(np.add, other, is_left=False)

    def __mul__(self, other: _Register | float) -> _Register:
        return self._with(np.multiply, other)

    def __rmul__(self, other: float) -> _Register:
        return self._with(np.multiply, other, is_left=False)

    def __truediv__(self, other: _Register | float) -> _Register:
        return self._with(np.divide, other)

    def __rtruediv__(self, other: float) -> _Register:
        return self._with(np.divide, other, is_left=False)

    def __pow__(self, exponent: _Register | float) -> _Register:
        return self._with(np.power, exponent)


class VectorFunction:
    """Several expressions of the same names. names: those without which they have no value."""

    def __init__(self, expressions: Sequence[Expr]) -> None:
        self.expressions = tuple(expressions)
        self.names = frozenset[str]().union(*map(free_symbols, expressions)) - {"pi"}
        self._n_registers = 0
        self._steps: list[tuple[Operation, tuple[int, ...]]] = []
        self._known: dict[tuple[Operation, tuple[int, ...]], int] = {}
        self._constants: dict[float, int] = {}
        self._filled: list[tuple[int, float]] = []
        self._inputs: dict[str, int] = {name: self._new() for name in sorted(self.names)}
        values = {name: _Register(self, index) for name, index in self._inputs.items()}
        self._results = [evaluate(e, values, self._functions()).index for e in expressions]

    def __reduce__(self) -> tuple[type[VectorFunction], tuple[tuple[Expr, ...]]]:
        """Another process makes the list anew."""
        return type(self), (self.expressions,)

    def _functions(self) -> dict[str, Any]:
        """What `evaluate` calls: it writes down what is to be done."""

        def written(operation: Operation) -> Callable[..., _Register]:
            return lambda *of: self.emit(operation, *(x.index for x in of))

        known: dict[str, Any] = {
            name: written(ARRAY_FUNCTIONS.get(name) or _one_by_one(FLOAT_FUNCTIONS[name]))
            for name in FLOAT_FUNCTIONS
            if name not in ("pi", "number")
        }

        def number(x: float) -> _Register:
            return self.constant(float(x))

        return known | {"pi": self.constant(math.pi), "number": number}

    def _new(self) -> int:
        self._n_registers += 1
        return self._n_registers - 1

    def constant(self, value: float) -> _Register:
        """The register of a number."""
        if value not in self._constants:
            self._constants[value] = self._new()
            self._filled.append((self._constants[value], value))
        return _Register(self, self._constants[value])

    def emit(self, operation: Operation, *of: int) -> _Register:
        """The register of what an operation gives, which is done once however often it occurs."""
        key = (operation, of)
        if key not in self._known:
            self._known[key] = self._new()
            self._steps.append(key)
        return _Register(self, self._known[key])

    def at(self, values: Mapping[str, Array | float], n: int) -> list[Array]:
        """(n,) values of each expression; NaN where it has no real one. values: by name, (n,) or one number each.
        Raises KeyError for a name without one."""
        registers: list[Any] = [None] * self._n_registers
        for name, index in self._inputs.items():
            registers[index] = np.asarray(values[name], dtype=np.float64)
        for index, value in self._filled:
            registers[index] = np.float64(value)
        with np.errstate(all="ignore"):
            for operation, used in self._steps:
                index = self._known[operation, used]
                registers[index] = operation(*(registers[k] for k in used))
        found = [np.array(np.broadcast_to(registers[k], (n,)), dtype=np.float64) for k in self._results]
        return [np.where(np.isfinite(x), x, np.nan) for x in found]


def _one_by_one(function: Callable[..., float]) -> Operation:
    """A function of numbers as one of arrays."""

    def safe(*of: float) -> float:
        try:
            return function(*map(float, of))
        except (ArithmeticError, ValueError):
            return math.nan

    return np.vectorize(safe, otypes=[float])


class VectorStatement:
    """A statement at arrays of numbers."""

    def __init__(self, statement: Statement) -> None:
        self.statement = statement
        self._compared = list(dict.fromkeys(comparisons(statement)))
        self._sides = VectorFunction([side for c in self._compared for side in (c.left, c.right)])
        self.names = self._sides.names

    def __reduce__(self) -> tuple[type[VectorStatement], tuple[Statement]]:
        return type(self), (self.statement,)

    def at(self, values: Mapping[str, Array | float], n: int, *, round_off: float = 0.0) -> Array:
        """(n,) 1 where it is so, -1 where it is not, 0 where a side has no value. round_off: as of `is_true`."""
        sides = self._sides.at(values, n)
        found: dict[Comparison, Array] = {}
        for c, left, right in zip(self._compared, sides[::2], sides[1::2], strict=True):
            room = round_off * np.fmax(np.abs(left), np.abs(right))
            is_so = np.where(c.truth(left, right, room), 1.0, -1.0)
            found[c] = np.where(np.isnan(left) | np.isnan(right), 0.0, is_so)
        return truth(self.statement, found.__getitem__, np.minimum, np.maximum)
