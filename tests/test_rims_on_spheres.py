"""The rim of a disk that rolls on a sphere or in a bowl, beside a derivation by hand.

Steady circling about the vertical k with the rate Omega, in the vertical plane of e (outward) and k: the axis of the
disk is a = cos(alpha) e + sin(alpha) k, its lowest radius u = sin(alpha) e - cos(alpha) k, and the rim touches at the
distance x = R sin(beta) from k. Rolling says omega = Omega k + s a, s = -Omega x/r. With the mass centre at x - r
sin(alpha), Newton's law for it and the moments about it, I across the axis and J about it,

    Omega^2 cos(alpha) ((J + m r^2) x/r - (J - I + m r^2) sin(alpha)) = m g r sin(alpha),

and the force of the sphere is -m Omega^2 (x - r sin(alpha)) e + m g k, whose part along the normal presses. Source: the
same balance for the plane (R without bound) is in Neimark & Fufaev, Dynamics of Nonholonomic Systems, 1972, ch. III.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from tests.test_rolling_on_spheres import normal_force

import freebody as fb

G, M, R, r = 9.81, 0.1, 0.4, 0.05
DISK = """
space: true
bodies:
  bowl: {spherical_shell: {mass: 1 kg, radius: 0.4 m}, fixed: true}
  coin: {SHAPE: {mass: 0.1 kg, radius: 0.05 m, axis: AXIS}, at: AT}
connections: {contact: {CONNECTION}}
loads: {weight: {gravity: 9.81 m/s^2}}
"""
ROLLING = "rolling: {body: coin, WHERE: bowl}"


def circling(
    shape: str, alpha: float, beta: float, side: int, connection: str
) -> tuple[fb.System, float, float, np.ndarray]:
    """The system, the rate, the normal force and the place of the centre; side: -1 in a bowl, 1 on a dome."""
    J = M * r**2 * (0.5 if shape == "disk" else 1.0)
    I, x = J / 2, R * math.sin(beta)  # noqa: E741  (as in the derivation)
    gyro = math.cos(alpha) * ((J + M * r**2) * x / r - (J - I + M * r**2) * math.sin(alpha))
    turns = math.sqrt(M * G * r * math.sin(alpha) / gyro)
    e, k, t = np.eye(3)[0], np.eye(3)[1], -np.eye(3)[2]  # k x e = t
    a = math.cos(alpha) * e + math.sin(alpha) * k
    u = math.sin(alpha) * e - math.cos(alpha) * k
    touch = x * e + side * R * math.cos(beta) * k
    center = touch - r * u
    omega = turns * k - turns * x / r * a
    force = -M * turns**2 * center[0] * e + M * G * k
    at, velocity, spin = ([float(c) for c in v] for v in (center, turns * center[0] * t, omega))
    text = DISK.replace("AT", f"{at}, velocity: {velocity}, angular_velocity: {spin}").replace("CONNECTION", connection)
    text = text.replace("AXIS", str([float(c) for c in a])).replace("SHAPE", shape)
    return fb.System.from_text(text), turns, float(side * force @ touch / R), center


@pytest.mark.parametrize(
    ("shape", "alpha", "beta", "side"), [("disk", 0.6, 0.5, -1), ("ring", 0.9, 1.1, -1), ("ring", 0.5, 0.3, 1)]
)
def test_rim_circles_steadily_in_a_bowl_and_on_a_dome(shape: str, alpha: float, beta: float, side: int) -> None:
    rolling = ROLLING.replace("WHERE", "inside" if side < 0 else "on")
    system, turns, normal, center = circling(shape, alpha, beta, side, rolling)
    found = system.simulate(0.3)
    assert found.t_end == 0.3
    angle = 0.3 * turns
    around = np.array((center[0] * math.cos(angle), center[1], -center[0] * math.sin(angle)))
    assert found.course.poses[-1, 0] == pytest.approx(around, abs=1e-7)
    assert normal_force(system) == pytest.approx(normal, rel=1e-9)


def test_rim_in_a_bowl_rolls_alike_by_friction_that_is_enough() -> None:
    rolls, *_ = circling("disk", 0.6, 0.5, -1, ROLLING.replace("WHERE", "inside"))
    rubs, *_ = circling("disk", 0.6, 0.5, -1, "contact: {between: [coin, inside bowl], friction: 2}")
    ends = [system.simulate(0.5).course.poses[-1, 0] for system in (rolls, rubs)]
    assert ends[1] == pytest.approx(ends[0], abs=1e-7)


def test_upright_disk_swings_in_its_plane_as_a_cylinder_in_a_trough() -> None:
    """3/2 (R - r) theta'' = -g sin(theta)."""
    phi = 0.01
    at = f"[{(R - r) * math.sin(phi)}, {(r - R) * math.cos(phi)}, 0]"
    text = DISK.replace("AT", at).replace("CONNECTION", ROLLING.replace("WHERE", "inside")).replace("AXIS", "z")
    half = math.pi * math.sqrt(3 * (R - r) / (2 * G)) * (1 + phi**2 / 16)
    end = fb.System.from_text(text.replace("SHAPE", "disk")).simulate(half).course.poses[-1, 0]
    assert end[0] == pytest.approx(-(R - r) * math.sin(phi), rel=1e-6)


IN_A_BOWL = """
space: {up: z}
bodies:
  bowl: {spherical_shell: {mass: 1 kg, radius: 0.4 m}, fixed: true}
  thing: {SHAPE, at: AT}
connections: {c: {contact: {between: [thing, inside bowl], touching: true}}}
loads: {weight: {gravity: 9.81 m/s^2}}
questions: {p: "normal force of c at FIRST"}
"""


def test_can_lies_in_a_bowl_on_both_of_its_rims() -> None:
    """Each presses to the middle of the bowl: 2 N sqrt(R^2 - L^2/4)/R = m g."""
    depth = math.sqrt(R**2 - 0.06**2)
    text = IN_A_BOWL.replace("SHAPE", "cylinder: {mass: 0.1 kg, radius: 0.05 m, length: 0.12 m, axis: y}")
    text = text.replace("AT", f"[0, 0, {0.05 - depth}]").replace("FIRST", "thing.start")
    [answer] = fb.System.from_text(text).solve().answers
    assert answer.value == pytest.approx(M * G / 2 * R / depth, rel=1e-9)


def test_three_corners_press_alike_on_a_bowl() -> None:
    """A pyramid on a regular triangle of points: 3 N depth/R = m g, whatever stands on it."""
    out, depth = 0.1, math.sqrt(R**2 - 0.01)
    far = math.sqrt(3) / 2 * out
    points = f"{{a: [{out}, 0, 0], b: [-0.05, {far}, 0], c: [-0.05, {-far}, 0], d: [0, 0, 0.1]}}"
    text = IN_A_BOWL.replace("SHAPE", f"convex: {{mass: 0.1 kg, points: {points}}}")
    text = text.replace("AT", f"[0, 0, {-depth}]").replace("FIRST", "thing.a")
    [answer] = fb.System.from_text(text).solve().answers
    assert answer.value == pytest.approx(M * G / 3 * R / depth, rel=1e-9)


def test_a_cone_does_not_lie_in_a_bowl() -> None:
    text = IN_A_BOWL.replace("SHAPE", "cone: {mass: 0.1 kg, radius: 0.05 m, height: 0.1 m}").replace("AT", "[0, 0, 0]")
    with pytest.raises(fb.FreebodyError, match="there is no contact of thing with inside bowl in space"):
        fb.System.from_text(text)


def test_what_has_no_formulas_at_all_has_numbers_of_its_small_motion() -> None:
    """An upright disk in a bowl falls over about its point of contact, 5/4 m r^2 theta'' = m g r theta; its law as a
    whole has too many terms for a formula."""
    text = DISK.replace("AT", f"[0, {r - R}, 0]").replace("CONNECTION", ROLLING.replace("WHERE", "inside"))
    system = fb.System.from_text(text.replace("AXIS", "z").replace("SHAPE", "disk"))
    asked = ["is total energy conserved", "is the equilibrium stable", "natural frequencies"]
    energy, stable, frequencies = system.solve(asked).answers
    assert "more than 60000 terms" in energy.reason
    assert stable.verdict == "not stable with the given numbers"
    assert f"a small motion grows at {math.sqrt(4 * G / (5 * r)):.6g} 1/s" in frequencies.reason
