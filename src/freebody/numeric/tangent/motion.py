"""The tangents of a whole motion: phase by phase, and through what happens between two of them.

A phase ends where a guard g vanishes. With d at a fixed time and ' along the motion, the instant moves by

    dt = -(g_z dz + g_p dp)/g',

and the state there by dz + z' dt; after the event z+ = h(z-) it is back at a fixed time as dz+ = h_z (dz- + f- dt) +
h_p dp - f+ dt, the saltation of the event. Where g' vanishes (the motion grazes) nothing of that exists.
Source: Hiskens & Pai, IEEE Trans. Circuits Syst. I 47, 2000, 204-220.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.model.elements import ConstraintRow, NonholonomicForm
from freebody.numeric.contact.bounded import Bounded
from freebody.numeric.contact.hybrid import Hybrid
from freebody.numeric.contact.record import PhaseRecord
from freebody.numeric.contact.rows import ModeOf
from freebody.numeric.engine.course import Status, Trajectory
from freebody.numeric.engine.engine import Engine
from freebody.numeric.engine.operations import ProgramNode
from freebody.numeric.jets import Array
from freebody.numeric.kernels.playing import TURN
from freebody.numeric.options import SimulationOptions
from freebody.numeric.system import NumericSystem
from freebody.numeric.tangent.collocation import N_PLACES, UNSETTLED, instants
from freebody.numeric.tangent.crossing import crossed
from freebody.numeric.tangent.equations import Columns, Equations, Matrices, Matrix
from freebody.numeric.tangent.passed import PassedPhase
from freebody.numeric.tangent.phase import PhaseTangent
from freebody.numeric.tangent.start import Inputs, StartTangent, independent
from freebody.numeric.tangent.tapes import Played
from freebody.numeric.tangent.writing import TangentWriter
from freebody.system.modes import ContactMode, in_mode
from freebody.system.system import System

MOST_ROUNDS = 12  # in which panels are divided
MOST_PARTS = 8.0
SETTLED = 0.1  # the error of a panel goes with the square of how far off it is: a hundredth of the motion's own
TOGETHER = 1e-6  # changes of what is held that should vanish, by the size of all changes


Followed = tuple[Trajectory, Sequence[PhaseRecord]]  # a motion, and its phases with their steps


@dataclass(frozen=True)
class Turn:
    """An instant between two phases: when, and how it changes (k,)."""

    time: float
    change: Array


@dataclass(frozen=True)
class Watched:
    """A measure, or its rate (order 1), that reaches a value."""

    measure: Measure
    order: int
    value: Expr
    name: str


class TangentMotion:
    """One motion under way, with the names by which it is differentiated."""

    def __init__(
        self,
        reference: NumericSystem,
        engine: Engine | Bounded,
        start: Array,
        near: Array,
        names: Sequence[str],
    ) -> None:
        """start: the state (n_y,); near: bearings there. Raises CannotAnswer where the start has no derivative."""
        if reference.system.blows:
            raise CannotAnswer(
                Message(
                    "something is struck or closes during the motion: exact derivatives do not go through such a blow"
                )
            )
        self.reference, self.near, self.start = reference, near, start
        self.bounded = engine if isinstance(engine, Bounded) else None
        self.free = engine.free if isinstance(engine, Bounded) else engine
        self.writer = TangentWriter(reference, names)
        self._count()
        self.angles: dict[int, float] = {}
        self._equations: dict[Any, Equations] = {}
        self._before = StartTangent(self.writer, self._inputs_at_start())
        self.dq, self.dv = self._before.q, self._before.velocities()
        self.phases: list[PassedPhase] = []
        self.turns: list[Turn] = []

    def _count(self) -> None:
        """Everything that counts from the start gets its input."""
        system = self.reference.system
        loads = [m for push in system.applied_loads for m in (push.measure, *(other for _name, other in push.measures))]
        strings = [row.measure for row in system.rows if row.unilateral]
        for measure in (*loads, *system.measures.values(), *strings):
            if not isinstance(measure, NonholonomicForm) and measure.incremental:
                self.writer.origin(measure)

    def _angles_at_start(self) -> dict[int, float]:
        """Angles of lines as the start counts them."""
        w, found = self.writer, dict[int, float]()
        for k in w.angles():
            place = int(w.operation(k)[3])
            here = float(Played(w, [ProgramNode(w, k)]).at(self._inputs_at_start(), np.zeros(1))[0, 0])
            off = [angle - here for (number, _k), angle in self.reference.branches.items() if number == place]
            if off:
                found[k] = here + TURN * round(min(off, key=lambda x: abs(x / TURN - round(x / TURN))) / TURN)
        return found

    def _inputs_at_start(self) -> Inputs:
        return {
            key: float(x[0]) if isinstance(x, np.ndarray) else x
            for key, x in self.writer.inputs(self.start[None]).items()
        }

    # -- the motion ---------------------------------------------------------------------------
    def run(self, until: float, options: SimulationOptions, times: Array, known: Followed | None = None) -> Trajectory:
        """Follows the motion to `until`, and its tangents; they are looked at at the given times. known: the motion,
        where it has been followed and its steps are kept. Raises CannotAnswer where there is no derivative, saying
        why."""
        course, records = known or self._followed(until, replace(options, verify=False))
        if course.status not in (Status.FINISHED, Status.EVENT):
            raise CannotAnswer(Message("the motion cannot be followed: {why}", why=course.message))
        ends = [_panels(record.course, times) for record in records]
        limit = SETTLED * options.tolerance**0.5
        for _ in range(MOST_ROUNDS):
            off = self._tangents(records, ends)
            if all(float(own.max(initial=0.0)) <= limit for own in off):
                return course
            ends = [_divided(own, _too_long(bad, limit)) for own, bad in zip(ends, off, strict=True)]
        raise CannotAnswer(UNSETTLED)

    def _followed(self, until: float, options: SimulationOptions) -> Followed:
        """The motion, and its phases with their steps."""
        self.free.count_from(self.near)
        outputs = np.array([0.0, until])
        if self.bounded is None:
            course = self.free.run(self.start.copy(), until, options, outputs=outputs, keep=True)
            return course, [PhaseRecord(course, self.free, ModeOf(frozenset(), ()))]
        hybrid = Hybrid(self.bounded, options, keep=True)
        return hybrid.run(self.start.copy(), 0.0, until, outputs, self.near), hybrid.phases

    def _tangents(self, records: Sequence[PhaseRecord], ends: Sequence[Array]) -> list[Array]:
        """The tangents of all phases; how far off the panels of each were."""
        self.phases, self.turns = [], []
        q, v, off = self.dq, self.dv, list[Array]()
        for k, (record, own) in enumerate(zip(records, ends, strict=True)):
            states = _states(record, instants(own))
            equations = self._equations_of(record.mode, states[0], own[0])
            if not k:
                self.angles = self._angles_at_start()
            phase = PhaseTangent(equations, self._origins(), self.reference.sizes.unit_moves)
            if k:
                q, v = crossed(self, records[k - 1], record, phase, states[:1], float(own[0]))
            angles = self.phases[-1].tangent.after if k else self.angles
            tangent = phase.along(own, self.writer.inputs(states), angles, q, v)
            passed = PassedPhase(equations, phase, tangent)
            self._check(passed, is_first=not k)
            self.phases.append(passed)
            off.append(tangent.off)
        return off

    def _origins(self) -> Array:
        """(n_origins, k) changes of where measures count from."""
        w = self.writer
        nodes = [w.raw(measure) for _entry, measure in w.origins.values()]
        if not nodes:
            return np.zeros((0, len(w.parameters)))
        parts = Columns(w, ()).parts("", nodes)
        D = Matrices(w, {"q": parts["q"], "p": parts["p"]}).at(self._inputs_at_start(), np.zeros(1))
        return D["q"][0] @ self.dq + D["p"][0][:, : len(w.parameters)]

    def _equations_of(self, mode: Any, state: Array, t: float) -> Equations:
        """The equations of a mode, of whose rows those are kept that do not depend on others."""
        if mode not in self._equations:
            system, loads = self.reference.system, {}
            if self.bounded is not None:
                system, loads = in_mode(system, self._named(mode))
            kept = self._without_redundant(system, state, t)
            dropped = {row.name for row in system.constraint_rows} - {row.name for row in kept.constraint_rows}
            self._equations[mode] = Equations(self.writer, kept, loads, dropped)
        return self._equations[mode]

    def _named(self, mode: ModeOf) -> ContactMode:
        b = self.bounded
        assert b is not None
        if mode.pivots:
            raise CannotAnswer(
                Message(
                    "{end} tips about its rim: exact derivatives do not go through that",
                    end=b.barriers[mode.pivots[0][0]].words[0],
                )
            )
        drags = {
            drag.name: state
            for k, (drag, state) in enumerate(zip(b.drags, mode.drags, strict=True))
            if state is not None and k not in mode.followers
        }
        return ContactMode.of({b.barriers[k].name for k in mode.closed}, drags)

    def _without_redundant(self, system: System, state: Array, t: float) -> System:
        w, rows = self.writer, system.constraint_rows
        if not rows:
            return system
        gradients = [w.by_velocities(w.rate(row.measure)) for row in rows]
        cells = [(i, j, x) for i, row in enumerate(gradients) for j, x in enumerate(row) if x is not None]
        J = Matrices(w, {"J": Matrix((len(rows), len(w.entries)), cells)}).at(w.inputs(state[None]), np.array([t]))[
            "J"
        ][0]
        kept = independent(J * self.reference.sizes.unit_moves)
        return system if len(kept) == len(rows) else replace(system, constraint_rows=tuple(rows[i] for i in kept))

    def note(self, t: float, change: Array) -> None:
        """An instant between two phases."""
        self.turns.append(Turn(t, change))

    # -- checks -------------------------------------------------------------------------------
    def _check(self, passed: PassedPhase, *, is_first: bool) -> None:
        """Raises CannotAnswer where what holds in a phase does not go on holding for other values of the names."""
        unit, of, e = self.reference.sizes.unit_moves, passed.tangent, passed.equations
        size = max(float(np.abs(x / unit[:, None]).max(initial=0.0)) for x in (of.q[0], of.v[0]))
        ideal = {b.name for b in self.bounded.barriers} if self.bounded is not None else set[str]()
        length = self.reference.sizes.length
        for row, changes in zip((e.rows[k] for k in e.places), of.kept, strict=True):
            is_bound = (
                row.name in ideal and not isinstance(row.measure, NonholonomicForm) and not row.measure.incremental
            )
            if is_bound and np.abs(changes).max(initial=0.0) > TOGETHER * (1.0 + size) * length:
                raise _at_once(row, of.times[0])
        for row, changes in zip(e.rows, of.parted, strict=True):
            if np.abs(changes).max(initial=0.0) > TOGETHER * (1.0 + size) * max(1.0, length):
                raise _at_once(row, of.times[0])
        if is_first:
            y = self.start
            moved = [
                float(np.ravel(of.inputs[self.writer.velocity(k)])[0]) - y[self.writer.velocity(k)]
                for k in self.writer.entries
            ]
            if np.abs(np.array(moved) / unit).max(initial=0.0) > TOGETHER * max(1.0, float(np.abs(y).max())):
                raise CannotAnswer(Message("the motion begins with an impact: exact derivatives do not go through it"))


def _at_once(row: ConstraintRow, t: float) -> CannotAnswer:
    return CannotAnswer(
        Message(
            "at t = {t:.6g} s several things happen at once at {row}, which other values would separate: the motion "
            "has no derivative from there on",
            t=t,
            row=row.name,
        )
    )


def _states(record: PhaseRecord, times: Array) -> Array:
    """(n, n_y) at instants of a phase, the first and the last of which are its own."""
    course, engine = record.course, record.engine
    first, last = engine.state_at(course, 0), engine.state_at(course, -1)
    inner = course.steps.states(times[1:-1]) if course.steps is not None else np.empty((0, len(first)))
    return np.concatenate((first[None], inner, last[None])) if len(times) > 1 else first[None]


def _panels(course: Trajectory, times: Array) -> Array:
    """The ends of panels of a phase: those of the steps of the motion, and the times at which something is wanted."""
    first, last = float(course.times[0]), course.t_end
    steps = np.zeros(0) if course.steps is None else course.steps.begins
    inner = np.concatenate((times, [e.time for e in course.events], steps))
    found = np.unique(np.concatenate(([first, last], inner[(inner > first) & (inner < last)])))
    apart = np.concatenate(([True], np.diff(found) > 1e-13 * max(1.0, abs(last))))
    return found[apart] if apart[-1] else np.append(found[apart][:-1], last)


def _too_long(off: Array, limit: float) -> Array:
    """(n_panels,) in how many parts panels are to be divided, as their order of accuracy tells."""
    parts = np.clip(np.ceil(1.1 * (np.maximum(off, limit) / limit) ** (1.0 / N_PLACES)), 1.0, MOST_PARTS)
    return np.where(off <= limit, 1.0, parts)


def _divided(ends: Array, parts: Array) -> Array:
    """The ends of panels, each in some equal parts."""
    steps = np.repeat(np.diff(ends) / parts, parts.astype(int))
    number: Array = np.concatenate([np.arange(float(n)) for n in parts])
    return np.append(np.repeat(ends[:-1], parts.astype(int)) + number * steps, ends[-1])
