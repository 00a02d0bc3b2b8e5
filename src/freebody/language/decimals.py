"""Decimals as exact numbers: what was written as it stands, what a binary number printed as the fraction it rounds."""

from __future__ import annotations

from fractions import Fraction

_PRINTED_DIGITS = 15  # from here on a decimal is taken for a printed binary number
_SIMPLE = 9999  # the largest divisor of a fraction that is told from its decimals


def written_number(digits: str) -> Fraction:
    """The value of a decimal. 66.66666666666667 is 200/3, not a number 1e-15 beside it: a wheel that turns with it
    would slip at the start. A decimal of fewer digits, or of no simple fraction, is taken as it stands; one in some
    ten million of the others is near such a fraction by chance."""
    exact = Fraction(digits)
    mantissa, _, exponent = digits.lower().partition("e")
    _whole, _, decimals = mantissa.partition(".")
    if len(mantissa.replace(".", "").lstrip("-0")) < _PRINTED_DIGITS:
        return exact
    half_a_digit = Fraction(10) ** (int(exponent or 0) - len(decimals)) / 2
    simple = exact.limit_denominator(_SIMPLE)
    is_rounded = abs(simple - exact) <= half_a_digit or float(simple) == float(exact) != 0
    return simple if is_rounded else exact
