"""What contact is calculated with: bounds, dry frictions and blows by their rows, a mode, and an instant."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.model.elements import DryFriction as RubElement
from freebody.model.elements import UnilateralConstraint
from freebody.numeric.contact.problem import ContactProblem
from freebody.numeric.engine.evaluator import EngineWatch
from freebody.numeric.kernels import kinematics
from freebody.numeric.kernels.arrays import Floats
from freebody.system.description import SystemDescription

MOST_PLACES = 6000  # at which bodies can touch, each of them followed


@dataclass(frozen=True)
class UnilateralRow:
    """A bound in numbers: gap = sign * row, >= 0."""

    name: str
    words: tuple[str, str]  # of what touches what
    kind: str  # "contact", "string" or "stop"
    place: int  # among the rows that may be held
    row: int
    sign: int
    restitution: float
    within: tuple[tuple[int, float, float], ...]  # rows that must be between two values
    family: str
    obstacle: str
    bound: UnilateralConstraint
    is_ideal: bool = False
    grips: tuple[int, ...] = ()  # places of rows that are held with it
    radius: float = np.nan  # of a gap that is a distance without it
    lost: int = -1  # the row that is not positive where more than a place touches
    spinning: int = -1  # the row of a spin that friction would resist in a way that is not known


@dataclass(frozen=True)
class FrictionRow:
    """Dry friction in numbers: the row of its slip, and the place of the row that keeps it."""

    name: str
    words: tuple[str, str]
    row: int
    keeps: int
    of: int  # the barrier without which there is none, or -1
    loads: tuple[int, ...]  # places of the rows that press
    load_sign: int
    rub: RubElement
    packed: int  # its number in the packing
    across: int = -1  # in a plane: the row of its slip across, and the place of the row that keeps that
    keeps_across: int = -1


@dataclass(frozen=True)
class BlowRow:
    """A blow in mid-motion in numbers: the places of the rows that close in it, the instant by the clock at which it
    happens (infinite: never), or the watch whose zero it is."""

    name: str
    places: tuple[int, ...]
    keeps: tuple[tuple[int, int], ...]  # of these places those that are held where they are then, and their rows
    time: float
    watch: EngineWatch | None


@dataclass(frozen=True)
class ModeOf:
    """Which barriers are closed, and for every drag 0 (sticks), +1, -1 (slides) or None (no force)."""

    closed: frozenset[int]
    drags: tuple[int | None, ...]
    groups: tuple[tuple[int, ...], ...] = ()  # drags that stick along the same slip: one row holds all of a group
    past: frozenset[int] = frozenset()  # the blows that have happened
    ways: tuple[tuple[int, float], ...] = ()  # of drags that slide in a plane: the angle of their slip from its row
    pivots: tuple[tuple[int, tuple[float, float, float]], ...] = ()  # of flat ends that tip, by barrier: their settings

    @property
    def followers(self) -> frozenset[int]:
        """Drags whose slip another one of their group holds."""
        return frozenset(k for group in self.groups for k in group[1:])


@dataclass(frozen=True)
class ContactInstant:
    """A state in dense form. Rows are all that may be held; gradients (n_rows, n), rates and biases (n_rows,)."""

    y: Floats
    t: float
    gradients: Floats
    values: Floats
    rates: Floats
    biases: Floats
    force: Floats  # (n,) of the loads


@dataclass(frozen=True)
class RowProblem:
    """A contact problem, and what its rows are: held ones, closed barriers, drags. weighted: (n_rows, n) J M^-1."""

    matrices: ContactProblem
    closed: tuple[int, ...]
    drags: tuple[int, ...]
    weighted: Floats
    n_held: int
    places: tuple[int, ...] = ()  # of its rows, among those that may be held
    across: dict[int, int] = field(default_factory=dict[int, int])  # by drag at rest in a plane: its second row
    ways: dict[int, float] = field(default_factory=dict[int, float])  # by drag sliding in one: the angle of its row

    def row_of_barrier(self, k: int) -> int:
        return self.n_held + self.closed.index(k)

    def row_of_drag(self, k: int) -> int:
        return self.n_held + len(self.closed) + self.drags.index(k)

    @property
    def rows_of_friction(self) -> list[int]:
        return [*map(self.row_of_drag, self.drags), *self.across.values()]

    def with_rates(self, b: Floats) -> RowProblem:
        return replace(self, matrices=replace(self.matrices, b=b))


def within(barrier: UnilateralRow, rows: Floats, slack: float = 0.0) -> bool:
    """Whether a barrier exists, by the rows of an engine at the instant that it looked at last."""
    return all(low - slack <= rows[row, kinematics.VALUE] <= high + slack for row, low, high in barrier.within)


def insist_on_few_places(system: SystemDescription) -> None:
    """Raises CannotAnswer where bodies can touch at more places than are followed one by one."""
    n_sites = sum(len(p.first.rounds) * (len(p.second.straights) + 1) for p in system.contacts)
    if n_sites > MOST_PLACES:
        way_out = (
            Message("Take fewer bodies") if system.space else Message("Use time stepping: method moreau, with a step")
        )
        raise CannotAnswer(
            Message(
                "{n} pairs can touch at more than {most} places; events of so many are not "
                "followed one by one. {way_out}",
                n=len(system.contacts),
                most=MOST_PLACES,
                way_out=way_out,
            )
        )
