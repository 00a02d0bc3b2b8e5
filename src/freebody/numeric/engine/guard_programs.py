"""The programs by which guards are searched for their zeros."""

from __future__ import annotations

import numpy as np

from freebody.numeric.engine.operations import Program
from freebody.numeric.engine.writing import ArrayBuilder
from freebody.numeric.kernels import guarding
from freebody.numeric.kernels.arrays import ModelArrays, floats, ints, pointers


class GuardPrograms:
    """The programs of the guards of a layout that have some, gaps and slip rates, one behind the other."""

    def __init__(self, layout: ModelArrays, written: ArrayBuilder) -> None:
        kinds = layout.guard[:, 0]
        self.guards = np.flatnonzero((kinds == guarding.GUARD_VALUE) | (kinds == guarding.GUARD_RATE))
        self.each: list[Program] = []
        for g in self.guards.tolist():
            order = int(kinds[g] == guarding.GUARD_RATE)
            row, across = (int(layout.guard[g, k]) for k in (1, 2))
            sign, sign_across = (float(layout.guard_factor[g, k]) for k in (0, 2))
            self.each.append(written.program(row, order, sign, across, sign_across))
        codes = [program.code for program in self.each]
        self.inputs = ints(np.unique(np.concatenate([p.inputs for p in self.each])) if codes else [])
        self.ptr = pointers([code.tolist() for code in codes])
        self.code = ints(np.concatenate(codes) if codes else [], 2, 3)
        self.constants = floats(np.concatenate([p.constants for p in self.each]) if codes else [])
        self.longest = max(map(len, codes), default=1)
        self.n_turns = np.array([len(program.turns) for program in self.each], dtype=np.intp)
