"""Finding a pose near a guess, by the masses, in which all gaps F(q) of some equations vanish, and the nearest one.

Damped Gauss-Newton, with A the gradients of the weighted gaps and D the metric of the masses:

    step = -D A^T (A A^T + mu)^(-1) F,        mu in proportion to |F|^2, which keeps convergence quadratic

and where the gaps are small, the smallest step that closes them in a rank-revealing sense, so that equations
may say the same thing more than once. In a large system A is sparse (`sparse`).
Source: Levenberg-Marquardt after Yamashita & Fukushima, Computing Suppl. 15, 2001, 239-249.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, LENGTH, Dimension
from freebody.measures.base import Measure
from freebody.model.elements import NonholonomicForm
from freebody.numeric.jet_geometry import Branch, Frame, JetGeometry
from freebody.numeric.jets import LARGE, Array, Jet
from freebody.numeric.sizes import Sizes
from freebody.numeric.sparse import SparseRows
from freebody.numeric.split import Split

TOLERANCE = 4e-13  # at which a pose is good enough to stop, by the size of the system
ACCEPTED = 1e-11  # up to which it is accepted where rounding stops the improvement
# the slope of the gaps, by their size and steepness, at which they are taken to be stationary; where a singular pose
# fulfils everything the slope is as small as its square root of the gaps, 1e-3 at the least where this is asked
STATIONARY = 1e-6
_NEWTON = 1e-6  # by the size of the system: from gaps below this Newton's steps close them
_EQUAL = 1e-6  # relative: gaps that round-off does not tell apart
_LOOSE = 1e-3  # the weight of what may stay open
_SPREAD = 0.02  # of a gap, what is not told beside it
_RCOND = 1e-13  # of equations that say the same thing
N_STEPS = 200
N_NEARER = 100  # steps towards a guess
N_HALVED = 12  # times that such a step is halved
FURTHEST = 8.0  # such a step, by the descent
NEAREST = 1e-11  # the descent, by the distance, at which nothing is nearer
STEEPEST = 1e4  # the gradient of a gap where it has an end, by that of the pose that was found


@dataclass(frozen=True)
class PoseEquation:
    """A condition on the pose: a gap that must vanish."""

    name: str
    unit: str
    gap: Callable[[JetGeometry], Jet]
    bodies: frozenset[str] = frozenset()  # whose poses it depends on, where that is known

    @classmethod
    def of(
        cls, name: str, measure: Measure | NonholonomicForm, target: Jet | Callable[[JetGeometry], Jet]
    ) -> PoseEquation:
        """A measure is at its target, angles of lines counted so that they are near it."""

        def gap(g: JetGeometry) -> Jet:
            wanted = target if isinstance(target, Jet) else target(g)
            return g.of_near(measure, wanted.value) - wanted

        return cls(name, _unit(measure.dimension), gap, frozenset(measure.bodies()))

    @classmethod
    def along(cls, direction: Array, q: Array, length: float) -> PoseEquation:
        """The pose has moved from q by so much, seen along a direction."""
        size = float(np.linalg.norm(direction))
        row = direction / size
        return cls(
            "a direction of motion", "", lambda g: Jet(float(row @ g.frame.difference(g.q, q)) - length / size, row)
        )

    def loosened(self, share: float) -> PoseEquation:
        """The same with a gap that counts for less."""

        def gap(g: JetGeometry) -> Jet:
            return self.gap(g) * share

        return replace(self, gap=gap)


def _unit(dimension: Dimension) -> str:
    return {LENGTH: "m", DIMENSIONLESS: "rad"}.get(dimension) or str(dimension)


@dataclass(frozen=True)
class Fit:
    """A pose, how far it is from fulfilling its equations, and the gradients of these."""

    q: Array
    gaps: Array
    rows: Array | SparseRows
    weights: Array  # make the gaps numbers by the size of the system
    extent: float  # how far the system reaches, by its size
    equations: Sequence[PoseEquation]
    geometry: JetGeometry  # at the pose, in which the equations were looked at
    n_steps: int = 0  # that led to it

    @property
    def branches(self) -> Mapping[Branch, float]:
        return self.geometry.angles

    @property
    def error(self) -> float:
        return float(np.abs(self.weights * self.gaps).max(initial=0.0)) / self.extent

    @property
    def worst_one(self) -> int:
        """The equation with the largest gap; of gaps that are equally large round-off does not choose one, nor does
        their order."""
        sizes = np.abs(self.weights * self.gaps)
        largest = np.flatnonzero(sizes >= (1.0 - _EQUAL) * sizes.max())
        return int(min(largest.tolist(), key=lambda n: self.equations[n].name))

    @property
    def worst(self) -> str:
        sizes, k = np.abs(self.weights * self.gaps), self.worst_one
        equation = self.equations[k]
        whole = [n for n in self._beside(k) if sizes[n] > _SPREAD * sizes[k]]
        is_along = len(whole) == 1  # one axis tells it
        name = equation.name if is_along else connection_of(equation)
        gap = float(np.linalg.norm(self.gaps[whole]))
        return Message("{name} is off by {gap:.3g} {unit}", name=name, gap=gap, unit=equation.unit)

    def _beside(self, k: int) -> list[int]:
        """The equations of the same connection in the same unit."""
        one = self.equations[k]
        alike = (n for n, e in enumerate(self.equations) if connection_of(e) == connection_of(one))
        return [n for n in alike if self.equations[n].unit == one.unit and (n == k or "." in one.name)]


def connection_of(equation: PoseEquation) -> str:
    return equation.name.partition(".")[0]


@dataclass(frozen=True)
class _Apart:
    """A pose and a guess apart from each other."""

    fit: Fit
    free: Array  # what the equations leave free of the move that leads to the guess
    distance: float  # by the masses
    slope: float  # the length of what is free, by the distance


@dataclass(frozen=True)
class Placing:
    """Poses of one system in numbers."""

    frame: Frame
    sizes: Sizes

    def placed(self, q: Array, equations: Sequence[PoseEquation], t: float, near: Mapping[Branch, float]) -> Fit:
        """The pose near q that fulfils the equations. Raises CannotAnswer if there is none in reach."""
        fit = self.fit(q, equations, t, near)
        if fit is None:
            raise CannotAnswer(Message("a held measure has no value in the pose at t = {t:.6g} s", t=t))
        if fit.error > ACCEPTED:
            raise CannotAnswer(
                Message("no pose in reach at t = {t:.6g} s holds everything: {worst}", t=t, worst=fit.worst)
            )
        return fit

    def fit(
        self,
        q: Array,
        equations: Sequence[PoseEquation],
        t: float,
        near: Mapping[Branch, float],
        n_steps: int = N_STEPS,
    ) -> Fit | None:
        """The best pose that at most n_steps from q lead to. None where a measure has no value at q."""
        here = self._gaps(q, equations, t, near)
        if here is None:
            return None
        D = self.sizes.small_moves * math.sqrt(self.sizes.mass) * self.sizes.length
        damping = 1e-2
        n_tried = 0
        for n_tried in range(n_steps):  # noqa: B007
            if here.error <= TOLERANCE:
                break
            F, is_close = here.weights * here.gaps, here.error < _NEWTON
            step = self._newton(here) if is_close else _damped_step(here, D, F, damping)
            if step is None:
                break
            step = self.sizes.clipped(step, float(np.abs(F).max(initial=0.0)))
            there = self._gaps(self.frame.moved(here.q, step), equations, t, here.branches)
            if there is not None and np.linalg.norm(there.weights * there.gaps) < np.linalg.norm(F):
                here, damping = there, max(0.1 * damping, 1e-12)
            elif is_close or damping > 1e12:
                break
            else:
                damping *= 10.0
        return replace(here, n_steps=n_tried + 1)

    def with_one_gap(self, missed: Fit) -> Fit:
        """A pose that fulfils all but what one connection holds, where there is one near to the best pose, in which the
        gap of a loop is spread over all of them: then this is the gap that one would measure."""
        sizes = np.abs(missed.weights * missed.gaps)
        largest = np.flatnonzero(sizes >= (1.0 - _EQUAL) * sizes.max())
        opened = connection_of(missed.equations[min(largest.tolist(), key=lambda k: missed.equations[k].name)])
        loose = [e.loosened(_LOOSE) if connection_of(e) == opened else e for e in missed.equations]
        fit = self.fit(missed.q, loose, 0.0, missed.branches)
        there = None if fit is None else self.fit(fit.q, missed.equations, 0.0, missed.branches, 0)
        if there is None:
            return missed
        others = [k for k, e in enumerate(missed.equations) if connection_of(e) != opened]
        beside = float(np.abs((there.weights * there.gaps)[others]).max(initial=0.0))
        return there if beside <= _SPREAD * float(np.abs(there.weights * there.gaps).max()) else missed

    def nearest(self, found: Fit, guess: Array, t: float) -> Fit:
        """Of the poses that fulfil the equations of a fit, as it does, one that no small move brings nearer to a guess.

        With d the move that leads to the guess and J the gradients, d - J^+ J d in the metric of the masses is what the
        equations leave free of it: the descent of half the squared distance, after which the least move leads back to
        the equations. How far to go tells the change of the last descent by the last move, |dx|^2 / (dx . -d(descent)).
        Where the way ends beside a pose in which a gradient has no end (the ends of a line meet), there is no nearest
        pose, and the fit is returned. Source: Barzilai & Borwein, IMA J. Numer. Anal. 8, 1988, 141-148."""
        here, part = self._from(found, guess), 1.0
        for _ in range(N_NEARER):
            there = None if here.slope <= NEAREST else self._nearer(here, part, guess, t)
            if there is None:
                break
            moved = self.frame.difference(there.fit.q, here.fit.q) / self.sizes.small_moves
            curved = float(moved @ ((here.free - there.free) / self.sizes.small_moves))
            part = min(float(moved @ moved) / curved, FURTHEST) if curved > 0.0 else FURTHEST
            here = there
        is_nearest = here.slope <= _NEWTON and self._steepness(here.fit) <= STEEPEST * self._steepness(found)
        return here.fit if is_nearest else found

    def _nearer(self, here: _Apart, part: float, guess: Array, t: float) -> _Apart | None:
        """Nearer to the guess by a part of the descent, halved until it is; where the distance is told from its least
        value by round-off alone, nearer to where the descent ends."""
        step = self.sizes.clipped(part * here.free, 0.0)
        for _ in range(N_HALVED):
            fit = self.fit(self.frame.moved(here.fit.q, step), here.fit.equations, t, here.fit.branches)
            if fit is not None and fit.error <= max(here.fit.error, TOLERANCE):
                there = self._from(fit, guess)
                if there.slope < here.slope if here.slope <= _NEWTON else there.distance < here.distance:
                    return there
            step = 0.5 * step
        return None

    def _from(self, fit: Fit, guess: Array) -> _Apart:
        wanted = self.frame.difference(guess, fit.q)
        free = wanted - self._least(fit, fit.rows @ wanted)
        distance = float(np.linalg.norm(wanted / self.sizes.small_moves))
        descent = float(np.linalg.norm(free / self.sizes.small_moves))
        is_there = float(self.sizes.relative(wanted).max(initial=0.0)) <= TOLERANCE * fit.extent
        return _Apart(fit, free, distance, 0.0 if is_there else descent / distance)

    def _steepness(self, fit: Fit) -> float:
        """The largest gradient of the gaps, by the size of the system."""
        rows = fit.rows.whole if isinstance(fit.rows, SparseRows) else fit.rows
        return float(np.abs(fit.weights[:, None] * rows * self.sizes.unit_moves).max(initial=0.0))

    def _least(self, here: Fit, gaps: Array) -> Array:
        """The smallest move that changes the measures by so much."""
        D = self.sizes.small_moves
        return here.rows.least(D, gaps) if isinstance(here.rows, SparseRows) else Split(here.rows, D).least(gaps)

    def _newton(self, here: Fit) -> Array:
        """The smallest step that closes small gaps."""
        return -self._least(here, here.gaps)

    def _gaps(self, q: Array, equations: Sequence[PoseEquation], t: float, near: Mapping[Branch, float]) -> Fit | None:
        g = JetGeometry(self.frame, q, np.zeros_like(q), t, near)
        try:
            gaps = [equation.gap(g) for equation in equations]
        except (CannotAnswer, ArithmeticError, ValueError):
            return None
        values = np.array([gap.value for gap in gaps])
        rows = rows_of(gaps, len(q))
        are_finite = rows.are_finite if isinstance(rows, SparseRows) else np.isfinite(rows).all()
        if not (np.isfinite(values).all() and are_finite):
            return None
        weights = np.array([1.0 / self.sizes.length if equation.unit == "m" else 1.0 for equation in equations])
        extent = max(1.0, self.sizes.relative(q).max(initial=0.0))
        return Fit(q, values, rows, weights, extent, equations, g)


def rows_of(jets: Sequence[Jet], n: int) -> Array | SparseRows:
    """The gradients of some jets by n coordinates."""
    if n > LARGE:
        return SparseRows([jet.gradient for jet in jets], n)
    return np.array([jet.row(n) for jet in jets]).reshape(len(jets), n)


def _damped_step(here: Fit, D: Array, F: Array, damping: float) -> Array | None:
    """A step of Gauss and Newton, damped. None at a stationary point of the gaps: nearer than this it does not get from
    here."""
    mu = damping * float(F @ F)
    if isinstance(here.rows, SparseRows):
        if here.rows.is_stationary(here.weights, D, F, STATIONARY):
            return None
        return -here.rows.damped(here.weights, D, F, mu)
    A = here.weights[:, None] * here.rows * D
    if np.linalg.norm(A.T @ F) <= STATIONARY * np.linalg.norm(F) * np.linalg.norm(A):
        return None
    return -D * (A.T @ _damped(A @ A.T, mu, F))


def _damped(square: Array, mu: float, F: Array) -> Array:
    """(square + mu) x = F; by least squares where equations that say the same thing make it singular."""
    damped = square + mu * np.eye(len(F))
    try:
        return np.asarray(np.linalg.solve(damped, F), dtype=np.float64)
    except np.linalg.LinAlgError:
        return np.asarray(np.linalg.lstsq(damped, F, rcond=_RCOND)[0], dtype=np.float64)
