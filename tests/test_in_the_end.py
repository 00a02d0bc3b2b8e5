"""What is tended to as the time grows in a phase that nothing ends, behind or beside other phases."""

from __future__ import annotations

import math

import pytest

import freebody as fb

SLOPE = """
parameters: {{m: 4 kg, alpha: 30 deg, mu: 0.2, c: 3 kg/s, k: 0.5 kg/m, v_0: 2 m/s, g: 9.81 m/s^2}}
ground: {{lines: {{slope: {{along: -alpha}}}}}}
bodies: {{block: {{particle: {{mass: m}}, at: [0, 0]}}}}
connections: {{contact: {{contact: {{between: [block, slope], friction: mu}}}}}}
loads: {{weight: {{gravity: g}}, air: {{drag: {{body: block, {drag}}}}}}}
measures: {{s: travel of block along slope}}
start: {{s: 0, rate(s): {rate}}}
"""
PULL = 4.0 * 9.81 * (math.sin(math.radians(30)) - 0.2 * math.cos(math.radians(30)))  # down the slope, less friction


def ask(asked: str, drag: str, rate: str = "0") -> fb.Answer:
    return fb.System.from_text(SLOPE.format(drag=drag, rate=rate)).solve(asked)["q1"]


@pytest.mark.parametrize(("drag", "speed"), [("linear: c", PULL / 3.0), ("quadratic: k", math.sqrt(PULL / 0.5))])
def test_the_air_balances_the_pull_down_the_slope_in_the_end(drag: str, speed: float) -> None:
    answer = ask("terminal velocity of s", drag)
    assert answer.value == pytest.approx(speed, rel=1e-12)
    assert len(answer.cases) == 2  # with more friction it rests
    assert all("just before" not in str(note) for note in answer.notes)


def test_what_slides_up_at_first_comes_down_in_the_end() -> None:
    assert ask("terminal velocity of s", "linear: c", "-v_0").value == pytest.approx(PULL / 3.0, rel=1e-12)


def test_a_place_that_goes_on_growing_tends_to_nothing() -> None:
    assert ask("s as t grows", "linear: c").value is None
