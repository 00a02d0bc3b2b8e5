"""A ball that rolls straight on in space: resistance with an arm, closed form to where it stands."""

from __future__ import annotations

import pytest

import freebody as fb
from freebody.errors import ModelError

R, F, G, V0 = 0.1, 0.002, 9.81, 1.0
BALL = """
space: {up: z}
parameters: {m: 2 kg, R: 0.1 m, mu: 0.5, f: 2 mm, v0: 1 m/s, g: 9.81 m/s^2}
bodies: {ball: {sphere: {mass: m, radius: R}, at: [0, 0, R], velocity: [v0, 0, 0], angular_velocity: [0, v0/R, 0]}}
ground: {planes: {floor: {normal: up}}}
connections: {c: {contact: {between: [ball, floor], friction: mu, rolling_resistance: f}}}
loads: {weight: {gravity: g}}
measures: {x: x of ball}
"""


def test_a_ball_comes_to_rest_where_the_resistance_has_taken_its_energy() -> None:
    # 7/10 m v0^2 = (f m g/R) x; m a = F and 2/5 m R^2 a/R = -F R - f m g give a = -5 f g/(7 R)
    found = fb.System.from_text(BALL).solve(
        ["x when rate(x) = 0", "time when rate(x) = 0", "acceleration of x at start"]
    )
    assert found["q1"].value == pytest.approx(0.7 * V0**2 * R / (F * G), rel=1e-9)
    assert found["q2"].value == pytest.approx(V0 * 7 * R / (5 * F * G), rel=1e-9)
    assert found["q3"].value == pytest.approx(-5 * F * G / (7 * R), rel=1e-9)
    assert all(found[q].expression is not None for q in ("q1", "q2", "q3"))


def test_without_resistance_it_rolls_on_at_its_speed() -> None:
    text = BALL.replace(", rolling_resistance: f", "").replace(" f: 2 mm,", "")
    found = fb.System.from_text(text).solve(["time when x = 2 m", "velocity of x when x = 2 m"])
    assert found["q1"].value == pytest.approx(2 / V0, rel=1e-9)
    assert found["q2"].value == pytest.approx(V0, rel=1e-9)
    assert all(found[q].expression is not None for q in ("q1", "q2"))


def test_rolling_resistance_of_a_rolling_joint_is_told_to_belong_to_a_contact() -> None:
    text = """
parameters: {f: 3 mm}
ground: {lines: {floor: {along: right}}}
bodies: {wheel: {disk: {mass: 1 kg, radius: 0.3 m}}}
connections: {track: {rolling: {body: wheel, on: ground.floor, rolling_resistance: f}}}
"""
    with pytest.raises(ModelError, match="a contact takes it"):
        fb.System.from_text(text)
