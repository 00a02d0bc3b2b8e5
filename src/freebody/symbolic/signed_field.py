"""The field whose roots know what sign their squares were taken of."""

from __future__ import annotations

from freebody.symbolic.field import Field
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign, sign_of


class SignedField(Field):
    """A field in which sqrt(x^2) is |x| by what is known of the sign of x."""

    def has_negative_sign(self, x: Ratio) -> bool | None:
        sign = sign_of(x)
        if sign in (Sign.POSITIVE, Sign.NONNEGATIVE):
            return False
        return True if sign in (Sign.NEGATIVE, Sign.NONPOSITIVE) else None
