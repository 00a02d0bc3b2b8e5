"""Rests of a system: poses in which the loads do no work on any motion that the connections allow.

With J the gradients of the held measures, N a basis of the free directions (J N = 0) and Q the generalized forces of
the loads at rest, virtual power says

    r(q) = N^T Q = 0,        and then  Q + J^T lambda = 0  gives the reactions.

Along the free directions  dr = -K dz,  K = -N^T [dQ/dq + lambda . Hess f] N  (geometric stiffness included). Roots
are found by damped Newton steps on |r|, each followed by a move onto the connections; minima of the potential, where
there is one, by Newton steps that go downhill. Time stands still at 0.
Source: Nikravesh, Computer-Aided Analysis of Mechanical Systems, 1988, sec. 10.5 (static equilibrium);
Nocedal & Wright, Numerical Optimization, 2nd ed. 2006, ch. 3 and 10 (line search, Levenberg-Marquardt).
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.numeric.instant import each_force, law
from freebody.numeric.jet_geometry import Branch, JetGeometry
from freebody.numeric.jets import Array, Jet
from freebody.numeric.placing import ACCEPTED, PoseEquation
from freebody.numeric.potential import potential
from freebody.numeric.small_motion import LinearisationPoint
from freebody.numeric.split import Split, stack
from freebody.tolerances import LEAST, ROUND_OFF

if TYPE_CHECKING:
    from freebody.numeric.reference import Reference

SAME = 1e-5  # poses nearer than this, by the size of the system, are one
FAR, FAR_ROUND = 1e5, 300.0  # beyond so many sizes, or radians, from where it began a search is given up
_REACH = 0.5  # of the first step of a search, in sizes or radians
_N_ITERATIONS = 80
_STEP = 1e-7  # by the size of the system: a difference ahead keeps half of the digits
_GOING_ON = 8  # steps of which the last is not much shorter than the first
_SMALL = 1e-13  # the same: a step after which nothing changes any more
_BALANCED = 1e-14  # of the loads: what they leave in a pose that rests
_DOWN = 1e-6  # of the loads: from where what is left of them is balanced by Newton's steps


@dataclass(frozen=True)
class CountedPose:
    """A pose, and the angles of lines by which it is counted on."""

    q: Array
    branches: Mapping[Branch, float]


@dataclass(frozen=True)
class LoadBalance:
    """The loads of a system at rest in a pose."""

    pose: CountedPose
    split: Split
    forces: Array  # Q
    multipliers: Array
    residual: Array  # r, in the metric of the masses
    scale: float  # what all loads come to, had they not cancelled, in the same metric
    J: Array

    @property
    def error(self) -> float:
        return float(np.linalg.norm(self.residual))


class RestFinder:
    """From one pose of a system to the rest near it."""

    def __init__(self, reference: Reference) -> None:
        """Raises CannotAnswer if the start cannot be assembled, or a driver moves at t = 0."""
        self.reference = reference
        q = reference.assemble()
        self.start = CountedPose(q, reference.geometry(q, np.zeros_like(q), 0.0).angles)
        self._equations = reference.held_where(q, 0.0)
        self._check_drivers()
        self.n_searches = 0
        self._n_looks = 0

    def geometry(self, pose: CountedPose) -> JetGeometry:
        """What measures see of the system at rest; time stands still."""
        return self.instant(pose).geometry(self.reference, pose.q, np.zeros_like(pose.q))

    def instant(self, pose: CountedPose) -> LinearisationPoint:
        return LinearisationPoint(pose.q, np.zeros_like(pose.q), 0.0, pose.branches, frozen=True)

    def _check_drivers(self) -> None:
        g = self.reference.geometry(self.start.q, np.zeros_like(self.start.q), 0.0, self.start.branches)
        for row in self.reference.system.constraint_rows:
            gap = self.reference.gap(row, g)
            if abs(gap.rate) > 1e-9 * max(self.reference.sizes.length, 1e-9):
                raise CannotAnswer(
                    Message(
                        "there is no equilibrium, because {connection} moves at t = 0 (at {rate:.6g} in "
                        "SI units). Give it a value that does not change, or ask for the motion instead",
                        connection=row.connection,
                        rate=abs(gap.rate),
                    )
                )

    # -- one pose -----------------------------------------------------------------------------
    def balance(self, pose: CountedPose) -> LoadBalance:
        """The loads and reactions in a pose. Raises CannotAnswer where a load has no value."""
        reference, n = self.reference, len(pose.q)
        self._n_looks += 1
        g = self.geometry(pose)
        J = stack([reference.gap(row, g).row(n) for row in reference.system.constraint_rows], n)
        loads = list(each_force(reference, g))
        D, Q = reference.sizes.small_moves, sum(loads, np.zeros(n))
        split = Split(J, D)
        scale = sum(float(np.linalg.norm(D * load)) for load in loads)
        return LoadBalance(pose, split, Q, split.multipliers(-Q), split.null.T @ Q, scale, J)

    def stiffness(self, here: LoadBalance) -> Array:
        """K along the columns of N, by differences: good enough to search by."""
        reference, n, N = self.reference, len(here.pose.q), here.split.null

        def pull(q: Array) -> Array:
            self._n_looks += 1
            g = self.geometry(CountedPose(q, here.pose.branches))
            rows = stack([reference.gap(row, g).row(n) for row in reference.system.constraint_rows], n)
            return sum(each_force(reference, g), rows.T @ here.multipliers)

        K = np.zeros((N.shape[1], N.shape[1]))
        rest = here.forces + here.J.T @ here.multipliers
        for k, direction in enumerate(N.T):
            h = _STEP / float(reference.sizes.relative(direction).max())
            K[:, k] = -(N.T @ (pull(reference.frame.moved(here.pose.q, h * direction)) - rest)) / h
        return K

    def moved(self, pose: CountedPose, step: Array) -> CountedPose | None:
        """The pose nearest to a step away that holds everything."""
        fit = self.reference.placing.fit(self.reference.frame.moved(pose.q, step), self._equations, 0.0, pose.branches)
        if fit is None or fit.error > ACCEPTED:
            return None
        return CountedPose(fit.q, fit.branches)

    def at_measures(self, pose: CountedPose, wanted: Sequence[tuple[str, Measure, float]]) -> CountedPose:
        """The pose nearest to one with given values of measures, led there in steps where it is far. Raises
        CannotAnswer if there is none in reach."""
        g = self.geometry(pose)
        begin = [self.reference.jet(g, measure, name).value for name, measure, _ in wanted]
        for n_parts in (1, 4, 16):
            here = pose
            for part in range(1, n_parts + 1):
                equations = [
                    PoseEquation.of(name, measure, Jet(x0 + (x - x0) * part / n_parts))
                    for (name, measure, x), x0 in zip(wanted, begin, strict=True)
                ]
                fit = self.reference.placing.fit(here.q, self._equations + equations, 0.0, here.branches)
                if fit is None or fit.error > ACCEPTED:
                    break
                here = CountedPose(fit.q, fit.branches)
            else:
                return here
        given = ", ".join(f"{name} = {x:.6g}" for name, _measure, x in wanted)
        raise CannotAnswer(
            Message("no pose in reach of the start has {given} (in SI units); guess another one", given=given)
        )

    def try_balance(self, pose: CountedPose | None) -> LoadBalance | None:
        if pose is None:
            return None
        try:
            here = self.balance(pose)
        except (CannotAnswer, ArithmeticError, ValueError):
            return None
        return here if np.isfinite(here.error) else None

    # -- searches -----------------------------------------------------------------------------
    def rest_near(self, pose: CountedPose) -> LoadBalance | None:
        """The rest to which damped Newton steps from a pose lead; None if they end elsewhere."""
        self.n_searches += 1
        here = self.try_balance(pose)
        damping, ratio, reach, errors, moved = 1e-8, 0.0, _REACH, list[float](), list[float]()
        for _ in range(_N_ITERATIONS):
            if here is None or not len(here.residual) or self._is_far(here.pose, pose):
                break
            errors.append(here.error)
            if len(errors) == 1 and here.error <= _BALANCED * here.scale:
                break  # it rests: a step would divide one round-off by another
            if here.error == 0.0 or (reach <= _REACH and len(errors) > 8 and here.error > 0.9 * errors[-8]):
                break
            try:
                K = self.stiffness(here)
            except (CannotAnswer, ArithmeticError, ValueError):
                return None
            size = float(np.linalg.norm(K)) or 1.0
            damped = np.vstack((K, damping * size * np.eye(len(K))))
            step = here.split.null @ _least_squares(damped, np.append(here.residual, np.zeros(len(K))))
            part = min(1.0, reach / max(float(self.reference.sizes.relative(step).max()), LEAST))
            step = part * step
            there = self._best(here, step, (1.0, 2.0, 3.0) if ratio > 0.1 else (1.0,))
            if there is not None and there.error < here.error:
                # a step that keeps what it promises may be followed by a longer one
                reach = 2.0 * reach if there.error <= (1.0 - 0.5 * part) * here.error else _REACH
                length = float(self.reference.sizes.relative(step).max())
                moved = [*moved, length] if part == 1.0 else []
                ratio, here, damping = there.error / here.error, there, max(0.1 * damping, 1e-10)
                if length < _SMALL:
                    break
            elif damping >= 1e4:
                break
            else:
                damping = max(10.0 * damping, 1e-4)
                ratio, reach = 0.0, _REACH
        return here if here is not None and self.is_rest(here) and not _goes_on(moved) else None

    def _best(self, here: LoadBalance, step: Array, factors: Sequence[float]) -> LoadBalance | None:
        """The best of some multiples of a step: where a rest is a multiple root, Newton's own is too short."""
        tried = [self.try_balance(self.moved(here.pose, factor * step)) for factor in factors]
        found = [b for b in tried if b is not None and len(b.residual) == len(here.residual)]
        return min(found, key=lambda b: b.error, default=None)

    def is_rest(self, here: LoadBalance) -> bool:
        """Whether the loads balance, by what they come to and what they would come to a little way off."""
        if not len(here.residual):
            return True
        K, N = self.stiffness(here), here.split.null
        off = 1e-3 / max(float(self.reference.sizes.relative(direction).max()) for direction in N.T)
        return here.error <= ROUND_OFF * (here.scale + off * float(np.linalg.norm(K)))

    def lowest_near(self, pose: CountedPose) -> LoadBalance | None:
        """The rest to which the way downhill leads; None without a potential, or if there is none in reach."""
        self.n_searches += 1
        here, height, reach = self.try_balance(pose), self._potential(pose), _REACH
        for _ in range(_N_ITERATIONS):
            if here is None or height is None or not len(here.residual) or self._is_far(here.pose, pose):
                return None
            if here.error <= _DOWN * here.scale:
                break
            try:
                K = self.stiffness(here)
            except (CannotAnswer, ArithmeticError, ValueError):
                return None
            values, vectors = np.linalg.eigh((K + K.T) / 2.0)
            steep = np.maximum(np.abs(values), 1e-6 * float(np.abs(values).max()) or 1.0)
            step = here.split.null @ (vectors @ ((vectors.T @ here.residual) / steep))
            step = step * min(1.0, reach / max(float(self.reference.sizes.relative(step).max()), LEAST))
            slope = float(here.forces @ step)
            for part in (1.0, 0.5, 0.25, 0.1, 0.01):
                lower = self.moved(here.pose, part * step)
                level = None if lower is None else self._potential(lower)
                if lower is not None and level is not None and level <= height - 1e-4 * part * slope:
                    here, height, reach = self.try_balance(lower), level, max(_REACH, 2.0 * part * reach)
                    break
            else:
                break
        return None if here is None else self.rest_near(here.pose)

    def _potential(self, pose: CountedPose) -> float | None:
        g = self.geometry(pose)
        try:
            applied_loads = self.reference.system.all_loads
            return sum(potential(self.reference, p, lambda m: self.reference.jet(g, m).value) for p in applied_loads)
        except (CannotAnswer, ArithmeticError, ValueError):
            return None

    def _is_far(self, pose: CountedPose, start: CountedPose) -> bool:
        away = self.reference.sizes.relative(self.reference.frame.difference(pose.q, start.q))
        return float(away.max(initial=0.0)) > FAR or float(away[self._turning].max(initial=0.0)) > FAR_ROUND

    @cached_property
    def _turning(self) -> NDArray[np.intp]:
        """Where angles stand in q; in space rotations are told from each other without turns."""
        if self.reference.system.space:
            return np.zeros(0, dtype=np.intp)
        return np.array([c[2] for c in self.reference.frame.columns.values() if len(c) == 3], dtype=np.intp)

    def apart(self, a: CountedPose, b: CountedPose) -> float:
        """How far two poses are apart, full turns counted out, by the size of the system."""
        return float(self.reference.sizes.relative(self.difference(a, b)).max(initial=0.0))

    def difference(self, a: CountedPose, b: CountedPose) -> Array:
        """The move from b to a, full turns counted out."""
        move = self.reference.frame.difference(a.q, b.q)
        angles = move[self._turning]
        move[self._turning] = angles - math.tau * np.round(angles / math.tau)
        return move

    def is_same(self, a: LoadBalance, b: LoadBalance) -> bool:
        """Whether two poses are one: turns counted out, if the loads do not count them."""
        return self.apart(a.pose, b.pose) <= SAME and self.loads_same(a.pose, b.pose)

    def loads_same(self, a: CountedPose, b: CountedPose) -> bool:
        """Whether the laws of all loads have the same values in two poses."""
        laws = [
            np.array([law(self.reference, g, push) for push in self.reference.system.all_loads])
            for g in (self.geometry(a), self.geometry(b))
        ]
        return bool(np.abs(laws[0] - laws[1]).max(initial=0.0) <= 1e-3 * np.abs(laws).max(initial=0.0) + ROUND_OFF)


def _goes_on(steps: Sequence[float]) -> bool:
    """Whether Newton's steps, as they are without a limit, stay as long while the loads die away: exp(-x/b) loses a
    factor e at each step of b, 1/x^n at each of x/n, and both are nowhere zero. To a zero of the order n a step is at
    most (n - 1)/n of the one before."""
    last = steps[-_GOING_ON:]
    return len(last) == _GOING_ON and last[-1] > 0.5 * last[0]


def _least_squares(A: Array, b: Array) -> Array:
    found: Any = np.linalg.lstsq(A, b, rcond=1e-14)
    return found[0]
