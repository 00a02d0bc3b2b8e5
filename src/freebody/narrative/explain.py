"""The worked solution of every question of a system."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from freebody.errors import CannotAnswer, ExpressionError, InputError, RoutesDisagree
from freebody.language.sentences import Message
from freebody.model.noting import did_you_mean
from freebody.narrative.closing import closing
from freebody.narrative.contact.settings import has_phases
from freebody.narrative.context import METHODS, Context, Derive, Method
from freebody.narrative.derivation import Derivation, WorkedSolutions
from freebody.narrative.kinds import derivation_of
from freebody.narrative.lines.script import DerivationStage, Item, Listing, NumberedFormula, Sentence
from freebody.narrative.numbering import numbered
from freebody.narrative.opening import opening
from freebody.narrative.sharing import Told
from freebody.narrative.telling.catalogue import Catalogue
from freebody.narrative.telling.composing import plain_derivations, report_of
from freebody.present.report.results import Result
from freebody.progress import busy_with
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer
from freebody.study.answering.solve import solve
from freebody.study.worded import in_words
from freebody.system.system import System

if TYPE_CHECKING:
    from freebody.present.report.blocks import Report


class Explanation(WorkedSolutions, Result):
    """All worked solutions of a system, ready to be written in any format."""

    @property
    def report(self) -> Report:
        """The explanation as a report."""
        return self._report

    @cached_property
    def _report(self) -> Report:
        return report_of(self)

    @property
    def is_complete(self) -> bool:
        return all(not d.reason for d in self.derivations)

    def to_plain(self) -> dict[str, Any]:
        """The solution, and how each answer is found: the lines of every stage as a terminal shows them."""
        return {**self.solution.to_plain(), "language": self.language, **plain_derivations(self)}

    @property
    def _code(self) -> str:
        name = Path(self.system.file).name if self.system.file else "model.yaml"
        return f'import freebody\n\nsystem = freebody.System.load("{name}")\nsystem.solve()'


@in_words
def explain(
    system: System,
    question: str | None = None,
    *,
    method: str = "auto",
    compare: str | None = None,
    language: str = "en",
) -> Explanation:
    """Derives the answers to the questions of a system, or to one: the id of a question of the file, or one in words.

    method: "auto", "newton", "lagrange" or "energy"; compare: a second method, shown beside the first. Raises
    ModelError for a question that cannot be read, InputError for an unknown method or language. A question without a
    derivation has a Derivation that says why."""
    Catalogue(language)  # refuses one that there is not, before any work
    chosen = _method(method)
    second = None if compare is None else _method(compare)
    known = {q.id: q for q in system.questions}
    if question is not None and question.isidentifier() and question not in known:
        raise InputError(
            Message(
                "there is no question with the id {question}.{hint}",
                question=question,
                hint=did_you_mean(question, known),
            )
        )
    asked = system.questions if question is None else (known.get(question) or system.question(question),)
    system = system if question is None else replace(system, questions=asked)
    context = Context(system)
    # the setup of a motion in phases is that of its first one, with too few draws to check an answer
    shared = None if has_phases(system) else context.setup
    solution = solve(system, setup=shared)
    first = tuple(opening(context))
    told = Told.of(first)
    answers = {a.question: a for a in solution.answers}
    found = [_derived(context, told, q, answers.get(q.text), chosen, second) for q in asked]
    return Explanation(system, solution, *_numbered(first, found), language)


def _numbered(
    first: tuple[DerivationStage, ...], found: Sequence[Derivation]
) -> tuple[tuple[DerivationStage, ...], tuple[Derivation, ...]]:
    """The opening and the derivations with their final numbers."""
    parts = [first, *(part for d in found for part in (d.stages, d.compared))]
    first, *rest = numbered(parts, Catalogue())
    pairs = zip(rest[::2], rest[1::2], strict=True)
    return first, tuple(replace(d, stages=s, compared=c) for d, (s, c) in zip(found, pairs, strict=True))


def _method(name: str) -> Method:
    for method in METHODS:
        if name == method:
            return method
    raise InputError(Message("there is no method {name}.{hint}", name=name, hint=did_you_mean(name, METHODS)))


def _derived(
    context: Context, told: Told, question: Question, answer: Answer | None, method: Method, second: Method | None
) -> Derivation:
    """The derivation of one question, without what has been told before."""
    assert answer is not None
    busy_with(f"deriving {question.id}: {question.text}")
    derive = derivation_of(context.system, question)
    here = context.of_question(question) if answer.is_answered else context
    stages, reason = _attempt(here, question, answer, method, derive)
    compared: Sequence[DerivationStage] = ()
    if second is not None and not reason:
        with here.as_if_alone():
            compared, trouble = _attempt(here, question, answer, second, derive)
        compared, reason = Told.of(told.opening).shared(compared)[0], trouble
    ends: Sequence[DerivationStage] = ()
    if answer.is_answered and not reason:
        ends, reason = _attempt(here, question, answer, method, _closing)
    context.next_number = here.next_number
    new, again = told.shared(stages)
    new += _with_source(ends, stages, again, told)
    told.take(new)
    here.keep_found(again, told.numbers)
    return Derivation(question, answer, tuple(new), method, reason, tuple(compared), second or "auto")


def _with_source(
    ends: Sequence[DerivationStage], stages: Sequence[DerivationStage], again: Mapping[int, int], told: Told
) -> list[DerivationStage]:
    """The result, with the line of an earlier derivation in which it was found, and without notes that were made on
    the way."""
    lines = [item.number for stage in stages for item in stage.items if isinstance(item, NumberedFormula)]
    said = [item for stage in stages for item in stage.items if isinstance(item, Sentence)]
    noted = [s.args.get("text") for s in (*said, *told.sentences) if s.key == "course.note"]
    found = [] if not lines or lines[-1] not in again else [Sentence("result.found", {"line": again[lines[-1]]})]
    made: list[DerivationStage] = []
    for stage in ends:
        items: list[Item] = [*(found if not made else ())]
        for item in stage.items:
            if isinstance(item, Listing):
                new = tuple(s for s in item.items if s.key != "result.note" or s.args.get("text") not in noted)
                items += [Listing(new)] if new else []
            else:
                items.append(item)
        made.append(replace(stage, items=tuple(items)))
    return made


def _closing(context: Context, question: Question, answer: Answer, method: Method) -> list[DerivationStage]:
    return closing(context, question, answer)


def _attempt(
    context: Context, question: Question, answer: Answer, method: Method, derive: Derive
) -> tuple[list[DerivationStage], str]:
    try:
        with context.setup.apart():  # what one derivation takes to be positive is nothing to the next
            stages = derive(context, question, answer, method)
    except (CannotAnswer, RoutesDisagree, ExpressionError, ZeroDivisionError) as error:
        return [], str(error)
    numbers = [item.number for stage in stages for item in stage.items if isinstance(item, NumberedFormula)]
    context.next_number = max([context.next_number - 1, *numbers]) + 1
    return stages, ""
