"""Not written yet."""

from __future__ import annotations

from freebody.errors import CannotAnswer
from freebody.model.question import Question
from freebody.narrative.context import Context, Method
from freebody.narrative.script import Stage
from freebody.study.answer import Answer


def derive(context: Context, question: Question, answer: Answer, method: Method) -> list[Stage]:
    raise CannotAnswer("no derivation yet")
