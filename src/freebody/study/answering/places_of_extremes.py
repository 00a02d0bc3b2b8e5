"""Events at which a measure, or another quantity, is at its greatest or least (`when theta is greatest`).

Three questions tell where that is: how great it gets, what it is at the start, and what it is where it first turns.
What is asked at the event is then asked at the start, where it turns, or where it has that value. Of a quantity that is
no measure the place is the one at which it has its extreme (`places_of_quantities.py`).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from itertools import islice

from freebody.errors import CannotAnswer, ModelError
from freebody.language.expression import FLOAT_FUNCTIONS, ZERO, Expr, Number, Symbol, evaluate, number
from freebody.language.notation import Stated, compared, reworded, to_python
from freebody.language.sentences import Message
from freebody.questions.clock import Clock
from freebody.questions.event import ExtremeEvent, FarthestPlace, QuantityEvent
from freebody.questions.event_base import QuestionEvent
from freebody.questions.motion import OfMeasure
from freebody.questions.reading import FoundAt, Question
from freebody.study.answering.answer import Answer
from freebody.study.answering.draws import Draw
from freebody.study.answering.parts import part_for
from freebody.study.answering.scope import is_scope
from freebody.study.answering.solution import Solution
from freebody.study.answering.uniform_extremes import instant_of_turn
from freebody.study.setup import Setup
from freebody.system.system import System

_N_DRAWS = 6  # at which two formulas are compared
_SAME = 1e-9  # relative
_OR = " | "  # between places, as a condition in Python
_SAME_NUMBER = 1e-7  # relative: an extreme that was seen in numbers alone
Solver = Callable[[System], Solution]  # what answers the questions of a system


@dataclass(frozen=True)
class _Ends:
    """What something is at its extreme, at the start and where it first turns."""

    extreme: Answer
    start: Answer
    turn: Answer | None


def at_extreme(system: System, question: Question, event: ExtremeEvent, solve: Solver) -> Question:
    """The question at the place of the extreme. Raises CannotAnswer where that is not found."""
    ends = _ends(system, event, solve)
    extreme = ends.extreme
    if isinstance(extreme.expression, tuple) or (extreme.value is None and extreme.expression is None):
        raise CannotAnswer(extreme.reason or Message("'{event}': that has several values", event=event.text))
    if extreme.cases:
        told = Message(
            "where '{event}' is so depends on the case of the motion; ask at another event", event=event.text
        )
        raise CannotAnswer(told)
    found = _found_at(event, extreme)
    if _is_same(system, extreme, ends.start):
        return replace(question, event=None, at_start=True, found_at=found)
    if (time := _instant(system, event)) is not None:
        return replace(question, event=Clock(time, event.text), found_at=found)
    if event.quantity is not None and extreme.expression == ZERO and (stop := _stop(system, event)) is not None:
        return replace(question, event=stop, found_at=FoundAt(found.conditions, ""))
    if event.quantity is not None:
        return replace(question, event=_of_quantity(event, _target(extreme)), found_at=found)
    side = 1 if event.end == "greatest" else -1
    if ends.turn is not None and _is_same(system, extreme, ends.turn):
        turn = FarthestPlace(event.measure, 1, ZERO, event.text, side)
        return replace(question, event=turn, found_at=found)
    place = FarthestPlace(event.measure, 0, _target(extreme), event.text, side)
    return replace(question, event=place, found_at=found)


def _ends(system: System, event: ExtremeEvent, solve: Solver) -> _Ends:
    texts = [f"{event.end} {event.phrase}", f"{event.phrase} at start"]
    if event.quantity is None:
        texts.append(f"{event.phrase} when {event.phrase} turns back")
    try:
        asked = system.asked(*texts)
    except ModelError as error:
        raise CannotAnswer(str(error)) from None
    if len(asked) != len(texts):
        raise CannotAnswer(Message("'{event}' can be meant in several ways", event=event.text))
    found = solve(replace(system, questions=asked)).answers
    return _Ends(found[0], found[1], found[2] if len(found) > len(texts) - 1 and event.quantity is None else None)


def _instant(system: System, event: ExtremeEvent) -> Expr | None:
    """When something turns that depends on several evenly accelerated coordinates."""
    of = event.quantity or OfMeasure(event.measure, 0, event.phrase)
    part = part_for(system, system.groups, Question("it", event.text, of)) or system
    if part.bounds or part.dry_friction or part.blows:
        return None
    try:
        return instant_of_turn(Setup(part), of)
    except CannotAnswer:
        return None


def _stop(system: System, event: ExtremeEvent) -> QuestionEvent | None:
    """The event of a measure that a speed of zero is: it turns there."""
    try:
        (asked,) = system.asked(f"time when the {event.phrase} is zero")
    except (ModelError, ValueError):
        return None
    is_of_measure = isinstance(asked.event, QuestionEvent) and not isinstance(asked.event, QuantityEvent)
    return asked.event if is_of_measure and isinstance(asked.event, QuestionEvent) else None


def _target(extreme: Answer) -> Expr:
    assert not isinstance(extreme.expression, tuple)
    if extreme.expression is not None:
        return extreme.expression
    assert isinstance(extreme.value, float)
    return number(extreme.value)


def _of_quantity(event: ExtremeEvent, target: Expr) -> QuantityEvent:
    assert event.quantity is not None
    unit = event.quantity.unit if isinstance(target, Number) else "1"
    shown = to_python(target) if unit == "1" else f"{to_python(target)} {unit}"
    return QuantityEvent(event.measure, 0, Symbol(""), event.text, event.quantity, target, event.phrase, shown)


def _found_at(event: ExtremeEvent, extreme: Answer) -> FoundAt:
    conditions = tuple(c for c in extreme.conditions if not is_scope(c))
    if extreme.expression is None or isinstance(extreme.expression, tuple):
        return FoundAt(conditions, "")
    name = Symbol(event.phrase) if event.phrase.isidentifier() else None
    if name is None:  # where it is as great at several places, all of them are told
        several = (note for note in extreme.notes if isinstance(note, Stated) and _OR in str(note.expression))
        return FoundAt(conditions, next(several, ""))
    equation = compared(name, "=", extreme.expression)
    return FoundAt(
        conditions, reworded(Message("'{event}' is so at {place}", event=event.text, place=equation), equation)
    )


def _is_same(system: System, one: Answer, other: Answer) -> bool:
    """Whether two answers are one: as formulas at many parameters, else as numbers."""
    a, b = one.expression, other.expression
    if isinstance(b, tuple) or isinstance(a, tuple):
        return False
    if a is None or b is None:
        x, y = one.value, other.value
        return isinstance(x, float) and isinstance(y, float) and math.isclose(x, y, rel_tol=_SAME_NUMBER, abs_tol=_SAME)
    return a == b or _agree(Setup(system).draw_stream(), a, b)


def _agree(draws: Iterable[Draw], a: Expr, b: Expr) -> bool:
    """Whether two formulas have the same values at many parameters."""
    n = 0
    for draw in islice(draws, _N_DRAWS):
        try:
            x, y = (float(evaluate(e, draw.values, FLOAT_FUNCTIONS)) for e in (a, b))
        except (ArithmeticError, ValueError):
            continue
        if not math.isclose(x, y, rel_tol=_SAME, abs_tol=_SAME):
            return False
        n += 1
    return n > 1
