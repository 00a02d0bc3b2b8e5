"""What is found about one answer, as a result."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from freebody.assess.typed import TypedJudgement
from freebody.language.expression import Expr
from freebody.language.notation import to_latex, to_python
from freebody.language.typed import TypedNumber
from freebody.narrative.sheets.options import shown
from freebody.narrative.telling.catalogue import Catalogue
from freebody.present.report.blocks import (
    Block,
    Choices,
    Emphasis,
    Entry,
    Equation,
    Equations,
    Formula,
    Paragraph,
    Report,
)
from freebody.present.report.result import Result
from freebody.present.report.results import entries, entry, line
from freebody.questions.reading import Question

_LONGEST = 200  # characters of an unreadable answer that are told


@dataclass(frozen=True)
class CheckedAnswer(Result):
    """The verdict on one answer. text: as it was typed; leads: the mistake that leads to it, in words of the language,
    where one was found by its formula."""

    question: Question
    text: str
    judgement: TypedJudgement
    language: str = "en"
    leads: str = ""
    title: str = ""
    is_brief: bool = False  # in a quiz: what would give the answer away is not shown
    chosen: tuple[str, str] = ("", "")  # the option that was chosen by its letter, as the file has it

    @property
    def verdict(self) -> str:
        return self.judgement.verdict

    @property
    def is_complete(self) -> bool:
        return self.verdict == "correct"

    @property
    def reason(self) -> str:
        return self._said(self.judgement.reason)

    @property
    def condition(self) -> str:
        return self._said(self.judgement.condition)

    @property
    def mistake(self) -> str:
        return self.leads or self._said(self.judgement.mistake)

    @property
    def counterexample(self) -> str:
        return self._said(self.judgement.counterexample)

    @property
    def decided_by(self) -> str:
        return self._said(self.judgement.decided_by)

    def _said(self, text: str) -> str:
        return text and Catalogue(self.language).said(text)

    def to_plain(self) -> dict[str, Any]:
        """The verdict as plain data: the JSON document of the command line."""
        return {
            "question": self.question.id,
            "answer": self.text,
            "verdict": self.verdict,
            "reason": self.reason or None,
            "condition": self.condition or None,
            "mistake": self.mistake or None,
            "counterexample": self.counterexample or None,
            "decided_by": self.decided_by or None,
            "reading": self._reading(),
        }

    def _reading(self) -> dict[str, Any] | None:
        answer = self.judgement.answer
        if self.judgement.forces:
            return {"expression": list(self.judgement.forces), "latex": [], "label": None}
        if self.judgement.equations:
            sides = [tuple(map(to_python, equation)) for equation in self.judgement.equations]
            latex = [" = ".join(map(to_latex, equation)) for equation in self.judgement.equations]
            return {"expression": [f"{left} = {right}" for left, right in sides], "latex": latex, "label": None}
        if answer is None:
            return None
        shown = [_shown(part) for part in answer.parts]
        latex = [to_latex(part) if not isinstance(part, TypedNumber) else part.text for part in answer.parts]
        return {"expression": shown[0] if len(shown) == 1 else shown, "latex": latex, "label": answer.label or None}

    @property
    def report(self) -> Report:
        """The verdict, after the answer as it was read."""
        catalogue = Catalogue(self.language)
        title = self.title or "freebody"
        return Report(title, self.language, "", tuple(self._blocks(catalogue)), catalogue.report_words, is_summary=True)

    def _blocks(self, catalogue: Catalogue) -> Iterator[Block]:
        yield line(Emphasis(self.question.id, "code"), f"  {self.question.text}")
        answer, equations = self.judgement.answer, self.judgement.equations
        letter, option = self.chosen
        if letter:
            yield Choices(((f"({letter})", shown(option, catalogue.option(option))),))
        elif equations:
            yield Paragraph((catalogue.word("marking.read_as"),))
            yield from (Paragraph(("    ", Formula(sides, ("=",)))) for sides in equations)
        elif self.judgement.forces:
            yield Paragraph((catalogue.word("marking.read_as"),))
            yield from (Paragraph((f"    {force}",)) for force in self.judgement.forces)
        elif answer is None:
            yield from entries(entry(catalogue.word("marking.answer"), _shortened(self.text)))
        else:
            formulas = [p for p in answer.parts if not isinstance(p, TypedNumber)]
            numbers = [p.text for p in answer.parts if isinstance(p, TypedNumber)]
            yield from entries(entry(catalogue.word("marking.read_as"), *numbers))
            if formulas:
                yield Paragraph((catalogue.word("marking.read_as"),))
                yield Equations(tuple(Equation(Formula((p,))) for p in formulas))
        yield Paragraph((Emphasis(catalogue.word(f"marking.{self.verdict}"), "strong"),))
        yield from entries(*self._said_of(catalogue))

    def _said_of(self, catalogue: Catalogue) -> Iterator[Entry]:
        gives_away = (
            self.is_brief and self.verdict == "incorrect" and not self.chosen[0] and not self.judgement.is_of_form
        )
        yield entry(catalogue.word("marking.reason"), *filter(None, ["" if gives_away else self.reason]))
        yield entry(catalogue.word("marking.mistake"), *filter(None, [self.mistake]))
        if self.is_brief:
            return
        is_new = self.counterexample and self.counterexample != self.reason
        yield entry(catalogue.word("marking.numbers"), *filter(None, [self.counterexample if is_new else ""]))
        yield entry(catalogue.word("marking.decided_by"), *filter(None, [self.decided_by]))


def _shown(part: Expr | TypedNumber) -> str:
    return part.text if isinstance(part, TypedNumber) else to_python(part)


def _shortened(text: str) -> str:
    """The beginning of what is too long to be told whole."""
    return text if len(text) <= _LONGEST else text[:_LONGEST] + " ..."
