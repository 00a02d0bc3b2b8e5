"""Questions about the n-th impact of what bounces, with a symbol for n.

    speed of ball after n impacts        time of the n-th impact        greatest y after the n-th impact

Between impacts on one contact every flight is a copy of the one before, with speeds and times e times as large (see
`study/phases/bouncing.py`). So what is asked is after k impacts a + b e^k + c e^(2k), or the root of that: three
impacts give a, b and c, and two further ones must agree. Source: Meriam & Kraige, Dynamics, sec. 3/12.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from freebody.errors import CannotAnswer
from freebody.language.expression import (
    FLOAT_FUNCTIONS,
    Call,
    Expr,
    Number,
    PowerOf,
    ProductOf,
    Sum,
    Symbol,
    add,
    evaluate,
    free_symbols,
    multiply,
    number,
    power,
)
from freebody.language.notation import to_text
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, Dimension
from freebody.model.friction import read_restitution
from freebody.questions.arithmetic import Functions, Joined, OfParameters, refuse_vectors
from freebody.questions.at_events import AtEvent
from freebody.questions.base import Quantity
from freebody.questions.forms import NAME
from freebody.questions.reading_when import Meant
from freebody.questions.sudden import IMPACT, ORDINALS

if TYPE_CHECKING:
    from freebody.model.names import Names

N_GIVEN, N_LOOKED_AT = 3, 5
_SAME = 1e-9  # relative: two numbers that are one
_NO_SERIES = CannotAnswer(Message("from impact to impact it follows no geometric series, so there is no formula in n"))
_NTH = re.compile(
    rf"\b(?:the )?(?P<n>{NAME}|\d+)-?(?:th|(?<=\d)(?:st|nd|rd)) (?P<what>{IMPACT})\b"
    rf"|\bafter (?P<k>{NAME}|\d+) (?:impacts|bounces|collisions|hits)\b"
)
_WORDS = ("two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve")
_NUMBERS = {word: n for n, word in enumerate(_WORDS, 2)} | {"eigh": 8, "nin": 9, "twelf": 12, "one": 1}
_MOST = 1000  # impacts


@dataclass(frozen=True)
class AtNthImpact(Joined, kind="at the n-th impact"):
    """A quantity at the n-th impact, by what it is at the first five."""

    continues_impacts = True

    seen: tuple[Quantity, ...]
    restitution: OfParameters
    count: OfParameters

    scope = "whole motion"
    example = """
parameters: {h: 2 m, e: 0.8, n: 4, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {ball: {particle: {mass: 1 kg}, at: [0, h]}}
connections: {hit: {contact: {between: [ball, floor], restitution: e}}}
loads: {weight: {gravity: g}}
measures: {y: y of ball}
questions: {it: speed of ball after n impacts}
"""

    @property
    def inner(self) -> tuple[Quantity, ...]:
        return (*self.seen, self.restitution, self.count)

    @property
    def dimension(self) -> Dimension:
        return self.seen[0].dimension

    @property
    def unit(self) -> str:
        return self.seen[0].unit

    @property
    def is_of_answers(self) -> bool:
        return True

    @property
    def remarks(self) -> tuple[Message, ...]:
        if isinstance(self.count.expr, Number):
            return ()
        return (Message("{n} counts the impacts: 1, 2, 3 and so on", n=to_text(self.count.expr)),)

    def made_of(self, values: tuple[Any, ...], of: Functions) -> Any:
        refuse_vectors(values)
        *seen, e, n = values
        times = self.count.expr
        grown = e ** int(times.value) if isinstance(times, Number) else of.function("exp", n * of.function("log", e))
        if _is_series(seen, e):
            return _at(seen, e, grown)
        squares = [x * x for x in seen]
        if not _is_series(squares, e):
            raise _NO_SERIES
        return of.sqrt(_at(squares, e, grown))

    def written(self, found: Expr) -> Expr:
        """exp(n log e) as e^n."""
        return _in_powers(found)


def _at(seen: Sequence[Any], e: Any, x: Any) -> Any:
    """The polynomial of degree two in e^k through the first three values, at x."""
    places = [e ** (k + 1) for k in range(N_GIVEN)]
    total: Any = 0
    for k, value in enumerate(seen[:N_GIVEN]):
        factor: Any = value
        for j, place in enumerate(places):
            if j != k:
                factor = factor * (x - place) / (places[k] - place)
        total = factor + total if k else factor
    return total


def _is_series(seen: Sequence[Any], e: Any) -> bool:
    """Whether the further values are those of the polynomial."""
    return all(_is_same(seen[k], _at(seen, e, e ** (k + 1))) for k in range(N_GIVEN, N_LOOKED_AT))


def _is_same(a: Any, b: Any) -> bool:
    if isinstance(a, Expr):  # at numbers of the parameters; what is told in the field has been compared there
        names = sorted(free_symbols(a) | free_symbols(b))
        numbers = {name: 0.37 + 0.11 * k for k, name in enumerate(names)}
        a, b = (float(evaluate(x, numbers, FLOAT_FUNCTIONS)) for x in (a, b))
    if isinstance(a, (int, float, Fraction)):
        return abs(a - b) <= _SAME * max(abs(a), abs(b))
    return bool(a.field.lowest_terms(a - b).is_zero())


def _in_powers(e: Expr) -> Expr:
    if isinstance(e, Call) and e.function == "exp":
        factors = e.argument.factors if isinstance(e.argument, ProductOf) else (e.argument,)
        logs = [x for x in factors if isinstance(x, Call) and x.function == "log"]
        if len(logs) == 1:
            return power(logs[0].argument, multiply(*(x for x in factors if x is not logs[0])))
    match e:
        case Sum(terms):
            return add(*map(_in_powers, terms))
        case ProductOf(factors):
            return multiply(*map(_in_powers, factors))
        case PowerOf(base, exponent):
            inner = _in_powers(base)
            if isinstance(inner, PowerOf):
                return power(inner.base, multiply(inner.exponent, exponent))
            return power(inner, exponent)
        case Call():
            return e.of(_in_powers)
        case _:
            return e


# -- words ------------------------------------------------------------------------------------
def read_nth(names: Names, phrase: str, read: Callable[[str], Meant | None]) -> Meant | None:
    """What a phrase asks at the n-th impact. read: what is asked at one of the first impacts, in words."""
    found = _NTH.search(phrase)
    if found is None or (found["n"] and f"{found['n']}th" in ORDINALS):
        return None
    name = str(found["n"] or found["k"])
    words = f"the {{nth}} {found['what']}" if found["n"] else "after the {nth} impact"
    template = f"{phrase[: found.start()]}{words}{phrase[found.end() :]}"
    count = _count(names, name, is_counted=found["k"] is not None)
    if count is None:
        return None
    if isinstance(count.expr, Number) and count.expr.value <= N_LOOKED_AT:
        return read(template.format(nth=_ordinal(int(count.expr.value))))
    bouncing = [c for c in names.connections.values() if getattr(c, "restitution", 0) not in (0, "0")]
    if count.dimension != DIMENSIONLESS or len(bouncing) != 1:
        told = Message("the n-th impact is told of what bounces on one contact, with a plain number for {n}", n=name)
        names.problem(told, "find")
        return None
    restitution = OfParameters(read_restitution(names, vars(bouncing[0])["restitution"]), DIMENSIONLESS)
    template = template.replace("time of the {nth}", "time when the {nth}")
    seen: list[Quantity] = []
    for k in range(N_LOOKED_AT):
        meant = read(template.format(nth=_ordinal(k + 1)))
        if meant is None:
            return None
        seen.append(AtEvent(meant.quantity, meant.event, meant.at_start, meant.transition))
    return Meant(AtNthImpact(tuple(seen), restitution, count))


def _ordinal(n: int) -> str:
    return next(word for word, k in ORDINALS.items() if k == n)


def _count(names: Names, said: str, *, is_counted: bool) -> OfParameters | None:
    """How many impacts are meant: a parameter or a number. None, with a problem noted, where something else is said
    that counts, as an n that is no parameter. is_counted: whether it can be nothing else (the smooth impact)."""
    if said in names.parameters:
        return OfParameters(Symbol(said), names.parameters[said].dimension)
    n = int(said) if said.isdigit() else _NUMBERS.get(said, 0)
    if 1 <= n <= _MOST:
        return OfParameters(number(n), DIMENSIONLESS)
    if is_counted or len(said) == 1 or said.isdigit():
        names.problem(Message("{n} is no number of impacts; write one, or a parameter without a unit", n=said), "find")
    return None
