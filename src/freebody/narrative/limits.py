"""What an answer becomes in special cases: equal parameters, one zero or without bound, an angle of 90 degrees."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from contextlib import suppress

from freebody.assess.cases import LimitingCase
from freebody.errors import CannotAnswer, ExpressionError
from freebody.language.expression import Call, Expr, Symbol, free_symbols, n_operations, rate_key
from freebody.language.notation import Stated
from freebody.language.sentences import Sentence
from freebody.language.truth import is_true
from freebody.language.units import DIMENSIONLESS, INERTIA, MASS
from freebody.measures.geometry import ZERO
from freebody.narrative.context import Context
from freebody.narrative.lines.script import Item, Listing
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer
from freebody.study.answering.draws import Draw
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy
from freebody.tolerances import ROUND_OFF

MOST = 4  # cases that are told
SHORT = 9  # operations of a value that stands within a line
SMALL = 1e-6  # of its own value: a parameter in place of zero, and one over it in place of infinity
_WORD = re.compile(r"[A-Za-z_]\w*")


def limiting_cases(context: Context, question: Question, answer: Answer) -> list[Item]:
    """The most telling cases of a scalar answer: where it vanishes or grows without bound first, then where it becomes
    simplest."""
    if answer.expression is None or isinstance(answer.expression, tuple) or answer.cases:
        return []
    if question.quantity.is_verdict:
        return []
    try:
        element = context.setup.model.geometry.apply(answer.expression, _coordinates(context))
    except (CannotAnswer, ExpressionError, ZeroDivisionError, KeyError):
        return []
    if element.is_zero():
        return []
    element = element.field.lowest_terms(element)
    told: list[tuple[int, int, Sentence]] = []
    for case, names in _cases(context, element):
        limit = case.limit(element) if _is_admissible(context, answer, names) else None
        if limit is not None and not (isinstance(limit, Ratio) and limit == element):
            told += _told(context, names, limit, n_operations(answer.expression))
    chosen = sorted(told, key=lambda entry: entry[0])[:MOST]
    if not chosen:
        return []
    ordered = tuple(sentence for _rank, _size, sentence in chosen)
    is_short = all(size <= SHORT for _rank, size, _sentence in chosen)
    return [Sentence("limit.cases", {"cases": ordered})] if is_short else [Listing(ordered)]


def _told(
    context: Context, names: tuple[str, Expr, Expr], limit: object, size: int
) -> Iterator[tuple[int, int, Sentence]]:
    """A case worth telling: its rank, the operations of its formula, its words. size: operations of the answer."""
    kind, p, q = names
    if not isinstance(limit, Ratio):
        if kind != "grows":  # more mass, more energy and larger forces: that tells nothing
            yield 1, 0, Sentence(f"limit.{kind}_infinite", {"p": p, "q": q})
        return
    shown = tidy(limit.field.lowest_terms(limit))
    n, said = n_operations(shown), Sentence(f"limit.{kind}", {"p": p, "q": q, "value": shown})
    if limit.is_zero():
        yield (0 if kind == "equal" else 1), 0, said
    elif n < size and (n < size / 2 or (n <= SHORT and kind != "right_angle")) and _is_like(context, names):
        yield 2 + n, n, said


def _is_like(context: Context, names: tuple[str, Expr, Expr]) -> bool:
    """Whether equal values mean something by themselves: those of masses and angles do, those of lengths seldom."""
    p = context.system.parameters[rate_key(names[1])]
    return names[0] != "equal" or p.is_angle or p.dimension in (MASS, INERTIA, DIMENSIONLESS)


def _is_possible(context: Context, kind: str, p: Expr) -> bool:
    """No body is without mass that has a moment of inertia."""
    bodies = context.system.moving
    own = [b for b in bodies if b.turns and b.mass == p and b.inertia != ZERO]
    return kind != "zero" or all(rate_key(p) in free_symbols(b.inertia) for b in own)


def _is_admissible(context: Context, answer: Answer, names: tuple[str, Expr, Expr]) -> bool:
    """Whether the conditions of an answer hold near a special case, wherever they hold at the draws."""
    kind, p, q = names
    if not _is_possible(context, kind, p):
        return False
    parameter = context.system.parameters.get(rate_key(p))
    if parameter is not None and ((kind == "grows" and parameter.is_share) or parameter.is_count):
        return False  # they are at most 1; a gear has teeth, as many as fit on it, and fewer than the ring round it
    conditions = [c.expression for c in answer.conditions if isinstance(c, Stated)]
    own, inside = rate_key(q if kind == "equal" else p), 0
    for draw in context.setup.draws:
        values = _values(context, draw)
        if not all(_may_hold(c, values, own) for c in conditions):
            continue
        inside += 1
        own_value = values.get(own, 1.0)
        near = {"equal": values.get(rate_key(p), 1.0), "zero": SMALL * own_value, "grows": own_value / SMALL}
        values[own] = near.get(kind, math.pi / 2 - SMALL)
        if not all(_may_hold(c, values, own) for c in conditions):
            return False
    return inside > 0


def _may_hold(condition: str, values: dict[str, float], own: str) -> bool:
    """What cannot be told is no obstacle, unless it is about the parameter of the case."""
    found = is_true(condition, values, round_off=ROUND_OFF)
    return found if found is not None else own not in _WORD.findall(condition)


def _values(context: Context, draw: Draw) -> dict[str, float]:
    """The parameters, and what moves as it is at the start, by the names of formulas."""
    model, values = context.setup.model, dict(draw.values)
    with suppress(CannotAnswer, ArithmeticError, ValueError):
        numbers = model.samples.numbers(draw.sample(draw.start()))
        for index, generator in model.field.generators.items():
            if generator.kind in ("coordinate", "speed") and index in numbers:
                values[rate_key(generator.display)] = float(numbers[index])
    return values


def _coordinates(context: Context) -> dict[str, Ratio]:
    f = context.setup.model.field
    found: dict[str, Ratio] = {}
    for index, generator in f.generators.items():
        if isinstance(generator.display, (Symbol, Call)) and generator.kind in ("coordinate", "speed", "parameter"):
            try:
                found[rate_key(generator.display)] = f.variable(index)
            except ExpressionError:
                continue
    return found


def _cases(context: Context, element: Ratio) -> Iterator[tuple[LimitingCase, tuple[str, Expr, Expr]]]:
    f, system = element.field, context.system
    used = f.ingredients(element)
    present = [p for p in system.parameters.values() if p.form is None and _index(context, p.name) in used]
    for k, p in enumerate(present):
        for q in present[k + 1 :]:
            if p.dimension == q.dimension and p.is_angle == q.is_angle:
                at = f.variable(_index(context, p.name))
                yield LimitingCase("", _index(context, q.name), at), ("equal", Symbol(p.name), Symbol(q.name))
    for p in present:
        index, symbol = _index(context, p.name), Symbol(p.name)
        if p.dimension in (MASS, INERTIA, DIMENSIONLESS) or p.is_angle:
            yield LimitingCase("", index, f.zero), ("zero", symbol, symbol)
        if p.is_angle:
            yield LimitingCase("", index, f.pi / 2), ("right_angle", symbol, symbol)
        elif p.dimension in (MASS, INERTIA, DIMENSIONLESS):
            yield LimitingCase("", index, None), ("grows", symbol, symbol)


def _index(context: Context, name: str) -> int:
    model = context.setup.model
    return model.field.index(model.parameters[name])
