"""Ropes of cranes: along the axis about which a jib slews they run from the ground to it, and slewing moves none."""

from __future__ import annotations

import math
from typing import Any

import pytest

import freebody as fb
from example_files import FOLDER
from freebody.errors import ModelError

M, R, R_D, ARM, J, J_D, G = 500.0, 0.2, 0.3, 8.0, 2000.0, 15.0, 9.81


def values_of(text: str) -> dict[str, Any]:
    found = {answer.id: answer.value for answer in fb.System.from_text(text).solve().answers}
    assert None not in found.values(), found
    return found


def crane(middle: float = R) -> str:
    """A winch on the ground lifts a load at the end of a jib that a torque slews."""
    return f"""
space: {{up: z}}
ground: {{points: {{O: [0, 0, 0], D: [-{R_D}, 0, 1]}}}}
bodies:
  drum: {{body: {{mass: 100, inertia: [{J_D}, {J_D}, {J_D}], radius: {R_D}}}}}
  jib: {{body: {{mass: 1000, inertia: [{J}, {J}, {J}]}}, points: {{top: [{middle}, 0, 10], tip: [{ARM}, 0, 10]}}}}
  inner: {{disk: {{mass: 0, radius: {R}, axis: y}}}}
  sheave: {{disk: {{mass: 0, radius: {R}, axis: y}}}}
  load: {{particle: {{mass: {M}}}}}
connections:
  winch: {{revolute: {{first: ground.D, second: drum, about: y}}}}
  slewing: {{revolute: {{first: ground.O, second: jib, about: z}}}}
  p: {{revolute: {{first: jib.top, second: inner, about: y}}}}
  q: {{revolute: {{first: jib.tip, second: sheave, about: y}}}}
  rope: {{string: {{path: [wound on drum at right, over inner, over sheave, load]}}}}
loads:
  weight: {{gravity: {{strength: {G}, along: -z}}}}
  drive: {{torque: {{on: jib, about: z, magnitude: 1000}}}}
  hoist: {{torque: {{on: drum, about: y, magnitude: 2000}}}}
measures: {{phi: angle of jib about z, z: z of load}}
start: {{phi: 0.3, rate(phi): 0.2, z: 4, rate(z): 0.1}}
questions:
  - {{id: tension, find: tension of rope at load at start}}
  - {{id: slewing, find: acceleration of phi at start}}
  - {{id: lifting, find: acceleration of z at start}}
"""


def test_a_crane_lifts_as_if_it_stood_still_and_slews_with_its_load_below_the_rim_of_the_sheave() -> None:
    """N - T R_d = J_d a/R_d, T - m g = m a; the load hangs r beyond the axle: M = (J + m (l + r)^2) phi''."""
    found = values_of(crane())
    a = (2000 / R_D - M * G) / (M + J_D / R_D**2)
    assert found["lifting"] == pytest.approx(a, rel=1e-10)
    assert found["tension"] == pytest.approx(M * (G + a), rel=1e-10)
    assert found["slewing"] == pytest.approx(1000 / (J + M * (ARM + R) ** 2), rel=1e-10)


def test_the_tower_of_a_crane_carries_the_load_by_its_arm_alone() -> None:
    """Jib, wheels and the rope on them are one body: the winch draws it down along the axis of slewing, the load at the
    arm l + r, both with T."""
    more = """
  - {id: moment, find: reaction moment of slewing at start}
  - {id: force, find: reaction of slewing at start}
"""
    found = values_of(crane().replace("phi: 0.3, rate(phi): 0.2", "phi: 0, rate(phi): 0") + more)
    rope = found["tension"]
    assert found["force"][2] == pytest.approx(1000 * G + 2 * rope, rel=1e-10)
    assert found["moment"][1] == pytest.approx(-rope * (ARM + R), rel=1e-10)


def test_a_trolley_that_runs_out_while_the_jib_turns_asks_for_twice_its_momentum() -> None:
    """Coriolis: d(m x^2 w)/dt = 2 m x v w, of the trolley at x and the load at x + r."""
    found = values_of((FOLDER / "slewing_crane.yaml").read_text())
    assert found["moment"] == pytest.approx(2 * 0.5 * 0.1 * (200 * 6 + 800 * 6.2), rel=1e-12)
    assert found["rope"] == pytest.approx(800 * 9.81, rel=1e-12)


def test_a_jib_that_luffs_on_a_tower_that_slews_lifts_its_load_by_the_way_of_its_end() -> None:
    """Over equal wheels the arcs add up to half a turn: z = z_E + |E - C| - const, E the end of the jib."""
    r, h, arm, rate = 0.2, 12.0, 9.0, 0.05
    found = values_of(f"""
space: {{up: z}}
parameters: {{w: 0.2 rad/s, u: {rate} rad/s}}
ground: {{points: {{O: [0, 0, 0], D: [0, 0, 1]}}}}
bodies:
  tower: {{body: {{mass: 1500, inertia: [60, 60, 60]}}, points: {{top: [{r}, 0, {h}], hinge: [0.5, 0, 8]}}}}
  jib: {{rod: {{mass: 500, length: {arm}}}}}
  upper: {{disk: {{mass: 0, radius: {r}, axis: y}}}}
  sheave: {{disk: {{mass: 0, radius: {r}, axis: y}}}}
  load: {{particle: {{mass: 800}}}}
connections:
  slewing: {{revolute: {{first: ground.O, second: tower, about: z}}}}
  upper_axle: {{revolute: {{first: tower.top, second: upper, about: y}}}}
  foot: {{revolute: {{first: tower.hinge, second: jib.start, about: y}}}}
  axle: {{revolute: {{first: jib.end, second: sheave, about: y}}}}
  rope: {{string: {{path: [ground.D, over upper, over sheave, load]}}}}
  turning: {{driver: {{measure: phi, follows: 0.3 + w*t}}}}
  luffing: {{driver: {{measure: psi, follows: -0.7 - u*t}}}}
loads: {{weight: {{gravity: {{strength: {G}, along: -z}}}}}}
measures: {{phi: angle of tower about z, psi: angle of jib about y relative to tower}}
questions:
  - {{id: speed, find: velocity of load along z at start}}
""")
    a = 0.7
    up, out = arm * rate * math.cos(a), -arm * rate * math.sin(a)  # of the end
    x, z = 0.5 + arm * math.cos(a) - r, 8 + arm * math.sin(a) - h
    assert found["speed"] == pytest.approx(up + (x * out + z * up) / math.hypot(x, z), rel=1e-10)


def test_a_wheel_beside_the_axis_of_slewing_is_told_where_it_belongs() -> None:
    with pytest.raises(ModelError, match=r"put the middle of inner 0\.2 m beside that axis \(now 0\.3 m\)"):
        fb.System.from_text(crane(middle=0.3))


def test_between_wheels_that_turn_against_each_other_about_no_line_of_the_string_there_is_none() -> None:
    joint = "{revolute: {first: ground.O, second: jib, about: z}}"
    text = crane().replace(joint, "{universal: {first: ground.O, second: jib, arm: x, second_arm: y}}")
    with pytest.raises(ModelError, match="the axes of drum and inner turn against each other"):
        fb.System.from_text(text)
