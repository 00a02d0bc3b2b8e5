"""A place on a string's way."""

from __future__ import annotations

from dataclasses import dataclass

from freebody.language.expression import Expr
from freebody.measures.geometry import Direction, Point


@dataclass(frozen=True)
class StringNode:
    """A place on the string's way: an end, a pulley it runs over or under, or a drum it is wound on."""

    point: Point
    radius: Expr
    way: str  # "end", "over", "under", "around", "drum"
    side: str | None
    turn: str | None
    hangs: bool
    is_put: bool  # it would hang, but for its place, which the model gives
    guide: Direction | None  # the lead runs along it
    track: Direction | None  # of a body that is guided where the model puts it
    place: tuple[float, float] | None

    @property
    def body(self) -> str:
        return self.point.body

    @property
    def called(self) -> tuple[str, ...]:
        """Names by which people ask for the tension there: the body, the point where it is one of several."""
        return tuple(dict.fromkeys((str(self.point), self.body)))
