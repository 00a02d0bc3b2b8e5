"""A direction of the plane in words: by the angle from the x axis, counter-clockwise, where its components are a cosine
and a sine of one angle, else by the components.

(cos a, sin a) lies at a, (-sin a, cos a) at a + 90°, (-cos a, -sin a) at a + 180°, (sin a, -cos a) at a - 90°; with the
sine of the other sign these lie at -a, -a - 90°, 180° - a and 90° - a.
"""

from __future__ import annotations

from freebody.language.expression import Call, Expr, Sum, negate
from freebody.language.sentences import Sentence

_TURNED = {  # what the components are, with their signs: how the angle is written
    ("cos", "+", "sin", "+"): "at",
    ("sin", "-", "cos", "+"): "ahead",
    ("cos", "-", "sin", "-"): "opposite",
    ("sin", "+", "cos", "-"): "behind",
    ("cos", "+", "sin", "-"): "below",
    ("sin", "-", "cos", "-"): "below_behind",
    ("cos", "-", "sin", "+"): "supplement",
    ("sin", "+", "cos", "+"): "complement",
}


def direction_words(x: Expr, y: Expr) -> Sentence:
    """The direction (x, y), of length 1."""
    first, second = _wave(x), _wave(y)
    if first is not None and second is not None and first[2] == second[2]:
        key, angle = _TURNED.get((*first[:2], *second[:2]), ""), first[2]
        if key and not (isinstance(angle, Sum) and key in ("below", "below_behind", "supplement", "complement")):
            return Sentence(f"slanted.{key}", {"angle": angle})
    return Sentence("slanted.components", {"x": x, "y": y})


def _wave(e: Expr) -> tuple[str, str, Expr] | None:
    """cos or sin, its sign and its argument, where an expression is no more than that."""
    for sign, part in (("+", e), ("-", negate(e))):
        if isinstance(part, Call) and part.function in ("cos", "sin"):
            return part.function, sign, part.argument
    return None
