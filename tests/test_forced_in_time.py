"""Motions that a drive or a load leads in time, from a given start: forced motion and free motion together.

By hand: x = p + h, with p of the shape of what leads it and h'' = -w0^2 h (- 2 d h'), h(0) = x0 - p(0),
h'(0) = v0 - p'(0). Problem families: Meirovitch, Elements of Vibration Analysis, sec. 2.2; Rao, Mechanical Vibrations,
ch. 3; Magnus & Popp, Schwingungen, ch. 5; Beer & Johnston, Dynamics, ch. 19.
"""

from __future__ import annotations

import pytest

from posed import is_derived, is_formula, posed

LED = """
parameters: {m: 2 kg, M: 1 kg, k: 200 N/m, Y: 0.1 m, w: 6 rad/s, b: 0.05 m, L: 0.5 m}
ground: {lines: {rail: {along: right}}}
bodies: {cart: {particle: {mass: m}}, base: {particle: {mass: M}}}
connections:
  under: {slider: [base, ground.rail]}
  on: {slider: [cart, ground.rail]}
  drive: {driver: {measure: x of base, follows: Y*sin(w*t)}}
loads: {spring: {spring: {between: [base, cart], stiffness: k, length: L}}}
measures: {s: x of base, x: x of cart}
start: {x: L, rate(x): 0}
"""
FORCED = """
parameters: {{m: 2 kg, k: 50 N/m, c: {c} kg/s, F0: 3 N, W: 3 rad/s, T: 1.3 s, v0: 0.4 m/s}}
ground: {{lines: {{rail: {{along: right}}}}}}
bodies: {{a: {{particle: {{mass: m}}}}}}
connections: {{on: {{slider: [a, ground.rail]}}}}
loads:
  spring: {{force: {{at: a, along: right, magnitude: -k*x{drag}}}}}
  push: {{force: {{at: a, along: right, magnitude: {push}}}}}
measures: {{x: x of a}}
start: {{x: 0, rate(x): {v}}}
"""
STRUCK = FORCED.format(c=1, drag="", push="F0*cos(W*t)", v="v0")
SQUARED = FORCED.format(c=1, drag="", push="F0*sin(W*t)^2", v="0")
RESONANT = FORCED.format(c=1, drag="", push="F0*sin(sqrt(k/m)*t)", v="0")
RAMP = FORCED.format(c=1, drag="", push="F0*t/T", v="0")
DAMPED = FORCED.format(c=1, drag=" - c*rate(x)", push="F0*sin(W*t)", v="0")
DRAGGED = FORCED.format(c=1, drag=" + k*x - c*rate(x)", push="F0*sin(W*t)", v="v0")

N = "sqrt(k/m)"
P = f"Y*{N}^2/({N}^2 - w^2)"
# damped: D = (k - m W^2)^2 + (c W)^2, p = F0 ((k - m W^2) sin - c W cos)/D
D = "((k - m*W^2)^2 + (c*W)^2)"
C0, S0 = f"(-F0*c*W/{D})", f"(F0*(k - m*W^2)/{D})"
DEC = "(c/(2*m))"
WD = f"sqrt(k/m - {DEC}^2)"

BY_HAND = {
    "driver at its extreme": (LED, "time when s = Y", "pi/(2*w)"),
    "there": (LED, "x when s = Y", f"L + {P}*(1 - w/{N}*sin({N}*pi/(2*w)))"),
    "speed there": (LED, "velocity of x when s = Y", f"-{P}*w*cos({N}*pi/(2*w))"),
    "driver on its way": (LED, "x when s = b", f"L + {P}*(b/Y - w/{N}*sin({N}/w*asin(b/Y)))"),
    "driver turns": (LED, "x when rate(s) = 0", f"L + {P}*(1 - w/{N}*sin({N}*pi/(2*w)))"),
    "driver at half its speed": (LED, "time when rate(s) = w*Y/2", "pi/(3*w)"),
    "struck": (STRUCK, "x at t = T", f"F0/(k - m*W^2)*(cos(W*T) - cos({N}*T)) + v0/{N}*sin({N}*T)"),
    "squared": (
        SQUARED,
        "x at t = T",
        f"F0/(2*k)*(1 - cos({N}*T)) - F0/(2*(k - 4*m*W^2))*(cos(2*W*T) - cos({N}*T))",
    ),
    "resonance": (RESONANT, "x at t = T", f"F0/(2*m*{N}^2)*(sin({N}*T) - {N}*T*cos({N}*T))"),
    "ramp": (RAMP, "x at t = T", f"F0/(k*T)*(T - sin({N}*T)/{N})"),
    "damped": (
        DAMPED,
        "x at t = T",
        f"{C0}*cos(W*T) + {S0}*sin(W*T) + exp(-{DEC}*T)*(-{C0}*cos({WD}*T) - ({S0}*W + {DEC}*{C0})/{WD}*sin({WD}*T))",
    ),
    "resisted": (
        DRAGGED,
        "velocity of x at t = T",
        "F0*(c*sin(W*T) - m*W*cos(W*T))/(c^2 + m^2*W^2) + (v0 + F0*m*W/(c^2 + m^2*W^2))*exp(-c*T/m)",
    ),
}


@pytest.mark.parametrize("name", BY_HAND)
def test_what_is_led_in_time_is_a_forced_and_a_free_motion(name: str) -> None:
    is_formula(*BY_HAND[name])


def test_at_resonance_without_damping_there_is_no_greatest_value() -> None:
    found = posed(RESONANT, "greatest x")
    assert found.expression is None
    assert "grows without bound" in str(found.reason)


@pytest.mark.parametrize("model", ["struck", "damped"])
def test_it_is_derived(model: str) -> None:
    told = is_derived({"struck": STRUCK, "damped": DAMPED}[model], "x at t = T")
    assert "a forced motion" in " ".join(told["en"].split())
    assert "eine erzwungene Bewegung" in " ".join(told["de"].split())
