"""The tree of phases as it is made: phases, what ends them, the impacts with which they begin."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message, in_turn
from freebody.study.phases.ends import FirstEvent
from freebody.study.phases.impact import ClosedFormCollision, SuddenBlow
from freebody.study.phases.numbers import Chosen
from freebody.study.phases.phase import Phase, PhaseWatch
from freebody.study.phases.placed import Placed
from freebody.study.phases.words import label
from freebody.symbolic.conditions import Condition
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.state import SymbolicState
from freebody.system.blows import BlowEvent
from freebody.system.modes import Way


@dataclass
class PhaseEnd:
    """How a phase ends: by an event after a time (None where energy alone describes the motion), or never."""

    first: FirstEvent | None
    time: Ratio | None  # since the phase began, in the home field
    conditions: list[Condition]
    sets: Chosen  # indices of the parameter sets that take this way
    nodes: list[PhaseNode] = field(default_factory=list["PhaseNode"])
    stops: str = ""  # why nothing follows
    is_exact: bool = True  # the conditions tell it from the other ends
    is_proved: bool = True  # that nothing else ends the phase follows from formulas

    @property
    def watch(self) -> PhaseWatch | None:
        return None if self.first is None else self.first.watch


@dataclass(frozen=True)
class JustBefore:
    """The state just before a blow, in the phase that it ends."""

    setup: Phase
    now: SymbolicState


@dataclass(frozen=True)
class PhaseImpact:
    """A blow, a collision, or one by the other, with which a phase begins: what hits, and the impulses by row in the
    home field; `before` is the state just before. unknown: rows whose impulses are not unique, and why."""

    hits: tuple[str, ...]
    impulses: Mapping[str, Ratio]
    before: ClosedFormCollision | JustBefore
    kept: frozenset[str] = frozenset()  # what touched before
    sudden: SuddenBlow | None = None
    unknown: Mapping[str, CannotAnswer] = field(default_factory=dict[str, CannotAnswer])
    collision: tuple[ClosedFormCollision, Mapping[str, Ratio]] | None = None  # with its impulses in its own field

    @property
    def blow(self) -> BlowEvent | None:
        """What closes and strikes at an event."""
        return None if self.sudden is None else self.sudden.blow

    @property
    def touched(self) -> frozenset[str]:
        """What strikes, and what has touched until then."""
        gone = () if self.collision is None else self.collision[0].gone
        return frozenset((*self.hits, *self.kept, *(row.name for row in gone)))

    @property
    def struck(self) -> frozenset[str]:
        """The rows along which it collides."""
        return frozenset(() if self.collision is None else self.collision[0].by_row(self.collision[1]))

    def is_in(self, connection: str) -> bool:
        """Whether it happens in one connection. Raises CannotAnswer where others strike at once."""
        closing = () if self.blow is None else self.blow.striking
        struck = {name.partition(".")[0] for name in (*self.hits, *closing)}
        if connection in struck and len(struck) > 1:
            names = ", ".join(sorted(struck))
            raise CannotAnswer(Message("{names} strike at once; what each of them takes is not told", names=names))
        return connection in struck

    @property
    def words(self) -> str:
        impact = Message("impact of {contacts}", contacts=self.contacts)
        if self.blow is None:
            return impact
        return Message("{blow}, {impact}", blow=self.blow.words, impact=impact) if self.hits else self.blow.words

    @property
    def contacts(self) -> str:
        return in_turn([*dict.fromkeys(label(name) for name in self.hits)])


@dataclass
class PhaseNode:
    """A phase in the tree; its conditions are those that make it the one that follows."""

    phase: Phase
    conditions: list[Condition]
    sets: Chosen
    depth: int
    edges: list[PhaseEnd] = field(default_factory=list[PhaseEnd])
    reason: str = ""  # why its motion has no closed form
    impact: PhaseImpact | None = None  # with which it begins
    n_impacts: int = 0  # so far
    is_exact: bool = True
    known: tuple[Condition, ...] = ()  # what holds on the way to it
    began: Ratio | None = None  # since the start, in the home field; None: no closed form


@dataclass(frozen=True)
class PhaseStart:
    """A state in which a phase begins: what touches without parting, slips by friction, and what comes from before."""

    placed: Placed
    closed: frozenset[str]
    slips: Mapping[str, Ratio]
    before: Mapping[str, int] = field(default_factory=dict[str, int])
    excluded: tuple[str, int] | None = None
    impact: PhaseImpact | None = None
    n_impacts: int = 0
    known: tuple[Condition, ...] = ()  # what holds on the way to it
    given: tuple[Condition, ...] = ()  # what makes it the state that follows
    past: frozenset[str] = frozenset()  # the blows that have happened
    began: Ratio | None = None  # since the start, in the home field
    ways: Mapping[str, Way] = field(default_factory=dict[str, Way])  # in which slips in planes are counted
    acting: Mapping[str, bool] = field(default_factory=dict[str, bool])  # of loads with a border, by that; not at it


@dataclass(frozen=True)
class WayToPhase:
    """From the start to the beginning of a phase."""

    nodes: tuple[PhaseNode, ...]
    edges: tuple[PhaseEnd, ...]
    conditions: tuple[Condition, ...]

    def on(self, edge: PhaseEnd, node: PhaseNode) -> WayToPhase:
        return WayToPhase(
            (*self.nodes, node), (*self.edges, edge), (*self.conditions, *edge.conditions, *node.conditions)
        )

    @property
    def last(self) -> PhaseNode:
        return self.nodes[-1]
