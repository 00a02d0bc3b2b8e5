"""Extremes of what swings with several frequencies at once, as drives and loads lead it:

    x = m + sum of A_k cos(W_k t) + B_k sin(W_k t),        |x - m| <= sum of R_k,    R_k^2 = A_k^2 + B_k^2.

Where no integer combination of the frequencies vanishes, the phases W_k t come as close as one likes to any that are
wanted (Kronecker), so the bound is the least one; it is reached where all waves are at their crests at once, as at
t = 0 those are that are cosines of one sign. Of two frequencies whose ratio is irrational no other instant comes twice.
Source: Hardy & Wright, An Introduction to the Theory of Numbers, ch. XXIII.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any, cast

import numpy as np

from freebody.errors import CannotAnswer, SaysNothing
from freebody.language.notation import to_text
from freebody.language.sentences import Message
from freebody.numeric.jets import Array
from freebody.questions.base import Quantity
from freebody.questions.reading import Question
from freebody.questions.steady import Extremes
from freebody.study.answering.answer import Evidence
from freebody.study.answering.crosscheck import MOTION_TOLERANCE, CrossCheck, broken, element_at
from freebody.study.answering.draws import Draw
from freebody.study.answering.finding import Finding, NotHere
from freebody.study.answering.repeated import checked
from freebody.study.answering.witness import states_at
from freebody.study.setup import Setup
from freebody.study.steady.drive import components, followed
from freebody.symbolic.closure import explicit
from freebody.symbolic.conditions import Condition
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign, sign_of
from freebody.symbolic.tidy import tidy
from freebody.symbolic.time_terms import TimeTerms

_SPAN, _PER_PERIOD, _MOST_INSTANTS = 6, 7, 3000  # longest periods that are fitted, instants in each of the shortest
_FITS = 1e-6
_MOST_SHARE = 1000  # of whole numbers that frequencies are as
_SAME = 1e-12
_PER_WAVE, _ROUNDS = 64, 5  # instants at which a wave is looked at, again and again about the best one
_NEVER = Message("a bound that is approached as closely as one likes, but never reached")
_APPROACHED = Message("the least bound: the motion comes as close to it as one likes")


@dataclass(frozen=True)
class Superposed:
    """is_size: whether it is the size |x| that is asked for."""

    model: SymbolicModel
    x: Ratio
    terms: TimeTerms
    is_size: bool

    @property
    def mean(self) -> Ratio:
        return self.terms.powers.get(0, self.model.field.zero)

    @property
    def rates(self) -> list[Ratio]:
        f = self.model.field
        return [f.lowest_terms(f.derivative(angle, f.index(f.time))) for angle, _a, _b in self.terms.waves]

    def amplitude(self, a: Ratio, b: Ratio) -> Ratio:
        f, is_negative = self.model.field, self.model.samples.is_negative
        if a.is_zero() or b.is_zero():
            size = a + b
            return -size if is_negative(size) else size
        return f.sqrt(f.lowest_terms(a * a + b * b), is_negative)

    def bound(self, side: int) -> Ratio:
        """The least upper bound, or the greatest lower one. Raises CannotAnswer of the least size, which is zero or
        not by more than the bounds tell."""
        f = self.model.field
        swing = sum((self.amplitude(a, b) for _angle, a, b in self.terms.waves), f.zero)
        if not self.is_size:
            return f.lowest_terms(self.mean + side * swing)
        if side < 0 and self.mean.is_zero():
            return f.zero
        if side < 0:
            raise CannotAnswer(Message("how small a size gets that swings with several frequencies was not decided"))
        mean = self.mean
        is_below = not mean.is_zero() and self.model.samples.is_negative(mean)
        return f.lowest_terms((-mean if is_below else mean) + swing)

    def is_reached(self, side: int) -> bool:
        """Whether all waves are at their crests, or troughs, at t = 0."""
        signs = {sign_of(a) for _angle, a, _b in self.terms.waves}
        if not all(b.is_zero() for _angle, _a, b in self.terms.waves) or len(signs) != 1:
            return False
        (sign,) = signs
        if not self.is_size:
            return sign is (Sign.POSITIVE if side > 0 else Sign.NEGATIVE)
        means = sign_of(self.mean)
        return side > 0 and sign.is_strict and means in (Sign.ZERO, sign)

    @property
    def never_comes(self) -> bool:
        """Whether crests never meet: of two waves with phases that are parts of pi and signs that are known, the ratio
        of whose frequencies is irrational."""
        sides = [self.mean] if self.is_size and not self.mean.is_zero() else []
        for _angle, a, b in self.terms.waves:
            if not a.is_zero() and not b.is_zero():
                return False
            sides.append(a + b)
        return len(self.terms.waves) == 2 and all(sign_of(x).is_strict for x in sides)


def _vector(of: Quantity) -> Quantity:
    """What a size is of."""
    return cast("Quantity", replace(cast("Any", of), size=False))


def superposed_of(setup: Setup, of: Quantity) -> Superposed | None:
    """None where it is not led by several waves, or powers, of the time alone."""
    model, is_size = setup.model, bool(getattr(of, "size", False))
    value = followed(setup, _vector(of) if is_size else of)
    parts = [model.field.lowest_terms(model.field.element(part)) for part in components(value)]
    led = [part for part in parts if not part.is_zero()]
    if len(led) != 1:
        return None
    x = explicit(model, led[0])
    terms = TimeTerms.of(x, model.field.index(model.field.time))
    return None if terms is None else Superposed(model, x, terms, is_size)


def superposed(setup: Setup, question: Question, q: Extremes, found: Superposed) -> Finding:
    """Raises CannotAnswer where there is no such extreme."""
    _refuse_growth(found, q)
    if q.what == "time ratio":
        raise CannotAnswer(Message("it is meant of an angle that turns evenly"))
    f = setup.model.field
    low, high = (found.bound(side) if _wants(q, side) else f.zero for side in (-1, 1))
    conditions = setup.holding(setup.state)
    element = {"least": low, "greatest": high, "stroke": f.lowest_terms(high - low)}.get(q.what, (low, high))
    sides = [side for side in (-1, 1) if _wants(q, side)]
    is_reached = all(found.is_reached(side) for side in sides)
    notes, says, has_value = list[str](), list[str](), True
    if is_reached:
        notes.append(Message("reached at t = 0, where all waves are at their crests"))
    else:
        rates = [to_text(tidy(rate)) for rate in found.rates]
        notes.append(_NEVER if found.never_comes else _APPROACHED)
        says.append(
            Message(
                "no sum of whole multiples of {rates} is zero (else it is a bound that need not be approached)",
                rates=", ".join(rates),
            )
        )
        own = _repeats(setup, found)
        if own is not None:
            has_value = False
            notes.append(_own_note(found, q, own, question.quantity.unit))
    evidence = _evidence(setup, question.text, q, found, conditions)
    return Finding(element, evidence, conditions, notes, says, has_value=has_value)


@dataclass(frozen=True)
class _Repeated:
    """With the model's own numbers the motion repeats itself: whole numbers that the frequencies are as, the period,
    and the extremes."""

    shares: tuple[int, ...]
    period: float
    low: float
    high: float


def _repeats(setup: Setup, found: Superposed) -> _Repeated | None:
    """None where there are no numbers, or no short common period."""
    if not setup.has_values or not setup.draws:
        return None
    draw, waves = setup.draws[0], found.terms.waves
    flat = (found.mean, *found.rates, *(x for _angle, a, b in waves for x in (a, b)))
    mean, *numbers = element_at(setup, flat, draw, draw.start())
    rates, sizes = [abs(v) for v in numbers[: len(waves)]], np.array(numbers[len(waves) :]).reshape(-1, 2)
    ratios = [Fraction(rate / rates[0]).limit_denominator(_MOST_SHARE) for rate in rates]
    if any(abs(float(r) - rate / rates[0]) > _SAME * float(r) for r, rate in zip(ratios, rates, strict=True)):
        return None
    below = math.lcm(*(r.denominator for r in ratios))
    shares = [int(r * below) for r in ratios]
    shares = [n // math.gcd(*shares) for n in shares]
    if max(shares) > _MOST_SHARE:
        return None
    period = math.tau * shares[0] / rates[0]
    senses = [math.copysign(1.0, v) for v in numbers[: len(waves)]]

    def at(t: Array) -> Array:
        swings = [
            a * np.cos(rate * t) + sense * b * np.sin(rate * t)
            for rate, sense, (a, b) in zip(rates, senses, sizes, strict=True)
        ]
        whole = mean + np.sum(swings, axis=0)
        return np.abs(whole) if found.is_size else whole

    low, high = (
        side * _largest(lambda t, side=side: side * at(t), period, _PER_WAVE * max(shares)) for side in (-1, 1)
    )
    return _Repeated(tuple(shares), period, low, high)


def _largest(x: Callable[[Array], Array], period: float, n: int) -> float:
    """Seen at n instants, then closer and closer about the best one."""
    begin, end, best = 0.0, period, -math.inf
    for _ in range(_ROUNDS):
        times = np.linspace(begin, end, n + 1)
        values = x(times)
        k = int(np.argmax(values))
        best = max(best, float(values[k]))
        begin, end, n = float(times[max(k - 1, 0)]), float(times[min(k + 1, n)]), _PER_WAVE
    return best


def _own_note(found: Superposed, q: Extremes, own: _Repeated, unit: str) -> str:
    extremes = [own.low] if not _wants(q, 1) else [own.high] if not _wants(q, -1) else [own.low, own.high]
    values = [own.high - own.low] if q.what == "stroke" else extremes
    return Message(
        "with the given numbers the frequencies are as {shares}, so that the motion repeats itself after "
        "{period:.5g} s; within that it is {values}",
        shares=" : ".join(map(str, own.shares)),
        period=own.period,
        values=", ".join(f"{v:.5g} {unit}".strip() for v in values),
    )


def _wants(q: Extremes, side: int) -> bool:
    return q.what not in ("least", "greatest") or (q.what == "greatest") == (side > 0)


def _refuse_growth(found: Superposed, q: Extremes) -> None:
    n = max((k for k, a in found.terms.powers.items() if not a.is_zero()), default=0)
    if not n:
        return
    rises = sign_of(found.terms.powers[n])
    unbounded = {-1, 1} if not rises.is_strict else {1 if rises is Sign.POSITIVE or found.is_size else -1}
    if any(_wants(q, side) for side in unbounded) and (rises.is_strict or found.is_size):
        raise CannotAnswer(Message("it grows without bound as time goes on, so there is no such extreme"))
    raise CannotAnswer(Message("no closed form was found for how far it gets"))


def bounds_in_numbers(setup: Setup, draw: Draw, of: Quantity, found: Superposed) -> tuple[float, float]:
    """The bounds by the waves of the same frequencies that fit the quantity in a numerical integration. Raises
    CannotAnswer where these do not fit."""
    start = draw.start()
    rates: Array = np.abs(np.array(element_at(setup, tuple(found.rates), draw, start)))
    alone = _vector(of) if found.is_size else of
    slowest, fastest = float(rates.min()), float(rates.max())
    n_times = int(_PER_PERIOD * _SPAN * fastest / slowest) + 1
    times: Array = np.linspace(0.0, _SPAN * math.tau / slowest, n_times)
    if len(times) > _MOST_INSTANTS:
        raise SaysNothing(Message("the frequencies are too far apart to be followed together"))
    seen = [components(alone.value(setup.system, s)) for s in states_at(draw.reference, start, start.t + times)]
    values = np.array(seen, dtype=float)
    values = values[:, int(np.argmax(np.abs(values).max(axis=0)))]
    t = (start.t + times)[:, None] * rates
    basis = np.hstack([np.ones((len(times), 1)), np.cos(t), np.sin(t)])
    fitted, *_rest = np.linalg.lstsq(basis, values, rcond=None)
    if np.abs(basis @ fitted - values).max() > _FITS * np.abs(values).max():
        raise CannotAnswer(Message("in numbers it does not swing with these frequencies alone"))
    n = len(rates)
    mean, swing = float(fitted[0]), float(np.hypot(fitted[1 : n + 1], fitted[n + 1 :]).sum())
    if found.is_size:
        return 0.0, abs(mean) + swing
    return mean - swing, mean + swing


def _evidence(setup: Setup, text: str, q: Extremes, found: Superposed, conditions: Sequence[Condition]) -> Evidence:
    sides = [side for side in (-1, 1) if _wants(q, side)]
    values = tuple(found.bound(side) for side in sides)
    check = CrossCheck(text, Message("waves of these frequencies, fitted to a numerical integration"), MOTION_TOLERANCE)

    def numbers(draw: Draw) -> tuple[float, ...]:
        low, high = bounds_in_numbers(setup, draw, q.of, found)
        return tuple(low if side < 0 else high for side in sides)

    evidence = checked(setup, check, values, conditions, numbers)
    if evidence is None:
        needs = ", ".join(broken(setup, conditions))
        raise NotHere(Message("the motion is another one at the model's own values: that needs {x}", x=needs))
    return evidence
