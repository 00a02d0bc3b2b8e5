"""What all laws of motion share: a coordinate as a function of the time since the start, and when it is at a value.

A law is a subclass of `MotionLaw` in a file of this folder, found by itself. What is true at an instant is closed as
long as the time is: sines of arcs are put in where they cancel.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from math import inf, isnan
from typing import ClassVar, Self

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.symbolic.field import Field
from freebody.symbolic.functions import functions
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign, sign_of
from freebody.symbolic.unknowns import Coordinate

Need = tuple[Ratio, str]  # what must be ">" or ">=" zero
Turn = tuple[Ratio, Ratio, Ratio | None]  # w t, the slope there, a key
SETTLED = 30  # units of time after which exp(-t) counts as zero
_NOW = 1e-12  # a time that counts as the start, by the unit of time of a law


@dataclass(frozen=True)
class LawInstant:
    """Something that happens at a time: the coordinate and its rate then. key: grows with the time and has its sign;
    None: it is after the start, and after the others that are. period: after which it comes again."""

    time: Ratio
    place: Ratio
    rate: Ratio
    key: Ratio | None
    period: Ratio | None = None


Instants = tuple[list[LawInstant], list[Need]] | None  # with what they need to be real; None: no closed form


@dataclass(frozen=True)
class FirstInstant:
    """The first of several instants, and what must be positive (or not negative) for it to be so."""

    instant: LawInstant
    conditions: tuple[tuple[Ratio, str], ...]


@dataclass(frozen=True)
class Freely:
    """One coordinate that moves by itself. takes_side: whether a sign on which the law depends, and which parameters
    decide, may be taken as it is at the first sample; that is then assumed. keeps_sense: whether it is followed only as
    long as its rate keeps its sense."""

    model: SymbolicModel
    coordinate: Coordinate
    acceleration: Ratio
    q0: Ratio
    u0: Ratio
    takes_side: bool
    keeps_sense: bool = False

    @property
    def field(self) -> Field:
        return self.model.field

    @cached_property
    def is_alone(self) -> bool:
        """Whether the acceleration depends on nothing that moves but the coordinate, its rate and the time."""
        coordinates = (*self.model.coordinates, *self.model.dependent)
        others = {g for c in coordinates for g in (c.index, c.speed)} - {self.coordinate.index, self.coordinate.speed}
        return not self.field.ingredients(self.acceleration) & others

    @cached_property
    def linear(self) -> tuple[Ratio, Ratio, Ratio] | None:
        """(alpha, beta, gamma) with q'' = alpha + beta q + gamma u, where alpha may depend on the time."""
        f, a, c = self.field, self.acceleration, self.coordinate
        if not self.is_alone or a.denominator().generators() & {c.index, c.speed}:
            return None
        beta, gamma = f.partial(a, c.index), f.partial(a, c.speed)
        alpha = f.lowest_terms(a - beta * f.variable(c.index) - gamma * f.variable(c.speed))
        moves = f.ingredients(alpha) & {c.index, c.speed}
        return (alpha, beta, gamma) if beta.is_constant() and gamma.is_constant() and not moves else None

    @property
    def steady(self) -> tuple[Ratio, Ratio, Ratio] | None:
        """The same, where nothing in it depends on the time."""
        return self.linear if self.linear is not None and self.linear[0].is_constant() else None

    def onward(self, sense: int) -> Ratio | None:
        """The acceleration as long as the rate has a sense: the size |u| of the rate, in a root, is sense u there. None
        where a root of the rate is something else."""
        f, x = self.field, self.acceleration
        u = f.variable(self.coordinate.speed)
        sized: dict[int, Ratio] = {}
        for g in x.generators():
            if g == self.coordinate.speed or self.coordinate.speed not in f.ingredients(f.variable(g)):
                continue
            if f.generators[g].kind != "root":
                return None
            share = f.lowest_terms(f.radicand(g) / (u * u))
            if not share.is_constant():
                return None
            sized[g] = sense * u * f.sqrt(share, self.model.samples.is_negative)
        return f.lowest_terms(f.substitute(x, sized)) if sized else x

    def sign(self, x: Ratio) -> Sign:
        """Of a parameter on which the law depends: strict, zero or unknown."""
        if x.is_zero():
            return Sign.ZERO
        known = sign_of(x)
        if known.is_strict:
            return known
        if not self.takes_side:
            return Sign.UNKNOWN
        return Sign.NEGATIVE if self.model.samples.is_negative(x) else Sign.POSITIVE


@dataclass(frozen=True)
class Farthest:
    """The end of a motion on one side, and what must be positive (or not negative) for it to be that. place: where that
    is; None: where it turns first."""

    place: Ratio | None
    needs: tuple[Need, ...] = ()
    is_boundless: bool = False
    is_limit: bool = False  # whether it only tends to it


@dataclass(frozen=True)
class MotionLaw:
    """What all laws know: the model, and the value and rate at the start."""

    laws: ClassVar[list[type[MotionLaw]]] = []
    key: ClassVar[str] = ""  # of the sentence that tells it
    tends_alike: ClassVar[bool] = False  # whether the laws among which a sign decides all tend to the same

    model: SymbolicModel
    q0: Ratio
    u0: Ratio

    def __init_subclass__(cls) -> None:
        super().__init_subclass__()
        MotionLaw.laws.append(cls)

    @classmethod
    def of(cls, moving: Freely) -> Self | None:
        """The law of a coordinate, where it is of this kind. No two laws fit one acceleration."""
        return None

    @property
    def is_still(self) -> bool:
        """True where it starts at rest and nothing accelerates it."""
        return self.u0.is_zero() and self.first_acceleration.is_zero()

    @property
    def first_acceleration(self) -> Ratio:
        """Zero just where the acceleration at the start is zero."""
        raise NotImplementedError

    @property
    def unit_of_time(self) -> Ratio | None:
        """In which the law does what it does, its sign aside; None where it has none."""
        return None

    @property
    def has_course(self) -> bool:
        """Whether value and rate are known as functions of the time."""
        return True

    @property
    def period(self) -> Ratio | None:
        """After which time it turns the same way again; None where it does not."""
        return None

    @property
    def is_undamped(self) -> bool:
        """Whether it then is where it was, too."""
        return True

    @property
    def half_period(self) -> Ratio | None:
        """After which time it turns the other way; None where it does not swing to and fro alike."""
        return None

    def turned_after(self, begin: LawInstant, n: int) -> Ratio:
        """The place at which it turns n half periods after a turn."""
        raise NotImplementedError

    def at(self, t: Ratio) -> tuple[Ratio, Ratio]:
        """Value and rate at a time."""
        raise NotImplementedError

    def at_near(self, t: Ratio, near: Ratio) -> tuple[Ratio, Ratio]:
        """The same of a law that has several parts: the part in which a time lies."""
        return self.at(t)

    def places(self, value: Ratio) -> Instants:
        """The instants at which the coordinate has a value."""
        return None

    def rates(self, value: Ratio) -> Instants:
        """The instants at which its rate has a value, likewise."""
        return None

    def extent(self, side: int) -> Farthest | None:
        """How far it gets above (side > 0) or below; None where the law does not tell."""
        return None

    def at_first_turn(self, side: int) -> Farthest | None:
        """Of what is damped or resisted: it does not get beyond its first turn, nor back beyond its start at rest."""
        sense = sign_of(self.u0)
        return Farthest(None) if sense.is_strict and (sense is Sign.POSITIVE) == (side > 0) else None

    def side_of(self, x: Ratio) -> tuple[int, tuple[Need, ...]]:
        """+1 or -1 by the sign of what is not zero; where it is open, as it is at the first sample, which is then
        needed."""
        known = sign_of(x)
        way = -1 if self.is_negative(x) else 1
        return way, () if known.is_strict else ((way * x, ">"),)

    @property
    def limit(self) -> Limit | None:
        """To what it tends; None where neither value nor rate tends to anything."""
        return None

    def function(self, name: str, x: Ratio) -> Ratio:
        """An elementary function."""
        found: Ratio = functions(self.model.field, self.model.samples.is_negative)[name](x)
        return found

    def is_negative(self, x: Ratio) -> bool:
        """The sign of a parameter; where it is open, as it is at the first sample, which is then assumed."""
        known = sign_of(x)
        return known is Sign.NEGATIVE if known.is_strict else self.model.samples.is_negative(x)

    def root(self, x: Ratio) -> Ratio:
        return self.model.field.sqrt(x, self.model.samples.is_negative)


@dataclass(frozen=True)
class Limit:
    """To what value and rate tend as the time grows, None for what does not. time: by when they are there, but for
    round-off."""

    place: Ratio | None
    rate: Ratio | None
    time: Ratio


def first(model: SymbolicModel, instants: Sequence[LawInstant]) -> FirstInstant | None:
    """The instant that comes first after the start at every sample, as many periods later as that needs; None where
    none comes at any. Raises CannotAnswer where that depends on the parameter values."""
    times = [model.samples.at_starts(i.time) for i in instants]
    periods = [[inf] if i.period is None else model.samples.at_starts(i.period) for i in instants]
    picks: set[tuple[int, int] | None] = set()
    for s in range(len(times[0]) if times else 0):
        found: list[tuple[float, int, int]] = []
        for k, instant in enumerate(instants):
            t, period = times[k][s], periods[k][s % len(periods[k])]
            is_past = instant.time.is_zero() or t <= _NOW
            if not isnan(t) and (not is_past or instant.period is not None):
                found.append((t + period, k, 1) if is_past else (t, k, 0))
        if found or not all(isnan(column[s]) for column in times):
            picks.add(min(found)[1:] if found else None)
    if len(picks) > 1:
        raise CannotAnswer(Message("which root is the first time after the start depends on the parameter values"))
    pick = picks.pop() if picks else None
    if pick is None:
        return None
    chosen, n = instants[pick[0]], pick[1]
    needs = _order(model, chosen, n, [i for i in instants if i is not chosen and not i.time.is_zero()])
    if n:
        assert chosen.period is not None
        chosen = replace(chosen, time=chosen.time + chosen.period)
    return FirstInstant(chosen, tuple(needs))


def _order(model: SymbolicModel, chosen: LawInstant, n: int, others: Sequence[LawInstant]) -> list[Need]:
    """Why an instant (a period later for n = 1) comes first: it is after the start, and each other either was before it
    or is later."""
    needs: list[Need] = []
    own = chosen.key
    if own is not None and not chosen.time.is_zero():
        needs.append((-own, ">=") if n else (own, ">"))
    for key in (other.key for other in others):
        if key is None:
            continue
        if all(not v > 0 for v in model.samples.at_starts(key)):
            needs.append((-key, ">="))
            if n and own is not None:
                needs.append((key - own, ">"))
        elif own is not None:
            is_later = all(not v <= 0 for v in model.samples.at_starts(key - own))
            needs.append((key - own, ">") if is_later else (key * (key - own), ">="))
    return needs


def unless_zero(x: Ratio, relation: str) -> list[Need]:
    """A need, unless it is met as an equation: then two instants are one."""
    return [] if x.is_zero() else [(x, relation)]
