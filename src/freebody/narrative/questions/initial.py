"""The initial conditions that a derivation uses, told before it does: x = 0 and x' = v0 at the start."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from typing import cast

from freebody.language.expression import Expr, free_symbols
from freebody.language.notation import compared
from freebody.language.sentences import Argument, Sentence
from freebody.narrative.bounds import number_with_unit
from freebody.narrative.context import Context
from freebody.narrative.lines.script import Script
from freebody.questions.motion import rates_of
from freebody.symbolic.tidy import tidy
from freebody.system.system import System

Value = tuple[str, int, Expr]  # of a coordinate, or of its rate (order 1), at the start


def tell_start(context: Context, script: Script, generators: Collection[int]) -> bool:
    """The values at the start of the coordinates and speeds among some generators, as far as the parameters give them;
    whether there are any. After a blow at the start these are the places, which it does not change."""
    setup = context.setup
    start, orders = setup.start, 1 if setup.system.is_struck else 2
    values = [
        (c.name, order, tidy(start.of(index)))
        for c in setup.model.coordinates
        for order, index in enumerate((c.index, c.speed)[:orders])
        if index in generators and index in start.values
    ]
    return tell_values(script, setup.system, values)


def tell_values(script: Script, system: System, values: Iterable[Value]) -> bool:
    """Some values at the start, as far as the parameters give them; whether there are any."""
    measures = script.glossary.measures
    told = tuple(
        _equation(rates_of(name, order), number_with_unit(value, measures[name].dimension, order))
        for name, order, value in values
        if name in measures and free_symbols(value) <= system.parameters.keys()  # else a start value without a formula
    )
    if told:
        script.say("course.start_values", values=told)
    return bool(told)


def _equation(name: Expr, value: Argument) -> Argument:
    if isinstance(value, Sentence):
        return Sentence("course.start_value", {"name": name, "value": value})
    return compared(name, "=", cast("Expr", value))
