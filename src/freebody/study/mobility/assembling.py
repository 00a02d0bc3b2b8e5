"""When a loop of four links closes at all."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction

from freebody.errors import CannotAnswer
from freebody.language.notation import joined, reworded
from freebody.language.sentences import Message, further, in_turn
from freebody.numeric.reference import Reference
from freebody.questions.linkages import Assembly
from freebody.questions.reading import Question
from freebody.study.answering.answer import Evidence
from freebody.study.answering.crosscheck import INSTANT_TOLERANCE, CrossCheck, element_at
from freebody.study.answering.draws import Draw
from freebody.study.answering.finding import Finding
from freebody.study.answering.formula import Formula
from freebody.study.mobility.dead_points import place
from freebody.study.mobility.four_links import FourLinks
from freebody.study.mobility.grashof import FourBarNumbers, dimensions
from freebody.study.mobility.linkages import FourBar
from freebody.study.mobility.loop_questions import answered, four_links, is_so, loop_draws, n_loops, refuse_pose
from freebody.study.setup import Setup
from freebody.symbolic.closure import Closure
from freebody.symbolic.conditions import Condition, merged
from freebody.symbolic.decide import decide
from freebody.symbolic.ratio import Ratio


@answered.register(Assembly)
def _assembly(q: Assembly, setup: Setup, question: Question) -> Finding:
    refuse_pose(question)
    try:
        links = four_links(setup)
    except CannotAnswer:
        return _by_solution(setup, question)
    needs, told = links.assembles()
    if all(decide(x, ">=") is True for x in needs):
        told = ""
    evidence = _compared(links, question.text, needs)
    notes: list[str] = []
    if isinstance(links.loop, FourBar):
        notes.append(Message("no side of the polygon is longer than all others together"))
    closing = merged([Condition(c.element, c.relation) for c in setup.closing_in_full(setup.state)])
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


def _compared(links: FourLinks, question: str, needs: Sequence[Ratio]) -> Evidence:
    setup = links.setup
    route = Message("lengths of the full system as it is assembled in numbers")
    check = CrossCheck(question, route, INSTANT_TOLERANCE)

    def compare(draw: Draw) -> None:
        exact = tuple(element_at(setup, x, draw, draw.start())[0] for x in needs)
        check.compare(draw, exact, _room(links, draw))

    return check.gather(loop_draws(setup), compare).evidence()


def _by_solution(setup: Setup, question: Question) -> Finding:
    """Any single loop whose solution has a value in every pose, as one with two sliders. Raises CannotAnswer where it
    has not: the poses in which it closes are not those in which it can be put together."""
    if n_loops(setup.system) != 1:
        raise CannotAnswer(Message("the mechanism is no single loop of four links with pins and sliders"))
    if closing := Closure(setup.model).closes():
        there = joined(merged([Condition(c.element, c.relation) for c in closing]))
        names = in_turn([c.name for c in setup.model.coordinates])
        told = Message("in the pose of {names}: {condition}", names=names, condition=there)
        one_loop = Message("the mechanism is no single loop of four links with pins and sliders")
        raise CannotAnswer(further(one_loop, told))
    route = Message("the full system assembled in numbers")
    check = CrossCheck(question.text, route, INSTANT_TOLERANCE)
    check.gather(loop_draws(setup), lambda draw: check.compare(draw, 1.0, _closes(setup, draw.values)))
    says = Message("the loop can be assembled with all lengths")
    return Finding(setup.model.field.one, check.evidence(), says=[says], unit="1", is_complete=True)


def _closes(setup: Setup, values: Mapping[str, float]) -> float:
    """1 where the loop can be assembled in some pose, else 0."""
    rows = tuple(row for row in setup.system.constraint_rows if not row.is_driven)
    loose = replace(setup.system, constraint_rows=rows, start={}, start_rates={})
    try:
        Reference(loose, dict(values)).assemble(guess=setup.draws[0].q)
    except CannotAnswer:
        return 0.0
    return 1.0


@is_so.register(Assembly)
def _(q: Assembly, setup: Setup) -> Formula:
    everywhere = CannotAnswer(Message("the loop can be assembled with all lengths"))
    try:
        links = four_links(setup)
    except CannotAnswer:
        if n_loops(setup.system) == 1 and not Closure(setup.model).closes():
            raise everywhere from None
        raise
    needs, _told = links.assembles()
    purpose = Message("the loop can be assembled")
    found = [Condition(x, ">=", purpose) for x in needs if decide(x, ">=") is not True]
    if not found:
        raise everywhere
    return Formula(
        Fraction(1), found, lambda: _compared(links, "assembly", needs), lambda values: _closes(setup, values)
    )


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
