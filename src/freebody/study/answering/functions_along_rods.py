"""What a rod transmits as a function of the section: N(x), V(x), M(x), from one place at which something acts to the
next.

How far the section is from the start of the rod is a parameter p, and what is asked is so at that section; as the
places follow one another at the given numbers p is put between each two of them in turn. In the answer p is x again.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from itertools import groupby, pairwise

from freebody.errors import CannotAnswer, InputError, ModelError
from freebody.language.expression import Expr, Symbol, add, negate
from freebody.language.notation import Stated, to_python, to_text
from freebody.language.sentences import Message
from freebody.questions.along_rods import SectionsOfRod
from freebody.questions.reading import Question
from freebody.questions.section import in_order, places_on
from freebody.study.answering.answer import Answer, AnswerCase, of_all, refused
from freebody.study.answering.functions import free_name, in_the_measure
from freebody.study.answering.section import BETWEEN_LOADS
from freebody.study.answering.solution import Solution
from freebody.study.setup import Setup
from freebody.symbolic.tidy import tidy
from freebody.system.system import System

Solver = Callable[[System], Solution]


@dataclass(frozen=True)
class Part:
    """Of a rod, between two places at which something acts: how far they are from its start, by their formulas and in
    numbers [m]."""

    begin: Expr
    end: Expr
    begins: float
    ends: float

    @property
    def middle(self) -> float:
        return (self.begins + self.ends) / 2


def along_a_rod(system: System, question: Question, solve: Solver) -> Answer:
    """The answer in cases, one for each part of the rod with a formula of its own."""
    q = question.quantity
    assert isinstance(q, SectionsOfRod)
    p = free_name(system)
    try:
        sections = [(part, *at_section(system, question, q, part, p)) for part in parts_of(system, q)]
    except (CannotAnswer, ModelError, InputError) as error:
        return refused(question, str(error))
    found: list[tuple[Part, Answer]] = []
    for part, made, at in sections:
        answer = solve(replace(made, questions=(at,))).answers[0]
        if answer.expression is None:
            return refused(question, answer.reason)
        found.append((part, in_the_measure(answer, p, q.name)))
    cases = [*_cases(found, q)]
    return replace(
        found[0][1],
        evidence=of_all([answer.evidence for _part, answer in found]),
        conditions=cases[0].conditions,
        cases=tuple(cases) if len(cases) > 1 else (),
        notes=(Message("{name} is counted from {rod}.start", name=q.name, rod=q.body), *found[0][1].notes),
    )


def _cases(found: list[tuple[Part, Answer]], q: SectionsOfRod) -> Iterator[AnswerCase]:
    """Parts beside each other in which the same holds are one."""
    for expression, group in groupby(found, key=lambda one: one[1].expression):
        parts = list(group)
        (first, answer), (last, _) = parts[0], parts[-1]
        others = [c for c in answer.conditions if str(BETWEEN_LOADS) not in c]
        within = (_stated(q.name, ">", first.begin), _stated(q.name, "<", last.end))
        assert expression is not None
        yield AnswerCase(expression, (*within, *others))


def _stated(name: str, relation: str, place: Expr) -> Stated:
    x = Symbol(name)
    shown, plain = (f"{told(x)} {relation} {told(place)}" for told in (to_text, to_python))
    return Stated(shown, plain, (x, relation, place))


def at_section(system: System, question: Question, q: SectionsOfRod, part: Part, p: str) -> tuple[System, Question]:
    """The system with a parameter p that tells a section in a part of the rod, and the question there."""
    document = system.document.with_value(("parameters", p), f"{part.middle!r} m")
    made = System.from_text(document.with_value(("questions",), []).dumps(), system.file)
    (asked,) = made.asked(q.asked_at(p))
    return made, replace(asked, id=question.id, text=question.text, understood=question.understood)


def parts_of(system: System, q: SectionsOfRod) -> list[Part]:
    """The parts of the rod, from its start on. Raises CannotAnswer where the places at which something acts are not
    known in numbers."""
    if not system.has_values:
        raise CannotAnswer(Message("in which order things act along {body} is told by numbers", body=q.body))
    setup, rod = Setup(system), system.bodies[q.body]
    draw = setup.draws[0]
    start = draw.seen(draw.start())
    order = in_order(rod, start, places_on(system, start, rod, q.part))
    f, first = setup.model.field, rod.points["start"][0]
    marks = [tidy(f.lowest_terms(f.element(setup.state.scalar(add(same[0], negate(first)))))) for same in order]
    numbers = [float(start.scalar(mark)) for mark in marks]
    return [Part(*ends, *at) for ends, at in zip(pairwise(marks), pairwise(numbers), strict=True)]
