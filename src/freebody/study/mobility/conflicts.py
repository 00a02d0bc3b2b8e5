"""Which parts of a model contradict each other, where its start cannot be assembled.

An irreducible set of conditions cannot hold together, but does without any one of them. It is found by two filters:

    sensitivity   in the pose that comes nearest to fulfilling everything, sum F_i grad F_i = 0: conditions whose gap
                  F_i is zero there have no part in that balance and are left out, if the rest still contradicts itself
    deletion      of what is left, by halves and then one by one, conditions are left out for good if the rest still
                  contradicts itself

"Contradicts itself" means that no start of several leads to a pose without gaps: a set may be named that only a farther
start could fulfil, as with every assembly.
Source: Chinneck & Dravnieks, ORSA Journal on Computing 3, 1991, 157-168.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from freebody.budgets import allowed
from freebody.language.sentences import Message, in_turn, listed
from freebody.measures.angle import Angle
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, Point
from freebody.numeric.closing import cannot_close
from freebody.numeric.described import axes_of
from freebody.numeric.jet_geometry import JetGeometry
from freebody.numeric.jets import Array, Jet
from freebody.numeric.mobility.described import attitude, described
from freebody.numeric.placing import ACCEPTED, TOLERANCE, Fit, Placing, PoseEquation
from freebody.numeric.reference import Reference
from freebody.numeric.start import N_STARTS, start_values
from freebody.system.system import System

MOST_EVALUATIONS = 40_000  # of a single condition; half of it again once it is clear that there is a contradiction
QUICK_STARTS = 5  # of a trial within the filters
SHARES = (0.1, 1e-2, 1e-3, 1e-4)  # of the largest gap, below which a condition has no part in the balance


@dataclass(frozen=True)
class Conflict:
    """Conditions that cannot hold together: connections, entries of start, `at of BODY`, `angle of BODY`."""

    names: tuple[str, ...]
    gap: str  # what is missed in the pose that comes nearest, with its unit
    is_geometric: bool  # the connections alone contradict each other, whatever the start
    is_minimal: bool = True  # without any one of them the others hold
    proof: str | None = None  # the inequality of lengths that no pose can fulfil, where one is found

    @property
    def message(self) -> str:
        """What contradicts, by how much, and what to do."""
        if self.proof is not None:
            told = Message("{names} contradict each other: {why}", names=listed(self.names), why=self.proof)
            return in_turn([told, self._cut_short], "{first}. {second}") if self._cut_short else told
        told = Message(
            "{names} contradict each other: at best {gap}, from every start that was tried. Change or leave out one of "
            "them, or change the {what}."
            if len(self.names) > 1
            else "{names} cannot hold: at best {gap}, from every start that was tried. Change or leave out one of "
            "them, or change the {what}.",
            names=listed(self.names),
            gap=self.gap,
            what=Message("lengths and positions" if self.is_geometric else "start (at, angle, start) or the lengths"),
        )
        return in_turn([told, self._cut_short], "{first} {second}") if self._cut_short else told

    @property
    def _cut_short(self) -> str:
        if self.is_minimal:
            return ""
        return Message("Perhaps not all of them are needed for it: the search was cut short.")

    def to_plain(self) -> dict[str, Any]:
        return {
            "names": list(self.names),
            "gap": self.gap,
            "is_geometric": self.is_geometric,
            "is_minimal": self.is_minimal,
            "proof": self.proof,
            "message": self.message,
        }


def conflict(system: System, most_evaluations: int = MOST_EVALUATIONS) -> Conflict | None:
    """A smallest set of conditions of a model that contradict each other, or None if the start can be assembled.
    The set may not be the smallest where the search needs more than about `most_evaluations` of a condition, or half of
    it after the assembly itself. Positions only: rates are not looked at. Raises CannotAnswer if parameters have no
    value."""
    budget = allowed(most_evaluations) if most_evaluations else 0
    search = _AssemblySearch(system, _Work(budget))
    everything = tuple(search.equations)
    fit = search.try_all(everything, to_the_end=True)
    if fit is None:
        return None
    search.work.grant(budget // 2)
    alone = tuple(dict.fromkeys(row.connection for row in system.constraint_rows if row.connection in search.equations))
    geometric = search.try_some(alone, fit) if len(alone) < len(everything) else fit
    suspects, fit = (everything, fit) if geometric is None else (alone, geometric)
    suspects, fit = search.by_sensitivity(suspects, fit)
    search, fit = search.among(suspects, fit)
    names, fit = search.by_deletion(suspects, fit)
    proof = cannot_close(search.reference, () if geometric is not None else start_values(search.reference, ()))
    return Conflict(names, fit.gap, geometric is not None, search.is_complete, proof)


# -- trials -----------------------------------------------------------------------------------
@dataclass(frozen=True)
class _Miss:
    """The pose that comes nearest to fulfilling a set of conditions, which none of the starts does."""

    fit: Fit | None
    placing: Placing | None = None

    @property
    def gap(self) -> str:
        if self.fit is None or self.placing is None:
            return Message("there is no pose in which all measures have a value")
        return self.placing.with_one_gap(self.fit).worst

    def sizes(self) -> dict[int, float]:
        """How large the gap of each equation is, by its identity, in parts of the largest."""
        if self.fit is None:
            return {}
        sizes = np.abs(self.fit.weights * self.fit.gaps)
        largest = float(sizes.max(initial=0.0)) or 1.0
        return {id(e): float(x) / largest for e, x in zip(self.fit.equations, sizes, strict=True)}


@dataclass
class _Work:
    """What a search has done, counted in evaluations of single conditions."""

    most: int
    done: int = 0

    def grant(self, more: int) -> None:
        """At least so much from now on."""
        self.most = max(self.most, self.done + more)

    @property
    def is_exhausted(self) -> bool:
        return self.done >= self.most

    def counted(self, equation: PoseEquation) -> PoseEquation:
        """The equation, which counts how often it is looked at."""

        def gap(g: JetGeometry) -> Jet:
            self.done += 1
            return equation.gap(g)

        return replace(equation, gap=gap)


class _AssemblySearch:
    """Assembles a system under some of its conditions."""

    def __init__(self, system: System, work: _Work) -> None:
        self.reference = Reference(system)
        self.work = work
        self.equations = {
            name: [work.counted(equation) for equation in equations]
            for name, equations in _conditions(self.reference).items()
        }
        self.is_complete = True
        self._guess = described(self.reference)

    def try_all(self, names: Sequence[str], *, to_the_end: bool = False) -> _Miss | None:
        """None if the conditions can be fulfilled; from as many starts as the assembly of a model, but for the first
        trial only as long as the budget lasts."""
        return self._miss(names, self._starts(range(N_STARTS)), to_the_end=to_the_end)

    def try_some(self, names: Sequence[str], near: _Miss) -> _Miss | None:
        """The same from a pose that nearly does and a few other starts."""
        first = [] if near.fit is None else [near.fit.q]
        # the smallest disturbances tell little beside the pose that nearly does
        return self._miss(names, [*first, *self._starts(range(3, 3 + QUICK_STARTS - 1))])

    def _starts(self, disturbed: Iterable[int]) -> list[Array]:
        """The description of the bodies, then disturbed ones, as `numeric.start` has them."""
        n, unit_moves = len(self._guess), self.reference.sizes.unit_moves
        moves = ((k, np.random.default_rng(k).standard_normal(n)) for k in disturbed)
        moved = self.reference.frame.moved
        return [self._guess, *(moved(self._guess, min(1.0, 0.02 * 2.0**k) * unit_moves * move) for k, move in moves)]

    def _miss(self, names: Sequence[str], starts: Sequence[Array], *, to_the_end: bool = False) -> _Miss | None:
        equations = [equation for name in names for equation in self.equations[name]]
        best: Fit | None = None
        for k, q in enumerate(starts):
            if k >= QUICK_STARTS and not to_the_end and self.work.is_exhausted:
                self.is_complete = False
                break
            fit = self.reference.placing.fit(q, equations, 0.0, {})
            if fit is not None and (best is None or fit.error < best.error):
                best = fit
            if best is not None and best.error <= TOLERANCE:
                return None
        return None if best is not None and best.error <= ACCEPTED else _Miss(best, self.reference.placing)

    def among(self, names: Sequence[str], miss: _Miss) -> tuple[_AssemblySearch, _Miss]:
        """The search in a system of the bodies that the conditions speak of alone, which is quicker. The same search if
        they speak of all, or if the bodies alone can fulfil them."""
        system = self.reference.system
        words = {name.partition(" of ")[2] for name in names}
        rows = [row for row in system.constraint_rows if row.connection in names]
        measures = [m for name, m in system.measures.items() if name in names or f"start of {name}" in names]
        used = {b for item in (*(row.measure for row in rows), *measures) for b in item.bodies()}
        bodies = {k: b for k, b in system.bodies.items() if b.fixed or k in used or k in words}
        if len(bodies) == len(system.bodies):
            return self, miss
        smaller = replace(system, bodies=bodies, constraint_rows=tuple(rows), applied_loads=(), impulses=(), offered=())
        smaller = replace(smaller, blows=())
        search = _AssemblySearch(smaller, self.work)
        search.equations = {name: search.equations[name] for name in names}
        search.is_complete = self.is_complete
        left = search.try_some(names, _Miss(None))
        return (self, miss) if left is None else (search, left)

    # -- filters ------------------------------------------------------------------------------
    def by_sensitivity(self, names: tuple[str, ...], miss: _Miss) -> tuple[tuple[str, ...], _Miss]:
        """Leaves out what has next to no gap in the nearest pose, if the rest still contradicts itself; the large gaps
        are tried alone first, since far models stop a little before the nearest pose."""
        sizes = miss.sizes()
        largest = {n: max(sizes.get(id(e), 1.0) for e in self.equations[n]) for n in names}
        for share in SHARES:
            kept = tuple(n for n in names if largest[n] > share)
            if len(kept) == len(names):
                break
            left = self.try_some(kept, miss) if kept else None
            if left is not None:
                return self.by_sensitivity(kept, left)
        return names, miss

    def by_deletion(self, names: tuple[str, ...], miss: _Miss) -> tuple[tuple[str, ...], _Miss]:
        """Leaves out what is not needed for the contradiction, by halves, and what has the smallest gaps first."""
        sizes = miss.sizes()
        left: tuple[tuple[str, ...], _Miss] = names, miss
        chunks = [sorted(names, key=lambda n: max(sizes.get(id(e), 1.0) for e in self.equations[n]))]
        while chunks:
            chunk = chunks.pop()
            rest = tuple(n for n in left[0] if n not in chunk)
            if self.work.is_exhausted:
                self.is_complete = False
                break
            without = self.try_some(rest, left[1]) if rest else None
            if without is not None:
                left = rest, without
            elif len(chunk) > 1:
                half = len(chunk) // 2
                chunks += [chunk[half:], chunk[:half]]
        if len(left[0]) == len(names) or not self.is_complete:
            return left
        thorough = self.try_all(left[0])
        if thorough is None:  # the few starts of a trial missed a pose: what was left out is needed after all
            self.is_complete = False
            return names, miss
        return left[0], thorough


def _conditions(reference: Reference) -> dict[str, list[PoseEquation]]:
    """The equations of the start by what the user calls them."""
    system = reference.system
    found: dict[str, list[PoseEquation]] = {}
    connections = {row.name: row.connection for row in system.constraint_rows}
    for equation in reference.held_by_targets():
        found.setdefault(connections[equation.name], []).append(equation)
    for name, expr in system.start.items():
        target = Jet(reference.number(expr))
        key = name if name not in found else f"start of {name}"
        found.setdefault(key, []).append(PoseEquation.of(name, system.measures[name], target))
    for body in system.moving:
        start = body.start
        if start.at is not None:
            point, place = start.at
            for axis, expr in zip(axes_of(system), place, strict=True):
                measure = Displacement(body.point(point), Point(GROUND), axis)
                equation = PoseEquation.of(f"the given place of {body.name}", measure, Jet(reference.number(expr)))
                found.setdefault(f"the given place of {body.name}", []).append(equation)
        if start.angle is not None and body.turns:
            angle = Jet(reference.number(start.angle))
            found[f"angle of {body.name}"] = [PoseEquation.of(f"angle of {body.name}", Angle(body.name), angle)]
        if start.turned is not None and body.turns:
            found[f"turned of {body.name}"] = attitude(reference, body.name, start.turned)
    return found
