"""A work that is zero is said to be zero, though it is added up from numbers; one that is small is not.

Two freedoms whose motion has no closed form: a rod that swings with a disk on its end that a torque spins.
"""

from __future__ import annotations

import math

import pytest

import freebody as fb
from freebody.study.answering.answer import Answer

SWING = """
parameters: {m: 2 kg, L: 1 m, w: 3 rad/s, g: 9.81 m/s^2, M: 3 N*m, F: 20 N}
ground: {points: {O: [0, 0]}}
bodies: {rod: {rod: {mass: m, length: L}}, d: {disk: {mass: m, radius: 0.2 m}}}
connections: {A: {pin: [ground.O, rod.start]}, B: {pin: [rod.end, d.center]}}
loads:
  weight: {gravity: g}
  torque: {torque: {on: d, magnitude: M}}
  pull: {force: {at: rod.end, along: rod.x, magnitude: F}}
measures: {th: {angle of rod from down}, ps: angle of d}
start: {th: 0, rate(th): w, ps: 0, rate(ps): 0}
"""


def asked(text: str, question: str) -> Answer:
    return fb.System.from_text(text).solve(question).answers[0]


@pytest.mark.parametrize(
    "question",
    [
        "work of weight until th = 0",  # what it gives on the way down it took on the way up
        "work of pull until th = 30 deg",  # at right angles to the way
        "work of pull until th = 0",
    ],
)
def test_nothing_is_said_as_zero(question: str) -> None:
    answer = asked(SWING, question)
    assert answer.expression is None
    assert answer.value == 0.0


def test_a_small_work_is_no_zero() -> None:
    """A force of 1e-9 N along the way, beside others of 20 N; and a hundredth of a degree of the whole way."""
    small = SWING.replace("F: 20 N", "F: 1e-9 N").replace("along: rod.x", "along: rod.y")
    value = asked(small, "work of pull until th = 30 deg").value
    assert value == pytest.approx(1e-9 * math.pi / 6, rel=1e-6)
    rise = 1.5 * (1.0 - math.cos(math.radians(0.01)))
    value = asked(SWING, "work of weight until th = 0.01 deg").value
    assert value == pytest.approx(-2.0 * 9.81 * rise, rel=1e-5)
