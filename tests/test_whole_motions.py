"""What is asked of a whole motion where several coordinates move, each or their sums by a law of its own; and the signs
that formulas take as they are at the start, which must then be so all along.

A ball thrown at the angle b over a slope of the angle a: along the normal v sin(b - a), against g cos a. Two carts on a
spring: their relative motion has the mass m1 m2/(m1 + m2), so the spring gets shorter by v sqrt(m1 m2/((m1 + m2) k)).
Problem families: Meriam & Kraige, Dynamics, 2/4 and 3/9; Hibbeler, Dynamics, 12.6 and 22.1; Beer & Johnston, Dynamics,
13.4 and 19.2.
"""

from __future__ import annotations

from fractions import Fraction

import pytest

import freebody as fb
from freebody.api import System
from freebody.language.notation import to_text
from freebody.symbolic.functions import cos_sin, functions
from freebody.symbolic.signed_field import SignedField
from freebody.symbolic.signs import Sign, sign_of
from freebody.symbolic.tidy import tidy
from posed import is_formula, posed

SLOPE = """
parameters: {m: 1 kg, v: 20 m/s, a: 20 deg, b: 50 deg, g: 9.81 m/s^2}
ground: {lines: {slope: {along: a}}}
bodies: {ball: {particle: {mass: m}, at: [0, 0], velocity: [v*cos(b), v*sin(b)]}}
loads: {weight: {gravity: g}}
measures: {s: {travel of ball along slope}, n: {travel of ball along normal to slope}}
start: {s: 0, n: 0}
"""
CARTS = """
parameters: {m1: 2 kg, m2: 3 kg, k: 120 N/m, l: 0.4 m, v: 2 m/s}
ground: {lines: {rail: {along: right}}}
bodies: {A: {particle: {mass: m1}, at: [0, 0]}, B: {particle: {mass: m2}, at: [l, 0]}}
connections: {ga: {slider: {body: A, along: rail}}, gb: {slider: {body: B, along: rail}}}
loads: {spring: {spring: {first: A, second: B, stiffness: k, length: l}}}
measures: {x1: x of A, x2: x of B, d: {expression: x2 - x1}}
start: {x1: 0, x2: l, rate(x1): v, rate(x2): 0}
"""
CART = """
parameters: {m: 2 kg, k: 120 N/m, l: 0.4 m, v: 2 m/s}
ground: {lines: {rail: {along: right}}}
bodies: {A: {particle: {mass: m}, at: [l, 0]}}
connections: {ga: {slider: {body: A, along: rail}}}
loads: {spring: {spring: {first: ground.O, second: A, stiffness: k, length: l}}}
measures: {x: x of A}
start: {x: l, rate(x): -v}
"""
CASES = {
    "height over a slope": (SLOPE, "greatest n", "v^2*sin(b - a)^2/(2*g*cos(a))"),
    "the highest point": (SLOPE, "greatest y of ball", "v^2*sin(b)^2/(2*g)"),
    "as far along the slope as it gets": (SLOPE, "greatest s", "v^2*cos(b - a)^2/(2*g*sin(a))"),
    "range on a slope": (SLOPE, "s when n = 0", "2*v^2*sin(b - a)*cos(b)/(g*cos(a)^2)"),
    "nearest": (CARTS, "least d", "l - v*sqrt(m1*m2/((m1 + m2)*k))"),
    "farthest": (CARTS, "greatest distance from A to B", "l + v*sqrt(m1*m2/((m1 + m2)*k))"),
    "period of the relative motion": (CARTS, "period of d", "2*pi*sqrt(m1*m2/((m1 + m2)*k))"),
    "force in a spring between two": (CARTS, "greatest force in spring", "v*sqrt(k*m1*m2/(m1 + m2))"),
    "the other way": (CARTS, "least force in spring", "-v*sqrt(k*m1*m2/(m1 + m2))"),
}


@pytest.mark.parametrize("name", CASES)
def test_several_coordinates_have_the_extremes_of_a_textbook(name: str) -> None:
    is_formula(*CASES[name], factors=(1.0, 1.02, 0.98))


def _conditions(text: str, question: str) -> list[str]:
    return [str(c).split(" (")[0] for c in posed(text, question).conditions]


@pytest.mark.parametrize("question", ["least d", "greatest d", "period of d", "greatest force in spring"])
def test_two_carts_may_not_pass_through_each_other(question: str) -> None:
    # the force of the spring is k (d - l) only while d > 0, and the least d is l - v/w
    assert _conditions(CARTS, question) == ["l > v·√(m₁·m₂/(k·(m₁ + m₂)))"]


@pytest.mark.parametrize("question", ["least x", "greatest x", "period of x", "greatest force in spring"])
def test_what_holds_of_a_whole_motion_needs_its_signs_all_along(question: str) -> None:
    assert _conditions(CART, question) == ["l > v·√(m/k)"]


def test_the_greatest_speed_needs_none_where_the_energy_tells_it() -> None:
    """The spring stores nothing at x = l, to which the cart comes back on either side of its fixed end."""
    assert _conditions(CART, "greatest velocity of x") == ["for all positive parameters"]


HUNG = """
parameters: {m: 2 kg, M: 1 kg, k: 120 N/m, l: 0.4 m, v: 1 m/s, r: 0.1 m, g: 9.81 m/s^2}
ground: {points: {A: [-2*r, 0], P: [-r, 2 m]}}
bodies: {load: {particle: {mass: m}}, tray: {particle: {mass: 0}}, wheel: {disk: {mass: M, radius: r}}}
connections:
  axle: {pin: [ground.P, wheel.center]}
  rope: {string: {from: tray, over: [wheel], to: load, grips: [wheel]}}
loads:
  weight: {gravity: g}
  spring: {spring: {first: ground.A, second: tray, stiffness: k, length: l}}
measures: {y: {height of tray above ground.A}}
start: {y: l + m*g/k, rate(y): v}
"""


def test_a_period_needs_its_strings_taut_all_along() -> None:
    # the spring pulls the massless tray with m g + k (y - y0), at the least m g - k v/w, and w^2 = k/(m + M/2)
    is_formula(HUNG, "period of y", "2*pi*sqrt((m + M/2)/k)", factors=(1.0, 1.02))
    # and neither does it reach the wheel, 2 m up: v/w <= 2 m - l - m g/k
    found = [str(c) for c in posed(HUNG, "period of y").conditions]
    assert found == [
        "v ≤ m·g·√(2/(k·(2·m + M))) (rope stays taut)",
        "v ≤ (2·k - m·g - k·l)·√(2/(k·(2·m + M))) (tray has not reached wheel)",
    ]


def test_a_ball_that_is_thrown_down_the_slope_is_highest_at_the_start() -> None:
    found = posed(SLOPE.replace("b: 50 deg", "b: 10 deg"), "greatest n")
    assert found.value == 0.0
    assert found.evidence is not None


def test_what_is_driven_on_gets_farther_and_farther() -> None:
    found = posed(SLOPE, "least s")
    assert found.never
    assert "without bound" in str(found.reason)


def test_the_greatest_range_on_a_slope_is_half_way_to_the_vertical() -> None:
    found = is_formula(SLOPE, "value of b for which s when n = 0 is largest", "pi/4 + a/2", factors=(1.0, 0.97))
    assert [str(c) for c in found.conditions] == ["for all positive parameters, 0 < a < 90°"]


def test_the_start_normal_to_the_slope_is_hit_at_a_right_angle() -> None:
    # v cos(b - a) = g sin a t and t = 2 v sin(b - a)/(g cos a): tan(b - a) tan a = 1/2
    found = is_formula(
        SLOPE, "value of b for which velocity of s = 0 when n = 0", "a + atan(1/(2*tan(a)))", factors=(1.0, 0.97)
    )
    assert found.value is not None


def test_a_range_of_angles_is_told_by_angles() -> None:
    found = fb.solve(System.from_text(SLOPE + "questions: [range of b for which velocity of s > 0 when n = 0]\n"))
    assert any("b > a" in str(note) for note in found.answers[0].notes)


# -- sums of given angles -------------------------------------------------------------------------
FIELD = SignedField()
A, B = (FIELD.parameter(name, positive=True) for name in "ab")
FIELD.acute_angles |= {FIELD.index(A), FIELD.index(B)}
(CA, SA), (CB, SB) = cos_sin(FIELD, A), cos_sin(FIELD, B)
F = functions(FIELD)


@pytest.mark.parametrize(
    ("x", "text"),
    [
        (CA * SB - SA * CB, "sin(b - a)"),
        (CA * CB - SA * SB, "cos(a + b)"),
        ((CA * SB - SA * CB) ** 2 / CA, "sin(a - b)²/cos(a)"),
        ((CA * CB + SA * SB) ** 2, "cos(a - b)²"),
        (F["atan"](CA / SA), "(π - 2·a)/2"),
        (F["acos"](-CB), "π - b"),
        (F["asin"](SA), "a"),
    ],
)
def test_functions_of_given_angles_are_gathered(x: object, text: str) -> None:
    assert to_text(tidy(x)) == text  # type: ignore[arg-type]


@pytest.mark.parametrize("first", ["asin", "acos"])
def test_an_arc_is_shown_alike_whatever_was_made_before(first: str) -> None:
    field = SignedField()
    a, b = (field.parameter(name, positive=True) for name in "ab")
    made = functions(field)
    made[first](a / b)
    asin, acos = made["asin"](a / b), made["acos"](a / b)
    shown = [to_text(tidy(x)) for x in (asin, 2 * acos, made["acos"](-a / b), field.pi - 2 * acos)]
    assert shown == ["asin(a/b)", "2·acos(a/b)", "π - acos(a/b)", "2·asin(a/b)"]


@pytest.mark.parametrize(
    ("x", "sign"),
    [
        (FIELD.pi - 2 * A, Sign.POSITIVE),
        (FIELD.pi - A - B, Sign.POSITIVE),
        (A - FIELD.pi / 2, Sign.NEGATIVE),
        (FIELD.pi / 2 - A - B, Sign.UNKNOWN),
        (B - A, Sign.UNKNOWN),
        (F["atan"]((2 - CA * CA) / (CA * SA)) - A, Sign.POSITIVE),
    ],
)
def test_signs_of_sums_of_acute_angles(x: object, sign: Sign) -> None:
    assert sign_of(x) is sign  # type: ignore[arg-type]


def test_the_root_of_a_quotient_is_positive_where_its_divisor_is_written_negative() -> None:
    # 1 + u^2 with u = (2 - c^2)/(c s) has the divisor c^2 - c^4, which the normal form writes with the sign of -c^4
    u = (2 - CA * CA) / (CA * SA)
    cosine = cos_sin(FIELD, F["atan"](u))[0]
    value = FIELD.evaluate(cosine, FIELD.complete({FIELD.index(A): 0.35, FIELD.index(B): 0.9}))
    assert float(value) > 0
    assert (cosine * cosine * (1 + u * u)).fraction() == Fraction(1)
