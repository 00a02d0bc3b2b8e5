"""Independent subproblems of a contact problem: bodies that lie on the ground side by side.

Two rows are coupled if their entry of A is not zero, and a rub is coupled with all rows in its load. The modes of each
subproblem are searched alone, so that their numbers add up where those of the whole would multiply.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from freebody.numeric.contact.problem import ContactProblem


@dataclass(frozen=True, slots=True)
class Part:
    """A problem of its own, and which rows of the whole its rows are."""

    problem: ContactProblem
    rows: tuple[int, ...]


def separate(problem: ContactProblem) -> list[Part]:
    """The parts, in the order of their first rows; the problem as it is if it has one only."""
    # which rows are coupled, (n, n), and the connected components of that graph
    joined = problem.A != 0.0
    for rub in problem.dry_friction:
        across = () if rub.across < 0 else (rub.across,)
        for row in (*rub.normals, *(row for group in rub.magnitudes for row in group), *across):
            joined[rub.row, row] = True
    groups = _connected(joined | joined.T)
    if len(groups) < 2:
        return [Part(problem, tuple(range(problem.n)))]
    # each component as a problem, its rows counted anew
    parts: list[Part] = []
    for rows in groups:
        place = {row: k for k, row in enumerate(rows)}
        dry_friction = tuple(
            replace(
                rub,
                row=place[rub.row],
                across=place.get(rub.across, -1),
                normals=tuple(place[row] for row in rub.normals),
                magnitudes=tuple(tuple(place[row] for row in group) for group in rub.magnitudes),
            )
            for rub in problem.dry_friction
            if rub.row in place
        )
        own = ContactProblem(
            problem.A[np.ix_(rows, rows)],
            problem.b[list(rows)],
            tuple(place[row] for row in problem.normals if row in place),
            dry_friction,
            None if problem.lengths is None else problem.lengths[list(rows)],
        )
        parts.append(Part(own, rows))
    return parts


def _connected(joined: NDArray[np.bool_]) -> list[tuple[int, ...]]:
    """The rows of every connected part of a symmetric relation."""
    left = np.ones(len(joined), dtype=bool)
    found: list[tuple[int, ...]] = []
    for row in range(len(joined)):
        if not left[row]:
            continue
        part = np.zeros(len(joined), dtype=bool)
        part[row] = True
        before = 0
        while before < (size := int(part.sum())):
            part |= joined[part].any(axis=0)
            before = size
        left &= ~part
        found.append(tuple(int(k) for k in np.flatnonzero(part)))
    return found
