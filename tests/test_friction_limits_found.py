"""Limits of rest in numbers: by linear programs alone, as far as their digits go."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import freebody as fb
from freebody.api import System

EXAMPLES = Path(__file__).parents[1] / "examples"


@pytest.mark.parametrize("T", [0.3, 0.99, 1.2, 2.4, 3.4])
def test_a_screw_that_hardly_slips_is_followed_to_where_it_slips(T: float) -> None:
    """Unrolled thread: with S along the axis, S (p - 2 pi r mu) = 2 pi T and S (2 pi r + p mu) = 2 pi r m g, so that
    mu = r (m g p - 2 pi T)/(2 pi m g r^2 + T p); upwards with the other sign."""
    system = System.load(EXAMPLES / "screw_jack.yaml").with_parameters(T=T)
    answer = system.solve("least mu so that it stays at rest").answers[0]
    m, p, r, g = 100.0, 8e-3, 15e-3, 9.81
    least = r * abs(m * g * p - 2 * math.pi * T) / (2 * math.pi * m * g * r * r + T * p)
    assert answer.value == pytest.approx(least, rel=1e-12)
    # the margin hardly changes with mu: where it was less than round-off counts for was no end
    assert answer.evidence is not None
    assert answer.evidence.worst_relative_difference < 1e-11


IN_THE_AIR = """
parameters: {m: 1 kg, mu: 0.3, nu: 0.2, g: 9.81 m/s^2, h: 2 m}
ground: {lines: {floor: {along: right}, wall: {along: up, through: [3 m, 0]}}}
bodies: {block: {rectangle: {width: 0.2 m, height: 0.2 m, mass: m}, at: [0, h]}}
connections: {floor: {contact: {between: [block, floor], friction: mu}}}
loads: {weight: {gravity: g}}
"""


def test_where_nothing_resists_the_open_contacts_are_named_with_their_gaps() -> None:
    level = IN_THE_AIR.replace("at: [0, h]", "at: [0, h], angle: 0").replace("nu: 0.2, ", "")
    assert System.from_text(level).statics().fails == "nothing resists block: floor is open by 1.9 m"  # 2 m - 0.2 m/2


def test_a_coefficient_of_friction_decides_nothing_where_nothing_touches() -> None:
    in_the_air = System.from_text(IN_THE_AIR.replace("nu: 0.2, ", ""))
    assert "nothing touches" in in_the_air.solve("least mu so that it does not slip").answers[0].reason
    on_the_floor = IN_THE_AIR.replace("at: [0, h]", "at: [0, 0.1 m], angle: 0").replace("h: 2 m", "F: 1 N")
    two = on_the_floor.replace(
        "friction: mu}}", "friction: mu}}, wall: {contact: {between: [block, wall], friction: nu}}"
    )
    push = two.replace("loads: {", "loads: {push: {force: {at: block, along: right, magnitude: F}}, ")
    system = System.from_text(push)
    assert system.solve("least mu so that it does not slip").answers[0].value == pytest.approx(1 / 9.81)
    assert "open at the start: wall" in system.solve("least nu so that it does not slip").answers[0].reason


def test_bell_crank_on_a_rough_journal_is_limited_by_the_circle_of_friction() -> None:
    """F b - W a = +-mu r sqrt(F^2 + W^2): the force on the journal changes its direction with F."""
    crank = """
parameters: {W: 800 N, a: 0.2 m, b: 0.5 m, mu: 0.2, r: 20 mm, F: 320 N}
ground: {points: {O: [0, 0]}}
bodies: {crank: {body: {}, at: [0, 0], points: {A: [-a, 0], B: [0, b]}}}
connections: {journal: {pin: {first: ground.O, second: crank, friction: mu, radius: r}}}
loads:
  load: {force: {at: crank.A, along: down, magnitude: W}}
  hand: {force: {at: crank.B, along: right, magnitude: F}}
questions: [largest F so that it stays at rest, least F so that it stays at rest]
"""
    solution = fb.solve(fb.System.from_text(crank))
    arm = 0.2 * 0.02
    for name, sign in (("q1", 1.0), ("q2", -1.0)):
        answer = solution[name]
        root = math.sqrt(0.2**2 + 0.5**2 - arm**2)
        assert answer.value == pytest.approx(800 * (0.2 * 0.5 + sign * arm * root) / (0.5**2 - arm**2), rel=1e-12)
        assert answer.expression is not None
        assert answer.evidence is not None
        assert answer.evidence.worst_relative_difference < 1e-12
