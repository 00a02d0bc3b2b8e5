"""What goes against its drive until it turns, and comes back by another formula; time counts from the start on both."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Protocol

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.symbolic.laws.base import Instants, LawInstant, Limit, MotionLaw
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio


class _Turning(Protocol):
    """Of what the two ways are put together: the turn (when, where), the formula of the way out, and the law of the way
    back, its time counted from the turn. is_one: whether the formula of the way out goes on over the turn."""

    @property
    def model(self) -> SymbolicModel: ...
    @property
    def is_one(self) -> bool: ...
    @property
    def turning(self) -> tuple[Ratio, Ratio]: ...
    @property
    def back(self) -> MotionLaw | None: ...
    def out(self, t: Ratio) -> tuple[Ratio, Ratio]: ...
    def is_negative(self, x: Ratio) -> bool: ...


def at_near(law: _Turning, t: Ratio, near: Ratio) -> tuple[Ratio, Ratio]:
    """Value and rate at a time, on the way on which another time lies."""
    f = law.model.field
    if law.is_one:
        return law.out(t)
    turn = law.turning[0]
    if law.is_negative(f.lowest_terms(near - turn)):
        return law.out(t)
    if law.back is None:
        raise CannotAnswer(Message("on the way back it is driven and not resisted"))
    return law.back.at(f.lowest_terms(t - turn))


def later(law: _Turning, instants: Instants) -> Iterator[LawInstant]:
    """Instants of the way back, by the time since the start."""
    turn = law.turning[0]
    for i in () if instants is None else instants[0]:
        yield replace(i, time=law.model.field.lowest_terms(turn + i.time), key=None)


def limit_behind(law: _Turning) -> Limit | None:
    """To what the way back tends."""
    end = None if law.back is None else law.back.limit
    return None if end is None else replace(end, time=law.turning[0] + end.time)
