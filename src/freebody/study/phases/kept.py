"""Questions that are about one law of motion, of a system with contacts or dry friction: freedoms, what is conserved,
small and steady motions. They are answered in the mode with which the motion begins.

What touches keeps touching and what sticks keeps sticking, which gives the conditions: at the equilibrium, or in the
steady motion, contacts push and friction stays within its limits.
"""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from math import isclose

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.loads.base import Load
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer, AnswerCase
from freebody.study.answering.closed_form import QuestionSolver
from freebody.study.answering.crosscheck import as_parts
from freebody.study.answering.scope import for_all
from freebody.study.answering.simulated_numbers import number_with_changes
from freebody.study.phases.nodes import PhaseNode
from freebody.study.phases.phase import Phase
from freebody.study.phases.placed import Given
from freebody.study.phases.quantities import frictions
from freebody.study.phases.result import relations
from freebody.study.phases.tree import PhaseTree
from freebody.study.phases.words import action, happening, in_phase, label
from freebody.study.setup import N_DRAWS, Setup
from freebody.symbolic.conditions import Condition, require
from freebody.symbolic.state import SymbolicState

_ALIKE = 1e-6  # [SI] of a value by a formula and by a simulation
_OF_ALL = ("whole motion", "repeated motion")  # what is asked of all of a motion


class KeptMode(Given):
    """The mode of a phase, kept for good; its first draw has the model's own values where the motion begins in it."""

    is_mode = True

    def __init__(self, tree: PhaseTree, node: PhaseNode) -> None:
        self.phase: Phase = node.phase
        self.is_own = tree.system.has_values and 0 in node.sets
        system = self.phase.system
        friction = {push.load: Load() for push in frictions(system)}  # a load as others are, which stores nothing
        kept = replace(system, loads={**system.loads, **friction})
        super().__init__(kept, tree.sets.some(node.sets, N_DRAWS), self.phase.model)

    @property
    def has_values(self) -> bool:
        return self.is_own

    def reserves(self, state: SymbolicState) -> list[Condition]:
        return self._needs(state, "slips", ">=", lambda name: Message("{contact} does not slip", contact=name))

    def clearances(self, state: SymbolicState, relation: str) -> list[Condition]:
        return self._needs(state, "touches", relation, lambda name: Message("{contact} stays open", contact=name))

    def _needs(self, state: SymbolicState, kind: str, relation: str, what: Callable[[str], Message]) -> list[Condition]:
        """What keeps events of a kind from happening; not of places on edges, which need not touch where they are
        level with what is beyond their ends. Raises CannotAnswer where that is so for no values of the parameters."""
        found: list[Condition] = []
        for watch in self.phase.watches:
            if watch.kind == kind and not watch.within:
                told = what(watch.connection)
                condition, possible = require(state.here(watch.element), relation, told)
                if not possible:
                    raise CannotAnswer(
                        Message("this needs that {what}, which is so for no values of the parameters", what=told)
                    )
                found += [] if condition is None else [condition]
        return found


def in_first_modes(tree: PhaseTree, question: Question) -> Answer:
    """The answer in the mode with which the motion begins at the model's own values; the others are further cases.
    Raises CannotAnswer where there is no such mode."""
    if not tree.roots:
        raise CannotAnswer(
            tree.reasons[0] if tree.reasons else Message("no state of the contacts is consistent with the start")
        )
    if question.quantity.scope in _OF_ALL:
        return _while_it_lasts(tree, question)
    wanted = question.quantity.wanted
    if wanted is not None and wanted.of.scope in _OF_ALL:
        _refuse_changes(tree)
    own, *rest = tree.roots
    answer = _in_mode(tree, own, question)
    if not answer.is_answered:
        return answer
    others: list[tuple[PhaseNode, Answer]] = []
    for node in rest:
        with suppress(CannotAnswer):
            other = _in_mode(tree, node, question)
            if other.expression is not None and not _is_same(answer, other):
                others.append((node, other))
    notes = (*answer.notes, in_phase(own.phase))
    if not others or answer.expression is None:
        return replace(answer, notes=notes)
    cases = [_case(tree, node, other) for node, other in [(own, answer), *others]]
    return replace(answer, notes=notes, conditions=cases[0].conditions or (for_all(tree.system),), cases=tuple(cases))


def led_as_it_begins(tree: PhaseTree, question: Question) -> Answer | None:
    """What drives alone lead, in the mode with which it begins, where a simulation of all contacts has the same value
    at the file's numbers: what touches still touches then. None where something else tells it, or it does not."""
    if not tree.roots or not tree.system.has_values or tree.roots[0].phase.model.coordinates:
        return None
    own = tree.roots[0]
    answer = _in_mode(tree, own, question)
    if answer.expression is None or answer.value is None:
        return None
    with suppress(CannotAnswer):
        seen = number_with_changes(tree.system, question, is_single=tree.is_single)
        pairs = zip(as_parts(answer.value), as_parts(seen), strict=True) if seen is not None else ()
        if seen is not None and all(isclose(a, b, rel_tol=_ALIKE, abs_tol=_ALIKE) for a, b in pairs):
            told = Message("that the contacts stay as they are until then was seen with the given numbers")
            return replace(answer, notes=(*answer.notes, in_phase(own.phase), told))
    return None


def _while_it_lasts(tree: PhaseTree, question: Question) -> Answer:
    """In the first mode, where nothing ever ends it. Raises CannotAnswer where something does."""
    own = tree.roots[0]
    edges = [e for e in own.edges if 0 in e.sets or not tree.system.has_values]
    edge = min(edges, key=lambda e: e.first is not None, default=None)  # without numbers, where nothing ends it
    if edge is None:
        raise CannotAnswer(Message("it is not known what ends the first phase of the motion"))
    if edge.first is not None or edge.stops:
        what = edge.stops if edge.first is None else happening(edge.first.watch, None)
        raise CannotAnswer(
            Message("the motion changes its law on the way ({event}), so one law does not tell that", event=what)
        )
    lasting = replace(own, sets=edge.sets)
    answer = _in_mode(tree, lasting, question)
    if answer.expression is None:
        return answer
    begins = [r.text() for r in relations(tree, [*tree.assumed, *own.conditions, *edge.conditions])]
    kept = [c for c in answer.conditions if not c.startswith("for all ")]
    conditions = tuple(dict.fromkeys((*kept, *begins))) or (for_all(tree.system),)
    notes = [*answer.notes, in_phase(own.phase)]
    if not edge.is_proved:
        notes.append(Message("that nothing ends the first phase was seen at many parameter values; it is not proved"))
    return replace(answer, notes=tuple(notes), conditions=conditions)


def _refuse_changes(tree: PhaseTree) -> None:
    """What all of a motion has for which values of a parameter is told where one law holds for all of them."""
    for edge in (edge for root in tree.roots for edge in root.edges):
        if edge.first is not None or edge.stops:
            what = edge.stops if edge.first is None else happening(edge.first.watch, None)
            raise CannotAnswer(
                Message("the motion changes its law on the way ({event}), so one law does not tell that", event=what)
            )


def _in_mode(tree: PhaseTree, node: PhaseNode, question: Question) -> Answer:
    sliding = [label(name) for name, state in node.phase.mode.states.items() if state]
    if sliding and question.quantity.scope == "small motion":
        raise CannotAnswer(
            Message("{names} slides at the start: there is no small motion about it", names=", ".join(sliding))
        )
    setup: Setup = KeptMode(tree, node)
    return QuestionSolver(setup, question).answer()


def _is_same(one: Answer, other: Answer) -> bool:
    return one.expression == other.expression and one.conditions == other.conditions


def _case(tree: PhaseTree, node: PhaseNode, answer: Answer) -> AnswerCase:
    """What holds in a mode, where that is the one with which the motion begins."""
    begins = tuple(r.text() for r in relations(tree, [*tree.assumed, *node.conditions]))
    assert answer.expression is not None
    own = tuple(c for c in answer.conditions if not c.startswith("for all "))
    return AnswerCase(answer.expression, tuple(dict.fromkeys((*begins, *own))), action(node.phase))
