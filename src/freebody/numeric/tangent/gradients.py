"""Gradients of operations, written by the same operations backward through them.

With w the derivative of the result by an operation, each one that it takes gets w times the partial derivative:

    d(x y): w y to x, w x to y;   d(x/y): w/y to x, -w (x/y)/y to y;   d arg(x, y): -w y/r^2 to x, w x/r^2 to y.

Source: Griewank & Walther, Evaluating Derivatives, 2nd ed. 2008, ch. 3.
"""

from __future__ import annotations

from collections.abc import Sequence

from freebody.numeric.engine.operations import OperationGraph, ProgramNode
from freebody.numeric.kernels.operations import (
    ADD,
    ARGUMENT,
    CONSTANT,
    DIVIDE,
    INPUT,
    MULTIPLY,
    POWER,
    SUBTRACT,
    TIME,
)

BY_TIME = -1  # the key of the derivative by the time itself, where others are entries of the state
Gradient = dict[int, ProgramNode]


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
