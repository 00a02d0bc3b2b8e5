"""How many rows of the constraint Jacobian are independent at a pose, and which say again what others say.

The rows J(q), in coordinates measured by the size of the system (a length by the typical one, an angle in radians)
and brought to unit length, have the rank r, the number of singular values that are not zero. Then

    freedoms at the pose = n_coordinates - r,        redundant rows = n_rows - r,

which is the count of Gruebler and Kutzbach where no row is redundant. A singular value far above rounding proves that
rows are independent. That they are dependent rounding can never prove; there the pose is refined to more digits and
the rows are eliminated in balls (see `elimination`).
Sources: Gogu, Mech. Mach. Theory 40, 2005, 1068-1097 (mobility); Golub & Van Loan, Matrix Computations, 4th ed. 2013,
sec. 5.5; Oxley, Matroid Theory, 2nd ed. 2011, sec. 1.2.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from freebody.errors import FreebodyError, InputError
from freebody.language.sentences import Message
from freebody.model.elements import ConstraintRow
from freebody.model.noting import did_you_mean
from freebody.numeric.jets import Array
from freebody.numeric.mobility.balls import BallRows, refined, row_lengths
from freebody.numeric.mobility.elimination import CircuitElimination, Unclear, unit_rows
from freebody.numeric.mobility.exact import BITS, precision
from freebody.numeric.mobility.sparse_rows import LARGE, FactoredRows
from freebody.numeric.split import RANK_CUT, stack
from freebody.numeric.system import NumericSystem

ROUNDED_CUT = 1e-7  # below this part of the largest they do at poses that are only as good as they were assembled
_MARGIN = 10.0  # of a smallest singular value found by iteration
CLEAR_CUT = 1e-6  # rows whose smallest singular value is above this part of the largest are independent
ZERO = 1e-45  # rests of the elimination below this count as zero


@dataclass(frozen=True)
class Rank:
    """What rows determine: how many of them are independent, and the circuits of the others.

    circuits: one for every redundant row, in the order of the model; the rows of a circuit depend on each other and
    any of them can be left out for the others to be independent. The last one is the redundant row.
    gap: the smallest singular value that counts and the largest that does not, as parts of the largest; in generic
    geometry the smallest pivot and the largest rest that counts as zero, of rows with entries of about one.
    is_exact: rows were proved independent, by a clear singular value or in balls, and dependent ones were found so to
    many digits; `how` says by what.
    pose: the coordinates that it was found for, refined where that was needed; none for generic geometry."""

    rank: int
    n_coordinates: int
    rows: tuple[str, ...]
    circuits: tuple[tuple[str, ...], ...]
    how: str
    is_exact: bool
    gap: tuple[float, float]
    pose: tuple[float, ...] = field(default=(), compare=False, repr=False)

    @property
    def n_freedoms(self) -> int:
        """Independent velocities that the rows leave."""
        return self.n_coordinates - self.rank

    @property
    def redundant(self) -> tuple[str, ...]:
        """The last row of every circuit."""
        return tuple(circuit[-1] for circuit in self.circuits)

    @property
    def reactions(self) -> tuple[str, ...]:
        """Rows whose multipliers are not unique: those of all circuits, in the order of the model."""
        shared = {row for circuit in self.circuits for row in circuit}
        return tuple(row for row in self.rows if row in shared)


def rank_at(reference: NumericSystem, q: Array, t: float = 0.0, without: Iterable[str] = ()) -> Rank:
    """The rank of the held rows at a pose, and their circuits.

    q: as from `Reference.assemble`, at the time t [s]. without: names of rows ("A.x") or connections ("A") that are
    left out. Raises InputError for a name that is neither, CannotAnswer where a row has no finite gradient."""
    rows = rows_without(reference, without)
    names = tuple(row.name for row in rows)
    J = scaled_rows(reference, q, rows, t)
    n = len(q)
    if not rows or not n:
        circuits = tuple((name,) for name in names)
        how = Message("there is nothing to hold or nothing that is held")
        return Rank(0, n, names, circuits, how, True, (1.0, 0.0), _pose(q))
    clear = _independent(J)
    if clear is not None:
        how = Message(
            "singular values: the smallest is {clear:.1e} of the largest, rows are independent above {cut:g}",
            clear=clear,
            cut=CLEAR_CUT,
        )
        return Rank(len(rows), n, names, (), how, True, (clear, 0.0), _pose(q))
    singular: Any = np.linalg.svd(J, compute_uv=False)
    relative = singular / (float(singular.max()) or 1.0)
    rank = int(np.count_nonzero(relative > RANK_CUT))
    gap = float(relative[:rank].min(initial=1.0)), float(relative[rank:].max(initial=0.0))
    eliminated, how, pose = _in_balls(reference, q, t, rows)
    is_exact = eliminated is not None
    if eliminated is None:
        eliminated, rounded = _in_floats(J, rank)
        how = Message("{rounded}; not confirmed in more digits, because {why}", rounded=rounded, why=how)
    circuits = tuple(tuple(names[k] for k in circuit) for circuit in eliminated.circuits)
    return Rank(eliminated.rank, n, names, circuits, how, is_exact, gap, pose)


def _pose(q: Iterable[Any]) -> tuple[float, ...]:
    return tuple(float(x) for x in q)


def rows_without(reference: NumericSystem, without: Iterable[str]) -> list[ConstraintRow]:
    """The held rows but those of these names, or of connections of these names."""
    held = reference.system.constraint_rows
    known = {row.name for row in held} | {row.connection for row in held}
    for name in (left_out := tuple(dict.fromkeys(without))):
        if name not in known:
            raise InputError(
                Message(
                    "there is no row or connection {name} to leave out.{hint}",
                    name=name,
                    hint=did_you_mean(name, known),
                )
            )
    return [row for row in held if row.name not in left_out and row.connection not in left_out]


def scaled_rows(reference: NumericSystem, q: Array, rows: Sequence[ConstraintRow], t: float = 0.0) -> Array:
    """(n_rows, n_coordinates): gradients in coordinates by the size of the system, brought to unit length."""
    return unit_length(gradients(reference, q, rows, t) * reference.sizes.unit_moves)


def gradients(reference: NumericSystem, q: Array, rows: Sequence[ConstraintRow], t: float = 0.0) -> Array:
    """(n_rows, n_coordinates). Raises CannotAnswer where one is not finite."""
    g = reference.geometry(q, np.zeros_like(q), t)
    return stack([reference.gap(row, g).row(len(q)) for row in rows], len(q))


def unit_length(J: Array) -> Array:
    """Rows brought to unit length, but for those that are zero."""
    return J / row_lengths(J)[:, None]


def n_independent(J: Array) -> int:
    """The rank of rows of unit length, by singular values alone, at a pose that is rounded."""
    singular: Any = np.linalg.svd(J, compute_uv=False)
    return int(np.count_nonzero(singular > ROUNDED_CUT * singular.max(initial=0.0)))


def _independent(J: Array) -> float | None:
    """The smallest singular value as a part of the largest, if it proves that rows are independent.

    Eigenvalues of J J^T are squares of singular values; rounding hides those below about 1e-13 of the largest. Of many
    rows the smallest is found by iteration, which comes down to it from above: hence the margin."""
    if len(J) > J.shape[1]:
        return None
    if len(J) > LARGE:
        try:
            smallest = FactoredRows(J).smallest()
        except ValueError:
            return None
        return smallest if smallest > _MARGIN * CLEAR_CUT else None
    squares: Any = np.linalg.eigvalsh(J @ J.T)
    part = float(squares[0] / squares[-1]) if squares[-1] > 0.0 else 0.0
    return math.sqrt(part) if part > CLEAR_CUT**2 else None


def _in_floats(J: Array, rank: int) -> tuple[CircuitElimination, str]:
    """Circuits by rounded elimination, with a threshold at which it agrees with the singular values."""
    rows = unit_rows([{int(k): float(row[k]) for k in np.flatnonzero(row)} for row in J], lambda _: 1.0)
    tried = [CircuitElimination.of(rows, zero, zero) for zero in (1e-9, 1e-8, 1e-10, 1e-7, 1e-11, 1e-6)]
    found = next((one for one in tried if one.rank == rank), tried[0])
    how = Message("numbers of 16 digits, what is below {zero:g} after elimination counts as zero", zero=found.zero)
    return found, how


# In balls ---------------------------------------------------------------------------------------
def _in_balls(
    reference: NumericSystem, q: Array, t: float, rows: Sequence[ConstraintRow]
) -> tuple[CircuitElimination | None, str, tuple[float, ...]]:
    """The rows eliminated at a pose known to many digits, how that was found, and the pose; None, and why not.

    Where only some rows are asked for, the pose is one in which the others hold too, if there is such a one."""
    why = ""
    everything = reference.system.constraint_rows
    ways = [(bits, closing) for bits in (BITS, 2 * BITS) for closing in (everything, rows)]
    for bits, closing in ways if len(rows) < len(everything) else ways[::2]:
        with precision(bits):
            try:
                model = BallRows(reference, rows, t, gradients(reference, q, rows, t))
                all_ = (
                    model if closing is rows else BallRows(reference, closing, t, gradients(reference, q, closing, t))
                )
                here, pose = refined(all_, q, 2.0 ** (64 - bits))
                eliminated = CircuitElimination.of(unit_rows(model.gradients(here), model.scale), ZERO)
            except (Unclear, FreebodyError, ArithmeticError, ValueError) as error:
                why = str(error)
                continue
        how = Message(
            "elimination in balls of {bits} bits, {pose}: what is below {zero:g} counts as zero, no pivot is smaller "
            "than {pivot:.1e}",
            bits=bits,
            pose=pose,
            zero=ZERO,
            pivot=eliminated.smallest,
        )
        return eliminated, how, _pose(model.coordinates(here))
    return None, why, _pose(q)
