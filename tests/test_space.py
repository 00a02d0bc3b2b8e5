"""Models in space: the laws do not know where the ground is, motions are those of the books, and mistakes are told."""

from __future__ import annotations

import copy
import functools
import math
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import scipy.special
from numpy.typing import NDArray

import freebody as fb
from freebody.errors import ModelError
from freebody.language.document import Document
from freebody.numeric.engine.course import Course, Status
from freebody.numeric.rotation import from_quaternion, matrix, rotation_vector
from freebody.study.simulate import Simulation, Simulator

Array = NDArray[np.float64]
FOLDER = Path(__file__).parents[1] / "examples"
SEED = 3
G = 9.81


def simulated(text: str, until: float, tolerance: float = 1e-12, every: float | None = None) -> Simulation:
    result = fb.simulate(fb.System.from_text(text), until, tolerance=tolerance, every=every)
    assert result.status is Status.FINISHED, result.message
    return result


def rotations(course: Course, body: int = 0) -> Array:
    """(n_times, 3, 3) rotation matrices of a body."""
    assert course.rotation is not None
    return np.array([from_quaternion(q) for q in course.rotation.quaternions[:, body]])


def spins(course: Course, body: int = 0) -> Array:
    """(n_times, 3) angular velocity of a body along the axes of the ground."""
    assert course.rotation is not None
    return course.rotation.velocities[:, body]


def reactions(result: Simulation, *names: str) -> Array:
    """(n_times, n) multipliers of rows."""
    rows = [row.name for row in result.rows]
    return result.course.multipliers[:, [rows.index(name) for name in names]]


# -- the same model elsewhere -----------------------------------------------------------------
BENNETT = """
space: true
ground:
  points: {{J1: [0, 0, 0], J4: [{b!r}, 0, 0]}}
bodies:
  b1:
    body: {{mass: 1 kg, inertia: [0.01, 0.02, 0.025], center_of_mass: [{a!r}, 0, 0]}}
    points: {{start: [{a2!r}, 0, 0]}}
    lines: {{axis_of_start: {{along: [0, {sin_a!r}, {cos_a!r}]}}}}
    near: {{at: [{at1}], turned: {turned1}}}
  b2:
    body: {{mass: 1.5 kg, inertia: [0.02, 0.03, 0.04], center_of_mass: [{b!r}, 0, 0]}}
    points: {{start: [{b2!r}, 0, 0]}}
    lines: {{axis_of_start: {{along: [0, {sin_b!r}, {cos_b!r}]}}}}
    near: {{at: [{at2}], turned: {turned2}}}
  b3:
    body: {{mass: 0.7 kg, inertia: [0.02, 0.01, 0.02], center_of_mass: [{a!r}, 0, 0]}}
    points: {{start: [{a2!r}, 0, 0]}}
    lines: {{axis_of_start: {{along: [0, {sin_a!r}, {cos_a!r}]}}}}
    near: {{at: [{at3}], turned: {turned3}}}
connections:
  j1: {{revolute: {{first: ground.J1, second: b1.start, about: z, second_axis: b1.axis_of_start}}}}
  j2: {{revolute: {{first: b1, second: b2.start, about: z, second_axis: b2.axis_of_start}}}}
  j3: {{revolute: {{first: b2, second: b3.start, about: z, second_axis: b3.axis_of_start}}}}
  j4: {{revolute: {{first: ground.J4, second: b3, about: [0, {sin_b!r}, {cos_b!r}], second_axis: z}}}}
loads: {{weight: {{gravity: 9.81}}}}
measures: {{theta: angle of b1 about z}}
start: {{theta: 1.1, rate(theta): 2 rad/s}}
"""
ALPHA, BETA, LONG = 0.6, 1.1, 0.5  # twists of the links, and the length of the second


def pace(theta: float) -> tuple[float, float]:
    """The first two joint angles of a Bennett linkage: tan(t1/2) tan(t2/2) = sin((b + a)/2)/sin((b - a)/2).
    Source: Bennett, Engineering 76 (1903) 777; Denavit and Hartenberg, J. Appl. Mech. 22 (1955) 215."""
    product = math.sin((BETA + ALPHA) / 2) / math.sin((BETA - ALPHA) / 2)
    return theta, 2 * math.atan(product / math.tan(theta / 2))


def bennett() -> str:
    """Opposite links are alike, a/sin(alpha) = b/sin(beta); frame i is at the end of link i, its z along the joint."""
    a, b = LONG * math.sin(ALPHA) / math.sin(BETA), LONG
    one, two = pace(1.1)
    R, r = np.eye(3), np.zeros(3)
    places: dict[str, str] = {}
    for k, (theta, length, twist) in enumerate([(one, a, ALPHA), (two, b, BETA), (-one, a, ALPHA)], 1):
        R = R @ matrix(np.array([0.0, 0.0, theta]))
        r = r + R @ [length, 0.0, 0.0]
        R = R @ matrix(np.array([twist, 0.0, 0.0]))
        places |= {f"at{k}": listed(r), f"turned{k}": as_text(rotation_vector(R))}
    numbers = {"a": -a / 2, "b": -b / 2, "a2": -a, "b2": -b, "sin_a": math.sin(ALPHA), "cos_a": math.cos(ALPHA)}
    text = BENNETT.format(**numbers, sin_b=math.sin(BETA), cos_b=math.cos(BETA), **places)
    return text.replace(f"J4: [{-b / 2!r}", f"J4: [{-b!r}")


def listed(v: Array) -> str:
    return ", ".join(repr(float(c)) for c in v)


def as_text(turn: Array) -> str:
    """A rotation vector as an angle about an axis."""
    angle = float(np.linalg.norm(turn))
    return f"'{angle!r} about [{listed(turn / angle)}]'"


SPATIAL = {path.stem: Document.load(path).data for path in sorted(FOLDER.glob("*.yaml"))}
SPATIAL = {name: data for name, data in SPATIAL.items() if "space" in data}
SPATIAL["general_bennett"] = Document.read(bennett()).data


@functools.cache
def at_home(name: str) -> Simulation:
    return moved(SPATIAL[name])


def moved(data: dict[str, Any]) -> Simulation:
    system = fb.System.from_data({key: value for key, value in data.items() if key != "questions"})
    return fb.simulate(system, 0.5, tolerance=1e-12, every=0.05)


def first_state(result: Simulation, k: int, shift: Array, Q: Array) -> dict[str, Any]:
    """Where a body begins in a model that is turned by Q and shifted."""
    course = result.course
    R = Q @ rotations(course, k)[0]
    return {
        "at": {"mass_center": [float(c) for c in Q @ course.poses[0, k] + shift]},
        "turned": as_text(rotation_vector(R)).strip("'"),
        "velocity": [float(c) for c in Q @ course.velocities[0, k]],
        "angular_velocity": [float(c) for c in Q @ spins(course, k)[0]],
    }


def on_a_lab(name: str, shift: Array, turn: Array) -> dict[str, Any]:
    """The same model, with all that it has on the ground on a fixed body `lab`, which is somewhere and turned anyhow."""
    data, home, Q = copy.deepcopy(SPATIAL[name]), at_home(name), matrix(turn)
    ground = data.pop("ground", {})
    points = dict(ground.pop("points", {}))

    def renamed(value: Any) -> Any:
        if isinstance(value, dict):
            return {key: renamed(v) for key, v in value.items()}
        if isinstance(value, list):
            return [renamed(v) for v in value]
        if not isinstance(value, str):
            return value
        for point in re.findall(r"ground\.(\w+)", value):
            if point != "origin" and not any(point in things for things in (points, *ground.values())):
                points[point] = [0, 0, 0]
        return f"lab.{value}" if value in ground.get("lines", {}) else value.replace("ground.", "lab.")

    def measure(text: str) -> str:
        if text.startswith("angle of") and "relative to" not in text:
            return f"{text} relative to lab"
        return re.sub(r"^([xyz]) of (\S+)$", r"travel of \2 along lab.\1 from lab.origin", text)

    data["connections"] = renamed(data.get("connections", {}))
    data["loads"] = renamed(data.get("loads", {}))
    data["measures"] = {key: measure(renamed(text)) for key, text in data.get("measures", {}).items()}
    for load in data["loads"].values():
        if "gravity" in load:
            given = load["gravity"] if isinstance(load["gravity"], dict) else {"strength": load["gravity"]}
            load["gravity"] = given | {"along": f"lab.{given.get('along', 'down')}"}
        if "torque" in load and "." not in load["torque"]["about"]:
            load["torque"]["about"] = f"lab.{load['torque']['about']}"
    data["frames"] = {key: {"on": "lab", **entry} for key, entry in data.get("frames", {}).items()}
    for k, body in enumerate(home.system.moving):
        entry = data["bodies"][body.name]
        if body.chain:
            entry.setdefault("frame", "lab")
            entry["near"] = {"at": first_state(home, k, shift, Q)["at"]}
            continue
        found = first_state(home, k, shift, Q)
        given = {key: found[key] for key in ("at", "velocity", "turned", "angular_velocity") if key in entry}
        entry |= {**given, "near": {key: found[key] for key in ("at", "turned")}}
        if "at" in given:
            del entry["near"]
    lab = {"body": {}, "fixed": True, "at": [float(c) for c in shift], "turned": as_text(turn).strip("'"), **ground}
    data["bodies"] = {"lab": lab | {"points": points}, **data["bodies"]}
    return data


def on_turned_ground(name: str, shift: Array, turn: Array) -> dict[str, Any]:
    """The same model with its ground points, planes, axes, gravity and start written in turned numbers."""
    data, home, Q = copy.deepcopy(SPATIAL[name]), at_home(name), matrix(turn)
    number, ground = home.simulator.reference.number, home.system.bodies["ground"]

    def vector(exprs: Any) -> Array:
        return np.array([number(e) for e in exprs])

    def plain(v: Array) -> list[float]:
        return [float(c) for c in v]

    data["ground"] = {
        "points": {key: plain(Q @ vector(at) + shift) for key, at in ground.points.items() if key != "origin"},
        "planes": {
            key: {"through": plain(Q @ vector(p.through.offset) + shift), "normal": plain(Q @ vector(p.normal.components))}
            for key, p in ground.planes.items()
        },
    }
    for connection in data["connections"].values() if "connections" in data else ():
        for spec in connection.values():
            if "about" in spec and str(spec["first"]).startswith("ground."):
                about = spec["about"]
                axis = np.eye(3)["xyz".index(about)] if isinstance(about, str) else np.array(about, dtype=float)
                spec["about"] = plain(Q @ axis)
                spec.setdefault("second_axis", about)
    for load in data.get("loads", {}).values():
        load["gravity"] = {"strength": load["gravity"], "along": plain(Q @ -vector(home.system.up))}
    for k, body in enumerate(home.system.moving):
        entry = {key: v for key, v in data["bodies"][body.name].items() if key not in ("at", "near", "frame")}
        data["bodies"][body.name] = entry | first_state(home, k, shift, Q)
    return {key: value for key, value in data.items() if key not in ("measures", "start")}


def resultants(result: Simulation, k: int) -> dict[str, Array]:
    """By connection (n_bodies, 6): force along the ground's axes and moment about principal axes on every body."""
    simulator, course = result.simulator, result.course
    engine, reference = simulator.engine, simulator.reference
    y = engine.state_at(course, k)
    poses, velocities = engine.coordinates(y)
    columns = [list(reference.columns(b.name)) for b in result.system.moving]
    q = np.concatenate([poses[i, : len(c)] for i, c in enumerate(columns)])
    v = np.concatenate([velocities[i, : len(c)] for i, c in enumerate(columns)])
    g = reference.snapshot(q, v, float(course.times[k])).geometry
    found: dict[str, Array] = {}
    for row, multiplier, unique in zip(result.rows, course.multipliers[k], course.unique[k], strict=True):
        gradient = reference.jet(g, row.measure, row.name).row(len(q)) * (multiplier if unique else 0.0)
        total = found.setdefault(row.connection, np.zeros((len(columns), 6)))
        for i, own in enumerate(columns):
            total[i, : len(own)] += gradient[own]
    return found


def assert_turned(here: Simulation, there: Simulation, shift: Array, turn: Array) -> None:
    """The second motion is the first one turned and shifted, its reactions are the turned ones, measures the same."""
    Q, a, b = matrix(turn), here.course, there.course
    assert b.status is a.status, b.message
    names = [body.name for body in here.system.moving]
    assert [body.name for body in there.system.moving] == names
    assert a.rotation is not None and b.rotation is not None
    n = len(names)
    size = max(1.0, float(np.abs(a.poses).max()))
    assert np.abs(b.poses[:, :n] - (a.poses[:, :n] @ Q.T + shift)).max() < 1e-8 * size
    assert np.abs(b.velocities[:, :n] - a.velocities[:, :n] @ Q.T).max() < 1e-8 * max(1.0, np.abs(a.velocities).max())
    for k in range(n):
        assert np.abs(rotations(b, k) - Q @ rotations(a, k)).max() < 1e-8
    w = a.rotation.velocities_in_body
    assert np.abs(b.rotation.velocities_in_body[:, :n] - w[:, :n]).max() < 1e-8 * max(1.0, np.abs(w).max())
    for name in set(here.series) & set(there.series):
        for found, wanted in zip(there.series[name], here.series[name], strict=True):
            assert np.abs(found - wanted).max() < 1e-7 * max(1.0, np.abs(wanted).max()), name
    for k in range(0, len(a.times), 3):
        one, other = resultants(here, k), resultants(there, k)
        largest = max([1.0, *(float(np.abs(forces).max(initial=0.0)) for forces in one.values())])
        for connection, forces in one.items():
            wanted = np.hstack([forces[:, :3] @ Q.T, forces[:, 3:]])
            assert np.abs(other[connection] - wanted).max() < 1e-8 * largest, (connection, k)


def anywhere() -> tuple[Array, Array]:
    print("seed", SEED)
    rng = np.random.default_rng(SEED)
    return rng.uniform(-2.0, 2.0, 3), rng.standard_normal(3)


@pytest.mark.parametrize("name", SPATIAL)
def test_a_model_on_a_turned_body_moves_and_reacts_the_turned_way(name: str) -> None:
    shift, turn = anywhere()
    assert_turned(at_home(name), moved(on_a_lab(name, shift, turn)), shift, turn)


GIVEN = ("general_bennett", "free_asymmetric_body", "rolling_coin", "rolling_cone", "spinning_top")


@pytest.mark.parametrize("name", GIVEN)
def test_a_model_in_turned_numbers_moves_and_reacts_the_turned_way(name: str) -> None:
    shift, turn = anywhere()
    assert_turned(at_home(name), moved(on_turned_ground(name, shift, turn)), shift, turn)
