"""Quantities where a measure, or another quantity, is at its greatest or least of all of the motion.

A block on a spring that is let go at x0 with the speed v0 has the amplitude A = sqrt(x0^2 + m v0^2/k): k A is the force
at its ends, and it passes the middle with A sqrt(k/m). A pendulum let go at a has S = m g cos a at its ends and
m g (3 - 2 cos a) at the bottom. A rod that swings up with w0 turns where cos t = 1 - L w0^2/(3 g).
Problem families: Meriam & Kraige, Dynamics, 3/6 and 8/2; Hibbeler, Dynamics, 13.5 and 22.1; Beer & Johnston 13.2.
"""

from __future__ import annotations

import math

import pytest

from freebody.api import System
from freebody.narrative.sheets.asking import asking
from freebody.narrative.telling.catalogue import Catalogue
from posed import is_derived, is_formula, posed

SPRING = """
parameters: {m: 2 kg, k: 200 N/m, x0: 0.1 m, v0: 1 m/s}
ground: {points: {O: [-1 m, 0]}}
bodies: {block: {particle: {mass: m}, at: [x0, 0]}}
connections: {guide: {slider: {body: block, along: right}}}
loads: {spring: {spring: {first: ground.O, second: block, stiffness: k, length: 1 m}}}
measures: {x: x of block}
start: {x: x0, rate(x): v0}
"""
PENDULUM = """
parameters: {m: 2 kg, L: 1.5 m, a: 50 deg, g: 9.81 m/s^2}
bodies: {bob: {particle: {mass: m}}}
connections: {rope: {link: [ground.O, bob, L]}}
loads: {weight: {gravity: g}}
measures: {theta: angle of line from ground.O to bob from down}
start: {theta: a}
"""
ROD = """
parameters: {m: 2 kg, L: 1 m, w0: 3 rad/s, g: 9.81 m/s^2}
bodies: {rod: {rod: {mass: m, length: L}, at: [0, -L/2], angle: -90 deg}}
connections: {hinge: {pin: [ground.O, rod.start]}}
loads: {weight: {gravity: g}}
measures: {phi: angle of line from ground.O to rod.end from down}
start: {phi: 0, rate(phi): w0}
"""
STONE = """
parameters: {m: 2 kg, v0: 20 m/s, b: 50 deg, g: 9.81 m/s^2}
bodies: {stone: {particle: {mass: m}, at: [0, 0], velocity: [v0*cos(b), v0*sin(b)]}}
loads: {weight: {gravity: g}}
measures: {x: x of stone, y: y of stone}
"""
ROUGH = """
parameters: {m: 2 kg, k: 200 N/m, x0: 0.3 m, mu: 0.2, g: 9.81 m/s^2}
ground: {points: {O: [-1 m, 0]}, lines: {floor: {along: right}}}
bodies: {block: {particle: {mass: m}, at: [x0, 0]}}
connections: {floor: {contact: {between: [block, floor], friction: mu}}}
loads: {weight: {gravity: g}, spring: {spring: {first: ground.O, second: block, stiffness: k, length: 1 m}}}
measures: {x: x of block}
start: {x: x0, rate(x): 0}
"""
AMPLITUDE = "sqrt(x0^2 + m*v0^2/k)"
CASES = {
    "where it first turns": (SPRING, "acceleration of x when x is greatest", f"-k/m*{AMPLITUDE}"),
    "where it turns the second time": (SPRING, "acceleration of x when x is least", f"k/m*{AMPLITUDE}"),
    "the time of the second turn": (SPRING, "time when x is least", "sqrt(m/k)*(pi + atan(v0*sqrt(m/k)/x0))"),
    "as others say it": (SPRING, "acceleration of x when x has its maximum", f"-k/m*{AMPLITUDE}"),
    "where something is fastest": (SPRING, "x when the speed of block is greatest", "0"),
    "when it is fastest": (SPRING, "time when speed of block is greatest", "sqrt(m/k)*(pi - atan(x0/v0*sqrt(k/m)))"),
    "where it is slowest": (SPRING, "What is the force in the spring when the speed is least?", f"k*{AMPLITUDE}"),
    "in German": (SPRING, "Wie groß ist die Federkraft, wenn x am größten ist?", f"k*{AMPLITUDE}"),
    "at the start": (PENDULUM, "tension of rope when theta is greatest", "m*g*cos(a)"),
    "on the other side": (PENDULUM, "tension of rope when theta is least", "m*g*cos(a)"),
    "at the bottom": (PENDULUM, "tension of rope when the speed is greatest", "m*g*(3 - 2*cos(a))"),
    "turned round": (PENDULUM, "value of a for which tension of rope when the speed is greatest is 2*m*g", "acos(1/2)"),
    "a rod": (
        ROD,
        "angular acceleration of rod when phi is greatest",
        "-3*g/(2*L)*sqrt(1 - (1 - L*w0^2/(3*g))^2)",
    ),
    "the top of a throw": (STONE, "speed of stone when y is greatest", "v0*cos(b)"),
    "how far that is": (STONE, "x when y is greatest", "v0^2*sin(b)*cos(b)/g"),
    "with friction": (ROUGH, "force in spring when x is least", "2*mu*m*g - k*x0"),
}


@pytest.mark.parametrize("name", CASES)
def test_what_is_so_where_something_is_greatest_is_that_of_a_textbook(name: str) -> None:
    model, question, formula = CASES[name]
    is_formula(model, question, formula, factors=(1.0, 1.02, 0.98))


def test_where_the_extreme_is_stands_beside_the_answer() -> None:
    found = posed(SPRING, "acceleration of x when x is least")
    assert any("x = -√((m·v₀² + k·x₀²)/k)" in str(note) for note in found.notes), found.notes


def test_what_grows_without_end_has_no_greatest_value() -> None:
    found = posed(STONE, "speed of stone when x is greatest")
    assert found.expression is None
    assert "without bound" in str(found.reason)


def test_it_is_derived_and_put_as_an_exercise() -> None:
    told = is_derived(PENDULUM, "tension of rope when the speed is greatest")
    assert "m⋅g⋅(3 - 2⋅cos(a))" in told["en"]
    system = System.from_text(SPRING + "questions: [acceleration of x when x is least]\n")
    assert "when x is least" in Catalogue("en").plain(asking(system, system.questions[0]))


SHIPS = """
parameters: {a: 10 km, b: 3 km, vA: 5 m/s, vB: 4 m/s}
bodies:
  A: {particle: {mass: 1 kg}, at: [0, 0], velocity: [vA, 0]}
  B: {particle: {mass: 1 kg}, at: [a, b], velocity: [0, -vB]}
"""
# one ball is dropped as the other is thrown at it: seen from the one the other flies straight
MONKEY = """
parameters: {a: 4 m, b: 3 m, u: 8 m/s, g: 9.81 m/s^2}
bodies:
  A: {particle: {mass: 1 kg}, at: [0, 0], velocity: [u, 0]}
  B: {particle: {mass: 1 kg}, at: [a, b]}
loads: {weight: {gravity: g}}
"""


# r = (a, b) and w = (-vA, -vB) from A to B: the least distance is |r x w|/|w|, at t = -r.w/w^2
@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        (SHIPS, "least distance of A and B", "abs(a*vB - b*vA)/sqrt(vA^2 + vB^2)"),
        (SHIPS, "When are A and B closest?", "(a*vA + b*vB)/(vA^2 + vB^2)"),
        (SHIPS, "x of A when distance from A to B is least", "vA*(a*vA + b*vB)/(vA^2 + vB^2)"),
        (SHIPS, "Wie nahe kommen sich A und B?", "abs(a*vB - b*vA)/sqrt(vA^2 + vB^2)"),
        (MONKEY, "least distance from A to B", "b"),
        (MONKEY, "speed of B when distance from A to B is least", "g*a/u"),
        (STONE, "least speed of stone", "v0*cos(b)"),
        (STONE, "y when speed of stone is least", "(v0*sin(b))^2/(2*g)"),
    ],
)
def test_what_is_accelerated_evenly_turns_once(model: str, question: str, formula: str) -> None:
    is_formula(model, question, formula, factors=(1.0, 1.02, 0.98))


def test_ships_that_part_are_closest_at_the_start() -> None:
    text = SHIPS.replace("[vA, 0]", "[-vA, 0]").replace("[0, -vB]", "[0, vB]")
    is_formula(text, "least distance from A to B", "sqrt(a^2 + b^2)", factors=(1.0, 1.02))
    assert "without bound" in str(posed(text, "greatest distance from A to B").reason)


def test_the_least_speed_is_derived_at_its_instant() -> None:
    told = is_derived(STONE, "least speed of stone")
    assert "v = v₀⋅cos(b)" in told["en"]


SWING = """
parameters: {m: 1 kg, L: 2 m, a: 40 deg, g: 9.81 m/s^2}
bodies: {bob: {particle: {mass: m}}}
connections: {rod: {link: [ground.O, bob, L]}}
loads: {weight: {gravity: g}}
measures: {phi: {angle of line from ground.O to bob from down}}
start: {phi: a, rate(phi): 0}
"""


def test_both_ends_of_a_swing_are_told() -> None:
    """S = m g (3 cos phi - 2 cos a) is least at both turns, and greatest once."""
    least = posed(SWING, "least tension of rod")
    assert [str(n) for n in least.notes] == ["least at φ = a and φ = -a"]
    there = posed(SWING, "phi when tension of rod is least")
    assert "least at φ = a and φ = -a" in [str(n) for n in there.notes]
    assert [str(n) for n in posed(SWING, "greatest tension of rod").notes] == ["largest at φ = 0"]


def test_both_ends_stand_in_the_table_of_a_derivation() -> None:
    assert "-a" in " ".join(is_derived(SWING, "least tension of rod")["en"].split())


GUIDED = """
parameters: {m: 9 kg, L: 1.2 m, k: 40 N/m, theta_0: 60 deg, g: 9.81 m/s^2}
bodies: {bar: {rod: {mass: m, length: L}}}
connections:
  A: {slot: {pin: bar.start, through: ground.O, along: right}}
  B: {slot: {pin: bar.end, through: ground.O, along: up}}
loads: {weight: {gravity: g}, spring: {spring: {first: ground.O, second: bar.start, stiffness: k, length: 0}}}
measures: {theta: angle of line from bar.start to bar.end from right}
start: {theta: theta_0, rate(theta): 0}
"""


def test_a_place_does_not_need_what_the_time_to_it_takes() -> None:
    """m L^2 theta'^2/6 = (m g L/2) (sin theta_0 - sin theta) + (k L^2/2) (sin^2 theta - sin^2 theta_0), which falls up
    to sin theta = m g/(2 k L): it goes down where m g > 2 k L sin theta_0, and is fastest at the bottom."""
    found = posed(GUIDED, "theta when speed of bar is greatest")
    assert found.value == pytest.approx(-math.pi / 2)
    assert not [c for c in found.conditions if "as at the start" in str(c)]
