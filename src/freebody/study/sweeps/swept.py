"""What charts and files see of a sweep."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np

from freebody.numeric.jets import Array
from freebody.study.sweeps.evaluators import Column, Evaluator
from freebody.study.sweeps.plan import Plan
from freebody.study.sweeps.statistics import Statistics
from freebody.study.sweeps.store import CHUNK


@dataclass(frozen=True)
class Variable:
    """An array over axes of the sweep, which is read in slabs along the first of them."""

    name: str
    dimensions: tuple[str, ...]
    shape: tuple[int, ...]
    dtype: Any
    attributes: dict[str, Any]
    read: Callable[[int, int], Array]  # of flat places from, to

    def parts(self) -> Iterator[tuple[slice, Array]]:
        """Slabs and their values."""
        inner = math.prod(self.shape[1:])
        step = max(1, CHUNK // max(inner, 1))
        for a in range(0, self.shape[0], step):
            b = min(a + step, self.shape[0])
            yield slice(a, b), np.asarray(self.read(a * inner, b * inner), self.dtype).reshape(b - a, *self.shape[1:])


class Swept(Protocol):
    """A sweep, as far as it is drawn and written."""

    @property
    def plan(self) -> Plan: ...
    @property
    def evaluators(self) -> tuple[Evaluator, ...]: ...
    @property
    def columns(self) -> tuple[Column, ...]: ...
    @property
    def statistics(self) -> Mapping[str, Statistics]: ...
    @property
    def counts(self) -> Mapping[str, Mapping[str, int]]: ...
    @property
    def n(self) -> int: ...
    def values(self, name: str) -> Array: ...
    def in_language(self, text: str) -> str: ...
    def status(self, of: str) -> Any: ...
    def parameters(self) -> dict[str, Array]: ...
    @property
    def attributes(self) -> dict[str, Any]: ...
    def variables(self) -> Iterator[Variable]: ...
    def tables(self) -> Iterator[dict[str, Any]]: ...
