"""Typed numbers against the value of an answer: unit, tolerance, and what went wrong with one that is off."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from freebody.errors import InputError, UnitError
from freebody.language.sentences import Message
from freebody.language.typed import TypedNumber
from freebody.language.units import DIMENSIONLESS, Dimension, parse_quantity

_ROUNDED = 5.0  # times the tolerance: rounded on the way, not wrong
_RAD = 180.0 / math.pi


@dataclass(frozen=True)
class Tolerance:
    """How far a number may be off: by a share of the value (relative), in SI units (absolute), or in the last of so
    many digits."""

    relative: float = 0.0
    absolute: float = 0.0
    digits: int = 0

    @classmethod
    def read(cls, text: str) -> Tolerance:
        """'1 %', '0.05 N' or '3 digits'. Raises InputError."""
        words = text.strip()
        if (found := re.fullmatch(r"(\d{1,2})\s*(?:digits?|Stellen|sig)", words)) is not None and int(found[1]) > 0:
            return cls(digits=int(found[1]))
        try:
            if words.endswith("%"):
                return cls(relative=_positive(float(words[:-1].replace(",", ".")) / 100.0, text))
            return cls(absolute=_positive(parse_quantity(words.replace(",", ".")).value, text))
        except (UnitError, ValueError):
            told = Message("the tolerance '{text}' cannot be read: write '1 %', '0.05 N' or '3 digits'", text=text)
            raise InputError(told) from None

    def room(self, value: float) -> float:
        """By how much a number may differ from a value."""
        if self.digits:
            if not value:
                return 0.0
            return 0.5001 * 10.0 ** (math.floor(math.log10(abs(value))) - self.digits + 1)
        return max(self.absolute, self.relative * abs(value))


ONE_PERCENT = Tolerance(relative=0.01)


def _positive(x: float, text: str) -> float:
    if not math.isfinite(x) or x < 0:
        raise InputError(Message("the tolerance '{text}' is negative or no number", text=text))
    return x


def are_near(given: Sequence[float], values: Sequence[float], tolerance: Tolerance, factor: float = 1.0) -> bool:
    """Whether all numbers are within the tolerance; that of a vector is by its largest component."""
    size = max(map(abs, values))
    room = factor * tolerance.room(size) + 1e-12 * size
    return len(given) == len(values) and all(abs(a - b) <= room for a, b in zip(given, values, strict=True))


@dataclass(frozen=True)
class NumberFault:
    """What is wrong with a number, and the mistake where it is found."""

    reason: str
    mistake: str = ""
    digits: str = ""


def fault_of(
    given: Sequence[TypedNumber],
    values: Sequence[float],
    unit: Dimension,
    tolerance: Tolerance,
    others: Mapping[str, Sequence[float]],
) -> NumberFault:
    """Why numbers are not the values. others: values that follow from a known mistake, by its words."""
    numbers = [n.value for n in given]
    shown = ", ".join(f"{n.value:.4g}" for n in given)
    right = ", ".join(f"{v:.4g}" for v in values)
    behind = "" if unit == DIMENSIONLESS else f" {unit}"
    plain = Message("{x} is not {right}", x=f"{shown}{behind}", right=f"{right}{behind}")
    for said, wrong in others.items():
        if are_near(numbers, wrong, tolerance):
            return NumberFault(plain, said)
    if are_near([-n for n in numbers], values, tolerance):
        return NumberFault(plain, Message("the sign is wrong"))
    if unit == DIMENSIONLESS and are_near([n / _RAD for n in numbers], values, tolerance):
        return NumberFault(plain, Message("degrees are given for radians"))
    if any(n.n_digits for n in given) and are_near(numbers, values, tolerance, _ROUNDED):
        return NumberFault(plain, Message("it was rounded too early, or too much"))
    size, own = max(map(abs, values)), max(map(abs, numbers))
    if size and own:
        power = round(math.log10(own / size))
        if power and are_near([n / 10.0**power for n in numbers], values, tolerance):
            return NumberFault(plain, Message("it is off by a factor of 10^{n}: a prefix or the point", n=power))
    return NumberFault(plain)
