"""A cube that is thrown on a table, beside its flight, its first blow and what its motion loses.

Its inertia is I = m a^2/6 about every axis, so that it flies with an angular velocity that stays. Where a corner at c
from the middle hits, with J the impulse, m V = J, I W = c x J and u = v + omega x c, of the blow

    u_n' = -e u_n,    |J_t| <= mu J_n, and J_t = -mu J_n u_t'/|u_t'| where it slips on.

Sources: Newton's law of impact with friction, Pfeiffer & Glocker, Multibody Dynamics with Unilateral Contacts, ch. 8.
"""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

import freebody as fb
from example_files import FOLDER

M, A, MU, E, G = 0.1, 0.05, 0.4, 0.2, 9.81
INERTIA = M * A * A / 6
PLACE, VELOCITY, SPIN = np.array([0.0, 0.3, 0.0]), np.array([0.5, 0.0, 0.2]), np.array([3.0, 5.0, 8.0])
UP = np.array([0.0, 1.0, 0.0])


@cache
def thrown() -> fb.Simulation:
    return fb.System.load(FOLDER / "tumbling_cube.yaml").simulate(until=0.7, tolerance=1e-8)


def corners(t: float) -> np.ndarray:
    """From the middle, (8, 3), while it flies: turned by 20 degrees about x, then by the spin."""
    rotation = pytest.importorskip("scipy.spatial.transform").Rotation
    own = A / 2 * np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
    turned = rotation.from_rotvec(SPIN * t) * rotation.from_rotvec([np.radians(20.0), 0, 0])
    return np.asarray(turned.apply(own))


def lowest(t: float) -> float:
    return float(PLACE[1] - G * t * t / 2 + corners(t)[:, 1].min())


def blow(arm: np.ndarray, velocity: np.ndarray) -> np.ndarray:
    """The impulse of a blow in which the corner slips on."""
    optimize = pytest.importorskip("scipy.optimize")
    before = velocity + np.cross(SPIN, arm)

    def misses(J: np.ndarray) -> np.ndarray:
        after = before + J / M + np.cross(np.cross(arm, J) / INERTIA, arm)
        slip = after - after[1] * UP
        rubbed = J + MU * J[1] * slip / np.linalg.norm(slip)
        return np.array([rubbed[0] / M, after[1] + E * before[1], rubbed[2] / M])

    found = optimize.root(misses, [0.0, -M * before[1], 0.0], tol=1e-14)
    assert found.success
    return np.asarray(found.x)


def test_a_cube_hits_the_table_with_a_corner_and_has_the_impulse_of_friction() -> None:
    optimize = pytest.importorskip("scipy.optimize")
    looks = np.linspace(0, 0.3, 601)
    after = next(t for t in looks if lowest(t) < 0)
    time = float(optimize.brentq(lowest, after - looks[1], after, xtol=1e-15))
    first = thrown().course.contact.collisions[0]
    assert first.time == pytest.approx(time, rel=1e-8)
    arms = corners(time)
    arm = arms[arms[:, 1].argmin()]
    impulse = blow(arm, VELOCITY - G * time * UP)
    assert impulse[1] > 0
    assert list(first.impulses.values()) == pytest.approx([impulse[1]], rel=1e-7)
    assert float(np.hypot(*first.friction.values())) == pytest.approx(MU * impulse[1], rel=1e-7)
    assert sorted(abs(x) for x in first.friction.values()) == pytest.approx(sorted(abs(impulse[[0, 2]])), rel=1e-6)


def test_a_cube_comes_to_rest_on_a_face_and_never_gains_energy() -> None:
    found = thrown()
    data = found.dataset
    place, velocity, spin = (
        np.asarray(data[f"body_{name}"])[:, 0] for name in ("position", "velocity", "angular_velocity")
    )
    energy = M * (velocity**2).sum(1) / 2 + INERTIA * (spin**2).sum(1) / 2 + M * G * place[:, 1]
    assert np.diff(energy).max() < 1e-10
    assert all(hit.energy_change < 1e-15 for hit in found.course.contact.collisions)
    assert place[-1, 1] == pytest.approx(A / 2, abs=1e-9)
    assert np.abs(velocity[-1]).max() < 1e-6
    assert np.abs(np.asarray(data["body_rotation_matrix"])[-1, 0, 1]).max() == pytest.approx(1.0, abs=1e-9)
    assert found.is_complete
    last = found.events[-4:]
    assert {event.kind for event in last} == {"stops slipping"}
    assert np.ptp([event.time for event in last]) == 0.0


def test_a_cube_changes_its_momentum_by_what_the_table_gives() -> None:
    """m (v_1 - v_0) + m g t = sum of impulses + int of forces; between the blows of the flight only weight acts."""
    found = thrown()
    hits = found.course.contact.collisions
    data = found.dataset
    times, velocity = np.asarray(data["time"]), np.asarray(data["body_velocity"])[:, 0]
    inside = np.flatnonzero((times > hits[0].time) & (times < hits[1].time))
    assert len(inside) > 1
    assert np.ptp(velocity[inside] + G * times[inside, None] * UP, axis=0) == pytest.approx(np.zeros(3), abs=1e-10)
    before, after = velocity[times < hits[0].time][-1], velocity[inside[0]]
    change = M * (after - before + G * (times[inside[0]] - times[times < hits[0].time][-1]) * UP)
    assert change[1] == pytest.approx(sum(hits[0].impulses.values()), rel=1e-9)


SLIDES = """
space: {up: z}
parameters: {m: 1 kg, a: 0.2 m, h: 0.05 m, mu: 0.3, g: 9.81 m/s^2}
ground: {planes: {floor: {normal: up}}}
bodies:
  box: {box: {mass: m, size: [a, a, h]}, at: [0, 0, h/2], velocity: [V m/s, 0, 0], angular_velocity: [0, 0, W rad/s]}
connections: {c: {contact: {between: [box, floor], friction: mu}}}
loads: {w: {gravity: g}}
"""


def _slides(v: float, w: float) -> tuple[float, np.ndarray]:
    """When a box that slides on its four corners stands, and (x, y, angle). The corners share the load as four equal
    springs would, N_i = m g/4 + p x_i + q y_i, so that the moments of friction, which acts h/2 below the middle,
    balance; sliding and spinning end together."""
    integrate = pytest.importorskip("scipy.integrate")
    m, a, h, mu, g = 1.0, 0.2, 0.05, 0.3, 9.81
    own = a / 2 * np.array([[1, 1], [1, -1], [-1, 1], [-1, -1]])

    def rates(_t: float, y: np.ndarray) -> np.ndarray:
        cos, sin = np.cos(y[2]), np.sin(y[2])
        r = own @ np.array([[cos, sin], [-sin, cos]])
        slip = y[3:5] + y[5] * np.column_stack([-r[:, 1], r[:, 0]])
        way = -mu * slip / np.linalg.norm(slip, axis=1)[:, None]
        # sum N r = -h/2 sum N way, of N = m g/4 + r k
        k = np.linalg.solve(r.T @ r + h / 2 * way.T @ r, -h / 2 * way.sum(axis=0) * m * g / 4)
        force = (m * g / 4 + r @ k)[:, None] * way
        moment = float((r[:, 0] * force[:, 1] - r[:, 1] * force[:, 0]).sum())
        return np.array([*y[3:], *(force.sum(axis=0) / m), moment / (m * a * a / 6)])

    def stands(_t: float, y: np.ndarray) -> float:
        return float(np.hypot(np.hypot(y[3], y[4]), a * y[5])) - 1e-5

    stands.terminal = True
    found = integrate.solve_ivp(rates, (0, 1), [0, 0, 0, v, 0, w], events=stands, rtol=1e-10, atol=1e-12)
    return float(found.t[-1]), found.y[:3, -1]


@pytest.mark.parametrize(("v", "w"), [(0.5, 3.0), (0.3, 0.5), (0.1, 6.0)])
def test_a_box_that_slides_and_spins_comes_to_rest_with_both_at_once(v: float, w: float) -> None:
    time, pose = _slides(v, w)
    found = fb.System.from_text(SLIDES.replace("V m/s", f"{v} m/s").replace("W rad", f"{w} rad")).simulate(until=1)
    assert found.is_complete
    last = found.events[-4:]
    assert [event.kind for event in last] == ["stops slipping"] * 4
    assert [event.time for event in last] == pytest.approx([time] * 4, abs=2e-5)
    place = np.asarray(found.dataset["body_position"])[-1, 0]
    turned = np.asarray(found.dataset["body_rotation_matrix"])[-1, 0]
    assert [*place[:2], np.arctan2(turned[1, 0], turned[0, 0])] == pytest.approx(pose, abs=1e-6)
