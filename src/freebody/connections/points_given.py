"""Points that a connection is given: written in the model, or in a table beside it (`model.tables`)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, cast

from freebody.language.sentences import Message
from freebody.language.units import Dimension
from freebody.model.tables import read_table

if TYPE_CHECKING:
    from freebody.model.names import Names

FIELD = "points"
PointList = Sequence[Any] | str  # what a field of points may be: a list, or the name of a table


@dataclass(frozen=True)
class GivenPoints:
    """Pairs of numbers [SI], and where each stands. lines: in a table, of which file."""

    pairs: tuple[tuple[float, float], ...]
    file: str = ""
    lines: tuple[int, ...] = ()

    def problem(self, names: Names, told: Message, k: int | None = None) -> None:
        """Notes a problem of a point, or of all."""
        if self.file and k is None:
            names.problem(Message("{file}: {why}", file=self.file, why=told), FIELD)
        elif self.file and k is not None:
            names.problem(Message("{file}, line {line}: {why}", file=self.file, line=self.lines[k], why=told), FIELD)
        else:
            names.problem(told, FIELD, *(() if k is None else (k,)))


def read_points(
    names: Names, given: PointList, columns: Sequence[tuple[str, Dimension]], pair: Message, numbers: Message
) -> GivenPoints | None:
    """None with a problem noted. columns: names of the two numbers and their dimensions; pair: what a point is;
    numbers: that it needs parameters with values."""
    if isinstance(given, str):
        rows = read_table(names, given, columns, FIELD)
        if rows is None:
            return None
        return GivenPoints(tuple((x, y) for _line, (x, y) in rows), given, tuple(line for line, _values in rows))
    found: list[tuple[float, float]] = []
    for k, each in enumerate(given):
        point = cast("list[Any]", each) if isinstance(each, list) else []
        if len(point) != len(columns):
            names.problem(pair, FIELD, k)
            return None
        x, y = (
            names.numeric(names.formula(value, dimension, FIELD, k, j))
            for j, (value, (_name, dimension)) in enumerate(zip(point, columns, strict=True))
        )
        if x is None or y is None:
            names.problem(numbers, FIELD, k)
            return None
        found.append((x, y))
    return GivenPoints(tuple(found))
