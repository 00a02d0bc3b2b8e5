"""What every kind of measure is."""

from __future__ import annotations

from collections.abc import Iterator
from typing import ClassVar, Protocol, TypeVar

from freebody.language.units import Dimension
from freebody.measures.geometry import Geometry, Point, Scalar

S = TypeVar("S", bound=Scalar)


class Measure(Protocol):
    """One scalar that the configuration determines, stated once for every route."""

    # True if only changes of it mean something (an arc rolled, a length of string): held at its start value
    incremental: ClassVar[bool] = False

    @property
    def is_angle(self) -> bool:
        """Whether it says how far something is turned, so that a bare number given for it may be one of degrees."""
        return False

    @property
    def is_size(self) -> bool:
        """Whether it is never negative, as a distance is."""
        return False

    @property
    def dimension(self) -> Dimension: ...

    def value(self, g: Geometry[S]) -> S:
        """The statement."""
        ...

    def bodies(self) -> Iterator[str]:
        """The bodies whose poses it reads."""
        ...

    def lines(self) -> Iterator[tuple[Point, Point]]:
        """The points between which it needs a line: where two of them coincide it has no gradient."""
        yield from ()
