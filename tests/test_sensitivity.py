"""Gradients of answers, exact, and shares of names in the variance of a result."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pytest

import freebody as fb
from freebody.errors import CannotAnswer, InputError
from freebody.language.expression import evaluate
from freebody.language.notation import to_python
from freebody.language.parser import parse
from freebody.language.units import MASS
from freebody.model.elements import Parameter
from freebody.symbolic.gradients import derivative

EXAMPLES = Path(__file__).parents[1] / "examples"
TWO_FORCES = """
parameters: {m: 2 kg, F1: 1 N, F2: 1 N, L: 3 m}
bodies: {cart: {particle: {mass: m}}}
loads: {one: {force: {at: cart, along: right, magnitude: F1}}, two: {force: {at: cart, along: right, magnitude: 2*F2}}}
measures: {x: x of cart}
start: {x: 0, rate(x): 0}
questions: [{id: a, find: acceleration of x}]
"""


def example(name: str) -> fb.System:
    return fb.System.load(EXAMPLES / f"{name}.yaml")


@pytest.mark.parametrize(
    "text",
    ["a*b^2/(a + b)", "sqrt(a/b)*sin(a*b)", "atan(a/b) + a^3*exp(-b)", "(a - b)*sqrt(a^2 + b^2)", "a^(3/2)/cos(b)"],
)
def test_derivatives_are_limits_of_differences(text: str) -> None:
    parameters = {name: Parameter(name, MASS, 1.0) for name in ("a", "b")}
    expr, at, h = parse(text), {"a": 1.3, "b": 0.7}, 1e-5
    for by, size in at.items():
        exact = evaluate(derivative(expr, by, parameters), at)
        ahead, behind = (evaluate(expr, {**at, by: size + s * h}) for s in (1, -1))
        assert exact == pytest.approx((ahead - behind) / (2 * h), rel=1e-8)


def test_a_derivative_is_in_lowest_terms() -> None:
    """d/da of (a^2 - b^2)/(a - b) is one."""
    parameters = {name: Parameter(name, MASS, 1.0) for name in ("a", "b")}
    assert to_python(derivative(parse("(a^2 - b^2)/(a - b)"), "a", parameters)) == "1"
    assert to_python(derivative(parse("a*b"), "c", parameters)) == "0"


def test_the_gradient_of_an_answer_is_that_by_hand() -> None:
    """Of g (m1 - m2)/(m1 + m2 + M/2): g (2 m2 + M/2)/S^2 by m1, -g (m1 - m2)/(2 S^2) by M, with S the sum below."""
    found = example("atwood_machine").gradient(["acceleration"])["acceleration"]
    m1, m2, M, g = 3.0, 2.0, 1.0, 9.81
    S = m1 + m2 + M / 2
    expected = {"m1": g * (2 * m2 + M / 2) / S**2, "m2": -g * (2 * m1 + M / 2) / S**2}
    expected |= {"M": -g * (m1 - m2) / (2 * S**2), "g": (m1 - m2) / S}
    assert found == pytest.approx(expected, rel=1e-14)


def test_an_answer_is_differentiated_by_a_start_value() -> None:
    """A pendulum let go at theta: its tension at the start is m g cos(theta)."""
    found = example("simple_pendulum").gradient(["tension"], by=["theta", "L"])
    assert found["tension"] == pytest.approx({"theta": -9.81 * math.sin(math.pi / 3), "L": 0.0}, rel=1e-13)
    told = found.to_plain()["answers"][0]["derivatives"]["theta"]
    assert told["unit"] == "N"
    assert told["relative"] == pytest.approx(-math.pi / 3 * math.tan(math.pi / 3), rel=1e-12)


def test_one_question_and_one_name_need_no_list() -> None:
    system = example("simple_pendulum")
    assert system.gradient("period", "L").to_plain() == system.gradient(["period"], ["L"]).to_plain()
    assert list(system.sweep({"L": "1..2 m:2"}, find="period").counts) == ["period"]


def test_the_gradient_of_a_period_has_the_signs_of_its_parameters() -> None:
    """2 pi sqrt(L/g): pi/sqrt(L g), without a sign left open."""
    (answer,) = example("simple_pendulum").gradient(["period"]).answers
    shown = {d.by: to_python(d.expression) for d in answer.derivatives if d.expression is not None}
    assert all("abs" not in text for text in shown.values())
    assert [d.relative for d in answer.derivatives if d.by in ("L", "g")] == pytest.approx([0.5, -0.5])


def test_without_a_formula_the_gradient_says_why() -> None:
    model = (EXAMPLES / "sphere_launched_down_incline.yaml").read_text(encoding="utf-8")
    steep = fb.System.from_text(model).with_parameters(mu=0.05)  # it never rolls there
    found = steep.gradient(["time"])
    assert not found.is_complete
    assert found.answers[0].formula is None
    assert found.answers[0].why


def test_indices_of_a_sum_are_the_shares_of_its_terms() -> None:
    """a = (F1 + 2 F2)/m with equal spreads: a fifth and four fifths, and nothing of the length."""
    pytest.importorskip("SALib")
    vary = {"F1": "normal(10 N, 1 N)", "F2": "normal(10 N, 1 N)", "L": "uniform(1 m, 2 m)"}
    found = fb.System.from_text(TWO_FORCES).sensitivity(vary, sample="saltelli:2048")
    shares = {i.name: i for i in found.indices["a"]}
    for name, share in (("F1", 0.2), ("F2", 0.8), ("L", 0.0)):
        assert shares[name].first == pytest.approx(share, abs=0.02 + shares[name].first_error)
        assert shares[name].total == pytest.approx(share, abs=0.02 + shares[name].total_error)
    assert shares["L"].total == pytest.approx(0.0, abs=1e-12)
    assert found.cases is not None
    assert found.cases.n == 2048 * 5


def test_indices_of_a_motion_are_those_of_the_formula_of_it() -> None:
    """x = a t^2/2 at t = 1 s: the same shares, of the same cases."""
    pytest.importorskip("SALib")
    vary = {"F1": "uniform(1 N, 3 N)", "F2": "uniform(1 N, 2 N)"}
    asked: dict[str, Any] = {"find": ["a"], "record": ["final x"], "until": 1.0, "sample": "saltelli:32"}
    found = fb.System.from_text(TWO_FORCES).sensitivity(vary, **asked)
    for one, other in zip(found.indices["a"], found.indices["final x"], strict=True):
        assert (one.first, one.total) == pytest.approx((other.first, other.total), rel=1e-6)


def test_a_variance_of_cases_without_a_number_is_not_told() -> None:
    pytest.importorskip("SALib")
    with pytest.raises(CannotAnswer, match="have no number"):
        example("sphere_launched_down_incline").sensitivity({"mu": "0.01..0.5"}, find=["time"], sample="saltelli:8")


@pytest.mark.parametrize(
    ("asked", "said"),
    [
        ({"vary": {"F1": "1..2 N"}, "sample": "sobol:64"}, "need cases by saltelli:1024"),
        ({"vary": {"F1": "1..2 N"}, "sample": "saltelli:100"}, "power of two"),
        ({"record": ["final x"]}, "how long is the motion"),
        ({"by": ["colour"]}, "colour is no parameter"),
    ],
)
def test_what_cannot_be_asked_is_told(asked: dict[str, Any], said: str) -> None:
    with pytest.raises(InputError, match=said):
        fb.System.from_text(TWO_FORCES).sensitivity(**asked)
