"""What a rod transmits as a function of the section: one cut in each part of the rod, between places at which something
acts.

Principle: how far the section is from the start of the rod is a parameter, so that the derivation of a section is that
of all in its part.
"""

from __future__ import annotations

from dataclasses import replace

from freebody.errors import CannotAnswer
from freebody.language.expression import Symbol
from freebody.language.sentences import Message, Sentence
from freebody.narrative.context import Context, Method
from freebody.narrative.kinds import derivation_of
from freebody.narrative.lines.script import DerivationStage
from freebody.narrative.sharing import lines_of
from freebody.questions.along_rods import SectionsOfRod
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer
from freebody.study.answering.functions_along_rods import at_section, parts_of
from freebody.study.answering.solve import solve


def derive(context: Context, question: Question, answer: Answer, method: Method) -> list[DerivationStage]:
    """The derivation for each part in turn. Raises CannotAnswer where there is none."""
    q = question.quantity
    assert isinstance(q, SectionsOfRod)
    if answer.expression is None:
        raise CannotAnswer(answer.reason or Message("there is no closed form"))
    stages: list[DerivationStage] = []
    for part in parts_of(context.system, q):
        made, there = at_section(context.system, question, q, part, q.name)
        made = replace(made, questions=(there,))
        here = Context(made, introduced=context.introduced | {q.name})
        here.next_number = max((line.number for line in lines_of(stages)), default=context.next_number - 1) + 1
        context.at_places.setdefault(question.id, here)
        (given,) = solve(made, setup=here.setup).answers
        if given.expression is None:
            raise CannotAnswer(given.reason or Message("there is no closed form"))
        where = {"name": Symbol(q.name), "rod": q.body, "begin": part.begin, "end": part.end}
        *before, cut = derivation_of(made, there)(here, there, given, method)
        stages += [*before, replace(cut, items=(Sentence("course.at_any_section", where), *cut.items))]
    return stages
