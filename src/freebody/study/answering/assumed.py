"""What the start of a model leaves open and is taken for granted: each of these is an assumption of the results."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from contextlib import suppress

from freebody.errors import CannotAnswer
from freebody.language.notation import Stated, to_python
from freebody.language.sentences import Message
from freebody.study.answering.answer import Answer
from freebody.study.setup import Setup
from freebody.symbolic.field import Ratio
from freebody.symbolic.tidy import tidy

_WORD = re.compile(r"[A-Za-z_]\w*")


def assumed_at_start(setup: Setup, answers: Sequence[Answer]) -> tuple[str, ...]:
    """Rates that the start does not give and that are not zero, and symbols of start values that stand in answers."""
    with suppress(CannotAnswer, ZeroDivisionError):
        return (*setup.start.assumed, *_start_symbols(setup, answers))
    return ()


def _start_symbols(setup: Setup, answers: Sequence[Answer]) -> Iterator[str]:
    model = setup.model
    names = {c.index: c.name for c in (*model.coordinates, *model.dependent)}
    meanings: list[tuple[Ratio, str]] = [
        (symbol, Message("what {row} keeps", row=row)) for row, symbol in model.constants.items()
    ]
    meanings += [
        (symbol, Message("what {name} is", name=names[k]))
        for k, symbol in model.samples.start_symbols.items()
        if k in names
    ]
    used = set[str]().union(*(_symbols(answer) for answer in answers))
    for symbol, meaning in meanings:
        name = to_python(tidy(symbol))
        if name in used:
            told = Message("{name} is {meaning} at the start", name=name, meaning=meaning)
            if setup.has_values:
                with suppress(CannotAnswer, ArithmeticError, KeyError):
                    told = Message("{what} ({x:.6g} in SI units)", what=told, x=_number(setup, symbol))
            yield Message("{what}: the model does not say it, and it has no formula in the parameters", what=told)


def _symbols(answer: Answer) -> set[str]:
    """The words in the formulas of an answer and in its conditions and notes."""
    forms = [answer.expression, *(case.expression for case in answer.cases)]
    parts = [part for e in forms if e is not None for part in (e if isinstance(e, tuple) else (e,))]
    said = [*answer.conditions, *answer.notes, *(text for case in answer.cases for text in case.conditions)]
    texts = [*map(to_python, parts), *(text.expression for text in said if isinstance(text, Stated))]
    return set(_WORD.findall(" ".join(texts)))


def _number(setup: Setup, symbol: Ratio) -> float:
    draw = setup.draws[0]
    numbers = setup.model.samples.numbers(draw.sample(draw.start()), draw.sample())
    return float(setup.model.field.evaluate(symbol, numbers))
