"""A system in numbers, assembled at its start and packed for the engine."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from difflib import get_close_matches
from functools import cached_property
from itertools import islice
from typing import TYPE_CHECKING, Any

import numpy as np

from freebody.errors import CannotAnswer, InputError, ModelError
from freebody.language.sentences import Message, further
from freebody.measures.base import Measure
from freebody.model.noting import did_you_mean
from freebody.numeric.blow import checked_blow
from freebody.numeric.contact.bounded import Bounded
from freebody.numeric.contact.hybrid import Hybrid
from freebody.numeric.contact.record import PhaseRecord, in_one
from freebody.numeric.contact.rows import ModeOf
from freebody.numeric.contact.start import assembled_touching, start_velocities
from freebody.numeric.contact.sudden import SuddenBlows
from freebody.numeric.engine.course import Trajectory
from freebody.numeric.engine.engine import Engine
from freebody.numeric.engine.evaluator import EngineWatch
from freebody.numeric.instant import check_laws
from freebody.numeric.jets import Array
from freebody.numeric.kernels import factoring
from freebody.numeric.numbers import Numbers
from freebody.numeric.options import SimulationOptions
from freebody.numeric.reference import Reference
from freebody.numeric.start_velocities import rates_not_given
from freebody.questions.clock import Clock
from freebody.questions.event_base import QuestionEvent
from freebody.study.simulation.at_borders import border_watches, with_borders
from freebody.study.where_true import end_and_size
from freebody.study.worded import without_value
from freebody.system.system import System

if TYPE_CHECKING:
    from freebody.numeric.tangent.motion import TangentMotion
    from freebody.present.scene import Scene

Progress = Callable[[float, int], None]


class Simulator:
    """A system with a number for every parameter, assembled at its start and packed for the engine."""

    def __init__(
        self,
        system: System,
        values: Mapping[str, float] | None = None,
        events: Sequence[str] = (),
        *,
        by_steps: bool = False,
        tells_borders: bool = False,
        stops_at_borders: bool = True,
        like: Simulator | None = None,
        placed: tuple[Reference, Array] | None = None,
    ) -> None:
        """values: of parameters, in SI, instead of the model's. events: what to look for, as "theta = 90 deg" or
        "theta' = 0", with "rising" or "falling" behind it for one direction only; one that begins with "stop when" ends
        the motion. by_steps: for time stepping, which does not follow single contacts. tells_borders: loads that act on
        one side only have events where they begin and end; stops_at_borders: their motion stops there and begins anew,
        as one with derivatives must not. like: of the same system from another start, perhaps, of which what does not
        hang on that is taken. placed: the system in numbers and its pose at the start (`placed_at_start`), where that
        is known. Raises CannotAnswer naming parameters without a value, or what contradicts itself at the start."""
        self.system = system
        for name, value in (values or {}).items():
            if name in system.parameters and system.parameters[name].sign == "positive" and not value > 0.0:
                raise InputError(
                    Message("{name} = {value:g} is not positive; the model says that it is", name=name, value=value)
                )
        self.reference, q = placed or placed_at_start(system, values)
        self.blow = checked_blow(self.reference, q)
        v = start_velocities(self.reference, q)
        self._began = q, v if self.blow is None else self.blow.before
        self.numbers = self.reference.numbers()
        watches, tracked = [*_watches(self, events), *_limits_of_validity(self)], list(system.measures.values())
        self.tells_borders, self._values = tells_borders, values
        borders = (
            []
            if by_steps or not stops_at_borders
            else [*border_watches(system, self.reference.number, self.numbers.length)]
        )
        self.borders = frozenset(watch.name for watch in borders)
        watches += borders
        self.bounded = None if by_steps or not has_phases(system) else Bounded(self.numbers, watches, tracked)
        again = None if like is None or self.bounded is not None else like.engine_of(system, self.numbers, watches)
        if self.bounded is None:
            self.engine = again or Engine(self.numbers, watches, tracked)
        else:
            self.engine = self.bounded.free
        if again is not None and like is not None and not system.space:  # in space where axes start is drawn
            self.scene = like.scene
        self.start = self.engine.state(*self.reference.by_body(q, v))
        start = self.reference.snapshot(q, v)
        check_laws(self.reference, start.geometry)
        for rub in system.dry_friction:
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
            raise CannotAnswer(further(str(error), *islice(without_value(system), 1))) from error
        if self.engine.layout.has_gap[0] or self.engine.room.info[factoring.N_LEFT_OUT]:
            _ = start.accelerations  # the dense solution refuses what moves without inertia or contradicts itself

    def engine_of(self, system: System, numbers: Numbers, watches: Sequence[EngineWatch]) -> Engine | None:
        """An engine of the same system from another start, by what is packed already; None where other arrays would
        be packed. Those of contact modes are changed on the way, and are not taken."""
        is_packed_alone = self.bounded is None and self.engine.watches == tuple(watches)
        return self.engine.again(numbers) if is_packed_alone and self.system.starts_otherwise(system) else None

    @cached_property
    def scene(self) -> Scene:
        """What is drawn of it."""
        from freebody.present.scene import Scene  # of a motion that is shown

        return Scene.of(self.system, self.reference.number)

    @cached_property
    def assumptions(self) -> tuple[str, ...]:
        """Of the model, and of the rates at the start."""
        own = self.system.assumptions
        return own if has_phases(self.system) else (*own, *rates_not_given(self.reference, *self._began))

    @property
    def degrees_of_freedom(self) -> int:
        """Independent velocities at the start."""
        self.engine.evaluate(self.start, 0.0)
        n_free = int(np.count_nonzero(self.engine.layout.inverse_mass))
        return n_free - len(self.engine.held) + int(self.engine.room.info[factoring.N_LEFT_OUT])

    def tangents(self, names: Sequence[str]) -> TangentMotion:
        """The motion with its derivatives by parameters. Raises CannotAnswer where the start has none."""
        from freebody.numeric.tangent.motion import TangentMotion  # nobody else needs it

        if self.borders:
            return Simulator(self.system, self._values, stops_at_borders=False).tangents(names)
        engine = self.engine if self.bounded is None else self.bounded
        return TangentMotion(self.reference, engine, self.start, self._near, names)

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
        past: Collection[str] = (),
        phases: list[PhaseRecord] | None = None,
        **given: Any,
    ) -> Trajectory:
        """The motion to `until` [s] as arrays. outputs: times at which it is wanted [s]. state, start, near: of a
        motion that goes on, from its `Trajectory`; past: the blows that have happened in it. first_step: [s], chosen if
        it is zero. phases: gets those of the motion, with all their steps. given: of the options."""
        options = replace(options or SimulationOptions(), **given)
        near = self._near if near is None else near
        self.engine.count_from(near)
        y = (self.start if state is None else state).copy()
        if self.bounded is not None:
            wanted = np.array([until]) if outputs is None else outputs
            blows = SuddenBlows(self.reference) if self.system.blows else None
            hybrid = Hybrid(self.bounded, options, blows, past, self.borders, keep=phases is not None)
            course = hybrid.run(y, start, until, wanted, near, progress)
            if phases is not None:
                phases += hybrid.phases
            return self._told(course)
        given = {"start": start, "first_step": first_step, "outputs": outputs, "progress": progress}
        given |= {"keep": phases is not None, "borders": self.borders}
        courses = list(self.engine.runs(y, until, options, **given))
        if phases is not None:
            phases += (PhaseRecord(course, self.engine, ModeOf(frozenset(), ())) for course in courses)
        return self._told(in_one(courses, self.borders))

    def _told(self, course: Trajectory) -> Trajectory:
        return replace(course, events=with_borders(self.system, course.events, told=self.tells_borders))


def placed_at_start(system: System, values: Mapping[str, float] | None = None) -> tuple[Reference, Array]:
    """A system in numbers, and its pose at the start. values: of parameters, in SI, instead of the model's. Raises
    CannotAnswer naming parameters without a value, or what contradicts itself."""
    reference = Reference(system, values)
    return reference, assembled_touching(reference)


def has_phases(system: System) -> bool:
    """Whether a motion may change its law on the way: something can part, touch, stick or slip."""
    return bool(system.contacts or system.limits or system.brakes or system.blows) or any(
        row.unilateral for row in system.constraint_rows
    )


def _watches(simulator: Simulator, events: Sequence[str]) -> list[EngineWatch]:
    """Events in words. Raises InputError if one cannot be read."""
    found: list[EngineWatch] = []
    for text in events:
        read = read_event(simulator.system, text)
        value = simulator.reference.number(read.event.value)
        size = max(abs(value), 1.0 if read.event.order else _size(simulator, read.event.measure))
        found.append(
            EngineWatch(
                read.words,
                read.event.measure,
                read.event.order,
                value,
                read.direction,
                is_terminal=read.stops,
                size=size,
            )
        )
    return found


def _limits_of_validity(simulator: Simulator) -> list[EngineWatch]:
    """Where the motion leaves what the model takes for granted."""
    found: list[EngineWatch] = []
    for v in simulator.system.validities:
        end, size = end_and_size(v, simulator.reference)
        found.append(EngineWatch(v.left, v.measure, 0, end, -v.sign, size=size))
    return found


@dataclass(frozen=True)
class ReadEvent:
    """An event as it was asked for. words: without what is to be done; direction: +1 rising, -1 falling, 0 both."""

    words: str
    event: QuestionEvent
    direction: int
    stops: bool


def read_event(system: System, text: str) -> ReadEvent:
    """An event in words. Raises InputError if it cannot be read."""
    stops = text.strip().lower().startswith("stop when")
    words = text.strip()[len("stop when") :].strip() if stops else text.strip()
    asked, direction = words, 0
    for word, sign in (("rising", 1), ("falling", -1)):
        if asked.endswith(f" {word}"):
            asked, direction = asked.removesuffix(word).strip(), sign
    try:
        question = system.question(f"time when {asked}")
    except ModelError as error:
        measures = system.measures
        listed = Message(" Named measures: {names}.", names=", ".join(measures)) if measures else ""
        called = words.split("=")[0].strip()
        guess = did_you_mean(called, measures)
        if get_close_matches(called, measures, n=1):  # a slip in the name: no list of what else one could ask
            told = Message("event '{text}': there is no measure {name}.{guess}", text=text, name=called, guess=guess)
            raise InputError(told) from error
        raise InputError(
            Message(
                "event '{text}': {message}.{guess}{listed}",
                text=text,
                message=error.problems[0].message,
                guess=guess,
                listed=listed,
            )
        ) from error
    event = question.event
    if event is None:
        raise InputError(Message("'{text}' is no event; write, for example, theta = 90 deg", text=text))
    if isinstance(event, Clock):
        told = Message("'{text}' is an instant, and no event; say until when the motion is followed", text=text)
        raise InputError(told)
    return ReadEvent(words, event, direction, stops)


def _size(simulator: Simulator, measure: Measure) -> float:
    from freebody.language.units import LENGTH

    return simulator.numbers.length if measure.dimension == LENGTH else 1.0
