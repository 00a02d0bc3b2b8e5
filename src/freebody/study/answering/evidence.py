"""The second opinion: every closed form is evaluated at random admissible numbers and compared with the
numeric route, which shares only the statements of the measures. A disagreement is an error, never an answer."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from functools import partial

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.numeric.snapshot import Snapshot
from freebody.questions.base import Quantity
from freebody.questions.clock import Clock
from freebody.questions.event import AskedEvent
from freebody.study.answering.answer import Evidence
from freebody.study.answering.crosscheck import (
    INSTANT_TOLERANCE,
    MIN_DRAWS,
    MOTION_TOLERANCE,
    CrossCheck,
    broken,
    element_at,
    holds,
)
from freebody.study.answering.draws import Draw
from freebody.study.answering.finding import NotHere
from freebody.study.answering.magnitude import magnitude
from freebody.study.answering.numbers import at_event
from freebody.study.answering.witness import motion_to, patience
from freebody.study.mobility.centres import moving_for
from freebody.study.setup import Setup, rank_freedoms
from freebody.symbolic.conditions import Condition
from freebody.symbolic.laws.base import SETTLED
from freebody.symbolic.ratio import Ratio

InNumbers = Callable[[Draw, Snapshot], tuple[float, ...]]
LONGEST = 100.0  # [s] that a motion without a closed form of its time is followed


def at_instants(
    setup: Setup,
    question: str,
    quantity: Quantity,
    x: Ratio | tuple[Ratio, ...] | InNumbers,
    *,
    at_start: bool,
    sides: Sequence[Ratio] = (),
) -> Evidence:
    """Compares at the start, or at a general pose and motion, of every draw. sides: what is positive where closed loops
    are assembled as the formula has them. x: the formula, or what tells it in numbers."""
    route = (
        Message("floating-point solve of all bodies and constraints at the start")
        if at_start
        else Message("floating-point solve of all bodies and constraints at random poses and speeds")
    )
    check = CrossCheck(question, route, INSTANT_TOLERANCE)
    if at_start:
        instants = ((draw, moving_for(quantity, draw.start())) for draw in setup.draw_stream())
    else:
        instants = setup.anywhere_stream()

    def compare(instant: tuple[Draw, Snapshot]) -> None:
        draw, snapshot = instant
        if not setup.is_on_branch(draw, snapshot):  # where the formula does not claim to be true
            return
        if sides and not all(side > 0.0 for side in element_at(setup, tuple(sides), draw, snapshot)):
            return
        seen = draw.seen(snapshot)
        exact = x(draw, snapshot) if callable(x) else element_at(setup, x, draw, snapshot)
        check.compare(draw, exact, quantity.value(setup.system, seen), partial(magnitude, quantity.dimension, seen))

    return check.gather(instants, compare, len(setup.draws)).evidence()


def along_motion(
    setup: Setup,
    question: str,
    quantity: Quantity,
    event: AskedEvent,
    x: Ratio | tuple[Ratio, ...],
    time: Ratio | None,
    conditions: Sequence[Condition],
    signs: Sequence[Condition] = (),
    decays: Sequence[tuple[Ratio, ...]] = (),
) -> Evidence:
    """Integrates from the start to the event and compares the time, or the quantity there. conditions: without which
    the event does not come; signs: what the formula takes to be positive; decays: characteristic polynomials of what
    dies out until then."""
    check = CrossCheck(question, Message("numerical integration from the start to the event"), MOTION_TOLERANCE)

    def compare(draw: Draw) -> None:
        start = draw.start()
        exact = element_at(setup, x, draw, start)
        if not all(holds(setup, c, draw, start) for c in (*conditions, *signs)):
            return
        late = 1.0 if isinstance(event, Clock) else 1.5
        until = patience(start, LONGEST) if time is None else late * element_at(setup, (time,), draw, start)[0]
        until = max([until, *(died_out(element_at(setup, c, draw, start)) for c in decays)])
        if until > 0:
            numeric = at_event(setup, quantity, draw, start, until, event)
            check.compare(draw, exact, numeric, partial(magnitude, quantity.dimension, draw.seen(start)))

    check.gather(setup.draw_stream(), compare)
    is_short = len(check.pairs) < MIN_DRAWS and setup.has_values
    of_parameters = [c for c in signs if not c.element.field.ingredients(c.element) & setup.model.moving]
    if is_short and not broken(setup, conditions) and (missed := broken(setup, of_parameters)):
        needs = ", ".join(missed)
        raise NotHere(
            Message("a formula is found only for {needs}, and the given numbers do not keep to it", needs=needs)
        )
    # where neither the signs nor what they lead to are so, numbers tell whether the event comes
    is_open = not broken(setup, of_parameters) or _comes(setup, event)
    if is_short and is_open and (missed := broken(setup, signs)):
        raise NotHere(
            Message(
                "a formula is found only for motions that keep to {needs}, as at the start; this one does not do so "
                "until '{event}'",
                event=event.text,
                needs=", ".join(missed),
            )
        )
    if is_short and (missed := broken(setup, conditions)):
        needs = ", ".join(missed)
        if isinstance(event, Clock) and event.time is None:
            raise NotHere(Message("there is no limit at the model's own values: that needs {needs}", needs=needs))
        raise NotHere(
            Message(
                "'{event}' does not come at the model's own values: that needs {needs}",
                event=event.text,
                needs=needs,
            )
        )
    return check.evidence()


def died_out(polynomial: Sequence[float]) -> float:
    """[s] By when what has a characteristic polynomial, from the constant term up, has died out."""
    slowest = float(np.max(np.roots(polynomial[::-1]).real))
    return SETTLED / -slowest if slowest < 0.0 else 0.0


def _comes(setup: Setup, event: AskedEvent) -> bool:
    """Whether an event comes, at the model's own values."""
    draw = setup.draws[0]
    with suppress(CannotAnswer, ArithmeticError, ValueError):
        motion_to(draw.reference, draw.start(), patience(draw.start(), LONGEST), event)
        return True
    return False


def freedom(setup: Setup, question: str, dof: int) -> Evidence:
    """Coordinates minus the rank of the constraint Jacobian at random poses."""
    check = CrossCheck(question, Message("rank of the constraint Jacobian at random poses"), 1e-12)
    for draw, snapshot in zip(setup.draws, _general(setup), strict=True):
        check.compare(draw, (float(dof),), (float(rank_freedoms(snapshot)),))
    return check.evidence()


def rank_freedom(setup: Setup) -> int:
    """Degrees of freedom by rank alone: the fewest of all draws."""
    return min(rank_freedoms(snapshot) for snapshot in _general(setup))


def _general(setup: Setup) -> list[Snapshot]:
    try:
        return setup.anywhere
    except CannotAnswer:  # without formulas there is no branch to be on
        return [draw.anywhere(k, 0.3, 0.1) for k, draw in enumerate(setup.draws)]
