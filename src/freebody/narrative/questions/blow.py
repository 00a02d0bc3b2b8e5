"""The blow at the start: impulse and momentum, and what is asked of the blow itself."""

from __future__ import annotations

from collections.abc import Callable
from functools import singledispatch

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, Symbol, add, n_operations, negate
from freebody.language.sentences import Argument, Message
from freebody.narrative.context import Context, Method, refuse
from freebody.narrative.lines.naming import asked_entry, asked_symbol, side_of, written
from freebody.narrative.lines.script import DerivationStage, Script
from freebody.narrative.principles.formal import elements
from freebody.questions.base import Quantity
from freebody.questions.blow import EnergyLostInBlow
from freebody.questions.energy import Energy
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer
from freebody.symbolic.blow import Blow
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy

MOST_OPERATIONS = 40  # of a kinetic energy that is written out


def tell_blow(context: Context, script: Script) -> tuple[int, ...]:
    """The momenta before and after the blow, coordinate by coordinate, and the speeds that follow; the lines of these.
    Raises CannotAnswer where there are none in formulas."""
    system, setup = context.setup.system, context.setup
    blow = setup.start_instant.blow
    f = setup.model.field
    closing = tuple(dict.fromkeys(row.connection for row in system.constraint_rows if row.closes))
    striking = tuple(dict.fromkeys(push.load for push in system.impulses))
    with script.stage("stage.blow", "hint.blow"):
        if striking:
            script.say("blow.strikes", names=striking)
        if closing:
            script.say("blow.closes", names=closing)
        script.say("blow.before")
        lines = tell_momenta(script, setup.model, blow, tidy)
        uses, found = tuple(lines), list[int]()
        for c in setup.model.coordinates if lines else ():
            sides = tidy(f.variable(c.speed)), tidy(blow.speeds[c.speed])
            found.append(script.line(*sides, why="blow.solved", args={"lines": uses}, uses=uses, when="start"))
    return tuple(found)


@singledispatch
def _difference(q: Quantity, context: Context) -> tuple[Expr, ...]:
    """The answer in the speeds after the blow, where it is a difference of what was before and is after."""
    return ()


@_difference.register(EnergyLostInBlow)
def _lost(q: EnergyLostInBlow, context: Context) -> tuple[Expr, ...]:
    setup = context.setup
    f, blow = setup.model.field, setup.start_instant.blow
    after = f.lowest_terms(f.element(Energy("kinetic").value(setup.system, setup.state)))
    if q.of or n_operations(tidy(after)) > MOST_OPERATIONS:
        return ()
    return (add(tidy(blow.energy_before), negate(tidy(after))),)


def tell_momenta(
    script: Script, model: SymbolicModel, blow: Blow, shown: Callable[[Ratio], Expr], before: tuple[int, ...] = ()
) -> list[int]:
    """Of each coordinate that has one, the line of the momentum that belongs to it: after the blow, and what the motion
    before and the impulses bring. shown: how this is written; before: lines of the motion just before."""
    lines: list[int] = []
    for c, (after, brought) in zip(model.coordinates, blow.balances, strict=True):
        if after.is_zero() and brought.is_zero():
            continue
        script.say("blow.balance", name=Symbol(c.name))
        lines.append(script.line(tidy(after), shown(brought), uses=before, when="start"))
    return lines


def derive(context: Context, question: Question, answer: Answer, method: Method) -> list[DerivationStage]:
    """The derivation of what belongs to the blow. Raises CannotAnswer where the solver has no formula."""
    if answer.expression is None:
        raise CannotAnswer(answer.reason or Message("there is no closed form"))
    refuse(method, (), Message("what belongs to the blow"))
    setup = context.setup
    parts = elements(setup.model.field, question.quantity.value(setup.system, setup.start_instant))
    script = context.script()
    name = asked_symbol(context, question, len(parts))
    with script.stage("stage.value", "hint.value"):
        script.say("blow.whole" if question.quantity.is_of_whole else "blow.body_by_body")
        script.add(asked_entry(name, question, n=len(parts)))
        sides = (side_of(name, len(parts)), *_difference(question.quantity, context), written(parts))
        given = context.after_blow
        args: dict[str, Argument] = {"lines": given}
        script.line(*sides, why="value.follows" if given else "blow.follows", args=args, uses=given, when="start")
    return script.stages
