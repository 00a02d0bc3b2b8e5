"""The scenes, in numbers that every engine is given.

settling    200 circles of 0.07 to 0.1 m and 1 kg, 20 in a row, fall into a box 4.96 m wide; friction 0.5, no rebound
slope       a block of 0.4 m by 0.2 m and 1 kg on a slope of 30 degrees that must hold: friction a thousandth above tan
sphere      a sphere of 1 kg and 0.1 m launched at 3 m/s without spin down a slope of 20 degrees with friction 0.3;
            rolling begins at T = 2 v0 / (g (7 mu cos - 2 sin)) with the speed 5 mu cos v0 / (7 mu cos - 2 sin)
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

GRAVITY = 9.81
N_CIRCLES, N_COLUMNS, SPACING = 200, 20, 0.24
WIDTH = N_COLUMNS * SPACING + 0.16
SETTLING_TIME = 5.0
CIRCLE_FRICTION = 0.5

SLOPE = math.radians(30.0)
SLOPE_FRICTION = 1.001 * math.tan(SLOPE)
BLOCK = (0.4, 0.2)
SLOPE_TIME = 10.0

INCLINE = math.radians(20.0)
SPHERE_RADIUS, SPHERE_SPEED, SPHERE_FRICTION, SPHERE_TIME = 0.1, 3.0, 0.3, 2.0


def circles() -> tuple[Array, Array]:
    """(200, 2) centres and (200,) radii [m]."""
    random = np.random.default_rng(7)
    k = np.arange(N_CIRCLES)
    x = (k % N_COLUMNS) * SPACING + 0.2 + random.uniform(-0.01, 0.01, N_CIRCLES)
    return np.column_stack([x, (k // N_COLUMNS) * SPACING + 0.2]), random.uniform(0.07, 0.1, N_CIRCLES)


def penetration(centres: Array, radii: Array) -> float:
    """The deepest overlap of circles with each other and with the walls [m]."""
    offset = centres[:, None] - centres[None]
    gaps = np.hypot(offset[..., 0], offset[..., 1]) - radii[:, None] - radii[None]
    np.fill_diagonal(gaps, np.inf)
    x, y = centres.T
    walls = min((x - radii).min(), (WIDTH - x - radii).min(), (y - radii).min())
    return max(0.0, -float(gaps.min()), -float(walls))


def block_centre() -> tuple[float, float]:
    """Where a block that touches the slope at the origin has its centre."""
    half = 0.5 * BLOCK[1]
    return half * math.sin(SLOPE), half * math.cos(SLOPE)


def rolling_begins() -> tuple[float, float]:
    """Time and speed of the sphere at which it begins to roll."""
    below = 7.0 * SPHERE_FRICTION * math.cos(INCLINE) - 2.0 * math.sin(INCLINE)
    return 2.0 * SPHERE_SPEED / (GRAVITY * below), 5.0 * SPHERE_FRICTION * math.cos(INCLINE) * SPHERE_SPEED / below


def settling_model() -> dict[str, Any]:
    """The circles in freebody's language."""
    centres, radii = circles()
    lines = {
        "floor": {"along": "right"},
        "left": {"along": "down", "through": [0, 0]},
        "right": {"along": "up", "through": [WIDTH, 0]},
    }
    bodies = {
        f"c{k}": {"disk": {"mass": "1 kg", "radius": float(r)}, "at": [float(x), float(y)]}
        for k, ((x, y), r) in enumerate(zip(centres, radii, strict=True))
    }
    return {
        "ground": {"lines": lines},
        "bodies": bodies,
        "loads": {"weight": {"gravity": f"{GRAVITY} m/s^2"}},
        "connections": {"it": {"contact": {"among": "all", "friction": CIRCLE_FRICTION}}},
    }


def slope_model() -> dict[str, Any]:
    """The block in freebody's language."""
    width, height = BLOCK
    shape = {"mass": "1 kg", "width": f"{width} m", "height": f"{height} m"}
    return {
        "ground": {"lines": {"slope": {"along": "-30 deg"}}},
        "bodies": {"block": {"rectangle": shape, "at": list(block_centre()), "angle": "-30 deg"}},
        "loads": {"weight": {"gravity": f"{GRAVITY} m/s^2"}},
        "connections": {"it": {"contact": {"between": ["block", "ground.slope"], "friction": SLOPE_FRICTION}}},
    }


def sphere_model() -> dict[str, Any]:
    """The sphere in freebody's language."""
    c, s = math.cos(INCLINE), math.sin(INCLINE)
    ball = {"sphere": {"mass": "1 kg", "radius": f"{SPHERE_RADIUS} m"}}
    return {
        "ground": {"lines": {"slope": {"along": "-20 deg"}}},
        "bodies": {
            "ball": ball
            | {"at": [SPHERE_RADIUS * s, SPHERE_RADIUS * c], "velocity": [SPHERE_SPEED * c, -SPHERE_SPEED * s]}
            | {"angular_velocity": 0}
        },
        "loads": {"weight": {"gravity": f"{GRAVITY} m/s^2"}},
        "connections": {"it": {"contact": {"between": ["ball", "ground.slope"], "friction": SPHERE_FRICTION}}},
    }
