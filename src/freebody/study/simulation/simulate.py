"""The motion of a system in time: assembled, run by the engine, and given back with what it can be trusted for."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from freebody.errors import InputError
from freebody.language.sentences import Message
from freebody.numeric.contact.record import PhaseRecord
from freebody.numeric.engine.course import Trajectory
from freebody.numeric.jets import Array
from freebody.numeric.options import SimulationOptions
from freebody.numeric.reference import Reference
from freebody.present.report.result import Result
from freebody.study.simulation.at_rest import is_unstable_rest, staying
from freebody.study.simulation.measured import MeasuredMotion
from freebody.study.simulation.pressed_sides import on_the_sides_that_bear
from freebody.study.simulation.simulator import Progress, Simulator
from freebody.study.worded import in_words
from freebody.system.system import System

if TYPE_CHECKING:
    import xarray

    from freebody.present.animation import Film
    from freebody.present.recording import Recording
    from freebody.present.report.blocks import Report


N_OUTPUTS = 1001
PARTED = 1e-3  # two runs have parted where they differ by this part of the system's size


class Simulation(MeasuredMotion, Result):
    """The result of a simulation. SI units, angles in rad."""

    def __repr__(self) -> str:
        return str(self)

    def _repr_html_(self) -> str:
        """The summary and a plot, for notebooks."""
        return super()._repr_html_() + self.plot()._repr_svg_()

    def __getitem__(self, name: str) -> Array:
        """A named measure at the output times, `t` for these; `rate(x)` is the rate of x. Raises KeyError."""
        if name in ("t", "time"):
            return self.course.times
        inner = name.removeprefix("rate(").removesuffix(")") if name.startswith("rate(") else name
        if inner not in self.series:
            raise KeyError(f"{name} is no named measure; there is {', '.join(('t', *self.series))}")
        return self.series[inner][0 if inner == name else 1]

    @property
    def report(self) -> Report:
        from freebody.present.report.results import summary
        from freebody.study.simulation.told import motion_blocks

        return summary(self.system.title or Message("simulation"), motion_blocks(self))

    def to_plain(self) -> dict[str, Any]:
        """The JSON document of the command line."""
        return self.summary()

    @property
    def is_complete(self) -> bool:
        return self.status.is_complete

    @cached_property
    def recording(self) -> Recording:
        """Everything along the motion, with units and long names; see `study.simulation.recorded`."""
        from freebody.study.simulation.recorded import recorded

        return recorded(self)

    @cached_property
    def dataset(self) -> xarray.Dataset:
        """The recording as an xarray dataset (extra `data`)."""
        return self.recording.dataset()

    def continued(self, until: float, **given: Any) -> Simulation:
        """The motion from here on to a later time, with the same tolerance; the arguments are those of `simulate`."""
        if not until > self.t_end:
            raise InputError(
                Message("the motion is at t = {t_end:.6g} s already; continue to a later time", t_end=self.t_end)
            )
        if "options" not in given:
            given.setdefault("tolerance", self.tolerance)
        return simulate(self.system, until, from_result=self, **given)

    def plot(self, *names: str, path: str | Path | None = None, dark: bool = False) -> Any:
        """A figure of the named measures (all of them without names); saved if a path is given."""
        from freebody.present.plots import plot, save

        events = [(self.in_language(e.name), e.time) for e in self.events]
        figure = plot(self.recording, names, events=events, dark=dark, time=self.in_language(Message("time")))
        if path is not None:
            save(figure, Path(path))
        return figure

    def animate(self, path: str | Path | None = None, *, speed: float = 1.0) -> Any:
        """The motion as a film that plays in a notebook; with a path it is written, as a player (.html), .gif or .mp4,
        and the path returned. speed: seconds of motion in a second of showing."""
        film = self.film(speed=speed)
        return film if path is None else film.write(path)

    def film(self, *, speed: float = 1.0) -> Film:
        """The motion as a film. speed: seconds of motion in a second of showing."""
        language = "en" if self._teller is None else self._teller.language
        return replace(self._film(speed), tell=self.in_language, language=language)

    def _film(self, speed: float) -> Film:
        course, number, title = self.course, self.simulator.reference.number, self.system.title
        scene, poses = self.simulator.scene, course.poses[:, :-1]
        if course.rotation is not None:
            from freebody.present.space import animation as space

            turned = course.rotation.quaternions[:, :-1]
            return space.film_of(scene, course.times, poses[:, :, :3], turned, title=title, speed=speed)
        from freebody.present import animation as plane
        from freebody.present.marks import ContactTrack

        contacts = ContactTrack.of(self.system, number, course.contact)
        return plane.film_of(scene, course.times, poses, title=title, speed=speed, contacts=contacts)


@in_words
def simulate(
    system: System,
    until: float,
    *,
    options: SimulationOptions | None = None,
    values: Mapping[str, float] | None = None,
    events: Sequence[str] = (),
    at: Sequence[float] = (),
    progress: Progress | None = None,
    from_result: Simulation | None = None,
    **given: Any,
) -> Simulation:
    """The motion of a system from its start to the time `until` [s].

    options: how it is followed; given: the same by name, as `tolerance=1e-6` or `method="moreau", step=1e-3`, and what
    differs from `options` where both are there. See `SimulationOptions` for their names, units and defaults. values: of
    parameters, in SI. events: see `Simulator`. at: further times at which it is looked at [s].

    Raises InputError for arguments without sense, CannotAnswer if the motion cannot begin; anything that goes wrong
    later is a status of the result, which keeps the motion up to there.
    """
    options = replace(options or SimulationOptions(), **given)
    return _simulated(system, until, options, values, events, at, progress, from_result)


def with_steps(
    system: System,
    until: float,
    options: SimulationOptions,
    *,
    values: Mapping[str, float] | None = None,
    events: Sequence[str] = (),
    at: Sequence[float] = (),
) -> Simulation:
    """As `simulate`; the phases of the motion are kept with all their steps, of which its derivatives are made."""
    return _simulated(system, until, options, values, events, at, keep=True)


@in_words
def simulated_like(
    system: System,
    until: float,
    options: SimulationOptions,
    like: Simulator | None,
    placed: tuple[Reference, Array] | None = None,
) -> Simulation:
    """As `simulate`, number for number; where the system is that of a simulator from another start, most of what is
    found before the motion is taken from that. placed: as for `Simulator`."""
    return _simulated(system, until, options, like=like, placed=placed)


def _simulated(
    system: System,
    until: float,
    options: SimulationOptions,
    values: Mapping[str, float] | None = None,
    events: Sequence[str] = (),
    at: Sequence[float] = (),
    progress: Progress | None = None,
    before: Simulation | None = None,
    *,
    keep: bool = False,
    like: Simulator | None = None,
    placed: tuple[Reference, Array] | None = None,
) -> Simulation:
    options.check_asked(until)
    if options.by_steps and events:
        raise InputError(
            Message("time stepping does not locate events; leave out the method, which follows every contact")
        )
    if options.by_steps and system.space:
        raise InputError(
            Message(
                "time stepping (moreau) is for models of the plane; leave out the method, which follows every "
                "contact of a model in space, or write the model without space: true"
            )
        )
    if options.by_steps and system.blows:
        raise InputError(
            Message(
                "time stepping (moreau) does not locate events, so nothing closes or strikes in mid-motion in it; "
                "leave out the method"
            )
        )
    simulator = (
        before.simulator
        if before is not None
        else Simulator(
            system,
            values,
            events,
            by_steps=options.by_steps,
            tells_borders=True,
            stops_at_borders=not keep,
            like=like,
            placed=placed,
        )
    )
    start = 0.0 if before is None else before.t_end
    state, near = (None, None) if before is None else (_last_state(before), before.course.near)
    past = frozenset[str]()
    if before is not None and before.course.contact is not None:
        past = before.course.contact.past
    if simulator.degrees_of_freedom == 0 and not any(row.is_driven for row in system.constraint_rows):
        message = "no motion: 0 degrees of freedom; the reactions at rest are given"
        course = simulator.run(1e-9, SimulationOptions(tolerance=options.tolerance), outputs=np.array([0.0]))
        course = replace(_first_instant(course), message=message)
        return Simulation(system, simulator, course, options)
    outputs = _output_times(start, until, options.every, at)
    if options.by_steps:
        return _stepped(simulator, until, options, outputs, progress, before)
    y = simulator.start if state is None else state
    if is_unstable_rest(simulator, y, start):
        first = simulator.run(start + 1e-9, outputs=np.array([start]), state=y, start=start, near=near)
        zero = [h for h in first.events if h.kind == "start"]
        here = (*zero, *(replace(h, kind="zero") for h in zero))
        return Simulation(system, simulator, staying(first, outputs, here), options)
    going_on: dict[str, Any] = {"outputs": outputs, "state": state, "start": start, "near": near, "past": past}
    phases: list[PhaseRecord] = []
    course = simulator.run(until, options, progress=progress, phases=phases if keep else None, **going_on)
    trusted = None
    if options.verify:
        finer = simulator.run(until, options.finer, **going_on)
        trusted = _trusted_until(simulator, course, finer)
    found = Simulation(system, simulator, course, options, trusted, phases=tuple(phases))
    on_their_sides = None if keep else on_the_sides_that_bear(found)
    return found if on_their_sides is None else replace(found, course=on_their_sides, follows_sides=True)


def _output_times(start: float, until: float, every: float | None, at: Sequence[float]) -> Array:
    n = N_OUTPUTS if every is None else max(2, round((until - start) / every) + 1)
    times = np.linspace(start, until, n) if every is None else np.append(start + every * np.arange(n), until)
    times = np.array(sorted({*times.tolist(), *map(float, at)}))  # `np.unique` imports masked arrays
    return times[(times >= start) & (times <= until)]


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
