"""Extremes of a quantity that is linear in a damped coordinate and its rate, which moves by the same law:

    x'' = -w0^2 (x - C) - 2 d x',    y = a + b x + c x'    =>    y'' = -w0^2 (y - a - b C) - 2 d y'.

So the greatest speed of what is damped is where the speed turns, as a place is. Beyond its first turn what dies away
does not get on that side; y(0) and y'(0) = b x'(0) + c x''(0) tell which side that is. Source: Magnus & Popp,
Schwingungen, 7th ed. 2005, sec. 2.2.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from freebody.errors import CannotAnswer, NeverHappens
from freebody.language.sentences import Message
from freebody.present.lines import number_text
from freebody.questions.base import Quantity
from freebody.study.answering.crosscheck import MOTION_TOLERANCE, CrossCheck, broken, element_at
from freebody.study.answering.draws import Draw
from freebody.study.answering.finding import Finding, NotHere
from freebody.study.answering.in_size import more_in_size
from freebody.study.answering.motion_values import extremes_between
from freebody.study.answering.repeated import checked, held_throughout, taken_throughout
from freebody.study.setup import Setup
from freebody.symbolic.conditions import Condition, insisted
from freebody.symbolic.law_ranges import extent_by_law
from freebody.symbolic.laws.damped import Damped
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.reached import Reached
from freebody.symbolic.unknowns import Coordinate

_BEYOND = Fraction(5, 2)  # times to the turn that are looked at in numbers


@dataclass(frozen=True)
class DampedQuantity:
    """The law by which it moves. is_size: whether its size is meant."""

    law: Damped
    is_size: bool


def damped_of(setup: Setup, of: Quantity) -> DampedQuantity | None:
    """How a quantity of the state dies away with the one coordinate that it depends on; None where it does not."""
    model, f = setup.model, setup.model.field
    value = of.value(setup.system, setup.state)
    if isinstance(value, tuple):
        return None
    x = f.lowest_terms(model.in_independent_speeds(f.element(value)))
    moving = {c.index: c for c in model.coordinates} | {c.speed: c for c in model.coordinates}
    inside = {moving[g] for g in f.ingredients(x) & moving.keys()}
    if len(inside) != 1 or not isinstance(law := setup.motion.law_of(c := inside.pop(), takes_side=True), Damped):
        return None
    if (linear := _linear(setup, x, c)) is not None:
        return DampedQuantity(_followed(law, *linear), is_size=False)
    slope = f.lowest_terms(x * x / (f.variable(c.speed) * f.variable(c.speed)))
    if not slope.is_constant():
        return None
    root = f.sqrt(slope, model.samples.is_negative)
    return DampedQuantity(_followed(law, f.zero, f.zero, root), is_size=True)


def _linear(setup: Setup, x: Ratio, c: Coordinate) -> tuple[Ratio, Ratio, Ratio] | None:
    """(a, b, c) of a + b q + c u with constant parts."""
    f = setup.model.field
    slopes = [f.lowest_terms(f.partial(x, g)) for g in (c.index, c.speed)]
    rest = f.lowest_terms(x - slopes[0] * f.variable(c.index) - slopes[1] * f.variable(c.speed))
    parts = (rest, *slopes)
    return parts if all(part.is_constant() for part in parts) else None  # pyrefly: ignore[bad-return]


def _followed(law: Damped, rest: Ratio, of_place: Ratio, of_rate: Ratio) -> Damped:
    """The law of a + b x + c x'."""
    short = law.model.field.lowest_terms
    acceleration = -law.square * (law.q0 - law.center) - 2 * law.delta * law.u0
    return replace(
        law,
        q0=short(rest + of_place * law.q0 + of_rate * law.u0),
        u0=short(of_place * law.u0 + of_rate * acceleration),
        center=short(rest + of_place * law.center),
    )


def find(setup: Setup, question: str, of: Quantity, damped: DampedQuantity, sides: Sequence[int]) -> Finding:
    """The closed form. sides: -1 for the least value, +1 for the greatest, in the order in which they are wanted."""
    f = setup.model.field
    found = [_size(damped.law) if damped.is_size else extent_by_law(damped.law, "it", side) for side in sides]
    if damped.is_size and set(sides) != {1}:
        raise CannotAnswer(Message("no closed form was found for how far it gets"))
    values = tuple(f.lowest_terms(reached.at) for reached in found)
    needs = (Condition(x, r, Message("it turns")) for reached in found for x, r in reached.conditions)
    never = NeverHappens(Message("it does not turn"))
    conditions = [*insisted(needs, never), *taken_throughout(setup), *held_throughout(setup)]
    limit = damped.law.limit
    assert limit is not None  # what is driven away has no farthest place

    def numbers(draw: Draw) -> tuple[float, ...]:
        seen: list[float] = []
        for side, reached in zip(sides, found, strict=True):
            time = limit.time if reached.time is None else f.element(_BEYOND) * reached.time
            (until,) = element_at(setup, (f.lowest_terms(time),), draw, draw.start())
            low, high = extremes_between(setup, draw, of, 0.0, until)
            seen.append(low if side < 0 else high)
        return tuple(seen)

    check = CrossCheck(question, Message("numerical integration beyond the turn"), MOTION_TOLERANCE)
    evidence = checked(setup, check, values, conditions, numbers)
    if evidence is None:
        needed = ", ".join(broken(setup, conditions))
        raise NotHere(Message("the motion is another one at the model's own values: that needs {x}", x=needed))
    notes = _by_sign(setup, of, limit.time) if [*sides] == [1] and not damped.is_size else []
    return Finding(values if len(values) > 1 else next(iter(values)), evidence, conditions, notes)


def _by_sign(setup: Setup, of: Quantity, settled: Ratio) -> list[str]:
    """That the greatest value is not that of the greatest size, where that is so at the given numbers."""
    if not setup.has_values:
        return []
    draw = setup.draws[0]
    (until,) = element_at(setup, (settled,), draw, draw.start())
    low, high = extremes_between(setup, draw, of, 0.0, until)
    return [more_in_size(f"{number_text(-low)} {of.unit}".rstrip())] if -low > high else []


def _size(law: Damped) -> Reached:
    """Where it turns first, and later it is smaller; what sets out through zero may have been greatest at the start."""
    side, needs = law.side_of(law.u0)
    reached = extent_by_law(law, "it", side)
    turn = side * reached.at
    if law.q0.is_zero():
        return replace(reached, at=turn, conditions=[*reached.conditions, *needs])
    sense, more = law.side_of(law.q0)
    begun, needs = sense * law.q0, (*needs, *more)
    if sense == side:
        return replace(reached, at=turn, conditions=[*reached.conditions, *needs])
    over = law.model.field.lowest_terms(begun - turn)
    if law.is_negative(over):
        return replace(reached, at=turn, conditions=[*reached.conditions, *needs, (-over, ">=")])
    return replace(reached, at=begun, conditions=[*reached.conditions, *needs, (over, ">=")])
