"""What a sweep may vary: parameters, the start of named measures, of their rates and of states, and where a driver
holds a measure.

A start value becomes a parameter of its own, so that every study sees a system with parameters and nothing else. A
driven measure, which follows f(t), then follows f(t) - f(0) + its start value.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

from freebody.errors import InputError
from freebody.language.expression import Expr, Symbol, add, negate, number, substitute
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, TIME, Dimension, unit_of
from freebody.model.elements import ConstraintRow, Parameter
from freebody.model.noting import did_you_mean
from freebody.system.reading.start import rate_of
from freebody.system.system import System


@dataclass(frozen=True)
class Varied:
    """A name that varies. parameter: the one of the system that stands for it."""

    name: str
    parameter: str
    dimension: Dimension
    is_angle: bool

    @property
    def unit(self) -> str:
        return "rad" if self.is_angle else "1" if self.dimension == DIMENSIONLESS else unit_of(self.dimension)


def varied(system: System, names: Sequence[str]) -> tuple[System, list[Varied]]:
    """The system in which each name is a parameter, and these. Raises InputError naming all that cannot be varied."""
    found: list[Varied] = []
    wrong: list[str] = []
    for name in names:
        if names.count(name) > 1:
            raise InputError(Message("{name} is varied twice", name=name))
        measure = rate_of(name, system.measures)
        if name in system.parameters:
            parameter = system.parameters[name]
            if parameter.form is not None:
                told = Message("{name} is a function of time; vary the parameters in it", name=name)
                wrong.append(told)
                continue
            found.append(Varied(name, name, parameter.dimension, parameter.is_angle))
        elif name in system.measures or measure != name:
            system, one = _with_start(system, name, measure)
            found.append(one)
        elif name in system.states:
            system, one = _with_state(system, name)
            found.append(one)
        else:
            free = (p.name for p in system.parameters.values() if p.form is None)
            known = [*free, *system.measures, *system.states]
            told = Message(
                "{name} is no parameter, no named measure and no state of the model.{hint}",
                name=name,
                hint=did_you_mean(name, known),
            )
            wrong.append(told)
    if wrong:
        raise InputError("\n".join(wrong))
    return system, found


def _with_start(system: System, name: str, measure: str) -> tuple[System, Varied]:
    """The system whose start has a parameter for a measure, or for its rate where the name is that of a rate."""
    of = system.measures[measure]
    is_rate = name != measure
    dimension = of.dimension / TIME if is_rate else of.dimension
    symbol = _free(f"{measure}_rate_0" if is_rate else f"{measure}_0", system)
    given = (system.start_rates if is_rate else system.start).get(measure)
    parameter = Parameter(symbol, dimension, _number(system, given), "any", is_angle=of.is_angle and not is_rate)
    parameters = {**system.parameters, symbol: parameter}
    one = Varied(name, symbol, dimension, parameter.is_angle)
    if is_rate:
        rates = {**system.start_rates, measure: Symbol(symbol)}
        return replace(system, parameters=parameters, start_rates=rates), one
    rows = tuple(_shifted(row, Symbol(symbol)) if row.measure == of else row for row in system.constraint_rows)
    if rows != system.constraint_rows:
        return replace(system, parameters=parameters, constraint_rows=rows), one
    return replace(system, parameters=parameters, start={**system.start, measure: Symbol(symbol)}), one


def _with_state(system: System, name: str) -> tuple[System, Varied]:
    """The system in which the value of a state at the start is a parameter."""
    state, symbol = system.states[name], _free(f"{name}_0", system)
    parameter = Parameter(symbol, state.dimension, _number(system, state.start), "any")
    states = {**system.states, name: replace(state, start=Symbol(symbol))}
    changed = replace(system, parameters={**system.parameters, symbol: parameter}, states=states)
    return changed, Varied(name, symbol, state.dimension, is_angle=False)


def _shifted(row: ConstraintRow, start: Expr) -> ConstraintRow:
    """A row that follows its own function of time from another start value."""
    if row.target is None or not row.is_driven:
        return row
    first = substitute(row.target, {"t": number(0)})
    return replace(row, target=add(row.target, negate(first), start))


def _free(name: str, system: System) -> str:
    while name in system.parameters or name in system.measures:
        name += "_"
    return name


def _number(system: System, given: Expr | None) -> float | None:
    """The model's own start value, where it has one."""
    from freebody.errors import ExpressionError
    from freebody.language.expression import evaluate

    values = {p.name: p.value for p in system.parameters.values() if p.value is not None}
    try:
        return None if given is None else float(evaluate(given, values))
    except (ExpressionError, ArithmeticError, ValueError):
        return None


def with_values(system: System, values: Mapping[str, float]) -> System:
    """The same system with other numbers of its parameters, in SI; nothing is read again."""
    changed = {name: replace(system.parameters[name], value=x) for name, x in values.items()}
    return replace(system, parameters={**system.parameters, **changed})


def wide(system: System, extents: Iterable[tuple[str, float, float]]) -> System:
    """The system in which a parameter is taken to be an acute angle only where its values are: (name, least,
    greatest)."""
    from math import pi

    changed = {
        name: replace(system.parameters[name], acute=system.parameters[name].acute and low > 0.0 and high < pi / 2)
        for name, low, high in extents
    }
    return replace(system, parameters={**system.parameters, **changed})
