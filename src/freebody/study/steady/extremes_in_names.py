"""The least or greatest value over a turn where its place has no closed form.

The quantity is told as a chain of formulas in the angle, and the place in numbers.

At the place the slope along the angle vanishes. That no other pose has more is shown in balls: in an interval of the
half width h about m,

    Q <= min(max Q([m - h, m + h]),  Q(m) + h max |Q'([m - h, m + h])|)

and what stays open is halved. Source: Moore, Kearfott & Cloud, Introduction to Interval Analysis, 2009, ch. 6.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property

from freebody.budgets import allowed
from freebody.language.expression import ZERO, Symbol, number, substitute
from freebody.language.notation import compared, reworded
from freebody.language.sentences import Message
from freebody.present.lines import number_text, symbol_text
from freebody.questions.base import Quantity
from freebody.questions.reading import Question
from freebody.questions.steady import extremes_in
from freebody.study.answering.answer import Answer, Evidence, made
from freebody.study.answering.chain import ChainBuilder, inputs
from freebody.study.answering.finding import NO_FORM
from freebody.study.answering.in_size import more_in_size
from freebody.study.answering.named_formulas import Chain, NamedFormula
from freebody.study.setup import Setup
from freebody.study.steady.chain_in_balls import ChainInBalls
from freebody.study.steady.drive import FreeToTurn, turned_by_drive
from freebody.study.steady.round_turn import N_POSES, DrawnTurn

_N_LOOKS = 720  # poses in which the chain is looked at
_HALVINGS = 60  # of the interval of two looks in which the slope changes its sign
_SAME = 1e-8  # of the largest value: how far chain and full system may differ
_NO_MORE = 1e-9  # of the largest value, that another pose may have more
_BOXES = 6000  # that the turn is cut into
_WIDE = 64  # intervals to begin with
_DIGITS = 10  # of the place, as it is shown


def extreme_in_names(setup: Setup, question: Question) -> Answer | None:
    """Of the turn of the one drive; None for other questions, and where no chain was found or it does not come to the
    same as the full system."""
    q = extremes_in(question.quantity)
    if q is None or q.what not in ("least", "greatest") or question.at_start or not setup.has_values:
        return None
    if not isinstance(setup, FreeToTurn) or setup.system.bounds or setup.system.dry_friction:
        return None
    try:
        turn = _chain_over_turn(setup, q.of, 1 if q.what == "greatest" else -1)
        return None if turn is None else _told(setup, question, turn)
    except (*NO_FORM, ValueError, KeyError):
        return None


@dataclass(frozen=True)
class ChainOverTurn:
    """A quantity by a chain in the angle `name`; side: 1 where the greatest value is looked for."""

    chain: Chain
    name: str
    known: Mapping[str, float]
    side: int

    def at(self, angle: float) -> float:
        """Not a number where a step has no value, as at the pole of a half angle."""
        with suppress(ArithmeticError, ValueError):
            return self.chain.numbers({**self.known, self.name: angle})[0]
        return math.nan

    @cached_property
    def looks(self) -> list[tuple[float, float]]:
        """(angle, value) all round the turn; no part of it is round, so that poles are seldom met."""
        angles = [math.tau * (k + math.sqrt(0.5)) / _N_LOOKS for k in range(_N_LOOKS)]
        return [(x, value) for x in angles if not math.isnan(value := self.at(x))]

    @cached_property
    def size(self) -> float:
        return max(abs(value) for _angle, value in self.looks)

    def best(self) -> tuple[float, float]:
        """(angle, value) at the extreme: of every look that beats its neighbours the zero of the slope beside it."""
        values = [self.side * value for _angle, value in self.looks]
        n, found = len(values), list[tuple[float, float]]()
        for k in range(n):
            if values[k] >= max(values[k - 1], values[(k + 1) % n]):
                found.append(self._closer(self.looks[k][0]))
        return max(found, key=lambda place: self.side * place[1])

    def _closer(self, angle: float) -> tuple[float, float]:
        """Where the slope changes its sign beside a look."""
        low, high = angle - 1.5 * math.tau / _N_LOOKS, angle + 1.5 * math.tau / _N_LOOKS
        for _ in range(_HALVINGS):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if self.side * self.balls.enclosed(middle, 0.0)[1].mid() > 0 else (low, middle)
        place = float(f"{0.5 * (low + high):.{_DIGITS + 2}g}")
        value = self.at(place)
        return place, -self.side * math.inf if math.isnan(value) else value

    # -- in balls -----------------------------------------------------------------------------
    @cached_property
    def balls(self) -> ChainInBalls:
        return ChainInBalls(self.chain, self.name, self.known)

    def is_proved(self, value: float) -> bool:
        """Whether no pose has more than a value."""
        if not self.balls.counts_no_turns:
            return False
        most, left = self.side * value + _NO_MORE * self.size, allowed(_BOXES)
        half = math.pi / _WIDE
        stack = [((2 * k + 1) * half, half) for k in range(_WIDE)]
        while stack:
            middle, half = stack.pop()
            left -= 1
            if left < 0:
                return False
            if not self._has_no_more(middle, half * (1 + 1e-12), most):
                stack += [(middle - half / 2, half / 2), (middle + half / 2, half / 2)]
        return True

    def _has_no_more(self, middle: float, half: float, most: float) -> bool:
        value, slope = self.balls.enclosed(middle, half)
        if self.side * value <= most:
            return True
        return bool(self.side * self.balls.enclosed(middle, 0.0)[0] + abs(slope) * half <= most)


def _chain_over_turn(setup: FreeToTurn, of: Quantity, side: int) -> ChainOverTurn | None:
    """The quantity of the driven system, with the angle in place of the time: t = (phi - phi_0)/phi'."""
    turned_by_drive(setup)  # raises CannotAnswer where something else moves beside it
    driven = Setup(setup.driven)
    model, f = driven.model, driven.model.field
    if model.coordinates:
        return None
    (name,) = setup.system.measures
    angle = f.parameter(name)
    begin = model.geometry.scalar(substitute(setup.drive.target or ZERO, {"t": ZERO}))
    builder = ChainBuilder(driven, {f.index(f.time): (angle - begin) / model.geometry.scalar(setup.rate)})
    found = builder.chain(of)
    if found is None or len(found.chain.result) != 1:
        return None
    draw = driven.draws[0]
    known = inputs(driven, model.samples.numbers(draw.sample(draw.start()), draw.sample()))
    return ChainOverTurn(found.chain, name, {k: x for k, x in known.items() if k not in (name, "t")}, side)


def _told(setup: FreeToTurn, question: Question, turn: ChainOverTurn) -> Answer | None:
    q = extremes_in(question.quantity)
    assert q is not None
    drawn = DrawnTurn(setup, setup.draws[0], turned_by_drive(setup), q.of)
    poses = [(turn.at(drawn.here + away), drawn.value(q_there)) for away, q_there in drawn.poses()]
    place, value = turn.best()
    if turn.side * value < max(turn.side * look for _angle, look in turn.looks) - _SAME * turn.size:
        return None  # it is most beside a jump, where no slope vanishes
    poses.append((value, drawn.at(math.remainder(place - drawn.here, math.tau))))
    gap = max(abs(one - other) for one, other in poses) / turn.size
    if not gap <= _SAME:
        return None
    route = Message("the full system at the extremal pose and at {n} others round the turn", n=N_POSES)
    angle = Symbol(turn.name)
    shown = number(Fraction(f"{place:.{_DIGITS}g}"))
    chain = Chain((NamedFormula(angle, shown), *turn.chain.named), turn.chain.result)
    return made(
        question,
        None,
        value,
        reason=Message("the place at which its slope vanishes has no closed form"),
        notes=[*_notes(turn, place, value), *_by_sign(turn, value, q.of.unit)],
        evidence=Evidence(1, gap, route),
        chain=chain,
    )


def _by_sign(turn: ChainOverTurn, value: float, unit: str) -> list[str]:
    """That the greatest value is not that of the greatest size, where that is so."""
    if turn.side < 0 or min(x for _angle, x in turn.looks) >= -abs(value) * (1 + _SAME):
        return []
    least = replace(turn, side=-1).best()[1]
    return [more_in_size(f"{number_text(-least)} {unit}".rstrip())]


def _notes(turn: ChainOverTurn, place: float, value: float) -> list[str]:
    degrees = number_text(math.degrees(math.remainder(place, math.tau)))
    where = compared(Symbol(turn.name), "=", number(Fraction(f"{place:.6g}")))
    there = f"{symbol_text(turn.name)} = {degrees}°"
    words = (
        Message("greatest at {place}, where the slope of this formula along the angle is zero", place=there)
        if turn.side > 0
        else Message("least at {place}, where the slope of this formula along the angle is zero", place=there)
    )
    if not turn.is_proved(value):
        return [reworded(words, where), Message("of the extremes seen at {n} poses round the turn", n=_N_LOOKS)]
    none = (
        Message("by interval arithmetic no other pose has more")
        if turn.side > 0
        else Message("by interval arithmetic no other pose has less")
    )
    return [reworded(words, where), none]
