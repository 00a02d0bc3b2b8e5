"""Cylinders that touch each other with their curved sides, beside closed forms, identities and the model in the plane.

Three equal cylinders in a pile rest where the friction between them is at least tan(15 deg) = 2 - sqrt(3) and that on
the floor at least a third of it: Meriam & Kraige, Statics, ch. 6, problems on friction; a bar on two others slides
along itself where tan(alpha) > mu, with g (sin(alpha) - mu cos(alpha)).
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
PILE = """
SPACE
ground: {FLOOR: {floor: {normal: up}}}
bodies:
  left: {SHAPE, at: [-0.1 m, 0.1 mZERO]}
  right: {SHAPE, at: [0.1 m, 0.1 mZERO]}
  top: {SHAPE, at: [0, 0.1 m + sqrt(3)*0.1 mZERO]}
connections:
  a: {contact: {between: [left, ground.floor], friction: MU}}
  b: {contact: {between: [right, ground.floor], friction: MU}}
  c: {contact: {between: [top, left], friction: NU}}
  d: {contact: {between: [top, right], friction: NU}}
"""
BARS = """
space: true
bodies:
  one: {cylinder: {mass: 1, radius: 0.03, length: 0.6, axis: x}, fixed: true, at: [0, LOW, 0.1]}
  two: {cylinder: {mass: 1, radius: 0.03, length: 0.6, axis: x}, fixed: true, at: [0, HIGH, -0.1]}
  rod: {cylinder: {mass: 2, radius: 0.02, length: 0.5, axis: z}, at: [0, UP, 0], turned: ALPHA deg about x}
connections:
  c: {contact: {between: [rod, one], friction: 0.2}}
  d: {contact: {between: [rod, two], friction: 0.2}}
"""
TWO = """
space: true
bodies:
  top: {cylinder: {mass: 2, radius: 0.1, length: 0.3, axis: AXIS}, at: [PLACE]MORE}
  low: {cylinder: {mass: 1, radius: 0.1, length: 0.6, axis: z}, fixed: true, at: [0, 0, 0]}
connections: {it: {contact: {between: [top, low], friction: 0.3}}}
"""


def pile(mu: float, nu: float, *, in_space: bool = True) -> fb.System:
    known = {
        "SPACE": "space: true" if in_space else "",
        "FLOOR": "planes" if in_space else "lines",
        "SHAPE": "cylinder: {mass: 2, radius: 0.1, length: 0.3, axis: z}"
        if in_space
        else "disk: {mass: 2, radius: 0.1}",
        "ZERO": ", 0" if in_space else "",
        "MU": str(mu),
        "NU": str(nu),
    }
    text = PILE
    for name, value in known.items():
        text = text.replace(name, value)
    return fb.System.from_text(
        (text if in_space else text.replace("normal: up", "through: [0, 0], along: right")) + WEIGHT
    )


def bars(alpha: float) -> fb.System:
    a = math.radians(alpha)
    known = {"LOW": -0.1 * math.tan(a), "HIGH": 0.1 * math.tan(a), "UP": 0.05 / math.cos(a), "ALPHA": alpha}
    text = BARS
    for name, value in known.items():
        text = text.replace(name, repr(value))
    return fb.System.from_text(text + WEIGHT)


def two(axis: str, place: str, more: str = "") -> fb.System:
    return fb.System.from_text(TWO.replace("AXIS", axis).replace("PLACE", place).replace("MORE", more) + WEIGHT)


@pytest.mark.parametrize(
    ("mu", "nu", "holds"),
    [
        (0.5, 0.267, False),
        (0.0892, 0.5, False),
        pytest.param(0.5, 0.269, True, marks=pytest.mark.slow),
        pytest.param(0.0894, 0.5, True, marks=pytest.mark.slow),
    ],
)
def test_pile_of_three_cylinders_needs_tan_15_between_them_and_a_third_of_it_on_the_floor(
    mu: float, nu: float, *, holds: bool
) -> None:
    assert pile(mu, nu).statics().holds == holds


@pytest.mark.slow
def test_pile_falls_apart_as_three_disks_do_in_the_plane() -> None:
    space, plane = pile(0.05, 0.05).simulate(0.1), pile(0.05, 0.05, in_space=False).simulate(0.1)
    assert space.course.status is Status.FINISHED, space.course.message
    assert space.course.poses[-1, :3, :2] == pytest.approx(plane.course.poses[-1, :3, :2], abs=1e-8)


@pytest.mark.parametrize(("alpha", "holds"), [(11.2, True), (11.4, False)])
def test_bar_across_two_bars_holds_up_to_the_angle_of_friction(alpha: float, *, holds: bool) -> None:
    assert math.tan(math.radians(11.3)) == pytest.approx(0.2, abs=3e-4)
    assert bars(alpha).statics().holds == holds


def test_steep_bar_slides_along_itself_with_g_sin_minus_mu_cos_and_tips_over_the_lower_one() -> None:
    """It tips where its friction, at r below the axis, and its weight have no moment about the lower bar: its middle is
    then mu r before that."""
    found = bars(20).simulate(0.41)
    assert found.course.status is Status.FINISHED, found.course.message
    a = math.radians(20)
    acceleration = G * (math.sin(a) - 0.2 * math.cos(a))
    n = int(np.searchsorted(found.course.times, 0.2))
    t, way = found.course.times[n], found.course.poses[n, 0, :3] - found.course.poses[0, 0, :3]
    assert way == pytest.approx(0.5 * t**2 * acceleration * np.array((0, -math.sin(a), math.cos(a))), abs=1e-9)
    tips = 0.1 / math.cos(a) + 0.05 * math.tan(a) - 0.2 * 0.02
    assert [(str(e.name), e.time) for e in found.course.events] == [
        ("rod leaves two", pytest.approx(math.sqrt(2 * tips / acceleration), rel=1e-6))
    ]


def test_rod_falls_across_a_cylinder_and_lies_there() -> None:
    found = two("x", "0, 0.3, 0").simulate(0.3)
    assert found.course.status is Status.FINISHED, found.course.message
    assert [e.time for e in found.course.events] == [pytest.approx(math.sqrt(0.2 / G), rel=1e-9)]
    assert found.course.poses[-1, 0, :3] == pytest.approx((0, 0.2, 0), abs=1e-9)


@pytest.mark.slow
def test_cylinder_rolls_off_another_one_as_a_disk_off_a_disk() -> None:
    """From rest at the top it would leave at cos = 4/7 of a rough one; with friction it slips a little before."""
    lean = 0.2
    v = math.sqrt(4 / 3 * G * 0.4 * (1 - math.cos(lean)))
    at, along = (0.4 * math.sin(lean), 0.4 * math.cos(lean)), (v * math.cos(lean), -v * math.sin(lean))
    space = f"""
space: true
bodies:
  roll:
    cylinder: {{mass: 2, radius: 0.1, length: 0.3, axis: z}}
    at: [{at[0]}, {at[1]}, 0]
    velocity: [{along[0]}, {along[1]}, 0]
    angular_velocity: [0, 0, {-10 * v}]
  hill: {{cylinder: {{mass: 1, radius: 0.3, length: 0.6, axis: z}}, fixed: true, at: [0, 0, 0]}}
connections: {{c: {{contact: {{between: [roll, hill], friction: 3}}}}}}
"""
    plane = f"""
bodies:
  roll:
    disk: {{mass: 2, radius: 0.1}}
    at: [{at[0]}, {at[1]}]
    velocity: [{along[0]}, {along[1]}]
    angular_velocity: {-10 * v}
  hill: {{disk: {{radius: 0.3}}, fixed: true, at: [0, 0]}}
connections: {{c: {{contact: {{between: [roll, hill], friction: 3}}}}}}
"""
    found, flat = (fb.System.from_text(text + WEIGHT).simulate(0.5) for text in (space, plane))
    left = {e.time for e in found.course.events if e.kind == "parts"}
    assert [*left] == pytest.approx([e.time for e in flat.course.events if e.kind == "parts"] * len(left), rel=1e-8)
    assert found.course.poses[-1, 0, :2] == pytest.approx(flat.course.poses[-1, 0, :2], abs=1e-8)


@pytest.mark.parametrize(
    ("axis", "place", "more", "told"),
    [
        ("y", "0, 0.4, 0", "", "top.start comes to the curved side of low, and their axes are not parallel"),
        ("x", "0.16, 0.3, 0", "", "top.start comes to the curved side of low"),
        ("z", "0, 0.21, 0", ", turned: 0.02 deg about y", "comes to the curved side of low"),
        ("z", "0, 0.3, 0.4", "", "axes are not parallel"),
    ],
)
def test_where_a_rim_may_touch_the_motion_ends_with_a_sentence(axis: str, place: str, more: str, told: str) -> None:
    found = two(axis, place, more).simulate(0.3)
    assert found.course.status is Status.INCONSISTENT
    assert told in found.course.message


def test_end_to_end_is_refused_at_the_start() -> None:
    with pytest.raises(fb.FreebodyError, match="how two ends of cylinders touch is not followed"):
        two("z", "0, 0, 0.6").simulate(0.1)


@pytest.mark.parametrize("where", ["crossed", "parallel"])
@pytest.mark.parametrize("seed", range(2))
def test_slip_is_the_velocity_of_one_material_point_against_the_other(where: str, seed: int) -> None:
    """u = v_1 + w_1 x (P - C_1) - v_2 - w_2 x (P - C_2): along the normal the rate of the gap, across it the slip."""
    rng = np.random.default_rng(20 + seed)
    whole, P = Rotation.random(random_state=rng), rng.normal(size=3)
    # of the first one C_1 = P + 0.1 n + 0.07 a, of the second C_2 = P - 0.2 n + 0.05 b; n is y
    a = np.array((math.sin(0.6), 0, math.cos(0.6))) if where == "crossed" else np.array((0, 0, 1.0))
    own = Rotation.from_euler("y", 0.6 if where == "crossed" else 0.0)
    n, b = np.array((0, 1.0, 0)), np.array((0, 0, 1.0))
    shift = 0.07 if where == "crossed" else 0.2  # then the end is at P
    centres = [P + whole.apply(0.1 * n + shift * a), P + whole.apply(-0.2 * n + 0.05 * b)]
    v, w = rng.normal(size=(2, 3)), rng.normal(size=(2, 3))
    bodies = ""
    for k, (name, radius, turn) in enumerate((("one", 0.1, whole * own), ("two", 0.2, whole))):
        x, y, z = turn.as_euler("XYZ")
        bodies += (
            f"  {name}: {{cylinder: {{mass: 1, radius: {radius}, length: {0.4 + 0.8 * k}, axis: z}}, "
            f"at: {centres[k].tolist()}, velocity: {v[k].tolist()}, angular_velocity: {w[k].tolist()}, "
            f"turned: [{x} rad about x, {y} rad about y, {z} rad about z]}}\n"
        )
    system = fb.System.from_text(
        f"space: true\nbodies:\n{bodies}connections: {{it: {{contact: {{between: [one, two], friction: 0.3}}}}}}\n"
    )
    reference = Reference(system, {})
    q = reference.assemble()
    g = reference.geometry(q, reference.velocities(q), 0.0)
    touching = [x for x in system.bounds if abs(gap_of(reference, g, x)) < 1e-9 and is_within(reference, g, x)]
    if where == "parallel":
        assert {x.row.ends[0] for x in touching} == {"one.start", "one.end"}
        touching = [x for x in touching if x.row.ends[0] == "one.start"]
    [bound] = touching
    [rub] = [rub for rub in system.dry_friction if rub.of == bound.name]
    u = v[0] + np.cross(w[0], P - centres[0]) - v[1] - np.cross(w[1], P - centres[1])
    normal = whole.apply(n)
    gap = reference.jet(g, bound.row.measure, "gap")
    assert bound.row.sign * gap.rate == pytest.approx(u @ normal, abs=1e-10)
    slips = [reference.jet(g, row.measure, "slip").rate for row in rub.rows]
    assert math.hypot(*slips) == pytest.approx(np.linalg.norm(u - (u @ normal) * normal), abs=1e-10)
