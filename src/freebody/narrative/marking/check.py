"""An answer that somebody typed to a question of a system: what it is worth, and why."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import cached_property, lru_cache
from pathlib import Path
from typing import Literal

from freebody.assess.numbers import Tolerance
from freebody.assess.solved import SolvedAnswer
from freebody.assess.typed import AnswerJudge, TypedJudgement
from freebody.assess.verdict import Verdict
from freebody.assess.wanted import Form, Policy, Wanted
from freebody.errors import FreebodyError, InputError, UnitError
from freebody.language.document.file import text_of
from freebody.language.expression import ZERO, Expr
from freebody.language.notation import to_python
from freebody.language.plain_text import plain, shortened
from freebody.language.sentences import Message, Sentence, listed
from freebody.language.typed import TypedNumber
from freebody.language.units import dimension_of
from freebody.model.noting import did_you_mean
from freebody.narrative.context import Context
from freebody.narrative.marking.equations import equations_of
from freebody.narrative.marking.found import CheckedAnswer
from freebody.narrative.marking.free_bodies import asked_bodies, judge_free_bodies
from freebody.narrative.marking.working import CheckedWorking, check_working
from freebody.narrative.mistakes.mistakes import KnownMistakes
from freebody.narrative.mistakes.wrong_options import FAILURES
from freebody.narrative.telling.catalogue import Catalogue
from freebody.questions.base import Quantity
from freebody.questions.freedom import DegreesOfFreedom
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer
from freebody.study.answering.solve import solve
from freebody.study.conservation.judge import Judge
from freebody.study.mobility.mobility import judged as judged_by_count
from freebody.study.setup import Setup
from freebody.study.worded import in_words
from freebody.system.system import System

EQUATIONS = ("equations of motion", "equations", "eom")  # asked for instead of a question
FORMS: tuple[Form, ...] = ("any", "formula", "number")
_OF_OPTION = re.compile(r"\((\w+)\)|(\w+)[.)]?")  # (b), b or b)
_LONGEST = 100_000  # characters that are looked at at all


@in_words
def check(
    system: System,
    question: str | None = None,
    answer: str | None = None,
    *,
    working: str | Path | None = None,
    free_body: str | None = None,
    form: str = "any",
    unit: str = "optional",
    tolerance: str = "1 %",
    gravity: Sequence[float] = (),
    language: str = "en",
) -> CheckedAnswer | CheckedWorking:
    """Judges a typed answer to a question: its id in the file, or one in words. The system is solved once; each further
    answer to the same question is compared with what was found.

    working: a file with a solution, one line a step, instead of both.
    free_body: a body, or several cut free together; the answer is the set of forces and moments that act on it, as for
    the question "free body of BODY".
    Instead of a question "equations of motion": the answer is a set of equations, which must hold on every motion.
    form: any, formula or number; unit: optional or required; tolerance: '1 %', '0.05 N' or '3 digits'; gravity: further
    values of g that are accepted [m/s^2]. Raises InputError for a question that cannot be read and for a policy that is
    none; an answer that cannot be read has the verdict `unreadable`."""
    Catalogue(language)
    if working is not None:
        return check_working(system, text_of(Path(working)), language=language)
    if free_body is not None:
        question = f"free body of {free_body}"
    if question is None or answer is None:
        raise InputError(
            Message(
                "to judge an answer give --question or --free-body, and --answer; or --working. What is wrong in a "
                "model is told by every other command, as freebody mobility MODEL"
            )
        )
    policy = _policy(form, unit, tolerance, gravity)
    if question.strip().lower() in EQUATIONS:
        found = equations_of(system).judge(answer[:_LONGEST])
        asked = Question("equations", Message("the equations of motion"), DegreesOfFreedom())
        return CheckedAnswer(asked, shortened(plain(answer), 300), found, language, title=system.title)
    if (bodies := asked_bodies(question)) is not None:
        found = judge_free_bodies(system, bodies, answer[:_LONGEST])
        told = Message("the free-body diagram of {bodies}", bodies=listed(bodies))
        asked = Question("free body", told, DegreesOfFreedom())
        return CheckedAnswer(asked, shortened(plain(answer), 300), found, language, title=system.title)
    marked = marked_question(system, question)
    text = plain(answer)
    letter, is_sure = marked.letter_of(text)
    judgement = TypedJudgement("unreadable") if is_sure else marked.judge(answer[:_LONGEST], policy)
    chosen = ("", "")
    if letter and judgement.verdict == "unreadable":
        chosen = (letter, marked.options[letter])
        judgement, said = marked.chosen(letter)
    else:
        said = marked.mistake(judgement)
    leads = "" if said is None else Catalogue(language).plain(said)
    shown = shortened(text, 300)
    return CheckedAnswer(marked.question, shown, judgement, language, leads, system.title, chosen=chosen)


def _policy(form: str, unit: str, tolerance: str, gravity: Sequence[float]) -> Policy:
    if unit not in ("optional", "required"):
        raise InputError(Message("unit is optional or required, not {unit}", unit=unit))
    for known in FORMS:
        if form == known:
            return Policy(known, unit == "required", Tolerance.read(tolerance), tuple(gravity))
    raise InputError(Message("there is no form {form}.{hint}", form=form, hint=did_you_mean(form, FORMS)))


@dataclass(frozen=True)
class MarkedQuestion:
    """A solved question that answers are compared with. judging: None where there is no formula; options: among which
    one may choose by the letter."""

    system: System
    question: Question
    answer: Answer
    judging: AnswerJudge | None
    options: Mapping[str, str] = field(default_factory=dict[str, str])

    def letter_of(self, text: str) -> tuple[str, bool]:
        """The letter of the option that is chosen by (b) or b, and whether nothing else can be meant: b alone is also
        the quantity of that name, where the problem has one. Nothing for any other answer."""
        found = _OF_OPTION.fullmatch(text.strip())
        if found is None:
            return "", False
        in_brackets, alone = found.groups()
        letters = {letter.lower(): letter for letter in self.options}
        letter = letters.get((in_brackets or alone).lower(), "")
        return letter, bool(letter) and alone not in {*self.system.parameters, *self.system.measures}

    def chosen(self, letter: str) -> tuple[TypedJudgement, Sentence | None]:
        """The verdict on an option, and the mistake that leads to it where one is known."""
        found = self._verdicts.get(letter)
        if found is None:
            return TypedJudgement("undecided", Message("there is nothing to compare it with")), None
        verdict = "correct" if found.verdict == "right" else "incorrect"
        return TypedJudgement(verdict, found.reason), self._behind_options.get(letter)

    @property
    def right_option(self) -> str:
        """Its letter; nothing where there is none, or several are."""
        right = [letter for letter, v in self._verdicts.items() if v.verdict == "right"] if self.options else []
        return right[0] if len(right) == 1 else ""

    @cached_property
    def _verdicts(self) -> Mapping[str, Verdict]:
        return self._options_judged(replace(self.question, options=dict(self.options)))

    @cached_property
    def _behind_options(self) -> Mapping[str, Sentence]:
        wrong = {k: self.options[k] for k, v in self._verdicts.items() if v.verdict == "wrong"}
        return {} if self.answer.expression is None or not wrong else self._known.behind(wrong)

    def judge(self, text: str, policy: Policy) -> TypedJudgement:
        if self.judging is not None:
            return self.judging.with_policy(policy).judge(text)
        return self._as_option(text)

    def mistake(self, judgement: TypedJudgement) -> Sentence | None:
        """The mistake that leads to what is not right, where one is known."""
        if judgement.verdict not in ("incorrect", "correct_only_if") or judgement.mistake or judgement.answer is None:
            return None
        parts = judgement.answer.parts
        with suppress(FreebodyError, *FAILURES):
            if judgement.answer.is_number:
                if any(isinstance(p, TypedNumber) and self._has_other_unit(p) for p in parts):
                    return None  # a number that is near the result of a mistake in another unit says nothing
                return self._known.behind_numbers([p.value for p in parts if isinstance(p, TypedNumber)])
            text = ", ".join(map(to_python, judgement.exprs))
            return self._known.behind({"a": f"[{text}]" if len(parts) > 1 else text}).get("a")
        return None

    def _has_other_unit(self, given: TypedNumber) -> bool:
        assert self.judging is not None
        return given.has_unit and given.dimension != self.judging.solved.dimension

    @cached_property
    def _known(self) -> KnownMistakes:
        return KnownMistakes(Context(self.system), self.question, self.answer)

    def with_options(self, question: Question) -> Answer:
        """The answer to the question as it stands in the file, with the verdicts on its options."""
        return solve(replace(self.system, questions=(question,))).answers[0]

    def _options_judged(self, asked: Question) -> Mapping[str, Verdict]:
        """The options of the question, by the study that answers it."""
        match asked.quantity.scope:
            case "structure" if isinstance(self.answer.value, float):
                return judged_by_count(self.system, asked, int(self.answer.value)).options
            case "every motion":
                return self._conservation.answer(asked).options
            case _:
                return solve(replace(self.system, questions=(asked,))).answers[0].options

    @cached_property
    def _conservation(self) -> Judge:
        return Judge(Setup(self.system))

    def _as_option(self, text: str) -> TypedJudgement:
        """Of what is no formula (a count, a condition) the answer is judged as an option would be."""
        if not self.answer.is_answered and not self.answer.conditions:
            return TypedJudgement("undecided", self.answer.reason)
        asked = replace(self.question, options={"a": text}, key=None)
        found = self._options_judged(asked).get("a")
        if found is None:
            return TypedJudgement("undecided", Message("there is nothing to compare it with"))
        verdict = {"right": "correct", "wrong": "incorrect", "unreadable": "unreadable"}[found.verdict]
        return TypedJudgement(verdict, found.reason)  # pyrefly: ignore[bad-argument-type]


@lru_cache(maxsize=64)
def marked_question(system: System, question: str) -> MarkedQuestion:
    """A question of a system with its answer, solved once."""
    known = {q.id: q for q in system.questions}
    if question.isidentifier() and question not in known:
        told = Message(
            "there is no question with the id {question}.{hint}", question=question, hint=did_you_mean(question, known)
        )
        raise InputError(told)
    as_set = known.get(question) or system.question(question)
    asked = replace(as_set, options={}, key=None)
    marked = marked_by(system, asked, solve(replace(system, questions=(asked,))).answers[0])
    return replace(marked, options=as_set.options)


def marked_by(system: System, question: Question, answer: Answer) -> MarkedQuestion:
    """A question with an answer that has been found already."""
    return MarkedQuestion(system, question, answer, _judge_of(question, answer))


def _bound(question: Question) -> Literal["<", ">", ""]:
    """Above a least value, below a largest one."""
    match (question.understood or question.text).split(maxsplit=1)[0]:
        case "least":
            return ">"
        case "largest":
            return "<"
        case _:
            return ""


def _is_of_values(q: Quantity) -> bool:
    """Whether values of a parameter are asked for, of which there may be several."""
    return q.wanted is not None and q.wanted.relation == "="


def _judge_of(question: Question, answer: Answer) -> AnswerJudge | None:
    """None for a count, and for what has no formula."""
    if answer.solved is None or answer.solved.element is None or answer.expression is None:
        return None
    if question.quantity.scope == "structure":
        return None
    value = answer.value if isinstance(answer.value, tuple) else None if answer.value is None else (answer.value,)
    cases = tuple(
        (c.expression if isinstance(c.expression, tuple) else (c.expression,), c.conditions) for c in answer.cases
    )
    q = question.quantity
    parts = answer.expression if isinstance(answer.expression, tuple) else (answer.expression,)
    wanted = Wanted(
        value,
        answer.conditions,
        cases,
        is_signed=q.sign_is_conventional,
        measure=q.counted_along,
        hides_units=_hides_units(answer.solved, parts),
        bound=_bound(question),
        has_order=not (q.is_any_of_several or q.scope == "small motion" or _is_of_values(q)),
    )
    return AnswerJudge(answer.solved, wanted)


def _hides_units(solved: SolvedAnswer, parts: Sequence[Expr]) -> bool:
    """Whether the formula of the answer has another unit than the answer: numbers of the model, as 20 rad/s, stand in
    it without theirs."""
    known = solved.setting().names.dimensions
    try:
        return any(part != ZERO and dimension_of(part, known) != solved.dimension for part in parts)
    except UnitError:
        return True
