"""Steady motion: the coordinates on which the equations of motion depend stay constant, the others run evenly.

A coordinate is cyclic where neither the mass matrix M nor the forces F of M(q) du/dt = F(q, u) contain it. With the
speeds of the others and all accelerations zero, what is left is F(q, u) = 0: conditions between the rates of the cyclic
coordinates and the values of the others. Sources: Routh, Dynamics of a System of Rigid Bodies, Advanced Part, 1905,
ch. III; for the top Goldstein, Poole & Safko, Classical Mechanics, 3rd ed. 2002, sec. 5.7; for rolling bodies Neimark &
Fufaev, Dynamics of Nonholonomic Systems, 1972, ch. VI.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from functools import cached_property

from freebody.errors import CannotAnswer
from freebody.language.expression import ZERO
from freebody.language.notation import compared, reworded, to_text
from freebody.language.sentences import Message, further
from freebody.measures.base import Measure
from freebody.questions.base import Quantity
from freebody.questions.event import AskedEvent
from freebody.questions.event_base import QuestionEvent
from freebody.questions.steady import SteadyValue
from freebody.study.eom import primitive_part
from freebody.study.steady.apart import MOST_ROOTS, nearest, places_apart
from freebody.symbolic.closure import Closure
from freebody.symbolic.functions import functions
from freebody.symbolic.linear import RHS, Row, solve
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.reduced import odd_part, without_square_roots
from freebody.symbolic.signs import sign_of
from freebody.symbolic.speeds import total_of
from freebody.symbolic.state import SymbolicState
from freebody.symbolic.tidy import tidy
from freebody.symbolic.unknowns import Coordinate
from freebody.symbolic.zeros import zeros_of


@dataclass
class SteadyMotion:
    """The steady motions of a model, or those in which something has a given value: a coordinate that stays constant,
    or a rate, by generator."""

    model: SymbolicModel
    given: Mapping[int, Ratio] = field(default_factory=dict[int, Ratio])

    @classmethod
    def asked(cls, model: SymbolicModel, event: AskedEvent | None) -> SteadyMotion:
        """With the value that an event states: when theta = 60 deg, when rate(psi) = 5 rad/s. Raises CannotAnswer
        where that is none of a steady motion."""
        steady = cls(model)
        if event is None:
            return steady
        if not isinstance(event, QuestionEvent):
            raise CannotAnswer(Message("what goes on evenly has no event; leave out 'when'"))
        among = steady.cyclic if event.order else steady.others
        c = next((c for c in among if model.measure_of(c) == event.measure), None)
        if c is None and (by := steady.kept_by(event)) is not None:
            return cls(model, by)
        if c is None:
            rates = [f"rate({k.name})" for k in steady.cyclic]
            told = Message(
                "'{event}' gives no value that a steady motion keeps; it keeps {names}",
                event=event.text,
                names=", ".join([*(k.name for k in steady.others), *rates]),
            )
            raise CannotAnswer(told)
        return cls(model, {c.speed if event.order else c.index: model.geometry.scalar(event.value)})

    def kept_by(self, event: QuestionEvent) -> dict[int, Ratio] | None:
        """The value of the one coordinate on which a measure depends, where that has the value which an event states:
        the one that is nearest to the start. None where it depends on others, or has no closed form."""
        m = self.model
        c, places = (None, []) if event.order else self.places_of(event.measure, m.geometry.scalar(event.value))
        near = [] if c is None else [v for v in m.samples.start_numbers(c.index)[:1] if v == v]
        if c is None or not places or not near:
            return None

        def away(place: Ratio) -> float:
            return min((abs(v - near[0]) for v in m.samples.at_starts(place)[:1] if v == v), default=float("inf"))

        return {c.index: min(places, key=away)}

    def places_of(self, measure: Measure, target: Ratio) -> tuple[Coordinate | None, list[Ratio]]:
        """The one coordinate on which a measure depends, and its values at which that has one; None where it depends on
        others."""
        m = self.model
        value = m.value_of(measure)
        inside = [c for c in (*m.coordinates, *m.dependent) if c.index in m.field.ingredients(value)]
        if len(inside) != 1 or inside[0] not in self.others:
            return None, []
        with m.samples.apart():
            return inside[0], zeros_of(m, without_arc(m, value, target).numerator(), inside[0])

    def put_in(self, x: Ratio) -> Ratio:
        """An element with the given value, and by independent coordinates as far as loops have a short solution."""
        with suppress(CannotAnswer):
            x = self._closure.explicit(x)
        return x.field.lowest_terms(x.field.follow(x, dict(self.given))) if self.given else x

    @cached_property
    def _closure(self) -> Closure:
        return Closure(self.model)

    @cached_property
    def cyclic(self) -> tuple[Coordinate, ...]:
        """Coordinates that the equations of motion do not contain."""
        needed = self.needed
        return tuple(c for c in self.model.coordinates if c.index not in needed)

    @cached_property
    def others(self) -> tuple[Coordinate, ...]:
        return tuple(c for c in self.model.coordinates if c not in self.cyclic)

    @cached_property
    def needed(self) -> set[int]:
        """Coordinates on which the equations depend, and those on which the speeds of these depend."""
        m = self.model
        entries = [without_square_roots(m, x) for row in m.dynamics.mass_matrix for x in row] + self.forces
        needed = {g for x in entries for g in m.field.ingredients(x)}
        todo = [c for c in m.dependent if c.index in needed]
        for c in todo:
            needed |= m.field.ingredients(m.dependent_speed(c))
            todo += [d for d in m.dependent if d.index in needed and d not in todo]
        return needed

    @cached_property
    def forces(self) -> list[Ratio]:
        m = self.model
        return [without_square_roots(m, m.in_independent_speeds(x)) for x in m.dynamics.forcing]

    def feels(self, c: Coordinate) -> bool:
        """Whether a force depends on the rate of a coordinate."""
        return any(c.speed in self.model.field.ingredients(x) for x in self.forces)

    @cached_property
    def still(self) -> dict[int, Ratio]:
        """The speeds of what stays constant."""
        return {c.speed: self.model.field.zero for c in self.others}

    @cached_property
    def equations(self) -> tuple[Ratio, ...]:
        """What has to vanish, each without the factors in which no rate occurs. Raises CannotAnswer where the motion
        cannot be steady: where forces depend on time, or bound coordinates go on moving."""
        m, f = self.model, self.model.field
        found: list[Ratio] = []
        for d in m.dependent:
            if d.index in self.needed and not m.samples.vanishes(f.substitute(m.dependent_speed(d), self.still)):
                raise CannotAnswer(
                    Message("the equations of motion depend on {x}, which moves on: nothing is steady", x=d.name)
                )
        for force in self.forces:
            x = self.put_in(f.lowest_terms(f.substitute(force, self.still)))
            if m.samples.vanishes(x):
                continue
            if any(f.generators[g].kind == "time" for g in f.ingredients(x)):
                raise CannotAnswer(Message("the forces depend on time, so that no motion is steady"))
            equation = self._with_rates(x)
            if all(equation != other and equation != -other for other in found):
                found.append(equation)
        return tuple(found)

    def _with_rates(self, x: Ratio) -> Ratio:
        """The factors that contain a rate; all that can vanish where none does."""
        product = x.field.one
        for base, _exponent in x.field.factor(x.num)[1]:
            if x.field.ingredients(base) & {c.speed for c in self.cyclic}:
                product = product * base
        if product != 1:
            return self._without_common_factor(product)
        part = primitive_part(x)
        return without_strict_factors(x) if part.is_constant() else part  # of parameters alone

    def _without_common_factor(self, x: Ratio) -> Ratio:
        """An equation without a factor of the pose that all its coefficients of rates have in common. Beside square
        roots, w^2 = 1 + 4 k^2 rho^2 of a slope, it is no factor of a polynomial, but cancels in their quotients."""
        f = x.field
        parts = [x]
        for c in self.cyclic:
            parts = [each for part in parts for each in part.coefficients(c.speed) if not each.is_zero()]
        roots = [g for g in f.ingredients(x) if f.generators[g].kind == "root" and f.generators[g].made_of]
        if len(roots) != 1 or len(parts) < 2:
            return x
        # the divisor a + b w makes the quotient with a - b w above and below the bar
        others = [f.substitute(part, {roots[0]: -f.variable(roots[0])}) for part in parts]
        quotients = [f.quotient((x * c).num, (part * c).num) for part, c in zip(parts, others, strict=True)]
        return primitive_part(min((x, *(q.numerator() for q in quotients)), key=lambda e: len(e.num)))

    @cached_property
    def always(self) -> list[Ratio]:
        """Factors without rates: where they vanish, every rate is steady."""
        f = self.model.field
        if len(self.equations) != 1:
            return []
        forces = [
            x
            for x in (self.put_in(f.substitute(force, self.still)) for force in self.forces)
            if not self.model.samples.vanishes(x)
        ]
        factors = [base for base, _e in f.factor(forces[0].num)[1] if not base.is_constant()]
        speeds = {c.speed for c in self.cyclic}
        if all(not f.ingredients(base) & speeds for base in factors):
            return []
        return [base for base in factors if not f.ingredients(base) & speeds] if len(forces) == 1 else []

    def texts(self) -> list[str]:
        return [compared(ZERO, "=", tidy(x)) for x in self.equations]

    # -- solving ------------------------------------------------------------------------------
    def solved_for(self, speed: int) -> Solutions:
        """The rate, by the other rates and the pose. Raises CannotAnswer where it stays open or has no closed form."""
        name = to_text(self.model.field.generators[speed].display)
        equations = list(self.equations)
        if not equations:
            raise CannotAnswer(
                Message("every value of {x} is steady: nothing depends on the coordinates that run", x=name)
            )
        if len(equations) > 1:
            return self._linear([speed, *(c.speed for c in self.cyclic if c.speed != speed)], name)
        equation = equations[0]
        if speed not in equation.generators():
            raise CannotAnswer(
                Message(
                    "steady motion leaves {x} open; its condition is {condition}", x=name, condition=self.texts()[0]
                )
            )
        return self._roots(equation, speed, name)

    def _roots(self, equation: Ratio, speed: int, name: str) -> Solutions:
        f, found = self.model.field, Solutions(speed)
        for base, _exponent in f.factor(equation.num)[1]:
            if speed not in base.generators():
                continue
            c = base.coefficients(speed)
            if len(c) == 2 and c[0].is_zero():
                found.notes.append(Message("{x} = 0 is steady, too", x=name))
            elif len(c) == 2:
                found.roots.append(f.lowest_terms(-c[0] / c[1]))
            elif len(c) == 3 and c[1].is_zero():
                found.roots.append(f.lowest_terms(f.sqrt(-c[0] / c[2], self.model.samples.is_negative)))
                found.notes.append(Message("in either sense: the opposite rate is steady, too"))
            elif len(c) == 3:
                found.roots += self._both_roots(c)
                found.notes += self._single(c, name)
            else:
                raise CannotAnswer(
                    Message(
                        "{x} is a root of a polynomial of degree {n} that does not factor: {equation}",
                        x=name,
                        n=len(c) - 1,
                        equation=self.texts()[0],
                    )
                )
        return found

    def _single(self, c: list[Ratio], name: str) -> list[str]:
        """What is left of two roots where their square has no factor: one, and none of them."""
        f = self.model.field
        if sign_of(c[2]).is_strict:
            return []
        square, only = compared(tidy(odd_part(c[2])), "=", ZERO), to_text(tidy(f.lowest_terms(-c[0] / c[1])))
        words = Message("where {square} there is one such rate alone, {x} = {only}", square=square, x=name, only=only)
        return [reworded(words, square)]

    def _both_roots(self, c: list[Ratio]) -> list[Ratio]:
        """Of c_0 + c_1 x + c_2 x^2, the smaller first."""
        root = self.model.field.sqrt(c[1] * c[1] - 4 * c[0] * c[2], self.model.samples.is_negative)
        both = [(-c[1] - root) / (2 * c[2]), (-c[1] + root) / (2 * c[2])]
        signs = [v for v in self.model.samples.at_starts(c[2]) if v == v]
        return both[::-1] if signs and signs[0] < 0 else both

    def _linear(self, columns: Sequence[int], name: str) -> Solutions:
        """The first of several unknowns, in which all conditions are linear."""
        f, asked = self.model.field, columns[0]
        rows: list[Row] = []
        for equation in self.equations:
            row: Row = {}
            rest = equation
            for column in columns:
                slope = f.partial(equation, column)
                # a sine or cosine of what is unknown has no slope along it in the field, and stands in the rest
                if f.ingredients(slope) & set(columns):
                    raise self._not_linear(name)
                if not slope.is_zero():
                    row[column], rest = slope, rest - slope * f.variable(column)
            if f.ingredients(rest) & set(columns):
                raise self._not_linear(name)
            rows.append(row if rest.is_zero() else {**row, RHS: -rest})
        done = solve(f, rows, columns, self.model.samples.vanishes, in_order=True)
        if done.contradictory:
            raise CannotAnswer(
                Message("no rates make this pose steady: {conditions}", conditions=further(*self.texts()))
            )
        if asked not in done.pivots:
            raise CannotAnswer(
                Message(
                    "steady motion leaves {x} open; its conditions are {conditions}",
                    x=name,
                    conditions=further(*self.texts()),
                )
            )
        values = {column: f.lowest_terms(total_of(f, row)) for column, row in done.pivots.items()}
        return Solutions(asked, [values.pop(asked)], with_them=values)

    def _not_linear(self, name: str) -> CannotAnswer:
        return CannotAnswer(
            Message(
                "{name} follows from {n} equations that are not linear in what is unknown: {conditions}",
                name=name,
                n=len(self.equations),
                conditions=further(*self.texts()),
            )
        )

    def at_position(self, c: Coordinate) -> Solutions:
        """The values of a coordinate that stays constant."""
        if not any(c.index in self.model.field.ingredients(x) for x in self.equations):
            raise CannotAnswer(Message("steady motion leaves {x} open", x=c.name))
        if len(self.equations) != 1:
            # what a controller with states settles at: their rates, and the places, together
            places = [other for other in self.others if other is not c and other.index not in self.given]
            apart = places_apart(self.model, self.equations, [c, *places], [other.speed for other in self.cyclic])
            if apart is not None:
                own = apart.pop(c.index)
                with_them = {k: nearest(self.model, k, roots) for k, roots in apart.items()}
                return self._on_one_side(Solutions(c.index, own, with_them=with_them), c)
            columns = [c.index, *(other.index for other in places), *(other.speed for other in self.cyclic)]
            return self._linear(columns, c.name)
        with self.model.samples.apart():  # signs of roots do not matter, since both are among the zeros
            roots = zeros_of(self.model, self.equations[0], c)
        if not roots or len(roots) > MOST_ROOTS:
            raise CannotAnswer(
                Message(
                    "the condition of steady motion has no closed form for {x}: {equation}",
                    x=c.name,
                    equation=self.texts()[0],
                )
            )
        return self._on_one_side(Solutions(c.index, roots), c)

    def _on_one_side(self, solutions: Solutions, c: Coordinate) -> Solutions:
        """Of two opposite values, the one with the sign that the coordinate has at the start. Where a value has no
        opposite among the others all are kept, since what is said of the opposite ones is said of every value."""
        halves = [x for x in solutions.roots if is_half(x)]  # upright: its own opposite
        if any(-x not in solutions.roots for x in solutions.roots if x not in halves):
            return solutions
        numbers = self.model.samples.start_numbers(c.index)
        is_negative = bool(numbers) and numbers[0] < 0
        kept: list[Ratio] = []
        for x in solutions.roots:
            if any(x == -y for y in kept):
                solutions.notes.append(Message("the opposite value of {x} is steady, too", x=c.name))
                kept = [-y if x == -y and is_negative else y for y in kept]
            else:
                kept.append(x)
        return Solutions(solutions.index, kept, solutions.notes, solutions.with_them)

    def any_solution(self) -> Solutions | None:
        """Some way to be steady, for evidence; None where every rate is."""
        if not self.equations:
            return None
        for c in self.cyclic:
            try:
                found = self.solved_for(c.speed)
            except CannotAnswer:
                continue
            if found.roots:
                return found
        for c in self.others:
            try:
                return self.at_position(c)
            except CannotAnswer:
                continue
        moving = {k for c in self.model.coordinates for k in (c.index, c.speed)}
        if not any(moving & self.model.field.ingredients(x) for x in self.equations):
            raise CannotAnswer(
                Message(
                    "the given place is steady only where {conditions}: set the parameters so, or ask for the value of "
                    "one of them for which it is",
                    conditions=further(*self.texts()),
                )
            )
        raise CannotAnswer(
            Message(
                "no steady motion has a closed form, to check it by: {conditions}", conditions=further(*self.texts())
            )
        )

    def eliminated(self, *, even_if_open: bool = False) -> Solutions | None:
        """What follows where something is given: the one rate, or the one place, that the conditions leave to be found;
        where nothing is given and nothing runs, the place nearest to the start, unless it may stay open (even_if_open:
        all of them). None where they leave more."""
        if not self.equations:
            return None
        free = frozenset[int]().union(*(self.model.field.ingredients(x) for x in self.equations))
        speeds = [c for c in self.cyclic if c.speed in free]
        places = [c for c in self.others if c.index in free]
        if not (self.given or even_if_open):
            return self._nearest_to_start(places) if not self.cyclic and len(self.equations) == 1 else None
        try:
            if len(speeds) == 1 and not places:
                return self.solved_for(speeds[0].speed)
            if len(places) == 1 and not speeds:
                return self.at_position(places[0])
        except CannotAnswer:
            return None
        return None

    def _nearest_to_start(self, places: Sequence[Coordinate]) -> Solutions | None:
        place = self.nearest_place(self.equations[0], places[0]) if len(places) == 1 else None
        if place is None:
            return None
        shown = compared(self.model.field.generators[places[0].index].display, "=", tidy(place))
        told = Message("about the steady motion with {place}", place=shown)
        return Solutions(places[0].index, [place], [reworded(told, shown)])

    def nearest_place(self, condition: Ratio, c: Coordinate) -> Ratio | None:
        """Where a condition holds, by its one open coordinate, nearest to the start. An angle that is so whatever the
        parameters are is meant only where the start is at it."""
        with self.model.samples.apart():
            places = zeros_of(self.model, condition.numerator(), c)
        measure = self.model.measure_of(c)
        if measure is not None and measure.is_angle:
            places = [x for x in places if not is_quarter(x)]
        start = self.model.samples.start_numbers(c.index)
        if not places or not [v for v in start[:1] if v == v]:
            return None
        return self.model.field.lowest_terms(nearest(self.model, c.index, places))

    # -- the instant --------------------------------------------------------------------------
    @cached_property
    def state(self) -> SymbolicState:
        """A general instant of a steady motion: without accelerations."""
        return SymbolicState(self.model.without_accelerations(), self.still)


def is_half(x: Ratio) -> bool:
    """Whether an element is zero, or a multiple of half a turn."""
    halves = (x / x.field.pi).fraction()
    return halves is not None and halves.denominator == 1


def is_quarter(x: Ratio) -> bool:
    """Whether an element is zero, or a multiple of a quarter turn."""
    quarters = (2 * x / x.field.pi).fraction()
    return quarters is not None and quarters.denominator == 1


def without_strict_factors(x: Ratio) -> Ratio:
    """An element that vanishes where x does, without the factors that never do."""
    product = x.field.one
    for base, _exponent in x.field.factor(x.num)[1]:
        if not sign_of(base).is_strict:
            product = product * base
    return x if product == 1 else product


def without_arc(model: SymbolicModel, value: Ratio, target: Ratio) -> Ratio:
    """What vanishes where a value is reached; of an arc acos(u) it is u - cos(target)."""
    f = model.field
    (only,) = value.generators() if len(value.generators()) == 1 else (None,)
    name, argument = f.arguments.get(only, ("", f.one)) if only is not None else ("", f.one)
    inverse = {"acos": "cos", "asin": "sin", "atan": "tan"}.get(name)
    if inverse is None or only is None or value != f.variable(only):
        return f.lowest_terms(value - target)
    return f.lowest_terms(argument - functions(f, model.samples.is_negative)[inverse](target))


@dataclass
class Solutions:
    """Values of a rate or a coordinate (`index`) with which a motion is steady, and of rates that go with them."""

    index: int
    roots: list[Ratio] = field(default_factory=list[Ratio])
    notes: list[str] = field(default_factory=list[str])
    with_them: dict[int, Ratio] = field(default_factory=dict[int, Ratio])


def unknown_of(steady: SteadyMotion, q: SteadyValue) -> Coordinate | None:
    """The coordinate whose rate or, if it stays constant, whose value is asked for."""
    measure, order = q.of.watched or (None, 2)
    if order > 1:
        return None
    among = steady.cyclic if order else steady.others
    return next((c for c in among if steady.model.measure_of(c) == measure), None)


def rate_among(steady: SteadyMotion, parts: Iterable[Quantity]) -> Coordinate | None:
    """The first of the rates from which a quantity is made, as a ratio is, that the one condition of steady motion
    tells by the others."""
    if len(steady.equations) != 1:
        return None
    told = steady.equations[0].generators()
    watched = (part.watched for part in parts)
    rates = [measure for measure, order in (w for w in watched if w is not None) if order == 1]
    found = (c for m in rates for c in steady.cyclic if c.speed in told and steady.model.measure_of(c) == m)
    return next(found, None)
