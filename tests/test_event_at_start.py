"""An event that is there at the start and does not come again: what is asked has its value at the start.

A drive counts its angle on, so phi = 0 is passed once. Formulas by hand from x = r cos phi + sqrt(l^2 - r^2 sin^2 phi)
for the slider-crank, x = r cos phi for the yoke, and from free fall.
"""

from __future__ import annotations

import math

import pytest

import freebody as fb
from freebody.language.expression import FLOAT_FUNCTIONS, Expr, evaluate
from freebody.language.parser import parse
from freebody.study.answering.answer import Answer

CRANK = """
parameters: {r: 0.1 m, l: 0.35 m, w: 20 rad/s, v1: 1 m/s}
ground: {points: {O: [0, 0]}}
bodies:
  crank: {rod: {length: r}}
  con: {rod: {length: l}, near: {at: [0.3 m, 0], angle: 0}}
  piston: {particle: {mass: 1 kg}, near: {at: [0.45 m, 0]}}
connections:
  O: {pin: [ground.O, crank.start]}
  A: {pin: [crank.end, con.start]}
  B: {pin: [con.end, piston]}
  bore: {slot: {pin: piston, along: right, through: ground.O}}
  drive: {driver: {measure: phi, follows: w*t}}
measures: {phi: angle of crank, x: x of piston}
"""
DROPPED = """
parameters: {m: 1 kg, h: 2 m, g: 9.81 m/s^2, v0: 3 m/s}
bodies: {ball: {particle: {mass: m}}}
loads: {weight: {gravity: g}}
measures: {y: y of ball, x: x of ball}
start: {y: h, rate(y): 0, x: 0, rate(x): v0}
"""
PROBLEMS = {
    "acceleration at the outer dead point": (CRANK, "acceleration of x when phi = 0", "-r*w^2*(1 + r/l)"),
    "angular velocity of the rod": (CRANK, "angular velocity of con when phi = 0", "-r*w/l"),
    "place": (CRANK, "x when phi = 0", "r + l"),
    "turned round": (CRANK, "value of w for which angular velocity of con when phi = 0 is -v1/l", "v1/r"),
    "thrown from here": (DROPPED, "velocity of x when x = 0", "v0"),
    "at its highest": (DROPPED, "acceleration of y when y = h", "-g"),
    "at rest": (DROPPED, "kinetic energy when y = h", "m*v0^2/2"),
}


def asked(text: str, question: str) -> Answer:
    return fb.System.from_text(text).solve(question).answers[0]


@pytest.mark.parametrize("name", PROBLEMS)
def test_what_is_asked_of_it_is_so_at_the_start(name: str) -> None:
    text, question, formula = PROBLEMS[name]
    answer = asked(text, question)
    assert isinstance(answer.expression, Expr), answer.reason
    own = {p.name: p.value or 0.0 for p in fb.System.from_text(text).parameters.values()}
    for share in (1.0, 1.1):
        values = {key: x * share**k for k, (key, x) in enumerate(sorted(own.items()))}
        numbers = [float(evaluate(e, values, FLOAT_FUNCTIONS)) for e in (answer.expression, parse(formula))]
        assert math.isclose(*numbers, rel_tol=1e-9), (answer.expression, values)
    assert any("never again" in note for note in answer.notes) or "turned" in name


def test_the_time_at_which_it_comes_is_still_none() -> None:
    answer = asked(DROPPED, "time when x = 0")
    assert answer.never
    assert answer.value is None


def test_the_derivation_is_that_of_the_start() -> None:
    told = fb.explain(fb.System.from_text(CRANK), "acceleration of x when phi = 0").to_text()
    assert "holds at the start, and never again" in told
    assert "defect" not in told
