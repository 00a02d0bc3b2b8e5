"""What a mechanism of one freedom has in a pose: at its dead points, and at rest.

Slider-crank at its dead points, turned evenly: x'' = -r w^2 (1 + r/l) stretched, r w^2 (1 - r/l) folded; the force of
the rod on the piston is what that and the gas force leave, and the torque is zero. Four-bar: the triangles a + b, c, d
and b - a, c, d. At rest forces are as the rates of their points turned round (virtual power).
Problem families: Norton, Design of Machinery, 3.12, 4.10, 6.4 and 6.5; Meriam & Kraige, Statics, 7/3 (toggle press);
Beer & Johnston, Statics, 6.4; Hibbeler, Dynamics, 16.7.
"""

from __future__ import annotations

import math

import pytest

from freebody.api import System
from freebody.language.expression import FLOAT_FUNCTIONS, Expr, evaluate
from freebody.language.parser import parse
from posed import is_derived, is_formula, posed

CRANK = """
parameters: {r: 0.05 m, l: 0.2 m, m: 0.8 kg, F: 200 N, w: 30 1/s}
ground: {lines: {rail: {along: right}}}
bodies: {crank: {rod: {mass: 0, length: r}}, rod: {rod: {mass: 0, length: l}}, piston: {particle: {mass: m}}}
connections:
  O: {pin: [ground.O, crank.start]}
  A: {pin: [crank.end, rod.start]}
  B: {pin: [rod.end, piston]}
  guide: {slider: [piston, ground.rail]}
  motor: {driver: {measure: psi, follows: w*t}}
loads: {gas: {force: {at: piston, along: left, magnitude: F}}}
measures: {psi: angle of crank, x: x of piston}
"""
BARS = """
parameters: {a: 0.1 m, b: 0.3 m, c: 0.25 m, d: 0.3 m}
ground: {points: {O: [0, 0], D: [d, 0]}}
bodies:
  crank: {rod: {mass: 1 kg, length: a}}
  coupler: {rod: {mass: 1 kg, length: b}}
  rocker: {rod: {mass: 1 kg, length: c}}
connections:
  O: {pin: [ground.O, crank.start]}
  A: {pin: [crank.end, coupler.start]}
  B: {pin: [coupler.end, rocker.end]}
  C: {pin: [ground.D, rocker.start]}
measures: {psi: angle of crank, phi: angle of rocker}
start: {psi: 60 deg}
"""
PRESS = """
parameters: {r: 0.1 m, l: 0.2 m, F: 40 N, R: 10 N, p: 50 deg}
ground: {lines: {rail: {along: right}}}
bodies: {crank: {rod: {mass: 0, length: r}}, rod: {rod: {mass: 0, length: l}}, ram: {particle: {mass: 1 kg}}}
connections:
  O: {pin: [ground.O, crank.start]}
  A: {pin: [crank.end, rod.start]}
  B: {pin: [rod.end, ram]}
  guide: {slider: [ram, ground.rail]}
loads:
  hand: {force: {at: crank.end, along: down, magnitude: F}}
  die: {force: {at: ram, along: left, magnitude: R}}
measures: {psi: angle of crank, x: x of ram}
start: {psi: p}
"""
SLOPE = "(r*sin(p)*(1 + r*cos(p)/sqrt(l^2 - r^2*sin(p)^2)))"  # -dx/dpsi
STRETCHED = "acos(((a + b)^2 + d^2 - c^2)/(2*(a + b)*d))"
FOLDED = "acos(((b - a)^2 + d^2 - c^2)/(2*(b - a)*d))"


@pytest.mark.parametrize(
    ("text", "question", "formulas"),
    [
        (CRANK, "driving torque of motor at the dead points", ["0", "0"]),
        (CRANK, "acceleration of x at the dead points of x", ["-r*w^2*(1 + r/l)", "r*w^2*(1 - r/l)"]),
        (
            CRANK,
            "horizontal reaction of B on piston at dead centres",
            ["F - m*r*w^2*(1 + r/l)", "F + m*r*w^2*(1 - r/l)"],
        ),
        (CRANK, "x at the dead points", ["r + l", "l - r"]),
        (BARS, "psi at the dead points of rocker", [STRETCHED, f"pi + {FOLDED}"]),
        (BARS, "y of coupler.end at the dead points", [f"(a + b)*sin({STRETCHED})", f"(b - a)*sin({FOLDED})"]),
    ],
)
def test_at_the_dead_points(text: str, question: str, formulas: list[str]) -> None:
    found = posed(text, question)
    assert isinstance(found.expression, tuple), found.reason
    own = {p.name: p.value for p in System.from_text(text).parameters.values() if p.value is not None}
    values = tuple(evaluate(parse(formula), own, FLOAT_FUNCTIONS) for formula in formulas)
    assert found.value == pytest.approx(values, rel=1e-9, abs=1e-12)


@pytest.mark.parametrize(
    ("text", "question", "formula"),
    [
        (CRANK, "acceleration of x at the outer dead point", "-r*w^2*(1 + r/l)"),
        (CRANK, "x at the inner dead point", "l - r"),
        (BARS, "psi at the inner dead point of rocker", f"pi + {FOLDED}"),
    ],
)
def test_at_one_of_both_dead_points(text: str, question: str, formula: str) -> None:
    """Outer, where crank and coupler are stretched, and inner, where they are folded."""
    is_formula(text, question, formula)


def test_forces_at_dead_points_ask_for_a_drive() -> None:
    found = posed(BARS, "reaction of A at the dead points")
    assert "give it a driver" in found.reason
    assert found.value is None  # no number of a rate that nobody gave


@pytest.mark.parametrize(
    ("text", "question", "formula"),
    [
        (PRESS, "ratio of velocity of x to velocity of psi at start", f"-{SLOPE}"),
        (PRESS, "velocity of x / velocity of psi at start", f"-{SLOPE}"),
        (PRESS, "mechanical advantage of die to hand at start", f"r*cos(p)/{SLOPE}"),
        (PRESS, "value of R for which acceleration of psi = 0 at start", f"F*r*cos(p)/{SLOPE}"),
    ],
)
def test_at_rest(text: str, question: str, formula: str) -> None:
    found = posed(text, question)
    assert isinstance(found.expression, Expr), found.reason
    own = {p.name: p.value for p in System.from_text(text).parameters.values() if p.value is not None}
    assert found.value == pytest.approx(evaluate(parse(formula), own, FLOAT_FUNCTIONS), rel=1e-9)


def test_a_lever_has_the_ratio_of_its_arms() -> None:
    text = """
parameters: {a: 2 m, b: 0.5 m, F: 30 N, R: 10 N}
bodies: {lever: {rod: {mass: 0, length: a + b}, points: {O: [(a - b)/2, 0]}}}
connections: {fulcrum: {pin: [ground.O, lever.O]}}
loads:
  hand: {force: {at: lever.start, along: down, magnitude: F}}
  crate: {force: {at: lever.end, along: down, magnitude: R}}
measures: {phi: angle of lever}
"""
    is_formula(text, "mechanical advantage of crate to hand", "a/b")
    told = posed(text, "mechanical advantage of crate to hand").notes
    assert "this is crate divided by hand, where the two balance each other" in told


def test_the_ratio_of_rates_of_a_four_bar_is_that_of_nearby_poses() -> None:
    a, b, c, d = 0.1, 0.3, 0.25, 0.3

    def phi(psi: float) -> float:
        x, y = a * math.cos(psi) - d, a * math.sin(psi)
        side = math.hypot(x, y)
        return math.atan2(y, x) - math.acos((side * side + c * c - b * b) / (2 * side * c))

    psi, step = math.radians(60), 1e-5
    found = posed(BARS, "ratio of angular velocity of rocker to angular velocity of crank at start")
    assert found.value == pytest.approx((phi(psi + step) - phi(psi - step)) / (2 * step), rel=1e-8)


def test_a_ratio_that_changes_sign_with_the_sense_is_none_at_rest() -> None:
    found = posed(PRESS, "ratio of speed of ram to angular velocity of crank at start")
    assert "which way it moves" in found.reason
    assert found.value is None


@pytest.mark.parametrize(
    ("text", "question"),
    [
        (CRANK, "acceleration of x at the dead points"),
        (CRANK, "horizontal reaction of B on piston at the dead points"),
        (BARS, "phi at the dead points"),
        (PRESS, "mechanical advantage of die to hand at start"),
        (PRESS, "ratio of velocity of x to velocity of psi at start"),
        (CRANK, "x at the inner dead point"),
    ],
)
def test_it_is_derived(text: str, question: str) -> None:
    is_derived(text, question)


HANGING = """
parameters: {m: 2 kg, L: 1 m, F: 5 N, k: 40 N/m, l: 0.2 m, g: 9.81 m/s^2}
ground: {points: {O: [0, 0], top: [2 m, 1 m]}}
bodies: {bob: {particle: {mass: m}}, block: {particle: {mass: m}, at: [2 m, 0]}}
connections: {rod: {link: [ground.O, bob, L]}, guide: {slider: {body: block, along: up}}}
loads:
  weight: {gravity: g}
  wind: {force: {at: bob, along: right, magnitude: F}}
  spring: {spring: {first: ground.top, second: block, stiffness: k, length: l}}
measures: {theta: {angle of line from ground.O to bob from down}, y: y of block}
start: {theta: 60 deg, y: 0}
"""


def test_forces_and_places_in_equilibrium_are_those_where_nothing_accelerates() -> None:
    """At rest S = sqrt((m g)^2 + F^2) along the rod, whatever the start; the spring carries the weight: F = m g."""
    system = System.from_text(HANGING)
    for question, expected in (
        ("tension of rod in equilibrium", math.hypot(2 * 9.81, 5.0)),
        ("Zugkraft in rod im Gleichgewicht", math.hypot(2 * 9.81, 5.0)),
        ("force in spring at rest", 2 * 9.81),
        ("y of bob at rest", -2 * 9.81 / math.hypot(2 * 9.81, 5.0)),
    ):
        answer = system.solve(question)["q1"]
        assert answer.expression is not None
        assert answer.value == pytest.approx(expected, rel=1e-12)


def test_a_structure_at_rest_has_the_forces_that_it_always_has() -> None:
    arch = """
parameters: {P: 500 N, b: 4 m, c: 1.5 m, h: 2 m}
ground: {points: {A: [0, 0], B: [b, 0]}}
bodies: {C: {particle: {}, at: [c, h]}}
connections: {AC: {link: [ground.A, C]}, BC: {link: [ground.B, C]}}
loads: {load: {force: {at: C, along: down, magnitude: P}}}
"""
    found = System.from_text(arch).solve("tension of AC at rest")["q1"]
    assert found.value == pytest.approx(-500 * 2.5 / 4 * math.hypot(1.5, 2) / 2, rel=1e-12)


def test_a_crate_put_exactly_on_a_braking_truck_tips_or_slips_by_the_smaller_limit() -> None:
    """Corners that stick hold the crate's angle twice, once as cos(theta) = 1: two roots that coincide choose no
    branch. By hand: a = mu g or b g/h, whichever is less."""
    system = System.from_text("""
parameters: {m: 200 kg, M: 4 t, b: 0.8 m, h: 1.5 m, mu: 0.6, a: 4 m/s^2, v0: 15 m/s, g: 9.81 m/s^2}
ground: {points: {O: [0, 0]}}
bodies:
  truck: {body: {mass: M}, lines: {bed: {along: right}}}
  crate: {rectangle: {mass: m, width: b, height: h}, at: [0, h/2], velocity: [v0, 0]}
connections:
  guide: {slider: {body: truck, along: right}}
  drive: {driver: {measure: x, follows: v0*t - a*t^2/2}}
  bed: {contact: {between: [crate, truck.bed], friction: mu}}
loads: {weight: {gravity: g}}
measures: {x: x of truck}
questions: {it: largest a so that it stays at rest}
""")
    answer = system.solve()["it"]
    assert answer.value == pytest.approx(0.8 / 1.5 * 9.81)
    assert len(answer.cases) == 2
