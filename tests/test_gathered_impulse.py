"""Impulses on the way to an event, and averages over the time up to it."""

from __future__ import annotations

import pytest

from posed import is_derived, is_formula, posed

DRAGGED = """
parameters: {m: 2 kg, F: 10 N, L: 3 m, T: 2 s, mu: 0.2, g: 9.81 m/s^2}
bodies: {b: {particle: {mass: m}, at: [0, 0]}}
connections: {floor: {slider: {body: b, along: right, friction: mu}}}
loads: {weight: {gravity: g}, pull: {force: {at: b, along: right, magnitude: F}}}
measures: {x: x of b}
start: {x: 0, rate(x): 0}
"""
HOISTED = """
parameters: {m: 2 kg, T: 2 s, a: 3 m/s^2, g: 9.81 m/s^2}
bodies: {b: {particle: {mass: m}, at: [0, 0]}}
connections: {rail: {slider: {body: b, along: up}}, motor: {driver: {measure: y of b, follows: a*t^2/2}}}
loads: {weight: {gravity: g}}
measures: {y: y of b}
"""
SHAKEN = """
parameters: {m: 2 kg, F0: 10 N, T: 2 s, w: 3 rad/s, g: 9.81 m/s^2}
bodies: {b: {particle: {mass: m}, at: [0, 0]}}
connections: {rail: {slider: {body: b, along: right}}}
loads: {pull: {force: {at: b, along: right, magnitude: F0*sin(w*t)}}, weight: {gravity: g}}
measures: {x: x of b}
start: {x: 0, rate(x): 0}
"""
SPRUNG = """
parameters: {m: 2 kg, k: 50 N/m, A: 1 m}
ground: {points: {W: [-3 m, 0]}}
bodies: {b: {particle: {mass: m}, at: [-A, 0]}}
connections: {rail: {slider: {body: b, along: right}}}
loads: {spring: {spring: {between: [ground.W, b], stiffness: k, length: 3 m}}}
measures: {x: x of b}
start: {x: -A, rate(x): 0}
"""
SWINGING = """
parameters: {m: 2 kg, L: 1 m, g: 9.81 m/s^2}
bodies: {bob: {particle: {mass: m}}}
connections: {rod: {link: [ground.O, bob, L]}}
loads: {weight: {gravity: g}}
measures: {theta: {angle of line from ground.O to bob from down}}
start: {theta: 60 deg}
"""


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        # Hibbeler, Dynamics, ch. 15: the impulses of pull and friction together are m v, with v^2 = 2 (F/m - mu g) L
        (DRAGGED, "impulse of pull until x = L", "m*sqrt(2*(F/m-mu*g)*L) + mu*m*g*sqrt(2*L/(F/m-mu*g))"),
        (DRAGGED, "impulse of floor along left until x = L", "F*sqrt(2*L/(F/m-mu*g)) - m*sqrt(2*(F/m-mu*g)*L)"),
        (DRAGGED, "average force of pull until x = L", "F"),
        # ch. 14: the mean power is F times half the final speed
        (DRAGGED, "average power of pull until x = L", "F*sqrt(2*(F/m-mu*g)*L)/2"),
        (DRAGGED, "average velocity of b along right until x = L", "sqrt(2*(F/m-mu*g)*L)/2"),
        (DRAGGED, "average acceleration of x until t = T", "F/m - mu*g"),
        (HOISTED, "average power of motor from start to t = T", "m*(g+a)*a*T/2"),
        (HOISTED, "impulse of motor along up until t = T", "m*a*T + m*g*T"),
        (SHAKEN, "impulse of pull until t = T", "F0*(1-cos(w*T))/w"),
        (SHAKEN, "average force of pull until t = T", "F0*(1-cos(w*T))/(w*T)"),
        (SHAKEN, "impulse of rail along up until t = T", "m*g*T"),
    ],
)
def test_what_a_force_gives_over_the_time_has_the_formula_by_hand(model: str, question: str, formula: str) -> None:
    is_formula(model, question, formula)


def test_the_impulse_of_a_pull_in_the_time_is_derived() -> None:
    told = is_derived(SHAKEN, "impulse of pull until t = T")
    assert "The integral of the force over the time" in told["en"]
    assert "Das Integral der Kraft über die Zeit" in told["de"]


def test_the_impulse_of_a_spring_is_the_momentum_that_it_gives() -> None:
    # it is compressed, so what it pulls with is negative: -m v with m v^2 = k A^2
    is_formula(SPRUNG, "impulse of spring until x = 0", "-A*sqrt(k*m)")


def test_the_impulse_of_a_reaction_that_changes_with_the_place_is_not_its_last_value_by_the_time() -> None:
    found = posed(SWINGING, "impulse of rod along up until theta = 0")
    assert found.expression is None
    assert "changes on the way" in str(found.reason)
