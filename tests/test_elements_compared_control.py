"""Controllers beside what follows by hand: a pole that a motor holds aside, with and without the weight fed forward."""

from __future__ import annotations

import math

import pytest

import freebody as fb
from posed import is_formula

POLE = """
parameters: {{m: 1 kg, L: 0.5 m, g: 9.81 m/s^2, kp: 20 N m, kd: 2 N m s, th0: 3 deg}}
ground: {{points: {{O: [0, 0]}}}}
bodies: {{pole: {{rod: {{mass: m, length: L}}}}}}
connections: {{O: {{pin: [ground.O, pole.start]}}}}
loads:
  weight: {{gravity: g}}
  motor: {{law: {{measure: theta, force: "{torque} - kd*rate(theta)"}}}}
measures: {{theta: angle of pole from up clockwise}}
start: {{theta: {start}, rate(theta): 0}}
"""
FED_FORWARD = "-kp*(theta - th0) - m*g*L/2*sin(th0)"
STIFFNESS = "(kp - m*g*L/2*cos(th0))"


@pytest.mark.parametrize("start", ["3 deg", "th0", "0"])
@pytest.mark.parametrize(
    ("question", "formula"),
    [
        ("equilibrium of theta", "th0"),
        ("period of small oscillations of theta", f"2*pi*sqrt(m*L**2/(3*{STIFFNESS}))"),
        ("stability of equilibrium", f"-3*{STIFFNESS}/(m*L**2)"),
        ("damping ratio", f"kd/(2*sqrt({STIFFNESS}*m*L**2/3))"),
    ],
)
def test_a_pole_whose_weight_is_fed_forward_rests_at_the_wanted_angle(start: str, question: str, formula: str) -> None:
    """m L^2/3 x'' + kd x' + (kp - m g L/2 cos(th0)) x = 0 beside it."""
    is_formula(POLE.format(torque=FED_FORWARD, start=start), question, formula)


def test_a_pole_that_sags_has_its_verdict_from_numbers() -> None:
    """kp (theta - th0) = m g L/2 sin(theta) has no closed form; its root by Newton's method."""
    theta = math.radians(3)
    for _ in range(50):
        theta = math.radians(3) + 9.81 * 0.25 / 20 * math.sin(theta)
    stiffness = 20 - 9.81 * 0.25 * math.cos(theta)
    system = fb.System.from_text(POLE.format(torque="-kp*(theta - th0)", start="3 deg"))
    questions = ("equilibrium of theta", "period of small oscillations of theta", "stability of equilibrium")
    place, period, stable = (system.solve(question)["q1"] for question in questions)
    assert place.value == pytest.approx(theta)
    assert period.value == pytest.approx(2 * math.pi * math.sqrt(0.25 / 3 / stiffness))
    assert stable.value == pytest.approx(-3 * stiffness / 0.25)
    assert stable.verdict == "stable with the given numbers"
    assert "without damping" in system.solve(questions[2]).to_text()


def test_a_pole_that_the_motor_is_too_weak_for_falls() -> None:
    stable = fb.System.from_text(POLE.format(torque="-kp/10*(theta - th0)", start="0")).solve(
        "stability of equilibrium"
    )
    assert stable["q1"].verdict == "not stable with the given numbers"
