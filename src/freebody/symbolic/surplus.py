"""More equations than unknowns: what they determine, and what must vanish for them to have a solution."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass

from freebody.symbolic.field import Field
from freebody.symbolic.linear import RHS, Row, determinant, reduced
from freebody.symbolic.ratio import Ratio

MOST_LEFT = 4  # unknowns in a determinant
MOST_DETERMINANTS = 8


@dataclass(frozen=True)
class ReducedColumns:
    """An elimination: pivot columns by the free ones, and what must vanish besides."""

    pivots: dict[int, Row]
    free: tuple[int, ...]
    residuals: tuple[Ratio, ...]


def eliminate(field: Field, rows: Sequence[Row], columns: Sequence[int]) -> ReducedColumns:
    """Reduces sum of entry * column = RHS completely, the simplest entries as pivots; what is left of rows without
    columns are the residuals."""
    done, left = _reduced(field, rows, columns, None)
    solved = {c for c, _row in done}
    pivots = {column: {c: x if c == RHS else -x for c, x in row.items()} for column, row in done}
    return ReducedColumns(
        pivots, tuple(c for c in columns if c not in solved), tuple(row[RHS] for row in left if RHS in row)
    )


def combined(field: Field, reduced: ReducedColumns, total: Row) -> Ratio | None:
    """A sum of unknowns with factors; None where it is not unique."""
    parts: Row = {}
    for column, share in total.items():
        for k, x in reduced.pivots.get(column, {column: field.one}).items():
            parts[k] = parts.get(k, field.zero) + share * x
    left = {k: y for k, x in parts.items() if not (y := field.lowest_terms(x)).is_zero()}
    return None if left.keys() - {RHS} else left.get(RHS, field.zero)


def overdetermined(field: Field, rows: Sequence[Row], columns: Sequence[int], parameter: int) -> list[Ratio]:
    """What must vanish for equations to have a solution, as functions of a parameter.

    Only entries without it are pivots, since others may vanish where a solution exists. What is left, n equations in
    k < n unknowns, has one if the determinants of any k + 1 of them, right-hand side included, vanish."""
    _done, left = _reduced(field, rows, columns, parameter)
    left = [row for row in left if row]
    unknown = sorted({c for row in left for c in row if c != RHS})
    if len(unknown) > MOST_LEFT or len(left) <= len(unknown):
        return []
    chosen = itertools.islice(itertools.combinations(left, len(unknown) + 1), MOST_DETERMINANTS)
    full = [*unknown, RHS]
    found = [determinant([[row.get(c, field.zero) for c in full] for row in some]) for some in chosen]
    return [x for x in found if not x.is_zero()]


def _reduced(
    field: Field, rows: Sequence[Row], columns: Sequence[int], without: int | None
) -> tuple[list[tuple[int, Row]], list[Row]]:
    """Pivot rows, completely reduced, and the rows that are left; no pivot contains the generator `without`."""
    order = {c: k for k, c in enumerate(columns)}

    def worth(column: int, entry: Ratio, row: Row) -> tuple[int, ...] | None:
        if without is not None and without in field.ingredients(entry):
            return None
        return (1 + entry.n_terms if entry.generators() else 0, len(row), order[column])

    def kept(x: Ratio) -> Ratio | None:
        least = field.lowest_terms(x)
        return None if least.is_zero() else least

    done, left = reduced(field, rows, worth, kept)
    return done, [row for _k, row in left]
