"""Signs under premises.

An element is taken apart into its factors. A factor has the sign that `signs` can tell, or that of a premise, if it is
no less than a multiple of it; what is then left open is looked at in one point of every open cell on which premises and
factors keep their signs (`cells.py`). That settles >= under premises that are open sets, since what is not negative in
all cells is not negative in their closure. A zero inside of the premises would be one that does not change the sign, so
a minimum; there is none where

    one cell is all there is, or
    a derivative along a positive or free variable has a strict sign, or
    the element stays >= 0 when a positive term of it is made smaller.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Protocol

import flint

from freebody.errors import CannotAnswer
from freebody.symbolic.decide.cells import TooLarge
from freebody.symbolic.decide.picture import BallFunctions, CellDecomposition, is_made, sign_at
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign, is_positive, sign_of, times

_flint: Any = flint
_MOST_FACTORS = 6
_MOST_TERMS = 200
_MOST_PARTS = 4  # of a premise, that are tried
_PART = 64  # of a positive term that is taken away to show that an element cannot vanish


class Premise(Protocol):
    """`element relation 0`, as a condition is."""

    @property
    def element(self) -> Ratio: ...
    @property
    def relation(self) -> str: ...


@dataclass(frozen=True)
class _Given:
    element: Ratio
    relation: str


def decide(x: Ratio, relation: str, premises: Sequence[Premise] = ()) -> bool | None:
    """Whether `x relation 0` (">", ">=", "!=") holds for all admissible values for which the premises do (True), for
    none of them (False), or for some, or that is not known (None). Where x is not real nothing is said of it."""
    found = _verdict(sign_given(x, premises), relation)
    if found is None and relation == "!=":
        nonzero = [p.element for p in premises if p.relation != ">="]
        parts = [base for base, _e in _factors(x.numerator())]
        if all(
            sign_given(b, premises).is_strict or any(_divides(b, k) for k in nonzero) or _excluded(b, premises)
            for b in parts
        ):
            return True
    return found


def _excluded(base: Ratio, premises: Sequence[Premise]) -> bool:
    """Whether a factor that is linear in a variable would break a premise where it vanishes."""
    f = base.field
    for g in base.generators():
        parts = base.coefficients(g) if _stands_alone(base, g) else []
        if len(parts) != 2 or not sign_of(parts[1]).is_strict:
            continue
        zero = -parts[0] / parts[1]
        for p in premises:
            if g in f.ingredients(p.element):
                with suppress(ZeroDivisionError, CannotAnswer):
                    if _verdict(sign_of(f.follow(p.element, {g: zero})), p.relation) is False:
                        return True
    return False


def implied(condition: Premise, premises: Sequence[Premise]) -> bool:
    """Whether a condition follows from others."""
    x = condition.element
    if condition.relation != "!=" and _is_refuted([x], 1, _used(x, premises)):
        return False
    return decide(x, condition.relation, premises) is True


def _is_refuted(factors: Sequence[Ratio], sign: int, premises: Sequence[Premise]) -> bool:
    """Whether a product has the opposite of a sign at a point at which the premises hold."""
    trials = factors[0].field.trials
    return trials is not None and trials.refute(factors, sign, premises)


def _verdict(sign: Sign, relation: str) -> bool | None:
    if relation == "!=":
        return True if sign.is_strict else (False if sign is Sign.ZERO else None)
    if sign is Sign.POSITIVE or (relation == ">=" and sign in (Sign.NONNEGATIVE, Sign.ZERO)):
        return True
    if sign is Sign.NEGATIVE or (relation == ">" and sign in (Sign.NONPOSITIVE, Sign.ZERO)):
        return False
    return None


def possible(conditions: Sequence[Premise]) -> bool | None:
    """Whether there is an open set of admissible values where all inequalities hold (None: not known). What holds on
    a border only (a - b >= 0 and b - a >= 0) counts as impossible; `!=` takes away nothing open."""
    wanted = [c for c in conditions if c.relation != "!="]
    for c in wanted:
        if sign_of(c.element) in (Sign.NEGATIVE, Sign.NONPOSITIVE, Sign.ZERO) and c.relation == ">":
            return False
    open_ = [c for c in wanted if sign_of(c.element) is not Sign.POSITIVE]
    if not open_:
        return True
    try:
        with _flint.ctx.workprec(192):
            picture = CellDecomposition(open_[0].element.field, [c.element for c in open_])
            return any(all(sign_at(c.element, v) == 1 for c in open_) for v in picture.values())
    except TooLarge:
        return None


def sign_given(x: Ratio, premises: Sequence[Premise] = ()) -> Sign:
    """The sign of an element wherever some conditions hold."""
    plain = sign_of(x)
    if plain is not Sign.UNKNOWN and (plain.is_strict or plain is Sign.ZERO):
        return plain
    key = (x.key(), tuple((p.element.key(), p.relation) for p in premises))
    known = x.field.decided
    if key not in known:
        known[key] = _sign(x, _used(x, premises))
    found = known[key]
    return plain if found is Sign.UNKNOWN else found


def _used(x: Ratio, premises: Sequence[Premise]) -> list[_Given]:
    """Inequalities among the premises that share a symbol with the element, directly or through others."""
    left = [_Given(p.element, p.relation) for p in premises if p.relation in (">", ">=", "!=")]
    reached, found, grown = set(x.field.ingredients(x)), list[_Given](), True
    while grown:
        near = [p for p in left if reached & x.field.ingredients(p.element)]
        left = [p for p in left if p not in near]
        found += near
        grown = bool(near)
        for p in near:
            reached |= x.field.ingredients(p.element)
    return found


def _sign(x: Ratio, premises: list[_Given]) -> Sign:
    number = _sign_of_number(x)
    if number is not None:
        return number
    if len(x.num) > _MOST_TERMS or (x.den is not None and len(x.den) > _MOST_TERMS):
        return Sign.UNKNOWN
    result, open_ = Sign.POSITIVE, list[tuple[Ratio, int]]()
    for base, exponent in _factors(x):
        sign = _of_factor(base, premises)
        if sign is Sign.UNKNOWN and exponent % 2:
            open_.append((base, exponent))
            continue
        if exponent % 2 == 0:
            sign = Sign.POSITIVE if sign.is_strict else Sign.NONNEGATIVE
        result = times(result, sign)
    if not open_:
        return result
    if 1 < len(open_) <= _MOST_FACTORS:
        return times(result, _in_cells([base for base, _e in open_], premises)[0])
    return Sign.UNKNOWN


def _factors(x: Ratio) -> list[tuple[Ratio, int]]:
    """Irreducible factors above and below the bar, a sign as one of them."""
    field, found, sign = x.field, list[tuple[Ratio, int]](), 1
    for poly in (x.num, x.den):
        if poly is not None:
            unit, factors = field.factor_by_degree(poly) or field.factor(poly)
            sign = -sign if unit < 0 else sign
            found += factors
    return [*found, (-field.one, 1)] if sign < 0 else found


def _of_factor(base: Ratio, premises: list[_Given]) -> Sign:
    known = sign_of(base)
    if known.is_strict or known is Sign.ZERO:
        return known
    number = _sign_of_number(base)
    if number is not None:
        return number
    if _is_refuted([base], 1, premises) and _is_refuted([base], -1, premises):
        return Sign.UNKNOWN
    for p in premises:
        for sign in (1, -1) if p.relation != "!=" else ():
            if _is_refuted([base], sign, [p]):
                continue
            found = _beside(sign * base, p)
            if found is not Sign.UNKNOWN:
                return found if sign > 0 else -found
    nonzero = any(p.relation != ">=" and _divides(base, p.element) for p in premises)
    found, used = known, list[_Given]()
    if found is Sign.UNKNOWN:
        found, used = _in_cells([base], premises)
    if found in (Sign.NONNEGATIVE, Sign.NONPOSITIVE):
        upward = base if found is Sign.NONNEGATIVE else -base
        is_open = all(p.relation == ">" for p in used)
        strict = [p for p in premises if p.relation == ">"] if is_open else used
        if nonzero or _cannot_vanish(upward, strict):
            return Sign.POSITIVE if found is Sign.NONNEGATIVE else Sign.NEGATIVE
    return found


def _beside(x: Ratio, p: _Given) -> Sign:
    """Of what is a positive number times the element of a premise and something that is not negative: c p + rest, with
    the c that takes away one of the terms of x."""
    own, given = x.terms()[0], p.element.terms()[0]
    parts = {Fraction(n, given[monomial]) for monomial, n in own.items() if monomial in given}
    for c in sorted(c for c in parts if c > 0)[:_MOST_PARTS]:
        rest = sign_of(x - x.field.element(c) * p.element) if x.den == p.element.den else Sign.UNKNOWN
        if rest in (Sign.POSITIVE, Sign.NONNEGATIVE, Sign.ZERO):
            return Sign.POSITIVE if p.relation == ">" or rest is Sign.POSITIVE else Sign.NONNEGATIVE
    return Sign.UNKNOWN


def _divides(base: Ratio, x: Ratio) -> bool:
    return bool(base.generators() <= x.generators()) and any(base in (b, -b) for b, _e in _factors(x.numerator()))


def _cannot_vanish(x: Ratio, premises: list[_Given]) -> bool:
    """Of an element that is not negative where the premises hold."""
    f = x.field
    if x.den is not None or len(x.num) > _MOST_TERMS // 4:
        return False
    closed = [g for g in x.generators() if g in f.nonnegative]
    if closed:
        at_zero = f.follow(x, {closed[0]: f.zero})
        if premises or sign_given(at_zero) is not Sign.POSITIVE:
            return False
    return _has_slope(x, premises) or _has_room(x, premises)


def _has_slope(x: Ratio, premises: list[_Given]) -> bool:
    """Where it vanished it would be least, so that every derivative vanished, too."""
    f = x.field
    if any(p.relation != ">" for p in premises):
        return False
    return any(_sign(f.partial(x, g), premises).is_strict for g in x.generators() if _stands_alone(x, g))


def _stands_alone(x: Ratio, g: int) -> bool:
    """A variable that nothing else in the element is made of."""
    f = x.field
    if is_made(f, g):
        return False
    return all(g not in f.generators[k].made_of for k in x.generators() - {g})


def _has_room(x: Ratio, premises: list[_Given]) -> bool:
    """Still not negative without a part of one of its positive terms."""
    f = x.field
    for monomial, coefficient in f.terms(x.num).items():
        if coefficient > 0 and all(is_positive(f, g) for g, _e in monomial):
            less = _PART * x - f.polynomial({monomial: coefficient})
            if sign_of(less) in (Sign.POSITIVE, Sign.NONNEGATIVE):
                return True
            if _in_cells([less], premises)[0] is Sign.NONNEGATIVE:
                return True
    return False


def _sign_of_number(x: Ratio) -> Sign | None:
    """Of what has no variables, by balls; None where it has some, or is too near to zero to tell."""
    f = x.field
    if x.is_zero():
        return Sign.ZERO
    if not all(is_made(f, g) for g in f.ingredients(x)):
        return None
    for precision in (64, 256, 1024):
        with _flint.ctx.workprec(precision):
            values = f.complete({}, BallFunctions())
            try:
                value = _flint.arb(f.evaluate(x, values))
            except (KeyError, ZeroDivisionError):
                return None
        if value > 0:
            return Sign.POSITIVE
        if value < 0:
            return Sign.NEGATIVE
    return None


def _in_cells(factors: list[Ratio], premises: list[_Given]) -> tuple[Sign, list[_Given]]:
    """The sign of a product in all cells in which premises hold, as far as it is the same, and the premises that were
    needed. It is strict where one cell is all there is, since then nothing vanishes anywhere."""
    for chosen in _choices(factors, premises):
        if _is_refuted(factors, 1, chosen) and _is_refuted(factors, -1, chosen):
            continue
        try:
            signs, is_whole = _signs(factors, chosen)
        except TooLarge:
            continue
        if signs == {1}:
            return Sign.POSITIVE if is_whole else Sign.NONNEGATIVE, chosen
        if signs == {-1}:
            return Sign.NEGATIVE if is_whole else Sign.NONPOSITIVE, chosen
    return Sign.UNKNOWN, []


def _choices(factors: list[Ratio], premises: list[_Given]) -> Iterator[list[_Given]]:
    """Fewer premises make fewer variables: none first, then those in the symbols of the factors, then all. One that is
    not strict is the closure of a strict one where its slope cannot vanish; two such need not be."""
    field = factors[0].field
    inside = frozenset[int]().union(*(field.ingredients(x) for x in factors))
    strict = [p for p in premises if p.relation == ">"]
    near = [p for p in strict if field.ingredients(p.element) <= inside]
    closed = [p for p in premises if p.relation == ">=" and _is_regular(p.element)]
    tried: list[list[_Given]] = []
    for chosen in ([], near, *([*near, p] for p in closed), strict, *([*strict, p] for p in closed)):
        if chosen not in tried:
            tried.append(chosen)
            yield chosen


def _is_regular(x: Ratio) -> bool:
    f = x.field
    if x.den is not None:
        return False
    return any(sign_of(f.partial(x, g)).is_strict for g in x.generators() if _stands_alone(x, g))


def _signs(factors: list[Ratio], premises: list[_Given]) -> tuple[set[int], bool]:
    """Of a product, in the cells where the premises hold strictly; and whether there is but one cell."""
    found, n_cells = set[int](), 0
    with _flint.ctx.workprec(192):
        picture = CellDecomposition(factors[0].field, [*factors, *(p.element for p in premises)])
        for values in picture.values():
            n_cells += 1
            if any(sign_at(p.element, values) != 1 for p in premises):
                continue
            signs = [sign_at(x, values) for x in factors]
            if None in signs:
                continue
            found.add(math.prod(s or 0 for s in signs))
            if len(found) > 1:
                break
    return found, n_cells == 1 and picture.is_without_gaps
