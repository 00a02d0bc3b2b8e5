"""The order in which rows are eliminated, and where everything stands in the factor.

Rows that hold the same bodies stay together; of these groups the one with the fewest neighbours goes first (minimum
degree), so that chains, ladders and trees fill in by a constant for each body. Of several with as few, the one that has
waited longest goes first: a chain is eliminated from both its ends in turn, and the two do not wait for each other in
the processor. Source: George & Liu, SIAM Review 31 (1989) 1.
"""

from __future__ import annotations

import heapq
from collections.abc import Hashable, Sequence
from dataclasses import dataclass
from itertools import accumulate

import numpy as np

from freebody.numeric.kernels.arrays import Ints


def elimination_order(bodies: Sequence[frozenset[Hashable]]) -> list[int]:
    """The rows in the order of their elimination; bodies[r] are those that row r moves."""
    groups: dict[frozenset[Hashable], list[int]] = {}
    for row, held in enumerate(bodies):
        groups.setdefault(held, []).append(row)
    members = list(groups.values())
    of_body: dict[Hashable, set[int]] = {}
    for g, held in enumerate(groups):
        for body in held:
            of_body.setdefault(body, set()).add(g)
    neighbours: list[set[int]] = [set().union(*(of_body[b] for b in held)) - {g} for g, held in enumerate(groups)]

    def degree(g: int) -> int:
        return sum(len(members[k]) for k in neighbours[g])

    heap = [(degree(g), g, g) for g in range(len(members))]
    heapq.heapify(heap)
    known = {g: d for d, _turn, g in heap}
    turn = len(members)
    order: list[int] = []
    while heap:
        d, _turn, g = heapq.heappop(heap)
        if known.get(g) != d:
            continue
        del known[g]
        order += members[g]
        around = neighbours[g]
        for k in around:
            neighbours[k] |= around
            neighbours[k] -= {k, g}
        for k in sorted(around):
            known[k] = degree(k)
            heapq.heappush(heap, (known[k], turn, k))
            turn += 1
    return order


@dataclass(frozen=True)
class FactorPattern:
    """Where the entries of a symmetric matrix and of its factor stand: column by column, the diagonal first."""

    column_ptr: Ints
    column_row: Ints
    target: Ints
    place: dict[tuple[int, int], int]  # (row, column), row >= column


def symbolic_factor(n: int, entries: set[tuple[int, int]]) -> FactorPattern:
    """The pattern of the factor of an (n, n) matrix with these entries below the diagonal (row > column)."""
    below: list[set[int]] = [set() for _ in range(n)]
    for row, column in entries:
        below[column].add(row)
    columns: list[list[int]] = []
    for j in range(n):
        column = sorted(below[j])
        columns.append(column)
        if column:
            below[column[0]].update(column[1:])
    ptr = [0, *accumulate(1 + len(column) for column in columns)]
    place: dict[tuple[int, int], int] = {}
    rows: list[int] = []
    for j, column in enumerate(columns):
        for i in (j, *column):
            place[i, j] = len(rows)
            rows.append(i)
    target: list[int] = []
    for column in columns:
        for a, i in enumerate(column):
            target += [place[i, k] for k in column[: a + 1]]
    return FactorPattern(
        np.array(ptr, dtype=np.int32),
        np.array(rows, dtype=np.int32),
        np.array(target, dtype=np.int32),
        place,
    )
