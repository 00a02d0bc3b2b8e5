"""What is calculated from several quantities: textbook relations between forces, energies and speeds.

Each formula is derived here by hand from the principle that is named. Problem families: Meriam & Kraige, Engineering
Mechanics: Dynamics, ch. 3 and 6; Hibbeler, Engineering Mechanics: Dynamics, ch. 13 to 18.
"""

from __future__ import annotations

import math

import pytest

from freebody.api import System
from freebody.errors import ModelError
from posed import is_formula, posed

ATWOOD = """
parameters: {m1: 3 kg, m2: 2 kg, M: 1 kg, R: 0.1 m, g: 9.81 m/s^2}
bodies: {pulley: {disk: {mass: M, radius: R}}, left: {particle: {mass: m1}}, right: {particle: {mass: m2}}}
connections:
  axle: {pin: [ground.axle, pulley.center]}
  rope: {string: {from: left, over: [pulley], to: right, grips: [pulley]}}
loads: {weight: {gravity: g}}
measures: {x1: {drop of left below ground.axle}, x2: {drop of right below ground.axle}}
"""
PENDULUM = """
parameters: {m: 2 kg, L: 1.5 m, g: 9.81 m/s^2, theta0: 60 deg}
bodies: {bob: {particle: {mass: m}}}
connections: {rod: {link: [ground.O, bob, L]}}
loads: {weight: {gravity: g}}
measures: {theta: {angle of line from ground.O to bob from down}}
start: {theta: theta0}
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
BLOCK = """
parameters: {m: 4 kg, F: 10 N, g: 9.81 m/s^2}
bodies: {a: {particle: {mass: m}}, b: {particle: {mass: 2*m}, at: [1 m, 0]}}
connections:
  first: {slider: {body: a, along: right}}
  bar: {link: [a, b, 1 m]}
  second: {slider: {body: b, along: right}}
loads: {pull: {force: {at: b, along: right, magnitude: F}}}
measures: {x: x of a}
"""


def value(model: str, question: str) -> float:
    answer = System.from_text(model).solve(question).answers[0]
    assert answer.expression is not None, answer.reason
    assert answer.evidence is not None
    found = answer.value
    assert isinstance(found, float)
    return found


G, M1, M2, M = 9.81, 3.0, 2.0, 1.0
A = (M1 - M2) * G / (M1 + M2 + M / 2)  # Newton's law for both masses, and the pulley's M R^2/2 a/R = (T1 - T2) R


@pytest.mark.parametrize(
    ("question", "wanted"),
    [
        ("tension of rope at left - tension of rope at right", M / 2 * A),
        ("(tension of rope at left - tension of rope at right)*R", M / 2 * A * 0.1),
        ("acceleration of x1 + acceleration of x2", 0.0),
        ("acceleration of x1/g", A / G),
        ("ratio of acceleration of x1 to g", A / G),
        ("tension of rope at left/(m1*g) + acceleration of x1/g", 1.0),  # m1 g - T1 = m1 a
        ("|acceleration of x2|", A),
        ("-acceleration of x2 - acceleration of x1", 0.0),
        ("(velocity of x1)^2/(2*g) when x1 = R", A * 0.1 / G),  # v^2 = 2 a R
        ("sqrt((velocity of x1)^2 + (velocity of x2)^2) when x1 = R", math.sqrt(2 * 2 * A * 0.1)),
    ],
)
def test_relations_in_an_atwood_machine(question: str, wanted: float) -> None:
    assert value(ATWOOD, question) == pytest.approx(wanted, abs=1e-12)


@pytest.mark.parametrize(
    ("question", "wanted"),
    [
        # energy: v^2 = 2 g L (1 - cos theta0); Newton along the rod: T = m g + m v^2/L
        ("tension of rod/(m*g) when theta = 0", 3 - 2 * math.cos(math.pi / 3)),
        ("tension of rod when theta = 0 / (m*g)", 3 - 2 * math.cos(math.pi / 3)),
        ("tension of rod when theta = 0 - tension of rod at start", 2 * G * (3 - 2 * 0.5) - 2 * G * 0.5),
        ("ratio of tension of rod when theta = 0 to tension of rod at start", (3 - 2 * 0.5) / 0.5),
        ("kinetic energy when theta = 0 / (m*g*L)", 1 - math.cos(math.pi / 3)),
    ],
)
def test_relations_on_the_swing_of_a_pendulum(question: str, wanted: float) -> None:
    assert value(PENDULUM, question) == pytest.approx(wanted, rel=1e-10)


@pytest.mark.parametrize(
    ("question", "wanted"),
    [
        # angular momentum about a point of the floor: m v0 r = 7/5 m v r, so v = 5 v0/7
        ("velocity of x when rolling begins/v0", 5 / 7),
        ("(velocity of x)/v0 when rolling begins", 5 / 7),
        ("energy lost until rolling begins/kinetic energy at start", 2 / 7),
        ("ratio of energy lost until rolling begins to kinetic energy at start", 2 / 7),
        ("1 - kinetic energy when rolling begins / kinetic energy at start", 2 / 7),
        ("velocity of x at start - velocity of x when rolling begins", 2 / 7 * 3),
        ("friction force of touch/normal force of touch at start", 0.2),
    ],
)
def test_relations_on_the_way_to_rolling(question: str, wanted: float) -> None:
    assert abs(value(BALL, question)) == pytest.approx(wanted, rel=1e-10)


def test_the_force_in_a_bar_by_the_force_that_pulls_both_bodies() -> None:
    assert abs(value(BLOCK, "tension of bar/F")) == pytest.approx(1 / 3)  # m of 3 m


def test_options_of_a_ratio_are_judged() -> None:
    options = "{a: (m1 - m2)/(m1 + m2), b: (m1 - m2)/(m1 + m2 + M/2)}"
    text = ATWOOD + f"questions: [{{id: q, find: acceleration of x1/g, options: {options}}}]"
    assert System.from_text(text).solve()["q"].choice == "b"


@pytest.mark.parametrize(
    ("question", "said"),
    [
        ("acceleration of x1 + tension of rope at left", "unlike units cannot be added"),
        ("velocity of x1^2", "Put the quantity in parentheses"),
        ("velocity of x1*x2", "Put the quantity in parentheses"),
        ("acceleration of x1/g - tension of zz", "no connection zz"),
        ("velocity of x1 at start - velocity of x1", "when it is meant"),
        ("(acceleration of x1", r"cannot read"),
    ],
)
def test_what_cannot_be_calculated_is_refused_in_words(question: str, said: str) -> None:
    with pytest.raises(ModelError, match=said):
        System.from_text(ATWOOD).solve(question)


def test_a_vector_is_no_number() -> None:
    with pytest.raises(ModelError, match="along a direction"):
        System.from_text(ATWOOD).solve("acceleration of left/g")


def test_a_ratio_of_vectors_is_that_of_their_sizes() -> None:
    """What a rope joins accelerates alike, one up and one down."""
    is_formula(ATWOOD, "ratio of acceleration of left to acceleration of right", "1")


BOX = """
parameters: {m: 50 kg, b: 2 m, g: 9.81 m/s^2, mu: 0.4, P: 100 N}
ground: {lines: {floor: {along: right}}}
bodies: {box: {rectangle: {mass: m, width: b, height: b}, at: [0, b/2], points: {l: [-b/2, -b/2], r: [b/2, -b/2]}}}
connections:
  l: {contact: {between: [box.l, floor], friction: mu}}
  r: {contact: {between: [box.r, floor], friction: mu}}
loads: {w: {gravity: g}, pull: {force: {at: box, along: right, magnitude: P}}}
"""


@pytest.mark.parametrize(
    ("question", "formula"),
    [
        ("friction force of l + friction force of r", "-P"),
        ("friction force of l + friction force of r + P", "0"),
        ("(friction force of l + friction force of r)/(normal force of l + normal force of r)", "-P/(m*g)"),
        ("|friction force of l + friction force of r|", "P"),
    ],
)
def test_frictions_of_which_only_the_sum_is_determined_are_added(question: str, formula: str) -> None:
    is_formula(BOX, question, formula)
    assert posed(BOX, "friction force of l - friction force of r").expression is None


def test_what_is_calculated_in_brackets_is_meant_at_their_instant() -> None:
    """|a| = g sin(alpha) at the start and 2 g (1 - cos(alpha)) at the bottom are alike for tan(alpha/2) = 1/2; the
    tension grows from m g cos(alpha) to m g (3 - 2 cos(alpha))."""
    pendulum = """
parameters: {m: 2 kg, L: 0.5 m, alpha: 35 deg, g: 9.81 m/s^2}
bodies: {bob: {particle: {mass: m}}}
connections: {rod: {link: [ground.O, bob, L]}}
loads: {weight: {gravity: g}}
measures: {theta: angle of line from ground.O to bob from down}
start: {theta: alpha, rate(theta): 0}
"""
    alike = "value of alpha for which |acceleration of bob| at start = |acceleration of bob| when theta = 0"
    is_formula(pendulum, alike, "2*atan(1/2)")
    grows = "(tension of rod/(m*g) when theta = 0) - (tension of rod/(m*g) at start)"
    is_formula(pendulum, grows, "3 - 3*cos(alpha)")
