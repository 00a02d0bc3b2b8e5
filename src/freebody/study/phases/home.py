"""What all phases of a system share: its start, one field of its parameters, and many sets of numbers for these."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.expression import ZERO, Expr, Symbol, free_symbols, n_operations, substitute
from freebody.language.sentences import Message
from freebody.measures.distance import Distance
from freebody.measures.geometry import Pose, SpatialPose
from freebody.model.elements import ConstraintRow, DryFriction, Start, UnilateralConstraint
from freebody.numeric.blow import blow_loads_friction
from freebody.numeric.jets import Array
from freebody.study.phases.at_start import as_put, closed_at_start, parted_at_start, put_where_they_touch
from freebody.study.phases.decide import Inequality
from freebody.study.phases.numbers import Chosen, Sets
from freebody.study.phases.phase import Phase, has_lines, straight_of
from freebody.study.phases.placed import Placed
from freebody.study.phases.together import slip_rates
from freebody.study.phases.words import at_start
from freebody.study.setup import Setup, held_in_blow
from freebody.symbolic.conditions import Condition, require
from freebody.symbolic.decide import Trials
from freebody.symbolic.parameter_roots import without_roots_below
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.relations import parted
from freebody.symbolic.state import SymbolicState
from freebody.system.modes import ContactMode, depends_on_time, ideal_bounds, in_mode, sticking_rows
from freebody.system.system import System
from freebody.tolerances import ROUND_OFF, ROUNDED

_LONG_ANGLE, _LONG_TIME = 3, 12  # operations: what is longer gets a symbol


class Home:
    """A system at its start, without friction: conditions, times and values of all phases are elements of its field."""

    def __init__(self, system: System) -> None:
        given, system = system.assumptions, as_put(system)
        self.put = [text for text in system.assumptions if text not in given]  # what is assumed about its start
        touching = closed_at_start(system)
        self.moving = parted_at_start(system, touching)  # touch, with a gap that grows or shrinks at the start
        self.closed = touching - self.moving
        system = put_where_they_touch(system, touching, self.moving)
        free = ContactMode.of(self.closed, {})
        self.home = Setup(in_mode(system, free)[0])
        self.system = _with_angles(system, self.home)
        if self.system is not system:
            self.home = Setup(in_mode(self.system, free)[0])
        self.sets = Sets(self.system)
        self.home.model.field.trials = Trials(self.sets.points_of(self.home.model))
        self.later: dict[str, Ratio] = {}  # symbols for angles of bodies, and times, at which later phases begin
        self.constants = dict(self._constants())
        self.sets.constants = {name: self.numbers(x) for name, x in self.constants.items()}
        self.assumed: list[Condition] = []
        self.indices: Chosen = np.flatnonzero(self._admissible(touching))
        self.acting = dict(self._acting())

    def _admissible(self, touching: frozenset[str]) -> Any:
        """Sets for which the start is one: on the branch of the model's own numbers, and nothing inside another."""
        found = np.ones(self.sets.n, dtype=bool)
        state, express = self.home.start_instant, self.home.model.express
        needed: list[Inequality] = [
            (state.here(express(x)), ">", Message("as at the start")) for x in self.home.model.samples.assumed
        ]
        for bound in self.system.bounds:
            if bound.name not in touching and not bound.within:
                needed.append(
                    (
                        self._gap(bound.row),
                        ">=",
                        Message("{contact} is open at the start", contact=bound.row.connection),
                    )
                )
            elif bound.name in touching:
                needed += self._on_its_edge(bound)
        needed += self._held_in_blow(state)
        for row in [r for r in self.system.constraint_rows if r.unilateral] + [b.row for b in self.system.bounds]:
            if row.name in touching and isinstance(row.measure, Distance) and row.target is not None:
                target = self.home.model.geometry.scalar(row.target)  # a circle in a ring is the smaller one
                needed.append((target, ">", Message("{string} fits", string=row.connection)))
        for x, relation, purpose in needed:
            found &= ~(self.numbers(x) <= 0) if relation == ">" else ~(self.numbers(x) < 0)
            condition, _possible = require(x, relation, purpose)
            if condition is not None:
                self.assumed.append(condition)
        return found

    def _acting(self) -> Iterator[tuple[str, bool]]:
        """Whether loads that have a border act at the start, at the model's own values, and so for all sets that are
        left; of loads that are at their border nothing."""
        for name, row in self.system.borders.items():
            beyond = -self._gap(row)
            if beyond.is_zero():
                continue
            numbers = self.numbers(beyond)
            if not np.isfinite(numbers[self.indices]).any():
                told = Message(
                    "whether {load} acts at the start cannot be told: the model leaves open where its ends are then",
                    load=name.partition(".")[0])  # fmt: skip
                raise CannotAnswer(told)
            acts = bool(np.sum(numbers[self.indices[:1]] > 0))
            side = 1 if acts else -1
            condition, _possible = require(side * beyond, ">", at_start(row, acts=acts))
            self.assumed += [] if condition is None else [condition]
            self.indices = self.indices[side * numbers[self.indices] > 0]
            yield name, acts

    def _held_in_blow(self, state: SymbolicState) -> Iterator[Inequality]:
        """What cannot pull must be pressed, or not be needed, where the start is a blow. Raises CannotAnswer where the
        blow loads dry friction, which acts in it."""
        if not state.is_struck:
            return
        loads = {name for rub in self.system.dry_friction for name in rub.load}
        for row in self.home.system.constraint_rows:
            if row.name in loads and row.name not in {b.name for b in self.system.bounds}:
                if not state.impulse(row).is_zero():
                    raise CannotAnswer(blow_loads_friction(row))
            elif row.unilateral:
                yield row.sign * state.impulse(row), ">=", held_in_blow(row)

    def _on_its_edge(self, bound: UnilateralConstraint) -> Iterator[Inequality]:
        """What touches at the start, or is struck there, does so between the ends of its edge."""
        scalar, contact = self.home.model.geometry.scalar, bound.row.connection
        purpose = Message("{contact} is struck", contact=contact)
        if bound.name not in self.moving:
            purpose = Message("{contact} touches", contact=contact)
        for span in bound.within:
            measure: Any = span.measure
            value = self.home.start_instant.value(measure)
            ends = [] if span.low is None else [value - scalar(span.low)]
            ends += [] if span.high is None else [scalar(span.high) - value]
            yield from ((self.home.model.field.lowest_terms(x), ">", purpose) for x in ends if not x.is_zero())

    def _gap(self, row: ConstraintRow) -> Ratio:
        measure: Any = row.measure
        target = row.target
        value = self.home.start_instant.value(measure)
        return row.sign * (value if target is None else value - self.home.model.geometry.scalar(target))

    def _constants(self) -> Iterator[tuple[str, Ratio]]:
        """Start values of the measures that are held where they are, by the symbols that stand for them."""
        rows: list[ConstraintRow] = [
            *self.system.constraint_rows,
            *(row for rub in self.system.dry_friction for row in sticking_rows(rub)),
        ]
        for row in rows:
            measure: Any = row.measure
            if getattr(measure, "incremental", False):
                try:
                    yield _symbol_of(row), self.home.start_instant.value(measure)
                except CannotAnswer:
                    continue

    # -- one field ----------------------------------------------------------------------------
    def to_home(self, phase: Phase | Setup, x: Ratio) -> Ratio:
        """An element of the parameters in the field that all phases share. Raises CannotAnswer where it contains a
        start value that follows from the assembly only: that is a symbol of its phase alone."""
        model = self.home.model
        own = {phase.model.field.index(symbol): k for k, symbol in phase.model.samples.start_symbols.items()}
        inside = phase.model.field.ingredients(x)
        inside |= {own[symbol] for symbol in inside & own.keys()}
        for c in (*phase.model.coordinates, *phase.model.dependent):
            if c.index in inside:
                raise CannotAnswer(
                    Message("what {name} is at the start has no closed form; give it in start", name=c.name)
                )
        expr = phase.model.field.expression(x)
        return _shorter(model.field.lowest_terms(model.geometry.apply(expr, {**self.later, **self.constants})))

    def at_start(self, x: Ratio) -> Ratio:
        return self.home.start_instant.here(x)

    def numbers(self, x: Ratio) -> Array:
        """An element of the parameters in all sets."""
        return self.sets.evaluate(self.home.model, x)

    def vanishes(self, x: Ratio) -> bool:
        """Whether an element is zero at the model's own numbers, or round-off of its terms."""
        return self.sets.vanishes(self.home.model, x, 0)

    def changes_sign(self, x: Ratio, sets: Chosen) -> bool:
        numbers = self.numbers(x)[sets]
        return bool((numbers > 0).any() and (numbers < 0).any())

    def conditions(self, elements: Sequence[tuple[Ratio, str, str]], sets: Chosen) -> list[Condition]:
        """What is left of inequalities that hold at some sets, factor by factor."""

        def sign_at(x: Ratio) -> int:
            signs = set(np.sign(self.numbers(x)[sets]).tolist()) - {0.0}
            return int(signs.pop()) if len(signs) == 1 else 0

        equal = [Condition(x.numerator(), relation, purpose) for x, relation, purpose in elements if relation == "="]
        open_ones = [item for item in elements if item[1] != "="]
        found = equal + [c for x, relation, purpose in open_ones for c in parted(x, relation, purpose, sign_at)]
        # what is not so at every set of the branch is no condition of it
        return [c for c in found if not (self.numbers(c.element)[sets] < -ROUND_OFF).any()]

    # -- contacts -------------------------------------------------------------------------------
    def bound_row(self, name: str) -> ConstraintRow:
        """Of a bound, or of a connection that cannot pull."""
        return next(
            row
            for row in (
                *ideal_bounds(self.system),
                *(b.row for b in self.system.bounds),
                *self.system.borders.values(),
            )
            if row.name == name
        )

    def by_sign(self, rates: Mapping[str, Ratio], indices: Chosen) -> Iterator[tuple[dict[str, int], Chosen]]:
        """The sets by the signs of the rates at which gaps change."""
        if not rates:
            yield {}, indices
            return
        numbers = {name: self.numbers(x)[indices] for name, x in rates.items()}
        largest = np.max([np.abs(v) for v in numbers.values()], axis=0)
        table = np.array([np.sign(np.where(np.abs(v) > ROUNDED * largest, v, 0.0)) for v in numbers.values()]).T
        for row in np.unique(table, axis=0)[::-1]:
            mine = indices[(table == row).all(axis=1)]
            yield dict(zip(numbers, row.astype(int).tolist(), strict=True)), mine

    def rubbing(self, closed: frozenset[str]) -> list[DryFriction]:
        return [rub for rub in self.system.dry_friction if not rub.of or rub.of in closed]

    @cached_property
    def slip_rates(self) -> dict[str, Ratio]:
        """While what touches at the start keeps touching."""
        return slip_rates(self.system, self.home.state)

    # -- states as starts ---------------------------------------------------------------------
    def placed(self, phase: Phase | Setup, values: dict[int, Ratio]) -> Placed:
        """The state of a phase at given values of its coordinates and speeds, as starts of all bodies. Angles become
        symbols, since sines of long sums are long."""
        unfollowed = phase.system.unfollowed
        if phase.system.space and any(b.turns and b.name not in unfollowed for b in phase.system.moving):
            raise CannotAnswer(Message("in space the start of a phase is put together from particles and balls only"))
        model, f = phase.model, phase.model.field
        there = SymbolicState(model, values)
        moving = {c.index for c in model.coordinates} | {c.speed for c in model.coordinates}

        def at(x: Ratio) -> Ratio:
            x = f.lowest_terms(there.here(x))
            if f.ingredients(x) & moving:
                raise CannotAnswer(Message("the state at the event has no closed form"))
            return x

        def shown(x: Ratio) -> Expr:
            return substitute(f.expression(at(x)), self._lengths_by_symbol)

        starts: dict[str, Start] = {}
        for body in phase.system.moving if phase.system.space else ():
            spatial = model.poses[body.name]
            assert isinstance(spatial, SpatialPose)
            assert spatial.center.z is not None
            center = (shown(spatial.center.x), shown(spatial.center.y), shown(spatial.center.z))
            motion = tuple(map(shown, model.kinematics.velocities[body.name]))
            spin = motion[3:] if body.turns else None
            starts[body.name] = Start((body.default_point, center), velocity=motion[:3], rates=spin)
        for body in () if phase.system.space else phase.system.all_moving:
            pose, (vx, vy, w) = model.poses[body.name], model.kinematics.velocities[body.name]
            assert isinstance(pose, Pose)
            name = body.default_point
            px, py = (model.geometry.scalar(e) for e in body.points[name])
            place = pose.x + pose.cos * px - pose.sin * py, pose.y + pose.sin * px + pose.cos * py
            starts[body.name] = Start(
                (name, (shown(place[0]), shown(place[1]))),
                self._short(phase, at(pose.angle), _LONG_ANGLE) if body.turns else None,
                (shown(vx), shown(vy)),
                shown(w) if body.turns else None,
            )
        return Placed(starts, self._since(phase, values), self.lengths)

    def begun(self, mode: ContactMode, placed: Placed, left: Chosen) -> Phase:
        """The phase of a mode from where it begins, in coordinates in which it is short. left: the parameter sets."""
        phase = Phase.begun(self.system, mode, placed, self.sets.some(left, 3))
        if placed.bodies is None and self._parts_too_early(phase):
            placed = self.placed(self.home, self.home.start.values)
            return Phase.begun(self.system, mode, placed, self.sets.some(left, 3))
        if placed.bodies is None and self._begins_elsewhere(phase):
            with suppress(CannotAnswer):
                where = self.placed(self.home, self.home.start.values)
                return Phase.begun(self.system, mode, where, self.sets.some(left, 3))
            with suppress(CannotAnswer):
                return Phase.begun(self._put_in_space(), mode, placed, self.sets.some(left, 3))
        if placed.bodies is None and has_lines(self.system):
            with suppress(CannotAnswer):
                _ = phase.course
                return phase
            # what is free from the start on may be simpler in other coordinates
            with suppress(CannotAnswer):
                return Phase.begun(
                    self.system, mode, self.placed(self.home, self.home.start.values), self.sets.some(left, 3)
                )
        return phase

    def _parts_too_early(self, phase: Phase) -> bool:
        """Whether the rates that nobody gave move what touches apart: what opens does so from the start of all that
        keeps touching."""
        gone = self.closed - phase.mode.closed
        rates = (phase.state.rate(self.bound_row(name).measure) for name in gone)
        return any(not phase.start_instant.here(rate).is_zero() for rate in rates)

    def _begins_elsewhere(self, phase: Phase) -> bool:
        """Whether what opens at once would begin apart: nobody has put it but what touched it until then."""
        gone = (self.bound_row(name) for name in self.closed - phase.mode.closed)
        return any(not phase.start_instant.here(phase.gap(row)).is_zero() for row in gone)

    def _put_in_space(self) -> System:
        """The system with the places of bodies that nothing but what touches them has put. Raises CannotAnswer where
        these have no formula."""
        bodies, model = dict(self.system.bodies), self.home.model
        touched = {body for name in self.closed for body in self.bound_row(name).measure.bodies()}
        for body in self.system.moving:
            pose = model.poses[body.name]
            if body.name not in touched or body.start.at is not None or not isinstance(pose, SpatialPose):
                continue
            assert pose.center.z is not None
            center = (self.home.start_instant.here(x) for x in (pose.center.x, pose.center.y, pose.center.z))
            place = tuple(model.field.expression(model.field.lowest_terms(x)) for x in center)
            is_told = all(free_symbols(x) <= self.system.parameters.keys() for x in place)
            if not is_told or set(body.points[body.default_point]) != {ZERO}:
                raise CannotAnswer(
                    Message(
                        "{body} touches at the start and moves apart at once; say where it is then (at)", body=body.name
                    )
                )
            bodies[body.name] = replace(body, start=replace(body.start, at=(body.default_point, place)))
        return replace(self.system, bodies=bodies)

    @cached_property
    def _lengths_by_symbol(self) -> dict[str, Expr]:
        rows = {row.name: row for row in ideal_bounds(self.system)}
        return {_symbol_of(rows[name]): length for name, length in self.lengths.items()}

    @cached_property
    def lengths(self) -> dict[str, Expr]:
        """Of what is held at the length that it has at the start, by row, where the parameters tell it."""
        found: dict[str, Expr] = {}
        model = self.home.model
        moving = {g for c in (*model.coordinates, *model.dependent) for g in (c.index, c.speed)}
        symbols = {model.field.index(symbol) for symbol in model.samples.start_symbols.values()}
        for row in ideal_bounds(self.system):
            length = self.constants.get(_symbol_of(row))
            if length is None and row.target is None and (straight := straight_of(row)) is not None:
                length = self.home.start_instant.value(straight)
            if length is not None and not model.field.ingredients(length) & (moving | symbols):
                found[row.name] = model.field.expression(length)
        return found

    def _since(self, phase: Phase | Setup, values: dict[int, Ratio]) -> Expr | None:
        """The time of the motion at a state of a phase, where it matters."""
        if not depends_on_time(self.system):
            return None
        f = phase.model.field
        now = values.get(f.index(f.time))
        if now is None:
            raise CannotAnswer(Message("something depends on the time, and that of the event has no closed form"))
        before = phase.placed.since if isinstance(phase, Phase) else None
        if now.is_zero() and before is None:
            return None
        if any(p.form is not None for p in self.system.parameters.values()):
            raise CannotAnswer(
                Message("a general function of time drives it, and what follows on an event has no formula")
            )
        own = self._short(phase, now, _LONG_TIME)
        return own if before is None else before + own

    def _short(self, phase: Phase | Setup, x: Ratio, longest: int) -> Expr:
        """An angle or a time as it is where it is short, else a symbol for it."""
        expr = phase.model.field.expression(x)
        if n_operations(expr) < longest:
            return expr
        name = f"@later {len(self.later) + 1}"
        self.later[name] = self.to_home(phase, x)
        self.sets.values[name] = self.numbers(self.later[name])
        return Symbol(name)


def _shorter(x: Ratio) -> Ratio:
    """With its one root on top where that is shorter: only then common factors cancel, which else are sums of large
    terms that leave round-off."""
    below = x.denominator()
    roots = [g for g in below.generators() if x.field.generators[g].kind == "root"]
    if len(roots) != 1:
        return x
    found = without_roots_below(x)
    return found if found.n_terms < x.n_terms else x


def _symbol_of(row: ConstraintRow) -> str:
    """The name that a symbolic model gives to the start value of a row."""
    return row.name.replace(".", "_").replace(" ", "_") + "_0"


def _with_angles(system: System, setup: Setup) -> System:
    """The system with the angles of bodies of which nobody said any, where these are zero in every start pose."""
    bodies = dict(system.bodies)
    for body in system.moving:
        if body.turns and body.start.angle is None:
            angles = [draw.reference.pose(draw.q, body.name)[2] for draw in setup.draws]
            if all(abs(a) < ROUND_OFF for a in angles):
                bodies[body.name] = replace(body, start=replace(body.start, angle=ZERO))
    return system if bodies == system.bodies else replace(system, bodies=bodies)
