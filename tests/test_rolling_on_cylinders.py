"""Spheres that roll on cylinders and in pipes in space: as in the plane across the axis, and up and down in an upright
pipe with sqrt(2/7) of the frequency with which they go round."""

from __future__ import annotations

import math

import numpy as np
import pytest

import freebody as fb

R, r, G, W = 0.5, 0.1, 9.81, 6.0
PIPE = f"""
space: {{up: z}}
bodies:
  pipe: {{cylinder: {{mass: 1, radius: {R}, length: 8, axis: z}}, fixed: true, at: [0, 0, 0]}}
  ball: {{sphere: {{mass: 0.2, radius: {r}}}, at: [{R - r}, 0, 1], velocity: [0, {(R - r) * W}, 0]}}
connections: {{touch: {{rolling: {{body: ball, inside: pipe}}}}}}
loads: {{weight: {{gravity: {{strength: {G}, along: -z}}}}}}
measures: {{h: z of ball}}
"""


def test_a_ball_in_an_upright_pipe_rises_again_after_sqrt_of_seven_halves_turns() -> None:
    """(1 + 2/5) z'' = -g - (2/5) W^2 (z - z_0) without spin about the normal at the start: down by 5 g/W^2, and back
    after the time sqrt(7/2) 2 pi/W. Source: Gualtieri et al., American Journal of Physics 74 (2006) 497-502."""
    period = math.sqrt(3.5) * 2 * math.pi / W
    result = fb.simulate(fb.System.from_text(PIPE), period, tolerance=1e-11)
    h, t = result.dataset["h"].values, result.dataset["time"].values
    assert h == pytest.approx(1.0 - 2.5 * G / W**2 * (1.0 - np.cos(math.sqrt(2 / 7) * W * t)), abs=1e-8)
    push = result.dataset["touch.normal_force"].values
    assert push == pytest.approx(np.full(len(t), 0.2 * (R - r) * W**2), rel=1e-8)


ON_ROLLER = """
space: {{up: {up}}}
bodies:
  roller: {{cylinder: {{mass: 1, radius: {R}, length: 2, axis: {axis}}}, fixed: true, at: [0, 0, 0]}}
  ball: {{sphere: {{mass: 0.2, radius: {r}}}, at: {at}}}
connections: {{touch: {{rolling: {{body: ball, on: roller}}}}}}
loads: {{weight: {{gravity: {{strength: {G}, along: -{up}}}}}}}
measures: {{h: {up} of ball}}
"""


@pytest.mark.parametrize(("axis", "up"), [("x", "z"), ("y", "x"), ("z", "y")])
def test_a_ball_leaves_a_level_roller_where_the_cosine_is_ten_seventeenths(axis: str, up: str) -> None:
    """(7/5) v^2/2 = g s (c_0 - c) with s = R + r, N = m g c - m v^2/s = m g (17 c - 10 c_0)/7."""
    s, c_0 = R + r, math.cos(0.1)
    side = next(name for name in "xyz" if name not in (axis, up))
    at = ["0", "0", "0"]
    at["xyz".index(up)], at["xyz".index(side)] = repr(s * c_0), repr(s * math.sin(0.1))
    text = ON_ROLLER.format(axis=axis, up=up, at="[" + ", ".join(at) + "]", R=R, r=r, G=G)
    result = fb.simulate(fb.System.from_text(text), 1.0, tolerance=1e-11)
    (leaving,) = result.events
    assert leaving.name == "ball leaves roller"
    rolls = result.dataset["time"].values < leaving.time
    c, push = result.dataset["h"].values / s, result.dataset["touch.normal_force"].values
    assert push[rolls] == pytest.approx(0.2 * G * (17 * c[rolls] - 10 * c_0) / 7, abs=1e-8)
    assert np.interp(leaving.time, result.dataset["time"].values, c) == pytest.approx(10 * c_0 / 17, abs=1e-5)


@pytest.mark.parametrize(("axis", "up", "other"), [("x", "z", "y"), ("y", "x", "z")])
def test_a_cylinder_leaves_a_fixed_one_where_the_cosine_is_four_sevenths(axis: str, up: str, other: str) -> None:
    """(3/2) v^2/2 = g s (c_0 - c) with s = R + r, N = m g c - m v^2/s = m g (7 c - 4 c_0)/3."""
    text = f"""
space: {{up: {up}}}
bodies:
  trunk: {{cylinder: {{mass: 1, radius: {R}, length: 2, axis: {axis}}}, fixed: true, at: [0, 0, 0]}}
  roller: {{cylinder: {{mass: 0.2, radius: {r}, length: 1, axis: {axis}}}}}
connections: {{touch: {{rolling: {{body: roller, on: trunk}}}}}}
loads: {{weight: {{gravity: {{strength: {G}, along: -{up}}}}}}}
measures: {{h: {up} of roller, s: {other} of roller}}
start: {{h: {(R + r) * math.cos(0.1)!r}, rate(h): 0, s: {(R + r) * math.sin(0.1)!r}}}
"""
    answer = fb.System.from_text(text).solve("h when contact of touch is lost").answers[0]
    assert answer.value == pytest.approx((R + r) * math.cos(0.1) * 4 / 7, rel=1e-9)


def test_a_roller_in_a_pipe_that_turns_swings_as_in_one_that_stands() -> None:
    """In a pipe on an axle J theta'' = f R, (1/2) m r^2 phi'' = f r, m s'' = -m g s/(R - r) - f and, in small swings,
    s' = R theta' - r phi' up to signs: what f moves yields by 2/m + R^2/J, and adds the inverse of that to m."""
    m, J, g = 0.2, 4 * R**2 / 2, G
    text = f"""
space: {{up: z}}
bodies:
  pipe: {{cylinder: {{mass: 4, radius: {R}, length: 2, axis: x}}}}
  roller: {{cylinder: {{mass: {m}, radius: {r}, length: 1, axis: x}}, at: [0, 0, {r - R}]}}
connections:
  axle: {{revolute: {{first: ground, second: pipe, about: x}}}}
  touch: {{rolling: {{body: roller, inside: pipe}}}}
loads: {{weight: {{gravity: {{strength: {g}, along: -z}}}}}}
"""
    found = fb.System.from_text(text).solve("period of small oscillations").answers[0].value
    mass = m + 1 / (2 / m + R**2 / J)  # that moves with the centre
    assert found == pytest.approx(2 * math.pi * math.sqrt(mass * (R - r) / (m * g)), rel=1e-9)


def test_a_roller_rises_in_a_pipe_by_three_halves_of_what_slides() -> None:
    """3/4 m v^2 = m g h; in small swings it is a pendulum of the length 3 (R - r)/2."""
    s, v = R - r, 0.8
    text = f"""
space: {{up: z}}
bodies:
  pipe: {{cylinder: {{mass: 1, radius: {R}, length: 2, axis: x}}, fixed: true, at: [0, 0, 0]}}
  roller: {{cylinder: {{mass: 0.2, radius: {r}, length: 1, axis: x}}, at: [0, 0, {-s}]}}
connections: {{touch: {{rolling: {{body: roller, inside: pipe}}}}}}
loads: {{weight: {{gravity: {{strength: {G}, along: -z}}}}}}
measures: {{h: z of roller, y: y of roller}}
start: {{rate(y): {v}}}
"""
    system = fb.System.from_text(text)
    assert system.solve("h when rate(y) = 0").answers[0].value == pytest.approx(-s + 0.75 * v**2 / G, rel=1e-9)
    period = system.solve("period of small oscillations").answers[0].value
    assert period == pytest.approx(2 * math.pi * math.sqrt(1.5 * s / G), rel=1e-9)


def test_the_period_of_a_roller_in_a_pipe_is_derived_with_its_place_at_rest() -> None:
    told = str(
        fb.System.from_text("""
space: {up: z}
parameters: {m: 2 kg, R: 1 m, r: 0.2 m, g: 9.81 m/s^2}
bodies:
  pipe: {cylinder: {mass: 50 kg, radius: R, length: 3 m, axis: x}, fixed: true, at: [0, 0, 0]}
  roller: {cylinder: {mass: m, radius: r, length: 1 m, axis: x}, at: [0, 0, r - R]}
connections: {roll: {rolling: {body: roller, inside: pipe}}}
loads: {weight: {gravity: g}}
""").explain("period of small oscillations")
    )
    assert "z_roller_e = r - R" in told
    assert "no derivation" not in told
