"""Answers about four-link loops: which links turn fully, when the loop closes, dead points, transmission angles.

Each is compared with the motion of the mechanism followed in numbers at random lengths: whether the link goes round, in
which poses the output reverses, how the angle runs. A loop that is none of four links is asked through its coordinates:
what is under the roots of its solution must not become negative on the way round.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from functools import singledispatch
from typing import Any, cast

import numpy as np
from scipy import optimize

from freebody.errors import CannotAnswer
from freebody.language.notation import joined, reworded
from freebody.language.sentences import Message, further, in_turn
from freebody.language.units import DIMENSIONLESS
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, Pose
from freebody.numeric.jets import Array
from freebody.numeric.mobility.path import MotionPath, trace
from freebody.numeric.reference import Reference
from freebody.questions.at_dead_points import AtDeadPoints
from freebody.questions.base import Quantity
from freebody.questions.linkages import Assembly, DeadPoints, FullTurn, TransmissionAngle
from freebody.questions.motion import OfMeasure
from freebody.questions.reading import Question, QuestionEvent
from freebody.questions.steady import Extremes
from freebody.study.answering.answer import Evidence, Value
from freebody.study.answering.conditions import real
from freebody.study.answering.crosscheck import INSTANT_TOLERANCE, CrossCheck, SaysNothing, element_at
from freebody.study.answering.draws import SEED, Draw, draws
from freebody.study.answering.finding import Finding
from freebody.study.answering.turned_round import Formula
from freebody.study.mobility.dead_points import (
    arc_of,
    dead_points,
    margins,
    needs_of,
    needs_of_reversal,
    place,
    transmission_cosine,
    transmission_extreme,
)
from freebody.study.mobility.four_links import FourLinks
from freebody.study.mobility.grashof import FourBarNumbers, dimensions, fold
from freebody.study.mobility.gruebler import is_driven
from freebody.study.mobility.linkages import FourBar, Linkage, linkages
from freebody.study.setup import N_DRAWS, Setup
from freebody.study.steady.extremes import ExtremaSearch, extremes
from freebody.study.steady.turning import TurningAngle
from freebody.symbolic.closure import explicit
from freebody.symbolic.conditions import Condition, merged
from freebody.symbolic.decide import decide
from freebody.symbolic.field import Ratio
from freebody.system.system import System

_ASIDE = 0.23  # [rad] from the start, where the motion is followed from


def find(setup: Setup, question: Question) -> Finding:
    """The closed form with its evidence. Raises CannotAnswer with the reason where there is none."""
    if setup.system.space:
        raise CannotAnswer(Message("four-bars and slider-cranks are told in the plane only"))
    return _find(question.quantity, setup, question)


def looked_at(setup: Setup, question: Question) -> Setup:
    """The system as a question looks at it."""
    return _looked_at(question.quantity, setup)


@singledispatch
def _looked_at(q: Quantity, setup: Setup) -> Setup:
    return setup


@_looked_at.register(AtDeadPoints)
def _(q: AtDeadPoints, setup: Setup) -> Setup:
    from freebody.study.mobility.at_dead_points import by_crank

    return by_crank(setup, q, four_links)


@singledispatch
def number(q: Quantity, setup: Setup) -> Value:
    """What is asked by the numeric route, at the model's own values; None where that is not looked for."""
    return None


@number.register(AtDeadPoints)
def _(q: AtDeadPoints, setup: Setup) -> Value:
    from freebody.study.mobility.at_dead_points import numbers_there

    return numbers_there(four_links(setup), q, setup.draws[0])


@singledispatch
def _find(q: Quantity, setup: Setup, question: Question) -> Finding:
    raise CannotAnswer(Message("this is no question about a linkage"))


# -- the loop ---------------------------------------------------------------------------------
def n_loops(system: System) -> int:
    """How many independent closed loops the connections make."""
    holding = {row.connection for row in system.constraint_rows if not is_driven(row)}
    return len(holding) - len(system.moving)


def only_loop(system: System) -> Linkage:
    """The four-link loop that a system is. Raises CannotAnswer where it is another mechanism."""
    found = linkages(system)
    if len(found) == 1 and n_loops(system) == 1:
        return found[0]
    raise CannotAnswer(Message("the mechanism is no single loop of four links with pins and sliders"))


def four_links(setup: Setup) -> FourLinks:
    return FourLinks(setup, only_loop(setup.system))


def _draws(setup: Setup) -> Iterator[Draw]:
    """More of them near the model's own numbers: which case of several they are in is open."""
    yield from setup.draw_stream()
    yield from draws(setup.system, N_DRAWS, seed=SEED + 30, widest=0.1, near=setup.draws[0])


def _plain(question: Question) -> None:
    if question.event is not None or question.at_start:
        raise CannotAnswer(Message("it belongs to the lengths and to no pose; leave out 'at' and 'when'"))


# -- a full turn ------------------------------------------------------------------------------
@_find.register(FullTurn)
def _full_turn(q: FullTurn, setup: Setup, question: Question) -> Finding:
    _plain(question)
    if q.angle is not None:
        raise CannotAnswer(Message("ask for the speed or the impulse: least v so that {name} turns fully", name=q.link))
    try:
        links = four_links(setup)
        turning = links.turning(q.link)
    except CannotAnswer:
        return _full_turn_by_coordinate(q, setup, question)
    notes = _case(links)
    does = Message("with the given numbers {link} turns fully", link=q.link)
    does_not = Message("with the given numbers {link} does not turn fully", link=q.link)
    if setup.has_values:
        notes.insert(0, does if links.does_turn(q.link) else does_not)
    if turning.needs:
        notes.append(Message("what must not be negative; where it is zero the linkage passes a change point"))
    evidence = _turns_in_numbers(setup, question.text, q.link, turning.conditions)
    says = reworded(Message("{link} turns fully if {condition}", link=q.link, condition=turning.says), turning.says)
    if not turning.needs:
        says = Message("{link} turns fully for all lengths", link=q.link)
    lengths = margins(links, q.link)
    element = lengths[0] if len(lengths) == 1 else lengths or setup.model.field.one
    return Finding(element, evidence, says=[says], notes=notes, unit="m" if lengths else "1", is_complete=True)


def _case(links: FourLinks) -> list[str]:
    """Grashof's case at the model's own numbers."""
    if not links.setup.has_values or not isinstance(links.loop, FourBar):
        return []
    draw = links.setup.draws[0]
    return [Message("with the given numbers: {case}", case=dimensions(links.loop, draw.reference, draw.q).case)]


@singledispatch
def is_so(q: Quantity, setup: Setup) -> Formula:
    """Where something is so of a loop, for questions after the values of a parameter."""
    raise CannotAnswer(Message("this is no question about a linkage"))


@is_so.register(FullTurn)
def _(q: FullTurn, setup: Setup) -> Formula:
    try:
        turning = four_links(setup).turning(q.link)
    except CannotAnswer as error:
        from freebody.study.mobility.round_by_energy import goes_round

        return goes_round(setup, q, error)
    if not turning.needs:
        raise CannotAnswer(Message("{link} turns fully for all lengths", link=q.link))

    def evidence() -> Evidence:
        return _turns_in_numbers(setup, q.link, q.link, turning.conditions)

    def in_numbers(values: dict[str, float]) -> float:
        try:
            pose = Reference(setup.system, values).assemble(guess=setup.draws[0].q, n_starts=2)
        except CannotAnswer:
            return 0.0
        return float(turns_fully(setup.system, values, pose, q.link))

    return Formula(Fraction(1), turning.conditions, evidence, in_numbers)


def _full_turn_by_coordinate(q: FullTurn, setup: Setup, question: Question) -> Finding:
    """Any loop that is solved by the angle of the link."""
    model = setup.model
    c = next((c for c in model.coordinates if model.measure_of(c) == Angle(q.link)), None)
    if c is None or len(model.coordinates) != 1:
        raise CannotAnswer(
            Message(
                "a full turn of {link} has a condition in closed form in a loop of four links, and elsewhere where the "
                "angle of {link} is the only coordinate. Its reach in numbers: freebody mobility --along",
                link=q.link,
            )
        )
    turning = TurningAngle(model, c)
    try:
        conditions = _all_round(setup, turning)
    except CannotAnswer:
        if not setup.has_values:
            raise CannotAnswer(Message("a condition for a full turn of {link} was not found", link=q.link)) from None
        so = turns_fully(setup.system, setup.draws[0].values, setup.draws[0].q, q.link)
        told = (
            Message("with the given numbers {link} turns fully", link=q.link)
            if so
            else Message("with the given numbers {link} does not turn fully", link=q.link)
        )
        why = Message("a condition for a full turn of {link} was not found", link=q.link)
        raise CannotAnswer(further(told, why)) from None
    evidence = _turns_in_numbers(setup, question.text, q.link, conditions, only_if=True)
    told = joined(merged([Condition(c.element, c.relation) for c in conditions]))
    says = (
        reworded(Message("{link} turns fully if {condition}", link=q.link, condition=told), told)
        if conditions
        else Message("{link} turns fully for all lengths", link=q.link)
    )
    notes: list[str] = [*turning.notes]
    if setup.has_values:
        notes.insert(0, Message("with the given numbers {link} turns fully", link=q.link))
    if conditions:
        notes.append(Message("as it is assembled at the start; other lengths may allow it in another way"))
    needs = tuple(c.element for c in conditions)
    element = needs[0] if len(needs) == 1 else needs or model.field.one
    return Finding(element, evidence, says=[says], notes=notes, unit="" if needs else "1", is_complete=True)


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
    route = Message("the motion of the full system followed all round in numbers")
    check = CrossCheck(question, route, INSTANT_TOLERANCE)

    def compare(draw: Draw) -> None:
        so = all(element_at(setup, c.element, draw, draw.start())[0] >= 0 for c in conditions)
        if only_if and not so:
            return
        check.compare(draw, float(so), float(turns_fully(setup.system, draw.values, draw.q, link)))

    return check.gather(_draws(setup), compare).evidence()


def turns_fully(system: System, values: dict[str, float], q: Array, link: str) -> bool:
    """Whether a link goes round, by the motion from a pose. Raises SaysNothing where it cannot be followed."""
    try:
        return _followed(system, values, q, Angle(link))[1].full_turn
    except CannotAnswer as error:
        raise SaysNothing(str(error)) from None


def _followed(
    system: System, values: dict[str, float], q: Array, along: Measure, outputs: dict[str, Measure] | None = None
) -> tuple[Reference, MotionPath]:
    """The motion without drivers."""
    rows = tuple(row for row in system.constraint_rows if not is_driven(row))
    loose = replace(system, constraint_rows=rows, start={}, start_rates={})
    reference = Reference(loose, values)
    q = reference.assemble(guess=q)
    with suppress(CannotAnswer):  # a start at a dead point is none on the way
        q = reference.pose_near(q, [(along, reference.snapshot(q, 0.0 * q).value(along) + _ASIDE)])
    return reference, trace(reference, q, along, outputs=outputs)


# -- assembly ---------------------------------------------------------------------------------
@_find.register(Assembly)
def _assembly(q: Assembly, setup: Setup, question: Question) -> Finding:
    _plain(question)
    links = four_links(setup)
    needs, told = links.assembles()
    if all(decide(x, ">=") is True for x in needs):
        told = ""
    route = Message("lengths of the full system as it is assembled in numbers")
    check = CrossCheck(question.text, route, INSTANT_TOLERANCE)

    def compare(draw: Draw) -> None:
        exact = tuple(element_at(setup, x, draw, draw.start())[0] for x in needs)
        check.compare(draw, exact, _room(links, draw))

    evidence = check.gather(_draws(setup), compare).evidence()
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


# -- dead points ------------------------------------------------------------------------------
@_find.register(AtDeadPoints)
def _at_dead_points(q: AtDeadPoints, setup: Setup, question: Question) -> Finding:
    from freebody.study.mobility.at_dead_points import find as find_there

    _plain(question)
    return find_there(four_links(setup), question, q)


@_find.register(DeadPoints)
def _dead_points(q: DeadPoints, setup: Setup, question: Question) -> Finding:
    _plain(question)
    try:
        links = four_links(setup)
    except CannotAnswer:
        found_there = extremes(setup, question, Extremes(OfMeasure(q.of, 0, q.name), None))
        found_there.notes.insert(0, Message("where {name} reverses, at its extreme values", name=q.name))
        return found_there
    found = dead_points(links, q.of, q.name)
    check = CrossCheck(
        question.text, Message("poses in which the output reverses, on the motion followed in numbers"), 1e-7
    )
    needs = needs_of(links)

    def compare(draw: Draw) -> None:
        if not all(element_at(setup, c.element, draw, draw.start())[0] >= 0 for c in needs):
            return
        numeric = reversing(links, draw, q.of)
        exact = [element_at(setup, point.value, draw, draw.start())[0] for point in found]
        if not numeric:
            raise SaysNothing(Message("the output does not reverse at these numbers"))
        is_angle = q.of.dimension == DIMENSIONLESS
        check.compare(draw, tuple(exact), tuple(nearest(x, numeric, is_angle=is_angle) for x in exact))

    evidence = check.gather(_draws(setup), compare).evidence()
    where = in_turn([point.where for point in found], "{first}; {second}")
    notes: list[str] = [
        Message("there {what} reverses: {places}", what=output_of(links), places=where),
        Message("{output} as the driver cannot move {crank} on from there", output=output_of(links), crank=links.crank),
    ]
    values = tuple(point.value for point in found)
    conditions = [*needs_of_reversal(links, found), *(c for x in values for c in real(x))]
    return Finding(values[0] if len(values) == 1 else values, evidence, conditions, notes, is_complete=True)


def output_of(links: FourLinks) -> str:
    """What the crank drives."""
    loop = links.loop
    if isinstance(loop, FourBar):
        return loop.output if links.crank == loop.input else loop.input
    if loop.fixed != loop.guide:
        return loop.guide
    sliding = [p.body for p in loop.joints[2].points if p.body not in (loop.rod, GROUND)]
    return sliding[0] if sliding else loop.joints[2].name


def reversing(links: FourLinks, draw: Draw, measure: Measure) -> list[float]:
    """The values of a measure where the output reverses, along the motion in numbers."""
    loop = links.loop
    if isinstance(loop, FourBar):
        output: Measure = Angle(loop.output if links.crank == loop.input else loop.input)
    elif loop.fixed != loop.guide:
        output = Angle(loop.guide)
    else:
        pivot = loop.joints[0].on(GROUND)
        assert pivot is not None
        output = Displacement(loop.joints[2].point, pivot, loop.along)
    try:
        reference, path = _followed(links.setup.system, draw.values, draw.q, Angle(links.crank), {"output": output})
    except CannotAnswer as error:
        raise SaysNothing(str(error)) from None
    poses = [point.q for point in path.points if point.kind == "output dead point"]
    return [reference.snapshot(q, 0.0 * q).value(measure) for q in poses]


def nearest(x: float, found: Sequence[float], *, is_angle: bool) -> float:
    """x as the nearest of some numbers has it, which differ by whole turns where they are angles."""
    gaps = [math.remainder(y - x, math.tau) if is_angle else y - x for y in found]
    return x + min(gaps, key=abs)


# -- transmission -----------------------------------------------------------------------------
@_find.register(TransmissionAngle)
def _transmission(q: TransmissionAngle, setup: Setup, question: Question) -> Finding:
    links = four_links(setup)
    if q.end:
        _plain(question)
        return _extreme_transmission(q, links, question)
    cos, event = transmission_cosine(links, _crank_angle(links, question)), question.event
    state = setup.start_instant if question.at_start else setup.state
    x = arc_of(links, setup.model.field.lowest_terms(state.here(cos)))
    route = Message("angle between the links of the full system in numbers")
    check = CrossCheck(question.text, route, INSTANT_TOLERANCE)

    def compare(case: tuple[int, Draw]) -> None:
        k, draw = case
        seen = draw.start() if question.at_start or event is not None else setup.anywhere[k]
        check.compare(draw, element_at(setup, x, draw, seen), transmission_in_numbers(links, question, draw, seen.q))

    check.gather(enumerate(setup.draws), compare)
    conditions = [*real(x), *(setup.closing(state) if event is None else ())]
    return Finding(x, check.evidence(), conditions, [_meant(links)], is_complete=True)


def _crank_angle(links: FourLinks, question: Question) -> Ratio | None:
    """The angle of the crank in its own axes, where the question gives it."""
    event = question.event
    if event is None:
        return None
    measure = event.measure if isinstance(event, QuestionEvent) and not event.order else None
    if isinstance(measure, Angle) and measure.of == links.crank and measure.origin == GROUND:
        assert isinstance(event, QuestionEvent)
        return links.model.geometry.scalar(event.value) + links.model.geometry.scalar(measure.reference)
    raise CannotAnswer(
        Message("a transmission angle belongs to a pose: give it by the angle of {crank}", crank=links.crank)
    )


def transmission_in_numbers(links: FourLinks, question: Question | None, draw: Draw, q: Array) -> float:
    """Of a pose, or of that which the question tells [rad]."""
    event, reference = None if question is None else question.event, draw.reference
    if isinstance(event, QuestionEvent):
        rows = tuple(row for row in links.setup.system.constraint_rows if not is_driven(row))
        loose = replace(links.setup.system, constraint_rows=rows, start={}, start_rates={})
        reference = Reference(loose, draw.values)
        q = reference.assemble(guess=draw.q)
        goal, here = reference.number(event.value), reference.snapshot(q, 0.0 * q).value(event.measure)
        n = max(1, math.ceil(abs(goal - here) / _ASIDE))
        for k in range(1, n + 1):
            q = reference.pose_near(q, [(event.measure, here + (goal - here) * k / n)])
    angle = dimensions(links.loop, reference, q).transmission_angle
    return math.pi / 2 if angle is None else math.radians(angle)


def _meant(links: FourLinks) -> str:
    loop = links.loop
    if isinstance(loop, FourBar):
        return Message("between {coupler} and {output}, at their pin", coupler=loop.coupler, output=output_of(links))
    if loop.fixed == loop.guide:
        return Message("between {rod} and the normal of the guide", rod=loop.rod)
    return Message("a pin in a slot presses at right angles to {output} in every pose", output=loop.guide)


def _extreme_transmission(q: TransmissionAngle, links: FourLinks, question: Question) -> Finding:
    setup = links.setup
    x, conditions = transmission_extreme(links, is_least=q.end == "least")
    needs = [*conditions, *needs_of(links)]
    route = Message("the angle all round the motion followed in numbers")
    check = CrossCheck(question.text, route, INSTANT_TOLERANCE)

    def compare(draw: Draw) -> None:
        if not all(element_at(setup, c.element, draw, draw.start())[0] >= 0 for c in needs):
            return
        (exact,) = element_at(setup, x, draw, draw.start())
        check.compare(draw, exact, extreme_in_numbers(links, draw, is_least=q.end == "least"))

    evidence = check.gather(_draws(setup), compare).evidence()
    notes: list[str] = [_meant(links), Message("of the angle and what it lacks to 180 degrees the smaller one")]
    return Finding(x, evidence, needs, notes, is_complete=True)


def extreme_in_numbers(links: FourLinks, draw: Draw, *, is_least: bool) -> float:
    """The least or greatest folded transmission angle [rad], looked for along the motion in numbers."""
    loop = links.loop
    if not isinstance(loop, FourBar) and loop.fixed != loop.guide:
        return math.pi / 2
    way, crank = (1.0 if is_least else -1.0), Angle(links.crank)
    try:
        reference, path = _followed(links.setup.system, draw.values, draw.q, crank)
    except CannotAnswer as error:
        raise SaysNothing(str(error)) from None

    def angle(q: Array) -> float:
        return way * math.radians(fold(dimensions(loop, reference, q).transmission_angle or 90.0))

    values = [angle(q) for q in path.poses]
    k = int(np.argmin(values))
    best, at = path.poses[k], float(path.inputs[k])

    def turned(by: float) -> float:
        return angle(reference.pose_near(best, [(crank, at + by)]))

    room = 2.0 * float(np.max(np.abs(np.diff(path.inputs))))
    found: Any = cast("Any", optimize).minimize_scalar(
        turned, bounds=(-room, room), method="bounded", options={"xatol": 1e-11}
    )
    return way * min(float(found.fun), min(values))
