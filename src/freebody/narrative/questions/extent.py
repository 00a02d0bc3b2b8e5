"""How far a motion gets: where the speed that energy gives is zero; and the extremes of a quantity over all of it."""

from __future__ import annotations

from dataclasses import replace
from functools import singledispatch

from freebody.errors import CannotAnswer, SaysNothing
from freebody.language.sentences import Argument, Message
from freebody.narrative.context import Context, Method, refuse
from freebody.narrative.kinds import derivation_of
from freebody.narrative.lines.glossary import World
from freebody.narrative.lines.naming import asked_as, asked_entry
from freebody.narrative.lines.script import DerivationStage
from freebody.narrative.questions.course_by_energy import first_integral, say_first_integral, square_line
from freebody.narrative.questions.extreme_of_swing import tell_swing
from freebody.narrative.questions.kept_momenta import tell_momenta
from freebody.narrative.questions.over_motion import tell_extreme
from freebody.questions.base import Quantity
from freebody.questions.clock import Clock
from freebody.questions.extent import Extent, ExtremeOfMotion
from freebody.questions.reading import Question
from freebody.questions.steady import Extremes
from freebody.study.answering.answer import Answer
from freebody.study.answering.crosscheck import holds
from freebody.study.answering.extent import extent_in_numbers, goes_one_way, kept_on_the_way, turn_of
from freebody.study.answering.modal_extremes import wave_of
from freebody.study.answering.settling_extremes import settling_of
from freebody.study.answering.solve import solve
from freebody.study.answering.uniform_extremes import instant_of_turn
from freebody.symbolic.conditions import Condition
from freebody.symbolic.tidy import tidy


def derive(context: Context, question: Question, answer: Answer, method: Method) -> list[DerivationStage]:
    """The derivation. Raises CannotAnswer where the solver has no formula, or where a law of motion gave it."""
    if answer.expression is None:
        raise CannotAnswer(answer.reason or Message("there is no closed form"))
    if question.quantity.is_of_answers:
        from freebody.narrative.questions.calculated import derive_calculated

        return derive_calculated(context, question, answer, method)
    return _told(question.quantity, context, question, answer, method)


@singledispatch
def _told(
    quantity: Quantity, context: Context, question: Question, answer: Answer, method: Method
) -> list[DerivationStage]:
    return _turning(quantity, context, question, answer, method)


@_told.register
def _of_extent(
    quantity: Extent, context: Context, question: Question, answer: Answer, method: Method
) -> list[DerivationStage]:
    """By the turn of its coordinate where it goes one way with it, else as an extreme of the motion."""
    setup = context.setup
    if question.event is not None:
        return tell_extreme(context, question, quantity.of_motion, method)
    if (turned := _evenly(quantity.of_motion, context, question, method)) is not None:
        return turned
    swings = wave_of(setup, quantity.of_motion.of) is not None
    if swings or not setup.model.coordinates or not goes_one_way(setup, quantity.measure):
        return _extreme(quantity.of_motion, context, question, answer, method)
    return _turning(quantity, context, question, answer, method)


def _turning(
    quantity: Quantity, context: Context, question: Question, answer: Answer, method: Method
) -> list[DerivationStage]:
    """What is reached where the motion turns back."""
    setup = context.setup
    measure, side = getattr(quantity, "measure", None), int(getattr(quantity, "side", 1))
    if measure is None:
        raise CannotAnswer(Message("there is no closed form"))
    refuse(method, ("energy",), Message("how far it gets"))
    with setup.motion.on_one_side():
        c, found, x = turn_of(setup, measure, side, str(getattr(quantity, "name", "")))
    if found.time is not None:
        return _first_turn(quantity, context, question, answer, method)
    script = context.script()
    lines = first_integral(context, script)
    lines += tell_momenta(script, setup.motion.integrals_of(c), c, lines, "start")
    with script.stage("stage.event", "hint.event"):
        say_first_integral(context, script, c)
        square = square_line(context, script, c, lines, "start")

        is_start = (x - setup.start_instant.value(measure)).is_zero()
        kept = kept_on_the_way(setup, found)
        kept += [Condition(part, relation, Message("it turns")) for part, relation in found.conditions]

        def is_so(world: World) -> bool:
            return all(holds(setup, k, world.draw, world.draw.start()) for k in kept)

        def read(world: World) -> float:
            if not is_so(world):
                raise SaysNothing(Message("the motion is another one there"))
            return extent_in_numbers(world.draw, measure, side, turns=not is_start)

        symbol = asked_as(context, question, read)
        script.add(asked_entry(symbol, question))
        script.glossary = script.glossary.where(is_so)
        args: dict[str, Argument] = {"line": square}
        script.line(symbol, tidy(x), why="course.farthest", args=args, uses=(square,), when="start")
    return script.stages


def _first_turn(
    quantity: Quantity, context: Context, question: Question, answer: Answer, method: Method
) -> list[DerivationStage]:
    """Where its law of motion tells when its rate is zero first: its value then."""
    assert isinstance(quantity, Extent)
    of, event, _side = quantity.turn
    asked = replace(question, quantity=of, event=event, options={}, key=None)
    (given,) = solve(replace(context.system, questions=(asked,)), setup=context.setup).answers
    if given.expression != answer.expression:
        raise CannotAnswer(Message("ask for it when its rate is zero; that is derived"))
    return derivation_of(context.system, asked)(context, asked, given, method)


def _evenly(q: ExtremeOfMotion, context: Context, question: Question, method: Method) -> list[DerivationStage] | None:
    """Of what turns where all is accelerated evenly: its value at that instant; None where it turns otherwise."""
    time = instant_of_turn(context.setup, q.of)
    if time is None:
        return None
    asked = replace(question, quantity=q.of, event=Clock(time, question.text), options={}, key=None)
    alone = Context(replace(context.system, questions=(asked,)))
    (given,) = solve(alone.system, setup=alone.setup).answers
    return derivation_of(alone.system, asked)(alone, asked, given, method)


@_told.register(ExtremeOfMotion)
def _extreme(
    q: ExtremeOfMotion, context: Context, question: Question, answer: Answer, method: Method
) -> list[DerivationStage]:
    """Of a quantity over the motion; what a drive keeps going makes one turn after the other."""
    if question.event is not None:
        return tell_extreme(context, question, q, method)
    if (turned := _evenly(q, context, question, method)) is not None:
        return turned
    if (swing := wave_of(context.setup, q.of)) is not None:
        return tell_swing(context, question, q, swing, method)
    if settling_of(context.setup, q.of) is not None:
        raise CannotAnswer(Message("how a quantity changes with a rate that settles is given as a result only"))
    if context.setup.model.coordinates:
        return tell_extreme(context, question, q, method)
    from freebody.narrative.steady.steady import derive as of_turn

    return of_turn(context, replace(question, quantity=Extremes(q.of, None, q.end)), answer, method)
