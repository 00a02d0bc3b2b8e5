"""A bevel differential of which both side wheels are driven.

Problem families: Norton, Design of Machinery, ch. 9 (differentials); Shigley & Uicker, Theory of Machines, ch. 7.
"""

from __future__ import annotations

import numpy as np
import pytest

from posed import posed

ADDER = """
space: true
parameters: {w1: 12 rad/s, w2: 4 rad/s}
bodies: {cage: {body: {}}, left: {body: {}}, right: {body: {}}, planet: {body: {}}}
connections:
  b0: {revolute: {first: ground.O, second: cage, about: x}}
  b1: {revolute: {first: ground.O, second: left, about: x}}
  b2: {revolute: {first: ground.O, second: right, about: x}}
  pin: {revolute: {first: cage, second: planet, about: y}}
  m1: {gear_pair: {first: left, second: planet, on: cage, first_axis: x, second_axis: y, ratio: 2}}
  m2: {gear_pair: {first: right, second: planet, on: cage, first_axis: x, second_axis: y, ratio: -2}}
  d1: {driver: {measure: p, follows: w1*t}}
  d2: {driver: {measure: q, follows: w2*t}}
measures: {p: angle of left about x, q: angle of right about x}
"""


def test_the_planet_turns_in_the_cage_by_half_the_difference_times_the_ratio() -> None:
    """Two equations by Willis, w_P = 2 (w_1 - w_C) and w_P = -2 (w_2 - w_C), at the start, where the pin lies along
    y."""
    w_1, w_2 = 12.0, 4.0
    w_P, w_C = np.linalg.solve([[1.0, 2.0], [1.0, -2.0]], [2 * w_1, -2 * w_2])
    assert posed(ADDER, "angular velocity of cage along right").value == pytest.approx(w_C)
    assert posed(ADDER, "angular velocity of planet relative to cage in cage").value == pytest.approx((0, w_P, 0))
    assert posed(ADDER, "angular velocity of planet relative to cage").value == pytest.approx((0, w_P, 0))
