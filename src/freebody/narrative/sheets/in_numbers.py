"""Options of a question in numbers, those of a variant: what the formulas of its author give there."""

from __future__ import annotations

import math
from collections.abc import Mapping

from freebody.errors import FreebodyError
from freebody.language.expression import FLOAT_FUNCTIONS, evaluate
from freebody.language.parser import parse
from freebody.language.raising import raised, typeset
from freebody.present.report.blocks import Text
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer
from freebody.system.system import System

_DIGITS = (3, 4, 5)  # as few as tell the options apart


def options_in_numbers(system: System, question: Question, answer: Answer) -> Mapping[str, Text]:
    """By option what is shown for it; nothing where one of them has no value or two have the same."""
    if answer.value is None or isinstance(answer.value, tuple):
        return {}
    values = {p.name: p.value for p in system.parameters.values() if p.value is not None}
    try:
        found = {text: float(evaluate(parse(text), values, FLOAT_FUNCTIONS)) for text in question.options.values()}
    except (FreebodyError, KeyError, ValueError, ArithmeticError, TypeError):
        return {}
    unit = "" if answer.unit in ("", "1") else f" {raised(answer.unit)}"
    for digits in _DIGITS:
        shown = {text: typeset(rounded(x, digits)) for text, x in found.items() if math.isfinite(x)}
        if len(set(shown.values())) == len(question.options):
            return {text: (f"{number}{unit}",) for text, number in shown.items()}
    return {}


def rounded(number: float, digits: int) -> str:
    """A number with a few significant digits, without an exponent where it is not needed."""
    short = float(f"{number:.{digits}g}")
    return f"{short:g}" if 1e-4 <= abs(short) < 1e5 else f"{short:.{digits}g}"
