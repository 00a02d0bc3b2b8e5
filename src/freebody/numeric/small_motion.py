"""Small motions about any state of a system: what the linear part of its equations of motion is.

About a state (q0, v0) at the time t0, which holds everything, with accelerations a0 and multipliers lambda0, a
disturbance (dq, dv) keeps the held measures f(q, t) = 0 and their rates. With the accelerations J a + bias of the
gaps, all to first order,

    J dq = 0,    J dv + d(f')[dq] = 0,    J da + d(J a0 + bias)[dq, dv] = 0,
    M da = d(Q + J^T lambda0 - M a0)[dq, dv] + J^T dlambda,

where d(...)[...] are derivatives with a0 and lambda0 kept. Independent coordinates z of the disturbance are named
measures as far as they are independent, z_i = dm_i; their gradients G, with J, determine dq, dv and da. With N the
directions in which one coordinate grows by one and the rest rest (J N = 0, G N = 1), the last line projected on N is

    M z'' + C z' + K z = N^T dQ,        M = N^T M_bodies N,

and K holds the loads, the geometric stiffness lambda0 . Hess f, and what a moving state adds. Nothing is
moved onto the constraints to find it, so it is accurate to rounding. About a rest, time stands still: drivers and
loads keep what they have at t0. About a moving state the equations hold for the instant t0; they have constant
coefficients if the state is steady in these coordinates (a rotor turning at a constant rate).
Sign of K: positive pulls back. Source: Meirovitch, Methods of Analytical Dynamics, 1970, sec. 6.2 to 6.5;
Nikravesh, Computer-Aided Analysis of Mechanical Systems, 1988, ch. 8.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.language.units import LENGTH
from freebody.measures.base import Measure
from freebody.model.elements import NonholonomicForm
from freebody.numeric.directional import derivative
from freebody.numeric.instant import check_inertia, dynamics, each_force, forces
from freebody.numeric.jet_geometry import Branch, JetGeometry
from freebody.numeric.jets import Array, Jet
from freebody.numeric.spatial import gyroscopic
from freebody.numeric.split import Split, stack
from freebody.numeric.system import NumericSystem

WELL_APART = 0.1  # how much of a coordinate's gradient along the free directions must be its own
AT_ALL = 1e-4  # and how much of its whole gradient must be along these, in the metric of the masses
UNBOUNDED = 1e5  # a gradient, by the sizes: nearer than this to where an angle has no value it tells nothing
NOISE = 1e-11  # of the stiffnesses that loads can come to: what is smaller counts as zero


@dataclass(frozen=True)
class SmallCoordinate:
    """An independent coordinate of small motions: a measure, or a fixed direction of the absolute coordinates."""

    name: str
    measure: Measure | None
    row: Array  # its gradient

    def jet(self, reference: NumericSystem, g: JetGeometry, v: Array) -> Jet:
        if self.measure is not None:
            return reference.jet(g, self.measure, self.name)
        return Jet(float(self.row @ g.q), self.row, float(self.row @ v))


@dataclass(frozen=True)
class LinearisationPoint:
    """A state about which to linearise, and whether time stands still there."""

    q: Array
    v: Array
    t: float
    branches: Mapping[Branch, float]
    frozen: bool

    def geometry(self, reference: NumericSystem, q: Array, v: Array) -> JetGeometry:
        """What measures see near this state."""
        g = reference.geometry(q, v, self.t, self.branches)
        if self.frozen:
            g.time = Jet(self.t)
        return g


def gradient_of(reference: NumericSystem, g: JetGeometry, name: str, measure: Measure) -> Array | None:
    """The gradient of a measure on the absolute coordinates; None where the measure has no value, or is so near to
    such a place that round-off decides it: the turn about an axis that another one has come to lie on."""
    try:
        row = reference.jet(g, measure, name).row(len(g.q))
    except (CannotAnswer, ArithmeticError, ValueError):
        return None
    size = reference.sizes.length if measure.dimension == LENGTH else 1.0
    return row if np.abs(row * reference.sizes.unit_moves).max(initial=0.0) < UNBOUNDED * size else None


def coordinates(reference: NumericSystem, g: JetGeometry, free: Array) -> list[SmallCoordinate]:
    """Coordinates along the free directions: named measures first, then angles and places of bodies, as far as
    they are independent, and directions of their own where those do not suffice."""
    D = reference.sizes.small_moves
    found: list[SmallCoordinate] = []
    left = np.eye(int(free.shape[1]))  # what is not yet covered, in the metric of the masses
    for name, measure in _candidates(reference):
        if not left.shape[1]:
            break
        row = gradient_of(reference, g, name, measure)
        if row is None:
            continue
        seen = free.T @ row
        own = left.T @ seen
        size = float(np.linalg.norm(seen))
        if size <= AT_ALL * float(np.linalg.norm(row * D)) or float(np.linalg.norm(own)) < WELL_APART * size:
            continue
        found.append(SmallCoordinate(name, measure, row))
        left = left @ _complement(own)
    for k in range(int(left.shape[1])):
        found.append(SmallCoordinate(f"direction {k + 1}", None, (free @ left[:, k]) / D**2))
    return found


def _complement(x: Array) -> Array:
    """Orthonormal columns at right angles to a vector."""
    return np.linalg.qr(x[:, None], mode="complete")[0][:, 1:]


def _candidates(reference: NumericSystem) -> Sequence[tuple[str, Measure]]:
    from freebody.measures.angle import Angle
    from freebody.measures.displacement import Displacement
    from freebody.measures.geometry import GROUND, RIGHT, UP, Point

    moving, origin = reference.system.all_moving, Point(GROUND)
    found: list[tuple[str, Measure]] = list(reference.system.all_measures.items())
    if reference.system.space:
        found += reference.system.offered
    found += [(f"angle of {body.name}", Angle(body.name)) for body in moving if body.turns]
    for body in moving:
        found.append((f"x of {body.name}", Displacement(body.mass_center, origin, RIGHT)))
        found.append((f"y of {body.name}", Displacement(body.mass_center, origin, UP)))
    return found


class SmallMotion:
    """The linear equations of motion about one state.

    `positions` and `speeds` are the coordinates whose disturbances, and rates of these, make the state x: as many
    of one as of the other unless rolling or a blade binds velocities only. M, C and K act on the speeds, the
    speeds and the positions."""

    def __init__(self, reference: NumericSystem, at: LinearisationPoint) -> None:
        """Raises CannotAnswer where the loads are not smooth."""
        self.reference, self.at = reference, at
        n = len(at.q)
        g = at.geometry(reference, at.q, at.v)
        gaps = [reference.gap(row, g) for row in reference.system.constraint_rows]
        J = stack([gap.row(n) for gap in gaps], n)
        places = [not isinstance(row.measure, NonholonomicForm) for row in reference.system.constraint_rows]
        D = reference.sizes.small_moves
        self.split = Split(J, D)
        free_places = self.split.null if all(places) else Split(J[np.array(places, dtype=bool)], D).null
        self.positions = coordinates(reference, g, free_places)
        if reference.system.space and at.v.any() and any(c.measure is None for c in self.positions):
            raise CannotAnswer(
                Message(
                    "small motions about a state that turns are counted in measures: name angles or places that tell "
                    "the pose, under measures or by turned"
                )
            )
        self.speeds = self.positions if all(places) else _among(self.positions, self.split.null, D)
        self._G_places = stack([c.row for c in self.positions], n)
        self._G = stack([c.row for c in self.speeds], n)
        self.unit_places = free_places @ np.linalg.inv(self._G_places @ free_places)
        self.unit_speeds = self.split.null @ np.linalg.inv(self._G @ self.split.null)
        self.orthonormal = self._G @ self.split.null  # speeds of the directions orthonormal in the metric
        self._rest(g)
        self._disturb(self._scale(g))

    def _rest(self, g: JetGeometry) -> None:
        """Accelerations and multipliers at the state; at rest the loads only balance."""
        reference, n = self.reference, len(self.at.q)
        if self.at.frozen:
            self._a = np.zeros(n)
            self._multipliers = self.split.multipliers(-forces(reference, g))
        else:
            here = dynamics(reference, g)
            self._a, self._multipliers = here.accelerations, here.multipliers
        D = reference.sizes.small_moves
        loads = sum(float(np.linalg.norm(D * load)) for load in each_force(reference, g))
        self._far_loads = self._loads_far_off(g)
        loads += float(np.linalg.norm(D * self._far_loads))
        # one in the metric of the masses is a move by so much of the size
        far = max((float(reference.sizes.relative(x).max()) for x in self.split.null.T), default=0.0)
        self.load_stiffness = loads * far  # [1/s^2], by the masses

    def _loads_far_off(self, g: JetGeometry) -> Array:
        """What the loads would change by over the size of the system, in no direction in particular."""
        reference, part, n = self.reference, 1e-3, len(self.at.q)
        step = part * reference.sizes.unit_moves * np.cos(1.0 + np.arange(n))
        try:
            moved = self.at.geometry(reference, reference.frame.moved(self.at.q, step), self.at.v + step)
            return (forces(reference, moved) - forces(reference, g)) / part
        except (CannotAnswer, ArithmeticError, ValueError):
            return np.zeros(n)

    # -- the disturbed equations --------------------------------------------------------------
    def _parts(self, q: Array, v: Array) -> Array:
        """Rates and accelerations of the gaps and of the coordinates, and the forces, at a0 and lambda0."""
        reference, n = self.reference, len(q)
        g = self.at.geometry(reference, q, v)
        gaps = [reference.gap(row, g) for row in reference.system.constraint_rows]
        marks = [c.jet(reference, g, v) for c in self.positions]
        jets = [*gaps, *marks]
        push = forces(reference, g) - reference.masses * self._a
        if reference.system.space:
            push = push + gyroscopic(v, reference.masses, reference.frame.columns.values())
        for multiplier, gap in zip(self._multipliers, gaps, strict=True):
            push = push + multiplier * gap.row(n)
        return np.concatenate(
            [[j.rate for j in jets], [float(j.row(n) @ self._a) + j.bias for j in jets], push], dtype=np.float64
        )

    def _scale(self, g: JetGeometry) -> Array:
        """What the terms of `_parts` come to, by the kind of the term."""
        reference, n, unit = self.reference, len(self.at.q), self.reference.sizes.unit_moves
        jets = [reference.gap(row, g) for row in reference.system.constraint_rows]
        jets += [c.jet(reference, g, self.at.v) for c in self.positions]
        rows = np.abs(stack([jet.row(n) for jet in jets], n))
        rates = rows @ (np.abs(self.at.v) + unit)
        accelerations = rows @ (np.abs(self._a) + unit * (1.0 + self._pace) ** 2)
        loads = sum((np.abs(load) for load in each_force(reference, g)), np.abs(reference.masses * self._a))
        loads = loads + np.abs(self._multipliers) @ rows[: len(self._multipliers)] + np.abs(self._far_loads)
        return np.concatenate((rates, accelerations, float((loads * unit).max(initial=0.0)) / unit))

    @property
    def _pace(self) -> float:
        """Sizes in a second."""
        return float(self.reference.sizes.relative(self.at.v).max(initial=0.0))

    def _along(self, f: _Function, dq: Array, dv: Array, scale: Array) -> Array:
        """The derivative of f(q, v) along a disturbance."""
        q, v, relative = self.at.q, self.at.v, self.reference.sizes.relative
        pace = max(1.0, self._pace)
        size = max(float(relative(dq).max(initial=0.0)), float(relative(dv).max(initial=0.0)) / pace)
        if size == 0.0:
            return np.zeros_like(f(q, v))
        moved = self.reference.frame.moved
        return size * derivative(lambda s: f(moved(q, (s / size) * dq), v + (s / size) * dv), scale)

    def _disturb(self, scale: Array) -> None:
        n_rows, n_z, n_u, n = (
            len(self.reference.system.constraint_rows),
            len(self.positions),
            len(self.speeds),
            len(self.at.q),
        )
        which = [self.positions.index(c) for c in self.speeds]
        zero = np.zeros(n)
        dq, dv, dz = np.zeros((n, n_z + n_u)), np.zeros((n, n_z + n_u)), np.zeros((n_z, n_z + n_u))
        dq[:, :n_z] = self.unit_places
        parts: list[Array] = []
        for k in range(n_z + n_u):
            if k < n_z:
                moved = self._along(self._parts, dq[:, k], zero, scale)
                rates, marks = moved[:n_rows], moved[n_rows : n_rows + n_z]
                dv[:, k] = self._solved(-rates, -marks[which])
                dz[:, k] = marks + self._G_places @ dv[:, k]
                if np.abs(dv[:, k]).max(initial=0.0) > 0.0:
                    moved = self._along(self._parts, dq[:, k], dv[:, k], scale)
            else:
                dv[:, k] = self.unit_speeds[:, k - n_z]
                dz[:, k] = self._G_places @ dv[:, k]
                moved = self._along(self._parts, zero, dv[:, k], scale)
            parts.append(moved[n_rows + n_z :])
        self.dq, self.dv, self.dz = dq, dv, dz
        moved = np.array(parts, dtype=np.float64).reshape(n_z + n_u, n_rows + n_z + n).T
        self._of_gaps, self._of_marks = moved[:n_rows], moved[n_rows : n_rows + n_z][which]
        M, N = self.reference.masses, self.unit_speeds
        self.M = N.T @ (M[:, None] * N)
        least = np.zeros((n, n_z + n_u))
        for k in range(n_z + n_u if n_rows else 0):
            least[:, k] = self.split.least(-self._of_gaps[:, k])
        push = N.T @ (moved[n_rows + n_z :] - M[:, None] * least)
        push = push + self.M @ (self._G @ least + self._of_marks)
        self.K, self.C = -push[:, :n_z], -push[:, n_z:]

    def _solved(self, gaps: Array, marks: Array) -> Array:
        """x with J x and G x given."""
        least = self.split.least(gaps) if len(gaps) else np.zeros(len(self.at.q))
        return least + self.unit_speeds @ (marks - self._G @ least)

    # -- the first-order form -----------------------------------------------------------------
    @cached_property
    def A(self) -> Array:
        """x' = A x, x = (z, u). Raises CannotAnswer naming a body that can move without inertia."""
        if len(self.speeds):
            N = self.split.null
            check_inertia(self.reference, N, N.T @ (self.reference.masses[:, None] * N))
        turned: Array = np.zeros((0, self.order))
        if len(self.speeds):
            turned = -np.linalg.solve(self.M, np.hstack((self.K, self.C))).astype(np.float64)
        return np.vstack((self.dz, turned))

    @property
    def order(self) -> int:
        return len(self.positions) + len(self.speeds)

    def input(self, push: Array) -> Array:
        """The column of B for a generalized force on the absolute coordinates."""
        pushed: Array = np.zeros(0)
        if len(self.speeds):
            pushed = np.linalg.solve(self.M, self.unit_speeds.T @ push).astype(np.float64)
        return np.concatenate((np.zeros(len(self.positions)), pushed))

    def output(self, measure: Measure, order: int) -> tuple[Array, Array]:
        """The row of C for a measure or its rate or acceleration, and what one of the speeds' accelerations adds
        to it (which inputs give directly)."""
        reference, n = self.reference, len(self.at.q)

        def shown(q: Array, v: Array) -> Array:
            jet = reference.jet(self.at.geometry(reference, q, v), measure, reference.name_of(measure))
            return np.array([jet.rate, float(jet.row(n) @ self._a) + jet.bias])

        row = reference.jet(self.at.geometry(reference, self.at.q, self.at.v), measure).row(n)
        if order == 0:
            return row @ self.dq, np.zeros(len(self.speeds))
        moved = np.array([self._along(shown, self.dq[:, k], self.dv[:, k], np.zeros(2)) for k in range(self.order)])
        if order == 1:
            return moved[:, 0], np.zeros(len(self.speeds))
        turned = self.A[len(self.positions) :]
        da = np.array(
            [self._solved(-self._of_gaps[:, k], turned[:, k] - self._of_marks[:, k]) for k in range(self.order)]
        ).reshape(self.order, n)
        return da @ row + moved[:, 1], row @ self.unit_speeds

    @property
    def of_states(self) -> list[int]:
        """Where among the positions the integrals of states of controllers stand: nothing depends on them."""
        carriers = {state.carrier for state in self.reference.system.states.values()}
        return [k for k, c in enumerate(self.positions) if c.name in carriers]

    @property
    def units(self) -> Array:
        """What a move by the size of the system, or a turn by a radian, comes to in the positions [their units]."""
        return np.abs(self._G_places) @ self.reference.sizes.unit_moves

    @property
    def noise(self) -> float:
        """Stiffness by the masses [1/s^2] that cannot be told from none."""
        return NOISE * (float(np.abs(self.stiffness).max(initial=0.0)) + self.load_stiffness)

    @property
    def stiffness(self) -> Array:
        """K along directions orthonormal in the metric of the masses [1/s^2]; needs as many positions as speeds."""
        return self.orthonormal.T @ self.K @ self.orthonormal

    @property
    def damping(self) -> Array:
        """C along the same directions [1/s]."""
        return self.orthonormal.T @ self.C @ self.orthonormal


_Function = Callable[[Array, Array], Array]


def _among(positions: list[SmallCoordinate], free: Array, D: Array) -> list[SmallCoordinate]:
    """Those of the coordinates whose rates are independent in the free directions."""
    found: list[SmallCoordinate] = []
    left = np.eye(int(free.shape[1]))
    for c in sorted(positions, key=lambda c: -float(np.linalg.norm(free.T @ c.row) / np.linalg.norm(D * c.row))):
        own = left.T @ (free.T @ c.row)
        if left.shape[1] and float(np.linalg.norm(own)) > 1e-3 * float(np.linalg.norm(D * c.row)):
            found.append(c)
            left = left @ _complement(own)
    return found
