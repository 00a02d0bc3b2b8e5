"""A system in plain numbers: what the reference route knows of it before it assembles or moves it.

Absolute coordinates q hold x, y and theta of every moving body (a particle has no theta). SI units throughout, angles
in rad.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Self

import numpy as np

from freebody.errors import CannotAnswer, InputError
from freebody.language.expression import Expr, Number, evaluate
from freebody.language.natural import natural
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.measures.geometry import SpatialPose
from freebody.model.elements import ConstraintRow, NonholonomicForm, RigidBody
from freebody.numeric import spatial
from freebody.numeric.checks import finite, named
from freebody.numeric.described import start_pose
from freebody.numeric.jet_geometry import Branch, Frame, JetGeometry
from freebody.numeric.jets import TIME, Array, Jet
from freebody.numeric.numbers import Numbers
from freebody.numeric.placing import Placing, PoseEquation
from freebody.numeric.rotation import matrix
from freebody.numeric.sizes import Sizes, neighbours, typical_length
from freebody.numeric.split import Split, stack
from freebody.system.description import merged
from freebody.system.parts import cut_out
from freebody.system.system import System

_A_NUMBER = Message("a number of the model")


class NumericSystem:
    """One system with a number for every parameter."""

    def __init__(self, system: System, values: Mapping[str, float] | None = None) -> None:
        """values: by parameter name, in SI; a parameter left out keeps the value of the model. Raises
        CannotAnswer naming the parameters without a value."""
        self.system = system
        # at t = 0, with the tree whose number it is and the values of the parameters
        self._known_numbers: dict[int, tuple[Expr, Mapping[str, float], float]] = {}
        numbers = _numbers(system, values or {})
        columns: dict[str, tuple[int, ...]] = {}
        n_places, n_turns = (3, 3) if system.space else (2, 1)
        n = 0
        for body in system.all_moving:
            columns[body.name] = tuple(range(n, n + n_places + (n_turns if body.turns else 0)))
            n += len(columns[body.name])
        self.frame = Frame(columns, {}, numbers)
        self._moments = {body.name: self._moments_of(body) for body in system.all_moving}
        principal = {name: axes for name, (_moments, axes) in self._moments.items()} if system.space else {}
        self.frame = Frame(columns, {}, numbers, system.space, principal)
        fixed = {b.name: tuple(start_pose(system, b, self.number)) for b in system.bodies.values() if b.fixed}
        self.frame = Frame(columns, fixed, numbers, system.space, principal)
        inertia = [[self.number(b.mass)] * n_places + list(self._moments[b.name][0]) for b in system.all_moving]
        listed = [m for own, b in zip(inertia, system.all_moving, strict=True) for m in own[: len(columns[b.name])]]
        self.masses = np.array(listed, dtype=np.float64)
        turning = np.array([i >= n_places for c in columns.values() for i in range(len(c))], dtype=bool)
        near = neighbours(system, self.number, [own[0] for own in inertia], [own[n_places:] for own in inertia])
        by_coordinate = [n for n, b in zip(near, system.all_moving, strict=True) for _ in columns[b.name]]
        self.sizes = Sizes.of(self.masses, turning, typical_length(system, self.number), by_coordinate)
        self.placing = Placing(self.frame, self.sizes)
        self._parts: dict[frozenset[str], Self] = {}
        self.branches: dict[Branch, float] = {}
        self._origins: dict[int, float] | None = None
        # the pose that was remembered last, with the angles that were met there
        self._remembered: tuple[JetGeometry, Mapping[Branch, float]] | None = None
        self._without_origin: dict[int, str] = {}  # by number of a measure: why it has no value at the start

    def _moments_of(self, body: RigidBody) -> tuple[Array, Array]:
        """Moments of inertia, in space about the principal axes, and these axes."""
        with named(Message("the inertia of {body}", body=body.name)):
            if not self.system.space:
                return np.array([self.number(body.inertia)]), spatial.UNIT
            return spatial.principal_axes(spatial.tensor_of(body, self.number))

    # -- parts --------------------------------------------------------------------------------
    def groups_joined_by(self, measures: Iterable[Measure | NonholonomicForm]) -> list[frozenset[str]]:
        """The moving bodies, as sets of those that the model or one of some measures joins."""
        groups = merged(self.system.groups, (set(measure.bodies()) for measure in measures))
        return sorted(groups, key=lambda group: natural(min(group, key=natural)))

    def part(self, group: frozenset[str]) -> Self:
        """The bodies of a group, and those that do not move, alone."""
        if group not in self._parts:
            self._parts[group] = type(self)(cut_out(self.system, group), self.frame.values)
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

    def count_from(self, other: NumericSystem, q: Array) -> None:
        """Measures of which only changes mean something count from a pose of the same bodies, in which another
        reference was assembled: what is held here need not hold there."""
        self.remember(q, other.branches)

    def pose_near(self, q: Array, wanted: Sequence[tuple[Measure, float]] = (), t: float = 0.0) -> Array:
        """The nearest pose, by the masses, in which everything that q holds is still held and the `wanted`
        measures have the given values. Raises CannotAnswer if there is none in reach."""
        equations = self.held_where(q, 0.0) + [PoseEquation.of(self.name_of(m), m, Jet(x)) for m, x in wanted]
        return self.placing.placed(q, equations, t, self.branches).q

    def by_rows(self) -> list[str]:
        """Moving bodies in an order that neither the file nor units nor other numbers of parameters change, so that a
        side that nobody gives is the same at all of them: by how many rows hold them, the most first, by the mass that
        the model gives, then by name."""
        own = {p.name: 1.0 if p.value is None else p.value for p in self.system.parameters.values()}
        masses = {b.name: evaluate(b.mass, {**self.frame.values, **own, TIME: 0.0}) for b in self.system.all_moving}
        n_rows = dict.fromkeys(self.frame.columns, 0)
        for row in self.system.constraint_rows:
            for name in n_rows.keys() & set(row.measure.bodies()):
                n_rows[name] += 1

        def rank(name: str) -> tuple[object, ...]:
            return -n_rows[name], float(f"{masses[name]:.9g}"), natural(name)

        return sorted(n_rows, key=rank)

    def noise(self, rng: np.random.Generator) -> Array:
        """(n,) normal deviates, drawn body by body."""
        columns = [column for name in self.by_rows() for column in self.columns(name)]
        found = np.zeros(len(self.masses))
        found[columns] = rng.standard_normal(len(columns))
        return found

    # -- rows ---------------------------------------------------------------------------------
    def geometry(self, q: Array, v: Array, t: float, near: Mapping[Branch, float] | None = None) -> JetGeometry:
        """What measures see at one instant; angles of lines are counted on from `near`, or from the start."""
        return JetGeometry(self.frame, q, v, t, self.branches if near is None else near)

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
        return [_at_target(row) for row in self.system.constraint_rows if _holds_a_place(row)]

    def held_where(self, q: Array, t: float) -> list[PoseEquation]:
        """Equations of all held measures; those that keep a start value keep the one they have at q."""
        g = self.geometry(q, np.zeros_like(q), t)
        equations: list[PoseEquation] = []
        for row in self.system.constraint_rows:
            if _holds_a_place(row):
                equations.append(_at_target(row))
            elif not isinstance(row.measure, NonholonomicForm):
                kept = Jet(self.jet(g, row.measure, row.name).value)
                equations.append(PoseEquation.of(row.name, row.measure, kept))
        return equations

    def split_at(self, q: Array, near: Mapping[Branch, float], t: float = 0.0) -> Split:
        """What the held measures determine at a pose, and what they leave free."""
        g = self.geometry(q, np.zeros_like(q), t, near)
        rows = [self.gap(row, g).row(len(q)) for row in self.system.constraint_rows]
        return Split(stack(rows, len(q)), self.sizes.small_moves)

    # -- where measures count from ------------------------------------------------------------
    def remember(self, q: Array, branches: Mapping[Branch, float]) -> None:
        """From this pose incremental measures count, and the angles of lines go on from here."""
        self.remember_at(self.geometry(q, np.zeros_like(q), 0.0, branches))

    def remember_at(self, g: JetGeometry) -> None:
        """The same of a pose that was looked at already, without velocities at t = 0."""
        if g.frame is not self.frame:  # of a part
            g = self.geometry(g.q, np.zeros_like(g.q), 0.0, g.angles)
        everything: list[tuple[str, Measure | NonholonomicForm]] = [
            *((row.name, row.measure) for row in self.system.constraint_rows),
            *((push.name, push.measure) for push in self.system.all_loads),
            *((name, m) for push in self.system.all_loads for name, m in push.measures),
            *self.system.all_measures.items(),
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
        self.branches, self._origins = dict(g.angles), origins
        self._remembered = g, self.branches

    def at_rest(self, q: Array, t: float = 0.0) -> JetGeometry:
        """What measures see at a pose without velocities; that of the start was looked at already."""
        if self._remembered is not None:
            g, branches = self._remembered
            is_same = g.frame is self.frame and branches is self.branches
            if t == 0.0 and is_same and np.array_equal(g.q, q):
                return g
        return self.geometry(q, np.zeros_like(q), t)

    @property
    def counts(self) -> bool:
        """Whether it is known from where incremental measures count."""
        return self._origins is not None

    def start_value(self, measure: Measure) -> float:
        """The value from which a measure counts: at the start for one of which only changes mean something,
        zero for all others."""
        if not measure.incremental:
            return 0.0
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
        if isinstance(expr, Number):
            return float(expr.value)
        values = self.frame.values
        known = self._known_numbers.get(id(expr)) if t == 0.0 else None  # the same trees are asked for many times
        if known is None or known[1] is not values:
            known = expr, values, self._number(expr, t)
            if t == 0.0:
                self._known_numbers[id(expr)] = known
        return known[2]

    def _number(self, expr: Expr, t: float) -> float:
        with named(_A_NUMBER):
            return finite(evaluate(expr, {**self.frame.values, TIME: t}))

    def name_of(self, measure: Measure | NonholonomicForm) -> str:
        """What the user calls a measure."""
        names = [name for name, known in self.system.all_measures.items() if known == measure]
        names += [row.name for row in (*self.system.rows, *self.system.all_loads) if row.measure == measure]
        return next(iter(names), "the measure")

    def most_moved(self, motion: Array) -> str:
        """The body that moves most, by the size of the system."""
        relative = self.sizes.relative(motion)
        return max(self.frame.columns, key=lambda body: max(relative[list(self.columns(body))]))


def _numbers(system: System, values: Mapping[str, float]) -> dict[str, float]:
    unknown = sorted(set(values) - set(system.parameters))
    if unknown:
        known = ", ".join(system.parameters)
        raise InputError(
            Message("there is no parameter {unknown}; the system has {known}", unknown=", ".join(unknown), known=known)
        )
    given = {p.name: p.value for p in system.parameters.values() if p.form is None} | dict(values)
    missing = [name for name, value in given.items() if value is None]
    if missing:
        open_ = [name for name in missing if name in system.unspecified]
        where = Message("at its place in the model" if open_ == missing else "under parameters")
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
