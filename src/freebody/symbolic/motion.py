"""Motion in closed form, for one degree of freedom or coordinates that move independently.

What moves by itself has a law in the time (`laws/`): constant acceleration, harmonic, damped, resisted, given in time.
Otherwise there is the first integral of energy,

    d(M u^2/2 + V)/dt = 0            u^2 = (M0 u0^2 + 2 V0 - 2 V)/M

Every root that solves an equation but not the problem is reported with the reason.
"""

from __future__ import annotations

from collections.abc import Generator
from contextlib import contextmanager, suppress
from functools import cached_property

from freebody.errors import CannotAnswer, NeverHappens, NotReached
from freebody.language.notation import compared, reworded
from freebody.language.sentences import Message
from freebody.questions.reading import QuestionEvent
from freebody.symbolic.closure import Closure
from freebody.symbolic.coupled import CoupledMotion, coupled_with
from freebody.symbolic.field import Ratio
from freebody.symbolic.first_integrals import FirstIntegrals, is_driven
from freebody.symbolic.laws import Freely, LawInstant, MotionLaw, first, law_of
from freebody.symbolic.laws.damped import Damped
from freebody.symbolic.laws.quadratic_resistance import Resisted
from freebody.symbolic.laws.uniform import UniformLaw
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.reached import HOLDS_ALWAYS, HOLDS_ONCE, Reached
from freebody.symbolic.signs import Sign, sign_of
from freebody.symbolic.start import StartState
from freebody.symbolic.tidy import tidy
from freebody.symbolic.uniform_passage import passage_at
from freebody.symbolic.unknowns import Coordinate
from freebody.symbolic.way import EnergyPath
from freebody.symbolic.zeros import solve_linear, without_root, zeros_of

_MOST_PLACES = 2  # at which a measure has a value that is not linear in its coordinate


class SmoothMotion:
    """The closed-form motion of a model from its start."""

    def __init__(self, model: SymbolicModel, start: StartState) -> None:
        self.model = model
        self.start = start
        self.field = model.field
        self.integrals = FirstIntegrals(model, start)
        self._on_one_side = False

    # -- the event ----------------------------------------------------------------------------
    def reach(self, event: QuestionEvent) -> Reached:
        """The first time after the start at which a measure or its rate reaches a value; where it has the value at the
        start, the next time. Raises NeverHappens where it is proved that there is none."""
        value = self.model.value_of(event.measure)
        target = self.model.geometry.scalar(event.value)
        place = value
        if event.order == 1:
            value = self.model.rate(value)
        begins = self.field.follow(self.model.in_independent_speeds(value - target), self.start.values).is_zero()
        if self.stands_still and not self.field.ingredients(value) & self._in_time:
            raise NeverHappens(
                HOLDS_ALWAYS
                if begins
                else Message(
                    "it starts at rest in an equilibrium, and stays there (an unstable equilibrium is left only if "
                    "something disturbs it)"
                )
            )
        if event.order == 1:
            reached = self._reach_rate(value, target, place, event.text)
        else:
            reached = self._reach_place(value, target, event)
        if begins:
            words = Message("'{event}' holds at the start as well (t = 0); this is the next time", event=event.text)
            reached.notes.insert(0, reworded(words, compared(tidy(value), "=", tidy(target))))
        return reached

    def at_clock(self, time: Ratio | None) -> Reached:
        """An instant by the clock; None: as the time grows without end. Then what does not tend to anything has no
        value there."""
        f = self.field
        if time is not None:
            return Reached(time, None, time, f.one, conditions=[(time, ">=")])
        found, latest = dict[int, Ratio](), f.zero
        for c in self.model.coordinates:
            taken = list(self.model.samples.assumed)
            law = None if self.stands_still else self.law_of(c, takes_side=True)
            if law is not None and law.tends_alike:
                self.model.samples.assumed[:] = taken  # on which side a sign is that chooses the law says nothing here
            limit = None if law is None else law.limit
            if self.stands_still:
                found |= {c.index: self.start.of(c.index), c.speed: f.zero}
            elif limit is not None:
                latest = latest + limit.time
                found |= {} if limit.place is None else {c.index: f.lowest_terms(limit.place)}
                found |= {} if limit.rate is None else {c.speed: f.lowest_terms(limit.rate)}
        return Reached(None, None, f.zero, f.one, limits=found, settled=f.lowest_terms(latest + 1))

    def known_at(self, reached: Reached) -> dict[int, Ratio]:
        """The coordinates and speeds at an event, as far as they have closed forms, and the time: a coordinate that
        moves by itself is where its own law has brought it by then, one that nothing depends on keeps its momentum."""
        if reached.limits is not None:
            return reached.limits
        values = self._independent_at(reached)
        places = {c.index for c in self.model.coordinates}
        if self.model.dependent and places <= values.keys() and self._has_solved_loops:
            at = {k: x for k, x in values.items() if k in places or k == self.field.index(self.field.time)}
            values = self.closure.at(at) | values
        return values

    @cached_property
    def closure(self) -> Closure:
        return Closure(self.model)

    @cached_property
    def _has_solved_loops(self) -> bool:
        try:
            self.closure.at({})
        except (CannotAnswer, ZeroDivisionError):
            return False
        return True

    def _independent_at(self, reached: Reached) -> dict[int, Ratio]:
        values = dict(reached.values)
        if (c := reached.coordinate) is not None and reached.speed is not None and len(self.model.coordinates) > 1:
            values = self.integrals.speeds_at(c, reached.at, reached.speed) | values
            values = self.integrals.places_at(c, reached.at, reached.time) | values
        if reached.time is None:
            return values
        values[self.field.index(self.field.time)] = reached.time
        takes_side = reached.coordinate is None or self._takes_side
        for c in self.model.coordinates:
            if self.stands_still:
                values |= {c.index: self.start.of(c.index), c.speed: self.field.zero}
            law = None if c.index in values else self.law_of(c, takes_side=takes_side)
            if law is not None and law.has_course:
                values[c.index], values[c.speed] = map(self.field.lowest_terms, law.at(reached.time))
            elif c.index not in values and (coupled := self.coupled(c)) is not None:
                values = coupled.at(reached.time) | values
        return values

    def coupled(self, c: Coordinate) -> CoupledMotion | None:
        """How a coordinate moves with those to which it is coupled linearly."""
        return coupled_with(self.model, self.start, c, self.acceleration)

    @cached_property
    def stands_still(self) -> bool:
        """True where it is proved that nothing ever moves: no speed and no acceleration at the start, nothing that
        depends on time, and laws smooth enough for the motion to be unique (Lipschitz; no root or sign of zero)."""
        f, model = self.field, self.model
        if any(not self.start.of(c.speed).is_zero() for c in model.coordinates) or is_driven(model):
            return False
        now = {k: x for k, x in self.start.values.items() if k != f.index(f.time)}
        try:
            accelerations = [model.in_independent_speeds(a) for a in model.dynamics.solved_accelerations.values()]
            for a in accelerations:
                for g in a.generators():
                    kind, (name, argument) = f.generators[g].kind, f.arguments.get(g, ("", f.one))
                    if kind == "root" and f.follow(f.radicand(g), now).is_zero():
                        return False
                    if name == "sign" and f.follow(argument, now).is_zero():
                        return False
            return all(f.follow(a, now).is_zero() for a in accelerations)
        except (CannotAnswer, ZeroDivisionError):
            return False

    @property
    def _in_time(self) -> set[int]:
        """The generators of the time and of given functions of it."""
        return {g for g, generator in self.field.generators.items() if generator.kind == "time"}

    # -- laws of motion -----------------------------------------------------------------------
    def acceleration(self, c: Coordinate) -> Ratio:
        """Of a coordinate, as a function of coordinates, speeds and time."""
        k = self.model.coordinates.index(c)
        found = self.field.lowest_terms(self.model.dynamics.solved_accelerations[self.model.accelerations[k]])
        still = self.integrals.resting  # coordinates that stay where they start are no variables
        return self.field.lowest_terms(self.field.follow(found, still)) if still else found

    def law_of(self, c: Coordinate, *, takes_side: bool = False) -> MotionLaw | None:
        """How a coordinate moves by itself, where that is one of the laws that have closed forms. takes_side: whether
        what parameters decide may be as it is at the first sample; that is then assumed."""
        q0, u0 = self.start.of(c.index), self.start.of(c.speed)
        return law_of(Freely(self.model, c, self.acceleration(c), q0, u0, takes_side))

    @cached_property
    def _takes_side(self) -> bool:
        """Whether laws may take a side: where no integral of energy serves for all of them."""
        try:
            self.integrals.potential({})
        except CannotAnswer:
            return True
        return False

    # -- a place ------------------------------------------------------------------------------
    def _reach_place(self, value: Ratio, target: Ratio, event: QuestionEvent) -> Reached:
        present = self.field.ingredients(value)
        found = [c for c in self.model.coordinates if c.index in present]
        bound = [c for c in self.model.dependent if c.index in present]
        if len(found) > 1 and not bound:
            together = self._together(value, target, found, event.text)
            if together is not None:
                return together
        if not found and not bound and (driven := self._driven(value, target)) is not None:
            return driven
        if len(found) != 1 or bound:
            raise CannotAnswer(
                Message(
                    "'{event}' involves {n} coordinates ({names}); a closed form is found for one only",
                    event=event.text,
                    n=len(found) + len(bound),
                    names=", ".join(c.name for c in (*found, *bound)) or "none",
                )
            )
        (c,) = found
        at = solve_linear(value - target, c.index)
        if at is None and (only := self._only_place(c, value - target, event)) is not None:
            return only
        if at is None:
            raise CannotAnswer(
                Message(
                    "'{event}' is not linear in the coordinate {x}; name a measure that is, or ask for "
                    "the value of {y}",
                    event=event.text,
                    x=c.name,
                    y=c.name,
                )
            )
        at = self.field.lowest_terms(at)
        law = self.law_of(c, takes_side=self._takes_side)
        if law is not None and law.is_still:
            holds = (at - law.q0).is_zero()
            raise NeverHappens(
                HOLDS_ALWAYS if holds else Message("{x} stays where it starts: at rest, and not accelerated", x=c.name)
            )
        if isinstance(law, UniformLaw):
            return passage_at(c.name, law, at).of(c, at)
        instants = None if law is None else law.places(at)
        if instants is not None:
            return self._first(c, c.name, *instants)
        return self._place_by_energy(c, at, event)

    def _only_place(self, c: Coordinate, gap: Ratio, event: QuestionEvent) -> Reached | None:
        """Where a measure that is not linear in its coordinate has a value: the place on the way by energy that comes
        first; None where which one that is depends on the parameters, or they have no closed form."""
        try:
            places = zeros_of(self.model, without_root(gap, c.index).numerator(), c, quadratic=True)
        except CannotAnswer:
            return None
        found: list[Reached] = []
        for place in places:
            with suppress(CannotAnswer):
                found.append(self._place_by_energy(c, self.field.lowest_terms(place), event))
        if len(found) < 2 or len(places) > _MOST_PLACES:
            return found[0] if len(found) == 1 and len(places) <= _MOST_PLACES else None
        # of two on one side the nearer one, where it is that whatever the parameters are
        one, other = (r.at for r in found)
        start = self.start.of(c.index)
        apart, ways = sign_of(other - one), [sign_of(x - start) for x in (one, other)]
        if not apart.is_strict or ways[0] is not ways[1] or not ways[0].is_strict:
            return None
        return found[0] if apart is ways[0] else found[1]

    def _driven(self, value: Ratio, target: Ratio) -> Reached | None:
        """A measure that is given as a function of the time, linear in it."""
        f = self.field
        index = f.index(f.time)
        if present := f.ingredients(value) & self._in_time - {index}:
            return None
        time = None if present else solve_linear(value - target, index)
        if time is None:
            return None
        time = f.lowest_terms(time)
        if time.is_zero():
            raise NeverHappens(HOLDS_ONCE)
        return Reached(time, None, target, f.derivative(value, index), conditions=[(time, ">")])

    def _together(
        self, value: Ratio, target: Ratio, found: list[Coordinate], text: str, order: int = 0
    ) -> Reached | None:
        """A measure that is linear in several coordinates, and whose acceleration depends on nothing that moves but
        itself: the way between bodies that fall, or between two masses on a spring."""
        f = self.field
        slopes = [f.partial(value, c.index) for c in found]
        rest = value
        for slope, c in zip(slopes, found, strict=True):
            rest = rest - slope * f.variable(c.index)
        if not all(x.is_constant() for x in (*slopes, rest)):
            return None
        q0, u0, a = rest, f.zero, f.zero
        for slope, c in zip(slopes, found, strict=True):
            q0, u0 = q0 + slope * self.start.of(c.index), u0 + slope * self.start.of(c.speed)
            a = a + slope * self.acceleration(c)
        # the measure takes the place of the first coordinate; its acceleration may depend on no other then
        first, others = found[0], range(1, len(found))
        own, rate = f.variable(first.index) - rest, f.variable(first.speed)
        for k in others:
            own = own - slopes[k] * f.variable(found[k].index)
            rate = rate - slopes[k] * f.variable(found[k].speed)
        a = f.lowest_terms(f.follow(a, {first.index: own / slopes[0], first.speed: rate / slopes[0]}))
        moving = Freely(self.model, first, a, f.lowest_terms(q0), f.lowest_terms(u0), self._takes_side)
        law = law_of(moving) if moving.is_alone else None
        if isinstance(law, UniformLaw) and not order:
            return passage_at(text, law, target).of(None, target)
        if law is None or law.is_still:
            return None
        instants = law.rates(target) if order else law.places(target)
        return None if instants is None else self._first(None, text, *instants)

    def _first(
        self, c: Coordinate | None, name: str, instants: list[LawInstant], needs: list[tuple[Ratio, str]]
    ) -> Reached:
        found = first(self.model, instants)
        if found is None:
            if any(sign_of(x) is Sign.NEGATIVE for x, _relation in needs):
                raise NeverHappens(Message("{x} does not get that far", x=name))
            if instants and all(i.period is None and _is_past(i) for i in instants):
                raise NeverHappens(Message("{x} does not get there after the start", x=name))
            if all(i.time.is_zero() and i.period is None for i in instants):
                raise NeverHappens(HOLDS_ONCE if instants else Message("{x} only tends to that", x=name))
            raise NotReached(Message("{x} does not get there at any of the parameter values that were tried", x=name))
        i = found.instant
        lowest = self.field.lowest_terms
        return Reached(lowest(i.time), c, lowest(i.place), lowest(i.rate), [], [*needs, *found.conditions])

    # -- a rate -------------------------------------------------------------------------------
    def _reach_rate(self, rate: Ratio, target: Ratio, place: Ratio, text: str) -> Reached:
        speeds = [c for c in self.model.coordinates if c.speed in rate.generators()]
        inside = self.field.ingredients(rate) & {c.index for c in (*self.model.coordinates, *self.model.dependent)}
        bound = any(c.speed in rate.generators() for c in self.model.dependent)
        if len(speeds) > 1 and not inside and not bound:
            together = self._together(place, target, speeds, text, order=1)
            if together is not None:
                return together
        if len(speeds) != 1 or inside or bound:
            raise CannotAnswer(Message("the rate depends on several coordinates; a closed form is found for one only"))
        (c,) = speeds
        wanted = solve_linear(rate - target, c.speed)
        if wanted is None:
            raise CannotAnswer(Message("the rate is not linear in the rate of {x}", x=c.name))
        law = self.law_of(c, takes_side=self._takes_side)
        if law is not None and law.is_still:
            raise NeverHappens(
                HOLDS_ALWAYS if wanted.is_zero() else Message("{x} stays at rest: nothing accelerates it", x=c.name)
            )
        if isinstance(law, UniformLaw):
            if law.a.is_zero():
                same = (wanted - law.u0).is_zero()
                raise NeverHappens(HOLDS_ALWAYS if same else Message("the rate of {x} is constant", x=c.name))
            time = self.field.lowest_terms((wanted - law.u0) / law.a)
            if time.is_zero():
                raise NeverHappens(HOLDS_ONCE)
            at = law.q0 + (wanted * wanted - law.u0 * law.u0) / (2 * law.a)
            return Reached(time, c, at, wanted, conditions=[(time, ">")])
        instants = None if law is None else law.rates(wanted)
        if instants is not None:
            return self._first(c, c.name, *instants)
        return self._rate_by_energy(c, wanted)

    # -- a motion that repeats itself ---------------------------------------------------------
    def period(self, c: Coordinate) -> Reached:
        """After which time a coordinate is where it was at the start, and as fast. Raises NeverHappens where it does
        not come back, CannotAnswer where no closed form is found."""
        q0, u0 = self.start.of(c.index), self.start.of(c.speed)
        if self.stands_still:
            raise NeverHappens(Message("it starts at rest in an equilibrium, and stays there"))
        law = self.law_of(c, takes_side=self._takes_side)
        if law is not None:
            if law.is_still or law.period is None:
                raise NeverHappens(Message("the motion of {x} does not repeat itself", x=c.name))
            notes: list[str] = (
                []
                if law.is_undamped
                else [Message("of a damped motion it is the time from a turn to the next but one")]
            )
            return Reached(self.field.lowest_terms(law.period), c, q0, u0, notes)
        way = self.way_of(c)
        found = way.period()
        if found is None:
            raise CannotAnswer(
                Message("no closed form was found for the period: the time is no elliptic integral of the first kind")
            )
        time, needs, says = found
        return Reached(time, c, q0, u0, [], needs, says=says, integral=way.integral)

    def extent(self, c: Coordinate, side: int) -> Reached:
        """The farthest place of a coordinate above (side > 0) or below."""
        q0 = self.start.of(c.index)
        if self.stands_still:
            return Reached(self.field.zero, c, q0, self.field.zero)
        try:
            self.integrals.speed_squared(c, self.field.variable(c.index))
        except CannotAnswer:
            return self._extent_by_law(c, side)
        at, needs, says = self.way_of(c).extent(side)
        return Reached(None, c, at, self.field.zero, [], needs, says=says)

    def _extent_by_law(self, c: Coordinate, side: int) -> Reached:
        """Of what is damped or resisted: it does not get beyond its first turn, nor back beyond its start at rest."""
        law, u0 = self.law_of(c, takes_side=True), self.start.of(c.speed)
        sense = sign_of(u0)
        if not isinstance(law, Damped | Resisted) or not sense.is_strict or (sense is Sign.POSITIVE) != (side > 0):
            raise CannotAnswer(Message("no closed form was found for how far it gets"))
        instants = law.rates(self.field.zero)
        if instants is None or (isinstance(law, Damped) and law.is_negative(law.delta)):
            raise CannotAnswer(Message("no closed form was found for how far it gets"))
        return self._first(c, c.name, *instants)

    # -- first integral -----------------------------------------------------------------------
    def _place_by_energy(self, c: Coordinate, at: Ratio, event: QuestionEvent) -> Reached:
        """The speed at a place, from M u^2/2 + V = const, with the sign of the way there."""
        way = self.way_of(c)
        speed, needs, says = way.to(at)
        if (timed := way.time_to(at)) is not None:
            return Reached(timed[0], c, at, speed, [], needs, says=says, integral=way.integral, timed=timed[1])
        why = Message(
            "no closed form was found for the time to '{event}': it is the integral of the coordinate's differential "
            "over the speed; simulate the motion for a number",
            event=event.text,
        )
        return Reached(None, c, at, speed, [], needs, why, says)

    def _rate_by_energy(self, c: Coordinate, wanted: Ratio) -> Reached:
        """The place at which the speed has a value: a zero of u(q)^2 - u^2 = 0, the first on the way."""
        way = self.way_of(c)
        at, needs, says = way.where(wanted)
        if (timed := way.time_until(at, wanted)) is not None:
            return Reached(timed[0], c, at, wanted, [], needs, says=says, integral=way.integral, timed=timed[1])
        why = Message(
            "no closed form was found for the time: it is the integral of the coordinate's differential over the "
            "speed; simulate the motion for a number"
        )
        return Reached(None, c, at, wanted, [], needs, why, says)

    def way_of(self, c: Coordinate) -> EnergyPath:
        """The way of a coordinate by energy."""
        square = self.speed_squared(c, self.field.variable(c.index))
        a0 = self.field.follow(self.acceleration(c), self.start.values)
        start = self.start.of(c.index), self.start.of(c.speed), a0
        return EnergyPath(self.model, c, square, start, takes_side=self._on_one_side)

    @contextmanager
    def on_one_side(self) -> Generator[None]:
        """Ways by energy are told as they are at the first sample, where parameters decide."""
        self._on_one_side = True
        try:
            yield
        finally:
            self._on_one_side = False

    def speed_squared(self, c: Coordinate, at: Ratio) -> Ratio:
        """u^2 at q = at."""
        return self.integrals.speed_squared(c, at)


def _is_past(instant: LawInstant) -> bool:
    """Whether an instant is proved to be before the start."""
    return instant.key is not None and not instant.key.is_zero() and sign_of(instant.key) is Sign.NEGATIVE
