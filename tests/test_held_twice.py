"""What a cable and dry friction hold together: how they share it nothing says, and no number is told."""

from __future__ import annotations

import math

import pytest

from freebody import System

SLEDGE = """
parameters: {{m: 60 kg, alpha: 20 deg, mu: 0.15, g: 9.81 m/s^2}}
ground: {{lines: {{slope: {{along: alpha}}}}, points: {{W: [12 m*cos(alpha), 12 m*sin(alpha)]}}}}
bodies: {{sledge: {{particle: {{mass: m}}}}, drum: {{body: {{inertia: 1.2 kg m^2, radius: 0.15 m}}}}}}
connections:
  axle: {{pin: [ground.W, drum]}}
  slope: {{contact: {{between: [sledge, slope]{friction}}}}}
  cable: {{string: {{from: sledge, to: drum.center}}}}
loads: {{weight: {{gravity: g}}, motor: {{torque: {{on: drum, magnitude: 70 N m}}}}}}
measures: {{s: travel of sledge along slope}}
start: {{s: 0, rate(s): 0}}
questions: {{it: tension of cable}}
"""


def test_a_tension_beside_friction_that_may_be_any_has_no_number() -> None:
    """Between m g (sin a - mu cos a) and m g (sin a + mu cos a) all tensions balance. The cable is tied to an axle, on
    which the drum turns idly."""
    (answer,) = System.from_text(SLEDGE.format(friction=", friction: mu")).solve().answers
    assert (answer.expression, answer.value) == (None, None)
    assert "not unique" in str(answer.reason)


def test_a_tension_without_friction_has_one() -> None:
    (answer,) = System.from_text(SLEDGE.format(friction="")).solve().answers
    assert answer.value == pytest.approx(60 * 9.81 * math.sin(math.radians(20)), rel=1e-12)


def test_friction_that_carries_a_block_along_is_unique_however_its_corners_share_it() -> None:
    """m_A a with a = P/(m_A + m_B): up to P = mu g (m_A + m_B)/2 half of what can be held is needed."""
    system = System.from_text("""
parameters: {mA: 4 kg, mB: 8 kg, mu: 0.3, P: 20 N, g: 9.81 m/s^2}
bodies:
  B: {rectangle: {mass: mB, width: 2 m, height: 0.2 m}, at: [0, 0.1 m]}
  A: {rectangle: {mass: mA, width: 0.3 m, height: 0.2 m}, at: [0, 0.3 m]}
connections:
  rail: {slider: {body: B, along: right}}
  top: {contact: {between: [A, B], friction: mu}}
loads: {weight: {gravity: g}, pull: {force: {at: B, along: right, magnitude: P}}}
questions: {it: value of P for which friction force of top = mu*mA*g/2}
""")
    (answer,) = system.solve().answers
    assert answer.value == pytest.approx(0.3 * 9.81 * 12 / 2, rel=1e-9)
