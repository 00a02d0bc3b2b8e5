"""Extremes of a quantity that is linear in coupled coordinates and their rates, of which one mode swings:

    x = m + A cos(w t) + (B/w) sin(w t),     m - sqrt(A^2 + B^2/w^2) <= x <= m + sqrt(A^2 + B^2/w^2).

Two carts that are joined by a spring: their common motion is uniform, and each is fastest as the spring goes through
its natural length.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from freebody.language.sentences import Message
from freebody.questions.base import Quantity
from freebody.study.answering.crosscheck import MOTION_TOLERANCE, CrossCheck, broken
from freebody.study.answering.draws import Draw
from freebody.study.answering.finding import Finding, NotHere
from freebody.study.answering.motion_values import extremes_between
from freebody.study.answering.repeated import checked, held_throughout
from freebody.study.setup import Setup
from freebody.symbolic.coupled import ModalWave
from freebody.symbolic.field import Ratio


def wave_of(setup: Setup, of: Quantity) -> ModalWave | None:
    """How a quantity swings, where it is that of coupled coordinates. Raises CannotAnswer where several modes do."""
    model, f = setup.model, setup.model.field
    if len(model.coordinates) < 2 or model.dependent:
        return None
    value = of.value(setup.system, setup.state)
    if isinstance(value, tuple):
        return None
    x = f.lowest_terms(model.in_independent_speeds(f.element(value)))
    return _wave(setup, x)


def wave_of_size(setup: Setup, of: Quantity) -> ModalWave | None:
    """The rate that swings about zero of which a quantity is the size, as the speed of one of two carts."""
    model, f = setup.model, setup.model.field
    value = of.value(setup.system, setup.state)
    if len(model.coordinates) < 2 or model.dependent or isinstance(value, tuple):
        return None
    x = f.lowest_terms(model.in_independent_speeds(f.element(value)))
    for c in model.coordinates:
        factor = f.lowest_terms(x * x / (f.variable(c.speed) * f.variable(c.speed)))
        if factor.is_constant() and not factor.is_zero():
            wave = _wave(setup, f.sqrt(factor, model.samples.is_negative) * f.variable(c.speed))
            return wave if wave is not None and wave.mean.is_zero() else None
    return None


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


def find(
    setup: Setup, question: str, of: Quantity, wave: ModalWave, sides: Sequence[int], *, is_size: bool = False
) -> Finding:
    """The closed form. sides: -1 for the least value, +1 for the greatest, in the order in which they are wanted.
    is_size: whether the quantity is the size of what swings, about zero."""
    f = setup.model.field
    if wave.cosine.is_zero() or wave.sine.is_zero():
        size = setup.state.absolute(wave.cosine if wave.sine.is_zero() else wave.sine)
        size = size if wave.sine.is_zero() else size / f.sqrt(wave.square, setup.model.samples.is_negative)
    else:
        inside = wave.cosine * wave.cosine + wave.sine * wave.sine / wave.square
        size = f.sqrt(f.lowest_terms(inside), setup.model.samples.is_negative)
    values = tuple(f.lowest_terms(wave.mean + (max(side, 0) if is_size else side) * size) for side in sides)
    conditions = held_throughout(setup)

    def numbers(draw: Draw) -> tuple[float, ...]:
        square = setup.model.samples.numbers(draw.sample(draw.start()))
        period = 2 * np.pi / np.sqrt(float(f.evaluate(wave.square, square)))
        low, high = extremes_between(setup, draw, of, 0.0, 1.5 * float(period))
        return tuple(low if side < 0 else high for side in sides)

    check = CrossCheck(question, Message("numerical integration over a cycle of the motion"), MOTION_TOLERANCE)
    shown: Ratio | tuple[Ratio, ...] = values if len(values) > 1 else next(iter(values))
    evidence = checked(setup, check, values, conditions, numbers)
    if evidence is None:
        needs = ", ".join(broken(setup, conditions))
        raise NotHere(Message("the motion is another one at the model's own values: that needs {x}", x=needs))
    return Finding(shown, evidence, conditions)
