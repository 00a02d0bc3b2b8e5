"""A planar model is a spatial one with planar connections: every planar example, connection and load, written in space
by program, moves, reacts and has its events as in the plane."""

from __future__ import annotations

import copy
import functools
import re
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest

import freebody as fb
import freebody.connections
import freebody.loads
from example_files import document, names_a_file, plain
from freebody.connections.base import Connection
from freebody.errors import CannotAnswer, InputError
from freebody.language.document import Document
from freebody.language.units import LENGTH
from freebody.loads.base import Load
from freebody.numeric.engine.course import Trajectory
from freebody.numeric.jets import Array
from freebody.numeric.rotation import matrix, rotation_vector
from freebody.study.simulation.simulate import Simulation
from freebody.study.simulation.simulator import Simulator

PLANAR = [name for name, data in plain().items() if "space" not in data and not names_a_file(data)]
# what closes in mid-motion is for the plane only
CLOSING = [
    name
    for name in PLANAR
    if any(str(c.get("closes", "")).startswith("when") for c in plain()[name].get("connections", {}).values())
]
CURVED = [  # as are circles that roll on curves
    name for name in PLANAR if any("rolling_on_curve" in c for c in plain()[name].get("connections", {}).values())
]
STRETCHED_ROUND = [  # and strings that stretch round wheels
    name
    for name in PLANAR
    if any(
        re.search(r"wound on|over|under", " ".join(load["elastic_string"].get("path", ())))
        for load in plain()[name].get("loads", {}).values()
        if "elastic_string" in load
    )
]
EXAMPLES = [name for name in PLANAR if name not in (*CLOSING, *CURVED, *STRETCHED_ROUND)]
# nothing can touch or rub: any pose near by is possible
SMOOTH = [
    name
    for name in EXAMPLES
    if not any(
        kind == "contact" or "friction" in spec
        for c in plain()[name].get("connections", {}).values()
        for kind, spec in c.items()
    )
]
# with 1e-12 round-off makes this wedge, which stays at rest, slip and stick again in the plane as well
TOLERANCES = {"wedge_under_load": 1e-9}
# of a start that nothing tells several poses are nearest to the one in which all is at the origin: (x, y, angle)
NEAR = {
    "multi_bar_platform": {
        "B1": (0.13, 0.95, 0.25),
        "L1": (-0.65, 0.32, 0.74),
        "L2": (0.83, 0.44, 1.93),
        "L3": (-1.0, 1.0, 3.14),
        "L4": (1.08, 1.08, -0.56),
    }
}
TOLERANCE, CLOSE, SEED = 1e-12, 1e-9, 5
# what cannot be said in space, and why
REFUSED = {
    "moreau": "time stepping.*is for models of the plane",
    "closes": "connections close in mid-motion in models of the plane only",
    "curves": "rolling on a curve is for models of the plane",
}
LOADS_ABOUT = ("torque", "motor", "torsional_spring", "torsional_damper", "angular_impulse")

example = pytest.mark.parametrize("name", EXAMPLES)


# -- writing a planar model in space ----------------------------------------------------------
def in_space(data: dict[str, Any]) -> dict[str, Any]:
    """A model of the plane written in space: every moving body has a planar connection. Components stay as they are."""
    data = copy.deepcopy(data) | {"space": True}
    for name, body in data["bodies"].items():
        body = data["bodies"][name] = {body: None} if isinstance(body, str) else body
        for place in (body, body.get("near") or {}):
            if "angle" in place:
                place["turned"] = f"{place.pop('angle')} about z"
        if "angular_velocity" in body:
            body["angular_velocity"] = [0, 0, body["angular_velocity"]]
    planes = {
        f"plane_of_{name}": {"planar": {"body": name}} for name, body in data["bodies"].items() if not body.get("fixed")
    }
    data["connections"] = {**data.get("connections", {}), **planes}
    for load in data.get("loads", {}).values():
        for kind in LOADS_ABOUT:
            if kind in load:
                load[kind]["about"] = "z"
    return data


def without_questions(data: dict[str, Any]) -> dict[str, Any]:
    return {key: value for key, value in data.items() if key != "questions"}


@functools.cache
def both(name: str) -> tuple[fb.System, fb.System]:
    """An example in the plane and in space."""
    data = without_questions(document(name))
    if name in NEAR:
        data = copy.deepcopy(data)
        for body, (x, y, angle) in NEAR[name].items():
            data["bodies"][body]["near"] = {"at": [f"{x} m", f"{y} m"], "angle": f"{angle} rad"}
    return fb.System.from_data(data), fb.System.from_data(in_space(data))


@functools.cache
def moved(name: str) -> tuple[Simulation, Simulation]:
    """Their motions."""
    flat, spatial = (
        fb.simulate(system, 1.0, tolerance=TOLERANCES.get(name, TOLERANCE), every=0.02) for system in both(name)
    )
    return flat, spatial


# -- comparing --------------------------------------------------------------------------------
def assert_close(found: Array, wanted: Array, what: str, floor: float = 1.0) -> None:
    """Equal to 1e-9 of the largest value, or of the floor."""
    assert found.shape == wanted.shape, what
    size = max(float(np.nanmax(np.abs(wanted), initial=0.0)), floor)
    gap = np.abs(found - wanted)
    assert np.isfinite(found).all() == np.isfinite(wanted).all(), what
    assert float(np.nanmax(gap, initial=0.0)) < CLOSE * size, f"{what}: {np.nanmax(gap)} of {size}"


def assert_same_places(flat: Trajectory, spatial: Trajectory) -> None:
    """Bodies are at the same places, turned by the same angles about z, and nowhere outside the plane."""
    rotation = spatial.rotation
    assert rotation is not None
    assert_close(spatial.times, flat.times, "times")
    assert_close(spatial.poses[:, :, :2], flat.poses[:, :, :2], "places")
    assert np.abs(spatial.poses[:, :, 2]).max() < 1e-12
    half = 0.5 * flat.poses[:, :, 2]
    w, x, y, z = np.moveaxis(rotation.quaternions, -1, 0)
    assert_close(z * np.cos(half), w * np.sin(half), "angles")  # of whole turns nothing is said
    assert max(np.abs(x).max(), np.abs(y).max()) < 1e-12
    assert_close(spatial.velocities[:, :, :2], flat.velocities[:, :, :2], "velocities")
    assert_close(rotation.velocities[:, :, 2], flat.velocities[:, :, 2], "angular velocities")
    assert_close(rotation.accelerations[:, :, 2], flat.accelerations[:, :, 2], "angular accelerations")


@dataclass(frozen=True)
class Rows:
    """Multipliers by the name of their row."""

    values: dict[str, Array]
    unique: dict[str, Any]

    @classmethod
    def of(cls, system_rows: Any, course: Trajectory) -> Rows:
        names = [row.name for row in system_rows]
        return cls(dict(zip(names, course.multipliers.T, strict=True)), dict(zip(names, course.unique.T, strict=True)))


def assert_same_reactions(flat: Rows, spatial: Rows) -> None:
    assert set(flat.values) <= set(spatial.values)
    added = set(spatial.values) - set(flat.values)
    own = {name.partition(".")[0] for name in flat.values}  # a weld holds more in space
    assert all(name.startswith("plane_of_") or name.partition(".")[0] in own for name in added)
    size = max([1.0, *(float(np.nanmax(np.abs(v), initial=0.0)) for v in flat.values.values())])
    for name, values in flat.values.items():
        where = flat.unique[name] & spatial.unique[name]
        assert_close(spatial.values[name][where], values[where], name, size)
        assert (flat.unique[name] == spatial.unique[name]).all(), f"{name} is unique in one of the two only"
    for name in added:  # nothing pushes out of the plane
        alone = spatial.values[name][spatial.unique[name]]
        assert np.abs(alone).max(initial=0.0) < 1e-9 * size, name


# -- examples ---------------------------------------------------------------------------------
@example
def test_a_planar_example_moves_in_space_as_in_the_plane(name: str) -> None:
    flat, spatial = moved(name)
    assert spatial.status is flat.status
    assert spatial.message == flat.message
    assert_same_places(flat.course, spatial.course)
    assert set(spatial.series) == set(flat.series)
    for measure, wanted in flat.series.items():
        for order, (found, values) in enumerate(zip(spatial.series[measure], wanted, strict=True)):
            assert_close(found, values, f"{measure}, derivative {order}")


@example
def test_a_planar_example_has_the_same_reactions_in_space(name: str) -> None:
    flat, spatial = moved(name)
    assert_same_reactions(Rows.of(flat.rows, flat.course), Rows.of(spatial.rows, spatial.course))


@example
def test_a_planar_example_has_the_same_energies_in_space(name: str) -> None:
    flat, spatial = moved(name)  # a torque has a potential in the plane; in space it does work
    assert_close(spatial.energy.kinetic, flat.energy.kinetic, "kinetic energy")
    given = [e.work - e.potential + e.potential[0] for e in (spatial.energy, flat.energy)]
    assert_close(given[0], given[1], "what loads gave")


@example
def test_a_planar_example_has_the_same_events_in_space(name: str) -> None:
    """Those of contacts, and for every measure that moves that it passes a value, each at another time."""
    flat, spatial = moved(name)
    units = {LENGTH: " m"}
    asked = [
        f"{m} = {float(values[15 + 2 * j : 17 + 2 * j].mean())!r}{units.get(flat.system.measures[m].dimension, '')}"
        for j, (m, (values, rate, _second)) in enumerate(flat.series.items())
        if m in flat.system.measures
        and np.ptp(values) > 1e-3  # of states there are no events
        and np.abs(rate[15 + 2 * j : 17 + 2 * j]).min() > 1e-3  # a value that it does not touch
    ]
    if asked:
        flat, spatial = (
            fb.simulate(s, 1.0, tolerance=TOLERANCE, every=0.1, events=asked) for s in (flat.system, spatial.system)
        )
    assert [(e.kind, e.name) for e in spatial.events] == [(e.kind, e.name) for e in flat.events]
    times = np.array([[e.time for e in result.events] for result in (flat, spatial)])
    assert_close(times[1], times[0], "times of events")


def raised(simulator: Simulator, flat: Simulator, poses: Array, velocities: Array) -> Array:
    """A state of the plane as one of space."""
    numbers, n = simulator.numbers, len(poses)
    q, v = np.zeros((n, 6)), np.zeros((n, 6))
    for k, body in enumerate(simulator.system.all_moving):
        x, y, angle = poses[k]
        frame = matrix(np.array([0.0, 0.0, angle])) @ numbers.principal(body.name)
        q[k] = [x, y, 0.0, *rotation_vector(frame)]
        v[k] = [velocities[k, 0], velocities[k, 1], 0.0, *(frame.T @ [0.0, 0.0, velocities[k, 2]])]
    return simulator.engine.state(q, v)


def assert_same_from_anywhere(systems: tuple[fb.System, fb.System], until: float) -> None:
    flat, spatial = map(Simulator, systems)
    reference = flat.reference
    print("seed", SEED)
    here = reference.assemble()
    try:
        q, v = reference.wander(here, np.random.default_rng(SEED), 0.2)
    except CannotAnswer:  # next to a pose in which the mechanism locks
        q, v = reference.wander(here, np.random.default_rng(SEED), 0.01)
    poses, velocities = reference.by_body(q, v)
    outputs = np.linspace(0.0, until, 21)
    one = flat.run(until, tolerance=TOLERANCE, outputs=outputs, state=flat.engine.state(poses, velocities))
    state = raised(spatial, flat, poses, velocities)
    other = spatial.run(until, tolerance=TOLERANCE, outputs=outputs, state=state)
    assert one.status is other.status, (one.message, other.message)
    assert_same_places(one, other)
    rows = [s.system.constraint_rows if s.bounded is None else s.system.rows for s in (flat, spatial)]
    assert_same_reactions(Rows.of(rows[0], one), Rows.of(rows[1], other))


@pytest.mark.parametrize("name", SMOOTH)
def test_a_planar_example_moves_in_space_as_in_the_plane_from_any_state(name: str) -> None:
    assert_same_from_anywhere(both(name), 0.5)


@pytest.mark.parametrize("name", CLOSING)
def test_closing_in_mid_motion_is_refused_in_space(name: str) -> None:
    with pytest.raises(InputError, match=REFUSED["closes"]):
        fb.System.from_data(in_space(without_questions(document(name))))


@pytest.mark.parametrize("name", CURVED)
def test_curves_in_a_parameter_are_refused_in_space(name: str) -> None:
    with pytest.raises(InputError, match=REFUSED["curves"]):
        fb.System.from_data(in_space(without_questions(document(name))))


def test_time_stepping_is_refused_in_space() -> None:
    with pytest.raises(InputError, match=REFUSED["moreau"]):
        fb.simulate(both("bouncing_ball")[1], 1.0, method="moreau", step=1e-3)


# -- all connections and loads of the plane ---------------------------------------------------
GRAVITY = {"weight_of_all": {"gravity": "9.81 m/s^2"}}
NOT_THERE = ("weld", "rolling_on_curve")
KINDS = {
    f"{kind.kind}": kind.example
    for kinds in (Connection.kinds, Load.kinds)
    for kind in kinds.values()
    if kind.__module__.startswith("freebody.") and "space:" not in kind.example and kind.kind not in NOT_THERE
}


@pytest.mark.parametrize("kind", sorted(KINDS))
def test_connections_and_loads_of_the_plane_do_the_same_in_space(kind: str) -> None:
    data = Document.read(KINDS[kind]).data
    data = {**data, "loads": {**data.get("loads", {}), **GRAVITY}}
    flat, spatial = fb.System.from_data(data), fb.System.from_data(in_space(data))
    if not (flat.contacts or flat.limits or flat.brakes):
        assert_same_from_anywhere((flat, spatial), 0.3)
        return
    one, other = (fb.simulate(s, 0.3, tolerance=TOLERANCE, every=0.05) for s in (flat, spatial))
    assert_same_places(one.course, other.course)
    assert_same_reactions(Rows.of(one.rows, one.course), Rows.of(other.rows, other.course))


def test_a_weld_holds_the_forces_of_the_plane_in_space() -> None:
    data = Document.read(Connection.kinds["weld"].example).data | {"loads": GRAVITY}
    flat, spatial = (fb.simulate(fb.System.from_data(d), 1.0).course for d in (data, data | {"space": True}))
    force, moment = flat.multipliers[0, :2], abs(flat.multipliers[0, 2])
    assert force == pytest.approx([0.0, 9.81], abs=1e-12)
    assert spatial.multipliers[0, :2] == pytest.approx(force, abs=1e-12)
    assert np.abs(spatial.multipliers[0, 2:]).max() == pytest.approx(moment, rel=1e-12)
    assert moment == pytest.approx(9.81 * 0.5, rel=1e-12)
