"""What a user writes as rate(x) stands as a formula in sentences, options and headings."""

from __future__ import annotations

from pathlib import Path

import pytest

import freebody as fb
from freebody.language.notation import as_equation
from freebody.language.parser import parse
from freebody.narrative.sheets.options import shown
from freebody.narrative.telling.dollars import with_rates
from freebody.present.report.blocks import Formula

EXAMPLES = Path(__file__).parents[1] / "examples"


@pytest.mark.parametrize(
    ("words", "formula", "behind"),
    [
        ("when rate(x) = 0.", Formula((parse("rate(x)"), parse("0")), ("=",)), "."),
        ("(rate(phi) = w_0/4 is reached)", Formula((parse("rate(phi)"), parse("w_0/4")), ("=",)), " is reached)"),
        ("only if |rate(x0)| is constant", Formula((parse("|rate(x0)|"),)), " is constant"),
        ("when rate(theta) = 90 deg/s", Formula((parse("rate(theta)"),)), " = 90 deg/s"),
        ("until rate(x) = v/(a + 1)", Formula((parse("rate(x)"),)), " = v/(a + 1)"),
    ],
)
def test_a_rate_in_words_is_a_formula_as_far_as_it_is_one(words: str, formula: Formula, behind: str) -> None:
    assert with_rates(words)[-2:] == [formula, behind]


def test_words_without_a_rate_stay_as_they_are() -> None:
    assert with_rates("only if the generate(x) rate is constant") == ["only if the generate(x) rate is constant"]
    assert with_rates("") == []


def test_an_option_in_words_has_its_rate_as_a_formula() -> None:
    assert [type(piece) for piece in shown("only if |rate(x0)| is constant", "only if |rate(x0)| is constant")] == [
        str,
        Formula,
        str,
    ]


@pytest.mark.parametrize("language", ["en", "de"])
def test_no_measure_text_is_left_in_what_is_told_of_an_event(language: str) -> None:
    told = fb.System.load(EXAMPLES / "ball_with_back_spin.yaml").explain(language=language).to_text()
    assert "rate(" not in told


@pytest.mark.parametrize(
    ("written", "told"),
    [
        ("theta = 180 deg", "θ = 180°"),
        ("z = k*R^2/2", "z = k·R²/2"),
        ("rate(phi) = omega_0/4", "φ' = ω_0/4"),
        ("speed of ball when it lands", "speed of ball when it lands"),
    ],
)
def test_an_event_is_told_in_formulas(written: str, told: str) -> None:
    assert as_equation(written) == told
