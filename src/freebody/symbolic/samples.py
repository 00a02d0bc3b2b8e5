"""What samples decide: numbers for every generator, and by them the signs and zeros that formulas leave open.

A length of a line is l = sqrt(x^2 + y^2 - offset^2), its angle turns at l da/dt = n . dv/dt, and l itself changes at
e . dv/dt + offset da/dt. An element vanishes on the motion if it does formally, or, where closed loops bind the
coordinates, if its terms cancel at samples in general position. A sign taken at the first sample is an assumption.
"""

from __future__ import annotations

import copy
import math
import random
from collections.abc import Generator, Iterable, Mapping, Sequence
from contextlib import contextmanager
from typing import Any

from freebody.language.expression import evaluate
from freebody.language.notation import to_text
from freebody.symbolic.bodies import Bodies
from freebody.symbolic.decide.refuting import Enclosed, is_proved_not_zero
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.sample import Sample
from freebody.symbolic.signs import Sign, sign_of
from freebody.symbolic.unknowns import Coordinate, ModelUnknowns
from freebody.symbolic.values_of_terms import NoValue
from freebody.tolerances import ROUND_OFF


class Samples:
    """The sample points of a model, and what is read off them."""

    def __init__(self, unknowns: ModelUnknowns, bodies: Bodies, points: Sequence[Sample]) -> None:
        self._unknowns, self._bodies = unknowns, bodies
        self.field = unknowns.field
        self.points = tuple(points)
        self.assumed: list[Ratio] = []  # elements taken to be positive, as they are at the first sample
        self._n_settled = 0  # of these: those that every question takes
        self.start_symbols: dict[int, Ratio] = {}  # by coordinate
        self.has_loops = True  # so long as coordinates are being chosen nothing is known of loops
        self._without_rate: set[int] = set()  # speeds of measures without a rate at a sample
        self._known: list[dict[int, Any]] = []
        self.read_again()

    def copy(self) -> Samples:
        """The same numbers, with assumptions of its own."""
        other = copy.copy(self)
        other.assumed = list(self.assumed)
        return other

    @contextmanager
    def apart(self) -> Generator[None]:
        """What is assumed inside is so for what is found there only."""
        n_assumed = len(self.assumed)
        try:
            yield
        finally:
            del self.assumed[n_assumed:]

    @contextmanager
    def taking(self) -> Generator[list[Ratio]]:
        """What is assumed inside, of what was not assumed before, and for what is found there only."""
        before, self.assumed, taken = self.assumed, list[Ratio](), list[Ratio]()
        try:
            yield taken
        finally:
            taken += [x for x in self.assumed if x not in before]
            self.assumed = before

    # -- what is kept from one question to the next -------------------------------------------
    def settle(self) -> None:
        """What is assumed by now is so for every question."""
        self._n_settled = len(self.assumed)

    def forget(self) -> None:
        """What one question took to be positive is no condition of the next."""
        del self.assumed[self._n_settled :]

    @contextmanager
    def carrying(self) -> Generator[list[Ratio]]:
        """What is assumed inside beyond what every question takes, whatever was assumed before: so that a value that is
        kept carries what it stands on, and not what happened to be asked earlier."""
        before, self.assumed, carried = self.assumed, self.assumed[: self._n_settled], list[Ratio]()
        try:
            yield carried
        finally:
            carried += self.assumed[self._n_settled :]
            self.assumed = before

    def take(self, x: Ratio) -> None:
        """An element is taken to be positive."""
        if all(x != other for other in self.assumed):
            self.assumed.append(x)

    # -- numbers of the generators ------------------------------------------------------------
    def read_again(self) -> None:
        """Numbers for all generators there are by now."""
        self._known = [self._values_at(sample) for sample in self.points]

    def numbers(self, sample: Sample, start: Sample | None = None) -> dict[int, Any]:
        """Values of all generators at a sample with velocities, for evaluating results there; `start` is the same
        draw at the start, for symbols of start values."""
        values = self._values_at(sample)
        if self.start_symbols:
            first = values if start is None else self._values_at(start)
            for index, symbol in self.start_symbols.items():
                values[self.field.index(symbol)] = first[index]
            values = self.field.complete(values)
        return values

    def _values_at(self, sample: Sample) -> dict[int, Any]:
        """Values of all generators at a sample; speeds and accelerations that it does not tell are arbitrary."""
        f, unknowns = self.field, self._unknowns
        values: dict[int, Any] = {}
        for name, g in unknowns.parameters.items():
            if f.index(g) not in unknowns.functions:
                values[f.index(g)] = sample.time if name == "t" else sample.parameters[name]
        for index, form in unknowns.functions.items():
            values[index] = float(evaluate(form, {**sample.parameters, "t": sample.time}))
        for name, g in unknowns.constants.items():
            values[f.index(g)] = sample.constants[name]
        self._bodies.add_numbers(values, sample)
        values = f.complete(values)
        if sample.velocities:
            self._add_speeds(values)
        self._add_arbitrary(values)
        return f.complete(values)

    def _add_arbitrary(self, values: dict[int, Any]) -> None:
        """Speeds and accelerations that nothing tells: by their names, so that no order of questions changes them."""
        for index, generator in self.field.generators.items():
            is_free = index not in values and index not in self._without_rate
            if is_free and generator.kind in ("speed", "acceleration"):
                values[index] = random.Random(to_text(generator.display)).uniform(0.5, 1.5)

    def _add_speeds(self, values: dict[int, Any]) -> None:
        """Speeds of lines, by l da/dt = n . dv/dt and dl/dt = e . dv/dt + offset da/dt, of roots l^2 = x, by
        2 l dl/dt = dx/dt, and of named measures. Some have none, as the rate of a distance has where its ends coincide:
        nothing else waits for them."""
        f, speeds = self.field, self._unknowns.speeds
        for line in self._unknowns.lines:
            # a line without length has no direction that could turn
            if not values.get(line.length) or line.angle not in values:
                self._without_rate |= {speeds[line.angle], speeds[line.length]}
                continue
            vx, vy = (f.evaluate(f.rate(c), values) for c in (line.x, line.y))
            cos, sin = math.cos(values[line.angle]), math.sin(values[line.angle])
            turning = (cos * vy - sin * vx) / values[line.length]
            values[speeds[line.angle]] = turning
            values[speeds[line.length]] = cos * vx + sin * vy + f.evaluate(line.offset, values) * turning
        for index, square in self._unknowns.roots.items():
            if values.get(index):
                values[speeds[index]] = f.evaluate(f.rate(square), values) / (2.0 * values[index])
            else:
                self._without_rate.add(speeds[index])
        for index, value in self._unknowns.defined.items():
            try:
                values[speeds[index]] = f.evaluate(f.rate(value), values)
            except (NoValue, ZeroDivisionError):
                self._without_rate.add(speeds[index])

    def _values(self, k: int) -> dict[int, Any]:
        """Sample k, with the atoms made since."""
        known = self._known[k]
        if len(known) < len(self.field.generators):
            self._add_arbitrary(known)
            self._known[k] = self.field.complete(known)
        return self._known[k]

    def put_in(self, index: int, values: Sequence[float]) -> None:
        """A value for a generator at every sample."""
        for known, value in zip(self._known, values, strict=True):
            known[index] = value

    def put_in_formulas(self, formulas: Mapping[int, Ratio]) -> None:
        """Generators that follow from others, at every sample."""
        for k in range(len(self.points)):
            values = self._values(k)
            for index, x in formulas.items():
                try:
                    values[index] = self.field.evaluate(x, self._values(k))
                except ZeroDivisionError:  # the formula fails in the pose of this sample
                    values[index] = math.nan

    def has_values(self, index: int) -> bool:
        """Whether an unknown has a value at every sample; the length of a line must not be zero, or it has no angle."""
        lengths = {line.length for line in self._unknowns.lines}
        for values in self._known:
            value = values.get(index)
            if value is None or not math.isfinite(value) or (index in lengths and abs(value) < ROUND_OFF):
                return False
        return True

    # -- numbers of elements ------------------------------------------------------------------
    @property
    def _starts(self) -> list[int]:
        return [k for k, s in enumerate(self.points) if s.is_start]

    def at_starts(self, x: Ratio) -> list[float]:
        """The element in numbers at the start poses of all samples; nan where it has no real value."""
        return self._at(x, self._starts)

    def everywhere(self, x: Ratio) -> list[float]:
        """The same at all samples."""
        return self._at(x, range(len(self.points)))

    def _at(self, x: Ratio, which: Iterable[int]) -> list[float]:
        found: list[float] = []
        for k in which:
            try:
                found.append(float(self.field.evaluate(x, self._values(k))))
            except (KeyError, ValueError, ArithmeticError):
                found.append(math.nan)
        return found

    def at_start_with(self, x: Ratio, number: int, changed: Mapping[int, float]) -> float:
        """The element at the start pose of that number, with other values of some generators; nan if it is not real."""
        f = self.field
        known = self._values(self._starts[number])
        needed = f.ingredients(x)
        values = {g: v for g, v in known.items() if not f.generators[g].made_of & changed.keys()} | dict(changed)
        try:
            for g in sorted(needed - values.keys()):
                compute = f.generators[g].compute
                assert compute is not None
                values[g] = compute(values, math)
            return float(f.evaluate(x, values))
        except (KeyError, ValueError, ArithmeticError):
            return math.nan

    # -- start values -------------------------------------------------------------------------
    def start_numbers(self, index: int) -> list[float]:
        """The start value of a generator at every sample that is a start pose."""
        return [float(self._values(k)[index]) for k in self._starts]

    def start_parameter(self, c: Coordinate, numbers: Sequence[float]) -> Ratio:
        """A symbol for a start value that follows from the assembly only."""
        symbol = self.field.parameter(f"{c.name}_0")
        starts = iter(numbers)
        last = numbers[0] if numbers else 0.0
        for k, sample in enumerate(self.points):
            last = next(starts, last) if sample.is_start else last
            self._known[k][self.field.index(symbol)] = last
        self.start_symbols[c.index] = symbol
        return symbol

    def starts_at_zero(self, name: str) -> bool:
        """Whether the start value of an incremental row or load is zero at every sample."""
        return all(abs(s.constants.get(name, 0.0)) < ROUND_OFF for s in self.points)

    def is_start_value(self, x: Ratio, name: str) -> bool:
        """Whether a formula gives the start values that were found for an incremental row or load by assembling the
        start, a length of 1e12 m as one of 1 m."""
        found = (self.points[k].constants.get(name, 0.0) for k in self._starts)
        pairs = zip(self.at_starts(x), found, strict=True)
        return all(math.isclose(a, b, rel_tol=1e-7, abs_tol=1e-7) for a, b in pairs)

    # -- zeros and signs ----------------------------------------------------------------------
    def vanishes(self, x: Ratio) -> bool:
        """True if the element is zero on the motion: formally, or at all samples where coordinates are bound by
        closed loops; of parameters alone not where balls prove the contrary."""
        if x.is_zero():
            return True
        fraction = x.fraction()
        if fraction is not None or not self.points:
            return False
        if not self.has_loops:
            return False
        # poses in general position, since an entry may vanish at the start and nowhere else
        general = [k for k, s in enumerate(self.points) if not s.is_start]
        # what does not vanish shows it at the first of them, nearly always
        which = general or range(len(self.points))
        return all(self._vanishes_at(x, k) for k in which) and not self._is_refuted(x, which[0])

    def _is_refuted(self, x: Ratio, k: int) -> bool:
        """Whether balls prove that an element is not zero at a sample, though its terms cancel in doubles: where it is
        made of parameters alone, whose numbers are exact. Poses of loops are assembled to round-off only."""
        generators = self.field.generators
        free = [g for g in self.field.ingredients(x) if generators[g].compute is None]
        if any(generators[g].kind not in ("parameter", "time") for g in free):
            return False
        values = self._values(k)
        return is_proved_not_zero(x, {g: float(values[g]) for g in free if g in values})

    def is_nonzero_where(self, x: Ratio, there: Mapping[int, Ratio]) -> bool:
        """Whether balls prove that an element is not zero where some generators are certain elements, so that it is no
        zero of the field with these put in, however long that takes; all others are as at the first start."""
        if not self._starts:
            return False
        values, generators = self._values(self._starts[0]), self.field.generators
        numbers = {g: float(value) for g, value in values.items() if generators[g].compute is None}
        return Enclosed(numbers, there).sign(x) != 0

    def vanishes_at_starts(self, x: Ratio) -> bool:
        """Whether the terms of an element cancel at every start."""
        starts = self._starts
        return bool(starts) and all(self._vanishes_at(x, k) for k in starts)

    def _vanishes_at(self, x: Ratio, k: int) -> bool:
        """Whether the terms of an element cancel at a sample: beside their own sizes, so in all units."""
        try:
            value, size = self.field.numerator_and_size(x, self._values(k))
        except (KeyError, ValueError, ArithmeticError):
            return False
        return abs(value) <= ROUND_OFF * size

    def is_negative(self, x: Ratio) -> bool:
        """The sign at the first sample, where formulas do not tell; the choice is noted as an assumption. A length that
        is a root is none by definition, and zero has no sign to choose (two roots of an angle that coincide)."""
        if x.is_zero() or sign_of(x) in (Sign.POSITIVE, Sign.NONNEGATIVE) or self._is_length(x):
            return False
        values = self.at_starts(x)
        negative = bool(values) and values[0] < 0
        self.take(-x if negative else x)
        return negative

    def _is_length(self, x: Ratio) -> bool:
        """Whether an element is one of the lengths that are unknowns with a square."""
        inside = x.generators()
        return len(inside) == 1 and inside <= self._unknowns.roots.keys() and x == self.field.variable(min(inside))

    def is_turned(self, x: Ratio) -> bool | None:
        """The same; None where something stands in it that changes: what is on one side at an instant may be on the
        other at the next. What is taken to be positive already stays so."""
        sign = sign_of(x)
        if sign in (Sign.POSITIVE, Sign.NONNEGATIVE) or x in self.assumed:
            return False
        if sign in (Sign.NEGATIVE, Sign.NONPOSITIVE) or -x in self.assumed:
            return True
        kinds = {self.field.generators[g].kind for g in self.field.ingredients(x)}
        if kinds & {"coordinate", "speed", "acceleration", "time"}:
            return None
        # a difference that vanishes at the numbers of the file, as of two heights, has no sign to choose
        is_border = bool(self._starts) and self._vanishes_at(x, self._starts[0])
        return None if is_border else self.is_negative(x)
