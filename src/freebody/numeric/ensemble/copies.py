"""One copy of an ensemble: its state, how that begins and changes, and what is looked at.

    y = (coordinates, further coordinates that closed loops and rolling bind, speeds),      y' = f(t, y, p)

with the parameters p that differ from copy to copy. Everything is an operation on the entries of y and p; operations on
p alone are done once for a copy.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from freebody.numeric.engine.operations import OperationGraph, ProgramNode
from freebody.numeric.kernels.operations import INPUT, TIME


class CopyGraph(OperationGraph):
    """The operations of one copy. Inputs are the entries of its state, then its parameters."""

    def __init__(self, n_states: int, n_parameters: int) -> None:
        super().__init__()
        self.n_states, self.n_parameters = n_states, n_parameters
        self.time = self.node(TIME)
        self.states = [self.node(INPUT, k) for k in range(n_states)]
        self.parameters = [self.node(INPUT, n_states + k) for k in range(n_parameters)]
        self._moves: list[bool] = []

    def speed(self, entry: int) -> ProgramNode:
        raise TypeError("the equations of an ensemble are written out; nothing in it is differentiated again")

    def moves(self, at: int) -> bool:
        """Whether an operation changes along a motion."""
        for k in range(len(self._moves), at + 1):
            op, i, _j, _c = self.operation(k)
            takes = any(self._moves[part] for part in self._taken(k))
            self._moves.append(op == TIME or (op == INPUT and i < self.n_states) or takes)
        return self._moves[at]

    def taken(self, at: int) -> tuple[int, ...]:
        """The operations that one takes."""
        return self._taken(at)


@dataclass(frozen=True)
class Extreme:
    """The greatest (side +1) or the least (-1) value of a node along a motion, with its rate."""

    node: ProgramNode
    rate: ProgramNode
    side: int


@dataclass(frozen=True)
class Copies:
    """start: y at t = 0, of parameters alone; rates: y'; units: the size of each entry [m or rad, for speeds by s];
    is_speed: which entries are speeds; watched: looked at at asked times; extremes: all along; positive: without which
    the equations are not those of the motion; gaps: what closed loops hold at zero, by its size."""

    graph: CopyGraph
    start: Sequence[ProgramNode]
    rates: Sequence[ProgramNode]
    units: Sequence[float]
    is_speed: Sequence[bool]
    watched: Sequence[ProgramNode]
    extremes: Sequence[Extreme] = ()
    positive: Sequence[ProgramNode] = ()
    gaps: Sequence[ProgramNode] = ()
