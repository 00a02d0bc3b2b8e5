"""The tangents of a motion in one mode: how its states change with the names that vary.

What is held leaves some coordinates free; their changes x = (dq_I, dv_I) follow a linear equation, and all others
follow from them by what is held: no change leaves the constraints. In space dq of a body that turns is the turn d
theta along its axes, d/dt d theta = d omega - omega x d theta.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from importlib import import_module
from typing import Any

import numpy as np

from freebody.numeric.jets import Array
from freebody.numeric.tangent.collocation import N_PLACES, instants, propagated
from freebody.numeric.tangent.equations import Equations
from freebody.numeric.tangent.gradients import Angles, Inputs

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
class _Linear:
    """The linear equations at all instants of a phase."""

    D: dict[str, Array]
    kept: Array  # (n_places, k) changes of held measures that stay as they are
    turning: Array  # (n, n, n) of d theta' = d omega - turning d theta


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
        dv: (n, k) there."""
        times = instants(ends)
        e = self.equations
        u, inverse = e.solved(inputs, times, angles)
        after = dict(angles)
        full = e.with_unknowns(inputs, u)
        D = self._by_names(e.derivatives(full, times, angles, after)) | {"1/Ru": inverse}
        kept = D["gq"][0] @ dq + D["gp"][0]
        linear = _Linear(D, kept, self._turning(full, len(times)))
        q, v, du, off = [dq[None]], [dv[None]], list[Array](), list[Array]()
        for first, last, maps in self._parts(linear, len(ends) - 1):
            part, own = slice(first, last + 1), slice(first * (N_PLACES + 1), last * (N_PLACES + 1) + 1)
            Tq, Tv, U, free_q, free_v = maps
            f = len(free_q) + len(free_v)
            F = np.concatenate(((Tv - linear.turning[own] @ Tq)[:, free_q], U[:, free_v]), axis=1)
            x0 = np.concatenate((q[-1][-1][free_q], v[-1][-1][free_v]))
            x, was_off = propagated(ends[part], F[:, :, :f], F[:, :, f:], x0, self.least)
            at = slice(None, None, N_PLACES + 1)

            def of(T: Array, x: Array = x, f: int = f, at: slice = at) -> Array:
                return T[at][:, :, :f] @ x + T[at][:, :, f:]

            begin = 1 if first else 0
            q.append(of(Tq)[1:])
            v.append(of(Tv)[1:])
            du.append(of(U)[begin:])
            off.append(was_off)
        at_ends = slice(None, None, N_PLACES + 1)
        here: dict[int, Array | float] = {
            key: x[at_ends] if isinstance(x, np.ndarray) else x for key, x in full.items()
        }
        return Tangent(
            ends,
            np.concatenate(q),
            np.concatenate(v),
            np.concatenate(du),
            u[at_ends],
            here,
            self._slopes({key: x[at_ends] for key, x in D.items()}, here, u[at_ends]),
            np.concatenate(off),
            kept,
            D["rq"][0] @ dq + D["J"][0] @ dv + D["rp"][0],
            angles,
            after,
        )

    def _slopes(self, D: dict[str, Array], inputs: Inputs, u: Array) -> Array:
        """u' from R_u u' + R_q v + R_v a + R_t = 0."""
        w = self.equations.writer
        v = np.column_stack([np.broadcast_to(inputs[w.velocity(e)], len(u)) for e in w.entries])[:, :, None]
        a = u[:, : len(w.entries), None]
        return -(D["1/Ru"] @ (D["Rq"] @ v + D["Rv"] @ a + D["Rt"]))[:, :, 0]

    def by_names(self, of: Array) -> Array:
        """Derivatives by parameters and by where measures count from, as derivatives by the names alone."""
        k = self.origins.shape[1]
        return of[..., :k] + of[..., k:] @ self.origins[: of.shape[-1] - k]

    def _by_names(self, D: dict[str, Array]) -> dict[str, Array]:
        return {key: self.by_names(x) if key in ("Rp", "gp", "rp") else x for key, x in D.items()}

    def _turning(self, inputs: Inputs, n: int) -> Array:
        """omega x of every body in space that turns."""
        w = self.equations.writer
        found = np.zeros((n, len(w.entries), len(w.entries)))
        if not w.numbers.space:
            return found
        firsts = [i for i, entry in enumerate(w.entries) if entry % 6 == 3]
        for i in firsts:
            x, y, z = (np.broadcast_to(inputs[w.velocity(w.entries[i + j])], n) for j in range(3))
            found[:, i, i + 1], found[:, i, i + 2] = -z, y
            found[:, i + 1, i], found[:, i + 1, i + 2] = z, -x
            found[:, i + 2, i], found[:, i + 2, i + 1] = -y, x
        return found

    # -- what depends on what is free ---------------------------------------------------------
    def _parts(
        self, linear: _Linear, n_panels: int
    ) -> Iterator[tuple[int, int, tuple[Array, Array, Array, list[int], list[int]]]]:
        """Panels in a row with the same free coordinates: the first and the last end, and the maps from (dq_I, dv_I,
        names) to dq, dv and du at all instants of them."""
        first = 0
        while first < n_panels:
            own = slice(first * (N_PLACES + 1), None)
            places = self.equations.places
            free_q = self._free(linear.D["J"][own.start][places])
            free_v = self._free(linear.D["J"][own.start])
            inverse = self._inverse(linear.D["J"][own][:, places], free_q)
            inverse_v = (
                inverse if len(places) == len(self.equations.rows) else self._inverse(linear.D["J"][own], free_v)
            )
            sizes = np.maximum(*(np.abs(x).max(axis=(1, 2), initial=0.0) for x in (inverse, inverse_v)))
            bad = np.flatnonzero(sizes > WELL_POSED * max(1.0, float(sizes[: N_PLACES + 2].max())))
            last = n_panels if not len(bad) else first + max(1, int(bad[0] - 1) // (N_PLACES + 1))
            part = slice(own.start, last * (N_PLACES + 1) + 1)
            n = part.stop - part.start
            yield first, last, self._maps(linear, part, inverse[:n], inverse_v[:n], free_q, free_v)
            first = last

    def _free(self, J: Array) -> list[int]:
        """The coordinates that are left free: those by which the others are determined best."""
        linalg: Any = import_module("scipy.linalg")
        n = len(self.unit)
        if not len(J):
            return list(range(n))
        order = linalg.qr(J * self.unit, mode="r", pivoting=True)[1].tolist()
        return sorted(order[len(J) :])

    def _inverse(self, J: Array, free: list[int]) -> Array:
        """(n, n, n) dq from the changes of what is held and of the free coordinates, both in units of size."""
        picked = np.broadcast_to(np.eye(len(self.unit))[free], (len(J), len(free), len(self.unit)))
        scaled = np.concatenate((J * self.unit, picked), axis=1)
        try:
            return np.asarray(np.linalg.inv(scaled), dtype=np.float64)
        except np.linalg.LinAlgError:  # in one of them others have to be free
            return np.array([_inverse_or_endless(one) for one in scaled])

    def _maps(
        self, linear: _Linear, part: slice, inverse: Array, inverse_v: Array, free_q: list[int], free_v: list[int]
    ) -> tuple[Array, Array, Array, list[int], list[int]]:
        D = {key: x[part] for key, x in linear.D.items()}
        n, k = len(inverse), linear.kept.shape[1]
        n_q, n_v, unit = len(free_q), len(free_v), self.unit
        held = np.zeros((n, len(unit), n_q + n_v + k))
        held[:, : len(unit) - n_q, n_q + n_v :] = linear.kept - D["gp"]
        held[:, len(unit) - n_q :, :n_q] = np.diag(1.0 / unit[free_q])
        Tq = unit[:, None] * (inverse @ held)
        held = np.zeros((n, len(unit), n_q + n_v + k))
        names = np.zeros((n, len(unit) - n_v, n_q + n_v + k))
        names[:, :, n_q + n_v :] = D["rp"]
        held[:, : len(unit) - n_v] = -(D["rq"] @ Tq + names)
        held[:, len(unit) - n_v :, n_q : n_q + n_v] = np.diag(1.0 / unit[free_v])
        Tv = unit[:, None] * (inverse_v @ held)
        right = D["Rq"] @ Tq + D["Rv"] @ Tv
        right[:, :, n_q + n_v :] += D["Rp"]
        return Tq, Tv, -(D["1/Ru"] @ right), free_q, free_v


def _inverse_or_endless(A: Array) -> Array:
    try:
        return np.asarray(np.linalg.inv(A), dtype=np.float64)
    except np.linalg.LinAlgError:
        return np.full_like(A, np.inf)
