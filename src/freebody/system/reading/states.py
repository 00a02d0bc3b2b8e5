"""The section `states`: `error: phi - phi_d`, a state by its rate, in measures, their rates, other states and time."""

from __future__ import annotations

from collections.abc import Mapping

from freebody.errors import ExpressionError, UnitError
from freebody.language.expression import ZERO, free_symbols, replace_rates, substitute
from freebody.language.parser import parse
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, TIME, Dimension, dimension_of
from freebody.model.names import Names
from freebody.model.states import ControllerState, in_states
from freebody.system.reading.source import Source


def read_states(source: Source) -> None:
    """Reads the states into the names of the model, each with what carries it."""
    names = source.names
    entries = {name: value for name, value in source.named("states").items() if _is_free(names, name)}
    left = list(entries)
    while left:  # in whatever order they stand
        told = {name: _rate_dimension(names, entries[name], left) for name in left}
        known = [name for name in left if told[name] is not None] or left
        for name in known:
            names.states[name] = ControllerState(name, (told[name] or DIMENSIONLESS) * TIME, ZERO, names.origin)
        left = [name for name in left if name not in known]
    for name, value in entries.items():
        known = {n: m.dimension for n, m in names.measures.items()} | {n: s.dimension for n, s in names.states.items()}
        state = names.states[name]
        with names.at("states"):
            rate = names.formula(value, state.dimension / TIME, name, extra={"t": TIME, **known})
        rates = free_symbols(replace_rates(rate, dict.fromkeys(names.states, ZERO))) ^ free_symbols(rate)
        if rates & names.states.keys():
            told = Message("the rate of a state is given in states, not in their rates: put in what they are")
            names.problem(told, "states", name)
            rate = ZERO
        law, used = in_states(rate, names.states, names.measures)
        names.states[name] = ControllerState(name, state.dimension, law, names.origin, used)


def _is_free(names: Names, name: str) -> bool:
    if name not in names.parameters and name not in names.measures:
        return True
    names.problem(Message("{name} is a parameter or a measure already; choose another name", name=name), "states", name)
    return False


def _rate_dimension(names: Names, value: object, own: list[str]) -> Dimension | None:
    """The dimension of a rate, whatever those states have that are not known yet: in (u - z)/T the first term tells.
    None where nothing is left without them."""
    known: Mapping[str, Dimension] = {
        **names.dimensions(in_time=True),
        **{n: m.dimension for n, m in names.measures.items()},
        **{n: s.dimension for n, s in names.states.items()},
        "t": TIME,
    }
    try:
        rest = substitute(parse(str(value)), dict.fromkeys(own, ZERO))
        return None if rest == ZERO else dimension_of(rest, known)
    except (ExpressionError, UnitError):  # told where it is read
        return DIMENSIONLESS
