"""Where nothing says how a model starts, formulas hold at every pose, and their values are those at one of them: which
one is told."""

from __future__ import annotations

import math
import re

import pytest

import freebody as fb

PENDULUM = """
parameters: {m: 1 kg, l: 0.8 m, g: 9.81 m/s^2}
bodies: {bob: {particle: {mass: m}}}
connections: {thread: {link: [ground, bob, l]}}
loads: {weight: {gravity: g}}
measures: {theta: {angle of line from ground to bob from down}}
"""


def test_the_value_is_that_at_the_place_that_is_told() -> None:
    """At rest the thread holds m g cos(theta)."""
    solution = fb.System.from_text(PENDULUM).solve("tension of thread")
    [told] = [text for text in map(str, solution.assumptions) if text.startswith("nothing says what theta is")]
    found = re.search(r"theta = (-?[\d.]+) deg$", told)
    assert found is not None
    assert solution.answers[0].value == pytest.approx(9.81 * math.cos(math.radians(float(found[1]))), rel=1e-3)


@pytest.mark.parametrize(
    ("start", "question"),
    [("start: {theta: 20 deg}", "tension of thread"), ("", "period of small oscillations"), ("", "degrees of freedom")],
)
def test_nothing_is_told_where_the_place_is_given_or_plays_no_part(start: str, question: str) -> None:
    solution = fb.System.from_text(PENDULUM + start).solve(question)
    assert not [text for text in map(str, solution.assumptions) if text.startswith("nothing says what")]
