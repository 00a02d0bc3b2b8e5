"""What a quantity that the velocities decide is at the start, beside what it is at every instant.

Of the speed of a bat that is struck the law of motion says no more than rate(phi): what the blow makes of it is the
same question at the start.
"""

from __future__ import annotations

from dataclasses import replace

from freebody.language.expression import free_symbols
from freebody.language.notation import Stated, to_python, to_text
from freebody.language.sentences import Message
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer
from freebody.study.answering.scope import is_scope


def asked_at_start(question: Question, answer: Answer) -> Question | None:
    """The same at the start, of what has velocities in its formula and a value there that is not zero; else None."""
    is_placed = question.at_start or question.event is not None or question.transition is not None
    if is_placed or question.quantity.wanted is not None or question.quantity.scope != "instant":
        return None
    parts = answer.value if isinstance(answer.value, tuple) else (answer.value,)
    if "rate(" not in _text(answer) or not any(parts) or answer.cases or answer.options:
        return None
    return replace(question, at_start=True, options={}, key=None)


def with_start(answer: Answer, at_start: Answer, *, is_struck: bool) -> Answer:
    """An answer with the formula that it has at the start, where the parameters give that alone. is_struck: after a
    blow."""
    found = at_start.expression
    if found is None or isinstance(found, tuple) or at_start.cases or "rate(" in _text(at_start):
        return answer
    is_plain = all(is_scope(condition) or condition in answer.conditions for condition in at_start.conditions)
    if not is_plain or not free_symbols(found):  # a number is the value
        return answer
    shown = to_text(found)
    blow, start = (
        Message("just after the blow of the start it is {x}", x=shown),
        Message("at the start it is {x}", x=shown),
    )
    return replace(answer, notes=(*answer.notes, Stated(blow if is_struck else start, to_python(found))))


def _text(answer: Answer) -> str:
    """The formulas of an answer, as a file writes them."""
    parts = answer.expression if isinstance(answer.expression, tuple) else (answer.expression,)
    return ", ".join(to_python(part) for part in parts if part is not None)
