"""The constraint doctor as a whole: counts, ranks, redundancy by name, singular poses, limits, modes."""

from __future__ import annotations

import copy
import functools
import json
import math
import random
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

import freebody as fb
from freebody.cli import commands
from freebody.errors import CannotAnswer, InputError, ModelError
from freebody.numeric.engine.engine import Engine
from freebody.numeric.mobility.rank import rank_at
from freebody.numeric.reference import Reference
from freebody.study.mobility.found import Mobility
from freebody.study.mobility.gruebler import gruebler
from freebody.study.mobility.mobility import mobility
from goldens import assert_golden
from mechanisms import ladder
from thinned import thinned

Within = Callable[[int, Callable[[], object]], None]
FOLDER = Path(__file__).parents[1] / "examples"
EXAMPLES = sorted(path.stem for path in FOLDER.glob("*.yaml"))


def examined(text: str, **options: object) -> Mobility:
    return mobility(fb.System.from_text(text), **options)  # type: ignore[arg-type]


def parallelogram(start: str = "60 deg", *, extra: str = "", third: str = "1 m", place: str = "[1 m, 0]") -> str:
    more = f"extra: {{rod: {{mass: 1 kg, length: {third}}}}}, " if extra else ""
    pins = "C: {pin: [ground.C, extra.start]}, M: {pin: [extra.end, coupler.center]}, " if extra else ""
    return f"""
ground: {{points: {{A: [0, 0], B: [2 m, 0], C: {place}}}}}
bodies: {{left: {{rod: {{mass: 1 kg, length: 1 m}}}}, right: {{rod: {{mass: 1 kg, length: 1 m}}}}, {more}
         coupler: {{rod: {{mass: 1 kg, length: 2 m}}}}}}
connections: {{A: {{pin: [ground.A, left.start]}}, B: {{pin: [ground.B, right.start]}}, {pins}
  D: {{pin: [left.end, coupler.start]}}, E: {{pin: [right.end, coupler.end]}}}}
measures: {{theta: angle of left}}
start: {{theta: {start}}}
"""


# -- the platform -----------------------------------------------------------------------------
def test_the_multi_bar_platform_has_fourteen_constraints_and_one_freedom() -> None:
    found = mobility(fb.System.load(FOLDER / "multi_bar_platform.yaml"))
    plain = found.to_plain()
    assert plain["gruebler"] == plain["gruebler"] | {"n": 3, "bodies": 5, "constraints": 14, "count": 1}
    assert (found.degrees_of_freedom, found.rank.rank, found.redundant) == (1, 14, ())
    assert found.kind is None
    (answer,) = plain["answers"]
    assert answer["choice"] == "b"
    assert {k: v["verdict"] for k, v in answer["options"].items() if k != "b"} == dict.fromkeys("acde", "wrong")
    assert "load" in answer["options"]["a"]["reason"]  # the spring, taken for a bar, gives 0


def test_the_platform_without_any_dimension_has_the_same_mobility() -> None:
    found = examined(
        """
ground: {points: [A, B, P, Q]}
bodies: {body: {body: {mass: 1 kg, inertia: 1 kg m^2}, points: [E, F, G, H]}, L1: rod, L2: rod, L3: rod, L4: rod}
connections:
  A: {pin: [ground.A, L1.start]}
  B: {pin: [ground.B, L2.start]}
  E: {pin: [L1.end, body.E]}
  H: {pin: [L2.end, body.H]}
  F: {pin: [body.F, L3.start]}
  G: {pin: [body.G, L4.start]}
  C: {slot: {pin: L3.end, along: up, through: ground.P}}
  D: {slot: {pin: L4.end, along: up, through: ground.Q}}
loads: {spring: {spring: {first: body.F, second: L3.end, stiffness: 5 N/m}}}
"""
    )
    assert found.basis == "topology"
    assert (found.gruebler.count, found.degrees_of_freedom, found.rank.rank) == (1, 1, 14)


def test_a_load_may_hang_anywhere_and_does_not_count() -> None:
    plain, loaded = (
        examined(parallelogram() + loads)
        for loads in ("", "loads: {s: {spring: {first: left.center, second: coupler, stiffness: 3 N/m}}}")
    )
    assert plain.degrees_of_freedom == loaded.degrees_of_freedom == 1
    assert loaded.gruebler.loads == ("s",)


# -- redundancy -------------------------------------------------------------------------------
def test_an_extra_parallel_bar_is_redundant_by_special_geometry() -> None:
    found = examined(parallelogram(extra="yes"))
    assert (found.gruebler.count, found.degrees_of_freedom) == (0, 1)
    assert found.kind == "special geometry"
    (rows,) = found.redundant
    assert {row.split(".")[0] for row in rows} == {"A", "B", "C", "D", "E", "M"}
    assert "equally long" in found.dependences[0].why
    assert "parallel" in found.dependences[0].why
    assert not found.is_singular
    assert set(found.indeterminate) == set(rows)


def test_a_longer_extra_bar_that_is_made_to_fit_leaves_a_rigid_structure() -> None:
    # at 60 deg the middle of the coupler is at (1.5, 0.866) m; a bar of 1.2 m to it from the ground
    x = 1.5 - math.sqrt(1.2**2 - 0.75)
    found = examined(parallelogram(extra="yes", third="1.2 m", place=f"[{x!r} m, 0]"))
    assert (found.degrees_of_freedom, found.rank.rank, found.redundant) == (0, 12, ())
    assert found.contradiction is None


def test_a_longer_extra_bar_that_does_not_fit_is_contradictory_and_not_redundant() -> None:
    found = examined(parallelogram(extra="yes", third="1.02 m"))
    assert found.contradiction is not None
    assert found.contradiction.is_geometric
    assert set(found.contradiction.names) == {"A", "B", "C", "D", "E", "M"}
    assert found.redundant == ()
    assert found.degrees_of_freedom == 0


def test_a_start_out_of_reach_names_the_start_and_is_examined_elsewhere() -> None:
    text = (FOLDER / "slider_crank.yaml").read_text()
    assert examined(text).contradiction is None
    text = """
ground: {points: {A: [0, 0], D: [5 m, 0]}}
bodies: {crank: {rod: {length: 2 m}}, coupler: {rod: {mass: 1 kg, length: 2 m}}, rocker: {rod: {length: 2 m}}}
connections: {A: {pin: [ground.A, crank.start]}, B: {pin: [crank.end, coupler.start]},
              C: {pin: [coupler.end, rocker.end]}, D: {pin: [ground.D, rocker.start]}}
measures: {theta: angle of crank}
start: {theta: 170 deg}
"""
    found = examined(text)
    assert found.contradiction is not None
    assert not found.contradiction.is_geometric
    assert "theta" in found.contradiction.names
    assert found.degrees_of_freedom == 1


def test_a_body_welded_twice_is_redundant_for_any_geometry() -> None:
    found = examined(
        "ground: {points: {A: [0, 0], B: [1 m, 0]}}\n"
        "bodies: {beam: {rod: {mass: 1 kg, length: 1 m}, at: {start: [0, 0]}, angle: 0}}\n"
        "connections: {w1: {weld: [ground.A, beam.start]}, w2: {weld: [ground.B, beam.end]}}"
    )
    assert (found.gruebler.count, found.degrees_of_freedom, found.rank.rank) == (-3, 0, 3)
    assert found.kind == "generic"
    assert len(found.redundant) == 3


def test_two_coaxial_sliders_leave_one_freedom() -> None:
    found = examined(
        "bodies: {block: {body: {mass: 1 kg, inertia: 1 kg m^2}, at: [0, 0], points: {P: [0.3 m, 0]}}}\n"
        "connections: {s1: {slider: {body: block, along: right}},"
        " s2: {slot: {pin: block.P, along: right}}, s3: {slider: {body: block, along: right}}}"
    )
    assert found.degrees_of_freedom == 1
    assert len(found.redundant) == 3
    assert {d.kind for d in found.dependences} == {"special geometry", "generic"}


def test_the_flat_parallelogram_is_a_bifurcation() -> None:
    found = examined(parallelogram("0"))
    assert (found.gruebler.count, found.degrees_of_freedom, found.nearby) == (1, 2, 1)
    assert found.kind == "momentary"
    assert found.is_singular

    assert "bifurcation" in found.to_text()


def test_a_triangle_truss_is_rigid_and_a_square_one_is_not() -> None:
    bars = "bodies: {a: {rod: {length: 1 m}}, b: {rod: {length: 1 m}}, c: {rod: {length: 1 m}}}\n"
    joints = (
        "ground: {points: {A: [0, 0], B: [1 m, 0]}}\n"
        "connections: {A: {pin: [ground.A, a.start]}, C: {pin: [a.end, b.end]},"
        " B: {slot: {pin: b.start, along: right, through: ground.B}},"
        " D: {pin: [c.start, a.start]}, E: {pin: [c.end, b.start]}}"
    )
    upright = bars.replace("a: {rod: {length: 1 m}}", "a: {rod: {length: 1 m}, near: {angle: 60 deg}}")
    assert examined(upright + joints).degrees_of_freedom == 0
    square = (
        "bodies: {a: {rod: {length: 1 m}}, b: {rod: {length: 1 m}}, c: {rod: {length: 1 m}}}\n"
        "ground: {points: {A: [0, 0], B: [1 m, 0]}}\n"
        "connections: {A: {pin: [ground.A, a.start]}, B: {pin: [ground.B, b.start]}, C: {pin: [a.end, c.start]},"
        " D: {pin: [b.end, c.end]}}\nmeasures: {phi: angle of a}\nstart: {phi: 80 deg}"
    )
    assert examined(square).degrees_of_freedom == 1


def test_a_particle_counts_two_and_an_unconnected_body_counts_fully() -> None:
    found = examined("bodies: {p: {particle: {mass: 1 kg}}, b: {disk: {mass: 1 kg, radius: 1 m}}}")
    assert (found.gruebler.count, found.degrees_of_freedom) == (5, 5)
    assert found.to_plain()["gruebler"]["particles"] == 1
    assert any("connected with nothing: p, b" in note for note in found.notes)


def test_symbols_without_values_keep_what_they_share() -> None:
    text = parallelogram(extra="yes").replace("length: 1 m", "length: L").replace("length: 2 m", "length: 2*c")
    text = text.replace("[2 m, 0]", "[2*c, 0]").replace("[1 m, 0]", "[c, 0]")
    text = "parameters: {L: m, c: m}\n" + text
    found = examined(text)
    assert found.basis == "symbols"
    assert (found.degrees_of_freedom, found.kind) == (1, "special geometry")


def test_what_moves_to_first_order_only_is_no_freedom() -> None:
    """Two bars in line between fixed pins give way across, and do not move; beside them a pendulum does."""
    text = """
ground: {points: {A: [0, 0], B: [2 m, 0], C: [0, 3 m]}}
bodies: {a: {rod: {mass: 1 kg, length: 1 m}, at: {start: [0, 0]}, angle: 0},
         b: {rod: {mass: 1 kg, length: 1 m}, at: {end: [2 m, 0]}, angle: 0}, p: {rod: {mass: 1 kg, length: 1 m}}}
connections: {A: {pin: [ground.A, a.start]}, M: {pin: [a.end, b.start]}, B: {pin: [ground.B, b.end]},
              C: {pin: [ground.C, p.start]}}
questions: [{id: q, find: degrees of freedom, options: {a: 0, b: one, c: two}}]
"""
    found = examined(text)
    assert (found.degrees_of_freedom, found.nearby, found.kind) == (2, 1, "momentary")
    assert found.to_plain()["answers"][0]["choice"] == "b"
    assert fb.solve(fb.System.from_text(text), "degrees of freedom").degrees_of_freedom == 1


def test_an_unknown_assembly_mode_is_refused_with_those_that_there_are() -> None:
    system = fb.System.load(FOLDER / "four_bar.yaml").with_mode("folded")
    with pytest.raises(CannotAnswer, match="open"):
        mobility(system)


def test_two_drivers_on_one_freedom_are_told_apart_from_redundant_joints() -> None:
    text = """
parameters: {w: 2 rad/s}
bodies: {wheel: {disk: {mass: 1 kg, radius: 1 m}}}
connections: {axle: {pin: [ground.O, wheel]}, m1: {driver: {measure: angle of wheel, follows: w*t}},
              m2: {driver: {measure: angle of wheel, follows: RATE*t}}}
"""
    wrong, right = (examined(text.replace("RATE", rate)) for rate in ("2*w", "w"))
    assert "m1, m2" in wrong.advice
    assert any("over-driven" in note for note in wrong.notes)
    assert not any("over-driven" in note for note in right.notes)


@pytest.mark.parametrize("numbers", ["0.2 m, 0.5 m, 0.4 m, 0.5 m", "2 m, 3 m, 4 m, 4.5 m"])
def test_a_four_bar_in_plain_numbers_takes_no_longer_than_one_in_symbols(numbers: str, within: Within) -> None:
    a, b, c, d = numbers.split(", ")
    system = fb.System.from_text(
        f"""
ground: {{points: {{A: [0, 0], D: [{d}, 0]}}}}
bodies: {{crank: {{rod: {{mass: 1 kg, length: {a}}}}}, coupler: {{rod: {{mass: 1 kg, length: {b}}}}},
         rocker: {{rod: {{mass: 1 kg, length: {c}}}}}}}
connections: {{A: {{pin: [ground.A, crank.start]}}, B: {{pin: [crank.end, coupler.start]}},
              C: {{pin: [coupler.end, rocker.end]}}, D: {{pin: [ground.D, rocker.start]}}}}
measures: {{theta: angle of crank}}
start: {{theta: 60 deg}}
"""
    )
    within(10_000_000, lambda: mobility(system).to_plain())


# -- what the pose is -------------------------------------------------------------------------
def test_a_slider_crank_driven_by_its_slider_has_dead_points_at_its_ends() -> None:
    text = """
bodies: {crank: {rod: {mass: 1 kg, length: 0.1 m}}, rod: {rod: {mass: 1 kg, length: 0.3 m}},
         piston: {particle: {mass: 1 kg}}}
connections: {O: {pin: [ground.O, crank.start]}, P: {pin: [crank.end, rod.start]}, Q: {pin: [rod.end, piston]},
              guide: {slider: {body: piston, along: right}}}
measures: {theta: angle of crank, x: x of piston}
start: {theta: 50 deg}
"""
    found = examined(text, along="x")
    assert found.motions is not None
    assert found.motions.path is not None
    assert found.motions.path.reach == pytest.approx((0.2, 0.4), abs=1e-9)
    turned = examined(text, along="theta")
    assert turned.motions is not None
    assert turned.motions.path is not None
    assert turned.motions.path.full_turn
    ends = [(math.degrees(p.input) % 360, p.value) for p in turned.motions.path.of_kind("output dead point")]
    assert sorted(round(v, 9) for _a, v in ends if v is not None) == pytest.approx([0.2, 0.4])
    assert sorted(round(a, 6) % 360 for a, _v in ends) == pytest.approx([0, 180], abs=1e-6)


def test_a_four_bar_driven_beyond_its_reach_has_the_limit_of_the_law_of_cosines() -> None:
    a, b, c, d = 2.0, 2.5, 2.4, 5.0
    text = f"""
ground: {{points: {{A: [0, 0], D: [{d} m, 0]}}}}
bodies: {{crank: {{rod: {{length: {a} m}}}}, coupler: {{rod: {{mass: 1 kg, length: {b} m}}}},
         rocker: {{rod: {{length: {c} m}}}}}}
connections: {{A: {{pin: [ground.A, crank.start]}}, B: {{pin: [crank.end, coupler.start]}},
              C: {{pin: [coupler.end, rocker.end]}}, D: {{pin: [ground.D, rocker.start]}},
              motor: {{driver: {{measure: theta, follows: w*t}}}}}}
parameters: {{w: 1 rad/s}}
measures: {{theta: angle of crank}}
"""
    found = examined(text, along="motor")
    assert found.degrees_of_freedom == 0
    assert found.motions is not None
    assert found.motions.path is not None
    limit = math.acos((a * a + d * d - (b + c) ** 2) / (2 * a * d))
    assert found.motions.path.reach == pytest.approx((-limit, limit), abs=1e-9)
    assert found.motions.linkages[0][1].case == "triple-rocker (non-Grashof)"
    # the simulation ends there, too
    run = fb.System.from_text(text).simulate(until=3)
    assert run.status.name == "UNREACHABLE" or "unreach" in str(run.status).lower()
    assert run.dataset.time.values[-1] == pytest.approx(limit, abs=1e-3)


def test_assembly_modes_of_a_four_bar_are_chosen_by_name() -> None:
    system = fb.System.load(FOLDER / "four_bar.yaml")
    found = mobility(system)
    assert found.motions is not None
    assert found.motions.modes is not None
    assert [m.name for m in found.motions.modes] == ["open", "crossed"]
    crossed = system.with_mode("crossed")
    q = Reference(crossed).assemble()
    np.testing.assert_allclose(q, found.motions.mode("crossed").q, atol=1e-9)
    assert fb.System.from_text(crossed.to_yaml()).mode == "crossed"
    run = crossed.simulate(until=0.01)
    np.testing.assert_allclose(run.dataset["theta"].values[0], math.radians(60), atol=1e-9)
    assert mobility(crossed).motions.modes[0].name == "crossed"  # type: ignore[union-attr,index]
    with pytest.raises(CannotAnswer, match=r"there is: open, crossed|there is: crossed, open"):
        Reference(system.with_mode("folded")).assemble()
    with pytest.raises(InputError, match="crossed"):
        found.motions.mode("crosed")


def test_closed_forms_hold_in_the_chosen_mode() -> None:
    """The rocker's ratio differs between the modes; each is checked by the other route."""
    system = fb.System.load(FOLDER / "four_bar.yaml")
    question = "ratio of angular velocity of rocker to angular velocity of crank"
    values = [fb.solve(s, question)["q1"].value for s in (system, system.with_mode("crossed"))]
    found = mobility(system)
    assert found.motions is not None
    ratio = next(r.value for r in found.motions.ratios if r.name == "rocker")
    assert values[0] == pytest.approx(ratio, abs=1e-9)
    assert values[1] != pytest.approx(values[0], abs=1e-3)


def test_velocity_ratios_and_centres_agree_with_the_closed_form() -> None:
    """omega_rocker/omega_crank = |A I|/|D I| with I the centre of crank and rocker (Kennedy)."""
    found = mobility(fb.System.load(FOLDER / "four_bar.yaml"))
    assert found.motions is not None
    centres = {c.pair: c.at for c in found.motions.centres}
    pole = centres["crank", "rocker"]
    assert pole is not None
    ratio = next(r.value for r in found.motions.ratios if r.name == "rocker")
    assert ratio == pytest.approx((pole[0] - 0.0) / (pole[0] - 0.5))


def test_a_driver_is_counted_and_can_be_thought_away() -> None:
    found = mobility(fb.System.load(FOLDER / "body_on_driven_roller.yaml"))
    assert found.degrees_of_freedom == 1
    assert found.gruebler.drivers == ("motor",)
    assert any("without motor: 2" in note for note in found.notes)


# -- examples ---------------------------------------------------------------------------------
@functools.cache
def of_example(name: str) -> Mobility:
    return mobility(fb.System.load(FOLDER / f"{name}.yaml"))


@pytest.mark.parametrize("name", EXAMPLES)
def test_the_mobility_of_an_example_is_the_golden_one(name: str) -> None:
    found = of_example(name)
    assert_golden("mobility", name, {"text": found.to_text().splitlines(), "json": found.to_plain()})


# -- against the engine -----------------------------------------------------------------------
@pytest.mark.parametrize("name", EXAMPLES)
def test_the_mobility_of_every_example_is_that_of_the_symbolic_route(name: str) -> None:
    found = of_example(name)
    system = found.system
    if not system.dry_friction:  # what sticks or slips is a case distinction there
        assert found.finite_freedom == fb.solve(system, "degrees of freedom").degrees_of_freedom
    assert len(found.independent_coordinates) == found.degrees_of_freedom
    json.dumps(found.to_plain())


def random_mechanism(seed: int, *, exact: bool) -> fb.System:
    """Bodies at random, joined by random pins, slots, links, welds and sliders, some of them twice. Exact ones stand at
    short decimals and right angles, so that all connections fit without round-off."""
    rng = random.Random(seed)
    n = rng.randint(2, 6)
    names = [f"b{k}" for k in range(n)]

    def place() -> float:
        return round(rng.uniform(-1, 1), 2) if exact else rng.uniform(-1, 1)

    turns = {name: rng.randint(-1, 2) if exact else rng.uniform(-2, 2) for name in names}
    pose = {name: (place(), place(), turns[name] * math.pi / 2) for name in names}
    points: dict[str, dict[str, list[str]]] = {name: {} for name in names}
    ground: dict[str, list[str]] = {"O": ["0 m", "0 m"]}

    def at(body: str, label: str, x: float, y: float) -> str:
        if body == "ground":
            ground[label] = [f"{x!r} m", f"{y!r} m"]
        else:
            px, py, angle = pose[body]
            c, s = math.cos(angle), math.sin(angle)
            u, v = c * (x - px) + s * (y - py), -s * (x - px) + c * (y - py)
            if exact:
                u, v = round(u, 2), round(v, 2)
            points[body][label] = [f"{u!r} m", f"{v!r} m"]
        return f"{body}.{label}"

    connections: dict[str, dict[str, object]] = {}
    for k in range(rng.randint(n - 1, 2 * n)):
        first, second = sorted(rng.sample(["ground", *names], 2), key=lambda name: name != "ground")
        x, y = place(), place()
        kind = rng.choice(["pin", "pin", "pin", "link", "slot", "slider", "weld"])
        for again in range(2 if rng.random() < 0.15 else 1):
            label = f"p{k}_{again}"
            one = at(first, f"p{k}", x, y)
            if kind == "link":
                value: dict[str, object] = {"link": [one, at(second, f"q{k}", x + 0.3, y + 0.4)]}
            elif kind == "slot":
                value = {"slot": {"pin": at(second, f"p{k}", x, y), "along": 0.3 * k, "on": first, "through": one}}
            elif kind == "slider":
                through = at(first, f"s{k}", *pose[second][:2])  # where the reference point of the sliding body is
                value = {"slider": {"body": second, "along": 0.3 * k, "on": first, "through": through}}
            else:
                value = {kind: [one, at(second, f"p{k}", x, y)]}
            connections[label] = value
    bodies = {
        name: {
            "body": {"mass": f"{1 + k} kg", "inertia": f"{0.3 + 0.1 * k} kg m^2"},
            "points": points[name],
            "at": [f"{x!r} m" for x in pose[name][:2]],
            "angle": f"{90 * turns[name]!r} deg",
        }
        for k, name in enumerate(names)
    }
    return fb.System.from_data({"ground": {"points": ground}, "bodies": bodies, "connections": connections})


def small_motions(system: fb.System) -> int:
    """Independent small motions by the engine: the rank of its accelerations from rest under unit forces and torques on
    all bodies, one at a time."""
    data = copy.deepcopy(system.document.data)
    names = [body.name for body in system.moving]
    data["parameters"] = {f"{f}_{b}": {"value": f"0 {u}", "sign": "any"} for b in names for f, u in _PUSHES.items()}
    data["loads"] = {}
    for b in names:
        data["loads"] |= {
            f"x_{b}": {"force": {"at": f"{b}.mass_center", "along": "right", "magnitude": f"x_{b}"}},
            f"y_{b}": {"force": {"at": f"{b}.mass_center", "along": "up", "magnitude": f"y_{b}"}},
            f"m_{b}": {"torque": {"on": b, "magnitude": f"m_{b}"}},
        }
    loaded = fb.System.from_data(data)
    responses: list[np.ndarray] = []
    start = Reference(loaded)
    q = start.assemble()
    for name in loaded.parameters:
        reference = Reference(loaded, {name: 1.0})
        reference.count_from(start, q)  # loads move nothing at the start
        engine = Engine(reference.numbers())
        accelerations, _multipliers = engine.evaluate(engine.state(*reference.by_body(q, np.zeros_like(q))), 0.0)
        responses.append(reference.by_column(accelerations).copy())
    return int(np.linalg.matrix_rank(np.array(responses), tol=1e-7))


_PUSHES = {"x": "N", "y": "N", "m": "N m"}


@pytest.mark.parametrize("seed", thinned(range(40), lambda seed: seed < 12))
@pytest.mark.parametrize("exact", [True, False])
def test_the_rank_of_random_mechanisms_leaves_as_many_motions_as_the_engine_finds(seed: int, exact: bool) -> None:
    system = random_mechanism(seed, exact=exact)
    reference = Reference(system)
    rank = rank_at(reference, reference.assemble())
    assert rank.is_exact or not exact
    assert rank.n_freedoms == small_motions(system)
    assert gruebler(system).count == rank.n_freedoms - len(rank.circuits)
    if seed < 4:
        found = mobility(system)
        assert found.degrees_of_freedom == rank.n_freedoms
        assert len(found.redundant) == len(rank.circuits)


# -- speed ------------------------------------------------------------------------------------
def test_a_linkage_of_two_hundred_bars_takes_three_million_calls(within: Within) -> None:
    system = ladder(100)
    assert len(system.moving) >= 200
    found: list[fb.Mobility] = []
    within(3_000_000, lambda: found.append(mobility(system)))
    assert found[0].gruebler.count == found[0].degrees_of_freedom


# -- bad input --------------------------------------------------------------------------------
def test_a_connection_of_a_body_with_itself_is_refused() -> None:
    with pytest.raises(ModelError, match=r"itself|both on|two bodies"):
        fb.System.from_text("bodies: {a: {rod: {length: 1 m}}}\nconnections: {p: {pin: [a.start, a.end]}}")


def test_an_unknown_input_is_refused_with_a_suggestion() -> None:
    with pytest.raises(InputError, match="theta"):
        mobility(fb.System.load(FOLDER / "four_bar.yaml"), along="thetta")


def test_an_option_that_is_no_number_is_told() -> None:
    text = parallelogram() + "questions: [{id: q, find: degrees of freedom, options: {a: 1, b: few, c: 2.5, d: -1}}]"
    answer = examined(text).to_plain()["answers"][0]
    assert {k: v["verdict"] for k, v in answer["options"].items()} == {
        "a": "right",
        "b": "unreadable",
        "c": "wrong",
        "d": "wrong",
    }


# -- the command ------------------------------------------------------------------------------
def test_the_command_prints_the_documented_json() -> None:
    result = CliRunner().invoke(commands(), ["mobility", str(FOLDER / "multi_bar_platform.yaml"), "--json"])
    assert result.exit_code == 0
    plain = json.loads(result.stdout)
    wanted = {"degrees_of_freedom", "gruebler", "rank", "redundant", "kind", "singular", "idle", "answers"}
    assert wanted | {"independent_coordinates"} <= plain.keys()


def test_the_command_reports_in_words() -> None:
    result = CliRunner().invoke(commands(), ["mobility", str(FOLDER / "four_bar.yaml"), "--along", "theta"])
    assert result.exit_code == 0
    for words in ("DOF = n L - K = 3*3 - 8 = 1", "crank-rocker", "turns fully", "open", "crossed"):
        assert words in result.stdout


@pytest.mark.parametrize("more", ["", ", leaves: false"])
def test_a_pin_on_a_curve_leaves_nothing_for_its_rail_to_hold(more: str) -> None:
    """Wherever the pin is on the curve: the foot follows the point, and holds nothing."""
    system = fb.System.from_text(
        f"""
parameters: {{A: 2 m}}
bodies: {{p: {{disk: {{mass: 2 kg, radius: 0.5 m}}}}}}
connections:
  c: {{pin: {{first: p.center, second: ground.O}}}}
  track: {{clothoid: {{point: p, scale: A{more}}}}}
"""
    )
    (found,) = system.mobility().dependences
    assert found.kind == "generic"
