"""The compiled engine in space: kernels against their statements, and motions against what is known of them."""

from __future__ import annotations

import itertools
import math
import time
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import scipy.special
from numpy.typing import NDArray

import freebody as fb
from freebody.language.expression import Number
from freebody.language.parser import parse
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Bearing, Distance
from freebody.measures.geometry import GROUND, Direction, Point, SpatialPose, Vector
from freebody.measures.lead import Lead, LeadInPlane
from freebody.measures.turn import Alignment, Turn
from freebody.numeric.engine.course import Status, Trajectory
from freebody.numeric.engine.engine import Engine
from freebody.numeric.engine.evaluator import Observer
from freebody.numeric.engine.integrators.radau5 import Slopes
from freebody.numeric.kernels import stepping
from freebody.numeric.numbers import Numbers
from freebody.numeric.options import SimulationOptions
from freebody.numeric.reference import Reference
from freebody.numeric.rotation import from_quaternion, matrix, rotation_vector
from kernel_runs import largest_gaps

Array = NDArray[np.float64]
SEED = 7


def engine_of(system: fb.System, **rest: Any) -> tuple[Engine, Numbers]:
    numbers = Reference(system).numbers()
    return Engine(numbers, **rest), numbers


def state_of(engine: Engine, numbers: Numbers, bodies: list[tuple[Array, Array, Array, Array]]) -> Array:
    """A state from center, rotation matrix, velocity and angular velocity (ground axes) of every body."""
    poses, velocities = np.zeros((len(bodies), 6)), np.zeros((len(bodies), 6))
    for k, ((r, R, v, w), body) in enumerate(zip(bodies, numbers.system.moving, strict=True)):
        P = numbers.principal(body.name)
        poses[k], velocities[k] = np.append(r, rotation_vector(R @ P)), np.append(v, (R @ P).T @ w)
    return engine.state(poses, velocities)


# -- kernels ----------------------------------------------------------------------------------
class FloatGeometry:
    """What statements see of poses in numbers, center and rotation matrix; bearings are the nearest to `near`."""

    def __init__(self, poses: dict[str, tuple[Array, Array]], near: float = 0.0) -> None:
        self.poses = {GROUND: (np.zeros(3), np.eye(3)), **poses}
        self.bearing = near

    def scalar(self, expr: Any) -> float:
        assert isinstance(expr, Number)
        return float(expr.value)

    def pose(self, body: str) -> SpatialPose[float]:
        r, R = self.poses[body]
        x, y, z = (Vector(*R[:, j].tolist()) for j in range(3))
        return SpatialPose(Vector(*r.tolist()), (x, y, z))

    def root(self, x: float) -> float:
        return math.sqrt(x)

    def tangent(self, v: Vector[float], offset: float) -> tuple[float, float]:
        length = math.sqrt(v.x**2 + v.y**2 - offset**2)
        angle = math.atan2(length * v.y - offset * v.x, length * v.x + offset * v.y)
        self.bearing = angle + 2.0 * math.pi * round((self.bearing - angle) / (2.0 * math.pi))
        return length, self.bearing

    def apply(self, expr: Any, values: dict[str, float], *, here: bool = False) -> float:
        raise NotImplementedError


def number(x: float) -> Any:
    return parse(repr(x))


def triple(x: float, y: float, z: float) -> Any:
    return number(x), number(y), number(z)


A, B, C = "a", "b", "c"
ON_A, ON_B = Point(A, triple(0.3, -0.2, 0.5)), Point(B, triple(0.1, 0.4, -0.6))
FIXED = Point("wall", triple(0.4, 0.1, -0.3))
ALONG, ACROSS, OUT = triple(0.6, 0.8, 0.0), triple(-0.48, 0.36, 0.8), triple(0.64, -0.48, 0.6)
MEASURES: dict[str, Measure] = {
    "displacement along the ground": Displacement(ON_A, ON_B, Direction(GROUND, ACROSS)),
    "displacement of a mass centre": Displacement(Point(A, triple(0.0, 0.0, 0.0)), FIXED, Direction(GROUND, ACROSS)),
    "displacement along a body": Displacement(ON_A, ON_B, Direction(C, ACROSS)),
    "displacement along its own body": Displacement(ON_A, ON_B, Direction(A, ACROSS)),
    "displacement from a fixed body": Displacement(ON_A, FIXED, Direction("wall", ACROSS)),
    "distance": Distance(ON_A, ON_B),
    "alignment of a fixed direction": Alignment(Direction("wall", ALONG), Direction(B, ACROSS)),
    "alignment along a fixed direction": Alignment(Direction(A, ALONG), Direction(GROUND, ACROSS)),
    "alignment": Alignment(Direction(A, ALONG), Direction(B, ACROSS)),
    "turn": Turn(Direction(A, OUT), Direction(B, ALONG), Direction(B, ACROSS), number(0.3)),
    "turn from a fixed body": Turn(Direction(A, OUT), Direction("wall", ALONG), Direction("wall", ACROSS)),
    "angle": Angle(A, GROUND, number(0.2)),
    "angle to a body": Angle(A, B, number(0.2)),
    "angle to a fixed body": Angle(A, "wall"),
    "bearing": Bearing(ON_A, ON_B, C, number(0.2)),
    "bearing from the ground": Bearing(ON_A, FIXED),
    "lead": Lead(ON_A, ON_B, number(0.35)),
    "lead in a plane": LeadInPlane(ON_A, ON_B, number(0.35), Direction(GROUND, ALONG), Direction(GROUND, ACROSS)),
    "lead in a plane of a body": LeadInPlane(ON_A, ON_B, number(0.2), Direction(C, ALONG), Direction(C, ACROSS)),
}
THREE_BODIES = """
space: true
bodies:
  a: {body: {mass: 1 kg, inertia: [[0.5, 0.1, 0.05], [0.1, 0.7, -0.08], [0.05, -0.08, 0.9]]}}
  b: {body: {mass: 2 kg, inertia: [[0.9, -0.2, 0.1], [-0.2, 0.8, 0.15], [0.1, 0.15, 1.1]]}}
  c: {box: {mass: 1 kg, size: [1 m, 2 m, 3 m]}}
  wall:
    box: {mass: 1 kg, size: [1 m, 1 m, 1 m]}
    fixed: true
    at: {center: [0.2, -0.3, 0.4]}
    turned: [0.7 about x, 0.4 about z]
"""
EIGHTH = np.array([1 / 280, -4 / 105, 1 / 5, -4 / 5, 0, 4 / 5, -1 / 5, 4 / 105, -1 / 280])  # first derivative
SECOND = np.array([-1 / 560, 8 / 315, -1 / 5, 8 / 5, -205 / 72, 8 / 5, -1 / 5, 8 / 315, -1 / 560])


def derivatives(f: Callable[[float], float], h: float = 0.002) -> tuple[float, float]:
    """First and second derivative at zero, with an error of order 8."""
    values = np.array([f(k * h) for k in range(-4, 5)])
    return float(EIGHTH @ values) / h, float(SECOND @ values) / h**2


@pytest.mark.parametrize("name", MEASURES)
def test_a_kernel_of_space_gives_value_gradient_and_bias_of_its_statement(name: str) -> None:
    measure = MEASURES[name]
    engine, numbers = engine_of(fb.System.from_text(THREE_BODIES), tracked=[measure])
    names = [b.name for b in numbers.system.moving]
    wall = numbers.fixed_frame("wall")
    rng = np.random.default_rng(SEED)
    for _ in range(4):
        print("seed", SEED)
        centers = np.array([[0.0, 0.0, 0.0], [2.0, 1.0, 0.5], [-1.0, 0.5, 1.0]]) + 0.2 * rng.standard_normal((3, 3))
        frames = [matrix(rng.standard_normal(3)) for _ in names]
        v, w = rng.standard_normal((3, 3)), rng.standard_normal((3, 3))  # ground axes, principal axes

        def value(s: float, v: Array, w: Array) -> float:
            """The value after a motion without acceleration: straight on, and round an axis fixed in the frame."""
            poses = {
                n: (centers[k] + s * v[k], frames[k] @ matrix(s * w[k]) @ numbers.principal(n).T)  # noqa: B023
                for k, n in enumerate(names)
            }
            g = FloatGeometry({**poses, "wall": wall}, near)  # noqa: B023
            found = measure.value(g)
            bearings.append(g.bearing)  # noqa: B023
            return found

        near, bearings = 0.0, list[float]()
        value(0.0, v, w)
        near = bearings[0]
        y = engine.state(
            np.array([np.append(r, rotation_vector(R)) for r, R in zip(centers, frames, strict=True)]),
            np.hstack([v, w]),
        )
        engine.align(y, 0.0, lambda m: value(0.0, v, w))  # noqa: B023
        engine.evaluate(y, 0.0)
        row = engine.rows[measure]
        gradient = engine.gradient_of(row).reshape(-1, 6)
        found = engine.room.rows[row]
        assert found[0] == pytest.approx(value(0.0, v, w), abs=1e-13)
        for k in range(3):
            for i in range(6):
                unit = np.zeros((3, 6))
                unit[k, i] = 1.0
                slope = derivatives(lambda s, u=unit: value(s, u[:, :3], u[:, 3:]))[0]
                assert gradient[k, i] == pytest.approx(slope, abs=1e-10), (names[k], i)
        rate, bias = derivatives(lambda s: value(s, v, w))  # noqa: B023
        assert float(gradient[:3].ravel() @ np.hstack([v, w]).ravel()) == pytest.approx(rate, abs=1e-9)
        assert found[2] == pytest.approx(bias, abs=1e-7)


# -- a free body ------------------------------------------------------------------------------
FREE = "{space: true, bodies: {it: {body: {mass: 2 kg, inertia: [1, 2, 2.5]}}}}"
MOMENTS = np.array([1.0, 2.0, 2.5])


def run(
    engine: Engine, y: Array, until: float, n: int = 100, tolerance: float = 1e-12, method: str = "dop853", **rest: Any
) -> Trajectory:
    options = SimulationOptions(method=method, tolerance=tolerance)
    course = engine.run(y, until, options, outputs=np.linspace(0.0, until, n + 1), **rest)
    assert course.status is Status.FINISHED, course.message
    return course


def free_run(until: float, n: int, w: Array, tolerance: float = 1e-12) -> Trajectory:
    engine, numbers = engine_of(fb.System.from_text(FREE))
    y = state_of(engine, numbers, [(np.zeros(3), np.eye(3), np.array([0.1, -0.2, 0.3]), w)])
    return run(engine, y, until, n, tolerance)


def test_a_free_asymmetric_body_keeps_energy_and_angular_momentum() -> None:
    course = free_run(1000.0, 500, np.array([0.3, 1.0, 0.2]))
    rotation = course.rotation
    assert rotation is not None
    w, q = rotation.velocities_in_body[:, 0], rotation.quaternions[:, 0]
    energy = 0.5 * (MOMENTS * w**2).sum(axis=1)
    momentum = np.array([from_quaternion(r) @ (MOMENTS * x) for r, x in zip(q, w, strict=True)])
    assert np.abs(energy / energy[0] - 1.0).max() < 1e-9
    assert np.abs(momentum - momentum[0]).max() < 1e-9 * np.linalg.norm(momentum[0])
    assert np.abs(np.linalg.norm(q, axis=1) - 1.0).max() < 1e-12


def test_a_free_asymmetric_body_turns_by_jacobis_functions() -> None:
    # L^2 > 2 T I2 and w2(0) = 0: w1 = a cn, w2 = b sn, w3 = c dn (Landau & Lifshitz, Mechanics, sec. 37)
    i1, i2, i3 = MOMENTS
    a, c = 0.4, 1.1
    energy2, square = i1 * a**2 + i3 * c**2, (i1 * a) ** 2 + (i3 * c) ** 2
    assert square > energy2 * i2
    b = math.sqrt((energy2 * i3 - square) / (i2 * (i3 - i2)))
    rate = math.sqrt((i3 - i2) * (square - energy2 * i1) / (i1 * i2 * i3))
    m = (i2 - i1) * (energy2 * i3 - square) / ((i3 - i2) * (square - energy2 * i1))
    course = free_run(50.0, 400, np.array([a, 0.0, c]))
    assert course.rotation is not None
    sn, cn, dn, _ = scipy.special.ellipj(rate * course.times, m)
    w = course.rotation.velocities_in_body[:, 0]
    sign = math.copysign(1.0, float(w[1, 1]))
    assert sign == math.copysign(1.0, (i3 - i1) * a * c / i2)
    assert np.abs(w - np.column_stack([a * cn, sign * b * sn, c * dn])).max() < 1e-8


def test_a_rotation_goes_through_every_pose_without_a_jump() -> None:
    course = free_run(300.0, 6000, np.array([0.02, 1.0, 0.01]), 1e-10)  # it tumbles about the middle axis
    assert course.rotation is not None
    q, w = course.rotation.quaternions[:, 0], course.rotation.velocities[:, 0]
    step = 2.0 * np.linalg.norm(np.diff(q, axis=0), axis=1)
    fastest = np.linalg.norm(w, axis=1).max() * 300.0 / 6000
    assert step.max() < 1.001 * fastest  # continuous in sign, too
    poles = np.array([from_quaternion(r) for r in q])
    assert poles[:, 2, 1].max() > 0.99 or poles[:, 1, 1].min() < -0.99
    # the angular velocity is that of the quaternions
    between = np.array([rotation_vector(from_quaternion(b) @ from_quaternion(a).T) for a, b in itertools.pairwise(q)])
    assert np.abs(between / (300.0 / 6000) - 0.5 * (w[1:] + w[:-1])).max() < 2e-3


# -- joints -----------------------------------------------------------------------------------
TOP = """
space: true
bodies:
  top:
    body: {mass: 0.5 kg, inertia: [0.002, 0.002, 0.001]}
    points: {tip: [0, 0, -0.1]}
connections: {ball: {spherical: [ground.O, top.tip]}}
loads: {weight: {gravity: {strength: 9.81, along: [0, 0, -1]}}}
"""


def test_a_heavy_symmetric_top_keeps_its_three_integrals() -> None:
    engine, numbers = engine_of(fb.System.from_text(TOP))
    R = matrix(np.array([0.9, 0.0, 0.0]))
    w = R @ np.array([1.0, 0.5, 120.0])
    r = R @ np.array([0.0, 0.0, 0.1])
    course = run(engine, state_of(engine, numbers, [(r, R, np.cross(w, r), w)]), 10.0)
    assert course.rotation is not None
    moments = np.array([0.002 + 0.005, 0.002 + 0.005, 0.001])  # about the tip
    w = course.rotation.velocities_in_body[:, 0]
    frames = [from_quaternion(q) for q in course.rotation.quaternions[:, 0]]
    height = np.array([0.1 * R[2, 2] for R in frames])
    energy = 0.5 * (moments * w**2).sum(axis=1) + 0.5 * 9.81 * height
    vertical = np.array([(R @ (moments * x))[2] for R, x in zip(frames, w, strict=True)])
    assert np.abs(energy / energy[0] - 1.0).max() < 1e-10
    assert np.abs(vertical / vertical[0] - 1.0).max() < 1e-10
    assert np.abs(w[:, 2] / w[0, 2] - 1.0).max() < 1e-10
    assert np.ptp(height) > 1e-3  # it nutates
    assert course.place_gap < 1e-12


BOX = "{box: {mass: 1.3 kg, size: [1 m, 0.1 m, 0.2 m]}}"
PENDULUM = f"""
space: true
bodies: {{it: {BOX}}}
connections:
  hinge: {{revolute: {{first: ground.O, second: it.left, about: z}}}}
loads: {{weight: {{gravity: 9.81}}}}
"""
INERTIA = 1.3 * (1.0 + 0.01) / 12
FLAT = f"""
bodies: {{it: {{body: {{mass: 1.3 kg, inertia: {INERTIA!r}}}, points: {{left: [-0.5, 0]}}}}}}
connections:
  hinge: {{pin: [ground.O, it.left]}}
loads: {{weight: {{gravity: 9.81}}}}
"""


def pendulum(method: str = "dop853", tolerance: float = 1e-12) -> Trajectory:
    engine, numbers = engine_of(fb.System.from_text(PENDULUM))
    spin = np.array([0.0, 0.0, 2.0])
    r = np.array([0.5, 0.0, 0.0])
    return run(
        engine,
        state_of(engine, numbers, [(r, np.eye(3), np.cross(spin, r), spin)]),
        10.0,
        100,
        tolerance,
        method=method,
    )


def flat_pendulum() -> Trajectory:
    engine = Engine(Reference(fb.System.from_text(FLAT)).numbers())
    return run(engine, engine.state(np.array([[0.5, 0.0, 0.0]]), np.array([[0.0, 1.0, 2.0]])), 10.0)


def test_a_pendulum_on_a_hinge_in_space_moves_like_the_planar_one() -> None:
    flat, course = flat_pendulum(), pendulum()
    assert course.rotation is not None
    assert np.abs(course.poses[:, 0, :2] - flat.poses[:, 0, :2]).max() < 1e-9
    assert np.abs(course.poses[:, 0, 2]).max() < 1e-12
    assert np.abs(course.rotation.velocities[:, 0, 2] - flat.velocities[:, 0, 2]).max() < 1e-9
    assert np.abs(course.rotation.accelerations[:, 0, 2] - flat.accelerations[:, 0, 2]).max() < 1e-8
    assert (
        np.abs(np.linalg.norm(course.multipliers[:, :3], axis=1) - np.linalg.norm(flat.multipliers, axis=1)).max()
        < 1e-8
    )


def test_implicit_steps_follow_a_pendulum_in_space() -> None:
    flat, course = flat_pendulum(), pendulum("radau5", 1e-8)
    assert np.abs(course.poses[:, 0, :2] - flat.poses[:, 0, :2]).max() < 1e-5
    assert course.rotation is not None
    assert np.abs(np.linalg.norm(course.rotation.quaternions, axis=2) - 1.0).max() < 1e-12


SPRUNG = f"""
space: true
ground: {{points: {{O: [0, 0, 0], W: [1 m, 1 m, 0.5 m]}}}}
bodies: {{it: {BOX}}}
connections: {{ball: {{spherical: [ground.O, it.left]}}}}
loads: {{spring: {{spring: {{first: ground.W, second: it.right, stiffness: 5e4 N/m, length: 0.3 m}}}}}}
"""


def test_implicit_steps_know_the_slopes_of_a_stiff_spring_in_space() -> None:
    engine, numbers = engine_of(fb.System.from_text(SPRUNG))
    R = matrix(np.array([0.4, -0.2, 0.3]))
    w = np.array([0.3, 0.5, -0.2])
    r = R @ np.array([0.5, 0.0, 0.0])
    y = state_of(engine, numbers, [(r, R, np.cross(w, r), w)])
    slopes = Slopes(engine).at(0.0, y)
    n, out = engine.n_coordinates, np.zeros((2, engine.n_y))
    for i in [*range(3), *range(n, n + 6), *range(2 * n + 1, engine.n_y)]:
        for side in (0, 1):
            moved = y.copy()
            moved[i] += (2 * side - 1) * 1e-6
            stepping.visit(engine.layout, engine.room, engine.idle, -1.0, moved, 0.0, out[side], 1)
        expected = (out[1] - out[0]) / 2e-6
        kept = np.arange(engine.n_y) != 2 * n  # the work
        assert np.abs(slopes[:, i] - expected)[kept].max() < 1e-3 * (1.0 + np.abs(expected).max()), i


def with_stop(text: str, measure: str) -> fb.System:
    stop = f"  end: {{stop: {{measure: {measure}, min: -1, restitution: 0.5}}}}\n"
    return fb.System.from_text(text.replace("loads:", stop + "loads:"))


def test_a_door_that_rebounds_from_a_stop_until_it_rests_does_what_the_planar_one_does() -> None:
    systems = with_stop(PENDULUM, "angle of it about z"), with_stop(FLAT, "angle of it")
    space, plane = (system.simulate(3.0, every=0.1).course for system in systems)
    assert [h.kind for h in space.events] == [h.kind for h in plane.events]
    assert [h.time for h in space.events] == pytest.approx([h.time for h in plane.events], abs=1e-8)
    assert np.abs(space.poses[:, 0, :2] - plane.poses[:, 0, :2]).max() < 1e-7
    assert space.rotation is not None
    assert len(space.rotation.quaternions) == len(space.times)


# -- chains -----------------------------------------------------------------------------------
def chain(n: int, shape: dict[str, Any], ends: tuple[str, str]) -> tuple[Engine, Array]:
    """n links with spherical joints, anyhow turned and moving."""
    joints = {f"j{k}": {"spherical": [f"b{k - 1}.{ends[1]}" if k else "ground.O", f"b{k}.{ends[0]}"]} for k in range(n)}
    bodies = {f"b{k}": shape for k in range(n)}
    loads = {"weight": {"gravity": "9.81 m/s^2"}}
    engine, numbers = engine_of(
        fb.System.from_data({"space": True, "bodies": bodies, "connections": joints, "loads": loads})
    )
    rng = np.random.default_rng(SEED)
    tip, speed, links = np.zeros(3), np.zeros(3), []
    for _ in range(n):
        R, w = matrix(rng.standard_normal(3)), rng.standard_normal(3)
        half = R @ np.array([0.5, 0.0, 0.0])
        links.append((tip + half, R, speed + np.cross(w, half), w))
        tip, speed = tip + 2.0 * half, speed + np.cross(w, 2.0 * half)
    return engine, state_of(engine, numbers, links)


LINK = {"box": {"mass": "1 kg", "size": ["1 m", "0.1 m", "0.2 m"]}}


def test_the_work_of_a_chain_in_space_grows_with_its_links() -> None:
    """Not with their square or cube: the factor of a long chain stays as sparse as that of a short one."""

    def seconds(n: int) -> float:
        engine, y = chain(n, LINK, ("left", "right"))
        assert max(largest_gaps(engine, y, 0.0)) < 1e-12
        engine.evaluate(y, 0.0, 10)
        best = math.inf
        for _ in range(10):
            begin = time.process_time()
            engine.evaluate(y, 0.0, 3000 // n)
            best = min(best, (time.process_time() - begin) / (3000 // n))
        return best

    assert seconds(100) < 4 * 3 * seconds(25)  # in one run, with a margin of three


def test_a_chain_in_space_keeps_its_energy() -> None:
    engine, y = chain(5, LINK, ("left", "right"))
    course = run(engine, y, 5.0)
    mass = np.divide(
        1.0, engine.layout.inverse_mass, out=np.zeros(engine.n_coordinates), where=engine.layout.inverse_mass > 0.0
    )
    states, n = engine.states(course), engine.n_coordinates
    energy = 0.5 * (states[:, n : 2 * n] ** 2 @ mass) + 9.81 * course.poses[:, :-1, 1].sum(axis=1)
    assert np.ptp(energy) < 1e-8 * np.abs(energy).max()


def test_thin_rods_have_no_spin_of_their_own_and_lend_no_mass() -> None:
    engine, y = chain(5, {"rod": {"mass": "1 kg", "length": "1 m"}}, ("start", "end"))
    assert engine.layout.has_gap[0] == 0
    inertia = [1e-9, 1 / 12, 1 / 12]
    points = {"start": [-0.5, 0, 0], "end": [0.5, 0, 0]}
    slender, z = chain(5, {"body": {"mass": 1, "inertia": inertia}, "points": points}, ("start", "end"))
    thin, thick = engine.evaluate(y, 0.0)[0], slender.evaluate(z, 0.0)[0]
    assert np.abs(thin[:, :3] - thick[:, :3]).max() < 1e-6


def test_a_hinged_thin_rod_turns_with_its_hinge() -> None:
    # the hinge decides the spin of the rod about itself, for which the rod has no moment of inertia
    engine, numbers = engine_of(
        fb.System.from_text(
            """
            space: true
            bodies: {rod: {rod: {mass: 1 kg, length: 1 m}}}
            connections: {hinge: {revolute: {first: ground.O, second: rod.start, about: z}}}
            loads: {weight: {gravity: 9.81}}
            """
        )
    )
    r = np.array([0.5, 0.0, 0.0])
    y = state_of(engine, numbers, [(r, np.eye(3), np.zeros(3), np.zeros(3))])
    a = engine.evaluate(y, 0.0)[0][0]
    assert a[:3] == pytest.approx([0.0, -0.75 * 9.81, 0.0], abs=1e-8)
    course = run(engine, y, 1.0, 10, 1e-9)
    assert np.abs(course.poses[:, 0, 2]).max() < 1e-9


# -- the border -------------------------------------------------------------------------------
def test_states_and_courses_are_the_same_seen_from_both_sides() -> None:
    engine, y = chain(3, LINK, ("left", "right"))
    poses, velocities = engine.coordinates(y)
    assert np.abs(engine.state(poses, velocities) - y).max() < 1e-14
    course = run(engine, y, 0.5, 10)
    again = engine.state_at(course, -1)
    n = engine.n_coordinates
    for k in (0, -1):
        p, _v = engine.coordinates(engine.state_at(course, k))
        assert np.abs(p[:, :3] - course.poses[k, :-1]).max() < 1e-14
    accelerations = engine.evaluate(again, 0.5)[0]
    assert np.abs(engine.accelerations(course)[-1] - accelerations.ravel()).max() < 1e-9
    assert again[2 * n] == 0.0
    options = SimulationOptions(method="dop853", tolerance=1e-12)
    further = engine.run(again, 1.0, options, start=0.5)
    direct = engine.run(y, 1.0, options)
    assert np.abs(further.poses[-1] - direct.poses[-1]).max() < 1e-8


def test_what_is_watched_along_a_motion_in_space_has_its_rates() -> None:
    engine, y = chain(2, LINK, ("left", "right"))
    course = run(engine, y, 0.01, 10)
    measure = Turn(Direction("b1", triple(1, 0, 0)), Direction("b0", triple(0, 1, 0)), Direction("b0", triple(0, 0, 1)))
    value, rate, second = Observer(engine.numbers, [measure]).along(course, [measure])[measure]
    h = 0.001
    f, g = derivatives_on(value, h)
    assert rate[5] == pytest.approx(f, abs=1e-8)
    assert second[5] == pytest.approx(g, abs=1e-5)


def derivatives_on(values: Array, h: float) -> tuple[float, float]:
    return float(EIGHTH @ values[1:10]) / h, float(SECOND @ values[1:10]) / h**2
