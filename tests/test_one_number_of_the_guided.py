"""The velocity of what is guided along a line of the ground, where one number is needed: that along its guide."""

from __future__ import annotations

import pytest

from posed import is_formula, posed

BLOCK = """
parameters: {m: 2 kg, F: 10 N, alpha: 30 deg, v0: 1 m/s, a: 2 m/s^2, g: 9.81 m/s^2}
ground: {lines: {slope: {along: alpha}}}
bodies: {block: {particle: {mass: m}, velocity: v0}}
connections: {guide: {slider: {body: block, along: slope}}}
loads: {weight: {gravity: g}, push: {force: {at: block, along: slope, magnitude: F}}}
"""
BALLS = """
parameters: {m1: 4 kg, m2: 2 kg, m3: 1 kg, e: 0.8, v: 5 m/s, d: 0.5 m, u: 3 m/s}
bodies:
  A: {particle: {mass: m1}, at: [0, 0], velocity: [v, 0]}
  B: {particle: {mass: m2}, at: [d, 0]}
  C: {particle: {mass: m3}, at: [2*d, 0]}
connections:
  ga: {slider: {body: A, along: right}}
  gb: {slider: {body: B, along: right}}
  gc: {slider: {body: C, along: right}}
  ab: {contact: {body: A, on: B, restitution: e}}
  bc: {contact: {body: B, on: C, restitution: e}}
"""
SHAKEN = """
parameters: {m: 2 kg, k: 300 N/m, c: 4 N s/m, Y: 0.01 m, Omega: 9 rad/s}
bodies: {block: {particle: {mass: m}}, foot: {particle: {}}}
connections:
  guide: {slider: {body: block, along: up}}
  track: {slider: {body: foot, along: up}}
  shaker: {driver: {measure: y, follows: Y*sin(Omega*t)}}
measures: {x: y of block, y: y of foot}
loads:
  spring: {law: {measure: {expression: x - y}, force: -k*(x - y)}}
  damper: {law: {measure: {expression: x - y}, force: -c*(rate(x) - rate(y))}}
start: {x: 0}
"""


@pytest.mark.parametrize(
    ("question", "formula"),
    [
        ("value of F for which acceleration of block = a", "m*(a + g*sin(alpha))"),
        ("ratio of acceleration of block to g", "F/(m*g) - sin(alpha)"),
        ("velocity of block/v0 at t = 2 s", "1 + 2*(F/m - g*sin(alpha))/v0"),
    ],
)
def test_on_a_slope(question: str, formula: str) -> None:
    is_formula(BLOCK, question, formula)


def test_from_where_on_a_block_is_pushed_up_its_slope() -> None:
    found = is_formula(BLOCK, "range of F for which acceleration of block > 0", "m*g*sin(alpha)")
    assert "this holds for F > m·g·sin(α)" in map(str, found.notes)


def test_the_size_stays_a_size() -> None:
    assert len(posed(BLOCK, "value of F for which |acceleration of block| = a").value) == 2


def test_the_best_ball_between_two() -> None:
    """Twice (1 + e) m_i/(m_i + m_k): m1 m2/((m1 + m2)(m2 + m3)) is largest for m2^2 = m1 m3."""
    is_formula(BALLS, "value of m2 for which velocity of C after the second impact is largest", "sqrt(m1*m3)")
    formula = "u*(m1 + m2)*(m2 + m3)/(m1*m2*(1 + e)^2)"
    is_formula(BALLS, "value of v for which velocity of C after the second impact = u", formula)


def test_the_steady_amplitude_of_an_acceleration() -> None:
    formula = "Omega^2*Y*sqrt((k^2 + c^2*Omega^2)/((k - m*Omega^2)^2 + c^2*Omega^2))"
    is_formula(SHAKEN, "steady amplitude of acceleration of block", formula)
