"""Lengths, speeds and masses that a file gives as numbers stand as such in the formulas: L > 1 is L > 1 m."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from freebody.assess.names import NameTable
from freebody.errors import UnitError
from freebody.language.expression import Expr, add, free_symbols, negate
from freebody.language.notation import Stated
from freebody.language.sentences import Message
from freebody.language.units import Dimension, dimension_of, parse_unit
from freebody.measures.geometry import ZERO
from freebody.study.answering.answer import Answer
from freebody.symbolic.model import SymbolicModel
from freebody.system.system import System


def with_plain_numbers(system: System, model: SymbolicModel, answers: Sequence[Answer]) -> tuple[Answer, ...]:
    """A note more for every answer whose units fit with the units of its numbers only."""
    dimensions = NameTable(model, system).dimensions
    told = Message("numbers that the file gives with a unit stand in it in SI units")
    return tuple(
        replace(answer, notes=(*answer.notes, told)) if _has_plain_numbers(answer, dimensions) else answer
        for answer in answers
    )


def _has_plain_numbers(answer: Answer, dimensions: Mapping[str, Dimension]) -> bool:
    unit = parse_unit(answer.unit).dimension if answer.unit else None  # a list of unlike quantities has none
    return any(_is_unlike(part, dimensions, unit) for part in _components(answer)) or any(
        _is_unlike(add(left, negate(right)), dimensions) for left, right in _comparisons(answer)
    )


def _components(answer: Answer) -> Iterator[Expr]:
    for form in (answer.expression, *(case.expression for case in answer.cases)):
        yield from form if isinstance(form, tuple) else () if form is None else (form,)


def _comparisons(answer: Answer) -> Iterator[tuple[Expr, Expr]]:
    for text in (*answer.conditions, *(text for case in answer.cases for text in case.conditions)):
        if isinstance(text, Stated) and text.sides is not None:
            yield text.sides[0], text.sides[2]


def _is_unlike(expr: Expr, dimensions: Mapping[str, Dimension], unit: Dimension | None = None) -> bool:
    """Whether unlike quantities are added in it, or it has not the unit that it should have."""
    if expr == ZERO or any(name not in dimensions for name in free_symbols(expr)):
        return False
    try:
        own = dimension_of(expr, dimensions)
    except UnitError:
        return True
    return unit is not None and own != unit
