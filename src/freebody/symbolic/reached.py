"""An event of a motion in closed form."""

from __future__ import annotations

from dataclasses import dataclass, field

from freebody.errors import NeverHappens
from freebody.language.sentences import Message
from freebody.symbolic.algebraic_time import AlgebraicTime
from freebody.symbolic.elliptic import EllipticTime
from freebody.symbolic.orbits import Orbit
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.unknowns import Coordinate

HOLDS_ALWAYS = Message("it holds at the start (t = 0) and all the time after it")


class HoldsOnce(NeverHappens):
    """The event is there at the start, and it is proved that it does not come again."""

    def __init__(self) -> None:
        super().__init__(Message("it holds at the start (t = 0), and never again"))


@dataclass
class Reached:
    """An event in closed form: when, and the state there; `notes` name the rejected roots."""

    time: Ratio | None
    coordinate: Coordinate | None  # None: a combination of several, of which `at` and `speed` are value and rate
    at: Ratio  # value of the coordinate
    speed: Ratio | None
    notes: list[str] = field(default_factory=list[str])
    conditions: list[tuple[Ratio, str]] = field(default_factory=list[tuple[Ratio, str]])  # must be ">" or ">=" zero
    why_no_time: str = ""
    says: list[str] = field(default_factory=list[str])  # conditions that have no formula
    limits: dict[int, Ratio] | None = None  # as the time grows without end: what tends to a value
    integral: EllipticTime | AlgebraicTime | None = None  # of the time, where energy gives it
    timed: list[tuple[Ratio, str]] = field(default_factory=list[tuple[Ratio, str]])  # what the time needs besides
    bound: dict[int, Ratio] = field(default_factory=dict[int, Ratio])  # angles of closed loops that the event gives
    others: dict[int, Ratio] = field(default_factory=dict[int, Ratio])  # angles that are known there by an orbit
    orbits: tuple[Orbit, ...] = ()  # by which they are
    settled: Ratio | None = None  # by when it is there, but for round-off
    decays: list[tuple[Ratio, ...]] = field(default_factory=list[tuple[Ratio, ...]])  # by characteristic polynomials

    @property
    def values(self) -> dict[int, Ratio]:
        """The coordinate and its speed there, by generator."""
        c = self.coordinate
        if c is None:
            return {}
        return {**self.others, c.index: self.at} | ({} if self.speed is None else {c.speed: self.speed})
