"""A value told in another unit of its dimension."""

from __future__ import annotations

import math
import re

from freebody.language.units.reader import parse_unit

_PER_TIME = re.compile(r"[kM]?Hz|hertz|1/\w+")  # how often it goes round: an angle of 2 pi each time


def conversion(own: str, wanted: str) -> float:
    """By what a value in one unit is multiplied to be told in another of the same dimension. A rate of an angle told in
    hertz, or in 1/min, counts full turns: 2 pi rad/s is 1 Hz."""
    one, other = parse_unit(own), parse_unit(wanted)
    ratio = float(one.factor / other.factor) * math.pi ** (one.pi_power - other.pi_power)
    return ratio / (2 * math.pi) if own.startswith("rad/") and _PER_TIME.fullmatch(wanted) else ratio
