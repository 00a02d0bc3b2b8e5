"""The period of a motion: from its law in the time, or from energy as an integral over the way."""

from __future__ import annotations

from freebody.errors import CannotAnswer
from freebody.language.sentences import Argument, Message
from freebody.measures.base import Measure
from freebody.narrative.context import Context, Method, refuse
from freebody.narrative.lines.glossary import World
from freebody.narrative.lines.naming import asked_as, asked_entry
from freebody.narrative.lines.script import DerivationStage, Script
from freebody.narrative.principles.momentum import by_method
from freebody.narrative.questions.course_by_energy import first_integral, say_first_integral, say_integral, square_line
from freebody.narrative.questions.kept_momenta import tell_momenta
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer
from freebody.study.answering.repeated import followed, period_of
from freebody.symbolic.reached import Reached
from freebody.symbolic.tidy import tidy
from freebody.symbolic.unknowns import Coordinate


def derive(context: Context, question: Question, answer: Answer, method: Method) -> list[DerivationStage]:
    """The derivation. Raises CannotAnswer where the solver has no formula."""
    measure, setup = getattr(question.quantity, "measure", None), context.setup
    if answer.expression is None:
        raise CannotAnswer(answer.reason or Message("there is no closed form"))
    with setup.motion.on_one_side():
        found, watched = period_of(setup, measure)
    script, c = context.script(), found.coordinate
    if found.integral is None or c is None:
        refuse(method, ("newton", "lagrange"), Message("the period"))
        why, lines = _by_law(context, script, watched, c, method)
    else:
        refuse(method, ("energy",), Message("the period"))
        why, lines = _by_energy(context, script, c, found)
    with script.stage("stage.value"):

        def read(world: World) -> float:
            return followed(setup, watched, world.draw, found)

        symbol = asked_as(context, question, read)
        script.add(asked_entry(symbol, question, "s"))
        args: dict[str, Argument] = {"lines": tuple(lines)}
        assert found.time is not None
        script.line(symbol, tidy(found.time), why=why, args=args, uses=tuple(lines), when="never")
    return script.stages


def _by_law(
    context: Context, script: Script, watched: Measure, c: Coordinate | None, method: Method
) -> tuple[str, list[int]]:
    """An acceleration that is linear in the coordinate, and in its rate; or those of all coordinates of a sum."""
    model, motion = context.setup.model, context.setup.motion
    value = model.value_of(watched)
    inside = [c] if c else [k for k in model.coordinates if k.index in model.field.ingredients(value)]
    unknowns = [model.accelerations[model.coordinates.index(k)] for k in inside]
    found = by_method(context, script, unknowns, method)
    law = motion.law_of(c, takes_side=True) if c else motion.law_of_sum(value)
    assert law is not None
    return f"period.{law.key}", [found[unknown][1] for unknown in unknowns]


def _by_energy(context: Context, script: Script, c: Coordinate, found: Reached) -> tuple[str, list[int]]:
    """The time there and back, or of a whole turn, as an elliptic integral."""
    law = found.integral
    assert law is not None
    lines = first_integral(context, script)
    lines += tell_momenta(script, context.setup.motion.integrals_of(c), c, lines, "start")
    with script.stage("stage.integration", "hint.integration"):
        say_first_integral(context, script, c)
        square = square_line(context, script, c, lines, "start")
        say_integral(script, c, law, context.setup.model.field, square)
    return ("period.swings" if law.highest is not None else "period.turns_over"), [square]
