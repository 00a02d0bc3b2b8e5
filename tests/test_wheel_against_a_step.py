"""A wheel on a rough floor that is pulled against a step, by moments about its edge.

P (r - h) = m g sqrt(r^2 - (r - h)^2) where it lifts (Meriam & Kraige, Statics, sec. 3/3; Hibbeler, Statics, ch. 5): the
reaction of the edge goes through the centre, and nothing slips.
"""

from __future__ import annotations

import math

import pytest

import freebody as fb

STEP = """
parameters: {m: 50 kg, r: 0.3 m, h: 0.1 m, P: 100 N, mu: 0.5, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}, points: {edge: [sqrt(r^2 - (r - h)^2), h]}}
bodies: {wheel: {disk: {mass: m, radius: r}, at: [0, r], angle: 0}}
connections:
  floor: {contact: {between: [wheel, ground.floor], friction: mu}}
  step: {contact: {between: [wheel, ground.edge], friction: mu}}
loads: {weight: {gravity: g}, pull: {force: {at: wheel, along: right, magnitude: P}}}
measures: {y: y of wheel}
"""
LEAST = 50 * 9.81 * math.sqrt(0.3**2 - 0.2**2) / 0.2


def test_least_pull_that_lifts_a_wheel_over_a_step() -> None:
    system = fb.System.from_text(STEP)
    (least,) = system.solve("least P so that the wheel lifts over the step").answers
    assert least.expression is not None
    assert least.value == pytest.approx(LEAST, rel=1e-12)
    # beside it: just below the wheel stands, just above it is on its way up
    for share, rises in ((0.999, False), (1.01, True)):
        motion = system.with_parameters(P=share * LEAST).simulate(0.1)
        assert bool(motion.series["y"][0][-1] > 0.3 + 1e-6) is rises


def test_where_the_floor_carries_nothing_is_a_range_of_the_pull() -> None:
    """Below the least pull the floor carries weight; it was said to carry none for every P."""
    (answer,) = fb.System.from_text(STEP).solve("value of P for which normal force of floor = 0").answers
    assert answer.value is None
    assert "in a whole range of P" in str(answer.reason)
