"""Special functions in an answer, and by which convention they are written."""

from __future__ import annotations

from collections.abc import Iterable

from freebody.language.expression import LAMBERT
from freebody.language.sentences import Message
from freebody.study.answering.finding import Elements
from freebody.symbolic.ratio import Ratio

_COMPLETE = Message(
    "K(k) is the complete elliptic integral of the first kind with the modulus k, the integral of "
    "1/√(1 − k² sin² x) from 0 to π/2; tables and programs that take the parameter m want k²"
)
_INCOMPLETE = Message(
    "F(φ, k) is the elliptic integral of the first kind with the modulus k, the integral of 1/√(1 − k² sin² x) "
    "from 0 to φ, and K(k) the complete one, up to π/2; tables and programs that take the parameter m want k²"
)
_LAMBERT = {
    "lambert_W0": Message(
        "W_0 is the principal branch of Lambert's W function: w = W_0(x) is the solution of w exp(w) = x with w >= -1"
    ),
    "lambert_Wm1": Message(
        "W_-1 is the branch -1 of Lambert's W function: w = W_-1(x) is the solution of w exp(w) = x with w <= -1"
    ),
}


def has_integrals(x: Elements) -> bool:
    """Whether elliptic integrals stand in a formula."""
    return bool(_among(x if isinstance(x, tuple) else (x,)))


def special_functions_named(parts: Iterable[Ratio]) -> list[str]:
    """What the elliptic integrals and the branches of Lambert's W in a formula are."""
    parts = tuple(parts)
    found = _among(parts)
    elliptic = [_INCOMPLETE if any(found) else _COMPLETE] if found else []
    names = {x.field.arguments.get(g, ("",))[0] for x in parts for g in x.field.ingredients(x)}
    return [*elliptic, *(_LAMBERT[name] for name in LAMBERT if name in names)]


def _among(parts: Iterable[Ratio]) -> list[bool]:
    """Those in a formula: whether each one is incomplete."""
    return [
        x.field.moduli[g][0] is not None for x in parts for g in sorted(x.field.ingredients(x)) if g in x.field.moduli
    ]
