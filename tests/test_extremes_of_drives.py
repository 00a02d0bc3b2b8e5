"""What varies with the phase of a drive has its extremes over one period; each is derived by hand here."""

from __future__ import annotations

import math

import pytest

from posed import is_derived, is_formula, posed

TABLE = """
parameters: {m: 2 kg, A: 0.03 m, W: 15 rad/s, g: 9.81 m/s^2}
bodies: {table: {particle: {mass: m}}}
connections:
  guide: {slider: {body: table, along: up, through: ground.O}}
  shaker: {driver: {measure: y of table, follows: A*cos(W*t)}}
loads: {weight: {gravity: g}}
measures: {y: y of table}
"""
ARM = """
parameters: {m: 2 kg, L: 0.8 m, W: 3 rad/s, b: 30 deg}
bodies: {arm: {rod: {length: L, mass: m}}}
connections: {hinge: {pin: [ground.O, arm.start]}, drive: {driver: {measure: phi, follows: b*sin(W*t)}}}
measures: {phi: angle of arm}
"""
ELLIPSE = """
parameters: {m: 2 kg, a: 0.1 m, b: 0.05 m, W: 4 rad/s}
bodies: {p: {particle: {mass: m}}}
connections:
  across: {driver: {measure: x of p, follows: a*cos(W*t)}}
  upward: {driver: {measure: y of p, follows: b*sin(W*t)}}
measures: {x: x of p, y: y of p}
"""
EIGHT = ELLIPSE.replace("b*sin(W*t)", "b*sin(2*W*t)")


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        (TABLE, "greatest y", "A"),
        (TABLE, "greatest velocity of y", "A*W"),
        (TABLE, "greatest |velocity of table|", "A*W"),
        (TABLE, "least acceleration of y", "-A*W^2"),
        # F = m (g + y''), y'' = -A W^2 cos(W t)
        (TABLE, "greatest force of shaker", "m*(g + A*W^2)"),
        (TABLE, "least force of shaker", "m*(g - A*W^2)"),
        (TABLE, "value of W for which least force of shaker = 0", "sqrt(g/A)"),
        # the end: at the turn L b W^2 along the path, in the middle L (b W)^2 to the hinge; b < 1
        (ARM, "greatest |velocity of arm.end|", "L*b*W"),
        (ARM, "greatest |acceleration of arm.end|", "L*b*W^2"),
        (ELLIPSE, "greatest |velocity of p|", "a*W"),
        (ELLIPSE, "least |velocity of p|", "b*W"),
        # v^2 = W^2 (a^2 s^2 + 4 b^2 (1 - 2 s^2)^2), convex in s^2: greatest at an end
        (EIGHT, "greatest |velocity of p|", "W*sqrt(a^2 + 4*b^2)"),
    ],
)
def test_extremes_over_the_period_of_a_drive(model: str, question: str, formula: str) -> None:
    is_formula(model, question, formula)


def test_they_are_derived_by_the_phase() -> None:
    told = is_derived(TABLE, "greatest force of shaker")
    assert "with the phase W·t" in told["en"]
    assert "mit der Phase W·t" in told["de"]
    is_derived(EIGHT, "greatest |velocity of p|")
    is_derived(TABLE, "greatest y")


def test_without_a_closed_form_there_is_the_number() -> None:
    answer = posed(ARM, "least y of arm.end")  # L sin(b sin(W t))
    assert answer.expression is None
    assert answer.value == pytest.approx(-0.8 * math.sin(math.pi / 6))
