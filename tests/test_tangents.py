"""Exact derivatives of motions, beside closed forms by hand and differences of motions followed very exactly."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest

import freebody as fb
from freebody.study.sweeps.varied import varied

EXAMPLES = Path(__file__).parents[1] / "examples"
OSCILLATOR = """
parameters: {m: 1 kg, k: 30 N/m, c: 1 N s/m}
ground: {lines: {floor: {along: right}}}
bodies: {cart: {particle: {mass: m}}}
connections: {guide: {slider: {body: cart, along: floor}}}
loads:
  spring: {law: {measure: x, force: -k*x}}
  damper: {law: {measure: x, force: -c*rate(x)}}
measures: {x: x of cart}
start: {x: 0.1 m, rate(x): 0.3 m/s}
"""
PUSHED = """
parameters: {m: 2 kg, mu: 0.3, r: 4 N/s, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {block: {particle: {mass: m}}}
connections: {contact: {contact: {between: [block, floor], friction: mu}}}
loads:
  weight: {gravity: g}
  push: {force: {at: block, along: right, magnitude: r*t}}
measures: {x: x of block}
start: {x: 0}
"""
PENDULUMS = """
parameters: {m1: 1 kg, m2: 2 kg, l1: 1 m, l2: 0.7 m, g: 9.81 m/s^2}
bodies: {first: {rod: {mass: m1, length: l1}}, second: {rod: {mass: m2, length: l2}}}
connections: {A: {pin: [ground.O, first.start]}, B: {pin: [first.end, second.start]}}
loads: {weight: {gravity: g}}
measures: {a: angle of first, b: angle of second}
start: {a: 0.3, b: -0.5, rate(a): 0, rate(b): 1 rad/s}
"""
THROW = """
parameters: {m: 1 kg, g: 9.81 m/s^2}
bodies: {ball: {particle: {mass: m}}}
loads: {weight: {gravity: g}}
measures: {y: y of ball}
start: {y: 1 m, rate(y): 3 m/s}
"""


def example(name: str) -> fb.System:
    return fb.System.load(EXAMPLES / f"{name}.yaml")


def gradient(system: fb.System, record: str, by: list[str], until: float, **given: Any) -> dict[str, float | None]:
    found = system.gradient(record=[record], by=by, until=until, **given)
    assert not found.answers[0].why, found.answers[0].why
    return found[record]


def differences(system: fb.System, record: str, by: list[str], until: float) -> dict[str, float]:
    """By Richardson's rule from central differences of motions at a tolerance of 1e-13, all values of (1 + s h) p."""
    seen, names = varied(system, by)
    found: dict[str, float] = {}
    for v in names:
        p = seen.parameters[v.parameter].value
        assert p is not None
        size = abs(p) or 1.0

        def at(step: float, v: Any = v, p: float = p, size: float = size) -> float:
            values = {v.name: [p + step * size]}
            swept = system.sweep(values, record=[record], until=until, tolerance=1e-13)
            return float(swept.values(record)[0]) / size

        def central(h: float, at: Callable[[float], float] = at) -> float:
            return (at(h) - at(-h)) / (2 * h)

        found[v.name] = (4 * central(1e-3) - central(2e-3)) / 3
    return found


def slopes(formula: Callable[..., Any], at: dict[str, float]) -> dict[str, float]:
    """Derivatives of a formula in mpmath's numbers."""
    values = list(at.values())
    with mpmath.workdps(40):
        return {
            name: float(
                mpmath.diff(lambda x, k=k: formula(*[x if i == k else mpmath.mpf(v) for i, v in enumerate(values)]), v)
            )
            for k, (name, v) in enumerate(at.items())
        }


def decay(t: float) -> Callable[..., Any]:
    """x of a damped oscillator: e^(-d t) (x0 cos w t + (v0 + d x0)/w sin w t)."""

    def x(m: Any, k: Any, c: Any, x0: Any, v0: Any) -> Any:
        d = c / (2 * m)
        w = mpmath.sqrt(k / m - d * d)
        return mpmath.exp(-d * t) * (x0 * mpmath.cos(w * t) + (v0 + d * x0) / w * mpmath.sin(w * t))

    return x


NAMES = {"m": 1.0, "k": 30.0, "c": 1.0, "x": 0.1, "rate(x)": 0.3}


def test_an_oscillator_changes_with_everything_as_its_closed_form_does() -> None:
    system = fb.System.from_text(OSCILLATOR)
    found = gradient(system, "x at 2 s", list(NAMES), 3.0)
    assert found == pytest.approx(slopes(decay(2.0), NAMES), rel=1e-8, abs=1e-11)


def test_the_greatest_value_and_the_time_of_an_event_change_as_in_closed_form() -> None:
    """x first vanishes at w t = pi - atan(w x0/(v0 + d x0)), and is greatest at tan w t = w v0/(d v0 + w0^2 x0)."""

    def crossing(m: Any, k: Any, c: Any, x0: Any, v0: Any) -> Any:
        d = c / (2 * m)
        w = mpmath.sqrt(k / m - d * d)
        return (mpmath.pi - mpmath.atan(w * x0 / (v0 + d * x0))) / w

    def greatest(m: Any, k: Any, c: Any, x0: Any, v0: Any) -> Any:
        d = c / (2 * m)
        w = mpmath.sqrt(k / m - d * d)
        t = mpmath.atan(w * v0 / (d * v0 + k / m * x0)) / w
        return mpmath.exp(-d * t) * (x0 * mpmath.cos(w * t) + (v0 + d * x0) / w * mpmath.sin(w * t))

    system = fb.System.from_text(OSCILLATOR)
    found = system.gradient(record=["time when x = 0", "maximum of x"], by=list(NAMES), until=2.0)
    assert found["time when x = 0"] == pytest.approx(slopes(crossing, NAMES), rel=1e-7)
    assert found["maximum of x"] == pytest.approx(slopes(greatest, NAMES), rel=1e-7)


def test_a_motion_that_an_event_ends_moves_its_end() -> None:
    """A throw that ends at the height 0: t = (v + sqrt(v^2 + 2 g y))/g; the rate there is -sqrt(v^2 + 2 g y)."""
    at = {"g": 9.81, "y": 1.0, "rate(y)": 3.0}
    system = fb.System.from_text(THROW)
    found = system.gradient(record=["y_rate at 0.2 s", "time when y = 0"], by=list(at), until=2.0)
    assert found["y_rate at 0.2 s"] == pytest.approx({"g": -0.2, "y": 0.0, "rate(y)": 1.0}, abs=1e-12)
    fall = slopes(lambda g, y, v: (v + mpmath.sqrt(v * v + 2 * g * y)) / g, at)
    assert found["time when y = 0"] == pytest.approx(fall, rel=1e-10)


def test_an_atwood_machine_changes_as_its_constant_acceleration() -> None:
    """x'' = (m2 - m1) g/(m1 + m2 + M/2) of the example: x = x'' t^2/2, and the derivatives of that."""
    system = example("atwood_machine")
    at = {name: float(system.parameters[name].value or 0.0) for name in ("m1", "m2", "M", "g")}
    measure = next(iter(system.measures))
    found = gradient(system, f"{measure}_rate at 1.5 s", list(at), 2.0)
    rate = slopes(lambda m1, m2, M, g: 1.5 * (m1 - m2) * g / (m1 + m2 + M / 2), at)
    sign = math.copysign(1.0, (found["g"] or 0.0) * rate["g"])
    assert found == pytest.approx({name: sign * x for name, x in rate.items()}, rel=1e-9)


def test_a_ball_that_rebounds_changes_as_its_bounces_do() -> None:
    """From the height h: t_1 = sqrt(2 h/g); between bounce i and the next 2 e^i t_1; after bounce n it rises from there
    with the speed e^n g t_1."""
    at, n, t = {"h": 1.0, "e": 0.8, "g": 9.81}, 3, 2.1

    def bounce(h: Any, e: Any, g: Any, n: int) -> Any:
        first = mpmath.sqrt(2 * h / g)
        return first * (1 + 2 * sum(e**i for i in range(1, n)))

    def height(h: Any, e: Any, g: Any) -> Any:
        since = t - bounce(h, e, g, n)
        return e**n * g * mpmath.sqrt(2 * h / g) * since - g * since * since / 2

    system = example("bouncing_ball")
    assert bounce(1.0, 0.8, 9.81, n) < t < bounce(1.0, 0.8, 9.81, n + 1)
    found = system.gradient(record=[f"y at {t} s", "time when ball hits floor"], by=list(at), until=2.2)
    assert found[f"y at {t} s"] == pytest.approx(slopes(height, at), rel=1e-9)
    first = slopes(lambda h, e, g: bounce(h, e, g, 1), at)
    assert found["time when ball hits floor"] == pytest.approx(first, rel=1e-10, abs=1e-12)


def test_a_driven_slider_crank_changes_as_its_geometry() -> None:
    """No freedom is left: x = r cos w t + sqrt(l^2 - r^2 sin^2 w t), and its second derivative in time."""
    t = mpmath.mpf("0.05")
    at = {"r": 0.05, "l": 0.2, "w": 30.0}

    def place(r: Any, l: Any, w: Any, time: Any = t) -> Any:  # noqa: E741
        return r * mpmath.cos(w * time) + mpmath.sqrt(l * l - (r * mpmath.sin(w * time)) ** 2)

    def acceleration(r: Any, l: Any, w: Any) -> Any:  # noqa: E741
        return mpmath.diff(lambda time: place(r, l, w, time), t, 2)

    found = example("driven_slider_crank").gradient(
        record=["x at 0.05 s", "x_acceleration at 0.05 s"], by=list(at), until=0.1
    )
    assert found["x at 0.05 s"] == pytest.approx(slopes(place, at), rel=1e-9)
    assert found["x_acceleration at 0.05 s"] == pytest.approx(slopes(acceleration, at), rel=1e-8)


def test_a_block_that_a_growing_force_tears_loose() -> None:
    """It sticks until r t = mu m g; then m x'' = r t - mu m g, so x = r (t - t_1)^3/(6 m)."""
    at, t = {"m": 2.0, "mu": 0.3, "r": 4.0, "g": 9.81}, 3.0
    system = fb.System.from_text(PUSHED)
    found = system.gradient(record=[f"x at {t} s"], by=list(at), until=3.5)
    moved = slopes(lambda m, mu, r, g: r * (t - mu * m * g / r) ** 3 / (6 * m), at)
    assert found[f"x at {t} s"] == pytest.approx(moved, rel=1e-8)


def test_a_tension_changes_as_its_formula() -> None:
    """A pendulum let go at the angle a: the pin carries m g cos a at the start; along the way energy gives the rest."""
    system = example("driven_slider_crank")
    found = gradient(system, "cylinder.normal_force at 0.05 s", ["F", "mp"], 0.1)
    assert found == pytest.approx(differences(system, "cylinder.normal_force at 0.05 s", ["F", "mp"], 0.1), rel=1e-7)


CASES = [
    ("four_bar", 0.5),
    ("planetary_gear", 0.7),
    ("stick_slip_oscillator", 1.5),
    ("string_comes_taut_again", 0.7),
    ("ball_leaving_cylinder", 0.7),
    ("sphere_launched_down_incline", 0.7),
    ("rolling_coin", 0.5),
    ("spinning_top", 0.3),
    ("spatial_slider_crank", 0.3),
]


@pytest.mark.parametrize(("name", "until"), CASES)
def test_derivatives_are_limits_of_differences(name: str, until: float) -> None:
    """Loops, gears, friction that sticks and slips, strings, contacts that open, rolling and rotations in space."""
    system = example(name)
    by = [p.name for p in system.parameters.values() if p.form is None and p.value is not None][:3]
    record = f"final {next(iter(system.measures))}"
    exact, near = gradient(system, record, by, until, tolerance=1e-11), differences(system, record, by, until)
    size = max(abs(x) for x in near.values()) or 1.0
    assert exact == pytest.approx(near, rel=1e-6, abs=1e-7 * size)


def test_a_double_pendulum_changes_with_masses_lengths_and_start() -> None:
    system = fb.System.from_text(PENDULUMS)
    by = ["m2", "l1", "l2", "g", "a", "rate(b)"]
    record = ["a at 1.2 s", "b_rate at 1.2 s", "b_acceleration at 1.2 s"]
    exact = system.gradient(record=record, by=by, until=1.5, tolerance=1e-11)
    for text in record:
        assert exact[text] == pytest.approx(differences(system, text, by, 1.5), rel=1e-7)


def test_what_the_motion_does_not_hang_on_changes_nothing() -> None:
    """Larger masses, all by the same factor: sum m dx/dm vanishes; so does, with all lengths and
    g larger by the same factor, sum l dx/dl + g dx/dg (the time stays the same)."""
    system = fb.System.from_text(PENDULUMS)
    found = gradient(system, "b at 1.2 s", ["m1", "m2", "l1", "l2", "g"], 1.5)
    values = {name: float(system.parameters[name].value or 0.0) for name in found}
    parts = {name: (slope or 0.0) * values[name] for name, slope in found.items()}
    assert parts["m1"] + parts["m2"] == pytest.approx(0.0, abs=1e-8 * abs(parts["m2"]))
    assert parts["l1"] + parts["l2"] + parts["g"] == pytest.approx(0.0, abs=1e-8 * abs(parts["g"]))


def test_where_there_is_no_derivative_the_reason_is_told() -> None:
    system = fb.System.from_text(THROW)
    top = 1.0 + 9.0 / (2 * 9.81)
    grazing = system.gradient(record=[f"time when y = {top!r} m"], until=1.0).answers[0]
    assert not grazing.derivatives
    at_rest = example("bouncing_ball").gradient(record=["final y"], until=6.0).answers[0]
    assert "come to their end" in at_rest.why
    blow = example("rod_caught_by_a_peg")
    told = blow.gradient(record=[f"final {next(iter(blow.measures))}"], until=1.0).answers[0]
    assert "such a blow" in told.why
    unknown = fb.System.from_text(OSCILLATOR).gradient(record=["kinetic_energy at 1 s"], until=2.0).answers[0]
    assert "no exact derivative" in unknown.why
    jump = example("ball_against_the_air")
    assert "jumps" in jump.gradient(record=[f"final {next(iter(jump.measures))}"], until=0.5).answers[0].why


def test_an_instant_at_which_velocities_jump_has_no_derivative() -> None:
    first = math.sqrt(2.0 / 9.81)
    told = example("bouncing_ball").gradient(record=[f"y_rate at {first!r} s"], until=1.0).answers[0]
    assert "law of motion changes" in told.why


def test_the_gradient_of_a_motion_is_told_and_is_plain_data() -> None:
    found = fb.System.from_text(OSCILLATOR).sensitivity(record=["final x"], by=["k"], until=1.0)
    assert found.is_complete
    assert "final x of the motion" in str(found)
    (answer,) = found.to_plain()["answers"]
    assert answer["formula"] is None
    assert answer["derivatives"]["k"]["unit"] == "m/(N/m)"
    exact = slopes(decay(1.0), NAMES)["k"]
    assert answer["derivatives"]["k"]["value"] == pytest.approx(exact, rel=1e-8)
    value = np.float64(answer["value"])
    assert answer["derivatives"]["k"]["relative"] == pytest.approx(exact * 30.0 / value, rel=1e-8)
