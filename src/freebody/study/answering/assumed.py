"""What the start of a model leaves open and is taken for granted: each of these is an assumption of the results."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from contextlib import suppress

from freebody.errors import CannotAnswer
from freebody.language.notation import Stated, to_python
from freebody.language.sentences import Message
from freebody.study.answering.answer import Answer
from freebody.study.setup import Setup
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy
from freebody.tolerances import ROUND_OFF

_WORD = re.compile(r"[A-Za-z_]\w*")


def assumed_at_start(setup: Setup, answers: Sequence[Answer]) -> tuple[str, ...]:
    """Rates that the start does not give and that are not zero, and symbols of start values that stand in answers."""
    with suppress(CannotAnswer, ZeroDivisionError):
        return (*setup.start.assumed, *_open_places(setup, answers), *_start_symbols(setup, answers))
    return ()


def _open_places(setup: Setup, answers: Sequence[Answer]) -> Iterator[str]:
    """For which place the values of formulas are told that hold at every pose, where the file says of none that it
    starts there."""
    model, started = setup.model, setup.model.samples.start_symbols
    used = set[str]().union(*(_in_formulas(answer) for answer in answers if answer.value is not None))
    for c in model.coordinates:
        if c.index not in started or c.name not in used:
            continue
        with suppress(CannotAnswer, ArithmeticError, KeyError):
            x = _number(setup, started[c.index])
            x = 0.0 if abs(x) < ROUND_OFF else x
            at = f"{round(math.degrees(x), 2):g} deg" if c.is_angle else f"{x:.4g} m"
            yield Message(
                "nothing says what {name} is at the start: values are those at {name} = {at}", name=c.name, at=at
            )


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
    said = [*answer.conditions, *answer.notes, *(text for case in answer.cases for text in case.conditions)]
    texts = [text.expression for text in said if isinstance(text, Stated)]
    return _in_formulas(answer) | set(_WORD.findall(" ".join(texts)))


def _in_formulas(answer: Answer) -> set[str]:
    """The words in the formulas of an answer."""
    forms = [answer.expression, *(case.expression for case in answer.cases)]
    parts = [part for e in forms if e is not None for part in (e if isinstance(e, tuple) else (e,))]
    return set(_WORD.findall(" ".join(map(to_python, parts))))


def _number(setup: Setup, symbol: Ratio) -> float:
    draw = setup.draws[0]
    numbers = setup.model.samples.numbers(draw.sample(draw.start()), draw.sample())
    return float(setup.model.field.evaluate(symbol, numbers))
