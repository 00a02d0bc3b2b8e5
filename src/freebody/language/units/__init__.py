"""Units of the user's text, and the dimensions of expressions.

dimension   exponents of mass, length and time
table       the units known by heart
reader      from the text of a unit to the unit
rare        units asked of pint
quantity    a number with its unit
inference   the dimension of an expression
"""

from __future__ import annotations

from freebody.language.units.dimension import (
    ACCELERATION,
    ANGULAR_ACCELERATION,
    ANGULAR_MOMENTUM,
    ANGULAR_VELOCITY,
    AREA,
    DAMPING,
    DENSITY,
    DIMENSIONLESS,
    ENERGY,
    FORCE,
    IMPULSE,
    INERTIA,
    LENGTH,
    MASS,
    MOMENTUM,
    POWER,
    PRESSURE,
    ROTARY_DAMPING,
    ROTARY_STIFFNESS,
    STIFFNESS,
    TIME,
    TORQUE,
    VELOCITY,
    VOLUME,
    Dimension,
    unit_of,
)
from freebody.language.units.inference import dimension_of
from freebody.language.units.quantity import LARGEST, Quantity, parse_quantity, quantities_within
from freebody.language.units.reader import is_unit, parse_unit
from freebody.language.units.table import Unit

__all__ = [
    "ACCELERATION",
    "ANGULAR_ACCELERATION",
    "ANGULAR_MOMENTUM",
    "ANGULAR_VELOCITY",
    "AREA",
    "DAMPING",
    "DENSITY",
    "DIMENSIONLESS",
    "ENERGY",
    "FORCE",
    "IMPULSE",
    "INERTIA",
    "LARGEST",
    "LENGTH",
    "MASS",
    "MOMENTUM",
    "POWER",
    "PRESSURE",
    "ROTARY_DAMPING",
    "ROTARY_STIFFNESS",
    "STIFFNESS",
    "TIME",
    "TORQUE",
    "VELOCITY",
    "VOLUME",
    "Dimension",
    "Quantity",
    "Unit",
    "dimension_of",
    "is_unit",
    "parse_quantity",
    "parse_unit",
    "quantities_within",
    "unit_of",
]
