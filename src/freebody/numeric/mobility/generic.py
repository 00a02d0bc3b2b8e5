"""The rank that a mechanism owes to its topology: bodies in random poses, joined by geometry that fits.

The generic model (see `system.generic`) has a symbol for every geometric datum. Poses of bodies and symbols are drawn
at random, then the symbols are changed as little as possible until every row that has a value closes,

    F(poses, symbols + step) = 0,      step = -A^+ F,      A = dF/d symbols,

which for pins is linear; rows that share no symbol are closed apart. What is special then is special in every
geometry: the rank at such a geometry is the largest that any one reaches, but for draws of probability zero. That
a rank is reached is shown to the digits to which the geometry closes (more than 70); that it is the largest is as
sure as the draw, so more seeds can only raise it.
Sources: Laman, J. Engng. Math. 4, 1970, 331-340; Whiteley, Contemp. Math. 197, 1996, 171-311; Jackson & Jordan,
Combinatorica 28, 2008, 645-658 (generic rank by random realisations).
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np

from freebody.errors import CannotAnswer, InputError
from freebody.language.sentences import Message
from freebody.measures.geometry import GROUND
from freebody.model.elements import ConstraintRow
from freebody.model.noting import did_you_mean
from freebody.numeric.jets import TIME, Array
from freebody.numeric.mobility.elimination import CircuitElimination, Unclear, unit_rows
from freebody.numeric.mobility.exact import (
    BALLS,
    BITS,
    FLOATS,
    Arithmetic,
    ExactDual,
    ExactDualGeometry,
    Gradient,
    Place,
    precision,
    size_of,
    spatial_place,
)
from freebody.numeric.mobility.rank import ZERO, Rank
from freebody.numeric.rotation import product_of_parts
from freebody.system.generic import GenericModel, generic_model
from freebody.system.system import System
from freebody.tolerances import LEAST

CLOSED = 1e-10  # gaps up to which a geometry fits before it is refined
_SHUT = 1e-13  # gaps of which a step improves nothing
_RCOND = 1e-11  # of a step: directions in which rows that depend on each other leave only rounding
N_DRAWS = 6
N_STEPS = 40
REACH = 5.0  # bodies are put in a square of twice this side; lengths are about one


def generic_rank(system: System, seed: int = 0) -> Rank:
    """The rank of all held rows in generic geometry, and the circuits that it has in any. Parameters need no values.
    Raises CannotAnswer if no random geometry gives every row a gradient."""
    return Framework.of(system).rank(seed=seed)


@dataclass(frozen=True)
class Framework:
    """The generic model of a system, with numbers for everything that its rows depend on: x, y and theta of bodies,
    then symbols, counted on. In space a body has x, y, z and a quaternion of any length; derivatives by its angular
    velocity along its own axes stand where the last three parts of the quaternion do."""

    model: GenericModel
    columns: Mapping[str, tuple[int, ...]]  # of moving bodies
    others: Mapping[str, tuple[int, ...]]  # of the ground and fixed bodies
    symbols: Mapping[str, int]

    @classmethod
    def of(cls, system: System, values: Mapping[str, float] | None = None) -> Framework:
        """values: of parameters, where those of the model are not meant."""
        model = generic_model(system, values)
        n = 0
        places: dict[str, tuple[int, ...]] = {}
        for body in sorted(model.system.bodies.values(), key=lambda body: body.fixed):
            size = (7 if body.turns else 3) if system.space else (3 if body.turns else 2)
            places[body.name] = tuple(range(n, n + size))
            n += size
        moving = {body.name for body in model.system.all_moving}
        return cls(
            model,
            {name: at for name, at in places.items() if name in moving},
            {name: at for name, at in places.items() if name not in moving},
            {name: n + k for k, name in enumerate(model.data)},
        )

    @property
    def n_coordinates(self) -> int:
        return len(self.coordinates)

    @cached_property
    def coordinates(self) -> tuple[int, ...]:
        """Where the derivatives by the coordinates of moving bodies stand."""
        return tuple(k for at in self.columns.values() for k in at if k not in self._heads)

    @cached_property
    def _heads(self) -> frozenset[int]:
        """The first parts of quaternions, by which there are no derivatives."""
        return frozenset(at[3] for at in (*self.columns.values(), *self.others.values()) if len(at) == 7)

    @cached_property
    def _quaternions(self) -> Mapping[int, int]:
        """Of the other parts of quaternions, where the first one is."""
        return {head + k: head for head in self._heads for k in (1, 2, 3)}

    # -- ranks --------------------------------------------------------------------------------
    def rank(self, rows: Iterable[str] | None = None, seed: int = 0) -> Rank:
        """The rank of all rows, or of these."""
        held, assembled = self.rows_of(rows)
        why, best = "", None
        ways = [(draw, turned) for draw in range(N_DRAWS) for turned in self._attitudes]
        for draw, is_turned in ways:
            numbers = self._drawn(np.random.default_rng((seed, draw)), is_turned=is_turned)
            try:
                gaps = self._fitted(assembled, numbers)
                open_rows = tuple(row for row, gap in zip(assembled, gaps, strict=True) if not gap <= CLOSED)
                closing = [row for row in assembled if row not in open_rows]
                found = self._rank(held, closing, numbers, open_rows, seed)
            except (Unclear, ArithmeticError, ValueError) as error:
                why = str(error)
                continue
            best = best or found
            if found.is_exact or not is_turned or len(self._attitudes) == 1:
                return found if found.is_exact else best
        if best is not None:
            return best
        raise CannotAnswer(Message("no random geometry was found in which all rows have a gradient: {why}", why=why))

    def rows_of(self, names: Iterable[str] | None) -> tuple[Sequence[ConstraintRow], Sequence[ConstraintRow]]:
        """The held rows of these names (None: all), and the rows that close where their connections are assembled."""
        held = self.model.system.constraint_rows
        if names is None:
            return held, self.model.assembled
        wanted, known = set(names), {row.name for row in held}
        for name in sorted(wanted - known):
            raise InputError(Message("{name} is not held.{hint}", name=name, hint=did_you_mean(name, known)))
        chosen = [row for row in held if row.name in wanted]
        joined = {row.connection for row in chosen}
        return chosen, [row for row in self.model.assembled if row.connection in joined]

    def _rank(
        self,
        held: Sequence[ConstraintRow],
        closing: Sequence[ConstraintRow],
        numbers: Array,
        open_rows: Sequence[ConstraintRow],
        seed: int,
    ) -> Rank:
        with precision(BITS):
            balls, error = self._refined(closing, numbers)
            g = self.geometry(balls, self.coordinates, BALLS)
            eliminated = CircuitElimination.of(
                unit_rows([g.of(row.measure).gradient for row in held], lambda _: 1.0), ZERO
            )
        how = Message(
            "elimination in balls of {bits} bits at a random geometry (seed {seed}) that closes to {error:.1e}: what "
            "is below {zero:g} counts as zero, no pivot is smaller than {pivot:.1e}",
            bits=BITS,
            seed=seed,
            error=error,
            zero=ZERO,
            pivot=eliminated.smallest,
        )
        if open_rows:
            names = ", ".join(row.name for row in open_rows)
            how = Message("{how}; no geometry was found that closes {names}", how=how, names=names)
        names = tuple(row.name for row in held)
        circuits = tuple(tuple(names[k] for k in circuit) for circuit in eliminated.circuits)
        gap = eliminated.smallest, eliminated.largest
        return Rank(eliminated.rank, self.n_coordinates, names, circuits, how, not open_rows, gap)

    # -- geometry -----------------------------------------------------------------------------
    def geometry(
        self,
        numbers: Sequence[Any] | Array,
        free: Iterable[int],
        arithmetic: Arithmetic,
        like: ExactDualGeometry | None = None,
        changed: Iterable[int] = (),
    ) -> ExactDualGeometry:
        """What measures see, with derivatives by the numbers that are `free`; where only some numbers have changed
        the others are taken from another geometry."""
        one, by = arithmetic.number(1), frozenset(free)

        def dual(k: int) -> ExactDual:
            return ExactDual(numbers[k], {k: one} if k in by else None)

        def place(body: str) -> Place:
            at = self.columns.get(body) or self.others[body]
            if self.model.system.space:
                quaternion = [numbers[k] for k in at[3:]] or [arithmetic.number(k) for k in (1, 0, 0, 0)]
                return spatial_place([dual(k) for k in at[:3]], quaternion, [k for k in at[4:] if k in by])
            x, y, *turning = at
            return dual(x), dual(y), dual(turning[0]) if turning else None

        if like is None:
            places = {body: place(body) for body in (*self.columns, *self.others)}
            values = {name: dual(k) for name, k in self.symbols.items()}
            return ExactDualGeometry(places, values | {TIME: ExactDual(arithmetic.number(0))}, arithmetic)
        places, values = dict(like.places), dict(like.values)
        for name, is_body in dict.fromkeys(self.names[k] for k in changed):
            if is_body:
                places[name] = place(name)
            else:
                values[name] = dual(self.symbols[name])
        return ExactDualGeometry(places, values, arithmetic)

    @cached_property
    def names(self) -> Mapping[int, tuple[str, bool]]:
        """Which body or symbol a number belongs to, and whether it is a body."""
        bodies = {k: (body, True) for body, at in (*self.columns.items(), *self.others.items()) for k in at}
        return bodies | {k: (name, False) for name, k in self.symbols.items()}

    @property
    def _attitudes(self) -> tuple[bool, ...]:
        """Whether bodies are turned at random. In space, where rows do not close so, they stand parallel: joints close
        then, since an axis has the same components in both of its bodies."""
        return (True, False) if self.model.system.space else (True,)

    def _drawn(self, rng: np.random.Generator, *, is_turned: bool) -> Array:
        """Bodies anywhere, symbols of about one; the ground at zero."""
        numbers = np.zeros(len(self.symbols) + sum(len(at) for at in (*self.columns.values(), *self.others.values())))
        n_places = 3 if self.model.system.space else 2
        for body, at in (*self.columns.items(), *self.others.items()):
            places, turning = list(at[:n_places]), list(at[n_places:])
            if body == GROUND or not is_turned:
                numbers[turning[:1]] = 1.0 if len(turning) == 4 else 0.0
            if body == GROUND:
                continue
            numbers[places] = rng.uniform(-REACH, REACH, n_places)
            if not is_turned:
                continue
            is_angle = len(turning) == 1
            numbers[turning] = rng.uniform(-math.pi, math.pi, 1) if is_angle else rng.standard_normal(len(turning))
        for name, k in self.symbols.items():
            match self.model.data[name].kind:
                case "direction":
                    numbers[k] = rng.standard_normal() if n_places == 3 else rng.uniform(-math.pi, math.pi)
                case "point":
                    numbers[k] = rng.standard_normal()
                case _:
                    numbers[k] = rng.uniform(0.3, 1.0)
        return numbers

    # -- fitting ------------------------------------------------------------------------------
    def _fitted(self, rows: Sequence[ConstraintRow], numbers: Array) -> Array:
        """Changes symbols, and where these cannot do it poses too, until the rows close; the gaps that are left."""
        left = self.close(rows, numbers, self.symbols.values())
        if (left <= CLOSED).all():
            return left
        before = numbers.copy()
        again = self.close(rows, numbers, [*self.symbols.values(), *self.coordinates])
        if np.count_nonzero(again <= CLOSED) >= np.count_nonzero(left <= CLOSED):
            return again
        numbers[:] = before
        return left

    def close(self, rows: Sequence[ConstraintRow], numbers: Array, free: Iterable[int]) -> Array:
        """Changes free numbers in place, as little as possible, until rows close; the gaps that are left."""
        by = frozenset(free)
        gaps, gradients = self._gaps(rows, numbers, by)
        left = np.abs(gaps)
        g = self.geometry(numbers.tolist(), by, FLOATS)
        for part in _parts(gradients):
            if left[part].max() > _SHUT:
                columns = {k for row in part for k in gradients[row]}
                left[part] = self._close_part([rows[k] for k in part], numbers, by, g, columns)
        return left

    def _close_part(
        self,
        rows: Sequence[ConstraintRow],
        numbers: Array,
        by: frozenset[int],
        like: ExactDualGeometry,
        changed: set[int],
    ) -> Array:
        gaps, gradients = self._gaps(rows, numbers, by, like, changed)
        for _ in range(N_STEPS):
            size = float(np.abs(gaps).max(initial=0.0))
            if size <= _SHUT:
                break
            columns, A = dense(gradients)
            if not columns:
                break
            step = np.linalg.pinv(A, rcond=_RCOND) @ gaps
            step *= min(1.0, REACH / max(float(np.abs(step).max(initial=0.0)), LEAST))
            improved = False
            for _halving in range(8):
                there = numbers.copy()
                self._step_back(there, columns, step)
                try:
                    new_gaps, new_gradients = self._gaps(rows, there, by, like, changed)
                except (ArithmeticError, ValueError):
                    step = 0.5 * step
                    continue
                if np.linalg.norm(new_gaps) < np.linalg.norm(gaps):
                    numbers[:], gaps, gradients, improved = there, new_gaps, new_gradients, True
                    break
                step = 0.5 * step
            if not improved:
                break
        return np.abs(gaps)

    def _step_back(self, numbers: Any, columns: Sequence[int], step: Sequence[Any] | Array) -> None:
        """Changes numbers in place by a step backwards."""
        turns: dict[int, list[Any]] = {}
        for k, dx in zip(columns, step, strict=True):
            head = self._quaternions.get(k)
            if head is None:
                numbers[k] = numbers[k] - dx
            else:
                turns.setdefault(head, [1, 0, 0, 0])[k - head] = -dx / 2
        for head, further in turns.items():
            numbers[head : head + 4] = product_of_parts([numbers[head + k] for k in range(4)], further)

    def _gaps(
        self,
        rows: Sequence[ConstraintRow],
        numbers: Array,
        by: frozenset[int],
        like: ExactDualGeometry | None = None,
        changed: Iterable[int] = (),
    ) -> tuple[Array, list[Gradient]]:
        g = self.geometry(numbers.tolist() if like is None else numbers, by, FLOATS, like, changed)
        duals = [g.gap(row) for row in rows]
        return np.array([dual.value for dual in duals], dtype=np.float64), [dual.gradient for dual in duals]

    def _refined(self, rows: Sequence[ConstraintRow], numbers: Array) -> tuple[list[Any], float]:
        """The numbers as balls, changed until the rows close to many digits."""
        balls: list[Any] = [BALLS.number(Fraction(float(x))) for x in numbers]
        by = frozenset(self.symbols.values())
        gaps, gradients = self._gaps(rows, numbers, by)
        if (np.abs(gaps) > 0.0).any() and self._is_stuck(gradients, gaps):
            by |= set(self.coordinates)
            gaps, gradients = self._gaps(rows, numbers, by)
        steps: list[tuple[list[int], list[int], Any]] = []
        for part in _parts(gradients):
            columns, A = dense([gradients[k] for k in part])
            steps.append((part, columns, np.linalg.pinv(A, rcond=_RCOND)))
        error = math.inf
        for _ in range(N_STEPS):
            g = self.geometry(balls, (), BALLS)
            left = [g.gap(row).value for row in rows]
            before, error = error, max(map(size_of, left), default=0.0)
            if error <= 2.0 ** (64 - BITS):
                return balls, error
            if not error < 0.1 * before:
                break
            shift = -math.frexp(error)[1]
            up, down = BALLS.number(Fraction(2) ** shift), BALLS.number(Fraction(2) ** -shift)
            for part, columns, inverse in steps:
                step = inverse @ np.array([float(left[k] * up) for k in part])
                self._step_back(balls, columns, [BALLS.number(float(dx)) * down for dx in step])
                for k in {*columns, *(self._quaternions[k] for k in columns if k in self._quaternions)}:
                    balls[k] = balls[k].mid()
        raise Unclear(Message("the random geometry closes only to {error:.0e}", error=error))

    def _is_stuck(self, gradients: Sequence[Gradient], gaps: Array) -> bool:
        """Whether symbols alone cannot close the rows."""
        for part in _parts(gradients):
            columns, A = dense([gradients[k] for k in part])
            if len(part) > len(columns) or np.linalg.matrix_rank(A) < len(part):
                return True
        return any(not gradient and gap != 0.0 for gradient, gap in zip(gradients, gaps, strict=True))


def _parts(gradients: Sequence[Gradient]) -> list[list[int]]:
    """Rows in groups that share no column; rows without any column are in none."""
    parent = list(range(len(gradients)))

    def root(k: int) -> int:
        while parent[k] != k:
            parent[k] = parent[parent[k]]
            k = parent[k]
        return k

    first: dict[int, int] = {}
    for k, gradient in enumerate(gradients):
        for column in gradient:
            parent[root(k)] = root(first.setdefault(column, k))
    groups: dict[int, list[int]] = {}
    for k, gradient in enumerate(gradients):
        if gradient:
            groups.setdefault(root(k), []).append(k)
    return list(groups.values())


def dense(gradients: Sequence[Gradient]) -> tuple[list[int], Array]:
    """The columns that occur, and the rows over them."""
    columns = sorted({column for gradient in gradients for column in gradient})
    at = {column: k for k, column in enumerate(columns)}
    A = np.zeros((len(gradients), len(columns)))
    for k, gradient in enumerate(gradients):
        for column, c in gradient.items():
            A[k, at[column]] = c
    return columns, A
