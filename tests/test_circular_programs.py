"""Linear programs with circular cones beside closed forms and beside the planes that cut the cones out.

The least of a linear form in a disk of radius mu N is -mu N |u|: the support function of a disk (Boyd & Vandenberghe,
Convex Optimization, 2004, sec. 2.2.4).
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from freebody.numeric.circular_programs import CircularCone, CircularProgram

E = np.eye(3)
CONE = CircularCone(E[0], E[1], 0.4 * E[2])


def program(cost: np.ndarray, A: np.ndarray, b: np.ndarray, *cones: CircularCone) -> CircularProgram:
    return CircularProgram(cost, A, b, np.zeros((0, len(cost))), np.zeros(0), cones)


def test_least_of_a_form_in_a_disk_is_its_support_function_without_a_plane(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(CircularProgram, "_linear", lambda *_args: pytest.fail("planes are not needed"))
    found = program(np.array((3.0, -4.0, 0.0)), E[2:], np.array((2.0,)), CONE).optimum()
    assert found is not None
    x, duals, least = found
    assert least == pytest.approx(-0.4 * 2.0 * 5.0, rel=1e-12)
    assert x[:2] == pytest.approx(0.8 * np.array((-0.6, 0.8)), rel=1e-9)
    assert duals == pytest.approx([-0.4 * 5.0], rel=1e-9)  # what one more unit of N changes


def test_at_the_tip_of_a_cone_the_multipliers_are_in_the_dual_one(monkeypatch: pytest.MonkeyPatch) -> None:
    """N + u.T is least at the tip as long as mu |u| <= 1; beyond it has no least value."""
    monkeypatch.setattr(CircularProgram, "_linear", lambda *_args: pytest.fail("planes are not needed"))
    found = program(np.array((1.2, -1.6, 1.0)), np.zeros((0, 3)), np.zeros(0), CONE).optimum()
    assert found is not None
    assert found[0] == pytest.approx(np.zeros(3), abs=1e-9)
    monkeypatch.undo()
    assert program(np.array((1.8, -2.4, 1.0)), np.zeros((0, 3)), np.zeros(0), CONE).optimum() is None


@pytest.mark.parametrize("seed", range(8))
def test_optimum_of_the_cones_is_the_one_of_their_planes(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Random equations with four feet, of which forces are left open."""
    rng = np.random.default_rng(seed)
    unit = np.eye(12)
    cones = [CircularCone(unit[3 * k], unit[3 * k + 1], 0.5 * unit[3 * k + 2]) for k in range(4)]
    A = rng.normal(size=(6, 12))
    inside = np.concatenate([(*rng.uniform(-0.2, 0.2, size=2), 1.0) for _ in cones])
    whole = program(rng.normal(size=12), A, A @ inside, *cones)
    total = sum(c.load for c in cones)
    whole = replace(whole, G=np.array([total]), h=np.array([8.0]))
    exact = whole.optimum()
    monkeypatch.setattr(CircularProgram, "_inside", lambda _self: None)
    cut = whole.optimum()
    assert exact is not None
    assert cut is not None
    assert exact[2] == pytest.approx(cut[2], rel=1e-5, abs=1e-7), seed
    assert whole.cost @ exact[0] == pytest.approx(exact[2])
    assert not any(cone.is_broken(exact[0]) for cone in cones)
