"""One system, set up on both routes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import AbstractContextManager, nullcontext, suppress
from dataclasses import replace
from functools import cached_property
from typing import Any, ClassVar

import numpy as np

from freebody.errors import CannotAnswer, ModelError, Problem
from freebody.language.expression import n_operations
from freebody.language.sentences import Message
from freebody.language.units import LENGTH
from freebody.measures.base import Measure
from freebody.measures.displacement import Displacement
from freebody.model.elements import ConstraintRow, NonholonomicForm
from freebody.numeric.snapshot import Snapshot
from freebody.numeric.split import Split, stack
from freebody.questions.base import Quantity
from freebody.questions.vectors import ORIGIN, axes_of
from freebody.study.answering.draws import SEED, Draw, draws
from freebody.symbolic.closure import Closure
from freebody.symbolic.conditions import Condition, closed, require
from freebody.symbolic.equilibrium import ClosedFormRest
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.motion import SmoothMotion
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.small_motion import small_motion_about
from freebody.symbolic.start import StartState, start_state
from freebody.symbolic.state import SymbolicState
from freebody.symbolic.tidy import tidy
from freebody.symbolic.values_of_terms import NoValue
from freebody.system.order import in_one_order
from freebody.system.system import System
from freebody.tolerances import ROUND_OFF

N_DRAWS = 6
N_MORE = 3  # further ones at a time
_TIME = 0.37  # an instant at which drivers are looked at
SAME_PLACE = 1e-6  # of a length: less is no other sign
_STILL = 1e-8  # of the slope of a measure: less along all free motions is no change

_MOST_TERMS = 60  # of a condition that is read, multiplied out
_N_WAYS = 6  # directions in which a general pose is looked for
_OTHER_WAY = 1000  # between their seeds
_CLOSER = (1.0, 0.5, 0.2, 0.05)  # how far from the file's values draws on its branch are looked for


class Setup:
    """The symbolic model, the numeric draws, and what all questions share."""

    _sides: Sequence[Ratio] = ()  # positive where the loops are assembled as in the formulas
    _has_sided_loads = False  # whether their laws take something to be positive

    def __init__(self, system: System, n_draws: int = N_DRAWS, first: Draw | None = None) -> None:
        """first: the first of the draws, where that shall be a certain one."""
        self.system = system
        try:
            self.draws: list[Draw] = draws(system, n_draws) if first is None else [first]
            if first is not None:
                self.draws += draws(system, n_draws - 1, near=first)
        except CannotAnswer as error:
            raise ModelError([Problem((), str(error))], system.file) from error

    def beginning_with(self, first: Draw) -> Setup:
        """The same system, with another first draw."""
        return Setup(self.system, first=first)

    @property
    def model(self) -> SymbolicModel:
        """The symbolic route. Raises CannotAnswer where its formulas would be too long."""
        if isinstance(self._made, CannotAnswer):
            raise self._made
        return self._made

    @property
    def has_model(self) -> bool:
        """Whether there are formulas of it at all."""
        return not isinstance(self._made, CannotAnswer)

    @cached_property
    def _made(self) -> SymbolicModel | CannotAnswer:
        """The model, or why there is none: neither is looked for twice."""
        try:
            n, model = len(self.draws), self._formulas()
            for widest in _CLOSER:  # a spring relaxed at the start is longer than then, or shorter, on one side only
                kept = [d for d in self.draws if self._fits(model, d)]
                if len(kept) == n:
                    break
                if not kept:
                    raise CannotAnswer(Message("at the start the formulas have no value, or another sign than nearby"))
                near = draws(self.system, n, seed=SEED + _OTHER_WAY, widest=widest, near=kept[0])
                self.draws = [*kept, *(d for d in near if self._fits(model, d))][:n]
                model = self._formulas()
            self._check_freedoms(model)
        except CannotAnswer as error:
            return error
        return model

    def apart(self) -> AbstractContextManager[None]:
        """What formulas take to be positive inside is so for what is found there only."""
        return nullcontext() if isinstance(self._made, CannotAnswer) else self._made.samples.apart()

    @cached_property
    def of_geometry(self) -> Setup:
        """What is driven moves so whatever loads act: the same without them, where their laws take something to be
        positive that may change its sign on the way, as the length of a spring whose ends pass each other."""
        model = self.model
        if model.degrees_of_freedom or not self._has_sided_loads:
            return self
        return Setup(replace(self.system, applied_loads=()))

    def _formulas(self) -> SymbolicModel:
        """The model for the draws there are: signs that formulas leave open are those at the first of them."""
        starts = [replace(d.sample(), still=still_measures(d)) for d in self.draws[:3]]
        general = [d.sample(d.anywhere(SEED, _TIME, 0.1), is_start=False) for d in self.draws[:3]]
        model = SymbolicModel(self.system, [*starts, *general])
        model.start.by_loops = lambda values: Closure(model).at(values)
        n_taken = len(model.samples.assumed)
        with suppress(CannotAnswer):  # what the laws take to be positive is so for every question
            model.loads.wrenches  # noqa: B018
        self._has_sided_loads = len(model.samples.assumed) > n_taken
        closure = Closure(model)
        closure.take_sides()
        self._sides = closure.sides
        return model

    def _fits(self, model: SymbolicModel, draw: Draw) -> bool:
        """Whether a draw starts on the branch of the formulas, its loops assembled as theirs are."""
        start = draw.start()
        if not _is_on_branch(model, draw, start):
            return False
        numbers = model.samples.numbers(draw.sample(start)) if self._sides else {}
        return all(model.field.evaluate(x, numbers) > 0 for x in self._sides)

    def _check_freedoms(self, model: SymbolicModel) -> None:
        """The formulas must have the freedoms that the rank leaves. Fewer are left by angles of a body in space that
        are named, or where a number of the model is special, as a radius of zero; more where what rows bind nearly
        vanishes about the start."""
        found = min(rank_freedoms(draw.anywhere(SEED + k, _TIME, 0.1)) for k, draw in enumerate(self.draws[:3]))
        if found == model.degrees_of_freedom:
            return
        rolls = any(isinstance(row.measure, NonholonomicForm) for row in self.system.constraint_rows)
        if found > model.degrees_of_freedom and rolls and not self.system.space:
            return  # rows of velocities may bind more a step away, where no motion leads
        are_named = any(turn.name for b in self.system.moving for turn in b.chain)
        if found < model.degrees_of_freedom or not self.system.space or not are_named:
            raise CannotAnswer(
                Message(
                    "about the start the connections leave {m} degrees of freedom, and in the formulas {n}: the pose "
                    "or a number of the model is a special one, in which formulas do not tell what is held. Start "
                    "elsewhere, or ask for numbers",
                    m=found,
                    n=model.degrees_of_freedom,
                )
            )
        few = [b.name for b in self.system.moving if 0 < sum(bool(turn.name) for turn in b.chain) < 3]
        if few:
            raise CannotAnswer(
                Message(
                    "the connections leave {n} degrees of freedom, but the angles of {bodies} named by turned only "
                    "{m}: name three angles, or hold the body by a joint that leaves it no others",
                    n=found,
                    bodies=", ".join(few),
                    m=model.degrees_of_freedom,
                )
            )
        raise CannotAnswer(
            Message(
                "the connections leave {n} degrees of freedom, but the angles named by turned only {m}: name three "
                "angles, or hold the body by a joint that leaves it no others",
                n=found,
                m=model.degrees_of_freedom,
            )
        )

    def draw_stream(self, n_more: int = N_MORE) -> Iterator[Draw]:
        """The draws, then more of them, ever closer to the file's values, for answers with narrow conditions."""
        yield from self.draws
        for k, widest in enumerate((0.5, 0.2, 0.05)):
            near = draws(self.system, n_more, seed=SEED + 10 + k, widest=widest, near=self.draws[0])
            yield from (d for d in near if not self.has_model or self._fits(self.model, d))

    is_mode: ClassVar[bool] = False  # one mode of contacts and friction, kept: of what ends it the system knows nothing

    @property
    def has_values(self) -> bool:
        """True if the file gives every parameter a value."""
        return self.system.has_values

    @cached_property
    def state(self) -> SymbolicState:
        """The general instant."""
        return SymbolicState(self.model)

    @cached_property
    def start(self) -> StartState:
        s = self.system
        return start_state(self.model, dict(s.all_start), dict(s.all_start_rates))

    @cached_property
    def start_instant(self) -> SymbolicState:
        return SymbolicState(self.model, self.start.values, self.start.blow)

    def start_for(self, quantity: Quantity) -> SymbolicState:
        """The start; for what only the sense of a motion matters to, with one freedom, the pose there."""
        if not quantity.is_of_pose_in_motion or self.model.degrees_of_freedom != 1:
            return self.start_instant
        speeds = {c.speed for c in (*self.model.coordinates, *self.model.dependent)}
        return SymbolicState(self.model, {k: x for k, x in self.start.values.items() if k not in speeds})

    @cached_property
    def moves_off_evenly(self) -> bool:
        """Whether nothing can rest, and small motions are those beside a motion with constant acceleration."""
        return self.place_of_small_motion().moves_evenly

    @property
    def rest_of_small_motion(self) -> ClosedFormRest | None:
        """The equilibrium that is stable, if it can be; None where nothing moves."""
        return self.place_of_small_motion() if self.model.coordinates else None

    def place_of_small_motion(self, *, stable_first: bool = True) -> ClosedFormRest:
        """The equilibrium; where there is none and the equations are linear, the start, about which they are as they
        are about any motion with constant acceleration."""
        if stable_first not in self._small_about:
            self._small_about[stable_first] = small_motion_about(self.model, self.start, stable_first=stable_first)
        return self._small_about[stable_first]

    @cached_property
    def _small_about(self) -> dict[bool, ClosedFormRest]:
        return {}

    @cached_property
    def motion(self) -> SmoothMotion:
        return SmoothMotion(self.model, self.start)

    @property
    def anywhere(self) -> list[Snapshot]:
        """A general pose and motion for every draw, on the branch for which the formulas are made: where the question
        at hand takes more to be positive, other poses and motions are looked for."""
        taken = tuple(x.key() for x in self.model.samples.assumed)
        if taken not in self._found_anywhere:
            self._found_anywhere[taken] = [self._anywhere(d, SEED + k) for k, d in enumerate(self.draws)]
        return list(self._found_anywhere[taken])

    def anywhere_stream(self) -> Iterator[tuple[Draw, Snapshot]]:
        """Every draw with a general pose and motion, then more of them, closer to the file's values: where the formulas
        take a difference of parameters to be positive, half of all draws are on no branch of theirs."""
        found = self.anywhere
        for k, draw in enumerate(self.draw_stream()):
            yield draw, found[k] if k < len(found) else self._anywhere(draw, SEED + k)

    @cached_property
    def _found_anywhere(self) -> dict[tuple[object, ...], list[Snapshot]]:
        return {}

    def _anywhere(self, draw: Draw, seed: int) -> Snapshot:
        # from a start at which something that is positive vanishes half of all ways lead astray, however short
        for way in range(_N_WAYS):
            for size in (0.3, 0.1, 0.03, 0.01):
                snapshot = draw.anywhere(seed + way * _OTHER_WAY, _TIME, size)
                if self.is_on_branch(draw, snapshot):
                    return snapshot
        return draw.start()

    def is_on_branch(self, draw: Draw, snapshot: Snapshot) -> bool:
        """True where everything that the formulas take to be positive is."""
        return _is_on_branch(self.model, draw, snapshot)

    def holding(self, state: SymbolicState, *, with_contacts: bool = True) -> list[Condition]:
        """Conditions without which the model itself is not true: what is taken to be positive is, ideal strings
        pull, contacts push. In the order of the names of connections, so that none in the file changes what is said."""
        found: list[Condition] = []
        for x in self.model.samples.assumed:
            found += _open(state.here(self.model.express(x)), ">", Message("as at the start"))
        for row in sorted(self.system.constraint_rows, key=lambda row: row.name):
            if row.unilateral and state.is_struck:
                found += _open(row.sign * state.impulse(row), ">=", held_in_blow(row))
            if row.unilateral and with_contacts:
                with suppress(CannotAnswer):
                    found += _open(row.sign * state.multiplier(row), ">=", closed(row.connection, row.reaction))
        if not with_contacts:
            return found
        for v in self.system.validities:
            away = state.value(v.measure) - state.scalar(v.limit)
            found += _open(v.sign * away, ">=", v.purpose)
        return found + self.reserves(state)

    def flanks(self, state: SymbolicState) -> list[Condition]:
        """Conditions under which teeth bear on the flank that the model says."""
        found: list[Condition] = []
        for row in self.system.constraint_rows:
            if row.pressed:
                with suppress(CannotAnswer):
                    pressed = row.pressed.sign * row.sign * state.multiplier(row)
                    found += _open(pressed, ">=", row.pressed.is_kept(row.connection))
        return found

    def reserves(self, state: SymbolicState) -> list[Condition]:
        """Conditions under which dry friction that sticks does so."""
        return []

    def clearances(self, state: SymbolicState, relation: str) -> list[Condition]:
        """Conditions under which what is open is so: `>=` where it may touch, `>` where it needs room to move."""
        return []

    @cached_property
    def closure(self) -> Closure:
        """The closed loops, solved for what they bind."""
        return Closure(self.model)

    def closing(self, state: SymbolicState) -> list[Condition]:
        """Where the closed loops close, as far as that is read at a glance; the names of a chain tell the rest."""
        found = self.closing_in_full(state)
        if any(c.element.n_terms > _MOST_TERMS for c in found):
            return []
        return [kept for c in found for kept in _open(c.element, c.relation, c.purpose)]

    def closing_in_full(self, state: SymbolicState) -> list[Condition]:
        """Where the closed loops close, as far as they have a short solution, however long that is."""
        with suppress(CannotAnswer):
            return [replace(c, element=state.here(c.element)) for c in self.closure.closes()]
        return []

    def in_free_coordinates(
        self, conditions: Sequence[Condition], state: SymbolicState, readable: int | None = None
    ) -> list[Condition]:
        """The same conditions in coordinates that loops do not bind, as far as the loops have a short solution.
        readable: those that would take more operations to write, and more than before, stay as they are."""
        bound = {d.index for d in self.model.dependent}
        found: list[Condition] = []
        for c in conditions:
            if bound & self.model.field.ingredients(c.element):
                with suppress(CannotAnswer):
                    free = state.here(self.closure.explicit(c.element))
                    if readable is None or _is_readable(free, c.element, readable):
                        c = replace(c, element=free)
            found.append(c)
        return found


def _is_readable(x: Ratio, instead: Ratio, readable: int) -> bool:
    """Whether an element is short enough to be read, or no longer than another one. Of a single term the factors are
    looked at one by one, as of the root of what lets a loop close."""
    if len(x.num) > readable:
        return False
    return len(x.num) == 1 or n_operations(tidy(x)) <= max(readable, n_operations(tidy(instead)))


def _is_on_branch(model: SymbolicModel, draw: Draw, snapshot: Snapshot) -> bool:
    if not model.samples.assumed and not model.has_equal_angles:
        return True
    numbers = model.samples.numbers(draw.sample(snapshot))
    try:
        if not all(model.field.evaluate(x, numbers) > 0 for x in model.samples.assumed):
            return False
    except NoValue:
        return False
    lengths = [m for m in model.system.measures.values() if m.dimension == LENGTH]
    return all(_is_as_in_formulas(model, numbers, snapshot, m) for m in (*lengths, *places_of_bodies(model)))


def places_of_bodies(model: SymbolicModel) -> Iterator[Measure]:
    """Where the bodies are: beyond the point from which a distance is counted, formulas have them on this side."""
    for body in model.system.moving:
        yield from (Displacement(body.mass_center, ORIGIN, along) for along in axes_of(model.system))


def _is_as_in_formulas(model: SymbolicModel, numbers: dict[int, Any], snapshot: Snapshot, length: Measure) -> bool:
    """Whether a named length has the value that the formulas give it: where they write it by another one, its sign may
    be that of the start (a travel by a distance)."""
    try:
        value = snapshot.value(length)
        gap = abs(float(model.field.evaluate(model.value_of(length), numbers)) - value)
    except (CannotAnswer, ArithmeticError):
        return True  # it has no value there
    return gap <= SAME_PLACE * max(snapshot.reference.sizes.length, abs(value))


def held_in_blow(row: ConstraintRow) -> Message:
    """What is needed of the impulse of a connection that cannot pull, or push."""
    return Message("{connection} holds in the blow", connection=row.connection)


def _open(x: Ratio, relation: str, purpose: str) -> list[Condition]:
    condition, _possible = require(x, relation, purpose)
    return [] if condition is None else [condition]


def rank_freedoms(snapshot: Snapshot) -> int:
    """Coordinates minus the rank of the constraint Jacobian. Each row counts by the size of what it measures: beside
    lengths of 1e12 m a radian is not nothing."""
    reference, n = snapshot.reference, len(snapshot.q)
    unit = reference.sizes.length
    rows = [
        reference.jet(snapshot.geometry, row.measure).row(n) / unit ** float(row.measure.dimension.length)
        for row in reference.system.constraint_rows
    ]
    return Split(stack(rows, n), reference.sizes.small_moves).null.shape[1]


def still_measures(draw: Draw) -> frozenset[str]:
    """Named measures that no motion of a draw changes at its start to first order (a dead point)."""
    reference, q = draw.reference, draw.q
    moves = reference.sizes.unit_moves
    free = np.linalg.qr(reference.split_at(q, {}).null / moves[:, None])[0]
    g = reference.geometry(q, np.zeros_like(q), 0.0)
    found: set[str] = set()
    for name, measure in reference.system.measures.items() if free.shape[1] else ():
        with suppress(CannotAnswer):
            slope = reference.jet(g, measure, name).row(len(q)) * moves
            if np.linalg.norm(slope @ free) <= _STILL * np.linalg.norm(slope):
                found.add(name)
    return frozenset(found)


def independent_measures(setup: Setup, n: int) -> tuple[str, ...]:
    """Names of n measures that determine the motion: named ones first, then those that joints offer."""
    start = setup.draws[0].start()
    moves = start.reference.sizes.unit_moves
    free = np.linalg.qr(start.reference.split_at(start.q, start.branches).null / moves[:, None])[0]
    chosen: list[str] = []
    rows = np.zeros((0, free.shape[1]))
    ordered = in_one_order(setup.system)
    for name, measure in (*ordered.measures.items(), *ordered.offered):
        with suppress(CannotAnswer):
            slope = start.reference.jet(start.geometry, measure).row(len(start.q)) * moves
            row = slope @ free
            size = float(np.linalg.norm(row))
            if size <= ROUND_OFF * float(np.linalg.norm(slope)):
                continue
            row = row / size
            if len(chosen) < n and np.linalg.matrix_rank(np.vstack((rows, row)), tol=ROUND_OFF) > len(rows):
                chosen.append(name)
                rows = np.vstack((rows, row))
    return tuple(chosen)
