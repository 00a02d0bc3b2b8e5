"""The result values of a solve study."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

from freebody.assess.solved import SolvedAnswer
from freebody.assess.verdict import Judgement, Verdict
from freebody.language.expression import Expr, in_one_order
from freebody.language.notation import stated_plain, to_latex, to_python
from freebody.language.sentences import Message
from freebody.language.units.conversion import conversion
from freebody.present.report.blocks import Report
from freebody.present.report.result import Result
from freebody.present.report.results import summary
from freebody.questions.reading import Question
from freebody.study.answering.named_formulas import Chain
from freebody.study.answering.told import answer_blocks

ITS_RATE = Message("this is its rate")  # a note on the answer to whether something is conserved
Value = float | tuple[float, ...] | None
NOT_VALID = "Not valid for the given numbers"  # how a note begins that names a condition which they break
WITHOUT_VALUE = Message("the formula is not valid, or has no value, at the given numbers; see the conditions and notes")


def point_moves(term: str) -> Message:
    """Another one: the rate of an angular momentum about a point that moves."""
    return Message("the point moves, so dH/dt = M - v × P, here with -v × P = {term}", term=term)


@dataclass(frozen=True)
class Evidence:
    """How a closed form was checked against the numeric route."""

    draws: int
    worst_relative_difference: float
    route: str  # what the second route did


def of_all(parts: Sequence[Evidence | None]) -> Evidence | None:
    """What is true of all parts from which an answer is calculated."""
    known = [part for part in parts if part is not None]
    if not known or len(known) < len(parts):
        return None
    worst = max(part.worst_relative_difference for part in known)
    return Evidence(min(part.draws for part in known), worst, known[0].route)


@dataclass(frozen=True)
class AnswerCase:
    """One case of an answer that depends on where the parameters are."""

    expression: Expr | tuple[Expr, ...]
    conditions: tuple[str, ...]
    what: str = ""  # what the system does then

    def to_plain(self) -> dict[str, Any]:
        parts = self.expression if isinstance(self.expression, tuple) else None
        shown: Any = [to_python(e) for e in parts] if parts is not None else to_python(self.expression)  # pyrefly: ignore[bad-argument-type]
        return {"expression": shown, "conditions": list(map(stated_plain, self.conditions)), "what": self.what}


@dataclass(frozen=True)
class Answer(Result):
    """An answer in closed form, or the reason why there is none.

    `expression` is None (no closed form), an expression, or a pair for a vector; `value` the same in numbers at
    the model's parameter values and start state, in SI; `conditions` say where the answer holds; `chain`
    has a long answer in short steps, each with a name.
    """

    id: str
    question: str
    expression: Expr | tuple[Expr, ...] | None
    unit: str
    value: Value
    conditions: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    reason: str = ""
    choice: str | None = None
    options: dict[str, Verdict] = field(default_factory=dict[str, Verdict])
    author_notes: tuple[str, ...] = ()
    form: tuple[Expr, ...] = ()  # the same as the right option writes it, part by part; nothing: no other form
    evidence: Evidence | None = None
    symbol: str = ""
    cases: tuple[AnswerCase, ...] = ()  # all of them, where there are several
    why_no_value: str = ""  # of an answer with an expression
    missing: tuple[str, ...] = ()  # parameters left open in a file that gives numbers, without which there is no value
    never: bool = False  # it is proved that the event does not happen after the start; `reason` says why
    understood: str = ""  # the question in the words of the grammar
    in_unit: str = ""  # in which the question wants the value, beside its own
    verdict: str = ""  # yes or no with the given numbers, of a question that asks whether
    chain: Chain | None = None  # a long answer in named sub-formulas, in the order of their computation
    holds_once: bool = False  # the event is there at the start alone, and the answer is what it is there
    is_missed: bool = False  # the event does not come in the motion, as far as that is known
    solved: SolvedAnswer | None = field(default=None, repr=False, compare=False)  # what others are judged against

    @property
    def report(self) -> Report:
        """The answer as a report."""
        return summary(self.question, answer_blocks(self))

    @property
    def is_complete(self) -> bool:
        return self.expression is not None

    def _repr_latex_(self) -> str:
        """The formula, for notebooks that show no HTML."""
        return super()._repr_latex_() if self.latex is None else rf"$\displaystyle {self.latex}$"

    @property
    def value_in_unit(self) -> Value:
        """The value in the unit in which the question wants it; None where it names none."""
        if not self.in_unit or self.value is None:
            return None
        ratio = conversion(self.unit, self.in_unit)
        return tuple(x * ratio for x in self.value) if isinstance(self.value, tuple) else self.value * ratio

    @property
    def is_answered(self) -> bool:
        return self.expression is not None or self.value is not None

    @property
    def latex(self) -> str | None:
        if self.expression is None:
            return None
        if isinstance(self.expression, tuple):
            return r"\begin{pmatrix}" + r" \\ ".join(map(to_latex, self.expression)) + r"\end{pmatrix}"
        return to_latex(self.expression)

    def to_plain(self) -> dict[str, Any]:
        """The answer as plain data, in the form of the JSON document."""
        if self.expression is None:
            shown: Any = None
        elif isinstance(self.expression, tuple):
            shown = [to_python(e) for e in self.expression]
        else:
            shown = to_python(self.expression)
        return {
            "id": self.id,
            "question": self.question,
            "understood": self.understood or self.question,
            "verdict": self.verdict or None,
            "expression": shown,
            "latex": self.latex,
            **({} if self.chain is None else {"chain": self.chain.to_plain()}),
            "unit": self.unit,
            "value": list(self.value) if isinstance(self.value, tuple) else self.value,
            **self._in_unit_plain(),
            "conditions": list(map(stated_plain, self.conditions)),
            "cases": [c.to_plain() for c in self.cases],
            "notes": list(map(stated_plain, self.notes)),
            "reason": self.reason or self.why_no_value or None,
            "never": self.never,
            "choice": self.choice,
            "options": {k: {"verdict": v.verdict, "reason": v.reason} for k, v in self.options.items()},
            "author_notes": list(self.author_notes),
            "evidence": None
            if self.evidence is None
            else {
                "draws": self.evidence.draws,
                "worst_relative_difference": self.evidence.worst_relative_difference,
                "route": self.evidence.route,
            },
        }

    def _in_unit_plain(self) -> dict[str, Any]:
        value = self.value_in_unit
        return {} if value is None else {"in": {"unit": self.in_unit, "value": value}}


def made(
    question: Question,
    expression: Expr | tuple[Expr, ...] | None,
    value: Value,
    *,
    unit: str | None = None,
    conditions: Sequence[str] = (),
    notes: Sequence[str] = (),
    reason: str = "",
    judgement: Judgement | None = None,
    evidence: Evidence | None = None,
    cases: tuple[AnswerCase, ...] = (),
    why_no_value: str = "",
    verdict: str = "",
    chain: Chain | None = None,
) -> Answer:
    """The answer to a question. unit: where it is not that of what is asked."""
    return Answer(
        question.id,
        question.text,
        expression,
        question.quantity.unit if unit is None else unit,
        value,
        tuple(conditions),
        (*notes, *question.quantity.remarks),
        reason,
        choice=None if judgement is None else judgement.choice,
        options={} if judgement is None else judgement.options,
        author_notes=() if judgement is None else judgement.notes,
        form=() if judgement is None else _other_form(judgement.form, expression),
        solved=None if judgement is None else judgement.against,
        evidence=evidence,
        cases=cases,
        why_no_value=why_no_value,
        verdict=verdict,
        understood=question.understood,
        in_unit=question.in_unit,
        chain=chain,
    )


def _other_form(form: tuple[Expr, ...], expression: Expr | tuple[Expr, ...] | None) -> tuple[Expr, ...]:
    """What an option writes, if it differs from the answer by more than the order of factors and terms."""
    own = expression if isinstance(expression, tuple) else () if expression is None else (expression,)
    is_alike = len(form) == len(own) and all(in_one_order(a) == in_one_order(b) for a, b in zip(form, own, strict=True))
    return () if is_alike or not own else form


def refused(
    question: Question, reason: str, value: Value = None, *, never: bool = False, is_missed: bool = False
) -> Answer:
    """Why there is no closed form, with the number of the numeric route where there is one. never: it is proved that
    the event does not happen; is_missed: it does not, as far as that is known."""
    return Answer(
        question.id,
        question.text,
        None,
        question.quantity.unit,
        value,
        reason=reason,
        never=never,
        understood=question.understood,
        in_unit=question.in_unit,
        is_missed=is_missed or never,
    )
