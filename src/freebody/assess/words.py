"""How reasons are worded: lists, short expressions, numbers to four digits and their units."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from freebody.language.expression import Expr, n_operations
from freebody.language.units import DIMENSIONLESS, Dimension

READABLE = 24  # operations in what a reason shows
NOT_REAL = "not a real number"
COMPONENTS = ("x component: ", "y component: ", "z component: ")


def listed(words: Sequence[str]) -> str:
    """a, b and c"""
    return " and ".join(filter(None, (", ".join(words[:-1]), words[-1])))


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
    """What stands before the reason of each component."""
    return ("",) if n_components == 1 else COMPONENTS[:n_components]
