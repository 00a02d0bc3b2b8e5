"""Swings against dry friction, half by half.

With the friction R = mu m g against the motion a mass on a spring swings about -+ R/k, so that every half swing, of
duration pi sqrt(m/k), takes 2 R/k off the amplitude: x_n = (-1)^n (x0 - 2 n R/k). It stays where k |x_n| <= R. Source:
Den Hartog, Mechanical Vibrations, 4th ed. 1956, sec. 8.4.
"""

from __future__ import annotations

import pytest

import freebody as fb
from freebody.language.expression import FLOAT_FUNCTIONS, Expr, evaluate
from freebody.language.parser import parse

BLOCK = """
parameters: {m: 2 kg, k: 200 N/m, mu: 0.2, x0: 0.12 m, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right, through: [0, 0]}}}
bodies: {b: {particle: {mass: m}}}
connections: {c: {contact: {between: [b, ground.floor], friction: mu}}}
loads: {weight: {gravity: g}, s: {law: {measure: x, force: -k*x}}}
measures: {x: x of b}
start: {x: x0, rate(x): 0}
"""


HAND = {
    "x after one half swing": "-(x0 - 2*mu*m*g/k)",
    "x after 2 half swings": "x0 - 4*mu*m*g/k",
    "x when b comes to rest for the third time": "-(x0 - 6*mu*m*g/k)",
    "time after 3 half swings": "3*pi*sqrt(m/k)",
    "number of half swings until it comes to rest for good": "3",
    "x when it comes to rest for good": "-(x0 - 6*mu*m*g/k)",
    # 2 a_1 + 2 a_2 + 2 a_3 of the arcs about the shifted middle, a_n = x0 - (2 n - 1) R/k
    "length of the path of b until b comes to rest for good": "2*(3*x0 - 9*mu*m*g/k)",
    "energy lost until b comes to rest for good": "mu*m*g*2*(3*x0 - 9*mu*m*g/k)",
}
VALUES = {"m": 2.1, "k": 203.0, "mu": 0.19, "x0": 0.118, "g": 9.81}


def test_each_half_swing_loses_twice_the_shift_of_the_middle() -> None:
    questions = "".join(f"  - {question!r}\n" for question in HAND)
    found = fb.System.from_text(f"{BLOCK}questions:\n{questions}").solve().answers
    for answer, formula in zip(found, HAND.values(), strict=True):
        assert answer.evidence is not None
        assert isinstance(answer.expression, Expr)
        here, by_hand = (evaluate(e, VALUES, FLOAT_FUNCTIONS) for e in (answer.expression, parse(formula)))
        assert here == pytest.approx(by_hand, rel=1e-12)
    number = found[4]
    # the n-th half swing is the last one where a < x0/(2 n - 1) and a >= x0/(2 n + 1), a = mu m g/k
    told: list[tuple[float, int]] = []
    for case in number.cases:
        assert isinstance(case.expression, Expr)
        told.append((float(evaluate(case.expression, {}, FLOAT_FUNCTIONS)), len(case.conditions)))
    assert sorted(told) == [(n, 2) for n in (1, 2, 3, 4)]


def test_more_half_swings_than_are_counted_are_refused() -> None:
    with pytest.raises(fb.ModelError, match="half swings are counted from 1 to 5"):
        fb.System.from_text(BLOCK).solve("x after 12 half swings")
