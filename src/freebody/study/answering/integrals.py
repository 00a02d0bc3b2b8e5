"""Elliptic integrals in an answer, and by which convention they are written."""

from __future__ import annotations

from collections.abc import Iterable

from freebody.language.sentences import Message
from freebody.study.answering.finding import Elements
from freebody.symbolic.field import Ratio

_COMPLETE = Message(
    "K(k) is the complete elliptic integral of the first kind with the modulus k, the integral of "
    "1/sqrt(1 - k^2 sin^2 x) from 0 to pi/2; tables and programs that take the parameter m want k^2"
)
_INCOMPLETE = Message(
    "F(phi, k) is the elliptic integral of the first kind with the modulus k, the integral of 1/sqrt(1 - k^2 sin^2 x) "
    "from 0 to phi, and K(k) the complete one, up to pi/2; tables and programs that take the parameter m want k^2"
)


def has_integrals(x: Elements) -> bool:
    """Whether elliptic integrals stand in a formula."""
    return bool(_among(x if isinstance(x, tuple) else (x,)))


def integrals_named(parts: Iterable[Ratio]) -> list[str]:
    """What the elliptic integrals in a formula are."""
    found = _among(parts)
    if not found:
        return []
    return [_INCOMPLETE if any(found) else _COMPLETE]


def _among(parts: Iterable[Ratio]) -> list[bool]:
    """Those in a formula: whether each one is incomplete."""
    return [
        x.field.moduli[g][0] is not None for x in parts for g in sorted(x.field.ingredients(x)) if g in x.field.moduli
    ]
