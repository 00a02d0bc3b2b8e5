"""What a name runs through: the values of a grid, and the quantiles of what is drawn."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable

from freebody.numeric.jets import Array

Read = Callable[[str], float]  # a number with or without a unit, in SI


class Range(ABC):
    """How one name varies."""

    @property
    @abstractmethod
    def extent(self) -> tuple[float, float]:
        """The least and the greatest value; infinite where nothing bounds them."""

    @abstractmethod
    def quantiles(self, u: Array) -> Array:
        """(n,) values to probabilities (n,) between 0 and 1."""

    @property
    def grid(self) -> Array | None:
        """The values of a grid, in their order; None where it has none."""
        return None
