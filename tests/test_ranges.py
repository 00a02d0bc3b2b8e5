"""For which values of a parameter an inequality holds: all of them, the least, the largest.

Every end is found by hand from the formula of the quantity. Problem families: Meriam & Kraige, Engineering Mechanics:
Dynamics, ch. 2 and 3; Hibbeler, Dynamics, ch. 12 to 15; Beer & Johnston, Dynamics, ch. 12 and 13.
"""

from __future__ import annotations

import pytest

import freebody as fb
from freebody.api import System
from freebody.errors import ModelError
from freebody.language.expression import FLOAT_FUNCTIONS, evaluate
from freebody.language.parser import parse
from posed import is_derived, is_formula, posed

PENDULUM = """
parameters: {m: 2 kg, L: 1.2 m, g: 9.81 m/s^2, w0: 9 1/s, S: 60 N, theta0: 70 deg}
bodies: {bob: {particle: {mass: m}}}
connections: {rod: {link: [ground.O, bob, L]}}
loads: {weight: {gravity: g}}
measures: {theta: {angle of line from ground.O to bob from down}}
start: {theta: 0, rate(theta): w0}
"""
THROW = """
parameters: {v0: 15 m/s, theta: 50 deg, s: 12 m, h: 2 m, g: 9.81 m/s^2, T: 1 s}
bodies: {ball: {particle: {mass: 1 kg}}}
loads: {weight: {gravity: g}}
measures: {x: x of ball, y: y of ball}
start: {x: 0, y: 0, rate(x): v0*cos(theta), rate(y): v0*sin(theta)}
"""
ATWOOD = """
parameters: {m1: 3 kg, m2: 2 kg, g: 9.81 m/s^2, a: 1 m/s^2}
bodies:
  pulley: {disk: {mass: 0, radius: 0.1 m}, fixed: true}
  left: {particle: {mass: m1}}
  right: {particle: {mass: m2}}
connections: {rope: {string: {from: left, over: [pulley], to: right}}}
loads: {weight: {gravity: g}}
measures: {x: drop of left}
"""
BLOCK = """
parameters: {m: 2 kg, mu: 0.3, v0: 4 m/s, g: 9.81 m/s^2, d: 1.5 m}
ground: {lines: {floor: {along: right}}}
bodies: {block: {particle: {mass: m}}}
connections: {touch: {contact: {between: [block, floor], friction: mu}}}
loads: {weight: {gravity: g}}
measures: {x: {travel of block along floor}}
start: {x: 0, rate(x): v0}
"""
FALLING = """
parameters: {m: 2 kg, g: 9.81 m/s^2, c: 0.8 kg/s, v1: 20 m/s}
bodies: {ball: {particle: {mass: m}}}
loads: {weight: {gravity: g}, air: {force: {at: ball, along: up, magnitude: -c*rate(y)}}}
measures: {y: y of ball}
start: {y: 0, rate(y): 0}
"""

BEAM = """
parameters: {L: 2 m, F: 6 kN, H: 4 kN, S: 5 kN}
ground: {points: {A: [0, 0], B: [L, 0]}}
bodies: {beam: {rod: {length: L}, angle: 0, at: {start: [0, 0]}}}
connections: {A: {pin: [ground.A, beam.start]}, B: {slot: {pin: beam.end, through: ground.B, along: right}}}
loads:
  F: {force: {at: beam, along: down, magnitude: F}}
  pull: {force: {at: beam.end, along: right, magnitude: H}}
"""
# model, question, ends, what the range is called
RANGES = {
    # m L w^2 - m g >= 0 at the top, with w^2 = w0^2 - 4 g/L
    "taut at the top": (
        PENDULUM,
        "range of w0 for which tension of rod >= 0 when theta = 180 deg",
        ["sqrt(5*g/L)"],
        "≥",
    ),
    # energy: L w0^2/2 > 2 g, and more than that to arrive
    "over the top": (PENDULUM, "range of w0 for which theta reaches 180 deg", ["2*sqrt(g/L)"], ">"),
    "to the side": (PENDULUM, "least w0 so that theta reaches 90 deg", ["sqrt(2*g/L)"], "≥"),
    "strength": (PENDULUM, "largest w0 so that tension of rod <= S at start", ["sqrt((S - m*g)/(m*L))"], "≤"),
    "strength, mass": (PENDULUM, "largest m so that tension of rod <= S at start", ["S/(g + L*w0^2)"], "≤"),
    # s tan(theta) - g s^2/(2 v0^2 cos^2(theta)) >= h, quadratic in tan(theta)
    "angles of a throw": (
        THROW,
        "range of theta for which y >= h when x = s",
        [
            "atan((v0^2 - sqrt(v0^4 - g*(g*s^2 + 2*h*v0^2)))/(g*s))",
            "atan((v0^2 + sqrt(v0^4 - g*(g*s^2 + 2*h*v0^2)))/(g*s))",
        ],
        "≤",
    ),
    "speed of a throw": (
        THROW,
        "range of v0 for which y > h when x = s",
        ["s*sqrt(g/(2*cos(theta)*(s*sin(theta) - h*cos(theta))))"],
        ">",
    ),
    "height of a throw": (THROW, "least v0 so that y reaches h", ["sqrt(2*g*h)/sin(theta)"], "≥"),
    "wall": (THROW, "largest h so that y >= h when x = s", ["s*tan(theta) - g*s^2/(2*v0^2*cos(theta)^2)"], "≤"),
    "by the clock": (THROW, "range of v0 for which y at t = T is positive", ["g*T/(2*sin(theta))"], ">"),
    # (m1 - m2) g/(m1 + m2)
    "which way": (ATWOOD, "range of m1 for which acceleration of x > 0", ["m2"], ">"),
    "slowly": (ATWOOD, "range of m1 for which acceleration of x < a", ["m2*(g + a)/(g - a)"], "<"),
    "fast enough": (ATWOOD, "least m1 so that acceleration of x >= a", ["m2*(g + a)/(g - a)"], "≥"),
    "rope": (ATWOOD, "largest m2 so that tension of rope <= m1*g/2", ["m1/3"], "≤"),
    # (H, F/2) in the pin: less than a value is the size of a force
    "what a pin bears": (BEAM, "largest F so that reaction of A <= S", ["2*sqrt(S^2 - H^2)"], "≤"),
    # v0^2 = 2 mu g d
    "as far as d": (BLOCK, "range of v0 for which x reaches d", ["sqrt(2*mu*g*d)"], ">"),
    "smooth enough": (BLOCK, "range of mu for which x >= d when velocity of x = 0", ["v0^2/(2*g*d)"], "≤"),
    # m g/c <= v1
    "parachute": (FALLING, "least c so that terminal velocity of y >= -v1", ["m*g/v1"], "≥"),
}


@pytest.mark.parametrize("name", RANGES)
def test_range_of_a_parameter(name: str) -> None:
    text, question, formulas, sign = RANGES[name]
    found = posed(text, question)
    assert found.expression is not None, found.reason
    assert found.evidence is not None
    ends = found.expression if isinstance(found.expression, tuple) else (found.expression,)
    assert len(ends) == len(formulas)
    own = {p.name: p.value for p in System.from_text(text).parameters.values() if p.value is not None}
    for n, factor in enumerate((1.0, 1.02, 0.99)):
        values = {key: v * factor ** (1 + 0.3 * (k + n)) for k, (key, v) in enumerate(sorted(own.items()))}
        for end, formula in zip(ends, formulas, strict=True):
            wanted = evaluate(parse(formula), values, FLOAT_FUNCTIONS)
            assert evaluate(end, values, FLOAT_FUNCTIONS) == pytest.approx(wanted, rel=1e-9)
    (told,) = [note for note in found.notes if note.startswith("this holds for ")]
    assert f" {sign} " in told, told


def test_the_range_is_where_the_quantity_says_so() -> None:
    """Values inside and outside put in: an independent look at the sense of every sign."""
    for w0, holds in ((5.0, False), (6.0, False), (6.5, True), (12.0, True)):
        found = posed(PENDULUM.replace("w0: 9 1/s", f"w0: {w0} 1/s"), "tension of rod when theta = 180 deg")
        assert (isinstance(found.value, float) and found.value >= 0) == holds


def test_the_limit_between_two_cases_is_named() -> None:
    """Just at v0^2 = 2 mu g d the block stops at d: one case passes into the other."""
    found = posed(BLOCK, "range of v0 for which x reaches d")
    assert any("limit between two cases" in note for note in found.notes)


def test_what_holds_everywhere_or_nowhere_is_said() -> None:
    assert "for every positive value" in posed(ATWOOD, "range of m1 for which tension of rope > 0").reason
    assert "no value of m1" in posed(ATWOOD, "range of m1 for which acceleration of x > 2*g").reason
    assert "no least value" in posed(ATWOOD, "least m1 so that acceleration of x < a").reason
    assert "no largest value" in posed(ATWOOD, "largest m1 so that acceleration of x > 0").reason


WORDS = ("is positive", "> 0", "exceeds 0", "is greater than 0")


@pytest.mark.parametrize("words", WORDS)
def test_words_for_inequalities(words: str) -> None:
    is_formula(ATWOOD, f"range of m1 for which acceleration of x {words}", "m2")


def test_a_least_value_with_an_equation_is_the_one_that_solves_it() -> None:
    asked = System.from_text(ATWOOD).question("least m1 so that acceleration of x = a")
    assert asked.understood == "value of m1 for which acceleration of x = a"
    with pytest.raises(ModelError, match="no parameter"):
        System.from_text(ATWOOD).question("range of m3 for which acceleration of x > 0")


def test_the_end_of_a_range_is_derived() -> None:
    told = is_derived(ATWOOD, "least m1 so that acceleration of x >= a")
    assert all("m₁" in text for text in told.values())


def test_a_range_is_found_where_the_numbers_of_the_file_do_not_get_there() -> None:
    # v^2 = 2 g L (1 - cos theta0) at the bottom, above the peg v^2 = that - 4 g (L - d) >= g (L - d)
    system = fb.System.from_text("""
parameters: {m: 0.5 kg, L: 1 m, d: 0.7 m, theta0: 60 deg, g: 9.81 m/s^2}
ground: {points: {O: [0, 0], P: [0, -d]}}
bodies: {bob: {particle: {mass: m}}}
connections: {string: {link: [ground.P, bob, L - d]}}
loads: {weight: {gravity: g}}
measures: {phi: {angle of line from ground.P to bob from down}}
start: {phi: 0, rate(phi): sqrt(2*g*L*(1 - cos(theta0)))/(L - d)}
""")
    answer = system.solve("least d so that tension of string >= 0 when phi = 180 deg").answers[0]
    assert answer.value == pytest.approx(0.8)
