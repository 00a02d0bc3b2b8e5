"""The formulas of an answer at arrays of numbers: in each case that one whose conditions are known to hold there.

A condition in coordinates, for every pose of the motion, is judged at the start where the question is about the start.
A formula whose conditions cannot be read as relations between parameters is used nowhere.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from freebody.errors import ExpressionError
from freebody.language.expression import Expr
from freebody.language.notation import Stated
from freebody.language.truth import read_statement, with_known
from freebody.numeric.jets import Array
from freebody.numeric.vectorised import VectorFunction, VectorStatement
from freebody.study.answering.answer import Answer
from freebody.study.answering.scope import is_scope

_ROUND_OFF = 1e-12  # of the larger side, by which a condition that includes equality may miss


@dataclass(frozen=True)
class AnswerForm:
    """A formula, part by part, and the conditions under which it holds, None where they cannot be read."""

    parts: VectorFunction
    conditions: tuple[tuple[VectorStatement, str], ...] | None  # each with its words
    expressions: tuple[Expr, ...]
    said: tuple[str, ...]

    def holds(self, known: Mapping[str, Array | float], n: int) -> NDArray[np.bool_]:
        """(n,) where the conditions are known to hold."""
        if not self.parts.names <= known.keys() or self.conditions is None:
            return np.zeros(n, dtype=bool)
        holds = np.ones(n, dtype=bool)
        for condition, _text in self.conditions:
            holds &= condition.at(known, n, round_off=_ROUND_OFF) > 0 if condition.names <= known.keys() else False
        return holds

    def broken(self, known: Mapping[str, Array | float]) -> list[str]:
        """The words of the conditions that are not true at numbers, one for each name."""
        return [
            text
            for condition, text in self.conditions or ()
            if condition.names <= known.keys() and condition.at(known, 1, round_off=_ROUND_OFF)[0] < 0
        ]


def forms_of(answer: Answer, n_parts: int, start: Mapping[str, Expr] | None = None) -> tuple[AnswerForm, ...]:
    """The formulas, those with readable conditions in parameters alone. start: measures in parameters, at the instant
    of which the answer is."""
    if answer.expression is None:
        return ()
    cases = [(c.expression, c.conditions) for c in answer.cases] or [(answer.expression, answer.conditions)]
    found: list[AnswerForm] = []
    for expression, conditions in cases:
        parts = expression if isinstance(expression, tuple) else (expression,)
        if len(parts) != n_parts:
            continue
        said = tuple(map(str, conditions))
        with suppress(ExpressionError):  # a rate that is left open has no value in parameters
            found.append(AnswerForm(VectorFunction(parts), _read(conditions, start or {}), parts, said))
    return tuple(found)


def which_holds(
    forms: Sequence[AnswerForm], known: Mapping[str, Array | float], is_open: NDArray[np.bool_]
) -> NDArray[np.int64]:
    """(n,) the first formula that is known to hold and has a value, of the cases that are open; -1 for none."""
    n = len(is_open)
    which = np.full(n, -1)
    for k, form in enumerate(forms):
        holds = is_open & (which < 0) & form.holds(known, n)
        if holds.any():
            holds &= np.isfinite(form.parts.at(known, n)).all(axis=0)
            which[holds] = k
    return which


def _read(conditions: Sequence[str], start: Mapping[str, Expr]) -> tuple[tuple[VectorStatement, str], ...] | None:
    """Conditions as statements about arrays, those that say that there is none left out; None where one cannot be
    read."""
    found: list[tuple[VectorStatement, str]] = []
    for text in conditions:
        statement = read_statement(text.expression) if isinstance(text, Stated) else None
        if statement is not None:
            found.append((VectorStatement(with_known(statement, start)), text))
        elif isinstance(text, Stated) or not is_scope(text):
            return None
    return tuple(found)
