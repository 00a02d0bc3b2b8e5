"""The best parameters of a system, against what is found by hand."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import freebody as fb
from command import freebody
from freebody.errors import CannotAnswer, InputError

EXAMPLES = Path(__file__).parents[1] / "examples"
SLIDE = """
title: Block sliding down an incline
parameters: {m: 1 kg, alpha: 30 deg, mu: 0.3, g: 9.81 m/s^2}
ground: {lines: {incline: {along: [cos(alpha), -sin(alpha)]}}}
bodies: {block: {particle: {mass: m}}}
connections: {contact: {contact: {between: [block, incline], friction: mu}}}
loads: {weight: {gravity: g}}
measures: {s: travel of block along incline, x: x of block}
start: {s: 0, rate(s): 1 m/s}
questions: [{id: sideways, find: acceleration of x at start}]
"""
NUMBERS = """
parameters: {a: 1 m, b: 1 m, c: 0.3, x: 0.5, m: 1 kg}
bodies: {p: {particle: {mass: m}}}
measures: {y: y of p}
start: {y: 0, rate(y): 0}
"""
OSCILLATOR = """
parameters: {m: 1 kg, k: 5 N/m}
ground: {lines: {floor: {along: right}}}
bodies: {cart: {particle: {mass: m}}}
connections: {guide: {slider: {body: cart, along: floor}}}
loads: {spring: {law: {measure: x, force: -k*x}}}
measures: {x: x of cart}
start: {x: 0.1 m, rate(x): 0}
"""


def numbers() -> fb.System:
    return fb.System.from_text(NUMBERS)


def test_the_steepest_way_sideways_is_at_45_degrees_and_half_the_friction_angle() -> None:
    """x'' = g cos a (sin a - mu cos a) is greatest where tan 2a = -1/mu: a = 45 deg + arctan(mu)/2; this is also the
    chord of quickest descent over a given width."""
    found = fb.System.from_text(SLIDE).optimise(maximise="sideways", over={"alpha": "20..80 deg"})
    a = math.pi / 4 + math.atan(0.3) / 2
    assert found.values["alpha"] == pytest.approx(a, rel=1e-7)
    assert found.value == pytest.approx(9.81 * math.cos(a) * (math.sin(a) - 0.3 * math.cos(a)), rel=1e-12)
    assert found.known is not None
    assert (found.known.order, found.n_same) == ("strict", 16)
    assert "not proved" in found.globally


def test_the_farthest_throw_from_a_height_is_that_of_the_formula() -> None:
    """tan theta = v/sqrt(v^2 + 2 g h)."""
    text = (EXAMPLES / "farthest_throw.yaml").read_text(encoding="utf-8").replace("y: 0,", "y: 5 m,")
    system = fb.System.from_text(text[: text.index("questions:")])
    found = system.optimise(maximise="x when y = 0", over={"theta": "5..85 deg"})
    assert math.tan(found.values["theta"]) == pytest.approx(18 / math.sqrt(18**2 + 2 * 9.81 * 5), rel=1e-6)


def test_the_highest_point_over_a_wall_is_found_to_the_last_digits() -> None:
    """y = d tan(a) - g d^2/(2 v^2 cos^2 a) is greatest for tan(a) = v^2/(g d). A search alone ends where y changes no
    more, with half of the digits of a."""
    system = fb.System.from_text(
        """
parameters: {m: 1 kg, v: 12 m/s, a: 40 deg, g: 9.81 m/s^2, d: 4 m}
bodies: {stone: {particle: {mass: m}, at: [0, 0]}}
loads: {weight: {gravity: g}}
measures: {x: x of stone, y: y of stone}
start: {x: 0, y: 0, rate(x): v*cos(a), rate(y): v*sin(a)}
questions: [{id: clear, find: y when x = d}]
"""
    )
    found = system.optimise(maximise="clear", over={"a": "10..85 deg"})
    assert found.values["a"] == pytest.approx(math.atan(144 / (9.81 * 4)), abs=1e-12)
    assert found.value == pytest.approx(144 / (2 * 9.81) - 9.81 * 16 / 288, rel=1e-14)
    assert found.known is not None
    assert found.known.order == "strict"


def test_the_multiplier_of_a_limit_is_what_a_unit_more_of_it_costs() -> None:
    """min a + 2 b with a b >= c: a = sqrt(2 c), b = a/2, the least value 2 sqrt(2 c), which grows by sqrt(2/c)."""
    found = numbers().optimise("a + 2*b", subject_to="a*b > 2 m^2", over={"a": "0.2..9 m", "b": "0.2..9 m"})
    assert found.values == pytest.approx({"a": 2.0, "b": 1.0}, rel=1e-6)
    assert found.known is not None
    (limit,) = found.known.active
    assert (limit.text, limit.unit) == ("a*b > 2 m^2", "1/m")
    assert limit.cost == pytest.approx(1.0, rel=1e-5)
    assert limit.multiplier > 0
    assert found.known.order == "strict"


def test_a_limit_is_moved_as_its_multiplier_says() -> None:
    """The cost of a bound is the slope of the optimum by it: max m1 with (m1 - m2) g/(m1 + m2 + M/2) <= a, at m2 = 1 kg
    and M = 2 kg, is (g + 2 a)/(g - a) kg, which grows by 3 g/(g - a)^2."""
    system = fb.System.load(EXAMPLES / "atwood_machine.yaml")
    over = {"m1": "1.1..4.5 kg", "M": "1..2 kg"}
    found = system.with_parameters(m2="1 kg").optimise(maximise="m1", subject_to="acceleration < 1 m/s^2", over=over)
    assert found.value == pytest.approx((9.81 + 2) / 8.81, rel=1e-9)
    costs = {a.text: a.cost for a in found.known.active} if found.known else {}
    assert costs["acceleration < 1 m/s^2"] == pytest.approx(3 * 9.81 / 8.81**2, rel=1e-6)
    assert costs["upper bound of M"] == pytest.approx(0.5 / 8.81, rel=1e-6)  # m1 = 1 + a (2 + M/2)/(g - a) ...


def test_the_least_greatest_deviation_is_that_of_chebyshev() -> None:
    """max |x^2 - c| on -1..1 is least for c = 1/2, where it is 1/2 at -1, 0 and 1."""
    found = numbers().optimise("maximum of abs(x^2 - c) over x=-1..1:201", over={"c": "-1..2"})
    assert found.values["c"] == pytest.approx(0.5, abs=1e-9)
    assert found.value == pytest.approx(0.5, abs=1e-9)


def test_linear_problems_alone_are_known_to_have_no_better_case() -> None:
    found = numbers().optimise("a + 2*b", subject_to="a + b > 1 m", over={"a": "0..5 m", "b": "0.1..5 m"})
    assert found.value == pytest.approx(1.1, rel=1e-9)
    assert "no case within the bounds is better" in found.globally
    costs = {a.text: a.cost for a in found.known.active} if found.known else {}
    assert costs == pytest.approx({"a + b > 1 m": 1.0, "lower bound of b": 1.0}, rel=1e-6)


def test_two_valleys_are_both_found_and_the_deeper_one_is_told() -> None:
    """(c^2 - 1)^2 + c/4 has a valley near each of -1 and 1."""
    found = numbers().optimise("(c^2 - 1)^2 + c/4", over={"c": "-2..2"})
    roots = np.roots([4, 0, -4, 0.25])
    assert found.values["c"] == pytest.approx(float(roots.real.min()), rel=1e-6)
    assert 0 < found.n_same < 16


def test_a_pareto_front_is_that_of_the_formula() -> None:
    """A small tension and a great acceleration both want the lighter mass least: m2 = 1 kg all along."""
    pytest.importorskip("pymoo")
    system = fb.System.load(EXAMPLES / "atwood_machine.yaml")
    found = system.optimise("tension", maximise="acceleration", over={"m1": "1..4 kg", "m2": "1..4 kg"}, generations=60)
    assert len(found.front) > 50
    for values, (tension, acceleration) in found.front:
        assert values["m2"] == pytest.approx(1.0, abs=2e-2)
        m1, m2 = values["m1"], values["m2"]
        a = (m1 - m2) / (m1 + m2 + 0.5) * 9.81
        assert acceleration == pytest.approx(a, rel=1e-9, abs=1e-9)
        assert tension == pytest.approx(m1 * (9.81 - a), rel=1e-9)
    again = system.optimise("tension", maximise="acceleration", over={"m1": "1..4 kg", "m2": "1..4 kg"}, generations=60)
    assert np.array_equal(found.u, again.u)


def test_what_is_read_off_a_motion_is_optimised_as_well() -> None:
    """x(1 s) = x0 cos sqrt(k/m) is least where sqrt(k/m) = pi."""
    pytest.importorskip("pymoo")
    system = fb.System.from_text(OSCILLATOR)
    found = system.optimise("final x", over={"k": "2..30 N/m"}, until=1.0, generations=6, tolerance=1e-11)
    assert found.values["k"] == pytest.approx(math.pi**2, rel=1e-4)
    assert found.value == pytest.approx(-0.1, rel=1e-7)


@pytest.mark.slow
def test_cases_that_cannot_be_assembled_are_violations_with_their_status() -> None:
    """The crank of a rocker b apart: b + c must reach over |d - a|, so that no shorter coupler is taken."""
    system = fb.System.load(EXAMPLES / "four_bar.yaml").with_parameters(c="0.1 m")
    found = system.optimise("b", subject_to="rocker < 100", over={"b": "0.3..0.6 m"}, starts=1)
    diagonal = math.sqrt(0.2**2 + 0.5**2 - 2 * 0.2 * 0.5 * math.cos(math.pi / 3))
    assert found.known is not None
    assert found.known.order == "not shown"  # the least coupler is at the edge of what has a number
    assert found.values["b"] >= diagonal - 0.1 - 1e-6
    assert found.failures
    assert all(status for _of, status, _n, _why in found.failures)


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"over": {"q": "1..2 m"}}, "q is no parameter, no named measure and no state"),
        ({"over": {"a": "1..2"}}, "a is in m; 1 is not"),
        ({"over": {"a": "2..1 m"}}, "a: the range is empty"),
        ({"over": {"a": "1, 2 m"}}, "between two bounds"),
        ({"over": {"c": "1..2"}}, "a + b does not depend on c"),
        ({"over": {"a": "1..2 m", "c": "1..2"}}, "neither a goal nor a limit depends on c"),
        ({"over": {}}, "nothing varies"),
        ({"over": {"a": "1..2 m"}, "subject_to": "a = b = c"}, "is no limit"),
        ({"over": {"a": "1..2 m"}, "subject_to": "a < 3 kg"}, "kg"),
        ({"over": {"a": "1..2 m"}, "method": "best"}, "there is no method best"),
        ({"over": {"a": "1..2 m"}, "starts": 5}, "powers of two"),
    ],
)
def test_bad_input_is_told_in_words(given: dict[str, Any], words: str) -> None:
    with pytest.raises(InputError) as told:
        numbers().optimise("a + b", **given)
    assert words in str(told.value)


def test_goals_that_are_none_are_told() -> None:
    with pytest.raises(InputError, match="there is no goal"):
        numbers().optimise(over={"a": "1..2 m"})
    with pytest.raises(InputError, match="b"):
        numbers().optimise("a + m", over={"a": "1..2 m"})
    with pytest.raises(CannotAnswer, match="no real value"):
        numbers().optimise("sqrt(c - 5)", over={"c": "0..1"})


def test_without_a_case_that_keeps_all_limits_the_nearest_one_is_told() -> None:
    found = numbers().optimise("a", subject_to="a > 3 m", over={"a": "1..2 m"})
    assert not found.is_complete
    assert "no case was found that keeps all limits" in found.to_text()
    assert not found.to_plain()["feasible"]


def test_the_command_prints_writes_and_ends_with_what_was_found(tmp_path: Path) -> None:
    model = EXAMPLES / "atwood_machine.yaml"
    args = [
        "optimise",
        str(model),
        "--minimise",
        "tension",
        "--over",
        "m1=1..4kg",
        "--subject-to",
        "acceleration > 1 m/s^2",
    ]
    ran = freebody(*args, "--json", "-o", str(tmp_path / "starts.csv"))
    assert ran.returncode == 0, ran.stderr
    told = json.loads(ran.stdout)
    m1 = (2.5 + 2 * 9.81) / 8.81  # (m1 - 2) g = m1 + 2.5
    assert told["values"]["m1"] == pytest.approx(m1, rel=1e-6)
    assert told["units"] == {"m1": "kg", "minimise tension": "N"}
    assert len((tmp_path / "starts.csv").read_text(encoding="utf-8").splitlines()) == 17
    bad = freebody(*args[:-1], "accel > 1 m/s^2")
    assert bad.returncode == 2
    assert "accel" in bad.stderr
