"""A number of hertz counts cycles: omega = 2 pi f."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import freebody as fb

EXAMPLES = Path(__file__).parents[1] / "examples"


@pytest.mark.parametrize(
    "question",
    ["value of k for which natural frequency = 2 Hz", "What stiffness is needed so that the frequency is 2 Hz?"],
)
def test_a_natural_frequency_in_hertz_is_that_of_cycles(question: str) -> None:
    """k = m (2 pi f)^2 with m = 2 kg."""
    [answer] = fb.solve(fb.System.load(EXAMPLES / "mass_on_spring.yaml"), question=question).answers
    assert answer.value == pytest.approx(2.0 * (2.0 * math.pi * 2.0) ** 2)


def test_an_angular_velocity_in_hertz_is_one_of_turns() -> None:
    """J w' = T_0 (1 - w/w_0) - T_L: w = w_s (1 - exp(-T_0 t/(J w_0))), w_s = w_0 (T_0 - T_L)/T_0."""
    system = fb.System.load(EXAMPLES / "motor_runs_up.yaml")
    [answer] = fb.solve(system, question="time when rate(phi) = 2 Hz").answers
    steady = 40.0 * (30.0 - 10.0) / 30.0
    assert answer.value == pytest.approx(-0.2 * 40.0 / 30.0 * math.log(1.0 - 4.0 * math.pi / steady))


def test_hertz_in_an_expression_stand_for_what_is_written() -> None:
    [answer] = fb.solve(
        fb.System.load(EXAMPLES / "mass_on_spring.yaml"),
        question="value of k for which natural frequency = 2*pi*(2 Hz)",
    ).answers
    assert answer.value == pytest.approx(2.0 * (2.0 * math.pi * 2.0) ** 2)
