"""The ram of a crank shaper that a slot of its lever leads: its place follows linearly from the closed loop.

The crank of radius a turns about a point at the distance d above the foot of the lever; the lever reverses where it is
tangent to the circle, at the angle asin(a/d) to either side. So the crank goes through pi + 2 asin(a/d) one way and
pi - 2 asin(a/d) back, and the ram at the height h strokes 2 h tan(asin(a/d)). Source: Norton, Design of Machinery,
sec. 3.4.
"""

from __future__ import annotations

import pytest

from posed import is_formula

SHAPER = """
parameters: {a: 0.1 m, d: 0.3 m, L: 0.5 m, h: 0.5 m}
ground: {points: {O: [0, d], B: [0, 0], G: [0, h]}}
bodies:
  crank: {rod: {mass: 0, length: a}}
  lever: {rod: {mass: 1 kg, length: L}}
  ram: {particle: {mass: 2 kg}, at: [0, h]}
connections:
  O: {pin: [ground.O, crank.start]}
  B: {pin: [ground.B, lever.start]}
  s: {slot: {pin: crank.end, on: lever, along: lever.x}}
  g: {slider: {body: ram, along: right, through: ground.G}}
  l: {slot: {pin: ram, on: lever, along: lever.x}}
measures: {phi: angle of crank, psi: angle of lever from up, x: x of ram}
start: {phi: 90 deg}
"""


@pytest.mark.parametrize(
    ("question", "formula"),
    [
        ("time ratio of x", "(pi + 2*asin(a/d))/(pi - 2*asin(a/d))"),
        ("stroke of x", "2*h*a/sqrt(d^2 - a^2)"),
        ("ratio of rate of x to rate of phi at start", "-h*a/(d+a)"),
    ],
)
def test_a_ram_in_the_slot_of_its_lever_has_the_quick_return_of_the_dead_points(question: str, formula: str) -> None:
    is_formula(SHAPER, question, formula)
