"""Boxes of unlike heights on one floor, face to face: which corners strike depends on which box is the taller one."""

from __future__ import annotations

import pytest

import freebody as fb

BOXES = """
parameters: {m1: 2 kg, m2: 3 kg, e: 0.5, v: 4 m/s, h: LEFT, H: RIGHT, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies:
  A: {rectangle: {mass: m1, width: 0.4 m, height: h}, at: [0, h/2], velocity: [v, 0]}
  B: {rectangle: {mass: m2, width: 0.4 m, height: H}, at: [1 m, H/2]}
connections:
  fA: {contact: {between: [A, floor]}}
  fB: {contact: {between: [B, floor]}}
  hit: {contact: {between: [A, B], restitution: e}}
loads: {weight: {gravity: g}}
"""


def after(h: float, H: float) -> tuple[float, float]:
    """The speeds of B across and upwards, by hand.

    Newton's law holds at both ends of the faces, so that the boxes turn alike, by q anticlockwise. Each then lifts off
    the floor but for one corner at a/2 beside its middle, which adds m (a/2)^2 to its inertia about its middle, and
    rises with a |q|/2. With the push P at a height s
        m (u - v) = -P    M w = P    J_A q = P (s - h/2)    J_B q = P (H/2 - s)    w - u + q (H - h)/2 = e v."""
    m, M, v, e, a = 2.0, 3.0, 4.0, 0.5, 0.4
    turned = [mass * ((a * a + high * high) / 12 + a * a / 4) for mass, high in ((m, h), (M, H))]
    J = sum(turned)
    push = (1 + e) * v / (1 / m + 1 / M + (H - h) ** 2 / (4 * J))
    q = push * (H - h) / (2 * J)
    assert 0.0 < h / 2 + turned[0] * q / push < min(h, H)  # the push acts where both faces are
    return push / M, a * abs(q) / 2


@pytest.mark.parametrize(("h", "H"), [(0.3, 0.5), (0.5, 0.3)])
def test_boxes_of_unlike_heights(h: float, H: float) -> None:
    system = fb.System.from_text(BOXES.replace("LEFT", f"{h} m").replace("RIGHT", f"{H} m"))
    answer = system.solve("velocity of B after the impact")["q1"]
    assert answer.expression is not None
    assert answer.value == pytest.approx(after(h, H), rel=1e-9)
    assert any(("H > h" if h < H else "h ≥ H") in condition for condition in answer.conditions)
