"""Instants of a motion in phases, by the numeric route: where the lines of its derivation are looked at.

The modes are integrated one after the other (`study/phases/witness.py`) at some of the parameter sets that take the
same way. Lines about the motion of a phase have to hold at instants within it, at its start and at the event that ends
it.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.narrative.lines.glossary import Glossary, TrueWhen, World
from freebody.numeric.jets import Array
from freebody.numeric.reference import Reference
from freebody.numeric.snapshot import Snapshot
from freebody.questions.event import AskedEvent
from freebody.study.answering.draws import Draw
from freebody.study.phases.branch import AnswerBranch
from freebody.study.phases.evidence import run as followed
from freebody.study.phases.evidence import stage
from freebody.study.phases.followed import begun, changed, follow
from freebody.study.phases.nodes import PhaseNode
from freebody.study.phases.phase import BOUNCES_END
from freebody.study.phases.tree import PhaseTree
from freebody.study.phases.witness import NumericMode, PhaseSnapshot

N_MOTIONS = 3
TIMES = (0.37, 0.71)  # of the duration of a phase
_LONGEST = 400.0
_OPEN_END = 0.7  # [s] that are looked at of a phase that nothing ends
_OPEN_TURN = 4.0  # [rad] that a body turns in it at most: steps shrink where rotation vectors come to a full turn


@dataclass(frozen=True)
class WorldRun:
    """One parameter set that takes the way: its number, and the phases in numbers."""

    k: int
    seen: tuple[PhaseSnapshot, ...]

    def begin(self, phase: int) -> float:
        """TrueWhen a phase begins."""
        return self.seen[phase - 1].time if phase else 0.0


class CourseWorld(World):
    """An instant of a run, within one of its phases."""

    def __init__(self, glossary: Glossary, draw: Draw, snapshot: Snapshot, run: WorldRun, phase: int) -> None:
        super().__init__(glossary, draw, snapshot)
        self.run = run
        self.phase = phase

    @property
    def since(self) -> float:
        """The time since the phase began."""
        return self.snapshot.t - self.run.begin(self.phase)


class WorldRuns:
    """The runs of a piece of an answer."""

    def __init__(self, tree: PhaseTree, piece: AnswerBranch, event: AskedEvent | None) -> None:
        self.tree = tree
        self.piece = piece
        self.event = event

    @cached_property
    def found(self) -> list[WorldRun]:
        """Raises CannotAnswer where the motion cannot be followed in numbers."""
        runs: list[WorldRun] = []
        for k in self.piece.sets:
            if len(runs) >= N_MOTIONS:
                break
            with suppress(CannotAnswer, ArithmeticError, ValueError):
                seen = self._seen(int(k))
                if seen is not None:
                    runs.append(WorldRun(int(k), tuple(seen)))
        if len(runs) < 2:
            raise CannotAnswer(
                Message("the motion could be followed in numbers at too few parameter sets to check its lines")
            )
        return runs

    def _seen(self, k: int) -> Sequence[PhaseSnapshot] | None:
        tree, piece = self.tree, self.piece
        if piece.first is None:
            return self._open(k)
        end: float | None = None
        if piece.time is not None:
            end = float(tree.numbers(piece.time)[k])
            if not 0.0 < end < _LONGEST:
                return None
        found = followed(tree, self.event, piece, k, end)
        met = [other[:2] for other in found[-1].together]
        return found if (piece.first.watch.kind, piece.first.watch.name) in met else None

    def _open(self, k: int) -> Sequence[PhaseSnapshot]:
        """A phase that nothing ends."""
        tree, nodes = self.tree, self.piece.nodes
        key = ("open", tuple(id(n.phase) for n in nodes), k, None if self.event is None else self.event.text)
        if key not in tree.seen:
            values, stages = tree.sets.one(k), [stage(tree, n) for n in nodes]
            end = _open_end(*begun(tree.system, stages[0], values))
            runs = follow(tree.system, stages, values, [end], self.event)
            tree.seen[key] = nodes, runs  # kept with the nodes, so that their numbers stay their own
        return tree.seen[key][1]


def _open_end(mode: NumericMode, q: Array, v: Array) -> float:
    """[s] How long a phase without an end is looked at, by what its bodies turn at first: w t + a t^2/2."""
    turning = mode.references[0].sizes.turning
    rate, gain = (float(np.abs(x[turning]).max(initial=0.0)) for x in (v, mode.accelerations(q, v, 0.0)))
    fastest = rate + math.sqrt(rate**2 + 2.0 * gain * _OPEN_TURN)
    return min(_OPEN_END, 2.0 * _OPEN_TURN / fastest) if fastest > 0.0 else _OPEN_END


class CourseGlossary(Glossary):
    """The symbols of one phase on its way. Lines are looked at within the phase ("always"), where it begins ("start")
    and where it ends ("event"). A phase that begins with the event that is asked for is looked at there only."""

    def __init__(self, node: PhaseNode, runs: WorldRuns, place: int) -> None:
        super().__init__(node.phase.setup)
        self.node = node
        self.runs = runs
        self.place = place

    def worlds(self, when: TrueWhen) -> Iterator[World]:
        follows = self.place == len(self.runs.piece.nodes)
        at_once = when == "event" and self.runs.piece.first is None  # what is asked for comes at the start
        if when == "start" or follows or at_once:
            yield from self._begins
        elif when == "event":
            yield from self._ends
        else:
            yield from self._within

    @cached_property
    def _begins(self) -> list[World]:
        return [self._world(run, self._begin(run)) for run in self.runs.found]

    @cached_property
    def _ends(self) -> list[World]:
        return [self._world(run, run.seen[self.place].snapshot()) for run in self.runs.found]

    @cached_property
    def _within(self) -> list[World]:
        return [self._world(run, snapshot) for run in self.runs.found for snapshot in self._passed(run)]

    def _passed(self, run: WorldRun) -> list[Snapshot]:
        """Instants of the phase between its beginning and its end, kept for other questions."""
        seen, kept = run.seen[self.place], self.runs.tree.seen
        key = ("within", tuple(map(id, run.seen)), self.place)
        if key not in kept:
            begin, (q, v) = run.begin(self.place), self._state(run)
            found: list[Snapshot] = []
            time, seen.mode.near = begin, seen.begin
            bounces = seen.event is not None and seen.event[0] == BOUNCES_END
            end = seen.looks[1].t if bounces else seen.time  # the lines are those of the first flight
            for share in TIMES:
                later = begin + share * (end - begin)
                there = seen.mode.run(q, v, time, later)
                found.append(there.snapshot())
                time, q, v = later, there.q, there.v
            kept[key] = found
        return kept[key]

    def _state(self, run: WorldRun) -> tuple[Array, Array]:
        """Where a phase begins."""
        if self.place:
            before, tree = run.seen[self.place - 1], self.runs.tree
            following = run.seen[self.place].mode.stage if self.place < len(run.seen) else stage(tree, self.node)
            return before.q, changed(tree.system, following, before.mode.values, before.q, before.v, before.time)
        first = run.seen[0].mode
        _mode, q, v = begun(self.runs.tree.system, first.stage, first.values)
        return q, v

    def _mode(self, run: WorldRun) -> NumericMode:
        if self.place < len(run.seen):
            return run.seen[self.place].mode
        return NumericMode(self.runs.tree.system, stage(self.runs.tree, self.node), run.seen[0].mode.values)

    def _begin(self, run: WorldRun) -> Snapshot:
        q, v = self._state(run)
        near = run.seen[self.place].begin if self.place < len(run.seen) else run.seen[-1].mode.near
        return self._mode(run).snapshot(q, v, run.begin(self.place), near)

    def _world(self, run: WorldRun, snapshot: Snapshot) -> World:
        mode = self._mode(run)
        reference = snapshot.reference
        assert isinstance(reference, Reference)
        draw = Draw(mode.values, reference, self._state(run)[0])
        return CourseWorld(self, draw, snapshot, run, self.place)
