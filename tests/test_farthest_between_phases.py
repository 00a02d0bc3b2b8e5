"""How fast something gets at most where an impact makes it so, or where it comes to rest: the extreme lies between two
phases. A bullet in a sprung block: m v = (m + M) u, then (m + M) u^2/2 = k x^2/2, until the spring has thrown both back
with -u and the bullet parts from the block. A block that slides to rest against friction never turns back."""

from __future__ import annotations

import numpy as np
import pytest

from freebody.study.phases.along_time import _falls_unseen
from posed import is_formula, posed

SPRUNG = """
parameters: {m: 0.02 kg, M: 2 kg, k: 500 N/m, v: 300 m/s}
bodies:
  bullet: {particle: {mass: m}, at: [-0.5 m, 0], velocity: [v, 0]}
  block: {rectangle: {mass: M, width: 0.2 m, height: 0.2 m}, at: [0, 0]}
connections:
  guide: {slider: {body: block, along: right}}
  hit: {contact: {between: [bullet, block], friction: 0, restitution: 0}}
measures: {x: x of block}
loads: {spring: {law: {measure: x, force: -k*x}}}
"""
SLIDING = """
parameters: {M: 1 kg, v: 3 m/s, mu: 0.3, g: 9.81 m/s^2}
ground: {lines: {table: {along: right}}}
bodies: {block: {particle: {mass: M}, velocity: [v, 0], at: [0, 0]}}
connections: {rub: {contact: {between: [block, ground.table], friction: mu}}}
loads: {weight: {gravity: g}}
measures: {x: x of block}
"""


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        (SPRUNG, "greatest x", "m*v/sqrt(k*(m + M))"),
        (SPRUNG, "greatest velocity of x", "m*v/(m + M)"),
        (SPRUNG, "least velocity of x", "-m*v/(m + M)"),
        (SLIDING, "least velocity of x", "0"),
        (SLIDING, "greatest velocity of x", "v"),
        (SLIDING, "greatest x", "v^2/(2*mu*g)"),
    ],
)
def test_an_extreme_between_two_phases_has_the_formula_by_hand(model: str, question: str, formula: str) -> None:
    is_formula(model, question, formula)


def test_only_what_has_been_positive_falls_unseen() -> None:
    first = np.array([1.0, -1.0, -1.0, 0.0, 1.0])
    seen = np.array([[-1.0, -1.0, 1.0, -1.0, 1.0], [-1.0, -1.0, -1.0, -1.0, 1.0]])
    assert _falls_unseen(first, seen).tolist() == [True, False, True, True, False]


def test_what_is_let_fall_is_highest_at_the_start_until_it_has_bounced() -> None:
    text = """
parameters: {m: 0.1 kg, h: 0.5 m, e: 0.7, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {ball: {particle: {mass: m}, at: [0, h]}}
connections: {hit: {contact: {between: [ball, floor], restitution: e}}}
loads: {weight: {gravity: g}}
measures: {y: height of ball}
"""
    is_formula(text, "greatest y until the second impact", "h")
    assert posed(text, "least y until the impact").value == 0.0
