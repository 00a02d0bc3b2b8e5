"""The second opinion on stability: the full system linearised in numbers about the same steady motion."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product
from typing import TypeVar

import numpy as np

from freebody.errors import CannotAnswer, SaysNothing
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.model.elements import NonholonomicForm
from freebody.numeric.jets import Array
from freebody.numeric.snapshot import Snapshot
from freebody.study.answering.answer import Evidence
from freebody.study.answering.crosscheck import MIN_DRAWS, CrossCheck, element_at
from freebody.study.answering.draws import Draw
from freebody.study.setup import Setup
from freebody.study.steady.evidence import coordinate_accelerations, moving
from freebody.study.steady.linear import Linear
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.unknowns import Coordinate
from freebody.tolerances import ROUND_OFF

_Form = TypeVar("_Form", bound=Measure | NonholonomicForm)
_TOLERANCE = 1e-5  # relative, of second differences
_FACTORS = (0.2, 0.5, 1.0, 2.0, 5.0)  # times the rates of the start: on both sides of a condition
_FAST = 25.0  # where what oscillates needs to be faster than the start
_STEP = 1e-4  # rad, m
CLEARLY_STABLE, _CLEARLY_NOT = 1e-6, 1e-3  # real parts, beside the largest exponent


def agrees(setup: Setup, question: str, linear: Linear, signs: Sequence[Ratio]) -> Evidence:
    """The characteristic polynomial of the full system is the same, and its exponents grow where a sign is negative."""
    witness = CrossCheck(
        question, Message("numerical linearisation of the full system with slow and fast rates"), _TOLERANCE
    )
    verdicts = CrossCheck(question, Message("exponents of the numerical linearisation"), _TOLERANCE)

    def compare(case: tuple[Draw, float]) -> None:
        draw, factor = case
        about = About(setup, linear, draw, factor)
        coefficients = np.array(element_at(setup, tuple(linear.coefficients), draw, about.snapshot))
        values = element_at(setup, tuple(signs), draw, about.snapshot)
        exact = np.roots(coefficients[::-1])
        size = float(np.abs(exact).max(initial=0.0)) or 1.0
        powers = size ** np.arange(len(coefficients))[::-1]
        numeric = np.poly(about.matrix())[::-1]
        witness.compare(draw, tuple(coefficients / coefficients[-1] / powers), tuple(numeric / powers))
        grows = float(exact.real.max(initial=0.0)) / size
        if not CLEARLY_STABLE < grows < _CLEARLY_NOT and _is_clear(values):
            verdicts.compare(draw, float(all(v > 0 for v in values)), float(grows <= CLEARLY_STABLE))

    witness.gather(product(setup.draws, _FACTORS), compare, 4 * MIN_DRAWS)
    verdicts.evidence()
    return witness.evidence()


def swings(
    setup: Setup, question: str, linear: Linear, frequencies: Sequence[Ratio], positive: Sequence[Ratio]
) -> Evidence:
    """Each frequency is the imaginary part of an exponent of the full system, wherever it oscillates."""
    witness = CrossCheck(
        question, Message("numerical linearisation of the full system with slow and fast rates"), _TOLERANCE
    )

    def compare(case: tuple[Draw, float]) -> None:
        draw, factor = case
        about = About(setup, linear, draw, factor)
        signs = element_at(setup, tuple(positive), draw, about.snapshot)
        if not (_is_clear(signs) and all(x > 0 for x in signs)):
            raise SaysNothing(Message("there is no oscillation about it: it is unstable"))
        exact = element_at(setup, tuple(frequencies), draw, about.snapshot)
        own: list[float] = np.linalg.eigvals(about.matrix()).imag.tolist()
        witness.compare(draw, exact, tuple(float(min(own, key=lambda x: abs(x - w))) for w in exact))

    return witness.gather(product(setup.draw_stream(), (*_FACTORS, _FAST)), compare, 2 * MIN_DRAWS).evidence()


def _is_clear(values: Sequence[float]) -> bool:
    largest = max(map(abs, values))
    return all(abs(v) > ROUND_OFF * largest for v in values)


class About:
    """A steady motion of one draw in numbers."""

    def __init__(self, setup: Setup, linear: Linear, draw: Draw, factor: float) -> None:
        self.steady, self.draw = linear.steady, draw
        self.others = [(c, self._known(c, self.steady.model.measure_of(c))) for c in self.steady.others]
        self.cyclic = [(c, self._known(c, self.steady.model.form_of(c))) for c in self.steady.cyclic]
        start = draw.start()
        there = {index: element_at(setup, (linear.place[index],), draw, start)[0] for index in linear.moved}
        places = [there[c.index] if c.index in there else start.value(m) for c, m in self.others]
        if not np.isfinite(places).all():
            raise CannotAnswer(Message("there is no such motion"))
        self.places = np.array(places, dtype=np.float64)
        q = self._pose(self.places)
        rates = {c.speed: self._rate(c, m, start, factor, linear) for c, m in self.cyclic}
        first = moving(self.steady, draw, q, rates)
        rates |= {index: element_at(setup, (x,), draw, first)[0] for index, x in linear.rates.items()}
        self.rates = np.array([rates[c.speed] for c, _m in self.cyclic], dtype=np.float64)
        self.snapshot = moving(self.steady, draw, q, rates)

    @staticmethod
    def _known(c: Coordinate, seen: _Form | None) -> _Form:
        if seen is None:
            raise CannotAnswer(Message("{x} is no measure of the model, so its stability cannot be checked", x=c.name))
        return seen

    @staticmethod
    def _rate(
        c: Coordinate, measure: Measure | NonholonomicForm, start: Snapshot, factor: float, linear: Linear
    ) -> float:
        if c.speed in linear.rates and linear.rates[c.speed].is_zero():
            return 0.0
        rate = start.rate(measure)
        return factor * (rate if abs(rate) > 1e-6 else 3.0)

    def _pose(self, places: Array) -> Array:
        wanted = [(m, float(x)) for (_c, m), x in zip(self.others, places, strict=True)]
        return self.draw.reference.pose_near(self.draw.q, wanted)

    def matrix(self) -> Array:
        """Of d/dt (x, x', y), by central differences."""
        n, k = len(self.places), len(self.rates)
        size = float(np.abs(self.rates).max(initial=1.0))
        columns: list[Array] = []
        for j in range(2 * n + k):
            step = _STEP if j < n else 1e-2 * size
            ahead, back = (self._accelerations(j, e * step) for e in (1.0, -1.0))
            columns.append((ahead - back) / (2 * step))
        slopes = np.array(columns).T
        top = np.zeros((n, 2 * n + k))
        top[:, n : 2 * n] = np.eye(n)
        return np.vstack([top, slopes])

    def _accelerations(self, j: int, away: float) -> Array:
        """Of x and y, with one of (x, x', y) changed."""
        n = len(self.places)
        state = np.concatenate([self.places, np.zeros(n), self.rates])
        state[j] += away
        q = self._pose(state[:n])
        speeds = [c.speed for c, _m in self.others] + [c.speed for c, _m in self.cyclic]
        rates = dict(zip(speeds, map(float, state[n:]), strict=True))
        found = coordinate_accelerations(self.steady, self.draw, moving(self.steady, self.draw, q, rates))
        order = [self.steady.model.coordinates.index(c) for c, _m in (*self.others, *self.cyclic)]
        return found[order]
