"""Extremes, stroke and time ratio of what a four-link loop drives, from its two dead points.

The output has its extremes where it reverses; between these the crank, turned evenly, passes the angles alpha and
2 pi - alpha, of which the ratio is that of the times. Source: Norton, Design of Machinery, 5th ed. 2012, sec. 3.4.
"""

from __future__ import annotations

import math

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.measures.angle import Angle
from freebody.questions.reading import Question
from freebody.questions.steady import Extremes
from freebody.study.answering.conditions import real
from freebody.study.answering.crosscheck import INSTANT_TOLERANCE, CrossCheck, element_at, holds
from freebody.study.answering.draws import Draw
from freebody.study.answering.finding import Elements, Finding
from freebody.study.mobility.dead_points import dead_points, needs_of_reversal
from freebody.study.mobility.four_links import FourLinks
from freebody.study.mobility.loop_questions import four_links, loop_draws
from freebody.study.setup import Setup
from freebody.study.steady.round_turn import DrawnTurn, extremes_in_numbers, time_ratio_in_numbers
from freebody.symbolic.field import Ratio

PLACE_TOLERANCE = 1e-6  # of a place in numbers: its value is stationary there


def by_dead_points(setup: Setup, question: Question, q: Extremes) -> Finding | None:
    """None where it is another mechanism, or another quantity than the angle or travel of the output."""
    watched, model = q.of.watched, setup.model
    if watched is None or watched[1] or question.at_start or len(model.coordinates) != 1:
        return None
    try:
        links = four_links(setup)
        points = dead_points(links, watched[0], str(question.text))
        cranks = dead_points(links, Angle(links.crank), links.crank)
    except CannotAnswer:
        return None
    (c,) = model.coordinates
    if len(points) != 2 or model.measure_of(c) != Angle(links.crank) or watched[0] == Angle(links.crank):
        return None
    least, largest = sorted((p.value for p in points), key=links.number)
    if (largest - least).is_zero():
        return None
    element = _element(q, links, least, largest, [p.value for p in cranks])
    conditions = [*needs_of_reversal(links, points), *(need for x in (least, largest) for need in real(x))]
    tolerance = PLACE_TOLERANCE if q.what == "time ratio" else INSTANT_TOLERANCE
    check = CrossCheck(question.text, Message("the full system round a turn in numbers"), tolerance)

    def compare(draw: Draw) -> None:
        if not all(holds(setup, k, draw, draw.start()) for k in conditions):
            return
        turn = DrawnTurn(setup, draw, c, q.of)
        exact = element_at(setup, element, draw, turn.start)
        check.compare(draw, exact, _in_numbers(q, turn))

    evidence = check.gather(loop_draws(setup), compare).evidence()
    notes: list[str] = [p.where for p in points]
    return Finding(element, evidence, conditions, list(dict.fromkeys(notes)))


def _element(q: Extremes, links: FourLinks, least: Ratio, largest: Ratio, cranks: list[Ratio]) -> Elements:
    f = links.field
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
            between = f.lowest_terms(cranks[1] - cranks[0])
            turns = round(links.number(between) / math.tau)
            between = f.lowest_terms(between - 2 * turns * f.pi)
            between = between if links.number(between) > 0 else -between
            return f.lowest_terms((2 * f.pi - between) / between)


def _in_numbers(q: Extremes, turn: DrawnTurn) -> tuple[float, ...]:
    if q.what == "time ratio":
        return (time_ratio_in_numbers(turn),)
    low, high = extremes_in_numbers(turn)
    return {"extremes": (low, high), "least": (low,), "greatest": (high,)}.get(q.what, (high - low,))
