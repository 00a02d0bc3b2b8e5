"""Whether something happens in a motion, or lasts, as the engine sees it: states along a simulated motion."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.numeric.contact.record import ABSENT
from freebody.numeric.engine.course import ContactRecord, Status, Trajectory
from freebody.numeric.options import SimulationOptions
from freebody.numeric.snapshot import Snapshot
from freebody.questions.clock import Clock
from freebody.questions.course import Transition
from freebody.questions.event import TurnsBack
from freebody.questions.event_base import QuestionEvent
from freebody.questions.happening import Happening, Lasting
from freebody.study.answering.witness import patience
from freebody.study.phases.locking import locks_in_numbers
from freebody.study.phases.standing import cannot_slip, feet_of
from freebody.study.simulation.simulator import Simulator
from freebody.system.system import System

_LOOKS = 1500  # instants at which states are looked at
# [s] for which it is followed, a longer time where nothing is decided in the shorter ones: what follows a contact that
# opens at once may be hundreds of bounces
_TIMES = (0.02, 0.2, 2.0, 10.0)
_LATE = 100.0  # [s] for which it is followed in the end, where that comes to an end
_LATER = (10.0, 100.0)  # times as long, where it goes on so evenly that few steps led to there
_FEW_STEPS = 300
_STEPS = 50_000
_TURNS = 150  # of the looks, at which it is seen whether a rate has turned
_TOLERANCE = 1e-9
_STILL = 1e-9  # [SI] of a slip that is none
_SOON = 1e-7  # [s] in which what is there at once shows


def is_seen(system: System, happening: Happening, touching: frozenset[str], values: Mapping[str, float]) -> bool:
    """Whether it is so at values of the parameters. touching: bounds that touch at the start.

    Raises CannotAnswer where the simulated motion does not tell: it ends too early, or two things
    come so close together that the looks do not tell them apart."""
    if happening.away is not None and not _sets_out(system, happening.away, values):
        return False
    if isinstance(happening.what, Lasting) and happening.what.kind == "locks":
        return locks_in_numbers(system, touching, happening.what, values) == happening.is_so
    if happening.at_once:
        if isinstance(happening.what, Transition) and happening.what.kind == "rolls":
            happening = replace(happening, what=Lasting("rolls", happening.what.of, happening.text))
        return _Seen(system, happening, _SOON, touching, values).is_so() == happening.is_so
    seen, slow = None, _slowness(system, values)
    for until in _TIMES:
        seen = _Seen(system, happening, slow * until, touching, values)
        if seen.is_decided:
            return seen.is_so() == happening.is_so
    with suppress(CannotAnswer):
        # what has lasted so long is not followed to where its place has no digits left for a slip
        for factor in (1.0,) if isinstance(happening.what, Lasting) else (1.0, *_LATER):
            seen = _Seen(system, happening, slow * _LATE * factor, touching, values)
            if seen.is_decided or seen.course.n_steps > _FEW_STEPS:
                break
    assert seen is not None
    if seen.limit < np.inf and not seen.is_decided:
        raise CannotAnswer(Message("the time that is asked about comes later than the simulated motion was followed"))
    return seen.is_so() == happening.is_so


def _sets_out(system: System, away: Measure, values: Mapping[str, float]) -> bool:
    """Whether a distance grows at first."""
    start = _start(system, values)
    rate = start.rate(away)
    return rate > _STILL or (abs(rate) <= _STILL and start.acceleration(away) > 0.0)


def _start(system: System, values: Mapping[str, float]) -> Snapshot:
    simulator = Simulator(system, values)
    q, v = map(simulator.reference.by_column, simulator.engine.coordinates(simulator.start))
    return simulator.reference.snapshot(q, v)


def _slowness(system: System, values: Mapping[str, float]) -> float:
    """By how much longer a motion is followed that takes long, as that of a planet does."""
    return patience(_start(system, values), 1.0)


class _Seen:
    """One simulated motion. Times are those of looks, infinite for what does not come."""

    def __init__(
        self, system: System, happening: Happening, until: float, touching: frozenset[str], values: Mapping[str, float]
    ) -> None:
        self.system, self.happening = system, happening
        self.places, self.touching = touching, sorted({name.partition(".")[0] for name in touching})  # connections
        asked = [e for e in (happening.what, happening.before) if isinstance(e, QuestionEvent)]
        simulator = Simulator(system, values, events=tuple(e.text for e in asked))
        looks = np.linspace(0.0, until, 3 if happening.at_once else _LOOKS)
        options = SimulationOptions(method="dop853", tolerance=_TOLERANCE, max_steps=_STEPS)
        self.course: Trajectory = simulator.run(until, options, outputs=looks)
        if self.course.status not in (Status.FINISHED, Status.EVENT):
            raise CannotAnswer(Message("the simulated motion ends early: {why}", why=self.course.message))
        self.simulator = simulator
        self.room = until / (len(looks) - 1)
        if not happening.at_once and isinstance(happening.what, Lasting):
            self.time = np.inf
        else:
            self.time = self._when(happening.what)
        self.limit = np.inf if happening.before is None else self._when(happening.before)
        self.fails = self._fails(happening.what) if isinstance(happening.what, Lasting) else np.inf

    @property
    def is_decided(self) -> bool:
        """By something that came while it was followed: the time of a clock is known before it has come."""
        return min(self.time, self.limit, self.fails) <= self.course.times[-1]

    def is_so(self) -> bool:
        """With the same looks for all that is compared."""
        mine = self.fails if isinstance(self.happening.what, Lasting) else self.time
        if self.limit < np.inf and abs(mine - self.limit) <= 2 * self.room:
            raise CannotAnswer(Message("two events come too close together to be told apart"))
        return mine > self.limit or mine == np.inf if isinstance(self.happening.what, Lasting) else mine < self.limit

    def _record(self) -> ContactRecord:
        record = self.course.contact
        if record is None:
            raise CannotAnswer(Message("nothing can touch or slip in this system"))
        return record

    def _when(self, asked: object) -> float:
        """The first time at which something comes."""
        match asked:
            case Clock():
                return np.inf if asked.time is None else self.simulator.reference.number(asked.time)
            case TurnsBack():
                return self._turned(asked)
            case QuestionEvent():
                return min(
                    (e.time for e in self.course.events if e.name == asked.text and e.kind != "start"), default=np.inf
                )
            case Transition():
                return self._changes(asked)
            case _:
                return np.inf

    def _turned(self, asked: TurnsBack) -> float:
        """The first of some looks at which the rate has another sign than when the measure set out."""
        times, reference, engine = self.course.times, self.simulator.reference, self.simulator.engine
        events = [e.time for e in self.course.events if e.name == asked.text]
        behind = np.minimum(np.searchsorted(times, events) + 1, len(times) - 1)
        looks = np.unique([*np.linspace(0, len(times) - 1, _TURNS).astype(int), *behind])

        def rate(k: int) -> float:
            q, v = map(reference.by_column, engine.coordinates(engine.state_at(self.course, k)))
            return reference.snapshot(q, v, float(times[k])).rate(asked.measure)

        sign = 0.0
        for k in looks:
            now = rate(int(k))
            if abs(now) > _STILL:
                sign = sign or np.sign(now)
                if np.sign(now) != sign:
                    return float(times[k])
        return np.inf

    def _columns(self, names: tuple[str, ...], of: tuple[str, ...]) -> list[int]:
        return [k for k, name in enumerate(names) if not of or name.partition(".")[0] in of]

    def _slips(self, of: tuple[str, ...]) -> list[int]:
        """The columns of friction between surfaces that slide, not of what resists rolling or spinning."""
        names = self._record().dry_friction
        turning = {rub.name for rub in self.system.dry_friction if rub.resists_turning}
        return [k for k in self._columns(names, of) if names[k] not in turning]

    def _first(self, holds: Any) -> float:
        """The first look at which something is so; (n_looks,)."""
        places = np.flatnonzero(np.asarray(holds))
        return float(self.course.times[places[0]]) if len(places) else np.inf

    def _fails(self, lasting: Lasting) -> float:
        """The first look at which a state is none."""
        if lasting.kind == "touches" and (acting := self._acting(lasting.of)):
            return self._first(~np.all(acting, axis=0))
        record = self._record()
        if lasting.kind == "touches":
            closed = record.states.astype(bool)
            meant = lasting.of or self.touching
            groups = [[k for k, name in enumerate(record.bounds) if name.partition(".")[0] == c] for c in meant]
            lost = [~closed[:, group].any(axis=1) for group in groups]
            return self._first(np.any(lost, axis=0)) if lost else np.inf
        if lasting.kind == "stands":
            closed = record.states.astype(bool)
            places = {name: k for k, name in enumerate(record.bounds)}
            begun = [name for name in record.bounds if name in self.places]
            tipped = list[NDArray[np.bool_]]()
            for feet in feet_of(self.system, begun, lasting.of):
                own = closed[:, [places[name] for name in feet.names]]
                is_held = feet.is_hinged | np.asarray(own.any(axis=1))
                tipped.append(np.asarray(~own.all(axis=1) & is_held))
            return self._first(np.any(tipped, axis=0)) if tipped else np.inf
        own = self._slips(lasting.of)
        connections = dict.fromkeys(record.dry_friction[k].partition(".")[0] for k in own)
        begun = [name for name in record.bounds if name in self.places]
        rolling = [record.bounds.index(name) for name in cannot_slip(self.system, begun, lasting.of)]
        lost = [np.asarray(~record.states.astype(bool)[:, k]) for k in rolling]
        for connection in connections:
            states = record.slips[:, [k for k in own if record.dry_friction[k].partition(".")[0] == connection]]
            lost.append(~(states == 0).any(axis=1) | ((states != 0) & (states != ABSENT)).any(axis=1))
        return self._first(np.any(lost, axis=0)) if lost else np.inf

    def _acting(self, of: tuple[str, ...]) -> list[NDArray[np.bool_]]:
        """At which looks each load of some names acts that does so on one side of a border only; of none, each load
        that does, where nothing can touch."""
        all_ = not of and self.course.contact is None
        pushes = [push for push in self.system.applied_loads if push.one_sided and (all_ or push.load in of)]
        if not pushes:
            return []
        reference, engine = self.simulator.reference, self.simulator.engine
        found = [np.zeros(len(self.course.times), dtype=bool) for _push in pushes]
        for k, time in enumerate(self.course.times):
            q, v = map(reference.by_column, engine.coordinates(engine.state_at(self.course, k)))
            now = reference.snapshot(q, v, float(time))
            for push, acts in zip(pushes, found, strict=True):
                border = push.one_sided
                assert border is not None
                gap = border.side * (now.value(border.measure) - reference.number(border.limit))
                acts[k] = gap < -_STILL
        return found

    def _changes(self, asked: Transition) -> float:
        if asked.kind in ("opens", "touches") and (acting := self._acting(asked.of)):
            wanted = [acts if asked.kind == "touches" else ~acts for acts in acting]
            return min(self._first(np.diff(np.append(now[:1], now).astype(int)) > 0) for now in wanted)
        record = self._record()
        if asked.kind in ("opens", "touches"):
            own = self._columns(record.bounds, asked.of)
            closed = record.states[:, own].astype(bool)
            if asked.kind == "touches":
                hits = [
                    c.time
                    for c in record.collisions
                    if any(not asked.of or n.partition(".")[0] in asked.of for n in c.before)
                ]
                if asked.count > 1:
                    times = sorted({*hits})
                    return times[asked.count - 1] if len(times) >= asked.count else np.inf
                return min([self._first(closed[:, k] & ~closed[0, k]) for k in range(len(own))] + hits, default=np.inf)
            closed[0] |= [record.bounds[k] in self.places for k in own]
            was = np.maximum.accumulate(closed, axis=0)
            return self._first((was & ~closed).any(axis=1))
        own = self._slips(asked.of)
        states = record.slips[:, own]
        slides = (states != 0) & (states != ABSENT)
        if asked.kind == "slips":
            begins = slides[0:1] | (slides & np.maximum.accumulate(states == 0, axis=0))
            return (
                self._first(np.vstack([begins[:1] & self._still_at_start(own), begins[1:]]).any(axis=1))
                if len(own)
                else np.inf
            )
        before = np.maximum.accumulate(slides, axis=0)
        if asked.kind == "rolls":
            is_asked, from_start = asked is self.happening.what, Lasting("rolls", asked.of, asked.text)
            if is_asked and (states[:2] == 0).any() and self._fails(from_start) > self.course.times[1]:
                return 0.0
            return self._first((before & (states == 0)).any(axis=1))
        turned = np.zeros_like(slides)
        turned[1:] = slides[:-1] & (states[1:] != states[:-1])
        return self._first(turned.any(axis=1))

    def _still_at_start(self, own: list[int]) -> NDArray[np.bool_]:
        """Which frictions have no slip at the start."""
        reference = self.simulator.reference
        q, v = map(reference.by_column, self.simulator.engine.coordinates(self.simulator.start))
        now, rubs = reference.snapshot(q, v), {rub.name: rub for rub in self.system.dry_friction}
        names = [self._record().dry_friction[k] for k in own]
        return np.array([[abs(now.rate(rubs[name].row.measure)) < _STILL for name in names]])
