"""Equations for a parameter that have no solution in closed form: the numbers, and that there are no others.

Every root is found a second time by bisection of a formula of the test's own, from the literature, over the range that
the answer names.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from typing import cast

import pytest
from scipy.optimize import brentq
from scipy.special import ellipk, ellipkinc

import freebody as fb
from freebody.study.answering.answer import Answer
from freebody.symbolic.decide.slopes import FUNCTIONS, two_terms

G = 9.81
PENDULUM = """
parameters: {m: 1 kg, L: 0.5 m, g: 9.81 m/s^2, theta_0: 60 deg, T: 1.5 s}
bodies: {bob: {particle: {mass: m}}}
connections: {rod: {link: [ground.O, bob, L]}}
loads: {weight: {gravity: g}}
measures: {th: {angle of line from ground.O to bob from down}}
start: {th: theta_0, rate(th): 0}
"""
PUSHED = PENDULUM.replace("theta_0: 60 deg", "v_0: 2 m/s").replace("th: theta_0, rate(th): 0", "th: 0, rate(th): v_0/L")
BRAKED = """
parameters: {m: 2 kg, c: 3 kg/s, v0: 5 m/s, T: 1 s, F: 10 N}
bodies: {b: {particle: {mass: m}}}
connections: {floor: {slot: {pin: b, along: right, through: ground.O}}}
loads: {air: {drag: {body: b, linear: c}}, push: {force: {at: b, along: right, magnitude: F}}}
measures: {x: x of b}
start: {x: 0, rate(x): v0}
"""
DAMPED = BRAKED.replace("F: 10 N", "k: 20 N/m").replace(
    "push: {force: {at: b, along: right, magnitude: F}}", "spring: {law: {measure: x, force: -k*x}}"
)


def asked(text: str, question: str) -> Answer:
    return fb.solve(fb.System.from_text(text), question).answers[0]


def said_range(answer: Answer) -> tuple[float, float]:
    found = re.search(r"between (\S+) and (\S+)", answer.reason)
    assert found is not None, answer.reason
    return float(found[1]), float(found[2].rstrip(","))


def roots(f: Callable[[float], float], low: float, high: float, n: int = 4001) -> list[float]:
    """Sign changes on a grid of equal ratios, each bisected."""
    low = max(low, high * 1e-6)
    places = [low * (high / low) ** (k / (n - 1)) for k in range(n)]
    values = [f(x) for x in places]
    pairs = zip(places, places[1:], values, values[1:], strict=False)
    return [cast("float", brentq(f, a, b, xtol=1e-14)) for a, b, fa, fb_ in pairs if fa * fb_ < 0]


def braked(c: float = 3.0, m: float = 2.0, T: float = 1.0) -> float:
    """x = F t/c + (v0 - F/c) m/c (1 - e^(-c t/m))"""
    return 10.0 * T / c + (5.0 - 10.0 / c) * m / c * (1.0 - math.exp(-c * T / m))


def damped(k: float, T: float = 1.0) -> float:
    """x = v0/w e^(-d t) sin(w t), d = c/(2 m), w^2 = k/m - d^2"""
    w = math.sqrt(k / 2.0 - 0.75**2)
    return 5.0 / w * math.exp(-0.75 * T) * math.sin(w * T)


def period(amplitude: float) -> float:
    return 4.0 * math.sqrt(0.5 / G) * ellipk(math.sin(amplitude / 2.0) ** 2)


def quarter_turn(v: float) -> float:
    """The time to theta = 90 deg: sin(phi) = sin(45 deg)/k with k = v/(2 sqrt(g L))"""
    k = v / (2.0 * math.sqrt(G * 0.5))
    return math.sqrt(0.5 / G) * ellipkinc(math.asin(math.sqrt(0.5) / k), k * k)


CASES: dict[str, tuple[str, str, Callable[[float], float]]] = {
    "amplitude for a period": (PENDULUM, "value of theta_0 for which period of th = T", lambda x: period(x) - 1.5),
    "large amplitude": (
        PENDULUM.replace("60 deg", "150 deg"),
        "value of theta_0 for which period of th = 2.5 s",
        lambda x: period(x) - 2.5,
    ),
    "amplitude for a time": (
        PENDULUM,
        "value of theta_0 for which time when th = 0 is 0.4 s",
        lambda x: period(x) / 4.0 - 0.4,
    ),
    "push for a period": (
        PUSHED,
        "value of v_0 for which period of th = T",
        lambda v: 4.0 * math.sqrt(0.5 / G) * ellipk(v * v / (4.0 * G * 0.5)) - 1.5,
    ),
    "push for a time": (
        PUSHED,
        "value of v_0 for which time when th = 90 deg is 0.3 s",
        lambda v: quarter_turn(v) - 0.3,
    ),
    "resistance": (BRAKED, "value of c for which x at t = T is 4 m", lambda c: braked(c=c) - 4.0),
    "mass": (BRAKED, "value of m for which x at t = T is 4 m", lambda m: braked(m=m) - 4.0),
    "time": (BRAKED, "value of T for which x at t = T is 4 m", lambda T: braked(T=T) - 4.0),
    "stiffness": (DAMPED, "value of k for which x at t = T is 0.1 m", lambda k: damped(k) - 0.1),
    "time of an oscillation": (DAMPED, "value of T for which x at t = T is 0.1 m", lambda T: damped(20.0, T) - 0.1),
}


@pytest.mark.parametrize("name", CASES)
def test_numbers_are_all_solutions_in_the_range_that_is_named(name: str) -> None:
    text, question, f = CASES[name]
    answer = asked(text, question)
    assert answer.expression is None
    assert answer.value is not None, answer.reason
    values = answer.value if isinstance(answer.value, tuple) else (answer.value,)
    low, high = said_range(answer)
    assert low < high
    assert list(values) == pytest.approx(roots(f, low, min(high, 5.0 * max(values))), rel=1e-9)
    assert ("exactly one" in answer.reason) == (len(values) == 1)


def test_the_derivation_ends_with_the_equation_and_how_many_solutions_it_has() -> None:
    system = fb.System.from_text(PENDULUM)
    text = fb.explain(system, "value of theta_0 for which period of th = T").to_text()
    for words in ("Legendre", "exactly one", "0.9343 rad"):
        assert words in text


def test_a_period_below_that_of_small_swings_has_no_amplitude() -> None:
    answer = asked(PENDULUM, "value of theta_0 for which period of th = 1.4 s")
    assert answer.value is None
    assert "it has no solution between" in answer.reason
    assert 2.0 * math.pi * math.sqrt(0.5 / G) > 1.4  # the least of all periods


def test_of_many_solutions_those_next_to_the_given_value_are_named_and_the_range_in_which_they_are_all() -> None:
    answer = asked(DAMPED, "value of k for which x at t = T is 0")
    assert isinstance(answer.value, tuple)
    # w t = n pi
    every = [2.0 * ((n * math.pi) ** 2 + 0.75**2) for n in range(1, 200)]
    _low, high = said_range(answer)
    assert list(answer.value) == pytest.approx([k for k in every if k < high])


@pytest.mark.parametrize("k", [0.2, 0.7, 0.97])
def test_slopes_of_elliptic_integrals_are_those_of_differences(k: float) -> None:
    h = 1e-6
    with two_terms():
        import flint

        series = flint.arb_series
        by_k = FUNCTIONS.elliptic_K(series([k, 1]))[1]
        of_angle = FUNCTIONS.elliptic_F(series([1, 1]), series([k]))[1]
        of_modulus = FUNCTIONS.elliptic_F(series([1]), series([k, 1]))[1]
    assert float(by_k.mid()) == pytest.approx((ellipk((k + h) ** 2) - ellipk((k - h) ** 2)) / (2 * h), rel=1e-6)
    assert float(of_angle.mid()) == pytest.approx(1.0 / math.sqrt(1.0 - (k * math.sin(1.0)) ** 2))
    differences = (ellipkinc(1.0, (k + h) ** 2) - ellipkinc(1.0, (k - h) ** 2)) / (2 * h)
    assert float(of_modulus.mid()) == pytest.approx(differences, rel=1e-6)
