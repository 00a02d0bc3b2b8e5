"""A quiz: questions of several systems one after the other, with attempts, hints from the derivations, and a log.

What cannot be read or decided costs no attempt. Hints are those of the worked solution, stage by stage; it is derived
when the first one is asked for.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from freebody.errors import FreebodyError, InputError
from freebody.language.sentences import Message
from freebody.narrative.explain import explain
from freebody.narrative.marking.check import check, marked_question
from freebody.narrative.marking.found import CheckedAnswer
from freebody.narrative.sheets.asking import asking
from freebody.narrative.sheets.statement import ExerciseStatement, title_of
from freebody.narrative.telling.catalogue import Catalogue
from freebody.narrative.telling.house import in_style
from freebody.narrative.telling.reports import ReportTeller
from freebody.present.report.blocks import Block, Choices, Emphasis, Paragraph, Report
from freebody.questions.reading import Question
from freebody.system.system import System

FREE = ("unreadable", "undecided")  # verdicts that cost no attempt


@dataclass
class QuizQuestion:
    """One question while it is being answered."""

    system: System
    question: Question
    attempts: int
    language: str = "en"
    log: list[dict[str, Any]] = field(default_factory=list[dict[str, Any]])
    n_hints: int = 0
    _hints: list[str] | None = None

    @property
    def words(self) -> str:
        """The question as an exercise asks it."""
        return self.question.words or Catalogue(self.language).plain(asking(self.system, self.question))

    @property
    def report(self) -> Report:
        """The question with its options, as a sheet has it."""
        catalogue = Catalogue(self.language)
        statement = ExerciseStatement(self.system, catalogue, 1, 1)
        blocks: list[Block] = [Paragraph((Emphasis(self.question.id, "code"), "  ", *statement.prompt(self.question)))]
        options = tuple((f"({k})", statement.option(text)) for k, text in self.question.options.items())
        blocks += [Choices(options)] if options else []
        title = title_of(self.system, catalogue)
        shown = in_style(tuple(blocks), self.system.style)
        return Report(title, self.language, "", shown, catalogue.report_words, is_summary=True)

    @property
    def n_left(self) -> int:
        """Attempts that are left."""
        return self.attempts - sum(entry["verdict"] not in FREE for entry in self.log)

    @property
    def is_solved(self) -> bool:
        return any(entry["verdict"] == "correct" for entry in self.log)

    @property
    def is_over(self) -> bool:
        return self.is_solved or self.n_left <= 0

    def answer(self, text: str) -> CheckedAnswer:
        """Judges an attempt and writes it into the log."""
        found = check(self.system, self.question.id, text, language=self.language)
        assert isinstance(found, CheckedAnswer)
        self.log.append(
            {
                "file": self.system.file or self.system.title,
                "question": self.question.id,
                "answer": found.text,
                "verdict": found.verdict,
                "mistake": found.mistake or None,
                "condition": found.condition or None,
                "hints": self.n_hints,
            }
        )
        return found

    def hint(self) -> str:
        """The next hint of the worked solution; nothing where there is none left."""
        if self._hints is None:
            self._hints = list(self._derived())
        if self.n_hints >= len(self._hints):
            return ""
        self.n_hints += 1
        return self._hints[self.n_hints - 1]

    def _derived(self) -> Iterator[str]:
        catalogue = Catalogue(self.language)
        try:
            derivations = explain(self.system, self.question.id, language=self.language).derivations
        except FreebodyError:
            return
        for stage in (stage for d in derivations for stage in d.stages):
            if stage.hint is not None:
                yield catalogue.plain(stage.hint)

    def solution(self) -> Report:
        """The right option and the answer, when the attempts are used up."""
        catalogue = Catalogue(self.language)
        marked = marked_question(self.system, self.question.id)
        told = ReportTeller(self.language).tell(replace(marked.answer, evidence=None).report)
        blocks = told.blocks
        if letter := marked.right_option:
            option = ExerciseStatement(self.system, catalogue, 1, 1).option(marked.options[letter])
            blocks = (Choices(((f"({letter})", option),)), *blocks)
        return replace(told, title=catalogue.word("quiz.solution"), blocks=blocks)


def quiz(
    systems: Sequence[System], ids: Sequence[str] = (), *, attempts: int = 3, language: str = "en"
) -> list[QuizQuestion]:
    """The questions of some systems that can be answered, in their order; ids: only these. Raises InputError where no
    question is left or the attempts are none."""
    Catalogue(language)
    if attempts < 1:
        raise InputError(Message("a quiz allows one attempt at least"))
    asked = [
        QuizQuestion(system, question, attempts, language)
        for system in systems
        for question in system.questions
        if not ids or question.id in ids
    ]
    if not asked:
        raise InputError(Message("there is no question to ask"))
    return asked
