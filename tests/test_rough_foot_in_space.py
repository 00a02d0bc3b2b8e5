"""What a rough foot carries in space, while nothing moves, has a formula where balance alone decides it."""

from __future__ import annotations

import math

import pytest

import freebody as fb

LADDER = """
space: {up: z}
parameters: {m: 10 kg, L: 2 m, beta: 60 deg, mu: 0.5, g: 9.81 m/s^2}
ground: {points: {O: [0, 0, 0]}, planes: {floor: {normal: up}, wall: {normal: x}}}
bodies:
  ladder: {rod: {mass: m, length: L}, at: {start: [L*cos(beta), 0, 0]}, turned: [180 deg - beta about -y]}
connections:
  foot: {contact: {between: [ladder.start, ground.floor], friction: mu}}
  top: {contact: {between: [ladder.end, ground.wall]}}
loads: {weight: {gravity: g}}
"""


@pytest.mark.parametrize(
    ("asked", "value"),
    [
        ("normal force of foot", 98.1),
        ("normal force of top", 98.1 / 2 / math.tan(math.pi / 3)),  # moments about the foot
        ("friction force x of foot", -98.1 / 2 / math.tan(math.pi / 3)),  # against the wall
    ],
)
def test_a_ladder_in_space_has_the_forces_of_the_ladder_in_the_plane(asked: str, value: float) -> None:
    system = fb.System.from_text(LADDER)
    (answer,) = system.solve(asked).answers
    assert answer.expression is not None
    assert answer.value == pytest.approx(value, rel=1e-9)
