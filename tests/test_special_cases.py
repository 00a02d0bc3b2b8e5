"""Special cases of an answer keep to the range in which it holds, by the conditions as formulas."""

from __future__ import annotations

from pathlib import Path

import pytest

import freebody as fb
from freebody.language.truth import is_true

EXAMPLES = Path(__file__).parents[1] / "examples"


def told(name: str) -> str:
    return " ".join(fb.System.load(EXAMPLES / f"{name}.yaml").explain().to_text().split())


def test_a_case_outside_of_the_range_is_not_told() -> None:
    # at theta = 0 a throw hits nothing above: h < s tan(theta) is needed, and the root would be imaginary
    assert "θ = 0:" not in told("throw_at_target")
    # the hook is taut while 2 I g >= R T, and without a moment of inertia it is not
    assert "I = 0:" not in told("hoist")


def test_a_case_inside_of_the_range_is_told_though_some_draws_are_outside() -> None:
    # the sliding distance is proportional to 1/mu, if the ball slides back: 2 r w0 > 5 v0
    assert "μ → 0: unbounded; μ → ∞: 0" in told("ball_with_back_spin")


@pytest.mark.parametrize(
    ("statement", "is_so"),
    [
        ("l > r", False),
        ("l >= r", True),
        ("(l > r) | (a < pi/2)", True),
        ("(l > r) & (a < pi/2)", False),
        ("(a + l)*(a - l) < 0", True),
        ("rate(theta) > 1", True),
        ("sqrt(a - l) > 0", None),
        ("x > 0", None),
        ("(l > r) & (x > 0)", False),
        ("(l >= r) | (x > 0)", True),
    ],
)
def test_statements_for_machines_are_judged(statement: str, is_so: bool | None) -> None:
    values = {"l": 1.0, "r": 1.0 + 1e-13, "a": 0.3, "rate(theta)": 2.0}
    assert is_true(statement, values, round_off=1e-12) is is_so
