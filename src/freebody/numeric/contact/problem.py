"""What a contact problem is, in matrices: rows, their states, and what friction may carry.

    a = A lambda + b          A = J M^-1 J^T (Delassus), positive semidefinite, singular if rows are redundant

Every row has a multiplier lambda and an acceleration a (in impacts: an impulse and a velocity). Rows are held (a = 0),
normals (0 <= lambda _|_ a >= 0) or rubs: friction along a slip rate, which carries at most a coefficient times a load.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum, IntEnum

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


class RowState(IntEnum):
    """What a row does next."""

    HELD = 0
    OPEN = 1
    CLOSED = 2
    STICKING = 3
    FORWARD = 4
    BACKWARD = 5
    ABSENT = 6  # a rub that nothing presses


Mode = tuple[RowState, ...]  # one state a row
Choice = tuple[int, RowState]  # a row and a state

MOST_OTHERS = 300  # modes that are tried to find out whether there is another outcome: those of three contacts
SLIPPING = (RowState.FORWARD, RowState.BACKWARD)


@dataclass(frozen=True, slots=True)
class FrictionProblemRow:
    """Friction T along the slip rate of `row`, where T > 0 pushes towards growing slip.

        load L = constant + sum of normal forces + sum of |(lambda_i, lambda_j, ..)| over the groups `magnitudes`
        slipping forward   T = -kinetic[0] L          sticking  -static[0] L <= T <= static[1] L
        slipping backward  T = +kinetic[1] L

    `sliding` is the sign of the slip rate, 0 at rest. At rest in a plane `across` is the row at right angles to
    `row`: then the resultant of both stays within static L, and slip begins against it (`cones`). A brake has a
    constant load, a dry slider the magnitude of one held row, a pin that of two. `normals` may name a held row (a
    taut string) whose force must not be negative: a mode in which it is counts as inconsistent. What `lifts`, a flat
    end that tips, takes its one normal with it: the gap of that opens by at least static |a|, a the acceleration in the
    plane (`cones`). Raises ValueError unless 0 <= kinetic <= static and constant >= 0.
    """

    row: int
    static: tuple[float, float]
    kinetic: tuple[float, float]
    constant: float = 0.0
    normals: tuple[int, ...] = ()
    magnitudes: tuple[tuple[int, ...], ...] = ()
    sliding: int = 0
    across: int = -1
    lifts: bool = False

    def __post_init__(self) -> None:
        if not (0.0 <= self.kinetic[0] <= self.static[0] and 0.0 <= self.kinetic[1] <= self.static[1]):
            raise ValueError(f"rub of row {self.row}: need 0 <= kinetic <= static, not {self.kinetic}, {self.static}")
        if self.constant < 0.0 or self.sliding not in (-1, 0, 1):
            raise ValueError(f"rub of row {self.row}: need constant >= 0 and sliding -1, 0 or 1")

    def load(self, forces: Sequence[float] | Array) -> float:
        """L at the given multipliers of all rows."""
        pressed = sum(forces[j] for j in self.normals)
        return float(self.constant + pressed + sum(math.hypot(*(forces[j] for j in g)) for g in self.magnitudes))

    @property
    def is_always_loaded(self) -> bool:
        """Whether it may carry force with every normal open."""
        return self.constant > 0.0 or bool(self.magnitudes)


@dataclass(frozen=True, slots=True)
class ContactProblem:
    """Rows at an instant. A: (n, n) [1/kg and the like], b: (n,) accelerations without any force of the rows.

    `normals` are rows, `dry_friction` names its own; every other row is held, with b such that its acceleration must
    vanish.
    """

    A: Array
    b: Array
    normals: tuple[int, ...] = ()
    dry_friction: tuple[FrictionProblemRow, ...] = ()
    lengths: Array | None = None  # (n,) h: of multipliers that are not unique those with the least sum of (lambda h)^2

    @property
    def n(self) -> int:
        return len(self.b)

    @property
    def free_rows(self) -> tuple[int, ...]:
        """Normals, then the rows of rubs."""
        across = (rub.across for rub in self.dry_friction if rub.across >= 0)
        return (*self.normals, *(rub.row for rub in self.dry_friction), *across)

    @property
    def held_rows(self) -> tuple[int, ...]:
        free = set(self.free_rows)
        return tuple(row for row in range(self.n) if row not in free)


class OutcomeCount(Enum):
    """How many outcomes a problem has. Outcomes with equal accelerations and other forces are one."""

    UNIQUE = "one consistent outcome"
    NONE = "no consistent forces exist (Painleve)"
    SEVERAL = "several consistent outcomes"
    NOT_FOUND = "no consistent forces were found"


@dataclass(frozen=True, slots=True)
class ForceOutcome:
    """The forces and accelerations of all rows, (n,) each, in the chosen mode; NaN and all open if there are none.

    `is_proven`: the status follows from a criterion or from trying every mode, not from one search.
    """

    status: OutcomeCount
    mode: Mode
    forces: Array
    accelerations: Array
    alternatives: tuple[Mode, ...] = ()
    is_proven: bool = True
    directions: tuple[tuple[int, float], ...] = ()  # of rubs in a plane, by row: the angle of their slip, from the row

    @property
    def is_found(self) -> bool:
        return self.status in (OutcomeCount.UNIQUE, OutcomeCount.SEVERAL)
