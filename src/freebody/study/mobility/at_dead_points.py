"""A quantity in the poses in which the output of a four-link loop reverses.

The poses are those of `dead_points`, by the angle of the crank; what is asked is the same function of that angle as
over a turn: of the pose alone, or of rates and forces while a drive turns the crank evenly.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import replace

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message, in_turn
from freebody.measures.angle import Angle
from freebody.questions.at_dead_points import AtDeadPoints
from freebody.questions.reading import Question
from freebody.study.answering.conditions import real
from freebody.study.answering.crosscheck import INSTANT_TOLERANCE, CrossCheck, element_at, holds
from freebody.study.answering.draws import Draw
from freebody.study.answering.finding import Finding
from freebody.study.mobility.dead_points import DeadPoint, dead_points, needs_of, needs_of_reversal
from freebody.study.mobility.four_links import FourLinks
from freebody.study.setup import Setup
from freebody.study.steady.drive import FreeToTurn, followed, without_drive
from freebody.study.steady.round_turn import DrawnTurn
from freebody.symbolic.closure import explicit
from freebody.symbolic.ratio import Ratio

_NEEDS_DRIVE = Message("it depends on how the crank turns: give it a driver, {{measure: psi, follows: w*t}}")


def by_crank(setup: Setup, q: AtDeadPoints, links_of: Callable[[Setup], FourLinks]) -> Setup:
    """The system with the angle of its crank as the one coordinate. Raises CannotAnswer where what is asked depends on
    how it moves, and no drive says that."""
    turned = without_drive(setup)
    if not isinstance(turned, FreeToTurn):
        if q.of.kinematic_order != 0:
            raise CannotAnswer(_NEEDS_DRIVE)
        system, crank = setup.system, links_of(setup).crank
        name = next((n for n, m in system.measures.items() if m == Angle(crank)), crank)
        start = {n: x for n, x in system.start.items() if n == name}
        turned = Setup(replace(system, measures={name: Angle(crank)}, start=start, start_rates={}))
    if len(turned.model.coordinates) != 1:
        raise CannotAnswer(Message("beside the loop something else is free to move"))
    return turned


def values_there(links: FourLinks, q: AtDeadPoints) -> list[tuple[DeadPoint, Ratio]]:
    """(dead point, by the angle of the crank; the quantity there)"""
    model, f = links.model, links.field
    (c,) = model.coordinates
    measure = model.measure_of(c)
    if q.of.watched is not None and not q.of.watched[1] and measure is not None:
        with suppress(CannotAnswer):  # what the triangle of the dead point tells reads best
            there = dead_points(links, q.of.watched[0], "", q.which)
            pairs = zip(dead_points(links, measure, c.name, q.which), there, strict=True)
            return [(point, own.value) for point, own in pairs]
    value = followed(links.setup, q.of)
    if measure is None or isinstance(value, tuple):
        raise CannotAnswer(Message("a vector at dead points is told by its size, or by a component along a direction"))
    x = explicit(model, f.lowest_terms(f.element(value)))
    found: list[tuple[DeadPoint, Ratio]] = []
    for point in dead_points(links, measure, c.name, q.which):
        try:
            found.append((point, f.lowest_terms(f.follow(x, {c.index: point.value}))))
        except ZeroDivisionError:
            raise CannotAnswer(Message("it grows without bound towards a dead point")) from None
    return found


def find(links: FourLinks, question: Question, q: AtDeadPoints) -> Finding:
    """The closed form, and the full system in these poses. links: by the angle of the crank."""
    found = values_there(links, q)
    points = [point for point, _x in found]
    conditions = [*needs_of_reversal(links, points), *(need for _point, x in found for need in real(x))]
    check = CrossCheck(question.text, Message("the full system in the poses of the dead points"), INSTANT_TOLERANCE)

    def compare(draw: Draw) -> None:
        start = draw.start()
        if not all(holds(links.setup, k, draw, start) for k in conditions):
            return
        exact = element_at(links.setup, tuple(x for _point, x in found), draw, start)
        there = _there(links, q, draw, points)
        if q.of.unit == "rad":  # an angle is counted on from the start, or back
            there = tuple(x + math.remainder(y - x, math.tau) for x, y in zip(exact, there, strict=True))
        check.compare(draw, exact, there)

    evidence = check.gather(links.setup.draw_stream(), compare).evidence()
    where = in_turn([point.where for point, _x in found], "{first}; {second}")
    element = tuple(x for _point, x in found)
    return Finding(element if len(element) > 1 else next(iter(element)), evidence, conditions, [where])


def _there(links: FourLinks, q: AtDeadPoints, draw: Draw, points: Sequence[DeadPoint]) -> tuple[float, ...]:
    """The quantity by the numeric route in the poses of the dead points."""
    turn = DrawnTurn(links.setup, draw, links.model.coordinates[0], q.of)
    angles = element_at(links.setup, tuple(point.value for point in points), draw, turn.start)
    return tuple(turn.at(math.remainder(angle - turn.here, math.tau)) for angle in angles)


def numbers_there(links: FourLinks, q: AtDeadPoints, draw: Draw) -> tuple[float, ...]:
    """The same without a formula of the quantity. links: by the angle of the crank. Raises CannotAnswer where it
    depends on how the crank turns, and no drive says that."""
    if not isinstance(links.setup, FreeToTurn) and q.of.kinematic_order != 0:
        raise CannotAnswer(_NEEDS_DRIVE)
    (c,) = links.model.coordinates
    measure = links.model.measure_of(c)
    if measure is None or not all(
        element_at(links.setup, n.element, draw, draw.start())[0] > 0 for n in needs_of(links)
    ):
        raise CannotAnswer(Message("the crank does not turn fully"))
    return _there(links, q, draw, dead_points(links, measure, c.name, q.which))
