"""Rattleback and tippe top beside what their motions keep, told from poses and velocities alone.

The rattleback rolls: the lowest point of its ellipsoid, half axes a_i, lies at -A u/sqrt(u . A u) from its middle
with A = diag(a_i^2) and u up, and has no velocity; the energy is kept. Its principal axes of inertia are turned against
those of the surface, so that it turns its spin round for one sense (Garcia & Hubbard, Proc. R. Soc. London A 418, 1988;
the stone of Kane & Levinson, 1982). A force at the contact of the tippe top leaves Jellett's L . r constant, with the
arm r from the mass centre to the contact, whatever the friction; the top stands on its head when it is spun fast
(Cohen, Am. J. Phys. 45, 1977).
"""

from __future__ import annotations

import numpy as np
import pytest

import freebody as fb
from example_files import FOLDER


def _motion(example: str, until: float) -> dict[str, np.ndarray]:
    """Arrays over the time, of the one body."""
    data = fb.System.load(FOLDER / f"{example}.yaml").simulate(until=until, tolerance=1e-9).dataset
    names = ("body_position", "body_velocity", "body_angular_velocity", "body_rotation_matrix")
    found = {name.removeprefix("body_"): np.asarray(data[name])[:, 0] for name in names}
    turned, spin = found["rotation_matrix"], found["angular_velocity"]
    return {**found, "spin_in_body": np.einsum("tij,ti->tj", turned, spin)}


def test_a_rattleback_rolls_with_its_energy_and_turns_its_spin_round() -> None:
    m, g, middle = 1.0, 9.81, np.array([0.0, 0.01, 0.0])  # of the ellipsoid, from the mass centre
    inertia = np.array([[2e-4, 0, -2e-5], [0, 17e-4, 0], [-2e-5, 0, 16e-4]])
    squares = np.diag([0.2**2, 0.02**2, 0.03**2])
    found = _motion("rattleback", 6.0)
    turned, velocity, spin = found["rotation_matrix"], found["velocity"], found["spin_in_body"]
    up = turned[:, 1, :]
    height = np.sqrt(np.einsum("ti,ij,tj->t", up, squares, up))
    arm = np.einsum("tij,tj->ti", turned, middle - up @ squares / height[:, None])
    assert found["position"][:, 1] == pytest.approx(height - up @ middle, abs=1e-12)
    assert np.abs(velocity + np.cross(found["angular_velocity"], arm)).max() < 1e-10
    energy = m * (velocity**2).sum(1) / 2 + np.einsum("ti,ij,tj->t", spin, inertia, spin) / 2
    assert np.ptp(energy + m * g * found["position"][:, 1]) < 1e-7 * energy[0]
    assert found["angular_velocity"][0, 1] == pytest.approx(5.0)
    assert found["angular_velocity"][-1, 1] < -0.2


def test_a_tippe_top_keeps_the_constant_of_jellett_and_stands_on_its_head() -> None:
    radius, below, inertia = 0.02, 0.006, np.array([2.62e-6, 3.2e-6, 2.62e-6])
    found = _motion("tippe_top", 2.0)
    turned = found["rotation_matrix"]
    axis = turned[:, :, 1]
    momentum = np.einsum("tij,tj->ti", turned, found["spin_in_body"] * inertia)
    kept = (momentum * (below * axis - radius * np.array([0.0, 1.0, 0.0]))).sum(1)
    assert np.ptp(kept) < 1e-8 * abs(kept[0])
    assert axis[0, 1] > 0.99
    assert axis[-1, 1] < -0.9
