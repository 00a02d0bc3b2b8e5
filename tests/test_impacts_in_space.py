"""Impacts of balls and particles with friction in space, in closed form, each worked out by hand.

Just before, the point of contact slips with u = v + omega x r, r = -R n, and comes down with w. The impulses are
P = (1 + e) m w along the normal and T against u; a ball with I = 2/5 m R^2 slips afterwards with u + 7/2 T/m. So it
stops slipping if |u| <= 7/2 mu (1 + e) w, by T = -2/7 m u, or else T = -mu P u/|u|. Then v' = v + T/m and
omega' = omega + r x T/I. Source: Stronge, Impact Mechanics, 2000, ch. 3; Cross, Am. J. Phys. 70 (2002) 482.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np
import pytest

import freebody as fb

M, R, E, W, G = 0.1, 0.03, 0.8, 4.0, 9.81


def ball(mu: float, *, e: float = E, height: str = "", shape: str = "sphere: {mass: m, radius: R}") -> fb.System:
    spin = "" if "particle" in shape else ", angular_velocity: [a, b, c]"
    return fb.System.from_text(f"""
space: true
parameters: {{m: {M} kg, R: {R} m, u: 3 m/s, s: 1 m/s, w: {W} m/s, e: {e or E}, mu: {mu}, h: 0.5 m, g: {G} m/s^2,
             a: 15 rad/s, b: 8 rad/s, c: 40 rad/s}}
ground: {{planes: {{floor: {{normal: up}}}}}}
bodies: {{ball: {{{shape}, at: [0, {"0" if not spin else "R"}{height}, 0], velocity: [u, -w, s]{spin}}}}}
connections: {{floor: {{contact: {{between: [ball, ground.floor], friction: mu, restitution: {"e" if e else 0}}}}}}}
loads: {{weight: {{gravity: g}}}}
measures: {{x: x of ball, y: y of ball, z: z of ball}}
""")


def by_hand(mu: float, w: float = W, e: float = E) -> tuple[np.ndarray, np.ndarray, np.ndarray, float]:
    """Velocity and spin afterwards, the impulse, and the energy lost."""
    v, omega, r = np.array([3.0, -w, 1.0]), np.array([15.0, 8.0, 40.0]), np.array([0.0, -R, 0.0])
    slip = v + np.cross(omega, r)
    slip[1] = 0.0
    size, P = math.hypot(*slip), (1 + e) * M * w
    T = -2 / 7 * M * slip if size <= 3.5 * mu * (1 + e) * w else -mu * P * slip / size
    total, inertia = T + np.array([0.0, P, 0.0]), 0.4 * M * R * R
    after, turning = v + total / M, omega + np.cross(r, T) / inertia
    lost = 0.5 * M * (v @ v - after @ after) + 0.5 * inertia * (omega @ omega - turning @ turning)
    return after, turning, total, lost


def values(system: fb.System, *questions: str) -> Iterator[np.ndarray]:
    for answer in system.solve(questions).answers:
        assert answer.expression is not None, answer.reason
        yield np.asarray(answer.value)


def value(system: fb.System, question: str) -> np.ndarray:
    [found] = values(system, question)
    return found


@pytest.mark.parametrize("mu", [0.02, 0.5], ids=["slips", "grips"])
def test_ball_with_any_spin_rebounds_as_worked_out_by_hand(mu: float) -> None:
    system = ball(mu)
    after, turning, impulse, lost = by_hand(mu)
    *velocity, omega, on_ball, energy = values(
        system,
        *(f"velocity of {name} after the impact" for name in "xyz"),
        "angular velocity of ball after the impact",
        "impulse of floor on ball",
        "energy lost in the impact",
    )
    assert velocity == pytest.approx(after, rel=1e-12)
    assert omega == pytest.approx(turning, rel=1e-12)
    assert on_ball == pytest.approx(impulse, rel=1e-12)
    assert energy == pytest.approx(lost, rel=1e-12)


def test_ball_that_falls_first_meets_the_floor_with_what_it_has_gained() -> None:
    after, turning, _impulse, lost = by_hand(0.02, math.sqrt(W * W + 2 * G * 0.5))
    system = ball(0.02, height=" + h")
    assert value(system, "velocity of z after the impact") == pytest.approx(after[2], rel=1e-11)
    assert value(system, "angular velocity of ball after the impact") == pytest.approx(turning, rel=1e-11)
    assert value(system, "energy lost in the impact") == pytest.approx(lost, rel=1e-11)


def test_ball_without_rebound_slides_and_rolls_on() -> None:
    after, turning, _impulse, _lost = by_hand(0.02, e=0.0)
    system = ball(0.02, e=0.0)
    slip = after + np.cross(turning, [0.0, -R, 0.0])
    duration = 2 * math.hypot(*slip) / (7 * 0.02 * G)
    rolls = (5 * after - 2 * np.cross(turning, [0.0, -R, 0.0])) / 7
    assert value(system, "time when rolling begins") == pytest.approx(duration, rel=1e-12)
    assert value(system, "velocity of x when rolling begins") == pytest.approx(rolls[0], rel=1e-12)


@pytest.mark.parametrize("mu", [0.1, 0.9])
def test_particle_loses_at_most_its_velocity_along_the_floor(mu: float) -> None:
    along, P = np.array([3.0, 1.0]), (1 + E) * W
    left = along * max(0.0, 1 - mu * P / math.hypot(*along))
    system = ball(mu, shape="particle: {mass: m}")
    found = [float(value(system, f"velocity of {name} after the impact")) for name in "xz"]
    assert found == pytest.approx(left, rel=1e-12, abs=1e-12)
