"""The reference route: a system in plain numbers, by the shortest way from the statements of its measures.

Absolute coordinates q hold x, y and theta of every moving body (a particle has no theta). With J the
gradients of the held measures, the accelerations a and the multipliers lambda solve

    M a = Q + J^T lambda,        J a = target'' - bias.

Every solution is rank-revealing in the metric of the masses, so redundant connections are allowed and
massless bodies too; what is then not unique is refused by name. SI units throughout, angles in rad.
Source: Nikravesh, Computer-Aided Analysis of Mechanical Systems, 1988, ch. 7 and 8.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence

import numpy as np

from freebody.errors import CannotAnswer, InputError
from freebody.language.expression import Expr, evaluate
from freebody.language.natural import natural
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.measures.geometry import SpatialPose
from freebody.model.elements import ConstraintRow, NonholonomicForm, RigidBody
from freebody.numeric import spatial
from freebody.numeric.checks import finite, named
from freebody.numeric.jets import TIME, Array, Branch, Frame, Jet, JetGeometry
from freebody.numeric.linearised import frequencies, linearised
from freebody.numeric.numbers import Numbers
from freebody.numeric.placing import Placing, PoseEquation
from freebody.numeric.rotation import matrix
from freebody.numeric.sizes import Sizes, neighbours, typical_length
from freebody.numeric.snapshot import Snapshot
from freebody.numeric.split import Split, stack
from freebody.numeric.start import N_STARTS, assembled, start_pose, start_velocities
from freebody.numeric.trajectory import ReferenceTrajectory, integrate
from freebody.system.description import merged
from freebody.system.parts import cut_out
from freebody.system.system import System


class Reference:
    """One system with a number for every parameter."""

    def __init__(self, system: System, values: Mapping[str, float] | None = None) -> None:
        """values: by parameter name, in SI; a parameter left out keeps the value of the model. Raises
        CannotAnswer naming the parameters without a value."""
        self.system = system
        numbers = _numbers(system, values or {})
        columns: dict[str, tuple[int, ...]] = {}
        n_places, n_turns = (3, 3) if system.space else (2, 1)
        for body in system.moving:
            n = sum(map(len, columns.values()))
            columns[body.name] = tuple(range(n, n + n_places + (n_turns if body.turns else 0)))
        self.frame = Frame(columns, {}, numbers)
        self._moments = {body.name: self._moments_of(body) for body in system.moving}
        principal = {name: axes for name, (_moments, axes) in self._moments.items()} if system.space else {}
        self.frame = Frame(columns, {}, numbers, system.space, principal)
        fixed = {b.name: tuple(start_pose(system, b, self.number)) for b in system.bodies.values() if b.fixed}
        self.frame = Frame(columns, fixed, numbers, system.space, principal)
        inertia = [[self.number(b.mass)] * n_places + list(self._moments[b.name][0]) for b in system.moving]
        listed = [m for own, b in zip(inertia, system.moving, strict=True) for m in own[: len(columns[b.name])]]
        self.masses = np.array(listed, dtype=np.float64)
        turning = np.array([i >= n_places for c in columns.values() for i in range(len(c))], dtype=bool)
        near = neighbours(system, self.number, [own[0] for own in inertia], [own[n_places:] for own in inertia])
        by_coordinate = [n for n, b in zip(near, system.moving, strict=True) for _ in columns[b.name]]
        self.sizes = Sizes.of(self.masses, turning, typical_length(system, self.number), by_coordinate)
        self.placing = Placing(self.frame, self.sizes)
        self._parts: dict[frozenset[str], Reference] = {}
        self._branches: dict[Branch, float] = {}
        self._origins: dict[int, float] | None = None
        self._without_origin: dict[int, str] = {}  # by number of a measure: why it has no value at the start

    def _moments_of(self, body: RigidBody) -> tuple[Array, Array]:
        """Moments of inertia, in space about the principal axes, and these axes."""
        with named(f"the inertia of {body.name}"):
            if not self.system.space:
                return np.array([self.number(body.inertia)]), spatial.UNIT
            return spatial.principal_axes(spatial.tensor_of(body, self.number))

    # -- parts --------------------------------------------------------------------------------
    def groups_joined_by(self, measures: Iterable[Measure | NonholonomicForm]) -> list[frozenset[str]]:
        """The moving bodies, as sets of those that the model or one of some measures joins."""
        groups = merged(self.system.groups, (set(measure.bodies()) for measure in measures))
        return sorted(groups, key=lambda group: natural(min(group, key=natural)))

    def part(self, group: frozenset[str]) -> Reference:
        """The bodies of a group, and those that do not move, alone."""
        if group not in self._parts:
            self._parts[group] = Reference(cut_out(self.system, group), self.frame.values)
        return self._parts[group]

    # -- poses and velocities -----------------------------------------------------------------
    def columns(self, body: str) -> tuple[int, ...]:
        """Where the coordinates of a moving body stand in q: x, y and theta; in space x, y, z and a rotation vector."""
        return self.frame.columns[body]

    def pose(self, q: Array, body: str) -> tuple[float, ...]:
        """x, y of the mass centre [m] and the angle [rad] of a body; in space x, y, z and, row by row, the rotation
        matrix, whose columns are the body's axes."""
        pose = self.geometry(q, np.zeros_like(q), 0.0).pose(body)
        if isinstance(pose, SpatialPose):
            center, R = self.frame_of(q, body)
            return (*center, *R.ravel())
        return pose.x.value, pose.y.value, pose.angle.value

    def frame_of(self, q: Array, body: str) -> tuple[Array, Array]:
        """Of a body in space: its mass centre (3,) [m], and its axes, the columns of a rotation (3, 3)."""
        pose = self.geometry(q, np.zeros_like(q), 0.0).pose(body)
        assert isinstance(pose, SpatialPose)
        vectors = (pose.center, *pose.axes)
        center, *axes = (np.array([v.x.value, v.y.value, 0.0 if v.z is None else v.z.value]) for v in vectors)
        return center, np.array(axes).T

    def angular_velocity(self, q: Array, v: Array, body: str) -> Array:
        """(3,) [rad/s] of a body in space, along the axes of the ground."""
        own = list(self.columns(body)[3:]) if body in self.frame.columns else []
        return matrix(q[own]) @ v[own] if own else np.zeros(3)

    def assemble(
        self,
        extra: Sequence[tuple[Measure | NonholonomicForm, float]] = (),
        guess: Array | None = None,
        n_starts: int = N_STARTS,
    ) -> Array:
        """The pose at t = 0: the held measures hold, the start of the model is as described, and the `extra`
        measures have the given values (which replace those of the model's start). What is left free stays near zero,
        or near the `guess`: each step on the way is the smallest by the masses. From here on measures of which only
        changes mean something count from this pose. n_starts: disturbed guesses that are tried after the guess itself,
        the first of them near it.

        Returns q. Raises CannotAnswer naming the row with the largest gap if this is contradictory."""
        fit = assembled(self, extra, guess, n_starts)
        if self.system.mode is not None and guess is None and not extra:
            from freebody.numeric.mobility.modes import chosen

            self._remember(fit.q, fit.branches)
            fit = assembled(self, extra, chosen(self, fit.q, self.system.mode))
        self._remember(fit.q, fit.branches)
        return fit.q

    def count_from(self, other: Reference, q: Array) -> None:
        """Measures of which only changes mean something count from a pose of the same bodies, in which another
        reference was assembled: what is held here need not hold there."""
        self._remember(q, other._branches)

    def pose_near(self, q: Array, wanted: Sequence[tuple[Measure, float]] = (), t: float = 0.0) -> Array:
        """The nearest pose, by the masses, in which everything that q holds is still held and the `wanted`
        measures have the given values. Raises CannotAnswer if there is none in reach."""
        equations = self.held_where(q, 0.0) + [PoseEquation.of(self.name_of(m), m, Jet(x)) for m, x in wanted]
        return self.placing.placed(q, equations, t, self._branches).q

    def wander(self, q: Array, rng: np.random.Generator, size: float, t: float = 0.0) -> tuple[Array, Array]:
        """A pose and velocities (q, v) near q that hold what q holds, otherwise arbitrary: the free
        directions are moved by about `size` (of the system's size, or radians) and run at about one size (or
        radian) a second. Raises CannotAnswer if there is none."""

        def along(free: Array, size: float) -> Array:
            # what a disturbance has along the free directions, so that it hangs on no basis of them
            scaled = free / self.sizes.unit_moves[:, None]
            step: Array = free @ np.linalg.lstsq(scaled, self.noise(rng), rcond=None)[0]
            return step * (size / (float(self.sizes.relative(step).max(initial=0.0)) or 1.0))

        step = along(self.split_at(q, self._branches).null, size)
        here = self.placing.placed(self.frame.moved(q, step), self.held_where(q, 0.0), t, self._branches).q
        free = self.split_at(here, self._branches, t).null
        return here, along(free, 1.0) + self.velocities(here, (), t, with_start=False)

    def noise(self, rng: np.random.Generator) -> Array:
        """(n,) normal deviates, drawn body by body in an order that neither the file nor units change: by how many rows
        hold them, by mass, then by name."""
        n_rows = {b.name: sum(b.name in row.measure.bodies() for row in self.system.held) for b in self.system.moving}

        def rank(name: str) -> tuple[object, ...]:
            return -n_rows[name], float(f"{self.masses[self.columns(name)[0]]:.9g}"), natural(name)

        columns = [column for name in sorted(n_rows, key=rank) for column in self.columns(name)]
        found = np.zeros(len(self.masses))
        found[columns] = rng.standard_normal(len(columns))
        return found

    def velocities(
        self,
        q: Array,
        extra: Sequence[tuple[Measure | NonholonomicForm, float]] = (),
        t: float = 0.0,
        *,
        with_start: bool = True,
    ) -> Array:
        """Velocities of least kinetic energy [m/s, rad/s] that hold what is held and have the rates of the
        model's start; `extra` rates replace those. Without `with_start` only the `extra` rates are asked for.
        Raises CannotAnswer naming a rate that contradicts."""
        return start_velocities(self, self.geometry(q, np.zeros_like(q), t), extra, with_start=with_start)

    # -- instants and motions -----------------------------------------------------------------
    def snapshot(self, q: Array, v: Array, t: float = 0.0, near: Snapshot | None = None) -> Snapshot:
        """The system at one instant; its accelerations and reactions are found when they are first asked for.
        Angles of lines are counted on from those of `near`, or of the start."""
        if not (np.isfinite(q).all() and np.isfinite(v).all() and math.isfinite(t)):
            raise CannotAnswer(Message("the state at t = {t:.6g} s is not finite", t=t))
        return Snapshot(self, self.geometry(q, v, t, near.branches if near else None), q, v, t)

    def integrate(
        self,
        start: Snapshot | tuple[Array, Array],
        until: float,
        event: Callable[[Snapshot], float] | None = None,
    ) -> ReferenceTrajectory:
        """The motion from `start` (a snapshot, or (q, v) at t = 0) until the time `until` [s], or until the
        first later time at which `event` crosses zero. Raises CannotAnswer if the event does not happen."""
        now = start if isinstance(start, Snapshot) else self.snapshot(*start)
        return integrate(self, now, until, event)

    def linearised(self, q: Array) -> tuple[Array, Array]:
        """(M, K) of the small undamped motions M z'' + K z = 0 about the equilibrium q, z along independent
        directions. Raises CannotAnswer if q is no equilibrium."""
        return linearised(self, q, self._branches)

    def frequencies(self, q: Array) -> Array:
        """Natural angular frequencies [rad/s] of the undamped system about the equilibrium pose q, ascending;
        0 for a direction without stiffness. Raises CannotAnswer if the equilibrium is unstable."""
        return frequencies(*self.linearised(q))

    # -- rows ---------------------------------------------------------------------------------
    def geometry(self, q: Array, v: Array, t: float, near: Mapping[Branch, float] | None = None) -> JetGeometry:
        """What measures see at one instant; angles of lines are counted on from `near`, or from the start."""
        return JetGeometry(self.frame, q, v, t, self._branches if near is None else near)

    def jet(self, g: JetGeometry, measure: Measure | NonholonomicForm, name: str = "") -> Jet:
        """The jet of a measure; raises CannotAnswer where it has no finite value."""
        with named(name or (lambda: self.name_of(measure))):
            jet = g.of(measure)
            finite(jet.value + jet.rate + jet.bias)
            return jet

    def gap(self, row: ConstraintRow, g: JetGeometry) -> Jet:
        """How far a held measure is from its target; the value leaves out a constant of incremental ones."""
        return self.jet(g, row.measure, row.name) - _target(row, g)

    def held_by_targets(self) -> list[PoseEquation]:
        """Equations of the held measures whose targets are known before the start pose is."""
        return [_at_target(row) for row in self.system.held if _holds_a_place(row)]

    def held_where(self, q: Array, t: float) -> list[PoseEquation]:
        """Equations of all held measures; those that keep a start value keep the one they have at q."""
        g = self.geometry(q, np.zeros_like(q), t)
        equations: list[PoseEquation] = []
        for row in self.system.held:
            if _holds_a_place(row):
                equations.append(_at_target(row))
            elif not isinstance(row.measure, NonholonomicForm):
                kept = Jet(self.jet(g, row.measure, row.name).value)
                equations.append(PoseEquation.of(row.name, row.measure, kept))
        return equations

    def split_at(self, q: Array, near: Mapping[Branch, float], t: float = 0.0) -> Split:
        """What the held measures determine at a pose, and what they leave free."""
        g = self.geometry(q, np.zeros_like(q), t, near)
        rows = [self.gap(row, g).row(len(q)) for row in self.system.held]
        return Split(stack(rows, len(q)), self.sizes.small_moves)

    # -- where measures count from ------------------------------------------------------------
    def _remember(self, q: Array, branches: Mapping[Branch, float]) -> None:
        """From this pose incremental measures count, and the angles of lines go on from here."""
        g = self.geometry(q, np.zeros_like(q), 0.0, branches)
        everything: list[tuple[str, Measure | NonholonomicForm]] = [
            *((row.name, row.measure) for row in self.system.held),
            *((push.name, push.measure) for push in self.system.pushes),
            *((name, m) for push in self.system.pushes for name, m in push.measures),
            *self.system.measures.items(),
            *self.system.offered,
        ]
        origins: dict[int, float] = {}
        for name, measure in everything:
            counts = not isinstance(measure, NonholonomicForm) and measure.incremental
            try:
                jet = self.jet(g, measure, name)
            except CannotAnswer as error:
                if counts:
                    self._without_origin[self.frame.number(measure)] = str(error)
            else:
                if counts:
                    origins[self.frame.number(measure)] = jet.value
        self._branches, self._origins = g.angles, origins

    def start_value(self, measure: Measure) -> float:
        """The value from which a measure counts: at the start for one of which only changes mean something,
        zero for all others."""
        if not measure.incremental:
            return 0.0
        if self._origins is None:
            self.assemble()
        origin = (self._origins or {}).get(self.frame.number(measure))
        if origin is None:
            why = self._without_origin.get(self.frame.number(measure), Message("a measure that counts from the start"))
            raise CannotAnswer(Message("{what}: it has no value at the start", what=why))
        return origin

    # -- for the engine -----------------------------------------------------------------------
    def numbers(self) -> Numbers:
        """What the engine needs to know."""
        fixed = {name: tuple(map(float, p)) for name, p in self.frame.fixed.items()}
        return Numbers(
            self.system, self.frame.values, self.sizes.length, fixed, self.number, self.start_value, self._moments
        )

    def by_body(self, q: Array, v: Array) -> tuple[Array, Array]:
        """(n_bodies, 3) poses and velocities; a body that does not turn keeps its angle. In space (n_bodies, 6)."""
        if self.system.space:
            return self._by_body_in_space(q), self._by_body_in_space(v)
        poses = np.zeros((len(self.frame.columns), 3))
        velocities = np.zeros_like(poses)
        for k, (name, columns) in enumerate(self.frame.columns.items()):
            n = len(columns)
            poses[k, :n], velocities[k, :n] = q[list(columns)], v[list(columns)]
            if n < 3:
                poses[k, 2] = self.pose(q, name)[2]
        return poses, velocities

    def _by_body_in_space(self, array: Array) -> Array:
        full = np.zeros((len(self.frame.columns), 6))
        for k, columns in enumerate(self.frame.columns.values()):
            full[k, : len(columns)] = array[list(columns)]
        return full

    def by_column(self, array: Array) -> Array:
        """The coordinates, from an array (n_bodies, 3) of all bodies; in space (n_bodies, 6)."""
        return np.concatenate([array[k, : len(c)] for k, c in enumerate(self.frame.columns.values())] or [np.zeros(0)])

    # -- numbers and names --------------------------------------------------------------------
    def number(self, expr: Expr, t: float = 0.0) -> float:
        """Value of an expression in the parameters and time."""
        with named("a number of the model"):
            return finite(evaluate(expr, {**self.frame.values, TIME: t}))

    def name_of(self, measure: Measure | NonholonomicForm) -> str:
        """What the user calls a measure."""
        names = [name for name, known in self.system.measures.items() if known == measure]
        names += [row.name for row in (*self.system.rows, *self.system.pushes) if row.measure == measure]
        return next(iter(names), "the measure")

    def most_moved(self, motion: Array) -> str:
        """The body that moves most, by the size of the system."""
        relative = self.sizes.relative(motion)
        return max(self.frame.columns, key=lambda body: max(relative[list(self.columns(body))]))


def _numbers(system: System, values: Mapping[str, float]) -> dict[str, float]:
    unknown = sorted(set(values) - set(system.parameters))
    if unknown:
        known = ", ".join(system.parameters)
        raise InputError(f"there is no parameter {', '.join(unknown)}; the system has {known}")
    given = {p.name: p.value for p in system.parameters.values() if p.form is None} | dict(values)
    missing = [name for name, value in given.items() if value is None]
    if missing:
        open_ = [name for name in missing if name in system.unspecified]
        where = "at its place in the model" if open_ == missing else "under parameters"
        raise CannotAnswer(
            Message("numbers need a value for {names}; give one {how}", names=", ".join(missing), how=where)
        )
    return {name: float(value) for name, value in given.items() if value is not None}


def _holds_a_place(row: ConstraintRow) -> bool:
    """Whether the target of a held measure is known before the start pose is."""
    return not isinstance(row.measure, NonholonomicForm) and (row.target is not None or not row.measure.incremental)


def _target(row: ConstraintRow, g: JetGeometry) -> Jet:
    with named(row.name):
        return Jet(0.0) if row.target is None else g.scalar(row.target)


def _at_target(row: ConstraintRow) -> PoseEquation:
    return PoseEquation.of(row.name, row.measure, lambda g: _target(row, g))
