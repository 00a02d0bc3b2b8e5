"""A question without a closed form: the equations that the numeric route solves, and what remains to it and why."""

from __future__ import annotations

from contextlib import suppress

from freebody.errors import CannotAnswer
from freebody.narrative.context import Context, Derive, Method
from freebody.narrative.lines.script import DerivationStage, Script, ready
from freebody.narrative.principles.loops import all_bound, closed_loops, however_long
from freebody.narrative.principles.motion_equations import motion_equations
from freebody.questions.reading import Question
from freebody.study.answering.about_rest import is_given_pose
from freebody.study.answering.answer import Answer
from freebody.study.setup import Setup


def or_in_numbers(derive: Derive) -> Derive:
    """The same derivation; where it cannot be done since the solver has no formula either, the equations of motion, and
    of a pose that a chain tells those of the loops."""

    def derived(context: Context, question: Question, answer: Answer, method: Method) -> list[DerivationStage]:
        if answer.chain is not None and question.quantity.scope == "rest":
            return of_pose(context)
        try:
            return derive(context, question, answer, method)
        except CannotAnswer:
            if answer.chain is not None and answer.expression is not None and is_given_pose(context.setup):
                return of_pose(context)
            if answer.expression is not None or not answer.reason or not _is_plain(context) or _cannot_move(context):
                raise
            return in_numbers(context, answer)

    return derived


def of_pose(context: Context) -> list[DerivationStage]:
    """Of a machine that a load holds in a pose: the loops, and by which principles the names of the chain follow."""
    script = context.script()
    with script.stage("stage.solved_loops"):
        closed_loops(context.setup, script, limit=however_long)
        script.say("unclosed.pose")
    with script.stage("stage.value"):
        script.say("unclosed.balance")
    return script.stages


def _cannot_move(context: Context) -> bool:
    """Whether there is no motion to be followed."""
    with suppress(CannotAnswer):
        return context.acting.stands_still
    return False


def _is_plain(context: Context) -> bool:
    """Whether there are equations of motion that hold all the time."""
    return not context.system.bounds and not context.system.dry_friction


def in_numbers(context: Context, answer: Answer) -> list[DerivationStage]:
    """The equations of motion, and what is done with them in numbers."""
    script = context.script()
    try:
        with script.stage("unclosed.equations", "unclosed.equations_hint"):
            all_bound(context.setup, script)
            motion_equations(context, script)
    except CannotAnswer as error:
        with script.stage("unclosed.equations"):
            _constraints(context.setup, script, str(error))
    if answer.never:
        with script.stage("stage.value"):
            script.say("unclosed.never", reason=ready(answer.reason))
        return script.stages
    with script.stage("stage.numeric"):
        script.say("unclosed.why", reason=ready(answer.reason))
        script.say("unclosed.number" if answer.value is not None else "unclosed.simulate")
    return script.stages


def _constraints(setup: Setup, script: Script, reason: str) -> None:
    """Where even the speeds have no short formula: what is solved instead."""
    script.say("unclosed.no_coordinates", reason=ready(reason))
    script.say("unclosed.bodies", n=sum(6 if setup.system.space else 3 for _b in setup.system.moving))
    script.say("unclosed.rows", n=len(setup.system.constraint_rows))
