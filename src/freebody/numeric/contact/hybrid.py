"""Hybrid motions: phases in one contact mode each, which the engine integrates, and the transitions between them.

A phase ends where a guard is violated (a contact opens or closes, friction slips or sticks, an edge ends) or an event
ends the motion; `transition` then finds the impacts and the next mode.
"""

# the state of the loop in `run` comes from the motion that begins in it: depending on which file it looks at first,
# pyright takes types in this circle for partly unknown, though every call in it has a declared result
# pyright: reportUnknownArgumentType=false, reportUnknownVariableType=false, reportUnknownMemberType=false
from __future__ import annotations

import math
import time
from collections.abc import Callable, Collection, Iterable, Iterator
from dataclasses import dataclass, field, replace
from functools import partial
from typing import Any

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message, further, in_turn
from freebody.numeric.contact.after import After, Choice
from freebody.numeric.contact.bounded import Bounded
from freebody.numeric.contact.overlaps import without_direction
from freebody.numeric.contact.problem import OutcomeCount as Consistency
from freebody.numeric.contact.record import PhaseRecord, beside_its_way, cut, merged
from freebody.numeric.contact.rows import ContactInstant, ModeOf, within
from freebody.numeric.contact.sharing import SharedReactions
from freebody.numeric.contact.stillness import DIRECTED
from freebody.numeric.contact.sudden import SuddenBlows
from freebody.numeric.contact.transition import InstantTransition
from freebody.numeric.contact.trouble import advised, contradiction, jammed, turned_by_friction, unresisted_spin
from freebody.numeric.contact.words import events_between
from freebody.numeric.engine.course import BlowRecord, Collision, Event, Status, Trajectory
from freebody.numeric.engine.engine import Engine, step_at_border
from freebody.numeric.engine.motion import stopped
from freebody.numeric.engine.patrol import Guarding
from freebody.numeric.engine.writing import OF_MULTIPLIER, OF_RATE, OF_VALUE
from freebody.numeric.kernels import factoring
from freebody.numeric.kernels.arrays import Floats
from freebody.numeric.options import SimulationOptions

FIRST_STEP = 0.1  # of a phase, by the last of the one before
MOST_AT_ONCE = 40  # phases without progress
MOST_EVENTS = 20_000
NO_ENERGY = 1e-10  # by the kinetic energy
SOON = 1e-12  # [s] a time that is none: what is to happen by the clock before a motion begins happens then
CLOSED = 1e-12  # a gap that is none, by the size of the system
Progress = Callable[[float, int], None]
Ended = tuple[Status, str]  # how a motion ends, and why


@dataclass
class _Between:
    """Where a motion stands between two phases."""

    t: float
    near: Floats
    result: After  # of the instant: the state, and the mode that comes next
    asleep: set[int] = field(default_factory=set[int])  # barriers that count only once they have been above zero
    forbidden: list[Choice] = field(default_factory=list[Choice])  # what was shown to be impossible without progress
    n_at_once: int = 0  # phases without progress
    again: Callable[..., After] | None = None  # what follows if nothing counts as stopped yet


class Hybrid:
    """One motion under way."""

    def __init__(
        self,
        bounded: Bounded,
        options: SimulationOptions,
        blows: SuddenBlows | None = None,
        past: Collection[str] = (),
        borders: frozenset[str] = frozenset(),
        *,
        keep: bool = False,
    ) -> None:
        """past: the blows that have happened before; borders: terminal events at which the law of a load changes,
        and the mode does not; keep: the steps of all phases."""
        self.bounded, self.options, self.blows, self.borders, self.keep = bounded, options, blows, borders, keep
        bounded.hold_past(past)
        self.struck: list[BlowRecord] = []
        self.transition = InstantTransition(bounded, options.law, jams=options.jams)
        self.phases: list[PhaseRecord] = []
        self.events: list[Event] = []
        self.collisions: list[Collision] = []
        self.several: float | None = None  # when first several outcomes were consistent
        self.ahead: tuple[float, float] | None = None  # when the most energy was there for a moment, and how much
        self.sharing = SharedReactions(bounded)

    def run(
        self, y: Floats, start: float, until: float, outputs: Floats, near: Floats, progress: Progress | None = None
    ) -> Trajectory:
        """The motion from a state; outputs: times at which it is wanted."""
        began = time.perf_counter()
        at = _Between(start, near, self.transition.after(y, start, near, None))
        at.asleep = at.result.behind
        self._note(None, at.result, start)
        while True:
            ended = self._ended(at, until, began) or self._phase(at, until, began, outputs, progress)
            if ended is not None:
                return self._course(*ended, time.perf_counter() - began)

    def _ended(self, at: _Between, until: float, began: float) -> Ended | None:
        """Why no other phase begins: nothing is consistent with it, the end is reached, or too much happened."""
        t, n_events = at.t, len(self.events)
        if at.result.mode is None:
            if not self.phases:
                self.phases.append(self._no_phase(at.result.y, t))
            return Status.INCONSISTENT, contradiction(self.bounded, at.result, t)
        if (spread := self._spread_out(at.result.mode.closed, t)) is not None:
            if not self.phases:
                self.phases.append(self._no_phase(at.result.y, t))
            return spread
        if (spins := self._spins(at)) is not None:
            if not self.phases:
                self.phases.append(self._no_phase(at.result.y, t))
            return spins
        if t >= until:
            return Status.FINISHED, ""
        left, steps_left = self._left(began)
        if left <= 0.0 or steps_left <= 0:
            limit = self.options.max_seconds if left <= 0.0 else None
            return Status.TOO_LONG, stopped(t, Message("{n} phases", n=len(self.phases)), limit)
        if at.n_at_once > MOST_AT_ONCE or n_events > MOST_EVENTS:
            what = Message("no mode lasts") if at.n_at_once > MOST_AT_ONCE else Message("{n} events", n=n_events)
            return Status.CHATTER, advised(self.bounded, Message("{what} at t = {t:.9g} s", what=what, t=t))
        return None

    def _left(self, began: float) -> tuple[float, int]:
        """Seconds and steps that are left."""
        n_steps = sum(phase.course.n_steps for phase in self.phases)
        return self.options.max_seconds - (time.perf_counter() - began), self.options.max_steps - n_steps

    def _phase(
        self, at: _Between, until: float, began: float, outputs: Floats, progress: Progress | None
    ) -> Ended | None:
        """One phase, and what follows at its end; how the whole motion ends, where it does."""
        y, t, mode = at.result.y, at.t, at.result.mode
        assert mode is not None
        left, steps_left = self._left(began)

        # the engine of the mode at its start, with what sticks kept where it is, and what is not unique shared
        self.bounded.ends.set(mode.pivots)
        now = self.bounded.instant(y, t, at.near)
        mode = self.bounded.grouped(replace(mode, past=self.bounded.past), now)
        engine, guards, about = self.bounded.engine(mode)
        self._keep(mode, now)
        self.bounded.point(mode, DIRECTED * self.transition.still.speed(y, now))
        engine.count_from(at.near)
        sizes = self._sizes(engine, guards, y, t)
        is_open = engine.is_shared or engine.room.info[factoring.N_LEFT_OUT] > 0.0
        if is_open:
            self.sharing.share(engine, mode, y, t)

        # up to the first guard that is violated, the next blow, or the end
        by_clock = self._by_clock(until)
        course: Trajectory = engine.run(
            y,
            until if by_clock is None else max(self.bounded.blows[by_clock].time, t + SOON),
            replace(self.options, max_seconds=left, max_steps=steps_left),
            start=t,
            first_step=self._first_step(t, until),
            outputs=np.concatenate(([t], outputs[outputs > t])),
            progress=progress,
            keep=self.keep,
            guarded=Guarding(
                sizes,
                partial(self._is_valid, engine, about),
                [g for g, (what, k) in enumerate(about) if what == "gap" and k in at.asleep],
                self.bounded.turning,
                partial(self._lasts, mode) if mode.closed and is_open else None,
            ),
        )
        if course.status in (Status.UNREACHABLE, Status.SINGULAR) and self.sharing.takes_back(engine, mode):
            return None
        if course.status is Status.UNREACHABLE and at.again is not None:
            # slips that had nearly stopped go on, and gaps that nothing can close any more stay as they are
            at.forbidden += [("closed", k, None) for k in self._not_closing(mode, now)]
            at.result, at.again = at.again(forbidden=tuple(at.forbidden)), None
            self._note(mode, at.result, t)
            return None

        # what it leaves
        self.phases.append(PhaseRecord(course, engine, mode))
        if (turned := beside_its_way(self.bounded, self.phases[-1])) is not None:
            self.phases[-1] = PhaseRecord(cut(course, turned[0] + 1), engine, mode)
            end = self.bounded.barriers[turned[1]].bound
            return Status.INCONSISTENT, turned_by_friction(end, float(course.times[turned[0]]))
        at.near = course.near
        y = engine.state_at(course, -1)
        y[engine.at_work] = course.work[-1]
        self.events += [e for e in course.events if not e.name.startswith("@") or e.name in self.borders]
        blow = self._blow_at_end(course, mode, by_clock)
        if blow is not None:
            return self._struck_by(blow, at, course, mode, y)
        if course.ends_at(self.borders):
            at.n_at_once = at.n_at_once + 1 if course.t_end <= at.t else 0
            at.t, at.forbidden, at.again, at.result = course.t_end, [], None, replace(at.result, mode=mode, y=y)
            return None
        if course.violated < 0:
            return None if self._slips_vanish(at, course, mode, y) else self._stopped(course, mode)
        what, k = about[course.violated]
        if what in ("foot", "gap"):
            self.bounded.instant(y, course.t_end, at.near)
            if (spread := self._spread_out((k,), course.t_end)) is not None:
                return spread
        self._violated(what, k, at, course, mode, y)
        return None

    def _first_step(self, t: float, until: float) -> float:
        """[s] By the last one; chosen by the engine where it is zero."""
        if not self.phases:
            return step_at_border(until - t, until) if self.borders else 0.0
        last = self.phases[-1].course
        if last.status is Status.STEP_TOO_SMALL:  # of slips that vanished
            return 0.0
        return step_at_border(last.last_step, until) if last.ends_at(self.borders) else FIRST_STEP * last.last_step

    def _spread_out(self, closed: Iterable[int], t: float) -> Ended | None:
        """How a motion ends where a contact is not in a single place."""
        spread = self.bounded.spread_out(closed)
        if spread is None:
            return None
        what = Message("{what} at t = {t:.9g} s", what=spread.pitfall or spread.name, t=t)
        return Status.INCONSISTENT, without_direction(what, spread)

    def _spins(self, at: _Between) -> Ended | None:
        """How a motion ends where a rough flat end spins as a phase begins."""
        b, closed = self.bounded, () if at.result.mode is None else sorted(at.result.mode.closed)
        if all(b.barriers[k].spinning < 0 for k in closed):
            return None
        b.instant(at.result.y, at.t, at.near)
        spins = b.spinning(closed)
        return None if spins is None else (Status.INCONSISTENT, unresisted_spin(spins, at.t))

    def _stopped(self, course: Trajectory, mode: ModeOf) -> Ended:
        """How a motion ends with a phase that no guard ended."""
        jam = ""
        last = course.events[-1] if course.events else None
        if last is not None and last.is_terminal:
            spins = self.bounded.spinning(mode.closed, by=last.name)
            if spins is not None:
                return Status.INCONSISTENT, unresisted_spin(spins, course.t_end)
        if course.status in (Status.STEP_TOO_SMALL, Status.NOT_FINITE):
            jam = jammed(self.bounded, mode, course.t_end)
        return (Status.INCONSISTENT, jam) if jam else (course.status, course.message)

    def _slips_vanish(self, at: _Between, course: Trajectory, mode: ModeOf, y: Floats) -> bool:
        """Whether slips in planes ended together, as those of a box that slides and spins do: the slower they are, the
        faster their forces turn, so that no step is short enough for what is left. What follows on it is found."""
        if course.status is not Status.STEP_TOO_SMALL:
            return False
        now = self.bounded.instant(y, course.t_end, at.near)
        ended = self.transition.still.vanishing(y, now, mode)
        if not ended:
            return False
        at.n_at_once = 0 if course.t_end > at.t else at.n_at_once + 1
        at.t, at.forbidden, at.again = course.t_end, [], None
        at.result = self.transition.after(y, at.t, at.near, mode, stopped=ended)
        at.asleep = at.result.behind
        self._note(mode, at.result, at.t)
        return True

    def _struck_by(self, blow: int, at: _Between, course: Trajectory, mode: ModeOf, y: Floats) -> Ended | None:
        """What follows on a blow at the end of a phase."""
        at.n_at_once = at.n_at_once + 1 if course.t_end <= at.t else 0
        at.t, at.forbidden, at.again = course.t_end, [], None
        trouble = self._strike(blow, y, at.t, at.near)
        if trouble:
            return Status.INCONSISTENT, trouble
        at.result = self.transition.after(y, at.t, at.near, mode)
        at.asleep = at.result.behind
        self._note(mode, at.result, at.t)
        return None

    def _violated(self, what: str, k: int, at: _Between, course: Trajectory, mode: ModeOf, y: Floats) -> None:
        """What follows on a guard that was violated at the end of a phase: the next mode."""
        is_progress = course.t_end > at.t
        at.n_at_once = 0 if is_progress else at.n_at_once + 1
        at.t = course.t_end
        at.forbidden = ([] if is_progress else at.forbidden) + self._excluded(what, k, mode, is_progress=is_progress)
        if self._hands_over(what, k, at, mode, y):
            return
        after = partial(
            self.transition.after,
            y,
            at.t,
            at.near,
            mode,
            touched=(k,) if what == "gap" else (),
            left=k if what == "foot" else self._pivot_of(what, k, mode),
        )
        has_stopped = what == "slip" and is_progress
        at.result = after(stopped=(k,) if has_stopped else (), forbidden=tuple(at.forbidden))
        at.again = after
        passed = {k} if what == "foot" else set[int]()
        at.asleep = at.result.behind | passed | (set[int]() if is_progress else at.asleep)
        self._note(mode, at.result, at.t)

    def _hands_over(self, what: str, k: int, at: _Between, mode: ModeOf, y: Floats) -> bool:
        """Whether a pivot and the rim for which it stands change places; then what follows is known."""
        ends = self.bounded.ends
        if what == "tilt":
            at.result = self.transition.after(y, at.t, at.near, mode, touched=(ends.by_edge[k].rim,), left=k)
        elif what == "foot" and k in ends.by_rim and self.bounded.is_flattened(k, y, at.t, at.near):
            at.result = self.transition.falls_back(y, at.t, at.near, mode, k)
        else:
            return False
        at.again, at.asleep = None, at.result.behind
        self._note(mode, at.result, at.t)
        return True

    def _pivot_of(self, what: str, k: int, mode: ModeOf) -> int | None:
        """The pivot of a flat end that has come down."""
        end = self.bounded.ends.by_flat.get(k) if what == "gap" else None
        return end.edge if end is not None and end.edge in mode.closed else None

    # -- blows --------------------------------------------------------------------------------
    def _by_clock(self, until: float) -> int | None:
        """The next blow by the clock before a time."""
        found = [
            (blow.time, k)
            for k, blow in enumerate(self.bounded.blows)
            if k not in self.bounded.past and blow.watch is None and blow.time < until
        ]
        return min(found)[1] if found else None

    def _blow_at_end(self, course: Trajectory, mode: ModeOf, by_clock: int | None) -> int | None:
        """The blow with which a phase ends."""
        last = course.events[-1] if course.events else None
        if last is not None and last.is_terminal:
            names = {f"@{blow.name}": k for k, blow in enumerate(self.bounded.blows) if k not in mode.past}
            return names.get(last.name)
        is_over = course.violated < 0 and course.status is Status.FINISHED
        return by_clock if is_over and by_clock is not None and course.t_end >= self._time_of(by_clock) else None

    def _time_of(self, k: int) -> float:
        return self.bounded.blows[k].time

    def _strike(self, k: int, y: Floats, t: float, near: Floats) -> str:
        """A blow changes the velocities of a state; why it cannot, or nothing."""
        assert self.blows is not None
        b, free = self.bounded, self.bounded.free
        name, past = b.blows[k].name, {b.blows[j].name for j in b.past}
        poses, velocities = free.coordinates(y)
        by_column, by_body = self.blows.by_column, self.blows.by_body
        q = by_column(poses)
        try:
            v, record = self.blows.at(name, past, q, by_column(velocities), t)
        except CannotAnswer as error:
            return str(error)
        n = free.n_coordinates
        y[n : 2 * n] = free.state(*by_body(q, v))[n : 2 * n]
        y[free.at_work] += record.energy_change
        b.close(k, y, t, near)
        self.struck.append(record)
        self.events.append(Event(t, self.blows.words(name), "blow"))
        return ""

    # -- between phases -----------------------------------------------------------------------
    def _excluded(self, what: str, k: int, mode: ModeOf, *, is_progress: bool) -> list[Choice]:
        """What a violation shows to be impossible from now on."""
        if what == "tilt":
            return []
        if what in ("press", "foot"):
            return [("closed", k, None)]
        if what == "gap":
            return [] if is_progress else [("open", k, None)]
        if what == "grip":
            return [("drag", k, 0)]
        return [] if is_progress else [("drag", k, mode.drags[k])]

    def _keep(self, mode: ModeOf, now: ContactInstant) -> None:
        """What sticks is kept where it is now."""
        for k, state in enumerate(mode.drags):
            if state == 0 and (not self.phases or self.phases[-1].mode.drags[k] != 0):
                self.bounded.keep(k, now)

    def _lasts(self, mode: ModeOf, y: Floats, t: float, near: Floats) -> bool:
        return self.transition.lasts(y, t, near, mode)

    def _is_valid(self, engine: Engine, about: list[tuple[str, int]], guard: int, slack: float) -> bool:
        what, k = about[guard]
        return what != "gap" or within(self.bounded.barriers[k], engine.room.rows, slack * self.bounded.numbers.length)

    def _sizes(self, engine: Engine, guards: Any, y: Floats, t: float) -> Floats:
        """What counts as large of each guard: lengths, speeds and forces of the system now."""
        length = self.bounded.numbers.length
        accelerations, multipliers = engine.evaluate(y, t)
        n = self.bounded.free.n_coordinates
        unit = engine.unit
        fastest = float((np.abs(y[n : 2 * n]) / unit).max(initial=0.0)) * length
        hardest = float((np.abs(accelerations.ravel()) / unit).max(initial=0.0)) * length
        speed = max(fastest, math.sqrt(hardest * length))
        force = np.abs(engine.room.force) * np.where(unit == 1.0, 1.0 / length, 1.0)
        strength = max(float(force.max(initial=0.0)), float(np.abs(multipliers).max(initial=0.0)))
        known = {OF_VALUE: length, OF_RATE: speed, OF_MULTIPLIER: strength}
        return np.array([known.get(guard.kind, 0.0) for guard in guards])

    def _not_closing(self, mode: ModeOf, now: ContactInstant) -> list[int]:
        """Closed barriers with a gap beyond round-off."""
        b = self.bounded
        return [k for k in mode.closed if abs(float(now.values[b.barriers[k].place])) > CLOSED * b.numbers.length]

    # -- the result ---------------------------------------------------------------------------
    def _course(self, status: Status, message: str, wall: float) -> Trajectory:
        events = tuple(sorted(self.events, key=lambda e: e.time))
        message = further(*(said for said in (message, *self._remarks()) if said))
        return merged(
            self.bounded,
            self.phases,
            status,
            message,
            wall,
            events,
            tuple(self.collisions),
            tuple(self.struck),
            self.borders,
        )

    def _note(self, before: ModeOf | None, result: After, t: float) -> None:
        b, names = self.bounded, [b.name for b in self.bounded.barriers]
        if result.status is Consistency.SEVERAL and self.several is None:
            self.several = t
        for impact in result.impacts:
            self.collisions.append(
                Collision(
                    t,
                    {names[k]: x for k, x in impact.impulses.items()},
                    {b.rows[place].name: x for place, x in impact.friction.items()},
                    {names[k]: x for k, x in impact.before.items()},
                    {names[k]: x for k, x in impact.after.items()},
                    impact.energy_change,
                    impact.energy_grew,
                    {b.rows[place].name: b.rows[place].sign * x for place, x in impact.joints.items()},
                    tuple(b.rows[place].name for place in impact.not_unique),
                )
            )
            result.y[self.bounded.free.at_work] += impact.energy_change
        gained = result.settled + sum(impact.energy_change for impact in result.impacts)
        if result.settled > 0.0 and gained > max(0.0 if self.ahead is None else self.ahead[1], self._tiny(result.y)):
            self.ahead = t, gained
        self.events += events_between(self.bounded, before, result, t)

    def _tiny(self, y: Floats) -> float:
        """An energy that is none beside that of the motion."""
        n = self.bounded.free.n_coordinates
        inverse = self.bounded.inverse_mass
        kinetic = np.divide(y[n : 2 * n] ** 2, 2.0 * inverse, out=np.zeros(n), where=inverse > 0.0)
        return NO_ENERGY * float(kinetic.sum())

    def _remarks(self) -> Iterator[Message]:
        """What was taken where a rigid model leaves it open."""
        grew = [c for c in self.collisions if c.energy_grew]
        if grew:
            yield Message(
                "the law of impact made energy at t = {t:.6g} s (Newton's may with friction; Poisson's does not)",
                t=grew[0].time,
            )
        if self.several is not None:
            yield Message(
                "at t = {t:.6g} s friction leaves several outcomes consistent; the one that keeps contact was taken",
                t=self.several,
            )
        if (shared := self.sharing.remark()) is not None:
            yield shared
        if self.ahead is not None:
            yield Message(
                "rebounds too small to be followed end at t = {t:.6g} s at once, and their friction with them: for "
                "that moment the energy is {energy:.2g} J too high",
                t=self.ahead[0],
                energy=self.ahead[1],
            )
        if self.transition.collisions.tied:
            yield Message(
                "of {names}, which are hit equally fast, the first by name is taken first",
                names=in_turn([*self.transition.collisions.tied]),
            )
        if self.transition.collisions.is_replaced:
            yield Message(
                "the law of impact, {law}, has no solution where several contacts or frictions are hit at once; "
                "Poisson's took over",
                law=self.options.law.value,
            )

    def _no_phase(self, y: Floats, t: float) -> PhaseRecord:
        """The first instant, where nothing can follow on it: its forces are not known."""
        b = self.bounded
        course = b.free.run(y, t + 1e-9, SimulationOptions(method="dop853"), start=t, outputs=np.array([t]))
        one = {name: getattr(course, name)[:1] for name in ("times", "poses", "velocities", "work")}
        unknown = {name: np.full_like(getattr(course, name)[:1], np.nan) for name in ("accelerations", "multipliers")}
        course = replace(course, **one, **unknown, unique=np.zeros_like(course.unique[:1]))
        return PhaseRecord(course, b.free, ModeOf(frozenset(), (None,) * len(b.drags)))
