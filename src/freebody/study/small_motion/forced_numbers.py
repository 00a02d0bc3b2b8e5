"""The numeric route to forced oscillations: accelerations of the full system near the equilibrium, no formulas.

With z the coordinates as measures, their accelerations a(z, z', t) by the full system, z_e the equilibrium of the mean,

    a_c - i a_s = a(z_e, 0, 0) - a_m - i (a(z_e, 0, T/4) - a_m),        a_m = (a(z_e, 0, 0) + a(z_e, 0, T/2))/2,
    (-Omega^2 - da/dz - i Omega da/dz') Z = a_c - i a_s,

slopes by central differences, their mean over the same instants; a quantity swings by the same expansion. Where only
the first order in the size s of drives counts (`system/small_drives`), what is odd in them swings, but for s^2:

    s (a_c - i a_s) = (a(0) - a(T/2) - i (a(T/4) - a(3T/4)))/2.

Where something moves without inertia, as a gear between two elastic shafts or the node of a spring and a damper in
series, forces tell what accelerations do not: with z'' given, R(z, z', z'', t) is the force along the coordinates that
is wanting (d'Alembert: N^T (M a - F), J N = 0, G N = 1), and

    (dR/dz + i Omega dR/dz' - Omega^2 dR/dz'') Z = -(R_c - i R_s).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.numeric.instant import WithoutInertia, forces, gyroscopic
from freebody.numeric.jets import Array
from freebody.numeric.snapshot import Snapshot
from freebody.numeric.split import stack
from freebody.questions.base import Quantity
from freebody.study.answering.draws import Draw
from freebody.system.small_drives import SCALE
from freebody.system.system import System

_STEP = 1e-4  # rad, m, and by Omega of rates
_HARMONIC = 1e-6  # of what is read at four instants of a period
_RESONANT = 1e-6  # of the size of the slopes, whose round-off is some 1e-8

Complex = NDArray[np.complex128]


@dataclass(frozen=True)
class ForcedNumbers:
    """One draw, its measures at the equilibrium of the mean, and the frequency of the excitation [rad/s]."""

    system: System
    draw: Draw
    places: Sequence[tuple[Measure, float]]
    frequency: float

    def seen(self, z: Array, rates: Array, phase: float) -> Snapshot:
        """The full system where the coordinates have given places and rates, at a part of the period."""
        reference, t = self.draw.reference, phase * math.tau / self.frequency
        measures = [measure for measure, _value in self.places]
        q = reference.pose_near(self.draw.q, list(zip(measures, map(float, z), strict=True)), t)
        v = reference.velocities(q, list(zip(measures, map(float, rates), strict=True)), t, with_start=False)
        return self.draw.seen(reference.snapshot(q, v, t))

    def _accelerations(self, s: Snapshot) -> Array:
        return np.array([s.acceleration(measure) for measure, _value in self.places], dtype=np.float64)

    @cached_property
    def rest(self) -> Array:
        return np.array([value for _measure, value in self.places], dtype=np.float64)

    def _swing(self, read: Callable[[Snapshot], Array]) -> tuple[Array, Complex, Complex]:
        """Of what is read off a state: its mean at the equilibrium, its own swing, and its slopes along Z."""
        n, w = len(self.places), self.frequency
        zero: Array = np.zeros(n)
        start, quarter, half, last = (read(self.seen(self.rest, zero, phase)) for phase in (0.0, 0.25, 0.5, 0.75))
        mean = (start + half) / 2.0
        size = self.draw.values.get(SCALE)
        sizes = np.abs(start) + np.abs(quarter) + np.abs(half) + np.abs(last)
        if size is None and np.any(np.abs(quarter + last - 2.0 * mean) > _HARMONIC * np.maximum(sizes, 1.0)):
            raise CannotAnswer(Message("it does not swing harmonically about the equilibrium"))
        columns: list[Complex] = []
        for k in range(n):
            e = np.zeros(n)
            e[k] = _STEP
            slopes = [self._slope(read, z, u) for z, u in ((e, zero), (zero, w * e))]
            columns.append(slopes[0] + 1j * slopes[1])
        own = (start - mean) - 1j * (quarter - mean)
        if size is not None:
            own = ((start - half) - 1j * (quarter - last)) / (2.0 * size)
        return mean, own, np.array(columns).T

    def _slope(self, read: Callable[[Snapshot], Array], z: Array, u: Array) -> Array:
        """By a step _STEP, the mean of two instants half a period apart."""
        found = [read(self.seen(self.rest + e * z, e * u, phase)) for phase in (0.0, 0.5) for e in (1.0, -1.0)]
        return (found[0] - found[1] + found[2] - found[3]) / (4.0 * _STEP)

    @cached_property
    def motion(self) -> Complex:
        """Z. Raises CannotAnswer in resonance, where it would be round-off of the slopes that limits it."""
        try:
            _mean, forced, slopes = self._swing(self._accelerations)
            inertia: Complex = np.eye(len(self.places), dtype=np.complex128)
        except WithoutInertia:
            _mean, forced, slopes = self._swing(self._wanting)
            inertia = self._inertia
        matrix = -(self.frequency**2) * inertia - slopes
        sizes = np.linalg.svd(matrix, compute_uv=False)
        most = self.frequency**2 * float(np.abs(inertia).max(initial=0.0)) + float(np.abs(slopes).max(initial=0.0))
        if sizes[-1] <= _RESONANT * most:
            told = Message("resonance without damping: no oscillation stays steady, it grows with the time")
            raise CannotAnswer(told)
        found = np.linalg.solve(matrix, forced)
        return np.asarray(found, dtype=np.complex128)

    # -- where something moves without inertia ------------------------------------------------
    def _wanting(self, s: Snapshot, accelerations: Array | None = None) -> Array:
        """-R: the forces along the coordinates beside what they would take to be accelerated so."""
        reference, g, n = self.draw.reference, s.geometry, len(s.q)
        rows = [reference.gap(row, g) for row in reference.system.constraint_rows]
        marks = [reference.jet(g, measure) for measure, _value in self.places]
        wanted = np.zeros(len(marks)) if accelerations is None else accelerations
        known = np.linalg.pinv(stack([jet.row(n) for jet in (*rows, *marks)], n))
        bias = np.array([jet.bias for jet in (*rows, *marks)])
        a = known @ (np.concatenate((np.zeros(len(rows)), wanted)) - bias)
        free = known[:, len(rows) :]
        return free.T @ (forces(reference, g) + gyroscopic(reference, g) - reference.masses * a)

    @cached_property
    def _inertia(self) -> Complex:
        """dR/dz'', which R is linear in."""
        n = len(self.places)
        s = self.seen(self.rest, np.zeros(n), 0.0)
        still = self._wanting(s)
        return np.array([still - self._wanting(s, e) for e in np.eye(n)]).T.astype(np.complex128)

    def of(self, quantity: Quantity) -> complex:
        """A quantity's swing, re cos(Omega t) - im sin(Omega t)."""

        def read(s: Snapshot) -> Array:
            value = quantity.value(self.system, s)
            if isinstance(value, tuple):
                raise CannotAnswer(Message("a vector has no one amplitude; ask along a direction"))
            return np.array([float(value)])

        _mean, own, slopes = self._swing(read)
        return complex((slopes @ self.motion + own)[0])
