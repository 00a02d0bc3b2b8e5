"""For which value of a parameter a quantity is largest or least.

Every place is found by hand from the slope of the formula. Problem families: Meriam & Kraige, Dynamics, ch. 2 and 3;
Beer & Johnston, Dynamics, ch. 11 and 19; Irodov, Problems in General Physics, 1.1 and 1.2; Morin, ch. 3.
"""

from __future__ import annotations

import math

import pytest

import freebody as fb
from conftest import Agree
from freebody.api import System
from posed import is_formula, posed

THROW = """
parameters: {v0: 15 m/s, theta: 50 deg, beta: 20 deg, g: 9.81 m/s^2}
bodies: {ball: {particle: {mass: 1 kg}}}
loads: {weight: {gravity: g}}
measures: {x: x of ball, y: y of ball}
start: {x: 0, y: 0, rate(x): v0*cos(theta), rate(y): v0*sin(theta)}
"""
BOX = """
parameters: {m: 20 kg, mu: 0.3, F: 120 N, alpha: 20 deg, g: 9.81 m/s^2}
bodies: {box: {particle: {mass: m}}}
loads: {push: {force: {at: box, along: right, magnitude: F*(cos(alpha) + mu*sin(alpha)) - mu*m*g}}}
measures: {x: x of box}
"""
ROD = """
parameters: {m: 2 kg, L: 1 m, b: 0.2 m, g: 9.81 m/s^2}
bodies: {rod: {rod: {mass: m, length: L}, points: {p: [b, 0]}}}
connections: {hinge: {pin: [rod.p, ground.O]}}
loads: {weight: {gravity: g}}
measures: {phi: {angle of rod from up}}
start: {phi: 0}
"""
ATWOOD = """
parameters: {m1: 3 kg, m2: 2 kg, g: 9.81 m/s^2}
bodies:
  pulley: {disk: {mass: 0, radius: 0.1 m}, fixed: true}
  left: {particle: {mass: m1}}
  right: {particle: {mass: m2}}
connections: {rope: {string: {from: left, over: [pulley], to: right}}}
loads: {weight: {gravity: g}}
measures: {x: drop of left}
"""
HOIST = """
parameters: {J1: 0.05 kg m^2, J2: 1.2 kg m^2, r: 0.08 m, n: 4, R: 0.2 m, m: 50 kg, T: 35 N m, g: 9.81 m/s^2}
ground: {points: {A: [0, 0], B: [r + n*r, 0]}}
bodies:
  pinion: {body: {inertia: J1, radius: r}}
  wheel: {body: {inertia: J2, radius: n*r}}
  load: {particle: {mass: m}}
connections:
  A: {pin: [ground.A, pinion]}
  B: {pin: [ground.B, wheel]}
  mesh: {gear_mesh: {first: pinion, second: wheel}}
  rope: {string: {path: [wound on wheel radius R at right, load]}}
loads: {weight: {gravity: g}, motor: {torque: {on: pinion, magnitude: -T}}}
measures: {z: height of load}
"""

CASES = {
    # a = R (n T - R m g)/(J1 n^2 + J2 + m R^2) of what hangs is one number: J1 T n^2 - 2 J1 R m g n = T (J2 + m R^2)
    "gear ratio": (
        HOIST,
        "value of n for which acceleration of load is largest",
        "R*m*g/T + sqrt((R*m*g/T)^2 + (J2 + m*R^2)/J1)",
    ),
    # x = v0^2 sin(2 theta)/g
    "range": (THROW, "value of theta for which x when y = 0 is largest", "pi/4"),
    "range, value": (THROW, "largest x when y = 0 over theta", "v0^2/g"),
    # F (cos + mu sin) - mu m g: tan = mu
    "pull": (BOX, "value of alpha for which acceleration of x is greatest", "atan(mu)"),
    "pull, value": (BOX, "greatest acceleration of x over alpha", "F*sqrt(1 + mu^2)/m - mu*g"),
    # T = 2 pi sqrt((L^2/12 + b^2)/(g b)): b = L/sqrt(12)
    "compound pendulum": (ROD, "value of b for which period of small oscillations is least", "L/sqrt(12)"),
}


@pytest.mark.parametrize("name", CASES)
def test_the_place_is_that_of_a_textbook(name: str) -> None:
    found = is_formula(*CASES[name])
    assert any("it rises up to" in note or "it falls up to" in note for note in found.notes)


def test_what_only_rises_has_no_largest_value_inside() -> None:
    assert "only rises" in posed(ATWOOD, "value of m1 for which acceleration of x is largest").reason
    assert "only falls" in posed(BOX, "least acceleration of x over mu").reason
    assert "does not depend" in posed(THROW, "value of beta for which x when y = 0 is largest").reason


def test_it_is_derived_in_both_languages() -> None:
    (derivation,) = fb.explain(System.from_text(THROW), CASES["range"][1]).derivations
    assert not derivation.reason
    assert derivation.stages[-2].title.key == "stage.extremal"
    words = fb.explain(System.from_text(BOX), CASES["pull, value"][1], language="de").to_text()
    assert "wechselt ihr Vorzeichen" in words


TWO_LUMPS = """
space: {up: z}
parameters: {m: 0.2 kg, r: 0.1 m, a: 0.2 m, b: 0.5 m, l: 0.8 m, W: 100 rad/s, d: 90 deg}
ground: {points: {A: [0, 0, 0]}}
bodies:
  shaft: {body: {}, points: {A: [0, 0, 0], B: [l, 0, 0], P: [a, r, 0], Q: [b, r*cos(d), r*sin(d)]}}
  one: {particle: {mass: m}}
  two: {particle: {mass: m}}
connections:
  A: {spherical: [ground.A, shaft.A]}
  B: {point_on_line: {point: shaft.B, through: ground.A, along: x}}
  p: {spherical: [shaft.P, one]}
  q: {spherical: [shaft.Q, two]}
  motor: {driver: {measure: phi, follows: W*t}}
measures: {phi: angle of shaft about x}
"""


def test_of_an_angle_that_only_turns_one_turn_is_meant() -> None:
    """B = m r W^2/l sqrt(a^2 + b^2 + 2 a b cos d) is least with the lumps on opposite sides, and again a turn later."""
    found = posed(TWO_LUMPS, "value of d for which size of reaction of B is least")
    assert found.expression is not None, found.reason
    assert found.value == pytest.approx(math.pi)


CHIMNEY = """
freebody: 1
parameters: {m: 2000 kg, L: 20 m, s: 5 m, g: 9.81 m/s^2}
ground: {points: {O: [0, 0]}}
bodies: {chimney: {rod: {mass: m, length: L}, points: {cut: [s - L/2, 0]}}}
connections: {foot: {pin: [ground.O, chimney.start]}}
loads: {weight: {gravity: g}}
measures: {theta: {angle of chimney from up clockwise}}
start: {theta: 1 deg, rate(theta): 0}
"""


def test_a_falling_chimney_breaks_at_a_third_of_its_height(agrees: Agree) -> None:
    """M = m g s (L - s)^2 sin(theta)/(4 L^2): dM/ds = 0 at s = L/3, and at s = L, behind which the section has left the
    chimney."""
    asked = [
        "s for which bending moment of chimney at cut is greatest",
        "greatest bending moment of chimney at cut over s",
    ]
    solution = fb.System.from_text(CHIMNEY).solve(asked)
    agrees(solution, "q1", "L/3")
    agrees(solution, "q2", "m*g*L*sin(theta)/27")
    assert any("sin(θ) > 0" in condition for condition in solution["q1"].conditions)
