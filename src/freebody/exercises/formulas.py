"""An item as it is asked for a formula: right and wrong ones in the language of a platform, and where they are compared."""

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

    points: values by the names that are typed; right: as it is typed, with its values; equivalent: other ways to write
    it; strict: right options that differ from it by a constant, and are not taken."""

    typing: Typing
    points: tuple[Mapping[str, float], ...]
    right: tuple[str, ...]
    values: Values
    equivalent: tuple[tuple[str, ...], ...]
    wrong: tuple[WrongFormula, ...]
    is_strict: bool


def formula_of(item: Item, language: Language) -> FormulaAsked:
    """Raises CannotAnswer where the platform cannot take it, with the reason."""
    if item.answer not in ("formula", "vector") or item.expression is None:
        raise CannotAnswer(Message("it is no formula"))
    right = item.expression if isinstance(item.expression, tuple) else (item.expression,)
    keys = named(right)
    points = tuple(p for p in item.samples if all(key in p for key in keys) and _values(right, (p,)) is not None)
    values = _values(right, points)
    if len(points) < _FEWEST_POINTS or values is None:
        raise CannotAnswer(Message("there are too few points at which it could be compared"))
    offered = [key for symbol in item.symbols for key in _keys(symbol) if all(key in p for p in points)]
    typing = Typing.of(language, dict.fromkeys([*keys, *offered]))
    try:
        typed = _typed(typing, right)
    except ExpressionError as error:
        raise CannotAnswer(error.args[0]) from error
    equal, others = _equivalent(item, typing, points, values)
    wrong = tuple(_wrong(item, typing, points, values))
    return FormulaAsked(typing, tuple(map(typing.values, points)), typed, values, equal, wrong, others)


def _keys(symbol: SymbolUsed) -> tuple[str, ...]:
    return (symbol.name, f"rate({symbol.name})") if symbol.is_moving else (symbol.name,)


def _typed(typing: Typing, parts: Sequence[Expr]) -> tuple[str, ...]:
    return tuple(map(typing.written, parts))


def _equivalent(
    item: Item, typing: Typing, points: Sequence[Mapping[str, float]], right: Values
) -> tuple[tuple[tuple[str, ...], ...], bool]:
    """Those that are equal at all points, and whether some are not."""
    found: list[tuple[str, ...]] = []
    differs = False
    for parts, values in _readable(item.equivalent, typing, points):
        if are_same(values, right):
            found.append(_typed(typing, parts))
        else:
            differs = True
    return tuple(found), differs


def _wrong(item: Item, typing: Typing, points: Sequence[Mapping[str, float]], right: Values) -> Iterator[WrongFormula]:
    """Wrong answers in the names of the problem that have a value, and are not equal to the right one there."""
    seen: list[Values] = []
    for wrong in item.wrong:
        for parts, values in _readable((wrong.text,), typing, points):
            if len(parts) == len(right) and not any(are_same(values, x) for x in (right, *seen)):
                seen.append(values)
                yield WrongFormula(_typed(typing, parts), values, wrong.feedback)


def _readable(
    texts: Sequence[str], typing: Typing, points: Sequence[Mapping[str, float]]
) -> Iterator[tuple[tuple[Expr, ...], Values]]:
    for text in texts:
        try:
            parts = parts_of(text)
            _typed(typing, parts)
        except ExpressionError:
            continue
        if (values := _values(parts, points)) is not None:
            yield parts, values


def _values(parts: Sequence[Expr], points: Sequence[Mapping[str, float]]) -> Values | None:
    """None where something has no value."""
    found = tuple(tuple(value_at(part, p) for p in points) for part in parts)
    return found if all(math.isfinite(x) for part in found for x in part) else None


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
    for change, make in (("{} + 1", lambda x: x + 1), ("7*({})", lambda x: 7 * x)):
        made = tuple(tuple(map(make, part)) for part in form.values)
        if not any(are_same(made, values) for values in (form.values, *known)):
            yield SelfTest(name, "distractor", response([change.format(part) for part in form.right]), "incorrect")
