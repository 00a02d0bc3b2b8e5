"""The initial conditions that a derivation uses, told before it does: x = 0 and x' = v0 at the start."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from freebody.language.expression import ZERO, Expr, Symbol, evaluate, free_symbols
from freebody.language.notation import compared
from freebody.language.raising import raised
from freebody.language.sentences import Argument, Sentence
from freebody.language.units import DIMENSIONLESS, TIME, Dimension
from freebody.narrative.context import Context
from freebody.narrative.lines.script import Script
from freebody.questions.motion import rates_of
from freebody.symbolic.tidy import tidy


def tell_start(context: Context, script: Script, generators: Collection[int]) -> bool:
    """The values at the start of the coordinates and speeds among some generators, as far as the parameters give them;
    whether there are any. Nothing after a blow at the start, which tells its own."""
    if context.setup.system.is_struck:
        return False
    values = tuple(_equations(context, generators))
    if values:
        script.say("course.start_values", values=values)
    return bool(values)


def _equations(context: Context, generators: Collection[int]) -> Iterator[Argument]:
    start, system = context.setup.start, context.setup.system
    for c in context.setup.model.coordinates:
        measure = context.glossary.measures.get(c.name)
        for order, index in enumerate((c.index, c.speed)):
            if measure is None or index not in generators or index not in start.values:
                continue
            value = tidy(start.of(index))
            if not free_symbols(value) <= system.parameters.keys():  # a start value without a formula
                continue
            unit = "" if free_symbols(value) or value == ZERO else _unit(measure.dimension, order)
            yield _equation(rates_of(c.name, order) if order else Symbol(c.name), value, unit)


def _unit(dimension: Dimension, order: int) -> str:
    if dimension == DIMENSIONLESS:
        return "rad/s" if order else ""
    return raised(str(dimension / TIME**order))


def _equation(name: Expr, value: Expr, unit: str) -> Argument:
    if not unit:
        return compared(name, "=", value)
    return Sentence(
        "course.start_value", {"name": name, "value": f"@{float(evaluate(value, {})):.6g}", "unit": f"@{unit}"}
    )
