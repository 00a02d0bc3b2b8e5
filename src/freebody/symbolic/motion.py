"""Motion in closed form, for one degree of freedom or coordinates that move independently.

What moves by itself has a law in the time (`laws/`): constant acceleration, harmonic, damped, resisted, given in time.
Otherwise there is the first integral of energy,

    d(M u^2/2 + V)/dt = 0            u^2 = (M0 u0^2 + 2 V0 - 2 V)/M

Every root that solves an equation but not the problem is reported with the reason.
"""

from __future__ import annotations

from contextlib import suppress
from dataclasses import replace
from functools import cached_property

from freebody.errors import CannotAnswer, NeverHappens
from freebody.language.notation import compared, reworded
from freebody.language.sentences import Message
from freebody.questions.event_base import QuestionEvent
from freebody.symbolic.closure import Closure
from freebody.symbolic.event_places import EventPlaces, Need, Variable
from freebody.symbolic.laws.uniform import UniformLaw
from freebody.symbolic.motion_cycles import MotionCycles
from freebody.symbolic.orbits import Orbit, orbit_of
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.reached import HOLDS_ALWAYS, HoldsOnce, Reached
from freebody.symbolic.seen_angles import ray_of
from freebody.symbolic.settling import settling_of
from freebody.symbolic.tidy import tidy
from freebody.symbolic.uniform_passage import passage_at
from freebody.symbolic.unknowns import Coordinate
from freebody.symbolic.zeros import solve_linear


class SmoothMotion(MotionCycles):
    """The closed-form motion of a model from its start."""

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
            reached = self._reach_rate(value, target, place, event)
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
        needs, decays = list[tuple[Ratio, str]](), list[tuple[Ratio, ...]]()
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
            elif law is None and not {c.index, c.speed} & found.keys():
                settling = settling_of(self.model, self.acceleration, c)
                found |= {} if settling is None else settling.limits
                needs += [] if settling is None else [(x, ">") for x in settling.needs]
                decays += [] if settling is None else [settling.polynomial]
        settled = f.lowest_terms(latest + 1)
        return Reached(None, None, f.zero, f.one, conditions=needs, limits=found, settled=settled, decays=decays)

    def known_at(self, reached: Reached) -> dict[int, Ratio]:
        """The coordinates and speeds at an event, as far as they have closed forms, and the time: a coordinate that
        moves by itself is where its own law has brought it by then, one that nothing depends on keeps its momentum."""
        if reached.limits is not None:
            return reached.limits
        values = self._independent_at(reached)
        places = {c.index for c in self.model.coordinates}
        if self.model.dependent and places <= values.keys() and self._has_solved_loops:
            at = {k: x for k, x in values.items() if k in places or k == self.field.index(self.field.time)}
            values = self.closure.at(at, reached.bound) | values
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
            integrals = self.integrals_of(c)
            values = integrals.speeds_at(c, reached.at, reached.speed) | values
            values = integrals.places_at(c, reached.at, reached.time) | values
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

    # -- a place ------------------------------------------------------------------------------
    def _reach_place(self, value: Ratio, target: Ratio, event: QuestionEvent) -> Reached:
        present = self.field.ingredients(value)
        found = [c for c in self.model.coordinates if c.index in present]
        bound = [c for c in self.model.dependent if c.index in present]
        if len(found) > 1 and not bound:
            together = self._together(value, target, found, event.text)
            if together is None and event.measure.is_angle:
                together = self._seen_under(value, target, found, event.text)
            if together is not None:
                return together
        if not found and not bound and (driven := self._driven(value, target)) is not None:
            return driven
        is_led = not found and not bound and present & self._in_time
        if is_led or (bound and not self.model.coordinates):
            return self._by_the_clock(value, target)
        at, needs, given = None, list[Need](), dict[int, Ratio]()
        if len(found) == 1 and not bound:
            at = solve_linear(value - target, found[0].index)
        elif len(self.model.coordinates) != 1:
            raise CannotAnswer(
                Message(
                    "'{event}' involves {n} coordinates ({names}); a closed form is found for one only",
                    event=event.text,
                    n=len(found) + len(bound),
                    names=", ".join(c.name for c in (*found, *bound)) or "none",
                )
            )
        c = found[0] if len(found) == 1 else self.model.coordinates[0]
        if at is None:
            places = EventPlaces(self.model, self.closure, Variable(c.index, c.name), value, target)
            (at, needs), given = self._on_the_way(c, places), places.bound
        reached = self._to_place(c, self.field.lowest_terms(at), event)
        reached.conditions += needs
        reached.bound = given
        return reached

    def _to_place(self, c: Coordinate, at: Ratio, event: QuestionEvent) -> Reached:
        """When a coordinate comes to a place: by its law in the time, else by energy."""
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
        try:
            return self._place_by_energy(c, at, event)
        except NeverHappens:
            raise
        except CannotAnswer as error:
            if law is None:
                raise
            why = Message(
                "{x} has a closed form in the time (ask for {x} at t = ...), but the equation for the time of "
                "'{event}' has no closed solution",
                x=c.name,
                event=event.text,
            )
            raise CannotAnswer(why) from error

    def _on_the_way(self, c: Coordinate, places: EventPlaces) -> tuple[Ratio, list[Need]]:
        """The first place of a coordinate at which something that is not linear in it has a value, and what that needs;
        where the coordinate turns before, the first one on the way back."""
        q0, sense, turn = self.start.of(c.index), self.sense(c), self._turn(c)
        if turn is not None and not places.is_before(q0, turn, sense, takes_side=self._on_one_side):
            return places.first(turn, -sense)
        return places.first(q0, sense)

    def sense(self, c: Coordinate) -> int:
        """+1 if a coordinate grows at first, else -1."""
        drive = self.start.of(c.speed)
        drive = self.field.follow(self.acceleration(c), self.start.values) if drive.is_zero() else drive
        signs = [(v > 0) - (v < 0) for v in self.model.samples.at_starts(drive)]
        if self._on_one_side and signs[0]:
            return signs[0]  # which is needed of the way by energy, too
        if len(set(signs)) != 1 or 0 in signs:
            raise CannotAnswer(Message("which way {x} goes depends on the parameter values", x=c.name))
        return signs[0]

    def _turn(self, c: Coordinate) -> Ratio | None:
        """Where a coordinate turns first, as far as energy tells that."""
        with suppress(CannotAnswer):
            return self.way_of(c).turn
        return None

    def _by_the_clock(self, value: Ratio, target: Ratio) -> Reached:
        """The first time at which something has a value that follows from driven measures through closed loops."""
        f = self.field
        time = Variable(f.index(f.time), "t")
        places = EventPlaces(self.model, self.closure, time, value, target)
        at, needs = places.first(f.zero, 1)
        return Reached(at, None, target, None, conditions=needs, bound=places.bound)

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
            raise HoldsOnce
        return Reached(time, None, target, f.derivative(value, index), conditions=[(time, ">")])

    def _together(
        self, value: Ratio, target: Ratio, found: list[Coordinate], text: str, order: int = 0
    ) -> Reached | None:
        """When a measure that is linear in several coordinates has a value, or its rate."""
        law = self.law_together(value, found)
        if isinstance(law, UniformLaw) and not order:
            return passage_at(text, law, target).of(None, target)
        if law is None or law.is_still:
            return None
        instants = law.rates(target) if order else law.places(target)
        return None if instants is None else self._first(None, text, *instants)

    def _seen_under(self, value: Ratio, target: Ratio, found: list[Coordinate], text: str) -> Reached | None:
        """When a line between points whose coordinates move by laws of their own has a direction."""
        ray = ray_of(value, target)
        reached = None if ray is None else self._together(ray.across, self.field.zero, found, text)
        if ray is None or reached is None or reached.time is None:
            return None
        there = self._independent_at(reached)
        if not {c.index for c in found} <= there.keys():
            return None
        ahead = self.field.lowest_terms(self.field.follow(ray.ahead, there))
        if not all(x > 0 for x in self.model.samples.at_starts(ahead)):
            return None  # it is on the other half of the line first
        return replace(reached, at=target, speed=None, notes=[], conditions=[*reached.conditions, (ahead, ">")])

    # -- a rate -------------------------------------------------------------------------------
    def _reach_rate(self, rate: Ratio, target: Ratio, place: Ratio, event: QuestionEvent) -> Reached:
        speeds = [c for c in self.model.coordinates if c.speed in rate.generators()]
        inside = self.field.ingredients(rate) & {c.index for c in (*self.model.coordinates, *self.model.dependent)}
        bound = any(c.speed in rate.generators() for c in self.model.dependent)
        if len(speeds) > 1 and not inside and not bound:
            together = self._together(place, target, speeds, event.text, order=1)
            if together is not None:
                return together
        is_led = not (speeds or inside or bound) and self.field.ingredients(rate) & self._in_time
        if is_led or (not self.model.coordinates and (inside or bound)):
            return self._by_the_clock(self.model.in_independent_speeds(rate), target)
        if len(self.model.coordinates) == 1 and target.is_zero() and (inside or bound):
            return self._reach_reversal(self.model.coordinates[0], rate, event)
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
                raise HoldsOnce
            at = law.q0 + (wanted * wanted - law.u0 * law.u0) / (2 * law.a)
            return Reached(time, c, at, wanted, conditions=[(time, ">")])
        instants = None if law is None else law.rates(wanted)
        if instants is not None:
            return self._first(c, c.name, *instants)
        return self._rate_by_energy(c, wanted)

    def _reach_reversal(self, c: Coordinate, rate: Ratio, event: QuestionEvent) -> Reached:
        """Where a rate g(q) u vanishes: at a zero of g, or where the coordinate turns, whichever is first."""
        x = self.field.lowest_terms(self.model.in_independent_speeds(rate))
        parts = x.numerator().coefficients(c.speed)
        if len(parts) != 2 or not parts[0].is_zero() or c.speed in x.denominator().generators():
            raise CannotAnswer(Message("the rate is not linear in the rate of {x}", x=c.name))
        places = EventPlaces(self.model, self.closure, Variable(c.index, c.name), parts[1], self.field.zero)
        turn = self._turn(c)
        if turn is not None and not places.is_before(self.start.of(c.index), turn, self.sense(c)):
            return self._rate_by_energy(c, self.field.zero)
        at, needs = places.first(self.start.of(c.index), self.sense(c))
        reached = self._to_place(c, self.field.lowest_terms(at), event)
        reached.conditions += needs
        return reached

    # -- first integral -----------------------------------------------------------------------
    def _place_by_energy(self, c: Coordinate, at: Ratio, event: QuestionEvent) -> Reached:
        """The speed at a place, from M u^2/2 + V = const, with the sign of the way there."""
        try:
            way = self.way_of(c)
        except CannotAnswer:
            if (reached := self._on_orbit(c, at, event)) is None:
                raise
            return reached
        speed, needs, says = way.to(at)
        orbits, seen = self._seen_from_center(c, at, turns=False)
        if (timed := way.time_to(at)) is not None:
            return Reached(
                timed[0],
                c,
                at,
                speed,
                [],
                needs,
                says=says,
                integral=way.integral,
                timed=timed[1],
                others=seen,
                orbits=orbits,
            )
        why = Message(
            "no closed form was found for the time to '{event}': it is the integral of the coordinate's differential "
            "over the speed; simulate the motion for a number",
            event=event.text,
        )
        return Reached(None, c, at, speed, [], needs, why, says, others=seen, orbits=orbits)

    def _seen_from_center(self, c: Coordinate, at: Ratio, *, turns: bool) -> tuple[tuple[Orbit, ...], dict[int, Ratio]]:
        """The angle about a centre at which a distance from it is reached first, where that has a closed form."""
        found = (orbit_of(self.integrals_of(c), c, k) for k in self.model.coordinates if k is not c)
        orbits = tuple(orbit for orbit in found if orbit is not None)
        return orbits, {orbit.angle.index: orbit.angle_at(at, turns=turns) for orbit in orbits}

    def _on_orbit(self, angle: Coordinate, at: Ratio, event: QuestionEvent) -> Reached | None:
        """When an angle about a centre has a value, by the distance that it has there: on the way from one apse to the
        next one."""
        for c in self.model.coordinates:
            if c is angle or (orbit := orbit_of(self.integrals_of(c), c, angle)) is None:
                continue
            turned = orbit.turned(at)
            left = self.field.lowest_terms(self.field.pi - turned)
            if left.is_zero():
                reached = self._rate_by_energy(c, self.field.zero)
            elif any(x < 0 for x in self.model.samples.at_starts(left)):
                return None
            else:
                reached = self._place_by_energy(c, orbit.distance_at(at), event)
            reached.conditions += [(turned, ">"), (left, ">=")]
            return replace(reached, others={angle.index: at}, orbits=(orbit,))
        return None

    def _rate_by_energy(self, c: Coordinate, wanted: Ratio) -> Reached:
        """The place at which the speed has a value: a zero of u(q)^2 - u^2 = 0, the first on the way."""
        way = self.way_of(c)
        at, needs, says = way.where(wanted)
        orbits, seen = self._seen_from_center(c, at, turns=True) if wanted.is_zero() else ((), {})
        if (timed := way.time_until(at, wanted)) is not None:
            return Reached(
                timed[0],
                c,
                at,
                wanted,
                [],
                needs,
                says=says,
                integral=way.integral,
                timed=timed[1],
                others=seen,
                orbits=orbits,
            )
        why = Message(
            "no closed form was found for the time: it is the integral of the coordinate's differential over the "
            "speed; simulate the motion for a number"
        )
        return Reached(None, c, at, wanted, [], needs, why, says, others=seen, orbits=orbits)
