"""What is written in another order, or stands far away, changes nothing: not a bit more than round-off."""

from __future__ import annotations

import itertools
import random
import re
from pathlib import Path

import pytest

import freebody as fb
from freebody.numeric.engine.course import Status
from freebody.study.simulation.simulator import Simulator
from freebody.system.order import in_one_order
from freebody.testing import documents

EXAMPLES = Path(__file__).parent.parent / "examples"


# -- inertia lent to massless bodies --------------------------------------------------------------
def pulleys(far: str = "", heavy: float = 4.0, arm: float = 0.1) -> fb.System:
    """A compound Atwood machine with massless pulleys, and perhaps a body on a rail far away."""
    stranger = f"  far: {{particle: {{mass: 3 kg}}, at: [{far}, 0]}}\n" if far else ""
    rail = "  rail: {slider: {body: far, along: right, through: ground.F}}\n" if far else ""
    return fb.System.from_text(f"""
ground: {{points: {{O: [0, 0], F: [{far or "1 m"}, 0]}}}}
bodies:
  upper: {{disk: {{radius: {arm} m}}}}
  lower: {{disk: {{radius: {arm / 2} m}}}}
  A: {{particle: {{mass: {heavy} kg}}}}
  B: {{particle: {{mass: 2 kg}}}}
  C: {{particle: {{mass: 1 kg}}}}
{stranger}connections:
{rail}  axle: {{pin: [ground.O, upper]}}
  rope1: {{string: {{from: A, over: [upper], to: lower}}}}
  rope2: {{string: {{from: B, over: [lower], to: C}}}}
loads: {{weight: {{gravity: 9.81 m/s^2}}}}
measures: {{x1: drop of A below ground.O}}
""")


def acceleration(system: fb.System) -> float:
    """x1'' of the engine at the start."""
    names = [body.name for body in system.moving]
    return -float(system.simulate(1e-3).course.accelerations[0, names.index("A"), 1])


@pytest.mark.parametrize("heavy", [4.0, 1e-3, 1e5])
@pytest.mark.parametrize("far", ["", "100 m", "1e6 m"])
def test_massless_pulleys_take_nothing_of_what_the_engine_lends_them(far: str, heavy: float) -> None:
    # the lower pulley with B and C weighs as much as 4 m2 m3/(m2 + m3) = 8/3 kg
    expected = (heavy - 8 / 3) / (heavy + 8 / 3) * 9.81
    assert acceleration(pulleys(far, heavy)) == pytest.approx(expected, rel=2e-11)


def test_a_mass_close_to_the_pivot_of_a_long_massless_lever_moves_with_its_own_inertia() -> None:
    system = fb.System.from_text("""
bodies: {lever: {rod: {length: 1 m}, points: {near: [-0.499 m, 0]}}, m: {particle: {mass: 2 kg}}}
connections: {h: {pin: [ground.O, lever.start]}, fix: {pin: [lever.near, m]}}
loads: {push: {force: {at: lever.end, along: up, magnitude: 1e-3 N}}}
start: {th: 0}
measures: {th: angle of lever, x1: y of m}
""")
    simulator = Simulator(system)
    accelerations, _multipliers = simulator.engine.evaluate(simulator.start, 0.0)
    assert accelerations[0, 2] == pytest.approx(1e-3 * 1.0 / (2 * 1e-3**2), rel=1e-10)  # F L/(m r^2)


# -- several impacts at once ------------------------------------------------------------------------
def cradle(balls: str, contacts: str) -> fb.System:
    place = {"a": "-0.2 m", "b": "0", "c": "0.2 m"}  # the first hits two that touch
    listed = "\n".join(f"  {b}: {{disk: {{mass: 1 kg, radius: 0.1 m}}, at: [{place[b]}, 0]}}" for b in balls)
    listed = listed.replace("at: [-0.2 m, 0]", "at: [-0.2 m, 0], velocity: [1 m/s, 0]")
    joined = "\n".join(f"  {p}: {{contact: {{between: [{p[0]}, {p[1]}], restitution: 1}}}}" for p in contacts.split())
    return fb.System.from_text(f"bodies:\n{listed}\nconnections:\n{joined}\n")


def test_three_balls_that_touch_part_alike_in_every_order() -> None:
    """Newton's law for all contacts at once: u12' = -e u12, and b and c, which do not approach, are not torn apart."""
    for balls, contacts in itertools.product(("abc", "cba", "bca"), ("ab bc", "bc ab", "cb ba")):
        run = cradle(balls, contacts).simulate(0.1)
        assert run.status is Status.FINISHED
        speed = {body: float(run.course.velocities[-1, k, 0]) for k, body in enumerate(balls)}
        assert [speed[b] for b in "abc"] == pytest.approx([-1 / 3, 2 / 3, 2 / 3], abs=1e-12)


def rod_flat(order: str, ends: str = "start end", mu: float = 0.0, speed: float = 0.0) -> fb.System:
    joined = "\n".join(
        f"  {c}: {{contact: {{between: [rod.{e}, floor], restitution: 0.5, friction: {mu}}}}}"
        for c, e in sorted(zip("pq", ends.split(), strict=True), key=lambda pair: order.index(pair[0]))
    )
    return fb.System.from_text(f"""
ground: {{lines: {{floor: {{along: right}}}}}}
bodies: {{rod: {{rod: {{mass: 2 kg, length: 1 m}}, at: [0, 0.1 m], angle: 0, velocity: [{speed} m/s, 0]}}}}
connections:
{joined}
loads: {{weight: {{gravity: 9.81 m/s^2}}}}
""")


def test_a_rod_that_falls_flat_rebounds_alike_in_every_order() -> None:
    runs = [
        rod_flat(order, ends, 0.3, 0.2).simulate(0.3) for order in ("pq", "qp") for ends in ("start end", "end start")
    ]
    first = runs[0].course
    assert abs(float(first.velocities[-1, 0, 2])) < 1e-9  # both ends are hit at once: it does not turn
    for run in runs:
        assert run.status is Status.FINISHED
        assert re.sub(r"[pq]", "", run.message) == re.sub(r"[pq]", "", runs[0].message)
        assert run.course.poses[-1] == pytest.approx(first.poses[-1], abs=1e-11)
        assert run.course.velocities[-1] == pytest.approx(first.velocities[-1], abs=1e-10)


def painleve(order: str) -> fb.Simulation:
    """Two rods slide on their points, with so much friction that there is no consistent force for one of them."""
    rods = {
        "r": "at: {start: [0, 0]}, angle: 60 deg, velocity: [-4 m/s, 0]",
        "s": "at: {start: [5 m, 0]}, angle: 120 deg, velocity: [4 m/s, 0]",
    }
    bodies = "\n".join(f"  {b}: {{rod: {{mass: 1 kg, length: 1 m}}, {rods[b]}}}" for b in order)
    joined = "\n".join(f"  c{b}: {{contact: {{between: [{b}.start, floor], friction: 2}}}}" for b in order[::-1])
    return fb.System.from_text(f"""
ground: {{lines: {{floor: {{along: right}}}}}}
bodies:
{bodies}
connections:
{joined}
loads: {{weight: {{gravity: 9.81 m/s^2}}}}
""").simulate(0.05)


def test_painleves_rods_end_alike_in_every_order() -> None:
    one, other = painleve("rs"), painleve("sr")
    assert one.status is other.status is Status.INCONSISTENT
    assert one.message == other.message
    assert "Painleve" in one.message


# -- the symbolic route -----------------------------------------------------------------------------
def shuffled(system: fb.System, seed: int) -> fb.System:
    return fb.System.from_data(documents.shuffled(documents.prepared(system), random.Random(seed)))


@pytest.mark.parametrize(
    "name", ["double_pendulum", "four_bar", "parallelogram_with_extra_bar", "multi_bar_platform", "compound_atwood"]
)
def test_equations_of_motion_are_the_same_text_in_every_order(name: str) -> None:
    system = fb.System.load(EXAMPLES / f"{name}.yaml")
    told = {str(shuffled(system, seed).equations_of_motion()) for seed in range(3)}
    assert len(told) == 1


def test_bodies_are_walked_from_the_ground_along_the_linkage() -> None:
    bodies = ("  rocker: {rod: {mass: 1 kg, length: 3 m}}", "  coupler: {rod: {mass: 1 kg, length: 4 m}}")
    lines = (*bodies, "  crank: {rod: {mass: 1 kg, length: 1 m}}", "  b10: {particle: {}}", "  b2: {particle: {}}")
    for order in itertools.permutations(lines):
        system = fb.System.from_text(
            "ground: {points: {A: [0, 0], D: [4 m, 0]}}\nbodies:\n"
            + "\n".join(order)
            + """
connections:
  d: {pin: [ground.D, rocker.start]}
  c: {pin: [coupler.end, rocker.end]}
  b: {pin: [crank.end, coupler.start]}
  a: {pin: [ground.A, crank.start]}
"""
        )
        assert list(in_one_order(system).bodies) == ["ground", "crank", "coupler", "rocker", "b2", "b10"]


def test_a_pivot_that_vanishes_by_the_sine_of_a_bar_that_stays_level_is_none() -> None:
    """Three parallel bars: c sin(coupler) vanishes in all poses, though it is a single term; with the connections in
    this order it was divided by, and more speeds than there are were taken for bound."""
    system = fb.System.load(EXAMPLES / "parallelogram_with_extra_bar.yaml")
    data = documents.prepared(system)
    data["connections"] = dict(sorted(data["connections"].items()))
    assert fb.System.from_data(data).solve().degrees_of_freedom == 1


@pytest.mark.parametrize("seed", range(4))
def test_a_pulley_hangs_on_the_rope_that_carries_it_and_not_on_the_one_over_it(seed: int) -> None:
    held = {row.name for row in shuffled(pulleys(), seed).constraint_rows}
    assert {"rope1.lower hangs", "rope2.B hangs", "rope2.C hangs"} <= held


def test_contacts_among_all_are_the_same_pairs_in_every_order() -> None:
    bodies = [f"  {b}: {{disk: {{mass: 1 kg, radius: 0.1 m}}, at: [{k} m, 1 m]}}" for k, b in enumerate("acb")]
    lines = "{lines: {z: {along: right}, y: {through: [-3 m, 0], along: up}}}"
    rest = f"ground: {lines}\nconnections: {{c: {{contact: {{among: all}}}}}}\nbodies:\n"
    told = {
        tuple(bound.name for bound in fb.System.from_text(rest + "\n".join(order)).bounds)
        for order in itertools.permutations(bodies)
    }
    assert len(told) == 1


def test_what_is_assumed_of_nothing_is_the_same_in_every_order() -> None:
    """A disk and a hub that nobody places, in mesh: the pose that is found, and what turns freely in space."""
    plane = """
parameters: {k: 5 N/m^3}
bodies:
  p: {ring: {mass: 10 kg, radius: 0.125 m}, near: {at: [-1 m, 2 m]}}
  q: {particle: {mass: 0.5 kg}}
  r: {disk: {mass: 1 kg, radius: 0.5 m}}
measures: {u: drop of q below r}
connections:
  c1: {slot: {pin: q.center, along: right}}
  c2: {gear_mesh: {first: r, second: p}}
loads: {f0: {law: {measure: u, force: -k*u^3}}}
questions: [{find: u at start}]
"""
    space = """
space: true
bodies:
  p: {body: {mass: 10 kg, inertia: 0.5 kg m^2}, near: {at: [0.3 m, 0, 1 m]}}
  q: {cone: {radius: 2 m, height: 0.5 m, axis: 30 deg}, at: [0.3 m, 1 m, 0]}
connections: {c1: {prismatic: {first: q, second: p, along: q.x}}}
measures: {u: angle of p about p.x}
questions: [{find: velocity of q along y at start}]
"""
    for text in (plane, space):
        system = fb.System.from_text(text)
        told = set[object]()
        for seed in range(5):
            solution = shuffled(system, seed).solve()
            value = solution.answers[0].value
            told.add((solution.coordinates, solution.dependent, f"{value:.9g}"))
        assert len(told) == 1


# -- a second name for the same length ------------------------------------------------------------
def test_a_distance_beside_a_travel_keeps_the_sense_of_the_travel() -> None:
    """r'' = omega^2 r for a bead on a rod that turns, whichever side it is on; a distance cannot be negative."""
    text = (EXAMPLES / "bead_on_turning_rod.yaml").read_text()
    text = text.replace("measures:\n", "measures:\n  zz: distance from ground.origin to bead\n")
    found = fb.System.from_text(text).solve("acceleration of r").answers[0]
    assert found.evidence is not None, found.reason
    assert found.value == pytest.approx(9.0 * 0.2)


def test_a_measure_may_be_calculated_from_one_that_stands_below_it() -> None:
    model = """
bodies: {block: {particle: {mass: 1 kg}, at: [2 m, 0]}}
measures: {twice: {expression: 2*x}, x: x of block, more: {expression: twice + x}}
"""
    system = fb.System.from_text(model)
    assert [*system.measures] == ["twice", "x", "more"]
    assert system.solve("more at start")["q1"].value == 6.0
