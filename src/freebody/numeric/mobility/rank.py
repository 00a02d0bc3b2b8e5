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
from fractions import Fraction
from typing import Any

import numpy as np

from freebody.errors import FreebodyError, InputError
from freebody.language.expression import Expr
from freebody.model.elements import Held, RateMeasure, RigidBody
from freebody.model.names import did_you_mean
from freebody.numeric.jets import TIME, Array
from freebody.numeric.mobility.elimination import Elimination, Unclear, unit_rows
from freebody.numeric.mobility.exact import (
    BALLS,
    BITS,
    Dual,
    DualGeometry,
    Place,
    decimal,
    parameter_ball,
    precision,
    size_of,
)
from freebody.numeric.mobility.sparse_rows import LARGE, SparseRows
from freebody.numeric.reference import Reference
from freebody.numeric.split import RANK_CUT, stack

ROUNDED_CUT = 1e-7  # below this part of the largest they do at poses that are only as good as they were assembled
_MARGIN = 10.0  # of a smallest singular value found by iteration
CLEAR_CUT = 1e-6  # rows whose smallest singular value is above this part of the largest are independent
ZERO = 1e-45  # rests of the elimination below this count as zero
N_STEPS = 40


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


def rank_at(reference: Reference, q: Array, t: float = 0.0, without: Iterable[str] = ()) -> Rank:
    """The rank of the held rows at a pose, and their circuits.

    q: as from `Reference.assemble`, at the time t [s]. without: names of rows ("A.x") or connections ("A") that are
    left out. Raises InputError for a name that is neither, CannotAnswer where a row has no finite gradient."""
    rows = rows_without(reference, without)
    names = tuple(row.name for row in rows)
    J = scaled_rows(reference, q, rows, t)
    n = len(q)
    if not rows or not n:
        circuits = tuple((name,) for name in names)
        return Rank(
            0, n, names, circuits, "there is nothing to hold or nothing that is held", True, (1.0, 0.0), _pose(q)
        )
    clear = _independent(J)
    if clear is not None:
        how = f"singular values: the smallest is {clear:.1e} of the largest, rows are independent above {CLEAR_CUT:g}"
        return Rank(len(rows), n, names, (), how, True, (clear, 0.0), _pose(q))
    singular: Any = np.linalg.svd(J, compute_uv=False)
    relative = singular / (float(singular.max()) or 1.0)
    rank = int(np.count_nonzero(relative > RANK_CUT))
    gap = float(relative[:rank].min(initial=1.0)), float(relative[rank:].max(initial=0.0))
    eliminated, how, pose = _in_balls(reference, q, t, rows)
    is_exact = eliminated is not None
    if eliminated is None:
        eliminated, rounded = _in_floats(J, rank)
        how = f"{rounded}; not confirmed in more digits, because {how}"
    circuits = tuple(tuple(names[k] for k in circuit) for circuit in eliminated.circuits)
    return Rank(eliminated.rank, n, names, circuits, how, is_exact, gap, pose)


def _pose(q: Iterable[Any]) -> tuple[float, ...]:
    return tuple(float(x) for x in q)


def rows_without(reference: Reference, without: Iterable[str]) -> list[Held]:
    """The held rows but those of these names, or of connections of these names."""
    held = reference.system.held
    known = {row.name for row in held} | {row.connection for row in held}
    for name in (left_out := frozenset(without)):
        if name not in known:
            raise InputError(f"there is no row or connection {name} to leave out.{did_you_mean(name, known)}")
    return [row for row in held if row.name not in left_out and row.connection not in left_out]


def scaled_rows(reference: Reference, q: Array, rows: Sequence[Held], t: float = 0.0) -> Array:
    """(n_rows, n_coordinates): gradients in coordinates by the size of the system, brought to unit length."""
    return unit_length(gradients(reference, q, rows, t) * reference.sizes.unit_moves)


def gradients(reference: Reference, q: Array, rows: Sequence[Held], t: float = 0.0) -> Array:
    """(n_rows, n_coordinates). Raises CannotAnswer where one is not finite."""
    g = reference.geometry(q, np.zeros_like(q), t)
    return stack([reference.gap(row, g).row(len(q)) for row in rows], len(q))


def unit_length(J: Array) -> Array:
    """Rows brought to unit length, but for those that are zero."""
    return J / _lengths(J)[:, None]


def _lengths(J: Array) -> Array:
    """Of the rows; of one that is zero, that of the longest."""
    sizes: Array = np.linalg.norm(J, axis=1)
    largest = float(sizes.max(initial=0.0)) or 1.0
    return np.where(sizes > 1e-12 * largest, sizes, largest)


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
            smallest = SparseRows(J).smallest()
        except ValueError:
            return None
        return smallest if smallest > _MARGIN * CLEAR_CUT else None
    squares: Any = np.linalg.eigvalsh(J @ J.T)
    part = float(squares[0] / squares[-1]) if squares[-1] > 0.0 else 0.0
    return math.sqrt(part) if part > CLEAR_CUT**2 else None


def _in_floats(J: Array, rank: int) -> tuple[Elimination, str]:
    """Circuits by rounded elimination, with a threshold at which it agrees with the singular values."""
    rows = unit_rows([{int(k): float(row[k]) for k in np.flatnonzero(row)} for row in J], lambda _: 1.0)
    tried = [Elimination.of(rows, zero, zero) for zero in (1e-9, 1e-8, 1e-10, 1e-7, 1e-11, 1e-6)]
    found = next((one for one in tried if one.rank == rank), tried[0])
    return found, f"numbers of 16 digits, what is below {found.zero:g} after elimination counts as zero"


# In balls ---------------------------------------------------------------------------------------
def _in_balls(
    reference: Reference, q: Array, t: float, rows: Sequence[Held]
) -> tuple[Elimination | None, str, tuple[float, ...]]:
    """The rows eliminated at a pose known to many digits, how that was found, and the pose; None, and why not."""
    why = ""
    for bits in (BITS, 2 * BITS):
        with precision(bits):
            try:
                model = _Balls(reference, rows, t)
                coordinates, pose = _refined(model, q, 2.0 ** (64 - bits))
                eliminated = Elimination.of(unit_rows(model.gradients(coordinates), model.scale), ZERO)
            except (Unclear, FreebodyError, ArithmeticError, ValueError) as error:
                why = str(error)
                continue
        how = (
            f"elimination in balls of {bits} bits, {pose}: what is below {ZERO:g} counts as zero, "
            f"no pivot is smaller than {eliminated.smallest:.1e}"
        )
        return eliminated, how, _pose(coordinates)
    return None, why, _pose(q)


class _Balls:
    """Some rows of a system in balls, at poses of which every coordinate is a ball."""

    def __init__(self, reference: Reference, rows: Sequence[Held], t: float) -> None:
        self.reference, self.rows, self.t = reference, rows, t
        parameters, numbers = reference.system.parameters, reference.frame.values
        self.values = {name: Dual(parameter_ball(parameters.get(name), x)) for name, x in numbers.items()}
        self.values[TIME] = Dual(BALLS.number(decimal(t)))
        self._plain = DualGeometry({}, self.values, BALLS)
        self.fixed = {body: self._fixed(reference.system.bodies[body]) for body in reference.frame.fixed}
        self._origins: dict[int, Any] = {}

    def number(self, expr: Expr) -> Any:
        return self._plain.scalar(expr).value

    def scale(self, column: int) -> float:
        return float(self.reference.sizes.unit_moves[column])

    def _fixed(self, body: RigidBody) -> Place:
        """Where a fixed body is, from what the model says."""
        start = body.start.with_guess()
        theta = BALLS.number(0) if start.angle is None else self.number(start.angle)
        x, y = self._mass_center(body, theta) if start.at is not None else (BALLS.number(0), BALLS.number(0))
        return Dual(x), Dual(y), Dual(theta)

    def _mass_center(self, body: RigidBody, theta: Any) -> tuple[Any, Any]:
        start = body.start.with_guess()
        if start.at is None:
            raise ValueError(f"{body.name} has no place")
        point, place = start.at
        (px, py), (x, y) = ([self.number(c) for c in pair] for pair in (body.points[point], place))
        c, s = (BALLS.functions[name](theta) for name in ("cos", "sin"))
        return x - (c * px - s * py), y - (s * px + c * py)

    def geometry(self, coordinates: Sequence[Any], *, with_gradient: bool) -> DualGeometry:
        one = BALLS.number(1)
        places: dict[str, Place] = dict(self.fixed)
        for body, columns in self.reference.frame.columns.items():
            x, y, *theta = (Dual(coordinates[k], {k: one} if with_gradient else None) for k in columns)
            places[body] = x, y, theta[0] if theta else None
        return DualGeometry(places, self.values, BALLS)

    def gradients(self, coordinates: Sequence[Any]) -> list[dict[int, Any]]:
        g = self.geometry(coordinates, with_gradient=True)
        return [g.of(row.measure).gradient for row in self.rows]

    def count_from(self, coordinates: Sequence[Any]) -> None:
        """Measures of which only changes mean something keep the value that they have here."""
        g = self.geometry(coordinates, with_gradient=False)
        self._origins = {
            k: g.of(row.measure).value
            for k, row in enumerate(self.rows)
            if not isinstance(row.measure, RateMeasure) and row.measure.incremental and row.target is None
        }

    def gaps(self, coordinates: Sequence[Any]) -> list[Any]:
        """How far every row is from its target; zero for one that is only a rate."""
        g = self.geometry(coordinates, with_gradient=False)
        return [
            BALLS.number(0) if isinstance(row.measure, RateMeasure) else g.gap(row, self._origins.get(k, 0)).value
            for k, row in enumerate(self.rows)
        ]

    def meant(self, q: Array, within: float) -> tuple[list[Any], list[int]]:
        """Coordinates as they may be meant: as the model states them, or short decimals and simple parts of pi that
        are as near as `within` (by the size of the system); and which have no such value."""
        found: list[Any] = [None] * len(q)
        length = self.reference.sizes.length
        for body in self.reference.system.moving:
            x, y, *turning = self.reference.columns(body.name)
            theta = BALLS.number(0)
            for k in turning:
                stated = None if body.start.angle is None else self.number(body.start.angle)
                found[k] = _nearest(q[k], [stated, *_angles(float(q[k]))], within)
                theta = BALLS.number(Fraction(float(q[k]))) if found[k] is None else found[k]
            stated_xy = self._mass_center(body, theta) if body.start.at is not None else (None, None)
            for k, stated in zip((x, y), stated_xy, strict=True):
                found[k] = _nearest(q[k], [stated, *_decimals(float(q[k]))], within * length)
        unknown = [k for k, x in enumerate(found) if x is None]
        return [BALLS.number(Fraction(float(q[k]))) if x is None else x for k, x in enumerate(found)], unknown


def _decimals(x: float) -> list[Any]:
    return [BALLS.number(f) for f in (Fraction(x).limit_denominator(1000), decimal(round(x, 9)))]


def _angles(x: float) -> list[Any]:
    turns = Fraction(x / math.pi).limit_denominator(720)
    return [BALLS.pi() * BALLS.number(turns), *_decimals(x)]


def _nearest(x: float, candidates: Sequence[Any], within: float) -> Any:
    """The first candidate that is near enough."""
    return next((c for c in candidates if c is not None and abs(float(c) - x) <= within), None)


def _refined(model: _Balls, q: Array, tolerance: float) -> tuple[list[Any], str]:
    """A pose near q that closes all rows to the tolerance, and what it is. Raises Unclear if none is found."""
    for within in (1e-12, 2e-6):
        coordinates, _unknown = model.meant(q, within)
        model.count_from(coordinates)
        if max(map(size_of, model.gaps(coordinates)), default=0.0) <= tolerance:
            return coordinates, "at the pose in the exact numbers of the model"
    # what is known exactly stays if it can: a slide that is level is to stay level to all digits
    _coordinates, unknown = model.meant(q, 1e-12)
    # redundant rows that only keep their start values may contradict each other by the rounding of q: then they
    # count from a pose in which the others hold
    closing = [row for row in model.rows if not (isinstance(row.measure, RateMeasure) or row.measure.incremental)]
    fewer = _Balls(model.reference, closing, model.t)
    error: Unclear | None = None
    for free in (unknown, list(range(len(q)))):
        for some in (model, fewer) if len(closing) < len(model.rows) else (model,):
            try:
                coordinates, how = _by_newton(some, q, free, tolerance)
            except Unclear as fault:
                error = error or fault
                continue
            if some is fewer:
                model.count_from(coordinates)
            return coordinates, how
    raise error or Unclear("no row closes")


def _by_newton(model: _Balls, q: Array, free: Sequence[int], tolerance: float) -> tuple[list[Any], str]:
    """Steps of one pseudo-inverse from what q is meant to be, in the free coordinates, until the rows close."""
    coordinates, _unknown = model.meant(q, 1e-12)
    model.count_from(coordinates)
    D = model.reference.sizes.unit_moves
    J = gradients(model.reference, q, model.rows, model.t) * D
    weights = 1.0 / _lengths(J)
    U, singular, Vt = np.linalg.svd(weights[:, None] * J[:, free], full_matrices=False)
    rank = int(np.count_nonzero(singular > RANK_CUT * singular.max(initial=0.0)))
    error = math.inf
    for _ in range(N_STEPS):
        gaps = model.gaps(coordinates)
        before, error = error, max((size_of(gap) * w for gap, w in zip(gaps, weights, strict=True)), default=0.0)
        if error <= tolerance:
            return coordinates, f"at the pose refined to {error:.1e}"
        if not error < 0.1 * before:
            raise Unclear(f"the pose closes only to {before:.1g} with the numbers given")
        # the step in floats, of gaps brought to about one
        shift = -math.frexp(error)[1]
        scaled = weights * np.array([float(_times_two(gap, shift)) for gap in gaps])
        step = D[free] * (Vt[:rank].T @ ((U[:, :rank].T @ scaled) / singular[:rank]))
        for k, dx in zip(free, step, strict=True):
            coordinates[k] = (coordinates[k] - _times_two(BALLS.number(float(dx)), -shift)).mid()
    raise Unclear(f"the pose closes only to {error:.1g} after {N_STEPS} steps")


def _times_two(x: Any, n: int) -> Any:
    """x 2^n"""
    return x * (BALLS.number(1) * 2**n if n >= 0 else BALLS.number(Fraction(1, 2**-n)))
