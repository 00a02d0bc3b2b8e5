"""An answer in one part of the space of parameters, and how it comes from the event at which it is asked for."""

from __future__ import annotations

from collections.abc import Generator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.questions.reading import Question
from freebody.study.answering.finding import Elements
from freebody.study.phases.changes_asked import is_before_impact
from freebody.study.phases.ends import FirstEvent
from freebody.study.phases.nodes import PhaseNode, WayToPhase
from freebody.study.phases.numbers import Chosen, holds
from freebody.study.phases.passage import passage_of
from freebody.study.phases.phase import Phase, PhaseWatch
from freebody.study.phases.reached import STRIKES
from freebody.study.phases.tree import PhaseTree
from freebody.study.phases.words import happening, label
from freebody.symbolic.conditions import Condition, require
from freebody.symbolic.phases.energy_motion import EnergyMotion
from freebody.symbolic.ratio import DivisorVanishes, Ratio
from freebody.symbolic.validity import TAKEN

_N_LOOKED_AT = 6  # parameter sets at which something that vanishes at all of them is nothing


@dataclass
class AnswerBranch:
    """An answer in one part of the space of parameters. With `is_home` its elements are of the parameters alone, in the
    field that all phases share; else they are functions of the state in the field of the last phase."""

    value: Elements
    is_home: bool
    nodes: list[PhaseNode]
    first: FirstEvent | None
    conditions: list[Condition]
    sets: Chosen
    time: Ratio | None = None  # of the event, since the start
    notes: list[str] = field(default_factory=list[str])
    after: PhaseNode | None = None  # the phase behind the impact that the event is: the value is that just after it
    needs: list[Condition] = field(default_factory=list[Condition])  # without which it has no value, in the same field
    in_blow: bool = False  # it is of the blow with which the last phase begins
    n_before: int = 0  # phases before the blow or impact from which on the event is meant

    def __post_init__(self) -> None:
        """Where a parameter is zero, as a coefficient of restitution, it is put into the value."""
        alone = [c.element for c in self.conditions if c.relation == "=" and len(c.element.generators()) == 1]
        zeros = {f.index(x): f.zero for x in alone if x == (f := x.field).variable(f.index(x))}
        if zeros and self.is_home:
            with suppress(DivisorVanishes):
                parts = self.value if isinstance(self.value, tuple) else (self.value,)
                put = tuple(x.field.follow(x, zeros) for x in parts)
                self.value = put if isinstance(self.value, tuple) else put[0]

    @property
    def phase(self) -> Phase:
        return self.nodes[-1].phase if self.after is None else self.after.phase

    @property
    def at_start(self) -> bool:
        """Whether what is asked for comes at the very start."""
        return self.first is None and self.time is not None


@contextmanager
def signs_taken(tree: PhaseTree, phase: Phase) -> Generator[list[Condition]]:
    """What the values that are found inside need: the speed behind an impact is the velocity or its opposite, by the
    sign that this has at the model's own numbers."""
    needed = list[Condition]()
    with phase.model.samples.taking() as own, tree.home.model.samples.taking() as there:
        yield needed
    for phase_or_home, taken in ((phase, own), (None, there)):
        for x in taken:
            with suppress(CannotAnswer):
                known = x if phase_or_home is None else tree.to_home(phase_or_home, x)
                condition, _possible = require(known, ">=", TAKEN)
                needed += [] if condition is None or condition in needed else [condition]


def _is_nothing(tree: PhaseTree, x: Ratio) -> bool:
    """Whether an element vanishes whatever the parameters are, as a sum of roots may whose form does not show it: at
    random parameter sets it is round-off of its terms."""
    return all(tree.sets.vanishes(tree.home.model, x, int(k)) for k in tree.indices[:_N_LOOKED_AT])


def where_so(tree: PhaseTree, conditions: Sequence[Condition], sets: Chosen) -> Chosen:
    """Those of some parameter sets at which conditions hold."""
    for c in conditions:
        sets = sets[holds(c, tree.numbers(c.element))[sets]]
    return sets


def branch_at(
    tree: PhaseTree,
    question: Question,
    way: WayToPhase,
    first: FirstEvent,
    conditions: list[Condition],
    sets: Chosen,
    after: PhaseNode | None = None,
) -> AnswerBranch:
    """The value at the event with which a phase ends; after: that behind it, where this is meant."""
    notes: list[str] = []
    time = time_of(tree, way, first)
    if isinstance(course := way.last.phase.course, EnergyMotion) and course.coordinate.speed not in first.zero.values:
        notes.append(
            Message("that it gets so far was checked at many parameter values; there is no short condition for it")
        )
    if after is not None:
        notes.append(just_after(after))
    elif question.transition is not None and question.transition.kind == "before":
        notes.append(Message("just before: {event}", event=happening(first.watch, None)))
    elif is_before_impact(question) and question.quantity.kinematic_order == 1 and _collides(tree, first.watch):
        notes.append(Message("just before the impact of {contact}", contact=label(first.watch.name)))
    elif hits := [other for other in first.together if first.watch.kind == "is reached" and _collides(tree, other)]:
        notes.append(
            Message("just before the impact of {contact}, which comes at the same instant", contact=label(hits[0].name))
        )
    elif first.watch.kind == "is reached" and any(other.kind == STRIKES for other in first.together):
        notes.append(Message("just before the blow, which comes at the same instant"))
    with signs_taken(tree, (way.last if after is None else after).phase) as taken:
        passage = passage_of(tree, way, time, sets, first, after)
        value = question.quantity.counted(passage)
    taken += [c for c in passage.counted_so(lambda x: x) if not _is_nothing(tree, c.element)]
    needed, sets = [*way.conditions, *conditions, *taken], where_so(tree, taken, sets)
    return AnswerBranch(value, True, list(way.nodes), first, needed, sets, time, notes, after)


def _collides(tree: PhaseTree, watch: PhaseWatch) -> bool:
    return watch.kind == "touches" and watch.name not in tree.system.borders


def time_of(tree: PhaseTree, way: WayToPhase, first: FirstEvent) -> Ratio | None:
    """Time since the start: the phases before and the part of the last one."""
    total = tree.home.model.field.zero
    for edge in way.edges:
        if edge.time is None:
            return None
        total = total + edge.time
    return None if first.zero.time is None else total + tree.to_home(way.last.phase, first.zero.time)


def just_after(node: PhaseNode) -> str:
    """That a value is the one behind an impact or a blow."""
    assert node.impact is not None
    if node.impact.blow is not None:
        return Message("just after: {blow}", blow=node.impact.words)
    if node.depth == 0:
        return Message("just after the impact of {contacts} at the start", contacts=node.impact.contacts)
    return Message("just after the impact of {contacts}", contacts=node.impact.contacts)
