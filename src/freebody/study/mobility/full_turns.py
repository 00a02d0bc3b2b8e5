"""Which links turn fully: Grashof's condition, and of other loops what is under the roots of their solution.

A loop that is none of four links is asked through its coordinates: what is under the roots must not become negative on
the way round. Both are compared with the motion of the mechanism followed in numbers at random lengths.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

from freebody.errors import CannotAnswer, SaysNothing
from freebody.language.notation import joined, reworded
from freebody.language.sentences import Message
from freebody.measures.angle import Angle
from freebody.measures.geometry import Pose
from freebody.numeric.jets import Array
from freebody.numeric.reference import Reference
from freebody.questions.linkages import FullTurn
from freebody.questions.reading import Question
from freebody.study.answering.answer import Evidence
from freebody.study.answering.crosscheck import INSTANT_TOLERANCE, CrossCheck, element_at
from freebody.study.answering.draws import Draw
from freebody.study.answering.finding import Finding
from freebody.study.answering.formula import Formula
from freebody.study.mobility.behind_a_wheel import loops_round
from freebody.study.mobility.dead_points import margins
from freebody.study.mobility.four_links import FourLinks
from freebody.study.mobility.grashof import dimensions
from freebody.study.mobility.linkages import FourBar
from freebody.study.mobility.loop_questions import (
    answered,
    four_links,
    is_single_loop,
    is_so,
    looked_at_by,
    loop_draws,
    n_loops,
    path_round,
    refuse_pose,
)
from freebody.study.mobility.turning_case import has_open_lengths, with_full_turn
from freebody.study.setup import Setup
from freebody.study.steady.drive import without_drive
from freebody.study.steady.extremes import ExtremaSearch
from freebody.study.steady.turning import TurningAngle
from freebody.symbolic.closure import explicit
from freebody.symbolic.conditions import Condition, merged
from freebody.symbolic.tidy import tidy
from freebody.symbolic.unknowns import Coordinate
from freebody.system.system import System

_ROUTE = Message("the motion of the full system followed all round in numbers")


@looked_at_by.register(FullTurn)
def _(q: FullTurn, setup: Setup) -> Setup:
    """A drive of another loop than one of four links is left out: its angle is the coordinate."""
    return setup if is_single_loop(setup.system) else with_full_turn(without_drive(setup))


@answered.register(FullTurn)
def _full_turn(q: FullTurn, setup: Setup, question: Question) -> Finding:
    refuse_pose(question)
    if q.angle is not None:
        raise CannotAnswer(Message("ask for the speed or the impulse: least v so that {name} turns fully", name=q.link))
    try:
        links = four_links(setup)
        turning = links.turning(q.link)
    except CannotAnswer:
        found = _full_turn_by_parts(q, setup, question)
        return _full_turn_by_coordinate(q, setup, question) if found is None else found
    notes, verdict = _case(links), ""
    if not has_open_lengths(setup.system):
        verdict = _verdict(q.link, so=links.does_turn(q.link))
    if turning.needs:
        notes.append(Message("what must not be negative; where it is zero the linkage passes a change point"))
    evidence = _turns_in_numbers(setup, question.text, q.link, turning.conditions)
    says = reworded(Message("{link} turns fully if {condition}", link=q.link, condition=turning.says), turning.says)
    if all(x.is_zero() for x in turning.needs):
        says = Message("{link} turns fully for all lengths", link=q.link)
    lengths = margins(links, q.link)
    element = lengths[0] if len(lengths) == 1 else lengths or setup.model.field.one
    return Finding(
        element, evidence, says=[says], notes=notes, verdict=verdict, unit="m" if lengths else "1", is_complete=True
    )


def _case(links: FourLinks) -> list[str]:
    """Grashof's case at the model's own numbers."""
    if has_open_lengths(links.setup.system) or not isinstance(links.loop, FourBar):
        return []
    draw = links.setup.draws[0]
    return [Message("with the given numbers: {case}", case=dimensions(links.loop, draw.reference, draw.q).case)]


@is_so.register(FullTurn)
def _(q: FullTurn, setup: Setup) -> Formula:
    try:
        needs: Sequence[Condition] = four_links(setup).turning(q.link).conditions
    except CannotAnswer as error:
        if n_loops(setup.system) < 1:
            from freebody.study.mobility.round_by_energy import goes_round

            return goes_round(setup, q, error)
        needs = _all_round(setup, TurningAngle(setup.model, _coordinate(setup, q.link)))
    if not needs:
        raise CannotAnswer(Message("{link} turns fully for all lengths", link=q.link))

    def evidence() -> Evidence:
        return _turns_in_numbers(setup, q.link, q.link, needs)

    def in_numbers(values: dict[str, float]) -> float:
        try:
            pose = Reference(setup.system, values).assemble(guess=setup.draws[0].q, n_starts=2)
        except CannotAnswer:
            return 0.0
        return float(turns_fully(setup.system, values, pose, q.link))

    return Formula(Fraction(1), needs, evidence, in_numbers)


def _coordinate(setup: Setup, link: str) -> Coordinate:
    """The one coordinate that turns as a link does. Raises CannotAnswer where that does not turn, or otherwise."""
    model, f = setup.model, setup.model.field
    angle = model.value_of(Angle(link))
    if not f.ingredients(angle) & model.moving:
        raise CannotAnswer(Message("{link} does not turn: its connections hold its direction", link=link))
    if len(model.coordinates) == 1:
        (c,) = model.coordinates
        apart = (angle - way * f.variable(c.index) for way in (1, -1))
        if any(not f.ingredients(x) & model.moving for x in apart):
            return c
    raise CannotAnswer(
        Message(
            "a full turn of {link} has a condition in closed form in a loop of four links, and elsewhere where the "
            "angle of {link} is the only coordinate. Its reach in numbers: freebody mobility --along",
            link=link,
        )
    )


def _full_turn_by_parts(q: FullTurn, setup: Setup, question: Question) -> Finding | None:
    """Of a loop of four links and another one behind a link of it that turns fully as well: what each of them needs."""
    for front, behind, output in loops_round(setup, q.link):
        turning = [front.turning(name) for name in dict.fromkeys((q.link, output))] + [behind.turning(output)]
        by_margins = [(front, name) for name in dict.fromkeys((q.link, output))] + [(behind, output)]
        here = setup.model.geometry.scalar
        conditions = [replace(c, element=here(tidy(c.element))) for one in turning for c in one.conditions]
        lengths = tuple(dict.fromkeys(here(tidy(x)) for links, name in by_margins for x in margins(links, name)))
        told = joined([one.says for one in turning if one.needs])
        says = reworded(Message("{link} turns fully if {condition}", link=q.link, condition=told), told)
        evidence = _turns_in_numbers(setup, question.text, q.link, conditions, only_if=True)
        notes: list[str] = [Message("as it is assembled at the start; other lengths may allow it in another way")]
        verdict = "" if has_open_lengths(setup.system) else _verdict(q.link, so=True)
        element = lengths[0] if len(lengths) == 1 else lengths or setup.model.field.one
        unit = "m" if lengths else "1"
        return Finding(element, evidence, says=[says], notes=notes, verdict=verdict, unit=unit, is_complete=True)
    return None


def _full_turn_by_coordinate(q: FullTurn, setup: Setup, question: Question) -> Finding:
    """Any loop that is solved by the angle of the link."""
    model = setup.model
    try:
        turning = TurningAngle(model, _coordinate(setup, q.link))
        conditions = _all_round(setup, turning)
    except CannotAnswer as error:
        if has_open_lengths(setup.system) or model.degrees_of_freedom != 1 or q.link not in setup.system.bodies:
            raise
        try:
            return _full_turn_in_numbers(q, setup, str(error))
        except CannotAnswer:  # what does not turn leads no motion
            raise error from None
    evidence = _turns_in_numbers(setup, question.text, q.link, conditions, only_if=True)
    told = joined(merged([Condition(c.element, c.relation) for c in conditions]))
    says = (
        reworded(Message("{link} turns fully if {condition}", link=q.link, condition=told), told)
        if conditions
        else Message("{link} turns fully for all lengths", link=q.link)
    )
    notes: list[str] = [*turning.notes]
    verdict = "" if has_open_lengths(setup.system) else _verdict(q.link, so=True)
    if conditions:
        notes.append(Message("as it is assembled at the start; other lengths may allow it in another way"))
    needs = tuple(c.element for c in conditions)
    element = needs[0] if len(needs) == 1 else needs or model.field.one
    return Finding(
        element, evidence, says=[says], notes=notes, verdict=verdict, unit="" if needs else "1", is_complete=True
    )


def _full_turn_in_numbers(q: FullTurn, setup: Setup, why: str) -> Finding:
    """At the given lengths alone. why: no condition is told."""
    draw = setup.draws[0]
    so = turns_fully(setup.system, draw.values, draw.q, q.link)
    told = _verdict(q.link, so=so)
    evidence = Evidence(1, 0.0, _ROUTE)
    return Finding(Fraction(so), evidence, says=[told], notes=[why], verdict=told, unit="1", is_complete=True)


def _verdict(link: str, *, so: bool) -> str:
    if so:
        return Message("with the given numbers {link} turns fully", link=link)
    return Message("with the given numbers {link} does not turn fully", link=link)


def _all_round(setup: Setup, turning: TurningAngle) -> list[Condition]:
    """Under what conditions all bodies have places on the way round, on the branch of the start."""
    search = ExtremaSearch(turning)
    for body in setup.system.moving:
        pose = setup.model.geometry.pose(body.name)
        assert isinstance(pose, Pose)
        for x in (pose.x, pose.y):
            there = explicit(setup.model, x)
            if turning.occurs_in(there):
                search.must_exist(there)
    search.must_go_round(setup)
    return search.conditions


def _turns_in_numbers(
    setup: Setup, question: str, link: str, conditions: Sequence[Condition], *, only_if: bool = False
) -> Evidence:
    """The motion is followed in numbers. only_if: draws that break a condition say nothing."""
    check = CrossCheck(question, _ROUTE, INSTANT_TOLERANCE)

    def compare(draw: Draw) -> None:
        so = all(element_at(setup, c.element, draw, draw.start())[0] >= 0 for c in conditions)
        if only_if and not so:
            return
        check.compare(draw, float(so), float(turns_fully(setup.system, draw.values, draw.q, link)))

    return check.gather(loop_draws(setup), compare).evidence()


def turns_fully(system: System, values: dict[str, float], q: Array, link: str) -> bool:
    """Whether a link goes round, by the motion from a pose. Raises SaysNothing where it cannot be followed."""
    try:
        return path_round(system, values, q, Angle(link))[1].full_turn
    except CannotAnswer as error:
        raise SaysNothing(str(error)) from None
