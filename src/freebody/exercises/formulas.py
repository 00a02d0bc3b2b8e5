"""An item as it is asked for a formula: what a platform takes for right and wrong, where it compares."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from freebody.errors import CannotAnswer, ExpressionError
from freebody.exercises.bank import Item, SymbolUsed
from freebody.exercises.selftests import SelfTest
from freebody.exercises.typed import Language, Typing, named, parts_of
from freebody.language.expression import FLOAT_FUNCTIONS, Expr, evaluate
from freebody.language.sentences import Message
from freebody.present.report.blocks import Text

SAME = 1e-6  # relative: formulas are equal that agree so far at all points
_SAME_ZERO = 1e-9
_FEWEST_POINTS = 3

Values = tuple[tuple[float, ...], ...]  # of each part, at each point


@dataclass(frozen=True)
class WrongFormula:
    """parts: as they are typed; values: of its parts at the points; feedback: what is said about it."""

    parts: tuple[str, ...]
    values: Values
    feedback: Text


@dataclass(frozen=True)
class FormulaAsked:
    """A formula is to be given, or one for each part of a vector.

    points: values by the names that are typed; later: of the same motions, where only differences count; right: as it
    is typed, with its values; equivalent: other ways to write it."""

    typing: Typing
    points: tuple[Mapping[str, float], ...]
    later: tuple[Mapping[str, float], ...]
    right: tuple[str, ...]
    values: Values
    equivalent: tuple[tuple[str, ...], ...]
    wrong: tuple[WrongFormula, ...]


def formula_of(item: Item, language: Language) -> FormulaAsked:
    """Raises CannotAnswer where the platform cannot take it, with the reason."""
    if item.answer not in ("formula", "vector") or item.expression is None:
        raise CannotAnswer(Message("it is no formula"))
    right = item.expression if isinstance(item.expression, tuple) else (item.expression,)
    states = _States(item)
    values = states.values(right)
    if len(states.points) < _FEWEST_POINTS or values is None:
        raise CannotAnswer(Message("there are too few points at which it could be compared"))
    offered = [key for symbol in item.symbols for key in _keys(symbol) if key in states.names]
    typing = Typing.of(language, dict.fromkeys([*offered, *named(right)]))
    try:
        typed = _typed(typing, right)
    except ExpressionError as error:
        raise CannotAnswer(error.message) from error
    found = _readable(item.equivalent, typing, states)
    equal = tuple(_typed(typing, parts) for parts, own in found if are_same(own, values))
    wrong = tuple(_wrong(item, typing, states, values))
    points, later = (tuple(map(typing.values, some)) for some in (states.points, states.later))
    return FormulaAsked(typing, points, later, typed, values, equal, wrong)


def _keys(symbol: SymbolUsed) -> tuple[str, ...]:
    return (symbol.name, f"rate({symbol.name})") if symbol.is_moving else (symbol.name,)


def _typed(typing: Typing, parts: Sequence[Expr]) -> tuple[str, ...]:
    return tuple(map(typing.written, parts))


class _States:
    """Where the formulas of an item are compared. names: that have values in all states."""

    def __init__(self, item: Item) -> None:
        sampling = item.sampling
        self.points = () if sampling is None else sampling.states
        self.later = () if sampling is None else sampling.later
        self.names = frozenset(() if sampling is None else sampling.units)

    def values(self, parts: Sequence[Expr]) -> Values | None:
        """None where something has no value. Raises ExpressionError for a name without one."""
        found = tuple(values_at(part, self.points, self.later) for part in parts)
        return found if all(math.isfinite(x) for part in found for x in part) else None


def _wrong(item: Item, typing: Typing, states: _States, right: Values) -> Iterator[WrongFormula]:
    """Wrong answers in the names of the problem that have a value, and are not equal to the right one there."""
    seen: list[Values] = []
    for wrong in item.wrong:
        for parts, values in _readable((wrong.text,), typing, states):
            if len(parts) == len(right) and not any(are_same(values, x) for x in (right, *seen)):
                seen.append(values)
                yield WrongFormula(_typed(typing, parts), values, wrong.feedback)


def _readable(texts: Sequence[str], typing: Typing, states: _States) -> Iterator[tuple[tuple[Expr, ...], Values]]:
    for text in texts:
        try:
            parts = parts_of(text)
            _typed(typing, parts)
            values = states.values(parts)
        except ExpressionError:
            continue
        if values is not None:
            yield parts, values


def values_at(
    expr: Expr, points: Sequence[Mapping[str, float]], later: Sequence[Mapping[str, float]] = ()
) -> tuple[float, ...]:
    """What it is at each point, and less what it is later there, where only differences count."""
    found = tuple(value_at(expr, point) for point in points)
    return tuple(x - value_at(expr, p) for x, p in zip(found, later, strict=True)) if later else found


def value_at(expr: Expr, point: Mapping[str, float]) -> float:
    """nan where it has none. Raises ExpressionError for a name without a value."""
    try:
        return float(evaluate(expr, point, FLOAT_FUNCTIONS))
    except (ValueError, ArithmeticError, TypeError):
        return math.nan


def are_same(given: Sequence[Sequence[float]], wanted: Sequence[Sequence[float]]) -> bool:
    """Whether all parts agree at all points."""
    return len(given) == len(wanted) and all(
        is_same(a, b) for own, its in zip(given, wanted, strict=True) for a, b in zip(own, its, strict=True)
    )


def is_same(given: float, wanted: float) -> bool:
    return abs(given - wanted) <= SAME * abs(wanted) + _SAME_ZERO


# -- self-tests -------------------------------------------------------------------------------
def response(parts: Sequence[str]) -> str:
    """As it stands in a self-test: a formula, or a list of them in JSON."""
    return parts[0] if len(parts) == 1 else json.dumps(list(parts))


def parts_given(text: str) -> tuple[str, ...]:
    """The formulas of a response."""
    return tuple(json.loads(text)) if text.startswith("[") else (text,)


def formula_tests(name: str, form: FormulaAsked, feedback: Sequence[str]) -> Iterator[SelfTest]:
    """The answer, other ways to write it, the wrong answers with what is said about them, and the answer made wrong."""
    yield SelfTest(name, "key", response(form.right), "correct")
    for parts in (*form.equivalent, tuple(f"2*({part})/2" for part in form.right)):
        yield SelfTest(name, "equivalent", response(parts), "correct")
    for wrong, said in zip(form.wrong, feedback, strict=True):
        yield SelfTest(name, "distractor", response(wrong.parts), "incorrect", said)
    known = [wrong.values for wrong in form.wrong]
    for change, factor, more in (("{} + 1", 1.0, 0.0 if form.later else 1.0), ("7*({})", 7.0, 0.0)):
        made = tuple(tuple(factor * x + more for x in part) for part in form.values)
        if not any(are_same(made, values) for values in (form.values, *known)):
            yield SelfTest(name, "distractor", response([change.format(part) for part in form.right]), "incorrect")
