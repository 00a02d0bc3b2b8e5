"""A phase of a motion that has been followed with its tangents, and what is seen at its instants."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from freebody.numeric.engine.operations import ProgramNode
from freebody.numeric.jets import Array
from freebody.numeric.tangent.equations import Equations, Matrices, column
from freebody.numeric.tangent.phase import PhaseTangent, Tangent

Written = Callable[[Equations], Sequence[ProgramNode]]


@dataclass(frozen=True)
class Seen:
    """Some expressions at instants: values and rates along the motion (n, m), changes by the names at fixed times
    (n, m, k)."""

    values: Array
    rates: Array
    changes: Array


@dataclass(frozen=True)
class PassedPhase:
    """A phase of a motion with its tangents."""

    equations: Equations
    phase: PhaseTangent
    tangent: Tangent

    def seen(self, written: Written) -> Seen:
        """What some expressions come to at the ends of all panels."""
        nodes, of, x = written(self.equations), self.tangent, self.equations
        parts = x.columns.parts("", nodes)
        inputs = of.inputs
        D = Matrices(x.writer, {"x": column(nodes), **parts}).at(inputs, of.times, of.angles)
        D["p"] = self.phase.by_names(D["p"])
        v = np.stack([np.broadcast_to(inputs[x.writer.velocity(e)], len(of.times)) for e in x.writer.entries], axis=1)
        a = of.unknowns[:, : len(x.writer.entries)]
        rates = D["q"] @ v[:, :, None] + D["v"] @ a[:, :, None] + D["u"] @ of.slopes[:, :, None] + D["t"]
        changes = D["q"] @ of.q + D["v"] @ of.v + D["u"] @ of.u + D["p"]
        return Seen(D["x"][:, :, 0], rates[:, :, 0], changes)
