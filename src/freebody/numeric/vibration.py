"""What the linear equations M z'' + C z' + K z = 0 say: natural motions, and whether a rest is stable.

In coordinates y with M = 1, motions y = Re(a e^(s t)) have s^2 a + s C a + K a = 0. Without C and with a symmetric K
that is an ordinary symmetric problem with s^2 = -omega^2; otherwise s are eigenvalues of the state matrix.

    oscillation     s = -zeta omega +- i omega sqrt(1 - zeta^2)        omega = |s|, zeta = -Re s/|s|
    creeping        s < 0, a real rate (of an overdamped pair two)
    growing         Re s > 0
    rigid           K a = 0: it stays wherever it is put, or drifts on

Stability of a rest, where K is symmetric and C dissipates (C + C^T >= 0): it is stable if K is positive definite, for
then the energy has a minimum (Lagrange, Dirichlet; damped and gyroscopic by Kelvin, Tait and Chetaev). If not, the
largest real part of the state matrix decides; a zero one leaves it open, except along a whole family of rests.
Source: Meirovitch, Methods of Analytical Dynamics, 1970, ch. 5 and 6; Chetaev, The Stability of Motion, 1961.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from freebody.numeric.jets import Array
from freebody.numeric.small_motion import SmallMotion
from freebody.tolerances import ROUND_OFF, ROUNDED

Kind = Literal["oscillation", "rigid", "creeping", "growing"]
Verdict = Literal["stable", "unstable", "neutral", "undecided by the linearisation"]

_ASYMMETRY = 1e-8  # of the largest stiffness: what finite differences leave
_UNDAMPED = 1e-13  # of the root of the largest stiffness: damping below this has no part in the motion
_NONE = 1e-10  # of the largest damping, or of a rate: a power or a growth that is none
_PURE = 1e-14  # of the largest rate: the real part that eigenvalues of an undamped motion are left with
_ZERO_RATE = 1e-6  # of the fastest rate: what rounding makes of a double zero


@dataclass(frozen=True)
class NaturalMotion:
    """One natural motion: z = Re(shape e^(rate t)); `motion` is the same in the absolute coordinates q."""

    rate: complex
    kind: Kind
    motion: NDArray[np.complex128]


@dataclass(frozen=True)
class Stability:
    """Whether a rest is stable, and the eigenvalue that says so."""

    verdict: Verdict
    eigenvalue: complex | None
    of: Literal["stiffness", "state matrix", ""]  # K by the masses [1/s^2], or A [1/s]
    motion: Array | None  # in q, of that eigenvalue
    soft: tuple[Array, ...] = ()  # motions in q without stiffness


def natural_motions(small: SmallMotion) -> list[NaturalMotion]:
    """All natural motions, slowest first; of a conjugate pair one. Raises CannotAnswer where inertia is missing."""
    if not small.order:
        return []
    small.A  # noqa: B018 (raises without inertia)
    if len(small.positions) == len(small.speeds):
        T, K, C = _by_the_masses(small)
        if _is_symmetric(K) and np.abs(C).max() <= _UNDAMPED * math.sqrt(float(np.abs(K).max()) or 1.0):
            found = _undamped(small, T, K)
        else:
            found = _damped(small, T, K, C)
    else:
        found = _general(small)
    return sorted(found, key=lambda m: (m.kind != "rigid", abs(m.rate)))


def stability(small: SmallMotion) -> Stability:
    """Whether the rest about which `small` is linearised is stable."""
    if not small.speeds:
        return Stability("stable", None, "", None)
    if len(small.positions) > len(small.speeds):
        return _by_rates(small, "neutral")
    K, C = small.stiffness, small.damping
    dissipates = float(np.linalg.eigvalsh(C + C.T)[0]) >= -_NONE * float(np.abs(C).max())
    if not _is_symmetric(K, small.noise) or not dissipates:
        return _by_rates(small, "undecided by the linearisation")
    values, vectors = np.linalg.eigh((K + K.T) / 2.0)
    lowest, motion = float(values[0]), small.split.null @ vectors[:, 0]
    soft = tuple(small.split.null @ vectors[:, k] for k in range(len(values)) if abs(values[k]) <= small.noise)
    if lowest > small.noise:
        return Stability("stable", lowest, "stiffness", motion)
    if lowest >= -small.noise:
        return Stability("neutral", 0.0, "stiffness", motion, soft)
    if np.abs(C - C.T).max() <= _NONE * np.abs(C).max():
        return Stability("unstable", lowest, "stiffness", motion, soft)
    return replace(_by_rates(small, "undecided by the linearisation"), soft=soft)


def _by_rates(small: SmallMotion, otherwise: Verdict) -> Stability:
    """By the natural motion that grows fastest or decays slowest."""
    motions = natural_motions(small)
    fastest = max(abs(m.rate) for m in motions) or 1.0
    worst = max(motions, key=lambda m: m.rate.real)
    growth = worst.rate.real
    verdict: Verdict = otherwise
    if growth > ROUND_OFF * fastest and worst.kind != "rigid":
        verdict = "unstable"
    elif growth < -ROUND_OFF * fastest and otherwise != "neutral":
        verdict = "stable"
    return Stability(verdict, worst.rate, "state matrix", np.asarray(worst.motion.real, dtype=np.float64))


def _is_symmetric(K: Array, noise: float = 0.0) -> bool:
    return bool(np.abs(K - K.T).max(initial=0.0) <= _ASYMMETRY * np.abs(K).max(initial=0.0) + noise)


def _by_the_masses(small: SmallMotion) -> tuple[Array, Array, Array]:
    """T, K and C of coordinates y with z = T y and M = 1."""
    T = np.linalg.inv(np.linalg.cholesky(small.M)).T.astype(np.float64)
    return T, T.T @ small.K @ T, T.T @ small.C @ T


def _undamped(small: SmallMotion, T: Array, K: Array) -> list[NaturalMotion]:
    values, vectors = np.linalg.eigh((K + K.T) / 2.0)
    found: list[NaturalMotion] = []
    for square, y in zip(values.tolist(), vectors.T, strict=True):
        motion = small.unit_speeds @ (T @ y) + 0j
        if abs(square) <= small.noise:
            found.append(NaturalMotion(0j, "rigid", motion))
        elif square > 0.0:
            found.append(NaturalMotion(1j * math.sqrt(square), "oscillation", motion))
        else:
            found.append(NaturalMotion(math.sqrt(-square) + 0j, "growing", motion))
    return found


def _damped(small: SmallMotion, T: Array, K: Array, C: Array) -> list[NaturalMotion]:
    n = len(K)
    pace = max(math.sqrt(float(np.abs(K).max())), float(np.abs(C).max())) or 1.0
    rates, vectors = _eig(np.block([[np.zeros((n, n)), pace * np.eye(n)], [-K / pace, -C]]))
    _U, sizes, Vt = np.linalg.svd(K)
    loose = Vt[sizes <= small.noise]
    found = [NaturalMotion(0j, "rigid", small.unit_speeds @ (T @ y) + 0j) for y in loose]
    order = np.argsort(np.abs(rates))
    n_zero = int(np.count_nonzero(np.abs(rates) <= _ZERO_RATE * pace))
    n_zero = min(2 * len(loose), max(len(loose), n_zero))
    found += [
        _moving(complex(rates[k]), small.unit_speeds @ (T @ vectors[:n, k]), pace)
        for k in order[n_zero:]
        if rates[k].imag >= 0.0
    ]
    return found


def _general(small: SmallMotion) -> list[NaturalMotion]:
    """Where velocities are bound more than positions, every disturbance of a position that no speed follows rests."""
    n = len(small.positions)
    rates, vectors = _eig(small.A)
    pace = max(float(np.abs(rates).max()), math.sqrt(small.load_stiffness)) or 1.0
    order = np.argsort(np.abs(rates))
    n_zero = max(n - len(small.speeds), int(np.count_nonzero(np.abs(rates) <= _ZERO_RATE * pace)))
    found = [NaturalMotion(0j, "rigid", small.dq @ vectors[:, k]) for k in order[:n_zero]]
    moving = [k for k in order[n_zero:] if rates[k].imag >= 0.0]
    return found + [_moving(complex(rates[k]), small.dq @ vectors[:, k], pace) for k in moving]


def _moving(rate: complex, motion: NDArray[np.complex128], pace: float) -> NaturalMotion:
    if abs(rate.imag) <= ROUNDED * abs(rate):
        rate = complex(rate.real)
    if abs(rate.real) <= _PURE * pace:
        rate = complex(0.0, rate.imag)
    kind: Kind = "oscillation" if rate.imag else "creeping"
    return NaturalMotion(rate, "growing" if rate.real > _NONE * abs(rate) else kind, motion)


def _eig(A: Array) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
    found: Any = np.linalg.eig(A)
    return found[0].astype(np.complex128), found[1].astype(np.complex128)
