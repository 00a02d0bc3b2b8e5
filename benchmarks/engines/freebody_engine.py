"""freebody: the model as a user describes it, its compiled simulator, one tolerance.

An evaluation comes to the accelerations of all bodies and the reactions of all pins.
"""

from __future__ import annotations

import sys
from time import perf_counter
from typing import Any

import numpy as np
from problems import (
    FOUR_BAR_TIME,
    Array,
    Evaluations,
    chain_model,
    chain_state,
    chain_without_start,
    four_bar_model,
    poses_and_velocities,
)

from freebody import System
from freebody.numeric.engine.engine import Engine
from freebody.numeric.reference import Reference
from freebody.study.simulation.simulate import simulate
from freebody.study.simulation.simulator import Simulator

TOLERANCES = (1e-2, 1e-12)


def _ends(course: Any) -> Array:
    """Where the rods end, from the last poses of mass centres; the last body is the ground."""
    x, y, angle = course.poses[-1, :-1].T
    return np.column_stack([x + np.cos(angle) / 2, y + np.sin(angle) / 2])


def _runs(model: dict[str, Any], until: float, points: Any) -> Any:
    simulator = Simulator(System.from_data(model))

    def run(tolerance: float) -> tuple[float, Array]:
        begin = perf_counter()
        course = simulator.run(until, tolerance=tolerance)
        seconds = perf_counter() - begin
        ends = points(_ends(course))
        return seconds, ends if course.status.is_complete else np.full_like(ends, np.nan)

    return run


def accelerations(n: int) -> Evaluations:
    """Evaluates at the random state of n links, timed within the compiled loop."""
    engine = Engine(Reference(System.from_data(chain_without_start(n))).numbers())
    state = engine.state(*poses_and_velocities(*chain_state(n)))
    found, _reactions = engine.evaluate(state, 0.0)

    def timed(n_calls: int) -> tuple[float, Array]:
        begin = perf_counter()
        engine.evaluate(state, 0.0, n_calls)
        return (perf_counter() - begin) / n_calls, found[:-1, 2]

    return timed


def chain_methods(n: int) -> dict[str, Any]:
    """Runs of the chain second."""
    return {"default": (_runs(chain_model(np.zeros(n), np.zeros(n)), 1.0, lambda ends: ends), TOLERANCES)}


def four_bar_methods(n_windows: int) -> dict[str, Any]:
    """Runs of the N-four-bar; crank 0 is the first body."""
    return {"default": (_runs(four_bar_model(n_windows), FOUR_BAR_TIME, lambda ends: ends[0]), TOLERANCES)}


if __name__ == "__main__":
    result = simulate(System.from_data(four_bar_model(1)), FOUR_BAR_TIME, tolerance=float(sys.argv[1]))
    print(*_ends(result.course)[0])
