"""One contact followed through its impact: slip as a function of the normal impulse.

With p the normal impulse, slip v, approach w (normal velocity) and friction dT = -s c dp while the slip has sign s,

    dv/dp = A_tn - s c A_tt          dw/dp = A_nn - s c A_tn

are constant until v = 0. Then the contact sticks, dT/dp = -A_tn/A_tt, if friction suffices for it, or slips on with the
sign of A_tn. So everything is piecewise linear in p and is followed exactly. Compression ends where w returns to zero.
It need not be a collision: where Painleve's paradox has no consistent force, w = 0 falls first (dw/dp < 0), slip
stops, and w returns. The restitution e compares the normal impulses of expansion and compression (Poisson).
Sources: Darboux 1880; J. B. Keller, J. Appl. Mech. 53 (1986) 1-4.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from freebody.numeric.contact.impulses import ImpactOutcome, impulsive, judged
from freebody.numeric.contact.problem import Array, ContactProblem, FrictionProblemRow, OutcomeCount, RowState
from freebody.numeric.contact.reduction import reduced


@dataclass(frozen=True, slots=True)
class _Phase:
    """From impulse p0 on: velocities v, w and the friction impulse T, with slopes dv, dw and `friction`."""

    p0: float
    v: float
    w: float
    T: float
    dv: float
    dw: float
    friction: float
    state: RowState


def impact_without_collision(problem: ContactProblem, restitution: float, *, slip: int = 0) -> ImpactOutcome:
    """Follows the impact of one contact.

    `problem.b`: velocities of all rows before, the normal one zero or approaching. `slip`: the sign of the slip rate,
    or of the slip that begins, where b is too small to tell it. Status NONE if the normal velocity never returns.
    Raises ValueError unless the problem has one normal, and one rub, loaded by it alone, or none (brakes do not count).
    """
    # one normal, and at most one rub that it alone loads
    kept = [row for row in range(problem.n) if row not in {rub.row for rub in impulsive(problem) if _is_idle(rub)}]
    followed = _of_rows(problem, kept)
    if len(followed.normals) != 1 or len(followed.dry_friction) > 1 or any(r.magnitudes for r in followed.dry_friction):
        raise ValueError("following an impact needs one normal, and one rub that it alone loads, or none")
    if any(rub.normals != followed.normals for rub in followed.dry_friction):
        raise ValueError("following an impact needs a rub that the normal alone loads")
    # the phases of slip, each linear in the normal impulse p [N s], up to the end of restitution
    system = reduced(followed)
    mode = [RowState.HELD] * problem.n
    for rub in problem.dry_friction:
        mode[rub.row] = RowState.ABSENT
    normal = problem.normals[0]
    mode[normal] = RowState.OPEN
    phases = _phases(system.A, system.b, _scaled_limits(followed, system.scale), slip) if system.is_consistent else []
    end = _end(phases, restitution) if phases else None
    if end is None:
        return judged(problem, OutcomeCount.NONE, tuple(mode), np.full(problem.n, np.nan), is_proven=True)
    # impulses of all rows (n,): those of the end of the phase in which it ends
    impulses = np.zeros(problem.n)
    if end > 0.0:
        last = next(phase for phase in reversed(phases) if phase.p0 <= end)
        x = np.array([end, last.T + last.friction * (end - last.p0)][: len(system.rows)])
        impulses[kept] = system.forces(x)
        mode[normal] = RowState.CLOSED
        for rub in followed.dry_friction:
            mode[kept[rub.row]] = last.state
    else:
        impulses[kept] = system.forces(np.zeros(len(system.rows)))
    return judged(problem, OutcomeCount.UNIQUE, tuple(mode), impulses, is_proven=True)


def _is_idle(rub: FrictionProblemRow) -> bool:
    """Whether a rub carries no impulse whatever happens: a brake."""
    return not rub.normals and not rub.magnitudes


def _of_rows(problem: ContactProblem, kept: list[int]) -> ContactProblem:
    """The problem without the rows of rubs that carry nothing."""
    place = {row: k for k, row in enumerate(kept)}
    dry_friction = tuple(
        replace(rub, row=place[rub.row], normals=tuple(place[j] for j in rub.normals))
        for rub in impulsive(problem)
        if not _is_idle(rub)
    )
    normals = tuple(place[row] for row in problem.normals)
    return ContactProblem(problem.A[np.ix_(kept, kept)], problem.b[kept], normals, dry_friction)


def _scaled_limits(problem: ContactProblem, scale: Array) -> tuple[float, float]:
    if not problem.dry_friction:
        return 0.0, 0.0
    weight = float(scale[0] / scale[1])
    forward, backward = problem.dry_friction[0].kinetic
    return weight * forward, weight * backward


def _phases(A: Array, b: Array, limits: tuple[float, float], slip: int) -> list[_Phase]:
    """Slip as long as it lasts, then sticking or slip the other way."""
    w = float(b[0])
    if len(b) == 1:
        return [_Phase(0.0, 0.0, w, 0.0, 0.0, float(A[0, 0]), 0.0, RowState.ABSENT)]
    v = float(b[1])
    sign = slip or int(np.sign(v))
    if sign == 0:
        return [_from_rest(A, limits, 0.0, 0.0, w, 0.0)]
    first = _sliding(A, limits, sign, 0.0, v, w, 0.0)
    if first.dv * sign >= 0.0:
        return [first]
    p = abs(v / first.dv)
    return [first, _from_rest(A, limits, p, 0.0, w + first.dw * p, first.friction * p)]


def _sliding(A: Array, limits: tuple[float, float], sign: int, p: float, v: float, w: float, T: float) -> _Phase:
    c = sign * limits[sign < 0]
    state = RowState.FORWARD if sign > 0 else RowState.BACKWARD
    return _Phase(p, v, w, T, float(A[0, 1] - c * A[1, 1]), float(A[0, 0] - c * A[0, 1]), -c, state)


def _from_rest(A: Array, limits: tuple[float, float], p: float, v: float, w: float, T: float) -> _Phase:
    """Sticks if -c_forward <= dT/dp = -A_tn/A_tt <= c_backward, else slips with the sign of A_tn."""
    a_nt, a_tt = float(A[0, 1]), float(A[1, 1])
    if a_nt > limits[0] * a_tt:
        return _sliding(A, limits, 1, p, v, w, T)
    if a_nt < -limits[1] * a_tt:
        return _sliding(A, limits, -1, p, v, w, T)
    stuck = -a_nt / a_tt if a_tt > 0.0 else 0.0
    return _Phase(p, v, w, T, 0.0, float(A[0, 0]) + stuck * a_nt, stuck, RowState.STICKING)


def _end(phases: list[_Phase], restitution: float) -> float | None:
    """The final normal impulse, (1 + e) times that of compression; None if compression never ends."""
    if phases[0].w >= 0.0 and phases[0].dw > 0.0:
        return 0.0
    ends = [*(phase.p0 for phase in phases[1:]), math.inf]
    for phase, end in zip(phases, ends, strict=True):
        returns = phase.p0 - phase.w / phase.dw if phase.dw > 0.0 else math.inf
        if phase.p0 <= returns <= end and math.isfinite(returns):
            return (1.0 + restitution) * returns
    return None
