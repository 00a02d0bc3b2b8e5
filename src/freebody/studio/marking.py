"""Where something changes along a slider: values of one parameter, all others as they are, at which a condition of an
answer to a question of the file begins or ceases to be true. The answer says the condition; its place is where its
truth changes, between two of many values, halved down to round-off."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from freebody.language.units import parse_quantity
from freebody.numeric.jets import Array
from freebody.numeric.vectorised import VectorStatement
from freebody.studio.reading import checked_system
from freebody.studio.telling import told
from freebody.studio.wire.motions import Mark, MarksAnswer, MarksRequest, Range
from freebody.study.sweeps.answers import AnswerEvaluator

_N = 401  # values along a slider
_HALVED = 40  # times, which leaves 1e-12 of a slider
_SAME = 1e-6  # of a slider: two places that are told as one


def marks(request: MarksRequest) -> MarksAnswer:
    """Raises ModelError where the text is no model."""
    system = checked_system(request.text)
    # by their words: several questions may say the same
    conditions: dict[str, tuple[VectorStatement, dict[str, float]]] = {}
    for question in system.questions:
        evaluator = AnswerEvaluator(system, question)
        for form in evaluator.forms:
            conditions |= {text: (statement, evaluator.own) for statement, text in form.conditions or ()}
    found: list[Mark] = []
    for each in request.ranges:
        of_name: list[Mark] = []
        for text, (statement, own) in conditions.items():
            for at in _changes(statement, own, each):
                near = [mark for mark in of_name if abs(mark.at - at) <= _SAME * (each.high - each.low)]
                said = told(text, request.language)
                if not near:
                    of_name.append(Mark(name=each.name, at=at, words=[said]))
                elif said not in near[0].words:
                    near[0].words.append(said)
        found += sorted(of_name, key=lambda mark: mark.at)
    return MarksAnswer(marks=found)


def _changes(statement: VectorStatement, own: dict[str, float], along: Range) -> Iterator[float]:
    """Where the truth of a statement changes, in the unit of a slider."""
    if along.name not in statement.names or not statement.names <= own.keys():
        return
    unit = parse_quantity(f"1 {along.unit}".strip()).value

    def truth(x: Array) -> Array:
        return statement.at({**own, along.name: unit * x}, len(x))

    x = np.linspace(along.low, along.high, _N)
    so = truth(x)
    at = np.flatnonzero(so[:-1] * so[1:] < 0.0)  # neither side without a value
    below, above, first = x[at], x[at + 1], so[at]
    for _ in range(_HALVED):
        middle = 0.5 * (below + above)
        is_below = truth(middle) == first
        below, above = np.where(is_below, middle, below), np.where(is_below, above, middle)
    size = along.high - along.low
    for found in (0.5 * (below + above)).tolist():
        if along.low + _SAME * size < found < along.high - _SAME * size:  # beyond an end there is nothing to move to
            yield found
