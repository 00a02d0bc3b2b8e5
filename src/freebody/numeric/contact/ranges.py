"""Between which bounds every reaction may lie, where accelerations leave it open.

All forces of given accelerations are l0 + Z y with A Z = 0, which is J^T Z = 0, cut by the cones of contact and
friction. Low and high are two linear programs a row. A load |l_j| is cut into its two signs; a load |(l_i, l_j)| must
be determined, otherwise it is bounded by |l_i| + |l_j| and the range may be too wide (`is_exact` is false).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from enum import Enum
from itertools import product
from typing import Any

import numpy as np

from freebody.numeric.contact.problem import SLIPPING, Array, ContactProblem, FrictionProblemRow, Mode, RowState
from freebody.numeric.solvers import optimize
from freebody.tolerances import ROUND_OFF

_RANK = 1e-11  # of the matrix with unit diagonal
_CONSISTENT = ROUND_OFF  # of the terms of an equation: what it may miss
_DETERMINED = ROUND_OFF  # of unit null vectors: a force along which none reaches is determined
_OPTIMAL = 1e-10  # feasibility of a linear program, at the finest that its solver takes


class Feasible(Enum):
    """Whether any forces give the accelerations."""

    YES = "forces exist"
    NO_FORCES = "no forces at all give these accelerations"
    NO_ADMISSIBLE_FORCES = "forces exist, but none that contact and friction admit"


@dataclass(frozen=True, slots=True)
class ForceRanges:
    """low, high: (n,) the least and largest multiplier of every row, maybe infinite; NaN if there are none."""

    feasible: Feasible
    low: Array
    high: Array
    is_exact: bool = True

    @property
    def is_unique(self) -> bool:
        """Whether every multiplier is determined."""
        if self.feasible is not Feasible.YES:
            return False
        size = float(np.abs(np.append(self.low, self.high)).max(initial=0.0)) or 1.0
        return bool((self.high - self.low <= 1e-8 * size).all())


@dataclass(frozen=True, slots=True)
class _Cut:
    """left y <= right, or left y = right."""

    left: Array
    right: float
    is_equation: bool = False


def force_ranges(problem: ContactProblem, accelerations: Array, mode: Mode) -> ForceRanges:
    """The range of every multiplier at given accelerations (n,) of the rows.

    Open and absent rows carry nothing, closed ones push, sticking rubs stay within their static limits, slipping ones
    are at their kinetic ones. The accelerations of held rows are taken as 0. Never raises for lack of forces: see
    `feasible`. Two linear programs a row that is not determined.
    """
    n = problem.n
    target = np.array(accelerations, dtype=float)
    target[list(problem.held_rows)] = 0.0
    diagonal = problem.A.diagonal()
    D = 1.0 / np.sqrt(np.where(diagonal > 0.0, diagonal, 1.0))
    right = D * (target - problem.b)
    values, vectors = np.linalg.eigh(D[:, None] * problem.A * D)
    kept = values > _RANK * n * max(1.0, float(values[-1]))
    along = vectors[:, kept].T @ right
    lost = right - vectors[:, kept] @ along
    terms = max(float(np.abs(D * target).max(initial=0.0)), float(np.abs(D * problem.b).max(initial=0.0)))
    if float(np.abs(lost).max(initial=0.0)) > _CONSISTENT * terms:
        return _none(n, Feasible.NO_FORCES)
    l0 = D * (vectors[:, kept] @ (along / values[kept]))
    Z = D[:, None] * vectors[:, ~kept]
    size = (
        max((float(np.abs(l0).max(initial=0.0))), max((rub.constant for rub in problem.dry_friction), default=0.0))
        or 1.0
    )
    return _within_cones(problem, mode, l0 / size, Z / (np.abs(Z).max(initial=0.0) or 1.0), size)


def _within_cones(problem: ContactProblem, mode: Mode, l0: Array, Z: Array, size: float) -> ForceRanges:
    """The union of the ranges over the signs of the magnitudes that are open."""
    low, high = np.full(problem.n, np.inf), np.full(problem.n, -np.inf)
    is_exact = True
    for signs in _signs(problem, mode, l0, Z):
        cuts, is_tight = _cuts(problem, mode, l0, Z, size, signs)
        found = _bounds(l0, Z, cuts)
        if found is None:
            continue
        is_exact = is_exact and is_tight
        low, high = np.minimum(low, found[0]), np.maximum(high, found[1])
    if not np.isfinite(low).any() and (low == np.inf).all():
        return _none(problem.n, Feasible.NO_ADMISSIBLE_FORCES)
    return ForceRanges(Feasible.YES, size * low, size * high, is_exact)


def _none(n: int, feasible: Feasible) -> ForceRanges:
    return ForceRanges(feasible, np.full(n, np.nan), np.full(n, np.nan))


def _signs(problem: ContactProblem, mode: Mode, l0: Array, Z: Array) -> Iterator[dict[int, float]]:
    """Every choice of signs for the held rows whose magnitude is a load and whose force is open."""
    acting = [rub for rub in problem.dry_friction if mode[rub.row] is not RowState.ABSENT]
    rows = sorted({row for rub in acting for group in rub.magnitudes for row in group})
    free = [row for row in rows if float(np.abs(Z[row]).max(initial=0.0)) > _DETERMINED]
    determined = {row: float(np.sign(l0[row])) for row in rows if row not in free}
    for choice in product((1.0, -1.0), repeat=len(free)):
        yield {**determined, **dict(zip(free, choice, strict=True))}


def _cuts(
    problem: ContactProblem, mode: Mode, l0: Array, Z: Array, size: float, signs: dict[int, float]
) -> tuple[list[_Cut], bool]:
    """The conditions on y, and whether none of them is wider than the law."""
    cuts: list[_Cut] = []
    is_tight = True
    for row in problem.normals:
        cuts.append(_Cut(-Z[row], float(l0[row]), is_equation=mode[row] is RowState.OPEN))
    for row, sign in signs.items():
        cuts.append(_Cut(-sign * Z[row], sign * float(l0[row])))
    for rub in problem.dry_friction:
        T, slope = float(l0[rub.row]), Z[rub.row]
        state = mode[rub.row]
        if state is RowState.ABSENT:
            cuts.append(_Cut(slope, -T, is_equation=True))
            continue
        load, along, is_known = _load(rub, l0, Z, size, signs)
        is_tight = is_tight and is_known
        if state in SLIPPING and is_known:
            c = rub.kinetic[0] if state is RowState.FORWARD else -rub.kinetic[1]
            cuts.append(_Cut(slope + c * along, -T - c * load, is_equation=True))
            continue
        forward, backward = rub.static
        if state in SLIPPING:
            forward, backward = (rub.kinetic[0], 0.0) if state is RowState.FORWARD else (0.0, rub.kinetic[1])
        cuts.append(_Cut(-slope - forward * along, T + forward * load))
        cuts.append(_Cut(slope - backward * along, -T + backward * load))
    return cuts, is_tight


def _load(
    rub: FrictionProblemRow, l0: Array, Z: Array, size: float, signs: dict[int, float]
) -> tuple[float, Array, bool]:
    """L = load + along.y, and whether it is exact rather than an upper bound."""
    load, along, is_known = rub.constant / size, np.zeros(Z.shape[1]), True
    for j in rub.normals:
        load, along = load + float(l0[j]), along + Z[j]
    for group in rub.magnitudes:
        moving = [row for row in group if float(np.abs(Z[row]).max(initial=0.0)) > _DETERMINED]
        if not moving:
            load += float(np.linalg.norm(l0[list(group)]))
            continue
        is_known = is_known and len(group) == 1
        for row in group:
            load, along = load + signs[row] * float(l0[row]), along + signs[row] * Z[row]
    return load, along, is_known


def _bounds(l0: Array, Z: Array, cuts: list[_Cut]) -> tuple[Array, Array] | None:
    """Least and largest l0 + Z y within the cuts, or None if nothing is."""
    open_cuts: list[_Cut] = []
    for cut in cuts:
        if float(np.abs(cut.left).max(initial=0.0)) > _DETERMINED:
            open_cuts.append(cut)
        elif cut.right < -_CONSISTENT or (cut.is_equation and cut.right > _CONSISTENT):
            return None
    low, high = l0.copy(), l0.copy()
    if not Z.shape[1]:
        return low, high
    if _least(np.zeros(len(Z.T)), open_cuts) is None:
        return None
    for row in range(len(l0)):
        if float(np.abs(Z[row]).max()) <= _DETERMINED:
            continue
        # something is feasible, so what has no optimum is unbounded
        least, most = _least(Z[row], open_cuts), _least(-Z[row], open_cuts)
        low[row] = l0[row] + least if least is not None else -np.inf
        high[row] = l0[row] - most if most is not None else np.inf
    return low, high


def _least(cost: Array, cuts: list[_Cut]) -> float | None:
    """The least cost.y within the cuts, or None if nothing is or it is unbounded."""
    below, equal = [c for c in cuts if not c.is_equation], [c for c in cuts if c.is_equation]
    found: Any = optimize().linprog(
        cost,
        A_ub=np.array([c.left for c in below]) if below else None,
        b_ub=np.array([c.right for c in below]) if below else None,
        A_eq=np.array([c.left for c in equal]) if equal else None,
        b_eq=np.array([c.right for c in equal]) if equal else None,
        bounds=(None, None),
        method="highs",
        options={"primal_feasibility_tolerance": _OPTIMAL, "dual_feasibility_tolerance": _OPTIMAL},
    )
    return float(found.fun) if found.status == 0 else None
