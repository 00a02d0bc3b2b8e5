"""What has no formula in one piece that anybody could make, answered by a chain of named sub-formulas."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from functools import partial

from freebody.errors import CannotAnswer, ExpressionError, SaysNothing
from freebody.language.sentences import Message
from freebody.numeric.snapshot import Snapshot
from freebody.questions.event import AskedEvent
from freebody.questions.reading import Question
from freebody.study.answering import loops
from freebody.study.answering.answer import Answer, Evidence, made
from freebody.study.answering.chain import chain_alone, inputs, is_assembled
from freebody.study.answering.conditions import at_instant, is_kinematic
from freebody.study.answering.crosscheck import (
    MOTION_TOLERANCE,
    CrossCheck,
    NotReal,
    element_at,
    holds,
)
from freebody.study.answering.draws import Draw
from freebody.study.answering.evidence import at_instants
from freebody.study.answering.named_formulas import InNames
from freebody.study.answering.numbers import at_event
from freebody.study.setup import Setup
from freebody.symbolic.conditions import Condition
from freebody.symbolic.reached import Reached
from freebody.symbolic.state import SymbolicState
from freebody.symbolic.validity import texts, validity


def answer_in_names(setup: Setup, question: Question, reached: Reached | None = None) -> Answer | None:
    """Of what is asked of an instant, or of an event to which drives lead at a known time; None for other questions.
    Raises CannotAnswer where the chain has no formulas either."""
    q = question.quantity
    if not q.is_of_state or q.wanted is not None or question.options:
        return None
    if question.event is not None:
        return None if reached is None else _led_to(setup, question, question.event, reached)
    state = setup.start_for(q) if question.at_start else setup.state
    found = chain_alone(setup, q, state)
    if found is None:
        return None
    exact = partial(in_numbers, setup, found)
    return told(setup, question, found, at_instants(setup, question.text, q, exact, at_start=question.at_start))


def _led_to(setup: Setup, question: Question, event: AskedEvent, reached: Reached) -> Answer | None:
    """Where drives leave nothing free, at the time at which they are there."""
    q, time = question.quantity, reached.time
    if setup.model.coordinates or time is None:
        return None
    state = SymbolicState(setup.model, setup.motion.known_at(reached))
    found = chain_alone(setup, q, state)
    if found is None:
        return None
    needs = [Condition(setup.state.here(x), relation, event.comes) for x, relation in reached.conditions]
    check = CrossCheck(question.text, Message("numerical integration from the start to the event"), MOTION_TOLERANCE)

    def compare(draw: Draw) -> None:
        start = draw.start()
        exact, until = in_numbers(setup, found, draw, start), 1.5 * element_at(setup, (time,), draw, start)[0]
        if until > 0.0 and all(holds(setup, c, draw, start) for c in needs):
            check.compare(draw, exact, at_event(setup, q, draw, start, until, event))

    evidence = check.gather(setup.draw_stream(), compare).evidence()
    return told(setup, question, found, evidence, [c.text() for c in validity(needs)])


def told(setup: Setup, question: Question, found: InNames, evidence: Evidence, says: Sequence[str] = ()) -> Answer:
    """The answer that a chain is. says: conditions in words."""
    q, is_of_event = question.quantity, question.event is not None
    state = setup.start_instant if question.at_start else setup.state
    judges_contacts = bool(setup.system.applied_loads) or not is_kinematic(setup, q)
    needed = at_instant(setup, question, state, with_contacts=judges_contacts and not is_of_event)
    if not setup.closing(state):
        says = [*says, *found.closing]
    if is_of_event:  # what is divided by must not vanish there
        says = [*says, *(c.text() for c in validity(found.needs))]
    else:
        needed = [*needed, *found.needs]
    needed = setup.in_free_coordinates(needed, state, loops.SHORT)
    notes = [*loops.loops_in(setup, (), None, found.chain), Message("in one piece the formula would be too long")]
    result, value = found.chain.result, _value(setup, found)
    return made(
        question,
        result if len(result) > 1 else next(iter(result)),
        value if value is None or len(result) > 1 else next(iter(value)),
        conditions=[*says, *texts(needed, until_event=is_of_event)],
        notes=notes,
        evidence=evidence,
        chain=found.chain,
    )


def in_numbers(setup: Setup, found: InNames, draw: Draw, snapshot: Snapshot) -> tuple[float, ...]:
    """A chain at a snapshot. Raises SaysNothing."""
    if not is_assembled(setup, found, draw, snapshot):
        raise SaysNothing(Message("at these numbers the loops are assembled in another way"))
    try:
        return found.chain.numbers(inputs(setup, setup.model.samples.numbers(draw.sample(snapshot), draw.sample())))
    except (ArithmeticError, ValueError, ExpressionError):
        raise NotReal(Message("a part of the closed form has no real value here")) from None


def _value(setup: Setup, found: InNames) -> tuple[float, ...] | None:
    if not setup.has_values:
        return None
    draw = setup.draws[0]
    with suppress(CannotAnswer):
        return in_numbers(setup, found, draw, draw.start())
    return None
