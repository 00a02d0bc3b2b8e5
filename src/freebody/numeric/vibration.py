"""What the linear equations M z'' + C z' + K z = 0 say: natural motions, and whether a rest is stable.

In coordinates y with M = 1, motions y = Re(a e^(s t)) have s^2 a + s C a + K a = 0. Without C and with a symmetric K
that is an ordinary symmetric problem with s^2 = -omega^2; otherwise s are eigenvalues of the state matrix.

    oscillation     s = -zeta omega +- i omega sqrt(1 - zeta^2)        omega = |s|, zeta = -Re s/|s|
    creeping        s < 0, a real rate (of an overdamped pair two)
    growing         Re s > 0
    rigid           K a = 0: it stays wherever it is put, or drifts on

Motions of one rate are a space, of which any basis would do: told are those of which each moves one coordinate that the
others leave alone, of the coordinates in their order (the reduced echelon form); those that swing are made independent
by the masses, one after the other. Where velocities are bound more than positions, the directions in which it drifts
come first, then those in which it only stays where it is put.

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
_STEADY = 1e-10  # of the fastest rate: what finite differences leave of none
_OWN = 1e-6  # of a disturbance: a part that is none
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
    if small.of_states:
        found = [m for m in found if not (m.kind == "rigid" and _is_of_states(small, m))]
    return sorted(found, key=lambda m: (m.kind != "rigid", float(f"{abs(m.rate):.9g}"), m.rate.real))


def _is_of_states(small: SmallMotion, found: NaturalMotion) -> bool:
    """Whether only integrals of states stand elsewhere, which nobody sees."""
    z = np.abs(np.array([c.row @ found.motion for c in small.positions])) / small.units
    return float(np.delete(z, small.of_states).max(initial=0.0)) <= _OWN * float(z.max())


def stability(small: SmallMotion) -> Stability:
    """Whether the rest about which `small` is linearised is stable."""
    if not small.speeds:
        return Stability("stable", None, "", None)
    if len(small.positions) > len(small.speeds):
        return _by_rates(small, "neutral")
    if small.of_states:
        return _by_rates(small, "undecided by the linearisation")
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
    found: list[NaturalMotion] = []
    squares, vectors = np.linalg.eigh((K + K.T) / 2.0)
    same = ROUND_OFF * float(np.abs(squares).max(initial=0.0)) + small.noise
    shapes = _sized(small, T @ vectors)
    for group in np.split(np.arange(len(squares)), np.flatnonzero(np.diff(squares) > same) + 1):
        square = float(squares[group].mean())
        basis = _told_basis(small, shapes[:, group])
        if abs(square) <= small.noise:
            found += _rigid(small, basis)
            continue
        rate = 1j * math.sqrt(square) if square > 0.0 else math.sqrt(-square) + 0j
        kind: Kind = "oscillation" if square > 0.0 else "growing"
        found += [_motion_of(small, rate, kind, z) for z in _independent(basis, small.M)]
    return found


def _damped(small: SmallMotion, T: Array, K: Array, C: Array) -> list[NaturalMotion]:
    n = len(K)
    pace = max(math.sqrt(float(np.abs(K).max())), float(np.abs(C).max())) or 1.0
    rates, vectors = _eig(np.block([[np.zeros((n, n)), pace * np.eye(n)], [-K / pace, -C]]))
    loose = _null(K, small.noise)
    found = _rigid(small, _told_basis(small, _sized(small, T @ loose)))
    order = np.argsort(np.abs(rates))
    n_zero = int(np.count_nonzero(np.abs(rates) <= _ZERO_RATE * pace))
    n_zero = min(2 * loose.shape[1], max(loose.shape[1], n_zero))
    found += [
        _moving(complex(rates[k]), small.unit_speeds @ (T @ vectors[:n, k]), pace)
        for k in order[n_zero:]
        if rates[k].imag >= 0.0
    ]
    return found


def _general(small: SmallMotion) -> list[NaturalMotion]:
    """Where velocities are bound more than positions, every disturbance of a position that no speed follows rests."""
    n, units, pace, A = len(small.positions), *_of_one_unit(small)
    rates, vectors = _eig(np.where(np.abs(A) > ROUNDED, A, 0.0))
    order = np.argsort(np.abs(rates))
    n_zero = max(n - len(small.speeds), int(np.count_nonzero(np.abs(rates) <= _ZERO_RATE)))
    # those that stay, x with A x = 0, in positions: first those along which it drifts, A y with A^2 y = 0
    drifts, stays = A @ _null(A @ A, _STEADY), _null(A, _STEADY)
    found = _rigid(small, _told_basis(small, *(units[:n, None] * x[:n] for x in (drifts, stays))))
    moved = small.unit_places @ (units[:, None] * vectors)[:n]
    return found + [
        _moving(pace * complex(rates[k]), moved[:, k], pace) for k in order[n_zero:] if rates[k].imag >= 0.0
    ]


def _of_one_unit(small: SmallMotion) -> tuple[Array, float, Array]:
    """The units of the state, the fastest pace [1/s], and A in these and in its time."""
    which = [small.positions.index(c) for c in small.speeds]
    units, n = np.concatenate((small.units, small.units[which])), len(small.positions)
    A = small.A * units / units[:, None]
    pull, drag = (float(np.abs(x).max(initial=0.0)) for x in (A[n:, :n], A[n:, n:]))
    pace = max(math.sqrt(max(pull, small.load_stiffness)), drag) or 1.0
    units[n:] *= pace
    return units, pace, small.A * units / units[:, None] / pace


def _rigid(small: SmallMotion, basis: Array) -> list[NaturalMotion]:
    return [_motion_of(small, 0j, "rigid", z) for z in basis.T]


def _motion_of(small: SmallMotion, rate: complex, kind: Kind, z: Array) -> NaturalMotion:
    return NaturalMotion(rate, kind, (small.unit_places @ z).astype(np.complex128))


def _sized(small: SmallMotion, columns: Array) -> Array:
    """Disturbances of the size of the system each."""
    return columns / np.linalg.norm(columns / small.units[:, None], axis=0)


def _null(A: Array, cut: float) -> Array:
    """Orthonormal columns x with A x = 0, where singular values up to the cut are none."""
    _U, sizes, Vt = np.linalg.svd(A)
    return Vt[int(np.count_nonzero(sizes > cut)) :].T


def _told_basis(small: SmallMotion, *spaces: Array) -> Array:
    """The reduced echelon form of spaces of disturbances z, given by columns: each column is one in a coordinate of its
    own, in which the others of its space, and those of later ones, are zero."""
    basis, taken = np.zeros((len(small.units), 0)), list[int]()
    for columns in spaces:
        x = columns / small.units[:, None]
        x = left = x - basis @ x[taken]
        own: list[int] = []
        for k in range(len(x)):
            size = float(np.linalg.norm(left[k]))
            if left.shape[1] and size > _OWN:
                own.append(k)
                left = left @ np.linalg.qr((left[k] / size)[:, None], mode="complete")[0][:, 1:]
        basis, taken = np.hstack((basis, x @ np.linalg.pinv(x[own]))), taken + own
    return small.units[:, None] * basis


def _independent(basis: Array, M: Array) -> list[Array]:
    """The columns made orthogonal by the masses, each to those before it."""
    found: list[Array] = []
    for z in basis.T:
        for other in found:
            z = z - other * float(other @ M @ z) / float(other @ M @ other)
        found.append(z)
    return found


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
