"""The work of drag and of dry friction where both brake: m v dv/dx = -k v^2 - mu m g, or -c v - mu m g.

With A = mu m g/k the first law gives v^2 = (v0^2 + A) exp(-2 k x/m) - A, and the work of drag is the integral of -k v^2
over the way; with B = mu m g/c the second one gives v = (v0 + B) exp(-c t/m) - B, and rest where v = 0."""

from __future__ import annotations

from math import isclose

import pytest

from posed import is_derived, is_formula, posed

SLEDGE = """
parameters: {m: 80 kg, k: 0.5 kg/m, mu: 0.05, v0: 15 m/s, d: 40 m, g: 9.81 m/s^2}
bodies: {sledge: {particle: {mass: m}}}
connections: {track: {slider: {body: sledge, along: right, friction: mu}}}
loads: {weight: {gravity: g}, air: {drag: {body: sledge, quadratic: k}}}
measures: {x: {x of sledge}}
start: {x: 0, rate(x): v0}
"""
ALONG = SLEDGE.replace("quadratic: k}", "quadratic: k, along: right}")
IN_OIL = ALONG.replace("quadratic: k", "linear: c").replace("k: 0.5 kg/m", "c: 3 kg/s")
DRY = SLEDGE.replace(", air: {drag: {body: sledge, quadratic: k}}", "").replace("k: 0.5 kg/m, ", "")
# a spring makes it swing, and the air is too much for a formula
ON_A_SPRING = """
parameters: {m: 2 kg, c: 300 N/m, mu: 0.2, a: 0.3 m, k: 0.5 kg/m, g: 9.81 m/s^2}
ground: {points: {A: [-1 m, 0]}}
bodies: {b: {particle: {mass: m}}}
connections: {track: {slider: {body: b, along: right, friction: mu}}}
loads:
  weight: {gravity: g}
  s: {spring: {first: ground.A, second: b, stiffness: c, length: 1 m}}
  air: {drag: {body: b, quadratic: k, along: right}}
measures: {x: {x of b}}
start: {x: a, rate(x): 0}
"""
A = "(mu*m*g/k)"
B = "(mu*m*g/c)"


@pytest.mark.parametrize("model", [SLEDGE, ALONG])
def test_drag_beside_friction_does_the_integral_of_its_force(model: str):
    wanted = f"mu*m*g*d - m/2*(v0^2 + {A})*(1 - exp(-2*k*d/m))"
    assert is_formula(model, "work of air until x = d", wanted)


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        (ALONG, "work of air until sledge stops", f"-m*v0^2/2 + mu*m*g*m/(2*k)*log(1 + v0^2/{A})"),
        (ALONG, "work of track until sledge stops", f"-mu*m*g*m/(2*k)*log(1 + v0^2/{A})"),
        (ALONG, "energy lost until sledge stops", "m*v0^2/2"),
        (ALONG, "energy lost in track until x = d", "mu*m*g*d"),
        (ALONG, "work of track until x = d", "-mu*m*g*d"),
        (IN_OIL, "work of air until sledge stops", f"-m*v0^2/2 + mu*m*g*m/c*(v0 - {B}*log(1 + v0/{B}))"),
        (IN_OIL, "energy lost until sledge stops", "m*v0^2/2"),
        (DRY, "work of track until x = d", "-mu*m*g*d"),
    ],
)
def test_what_brakes_takes_its_share_of_the_kinetic_energy(model: str, question: str, formula: str):
    assert is_formula(model, question, formula)


def test_the_work_of_friction_is_derived_from_the_energy():
    told = is_derived(DRY, "work of track until x = d")
    assert "The work is what the energy gains" in told["en"]
    assert "Die Arbeit ist der Zuwachs der Energie" in told["de"]


def test_without_a_formula_the_works_add_up_to_what_is_lost():
    questions = ["work of air until x = 0", "work of track until x = 0", "energy lost until x = 0"]
    air, track, lost = (posed(ON_A_SPRING, q).value for q in questions)
    assert isclose(track, -0.2 * 2 * 9.81 * 0.3, rel_tol=1e-8)
    assert isclose(-air - track, lost, rel_tol=1e-8)
    # m v^2/2 where the spring is as long as unloaded, of m dv^2/2 = (mu m g - c x - k v^2) dx
    assert isclose(lost, 300 * 0.3**2 / 2 - posed(ON_A_SPRING, "kinetic energy when x = 0").value, rel_tol=1e-8)
