"""Loads that swing as the square of a sine: A cos^2(w t) = A/2 + A/2 cos(2 w t) rests at its mean and swings at 2 w."""

from __future__ import annotations

import pytest

from freebody.api import System
from posed import is_formula

CART = """
parameters: {m: 2 kg, k: 200 N/m, A: 2 N, w: 3 rad/s}
bodies: {a: {particle: {mass: m}}}
connections: {guide: {slider: {body: a, along: right}}}
measures: {x: x of a}
loads:
  spring: {law: {measure: x, force: -k*x}}
  push: {force: {at: a, along: right, magnitude: WAVE}}
start: {x: 0}
"""
BOB = """
parameters: {m: 2 kg, L: 1 m, A: 8 N, w: 3 rad/s, g: 9.81 m/s^2}
bodies: {bob: {particle: {mass: m}}}
connections: {rod: {link: [ground.O, bob, L]}}
measures: {th: angle of line from ground.O to bob from down}
start: {th: 0}
loads:
  weight: {gravity: g}
  wind: {force: {at: bob, along: right, magnitude: A*sin(w*t)^2}}
"""


@pytest.mark.parametrize(
    ("wave", "rest"), [("A*cos(w*t)^2", "A/(2*k)"), ("A*sin(w*t)^2", "A/(2*k)"), ("A*sin(w*t)*cos(w*t)", "0")]
)
def test_it_swings_about_its_mean_at_twice_the_frequency(wave: str, rest: str) -> None:
    text = CART.replace("WAVE", wave)
    is_formula(text, "equilibrium of x", rest)
    is_formula(text, "steady amplitude of x", "A/(2*|k - 4*m*w^2|)")


def test_a_pendulum_in_gusts_swings_about_a_slanting_line() -> None:
    """The mean force A/2 stands beside m g: it swings in the field sqrt(g^2 + (A/(2 m))^2)."""
    is_formula(BOB, "natural frequency", "sqrt(sqrt(g^2 + (A/(2*m))^2)/L)")


def test_what_holds_it_in_equilibrium_is_that_of_the_mean() -> None:
    text = CART.replace("WAVE", "A*cos(w*t)^2")
    is_formula(text, "force in spring in equilibrium", "-A/2")
    is_formula(text, "potential energy in equilibrium", "A^2/(8*k)")


def test_an_equilibrium_exists_where_the_mean_can_be_held() -> None:
    """A bar under a torque T cos^2(w t) hangs at sin(phi) = (T/2)/(m g L/2)."""
    bar = """
parameters: {m: 2 kg, L: 1 m, T: 5 N m, g: 9.81 m/s^2, w: 2 rad/s}
bodies: {bar: {rod: {mass: m, length: L}}}
connections: {hinge: {pin: [ground.O, bar.start]}}
loads: {weight: {gravity: g}, motor: {torque: {on: bar, magnitude: T*cos(w*t)^2}}}
measures: {phi: {angle of bar from down}}
start: {phi: 0, rate(phi): 0}
"""
    is_formula(bar, "equilibrium of phi", "asin(T/(m*g*L))")
    is_formula(bar, "range of T for which an equilibrium exists", "m*g*L")


@pytest.mark.parametrize(("law", "n"), [("A + A*cos(w*t) + A*cos(2*w*t)", 1), ("A*cos(w*t)", 0), ("A*cos(w*t)^2", 0)])
def test_loads_of_several_waves_are_said_to_be_those_at_the_start(law: str, n: int) -> None:
    cart = f"""
parameters: {{m: 1 kg, k: 20 N/m, A: 4 N, w: 3 1/s}}
bodies: {{b: {{particle: {{mass: m}}}}}}
connections: {{g: {{slider: {{body: b, along: right}}}}}}
measures: {{x: x of b}}
loads: {{s: {{law: {{measure: x, force: -k*x}}}}, p: {{force: {{at: b, along: right, magnitude: {law}}}}}}}
"""
    (answer,) = System.from_text(cart).solve("equilibrium of x").answers
    assert sum("as they are at t = 0" in note for note in answer.notes) == n
