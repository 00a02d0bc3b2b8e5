"""How series of a motion, its events and its end change with parameters: exactly, or not at all."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.numeric.engine.operations import ProgramNode
from freebody.numeric.jets import Array
from freebody.numeric.options import SimulationOptions
from freebody.numeric.tangent.crossing import moved, multiplier
from freebody.numeric.tangent.equations import Equations
from freebody.numeric.tangent.passed import Seen
from freebody.study.simulation.recorded import reaction_names
from freebody.study.simulation.simulate import Simulation
from freebody.study.simulation.simulator import read_event
from freebody.system.system import System

_SAME_TIME = 1e-9  # of the whole motion: instants that two runs of it find


@dataclass(frozen=True)
class Change:
    """Of a number along a motion at an instant: its value, its rate in time, and its derivatives (k,) by the names at
    that fixed time."""

    value: float
    rate: float
    by: Array


class MotionTangents:
    """A simulated motion with its derivatives by some parameters."""

    def __init__(
        self,
        result: Simulation,
        names: Sequence[str],
        until: float,
        options: SimulationOptions,
        times: Sequence[float] = (),
    ) -> None:
        """names: parameters; times: at which series will be looked at [s]. Raises CannotAnswer, saying why, where the
        motion has no derivative."""
        if result.steps is not None or options.by_steps:
            raise CannotAnswer(Message("time stepping gives no exact derivatives; leave out the method"))
        self.result, self.names, self.system = result, tuple(names), result.system
        self._motion = result.simulator.tangents(names)
        events = [e.time for e in result.events if 0.0 < e.time < result.t_end]
        looked_at = np.array([t for t in (*times, *events) if 0.0 <= t <= result.t_end])
        is_known = bool(result.phases) and result.tolerance <= options.tolerance
        known = (result.course, result.phases) if is_known else None
        self.course = self._motion.run(until, options, looked_at, known)
        self._seen: dict[tuple[str, int], Seen] = {}

    # -- series -------------------------------------------------------------------------------
    def at(self, series: str, time: float, *, before: bool = False) -> Change:
        """A series at an instant; where something happens then, after it or `before`. Raises CannotAnswer for series
        without a derivative."""
        if not before and self.turn_at(time) is not None:
            raise CannotAnswer(
                Message(
                    "at t = {t:.6g} s the law of motion changes, and {series} has no derivative just then",
                    t=time,
                    series=series,
                )
            )
        k = self._phase_at(time, before=before)
        seen, own = self._of(series, k), self._motion.phases[k].tangent.times
        i = int(np.abs(own - time).argmin())
        return Change(float(seen.values[i, 0]), float(seen.rates[i, 0]), seen.changes[i, 0])

    def along(self, series: str, times: Array) -> Array:
        """(n, k) derivatives of a series at some of the times that were looked at."""
        return np.array([self.at(series, float(t)).by for t in times]).reshape(len(times), len(self.names))

    def _of(self, series: str, k: int) -> Seen:
        key = series, k
        if key not in self._seen:
            self._seen[key] = self._motion.phases[k].seen(lambda e: [written(self.system, e, series)])
        return self._seen[key]

    def _phase_at(self, time: float, *, before: bool) -> int:
        room = _SAME_TIME * max(1.0, self.course.t_end)
        starts = [float(p.tangent.times[0]) for p in self._motion.phases]
        reached = [k for k, t in enumerate(starts) if (t < time - room if before else t <= time + room)]
        return reached[-1] if reached else 0

    # -- instants -----------------------------------------------------------------------------
    @property
    def end(self) -> Array:
        """(k,) how the end of the motion moves: by the event that ends it, else not at all."""
        last = self.course.events[-1] if self.course.events else None
        if last is None or not last.is_terminal:
            return np.zeros(len(self.names))
        return self.event(last.name, last.time)

    def event(self, words: str, time: float) -> Array:
        """(k,) how the instant of an event moves. Raises CannotAnswer where it has no derivative."""
        if "=" not in words:
            return self._turn(words, time)
        happened = next((e for e in self.course.events if e.name == words and self._is_then(e.time, time)), None)
        if happened is not None and happened.kind == "touch":
            raise CannotAnswer(Message("{event} is reached without being crossed: it has no derivative", event=words))
        asked = read_event(self.system, words).event
        k = self._phase_at(time, before=True)
        phase = self._motion.phases[k]

        def gap(e: Equations) -> list[ProgramNode]:
            of = e.writer.rate(asked.measure) if asked.order else e.writer.value(asked.measure)
            return [of - e.writer.scalar(asked.value)]

        seen, own = phase.seen(gap), phase.tangent.times
        i = int(np.abs(own - time).argmin())
        return moved(seen.rates[:, 0], seen.changes[i, 0], words, time, i)

    def _turn(self, words: str, time: float) -> Array:
        found = self.turn_at(time)
        if found is None:
            raise CannotAnswer(Message("'{event}' has no exact derivative", event=words))
        return found

    def turn_at(self, time: float) -> Array | None:
        """(k,) how the change of the law of motion at an instant moves; None where there is none."""
        return next((turn.change for turn in self._motion.turns if self._is_then(turn.time, time)), None)

    def _is_then(self, one: float, other: float) -> bool:
        return abs(one - other) <= _SAME_TIME * max(1.0, self.course.t_end)


def written(system: System, e: Equations, series: str) -> ProgramNode:
    """A series of a motion by its name, over the equations of a phase. Raises CannotAnswer for one that has no
    derivative here."""
    w = e.writer
    for suffix, order in (("_acceleration", 2), ("_rate", 1), ("", 0)):
        name = series.removesuffix(suffix)
        if series.endswith(suffix) and name in system.measures:
            measure = system.measures[name]
            rate = w.rate(measure)
            return w.value(measure) if not order else rate if order == 1 else w.derivative(rate)
    for name, row in zip(reaction_names(system.rows), system.rows, strict=True):
        if name == series:
            held = {r.name for r in e.system.constraint_rows} | e.dropped
            return float(row.sign) * multiplier(e, row.name) if row.name in held else w.constant(0.0)
    raise CannotAnswer(
        Message("{series} has no exact derivative; measures, their rates and reactions do", series=series)
    )
