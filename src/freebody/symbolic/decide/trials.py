"""Counterexamples by numbers: a point at which premises hold and an element has the other sign ends the question
whether it has one, before any cells are made.

Floating-point numbers find the point, and balls prove it, so that nothing is taken for refuted that is true. Where no
point is found nothing is known.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, Protocol

from freebody.symbolic.decide.refuting import Enclosed
from freebody.symbolic.ratio import Ratio

_MOST_TRIED = 3  # points that balls look at, for one sign


class Points(Protocol):
    """Admissible numbers for all that is free in a field, many sets at once."""

    def evaluate(self, x: Ratio) -> Any:
        """The values of an element in all sets, as an array of floats; nan where it is not real."""
        ...

    def numbers(self, k: int) -> Mapping[int, float]:
        """Those of one set, by generators."""
        ...


class Premise(Protocol):
    """`element relation 0`."""

    @property
    def element(self) -> Ratio: ...
    @property
    def relation(self) -> str: ...


class Trials:
    """What is known of elements at points."""

    def __init__(self, points: Points) -> None:
        self.points = points
        self._values: dict[Any, Any] = {}
        self._enclosed: dict[int, Enclosed] = {}

    def refute(self, factors: Sequence[Ratio], sign: int, premises: Sequence[Premise]) -> bool:
        """Whether a product does not have a sign (+1 or -1), nor vanishes, at some point inside of the premises."""
        inside = -sign * self._product(factors) > 0
        for p in premises:
            inside = inside & (self._of(p.element) != 0 if p.relation == "!=" else self._of(p.element) > 0)
        return any(self._is_proved(k, factors, -sign, premises) for k in self._first(inside))

    def _first(self, inside: Any) -> Iterator[int]:
        yield from map(int, inside.nonzero()[0][:_MOST_TRIED])

    def _product(self, factors: Sequence[Ratio]) -> Any:
        found = self._of(factors[0])
        for x in factors[1:]:
            found = found * self._of(x)
        return found

    def _of(self, x: Ratio) -> Any:
        key = x.key()
        if key not in self._values:
            self._values[key] = self.points.evaluate(x)
        return self._values[key]

    def _is_proved(self, k: int, factors: Sequence[Ratio], sign: int, premises: Sequence[Premise]) -> bool:
        if k not in self._enclosed:
            self._enclosed[k] = Enclosed(self.points.numbers(k))
        at = self._enclosed[k]
        for x in factors:
            sign *= at.sign(x)
        signs = [at.sign(p.element) for p in premises]
        return sign == 1 and all(s if p.relation == "!=" else s > 0 for s, p in zip(signs, premises, strict=True))
