"""Mobility in space: mechanisms whose freedoms are known, loops against the rank of their joint screws."""

from __future__ import annotations

import json
import math
from typing import Any

import numpy as np
import pytest

from freebody import System
from freebody.errors import CannotAnswer
from freebody.numeric.jets import Array
from freebody.numeric.mobility.generic import generic_rank
from freebody.numeric.mobility.modes import assembly_modes
from freebody.numeric.mobility.path import MotionPath
from freebody.numeric.mobility.rank import rank_at, scaled_rows
from freebody.numeric.reference import Reference
from freebody.study.mobility.centres import instant_centres
from freebody.study.mobility.found import Mobility
from freebody.study.mobility.mobility import mobility

FOUR_BAR = """
space: true
ground: {points: {A: [0, 0, 0], D: [1 m, 0, 0]}}
bodies:
  crank: {rod: {mass: 1 kg, length: 0.3 m}, at: {start: [0, 0, 0]}, turned: 60 deg about z}
  coupler: {rod: {mass: 1 kg, length: 0.9 m}}
  rocker: {rod: {mass: 1 kg, length: 0.6 m}, near: {turned: 80 deg about z}}
connections:
  a: {revolute: {first: ground.A, second: crank.start, about: z}}
  b: {revolute: {first: crank.end, second: coupler.start, about: z}}
  c: {revolute: {first: coupler.end, second: rocker.end, about: z}}
  d: {revolute: {first: ground.D, second: rocker.start, about: z}}
"""

BENNETT = """
space: true
parameters: {a: 0.5 m, b: 1 m, alpha: 30 deg, beta: 90 deg}
ground: {points: {A: [0, 0, 0], B: [a, 0, 0]}}
bodies:
  p: {rod: {mass: 1 kg, length: b}, at: {start: [a, 0, 0]}, near: {turned: [30 deg about x, 60 deg about z]}}
  q: {rod: {mass: 1 kg, length: a}}
  r: {rod: {mass: 1 kg, length: b}}
connections:
  A: {revolute: {first: ground.A, second: r.end, about: z, second_axis: [0, -sin(beta), cos(beta)]}}
  B: {revolute: {first: ground.B, second: p.start, about: [0, -sin(alpha), cos(alpha)], second_axis: z}}
  C: {revolute: {first: p.end, second: q.start, about: [0, -sin(beta), cos(beta)], second_axis: z}}
  D: {revolute: {first: q.end, second: r.start, about: [0, -sin(alpha), cos(alpha)], second_axis: z}}
questions:
  - {find: degrees of freedom, options: {A: 1, B: 0, C: 2}, key: A}
"""

SPHERICAL = """
space: true
ground: {points: {O: [0, 0, 0]}}
bodies:
  crank: {box: {mass: 1 kg, size: [0.1 m, 0.1 m, 0.1 m]}, at: [0, 0, 0], turned: 40 deg about z}
  coupler: {box: {mass: 1 kg, size: [0.1 m, 0.1 m, 0.1 m]}}
  rocker: {box: {mass: 1 kg, size: [0.1 m, 0.1 m, 0.1 m]}}
connections:
  a: {revolute: {first: ground.O, second: crank, about: z}}
  b: {revolute: {first: crank, second: coupler, about: [1, 0, 2], second_axis: z}}
  c: {revolute: {first: coupler, second: rocker, about: [2, 0, 1], second_axis: z}}
  d: {revolute: {first: ground.O, second: rocker, about: [2, 1, 1], second_axis: [1, 0, 1]}}
"""

SLIDER_CRANK = """
space: true
ground: {points: {A: [0, 0, 0], G: [0.4 m, 0, 0.2 m]}}
bodies:
  crank: {rod: {mass: 1 kg, length: 0.2 m}, at: {start: [0, 0, 0]}, turned: 60 deg about z}
  coupler: {rod: {mass: 1 kg, length: 0.8 m}}
  slider: {box: {mass: 1 kg, size: [0.1 m, 0.1 m, 0.1 m]}, near: {at: [0.9 m, 0, 0.2 m]}}
connections:
  a: {revolute: {first: ground.A, second: crank.start, about: z}}
  b: {spherical: [crank.end, coupler.start]}
  c: {spherical: [coupler.end, slider]}
  d: {prismatic: {first: ground.G, second: slider, along: x}}
questions:
  - {find: degrees of freedom, options: {A: 1, B: 2, C: 3}, key: B}
"""

SARRUS = """
space: true
parameters: {L: 0.5 m}
ground: {points: {A: [0, 0, 0], D: [0, 0.3 m, 0.3 m]}}
bodies:
  p: {rod: {mass: 1 kg, length: L}, at: {start: [0, 0, 0]}, turned: [-90 deg about y, 40 deg about y]}
  q: {rod: {mass: 1 kg, length: L}, near: {turned: [-90 deg about y, -40 deg about y]}}
  r: {rod: {mass: 1 kg, length: L}, near: {turned: [-90 deg about y, 40 deg about z]}}
  s: {rod: {mass: 1 kg, length: L}, near: {turned: [-90 deg about y, -40 deg about z]}}
  top: {box: {mass: 1 kg, size: [0.1 m, 0.1 m, 0.1 m]}, points: {A: [0, 0, 0], D: [0, 0.3 m, 0.3 m]}}
connections:
  a: {revolute: {first: ground.A, second: p.start, about: y}}
  b: {revolute: {first: p.end, second: q.start, about: y}}
  c: {revolute: {first: q.end, second: top.A, about: y}}
  d: {revolute: {first: ground.D, second: r.start, about: x, second_axis: z}}
  e: {revolute: {first: r.end, second: s.start, about: z}}
  f: {revolute: {first: s.end, second: top.D, about: z, second_axis: x}}
"""

SHAFT = """
space: true
ground: {points: {A: [0, 0, 0], B: [1 m, 0, 0]}}
bodies: {shaft: {cylinder: {mass: 1 kg, radius: 0.1 m, length: 1 m, axis: x}}}
connections:
  left: {revolute: {first: ground.A, second: shaft.start, about: x}}
  right: {revolute: {first: ground.B, second: shaft.end, about: x}}
"""

ROLLING = """
space: {up: z}
ground: {planes: {floor: {normal: z}}}
bodies: {body: BODY}
connections: {roll: {rolling: [body, floor]}}
"""

UNIVERSALS = """
space: true
ground: {points: {A: [0, 0, 0], B: [1 m, 0.2 m, 0]}}
bodies:
  drive: {cylinder: {mass: 1 kg, radius: 0.05 m, length: 0.2 m, axis: x}}
  middle: {cylinder: {mass: 1 kg, radius: 0.05 m, length: 0.6 m, axis: x}, near: {at: [0.5 m, 0.1 m, 0]}}
  driven: {cylinder: {mass: 1 kg, radius: 0.05 m, length: 0.2 m, axis: x}, near: {at: [0.9 m, 0.2 m, 0]}}
connections:
  a: {revolute: {first: ground.A, second: drive.start, about: x}}
  u: {universal: {first: drive.end, second: middle.start, arm: y, second_arm: z}}
  w: {universal: {first: middle.end, second: driven.start, arm: z, second_arm: y}}
  b: {cylindrical: {first: ground.B, second: driven.end, about: x}}
"""

TRIPOD = """
space: {up: z}
bodies:
  table:
    box: {mass: 1 kg, size: [1 m, 1 m, 0.1 m]}
    at: {P: [0, 0, 0]}
    points: {P: [0, 0, -0.5 m], Q: [1 m, 0, -0.5 m], R: [0, 1 m, -0.5 m], S: [1 m, 1 m, -0.5 m]}
measures: {hp: z of table.P, hq: z of table.Q, hr: z of table.R, hs: z of table.S}
connections:
  p: {constraint: hp}
  q: {constraint: hq}
  r: {constraint: hr}
"""

SHAKY = """
space: true
ground: {points: {A: [1 m, 0, 0], B: [-0.5 m, 0, 0.8 m], C: [-0.5 m, 0, -0.8 m]}}
bodies: {p: {particle: {mass: 1 kg}, at: [0, 0, 0]}}
connections: {a: {link: [ground.A, p]}, b: {link: [ground.B, p]}, c: {link: [ground.C, p]}}
"""

OPEN = """
space: true
ground: {points: [A, D]}
bodies: {crank: rod, coupler: rod, rocker: rod}
connections:
  a: {revolute: {first: ground.A, second: crank.start, about: z}}
  b: {spherical: [crank.end, coupler.start]}
  c: {spherical: [coupler.end, rocker.end]}
  d: {revolute: {first: ground.D, second: rocker.start, about: y}}
"""


def examined(text: str) -> Mobility:
    return mobility(System.from_text(text))


# -- mechanisms -------------------------------------------------------------------------------
def test_a_four_bar_in_space_moves_though_the_count_is_minus_two() -> None:
    # Gogu, Mech. Mach. Theory 40 (2005) 1068: planar loops of four revolutes have three redundant constraints
    found = examined(FOUR_BAR)
    assert found.gruebler.formula == "6*3 - 20 = -2"
    assert (found.rank.rank, found.degrees_of_freedom, found.nearby) == (17, 1, 1)
    assert found.rank.is_exact
    assert found.kind == "special geometry"
    assert len(found.redundant) == 3
    out_of_plane = {f"{joint}.{row}" for joint in "abcd" for row in ("z", "moment x", "moment y")}
    assert set(found.indeterminate) == out_of_plane
    assert "the axes of a, b, c and d are parallel" in found.dependences[0].why
    assert found.independent_coordinates == ("phi_a",)


def test_every_minimal_set_is_minimal() -> None:
    for text in (FOUR_BAR, SARRUS, SHAFT):
        system = System.from_text(text)
        reference = Reference(system)
        q = reference.assemble()
        for circuit in rank_at(reference, q).circuits:
            others = [row.name for row in system.constraint_rows if row.name not in circuit]
            assert rank_at(reference, q, without=others).rank == len(circuit) - 1
            for row in circuit:
                fewer = rank_at(reference, q, without=[*others, row])
                assert fewer.rank == len(circuit) - 1 == len(fewer.rows)


def test_a_four_bar_in_space_moves_as_the_one_in_the_plane() -> None:
    plane = """
ground: {points: {A: [0, 0], D: [1 m, 0]}}
bodies:
  crank: {rod: {mass: 1 kg, length: 0.3 m}, at: {start: [0, 0]}, angle: 60 deg}
  coupler: {rod: {mass: 1 kg, length: 0.9 m}}
  rocker: {rod: {mass: 1 kg, length: 0.6 m}, near: {angle: 80 deg}}
connections:
  a: {pin: [ground.A, crank.start]}
  b: {pin: [crank.end, coupler.start]}
  c: {pin: [coupler.end, rocker.end]}
  d: {pin: [ground.D, rocker.start]}
"""
    flat, space = _path(plane, "angle of rocker"), _path(FOUR_BAR, "phi_d")
    assert space.reach == pytest.approx(flat.reach, abs=1e-9)
    assert len(space.of_kind("dead point")) == len(flat.of_kind("dead point")) == 2
    assert space.is_closed


def _path(text: str, along: str) -> MotionPath:
    motions = mobility(System.from_text(text), along=along).motions
    assert motions is not None
    assert motions.path is not None
    return motions.path


def test_instantaneous_screws_of_a_flat_linkage_are_its_instant_centres() -> None:
    found = examined(FOUR_BAR)
    assert found.motions is not None
    axes = {s.body: s for s in found.motions.screws}
    for s in axes.values():
        assert abs(s.screw.direction[2]) == pytest.approx(1.0)
        assert s.screw.pitch == 0.0
    # the coupler turns about where the lines of crank and rocker meet
    center = axes["coupler"].screw.point
    crank = np.array([math.cos(math.radians(60)), math.sin(math.radians(60)), 0.0])
    assert np.cross(center, crank) == pytest.approx(np.zeros(3), abs=1e-9)


def test_bennett_linkage_moves() -> None:
    # Bennett, Engineering 76 (1903) 777: a/sin(alpha) = b/sin(beta), opposite links alike
    found = examined(BENNETT)
    assert found.gruebler.count == -2
    assert (found.rank.rank, found.finite_freedom, found.kind) == (17, 1, "special geometry")
    assert found.rank.is_exact
    assert "the sines of these angles are as the distances" in found.dependences[0].why
    assert found.answers["q1"].choice == "A"
    assert found.motions is not None
    assert found.motions.path is not None
    assert found.motions.path.full_turn


def test_a_loop_of_four_skew_axes_with_other_lengths_is_stiff() -> None:
    found = examined(BENNETT.replace("b: 1 m", "b: 1.1 m"))
    assert (found.gruebler.count, found.rank.rank, found.finite_freedom) == (-2, 18, 0)
    assert found.kind == "generic"


def test_spherical_four_bar() -> None:
    # McCarthy & Soh, Geometric Design of Linkages, 2nd ed. 2011, ch. 7
    found = examined(SPHERICAL)
    assert (found.gruebler.count, found.rank.rank, found.finite_freedom) == (-2, 17, 1)
    assert found.redundant == tuple(tuple(f"{joint}.{axis}" for joint in "abcd") for axis in "xyz")
    assert all(d.kind == "special geometry" for d in found.dependences)
    assert "meet in one point (0, 0, 0) m" in found.dependences[0].why


def test_slider_crank_with_ball_ended_rod_has_an_idle_freedom() -> None:
    # Norton, Design of Machinery, ch. 2: RSSP counts 2, one of them the coupler's turn about itself
    found = examined(SLIDER_CRANK)
    assert (found.gruebler.count, found.finite_freedom, found.useful_freedom) == (2, 2, 1)
    assert dict(found.idle) == {"coupler": "turns about the line from b to c"}
    assert found.answers["q1"].choice == "B"
    assert "coupler turns about the line from b to c" in found.answers["q1"].options["A"].reason


def test_sarrus_linkage_moves_straight() -> None:
    # Sarrus, C. R. Acad. Sci. 36 (1853) 1036: two planar chains in different planes carry the platform straight on
    found = examined(SARRUS)
    assert (found.gruebler.count, found.rank.rank, found.finite_freedom) == (0, 29, 1)
    assert len(found.redundant) == 1
    assert "the axes of a, b and c are parallel, and so are those of d, e and f" in found.dependences[0].why
    assert found.motions is not None
    top = {s.body: s.screw for s in found.motions.screws}["top"]
    assert top.pitch is None
    assert np.abs(top.direction) == pytest.approx([0.0, 0.0, 1.0], abs=1e-9)


def test_threefold_symmetric_bricard_linkage_moves() -> None:
    # Bricard (1927); Chen, You & Tarnai, Int. J. Solids Struct. 42 (2005) 2287: six equal links, twists of 90 and
    # 270 deg; in one pose they are six edges of a cube, each axis along the edge across its two links
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (1, 1, 1), (0, 1, 1), (0, 0, 1)]
    found = mobility(_loop(corners, _edge_axes(corners)))
    assert (found.gruebler.count, found.rank.rank, found.finite_freedom) == (0, 29, 1)
    assert found.kind == "special geometry"


def test_a_shaft_in_two_bearings() -> None:
    # five of ten constraints are redundant: only turning is left
    found = examined(SHAFT)
    assert (found.gruebler.count, found.degrees_of_freedom, len(found.redundant)) == (-4, 1, 5)
    assert found.redundant[0] == ("left.x", "right.x")
    assert set(found.indeterminate) == {row.name for row in System.from_text(SHAFT).constraint_rows}
    assert "the axes of left and right are one line" in found.dependences[0].why


def test_a_free_body_and_a_free_particle() -> None:
    body = examined("{space: true, bodies: {b: {box: {mass: 1 kg, size: [1 m, 0.4 m, 0.3 m]}}}}")
    particle = examined("{space: true, bodies: {b: {particle: {mass: 1 kg}}}}")
    assert (body.degrees_of_freedom, particle.degrees_of_freedom) == (6, 3)
    assert len(body.independent_coordinates) == 6
    assert particle.independent_coordinates == ("x of b", "y of b", "z of b")
    assert particle.gruebler.formula == "6*0 + 3*1 - 0 = 3"


@pytest.mark.parametrize(
    ("body", "freedoms", "dimensions"),
    [
        # Neimark & Fufaev, Dynamics of Nonholonomic Systems, 1972, ch. I: five coordinates, three velocities
        ("{sphere: {mass: 1 kg, radius: 0.1 m}, at: [0, 0, 0.1 m]}", 3, 5),
        ("{disk: {mass: 1 kg, radius: 0.1 m, axis: y}, near: {at: [0, 0, 0.1 m], turned: 0.3 about x}}", 3, 5),
        # a cone on its plane rolls about its apex: one velocity, which can be integrated
        ("{cone: {mass: 1 kg, radius: 0.1 m, height: 0.2 m}}", 1, 1),
    ],
)
def test_rolling_reaches_more_poses_than_it_has_velocities(body: str, freedoms: int, dimensions: int) -> None:
    found = examined(ROLLING.replace("BODY", body))
    assert (found.gruebler.count, found.degrees_of_freedom) == (freedoms, freedoms)
    assert found.reachable == dimensions


def test_a_shaft_with_two_universal_joints_turns() -> None:
    found = examined(UNIVERSALS)
    assert (found.gruebler.count, found.degrees_of_freedom, found.redundant) == (1, 1, ())
    assert found.motions is not None
    # parallel shafts, arms of the middle shaft in one plane: the driven shaft turns as fast as the driving one
    rates = {s.body: s.rate for s in found.motions.screws}
    assert rates["driven"] == pytest.approx(rates["drive"])


def test_a_table_stands_on_three_feet_and_not_uniquely_on_four() -> None:
    three = examined(TRIPOD)
    four = examined(TRIPOD + "  s: {constraint: hs}\n")
    assert (three.degrees_of_freedom, three.redundant) == (3, ())
    assert four.degrees_of_freedom == 3
    assert four.redundant == (("p.constraint", "q.constraint", "r.constraint", "s.constraint"),)


def test_rods_in_one_plane_hold_a_point_only_to_first_order() -> None:
    found = examined(SHAKY)
    assert (found.degrees_of_freedom, found.finite_freedom, found.kind) == (1, 0, "momentary")
    assert "lie in one plane" in found.dependences[0].why


def test_a_flat_parallelogram_is_at_a_change_point() -> None:
    # with all four axes in one plane a second branch, the crossed one, leaves: two freedoms to first order
    flat = """
space: true
ground: {points: {A: [0, 0, 0], D: [1 m, 0, 0]}}
bodies:
  crank: {rod: {mass: 1 kg, length: 0.3 m}, at: {start: [0, 0, 0]}, turned: []}
  coupler: {rod: {mass: 1 kg, length: 1 m}, at: {start: [0.3 m, 0, 0]}, turned: []}
  rocker: {rod: {mass: 1 kg, length: 0.3 m}, at: {start: [1 m, 0, 0]}, turned: []}
connections:
"""
    found = examined(flat + FOUR_BAR.partition("connections:\n")[2])
    assert (found.degrees_of_freedom, found.nearby, found.kind) == (2, 1, "momentary")
    assert "the axes of a, b, c and d lie in one plane" in found.dependences[0].why
    assert found.motions is not None
    assert found.motions.singular == ("dead point", "change point")


def test_the_report_has_its_parts_in_space() -> None:
    found = examined(SLIDER_CRANK)
    text = found.to_text()
    assert "DOF = n L - K = 6*3 - 16 = 2" in text
    assert "coupler turns about the line from b to c, and nothing else moves" in text
    assert "2 - 1 = 1 without what is idle" in text
    plain = json.loads(json.dumps(found.to_plain()))
    assert plain["useful_degrees_of_freedom"] == 1
    plain = json.loads(json.dumps(examined(SARRUS).to_plain()))
    assert plain["screw_axes"][-1]["pitch"] is None


def test_without_dimensions_the_rank_is_that_of_random_ones() -> None:
    found = examined(OPEN)
    assert (found.basis, found.gruebler.count, found.degrees_of_freedom) == ("symbols", 2, 2)
    assert dict(found.idle) == {"coupler": "turns about the line from b to c"}
    assert generic_rank(System.from_text(OPEN)).n_freedoms == 2


def test_axes_that_are_given_count_where_lengths_are_not() -> None:
    text = OPEN.replace("about: y", "about: z")
    for first, second in (("crank.end", "coupler.start"), ("coupler.end", "rocker.end")):
        joint = f"revolute: {{first: {first}, second: {second}, about: z}}"
        text = text.replace(f"spherical: [{first}, {second}]", joint)
    found = examined(text.replace("points: [A, D]", "points: {A: [0, 0, 0], D: [1 m, 0, 0]}"))
    assert (found.basis, found.gruebler.count, found.degrees_of_freedom) == ("symbols", -2, 1)


def test_without_its_special_geometry_a_loop_of_four_revolutes_is_stiff() -> None:
    for text in (FOUR_BAR, BENNETT, SPHERICAL):
        rank = generic_rank(System.from_text(text))
        assert (rank.n_freedoms, len(rank.circuits)) == (0, 2)


def test_a_driver_takes_the_freedom() -> None:
    named = UNIVERSALS.replace("space: true", "space: true\nparameters: {Omega: 1 rad/s}")
    named = named.replace("length: 0.2 m, axis: x}}", "length: 0.2 m, axis: x}, turned: [psi about x]}", 1)
    found = examined(named + "  motor: {driver: {measure: psi, follows: Omega*t}}\n")
    assert found.degrees_of_freedom == 0
    assert "without motor: 1 degree of freedom" in found.notes
    assert found.motions is not None
    assert found.motions.path is not None
    assert found.motions.path.full_turn


def test_notions_of_the_plane_are_refused_in_space() -> None:
    reference = Reference(System.from_text(FOUR_BAR))
    q = reference.assemble()
    with pytest.raises(CannotAnswer, match="in the plane"):
        instant_centres(reference.system, reference.snapshot(q, 0.0 * q))
    with pytest.raises(CannotAnswer, match="in the plane only"):
        assembly_modes(reference, q, [])


# -- mechanisms of all joints -----------------------------------------------------------------
AXES = ([1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 0], [1, 2, 3])


def _joint(rng: np.random.Generator, first: str, second: str) -> dict[str, Any]:
    kinds = ("revolute", "prismatic", "cylindrical", "spherical", "universal", "screw", "planar", "weld")
    kind, axis = str(rng.choice(kinds)), AXES[int(rng.integers(len(AXES)))]
    own = {
        "spherical": {},
        "weld": {},
        "universal": {"arm": "x", "second_arm": "y"},
        "prismatic": {"along": axis},
        "screw": {"about": axis, "pitch": "0.1 m"},
        "planar": {"normal": axis},
    }
    ends = {"through": first, "body": second} if kind == "planar" else {"first": first, "second": second}
    return {kind: {**ends, **own.get(kind, {"about": axis})}}


def _mechanism(rng: np.random.Generator) -> System:
    """A loop of up to three bodies and the ground, joined at random places; all bodies stand parallel at the origin."""
    n = int(rng.integers(1, 4))
    places = {f"Q{k}": [f"{int(c) / 4} m" for c in rng.integers(-4, 5, 3)] for k in range(n + 1)}
    body: dict[str, Any] = {"box": {"mass": "1 kg", "size": ["1 m"] * 3}, "at": {"P": [0, 0, 0]}, "turned": []}
    bodies: dict[str, Any] = {f"b{k}": {**body, "points": {"P": [0, 0, 0], **places}} for k in range(n)}
    names = ["ground", *bodies, "ground"]
    joints = {f"j{k}": _joint(rng, f"{names[k]}.Q{k}", f"{names[k + 1]}.Q{k}") for k in range(n)}
    joints[f"j{n}"] = _joint(rng, f"ground.Q{n}", f"b{n - 1}.Q{n}")
    return System.from_data({"space": True, "ground": {"points": places}, "bodies": bodies, "connections": joints})


@pytest.mark.parametrize("seed", range(12))
def test_exact_rank_of_a_random_mechanism_is_that_of_its_singular_values(seed: int) -> None:
    system = _mechanism(np.random.default_rng(seed))
    found = mobility(system)
    reference = Reference(system)
    J = scaled_rows(reference, reference.assemble(), system.constraint_rows)
    singular = np.linalg.svd(J, compute_uv=False)
    assert found.rank.is_exact
    assert found.rank.rank == np.count_nonzero(singular > 1e-9 * singular.max()), f"seed {seed}"
    assert found.degrees_of_freedom >= found.finite_freedom >= max(found.gruebler.count, found.n_idle)
    assert len(found.redundant) == found.degrees_of_freedom - found.gruebler.count


# -- single loops against their screws --------------------------------------------------------
def _edge_axes(corners: list[tuple[int, ...]]) -> list[tuple[int, ...]]:
    """Across the two links that meet at each corner."""
    points = np.array(corners)
    axes = [np.cross(points[k] - points[k - 1], points[(k + 1) % len(points)] - points[k]) for k in range(len(points))]
    return [tuple(int(c) for c in axis) for axis in axes]


def _loop(corners: Any, axes: Any) -> System:
    """A loop of bodies, the ground the last, with a revolute joint at every corner; all bodies stand parallel."""
    n = len(corners)
    bodies: dict[str, Any] = {}
    connections: dict[str, Any] = {}

    def point(body: int, k: int) -> str:
        return f"ground.P{k}" if body == n - 1 else f"b{body}.P{k}"

    for k in range(n - 1):
        here, there = corners[k], corners[(k + 1) % n]
        points = {f"P{k}": [0, 0, 0], f"P{k + 1}": [f"{b - a} m" for a, b in zip(here, there, strict=True)]}
        place = {f"P{k}": [f"{c} m" for c in here]}
        bodies[f"b{k}"] = {
            "box": {"mass": "1 kg", "size": ["1 m", "1 m", "1 m"]},
            "at": place,
            "turned": [],
            "points": points,
        }
    ground = {f"P{k}": [f"{c} m" for c in corners[k]] for k in (0, n - 1)}
    for k in range(n):
        first, second = point((k - 1) % n, k), point(k, k)
        connections[f"j{k}"] = {"revolute": {"first": first, "second": second, "about": list(axes[k])}}
    return System.from_data({"space": True, "ground": {"points": ground}, "bodies": bodies, "connections": connections})


def _screw_rank(corners: Array, axes: Array) -> int:
    """The rank of the joints' screws (e, r x e)."""
    screws = np.array([[*e, *np.cross(r, e)] for r, e in zip(corners, axes, strict=True)], dtype=float)
    return int(np.linalg.matrix_rank(screws, tol=1e-9))


def _random_axes(rng: np.random.Generator, n: int, kind: str) -> tuple[Array, Array]:
    corners = np.asarray(rng.integers(-9, 10, (n, 3)) / 4, np.float64)
    axes = np.asarray(rng.integers(-3, 4, (n, 3)), np.float64)
    axes[~axes.any(axis=1)] = (0, 0, 1)
    if kind == "parallel":
        axes[:] = axes[0]
    if kind == "concurrent":
        corners = 0.5 * axes
    if kind == "two directions":
        axes[n // 2 :], axes[: n // 2] = (0, 1, 2), (1, 0, 0)
    return corners, axes


@pytest.mark.parametrize("kind", ["any", "parallel", "concurrent", "two directions"])
@pytest.mark.parametrize("seed", range(3))
def test_exact_rank_of_a_random_loop_is_that_of_its_screws(kind: str, seed: int) -> None:
    # Hunt, Kinematic Geometry of Mechanisms, 1978, ch. 2: a loop of n joints of one freedom has, at a pose,
    # n - (rank of its screws) freedoms
    rng = np.random.default_rng(seed)
    n = int(rng.integers(4, 8))
    corners, axes = _random_axes(rng, n, kind)
    system = _loop(corners.tolist(), axes.tolist())
    reference = Reference(system)
    q = reference.assemble()
    rank = rank_at(reference, q)
    assert rank.is_exact
    assert rank.n_freedoms == n - _screw_rank(corners, axes), f"seed {seed}, {kind}, {n} joints"
