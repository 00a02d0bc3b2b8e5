"""What a user says in words: times, views, values of named measures at an instant, or functions of time."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from freebody.errors import InputError
from freebody.language.expression import Expr
from freebody.language.sentences import Message, lines
from freebody.language.units import ACCELERATION, DIMENSIONLESS, TIME, Dimension, parse_quantity
from freebody.measures.base import Measure
from freebody.model.names import Names
from freebody.model.noting import did_you_mean
from freebody.system.system import System


def each(given: str | Sequence[str]) -> tuple[str, ...]:
    """One text, or several."""
    return (given,) if isinstance(given, str) else tuple(given)


def named_measure(system: System, name: str) -> Measure:
    """Raises InputError if there is no such measure."""
    if name not in system.measures:
        raise InputError(
            Message("there is no measure {name}.{hint}", name=name, hint=did_you_mean(name, system.measures))
        )
    return system.measures[name]


def formula(system: System, name: str, value: str | float, *, in_time: bool = False) -> Expr:
    """An expression in the parameters (and time `t`), or a number with a unit, of a measure's dimension. Raises
    InputError saying what is wrong with it."""
    return formula_of(system, named_measure(system, name).dimension, name, value, in_time=in_time)


def formula_of(system: System, dimension: Dimension, name: str, value: str | float, *, in_time: bool = False) -> Expr:
    """The same of a dimension; name: what it is for. Raises InputError."""
    names = Names()
    names.parameters = dict(system.parameters)
    found = names.formula(value, dimension, name, extra={"t": TIME} if in_time else None)
    if names.problems:
        raise InputError(lines([problem.text(None) for problem in names.problems]))
    return found


def guess_of(text: str) -> Mapping[str, str]:
    """`theta = 20 deg, x = 0.1 m` as values by name. Raises InputError if it cannot be read."""
    found: dict[str, str] = {}
    for part in text.split(","):
        name, equals, value = (piece.strip() for piece in part.partition("="))
        if not equals or not name or not value:
            raise InputError(
                Message("a guess is written as name=value, e.g. theta=20 deg; found '{part}'", part=part.strip())
            )
        found[name] = value
    return found


def seconds(text: str) -> float:
    """A time [s]: a number, or a number with a unit. Raises InputError for anything else."""
    try:
        return float(text)
    except ValueError:
        quantity = parse_quantity(text)
    if quantity.dimension != TIME:
        raise InputError(Message("{text} is no time; write 10 or 200 ms", text=text))
    return float(quantity.value)


def turning_rate(text: str) -> float:
    """A rate of an angle [rad/s]: a number, or a number with a unit. Raises InputError for anything else."""
    try:
        return float(text)
    except ValueError:
        quantity = parse_quantity(text)
    if quantity.dimension != DIMENSIONLESS / TIME:
        raise InputError(Message("{text} is no rate of an angle; write 10 or 30 rad/s", text=text))
    return float(quantity.value)


def gravity(text: str) -> float:
    """An acceleration of gravity [m/s^2]: a number, or a number with a unit. Raises InputError for anything else."""
    try:
        return float(text)
    except ValueError:
        quantity = parse_quantity(text)
    if quantity.dimension != ACCELERATION:
        raise InputError(Message("{text} is no acceleration; write 10 or 9.81 m/s^2", text=text))
    return float(quantity.value)


def azimuth_and_elevation(text: str) -> tuple[float, float]:
    """From where one looks [deg], as `30,20`. Raises InputError if it cannot be read."""
    try:
        azimuth, elevation = map(float, text.split(","))
    except ValueError:
        raise InputError(Message("give azimuth and elevation in degrees, e.g. --view 30,20")) from None
    return azimuth, elevation


def ranges_of(texts: Iterable[str]) -> dict[str, str]:
    """`m1 = 1..3 kg:50` as the range of a name. Raises InputError if it cannot be read."""
    found: dict[str, str] = {}
    for text in texts:
        name, equals, value = (piece.strip() for piece in text.partition("="))
        if not equals or not name or not value:
            raise InputError(Message("'{text}': write name=range, as m1=1..3 kg:50", text=text))
        if name in found:
            raise InputError(Message("{name} is varied twice", name=name))
        found[name] = value
    return found
