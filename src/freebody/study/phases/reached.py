"""From which side a phase comes to an event: what is asked for, and the blows that are still to come.

An event is the zero of a difference, a measure less a value or the time that is left. As a function that stays positive
until then it has the sign that it has when the phase begins, or where it is zero there, right after that; where the
sign depends on the parameters, the sets are parted by it.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.questions.clock import Clock
from freebody.questions.event import AskedEvent, Peak
from freebody.questions.event_base import QuestionEvent
from freebody.study.answering.sizes import is_size
from freebody.study.phases.home import Home
from freebody.study.phases.nodes import PhaseNode
from freebody.study.phases.numbers import Chosen
from freebody.study.phases.phase import Phase, PhaseWatch
from freebody.study.phases.quantities import value_in_mode
from freebody.symbolic.conditions import Condition
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy
from freebody.tolerances import ROUNDED

STRIKES = "strikes"  # the kind of a watch for a blow
Side = tuple[
    PhaseWatch | None, Chosen, list[Condition]
]  # with the sets for which it is that side, and what makes it so
Sides = tuple[tuple[PhaseWatch, ...], Chosen, list[Condition]]
_ORDERS = 3  # derivatives that are looked at where it begins at zero


def sides(home: Home, phase: Phase, event: AskedEvent, began: Ratio | None, kind: str, left: Chosen) -> Iterator[Side]:
    """The distance from an event, positive when the phase begins. began: when it does, since the start, in the home
    field; None where that has no closed form. left: the sets to look at; those for which the distance is zero all
    along come last, without a watch."""
    x = difference = _distance(home, phase, event, began)
    place, n = Message("'{event}' is reached from this side", event=event.text), len(left)
    for _order in range(_ORDERS):
        at_first = home.to_home(phase, phase.start_instant.here(phase.model.in_independent_speeds(x)))
        numbers = home.numbers(at_first)[left]
        for sign in (1, -1):
            mine = left[sign * numbers > ROUNDED]
            if len(mine):
                given = home.conditions([(sign * at_first, ">", place)], mine) if len(mine) < n else []
                yield PhaseWatch(kind, event.text, sign * difference), mine, given
        left = left[~(abs(numbers) > ROUNDED)]
        if not len(left):
            return
        x = phase.model.field.substitute(phase.model.rate(x), phase.model.dynamics.solved_accelerations)
    yield None, left, []


def rate_of(home: Home, phase: Phase, event: QuestionEvent) -> Ratio:
    """How fast what turns back at an event changes in a phase: a measure, or a quantity of the state. Of a size, as a
    speed is, its square tells: it has a rate at rest, too, and grows and falls with it."""
    if not isinstance(event, Peak):
        return phase.state.rate(event.measure)
    f, model = phase.model.field, phase.model
    value: Any = value_in_mode(event.quantity, home.system, phase.system, phase.state)
    if isinstance(value, tuple):
        raise CannotAnswer(Message("it has several components; ask for one of them"))
    x = model.in_independent_speeds(f.lowest_terms(f.element(value)))
    if is_size(model, x, *model.coordinates):
        x = f.lowest_terms(x * x)
    rate = model.rate(x)
    return f.substitute(rate, model.dynamics.solved_accelerations)


def _distance(home: Home, phase: Phase, event: AskedEvent, began: Ratio | None) -> Ratio:
    geometry = phase.model.geometry
    if isinstance(event, Peak):
        return rate_of(home, phase, event)
    if not isinstance(event, Clock):
        value = phase.state.rate(event.measure) if event.order == 1 else phase.state.value(event.measure)
        return value - geometry.scalar(event.value)
    if event.time is None:
        raise CannotAnswer(Message("what is tended to as the time grows is found only where one law of motion holds"))
    if began is None:
        raise CannotAnswer(Message("how long a phase before that lasts has no closed form"))
    return geometry.scalar(event.time) - geometry.scalar(tidy(began)) - geometry.field.time


def pending(home: Home, node: PhaseNode, left: Chosen) -> list[Sides]:
    """The blows that are still to come in a phase, by the sides from which it comes to them."""
    found: list[Sides] = [((), left, [])]
    for blow in home.system.blows:
        if blow.name not in node.phase.mode.past:
            found = [
                (watches if watch is None else (*watches, watch), mine, [*given, *more])
                for watches, sets, given in found
                for watch, mine, more in sides(home, node.phase, blow.event, node.began, STRIKES, sets)
            ]
    return found
