"""Linear systems over the field, by elimination with numeric guidance.

Whether an element vanishes *on the motion* (not just formally) is asked of sample points, because coordinates
that a closed loop binds are not reduced against each other. Pivots are the simplest elements that are safely
away from zero at the samples.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.symbolic.field import Field
from freebody.symbolic.ratio import Ratio

Row = dict[int, Ratio]  # column -> entry; the right-hand side is column -1
RHS = -1
MOST_ROWS = 8


@dataclass(frozen=True)
class Solved:
    """Outcome of an elimination: pivot columns expressed by the free ones, and what was left over."""

    pivots: dict[int, Row]  # column -> {free column: coefficient, RHS: constant}
    free: tuple[int, ...]
    redundant: tuple[int, ...]  # indices of rows that follow from the others
    contradictory: tuple[int, ...]  # indices of rows that read 0 = r with r not zero


# what makes an entry a good pivot, the smallest first; None where it is none
Worth = Callable[[int, Ratio, Row], "tuple[int, ...] | None"]


def determinant(A: Sequence[Sequence[Ratio]], most: int = MOST_ROWS) -> Ratio:
    """Laplace expansion; matrices here are small. Raises CannotAnswer for more rows than `most`."""
    if len(A) == 1:
        return A[0][0]
    if len(A) > most:
        raise CannotAnswer(Message("more than {n} degrees of freedom; ask for numbers", n=most))
    total = A[0][0].field.zero
    for k, entry in enumerate(A[0]):
        if not entry.is_zero():
            total = total + (-1) ** k * entry * determinant([[*row[:k], *row[k + 1 :]] for row in A[1:]])
    return total


def solve(
    field: Field,
    rows: Sequence[Row],
    columns: Sequence[int],
    is_zero: Callable[[Ratio], bool],
    *,
    in_order: bool = False,
    is_last: Callable[[Ratio], bool] = lambda _entry: False,
) -> Solved:
    """Reduces `sum entry * column = RHS` completely. With `in_order` the columns become pivots in their order,
    so that the last ones stay free; otherwise the simplest entries do. is_last: whether an entry is a pivot only where
    no other one is left."""
    order = {c: k for k, c in enumerate(columns)}

    def worth(column: int, entry: Ratio, row: Row) -> tuple[int, ...]:
        cost = 0 if not entry.generators() else 1 if entry.is_constant() else 2 + entry.n_terms
        simple = (order[column], cost, len(row)) if in_order else (cost, len(row), order[column])
        return is_last(entry), *simple

    done, left = reduced(field, rows, worth, lambda x: None if is_zero(x) else x)
    solved_columns = {c for c, _row in done}
    free = tuple(c for c in columns if c not in solved_columns)
    pivots: dict[int, Row] = {}
    for column, row in done:
        pivots[column] = {c: field.lowest_terms(x if c == RHS else -x) for c, x in row.items()}
    return Solved(
        pivots,
        free,
        redundant=tuple(k for k, row in left if RHS not in row),
        contradictory=tuple(k for k, row in left if RHS in row),
    )


def reduced(
    field: Field, rows: Sequence[Row], worth: Worth, kept: Callable[[Ratio], Ratio | None]
) -> tuple[list[tuple[int, Row]], list[tuple[int, Row]]]:
    """Rows of pivots by their columns, completely reduced, and the rows without a pivot by their numbers. kept: an
    entry as it is kept, None where it vanishes."""
    work = [(k, {c: y for c, x in row.items() if (y := kept(x)) is not None}) for k, row in enumerate(rows)]
    done: list[tuple[int, Row]] = []
    while True:
        best: tuple[tuple[int, ...], int, int] | None = None
        for position, (_k, row) in enumerate(work):
            for column, entry in row.items():
                rank = None if column == RHS else worth(column, entry, row)
                if rank is not None and (best is None or rank < best[0]):
                    best = rank, position, column
        if best is None:
            return done, work
        _rank, position, column = best
        _k, pivot_row = work.pop(position)
        pivot = pivot_row[column]
        scaled = {c: field.lowest_terms(x / pivot) for c, x in pivot_row.items() if c != column}
        work = [(k, _eliminate(row, column, scaled, kept)) for k, row in work]
        done = [(c, _eliminate(row, column, scaled, kept)) for c, row in done]
        done.append((column, scaled))


def _eliminate(row: Row, column: int, scaled: Row, kept: Callable[[Ratio], Ratio | None]) -> Row:
    factor = row.get(column)
    if factor is None:
        return row
    result = {c: x for c, x in row.items() if c != column}
    for c, x in scaled.items():
        value = kept(result[c] - factor * x if c in result else -factor * x)
        if value is None:
            result.pop(c, None)
        else:
            result[c] = value
    return result
