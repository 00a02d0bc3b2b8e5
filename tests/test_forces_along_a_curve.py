"""The normal force on a bead along a curve, and ropes with mass that unwind with a load, by hand.

Down a curve v^2 = 2 g (y_0 - y), and N = m (g cos(psi) + v^2/rho), psi the slope. Of the cycloid x = R (2 s + sin(2s)),
y = R (1 - cos(2 s)) the slope is s and rho = 4 R cos(s), so that N = m g (2 cos(s) - cos(s_0)^2/cos(s)); let go at the
cusp, s_0 = 90 deg, it would be 2 m g cos(s) (Huygens 1673, part 2). Of the parabola y = x^2/(4 a), in s with x = 2 s,
N = m a g (a^2 + s_0^2)/(a^2 + s^2)^(3/2); of the catenary y = a cosh(s/a), N = m g (2 cosh(s_0/a) - cosh(s/a))/
cosh(s/a)^2. A rope of the mass m, of which x hangs from a drum with a load at its end, moves by
(m + M/2 + m_e) x'' = (m x/L + m_e) g, so that v^2 is twice the work of that force over the inertia.
"""

from __future__ import annotations

import pytest

from posed import is_formula

BEAD = """
parameters: {m: 0.1 kg, PARAMETERS, g: 9.81 m/s^2}
bodies: {bead: {particle: {mass: m}}}
connections: {wire: {curved_rail: {point: bead, CURVE}}}
loads: {weight: {gravity: g}}
measures: {s: parameter of wire}
start: {s: s_0, rate(s): 0}
"""
CURVES = {
    "cycloid": (
        "R: 0.25 m, s_0: 50 deg, s_1: 20 deg",
        "x: R*(2*s + sin(2*s)), y: R*(1 - cos(2*s))",
        "m*g*(2*cos(s_1) - cos(s_0)^2/cos(s_1))",
    ),
    "parabola": (
        "a: 0.5 m, s_0: 0.6 m, s_1: 0.2 m",
        "x: 2*s, y: s^2/a",
        "m*a*g*(a^2 + s_0^2)/(a^2 + s_1^2)^(3/2)",
    ),
    "catenary": (
        "a: 0.5 m, s_0: 0.6 m, s_1: 0.2 m",
        "x: s, y: a*cosh(s/a)",
        "m*g*(2*cosh(s_0/a) - cosh(s_1/a))/cosh(s_1/a)^2",
    ),
}
DRUM = """
parameters: {m: 4 kg, L: 10 m, M: 6 kg, R: 0.25 m, b: 1 m, m_e: 3 kg, g: 9.81 m/s^2}
bodies:
  drum: {disk: {mass: M, radius: R}}
  rope: {rope: {mass: m, length: L}}
  load: {particle: {mass: m_e}}
connections:
  axle: {pin: [ground.axle, drum]}
  winding: {heavy_rope: {rope: rope, wound_on: drum, side: right, leads: [down], to: load}}
loads: {weight: {gravity: g}}
measures: {x: drop of rope}
start: {x: b, rate(x): 0}
"""


@pytest.mark.parametrize("name", CURVES)
def test_a_wire_presses_its_bead_by_its_slope_and_its_curvature(name: str) -> None:
    parameters, curve, force = CURVES[name]
    model = BEAD.replace("PARAMETERS", parameters).replace("CURVE", curve)
    is_formula(model, "normal force of wire when s = s_1", force, factors=(1.0, 1.03, 0.97))
    bottom = model.replace(parameters, parameters.split(", s_1")[0])
    is_formula(bottom, "normal force of wire when s = 0", force.replace("s_1", "0"), factors=(1.0, 1.03, 0.97))


def test_a_rope_that_unwinds_with_a_load_falls_faster_and_faster() -> None:
    is_formula(DRUM, "acceleration of x at start", "(m*b/L + m_e)*g/(m + M/2 + m_e)")
    is_formula(DRUM, "tension of winding at drum at start", "M/2*(m*b/L + m_e)*g/(m + M/2 + m_e)")
    is_formula(DRUM, "tension of winding at load at start", "m_e*(g - (m*b/L + m_e)*g/(m + M/2 + m_e))")
    is_formula(DRUM, "velocity of x when x = L", "sqrt(2*g*(m*(L^2 - b^2)/(2*L) + m_e*(L - b))/(m + M/2 + m_e))")
