"""Systems of thousands of bodies: the same start as by dense matrices, at a cost in proportion to their number."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from conftest import calls_of
from freebody import CannotAnswer, System
from freebody.numeric import jets, outward, placing, start
from freebody.numeric.jets import GradientEntries
from freebody.numeric.reference import Reference
from freebody.numeric.sparse import SparseRows
from freebody.numeric.split import Split
from freebody.study.simulation.simulator import Simulator


def chain(n: int, **of_link: Any) -> dict[str, Any]:
    """n rods of 1 m in series, the first pinned to the origin. of_link: what each is given, by a function of its
    number."""
    bodies = {f"L{k}": {"rod": {"mass": "1 kg", "length": "1 m"}, **{key: f(k) for key, f in of_link.items()}}
              for k in range(n)}  # fmt: skip
    pins = {f"J{k}": {"pin": [f"L{k - 1}.end" if k else "ground.O", f"L{k}.start"]} for k in range(n)}
    return {"bodies": bodies, "connections": pins, "loads": {"weight": {"gravity": "9.81 m/s^2"}}}


def four_bars(n: int) -> dict[str, Any]:
    """n + 1 equal cranks, one beside the other, joined by n couplers: closed loops, of which all but one are redundant
    for the velocities while the cranks are parallel."""
    rod = {"rod": {"mass": "1 kg", "length": "1 m"}}
    bodies: dict[str, Any] = {f"crank{k}": rod | {"angle": "70 deg"} for k in range(n + 1)}
    bodies |= {f"coupler{k}": rod | {"angle": 0} for k in range(n)}
    bodies["crank0"] = bodies["crank0"] | {"angular_velocity": -1.0}
    pins = {f"A{k}": [f"ground.A{k}", f"crank{k}.start"] for k in range(n + 1)}
    pins |= {f"B{k}": [f"crank{k}.end", f"coupler{k}.start"] for k in range(n)}
    pins |= {f"C{k}": [f"coupler{k}.end", f"crank{k + 1}.end"] for k in range(n)}
    ground = {"points": {f"A{k}": [k, 0] for k in range(n + 1)}}
    return {"ground": ground, "bodies": bodies, "connections": {name: {"pin": ends} for name, ends in pins.items()}}


SPATIAL_CHAIN = {
    "space": True,
    "bodies": {
        f"L{k}": {"rod": {"mass": "1 kg", "length": "1 m"}, "turned": f"{7 * k + 3} deg about z"} for k in range(6)
    },
    "connections": {f"J{k}": {"spherical": [f"L{k - 1}.end" if k else "ground.O", f"L{k}.start"]} for k in range(6)},
}


@pytest.fixture
def small_is_large(monkeypatch: pytest.MonkeyPatch) -> None:
    for module in (jets, placing, start, outward):
        monkeypatch.setattr(module, "LARGE", 3)


# -- a chain of two thousand links ------------------------------------------------------------
def test_a_chain_of_two_thousand_links_is_assembled_where_its_angles_put_it():
    """Joint k is at the sum of e(angle) of the links before it, and moves with the sum of angle' n(angle)."""
    n = 2000
    random = np.random.default_rng(1)
    angles, rates = random.uniform(-1.0, 1.0, n), random.standard_normal(n)
    given = {"angle": lambda k: float(angles[k]), "angular_velocity": lambda k: float(rates[k])}
    reference = Reference(System.from_data(chain(n, **given)))
    q = reference.assemble()
    poses, velocities = reference.by_body(q, reference.velocities(q))
    along = np.column_stack([np.cos(angles), np.sin(angles)])
    across = np.column_stack([-np.sin(angles), np.cos(angles)]) * rates[:, None]
    assert np.abs(poses[:, :2] - (np.cumsum(along, axis=0) - along / 2)).max() < 1e-9
    assert np.abs(poses[:, 2] - angles).max() < 1e-12
    assert np.abs(velocities[:, :2] - (np.cumsum(across, axis=0) - across / 2)).max() < 1e-9
    assert np.abs(velocities[:, 2] - rates).max() < 1e-9


def test_links_of_which_nothing_is_said_are_put_one_after_the_other():
    reference = Reference(System.from_data(chain(500)))
    poses, _ = reference.by_body(q := reference.assemble(), np.zeros_like(q))
    assert np.abs(poses - np.column_stack([np.arange(500) + 0.5, np.zeros((500, 2))])).max() < 1e-9


def test_twice_as_many_links_cost_twice_as_much():
    """From data to the packed system at its start; by the calls of functions, which no other process changes."""
    few, many = (calls_of(lambda n=n: Simulator(System.from_data(chain(n)))) for n in (200, 400))
    assert many < 2.2 * few


def test_a_long_chain_hanging_from_both_ends_is_closed():
    """The start says only where the links are roughly; the last one is pinned to the ground too."""
    n = 150
    roughly = {"near": lambda k: {"angle": f"{60 - 120 * k / (n - 1)} deg"}}
    model = chain(n, **roughly)
    model["ground"] = {"points": {"O": [0, 0], "far": [0.8 * n, 0]}}
    model["connections"]["last"] = {"pin": [f"L{n - 1}.end", "ground.far"]}
    reference = Reference(System.from_data(model))
    poses, _ = reference.by_body(q := reference.assemble(), np.zeros_like(q))
    along = np.column_stack([np.cos(poses[:, 2]), np.sin(poses[:, 2])])
    ends = np.cumsum(along, axis=0)
    assert np.abs(poses[:, :2] - (ends - along / 2)).max() < 1e-8
    assert np.abs(ends[-1] - [0.8 * n, 0.0]).max() < 1e-8


# -- the same as small ones -------------------------------------------------------------------
@pytest.mark.parametrize("model", [chain(5, angle=lambda k: 0.3 * k), four_bars(3), SPATIAL_CHAIN])
def test_sparse_and_dense_matrices_give_the_same_start(model: dict[str, Any], monkeypatch: pytest.MonkeyPatch):
    system = System.from_data(model)
    dense = Reference(system)
    q = dense.assemble()
    v = dense.velocities(q)
    for module in (jets, placing, start, outward):
        monkeypatch.setattr(module, "LARGE", 3)
    sparse = Reference(system)
    found = sparse.assemble()
    assert np.abs(found - q).max() < 1e-9
    assert np.abs(sparse.velocities(found) - v).max() < 1e-9


@pytest.mark.usefixtures("small_is_large")
def test_a_large_system_says_as_well_what_contradicts_itself():
    model = four_bars(2)
    model["bodies"]["crank1"] = model["bodies"]["crank1"] | {"angular_velocity": 2.0}
    reference = Reference(System.from_data(model))
    with pytest.raises(CannotAnswer, match=r"velocities.* contradict each other"):
        reference.velocities(reference.assemble())


@pytest.mark.usefixtures("small_is_large")
def test_a_large_system_that_cannot_be_assembled_says_which_gap_stays_open():
    model = chain(3)
    model["ground"] = {"points": {"O": [0, 0], "far": [3.5, 0]}}
    model["connections"]["last"] = {"pin": ["L2.end", "ground.far"]}
    with pytest.raises(CannotAnswer, match="cannot be assembled"):
        Reference(System.from_data(model)).assemble(n_starts=1)


@pytest.mark.parametrize("seed", range(4))
def test_the_smallest_move_is_that_of_the_singular_values(seed: int):
    """Rows that say the same thing, by D not equal to one."""
    random = np.random.default_rng(seed)
    J = random.standard_normal((5, 9)) * (random.random((5, 9)) < 0.5)
    J = np.vstack([J, J[0] - 2.0 * J[1], J[2]])
    D = random.uniform(0.5, 2.0, 9)
    b = J @ random.standard_normal(9)
    rows = SparseRows([GradientEntries({k: float(x) for k, x in enumerate(row) if x}) for row in J], 9)
    assert np.abs(rows.least(D, b) - Split(J, D).least(b)).max() < 1e-9
    assert np.array_equal(rows.whole, J)
    assert np.array_equal(rows.any(axis=0), J.any(axis=0))
