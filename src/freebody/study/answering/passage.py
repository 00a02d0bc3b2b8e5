"""Motions from the start to an event, as quantities count along them: in formulas, and in numbers.

A motion is a sequence of phases, each with one law; a smooth motion has one phase. An impact, or a contact that opens,
adds a phase of no length behind the event where the value just after it is meant.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from itertools import pairwise
from typing import Any

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.expression import number
from freebody.language.sentences import Message
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, Direction, Point
from freebody.numeric.jets import Array
from freebody.numeric.snapshot import Snapshot
from freebody.questions.base import Described, Quantity
from freebody.questions.energy import Energy, mixes, resists
from freebody.questions.motion import OfPoint
from freebody.study.answering.finding import Elements
from freebody.study.answering.formula_phase import FormulaPhase
from freebody.study.answering.over_time import FORCE_CHANGES, by_momentum, over_time
from freebody.study.answering.turns_in_space import turns_in_formulas, turns_in_numbers
from freebody.study.setup import Setup
from freebody.symbolic.conditions import Condition, require
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.reached import Reached
from freebody.symbolic.state import SymbolicState, law_polynomial
from freebody.symbolic.turned_ways import turned_way
from freebody.symbolic.unknowns import Coordinate
from freebody.system.system import System

_WORK_INSTEAD = Message("that is counted where contacts or dry friction are; here ask for the work of a load")
_TURNS_BACK = CannotAnswer(
    Message(
        "it turns back on the way: ask for the distance travelled until its rate is zero, and for that from there on"
    )
)
_TURNED = 1e-12  # rad: less is round-off
_CURVED = Message("the point moves on a curve, and the length of its path has no closed form here")
_CURVED_OR_BACK = CannotAnswer(Message("the point moves on a curve or turns back, so the length was not checked"))
_ROUND_OFF = 1e-9  # of the product of two rates
_ASIDE = 1e-8  # of a path: less is no curve
_N_ON_THE_WAY = 3  # steps of a path that tell whether it is straight


def _no_load(name: str) -> Message:
    return Message("{load} is no load; the work of a constraint is asked as power", load=name)


def drivers(system: Described) -> set[str]:
    """The connections that hold something at a function of time."""
    return {row.connection for row in system.constraint_rows if row.general is not None or row.is_driven}


def resistances(system: Described) -> list[str]:
    """The loads that resist motion and only take energy: drag, dampers, laws like them. Raises CannotAnswer where what
    a load takes is not told apart from what it stores."""
    for name in system.loads:
        if mixes(system, name):
            raise CannotAnswer(
                Message("{load} stores energy and takes it: write what resists as a load of its own", load=name)
            )
    return [name for name in system.loads if resists(system, name)]


NO_SWINGS = Message("half swings are counted where friction alone ends each motion of one coordinate")
_AT_A_TURN = 1e-3  # of the speed between: slower is as good as at rest


@dataclass(frozen=True)
class FormulaPassage:
    """In formulas. system: without what only friction pushes; numbers: an element of the answer at all samples."""

    system: System
    phases: Sequence[FormulaPhase]
    elapsed: Ratio | None
    why_no_time: str
    elements: Callable[[Quantity, SymbolicState], Elements]
    numbers: Callable[[Ratio], Array]
    sqrt: Callable[[Ratio], Ratio]
    # coordinates and speeds that stay as they start
    still: Mapping[int, Ratio] = field(default_factory=dict[int, Ratio], kw_only=True)
    # what is counted needs: that it turns back as often as was counted
    needs: list[tuple[Ratio, str]] = field(default_factory=list[tuple[Ratio, str]], kw_only=True)
    # of a path that is so many times the way of a coordinate: R and this
    arms: list[tuple[Ratio, Coordinate]] = field(default_factory=list[tuple[Ratio, Coordinate]], kw_only=True)
    # the values at which what was counted turns back
    turns: list[Ratio] = field(default_factory=list[Ratio], kw_only=True)

    def counted_so(self, here: Callable[[Ratio], Ratio]) -> list[Condition]:
        """What was counted needs. here: takes an element to where it is told."""
        why = Message("how often it turns back")
        told = (require(here(x), relation, why)[0] for x, relation in self.needs)
        return [condition for condition in told if condition is not None]

    def time(self) -> Ratio:
        if self.elapsed is None:
            raise CannotAnswer(self.why_no_time)
        return self.elapsed

    def change(self, measure: Measure) -> Ratio:
        x = self.phases[-1].at_end(measure) - self.phases[0].at_begin(measure)
        return x.field.lowest_terms(x)

    def work(self, load: str) -> Ratio:
        """Of a load that is a function of its own measure: minus the change of its potential. Of the only one that is
        not, and of the only driver, what T + V gains."""
        before, after, _is_balance = self.energies(load)
        return before.field.lowest_terms(after - before)

    def energies(self, load: str) -> tuple[Ratio, Ratio, bool]:
        """At the start and at the end, of which the work of a load is the difference: minus its potential, or T + V of
        all else, then True."""
        if all(p.load != load for p in self.system.applied_loads):
            if drivers(self.system) != {load} or (found := self._balance([load])) is None:
                raise CannotAnswer(_no_load(load))
            return (*found, True)
        try:
            return (*self._potentials([load], -1), False)
        except CannotAnswer:
            found = self._balance([load])
            if found is None:
                raise
            return (*found, True)

    def _balance(self, loads: Sequence[str]) -> tuple[Ratio, Ratio] | None:
        """T, and V of all loads but some; None where not these alone do work: where dry friction does, something is led
        through time, or one phase follows another."""
        first = self.phases[0]
        if len(self.phases) > 1 or self.system.dry_friction or drivers(self.system) - {*loads}:
            return None
        try:
            others = list(dict.fromkeys(p.load for p in self.system.applied_loads if p.load not in loads))
            stored = self._potentials(others, 1)
        except CannotAnswer:
            return None
        moving = [self.elements(Energy("kinetic"), state) for state in (first.begin, first.end)]
        before, after = (first.told(x) + v for x, v in zip(moving, stored, strict=True) if not isinstance(x, tuple))
        return before.field.lowest_terms(before), after.field.lowest_terms(after)

    def _potentials(self, loads: Sequence[str], sign: int) -> tuple[Ratio, Ratio]:
        """The potential energy of some loads, with a sign, at the start and at the end."""
        first, last = self.phases[0], self.phases[-1]
        before = after = first.told(first.begin.model.field.zero)
        for push in (p for load in loads for p in self.system.applied_loads if p.load == load):
            law_polynomial(push)
            before = before + sign * first.told(first.begin.potential(push))
            after = after + sign * last.told(last.end.potential(push))
        return before, after

    def half_swings(self) -> Ratio:
        raise CannotAnswer(NO_SWINGS)

    def heat(self, of: str) -> Ratio:
        """Of what resists, where nothing rubs: what T + V of all else has lost."""
        resisting = [] if of else resistances(self.system)
        found = self._balance(resisting) if resisting else None
        if found is None:
            raise CannotAnswer(_WORK_INSTEAD)
        return found[0].field.lowest_terms(found[0] - found[1])

    def revolutions(self, body: str) -> Ratio:
        """Angles turned through, without sign, over a full turn; in every phase the body turns one way only."""
        if self.system.space:
            return turns_in_formulas(body, self.phases, self.numbers, self.sqrt)
        why = Message(
            "which way {body} turns depends on the parameter values; ask for the change of its angle", body=body
        )
        gone = self._gone(Angle(body), both_ways(body), why)
        return gone.field.lowest_terms(gone / (2 * gone.field.pi))

    def travelled(self, measure: Measure) -> Ratio:
        """The way without sign; in every phase the measure goes one way only."""
        return self._gone(measure, _TURNS_BACK, Message("which way it goes depends on the parameter values"))

    def length(self, point: Point) -> Ratio:
        """Of the path of a point, phase by phase."""
        axes = along_axes(point, in_space=bool(self.system.space))
        total = sum((self._length_in(phase, axes) for phase in self.phases), self.phases[0].told_zero)
        return total.field.lowest_terms(total)

    def _length_in(self, phase: FormulaPhase, axes: Sequence[Displacement]) -> Ratio:
        """Where it runs as a point on a circle does, |v| = R |u|, or straight on, v = u e with a constant direction e,
        or is as fast all the time, v . a = 0."""
        model = phase.begin.model
        state, f = SymbolicState(model), model.field
        rates = [(m, u) for m in axes if not (u := f.lowest_terms(f.follow(state.rate(m), self.still))).is_zero()]
        if not rates:
            return phase.told_zero
        if (found := self._by_arc(phase, [u for _m, u in rates])) is not None:
            return found
        first, along = rates[0]
        shares = [f.lowest_terms(u / along) for _m, u in rates]
        if not any(f.ingredients(x) & model.moving for x in shares):
            why = Message("which way it goes depends on the parameter values")
            size = phase.begin.sqrt(f.lowest_terms(sum((x * x for x in shares), f.zero)))
            return self._gone_in(phase, first, _TURNS_BACK, why) * phase.told(size)
        power = sum((u * f.follow(state.acceleration(m), self.still) for m, u in rates), f.zero)
        if phase.time is None or not f.lowest_terms(power).is_zero():
            raise CannotAnswer(_CURVED)
        square = sum((phase.begin.rate(m) ** 2 for m in axes), f.zero)
        return phase.told(phase.begin.sqrt(f.lowest_terms(square)) * phase.time)

    def _by_arc(self, phase: FormulaPhase, rates: Sequence[Ratio]) -> Ratio | None:
        """R times the way of the one coordinate that moves, where all rates are its own, times what makes a constant R
        together."""
        model, f = phase.begin.model, phase.begin.model.field
        moving = [c for c in model.coordinates if any(c.speed in f.ingredients(u) for u in rates)]
        if len(moving) != 1:
            return None
        (c,) = moving
        arms = [f.lowest_terms(u / f.variable(c.speed)) for u in rates]
        square = f.lowest_terms(sum((x * x for x in arms), f.zero))
        if f.ingredients(square) & model.moving:
            return None
        gone = self._by_turns(phase, f.variable(c.index), Message("which way it goes depends on the parameter values"))
        arm = phase.begin.sqrt(square)
        self.arms.extend([] if arm.is_one() else [(arm, c)])
        return None if gone is None else gone * phase.told(arm)

    def _by_turns(self, phase: FormulaPhase, value: Ratio, depends: Message) -> Ratio | None:
        """The way of what moves in a phase: |q1 - q0| + |q2 - q1| + ... from one turn to the next. None where nothing
        tells where it turns."""
        way = None if phase.turned is None else phase.turned(value)
        if way is None:
            return None
        f = phase.begin.model.field
        places = [phase.begin.here(value), *way.turns, phase.end.here(value)]
        pairs = Counter((id(a), id(b)) for a, b in pairwise(places))
        known, zero = {id(x): x for x in places}, phase.told_zero
        sense, total = 0.0, zero
        for k, (a, b) in enumerate(pairwise(places)):
            n = pairs.pop((id(a), id(b)), 0)
            if not n:
                continue
            x = phase.told(f.lowest_terms(known[id(b)] - known[id(a)]))
            if not k:
                sense = float(np.sign(self.numbers(x)[0]))
                if np.isnan(sense):
                    raise CannotAnswer(depends)
                self.needs.extend([(int(sense) * x, ">=")] if sense else [])
            total = total + n * int(sense) * (-1) ** k * x
        self.needs.extend((phase.told(x), relation) for x, relation in way.needs)
        self.turns.extend(map(phase.told, way.turns))
        return total

    def _gone(self, measure: Measure, both_ways: CannotAnswer, depends: Message) -> Ratio:
        """How far a measure has gone, phase by phase."""
        gone = [self._gone_in(phase, measure, both_ways, depends) for phase in self.phases]
        return gone[0].field.lowest_terms(sum(gone[1:], gone[0]))

    def _gone_in(self, phase: FormulaPhase, measure: Measure, both_ways: CannotAnswer, depends: Message) -> Ratio:
        """How far a measure has gone in one phase. Where it turns back for some parameters, and not for the first, that
        it goes on at the end as at the beginning is taken to be so."""
        model = phase.begin.model
        value = model.field.lowest_terms(model.field.follow(model.value_of(measure), self.still))
        if (found := self._by_turns(phase, value, depends)) is not None:
            return found
        begins, ends = (self.numbers(x) for x in phase.rates(measure))
        goes_on = ~(begins * ends < -_ROUND_OFF)
        if not goes_on[:1].all():
            raise both_ways
        if not goes_on.all():
            rate = phase.end.rate(measure)
            phase.begin.model.samples.take(rate if begins[0] > 0 else -rate)
        x = phase.at_end(measure) - phase.at_begin(measure)
        values = self.numbers(x)[goes_on]
        signs = set(np.sign(values[np.abs(values) > _TURNED]).tolist())
        if not signs and not self._stays(phase, measure):
            raise both_ways  # there and back, as over a turn from one dead point to the same
        if len(signs) > 1:
            raise CannotAnswer(depends)
        return -x if signs == {-1.0} else x

    def _stays(self, phase: FormulaPhase, measure: Measure) -> bool:
        model = phase.begin.model
        return model.field.lowest_terms(model.field.follow(SymbolicState(model).rate(measure), self.still)).is_zero()

    def integral(self, quantity: Quantity) -> Elements:
        """Over the time, of what stays the same or is given in it, phase by phase."""
        if len(self.phases) > 1:
            raise CannotAnswer(FORCE_CHANGES)
        first = self.phases[0]
        model = first.begin.model
        x = self.elements(quantity, SymbolicState(model))
        if not isinstance(x, tuple) and (found := by_momentum(x, first, self.elapsed)) is not None:
            return found
        return over_time(x, model, self.time())

    def there(self, quantity: Quantity) -> Elements:
        last = self.phases[-1]
        x = self.elements(quantity, last.end)
        return tuple(map(last.told, x)) if isinstance(x, tuple) else last.told(x)

    def started(self, quantity: Quantity) -> Elements:
        first = self.phases[0]
        x = self.elements(quantity, first.begin)
        return tuple(map(first.told, x)) if isinstance(x, tuple) else first.told(x)


def smooth_passage(
    setup: Setup,
    reached: Reached,
    elements: Callable[[Quantity, SymbolicState], Elements],
    there: SymbolicState | None = None,
) -> FormulaPassage:
    """A motion of one phase. there: the state at its end, where it is made otherwise."""
    there = there or SymbolicState(setup.model, setup.motion.known_at(reached))
    turned = partial(turned_way, setup.motion, reached=reached)
    phase = FormulaPhase(setup.start_instant, there, lambda x: x, reached.time, turned)
    return FormulaPassage(
        setup.system,
        (phase,),
        reached.time,
        reached.why_no_time,
        elements,
        lambda x: np.array(setup.model.samples.at_starts(x), dtype=np.float64),
        setup.start_instant.sqrt,
        still=setup.motion.integrals.resting,
    )


def along_axes(point: Point, *, in_space: bool) -> tuple[Displacement, ...]:
    """Where a point is on the axes of the ground."""
    zero, one = number(0), number(1)
    n = 3 if in_space else 2
    axes = (Direction(GROUND, tuple(one if j == k else zero for j in range(n))) for k in range(n))
    return tuple(Displacement(point, Point(GROUND, (zero,) * n), axis) for axis in axes)


def straight_through(places: Sequence[Sequence[float]]) -> float:
    """The length of a path from its points, with those at which it turns back, which lie on a line. Raises CannotAnswer
    where they do not: how far it gets between them is not known."""
    steps = np.diff(np.asarray(places, dtype=np.float64), axis=0)
    lengths = np.linalg.norm(steps, axis=1)
    total = float(lengths.sum())
    if total <= _TURNED:  # a phase without length
        return total
    along = steps[int(np.argmax(lengths))] / lengths.max()
    aside = np.linalg.norm(steps - np.outer(steps @ along, along), axis=1)
    if len(steps) < _N_ON_THE_WAY or float(aside.max()) > total * _ASIDE + _TURNED:
        raise _CURVED_OR_BACK
    return total


def gone_through(values: Sequence[float], both_ways: CannotAnswer) -> float:
    """The way of a measure, from its values along one phase. Raises CannotAnswer where it goes both ways: how far it
    gets between the instants is not known."""
    steps = np.diff(np.asarray(values, dtype=np.float64))
    least = _ROUND_OFF * max(1.0, float(np.abs(values).max(initial=0.0)))
    if steps.min(initial=0.0) < -least and steps.max(initial=0.0) > least:
        raise both_ways
    return float(np.abs(steps).sum())


def both_ways(body: str) -> CannotAnswer:
    """The reason why revolutions are not counted."""
    return CannotAnswer(
        Message("{body} turns one way and then the other; ask for the change of its angle instead", body=body)
    )


@dataclass(frozen=True)
class NumericPassage:
    """A motion in numbers, whatever its phases. begin, now: the instants at its ends, before an impact with which it
    begins. at_end, at_begin: a quantity at its ends; lost: [J] what dry friction and impacts have taken, in one
    connection or (no name) in all; work_done: [J] of a load, else what its potential has lost; ways: instants on the
    way, phase by phase."""

    system: Described
    begin: Snapshot
    now: Snapshot
    at_end: Callable[[Quantity], Any]
    lost: Callable[[str], float]
    work_done: Callable[[str], float] | None = None
    ways: Callable[[], Iterable[Sequence[Snapshot]]] | None = None
    at_begin: Callable[[Quantity], Any] | None = None
    over_time: Callable[..., Any] | None = None
    turned: Callable[[Sequence[Measure]], Sequence[Snapshot]] | None = None  # instants at which measures turn back
    takes_energy: frozenset[str] = frozenset()  # connections that rub or collide
    is_smooth: bool = False  # one law all the way, along which `over_time` integrates

    def time(self) -> float:
        return self.now.t

    def change(self, measure: Measure) -> float:
        return self.now.value(measure) - self.begin.value(measure)

    def work(self, load: str) -> float:
        if load not in self.system.loads and load not in drivers(self.system):
            if load not in self.takes_energy:
                raise CannotAnswer(_no_load(load))
            return -self.lost(load)
        if self.work_done is not None:
            return self.work_done(load)
        return self.by_energies(load)

    def by_energies(self, load: str) -> float:
        """The work of a load by its potential, or of the only driver by the balance of energy."""
        if load in drivers(self.system):
            return self._work_of_only_driver(load)
        return sum(self.begin.potential(p) - self.now.potential(p) for p in self.system.applied_loads if p.load == load)

    def _work_of_only_driver(self, name: str) -> float:
        """What T + V gains, and what friction and impacts take on the way."""
        if drivers(self.system) != {name}:
            raise CannotAnswer(_no_load(name))
        for push in self.system.applied_loads:
            law_polynomial(push)  # has a potential
        moving = self.there(Energy("kinetic")) - self.started(Energy("kinetic"))
        stored = sum(self.now.potential(p) - self.begin.potential(p) for p in self.system.applied_loads)
        return float(moving + stored + self.lost(""))

    def heat(self, of: str) -> float:
        return self.lost(of)

    def revolutions(self, body: str) -> float:
        if self.ways is None:
            raise CannotAnswer(Message("how often {body} turns is not counted here", body=body))
        if self.begin.reference.system.space:
            return turns_in_numbers(body, self.ways())
        angle, why = Angle(body), both_ways(body)
        if self.turned is not None:
            return self.travelled(angle) / (2.0 * np.pi)
        return sum(gone_through([s.value(angle) for s in instants], why) for instants in self.ways()) / (2.0 * np.pi)

    def length(self, point: Point) -> float:
        axes = along_axes(point, in_space=bool(self.begin.reference.system.space))
        if self.is_smooth and self.over_time is not None:
            halts = () if self.turned is None else [s.t for s in self.turned(axes)]
            return float(self.over_time(OfPoint(point, 1, size=True), halts))
        if self.ways is None:
            raise CannotAnswer(Message("the way is not counted here"))
        turns = () if self.turned is None else self.turned(axes)
        ways = (self._with_turns(instants, turns) for instants in self.ways())
        return sum(straight_through([[s.value(m) for m in axes] for s in instants]) for instants in ways)

    @staticmethod
    def _with_turns(instants: Sequence[Snapshot], turns: Sequence[Snapshot]) -> list[Snapshot]:
        """Instants of one phase in their order, with those at which something turns back in it."""
        begin, end = instants[0].t, instants[-1].t
        return sorted((*instants, *(s for s in turns if begin < s.t < end)), key=lambda s: s.t)

    def half_swings(self) -> float:
        """Runs of instants between which all goes on the same way: where it turns the velocities are against those
        before."""
        if self.ways is None:
            raise CannotAnswer(NO_SWINGS)
        n, before = 0, np.zeros(0)
        for instants in self.ways():
            fastest = max((float(np.abs(s.v).max(initial=0.0)) for s in instants), default=0.0)
            for s in instants:
                if np.abs(s.v).max(initial=0.0) > _AT_A_TURN * fastest > 0.0:
                    n += not len(before) or float(before @ s.v) < 0.0
                    before = s.v
        return float(n)

    def travelled(self, measure: Measure) -> float:
        if self.ways is None:
            raise CannotAnswer(Message("the way is not counted here"))
        if self.turned is None:
            return sum(gone_through([s.value(measure) for s in instants], _TURNS_BACK) for instants in self.ways())
        turns = self.turned((measure,))
        ways = (self._with_turns(instants, turns) for instants in self.ways())
        return sum(float(np.abs(np.diff([s.value(measure) for s in instants])).sum()) for instants in ways)

    def integral(self, quantity: Quantity) -> Any:
        if self.over_time is None:
            raise CannotAnswer(Message("what is counted on the way was not checked in numbers"))
        return self.over_time(quantity)

    def there(self, quantity: Quantity) -> Any:
        return self.at_end(quantity)

    def started(self, quantity: Quantity) -> Any:
        return quantity.value(self.system, self.begin) if self.at_begin is None else self.at_begin(quantity)


def smooth_numbers(
    setup: Setup,
    start: Snapshot,
    event: Snapshot,
    work: Callable[[str], float],
    links: Sequence[Snapshot] = (),
    over_time: Callable[..., Any] | None = None,
    turned: Callable[[Sequence[Measure]], Sequence[Snapshot]] | None = None,
) -> NumericPassage:
    """A motion of one phase. work: the integral of the power of a load up to the event; links: instants on the way;
    over_time: the integral of a quantity, with instants at which its slope may jump; turned: instants at which
    measures turn back."""

    def lost(of: str) -> float:
        resisting = [] if of else resistances(setup.system)
        if not resisting:
            raise CannotAnswer(_WORK_INSTEAD)
        return -sum(work(load) for load in resisting)

    def at_end(quantity: Quantity) -> Any:
        return quantity.value(setup.system, event)

    return NumericPassage(
        setup.system,
        start,
        event,
        at_end,
        lost,
        work,
        lambda: ((start, *links, event),),
        over_time=over_time,
        turned=turned,
        is_smooth=True,
    )
