"""How much a frame, a truss or a beam may be loaded: what stays so where nothing can move.

A step ladder of two legs L at an angle alpha, the right one on rollers, with a tie at the height h along the legs and a
person F at the distance a up the left leg: B = F a/(2 L), and moments on the right leg about the apex give
T (L - h) sin(alpha) = B L cos(alpha). Problem family: Meriam, Kraige & Bolton, Statics, sec. 4/6.
"""

from __future__ import annotations

import math

import pytest

from posed import is_derived, is_formula, posed

LADDER = """
parameters: {F: 900 N, L: 3 m, h: 1 m, alpha: 70 deg, a: 2 m}
ground: {points: {O: [0, 0], E: [2*L*cos(alpha), 0]}}
bodies:
  left: {rod: {length: L}, at: {start: [0, 0]}, angle: alpha, points: {T: [h - L/2, 0], S: [a - L/2, 0]}}
  right: {rod: {length: L}, at: {start: [2*L*cos(alpha), 0]}, angle: 180 deg - alpha, points: {T: [h - L/2, 0]}}
connections:
  A: {pin: [ground.O, left.start]}
  B: {slot: {pin: right.start, through: ground.E, along: right}}
  apex: {pin: [left.end, right.end]}
  tie: {link: [left.T, right.T]}
loads: {person: {force: {at: left.S, along: down, magnitude: F}}}
"""


@pytest.mark.parametrize(
    ("question", "formula"),
    [
        ("greatest tension of tie", "F*a*cos(alpha)/(2*(L - h)*sin(alpha))"),
        ("largest F so that tension of tie stays below 200 N", "400*(L - h)*sin(alpha)/(a*cos(alpha))"),
    ],
)
def test_what_nothing_moves_has_one_value(question: str, formula: str) -> None:
    assert is_formula(LADDER, question, formula)


def test_size_of_a_reaction_stays_below_a_limit() -> None:
    """The apex bears T and B on the right leg."""
    found = posed(LADDER, "largest F so that size of reaction of apex stays below 1 kN")
    of_one = math.hypot(1 / 3, 2 * math.cos(math.radians(70)) / (4 * math.sin(math.radians(70))))
    assert found.value == pytest.approx(1000 / of_one, rel=1e-9)


def test_the_limit_of_a_frame_is_derived() -> None:
    assert is_derived(LADDER, "largest F so that tension of tie stays below 200 N")
