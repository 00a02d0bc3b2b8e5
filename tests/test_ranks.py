"""Ranks of constraint rows, their circuits, and what these are due to.

Counts are those of Gruebler and Kutzbach, F = 3 (n - 1) - 2 j for n bodies with the ground and j pins, or known from
the theory of rigid frameworks.
"""

from __future__ import annotations

import itertools
import math
from typing import Any

import numpy as np
import pytest

import freebody as fb
from freebody.errors import InputError
from freebody.language.expression import number
from freebody.numeric.mobility.generic import Framework, generic_rank
from freebody.numeric.mobility.idle import idle_motions
from freebody.numeric.mobility.kinds import Dependence, dependences
from freebody.numeric.mobility.rank import Rank, rank_at, rows_without, scaled_rows
from freebody.numeric.reference import Reference
from freebody.system.generic import generic_model
from mechanisms import chain, ladder

Model = dict[str, Any]


def rod(length: float, start: list[float], angle: object, *, near: bool = False, **more: object) -> Model:
    place = {"at": {"start": start}, "angle": angle}
    return {"rod": {"mass": "1 kg", "length": length}, **({"near": place} if near else place), **more}


def pins(**joints: list[str]) -> Model:
    return {name: {"pin": points} for name, points in joints.items()}


def model(bodies: Model, connections: Model, **points: list[object]) -> fb.System:
    return fb.System.from_data({"ground": {"points": points}, "bodies": bodies, "connections": connections})


def studied(system: fb.System) -> tuple[Rank, tuple[Dependence, ...]]:
    """The rank at the start, and what its circuits are due to; circuits are checked on the way."""
    reference = Reference(system)
    q = reference.assemble()
    rank = rank_at(reference, q)
    assert len(rank.rows) == len(system.constraint_rows) == rank.rank + len(rank.circuits)
    check_circuits(reference, rank)
    return rank, dependences(reference, q, rank)


def check_circuits(reference: Reference, rank: Rank) -> None:
    """A circuit of k rows has rank k - 1, and so has what is left when any of its rows is left out."""
    at = {row.name: k for k, row in enumerate(reference.system.constraint_rows)}
    J = scaled_rows(reference, np.array(rank.pose), reference.system.constraint_rows)
    for circuit in rank.circuits:
        rows = J[[at[name] for name in circuit]]
        assert np.linalg.matrix_rank(rows, tol=1e-7) == len(circuit) - 1
        for k in range(len(circuit)):
            assert np.linalg.matrix_rank(np.delete(rows, k, axis=0), tol=1e-7) == len(circuit) - 1


# Mechanisms -------------------------------------------------------------------------------------
def four_bar() -> fb.System:
    bodies = {
        "crank": rod(1.0, [0, 0], "70 deg"),
        "coupler": rod(2.5, [0.3, 0.9], "15 deg", near=True),
        "rocker": rod(2.0, [3, 0], "110 deg", near=True),
    }
    joints = pins(
        A=["ground.A", "crank.start"],
        B=["crank.end", "coupler.start"],
        C=["coupler.end", "rocker.end"],
        D=["ground.D", "rocker.start"],
    )
    return model(bodies, joints, A=[0, 0], D=[3, 0])


def slider_crank() -> fb.System:
    bodies = {
        "crank": rod(1.0, [0, 0], "50 deg"),
        "rod": rod(3.0, [0.6, 0.8], "-15 deg", near=True),
        "block": {"rectangle": {"mass": 1, "width": 1, "height": 1}, "near": {"at": [3.5, 0]}},
    }
    joints = pins(A=["ground.A", "crank.start"], B=["crank.end", "rod.start"], C=["rod.end", "block"])
    return model(bodies, {**joints, "guide": {"slider": {"body": "block", "along": "right"}}}, A=[0, 0])


def parallelogram(angle: object, third_foot: float | None = None, third_length: float = 1.0) -> fb.System:
    """Cranks of 1 m on feet 2 m apart, the third one under the middle of the coupler, or wherever it fits."""
    turn = math.radians(float(str(angle).split()[0]))
    top = [math.cos(turn), math.sin(turn)]
    bodies = {
        "left": rod(1.0, [0, 0], angle),
        "right": rod(1.0, [2, 0], angle, near=True),
        "coupler": rod(2.0, top, 0, near=True, points={"M": [0, 0]}),
    }
    joints: dict[str, list[str]] = {
        "A": ["ground.A", "left.start"],
        "B": ["ground.B", "right.start"],
        "D": ["left.end", "coupler.start"],
        "E": ["right.end", "coupler.end"],
    }
    points: dict[str, list[object]] = {"A": [0, 0], "B": [2, 0]}
    if third_foot is not None:
        heading = math.atan2(top[1], top[0] + 1.0 - third_foot)
        bodies["third"] = rod(third_length, [third_foot, 0], heading, near=True)
        joints |= {"C": ["ground.C", "third.start"], "F": ["third.end", "coupler.M"]}
        points["C"] = [third_foot, 0]
    return model(bodies, pins(**joints), **points)


def six_bar(*, watt: bool) -> fb.System:
    """A four-bar with two bars more: on crank and coupler joined to the ground (Watt, two four-bars in a row that share
    the rocker), or from the coupler to the ground (Stephenson)."""
    base = four_bar()
    data = base.document.data
    data["bodies"]["rocker"]["points"] = {"P": [0.4, 0.5]}
    data["bodies"]["coupler"]["points"] = {"P": [0.2, 0.7]}
    data["ground"]["points"]["G"] = [5, 0.2]
    carrier = "rocker" if watt else "coupler"
    data["bodies"] |= {
        "arm": rod(2.2, [2.5, 1.5], "-10 deg", near=True),
        "last": rod(1.7, [5, 0.2], "100 deg", near=True),
    }
    data["connections"] |= pins(
        P=[f"{carrier}.P", "arm.start"], Q=["arm.end", "last.end"], G=["ground.G", "last.start"]
    )
    return fb.System.from_data(data)


def planetary(n_planets: int) -> fb.System:
    """A sun and n equal planets on a carrier inside a fixed ring."""
    places = {f"P{k}": [f"a*cos(2*pi*{k}/{n_planets})", f"a*sin(2*pi*{k}/{n_planets})"] for k in range(n_planets)}
    bodies: Model = {
        "sun": {"disk": {"mass": 1, "radius": 0.1}},
        "ring": {"ring": {"mass": 1, "radius": 0.2}, "fixed": True, "at": [0, 0]},
        "carrier": {"body": {"mass": 1, "inertia": 1}, "points": places, "angle": 0},
    }
    connections: Model = pins(S=["ground.O", "sun"], K=["ground.O", "carrier"])
    for k in range(n_planets):
        bodies[f"p{k}"] = {"disk": {"mass": 1, "radius": 0.05}, "near": {"at": places[f"P{k}"]}}
        connections |= {
            f"pin{k}": {"pin": [f"carrier.P{k}", f"p{k}"]},
            f"outer{k}": {"gear_mesh": ["sun", f"p{k}"]},
            f"inner{k}": {"gear_mesh": {"first": "ring", "second": f"p{k}", "internal": True}},
        }
    return fb.System.from_data(
        {
            "parameters": {"a": "0.15 m"},
            "ground": {"points": {"O": [0, 0]}},
            "bodies": bodies,
            "connections": connections,
        }
    )


def cam_and_roller() -> fb.System:
    bodies = {
        "cam": {"disk": {"mass": 1, "radius": 1}, "points": {"E": [0.3, 0]}, "angle": "20 deg"},
        "follower": rod(1.0, [0, 1.2], "90 deg", near=True),
        "roller": {"disk": {"mass": 1, "radius": 0.2}, "near": {"at": [0, 1.2]}},
    }
    connections = {
        **pins(axle=["ground.A", "cam.E"], roller_pin=["follower.start", "roller"]),
        "guide": {"slider": {"body": "follower", "along": "up"}},
        "touch": {"link": ["cam", "roller", 1.2]},
    }
    return model(bodies, connections, A=[0, 0])


# Ranks ------------------------------------------------------------------------------------------
@pytest.mark.parametrize(
    ("system", "n_bodies", "n_pins"),
    [
        (four_bar(), 3, 4),
        (parallelogram("60 deg"), 3, 4),
        (six_bar(watt=True), 5, 7),
        (six_bar(watt=False), 5, 7),
        (chain(7), 7, 7),
        (ladder(4), 9, 4 + 1 + 2 * 4),
    ],
)
def test_linkages_have_the_freedoms_that_gruebler_counts(system: fb.System, n_bodies: int, n_pins: int) -> None:
    rank, found = studied(system)
    assert (rank.n_coordinates, len(rank.rows)) == (3 * n_bodies, 2 * n_pins)
    assert rank.n_freedoms == 3 * n_bodies - 2 * n_pins
    assert rank.circuits == found == ()
    assert rank.gap[0] > 1e-6
    assert generic_rank(system).rank == rank.rank


def test_slider_crank_has_one_freedom() -> None:
    rank, _ = studied(slider_crank())
    # three pins and a slider, two rows each
    assert (rank.n_coordinates, rank.rank, rank.n_freedoms) == (9, 8, 1)
    assert generic_rank(slider_crank()).rank == 8


def test_third_parallel_crank_makes_a_parallelogram_redundant_by_its_sizes() -> None:
    system = parallelogram("60 deg", third_foot=1.0)
    rank, (dependence,) = studied(system)
    # 3 * 4 - 2 * 6 = 0 by the count, but it moves
    assert (rank.n_coordinates, len(rank.rows), rank.rank, rank.n_freedoms) == (12, 12, 11, 1)
    assert rank.is_exact
    assert rank.redundant == ("F.y",)
    assert dependence.kind == "special geometry"
    assert set(dependence.connections) == set("ABCDEF")
    assert dependence.why == "left, right and third are equally long (1 m) and parallel."
    assert rank.reactions == dependence.reactions == rank.rows
    assert generic_rank(system).rank == Framework.of(system).rank(rank.rows).rank == 12


def test_third_crank_that_only_fits_the_start_pose_makes_it_rigid() -> None:
    foot = 0.7
    length = math.hypot(math.cos(math.pi / 3) + 1.0 - foot, math.sin(math.pi / 3))
    rank, found = studied(parallelogram("60 deg", foot, length))
    assert (rank.rank, rank.n_freedoms, found) == (12, 0, ())


def test_leaving_out_the_third_crank_leaves_no_circuit() -> None:
    reference = Reference(parallelogram("60 deg", third_foot=1.0))
    q = reference.assemble()
    without = rank_at(reference, q, without=["C", "F.x", "F.y"])
    assert (without.rank, without.circuits) == (8, ())
    assert rank_at(reference, q, without=["F.y"]).rank == 11
    with pytest.raises(InputError, match="no row or connection G"):
        rank_at(reference, q, without=["G"])


def test_flat_parallelogram_is_singular_in_this_pose_only() -> None:
    rank, (dependence,) = studied(parallelogram("0 deg"))
    # both branches, parallel and crossed, leave from here: two freedoms for a moment
    assert (rank.rank, rank.n_freedoms, rank.is_exact) == (7, 2, True)
    assert "exact numbers" in rank.how
    assert (dependence.kind, dependence.is_shaky) == ("momentary", False)
    assert dependence.why == "At this pose A, B, D and E lie in line."
    assert generic_rank(parallelogram("0 deg")).rank == 8


def test_two_bars_in_line_are_shaky() -> None:
    bodies = {"a": rod(1.0, [0, 0], 0), "b": rod(1.5, [2.5, 0], "180 deg")}
    joints = pins(A=["ground.A", "a.start"], B=["ground.B", "b.start"], C=["a.end", "b.end"])
    rank, (dependence,) = studied(model(bodies, joints, A=[0, 0], B=[2.5, 0]))
    # three rows along the line for two positions along it; nothing holds C across it to first order
    assert (rank.rank, rank.n_freedoms, rank.is_exact) == (5, 1, True)
    assert (dependence.kind, dependence.is_shaky) == ("momentary", True)
    assert "A, B and C lie in line" in dependence.why
    assert "infinitesimal" in dependence.why
    assert set(dependence.rows) == {"A.x", "B.x", "C.x"}


def test_two_bars_nearly_in_line_are_rigid() -> None:
    bodies = {"a": rod(1.0, [0, 0], "30 deg", near=True), "b": rod(1.5, [2.4, 0], "150 deg", near=True)}
    joints = pins(A=["ground.A", "a.start"], B=["ground.B", "b.start"], C=["a.end", "b.end"])
    rank, found = studied(model(bodies, joints, A=[0, 0], B=[2.4, 0]))
    assert (rank.rank, found) == (6, ())


def test_body_on_three_links_through_one_point_turns_about_it_for_a_moment() -> None:
    # three links hold a body unless their lines meet in one point (or are parallel); here all meet in (0, 3)
    feet: dict[str, list[object]] = {"A": [-2, -1], "B": [0, -1], "C": [2, -1]}
    points = {"P": [-1, 1], "Q": [0, 0.5], "R": [1, 1]}
    body = {"body": {"mass": 1, "inertia": 1}, "points": points, "at": [0, 0], "angle": 0}
    links = {f"l{a}": {"link": [f"ground.{a}", f"plate.{p}"]} for a, p in zip("ABC", "PQR", strict=True)}
    rank, (dependence,) = studied(model({"plate": body}, links, **feet))
    assert (rank.rank, rank.n_freedoms, rank.is_exact) == (2, 1, True)
    assert (dependence.kind, dependence.is_shaky) == ("momentary", True)
    assert "the lines of lA, lB and lC meet in one point (0, 3) m" in dependence.why


def test_sizes_that_fit_to_twelve_digits_only_are_said_to_be_judged_by_rounded_numbers() -> None:
    rank, (dependence,) = studied(parallelogram("60 deg", 1.0, 1.0 + 1e-12))
    assert (rank.rank, rank.is_exact) == (11, False)
    assert "not confirmed in more digits" in rank.how
    assert dependence.kind == "special geometry"


def test_body_welded_twice_is_held_twice_in_any_geometry() -> None:
    bodies = {"beam": rod(1.0, [0, 0], "20 deg")}
    end = [math.cos(math.pi / 9), math.sin(math.pi / 9)]
    welds = {"A": {"weld": ["ground.A", "beam.start"]}, "B": {"weld": ["ground.B", "beam.mid"]}}
    bodies["beam"]["points"] = {"mid": ["0 m", "0.5 m"]}
    system = model(bodies, welds, A=[0, 0], B=[0.5 * end[0] - 0.5 * end[1], 0.5 * end[1] + 0.5 * end[0]])
    rank, found = studied(system)
    assert (len(rank.rows), rank.rank, rank.n_freedoms) == (6, 3, 0)
    assert rank.redundant == ("B.x", "B.y", "B.angle")
    assert [d.kind for d in found] == ["generic"] * 3
    assert ("A.angle", "B.angle") in rank.circuits
    generic = generic_rank(system)
    assert (generic.rank, len(generic.circuits)) == (3, 3)


@pytest.mark.parametrize("angle", [0, "35 deg"])
def test_two_bodies_on_two_pins_have_one_row_too_many_in_any_geometry(angle: object) -> None:
    body = {"body": {"mass": 1, "inertia": 1}, "points": {"P": [0.2, 0], "Q": [1.4, 0]}, "angle": angle}
    system = model({"a": body, "b": body}, pins(p=["a.P", "b.P"], q=["a.Q", "b.Q"]))
    rank, (dependence,) = studied(system)
    assert (len(rank.rows), rank.rank, rank.n_freedoms) == (4, 3, 3)
    assert dependence.kind == "generic"
    assert generic_rank(system).rank == 3


def test_two_coaxial_sliders_share_their_angle_always_and_their_guide_by_its_place() -> None:
    block = {"rectangle": {"mass": 1, "width": 1, "height": 1}}
    sliders = {name: {"slider": {"body": "block", "along": "right"}} for name in ("s1", "s2")}
    system = model({"block": block}, sliders)
    rank, found = studied(system)
    assert (rank.rank, rank.circuits) == (2, (("s1.normal", "s2.normal"), ("s1.angle", "s2.angle")))
    assert [d.kind for d in found] == ["special geometry", "generic"]
    assert "the guides of s1 and s2 are in one line" in found[0].why
    assert generic_rank(system).rank == 3


def test_triangle_is_rigid_and_stiffly_supported_by_three_rows() -> None:
    bodies = {
        "a": rod(2.0, [0, 0], 0),
        "b": rod(2.0, [2, 0], "120 deg", near=True),
        "c": rod(2.0, [0, 0], "60 deg", near=True),
    }
    joints = pins(A=["a.start", "c.start"], B=["a.end", "b.start"], C=["b.end", "c.end"], foot=["ground.A", "a.start"])
    points: dict[str, list[object]] = {"A": [0, 0], "B": [2, 0]}
    roller = {"slot": {"pin": "a.end", "along": "right", "through": "ground.B"}}
    # Maxwell: 3 bars for 2 * 3 - 3 freedoms of the joints, and three rows of support
    rank, found = studied(model(bodies, {**joints, "roller": roller}, **points))
    assert (rank.n_coordinates, rank.rank, found) == (9, 9, ())
    both_pinned = model(bodies, joints | pins(other=["ground.B", "a.end"]), **points)
    rank, (dependence,) = studied(both_pinned)
    assert (len(rank.rows), rank.rank) == (10, 9)
    assert dependence.kind == "generic"
    assert set(dependence.connections) == {"foot", "other"}


@pytest.mark.parametrize("n_planets", [1, 2, 3, 4])
def test_planets_beyond_the_first_are_redundant_by_their_equal_radii(n_planets: int) -> None:
    system = planetary(n_planets)
    rank, found = studied(system)
    # one planet carries the ratio; every other one adds three coordinates and four rows, of which three count
    assert (rank.n_coordinates, len(rank.rows)) == (6 + 3 * n_planets, 4 + 4 * n_planets)
    assert (rank.n_freedoms, len(rank.circuits), rank.is_exact) == (1, n_planets - 1, True)
    assert [d.kind for d in found] == ["special geometry"] * (n_planets - 1)
    for k, dependence in enumerate(found, 1):
        assert "sun and ring are concentric" in dependence.why
        assert f"p0 and p{k} have equal radii (0.05 m)" in dependence.why


def test_velocity_constraints_count() -> None:
    skate = {
        "bodies": {"skate": {"rod": {"mass": 1, "length": 1}}},
        "measures": {"x": "x of skate", "y": "y of skate", "theta": "angle of skate"},
        "connections": {"edge": {"velocity_constraint": "rate(y)*cos(theta) - rate(x)*sin(theta)"}},
    }
    system = fb.System.from_data(skate)
    rank, _ = studied(system)
    assert (rank.rank, rank.n_freedoms) == (1, 2)
    assert generic_rank(system).rank == 1


def test_free_body_has_rank_zero() -> None:
    reference = Reference(model({"b": rod(1.0, [0, 0], 0)}, {}))
    rank = rank_at(reference, reference.assemble())
    assert (rank.rank, rank.n_freedoms, rank.circuits) == (0, 3, ())


# Generic geometry -------------------------------------------------------------------------------
def test_generic_rank_needs_no_values() -> None:
    data = four_bar().document.data
    data["parameters"] = {"L1": "m", "L2": "m", "d": "m"}
    data["bodies"]["crank"]["rod"]["length"], data["bodies"]["coupler"]["rod"]["length"] = "L1", "L2"
    data["ground"]["points"]["D"] = ["d", 0]
    assert generic_rank(fb.System.from_data(data)).rank == 8


@pytest.mark.parametrize("seed", range(3))
def test_generic_rank_does_not_depend_on_the_draw(seed: int) -> None:
    for system, expected in ((parallelogram("0 deg", 1.0), 12), (planetary(2), 12), (cam_and_roller(), 7)):
        generic = generic_rank(system, seed)
        assert (generic.rank, generic.is_exact) == (expected, True), f"seed {seed}"


@pytest.mark.parametrize(("system", "expected"), [(chain(200), 400), (ladder(66), 398)])
def test_linkages_of_two_hundred_bars_have_no_circuits(system: fb.System, expected: int) -> None:
    reference = Reference(system)
    rank = rank_at(reference, reference.assemble())
    assert (rank.rank, rank.circuits, rank.is_exact) == (expected, (), True)
    generic = generic_rank(system)
    assert (generic.rank, generic.is_exact) == (expected, True)


def test_generic_model_shares_the_points_that_connections_share() -> None:
    generic = generic_model(parallelogram("60 deg", 1.0))
    rows = {row.name: row for row in generic.system.constraint_rows}
    assert [row.name for row in generic.system.constraint_rows] == [
        row.name for row in parallelogram("60 deg", 1.0).constraint_rows
    ]
    crank = generic.system.bodies["left"]
    measure: Any = rows["D.x"].measure
    assert measure.origin.offset == crank.points["end"]
    assert crank.points["end"] != crank.points["start"]


def test_laman_graphs_of_bars_are_generically_independent() -> None:
    # Laman 1970: 2 v - 3 bars, and no v' joints with more than 2 v' - 3 bars among them; particles joined by links
    particles = {f"j{k}": {"particle": {"mass": 1}, "at": [k, k * k]} for k in range(5)}

    def framework(bars: list[tuple[int, int]]) -> fb.System:
        return model(particles, {f"b{i}{j}": {"link": [f"j{i}", f"j{j}"]} for i, j in bars})

    laman = [(0, 1), (0, 2), (1, 2), (1, 3), (2, 3), (2, 4), (3, 4)]
    assert generic_rank(framework(laman)).rank == 7
    complete = list(itertools.combinations(range(4), 2))
    crowded = generic_rank(framework([*complete, (3, 4)]))
    assert (crowded.rank, len(crowded.circuits)) == (6, 1)
    assert set(crowded.circuits[0]) == {f"b{i}{j}.length" for i, j in complete}


# Idle freedoms ----------------------------------------------------------------------------------
def test_roller_on_a_cam_turns_idly_about_its_pin() -> None:
    system = cam_and_roller()
    reference = Reference(system)
    q = reference.assemble()
    rank = rank_at(reference, q)
    # pin, pin, slider and contact: 9 - 7 freedoms, of which the cam decides one
    assert (rank.n_coordinates, rank.rank, rank.n_freedoms) == (9, 7, 2)
    assert idle_motions(reference, q) == {"roller": ["turns about its pin roller_pin"]}


@pytest.mark.parametrize("system", [chain(3), four_bar(), slider_crank(), planetary(3), parallelogram("0 deg")])
def test_what_drives_others_or_hangs_last_is_not_idle(system: fb.System) -> None:
    reference = Reference(system)
    assert idle_motions(reference, reference.assemble()) == {}


# Random mechanisms ------------------------------------------------------------------------------
def random_mechanism(rng: np.random.Generator) -> fb.System:
    """Bodies on pins in a tree, with links and sliders across, some of them twice."""
    n = int(rng.integers(2, 6))
    bodies: Model = {}
    connections: Model = {}
    for k in range(n):
        points = {name: [round(float(x), 2) for x in rng.uniform(-1, 1, 2)] for name in "PQR"}
        place = {
            "at": [round(float(x), 2) for x in rng.uniform(-3, 3, 2)],
            "angle": round(float(rng.uniform(-3, 3)), 2),
        }
        bodies[f"b{k}"] = {"body": {"mass": 1, "inertia": 1}, "points": points, "near": place}
        parent = "ground.A" if k == 0 else f"b{rng.integers(k)}.{rng.choice(list('QR'))}"
        connections[f"pin{k}"] = {"pin": [parent, f"b{k}.P"]}
    for k in range(int(rng.integers(1, 4))):
        i, j = rng.choice(n, 2, replace=False)
        connections[f"link{k}"] = {"link": [f"b{i}.Q", f"b{j}.R"]}
        if rng.random() < 0.4:
            connections[f"again{k}"] = connections[f"link{k}"]
    if rng.random() < 0.5:
        angle = f"{rng.integers(1, 90)} deg"
        connections["guide"] = {"slider": {"body": f"b{rng.integers(n)}.Q", "along": angle}}
    return model(bodies, connections, A=[0, 0])


@pytest.mark.parametrize("seed", range(25))
def test_random_mechanisms_have_the_rank_of_their_singular_values(seed: int) -> None:
    system = random_mechanism(np.random.default_rng(seed))
    reference = Reference(system)
    q = reference.assemble()
    rank = rank_at(reference, q)
    singular = np.linalg.svd(scaled_rows(reference, q, rows_without(reference, ())), compute_uv=False)
    assert rank.rank == np.count_nonzero(singular > 1e-9 * singular[0]), f"seed {seed}"
    assert rank.is_exact, f"seed {seed}: {rank.how}"
    check_circuits(reference, rank)
    generic = generic_rank(system, seed)
    assert generic.rank >= rank.rank, f"seed {seed}"
    for dependence in dependences(reference, q, rank):
        n = len(dependence.rows)
        is_generic = Framework.of(system).rank(dependence.rows).rank < n
        assert dependence.kind == "generic" or not is_generic, f"seed {seed}"


@pytest.mark.parametrize("size", ["1e-9 m", "1 m", "1e12 m", "1e50 m"])
def test_freedoms_do_not_depend_on_the_unit_of_length(size: str) -> None:
    """A parallelogram moves with one freedom, of any size; a pinion in a guide across its rack with none."""
    with_bar = f"""
parameters: {{r: {size}}}
ground: {{points: {{A: [0, 0], D: [4*r, 0]}}}}
bodies:
  a: {{rod: {{length: r, mass: 1 kg}}, near: {{angle: 60 deg}}}}
  b: {{rod: {{length: 4*r, mass: 1 kg}}, near: {{angle: 0}}}}
  c: {{rod: {{length: r, mass: 1 kg}}, near: {{angle: 60 deg}}}}
connections:
  A: {{pin: [ground.A, a.start]}}
  B: {{pin: [a.end, b.start]}}
  C: {{pin: [b.end, c.end]}}
  D: {{pin: [ground.D, c.start]}}
measures: {{theta: angle of a}}
start: {{theta: 60 deg}}
questions: [degrees of freedom]
"""
    pinion = f"""
bodies: {{p: {{sphere: {{mass: 0.125 kg, radius: {size}}}}}}}
connections:
  teeth: {{rack_and_pinion: {{pinion: p, rack: ground, along: up}}}}
  guide: {{slider: {{body: p, along: up, on: ground}}}}
questions: [degrees of freedom]
"""
    for text, n in ((with_bar, 1), (pinion, 0)):
        (answer,) = fb.System.from_text(text).solve().answers
        assert answer.reason == ""
        assert answer.expression == number(n)
