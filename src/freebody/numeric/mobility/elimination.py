"""Sparse elimination of rows in their order: which are independent, and which say again what others say.

Rows are eliminated in the order of the model,

    row_k - sum over earlier pivots p of m_kp pivot_p = rest_k,

and a row whose rest vanishes depends on earlier ones; its multipliers, followed back, are the one combination of
kept rows that it equals. These rows with it are its fundamental circuit: leave any of them out and the others are
independent. Since kept rows come first, the redundant row of a circuit is the one declared last.
Numbers are floats, or balls that contain what they stand for: a pivot that does not contain zero is not zero.
Sources: Oxley, Matroid Theory, 2nd ed. 2011, sec. 1.2 (fundamental circuits); Duff, Erisman & Reid, Direct Methods for
Sparse Matrices, 2nd ed. 2017, ch. 5 and 7.
"""

from __future__ import annotations

import heapq
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from freebody.language.sentences import Message
from freebody.numeric.mobility.exact import Gradient, is_zero, size_of

CLEAR = 1e-9  # a rest that is larger is not zero: smaller ones would be told apart from zero by the data's last digits

Row = dict[int, Any]


class Unclear(Exception):
    """A rest is neither zero nor clearly something else."""


@dataclass
class CircuitElimination:
    """Rows eliminated in their order. `kept` are the independent ones, `circuits` holds for every other row the
    kept ones that it depends on, and itself.

    zero: rests that are smaller count as zero, rests between it and `clear` raise Unclear. Rows are to have entries
    of about one.
    """

    zero: float
    clear: float = CLEAR
    kept: list[int] = field(default_factory=list[int])
    circuits: list[tuple[int, ...]] = field(default_factory=list[tuple[int, ...]])
    smallest: float = 1.0  # the smallest pivot
    largest: float = 0.0  # the largest rest that counts as zero
    _pivots: list[tuple[int, Any, Row]] = field(default_factory=list[tuple[int, Any, Row]], repr=False)
    _at: dict[int, int] = field(default_factory=dict[int, int], repr=False)  # column -> which pivot
    _steps: list[list[tuple[int, Any]]] = field(default_factory=list[list[tuple[int, Any]]], repr=False)

    @classmethod
    def of(cls, rows: Sequence[Row], zero: float, clear: float = CLEAR) -> CircuitElimination:
        made = cls(zero, clear)
        counts: dict[int, int] = {}
        for row in rows:
            for k in row:
                counts[k] = counts.get(k, 0) + 1
        for k, row in enumerate(rows):
            made._take(k, row, counts)
        return made

    @property
    def rank(self) -> int:
        return len(self.kept)

    def _take(self, index: int, row: Row, counts: Mapping[int, int]) -> None:
        rest, steps = self._reduced(dict(row))
        sizes = {k: size_of(c) for k, c in rest.items()}
        if not math.isfinite(sum(sizes.values())):
            raise Unclear(Message("a row has no finite entries"))
        most = max(sizes.values(), default=0.0)
        if most <= self.zero:
            self.largest = max(self.largest, most)
            self.circuits.append((*sorted(self._combination(steps)), index))
            return
        if most < self.clear:
            raise Unclear(Message("a row is left with entries of {most:.1e} after elimination", most=most))
        # of the large entries the one in the column that is used least: it is eliminated most rarely
        column = min((k for k, size in sizes.items() if size > 0.1 * most), key=lambda k: (counts[k], -sizes[k]))
        pivot = rest.pop(column)
        if not abs(pivot) > self.zero:
            raise Unclear(Message("a pivot is not proved to differ from zero"))
        self.smallest = min(self.smallest, size_of(pivot))
        self._at[column] = len(self._pivots)
        self._pivots.append((index, pivot, rest))
        self._steps.append(steps)
        self.kept.append(index)

    def _reduced(self, row: Row) -> tuple[Row, list[tuple[int, Any]]]:
        """The row less what earlier pivots account for, and how much of each that is."""
        at = self._at
        columns = {at[k]: k for k in row if k in at}
        waiting = list(columns)
        heapq.heapify(waiting)
        steps: list[tuple[int, Any]] = []
        while waiting:
            p = heapq.heappop(waiting)
            c = row.pop(columns[p], None)
            if c is None or size_of(c) <= self.zero:
                continue
            _index, pivot, others = self._pivots[p]
            factor = c / pivot
            steps.append((p, factor))
            for k, other in others.items():
                if k in row:
                    row[k] = row[k] - factor * other
                    continue
                row[k] = -(factor * other)
                if k in at and at[k] not in columns:
                    columns[at[k]] = k
                    heapq.heappush(waiting, at[k])
        return row, steps

    def _combination(self, steps: Sequence[tuple[int, Any]]) -> list[int]:
        """The kept rows with a part in what these steps took away."""
        parts: dict[int, Any] = dict(steps)
        waiting = [-p for p in parts]
        heapq.heapify(waiting)
        found: list[int] = []
        while waiting:
            p = -heapq.heappop(waiting)
            part = parts[p]
            size = size_of(part)
            if size <= self.zero:
                continue
            if size < self.clear:
                raise Unclear(Message("a row takes part in a circuit by no more than {size:.1e}", size=size))
            found.append(self._pivots[p][0])
            for earlier, factor in self._steps[p]:
                if earlier not in parts:
                    parts[earlier] = -(part * factor)
                    heapq.heappush(waiting, -earlier)
                else:
                    parts[earlier] = parts[earlier] - part * factor
        return found


def unit_rows(rows: Sequence[Gradient], scale: Callable[[int], Any]) -> list[Row]:
    """Rows in scaled coordinates, brought to a largest entry of about one."""
    made: list[Row] = []
    for row in rows:
        scaled = {k: c * scale(k) for k, c in row.items() if not is_zero(c)}
        size = max((size_of(c) for c in scaled.values()), default=0.0)
        made.append({k: c / size for k, c in scaled.items()} if size > 0.0 else {})
    return made
