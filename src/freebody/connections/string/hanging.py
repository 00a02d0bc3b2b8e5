"""Where bodies hang on their strings.

Followed from its start the string runs round circle i counter-clockwise (s_i = +1) or clockwise (-1), and a lead
touches it at C_i - s_i R_i n, n the direction of the lead turned by a quarter turn (see `measures.lead`). Both ends
of a lead of constant direction are on one line, so

    n . (C_2 - C_1) = s_2 R_2 - s_1 R_1.

That is how far a body hangs aside of the pulley that carries it: R to its left or to its right.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from freebody.connections.standing import apart_at_start, is_parallel, is_zero, same_way, stands_at
from freebody.connections.string.node import StringNode, aside
from freebody.language.expression import Expr, add, multiply, negate
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, RIGHT, ZERO, Direction, Point
from freebody.model.elements import ConstraintRow

if TYPE_CHECKING:
    from freebody.model.names import Names


@dataclass(frozen=True)
class Aside:
    """A lead of constant direction as the body at one of its ends sees it: normal . (r - r_other) = offset."""

    other: Point
    normal: Direction
    offset: Expr

    def place(self, names: Names, along: Direction, seen: frozenset[str]) -> Expr | None:
        """Where it keeps the body along a direction; None where the other end has no place that way."""
        if along.body != GROUND or not is_parallel(names, self.normal, along):
            return None
        base = stands_at(names, self.other, along, seen)
        aside = self.offset if same_way(names, self.normal, along) else negate(self.offset)
        return None if base is None else add(base, aside)


@dataclass(frozen=True)
class Hook:
    """A point that strings keep on the lines of its leads: of a body that hangs, or that is guided along."""

    point: Point
    hangs: bool
    leads: tuple[Aside, ...]

    def place(self, names: Names, along: Direction, seen: frozenset[str]) -> Expr | None:
        """Where the leads keep it along a direction."""
        return next((p for lead in self.leads if (p := lead.place(names, along, seen)) is not None), None)

    def row(self, names: Names) -> ConstraintRow:
        """Holds it across its first lead: by its place on the ground where that is known, else beside the other end."""
        lead, body = self.leads[0], self.point.body
        across, target = Displacement(self.point, lead.other, lead.normal), lead.offset
        along = RIGHT if is_parallel(names, lead.normal, RIGHT) else lead.normal
        place = stands_at(names, self.point, along)
        if place is not None:
            across, target = Displacement(self.point, Point(GROUND, (ZERO, ZERO), "ground.origin"), along), place
        return ConstraintRow(f"{body} hangs", "sideways force", across, target, ends=(body,), if_needed=True)


def hooks_of(way: Sequence[StringNode], leads: Sequence[Direction | None], arms: Sequence[Expr]) -> dict[str, Hook]:
    """The bodies that leads of constant direction place, by name."""
    found: dict[str, Hook] = {}
    for k, node in enumerate(way):
        if node.body in found or not (node.hangs or node.guide is not None):
            continue
        sides: list[Aside] = []
        for j, lead in ((k - 1, leads[k - 1]) if k > 0 else (0, None), (k, leads[k]) if k < len(leads) else (0, None)):
            if lead is None:
                continue
            offset = aside(way, arms, j)
            is_end = j + 1 == k
            sides.append(Aside(way[j if is_end else k + 1].point, lead.normal(), offset if is_end else negate(offset)))
        if sides:
            found[node.body] = Hook(node.point, node.hangs, tuple(sides))
    return found


def askew(
    names: Names, way: Sequence[StringNode], leads: Sequence[Direction | None], arms: Sequence[Expr]
) -> Iterator[tuple[Point, Point, Direction]]:
    """Leads whose ends stand so that they cannot have the direction that they are taken to have."""
    for k, lead in enumerate(leads):
        if lead is None or lead.body != GROUND:
            continue
        first, second, normal = way[k].point, way[k + 1].point, lead.normal()
        start, end = stands_at(names, first, normal), stands_at(names, second, normal)
        if start is None or end is None:
            if _is_beside(names, way, leads, arms, k):
                yield first, second, lead
            continue
        if not is_zero(names, add(end, negate(start), negate(aside(way, arms, k)))):
            yield first, second, lead


def _is_beside(
    names: Names, way: Sequence[StringNode], leads: Sequence[Direction | None], arms: Sequence[Expr], k: int
) -> bool:
    """Whether a lead goes up from a wheel that hangs below another one, as from trolley to trolley, and what it leads
    to starts beside it: the first lead of the wheel puts it at C + n rho, its second one at C - n rho."""
    before, after = leads[k - 1] if k > 0 else None, leads[k]
    if before is None or after is None or not way[k].hangs or not is_parallel(names, before, after):
        return False
    apart = apart_at_start(names, way[k - 1].point, way[k + 1].point, RIGHT)
    if apart is None:
        return False
    (n, *_), (m, *_) = before.normal().components, after.normal().components
    rho, other = (aside(way, arms, j) for j in (k - 1, k))
    return not is_zero(names, add(multiply(n, rho), multiply(m, other), negate(apart)))
