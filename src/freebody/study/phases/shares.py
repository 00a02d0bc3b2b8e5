"""Shares of impulses that a collision does not determine: of all solutions x = x0 + N z that with the least answers.

The answers are linear in the impulses, y = G x. First |y|^2 is made least, then |x|^2 among what is left:

    (G N)^T G N z = -(G N)^T G x0,

which has a solution whatever the rank. Of two equal faces each corner then takes the same, and nothing that touched
before answers where nothing has to. Source: Golub & Van Loan, Matrix Computations, sec. 5.5 (least squares, rank
deficient).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from freebody.symbolic.field import Field
from freebody.symbolic.linear import RHS, Row, Solved, solve
from freebody.symbolic.ratio import Ratio


def least_shares(
    field: Field, solved: Solved, columns: Sequence[int], answers: Sequence[Mapping[int, Ratio]]
) -> dict[int, Ratio]:
    """Values of the columns. solved: what determines them but for its free columns; answers: by column what each of
    them adds to an answer."""
    forms: dict[int, Row] = {c: solved.pivots.get(c, {c: field.one}) for c in columns}  # over what is free, and RHS
    free = list(solved.free)
    for of_answers in (True, False):
        wanted = [_put_in(field, answer, forms) for answer in answers] if of_answers else list(forms.values())
        least = _least(field, wanted, free)
        forms = {
            c: _put_in(field, {k: x for k, x in form.items() if k != RHS}, least, form) for c, form in forms.items()
        }
        free = [c for c in free if c in least[c]]
    return {c: field.lowest_terms(form.get(RHS, field.zero)) for c, form in forms.items()}


def _put_in(field: Field, slopes: Mapping[int, Ratio], forms: Mapping[int, Row], known: Row | None = None) -> Row:
    """sum of slope * form, and what is known."""
    total: Row = {} if known is None or RHS not in known else {RHS: known[RHS]}
    for column, slope in slopes.items():
        for c, x in forms[column].items():
            total[c] = total[c] + slope * x if c in total else slope * x
    return {c: y for c, x in total.items() if not (y := field.lowest_terms(x)).is_zero()}


def _least(field: Field, wanted: Sequence[Row], free: Sequence[int]) -> dict[int, Row]:
    """What is free, over what stays free where the sum of the squares of forms is least."""
    rows: list[Row] = []
    for one in free:
        row: Row = {}
        for form in wanted:
            if (slope := form.get(one)) is not None:
                for c, x in form.items():
                    x = -x if c == RHS else x
                    row[c] = row[c] + slope * x if c in row else slope * x
        rows.append({c: y for c, x in row.items() if not (y := field.lowest_terms(x)).is_zero()})
    solved = solve(field, rows, free, lambda x: x.is_zero())
    return {c: solved.pivots.get(c, {c: field.one}) for c in free}
