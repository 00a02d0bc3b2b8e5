"""Formulas among the words of derivations: set as mathematics in every format, vectors in bold letters."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import pytest

from freebody.narrative.telling.dollars import formula_of
from freebody.narrative.telling.phrases import MESSAGES, TABLE
from freebody.narrative.words import languages, tables_of
from freebody.present.report.formulas.latex import LatexFormulas
from freebody.present.report.formulas.line import LineFormulas
from freebody.present.report.formulas.mathml import MathMLFormulas
from freebody.present.report.formulas.rows import formula_width
from freebody.present.report.formulas.typst import TypstFormulas

TYPED = r"[×√∂∝]|(?<![\w$])d[A-Z]/dt"  # signs of formulas, and rates


def sentences(table: dict[str, Any]) -> Iterator[str]:
    for key, value in table.items():
        if isinstance(value, dict):
            if key not in (TABLE, MESSAGES):
                yield from sentences(value)
        else:
            yield str(value)


@pytest.mark.parametrize("language", languages())
def test_formulas_of_the_words_can_be_read_and_are_not_typed(language: str) -> None:
    n_formulas = 0
    for table in tables_of(language):
        for sentence in sentences(table):
            plain, formulas = sentence.split("$")[::2], sentence.split("$")[1::2]
            for formula in formulas:
                assert MathMLFormulas().formula(formula_of(formula)), sentence
            n_formulas += len(formulas)
            assert "{scale}" in sentence or not re.search(TYPED, " ".join(plain)), sentence
    assert n_formulas > 100


@pytest.mark.parametrize(
    ("written", "line", "latex", "typst"),
    [
        (
            "𝒗 + 𝝎 × 𝒓 = 0",
            "𝒗 + 𝝎 × 𝒓 = 0",
            r"\boldsymbol{v} + \boldsymbol{\omega} \times \boldsymbol{r} = 0",
            "bold(v) + bold(ω) × bold(r) = 0",
        ),
        (
            "d𝑯/dt + 𝝎 × 𝑯 = 𝑴",
            "d𝑯/dt + 𝝎 × 𝑯 = 𝑴",
            r"\frac{\mathrm{d}\boldsymbol{H}}{\mathrm{d}t} + \boldsymbol{\omega} \times \boldsymbol{H} "
            r"= \boldsymbol{M}",
            "frac(upright(d) bold(H), upright(d) t) + bold(ω) × bold(H) = bold(M)",
        ),
        (
            "h = Σ u*∂L/∂u - L",
            "h = Σ u∂L/∂u - L",
            r"h = \sum u{}\frac{\partial L}{\partial u} - L",
            'h = sum u""frac(∂ L, ∂ u) - L',
        ),
        ("det(K - ω^2*M) = 0", "det(K - ω²·M) = 0", r"\operatorname{det}\left(K - \omega^{2} M\right) = 0", None),
        ("C = -∂F/∂q'", "C = -∂F/∂q'", r"C = -\frac{\partial F}{\partial \dot{q}}", None),
        ("λ = -δ ± i*ω", "λ = -δ ± i·ω", r"\lambda = -\delta \pm i \omega", None),
        ("m*v^2/2", "m·v²/2", r"\frac{m v^{2}}{2}", None),
    ],
)
def test_a_formula_is_the_same_in_every_format(written: str, line: str, latex: str, typst: str | None) -> None:
    formula = formula_of(written)
    assert LineFormulas().formula(formula) == line
    assert LatexFormulas().formula(formula) == latex
    assert typst is None or TypstFormulas().formula(formula) == typst
    assert 0 < formula_width(formula) < 40


def test_the_sign_between_vectors_and_the_sign_before_a_term_have_their_spaces_in_mathml() -> None:
    between = MathMLFormulas().formula(formula_of("𝝎 × 𝑯"))
    before = MathMLFormulas().formula(formula_of("-𝒗 × 𝑷"))
    assert '<mo form="infix" stretchy="false">×</mo>' in between
    assert before.index("−") < before.index("×")
