"""The cheapest closed set of principles that contains what is asked.

Unknowns are the independent accelerations and the reactions. At a random motion every principle is a row of numbers
over these; a set is closed if the row of what is asked is a combination of its rows. The search is best first:
to what is needed it adds an equation that contains one of the unknowns that are still in the way. Costs say what
a person would count: equations, bodies taken together, reactions nobody asked for.
"""

from __future__ import annotations

import heapq
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import count

import numpy as np
from numpy.typing import NDArray

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.narrative.principles.table import PrincipleTable, Slot, WritablePrinciple
from freebody.symbolic.field import Ratio
from freebody.tolerances import ROUND_OFF

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]
Places = NDArray[np.intp]
# What a principle costs; so chosen that bodies on strings are cut free one by one (two momenta and one moment for an
# Atwood machine) while a momentum of the whole system is preferred to a force between its bodies (cart and pendulum).
EQUATION = 1.0
MORE_BODIES = {"linear": 0.8, "angular": 1.5}
REACTION = 0.3
OTHER_POINT = 0.05  # a centre other than the mass centre or a fixed point
MOVING_POINT = 0.05
UNNATURAL = 0.02  # per place in the list of directions
MASSLESS = -0.2
MOST_STATES = 4000
MOST_EQUATIONS = 12
_SPAN = 1e-7


@dataclass(frozen=True)
class Plan:
    """The chosen principles, and for each the reactions that it avoids and contains (rows)."""

    principles: tuple[WritablePrinciple, ...]
    avoided: tuple[tuple[str, ...], ...]
    contained: tuple[tuple[str, ...], ...]


@dataclass(frozen=True)
class Entry:
    principle: WritablePrinciple
    row: Array
    cost: float


class Planner:
    """Chooses principles of a table. merged: reactions that symmetry makes equal, by row."""

    def __init__(
        self, table: PrincipleTable, numbers: Mapping[int, float], merged: Mapping[str, str] | None = None
    ) -> None:
        self.table = table
        self.model = table.model
        self.numbers = numbers
        self.merged = dict(merged or {})
        n = len(self.model.accelerations)
        self.columns = {row: n + k for k, row in enumerate(table.rows)}
        self.n = n + len(self.columns)
        self._known: dict[frozenset[str] | None, list[Entry]] = {}
        self._slopes = {
            row: {slot: self._number(x) for slot, x in slopes.items()} for row, slopes in table.directions.items()
        }

    def _number(self, x: Ratio) -> float:
        try:
            return float(self.model.field.evaluate(x, self.numbers))
        except (KeyError, ValueError, ArithmeticError):
            raise CannotAnswer(Message("a principle has no real value at a random motion")) from None

    # -- rows ---------------------------------------------------------------------------------
    def column(self, row: str) -> int:
        return self.columns[self.merged.get(row, row)]

    def row_of(self, weights: Mapping[Slot, Ratio]) -> Array:
        """Coefficients of the accelerations and reactions: inertia on the left, reactions moved there."""
        found = np.zeros(self.n)
        for (body, slot), weight in weights.items():
            w = self._number(weight)
            place = self.model.bodies.slots.index(slot)
            inertia = self._number(self.model.dynamics.inertias[body][place])
            for k, partial in enumerate(self.model.kinematics.partial_velocities[body]):
                found[k] += w * inertia * self._number(partial[place])
            for row, slopes in self._slopes.items():
                if (body, slot) in slopes:
                    found[self.column(row)] -= w * slopes[body, slot]
        found[np.abs(found) < ROUND_OFF * max(1.0, float(np.abs(found).max(initial=0.0)))] = 0.0
        return found

    def _cost(self, p: WritablePrinciple, row: Array, place: int) -> float:
        cost = EQUATION + MORE_BODIES[p.kind] * (len(p.bodies) - 1)
        if p.centre is not None and not p.centre.mass_center_of:
            cost += OTHER_POINT + (0.0 if p.centre.is_fixed else MOVING_POINT)
        if p.kind == "linear":
            cost += UNNATURAL * min(place, 6)
        if not row[: len(self.model.accelerations)].any():
            cost += MASSLESS
        return cost

    # -- search -------------------------------------------------------------------------------
    def plan(self, target: Array, among: Sequence[str] | None = None) -> Plan:
        """Principles from whose rows all targets (n_targets, n_unknowns) can be put together. among: bodies that may be
        cut free. Raises CannotAnswer if there are none."""
        entries = self._entries(frozenset(among) if among is not None else None)
        chosen = self._search(entries, target)
        if chosen is None:
            raise CannotAnswer(Message("no closed set of principles was found"))
        ordered = self._in_order([entries[k] for k in chosen], target)
        avoided = tuple(self._avoided(e) for e in ordered)
        contained = tuple(tuple(r for r, k in self.columns.items() if e.row[k]) for e in ordered)
        return Plan(tuple(e.principle for e in ordered), avoided, contained)

    def _entries(self, among: frozenset[str] | None) -> list[Entry]:
        """The principles that may be written, each kind of equation in its cheapest form."""
        if among not in self._known:
            found: list[Entry] = []
            for group in self.table.groups():
                if among is not None and not set(group) <= among:
                    continue
                for place, principle in enumerate(self.table.of(group)):
                    row = self.row_of(principle.weights)
                    if row.any():
                        found.append(Entry(principle, row, self._cost(principle, row, place)))
            self._known[among] = _thinned(found)
        return self._known[among]

    def _search(self, entries: Sequence[Entry], target: Array) -> tuple[int, ...] | None:
        """Best first over sets of entries. A set in which an unknown that is not asked for stands in one row only
        cannot be closed: that row would have to be left out."""
        wanted = np.abs(target).max(axis=0) > 0
        support = np.array([e.row != 0 for e in entries])
        costs = np.array([e.cost for e in entries])
        cheapest = float(costs.min(initial=np.inf))
        tie = count()
        queue: list[tuple[float, int, tuple[int, ...]]] = [(0.0, next(tie), ())]
        seen: set[tuple[int, ...]] = set()
        best: tuple[float, tuple[int, ...]] | None = None
        for _step in range(MOST_STATES):
            if not queue:
                break
            bound, _k, chosen = heapq.heappop(queue)
            if best is not None and bound >= best[0]:
                break
            for k in self._useful(support, chosen, wanted):
                more = tuple(sorted((*chosen, int(k))))
                if more in seen:
                    continue
                seen.add(more)
                times = support[list(more)].sum(axis=0)
                reactions = np.flatnonzero((times > 0) & ~wanted)
                n_reactions = int((reactions >= len(self.model.accelerations)).sum())
                cost = float(costs[list(more)].sum()) + REACTION * n_reactions
                if best is not None and cost >= best[0]:
                    continue
                if not ((times == 1) & ~wanted).any() and _spans(np.array([entries[i].row for i in more]), target):
                    best = cost, more
                elif len(more) < MOST_EQUATIONS:
                    heapq.heappush(queue, (cost + cheapest, next(tie), more))
        if best is not None:
            return best[1]
        return self._everything(entries, target)

    def _useful(self, support: Mask, chosen: tuple[int, ...], wanted: Mask) -> Places:
        """Entries that contain the unknown in the way which the fewest entries contain."""
        if not chosen:
            in_the_way = wanted
        else:
            times = support[list(chosen)].sum(axis=0)
            lonely = (times == 1) & ~wanted
            in_the_way = lonely if lonely.any() else (times > 0) | wanted
        free = support.copy()
        free[list(chosen)] = False
        how_many = np.where(in_the_way, free.sum(axis=0), 0)
        if not how_many.any():
            return np.array([], dtype=int)
        column = int(np.argmin(np.where(how_many > 0, how_many, np.iinfo(np.int64).max)))
        return np.flatnonzero(free[:, column])

    def _everything(self, entries: Sequence[Entry], target: Array) -> tuple[int, ...] | None:
        """All single-body equations, thinned out one by one."""
        chosen: list[int] = []
        rank = 0
        for i, e in sorted(enumerate(entries), key=lambda p: p[1].cost):
            if len(e.principle.bodies) == 1:
                rows = np.array([entries[k].row for k in (*chosen, i)])
                if int(np.linalg.matrix_rank(rows, tol=_SPAN)) > rank:
                    rank += 1
                    chosen.append(i)
        if not chosen or not _spans(np.array([entries[k].row for k in chosen]), target):
            return None
        for i in sorted(chosen, key=lambda k: -entries[k].cost):
            rest = [k for k in chosen if k != i]
            if rest and _spans(np.array([entries[k].row for k in rest]), target):
                chosen = rest
        return tuple(chosen)

    # -- the outcome --------------------------------------------------------------------------
    def _in_order(self, entries: list[Entry], target: Array) -> list[Entry]:
        """First what contains the unknowns that are asked for, then what goes on from there."""
        wanted = {int(k) for k in np.flatnonzero(np.abs(target).max(axis=0))}
        ordered: list[Entry] = []
        left = list(entries)
        while left:
            near = [e for e in left if wanted & {int(k) for k in np.flatnonzero(e.row)}] or left
            e = min(near, key=lambda e: (np.count_nonzero(e.row), e.cost))
            ordered.append(e)
            left.remove(e)
            wanted |= {int(k) for k in np.flatnonzero(e.row)}
        return ordered

    def _avoided(self, e: Entry) -> tuple[str, ...]:
        """Reactions that act on the bodies from outside and do not stand in the equation."""
        found: list[str] = []
        for row, slopes in self._slopes.items():
            own = {body for body, _slot in slopes if body in e.principle.bodies}
            inside = {body for body, _slot in slopes if not self._is_fixed(body)} <= set(e.principle.bodies)
            is_external = not inside or len({b for b, _s in slopes if not self._is_fixed(b)}) == 1
            if own and is_external and not e.row[self.column(row)]:
                found.append(row)
        return tuple(found)

    def _is_fixed(self, body: str) -> bool:
        return self.table.system.bodies[body].fixed


def is_multiple(a: Array, b: Array) -> bool:
    return bool(np.linalg.matrix_rank(np.array([a, b]), tol=_SPAN) < 2)


def _thinned(entries: list[Entry]) -> list[Entry]:
    """Without multiples of cheaper ones, and with at most two equations of the same unknowns."""
    kept: dict[tuple[int, ...], list[Entry]] = {}
    for e in sorted(entries, key=lambda e: e.cost):
        same = kept.setdefault(tuple(map(int, np.flatnonzero(e.row))), [])
        if len(same) < 2 and not any(is_multiple(e.row, other.row) for other in same):
            same.append(e)
    found = [e for same in kept.values() for e in same]
    return sorted(found, key=lambda e: e.cost)


def _spans(rows: Array, targets: Array) -> bool:
    """Whether every target is a combination of the rows."""
    scale = np.abs(rows).max(axis=0)
    absent = scale == 0
    if np.any(targets[:, absent]):
        return False
    scale[absent] = 1.0
    rows, targets = rows / scale, targets / scale
    combined = np.linalg.lstsq(rows.T, targets.T, rcond=None)[0]
    gap = rows.T @ combined - targets.T
    return float(np.abs(gap).max()) < _SPAN * max(1.0, float(np.abs(targets).max()))
