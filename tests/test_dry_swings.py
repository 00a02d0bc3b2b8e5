"""Swings against dry friction, half by half.

With the friction R = mu m g against the motion a mass on a spring swings about -+ R/k, so that every half swing, of
duration pi sqrt(m/k), takes 2 R/k off the amplitude: x_n = (-1)^n (x0 - 2 n R/k). It stays where k |x_n| <= R. Source:
Den Hartog, Mechanical Vibrations, 4th ed. 1956, sec. 8.4.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

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
    "number of half swings until b comes to rest": "3",
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


# c p0/T = 15: it stays where |p_n| = p0 - 2 n T/c is T/c at most, after the seventh half swing
WHEEL = """
parameters: {J: 0.2 kg m^2, c: 5 N m/rad, T: 0.1 N m, p0: 0.29 rad}
bodies: {wheel: {body: {inertia: J}, points: {O: [0, 0]}}}
connections: {h: {pin: [ground.O, wheel.O]}, brake: {brake: {between: [wheel, ground], torque: T}}}
loads: {twist: {law: {measure: theta, force: -c*theta}}}
measures: {theta: angle of wheel}
start: {theta: p0, rate(theta): 0}
"""
PENDULUM = """
parameters: {m: 1 kg, L: 1 m, T: 0.4 N m, p0: 50 deg, g: 9.81 m/s^2}
bodies: {rod: {rod: {mass: m, length: L}}}
connections: {h: {pin: [ground.O, rod.start]}, brake: {brake: {between: [rod, ground], torque: T}}}
loads: {weight: {gravity: g}}
measures: {theta: angle of rod from down}
start: {theta: p0, rate(theta): 0}
"""


def test_many_half_swings_have_formulas_at_the_models_own_values() -> None:
    hand = {
        "number of half swings until it comes to rest for good": "7",
        "theta when it comes to rest for good": "-(p0 - 14*T/c)",
        "time when it comes to rest for good": "7*pi*sqrt(J/c)",
        # the work T on the way 2 (p0 - (2 n - 1) T/c) of every half swing
        "energy lost until it comes to rest for good": "T*2*(7*p0 - 49*T/c)",
    }
    questions = "".join(f"  - {question!r}\n" for question in hand)
    found = fb.System.from_text(f"{WHEEL}questions:\n{questions}").solve().answers
    values = {"J": 0.21, "c": 5.1, "T": 0.11, "p0": 0.3}
    for answer, formula in zip(found, hand.values(), strict=True):
        assert answer.evidence is not None
        assert isinstance(answer.expression, Expr)
        here, by_hand = (evaluate(e, values, FLOAT_FUNCTIONS) for e in (answer.expression, parse(formula)))
        assert here == pytest.approx(by_hand, rel=1e-12)


def test_more_half_swings_than_are_followed_are_counted_in_numbers() -> None:
    # the amplitude falls by 2 s, s = mu m g/k, until it is s at most
    s = 0.2 * 2 * 9.81 / 200
    n = math.ceil((1.5 / s - 1) / 2)
    far = fb.System.from_text(BLOCK.replace("x0: 0.12 m", "x0: 1.5 m"))
    number, x, length = far.solve(
        [
            "number of half swings until it comes to rest for good",
            "x when it comes to rest for good",
            "length of the path of b until it comes to rest for good",
        ]
    ).answers
    assert number.value == n == 38
    assert x.value == pytest.approx((-1) ** n * (1.5 - 2 * n * s), rel=1e-6)
    assert length.value == pytest.approx(2 * n * (1.5 - n * s), rel=1e-6)


def test_a_pendulum_with_a_rubbing_journal_swings_as_often_as_its_equation_says() -> None:
    count, at, time = _swings(math.radians(50), 0.4, 1.0, 1.0)
    number, theta, t = (
        fb.System.from_text(PENDULUM)
        .solve(
            [
                "number of half swings until it comes to rest for good",
                "theta when it comes to rest for good",
                "time when it comes to rest for good",
            ]
        )
        .answers
    )
    assert number.value == count
    assert theta.value == pytest.approx(at, abs=1e-8)
    assert t.value == pytest.approx(time, rel=1e-8)


def _swings(p: float, T: float, m: float, L: float) -> tuple[int, float, float]:
    """m L^2/3 p'' = -m g L/2 sin p -+ T, from turn to turn, until T holds."""
    n, t = 0, 0.0
    while 9.81 * m * L / 2 * abs(math.sin(p)) > T:
        side = math.copysign(1.0, p)  # it falls towards the middle, and T is against that

        def slope(_t: float, y: np.ndarray, side: float = side) -> list[float]:
            return [y[1], 3 / (m * L * L) * (-9.81 * m * L / 2 * math.sin(y[0]) + side * T)]

        def turns(_t: float, y: np.ndarray, side: float = side) -> float:
            return side * y[1] + 1e-13

        turns.direction, turns.terminal = 1, True  # type: ignore[attr-defined]
        found = solve_ivp(slope, (0, 20), [p, 0.0], "DOP853", events=turns, rtol=1e-12, atol=1e-13)
        p, t, n = float(found.y_events[0][0][0]), t + float(found.t_events[0][0]), n + 1
    return n, p, t
