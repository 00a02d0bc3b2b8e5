"""The symbolic route's view of a system at an instant: everything as a field element in q, u and t."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import cached_property
from typing import Any

from freebody.errors import CannotAnswer, FormulaTooLong
from freebody.language.expression import (
    Expr,
    PowerOf,
    ProductOf,
    Sum,
    Symbol,
    children,
    differentiate,
    free_symbols,
    number,
    power,
    substitute,
    whole_exponent,
)
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.measures.geometry import SpatialPose, Vector
from freebody.model.elements import AppliedLoad, ConstraintRow, NonholonomicForm
from freebody.model.state import JustBefore, no_direction, not_beside
from freebody.symbolic.blow import Blow
from freebody.symbolic.field import Field
from freebody.symbolic.functions import IsNegative, atan2, functions
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign, sign_of

_POLYNOMIAL_LIMIT = 12
_MOST_TERMS_OF_VECTOR = 200  # whose size is formed in one piece
_MOST_THROUGH_LOOPS = 8  # the same where a chain of names has the components


class SymbolicState:
    """A general instant, or with `values` one at which some generators have given elements (the start)."""

    def __init__(
        self, model: SymbolicModel, values: Mapping[int, Ratio] | None = None, blow: Blow | None = None
    ) -> None:
        """blow: by which the velocities of the start come about."""
        self.model = model
        self.values = dict(values or {})
        self._blow = blow

    def here(self, x: Ratio) -> Ratio:
        """An element at this instant."""
        given, field = self.model.given_constants, self.model.field
        if self.values:  # which may contain the constants, as a speed by energy does
            x = field.follow(self.model.in_independent_speeds(x), {**given, **self.values})
        return field.follow(x, given) if field.ingredients(x) & given.keys() else x

    def scalar(self, expr: Expr) -> Ratio:
        return self.model.geometry.scalar(expr)

    def value(self, measure: Measure) -> Ratio:
        return self.here(self.model.value_of(measure))

    def raw_rate(self, measure: Measure | NonholonomicForm) -> Ratio:
        """The rate with the speeds of dependent coordinates as they are."""
        return self.model.rate_of(measure)

    def rate(self, measure: Measure | NonholonomicForm) -> Ratio:
        return self.here(self.model.in_independent_speeds(self.raw_rate(measure)))

    def acceleration(self, measure: Measure | NonholonomicForm) -> Ratio:
        m = self.model
        second = m.rate(self.raw_rate(measure))
        if second.generators() & set(m.accelerations):
            second = m.dynamics.determined(m.field.substitute(second, m.dynamics.open_accelerations))
        if m.system.space:
            second = m.field.lowest_terms(m.in_independent_speeds(second))
        return self.here(second)

    def gradient(self, measure: Measure | NonholonomicForm, body: str) -> tuple[Ratio, ...]:
        slopes, pose = self.model.gradient(measure), self.model.geometry.pose(body)
        zero = self.model.field.zero
        along = tuple(slopes.get((body, slot), zero) for slot in self.model.bodies.slots)
        if isinstance(pose, SpatialPose):  # a moment along the body's axes, by its components on the ground
            moment = pose.turn(Vector(*along[3:]))
            along = (*along[:3], moment.x, moment.y, zero if moment.z is None else moment.z)
        return tuple(map(self.here, along))

    def multiplier(self, row: ConstraintRow) -> Ratio:
        try:
            return self.here(self.model.reactions.multiplier(row))
        except FormulaTooLong:
            if not self._is_one_pose:
                raise
            return self.model.reactions.in_pose(row, self._made_short, self._accelerations)

    @property
    def _is_one_pose(self) -> bool:
        """Whether everything has a value here, what loops bind too."""
        known = (*self.model.coordinates, *self.model.dependent)
        return all(c.index in self.values for c in known)

    def _made_short(self, x: Ratio) -> Ratio:
        return self.model.field.lowest_terms(self.here(x))

    @cached_property
    def _accelerations(self) -> Mapping[int, Ratio]:
        """Of the coordinates in this pose."""
        return self.model.dynamics.accelerations_in(self._made_short)

    def impulse(self, row: ConstraintRow) -> Ratio:
        return self.blow.impulse(row)

    @property
    def energy_before(self) -> Ratio:
        return self.blow.energy_before

    def rate_before(self, measure: Measure | NonholonomicForm) -> Ratio:
        return self.blow.rate_before(measure)

    def beside_blow(self, quantity: Any, side: str) -> Any:
        if side == "start":
            raise not_beside(side)
        return quantity.value(self.model.system, JustBefore(self))

    @property
    def is_struck(self) -> bool:
        """Whether a blow brought it about."""
        return self._blow is not None

    @property
    def blow(self) -> Blow:
        """The blow of the start. Raises CannotAnswer where there is none."""
        if self._blow is None:
            raise CannotAnswer(Message("nothing is struck here"))
        return self._blow

    def law(self, push: AppliedLoad) -> Ratio:
        return self.here(self.model.loads.law(push))

    def potential(self, push: AppliedLoad) -> Ratio:
        """-integral of the law over its measure: from 0 for laws that are polynomials in it, from infinity for sums of
        c/x^n with n > 1, which have a pole at 0 and fade out."""
        field = self.model.field
        inverse = inverse_powers(push)
        coefficients = law_polynomial(push) if inverse is None else []
        assert not isinstance(push.measure, NonholonomicForm)
        value = self.model.value_of(push.measure) - self.model.loads.start_constant(push)
        total = field.zero
        for k, coefficient in enumerate(coefficients):
            total = total - self.scalar(coefficient) * value ** (k + 1) / (k + 1)
        for n, coefficient in (inverse or {}).items():
            total = total + self.scalar(coefficient) / (value ** (n - 1) * (n - 1))
        return self.here(total)

    def sqrt(self, x: Any) -> Ratio:
        return self.model.field.sqrt(x, self.model.samples.is_turned)

    def size(self, vector: tuple[Any, ...]) -> Ratio:
        """Raises FormulaTooLong where the components are so long that nobody reads a root of their squares."""
        parts = [x for x in map(self.model.field.element, vector) if not x.is_zero()]
        if len(parts) == 1:  # of what is guided along a line, however long that is
            return self.root_of_squares(parts)
        most = _MOST_THROUGH_LOOPS if self.model.loops else _MOST_TERMS_OF_VECTOR
        if sum(x.n_terms for x in parts) > most:
            raise FormulaTooLong(Message("the size of a vector with such long components is a chain of formulas"))
        return self.root_of_squares(parts)

    def root_of_squares(self, parts: Sequence[Ratio]) -> Ratio:
        """The root of a sum of squares, which is real whatever they are."""
        f = self.model.field
        below = self._common_denominator(parts)
        found = self.sqrt(sum((x * x for x in (f.lowest_terms(part * below) for part in parts)), start=f.zero))
        found = found / f.size_of(below, self.model.samples.is_turned)
        within = set[int]().union(*(x.generators() for x in parts))
        f.real_roots |= {g for g in found.generators() - within if f.generators[g].kind == "root"}
        return found

    def _common_denominator(self, parts: Sequence[Ratio]) -> Ratio:
        """A sum in cosines and sines that all parts are divided by, sin(a - b): its square is none in normal form.
        One where there is none."""
        f = self.model.field
        below = max((x.denominator() for x in parts), key=lambda x: x.n_terms, default=f.one)
        is_round = below.n_terms > 1 and len(f.pairs(below.generators())) > 1
        return below if is_round and all(f.lowest_terms(x * below).den is None for x in parts) else f.one

    def absolute(self, x: Any) -> Ratio:
        """As a root, out of which only factors come whose sign is known: |m1 - m2| g."""

        def is_negative(factor: Ratio) -> bool | None:
            sign = sign_of(factor)
            return None if sign in (Sign.UNKNOWN, Sign.ZERO) else sign in (Sign.NEGATIVE, Sign.NONPOSITIVE)

        element = self.model.field.element(x)
        return self.model.field.sqrt(element * element, is_negative)

    def function(self, name: str, x: Any) -> Ratio:
        f = self.model.field
        return functions(f, self.model.samples.is_turned)[name](f.lowest_terms(f.element(x)))

    def direction(self, y: Any, x: Any) -> Ratio:
        f = self.model.field
        up, along = (f.lowest_terms(f.element(part)) for part in (y, x))
        return direction_of(f, up, along, self.model.samples.is_turned)


def direction_of(field: Field, y: Ratio, x: Ratio, is_turned: IsNegative | None) -> Ratio:
    """The angle of a vector: atan(y/x) where x is known to be positive, +-pi/2 - atan(x/y) where the sign of y is
    known, else by the half angle, tan(a/2) = y/(sqrt(x^2 + y^2) + x). Raises CannotAnswer for a vector of no length."""
    if x.is_zero() and y.is_zero():
        raise no_direction()
    atan = functions(field, is_turned)["atan"]
    if sign_of(x) is Sign.POSITIVE:
        return atan(y / x)
    upright = sign_of(y)
    if upright in (Sign.POSITIVE, Sign.NEGATIVE):
        return field.pi / 2 * (1 if upright is Sign.POSITIVE else -1) - atan(x / y)
    if y.is_zero() and sign_of(x) is Sign.NEGATIVE:
        return field.pi
    return atan2(field, y, x, field.sqrt(x * x + y * y, is_turned))


def law_polynomial(push: AppliedLoad) -> list[Expr]:
    """Coefficients c_k of a law sum c_k value^k. Raises CannotAnswer if the load has no such potential."""
    if isinstance(push.measure, NonholonomicForm):
        raise CannotAnswer(
            Message("the direction of {load} changes with the motion, so it has no potential energy", load=push.load)
        )
    symbols = free_symbols(push.law)
    if push.measures or push.general is not None or {"@rate", "t"} & symbols or "rate(" in str(push.law):
        raise CannotAnswer(
            Message("{load} depends on time, a rate or another measure and has no potential energy", load=push.load)
        )
    if not _is_polynomial(push.law):
        raise CannotAnswer(
            Message("the law of {load} is no polynomial in its measure, so its potential is not closed", load=push.load)
        )
    coefficients: list[Expr] = []
    derivative = push.law
    factorial = 1
    for k in range(_POLYNOMIAL_LIMIT):
        try:
            coefficients.append(substitute(derivative, {"@value": number(0)}) * Fraction(1, factorial))
        except ZeroDivisionError:
            raise CannotAnswer(
                Message("the law of {load} is singular at 0 and no polynomial", load=push.load)
            ) from None
        derivative = differentiate(derivative, "@value")
        if "@value" not in free_symbols(derivative):
            if derivative != number(0):
                coefficients.append(derivative * Fraction(1, factorial * (k + 1)))
            return coefficients
        factorial *= k + 1
    raise CannotAnswer(
        Message("the law of {load} is no polynomial in its measure, so its potential is not closed", load=push.load)
    )


def inverse_powers(push: AppliedLoad) -> dict[int, Expr] | None:
    """Coefficients c_n of a law sum c_n/value^n with all n > 1, by n; None where it is not of that form."""
    if isinstance(push.measure, NonholonomicForm) or push.measure.incremental or push.measures or push.general:
        return None
    found: dict[int, Expr] = {}
    for term in push.law.terms if isinstance(push.law, Sum) else (push.law,):
        monomial = _monomial(term)
        if monomial is None or monomial[1] > -2 or {"t", "@rate"} & free_symbols(monomial[0]):
            return None
        found[-monomial[1]] = found.get(-monomial[1], number(0)) + monomial[0]
    return found


def _monomial(e: Expr) -> tuple[Expr, int] | None:
    """(c, n) of c value^n; None for anything else."""
    if "@value" not in free_symbols(e):
        return e, 0
    match e:
        case Symbol():
            return number(1), 1
        case ProductOf(factors):
            parts = [_monomial(factor) for factor in factors]
            c, n = number(1), 0
            for part in parts:
                if part is None:
                    return None
                c, n = c * part[0], n + part[1]
            return c, n
        case PowerOf(base, exponent):
            inner, k = _monomial(base), whole_exponent(e)
            return None if inner is None or k is None else (power(inner[0], exponent), inner[1] * k)
        case _:
            return None


def _is_polynomial(law: Expr) -> bool:
    """Whether the measure stands in sums, products and whole powers only."""
    if "@value" not in free_symbols(law):
        return True
    match law:
        case Symbol():
            return True
        case Sum() | ProductOf():
            return all(map(_is_polynomial, children(law)))
        case PowerOf(base, _):
            n = whole_exponent(law)
            return n is not None and n >= 0 and _is_polynomial(base)
        case _:
            return False


class StagedState(SymbolicState):
    """An instant at which closed loops are solved first, in general, and `values` put in afterwards: with numbers that
    have roots in them, as cos(30 deg), powers of a divisor are not seen to have common factors any more."""

    def __init__(self, model: SymbolicModel, loops: Mapping[int, Ratio], values: Mapping[int, Ratio]) -> None:
        super().__init__(model, values)
        self._loops = dict(loops)

    def here(self, x: Ratio) -> Ratio:
        f = self.model.field
        solved = f.follow(self.model.in_independent_speeds(x), {**self.model.given_constants, **self._loops})
        return super().here(f.lowest_terms(solved))
