"""Of several things that slide it is the last one that has stopped when `it stops`.

A block slides into another one at the distance d; both slide on. With v^2 = v_0^2 - 2 mu g d they have
v_A = (m_1 - e m_2) v/(m_1 + m_2) and v_B = m_1 (1 + e) v/(m_1 + m_2), and each comes to rest after v_i/(mu g), on
v_i^2/(2 mu g). Source: Beer & Johnston, Vector Mechanics for Engineers: Dynamics, sec. 13.4.
"""

from __future__ import annotations

from math import sqrt

import pytest

import freebody as fb
from posed import posed

BLOCKS = fb.System.from_text("""
parameters: {m1: 2 kg, m2: 3 kg, v0: 6 m/s, d: 1 m, mu: 0.3, e: 0.5, g: 9.81 m/s^2}
bodies:
  A: {particle: {mass: m1}, at: [0, 0]}
  B: {particle: {mass: m2}, at: [d, 0]}
connections:
  gA: {slider: {body: A, along: right, through: ground.O, friction: mu}}
  gB: {slider: {body: B, along: right, through: ground.O, friction: mu}}
  hit: {contact: {between: [A, B], restitution: e}}
loads: {weight: {gravity: g}}
measures: {xA: x of A, xB: x of B}
start: {rate(xA): v0, rate(xB): 0}
""")
BRAKED = 0.3 * 9.81
V = sqrt(6.0**2 - 2 * BRAKED * 1.0)
V_A, V_B = (2 - 0.5 * 3) * V / 5, 2 * 1.5 * V / 5


@pytest.mark.parametrize(
    ("said", "value"),
    [
        ("time until both are at rest", (6.0 - V) / BRAKED + V_B / BRAKED),
        ("How far apart are they when both have stopped?", (V_B**2 - V_A**2) / (2 * BRAKED)),
        ("How far does B slide until it comes to rest?", V_B**2 / (2 * BRAKED)),
        ("time when A stops", (6.0 - V) / BRAKED + V_A / BRAKED),
    ],
    ids=["both", "apart", "B slides", "A"],
)
def test_the_last_one_has_stopped(said: str, value: float) -> None:
    (answer,) = BLOCKS.solve(said).answers
    assert answer.expression is not None, answer.reason
    assert answer.value == pytest.approx(value, rel=1e-9)


BESIDE = """
parameters: {m: 1 kg, M: 2 kg, mu: 0.3, nu: 0.2, g: 9.81 m/s^2, v: 3 m/s, w: 1 m/s, u: 1 m/s}
ground: {lines: {floor: {along: right}}}
bodies: {A: {particle: {mass: m}}, B: {particle: {mass: M}}, C: {particle: {mass: M}}}
connections:
  a: {contact: {between: [A, floor], friction: mu}}
  b: {contact: {between: [B, floor], friction: nu}}
  c: {contact: {between: [C, floor]}}
loads: {weight: {gravity: g}}
measures: {x: travel of A along floor, y: travel of B along floor, z: travel of C along floor}
start: {x: 0, rate(x): v, y: 5 m, rate(y): w, z: 20 m, rate(z): u}
"""


def test_what_nothing_brakes_does_not_stop_with_the_others() -> None:
    """C slides on without friction: its energy M u^2/2 is none of something at rest."""
    found = posed(BESIDE, "time when it stops")
    assert found.expression is None
    assert "z still changes" in str(found.reason)
