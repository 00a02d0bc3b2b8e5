"""Quotients with both functions of a given angle below the bar, by sin^2 + cos^2 = 1."""

from __future__ import annotations

import math

import pytest

import freebody as fb

LADDER = """
parameters: {m: 12 kg, L: 4 m, alpha: 65 deg, mu: 0.4, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}, wall: {along: up, through: [0, 0]}}}
bodies: {ladder: {rod: {mass: m, length: L}, angle: alpha}}
connections:
  floor: {contact: {between: [ladder, ground.floor], friction: mu}}
  wall: {contact: {between: [ladder, ground.wall], friction: mu}}
loads: {weight: {gravity: g}}
"""


@pytest.mark.parametrize("degrees", [20.0, 45.0, 65.0, 80.0])
def test_a_ladder_as_rough_at_both_ends_stays_by_the_tangent_of_half_the_angle_from_upright(degrees: float) -> None:
    """tan((90 - alpha)/2): on the verge at both ends the lines of the reactions, turned by rho = atan mu, meet above
    the mass centre at a right angle. The middle of the ladder is that of the circle through both ends and this point,
    which lies straight above it where 2 rho = 90 degrees - alpha."""
    asked = fb.System.from_text(LADDER.replace("65 deg", f"{degrees} deg")).solve("least mu so that it stays at rest")
    answer = asked.answers[0]
    assert answer.value == pytest.approx(math.tan(math.radians(90.0 - degrees) / 2), rel=1e-10)
    assert str(answer.to_plain()["expression"]) == "(1 - sin(alpha))/cos(alpha)"
