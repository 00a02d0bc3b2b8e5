"""The initial conditions that a derivation uses, told before it does: x = 0 and x' = v0 at the start."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from typing import cast

from freebody.language.expression import Expr, free_symbols
from freebody.language.notation import compared
from freebody.language.sentences import Argument, Sentence
from freebody.narrative.bounds import number_with_unit
from freebody.narrative.context import Context
from freebody.narrative.lines.script import Script
from freebody.questions.motion import rates_of
from freebody.symbolic.tidy import tidy


def tell_start(context: Context, script: Script, generators: Collection[int]) -> bool:
    """The values at the start of the coordinates and speeds among some generators, as far as the parameters give them;
    whether there are any. After a blow at the start these are the places, which it does not change."""
    values = tuple(_equations(context, generators))
    if values:
        script.say("course.start_values", values=values)
    return bool(values)


def _equations(context: Context, generators: Collection[int]) -> Iterator[Argument]:
    start, system = context.setup.start, context.setup.system
    orders = 1 if system.is_struck else 2
    for c in context.setup.model.coordinates:
        measure = context.glossary.measures.get(c.name)
        for order, index in enumerate((c.index, c.speed)[:orders]):
            if measure is None or index not in generators or index not in start.values:
                continue
            value = tidy(start.of(index))
            if not free_symbols(value) <= system.parameters.keys():  # a start value without a formula
                continue
            yield _equation(rates_of(c.name, order), number_with_unit(value, measure.dimension, order))


def _equation(name: Expr, value: Argument) -> Argument:
    if isinstance(value, Sentence):
        return Sentence("course.start_value", {"name": name, "value": value})
    return compared(name, "=", cast("Expr", value))
