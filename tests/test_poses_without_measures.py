"""Questions about poses that no measure of the file tells: formulas by hand."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import freebody as fb

MODELS = Path(__file__).parent / "spoken_models"
M, LENGTH, G, TILT = 5.0, 2.0, 9.81, math.radians(80)
SPIN = math.sqrt(3 * G * math.sin(TILT) / LENGTH)  # m g L sin(80 deg)/2 = (m L^2/3) w^2/2: lying, only the foot slides


@pytest.mark.parametrize(
    ("question", "value"),
    [
        ("angular velocity of the rod when it is horizontal", -SPIN),
        ("speed of the upper end when it hits the floor", SPIN * LENGTH),
        ("vertical reaction of foot on the rod when it is horizontal", M * G / 4),
    ],
)
def test_a_rod_lies_on_a_smooth_floor(question: str, value: float) -> None:
    (answer,) = fb.System.load(MODELS / "rod_on_a_smooth_floor.yaml").solve(question).answers
    assert answer.expression is not None
    assert answer.value == pytest.approx(value, rel=1e-9)


@pytest.mark.parametrize("rope", ["link: {first: ground.hook, second: load}", "string: {from: ground.hook, to: load}"])
def test_a_load_swings_out(rope: str) -> None:
    """Energy: v^2/2 = g L (1 - cos phi)."""
    text = (MODELS / "load_on_a_rope.yaml").read_text()
    link = "link: [ground.hook, load], length: L"
    assert link in text
    system = fb.System.from_text(text.replace(link, rope.replace("load}", "load, length: L}")))
    (answer,) = system.solve("greatest angle of the rope with the vertical").answers
    assert answer.expression is not None
    assert answer.value == pytest.approx(math.acos(1 - 2**2 / (2 * 9.81 * 5)), rel=1e-9)


def test_what_else_moves_changes_nothing_of_a_swing() -> None:
    text = (MODELS / "load_on_a_rope.yaml").read_text()
    system = fb.System.from_text(
        text.replace("bodies: {", "bodies: {stranger: {particle: {mass: 1 kg}, at: [50 m, 0]}, ")
    )
    (answer,) = system.solve("greatest angle of the rope with the vertical").answers
    assert answer.value == pytest.approx(math.acos(1 - 2**2 / (2 * 9.81 * 5)), rel=1e-9)
