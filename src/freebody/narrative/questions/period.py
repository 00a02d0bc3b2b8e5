"""The period of a motion: from its law in the time, or from energy as an integral over the way."""

from __future__ import annotations

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.narrative.context import Context, Method, refuse
from freebody.narrative.lines.glossary import World
from freebody.narrative.lines.naming import asked_as, asked_entry
from freebody.narrative.lines.script import Argument, DerivationStage, Script
from freebody.narrative.principles.momentum import by_method
from freebody.narrative.questions.course_by_energy import first_integral, say_first_integral, say_integral, square_line
from freebody.narrative.questions.kept_momenta import tell_momenta
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer
from freebody.study.answering.repeated import coordinate_of, followed
from freebody.symbolic.reached import Reached
from freebody.symbolic.tidy import tidy
from freebody.symbolic.unknowns import Coordinate


def derive(context: Context, question: Question, answer: Answer, method: Method) -> list[DerivationStage]:
    """The derivation. Raises CannotAnswer where the solver has no formula."""
    measure, setup = getattr(question.quantity, "measure", None), context.setup
    if answer.expression is None:
        raise CannotAnswer(answer.reason or Message("there is no closed form"))
    c = coordinate_of(setup, measure)
    with setup.motion.on_one_side():
        found = setup.motion.period(c)
    script = context.script()
    if found.integral is None:
        refuse(method, ("newton", "lagrange"), Message("the period"))
        why, lines = _by_law(context, script, c, method)
    else:
        refuse(method, ("energy",), Message("the period"))
        why, lines = _by_energy(context, script, c, found)
    with script.stage("stage.value"):

        def read(world: World) -> float:
            return followed(setup, measure, c, world.draw, found)

        symbol = asked_as(context, question, read)
        script.add(asked_entry(symbol, question, "s"))
        args: dict[str, Argument] = {"lines": tuple(lines)}
        assert found.time is not None
        script.line(symbol, tidy(found.time), why=why, args=args, uses=tuple(lines), when="never")
    return script.stages


def _by_law(context: Context, script: Script, c: Coordinate, method: Method) -> tuple[str, list[int]]:
    """An acceleration that is linear in the coordinate, and in its rate."""
    model = context.setup.model
    unknown = model.accelerations[model.coordinates.index(c)]
    line = by_method(context, script, [unknown], method)[unknown][1]
    law = context.setup.motion.law_of(c, takes_side=True)
    assert law is not None
    return f"period.{law.key}", [line]


def _by_energy(context: Context, script: Script, c: Coordinate, found: Reached) -> tuple[str, list[int]]:
    """The time there and back, or of a whole turn, as an elliptic integral."""
    law = found.integral
    assert law is not None
    lines = first_integral(context, script)
    lines += tell_momenta(script, context.setup.motion.integrals, c, lines, "start")
    with script.stage("stage.integration", "hint.integration"):
        say_first_integral(context, script, c)
        square = square_line(context, script, c, lines, "start")
        say_integral(script, c, law, context.setup.model.field, square)
    return ("period.swings" if law.highest is not None else "period.turns_over"), [square]
