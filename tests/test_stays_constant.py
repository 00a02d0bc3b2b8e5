"""For which value of a parameter a coordinate stays as it is at the start: circular and conical motion, rest.

Derived by hand from the balance of forces towards the centre, m v^2/r = F(r). Problem families: Beer & Johnston, Vector
Mechanics: Dynamics, ch. 12; Goldstein, Poole & Safko, Classical Mechanics, sec. 3.3.
"""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import freebody as fb
from freebody.language.expression import FLOAT_FUNCTIONS, Expr, evaluate
from freebody.language.parser import parse
from freebody.study.answering.answer import Answer

EXAMPLES = Path(__file__).parents[1] / "examples"
PLANET = (EXAMPLES / "planet_orbit.yaml").read_text(encoding="utf-8")
CONE = (EXAMPLES / "conical_pendulum.yaml").read_text(encoding="utf-8")
WHIRLED = """
parameters: {m: 1 kg, k: 50 N/m, L: 0.4 m, w: 3 rad/s, r_0: 0.6 m}
ground: {points: {O: [0, 0]}}
bodies: {ball: {particle: {mass: m}}}
loads: {cord: {spring: {first: ground.O, second: ball, stiffness: k, length: L}}}
measures: {r: distance from ground.O to ball, th: {angle of line from ground.O to ball}}
start: {r: r_0, th: 0, rate(r): 0, rate(th): w}
"""
# a mass on a table whose cord runs through a hole to a hanging mass
HANGING = """
parameters: {m: 0.5 kg, M: 1 kg, g: 9.81 m/s^2, r_0: 0.3 m, v_0: 2 m/s}
ground: {points: {O: [0, 0]}}
bodies: {puck: {particle: {mass: m}}}
loads: {hanging: {law: {measure: r, force: -M*g}}}
measures: {r: distance from ground.O to puck, th: {angle of line from ground.O to puck}}
start: {r: r_0, th: 0, rate(r): 0, rate(th): v_0/r_0}
"""
PENDULUM = """
parameters: {m: 1 kg, L: 0.5 m, g: 9.81 m/s^2, theta_0: 60 deg, k: 2 N*m}
bodies: {bob: {particle: {mass: m}}}
connections: {rod: {link: [ground.O, bob, L]}}
loads: {weight: {gravity: g}, drive: {law: {measure: th, force: k}}}
measures: {th: {angle of line from ground.O to bob from down}}
start: {th: theta_0, rate(th): 0}
"""
PROBLEMS = {
    "circular orbit": (PLANET, "value of v_0 for which r stays constant", "sqrt(mu/r_0)"),
    "the centre for a circle": (PLANET, "value of mu for which r does not change", "v_0^2*r_0"),
    "conical pendulum": (CONE, "value of Omega for which theta remains constant", "sqrt(g/(L*cos(beta)))"),
    "its angle": (CONE, "value of beta for which theta stays constant", "acos(g/(L*Omega^2))"),
    "whirled on a spring": (WHIRLED, "value of r_0 for which r is constant", "k*L/(k - m*w^2)"),
    "through a hole": (HANGING, "value of v_0 for which r stays constant", "sqrt(M*g*r_0/m)"),
    "held at rest": (PENDULUM, "value of k for which th stays constant", "m*g*L*sin(theta_0)"),
}


def asked(text: str, question: str) -> Answer:
    return fb.System.from_text(text).solve(question).answers[0]


@pytest.mark.parametrize("name", PROBLEMS)
def test_the_value_is_that_of_the_balance_towards_the_centre(name: str) -> None:
    text, question, formula = PROBLEMS[name]
    answer = asked(text, question)
    assert isinstance(answer.expression, Expr), answer.reason
    own = {p.name: p.value or 0.0 for p in fb.System.from_text(text).parameters.values()}
    numbers = [float(evaluate(e, own, FLOAT_FUNCTIONS)) for e in (answer.expression, parse(formula))]
    assert math.isclose(*numbers, rel_tol=1e-9), answer.expression
    assert any("all rates stay as they are" in note or "nothing moves" in note for note in answer.notes)


def test_the_simulation_stays() -> None:
    speed = asked(HANGING, "value of v_0 for which r stays constant").value
    assert isinstance(speed, float)
    system = fb.System.from_text(HANGING).with_parameters(v_0=speed)
    motion = fb.simulate(system, until=3.0)
    assert motion.series["r"][0] == pytest.approx(0.3, rel=1e-7)


def test_what_changes_from_the_start_on_is_refused() -> None:
    answer = asked(WHIRLED, "value of w for which th stays constant")
    assert answer.value is None
    assert "changes from the start on" in answer.reason


def test_what_only_starts_without_acceleration_is_refused() -> None:
    """x'' = (p - y) with y' = v: at p = y_0 it is zero at the start, and no longer."""
    text = """
parameters: {m: 1 kg, k: 3 N/m, p: 1 m, v: 2 m/s, y_0: 1 m}
bodies: {ball: {particle: {mass: m}}}
loads: {push: {force: {at: ball, along: right, magnitude: k*(p - y)}}}
measures: {x: x of ball, y: y of ball}
start: {x: 0, rate(x): 0, y: y_0, rate(y): v}
"""
    answer = asked(text, "value of p for which x stays constant")
    assert answer.value is None
    assert "depend on y" in answer.reason
    assert asked(text, "value of p for which acceleration of x = 0 at start").expression is not None


def test_an_acute_angle_stays_acute_where_other_numbers_are_tried() -> None:
    answer = asked(PENDULUM, "value of theta_0 for which acceleration of th = k/(m*L^2) at start")
    assert answer.value is None, "the weight has no moment at 0 and pi alone"
