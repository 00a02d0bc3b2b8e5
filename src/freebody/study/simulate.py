"""The motion of a system in time: assembled, run by the engine, and given back with what it can be trusted for."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from freebody.errors import CannotAnswer, InputError, ModelError
from freebody.language.expression import free_symbols
from freebody.measures.base import Measure
from freebody.model.elements import ConstraintRow
from freebody.model.names import did_you_mean
from freebody.numeric.contact.admissible import admissible_reactions
from freebody.numeric.contact.bounded import Bounded
from freebody.numeric.contact.hybrid import Hybrid
from freebody.numeric.contact.start import assembled_touching, start_velocities
from freebody.numeric.engine import dynamics
from freebody.numeric.engine.course import Event, Status, Trajectory
from freebody.numeric.engine.engine import Engine
from freebody.numeric.engine.evaluator import EngineWatch
from freebody.numeric.instant import check_laws
from freebody.numeric.jets import Array
from freebody.numeric.options import SimulationOptions
from freebody.numeric.reference import Reference
from freebody.study.assumed import rates_not_given
from freebody.study.at_rest import is_unstable_rest, staying
from freebody.study.energy import EnergyBalance, energy_balance
from freebody.study.worded import in_words, without_value
from freebody.system.system import System

if TYPE_CHECKING:
    import xarray

    from freebody.numeric.timestepping.run import Stepped

Progress = Callable[[float, int], None]
N_OUTPUTS = 1001
PARTED = 1e-3  # two runs have parted where they differ by this part of the system's size


class Simulator:
    """A system with a number for every parameter, assembled at its start and packed for the engine."""

    def __init__(
        self,
        system: System,
        values: Mapping[str, float] | None = None,
        events: Sequence[str] = (),
        *,
        by_steps: bool = False,
    ) -> None:
        """values: of parameters, in SI, instead of the model's. events: what to look for, as "theta = 90 deg" or
        "theta' = 0", with "rising" or "falling" behind it for one direction only; one that begins with "stop when" ends
        the motion. by_steps: for time stepping, which does not follow single contacts. Raises CannotAnswer naming
        parameters without a value, or what contradicts itself at the start."""
        self.system = system
        for name, value in (values or {}).items():
            if name in system.parameters and system.parameters[name].sign == "positive" and not value > 0.0:
                raise InputError(f"{name} = {value:g} is not positive; the model says that it is")
        self.reference = Reference(system, values)
        q = assembled_touching(self.reference)
        v = start_velocities(self.reference, q)
        self.assumptions = system.assumptions
        if not has_phases(system):
            self.assumptions = (*self.assumptions, *rates_not_given(self.reference, q, v))
        self.numbers = self.reference.numbers()
        watches, tracked = _watches(self, events), list(system.measures.values())
        self.bounded = None if by_steps or not has_phases(system) else Bounded(self.numbers, watches, tracked)
        self.engine = Engine(self.numbers, watches, tracked) if self.bounded is None else self.bounded.free
        self.start = self.engine.state(*self.reference.by_body(q, v))
        start = self.reference.snapshot(q, v)
        check_laws(self.reference, start.geometry)
        for rub in system.rubs:
            if not rub.of:  # it rubs from the start on, so its slip must have a value there
                self.reference.jet(start.geometry, rub.row.measure, rub.row.name)
        self.value_at_start = start.value
        try:
            self.engine.align(self.start, 0.0, self.value_at_start)
        except ZeroDivisionError:
            for measure in system.measures.values():
                _ = start.acceleration(measure)  # says which one has no value or rate at the start
            raise
        self._near = self.engine.near()
        try:
            _accelerations, _multipliers = self.engine.evaluate(self.start, 0.0)
        except CannotAnswer as error:
            raise CannotAnswer("; ".join([str(error), *islice(without_value(system), 1)])) from error
        if self.engine.layout.has_gap[0] or self.engine.room.info[dynamics.N_LEFT_OUT]:
            _ = start.accelerations  # the dense solution refuses what moves without inertia or contradicts itself

    @property
    def degrees_of_freedom(self) -> int:
        """Independent velocities at the start."""
        self.engine.evaluate(self.start, 0.0)
        n_free = int(np.count_nonzero(self.engine.layout.inverse_mass))
        return n_free - len(self.engine.held) + int(self.engine.room.info[dynamics.N_LEFT_OUT])

    def run(
        self,
        until: float,
        options: SimulationOptions | None = None,
        *,
        outputs: Array | None = None,
        progress: Progress | None = None,
        state: Array | None = None,
        start: float = 0.0,
        near: Array | None = None,
        first_step: float = 0.0,
        **given: Any,
    ) -> Trajectory:
        """The motion to `until` [s] as arrays. outputs: times at which it is wanted [s]. state, start, near: of a
        motion that goes on, from its `Trajectory`. first_step: [s], chosen if it is zero. given: of the options."""
        options = replace(options or SimulationOptions(), **given)
        near = self._near if near is None else near
        self.engine.count_from(near)
        y = (self.start if state is None else state).copy()
        if self.bounded is not None:
            wanted = np.array([until]) if outputs is None else outputs
            return Hybrid(self.bounded, options).run(y, start, until, wanted, near, progress)
        return self.engine.run(
            y, until, options, start=start, first_step=first_step, outputs=outputs, progress=progress
        )

    def time_accelerations(self, n_calls: int) -> float:
        """Seconds for one evaluation of all accelerations and multipliers, within the compiled loop."""
        import time

        began = time.perf_counter()
        self.engine.evaluate(self.start, 0.0, n_calls)
        return (time.perf_counter() - began) / n_calls


@dataclass(frozen=True, repr=False)
class Simulation:
    """The result of a simulation. SI units, angles in rad."""

    system: System
    simulator: Simulator
    course: Trajectory
    options: SimulationOptions
    trusted_until: float | None = None  # with `verify`: from here on two tolerances disagree
    steps: Stepped | None = field(default=None, repr=False)  # of time stepping: what the contacts did

    def __repr__(self) -> str:
        from freebody.present.simulation import simulation_lines

        return "\n".join(simulation_lines(self))

    def _repr_html_(self) -> str:
        """The summary and a plot, for notebooks."""
        from html import escape
        from io import StringIO

        picture = StringIO()
        self.plot().savefig(picture, format="svg")
        svg = picture.getvalue()
        return f"<pre>{escape(repr(self))}</pre>{svg[svg.index('<svg') :]}"

    @property
    def rows(self) -> tuple[ConstraintRow, ...]:
        """The rows whose multipliers the course has: what is held, and what is bounded or rubs where single contacts
        are followed."""
        return self.system.held if self.simulator.bounded is None else self.system.rows

    @property
    def tolerance(self) -> float:
        return self.options.tolerance

    @property
    def status(self) -> Status:
        return self.course.status

    @property
    def message(self) -> str:
        return self.course.message

    @property
    def events(self) -> tuple[Event, ...]:
        return self.course.happenings

    @property
    def t_end(self) -> float:
        return self.course.t_end

    @cached_property
    def energy(self) -> EnergyBalance:
        """Kinetic and potential energy, and the work of all other loads, at the output times."""
        return energy_balance(self)

    @cached_property
    def series(self) -> dict[str, tuple[Array, Array, Array]]:
        """Value, rate and second derivative of every named measure at the output times."""
        from freebody.study.observed import observed

        return observed(self, dict(self.system.measures))

    def reaction_ranges(self, time: float | None = None) -> dict[str, tuple[float, float]]:
        """Of a system with contacts or dry friction: the least and the largest value [N or N m] that every reaction may
        have at the output time nearest to the given one [s] (the end if nothing is said), by the name of its row. Both
        are the same where it is unique; infinite where nothing bounds it. Raises InputError for other systems."""
        if self.simulator.bounded is None:
            raise InputError("there are no contacts or dry friction; reactions that are not unique are unbounded")
        k = -1 if time is None else int(np.abs(self.course.times - time).argmin())
        return admissible_reactions(self.simulator.bounded, self.course, k % len(self.course.times))

    @cached_property
    def dataset(self) -> xarray.Dataset:
        """Everything along the motion, with units and long names; see `study.dataset`."""
        from freebody.study.dataset import dataset_of

        return dataset_of(self)

    def continued(self, until: float, **given: Any) -> Simulation:
        """The motion from here on to a later time, with the same tolerance; the arguments are those of `simulate`."""
        if not until > self.t_end:
            raise InputError(f"the motion is at t = {self.t_end:.6g} s already; continue to a later time")
        if "options" not in given:
            given.setdefault("tolerance", self.tolerance)
        return simulate(self.system, until, from_result=self, **given)

    def summary(self) -> dict[str, Any]:
        """The document that `freebody simulate --json` prints."""
        course, energy = self.course, self.energy
        final: dict[str, Any] = {
            "measures": {name: float(values[-1]) for name, (values, _r, _a) in self.series.items()},
            "poses": {b.name: [float(x) for x in course.poses[-1, k]] for k, b in enumerate(self.system.moving)},
        }
        if course.rotation is not None:
            turned = course.rotation.quaternions[-1]
            final["quaternions"] = {b.name: [float(x) for x in turned[k]] for k, b in enumerate(self.system.moving)}
        return {
            "title": self.system.title,
            "assumptions": list(self.simulator.assumptions),
            "status": str(self.status),
            "message": self.message,
            "t_end": self.t_end,
            "steps": course.n_steps,
            "evaluations": course.n_evaluations,
            "wall_time": course.wall_time,
            "max_position_violation": course.place_gap * self.simulator.numbers.length,
            "max_velocity_violation": course.motion_gap * self.simulator.numbers.length,
            "energy_error": energy.error,
            "energy_error_relative": energy.relative_error,
            "method": course.method,
            "tolerance": self.tolerance,
            "trusted_until": self.trusted_until,
            "events": [{"time": e.time, "name": e.name, "kind": e.kind} for e in self.events],
            "final": final,
            **self._contact_summary(),
        }

    def _contact_summary(self) -> dict[str, Any]:
        """Contact states at the end, and all collisions."""
        record = self.course.contact
        if record is None:
            return {}
        from dataclasses import asdict

        from freebody.study.contact_series import final_states

        return {
            "phases": record.n_phases,
            "contacts": final_states(self),
            "collisions": [asdict(collision) for collision in record.collisions],
        }

    def plot(self, *names: str, path: str | Path | None = None, dark: bool = False) -> Any:
        """A figure of the named measures (all of them without names); saved if a path is given."""
        from freebody.present.plots import plot, save

        figure = plot(self.dataset, names, events=[(e.name, e.time) for e in self.events], dark=dark)
        if path is not None:
            save(figure, Path(path))
        return figure

    def _animate_in_space(self, path: Path, speed: float) -> Path:
        from freebody.present.scene import Scene
        from freebody.present.space.animation import write_animation

        course = self.course
        assert course.rotation is not None
        scene = Scene.of(self.system, self.simulator.reference.number)
        turned = course.rotation.quaternions[:, :-1]
        centers = course.poses[:, :-1, :3]
        return write_animation(scene, course.times, centers, turned, path, title=self.system.title, speed=speed)

    def animate(self, path: str | Path, *, speed: float = 1.0) -> Path:
        """Writes an animation: a player (.html), .gif or .mp4."""
        from freebody.present.animation import write_animation
        from freebody.present.marks import ContactTrack
        from freebody.present.scene import Scene

        number = self.simulator.reference.number
        if self.system.space:
            return self._animate_in_space(Path(path), speed)
        scene = Scene.of(self.system, number)
        poses = self.course.poses[:, :-1]
        contacts = ContactTrack.of(self.system, number, self.course.contact)
        write_animation(
            scene, self.course.times, poses, Path(path), title=self.system.title, speed=speed, contacts=contacts
        )
        return Path(path)


@in_words
def simulate(
    system: System,
    until: float,
    *,
    options: SimulationOptions | None = None,
    values: Mapping[str, float] | None = None,
    events: Sequence[str] = (),
    progress: Progress | None = None,
    from_result: Simulation | None = None,
    **given: Any,
) -> Simulation:
    """The motion of a system from its start to the time `until` [s].

    options: how it is followed; given: the same by name, as `tolerance=1e-6` or `method="moreau", step=1e-3`, and what
    differs from `options` where both are there. See `SimulationOptions` for their names, units and defaults. values: of
    parameters, in SI. events: see `Simulator`.

    Raises InputError for arguments without sense, CannotAnswer if the motion cannot begin; anything that goes wrong
    later is a status of the result, which keeps the motion up to there.
    """
    options = replace(options or SimulationOptions(), **given)
    options.check_asked(until)
    if options.by_steps and events:
        raise InputError("time stepping does not locate events; leave out the method, which follows every contact")
    if options.by_steps and system.space:
        raise InputError(
            "time stepping (moreau) is for models of the plane; leave out the method, which follows every contact of a "
            "model in space, or write the model without space: true"
        )
    before = from_result
    simulator = Simulator(system, values, events, by_steps=options.by_steps) if before is None else before.simulator
    start = 0.0 if before is None else before.t_end
    state, near = (None, None) if before is None else (_last_state(before), before.course.near)
    if simulator.degrees_of_freedom == 0 and not _is_driven(system):
        message = "no motion: 0 degrees of freedom; the reactions at rest are given"
        course = simulator.run(1e-9, SimulationOptions(tolerance=options.tolerance), outputs=np.array([0.0]))
        course = replace(_first_instant(course), message=message)
        return Simulation(system, simulator, course, options)
    outputs = _output_times(start, until, options.every)
    if options.by_steps:
        return _stepped(simulator, until, options, outputs, progress, before)
    y = simulator.start if state is None else state
    if is_unstable_rest(simulator, y, start):
        first = simulator.run(start + 1e-9, outputs=np.array([start]), state=y, start=start, near=near)
        zero = [h for h in first.happenings if h.kind == "start"]
        here = (*zero, *(replace(h, kind="zero") for h in zero))
        return Simulation(system, simulator, staying(first, outputs, here), options)
    course = simulator.run(until, options, outputs=outputs, progress=progress, state=state, start=start, near=near)
    trusted = None
    if options.verify:
        finer = simulator.run(until, options.finer, outputs=outputs, state=state, start=start, near=near)
        trusted = _trusted_until(simulator, course, finer)
    return Simulation(system, simulator, course, options, trusted)


def _output_times(start: float, until: float, every: float | None) -> Array:
    n = N_OUTPUTS if every is None else max(2, round((until - start) / every) + 1)
    times = np.linspace(start, until, n) if every is None else np.append(start + every * np.arange(n), until)
    times = np.unique(times)
    return times[times <= until]


def _stepped(
    simulator: Simulator,
    until: float,
    options: SimulationOptions,
    outputs: Array,
    progress: Progress | None,
    before: Simulation | None,
) -> Simulation:
    """A motion by Moreau-Jean time stepping."""
    from freebody.numeric.timestepping.run import run_moreau

    y = simulator.start if before is None else _last_state(before)
    q, v = simulator.engine.parts(y)
    found = run_moreau(
        simulator.numbers,
        q[:-1].copy(),
        v[:-1].copy(),
        until,
        options,
        start=0.0 if before is None else before.t_end,
        outputs=outputs,
        progress=progress,
        value=simulator.value_at_start,
    )
    return Simulation(simulator.system, simulator, found.course, options, steps=found)


def has_phases(system: System) -> bool:
    """Whether a motion may change its law on the way: something can part, touch, stick or slip."""
    return bool(system.contacts or system.limits or system.brakes) or any(row.unilateral for row in system.held)


def _is_driven(system: System) -> bool:
    return any(row.target is not None and "t" in free_symbols(row.target) for row in system.held)


def _watches(simulator: Simulator, events: Sequence[str]) -> list[EngineWatch]:
    """Events in words. Raises InputError if one cannot be read."""
    found: list[EngineWatch] = []
    for text in events:
        stops = text.strip().lower().startswith("stop when")
        words = text.strip()[len("stop when") :].strip() if stops else text.strip()
        asked, direction = words, 0
        for word, sign in (("rising", 1), ("falling", -1)):
            if asked.endswith(f" {word}"):
                asked, direction = asked.removesuffix(word).strip(), sign
        try:
            question = simulator.system.question(f"time when {asked}")
        except ModelError as error:
            measures = simulator.system.measures
            listed = f" Named measures: {', '.join(measures)}." if measures else ""
            guess = did_you_mean(words.split("=")[0].strip(), measures)
            raise InputError(f"event '{text}': {error.problems[0].message}.{guess}{listed}") from error
        event = question.event
        if event is None:
            raise InputError(f"'{text}' is no event; write, for example, theta = 90 deg")
        value = simulator.reference.number(event.value)
        size = max(abs(value), 1.0 if event.order else _size(simulator, event.measure))
        found.append(EngineWatch(words, event.measure, event.order, value, direction, is_terminal=stops, size=size))
    return found


def _size(simulator: Simulator, measure: Measure) -> float:
    from freebody.language.units import LENGTH

    return simulator.numbers.length if measure.dimension == LENGTH else 1.0


def _last_state(result: Simulation) -> Array:
    course, engine = result.course, result.simulator.engine
    y = engine.state_at(course, -1)
    y[2 * engine.n_coordinates] = course.work[-1]
    return y


def _first_instant(course: Trajectory) -> Trajectory:
    arrays = ("times", "poses", "velocities", "accelerations", "multipliers", "unique", "work")
    rotation = None if course.rotation is None else course.rotation.first()
    return replace(course, rotation=rotation, **{name: getattr(course, name)[:1] for name in arrays})


def _trusted_until(simulator: Simulator, course: Trajectory, finer: Trajectory) -> float:
    """The first output time at which two runs have parted, or the end."""
    times, first, second = np.intersect1d(course.times, finer.times, return_indices=True)
    engine = simulator.engine
    n, unit = engine.n_coordinates, engine.unit
    one, other = engine.states(course)[first], engine.states(finer)[second]
    gaps = (np.abs(one - other)[:, :n] / unit).max(axis=1)
    turned = np.abs(one - other)[:, 2 * n + 1 :]  # quaternions, in space
    gaps = np.maximum(gaps, 2.0 * turned.max(axis=1, initial=0.0))
    parted = np.flatnonzero(gaps > PARTED)
    return float(times[parted[0]] if len(parted) else times[-1])
