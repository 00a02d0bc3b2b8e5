"""The motion of one phase in closed form, and where a function of the state vanishes along it.

    rest      nothing can move
    uniform   every acceleration is constant:    q(t) = q0 + u0 t + a t^2/2; what is a polynomial in q and u is one in t
    laws      every coordinate by itself: harmonic, or exponential (`symbolic/laws`), or several by modes (`modes.py`)
    energy    one coordinate on which all depends, and loads with potentials:    u^2 = (M0 u0^2 + 2 V0 - 2 V(q))/M(q);
              what is even in u is a function of q; speeds of other coordinates follow by their momenta

t is the time since the phase began.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.symbolic.laws.base import Instants, LawInstant, MotionLaw
from freebody.symbolic.laws.uniform import UniformLaw
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.quadratic import roots
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.start import StartState
from freebody.symbolic.unknowns import Coordinate
from freebody.symbolic.zeros import reals, solve_linear, without_root, zeros_of

TAU = "@since"  # the time since a phase began, as a generator


@dataclass(frozen=True)
class CourseZero:
    """A place where a function vanishes along the course: after a time, or at a value of the coordinate."""

    time: Ratio | None
    values: Mapping[int, Ratio]  # coordinates and speeds there, by generator
    at: Ratio | None = None  # of the coordinate, where energy gives the motion
    needs: tuple[Ratio, ...] = ()  # positive where it is real and after the start, as far as that is known otherwise


class ClosedFormMotion:
    """What the kinds of motion have in common."""

    sides: tuple[Ratio, ...] = ()  # of the parameters, positive where the motion is of this kind

    def __init__(self, model: SymbolicModel, start: StartState, still: Mapping[int, Ratio] | None = None) -> None:
        self.model = model
        self.start = start
        self.still = dict(still or {})  # dependent coordinates that do not move

    @property
    def kind(self) -> str:
        raise NotImplementedError

    def along(self, x: Ratio) -> list[Ratio]:
        """Coefficients of a function of the state: of the powers of the time, lowest first."""
        raise NotImplementedError

    def zeros(self, x: Ratio) -> list[CourseZero]:
        """All zeros after the start that have a closed form."""
        raise NotImplementedError

    def plain(self, x: Ratio) -> Ratio:
        """With what does not move put in."""
        f = self.model.field
        return f.lowest_terms(f.follow(self.model.in_independent_speeds(x), self.still))


class MotionInTime(ClosedFormMotion):
    """The coordinates are functions of the time."""

    @cached_property
    def tau(self) -> Ratio:
        return self.model.field.parameter(TAU)

    def values(self, time: Ratio) -> dict[int, Ratio]:
        """Coordinates and speeds at a time, by generator, and the time."""
        raise NotImplementedError

    @property
    def units_of_time(self) -> Sequence[Ratio]:
        """In which it does what it does, their signs aside."""
        return ()

    def over_time(self, x: Ratio) -> Ratio:
        """A function of the state as one of the time `tau`."""
        return self.model.field.follow(self.model.in_independent_speeds(x), self.values(self.tau))


class UniformMotion(MotionInTime):
    """Constant accelerations."""

    @property
    def kind(self) -> str:
        return "uniform" if self.model.coordinates else "rest"

    @cached_property
    def accelerations(self) -> dict[int, Ratio]:
        """By the generator of the speed."""
        m = self.model
        found = zip(m.coordinates, m.accelerations, strict=True)
        return {c.speed: self.plain(m.dynamics.solved_accelerations[a]) for c, a in found}

    def values(self, time: Ratio) -> dict[int, Ratio]:
        """Coordinates and speeds at a time."""
        f = self.model.field
        found: dict[int, Ratio] = {f.index(f.time): time, **self.still}
        for c in self.model.coordinates:
            q, u, a = self.start.of(c.index), self.start.of(c.speed), self.accelerations[c.speed]
            found[c.index] = f.lowest_terms(q + u * time + a * time * time / 2)
            found[c.speed] = f.lowest_terms(u + a * time)
        return found

    def along(self, x: Ratio) -> list[Ratio]:
        """Raises CannotAnswer where the function is no polynomial in the time."""
        f = self.model.field
        index = f.index(self.tau)
        x = without_root(self.over_time(x), index)
        if index in f.ingredients(x.denominator()) or any(
            index in f.generators[g].made_of for g in x.generators() if g != index
        ):
            raise CannotAnswer(Message("it is no polynomial in the time"))
        below = x.denominator()
        return [f.lowest_terms(c / below) for c in x.numerator().coefficients(index)] or [f.zero]

    def sign_along(self, x: Ratio) -> list[Ratio]:
        """Coefficients of a polynomial in the time that has the sign of a function of the state everywhere: where that
        has no roots in closed form here, without the factors that stand in it to an even power. Raises CannotAnswer."""
        c, f = self.along(x), self.model.field
        if has_roots(behind_zeros(c)):
            return c
        whole = f.lowest_terms(sum((part * self.tau**k for k, part in enumerate(c)), f.zero))
        even, index = f.one, f.index(self.tau)
        for base, exponent in f.factor(whole.num)[1]:
            if index in base.generators():
                even = even * base ** (exponent - exponent % 2)
        rest = f.lowest_terms(whole / even)
        below = rest.denominator()
        return [f.lowest_terms(part / below) for part in rest.numerator().coefficients(index)] or [f.zero]

    def parts_along(self, x: Ratio) -> list[list[Ratio]]:
        """Polynomials in the time, by their coefficients, whose product has the sign of a function of the state:
        itself, or where that has no roots in closed form here its factors. Raises CannotAnswer."""
        whole = self.sign_along(x)
        if has_roots(behind_zeros(whole)):
            return [whole]
        there = {c.index: self.start.of(c.index) for c in self.model.coordinates if self._rests(c)}
        alone = self.model.field.follow(self.plain(x), there)
        odd = [base for base, exponent in self.model.field.factor(alone.num)[1] if exponent % 2]
        return [self.sign_along(base) for base in odd] if len(odd) > 1 else [whole]

    def _rests(self, c: Coordinate) -> bool:
        return self.start.of(c.speed).is_zero() and self.accelerations[c.speed].is_zero()

    def zeros(self, x: Ratio) -> list[CourseZero]:
        try:
            times = [t for part in self.parts_along(x) for t in polynomial_roots(self.model, part)]
        except CannotAnswer:
            return self._in_waves(x)
        return [CourseZero(t, self.values(t)) for t in times]

    def _in_waves(self, x: Ratio) -> list[CourseZero]:
        """Of what is driven in a wave of the time; an instant before the start comes again a period later."""
        f, own = self.model.field, Coordinate(TAU, self.model.field.index(self.tau), -1, is_angle=False)
        places = zeros_of(self.model, self.over_time(x).numerator(), own)
        later = [f.zero, *(way * period for period in self.periods(x) for way in (1, -1))]
        times = [f.lowest_terms(place + shift) for place in places for shift in later]
        return [CourseZero(t, self.values(t), needs=reals(t)) for t in times]

    def periods(self, x: Ratio) -> list[Ratio]:
        """Of the waves of the time in a function of the state; their sign is not known."""
        f, index = self.model.field, self.model.field.index(self.tau)
        inside = f.ingredients(self.over_time(x))
        angles = [f.angles[cos] for cos, _sin in f.pairs(inside) if index in f.ingredients(f.angles[cos])]
        slopes = [f.partial(angle, index) for angle in angles]
        return [2 * f.pi / k for k in slopes if not k.is_zero()]


class LawMotion(MotionInTime):
    """Every coordinate moves by a law of its own, whatever the others do. still: those that stay where they start."""

    def __init__(
        self,
        model: SymbolicModel,
        start: StartState,
        laws: Sequence[MotionLaw],
        still: dict[int, Ratio],
        sides: Sequence[Ratio] = (),
    ) -> None:
        super().__init__(model, start, still)
        self.laws, self.sides = tuple(laws), tuple(sides)

    @property
    def kind(self) -> str:
        return "laws"

    @property
    def units_of_time(self) -> Sequence[Ratio]:
        return units_of(self.laws)

    def values(self, time: Ratio) -> dict[int, Ratio]:
        """Coordinates and speeds at a time."""
        f = self.model.field
        found: dict[int, Ratio] = {f.index(f.time): time}
        for c, law in zip(self.model.coordinates, self.laws, strict=True):
            found[c.index], found[c.speed] = map(f.lowest_terms, law.at(time))
        return found

    def along(self, x: Ratio) -> list[Ratio]:
        raise CannotAnswer(Message("it is no polynomial in the time"))

    def zeros(self, x: Ratio) -> list[CourseZero]:
        """Of factors that are linear in one coordinate, or in its rate, or of the time alone. Raises CannotAnswer for
        any other."""
        f = self.model.field
        found: list[CourseZero] = []
        for base, _exponent in f.factor(self.plain(x).num)[1]:
            inside = f.ingredients(base)
            moving = [(c, law) for c, law in self._each if inside & {c.index, c.speed}]
            if f.index(f.time) in inside and not moving:
                found += self._at_times(base)
            elif len(moving) > 1 or f.index(f.time) in inside:
                raise CannotAnswer(Message("it depends on several coordinates, or on the time as well"))
            for c, law in moving:
                found += self._instants(base, c, law)
        return found

    def _at_times(self, base: Ratio) -> Iterator[CourseZero]:
        """Where a polynomial of the time vanishes."""
        f = self.model.field
        index = f.index(f.time)
        if any(index in f.generators[g].made_of for g in f.ingredients(base) if g != index):
            raise CannotAnswer(Message("it is no polynomial in the time"))
        for time in polynomial_roots(self.model, base.coefficients(index)):
            yield CourseZero(time, self.values(time), needs=(time,))

    @property
    def _each(self) -> Iterator[tuple[Coordinate, MotionLaw]]:
        return zip(self.model.coordinates, self.laws, strict=True)

    def _instants(self, base: Ratio, c: Coordinate, law: MotionLaw) -> Iterator[CourseZero]:
        """At most one period later: an instant before the start comes again."""
        inside, index = self.model.field.ingredients(base), c.index
        if c.speed in inside:
            index = c.speed
        value = None if {c.index, c.speed} <= inside else solve_linear(base, index)
        if value is not None and index == c.index and isinstance(law, UniformLaw):
            for time in polynomial_roots(self.model, [law.q0 - value, law.u0, law.a / 2]):
                yield CourseZero(time, self.values(time), needs=(time,))
            return
        instants = None if value is None else law.places(value) if index == c.index else law.rates(value)
        if instants is None:
            raise CannotAnswer(Message("it has no closed form in the time"))
        for time, instant, needs in within_a_period(instants):
            own = {c.index: instant.place, c.speed: instant.rate}
            yield CourseZero(time, {**self.values(time), **own}, needs=needs)


def within_a_period(instants: Instants) -> Iterator[tuple[Ratio, LawInstant, tuple[Ratio, ...]]]:
    """The times of instants, with what is positive where each is real and after the start: those of them that come
    again once more, a period later."""
    assert instants is not None
    needs = tuple(x for x, _relation in instants[1])
    for instant in instants[0]:
        key = () if instant.key is None else (instant.key,)  # of the sign of the time
        yield instant.time, instant, (*needs, *key)
        if instant.period is not None:
            yield instant.time + instant.period, instant, (*needs, *(-x for x in key))


def units_of(laws: Sequence[MotionLaw]) -> list[Ratio]:
    """The units of time of laws, without those that have none."""
    return [law.unit_of_time for law in laws if law.unit_of_time is not None]


def behind_zeros(c: Sequence[Ratio]) -> Sequence[Ratio]:
    """The coefficients of a polynomial without its zeros at the start itself."""
    return c[next((k for k, part in enumerate(c) if not part.is_zero()), 0) :]


def has_roots(c: Sequence[Ratio]) -> bool:
    """Whether a polynomial has roots in closed form here: one of the second degree at most, or one in the square of
    the unknown."""
    return len(c) <= 3 or (len(c) == 5 and c[1].is_zero() and c[3].is_zero())


def polynomial_roots(model: SymbolicModel, c: list[Ratio]) -> list[Ratio]:
    """Roots other than zero of a polynomial of degree two at most, of which the coefficients are given, or of one in
    the square of the unknown."""
    c = list(c)
    while c and c[-1].is_zero():
        c.pop()
    while c and c[0].is_zero():
        c.pop(0)
    if len(c) < 2:
        return []
    if len(c) == 5 and c[1].is_zero() and c[3].is_zero():
        squares = roots(c[::2], model.samples.is_negative) or []
        return [sign * model.field.sqrt(x, model.samples.is_negative) for x in squares for sign in (-1, 1)]
    found = roots(c, model.samples.is_negative)
    if found is None:
        raise CannotAnswer(Message("the time is a root of a polynomial of degree {n}", n=len(c) - 1))
    return found
