"""Rest in space and free motions beside what follows by hand or from an integration of their own."""

from __future__ import annotations

import numpy as np
import pytest

import freebody as fb
from posed import is_formula

TROUGH = """
space: {up: z}
parameters: {W: 100 N, r: 0.2 m, alpha: 35 deg, g: 9.81 m/s^2}
ground: {planes: {left: {normal: [-sin(alpha), 0, cos(alpha)]}, right: {normal: [sin(alpha), 0, cos(alpha)]}}}
bodies: {ball: {sphere: {mass: W/g, radius: r}}}
connections: {a: {contact: {between: [ball, left]}}, b: {contact: {between: [ball, right]}}}
loads: {w: {gravity: g}}
"""
BOX = """
space: {up: z}
parameters: {m: 20 kg, a: 0.4 m, h: 0.3 m, beta: 15 deg, mu: 0.4, F: 10 N, g: 9.81 m/s^2}
ground: {planes: {slope: {normal: [sin(beta), 0, cos(beta)]}}}
bodies: {box: {box: {mass: m, size: [a, a, h]}, turned: [beta about y]}}
connections: {c: {contact: {between: [box, slope], friction: mu}}}
loads: {w: {gravity: g}, pull: {force: {at: box, along: y, magnitude: F}}}
"""
TABLE = """
space: {up: z}
parameters: {W: 300 N, R: 0.5 m, e: 0.1 m, k: 0.7 m, g: 9.81 m/s^2}
ground: {planes: {floor: {normal: up}}}
bodies:
  table:
    body: {mass: W/g, inertia: [1 kg m^2, 1 kg m^2, 1 kg m^2], center_of_mass: [e, 0, 0]}
    points: {A: [R, 0, -k], B: [-R/2, R*sqrt(3)/2, -k], C: [-R/2, -R*sqrt(3)/2, -k]}
connections:
  a: {contact: {between: [table.A, floor]}}
  b: {contact: {between: [table.B, floor]}}
  c: {contact: {between: [table.C, floor]}}
loads: {w: {gravity: g}}
"""


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        (TROUGH, "normal force of a", "W/(2*cos(alpha))"),
        # friction carries the resultant of the pull across and the weight down the slope
        (BOX, "largest F so that it stays at rest", "m*g*sqrt((mu*cos(beta))**2 - sin(beta)**2)"),
        (BOX, "least mu so that it stays at rest", "sqrt(F**2 + (m*g*sin(beta))**2)/(m*g*cos(beta))"),
        (TABLE, "normal force of a", "W*(1/3 + 2*e/(3*R))"),
        (TABLE, "normal force of b", "W*(1/3 - e/(3*R))"),
    ],
    ids=["trough", "pull", "friction", "near leg", "far leg"],
)
def test_bodies_rest_in_space_as_their_balances_say(model: str, question: str, formula: str) -> None:
    is_formula(model, question, formula, factors=(1.0, 1.05))


def test_a_brick_tumbles_as_the_equations_of_euler_say() -> None:
    """I_1 w_1' = (I_2 - I_3) w_2 w_3, integrated by SciPy: the spin about the middle axis turns over."""
    integrate = pytest.importorskip("scipy.integrate")
    moments = np.array([2 / 12 * 0.20, 2 / 12 * 0.17, 2 / 12 * 0.05])
    start = [0.01, 8.0, 0.02]
    found = fb.System.from_text(f"""
space: true
parameters: {{m: 2 kg, a: 0.1 m, b: 0.2 m, c: 0.4 m}}
bodies:
  brick:
    box: {{mass: m, size: [a, b, c]}}
    velocity: [0, 0, 0]
    angular_velocity: {[f"{w} rad/s" for w in start]}
""").simulate(until=10, tolerance=1e-11)

    def euler(_t: float, w: np.ndarray) -> np.ndarray:
        torque = (moments[[1, 2, 0]] - moments[[2, 0, 1]]) * w[[1, 2, 0]] * w[[2, 0, 1]]
        return torque / moments

    wanted = integrate.solve_ivp(euler, (0, 10), start, rtol=1e-12, atol=1e-14).y[:, -1]
    assert wanted[1] < -7.9
    assert np.asarray(found.dataset["body_angular_velocity_in_body"])[-1, 0] == pytest.approx(wanted, abs=1e-6)


def test_a_satellite_comes_back_after_the_time_of_kepler() -> None:
    """r_a = v^2 r^2/(2 mu - v^2 r), T = 2 pi sqrt(A^3/mu), 1/A = 2/r - v^2/mu."""
    model = """
parameters: {mu: 3.986e14 m^3/s^2, m: 500 kg, r: 7000 km, v: 8 km/s}
ground: {points: {O: [0, 0]}}
bodies: {s: {particle: {mass: m}, at: [r, 0], velocity: [0, v]}}
loads: {a: {attraction: {center: ground.O, strength: mu}}}
measures: {d: distance from ground.O to s, th: angle of line from ground.O to s}
"""
    is_formula(model, "greatest d", "v**2*r**2/(2*mu - v**2*r)", factors=(1.0,))
    is_formula(model, "period of d", "2*pi*sqrt((1/(2/r - v**2/mu))**3/mu)", factors=(1.0,))
