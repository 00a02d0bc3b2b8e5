"""Spheres that roll on surfaces z = f(x, y), beside closed forms and beside the same motion written otherwise.

A ball rolls in the bowl z = R - sqrt(R^2 - rho^2) as it does inside a sphere of the radius R. Circling steadily it
meets nothing of a bowl of revolution but a circle of one slope psi, as on a cone, so that Routh's condition for the
sphere holds with (R - r) sin(theta) = rho_C, the radius of the circle of the centre, and theta = psi:

    7 rho_C/sin(psi) Omega^2 cos(psi) - 2 r sigma Omega - 5 g = 0,   sigma = omega . n.

At the lowest place of k rho^2 the radius of curvature is 1/(2k), so that small oscillations have
omega^2 = 5 g/(7 (1/(2k) - r)); down a plane of the slope beta the acceleration is 5/7 g sin(beta). Source: Routh,
Dynamics of a System of Rigid Bodies, Advanced Part, 1884, sec. 224.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import freebody as fb

G, R, r, K = 9.81, 0.4, 0.05, 1.0
MODEL = """
space: {up: z}
parameters: {m: 0.5 kg, r: 0.05 m, R: 0.4 m, k: 1 1/m, beta: 20 deg, g: 9.81 m/s^2}
bodies: {ball: {sphere: {mass: m, radius: r}, START}, BOWL}
connections: {contact: {HOW}}
loads: {weight: {gravity: g}, push: {force: {at: ball, along: up, magnitude: PUSH*m*g}}}
"""


def rolling(how: str, start: str, bowl: str = "", push: float = 0.0) -> fb.System:
    text = MODEL.replace("HOW", how).replace("START", start).replace("PUSH", str(push))
    return fb.System.from_text(text.replace("BOWL", bowl))


@pytest.mark.slow
def test_ball_rolls_on_the_surface_of_a_sphere_as_it_does_inside_the_sphere() -> None:
    n = np.array((math.sin(0.6), 0.0, -math.cos(0.6)))
    omega = np.array((1.0, -4.0, 7.0))
    place, velocity = (R - r) * n + np.array((0.0, 0.0, R)), np.cross(omega, -r * n)  # no slip
    start = f"at: {place.tolist()}, velocity: {velocity.tolist()}, angular_velocity: {omega.tolist()}"
    bowl = "bowl: {spherical_shell: {mass: 1 kg, radius: R}, fixed: true, at: [0, 0, R]}"
    on_surface = rolling("rolling_on_surface: {body: ball, z: R - sqrt(R^2 - rho^2)}", start)
    in_sphere = rolling("rolling: {body: ball, inside: bowl}", start, bowl)
    ends = [system.simulate(0.8).course.poses[-1, 0] for system in (on_surface, in_sphere)]
    assert ends[0] == pytest.approx(ends[1], abs=1e-7)
    assert np.linalg.norm(ends[0] - place) > 0.05


@pytest.mark.parametrize(
    ("shape", "turns", "up"),
    [pytest.param(1.0, 5.0, 1.0, marks=pytest.mark.slow), (-1.0, 1.0, 1.0), (1.0, 5.0, -1.0)],
)
def test_ball_circles_steadily_as_on_the_cone_that_touches_the_surface(shape: float, turns: float, up: float) -> None:
    """In a bowl, on a dome, and under a dome against which a force of 2 m g presses it: the mirrored motion, in which
    the angular velocity has other signs along x and y. omega = -(rho/r) n x n' + sigma n, n to the surface."""
    foot = 0.3
    slope = math.atan(2.0 * shape * K * foot)
    n = np.array((math.sin(slope), 0.0, -math.cos(slope)))
    place = np.array((foot, 0.0, shape * K * foot**2)) - r * n
    rho = place[0] / n[0]
    sigma = (7.0 * rho * turns**2 * -n[2] - 5.0 * G) / (2.0 * r * turns)
    rate = turns * np.array((0.0, n[0], 0.0))
    omega, velocity = -(rho / r) * np.cross(n, rate) + sigma * n, rho * rate
    place[2], omega[:2] = up * place[2], up * omega[:2]
    start = f"at: {place.tolist()}, velocity: {velocity.tolist()}, angular_velocity: {omega.tolist()}"
    how = f"rolling_on_surface: {{body: ball, z: {up * shape}*k*rho^2, below: {str(up < 0).lower()}}}"
    course = rolling(how, start, push=1.0 - up).simulate(0.4).course
    x, y, z = course.poses[:, 0].T
    assert z == pytest.approx(np.full_like(z, place[2]), abs=1e-7)
    assert x == pytest.approx(place[0] * np.cos(turns * course.times), abs=1e-6)
    assert y == pytest.approx(place[0] * np.sin(turns * course.times), abs=1e-6)


def test_ball_rolls_down_a_plane_surface_at_five_sevenths_of_the_slope() -> None:
    system = rolling("rolling_on_surface: {body: ball, z: -x*tan(beta)}", "at: [r*sin(beta), 0, r*cos(beta)]")
    places = system.simulate(0.5).course.poses[:, 0]
    travelled = np.linalg.norm(places[-1] - places[0])
    assert travelled == pytest.approx((5 / 7) * G * math.sin(math.radians(20.0)) * 0.5**2 / 2, rel=1e-8)


@pytest.mark.slow
def test_ball_sways_about_the_bottom_with_the_radius_of_curvature_less_its_own() -> None:
    system = rolling("rolling_on_surface: {body: ball, z: k*rho^2}", "at: [0, 0, r]")
    (period,) = system.solve("period of small oscillations").answers
    assert period.value == pytest.approx(2 * math.pi * math.sqrt(7 * (1 / (2 * K) - r) / (5 * G)), rel=1e-6)


@pytest.mark.parametrize(("z", "tightest"), [("10.5*k*rho^2", "0.04762"), ("11*k*x^2 - 3*k*y^2 + 2*k*x*y", "0.04516")])
def test_ball_that_does_not_fit_is_refused_with_the_radius_that_would_do(z: str, tightest: str) -> None:
    """At the middle 1/(2k); of a quadric the greater root of kappa^2 - 16 k kappa - 136 k^2, of the
    second derivatives 22 k, 2 k, -6 k."""
    with pytest.raises(fb.ModelError, match=f"radius of curvature {tightest} m"):
        rolling(f"rolling_on_surface: {{body: ball, z: {z}}}", "near: {at: [0, 0, 0.05 m]}")
    below = rolling(f"rolling_on_surface: {{body: ball, z: {z}, below: true}}", "near: {at: [0, 0, -0.05 m]}")
    assert "ball" in below.bodies


def test_only_a_sphere_rolls_on_a_surface_and_rolling_names_what_takes_one() -> None:
    text = MODEL.replace("BOWL", "").replace("PUSH", "0").replace("START", "at: [0, 0, r]")
    disk = text.replace("sphere:", "disk:")
    with pytest.raises(fb.ModelError, match="make ball a sphere"):
        fb.System.from_text(disk.replace("HOW", "rolling_on_surface: {body: ball, z: k*rho^2}"))
    with pytest.raises(fb.ModelError, match="it is rolling_on_surface"):
        fb.System.from_text(text.replace("HOW", "rolling: {body: ball, z: k*rho^2}"))
