"""Who answers which question about motion that goes on evenly."""

from __future__ import annotations

import math
from functools import singledispatch

from freebody.errors import CannotAnswer, RoutesDisagree
from freebody.language.sentences import Message
from freebody.questions.arithmetic import refuse_vectors
from freebody.questions.base import Quantity
from freebody.questions.reading import Question
from freebody.questions.steady import (
    Extremes,
    SpinStability,
    SteadyOscillations,
    SteadyStability,
    SteadyValue,
    extremes_in,
)
from freebody.study.answering.answer import Value
from freebody.study.answering.finding import NO_FORM, Finding
from freebody.study.setup import Setup


def find(setup: Setup, question: Question) -> Finding:
    """The closed form with its evidence. Raises CannotAnswer with the reason where there is none."""
    if question.event is not None and not question.quantity.keeps_what_is_given:
        raise CannotAnswer(Message("what goes on evenly has no event; leave out 'when'"))
    return _find(question.quantity, setup, question)


def looked_at(setup: Setup, question: Question) -> Setup:
    """The system as a question looks at it: for what is so in the poses of a turn the drive is left out that turns it
    evenly, and lengths that are open are such that it turns fully."""
    if not question.quantity.is_of_turn:
        return setup
    from freebody.study.mobility.turning_case import with_full_turn
    from freebody.study.steady.drive import without_drive

    return with_full_turn(without_drive(setup))


@singledispatch
def number(q: Quantity, setup: Setup, question: Question) -> Value:
    """What is asked by the numeric route alone, at the model's own values; None where that is not looked for. Raises
    CannotAnswer."""
    return None


@number.register(Extremes)
def _number_of_turn(q: Extremes, setup: Setup, question: Question) -> Value:
    from freebody.study.steady.drive import FreeToTurn, followed, turned_by_drive
    from freebody.study.steady.extremes import angle_of
    from freebody.study.steady.round_turn import DrawnTurn, extremes_in_numbers, time_ratio_in_numbers
    from freebody.symbolic.closure import explicit

    if question.at_start:
        return None
    if not isinstance(setup, FreeToTurn) and not setup.model.coordinates:
        return _number_of_period(q, setup)
    if isinstance(setup, FreeToTurn):
        c = turned_by_drive(setup)
    elif q.of.kinematic_order != 0 and not q.of.is_of_pose_in_motion:
        return None  # at which rate, no drive says
    else:
        x = followed(setup, q.of)
        refuse_vectors((x,))
        c = angle_of(setup.model, q, explicit(setup.model, setup.model.field.element(x)))
    turn = DrawnTurn(setup, setup.draws[0], c, q.of)
    refuse_vectors((turn.quantity_at(setup.draws[0].q),))
    return time_ratio_in_numbers(turn) if q.what == "time ratio" else _of_both(q, *extremes_in_numbers(turn))


def number_of_driven_turn(setup: Setup, question: Question) -> Value:
    """Over a turn of the one drive, by the poses through which it leads the system, where there are no formulas; None
    where it is another question, or nothing turns evenly. Raises CannotAnswer where a pose cannot be had."""
    from freebody.study.answering.motion_values import extremes_between
    from freebody.study.steady.drive import FreeToTurn

    q, free = extremes_in(question.quantity), looked_at(setup, question)
    if q is None or q.what == "time ratio" or question.at_start or not isinstance(free, FreeToTurn):
        return None
    draw = setup.draws[0]
    rate = abs(draw.reference.number(free.rate))
    return _of_both(q, *extremes_between(setup, draw, q.of, 0.0, math.tau / rate)) if rate else None


def _of_both(q: Extremes, least: float, largest: float) -> Value:
    match q.what:
        case "extremes":
            return least, largest
        case "least":
            return least
        case "greatest":
            return largest
        case _:
            return largest - least


def _number_of_period(q: Extremes, setup: Setup) -> Value:
    """Over the period of a drive."""
    from freebody.study.steady.drive import followed
    from freebody.study.steady.phase import extremes_of_period, phase_of

    if q.what == "time ratio":
        return None
    x = followed(setup, q.of)
    refuse_vectors((x,))
    phase = phase_of(setup.model, setup.model.field.element(x))
    return None if phase is None else _of_both(q, *extremes_of_period(setup, setup.draws[0], q.of, phase))


@number.register(SteadyOscillations)
def _number_of_oscillations(q: SteadyOscillations, setup: Setup, question: Question) -> Value:
    from freebody.study.steady.oscillations import in_numbers

    return in_numbers(setup, question, q)


@singledispatch
def _find(q: Quantity, setup: Setup, question: Question) -> Finding:
    raise CannotAnswer(Message("this is no question about steady motion"))


@_find.register(SteadyValue)
def _value(q: SteadyValue, setup: Setup, question: Question) -> Finding:
    from freebody.study.steady.values import steady_value

    return steady_value(setup, question, q)


@_find.register(Extremes)
def _extremes(q: Extremes, setup: Setup, question: Question) -> Finding:
    from freebody.study.mobility.over_a_turn import behind_a_wheel, by_dead_points
    from freebody.study.steady.extremes import extremes

    if (driven := behind_a_wheel(setup, question, q)) is not None:
        return driven
    try:
        return extremes(setup, question, q)
    except RoutesDisagree:
        raise
    except NO_FORM:
        found = by_dead_points(setup, question, q)
        if found is None:
            raise
        return found


@_find.register(SpinStability)
def _spin(q: SpinStability, setup: Setup, question: Question) -> Finding:
    from freebody.study.steady.spin import spin_stability

    return spin_stability(setup, question, q)


@_find.register(SteadyStability)
def _stability(q: SteadyStability, setup: Setup, question: Question) -> Finding:
    from freebody.study.steady.stability import steady_stability

    return steady_stability(setup, question)


@_find.register(SteadyOscillations)
def _oscillations(q: SteadyOscillations, setup: Setup, question: Question) -> Finding:
    from freebody.study.steady.oscillations import oscillations

    return oscillations(setup, question, q)
