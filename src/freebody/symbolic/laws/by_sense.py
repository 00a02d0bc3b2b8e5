"""A spring, and a resistance that is linear in the rate, but stronger in one sense than in the other, or in one alone:

    q'' = alpha + beta q + gamma u + eta |u|,        beta < 0,  gamma +- eta <= 0

As long as the rate keeps its sense s this is the law of q'' = alpha + beta q + (gamma + s eta) u, with or without
resistance; it is told up to where it turns first. Every half of a swing is no wider than the one before. Source: Magnus
& Popp, Schwingungen, 7th ed. 2005, sec. 2.2, half by half.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Self

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.symbolic.laws.base import (
    Farthest,
    FirstInstant,
    Freely,
    Instants,
    LawInstant,
    MotionLaw,
    Need,
    first,
)
from freebody.symbolic.laws.damped import CriticallyDamped, Overdamped, Underdamped
from freebody.symbolic.laws.oscillation import Oscillation
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign


@dataclass(frozen=True)
class BySense(MotionLaw):
    """way: the law of the way on which it sets out."""

    key = "by_sense"

    way: MotionLaw

    @classmethod
    def of(cls, moving: Freely) -> Self | None:
        f, c = moving.field, moving.coordinate
        if not moving.takes_side or not moving.is_alone or c.speed not in f.ingredients(moving.acceleration):
            return None
        both = {sense: moving.onward(sense) for sense in (1, -1)}
        if None in both.values() or both[1] == both[-1]:
            return None
        ways = {sense: replace(moving, acceleration=x) for sense, x in both.items() if x is not None}
        if not all(map(_is_resisted, ways.values())):
            return None
        drive = moving.u0
        if drive.is_zero():
            drive = f.lowest_terms(f.follow(ways[1].acceleration, {c.speed: f.zero, c.index: moving.q0}))
        sense = {Sign.POSITIVE: 1, Sign.NEGATIVE: -1}.get(moving.sign(drive), 0)
        if not sense:
            return None
        kinds = (Underdamped, Overdamped, CriticallyDamped, Oscillation)
        way = next((law for kind in kinds if (law := kind.of(ways[sense])) is not None), None)
        return None if way is None else cls(moving.model, moving.q0, moving.u0, way)

    @property
    def first_acceleration(self) -> Ratio:
        return self.way.first_acceleration

    @property
    def unit_of_time(self) -> Ratio | None:
        return self.way.unit_of_time

    @cached_property
    def _turn(self) -> FirstInstant | None:
        """Where its rate is zero first after the start; None where it only creeps."""
        found = self.way.rates(self.u0.field.zero)
        return None if found is None else first(self.model, found[0])

    def at(self, t: Ratio) -> tuple[Ratio, Ratio]:
        return self.at_near(t, t)

    def at_near(self, t: Ratio, near: Ratio) -> tuple[Ratio, Ratio]:
        f = self.model.field
        if self._turn is not None and self.is_negative(f.lowest_terms(self._turn.instant.time - near)):
            raise CannotAnswer(
                Message("after its first turn it is resisted otherwise; there is no one formula for both")
            )
        return self.way.at(t)

    def places(self, value: Ratio) -> Instants:
        found = self.way.places(value)
        return None if found is None else self._before_turn(found)

    def rates(self, value: Ratio) -> Instants:
        found = self.way.rates(value)
        if found is None or not value.is_zero():
            return found and self._before_turn(found)
        turn = self._turn
        return ([] if turn is None else [replace(turn.instant, period=None)]), found[1]

    def _before_turn(self, found: tuple[list[LawInstant], list[Need]]) -> Instants:
        """The first of them, where the turn is not before it."""
        come = first(self.model, found[0])
        if come is None or self._turn is None:
            return found
        left = self.model.field.lowest_terms(self._turn.instant.time - come.instant.time)
        if self.is_negative(left):
            return None
        needs = [*found[1], *come.conditions, *([] if left.is_zero() else [(left, ">=")])]
        return [replace(come.instant, period=None)], needs

    def extent(self, side: int) -> Farthest | None:
        if not self.u0.is_zero():
            return self.at_first_turn(side)
        sense, needs = self.side_of(self.first_acceleration)  # which has the sign of q0 less the centre
        is_creeping = self._turn is None
        return Farthest(self.q0 if side == sense else None, needs, is_limit=side != sense and is_creeping)


def _is_resisted(moving: Freely) -> bool:
    """Whether it is linear, drawn back, and not driven by what grows with the rate."""
    if moving.steady is None:
        return False
    _alpha, beta, gamma = moving.steady
    is_damped = gamma.is_zero() or moving.sign(gamma) is Sign.NEGATIVE
    return moving.sign(beta) is Sign.NEGATIVE and is_damped
