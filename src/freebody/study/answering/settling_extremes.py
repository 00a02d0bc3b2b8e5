"""Extremes of a quantity of one rate that settles: the greatest power of a motor that runs up, of a weight that falls
against the air.

Where u' = F(u) the rate goes from u_0 to its end u_1, a zero of F, and never turns. A quantity y(u) is there greatest
where dy/du = 0, if that rate lies between the two, else at the start, or it comes ever nearer to y(u_1). A motor with
the torque T_0 (1 - u/omega_0) has the power T_0 u (1 - u/omega_0), greatest at u = omega_0/2: T_0 omega_0/4. Source:
Norton, Design of Machinery, sec. 2.19; Arnold, Ordinary Differential Equations, 1973, sec. 1 (flows on the line).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from freebody.errors import CannotAnswer
from freebody.language.expression import Symbol
from freebody.language.notation import compared, reworded
from freebody.language.sentences import Message
from freebody.questions.base import Quantity
from freebody.study.answering.crosscheck import MOTION_TOLERANCE, CrossCheck, broken, element_at
from freebody.study.answering.draws import Draw
from freebody.study.answering.finding import Finding, NotHere
from freebody.study.answering.motion_values import extremes_between
from freebody.study.answering.repeated import checked, held_throughout, taken_throughout
from freebody.study.answering.sizes import is_size
from freebody.study.setup import Setup
from freebody.symbolic.conditions import Condition, require
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.relations import readable
from freebody.symbolic.unknowns import Coordinate


@dataclass(frozen=True)
class Settling:
    """A quantity over the rate of a coordinate, which goes from `first` to `last`; turn: the rate at which the quantity
    turns, None where it nowhere does. time: by when the rate has settled, but for round-off."""

    setup: Setup
    c: Coordinate
    value: Ratio
    first: Ratio
    last: Ratio
    turn: Ratio | None
    time: Ratio
    is_size: bool

    def at(self, rate: Ratio) -> Ratio:
        f = self.value.field
        return f.lowest_terms(f.follow(self.value, {self.c.speed: rate}))


def settling_of(setup: Setup, of: Quantity) -> Settling | None:
    """How a quantity changes with a rate that settles; None where it is another one."""
    model, f = setup.model, setup.model.field
    value = of.value(setup.system, setup.state)
    if isinstance(value, tuple) or len(model.coordinates) != 1 or model.dependent:
        return None
    (c,) = model.coordinates
    x = f.lowest_terms(model.in_independent_speeds(f.element(value)))
    if size := is_size(model, x, c):
        x = f.lowest_terms(x * x)
    law = setup.motion.law_of(c, takes_side=True)
    moves = {c.index, f.index(f.time)}
    is_of_rate = not moves & (f.ingredients(x) | f.ingredients(setup.motion.acceleration(c)))
    if law is None or law.limit is None or law.limit.rate is None or not is_of_rate:
        return None
    if c.speed not in f.ingredients(x) or c.speed in f.ingredients(x.denominator()):
        return None
    slope = f.lowest_terms(f.partial(x, c.speed)).coefficients(c.speed)
    if len(slope) > 2:
        return None
    turn = f.lowest_terms(-slope[0] / slope[1]) if len(slope) == 2 else None
    return Settling(setup, c, x, law.u0, law.limit.rate, turn, law.limit.time, size)


def find(setup: Setup, question: str, of: Quantity, settling: Settling, sides: Sequence[int]) -> Finding:
    """The closed form. sides: -1 for the least value, +1 for the greatest, in the order in which they are wanted."""
    f = setup.model.field
    conditions = [*taken_throughout(setup), *held_throughout(setup)]
    values: list[Ratio] = []
    notes: list[Message | str] = []
    for side in sides:
        rate, needs = _rate_of(settling, side)
        best = settling.at(rate)
        values.append(f.sqrt(best, setup.model.samples.is_negative) if settling.is_size else best)
        conditions += needs
        notes.append(_where(settling, rate))

    def numbers(draw: Draw) -> tuple[float, ...]:
        (until,) = element_at(setup, (settling.time,), draw, draw.start())
        low, high = extremes_between(setup, draw, of, 0.0, until)
        return tuple(low if side < 0 else high for side in sides)

    check = CrossCheck(question, Message("numerical integration until the motion is steady"), MOTION_TOLERANCE)
    evidence = checked(setup, check, tuple(values), conditions, numbers)
    if evidence is None:
        needed = ", ".join(broken(setup, conditions))
        raise NotHere(Message("the motion is another one at the model's own values: that needs {x}", x=needed))
    return Finding(tuple(values) if len(values) > 1 else values[0], evidence, conditions, notes)


def _rate_of(s: Settling, side: int) -> tuple[Ratio, list[Condition]]:
    """The rate at which the quantity is greatest (side 1) or least of all that are passed, at the model's own values or
    the first sample; that it is so for others is a condition."""
    f = s.value.field
    ends = [s.first, s.last]
    if s.turn is not None and _is_between(s, s.turn):
        gap = f.lowest_terms((s.turn - s.first) * (s.last - s.turn))
        rates, needs = [*ends, s.turn], [(gap, ">", Message("it gets there"))]
    elif s.turn is not None:
        gap = f.lowest_terms((s.turn - s.first) * (s.turn - s.last))
        rates, needs = ends, [(gap, ">=", Message("it does not get there"))]
    else:
        rates, needs = ends, []
    best = max(rates, key=lambda rate: side * _first(s, s.at(rate)))
    needs += [
        (f.lowest_terms(side * (s.at(best) - s.at(rate))), ">=", Message("which extreme is which"))
        for rate in ends
        if rate is not best and (s.turn is None or best is not s.turn)
    ]
    found: list[Condition] = []
    for gap, relation, purpose in needs:
        condition, possible = require(gap, relation, purpose)
        if not possible:
            raise CannotAnswer(Message("which value is the extreme one was not decided"))
        found += [] if condition is None else [condition]
    return best, found


def _is_between(s: Settling, rate: Ratio) -> bool:
    low, high = sorted((_first(s, s.first), _first(s, s.last)))
    return low < _first(s, rate) < high


def _first(s: Settling, x: Ratio) -> float:
    return s.setup.model.samples.at_starts(x)[0]


def _where(s: Settling, rate: Ratio) -> Message | str:
    """At which rate it is so."""
    if rate is s.first:
        return Message("that is so at the start")
    if rate is s.last:
        return Message("it comes ever nearer to that, and never quite reaches it")
    shown = compared(Symbol(f"{s.c.name}'"), "=", readable(rate))
    return reworded(Message("that is so at {place}", place=shown), shown)
