"""When a loop of four links closes at all."""

from __future__ import annotations

import math

from freebody.language.notation import joined, reworded
from freebody.language.sentences import Message, in_turn
from freebody.questions.linkages import Assembly
from freebody.questions.reading import Question
from freebody.study.answering.crosscheck import INSTANT_TOLERANCE, CrossCheck, element_at
from freebody.study.answering.draws import Draw
from freebody.study.answering.finding import Finding
from freebody.study.mobility.dead_points import place
from freebody.study.mobility.four_links import FourLinks
from freebody.study.mobility.grashof import FourBarNumbers, dimensions
from freebody.study.mobility.linkages import FourBar
from freebody.study.mobility.loop_questions import answered, four_links, loop_draws, refuse_pose
from freebody.study.setup import Setup
from freebody.symbolic.conditions import Condition, merged
from freebody.symbolic.decide import decide


@answered.register(Assembly)
def _assembly(q: Assembly, setup: Setup, question: Question) -> Finding:
    refuse_pose(question)
    links = four_links(setup)
    needs, told = links.assembles()
    if all(decide(x, ">=") is True for x in needs):
        told = ""
    route = Message("lengths of the full system as it is assembled in numbers")
    check = CrossCheck(question.text, route, INSTANT_TOLERANCE)

    def compare(draw: Draw) -> None:
        exact = tuple(element_at(setup, x, draw, draw.start())[0] for x in needs)
        check.compare(draw, exact, _room(links, draw))

    evidence = check.gather(loop_draws(setup), compare).evidence()
    notes: list[str] = []
    if isinstance(links.loop, FourBar):
        notes.append(Message("no side of the polygon is longer than all others together"))
    closing = merged([Condition(c.element, c.relation) for c in setup.closing(setup.state)])
    if closing and setup.model.coordinates:
        told_there = joined(closing)
        notes.append(
            reworded(
                Message(
                    "in the pose of {names}: {condition}",
                    names=in_turn([c.name for c in setup.model.coordinates]),
                    condition=told_there,
                ),
                told_there,
            )
        )
    says = (
        reworded(Message("the loop can be assembled if {condition}", condition=told), told)
        if told
        else Message("the loop can be assembled with all lengths")
    )
    element = needs[0] if len(needs) == 1 else needs
    return Finding(element, evidence, says=[says], notes=notes, is_complete=True)


def _room(links: FourLinks, draw: Draw) -> tuple[float, ...]:
    """By how much the polygon closes, from distances of joints."""
    loop = links.loop
    at = [place(draw, joint) for joint in loop.joints]
    if isinstance(loop, FourBar):
        A, B, C, D = at
        sides = [math.dist(D, A), math.dist(A, B), math.dist(B, C), math.dist(C, D)]
        return tuple(sum(sides) - 2 * x for x in sides)
    numbers = dimensions(loop, draw.reference, draw.q)
    assert not isinstance(numbers, FourBarNumbers)
    bars = math.dist(at[0], at[1]) + math.dist(at[1], at[2])
    n = len(links.assembles()[0])
    return tuple(bars - side for side in (numbers.offset, -numbers.offset)[:n])
