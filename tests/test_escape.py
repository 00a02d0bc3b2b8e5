"""What never turns back: escape from a centre, a pendulum that turns over; each derived by hand here."""

from __future__ import annotations

import pytest

from posed import is_derived, is_formula

ORBIT = """
parameters: {m: 5 kg, mu: 4 m^3/s^2, r0: 0.7 m, v0: 2.8 m/s}
bodies: {probe: {particle: {mass: m}}}
ground: {points: {O: [0, 0]}}
loads: {gravity: {law: {measure: r, force: -m*mu/r^2}}}
measures: {r: distance from ground.O to probe, phi: angle of line from ground.O to probe}
start: {r: r0, phi: 0, rate(r): 0, rate(phi): v0/r0}
"""
EARTH = ORBIT.replace("4 m^3/s^2", "4e14 m^3/s^2").replace("0.7 m,", "7e6 m,").replace("2.8 m/s", "9000 m/s")
PENDULUM = """
parameters: {m: 2 kg, L: 0.5 m, g: 9.81 m/s^2, w0: 5 rad/s}
bodies: {bob: {particle: {mass: m}}}
connections: {rod: {link: [ground.O, bob, L]}}
loads: {weight: {gravity: g}}
measures: {theta: angle of line from ground.O to bob from down}
start: {theta: 0, rate(theta): w0}
"""


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        (ORBIT, "least v0 so that r escapes", "sqrt(2*mu/r0)"),  # v0^2/2 - mu/r0 = 0
        (ORBIT, "range of v0 for which r never turns back", "sqrt(2*mu/r0)"),
        (ORBIT, "range of v0 for which r does not come back", "sqrt(2*mu/r0)"),
        (PENDULUM, "least w0 so that theta never turns back", "2*sqrt(g/L)"),  # m L^2 w0^2/2 = 2 m g L
        (PENDULUM, "range of w0 for which theta turns back before theta = 90 deg", "sqrt(2*g/L)"),
    ],
)
def test_what_never_turns_back(model: str, question: str, formula: str) -> None:
    is_formula(model, question, formula, factors=(1.0,))


def test_numbers_of_a_planet_are_waited_for() -> None:
    # a turn is hours away: the motion in numbers that confirms the formula is followed as long
    found = is_formula(EARTH, "least v0 so that r escapes", "sqrt(2*mu/r0)", factors=(1.0,))
    assert found.value == pytest.approx(10690.45, rel=1e-6)


def test_it_is_derived() -> None:
    is_derived(PENDULUM, "least w0 so that theta never turns back")
