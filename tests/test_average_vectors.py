"""The average velocity and acceleration of a point on the way to an event, with components."""

from __future__ import annotations

import pytest

from freebody.language.expression import FLOAT_FUNCTIONS, evaluate
from freebody.language.parser import parse
from posed import posed

THROWN = """
parameters: {m: 2 kg, v0: 10 m/s, al: 50 deg, g: 9.81 m/s^2, t1: 0.5 s}
bodies: {b: {particle: {mass: m}, at: [0, 0], velocity: [v0*cos(al), v0*sin(al)]}}
loads: {weight: {gravity: g}}
measures: {x: x of b, y: y of b}
"""
VALUES = {"m": 2.0, "v0": 9.0, "al": 0.8, "g": 9.7, "t1": 0.4}


@pytest.mark.parametrize(
    ("question", "by_hand"),
    [
        ("average velocity of b until t = t1", ("v0*cos(al)", "v0*sin(al) - g*t1/2")),
        ("average velocity of b until y = 0", ("v0*cos(al)", "0")),
        ("mean acceleration of b until y = 0", ("0", "-g")),
    ],
)
def test_the_average_of_a_thrown_body_is_the_change_over_the_time(question: str, by_hand: tuple[str, str]) -> None:
    answer = posed(THROWN, question)
    assert isinstance(answer.expression, tuple)
    assert answer.evidence is not None
    for part, formula in zip(answer.expression, by_hand, strict=True):
        here, wanted = (evaluate(e, VALUES, FLOAT_FUNCTIONS) for e in (part, parse(formula)))
        assert here == pytest.approx(wanted, abs=1e-12)
