"""One measure that is led along a motion: as a formula in the time, a function, or samples with cubics between."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike

from freebody.errors import InputError
from freebody.language.expression import Expr, Symbol, number
from freebody.language.sentences import Message
from freebody.numeric.jets import TIME, Array
from freebody.study.given import formula, named_measure
from freebody.system.system import System

# text in `t` and the parameters; a number; a function of t giving (value, rate, acceleration); three arrays of these
Course = str | float | Callable[[float], Sequence[float]] | Sequence[ArrayLike]
CONNECTION = "motion"


class PrescribedMeasure:
    """One measure of the motion: its course as an expression in t, and at some time as numbers."""

    def __init__(self, system: System, name: str, course: Course, times: Array) -> None:
        self.name, self.measure = name, named_measure(system, name)
        self._call: Callable[[float], Sequence[float]] | None = None
        self.arrays: tuple[Array, Array, Array] | None = None
        self.expression: Expr | None = None
        if isinstance(course, (str, int, float)):
            self.expression = formula(system, name, course, in_time=True)
        elif callable(course):
            self._call = course
        else:
            arrays = [np.broadcast_to(np.asarray(part, dtype=np.float64), times.shape) for part in course]
            if len(arrays) != 3 or not all(np.isfinite(a).all() for a in arrays):
                raise InputError(
                    Message("{name}: give three arrays of finite numbers: values, rates and accelerations", name=name)
                )
            self.arrays = arrays[0], arrays[1], arrays[2]
        self._times = times

    @property
    def names(self) -> tuple[str, str, str]:
        """Hidden parameters with the numbers of an instant; no user can type these names."""
        return f"@{self.name}", f"@{self.name}'", f"@{self.name}''"

    def target(self) -> Expr:
        """The course; for numbers, its parabola about the time @t."""
        if self.expression is not None:
            return self.expression
        value, rate, acceleration = map(Symbol, self.names)
        later = Symbol(TIME) - Symbol("@t")
        return value + rate * later + acceleration * later * later * number(0.5)

    def numbers(self, t: float) -> Mapping[str, float]:
        """The hidden parameters at a time."""
        if self.expression is not None:
            return {}
        if self._call is not None:
            found = [float(x) for x in self._call(t)]
            if len(found) != 3 or not np.isfinite(found).all():
                raise InputError(
                    Message(
                        "{name}: its function must give value, rate and acceleration; found {found}",
                        name=self.name,
                        found=found,
                    )
                )
            return dict(zip(self.names, found, strict=True))
        assert self.arrays is not None
        return dict(zip(self.names, self._between(t), strict=True))

    def _between(self, t: float) -> tuple[float, float, float]:
        """Between the times of the arrays, a cubic through values and rates: on the way only."""
        assert self.arrays is not None
        values, rates, accelerations = self.arrays
        k = int(np.searchsorted(self._times, t))
        if k < len(self._times) and self._times[k] == t:
            return float(values[k]), float(rates[k]), float(accelerations[k])
        k = min(max(k, 1), len(self._times) - 1)
        if k < 1:
            return float(values[0]), float(rates[0]), float(accelerations[0])
        t0, t1 = float(self._times[k - 1]), float(self._times[k])
        h, s = t1 - t0, (t - t0) / (t1 - t0)
        y0, y1, d0, d1 = float(values[k - 1]), float(values[k]), float(rates[k - 1]) * h, float(rates[k]) * h
        c2, c3 = 3.0 * (y1 - y0) - 2.0 * d0 - d1, 2.0 * (y0 - y1) + d0 + d1
        value = y0 + s * (d0 + s * (c2 + s * c3))
        return value, (d0 + s * (2.0 * c2 + 3.0 * s * c3)) / h, (2.0 * c2 + 6.0 * s * c3) / h**2
