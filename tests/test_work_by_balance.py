"""The work of the one load without a potential is what T + V gains; each derived by hand here."""

from __future__ import annotations

import pytest

from posed import is_derived, is_formula, posed

PULLED = """
parameters: {m: 5 kg, F0: 40 N, T: 2 s, v1: 4 m/s, s1: 2 m}
bodies: {block: {particle: {mass: m}}}
connections: {guide: {slider: {body: block, along: right, through: ground.O}}}
loads: {pull: {force: {at: block, along: right, magnitude: F0*t/T}}}
measures: {x: x of block}
start: {x: 0, rate(x): 0}
"""
DAMPED = """
parameters: {m: 4 kg, k: 900 N/m, c: 24 N s/m, x0: 0.05 m}
bodies: {block: {particle: {mass: m}}}
connections: {guide: {slider: {body: block, along: right, through: ground.O}}}
loads: {spring: {law: {measure: x, force: -k*x}}, damper: {law: {measure: x, force: -c*rate(x)}}}
measures: {x: x of block}
start: {x: x0, rate(x): 0}
"""
MOTOR = """
parameters: {J: 0.4 kg m^2, M0: 12 N m, c: 0.3 N m s, w1: 30 rad/s}
bodies: {rotor: {body: {mass: 5 kg, inertia: J}}}
connections: {bearing: {pin: [ground.O, rotor.center]}}
loads: {drive: {law: {measure: phi, force: M0 - c*rate(phi)}}}
measures: {phi: angle of rotor}
start: {phi: 0, rate(phi): 0}
"""
WAVE = "sqrt(k/m - (c/(2*m))^2)"


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        (PULLED, "work of pull until rate(x) = v1", "m*v1^2/2"),
        # x = F0 t^3/(6 m T), x' = F0 t^2/(2 m T)
        (PULLED, "time until x = s1", "(6*m*T*s1/F0)^(1/3)"),
        (PULLED, "work of pull until x = s1", "m/2*(F0/(2*m*T))^2*(6*m*T*s1/F0)^(4/3)"),
        (MOTOR, "work of drive until rate(phi) = w1", "J*w1^2/2"),
        # the amplitude falls as exp(-c t/(2 m)): after half a period, and where it passes the middle
        (DAMPED, "energy lost in damper until rate(x) = 0", f"k*x0^2/2*(1 - exp(-c/m*pi/{WAVE}))"),
        (
            DAMPED,
            "work of damper until x = 0",
            f"k*x0^2/2*(exp(-c/m*(pi - acos(c/(2*sqrt(m*k))))/{WAVE}) - 1)",
        ),
    ],
)
def test_work_of_what_has_no_potential(model: str, question: str, formula: str) -> None:
    is_formula(model, question, formula)


def test_it_is_derived_by_the_balance_of_energy() -> None:
    told = is_derived(DAMPED, "energy lost in damper until rate(x) = 0")
    assert "the loss of mechanical energy" in " ".join(told["en"].split())
    assert "die Abnahme der mechanischen Energie" in " ".join(told["de"].split())
    assert "the gain in mechanical energy" in " ".join(is_derived(PULLED, "work of pull until x = s1")["en"].split())


def test_of_two_loads_without_potential_it_is_a_number() -> None:
    both = DAMPED.replace("loads: {", "loads: {push: {force: {at: block, along: right, magnitude: 3 N/s*t}}, ")
    answer = posed(both, "work of damper until rate(x) = 0")
    assert answer.expression is None
    assert answer.value is not None
