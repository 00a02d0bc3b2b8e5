"""Parameters from measured motions: closed forms give the data, linear regression the errors."""

from __future__ import annotations

import csv
import json
import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.stats import t as student

import freebody as fb
from command import freebody
from freebody.errors import CannotAnswer, InputError

OSCILLATOR = """
parameters: {m: 1 kg, k: 30 N/m, c: 1 N s/m}
ground: {lines: {floor: {along: right}}}
bodies: {cart: {particle: {mass: m}}}
connections: {guide: {slider: {body: cart, along: floor}}}
loads:
  spring: {law: {measure: x, force: -k*x}}
  damper: {law: {measure: x, force: -c*rate(x)}}
measures: {x: x of cart}
start: {x: 0.1 m, rate(x): 0}
"""
THROW = """
parameters: {m: 1 kg, g: 9.81 m/s^2}
bodies: {ball: {particle: {mass: m}}}
loads: {weight: {gravity: g}}
measures: {y: y of ball}
start: {y: 0 m, rate(y): 3 m/s}
"""


def written(path: Path, columns: Mapping[str, Any]) -> Path:
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(columns)
        cells = [
            ["" if isinstance(x, float) and math.isnan(x) else x for x in map(float, of)] for of in columns.values()
        ]
        writer.writerows(zip(*cells, strict=True))
    return path


def decay(t: Any, m: float, k: float, c: float, x0: float = 0.1) -> Any:
    """x of a damped oscillator let go at x0: e^(-d t) (cos w t + d/w sin w t) x0."""
    d = c / (2 * m)
    w = math.sqrt(k / m - d * d)
    return x0 * np.exp(-d * t) * (np.cos(w * t) + d / w * np.sin(w * t))


def test_parameters_of_an_oscillator_come_back_from_its_closed_form(tmp_path: Path) -> None:
    """Two runs, unequal times, millimetres, a missing value, an offset; each run has its own start."""
    system, rng = fb.System.from_text(OSCILLATOR), np.random.default_rng(2)
    times = [np.sort(rng.uniform(0, 3, n)) for n in (25, 17)]
    files = []
    for k, (t, x0) in enumerate(zip(times, (0.1, 0.25), strict=True)):
        x = 1e3 * (decay(t, 1.0, 40.0, 0.8, x0) + 0.02)
        x[3] = math.nan
        files.append(written(tmp_path / f"{k}.csv", {"t [s]": t, "x [mm]": x}))
    found = system.fit(files, ["c", "k", "x", "offset(x)"])
    expected = {"c": 0.8, "k": 40.0, "x of run 1": 0.1, "x of run 2": 0.25, "offset(x)": 0.02}
    assert found.values == pytest.approx(expected, rel=1e-6)
    assert found.is_complete
    assert found.n_data == 40
    assert found.fitted.parameters["k"].value == pytest.approx(40.0, rel=1e-6)
    for r in found.residuals:
        assert r.rms < 1e-8


@pytest.mark.parametrize("is_weighted", [False, True])
def test_errors_of_what_is_linear_are_those_of_linear_regression(tmp_path: Path, is_weighted: bool) -> None:
    """y0 + v0 t - g t^2/2 is linear in y0, v0 and g: values, errors and correlation by the normal equations."""
    rng = np.random.default_rng(8)
    t = np.sort(rng.uniform(0.0, 1.0, 30))
    sigma = np.where(t < 0.5, 0.002, 0.01) if is_weighted else np.ones(30)
    y = 0.1 + 3.2 * t - 9.7 * t**2 / 2 + rng.normal(0, 0.005, 30)
    columns: dict[str, Any] = {"t [s]": t, "y [m]": y} | ({"sigma(y) [m]": sigma} if is_weighted else {})
    found = fb.System.from_text(THROW).fit(written(tmp_path / "a.csv", columns), ["g", "rate(y)", "y"])
    A = np.column_stack((-(t**2) / 2, t, np.ones(30))) / sigma[:, None]
    best, *_ = np.linalg.lstsq(A, y / sigma, rcond=None)
    left = A @ best - y / sigma
    covariance = left @ left / 27 * np.linalg.inv(A.T @ A)
    spread = np.sqrt(np.diag(covariance))
    np.testing.assert_allclose(found.found, best, rtol=1e-7)
    np.testing.assert_allclose(found.estimate.errors, student.ppf(0.975, 27) * spread, rtol=1e-5)
    np.testing.assert_allclose(found.estimate.correlation, covariance / np.outer(spread, spread), atol=1e-5)


def test_what_the_data_cannot_tell_is_said_by_name(tmp_path: Path) -> None:
    """A free oscillation tells k/m and c/m, and nothing of m: the three change together by one per cent."""
    t = np.linspace(0, 3, 40)
    file = written(tmp_path / "a.csv", {"t": t, "x": decay(t, 1.0, 40.0, 0.8)})
    found = fb.System.from_text(OSCILLATOR).fit(file, ["m", "k", "c"])
    (told,) = found.estimate.combinations
    assert all(f"{name} by 1 %" in told for name in ("m", "k", "c"))
    assert not found.is_complete
    assert set(found.errors.values()) == {math.inf}
    values = found.values
    assert values["k"] / values["m"] == pytest.approx(40.0, rel=1e-6)
    assert values["c"] / values["m"] == pytest.approx(0.8, rel=1e-6)


def test_an_unknown_without_a_trace_leaves_the_others_their_errors(tmp_path: Path) -> None:
    """The mass of what falls freely leaves no trace."""
    t = np.linspace(0, 1, 12)
    y = 3 * t - 9.7 * t**2 / 2 + 1e-3 * np.sin(40 * t)
    found = fb.System.from_text(THROW).fit(written(tmp_path / "a.csv", {"t": t, "y": y}), ["g", "m"])
    assert found.estimate.combinations == ("the data tell nothing of m",)
    assert found.errors["m"] == math.inf
    assert 0 < found.errors["g"] < 0.1


def test_a_positive_parameter_stays_so(tmp_path: Path) -> None:
    """Data of a growing motion ask for a negative damping, which the model excludes: the bound is named."""
    t = np.linspace(0, 2, 30)
    file = written(tmp_path / "a.csv", {"t": t, "x": 0.1 * np.exp(0.1 * t) * np.cos(math.sqrt(30) * t)})
    found = fb.System.from_text(OSCILLATOR).fit(file, ["c", "k"])
    assert 0 < found.values["c"] < 1e-4
    assert found.at_bound == ("c",)


@pytest.mark.parametrize(
    ("columns", "free", "said"),
    [
        ({"x [m]": [1.0, 2.0]}, ["k"], "no column t"),
        ({"t": [0.0, 1.0], "z": [1.0, 2.0]}, ["k"], "the motion has no z"),
        ({"t": [0.0, 1.0], "x [kg]": [1.0, 2.0]}, ["k"], "x is in m, not in kg"),
        ({"t [m]": [0.0, 1.0], "x": [1.0, 2.0]}, ["k"], "t is in s, not in m"),
        ({"t": [-1.0, 1.0], "x": [1.0, 2.0]}, ["k"], "from the start of the motion on"),
        ({"t": [0.0, 1.0], "x": [math.nan, math.nan]}, ["k"], "no measured values"),
        ({"t": [0.0, 1.0], "x": [1.0, 2.0], "sigma(x)": [1.0, 0.0]}, ["k"], "must be positive"),
        ({"t": [0.0, 1.0], "x": [1.0, 2.0]}, ["k", "c", "m"], "2 measured values cannot tell 3 unknowns"),
        ({"t": [0.0, 1.0], "x": [1.0, 2.0]}, ["stiffness"], "stiffness is no parameter"),
        ({"t": [0.0, 1.0], "x": [1.0, 2.0]}, ["offset(y)"], "nothing is measured of y"),
        ({"t": [0.0, 1.0], "x": [1.0, 2.0]}, [], "nothing is free"),
    ],
)
def test_bad_data_are_told_by_file_and_name(columns: Any, free: list[str], said: str, tmp_path: Path) -> None:
    system = fb.System.from_text(OSCILLATOR)
    with pytest.raises(InputError) as caught:
        system.fit(written(tmp_path / "a.csv", columns), free)
    assert said in str(caught.value)


def test_a_motion_that_cannot_begin_is_told(tmp_path: Path) -> None:
    file = written(tmp_path / "a.csv", {"t": [0.0, 0.1], "theta": [1.0, 1.1]})
    model = (Path(__file__).parents[1] / "examples" / "slider_crank.yaml").read_text(encoding="utf-8")
    with pytest.raises(CannotAnswer):
        fb.System.from_text(model).with_parameters(l="0.01 m").fit(file, ["T"])


def test_the_command_tells_values_errors_and_what_is_left(tmp_path: Path) -> None:
    model, t = tmp_path / "model.yaml", np.linspace(0, 2, 30)
    model.write_text(OSCILLATOR, encoding="utf-8")
    file = written(tmp_path / "a.csv", {"t [s]": t, "x [m]": decay(t, 1.0, 40.0, 0.8)})
    page, plot = tmp_path / "a.html", tmp_path / "a.svg"
    done = freebody("fit", str(model), str(file), "--free", "c,k", "-o", str(page), "--plot", str(plot))
    assert done.returncode == 0, done.stderr
    told = json.loads(freebody("fit", str(model), str(file), "--free", "c,k", "--json").stdout)
    assert told["unknowns"]["k"]["value"] == pytest.approx(40.0, rel=1e-6)
    assert told["unknowns"]["k"]["unit"] == "N/m"
    assert page.read_text(encoding="utf-8").count("<figure") == 1
    assert plot.read_text(encoding="utf-8").count("<path") > 30


BOUNCE = """
parameters: {m: 0.2 kg, h: 1 m, e: 0.8, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {ball: {particle: {mass: m}, at: [0, h]}}
connections: {contact: {contact: {between: [ball, floor], restitution: e}}}
loads: {weight: {gravity: g}}
measures: {y: {height of ball}}
start: {y: h}
"""


def bounced(t: float, h: float, e: float, g: float) -> float:
    """Height of a ball let go at h: flights of 2 e^i sqrt(2 h/g) between bounces."""
    first = math.sqrt(2 * h / g)
    if t < first:
        return h - g * t * t / 2
    since, speed = t - first, e * g * first
    while since > 2 * speed / g:
        since, speed = since - 2 * speed / g, e * speed
    return speed * since - g * since * since / 2


def test_a_ball_that_rebounds_tells_its_restitution_by_exact_derivatives(tmp_path: Path) -> None:
    t = np.linspace(0.05, 2.2, 60)
    data = written(tmp_path / "bounce.csv", {"t [s]": t, "y [m]": [bounced(x, 0.93, 0.77, 9.81) for x in t]})
    found = fb.System.from_text(BOUNCE).fit(data, ["h", "e"])
    assert found.values == pytest.approx({"h": 0.93, "e": 0.77}, rel=1e-8)
    assert not found.why_differences


def test_exact_derivatives_save_motions_and_say_the_same(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """With three unknowns every Jacobian of differences takes six motions, an exact one takes one."""
    system, rng = fb.System.from_text(OSCILLATOR), np.random.default_rng(5)
    t = np.linspace(0.0, 3.0, 80)
    x = decay(t, 1.0, 33.0, 1.2) + rng.normal(0.0, 1e-3, len(t))
    data = written(tmp_path / "swing.csv", {"t [s]": t, "x [m]": x})
    exact = system.fit(data, ["k", "c", "x"])
    assert exact.n_tangents > 0

    def refuse(*_of: Any) -> Any:
        raise CannotAnswer("for comparison")

    monkeypatch.setattr("freebody.study.fitting.fit.MotionTangents", refuse)
    near = system.fit(data, ["k", "c", "x"])
    assert near.why_differences == "for comparison"
    assert "for comparison" in str(near)
    assert exact.values == pytest.approx(near.values, rel=1e-7)
    assert exact.errors == pytest.approx(near.errors, rel=1e-5)
    assert exact.n_motions + exact.n_tangents < near.n_motions / 2


GALILEO = [33, 130, 298, 526, 824, 1192, 1620, 2104]  # punti of 29/30 mm after 1 to 8 times of 0.55 s


def test_a_table_of_galileo_tells_the_slope_of_his_plane(tmp_path: Path) -> None:
    """Ms. Gal. 72, f. 107v, in the units of Drake, Galileo at Work, 1978, ch. 5, who finds 1.7 degrees. A ball rolls by
    s = (5/14) g sin(alpha) t^2, so that linear regression gives sin(alpha) = (14/5) sum(s t^2)/(g sum(t^4))."""
    t, s = 0.55 * np.arange(1, 9), np.array(GALILEO) * 0.029 / 30
    table = written(tmp_path / "galileo.csv", {"t [s]": t, "s [m]": s})
    system = fb.System.from_text("""
parameters: {m: 0.1 kg, r: 10 mm, alpha: 2 deg, g: 9.81 m/s^2}
ground: {lines: {slope: {along: -alpha}}}
bodies: {ball: {sphere: {mass: m, radius: r}}}
connections: {rolls: {rolling: {body: ball, on: slope}}}
loads: {weight: {gravity: g}}
measures: {s: travel of ball along slope}
start: {s: 0, rate(s): 0}
""")
    found = system.fit(table, ["alpha"])
    assert math.sin(found.values["alpha"]) == pytest.approx(14 / 5 * (s @ t**2) / (9.81 * (t**4).sum()), rel=1e-8)
    assert math.degrees(found.values["alpha"]) == pytest.approx(1.7, abs=0.05)
    both = system.fit(table, ["alpha", "g"])
    assert math.isnan(both.estimate.errors[0]) or math.isinf(both.estimate.errors[0])
