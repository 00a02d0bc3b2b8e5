"""A block slides up a rough incline and comes back to where it started, as an event and as a condition."""

from __future__ import annotations

import math

import pytest

import freebody as fb

MODEL = """
parameters: {m: 4 kg, alpha: 30 deg, mu: 0.2, v_0: 5 m/s, v_1: 3 m/s, g: 9.81 m/s^2}
ground: {lines: {slope: {along: alpha}}}
bodies: {block: {particle: {mass: m}, at: [0, 0]}}
connections: {contact: {contact: {between: [block, slope], friction: mu}}}
loads: {weight: {gravity: g}}
measures: {s: travel of block along slope}
start: {s: 0, rate(s): v_0}
"""
# up with g (sin + mu cos), down with g (sin - mu cos), the same way: v^2/v_0^2 is the ratio of the two
UP, DOWN = (math.sin(math.radians(30)) + k * 0.2 * math.cos(math.radians(30)) for k in (1, -1))
BACK = math.sqrt(DOWN / UP)


@pytest.mark.parametrize(
    ("asked", "value"),
    [
        ("speed of block when it is back at its start", 5.0 * BACK),
        ("time when s = 0", 5.0 / 9.81 / UP + 5.0 * BACK / 9.81 / DOWN),
        ("does the block come back?", DOWN),  # by how much it slips where it turns back
        ("Kommt der Klotz zurück?", DOWN),
        ("range of mu for which the block comes back to its start", math.tan(math.radians(30))),
        ("Für welche mu kommt der Klotz zum Start zurück?", math.tan(math.radians(30))),
        ("least v_0 so that speed of block when it is back at its start >= v_1", 3.0 / BACK),
        ("How large must v_0 be so that the block returns with the speed v_1?", 3.0 / BACK),
    ],
)
def test_a_block_comes_back_with_less_speed(asked: str, value: float) -> None:
    assert fb.System.from_text(MODEL).solve(asked)["q1"].value == pytest.approx(value, rel=1e-9)
