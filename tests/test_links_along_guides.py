"""A bar between two blocks on one line: the travel of one follows from that of the other.

Along the line from block 2 (below) to block 1: m1 a = m1 g (sin al - mu1 cos al) + S and m2 a = m2 g (sin al - mu2 cos
al) - S with a pull S of the bar on both. The sum gives a, the difference S; the work of friction is what is lost."""

from __future__ import annotations

import pytest

from posed import is_formula

TWO_BLOCKS = """
parameters: {m1: 2 kg, m2: 4 kg, mu1: 0.1, mu2: 0.3, alpha: 35 deg, L: 0.5 m, d: 2 m, g: 9.81 m/s^2}
ground: {lines: {incline: {along: -alpha}}}
bodies: {lower: {particle: {mass: m1}}, upper: {particle: {mass: m2}}}
connections:
  g1: {slider: {body: lower, along: incline, friction: mu1}}
  g2: {slider: {body: upper, along: incline, friction: mu2}}
  bar: {link: [upper, lower, L]}
loads: {weight: {gravity: g}}
measures: {s: travel of lower along incline, u: travel of upper along incline}
start: {s: 0, u: -L, rate(s): 0}
"""
SMOOTH = TWO_BLOCKS.replace(", friction: mu1", "").replace(", friction: mu2", "").replace("mu1: 0.1, mu2: 0.3, ", "")
# without weight: a push F on the lower block alone, along a line that leans the other way
PUSHED = """
parameters: {m1: 2 kg, m2: 4 kg, alpha: 50 deg, L: 0.5 m, d: 2 m, F: 12 N}
ground: {lines: {incline: {along: alpha}}}
bodies: {lower: {particle: {mass: m1}}, upper: {particle: {mass: m2}}}
connections:
  g1: {slider: {body: lower, along: incline}}
  g2: {slider: {body: upper, along: incline}}
  bar: {link: [upper, lower, L]}
loads: {push: {force: {at: lower, along: incline, magnitude: F}}}
measures: {s: travel of lower along incline, u: travel of upper along incline}
start: {s: 0, u: L, rate(s): 0}
"""
ACCELERATION = "g*(sin(alpha) - (m1*mu1 + m2*mu2)*cos(alpha)/(m1 + m2))"


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        (TWO_BLOCKS, "velocity of s when s = d", f"sqrt(2*d*{ACCELERATION})"),
        (TWO_BLOCKS, "velocity of u when s = d", f"sqrt(2*d*{ACCELERATION})"),
        (TWO_BLOCKS, "tension of bar when s = d", "m1*m2*g*(mu2 - mu1)*cos(alpha)/(m1 + m2)"),
        (TWO_BLOCKS, "energy lost until s = d", "(m1*mu1 + m2*mu2)*g*cos(alpha)*d"),
        (SMOOTH, "u when s = d", "d - L"),
        (SMOOTH, "velocity of s when s = d", "sqrt(2*g*d*sin(alpha))"),
        (SMOOTH, "tension of bar", "0"),
        (PUSHED, "u when s = d", "d + L"),
        (PUSHED, "tension of bar", "-F*m2/(m1 + m2)"),
        (PUSHED, "velocity of u when s = d", "sqrt(2*F*d/(m1 + m2))"),
    ],
)
def test_blocks_that_a_bar_joins_on_one_line_move_as_one(model: str, question: str, formula: str):
    assert is_formula(model, question, formula)
