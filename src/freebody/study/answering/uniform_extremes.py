"""Extremes of a quantity of several coordinates that are all accelerated evenly: the least distance of two ships, or of
two thrown balls, the least speed of a ball in flight.

Where the quantity, or the square of a size, is P(t) = c0 + c1 t + c2 t^2, its only turn is at t = -c1/(2 c2), with the
value c0 - c1^2/(4 c2); if that instant is before the start, the start is the place. It is the least value for c2 > 0,
and then there is no greatest one. Source: Meriam & Kraige, Dynamics, 8th ed. 2015, sec. 2/8 (relative motion).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from freebody.errors import CannotAnswer, NeverHappens
from freebody.language.expression import Expr, Symbol
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
from freebody.symbolic.conditions import Condition, insisted
from freebody.symbolic.laws.uniform import UniformLaw
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.relations import readable
from freebody.symbolic.signs import Sign, sign_of

_SEEN = 3.0  # times to the turn that are looked at in numbers
_N_PARTS = 3  # c0, c1, c2


@dataclass(frozen=True)
class EvenTurn:
    """The one turn of a quantity along c0 + c1 t + c2 t^2. is_size: of which that is the square."""

    parts: tuple[Ratio, Ratio, Ratio]
    is_size: bool

    @property
    def time(self) -> Ratio:
        _c0, c1, c2 = self.parts
        return c1.field.lowest_terms(-c1 / (2 * c2))

    def value(self, *, at_start: bool) -> Ratio:
        """At the turn, or at the start."""
        c0, c1, c2 = self.parts
        return c0.field.lowest_terms(c0 if at_start else c0 - c1 * c1 / (4 * c2))


def even_turn(setup: Setup, of: Quantity) -> EvenTurn | None:
    """How a quantity of several coordinates turns that are accelerated evenly; None where it is another one."""
    model, motion, f = setup.model, setup.motion, setup.model.field
    value = of.value(setup.system, setup.state)
    if isinstance(value, tuple) or model.dependent or motion.stands_still:
        return None
    x = f.lowest_terms(model.in_independent_speeds(f.element(value)))
    inside = [c for c in model.coordinates if {c.index, c.speed} & f.ingredients(x)]
    if len(inside) < 2:
        return None
    if size := is_size(model, x, *inside):
        x = f.lowest_terms(x * x)
    laws = {c: motion.law_of(c) for c in inside}
    places: dict[int, Ratio] = {}
    for c, law in laws.items():
        if not isinstance(law, UniformLaw):
            return None
        at, rate = law.at(f.time)
        places |= {c.index: at, c.speed: rate}
    x = f.lowest_terms(f.follow(x, places))
    clock = f.index(f.time)
    if clock not in f.ingredients(x) or clock in f.ingredients(x.denominator()):
        return None
    parts = [f.lowest_terms(part) for part in x.coefficients(clock)]
    if len(parts) != _N_PARTS or not all(part.is_constant() for part in parts):
        return None
    if any(clock in f.ingredients(part) for part in parts):
        return None
    return EvenTurn((parts[0], parts[1], parts[2]), size)


def find(setup: Setup, question: str, of: Quantity, turn: EvenTurn, sides: Sequence[int]) -> Finding:
    """The closed form. sides: -1 for the least value, +1 for the greatest, in the order in which they are wanted.
    Raises NeverHappens where it grows without bound on that side."""
    (side,) = sides if len(sides) == 1 else (0,)
    if not side:
        raise CannotAnswer(Message("it turns once only"))
    f, c1, c2 = setup.model.field, turn.parts[1], turn.parts[2]
    way = sign_of(c2)
    opens = -1 if way is Sign.NEGATIVE or (way is Sign.UNKNOWN and setup.model.samples.at_starts(c2)[0] < 0) else 1
    if opens == side:
        raise NeverHappens(Message("it grows without bound on that side, so there is no farthest place"))
    at_start = is_over(setup, turn)
    conditions = [Condition(opens * c2, ">", Message("it turns"))]
    conditions.append(Condition((1 if at_start else -1) * opens * c1, ">=" if at_start else ">", _why(at_start)))
    value = turn.value(at_start=at_start)
    value = f.sqrt(value, setup.model.samples.is_negative) if turn.is_size else value
    never = NeverHappens(Message("it does not turn"))
    needed = [*insisted(conditions, never), *taken_throughout(setup), *held_throughout(setup)]

    def numbers(draw: Draw) -> tuple[float, ...]:
        (time,) = element_at(setup, (turn.time,), draw, draw.start())
        low, high = extremes_between(setup, draw, of, 0.0, _SEEN * abs(time))
        return (low if side < 0 else high,)

    check = CrossCheck(question, Message("numerical integration beyond the turn"), MOTION_TOLERANCE)
    evidence = checked(setup, check, (value,), needed, numbers)
    if evidence is None:
        raise NotHere(
            Message(
                "the motion is another one at the model's own values: that needs {x}",
                x=", ".join(broken(setup, needed)),
            )
        )
    if at_start:
        return Finding(value, evidence, needed, [Message("that is so at the start")])
    when = compared(Symbol("t"), "=", readable(turn.time))
    return Finding(value, evidence, needed, [reworded(Message("that is so at {place}", place=when), when)])


def is_over(setup: Setup, turn: EvenTurn) -> bool:
    """Whether the turn is before the start, at the model's own values."""
    time = setup.model.samples.at_starts(turn.time)
    return turn.time.is_zero() or bool(time and time[0] <= 0.0)


def _why(at_start: bool) -> Message:
    return Message("it sets out to the other side") if at_start else Message("it turns")


def instant_of_turn(setup: Setup, of: Quantity) -> Expr | None:
    """When a quantity turns after the start; None where it does not, or is another one."""
    turn = even_turn(setup, of)
    return None if turn is None or is_over(setup, turn) else readable(turn.time)
