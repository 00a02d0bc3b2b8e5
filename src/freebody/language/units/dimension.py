"""Dimensions of mechanics: products of powers of mass, length and time.

    force = mass length time^-2        an angle, a ratio: all exponents 0

They multiply by adding exponents, and print as the SI unit one usually writes.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction


@dataclass(frozen=True, slots=True)
class Dimension:
    """Exponents of mass, length and time."""

    mass: Fraction = Fraction(0)
    length: Fraction = Fraction(0)
    time: Fraction = Fraction(0)

    def __mul__(self, other: Dimension) -> Dimension:
        return Dimension(self.mass + other.mass, self.length + other.length, self.time + other.time)

    def __truediv__(self, other: Dimension) -> Dimension:
        return self * other**-1

    def __pow__(self, exponent: int | Fraction) -> Dimension:
        return Dimension(self.mass * exponent, self.length * exponent, self.time * exponent)

    def __str__(self) -> str:
        """The usual SI unit: N, m/s^2, kg m^2, N m; 1 when dimensionless."""
        return _USUAL.get(self) or self._in_base_units()

    def _in_base_units(self) -> str:
        parts = (("kg", self.mass), ("m", self.length), ("s", self.time))
        above = [_powered(unit, n) for unit, n in parts if n > 0]
        below = [_powered(unit, -n) for unit, n in parts if n < 0]
        text = " ".join(above) or "1"
        if not below:
            return text
        return f"{text}/{below[0]}" if len(below) == 1 else f"{text}/({' '.join(below)})"


def _powered(unit: str, exponent: Fraction) -> str:
    if exponent == 1:
        return unit
    return f"{unit}^{exponent}" if exponent.denominator == 1 else f"{unit}^({exponent})"


def _dimension(mass: int, length: int, time: int) -> Dimension:
    return Dimension(Fraction(mass), Fraction(length), Fraction(time))


DIMENSIONLESS = _dimension(0, 0, 0)
MASS = _dimension(1, 0, 0)
LENGTH = _dimension(0, 1, 0)
TIME = _dimension(0, 0, 1)
AREA = LENGTH**2
VOLUME = LENGTH**3
DENSITY = MASS / VOLUME
VELOCITY = LENGTH / TIME
ACCELERATION = VELOCITY / TIME
ANGULAR_VELOCITY = DIMENSIONLESS / TIME
ANGULAR_ACCELERATION = ANGULAR_VELOCITY / TIME
FORCE = MASS * ACCELERATION
TORQUE = ENERGY = FORCE * LENGTH
POWER = ENERGY / TIME
PRESSURE = FORCE / AREA
INERTIA = MASS * AREA
MOMENTUM = IMPULSE = FORCE * TIME
ANGULAR_MOMENTUM = INERTIA / TIME
STIFFNESS = FORCE / LENGTH
DAMPING = FORCE / VELOCITY
ROTARY_STIFFNESS = TORQUE
ROTARY_DAMPING = TORQUE * TIME

_USUAL = {
    FORCE: "N",
    TORQUE: "N m",
    POWER: "W",
    PRESSURE: "Pa",
    STIFFNESS: "N/m",
    DAMPING: "N s/m",
    IMPULSE: "N s",
    ROTARY_DAMPING: "N m s",
    DIMENSIONLESS: "1",
}


def unit_of(dimension: Dimension) -> str:
    """The unit in which a measure is given: m, rad, or SI base units."""
    return {LENGTH: "m", DIMENSIONLESS: "rad"}.get(dimension, str(dimension))
