"""Friction in planes at one instant: what is found obeys the circular law, whatever touches."""

from __future__ import annotations

import math

import numpy as np
import pytest

from freebody.numeric.contact.forces import contact_forces
from freebody.numeric.contact.problem import ContactProblem, FrictionProblemRow, RowState

SEED = 5


def corners(n: int, mu: float, rng: np.random.Generator) -> ContactProblem:
    """Velocities at n corners of a face of a cube that arrives at a plane, flat or askew."""
    m, a = 0.1, 0.05
    places = rng.permutation([(x, -1.0, z) for x in (-1.0, 1.0) for z in (-1.0, 1.0)])[:n] * a / 2
    if rng.random() < 0.5:
        places = places + 0.1 * a * rng.normal(size=places.shape)
    J = np.array([np.r_[d, np.cross(p, d)] for d in np.eye(3)[[1, 2, 0]] for p in places])
    v = np.r_[rng.normal(size=3), 30.0 * rng.normal(size=3)]
    v[1] = -abs(v[1])
    inverse = np.array([1 / m] * 3 + [6 / (m * a * a)] * 3)
    rubs = tuple(FrictionProblemRow(n + k, (mu, mu), (mu, mu), normals=(k,), across=2 * n + k) for k in range(n))
    return ContactProblem((J * inverse) @ J.T, J @ v, tuple(range(n)), rubs)


@pytest.mark.parametrize("mu", [0.1, 0.4, 1.0])
@pytest.mark.parametrize("n", [1, 2, 3, 4])
def test_impulses_of_corners_obey_the_circular_law(n: int, mu: float) -> None:
    rng = np.random.default_rng(SEED)
    for _ in range(20):
        problem = corners(n, mu, rng)
        found = contact_forces(problem)
        assert found.is_found, f"seed {SEED}"
        size = np.abs(found.forces).max()
        a = problem.A @ found.forces + problem.b
        fastest = np.abs(problem.b).max()
        for rub in problem.dry_friction:
            N, T, slip = found.forces[rub.normals[0]], found.forces[[rub.row, rub.across]], a[[rub.row, rub.across]]
            assert -1e-9 * size <= N
            assert a[rub.normals[0]] >= -1e-9 * fastest
            assert N * a[rub.normals[0]] == pytest.approx(0.0, abs=1e-9 * size * fastest)
            assert np.linalg.norm(T) <= mu * N + 1e-8 * size
            speed = np.linalg.norm(slip)
            if speed > 1e-8 * fastest:
                assert pytest.approx(-mu * N * slip / speed, abs=1e-8 * size) == T


def test_block_starts_to_slip_against_the_resultant_with_its_kinetic_coefficient() -> None:
    """m = 2, N = 20; pulled by (3, 4) F it holds up to |T| = 5 F = 0.5 N, then it goes along the pull."""
    rub = FrictionProblemRow(1, (0.5, 0.5), (0.4, 0.4), normals=(0,), across=2)
    for F, slips in ((1.99, False), (2.01, True)):
        problem = ContactProblem(np.eye(3) / 2, np.array((-10.0, 1.5 * F, 2.0 * F)), (0,), (rub,))
        found = contact_forces(problem)
        if slips:
            assert found.mode[1] is RowState.FORWARD
            assert dict(found.directions)[1] == pytest.approx(math.atan2(4, 3))
            assert found.forces == pytest.approx((20.0, -8.0 * 0.6, -8.0 * 0.8))
        else:
            assert found.mode[1] is RowState.STICKING
            assert found.forces == pytest.approx((20.0, -3.0 * F, -4.0 * F))
