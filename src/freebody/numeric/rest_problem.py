"""A system at rest in numbers: its held rows, its loads, and the friction that acts in it.

Beside a drive rest is that nothing moves against what is driven: J v = target' and J a = target'' - bias of all rows,
slips among them, give how everything goes along, and Q - M a stands for Q (d'Alembert).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.expression import FLOAT_FUNCTIONS, Expr, evaluate
from freebody.language.sentences import Message
from freebody.model.elements import ConstraintRow, DryFriction
from freebody.numeric.instant import forces, gyroscopic
from freebody.numeric.jet_geometry import JetGeometry
from freebody.numeric.jets import TIME, Array
from freebody.numeric.reference import Reference
from freebody.numeric.split import Split, stack
from freebody.tolerances import ROUND_OFF


class FreeBeside(CannotAnswer):
    """Nothing tells how what is not held goes along with a drive."""

    def __init__(self) -> None:
        super().__init__(Message("beside what is driven something is free to move; rest is asked of what is held"))


@dataclass(frozen=True)
class FrictionCone:
    """Dry friction at one row: -(forward L + limit) <= T <= backward L + limit, each with its own `limits`.

    L = sum of sign * multiplier over `load`, or the size of the multipliers in `size`, whose signs are open. In a plane
    T has a second component, in the row `across`, and the size of both is forward L at most."""

    name: str
    row: int
    forward: float
    backward: float
    load: tuple[tuple[int, float], ...] = ()
    size: tuple[int, ...] = ()
    limits: tuple[float, float] = (0.0, 0.0)
    across: int = -1

    def size_of(self, rates: Array) -> float:
        """The size of its components, of what is given by row."""
        return abs(float(rates[self.row])) if self.across < 0 else math.hypot(rates[self.row], rates[self.across])


@dataclass(frozen=True)
class RestProblem:
    """A system at rest in numbers: J (n_rows, n), Q (n,); `normals` are (row, sign) of what cannot pull."""

    names: tuple[str, ...]
    J: Array
    Q: Array
    normals: tuple[tuple[int, int], ...]
    cones: tuple[FrictionCone, ...]
    moves: Array  # (n,) a move by the size of the system, a turn by a radian
    walls: tuple[tuple[tuple[int, float], ...], ...] = ()  # sums of coefficient * multiplier that are not negative

    @property
    def force(self) -> float:
        """The largest load; 1 if there is none."""
        return float(np.abs(self.Q * self.moves).max(initial=0.0)) or 1.0

    def place(self, name: str) -> int:
        return self.names.index(name)


def rest_problem(reference: Reference, q: Array, dry_friction: Sequence[DryFriction]) -> RestProblem:
    """The reference's system at rest at q: its held rows (those that are unilateral cannot pull) and dry friction."""
    held, n = reference.system.constraint_rows, len(q)
    rows = _resisting(reference, dry_friction)
    g = reference.geometry(q, velocities_along(reference, q, dry_friction), 0.0)
    gaps = [reference.gap(row, g) for row in rows]
    J = stack([gap.row(n) for gap in gaps], n)
    names = tuple(row.name for row in rows)
    cones = tuple(
        replace(
            _cone(reference, g, rub, len(held) + k, held),
            across=-1 if rub.across is None else names.index(rub.across.name),
        )
        for k, rub in enumerate(dry_friction)
    )
    normals = tuple((k, row.sign) for k, row in enumerate(held) if row.unilateral)
    a = _led(reference, J, np.array([-gap.bias for gap in gaps]))
    Q = forces(reference, g) + gyroscopic(reference, g) - reference.masses * a
    return RestProblem(names, J, Q, normals, cones, reference.sizes.unit_moves)


def velocities_along(reference: Reference, q: Array, dry_friction: Sequence[DryFriction]) -> Array:
    """(n,) of what is driven and goes along with it at rest beside it."""
    g = reference.geometry(q, np.zeros(len(q)), 0.0)
    gaps = [reference.gap(row, g) for row in _resisting(reference, dry_friction)]
    return _led(reference, stack([gap.row(len(q)) for gap in gaps], len(q)), np.array([-gap.rate for gap in gaps]))


def _resisting(reference: Reference, dry_friction: Sequence[DryFriction]) -> list[ConstraintRow]:
    """The rows that are held, and those of dry friction."""
    across = (rub.across for rub in dry_friction if rub.across is not None)
    return [*reference.system.constraint_rows, *(rub.row for rub in dry_friction), *across]


def _led(reference: Reference, J: Array, driven: Array) -> Array:
    """Velocities or accelerations (n,) with which everything goes along; driven: what the rows have of them."""
    moves = reference.sizes.unit_moves
    if not driven.any():
        return np.zeros(len(moves))
    split = Split(J, moves)
    found = split.least(driven)
    if float(np.abs(J @ found - driven).max()) > ROUND_OFF * float(np.abs(driven).max()):
        raise CannotAnswer(Message("the drive moves what is held, so nothing stays at rest beside it"))
    n = 3 if reference.system.space else 2
    moved = [column for body in reference.system.moving for column in reference.columns(body.name)[:n]]
    if (
        float(np.abs(split.null[moved]).max(initial=0.0)) > ROUND_OFF
    ):  # what only spins about its middle need not go along
        raise FreeBeside
    return found


def _cone(
    reference: Reference, g: JetGeometry, rub: DryFriction, row: int, held: Sequence[ConstraintRow]
) -> FrictionCone:
    values = {**reference.frame.values, TIME: 0.0}
    for name, measure in rub.measures:
        values[name] = reference.jet(g, measure, name).value
        values[f"rate({name})"] = 0.0

    def number(expr: Expr) -> float:
        return float(evaluate(expr, values, FLOAT_FUNCTIONS))

    forward, backward = (number(rub.coefficient(d, at_rest=True)) for d in (1, -1))
    if not rub.load:
        return FrictionCone(rub.name, row, 0.0, 0.0, limits=(forward, backward))
    place = {other.name: k for k, other in enumerate(held)}
    missing = [name for name in rub.load if name not in place]
    if missing:
        raise CannotAnswer(
            Message(
                "the friction of {connection} depends on {names}, which is not held",
                connection=rub.row.connection,
                names=", ".join(missing),
            )
        )
    pressing = [place[name] for name in rub.load]
    if len(pressing) == 1 and held[pressing[0]].unilateral:
        return FrictionCone(rub.name, row, forward, backward, ((pressing[0], float(held[pressing[0]].sign)),))
    return FrictionCone(rub.name, row, forward, backward, size=tuple(pressing))
