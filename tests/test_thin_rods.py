"""A rod has no thickness: what touches it is on one of its sides, and counts once."""

from __future__ import annotations

import math

import numpy as np
import pytest

import freebody as fb
from freebody.numeric.engine.course import Status
from freebody.study.phases.at_start import closed_at_start
from posed import is_formula, posed

L, V, E = 1.2, 2.0, 0.6

BAR = """
parameters: {m: 2 kg, L: 1.2 m, v: 2 m/s, e: 0.6}
ground: {points: {corner: [0, 0]}}
bodies:
  bar: {rod: {mass: m, length: L}, at: [X m, Y m], angle: 0, velocity: [0, VY*v], angular_velocity: 0}
connections:
  hit: {contact: {between: [BETWEEN], restitution: e}}
"""


def bar(x: float = -0.3, y: float = 0.0, vy: int = -1, between: str = "bar, ground.corner") -> fb.System:
    changes = {"X m": f"{x} m", "Y m": f"{y} m", "VY": str(vy), "BETWEEN": between}
    text = BAR
    for old, new in changes.items():
        text = text.replace(old, new)
    return fb.System.from_text(text)


@pytest.mark.parametrize("x", [-0.3, 0.2, 0.0, -0.6, 0.6])
@pytest.mark.parametrize(("y", "vy"), [(0.0, -1), (0.0, 1), (0.1, -1)])
@pytest.mark.parametrize("between", ["bar, ground.corner", "ground.corner, bar"])
def test_a_bar_that_hits_a_corner_turns_as_one_impulse_there_makes_it(
    x: float, y: float, vy: int, between: str
) -> None:
    # the impulse J at the distance d from the centre: m (u - v) = J, m L^2/12 w = J d, and u + w d = -e v
    d = -x
    result = bar(x, y, vy, between).simulate(0.1)
    assert result.status is Status.FINISHED
    assert result.course.contact is not None
    assert [len(c.impulses) for c in result.course.contact.collisions] == [1]
    w = -vy * 12 * (1 + E) * V * d / (L**2 + 12 * d**2)
    assert result.course.velocities[-1, 0, 2] == pytest.approx(w, rel=1e-9, abs=1e-12)
    assert result.course.velocities[-1, 0, 1] == pytest.approx(vy * V - vy * (1 + E) * V * L**2 / (L**2 + 12 * d**2))


@pytest.mark.parametrize("vy", [-1, 1])
def test_formulas_know_one_side_of_the_bar(vy: int) -> None:
    assert len(closed_at_start(bar(vy=vy))) == 1
    assert closed_at_start(bar(vy=1)) != closed_at_start(bar(vy=-1))


PLANK = """
parameters: {m: 10 kg, L: 2 m, a: 0.5 m, b: 0.7 m, mu: 0.3, F: 5 N, g: 9.81 m/s^2}
ground: {points: {p: [-a, 0], q: [b, 0]}}
bodies: {plank: {rod: {mass: m, length: L}, at: [0, 0], angle: 0}}
connections:
  left: {contact: {between: [plank, ground.p], friction: mu}}
  right: {contact: {between: [plank, ground.q], friction: mu}}
loads: {weight: {gravity: g}, push: {force: {at: plank, along: right, magnitude: F}}}
"""


def test_a_plank_lies_on_its_posts_and_not_under_them() -> None:
    found = fb.statics(fb.System.from_text(PLANK))
    normals = {r.connection: (r.low, r.high) for r in found.reactions if r.reaction == "normal force"}
    assert normals["left"] == pytest.approx((10 * 9.81 * 0.7 / 1.2,) * 2)
    assert normals["right"] == pytest.approx((10 * 9.81 * 0.5 / 1.2,) * 2)
    assert found.reserve == pytest.approx(0.3 * 10 * 9.81 / 5)


def test_a_particle_bounces_off_a_rod_once() -> None:
    # M at the centre of the rod m: both move as in a central impact
    text = """
bodies:
  rod: {rod: {mass: 2 kg, length: 1 m}, at: [0, 0], angle: 0}
  ball: {particle: {mass: 1 kg}, at: [0, 0.1 m], velocity: [0, -3 m/s]}
connections: {c: {contact: {between: [ball, rod], restitution: 0.5}}}
"""
    result = fb.System.from_text(text).simulate(0.1)
    assert result.course.velocities[-1, 0, 1] == pytest.approx(-1.5)
    assert result.course.velocities[-1, 1, 1] == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize("e", [0.0, 0.5, 1.0])
def test_two_squares_that_meet_corner_to_corner_head_on_part_as_two_balls(e: float) -> None:
    text = f"""
bodies:
  a: {{rectangle: {{mass: 1 kg, width: 0.2 m, height: 0.2 m}}, at: [-0.3 m, 0], angle: 45 deg, velocity: [2 m/s, 0]}}
  b: {{rectangle: {{mass: 3 kg, width: 0.2 m, height: 0.2 m}}, at: [0.3 m, 0], angle: 45 deg}}
connections: {{c: {{contact: {{between: [a, b], restitution: {e}}}}}}}
"""
    result = fb.System.from_text(text).simulate(0.3)
    u = result.course.velocities[-1, :2, 0]
    assert u == pytest.approx([0.5 - 1.5 * e, 0.5 + 0.5 * e], abs=1e-9)
    assert np.abs(result.course.velocities[-1, :2, 1:]).max() < 1e-9


def test_a_steep_rod_that_falls_on_a_corner_is_pushed_along_its_normal() -> None:
    alpha = math.radians(30)
    text = """
ground: {points: {corner: [0, 0]}}
bodies: {rod: {rod: {mass: 1 kg, length: 1 m}, at: [0, 0], angle: 30 deg, velocity: [0, -2 m/s]}}
connections: {c: {contact: {between: [rod, ground.corner], restitution: 1}}}
"""
    result = fb.System.from_text(text).simulate(0.1)
    n = np.array([-math.sin(alpha), math.cos(alpha)])
    v = np.array([0.0, -2.0])
    assert result.course.velocities[-1, 0, :2] == pytest.approx(v - 2 * (v @ n) * n)


BOOM = """
space: {up: z}
parameters: {m: 12 kg, W: 400 N, L: 2 m, g: 9.81 m/s^2}
bodies: {boom: {rod: {mass: m, length: L}, at: {start: [0, 0, 0]}, turned: [0.4 rad about z, -0.3 rad about y]}}
connections: {socket: {spherical: [ground.O, boom.start]}}
loads: {weight: {gravity: g}, load: {force: {at: boom.end, along: down, magnitude: W}}}
"""


def test_how_a_thin_rod_rolls_about_its_axis_is_told_by_no_number() -> None:
    for question in ("angular acceleration of boom along x", "size of angular acceleration of boom"):
        found = posed(BOOM, question)
        assert (found.value, found.expression) == (None, None)
        assert "roll_boom, so its acceleration is not determined" in found.reason


def test_what_does_not_depend_on_the_roll_of_a_thin_rod_has_a_formula() -> None:
    # at rest at the slope beta: m L^2/3 alpha = (m g/2 + W) L cos(beta), and the end falls with L alpha cos(beta)
    is_formula(BOOM, "acceleration of boom.end along down at start", "3*(g/2+W/m)*cos(0.3)^2")
    found = posed(BOOM, "reaction of socket along up at start")
    assert found.value == pytest.approx(12 * 9.81 + 400 - 12 * (9.81 / 2 + 400 / 12) * 1.5 * math.cos(0.3) ** 2)
