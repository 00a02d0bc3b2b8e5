"""Rest where nothing touches and nothing rubs: what a parameter must be so that all forces are in balance."""

from __future__ import annotations

from dataclasses import replace

from freebody.language.expression import ZERO
from freebody.questions.motion import OfMeasure
from freebody.questions.reading import Question
from freebody.questions.rest import RestLimit
from freebody.questions.turned_round import ValueFor
from freebody.study.friction.touching import TouchingAtRest
from freebody.study.setup import Setup


def in_balance(touching: TouchingAtRest, setup: Setup, question: Question, q: RestLimit) -> Question | None:
    """The values of a parameter with which a system of one freedom stays at rest, as those for which its acceleration
    at the start is zero: of a place or a length there is no range between two ends. None where something touches or
    rubs, or there are other freedoms."""
    if q.which != "range" or touching.dry_friction or touching.bounds or len(setup.model.coordinates) != 1:
        return None
    coordinate = setup.model.coordinates[0]
    measure, name = setup.model.measure_of(coordinate), coordinate.name
    if measure is None:
        return None
    balance = ValueFor(q.parameter, OfMeasure(measure, 2, name), ZERO, q.dimension, q.unit, f"acceleration of {name}")
    return replace(question, quantity=balance, at_start=True)
