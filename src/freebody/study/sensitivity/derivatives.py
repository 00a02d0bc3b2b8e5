"""Derivatives of one number by names."""

from __future__ import annotations

from dataclasses import dataclass

from freebody.language.expression import Expr


@dataclass(frozen=True)
class Derivative:
    """How one number changes with one name. expression: of a formula; value: nothing where there is none."""

    by: str
    expression: Expr | None
    value: float | None
    relative: float | None
    unit: str
    why: str = ""


@dataclass(frozen=True)
class AnswerGradient:
    """Of one number that is asked for. formula: it, under `conditions`, where it has one; value: at the model's
    numbers; why: there are no derivatives."""

    name: str
    question: str
    formula: Expr | None
    conditions: tuple[str, ...]
    value: float | None
    derivatives: tuple[Derivative, ...]
    why: str = ""
    unit: str = ""  # of a value without a formula
