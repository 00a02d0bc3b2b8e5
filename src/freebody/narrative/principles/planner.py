"""The cheapest closed set of principles that contains what is asked.

Unknowns are the independent accelerations and the reactions. At a random motion every principle is a row of numbers
over these; a set is closed if the row of what is asked is a combination of its rows. What is known of the reactions is
put into the rows: a friction that slides counts as its normal force, what has opened as nothing. At rest there are no
accelerations; then the loads are a last column, and a set from which all reactions drop out is a condition on the
parameters. The search is best first: to what is needed it adds an equation that contains one of the unknowns that are
still in the way. Costs say what a person would count: equations, bodies taken together, reactions nobody asked for.
"""

from __future__ import annotations

import heapq
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import count

import numpy as np
from numpy.typing import NDArray

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.narrative.principles.acting import Slot
from freebody.narrative.principles.table import Kind, PrincipleTable, WritablePrinciple
from freebody.symbolic.ratio import Ratio
from freebody.tolerances import ROUND_OFF

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]
Places = NDArray[np.intp]
MOST_STATES = 4000
MOST_EQUATIONS = 12
_SPAN = 1e-7  # of unit rows: what lies within this of the span of others depends on them, at rounded poses
EQUATION = 1.0
REACTION = 0.3
OTHER_POINT = 0.05  # a centre other than the mass centre or a fixed point
UNNATURAL = 0.02  # per place in the list of directions
MASSLESS = -0.2


@dataclass(frozen=True)
class Preferences:
    """What a principle costs beside one equation, and how widely is searched.

    The costs of the plane are so chosen that bodies on strings are cut free one by one (two momenta and one moment for
    an Atwood machine) while a momentum of the whole system is preferred to a force between its bodies (cart and
    pendulum)."""

    more_bodies: Mapping[Kind, float] = field(default_factory=lambda: {"linear": 0.8, "angular": 1.5})
    moving_point: float = 0.05
    whole: float | None = None  # all bodies together, where that is less than their number says
    force: float = 0.0  # for every reaction in it
    most_alike: int | None = 2  # equations of the same unknowns
    is_wide: bool = False  # whether every principle that touches what is unknown so far is looked at
    one_by_one: bool = False  # whether each unknown is planned for on its own


IN_THE_PLANE = Preferences()
# where nothing moves there are no momenta to be added up: the whole of a frame or truss, or a part of it, comes first
OF_STRUCTURES = Preferences(more_bodies={"linear": 0.1, "angular": 0.1}, whole=0.05)
# in space it is the equations of one body that are many: those of several bodies together are preferred
IN_SPACE = Preferences(more_bodies={"linear": 0.2, "angular": 0.2}, one_by_one=True)
# where a friction counts as its normal force, an equation may be needed although no unknown of it is alone; moments
# about a point that moves with the contact are what one takes last
WITH_CONTACTS = Preferences(moving_point=0.45, is_wide=True)
SLIDING_IN_SPACE = replace(IN_SPACE, moving_point=0.45, is_wide=True)
# with frictions at their limit many equations have the same unknowns, and those with fewer forces come first
AT_REST = Preferences(force=0.05, most_alike=None, is_wide=True)


@dataclass(frozen=True)
class Plan:
    """The chosen principles, and for each the reactions that it avoids and contains (rows)."""

    principles: tuple[WritablePrinciple, ...] = ()
    avoided: tuple[tuple[str, ...], ...] = ()
    contained: tuple[tuple[str, ...], ...] = ()

    @classmethod
    def united(cls, plans: Sequence[Plan]) -> Plan:
        """Several plans as one, each principle once."""
        chosen: list[tuple[WritablePrinciple, tuple[str, ...], tuple[str, ...]]] = []
        for plan in plans:
            for entry in zip(plan.principles, plan.avoided, plan.contained, strict=True):
                if all(entry[0] != other[0] for other in chosen):
                    chosen.append(entry)
        principles, avoided, contained = zip(*chosen, strict=True) if chosen else ((), (), ())
        return cls(tuple(principles), tuple(avoided), tuple(contained))

    @property
    def bodies(self) -> tuple[str, ...]:
        """All that are cut free."""
        return tuple(dict.fromkeys(body for p in self.principles for body in p.bodies))


@dataclass(frozen=True)
class Entry:
    principle: WritablePrinciple
    row: Array
    cost: float


class Planner:
    """Chooses principles of a table."""

    def __init__(
        self,
        table: PrincipleTable,
        numbers: Mapping[int, float],
        preferences: Preferences,
        merged: Mapping[str, str] | None = None,
        *,
        counts_loads: bool = False,
        knows_resultants: bool = True,
    ) -> None:
        """merged: reactions that symmetry makes equal, by row; counts_loads: the loads are a column, since a condition
        on the parameters is wanted; knows_resultants: what presses with a resultant is known where that rubs."""
        self.table, self.acting, self.model = table, table.acting, table.model
        self.numbers, self.preferences = numbers, preferences
        self.merged = dict(merged or {})
        self.n_accelerations = len(self.model.accelerations)
        self.columns = {row: self.n_accelerations + k for k, row in enumerate(self.acting.rows)}
        self.loads = self.n_accelerations + len(self.columns)  # their column
        self.n = self.loads + 1
        self._counts_loads = counts_loads
        laws = self.acting.known.laws
        self._laws = {name: law for name, law in laws.items() if knows_resultants or not law.resultant}
        self._known: dict[frozenset[str] | None, list[Entry]] = {}
        self._slopes = {row: self._numbers(slopes) for row, slopes in self.acting.directions.items()}
        self._factors = {name: self._number(law.factor) for name, law in self.acting.known.laws.items()}
        self._pushes = [self._numbers(slopes, law) for _p, law, slopes in self.acting.loads] if counts_loads else []
        self._changes = {} if self.acting.is_at_rest else {b.name: self._momenta(b.name) for b in table.system.moving}

    def _number(self, x: Ratio) -> float:
        try:
            return float(self.model.field.evaluate(x, self.numbers))
        except (KeyError, ValueError, ArithmeticError):
            raise CannotAnswer(Message("a principle has no real value at a random motion")) from None

    def _numbers(self, slopes: Mapping[Slot, Ratio], factor: Ratio | None = None) -> dict[Slot, float]:
        return {slot: self._number(x if factor is None else factor * x) for slot, x in slopes.items()}

    def _momenta(self, body: str) -> list[list[float]]:
        """By acceleration: what a unit of it changes in the momentum of a body, along its slots."""
        partials = self.model.kinematics.partial_velocities[body]
        return [[self._number(x) for x in self.model.dynamics.momentum(body, partial)] for partial in partials]

    # -- rows ---------------------------------------------------------------------------------
    def column(self, row: str) -> int:
        return self.columns[self.merged.get(row, row)]

    def target(self, row: str) -> Array:
        """The row of an unknown reaction, as far as it is not known."""
        found = np.zeros(self.n)
        found[self.column(row)] = 1.0
        return self._decided(found)

    def row_of(self, weights: Mapping[Slot, Ratio]) -> Array:
        """Coefficients of the accelerations and reactions: inertia on the left, reactions and loads moved there."""
        found = np.zeros(self.n)
        numbers = self._numbers(weights)
        for (body, slot), w in numbers.items():
            place = self.model.bodies.slots.index(slot)
            for k, change in enumerate(self._changes.get(body, ())):
                found[k] += w * change[place]
            for row, slopes in self._slopes.items():
                if (body, slot) in slopes:
                    found[self.column(row)] -= w * slopes[body, slot]
            for slopes in self._pushes:
                found[self.loads] -= w * slopes.get((body, slot), 0.0)
        found[np.abs(found) < ROUND_OFF * max(1.0, float(np.abs(found).max(initial=0.0)))] = 0.0
        return self._decided(found)

    def _decided(self, row: Array) -> Array:
        """With what is known of the reactions put in."""
        known = self.acting.known
        for name in known.absent:
            row[self.column(name)] = 0.0
        for name, law in self._laws.items():
            column = self.column(name)
            if law.load:
                row[self.column(law.load)] += self._factors[name] * row[column]
            elif self._counts_loads:
                row[self.loads] += self._factors[name] * row[column]
            row[column] = 0.0
        return row

    def _arms(self, weights: Mapping[Slot, Ratio]) -> dict[str, float]:
        """By row: what its reaction weighs in a principle."""
        numbers = self._numbers(weights)
        return {
            row: sum(w * slopes.get(slot, 0.0) for slot, w in numbers.items()) for row, slopes in self._slopes.items()
        }

    def _cost(self, p: WritablePrinciple, row: Array, place: int) -> float:
        more = self.preferences.more_bodies[p.kind] * (len(p.bodies) - 1)
        if self.preferences.whole is not None and len(p.bodies) == len(self.table.system.moving):
            more = min(more, self.preferences.whole)
        cost = EQUATION + more
        if p.centre is not None and not p.centre.mass_center_of:
            cost += OTHER_POINT + (0.0 if p.centre.is_fixed else self.preferences.moving_point)
        if p.kind == "linear":
            cost += UNNATURAL * min(place, 6)
        if not row[: self.n_accelerations].any():
            cost += MASSLESS
        if self.preferences.force:
            arms = self._arms(p.weights)
            n_forces = sum(abs(arm) > ROUND_OFF for name, arm in arms.items() if name not in self.acting.known.absent)
            cost += self.preferences.force * n_forces
        return cost

    # -- search -------------------------------------------------------------------------------
    def plan(self, target: Array, among: Sequence[str] | None = None, known: Sequence[int] = ()) -> Plan:
        """Principles from whose rows all targets (n_targets, n_unknowns) can be put together. among: bodies that may be
        cut free; known: columns of unknowns that have been found before. Raises CannotAnswer if there are none."""
        entries = _without(self._entries(frozenset(among) if among is not None else None), known)
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
            self._known[among] = _thinned(found, self.preferences.most_alike)
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
            useful = self._useful(support, chosen, wanted)
            # how often each unknown stands in the set with each of these more, all at once
            times = support[list(chosen)].sum(axis=0) + support[useful]
            n_reactions = ((times > 0) & ~wanted)[:, self.n_accelerations :].sum(axis=1).tolist()
            is_open = ((times == 1) & ~wanted).any(axis=1).tolist()
            for place, k in enumerate(useful.tolist()):
                more = tuple(sorted((*chosen, k)))
                if more in seen:
                    continue
                seen.add(more)
                cost = float(costs[list(more)].sum()) + REACTION * n_reactions[place]
                if best is not None and cost >= best[0]:
                    continue
                if not is_open[place] and _spans(np.array([entries[i].row for i in more]), target):
                    best = cost, more
                elif len(more) < MOST_EQUATIONS:
                    heapq.heappush(queue, (cost + cheapest, next(tie), more))
        if best is not None:
            return best[1]
        return self._everything(entries, target)

    def _useful(self, support: Mask, chosen: tuple[int, ...], wanted: Mask) -> Places:
        """Entries that contain the unknown in the way which the fewest entries contain: one that stands alone, else one
        that is asked for and stands nowhere yet; in a wide search all that contain one of those that stand there."""
        free = support.copy()
        free[list(chosen)] = False
        if not chosen:
            in_the_way = wanted
        else:
            times = support[list(chosen)].sum(axis=0)
            if self.preferences.is_wide:
                return np.flatnonzero(free[:, (times > 0) | wanted].any(axis=1))
            lonely, missing = (times == 1) & ~wanted, (times == 0) & wanted
            in_the_way = next((some for some in (lonely, missing) if some.any()), (times > 0) | wanted)
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
        together: dict[int, float] = {}  # of those that symmetry makes equal
        for row, arm in self._arms(e.principle.weights).items():
            together[self.column(row)] = together.get(self.column(row), 0.0) + arm
        small = ROUND_OFF * max(1.0, max(map(abs, together.values()), default=0.0))
        outside = set(self.acting.from_outside(e.principle.bodies)) - self.acting.known.absent.keys()
        return tuple(row for row in self._slopes if row in outside and abs(together[self.column(row)]) < small)


def _without(entries: list[Entry], known: Sequence[int]) -> list[Entry]:
    """The rows in what is still unknown."""
    if not known:
        return entries
    left = [(e, np.where(np.isin(np.arange(len(e.row)), known), 0.0, e.row)) for e in entries]
    return [replace(e, row=row) for e, row in left if row.any()]


def _thinned(entries: list[Entry], most_alike: int | None) -> list[Entry]:
    """The cheapest first, without multiples of cheaper ones, and with a few equations of the same unknowns only."""
    kept: list[Entry] = []
    alike: dict[tuple[int, ...], list[Entry]] = {}
    for e in sorted(entries, key=lambda e: e.cost):
        same = alike.setdefault(tuple(map(int, np.flatnonzero(e.row))), [])
        if (most_alike is None or len(same) < most_alike) and not any(_is_multiple(e.row, o.row) for o in same):
            same.append(e)
            kept.append(e)
    return kept


def _is_multiple(a: Array, b: Array) -> bool:
    return bool(np.linalg.matrix_rank(np.array([a, b]), tol=_SPAN) < 2)


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
