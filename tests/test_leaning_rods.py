"""A rod that leans with its end on a smooth wall and over a smooth edge at the distance a from it.

The height of its middle over the edge is (L/2 cos q - a) tan q, so that L/2 cos^3 q = a at rest; there the edge presses
P = m g/cos q across the rod and the wall m g tan q. Of the two the pose below the edge is stable: d^2V/dq^2 =
-3/2 m g L sin q there. Source: Den Hartog, Mechanics, 1948, virtual work."""

from __future__ import annotations

import pytest

from posed import is_formula, posed

ROD = """
parameters: {m: 2 kg, L: 1 m, a: 0.2 m, g: 9.81 m/s^2}
ground: {points: {O: [0, 0], P: [a, 0]}, lines: {wall: {along: up}}}
bodies:
  rod:
    rod: {mass: m, length: L}
    near: {at: {start: [0, -0.1 m]}, angle: 40 deg}
    lines: {axis: {along: right}}
connections:
  w: {slot: [rod.start, ground.wall]}
  p: {slot: [ground.P, rod.axis]}
loads: {weight: {gravity: g}}
measures: {theta: angle of rod}
"""
# the height of the free end is taken for the coordinate, and the angle hangs on it by the loop
BY_HEIGHT = ROD.replace("theta: angle of rod}", "z: y of rod.end, theta: angle of rod}")
COS = "((2*a/L)^(1/3))"
SIN = f"sqrt(1 - {COS}^2)"


@pytest.mark.parametrize("model", [ROD, BY_HEIGHT])
@pytest.mark.parametrize(
    ("question", "formula"),
    [
        ("theta in equilibrium", f"-acos({COS})"),
        ("normal force of w in equilibrium", f"m*g*{SIN}/{COS}"),
    ],
)
def test_the_cube_of_the_cosine_is_known(model: str, question: str, formula: str):
    assert is_formula(model, question, formula)


def test_the_height_of_the_end_follows_from_the_angle_and_the_other_pose_is_told():
    found = is_formula(BY_HEIGHT, "z in equilibrium", f"-(L*{COS} - a)*{SIN}/{COS}")
    assert any("it may rest at" in str(note) for note in found.notes)


def test_a_rod_that_is_too_short_to_reach_over_the_edge_finds_no_rest():
    # cos^3 q = 2 a/L needs L > 2 a
    short = BY_HEIGHT.replace("a: 0.2 m", "a: 0.55 m")
    found = posed(short, "theta in equilibrium")
    assert found.value is None
