"""What is tended to as the time grows, in the phases that nothing ends: the limits of their laws of motion."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.questions.clock import Clock
from freebody.questions.reading import Question
from freebody.study.answering.finding import NO_FORM, why
from freebody.study.phases.branch import AnswerBranch, branch_at, signs_taken, where_so
from freebody.study.phases.ends import FirstEvent
from freebody.study.phases.nodes import PhaseEnd, WayToPhase
from freebody.study.phases.passage import elements_in
from freebody.study.phases.phase import Phase, PhaseWatch
from freebody.study.phases.tree import PhaseTree
from freebody.symbolic.laws.base import MotionLaw
from freebody.symbolic.laws.uniform import UniformLaw
from freebody.symbolic.phases.course import CourseZero, LawMotion, UniformMotion
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.state import SymbolicState


def in_the_end(
    tree: PhaseTree, question: Question, event: Clock, ways: list[WayToPhase], met: list[str]
) -> Iterator[AnswerBranch]:
    """In the last phase of every way; `met` collects why there is no value on some of them."""
    for way in ways:
        for edge in way.last.edges:
            if edge.first is None and not edge.stops:
                try:
                    yield _settled(tree, question, event, way, edge)
                except NO_FORM as error:
                    met.append(why(tree.system, error))
            elif edge.stops:
                met.append(edge.stops)
            for after in edge.nodes:
                yield from in_the_end(tree, question, event, [way.on(edge, after)], met)
        if way.last.reason:
            met.append(way.last.reason)


def _settled(tree: PhaseTree, question: Question, event: Clock, way: WayToPhase, edge: PhaseEnd) -> AnswerBranch:
    phase = way.last.phase
    values, latest = _limits(phase)
    with signs_taken(tree, phase) as taken:
        there = elements_in(tree, phase, question.quantity, SymbolicState(phase.model, values))
    parts = there if isinstance(there, tuple) else (there,)
    f = phase.model.field
    moving = {g for c in phase.model.coordinates for g in (c.index, c.speed)} | {f.index(f.time)}
    if any(f.ingredients(x) & moving for x in parts):
        raise CannotAnswer(Message("that does not tend to anything as the time grows"))
    watch = PhaseWatch("is reached", event.text, f.one)
    first = FirstEvent(watch, CourseZero(latest, values))
    return branch_at(tree, question, way, first, [*edge.conditions, *taken], where_so(tree, taken, edge.sets))


def _limits(phase: Phase) -> tuple[dict[int, Ratio], Ratio]:
    """To what coordinates and speeds tend, by generator, and by when they are there but for round-off."""
    f, values, latest = phase.model.field, dict[int, Ratio](phase.still), phase.model.field.one
    for c, law in zip(phase.model.coordinates, _laws(phase), strict=False):
        limit = None if c.speed in phase.still else law.limit
        if limit is None:
            continue
        latest = latest + limit.time
        values |= {} if limit.place is None else {c.index: f.lowest_terms(limit.place)}
        values |= {} if limit.rate is None else {c.speed: f.lowest_terms(limit.rate)}
    return values, f.lowest_terms(latest)


def _laws(phase: Phase) -> Sequence[MotionLaw]:
    """By which the coordinates move, each by its own."""
    match phase.course:
        case LawMotion() as course:
            return course.laws
        case UniformMotion() as course:
            starts = [(course.start.of(c.index), course.start.of(c.speed), c.speed) for c in phase.model.coordinates]
            return [UniformLaw(phase.model, q, u, course.accelerations[speed]) for q, u, speed in starts]
        case _:
            return ()
