"""When does an element vanish for every motion?

Coordinates and independent speeds may have any values at one instant, so an element that is a polynomial in them
(and in the sines and cosines of angles, in normal form) vanishes for every motion if and only if each of its
coefficients does. The coefficients contain parameters and given functions of time only. All of them must be zero, and
each is zero if one of its factors is: that gives cases, every one a set of equalities.

Which parameters may be zero is told by `may_vanish`; a case that would need another one to be zero is none. What a case
says is put in before the next coefficient is looked at, so that no case contains a superfluous equality.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from freebody.errors import CannotAnswer
from freebody.language.expression import ZERO, Call, Symbol
from freebody.language.notation import Stated, compared, joined, to_python, to_text
from freebody.language.sentences import Message
from freebody.symbolic.conditions import relation_text
from freebody.symbolic.field import Field
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign, sign_of
from freebody.symbolic.tidy import tidy

_MOST_CASES = 64

MayVanish = Callable[[int], bool]  # of a generator that is a parameter


@dataclass(frozen=True)
class VanishingCase:
    """Equalities that hold together (none: always), and what they put in for generators. A given function of time that
    is zero is so at all times, and its rates with it."""

    equalities: tuple[Ratio, ...]
    values: Mapping[int, Ratio]
    is_solved: bool = True  # False: an equality could not be solved for a parameter

    def put_in(self, x: Ratio) -> Ratio:
        """An element in this case. Raises CannotAnswer where it has no value then."""
        try:
            return x.field.follow(x, self.values) if self.values else x
        except ZeroDivisionError:
            raise CannotAnswer(Message("it has no value for {case}", case=joined(self.texts()))) from None

    def with_more(self, more: VanishingCase) -> VanishingCase:
        """Both cases together."""
        values = {k: more.put_in(v) for k, v in self.values.items()} | dict(more.values)
        return VanishingCase((*self.equalities, *more.equalities), values, self.is_solved and more.is_solved)

    def kills(self, x: Ratio) -> bool:
        """Whether an element is zero in this case. Raises CannotAnswer where it has no value then."""
        put = self.put_in(x)
        if self.is_solved or put.is_zero():
            return put.is_zero()
        return any(_divides(e, put.numerator()) for e in self.equalities)

    def texts(self) -> tuple[Stated, ...]:
        return tuple(equality_text(e) for e in self.equalities)


ALWAYS = VanishingCase((), {})


def equality_text(x: Ratio) -> Stated:
    """x = 0 as people write it: d = 0, m1 = m2, an angle instead of its sine, a rate that is zero as a constant."""
    shown = tidy(x)
    angle = _angle_of(x)
    if angle is not None:
        return angle
    if isinstance(shown, Call) and shown.function == "rate":
        zero = compared(shown, "=", ZERO)
        return Stated(Message("{zero} ({x} is constant)", zero=zero, x=to_text(shown.argument)), zero.expression)
    return relation_text(shown, "=")


def _angle_of(x: Ratio) -> Stated | None:
    """sin(alpha) = 0 as alpha = 0."""
    field = x.field
    if x.den is not None or len(x.generators()) != 1:
        return None
    (index,) = x.generators()
    kind = field.generators[index].kind
    if kind not in ("cos", "sin") or x != field.variable(index):
        return None
    angle = tidy(field.angles[index if kind == "cos" else index - 1])
    if kind == "sin":
        return compared(angle, "=", ZERO)
    return Stated(f"{to_text(angle)} = 90°", f"{to_python(angle)} == pi/2")


def motion_coefficients(x: Ratio, is_parameter: Callable[[int], bool]) -> list[Ratio]:
    """Coefficients of the numerator with respect to everything that a motion may have otherwise: coordinates, speeds,
    start values, their sines, cosines and roots, and the time. Parameters and given functions of time stay."""
    return [coefficient for _moving, coefficient in motion_terms(x, is_parameter)]


def motion_terms(x: Ratio, is_parameter: Callable[[int], bool]) -> list[tuple[Ratio, Ratio]]:
    """The same with what each coefficient stands before: products of what moves."""
    field = x.field

    def stays(index: int) -> bool:
        if field.generators[index].kind == "parameter":
            return is_parameter(index)
        if is_given_function(field, index):
            return True
        return field.is_constant_generator(index) and all(map(stays, field.generators[index].made_of))

    groups: dict[tuple[tuple[int, int], ...], dict[tuple[tuple[int, int], ...], int]] = {}
    for monomial, coefficient in field.terms(x.num).items():
        moving = tuple(item for item in monomial if not stays(item[0]))
        rest = tuple(item for item in monomial if stays(item[0]))
        groups.setdefault(moving, {})[rest] = coefficient
    found = [(field.polynomial({moving: 1}), field.polynomial(terms)) for moving, terms in groups.items()]
    return [(moving, c) for moving, c in found if not c.is_zero()]


def is_given_function(field: Field, index: int) -> bool:
    """True for a given function of time and its rates."""
    g = field.generators[index]
    return g.kind == "time" and g.display != Symbol("t")


def cases_where_zero(coefficients: Sequence[Ratio], may_vanish: MayVanish) -> tuple[VanishingCase, ...]:
    """All cases in which every coefficient is zero, the more special left out where a more general one covers them.
    No case: they are never all zero; the case without equalities: they always are."""
    return most_general(list(_cases(list(coefficients), ALWAYS, may_vanish)))


def most_general(found: Sequence[VanishingCase]) -> tuple[VanishingCase, ...]:
    """The cases that no other one covers."""
    general: list[VanishingCase] = []
    for k, case in enumerate(found):
        if not any(implies(case, other) for other in (*general, *found[k + 1 :])):
            general.append(case)
    return tuple(general)


def implies(case: VanishingCase, other: VanishingCase) -> bool:
    """Whether all equalities of the other case hold in this one."""
    try:
        return all(case.kills(e) for e in other.equalities)
    except CannotAnswer:
        return False


def _cases(open_: list[Ratio], so_far: VanishingCase, may_vanish: MayVanish) -> Iterator[VanishingCase]:
    open_ = [x for x in open_ if not x.is_zero()]
    if not open_:
        if all(map(so_far.kills, so_far.equalities)):  # what came later may contradict what came before
            yield _read_off(so_far)
        return
    # the coefficient with the fewest ways to vanish decides first
    ways = [(list(_ways(x, may_vanish)), x) for x in open_]
    first, own = min(ways, key=lambda w: (len(w[0]), len(w[1].num)))
    for way in first[:_MOST_CASES]:
        try:
            rest = [way.put_in(x).numerator() for x in open_ if way.is_solved or x is not own]
            values = {k: way.put_in(v) for k, v in so_far.values.items()} | dict(way.values)
        except CannotAnswer:
            continue
        if not way.is_solved:
            rest = [x for x in rest if not _divides(way.equalities[0], x)]
        together = VanishingCase((*so_far.equalities, *way.equalities), values, so_far.is_solved and way.is_solved)
        yield from _cases(rest, together, may_vanish)


def _read_off(case: VanishingCase) -> VanishingCase:
    """The case with each equality that later ones made simpler as what it has come to."""
    equalities: list[Ratio] = []
    for e in case.equalities:
        solved = [k for k in case.values if k in e.generators() and e.field.generators[k].kind == "parameter"]
        if solved and len(case.equalities) > 1:
            k = max(solved)
            come_to = (e.field.variable(k) - case.values[k]).numerator()
            e = come_to if len(come_to.num) < len(e.num) else e
        if all(e != other and e != -other for other in equalities):
            equalities.append(e)
    # a function that is zero has rates that are
    field = equalities[0].field if equalities else None
    functions = [e for e in equalities if field is not None and _is_function(field, e)]
    later = [r for e in functions for r in _rates_of(e)]
    return VanishingCase(tuple(e for e in equalities if e not in later), case.values, case.is_solved)


def _is_function(field: Field, x: Ratio) -> bool:
    return len(x.generators()) == 1 and is_given_function(field, min(x.generators())) and len(x.num) == 1


def _rates_of(function: Ratio) -> list[Ratio]:
    found: list[Ratio] = []
    rate = function.field.rate(function)
    while not rate.is_zero():
        found.append(rate)
        rate = function.field.rate(rate)
    return found


def _divides(factor: Ratio, x: Ratio) -> bool:
    return (x / factor).den is None


def _ways(x: Ratio, may_vanish: MayVanish) -> Iterator[VanishingCase]:
    """The ways in which one coefficient can be zero."""
    _unit, factors = x.field.factor(x.num)
    for base, _exponent in factors:
        yield from factor_zero(base, may_vanish)


def factor_zero(base: Ratio, may_vanish: MayVanish) -> Iterator[VanishingCase]:
    """The ways in which an irreducible factor can be zero."""
    field = base.field
    if not base.generators():
        return
    if len(base.generators()) == 1 and base.den is None:
        (index,) = base.generators()
        if base == field.variable(index):
            yield from _generator_zero(field, index, may_vanish)
            return
        right = _right_angle(base)
        if right is not None:
            yield from _generator_zero(field, right, may_vanish)
            return
    sign = sign_of(base)
    if sign in (Sign.POSITIVE, Sign.NEGATIVE, Sign.NONNEGATIVE, Sign.NONPOSITIVE):
        yield from _sum_zero(base, may_vanish)
        return
    yield from _solved(base, may_vanish)


def _right_angle(base: Ratio) -> int | None:
    """cos(a) - 1 is zero where sin(a) is, sin(a) - 1 where cos(a) is, for an angle below 90 degrees."""
    field = base.field
    (index,) = base.generators()
    kind = field.generators[index].kind
    if kind not in ("cos", "sin") or not field.generators[index].positive:
        return None
    if base not in (field.variable(index) - 1, 1 - field.variable(index)):
        return None
    return index + 1 if kind == "cos" else index - 1


def _generator_zero(field: Field, index: int, may_vanish: MayVanish) -> Iterator[VanishingCase]:
    g = field.generators[index]
    x = field.variable(index)
    if is_given_function(field, index):
        yield VanishingCase((x,), dict(_with_rates(field, index, field.zero)))
    elif g.kind in ("cos", "sin"):
        angle = field.angles[index if g.kind == "cos" else index - 1]
        inside = [k for k in angle.generators() if may_vanish(k)]
        if len(inside) == 1:
            target = field.zero if g.kind == "sin" else field.pi / 2
            slope = field.partial(angle, inside[0])
            rest = angle - slope * field.variable(inside[0])
            yield VanishingCase((x,), {inside[0]: (target - rest) / slope})
    elif g.kind == "parameter" and may_vanish(index):
        yield VanishingCase((x,), {index: field.zero})


def _sum_zero(base: Ratio, may_vanish: MayVanish) -> Iterator[VanishingCase]:
    """A sum of terms of one sign is zero if every term is."""
    field = base.field
    terms = field.terms(base.num)
    if len(terms) > 1:
        monomials = [field.polynomial({monomial: 1}) for monomial in terms]
        yield from _cases(monomials, ALWAYS, may_vanish)


def _solved(base: Ratio, may_vanish: MayVanish) -> Iterator[VanishingCase]:
    """An equality, solved for the given function of highest order, or for the parameter declared last, in which it is
    linear; and, where the coefficient of that may vanish, the cases in which both parts do."""
    field = base.field
    functions = [g for g in base.generators() if is_given_function(field, g)]
    for index in (*sorted(functions, reverse=True), *sorted(base.generators(), reverse=True)):
        g = field.generators[index]
        if index not in functions and (g.kind != "parameter" or field.index(field.pi) == index or functions):
            continue
        parts = base.numerator().coefficients(index)
        if len(parts) != 2 or any(index in field.ingredients(part) for part in parts):
            continue
        value = -parts[0] / parts[1]
        if g.positive and sign_of(value) in (Sign.NEGATIVE, Sign.NONPOSITIVE, Sign.ZERO):
            continue
        values = {index: value} if index not in functions else dict(_with_rates(field, index, value))
        yield VanishingCase((base,), values)
        if not sign_of(parts[1]).is_strict:
            yield from _cases(list(parts), ALWAYS, may_vanish)
        return
    yield VanishingCase((base,), {}, is_solved=False)


def _with_rates(field: Field, index: int, value: Ratio) -> Iterable[tuple[int, Ratio]]:
    """A given function that is equal to something at all times, and its rates."""
    while True:
        yield index, value
        rate = field.rate(field.variable(index))
        if rate.is_zero():
            return
        index, value = field.index(rate), field.rate(value)


def texts_of(cases: Sequence[VanishingCase]) -> tuple[str, ...]:
    """One text for every case, its equalities joined."""
    return tuple(joined(case.texts()) for case in cases)
