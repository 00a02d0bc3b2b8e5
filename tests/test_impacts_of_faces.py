"""Faces that meet: contacts share their impulse in more than one way, and speeds, sums of impulses and the energy that
is lost are determined all the same. By hand: momentum and Newton's law of restitution of two bodies that go along one
line. Source: Hibbeler, Dynamics, sec. 15.4.
"""

from __future__ import annotations

import pytest

from posed import is_derived, is_formula

ON_A_FLOOR = """
parameters: {m1: 2 kg, m2: 3 kg, b: 0.4 m, h: 0.3 m, e: 0.5, v: 4 m/s, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies:
  A: {box: {mass: m1, width: b, height: h}, at: [-1 m, h/2], velocity: [v, 0]}
  B: {box: {mass: m2, width: b, height: h}, at: [0, h/2]}
connections:
  fa: {contact: {between: [A, floor]}}
  fb: {contact: {between: [B, floor]}}
  hit: {contact: {between: [A, B], restitution: e}}
loads: {weight: {gravity: g}}
"""
ON_A_RAIL = (
    ON_A_FLOOR.replace("height: h}, at: [0, h/2]", "height: 2*h}, at: [0, h]")
    .replace("fb: {contact: {between: [B, floor]}}", "rail: {slider: {body: B, along: right}}")
    .replace("b: 0.4 m, ", "")
    .replace("width: b", "width: 0.4 m")
)
AFTER = "m1*v*(1 + e)/(m1 + m2)"


@pytest.mark.parametrize(
    ("text", "question", "expected"),
    [
        (ON_A_FLOOR, "velocity of B along right just after the impact", AFTER),
        (ON_A_FLOOR, "impulse of hit on B along right", f"m2*{AFTER}"),
        (ON_A_RAIL, "impulse of hit on B along right", f"m2*{AFTER}"),
        (ON_A_RAIL, "energy lost in the impact", "(1 - e^2)*m1*m2*v^2/(2*(m1 + m2))"),
    ],
)
def test_what_faces_share_is_determined_together(text: str, question: str, expected: str) -> None:
    is_formula(text, question, expected)


def test_the_impulse_of_a_whole_face_is_told_as_one() -> None:
    told = is_derived(ON_A_FLOOR, "velocity of B just after the impact")
    assert "normal impulse of hit\n" in told["en"]
