"""A second opinion on phases: the modes integrated in numbers, the loads of sliding frictions solved at every instant.

Accelerations and multipliers are affine in the loads N; one solution without and one for each unit load give all,

    a = a_0 + sum_k N_k (a_k - a_0),        N_i = l_i0 + sum_k N_k (l_ik - l_i0).

It knows the order of the modes, and finds by itself when each ends and by which event.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, evaluate
from freebody.language.sentences import Message
from freebody.model.elements import DryFriction, NonholonomicForm
from freebody.numeric.jets import Array
from freebody.numeric.reference import Reference
from freebody.numeric.snapshot import Snapshot
from freebody.questions.clock import Clock
from freebody.questions.event import AskedEvent, Peak
from freebody.study.answering.witness import TOUCH
from freebody.study.phases.looks import Watched, Watcher, begins_in, looked_at, zero_in
from freebody.study.phases.phase import Phase, without_rows
from freebody.study.phases.reached import STRIKES
from freebody.study.phases.slopes import slope_of
from freebody.study.phases.turned_along import TurnedAlong
from freebody.symbolic.phases.friction import named_rows
from freebody.system.modes import ContactMode, across_the_way, ideal_bounds, in_mode, straightened
from freebody.system.system import System
from freebody.tolerances import ROUND_OFF

_STILL = 1e-9  # [SI] of what is watched: rounding and the steps before leave this of a zero
_STAGES, _NEWTON = 4, 50  # of the way from no friction to all of it, and steps in each
_STRAIGHT = 1e-7  # of a slip: what it may have aside of its direction
_PLACES = (
    "touches",
    "is reached",
    STRIKES,
)  # events of places, which a motion may pass and come back from between two looks


@dataclass(frozen=True)
class PhaseSnapshot:
    """The state at the end of a phase: by which event, when, and the instant in the mode that ends."""

    event: tuple[str, str, int] | None  # kind, name, direction
    time: float
    mode: NumericMode
    q: Array
    v: Array
    begin: Snapshot  # the start of the phase
    together: tuple[tuple[str, str, int], ...] = ()  # all events at that instant
    looks: tuple[Snapshot, ...] = ()  # on the way

    def snapshot(self) -> Snapshot:
        return self.mode.snapshot(self.q, self.v, self.time, (self.begin, *self.looks)[-1])


@dataclass(frozen=True)
class FollowedPhase:
    """A phase to be followed. touching: what touches at the start of the motion, where more does in the phase. hits:
    what collides when it begins; blow: what happens in mid-motion before that; kept: what keeps touching
    in that, and for the first phase what does so up to the start, where it opens."""

    phase: Phase
    touching: frozenset[str] | None = None
    hits: tuple[str, ...] = ()
    kept: frozenset[str] = frozenset()
    blow: str = ""


class NumericMode:
    """One mode of a system at given parameter values."""

    def __init__(self, base: System, stage: FollowedPhase, values: Mapping[str, float]) -> None:
        phase = stage.phase
        in_planes = {rub.name: rub for rub in base.dry_friction}
        self.aside = {name: across_the_way(in_planes[name], way) for name, way in phase.mode.ways}
        base = straightened(base, phase.mode)
        self.base, self.mode, self.stage = base, phase.mode, stage
        system, self.loads = in_mode(base, phase.mode)
        self.system = without_rows(system, phase.shared)
        self.shared = phase.shared
        self.values = {n: v for n, v in values.items() if n in base.parameters}
        self.rows = named_rows(self.system)
        units = [dict.fromkeys(self.loads, 0.0) | ({} if one is None else {one: 1.0}) for one in (None, *self.loads)]
        self.references = [self._reference(u) for u in units]
        self._last: tuple[Any, list[Snapshot]] | None = None
        self.near: Snapshot | None = None  # an instant from which angles of lines are counted on; None: from the start
        self.bounds = {b.name: b for b in base.bounds}
        self.at_gap = {**base.borders, **{b.name: b.row for b in base.bounds}}
        self.dry_friction = {r.name: r for r in base.dry_friction}

    def _reference(self, loads: Mapping[str, float]) -> Reference:
        reference = Reference(self.system, {**self.values, **loads})
        # from the start pose measures count of which only changes mean something
        if self.stage.touching is None:
            reference.assemble()
        else:
            reference.count_from(*self._start)
        return reference

    @cached_property
    def _start(self) -> tuple[Reference, Array]:
        """The start of the model, where the mode does not hold yet."""
        assert self.stage.touching is not None
        reference = Reference(in_mode(self.base, ContactMode.of(self.stage.touching, {}))[0], self.values)
        return reference, reference.assemble()

    def start(self) -> tuple[Array, Array]:
        """The start of the model in this mode."""
        q = self.references[0].assemble()
        return q, self.references[0].velocities(q)

    # -- dynamics ---------------------------------------------------------------------------------
    def solved(self, q: Array, v: Array, t: float) -> dict[str, float]:
        """The loads of the sliding frictions. Guides are pressed on the side on which that is not negative; where both
        are such, on that to which the loads come steadily as friction grows from nothing, det(1 - B) > 0. A contact has
        one side, and a negative load says that it has opened."""
        if not self.loads:
            return {}
        seen = self._seen(q, v, t)
        if any(len(rub.load) > 1 for rub in self.loads.values()):
            return dict(zip(self.loads, self._resultants(seen).tolist(), strict=True))
        n = len(self.loads)
        table = np.array([[self._size(rub, s) for s in seen] for rub in self.loads.values()])
        is_guide = np.array([not rub.of for rub in self.loads.values()])
        jammed: dict[str, float] | None = None
        for signs in _signs(table[:, 0], is_guide):
            a = signs * table[:, 0]
            B = signs[:, None] * (table[:, 1:] - table[:, :1])
            N = np.linalg.solve(np.eye(n) - B, a)
            if float(N[is_guide].min(initial=0.0)) >= -_STILL * max(1.0, float(np.abs(N).max())):
                found = dict(zip(self.loads, N.tolist(), strict=True))
                if float(np.linalg.det(np.eye(n) - B)) > 0.0:
                    return found
                jammed = jammed or found
        if jammed is None:
            raise CannotAnswer(Message("no friction force is consistent with the motion"))
        return jammed

    def _seen(self, q: Array, v: Array, t: float) -> list[Snapshot]:
        """One instant without loads and with each unit load; the last one is kept, since everything asks for it."""
        key = (t, q.tobytes(), v.tobytes())
        if self._last is None or self._last[0] != key:
            first = self.looked(q, v, t)
            more = [Snapshot(r, first.geometry, q, v, t) for r in self.references[1:]]  # loads move nothing
            self._last = key, [first, *more]
        return self._last[1]

    def multiplier(self, name: str, q: Array, v: Array, t: float) -> float:
        """Of a row, with the loads of the sliding frictions."""
        found = [s.multiplier(self.rows[name]) for s in self._seen(q, v, t)]
        N = self.solved(q, v, t)
        return found[0] + sum(value * (one - found[0]) for value, one in zip(N.values(), found[1:], strict=True))

    def _resultants(self, seen: Sequence[Snapshot]) -> Array:
        """The loads where some are resultants: N_i = |a_i + s B_i N| by Newton's method, from s = 0, where friction
        changes nothing, to s = 1. What has a bound of its own is pressed on one side, N_i = a_i + s B_i N."""
        rubs, n = list(self.loads.values()), len(self.loads)
        parts = [np.array([self._parts(rub, s) for s in seen]) for rub in rubs]  # (1 + n, components) each
        N = np.array([self._whole(rub, p[0])[0] for rub, p in zip(rubs, parts, strict=True)])
        for s in np.linspace(1.0 / _STAGES, 1.0, _STAGES):
            for _ in range(_NEWTON):
                F, slopes = N.copy(), np.eye(n)
                for i, (rub, p) in enumerate(zip(rubs, parts, strict=True)):
                    B = s * (p[1:] - p[0])
                    size, along = self._whole(rub, p[0] + N @ B)
                    F[i] -= size
                    slopes[i] -= B @ along
                step = np.linalg.solve(slopes, F)
                N = N - step
                if float(np.abs(step).max()) <= ROUND_OFF * max(1.0, float(np.abs(N).max())):
                    break
            else:
                raise CannotAnswer(Message("no friction force is consistent with the motion"))
        return np.asarray(N, dtype=np.float64)

    @staticmethod
    def _whole(rub: DryFriction, parts: Array) -> tuple[float, Array]:
        """What presses a friction, by its components, and its slopes by these."""
        if rub.of:
            return float(parts[0]), np.ones(1)
        size = float(np.linalg.norm(parts))
        return size, parts / size if size > 0.0 else np.zeros(len(parts))

    def _parts(self, rub: DryFriction, s: Snapshot) -> list[float]:
        return [self.rows[name].sign * s.multiplier(self.rows[name]) for name in rub.load]

    def _size(self, rub: DryFriction, s: Snapshot) -> float:
        return self._parts(rub, s)[0]

    def accelerations(self, q: Array, v: Array, t: float) -> Array:
        N = self.solved(q, v, t)
        found = [s.accelerations for s in self._seen(q, v, t)]
        total = found[0].copy()
        for value, one in zip(N.values(), found[1:], strict=True):
            total += value * (one - found[0])
        return total

    def snapshot(self, q: Array, v: Array, t: float, near: Snapshot | None = None) -> Snapshot:
        """The instant with the loads put in. near: an instant from which angles count on, otherwise the last one."""
        if not self.loads:
            return self.looked(q, v, t, near)
        return self._reference(self.solved(q, v, t)).snapshot(q, v, t, near or self.near)

    def looked(self, q: Array, v: Array, t: float, near: Snapshot | None = None) -> Snapshot:
        """The instant without the loads."""
        return self.references[0].snapshot(q, v, t, near or self.near)

    def goes_on(self, q: Array, v: Array, t: float) -> Snapshot:
        """An instant of a motion, half a turn of any line from the last at most: angles count on from it."""
        self.near = self.looked(q, v, t).counted_on()
        return self.near

    # -- what ends it -----------------------------------------------------------------------------
    def watches(self) -> list[tuple[tuple[str, str, int], Watcher]]:
        """What must stay positive, by the event that its zero is."""
        found: list[tuple[tuple[str, str, int], Watcher]] = []
        unilateral = [r.name for r in self.base.constraint_rows if r.unilateral]
        for name in [*unilateral, *self.bounds]:
            if name in self.mode.closed:
                found.append((("opens", name, 0), lambda q, v, t, n=name: self.normal(n, q, v, t)))
                if name in self.bounds and self.bounds[name].within:
                    found.append((("edge ends", name, 0), lambda q, v, t, n=name: self.on_edge(n, q, v, t)))
            elif name in self.bounds or name in self.stage.phase.closing_again:
                found.append((("touches", name, 0), lambda q, v, t, n=name: self.gap(n, q, v, t)))
        for name, acts in self.mode.acting:
            kind, side = ("opens", -1.0) if acts else ("touches", 1.0)
            found.append(((kind, name, 0), lambda q, v, t, n=name, s=side: s * self.gap(n, q, v, t)))
        for name, state in self.mode.states.items():
            if state:
                found.append((("slip ends", name, 0), lambda q, v, t, n=name, s=state: s * self.slip(n, q, v, t)))
            elif not any(name in others for others in self.shared.values()):
                for way in (1, -1) if self.dry_friction[name].across is None else (1,):
                    found.append((("slips", name, way), lambda q, v, t, n=name, w=way: self.reserve(n, w, q, v, t)))
        return found

    def normal(self, name: str, q: Array, v: Array, t: float) -> float:
        return self.rows[name].sign * self.multiplier(name, q, v, t)

    def gap(self, name: str, q: Array, v: Array, t: float) -> float:
        reference, again = self.references[0], name not in self.at_gap
        row = self.stage.phase.closing_again[name] if again else self.at_gap[name]
        if again and self.base_target(name) is None:
            target = self.lengths[name]
        else:
            target = 0.0 if row.target is None else reference.number(row.target, t)
        return row.sign * (self.looked(q, v, t).value(row.measure) - target)  # pyrefly: ignore[bad-argument-type]

    def base_target(self, name: str) -> Expr | None:
        """What an ideal connection is held at; None for the length that it has at the start of the motion."""
        return next(row.target for row in ideal_bounds(self.base) if row.name == name)

    @cached_property
    def lengths(self) -> dict[str, float]:
        """Of what is slack and may come taut again: as it is when the motion begins."""
        touching = self.mode.closed if self.stage.touching is None else self.stage.touching
        reference = Reference(in_mode(self.base, ContactMode.of(touching, {}))[0], self.values)
        q = reference.assemble()
        begin = reference.snapshot(q, np.zeros_like(q), 0.0)
        again = self.stage.phase.closing_again.items()
        return {n: begin.value(row.measure) for n, row in again if not isinstance(row.measure, NonholonomicForm)}

    def on_edge(self, name: str, q: Array, v: Array, t: float) -> float:
        """How far the place of a bound is from the nearer end of its edge; spans that are none count as long."""
        now, reference = self.looked(q, v, t), self.references[0]
        if name not in self.bounds:
            return np.inf
        found = [np.inf]
        for span in self.bounds[name].within:
            value = now.value(span.measure)
            found += [] if span.low is None else [value - reference.number(span.low, t)]
            found += [] if span.high is None else [reference.number(span.high, t) - value]
        return min((x for x in found if abs(x) > _STILL), default=np.inf)

    def _exists(self, event: tuple[str, str, int], q: Array, v: Array, t: float) -> bool:
        """Whether what closes is within its edge."""
        return event[0] != "touches" or self.on_edge(event[1], q, v, t) > 0.0

    def slip(self, name: str, q: Array, v: Array, t: float) -> float:
        now = self._seen(q, v, t)[0]
        found = now.rate(self.dry_friction[name].row.measure)
        if name in self.aside and abs(now.rate(self.aside[name])) > _STRAIGHT * max(1.0, abs(found)):
            raise CannotAnswer(
                Message("the slip of {contact} turns, and its friction with it", contact=name.partition(".")[0])
            )
        return found

    def reserve(self, name: str, way: int, q: Array, v: Array, t: float) -> float:
        limit = 0.0
        if (across := self.dry_friction[name].across) is not None:
            forces = [self.multiplier(n, q, v, t) for n in (name, across.name)]
            (pressing,) = self.dry_friction[name].load
            load = abs(self.multiplier(pressing, q, v, t))
            return self.coefficient(self.dry_friction[name], 1, self._seen(q, v, t)[0]) * load - math.hypot(*forces)
        for rub in (self.dry_friction[name], *(self.dry_friction[other] for other in self.shared.get(name, ()))):
            load = float(np.hypot.reduce([self.multiplier(n, q, v, t) for n in rub.load])) if rub.load else 1.0
            limit += self.coefficient(rub, way, self._seen(q, v, t)[0]) * load
        return limit + way * self.multiplier(name, q, v, t)

    def coefficient(self, rub: DryFriction, way: int, now: Snapshot) -> float:
        values: dict[str, float] = {**self.values, "t": now.t}
        for name, measure in rub.measures:
            values[name], values[f"rate({name})"] = now.value(measure), now.rate(measure)
        return float(evaluate(rub.coefficient(way, at_rest=True), values))

    def _distance(self, asked: AskedEvent, begin: Snapshot) -> Watched:
        """How far a measure is from its value, or the clock from an instant, positive at the beginning."""
        reference = self.references[0]
        if isinstance(asked, Clock):
            end = math.inf if asked.time is None else reference.number(asked.time)
            return Watched(lambda _q, _v, t: end - t)
        target = reference.number(asked.value)

        if isinstance(asked, Peak):
            return Watched(slope_of(self, asked.quantity, begin))

        def gap(s: Snapshot) -> float:
            return (s.rate(asked.measure) if asked.order else s.value(asked.measure)) - target

        driven = self.snapshot(begin.q, begin.v, begin.t)  # by friction as well
        rate = driven.acceleration(asked.measure) if asked.order else begin.rate(asked.measure)
        sign = -1.0 if (gap(begin) < 0 if abs(gap(begin)) > _STILL else rate < 0) else 1.0
        distance: Watcher = lambda q, v, t: sign * gap(self.looked(q, v, t))  # noqa: E731
        if asked.order:
            return Watched(distance)
        size = max(abs(target), reference.sizes.length ** float(asked.measure.dimension.length))
        return Watched(distance, True, lambda q, v, t: sign * self.looked(q, v, t).rate(asked.measure), TOUCH * size)

    # -- motion -----------------------------------------------------------------------------------
    @cached_property
    def _along(self) -> TurnedAlong:
        return TurnedAlong(self.references[0], self.base.unfollowed)

    def _turned(self, y: Array, t: float, turns: Array) -> tuple[Array, Array]:
        """A state with its balls turned, in which it is accelerated as without."""
        n = len(y) // 2
        q, v = self._along.turned(y[:n], y[n:], turns)
        if len(turns):
            self._along.check(self.accelerations(y[:n], y[n:], t), self.accelerations(q, v, t), turns)
        return q, v

    def run(self, q: Array, v: Array, start: float, until: float, asked: AskedEvent | None = None) -> PhaseSnapshot:
        """To the first event, or until a time. asked: a measure that reaches a value, as a further event."""
        n, along = len(q), self._along
        turns = along.at_first()
        begin = self.goes_on(q, v, start)
        events = [(event, Watched(watch, may_pass=event[0] in _PLACES)) for event, watch in self.watches()]
        for blow in self.base.blows:
            if blow.name not in self.mode.past:
                events.append(((STRIKES, blow.name, 0), self._distance(blow.event, begin)))
        if asked is not None:
            events.append((("is reached", asked.text, 0), self._distance(asked, begin)))

        def derivative(t: float, y: Array) -> Array:
            slope = along.without(self.references[0].frame.slope(y[:n], y[n:]))
            return np.concatenate([slope, self.accelerations(y[:n], y[n:], t)])

        looks: list[Snapshot] = []
        armed = np.array([watched(q, v, start) for _event, watched in events]) > _STILL
        for a, b, state in looked_at(derivative, np.concatenate([q, v]), start, until):
            y = state(b)
            now = np.array([watched(y[:n], y[n:], b) for _event, watched in events])
            roots: list[tuple[float, int]] = []
            for k, begun in begins_in([w for _e, w in events], armed, now, state, n, a, b, _STILL).items():
                event, watched = events[k]
                if (root := zero_in(watched, state, n, begun, b, is_below=bool(now[k] < 0.0))) is None:
                    continue
                armed[k] = False
                there = state(root)
                roots += [(root, k)] if self._exists(event, there[:n], there[n:], root) else []
            if roots:
                first = min(root for root, _k in roots)
                at_once = [r for r in roots if r[0] <= first + ROUND_OFF * abs(first)]
                time, k = max(at_once, key=lambda r: r[1])
                q, v = self._turned(state(time), time, along.on(turns, state, a, time))
                together = tuple(events[other][0] for _time, other in at_once)
                return PhaseSnapshot(events[k][0], time, self, q, v, begin, together, tuple(looks))
            armed |= now > _STILL
            turns = along.on(turns, state, a, b)
            q, v = self._turned(y, b, turns)
            looks.append(self.goes_on(q, v, b))
        return PhaseSnapshot(None, until, self, q, v, begin, (), tuple(looks))


def _signs(first: Array, is_guide: NDArray[np.bool_]) -> Sequence[Array]:
    """Bounds push; a guide may be pressed on either side."""
    own = np.where(is_guide & (first < 0), -1.0, 1.0)
    return [np.ones_like(own), own, np.where(is_guide, -own, 1.0)]
