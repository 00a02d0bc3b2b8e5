"""Gradients of operations, written by the same operations backward through them, and their values at many instants.

With w the derivative of the result by an operation, each one that it takes gets w times the partial derivative:

    d(x y): w y to x, w x to y;   d(x/y): w/y to x, -w (x/y)/y to y;   d arg(x, y): -w y/r^2 to x, w x/r^2 to y.

Source: Griewank & Walther, Evaluating Derivatives, 2nd ed. 2008, ch. 3.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from freebody.numeric.engine.operations import OperationGraph, ProgramNode
from freebody.numeric.jets import Array
from freebody.numeric.kernels.operations import (
    ADD,
    ARGUMENT,
    CONSTANT,
    DIVIDE,
    FUNCTIONS,
    INPUT,
    MULTIPLY,
    POWER,
    SQRT,
    SUBTRACT,
    TIME,
)
from freebody.numeric.potential import ARRAY_FUNCTIONS

BY_TIME = -1  # the key of the derivative by the time itself, where others are entries of the state
CHUNK = 4096  # instants at once
TURN = 2.0 * np.pi
Gradient = dict[int, ProgramNode]
Inputs = Mapping[int, "Array | float"]
Angles = Mapping[int, float]
NO_ANGLES: Angles = {}


def gradient(graph: OperationGraph, result: ProgramNode) -> Gradient:
    """The derivatives of a result by all inputs that are in it."""
    weights: dict[int, ProgramNode] = {result.at: graph.constant(1.0)}
    found: Gradient = {}
    for k in reversed(graph.below(result)):
        if k not in weights:
            continue
        op, i, j, c = graph.operation(k)
        w = weights[k]
        if op == INPUT:
            found[i] = w
        elif op == TIME:
            found[BY_TIME] = w
        elif op != CONSTANT:
            for of, part in _parts(graph, op, i, j, c, k, w):
                weights[of] = weights[of] + part if of in weights else part
    return {key: node for key, node in found.items() if graph.known(node) != 0.0}


def _parts(
    graph: OperationGraph, op: int, i: int, j: int, c: float, k: int, w: ProgramNode
) -> Sequence[tuple[int, ProgramNode]]:
    """What operation k takes, each with its part of the weight w: w times the derivative by it. Numbers get none."""
    x, y, here = ProgramNode(graph, i), ProgramNode(graph, j), ProgramNode(graph, k)
    if op == ADD:
        return (i, w), (j, w)
    if op == SUBTRACT:
        return (i, w), (j, -w)
    if op == MULTIPLY:
        if graph.known(x) is not None:
            return ((j, w * x),)
        return ((i, w * y),) if graph.known(y) is not None else ((i, w * y), (j, w * x))
    if op == DIVIDE:
        of = w / y
        return (i, of), (j, -(of * here))
    if op == POWER:
        return ((i, w * (c * graph.power(x, c - 1.0))),)
    if op == ARGUMENT:
        square = x * x + y * y
        return (i, w * (-y / square)), (j, w * (x / square))
    return ((i, w * graph.slope(op, x, here)),)


class Played:
    """Some results of a graph, evaluated at many instants at once."""

    def __init__(self, graph: OperationGraph, results: Sequence[ProgramNode]) -> None:
        needed = set[int]()
        for result in results:
            if result.at not in needed:
                needed.update(graph.below(result))
        self._steps = [(k, *graph.operation(k)) for k in sorted(needed)]
        self._results = [result.at for result in results]

    def at(
        self, inputs: Inputs, times: Array, angles: Angles = NO_ANGLES, after: dict[int, float] | None = None
    ) -> Array:
        """(n_results, n) values. inputs: of the entries of a state, (n,) or one number each; angles: those of lines
        before the first instant, by operation, from which they are counted on; after: gets those at the last one."""
        n, going = len(times), dict(angles)
        found = np.empty((len(self._results), n))
        for first in range(0, n, CHUNK):
            part = slice(first, first + CHUNK)
            own = {key: x[part] if isinstance(x, np.ndarray) else x for key, x in inputs.items()}
            registers = self._played(own, times[part], going)
            for row, k in enumerate(self._results):
                found[row, part] = registers[k]
        if after is not None:
            after.update(going)
        return found

    def _played(self, inputs: Inputs, times: Array, angles: dict[int, float]) -> dict[int, Any]:
        registers: dict[int, Any] = {}
        with np.errstate(all="ignore"):
            for k, op, i, j, c in self._steps:
                if op == CONSTANT:
                    registers[k] = c
                elif op == TIME:
                    registers[k] = times
                elif op == INPUT:
                    registers[k] = inputs[i]
                elif op == ADD:
                    registers[k] = registers[i] + registers[j]
                elif op == SUBTRACT:
                    registers[k] = registers[i] - registers[j]
                elif op == MULTIPLY:
                    registers[k] = registers[i] * registers[j]
                elif op == DIVIDE:
                    registers[k] = np.divide(registers[i], registers[j])
                elif op == POWER:
                    registers[k] = np.power(registers[i], c)
                elif op == ARGUMENT:
                    registers[k] = _counted_on(np.arctan2(registers[j], registers[i]), k, angles)
                else:
                    registers[k] = ARRAY_FUNCTIONS[FUNCTIONS[op - SQRT]](registers[i])
        return registers


def _counted_on(angle: Any, key: int, angles: dict[int, float]) -> Any:
    """An angle along a motion without jumps of a turn, near where it was before."""
    here: Array = np.atleast_1d(np.asarray(angle, dtype=np.float64))
    before = np.concatenate(([angles.get(key, float(here[0]))], here[:-1]))
    going: Array = here - TURN * np.cumsum(np.round((here - before) / TURN))
    angles[key] = float(going[-1])
    return going if np.ndim(angle) else float(going[0])
