"""The tangents of a motion in one mode: how its states change with the names that vary.

What is held leaves some coordinates free; their changes x = (dq_I, dv_I) follow a linear equation, and all others
follow from them by what is held: no change leaves the constraints. In space dq of a body that turns is the turn d
theta along its axes, d/dt d theta = d omega - omega x d theta.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from importlib import import_module
from typing import Any

import numpy as np

from freebody.numeric.jets import Array
from freebody.numeric.kernels import linearising
from freebody.numeric.kernels.arrays import ints
from freebody.numeric.kernels.linearising import FreeCoordinates
from freebody.numeric.tangent.collocation import N_PLACES, instants, propagated
from freebody.numeric.tangent.equations import Equations, checked
from freebody.numeric.tangent.tapes import Angles, Inputs

STRIDE = N_PLACES + 1  # instants of a panel, one of its ends with them
WELL_POSED = 30.0  # so much larger than at the beginning the dependent changes may get before others are chosen free
NOTHING = 1e-6  # of the size of a system: where so little changes if a name is doubled, nothing hangs on it


@dataclass(frozen=True)
class Tangent:
    """At the ends of some panels: times (n,), changes dq, dv (n, n_coordinates, k) and du (n, n_unknowns, k) by every
    name at fixed times; u (n, n_unknowns); inputs: all that expressions read there."""

    times: Array
    q: Array
    v: Array
    u: Array
    unknowns: Array
    inputs: dict[int, Array | float]
    slopes: Array  # (n, n_unknowns) of the unknowns along the motion
    off: Array  # (n - 1,) how far off each panel was
    kept: Array  # (n_places, k) changes of held measures at the start
    parted: Array  # (n_rows, k) changes of their rates there, which have to vanish
    angles: Angles  # of lines at the start and at the end
    after: Angles


@dataclass(frozen=True)
class _Instants:
    """A phase as kernels read it, at the ends of its panels and the places between."""

    ends: Array
    times: Array
    rows: Array  # (n_inputs, n)
    turns: Array  # of lines
    kept: Array  # (n_places, k) changes of held measures that stay as they are

    def before(self, panel: int, lines: Sequence[int]) -> Angles:
        """Angles of lines before a panel."""
        return dict(zip(lines, self.turns[:, panel * STRIDE].tolist(), strict=True))


class PhaseTangent:
    """One phase of a motion, in one mode."""

    def __init__(self, equations: Equations, origins: Array, unit: Array) -> None:
        """origins: (n_origins, k) changes of where measures count from; unit: (n,) moves of unit size."""
        self.equations, self.origins, self.unit = equations, origins, unit
        w = equations.writer
        sizes = np.abs([w.numbers.values[name] or 1.0 for name in w.varied])
        self.least = NOTHING * float(unit.max()) / sizes  # changes, by each name, that do not count

    def along(self, ends: Array, inputs: Inputs, angles: Angles, dq: Array, dv: Array) -> Tangent:
        """Tangents at the ends of panels. inputs: at `instants(ends)`; angles: of lines before the first of them; dq,
        dv: (n, k) there. Raises CannotAnswer where there are none."""
        e, n, times = self.equations, len(self.unit), instants(ends)
        held = {key: x[0] for key, x in e.held.at(_at(inputs, 0), times[:1], angles).items()}
        kept = held["gq"] @ dq + self.by_names(held["gp"])
        parted = held["rq"] @ dq + held["J"] @ dv + self.by_names(held["rp"])
        of = _Instants(ends, times, e.rows_of(inputs, len(times)), e.tape.turns(angles, len(times)), kept)
        first, jacobian, off, parts = 0, held["J"], list[Array](), list[Array]()
        while first < len(ends) - 1:
            if first:
                before, here = of.before(first, e.tape.angles), slice(first * STRIDE, first * STRIDE + 1)
                jacobian = e.held.at(_at(inputs, here), times[here], before)["J"][0]
            changes, was_off = self._part(of, first, self._chosen(jacobian), dq, dv)
            first += len(was_off)
            dq, dv = changes[-1, :n, :-1], changes[-1, n : 2 * n, :-1]
            parts.append(changes if first == len(ends) - 1 else changes[:-1])
            off.append(was_off)
        changes = np.concatenate(parts)
        return Tangent(
            ends,
            changes[:, :n, :-1],
            changes[:, n : 2 * n, :-1],
            changes[:, 2 * n :, :-1],
            np.ascontiguousarray(of.rows[e.program.unknowns, ::STRIDE].T),
            _at(inputs, slice(None, None, STRIDE)) | dict(zip(e.tape.inputs, of.rows[:, ::STRIDE], strict=True)),
            changes[:, 2 * n :, -1],
            np.concatenate(off),
            kept,
            parted,
            angles,
            dict(zip(e.tape.angles, of.turns[:, -1].tolist(), strict=True)),
        )

    def _part(self, of: _Instants, first: int, free: FreeCoordinates, dq: Array, dv: Array) -> tuple[Array, Array]:
        """From a panel on, as long as the free coordinates are well chosen: changes of q, v and u by the names, and
        their own rates (n_ends, n + n + n_u, k + 1), and how far off the panels are."""
        e, k, begin = self.equations, dq.shape[1], first * STRIDE
        f, n_maps, n_ends = len(free.q) + len(free.v), 2 * len(self.unit) + len(e.program.unknowns), len(of.ends)
        F, maps = np.empty(((len(of.times) - begin) * f, f + k)), np.zeros((n_ends * n_maps, f + k + 1))
        done = checked(
            linearising.linearised(
                *(e.program, e.room(f + k + 1), free, of.rows, of.times, of.turns, of.kept, self.origins, self.unit),
                *(F, maps, begin, STRIDE, WELL_POSED),
            )
        )
        last = n_ends - 1 if done == len(of.times) else first + max(1, (done - 1 - begin) // STRIDE)
        x, off = propagated(of.ends[first : last + 1], F, np.concatenate((dq[free.q], dv[free.v])), self.least)
        T = maps.reshape(n_ends, n_maps, -1)[first : last + 1]
        return np.concatenate((T[:, :, :f] @ x + T[:, :, f:-1], T[:, :, -1:]), axis=2), off

    def by_names(self, of: Array) -> Array:
        """Derivatives by parameters and by where measures count from, as derivatives by the names alone."""
        k = self.origins.shape[1]
        return of[..., :k] + of[..., k:] @ self.origins[: of.shape[-1] - k]

    # -- what is free -------------------------------------------------------------------------
    def _chosen(self, J: Array) -> FreeCoordinates:
        """The coordinates that are left free: those by which the others are determined best."""
        every = range(len(self.unit))
        q, v = self._free(J[self.equations.places]), self._free(J)
        return FreeCoordinates(
            ints(q), ints(v), ints([i for i in every if i not in q]), ints([i for i in every if i not in v])
        )

    def _free(self, J: Array) -> list[int]:
        linalg: Any = import_module("scipy.linalg")
        n = len(self.unit)
        if not len(J):
            return list(range(n))
        order = linalg.qr(J * self.unit, mode="r", pivoting=True)[1].tolist()
        return sorted(order[len(J) :])


def _at(inputs: Inputs, of: Any) -> dict[int, Array | float]:
    """Inputs at some of the instants."""
    return {key: x[of] if isinstance(x, np.ndarray) else x for key, x in inputs.items()}
