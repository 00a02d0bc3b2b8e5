"""Many cases of one system: the same numbers as one by one, the same bits however they are divided."""

from __future__ import annotations

import csv
import json
import math
import os
import signal
import subprocess
import sys
import time
import tracemalloc
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import freebody as fb
from command import freebody
from freebody.errors import InputError
from freebody.language.parser import parse
from freebody.language.truth import is_true, read_statement
from freebody.numeric.vectorised import VectorFunction, VectorStatement
from freebody.present.charts.frame import HEIGHT, WIDTH, Scale
from freebody.present.charts.lines import line_chart
from freebody.study.sweeps import running
from freebody.study.sweeps import sweep as sweep_module
from freebody.study.sweeps.statistics import statistics

EXAMPLES = Path(__file__).parents[1] / "examples"


def example(name: str) -> fb.System:
    return fb.System.load(EXAMPLES / f"{name}.yaml")


# -- formulas of arrays -----------------------------------------------------------------------
def test_a_formula_of_arrays_is_that_of_numbers_place_by_place() -> None:
    rng = np.random.default_rng(3)
    texts = ["a*sin(b)^2/(1 + a) - a/b", "sqrt(a)*exp(-b) + atan(a/b)^3", "elliptic_K(b/4)*a^(1/3)", "2*pi*sqrt(a/b)"]
    values = {"a": rng.uniform(0.5, 2.0, 37), "b": rng.uniform(0.5, 2.0, 37)}
    found = VectorFunction([parse(text) for text in texts]).at(values, 37)
    for text, column in zip(texts, found, strict=True):
        one_by_one = [
            fb.language.expression.evaluate(parse(text), {k: float(x[i]) for k, x in values.items()}) for i in range(37)
        ]
        np.testing.assert_allclose(column, one_by_one, rtol=1e-14)


def test_what_has_no_real_value_is_no_number() -> None:
    (x,) = VectorFunction([parse("sqrt(a) + 1/(a - 4)")]).at({"a": np.array([-1.0, 4.0, 9.0])}, 3)
    np.testing.assert_array_equal(x, [math.nan, math.nan, 3.2])


def test_a_statement_about_arrays_is_true_false_or_open_place_by_place() -> None:
    text = "((a > 2) & (b < 1)) | (a == 0)"
    a, b = np.array([0.0, 1.0, 3.0, 3.0, math.nan, 3.0]), np.array([5.0, 0.0, 0.0, 2.0, 0.0, math.nan])
    statement = read_statement(text)
    assert statement is not None
    found = VectorStatement(statement).at({"a": a, "b": b}, 6)
    np.testing.assert_array_equal(found, [1, -1, 1, -1, 0, 0])
    words = {1.0: True, -1.0: False}
    for k in range(4):
        assert is_true(text, {"a": float(a[k]), "b": float(b[k])}) is words[found[k]]


# -- answers ----------------------------------------------------------------------------------
def test_swept_answers_are_those_of_solve_case_by_case() -> None:
    """Atwood's machine: g (m1 - m2)/(m1 + m2 + M/2), by hand, and by solve at other values of the model."""
    found = example("atwood_machine").sweep({"m1": "1..3 kg:4", "M": "0.5, 2 kg"}, find=["acceleration", "tension"])
    m1, M = np.meshgrid(np.linspace(1, 3, 4), [0.5, 2.0], indexing="ij")
    np.testing.assert_allclose(found.values("acceleration"), 9.81 * (m1 - 2) / (m1 + 2 + M / 2), rtol=1e-15)
    assert found.counts == {"acceleration": {"formula": 8}, "tension": {"formula": 8}}
    here = example("atwood_machine").with_parameters(m1=float(m1[2, 1]), M=2.0).solve()
    assert found.values("tension")[2, 1] == pytest.approx(here["tension"].value, rel=1e-14)


def test_conditions_decide_case_by_case_where_a_formula_holds() -> None:
    """A sphere with sliding friction begins to roll only if mu > 2 tan(theta)/7."""
    found = example("sphere_launched_down_incline").sweep(
        {"mu": "0.05..0.5:10", "theta": "10, 20, 40 deg"}, find=["time"]
    )
    mu, theta = np.meshgrid(np.linspace(0.05, 0.5, 10), np.radians([10, 20, 40]), indexing="ij")
    rolls = mu > 2 / 7 * np.tan(theta)
    times = 2 * 2.0 / (9.81 * (7 * mu * np.cos(theta) - 2 * np.sin(theta)))
    np.testing.assert_allclose(found.values("time"), np.where(rolls, times, math.nan), rtol=1e-13)
    np.testing.assert_array_equal(found.status("time") == "formula", rolls)
    (failure,) = found.failures
    assert (failure.status, failure.count) == ("outside", int((~rolls).sum()))
    assert "is not true there" in failure.why


def test_a_case_distinction_takes_the_formula_of_each_case() -> None:
    """A block on a rough incline: it stays, or slides down with g (sin - mu cos), by what friction can hold."""
    model = """
parameters: {m: 1 kg, g: 10 m/s^2, theta: 30 deg, mu: 0.3}
ground: {lines: {incline: {along: -theta}}}
bodies: {block: {particle: {mass: m}}}
connections: {contact: {contact: {between: [block, incline], friction: mu}}}
loads: {weight: {gravity: g}}
measures: {x: {travel of block along incline}}
start: {x: 0, rate(x): 0}
questions: [{id: a, find: acceleration of x}]
"""
    found = fb.System.from_text(model).sweep({"mu": "0.1..1:10", "theta": "15, 30, 45 deg"})
    mu, theta = np.meshgrid(np.linspace(0.1, 1, 10), np.radians([15, 30, 45]), indexing="ij")
    slides = np.tan(theta) > mu
    expected = np.where(slides, 10 * (np.sin(theta) - mu * np.cos(theta)), 0.0)
    known = ~np.isclose(np.tan(theta), mu)
    np.testing.assert_allclose(found.values("a")[known], expected[known], rtol=1e-13, atol=1e-13)


def test_outside_of_a_formula_the_numeric_route_answers() -> None:
    """The crank of a slider-crank beyond what can be assembled, and a question whose formula nobody knows."""
    found = example("slider_crank").sweep({"l": "0.05, 0.2, 0.4 m"}, find=["rod"])
    r, length = 0.1, np.array([0.05, 0.2, 0.4])
    with np.errstate(invalid="ignore"):
        np.testing.assert_allclose(found.values("rod"), -r / np.sqrt(4 * length**2 - 3 * r**2), rtol=1e-12)
    assert list(found.status("rod")) == ["cannot be assembled", "formula", "formula"]


def test_a_sign_that_the_model_excludes_is_a_status() -> None:
    found = example("atwood_machine").sweep(
        {"m1": "-1, 0, 1 kg"}, find=["acceleration"], record=["final x1"], until=0.5
    )
    for of in ("acceleration", "motion"):
        assert [str(x) for x in found.status(of)][:2] == ["not admissible"] * 2
    assert "positive" in found.failures[0].why


def test_a_value_that_the_reader_of_a_model_refuses_is_a_status() -> None:
    """A coefficient of restitution above one: no formula is evaluated there."""
    found = example("bouncing_ball").sweep({"e": "0.5, 1, 1.2"}, find=["time"], record=["end"], until=0.1)
    for of in ("time", "motion"):
        assert [str(x) == "not admissible" for x in found.status(of)] == [False, False, True]
    assert "restitution" in found.failures[0].why


def test_a_condition_at_every_pose_is_judged_at_the_start_that_is_asked_for() -> None:
    """Omega = sqrt(g/(L cos theta)) of a conical pendulum, by hand from m L sin(theta) Omega^2 = S sin(theta) and
    S cos(theta) = m g, where it hangs below its pivot: `cos(theta) > 0`, with theta = beta at the start."""
    beta = np.radians([20.0, 50.0, 80.0, 100.0])
    with np.errstate(invalid="ignore"):
        expected = np.sqrt(9.81 / (1.2 * np.cos(beta)))
    for name in ("beta", "theta"):  # the parameter, and the measure whose start it is
        found = example("conical_pendulum").sweep({name: "20, 50, 80, 100 deg"}, find=["rate"])
        np.testing.assert_allclose(found.values("rate"), expected, rtol=1e-12)
        assert [str(x) for x in found.status("rate")] == ["formula", "formula", "formula", "outside"]
        (failure,) = found.failures
        assert "cos(θ) > 0 (as at the start) is not true there" in failure.why


def test_a_condition_in_a_rate_leaves_a_case_without_a_value() -> None:
    """Of steady motion at no instant that is said: that is not broken, and not known."""
    found = example("spinning_top").sweep({"m": "0.4, 0.5 kg"}, find=["steady"])
    assert found.counts == {"steady": {"no value": 2}}


def test_a_start_value_varies_as_a_parameter_does() -> None:
    """A pendulum let go at theta reaches the lowest place with sqrt(2 g (1 - cos theta)/L)."""
    angles = np.radians([-60.0, 20.0, 120.0])
    found = example("simple_pendulum").sweep({"theta": "-60, 20, 120 deg"}, find=["tension", "equation"])
    np.testing.assert_allclose(found.values("tension"), 9.81 * np.cos(angles), rtol=1e-12)
    np.testing.assert_allclose(found.values("equation"), -9.81 * np.sin(angles), rtol=1e-12)


def test_what_is_driven_is_gone_over() -> None:
    """x = r cos(psi) + sqrt(l^2 - r^2 sin(psi)^2) of a slider-crank, in every place of its crank."""
    found = example("driven_slider_crank").sweep(
        over={"theta": "0..360 deg"}, vary={"r": "0.04, 0.05 m"}, find=["place"]
    )
    assert dict(found.plan.dimensions) == {"r": 2, "theta": 73}
    r, psi = np.meshgrid([0.04, 0.05], np.linspace(0, 2 * math.pi, 73), indexing="ij")
    np.testing.assert_allclose(
        found.values("place"), r * np.cos(psi) + np.sqrt(0.2**2 - (r * np.sin(psi)) ** 2), rtol=1e-9
    )


# -- motions ----------------------------------------------------------------------------------
def test_motions_of_a_sweep_are_those_that_are_simulated_alone() -> None:
    system = example("simple_pendulum")
    found = system.sweep(
        {"L": "0.5, 1.5 m"},
        record=[
            "final theta",
            "maximum of theta_rate",
            "time when theta = 0",
            "theta at 0.3 s",
            "minimum of rod.tension",
        ],
        until=1.0,
    )
    for k, length in enumerate((0.5, 1.5)):
        alone = system.with_parameters(L=length).simulate(1.0, events=["theta = 0"])
        series = alone.recording.series
        assert found.values("final theta")[k] == pytest.approx(float(series["theta"].values[-1]), rel=1e-9)
        assert found.values("time when theta = 0")[k] == pytest.approx(alone.events[0].time, rel=1e-9)
        assert found.values("minimum of rod.tension")[k] == pytest.approx(
            float(series["rod.tension"].values.min()), rel=1e-6
        )
        least = float(np.interp(0.3, alone.course.times, series["theta"].values))
        assert found.values("theta at 0.3 s")[k] == pytest.approx(least, abs=1e-5)


def test_the_maximum_of_a_measure_lies_between_output_times_as_well() -> None:
    """v0^2/(2 g) of a throw, with eleven output times."""
    model = """
parameters: {m: 1 kg, g: 9.81 m/s^2, v0: 4 m/s}
bodies: {ball: {particle: {mass: m}}}
loads: {weight: {gravity: g}}
measures: {y: y of ball}
start: {y: 0, rate(y): v0}
"""
    found = fb.System.from_text(model).sweep({"v0": "3, 4, 5 m/s"}, record=["maximum of y"], until=1.5, every=0.15)
    np.testing.assert_allclose(found.values("maximum of y"), np.array([9, 16, 25]) / (2 * 9.81), rtol=1e-12)


def test_the_event_of_a_contact_has_the_words_of_a_simulation() -> None:
    found = example("bouncing_ball").sweep({"h": "1, 2 m"}, record=["time when ball hits floor"], until=1.0)
    np.testing.assert_allclose(
        found.values("time when ball hits floor"), np.sqrt(2 * np.array([1, 2]) / 9.81), rtol=1e-9
    )


# -- the same bits ----------------------------------------------------------------------------
def test_results_are_the_same_bit_for_bit_however_cases_are_divided() -> None:
    system = example("simple_pendulum")
    asked: dict[str, Any] = {"find": ["tension", "lowest_speed"], "record": ["final theta"], "until": 0.2}
    vary = {"theta_0": "5..85 deg", "L": "normal(1 m, 5 %)"}
    digests = {
        system.sweep(vary, sample="lhs:100", threads=threads, block=block, **asked).digest
        for threads, block in ((1, 4096), (2, 64), (3, 100))
    }
    assert len(digests) == 1
    assert system.sweep(vary, sample="lhs:100", seed=1, **asked).digest not in digests


@pytest.mark.parametrize("sample", ["sobol:2048", "lhs:1500", "random:2500", "grid"])
def test_cases_hang_on_their_number_alone(sample: str) -> None:
    vary = {"m1": "1..3 kg:30", "M": "0.5, 1 kg"} if sample == "grid" else {"m1": "1..3 kg", "M": "normal(1 kg, 10 %)"}
    plan = example("atwood_machine").sweep(vary, find=["acceleration"], sample=sample).plan
    whole, n = plan.cases(0, plan.n), plan.n
    for a, b in ((0, 1), (7, n // 2), (n // 2, n), (n - 1, n)):
        np.testing.assert_array_equal(plan.cases(a, b), whole[a:b])


def test_samples_have_the_distributions_that_were_asked_for() -> None:
    vary = {
        "m1": "normal(2 kg, 5 %)",
        "m2": "uniform(1 kg, 3 kg)",
        "M": "lognormal(2 kg, 10 %)",
        "R": "triangular(0.1 m, 0.2 m, 0.4 m)",
    }
    x = example("atwood_machine").sweep(vary, find=["acceleration"], sample="sobol:4096").plan.cases(0, 4096)
    np.testing.assert_allclose(x.mean(axis=0), [2, 2, 2 * math.exp(0.005), 0.7 / 3], rtol=2e-3)
    spread = math.sqrt((0.01 + 0.04 + 0.16 - 0.02 - 0.04 - 0.08) / 18)
    np.testing.assert_allclose(x.std(axis=0)[[0, 1, 3]], [0.1, 1 / math.sqrt(3), spread], rtol=5e-3)


def test_the_error_of_a_mean_is_told_of_random_cases() -> None:
    found = example("atwood_machine").sweep({"m1": "uniform(1 kg, 3 kg)"}, find=["acceleration"], sample="random:2000")
    told = found.to_plain()["found"]["acceleration"]
    x = found.values("acceleration")
    assert told["error_of_mean"] == pytest.approx(x.std(ddof=1) / math.sqrt(2000), rel=1e-12)
    exact = 9.81 * (1 - 4.5 / 2 * math.log(5.5 / 3.5))  # the mean of 1 - 2 (2.25)/(m + 2.5), m from 1 to 3
    assert abs(told["mean"] - exact) < 4 * told["error_of_mean"]


def test_statistics_do_not_hang_on_how_numbers_are_divided() -> None:
    x = np.random.default_rng(5).normal(1e6, 1.0, 1000)
    one, parts = statistics([x]), statistics([x[:10], np.array([math.nan]), x[10:]])
    assert (one.n, one.least, one.greatest) == (parts.n, parts.least, parts.greatest)
    assert parts.mean == pytest.approx(one.mean, rel=1e-14)
    assert parts.deviation == pytest.approx(float(x.std(ddof=1)), rel=1e-9)


# -- files ------------------------------------------------------------------------------------
def test_every_format_has_the_same_numbers(tmp_path: Path) -> None:
    xarray = pytest.importorskip("xarray")
    pandas = pytest.importorskip("pandas")
    paths = [tmp_path / f"a{suffix}" for suffix in (".nc", ".zarr", ".csv", ".parquet")]
    asked = ["tension", "acceleration"]
    found = example("atwood_machine").sweep({"m1": "1..3 kg:5", "M": "0.5, 1 kg"}, find=asked, out=paths)
    assert found.files == tuple(paths)
    assert not list(tmp_path.glob("*.part"))
    expected = found.values("tension")
    np.testing.assert_array_equal(found.values("acceleration")[2], 0.0)  # of equal weights: no missing value
    for data in (xarray.open_dataset(paths[0]), xarray.open_zarr(paths[1]), found.dataset):
        for name in asked:
            np.testing.assert_array_equal(data[name].values, found.values(name))
        assert data["tension"].dims == ("m1", "M")
        assert data["m1"].attrs["units"] == "kg"
        assert "formula" in data["tension.status"].attrs["flag_meanings"]
        data.close()
    with paths[2].open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert [float(row["tension [N]"]) for row in rows] == list(expected.ravel())
    assert rows[0]["tension.status"] == "formula"
    np.testing.assert_array_equal(pandas.read_parquet(paths[3])["tension [N]"], expected.ravel())


def test_cases_of_a_table_have_the_units_of_its_head(tmp_path: Path) -> None:
    table = tmp_path / "cases.csv"
    table.write_text("m1 [g],M\n1000,0.5\n3000,1\n", encoding="utf-8")
    found = example("atwood_machine").sweep(sample=str(table), find=["acceleration"])
    np.testing.assert_array_equal(found.values("m1"), [1.0, 3.0])
    np.testing.assert_allclose(found.values("acceleration"), [-9.81 / 3.25, 9.81 / 5.5], rtol=1e-15)


def test_a_sweep_goes_on_where_it_was_interrupted(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    system, out = example("simple_pendulum"), tmp_path / "a.csv"
    asked: dict[str, Any] = {"vary": {"L": "0.5..1.5 m:130"}, "record": ["final theta"], "until": 0.1}
    whole = system.sweep(**asked)
    look, seen = running.Block._look, 0

    def interrupted(self: Any, job: Any) -> Any:
        nonlocal seen
        seen += len(job)
        if seen > 80:
            raise KeyboardInterrupt
        return look(self, job)

    monkeypatch.setattr(running.Block, "_look", interrupted)
    part = system.sweep(**asked, out=out, block=64)
    assert 64 <= part.n_done < 130
    assert not part.is_complete
    assert not out.exists()
    with pytest.raises(InputError, match="--resume"):
        system.sweep(**asked, out=out)
    monkeypatch.setattr(running.Block, "_look", look)
    with pytest.raises(InputError, match="other values, results"):
        system.sweep({"L": "0.5..1.6 m:130"}, record=["end"], until=0.1, out=out, resume=True)
    with pytest.raises(InputError, match="other settings"):
        system.sweep(**{**asked, "until": 0.2}, out=out, resume=True)
    with pytest.raises(InputError, match="other model"):
        system.with_parameters(g=9.0).sweep(**asked, out=out, resume=True)
    looked: list[int] = []

    def counted(self: Any, job: Any) -> Any:
        looked.extend(i for i, _which in job)
        return look(self, job)

    monkeypatch.setattr(running.Block, "_look", counted)
    rest = system.sweep(**asked, out=out, resume=True)
    assert len(looked) == 130 - part.n_done
    assert rest.digest == whole.digest
    assert out.exists()
    assert not list(tmp_path.glob("*.part"))


def test_a_killed_sweep_goes_on_to_the_same_digest(tmp_path: Path) -> None:
    out = tmp_path / "a.csv"
    words = ["sweep", str(EXAMPLES / "simple_pendulum.yaml"), "--vary", "L=0.5..1.5 m:200", "--record", "final theta"]
    words += ["--until", "2", "--json", "-o", str(out)]
    process = subprocess.Popen([sys.executable, "-m", "freebody", *words], stdout=subprocess.DEVNULL)
    done = tmp_path / "a.csv.part" / "done.bin"
    until = time.monotonic() + 60.0
    while not (done.exists() and done.read_bytes().count(1)) and process.poll() is None and time.monotonic() < until:
        time.sleep(0.05)
    os.kill(process.pid, signal.SIGKILL)
    process.wait()
    n_done = done.read_bytes().count(1)
    assert 0 < n_done < 200
    told = json.loads(freebody(*words, "--resume", "--threads", "2").stdout)
    assert told["done"] == 200
    whole = example("simple_pendulum").sweep({"L": "0.5..1.5 m:200"}, record=["final theta"], until=2.0)
    assert told["digest"] == whole.digest


# -- charts -----------------------------------------------------------------------------------
def test_the_regions_of_a_chart_are_those_of_the_conditions() -> None:
    """A sphere rolls where mu > 2 tan(theta)/7: the coloured cells of that region have its share of the area."""
    found = example("sphere_launched_down_incline").sweep(
        {"mu": "0.05..0.5:19", "theta": "5..50 deg:10"}, find=["time"]
    )
    mu, theta = np.meshgrid(np.linspace(0.05, 0.5, 19), np.radians(np.linspace(5, 50, 10)), indexing="ij")
    picture = found.chart("time", "regions")
    colors: dict[int, float] = {}
    for shape in picture.shapes:
        if shape.fill is not None and shape.points.min() >= -1e-9:  # not of the legend
            width, height = np.ptp(shape.points, axis=0)
            colors[shape.fill.body] = colors.get(shape.fill.body, 0.0) + width * height
    share = colors[0] / sum(colors.values())
    assert share == pytest.approx(np.mean(mu > 2 / 7 * np.tan(theta)), abs=1e-9)
    assert [word.label.text for word in picture.words if word.at[1] < -30] == ["formula", "outside"]


def test_a_curve_runs_through_its_values_and_has_gaps_where_there_are_none() -> None:
    curves = [("a", np.array([0.0, 1.0, math.nan, 3.0, 2.0]))]
    picture = line_chart("t", "x", np.arange(5.0), "y", curves)
    runs = [shape.points for shape in picture.shapes if shape.stroke is not None and shape.stroke.color == "body"]
    assert [len(run) for run in runs] == [2, 2]
    np.testing.assert_allclose(runs[0], [(0, 0), (WIDTH / 4, HEIGHT / 3)])
    np.testing.assert_allclose(runs[1][:, 1], [HEIGHT, HEIGHT * 2 / 3])


def test_round_numbers_of_an_axis_lie_in_it() -> None:
    for low, high in ((0.0, 1.0), (-3.2, 7.9), (1e-7, 3e-7), (2.0, 2.0), (1e9, 1.7e9)):
        scale = Scale.of("x", np.array([low, high, math.nan]))
        assert 2 <= len(scale.ticks) <= 8
        assert scale.ticks[0] >= scale.low - 1e-9 * abs(scale.high)
        assert scale.ticks[-1] <= scale.high * (1 + 1e-9)


@pytest.mark.parametrize(
    ("vary", "sample", "kind"),
    [
        ({"m1": "1..3 kg:5"}, None, "line"),
        ({"m1": "1..3 kg:5", "M": "1, 2 kg"}, None, "heat"),
        ({"m1": "1..3 kg", "M": "1..2 kg"}, "lhs:30", "parallel"),
        ({"m1": "1..3 kg"}, "lhs:30", "line"),
    ],
)
def test_every_chart_is_written_in_every_format(vary: Any, sample: str | None, kind: str, tmp_path: Path) -> None:
    found = example("atwood_machine").sweep(vary, sample=sample, find=["tension"])
    for suffix in (".svg", ".png", ".pdf", ".tex"):
        assert found.chart("tension", kind).write(tmp_path / f"a{suffix}").stat().st_size > 500
    assert found.to_html().count("<figure") == 1
    assert "tension" in found.chart().description


# -- bad input --------------------------------------------------------------------------------
@pytest.mark.parametrize(
    ("asked", "said"),
    [
        ({"vary": {}}, "nothing varies"),
        ({"vary": {"mass": "1..3 kg:5"}}, "mass is no parameter, no named measure and no state"),
        ({"vary": {"m1": "1..3 m:5"}}, "m1 is in kg; 1 m is not"),
        ({"vary": {"m1": "1..3:5"}}, "m1 is in kg; 1 is not"),
        ({"vary": {"m1": "1..3 kg"}}, "say how many"),
        ({"vary": {"m1": "1..3 kg:0"}}, "between 1 and"),
        ({"vary": {"m1": ""}}, "there are no values"),
        ({"vary": {"m1": []}}, "there are no values"),
        ({"vary": {"m1": "much"}}, "cannot read how it varies"),
        ({"vary": {"m1": "normal(2 kg)"}}, "normal takes 2 numbers"),
        ({"vary": {"m1": "normal(2 kg, -1 kg)"}}, "must be positive"),
        ({"vary": {"m1": "uniform(3 kg, 1 kg)"}}, "must rise"),
        ({"vary": {"w": "0..360:5"}}, "has no unit: write 360 deg"),
        ({"vary": {"m1": "1..3 kg"}, "sample": "sobol:100"}, "sobol:64 or sobol:128"),
        ({"vary": {"m1": "1..3 kg"}, "sample": "lhs:many"}, "no number of cases"),
        ({"vary": {"m1": "1..3 kg"}, "sample": "halton:9"}, "no such choice of cases"),
        ({"vary": {"m1": "1..3 kg:5"}, "over": {"m1": "1..3 kg:5"}}, "varied twice"),
        ({"vary": {"m1": "1..3 kg:5"}, "find": ["the colour of left"]}, "nothing that is found of a body"),
        ({"vary": {"m1": "1..3 kg:5"}, "record": ["final x1"]}, "how long is the motion"),
        ({"vary": {"m1": "1..3 kg:5"}, "record": ["final x3"], "until": 1.0}, "cannot be recorded"),
        ({"vary": {"m1": "1..3 kg:5"}, "record": ["time when rope tears"], "until": 1.0}, "no contact does that"),
        ({"vary": {"m1": "1..3 kg:5"}, "record": ["end", "end"], "until": 1.0}, "stand twice"),
        ({"vary": {"m1": "1..3 kg:5"}, "threads": 0}, "threads"),
        ({"vary": {"m1": "1..3 kg:5"}, "out": "a.doc"}, "for data, .csv, .nc, .parquet, .zarr"),
        ({"vary": {"m1": "1..3 kg:5"}, "out": "/nowhere/a.csv"}, "no folder"),
        ({"vary": {"m1": "1..3 kg:5"}, "out": "a.html", "resume": True}, "only a sweep with a file"),
        ({"vary": {"m1": "1..3 kg:5"}, "resume": True}, "only a sweep with a file"),
        ({"sample": "table:/nowhere.csv"}, "cannot be read"),
    ],
)
def test_bad_input_is_told_before_anything_is_computed(asked: dict[str, Any], said: str) -> None:
    with pytest.raises(InputError) as caught:
        example("atwood_machine").sweep(**asked)
    assert said in str(caught.value)


def test_a_full_disk_is_told_with_the_size_of_what_is_missing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(_descriptor: int, _start: int, _size: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "posix_fallocate", full, raising=False)
    with pytest.raises(InputError, match=r"take 9\.?\d* MB.*disk is full|the disk is full"):
        example("atwood_machine").sweep({"m1": "1..3 kg:9"}, find=["tension"], out=tmp_path / "a.csv")
    assert not list(tmp_path.iterdir())


@pytest.mark.skipif(sys.platform == "win32", reason="files cannot be kept short there")
@pytest.mark.parametrize("suffix", [".csv", ".parquet"])
def test_results_that_have_no_room_in_their_file_are_kept(suffix: str, tmp_path: Path) -> None:
    """Twenty thousand cases in a process whose files end at 200 kB: the folder of 160 kB is there, the file is not."""
    model, out = str(EXAMPLES / "atwood_machine.yaml"), tmp_path / f"a{suffix}"
    words = ["sweep", model, "--vary", "m1=1..3 kg:20000", "--find", "tension", "--json", "-o", str(out)]
    short = "import resource, sys; resource.setrlimit(resource.RLIMIT_FSIZE, (200_000, 200_000)); "
    program = f"{short}from freebody.cli import main; sys.argv = ['freebody', *{words!r}]; main()"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert done.returncode == 2
    said = " ".join(done.stderr.split())
    assert "cannot be written" in said
    assert "--resume goes on" in said
    assert [path.name for path in tmp_path.iterdir()] == [f"a{suffix}.part"]
    told = json.loads(freebody(*words, "--resume").stdout)
    assert (told["done"], told["files"]) == (20_000, [str(out)])


@pytest.mark.parametrize("name", ["numbers", "statuses", "done"])
def test_results_of_which_a_part_is_lost_are_not_gone_on_with(name: str, tmp_path: Path) -> None:
    """A file that is too short would be filled up with zeros, which are numbers."""

    def interrupted(_done: int, _n: int) -> None:
        raise KeyboardInterrupt

    asked: dict[str, Any] = {"vary": {"m1": "1..3 kg:200"}, "find": ["tension"], "block": 64, "out": tmp_path / "a.csv"}
    system = example("atwood_machine")
    assert not system.sweep(**asked, progress=interrupted).is_complete
    path = tmp_path / "a.csv.part" / f"{name}.bin"
    path.write_bytes(path.read_bytes()[:100])
    with pytest.raises(InputError, match=r"a\.csv\.part is no sweep that could go on: remove it and begin anew"):
        system.sweep(**asked, resume=True)


def test_memory_is_that_of_a_block_not_that_of_the_sweep(tmp_path: Path) -> None:
    """Twice as many cases, the same peak of what is allocated; the results themselves are mapped from a file."""

    def peak(n: int) -> int:
        tracemalloc.start()
        example("atwood_machine").sweep(
            {"m1": "1..3 kg"}, sample=f"random:{n}", find=["tension"], out=tmp_path / f"{n}.zarr"
        )
        found = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
        return found

    pytest.importorskip("zarr")
    peak(64)  # what is made once
    assert peak(2**18) <= 1.1 * peak(2**17)  # more than one part is looked at in both


def test_another_version_of_the_program_does_not_go_on_with_a_sweep(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def interrupted(_done: int, _n: int) -> None:
        raise KeyboardInterrupt

    system, out = example("simple_pendulum"), tmp_path / "a.csv"
    asked: dict[str, Any] = {"vary": {"L": "0.5..1.5 m:99"}, "record": ["end"], "until": 0.1, "out": out}
    assert not system.sweep(**asked, progress=interrupted).is_complete
    monkeypatch.setattr(sweep_module, "version", lambda _name: "0.0.1")
    with pytest.raises(InputError, match="begun with other version of the program"):
        system.sweep(**asked, resume=True)


def test_netcdf_is_not_begun_where_it_has_no_room(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The library brings the interpreter down on a full disk, when it closes its file."""
    pytest.importorskip("h5netcdf")
    found = example("atwood_machine").sweep({"m1": "1..3 kg:9"}, find=["tension"])

    def full(_descriptor: int, _start: int, _size: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "posix_fallocate", full, raising=False)
    with pytest.raises(InputError, match=r"a\.nc cannot be written: No space left"):
        found.write(tmp_path / "a.nc")
    assert not list(tmp_path.iterdir())


def test_the_command_prints_one_document_and_writes_its_files(tmp_path: Path) -> None:
    model, out = str(EXAMPLES / "atwood_machine.yaml"), tmp_path / "a.csv"
    done = freebody(
        "sweep", model, "--vary", "m1=1..3kg:50", "--set", "M=2 kg", "--find", "tension", "--json", "-o", str(out)
    )
    told = json.loads(done.stdout)
    assert (told["cases"], told["statuses"]) == (50, {"tension": {"formula": 50}})
    assert told["files"] == [str(out)]
    assert len(told["digest"]) == 64
    assert len(out.read_text(encoding="utf-8").splitlines()) == 51
