"""Extremes of a quantity that is linear in coupled coordinates and their rates, of which one mode swings:

    x = m + A cos(w t) + (B/w) sin(w t),     m - sqrt(A^2 + B^2/w^2) <= x <= m + sqrt(A^2 + B^2/w^2).

Two carts that are joined by a spring: their common motion is uniform, and each is fastest as the spring goes through
its natural length. The size of such a quantity, as a speed, is at most |m| + sqrt(...), and at least
|m| - sqrt(...) or 0.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.questions.base import Quantity
from freebody.study.answering.crosscheck import MOTION_TOLERANCE, CrossCheck, broken
from freebody.study.answering.draws import Draw
from freebody.study.answering.finding import Finding, NotHere
from freebody.study.answering.motion_values import extremes_between
from freebody.study.answering.repeated import checked, held_throughout
from freebody.study.setup import Setup
from freebody.symbolic.conditions import Condition, require
from freebody.symbolic.coupled import ModalWave
from freebody.symbolic.ratio import Ratio


@dataclass(frozen=True)
class Swing:
    """A quantity that is a wave, or the size of one."""

    wave: ModalWave
    is_size: bool


def wave_of(setup: Setup, of: Quantity) -> Swing | None:
    """How a quantity swings, where it is that of coupled coordinates. Raises CannotAnswer where several modes do."""
    model, f = setup.model, setup.model.field
    if len(model.coordinates) < 2 or model.dependent:
        return None
    value = of.value(setup.system, setup.state)
    if isinstance(value, tuple):
        return None
    x = f.lowest_terms(model.in_independent_speeds(f.element(value)))
    wave = _wave(setup, x)
    if wave is not None:
        return Swing(wave, is_size=False)
    if not any(f.generators[g].kind == "root" for g in f.ingredients(x)):
        return None
    base = f.sqrt(f.lowest_terms(x * x), lambda _factor: False)
    wave = _wave(setup, f.lowest_terms(base))
    return None if wave is None else Swing(wave, is_size=True)


def _wave(setup: Setup, x: Ratio) -> ModalWave | None:
    model, f = setup.model, setup.model.field
    inside = f.ingredients(x)
    moving = [c for c in model.coordinates if {c.index, c.speed} & inside]
    if not moving or any(f.generators[g].kind == "time" for g in inside):
        return None
    coupled = setup.motion.coupled(moving[0])
    if coupled is None or any(c not in coupled.coordinates for c in moving):
        return None
    return coupled.wave_of(x)


def _size_at(setup: Setup, mean: Ratio, size: Ratio, side: int, conditions: list[Condition]) -> Ratio:
    """The greatest (side 1) or least |x| of m - S <= x <= m + S: |m| + S, and |m| - S, or 0 where x changes sign."""
    f, samples = setup.model.field, setup.model.samples
    middle = setup.state.absolute(mean)
    if side > 0:
        return f.lowest_terms(middle + size)
    gap = f.lowest_terms(middle - size)
    is_apart = not samples.is_negative(gap)
    needed, possible = require(
        gap if is_apart else -gap, ">=", Message("it keeps its sign") if is_apart else Message("it changes its sign")
    )
    if not possible:
        raise CannotAnswer(Message("which value is the extreme one was not decided"))
    if needed is not None:
        conditions.append(needed)
    return gap if is_apart else f.zero


def value_of(setup: Setup, swing: Swing, side: int, conditions: list[Condition]) -> Ratio:
    """The extreme on a side; what it needs is added to the conditions."""
    f, wave = setup.model.field, swing.wave
    if wave.cosine.is_zero() or wave.sine.is_zero():
        size = setup.state.absolute(wave.cosine if wave.sine.is_zero() else wave.sine)
        size = size if wave.sine.is_zero() else size / f.sqrt(wave.square, setup.model.samples.is_negative)
    else:
        inside = wave.cosine * wave.cosine + wave.sine * wave.sine / wave.square
        size = f.sqrt(f.lowest_terms(inside), setup.model.samples.is_negative)
    if swing.is_size:
        return _size_at(setup, wave.mean, size, side, conditions)
    return f.lowest_terms(wave.mean + side * size)


def in_numbers(setup: Setup, draw: Draw, of: Quantity, swing: Swing) -> tuple[float, float]:
    """The least and the greatest value over a period, by integration."""
    f = setup.model.field
    square = setup.model.samples.numbers(draw.sample(draw.start()))
    period = 2 * np.pi / np.sqrt(float(f.evaluate(swing.wave.square, square)))
    low, high = extremes_between(setup, draw, of, 0.0, 1.5 * float(period))
    if swing.is_size and low * low <= MOTION_TOLERANCE * high * high:
        low = 0.0  # seen by its square: a size has a kink where it vanishes
    return low, high


def find(setup: Setup, question: str, of: Quantity, swing: Swing, sides: Sequence[int]) -> Finding:
    """The closed form. sides: -1 for the least value, +1 for the greatest, in the order in which they are wanted."""
    conditions = list(held_throughout(setup))
    values = tuple(value_of(setup, swing, side, conditions) for side in sides)

    def numbers(draw: Draw) -> tuple[float, ...]:
        low, high = in_numbers(setup, draw, of, swing)
        return tuple(low if side < 0 else high for side in sides)

    check = CrossCheck(question, Message("numerical integration over a cycle of the motion"), MOTION_TOLERANCE)
    shown: Ratio | tuple[Ratio, ...] = values if len(values) > 1 else next(iter(values))
    evidence = checked(setup, check, values, conditions, numbers)
    if evidence is None:
        needs = ", ".join(broken(setup, conditions))
        raise NotHere(Message("the motion is another one at the model's own values: that needs {x}", x=needs))
    return Finding(shown, evidence, conditions)
