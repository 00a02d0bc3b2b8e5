"""Numbers and units as they are printed: exponents raised, a minus that is one."""

from __future__ import annotations

import re

_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def raised(unit: str) -> str:
    """kg m^2/s^2 with its exponents raised."""
    return re.sub(r"\^(-?\d+)", lambda found: found[1].translate(_RAISED), unit)


def typeset(number: str) -> str:
    """-1.2e+04 as −1.2·10⁴."""
    mantissa, e, exponent = number.partition("e")
    power = f"·10{str(int(exponent)).translate(_RAISED)}" if e else ""
    return f"{mantissa}{power}".replace("-", "−")
