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
from freebody.language.expression import Call, Symbol
from freebody.language.notation import to_text
from freebody.symbolic.conditions import relation_text
from freebody.symbolic.field import Field, Ratio
from freebody.symbolic.signs import Sign, sign_of
from freebody.symbolic.tidy import tidy

_MOST_CASES = 64

MayVanish = Callable[[int], bool]  # of a generator that is a parameter


@dataclass(frozen=True)
class Case:
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
            raise CannotAnswer(f"it has no value for {' and '.join(self.texts())}") from None

    def texts(self) -> tuple[str, ...]:
        return tuple(equality_text(e) for e in self.equalities)


ALWAYS = Case((), {})


def equality_text(x: Ratio) -> str:
    """x = 0 as people write it: d = 0, m1 = m2, an angle instead of its sine, a rate that is zero as a constant."""
    shown = tidy(x)
    angle = _angle_of(x)
    if angle is not None:
        return angle
    if isinstance(shown, Call) and shown.function == "rate":
        return f"{to_text(shown)} = 0 ({to_text(shown.argument)} is constant)"
    return relation_text(shown, "=")


def _angle_of(x: Ratio) -> str | None:
    """sin(alpha) = 0 as alpha = 0."""
    field = x.field
    if x.den is not None or len(x.generators()) != 1:
        return None
    (index,) = x.generators()
    kind = field.generators[index].kind
    if kind not in ("cos", "sin") or x != field.variable(index):
        return None
    angle = field.angles[index if kind == "cos" else index - 1]
    return f"{to_text(tidy(angle))} = {'0' if kind == 'sin' else '90°'}"


def motion_coefficients(x: Ratio, is_parameter: Callable[[int], bool]) -> list[Ratio]:
    """Coefficients of the numerator with respect to everything that a motion may have otherwise: coordinates, speeds,
    start values, their sines, cosines and roots, and the time. Parameters and given functions of time stay."""
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
    return [c for c in (field.polynomial(terms) for terms in groups.values()) if not c.is_zero()]


def is_given_function(field: Field, index: int) -> bool:
    """True for a given function of time and its rates."""
    g = field.generators[index]
    return g.kind == "time" and g.display != Symbol("t")


def cases_where_zero(coefficients: Sequence[Ratio], may_vanish: MayVanish) -> tuple[Case, ...]:
    """All cases in which every coefficient is zero, the more special left out where a more general one covers them.
    No case: they are never all zero; the case without equalities: they always are."""
    found = list(_cases(list(coefficients), ALWAYS, may_vanish))
    general: list[Case] = []
    for k, case in enumerate(found):
        if not any(implies(case, other) for other in (*general, *found[k + 1 :])):
            general.append(case)
    return tuple(general)


def implies(case: Case, other: Case) -> bool:
    """Whether all equalities of the other case hold in this one."""
    return all(_put(case, e).is_zero() for e in other.equalities)


def _put(case: Case, x: Ratio) -> Ratio:
    try:
        return case.put_in(x)
    except CannotAnswer:
        return x


def _cases(open_: list[Ratio], so_far: Case, may_vanish: MayVanish) -> Iterator[Case]:
    open_ = [x for x in open_ if not x.is_zero()]
    if not open_:
        yield so_far
        return
    # the coefficient with the fewest ways to vanish decides first
    ways = [(list(_ways(x, may_vanish)), x) for x in open_]
    first, own = min(ways, key=lambda w: (len(w[0]), len(w[1].num)))
    for way in first[:_MOST_CASES]:
        try:
            rest = [way.put_in(x).numerator() for x in open_ if way.is_solved or x is not own]
        except CannotAnswer:
            continue
        if not way.is_solved:
            rest = [x for x in rest if not _divides(way.equalities[0], x)]
        values = {k: way.put_in(v) for k, v in so_far.values.items()} | dict(way.values)
        together = Case((*so_far.equalities, *way.equalities), values, so_far.is_solved and way.is_solved)
        yield from _cases(rest, together, may_vanish)


def _divides(factor: Ratio, x: Ratio) -> bool:
    return (x / factor).den is None


def _ways(x: Ratio, may_vanish: MayVanish) -> Iterator[Case]:
    """The ways in which one coefficient can be zero."""
    _unit, factors = x.field.factor(x.num)
    for base, _exponent in factors:
        yield from factor_zero(base, may_vanish)


def factor_zero(base: Ratio, may_vanish: MayVanish) -> Iterator[Case]:
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
    yield _solved(base)


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


def _generator_zero(field: Field, index: int, may_vanish: MayVanish) -> Iterator[Case]:
    g = field.generators[index]
    x = field.variable(index)
    if is_given_function(field, index):
        yield Case((x,), dict(_function_and_rates(field, index)))
    elif g.kind in ("cos", "sin"):
        angle = field.angles[index if g.kind == "cos" else index - 1]
        inside = [k for k in angle.generators() if may_vanish(k)]
        if len(inside) == 1:
            target = field.zero if g.kind == "sin" else field.pi / 2
            slope = field.partial(angle, inside[0])
            rest = angle - slope * field.variable(inside[0])
            yield Case((x,), {inside[0]: (target - rest) / slope})
    elif g.kind == "parameter" and may_vanish(index):
        yield Case((x,), {index: field.zero})


def _function_and_rates(field: Field, index: int) -> Iterable[tuple[int, Ratio]]:
    """The function is zero at all times, and so are its rates."""
    while True:
        yield index, field.zero
        rate = field.rate(field.variable(index))
        if rate.is_zero():
            return
        index = field.index(rate)


def _sum_zero(base: Ratio, may_vanish: MayVanish) -> Iterator[Case]:
    """A sum of terms of one sign is zero if every term is."""
    field = base.field
    terms = field.terms(base.num)
    if len(terms) > 1:
        monomials = [field.polynomial({monomial: 1}) for monomial in terms]
        yield from _cases(monomials, ALWAYS, may_vanish)


def _solved(base: Ratio) -> Case:
    """An equality, solved for the parameter declared last in which it is linear."""
    field = base.field
    for index in sorted(base.generators(), reverse=True):
        g = field.generators[index]
        if g.kind != "parameter" or field.index(field.pi) == index:
            continue
        parts = base.numerator().coefficients(index)
        if len(parts) != 2 or any(index in field.ingredients(part) for part in parts):
            continue
        value = -parts[0] / parts[1]
        if g.positive and sign_of(value) in (Sign.NEGATIVE, Sign.NONPOSITIVE, Sign.ZERO):
            continue
        return Case((base,), {index: value})
    return Case((base,), {}, is_solved=False)


def texts_of(cases: Sequence[Case]) -> tuple[str, ...]:
    """One text for every case, its equalities joined."""
    return tuple(" and ".join(case.texts()) for case in cases)
