"""What swings goes all round if energy lets it over the highest point.

A hinged rod struck at its end: w = 3 J/(m L) and m L^2 w^2/6 > m g L. A bob on a light rod let go at a with the rate w:
L w^2/2 > g (1 + cos a); a string must stay taut as well.
Problem families: Meriam & Kraige, Dynamics, 3/7 and 6/8; Beer & Johnston, Dynamics, 13.6; Hibbeler, Dynamics, 19.4.
The end of a plateau: a ball thrown on a rough floor keeps at least 5 u/7 (Beer & Johnston, 17.3).
"""

from __future__ import annotations

import math

import pytest

import freebody as fb
from posed import is_derived, is_formula, posed

ROD = """
parameters: {m: 2 kg, L: 1 m, J: 3 N s, g: 9.81 m/s^2}
bodies: {rod: {rod: {mass: m, length: L}}}
connections: {hinge: {pin: [ground.O, rod.start]}}
loads: {weight: {gravity: g}, kick: {impulse: {at: rod.end, along: right, magnitude: J}}}
measures: {theta: {angle of rod from down}}
start: {theta: 0}
"""
BOB = """
parameters: {m: 1 kg, L: 1 m, w: 6 1/s, g: 9.81 m/s^2, a: 30 deg}
bodies: {ball: {particle: {mass: m}}}
connections: {rope: {link: [ground.O, ball, L]}}
loads: {weight: {gravity: g}}
measures: {theta: {angle of line from ground.O to ball from down}}
start: {theta: a, rate(theta): w}
"""
STRING = BOB.replace("rope: {link: [ground.O, ball, L]}", "rope: {string: {from: ground.O, to: ball, swings: true}}")
STRING = STRING.replace("measures: {", "measures: {r: distance from ground.O to ball, ").replace(
    "start: {", "start: {r: L, "
)
THROWN = """
parameters: {m: 1 kg, r: 0.1 m, u: 5 m/s, h: 0.5 m, mu: 0.1, e: 0.5, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {ball: {sphere: {mass: m, radius: r}, at: [0, h]}}
connections: {c: {contact: {between: [ball, floor], friction: mu, restitution: e}}}
loads: {weight: {gravity: g}}
measures: {x: x of ball, y: y of ball, phi: angle of ball}
start: {x: 0, y: h, rate(x): u, rate(y): 0, rate(phi): 0}
"""


@pytest.mark.parametrize(
    ("text", "question", "formula"),
    [
        (ROD, "least J so that rod turns fully", "m*sqrt(2*g*L/3)"),
        (ROD.replace("along: right", "along: left"), "least J so that rod goes over the top", "m*sqrt(2*g*L/3)"),
        (BOB, "least w so that ball goes over the top", "sqrt(2*g*(1 + cos(a))/L)"),
        (BOB, "least w so that theta turns fully", "sqrt(2*g*(1 + cos(a))/L)"),
        (BOB, "range of L for which ball makes a full circle", "2*g*(1 + cos(a))/w^2"),
    ],
)
def test_the_least_that_brings_it_round(text: str, question: str, formula: str) -> None:
    is_formula(text, question, formula, factors=(1.0, 1.02))


def test_a_string_may_go_slack_before() -> None:
    assert "stays taut" in posed(STRING, "least w so that ball goes over the top").reason


@pytest.mark.parametrize(
    ("question", "formula"),
    [  # the impulse m (1 + e) sqrt(2 g (h - r)) times mu takes u/7, or 2 u/7, where sliding ends
        ("least mu so that velocity of x after the impact <= 6*u/7", "u/(7*(1 + e)*sqrt(2*g*(h - r)))"),
        ("least mu so that velocity of x after the impact <= 5*u/7", "2*u/(7*(1 + e)*sqrt(2*g*(h - r)))"),
    ],
)
def test_a_range_may_end_where_a_plateau_begins(question: str, formula: str) -> None:
    is_formula(THROWN, question, formula, factors=(1.0,))


@pytest.mark.slow
def test_below_the_plateau_there_is_nothing() -> None:
    found = posed(THROWN, "least mu so that velocity of x after the impact < 5*u/7")
    assert "no value of mu" in found.reason


def test_it_is_derived() -> None:
    is_derived(ROD, "least J so that rod turns fully")


ROD_WITH_BOB = """
parameters: {M: 2 kg, m: 1 kg, L: 0.6 m, w: 6.5 rad/s, g: 9.81 m/s^2}
bodies: {rod: {rod: {mass: M, length: L}}, bob: {particle: {mass: m}}}
connections: {hinge: {pin: [ground.O, rod.start]}, fix: {pin: [rod.end, bob]}}
loads: {weight: {gravity: g}}
measures: {th: {angle of line from ground.O to bob from down}}
start: {th: 0, rate(th): w}
"""


def test_a_body_comes_round_with_the_line_that_is_fixed_in_it() -> None:
    """By hand: I w^2/2 = (M + 2 m) g L with I = M L^2/3 + m L^2."""
    is_formula(ROD_WITH_BOB, "least w so that rod turns fully", "sqrt(6*g*(M + 2*m)/(L*(M + 3*m)))")


def test_a_swing_beyond_a_quarter_turn_is_counted_on_between_its_ends() -> None:
    """cos(th) = 1 - L w^2 (M + 3 m)/(3 g (M + 2 m)) by energy; the two ends are more than half a turn apart."""
    found = is_formula(ROD_WITH_BOB, "greatest th", "acos(1 - L*w^2*(M + 3*m)/(3*g*(M + 2*m)))", (1.0, 0.97, 0.93))
    assert isinstance(found.value, float)
    assert found.value > math.pi / 2


def test_of_many_places_the_nearest_is_told() -> None:
    found = is_formula(
        ROD_WITH_BOB.replace("6.5 rad/s", "9 rad/s"),
        "greatest reaction of hinge over the motion",
        "(M + m)*g + (M/2 + m)*L*w^2",
    )
    assert "largest at th = 0" in " ".join(map(str, found.notes))


def test_a_turn_without_a_formula_that_could_come_before_is_told() -> None:
    """A rod with a constant friction torque goes over the top at 9 rad/s and comes down beyond. What its speed there
    needs for a real root is not enough: at 5 rad/s that holds, and the rod turns back below the top."""
    system = fb.System.from_text("""
parameters: {m: 2 kg, L: 1 m, M: 0.05 N m, w: 9 rad/s, p0: 60 deg, p1: 350 deg, g: 9.81 m/s^2}
ground: {points: {O: [0, 0]}}
bodies: {rod: {rod: {mass: m, length: L}}}
connections: {O: {pin: [ground.O, rod.start]}, rub: {dry_friction: {measure: phi, force: M}}}
loads: {weight: {gravity: g}}
measures: {phi: angle of rod from down}
start: {phi: p0, rate(phi): -w}
""")
    [answer] = system.solve("angular velocity of rod when phi = -p1").answers
    left = 9.0**2 + 3 * 9.81 * (math.cos(math.radians(350)) - 0.5) - 6 * 0.05 / 2 * math.radians(410)
    assert answer.value == pytest.approx(-math.sqrt(left))
    assert any("the conditions are not all that this needs" in note for note in answer.notes)
