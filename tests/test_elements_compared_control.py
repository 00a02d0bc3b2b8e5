"""Controllers beside what follows by hand: a pole that a motor holds aside, with and without the weight fed forward."""

from __future__ import annotations

import math

import numpy as np
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


CART = """
parameters: {M: 2 kg, m: 0.5 kg, L: 0.6 m, g: 9.81 m/s^2, b: 0.4 kg/s, tau: 0.05 s, w: {value: 0.02 rad, sign: any}}
bodies: {cart: {particle: {mass: M}}, bob: {particle: {mass: m}, near: {at: [0, L]}}}
connections: {track: {slider: {body: cart, along: right}}, pole: {link: {first: cart, second: bob, length: L}}}
loads:
  weight: {gravity: g}
  push: {force: {at: cart, along: right, magnitude: 0 N}}
  held: {force: {at: cart, along: right, magnitude: (40 N)*(u - w)}}
  rub: {drag: {body: cart, linear: b}}
states: {u: (th - u)/tau}
measures: {x: x of cart, th: angle of line from cart to bob from up clockwise}
start: {x: 0, rate(x): 0, th: 0, rate(th): 0}
"""


def test_a_cart_with_a_pole_has_the_state_space_of_its_linear_equations() -> None:
    """M x'' = F - b x' - m g th, M L th'' = (M + m) g th - F + b x', F = push + 40 (u - w), u' = (th - u)/tau."""
    system = fb.System.from_text(CART.replace("value: 0.02 rad", "value: 0 rad"))
    A, B, C, D = system.modes().state_space(["push", "w"], ["th", "rate(rate(x))", "rate(rate(th))"])
    M, m, L, g, b, k = 2.0, 0.5, 0.6, 9.81, 0.4, 40.0
    x = np.array([0.0, -m * g, -b, 0.0, k]) / M  # of x, th, x', th', u
    th = np.array([0.0, (M + m) * g, b, 0.0, -k]) / (M * L)
    rates = np.array([[0, 0, 1, 0, 0], [0, 0, 0, 1, 0], x, th, [0, 1 / 0.05, 0, 0, -1 / 0.05]])
    assert np.sort_complex(np.linalg.eigvals(A)) == pytest.approx(np.sort_complex(np.linalg.eigvals(rates)), abs=1e-6)
    pushed = np.array([[0, 0], [0, 0], [1 / M, -k / M], [-1 / (M * L), k / (M * L)], [0, 0]])
    seen = np.array([[0, 1, 0, 0, 0], x, th])
    through = np.array([[0, 0], [1 / M, -k / M], [-1 / (M * L), k / (M * L)]])
    assert pytest.approx(through, abs=1e-7) == D
    for s in (0.7j, 3.0j, 1.0 + 2.0j):  # in whatever order the states are
        ours = seen @ np.linalg.solve(s * np.eye(5) - rates, pushed) + through
        assert C @ np.linalg.solve(s * np.eye(len(A)) - A, B) + D == pytest.approx(ours, rel=1e-6)
