"""Shares of what a motion tends to, of an amplitude that dies away, and amplitude ratios of modes."""

from __future__ import annotations

import pytest

from posed import is_derived, is_formula, posed

DRIVEN = """
parameters: {m: 2 kg, F: 10 N, c: 4 kg/s, p: 0.6}
bodies: {b: {particle: {mass: m}, at: [0, 0]}}
connections: {rail: {slider: {body: b, along: right}}}
measures: {x: x of b}
loads: {drag: {law: {measure: x, force: -c*rate(x)}}, pull: {force: {at: b, along: right, magnitude: F}}}
start: {x: 0, rate(x): 0}
"""
FALLING = """
parameters: {m: 2 kg, c: 4 kg/m, g: 9.81 m/s^2}
bodies: {b: {particle: {mass: m}, at: [0, 0]}}
connections: {rail: {slider: {body: b, along: down}}}
measures: {s: drop of b below ground.O}
loads: {drag: {law: {measure: s, force: -c*rate(s)^2}}, weight: {gravity: g}}
ground: {points: {O: [0, 0]}}
start: {s: 0, rate(s): 0}
"""
COASTING = """
parameters: {m: 2 kg, c: 4 kg/s, v: 3 m/s}
bodies: {b: {particle: {mass: m}, at: [0, 0]}}
connections: {rail: {slider: {body: b, along: right}}}
measures: {x: x of b}
loads: {drag: {law: {measure: x, force: -c*rate(x)}}}
start: {x: 0, rate(x): v}
"""
DAMPED = """
parameters: {m: 2 kg, k: 800 N/m, c: 4 kg/s, A: 5 cm, p: 0.1}
bodies: {b: {particle: {mass: m}}}
connections: {rail: {slider: {body: b, along: right}}}
measures: {x: x of b}
loads: {spring: {law: {measure: x, force: -k*x}}, damper: {law: {measure: x, force: -c*rate(x)}}}
start: {x: A, rate(x): 0}
"""
COUPLED = """
parameters: {m: 1 kg, k: 100 N/m, q: 40 N/m}
bodies: {A: {particle: {mass: m}}, B: {particle: {mass: 2*m}}}
connections: {a: {slider: {body: A, along: right}}, b: {slider: {body: B, along: right}}}
measures: {x1: x of A, x2: x of B}
loads:
  left: {law: {measure: x1, force: -k*x1}}
  middle: {law: {measure: {expression: x2 - x1}, force: -q*(x2 - x1)}}
start: {x1: 0, x2: 0}
"""
# K - w^2 M of the same: (k + q - w^2 m) x1 = q x2, 2 m^2 w^4 - m (2 k + 3 q) w^2 + k q = 0
FASTER = "((2*k+3*q) + sqrt((2*k+3*q)^2 - 8*k*q))/(4*m)"


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        # Meriam & Kraige, Dynamics, ch. 3: v = (F/c)(1 - exp(-c t/m))
        (DRIVEN, "time until half of the final speed", "m*log(2)/c"),
        (DRIVEN, "time when velocity of x is 90 % of its final value", "m*log(10)/c"),
        (DRIVEN, "time until p of the final speed is reached", "-m*log(1-p)/c"),
        (DRIVEN, "x when velocity of x is p of its final value", "-(m*F/c^2)*(log(1-p)+p)"),
        # v = V tanh(g t/V), V^2 = m g/c; v^2 = V^2 (1 - exp(-2 c s/m))
        (FALLING, "time until half of the terminal speed", "sqrt(m/(c*g))*log(3)/2"),
        (FALLING, "s when velocity of s is half of its final value", "m*log(4/3)/(2*c)"),
        # Gross, Hauger et al., Technische Mechanik 3, ch. 5: x_(n+1)/x_n = exp(-delta)
        (DAMPED, "number of oscillations until the amplitude falls to 10 %", "log(10)*sqrt(4*m*k-c^2)/(2*pi*c)"),
        (DAMPED, "number of swings until the amplitude has fallen to p", "-log(p)*sqrt(4*m*k-c^2)/(2*pi*c)"),
        (COUPLED, "amplitude ratio of x1 to x2 in mode 2", f"q/(k+q-m*{FASTER})"),
        (COUPLED, "ratio of the amplitudes of x2 to x1 in the second mode", f"(k+q-m*{FASTER})/q"),
    ],
)
def test_a_share_and_a_ratio_have_the_formula_by_hand(model: str, question: str, formula: str) -> None:
    is_formula(model, question, formula)


def test_a_share_of_a_speed_that_dies_away_is_never_reached() -> None:
    found = posed(COASTING, "time until half of the final speed")
    assert found.expression is None
    assert "tends to zero" in str(found.reason)


def test_an_amplitude_ratio_and_a_share_are_derived() -> None:
    assert "in der Eigenform 2" in is_derived(COUPLED, "amplitude ratio of x1 to x2 in mode 2")["de"]
    is_derived(DRIVEN, "time until half of the final speed")
