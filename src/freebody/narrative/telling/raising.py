"""Exponents of units, raised."""

from __future__ import annotations

import re

_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def raised(unit: str) -> str:
    """kg m^2/s^2 with its exponents raised."""
    return re.sub(r"\^(-?\d+)", lambda found: found[1].translate(_RAISED), unit)
