"""Strings that go slack and come taut again, in polar coordinates. The formulas are derived here by hand: a projectile
from where the tension vanishes, and the loss of the speed along the string where it is straight again.

Problem families: Timoshenko & Young, Engineering Mechanics, ch. 8 (bob on a slack string); Hibbeler, Dynamics, ch. 15;
Meriam & Kraige, Engineering Mechanics: Dynamics, ch. 3; Kleppner & Kolenkow, An Introduction to Mechanics, ch. 4.
"""

from __future__ import annotations

import math

import pytest

from freebody.api import System
from freebody.language.expression import FLOAT_FUNCTIONS, Expr, evaluate
from freebody.narrative.explain import explain
from posed import is_formula

BOB = """
parameters: {m: 0.5 kg, L: 1 m, v0: 5.5 m/s, g: 9.81 m/s^2}
bodies: {bob: {particle: {mass: m}, at: [0, -L]}}
connections: {cord: {string: {from: ground.O, to: bob, swings: true}}}
loads: {w: {gravity: g}}
measures: {theta: angle of line from ground.O to bob from down, r: distance from ground.O to bob}
start: {r: L, theta: 0, rate(theta): v0/L}
"""
DROPPED = """
parameters: {m: 0.5 kg, L: 1 m, b: 0.6 m, g: 9.81 m/s^2}
bodies: {bob: {particle: {mass: m}, at: [b, 0]}}
connections: {cord: {stop: {measure: r, max: L}}}
loads: {w: {gravity: g}}
measures: {r: distance from ground.O to bob, theta: angle of line from ground.O to bob from down}
start: {r: b, theta: 90 deg, rate(r): 0, rate(theta): 0}
"""
TWO_PUCKS = """
parameters: {mA: 2 kg, mB: 3 kg, L: 1.3 m, b: 0.5 m, v: 4 m/s}
bodies: {A: {particle: {mass: mA}, at: [0, 0]}, B: {particle: {mass: mB}, at: [0, b], velocity: [v, 0]}}
connections: {cord: {stop: {measure: d, max: L}}}
measures: {d: distance from A to B, xA: x of A, yA: y of A, xB: x of B, yB: y of B}
"""


def answered(text: str, question: str):
    """The one answer, which has a formula that was checked."""
    system = System.from_text(text + f"questions: [{{id: q, find: '{question}'}}]\n")
    (answer,) = system.solve().answers
    assert answer.expression is not None, answer.reason
    assert answer.evidence is not None
    return answer


def values(answer, **numbers: float) -> list[float]:
    parts = answer.expression if isinstance(answer.expression, tuple) else (answer.expression,)
    assert all(isinstance(part, Expr) for part in parts)
    return [float(evaluate(part, numbers, FLOAT_FUNCTIONS)) for part in parts]


def test_bob_comes_taut_three_times_as_far_below_as_it_went_slack_above():
    """The parabola through the circle at the elevation alpha, sin(alpha) = (v0^2 - 2 g L)/(3 g L), meets it again at
    -3 alpha."""
    for v0 in (4.9, 5.5, 6.2):
        alpha = math.asin((v0 * v0 - 2 * 9.81) / (3 * 9.81))
        (theta,) = values(answered(BOB, "theta when cord goes taut"), m=0.5, L=1.0, g=9.81, v0=v0)
        assert math.remainder(theta - (math.pi / 2 - 3 * alpha), math.tau) == pytest.approx(0, abs=1e-9)


def test_jerk_of_the_bob_takes_the_speed_along_the_string():
    """v_r = 8 sqrt(g L s^3) cos(alpha)^3 with s = sin(alpha): (m/2) v_r^2 is lost."""
    m, L, g, v0 = 0.5, 1.0, 9.81, 5.5
    s = (v0 * v0 - 2 * g * L) / (3 * g * L)
    lost = 32 * m * g * L * s**3 * (1 - s * s) ** 3
    answer = answered(BOB, "energy lost in the impact")
    assert answer.value == pytest.approx(lost, rel=1e-12)
    x, y = values(answered(BOB, "impulse of cord"), m=m, L=L, g=g, v0=v0)
    assert math.hypot(x, y) == pytest.approx(math.sqrt(2 * m * lost), rel=1e-12)


def test_dropped_bob_is_caught_by_its_string():
    """It falls sqrt(L^2 - b^2) freely; the impulse is m v cos of the angle to the vertical."""
    m, L, b, g = 0.5, 1.0, 0.6, 9.81
    h = math.sqrt(L * L - b * b)
    v = math.sqrt(2 * g * h)
    assert answered(DROPPED, "time when cord closes").value == pytest.approx(v / g)
    assert answered(DROPPED, "energy lost in the impact").value == pytest.approx(m * v * v / 2 * (h / L) ** 2)
    x, y = values(answered(DROPPED, "impulse of cord"), m=m, L=L, b=b, g=g)
    assert (x, y) == pytest.approx((-m * v * h / L * b / L, m * v * h / L * h / L))


def test_two_pucks_on_a_cord_share_the_speed_along_it():
    mu, along = 2 * 3 / 5, 4 * math.sqrt(1.3**2 - 0.5**2) / 1.3
    assert answered(TWO_PUCKS, "speed of A after the impact").value == pytest.approx(mu * along / 2)
    assert answered(TWO_PUCKS, "energy lost in the impact").value == pytest.approx(mu * along**2 / 2)
    impulse = answered(TWO_PUCKS, "impulse of cord")
    assert math.hypot(*impulse.value) == pytest.approx(mu * along)
    assert all(len(str(part)) < 2000 for part in impulse.expression)  # no sines of many times an angle


def test_impact_of_the_cord_is_derived_with_its_impulse():
    system = System.from_text(
        TWO_PUCKS
        + "questions: [{id: v, find: speed of A after the impact}, {id: E, find: energy lost in the impact},"
        + " {id: p, find: is linear momentum along right conserved in the impact}]\n"
    )
    derivations = explain(system).derivations
    assert not any(derivation.reason for derivation in derivations)
    keys = [stage.title.key for derivation in derivations for stage in derivation.stages]
    assert "stage.impact" in keys  # once: the others refer to it


ATWOOD = """
parameters: {m1: 3 kg, m2: 2 kg, h: 1 m, g: 9.81 m/s^2, R: 0.1 m}
ground: {points: {axle: [0, 3 m]}, lines: {floor: {along: right}}}
bodies:
  pulley: {disk: {radius: R}}
  heavy: {particle: {mass: m1}, at: [-R, h]}
  light: {particle: {mass: m2}, at: [R, 0.5 m]}
connections:
  axle: {pin: [ground.axle, pulley.center]}
  rope: {string: {from: heavy, over: [pulley], to: lightGRIPS}}
  floor: {contact: {between: [heavy, floor], restitution: 0}}
loads: {weight: {gravity: g}}
measures: {y1: y of heavy, y2: y of light}
start: {y1: h, rate(y1): 0}
"""


@pytest.mark.parametrize("grips", ["", ", grips: []"], ids=["gripped", "free"])
@pytest.mark.parametrize(
    ("question", "formula"),
    [
        ("velocity of y1 after the second impact", "m2*V/(m1 + m2)"),
        ("(time of the second impact) - (time of the first impact)", "2*V/g"),
        ("energy lost in the second impact", "m1*m2*V^2/(2*(m1 + m2))"),
    ],
)
def test_a_string_over_a_pulley_comes_taut_again_behind_the_landing_of_one_mass(
    grips: str, question: str, formula: str
) -> None:
    """The heavy mass lands with V = sqrt(2 g h (m1 - m2)/(m1 + m2)) and stays; the light one rises and falls back to
    the same height with V, where the string jerks the heavy one up: momentum m2 V along the string for both masses."""
    landing = "sqrt(2*g*h*(m1 - m2)/(m1 + m2))"
    is_formula(ATWOOD.replace("GRIPS", grips), question, formula.replace("V", landing), (1.0, 1.03, 0.98))


def test_a_string_of_several_parts_is_said_to_go_taut() -> None:
    told = System.from_text(ATWOOD.replace("GRIPS", "")).phases().to_text()
    assert "rope (heavy to pulley) goes taut" in told
