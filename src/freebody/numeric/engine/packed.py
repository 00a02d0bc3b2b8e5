"""What packing collects of a system before arrays are made of it: rows by their kind, what may be held, what slides."""

from __future__ import annotations

from dataclasses import dataclass

from freebody.language.expression import Expr
from freebody.model.elements import ConstraintRow, DryFriction

Terms = tuple[tuple[int, float], ...]  # (measure, coefficient)


@dataclass(frozen=True)
class Base:
    """constant + sum of coefficient * measure."""

    constant: float
    terms: Terms


@dataclass
class Composition:
    """An expression in base rows and time."""

    expr: Expr
    inputs: dict[str, int]


@dataclass(frozen=True)
class Hold:
    """A row that may be held."""

    where: Where
    target: Expr | None
    held: ConstraintRow
    is_place: bool


@dataclass(frozen=True)
class Slide:
    """Dry friction: the row of its slip, the place among the rows that may be held that keeps it where it is, and where
    its load is among them."""

    where: Where
    friction: DryFriction
    keeps: int
    loads: tuple[int, ...]
    sign: int
    across: Where | None = None  # in a plane: the row of its slip across, and the place that keeps that
    keeps_across: int = -1


@dataclass
class RowProduct:
    """Sum of c(pose) dm/dt, both c and m rows of their own."""

    terms: list[tuple[tuple[str, int], tuple[str, int]]]


MeasureKey = tuple[tuple[int, ...], tuple[float, ...]]  # bodies and numbers of a measure
Where = tuple[str, int]  # "base" or "other", and the place there


def summed(a: Base, b: Base, factor: float) -> Base:
    """a + factor * b, measures in the order in which they first occur."""
    terms = dict(a.terms)
    for k, c in b.terms:
        terms[k] = terms.get(k, 0.0) + factor * c
    return Base(a.constant + factor * b.constant, tuple(terms.items()))
