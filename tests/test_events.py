"""Events: every crossing and touch of what is watched is found, however long the steps are.

Expected times are those of uniform rotation: a point at the angle theta_0 + w t crosses or touches where its sine does.
"""

from __future__ import annotations

import math
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.special import ellipk

import freebody as fb
from freebody.language.parser import parse
from freebody.language.units import DIMENSIONLESS
from freebody.measures.combination import Composed
from freebody.numeric.engine import search
from freebody.numeric.engine.course import Status, Trajectory
from freebody.numeric.engine.engine import Engine
from freebody.numeric.engine.evaluator import EngineWatch
from freebody.numeric.engine.integrators import integrators
from freebody.numeric.options import SimulationOptions
from freebody.numeric.reference import Reference
from freebody.study.simulation.simulator import Simulator

WHEEL = """
parameters: {R: 0.5 m, v: 10 m/s}
ground: {lines: {road: {along: right}}}
bodies:
  wheel: {body: {mass: 2 kg, inertia: 0.25 kg m^2, radius: R}, points: {P: [R, 0]}}
connections: {contact: {rolling: {body: wheel, on: road}}}
measures: {s: travel of wheel along road, h: height of wheel.P}
start: {s: 0, rate(s): v}
"""
ROD = """
ground: {points: {O: [0, 0], C: [1 m, 0]}}
bodies:
  rod: {body: {mass: 2 kg, inertia: 0.3 kg m^2}, points: {P: [1 m, 0]}}
connections: {pin: {pin: [ground.O, rod]}}
measures:
  theta: angle of rod from right
  h: y of rod.P
  u: angle of line from ground.O to rod.P
  d: distance from ground.C to rod.P
start: {theta: 0.1 rad, rate(theta): 1 rad/s}
"""
IN_SPACE = """
space: {up: z}
ground: {points: {O: [0, 0, 0], C: [0, 1 m, 0]}}
bodies:
  rotor: {body: {mass: 2 kg, inertia: [0.2 kg m^2, 0.3 kg m^2, 0.4 kg m^2]}, points: {P: [0, 1 m, 0]}}
connections: {hinge: {revolute: [ground.O, rotor, z]}}
measures:
  theta: angle of rotor about z
  h: y of rotor.P
  d: distance from ground.C to rotor.P
start: {theta: 0.1 rad, rate(theta): 1 rad/s}
"""
EXAMPLES = Path(__file__).parents[1] / "examples"
METHODS = integrators()


@cache
def model(text: str) -> fb.System:
    return fb.System.from_text(text)


def times_of(result: fb.Simulation, kind: str = "") -> list[float]:
    assert (np.diff(result.course.times) > 0.0).all()
    return [e.time for e in result.events if e.kind not in ("start", "zero") and kind in ("", e.kind)]


def simulated(text: str, until: float, event: str, method: str = "dop853", tolerance: float = 1e-9) -> fb.Simulation:
    step = until / 500.0 if method == "rk4" else None
    return model(text).simulate(until, events=[event], method=method, tolerance=tolerance, step=step)


# -- however long the steps --------------------------------------------------------------------
@pytest.mark.parametrize("tolerance", [1e-4, 1e-9, 1e-12])
@pytest.mark.parametrize("method", METHODS)
def test_a_rim_point_passes_the_height_of_the_axle_twice_a_turn(method: str, tolerance: float) -> None:
    # the wheel turns by 10/0.5 * 10 = 200 rad; the point is at the height of the axle where it has turned by k pi
    found = times_of(simulated(WHEEL, 10.0, "h = R", method, tolerance))
    assert len(found) == 63 == math.floor(200.0 / math.pi)
    assert found == pytest.approx([k * math.pi / 20.0 for k in range(1, 64)], rel=1e-12)


def test_a_rod_that_turns_for_a_thousand_seconds_crosses_318_times() -> None:
    found = times_of(simulated(ROD, 999.9, "h = 0"))
    assert len(found) == 318 == math.floor(1000.0 / math.pi)
    assert found == pytest.approx([k * math.pi - 0.1 for k in range(1, 319)], rel=1e-12)


@pytest.mark.parametrize("method", METHODS)
def test_every_touch_of_the_highest_point_is_found(method: str) -> None:
    result = simulated(ROD, 100.0, "h = 1 m", method)
    assert {e.kind for e in result.events} == {"touch"}
    expected = [math.pi / 2 + 2 * math.pi * k - 0.1 for k in range(16)]
    assert times_of(result) == pytest.approx(expected, rel=1e-9)


def test_a_distance_that_comes_to_nothing_is_a_touch_once_a_turn() -> None:
    found = times_of(simulated(ROD, 100.0, "d = 0"), "touch")
    assert found == pytest.approx([2 * math.pi * k - 0.1 for k in range(1, 16)], rel=1e-8)


@pytest.mark.parametrize("method", METHODS)
def test_the_rate_of_a_height_vanishes_twice_a_turn(method: str) -> None:
    found = times_of(simulated(ROD, 100.0, "rate(h) = 0", method))
    assert found == pytest.approx([math.pi / 2 + math.pi * k - 0.1 for k in range(32)], rel=1e-11)


def test_the_angle_of_a_line_is_counted_on_through_a_long_step() -> None:
    result = simulated(ROD, 1000.0, "u = 600 rad")
    assert result.course.n_steps < 20  # more than a hundred radians each
    assert times_of(result) == pytest.approx([599.9], rel=1e-12)
    for found in (result, model(ROD).simulate(1000.0)):  # looked back upon in batches where no event asks for it
        theta, along = (found.series[name][0] for name in ("theta", "u"))
        assert np.abs(along - theta).max() < 1e-9


@pytest.mark.parametrize("tolerance", [1e-4, 1e-12])
def test_crossings_in_space_are_all_found(tolerance: float) -> None:
    # h = cos(0.1 + t)
    found = times_of(simulated(IN_SPACE, 50.0, "h = 0", tolerance=tolerance))
    expected = [math.pi / 2 + math.pi * k - 0.1 for k in range(16) if math.pi / 2 + math.pi * k < 50.1]
    assert found == pytest.approx(expected, rel=10.0 * tolerance + 1e-11)


def test_an_angle_in_space_is_counted_on_and_its_distance_touches_zero() -> None:
    assert times_of(simulated(IN_SPACE, 50.0, "theta = 45 rad")) == pytest.approx([44.9], rel=1e-9)
    touches = times_of(simulated(IN_SPACE, 50.0, "d = 0"), "touch")
    assert touches == pytest.approx([2 * math.pi * k - 0.1 for k in range(1, 8)], rel=1e-6)


def test_events_where_steps_end_are_neither_doubled_nor_lost() -> None:
    text = ROD.replace("theta: 0.1 rad", "theta: 0")
    for event, first, n in (("h = 0", math.pi, 10), ("h = 1 m", math.pi / 2, 5), ("rate(h) = 0", math.pi / 2, 10)):
        result = model(text).simulate(10.2 * math.pi, events=[event], method="rk4", step=math.pi / 4)
        apart = 2.0 * math.pi if event == "h = 1 m" else math.pi
        found = times_of(result)
        assert len(found) == len(set(found))
        assert found[:n] == pytest.approx([first + apart * k for k in range(n)], abs=1e-12)


# -- expressions ---------------------------------------------------------------------------------
@cache
def rod() -> Simulator:
    return Simulator(model(ROD))


def course_of(text: str, until: float, **options: Any) -> Trajectory:
    """Of an expression in theta = 0.1 + t."""
    simulator = rod()
    measure = Composed(parse(text), (("theta", simulator.system.measures["theta"]),), DIMENSIONLESS)
    engine = Engine(simulator.numbers, [EngineWatch("it", measure)])
    y = simulator.start.copy()
    engine.align(y, 0.0, simulator.value_at_start)
    return engine.run(y, until, SimulationOptions(**{"method": "dop853"} | options))


def found_of(text: str, until: float) -> list[tuple[float, str]]:
    return [(e.time + 0.1, e.kind) for e in course_of(text, until).events]


@pytest.mark.parametrize("tolerance", [1e-4, 1e-6, 1e-9, 1e-12])
@pytest.mark.parametrize("method", METHODS)
def test_all_roots_of_sin_3x_equal_to_cos_x_are_found(method: str, tolerance: float) -> None:
    # 3 x = pi/2 - x + 2 n pi, or 3 x = pi/2 + x + 2 n pi
    roots = [math.pi / 8 + n * math.pi / 2 for n in range(64)] + [math.pi / 4 + n * math.pi for n in range(32)]
    expected = sorted(x - 0.1 for x in roots if x < 100.1)
    course = course_of(
        "sin(3*theta) - cos(theta)", 100.0, method=method, tolerance=tolerance, step=0.5 if method == "rk4" else None
    )
    assert [e.time for e in course.events] == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("(theta - 2)^2 - 1e-8", [(1.9999, "falling"), (2.0001, "rising")]),
        ("(theta - 2)^2*(theta - 3)^2 - 1e-6", None),  # two dips in one step
        ("(theta - 2)^2", [(2.0, "touch")]),
        ("(theta - 2)^2 - 1e-10", [(2.0, "touch")]),  # within the resolution
        ("(theta - 2)^2 + 1e-7", []),
        ("(theta - 2)^3", [(2.0, "rising")]),
        ("(theta - 2)^4", [(2.0, "touch")]),
        ("abs(theta - 2)", [(2.0, "touch")]),
        ("sign(theta - 2)", [(2.0, "rising")]),
        ("1/(theta - 2)", []),  # a pole is no zero
        ("tan(theta)", [(math.pi, "rising"), (2 * math.pi, "rising"), (3 * math.pi, "rising")]),
        ("asin(sin(theta)) - 1.5", None),
        ("theta^1.5 - 8", [(4.0, "rising")]),
        ("exp(-theta) - exp(-5)", [(5.0, "falling")]),
        ("log(theta)*sqrt(theta)", [(1.0, "rising")]),
        ("atan(theta) - atan(7)", [(7.0, "rising")]),
        ("sinh(theta) - cosh(theta) + exp(-3)", [(3.0, "rising")]),
        ("tanh(theta/10) - tanh(0.6)", [(6.0, "rising")]),
        ("acos(cos(theta)) - 3", None),
    ],
)
def test_dips_touches_kinks_and_poles_are_told_apart(text: str, expected: list[tuple[float, str]] | None) -> None:
    found = found_of(text, 9.5)
    if text.startswith("asin"):  # twice about every maximum at pi/2 + 2 n pi, nothing where the slope jumps
        expected = [(1.5, "rising"), (math.pi - 1.5, "falling")]
        expected += [(x + 2 * math.pi, kind) for x, kind in expected]
    if text.startswith("acos"):
        expected = [(3.0, "rising"), (2 * math.pi - 3.0, "falling")]
        expected += [(2 * math.pi + 3.0, "rising"), (4 * math.pi - 3.0, "falling")]
    if expected is None:  # |(x - 2)(x - 3)| = 1e-3
        inner, outer = (math.sqrt(0.25 + sign * 1e-3) for sign in (-1.0, 1.0))
        expected = [
            (2.5 - outer, "falling"),
            (2.5 - inner, "rising"),
            (2.5 + inner, "falling"),
            (2.5 + outer, "rising"),
        ]
    assert [kind for _x, kind in found] == [kind for _x, kind in expected]
    assert [x for x, _kind in found] == pytest.approx([x for x, _kind in expected], abs=1e-8)


def test_what_was_not_looked_for_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(search, "MOST_PARTS", 40)
    result = simulated(ROD, 1000.0, "h = 0")
    assert result.status is Status.FINISHED
    assert "h = 0 was not looked for between t = " in result.message
    assert "max_step" in result.message


@pytest.mark.parametrize("tolerance", [1e-4, 1e-6, 1e-9, 1e-12])
def test_a_pendulum_comes_back_to_where_it_was_let_go_once_a_period(tolerance: float) -> None:
    result = fb.System.load(EXAMPLES / "simple_pendulum.yaml").simulate(
        20.0, events=["theta = theta_0"], tolerance=tolerance
    )
    period = 4.0 * math.sqrt(1.0 / 9.81) * ellipk(math.sin(math.radians(30.0)) ** 2)
    assert [e.kind for e in result.events] == ["start"] + 9 * ["touch"]
    assert times_of(result) == pytest.approx([k * period for k in range(1, 10)], rel=10.0 * tolerance + 1e-9)


# -- rest in an unstable equilibrium -------------------------------------------------------------
UPRIGHT = """
parameters: {m: 2 kg, L: 1.5 m}
bodies: {rod: {rod: {mass: m, length: L}}}
connections: {hinge: {pin: [ground.O, rod.start]}}
loads: {weight: {gravity: 9.81 m/s^2}}
measures: {theta: angle of rod from up clockwise}
start: {theta: 0}
"""


def test_a_rod_that_stands_upright_at_rest_stays_and_that_is_said() -> None:
    result = model(UPRIGHT).simulate(30.0, events=["theta = 0.9 rad"])
    assert (result.status, result.t_end, result.events) == (Status.FINISHED, 30.0, ())
    assert "unstable equilibrium" in result.message
    assert np.ptp(result.series["theta"][0]) == 0.0


@pytest.mark.parametrize("stiffness", [5.0, 500.0, 7e6])
@pytest.mark.parametrize("turned", [0.0, 0.3, 0.7, 1.1])
def test_a_spring_along_a_bar_that_never_stretches_makes_no_equilibrium_unstable(
    stiffness: float, turned: float
) -> None:
    # both its ends are on one bar: its force is of round-off, and so is every slope of it
    start = f"{{through: [0.3 m, 0.1 m], along: {turned} rad}}"
    system = model(f"""
ground: {{points: {{O: [0.3 m, 0.1 m]}}, lines: {{way: {start}}}}}
bodies: {{crank: {{rod: {{mass: 1 kg, length: 1.3 m}}}}, link: {{rod: {{mass: 2 kg, length: 2.1 m}}}}}}
connections:
  O: {{pin: [ground.O, crank.start]}}
  A: {{pin: [crank.end, link.start]}}
  B: {{slot: {{pin: link.end, along: way}}}}
loads: {{spring: {{spring: {{first: crank.end, second: link.end, stiffness: {stiffness} N/m}}}}}}
measures: {{theta: angle of crank from right}}
start: {{theta: {turned + 0.9} rad}}
""")
    reference = Reference(system)
    _mass, K = reference.linearised(reference.assemble())
    assert K.shape == (1, 1)
    assert not K.any()
    assert system.simulate(1.0).message == ""


@pytest.mark.parametrize("start", [1e-9, 1e-3])
def test_a_rod_a_little_beside_falls_after_the_time_of_the_closed_form(start: float) -> None:
    # theta'^2 = 3 g/L (cos theta_0 - cos theta) = 6 g/L sin((theta + theta_0)/2) sin((theta - theta_0)/2); the
    # quadrature is over u, theta = theta_0 cosh u, which takes the singular end away
    rate = math.sqrt(1.5 * 9.81 / 1.5)
    result = model(UPRIGHT.replace("start: {theta: 0}", f"start: {{theta: {start} rad}}")).simulate(
        20.0, events=["stop when theta = 0.9 rad"]
    )

    def slope(u: float) -> float:
        theta = start * math.cosh(u)
        speed = 2.0 * rate * math.sqrt(math.sin((theta + start) / 2.0) * math.sin((theta - start) / 2.0))
        return start * math.sinh(u) / speed if u else 1.0 / rate

    expected = quad(slope, 0.0, math.acosh(0.9 / start), epsabs=1e-12, epsrel=1e-12, limit=200)[0]
    assert result.t_end == pytest.approx(expected, rel=1e-6)
    assert "equilibrium" not in result.message


# -- contact -------------------------------------------------------------------------------------
def test_a_corner_that_dips_below_the_floor_for_an_instant_hits_it() -> None:
    # half the rod is longer than the pin is high by a part in 10^7: it hits where sin(theta) = 1 - 1e-7
    system = model("""
ground: {points: {O: [0, 0]}, lines: {floor: {through: [0, -0.9999999 m], along: right}}}
bodies: {rod: {rod: {mass: 1 kg, length: 2 m}, at: {center: [0, 0]}, angle: 0}}
connections: {pin: {pin: [ground.O, rod.center]}, hit: {contact: {between: [rod, floor], restitution: 1}}}
measures: {theta: angle of rod from right}
start: {theta: 0, rate(theta): 1 rad/s}
""")
    result = system.simulate(3.0)
    assert result.events[0].time == pytest.approx(math.asin(1.0 - 1e-7), abs=1e-9)


def test_contacts_are_watched_by_the_implicit_method_too() -> None:
    system = model("""
ground: {lines: {floor: {along: right}}}
bodies: {ball: {disk: {mass: 1 kg, radius: 0.1 m}, at: [0, 1.1 m]}}
connections: {hit: {contact: {between: [ball, floor], restitution: 0.8}}}
loads: {weight: {gravity: 9.81 m/s^2}}
""")
    first = math.sqrt(2.0 / 9.81)
    result = system.simulate(1.5, method="radau5")
    assert [e.time for e in result.events[:2]] == pytest.approx([first, first + 1.6 * first], rel=1e-7)


# -- limits --------------------------------------------------------------------------------------
def test_a_motion_cut_by_its_steps_says_so_and_the_same_every_time() -> None:
    ends = [simulated_steps() for _ in range(2)]
    assert ends[0].status is Status.TOO_LONG
    assert "after 3 steps: cut by max_steps" in ends[0].message
    assert ends[0].t_end == ends[1].t_end


def simulated_steps() -> fb.Simulation:
    return model(WHEEL).simulate(10.0, max_steps=3)


def test_a_longest_step_is_kept() -> None:
    assert model(WHEEL).simulate(10.0, max_step=0.1).course.n_steps >= 100
    with pytest.raises(fb.InputError, match="max_step must be positive"):
        model(WHEEL).simulate(10.0, max_step=-1.0)


def test_turns_are_counted_on_through_the_impacts_of_something_else() -> None:
    # a rod that nothing slows down, and a ball that bounces without knowing of it: u = theta = 0.1 + 30 t
    system = fb.System.from_text("""
ground: {points: {O: [0, 0]}, lines: {floor: {along: right}}}
bodies:
  rod: {body: {mass: 2 kg, inertia: 0.3 kg m^2}, points: {P: [1 m, 0]}}
  ball: {particle: {mass: 1 kg}, at: [5 m, 2 m]}
connections:
  pin: {pin: [ground.O, rod]}
  rail: {slider: {body: ball, along: up}}
  bounces: {contact: {between: [ball, ground.floor], restitution: 0.5}}
measures: {theta: angle of rod from right, u: angle of line from ground.O to rod.P}
start: {theta: 0.1 rad, rate(theta): 30 rad/s}
loads: {weight: {force: {at: ball, along: down, magnitude: 9.81 N}}}
""")
    result = system.simulate(3.0)
    assert len(result.events) > 5
    for name in ("theta", "u"):
        assert np.asarray(result.series[name][0]) == pytest.approx(
            0.1 + 30.0 * np.asarray(result.course.times), abs=1e-6
        )
