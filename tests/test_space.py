"""Models in space: the laws do not know where the ground is, motions are those of the books, and mistakes are told."""

from __future__ import annotations

import copy
import functools
import itertools
import math
import re
from typing import Any

import numpy as np
import pytest
import scipy.special
from numpy.typing import NDArray

import freebody as fb
from conftest import assert_same_function
from example_files import document, plain
from freebody.errors import ModelError
from freebody.language.document import Document
from freebody.language.notation import to_python
from freebody.numeric.engine.course import Status, Trajectory
from freebody.numeric.rotation import from_quaternion, matrix, rotation_vector
from freebody.study.simulation.simulate import Simulation

Array = NDArray[np.float64]
SEED = 3
G = 9.81


def simulated(text: str, until: float, tolerance: float = 1e-12, every: float | None = None) -> Simulation:
    result = fb.simulate(fb.System.from_text(text), until, tolerance=tolerance, every=every)
    assert result.status is Status.FINISHED, result.message
    return result


def rotations(course: Trajectory, body: int = 0) -> Array:
    """(n_times, 3, 3) rotation matrices of a body."""
    assert course.rotation is not None
    return np.array([from_quaternion(q) for q in course.rotation.quaternions[:, body]])


def spins(course: Trajectory, body: int = 0) -> Array:
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


GENERAL = "general_bennett"
SPATIAL = [*(name for name, data in plain().items() if "space" in data), GENERAL]


def spatial(name: str) -> dict[str, Any]:
    return Document.read(bennett()).data if name == GENERAL else document(name)


@functools.cache
def at_home(name: str) -> Simulation:
    return moved(spatial(name))


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


def hanging(system: fb.System) -> set[str]:
    """The bodies that hang straight down on strings."""
    return {row.ends[0] for row in system.rows if row.if_needed and row.reaction == "sideways force"}


def on_a_lab(name: str, shift: Array, turn: Array) -> dict[str, Any]:
    """The same model, with all that it has on the ground on a fixed body `lab`, which is anywhere and turned anyhow."""
    data, home, Q = copy.deepcopy(spatial(name)), at_home(name), matrix(turn)
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

    def measure(text: Any) -> Any:
        if isinstance(text, dict):  # along a line of a body
            return text
        if text.startswith("angle of line"):
            return re.sub(r" from (\w+)$", r" from lab.\1", text)
        if text.startswith("angle of") and "relative to" not in text:
            return f"{text} relative to lab"
        text = re.sub(r"^height of (\S+)$", r"y of \1", text)
        return re.sub(r"^([xyz]) of (\S+)$", r"travel of \2 along lab.\1 from lab.origin", text)

    data["connections"] = renamed(data.get("connections", {}))
    for joint in data["connections"].values():  # bearings, surfaces and planes that are on the ground unless it is said
        for kind in joint.keys() & {"bevel_gears", "helical_gears", "worm_gear"}:
            joint[kind].setdefault("on", "lab")
        if "driver" in joint:
            joint["driver"]["measure"] = measure(joint["driver"]["measure"])
        if "planar" in joint:
            joint["planar"] = {"through": "lab.origin", "normal": "lab.z", **joint["planar"]}
    data["loads"] = renamed(data.get("loads", {}))
    data["measures"] = {key: measure(renamed(text)) for key, text in data.get("measures", {}).items()}
    for load in data["loads"].values():
        if "gravity" in load:
            given = load["gravity"] if isinstance(load["gravity"], dict) else {"strength": load["gravity"]}
            load["gravity"] = given | {"along": f"lab.{given.get('along', 'down')}"}
        if "force" in load and isinstance(load["force"]["along"], list):  # components of the ground
            load["force"]["along"] = [float(c) for c in Q @ np.array(load["force"]["along"], dtype=float)]
        elif "force" in load and load["force"]["along"] in ("x", "y", "z", "up", "down"):
            load["force"]["along"] = f"lab.{load['force']['along']}"
        if "torque" in load and "." not in load["torque"]["about"]:
            load["torque"]["about"] = f"lab.{load['torque']['about']}"
    data["frames"] = {key: {"on": "lab", **entry} for key, entry in data.get("frames", {}).items()}
    for k, body in enumerate(home.system.moving):
        entry = data["bodies"][body.name]
        if body.chain:
            entry.setdefault("frame", "lab")
            entry["near"] = {"at": first_state(home, k, shift, Q)["at"]}
            continue
        if body.name in hanging(home.system) and "at" not in entry:
            continue  # where it hangs follows from the string
        found = first_state(home, k, shift, Q)
        given = {key: found[key] for key in ("at", "velocity", "turned", "angular_velocity") if key in entry}
        entry |= {**given, "near": {key: found[key] for key in ("at", "turned")}}
        if "at" in given:
            del entry["near"]["at"]
    for body, entry in data["bodies"].items():
        if entry.get("fixed"):
            pose = np.array(home.simulator.reference.frame.fixed[body])
            there = as_text(rotation_vector(Q @ matrix(pose[3:]))).strip("'")
            entry |= {"at": {"mass_center": [float(c) for c in Q @ pose[:3] + shift]}, "turned": there}
    lab = {"body": {}, "fixed": True, "at": [float(c) for c in shift], "turned": as_text(turn).strip("'"), **ground}
    data["bodies"] = {"lab": lab | {"points": points}, **data["bodies"]}
    return data


def on_turned_ground(name: str, shift: Array, turn: Array) -> dict[str, Any]:
    """The same model with its ground points, planes, axes, gravity and start written in turned numbers."""
    data, home, Q = copy.deepcopy(spatial(name)), at_home(name), matrix(turn)
    number, ground = home.simulator.reference.number, home.system.bodies["ground"]

    def vector(exprs: Any) -> Array:
        return np.array([number(e) for e in exprs])

    def plain(v: Array) -> list[float]:
        return [float(c) for c in v]

    data["ground"] = {
        "points": {key: plain(Q @ vector(at) + shift) for key, at in ground.points.items() if key != "origin"},
        "planes": {
            key: {
                "through": plain(Q @ vector(p.through.offset) + shift),
                "normal": plain(Q @ vector(p.normal.components)),
            }
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
    assert a.rotation is not None
    assert b.rotation is not None
    n = len(names)
    # but for the instants of events, of which only one of the two may have some, as where a slip turns aside
    between = [np.flatnonzero(~np.isin(c.times, [event.time for event in c.events])) for c in (a, b)]
    _times, of_a, of_b = np.intersect1d(a.times[between[0]], b.times[between[1]], return_indices=True)
    of_a, of_b = between[0][of_a], between[1][of_b]
    assert len(of_a) > 5
    size = max(1.0, float(np.abs(a.poses).max()))
    assert np.abs(b.poses[of_b, :n] - (a.poses[of_a, :n] @ Q.T + shift)).max() < 1e-8 * size
    gap = b.velocities[of_b, :n] - a.velocities[of_a, :n] @ Q.T
    assert np.abs(gap).max() < 1e-8 * max(1.0, np.abs(a.velocities).max())
    for k in (k for k, body in enumerate(here.system.moving) if body.turns):
        assert np.abs(rotations(b, k)[of_b] - Q @ rotations(a, k)[of_a]).max() < 1e-8
    w = a.rotation.velocities_in_body
    gap = b.rotation.velocities_in_body[of_b, :n] - w[of_a, :n]
    assert np.abs(gap).max() < 1e-8 * max(1.0, np.abs(w).max())
    for name in set(here.series) & set(there.series):
        for found, wanted in zip(there.series[name], here.series[name], strict=True):
            assert np.abs(found[of_b] - wanted[of_a]).max() < 1e-7 * max(1.0, np.abs(wanted).max()), name
    for k, j in zip(of_a[::3], of_b[::3], strict=True):
        one, other = resultants(here, k), resultants(there, j)
        largest = max([1.0, *(float(np.abs(forces).max(initial=0.0)) for forces in one.values())])
        for connection, forces in one.items():
            wanted = np.hstack([forces[:, :3] @ Q.T, forces[:, 3:]])
            assert np.abs(other[connection] - wanted).max() < 1e-8 * largest, (connection, k)


def anywhere() -> tuple[Array, Array]:
    print("seed", SEED)
    rng = np.random.default_rng(SEED)
    return rng.uniform(-2.0, 2.0, 3), rng.standard_normal(3)


# a rope with mass runs along directions of the ground; what rolls on a surface has a foot there, which is no body here;
# polar coordinates are counted from an axis of the ground; a copy of a gear may begin at any angle about its own axis
BOUND_TO_THE_GROUND = {"heavy_rope", "rolling_on_surface"}
ON_THE_GROUND = [
    name
    for name in SPATIAL
    if any(BOUND_TO_THE_GROUND & {*c} for c in spatial(name).get("connections", {}).values())
    or any("from the z axis" in str(text) for text in spatial(name).get("measures", {}).values())
    or any("copies" in body for body in spatial(name)["bodies"].values())
]


def along_edges(data: dict[str, Any]) -> str:
    """The axis of a cylinder that lies along edges of a box, or nothing. Turned anyhow it lies along them but for
    rounding, which then tells where its rims are nearest to an edge: the search for where they touch uses up its budget
    of parts, of each edge in each step. Turned about the axis, it lies along them exactly."""
    for connection in data.get("connections", {}).values():
        between = connection.get("contact", {}).get("between", ())
        bodies = [data["bodies"].get(name, {}) for name in between]
        axes = [body["cylinder"]["axis"] for body in bodies if "cylinder" in body]
        if axes and any("box" in body for body in bodies):
            return str(axes[0])
    return ""


@pytest.mark.parametrize("name", [name for name in SPATIAL if name not in ON_THE_GROUND])
def test_a_model_on_a_turned_body_moves_and_reacts_the_turned_way(name: str) -> None:
    shift, turn = anywhere()
    if hanging(at_home(name).system):
        turn = np.array([0.0, 0.0, turn[2]])  # what hangs on a string hangs straight down, wherever that comes from
    if axis := along_edges(spatial(name)):
        turn = turn * np.eye(3)["xyz".index(axis)]
    assert_turned(at_home(name), moved(on_a_lab(name, shift, turn)), shift, turn)


@pytest.mark.parametrize("seed", [5, 7])
def test_a_contact_at_a_body_that_joints_hold_moves_nothing_however_it_is_turned(seed: int) -> None:
    """Two revolutes keep the disk where it touches: the normal is a combination of their rows, and what it does to the
    disk is no more than round-off, beside a shaft without mass."""
    name, rng = "disk_on_angled_shaft", np.random.default_rng(seed)
    shift, turn = rng.uniform(-2.0, 2.0, 3), rng.standard_normal(3)
    assert_turned(at_home(name), moved(on_a_lab(name, shift, turn)), shift, turn)


GIVEN = ("general_bennett", "free_asymmetric_body", "rolling_coin", "rolling_cone", "spinning_top")


@pytest.mark.parametrize("name", GIVEN)
def test_a_model_in_turned_numbers_moves_and_reacts_the_turned_way(name: str) -> None:
    shift, turn = anywhere()
    assert_turned(at_home(name), moved(on_turned_ground(name, shift, turn)), shift, turn)


# -- gimbal poses -----------------------------------------------------------------------------
TUMBLING = """
space: true
bodies:
  it:
    body: {mass: 1 kg, inertia: [1, 2, 2.5]}
    turned: [psi about z, theta about y, phi about x]
start: {psi: 0.4, theta: 0.3, phi: -0.2, rate(psi): 0.02, rate(theta): 1.1, rate(phi): 0.03}
"""


def test_a_body_turns_through_gimbal_poses_without_a_jump() -> None:
    result = simulated(TUMBLING, 60.0, 1e-12, 0.01)
    course = result.course
    assert course.rotation is not None
    q = course.rotation.quaternions[:, 0]
    fastest = float(np.linalg.norm(spins(course), axis=1).max())
    assert 2.0 * np.linalg.norm(np.diff(q, axis=0), axis=1).max() < 1.001 * fastest * 0.01
    tilt = np.abs(np.cos(result.series["theta"][0]))
    assert tilt.min() < 0.02  # it comes near the pose in which psi and phi are one
    far = np.minimum(tilt[1:], tilt[:-1])
    for name in ("psi", "phi"):  # elsewhere the angles go on by their rates, over whole turns too
        values, rates, _ = result.series[name]
        steps = np.diff(values) - 0.005 * (rates[1:] + rates[:-1])
        assert np.abs(steps[far > 0.2]).max() < 1e-3, name
    assert np.ptp(result.series["phi"][0]) > 2 * math.pi


def test_named_angles_are_those_of_the_rotation() -> None:
    """R = Rz(psi) Ry(theta) Rx(phi) at every instant, through gimbal poses too."""
    result = simulated(TUMBLING, 20.0, 1e-12, 0.1)
    psi, theta, phi = (result.series[name][0] for name in ("psi", "theta", "phi"))
    for k, R in enumerate(rotations(result.course)):
        built = matrix(np.array([0, 0, psi[k]])) @ matrix(np.array([0, theta[k], 0])) @ matrix(np.array([phi[k], 0, 0]))
        assert np.abs(built - R).max() < 1e-7


# -- tops and free bodies ---------------------------------------------------------------------
TOP = """
space: {{up: z}}
bodies:
  top:
    body: {{mass: 0.5 kg, inertia: [8e-4, 8e-4, 5e-4]}}
    points: {{tip: [0, 0, -0.06]}}
    turned: [psi about z, theta about x, phi about z]
connections: {{tip: {{spherical: [ground.O, top.tip]}}}}
loads: {{weight: {{gravity: 9.81}}}}
start: {{psi: 0, theta: {theta}, phi: 0, rate(psi): {psi}, rate(theta): 0, rate(phi): {phi}}}
"""
ABOUT_TIP, ABOUT_AXIS, WEIGHT = 8e-4 + 0.5 * 0.06**2, 5e-4, 0.5 * G * 0.06  # A, C, m g l


@pytest.mark.parametrize("spin", [60.0, 100.0, 200.0])
def test_a_top_let_go_nods_by_jacobis_functions(spin: float) -> None:
    # u = cos(theta): u'^2 = b (u - u1)(u - u0)(u - u3), b = 2 m g l/A; from the cusp u0: u = u1 + (u0 - u1) cd^2.
    # Source: Whittaker, Analytical Dynamics, 1937, sec. 71.
    u0 = math.cos(0.5)
    b, square = 2 * WEIGHT / ABOUT_TIP, (ABOUT_AXIS * spin / ABOUT_TIP) ** 2
    low, high = sorted(np.roots([b, -square, square * u0 - b]).real)
    m = (u0 - low) / (high - low)
    result = simulated(TOP.format(theta=0.5, psi=0, phi=spin), 5.0, 1e-13, 0.01)
    _sn, cn, dn, _ = scipy.special.ellipj(0.5 * math.sqrt(b * (high - low)) * result.course.times, m)
    wanted = np.arccos(low + (u0 - low) * (cn / dn) ** 2)
    assert np.abs(result.series["theta"][0] - wanted).max() < 1e-8


def test_a_fast_top_precesses_with_m_g_l_over_its_spin() -> None:
    """The mean rate tends to m g l/(C omega), with an error that falls with the square of the spin."""
    errors: list[float] = []
    for spin in (200.0, 400.0, 800.0):
        slow = WEIGHT / (ABOUT_AXIS * spin)
        result = simulated(TOP.format(theta=0.5, psi=slow, phi=spin), 2.0, 1e-12, 0.5)
        errors.append(abs(result.series["psi"][0][-1] / (2.0 * slow) - 1.0))
    assert errors[0] < 0.1
    for one, next_one in itertools.pairwise(errors):
        assert 3.0 < one / next_one < 6.0


def test_the_middle_axis_flips_with_the_period_of_the_elliptic_solution() -> None:
    # about the middle axis w2 = b sn(rate t, m): it changes its sign every 2 K/rate (Landau & Lifshitz, sec. 37)
    i1, i2, i3 = 1.0, 2.0, 2.5
    a, c = 0.4, 1.1
    energy, square = i1 * a**2 + i3 * c**2, (i1 * a) ** 2 + (i3 * c) ** 2
    rate = math.sqrt((i3 - i2) * (square - energy * i1) / (i1 * i2 * i3))
    m = (i2 - i1) * (energy * i3 - square) / ((i3 - i2) * (square - energy * i1))
    text = f"""
    space: true
    bodies:
      it:
        body: {{mass: 1 kg, inertia: [{i1}, {i2}, {i3}]}}
        turned: 0 about x
        at: [0, 0, 0]
        velocity: [0, 0, 0]
        angular_velocity: {{body: [{a}, 0, {c}]}}
    """
    result = simulated(text, 100.0, 1e-13, 0.01)
    assert result.course.rotation is not None
    w, t = result.course.rotation.velocities_in_body[:, 0, 1], result.course.times
    k = np.flatnonzero(w[1:-1] * w[2:] < 0.0) + 1
    flips = t[k] - w[k] * (t[k + 1] - t[k]) / (w[k + 1] - w[k])
    half = 2.0 * scipy.special.ellipk(m) / rate
    assert len(flips) > 10
    assert np.abs(flips / half - np.round(flips / half)).max() < 1e-5  # by linear interpolation


def test_a_free_body_keeps_energy_and_momentum_for_ten_thousand_seconds() -> None:
    text = """
    space: true
    bodies:
      it:
        body: {mass: 1 kg, inertia: [1, 2, 2.5]}
        turned: 0.3 about [1, 2, 3]
        at: [0, 0, 0]
        velocity: [0, 0, 0]
        angular_velocity: {body: [0.02, 1, 0.01]}
    """
    course = simulated(text, 1e4, 1e-13, 10.0).course
    assert course.rotation is not None
    momenta = course.rotation.velocities_in_body[:, 0] * [1.0, 2.0, 2.5]
    energy = 0.5 * (momenta * course.rotation.velocities_in_body[:, 0]).sum(axis=1)
    vector = np.einsum("tij,tj->ti", rotations(course), momenta)
    assert np.abs(energy / energy[0] - 1.0).max() < 1e-9
    assert np.abs(vector - vector[0]).max() < 1e-9 * np.linalg.norm(vector[0])


# -- rolling ----------------------------------------------------------------------------------
COIN = """
space: true
ground: {{planes: {{table: {{normal: up}}}}}}
bodies: {{coin: {{disk: {{mass: 0.1 kg, radius: 0.05 m}}, turned: [psi about y, theta about x, phi about z]}}}}
connections: {{rolling: {{rolling: {{body: coin, on: ground.table}}}}}}
loads: {{weight: {{gravity: 9.81}}}}
measures: {{x: x of coin, z: z of coin}}
start: {{x: 0, z: 0, psi: 0, theta: {theta}, phi: 0, rate(theta): 0, rate(psi): {psi}, rate(phi): {phi}}}
"""


def steady_spin(theta: float, turning: float) -> float:
    """(C + m R^2) w Om cos(th) + A Om^2 sin(th) cos(th) = m g R sin(th), w = phi' - Om sin(th): moments about the point
    of contact of a thin disk, C = m R^2/2, A = m R^2/4. Source: Neimark & Fufaev, 1972, ch. II sec. 5."""
    sine, cosine = math.sin(theta), math.cos(theta)
    w = (G / 0.05 * sine - turning**2 * sine * cosine / 4) / (1.5 * turning * cosine)
    return w + turning * sine


@pytest.mark.parametrize(("theta", "turning"), [(0.3, 4.0), (0.8, 9.0), (1.2, 25.0)])
def test_a_disk_that_turns_steadily_goes_on_so(theta: float, turning: float) -> None:
    spin = steady_spin(theta, turning)
    result = simulated(COIN.format(theta=theta, psi=turning, phi=spin), 3.0)
    assert np.abs(result.series["theta"][0] - theta).max() < 1e-8
    assert np.abs(result.series["psi"][1] - turning).max() < 1e-7 * turning
    assert np.abs(result.series["phi"][1] - spin).max() < 1e-7 * abs(spin)
    x, z = result.series["x"][0], result.series["z"][0]  # the centre goes round a circle
    radius = 0.05 * abs(spin - turning * math.sin(theta)) / turning
    middle = np.array([(x.max() + x.min()) / 2, (z.max() + z.min()) / 2])
    assert np.hypot(x - middle[0], z - middle[1]) == pytest.approx(np.full(len(x), radius), abs=1e-4 * radius)


def test_eulers_disk_keeps_its_energy() -> None:
    """Almost flat, turning fast round the point of contact."""
    theta, turning = 1.45, 60.0
    text = COIN.format(theta=theta, psi=turning, phi=1.02 * steady_spin(theta, turning))
    result = simulated(text, 1.0)
    assert np.ptp(result.series["theta"][0]) > 1e-3
    assert result.energy.relative_error < 1e-9


@pytest.mark.parametrize("factor", [1.05, 0.95])
def test_a_fast_upright_disk_stays_upright_and_a_slow_one_falls(factor: float) -> None:
    """Rolling straight on is stable above w^2 = A m g R/(C (C + m R^2)) = g/(3 R). Source: Routh, Advanced Rigid
    Dynamics, 1905, sec. 244."""
    spin = factor * math.sqrt(G / (3 * 0.05))
    result = simulated(COIN.format(theta=1e-5, psi=0, phi=spin), 6.0)
    largest = float(np.abs(result.series["theta"][0]).max())
    assert (largest < 5e-4) == (factor > 1.0)


def test_a_ball_on_a_turntable_goes_round_with_two_sevenths_of_its_speed() -> None:
    # Source: Weltner, Am. J. Phys. 47 (1979) 984
    omega, r = 3.0, 0.02
    text = f"""
    space: true
    parameters: {{W: {omega} rad/s}}
    bodies:
      table: {{body: {{inertia: 1}}, planes: {{top: {{normal: up}}}}}}
      ball: {{sphere: {{mass: 0.05 kg, radius: {r}}}}}
    connections:
      axle: {{revolute: {{first: ground.O, second: table, about: y}}}}
      motor: {{driver: {{measure: turn, follows: W*t}}}}
      rolling: {{rolling: {{body: ball, on: table.top}}}}
    measures: {{turn: angle of table about y, x: x of ball, z: z of ball}}
    loads: {{weight: {{gravity: 9.81}}}}
    start: {{x: 0.3 m, z: 0.1 m, rate(x): 0.2 m/s, rate(z): -0.1 m/s}}
    """
    result = simulated(text, 10.0)
    z = result.series["x"][0] - 1j * result.series["z"][0]  # right-handed about y
    v = result.series["x"][1] - 1j * result.series["z"][1]
    rate = 2.0 / 7.0 * omega
    middle = z[0] - v[0] / (1j * rate)
    wanted = middle + (z[0] - middle) * np.exp(1j * rate * result.course.times)
    assert np.abs(z - wanted).max() < 1e-9


def test_a_rolling_cone_turns_evenly() -> None:
    # T = 3/40 m h^2 W^2 (1 + 5 cos^2 a). Source: Landau & Lifshitz, Mechanics, sec. 32, problem 7
    result = moved(spatial("rolling_cone"))
    turning = result.series["psi"][1]
    assert np.abs(turning - 2.0).max() < 1e-9
    m, radius, height = 2.0, 0.1, 0.3
    cosine2 = height**2 / (height**2 + radius**2)
    wanted = 3 / 40 * m * height**2 * 4.0 * (1 + 5 * cosine2)
    assert result.energy.kinetic == pytest.approx(np.full(len(turning), wanted), rel=1e-9)
    # it rolls off a circle as wide as its slant with its base: phi' = -psi' sqrt(R^2 + h^2)/R
    ratio = result.series["phi"][1] / turning
    assert np.abs(ratio) == pytest.approx(np.full(len(turning), math.hypot(radius, height) / radius), rel=1e-9)


# -- machines ---------------------------------------------------------------------------------
def test_bearings_carry_the_couple_of_a_tilted_disk() -> None:
    """m R^2 omega^2 sin(delta) cos(delta)/(8 b) each, b from the middle: (C - A) omega^2 sin cos over 2 b."""
    result = moved(spatial("tilted_disk_on_shaft"))
    m, radius, delta, b, omega = 5.0, 0.15, math.radians(2.0), 0.3, 150.0
    force = m * radius**2 * omega**2 * math.sin(delta) * math.cos(delta) / (8 * b)
    rows = [row.name for row in result.rows]
    for bearing in ("A", "B"):
        across = [name for name in rows if name.startswith(f"{bearing}.") and name != "A.x"]
        sizes = np.linalg.norm(reactions(result, *across), axis=1)
        assert sizes == pytest.approx(np.full(len(sizes), force), rel=1e-9)


FOUR_HINGES = """
space: true
ground: {points: {A: [0, 0, 0], D: [1 m, 0, 0]}}
bodies:
  crank: {box: {mass: 1 kg, size: [0.3 m, 0.05 m, 0.05 m]}, near: {at: {left: [0, 0, 0]}, turned: 60 deg about z}}
  coupler: {box: {mass: 2 kg, size: [0.9 m, 0.05 m, 0.05 m]}, near: {turned: 20 deg about z}}
  rocker: {box: {mass: 1 kg, size: [0.6 m, 0.05 m, 0.05 m]}, near: {turned: 80 deg about z}}
connections:
  A: {revolute: {first: ground.A, second: crank.left, about: z}}
  B: {revolute: {first: crank.right, second: coupler.left, about: z}}
  C: {revolute: {first: coupler.right, second: rocker.right, about: z}}
  D: {revolute: {first: ground.D, second: rocker.left, about: z}}
loads: {weight: {gravity: 9.81}}
measures: {theta: angle of crank about z}
start: {theta: 60 deg, rate(theta): 4 rad/s}
"""


@pytest.mark.parametrize("text", [bennett(), FOUR_HINGES], ids=["bennett", "four hinges"])
def test_loops_with_redundant_hinges_move_keep_their_energy_and_do_not_drift(text: str) -> None:
    result = simulated(text, 20.0, 1e-13)
    assert result.simulator.degrees_of_freedom == 1
    assert not result.course.unique.all()
    assert np.ptp(result.series["theta"][0]) > 0.5
    assert result.energy.relative_error < 1e-9
    assert result.course.place_gap < 1e-11
    assert result.course.motion_gap < 1e-9


def test_a_bennett_linkage_keeps_the_product_of_half_tangents() -> None:
    result = simulated(bennett(), 5.0, every=0.05)
    one = result.series["theta"][0]
    between = np.einsum("tji,tjk->tik", rotations(result.course, 0), rotations(result.course, 1))
    two = np.arctan2(between[:, 1, 0], between[:, 0, 0])
    wanted = math.sin((BETA + ALPHA) / 2) / math.sin((BETA - ALPHA) / 2)
    away = np.abs(np.sin(one / 2)) > 0.05
    gap = np.sin(one / 2) * np.sin(two / 2) - wanted * np.cos(one / 2) * np.cos(two / 2)
    assert away.any()
    assert np.abs(gap).max() < 1e-9


def test_a_nut_falls_slowly_along_its_thread() -> None:
    """It brings its moment of inertia along: a = g m/(m + J (2 pi/p)^2)."""
    text = """
    space: true
    bodies: {nut: {body: {mass: 0.5 kg, inertia: [1e-5, 2e-5, 1.5e-5]}}}
    connections: {thread: {screw: {first: ground.A, second: nut, about: y, pitch: 20 mm}}}
    loads: {weight: {gravity: 9.81}}
    measures: {drop: drop of nut, turn: angle of nut about y}
    """
    result = simulated(text, 2.0)
    wanted = G * 0.5 / (0.5 + 2e-5 * (2 * math.pi / 0.02) ** 2)
    assert result.series["drop"][2] == pytest.approx(np.full(len(result.course.times), wanted), rel=1e-10)
    assert result.series["drop"][0][-1] == pytest.approx(wanted * 2.0, rel=1e-9)
    assert result.series["turn"][0][-1] == pytest.approx(-wanted * 2.0 * 2 * math.pi / 0.02, rel=1e-9)


def test_a_cardan_joint_turns_unevenly_and_a_constant_velocity_joint_evenly() -> None:
    """w2/w1 = cos(a)/(cos^2(a) + sin^2(a) cos^2(psi)), psi from where the driving arm is across both shafts."""
    cardan = moved(spatial("cardan_joint"))
    alpha = math.radians(30)
    psi, rate, _ = cardan.series["psi"]
    names = [body.name for body in cardan.system.moving]
    out = np.array([0.0, math.sin(alpha), math.cos(alpha)])
    along = spins(cardan.course, names.index("driven")) @ out
    wanted = math.cos(alpha) / (math.cos(alpha) ** 2 + math.sin(alpha) ** 2 * np.cos(psi) ** 2)
    assert along / rate == pytest.approx(wanted, rel=1e-10)
    text = """
    space: true
    frames: {bent: {turned: -30 deg about x}}
    bodies:
      drive: {body: {inertia: 0.01}}
      driven: {body: {inertia: 0.02}, near: {turned: -30 deg about x}}
    connections:
      bearing: {revolute: {first: ground.O, second: drive, about: z}}
      support: {cylindrical: {first: ground.O, second: driven, about: bent.z, second_axis: z}}
      joint: {constant_velocity: {first: drive, second: driven, about: z}}
    loads: {motor: {torque: {on: drive, about: z, magnitude: 0.3}}}
    measures: {psi: angle of drive about z}
    start: {psi: 0, rate(psi): 5 rad/s}
    """
    even = simulated(text, 3.0)
    ratio = spins(even.course, 1) @ out / even.series["psi"][1]
    assert np.abs(ratio - 1.0).max() < 1e-9
    assert even.series["psi"][2] == pytest.approx(np.full(len(ratio), 0.3 / 0.03), rel=1e-9)


def test_a_gear_pair_pushes_its_carrier_with_what_it_changes() -> None:
    """At rest the carrier, and what holds it, feel both torques: one about x, the other about y."""
    text = """
    space: true
    bodies:
      carrier: {body: {mass: 1 kg, inertia: 0.1}}
      a: {disk: {mass: 1 kg, radius: 0.2 m, axis: x}}
      b: {disk: {mass: 1 kg, radius: 0.4 m, axis: y}}
    connections:
      hold: {weld: {first: ground.O, second: carrier}}
      p: {revolute: {first: carrier, second: a, about: x}}
      q: {revolute: {first: carrier, second: b, about: y}}
      mesh: {gear_pair: {first: a, second: b, on: carrier, first_axis: x, second_axis: y, ratio: 1/2}}
    loads:
      one: {torque: {on: a, about: x, magnitude: 3}}
      other: {torque: {on: b, about: y, magnitude: -6}}
    """
    result = simulated(text, 0.5)
    assert np.abs(spins(result.course, 1)).max() < 1e-12  # the torques balance: no power
    found = resultants(result, 0)
    k = [body.name for body in result.system.moving].index("carrier")
    assert found["hold"][k, 3:] == pytest.approx([-3.0, 6.0, 0.0], abs=1e-10)
    assert found["mesh"][k, 3:] == pytest.approx([3.0, -6.0, 0.0], abs=1e-10)
    assert np.abs(found["p"][k]).max() < 1e-10


# -- mistakes ---------------------------------------------------------------------------------
BOX = "{box: {mass: 1 kg, size: [1 m, 1 m, 1 m]}}"
ONE_BOX = f"space: true\nbodies:\n  b: {BOX}\n"
TWO = f"space: true\nbodies:\n  b: {BOX}\n  c: {BOX}\nconnections:\n"
BODY = "space: true\nbodies:\n  b:\n    box: {mass: 1 kg, size: [1 m, 1 m, 1 m]}\n"
DISK = "bodies:\n  b:\n    disk: {mass: 1 kg, radius: 1 m}\n"
TENSOR = "space: true\nbodies:\n  b:\n    body: {mass: 1 kg, inertia: %s}\n"
MISTAKES = {
    "a moment larger than the sum of the others": (TENSOR % "[1, 1, 3]", 4, "largest cannot be more than the sum"),
    "a tensor that is not positive": (TENSOR % "[[1, 2, 0], [2, 1, 0], [0, 0, 1]]", 4, "none can be negative"),
    "a tensor that is not symmetric": (TENSOR % "[[1, 0.2, 0], [0, 1, 0], [0, 0, 1]]", 4, "is symmetric"),
    "an axis of no length": (
        ONE_BOX + "connections:\n  j: {revolute: {first: ground.A, second: b, about: [0, 0, 0]}}\n",
        5,
        r"a direction must not be \[0, 0, 0\]; it needs a length",
    ),
    "a force along nothing": (
        ONE_BOX + "loads:\n  f: {force: {at: b, along: [0, 0, 0], magnitude: 1 N}}\n",
        5,
        "it needs a length",
    ),
    "a turn about nothing": (BODY + "    turned: 30 deg about [0, 0, 0]\n", 5, "it needs a length"),
    "a rotation that is none": (BODY + "    turned: psi around y\n", 5, "angle about an axis, e.g. 30 deg about z"),
    "an axis that is none": (BODY + "    turned: psi about w\n", 5, "w is no axis to turn about; write x, y, z"),
    "two angles about one axis": (BODY + "    turned: [psi about y, theta about y]\n", 5, "same axis|different"),
    "two of three angles about one axis": (
        BODY + "    turned: [psi about y, theta about y, phi about x]\n",
        5,
        "neighbours about different ones",
    ),
    "one name twice": (BODY + "    turned: [psi about y, psi about x]\n", 5, "psi is named twice"),
    "a pin on a body that is free in space": (
        ONE_BOX + "connections:\n  j: {pin: [ground.A, b]}\n",
        5,
        "pin is a connection of the plane: in space a hinge is revolute",
    ),
    "a torque without an axis": (
        ONE_BOX + "loads:\n  t: {torque: {on: b, magnitude: 1 N m}}\n",
        5,
        "needs its axis, e.g. about: z",
    ),
    "a torsional spring without an axis": (
        ONE_BOX + "loads:\n  t: {torsional_spring: {body: b, stiffness: 1 N m}}\n",
        5,
        "needs an axis, e.g. about: z",
    ),
    "three components in the plane": (
        DISK + "    at: [1, 2, 3]\n",
        4,
        r"expected two components \[x, y\].*space: true",
    ),
    "a ground point with three components in the plane": (
        "ground: {points: {A: [1, 2, 3]}}\n" + DISK + "connections: {p: {pin: [ground.A, b]}}\n",
        1,
        r"expected two components \[x, y\].*space: true",
    ),
    "an axis of a torque in the plane": (
        DISK + "loads:\n  t: {torque: {on: b, magnitude: 1 N m, about: z}}\n",
        5,
        "in the plane has no axis; in space write space: true",
    ),
    "a rotation in the plane": (DISK + "    turned: 30 deg about z\n", 4, "for models in space: write space: true"),
    "an axis on the wrong body": (
        TWO + "  j: {revolute: {first: b, second: c, about: ground.x}}\n",
        6,
        "must be on b, the body of first; give the one on c as second_axis",
    ),
    "a second axis on the wrong body": (
        TWO + "  j: {revolute: {first: b, second: c, about: x, second_axis: b.y}}\n",
        6,
        "second_axis must be fixed in c, the body of second",
    ),
    "a joint without an axis": (
        ONE_BOX + "connections:\n  j: {revolute: {first: ground.A, second: b}}\n",
        5,
        "revolute needs about",
    ),
    "a joint of space in the plane": (
        DISK + "connections:\n  j: {revolute: {first: ground.A, second: b, about: z}}\n",
        5,
        "revolute is for models in space: write space: true; in the plane take pin",
    ),
    "rolling on a plane that is not there": (
        "space: true\nground: {planes: {floor: {normal: up}}}\n"
        + DISK
        + "connections:\n  j: {rolling: {body: b, on: ground.flor}}\n",
        7,
        "neither a plane, a line nor a round body. Did you mean ground.floor",
    ),
    "a box that rolls": (
        "space: true\nground: {planes: {floor: {normal: up}}}\nbodies:\n  b: "
        + BOX
        + "\nconnections:\n  j: {rolling: {body: b, on: ground.floor}}\n",
        6,
        "b is not round; make it a disk, ring, cylinder, sphere, ellipsoid or cone",
    ),
    "one number as an angular velocity": (
        BODY + "    angular_velocity: 3 rad/s\n",
        5,
        r"expected three components \[x, y, z\]",
    ),
}


@pytest.mark.parametrize("what", MISTAKES)
def test_a_mistake_is_told_once_with_its_line_and_what_to_do(what: str) -> None:
    text, line, message = MISTAKES[what]
    with pytest.raises(ModelError, match=message) as caught:
        fb.System.from_text(text, "model.yaml")
    (problem,) = caught.value.problems
    assert problem.line == line
    assert str(caught.value).startswith(f"model.yaml:{line}:")


def test_a_string_in_space_runs_through_a_hole_of_a_table() -> None:
    # r r'' terms: (m + M) r'' = m u^2/r - M g at the start, S = m M/(m + M) (g + u^2/r)
    system = fb.System.from_text("""
space: {up: z}
ground: {planes: {table: {normal: up}}}
bodies:
  puck: {particle: {mass: 2 kg}, at: [0.5 m, 0, 0], velocity: [0, 3 m/s, 0]}
  load: {particle: {mass: 3 kg}, at: [0, 0, -1 m]}
connections:
  rope: {string: {path: [puck, over ground.hole, load]}}
  table: {point_on_plane: {point: puck, on: table}}
  guide: {point_on_line: {point: load, through: ground.hole, along: z}}
loads: {weight: {gravity: 9.81 m/s^2}}
questions: {a: acceleration of load along z at start, tension: tension of rope at start}
""")
    solution = system.solve()
    assert solution["a"].value == pytest.approx((2 * 9 / 0.5 - 3 * 9.81) / 5)
    assert solution["tension"].value == pytest.approx(2 * 3 / 5 * (9.81 + 9 / 0.5))


def test_a_string_in_space_over_a_wheel_leaves_it_a_radius_to_either_side_as_in_the_plane() -> None:
    bodies = "{wheel: {disk: {mass: 1 kg, radius: 0.1 m}}, a: {particle: {mass: 1 kg}}, b: {particle: {mass: 1 kg}}}"
    bearings = {"space: true": "revolute: {first: ground.O, second: wheel, about: z}", "": "pin: [ground.O, wheel]"}
    found = []
    for head, bearing in bearings.items():
        system = fb.System.from_text(f"""{head}
bodies: {bodies}
connections: {{p: {{{bearing}}}, r: {{string: {{from: a, over: [wheel], to: b}}}}}}
loads: {{weight: {{gravity: {{strength: 9.81 m/s^2, along: down}}}}}}
questions: {{a: position of a at start, b: position of b at start}}
""")
        solution = system.solve()
        found.append([x for body in "ab" for x in solution[body].value[:2]])
    assert found[0] == pytest.approx(found[1])
    assert found[0][::2] == pytest.approx([-0.1, 0.1])


def test_a_bead_on_a_turning_parabola_stays_anywhere_at_one_rate() -> None:
    # s'' (1 + 4 a^2 s^2) = s (Omega^2 - 2 a g - 4 a^2 s'^2)
    system = fb.System.from_text("""
space: true
parameters: {a: 0.8 1/m, Omega: 3 rad/s}
bodies:
  wire: {body: {inertia: 1 kg m^2}}
  bead: {particle: {mass: 2 kg}, near: {at: [0.6 m, 0.3 m, 0]}}
connections:
  axle: {revolute: {first: ground.O, second: wire, about: y}}
  motor: {driver: {measure: angle of wire about y, follows: Omega*t}}
  curve: {curved_rail: {point: bead, on: wire, y: a*x^2}}
loads: {weight: {gravity: {strength: 9.81 m/s^2, along: -y}}}
measures: {s: travel of bead along wire.x from wire.origin}
start: {s: 0.6 m, rate(s): 0}
questions: {a: acceleration of s at start}
""")
    assert system.solve()["a"].value == pytest.approx(0.6 * (9 - 2 * 0.8 * 9.81) / (1 + 4 * 0.64 * 0.36))


TWO_PULLEYS = """
freebody: 1
space: {up: z}
parameters: {m1: 2 kg, m2: 3 kg, g: 9.81 m/s^2, h: 2 m}
ground: {points: {A: [0, 0, h], B: [1 m, 1 m, h]}}
bodies:
  one: {particle: {mass: m1}, at: [0, 0, 0]}
  two: {particle: {mass: m2}, at: [1 m, 0, 1 m]}
connections: {rope: {string: {from: one, over: [ground.A, ground.B], to: two}}}
loads: {weight: {gravity: g}}
"""


def test_a_string_over_two_small_pulleys_has_a_length_of_each_part_that_moves() -> None:
    """At rest along u = (0, 1, 1)/sqrt(2) the second weight adds g/sqrt(2): T (1/m1 + 1/m2) = g (1 + 1/sqrt(2))."""
    [answer] = fb.System.from_text(TWO_PULLEYS).solve("tension of rope at the start").answers
    assert answer.expression is not None, answer.reason
    assert answer.value == pytest.approx(9.81 * (1 + math.sqrt(0.5)) / (1 / 2 + 1 / 3), rel=1e-12)
    [anywhere] = fb.System.from_text(TWO_PULLEYS).solve("tension of rope").answers
    assert "defect" not in (anywhere.reason or "")  # the routes agree at any pose
    assert anywhere.value == pytest.approx(answer.value, rel=1e-9)


def test_a_plate_on_six_bars_that_is_put_by_its_corner() -> None:
    """With w = sqrt(b^2 + h^2): about the vertical through L, s6 a b/w = b H, and across, s5 = -s6. About x through K,
    s3 + P + (s5 + s6) h/w = 0; about the edge L N, s1 + s3 + s6 h/w = 0. The plate is put by a corner, over a foot of
    the same x and y, and is not turned."""
    plate = fb.System.from_text("""
space: true
parameters: {a: 1.2 m, b: 0.8 m, h: 1 m, P: 200 N, H: 50 N}
ground: {points: {A: [0, 0, -h], B: [a, 0, -h], C: [0, b, -h]}}
bodies:
  top:
    box: {size: [a, b, 0.02 m]}
    at: {K: [0, 0, 0]}
    points: {K: [-a/2, -b/2, 0], L: [a/2, -b/2, 0], M: [-a/2, b/2, 0], N: [a/2, b/2, 0]}
connections:
  s1: {link: [ground.A, top.K]}
  s2: {link: [ground.B, top.L]}
  s3: {link: [ground.C, top.M]}
  s4: {link: [ground.A, top.L]}
  s5: {link: [ground.B, top.N]}
  s6: {link: [ground.A, top.M]}
loads:
  P: {force: {at: top.N, along: -z, magnitude: P}}
  H: {force: {at: top.N, along: x, magnitude: H}}
""")
    first, fifth = plate.solve(["force in s1", "force in s5"]).answers
    assert_same_function(to_python(first.expression), "P - h*H/a", {})
    assert_same_function(to_python(fifth.expression), "-H*sqrt(b**2 + h**2)/a", {})


PLATE = """
space: {up: z}
parameters: {m: 25 kg, P: 200 N, a: 1.2 m, b: 0.8 m, x: 0.2 m, y: 0.1 m, h: 1 m, g: 9.81 m/s^2}
bodies:
  top:
    box: {mass: m, size: [a, b, 0.02 m]}
    at: [0, 0, 0]
    points: {A: [-a/2, -b/2, 0], B: [a/2, -b/2, 0], C: [0, b/2, 0], Q: [x, y, 0]}
ground: {points: {A: [-a/2, -b/2, h], B: [a/2, -b/2, h], C: [0, b/2, h]}}
connections:
  A: {string: {path: [ground.A, top.A]}}
  B: {string: {path: [ground.B, top.B]}}
  C: {string: {path: [ground.C, top.C]}}
loads: {W: {gravity: g}, P: {force: {at: top.Q, along: -z, magnitude: P}}}
"""


def test_a_plate_that_hangs_on_three_cables_has_the_forces_of_statics_where_it_starts() -> None:
    """About the edge A B: C b = (m g + 2 P (y/b + 1/2)) b/2; about the middle: (B - A) a/2 = P x. It may sway in three
    ways, whose general pose is too long to write."""
    first, third = fb.System.from_text(PLATE).solve(["tension of A", "tension of C"]).answers
    C = "(m*g/2 + P*(y/b + 1/2))"
    assert_same_function(to_python(third.expression), C, {})
    assert_same_function(to_python(first.expression), f"(m*g + P - {C})/2 - P*x/a", {})
    assert any("in which the system rests" in note for note in first.notes)


def test_what_has_no_formula_in_any_phase_is_refused_with_its_reason_beside_what_has_one() -> None:
    asked = ["tension of A", "largest P so that A stays taut", "time when A goes slack"]
    first, *others = fb.System.from_text(PLATE).solve(asked).answers
    assert first.expression is not None
    assert all(answer.expression is None and "would have more than" in answer.reason for answer in others)


def test_what_is_not_in_equilibrium_at_the_start_has_no_formula_of_statics() -> None:
    pushed = PLATE.replace("along: -z", "along: x")
    (answer,) = fb.System.from_text(pushed).solve("tension of A").answers
    assert answer.expression is None
    assert not any("in which the system rests" in note for note in answer.notes)
