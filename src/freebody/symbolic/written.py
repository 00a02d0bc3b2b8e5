"""Where what a file says has a value as it is written, before anything is cancelled.

A law k (u^2 - a^2)/(u - a) is k (u + a) in the field, and so in every answer; at u = a the file says nothing. What it
excludes is excluded from the answers that rest on it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from freebody.errors import CannotAnswer
from freebody.language.notation import to_text
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.measures.combination import Composed
from freebody.model.elements import NonholonomicForm
from freebody.symbolic.conditions import Condition, require
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.state import SymbolicState
from freebody.symbolic.tidy import tidy


class HasNoValue(CannotAnswer):
    """What the file says has no value in the state that is asked for."""


Need = tuple[Ratio, str, str]  # element, relation to 0, what has a value then


def has_values(state: SymbolicState, measures: Iterable[Measure], *, with_loads: bool) -> list[Condition]:
    """Conditions for the geometry, some measures and, where they matter, the laws of the loads. Raises HasNoValue
    where one of them never has a value in this state."""
    found: list[Condition] = []
    for x, relation, purpose in _needs(state.model, measures, with_loads):
        here = state.here(x)
        condition, possible = require(here, relation, purpose)
        if not possible:
            raise HasNoValue(
                Message(
                    "the {what} has no value in this state, as it is written: {x} is {y} there",
                    what=purpose,
                    x=to_text(tidy(x)),
                    y=to_text(tidy(here)),
                )
            )
        found += [] if condition is None else [condition]
    return found


def _needs(model: SymbolicModel, measures: Iterable[Measure], with_loads: bool) -> Iterator[Need]:
    for expr in model.lengths:
        for x, relation in model.geometry.needs(expr, {}):
            yield x, relation, Message("geometry")
    rows = [row.measure for row in model.system.constraint_rows if not isinstance(row.measure, NonholonomicForm)]
    for measure in (*rows, *measures):
        yield from _of_measure(model, measure)
    for push in model.system.all_loads if with_loads else ():
        for x, relation in model.loads.needs(push):
            yield x, relation, Message("law of {load}", load=push.load)
        if not isinstance(push.measure, NonholonomicForm):
            yield from _of_measure(model, push.measure)


def _of_measure(model: SymbolicModel, measure: Measure) -> Iterator[Need]:
    if not isinstance(measure, Composed):
        return
    values = {name: model.value_of(part) for name, part in measure.measures}
    for x, relation in model.geometry.needs(measure.expression, values):
        yield x, relation, Message("measure")
    for _name, part in measure.measures:
        yield from _of_measure(model, part)
