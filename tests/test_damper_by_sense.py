"""A damper that acts in one sense only: the closed form up to the first turn, half by half of a damped swing."""

from __future__ import annotations

from math import atan2, exp, pi, sin, sqrt

import pytest

import freebody as fb

M, K, C, D = 10.0, 1000.0, 40.0, 90.0
BLOCK = """
parameters: {m: 10 kg, k: 1000 N/m, c: 40 N s/m, d: 90 N s/m, x0: 0.1 m, v0: 2 m/s}
bodies: {block: {particle: {mass: m}}}
connections: {rail: {slider: {body: block, along: right}}}
ground: {points: {W: [-0.5 m, 0]}}
loads:
  spring: {spring: {first: ground.W, second: block, stiffness: k, length: 0.5 m}}
  bump: {damper: {first: ground.W, second: block, damping: c, only: compressed}}
measures: {x: x of block}
"""
REBOUND = "  rebound: {damper: {first: ground.W, second: block, damping: d, only: stretched}}\nmeasures:"
FROM_REST = "start: {x: x0, rate(x): 0}\n"
STRUCK = "start: {x: 0, rate(x): v0}\n"


def swing(damping: float) -> tuple[float, float]:
    """Decay delta = c/(2 m) and w = sqrt(k/m - delta^2) on one of the two ways."""
    delta = damping / (2 * M)
    return delta, sqrt(K / M - delta**2)


def test_a_block_let_go_is_damped_in_its_first_half_swing_by_the_damper_that_is_compressed() -> None:
    # x = exp(-delta t) (x0 cos(w t) + ...): half a period pi/w, in which x0 becomes -x0 exp(-pi delta/w)
    delta, w = swing(C)
    found = fb.System.from_text(BLOCK + FROM_REST).solve(["time when rate(x) = 0", "least x", "greatest x"])
    assert found["q1"].value == pytest.approx(pi / w, rel=1e-9)
    assert found["q2"].value == pytest.approx(-0.1 * exp(-pi * delta / w), rel=1e-9)
    assert found["q3"].value == pytest.approx(0.1, rel=1e-12)
    assert all(found[q].expression is not None for q in ("q1", "q2", "q3"))


def test_pulled_apart_the_same_damper_does_nothing_and_the_block_swings_to_the_other_side() -> None:
    text = BLOCK.replace("x0: 0.1 m", "x0: {value: -0.1 m, sign: any}") + FROM_REST
    found = fb.System.from_text(text).solve(["time when rate(x) = 0", "x when rate(x) = 0"])
    assert found["q1"].value == pytest.approx(pi * sqrt(M / K), rel=1e-9)
    assert found["q2"].value == pytest.approx(0.1, rel=1e-9)


def test_with_bump_and_rebound_a_blow_is_met_by_the_damping_of_its_own_sense() -> None:
    # x = (v0/w) exp(-delta t) sin(w t) turns at tan(w t) = w/delta
    delta, w = swing(D)
    turn = atan2(w, delta) / w
    text = BLOCK.replace("measures:", REBOUND) + STRUCK
    questions = ["time when rate(x) = 0", "greatest x", "x at t = 0.05 s", "x at t = 1 s"]
    found = fb.System.from_text(text).solve(questions)
    assert found["q1"].value == pytest.approx(turn, rel=1e-9)
    assert found["q2"].value == pytest.approx(2 / w * exp(-delta * turn) * sin(w * turn), rel=1e-9)
    assert found["q3"].value == pytest.approx(2 / w * exp(-delta * 0.05) * sin(w * 0.05), rel=1e-9)
    assert found["q4"].expression is None
    assert "after its first turn it is resisted otherwise" in str(found["q4"].reason)


def test_two_equal_one_way_dampers_are_one_damper() -> None:
    both = BLOCK.replace("measures:", REBOUND.replace("damping: d", "damping: c")) + STRUCK
    one = BLOCK.replace(", only: compressed", "") + STRUCK
    questions = ["time when rate(x) = 0", "greatest x"]
    pair, single = (fb.System.from_text(text).solve(questions) for text in (both, one))
    for q in ("q1", "q2"):
        assert pair[q].value == pytest.approx(single[q].value, rel=1e-12)


def test_its_derivation_says_that_it_holds_up_to_the_first_turn() -> None:
    told = fb.System.from_text(BLOCK + FROM_REST).explain("time when rate(x) = 0", language="de")
    assert told.is_complete
    assert "bis zum ersten Umkehrpunkt" in " ".join(told.to_text().split())
