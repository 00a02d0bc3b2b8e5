"""The tree of phases: from the start, which mode holds, what ends it, which mode follows.

At an instant every closed bound and every friction without slip is up for decision. A mode is consistent if

    closed   N >= 0                        open at gap 0    gap'' > 0 (gap' > 0)
    sticks   -mu_s N <= T <= mu_s N        slides           s slip' > 0, or slip' = 0 and s slip'' > 0

Which of these holds, and which event comes first, is looked up at several hundred random parameter sets (`Sets`), and
the inequalities that told them apart are the conditions of the branch, as formulas.
Source of the cases: Pfeiffer & Glocker, Multibody Dynamics with Unilateral Contacts, 1996, ch. 5.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any

import numpy as np

from freebody.effort import allowed
from freebody.errors import CannotAnswer, ExpressionError
from freebody.study.phases.events import First, first_events
from freebody.study.phases.home import Home
from freebody.study.phases.numbers import Chosen, Mask
from freebody.study.phases.phase import Phase, Placed, Watch, has_lines
from freebody.symbolic.conditions import Condition
from freebody.symbolic.field import Ratio
from freebody.symbolic.state import SymbolicState
from freebody.system.modes import Mode, ideal_bounds
from freebody.system.system import System

MAX_DEPTH = 5
MAX_NODES = 24
MAX_CANDIDATES = 48
_ZERO = 1e-9
# what can go wrong with formulas that are too long, or that have no value
NO_FORM = (CannotAnswer, ExpressionError, OverflowError, ZeroDivisionError)
_LONG_ANGLE = 3


def why(error: Exception) -> str:
    """Why there is no closed form, for a user."""
    return str(error) if isinstance(error, CannotAnswer) else "the formulas become too long here; simulate the motion"


@dataclass
class Edge:
    """How a phase ends: by an event after a time (None where energy alone describes the motion), or never."""

    first: First | None
    time: Ratio | None  # since the phase began, in the home field
    conditions: list[Condition]
    sets: Chosen  # indices of the parameter sets that take this way
    nodes: list[Node] = field(default_factory=list["Node"])
    stops: str = ""  # why nothing follows

    @property
    def watch(self) -> Watch | None:
        return None if self.first is None else self.first.watch


@dataclass
class Node:
    """A phase in the tree; its conditions are those that make it the one that follows."""

    phase: Phase
    conditions: list[Condition]
    sets: Chosen
    depth: int
    edges: list[Edge] = field(default_factory=list[Edge])
    reason: str = ""  # why its motion has no closed form


class Tree(Home):
    """The phases of a system."""

    def __init__(self, system: System) -> None:
        super().__init__(system)
        self.n_nodes = 0
        self.reasons: list[str] = []
        self.seen: dict[Any, Any] = {}  # motions in numbers, kept for other questions
        self.slips = {
            rub.name: self.at_start(self.home.state.rate(rub.row.measure))
            for rub in self.system.rubs
            if not rub.of or rub.of in self.closed
        }
        self.boundaries = [x for x in self.slips.values() if self.changes_sign(x, self.indices)]
        self.roots = self._follow(Placed(), self.closed, self.slips, {}, self.indices, 0)

    # -- which modes follow -----------------------------------------------------------------------
    def _follow(
        self,
        placed: Placed,
        closed: frozenset[str],
        slips: Mapping[str, Ratio],
        before: Mapping[str, int],
        indices: Chosen,
        depth: int,
        excluded: tuple[str, int] | None = None,
    ) -> list[Node]:
        """The phases that begin in a state, each with the parameter sets for which it does."""
        left = indices
        found: list[Node] = []
        failed: list[list[tuple[Ratio, str, Mask]]] = []  # the checks of the modes tried before, where they fail
        for mode in self._candidates(closed, slips, before, excluded, left):
            if not len(left) or self.n_nodes >= allowed(MAX_NODES):
                break
            try:
                phase = self._phase(mode, placed, left)
                checks = list(self._checks(phase, closed, slips, excluded))
                holds = np.ones(self.sets.n, dtype=bool)
                elements: list[tuple[Ratio, str, str]] = []
                fails: list[tuple[Ratio, str, Mask]] = []
                for x, relation, purpose in checks:
                    value = self.to_home(phase, x)
                    numbers = self.numbers(value)
                    passes = numbers > _ZERO if relation == ">" else numbers >= -_ZERO
                    holds &= passes
                    elements.append((value, relation, purpose))
                    fails.append((value, relation, ~passes))
            except NO_FORM as error:
                self.reasons.append(why(error))
                continue
            mine = left[holds[left]]
            if not len(mine):
                failed.append(fails)
                continue
            elements += _opposites(failed, mine)
            failed.append(fails)
            left = left[~holds[left]]
            self.n_nodes += 1
            conditions = self.conditions(elements, mine)
            found.append(Node(phase, conditions, mine, depth))
        for node in found:
            self._end(node)
        found.sort(key=lambda node: int(node.sets[0]))
        return found

    def _phase(self, mode: Mode, placed: Placed, left: Chosen) -> Phase:
        phase = Phase.begun(self.system, mode, placed, self.sets.some(left, 3))
        if placed.bodies is None and mode.closed != self.closed and has_lines(self.system):
            with suppress(CannotAnswer):
                _ = phase.course
                return phase
            # what is free from the start on may be simpler in other coordinates
            with suppress(CannotAnswer):
                return Phase.begun(
                    self.system, mode, self.placed(self.home, self.home.start.values), self.sets.some(left, 3)
                )
        return phase

    def _candidates(
        self,
        closed: frozenset[str],
        slips: Mapping[str, Ratio],
        before: Mapping[str, int],
        excluded: tuple[str, int] | None,
        indices: Chosen,
    ) -> Iterator[Mode]:
        """Modes in the order in which they are tried: all closed, sticking before sliding."""
        choices: list[list[tuple[str, int | None]]] = []
        for name in sorted(closed):
            open_now = excluded == (name, 0)
            choices.append([(name, None)] if open_now else [(name, 1), (name, None)])
        for name, slip in slips.items():
            signs: list[int]
            if slip.is_zero():
                signs = [0, 1, -1]
                if excluded is not None and excluded[0] == name:
                    signs = [excluded[1]] if excluded[1] else signs
            else:
                numbers = self.numbers(slip)[indices]
                signs = [s for s in (1, -1) if np.any(s * numbers > 0)]
                if np.any(numbers == 0):
                    signs.append(0)
            choices.append([(name, s) for s in signs])
        tried = itertools.islice(itertools.product(*choices), 4 * allowed(MAX_CANDIDATES))
        seen: set[Mode] = set()
        modes: list[tuple[int, int, Mode]] = []
        for k, combination in enumerate(tried):
            still = {n for n, s in combination if n in closed and s is not None}
            still |= {n for n in closed if n not in dict(combination)}
            rubs = {n: s for n, s in combination if n in slips and s is not None and self._touches(n, still)}
            mode = Mode.of(still, rubs)
            if mode not in seen:
                seen.add(mode)
                n_changes = sum(before.get(n, s) != s for n, s in rubs.items()) + 3 * (len(closed) - len(still))
                modes.append((n_changes, k, mode))
        modes.sort(key=lambda item: item[:2])
        yield from (mode for _n, _k, mode in modes[: allowed(MAX_CANDIDATES)])

    def _touches(self, rub: str, closed: set[str]) -> bool:
        of = next(r.of for r in self.system.rubs if r.name == rub)
        return not of or of in closed

    def _checks(
        self, phase: Phase, closed: frozenset[str], slips: Mapping[str, Ratio], excluded: tuple[str, int] | None
    ) -> Iterator[tuple[Ratio, str, str]]:
        """Inequalities between elements of the parameters that make the mode consistent at its start. What an event has
        just let go of, by a force that falls through its limit, goes on of itself."""
        here, model = phase.start_instant.here, phase.model
        if phase.determinant is not None:
            yield here(phase.determinant), ">", "friction forces exist"
        for watch in phase.watches:
            if watch.kind == "opens":
                yield here(watch.element), ">=", f"{watch.connection} keeps touching"
            elif watch.kind == "slips":
                yield here(watch.element), ">=", f"{watch.connection} does not slip"
            elif watch.kind == "slip ends":
                slip = slips[watch.name]
                sign = phase.mode.states[watch.name]
                if excluded is not None and excluded[0] == watch.name:
                    continue
                if slip.is_zero():
                    rub = phase.rubs[watch.name]
                    yield sign * here(phase.state.acceleration(rub.row.measure)), ">", f"{watch.connection} slips"
                else:
                    yield here(watch.element), ">", f"{watch.connection} slips"
        let_go = "" if excluded is None else excluded[0]
        for name in sorted(closed - phase.mode.closed - {let_go}):
            gap = phase.gap(phase.base_row(name))
            rate = here(model.in_independent_speeds(model.rate(gap)))
            if rate.is_zero():
                second = model.field.substitute(model.rate(model.rate(gap)), model.solved_accelerations)
                yield here(second), ">", f"{name.partition('.')[0]} opens"
            else:
                yield rate, ">", f"{name.partition('.')[0]} opens"

    # -- how a phase ends -------------------------------------------------------------------------
    def _end(self, node: Node) -> None:
        """The first events, and what follows each."""
        try:
            found, never = first_events(node.phase, self.sets, node.sets)
        except NO_FORM as error:
            node.reason = why(error)
            return
        for first, indices in found:
            time = None if first.zero.time is None else self.to_home(node.phase, first.zero.time)
            elements = [(self.to_home(node.phase, x), ">", why) for x, why in first.conditions]
            edge = Edge(first, time, self.conditions(elements, indices), indices)
            node.edges.append(edge)
            self._after(node, edge)
        gone = [row.connection for row in ideal_bounds(self.system) if row.name not in node.phase.mode.closed]
        again = f"whether {gone[0]} closes again is not looked at; simulate the motion" if gone else ""
        if len(never):
            elements = [(self.to_home(node.phase, x), ">=", why) for x, why in _negated(found)]
            node.edges.append(Edge(None, None, self.conditions(elements, never), never, stops=again))
        node.edges.sort(key=lambda e: int(e.sets[0]))

    def _after(self, node: Node, edge: Edge) -> None:
        watch = edge.watch
        assert edge.first is not None
        assert watch is not None
        if watch.kind == "touches":
            edge.stops = (
                f"{watch.connection} touches: an impact, at which the formulas end; simulate the motion for more"
            )
            return
        if node.depth + 1 >= allowed(MAX_DEPTH) or self.n_nodes >= allowed(MAX_NODES):
            edge.stops = f"after {node.depth + 1} phases the search ends; raise the effort (--effort) to go on"
            return
        phase = node.phase
        try:
            placed = self.placed(phase, dict(edge.first.zero.values))
        except NO_FORM as error:
            edge.stops = why(error)
            return
        closed = phase.mode.closed
        states = dict(phase.mode.states)
        excluded: tuple[str, int] | None
        if watch.kind == "opens":
            excluded = (watch.name, 0)
        elif watch.kind == "slips":
            excluded = (watch.name, watch.direction)
        else:
            excluded = None
        slips: dict[str, Ratio] = {}
        for name, state in states.items():
            if name == watch.name or state == 0:
                slips[name] = self.home.model.field.zero
            else:
                there = SymbolicState(phase.model, edge.first.zero.values)
                slips[name] = self.to_home(phase, there.rate(phase.rubs[name].row.measure))
        before = {n: s for n, s in states.items() if n != watch.name}
        edge.nodes = self._follow(placed, closed, slips, before, edge.sets, node.depth + 1, excluded)
        if not edge.nodes:
            edge.stops = self.reasons[-1] if self.reasons else "no mode is consistent there"


@lru_cache(maxsize=4)
def tree_of(system: System) -> Tree:
    """The tree of a system, made once for all that is asked of it. Raises CannotAnswer where there is none."""
    return Tree(system)


def _opposites(failed: Sequence[Sequence[tuple[Ratio, str, Mask]]], mine: Chosen) -> list[tuple[Ratio, str, str]]:
    """A mode that is tried before must fail: where one inequality fails it everywhere, that one is turned round."""
    found: list[tuple[Ratio, str, str]] = []
    for checks in failed:
        everywhere = [(x, relation) for x, relation, fails in checks if fails[mine].all()]
        somewhere = [x for x, _relation, fails in checks if fails[mine].any()]
        if len(everywhere) == 1 and len(somewhere) == 1:
            ((x, relation),) = everywhere
            found.append((-x, ">" if relation == ">=" else ">=", ""))
    return found


def _negated(found: Sequence[tuple[First, Chosen]]) -> Iterator[tuple[Ratio, str]]:
    """Where one event alone can happen, and that on one condition, never is its opposite."""
    if len({id(f.watch) for f, _i in found}) == 1 and len(found[0][0].exists) == 1:
        yield -found[0][0].exists[0], "no event ends it"
