"""An answer is the same, whatever else is asked, and in whatever order: its value, its conditions, its cases."""

from __future__ import annotations

import pytest

import freebody as fb
from examples_told import FOLDER

SPOOL = """
parameters: {m: 3 kg, J: 0.02 kg m^2, R: 0.2 m, r: 0.1 m, F: 10 N, beta: 40 deg, mu: 0.4, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {spool: {disk: {mass: m, radius: R, inertia: J}, at: [0, R]}}
connections: {roll: {contact: {between: [spool, floor], friction: mu}}}
loads:
  weight: {gravity: g}
  pull: {force: {at: spool, along: beta, magnitude: F}}
  moment: {torque: {on: spool, magnitude: F*r}}
"""


def told(answer: fb.Answer) -> str:
    """All but the evidence, which draws what it compares beside the other questions."""
    return str(answer).split("    evidence")[0]


def test_what_one_question_takes_to_be_positive_is_no_condition_of_another() -> None:
    """The acceleration is the size of F R (R cos(beta) - r)/(m R^2 + J): its sign is taken, as it is at the start. What
    holds the spool is F (J cos(beta) + m R r)/(m R^2 + J) to the left, whatever that sign is."""
    force, turned = "friction force of roll", "value of beta for which acceleration of spool = 0"
    system = fb.System.from_text(SPOOL)
    alone, (_turned, behind) = system.solve(force).answers[0], system.solve([turned, force]).answers
    assert "R·cos(β) > r" not in told(alone)
    assert told(behind) == told(alone)


@pytest.mark.parametrize(
    "name",
    ["bead_on_a_parabola", "block_pushed_on_incline", "cart_into_a_buffer", "coin_on_a_turntable", "sliding_ladder"],
)
def test_the_order_of_questions_changes_no_answer(name: str) -> None:
    system = fb.System.load(FOLDER / f"{name}.yaml")
    asked = [question.text for question in system.questions]
    here, there = system.solve(asked).answers, fb.System.load(system.file).solve(asked[::-1]).answers
    assert [told(a) for a in here] == [told(a) for a in reversed(there)]
