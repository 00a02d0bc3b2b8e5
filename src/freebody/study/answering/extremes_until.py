"""The greatest and the least value of a quantity from the start of a smooth motion to an event: at one of these, or
where its slope vanishes between them."""

from __future__ import annotations

from collections.abc import Sequence

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.present.lines import number_text
from freebody.questions.base import Quantity
from freebody.questions.event import AskedEvent
from freebody.questions.extent import ExtremeOfMotion
from freebody.study.answering.crosscheck import MOTION_TOLERANCE, CrossCheck, broken
from freebody.study.answering.draws import Draw
from freebody.study.answering.extent import LONGEST, kept_on_the_way
from freebody.study.answering.finding import Finding, NotHere
from freebody.study.answering.in_size import more_in_size
from freebody.study.answering.motion_extremes import along_until
from freebody.study.answering.motion_values import extremes_between, insist_held
from freebody.study.answering.repeated import checked
from freebody.study.answering.witness import motion_to, patience
from freebody.study.setup import Setup
from freebody.symbolic.conditions import Condition
from freebody.symbolic.reached import Reached
from freebody.tolerances import ROUND_OFF


def find(
    setup: Setup, question: str, q: ExtremeOfMotion, event: AskedEvent, reached: Reached, needs: Sequence[Condition]
) -> Finding:
    """The closed form. needs: for the event to come."""
    seen = along_until(setup, q.of, reached)
    chosen = seen.best(seen.candidates(), q.side)
    conditions = [*needs, *seen.conditions, *kept_on_the_way(setup, reached)]
    value = seen.value_of(chosen)
    check = CrossCheck(question, Message("numerical integration from the start to the event"), MOTION_TOLERANCE)

    def number(draw: Draw) -> float:
        return extreme_in_numbers(setup, draw, q, event)

    def parts(draw: Draw) -> float:  # what is nearly zero at its least has the errors of what it is beside
        return max(map(abs, _extremes_in_numbers(setup, draw, q, event)))

    evidence = checked(setup, check, value, conditions, number, parts)
    if evidence is None:
        missed = ", ".join(broken(setup, conditions))
        raise NotHere(Message("it is not largest or least there at the model's own values: that needs {x}", x=missed))
    note = seen.where(Message("largest") if q.side > 0 else Message("least"), chosen)
    notes = [note, *said_of_sign(setup, q, event), *reached.notes]
    return Finding(value, evidence, conditions, notes, list(reached.says))


def said_of_sign(setup: Setup, q: Quantity, event: AskedEvent) -> tuple[str, ...]:
    """How large that gets which is never positive at the given numbers: its greatest value has the least size."""
    assert isinstance(q, ExtremeOfMotion)
    if q.side < 0 or not setup.has_values:
        return ()
    try:
        low, high = _extremes_in_numbers(setup, setup.draws[0], q, event)
    except CannotAnswer:
        return ()
    is_turned = high <= ROUND_OFF * abs(low) and low < 0
    return (more_in_size(f"{number_text(-low)} {q.unit}".rstrip()),) if is_turned else ()


def extreme_in_numbers(setup: Setup, draw: Draw, q: ExtremeOfMotion, event: AskedEvent) -> float:
    """The same by the numeric route. Raises CannotAnswer where the event does not come."""
    low, high = _extremes_in_numbers(setup, draw, q, event)
    return high if q.side > 0 else low


def _extremes_in_numbers(setup: Setup, draw: Draw, q: ExtremeOfMotion, event: AskedEvent) -> tuple[float, float]:
    start = draw.start()
    end = motion_to(draw.reference, start, patience(start, LONGEST), event).time
    insist_held(setup, draw, start.t, end)
    return extremes_between(setup, draw, q.of, start.t, end)
