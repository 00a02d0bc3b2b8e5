"""How one coordinate moves by itself, as a function of the time since the start, and when it is at a given value.

    q'' = a              q = q0 + u0 t + a t^2/2
    q'' = -w^2 (q - c)   q = c + x0 cos(w t) + (u0/w) sin(w t)
    q'' = +k^2 (q - c)   q = c + x0 cosh(k t) + (u0/k) sinh(k t)
    q'' = g (u - u1)     u = u1 + (u0 - u1) exp(g t)

x0 = q0 - c. What is true at an instant is closed as long as the time is: sines of arcs are put in where they cancel.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import inf, isnan

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.symbolic.field import Ratio
from freebody.symbolic.functions import functions
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.signs import Sign, sign_of

_Need = tuple[Ratio, str]  # what must be ">" or ">=" zero
_Turn = tuple[Ratio, Ratio, Ratio | None]  # w t, the slope there, a key
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


Instants = tuple[list[LawInstant], list[_Need]] | None  # with what they need to be real; None: no closed form


@dataclass(frozen=True)
class FirstInstant:
    """The first of several instants, and what must be positive (or not negative) for it to be so."""

    instant: LawInstant
    conditions: tuple[tuple[Ratio, str], ...]


@dataclass(frozen=True)
class MotionLaw:
    """What all laws know: the model, and the value and rate at the start."""

    model: SymbolicModel
    q0: Ratio
    u0: Ratio

    @property
    def is_still(self) -> bool:
        """True where it starts at rest and nothing accelerates it."""
        return self.u0.is_zero() and self._first_acceleration.is_zero()

    @property
    def _first_acceleration(self) -> Ratio:
        """Zero just where the acceleration at the start is zero."""
        raise NotImplementedError

    def at(self, t: Ratio) -> tuple[Ratio, Ratio]:
        """Value and rate at a time."""
        raise NotImplementedError

    def places(self, value: Ratio) -> Instants:
        """The instants at which the coordinate has a value."""
        raise NotImplementedError

    def rates(self, value: Ratio) -> Instants:
        """The instants at which its rate has a value, likewise."""
        raise NotImplementedError


@dataclass(frozen=True)
class UniformLaw(MotionLaw):
    """Constant acceleration."""

    a: Ratio

    @property
    def _first_acceleration(self) -> Ratio:
        return self.a

    def at(self, t: Ratio) -> tuple[Ratio, Ratio]:
        return self.q0 + self.u0 * t + self.a * t * t / 2, self.u0 + self.a * t

    def places(self, value: Ratio) -> Instants:
        return None  # its roots are told apart where it is asked for (`motion.py`)

    def rates(self, value: Ratio) -> Instants:
        if self.a.is_zero():
            return [], []
        t = (value - self.u0) / self.a
        return [LawInstant(t, self.at(t)[0], value, t)], []


@dataclass(frozen=True)
class Oscillation(MotionLaw):
    """Harmonic about a centre."""

    center: Ratio
    square: Ratio  # of the angular frequency

    @property
    def _first_acceleration(self) -> Ratio:
        return self.q0 - self.center

    @property
    def w(self) -> Ratio:
        return self.model.field.sqrt(self.square, self.model.samples.is_negative)

    def at(self, t: Ratio) -> tuple[Ratio, Ratio]:
        w, f = self.w, functions(self.model.field, self.model.samples.is_negative)
        c, s = f["cos"](w * t), f["sin"](w * t)
        x0 = self.q0 - self.center
        return self.center + x0 * c + self.u0 / w * s, self.u0 * c - x0 * w * s

    def places(self, value: Ratio) -> Instants:
        w = self.w
        waves, needs = self._turns(self.q0 - self.center, self.u0 / w, value - self.center)
        return [LawInstant(tau / w, value, w * slope, key, self._period) for tau, slope, key in waves], needs

    def rates(self, value: Ratio) -> Instants:
        # u is a wave as well: u0 cos(tau) - w x0 sin(tau), and du/dtau = -w (q - c)
        w = self.w
        waves, needs = self._turns(self.u0, -w * (self.q0 - self.center), value)
        found = [LawInstant(tau / w, self.center - slope / w, value, key, self._period) for tau, slope, key in waves]
        return found, needs

    @property
    def _period(self) -> Ratio:
        return 2 * self.model.field.pi / self.w

    def _turns(self, a: Ratio, b: Ratio, y: Ratio) -> tuple[list[_Turn], list[_Need]]:
        """Angles tau in (-pi, 3 pi/2) with a cos(tau) + b sin(tau) = y, each with d/dtau there and a key."""
        field = self.model.field
        f = functions(field, self.model.samples.is_negative)
        pi, zero, real = field.pi, field.zero, a * a + b * b - y * y
        if sign_of(real) is Sign.NEGATIVE:  # out of reach
            return [], [(real, ">")]
        if b.is_zero():  # from an extreme; half a turn at most
            tau = f["acos"](y / a)
            return [(tau, zero if real.is_zero() else -a * f["sin"](tau), None)], _unless_zero(1 - (y / a) ** 2, ">")
        if a.is_zero():  # from the middle; the other angle with this sine is pi - tau
            ratio = y / b
            is_below = sign_of(ratio) in (Sign.NEGATIVE, Sign.NONPOSITIVE)
            tau = -f["asin"](-ratio) if is_below else f["asin"](ratio)
            slope = zero if real.is_zero() else b * f["cos"](tau)
            return [(tau, slope, y / b), (pi - tau, -slope, None)], _unless_zero(1 - (y / b) ** 2, ">=")
        if (y - a).is_zero():  # back where it started
            return [(zero, b, zero), (2 * f["atan"](b / a), -b, b / a)], []
        if (y + a).is_zero():
            tangent = -a / b
            slope = (b * (1 - tangent * tangent) - 2 * a * tangent) / (1 + tangent * tangent)
            return [(2 * f["atan"](tangent), slope, tangent), (pi, -b, None)], []
        # (y + a) T^2 - 2 b T + (y - a) = 0 with T = tan(tau/2), and the slope is plus or minus the root
        root = field.sqrt(real, self.model.samples.is_negative)
        tangents = [(sign, (b - sign * root) / (y + a)) for sign in (1, -1)]
        return [(2 * f["atan"](tangent), sign * root, tangent) for sign, tangent in tangents], _unless_zero(real, ">=")


@dataclass(frozen=True)
class Growth(MotionLaw):
    """Away from a centre, or towards it for ever."""

    center: Ratio
    square: Ratio  # k^2

    @property
    def _first_acceleration(self) -> Ratio:
        return self.q0 - self.center

    @property
    def k(self) -> Ratio:
        return self.model.field.sqrt(self.square, self.model.samples.is_negative)

    def at(self, t: Ratio) -> tuple[Ratio, Ratio]:
        k, f = self.k, functions(self.model.field, self.model.samples.is_negative)
        c, s = f["cosh"](k * t), f["sinh"](k * t)
        x0 = self.q0 - self.center
        return self.center + x0 * c + self.u0 / k * s, self.u0 * c + x0 * k * s

    def places(self, value: Ratio) -> Instants:
        k = self.k
        found, needs = self._logs(self.q0 - self.center, self.u0 / k, value - self.center)
        return [LawInstant(tau / k, value, k * slope, key) for tau, slope, key in found], needs

    def rates(self, value: Ratio) -> Instants:
        k = self.k
        found, needs = self._logs(self.u0, k * (self.q0 - self.center), value)
        return [LawInstant(tau / k, self.center + slope / k, value, key) for tau, slope, key in found], needs

    def _logs(self, a: Ratio, b: Ratio, y: Ratio) -> tuple[list[_Turn], list[_Need]]:
        """tau with a cosh(tau) + b sinh(tau) = y, each with d/dtau there and a key; E = exp(tau) is a root of
        (a + b) E^2 - 2 y E + (a - b) = 0."""
        field = self.model.field
        log = functions(field, self.model.samples.is_negative)["log"]
        if (a + b).is_zero():  # it comes to rest at the centre, but only after all time
            if y.is_zero():
                return [], []
            return [(log(a / y), -y, a / y - 1)], []
        if b.is_zero():  # from rest
            ratio = y / a
            if sign_of(ratio - 1) is Sign.NEGATIVE:
                return [], [(ratio - 1, ">")]
            root = field.sqrt(ratio * ratio - 1, self.model.samples.is_negative)
            return [(log(ratio + root), a * root, ratio - 1)], []
        if a.is_zero():  # from the centre
            ratio = y / b
            root = field.sqrt(ratio * ratio + 1, self.model.samples.is_negative)
            return [(log(ratio + root), b * root, ratio)], []
        if sign_of(y * y - a * a + b * b) is Sign.NEGATIVE:
            return [], [(y * y - a * a + b * b, ">=")]
        root = field.sqrt(y * y - a * a + b * b, self.model.samples.is_negative)
        growths = [(sign, (y + sign * root) / (a + b)) for sign in (1, -1)]
        found: list[_Turn] = [
            (log(growth), sign * root, growth - 1) for sign, growth in growths if not growth.is_zero()
        ]
        return found, _unless_zero(y * y - a * a + b * b, ">=")


@dataclass(frozen=True)
class Decay(MotionLaw):
    """A resistance that is linear in the rate: u tends to `end`, or leaves it."""

    end: Ratio
    gamma: Ratio

    @property
    def _first_acceleration(self) -> Ratio:
        return self.u0 - self.end

    def at(self, t: Ratio) -> tuple[Ratio, Ratio]:
        grown = functions(self.model.field, self.model.samples.is_negative)["exp"](self.gamma * t)
        over = self.u0 - self.end
        return self.q0 + self.end * t + over * (grown - 1) / self.gamma, self.end + over * grown

    def places(self, value: Ratio) -> Instants:
        if not self.end.is_zero() or self.u0.is_zero():
            return None  # the time stands in a sum of itself and an exponential
        grown = 1 + self.gamma * (value - self.q0) / self.u0
        log = functions(self.model.field, self.model.samples.is_negative)["log"]
        return [LawInstant(log(grown) / self.gamma, value, self.u0 * grown, (value - self.q0) / self.u0)], [
            (grown, ">")
        ]

    def rates(self, value: Ratio) -> Instants:
        grown = (self.end - value) / (self.end - self.u0)
        log = functions(self.model.field, self.model.samples.is_negative)["log"]
        time = log(grown) / self.gamma
        place = self.q0 + (value - self.u0 + self.gamma * self.end * time) / self.gamma
        return [LawInstant(time, place, value, (grown - 1) / self.gamma)], [(grown, ">")]


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


def _order(model: SymbolicModel, chosen: LawInstant, n: int, others: Sequence[LawInstant]) -> list[_Need]:
    """Why an instant (a period later for n = 1) comes first: it is after the start, and each other either was before it
    or is later."""
    needs: list[_Need] = []
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


def _unless_zero(x: Ratio, relation: str) -> list[_Need]:
    """A need, unless it is met as an equation: then two instants are one."""
    return [] if x.is_zero() else [(x, relation)]
