"""Questions about an instant by the clock, or about what a motion tends to: every coordinate by its law of motion."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress

from freebody.errors import CannotAnswer
from freebody.language.expression import Symbol
from freebody.language.sentences import Message
from freebody.model.states import shown_rate
from freebody.narrative.context import Context, Method
from freebody.narrative.lines.script import DerivationStage, Script, ready
from freebody.narrative.principles.momentum import by_method
from freebody.narrative.principles.motion_equations import motion_equations
from freebody.narrative.questions.course_by_law import law_lines
from freebody.narrative.questions.event_way import TIME, AtEvent, EventWay, coordinates_asked, tell_asked
from freebody.narrative.steady.polynomial import tell_polynomial
from freebody.questions.clock import Clock
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer
from freebody.symbolic.conditions import Condition, require
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.reached import Reached
from freebody.symbolic.state import SymbolicState
from freebody.symbolic.tidy import tidy
from freebody.symbolic.unknowns import Coordinate


def derive(context: Context, question: Question, answer: Answer, method: Method) -> list[DerivationStage]:
    """The derivation. Raises CannotAnswer where the solver has no formula either."""
    event, setup = question.event, context.setup
    assert isinstance(event, Clock)
    if method == "energy":
        raise CannotAnswer(Message("energy does not tell of the time; there is: auto, newton, lagrange"))
    model = setup.model
    reached = setup.motion.at_clock(None if event.time is None else model.geometry.scalar(event.time))
    context.glossary.at_event(event, reached.settled, _sides(context, question, reached), reached.decays)
    script = context.script()
    asked = coordinates_asked(context, question)
    lines: list[int] = []
    if reached.decays and (settling := [c for c in asked if setup.motion.law_of(c, takes_side=True) is None]):
        lines += _dying_out(context, script, reached)
        by_law = [c for c in asked if c not in settling]
    else:
        by_law = asked
    if by_law and not setup.motion.stands_still:
        unknowns = [model.accelerations[model.coordinates.index(c)] for c in by_law]
        found = by_method(context, script, unknowns, method)
        with script.stage("stage.integration", "hint.integration"):
            for c, unknown in zip(by_law, unknowns, strict=True):
                lines += law_lines(_way(context, script, question, reached, c, found[unknown][1]))
    with script.stage("stage.event", "hint.event"):
        if setup.motion.stands_still:
            script.say("course.still")
            lines += [_value(context, script, reached, c) for c in asked]
        elif reached.time is not None:
            lines.append(script.line(TIME, tidy(reached.time), why="course.clock", when="event"))
        else:
            lines = _limits(context, script, reached, asked if by_law is asked else model.coordinates, lines)
    tell_asked(AtEvent(context, script, question, reached), lines)
    return script.stages


def _dying_out(context: Context, script: Script, reached: Reached) -> list[int]:
    """Of what is linear and has no function of the time of its own: the equations, the polynomial of the exponents of
    its free motion, and what makes that die out, so that what is left stays as it is."""
    with script.stage("unclosed.equations", "unclosed.equations_hint"):
        lines = [row.number for row in motion_equations(context, script)]
    with script.stage("stage.dying_out", "hint.dying_out"):
        script.say("course.exponents", lines=tuple(lines))
        for polynomial in dict.fromkeys(reached.decays):
            tell_polynomial(script, polynomial)
        needs = [require(x, relation, "")[0] for x, relation in reached.conditions]
        told = tuple(ready(c.text()) for c in needs if c is not None)
        script.say("course.dies_out" if told else "course.dies_out_always", conditions=told)
    return lines


def _way(context: Context, script: Script, question: Question, reached: Reached, c: Coordinate, line: int) -> EventWay:
    return EventWay(context, script, question, reached, c, context.setup.motion.acceleration(c), line)


def _sides(context: Context, question: Question, reached: Reached) -> list[Condition]:
    """What parameters decide, and formulas have as it is at the model's own numbers."""
    model = context.setup.model
    with suppress(CannotAnswer):  # of what is counted on the way no instant has a value
        question.quantity.value(context.system, SymbolicState(model, context.setup.motion.known_at(reached)))
    return [Condition(x, ">", "") for x in (*model.samples.assumed, *(need for need, _relation in reached.conditions))]


def _value(context: Context, script: Script, reached: Reached, c: Coordinate) -> int:
    value: Ratio = context.setup.motion.known_at(reached)[c.index]
    return script.line(Symbol(c.name), tidy(value), when="event")


def _limits(
    context: Context, script: Script, reached: Reached, asked: Sequence[Coordinate], lines: list[int]
) -> list[int]:
    """What the coordinates and their rates tend to."""
    f, values, uses = context.setup.model.field, SymbolicState(context.setup.model, reached.limits).values, tuple(lines)
    found: list[int] = []
    for c in asked:
        for symbol, generator in ((Symbol(c.name), c.index), (shown_rate(c.name), c.speed)):
            if (value := values.get(generator)) is not None:
                right, args = tidy(f.lowest_terms(value)), {"lines": uses}
                found.append(script.line(symbol, right, why="course.endless", args=args, uses=uses, when="event"))
    return found
