"""What tangents of motions are made of: linear systems, panels, operations at many instants, steps that are kept."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import freebody as fb
from freebody.numeric.engine.engine import Engine
from freebody.numeric.options import SimulationOptions
from freebody.numeric.tangent.collocation import N_PLACES, instants, propagated
from freebody.study.simulation.simulate import with_steps

EXAMPLES = Path(__file__).parents[1] / "examples"


def example(name: str) -> fb.System:
    return fb.System.load(EXAMPLES / f"{name}.yaml")


@pytest.mark.parametrize("f", [1, 2, 7])
def test_panels_follow_the_exponential_of_a_matrix(f: int) -> None:
    """x' = A x + b with constants: x = e^(A t) (x0 + A^-1 b) - A^-1 b; seven free ones are found by iteration."""
    linalg: Any = pytest.importorskip("scipy.linalg")
    rng = np.random.default_rng(f)
    A, b, x0 = rng.normal(size=(f, f)), rng.normal(size=(f, 2)), rng.normal(size=(f, 2))
    ends = np.array([0.0, 0.2, 0.5, 0.7, 1.0])
    F = np.tile(np.hstack((A, b)), (len(instants(ends)), 1))
    x, off = propagated(ends, F, x0, np.full(2, 1e-9))
    for t, found in zip(ends, x, strict=True):
        rest = np.linalg.solve(A, b)
        assert found == pytest.approx(linalg.expm(A * t) @ (x0 + rest) - rest, rel=1e-10, abs=1e-10)
    assert off.max() < 1e-3


def test_iteration_and_elimination_find_the_same_panels() -> None:
    """The same equation for one name and for four, of which the latter is solved by elimination."""
    rng = np.random.default_rng(3)
    f, ends = 5, np.linspace(0.0, 1.0, 5)
    n = len(instants(ends))
    A, b, x0 = rng.normal(size=(n, f, f)), rng.normal(size=(n, f, 4)), rng.normal(size=(f, 4))
    every, _ = propagated(ends, np.concatenate((A, b), axis=2).reshape(n * f, -1), x0, np.full(4, 1e-9))
    for k in range(4):
        F = np.ascontiguousarray(np.concatenate((A, b[:, :, k : k + 1]), axis=2).reshape(n * f, -1))
        one, _ = propagated(ends, F, x0[:, k : k + 1], np.full(1, 1e-9))
        assert one[:, :, 0] == pytest.approx(every[:, :, k], rel=1e-12, abs=1e-12)


def test_a_stiff_panel_is_left_to_elimination() -> None:
    """x' = -1e4 x: the iteration does not settle, and the panel still has its solution, which is damped."""
    f, ends = 4, np.array([0.0, 1.0])
    F = np.tile(np.hstack((-1e4 * np.eye(f), np.zeros((f, 1)))), (N_PLACES + 2, 1))
    x, _off = propagated(ends, F, np.ones((f, 1)), np.full(1, 1e-9))
    assert np.abs(x[-1]).max() < 1.0 + 1e-9


@pytest.mark.parametrize("name", ["four_bar", "spinning_top", "cart_and_pendulum"])
def test_kept_steps_have_the_motion_between_them(name: str) -> None:
    """The dense outputs at output times are the states there, which are projected, within the tolerance."""
    times = np.linspace(0.0, 0.5, 23)
    result = with_steps(example(name), 0.5, SimulationOptions(tolerance=1e-10, every=0.5), at=times)
    (phase,) = result.phases
    assert phase.course.steps is not None
    seen, engine = phase.course.steps.states(phase.course.times), phase.engine
    n = 2 * engine.n_coordinates
    states = engine.states(phase.course)
    assert seen[:, :n] == pytest.approx(states[:, :n], abs=1e-7 * max(1.0, float(np.abs(states[:, :n]).max())))


def test_a_gradient_follows_the_motion_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of a ball with three bounces: four phases, each followed once, however many names there are."""
    runs: list[float] = []
    follow = Engine.run

    def counted(self: Engine, y: Any, until: float, *rest: Any, **given: Any) -> Any:
        runs.append(until)
        return follow(self, y, until, *rest, **given)

    monkeypatch.setattr(Engine, "run", counted)
    found = example("bouncing_ball").gradient(record=["final y"], by=["h", "e", "g"], until=2.1)
    assert len(runs) == 4
    # y = e^3 g t_1 s - g s^2/2 with s = t - t_1 (1 + 2 e + 2 e^2), t_1 = sqrt(2 h/g); by h: t_1' = t_1/(2 h)
    h, e, g, t = 1.0, 0.8, 9.81, 2.1
    t_1 = math.sqrt(2 * h / g)
    s, slope = t - t_1 * (1 + 2 * e + 2 * e * e), -(1 + 2 * e + 2 * e * e) / (2 * h) * t_1
    by_h = e**3 * g * (t_1 / (2 * h) * s + t_1 * slope) - g * s * slope
    assert found["final y"]["h"] == pytest.approx(by_h, rel=1e-9)
