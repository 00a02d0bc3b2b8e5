"""Mistakes in a file: one cause is told once, with what to write instead, in the names of the file."""

from __future__ import annotations

from pathlib import Path

import pytest

import freebody as fb

EXAMPLES = Path(__file__).parents[1] / "examples"

# an example, what is written wrongly in it, and all that is said of it
MISTAKES = [
    ("planetary_gear", "P1: {body: {mass", "P1: {body: {mas", "body has no mas. Did you mean mass?"),
    ("sphere_launched_down_incline", "sphere: {mass", "sphere: {mas", "sphere has no mas. Did you mean mass?"),
    (
        "planetary_gear",
        "r_S: 0.1 m",
        "r_S: -0.1 m",
        "r_S = -0.1 m is not positive; parameters are positive unless the model says otherwise: r_S: {value: -0.1 m, "
        "sign: any}",
    ),
    (
        "block_tips_or_slides",
        "ground.floor",
        "ground.flor",
        "ground has no point flor. Did you mean the line ground.floor? Else declare it: ground: {points: {flor: [x, "
        "y]}}",
    ),
    (
        "atwood_machine",
        "pin: [ground.axle,",
        "pin: [ground.axl,",
        "the points axle, axl of the ground have no position. Are axle and axl the same point? Declare them: ground: "
        "{points: {axle: [x, y], axl: [x, y]}}, or, with positions left open, list all of them: ground: {points: "
        "[axle, axl]}",
    ),
    ("cardan_joint", "alpha: 30 deg", "alpha 30 deg", "a colon is missing after alpha: alpha: 30 deg"),
    (
        "cart_and_pendulum",
        "{body: cart, along: right}",
        "{body: cart, along: right, friction: rod}",
        "rod is a body; here stands a number, or a formula in parameters",
    ),
    (
        "isolated_machine",
        "Omega: 100 rad/s",
        "Omega: 300 U/min",
        "the unit 'U' is not known: write rev for revolutions, or rpm for those in a minute",
    ),
]


@pytest.mark.parametrize(("name", "right", "wrong", "told"), MISTAKES)
def test_one_mistake_is_told_once(name: str, right: str, wrong: str, told: str) -> None:
    text = (EXAMPLES / f"{name}.yaml").read_text("utf-8")
    assert right in text
    with pytest.raises(fb.ModelError) as caught:
        fb.System.from_text(text.replace(right, wrong, 1))
    assert [str(problem.message) for problem in caught.value.problems] == [told]


def test_a_question_about_a_body_that_cannot_be_read_is_no_second_mistake() -> None:
    text = """
bodies: {ball: {disk: {mass: 1 s}}, rod: {rod: {lenght: 1 m}}}
connections: {p: {pin: [rod.strat, ground.O, ball]}}
questions: {how: acceleration of rod.edge}
"""
    with pytest.raises(fb.ModelError) as caught:
        fb.System.from_text(text)
    assert "questions" not in {problem.path[0] for problem in caught.value.problems}
