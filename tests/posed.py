"""Textbook problems: a model, a question, and the formula that the book has, compared at several numbers."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import isclose

import freebody as fb
from freebody.api import System
from freebody.language.expression import FLOAT_FUNCTIONS, Expr, evaluate
from freebody.language.parser import parse
from freebody.study.answering.answer import Answer

Problem = tuple[str, str, str]  # model, question, formula


def posed(text: str, question: str) -> Answer:
    """The answer to a question about a model."""
    return fb.solve(System.from_text(f"{text}questions: [{question!r}]\n")).answers[0]


def is_derived(text: str, question: str) -> dict[str, str]:
    """Asserts that the answer is derived; what is told, by language. It is derived once for all of them."""
    found = fb.explain(System.from_text(f"{text}questions: [{question!r}]\n"))
    assert [derivation.reason for derivation in found.derivations] == [""]
    told = {language: replace(found, language=language).to_text() for language in ("en", "de")}
    assert "There is no derivation" not in told["en"], told["en"]
    assert "keine Herleitung" not in told["de"], told["de"]
    return told


def _real(e: Expr, values: Mapping[str, float]) -> float | None:
    """The value of a formula, None where it has no real one."""
    try:
        return evaluate(e, values, FLOAT_FUNCTIONS)
    except ValueError:
        return None


def is_formula(
    text: str,
    question: str,
    formula: str,
    factors: Sequence[float] = (1.0, 1.1, 0.93),
    numbers: Mapping[str, float] | None = None,
) -> Answer:
    """Asserts that the answer is a formula, at the model's numbers and near them, and has evidence. numbers: for what
    the model leaves open."""
    found = posed(text, question)
    assert isinstance(found.expression, Expr), found.reason
    assert found.evidence is not None
    own = {p.name: p.value for p in System.from_text(text).parameters.values() if p.value is not None}
    own |= numbers or {}
    wanted = parse(formula)
    for n, factor in enumerate(factors):
        # every parameter by a factor of its own, or formulas that differ by a power of units would agree
        values = {name: v * factor ** (1 + 0.3 * (k + n)) for k, (name, v) in enumerate(sorted(own.items()))}
        a, b = (_real(e, values) for e in (found.expression, wanted))
        if n and a is b is None:  # there is no such motion near by: both formulas say so
            continue
        assert a is not None
        assert b is not None
        assert isclose(a, b, rel_tol=1e-9, abs_tol=1e-12), (str(found.expression), a, b)
    return found
