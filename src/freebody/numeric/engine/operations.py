"""Operations on the entries of a state, each written once: sums, products, functions, and their rates along a motion.

What is constant is folded, what occurs twice is computed once. A rate is written by the same operations, forward
through the value, with the velocities for the derivatives of what moves:

    d(x y) = dx y + x dy,  d sqrt(x) = dx/(2 sqrt(x)),  d arg(x, y) = (x dy - y dx)/(x^2 + y^2).
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import Any

from freebody.language.expression import FLOAT_FUNCTIONS
from freebody.numeric.kernels.arrays import Floats, Ints, floats, ints
from freebody.numeric.kernels.operations import (
    ABS,
    ACOS,
    ADD,
    ARGUMENT,
    ASIN,
    ATAN,
    CONSTANT,
    COS,
    COSH,
    DIVIDE,
    EXP,
    FRESNEL_C,
    FRESNEL_S,
    FUNCTIONS,
    INPUT,
    LOG,
    MULTIPLY,
    POWER,
    SIGN,
    SIN,
    SINH,
    SQRT,
    SUBTRACT,
    TAN,
    TANH,
    TIME,
)


@dataclass(frozen=True)
class Program:
    """Operations (n, 3): what is done with which registers, or with which entry of the state; the last one is the
    result. inputs: the entries of the state that are read. turns: for every angle that is counted on, the place among
    the measures of the layout whose bearing it is (-1: none)."""

    code: Ints
    constants: Floats
    inputs: Ints
    turns: tuple[int, ...]


class OperationGraph(ABC):
    """Operations under way, of which programs are written."""

    def __init__(self) -> None:
        self._ops: list[tuple[int, int, int, float]] = []
        self._known: dict[tuple[int, int, int, float], int] = {}
        self._rates: dict[int, ProgramNode] = {}

    @abstractmethod
    def speed(self, entry: int) -> ProgramNode:
        """The rate of an entry of the state."""

    # -- operations ---------------------------------------------------------------------------
    def node(self, op: int, i: int = 0, j: int = 0, c: float = 0.0) -> ProgramNode:
        """An operation on earlier ones, or on an entry of the state, with a number c; the same one once only."""
        key = op, i, j, c
        if key not in self._known:
            self._known[key] = len(self._ops)
            self._ops.append(key)
        return ProgramNode(self, self._known[key])

    def constant(self, x: float) -> ProgramNode:
        return self.node(CONSTANT, c=float(x) + 0.0)

    def known(self, x: ProgramNode) -> float | None:
        """The number that a node is, if it is one."""
        op, _i, _j, c = self._ops[x.at]
        return c if op == CONSTANT else None

    def binary(self, op: int, a: ProgramNode, b: ProgramNode) -> ProgramNode:
        """a op b, shortened where one of them is 0 or 1."""
        x, y = self.known(a), self.known(b)
        if x is not None and y is not None and not (op == DIVIDE and y == 0.0):
            return self.constant(
                {ADD: x + y, SUBTRACT: x - y, MULTIPLY: x * y}.get(op) or (x / y if op == DIVIDE else 0.0)
            )
        if op == ADD and 0.0 in (x, y):
            return b if x == 0.0 else a
        if op == SUBTRACT and y == 0.0:
            return a
        if op == MULTIPLY and 0.0 in (x, y):
            return self.constant(0.0)
        if op == MULTIPLY and 1.0 in (x, y):
            return b if x == 1.0 else a
        if op == DIVIDE and (y == 1.0 or x == 0.0):
            return a
        return self.node(op, a.at, b.at)

    def function(self, op: int, x: ProgramNode) -> ProgramNode:
        number = self.known(x)
        if number is not None:
            try:
                return self.constant(FLOAT_FUNCTIONS[FUNCTIONS[op - SQRT]](number))
            except (ArithmeticError, ValueError):
                return self.constant(math.nan)
        return self.node(op, x.at)

    def power(self, x: ProgramNode, exponent: float | ProgramNode) -> ProgramNode:
        if isinstance(exponent, ProgramNode):
            number = self.known(exponent)
            if number is None:  # exp(y log x)
                return self.function(EXP, exponent * self.function(LOG, x))
            exponent = number
        if exponent == int(exponent) and 0 <= exponent <= 64:
            result, factor, n = self.constant(1.0), x, int(exponent)
            while n:
                result = result * factor if n & 1 else result
                n >>= 1
                factor = factor * factor if n else factor
            return result
        if exponent == int(exponent) and exponent < 0:
            return self.constant(1.0) / self.power(x, -exponent)
        if exponent == 0.5:
            return self.function(SQRT, x)
        number = self.known(x)
        if number is not None and number > 0.0:
            return self.constant(number**exponent)
        return self.node(POWER, x.at, self.constant(exponent).at, exponent)

    def operation(self, k: int) -> tuple[int, int, int, float]:
        """What is done in operation k, with which others or which entry of the state, and with which number."""
        return self._ops[k]

    def takes(self, k: int) -> set[int]:
        """The operations that operation k takes."""
        return set(self._taken(k))

    @property
    def n_operations(self) -> int:
        return len(self._ops)

    # -- rates --------------------------------------------------------------------------------
    def derivative(self, x: ProgramNode) -> ProgramNode:
        """The derivative of a node along the motion."""
        for k in self.below(x):  # no recursion: chains may be long
            if k not in self._rates:
                self._rates[k] = self._rate_by_parts(k)
        return self._rates[x.at]

    def below(self, *nodes: ProgramNode) -> list[int]:
        """The operations that nodes need, themselves included, each after what it takes."""
        needed, waiting = set[int](), [x.at for x in nodes]
        while waiting:
            i = waiting.pop()
            if i not in needed:
                needed.add(i)
                waiting += self._taken(i)
        return sorted(needed)

    def _rate_by_parts(self, k: int) -> ProgramNode:
        op, i, j, c = self._ops[k]
        if op == CONSTANT:
            return self.constant(0.0)
        if op == TIME:
            return self.constant(1.0)
        if op == INPUT:
            return self.speed(i)
        x, dx, here = ProgramNode(self, i), self._rates[i], ProgramNode(self, k)
        if op <= ARGUMENT:
            y, dy = ProgramNode(self, j), self._rates[j]
            if op == ADD:
                return dx + dy
            if op == SUBTRACT:
                return dx - dy
            if op == MULTIPLY:
                return dx * y + x * dy
            if op == DIVIDE:
                return (dx - here * dy) / y
            if op == POWER:
                return c * self.power(x, c - 1.0) * dx
            return (x * dy - y * dx) / (x * x + y * y)
        return self.slope(op, x, here) * dx

    def slope(self, op: int, x: ProgramNode, here: ProgramNode) -> ProgramNode:
        """The derivative of a function of one number."""
        one = self.constant(1.0)
        if op == SQRT:
            return 0.5 / here
        if op == SIN:
            return self.function(COS, x)
        if op == COS:
            return -self.function(SIN, x)
        if op == TAN:
            return one + here * here
        if op == ASIN:
            return one / self.function(SQRT, one - x * x)
        if op == ACOS:
            return -one / self.function(SQRT, one - x * x)
        if op == ATAN:
            return one / (one + x * x)
        if op == EXP:
            return here
        if op == LOG:
            return one / x
        if op == SINH:
            return self.function(COSH, x)
        if op == COSH:
            return self.function(SINH, x)
        if op == TANH:
            return one - here * here
        if op in (FRESNEL_C, FRESNEL_S):
            return self.function(COS if op == FRESNEL_C else SIN, self.constant(math.pi / 2) * x * x)
        return self.function(SIGN, x) if op == ABS else self.constant(0.0)

    # -- programs -----------------------------------------------------------------------------
    def written(self, result: ProgramNode) -> Program:
        """The operations that a result needs, in their order."""
        needed, waiting = set[int](), [result.at]
        while waiting:
            k = waiting.pop()
            if k not in needed:
                needed.add(k)
                waiting += self._taken(k)
        order = [*sorted(needed - {result.at}), result.at]
        place = {k: new for new, k in enumerate(order)}
        inputs = sorted({self._ops[k][1] for k in order if self._ops[k][0] == INPUT})
        turns = [self._ops[k] for k in order if self._ops[k][0] == ARGUMENT]
        code: list[tuple[int, int, int]] = []
        n_turns = 0
        constants: list[float] = []
        for k in order:
            op, i, j, c = self._ops[k]
            if op >= ADD:
                i = place[i]
                j = place[j] if op <= ARGUMENT else 0
            if op == ARGUMENT:
                c, n_turns = float(n_turns), n_turns + 1
            code.append((op, i, j))
            constants.append(c)
        return Program(ints(code, 2, 3), floats(constants), ints(inputs), tuple(int(t[3]) for t in turns))

    def _taken(self, k: int) -> tuple[int, ...]:
        op, i, j, _c = self._ops[k]
        return () if op <= INPUT else (i, j) if op <= ARGUMENT else (i,)


class ProgramNode:
    """One result in a program under way: a scalar that statements can be run over. Thousands of them are made."""

    __slots__ = ("at", "graph")

    def __init__(self, graph: OperationGraph, at: int) -> None:
        self.graph, self.at = graph, at

    def _with(self, other: Any) -> ProgramNode:
        return other if isinstance(other, ProgramNode) else self.graph.constant(float(other))

    def __add__(self, other: Any) -> ProgramNode:
        return self.graph.binary(ADD, self, self._with(other))

    def __radd__(self, other: Any) -> ProgramNode:
        return self.graph.binary(ADD, self._with(other), self)

    def __sub__(self, other: Any) -> ProgramNode:
        return self.graph.binary(SUBTRACT, self, self._with(other))

    def __rsub__(self, other: Any) -> ProgramNode:
        return self.graph.binary(SUBTRACT, self._with(other), self)

    def __mul__(self, other: Any) -> ProgramNode:
        return self.graph.binary(MULTIPLY, self, self._with(other))

    def __rmul__(self, other: Any) -> ProgramNode:
        return self.graph.binary(MULTIPLY, self._with(other), self)

    def __truediv__(self, other: Any) -> ProgramNode:
        return self.graph.binary(DIVIDE, self, self._with(other))

    def __rtruediv__(self, other: Any) -> ProgramNode:
        return self.graph.binary(DIVIDE, self._with(other), self)

    def __neg__(self) -> ProgramNode:
        return self.graph.binary(MULTIPLY, self.graph.constant(-1.0), self)

    def __pow__(self, exponent: Any) -> ProgramNode:
        return self.graph.power(self, exponent if isinstance(exponent, ProgramNode) else float(exponent))

    def __rpow__(self, base: Any) -> ProgramNode:
        return self.graph.power(self._with(base), self)
