"""A quantity as a function of the place or of the time: derived for one place of the motion, which may be any.

Principle: the place is a parameter q1, so that the derivation of an event q = q1 is this one's as well, by a law that
is integrated, by energy, or phase by phase; as q1 may be any place that the motion comes to, it is q again in the last
line. The same goes for an instant t = t_a, unless a line says what is asked at every time.
"""

from __future__ import annotations

from collections.abc import Sequence
from collections.abc import Set as AbstractSet
from contextlib import suppress
from dataclasses import replace

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, Symbol, free_symbols
from freebody.language.sentences import Argument, Message
from freebody.narrative.contact.settings import has_phases
from freebody.narrative.context import Context, Method
from freebody.narrative.kinds import derivation_of
from freebody.narrative.lines.script import DerivationStage, NumberedFormula, Script
from freebody.narrative.sharing import lines_of, result_line
from freebody.present.report.blocks import Derivative, Difference, Side
from freebody.questions.event import AnyInstant, Anywhere
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer
from freebody.study.answering.functions import at_place
from freebody.study.answering.solve import solve

_WHAT = ("any_place", "any_instant")


def derive(context: Context, question: Question, answer: Answer, method: Method) -> list[DerivationStage]:
    """The derivation at a place with a name of its own, then for any place. Raises CannotAnswer where there is none."""
    event = question.event
    assert isinstance(event, Anywhere)
    if answer.expression is None:
        raise CannotAnswer(answer.reason or Message("there is no closed form"))
    alone, place = at_its_place(context, question), _name_of(context, event)
    made, there = alone.system, alone.system.questions[0]
    (given,) = solve(made, setup=alone.setup).answers
    if given.expression is None:
        raise CannotAnswer(given.reason or Message("there is no closed form"))
    opened = alone.script()
    what = _WHAT[isinstance(event, AnyInstant)]
    with opened.stage(f"stage.{what}", f"hint.{what}"):
        opened.say(f"course.at_{what}", name=Symbol(event.name), place=place)
    stages = derivation_of(made, there)(alone, there, given, method)
    last = result_line(stages)
    if last is None:
        raise CannotAnswer(Message("there is no closed form"))
    if isinstance(event, AnyInstant) and not has_phases(context.system):
        by_law = _by_its_law(stages, last.sides[0], event.name, {*context.system.parameters, event.name, "pi"})
        if by_law is not None:
            return by_law
    stages = [*opened.stages, *stages]
    ends = _named_again(alone, stages, last, answer.expression, Symbol(event.name), place)
    if ends and stages[-1].title == ends[0].title:  # it goes on
        stages[-1:] = [replace(stages[-1], items=stages[-1].items + ends[0].items)]
        return stages
    return [*stages, *ends]


def _by_its_law(
    stages: Sequence[DerivationStage], asked: Side, time: str, known: AbstractSet[str]
) -> list[DerivationStage] | None:
    """The derivation as far as the line that says what is asked at every time, in what is known; None without one."""
    for k, stage in enumerate(stages):
        for i, item in enumerate(stage.items):
            law = item.sides[-1] if isinstance(item, NumberedFormula) and item.sides[0] == asked else None
            if law is None or isinstance(law, tuple | Difference | Derivative):
                continue
            if time in (names := free_symbols(law)) and names <= known:
                return [*stages[:k], replace(stage, items=stage.items[: i + 1])]
    return None


def _name_of(context: Context, event: Anywhere) -> Symbol:
    if isinstance(event, AnyInstant):  # t_1 is how long the first phase lasts, and t1 looks the same
        return context.symbol("t_a", "t_any")
    has_index = event.name[-1].isdigit() or "_" in event.name
    return context.symbol(*([] if has_index else [f"{event.name}1"]), f"{event.name}_1", f"{event.name}_there")


def at_its_place(context: Context, question: Question) -> Context:
    """The context of the system with the place as a parameter, whose only question is about this place; that of any
    other question is its own."""
    event = question.event
    if not isinstance(event, Anywhere):
        return context.at_places.get(question.id, context)  # as one of a section of a rod
    if question.id not in context.at_places:
        place = _name_of(context, event)
        made, there = at_place(context.system, question, event, place.name)
        made = replace(made, questions=(there,))
        context.at_places[question.id] = Context(made, introduced=context.introduced | {place.name})
    found = context.at_places[question.id]
    found.next_number = context.next_number
    return found


def _named_again(
    context: Context,
    stages: Sequence[DerivationStage],
    last: NumberedFormula,
    value: Expr | tuple[Expr, ...],
    name: Symbol,
    place: Symbol,
) -> list[DerivationStage]:
    """The result with the measure itself in it; nothing where its formula is no line, as of a phase."""
    first = max(line.number for line in lines_of(stages)) + 1
    script = Script(context.glossary, first)
    args: dict[str, Argument] = {"line": last.number, "name": name, "place": place}
    with suppress(CannotAnswer), script.stage("stage.value"):
        script.line(last.sides[0], value, why="course.any_place", args=args, uses=(last.number,), when="event")
    return script.stages
