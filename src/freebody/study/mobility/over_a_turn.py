"""Extremes, stroke and time ratio of what a four-link loop drives, from its two dead points.

The output has its extremes where it reverses; between these the crank, turned evenly, passes the angles alpha and
2 pi - alpha, of which the ratio is that of the times. What the output drives in turn, as the ram of a shaper, follows
its angle alone: where it has no extreme on the way, its own are there, too.
Source: Norton, Design of Machinery, 5th ed. 2012, sec. 3.4 and 3.5.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import pairwise

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, evaluate, number, substitute
from freebody.language.sentences import Message, in_turn
from freebody.measures.angle import Angle
from freebody.measures.geometry import GROUND
from freebody.questions.reading import Question
from freebody.questions.steady import Extremes
from freebody.study.answering.conditions import real
from freebody.study.answering.crosscheck import (
    INSTANT_TOLERANCE,
    CrossCheck,
    NotReal,
    element_at,
    holds,
    without_numbers,
)
from freebody.study.answering.draws import Draw
from freebody.study.answering.finding import NO_FORM, Elements, Finding
from freebody.study.mobility.behind_a_wheel import BehindAWheel, bodies_of
from freebody.study.mobility.dead_points import DeadPoint, dead_points, needs_of_reversal
from freebody.study.mobility.linkages import at_ground, linkages
from freebody.study.mobility.loop_questions import four_links, is_single_loop, loop_draws, n_loops
from freebody.study.setup import Setup
from freebody.study.steady.round_turn import DrawnTurn, extremes_in_numbers, time_ratio_in_numbers
from freebody.symbolic.closure import explicit
from freebody.symbolic.conditions import Condition, require
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.state import SymbolicState
from freebody.symbolic.tidy import tidy
from freebody.system.parts import cut_out

PLACE_TOLERANCE = 1e-6  # of a place in numbers: its value is stationary there
_N_BETWEEN = 36  # poses between two dead points at which is looked
_ANGLE = "@angle"  # of the output, as a measure of what follows it


@dataclass(frozen=True)
class _Reversals:
    """The values and the angles of the crank at the two dead points, and what they need."""

    values: Sequence[Ratio]
    cranks: Sequence[Ratio]
    needs: Sequence[Condition]
    notes: Sequence[str]
    following: Following | None = None


@dataclass(frozen=True)
class Following:
    """What follows the angle of an output: its value by that, and between which angles."""

    output: str
    value: Expr
    ends: tuple[Expr, Expr]

    def goes_one_way(self, draw: Draw) -> bool:
        """Whether it reaches from one end to the other, and has no extreme between them, in numbers."""
        first, last = (float(evaluate(x, draw.values)) for x in self.ends)
        angles = (first + (last - first) * k / _N_BETWEEN for k in range(_N_BETWEEN + 1))
        try:
            values = [float(evaluate(self.value, {**draw.values, _ANGLE: angle})) for angle in angles]
        except ValueError:  # a root of what is negative
            return False
        return len({b > a for a, b in pairwise(values)}) == 1


def by_dead_points(setup: Setup, question: Question, q: Extremes) -> Finding | None:
    """None where it is another mechanism, or another quantity than one that follows the output."""
    watched, coordinates = q.of.watched, setup.model.coordinates
    if watched is None or watched[1] or question.at_start or len(coordinates) != 1:
        return None
    crank = setup.model.measure_of(coordinates[0])
    if not isinstance(crank, Angle) or crank == watched[0] or crank.origin != GROUND:
        return None
    for loop in linkages(setup.system):
        if GROUND in loop.links and crank.of in (ends := at_ground(loop)) and len(ends) == len({*ends}):
            try:
                return _found(setup, question, q, _reversals(setup, q, crank, bodies_of(setup.system, loop), ends))
            except NO_FORM:
                continue
    return None


def behind_a_wheel(setup: Setup, question: Question, q: Extremes) -> Finding | None:
    """Of what a link drives that turns fully; None where it is another mechanism, or another quantity."""
    watched, coordinates = q.of.watched, setup.model.coordinates
    if watched is None or watched[1] or question.at_start or len(coordinates) != 1 or n_loops(setup.system) < 2:
        return None
    crank = setup.model.measure_of(coordinates[0])
    if not isinstance(crank, Angle) or crank.origin != GROUND:
        return None
    for loop in linkages(setup.system):
        if GROUND in loop.links and crank.of in (ends := at_ground(loop)) and len({*ends}) == 2:
            try:
                part = BehindAWheel(setup, q, crank, bodies_of(setup.system, loop), ends)
                cranks = (setup.model.field.zero, part.between()) if q.what == "time ratio" else ()
                return _found(setup, question, q, _Reversals(part.values, cranks, part.needs, part.where()))
            except NO_FORM:
                continue
    return None


def _reversals(setup: Setup, q: Extremes, crank: Angle, own: frozenset[str], ends: Sequence[str]) -> _Reversals:
    """Raises CannotAnswer where there are none of them, or what follows the output has no formula."""
    system, f = setup.system, setup.model.field
    front = setup if is_single_loop(system) else Setup(cut_out(system, own))
    links = four_links(front)
    if links.crank != crank.of:
        raise CannotAnswer(Message("{link} does not turn fully", link=crank.of))

    def here(x: Ratio) -> Ratio:
        return x if links.field is f else setup.model.geometry.scalar(tidy(x))

    assert q.of.watched is not None
    cranks = dead_points(links, crank, crank.of)
    following = None
    try:
        points = dead_points(links, q.of.watched[0], "")
        values = [here(point.value) for point in points]
    except CannotAnswer:
        output = next((link for link in ends if link != crank.of), None)
        if output is None or front is setup:
            raise
        points = dead_points(links, Angle(output), output)
        following = _behind(setup, q, own - {output}, output, points)
        by_ends = (substitute(following.value, {_ANGLE: end}) for end in following.ends)
        values = [setup.model.geometry.scalar(x) for x in by_ends]
    if len(points) != 2 or (values[0] - values[1]).is_zero():
        raise CannotAnswer(Message("it does not reverse"))
    needs = [replace(c, element=here(c.element)) for c in needs_of_reversal(links, points)]
    notes = dict.fromkeys(point.where for point in points)
    return _Reversals(values, [here(point.value) for point in cranks], needs, list(notes), following)


def _behind(setup: Setup, q: Extremes, before: frozenset[str], output: str, points: Sequence[DeadPoint]) -> Following:
    """What follows the angle of an output. Raises CannotAnswer where it depends on something else as well."""
    system, draw = setup.system, setup.draws[0]
    rest = cut_out(system, frozenset(b.name for b in system.moving) - before)
    here = number(Fraction(draw.reference.snapshot(draw.q, 0.0 * draw.q).value(Angle(output))))
    back = Setup(replace(rest, measures={_ANGLE: Angle(output)}, start={_ANGLE: here}, start_rates={}))
    model = back.model
    if [model.measure_of(c) for c in model.coordinates] != [Angle(output)] or len(points) != 2:
        raise CannotAnswer(Message("it does not follow {link} alone", link=output))
    x = explicit(model, model.field.element(q.of.value(back.system, SymbolicState(model))))
    return Following(output, tidy(x), (tidy(points[0].value), tidy(points[1].value)))


def _found(setup: Setup, question: Question, q: Extremes, at: _Reversals) -> Finding:
    (c,) = setup.model.coordinates
    first = setup.draws[0]
    if at.following is not None and setup.has_values and not at.following.goes_one_way(first):
        raise CannotAnswer(Message("it has an extreme on the way between the dead points"))

    def size(x: Ratio) -> float:
        return element_at(setup, x, first, first.start())[0]

    least, largest = sorted(at.values, key=size)
    between = size(at.cranks[1] - at.cranks[0]) if at.cranks else 0.0
    element = _element(q, least, largest, at.cranks, between)
    conditions = [*at.needs, *(need for x in at.values for need in real(x))]
    if at.following is not None:  # a toggle may pass its stretched pose on the other side at other lengths
        order, _possible = require(largest - least, ">", Message("which extreme is which"))
        conditions += [] if order is None else [order]
    tolerance = PLACE_TOLERANCE if q.what == "time ratio" else INSTANT_TOLERANCE
    check = CrossCheck(question.text, Message("the full system round a turn in numbers"), tolerance)

    def compare(draw: Draw) -> None:
        try:
            if not all(holds(setup, k, draw, draw.start()) for k in conditions):
                return
        except NotReal:  # a root within what is compared: there is no such pose
            return
        if at.following is not None and not at.following.goes_one_way(draw):
            return
        turn = DrawnTurn(setup, draw, c, q.of)
        with without_numbers():
            numeric = _in_numbers(q, turn)
        check.compare(draw, element_at(setup, element, draw, turn.start), numeric)

    evidence = check.gather(loop_draws(setup), compare).evidence()
    notes, says = [in_turn(at.notes, "{first}; {second}")], list[str]()
    if at.following is not None:
        says.append(Message("between the dead points of {link} it has no extreme", link=at.following.output))
    return Finding(element, evidence, conditions, notes, says)


def _element(q: Extremes, least: Ratio, largest: Ratio, cranks: Sequence[Ratio], between_at_first: float) -> Elements:
    f = least.field
    match q.what:
        case "extremes":
            return least, largest
        case "least":
            return least
        case "greatest":
            return largest
        case "stroke":
            return f.lowest_terms(largest - least)
        case _:
            turns = round(between_at_first / math.tau)
            between = f.lowest_terms(cranks[1] - cranks[0] - 2 * turns * f.pi)
            between = between if between_at_first - turns * math.tau > 0 else -between
            return f.lowest_terms((2 * f.pi - between) / between)


def _in_numbers(q: Extremes, turn: DrawnTurn) -> tuple[float, ...]:
    if q.what == "time ratio":
        return (time_ratio_in_numbers(turn),)
    low, high = extremes_in_numbers(turn)
    return {"extremes": (low, high), "least": (low,), "greatest": (high,)}.get(q.what, (high - low,))
