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


def _tippe_top(spin: float, tilt: float, mu: float, until: float) -> tuple[np.ndarray, np.ndarray]:
    """cos of the tilt, and the energy beyond the least one at that tilt; at first it turns about the vertical."""
    text = (FOLDER / "tippe_top.yaml").read_text("utf-8")
    for old, new in (
        ("n: 155 rad/s", f"n: {spin} rad/s"),
        ("mu: 0.3", f"mu: {mu}"),
        ("0.1 rad about z", f"{tilt} rad about z"),
        ("[0, n, 0]", f"[n*sin({tilt}), n*cos({tilt}), 0]"),
    ):
        assert old in text
        text = text.replace(old, new)
    data = fb.System.from_text(text).simulate(until=until, tolerance=1e-9).dataset
    names = ("body_position", "body_velocity", "body_angular_velocity", "body_rotation_matrix")
    place, velocity, spins, turned = (np.asarray(data[name])[:, 0] for name in names)
    m, g, radius, below, inertia = 0.02, 9.81, 0.02, 0.006, np.array([2.62e-6, 3.2e-6, 2.62e-6])
    x, in_body = turned[:, 1, 1], np.einsum("tij,ti->tj", turned, spins)
    up = np.array([0.0, 1.0, 0.0])
    jellett = ((np.einsum("tij,tj->ti", turned, in_body * inertia)) * (radius * up - below * turned[:, :, 1])).sum(1)
    energy = m * (velocity**2).sum(1) / 2 + (inertia * in_body**2).sum(1) / 2 + m * g * place[:, 1]
    share = inertia[0] * (1 - x**2) + inertia[1] * (x - below / radius) ** 2
    least = m * g * (radius - below * x) + jellett**2 / (2 * radius**2 * share)
    assert np.all(np.diff(energy) < 1e-9 * energy[0])
    return x, energy - least


def test_a_tippe_top_does_not_turn_over_below_the_spin_whose_energy_lifts_it() -> None:
    """With Jellett's constant kept, n C (R - a) = n' C (R + a) on its head, and C n^2/2 must pay for C n'^2/2 + 2 m g
    a: n >= (1 + a/R) sqrt(m g R/C), 45.5 rad/s."""
    bound = 1.3 * np.sqrt(0.02 * 9.81 * 0.02 / 3.2e-6)
    x, above = _tippe_top(0.95 * bound, 0.5, 0.02, 2.0)
    assert x.min() > -0.9
    assert above.min() > -1e-9


@pytest.mark.parametrize(("share", "falls"), [(0.7, True), (1.4, False)])
def test_a_tippe_top_stays_on_its_head_above_a_spin(share: float, falls: bool) -> None:
    """The energy of a top that turns about the vertical with Jellett's constant l = C n (R + a) at cos(tilt) = x,

        m g (R - a x) + l^2/(2 R^2 (A (1 - x^2) + C (x - a/R)^2)),

    is least at x = -1 where n^2 > m g a/C (1 + a/R)^2/(1 + a/R - A/C), and friction leads to where it is least
    (Ebenfeld & Scheck, Ann. Phys. 243, 1995; Bou-Rabee, Marsden & Romero, SIAM J. Appl. Dyn. Syst. 3, 2004)."""
    ratio, eccentric = 2.62 / 3.2, 0.3
    stands = np.sqrt(0.02 * 9.81 * 0.006 / 3.2e-6) * (1 + eccentric) / np.sqrt(1 + eccentric - ratio)
    x, above = _tippe_top(share * stands, 3.0, 0.02, 4.0)
    assert above.min() > -1e-9
    assert (x[-1] > -0.5) == falls
    assert falls or (x.max() < -0.9 and x[-1] < x[0])
