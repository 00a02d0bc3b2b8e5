"""Cylinders and disks that touch boxes and other convex bodies in space, beside the model in the plane and identities.

A cylinder that rolls over the edge of a table at v without slip has v'^2 = v^2 + 4/3 g R (1 - cos) and leaves it where
m v'^2/R = m g cos, at cos = (4 + 3 v^2/(g R))/7. Source: Meriam & Kraige, Dynamics, sec. 6/6.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import freebody as fb
from freebody.numeric.contact.overlaps import gap_of, is_within
from freebody.numeric.engine.course import Status
from freebody.numeric.reference import Reference

G = 9.81
WEIGHT = "loads: {weight: {gravity: 9.81 m/s^2}}\n"
R, L = 0.1, 0.4


def frame(z: np.ndarray, x: np.ndarray) -> Rotation:
    """Axes with the third along z and the first towards x."""
    z = z / np.linalg.norm(z)
    x = x - (x @ z) * z
    x = x / np.linalg.norm(x)
    return Rotation.from_matrix(np.column_stack((x, np.cross(z, x), z)))


def placed(where: str) -> tuple[str, Rotation, np.ndarray, Rotation, np.ndarray, np.ndarray, str]:
    """What touches in the origin: a shape with its axes and centre, a box with its own, the normal, and the place."""
    can, disk = "cylinder: {mass: 1, radius: 0.1, length: 0.4, axis: z}", "disk: {mass: 1, radius: 0.1, axis: z}"
    size = np.array((0.6, 0.2, 0.3))
    up, x, z = np.eye(3)[1], np.eye(3)[0], np.eye(3)[2]
    if where.startswith("rim on face"):
        a = np.array((0.3, 0.5, 1.0)) / math.sqrt(0.09 + 0.25 + 1.0)
        out = R * (up - (a @ up) * a) / math.sqrt(1 - (a @ up) ** 2)
        shape, center = (disk, out) if "disk" in where else (can, out + 0.5 * L * a)
        place = "can on box.top" if "disk" in where else "can.start on box.top"
        return shape, frame(a, x), center, Rotation.identity(), np.array((0.1, -0.1, 0.05)), up, place
    corner_up = frame(np.array((0.2, 1.0, 0.3)), x).as_matrix() @ frame(np.array((1.0, 1.0, 1.0)), x).as_matrix().T
    if where.startswith("corner"):
        box, at = Rotation.from_matrix(corner_up), -(corner_up @ (0.5 * size))
        if where == "corner on end":
            return can, frame(up, x), 0.5 * L * up + np.array((0.03, 0, 0.05)), box, at, up, "box.corner8 on can.start"
        return can, frame(x, up), R * up + 0.05 * x, box, at, up, "box.corner8 on can"
    # the edge top-right of the box, which is turned so that it points up, along z
    box = Rotation.from_euler("Z", math.pi / 4)
    at = -box.apply(np.array((0.3, 0.1, 0.05)))
    if where == "side on edge":
        a = np.array((1.0, 0.1, 0.6))
        n = np.cross(a, z) * np.sign(np.cross(a, z) @ up) / np.linalg.norm(np.cross(a, z))
        return can, frame(a, up), R * n + 0.07 * a / np.linalg.norm(a), box, at, n, "can on box"
    u = np.array((0.1, -1.0, 0.15))
    u = u / np.linalg.norm(u)
    a = np.array((0.2, 0.0, 1.0))
    a = a - (a @ u) * u
    a = a / np.linalg.norm(a)
    k = u[2] / a[2]
    n = -(u - k * a) / math.sqrt(1 + k * k)
    shape, center = (disk, -R * u) if "disk" in where else (can, -R * u + 0.5 * L * a)
    return shape, frame(a, x), center, box, at, n, "can on box" if "disk" in where else "can.start on box"


PLACES = ["rim on face", "rim on face, disk", "side on edge", "rim on edge", "rim on edge, disk", "corner on side"]


@pytest.mark.parametrize("where", [*PLACES, "corner on end"])
@pytest.mark.parametrize("seed", range(2))
def test_slip_is_the_velocity_of_one_material_point_against_the_other(where: str, seed: int) -> None:
    """u = v_1 + w_1 x (P - C_1) - v_2 - w_2 x (P - C_2): along the normal the rate of the gap, across it what the two
    rows of slip have; and only the place that is meant touches there."""
    rng = np.random.default_rng(70 + seed)
    shape, own, center, box, at, n, place = placed(where)
    whole, P = Rotation.random(random_state=rng), rng.normal(size=3)
    v, w = rng.normal(size=(2, 3)), rng.normal(size=(2, 3))
    centers = [P + whole.apply(center), P + whole.apply(at)]
    bodies: list[str] = []
    solid = "box: {mass: 2, size: [0.6, 0.2, 0.3]}"
    for k, (name, form, turn) in enumerate((("can", shape, own), ("box", solid, box))):
        a, b, c = (whole * turn).as_euler("XYZ")
        bodies.append(
            f"  {name}: {{{form}, at: {centers[k].tolist()}, velocity: {v[k].tolist()}, angular_velocity: "
            f"{w[k].tolist()}, turned: [{a} rad about x, {b} rad about y, {c} rad about z]}}\n"
        )
    contact = "connections: {it: {contact: {between: [can, box], friction: 0.3}}}\n"
    system = fb.System.from_text(f"space: true\nbodies:\n{''.join(bodies)}{contact}")
    reference = Reference(system, {})
    q = reference.assemble()
    g = reference.geometry(q, reference.velocities(q), 0.0)
    [bound] = [b for b in system.bounds if abs(gap_of(reference, g, b)) < 1e-9 and is_within(reference, g, b)]
    assert place in bound.name
    [rub] = [rub for rub in system.dry_friction if rub.of == bound.name]
    n = whole.apply(n)
    u = v[0] + np.cross(w[0], P - centers[0]) - v[1] - np.cross(w[1], P - centers[1])
    gap = reference.jet(g, bound.row.measure, "gap")
    pushed = gap.row(len(q))[list(reference.columns("can"))[:3]]
    assert bound.row.sign * gap.rate == pytest.approx(u @ n, abs=1e-9)
    assert bound.row.sign * pushed == pytest.approx(n, abs=1e-9)
    slips = [reference.jet(g, row.measure, "slip").rate for row in rub.rows]
    assert math.hypot(*slips) == pytest.approx(np.linalg.norm(u - (u @ n) * n), abs=1e-9)


# -- off a table ----------------------------------------------------------------------------------
def off_a_table(length: float, friction: float, v: float) -> fb.Simulation:
    model = (
        "space: true\nbodies:\n  table: {box: {mass: 1, size: [1, 0.4, 0.8]}, fixed: true, at: [-0.5, -0.2, 0]}\n"
        f"  can: {{cylinder: {{mass: 2, radius: 0.1, length: {length}, axis: z}}, at: [-0.02, 0.1, 0.05], "
        f"velocity: [{v}, 0, 0], angular_velocity: [0, 0, {-v / 0.1}]}}\n"
        f"connections: {{c: {{contact: {{between: [can, table], friction: {friction}}}}}}}\n{WEIGHT}"
    )
    found = fb.System.from_text(model).simulate(0.3)
    assert found.course.status is Status.FINISHED, found.course.message
    return found


@pytest.mark.parametrize("length", [0.3, pytest.param(1.2, marks=pytest.mark.slow)])
def test_can_rolls_over_the_edge_of_a_table_and_leaves_it_at_a_known_angle(length: float) -> None:
    """With its rims on the edge, or, where it is longer than the table, with its side on the corners of that."""
    v = 0.3
    found = off_a_table(length, 1e3, v)
    parts = [event.time for event in found.course.events if event.kind == "parts"]
    assert parts == [pytest.approx(parts[0], abs=1e-9)] * 2
    at = np.searchsorted(found.course.times, parts[0])
    assert found.course.poses[at, 0, 1] / R == pytest.approx((4 + 3 * v * v / (G * R)) / 7, abs=2e-5)
    assert found.course.poses[-1, 0, 2] == pytest.approx(0.05, abs=1e-9)
