"""Which derivation a question has, by what it asks for."""

from __future__ import annotations

from freebody.model.friction_questions import RestQuantity
from freebody.model.question import Conserved, Equilibrium, Freedom, InstantCentre, Question, Small
from freebody.model.steady_questions import SteadyQuantity
from freebody.narrative import course, instant
from freebody.narrative.context import Derive
from freebody.system.system import System


def derivation_of(system: System, question: Question) -> Derive:
    """The function that derives the answer to a question."""
    q = question.quantity
    if question.event is not None:
        return course.derive
    return instant.derive


__all__ = [
    "Conserved",
    "Equilibrium",
    "Freedom",
    "InstantCentre",
    "RestQuantity",
    "Small",
    "SteadyQuantity",
    "derivation_of",
]
