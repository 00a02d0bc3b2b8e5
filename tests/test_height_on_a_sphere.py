"""How far a particle sinks that goes round on a sphere, with the length of the way round bound by the link.

With the angular momentum l = R u about the vertical and energy, from the equator at u along it:

    u^2/2 = R^2 u^2/(2 (R^2 - z^2)) + g z     gives, beside z = 0,     2 g z^2 - u^2 z - 2 g R^2 = 0.

Source: Whittaker, Analytical Dynamics of Particles and Rigid Bodies, sec. 55 (spherical pendulum).
"""

from __future__ import annotations

import math

import pytest

import freebody as fb
from posed import posed

MODEL = """
freebody: 1
space: {up: z}
parameters: {m: 0.2 kg, g: 9.81 m/s^2, R: 0.5 m, u: 2 m/s}
bodies: {bead: {particle: {mass: m}, near: {at: [R, 0, 0]}}}
connections: {rod: {link: [ground.O, bead, R]}}
loads: {weight: {gravity: g}}
measures: {z: z of bead, phi: angle of line from ground.O to bead}
start: {z: 0, phi: 0, rate(z): 0, rate(phi): u/R}
"""


def test_a_spherical_pendulum_sinks_to_a_root_of_its_energy_equation() -> None:
    answer = fb.System.from_text(MODEL).solve("least z").answers[0]
    assert answer.value is not None
    assert answer.expression is not None
    z = float(answer.value)
    assert z == pytest.approx((4 - math.sqrt(16 + 16 * 9.81**2 * 0.25)) / (4 * 9.81))
    assert 2 * 9.81 * z**2 - 4 * z - 2 * 9.81 * 0.25 == pytest.approx(0, abs=1e-12)


def test_what_sets_out_level_on_the_equator_rises_no_higher_than_that() -> None:
    answer = fb.System.from_text(MODEL).solve("greatest z").answers[0]
    assert answer.value == 0.0


def test_a_spherical_pendulum_is_fastest_at_its_lowest_point() -> None:
    """From 50 degrees with 2 m/s along the level: v sin(theta) is kept, and v^2/2 - g L cos(theta)."""
    model = """
space: {up: z}
parameters: {m: 0.4 kg, L: 1.2 m, g: 9.81 m/s^2, beta: 50 deg, v0: 2 m/s}
bodies:
  yoke: {body: {}, turned: [psi about z]}
  bob: {body: {mass: m}, points: {top: [0, 0, L]}, turned: [theta about y], frame: yoke}
connections:
  swivel: {revolute: {first: ground.O, second: yoke, about: z}}
  hinge: {revolute: {first: yoke, second: bob.top, about: y}}
loads: {weight: {gravity: g}}
start: {psi: 0, theta: beta, rate(theta): 0, rate(psi): v0/(L*sin(beta))}
"""
    v = posed(model, "speed of bob at its lowest point").value
    assert isinstance(v, float)
    beta = math.radians(50)
    theta = math.asin(2 * math.sin(beta) / v)
    assert theta < beta
    assert v**2 / 2 - 9.81 * 1.2 * math.cos(theta) == pytest.approx(2 - 9.81 * 1.2 * math.cos(beta))
    circle = posed(model, "value of v0 for which the bob circles steadily")
    assert circle.value == pytest.approx(math.sqrt(9.81 * 1.2 * math.sin(beta) * math.tan(beta)))
