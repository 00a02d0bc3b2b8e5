"""The benchmark problems: sizes, start states, exact reductions, and the models in freebody's language.

Every link is a uniform rod of 1 m and 1 kg in the x-y plane, gravity 9.81 m/s^2 along -y, angles from +x anticlockwise.

chain       n links in series, the first hinged to the origin. Link k starts at joint k and ends at joint k + 1.
N-four-bar  N windows (IFToMM benchmark A02): N + 1 cranks A_i B_i hinged to the ground at (i, 0), N couplers
            B_i B_(i+1). It starts with upright cranks, B_0 moving at 1 m/s along +x.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
# number of calls -> seconds per evaluation, absolute angular accelerations [rad/s^2] where the engine shows them
Evaluations = Callable[[int], tuple[float, Array | None]]

GRAVITY = 9.81
ACCELERATION_SIZES = (1, 10, 100, 200, 500, 2000)  # n = 1 shows what a call costs from Python
CHAIN_SIZES = (10, 50, 200)
CHAIN_TOLERANCE = 1e-6  # m, every joint at t = 1 s
WINDOWS = (1, 40)
FOUR_BAR_TIME = 10.0
FOUR_BAR_TOLERANCES = (1e-4, 1e-6)  # m, B_0 at the end; the first one holds for the fresh process too


def chain_state(n: int) -> tuple[Array, Array]:
    """Random absolute angles [rad] and angular velocities [rad/s] of n links, the same for every engine."""
    random = np.random.default_rng(n)
    return random.uniform(-np.pi, np.pi, n), random.standard_normal(n)


def relative(absolute: Array) -> Array:
    """Joint angles (or rates) from absolute ones."""
    return np.diff(absolute, prepend=0.0)


def joint_positions(absolute_angles: Array) -> Array:
    """(n, 2): where each link of the chain ends [m]."""
    return np.cumsum(np.column_stack([np.cos(absolute_angles), np.sin(absolute_angles)]), axis=0)


def farthest(positions: Array, reference: Array) -> float:
    """The largest distance between corresponding points [m]; infinite when something is not a number."""
    distance = float(np.max(np.linalg.norm(positions - reference, axis=-1)))
    return distance if np.isfinite(distance) else np.inf


def four_bar_start(n_windows: int) -> tuple[Array, Array, Array, Array]:
    """Angles and angular velocities: cranks (N + 1), then couplers (N)."""
    n = n_windows
    return np.full(n + 1, np.pi / 2), np.full(n + 1, -1.0), np.zeros(n), np.zeros(n)


def _rod(start: Array, angle: float, center_velocity: Array, spin: float) -> dict[str, Any]:
    return {
        "rod": {"mass": "1 kg", "length": "1 m"},
        "at": {"start": [float(start[0]), float(start[1])]},
        "angle": float(angle),
        "velocity": [float(center_velocity[0]), float(center_velocity[1])],
        "angular_velocity": float(spin),
    }


def chain_model(angles: Array, rates: Array) -> dict[str, Any]:
    """The chain at a given state, for `System.from_data`."""
    along = np.column_stack([np.cos(angles), np.sin(angles)])
    across = np.column_stack([-np.sin(angles), np.cos(angles)]) * rates[:, None]
    starts, velocities = np.cumsum(along, axis=0) - along, np.cumsum(across, axis=0) - across / 2
    n = len(angles)
    return {
        "title": f"Chain of {n} rods",
        "bodies": {f"link{k}": _rod(starts[k], angles[k], velocities[k], rates[k]) for k in range(n)},
        "connections": {
            f"joint{k}": {"pin": [f"link{k - 1}.end" if k else "ground.O", f"link{k}.start"]} for k in range(n)
        },
        "loads": {"weight": {"gravity": f"{GRAVITY} m/s^2"}},
    }


def chain_without_start(n: int) -> dict[str, Any]:
    """The chain without a start: half of the values of a model."""
    model = chain_model(np.zeros(n), np.zeros(n))
    rod = {key: value for key, value in model["bodies"]["link0"].items() if key == "rod"}
    return model | {"bodies": {f"link{k}": rod for k in range(n)}}


def poses_and_velocities(angles: Array, rates: Array) -> tuple[Array, Array]:
    """(n, 3) x, y of the centre and angle of every link, and their rates."""
    along = np.column_stack([np.cos(angles), np.sin(angles)])
    across = np.column_stack([-np.sin(angles), np.cos(angles)]) * rates[:, None]
    centers, velocities = np.cumsum(along, axis=0) - along / 2, np.cumsum(across, axis=0) - across / 2
    return np.column_stack([centers, angles]), np.column_stack([velocities, rates])


def four_bar_model(n_windows: int) -> dict[str, Any]:
    """The N-four-bar at its start, for `System.from_data`."""
    up, half, right = np.pi / 2, np.array([0.5, 0.0]), np.array([1.0, 0.0])
    n = n_windows
    bodies = {f"crank{k}": _rod(np.array([k, 0.0]), up, half, -1.0) for k in range(n + 1)}
    bodies |= {f"coupler{k}": _rod(np.array([k, 1.0]), 0.0, right, 0.0) for k in range(n)}
    pins = {f"A{k}": [f"ground.A{k}", f"crank{k}.start"] for k in range(n + 1)}
    pins |= {f"B{k}": [f"crank{k}.end", f"coupler{k}.start"] for k in range(n)}
    pins |= {f"C{k}": [f"coupler{k}.end", f"crank{k + 1}.end"] for k in range(n)}
    return {
        "title": f"Four-bar with {n} windows",
        "ground": {"points": {f"A{k}": [k, 0] for k in range(n + 1)}},
        "bodies": bodies,
        "connections": {name: {"pin": ends} for name, ends in pins.items()},
        "loads": {"weight": {"gravity": f"{GRAVITY} m/s^2"}},
    }
