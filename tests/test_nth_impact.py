"""The n-th impact of what bounces, with a symbol for n: geometric series."""

from __future__ import annotations

import pytest

from freebody.errors import ModelError
from posed import is_formula, posed

DROPPED = """
parameters: {m: 0.2 kg, h: 1.5 m, e: 0.7, n: 3, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {ball: {particle: {mass: m}, at: [0, h]}}
connections: {hit: {contact: {between: [ball, ground.floor], restitution: e}}}
loads: {weight: {gravity: g}}
measures: {y: y of ball}
"""
ROLLED_OFF = """
parameters: {m: 0.2 kg, h: 1 m, u: 2 m/s, e: 0.7, n: 3, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {ball: {particle: {mass: m}, at: [0, h], velocity: [u, 0]}}
connections: {hit: {contact: {between: [ball, ground.floor], restitution: e}}}
loads: {weight: {gravity: g}}
measures: {x: x of ball}
"""


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        # Meriam & Kraige, Dynamics, ch. 3: v_n = e^n sqrt(2 g h), flights of 2 e^k sqrt(2 h/g)
        (DROPPED, "speed of ball after n impacts", "e^n*sqrt(2*g*h)"),
        (DROPPED, "greatest y after the n-th impact", "h*e^(2*n)"),
        (DROPPED, "time of the n-th impact", "sqrt(2*h/g)*(1 + 2*e*(1-e^(n-1))/(1-e))"),
        (DROPPED, "energy lost in the n-th impact", "m*g*h*(e^(2*n-2) - e^(2*n))"),
        (ROLLED_OFF, "x at the n-th impact", "u*sqrt(2*h/g)*(1 + 2*e*(1-e^(n-1))/(1-e))"),
        (ROLLED_OFF, "speed of ball after the n-th impact", "sqrt(u^2 + 2*g*h*e^(2*n))"),
    ],
)
def test_the_nth_impact_has_the_sum_of_the_series(model: str, question: str, formula: str) -> None:
    found = is_formula(model, question, formula, factors=(1.0, 0.9))
    assert any("n counts the impacts" in str(note) for note in found.notes)


def test_the_formula_in_n_is_that_of_the_third_impact_for_three() -> None:
    general, third = (posed(ROLLED_OFF, f"x at the {which} impact").value for which in ("n-th", "third"))
    assert isinstance(general, float)
    assert isinstance(third, float)
    assert abs(general - third) < 1e-9


def test_a_ball_against_the_air_has_no_series() -> None:
    air = DROPPED.replace("{m: 0.2 kg,", "{m: 0.2 kg, c: 0.1 kg/s,").replace(
        "weight: {gravity: g}", "weight: {gravity: g}, drag: {law: {measure: y, force: -c*rate(y)}}"
    )
    assert posed(air, "speed of ball after n impacts").expression is None


@pytest.mark.parametrize("question", ["greatest y after the tenth impact", "greatest y after 10 impacts"])
def test_the_tenth_impact_is_counted(question: str) -> None:
    is_formula(DROPPED, question, "h*e^20", factors=(1.0, 0.9))


def test_a_count_that_is_no_number_is_refused() -> None:
    with pytest.raises(ModelError, match="k is no number of impacts"):
        posed(DROPPED, "greatest y after k impacts")
