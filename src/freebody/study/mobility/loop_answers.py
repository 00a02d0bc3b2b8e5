"""Answers about four-link loops: here about dead points and transmission angles, beside `full_turns` and `assembling`.

Each is compared with the motion of the mechanism followed in numbers at random lengths: in which poses the output
reverses, how the angle runs.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Any, cast

import numpy as np
from scipy import optimize

from freebody.errors import CannotAnswer, SaysNothing
from freebody.language.sentences import Message, in_turn
from freebody.language.units import DIMENSIONLESS
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND
from freebody.numeric.jets import Array
from freebody.numeric.reference import Reference
from freebody.numeric.snapshot import Snapshot
from freebody.questions.at_dead_points import AtDeadPoints
from freebody.questions.base import Quantity
from freebody.questions.event_base import QuestionEvent
from freebody.questions.linkages import DeadPoints, TransmissionAngle
from freebody.questions.motion import OfMeasure
from freebody.questions.reading import Question
from freebody.questions.steady import Extremes
from freebody.study.answering.answer import Value
from freebody.study.answering.conditions import real
from freebody.study.answering.crosscheck import INSTANT_TOLERANCE, CrossCheck, element_at
from freebody.study.answering.draws import Draw
from freebody.study.answering.finding import Finding
from freebody.study.answering.formula import Formula
from freebody.study.mobility import assembling, full_turns
from freebody.study.mobility.dead_points import (
    CLEAR,
    arc_of,
    dead_points,
    needs_of,
    needs_of_reversal,
    transmission_cosine,
    transmission_extreme,
)
from freebody.study.mobility.four_links import FourLinks
from freebody.study.mobility.grashof import fold, transmission_angle
from freebody.study.mobility.linkages import FourBar
from freebody.study.mobility.loop_questions import (
    ASIDE,
    answered,
    four_links,
    is_so,
    looked_at_by,
    loop_draws,
    number,
    path_round,
    refuse_pose,
)
from freebody.study.mobility.turning_case import with_full_turn
from freebody.study.setup import Setup
from freebody.study.steady.extremes import extremes
from freebody.symbolic.ratio import Ratio

ROOMS = (full_turns, assembling)  # they register their kinds of question


def find(setup: Setup, question: Question) -> Finding:
    """The closed form with its evidence. Raises CannotAnswer with the reason where there is none."""
    if setup.system.space:
        raise CannotAnswer(Message("four-bars and slider-cranks are told in the plane only"))
    return answered(question.quantity, setup, question)


def looked_at(setup: Setup, question: Question) -> Setup:
    """The system as a question looks at it."""
    return looked_at_by(question.quantity, setup)


def value_of(q: Quantity, setup: Setup) -> Value:
    """What is asked by the numeric route, at the model's own values; None where that is not looked for."""
    return number(q, setup)


def holds(q: Quantity, setup: Setup) -> Formula:
    """Where something is so of a loop, for questions after the values of a parameter."""
    return is_so(q, setup)


@looked_at_by.register(AtDeadPoints)
def _(q: AtDeadPoints, setup: Setup) -> Setup:
    from freebody.study.mobility.at_dead_points import by_crank

    return with_full_turn(by_crank(setup, q, four_links))


@looked_at_by.register(DeadPoints)
def _(q: DeadPoints, setup: Setup) -> Setup:
    return with_full_turn(setup)


@looked_at_by.register(TransmissionAngle)
def _(q: TransmissionAngle, setup: Setup) -> Setup:
    return with_full_turn(setup) if q.end else setup


@number.register(AtDeadPoints)
def _(q: AtDeadPoints, setup: Setup) -> Value:
    from freebody.study.mobility.at_dead_points import numbers_there

    return numbers_there(four_links(setup), q, setup.draws[0])


@answered.register(AtDeadPoints)
def _at_dead_points(q: AtDeadPoints, setup: Setup, question: Question) -> Finding:
    from freebody.study.mobility.at_dead_points import find as find_there

    refuse_pose(question)
    return find_there(four_links(setup), question, q)


@answered.register(DeadPoints)
def _dead_points(q: DeadPoints, setup: Setup, question: Question) -> Finding:
    refuse_pose(question)
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
    reverses = needs_of_reversal(links, found)

    def compare(draw: Draw) -> None:
        if not all(element_at(setup, c.element, draw, draw.start())[0] > CLEAR for c in reverses):
            return
        numeric = reversing(links, draw, q.of)
        exact = [element_at(setup, point.value, draw, draw.start())[0] for point in found]
        if not numeric:
            raise SaysNothing(Message("the output does not reverse at these numbers"))
        is_angle = q.of.dimension == DIMENSIONLESS
        check.compare(draw, tuple(exact), tuple(nearest(x, numeric, is_angle=is_angle) for x in exact))

    evidence = check.gather(loop_draws(setup), compare).evidence()
    where = in_turn([point.where for point in found], "{first}; {second}")
    notes: list[str] = [
        Message("there {what} reverses: {places}", what=output_of(links), places=where),
        Message("{output} as the driver cannot move {crank} on from there", output=output_of(links), crank=links.crank),
    ]
    if any(c.element.is_zero() for c in needs_of(links)):
        notes.append(
            Message(
                "with these lengths all links can lie in one line: two branches of the motion meet there, and the dead "
                "points are those of the assembly at the start"
            )
        )
    values = tuple(point.value for point in found)
    conditions = [*reverses, *(c for x in values for c in real(x))]
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
        reference, path = path_round(links.setup.system, draw.values, draw.q, Angle(links.crank), {"output": output})
    except CannotAnswer as error:
        raise SaysNothing(str(error)) from None
    poses = [point.q for point in path.points if point.kind == "output dead point"]
    return [reference.snapshot(q, 0.0 * q).value(measure) for q in poses]


def nearest(x: float, found: Sequence[float], *, is_angle: bool) -> float:
    """x as the nearest of some numbers has it, which differ by whole turns where they are angles."""
    gaps = [math.remainder(y - x, math.tau) if is_angle else y - x for y in found]
    return x + min(gaps, key=abs)


@answered.register(TransmissionAngle)
def _transmission(q: TransmissionAngle, setup: Setup, question: Question) -> Finding:
    links = four_links(setup)
    _must_be_driven_by_crank(links)
    if q.end:
        refuse_pose(question)
        return _extreme_transmission(q, links, question)
    cos, event = transmission_cosine(links, _crank_angle(links, question)), question.event
    state = setup.start_instant if question.at_start else setup.state
    x = arc_of(links, setup.model.field.lowest_terms(state.here(cos)))
    route = Message("angle between the links of the full system in numbers")
    check = CrossCheck(question.text, route, INSTANT_TOLERANCE)

    def compare(case: tuple[Draw, Snapshot]) -> None:
        draw, seen = case
        check.compare(draw, element_at(setup, x, draw, seen), transmission_in_numbers(links, question, draw, seen.q))

    is_given = question.at_start or event is not None
    check.gather(((d, d.start()) for d in loop_draws(setup)) if is_given else setup.anywhere_stream(), compare)
    conditions = [*real(x), *(setup.closing(state) if event is None else ())]
    return Finding(x, check.evidence(), conditions, [_meant(links)], is_complete=True)


def _must_be_driven_by_crank(links: FourLinks) -> None:
    """Raises CannotAnswer where something else is driven, as the ram of a swinging block."""
    for row in links.setup.system.constraint_rows:
        if row.is_driven and not (isinstance(row.measure, Angle) and row.measure.of == links.crank):
            told = Message(
                "a transmission angle is told of a loop whose crank drives, and here {driver} does",
                driver=row.connection,
            )
            raise CannotAnswer(told)


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
        rows = tuple(row for row in links.setup.system.constraint_rows if not row.is_driven)
        loose = replace(links.setup.system, constraint_rows=rows, start={}, start_rates={})
        reference = Reference(loose, draw.values)
        q = reference.assemble(guess=draw.q)
        goal, here = reference.number(event.value), reference.snapshot(q, 0.0 * q).value(event.measure)
        n = max(1, math.ceil(abs(goal - here) / ASIDE))
        for k in range(1, n + 1):
            q = reference.pose_near(q, [(event.measure, here + (goal - here) * k / n)])
    angle = transmission_angle(links.loop, reference, q, links.crank)
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
        seen = extreme_in_numbers(links, draw, is_least=q.end == "least")
        # by 1 + cos: next to 0 the arc magnifies round-off, and a cosine of 0 has no size of its own
        check.compare(draw, 1.0 + math.cos(exact), 1.0 + math.cos(seen))

    evidence = check.gather(loop_draws(setup), compare).evidence()
    notes: list[str] = [_meant(links), Message("of the angle and what it lacks to 180 degrees the smaller one")]
    return Finding(x, evidence, needs, notes, is_complete=True)


def extreme_in_numbers(links: FourLinks, draw: Draw, *, is_least: bool) -> float:
    """The least or greatest folded transmission angle [rad], looked for along the motion in numbers."""
    loop = links.loop
    if not isinstance(loop, FourBar) and loop.fixed != loop.guide:
        return math.pi / 2
    way, crank = (1.0 if is_least else -1.0), Angle(links.crank)
    try:
        reference, path = path_round(links.setup.system, draw.values, draw.q, crank)
    except CannotAnswer as error:
        raise SaysNothing(str(error)) from None

    def angle(q: Array) -> float:
        return way * math.radians(fold(transmission_angle(loop, reference, q, links.crank) or 90.0))

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
