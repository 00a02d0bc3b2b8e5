"""Linear systems over the field, by elimination with numeric guidance.

Whether an element vanishes *on the motion* (not just formally) is asked of sample points, because coordinates
that a closed loop binds are not reduced against each other. Pivots are the simplest elements that are safely
away from zero at the samples.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from freebody.symbolic.field import Field, Ratio

Row = dict[int, Ratio]  # column -> entry; the right-hand side is column -1
RHS = -1


@dataclass(frozen=True)
class Solved:
    """Outcome of an elimination: pivot columns expressed by the free ones, and what was left over."""

    pivots: dict[int, Row]  # column -> {free column: coefficient, RHS: constant}
    free: tuple[int, ...]
    redundant: tuple[int, ...]  # indices of rows that follow from the others
    contradictory: tuple[int, ...]  # indices of rows that read 0 = r with r not zero


def solve(
    field: Field,
    rows: Sequence[Row],
    columns: Sequence[int],
    is_zero: Callable[[Ratio], bool],
    *,
    in_order: bool = False,
) -> Solved:
    """Reduces `sum entry * column = RHS` completely. With `in_order` the columns become pivots in their order,
    so that the last ones stay free; otherwise the simplest entries do."""
    order = {c: k for k, c in enumerate(columns)}
    work: list[tuple[int, Row]] = []
    for k, row in enumerate(rows):
        work.append((k, {c: x for c, x in row.items() if not is_zero(x)}))
    done: list[tuple[int, Row]] = []
    redundant: list[int] = []
    contradictory: list[int] = []
    while work:
        best: tuple[tuple[int, int, int], int, int] | None = None
        for position, (_k, row) in enumerate(work):
            n_entries = len(row)
            for column, entry in row.items():
                if column == RHS:
                    continue
                cost = 0 if not entry.generators() else 1 if entry.is_constant() else 2 + _size(entry)
                place = order[column]
                rank = (place, cost, n_entries) if in_order else (cost, n_entries, place)
                if best is None or rank < best[0]:
                    best = rank, position, column
        if best is None:
            for k, row in work:
                (contradictory if RHS in row else redundant).append(k)
            break
        _k, pivot_row = work.pop(best[1])
        column = best[2]
        pivot = pivot_row[column]
        scaled = {c: field.lowest_terms(x / pivot) for c, x in pivot_row.items() if c != column}
        work = [(k, _eliminate(row, column, scaled, is_zero)) for k, row in work]
        done = [(c, _eliminate(row, column, scaled, is_zero)) for c, row in done]
        done.append((column, scaled))
    solved_columns = {c for c, _row in done}
    free = tuple(c for c in columns if c not in solved_columns)
    pivots: dict[int, Row] = {}
    for column, row in done:
        pivots[column] = {c: field.lowest_terms(x if c == RHS else -x) for c, x in row.items()}
    return Solved(pivots, free, tuple(redundant), tuple(contradictory))


def _size(x: Ratio) -> int:
    return len(x.num) + (0 if x.den is None else len(x.den))


def _eliminate(row: Row, column: int, scaled: Row, is_zero: Callable[[Ratio], bool]) -> Row:
    factor = row.get(column)
    if factor is None:
        return row
    result = {c: x for c, x in row.items() if c != column}
    for c, x in scaled.items():
        value = result[c] - factor * x if c in result else -factor * x
        if is_zero(value):
            result.pop(c, None)
        else:
            result[c] = value
    return result
