"""How reasons are worded: lists, short expressions, numbers to four digits and their units."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from freebody.language.expression import Expr, n_operations
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, Dimension

READABLE = 24  # operations in what a reason shows
NOT_REAL = Message("not a real number")


def is_readable(*shown: Expr) -> bool:
    """Whether a reason can show all of these."""
    return sum(map(n_operations, shown)) <= READABLE


def digits(x: Any) -> str:
    """A ball as a number."""
    return f"{float(x):.4g}" if x.is_finite() else NOT_REAL


def unit_behind(dimension: Dimension) -> str:
    """The unit behind a number, with the space before it."""
    return "" if dimension == DIMENSIONLESS else f" {dimension}"


def places(n_components: int) -> Sequence[str]:
    """The axes that the reasons of components name."""
    return ("",) if n_components == 1 else "xyz"[:n_components]


def of_component(axis: str, reason: str) -> str:
    return Message("{axis} component: {reason}", axis=axis, reason=reason) if axis else reason
