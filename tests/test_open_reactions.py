"""Dry friction pressed by reactions that rigid bodies leave open: one rule shares them, and the result says so."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import freebody as fb
from freebody.numeric.engine.course import Status

LENGTHS = {"left": (2, 0.5), "right": (3, 0.5), "middle": (1, 0.5), "coupler": (2, 0.8)}
PINS = {
    "A": ("ground.A", "left.start", 0.3),
    "B": ("ground.B", "right.start", 0.3),
    "C": ("ground.C", "middle.start", 0.2),
    "D": ("left.end", "coupler.start", 0.0),
    "E": ("right.end", "coupler.end", 0.0),
    "M": ("middle.end", "coupler.center", 0.0),
}


def parallelogram(order: str = "ABCDEM", bodies: str = "left right middle coupler", turned: float = 0.0) -> fb.System:
    """Three parallel bars under a coupler, with journals that rub on the ground; the whole turned by an angle."""

    def place(x: float) -> str:
        return f"[{x * math.cos(turned)!r} m, {x * math.sin(turned)!r} m]"

    def pin(name: str) -> str:
        first, second, mu = PINS[name]
        dry_friction = f", friction: {mu}, radius: 0.05 m" if mu else ""
        return f"  {name}: {{pin: {{first: {first}, second: {second}{dry_friction}}}}}"

    listed = "\n".join(
        f"  {b}: {{rod: {{mass: {LENGTHS[b][0]} kg, length: {LENGTHS[b][1]} m}}}}" for b in bodies.split()
    )
    joined = "\n".join(map(pin, order))
    along = f"{turned - math.pi / 2!r} rad"
    return fb.System.from_text(f"""
ground: {{points: {{A: [0, 0], B: {place(0.8)}, C: {place(0.4)}}}}}
bodies:
{listed}
connections:
{joined}
loads:
  w1: {{force: {{at: left, along: {along}, magnitude: 19.62 N}}}}
  w2: {{force: {{at: right, along: {along}, magnitude: 29.43 N}}}}
  w3: {{force: {{at: middle, along: {along}, magnitude: 9.81 N}}}}
  w4: {{force: {{at: coupler, along: {along}, magnitude: 19.62 N}}}}
measures: {{theta: {{angle of left}}}}
start: {{theta: {math.radians(60) + turned!r} rad, rate(theta): 3 rad/s}}
""")


def final(system: fb.System) -> float:
    result = system.simulate(0.2)
    assert result.status is Status.FINISHED
    return float(result.series["theta"][0][-1])


@pytest.fixture(scope="module")
def plain() -> fb.Simulation:
    return parallelogram().simulate(0.2)


@pytest.mark.parametrize(
    ("order", "bodies"),
    [
        ("MEDCBA", "left right middle coupler"),
        ("CAMEBD", "coupler middle right left"),
        ("BACDME", "middle left coupler right"),
    ],
)
def test_the_order_of_connections_and_bodies_does_not_change_the_motion(
    plain: fb.Simulation, order: str, bodies: str
) -> None:
    assert final(parallelogram(order, bodies)) == pytest.approx(float(plain.series["theta"][0][-1]), abs=1e-11)


def test_a_turned_linkage_moves_alike(plain: fb.Simulation) -> None:
    turned = 0.7
    assert final(parallelogram(turned=turned)) - turned == pytest.approx(float(plain.series["theta"][0][-1]), abs=1e-9)


def test_the_result_says_that_reactions_were_shared(plain: fb.Simulation) -> None:
    assert "dry friction of A, B, C are not unique" in plain.message
    assert "as if all joints yielded alike" in plain.message
    assert math.isnan(float(plain.dataset["A.x"].values[0]))  # and none is printed as if it were the only one


def test_the_shared_reactions_are_the_least_that_balance(plain: fb.Simulation) -> None:
    """Of all forces of the pins with the same effect those with the least sum of squares: orthogonal to every set of
    forces that does nothing. A bar's pins may pull at it lengthwise against those of the others: such a set."""
    rows = {row.name: k for k, row in enumerate(plain.rows)}
    forces = plain.course.multipliers[0]
    nothing = np.zeros(len(forces))
    # along the bars at 60 deg: left and right push the coupler up by 1 each, middle holds it down by 2
    for bar, low, high, size in (("left", "A", "D", 1.0), ("right", "B", "E", 1.0), ("middle", "C", "M", -2.0)):
        del bar
        for axis, c in (("x", math.cos(math.radians(60))), ("y", math.sin(math.radians(60)))):
            nothing[rows[f"{low}.{axis}"]] = size * c
            nothing[rows[f"{high}.{axis}"]] = size * c
    assert abs(forces @ nothing) < 1e-7 * np.linalg.norm(forces) * np.linalg.norm(nothing)


# -- supports of different roughness ------------------------------------------------------------
SUPPORTS = {"p": (-0.5, 0.1), "q": (0.1, 0.3), "r": (0.6, 0.5)}


def plank(order: str, coefficients: dict[str, float]) -> fb.Simulation:
    joined = "\n".join(
        f"  {name}: {{contact: {{between: [plank, ground.{name}], friction: {coefficients[name]}}}}}" for name in order
    )
    return fb.System.from_text(f"""
ground: {{points: {{p: [-0.5 m, 0], q: [0.1 m, 0], r: [0.6 m, 0]}}}}
bodies: {{plank: {{rod: {{mass: 3 kg, length: 3 m}}, at: [0, 0], angle: 0, velocity: [2 m/s, 0]}}}}
connections:
{joined}
loads: {{weight: {{gravity: 9.81 m/s^2}}}}
""").simulate(0.1)


def test_a_plank_on_three_posts_of_different_roughness_slides_alike_in_every_order() -> None:
    rough = {name: mu for name, (_x, mu) in SUPPORTS.items()}
    runs = [plank(order, rough) for order in ("pqr", "rqp", "qpr")]
    assert all("p, q, r are not unique" in run.message for run in runs)
    first = runs[0].course.poses[-1, 0]
    # the least forces that carry the weight W about the centre: N_i = a + b x_i with sum N = W, sum N x = 0
    x = np.array([place for place, _mu in SUPPORTS.values()])
    a, b = np.linalg.solve([[3.0, x.sum()], [x.sum(), (x * x).sum()]], [3 * 9.81, 0.0])
    deceleration = float((a + b * x) @ list(rough.values())) / 3
    assert runs[0].course.accelerations[0, 0, 0] == pytest.approx(-deceleration, rel=1e-9)
    for run in runs[1:]:
        assert run.course.poses[-1, 0] == pytest.approx(first, abs=1e-11)


def test_posts_of_one_roughness_brake_alike_however_the_weight_is_shared() -> None:
    run = plank("qrp", dict.fromkeys(SUPPORTS, 0.3))
    assert run.message == ""
    assert run.course.velocities[-1, 0, 0] == pytest.approx(2 - 0.3 * 9.81 * 0.1)


def test_a_load_that_a_wedge_holds_rests_in_one_phase() -> None:
    """What sticks with one admissible distribution of its forces sticks, though others would let it slip."""
    system = fb.System.load(Path(__file__).parents[1] / "examples" / "wedge_under_load.yaml")
    result = system.simulate(1.0, tolerance=1e-11)
    assert result.course.contact is not None
    assert result.course.contact.n_phases == 1
    assert result.events == ()
    assert np.abs(result.course.velocities).max() < 1e-12


def heavy_end(order: str) -> fb.Simulation:
    """The plank with its mass centre beyond the middle post: the least forces would have the first one pull."""
    joined = "\n".join(
        f"  {name}: {{contact: {{between: [plank, ground.{name}], friction: {SUPPORTS[name][1]}}}}}" for name in order
    )
    return fb.System.from_text(f"""
ground: {{points: {{p: [-0.5 m, 0], q: [0.1 m, 0], r: [0.6 m, 0]}}}}
bodies: {{plank: {{rod: {{mass: 3 kg, length: 3 m}}, at: [0.55 m, 0], angle: 0, velocity: [2 m/s, 0]}}}}
connections:
{joined}
loads: {{weight: {{gravity: 9.81 m/s^2}}}}
""").simulate(0.001)


def test_a_post_that_would_have_to_pull_carries_nothing_in_any_order() -> None:
    # of all N >= 0 with sum N = W, sum N x = 0.55 m W those with the least squares: p nothing, q W/10, r 9 W/10
    runs = [heavy_end(order) for order in ("pqr", "rqp", "qrp")]
    for run in runs:
        assert "carries nothing" in run.message
        assert run.course.accelerations[0, 0, 0] == pytest.approx(-(0.1 * 0.3 + 0.9 * 0.5) * 9.81, rel=1e-9)
