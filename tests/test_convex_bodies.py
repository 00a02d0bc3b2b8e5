"""Convex bodies in space: hulls beside SciPy's, moments of inertia beside closed forms, contact beside boxes and
separating axes, and the laws of momentum and energy.

A tetrahedron with edges a, b, c at right angles has its mass centre at a/4, b/4, c/4 and I_x = 3 m (b^2 + c^2)/80 about
it, I_xy = m a b/80; a regular one m a^2/20; a pyramid of height h on a square I_z = m a^2/10, with its mass centre at
h/4. Source: Tonon, J. Math. Stat. 1 (2005) 8-11; Beer, Johnston & Cornwell, Dynamics, inside back cover. A regular
tetrahedron on a slope tips about its lower edge at tan(alpha) = sqrt(2): its mass centre is a/sqrt(12) from the edge
and a/sqrt(24) above the face.
"""

from __future__ import annotations

import itertools
import math
import re

import numpy as np
import pytest
from scipy.spatial import ConvexHull
from scipy.spatial.transform import Rotation

import freebody as fb
from freebody.language.expression import evaluate
from freebody.language.notation import to_text
from freebody.model.hulls import faces_of_hull
from freebody.numeric.contact.overlaps import gap_of, is_within, parting
from freebody.numeric.engine.course import Status
from freebody.numeric.reference import Reference

G = 9.81
WEIGHT = "loads: {weight: {gravity: 9.81 m/s^2}}\n"
REGULAR = "{A: [a, a, a], B: [a, -a, -a], C: [-a, a, -a], D: [-a, -a, a]}"


def body(shape: str) -> tuple[np.ndarray, np.ndarray, tuple[str, ...]]:
    """The mass centre from the reference point, the tensor about it in numbers, and in formulas."""
    system = fb.System.from_text(
        f"space: true\nparameters: {{m: 2 kg, a: 0.3 m, h: 0.5 m}}\nbodies: {{b: {{{shape}}}}}\n"
    )
    values = {name: parameter.value for name, parameter in system.parameters.items()}
    it = system.bodies["b"]

    def numbers(exprs: tuple[object, ...]) -> np.ndarray:
        return np.array([evaluate(expr, values) for expr in exprs])  # type: ignore[arg-type]

    return -numbers(it.center.offset), numbers(it.tensor), tuple(map(to_text, it.tensor))


def simulated(model: str, until: float) -> fb.Simulation:
    found = fb.System.from_text(model).simulate(until)
    assert found.course.status is Status.FINISHED, found.course.message
    return found


# -- hulls and moments of inertia -----------------------------------------------------------------
@pytest.mark.parametrize("seed", range(4))
def test_hull_of_points_is_that_of_scipy(seed: int) -> None:
    points = np.random.default_rng(seed).normal(size=(14, 3))
    faces = faces_of_hull([tuple(p) for p in points.tolist()])
    hull = ConvexHull(points)
    assert {frozenset(face) for face in faces} == {frozenset(map(int, s)) for s in hull.simplices}
    middle = points.mean(axis=0)
    for face in faces:
        a, b, c = points[list(face[:3])]
        assert np.cross(b - a, c - a) @ (a - middle) > 0.0
    assert faces == sorted(faces)


def test_points_on_faces_and_edges_and_inside_are_no_corners() -> None:
    cube = list(itertools.product((-1.0, 1.0), repeat=3))
    more = [(0.0, 0.0, 1.0), (1.0, 1.0, 0.0), (0.2, 0.1, 0.3), (1.0, 1.0, 1.0)]
    faces = faces_of_hull([*cube, *more])
    assert sorted(map(len, faces)) == [4] * 6
    assert {corner for face in faces for corner in face} == set(range(8))


def test_flat_points_have_no_hull() -> None:
    assert faces_of_hull([(0.0, 0.0, 1.0), (1.0, 0.0, 1.0), (0.0, 1.0, 1.0), (0.3, 0.3, 1.0)]) == []


def test_tetrahedron_has_the_moments_of_the_closed_forms() -> None:
    middle, tensor, _ = body("convex: {mass: 2 kg, points: [[0, 0, 0], [0.3 m, 0, 0], [0, 0.4 m, 0], [0, 0, 0.5 m]]}")
    a, b, c = 0.3, 0.4, 0.5
    assert middle == pytest.approx((a / 4, b / 4, c / 4))
    moments = [3 * 2 * (p * p + q * q) / 80 for p, q in ((b, c), (a, c), (a, b))]
    assert tensor == pytest.approx((*moments, 2 * a * b / 80, 2 * a * c / 80, 2 * b * c / 80), rel=1e-14)
    _, _, told = body(f"convex: {{mass: m, points: {REGULAR}}}")
    assert set(told[:3]) == {"2·a²·m/5"}  # of edges a sqrt(8)
    assert told[3:] == ("0", "0", "0")


def test_pyramid_and_box_have_their_textbook_formulas() -> None:
    middle, tensor, _ = body(
        "convex: {mass: m, points: [[a/2, 0, a/2], [a/2, 0, -a/2], [-a/2, 0, a/2], [-a/2, 0, -a/2], [0, h, 0]]}"
    )
    assert middle == pytest.approx((0, 0.5 / 4, 0))
    assert tensor[1] == pytest.approx(2 * 0.3**2 / 10)
    assert tensor[0] == pytest.approx(2 * (0.3**2 / 20 + 3 * 0.5**2 / 80))
    corners = [[f"{s}a/2" for s in signs] for signs in itertools.product(("-", ""), repeat=3)]
    _, _, told = body(f"convex: {{mass: m, points: {corners}}}".replace("'", ""))
    assert told == ("a²·m/6", "a²·m/6", "a²·m/6", "0", "0", "0")


def test_two_wedges_are_a_box() -> None:
    low = "[[0, 0, 0], [0.3, 0, 0], [0, 0.4, 0], [0, 0, 0.5], [0.3, 0, 0.5], [0, 0.4, 0.5]]"
    top = "[[0.3, 0.4, 0], [0.3, 0, 0], [0, 0.4, 0], [0.3, 0.4, 0.5], [0.3, 0, 0.5], [0, 0.4, 0.5]]"
    parts = ", ".join(f"{name}: {{convex: {{mass: 1, points: {p}}}}}" for name, p in (("low", low), ("top", top)))
    middle, tensor, _ = body(f"composite: {{parts: {{{parts}}}}}")
    whole = body("box: {mass: 2, size: [0.3, 0.4, 0.5]}")
    assert middle == pytest.approx((0.15, 0.2, 0.25))
    assert tensor == pytest.approx(whole[1], abs=1e-15)


@pytest.mark.parametrize(
    ("shape", "what"),
    [
        ("{mass: 1, points: [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]}", "four points that are not in one plane"),
        ("{mass: 1, points: [[0, 0, 0], [a, 0, 0], [0, a, 0], [0, 0, L]]}", "give L a value, for corner4"),
        ("{mass: 1, points: {origin: [0, 0, 0], A: [1, 0, 0], B: [0, 1, 0], C: [0, 0, 1]}}", "origin is there already"),
        (
            "{mass: 1, points: {A: [0, 0, 0], B: [1, 0, 0], C: [0, 1, 0], D: [0, 0, 1]}, faces: {s: [A, B, E]}}",
            "no corner E",
        ),
        (
            "{mass: 1, points: {A: [0, 0, 0], B: [1, 0, 0], C: [0, 1, 0], D: [0, 0, 1]}, faces: {s: [A, B]}}",
            "no face has",
        ),
        (
            "{mass: 1, points: [[0, 0, 0], [a, 0, 0], [a, b, 0], [0, b, a - b], [0, 0, 1], [a, 0, 1], [a, b, 1], "
            "[0, b, 1]]}",
            "in one plane for the given values alone",
        ),
    ],
)
def test_what_is_no_convex_body_is_refused(shape: str, what: str) -> None:
    model = f"space: true\nparameters: {{a: 0.3 m, b: 0.3 m, L: m}}\nbodies: {{b: {{convex: {shape}}}}}\n"
    with pytest.raises(fb.ModelError, match=what):
        fb.System.from_text(model)


# -- beside boxes ---------------------------------------------------------------------------------
def convex_for_box(model: str) -> str:
    """The boxes of a model, whose sizes are numbers, written by their corners."""

    def written(found: re.Match[str]) -> str:
        halves = [float(size.split()[0]) / 2 for size in found[2].split(",")]
        points = [[s * h for s, h in zip(signs, halves, strict=True)] for signs in itertools.product((-1, 1), repeat=3)]
        return f"convex: {{mass: {found[1]}, points: {points}}}"

    return re.sub(r"box: \{mass: ([^,]*), size: \[([^\]]*)\]\}", written, model)


SLAB = "space: true\nbodies:\n  slab: {box: {mass: 1 kg, size: [1 m, 0.2 m, 0.6 m]}, fixed: true, at: [0, 0, 0]}\n"
CRATE = (
    "  crate: {box: {mass: 2 kg, size: [0.3 m, 0.2 m, 0.25 m]}, at: [0.37 m, 0.2 m, 0], velocity: [1.5 m/s, 0, 0]}\n"
)
CONTACT = "connections: {contact: {contact: {between: [crate, slab], friction: 0.3}}}\n"


def test_box_that_is_written_by_its_corners_moves_as_a_box() -> None:
    """It slides, its corners leave the face, its edges cross that of the slab, and it tips."""
    model = SLAB + CRATE + CONTACT + WEIGHT
    one, other = simulated(model, 0.15), simulated(convex_for_box(model), 0.15)
    assert [event.time for event in other.course.events] == [event.time for event in one.course.events]
    assert other.course.poses[-1] == pytest.approx(one.course.poses[-1], abs=1e-12)


BALL = (
    "space: true\nbodies:\n  block: {box: {mass: 1, size: [0.6, 1, 0.8]}, fixed: true, at: [-0.3, -0.5, 0]}\n"
    "  ball: {sphere: {mass: 1, radius: 0.05}, at: [-0.03, 0.05, 0.02], velocity: [0.2, 0, 0.05], "
    "angular_velocity: [1, 0, -4]}\nconnections: {c: {contact: {between: [ball, block], friction: 1.5}}}\n"
)


def test_ball_rolls_over_an_edge_of_a_convex_body_as_over_that_of_a_box() -> None:
    """From its face to its edge, where it slips and leaves."""
    one, other = simulated(BALL + WEIGHT, 0.35), simulated(convex_for_box(BALL) + WEIGHT, 0.35)
    assert [event.kind for event in other.course.events] == ["starts to slip", "parts"]
    assert [e.time for e in other.course.events] == pytest.approx([e.time for e in one.course.events], rel=1e-9)
    assert other.course.poses[-1] == pytest.approx(one.course.poses[-1], abs=1e-10)
    assert [event.name for event in other.course.events][-1] == "ball leaves block face5-face6"


@pytest.mark.parametrize("seed", range(6))
def test_ball_is_as_far_from_a_convex_body_as_from_the_box(seed: int) -> None:
    """At faces, edges and corners: of its places one exists, with the same gap."""
    at = np.random.default_rng(seed).uniform((-0.9, -1.2, -0.9), (0.4, 0.3, 0.9))
    gaps: list[list[float]] = []
    for model in (BALL, convex_for_box(BALL)):
        text = model.replace("[-0.03, 0.05, 0.02]", str(at.tolist())).replace(
            "-0.3, -0.5, 0]", "-0.3, -0.5, 0], turned: 20 deg about x"
        )
        reference = Reference(fb.System.from_text(text), {})
        q = reference.assemble()
        g = reference.geometry(q, np.zeros_like(q), 0.0)
        gaps.append([gap_of(reference, g, b) for b in reference.system.bounds if is_within(reference, g, b)])
    [expected] = gaps[0]
    assert max(gaps[1]) == pytest.approx(expected, abs=1e-12)
    assert expected < 0.0 or len(gaps[1]) <= 2  # the face behind it is none that it touches


# -- where they touch -----------------------------------------------------------------------------
@pytest.mark.parametrize("seed", range(4))
def test_two_convex_bodies_overlap_by_the_widest_gap_of_all_separating_axes(seed: int) -> None:
    rng = np.random.default_rng(seed)
    clouds, bodies = [0.3 * rng.normal(size=(n, 3)) for n in (4, 7)], list[str]()
    for name, points, at in zip("pq", clouds, (np.zeros(3), 0.1 * rng.normal(size=3)), strict=True):
        turn = Rotation.random(random_state=rng)
        a, b, c = turn.as_euler("XYZ")
        own = points.tolist()
        points[:] = turn.apply(points) + at
        bodies.append(
            f"  {name}: {{convex: {{mass: 1, points: {own}}}, at: {{origin: {at.tolist()}}}, "
            f"turned: [{a} rad about x, {b} rad about y, {c} rad about z]}}\n"
        )
    contact = "connections: {it: {contact: {between: [p, q], friction: 0.3, touching: false}}}\n"
    reference = Reference(fb.System.from_text(f"space: true\nbodies:\n{''.join(bodies)}{contact}"), {})
    q = reference.assemble()
    g = reference.geometry(q, np.zeros_like(q), 0.0)
    hulls = [ConvexHull(points) for points in clouds]
    sides = [
        {tuple((points[j] - points[i]).tolist()) for s in h.simplices for i, j in itertools.combinations(s, 2)}
        for points, h in zip(clouds, hulls, strict=True)
    ]
    axes = [*hulls[0].equations[:, :3], *(-hulls[1].equations[:, :3])]
    axes += [s * np.cross(x, y) for x in sides[0] for y in sides[1] for s in (1, -1)]
    units = [axis / np.linalg.norm(axis) for axis in axes if np.linalg.norm(axis) > 1e-9]
    expected = max(float((clouds[1] @ n).min() - (clouds[0] @ n).max()) for n in units)
    [(widest, _places)] = parting(reference, g, reference.system.bounds).values()
    assert widest == pytest.approx(expected, abs=1e-9)


# -- motion ---------------------------------------------------------------------------------------
TETRAHEDRA = (
    "space: true\nbodies:\n"
    "  low: {convex: {mass: 2, points: [[0, 0, 0], [0.3, 0, 0.05], [0, 0.1, 0.4], [-0.3, 0, 0]]}, at: [0, 0, 0], "
    "angular_velocity: [0.4, 0.2, -0.3]}\n"
    "  top: {convex: {mass: 1, points: [[0, 0, 0], [0.2, 0.3, 0], [-0.2, 0.3, 0.1], [0, 0.3, -0.2]]}, "
    "at: [0.02, 0.4, 0.02], velocity: [0.1, -2, 0], angular_velocity: [1, 0.5, 2]}\n"
    "connections: {it: {contact: {between: [low, top], friction: MU, restitution: E}}}\n"
)


@pytest.mark.parametrize(("mu", "e"), [(0.0, 1.0), (0.4, 0.5)])
def test_tetrahedra_that_collide_keep_the_momenta_and_without_friction_the_energy(mu: float, e: float) -> None:
    found = simulated(TETRAHEDRA.replace("MU", str(mu)).replace("E}", f"{e}}}"), 0.3)
    assert found.course.contact is not None
    hits = found.course.contact.collisions
    assert hits
    energy = [hit.energy_change for hit in hits]
    assert (energy == pytest.approx([0.0] * len(hits), abs=1e-9)) if e == 1.0 else max(energy) < 0.0
    first, last = (momenta(found, at) for at in (0, -1))
    assert last[0] == pytest.approx(first[0], abs=1e-9)
    assert last[1] == pytest.approx(first[1], abs=1e-8)


def momenta(found: fb.Simulation, at: int) -> tuple[np.ndarray, np.ndarray]:
    """Sum of m v, and about the origin of r x m v + R I R^T w."""
    course, rotation = found.course, found.course.rotation
    assert rotation is not None
    total, moment = np.zeros(3), np.zeros(3)
    for k, it in enumerate(found.system.moving):
        mass, *tensor = (float(evaluate(expr, {})) for expr in (it.mass, *it.tensor))
        xx, yy, zz, xy, xz, yz = tensor
        p = mass * course.velocities[at, k, :3]
        w, *vector = rotation.quaternions[at, k]
        R = Rotation.from_quat((*vector, w)).as_matrix()
        total += p
        moment += np.cross(course.poses[at, k, :3], p)
        moment += R @ np.array([(xx, xy, xz), (xy, yy, yz), (xz, yz, zz)]) @ R.T @ rotation.velocities[at, k]
    return total, moment


@pytest.mark.parametrize("ground", ["plane", "box"])
def test_pyramid_that_falls_onto_its_tip_or_base_stays_upright(ground: str) -> None:
    points = "{a: [0.1, 0, 0.1], b: [0.1, 0, -0.1], c: [-0.1, 0, 0.1], d: [-0.1, 0, -0.1], tip: [0, -0.3, 0]}"
    floor = "ground: {planes: {floor: {normal: up}}}\n" if ground == "plane" else ""
    other = "ground.floor" if floor else "slab"
    slab = "" if floor else "  slab: {box: {mass: 1, size: [1, 0.2, 1]}, fixed: true, at: [0, -0.1, 0]}\n"
    model = (
        f"space: true\n{floor}bodies:\n"
        f"{slab}  p: {{convex: {{mass: 1, points: {points}}}, at: {{tip: [0.01, 0.1, 0.02]}}}}\n"
        f"connections: {{it: {{contact: {{between: [p, {other}], friction: 0.3, restitution: 0.5}}}}}}\n{WEIGHT}"
    )
    found = simulated(model, 0.25)
    v, t = math.sqrt(2 * G * 0.1), 0.25 - math.sqrt(0.2 / G)
    assert found.course.rotation is not None
    assert np.abs(found.course.rotation.velocities[-1]).max() < 1e-12
    height = 0.3 * 3 / 4 + 0.5 * v * t - 0.5 * G * t * t
    assert found.course.poses[-1, 0, :3] == pytest.approx((0.01, height, 0.02), abs=1e-9)


# -- rest -----------------------------------------------------------------------------------------
SLOPE = """
space: true
parameters: {m: 2 kg, a: 0.3 m, alpha: 15 deg, mu: 2, g: 9.81 m/s^2}
ground: {planes: {slope: {normal: [-sin(alpha), cos(alpha), 0]}}}
bodies:
  stone:
    convex:
      mass: m
      points: {A: [-a*sqrt(3)/6, 0, -a/2], B: [-a*sqrt(3)/6, 0, a/2], C: [a/sqrt(3), 0, 0], D: [0, a*sqrt(2/3), 0]}
    at: {origin: [0, 0, 0]}
    turned: alpha about z
connections: {contact: {contact: {between: [stone, ground.slope], friction: mu}}}
loads: {weight: {gravity: g}}
"""


def test_regular_tetrahedron_on_a_rough_slope_tips_at_tan_alpha_sqrt_2() -> None:
    [answer] = fb.System.from_text(SLOPE).solve("does it tip or slide as alpha grows").answers
    assert answer.value == pytest.approx(math.atan(math.sqrt(2)), rel=1e-10)
    assert answer.expression is not None


def test_regular_tetrahedron_on_a_slope_holds_with_mu_at_least_tan_alpha() -> None:
    [answer] = fb.System.from_text(SLOPE).solve("least mu so that it stays at rest").answers
    assert answer.value == pytest.approx(math.tan(math.radians(15)), rel=1e-12)
    assert answer.expression is not None


GROOVE = """
space: true
parameters: {h: 0.2 m, l: 0.5 m, alpha: 20 deg, beta: 40 deg, g: 9.81 m/s^2}
ground:
  planes:
    left: {normal: [cos(beta), sin(beta)*cos(alpha), -sin(beta)*sin(alpha)]}
    right: {normal: [-cos(beta), sin(beta)*cos(alpha), -sin(beta)*sin(alpha)]}
bodies:
  wedge:
    convex:
      mass: 3 kg
      points: [[0, 0, 0], [h*tan(beta), h, 0], [-h*tan(beta), h, 0], [0, 0, l],
        [h*tan(beta), h, l], [-h*tan(beta), h, l]]
    at: {origin: [0, 0, 0]}
    turned: -alpha about x
connections:
  on_left: {contact: {between: [wedge, ground.left], friction: 0.1}}
  on_right: {contact: {between: [wedge, ground.right], friction: 0.1}}
loads: {weight: {gravity: g}}
"""


def test_prism_slides_in_a_groove_with_the_friction_of_both_walls() -> None:
    """Each presses with m g cos(alpha)/(2 sin(beta)): a = g (sin(alpha) - mu cos(alpha)/sin(beta))."""
    found = simulated(GROOVE, 0.5)
    a, b = math.radians(20), math.radians(40)
    expected = 0.5 * G * (math.sin(a) - 0.1 * math.cos(a) / math.sin(b))
    assert np.linalg.norm(found.course.velocities[-1, 0, :3]) == pytest.approx(expected, rel=1e-9)
