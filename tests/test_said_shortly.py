"""Questions that leave out, or add, a few words: whose value it is, what gets somewhere, what an average is taken over.

A sled that slides with v0 over rough ice comes to x = L with v0^2 - 2 mu g L, and to rest with the average speed v0/2.
Two carts that a spring d longer than its own length joins: the first is fastest with d sqrt(k m2/(m1 (m1 + m2))).
Problem families: Hibbeler, Dynamics, 14.2 and 14.4; Meriam & Kraige, Dynamics, 2/2 and 3/9.
"""

from __future__ import annotations

import pytest

from freebody.api import System
from freebody.errors import ModelError
from posed import is_derived, is_formula

SLED = """
parameters: {m: 60 kg, v0: 8 m/s, mu: 0.25, L: 6 m, g: 9.81 m/s^2}
ground: {lines: {ice: {along: right}}}
bodies: {sled: {particle: {mass: m}}}
connections: {c: {contact: {between: [sled, ice], friction: mu}}}
loads: {weight: {gravity: g}}
measures: {x: x of sled}
start: {x: 0, rate(x): v0}
"""
WHEEL = """
parameters: {J: 0.8 kg m^2, w0: 120 rad/s, T: 6 N m}
bodies: {wheel: {body: {mass: 10 kg, inertia: J}}}
connections: {axle: {pin: [ground.O, wheel]}}
loads: {brake: {torque: {on: wheel, magnitude: -T}}}
measures: {phi: angle of wheel}
start: {phi: 0, rate(phi): w0}
"""
CARTS = """
parameters: {m1: 1 kg, m2: 2 kg, k: 90 N/m, d: 0.05 m}
bodies:
  A: {particle: {mass: m1}, at: [0, 0], velocity: [0, 0]}
  B: {particle: {mass: m2}, at: [0.5 m + d, 0], velocity: [0, 0]}
connections: {ga: {slider: {body: A, along: right}}, gb: {slider: {body: B, along: right}}}
loads: {s: {spring: {first: A, second: B, stiffness: k, length: 0.5 m}}}
measures: {xA: x of A, xB: x of B}
"""
STONE = """
parameters: {m: 1 kg, v0: 25 m/s, a: 55 deg, b: 20 deg, g: 9.81 m/s^2}
bodies: {stone: {particle: {mass: m}, at: [0, 0], velocity: [v0*cos(a), v0*sin(a)]}}
loads: {weight: {gravity: g}}
measures: {x: x of stone, y: y of stone}
"""
CASES = {
    "what gets somewhere": (SLED, "least v0 so that sled reaches x = L", "sqrt(2*mu*g*L)"),
    "without the value of": (SLED, "mu so that the sled just reaches x = L", "v0^2/(2*g*L)"),
    "a parameter for which": (WHEEL, "T for which phi when rate(phi) = 0 is 100*pi", "J*w0^2/(200*pi)"),
    "an average speed": (SLED, "average speed of x until it stops", "v0/2"),
    "an average velocity": (SLED, "average velocity of x until rate(x) = v0/2", "3*v0/4"),
    "an average power": (WHEEL, "average power of brake until rate(phi) = 0", "-T*w0/2"),
    "a rate": (WHEEL, "rate(phi) after 3 s", "w0 - 3*T/J"),
    "the speed of what swings": (CARTS, "greatest speed of A", "d*sqrt(k*m2/(m1*(m1 + m2)))"),
    "and its least one": (CARTS, "least speed of A", "0"),
    "where a path meets a slope": (STONE, "x when y = x*tan(b)", "2*v0^2*cos(a)*sin(a - b)/(g*cos(b))"),
    "and when": (STONE, "time when y = x*tan(b)", "2*v0*sin(a - b)/(g*cos(b))"),
}


@pytest.mark.parametrize("name", CASES)
def test_what_is_said_shortly_is_that_of_a_textbook(name: str) -> None:
    model, question, formula = CASES[name]
    is_formula(model, question, formula, factors=(1.0, 1.01, 0.99))


def test_another_body_does_not_reach_a_place_of_this_one() -> None:
    with pytest.raises(ModelError):
        System.from_text(CARTS + "questions: [least d so that B reaches xA = 0]\n")


def test_an_average_is_derived() -> None:
    is_derived(WHEEL, "average power of brake until rate(phi) = 0")
