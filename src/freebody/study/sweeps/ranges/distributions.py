"""Random values: `normal(2 kg, 5 %)` by mean and standard deviation, `uniform(1 kg, 3 kg)` by its ends,
`lognormal(2 kg, 5 %)` by median and relative spread, `triangular(1 kg, 2 kg, 4 kg)` by ends and mode between.

They are given by their quantiles.
Source: Evans, Hastings & Peacock, Statistical Distributions, 3rd ed. 2000, ch. 25, 29, 40, 41.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from freebody.errors import InputError
from freebody.language.sentences import Message
from freebody.numeric.jets import Array
from freebody.study.sweeps.ranges.base import Range, Read

FORM = "normal(2 kg, 5 %), uniform(1 kg, 3 kg), lognormal(2 kg, 5 %), triangular(1 kg, 2 kg, 4 kg)"
_FORM = re.compile(r"(?P<kind>[a-z]+)\s*\((?P<of>[^()]*)\)")


@dataclass(frozen=True)
class Distribution(Range):
    """A distribution by its quantile function."""

    kind: str
    of: tuple[float, ...]

    @property
    def extent(self) -> tuple[float, float]:
        if self.kind == "normal":
            return -math.inf, math.inf
        return (0.0, math.inf) if self.kind == "lognormal" else (self.of[0], self.of[-1])

    def quantiles(self, u: Array) -> Array:
        return _QUANTILES[self.kind](u, *self.of)


def _normal(u: Array, mean: float, spread: float) -> Array:
    return mean + spread * _standard(u)


def _standard(u: Array) -> Array:
    """The quantiles of the standard normal distribution; u = 0, which a scrambled sequence may hit, is the least."""
    from scipy.special import ndtri

    return ndtri(np.clip(u, 2.0**-60, 1.0 - 2.0**-53))


def _lognormal(u: Array, median: float, spread: float) -> Array:
    return median * np.exp(spread / median * _standard(u))


def _uniform(u: Array, low: float, high: float) -> Array:
    return low + (high - low) * u


def _triangular(u: Array, low: float, mode: float, high: float) -> Array:
    part = (mode - low) / (high - low)
    rising = low + np.sqrt(u * (high - low) * (mode - low))
    return np.where(u < part, rising, high - np.sqrt((1.0 - u) * (high - low) * (high - mode)))


_QUANTILES: dict[str, Callable[..., Array]] = {
    "normal": _normal,
    "uniform": _uniform,
    "lognormal": _lognormal,
    "triangular": _triangular,
}
_COUNT = {"normal": 2, "uniform": 2, "lognormal": 2, "triangular": 3}


def read(text: str, read: Read) -> Distribution | None:
    found = _FORM.fullmatch(text)
    if found is None or found["kind"] not in _QUANTILES:
        return None
    kind, parts = found["kind"], [part.strip() for part in found["of"].split(",")]
    if len(parts) != _COUNT[kind]:
        raise InputError(Message("{text}: {kind} takes {n} numbers", text=text, kind=kind, n=_COUNT[kind]))
    first = read(parts[0])
    rest = [_relative(part, first) if part.endswith("%") else read(part) for part in parts[1:]]
    made = Distribution(kind, (first, *rest))
    is_spread = kind in ("normal", "lognormal")
    is_ordered = made.of[1] > 0 if is_spread else all(a <= b for a, b in zip(made.of, made.of[1:], strict=False))
    if not is_ordered or (not is_spread and made.of[0] == made.of[-1]) or (kind == "lognormal" and first <= 0.0):
        if is_spread:
            raise InputError(Message("{text}: the spread and a median must be positive", text=text))
        raise InputError(Message("{text}: the numbers must rise", text=text))
    return made


def _relative(part: str, of: float) -> float:
    try:
        return abs(of) * float(part[:-1]) / 100.0
    except ValueError:
        raise InputError(Message("{text} is no percentage", text=part)) from None
