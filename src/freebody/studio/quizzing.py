"""Answers that somebody types on the page: judged, and helped by hints, as in the quiz of the terminal."""

from __future__ import annotations

from dataclasses import replace

from freebody.narrative.marking.check import check
from freebody.narrative.marking.found import CheckedAnswer
from freebody.narrative.marking.quiz import FREE, quiz
from freebody.present.report.formats.html import html_content
from freebody.present.report.results import finite
from freebody.studio.reading import checked_system
from freebody.studio.wire import HintsAnswer, HintsRequest, JudgeAnswer, JudgeRequest


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


def hints(request: HintsRequest) -> HintsAnswer:
    """How a question is asked in an exercise, and the hints of its derivation in their order."""
    system = checked_system(request.text)
    [one] = quiz([system], (request.question,), language=request.language)
    return HintsAnswer(words=one.words, hints=list(iter(one.hint, "")))
