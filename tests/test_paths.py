"""The motion of planar mechanisms along an input: limits, dead points, change points, assembly modes.

Every expected value is derived here from triangles.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from freebody.errors import CannotAnswer, InputError
from freebody.measures.base import Measure
from freebody.measures.geometry import position
from freebody.numeric.mobility.modes import AssemblyMode, assembly_modes
from freebody.numeric.mobility.path import MotionPath, singular_at, trace
from freebody.numeric.reference import Reference
from freebody.system.system import System


def rod(length: str) -> dict[str, Any]:
    return {"rod": {"mass": "1 kg", "length": length}}


def four_bar(a: float, b: float, c: float, d: float, theta: float | None = 1.0) -> System:
    """Crank a, coupler b, rocker c on the ground d."""
    return System.from_data(
        {
            "parameters": {"a": f"{a!r} m", "b": f"{b!r} m", "c": f"{c!r} m", "d": f"{d!r} m"},
            "ground": {"points": {"A": [0, 0], "D": ["d", 0]}},
            "bodies": {"crank": rod("a"), "coupler": rod("b"), "rocker": rod("c")},
            "connections": {
                "A": {"pin": ["ground.A", "crank.start"]},
                "B": {"pin": ["crank.end", "coupler.start"]},
                "C": {"pin": ["coupler.end", "rocker.end"]},
                "D": {"pin": ["ground.D", "rocker.start"]},
            },
            "measures": {"theta": "angle of crank", "psi": "angle of rocker"},
            "start": {} if theta is None else {"theta": f"{theta!r} rad"},
        }
    )


def slider_crank(r: float, rod_length: float, theta: float = 1.0) -> System:
    return System.from_data(
        {
            "parameters": {"r": f"{r!r} m", "l": f"{rod_length!r} m"},
            "ground": {"points": {"O": [0, 0]}, "lines": {"cylinder": {"along": "right"}}},
            "bodies": {"crank": rod("r"), "rod": rod("l"), "piston": {"particle": {"mass": "1 kg"}}},
            "connections": {
                "main": {"pin": ["ground.O", "crank.start"]},
                "crankpin": {"pin": ["crank.end", "rod.start"]},
                "wristpin": {"pin": ["rod.end", "piston"]},
                "cylinder": {"slider": {"body": "piston", "along": "cylinder"}},
            },
            "measures": {"theta": "angle of crank", "x": "x of piston"},
            "start": {"theta": f"{theta!r} rad"},
        }
    )


def parallelogram(*, with_third_bar: bool = False, with_motor: bool = False) -> System:
    connections: dict[str, Any] = {
        "A": {"pin": ["ground.A", "crank.start"]},
        "B": {"pin": ["crank.end", "coupler.start"]},
        "C": {"pin": ["coupler.end", "rocker.end"]},
        "D": {"pin": ["ground.D", "rocker.start"]},
    }
    bodies = {"crank": rod("a"), "coupler": rod("d"), "rocker": rod("a")}
    if with_third_bar:
        bodies["extra"] = rod("a")
        connections |= {
            "E": {"pin": ["ground.E", "extra.start"]},
            "F": {"pin": ["coupler.center", "extra.end"]},
        }
    if with_motor:
        connections["motor"] = {"driver": {"measure": "theta", "follows": "1 + w*t"}}
    return System.from_data(
        {
            "parameters": {"a": "0.2 m", "d": "0.5 m", "w": "1 rad/s"},
            "ground": {"points": {"A": [0, 0], "E": ["d/2", 0], "D": ["d", 0]}},
            "bodies": bodies,
            "connections": connections,
            "measures": {"theta": "angle of crank"},
            "start": {} if with_motor else {"theta": "1 rad"},
        }
    )


def watt() -> System:
    """Two four-bars in a row: the rocker of the first (D) carries the crank of the second."""
    lever = {"body": {"mass": "1 kg", "inertia": "1 kg m^2"}, "points": {"C": ["0.4 m", 0], "E": ["0.1 m", "0.3 m"]}}
    return System.from_data(
        {
            "ground": {"points": {"A": [0, 0], "D": ["0.5 m", 0], "G": ["1.1 m", "0.1 m"]}},
            "bodies": {
                "crank": rod("0.2 m"),
                "coupler": rod("0.5 m"),
                "lever": lever,
                "link": rod("0.6 m"),
                "flap": rod("0.5 m"),
            },
            "connections": {
                "A": {"pin": ["ground.A", "crank.start"]},
                "B": {"pin": ["crank.end", "coupler.start"]},
                "C": {"pin": ["coupler.end", "lever.C"]},
                "D": {"pin": ["ground.D", "lever"]},
                "E": {"pin": ["lever.E", "link.start"]},
                "F": {"pin": ["link.end", "flap.end"]},
                "G": {"pin": ["ground.G", "flap.start"]},
            },
            "measures": {"theta": "angle of crank"},
            "start": {"theta": "1 rad"},
        }
    )


def started(system: System) -> tuple[Reference, np.ndarray[Any, Any]]:
    reference = Reference(system)
    return reference, reference.assemble()


def path_of(system: System, by: str = "theta", *outputs: str, released: tuple[str, ...] = ()) -> MotionPath:
    reference, q = started(system)
    named: dict[str, Measure] = {name: system.measures[name] for name in outputs}
    return trace(reference, q, system.measures[by], released, outputs=named)


def modes_of(system: System, **fixed: float) -> list[AssemblyMode]:
    reference, q = started(system)
    return assembly_modes(reference, q, [(system.measures[name], value) for name, value in fixed.items()])


def turned(angle: float) -> float:
    """From 0 to 2 pi; just below a full turn counts as none."""
    rest = angle % math.tau
    return 0.0 if rest > math.tau - 1e-7 else rest


def angles(path: MotionPath, kind: Any) -> list[float]:
    return sorted(turned(point.input) for point in path.of_kind(kind))


def place(reference: Reference, q: Any, body: str, point: str) -> tuple[float, float]:
    at = position(reference.geometry(q, np.zeros_like(q), 0.0), reference.system.bodies[body].point(point))
    return at.x.value, at.y.value


def meet(p: complex, r: float, s: complex, rho: float, side: float) -> complex:
    """Where circles about p and s meet, to the left of the way from p to s for side 1."""
    d = abs(s - p)
    along = (d * d + r * r - rho * rho) / (2.0 * d)
    return p + (s - p) / d * complex(along, side * math.sqrt(r * r - along * along))


def law_of_cosines(a: float, b: float, c: float) -> float:
    """The angle between the sides a and b, opposite to c."""
    return math.acos((a * a + b * b - c * c) / (2.0 * a * b))


# -- limits and dead points -------------------------------------------------------------------
def test_a_crank_turns_fully_and_its_piston_rests_where_crank_and_rod_are_in_line() -> None:
    path = path_of(slider_crank(0.1, 0.3), "theta", "x")
    assert path.is_closed
    assert path.full_turn
    assert path.reach is None
    assert path.period == pytest.approx(math.tau, abs=1e-12)
    assert angles(path, "output dead point") == pytest.approx([0.0, math.pi], abs=1e-9)
    values = [point.value for point in path.points]
    assert sorted(value for value in values if value is not None) == pytest.approx([0.2, 0.4], abs=1e-12)
    assert not path.of_kind("dead point")
    assert not path.of_kind("change point")


def test_a_piston_that_drives_has_its_dead_points_at_both_ends() -> None:
    path = path_of(slider_crank(0.1, 0.3), "x")
    assert path.is_closed
    assert not path.full_turn
    assert path.period is None
    assert path.reach == pytest.approx((0.2, 0.4), abs=1e-12)
    assert [point.what for point in path.of_kind("dead point")] == ["upper limit of x", "lower limit of x"]
    for point in path.of_kind("dead point"):
        assert math.sin(point.q[2]) == pytest.approx(0.0, abs=1e-9)


def test_the_rocker_of_a_crank_rocker_turns_back_where_crank_and_coupler_are_in_line() -> None:
    a, b, c, d = 0.2, 0.5, 0.4, 0.5
    path = path_of(four_bar(a, b, c, d), "theta", "psi")
    # the triangle of ground, rocker and coupler plus or less the crank
    stretched, folded = law_of_cosines(d, b + a, c), law_of_cosines(d, b - a, c) + math.pi
    assert path.full_turn
    assert angles(path, "output dead point") == pytest.approx(sorted([stretched, folded]), abs=1e-9)
    extremes = sorted(math.pi - law_of_cosines(d, c, side) for side in (b - a, b + a))
    found = sorted(point.value for point in path.points if point.value is not None)
    assert np.mod(found, math.tau) == pytest.approx(extremes, abs=1e-9)


def test_the_crank_of_a_triple_rocker_stops_where_coupler_and_rocker_are_in_line() -> None:
    a, b, c, d = 0.4, 0.3, 0.3, 0.5
    path = path_of(four_bar(a, b, c, d), "theta")
    most = math.acos((a * a + d * d - (b + c) ** 2) / (2.0 * a * d))
    assert path.is_closed
    assert not path.full_turn
    assert path.reach == pytest.approx((-most, most), abs=1e-9)
    assert len(path.of_kind("dead point")) == 2


def test_a_crank_that_cannot_pass_the_ground_line_has_a_lower_limit() -> None:
    a, b, c, d = 0.4, 0.5, 0.3, 0.3
    path = path_of(four_bar(a, b, c, d), "theta")
    least = math.acos((a * a + d * d - (b - c) ** 2) / (2.0 * a * d))
    assert path.reach == pytest.approx((least, math.tau - least), abs=1e-9)


def test_a_scotch_yoke_moves_by_the_cosine_and_drives_up_to_its_crank_radius() -> None:
    system = System.from_data(
        {
            "ground": {"points": {"O": [0, 0]}},
            "bodies": {
                "crank": rod("0.1 m"),
                "yoke": {"rectangle": {"mass": "1 kg", "width": "0.1 m", "height": "0.3 m"}, "angle": 0},
            },
            "connections": {
                "O": {"pin": ["ground.O", "crank.start"]},
                "guide": {"slider": {"body": "yoke", "along": "right"}},
                "slot": {"slot": {"pin": "crank.end", "along": "up", "on": "yoke"}},
            },
            "measures": {"theta": "angle of crank", "x": "x of yoke"},
            "start": {"theta": "1 rad"},
        }
    )
    by_crank = path_of(system, "theta", "x")
    reference = Reference(system)
    xs = [reference.pose(q, "yoke")[0] for q in by_crank.poses]
    assert xs == pytest.approx(0.1 * np.cos(by_crank.inputs), abs=1e-12)
    assert angles(by_crank, "output dead point") == pytest.approx([0.0, math.pi], abs=1e-9)
    assert path_of(system, "x").reach == pytest.approx((-0.1, 0.1), abs=1e-12)


# -- change points ----------------------------------------------------------------------------
def test_a_parallelogram_has_its_change_points_where_it_is_flat() -> None:
    path = path_of(parallelogram())
    assert path.full_turn
    assert path.period == pytest.approx(math.tau, abs=1e-9)
    points = path.of_kind("change point")
    assert angles(path, "change point") == pytest.approx([0.0, math.pi], abs=1e-9)
    assert len(path.points) == 2
    for point in points:
        assert point.q[[2, 5, 8]] == pytest.approx(np.round(point.q[[2, 5, 8]] / math.pi) * math.pi, abs=1e-8)
        assert point.branch is not None


def test_at_a_change_point_the_other_branch_has_the_rates_of_the_antiparallelogram() -> None:
    # Flat, with f = cos(theta) = +-1: the coupler turns at f a (w3 - w1)/d, and the accelerations along the line,
    # f a w1^2 - f a w3^2 = -a^2 (w3 - w1)^2/d, leave w3 = w1 or w3/w1 = (a + f d)/(a - f d).
    a, d = 0.2, 0.5
    for point in path_of(parallelogram()).of_kind("change point"):
        assert point.branch is not None
        f = math.cos(point.input)
        assert point.branch[8] / point.branch[2] == pytest.approx((a + f * d) / (a - f * d), rel=1e-8)


def test_the_branch_of_a_flat_parallelogram_leads_onto_the_other_mode() -> None:
    system = parallelogram()
    reference, q = started(system)
    path = trace(reference, q, system.measures["theta"])
    point = path.of_kind("change point")[0]
    assert point.branch is not None
    unit = point.branch / np.abs(point.branch).max()
    gaps: list[float] = []
    for size in (1e-2, 1e-3):
        moved = point.q + size * unit
        g = reference.geometry(moved, np.zeros_like(moved), 0.0)
        gaps.append(max(abs(reference.gap(row, g).value) for row in system.constraint_rows))
    assert gaps[1] < 1.01e-2 * gaps[0]  # of the second order along a tangent
    there = reference.pose_near(point.q + 0.05 * unit)
    assert float(np.abs(there - point.q - 0.05 * unit).max()) < 0.01
    assert abs(reference.pose(there, "coupler")[2]) > 1e-3  # the coupler of a parallelogram would not turn


def test_a_third_parallel_bar_takes_the_second_branch_away_but_not_the_singular_poses() -> None:
    path = path_of(parallelogram(with_third_bar=True, with_motor=True), released=("motor",))
    assert path.full_turn
    assert angles(path, "change point") == pytest.approx([0.0, math.pi], abs=1e-9)
    for point in path.of_kind("change point"):
        # Points x of the coupler with the velocity v + omega x across: a (c + omega^2 x) = (v + omega x)^2 for three x
        # has no solution but omega = 0
        assert point.branch is None
    couplers = path.poses[:, 5]
    assert couplers == pytest.approx(np.full(len(couplers), couplers[0]), abs=1e-12)


def test_the_crank_of_a_kite_turns_twice_before_all_is_as_it_was() -> None:
    # d = a, c = b: with B on D, coupler and rocker are free to turn together, the crank at rest
    path = path_of(four_bar(0.3, 0.5, 0.5, 0.3))
    assert path.full_turn
    assert path.period == pytest.approx(2.0 * math.tau, abs=1e-9)
    assert angles(path, "change point") == pytest.approx([0.0, 0.0], abs=1e-9)
    for point in path.of_kind("change point"):
        assert point.branch is not None
        crank, coupler, rocker = point.branch[[2, 5, 8]]
        assert crank == pytest.approx(0.0, abs=1e-8 * abs(rocker))
        assert coupler == pytest.approx(rocker, rel=1e-6)


def test_a_crank_that_stands_still_is_no_input() -> None:
    system = four_bar(0.3, 0.5, 0.5, 0.3, theta=0.0)
    reference = Reference(system)
    # coupler and rocker upwards from B = D
    q = np.array([0.15, 0.0, 0.0, 0.3, 0.25, math.pi / 2, 0.3, 0.25, math.pi / 2])
    with pytest.raises(CannotAnswer, match="theta stays at"):
        trace(reference, q, system.measures["theta"])
    assert trace(reference, q, system.measures["psi"]).period == pytest.approx(math.tau)


def test_a_slider_crank_with_equal_lengths_changes_where_the_piston_is_on_the_crank_axis() -> None:
    path = path_of(slider_crank(0.1, 0.1), "theta", "x")
    assert angles(path, "change point") == pytest.approx([math.pi / 2, 3 * math.pi / 2], abs=1e-9)
    for point in path.of_kind("change point"):
        assert point.q[6] == pytest.approx(0.0, abs=1e-9)
        assert point.branch is not None
        # the other branch: rod and crank turn as one, the piston rests
        assert point.branch[6] == pytest.approx(0.0, abs=1e-8)
        assert point.branch[5] == pytest.approx(point.branch[2], rel=1e-6)
    assert path_of(slider_crank(0.1, 0.1), "x").reach == pytest.approx((-0.2, 0.2), abs=1e-12)


def test_lengths_that_nearly_make_a_kite_make_no_change_point() -> None:
    a, b, c, d = 0.3, 0.50001, 0.5, 0.3
    path = path_of(four_bar(a, b, c, d))
    least = law_of_cosines(a, d, b - c)
    assert not path.of_kind("change point")
    assert path.reach == pytest.approx((least, math.tau - least), abs=1e-9)


def test_two_loops_that_are_flat_together_are_found_though_the_determinant_keeps_its_sign() -> None:
    # two parallelograms with one crank: two singular values vanish at once
    system = System.from_data(
        {
            "ground": {"points": {"A": [0, 0], "D": ["0.5 m", 0], "E": ["0.3 m", 0]}},
            "bodies": {
                "crank": rod("0.2 m"),
                "coupler": rod("0.5 m"),
                "rocker": rod("0.2 m"),
                "short": rod("0.3 m"),
                "second": rod("0.2 m"),
            },
            "connections": {
                "A": {"pin": ["ground.A", "crank.start"]},
                "B": {"pin": ["crank.end", "coupler.start"]},
                "C": {"pin": ["coupler.end", "rocker.end"]},
                "D": {"pin": ["ground.D", "rocker.start"]},
                "F": {"pin": ["crank.end", "short.start"]},
                "G": {"pin": ["short.end", "second.end"]},
                "E": {"pin": ["ground.E", "second.start"]},
            },
            "measures": {"theta": "angle of crank"},
            "start": {"theta": "1 rad"},
        }
    )
    path = path_of(system)
    assert angles(path, "change point") == pytest.approx([0.0, math.pi], abs=1e-9)
    assert all("3 motions" in point.what for point in path.of_kind("change point"))


# -- starts, ends and refusals ----------------------------------------------------------------
def test_a_path_from_a_change_point_starts_beside_it_and_says_so() -> None:
    path = path_of(four_bar(0.2, 0.5, 0.2, 0.5, theta=0.0))
    assert "change point itself" in path.note
    assert angles(path, "change point") == pytest.approx([0.0, math.pi], abs=1e-9)


def test_every_pose_of_a_path_holds_what_is_held() -> None:
    system = watt()
    reference, q = started(system)
    path = trace(reference, q, system.measures["theta"])
    for pose in path.poses:
        g = reference.geometry(pose, np.zeros_like(pose), 0.0)
        assert max(abs(reference.gap(row, g).value) for row in system.constraint_rows) < 1e-11


def test_the_flap_of_a_six_bar_follows_from_two_triangles_after_each_other() -> None:
    system = watt()
    reference, q = started(system)
    path = trace(reference, q, system.measures["theta"])
    assert path.full_turn
    B, C, D, E, F, G = (
        complex(*place(reference, q, body, point))
        for body, point in [
            ("crank", "end"),
            ("coupler", "end"),
            ("ground", "D"),
            ("link", "start"),
            ("link", "end"),
            ("ground", "G"),
        ]
    )
    first = math.copysign(1.0, ((C - B) * (D - B).conjugate()).imag)
    second = math.copysign(1.0, ((F - E) * (G - E).conjugate()).imag)
    for pose, theta in zip(path.poses, path.inputs, strict=True):
        at_C = meet(0.2 * complex(math.cos(theta), math.sin(theta)), 0.5, D, 0.4, first)
        at_F = meet(D + (at_C - D) / 0.4 * complex(0.1, 0.3), 0.6, G, 0.5, second)
        assert complex(*place(reference, pose, "link", "end")) == pytest.approx(at_F, abs=1e-10)


def test_gears_are_as_they_were_after_as_many_turns_as_their_teeth_say() -> None:
    system = System.from_data(
        {
            "bodies": {
                "small": {"disk": {"mass": "1 kg", "radius": "0.2 m"}},
                "large": {"disk": {"mass": "1 kg", "radius": "0.3 m"}},
            },
            "ground": {"points": {"A": [0, 0], "B": ["0.5 m", 0]}},
            "connections": {
                "A": {"pin": ["ground.A", "small.center"]},
                "B": {"pin": ["ground.B", "large.center"]},
                "mesh": {"gear_mesh": ["small", "large"]},
            },
            "measures": {"theta": "angle of small"},
        }
    )
    assert path_of(system).period == pytest.approx(3.0 * math.tau)


def test_a_block_on_a_straight_guide_goes_beyond_every_bound() -> None:
    block = {"rectangle": {"mass": "1 kg", "width": "1 m", "height": "1 m"}}
    system = System.from_data(
        {
            "bodies": {"block": block},
            "connections": {"guide": {"slider": {"body": "block", "along": "right"}}},
            "measures": {"x": "x of block"},
        }
    )
    path = path_of(system, "x")
    assert path.is_unbounded
    assert not path.is_closed
    assert path.reach is None


def test_a_path_with_the_driver_left_in_says_that_nothing_moves() -> None:
    with pytest.raises(CannotAnswer, match=r"nothing moves\. Release the driver"):
        path_of(parallelogram(with_motor=True))


def test_a_path_with_two_freedoms_says_how_many_there_are() -> None:
    system = System.from_data(
        {
            "bodies": {"a": rod("1 m"), "b": rod("1 m")},
            "connections": {"p": {"pin": ["ground.O", "a.start"]}, "q": {"pin": ["a.end", "b.start"]}},
            "measures": {"theta": "angle of a"},
        }
    )
    with pytest.raises(CannotAnswer, match=r"there are 2 .*Hold 1 more"):
        path_of(system)
    with pytest.raises(CannotAnswer, match=r"keeps 1 freedom .*b"):
        modes_of(system, theta=0.0)


def test_bars_in_line_between_two_walls_move_only_infinitesimally() -> None:
    system = System.from_data(
        {
            "ground": {"points": {"A": [0, 0], "B": ["2 m", 0]}},
            "bodies": {"a": rod("1 m"), "b": rod("1 m")},
            "connections": {
                "p": {"pin": ["ground.A", "a.start"]},
                "q": {"pin": ["a.end", "b.start"]},
                "r": {"pin": ["b.end", "ground.B"]},
            },
            "measures": {"theta": "angle of a"},
        }
    )
    with pytest.raises(CannotAnswer, match="infinitesimal"):
        path_of(system)


def test_a_velocity_constraint_is_refused_by_name() -> None:
    system = System.from_data(
        {
            "bodies": {"blade": {"body": {"mass": "1 kg", "inertia": "1 kg m^2"}}},
            "connections": {
                "no_slip": {"velocity_constraint": "rate(y)*cos(theta) - rate(x)*sin(theta)"},
            },
            "measures": {"x": "x of blade", "y": "y of blade", "theta": "angle of blade"},
        }
    )
    with pytest.raises(CannotAnswer, match=r"no_slip\..* holds a velocity"):
        path_of(system, "x")
    with pytest.raises(CannotAnswer, match=r"no_slip\..* holds a velocity"):
        modes_of(system, x=0.0)


def test_a_misspelt_connection_to_release_is_an_input_error() -> None:
    with pytest.raises(InputError, match="Did you mean motor"):
        path_of(parallelogram(with_motor=True), released=("moter",))


def test_a_four_bar_takes_few_poses() -> None:
    reference, q = started(four_bar(0.2, 0.5, 0.4, 0.5))
    measures = reference.system.measures
    found = trace(reference, q, measures["theta"], outputs={"psi": measures["psi"]})
    assert len(found.inputs) < 400


# -- the pose itself --------------------------------------------------------------------------
def test_a_flat_parallelogram_is_singular_with_and_without_its_crank_held() -> None:
    flat, away = four_bar(0.2, 0.5, 0.2, 0.5, theta=0.0), four_bar(0.2, 0.5, 0.2, 0.5)
    for system, kinds in ((flat, ["dead point", "change point"]), (away, [])):
        reference, q = started(system)
        assert singular_at(reference, q, system.measures["theta"]) == kinds


def test_a_piston_at_the_end_of_its_stroke_is_at_a_dead_point_and_the_crank_is_not() -> None:
    system = slider_crank(0.1, 0.3, theta=0.0)
    reference, q = started(system)
    assert singular_at(reference, q, system.measures["x"]) == ["dead point"]
    assert singular_at(reference, q, system.measures["theta"]) == []


# -- assembly modes ---------------------------------------------------------------------------
def test_a_four_bar_has_an_open_and_a_crossed_mode() -> None:
    a, b, c, d, theta = 0.2, 0.5, 0.4, 0.5, 1.0
    system = four_bar(a, b, c, d)
    reference = Reference(system)
    modes = {mode.name: mode for mode in modes_of(system, theta=theta)}
    assert set(modes) == {"open", "crossed"}
    B = a * complex(math.cos(theta), math.sin(theta))
    for name, side in (("open", 1.0), ("crossed", -1.0)):
        C = meet(B, b, complex(d, 0.0), c, side)
        assert complex(*place(reference, modes[name].q, "coupler", "end")) == pytest.approx(C, abs=1e-10)
    assert modes["open"].signs["B"] == modes["open"].signs["C"] == -1  # convex, run clockwise
    assert modes["crossed"].signs["C"] == 1


def test_the_mode_of_the_given_pose_comes_first() -> None:
    system = four_bar(0.2, 0.5, 0.4, 0.5)
    reference = Reference(system)
    for mode in modes_of(system, theta=1.0):
        found = assembly_modes(reference, mode.q, [(system.measures["theta"], 1.0)])
        assert found[0].name == mode.name
        assert found[0].q == pytest.approx(mode.q, abs=1e-10)
        assert f"{found.n_starts} starts" in found.note


def test_a_slider_crank_has_its_piston_on_either_side() -> None:
    r, length, theta = 0.1, 0.3, 1.0
    modes = {mode.name: mode.q for mode in modes_of(slider_crank(r, length), theta=theta)}
    assert set(modes) == {"crankpin left", "crankpin right"}
    reach = math.sqrt(length**2 - (r * math.sin(theta)) ** 2)
    assert modes["crankpin right"][6] == pytest.approx(r * math.cos(theta) + reach, abs=1e-10)
    assert modes["crankpin left"][6] == pytest.approx(r * math.cos(theta) - reach, abs=1e-10)


def test_at_its_limit_the_two_modes_of_a_four_bar_are_one() -> None:
    a, b, c, d = 0.4, 0.3, 0.3, 0.5
    most = math.acos((a * a + d * d - (b + c) ** 2) / (2.0 * a * d))
    modes = modes_of(four_bar(a, b, c, d, theta=None), theta=most)
    assert len(modes) == 1


def test_a_watt_six_bar_has_the_modes_of_its_loops_together() -> None:
    system, theta = watt(), 1.0
    reference = Reference(system)
    modes = modes_of(system, theta=theta)
    D, G = 0.5 + 0.0j, 1.1 + 0.1j
    expected: list[complex] = []
    for first in (1.0, -1.0):
        C = meet(0.2 * complex(math.cos(theta), math.sin(theta)), 0.5, D, 0.4, first)
        E = D + (C - D) / 0.4 * complex(0.1, 0.3)
        if abs(0.6 - 0.5) < abs(G - E) < 0.6 + 0.5:
            expected += [meet(E, 0.6, G, 0.5, second) for second in (1.0, -1.0)]
    found = [complex(*place(reference, mode.q, "link", "end")) for mode in modes]
    assert len(found) == len(expected)
    assert all(min(abs(F - other) for other in found) < 1e-9 for F in expected)
    assert len({mode.name for mode in modes}) == len(modes)


def test_a_platform_on_three_bars_has_six_modes() -> None:
    # Expected: along the coupler curve of two of the bars, where the third corner has its distance from its pin.
    pins = (0.0, 1.0, 0.64 + 0.54j)
    corners = (0.0, 0.77, 0.27 + 0.8j)
    lengths = (0.73, 0.9, 0.9)
    phi = np.linspace(0.0, math.tau, 20001)
    P = lengths[0] * np.exp(1j * phi)
    expected = 0
    for side in (1.0, -1.0):
        away = pins[1] - P
        cosine = (np.abs(away) ** 2 + corners[1] ** 2 - lengths[1] ** 2) / (2.0 * np.abs(away) * corners[1])
        turn = away / np.abs(away) * (cosine + 1j * side * np.emath.sqrt(1.0 - cosine**2))
        gap = np.where(np.abs(cosine) <= 1.0, np.abs(P + turn * corners[2] - pins[2]) - lengths[2], np.nan)
        expected += int(np.count_nonzero(gap[1:] * gap[:-1] < 0.0))
    assert expected == 6
    system = System.from_data(
        {
            "ground": {"points": {f"G{k}": [f"{p.real} m", f"{p.imag} m"] for k, p in enumerate(map(complex, pins))}},
            "bodies": {
                "platform": {
                    "body": {"mass": "1 kg", "inertia": "1 kg m^2"},
                    "points": {f"P{k}": [f"{p.real} m", f"{p.imag} m"] for k, p in enumerate(map(complex, corners))},
                },
                **{f"bar{k}": rod(f"{length} m") for k, length in enumerate(lengths)},
            },
            "connections": {
                **{f"G{k}": {"pin": [f"ground.G{k}", f"bar{k}.start"]} for k in range(3)},
                **{f"P{k}": {"pin": [f"bar{k}.end", f"platform.P{k}"]} for k in range(3)},
            },
        }
    )
    modes = modes_of(system)
    assert len(modes) == 6
    assert len({mode.name for mode in modes}) == 6
