"""Motions by which what runs the kernels is compared: `python kernel_runs.py NAME ...` prints a hash of each.

What goes into the kernels is rounded to nine decimals, and what is rounded to zero has no sign, so that the last digits
that Python and linear algebra gave it, which may differ between machines, do not come out again.
"""

from __future__ import annotations

import hashlib
import json
import sys
from pathlib import Path

import numpy as np

import freebody as fb
from freebody.numeric.engine.engine import Engine
from freebody.numeric.kernels import stepping
from freebody.numeric.options import SimulationOptions
from freebody.study.simulation.simulator import Simulator

EXAMPLES = Path(__file__).parents[1] / "examples"
# smooth motions: in the plane and in space, with loops, gears, rolling, springs, drivers and expressions
NAMES = (
    "cart_and_pendulum",
    "spherical_four_bar",
    "double_pendulum",
    "falling_hinged_rod",
    "four_bar",
    "free_asymmetric_body",
    "planetary_gear",
    "slider_crank",
    "spinning_top",
    "two_masses_three_springs",
)


def largest_gaps(engine: Engine, y: np.ndarray, t: float) -> tuple[float, float]:
    """How far a state is from what is held, at most: positions and velocities, by the size of the system."""
    state = y.copy()
    stepping.visit(engine.layout, engine.room, engine.idle, -1.0, state, t, np.zeros(engine.n_y), 0)
    n = engine.n_coordinates
    moved = np.abs(state - y)
    turned = 2.0 * float(moved[2 * n + 1 :].max(initial=0.0))
    return max(float((moved[:n] / engine.unit).max()), turned), float((moved[n : 2 * n] / engine.unit).max())


def motion(name: str, until: float = 0.5) -> np.ndarray:
    """(n_times, ...) poses of the bodies of an example."""
    system = fb.System.load(EXAMPLES / f"{name}.yaml")
    values = {p.name: 0.7 + 0.1 * k for k, p in enumerate(system.parameters.values()) if p.value is None}
    simulator = Simulator(system, values)
    engine = simulator.engine
    assert simulator.bounded is None, f"{name} has phases, between which more than kernels are at work"
    rounded = {k: _rounded(x) for k, x in engine.layout._asdict().items() if x.dtype == float}
    engine.layout = engine.layout._replace(**rounded)
    course = engine.run(_rounded(simulator.start), until, SimulationOptions(), outputs=np.linspace(0.0, until, 6))
    assert course.status.is_complete
    return course.poses


def _rounded(x: np.ndarray) -> np.ndarray:
    return np.round(x, 9) + 0.0


def hashed(name: str) -> str:
    return hashlib.sha256(np.ascontiguousarray(motion(name)).tobytes()).hexdigest()[:16]


if __name__ == "__main__":
    print(json.dumps({name: hashed(name) for name in sys.argv[1:]}))
