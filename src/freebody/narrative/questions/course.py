"""Questions about an event: from the acceleration to the motion, and to the instant at which a measure has its value.

Three ways, as the solver goes them: constant acceleration (velocity, place, the root that is meant), an acceleration
linear in the coordinate (harmonic or exponential), else the energy integral from the start to the event.
"""

from __future__ import annotations

from dataclasses import replace

from freebody.errors import CannotAnswer
from freebody.language.expression import Symbol
from freebody.language.sentences import Argument, Message
from freebody.narrative.context import Context, Method
from freebody.narrative.lines.script import DerivationStage
from freebody.narrative.principles.momentum import by_method
from freebody.narrative.questions.course_by_energy import lines_by_energy, time_by_energy
from freebody.narrative.questions.course_by_law import law_lines, lines_by_law
from freebody.narrative.questions.event_way import (
    TIME,
    AtEvent,
    EventWay,
    coordinates_asked,
    event_means,
    tell_asked,
)
from freebody.narrative.questions.initial import tell_start
from freebody.questions.event_base import QuestionEvent
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer
from freebody.study.answering.extent import kept_on_the_way
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy
from freebody.symbolic.unknowns import Coordinate


def derive(context: Context, question: Question, answer: Answer, method: Method) -> list[DerivationStage]:
    """The derivation of a quantity at an event. Raises CannotAnswer where the solver has no formula either."""
    with context.setup.motion.on_one_side():
        return _derived(context, question, answer, method)


def _derived(context: Context, question: Question, answer: Answer, method: Method) -> list[DerivationStage]:
    event = question.event
    assert isinstance(event, QuestionEvent)
    setup = context.setup
    reached = setup.motion.reach(event)
    c = reached.coordinate
    context.glossary.at_event(event, sides=[] if c is None else kept_on_the_way(setup, reached))
    if c is None and not setup.model.coordinates:
        return _driven(AtEvent(context, context.script(), question, reached), method)
    if c is None:
        return _together(AtEvent(context, context.script(), question, reached), method)
    script = context.script()
    by_energy = reached.time is None or reached.integral is not None or method == "energy"
    if by_energy and reached.time is not None and reached.integral is None and question.quantity.is_of_event:
        raise CannotAnswer(Message("energy tells the speed, not the time; there is: auto, newton, lagrange"))
    way = EventWay(context, script, question, reached, c, setup.motion.acceleration(c), 0)
    if not by_energy:
        is_of_measure = question.quantity.scope != "course" or hasattr(question.quantity, "measure")
        others = coordinates_asked(context, question) if is_of_measure else []
        named = [c, *(o for o in others if o is not c and setup.motion.law_of(o, takes_side=True) is not None)]
        unknowns = [setup.model.accelerations[setup.model.coordinates.index(o)] for o in named]
        found = by_method(context, script, unknowns, method)
        way, *beside = (
            replace(
                way, coordinate=o, acceleration=setup.motion.acceleration(o), line=_on_the_way(way, o, *found[unknown])
            )
            for o, unknown in zip(named, unknowns, strict=True)
        )
        way.beside = beside
    if reached.integral is not None and question.quantity.is_of_event:
        lines = time_by_energy(way)
    else:
        lines = lines_by_energy(way) if by_energy else lines_by_law(way)
    tell_asked(way, lines)
    return script.stages


def _on_the_way(way: EventWay, c: Coordinate, value: Ratio, line: int) -> int:
    """The line of an acceleration that is constant on the way, though it is not in general: because other coordinates
    that stand in it stay at rest."""
    setup, script, f = way.context.setup, way.script, way.context.setup.model.field
    there = setup.motion.acceleration(c)
    inside = f.ingredients(value)
    others = [k for k in setup.model.coordinates if inside & {k.index, k.speed}]
    if not others or not there.is_constant():
        return line
    with script.stage("stage.integration", "hint.integration"):
        tell_start(way.context, script, {x for k in others for x in (k.index, k.speed)})
        if c not in others and all(setup.start.of(k.speed).is_zero() for k in others):
            script.say("course.at_rest", names=tuple(Symbol(k.name) for k in others))
        symbol = tidy(f.variable(setup.model.accelerations[setup.model.coordinates.index(c)]))
        args: dict[str, Argument] = {"line": line}
        return script.line(symbol, tidy(there), why="course.on_the_way", args=args, uses=(line,), when="event")


def _together(asked: AtEvent, method: Method) -> list[DerivationStage]:
    """Of an event in several coordinates, each of which moves by a law of its own: when their functions of the time
    meet it."""
    context, script, reached, event = asked.context, asked.script, asked.reached, asked.question.event
    assert isinstance(event, QuestionEvent)
    model, motion = context.setup.model, context.setup.motion
    value = model.field.lowest_terms(
        context.setup.state.rate(event.measure) if event.order else model.value_of(event.measure)
    )
    inside = model.field.ingredients(value)
    meant = [k for k in model.coordinates if inside & {k.index, k.speed}]
    is_counted = asked.question.quantity.scope == "course"
    others = [k for k in ([] if is_counted else coordinates_asked(context, asked.question)) if k not in meant]
    named = [*meant, *others]
    if reached.time is None or any(motion.law_of(k, takes_side=True) is None for k in named):
        raise CannotAnswer(
            Message("a measure of several coordinates that move independently is told without a derivation")
        )
    unknowns = [model.accelerations[model.coordinates.index(k)] for k in named]
    found = by_method(context, script, unknowns, method)
    lines: list[int] = []
    with script.stage("stage.integration", "hint.integration"):
        for k, unknown in zip(named, unknowns, strict=True):
            acceleration = motion.acceleration(k)
            lines += law_lines(EventWay(context, script, asked.question, reached, k, acceleration, found[unknown][1]))
    with script.stage("stage.event", "hint.event"):
        args: dict[str, Argument] = {"event": f"@{event.text}"}
        at = script.line(tidy(value), event.value, why="course.event", args=args, when="event")
        args = {"lines": (*lines, at)}
        uses = (*lines, at)
        time = script.line(TIME, tidy(reached.time), why="course.first_time", args=args, uses=uses, when="event")
    tell_asked(asked, [*lines, time])
    return script.stages


def _driven(asked: AtEvent, method: Method) -> list[DerivationStage]:
    """Of a motion that is given as a function of the time."""
    event, script = asked.question.event, asked.script
    assert isinstance(event, QuestionEvent)
    assert asked.reached.time is not None
    with script.stage("stage.event", "hint.event"):
        lines = event_means(asked)
        args: dict[str, Argument] = {"event": f"@{event.text}"}
        time = tidy(asked.reached.time)
        lines.append(script.line(TIME, time, why="course.event", args=args, uses=tuple(lines), when="event"))
    tell_asked(asked, lines)
    return script.stages
