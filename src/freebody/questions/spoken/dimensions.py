"""What a value is of, as its unit says: a time, an angle, a length, a speed."""

from __future__ import annotations

import re

from freebody.errors import UnitError
from freebody.language.units import DIMENSIONLESS, LENGTH, TIME, Dimension
from freebody.language.units.quantity import parse_quantity


def is_time(value: str) -> bool:
    return _has(value, TIME)


def is_speed(value: str) -> bool:
    return _has(value, LENGTH / TIME)


def is_turning_speed(value: str) -> bool:
    """A number of turns or radians in a time; not a bare frequency, whose turns are left open."""
    return _has(value, DIMENSIONLESS / TIME) and re.search(r"rad|deg|rpm|rev", value) is not None


def kind_of(value: str) -> str:
    """A speed or an acceleration, as the unit of a value says."""
    return next(
        (kind for kind, of in (("speed", LENGTH / TIME), ("acceleration", LENGTH / TIME**2)) if _has(value, of)), ""
    )


def is_length(value: str) -> bool:
    return _has(value, LENGTH)


def is_angle(value: str) -> bool:
    return _has(value, DIMENSIONLESS) and not value.replace(".", "").isdigit()


def _has(value: str, dimension: Dimension) -> bool:
    try:
        return parse_quantity(value).dimension == dimension
    except (UnitError, ValueError):
        return False
