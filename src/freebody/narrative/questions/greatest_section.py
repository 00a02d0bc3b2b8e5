"""Where a rod is loaded most: the section that governs is cut, and what is transmitted there is derived."""

from __future__ import annotations

from dataclasses import replace

from freebody.errors import CannotAnswer, SaysNothing
from freebody.language.sentences import Message
from freebody.narrative.context import Context, Method
from freebody.narrative.kinds import derivation_of
from freebody.narrative.lines.glossary import World
from freebody.narrative.lines.naming import asked_as
from freebody.narrative.lines.script import DerivationStage
from freebody.questions.greatest_section import GreatestInRod
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer
from freebody.study.answering.crosscheck import holds
from freebody.study.answering.greatest_section import governing
from freebody.study.answering.solve import solve


def derive(context: Context, question: Question, answer: Answer, method: Method) -> list[DerivationStage]:
    """The derivation. Raises CannotAnswer where the solver has no formula, or where the section has none."""
    if answer.expression is None:
        raise CannotAnswer(answer.reason or Message("there is no closed form"))
    setup, q = context.setup, question.quantity
    assert isinstance(q, GreatestInRod)
    state = setup.start_for(q) if question.at_start else setup.state
    if q.asks == "zero":
        raise CannotAnswer(Message("ask for what is zero there, at a distance from the start of the rod"))
    if q.asks == "place":
        raise CannotAnswer(Message("ask how great it is there; the place is told with that"))
    cut, conditions = governing(setup, question, q, state)

    def read(world: World) -> float:
        if not all(holds(setup, c, world.draw, world.snapshot) for c in conditions):
            raise SaysNothing(Message("it is greatest elsewhere there"))
        return q.value(setup.system, world.snapshot)

    asked_as(context, question, read)
    asked = replace(question, quantity=cut, options={}, key=None)
    (given,) = solve(replace(context.system, questions=(asked,)), setup=setup).answers
    return derivation_of(context.system, asked)(context, asked, given, method)
