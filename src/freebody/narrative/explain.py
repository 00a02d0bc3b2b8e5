"""The worked solution of every question of a system."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from freebody.errors import CannotAnswer, ExpressionError, InputError, RoutesDisagree
from freebody.language.expression import Call, Number, Symbol
from freebody.language.sentences import Argument, Message, Sentence
from freebody.model.noting import did_you_mean
from freebody.narrative.closing import closing
from freebody.narrative.contact.settings import changes_at_borders_alone, has_phases
from freebody.narrative.context import METHODS, Context, Derive, Method
from freebody.narrative.derivation import Derivation, WorkedSolutions
from freebody.narrative.first_turn import at_first_turn
from freebody.narrative.kinds import derivation_of
from freebody.narrative.lines.script import DerivationStage, Item, Listing, NumberedFormula, ready
from freebody.narrative.numbering import numbered
from freebody.narrative.opening import opening
from freebody.narrative.sharing import ToldSoFar, lines_of, result_line, sentences_of, without_echo
from freebody.narrative.telling.catalogue import Catalogue
from freebody.narrative.telling.composing import plain_derivations, report_of
from freebody.present.report.result import Result
from freebody.progress import busy_with
from freebody.questions.event import Anywhere, OfQuantity
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer
from freebody.study.answering.asked_of import asked_of
from freebody.study.answering.nothing_moves import of_what_stays
from freebody.study.answering.places_of_quantities import placed
from freebody.study.answering.solution import Solution
from freebody.study.answering.solve import solve
from freebody.study.friction.answers import of_motion
from freebody.study.given import each
from freebody.study.steady.open_balls import with_open_balls
from freebody.study.worded import in_words
from freebody.symbolic.uniform_passage import is_of_roots
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
    question: str | Sequence[str] | None = None,
    *,
    method: str = "auto",
    compare: str | None = None,
    language: str = "en",
) -> Explanation:
    """Derives the answers to the questions of a system, or to those given: ids of questions of the file, or in words.

    method: "auto", "newton", "lagrange" or "energy"; compare: a second method, shown beside the first. Raises
    ModelError for a question that cannot be read, InputError for an unknown method or language. A question without a
    derivation has a Derivation that says why."""
    Catalogue(language)  # refuses one that there is not, before any work
    chosen = _method(method)
    second = None if compare is None else _method(compare)
    known = {q.id: q for q in system.questions}
    system, asked = (system, system.questions) if question is None else _asked(system, known, each(question))
    asked = tuple(placed(system, asked, solve)[0])
    system = system if asked == system.questions else replace(system, questions=asked)
    system = with_open_balls(system, asked)
    context = Context(system)
    # the setup of a motion in phases is that of its first one, with too few draws to check an answer
    shared = None if has_phases(system) else context.setup
    return _explained(context, solve(system, setup=shared), chosen, second, language)


@in_words
def explain_solved(system: System, solution: Solution, k: int, *, language: str = "en") -> Explanation:
    """Derives one of the answers that have been found already, that to question k, without finding it again."""
    question = system.questions[k]
    if isinstance(question.event, OfQuantity):  # solved as another question, at the place of the event
        return explain(system, question.id, language=language)
    alone = with_open_balls(replace(system, questions=(question,)), (question,))
    found = replace(solution, system=alone, answers=(solution.answers[k],))
    return _explained(Context(alone), found, "auto", None, language)


def _asked(system: System, known: Mapping[str, Question], texts: Sequence[str]) -> tuple[System, tuple[Question, ...]]:
    """Questions of the file by their ids, and others in words, in the order in which they are asked; and the system
    with the values that they state."""
    for text in texts:
        if text.isidentifier() and text not in known:
            told = Message(
                "there is no question with the id {question}.{hint}", question=text, hint=did_you_mean(text, known)
            )
            raise InputError(told)
    if all(text in known for text in texts):
        return system, tuple(known[text] for text in texts)
    return asked_of(system, *(known[text].text if text in known else text for text in texts))


def _explained(
    context: Context, solution: Solution, chosen: Method, second: Method | None, language: str
) -> Explanation:
    system, asked = context.system, context.system.questions
    first = tuple(opening(context))
    told = ToldSoFar.of(first)
    answers = {a.id: a for a in solution.answers}  # a text may be asked twice, with options of its own
    found = [_derived(context, told, q, answers.get(q.id), chosen, second) for q in asked]
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
    context: Context, told: ToldSoFar, question: Question, answer: Answer | None, method: Method, second: Method | None
) -> Derivation:
    """The derivation of one question, without what has been told before."""
    assert answer is not None
    busy_with(f"deriving {question.id}: {question.text}")
    if answer.holds_once:
        question = replace(question, event=None, at_start=True)
    if isinstance(question.event, Anywhere) and answer.value is not None:  # the formula is the same at every instant
        question = replace(question, event=None)
    told_of, question = question, _at_its_turn(context, of_motion(context.system, question))
    question = of_what_stays(context.setup, question)
    derive = derivation_of(context.system, question)
    here = context.of_question(question) if answer.is_answered else context
    here.own = None
    stages, reason = _attempt(here, question, answer, method, derive)
    if reason and method == "auto" and _has_redundant_constraints(here):  # no equation may have their reactions in it
        stages, trouble = _attempt(here, question, answer, "lagrange", derive)
        reason = reason if trouble else ""
    if reason and (turned := at_first_turn(context.system, question, answer)) is not None:
        question, derive = turned, derivation_of(context.system, turned)
        here = context.of_question(question)
        here.own = None
        stages, trouble = _attempt(here, question, answer, method, derive)
        reason = reason if trouble else ""
    compared: Sequence[DerivationStage] = ()
    if second is not None and not reason:
        with here.as_if_alone():
            compared, trouble = _attempt(here, question, answer, second, derive)
        compared, reason = ToldSoFar.of(told.opening).shared(compared)[0], trouble
    ends: Sequence[DerivationStage] = ()
    if answer.is_answered and not reason:
        ends, reason = _attempt(here, question, answer, method, _closing)
    context.next_number = here.next_number
    new, again = told.shared(stages)
    result = result_line(stages)
    if stages and stages[-1].title.key == "stage.numeric":  # nothing was found in its equations, told before or not
        new = [*(stage for stage in new if stage.title != stages[-1].title), stages[-1]]
    elif result is not None and result.number in again:
        found = Sentence("result.found", {"line": again[result.number]})
        title = Sentence("stage.value")
        if new and new[-1].title == title:
            new[-1] = replace(new[-1], items=(*new[-1].items, found))
        else:
            new.append(DerivationStage(title, None, (found,)))
    new, again = without_echo(new, again)
    at = question.event or question.transition
    event = "" if at is None else repr(at)
    if all(line.sides[0] != Symbol("t") for line in lines_of(stages)):  # without the time its roots mean nothing
        unsaid = tuple(ready(note) for note in answer.notes if is_of_roots(note))
    else:
        unsaid = ()
    new = _with_result(new, ends, told, event, unsaid)
    told.take(new)
    told.take_notes(new, event)
    here.keep_found(again, told.numbers)
    return Derivation(told_of, answer, tuple(new), method, reason, tuple(compared), second or "auto")


def _at_its_turn(context: Context, question: Question) -> Question:
    """How far a motion gets past the borders of its loads is what it is where it first turns."""
    turn = question.quantity.turn
    if turn is None or not changes_at_borders_alone(context.system):
        return question
    of, event, _side = turn
    return replace(question, quantity=of, event=event)


def _with_result(
    new: list[DerivationStage],
    ends: Sequence[DerivationStage],
    told: ToldSoFar,
    event: str,
    unsaid: Sequence[Argument] = (),
) -> list[DerivationStage]:
    """A derivation with its end. A result that stands in the last line is not written again, and what an earlier
    derivation has found is named beside it; notes that were made on the way, or of the same event, are not repeated.
    unsaid: notes that are of nothing in it."""
    if not ends:
        return new
    noted = [s.args.get("text") for s in (*told.sentences, *sentences_of(new)) if s.key == "course.note"]
    noted += [*(told.notes.get(event, ()) if event else ()), *unsaid]
    first, *others = [_without_notes(stage, noted) for stage in ends]
    found = [s for s in sentences_of(new) if s.key == "result.found"]
    if found and len(new) == 1:
        return [replace(first, items=(found[0], *first.items)), *others]
    line, result = result_line(new), next(iter(lines_of([first])), None)
    if line is None or result is None or not _says(line, result):
        return [*new, first, *others]
    other = result.sides[2:]  # as the options write it
    sides, relations = (*line.sides, *other), (*line.relations, *result.relations[1:])
    last = replace(line, is_result=True, sides=sides, relations=relations)
    marked = [replace(s, items=tuple(last if item is line else item for item in s.items)) for s in new]
    checks = tuple(item for item in first.items if item is not result)
    title = Sentence("stage.checks")
    return [*marked, *([replace(first, title=title, items=checks)] if checks else []), *others]


def _says(line: NumberedFormula, result: NumberedFormula) -> bool:
    """Whether a line ends in the result, under its name or that of a coordinate or rate whose value is asked for."""
    name, value = line.sides[0], line.sides[-1]
    if result.sides[1:2] != (value,):  # a coordinate that is asked for has nothing that it equals
        return False
    is_rate = isinstance(name, Call) and name.function == "rate"
    is_there = line.when == result.when == "event" and not isinstance(value, Number)
    return name == result.sides[0] or (is_there and (is_rate or isinstance(name, Symbol)))


def _without_notes(stage: DerivationStage, noted: Sequence[object]) -> DerivationStage:
    items: list[Item] = []
    for item in stage.items:
        if isinstance(item, Listing):
            new = tuple(s for s in item.items if s.key != "result.note" or s.args.get("text") not in noted)
            items += [Listing(new)] if new else []
        else:
            items.append(item)
    return replace(stage, items=tuple(items))


def _closing(context: Context, question: Question, answer: Answer, method: Method) -> list[DerivationStage]:
    return closing(context, question, answer)


def _has_redundant_constraints(context: Context) -> bool:
    """Whether reactions are not unique, so that a line with them in it cannot be checked."""
    with suppress(CannotAnswer):
        return bool(context.setup.model.redundant)
    return False


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
