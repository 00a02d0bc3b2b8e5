"""Lemke's pivots against enumeration, closed cases and their own conditions."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

from freebody.numeric.contact.complementarity import Ended, lemke


def by_enumeration(M, q):
    """All solutions with a regular basis."""
    n = len(q)
    found = []
    for active in product((False, True), repeat=n):
        rows = np.flatnonzero(active)
        z = np.zeros(n)
        if len(rows):
            block = M[np.ix_(rows, rows)]
            if abs(np.linalg.det(block)) < 1e-12:
                continue
            z[rows] = np.linalg.solve(block, -q[rows])
        w = M @ z + q
        if z.min() >= -1e-12 and w.min() >= -1e-12:
            found.append(z)
    return found


def assert_complementary(M, q, found):
    assert (found.z >= 0.0).all()
    assert (found.w >= 0.0).all()
    assert (found.z * found.w == 0.0).all()
    size = np.abs(M) @ found.z + np.abs(q)
    np.testing.assert_allclose(M @ found.z + q, found.w, atol=1e-10 * size.max())


@pytest.mark.parametrize("seed", range(60))
def test_agrees_with_enumeration_on_matrices_with_one_solution(seed):
    print("seed", seed)
    rng = np.random.default_rng(seed)
    n = int(rng.integers(1, 7))
    root = rng.normal(size=(n, n))
    skew = rng.normal(size=(n, n))
    M = root @ root.T + 0.1 * np.eye(n) + skew - skew.T  # positive definite, not symmetric
    q = rng.normal(size=n)
    found = lemke(M, q)
    solutions = by_enumeration(M, q)
    assert found.is_solved
    assert len(solutions) == 1
    np.testing.assert_allclose(found.z, solutions[0], rtol=1e-8, atol=1e-10)


@pytest.mark.parametrize("seed", range(60))
def test_what_it_solves_of_any_matrix_is_among_the_enumerated_solutions(seed):
    print("seed", seed)
    rng = np.random.default_rng(1000 + seed)
    n = int(rng.integers(2, 6))
    M, q = rng.normal(size=(n, n)), rng.normal(size=n)
    found = lemke(M, q)
    solutions = by_enumeration(M, q)
    if found.is_solved:
        assert_complementary(M, q, found)
        assert any(np.allclose(found.z, z, rtol=1e-7, atol=1e-9) for z in solutions)
    else:
        assert found.ended is Ended.RAY


def test_a_ray_is_told_where_no_solution_exists():
    found = lemke(np.array([[-1.0]]), np.array([-1.0]))
    assert found.ended is Ended.RAY
    assert np.isnan(found.z).all()


def test_nothing_to_do_is_solved_by_zero():
    found = lemke(-np.eye(3), np.array([0.0, 1.0, 2.0]))
    assert found.is_solved
    assert (found.z == 0.0).all()
    assert lemke(np.zeros((0, 0)), np.zeros(0)).is_solved


def test_murtys_exponential_example_is_solved():
    # Murty 1978: M = I + 2 (lower triangle), q = -1: 2^n - 1 pivots of his method, z = (0, .., 0, 1) reversed
    n = 8
    M = np.triu(2.0 * np.ones((n, n)), 1) + np.eye(n)
    found = lemke(M, -np.ones(n))
    expected = np.zeros(n)
    expected[-1] = 1.0
    assert found.is_solved
    np.testing.assert_allclose(found.z, expected, atol=1e-14)


def test_a_problem_full_of_ties_does_not_cycle():
    # redundant supports under one load: a singular matrix of ones
    n = 12
    found = lemke(np.ones((n, n)), -np.ones(n))
    assert found.is_solved
    assert found.z.sum() == pytest.approx(1.0, rel=1e-13)


@pytest.mark.parametrize("seed", range(20))
def test_singular_semidefinite_matrices_are_solved(seed):
    print("seed", seed)
    rng = np.random.default_rng(2000 + seed)
    J = rng.normal(size=(9, 4))
    # b = J f lies in the range, as accelerations do; J J^T has rank 4
    M, q = J @ J.T, J @ rng.normal(size=4)
    found = lemke(M, q)
    assert found.is_solved
    assert_complementary(M, q, found)


def test_units_of_the_rows_do_not_matter():
    rng = np.random.default_rng(5)
    root = rng.normal(size=(5, 5))
    M, q = root @ root.T + 0.1 * np.eye(5), rng.normal(size=5)
    D = 10.0 ** np.array([-6, -3, 0, 3, 6])
    plain, scaled = lemke(M, q), lemke(D[:, None] * M * D, D * q)
    assert scaled.is_solved
    np.testing.assert_allclose(D * scaled.z, plain.z, rtol=1e-9, atol=1e-12)


def test_three_hundred_rows_take_at_most_two_pivots_a_row():
    rng = np.random.default_rng(3)
    J = rng.normal(size=(300, 200))
    M, q = J @ J.T / 200.0, J @ rng.normal(size=200)
    found = lemke(M, q)
    assert found.is_solved
    assert_complementary(M, q, found)
    assert found.n_pivots <= 600
