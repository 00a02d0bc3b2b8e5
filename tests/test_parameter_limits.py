"""To what an answer tends as a parameter vanishes, grows without bound, or tends to a value.

The limits are those by which a textbook checks a formula, found here from the formula by hand. Problem families: Morin,
Introduction to Classical Mechanics, ch. 1 (limiting cases), 3 and 8; Kleppner & Kolenkow, ch. 2 and 7; Meriam & Kraige,
Dynamics, ch. 3, 6 and 8; Taylor, Classical Mechanics, ch. 2 (linear resistance).
"""

from __future__ import annotations

import pytest

import freebody as fb
from freebody.api import System
from freebody.errors import ModelError
from freebody.language.expression import FLOAT_FUNCTIONS, Expr, evaluate
from freebody.language.parser import parse
from posed import is_formula, posed

ATWOOD = """
parameters: {m1: 3 kg, m2: 2 kg, M: 1 kg, R: 0.1 m, g: 9.81 m/s^2}
bodies: {pulley: {disk: {mass: M, radius: R}}, left: {particle: {mass: m1}}, right: {particle: {mass: m2}}}
connections:
  axle: {pin: [ground.axle, pulley.center]}
  rope: {string: {from: left, over: [pulley], to: right, grips: [pulley]}}
loads: {weight: {gravity: g}}
measures: {x: {drop of left below ground.axle}}
start: {x: 1 m}
"""
FALL = """
parameters: {m: 2 kg, g: 9.81 m/s^2, c: 0.8 kg/s, T: 2 s}
bodies: {ball: {particle: {mass: m}}}
loads: {weight: {gravity: g}, air: {force: {at: ball, along: up, magnitude: -c*rate(y)}}}
measures: {y: y of ball}
start: {y: 0, rate(y): 0}
"""
INCLINE = """
parameters: {m: 2 kg, mu: 0.2, theta: 30 deg, g: 9.81 m/s^2, v0: 5 m/s}
ground: {lines: {incline: {along: theta}}}
bodies: {block: {particle: {mass: m}}}
connections: {touch: {contact: {between: [block, incline], friction: mu}}}
loads: {weight: {gravity: g}}
measures: {s: {travel of block along incline}}
start: {s: 0, rate(s): v0}
"""
BALL = """
parameters: {m: 1 kg, r: 0.1 m, mu: 0.2, v0: 3 m/s, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {ball: {sphere: {mass: m, radius: r}}}
connections: {touch: {contact: {between: [ball, floor], friction: mu}}}
loads: {weight: {gravity: g}}
measures: {x: {travel of ball along floor}}
start: {x: 0, rate(x): v0}
"""
ROD = """
parameters: {m: 2 kg, L: 1.5 m, g: 9.81 m/s^2}
bodies: {rod: {rod: {mass: m, length: L}}}
connections: {hinge: {pin: [rod.start, ground.O]}}
loads: {weight: {gravity: g}}
measures: {phi: {angle of rod from down}}
start: {phi: 0}
"""
THROW = """
parameters: {v0: 15 m/s, theta: 50 deg, H: 3 m, g: 9.81 m/s^2}
bodies: {ball: {particle: {mass: 1 kg}}}
loads: {weight: {gravity: g}}
measures: {x: x of ball, y: y of ball}
start: {x: 0, y: H, rate(x): v0*cos(theta), rate(y): v0*sin(theta)}
"""

CASES = {
    # a = (m1 - m2) g/(m1 + m2 + M/2)
    "light pulley": (ATWOOD, "acceleration of x as M -> 0", "(m1 - m2)*g/(m1 + m2)"),
    "heavy mass": (ATWOOD, "acceleration of x as m2 grows", "-g"),
    "heavy mass, string": (ATWOOD, "tension of rope at left as m2 -> oo", "2*m1*g"),
    "heavy pulley": (ATWOOD, "acceleration of x as M becomes very large", "0"),
    "equal masses": (ATWOOD, "limit of tension of rope at left as m1 tends to m2", "m2*g"),
    # v = -(m g/c) (1 - exp(-c T/m)), and its integral
    "no resistance": (FALL, "velocity of y at t = T as c -> 0", "-g*T"),
    "no resistance, way": (FALL, "y at t = T as c tends to 0", "-g*T^2/2"),
    "strong resistance": (FALL, "velocity of y as c grows at t = T", "0"),
    "terminal": (FALL, "velocity of y at t = T as T grows", "-m*g/c"),
    "heavy ball": (FALL, "velocity of y as m grows when t = T", "-g*T"),
    # s = v0^2/(2 g (sin(theta) + mu cos(theta)))
    "smooth": (INCLINE, "s when velocity of s = 0 as mu tends to 0", "v0^2/(2*g*sin(theta))"),
    "upright": (INCLINE, "s when velocity of s = 0 as theta -> 90 deg", "v0^2/(2*g)"),
    "flat": (INCLINE, "acceleration of s as theta -> 0", "-mu*g"),
    # v = 5 v0/7 whatever the friction
    "rolling": (BALL, "velocity of x when rolling begins as mu -> 0", "5*v0/7"),
    # x = v0 cos (v0 sin + sqrt(v0^2 sin^2 + 2 g H))/g
    "level ground": (THROW, "x when y = 0 as H -> 0", "2*v0^2*sin(theta)*cos(theta)/g"),
    "dropped": (THROW, "time when y = 0 as v0 vanishes", "sqrt(2*H/g)"),
    "short rod": (ROD, "period of small oscillations as L -> 0", "0"),
}


@pytest.mark.parametrize("name", CASES)
def test_the_limit_is_that_of_a_textbook(name: str) -> None:
    text, question, formula = CASES[name]
    found = posed(text, question)
    assert isinstance(found.expression, Expr), found.reason
    assert found.evidence is not None
    own = {p.name: p.value for p in System.from_text(text).parameters.values() if p.value is not None}
    for factor in (1.0, 1.1):
        values = {key: v * factor ** (1 + 0.3 * k) for k, (key, v) in enumerate(sorted(own.items()))}
        wanted = float(evaluate(parse(formula), values, FLOAT_FUNCTIONS))
        assert evaluate(found.expression, values, FLOAT_FUNCTIONS) == pytest.approx(wanted, rel=1e-9, abs=1e-12)


@pytest.mark.parametrize(
    ("model", "question", "words"),
    [
        (THROW, "time when y = 0 as g -> 0", "tends to +∞"),
        (BALL, "time when rolling begins as mu -> 0", "tends to +∞"),
        (FALL, "y at t = T as T grows", "tends to -∞"),
        (ROD, "period of small oscillations as L grows without bound", "tends to +∞"),
        (ATWOOD, "1/acceleration of x as m1 -> m2", "no limit"),
    ],
)
def test_what_grows_without_bound_is_called_so(model: str, question: str, words: str) -> None:
    found = posed(model, question)
    assert found.expression is None
    assert words in found.reason


TWO_MASSES = """
parameters: {m1: 20 kg, m2: 2 kg, k1: 8 kN/m, k2: 600 N/m}
bodies: {A: {particle: {mass: m1}}, B: {particle: {mass: m2}}}
connections: {a: {slider: {body: A, along: right}}, b: {slider: {body: B, along: right}}}
measures: {x1: x of A, x2: x of B}
loads:
  s1: {law: {measure: x1, force: -k1*x1}}
  s2: {law: {measure: {expression: x2 - x1}, force: -k2*(x2 - x1)}}
start: {x1: 0, x2: 0}
"""


@pytest.mark.parametrize(
    ("question", "formula"),
    [
        # the roots of the characteristic polynomial cancel each other there
        ("lowest natural frequency as k2 grows", "sqrt(k1/(m1 + m2))"),
        ("lowest natural frequency as m2 -> 0", "sqrt(k1/m1)"),
        ("highest natural frequency as m1 grows", "sqrt(k2/m2)"),
    ],
)
def test_a_frequency_whose_parts_cancel_has_a_limit(question: str, formula: str) -> None:
    is_formula(TWO_MASSES, question, formula)


def test_the_time_still_grows() -> None:
    assert (
        posed(FALL, "velocity of y as t grows").expression
        == posed(FALL, "velocity of y at t = T as T grows").expression
    )


def test_a_parameter_that_is_none_is_said() -> None:
    with pytest.raises(ModelError):
        System.from_text(ATWOOD).question("acceleration of x as m1 tends to Q")


def test_it_is_derived_in_both_languages() -> None:
    system = System.from_text(ATWOOD)
    (derivation,) = fb.explain(system, "acceleration of x as M -> 0").derivations
    assert not derivation.reason
    words = fb.explain(system, "acceleration of x as m2 grows", language="de").to_text()
    assert "für m₂ → ∞ wird daraus" in words.lower()
