"""An angle that does not come, while the motion passes the same direction in another turn: 390 deg for 30 deg."""

from __future__ import annotations

import math

import pytest

import freebody as fb

G, L = 9.81, 0.5
PENDULUM = """
parameters: {{m: 1 kg, l: 0.5 m, g: 9.81 m/s^2}}
bodies: {{rod: {{rod: {{mass: m, length: l}}}}}}
connections: {{h: {{pin: [ground.O, rod.start]}}}}
loads: {{weight: {{gravity: g}}}}
measures: {{theta: angle of rod from down}}
start: {{theta: 0, rate(theta): {rate} rad/s}}
"""
DISK = """
bodies: {{disk: {{disk: {{mass: 1 kg, radius: 0.1 m}}}}}}
connections: {{h: {{pin: [ground.O, disk.center]}}{brake}}}
measures: {{theta: angle of disk}}
start: {{rate(theta): {rate} rad/s}}
"""


def asked(text: str, question: str) -> fb.Answer:
    return fb.System.from_text(text).solve(question).answers[0]


def speed(rate: float, degrees: float) -> float:
    """Of a uniform rod from hanging down: theta'^2 = rate^2 - 3 g (1 - cos theta)/l."""
    return math.copysign(math.sqrt(rate**2 - 3 * G * (1 - math.cos(math.radians(degrees))) / L), rate)


@pytest.mark.parametrize(("degrees", "passed"), [(380, 20), (-340, 20), (-700, 20)])
def test_a_swinging_rod_passes_the_direction_in_the_turn_of_its_start(degrees: int, passed: int) -> None:
    answer = asked(PENDULUM.format(rate=3), f"velocity of theta when theta = {degrees} deg")
    assert answer.value is None
    assert f"the same direction is passed at theta = {passed} deg" in answer.reason
    assert not answer.never
    there = asked(PENDULUM.format(rate=3), f"velocity of theta when theta = {passed} deg")
    assert there.value == pytest.approx(speed(3, passed))


@pytest.mark.parametrize(("rate", "degrees", "passed"), [(20, -20, 340), (-20, 20, -340), (-20, 380, -340)])
def test_a_rod_that_goes_round_passes_it_in_its_own_sense(rate: int, degrees: int, passed: int) -> None:
    answer = asked(PENDULUM.format(rate=rate), f"velocity of theta when theta = {degrees} deg")
    assert answer.value is None
    assert any(f"passed at theta = {passed} deg" in text for text in (answer.reason, *answer.notes))
    there = asked(PENDULUM.format(rate=rate), f"velocity of theta when theta = {passed} deg")
    assert there.value == pytest.approx(speed(rate, passed))


def test_what_is_passed_in_no_turn_stays_refused() -> None:
    # a rod with 3 rad/s turns at 1 - cos = l w^2/(3 g), before 45 deg
    answer = asked(PENDULUM.format(rate=3), "velocity of theta when theta = 90 deg")
    assert answer.value is None
    assert "passed at" not in answer.reason


@pytest.mark.parametrize(("rate", "degrees", "passed"), [(2, -20, 340), (-2, 20, -340)])
def test_a_free_disk_passes_every_direction(rate: int, degrees: int, passed: int) -> None:
    answer = asked(DISK.format(rate=rate, brake=""), f"time when theta = {degrees} deg")
    assert f"passed at theta = {passed} deg" in answer.reason
    there = asked(DISK.format(rate=rate, brake=""), f"time when theta = {passed} deg")
    assert there.value == pytest.approx(math.radians(passed) / rate)
