"""Which derivation a question has, by what it asks for."""

from __future__ import annotations

from importlib import import_module
from typing import cast

from freebody.narrative.contact.settings import has_phases
from freebody.narrative.context import Derive
from freebody.narrative.questions.numeric import or_in_numbers
from freebody.questions.conservation import Conserved
from freebody.questions.freedom import Freedom
from freebody.questions.reading import Question
from freebody.questions.rest import AtRest
from freebody.questions.small_motion import Equilibrium, Small
from freebody.questions.steady import Steady
from freebody.system.system import System


def derivation_of(system: System, question: Question) -> Derive:
    """The function that derives the answer to a question; without a formula, the equations that numbers solve."""
    module = import_module(f"freebody.narrative.{_place(system, question)}")  # each kind needs libraries of its own
    return or_in_numbers(cast("Derive", module.derive))


def _place(system: System, question: Question) -> str:
    """The module that derives a kind of question."""
    q = question.quantity
    if isinstance(q, AtRest):
        return "contact.rest"
    if question.transition is not None or (has_phases(system) and not isinstance(q, (Freedom, Conserved))):
        return "contact.phases"
    if isinstance(q, Freedom):
        return "questions.freedom"
    if isinstance(q, Conserved):
        return "questions.conserving"
    if isinstance(q, (Small, Equilibrium)):
        return "questions.small"
    if isinstance(q, Steady):
        return "steady.steady"
    if question.event is not None:
        return "questions.course"
    return "space.spatial" if system.space else "questions.instant"
