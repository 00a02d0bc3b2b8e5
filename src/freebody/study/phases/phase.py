"""One phase: a mode of the system, its motion in closed form, and the functions that stay positive while it lasts."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

from freebody.errors import CannotAnswer, ExpressionError
from freebody.language.expression import ZERO, number
from freebody.language.sentences import Message
from freebody.measures.angle import Angle
from freebody.measures.combination import Combination
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Distance
from freebody.measures.lead import Lead
from freebody.model.elements import ConstraintRow, DryFriction, UnilateralConstraint
from freebody.study.phases.placed import Given, Placed
from freebody.study.setup import Setup
from freebody.symbolic.carried import carried_property
from freebody.symbolic.conditions import relation_text
from freebody.symbolic.phases.course import ClosedFormMotion
from freebody.symbolic.phases.energy_motion import course_of
from freebody.symbolic.phases.friction import acts_either_way, named_rows, resultant, solve_loads, with_loads
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.samples import Samples
from freebody.symbolic.start import StartState, start_from_bodies, start_state
from freebody.symbolic.state import SymbolicState
from freebody.symbolic.tidy import tidy
from freebody.system.modes import (
    ContactMode,
    across_the_way,
    ideal_bounds,
    in_mode,
    straightened,
)
from freebody.system.system import System

BOUNCES_END = "bounces end"  # of a contact, after infinitely many impacts


@dataclass(frozen=True)
class PhaseWatch:
    """Something that must stay positive for the phase to go on, and what happens where it does not."""

    # "slip ends", "opens", "slips", "touches", "edge ends", "changes sign", "strikes", "is reached", "is left",
    # "bounces end"
    kind: str
    name: str  # of the bound or the friction; of what changes its sign where that is
    element: Ratio
    direction: int = 0  # in which it begins to slip
    within: tuple[Ratio, ...] = ()  # not negative where the place at which it touches exists
    purpose: str = Message("as at the start")  # of what changes its sign, where it does not

    @property
    def connection(self) -> str:
        is_text = self.kind in ("changes sign", "strikes", "is reached", "is left")
        return self.name if is_text else self.name.partition(".")[0]


class Phase:
    """A mode from a given state on. Raises CannotAnswer where the mode has no closed form, or its forces are not
    unique."""

    def __init__(self, base: System, mode: ContactMode, placed: Placed, values: Sequence[Mapping[str, float]]) -> None:
        in_planes = {rub.name: rub for rub in base.dry_friction}
        base = straightened(base, mode)
        self.base, self.mode, self.placed = base, mode, placed
        self.bounds: dict[str, UnilateralConstraint] = {b.name: b for b in base.bounds}
        self.dry_friction: dict[str, DryFriction] = {r.name: r for r in base.dry_friction}
        system, loads = in_mode(placed.put_into(base), mode)
        self.shared = self._shared(system, loads, values)
        system = without_rows(system, self.shared)
        self.determinant: Ratio | None = None
        if loads:
            # any number will do for the loads while they are symbols: they move nothing at an instant
            unknown = {n: replace(p, value=1.0) if n in loads else p for n, p in system.parameters.items()}
            trial = Given(replace(system, parameters=unknown), [{**v, **dict.fromkeys(loads, 1.0)} for v in values])
            solved = solve_loads(trial.model, loads, named_rows(trial.system), trial.model.samples.is_negative)
            system = with_loads(system, trial.model, solved)
            determinant = solved.determinant
            setup = Given(system, values)
            if not determinant.generators() & {c.speed for c in trial.model.coordinates}:
                with suppress(CannotAnswer, ExpressionError):
                    names = {c.name: setup.model.field.variable(c.index) for c in setup.model.coordinates}
                    expr = trial.model.field.expression(determinant)
                    self.determinant = setup.model.geometry.apply(expr, names)
        else:
            setup = Given(system, values)
        self.setup: Setup = setup
        self.system = system
        self.model = self.setup.model
        self.rows = named_rows(system)
        for name, way in mode.ways:
            aside = self.state.acceleration(across_the_way(in_planes[name], way))
            if not self.samples.vanishes(aside):
                contact = in_planes[name].row.connection
                raise CannotAnswer(Message("the slip of {contact} turns, and its friction with it", contact=contact))
        self.samples.settle()

    @property
    def samples(self) -> Samples:
        return self.model.samples

    @property
    def dropped(self) -> frozenset[str]:
        """Frictions that stick together with another one, and leave the holding to it."""
        return frozenset(name for names in self.shared.values() for name in names)

    def _shared(
        self, system: System, loads: Mapping[str, DryFriction], values: Sequence[Mapping[str, float]]
    ) -> dict[str, list[str]]:
        """Frictions that stick along the same line: of these only the sum is determined, and one row stands for all."""
        sticking = [name for name, state in self.mode.dry_friction if state == 0]
        if len(sticking) < 2:
            return {}
        parameters = {n: replace(p, value=1.0) if n in loads else p for n, p in system.parameters.items()}
        known = [{**v, **dict.fromkeys(loads, 1.0)} for v in values[:1]]
        model = Given(replace(system, parameters=parameters), known).model
        found: dict[str, list[str]] = {}
        for name in sticking:
            if name not in model.redundant:
                continue
            own = model.gradient(self.dry_friction[name].row.measure)
            for other in sticking:
                its = model.gradient(self.dry_friction[other].row.measure)
                is_kept = other != name and other not in model.redundant and own.keys() == its.keys()
                if is_kept and all(model.samples.vanishes(own[k] - its[k]) for k in own):
                    found.setdefault(other, []).append(name)
                    break
            else:
                raise CannotAnswer(
                    Message(
                        "the friction forces {names} are not unique where they all stick", names=", ".join(sticking)
                    )
                )
        return found

    @cached_property
    def start(self) -> StartState:
        if self.placed.bodies is None or self.system.space:
            return start_state(self.model, dict(self.system.all_start), dict(self.system.all_start_rates))
        return start_from_bodies(self.model)

    @property
    def course(self) -> ClosedFormMotion:
        if isinstance(self._course, CannotAnswer):
            raise self._course.with_traceback(None)  # or each time would add where it was raised
        return self._course

    @carried_property
    def _course(self) -> ClosedFormMotion | CannotAnswer:
        """Also that there is none is found once: a phase is asked for its motion many times."""
        rubbing = [self.dry_friction[name].row.measure for name, state in self.mode.states.items() if state]
        try:
            return course_of(self.model, self.start, [self.state.rate(measure) for measure in rubbing])
        except CannotAnswer as reason:
            return reason

    @property
    def sides(self) -> tuple[Ratio, ...]:
        """What is positive where the motion is of its kind."""
        try:
            return self.course.sides
        except CannotAnswer:
            return ()

    @property
    def still(self) -> dict[int, Ratio]:
        """What rests all along, by generator."""
        try:
            return self.course.still
        except CannotAnswer:
            return {}

    @classmethod
    def begun(cls, base: System, mode: ContactMode, placed: Placed, values: Sequence[Mapping[str, float]]) -> Phase:
        """The phase, in the coordinates of the named measures, or without them where only that has a closed form."""
        phase = cls(base, mode, placed, values)
        if not has_lines(base):
            return phase
        needed = {*base.start, *base.start_rates} if placed.bodies is None else set[str]()
        kept = {name: m for name, m in base.measures.items() if name in needed}
        if len(kept) == len(base.measures):
            return phase
        try:
            _ = phase.course
        except CannotAnswer:
            with suppress(CannotAnswer):
                plain = cls(replace(base, measures=kept), mode, placed, values)
                _ = plain.course
                plain.base = straightened(base, mode)
                return plain
        return phase

    @cached_property
    def state(self) -> SymbolicState:
        return SymbolicState(self.model)

    @cached_property
    def start_instant(self) -> SymbolicState:
        return SymbolicState(self.model, self.start.values, self.start.blow)

    # -- forces -------------------------------------------------------------------------------
    def normal(self, bound: UnilateralConstraint | ConstraintRow) -> Ratio:
        """The reaction of a closed bound; not negative while it is closed."""
        row = bound.row if isinstance(bound, UnilateralConstraint) else bound
        return row.sign * self.model.reactions.multiplier(self.rows[row.name])

    def load(self, rub: DryFriction) -> Ratio:
        """What multiplies the coefficient of a friction; 1 where the coefficient is a force itself."""
        if not rub.load:
            return self.model.field.one
        return resultant(self.model, rub, self.rows, self.samples.is_negative)

    def coefficient(self, rub: DryFriction, direction: int, *, at_rest: bool) -> Ratio:
        g = self.model.geometry
        values: dict[str, Ratio] = {}
        for name, measure in rub.measures:
            values[name] = measure.value(g)
            values[f"rate({name})"] = self.model.rate(values[name])
        return g.apply(rub.coefficient(direction, at_rest=at_rest), values)

    def friction(self, rub: DryFriction) -> Ratio:
        """The friction force along the slip of a rub: what holds it, or what resists it; none where it is open."""
        state = self.mode.states.get(rub.name)
        if state is None:
            return self.model.field.zero
        if rub.name in self.dropped:
            raise CannotAnswer(
                Message("only the sum of the friction forces of {contact} is determined", contact=rub.row.connection)
            )
        if state == 0:
            return self.model.reactions.multiplier(self.rows[rub.name])
        return -state * self.coefficient(rub, state, at_rest=False) * self.load(rub)

    # -- what the phase lives on --------------------------------------------------------------
    @carried_property
    def watches(self) -> tuple[PhaseWatch, ...]:
        """Everything that stays positive while the phase lasts."""
        _ = self._course  # what it takes to be positive along the motion is watched
        found: list[PhaseWatch] = []
        states = self.mode.states
        for name in [row.name for row in self.base.constraint_rows if row.unilateral] + list(self.bounds):
            if name in self.mode.closed:
                found.append(PhaseWatch("opens", name, self.normal(self.rows[name])))
                found += [PhaseWatch("edge ends", name, x) for x in self.spans(name)]
            elif name in self.bounds:
                found.append(
                    PhaseWatch("touches", name, self._nearness(self.bounds[name].row), within=self.spans(name))
                )
            elif (row := self.closing_again.get(name)) is not None:
                found.append(PhaseWatch("touches", name, self._nearness(row)))
        for name, acts in self.mode.acting:  # neither force nor velocity jumps at a border
            short = self.gap(self.base.borders[name])
            found.append(PhaseWatch("opens", name, -short) if acts else PhaseWatch("touches", name, short))
        for row in self.base.constraint_rows:
            if row.pressed and not (pressed := row.pressed.sign * self.normal(row)).is_zero():
                found.append(PhaseWatch("changes sign", row.pressed.is_kept(row.connection), pressed))
        for name, state in states.items():
            rub = self.dry_friction[name]
            if state:
                found.append(PhaseWatch("slip ends", name, state * self.state.rate(rub.row.measure)))
            elif name not in self.dropped:
                found += self._limits(rub)
        for name, x in self.pressed.items():  # behind it the size of N is -N
            side = Message("{contact} is pressed on this side", contact=self.dry_friction[name].row.connection)
            found.append(PhaseWatch("changes sign", relation_text(tidy(x), "="), x, purpose=side))
        for v in self.base.validities:
            room = v.sign * (self.state.value(v.measure) - self.model.geometry.scalar(v.limit))
            end = v.end or Message("it is no longer so that {purpose}", purpose=v.purpose)
            found.append(PhaseWatch("is left", end, room, purpose=v.purpose))
        for x in map(self.model.express, self.samples.assumed):
            if self.model.field.ingredients(x) & {c.index for c in self.model.coordinates}:
                found.append(PhaseWatch("changes sign", relation_text(tidy(x), "="), x))  # and with it the formulas
        return tuple(found)

    @carried_property
    def pressed(self) -> dict[str, Ratio]:
        """The loads of the frictions that may be pressed either way, by name: positive while they are on this side."""
        names = [name for name in self.mode.states if name not in self.dropped]
        rubs = {name: self.dry_friction[name] for name in names}
        loads = {n: self.load(rub) for n, rub in rubs.items() if acts_either_way(self.model, rub, self.rows)}
        return {name: x for name, x in loads.items() if not x.is_zero()}

    @cached_property
    def closing_again(self) -> dict[str, ConstraintRow]:
        """Ideal strings that are slack and rolling contacts that have lifted off, as far as it is known when they close
        again: held at a length that has a formula, and no other row of the connection is held with them."""
        found: dict[str, ConstraintRow] = {}
        together = {f"{row.connection}.{row.needs}" for row in self.base.constraint_rows if row.needs}
        for row in ideal_bounds(self.base):
            if row.name in self.mode.closed or row.name in together:
                continue
            straight = distance_of(row) or straight_of(row)
            length = self.placed.lengths.get(row.name) if row.target is None else row.target
            if straight is not None and length is not None:
                found[row.name] = replace(row, measure=straight, target=length)
        return found

    def spans(self, name: str) -> tuple[Ratio, ...]:
        """How far the place of a bound is from the ends of the edge on which it lies; none for what has no ends."""
        g, found = self.model.geometry, list[Ratio]()
        for span in self.bounds[name].within if name in self.bounds else ():
            measure: Any = span.measure
            value: Ratio = measure.value(g)
            found += [] if span.low is None else [value - g.scalar(span.low)]
            found += [] if span.high is None else [g.scalar(span.high) - value]
        return tuple(x for x in found if not x.is_zero())

    def _limits(self, rub: DryFriction) -> list[PhaseWatch]:
        """A friction T that resists a growing measure is negative, and holds while -T <= mu N; else while T <= mu N."""
        if rub.across is not None:
            return [PhaseWatch("slips", rub.name, self._inside(rub), 1)]
        held = self.friction(rub)
        together = [rub, *(self.dry_friction[name] for name in self.shared.get(rub.name, ()))]
        up = down = self.model.field.zero
        for one in together:
            up = up + self.coefficient(one, 1, at_rest=True) * self.load(one)
            down = down + self.coefficient(one, -1, at_rest=True) * self.load(one)
        return [PhaseWatch("slips", rub.name, up + held, 1), PhaseWatch("slips", rub.name, down - held, -1)]

    def _inside(self, rub: DryFriction) -> Ratio:
        """How far the force of a friction that sticks in a plane is inside its cone, c N - |T|; of squares where T
        changes with the motion."""
        forces = [self.model.reactions.multiplier(self.rows[row.name]) for row in rub.rows]
        square = self.model.field.lowest_terms(sum((x * x for x in forces), self.model.field.zero))
        limit = self.coefficient(rub, 1, at_rest=True) * self.load(rub)
        if self.model.field.ingredients(square) & self.model.moving:
            return limit * limit - square
        return limit - self.state.sqrt(square)

    def base_row(self, name: str) -> ConstraintRow:
        """A row of the system, or of its bounds, whether it is held now or not."""
        if name in self.closing_again:
            return self.closing_again[name]
        rows = (*self.base.constraint_rows, *(b.row for b in self.base.bounds), *self.base.borders.values())
        return next(row for row in rows if row.name == name)

    def _nearness(self, row: ConstraintRow) -> Ratio:
        """A gap, or that of the squares of a distance and its limit: a polynomial where the distance is a root."""
        if not self.is_by_squares(row):
            return self.gap(row)
        assert isinstance(row.measure, Distance)
        assert row.target is not None
        value, target = row.measure.value(self.model.geometry), self.model.geometry.scalar(row.target)
        return row.sign * self.model.field.lowest_terms(value * value - target * target)

    def is_by_squares(self, row: ConstraintRow) -> bool:
        """Whether a gap is that of the squares of a distance, which is a root of the coordinates, and of its limit."""
        if not isinstance(row.measure, Distance) or row.target is None:
            return False
        f, value = self.model.field, row.measure.value(self.model.geometry)
        return any(f.generators[g].kind == "root" and not f.is_constant_generator(g) for g in value.generators())

    def gap(self, row: ConstraintRow) -> Ratio:
        """How far a bound is from being closed."""
        measure: Any = row.measure
        value: Ratio = measure.value(self.model.geometry)
        target = self.model.field.zero if row.target is None else self.model.geometry.scalar(row.target)
        return row.sign * (value - target)


def distance_of(row: ConstraintRow) -> Distance | None:
    """The distance whose changes a row holds: of a link, or of a string that runs straight from point to point."""
    measure = row.measure
    if isinstance(measure, Combination) and len(measure.terms) == 1 and measure.terms[0][0] == number(1):
        measure = measure.terms[0][1]
    if isinstance(measure, Lead) and measure.rho == ZERO:
        return Distance(measure.start, measure.end)
    return measure if isinstance(measure, Distance) else None


def straight_of(row: ConstraintRow) -> Combination | None:
    """The length of a string whose ends run up and down, or along guides, and of what its wheels take: displacements
    and angles alone, whose changes a row holds."""
    measure = row.measure
    if not isinstance(measure, Combination):
        return None
    return measure if all(isinstance(part, (Displacement, Angle)) for _factor, part in measure.terms) else None


def has_lines(system: System) -> bool:
    """Whether named measures bring coordinates of their own, lengths and angles of lines."""
    return not all(isinstance(m, (Displacement, Angle)) for m in system.measures.values())


def without_rows(system: System, shared: Mapping[str, Sequence[str]]) -> System:
    """Without rows that hold what others hold, by these: each says for which it stands."""
    if not shared:
        return system
    out = {name for names in shared.values() for name in names}
    left = [row for row in system.constraint_rows if row.name not in out]
    told = tuple(replace(row, stands_for=tuple(shared[row.name])) if row.name in shared else row for row in left)
    return replace(system, constraint_rows=told)
