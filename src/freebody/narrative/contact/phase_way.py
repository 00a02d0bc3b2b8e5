"""The way through the phases on which a question is answered: phases, what ends each, and their numbers."""

from __future__ import annotations

from collections.abc import Callable, Generator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, Symbol
from freebody.language.sentences import Message, Sentence
from freebody.narrative.contact.phase_forces import newton_of_phase
from freebody.narrative.contact.phase_worlds import CourseGlossary, CourseWorld, WorldRuns
from freebody.narrative.lines.glossary import Glossary, Meaning, World
from freebody.narrative.lines.script import Script
from freebody.narrative.principles.newton import Newton
from freebody.questions.reading import Question
from freebody.study.answering.finding import NO_FORM, why
from freebody.study.phases.branch import AnswerBranch
from freebody.study.phases.ends import FirstEvent
from freebody.study.phases.nodes import PhaseNode
from freebody.study.phases.phase import Phase
from freebody.study.phases.pieces import pieces
from freebody.study.phases.tree import tree_of
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.relations import readable
from freebody.system.system import System


@dataclass
class PhaseSegment:
    """One phase of the way, with what it is written by. first: what ends it, where the way goes on or stops there."""

    number: int
    node: PhaseNode
    first: FirstEvent | None
    time: Ratio | None  # how long it lasts, in the field that all phases share
    glossary: Glossary  # at random motions of the mode
    course: CourseGlossary  # on the way
    newton: Newton
    starting: frozenset[str]  # bounds that are closed when the motion begins

    @property
    def phase(self) -> Phase:
        return self.node.phase

    @cached_property
    def clock(self) -> Expr:
        """The time since the phase began."""
        if self.number == 1:
            return Symbol("t")
        return Symbol(self.free_name(f"tau_{self.number}"))

    @cached_property
    def end(self) -> Expr:
        """How long it lasts."""
        return Symbol(self.free_name(f"t_{self.number}"))

    def free_name(self, name: str) -> str:
        """A name that means nothing else in the model."""
        system = self.phase.base
        while name in system.parameters or name in system.measures:
            name += "_"
        return name


class PhaseSequence:
    """From the start to where a question is answered."""

    def __init__(self, system: System, question: Question) -> None:
        self.system = system
        self.question = question
        try:
            self.tree = tree_of(system, question)
            self.piece: AnswerBranch = pieces(self.tree, question)[0]
        except NO_FORM as error:
            raise CannotAnswer(why(system, error)) from None
        self.runs = WorldRuns(self.tree, self.piece, question.event)
        self.legs = [self._leg(k) for k in range(len(self.piece.nodes))]

    def _leg(self, k: int) -> PhaseSegment:
        node, phase = self.piece.nodes[k], self.piece.nodes[k].phase
        is_last = k == len(self.piece.nodes) - 1
        first = self.piece.first if is_last else self._between(node, self.piece.nodes[k + 1])
        time = None if first is None or first.zero.time is None else self.tree.to_home(phase, first.zero.time)
        return self.leg(k + 1, node, first, time, k)

    def leg(
        self, number: int, node: PhaseNode, first: FirstEvent | None, time: Ratio | None, place: int
    ) -> PhaseSegment:
        """A phase with its glossaries; both know the same symbols."""
        glossary, course = Glossary(node.phase.setup), CourseGlossary(node, self.runs, place)
        course.meanings = glossary.meanings
        made = PhaseSegment(
            number, node, first, time, glossary, course, newton_of_phase(node.phase, glossary), self.tree.closed
        )
        made.newton.is_drawn = node.phase.mode.closed == self.tree.closed
        if number > 1:
            what = Sentence("symbol.since", {"phase": f"@{number}"})
            glossary.introduce(Meaning(made.clock, what, _since, "s"))
        for end in range(1, number + 1):
            name = Symbol(made.free_name(f"t_{end}"))
            what = Sentence("symbol.duration", {"phase": f"@{end}"})
            glossary.introduce(Meaning(name, what, _duration(end - 1), "s"))
        return made

    def _between(self, node: PhaseNode, following: PhaseNode) -> FirstEvent | None:
        for edge in node.edges:
            if any(after.phase is following.phase for after in edge.nodes):
                return edge.first
        raise CannotAnswer(Message("the phases do not follow each other"))

    @cached_property
    def following(self) -> PhaseNode | None:
        """The phase that begins with the event that is asked for, at the parameters of the way."""
        last = self.legs[-1]
        for edge in last.node.edges:
            if last.first is None or edge.first is None or edge.first.watch is not last.first.watch:
                continue
            for node in edge.nodes:
                if len(np.intersect1d(node.sets, self.piece.sets)):
                    return node
        return None

    def home(self, leg: PhaseSegment, x: Ratio) -> Ratio:
        """An element of the parameters in the field that all phases share."""
        return self.tree.to_home(leg.phase, x)

    def shown(self, leg: PhaseSegment, x: Ratio) -> Expr:
        return readable(self.home(leg, x))


def _since(world: World) -> float:
    assert isinstance(world, CourseWorld)
    return world.since


def _duration(phase: int) -> Callable[[World], float]:
    """Reads how long a phase lasts."""

    def read(world: World) -> float:
        assert isinstance(world, CourseWorld)
        return world.run.seen[phase].time - world.run.begin(phase)

    return read


@contextmanager
def on_the_way(script: Script, glossary: Glossary) -> Generator[None]:
    """Lines are looked at where a glossary says."""
    before, script.glossary = script.glossary, glossary
    try:
        yield
    finally:
        script.glossary = before
