"""What a value is of, as its unit says: a time, an angle, a length, a speed."""

from __future__ import annotations

import re
from contextlib import suppress
from typing import TYPE_CHECKING

from freebody.errors import InputError, UnitError
from freebody.language.parser import parse
from freebody.language.units import DIMENSIONLESS, LENGTH, TIME, Dimension
from freebody.language.units.inference import dimension_of
from freebody.language.units.quantity import parse_quantity

if TYPE_CHECKING:
    from freebody.model.names import Names


def is_time(value: str, names: Names | None = None) -> bool:
    return _has(value, TIME, names)


def is_speed(value: str, names: Names | None = None) -> bool:
    return _has(value, LENGTH / TIME, names)


def is_turning_speed(value: str, names: Names | None = None) -> bool:
    """A number of turns or radians in a time; not a bare frequency, whose turns are left open."""
    is_counted = re.search(r"rad|deg|rpm|rev", value) is not None or not value[:1].isdigit()
    return is_counted and _has(value, DIMENSIONLESS / TIME, names)


def kind_of(value: str, names: Names | None = None) -> str:
    """A speed or an acceleration, of a place or of an angle, as the unit of a value says."""
    if is_turning_speed(value, names):
        return "angular velocity"
    if re.search(r"rad|deg|rev", value) is not None and _has(value, DIMENSIONLESS / TIME**2, names):
        return "angular acceleration"
    return next(
        (kind for kind, of in (("speed", LENGTH / TIME), ("acceleration", LENGTH / TIME**2)) if _has(value, of, names)),
        "",
    )


def is_length(value: str, names: Names | None = None) -> bool:
    return _has(value, LENGTH, names)


def is_same(names: Names, value: str, parameter: str) -> bool:
    """Whether a parameter has a value in the file."""
    if value == parameter:
        return True
    with suppress(UnitError, ValueError):
        return parameter in names.parameters and names.number_of(parameter) == parse_quantity(value).value
    return False


def is_angle(value: str) -> bool:
    return _has(value, DIMENSIONLESS) and not value.replace(".", "").isdigit()


def _has(value: str, dimension: Dimension, names: Names | None = None) -> bool:
    try:
        return parse_quantity(value).dimension == dimension
    except (UnitError, ValueError):
        return names is not None and _of_parameters(value, names) == dimension


def _of_parameters(value: str, names: Names) -> Dimension | None:
    """The dimension of an expression in parameters: omega_0/2."""
    own = {name: parameter.dimension for name, parameter in names.parameters.items() if parameter.dimension is not None}
    try:
        return dimension_of(parse(value), own)
    except InputError:
        return None
