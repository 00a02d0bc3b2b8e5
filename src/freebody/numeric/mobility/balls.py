"""Poses of a system in balls: what is meant by rounded coordinates, and poses that close to many digits.

Of a body that turns in space the pose is a quaternion, of any length, and three small turns further about the body's
own axes, which stand in its columns; the quaternion is what the model states, or as many digits as there are.
Source: Shuster, J. Astronaut. Sci. 41 (1993) 439 (quaternions).
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

import numpy as np

from freebody.language.expression import Expr
from freebody.language.sentences import Message
from freebody.model.elements import ConstraintRow, NonholonomicForm, RigidBody, Rotation
from freebody.numeric.jets import TIME, Array
from freebody.numeric.mobility.elimination import Unclear
from freebody.numeric.mobility.exact import (
    BALLS,
    ExactDual,
    ExactDualGeometry,
    Place,
    Quaternion,
    decimal,
    parameter_ball,
    size_of,
    spatial_place,
)
from freebody.numeric.rotation import matrix, product_of_parts, quaternion, rotation_vector
from freebody.numeric.split import RANK_CUT
from freebody.numeric.system import NumericSystem
from freebody.tolerances import ROUNDED

N_STEPS = 40


@dataclass
class BallPose:
    """Coordinates in balls, by column, and the quaternions from which the turns of bodies in space count."""

    numbers: list[Any]
    attitudes: dict[str, Quaternion] = field(default_factory=dict[str, Quaternion])


class BallRows:
    """Some rows of a system in balls. slopes: their gradients at the pose that is looked at, by speeds in floats."""

    def __init__(self, reference: NumericSystem, rows: Sequence[ConstraintRow], t: float, slopes: Array) -> None:
        self.reference, self.rows, self.t = reference, rows, t
        self.slopes = _by_own_axes(reference, slopes)
        parameters, numbers = reference.system.parameters, reference.frame.values
        self.values = {name: ExactDual(parameter_ball(parameters.get(name), x)) for name, x in numbers.items()}
        self.values[TIME] = ExactDual(BALLS.number(decimal(t)))
        self._plain = ExactDualGeometry({}, self.values, BALLS)
        self.fixed = {body: self._fixed(reference.system.bodies[body]) for body in reference.frame.fixed}
        self._origins: dict[int, Any] = {}

    def number(self, expr: Expr) -> Any:
        return self._plain.scalar(expr).value

    def scale(self, column: int) -> float:
        return float(self.reference.sizes.unit_moves[column])

    def fewer(self, kept: Sequence[bool]) -> BallRows:
        """The rows that are kept alone."""
        rows = [row for row, keep in zip(self.rows, kept, strict=True) if keep]
        found = BallRows(self.reference, rows, self.t, np.zeros((0, self.slopes.shape[1])))
        found.slopes = self.slopes[np.array(kept, dtype=bool)]
        return found

    # -- as the model says --------------------------------------------------------------------
    def _fixed(self, body: RigidBody) -> Place:
        """Where a fixed body is, from what the model says."""
        start = body.start.with_guess()
        zero = BALLS.number(0)
        if self.reference.system.space:
            attitude = self._stated_attitude(body) or _unturned()
            center = self._center(body, attitude) if start.at is not None else [zero] * 3
            return spatial_place([ExactDual(c) for c in center], attitude)
        theta = zero if start.angle is None else self.number(start.angle)
        x, y = self._mass_center(body, theta) if start.at is not None else (zero, zero)
        return ExactDual(x), ExactDual(y), ExactDual(theta)

    def _mass_center(self, body: RigidBody, theta: Any) -> tuple[Any, Any]:
        start = body.start.with_guess()
        if start.at is None:
            raise ValueError(f"{body.name} has no place")
        point, place = start.at
        (px, py), (x, y) = ([self.number(c) for c in pair] for pair in (body.points[point], place))
        c, s = (BALLS.functions[name](theta) for name in ("cos", "sin"))
        return x - (c * px - s * py), y - (s * px + c * py)

    def _center(self, body: RigidBody, attitude: Quaternion) -> list[Any]:
        """The mass centre of a body in space of which a point is stated."""
        start = body.start.with_guess()
        if start.at is None:
            raise ValueError(f"{body.name} has no place")
        point, place = start.at
        axes = _axes_of(attitude)
        offset = [self.number(c) for c in body.points[point]]
        center: list[Any] = []
        for k, c in enumerate(place):
            arm = sum(axis[k] * o for axis, o in zip(axes, offset, strict=True))
            center.append(self.number(c) - arm)
        return center

    def _stated_attitude(self, body: RigidBody) -> Quaternion | None:
        """The quaternion of the rotations that the model states, or guesses; None without any."""
        stated = body.start.with_guess().turned
        return None if stated is None else self._product(stated)

    def _product(self, chain: Iterable[Rotation]) -> Quaternion:
        total: Quaternion = _unturned()
        for turn in chain:
            axis = [self.number(c) for c in turn.axis]
            size = BALLS.functions["sqrt"](sum(c * c for c in axis))
            total = product_of_parts(total, _about([c / size for c in axis], self.number(turn.by)))
        return total

    # -- poses --------------------------------------------------------------------------------
    def geometry(self, pose: BallPose, *, with_gradient: bool) -> ExactDualGeometry:
        one = BALLS.number(1)
        places: dict[str, Place] = dict(self.fixed)

        def dual(k: int) -> ExactDual:
            return ExactDual(pose.numbers[k], {k: one} if with_gradient else None)

        for body, columns in self.reference.frame.columns.items():
            if self.reference.system.space:
                own = columns[3:]
                attitude = self._attitude(pose, body) if own else _unturned()
                places[body] = spatial_place([dual(k) for k in columns[:3]], attitude, own if with_gradient else ())
                continue
            x, y, *theta = map(dual, columns)
            places[body] = x, y, theta[0] if theta else None
        return ExactDualGeometry(places, self.values, BALLS)

    def _attitude(self, pose: BallPose, body: str) -> Quaternion:
        further = [pose.numbers[k] for k in self.reference.frame.columns[body][3:]]
        attitude = pose.attitudes[body]
        if all(bool(x == 0) for x in further):
            return attitude
        return product_of_parts(attitude, [BALLS.number(1), *(x / 2 for x in further)])

    def coordinates(self, pose: BallPose) -> Array:
        """The same pose as coordinates of `reference`, rounded."""
        q = np.array([float(x) for x in pose.numbers])
        for body in pose.attitudes:
            own = list(self.reference.frame.columns[body][3:])
            R = _rotation(_axes_of(self._attitude(pose, body)))
            q[own] = rotation_vector(R @ self.reference.frame.principal[body])
        return q

    def gradients(self, pose: BallPose) -> list[dict[int, Any]]:
        g = self.geometry(pose, with_gradient=True)
        return [g.of(row.measure).gradient for row in self.rows]

    def count_from(self, pose: BallPose) -> None:
        """Measures of which only changes mean something keep the value that they have here."""
        g = self.geometry(pose, with_gradient=False)
        self._origins = {
            k: g.of(row.measure).value
            for k, row in enumerate(self.rows)
            if not isinstance(row.measure, NonholonomicForm) and row.measure.incremental and row.target is None
        }

    def gaps(self, pose: BallPose) -> list[Any]:
        """How far every row is from its target; zero for one that is only a rate."""
        g = self.geometry(pose, with_gradient=False)
        return [
            BALLS.number(0) if isinstance(row.measure, NonholonomicForm) else g.gap(row, self._origins.get(k, 0)).value
            for k, row in enumerate(self.rows)
        ]

    # -- what is meant ------------------------------------------------------------------------
    def meant(self, q: Array, within: float) -> tuple[BallPose, list[int]]:
        """Coordinates as they may be meant: as the model states them, or short decimals and simple parts of pi that
        are as near as `within` (by the size of the system); and which have no such value."""
        found: list[Any] = [None] * len(q)
        length = self.reference.sizes.length
        attitudes: dict[str, Quaternion] = {}
        for body in self.reference.system.all_moving:
            columns = self.reference.columns(body.name)
            stated: Sequence[Any] = [None] * len(columns)
            if self.reference.system.space:
                places, own = columns[:3], columns[3:]
                attitude: Quaternion = _unturned()
                if own:
                    attitude, is_known = self._meant_attitude(body, q, within)
                    attitudes[body.name] = attitude
                    for k in own:
                        found[k] = BALLS.number(0) if is_known else None
                if body.start.with_guess().at is not None:
                    stated = self._center(body, attitude)
            else:
                places, turning = columns[:2], columns[2:]
                theta = BALLS.number(0)
                for k in turning:
                    angle = None if body.start.angle is None else self.number(body.start.angle)
                    found[k] = _nearest(q[k], [angle, *_angles(float(q[k]))], within)
                    theta = BALLS.number(Fraction(float(q[k]))) if found[k] is None else found[k]
                if body.start.at is not None:
                    stated = self._mass_center(body, theta)
            for k, place in zip(places, stated, strict=False):
                found[k] = _nearest(q[k], [place, *_decimals(float(q[k]))], within * length)
        unknown = [k for k, x in enumerate(found) if x is None]
        turning_columns = {k for name in attitudes for k in self.reference.columns(name)[3:]}
        rounded = [0.0 if k in turning_columns else float(q[k]) for k in range(len(q))]
        numbers = [BALLS.number(Fraction(rounded[k])) if x is None else x for k, x in enumerate(found)]
        return BallPose(numbers, attitudes), unknown

    def _meant_attitude(self, body: RigidBody, q: Array, within: float) -> tuple[Quaternion, bool]:
        """The quaternion of a body, and whether it is known exactly: as stated, or a turn about x, y or z by a simple
        angle."""
        own = list(self.reference.columns(body.name)[3:])
        R = matrix(q[own]) @ self.reference.frame.principal[body.name].T
        phi = rotation_vector(R)
        candidates = [self._stated_attitude(body)]
        k = int(np.abs(phi).argmax())
        for angle in _angles(float(phi[k])):
            candidates.append(_about([BALLS.number(int(i == k)) for i in range(3)], angle))
        for candidate in candidates:
            if candidate is not None and float(np.abs(_rotation(_axes_of(candidate)) - R).max()) <= within:
                return candidate, True
        return [BALLS.number(Fraction(float(c))) for c in quaternion(R)], False


def _unturned() -> list[Any]:
    return [BALLS.number(int(k == 0)) for k in range(4)]


def _about(axis: Sequence[Any], angle: Any) -> list[Any]:
    """The quaternion of a turn about a unit vector."""
    half = angle / 2
    sine = BALLS.functions["sin"](half)
    return [BALLS.functions["cos"](half), *(c * sine for c in axis)]


def _axes_of(attitude: Quaternion) -> list[list[Any]]:
    """The axes of a body, by their ground components."""
    axes = spatial_place([ExactDual(BALLS.number(0))] * 3, attitude).axes
    return [[c.value for c in (a.x, a.y, a.z) if c is not None] for a in axes]


def _rotation(axes: Sequence[Sequence[Any]]) -> Array:
    """(3, 3), rounded."""
    return np.array([[float(c) for c in axis] for axis in axes]).T


def _by_own_axes(reference: NumericSystem, J: Array) -> Array:
    """Gradients by the angular velocity along the bodies' own axes in place of their principal ones."""
    found = J.copy()
    for body, columns in reference.frame.columns.items() if reference.system.space else ():
        own = list(columns[3:])
        found[:, own] = J[:, own] @ reference.frame.principal[body].T if own else J[:, own]
    return found


def _decimals(x: float) -> list[Any]:
    return [BALLS.number(f) for f in (Fraction(x).limit_denominator(1000), decimal(round(x, 9)))]


def _angles(x: float) -> list[Any]:
    turns = Fraction(x / math.pi).limit_denominator(720)
    return [BALLS.pi() * BALLS.number(turns), *_decimals(x)]


def _nearest(x: float, candidates: Sequence[Any], within: float) -> Any:
    """The first candidate that is near enough."""
    return next((c for c in candidates if c is not None and abs(float(c) - x) <= within), None)


# -- closing ----------------------------------------------------------------------------------
def refined(model: BallRows, q: Array, tolerance: float) -> tuple[BallPose, str]:
    """A pose near q that closes all rows to the tolerance, and what it is. Raises Unclear if none is found."""
    for within in (ROUNDED, 2e-6):
        pose, _unknown = model.meant(q, within)
        model.count_from(pose)
        if max(map(size_of, model.gaps(pose)), default=0.0) <= tolerance:
            return pose, Message("at the pose in the exact numbers of the model")
    # what is known exactly stays if it can: a slide that is level is to stay level to all digits
    _pose, unknown = model.meant(q, ROUNDED)
    # redundant rows that only keep their start values may contradict each other by the rounding of q: then they
    # count from a pose in which the others hold
    closing = [not (isinstance(row.measure, NonholonomicForm) or row.measure.incremental) for row in model.rows]
    error: Unclear | None = None
    for free in (unknown, list(range(len(q)))):
        for some in (model,) if all(closing) else (model, model.fewer(closing)):
            try:
                pose, how = _by_newton(some, q, free, tolerance)
            except Unclear as fault:
                error = error or fault
                continue
            if some is not model:
                model.count_from(pose)
            return pose, how
    raise error or Unclear(Message("no row closes"))


def _by_newton(model: BallRows, q: Array, free: Sequence[int], tolerance: float) -> tuple[BallPose, str]:
    """Steps of one pseudo-inverse from what q is meant to be, in the free coordinates, until the rows close."""
    pose, _unknown = model.meant(q, ROUNDED)
    model.count_from(pose)
    D = model.reference.sizes.unit_moves
    J = model.slopes * D
    weights = 1.0 / row_lengths(J)
    U, singular, Vt = np.linalg.svd(weights[:, None] * J[:, free], full_matrices=False)
    rank = int(np.count_nonzero(singular > RANK_CUT * singular.max(initial=0.0)))
    error = math.inf
    for _ in range(N_STEPS):
        gaps = model.gaps(pose)
        before, error = error, max((size_of(gap) * w for gap, w in zip(gaps, weights, strict=True)), default=0.0)
        if error <= tolerance:
            return pose, Message("at the pose refined to {error:.1e}", error=error)
        if not error < 0.1 * before:
            raise Unclear(Message("the pose closes only to {gap:.1g} with the numbers given", gap=before))
        # the step in floats, of gaps brought to about one
        shift = -math.frexp(error)[1]
        scaled = weights * np.array([float(_times_two(gap, shift)) for gap in gaps])
        step = D[free] * (Vt[:rank].T @ ((U[:, :rank].T @ scaled) / singular[:rank]))
        for k, dx in zip(free, step, strict=True):
            pose.numbers[k] = (pose.numbers[k] - _times_two(BALLS.number(float(dx)), -shift)).mid()
    raise Unclear(Message("the pose closes only to {gap:.1g} after {n} steps", gap=error, n=N_STEPS))


def row_lengths(J: Array) -> Array:
    """Of the rows; of one that is zero, that of the longest."""
    sizes: Array = np.linalg.norm(J, axis=1)
    largest = float(sizes.max(initial=0.0)) or 1.0
    return np.where(sizes > ROUNDED * largest, sizes, largest)


def _times_two(x: Any, n: int) -> Any:
    """x 2^n"""
    return x * (BALLS.number(1) * 2**n if n >= 0 else BALLS.number(Fraction(1, 2**-n)))
