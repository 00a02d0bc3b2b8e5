"""The units that are known by heart, each exactly: a fraction of the SI unit times a power of pi.

    deg = (1/180) pi        rpm = (2/60) pi /s        inch = 254/10000 m        lbf = lb * 9.80665 m/s^2

Sources: the SI brochure, 9th ed. 2019; NIST Special Publication 811, 2008, app. B (inch, pound, yard).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction

from freebody.language.units.dimension import (
    ANGULAR_VELOCITY,
    DIMENSIONLESS,
    ENERGY,
    FORCE,
    LENGTH,
    MASS,
    POWER,
    PRESSURE,
    TIME,
    VELOCITY,
    VOLUME,
    Dimension,
)


@dataclass(frozen=True, slots=True)
class Unit:
    """One of the unit is `factor` * pi**`pi_power` of the SI unit of its dimension."""

    dimension: Dimension
    factor: Fraction = Fraction(1)
    pi_power: int = 0
    is_angle: bool = False
    is_exact: bool = True

    def __mul__(self, other: Unit) -> Unit:
        return Unit(
            self.dimension * other.dimension,
            self.factor * other.factor,
            self.pi_power + other.pi_power,
            is_exact=self.is_exact and other.is_exact,
        )

    def __pow__(self, exponent: int | Fraction) -> Unit:
        """A power; a broken one of a factor that is no such power of a fraction is a number of 16 digits."""
        exponent = Fraction(exponent)
        if exponent == 1:
            return self
        pi_power = self.pi_power * exponent
        if exponent.denominator == 1 or (self.factor == 1 and pi_power.denominator == 1):
            factor = self.factor ** int(exponent) if self.factor != 1 else self.factor
            return Unit(self.dimension**exponent, factor, int(pi_power), is_exact=self.is_exact)
        factor = Fraction((float(self.factor) * math.pi**self.pi_power) ** float(exponent))
        return Unit(self.dimension**exponent, factor, is_exact=False)


def _exactly(dimension: Dimension, factor: int | str | Fraction = 1) -> Unit:
    return Unit(dimension, Fraction(factor))


def _angle(factor: Fraction, pi_power: int = 1) -> Unit:
    return Unit(DIMENSIONLESS, factor, pi_power, is_angle=True)


_POUND = Fraction("0.45359237")
_POUND_FORCE = _POUND * Fraction("9.80665")
_FOOT = Fraction("0.3048")
_INCH = Fraction("0.0254")
_DEGREE = Fraction(1, 180)

# Units that take SI prefixes by symbol.
PREFIXED = {
    "g": _exactly(MASS, Fraction(1, 1000)),
    "m": _exactly(LENGTH),
    "s": _exactly(TIME),
    "N": _exactly(FORCE),
    "J": _exactly(ENERGY),
    "W": _exactly(POWER),
    "Pa": _exactly(PRESSURE),
    "Hz": _exactly(ANGULAR_VELOCITY),
    "L": _exactly(VOLUME, Fraction(1, 1000)),
    "rad": _angle(Fraction(1), 0),
    "Wh": _exactly(ENERGY, 3600),
}
PREFIXES = {
    "p": -12, "n": -9, "u": -6, "µ": -6, "μ": -6, "m": -3, "c": -2, "d": -1,
    "da": 1, "h": 2, "k": 3, "M": 6, "G": 9, "T": 12,
}  # fmt: skip

# A test compares each of them with pint, which is asked only for names that are not here.
UNITS = {
    **PREFIXED,
    "gram": PREFIXED["g"],
    "kilogram": _exactly(MASS),
    "t": _exactly(MASS, 1000),
    "tonne": _exactly(MASS, 1000),
    "lb": _exactly(MASS, _POUND),
    "pound": _exactly(MASS, _POUND),
    "oz": _exactly(MASS, _POUND / 16),
    "slug": _exactly(MASS, _POUND_FORCE / _FOOT),
    "meter": _exactly(LENGTH),
    "metre": _exactly(LENGTH),
    "millimeter": _exactly(LENGTH, Fraction(1, 1000)),
    "centimeter": _exactly(LENGTH, Fraction(1, 100)),
    "kilometer": _exactly(LENGTH, 1000),
    "in": _exactly(LENGTH, _INCH),
    "inch": _exactly(LENGTH, _INCH),
    "ft": _exactly(LENGTH, _FOOT),
    "foot": _exactly(LENGTH, _FOOT),
    "feet": _exactly(LENGTH, _FOOT),
    "yd": _exactly(LENGTH, 3 * _FOOT),
    "mi": _exactly(LENGTH, 5280 * _FOOT),
    "mile": _exactly(LENGTH, 5280 * _FOOT),
    "nmi": _exactly(LENGTH, 1852),
    "thou": _exactly(LENGTH, _INCH / 1000),
    "l": PREFIXED["L"],
    "liter": PREFIXED["L"],
    "litre": PREFIXED["L"],
    "second": _exactly(TIME),
    "sec": _exactly(TIME),
    "min": _exactly(TIME, 60),
    "minute": _exactly(TIME, 60),
    "h": _exactly(TIME, 3600),
    "hr": _exactly(TIME, 3600),
    "hour": _exactly(TIME, 3600),
    "d": _exactly(TIME, 86400),
    "day": _exactly(TIME, 86400),
    "kph": _exactly(VELOCITY, Fraction(1000, 3600)),
    "mph": _exactly(VELOCITY, 5280 * _FOOT / 3600),
    "knot": _exactly(VELOCITY, Fraction(1852, 3600)),
    "newton": _exactly(FORCE),
    "dyn": _exactly(FORCE, Fraction(1, 100_000)),
    "kgf": _exactly(FORCE, "9.80665"),
    "lbf": _exactly(FORCE, _POUND_FORCE),
    "kip": _exactly(FORCE, 1000 * _POUND_FORCE),
    "joule": _exactly(ENERGY),
    "erg": _exactly(ENERGY, Fraction(1, 10_000_000)),
    "watt": _exactly(POWER),
    "hp": _exactly(POWER, 550 * _FOOT * _POUND_FORCE),
    "pascal": _exactly(PRESSURE),
    "bar": _exactly(PRESSURE, 100_000),
    "mbar": _exactly(PRESSURE, 100),
    "psi": _exactly(PRESSURE, _POUND_FORCE / _INCH**2),
    "atm": _exactly(PRESSURE, 101_325),
    "hertz": _exactly(ANGULAR_VELOCITY),
    "rpm": Unit(ANGULAR_VELOCITY, Fraction(2, 60), 1),
    "radian": _angle(Fraction(1), 0),
    "radians": _angle(Fraction(1), 0),
    "deg": _angle(_DEGREE),
    "degree": _angle(_DEGREE),
    "degrees": _angle(_DEGREE),
    "°": _angle(_DEGREE),
    "grad": _angle(Fraction(1, 200)),
    "arcmin": _angle(_DEGREE / 60),
    "arcsec": _angle(_DEGREE / 3600),
    "rev": _angle(Fraction(2)),
    "revolution": _angle(Fraction(2)),
    "turn": _angle(Fraction(2)),
}
