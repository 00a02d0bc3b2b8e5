"""Which derivation a question has, by what it asks for."""

from __future__ import annotations

from importlib import import_module
from typing import cast

from freebody.narrative.contact.settings import has_phases
from freebody.narrative.context import Derive
from freebody.narrative.questions.numeric import or_in_numbers
from freebody.questions.base import Scope
from freebody.questions.clock import Clock
from freebody.questions.event import Anywhere
from freebody.questions.reading import Question
from freebody.questions.reading_when import is_of_start
from freebody.system.system import System


def derivation_of(system: System, question: Question) -> Derive:
    """The function that derives the answer to a question; without a formula, the equations that numbers solve."""
    module = import_module(f"freebody.narrative.{_place(system, question)}")  # each kind needs libraries of its own
    return or_in_numbers(cast("Derive", module.derive))


_PLACES: dict[Scope, str] = {
    "structure": "questions.freedom",
    "every motion": "questions.conserving",
    "whole motion": "questions.extent",
    "repeated motion": "questions.period",
    "small motion": "questions.small",
    "steady motion": "steady.steady",
    "linkage": "questions.linkage",
    "sections": "questions.along_rods",
}


def _place(system: System, question: Question) -> str:
    """The module that derives the answer, by what part of mechanics the question belongs to."""
    scope = question.quantity.scope
    if isinstance(question.event, Anywhere):
        return "questions.of_place"
    if question.quantity.wanted is not None:
        return "questions.turned_round"
    if question.quantity.jump is not None:
        return "questions.jump"
    if is_of_start(question.quantity) and (system.is_struck or not has_phases(system)):
        return "questions.blow"
    if question.quantity.derived_by:
        return f"questions.{question.quantity.derived_by}"
    if scope == "rest":
        return "contact.rest"
    quantity = question.quantity
    in_phases = has_phases(system) and quantity.is_of_state and not quantity.is_of_parameters
    if question.transition is not None or in_phases:
        return "contact.phases"
    if scope in _PLACES:
        return _PLACES[scope]
    if isinstance(question.event, Clock):
        return "questions.clock"
    return "questions.instant" if question.event is None else "questions.course"
