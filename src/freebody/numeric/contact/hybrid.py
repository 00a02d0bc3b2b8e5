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
from collections.abc import Callable, Collection, Iterator
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message, further, in_turn
from freebody.numeric.contact.bounded import Bounded
from freebody.numeric.contact.least import least_within
from freebody.numeric.contact.problem import OutcomeCount as Consistency
from freebody.numeric.contact.problem import OutcomeCount as Outcome
from freebody.numeric.contact.record import PhaseRecord, merged
from freebody.numeric.contact.rows import ContactInstant, ModeOf, within
from freebody.numeric.contact.sudden import SuddenBlows
from freebody.numeric.contact.transition import HELD_ALONE, After, Choice, InstantTransition
from freebody.numeric.contact.words import events_between
from freebody.numeric.engine.course import BlowRecord, Collision, Event, Status, Trajectory
from freebody.numeric.engine.engine import Engine
from freebody.numeric.engine.motion import stopped
from freebody.numeric.engine.patrol import Guarding
from freebody.numeric.engine.writing import OF_MULTIPLIER, OF_RATE, OF_VALUE
from freebody.numeric.kernels import dynamics
from freebody.numeric.kernels.arrays import Floats
from freebody.numeric.options import SimulationOptions
from freebody.tolerances import ROUND_OFF

FIRST_STEP = 0.1  # of a phase, by the last of the one before
MOST_AT_ONCE = 40  # phases without progress
MOST_EVENTS = 20_000
_FREE = 1e-6  # a force that null vectors of unit length leave free, by the sizes of rows
_SLIGHT = 1e-7  # of the largest effect: what free forces change by friction that is none
NO_ENERGY = 1e-10  # by the kinetic energy
SOON = 1e-12  # [s] a time that is none: what is to happen by the clock before a motion begins happens then
CLOSED = 1e-12  # a gap that is none, by the size of the system
ADVICE = Message("use time stepping (method moreau, with a step), which does not follow single events")
Progress = Callable[[float, int], None]


class Hybrid:
    """One motion under way."""

    def __init__(
        self, bounded: Bounded, options: SimulationOptions, blows: SuddenBlows | None = None, past: Collection[str] = ()
    ) -> None:
        """past: the blows that have happened before."""
        self.bounded, self.options, self.blows = bounded, options, blows
        bounded.hold_past(past)
        self.struck: list[BlowRecord] = []
        self.transition = InstantTransition(bounded, options.law, jams=options.jams)
        self.phases: list[PhaseRecord] = []
        self.events: list[Event] = []
        self.collisions: list[Collision] = []
        self.several: float | None = None  # when first several outcomes were consistent
        self.ahead: tuple[float, float] | None = None  # when the most energy was there for a moment, and how much
        self.shared: dict[str, None] = {}  # dry friction that is pressed by reactions that are not unique
        self.yielding: dict[
            ModeOf, None
        ] = {}  # modes in which a contact would have to pull for it, and carries nothing
        self.stiff: set[ModeOf] = set()  # modes in which letting such a contact go does not hold the others
        self.is_arbitrary = False  # whether they were ever shared otherwise than by the rule

    def run(
        self, y: Floats, start: float, until: float, outputs: Floats, near: Floats, progress: Progress | None = None
    ) -> Trajectory:
        """The motion from a state; outputs: times at which it is wanted."""
        began = time.perf_counter()
        t, mode = start, None
        result = self.transition.after(y, t, near, None)
        self._note(None, result, t)
        asleep = result.behind
        forbidden: list[Choice] = []
        n_at_once = 0
        again: Callable[..., After] | None = None  # what follows if nothing counts as stopped yet
        status, message = Status.FINISHED, ""
        while True:
            y, mode = result.y, result.mode
            if mode is None:
                status, message = Status.INCONSISTENT, self._contradiction(result, t)
                if not self.phases:
                    self.phases.append(self._no_phase(y, t))
                break
            mode = replace(mode, past=self.bounded.past)
            if t >= until:
                break
            left = self.options.max_seconds - (time.perf_counter() - began)
            steps_left = self.options.max_steps - sum(phase.course.n_steps for phase in self.phases)
            if left <= 0.0 or steps_left <= 0:
                limit = self.options.max_seconds if left <= 0.0 else None
                status, message = Status.TOO_LONG, stopped(t, Message("{n} phases", n=len(self.phases)), limit)
                break
            if n_at_once > MOST_AT_ONCE or len(self.events) > MOST_EVENTS:
                status = Status.CHATTER
                what = Message("no mode lasts")
                if n_at_once <= MOST_AT_ONCE:
                    what = Message("{n} events", n=len(self.events))
                message = self._advised(Message("{what} at t = {t:.9g} s", what=what, t=t))
                break
            now = self.bounded.instant(y, t, near)
            mode = self.bounded.grouped(mode, now)
            engine, guards, about = self.bounded.engine(mode)
            self._keep(mode, now)
            engine.count_from(near)
            sizes = self._sizes(engine, guards, y, t)
            is_open = engine.is_shared or engine.room.info[dynamics.N_LEFT_OUT] > 0.0
            if is_open:
                self._share(engine, mode, y, t)
            is_soft = bool(mode.closed) and is_open
            by_clock = self._by_clock(until)
            course: Trajectory = engine.run(
                y,
                until if by_clock is None else max(self.bounded.blows[by_clock].time, t + SOON),
                replace(self.options, max_seconds=left, max_steps=steps_left),
                start=t,
                first_step=FIRST_STEP * self.phases[-1].course.last_step if self.phases else 0.0,
                outputs=np.concatenate(([t], outputs[outputs > t])),
                progress=progress,
                guarded=Guarding(
                    sizes,
                    partial(self._is_valid, engine, about),
                    [g for g, (what, k) in enumerate(about) if what == "gap" and k in asleep],
                    self.bounded.turning,
                    partial(self._lasts, mode) if is_soft else None,
                ),
            )
            if course.status in (Status.UNREACHABLE, Status.SINGULAR) and self._takes_back(engine, mode):
                continue
            if course.status is Status.UNREACHABLE and again is not None:
                # slips that had nearly stopped go on, and gaps that nothing can close any more stay as they are
                forbidden += [("closed", k, None) for k in self._not_closing(mode, now)]
                result, again = again(forbidden=tuple(forbidden)), None
                self._note(mode, result, t)
                continue
            self.phases.append(PhaseRecord(course, engine, mode))
            near = course.near
            y = engine.state_at(course, -1)
            y[engine.at_work] = course.work[-1]
            self.events += [e for e in course.events if not e.name.startswith("@")]
            blow = self._blow_at_end(course, mode, by_clock)
            if blow is not None:
                n_at_once = n_at_once + 1 if course.t_end <= t else 0
                t, forbidden = course.t_end, []
                trouble = self._strike(blow, y, t, near)
                if trouble:
                    status, message = Status.INCONSISTENT, trouble
                    break
                result = self.transition.after(y, t, near, mode)
                again, asleep = None, result.behind
                self._note(mode, result, t)
                continue
            if course.violated < 0:
                status, message = course.status, course.message
                if status in (Status.STEP_TOO_SMALL, Status.NOT_FINITE) and any(mode.drags):
                    jam = self._jam(mode, course.t_end)
                    if jam:
                        status, message = Status.INCONSISTENT, jam
                break
            what, k = about[course.violated]
            is_progress = course.t_end > t
            n_at_once = 0 if is_progress else n_at_once + 1
            if is_progress:
                forbidden = []
            t = course.t_end
            forbidden += self._excluded(what, k, mode, is_progress=is_progress)
            after = partial(
                self.transition.after,
                y,
                t,
                near,
                mode,
                touched=(k,) if what == "gap" else (),
                left=k if what == "foot" else None,
            )
            has_stopped = what == "slip" and is_progress
            result = after(stopped=(k,) if has_stopped else (), forbidden=tuple(forbidden))
            again = after
            passed = {k} if what == "foot" else set[int]()
            asleep = result.behind | passed | (set[int]() if is_progress else asleep)
            self._note(mode, result, t)
        return self._course(status, message, time.perf_counter() - began)

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

    # -- words --------------------------------------------------------------------------------
    def _note(self, before: ModeOf | None, result: After, t: float) -> None:
        b, names = self.bounded, [b.name for b in self.bounded.barriers]
        if result.status is Consistency.SEVERAL and self.several is None:
            self.several = t
        for impact in result.impacts:
            self.collisions.append(
                Collision(
                    t,
                    {names[k]: x for k, x in impact.impulses.items()},
                    {self.bounded.drags[k].name: x for k, x in impact.friction.items()},
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

    def _not_closing(self, mode: ModeOf, now: ContactInstant) -> list[int]:
        """Closed barriers with a gap beyond round-off."""
        b = self.bounded
        return [k for k in mode.closed if abs(float(now.values[b.barriers[k].place])) > CLOSED * b.numbers.length]

    def _tiny(self, y: Floats) -> float:
        """An energy that is none beside that of the motion."""
        n = self.bounded.free.n_coordinates
        inverse = self.bounded.inverse_mass
        kinetic = np.divide(y[n : 2 * n] ** 2, 2.0 * inverse, out=np.zeros(n), where=inverse > 0.0)
        return NO_ENERGY * float(kinetic.sum())

    def _share(self, engine: Engine, mode: ModeOf, y: Floats, t: float) -> None:
        """Notes the dry friction whose force depends on how reactions that are not unique are shared, and has them
        shared by a rule that no order of the connections changes, as long as nothing would have to pull."""
        b = self.bounded
        engine.share_no_more()  # what an earlier phase of this mode shared, and which contacts carried nothing in it
        engine.evaluate(y, t)
        sets, sizes = engine.open_multipliers()
        if not sets.shape[1]:
            return
        row_of = {place: row for row, place in enumerate(b.held_in(mode))}
        free = {place: sets[row] / sizes[row] for place, row in row_of.items()}
        pressed = [k for k, state in enumerate(mode.drags) if state is not None and b.drags[k].loads]
        found = [
            k
            for k in pressed
            if any(np.abs(free[p]).max() > _FREE / sizes[row_of[p]] for p in b.drags[k].loads if p in free)
        ]
        if not found or not self._matters(engine, mode, free, found):
            return
        self.shared |= dict.fromkeys(b.drags[k].rub.row.connection for k in found)
        if mode in self.stiff:
            return
        engine.share_by_compliance()
        _accelerations, multipliers = engine.evaluate(y, t)
        pushing = {row_of[b.barriers[k].place]: b.barriers[k].sign for k in mode.closed}
        idle = _idle(multipliers, sets / sizes[:, None], 1.0 / engine.scale_of_held, pushing)
        if idle:
            engine.share_no_more()
            engine.evaluate(y, t)
            engine.share_by_compliance(idle)
            self.yielding[mode] = None
        elif idle is None:
            engine.share_no_more()  # no distribution at all would do
            self.is_arbitrary = True
        engine.evaluate(y, t)

    def _takes_back(self, engine: Engine, mode: ModeOf) -> bool:
        """Whether contacts that carry nothing had been let go in a mode: from now on all of them are held again. Where
        such a contact closes by more than round-off nothing else keeps it, and no pose would."""
        if mode not in self.yielding:
            return False
        del self.yielding[mode]
        self.stiff.add(mode)
        engine.share_no_more()
        self.is_arbitrary = True
        return True

    def _matters(self, engine: Engine, mode: ModeOf, free: dict[int, Floats], found: list[int]) -> bool:
        """Whether friction as a whole depends on the sharing: not where all that presses rubs along one line with one
        coefficient."""
        b = self.bounded
        if any(len(b.drags[k].loads) != 1 or not b.drags[k].load_sign for k in found):
            return True
        total: dict[int, Floats] = {}
        for k in found:
            drag, state = b.drags[k], mode.drags[k]
            c = b.numbers.number(drag.rub.coefficient(state or 1, at_rest=not state))
            along = engine.gradient_of(drag.row)
            effect = (state or 1) * c * drag.load_sign * np.outer(along, free[drag.loads[0]])
            total[bool(state)] = total.get(bool(state), np.zeros_like(effect)) + effect
        scale = max(float(np.abs(x).max(initial=0.0)) for x in free.values())
        return any(float(np.abs(x).max(initial=0.0)) > _SLIGHT * scale for x in total.values())

    def _advised(self, trouble: Message) -> str:
        return trouble if self.bounded.numbers.system.space else further(trouble, ADVICE)

    def _contradiction(self, result: After, t: float) -> str:
        if result.status is Outcome.NOT_FOUND:
            return self._advised(
                Message("at t = {t:.9g} s no force was found that is consistent with {what}", t=t, what=result.why)
            )
        if result.why == HELD_ALONE:
            return Message("at t = {t:.9g} s no force is consistent with {what}", t=t, what=result.why)
        return Message(
            "at t = {t:.9g} s no force is consistent with {what}: with so much friction the contact can neither "
            "slide nor hold (Painleve's paradox). A rigid model ends here. Go on with an impulse (option jams), make "
            "the contact compliant with a spring, or lower the friction",
            t=t,
            what=result.why,
        )

    def _jam(self, mode: ModeOf, t: float) -> Message:
        """Sliding friction whose forces grow without bound."""
        return Message(
            "at t = {t:.9g} s the forces of {names} grow without bound: sliding friction jams there (Painleve). A "
            "rigid model ends here. Go on with an impulse (option jams), make the contact compliant with a spring, or "
            "lower the friction",
            t=t,
            names=in_turn([d.name for d, state in zip(self.bounded.drags, mode.drags, strict=True) if state]),
        )

    # -- the result ---------------------------------------------------------------------------
    def _course(self, status: Status, message: str, wall: float) -> Trajectory:
        events = tuple(sorted(self.events, key=lambda e: e.time))
        message = further(*(said for said in (message, *self._remarks()) if said))
        return merged(
            self.bounded, self.phases, status, message, wall, events, tuple(self.collisions), tuple(self.struck)
        )

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
        if self.shared:
            how = [Message("they are shared as if all joints yielded alike, and the motion depends on it")]
            if self.yielding:
                how.append(Message("a contact that would have to pull for that carries nothing"))
            if self.is_arbitrary:
                how.append(Message("where that leaves a contact that pulls or opens, it is by the order of the rows"))
            yield Message(
                "the reactions that press the dry friction of {names} are not unique in a rigid model; {how}",
                names=in_turn(sorted(self.shared)),
                how=further(*how),
            )
        if self.ahead is not None:
            yield Message(
                "rebounds too small to be followed end at t = {t:.6g} s at once, and their friction with them: for "
                "that moment the energy is {energy:.2g} J too high",
                t=self.ahead[0],
                energy=self.ahead[1],
            )
        if self.transition.tied:
            yield Message(
                "of {names}, which are hit equally fast, the first by name is taken first",
                names=in_turn([*self.transition.tied]),
            )
        if self.transition.is_replaced:
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


def _idle(forces: Floats, free: Floats, weights: Floats, pushing: dict[int, int]) -> list[int] | None:
    """Rows that carry nothing in the least forces in which no contact pulls: empty where the least of all are such,
    None where there are none. forces: (n,) the least; free: (n, k) what may be added; weights: (n,) of the rows;
    pushing: the rows of contacts with their signs. A strictly convex problem has one solution, whatever the order of
    the rows."""
    size = float(np.abs(forces).max(initial=0.0))
    rows = list(pushing)
    signs = np.array([pushing[row] for row in rows], dtype=np.float64)
    if not bool((signs * forces[rows] < -ROUND_OFF * size).any()):
        return []
    inverse = np.linalg.inv(np.linalg.qr(weights[:, None] * free, mode="r"))
    among = free @ inverse
    least = least_within(signs[:, None] * among[rows], -signs * forces[rows])
    if least is None:
        return None
    found = forces + among @ least
    return [row for row, sign in zip(rows, signs, strict=True) if sign * found[row] <= ROUND_OFF * size]
