"""Inverse dynamics: what force or torque makes a mechanism move as it is told to.

Every prescribed measure becomes a held one, f(q) = f(t), whose multiplier is the wanted force (for an angle, torque) in
the direction in which the measure grows; it does the power  force * rate(f)  on the mechanism. With all degrees of
freedom prescribed the pose, the velocities and the accelerations follow from the held measures alone,

    f(q, t) = 0,    J v = -df/dt,    J a = -bias,        and then        J^T lambda = M a - Q.

The pose is followed in time from the start on, so that the mechanism stays on its branch. SI units, angles in rad.
Source: Nikravesh, Computer-Aided Analysis of Mechanical Systems, 1988, sec. 8.3 (kinematically driven systems).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from copy import copy
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from freebody.connections.driver import Driver
from freebody.errors import CannotAnswer, InputError
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS
from freebody.model.elements import ConstraintRow, NonholonomicForm
from freebody.numeric.instant import UNIQUE
from freebody.numeric.jets import Array, Jet
from freebody.numeric.placing import ACCEPTED, Fit, PoseEquation
from freebody.numeric.reference import Reference
from freebody.numeric.rest import CountedPose
from freebody.numeric.snapshot import Snapshot
from freebody.numeric.split import Split, stack
from freebody.present.lines import number_text
from freebody.present.report.blocks import Block, Report, Section
from freebody.present.report.result import Result
from freebody.present.report.results import entries, entry, summary, table
from freebody.study.prescribed_motion import CONNECTION, Course, PrescribedMeasure
from freebody.study.settled import settled
from freebody.study.small_motion.equilibrium import moved_most
from freebody.study.small_motion.found import unit_of
from freebody.study.worded import in_words
from freebody.system.system import System
from freebody.tolerances import LEAST, ROUND_OFF

_STRIDE = 0.2  # in sizes or radians: further than this from one pose to the next the way is divided
_N_STRIDES = 10_000
_MOST_SHOWN = 12  # times in a report


@dataclass(frozen=True)
class InverseDynamics(Result):
    """A prescribed motion and what drives it; every array has one entry for each time.

    forces: by prescribed measure and by driver of the model [N], [N m] for angles; powers: force times rate [W];
    reactions: by row of the connections, positive as people name them; NaN at the times at which they are not unique,
    and `non_unique` names the rows where that happens; poses: (n_times, 3) by body: x, y of the mass centre, angle;
    values, rates, accelerations: of the named measures."""

    system: System
    times: Array
    forces: Mapping[str, Array]
    powers: Mapping[str, Array]
    reactions: Mapping[str, Array]
    non_unique: tuple[str, ...]
    poses: Mapping[str, Array]
    values: Mapping[str, Array]
    rates: Mapping[str, Array]
    accelerations: Mapping[str, Array]

    def unit(self, force: str) -> str:
        """The unit of a driving force: N, or N m for an angle."""
        row = next((row for row in self.system.constraint_rows if row.connection == force), None)
        measure: Any = self.system.measures[force] if row is None else row.measure
        return "N m" if measure.dimension == DIMENSIONLESS else "N"

    def to_plain(self) -> dict[str, Any]:
        """Plain data: times, forces {name: {values, unit}}, powers, reactions (null where not unique), non_unique,
        poses, and measures {name: {values, rates, accelerations, unit}}."""
        return {
            "title": self.system.title,
            "times": self.times.tolist(),
            "forces": {n: {"values": _plain(x), "unit": self.unit(n)} for n, x in self.forces.items()},
            "powers": {n: _plain(x) for n, x in self.powers.items()},
            "reactions": {n: _plain(x) for n, x in self.reactions.items()},
            "non_unique": list(self.non_unique),
            "poses": {n: x.tolist() for n, x in self.poses.items()},
            "measures": {
                n: {
                    "values": x.tolist(),
                    "rates": self.rates[n].tolist(),
                    "accelerations": self.accelerations[n].tolist(),
                    "unit": unit_of(self.system.measures[n]),
                }
                for n, x in self.values.items()
            },
        }

    @property
    def report(self) -> Report:
        """The driving forces and the measures, at some of the times."""
        return summary(self.system.title, self._blocks())

    def _blocks(self) -> Iterator[Block]:
        n_times = len(self.times)
        share = (n_times - 1) / (_MOST_SHOWN - 1)
        shown = sorted({round(k * share) for k in range(_MOST_SHOWN)}) if n_times else []
        columns: dict[str, Array] = {
            Message("force of {name} [N]" if self.unit(n) == "N" else "torque of {name} [N m]", name=n): x
            for n, x in self.forces.items()
        }
        columns |= {f"{name} [{unit_of(self.system.measures[name])}]": x for name, x in self.values.items()}
        rows = [[number_text(float(x[k])) for x in (self.times, *columns.values())] for k in shown]
        title = Message("Driving forces and measures")
        if len(shown) < n_times:
            title = Message("Driving forces and measures, at {k} of {n} times", k=len(shown), n=n_times)
        yield Section((title,), tuple(table(rows, ("t [s]", *columns))))
        if self.non_unique:
            told = Message("the reactions {names}", names=", ".join(self.non_unique))
            yield from entries(entry(Message("not unique"), told))


def _plain(x: Array) -> list[float | None]:
    return [None if np.isnan(value) else float(value) for value in x]


@in_words
def inverse_dynamics(system: System, motion: Mapping[str, Course] | None, times: Sequence[float]) -> InverseDynamics:
    """The forces that make named measures follow functions of time, with all reactions.

    motion: by named measure, as many as there are degrees of freedom (none for a model whose drivers move
    everything): an expression in `t` and the parameters as text, a number, a function of t that gives (value, rate,
    acceleration), or three arrays of these at the times. times: ascending [s].

    Raises InputError for unknown measures, CannotAnswer naming what is left free or is prescribed twice, and where
    no pose follows the motion."""
    at = np.asarray(list(times), dtype=np.float64)
    if not len(at) or not np.isfinite(at).all() or (np.diff(at) <= 0.0).any():
        raise InputError(Message("times must be finite numbers [s], each later than the one before; at least one"))
    return _Follower(settled(system), motion or {}, at).result()


class _Follower:
    """Follows a prescribed motion in time."""

    def __init__(self, system: System, motion: Mapping[str, Course], times: Array) -> None:
        self.system, self.times = system, times
        self.courses = [PrescribedMeasure(system, name, course, times) for name, course in motion.items()]
        self.free = Reference(system)  # the mechanism without the motion, which measures count from
        q = self.free.assemble()
        self.start = CountedPose(q, self.free.geometry(q, np.zeros_like(q), 0.0).angles)
        rows = [
            ConstraintRow(
                c.name,
                "driving torque" if c.measure.dimension == DIMENSIONLESS else "driving force",
                c.measure,
                c.target(),
                connection=CONNECTION,
            )
            for c in self.courses
        ]
        self.rows = rows
        self.extended = replace(system, constraint_rows=(*system.constraint_rows, *rows))
        for row in system.constraint_rows:
            if isinstance(row.measure, NonholonomicForm):
                raise CannotAnswer(
                    Message(
                        "{connection} binds velocities only, so no pose follows from the motion alone",
                        connection=row.connection,
                    )
                )
        self._check_freedom(self.start)

    def _check_freedom(self, pose: CountedPose) -> None:
        """All that is free is prescribed, and nothing twice."""
        reference, n = self.free, len(pose.q)
        g = reference.geometry(pose.q, np.zeros(n), 0.0, pose.branches)
        D = reference.sizes.small_moves
        free = reference.split_at(pose.q, pose.branches).null
        dof = int(free.shape[1])
        held: list[str] = []
        left = free
        for row, course in zip(self.rows, self.courses, strict=True):
            gradient = reference.jet(g, course.measure, course.name).row(n)
            own = left.T @ gradient
            if float(np.linalg.norm(own)) <= ROUND_OFF * float(np.linalg.norm(gradient * D)):
                before = ", ".join(["the connections", *held] if dof - left.shape[1] == 0 or not held else held)
                raise CannotAnswer(
                    Message(
                        "{component} is prescribed twice: {before} determine it already. Leave it out",
                        component=row.component,
                        before=before,
                    )
                )
            held.append(course.name)
            left = left @ np.linalg.qr(own[:, None], mode="complete")[0][:, 1:]
        if left.shape[1]:
            loose = moved_most(reference, g, left[:, 0])
            raise CannotAnswer(
                Message(
                    "the motion prescribes {n} of {dof} degrees of freedom and leaves {what} free. "
                    "Prescribe {more} more",
                    n=len(held),
                    dof=dof,
                    what=loose,
                    more=left.shape[1],
                )
            )

    def at(self, t: float) -> Reference:
        """The driven mechanism with the numbers of a time; it counts from the start of the model."""
        numbers: dict[str, float] = {**self.free.frame.values, "@t": t}
        for course in self.courses:
            numbers.update(course.numbers(t))
        driven = copy(self.free)
        driven.system = self.extended
        driven.frame = replace(self.free.frame, values=numbers)
        driven.placing = replace(self.free.placing, frame=driven.frame)
        return driven

    # -- following ----------------------------------------------------------------------------
    def _begin(self, t: float) -> CountedPose:
        """The pose at the first time, led there from the start."""
        driven, here = self.at(t), self.start
        equations = self.free.held_where(here.q, 0.0)
        g = driven.geometry(here.q, np.zeros_like(here.q), t, here.branches)
        begin = [driven.jet(g, row.measure, row.component).value for row in self.rows]
        goals = [g.scalar(row.target).value for row in self.rows if row.target is not None]
        ways = [b - x for b, x in zip(begin, goals, strict=True)]
        ways += [driven.gap(row, g).value for row in self.system.constraint_rows if row.target is not None]
        far = max(map(abs, ways), default=0.0)
        n_parts = min(_N_STRIDES, 1 + int(far / (_STRIDE * max(1.0, self.free.sizes.length))))
        for part in range(1, n_parts + 1):
            led = [
                PoseEquation.of(c.name, c.measure, Jet(x0 + (x - x0) * part / n_parts))
                for c, x0, x in zip(self.courses, begin, goals, strict=True)
            ]
            fit = driven.placing.fit(here.q, equations + led, t * part / n_parts, here.branches)
            if fit is None or fit.error > ACCEPTED:
                told = Message("the motion cannot begin at t = {t:.6g} s from the start of the model", t=t)
                raise CannotAnswer(told if fit is None else _at_best(told, fit))
            here = CountedPose(fit.q, fit.branches)
        return here

    def _follow(self) -> Iterator[tuple[Snapshot, Split]]:
        t, pose = float(self.times[0]), self._begin(float(self.times[0]))
        kept = self.at(t).held_where(pose.q, t)  # rows that keep their start value keep the one they have
        s, split = self._instant(pose, t)
        yield s, split
        for goal in self.times[1:].tolist():
            n_strides = 0
            while s.t < goal:
                pace = float(self.free.sizes.relative(s.v).max(initial=0.0))
                step = min(goal - s.t, _STRIDE / max(pace, LEAST))
                s, split = self._stepped(s, goal if s.t + step >= goal * (1 - 1e-15) else s.t + step, kept)
                n_strides += 1
                if n_strides > _N_STRIDES:
                    raise CannotAnswer(Message("the motion runs too fast to be followed beyond t = {t:.6g} s", t=s.t))
            yield s, split

    def _stepped(self, s: Snapshot, t: float, kept: Sequence[PoseEquation]) -> tuple[Snapshot, Split]:
        """The next pose, guessed from the velocities; the way is halved where that does not lead to one near."""
        fit: Fit | None = None
        for _ in range(12):
            guess = self.free.frame.moved(s.q, (t - s.t) * s.v)
            fit = self.at(t).placing.fit(guess, kept, t, s.branches)
            if fit is not None and fit.error <= ACCEPTED:
                away = float(self.free.sizes.relative(self.free.frame.difference(fit.q, guess)).max(initial=0.0))
                if away <= 2.0 * _STRIDE:
                    return self._instant(CountedPose(fit.q, fit.branches), t)
            t = 0.5 * (s.t + t)
        told = Message("the mechanism cannot follow the motion beyond t = {t:.6g} s", t=s.t)
        raise CannotAnswer(told if fit is None else _at_best(told, fit))

    def _instant(self, pose: CountedPose, t: float) -> tuple[Snapshot, Split]:
        """The driven mechanism at a time, and what its rows determine."""
        driven = self.at(t)
        g = driven.geometry(pose.q, np.zeros_like(pose.q), t, pose.branches)
        n = len(pose.q)
        gaps = [driven.gap(row, g) for row in driven.system.constraint_rows]
        split = Split(stack([gap.row(n) for gap in gaps], n), driven.sizes.small_moves)
        if split.null.shape[1]:
            loose = moved_most(driven, g, split.null[:, 0])
            raise CannotAnswer(
                Message(
                    "at t = {t:.6g} s the prescribed motion does not determine {what}: a dead centre", t=t, what=loose
                )
            )
        v = driven.velocities(pose.q, (), t, with_start=False)
        return Snapshot(driven, driven.geometry(pose.q, v, t, pose.branches), pose.q, v, t), split

    # -- the result ---------------------------------------------------------------------------
    def result(self) -> InverseDynamics:
        instants = list(self._follow())
        snapshots = [s for s, _split in instants]
        rows, drivers = self.extended.constraint_rows, self._drivers()
        multipliers = {
            row.name: np.array([_multiplier(s, split, k) for s, split in instants]) for k, row in enumerate(rows)
        }
        forces: dict[str, Array] = {}
        powers: dict[str, Array] = {}
        for row in [*drivers, *self.rows]:
            name = row.component if row.connection == CONNECTION else row.connection
            forces[name] = multipliers[row.name]
            powers[name] = forces[name] * np.array([s.rate(row.measure) for s in snapshots])
        reactions = {
            row.name: row.sign * multipliers[row.name] for row in self.system.constraint_rows if row not in drivers
        }
        poses = {
            body.name: np.array([self.free.pose(s.q, body.name) for s in snapshots]) for body in self.system.moving
        }
        values, rates, accelerations = (
            {name: np.array([read(s, m) for s in snapshots]) for name, m in self.system.measures.items()}
            for read in (Snapshot.value, Snapshot.rate, Snapshot.acceleration)
        )
        return InverseDynamics(
            self.system,
            self.times,
            forces,
            powers,
            reactions,
            tuple(name for name, x in (*forces.items(), *reactions.items()) if np.isnan(x).any()),
            poses,
            values,
            rates,
            accelerations,
        )

    def _drivers(self) -> list[ConstraintRow]:
        """The rows of the model's own drivers."""
        connections = self.system.connections
        return [row for row in self.system.constraint_rows if isinstance(connections.get(row.connection), Driver)]


def _multiplier(s: Snapshot, split: Split, k: int) -> float:
    """Of the k-th held row; NaN where it is not unique."""
    if float(np.linalg.norm(split.left_null[k])) > UNIQUE:
        return float("nan")
    return s.multiplier(s.reference.system.constraint_rows[k])


def _at_best(what: str, fit: Fit) -> str:
    return Message("{what}: at best {worst}", what=what, worst=fit.worst)
