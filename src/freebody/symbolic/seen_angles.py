"""The angle of a line between points that move, as the place of one across a direction.

The line from A to B has the direction alpha where B is on the ray from A along it,

    across = y cos(alpha) - x sin(alpha) = 0,     ahead = x cos(alpha) + y sin(alpha) > 0,     (x, y) = r_AB,

which are linear in coordinates in which x and y are: what is seen under a given angle is a place reached.
"""

from __future__ import annotations

from dataclasses import dataclass

from freebody.symbolic.functions import cos_sin
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign, sign_of


@dataclass(frozen=True)
class Ray:
    """Zero on a line, and positive on one half of it."""

    across: Ratio
    ahead: Ratio


def ray_of(angle: Ratio, target: Ratio) -> Ray | None:
    """Where an angle has a value, but for whole turns: sin(angle - target) = 0 and cos(angle - target) > 0, both
    without what they are divided by; None where the sign of that is open."""
    f = angle.field
    cos, sin = map(f.lowest_terms, cos_sin(f, f.lowest_terms(angle - target)))
    if not all(sign_of(x.denominator()) in (Sign.POSITIVE, Sign.NONNEGATIVE) for x in (cos, sin)):
        return None
    return Ray(sin.numerator(), cos.numerator())
