"""A system with unilateral constraints and dry friction, packed into arrays once for all of its contact modes.

`instant` gives the dense matrices of a state, from which contact problems are made (`problem`); `engine` gives the
integrator of one mode: closed contacts and sticking friction as constraints, sliding friction as a load, and guards for
the inequalities that the mode needs.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np

from freebody.language.units import DIMENSIONLESS, LENGTH
from freebody.measures.base import Measure
from freebody.measures.distance import Distance
from freebody.measures.turned import carriers
from freebody.model.elements import ConstraintRow, DryFriction, NonholonomicForm, RimPivot, UnilateralConstraint
from freebody.numeric.contact.ends import FlatEnds
from freebody.numeric.contact.problem import ContactProblem, FrictionProblemRow
from freebody.numeric.contact.rows import (
    BlowRow,
    ContactInstant,
    FrictionRow,
    ModeOf,
    RowProblem,
    UnilateralRow,
    insist_on_few_places,
    within,
)
from freebody.numeric.engine.engine import Engine
from freebody.numeric.engine.evaluator import EngineRows, EngineWatch, packed
from freebody.numeric.engine.writing import OF_MULTIPLIER, OF_RATE, OF_RESERVE, OF_SHARE, OF_VALUE, ArrayBuilder, Guard
from freebody.numeric.kernels import kinematics, stepping
from freebody.numeric.kernels.arrays import Floats
from freebody.numeric.numbers import Numbers
from freebody.questions.clock import Clock
from freebody.system.blows import BlowEvent
from freebody.system.description import SystemDescription

LENT = 1e-6  # part of the mass lent to massless bodies that they keep in contact problems
_SAME_SLIP = 1e-11  # relative, of gradients: drags along one line slip together
_SPIN = "@spin of "
SPINS = 1e-6  # [rad/s] a flat end that turns faster about the normal spins
TOUCHING = 1e-10  # gaps below this part of the system's size are none; so far a foot may be beyond the end of its edge


class Bounded:
    """All rows of a system, its barriers and drags."""

    def __init__(
        self, numbers: Numbers, watches: Sequence[EngineWatch] = (), tracked: Sequence[Measure | NonholonomicForm] = ()
    ) -> None:
        system = numbers.system
        insist_on_few_places(system)
        self.numbers, self.watches, self.tracked = numbers, tuple(watches), tuple(tracked)
        pivots = {bound.name: bound.pivot for bound in system.bounds if bound.pivot is not None}
        self.n_rows = len(system.rows)  # those after it are of pivots
        self.rows = (*system.rows, *(row for pivot in pivots.values() for row in _rows_of(pivot)))
        places = {row.name: k for k, row in enumerate(self.rows)}
        ideal = [UnilateralConstraint(row) for row in system.constraint_rows if row.unilateral]
        self._packing = packed(numbers, watches, tracked)
        self._enter(system, ideal, places)
        self.written = ArrayBuilder(self._packing)
        self.blows = [self._blow(blow, places) for blow in system.blows]
        self.past = frozenset[int]()  # the blows that have happened in the motion under way
        self.bilateral = tuple(k for k, row in enumerate(system.constraint_rows) if not (row.unilateral or row.needs))
        # in the order of their names: where several outcomes are alike, none in the file chooses one
        bounds = sorted([*ideal, *system.bounds, *(p.bound for p in pivots.values())], key=lambda bound: bound.name)
        grips = {bound.name: _grips(system, bound) for bound in ideal}
        self.barriers = [self._barrier(b, places[b.name], grips.get(b.name, ()), b in ideal) for b in bounds]
        self.drags = self._drags((*system.dry_friction, *(r for p in pivots.values() for r in p.dry_friction)), places)
        self.ends = FlatEnds(self, pivots)
        self._engines: dict[ModeOf, tuple[Engine, tuple[Guard, ...], list[tuple[str, int]]]] = {}

    def _enter(
        self, system: SystemDescription, ideal: Sequence[UnilateralConstraint], places: Mapping[str, int]
    ) -> None:
        """What may be held or pressed, and what is watched for it, is entered in the packing."""
        packing = self._packing
        for bound in ideal:
            packing.watched.append(packing.held[places[bound.name]].where)
        for bound in system.bounds:
            packing.bound(bound)
        for rub in system.dry_friction:
            loads = tuple(places[name] for name in rub.load)
            packing.friction(rub, loads, self._load_sign(loads))
        for blow in system.blows:
            if not isinstance(blow.event, Clock):
                packing.watch(blow.event.measure)
            for row in blow.rows:
                packing.closing(row)
        for bound in system.bounds:
            if bound.pivot is not None:
                self._enter_pivot(bound.pivot, places)

    def _enter_pivot(self, pivot: RimPivot, places: Mapping[str, int]) -> None:
        packing = self._packing
        for measure in pivot.settings:
            packing.setting(measure)
        packing.bound(pivot.bound)
        for rub in pivot.dry_friction:
            loads = tuple(places[name] for name in rub.load)
            packing.friction(rub, loads, self._load_sign(loads))
        for measure in (*pivot.lowest, *pivot.along[0], *pivot.along[1]):
            packing.watch(measure)

    def _drags(self, dry_friction: Sequence[DryFriction], places: Mapping[str, int]) -> list[FrictionRow]:
        """Dry friction in the order of its names, each with the barrier without which there is none."""
        number = {barrier.name: k for k, barrier in enumerate(self.barriers)}
        return [
            FrictionRow(
                rub.name,
                (rub.row.ends[0], rub.row.ends[1]) if len(rub.row.ends) > 1 else (rub.row.connection, ""),
                self.written.row_of_friction(k),
                places[rub.name],
                number.get(rub.of, -1),
                self._packing.dry_friction[k].loads,
                self._packing.dry_friction[k].sign,
                rub,
                k,
                self.written.across_of_friction(k),
                self._packing.dry_friction[k].keeps_across,
            )
            for k, rub in sorted(enumerate(dry_friction), key=lambda numbered: numbered[1].name)
        ]

    def _blow(self, blow: BlowEvent, places: Mapping[str, int]) -> BlowRow:
        own = tuple(places[row.name] for row in blow.rows)
        counted = [
            (place, self.written.rows[row.measure])
            for place, row in zip(own, blow.rows, strict=True)
            if not isinstance(row.measure, NonholonomicForm) and row.target is None and row.measure.incremental
        ]
        event, number = blow.event, self.numbers.number
        if isinstance(event, Clock):
            time = np.inf if event.time is None else number(event.time)
            return BlowRow(blow.name, own, tuple(counted), time, None)
        value = number(event.value)
        length = self.numbers.length if event.measure.dimension == LENGTH else 1.0
        size = max(abs(value), 1.0 if event.order else length)
        watch = EngineWatch(f"@{blow.name}", event.measure, event.order, value, is_terminal=True, size=size)
        return BlowRow(blow.name, own, tuple(counted), np.inf, watch)

    def hold_past(self, names: Collection[str]) -> None:
        """What closes in blows that have happened is held from now on."""
        self.past = frozenset(k for k, blow in enumerate(self.blows) if blow.name in names)

    def close(self, k: int, y: Floats, t: float, near: Floats) -> None:
        """A blow happens in a state: what is held where it is then is held there."""
        self.instant(y, t, near)
        for place, row in self.blows[k].keeps:
            self.written.keep_at(place, float(self.free.room.rows[row, kinematics.VALUE]))
        self.past |= {k}

    @property
    def always(self) -> tuple[int, ...]:
        """Places of the rows that are held whatever touches: bilateral ones, and what has closed."""
        return (*self.bilateral, *(place for k in sorted(self.past) for place in self.blows[k].places))

    def _load_sign(self, loads: tuple[int, ...]) -> int:
        """The sign with which a single row presses; 0: by its size."""
        row = self.rows[loads[0]] if len(loads) == 1 else None
        return row.sign if row is not None and row.unilateral else 0

    def _barrier(
        self, bound: UnilateralConstraint, place: int, grips: tuple[int, ...], is_ideal: bool
    ) -> UnilateralRow:
        # what it is, and what events call its two sides
        number, row = self.numbers.number, bound.row
        kind = "string" if row.reaction == "tension" else "stop" if bound.is_stop else "contact"
        ends = (
            (row.ends[0], row.ends[1]) if kind == "contact" and len(row.ends) > 1 else (row.connection, row.component)
        )
        if kind == "string" and row.component != "length":
            ends = (f"{row.connection} ({row.component})", "")
        if kind == "contact" and is_ideal:
            bodies = list(dict.fromkeys(row.measure.bodies()))
            ends = (bodies[0], bodies[1] if len(bodies) > 1 else row.connection)
        # the edge on which it counts, longer by round-off at both ends
        own = [TOUCHING * (self.numbers.length if s.measure.dimension == LENGTH else 1.0) for s in bound.within]
        return UnilateralRow(
            bound.name,
            ends,
            kind,
            place,
            self.written.row_of_held(place),
            row.sign,
            number(bound.restitution),
            tuple(
                (
                    self.written.rows[span.measure],
                    -np.inf if span.low is None else number(span.low) - tolerance,
                    np.inf if span.high is None else number(span.high) + tolerance,
                )
                for span, tolerance in zip(bound.within, own, strict=True)
            ),
            bound.family or bound.name,
            bound.obstacle,
            bound,
            is_ideal,
            grips,
            number(row.target) if kind == "contact" and isinstance(row.measure, Distance) and row.target else np.nan,
            -1 if bound.lost is None else self.written.rows[bound.lost],
            -1 if bound.spinning is None else self.written.rows[bound.spinning],
        )

    @property
    def n_bodies(self) -> int:
        return self._packing.n_bodies

    @cached_property
    def turning(self) -> tuple[int, ...]:
        """The bodies whose turning moves a gap: those with a point beside the mass centre or a direction in one."""
        names = {name for barrier in self.barriers for name in carriers(barrier.bound.row.measure)}
        return tuple(k for k, body in enumerate(self.numbers.system.all_moving) if body.name in names)

    # -- engines ------------------------------------------------------------------------------
    @cached_property
    def free(self) -> Engine:
        """The system with its bilateral rows only."""
        return Engine(self.numbers, self.watches, self.tracked, EngineRows(self.written, self.bilateral, (), ()))

    def held_in(self, mode: ModeOf) -> tuple[int, ...]:
        """Places of the rows that are held in a mode."""
        places = {*self.bilateral, *(place for k in mode.past for place in self.blows[k].places)}
        for k in mode.closed:
            places.add(self.barriers[k].place)
            places.update(self.barriers[k].grips)
        followers = mode.followers
        sticking = [self.drags[k] for k, state in enumerate(mode.drags) if state == 0 and k not in followers]
        places.update(drag.keeps for drag in sticking)
        places.update(drag.keeps_across for drag in sticking if drag.across >= 0)
        return tuple(sorted(places))

    def engine(self, mode: ModeOf) -> tuple[Engine, tuple[Guard, ...], list[tuple[str, int]]]:
        """The engine of a mode, its guards, and what each of them guards: ("gap", barrier), ("press", barrier),
        ("foot", barrier), ("tilt", barrier), ("slip", drag), ("grip", drag). Slip in a plane is pointed before each
        phase (`point`)."""
        mode = replace(mode, ways=())
        if mode not in self._engines:
            guards: list[Guard] = []
            about: list[tuple[str, int]] = []
            for k, barrier in enumerate(self.barriers):
                # an open contact: its gap; a closed one: its force, and that it stays within the ends of its edge
                if k not in mode.closed:
                    if k in self.ends.by_edge:
                        continue  # a pivot is put, and never met
                    guards.append(Guard(OF_VALUE, barrier.row, sign=barrier.sign))
                    about.append(("gap", k))
                    continue
                guards.append(Guard(OF_MULTIPLIER, barrier.place, sign=barrier.sign))
                about.append(("press", k))
                for row, low, high in barrier.within:
                    for sign, limit in ((1.0, low), (-1.0, high)):
                        if np.isfinite(limit):
                            guards.append(Guard(OF_VALUE, row, sign=sign, offset=limit))
                            about.append(("foot", k))
                if barrier.lost >= 0:
                    guards.append(Guard(OF_VALUE, barrier.lost))
                    about.append(("foot", k))
                if k in self.ends.by_edge:  # until the rim has a lowest place of its own
                    rim = self.barriers[self.ends.by_edge[k].rim]
                    guards.append(Guard(OF_VALUE, rim.lost, sign=-1.0))
                    about.append(("tilt", k))
            for k, state in enumerate(mode.drags):
                # sticking friction: what is left of its limit, shared in a group; sliding friction: its slip rate
                if state == 0 and k not in mode.followers:
                    group = next((group for group in mode.groups if group[0] == k), (k,))
                    guards.append(Guard(OF_RESERVE, friction=self.drags[k].packed, n_shares=len(group) - 1))
                    guards += (Guard(OF_SHARE, friction=self.drags[other].packed) for other in group[1:])
                    about += [("grip", other) for other in group]
                elif state == 0:
                    continue
                elif state is not None:
                    guards.append(Guard(OF_RATE, self.drags[k].row, sign=float(state), row_across=self.drags[k].across))
                    about.append(("slip", k))
            sliding = tuple((drag.packed, state) for drag, state in zip(self.drags, mode.drags, strict=True) if state)
            rows = EngineRows(self.written, self.held_in(mode), sliding, tuple(guards))
            to_come = [b.watch for k, b in enumerate(self.blows) if k not in mode.past and b.watch is not None]
            spins = [watch for k in sorted(mode.closed) for watch in _spin_watches(k, self.barriers[k].bound)]
            engine = Engine(self.numbers, (*self.watches, *to_come, *spins), self.tracked, rows)
            self._engines[mode] = engine, tuple(guards), about
        return self._engines[mode]

    def point(self, mode: ModeOf, small: float) -> None:
        """The engine of a mode gets the directions in which it slides in planes. small: the speed [m/s] below which a
        slip has the direction that is known of it."""
        engine, _guards, about = self.engine(mode)
        for k, angle in mode.ways:
            drag = self.drags[k]
            small_of = small / self.numbers.length if self.is_angle(drag.rub.row) else small
            rows = {drag.row: math.cos(angle), drag.across: math.sin(angle)}
            engine.point(rows, small_of, about.index(("slip", k)))

    # -- instants -----------------------------------------------------------------------------
    def instant(self, y: Floats, t: float, near: Floats) -> ContactInstant:
        """Everything about a state that contact problems need."""
        e = self.free
        e.count_from(near)
        stepping.visit(e.layout, e.room, e.idle, -1.0, y.copy(), t, np.zeros(e.n_y), 1)
        n = e.n_coordinates
        rows = [self.written.row_of_held(k) for k in range(len(self.rows))]
        gradients = np.zeros((len(rows), n))
        at, entries = self._entries
        np.add.at(gradients.ravel(), at, e.room.gradient[entries])
        table = e.room.rows
        v = y[n : 2 * n]
        drifts = table[rows, kinematics.DRIFT] if rows else np.zeros(0)
        goals = self._goals(t)
        return ContactInstant(
            y,
            t,
            gradients,
            table[rows, kinematics.VALUE].copy() if rows else np.zeros(0),
            gradients @ v + drifts - goals[:, 1],
            (table[rows, kinematics.BIAS].copy() if rows else np.zeros(0)) - goals[:, 2],
            e.room.force.copy(),
        )

    @cached_property
    def _entries(self) -> tuple[Any, Any]:
        """Where the entries of the rows stand in the matrix of their gradients, and in the engine's room."""
        layout = self.free.layout
        n = self.free.n_coordinates
        at: list[int] = []
        entries: list[int] = []
        for k in range(len(self.rows)):
            row = self.written.row_of_held(k)
            for body, o in layout.slots[layout.slot_ptr[row] : layout.slot_ptr[row + 1]].tolist():
                at += [n * k + 3 * body + j for j in range(3)]
                entries += [o + j for j in range(3)]
        return np.array(at, dtype=np.intp), np.array(entries, dtype=np.intp)

    def _goals(self, t: float) -> Floats:
        """(n_rows, 3) targets of the bilateral rows that move, and their rates, as of the instant looked at."""
        e = self.free
        goals = np.zeros((len(self.rows), 3))
        for k, place in zip(self.bilateral, e.place_of, strict=True):
            if e.layout.held[place, 1] >= 0:
                goals[k] = e.room.held[place, :3]
                if not e.layout.held[place, 2]:  # a target of velocities
                    goals[k] = 0.0, goals[k, 0], goals[k, 1]
        return goals

    @cached_property
    def inverse_mass(self) -> Floats:
        """(n,) by coordinate; bodies without mass keep a small one."""
        layout = self.free.layout
        lent = layout.mass_gap > 0.0
        return np.where(lent, layout.inverse_mass / LENT, layout.inverse_mass)

    def grouped(self, mode: ModeOf, now: ContactInstant) -> ModeOf:
        """The mode with drags that stick along the same slip grouped: two corners of a block on one line."""
        groups: list[list[int]] = []
        for k, state in enumerate(mode.drags):
            if state != 0:
                continue
            row = now.gradients[self.drags[k].keeps]
            if self.drags[k].across >= 0:
                continue
            for group in groups:
                if np.abs(now.gradients[self.drags[group[0]].keeps] - row).max() <= _SAME_SLIP * np.abs(row).max():
                    group.append(k)
                    break
            else:
                groups.append([k])
        return replace(mode, groups=tuple(tuple(group) for group in groups if len(group) > 1))

    def values(self) -> Floats:
        """(n_rows,) of all measures at the instant that `free` looked at last."""
        return self.free.room.rows[:, kinematics.VALUE]

    def is_valid(self, k: int) -> bool:
        """Whether a barrier exists at the instant that `free` looked at last: a foot is on its edge."""
        return within(self.barriers[k], self.free.room.rows)

    def spread_out(self, closed: Iterable[int]) -> UnilateralConstraint | None:
        """Of closed contacts at the same instant one that is not in a single place."""
        rows = self.free.room.rows
        several = (self.barriers[k] for k in closed if k not in self.ends.by_rim)
        lost = (b for b in several if b.lost >= 0 and rows[b.lost, kinematics.VALUE] <= TOUCHING)
        return next((barrier.bound for barrier in lost), None)

    def is_flattened(self, rim: int, y: Floats, t: float, near: Floats) -> bool:
        """Whether a rim has no lowest place of its own any more."""
        self.instant(y, t, near)
        return bool(self.free.room.rows[self.barriers[rim].lost, kinematics.VALUE] <= TOUCHING)

    def spinning(self, closed: Iterable[int], *, by: str = "") -> UnilateralConstraint | None:
        """Of closed contacts at the same instant a rough flat end that spins, or the one whose watch is named."""
        if by:
            return next((b.bound for k, b in enumerate(self.barriers) if by == f"{_SPIN}{k}"), None)
        rows = self.free.room.rows
        spins = (b for k in closed if (b := self.barriers[k]).spinning >= 0)
        return next((b.bound for b in spins if abs(rows[b.spinning, kinematics.RATE]) > SPINS), None)

    def problem(
        self, now: ContactInstant, closed: Sequence[int], drags: dict[int, int], *, of_rates: bool
    ) -> RowProblem:
        """The contact problem of a set of barriers and of drags (with the sign of their slip rate): in accelerations,
        or in rates."""
        held = [*self.always, *(grip for k in closed for grip in self.barriers[k].grips)]
        places = [*held, *(self.barriers[k].place for k in closed), *(self.drags[k].keeps for k in drags)]
        across: dict[int, int] = {}
        for k, sliding in drags.items():
            if self.drags[k].across >= 0 and not sliding:
                across[k] = len(places)
                places.append(self.drags[k].keeps_across)
        signs = np.ones(len(places))
        normals = range(len(held), len(held) + len(closed))
        for row, k in zip(normals, closed, strict=True):
            signs[row] = self.barriers[k].sign
        at = {place: row for row, place in enumerate(places)}
        J = now.gradients[places] * signs[:, None]
        rates, biases = signs * now.rates[places], signs * now.biases[places]
        # what slides in a plane has the row of its direction
        ways: dict[int, float] = {}
        for row, (k, sliding) in enumerate(drags.items(), len(held) + len(closed)):
            if self.drags[k].across >= 0 and sliding:
                both, ways[k] = [self.drags[k].keeps, self.drags[k].keeps_across], self.way(k, now)
                unit = np.array((math.cos(ways[k]), math.sin(ways[k])))
                J[row], rates[row], biases[row] = (unit @ each[both] for each in (now.gradients, now.rates, now.biases))
        weighted = J * self.inverse_mass
        A = weighted @ J.T
        b = rates if of_rates else weighted @ now.force + biases
        dry_friction = tuple(
            replace(self._rub(k, sliding, at, len(held) + len(closed) + n, now.t), across=across.get(k, -1))
            for n, (k, sliding) in enumerate(drags.items())
        )
        lengths = np.array([1.0 if self.is_angle(self.rows[k]) else self.numbers.length for k in places])
        matrices = ContactProblem(A, b, tuple(normals), dry_friction, lengths)
        return RowProblem(matrices, tuple(closed), tuple(drags), weighted, len(held), tuple(places), across, ways)

    def way(self, k: int, now: ContactInstant) -> float:
        """The angle from its row of a slip in a plane."""
        return math.atan2(now.rates[self.drags[k].keeps_across], now.rates[self.drags[k].keeps])

    def slip_gradient(self, k: int, sign: int, now: ContactInstant) -> Floats:
        """(n,) of the slip rate of what slides, in the direction in which it does."""
        drag = self.drags[k]
        if drag.across < 0:
            return sign * now.gradients[drag.keeps]
        angle = self.way(k, now)
        return math.cos(angle) * now.gradients[drag.keeps] + math.sin(angle) * now.gradients[drag.keeps_across]

    def _rub(self, k: int, sliding: int, at: dict[int, int], row: int, t: float) -> FrictionProblemRow:
        drag, number = self.drags[k], self.numbers.number
        rub = drag.rub
        if not drag.loads:
            static, kinetic = self._limits(k, t)
            return FrictionProblemRow(row, (static, static), (kinetic, kinetic), constant=1.0, sliding=sliding)
        static = number(rub.coefficient(1, at_rest=True)), number(rub.coefficient(-1, at_rest=True))
        kinetic = number(rub.coefficient(1)), number(rub.coefficient(-1))
        loads = tuple(at[place] for place in drag.loads if place in at)
        if len(loads) == 1 and drag.load_sign:
            return FrictionProblemRow(
                row, static, kinetic, normals=loads, sliding=sliding, lifts=rub.is_tipping and k in self.ends.by_moment
            )
        return FrictionProblemRow(row, static, kinetic, magnitudes=(loads,) if loads else (), sliding=sliding)

    def _limits(self, k: int, t: float) -> tuple[float, float]:
        """The largest friction at rest and in motion of a brake, at the instant looked at."""
        static, kinetic = (
            max(0.0, self.free.tape_value(tape, t)) for tape in self.written.limit_tapes(self.drags[k].packed)
        )
        return max(static, kinetic), kinetic

    def is_angle(self, row: ConstraintRow) -> bool:
        return row.measure.dimension == DIMENSIONLESS

    def keep(self, drag: int, now: ContactInstant) -> None:
        """The slip of a drag is kept from now on where it is."""
        d, rows = self.drags[drag], self.free.room.rows
        self.written.keep(d.packed, float(rows[d.row, kinematics.VALUE]))
        if d.across >= 0:
            self.written.keep_across(d.packed, float(rows[d.across, kinematics.VALUE]))


def _rows_of(pivot: RimPivot) -> tuple[ConstraintRow, ...]:
    return (pivot.bound.row, *(row for rub in pivot.dry_friction for row in rub.rows))


def _spin_watches(k: int, bound: UnilateralConstraint) -> list[EngineWatch]:
    """What ends a motion where a rough flat end begins to spin, either way."""
    if bound.spinning is None:
        return []
    return [EngineWatch(f"{_SPIN}{k}", bound.spinning, 1, limit, is_terminal=True) for limit in (SPINS, -SPINS)]


def _grips(system: SystemDescription, bound: UnilateralConstraint) -> tuple[int, ...]:
    """The rows that are held only while an ideal contact is closed."""
    return tuple(
        k for k, row in enumerate(system.constraint_rows) if row.needs and f"{row.connection}.{row.needs}" == bound.name
    )
