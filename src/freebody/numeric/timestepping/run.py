"""One motion by time stepping, from Python: steps in chunks, candidates, outputs, and what is said of the result."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from freebody.errors import InputError
from freebody.language.sentences import Message, further, in_turn
from freebody.measures.base import Measure
from freebody.numeric.engine.course import NO_TRACKS, Status, Trajectory
from freebody.numeric.engine.lending import OF_LIGHTEST
from freebody.numeric.engine.motion import stopped
from freebody.numeric.kernels import march, marching
from freebody.numeric.kernels.arrays import Floats
from freebody.numeric.kernels.march import March
from freebody.numeric.kernels.measures_planar import NEAR
from freebody.numeric.kernels.rows import IMPULSE, KIND, NORMAL, OF_BOUND, OF_SITE, ORIGIN, SOURCE
from freebody.numeric.numbers import Numbers
from freebody.numeric.options import SimulationOptions
from freebody.numeric.timestepping.scene import KEPT, ContactScene

Progress = Callable[[float, int], None]
TOLERANCE = 1e-12
MOST_SWEEPS = 200
STEPS_AT_ONCE = 2_000


@dataclass(frozen=True)
class ContactForces:
    """Mean forces of closed contacts over the step that ends at an output time."""

    ptr: NDArray[np.intp]  # (n_times + 1,): those of time k are ptr[k]:ptr[k + 1]
    origin: NDArray[np.intp]  # 0: a pair of outlines, 1: another bound
    pair: NDArray[np.intp]  # of `System.contacts`, or the bound
    place: NDArray[np.intp]  # among the sites of the pair
    normal: Floats  # [N]
    friction: Floats  # [N], positive where it pushes the slip measure on


@dataclass(frozen=True)
class Stepped:
    """A motion by time stepping: a `Trajectory`, and what the contacts did. `course.work` includes `losses`."""

    course: Trajectory
    scene: ContactScene = field(repr=False)
    step: float  # [s]
    contacts: ContactForces
    losses: Floats  # (n_times,): work of contacts and friction since the start, negative [J]
    penetration: float  # the deepest, after each step [m]
    residual: float  # the largest change of a velocity in the last sweep of a step [m/s or rad/s]
    n_capped: int  # steps whose iteration ended at the cap

    def names(self) -> list[str]:
        """The name of every entry of `contacts`."""
        c, known = self.contacts, dict[tuple[int, int, int], str]()
        found: list[str] = []
        for row in np.column_stack([c.origin, c.pair, c.place]):
            key = int(row[0]), int(row[1]), int(row[2])
            if key not in known:
                bound = self.scene.parts.bounds[key[1]] if key[0] else None
                known[key] = self.scene.site_name(key[1], key[2]) if bound is None else bound.name
            found.append(known[key])
        return found


def run_moreau(
    numbers: Numbers,
    poses: Floats,
    velocities: Floats,
    until: float,
    options: SimulationOptions,
    *,
    start: float = 0.0,
    outputs: Floats | None = None,
    tolerance: float = TOLERANCE,
    max_sweeps: int = MOST_SWEEPS,
    progress: Progress | None = None,
    value: Callable[[Measure], float] | None = None,
    scene: ContactScene | None = None,
) -> Stepped:
    """The motion from `start` to `until` [s] in steps of at most the step of the options, all of one length.

    poses, velocities: (n_bodies, 3) at the start, in the order of `System.moving` [m, rad; m/s, rad/s]. outputs: times
    at which the motion is wanted, each moved to the end of the step in which it lies. tolerance: what a sweep over the
    contacts may still change, by the speeds. value: of measures at the start, from which turns are counted. scene: of
    an earlier run of the same system.

    Raises InputError for a step without sense; what goes wrong later is a status of the course.
    """
    step = min(options.step or math.inf, options.longest)
    if not (step > 0.0 and math.isfinite(step) and until > start):
        raise InputError(
            Message(
                "time stepping needs a step between 0 and {most:g} s, not {step:g} s", most=until - start, step=step
            )
        )
    scene = ContactScene(numbers) if scene is None else scene
    return _Run(scene, poses, velocities, start, until, step, tolerance, max_sweeps, value).result(
        outputs, options, progress
    )


class _Run:
    def __init__(
        self,
        scene: ContactScene,
        poses: Floats,
        velocities: Floats,
        start: float,
        until: float,
        step: float,
        tolerance: float,
        max_sweeps: int,
        value: Callable[[Measure], float] | None,
    ) -> None:
        self.scene, self.start = scene, start
        self.n_steps = max(1, math.ceil((until - start) / step * (1.0 - 1e-12)))
        self.step = (until - start) / self.n_steps
        packed, n = scene.packed, scene.n_bodies + 1
        self.march = March(
            clock=np.zeros(march.N_CLOCK),
            count=np.zeros(march.N_COUNT, np.int32),
            **{name: np.zeros((n, 3)) for name in ("q", "v", "middle", "free", "bare", "new")},
            held_impulse=np.zeros(len(packed.layout.held)),
            is_jointed=scene.is_jointed,
            is_whole=np.zeros(n, np.int32),
            circle_body=scene.circle_body,
            circle=scene.circle,
            circle_built=np.zeros_like(scene.circle),
        )
        m = self.march
        m.q[:-1], m.v[:-1] = poses, velocities
        m.clock[march.NOW], m.clock[march.STEP] = start, self.step
        m.clock[march.TOLERANCE], m.clock[march.SLOP] = tolerance, scene.slop
        m.count[march.MOST_SWEEPS] = max_sweeps
        if value is not None:
            packed.align(packed.state(poses, velocities), start, value)
        scene.fixtures.bound_memory[:] = 0.0
        scene.fixtures.friction_memory[:] = 0.0
        scene.built.arrays.memory[:] = 0.0
        scene.built.arrays.pair[:, 1] = -1
        self._look()
        self._states: list[tuple[float, Floats, Floats, Floats, Floats, float, float]] = []
        self._contacts: list[tuple[NDArray[np.intp], Floats]] = []
        self._deepest = 0.0

    def result(self, outputs: Floats | None, options: SimulationOptions, progress: Progress | None) -> Stepped:
        max_seconds, max_steps = options.max_seconds, options.max_steps
        self._advance(self.n_done)  # compiles what is needed, which is no part of the time
        began = time.perf_counter()
        wanted = np.zeros(0) if outputs is None else np.asarray(outputs, np.float64)
        ends = np.ceil((wanted - self.start) / self.step - 1e-9).astype(np.int64)
        marks = np.unique(np.clip(np.append(ends, self.n_steps), 0, self.n_steps))
        status, message = Status.FINISHED, ""
        if len(marks) and marks[0] == 0:
            self._store()
            marks = marks[1:]
        try:
            for mark in marks:
                while self.n_done < mark:
                    is_late = time.perf_counter() - began > max_seconds
                    if is_late or self.n_done >= max_steps:
                        limit = max_seconds if is_late else None
                        status, message = Status.TOO_LONG, stopped(self.now, Message("{n} steps", n=self.n_done), limit)
                        break
                    trouble = self._advance(min(int(mark), self.n_done + STEPS_AT_ONCE, max_steps))
                    if trouble is not None:
                        status, message = trouble
                        break
                    if progress is not None:
                        progress(self.now, self.n_done)
                if status is not Status.FINISHED:
                    break
                self._store()
        except KeyboardInterrupt:
            status, message = Status.INTERRUPTED, Message("interrupted at t = {t:.6g} s", t=self.now)
        if status is not Status.FINISHED and (not self._states or self._states[-1][0] < self.now):
            self._store()
        return self._collected(status, further(*(said for said in (message, *self._notes()) if said)), began)

    @property
    def now(self) -> float:
        return self.start + self.n_done * self.step

    @property
    def n_done(self) -> int:
        return int(self.march.count[march.STEPS])

    # -- steps --------------------------------------------------------------------------------
    def _look(self) -> None:
        """New candidates."""
        m = self.march
        fastest = float(np.abs(m.v[:, :2]).sum(axis=1).max(initial=0.0) + self.step * m.clock[march.ACCELERATION])
        skin = self.scene.skin(fastest, self.step)
        built, where = self.scene.look(m.q, skin)
        self.candidates = built.arrays
        m.circle_built[:] = where
        m.clock[march.SKIN] = skin
        m.count[march.REBUILDS] += 1

    def _advance(self, until_step: int) -> tuple[Status, str] | None:
        """Steps until their number is reached; else what is in the way."""
        s, m = self.scene, self.march
        L, S = s.packed.layout, s.packed.room
        while True:
            result = marching.advance(L, S, self.candidates, s.fixtures, s.rows, m, until_step)
            if result == march.DONE:
                return None
            if result == march.REBUILD:
                self._look()
            elif result == march.FULL:
                s.grow()
            elif result == march.NOT_FINITE:
                return Status.NOT_FINITE, Message(
                    "after t = {t:.6g} s speeds are not finite; take a shorter step", t=self.now
                )
            else:
                return Status.UNREACHABLE, Message("after t = {t:.6g} s what is held cannot be held", t=self.now)

    def _store(self) -> None:
        """The state and the contacts of this instant."""
        m, s = self.march, self.scene
        acceleration = m.new.copy() if self.n_done else np.zeros_like(m.new)
        held = m.held_impulse[s.place_of] / self.step
        self._states.append(
            (
                self.now,
                m.q.copy(),
                m.v.copy(),
                acceleration,
                held,
                float(m.clock[march.WORK]),
                float(m.clock[march.LOSS]),
            )
        )
        rows = s.rows
        n = int(rows.count[0]) if self.n_done else 0
        what, number = rows.what[:n], rows.number[:n, IMPULSE] / self.step
        normals = np.flatnonzero((what[:, KIND] == NORMAL) & (number > 0.0))
        origin, source = what[normals, ORIGIN].astype(np.intp), what[normals, SOURCE].astype(np.intp)
        is_site = origin == OF_SITE
        pair, place = source.copy(), np.zeros_like(source)
        pair[is_site] = s.built.site_pair[source[is_site]]
        place[is_site] = s.built.site_place[source[is_site]]
        friction = np.zeros(len(normals))
        if n:
            coupled = what[normals, 1] > 0
            friction[coupled] = number[normals[coupled] + 1]
        keys = np.column_stack([np.where(is_site, 0, origin == OF_BOUND), pair, place])
        self._contacts.append((keys, np.column_stack([number[normals], friction])))
        deep = marching.penetration(s.packed.room, self.candidates, m.q, m.v, s.slop)
        self._deepest = max(self._deepest, float(deep))

    # -- the result ---------------------------------------------------------------------------
    def _notes(self) -> Iterator[Message]:
        m = self.march
        if m.count[march.CAPPED]:
            yield Message(
                "the contacts of {n} of {all} steps were left after {sweeps} sweeps, with velocities that still "
                "changed by up to {v:.1e} m/s; more sweeps (max_sweeps) or shorter steps make them exact",
                n=int(m.count[march.CAPPED]),
                all=self.n_done,
                sweeps=int(m.count[march.MOST_SWEEPS]),
                v=float(m.clock[march.WORST_RESIDUAL]),
            )
        if m.count[march.SOFTENED]:
            yield Message(
                "in {n} steps with several impacts the law of restitution would have added energy; they were done "
                "without restitution",
                n=int(m.count[march.SOFTENED]),
            )
        if self.scene.lent:
            yield Message(
                "{names}: without mass or moment of inertia; time stepping counts {share:.0e} of the lightest one "
                "beside it instead",
                names=in_turn([*self.scene.lent]),
                share=KEPT * OF_LIGHTEST,
            )
        reach = self.step * float(m.clock[march.FASTEST])
        if len(self.scene.built.pairs) and reach > self.scene.size:
            yield Message(
                "a body moved {reach:.3g} m in a step, more than the smallest outline ({size:.3g} m): contacts may "
                "have been missed; take a shorter step",
                reach=reach,
                size=float(self.scene.size),
            )

    def _collected(self, status: Status, message: str, began: float) -> Stepped:
        m, s, packed = self.march, self.scene, self.scene.packed
        times, q, v, a, held, work, losses = (list(column) for column in zip(*self._states, strict=True))
        n_held = len(s.parts.joints)
        keys = [k for k, _forces in self._contacts]
        all_keys = np.concatenate(keys)
        forces = np.concatenate([f for _k, f in self._contacts])
        multipliers = self._multipliers(np.array(held).reshape(len(times), n_held), keys)
        course = Trajectory(
            status=status,
            message=message,
            times=np.array(times),
            poses=np.array(q),
            velocities=np.array(v),
            accelerations=np.array(a),
            multipliers=multipliers,
            unique=np.ones(multipliers.shape, bool),
            work=np.array(work) + np.array(losses),
            events=(),
            n_steps=self.n_done,
            n_evaluations=self.n_done,
            n_rejected=0,
            n_regularised=0,
            wall_time=time.perf_counter() - began,
            place_gap=float(m.clock[march.PLACE_GAP]),
            motion_gap=0.0,
            last_step=self.step,
            method="moreau",
            tracks=NO_TRACKS,
            near=packed.room.measures[:, NEAR].copy(),
        )
        return Stepped(
            course,
            s,
            self.step,
            ContactForces(
                np.concatenate(([0], np.cumsum([len(k) for k in keys]))).astype(np.intp),
                all_keys[:, 0],
                all_keys[:, 1],
                all_keys[:, 2],
                forces[:, 0],
                forces[:, 1],
            ),
            np.array(losses),
            max(self._deepest, float(m.clock[march.DEEPEST])),
            float(m.clock[march.WORST_RESIDUAL]),
            int(m.count[march.CAPPED]),
        )

    def _multipliers(self, held: Floats, keys: list[NDArray[np.intp]]) -> Floats:
        """(n_times, n_held) in the order of the model's held rows; zero for those that do not press."""
        system, s = self.scene.numbers.system, self.scene
        found = np.zeros((len(held), len(system.constraint_rows)))
        joint = {row.name: k for k, row in enumerate(s.parts.joints)}
        for k, row in enumerate(system.constraint_rows):
            if row.name in joint:
                found[:, k] = held[:, joint[row.name]]
        return found
