"""Events on the way of what turns back against friction: which of two ways leads to a place is told by conditions."""

from __future__ import annotations

import math

import pytest

import freebody as fb

SLOPE = """
freebody: 1
parameters: {m: 2 kg, alpha: 25 deg, mu: 0.2, v0: 5 m/s, p: {value: 1 m, sign: any}, g: 9.81 m/s^2}
ground: {lines: {slope: {along: alpha}}}
bodies: {block: {particle: {mass: m}}}
connections: {slope: {contact: {between: [block, ground.slope], friction: mu}}}
loads: {weight: {gravity: g}}
measures: {s: {displacement of block along alpha}}
start: {s: 0, rate(s): v0}
"""
OSCILLATOR = """
freebody: 1
parameters: {m: 2 kg, k: 200 N/m, F: 2 N, A: 0.2 m, v: 1 m/s}
bodies: {mass: {particle: {mass: m}}}
connections:
  guide: {slider: {body: mass, along: right}}
  rub: {dry_friction: {measure: x, force: F}}
loads: {spring: {law: {measure: x, force: -k*x}}}
measures: {x: {x of mass}}
start: {x: A, rate(x): v}
"""


def test_place_below_the_start_is_reached_on_the_way_back_alone() -> None:
    """What has not been reached on the way up is so for p < 0 alone: at 0 < p it was passed before."""
    system = fb.System.from_text(SLOPE)
    (up,) = system.solve("speed of block when s = p").answers
    alpha, mu, v0, g = math.radians(25), 0.2, 5.0, 9.81
    assert up.value == pytest.approx(math.sqrt(v0**2 - 2 * g * (math.sin(alpha) + mu * math.cos(alpha))))
    assert len(up.cases) == 2
    assert all("p > 0" in case.conditions or "p < 0" in case.conditions for case in up.cases)
    (down,) = system.with_parameters(p=-1.0).solve("speed of block when s = p").answers
    top = v0**2 / (2 * g * (math.sin(alpha) + mu * math.cos(alpha)))
    fall = 2 * g * (math.sin(alpha) - mu * math.cos(alpha)) * (top + 1.0)
    assert down.value == pytest.approx(math.sqrt(fall))


def test_way_to_a_place_behind_the_first_turn_has_no_condition_that_is_an_equality() -> None:
    """(S - F)/k is where it turns, with S^2 = (k A + F)^2 + m k v^2; the way is from A to there and back to 0.1 m."""
    (found,) = fb.System.from_text(OSCILLATOR).solve("distance travelled until x = 0.1 m").answers
    turn = (math.sqrt((200 * 0.2 + 2) ** 2 + 2 * 200 * 1.0) - 2) / 200
    assert found.value == pytest.approx((turn - 0.2) + (turn - 0.1), rel=1e-9)
    assert found.conditions[0] == "10·A > 1"
    assert all("≥" not in condition for condition in found.conditions)
