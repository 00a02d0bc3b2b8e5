"""A solution line by line: the first line that does not hold, and what follows from it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from freebody.assess.equations import Equation
from freebody.assess.points import working_precision
from freebody.assess.working import LineFound, WorkingJudge
from freebody.errors import ExpressionError, InputError
from freebody.language.notation import to_latex, to_python
from freebody.language.plain_text import plain, shortened
from freebody.language.sentences import Message
from freebody.language.typed import read_equation
from freebody.narrative.marking.equations import equations_of
from freebody.narrative.telling.catalogue import Catalogue
from freebody.present.report.blocks import Block, Formula, Paragraph, Report
from freebody.present.report.result import Result
from freebody.present.report.results import entries, entry
from freebody.system.system import System

MOST_LINES = 60


@dataclass(frozen=True)
class CheckedLine:
    """A line as it was written and read, with its verdict. n: as lines are counted in the text."""

    n: int
    text: str
    equation: Equation | None
    found: LineFound


@dataclass(frozen=True)
class CheckedWorking(Result):
    """The verdicts on the lines of a solution."""

    lines: tuple[CheckedLine, ...]
    language: str = "en"
    title: str = ""

    @property
    def first_wrong(self) -> int | None:
        """The number of the first line that does not hold."""
        return next((line.n for line in self.lines if line.found.verdict == "wrong"), None)

    @property
    def verdict(self) -> str:
        if self.first_wrong is not None:
            return "incorrect"
        return "correct" if any(line.found.verdict == "holds" for line in self.lines) else "undecided"

    @property
    def is_complete(self) -> bool:
        return self.verdict == "correct"

    def _said(self, text: str) -> str:
        return text and Catalogue(self.language).said(text)

    def to_plain(self) -> dict[str, Any]:
        """The lines as plain data: the JSON document of the command line."""
        return {"verdict": self.verdict, "first_wrong": self.first_wrong, "lines": [self._plain(x) for x in self.lines]}

    def _plain(self, line: CheckedLine) -> dict[str, Any]:
        equation = line.equation
        return {
            "line": line.n,
            "text": line.text,
            "verdict": line.found.verdict,
            "principle": line.found.principle,
            "reason": self._said(line.found.reason) or None,
            "mistake": self._said(line.found.mistake) or None,
            "reading": None if equation is None else " = ".join(map(to_python, equation)),
            "latex": None if equation is None else " = ".join(map(to_latex, equation)),
        }

    @property
    def report(self) -> Report:
        """Every line with its verdict."""
        catalogue = Catalogue(self.language)
        blocks = tuple(self._blocks(catalogue))
        return Report(self.title or "freebody", self.language, "", blocks, catalogue.report_words, is_summary=True)

    def _blocks(self, catalogue: Catalogue) -> Iterator[Block]:
        for line in self.lines:
            key = line.found.principle if line.found.verdict == "holds" else line.found.verdict
            if line.equation is None:
                yield Paragraph((f"{line.n}  {line.text}",))
            else:
                yield Paragraph((f"{line.n}  ", Formula(line.equation, ("=",))))
            yield from entries(
                entry(catalogue.word("marking.line"), catalogue.word(f"marking.line_{key}")),
                entry(catalogue.word("marking.reason"), *filter(None, [self._said(line.found.reason)])),
                entry(catalogue.word("marking.mistake"), *filter(None, [self._said(line.found.mistake)])),
            )


def check_working(system: System, text: str, *, language: str = "en") -> CheckedWorking:
    """Judges a solution of equations, one a line; lines without one are left out of the judgement. Raises InputError
    for a text that is too long, CannotAnswer where the motion of the system has no formulas."""
    Catalogue(language)
    lines = [(n, line.strip()) for n, line in enumerate(text.splitlines(), 1) if line.strip()]
    if len(lines) > MOST_LINES:
        raise InputError(Message("a solution may have {most} lines, this one has {n}", most=MOST_LINES, n=len(lines)))
    marked = equations_of(system)
    judge = WorkingJudge(marked.judging)
    found: list[CheckedLine] = []
    for n, line in lines:
        shown = shortened(plain(line), 200)
        try:
            equation = read_equation(line, marked.vocabulary)
        except ExpressionError as error:
            why = str(error) if "=" in line else ""  # words between the lines are no fault
            found.append(CheckedLine(n, shown, None, LineFound("not_judged", why)))
            continue
        with working_precision():
            found.append(CheckedLine(n, shown, equation, judge.line(n, equation)))
    return CheckedWorking(tuple(found), language, system.title)
