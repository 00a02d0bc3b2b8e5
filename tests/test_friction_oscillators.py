"""What friction alone, or a spring, swings against surfaces that move on: the slip ends where the body is as fast as
these. Source: Timoshenko, Vibration Problems in Engineering, sec. 4 (two rollers); Popp & Stelter 1990 (belt)."""

from __future__ import annotations

import math

import pytest

import freebody as fb

ROLLERS = """
parameters: {mu: 0.25, W: 30 rad/s, g: 9.81 m/s^2}
ground: {points: {A: [-0.3, -0.1], B: [0.3, -0.1]}}
bodies:
  left: {disk: {radius: 0.1 m, mass: 1 kg}, at: [-0.3, -0.1]}
  right: {disk: {radius: 0.1 m, mass: 1 kg}, at: [0.3, -0.1]}
  plank: {body: {mass: 4 kg, inertia: 1 kg m^2}, lines: {under: {along: left}}}
connections:
  axle_left: {pin: [left, ground.A]}
  axle_right: {pin: [right, ground.B]}
  motor_left: {driver: {measure: turn_left, follows: -W*t}}
  motor_right: {driver: {measure: turn_right, follows: W*t}}
  on_left: {contact: {between: [left, plank.under], friction: mu}}
  on_right: {contact: {between: [right, plank.under], friction: mu}}
loads: {weight: {gravity: g}}
measures:
  x: {x of plank}
  turn_left: {angle of left}
  turn_right: {angle of right}
start: {x: 0.1 m, rate(x): 0}
"""
X0 = 0.1
OMEGA = math.sqrt(0.25 * 9.81 / 0.3)  # N_right - N_left = m g x/d, hence x'' = -mu g x/d


@pytest.mark.slow
def test_a_plank_on_two_rollers_that_turn_inwards_swings_by_friction_alone() -> None:
    """Timoshenko's way to measure friction: T = 2 pi sqrt(d/(mu g)), 2 d from axle to axle."""
    system = fb.System.from_text(ROLLERS)
    expected = {
        "period of x": 2 * math.pi / OMEGA,
        "time when x = 0": math.pi / 2 / OMEGA,
        "velocity of x when x = 0": -X0 * OMEGA,
        "time when x turns back": math.pi / OMEGA,  # the start is at rest, pushed by friction alone
        "greatest velocity of x": X0 * OMEGA,
    }
    for question, value in expected.items():
        (answer,) = system.solve(question).answers
        assert answer.expression is not None, (question, answer.reason)
        assert answer.value == pytest.approx(value, rel=1e-12), question


def test_a_plank_sticks_to_a_slow_roller_as_soon_as_it_is_as_fast() -> None:
    """x0 w sin(w t) = R W; it is so if x0 w > R W."""
    system = fb.System.from_text(ROLLERS).with_parameters(W=1.0)
    (answer,) = system.solve("time when slipping of on_right ends").answers
    assert answer.expression is not None, answer.reason
    assert answer.value == pytest.approx(math.asin(0.1 * 1.0 / (X0 * OMEGA)) / OMEGA, rel=1e-12)


def test_a_block_on_a_belt_slips_against_its_spring_until_it_is_as_fast_as_the_belt() -> None:
    """From rest at 0 it swings about s = mu m g/k, and is as fast as the belt where s w sin(w t) = v."""
    system = fb.System.from_text("""
parameters: {m: 1 kg, k: 40 N/m, v: 0.2 m/s, mu: 0.5, g: 9.81 m/s^2}
bodies:
  belt: {body: {mass: 1 kg, inertia: 1 kg m^2}, lines: {top: {along: right}}}
  block: {particle: {mass: m}}
connections:
  guide: {slider: {body: belt, along: right}}
  motor: {driver: {measure: x of belt, follows: v*t}}
  contact: {contact: {between: [block, belt.top], friction: mu}}
loads: {weight: {gravity: g}, spring: {law: {measure: x, force: -k*x}}}
measures: {x: {x of block}}
start: {x: 0}
""")
    rest, omega = 0.5 * 9.81 / 40, math.sqrt(40.0)
    until = math.asin(0.2 / (rest * omega)) / omega
    for question, value in {
        "time when slipping of contact ends": until,
        "x when slipping of contact ends": rest * (1 - math.cos(omega * until)),
    }.items():
        (answer,) = system.solve(question).answers
        assert answer.expression is not None, (question, answer.reason)
        assert answer.value == pytest.approx(value, rel=1e-12), question
