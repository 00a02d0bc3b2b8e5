"""From "9.81 m/s^2" or 3 to a number with its unit: in SI as a float, and as a fraction where that is exact."""

from __future__ import annotations

import math
import re
from collections.abc import Container
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from itertools import count

from freebody.errors import NoQuantity, UnitError
from freebody.language.decimals import written_number
from freebody.language.sentences import Message
from freebody.language.units.dimension import DIMENSIONLESS, Dimension
from freebody.language.units.reader import MAX_CHARACTERS, parse_unit
from freebody.language.units.table import Unit


@dataclass(frozen=True, slots=True)
class Quantity:
    """A number with its unit, in SI; angles in radians.

    `exact` is the value as a fraction, None where pi or an inexact unit is in it; `of_pi` is the value over pi where
    the unit has pi in it, exactly, so that 30 deg can stay pi/6 and 300 rpm 10 pi/s.
    """

    value: float
    exact: Fraction | None
    dimension: Dimension
    is_angle: bool
    text: str
    of_pi: Fraction | None = None

    @property
    def degrees(self) -> Fraction | None:
        """Of an angle that is given in degrees or turns."""
        return 180 * self.of_pi if self.of_pi is not None and self.is_angle else None


LARGEST = 1e60  # whose fifth power is a number still

_DIGITS = r"(?:[0-9]+\s*/\s*[1-9][0-9]*(?![0-9.]|\s*[/^])|(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+−]?[0-9]+)?)"
_NUMBER = re.compile(rf"\s*(?P<sign>[-+−]?)\s*(?P<digits>{_DIGITS})(?P<unit>.*)", re.S)


def parse_quantity(given: str | int | float | Fraction) -> Quantity:
    """A number, or a text of a number and a unit: "9.81 m/s^2", "30 deg", "5 kN", "3".

    Raises UnitError when the text cannot be read, the unit is unknown or the value is not finite.
    """
    if isinstance(given, str):
        return _quantity_of_text(given)
    if isinstance(given, bool):
        raise UnitError(Message("'{text}' is not a number", text=str(given).lower()))
    if isinstance(given, float) and not math.isfinite(given):
        raise UnitError(Message("{value} is not a number that can be calculated with", value=given))
    exact = written_number(repr(float(given))) if isinstance(given, float) else Fraction(given)
    return _quantity(exact, Unit(DIMENSIONLESS), str(given))


# a number and a unit as a part of a sum or a product: units have no plus, times or brackets in what is read here
_PART = re.compile(rf"(?<![\w.]){_DIGITS}\s*[A-Za-zµμ°][^-+−*()]*")


def quantities_within(text: str, taken: Container[str]) -> tuple[str, dict[str, Quantity]]:
    """An expression in which quantities with units stand, such as b + 0.1 m, with a new name for each of these."""
    found: dict[str, Quantity] = {}

    def named(match: re.Match[str]) -> str:
        if text[: match.start()].rstrip()[-1:] in ("/", "^"):  # a/2 m can be read in two ways
            return match.group()
        try:
            quantity = parse_quantity(match.group())
        except UnitError:
            return match.group()
        name = next(name for k in count(1) if (name := f"quantity_{k}") not in taken and name not in found)
        found[name] = quantity
        return f"({name})"

    return _PART.sub(named, text), found


@lru_cache(maxsize=2048)
def _quantity_of_text(text: str) -> Quantity:
    if len(text) > MAX_CHARACTERS:
        raise NoQuantity(
            Message("a quantity has at most {most} characters, this one has {n}", most=MAX_CHARACTERS, n=len(text))
        )
    found = _NUMBER.fullmatch(text)
    if found is None:
        raise UnitError(
            Message("'{text}' is not a quantity: write a number and a unit, as 9.81 m/s^2", text=text.strip())
        )
    digits = re.sub(r"\s", "", found["digits"].replace("−", "-").lower())
    if abs(int(digits.partition("e")[2][:6] or 0)) > 300:
        raise UnitError(
            Message("{digits} is too large or too small: the exponent of ten is at most 300", digits=digits)
        )
    exact = Fraction(digits) if "/" in digits else written_number(digits)
    exact *= -1 if found["sign"] in ("-", "−") and found["sign"] else 1
    return _quantity(exact, parse_unit(found["unit"]), text.strip())


def _quantity(number: Fraction, unit: Unit, text: str) -> Quantity:
    exact = number * unit.factor
    try:
        value = float(exact) * math.pi**unit.pi_power
    except OverflowError:
        value = math.inf
    if exact != 0 and not 1 / LARGEST <= abs(value) <= LARGEST:
        raise UnitError(
            Message(
                "{text} is too large or too small to calculate with: sizes go from {least:.0e} to {most:.0e} "
                "in SI units",
                text=text[:60],
                least=1 / LARGEST,
                most=LARGEST,
            )
        )
    is_exact = unit.is_exact and unit.pi_power == 0
    return Quantity(
        value=value,
        exact=exact if is_exact else None,
        dimension=unit.dimension,
        is_angle=unit.is_angle,
        text=text,
        of_pi=exact if unit.is_exact and unit.pi_power == 1 else None,
    )
