"""Roots of polynomials of the second degree, by the formula."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign, sign_of


def roots(c: Sequence[Ratio], is_negative: Callable[[Ratio], bool] | None = None) -> list[Ratio] | None:
    """The roots of c_0 + c_1 x + c_2 x^2, or of c_0 + c_1 x: first that with the square root subtracted. None for other
    polynomials. is_negative: what sign is taken of what stands under a square root (`Field.sqrt`)."""
    field = c[0].field
    if len(c) == 2:
        return [field.lowest_terms(-c[0] / c[1])]
    if len(c) == 3:
        root = field.sqrt(field.lowest_terms(c[1] * c[1] - 4 * c[0] * c[2]), is_negative)
        return [(-c[1] - root) / (2 * c[2]), (-c[1] + root) / (2 * c[2])]
    return None


def has_no_real_root(c: Sequence[Ratio]) -> bool:
    """Whether c_0 + c_1 x + c_2 x^2 vanishes nowhere, for all values of the parameters."""
    return len(c) == 3 and sign_of(c[0].field.lowest_terms(c[1] * c[1] - 4 * c[0] * c[2])) is Sign.NEGATIVE
