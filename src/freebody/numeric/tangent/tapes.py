"""Operations as kernels play them, at many instants of a motion at once."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from freebody.numeric.engine.operations import OperationGraph, ProgramNode
from freebody.numeric.jets import Array
from freebody.numeric.kernels import playing
from freebody.numeric.kernels.arrays import floats, ints
from freebody.numeric.kernels.operations import ARGUMENT, CONSTANT, INPUT

WIDTH = 16  # instants by each operation: their registers should stay in the processor's cache
Inputs = Mapping[int, "Array | float"]
Angles = Mapping[int, float]
NO_ANGLES: Angles = {}


@dataclass(frozen=True)
class Tape:
    """The operations that some results need."""

    code: NDArray[np.int32]  # (n, 4), see `kernels.playing`
    numbers: Array
    parts: NDArray[np.int32]  # where the operations of each part begin, and their end
    register: Mapping[int, int]  # of an operation of the graph
    constants: Mapping[int, float]  # by register
    inputs: tuple[int, ...]  # which inputs the rows are
    angles: tuple[int, ...]  # which operations of the graph are angles that are counted on

    def rows(self, inputs: Inputs, n: int) -> Array:
        """(n_inputs, n) what is read at n instants; inputs that are not given are zero."""
        found = np.zeros((len(self.inputs), n))
        for row, entry in enumerate(self.inputs):
            found[row] = inputs.get(entry, 0.0)
        return found

    def turns(self, angles: Angles, n: int) -> Array:
        """(n_angles, n + 1) room for angles, with what they were before the first instant."""
        found = np.full((len(self.angles), n + 1), np.nan)
        found[:, 0] = [angles.get(k, np.nan) for k in self.angles]
        return found

    def registers(self) -> Array:
        """Room for all results at some instants."""
        found = np.zeros((len(self.register), WIDTH))
        for k, c in self.constants.items():
            found[k] = c
        return found


def taped(
    graph: OperationGraph,
    parts: Sequence[Sequence[ProgramNode]],
    changing: Collection[int] = (),
    further: Sequence[int] = (),
) -> Tape:
    """Parts that are played one after the other. changing: inputs that are others from the second part on, so that what
    depends on them is played again; further: inputs that get a row whether they are read or not."""
    lists = list(_listed(graph, parts, changing))
    needed = sorted(set[int]().union(*lists))
    ops = {k: graph.operation(k) for k in needed}
    register = {k: place for place, k in enumerate(needed)}
    entries = list(dict.fromkeys([*further, *(ops[k][1] for k in needed if ops[k][0] == INPUT)]))
    angles = [k for k in needed if ops[k][0] == ARGUMENT]
    row, place = ({key: i for i, key in enumerate(of)} for of in (entries, angles))

    code, numbers, ends = list[tuple[int, int, int, int]](), list[float](), [0]
    for own in lists:
        for k in own:
            op, i, j, c = ops[k]
            if op != CONSTANT:
                left = row[i] if op == INPUT else register.get(i, 0)
                code.append((op, register[k], left, register.get(j, 0)))
                numbers.append(float(place[k]) if op == ARGUMENT else c)
        ends.append(len(code))
    constants = {register[k]: c for k, (op, _i, _j, c) in ops.items() if op == CONSTANT}
    return Tape(ints(code, 2, 4), floats(numbers), ints(ends), register, constants, tuple(entries), tuple(angles))


def _listed(
    graph: OperationGraph, parts: Sequence[Sequence[ProgramNode]], changing: Collection[int]
) -> Iterator[list[int]]:
    """The operations of each part, in their order."""
    played, moved = set[int](), set[int]()  # moved: operations that depend on what changes
    for results in parts:
        own = graph.below(*results)
        for k in own if changing else ():
            op, i, _j, _c = graph.operation(k)
            if (op == INPUT and i in changing) or graph.takes(k) & moved:
                moved.add(k)
        yield [k for k in own if k not in played or k in moved]
        played.update(own)


class Played:
    """Some results of a graph, evaluated at many instants at once."""

    def __init__(self, graph: OperationGraph, results: Sequence[ProgramNode]) -> None:
        self._tape = taped(graph, [results])
        self._results = ints([self._tape.register[result.at] for result in results])

    def at(
        self, inputs: Inputs, times: Array, angles: Angles = NO_ANGLES, after: dict[int, float] | None = None
    ) -> Array:
        """(n, n_results) values. inputs: of the entries of a state, (n,) or one number each; angles: those of lines
        before the first instant, by operation, from which they are counted on; after: gets those at the last one."""
        tape, n = self._tape, len(times)
        found, turns = np.empty((n, len(self._results))), tape.turns(angles, n)
        playing.played(
            tape.code, tape.numbers, tape.rows(inputs, n), times, turns, tape.registers(), self._results, found
        )
        if after is not None:
            after.update(zip(tape.angles, turns[:, -1].tolist(), strict=True))
        return found
