"""Boxes that touch each other in space, beside closed forms, identities and the model in the plane.

Two convex polyhedra are apart by the greatest of the gaps along the normals of their faces and the common normals of
their edges: Gottschalk, Lin & Manocha, Computer Graphics 30 (1996) 171-180. A crate on a slope slides where
tan(alpha) > mu and tips where tan(alpha) > a/h: Meriam & Kraige, Statics, sec. 6/3. A body that meets a fixed edge at
the distance d from its centre gets the impulse (1 + e) m v/(1 + d^2/k^2), k its radius of gyration: Goldsmith, Impact,
1960, ch. 2.
"""

from __future__ import annotations

import itertools
import math
import re

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import freebody as fb
from freebody.numeric.contact.overlaps import gap_of, is_within, parting
from freebody.numeric.engine.course import Collision, Status
from freebody.numeric.reference import Reference

G = 9.81
WEIGHT = "loads: {weight: {gravity: 9.81 m/s^2}}\n"
SLAB = "space: true\nbodies:\n  slab: {box: {mass: 1 kg, size: [1 m, 0.2 m, 0.6 m]}, fixed: true, at: [0, 0, 0]}\n"
SIZES = {"one": np.array((0.6, 0.4, 0.3)), "two": np.array((0.3, 0.5, 0.7))}


def on_slab(crate: str, contact: str = "friction: 0.3") -> str:
    return (
        f"{SLAB}  crate: {{{crate}}}\n"
        f"connections: {{contact: {{contact: {{between: [crate, slab], {contact}}}}}}}\n{WEIGHT}"
    )


def box(a: float, b: float, c: float, at: str = "", more: str = "") -> str:
    place = f", at: {at}" if at else ""
    return f"box: {{mass: 2 kg, size: [{a} m, {b} m, {c} m]}}{place}{more}"


def simulated(model: str, until: float, **options: float) -> fb.Simulation:
    found = fb.System.from_text(model).simulate(until, **options)
    assert found.course.status is Status.FINISHED, found.course.message
    return found


def collisions(found: fb.Simulation) -> tuple[Collision, ...]:
    record = found.course.contact
    assert record is not None
    return tuple(record.collisions)


# -- where they touch -----------------------------------------------------------------------------
def two_boxes(rng: np.random.Generator, apart: float = 0.5) -> tuple[str, list[Rotation], np.ndarray]:
    turns = [Rotation.random(random_state=rng) for _ in range(2)]
    place = apart * rng.normal(size=3)
    bodies: list[str] = []
    for name, turn, at in zip(SIZES, turns, (np.zeros(3), place), strict=True):
        a, b, c = turn.as_euler("XYZ")
        bodies.append(
            f"  {name}: {{box: {{mass: 1, size: {SIZES[name].tolist()}}}, at: {at.tolist()}, "
            f"turned: [{a} rad about x, {b} rad about y, {c} rad about z]}}\n"
        )
    contact = "connections: {it: {contact: {between: [one, two], friction: 0.3, touching: false}}}\n"
    return f"space: true\nbodies:\n{''.join(bodies)}{contact}", turns, place


@pytest.mark.parametrize("seed", range(6))
def test_two_boxes_are_apart_by_the_widest_gap_of_all_separating_axes(seed: int) -> None:
    model, (A, B), place = two_boxes(np.random.default_rng(seed))
    reference = Reference(fb.System.from_text(model), {})
    q = reference.assemble()
    g = reference.geometry(q, np.zeros_like(q), 0.0)
    a, b = A.as_matrix().T, B.as_matrix().T
    axes = [*a, *b, *(np.cross(x, y) for x in a for y in b)]
    expected = -math.inf
    for n in (axis / np.linalg.norm(axis) for axis in axes):
        reach = np.abs(a @ n) @ SIZES["one"] / 2 + np.abs(b @ n) @ SIZES["two"] / 2
        expected = max(expected, abs(n @ place) - reach)
    [(widest, _places)] = parting(reference, g, reference.system.bounds).values()
    assert widest == pytest.approx(expected, abs=1e-12)


def crossing(P: np.ndarray, whole: Rotation, v: np.ndarray, w: np.ndarray, angle: float) -> tuple[str, np.ndarray]:
    """Two boxes on edge, one above the other and turned against it by an angle, that meet in P; and their centres."""
    half = 0.2 / math.sqrt(2)
    bodies: list[str] = []
    centres = np.zeros((2, 3))
    about = Rotation.from_euler("Y", angle)
    for k, (name, size, own, at) in enumerate(
        (
            ("one", "[0.2, 0.2, 0.5]", about * Rotation.from_euler("Z", math.pi / 4), about.apply((0.0, half, 0.1))),
            ("two", "[0.6, 0.2, 0.2]", Rotation.from_euler("X", math.pi / 4), np.array((0.05, -half, 0.0))),
        )
    ):
        centres[k] = P + whole.apply(at)
        a, b, c = (whole * own).as_euler("XYZ")
        bodies.append(
            f"  {name}: {{box: {{mass: 1, size: {size}}}, at: {centres[k].tolist()}, velocity: {v[k].tolist()}, "
            f"turned: [{a} rad about x, {b} rad about y, {c} rad about z], angular_velocity: {w[k].tolist()}}}\n"
        )
    contact = "connections: {it: {contact: {between: [one, two], friction: 0.3, restitution: 0.5}}}\n"
    return f"space: true\nbodies:\n{''.join(bodies)}{contact}", centres


@pytest.mark.parametrize("seed", range(3))
def test_slip_of_crossing_edges_is_the_velocity_of_one_material_point_against_the_other(seed: int) -> None:
    """u = v_1 + w_1 x (P - C_1) - v_2 - w_2 x (P - C_2): along the normal the rate of the gap, across it what the two
    rows of slip have. The blow is along n and against the slip."""
    rng = np.random.default_rng(40 + seed)
    whole, P = Rotation.random(random_state=rng), rng.normal(size=3)
    v, w = rng.normal(size=(2, 3)), rng.normal(size=(2, 3))
    n = whole.apply(np.array((0.0, 1.0, 0.0)))
    v[0] -= (5.0 + v[0] @ n) * n  # it comes from above
    model, centres = crossing(P, whole, v, w, rng.uniform(-0.6, 0.6))
    system = fb.System.from_text(model)
    reference = Reference(system, {})
    q = reference.assemble()
    g = reference.geometry(q, reference.velocities(q), 0.0)
    size = 1e-9
    [bound] = [b for b in system.bounds if abs(gap_of(reference, g, b)) < size and is_within(reference, g, b)]
    [rub] = [rub for rub in system.dry_friction if rub.of == bound.name]
    u = v[0] + np.cross(w[0], P - centres[0]) - v[1] - np.cross(w[1], P - centres[1])
    gap = reference.jet(g, bound.row.measure, "gap")
    assert bound.row.sign * gap.rate == pytest.approx(u @ n, abs=1e-10)
    assert bound.row.sign * gap.row(len(q))[list(reference.columns("one"))[:3]] == pytest.approx(n, abs=1e-10)
    slips = [reference.jet(g, row.measure, "slip").rate for row in rub.rows]
    across = u - (u @ n) * n
    assert math.hypot(*slips) == pytest.approx(np.linalg.norm(across), abs=1e-10)


@pytest.mark.parametrize(("mu", "e"), [(0.0, 1.0), (0.4, 0.6)])
@pytest.mark.parametrize("seed", range(2))
def test_blow_of_two_edges_keeps_the_momenta_and_without_friction_the_energy(seed: int, mu: float, e: float) -> None:
    rng = np.random.default_rng(60 + seed)
    whole, P = Rotation.random(random_state=rng), np.zeros(3)
    v, w = 0.3 * rng.normal(size=(2, 3)), rng.normal(size=(2, 3))
    n = whole.apply(np.array((0.0, 1.0, 0.0)))
    v[0] -= 3.0 * n
    model, _centres = crossing(P, whole, v, w, 0.4)
    model = model.replace("friction: 0.3, restitution: 0.5", f"friction: {mu}, restitution: {e}")
    found = simulated(model, 0.01)
    [hit] = collisions(found)
    assert hit.time == 0.0
    assert hit.energy_change == pytest.approx(0.0, abs=1e-9) if e == 1.0 else hit.energy_change < 0.0
    inertia = {"one": (0.2, 0.2, 0.5), "two": (0.6, 0.2, 0.2)}
    first, last = (momenta(found, at, inertia) for at in (0, -1))
    stated = v.sum(axis=0)
    assert last[0] == pytest.approx(stated, abs=1e-9)
    assert first[0] == pytest.approx(last[0], abs=1e-9)
    assert first[1] == pytest.approx(last[1], abs=1e-8)


def momenta(found: fb.Simulation, at: int, sizes: dict[str, tuple[float, ...]]) -> tuple[np.ndarray, np.ndarray]:
    """Of two boxes of 1 kg: m v, and that about the origin with R I R^T w."""
    rotation = found.course.rotation
    assert rotation is not None
    total, moment = np.zeros(3), np.zeros(3)
    for k, size in enumerate(sizes.values()):
        p = found.course.velocities[at, k, :3]
        a, b, c = (x * x / 12 for x in size)
        w, *vector = rotation.quaternions[at, k]
        R = Rotation.from_quat((*vector, w)).as_matrix()
        total += p
        moment += np.cross(found.course.poses[at, k, :3], p)
        moment += R @ np.diag((b + c, a + c, a + b)) @ R.T @ rotation.velocities[at, k]
    return total, moment


# -- sliding --------------------------------------------------------------------------------------
@pytest.mark.parametrize("heading", [0.0, 0.7])
def test_box_slides_to_rest_on_another_by_mu_g(heading: float) -> None:
    """t = v/(mu g) and s = v^2/(2 mu g), without turning, whichever way it goes."""
    v = np.array((math.cos(heading), 0.0, -math.sin(heading)))
    crate = box(0.3, 0.2, 0.25, "[-0.2 m, 0.2 m, 0.1 m]", f", velocity: {v.tolist()}")
    found = simulated(on_slab(crate), 0.6)
    stops = {event.time for event in found.course.events if event.kind == "stops slipping"}
    assert [*stops] == [pytest.approx(1 / (0.3 * G), rel=1e-9)]
    way = found.course.poses[-1, 0, :3] - np.array((-0.2, 0.2, 0.1))
    assert way == pytest.approx(v / (2 * 0.3 * G), abs=1e-8)
    assert found.course.rotation is not None
    assert np.abs(found.course.rotation.velocities[-1, 0]).max() < 1e-10


@pytest.mark.parametrize("v", [(0.5, 0.0, 0.0), pytest.param((0.5, 0.0, 0.2), marks=pytest.mark.slow)])
def test_box_on_one_of_its_own_size_slides_from_flush_without_a_word(v: tuple[float, ...]) -> None:
    """Corners on corners and edges on edges at the start: what touches from then on is no news, up to v/(mu g)."""
    slab = SLAB.replace("[1 m, 0.2 m, 0.6 m]", "[0.3 m, 0.2 m, 0.25 m]")
    crate = box(0.3, 0.2, 0.25, "[0, 0.2 m, 0]", f", velocity: {list(v)}")
    found = simulated(on_slab(crate).replace(SLAB, slab), 0.2)
    speed = math.hypot(*v)
    assert {event.kind for event in found.course.events} == {"stops slipping"}
    assert [*{event.time for event in found.course.events}] == [pytest.approx(speed / (0.3 * G), rel=1e-9)]
    way = found.course.poses[-1, 0, :3] - np.array((0.0, 0.2, 0.0))
    assert way == pytest.approx(np.array(v) * speed / (2 * 0.3 * G), abs=1e-8)


def test_box_slides_off_the_edge_of_another_as_in_the_plane() -> None:
    """Its corners leave the face, two edges of it go on across the edge of the slab, it tips about that and falls."""
    flat = """
bodies:
  slab: {rectangle: {mass: 1 kg, width: 1 m, height: 0.2 m}, fixed: true, at: [0, 0]}
  crate: {rectangle: {mass: 2 kg, width: 0.3 m, height: 0.2 m}, at: [0.3 m, 0.2 m], velocity: [1.5 m/s, 0]}
connections: {contact: {contact: {between: [crate, slab], friction: 0.3}}}
"""
    plane = simulated(flat + WEIGHT, 0.5)
    crate = box(0.3, 0.2, 0.25, "[0.3 m, 0.2 m, 0]", ", velocity: [1.5 m/s, 0, 0]")
    space = simulated(on_slab(crate), 0.5)
    tips = [event.time for event in plane.course.events if event.kind == "parts"]
    assert sorted({round(e.time, 9) for e in space.course.events if e.kind == "parts"}) == pytest.approx(tips, abs=1e-8)
    x, y, angle = plane.course.poses[-1, 0]
    assert space.course.poses[-1, 0, :3] == pytest.approx((x, y, 0.0), abs=1e-8)
    w, *vector = space.course.rotation.quaternions[-1, 0]  # type: ignore[union-attr]
    assert Rotation.from_quat((*vector, w)).as_rotvec() == pytest.approx((0.0, 0.0, angle), abs=1e-8)


def test_box_tips_when_its_centre_has_passed_the_edge() -> None:
    """Without friction it goes on at v; the centre is over the edge at s/v, and then the rear corners lift."""
    crate = box(0.3, 0.1, 0.25, "[0.35 m, 0.15 m, 0.02 m]", ", velocity: [0.5 m/s, 0, 0]")
    found = simulated(on_slab(crate, "friction: 0"), 0.32)
    lifts = [event.time for event in found.course.events if "corner" in event.name and event.kind == "parts"]
    assert lifts == [pytest.approx(0.3, rel=1e-9)] * len(lifts)
    assert len(lifts) == 2


def test_two_boxes_on_an_incline_slide_and_hold_each_by_its_own_coefficient() -> None:
    """The upper slides at g (sin - mu_2 cos); the lower holds as long as 3 sin < ... : friction 2 g sin + mu_2 g cos of
    the normal force 3 g cos at most mu_1 of it."""
    b, mu1, mu2 = math.radians(17), 0.35, 0.25
    assert 2 * math.sin(b) + mu2 * math.cos(b) < 3 * mu1 * math.cos(b)
    turned, at = f"turned: {-b} rad about z", np.array((math.sin(b), math.cos(b), 0.0))
    model = (
        f"space: true\nbodies:\n  ramp: {{box: {{mass: 1, size: [2, 0.2, 0.6]}}, fixed: true, {turned}}}\n"
        f"  lower: {{box: {{mass: 2, size: [0.6, 0.2, 0.4]}}, at: {(0.2 * at).tolist()}, {turned}}}\n"
        f"  upper: {{box: {{mass: 1, size: [0.2, 0.1, 0.3]}}, at: {(0.35 * at).tolist()}, {turned}}}\n"
        f"connections:\n  one: {{contact: {{between: [lower, ramp], friction: {mu1}}}}}\n"
        f"  two: {{contact: {{between: [upper, lower], friction: {mu2}}}}}\n{WEIGHT}"
    )
    found = simulated(model, 0.4)
    down = np.array((math.cos(b), -math.sin(b), 0.0))
    way = found.course.poses[-1, :2, :3] - found.course.poses[0, :2, :3]
    assert way[0] == pytest.approx(0.0, abs=1e-9)
    assert way[1] == pytest.approx(0.5 * G * (math.sin(b) - mu2 * math.cos(b)) * 0.4**2 * down, abs=1e-9)


# -- resting --------------------------------------------------------------------------------------
@pytest.mark.parametrize("angle", [0.0, 20.0])
def test_plank_lies_across_another_on_crossings_of_edges(angle: float) -> None:
    """No corner of either is on a face of the other. What carries it is m g, at the four crossings or some of them."""
    crate = box(0.3, 0.2, 2.0, "[0.1 m, 0.2 m, 0.1 m]", f", turned: {angle} deg about y")
    found = simulated(on_slab(crate), 0.1)
    assert found.course.poses[-1, 0, :3] == pytest.approx((0.1, 0.2, 0.1), abs=1e-12)
    forces = {name: force for name, force in forces_at_the_end(found).items() if abs(force) > 1e-9}
    assert len(forces) >= 3
    crossings = itertools.product(("left-bottom", "right-bottom"), ("top-back", "top-front"))
    assert forces.keys() <= {f"contact.crate {one} on slab {other}" for one, other in crossings}
    assert sum(forces.values()) == pytest.approx(2 * G, rel=1e-9)


def forces_at_the_end(found: fb.Simulation) -> dict[str, float]:
    system = found.system
    rows = {row.name: k for k, row in enumerate(system.rows)}
    signs = {bound.name: bound.row.sign for bound in system.bounds}
    last = found.course.multipliers[-1]
    return {name: sign * last[rows[name]] for name, sign in signs.items() if np.isfinite(last[rows[name]])}


RAMP = """
space: true
parameters: {m: 2 kg, g: 9.81 m/s^2, a: 0.2 m, h: 0.5 m, H: 0.2 m, alpha: 10 deg, mu: 0.9}
bodies:
  ramp: {box: {mass: 1 kg, size: [2 m, H, 0.6 m]}, fixed: true, at: [0, 0, 0], turned: alpha about z}
  crate:
    box: {mass: m, size: [a, h, 0.25 m]}
    at: [-(h + H)/2*sin(alpha), (h + H)/2*cos(alpha), 0]
    turned: alpha about z
connections: {contact: {contact: {between: [crate, ramp], friction: mu}}}
loads: {weight: {gravity: g}}
"""


@pytest.mark.slow
@pytest.mark.parametrize(("mu", "limit"), [(0.9, math.atan(0.4)), (0.3, math.atan(0.3))])
def test_box_on_an_inclined_box_tips_at_the_ratio_of_its_sides_or_slides_at_mu(mu: float, limit: float) -> None:
    [answer] = (
        fb.System.from_text(RAMP.replace("mu: 0.9", f"mu: {mu}")).solve("does it tip or slide as alpha grows").answers
    )
    assert answer.value == pytest.approx(limit, rel=1e-10)
    assert answer.expression is not None


def test_box_on_an_inclined_box_holds_with_mu_at_least_the_slope() -> None:
    [answer] = fb.System.from_text(RAMP).solve("least mu so that it stays at rest").answers
    assert answer.value == pytest.approx(math.tan(math.radians(10)), rel=1e-12)
    assert answer.expression is not None


def test_box_on_a_box_slips_at_the_ratio_of_push_and_weight_unless_it_tips() -> None:
    """mu = P/(m g), as long as P b/2 <= m g a/2."""
    crate = box(0.3, 0.2, 0.25, "[-0.2 m, 0.2 m, 0]").replace("2 kg", "m").replace("0.2 m, 0.25", "b, 0.25")
    model = on_slab(crate.replace("0.3 m, b", "a, b"), "friction: mu").replace(WEIGHT, "")
    model = model.replace(
        "space: true", "space: true\nparameters: {m: 2 kg, g: 9.81 m/s^2, P: 3 N, mu: 0.3, a: 0.3 m, b: 0.2 m}"
    )
    model += "loads: {weight: {gravity: g}, push: {force: {at: crate, along: [1, 0, 0], magnitude: P}}}\n"
    [answer] = (
        fb.System.from_text(model.replace("-0.2 m, 0.2 m, 0", "-0.2 m, 0.1 m + b/2, 0"))
        .solve("least mu so that it stays at rest")
        .answers
    )
    assert answer.value == pytest.approx(3 / (2 * 9.81), rel=1e-12)
    assert re.search(r"valid.*(P·b|b·P)", str(answer))


# -- blows ----------------------------------------------------------------------------------------
@pytest.mark.parametrize("e", [0.0, 0.5])
def test_box_that_falls_flat_onto_an_edge_gets_the_impulse_of_its_distance(e: float) -> None:
    """Onto the upright edge of a slab, d = 0.1 m from its middle: J = (1 + e) m v/(1 + d^2/k^2), k^2 = (a^2 + b^2)/12.
    Its corners are over the slab as well, but the blow at the edge lifts them."""
    d, a, b = 0.2, 0.6, 0.2
    found = simulated(on_slab(box(a, b, 0.4, f"[{0.5 + d}, 0.4, 0]"), f"friction: 0, restitution: {e}"), 0.21)
    v = math.sqrt(2 * G * 0.2)
    [hit] = collisions(found)
    J = (1 + e) * 2 * v / (1 + d**2 / ((a**2 + b**2) / 12))
    assert sum(hit.impulses.values()) == pytest.approx(J, rel=1e-9)
    assert hit.time == pytest.approx(v / G, rel=1e-9)


def test_box_is_put_onto_the_face_onto_which_its_weight_drives_it() -> None:
    found = simulated(on_slab(box(0.3, 0.2, 0.25), "friction: 0.3, touching: true"), 0.01)
    assert found.course.poses[-1, 0, :3] == pytest.approx((0.0, 0.2, 0.0), abs=1e-12)


@pytest.mark.parametrize(
    ("crate", "what"),
    [
        (box(0.3, 0.2, 0.25), "crate is 0.2 m inside slab"),
        (box(0.3, 0.2, 0.25, "[0, 0.15 m, 0]"), "crate.corner1 is 0.05 m inside slab.top"),
        (box(0.1, 0.1, 3.0, "[0, 0.14 m, 0]"), "crate is 0.01 m inside slab"),
    ],
)
def test_boxes_that_overlap_are_refused_with_how_deep(crate: str, what: str) -> None:
    with pytest.raises(fb.CannotAnswer) as told:
        fb.System.from_text(on_slab(crate)).simulate(0.1)
    assert what in str(told.value)


BALL = """
space: true
bodies:
  other: {OTHER, at: [0, 0, 0], fixed: true}
  ball: {sphere: {mass: 1 kg, radius: 0.1 m}, at: AT}
connections: {it: {contact: {between: [ball, other]}}}
"""


@pytest.mark.parametrize(
    ("other", "at", "what"),
    [
        ("ring: {mass: 2 kg, radius: 0.5 m, axis: y}", "[0, 0.6 m, 0]", "ball is on the axis of other or on its rim"),
        ("sphere: {mass: 2 kg, radius: 0.5 m}", "[0, 0, 0]", "the middle of ball is the middle of other"),
        ("box: {mass: 2 kg, size: [1 m, 1 m, 1 m]}", "[0, 0, 0]", "the middle of ball is inside other"),
        ("rod: {mass: 2 kg, length: 0.5 m}", "[0, 0, 0]", "the middle of ball is inside other"),
    ],
)
def test_ball_without_a_nearest_place_is_told_as_such(other: str, at: str, what: str) -> None:
    with pytest.raises(fb.CannotAnswer, match=what):
        fb.System.from_text(BALL.replace("OTHER", other).replace("AT", at)).simulate(0.1)


def test_particle_slides_off_a_box_and_falls() -> None:
    """v^2 = v0^2 - 2 mu g s at the edge, and then a parabola."""
    crate = "particle: {mass: 1 kg}, at: [0.3 m, 0.1 m, 0.1 m], velocity: [1.5 m/s, 0, 0]"
    found = simulated(on_slab(crate), 0.5)
    v = math.sqrt(1.5**2 - 2 * 0.3 * G * 0.2)
    t = (1.5 - v) / (0.3 * G)
    [parts] = [event.time for event in found.course.events if event.kind == "parts"]
    assert parts == pytest.approx(t, rel=1e-8)
    x, y, z = found.course.poses[-1, 0, :3]
    assert (x, y, z) == pytest.approx((0.5 + v * (0.5 - t), 0.1 - 0.5 * G * (0.5 - t) ** 2, 0.1), abs=1e-8)


def test_names_of_places_are_those_of_corners_faces_and_edges() -> None:
    names = [bound.name for bound in fb.System.from_text(on_slab(box(0.3, 0.2, 0.25, "[0, 1, 0]"))).bounds]
    assert len(names) == len(set(names)) == 2 * 8 * 6 + 2 * 12 * 12
    faces = ("left", "right", "bottom", "top", "back", "front")
    for corner, face in itertools.product(range(1, 9), faces):
        assert f"contact.crate.corner{corner} on slab.{face}" in names
