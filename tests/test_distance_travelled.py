"""The distance travelled is the length of the way, and no change of place.

Thrown up with v: v^2/(2 g) to the top, behind it the way is longer than the change of place. A ball that slides with
v until it rolls: 12 v^2/(49 mu g). Problem families: Meriam & Kraige, Dynamics, 2/2 (net displacement and distance);
Hibbeler, Dynamics, 12.2; Beer & Johnston, Dynamics, 11.1 and 16.2.
"""

from __future__ import annotations

import pytest

from posed import is_formula, posed

THROW = """
parameters: {v: 12 m/s, g: 9.81 m/s^2, h: 3 m}
bodies: {ball: {particle: {mass: 1 kg}}}
loads: {weight: {gravity: g}}
measures: {x: x of ball, y: y of ball}
start: {x: 0, y: 0, rate(x): 0, rate(y): v}
"""
BALL = """
parameters: {m: 1 kg, mu: 0.3, v: 4 m/s, g: 9.81 m/s^2, r: 0.1 m}
ground: {lines: {floor: {along: right}}}
bodies: {ball: {sphere: {mass: m, radius: r}}}
connections: {touch: {contact: {between: [ball, floor], friction: mu}}}
loads: {weight: {gravity: g}}
measures: {x: {travel of ball along floor}}
start: {x: 0, rate(x): v}
"""


@pytest.mark.parametrize(
    ("text", "question", "formula"),
    [
        (THROW, "distance travelled along y until rate(y) = 0", "v^2/(2*g)"),
        (THROW.replace("rate(y): v", "rate(y): -v"), "distance travelled along y until y = -h", "h"),
        (BALL, "distance travelled along x until rolling begins", "12*v^2/(49*mu*g)"),
    ],
)
def test_one_way(text: str, question: str, formula: str) -> None:
    is_formula(text, question, formula)


@pytest.mark.parametrize(
    "question", ["distance travelled along y until y = -h", "distance travelled along y after 2 s"]
)
def test_where_it_turns_back_the_change_of_place_is_no_answer(question: str) -> None:
    found = posed(THROW, question)
    assert found.expression is None
    assert "turns back" in found.reason
    is_formula(THROW, "change of y until y = -h", "-h")
