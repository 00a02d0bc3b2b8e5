"""A load whose size is open is asked for by its symbol, and equations in it are solved for what else stands there."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import freebody as fb
from freebody.language.notation import to_text
from posed import is_formula

TOGGLE = Path(__file__).parent / "spoken_models" / "toggle.yaml"

RAM = """
parameters:
  {L: 4 m, a: 1.2 m, b: 0.9 m, c: 0.4 m, m: 350 kg, phi0: 35 deg, v: 0.1 m/s,
   l_0: "sqrt((a*cos(phi0) - c)^2 + (a*sin(phi0) + b)^2)"}
ground: {points: {A: [0, 0], B: [c, -b]}}
bodies:
  boom: {rod: {length: L, mass: m}, at: {start: [0, 0]}, angle: phi0, points: {E: [a - L/2, 0]}}
connections:
  A: {pin: [ground.A, boom.start]}
  ram: {driver: {measure: l, follows: l_0 + v*t}}
measures:
  l: {distance from ground.B to boom.E}
  phi: {angle of boom}
"""


def _asked(question: str) -> fb.Answer:
    return fb.System.load(TOGGLE).solve(question).answers[0]


def test_force_of_the_press_is_what_balances_the_push_on_its_knee() -> None:
    found = _asked("Which force Q does the press exert?")
    assert found.value == pytest.approx(250 / (2 * math.tan(math.radians(12))))


def test_angle_at_which_the_press_exerts_five_times_the_push() -> None:
    """2 Q tan(beta) = F: half of the push is carried by each link."""
    assert is_formula(TOGGLE.read_text(), "For which beta is Q = 5*F?", "atan(1/10)")


def test_angle_at_which_a_link_carries_a_force_has_a_number_though_a_load_is_open() -> None:
    found = _asked("value of beta for which axial force of lower = -800 N")
    assert found.value == pytest.approx(math.asin(250 / 1600))


def test_speed_through_a_loop_is_short() -> None:
    """The end of a boom goes L/a times as fast as the pivot of its ram, whose part along the ram is v."""
    found = fb.System.from_text(RAM).solve("speed of boom.end").answers[0]
    x, y = 1.2 * math.cos(math.radians(35)) - 0.4, 1.2 * math.sin(math.radians(35)) + 0.9
    across = math.sin(math.atan2(y, x) - math.radians(35))
    assert found.value == pytest.approx(4 * 0.1 / (1.2 * across))
    assert to_text(found.expression) == "L·v/(a·|sin(φ_ram - φ)|)"


PLIERS = """
parameters: {a: 0.25 m, b: 0.04 m, F: 120 N, N: N}
bodies:
  upper: {rod: {length: a + b}, at: {start: [-a, 0]}, angle: 0, points: {P: [(a - b)/2, 0]}}
  lower: {rod: {length: a + b}, at: {start: [-a, 0]}, angle: 0, points: {P: [(a - b)/2, 0]}}
connections: {P: {pin: [upper.P, lower.P]}}
loads:
  hand: {force: {at: upper.start, along: down, magnitude: F}}
  thumb: {force: {at: lower.start, along: up, magnitude: F}}
  above: {force: {at: upper.end, along: down, magnitude: N}}
  below: {force: {at: lower.end, along: up, magnitude: N}}
"""


@pytest.mark.parametrize(
    ("question", "formula"),
    [
        ("Which force N acts on the pipe?", "a*F/b"),
        ("ratio of N to F", "a/b"),
        ("size of reaction of P", "F*(a + b)/b"),
        ("vertical reaction of P in equilibrium", "-F*(a + b)/b"),
    ],
)
def test_pliers_that_float_are_levers(question: str, formula: str) -> None:
    """Moments about the pin: N b = F a; the pin bears both forces of a half."""
    assert is_formula(PLIERS, question, formula, numbers={"N": 750.0})
