"""Rest where nothing touches and nothing rubs: what a parameter must be so that all forces are in balance."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import replace

from freebody.errors import CannotAnswer
from freebody.language.expression import ZERO
from freebody.questions.motion import OfMeasure
from freebody.questions.reading import Question
from freebody.questions.rest import RestLimit
from freebody.questions.turned_round import ValueFor
from freebody.study.friction.answers import prepared
from freebody.study.setup import Setup


def in_balance(setup: Setup, question: Question) -> Question | None:
    """The values of a parameter with which a system of one freedom stays at rest, as those for which its acceleration
    at the start is zero: of a place or a length there is no range between two ends. None where the ends of a range
    tell it."""
    q, system = question.quantity, setup.system
    if not isinstance(q, RestLimit) or q.which != "range" or len(setup.model.coordinates) != 1:
        return None
    if not system.names.lets_go_from_rest:
        return None
    with suppress(CannotAnswer):
        if prepared(system).parameter(q.parameter).is_linear:
            return None
    coordinate = setup.model.coordinates[0]
    measure, name = setup.model.measure_of(coordinate), coordinate.name
    if measure is None:
        return None
    balance = ValueFor(q.parameter, OfMeasure(measure, 2, name), ZERO, q.dimension, q.unit, f"acceleration of {name}")
    return replace(question, quantity=balance, at_start=True)
