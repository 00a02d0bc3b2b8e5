"""What stands on the picture of a system as on paper: masses, dimensions, velocities at the start, and proportions."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import freebody as fb
from freebody.present.picture.picture import Picture
from freebody.study.pictures.picture import free_body, picture

EXAMPLES = Path(__file__).parents[1] / "examples"

BEAM = """
parameters: {m: 20 kg, L: 6 m, a: 2 m, s: 4 m, b: 3 m, P: 1 kN}
ground: {points: {A: [0, 0], C: [0, b]}}
bodies:
  beam: {rod: {mass: m, length: L}, at: {start: [0, 0]}, angle: 0, points: {P: [a - L/2, 0], Q: [s - L/2, 0]}}
connections:
  A: {pin: [ground.A, beam.start]}
  rope: {link: [ground.C, beam.end]}
loads: {load: {force: {at: beam.P, along: down, magnitude: P}}}
"""

THROWN = """
parameters: {m: 1 kg, v0: 10 m/s, theta: 40 deg, g: 9.81 m/s^2}
bodies: {ball: {particle: {mass: m}}}
loads: {weight: {gravity: g}}
measures: {x: x of ball, y: y of ball}
start: {x: 0, y: 0, rate(x): v0*cos(theta), rate(y): v0*sin(theta)}
"""

BACK = """
parameters: {m: 1 kg, r: 0.1 m, v0: 3 m/s, w0: 20 rad/s, mu: 0.3, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {ball: {sphere: {mass: m, radius: r}}}
connections: {contact: {contact: {between: [ball, floor], friction: mu}}}
loads: {weight: {gravity: g}}
measures: {x: x of ball, turn: angle of ball clockwise}
start: {x: 0, rate(x): -v0, rate(turn): -w0}
"""


def example(name: str) -> fb.System:
    return fb.System.load(EXAMPLES / f"{name}.yaml")


def texts(found: Picture) -> set[str]:
    return {word.label.text for word in found.words}


def heads(found: Picture, ink: str) -> list[np.ndarray]:
    """The tips of the arrows of a colour."""
    return [s.points[0] for s in found.shapes if s.fill is not None and s.fill.name == ink and len(s.points) == 4]


def test_a_point_mass_is_called_by_its_mass_and_other_bodies_by_their_names() -> None:
    assert {"m_1", "m_2", "pulley"} <= texts(picture(example("atwood_machine")))
    assert "m_1" in texts(free_body(example("atwood_machine"), "left"))


def test_point_masses_that_share_a_mass_keep_their_names() -> None:
    assert {"A", "B"} <= texts(picture(example("two_masses_three_springs")))


def test_a_length_from_the_end_of_a_rod_is_a_dimension_though_other_points_lie_between() -> None:
    # a - L/2 and -L/2 are a apart whatever L is; the middle lies between the start and Q
    assert {"a", "s", "L", "b"} <= texts(picture(fb.System.from_text(BEAM)))


def test_the_distance_of_fixed_bearings_is_a_dimension() -> None:
    assert "d" in texts(picture(example("four_bar")))


def test_the_angle_at_which_a_ladder_is_put_is_shown() -> None:
    assert "\u03b1" in texts(picture(example("ladder_against_wall")))


def test_a_throw_shows_its_speed_and_its_angle() -> None:
    found = picture(fb.System.from_text(THROWN))
    assert {"v_0", "\u03b8"} <= texts(found)


def test_a_velocity_that_points_back_is_drawn_back_without_a_sign() -> None:
    found = picture(fb.System.from_text(BACK))
    assert {"v_0", "w_0"} <= texts(found)
    wheel = next(s.points for s in found.shapes if s.is_closed and len(s.points) > 40)
    assert min(tip[0] for tip in heads(found, "velocity")) < float(wheel[:, 0].min())


@pytest.mark.parametrize("name", ["disk_rolling_down_incline", "sphere_launched_down_incline", "ball_with_back_spin"])
def test_the_line_that_a_wheel_rolls_on_is_longer_than_the_wheel(name: str) -> None:
    found = picture(example(name))
    round_ones = [s.points for s in found.shapes if s.is_closed and len(s.points) > 40]
    wheel = max(float(np.ptp(points[:, 0])) for points in round_ones)
    lines = [s.points for s in found.shapes if not s.is_closed and len(s.points) == 2]
    longest = max(float(np.hypot(*(points[1] - points[0]))) for points in lines)
    assert longest > 1.7 * wheel


def test_what_hangs_on_a_pulley_is_a_block_that_is_not_lost_beside_it() -> None:
    found = picture(example("atwood_machine"))
    blocks = [s.points for s in found.shapes if s.is_closed and len(s.points) == 4 and s.fill is not None]
    sides = [float(np.ptp(points[:, 0])) for points in blocks if s_is_square(points)]
    wheel = max(float(np.ptp(s.points[:, 0])) for s in found.shapes if s.is_closed and len(s.points) > 40)
    assert len(sides) >= 2
    assert wheel < 8.0 * max(sides)


def s_is_square(points: np.ndarray) -> bool:
    return abs(float(np.ptp(points[:, 0])) - float(np.ptp(points[:, 1]))) < 1e-6
