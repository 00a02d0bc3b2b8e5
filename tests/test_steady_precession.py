"""Steady precession about an axle that is level, the ratio of two rates, and whether a place that is named is stable.

Problem families: Goldstein, Poole & Safko, Classical Mechanics, ch. 5 (gyroscope with a counterweight, thrown plate);
Greenwood, Principles of Dynamics, ch. 8; Meriam & Kraige, Dynamics, ch. 7; Ginsberg, Engineering Dynamics, ch. 10.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from posed import is_derived, posed

BALANCE = """
space: {up: z}
parameters: {m: 0.6 kg, r: 0.06 m, a: 0.15 m, M: 0.9 kg, b: 0.08 m, s: 300 rad/s, g: 9.81 m/s^2}
bodies:
  post: {body: {}}
  frame: {body: {}, points: {W: [a, 0, 0], C: [-b, 0, 0]}}
  wheel: {disk: {mass: m, radius: r, axis: x}}
  counter: {particle: {mass: M}}
connections:
  foot: {revolute: {first: ground.O, second: post, about: z}}
  hinge: {revolute: {first: post, second: frame, about: y}}
  fix: {spherical: [frame.C, counter]}
  spin: {revolute: {first: frame.W, second: wheel, about: x}}
measures:
  psi: angle of post about z
  beta: angle of frame about y relative to post
  phi: angle of wheel about x relative to frame
loads: {weight: {gravity: g}}
start: {psi: 0, beta: 0, phi: 0, rate(phi): s}
"""
PLATE = """
space: {up: z}
parameters: {m: 0.3 kg, R: 0.12 m, w: 20 rad/s, beta: 20 deg}
bodies: {plate: {disk: {mass: m, radius: R, axis: z}, turned: [psi about z, theta about x, phi about z]}}
start: {psi: 0, theta: beta, phi: 0, rate(theta): 0, rate(phi): w}
"""
HOOP = """
space: {up: z}
parameters: {m: 0.1 kg, R: 0.3 m, Omega: 8 rad/s, g: 9.81 m/s^2}
bodies:
  hoop: {body: {}}
  spoke: {body: {}, points: {rim: [0, 0, -R]}}
  bead: {particle: {mass: m}}
connections:
  axle: {revolute: {first: ground.O, second: hoop, about: z}}
  motor: {driver: {measure: psi, follows: Omega*t}}
  centre: {revolute: {first: hoop, second: spoke, about: y}}
  wire: {spherical: [spoke.rim, bead]}
measures: {psi: angle of hoop about z, theta: angle of spoke about y relative to hoop}
loads: {weight: {gravity: g}}
start: {theta: 40 deg, rate(theta): 0}
"""


def test_a_level_axle_precesses_as_the_moment_of_the_weights_demands() -> None:
    """dL/dt = Omega x L = sum of r x (-w up), with L of the spin alone along the level axle."""
    m, r, a, M, b, s, g = 0.6, 0.06, 0.15, 0.9, 0.08, 300.0, 9.81
    up, axle = np.array([0.0, 0.0, 1.0]), np.array([1.0, 0.0, 0.0])
    moment = np.cross(a * axle, -m * g * up) + np.cross(-b * axle, -M * g * up)
    of_one = np.cross(up, m * r**2 / 2 * s * axle)  # dL/dt at one radian a second
    rate = moment @ of_one / (of_one @ of_one)
    question = "rate of psi in steady motion when beta = 0"
    assert posed(BALANCE, question).value == pytest.approx(rate)
    is_derived(BALANCE, question)


def test_a_thrown_plate_wobbles_nearly_twice_as_fast_as_it_spins() -> None:
    """Of a free body psi' A cos(theta) = C (phi' + psi' cos(theta)), and C = 2 A for a thin disk."""
    question = "ratio of rate of psi to rate of phi in steady motion"
    A, C, c = 1.0, 2.0, math.cos(math.radians(20))
    assert posed(PLATE, question).value == pytest.approx(C / ((A - C) * c))
    is_derived(PLATE, question)


@pytest.mark.parametrize(
    "question",
    [
        "range of Omega for which theta = 0 in steady motion is stable",
        "range of Omega for which the steady motion is stable when theta = 0",
        "range of Omega for which the steady motion is unstable when theta = 0",
    ],
)
def test_the_lowest_place_on_a_hoop_is_left_where_it_turns_fast(question: str) -> None:
    """V/(m R) = -g cos(theta) - R Omega^2 sin(theta)^2/2 is least at zero where its second difference is positive."""

    def bends(rate: float, h: float = 1e-4) -> float:
        return 2 * (-9.81 * math.cos(h) - 0.3 * rate**2 * math.sin(h) ** 2 / 2 + 9.81) / h**2

    answer = posed(HOOP, question)
    end = answer.value
    assert isinstance(end, float)
    below, above = bends(0.99 * end), bends(1.01 * end)
    assert below > 0 > above
    assert any(("Ω > " if "unstable" in question else "Ω < ") in note for note in answer.notes)


def test_the_stability_of_a_place_that_is_named() -> None:
    question = "stability of steady motion when theta = 0"
    assert posed(HOOP, question).value == pytest.approx(8.0**2 - 9.81 / 0.3)
    is_derived(HOOP, question)
    is_derived(HOOP, "range of Omega for which theta = 0 is stable")
