"""Answers that somebody types on the page: judged, and helped by hints, as in the quiz of the terminal."""

from __future__ import annotations

from dataclasses import replace

from freebody.narrative.marking.check import check
from freebody.narrative.marking.found import CheckedAnswer
from freebody.narrative.marking.quiz import FREE, QuizQuestion, quiz
from freebody.present.report.formats.html import html_content
from freebody.present.report.results import finite
from freebody.studio.reading import checked_system
from freebody.studio.wire.studies import HintsAnswer, HintsRequest, JudgeAnswer, JudgeRequest, PosedAnswer, PosedRequest


def judged(request: JudgeRequest) -> JudgeAnswer:
    """The verdict on an answer, or on the forces that act on bodies that are cut free."""
    system = checked_system(request.text)
    free_body = ", ".join(request.free) or None
    question = None if free_body else request.question
    found = check(system, question, request.answer, free_body=free_body, language=request.language)
    assert isinstance(found, CheckedAnswer)
    shown = replace(found, is_brief=not free_body)
    return JudgeAnswer(
        html=html_content(shown.report, request.prefix),
        plain=finite(found.to_plain()),
        is_right=found.is_complete,
        is_attempt=found.verdict not in FREE,
    )


def posed(request: PosedRequest) -> PosedAnswer:
    """A question as an exercise asks it."""
    one = _asked(request)
    return PosedAnswer(html=html_content(one.report, request.prefix), options=list(one.question.options))


def hints(request: HintsRequest) -> HintsAnswer:
    """The hints of the derivation of a question in their order."""
    return HintsAnswer(hints=list(iter(_asked(request).hint, "")))


def _asked(request: HintsRequest) -> QuizQuestion:
    [one] = quiz([checked_system(request.text)], (request.question,), language=request.language)
    return one
