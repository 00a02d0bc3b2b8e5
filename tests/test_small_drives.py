"""Drives that stand in the length of a spring: forced motion to the first order in their amplitude.

Hand values by M x'' + C x' + K x = Re(f e^(i Omega t)) with the springs along their axes: Rao, Mechanical Vibrations,
5th ed. 2011, sec. 3.6; that it is a limit by simulations of the full motion.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import freebody as fb
from freebody.api import System
from posed import is_formula, posed

OBLIQUE = """
parameters: {m: 2 kg, k: 400 N/m, c: 5 N s/m, a: 0.3 m, b: 0.4 m, U: 2 cm, Omega: 9 rad/s}
ground: {points: {P: [a, b]}}
bodies: {block: {particle: {mass: m}}, foot: {particle: {mass: 0}}}
connections:
  rail: {slider: {body: block, along: right}}
  guide: {slider: {body: foot, along: right, through: ground.P}}
  shaker: {driver: {measure: u, follows: a + U*cos(Omega*t)}}
loads:
  spring: {spring: {between: [block, foot], stiffness: k, length: sqrt(a^2 + b^2)}}
  damper: {law: {measure: x, force: -c*rate(x)}}
measures: {x: x of block, u: x of foot}
start: {x: 0}
"""
TWO_WAYS = """
parameters: {m: 2 kg, k1: 400 N/m, k2: 300 N/m, l: 0.5 m, U: 1 cm, Omega: 6 rad/s}
ground: {points: {W: [-l, 0], Q: [l/sqrt(2), l/sqrt(2)]}}
bodies: {mass: {particle: {mass: m}, at: [0, 0]}, foot: {particle: {mass: 0}, at: [l/sqrt(2), l/sqrt(2)]}}
connections:
  guide: {slider: {body: foot, along: right}}
  shaker: {driver: {measure: u, follows: U*sin(Omega*t)}}
loads:
  slanting: {spring: {between: [mass, foot], stiffness: k1, length: l}}
  level: {spring: {between: [ground.W, mass], stiffness: k2, length: l}}
measures: {x: x of mass, y: y of mass, u: travel of foot along right from ground.Q}
"""
LEVER = """
parameters: {m: 5 kg, L: 0.6 m, b: 0.4 m, k: 3 kN/m, y0: 1 cm, Omega: 20 rad/s, l0: 0.3 m, g: 9.81 m/s^2}
ground: {points: {O: [0, 0], Q: [b, -l0]}}
bodies:
  lever: {rod: {length: L}, at: {start: [0, 0]}, angle: 0, points: {S: [b - L/2, 0]}}
  mass: {particle: {mass: m}}
  foot: {particle: {mass: 0}, at: [b, -l0]}
connections:
  hinge: {pin: [ground.O, lever.start]}
  hold: {weld: [lever.end, mass]}
  guide: {slider: {body: foot, along: up}}
  shaker: {driver: {measure: u, follows: y0*sin(Omega*t)}}
loads: {spring: {spring: {between: [lever.S, foot], stiffness: k, length: l0}}}
measures: {u: height of foot above ground.Q, phi: angle of lever}
"""
K = "(k*a^2/(a^2 + b^2))"


def test_a_foot_that_is_shaken_moves_the_block_by_the_stiffness_along_its_rail() -> None:
    amplitude = is_formula(OBLIQUE, "steady amplitude of x", f"{K}*U/sqrt(({K} - m*Omega^2)^2 + (c*Omega)^2)")
    assert any("first order in its amplitude" in note for note in amplitude.notes)


def test_small_motion_beside_a_cosine_is_about_the_mean() -> None:
    frequency = is_formula(OBLIQUE, "natural frequency", f"sqrt({K}/m)")
    assert not any("equilibrium" in note for note in frequency.notes)


@pytest.mark.parametrize(
    ("asked", "formula"),
    [
        ("x", "k1*U/2*m*Omega^2/abs((k1/2 + k2 - m*Omega^2)*(k1/2 - m*Omega^2) - k1^2/4)"),
        ("y", "k1*U/2*abs(k2 - m*Omega^2)/abs((k1/2 + k2 - m*Omega^2)*(k1/2 - m*Omega^2) - k1^2/4)"),
    ],
)
def test_a_slanting_spring_shakes_a_mass_in_two_directions(asked: str, formula: str) -> None:
    is_formula(TWO_WAYS, f"steady amplitude of {asked}", formula)


def test_a_lever_on_a_shaken_spring() -> None:
    is_formula(LEVER, "steady amplitude of phi", "k*b*y0/abs(k*b^2 - m*L^2*Omega^2)")


def test_the_simulated_motion_tends_to_the_formula_as_the_drive_gets_small() -> None:
    """Damped away after 30 s, the amplitude differs from the formula by the square of the drive."""
    formula = posed(OBLIQUE, "steady amplitude of x").value
    assert isinstance(formula, float)
    gaps = list[float]()
    for U in (0.004, 0.002):
        run = fb.simulate(System.from_text(OBLIQUE).with_parameters(U=U), until=30 + 2 * math.tau / 9)
        t = np.asarray(run.dataset["time"])
        x = np.asarray(run.dataset["x"])[t > 30]
        gaps.append(abs(float(x.max() - x.min()) / 2 / (formula * U / 0.02) - 1))
    assert 2 * gaps[1] < gaps[0] < 0.02


def test_a_drive_that_is_no_harmonic_term_is_still_refused() -> None:
    answer = posed(OBLIQUE.replace("a + U*cos(Omega*t)", "a + U*Omega*t"), "steady amplitude of x")
    assert "swing harmonically" in answer.reason


def test_drives_with_two_frequencies_leave_no_factor_in_the_frequency() -> None:
    two = OBLIQUE.replace("a + U*cos(Omega*t)", "a + U*sin(Omega*t) + U*sin(3*Omega*t)")
    is_formula(two, "natural frequency", f"sqrt({K}/m)")
    assert "swing harmonically" in posed(two, "steady amplitude of x").reason
