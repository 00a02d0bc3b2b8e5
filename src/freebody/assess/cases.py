"""Special and limiting cases in which an option and the answer differ, as a teacher would try them.

Two equal parameters, one of them zero, one growing without bound, an angle of 90 degrees: a case is worth
telling if one of the two is zero or infinite there and the other is not, else if the answer becomes simpler.
Roots may have changed sign on the way to a limit, so numbers close to the case must show it too.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations
from typing import Any, Literal

from freebody.assess.comparing import ComponentPair
from freebody.assess.points import EvaluationPoint, is_free, real
from freebody.assess.words import is_readable
from freebody.errors import CannotAnswer
from freebody.language.expression import Symbol
from freebody.language.notation import to_text
from freebody.language.sentences import Message
from freebody.language.units import ANGULAR_VELOCITY, DIMENSIONLESS, INERTIA, MASS, VELOCITY, Dimension
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy

Limit = Ratio | Literal["infinite"] | None

_N_SHOWN = 2  # of the special cases that are tried for a reason
_NEARBY = Fraction(1, 10**20)
_RANKS = {unit: rank for rank, unit in enumerate((MASS, INERTIA, DIMENSIONLESS, VELOCITY, ANGULAR_VELOCITY))}


@dataclass(frozen=True)
class LimitingCase:
    """A parameter at, or going to, a special value; None is beyond all bounds."""

    words: str
    index: int
    value: Ratio | None
    shift: Fraction = Fraction(0)  # where to look in numbers, beside the value

    def put(self, point: EvaluationPoint) -> None:
        """Sets the parameter close to the value."""
        at = real(10**20) if self.value is None else point.number(self.value) + real(self.shift)
        point.values[self.index] = at

    def limit(self, x: Ratio) -> Limit:
        """What x is or tends to; None where substitution does not tell."""
        try:
            return self._at_value(x, self.value) if self.value is not None else self._far_out(x)
        except (CannotAnswer, ZeroDivisionError):
            return None

    def _at_value(self, x: Ratio, value: Ratio) -> Limit:
        top, bottom = (x.field.follow(part, {self.index: value}) for part in (x.numerator(), x.denominator()))
        if not bottom.is_zero():
            return top / bottom
        return None if top.is_zero() else "infinite"

    def _far_out(self, x: Ratio) -> Limit:
        """The leading power decides, unless the parameter stands in a root or another function."""
        field = x.field
        if any(self.index in field.generators[g].made_of for g in x.generators()):
            return None
        top, bottom = x.numerator().coefficients(self.index), x.denominator().coefficients(self.index)
        if len(top) == len(bottom):
            return top[-1] / bottom[-1]
        return "infinite" if len(top) > len(bottom) else field.zero


def special_case(pair: ComponentPair, option: Ratio) -> str | None:
    """The first case in which one of the two is zero or infinite and the other is not; else the limit
    that makes the answer simplest, if the two differ there."""
    plain = _size(pair.answer)
    simpler: list[tuple[int, LimitingCase, Ratio, Ratio]] = []
    for case in _cases(pair):
        mine, its = case.limit(option), case.limit(pair.answer)
        if mine is None or its is None:
            continue
        if _kind(mine) != _kind(its):
            if _is_seen(pair, case, mine, its):
                return _told(pair, case, mine, its)
            continue
        if not isinstance(mine, Ratio) or not isinstance(its, Ratio) or mine == its:
            continue
        if case.shift and _size(its) < plain:
            simpler.append((_size(its) + _size(mine), case, mine, its))
    for _sum, case, mine, its in sorted(simpler, key=lambda s: s[0])[:_N_SHOWN]:
        if is_readable(tidy(mine), tidy(its)) and _is_seen(pair, case, mine, its):
            return _told(pair, case, mine, its)
    return None


def _cases(pair: ComponentPair) -> Iterable[LimitingCase]:
    field, angles = pair.field, pair.setting.angles
    known = pair.setting.names.dimensions

    def name(index: int) -> str:
        return to_text(field.generators[index].display)

    parameters: list[tuple[int, str, Dimension]] = []
    for g in pair.generators:
        shown = field.generators[g].display
        if field.generators[g].kind == "parameter" and is_free(field, g) and isinstance(shown, Symbol):
            parameters.append((g, shown.name, known.get(shown.name, DIMENSIONLESS)))
    for (p, _n, unit), (q, _m, its) in combinations(parameters, 2):
        if unit == its and (p in angles) == (q in angles):
            yield LimitingCase(Message("for {p} = {q}", p=name(p), q=name(q)), q, field.variable(p))
    ordered = sorted(parameters, key=lambda p: _RANKS.get(p[2], len(_RANKS)))
    for p, _name, _unit in ordered:
        yield LimitingCase(Message("for {p} = {q}", p=name(p), q=0), p, field.zero, _NEARBY)
    for p, _name, _unit in ordered:
        if p not in angles:
            yield LimitingCase(Message("as {p} grows", p=name(p)), p, None)
    for p, _name, _unit in ordered:
        if p in angles:
            yield LimitingCase(Message("for {p} = {q}", p=name(p), q="90°"), p, field.pi / 2, -_NEARBY)


def _is_seen(pair: ComponentPair, case: LimitingCase, mine: Limit, its: Limit) -> bool:
    """True if numbers close to the case show the limits too."""
    for point in pair.setting.points(pair.option.conditions, case.put):
        numbers = pair.numbers(point)
        if all(number.is_finite() for number in numbers):
            return all(_is_near(n, x, point) for n, x in zip(numbers, (mine, its), strict=True))
    return False


def _is_near(number: Any, limit: Limit, point: EvaluationPoint) -> bool:
    """True if a number close to the special value is like the limit."""
    if not isinstance(limit, Ratio):
        return bool(abs(number) > 10**6)
    expected = point.number(limit)
    slack = real(Fraction(1, 10**6))
    return bool(abs(number - expected) < slack * (abs(expected) if not limit.is_zero() else 1))


def _kind(limit: Limit) -> str:
    if isinstance(limit, Ratio):
        return "zero" if limit.is_zero() else "finite"
    return str(limit)


def _size(x: Ratio) -> int:
    """How long it is when it is written out."""
    parts = (x.numerator().num, x.denominator().num)
    return sum(1 + len(monomial) for part in parts for monomial in x.field.terms(part))


def _told(pair: ComponentPair, case: LimitingCase, mine: Limit, its: Limit) -> str:
    tends = case.value is None

    def is_(limit: Limit) -> str:
        if not isinstance(limit, Ratio):
            return Message("grows without bound") if tends else Message("is infinite")
        shown = tidy(limit)
        if not is_readable(shown):
            return Message("stays finite") if tends else Message("is finite and not 0")
        return Message("tends to {x}", x=to_text(shown)) if tends else to_text(shown)

    def told(limit: Limit, *, is_mine: bool) -> str:
        words = is_(limit)
        if isinstance(words, Message):
            return words
        return Message("gives {x}", x=words) if is_mine else Message("is {x}", x=words)

    its_words, my_words = told(its, is_mine=False), told(mine, is_mine=True)
    if pair.setting.is_typed:
        return Message("{case} the right answer {its}, this one {mine}", case=case.words, its=its_words, mine=my_words)
    return Message("{case} the answer {its}, this option {mine}", case=case.words, its=its_words, mine=my_words)
