"""Time stepping with contacts: exact rest, first order otherwise, no energy from nowhere, many bodies at once."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import freebody as fb
from freebody.numeric.engine.course import Status
from freebody.numeric.options import SimulationOptions
from freebody.numeric.reference import Reference
from freebody.numeric.timestepping.run import Stepped, run_moreau
from freebody.system.system import System

G = 9.81
WEIGHT = {"weight": {"gravity": f"{G} m/s^2"}}
FLOOR = {"lines": {"floor": {"along": "right"}}}
TILT = math.radians(30.0)


def stepped(data: dict[str, Any], until: float, step: float, **more: Any) -> Stepped:
    reference = Reference(System.from_data(data))
    q = reference.assemble()
    poses, velocities = reference.by_body(q, reference.velocities(q))
    more.setdefault("outputs", np.linspace(0.0, until, 11))
    options = SimulationOptions(method="moreau", step=step)
    result = run_moreau(reference.numbers(), poses, velocities, until, options, **more)
    assert result.course.status is Status.FINISHED, result.course.message
    for array in (result.course.poses, result.course.velocities, result.contacts.normal, result.course.multipliers):
        assert np.isfinite(array).all()
    return result


def energy(result: Stepped) -> Any:
    """(n_times,) kinetic and potential energy of gravity [J]."""
    numbers, course = result.scene.numbers, result.course
    total = np.zeros(len(course.times))
    for k, body in enumerate(numbers.system.moving):
        m, i = numbers.number(body.mass), numbers.number(body.inertia) if body.turns else 0.0
        v = course.velocities[:, k]
        total += 0.5 * m * (v[:, 0] ** 2 + v[:, 1] ** 2) + 0.5 * i * v[:, 2] ** 2 + m * G * course.poses[:, k, 1]
    return total


def on_slope(friction: float, **more: Any) -> dict[str, Any]:
    """A block of 0.4 m by 0.2 m on a slope of 30 degrees that falls to the right."""
    centre = [0.1 * math.sin(TILT), 0.1 * math.cos(TILT)]
    return {
        "ground": {"lines": {"slope": {"along": "-30 deg"}}},
        "bodies": {
            "block": {"rectangle": {"mass": "1 kg", "width": "0.4 m", "height": "0.2 m"}, "at": centre}
            | {"angle": "-30 deg"}
            | more
        },
        "loads": WEIGHT,
        "connections": {"it": {"contact": {"between": ["block", "ground.slope"], "friction": friction}}},
    }


def ball(height: float, restitution: float, radius: float = 0.1) -> dict[str, Any]:
    return {
        "ground": FLOOR,
        "bodies": {"ball": {"disk": {"mass": "2 kg", "radius": radius}, "at": [0, height + radius]}},
        "loads": WEIGHT,
        "connections": {"it": {"contact": {"between": ["ball", "ground.floor"], "restitution": restitution}}},
    }


def pile(n: int, seed: int, n_boxes: int = 0, restitution: float = 0.0, mirror: int = 1) -> dict[str, Any]:
    """Circles and boxes above the floor of a box."""
    random = np.random.default_rng(seed)
    bodies: dict[str, Any] = {}
    for k in range(n):
        x, y = 0.25 * (k % 6) - 0.6 + random.uniform(-0.01, 0.01), 0.15 + 0.28 * (k // 6)
        size, angle = random.uniform(0.07, 0.1), random.uniform(-1.0, 1.0)
        mass = f"{random.uniform(0.5, 2.0)} kg"
        shape: dict[str, Any] = {"disk": {"mass": mass, "radius": size}}
        if k < n_boxes:
            shape = {"rectangle": {"mass": mass, "width": 1.7 * size, "height": 1.2 * size}}
        bodies[f"b{k}"] = shape | {"at": [mirror * x, y], "angle": mirror * angle}
    walls = {
        "floor": {"along": "right"},
        "left": {"along": "down", "through": [-0.8, 0]},
        "right": {"along": "up", "through": [0.8, 0]},
    }
    contact = {"among": "all", "friction": 0.4, "restitution": restitution}
    return {"ground": {"lines": walls}, "bodies": bodies, "loads": WEIGHT, "connections": {"it": {"contact": contact}}}


# -- one body ---------------------------------------------------------------------------------
@pytest.mark.parametrize("step", [0.02, 0.1])
def test_block_on_a_slope_holds_without_creep_just_above_the_critical_friction(step: float) -> None:
    result = stepped(on_slope(math.tan(TILT) * (1.0 + 1e-9)), 100.0, step)
    moved = result.course.poses[:, 0] - result.course.poses[0, 0]
    assert np.abs(moved).max() < 1e-12
    forces = result.contacts
    assert forces.normal[-2:].sum() == pytest.approx(G * math.cos(TILT), rel=1e-9)
    assert abs(forces.friction[-2:].sum()) == pytest.approx(G * math.sin(TILT), rel=1e-9)


def test_block_slides_just_below_the_critical_friction() -> None:
    mu = math.tan(TILT) * (1.0 - 1e-6)
    result = stepped(on_slope(mu), 10.0, 0.01)
    acceleration = G * (math.sin(TILT) - mu * math.cos(TILT))
    assert np.hypot(*result.course.velocities[-1, 0, :2]) == pytest.approx(10.0 * acceleration, rel=1e-6)


def test_sliding_block_has_the_exact_acceleration() -> None:
    result = stepped(on_slope(0.3), 2.0, 0.01)
    acceleration = G * (math.sin(TILT) - 0.3 * math.cos(TILT))
    travel = np.hypot(*(result.course.poses[-1, 0, :2] - result.course.poses[0, 0, :2]))
    assert travel == pytest.approx(0.5 * acceleration * 4.0, rel=1e-9)
    assert np.allclose(np.hypot(*result.course.velocities[:, 0, :2].T), acceleration * result.course.times, rtol=1e-9)


def test_static_friction_that_exceeds_the_kinetic_one_holds_until_it_is_passed() -> None:
    data = on_slope(0.0)
    data["connections"]["it"]["contact"]["friction"] = {"static": 0.6, "kinetic": 0.2}
    assert np.abs(stepped(data, 5.0, 0.01).course.velocities).max() < 1e-12
    data["bodies"]["block"]["velocity"] = [0.1 * math.cos(TILT), -0.1 * math.sin(TILT)]
    result = stepped(data, 1.0, 1e-3)
    speed = 0.1 + G * (math.sin(TILT) - 0.2 * math.cos(TILT))
    assert np.hypot(*result.course.velocities[-1, 0, :2]) == pytest.approx(speed, rel=1e-3)


def test_disk_begins_to_roll_at_two_thirds_of_its_launch_speed() -> None:
    data = ball(0.0, 0.0)
    data["bodies"]["ball"]["velocity"] = [3.0, 0.0]
    data["connections"]["it"]["contact"]["friction"] = 0.2
    result = stepped(data, 2.0, 1e-3)
    x, _y, w = result.course.velocities[-1, 0]
    assert x == pytest.approx(2.0, rel=1e-9)
    assert w == pytest.approx(-20.0, rel=1e-9)


def test_rolling_resistance_stops_a_wheel_where_the_work_says() -> None:
    data = ball(0.0, 0.0)
    data["bodies"]["ball"] |= {"velocity": [1.0, 0.0], "angular_velocity": -10.0}
    data["connections"]["it"]["contact"] |= {"friction": 0.5, "rolling_resistance": "0.002 m"}
    result = stepped(data, 10.0, 1e-3)
    travel = 0.75 * 2.0 * 1.0 / (2.0 * G * 0.002 / 0.1)  # kinetic energy = torque * angle
    assert result.course.poses[-1, 0, 0] == pytest.approx(travel, rel=2e-3)
    assert np.abs(result.course.velocities[-1]).max() < 1e-12


@pytest.mark.parametrize("restitution", [0.5, 0.8])
def test_bouncing_ball_follows_the_exact_times_to_first_order(restitution: float) -> None:
    height = 1.0
    fall = math.sqrt(2.0 * height / G)
    until = fall * (1.0 + 2.0 * restitution + restitution**2)  # the top after the second bounce
    for step in (4e-3, 1e-3, 2.5e-4):
        result = stepped(ball(height, restitution), until, step)
        error = abs(result.course.poses[-1, 0, 1] - 0.1 - height * restitution**4)
        assert error < step * math.sqrt(2.0 * G * height)


def test_elastic_ball_keeps_its_energy_exactly() -> None:
    result = stepped(ball(1.0, 1.0), 20.0, 1e-2, outputs=np.linspace(0.0, 20.0, 401))
    e = energy(result)
    assert np.abs(e - e[0]).max() < 1e-9 * e[0]


# -- piles ------------------------------------------------------------------------------------
def test_stack_of_ten_boxes_rests_and_every_floor_carries_what_is_above() -> None:
    box = {"rectangle": {"mass": "1 kg", "width": "0.3 m", "height": "0.2 m"}}
    bodies = {f"b{k}": box | {"at": [0.0, 0.1 + 0.2 * k]} for k in range(10)}
    contact = {"among": "all", "friction": 0.4}
    data = {"ground": FLOOR, "bodies": bodies, "loads": WEIGHT, "connections": {"it": {"contact": contact}}}
    result = stepped(data, 5.0, 0.01, max_sweeps=5000)
    assert np.abs(result.course.poses[-1] - result.course.poses[0]).max() < 1e-9
    names, forces = result.names(), result.contacts
    last = range(int(forces.ptr[-2]), int(forces.ptr[-1]))
    for k in range(10):
        under = "floor" if k == 0 else f"b{k - 1}"
        normal = sum(forces.normal[i] for i in last if _is_between(names[i], f"b{k}", under))
        assert normal == pytest.approx((10 - k) * G, rel=1e-6)


def _is_between(name: str, first: str, second: str) -> bool:
    words = name.removeprefix("it.").replace(".", " ").split()
    return {first, second} <= set(words)


def test_thirty_circles_come_to_rest_on_the_floor_that_carries_their_weight() -> None:
    result = stepped(pile(30, seed=3), 12.0, 2e-3, outputs=np.linspace(0.0, 12.0, 61), max_sweeps=2000)
    course, forces = result.course, result.contacts
    assert np.abs(course.velocities[-1]).max() < 1e-8
    assert result.penetration < 1e-4
    names = result.names()
    last = range(int(forces.ptr[-2]), int(forces.ptr[-1]))
    weight = G * sum(result.scene.numbers.number(b.mass) for b in result.scene.numbers.system.moving)
    # friction pushes the measure of slip on: along the walls, which run down on the left and up on the right
    carried = sum(forces.normal[i] for i in last if names[i].endswith("on floor"))
    carried -= sum(forces.friction[i] for i in last if names[i].endswith("on left"))
    carried += sum(forces.friction[i] for i in last if names[i].endswith("on right"))
    assert carried == pytest.approx(weight, rel=1e-6)


@pytest.mark.parametrize("restitution", [0.0, 0.5, 1.0])
@pytest.mark.parametrize("seed", [1, 2])
def test_energy_never_grows(restitution: float, seed: int) -> None:
    result = stepped(pile(18, seed, 6, restitution), 2.0, 2e-3, outputs=np.linspace(0.0, 2.0, 1001))
    e = energy(result)
    assert np.diff(e).max() < 2e-3 * (e[0] - e.min() + 1.0)
    assert (np.diff(result.losses) < 1e-6 * e[0]).all()


def test_the_same_scene_twice_gives_the_same_numbers() -> None:
    first, second = (stepped(pile(18, 5, 6), 1.0, 2e-3) for _ in range(2))
    assert (first.course.poses == second.course.poses).all()
    assert (first.contacts.normal == second.contacts.normal).all()


@pytest.mark.parametrize(("n_boxes", "until", "allowed"), [(0, 0.5, 1e-9), (4, 0.25, 1e-4)])
def test_mirrored_scene_gives_the_mirrored_motion(n_boxes: int, until: float, allowed: float) -> None:
    # corners of boxes change places, so their gaps are closed in another order
    first, second = (stepped(pile(12, 5, n_boxes, mirror=m), until, 1e-3, max_sweeps=5000) for m in (1, -1))
    assert np.allclose(first.course.poses[-1], second.course.poses[-1] * [-1.0, 1.0, -1.0], atol=allowed)


@pytest.mark.parametrize("seed", range(6))
def test_random_scenes_give_finite_results_without_deep_penetration(seed: int) -> None:
    random = np.random.default_rng(seed)
    n = int(random.integers(2, 31))
    result = stepped(pile(n, seed, int(random.integers(0, n)), float(random.choice([0.0, 0.3]))), 2.0, 2e-3)
    assert result.penetration < 0.02
    poses = result.course.poses[:, :-1]
    assert poses[..., 1].min() > 0.0
    assert np.abs(poses[..., 0]).max() < 0.8


# -- joints, stops, brakes --------------------------------------------------------------------
def cradle(n: int, gap: float) -> dict[str, Any]:
    """Balls on rods that hang side by side; the first one is drawn aside."""
    bodies: dict[str, Any] = {}
    connections: dict[str, Any] = {}
    points: dict[str, Any] = {}
    for k in range(n):
        x, angle = k * (0.2 + gap), -0.5 if k == 0 else 0.0
        points[f"P{k}"] = [x, 0]
        place = [x + math.sin(angle), -math.cos(angle)]
        bodies[f"ball{k}"] = {"disk": {"mass": "1 kg", "radius": "0.1 m"}, "at": place, "angle": angle}
        bodies[f"ball{k}"]["points"] = {"eye": [0, 1]}
        connections[f"pin{k}"] = {"pin": [f"ground.P{k}", f"ball{k}.eye"]}
    connections["it"] = {"contact": {"among": list(bodies), "restitution": 1}}
    return {"ground": {"points": points}, "bodies": bodies, "loads": WEIGHT, "connections": connections}


def test_newtons_cradle_hands_the_swing_to_the_last_ball() -> None:
    result = stepped(cradle(3, 1e-3), 1.2, 2e-4, outputs=np.linspace(0.0, 1.2, 121))
    angles = result.course.poses[:, :3, 2]
    assert angles[:, 2].max() == pytest.approx(0.5, abs=0.01)
    after = np.argmax(angles[:, 2])
    assert np.abs(angles[after, :2]).max() < 0.02
    e = energy(result)
    assert np.abs(e - e[0]).max() < 1e-3 * (e[0] - e.min() + 1.0)
    assert result.course.place_gap < 1e-10


def test_joints_do_not_drift() -> None:
    result = stepped(cradle(1, 0.0) | {"connections": {"pin0": {"pin": ["ground.P0", "ball0.eye"]}}}, 20.0, 5e-3)
    x, y, _angle = result.course.poses[:, 0].T
    assert np.abs(np.hypot(x, y) - 1.0).max() < 1e-12
    e = energy(result)
    assert np.abs(e - e[0]).max() < 1e-3


def test_stop_holds_a_cart_and_restitution_throws_it_back() -> None:
    data = {
        "bodies": {"cart": {"particle": {"mass": "1 kg"}, "at": ["1 m", 0], "velocity": ["-1 m/s", 0]}},
        "measures": {"x": "x of cart"},
        "connections": {
            "rail": {"slider": {"body": "cart", "along": "right"}},
            "it": {"stop": {"measure": "x", "min": 0, "restitution": 0.5}},
        },
    }
    result = stepped(data, 2.0, 1e-3)
    assert result.course.velocities[-1, 0, 0] == pytest.approx(0.5, rel=1e-9)
    assert result.course.poses[-1, 0, 0] == pytest.approx(0.5, abs=2e-3)


def test_brake_stops_a_drum_when_momentum_says_and_then_holds_it() -> None:
    data = {
        "bodies": {"drum": {"disk": {"mass": "1 kg", "radius": "0.1 m"}, "angular_velocity": "10 rad/s"}},
        "connections": {
            "p": {"pin": ["ground.A", "drum"]},
            "it": {"brake": {"between": ["drum", "ground"], "torque": "0.1 N m"}},
        },
    }
    result = stepped(data, 1.0, 1e-3, outputs=np.array([0.25, 1.0]))
    inertia = 0.5 * 0.1**2
    assert result.course.velocities[0, 0, 2] == pytest.approx(10.0 - 0.1 / inertia * 0.25, rel=1e-9)
    assert abs(result.course.velocities[1, 0, 2]) < 1e-15
    assert result.course.poses[1, 0, 2] == pytest.approx(10.0**2 * inertia / (2.0 * 0.1), rel=1e-3)


def test_friction_of_a_slider_follows_the_normal_force_of_its_guide() -> None:
    data = {
        "bodies": {"block": {"rectangle": {"mass": "1 kg", "width": "1 m", "height": "1 m"}, "velocity": [3, 0]}},
        "loads": WEIGHT,
        "connections": {"rail": {"slider": {"body": "block", "along": "right", "friction": 0.2}}},
    }
    result = stepped(data, 1.0, 1e-3)
    assert result.course.velocities[-1, 0, 0] == pytest.approx(3.0 - 0.2 * G, rel=1e-9)


def test_ideal_rolling_contact_grips_as_long_as_it_presses() -> None:
    data = {
        "ground": {"lines": {"slope": {"along": "-30 deg"}}},
        "bodies": {"wheel": {"disk": {"mass": "1 kg", "radius": "1 m"}}},
        "loads": WEIGHT,
        "connections": {"it": {"rolling": {"body": "wheel", "on": "slope"}}},
    }
    result = stepped(data, 1.0, 1e-2)
    speed = np.hypot(*result.course.velocities[-1, 0, :2])
    assert speed == pytest.approx(2.0 / 3.0 * G * math.sin(TILT), rel=1e-9)


def test_bob_leaves_its_circle_where_the_string_goes_slack() -> None:
    speed = math.sqrt(3.5 * G)  # the string is slack from 60 degrees before the top on
    data = {
        "ground": {"points": {"A": [0, 0]}},
        "bodies": {"bob": {"particle": {"mass": "1 kg"}, "at": [0, "-1 m"], "velocity": [speed, 0]}},
        "loads": WEIGHT,
        "connections": {"rope": {"string": {"from": "ground.A", "to": "bob"}}},
    }
    result = stepped(data, 2.0, 2e-4, outputs=np.linspace(0.0, 2.0, 401))
    x, y = result.course.poses[:, 0, :2].T
    assert y.max() == pytest.approx(0.6875, abs=1e-3)
    assert np.hypot(x, y).max() < 1.0 + 1e-6
    assert np.hypot(x, y)[-1] == pytest.approx(1.0, abs=1e-3) or np.hypot(x, y)[-1] < 1.0


def test_the_residual_is_reported_when_the_sweeps_do_not_suffice() -> None:
    result = stepped(pile(30, seed=3), 1.0, 5e-3, max_sweeps=3)
    assert result.n_capped > 0
    assert "sweeps" in result.course.message
    assert result.residual > 0.0


def test_what_massless_bodies_count_as_is_small_and_said() -> None:
    """A pendulum on a massless rod beside a disk: theta'' = -g/L cos(theta) from the horizontal, to 1e-3."""
    system = fb.System.from_text("""
ground: {points: {A: [0, 2 m]}, lines: {floor: {along: right}}}
bodies:
  rod: {rod: {length: 1 m}, angle: 0}
  bob: {particle: {mass: 1 kg}}
  disk: {disk: {mass: 2 kg, radius: 0.1 m}, at: [3 m, 1 m]}
connections:
  O: {pin: [ground.A, rod.start]}
  P: {weld: [rod.end, bob]}
  c: {contact: {between: [disk, floor]}}
loads: {w: {gravity: 9.81 m/s^2}}
measures: {theta: angle of rod}
""")
    stepped = system.simulate(0.4, method="moreau", step=2e-4)
    assert "rod: without mass or moment of inertia" in stepped.message
    exact = system.simulate(0.4).dataset["theta"][-1]
    assert float(stepped.dataset["theta"][-1]) == pytest.approx(float(exact), abs=1e-3)
