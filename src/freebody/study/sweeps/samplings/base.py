"""The cases of a sweep: a table of values that is never there as a whole."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from freebody.errors import InputError
from freebody.language.sentences import Message
from freebody.numeric.jets import Array
from freebody.study.sweeps.ranges.base import Range

MOST = 1_000_000_000  # cases
GROUP = 1024  # cases that are drawn together, from a seed of their own


@dataclass(frozen=True)
class Sampling(ABC):
    """How cases are chosen from ranges. is_random: errors of means are told for it."""

    ranges: Mapping[str, Range]
    n: int

    is_random = False

    @property
    def dimensions(self) -> Mapping[str, int]:
        """The axes of what is found, the last one running fastest."""
        return {"case": self.n}

    @abstractmethod
    def cases(self, start: int, stop: int) -> Array:
        """(stop - start, n_names) values in SI, those of one case always the same."""


class Drawn(Sampling):
    """Cases by points in the unit cube."""

    @abstractmethod
    def points(self, start: int, stop: int) -> Array:
        """(stop - start, n_names) probabilities."""

    def cases(self, start: int, stop: int) -> Array:
        points = self.points(start, stop)
        columns = [of.quantiles(points[:, k]) for k, of in enumerate(self.ranges.values())]
        return np.column_stack(columns) if columns else np.zeros((stop - start, 0))


def how_many(text: str, form: str) -> int:
    """The number of cases. Raises InputError."""
    if not text.isdigit() or not 1 <= int(text) <= MOST:
        raise InputError(
            Message(
                "'{text}' is no number of cases: write for example {form}, with 1 to {most:,}",
                text=text,
                form=form,
                most=MOST,
            )
        )
    return int(text)


def groups(start: int, stop: int) -> range:
    """The groups of cases that lie between two of them."""
    return range(start // GROUP, -(-stop // GROUP))
