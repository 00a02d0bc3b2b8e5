"""The compiled engine against the reference route: the same statements, evaluated in two ways."""

from __future__ import annotations

import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

import freebody as fb
from freebody.connections.base import Connection
from freebody.language.expression import FLOAT_FUNCTIONS, evaluate
from freebody.language.parser import parse
from freebody.loads.base import Load
from freebody.measures.angle import Angle
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Bearing, Distance
from freebody.measures.geometry import Direction, Point
from freebody.measures.lead import Lead
from freebody.numeric.engine.course import NO_TRACKS
from freebody.numeric.engine.engine import Engine
from freebody.numeric.engine.evaluator import Observer
from freebody.numeric.engine.tapes import Tapes
from freebody.numeric.kernels import tape
from freebody.numeric.kernels.declaring import plain
from freebody.numeric.reference import Reference
from freebody.study.settled import settled, start_mode
from kernel_runs import largest_gaps
from mechanisms import chain, ladder, tree

ROOT = Path(__file__).parents[1]
EXAMPLES = sorted(path.stem for path in (ROOT / "examples").glob("*.yaml"))
KINDS = {**Connection.kinds, **Load.kinds}


def number(x: float) -> object:
    return parse(repr(x))


# -- instants ---------------------------------------------------------------------------------
def assert_alike(system: fb.System) -> None:
    """Accelerations and unique multipliers at a general pose and motion, by both routes."""
    values = {p.name: 0.7 + 0.1 * k for k, p in enumerate(system.parameters.values()) if p.value is None}
    reference = Reference(system, values)
    q = reference.assemble()
    q, v = reference.wander(q, np.random.default_rng(3), 0.1, 0.2)
    snapshot = reference.snapshot(q, v, 0.2)
    engine = Engine(reference.numbers())
    y = engine.state(*reference.by_body(q, v))
    engine.align(y, 0.2, snapshot.value)
    engine.evaluate(y + 0.01 * np.sin(np.arange(len(y))), 0.5)  # nothing of another instant may be left
    accelerations, multipliers = engine.evaluate(y, 0.2)
    scale = 1.0 + np.abs(snapshot.accelerations).max(initial=0.0)
    assert np.abs(reference.by_column(accelerations) - snapshot.accelerations).max(initial=0.0) < 1e-9 * scale
    largest = 1.0 + np.abs(multipliers).max(initial=0.0)
    for k, row in enumerate(system.constraint_rows):
        try:
            assert multipliers[k] == pytest.approx(snapshot.multiplier(row), abs=1e-8 * largest), row.name
        except fb.CannotAnswer:
            assert engine.non_unique()[k], row.name
    assert max(largest_gaps(engine, y, 0.2)) < 1e-9


@pytest.mark.parametrize("name", EXAMPLES)
def test_both_routes_agree_on_the_accelerations_and_reactions_of_an_example(name: str) -> None:
    assert_alike(fb.System.load(ROOT / "examples" / f"{name}.yaml"))


@pytest.mark.parametrize("kind", sorted(KINDS))
def test_both_routes_agree_on_every_connection_and_load(kind: str) -> None:
    assert_alike(fb.System.from_text(KINDS[kind].example))


MEASURES = {
    "displacement along the ground": Displacement(
        Point("a", (number(0.3), number(-0.2))),
        Point("b", (number(0.1), number(0.4))),
        Direction("ground", (number(0.6), number(0.8))),
    ),
    "displacement along a body": Displacement(
        Point("a", (number(0.3), number(-0.2))),
        Point("b", (number(0.1), number(0.4))),
        Direction("c", (number(0.6), number(0.8))),
    ),
    "displacement along its own body": Displacement(
        Point("a", (number(0.3), number(-0.2))),
        Point("b", (number(0.1), number(0.4))),
        Direction("a", (number(0.6), number(0.8))),
    ),
    "angle": Angle("a", "b", number(0.3)),
    "distance": Distance(Point("a", (number(0.3), number(-0.2))), Point("b", (number(0.1), number(0.4)))),
    "bearing": Bearing(
        Point("a", (number(0.3), number(-0.2))), Point("b", (number(0.1), number(0.4))), "c", number(0.2)
    ),
    "lead": Lead(Point("a", (number(0.3), number(-0.2))), Point("b", (number(0.1), number(0.4))), number(0.35)),
}


@pytest.mark.parametrize("name", MEASURES)
def test_a_kernel_gives_value_rate_and_second_derivative_of_its_measure(name: str) -> None:
    system = fb.System.from_text(
        "bodies: {a: {rod: {mass: 1 kg, length: 1 m}}, b: {rod: {mass: 2 kg, length: 1 m}}, "
        "c: {disk: {mass: 1 kg, radius: 1 m}}}"
    )
    measure = MEASURES[name]
    reference = Reference(system)
    rng = np.random.default_rng(5)
    q = np.array([0.0, 0.0, 0.4, 2.0, 1.0, -0.7, -1.0, 0.5, 1.1])
    v, a = rng.standard_normal(9), rng.standard_normal(9)
    snapshot = reference.snapshot(q, v)
    jet = reference.jet(snapshot.geometry, measure)
    observer = Observer(reference.numbers(), [measure])
    y = observer.state(*reference.by_body(q, v))
    observer.align(y, 0.0, lambda m: reference.jet(snapshot.geometry, m).value)
    course = _instant(y, observer, a)
    value, rate, second = observer.along(course, [measure])[measure]
    assert value[0] == pytest.approx(jet.value, abs=1e-13)
    assert rate[0] == pytest.approx(jet.rate, abs=1e-13)
    assert second[0] == pytest.approx(float(jet.row(9) @ a) + jet.bias, abs=1e-12)


def _instant(y: np.ndarray, observer: Observer, a: np.ndarray) -> object:
    class Instant:
        times = np.zeros(1)
        poses = observer.parts(y)[0][None]
        velocities = observer.parts(y)[1][None]
        accelerations = np.vstack((a.reshape(3, 3), np.zeros(3)))[None]
        tracks = NO_TRACKS

    return Instant()


def test_the_kernels_in_the_tree_are_what_the_statements_give() -> None:
    done = subprocess.run(
        [sys.executable, str(ROOT / "tools" / "write_kernels.py"), "--check"], capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr


# -- expressions ------------------------------------------------------------------------------
TEXTS = [
    "3*x + t",
    "x*t/(1 + x^2)",
    "sin(x)*cos(t)*tan(x/3)",
    "sqrt(1 + x^2) - x^3/7 + x^-2",
    "exp(-x)*log(2 + x)",
    "asin(x/4) + acos(x/5) + atan(x)",
    "sinh(x) - cosh(t) + tanh(x)",
    "abs(x)*sign(x) + x^(5/2) + (1 + x)^t",
]


@pytest.mark.parametrize("text", TEXTS)
def test_a_tape_follows_an_expression_and_its_derivatives(text: str) -> None:
    expr = parse(text)
    tapes = Tapes({})
    tapes.write(expr, {"x": (0, 0.0)})
    ops = np.array(list(zip(tapes.ops, tapes.left, tapes.right, strict=True)), dtype=np.int32)
    constants = np.array(tapes.constants)
    x, rate, second, t = 0.83, 1.4, -0.6, 0.37
    rows = np.array([[x, rate, second, 0.0, 0.0]])
    registers = np.zeros((len(ops), 4))
    plain(tape.play)(0, len(ops), ops, constants, t, rows, registers)

    def f(s: float) -> float:
        return float(evaluate(expr, {"x": x + rate * s + second * s * s / 2, "t": t + s}, FLOAT_FUNCTIONS))

    h = 1e-3
    first = (8 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12 * h)
    twice = (16 * (f(h) + f(-h)) - (f(2 * h) + f(-2 * h)) - 30 * f(0)) / (12 * h * h)
    assert registers[-1, 0] == pytest.approx(f(0.0), rel=1e-14)
    assert registers[-1, 1] == pytest.approx(first, rel=1e-9)
    assert registers[-1, 2] == pytest.approx(twice, rel=1e-6, abs=1e-7)
    plain(tape.sweep)(0, len(ops), ops, constants, registers, rows)
    by_x = (
        evaluate(expr, {"x": x + h, "t": t}, FLOAT_FUNCTIONS) - evaluate(expr, {"x": x - h, "t": t}, FLOAT_FUNCTIONS)
    ) / (2 * h)
    assert rows[0, 4] == pytest.approx(by_x, rel=1e-5)


def test_an_expression_of_ten_operations_costs_less_than_200_ns_where_a_wheel_alone_costs_120() -> None:
    torque = (
        "bodies: {w: {disk: {mass: 1 kg, radius: 1 m}}}\nmeasures: {phi: angle of w}\n"
        "parameters: {T0: 1 N m, w0: 2 1/s, k: 3 N m}\n"
    )
    plain = fb.Simulator(fb.System.from_text(torque + "loads: {m: {torque: {on: w, magnitude: 1 N m}}}"))
    loaded = fb.Simulator(
        fb.System.from_text(torque + "loads: {m: {torque: {on: w, magnitude: T0*sin(w0*t) - k*phi^3/(1 + phi^2)}}}")
    )

    def seconds(simulator: fb.Simulator) -> float:
        """Of the processor, for an evaluation: in runs so short that most of them are not interrupted."""
        n = 20_000
        began = time.thread_time()
        simulator.engine.evaluate(simulator.start, 0.0, n)
        return (time.thread_time() - began) / n

    # another process on the machine makes a run longer, never shorter: the least of many, of both in turn; a slower
    # machine makes both longer
    runs = np.array([[seconds(loaded), seconds(plain)] for _ in range(20)])
    with_expression, alone = runs.min(axis=0)
    assert (with_expression - alone) / alone < 200 / 120


# -- the linear system ------------------------------------------------------------------------
@pytest.mark.parametrize("family", [chain, tree, ladder])
def test_the_factor_grows_linearly_with_the_number_of_bodies(family) -> None:  # type: ignore[no-untyped-def]
    def entries(n: int) -> int:
        reference = Reference(family(n))
        reference._origins = {}
        return len(Engine(reference.numbers()).room.schur)

    assert entries(32) - entries(16) == pytest.approx(2 * (entries(16) - entries(8)), rel=0.25)


# -- reproducible, with and without compilation ----------------------------------------------
def test_the_same_input_gives_the_same_bits() -> None:
    system = fb.System.load(ROOT / "examples" / "double_pendulum.yaml").with_parameters()
    first, second = (system.simulate(3.0).course for _ in range(2))
    assert first.poses.tobytes() == second.poses.tobytes()
    assert first.multipliers.tobytes() == second.multipliers.tobytes()


# -- motions ----------------------------------------------------------------------------------
def stuck(system: fb.System) -> fb.System:
    """The system in the contact states of its start, with friction that sticks."""
    return settled(system) if system.has_values else system


def assert_same_motion(system: fb.System) -> None:
    values = {p.name: 0.7 + 0.1 * k for k, p in enumerate(system.parameters.values()) if p.value is None}
    result = system.simulate(0.1, tolerance=1e-12, every=0.1, values=values)
    if result.course.events:
        pytest.skip("something strikes or comes loose within the tenth of a second: the reference follows one mode")
    reference = Reference(stuck(system), values)
    q = reference.assemble()
    slow = reference.integrate((q, reference.velocities(q)), 0.1).snapshots[-1]
    engine = result.simulator.engine
    fast, velocities = map(reference.by_column, engine.coordinates(engine.state_at(result.course, -1)))
    assert np.abs(reference.frame.difference(fast, slow.q)).max() < 1e-9 * (1.0 + np.abs(slow.q).max())
    assert np.abs(velocities - slow.v).max() < 1e-8 * (1.0 + np.abs(slow.v).max())


@pytest.mark.parametrize("name", EXAMPLES)
def test_both_routes_follow_the_same_motion_of_an_example(name: str) -> None:
    """Examples whose friction slides are followed phase by phase in test_phases_simulation."""
    system = fb.System.load(ROOT / "examples" / f"{name}.yaml")
    if system.dry_friction:
        mode = start_mode(system)
        if any(state for _name, state in mode.dry_friction):
            return
        if not mode.closed <= {row.name for row in system.rows}:
            pytest.skip("it tips from the start: the reference has no row for the point about which it does")
    assert_same_motion(system)


@pytest.mark.parametrize("kind", sorted(KINDS))
def test_both_routes_follow_the_same_motion_of_every_connection_and_load(kind: str) -> None:
    system = fb.System.from_text(KINDS[kind].example)
    if fb.Simulator(system).degrees_of_freedom:
        assert_same_motion(system)


def test_a_velocity_constraint_with_expressions_keeps_the_order_of_a_method() -> None:
    sleigh = fb.System.from_text("""
bodies: {b: {body: {mass: 3 kg, inertia: 0.5 kg m^2, center_of_mass: [0.4 m, 0]}}}
measures: {x: x of b, y: y of b, theta: angle of b}
connections: {it: {velocity_constraint: rate(y)*cos(theta) - rate(x)*sin(theta)}}
parameters: {v: 2 m/s, w: 1.5 rad/s}
start: {x: 0, y: 0, theta: 0, rate(x): v, rate(theta): w}
""")
    simulator = fb.Simulator(sleigh)
    exact = simulator.run(1.0, tolerance=1e-13).poses[-1, 0]
    errors = [np.abs(simulator.run(1.0, method="rk4", step=h).poses[-1, 0] - exact).max() for h in (0.02, 0.01)]
    assert errors[0] / errors[1] == pytest.approx(16.0, rel=0.3)
