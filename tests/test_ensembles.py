"""Many copies by equations of their own: the numbers of the engine and of closed forms, and what is refused by name."""

from __future__ import annotations

import math
import os
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import freebody as fb
from command import freebody
from freebody.errors import CannotAnswer, InputError, RoutesDisagree
from freebody.numeric.engine.integrators import integrator
from freebody.numeric.engine.operations import ProgramNode
from freebody.numeric.ensemble import devices
from freebody.numeric.ensemble.copies import Copies, CopyGraph
from freebody.numeric.ensemble.source import source_of
from freebody.study.setup import Setup
from freebody.study.sweeps.ensembles import evaluator
from freebody.study.sweeps.ensembles.equations import EquationsOfCopies
from freebody.study.sweeps.varied import varied

numba: Any = pytest.importorskip("numba")

EXAMPLES = Path(__file__).parents[1] / "examples"


def example(name: str) -> fb.System:
    return fb.System.load(EXAMPLES / f"{name}.yaml")


def _as_it_stands(source: str) -> Any:
    functions = devices._functions_of(source + devices._PART_OF_COPIES, {}, lambda f: f, but="follow_some")
    return functions["follow_some"]


@pytest.fixture
def uncompiled(monkeypatch: pytest.MonkeyPatch) -> None:
    """The text of copies run by Python: it takes no seconds to compile."""
    monkeypatch.setattr(devices, "_for_processors", _as_it_stands)


# -- the same numbers as by the engine --------------------------------------------------------
DEGREES = math.pi / 180.0
CASES: dict[str, tuple[str, dict[str, Any], list[str], float]] = {
    "an open chain": (
        "double_pendulum",
        {"theta1": [20 * DEGREES, 50 * DEGREES], "m2": [0.5, 2.0]},
        ["final theta1", "theta2_rate at 0.3 s", "maximum of theta1", "minimum of theta2_rate", "final theta2"],
        1.0,
    ),
    "a cart under a force": ("cart_and_pendulum", {"F": [2.0, 9.0]}, ["final x", "final theta_acceleration"], 1.0),
    "a drive": ("bead_on_turning_rod", {"omega": [1.0, 2.0]}, ["final r", "final r_rate"], 0.5),
    "a bead on a turning hoop": ("bead_on_turning_hoop", {"R": [0.2, 0.3]}, ["maximum of beta"], 1.0),
    "a loop without a formula of its start": ("four_bar", {"b": [0.48, 0.5], "T": [1.0, 3.0]}, ["final theta"], 0.5),
    "a loop with dead points": ("slider_crank", {"T": [1.0, 2.0]}, ["final theta", "final theta_rate"], 0.3),
    "a driven loop in space": ("cardan_joint", {"alpha": [0.3, 0.5]}, None, 0.3),  # type: ignore[dict-item]
    "a top": ("spinning_top", {"g": [9.0, 9.81]}, None, 0.2),  # type: ignore[dict-item]
    "a controller with a state": ("servo_with_pid", {"J": [0.01, 0.02]}, None, 0.3),  # type: ignore[dict-item]
}


@pytest.mark.usefixtures("uncompiled")
@pytest.mark.parametrize("case", CASES)
def test_copies_have_the_numbers_of_the_engine(case: str) -> None:
    name, vary, record, until = CASES[case]
    system = example(name)
    record = record or [f"final {measure}" for measure in system.measures]
    one, other = (system.sweep(vary, record=record, until=until, device=d, threads=1) for d in ("cpu", "engine"))
    assert one.counts == other.counts == {"motion": {"finished": one.n}}
    assert (one.device, other.device) == ("cpu", "engine")
    for column in record:
        np.testing.assert_allclose(one.values(column), other.values(column), rtol=3e-7, atol=3e-8)


def test_compiled_copies_have_the_same_bits_for_any_threads_and_blocks() -> None:
    system = example("simple_pendulum")
    asked: dict[str, Any] = {
        "vary": {"theta_0": "10..170 deg", "L": "1..2 m"},
        "sample": "random:200",
        "record": ["final theta", "maximum of theta_rate"],
        "until": 2.0,
    }
    first = system.sweep(**asked, device="cpu", threads=1)
    again = system.sweep(**asked, device="cpu", threads=3, block=64)
    by_engine = system.sweep(**asked, threads=2)
    assert first.digest == again.digest
    assert first.counts == by_engine.counts
    for column in asked["record"]:
        np.testing.assert_allclose(first.values(column), by_engine.values(column), atol=2e-7)


# -- closed forms -----------------------------------------------------------------------------
OSCILLATOR = """
freebody: 1
parameters: {m: 2 kg, k: 200 N/m, X: 0.1 m, W: 4 rad/s}
bodies: {base: {particle: {mass: 1 kg}}, block: {particle: {mass: m}}}
connections:
  rail: {slider: {body: base, along: right}}
  track: {slider: {body: block, along: right}}
  shaker: {driver: {measure: x of base, follows: X*sin(W*t)}}
loads: {spring: {spring: {first: base, second: block, stiffness: k, length: 2 m}}}
measures: {x: {x of block}}
start: {x: 2.5 m, rate(x): 0}
"""


@pytest.mark.usefixtures("uncompiled")
def test_a_driven_oscillator_moves_by_its_closed_form() -> None:
    """m y'' = -k (y - X sin W t) with y = x - 2 m, so y = A cos w t + B sin w t + C sin W t, w^2 = k/m,
    C = X w^2/(w^2 - W^2), A = 0.5 m, B = -C W/w."""
    k, W = np.array([150.0, 200.0, 333.0]), np.array([3.0, 5.0])
    found = fb.System.from_text(OSCILLATOR).sweep(
        {"k": k, "W": W},
        record=["final x", "x_rate at 0.7 s", "maximum of x"],
        until=1.3,
        tolerance=1e-10,
        device="cpu",
    )
    w, Wg = np.meshgrid(np.sqrt(k / 2.0), W, indexing="ij")
    C = 0.1 * w**2 / (w**2 - Wg**2)

    def x(t: Any) -> Any:
        return 2.0 + 0.5 * np.cos(w * t) - C * Wg / w * np.sin(w * t) + C * np.sin(Wg * t)

    def rate(t: Any) -> Any:
        return -0.5 * w * np.sin(w * t) - C * Wg * np.cos(w * t) + C * Wg * np.cos(Wg * t)

    np.testing.assert_allclose(found.values("final x"), x(1.3), atol=1e-8)
    np.testing.assert_allclose(found.values("x_rate at 0.7 s"), rate(0.7), atol=1e-7)
    most = np.max([x(t) for t in np.linspace(0.0, 1.3, 20_001)], axis=0)
    np.testing.assert_allclose(found.values("maximum of x"), most, atol=1e-6)


@pytest.mark.usefixtures("uncompiled")
def test_copies_of_a_double_pendulum_keep_their_energy() -> None:
    """T + V with V = -(m1 + m2) g L1 cos(theta1) - m2 g L2 cos(theta2); Landau & Lifshitz, Mechanics, sec. 5."""
    system = example("double_pendulum")
    p = {name: parameter.value for name, parameter in system.parameters.items()}
    record = [f"final {name}" for name in ("theta1", "theta2", "theta1_rate", "theta2_rate")]
    angles = np.radians([20.0, 70.0, 110.0])
    found = system.sweep({"theta1": angles, "theta2": angles}, record=record, until=3.0, device="cpu")
    a, b, u, v = (found.values(name) for name in record)
    m1, m2, L1, L2, g = (p[name] for name in ("m1", "m2", "L1", "L2", "g"))
    kinetic = 0.5 * (m1 + m2) * (L1 * u) ** 2 + 0.5 * m2 * (L2 * v) ** 2 + m2 * L1 * L2 * u * v * np.cos(a - b)

    def potential(a: Any, b: Any) -> Any:
        return -(m1 + m2) * g * L1 * np.cos(a) - m2 * g * L2 * np.cos(b)

    begun = potential(*np.meshgrid(angles, angles, indexing="ij"))
    np.testing.assert_allclose(kinetic + potential(a, b), begun, atol=1e-7 * (m1 + m2) * g * L1)


# -- elements as operations -------------------------------------------------------------------
def test_nested_operations_have_the_values_of_the_elements() -> None:
    system, names = varied(example("four_bar"), ["a", "m2"])
    equations = EquationsOfCopies(system, [v.parameter for v in names])
    copies = equations.copies(["theta_acceleration"], ())
    model = equations.model
    sample = equations.setup.draws[1].sample(equations.setup.draws[1].anywhere(5, 0.0, 0.2), is_start=False)
    numbers = model.samples.numbers(sample)
    # the parameters that do not vary have the numbers of the model, not those of the sample
    own = {name: model.field.index(g) for name, g in model.parameters.items() if name != "t"}
    values = {k: x for k, x in numbers.items() if model.field.generators[k].kind in ("coordinate", "speed")}
    values |= {k: float(system.parameters[name].value or 0.0) for name, k in own.items()}
    values |= {own["a"]: 0.21, own["m2"]: 1.7, model.field.index(model.field.time): 0.0}
    values = model.field.complete(values)
    speeds = [model.dependent_speed(c) for c in model.dependent]
    values |= {c.speed: model.field.evaluate(x, values) for c, x in zip(model.dependent, speeds, strict=True)}
    M, F = model.dynamics.mass_matrix[0][0], model.dynamics.forcing[0]
    wanted = model.field.evaluate(F, values) / model.field.evaluate(M, values)
    given = np.array([[0.21, 1.7, 0.0, 0.0]])
    rates = devices._functions_of(source_of(copies, integrator("dop853").tableau), {}, lambda f: f, but="")
    constants = rates["constants"](*given[0])
    found = rates["rates"](0.0, *(values[k] for k in equations.states), *constants)
    assert found[-1] == pytest.approx(wanted, rel=1e-11)
    np.testing.assert_allclose(found[1:3], [values[c.speed] for c in model.dependent], rtol=1e-11)


def test_what_hangs_on_parameters_alone_is_computed_once() -> None:
    graph = CopyGraph(1, 2)
    y, (p, q) = graph.states[0], graph.parameters
    square = p * p * q
    assert not graph.moves(square.at)
    assert graph.moves((square * y).at)
    copies = Copies(graph, [p], [square * y], [1.0], [True], [y])
    text = source_of(copies, integrator("dop853").tableau)
    rates = text[text.index("def rates") : text.index("def watched")]
    assert rates.count("*") == 1


@pytest.mark.usefixtures("uncompiled")
def test_no_step_goes_where_the_equations_are_not_those_of_the_motion() -> None:
    """y' = -1 from y = 1, with equations for y > 0 alone: the copy comes to 0.9 s, and not to 1.1 s."""
    graph = CopyGraph(1, 1)
    y: ProgramNode = graph.states[0]
    one, minus = graph.constant(1.0), graph.constant(-1.0)
    text = source_of(Copies(graph, [one], [minus], [1.0], [True], [y], (), [y]), integrator("dop853").tableau)
    compiled = devices.Compiled(text, 1, 0)
    for until, is_done in ((0.9, True), (1.1, False)):
        found = compiled.follow(np.zeros((1, 1)), np.array([until]), 1e-9)
        assert bool(found.is_done[0]) is is_done
    assert compiled.follow(np.zeros((1, 1)), np.array([0.5]), 1e-9).watched[0, 0, 0] == pytest.approx(0.5)


# -- what the engine does instead -------------------------------------------------------------
@pytest.mark.usefixtures("uncompiled")
def test_cases_that_copies_do_not_bring_to_their_end_are_the_engine_s_to_the_bit(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(devices, "MOST_TRIES", 2)  # steps
    asked: dict[str, Any] = {"vary": {"L": [0.5, 1.0]}, "record": ["final theta", "maximum of theta"], "until": 1.0}
    one, other = (example("simple_pendulum").sweep(**asked, device=d) for d in ("cpu", "engine"))
    assert one.digest == other.digest


@pytest.mark.slow
@pytest.mark.usefixtures("uncompiled")
def test_a_case_without_a_start_has_the_status_of_the_engine() -> None:
    """A coupler of 0.02 m does not reach: the loop has no start there."""
    asked: dict[str, Any] = {"vary": {"b": [0.02, 0.5]}, "record": ["final theta"], "until": 0.1}
    one, other = (example("four_bar").sweep(**asked, device=d) for d in ("cpu", "engine"))
    assert one.counts == other.counts
    assert one.counts["motion"]["cannot be assembled"] == 1
    assert one.failures[0].why == other.failures[0].why


@pytest.mark.usefixtures("uncompiled")
def test_a_sign_that_the_model_excludes_is_a_status() -> None:
    found = example("simple_pendulum").sweep({"m": [-1.0, 1.0]}, record=["final theta"], until=0.1, device="cpu")
    assert found.counts["motion"] == {"not admissible": 1, "finished": 1}


@pytest.mark.usefixtures("uncompiled")
def test_equations_that_differ_from_the_engine_are_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    write: Callable[..., str] = evaluator.source_of
    monkeypatch.setattr(evaluator, "source_of", lambda *of: write(*of).replace("math.sin(y0)", "math.cos(y0)"))
    with pytest.raises(RoutesDisagree, match=r"'theta at 0\.0078125 s' is .* by the engine at theta_0 = "):
        example("simple_pendulum").sweep({"theta_0": [0.3, 0.6]}, record=["final theta"], until=0.5, device="cpu")


@pytest.mark.usefixtures("uncompiled")
def test_late_in_a_chaotic_motion_nothing_is_compared() -> None:
    """From nearly upright the ends of both routes have nothing to do with each other, and nobody is to blame."""
    vary = {"theta1": np.radians([165.0]), "theta2": np.radians([165.0, 175.0])}
    asked: dict[str, Any] = {"record": ["final theta1", "maximum of theta2"], "until": 40.0, "tolerance": 1e-6}
    found = example("double_pendulum").sweep(vary, **asked, device="cpu")
    by_engine = example("double_pendulum").sweep(vary, **asked)
    assert found.counts == by_engine.counts == {"motion": {"finished": 2}}
    assert float(np.abs(found.values("final theta1") - by_engine.values("final theta1")).max()) > 1e-3


@pytest.mark.usefixtures("uncompiled")
@pytest.mark.parametrize(("name", "vary"), [("double_pendulum", "m1"), ("arm_against_gravity", "m")])
def test_round_off_of_what_rests_is_no_difference(name: str, vary: str) -> None:
    system = example(name)
    record = [f"{what} of {measure}" for measure in system.measures for what in ("maximum", "minimum")]
    found = system.sweep({vary: [1.0, 2.0]}, record=record, until=0.6, device="cpu")
    assert found.counts == {"motion": {"finished": 2}}
    for column in record:
        np.testing.assert_allclose(found.values(column), found.values(column).flat[0], atol=1e-9)


# -- what is refused --------------------------------------------------------------------------
REFUSED: dict[str, tuple[str, dict[str, Any], str]] = {
    "contacts": (
        "bouncing_ball",
        {"vary": {"h": [1.0]}, "record": ["final y"]},
        "contact may open, close, stick or slip",
    ),
    "reactions": (
        "simple_pendulum",
        {"vary": {"L": [1.0]}, "record": ["final rod.tension"]},
        "'final rod.tension': only measures",
    ),
    "times of events": (
        "simple_pendulum",
        {"vary": {"L": [1.0]}, "record": ["time when theta = 0"]},
        "'time when theta = 0': only values at an instant",
    ),
    "another method": (
        "simple_pendulum",
        {"vary": {"L": [1.0]}, "record": ["final theta"], "method": "radau5"},
        "only the method dop853 is available",
    ),
    "long formulas": (
        "spherical_four_bar",
        {"vary": {"alpha_1": [0.4]}, "record": ["final theta"]},
        "leave out --device",
    ),
    "what has no inertia": ("four_bar", {"vary": {"b": [0.5]}, "record": ["final theta"]}, "moves without inertia"),
    "extremes of accelerations": (
        "simple_pendulum",
        {"vary": {"L": [1.0]}, "record": ["maximum of theta_acceleration"]},
        "extremes of accelerations cannot be recorded",
    ),
}


@pytest.mark.parametrize("what", REFUSED)
def test_what_copies_do_not_follow_is_said_by_name(what: str) -> None:
    name, asked, told = REFUSED[what]
    system = example(name)
    if what == "what has no inertia":
        text = (EXAMPLES / "four_bar.yaml").read_text(encoding="utf-8")
        system = fb.System.from_text(re.sub(r"mass: m\d", "mass: 0 kg", text))
    if what == "long formulas":
        asked = {
            **asked,
            "vary": {next(iter(system.parameters)): [0.4]},
            "record": [f"final {next(iter(system.measures))}"],
        }
    with pytest.raises(CannotAnswer, match="leave out --device") as error:
        system.sweep(**asked, until=1.0, device="cpu")
    assert told in str(error.value)


def test_a_device_needs_a_motion_without_events_and_no_cluster() -> None:
    system = example("simple_pendulum")
    asked: dict[str, Any] = {"vary": {"L": [1.0]}, "record": ["final theta"], "until": 1.0}
    with pytest.raises(InputError, match="there is no device tpu; take engine, cpu or gpu"):
        system.sweep(**asked, device="tpu")
    with pytest.raises(InputError, match="--device is for motions"):
        system.sweep({"L": [1.0]}, find=["period"], device="cpu")
    with pytest.raises(InputError, match="only the engine looks for events"):
        system.sweep(**asked, events=["theta = 0"], device="cpu")
    with pytest.raises(InputError, match="choose --cluster or --device"):
        system.sweep(**asked, cluster="local:1", device="cpu")


def test_a_missing_library_is_named_with_its_extra(monkeypatch: pytest.MonkeyPatch) -> None:
    def missing(name: str) -> Any:
        raise ModuleNotFoundError(name)

    monkeypatch.setattr(devices, "import_module", missing)
    with pytest.raises(InputError, match=r'pip install "freebody\[ensemble\]"'):
        devices.check_device("cpu")
    with pytest.raises(InputError, match=r'pip install "freebody\[gpu\]"'):
        devices.check_device("gpu")


def _has_card() -> bool:
    from numba import cuda

    return os.environ.get("NUMBA_ENABLE_CUDASIM") != "1" and bool(cuda.is_available())


@pytest.mark.skipif(_has_card(), reason="there is a graphics card")
def test_a_missing_card_is_told_by_the_command() -> None:
    done = freebody(
        "sweep", "examples/simple_pendulum.yaml", "--vary", "L=1, 2 m", "--record", "final theta", "--until", "1",
        "--device", "gpu",
    )  # fmt: skip
    assert done.returncode == 2
    assert "CUDA finds no graphics card here" in done.stderr


# -- graphics cards ---------------------------------------------------------------------------
_ON_CARD = """
import sys
import numpy as np
import freebody as fb

system = fb.System.load(sys.argv[1])
asked = dict(vary={"theta1": [0.3, 0.6, 0.9]}, record=["final theta1", "maximum of theta2"], until=0.3)
numbers = [system.sweep(**asked, device=device) for device in ("gpu", "engine")]
for column in asked["record"]:
    np.testing.assert_allclose(*(found.values(column) for found in numbers), atol=3e-8)
print(numbers[0].counts)
"""


def test_the_kernel_of_a_card_has_the_numbers_of_the_engine_in_the_simulator() -> None:
    done = subprocess.run(
        [sys.executable, "-c", _ON_CARD, str(EXAMPLES / "double_pendulum.yaml")],
        env={**os.environ, "NUMBA_ENABLE_CUDASIM": "1"},
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout.strip() == "{'motion': {'finished': 3}}"


@pytest.mark.skipif(not _has_card(), reason="CUDA finds no graphics card")
def test_a_card_has_the_numbers_of_the_processor() -> None:
    system = example("double_pendulum")
    asked: dict[str, Any] = {
        "vary": {"theta1": "10..60 deg", "theta2": "10..60 deg"},
        "sample": "random:2000",
        "record": ["final theta1", "maximum of theta2"],
        "until": 2.0,
    }
    card, processor = (system.sweep(**asked, device=device) for device in ("gpu", "cpu"))
    assert card.counts == processor.counts
    for column in ("final theta1", "maximum of theta2"):
        np.testing.assert_allclose(card.values(column), processor.values(column), atol=1e-7)


def test_the_numbers_of_the_start_are_those_of_the_assembled_pose() -> None:
    system, names = varied(example("four_bar"), ["b"])
    equations = EquationsOfCopies(system, [v.parameter for v in names])
    assert len(equations.open) == 2
    model, setup = equations.model, Setup(system, 1)
    snapshot = setup.draws[0].start()
    found = dict(zip(equations.open, equations.given({"b": 0.5}), strict=True))
    for c in model.dependent:
        measure = model.measure_of(c)
        if measure is not None:
            assert math.remainder(found[c.index] - snapshot.value(measure), math.tau) == pytest.approx(0.0, abs=1e-9)
