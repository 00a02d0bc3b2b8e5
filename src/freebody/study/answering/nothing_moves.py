"""Questions about a motion, where nothing can move: the greatest and the least value of a quantity are what it is."""

from __future__ import annotations

from dataclasses import replace

from freebody.questions.reading import Question
from freebody.study.setup import Setup
from freebody.system.modes import depends_on_time


def of_what_stays(setup: Setup, question: Question) -> Question:
    """A question about an extreme as one about the quantity itself, where that is the same all the time: in a frame, a
    truss, a beam whose loads do not change."""
    plain = question.quantity.of_what_stays
    if plain is None or question.event is not None or question.transition is not None:
        return question
    system = setup.system
    if system.bounds or system.dry_friction or depends_on_time(system) or setup.model.coordinates:
        return question
    return replace(question, quantity=plain)
