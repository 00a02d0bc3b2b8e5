"""Events of measures that closed loops bind, or that are waves of the coordinate.

Slider-crank: (x - r cos psi)^2 + r^2 sin^2 psi = l^2, so cos psi = (x^2 + r^2 - l^2)/(2 x r), l sin phi = r sin psi,
and x' = -x r w sin psi/(x - r cos psi). Quick return: the lever from A points to the crank pin, r sin(phi - psi) =
h cos phi; it reverses where sin psi = -r/h. A massless crank that coasts leaves the lever its kinetic energy.
Problem families: Norton, Design of Machinery, ch. 4 (positions) and 6 (velocities); Meriam & Kraige, Dynamics, 5/4 and
5/6; Beer & Johnston, Dynamics, 15.3 and 17.1; Hibbeler, Dynamics, 14.5 and 16.4.
"""

from __future__ import annotations

import math

import pytest

from posed import is_derived, is_formula, posed

SLIDER_CRANK = """
parameters: {r: 0.05 m, l: 0.2 m, w: 30 1/s, X: 0.21 m}
ground: {lines: {rail: {along: right}}}
bodies: {crank: {rod: {length: r}}, rod: {rod: {length: l}}, piston: {particle: {mass: 0.8 kg}}}
connections:
  O: {pin: [ground.O, crank.start]}
  A: {pin: [crank.end, rod.start]}
  B: {pin: [rod.end, piston]}
  guide: {slider: [piston, ground.rail]}
  motor: {driver: {measure: psi, follows: w*t}}
measures: {psi: angle of crank, phi: angle of rod clockwise, x: x of piston}
"""
QUICK_RETURN = """
parameters: {r: 0.1 m, h: 0.25 m, w: 3 rad/s, m: 1 kg}
ground: {points: {O: [0, h], A: [0, 0]}}
bodies: {crank: {rod: {length: r}}, lever: {rod: {mass: m, length: 0.5 m}, near: {angle: 70 deg}}}
connections:
  main: {pin: [ground.O, crank.start]}
  pivot: {pin: [ground.A, lever.start]}
  block: {slot: {pin: crank.end, along: right, on: lever}}
measures: {psi: angle of crank, phi: angle of lever, s: distance from ground.A to crank.end}
"""
MOTOR = QUICK_RETURN.replace("measures:", "  motor: {driver: {measure: psi, follows: w*t}}\nmeasures:")
COASTING = f"{QUICK_RETURN}start: {{psi: 0, rate(psi): w}}\n"
YOKE = """
parameters: {r: 0.06 m, w: 25 rad/s, m: 2.5 kg}
bodies: {crank: {rod: {length: r}}, yoke: {body: {mass: m}}}
connections:
  O: {pin: [ground.O, crank.start]}
  guide: {slider: {body: yoke, along: right}}
  slot: {slot: {pin: crank.end, along: yoke.y, on: yoke}}
  motor: {driver: {measure: theta, follows: w*t}}
measures: {theta: {angle of crank}, x: x of yoke}
"""
PENDULUM = """
parameters: {L: 1.2 m, g: 9.81 m/s^2, a: 60 deg}
bodies: {bob: {particle: {mass: 2 kg}}}
connections: {rope: {link: [ground.O, bob, L]}}
loads: {weight: {gravity: g}}
measures: {theta: {angle of line from ground.O to bob from down}, x: x of bob}
start: {theta: a}
"""
TIPPER = """
parameters: {a: 1.5 m, b: 2 m, c: 1 m, m: 800 kg, L: 4 m, v: 0.1 m/s, g: 9.81 m/s^2, beta: 40 deg}
ground: {points: {O: [0, 0], A: [b, 0]}}
bodies: {bed: {rod: {mass: m, length: L}, points: {P: [a - L/2, 0]}}}
connections:
  O: {pin: [ground.O, bed.start]}
  ram: {driver: {measure: s, follows: c + v*t}}
loads: {weight: {gravity: g}}
measures: {s: distance from ground.A to bed.P, theta: angle of bed}
"""
HEAVY = COASTING.replace("crank: {rod: {length: r}}", "crank: {rod: {mass: m, length: r}}")
ARC = "acos((X^2 + r^2 - l^2)/(2*X*r))"

FORMULAS = {
    "crank by the piston": (SLIDER_CRANK, "psi when x = X", ARC),
    "time by the piston": (SLIDER_CRANK, "time when x = X", f"{ARC}/w"),
    "piston at the length of the rod": (
        SLIDER_CRANK,
        "velocity of x when x = l",
        "-r*w*l*sqrt(4*l^2 - r^2)/(2*l^2 - r^2)",
    ),
    "crank by the rod": (SLIDER_CRANK, "psi when phi = 10 deg", "asin(l*sin(pi/18)/r)"),
    "rod is steepest": (SLIDER_CRANK, "psi when rate(phi) = 0", "pi/2"),
    "lever upright": (MOTOR, "time when phi = 90 deg", "pi/(2*w)"),
    "lever turned": (MOTOR, "psi when phi = 100 deg", "5*pi/9 - asin(h*cos(5*pi/9)/r)"),
    "lever reverses": (MOTOR, "time when rate(phi) = 0", "(pi + asin(r/h))/w"),
    "block far out": (MOTOR, "psi when s = h", "pi + asin(r/(2*h))"),
    "lever by energy": (COASTING, "angular velocity of lever when phi = 90 deg", "r^2*w/(r^2 + h^2)"),
    "crank by energy": (COASTING, "angular velocity of crank when phi = 90 deg", "r*w*(r + h)/(r^2 + h^2)"),
    "reversal of what coasts": (HEAVY, "psi when rate(phi) = 0", "pi + asin(r/h)"),
    "yoke": (YOKE, "velocity of x when x = r/2", "-r*w*sqrt(3)/2"),
    "yoke reverses": (YOKE, "time when rate(x) = 0", "pi/w"),
    "bob by its place": (PENDULUM, "theta when x = L/2", "pi/6"),
    "bob by the other side": (PENDULUM, "theta when x = -L/3", "-asin(1/3)"),
    "speed by its place": (PENDULUM, "speed of bob when x = L/2", "sqrt(2*g*L*(sqrt(3)/2 - cos(a)))"),
}


@pytest.mark.parametrize("name", FORMULAS)
def test_the_event_is_solved_for(name: str) -> None:
    is_formula(*FORMULAS[name], factors=(1.0, 1.02, 0.99))


@pytest.mark.parametrize(
    ("question", "formula"),
    [
        # s^2 = a^2 + b^2 - 2 a b cos(theta), so s v = a b sin(theta) theta'
        ("angular velocity of bed when theta = beta", "v*sqrt(a**2 + b**2 - 2*a*b*cos(beta))/(a*b*sin(beta))"),
        ("time when theta = beta", "(sqrt(a**2 + b**2 - 2*a*b*cos(beta)) - c)/v"),
    ],
)
def test_a_ram_that_lengthens_evenly_has_tipped_a_bed_to_an_angle(question: str, formula: str) -> None:
    is_formula(TIPPER, question, formula)
    is_derived(TIPPER, question)


@pytest.mark.parametrize(
    ("text", "question", "needed"),
    [
        # on the other side of 2 l^2 = r^2 the piston is behind the crank pin there: x = r cos psi - sqrt(..)
        (SLIDER_CRANK, "time when x = l", "2·l² > r²"),
        (SLIDER_CRANK, "psi when phi = 10 deg", "r > l·sin(π/18)"),
        (MOTOR, "time when rate(phi) = 0", "h > r"),
        (MOTOR, "psi when s = h", "2·h > r"),
    ],
)
def test_an_event_needs_that_it_is_reached(text: str, question: str, needed: str) -> None:
    assert needed in {str(c).partition(" (")[0] for c in posed(text, question).conditions}


def test_a_place_beyond_the_reach_is_no_event() -> None:
    found = posed(YOKE, "time when x = 2*r")
    assert found.expression is None
    assert found.value is None
    assert "does not" in str(found.reason)


@pytest.mark.parametrize(
    ("text", "question"),
    [
        (SLIDER_CRANK, "velocity of x when x = l"),
        (MOTOR, "time when phi = 90 deg"),
        (COASTING, "angular velocity of lever when phi = 90 deg"),
        (PENDULUM, "speed of bob when x = L/2"),
    ],
)
def test_it_is_derived(text: str, question: str) -> None:
    is_derived(text, question)


def test_the_numbers_agree_with_the_triangle() -> None:
    """cos psi = (x^2 + r^2 - l^2)/(2 x r)."""
    found = posed(SLIDER_CRANK, "psi when x = X")
    assert found.value == pytest.approx(math.acos((0.21**2 + 0.05**2 - 0.2**2) / (2 * 0.21 * 0.05)), rel=1e-12)
