"""A drive of constant power against forces and drags: m u' = P/u - F(u), with its end F(u) u = P, and by separation

    x = int m u^2 du/(P - u F),        t = int m u du/(P - u F).

Source: Meriam & Kraige, Dynamics, sec. 3/6; Hibbeler, Dynamics, sec. 14.4.
"""

from __future__ import annotations

import pytest

from posed import is_derived, is_formula, posed

CAR = """
parameters: {m: 1100 kg, P: 40 kW, F: 800 N, b: 20 kg/s, c: 0.6 kg/m, v1: 20 m/s, v0: 5 m/s}
ground: {lines: {road: {along: right}}}
bodies: {car: {particle: {mass: m}}}
connections: {road: {slider: {body: car, along: road}}}
loads: {engine: {force: {at: car, along: right, magnitude: P/rate(x) - RESISTANCE}}}
measures: {x: x of car}
start: {x: 0, rate(x): v0}
"""


@pytest.mark.parametrize(
    ("resistance", "end"),
    [
        ("F", "P/F"),
        ("b*rate(x)", "sqrt(P/b)"),
        ("F - b*rate(x)", "(sqrt(F^2 + 4*P*b) - F)/(2*b)"),
        ("c*rate(x)^2", "exp(log(P/c)/3)"),
    ],
)
def test_a_constant_power_leads_to_the_speed_at_which_the_resistance_takes_it(resistance: str, end: str) -> None:
    is_formula(CAR.replace("RESISTANCE", resistance), "terminal velocity of x", end)


def test_which_power_keeps_a_speed_against_the_air() -> None:
    text = CAR.replace("RESISTANCE", "c*rate(x)^2")
    is_formula(text, "value of P for which terminal velocity of x = v1", "c*v1^3")


def test_the_way_and_the_time_against_the_air_are_integrals_over_the_speed() -> None:
    text = CAR.replace("RESISTANCE", "c*rate(x)^2")
    is_formula(text, "x when rate(x) = v1", "m/(3*c)*log((P - c*v0^3)/(P - c*v1^3))")
    k, root = "exp(log(P/c)/3)", "sqrt(3)"
    ends = [
        f"(log({v}^2 + {k}*{v} + {k}^2)/6 - log({k} - {v})/3 - atan((2*{v} + {k})/({root}*{k}))/{root})/{k}"
        for v in ("v1", "v0")
    ]
    is_formula(text, "time when rate(x) = v1", f"m/c*({ends[0]} - {ends[1]})")


def test_only_speeds_below_the_end_are_reached() -> None:
    found = posed(CAR.replace("RESISTANCE", "c*rate(x)^2"), "range of v1 for which rate(x) reaches v1")
    assert found.value == pytest.approx((5.0, (40e3 / 0.6) ** (1 / 3)))


@pytest.mark.parametrize("question", ["terminal velocity of x", "x when rate(x) = v1"])
def test_its_answers_are_derived(question: str) -> None:
    is_derived(CAR.replace("RESISTANCE", "c*rate(x)^2"), question)
