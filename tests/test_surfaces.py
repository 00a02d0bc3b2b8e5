"""Points on surfaces of revolution z = f(rho), beside closed forms.

With the angular momentum m rho^2 phi' = l kept, the effective potential l^2/(2 m rho^2) + m g f gives

    steady circle        rho phi'^2 = g f',              N = m g sqrt(1 + f'^2)
    swaying about it     omega^2 = g (3 f'/rho + f'')/(1 + f'^2)

For the paraboloid k rho^2: phi'^2 = 2 k g, omega^2 = 8 k g/(1 + 4 k^2 rho^2); for the cone rho/tan(alpha):
omega = sqrt(3) phi' sin(alpha). Source: Landau & Lifshitz, Mechanics, sec. 14; Whittaker, Analytical Dynamics, ch. IV.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest

import freebody as fb

Agree = Callable[[fb.Solution, str, str], None]
G = 9.81
ROUND = """
space: {up: z}
parameters: {m: 0.2 kg, k: 1.2 1/m, a: 0.3 m, alpha: 30 deg, g: 9.81 m/s^2, R: 0.5 m, Omega: 3 rad/s}
bodies: {bead: {particle: {mass: m}, near: {at: [R, 0, HEIGHT]}}}
connections: {bowl: {point_on_surface: {point: bead, z: SHAPE}}}
loads: {weight: {gravity: g}}
measures: {rho: distance of bead from the z axis, phi: angle of line from ground.O to bead, z: z of bead}
start: {rho: R, phi: 0, rate(rho): 0, rate(phi): Omega}
"""


def round_bowl(shape: str) -> fb.System:
    at_start = shape.replace("rho", "R")
    return fb.System.from_text(ROUND.replace("HEIGHT", at_start).replace("SHAPE", shape))


@pytest.mark.parametrize(
    ("shape", "rate", "force", "swaying"),
    [
        ("k*rho^2", "sqrt(2*k*g)", "m*g*sqrt(1 + 4*k^2*R^2)", "sqrt(8*k*g/(1 + 4*k^2*R^2))"),
        pytest.param(
            "rho/tan(alpha)",
            "sqrt(g/(R*tan(alpha)))",
            "m*g/sin(alpha)",
            "sqrt(3*g/(R*tan(alpha)))*sin(alpha)",
            marks=pytest.mark.slow,
        ),
        pytest.param(
            "k^3*rho^4",
            "sqrt(4*g*k^3*R^2)",
            "m*g*sqrt(1 + 16*k^6*R^6)",
            "sqrt(24*g*k^3*R^2/(1 + 16*k^6*R^6))",
            marks=pytest.mark.slow,
        ),
    ],
)
def test_particle_circles_and_sways_in_a_bowl_of_revolution(
    shape: str, rate: str, force: str, swaying: str, agrees: Agree
) -> None:
    asked = {
        "rate": "rate of phi in steady motion when rho = R",
        "force": "normal force of bowl in steady motion when rho = R",
        "swaying": "frequency of small oscillations about steady motion when rho = R",
    }
    solution = round_bowl(shape).solve(list(asked.values()))
    for k, closed in enumerate((rate, force, swaying), 1):
        agrees(solution, f"q{k}", closed.replace("^", "**"))


def test_particle_in_a_paraboloid_is_as_fast_as_energy_says_and_turned_back_by_its_angular_momentum(
    agrees: Agree,
) -> None:
    """rho^2 turns where l^2/(2 m rho^2) + m g k rho^2 is what it was: at R^2 and at l^2/(2 m^2 g k R^2)."""
    solution = round_bowl("k*rho^2").solve(["speed of bead when z = k*R^2/2", "least value of rho"])
    agrees(solution, "q1", "sqrt(R**2*Omega**2 + g*k*R**2)")
    agrees(solution, "q2", "R*Omega/sqrt(2*k*g)")


BOWL = """
space: {up: z}
parameters: {k: 0.8 1/m, g: 9.81 m/s^2}
bodies: {bead: {particle: {mass: 0.3 kg}, at: AT}}
connections: {bowl: {point_on_surface: {point: bead, z: SHAPE, MORE}}}
loads: {weight: {gravity: g}}
"""


def bowl(at: str, shape: str = "k*rho^2", more: str = "leaves: false") -> fb.System:
    return fb.System.from_text(BOWL.replace("AT", at).replace("SHAPE", shape).replace("MORE", more))


@pytest.mark.parametrize(
    ("shape", "height"),
    [("k*rho^2", lambda x, y: 0.8 * (x * x + y * y)), ("k*x^2 + 2*k*y^2 - x*y/m", None), ("rho", math.hypot)],
)
def test_motion_on_a_surface_keeps_energy_and_on_one_of_revolution_angular_momentum(
    shape: str, height: Callable[[float, float], float] | None
) -> None:
    shape = shape.replace("/m", "*k")
    height = height or (lambda x, y: 0.8 * (x * x + 2 * y * y - x * y))
    place = np.array((0.4, 0.3, height(0.4, 0.3)))
    system = bowl(
        f"[0.4 m, 0.3 m, {place[2]} m], velocity: [-0.6, 1.1, VZ]".replace("VZ", str(climb(height, place))), shape
    )
    course = system.simulate(2.0).course
    x, y, z = course.poses[:, 0].T
    u = course.velocities[:, 0]
    assert z == pytest.approx([height(*p) for p in zip(x, y, strict=True)], abs=1e-9)
    energy = 0.5 * (u[:, :3] ** 2).sum(axis=1) + G * z
    assert energy == pytest.approx(np.full_like(energy, energy[0]), rel=1e-8)
    if "x" not in shape:
        around = x * u[:, 1] - y * u[:, 0]
        assert around == pytest.approx(np.full_like(around, around[0]), rel=1e-8)


def climb(height: Callable[[float, float], float], place: np.ndarray) -> float:
    """dz/dt of a point that moves by (-0.6, 1.1) along the surface, by central differences."""
    x, y, step = place[0], place[1], 1e-5
    forward, back = (height(x - s * 0.6 * step, y + s * 1.1 * step) for s in (1, -1))
    return (forward - back) / (2 * step)


def test_particle_swings_through_the_bottom_of_a_paraboloid_with_one_frequency_in_all_directions(
    agrees: Agree,
) -> None:
    """On the axis there is no angle round it: x and y remain coordinates."""
    solution = bowl("[0, 0, 0]").solve("period of small oscillations")
    agrees(solution, "q1", "2*pi/sqrt(2*k*g)")


def test_particle_in_a_bowl_of_two_curvatures_swings_with_two_frequencies() -> None:
    found = bowl("[0, 0, 0]", "k*x^2 + 3*k*y^2").solve("natural frequencies")
    assert found.answers[0].value == pytest.approx([math.sqrt(2 * 0.8 * G), math.sqrt(6 * 0.8 * G)], rel=1e-9)


def test_particle_leaves_a_round_dome_at_two_thirds_of_the_height_at_which_it_is_let_go() -> None:
    """N = m (g cos - v^2/R) with v^2 = 2 g (z_0 - z) vanishes at z = 2/3 z_0; from rest it goes down a meridian."""
    z_0 = math.sqrt(1 / 0.8**2 - 0.05**2)
    course = bowl(f"[0.03 m, 0.04 m, {z_0}]", "sqrt(1/k^2 - rho^2)", "leaves: true").simulate(1.4).course
    (parts,) = (event for event in course.events if event.kind == "parts")
    x, y, z = course.poses[int(np.searchsorted(course.times, parts.time)), 0]
    assert z == pytest.approx(2 / 3 * z_0, abs=1e-7)
    assert y / x == pytest.approx(4 / 3, rel=1e-6)


def test_particle_on_a_rough_cone_comes_to_rest_where_the_cone_is_less_steep_than_its_angle_of_friction() -> None:
    """Along a meridian it loses speed by g (mu cos - sin) each second: it slides 0.3 s further."""
    slope = math.atan(0.3)
    tangent = (1.0, 0.3)
    speed = 0.3 * G * (0.5 * math.cos(slope) + math.sin(slope))
    u, w = (speed * c / math.hypot(*tangent) for c in tangent)
    system = bowl(f"[1, 0, 0.3], velocity: [{u}, 0, {w}]", "0.3*rho", "friction: 0.5")
    found = system.simulate(1.0)
    (stops,) = (event for event in found.course.events if event.kind == "stops slipping")
    assert stops.time == pytest.approx(0.3, abs=1e-6)


def test_a_surface_needs_a_formula_that_is_a_length() -> None:
    with pytest.raises(fb.ModelError, match="z"):
        bowl("[0, 0, 0]", "rho^2")
