"""A step that leads over the border of a law from far away is no step, whatever its error says.

A ball is thrown up by a spring that pushes only, falls, and meets it again and again. In free flight an explicit method
of the eighth order has no error, so its steps grow until one leads through all of the next push. The stages that no sum
of the step weighs meet the spring alone and throw the others back into the free flight; the error is zero.
"""

from __future__ import annotations

import numpy as np
import pytest

import freebody as fb
from freebody.numeric.options import SimulationOptions
from freebody.study.simulation.simulator import Simulator

M, K, D, G = 0.3, 500.0, 0.08, 9.81
LAUNCH = fb.System.from_text(f"""
ground: {{points: {{O: [0, -1 m]}}}}
bodies: {{ball: {{particle: {{mass: {M} kg}}, at: [0, -{D} m]}}}}
connections: {{tube: {{slider: {{body: ball, along: up}}}}}}
loads:
  weight: {{gravity: {G} m/s^2}}
  spring: {{spring: {{first: ground.O, second: ball, stiffness: {K} N/m, length: 1 m, only: compressed}}}}
measures: {{y: y of ball}}
start: {{y: -{D} m, rate(y): 0}}
""")


@pytest.mark.parametrize("tolerance", [1e-9, 1e-10, 1e-12])
def test_a_ball_on_a_spring_meets_it_in_every_flight(tolerance: float) -> None:
    simulator = Simulator(LAUNCH, tells_borders=True)
    options = SimulationOptions(method="dop853", tolerance=tolerance)
    course = simulator.run(60.0, options, outputs=np.linspace(0.0, 60.0, 1201))
    top = K * D**2 / (2 * M * G) - D  # m g (top + d) = k d^2/2
    heights = course.poses[:, :, 1]
    assert float(heights.max()) == pytest.approx(top, abs=1e-3)
    # up and down from y = 0 with v^2 = 2 g top, and half a swing about the rest below it
    v, w, rest = (2 * G * top) ** 0.5, (K / M) ** 0.5, M * G / K
    push = 2 * (np.pi - np.arctan2(v / w, rest))
    whole = 2 * v / G + push / w
    touches = [event.time for event in course.events if event.kind == "touches"]
    first = push / (2 * w) + 2 * v / G
    for k, time in enumerate(sorted({round(t, 6) for t in touches})[:80]):
        assert time == pytest.approx(first + k * whole, abs=1e-5)
