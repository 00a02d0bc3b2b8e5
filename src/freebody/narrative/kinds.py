"""Which derivation a question has, by what it asks for."""

from __future__ import annotations

from freebody.model.friction_questions import RestQuantity
from freebody.model.question import Conserved, Equilibrium, Freedom, InstantCentre, Question, Small
from freebody.model.steady_questions import SteadyQuantity
from freebody.narrative import conserving, course, freedom, instant, phases, rest, small, spatial, steady
from freebody.narrative.context import Derive
from freebody.narrative.numeric import or_in_numbers
from freebody.narrative.settings import has_phases
from freebody.system.system import System


def derivation_of(system: System, question: Question) -> Derive:
    """The function that derives the answer to a question; without a formula, the equations that numbers solve."""
    return or_in_numbers(_by_kind(system, question))


def _by_kind(system: System, question: Question) -> Derive:
    q = question.quantity
    if isinstance(q, RestQuantity):
        return rest.derive
    if has_phases(system) and not isinstance(q, (Freedom, Conserved)):
        return phases.derive
    if question.transition is not None:
        return phases.derive
    if isinstance(q, Freedom):
        return freedom.derive
    if isinstance(q, Conserved):
        return conserving.derive
    if isinstance(q, (Small, Equilibrium)):
        return small.derive
    if isinstance(q, SteadyQuantity):
        return steady.derive
    if system.space and question.event is None:
        return spatial.derive
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
