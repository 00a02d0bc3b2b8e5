"""What a terminal shows of a single answer."""

from __future__ import annotations

from freebody.present.report.formats.terminal import terminal_text
from freebody.present.report.results import summary
from freebody.study.answering.answer import Answer
from freebody.study.answering.told import answer_section


def said(answer: Answer, *, is_short: bool = False) -> list[str]:
    """Its lines, without those of a title."""
    return terminal_text(summary("", [answer_section(answer)]), is_short=is_short).splitlines()[2:]
