"""Systems as textbooks ask for them, against answers derived by hand in the line beside them."""

from __future__ import annotations

import pytest

import freebody as fb
from conftest import Agree, assert_same_function
from freebody.language.notation import to_python

CART = """
parameters: {M: 2 kg, m: 1 kg, L: 1 m, th0: 60 deg, g: 9.81 m/s^2}
ground: {lines: {rail: {along: right}}}
bodies: {cart: {particle: {mass: M}}, bob: {particle: {mass: m}}}
connections: {guide: {slider: {body: cart, along: rail}}, rod: {link: [cart, bob, L]}}
loads: {weight: {gravity: g}}
measures: {x: x of cart, th: angle of line from cart to bob from down}
start: {x: 0, th: th0, rate(x): 0, rate(th): 0}
"""
FALLING_ROD = """
parameters: {m: 1 kg, L: 1 m, th0: 70 deg, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {rod: {rod: {mass: m, length: L}}}
connections: {foot: {slot: {pin: rod.start, along: floor}}}
loads: {weight: {gravity: g}}
measures: {th: angle of rod, x: x of rod}
start: {th: th0, x: L/3, rate(th): 0, rate(x): 0}
"""
COLLISION = """
parameters: {m1: 2 kg, m2: 3 kg, v0: 5 m/s, e: 0.6, r: 0.1 m, d: 1 m}
ground: {lines: {l: {along: right}}}
bodies: {a: {disk: {mass: m1, radius: r}, at: [0, 0]}, b: {disk: {mass: m2, radius: r}, at: [d, 0]}}
connections:
  ga: {slider: {body: a, along: l}}
  gb: {slider: {body: b, along: l}}
  hit: {contact: {between: [a, b], restitution: e}}
measures: {x1: x of a, x2: x of b}
start: {x1: 0, x2: d, rate(x1): v0, rate(x2): 0}
"""
STRUCK_ROD = """
parameters: {M: 2 kg, L: 1 m, m: 0.02 kg, v0: 300 m/s, h: 0.8 m}
bodies:
  rod: {rod: {mass: M, length: L}, angle: -90 deg}
  bullet: {particle: {mass: m}, at: [-0.1 m, -h], velocity: [v0, 0]}
connections: {hinge: {pin: [ground.O, rod.start]}}
measures: {th: angle of rod from down}
"""


def expression(model: str, question: str) -> str:
    (answer,) = fb.solve(fb.System.from_text(model), question).answers
    assert answer.expression is not None, answer.reason
    return to_python(answer.expression)


@pytest.mark.parametrize(
    ("model", "question", "expected"),
    [
        # M x + m (x + L sin th) stays: the mass centre does not move aside
        (CART, "x when th = 0", "m*L*sin(th0)/(M + m)"),
        (CART, "x of bob when th = 0", "m*L*sin(th0)/(M + m)"),
        # no force acts aside, so x stays; the foot is half a length from it
        (FALLING_ROD, "x of rod.start when th = 0", "L/3 - L/2"),
        # after the impact a goes on with v0 (m1 - e m2)/(m1 + m2) over the last 2 r
        (COLLISION, "time when x1 = d", "(d - 2*r)/v0 + 2*r*(m1 + m2)/(v0*(m1 - m2*e))"),
    ],
)
def test_what_textbooks_ask_for(model: str, question: str, expected: str) -> None:
    assert_same_function(expression(model, question), expected, {})


def test_a_velocity_that_is_given_is_no_assumption_where_another_is_left_open() -> None:
    assumptions = fb.solve(fb.System.from_text(STRUCK_ROD), "acceleration of th at start").assumptions
    assert not any("bullet" in text for text in assumptions)


def test_a_block_that_is_put_upon_another_slides_on_it_there(agrees: Agree) -> None:
    """Both are put at places: the guide between them is where these say, and turns neither of them."""
    solution = fb.System.from_text("""
parameters: {m1: 2 kg, m2: 5 kg, F: 40 N, mu: 0.4, g: 9.81 m/s^2}
bodies:
  upper: {rectangle: {mass: m1, width: 0.4 m, height: 0.2 m}, at: [0, 0.5 m]}
  lower: {rectangle: {mass: m2, width: 1 m, height: 0.4 m}, at: [0, 0.2 m]}
connections:
  floor: {slider: {body: lower, along: right}}
  between: {slider: {body: upper, on: lower, along: right, friction: mu}}
loads:
  weight: {gravity: g}
  pull: {force: {at: lower, along: right, magnitude: F}}
questions: [acceleration of upper, acceleration of lower, normal force of between]
""").solve()
    agrees(solution, "q1", ["mu*g", "0"])
    agrees(solution, "q2", ["(F - mu*m1*g)/m2", "0"])
    agrees(solution, "q3", "m1*g")
    start = solution.system.simulate(0.01).dataset.isel(time=0)
    assert start.body_angle.values == pytest.approx([0.0, 0.0], abs=1e-15)
    assert start.body_position.sel(axis="y").values == pytest.approx([0.5, 0.2])


MOLECULE = """
parameters: {m1: 1 kg, m2: 2 kg, k: 300 N/m, l: 1 m}
bodies: {a: {particle: {mass: m1}, at: [0, 0]}, b: {particle: {mass: m2}, at: [l, 0]}}
connections: {ra: {slider: {body: a, along: right}}, rb: {slider: {body: b, along: right}}}
loads: {s: {spring: {first: a, second: b, stiffness: k, length: l}}}
"""
ROD_WITH_WHEEL = """
parameters: {M: 3 kg, m: 2 kg, L: 1.2 m, R: 0.2 m, g: 9.81 m/s^2}
bodies: {rod: {rod: {mass: M, length: L}}, disk: {disk: {mass: m, radius: R}}}
connections: {hinge: {pin: [ground.O, rod.start]}, axle: {pin: [rod.end, disk.center]}}
loads: {weight: {gravity: g}}
measures: {phi: {angle of rod from right clockwise}}
start: {phi: 0}
"""


@pytest.mark.parametrize(
    ("model", "frequency"),
    [
        (MOLECULE, "sqrt(k*(m1 + m2)/(m1*m2))"),
        # the wheel does not turn: I = M L^2/3 + m L^2 about the hinge, and M g L/2 + m g L drives back
        (ROD_WITH_WHEEL, "sqrt((M/2 + m)*g/((M/3 + m)*L))"),
    ],
)
def test_what_swings_has_its_period_beside_what_nothing_drives_back(model: str, frequency: str, agrees: Agree) -> None:
    questions = "questions: [period of small oscillations, natural frequency, natural frequencies]"
    solution = fb.System.from_text(model + questions).solve()
    agrees(solution, "q1", f"2*pi/{frequency}")
    agrees(solution, "q2", frequency)
    agrees(solution, "q3", ["0", frequency])
    assert solution.system.explain().is_complete


def test_what_nothing_drives_back_does_not_oscillate() -> None:
    free = MOLECULE.replace("loads: {s: {spring: {first: a, second: b, stiffness: k, length: l}}}", "")
    (answer,) = fb.solve(fb.System.from_text(free), "period of small oscillations").answers
    assert answer.expression is None
    assert "nothing drives it back" in (answer.reason or "")
