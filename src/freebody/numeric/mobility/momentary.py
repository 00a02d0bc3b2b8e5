"""Poses near one in which rows depend on each other, and whether the dependence lasts to second order.

A circuit of rows J_c has one combination w^T J_c = 0. Along a velocity v that the mechanism allows the rows change so
that the combination stays zero to second order only if

    Q(v) = sum_k w_k  v . (Hess f_k) v = 0.

Where Q is not zero for all allowed v the dependence is of this pose: momentary. If Q has one sign only, no motion
leads along the v with Q(v) /= 0, for sum w_k f_k would grow: the freedom is infinitesimal, the structure shaky.
Where Q vanishes, poses near by decide.
Sources: Connelly & Whiteley, SIAM J. Discrete Math. 9, 1996, 453-491 (second-order rigidity and prestress); Wohlhart,
Mech. Mach. Theory 45, 2010, 1559-1577 (shaky mechanisms).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from freebody.errors import CannotAnswer
from freebody.model.elements import ConstraintRow, NonholonomicForm
from freebody.numeric.jet_geometry import JetGeometry
from freebody.numeric.jets import Array, Jet
from freebody.numeric.mobility.rank import gradients
from freebody.numeric.placing import PoseEquation
from freebody.numeric.reference import Reference
from freebody.numeric.split import Split
from freebody.tolerances import LEAST

SIZES = (0.01, 0.05, 0.2)  # of the moves to poses near by, by the size of the system
_CUT = 1e-7  # of rows and velocities of about one: what is below is none, at poses as good as they were assembled
FAR = 0.02  # part of a move that is asked for, below which no pose is taken to be in reach
N_SEEDS = 2
N_EXACT = 16  # freedoms up to which Q is found as a matrix, else along random velocities
N_RANDOM = 24


@dataclass(frozen=True)
class Neighbourhood:
    """How a mechanism, held by some rows, can move from a pose."""

    reference: Reference
    held: Sequence[ConstraintRow]
    q: Array
    t: float

    @cached_property
    def freedoms(self) -> Array:
        """(n_coordinates, n_freedoms): velocities that the mechanism allows, of about one by its size."""
        return Split(self._gradients(self.held), self.reference.sizes.unit_moves).null

    @property
    def is_rigid(self) -> bool:
        return not self.freedoms.shape[1]

    @property
    def poses(self) -> list[Array]:
        """Other poses that the mechanism reaches from here."""
        return [q for q, part in self._moved if part > FAR]

    @property
    def is_isolated(self) -> bool:
        """Whether poses were found, but only this one again."""
        return bool(self._moved) and not self.poses

    @cached_property
    def _moved(self) -> list[tuple[Array, float]]:
        """Poses after a move, and how far they are by the size of the system as a part of how far was asked."""
        found: list[tuple[Array, float]] = []
        if self.is_rigid:
            return found
        sizes, g, frame = self.reference.sizes, self._geometry(np.zeros_like(self.q)), self.reference.frame
        equations = [_kept(row, g) for row in self.held if not isinstance(row.measure, NonholonomicForm)]
        for size in SIZES:
            for seed in range(N_SEEDS):
                rng = np.random.default_rng(seed)
                along: Array = self.freedoms @ rng.standard_normal(int(self.freedoms.shape[1]))
                step = along * (size / (float(sizes.relative(along).max(initial=0.0)) or 1.0))
                with suppress(CannotAnswer):
                    here = self.reference.placing.placed(frame.moved(self.q, step), equations, self.t, g.angles).q
                    far = float(sizes.relative(frame.difference(here, self.q)).max(initial=0.0))
                    found.append((here, far / size))
        return found

    def second_order(self, circuit: Sequence[ConstraintRow]) -> tuple[bool, bool]:
        """Whether Q of a circuit takes positive and negative values."""
        if any(isinstance(row.measure, NonholonomicForm) for row in circuit):
            return False, False
        J = self._gradients(circuit) * self.reference.sizes.unit_moves
        scale = 1.0 / np.maximum(np.linalg.norm(J, axis=1), LEAST)
        w: Array = np.linalg.svd(scale[:, None] * J)[0][:, -1] * scale

        def second(v: Any) -> tuple[float, float]:
            """Q(v), and the size of what was added for it."""
            g = self._geometry(v)
            parts = [float(w[k]) * self.reference.gap(row, g).bias for k, row in enumerate(circuit)]
            return math.fsum(parts), math.fsum(map(abs, parts))

        values, size = _values(second, self.freedoms)
        cut = _CUT * max(1.0, size)
        return bool((values > cut).any()), bool((values < -cut).any())

    def _geometry(self, v: Array) -> JetGeometry:
        return self.reference.geometry(self.q, v, self.t)

    def _gradients(self, rows: Sequence[ConstraintRow]) -> Array:
        return gradients(self.reference, self.q, rows, self.t)


def _kept(row: ConstraintRow, g: JetGeometry) -> PoseEquation:
    """A row stays where it is; the tangents that it meets are counted on from here."""
    return PoseEquation.of(row.name, row.measure, Jet(g.of(row.measure).value))


def _values(second: Callable[[Any], tuple[float, float]], freedoms: Array) -> tuple[Array, float]:
    """Values of Q that show its signs: its eigenvalues, or those along random velocities."""
    f = freedoms.shape[1]
    if f > N_EXACT:
        rng = np.random.default_rng(0)
        found = [second(freedoms @ rng.standard_normal(f)) for _ in range(N_RANDOM)]
        return np.array([x for x, _ in found]), max(size for _, size in found)
    Q, size = np.zeros((f, f)), 0.0
    for i in range(f):
        Q[i, i], s = second(freedoms[:, i])
        size = max(size, s)
    for i in range(f):
        for j in range(i):
            both, s = second(freedoms[:, i] + freedoms[:, j])
            Q[i, j] = Q[j, i] = 0.5 * (both - Q[i, i] - Q[j, j])
            size = max(size, s)
    eigenvalues: Any = np.linalg.eigvalsh(Q)
    return eigenvalues, size
