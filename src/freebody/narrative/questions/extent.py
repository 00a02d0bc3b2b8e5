"""How far a motion gets: where the speed that energy gives is zero."""

from __future__ import annotations

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.narrative.context import Context, Method, refuse
from freebody.narrative.lines.glossary import World
from freebody.narrative.lines.naming import asked_as, asked_entry
from freebody.narrative.lines.script import Argument, DerivationStage
from freebody.narrative.questions.course_by_energy import first_integral, say_first_integral, square_line
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer
from freebody.study.answering.extent import extent_in_numbers, turn_of
from freebody.symbolic.tidy import tidy


def derive(context: Context, question: Question, answer: Answer, method: Method) -> list[DerivationStage]:
    """The derivation. Raises CannotAnswer where the solver has no formula, or where a law of motion gave it."""
    setup, quantity = context.setup, question.quantity
    measure, side = getattr(quantity, "measure", None), int(getattr(quantity, "side", 1))
    if answer.expression is None or measure is None:
        raise CannotAnswer(answer.reason or Message("there is no closed form"))
    refuse(method, ("energy",), Message("how far it gets"))
    with setup.motion.on_one_side():
        c, found, x = turn_of(setup, measure, side)
    if len(setup.model.coordinates) > 1:
        raise CannotAnswer(Message("energy and momentum of several freedoms are told without a derivation here"))
    if found.time is not None:
        raise CannotAnswer(Message("ask for it when its rate is zero; that is derived"))
    script = context.script()
    lines = first_integral(context, script)
    with script.stage("stage.event", "hint.event"):
        say_first_integral(context, script, c)
        square = square_line(context, script, c, lines, "start")

        def read(world: World) -> float:
            return extent_in_numbers(world.draw, measure, side)

        symbol = asked_as(context, question, read)
        script.add(asked_entry(symbol, question))
        args: dict[str, Argument] = {"line": square}
        script.line(symbol, tidy(x), why="course.farthest", args=args, uses=(square,), when="never")
    return script.stages
