"""The section `parameters`: numbers with units, symbols without a value, functions of time."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Collection, Mapping
from typing import Any, cast

from freebody.errors import InputError, NoQuantity, UnitError
from freebody.language.expression import Expr, free_symbols
from freebody.language.parser import parse
from freebody.language.sentences import Message, in_turn
from freebody.language.units import (
    ANGULAR_VELOCITY,
    DIMENSIONLESS,
    FORCE,
    IMPULSE,
    INERTIA,
    MASS,
    TIME,
    TORQUE,
    VELOCITY,
    Quantity,
    dimension_of,
    parse_quantity,
    parse_unit,
    quantities_within,
)
from freebody.model.elements import Parameter, Sign
from freebody.model.formulas import no_parameter_in
from freebody.model.names import Names
from freebody.model.noting import did_you_mean
from freebody.system.reading.sections import OF_PARAMETERS
from freebody.system.reading.source import Source, known_keys

_RIGHT_ANGLE = math.pi / 2
_VALUE = re.compile(r"\s*[+-]?[\d.]+([eE][+-]?\d+)?\s+[^\W\d]")  # with its unit, behind a space
_NEVER_NEGATIVE = {MASS: Message("a mass"), INERTIA: Message("a moment of inertia")}
_WORD = re.compile(r"[^\W\d]\w*")


def read_parameters(source: Source) -> None:
    names = source.names
    functions: dict[str, dict[str, Any]] = {}
    shorthands: dict[str, str] = {}
    for name, value in source.named("parameters").items():
        with names.at("parameters", name):
            if isinstance(value, dict) and "function" in value:
                functions[name] = cast("dict[str, Any]", value)
            else:
                formula = _of_others(value, source.mapping("parameters").keys() - {name})
                if formula is None:
                    names.parameters[name] = read_parameter(names, name, value)
                else:
                    shorthands[name] = formula
    _read_shorthands(names, shorthands)
    for name, entry in functions.items():
        with names.at("parameters", name):
            names.parameters[name] = _function(names, name, entry)


def _function(names: Names, name: str, entry: dict[str, Any]) -> Parameter:
    """`x0: {function: v*t, unit: m}`: a function of time. Formulas keep it general; numbers need its form."""
    known_keys(names, entry, ("function", "unit", "about"), Message("a function of time"))
    unit = str(entry.get("unit") or "")
    try:
        quantity = parse_unit(unit) if unit else None
    except InputError as error:
        names.problem(str(error), "unit")
        names.broken.add(name)
        quantity = None
    dimension = DIMENSIONLESS if quantity is None else quantity.dimension
    form = names.formula(entry["function"], dimension, "function", extra={"t": TIME})
    used = sorted(p for p in free_symbols(form) if p in names.parameters and names.parameters[p].form)
    if used:
        names.problem(
            Message("{other} is a function of time itself; write {name} in t and parameters", other=used[0], name=name)
        )
    is_angle = quantity is not None and quantity.is_angle
    return Parameter(name, dimension, None, "any", unit=unit, is_angle=is_angle, form=form)


def _read_shorthands(names: Names, written: Mapping[str, str]) -> None:
    """`R: 2*r`: short for a formula of other parameters, which stands wherever R does."""
    waiting = dict(written)
    while waiting:
        ready = [name for name in waiting if not _used_in(waiting[name]) & waiting.keys()]
        if not ready:
            name = min(waiting)
            with names.at("parameters", name):
                own = [each for each in waiting if each in _used_in(waiting[each])]
                told = Message(
                    "{name} is given by itself ({formula}); give it a number, as {name}: 1 m, or call one of the two "
                    "otherwise",
                    name=own[0] if own else name,
                    formula=waiting[own[0] if own else name],
                )
                if not own:
                    each = in_turn(list(waiting))
                    told = Message("{names} are formulas of each other; give a number for one", names=each)
                names.problem(told)
            names.broken |= waiting.keys()
            return
        for name in ready:
            with names.at("parameters", name):
                _read_shorthand(names, name, waiting.pop(name))


def _read_shorthand(names: Names, name: str, formula: str) -> None:
    if _used_in(formula) & names.broken:
        names.broken.add(name)  # told where that stands
        return
    _named, quantities = quantities_within(formula, names.parameters)
    try:
        if quantities:  # as a bare number it would lose its unit
            names.problem(Message("in '{text}' every value with a unit needs a name: a parameter", text=formula))
        else:
            short = names.parsed(formula)
            if unknown := sorted(free_symbols(short) - names.parameters.keys() - {"pi"}):
                names.problem(no_parameter_in(unknown[0], formula, did_you_mean(unknown[0], names.parameters)))
                names.broken.add(name)
                return
            dimension_of(short, names.dimensions())
            names.shorthands[name] = short
            return
    except (InputError, ZeroDivisionError) as error:
        names.problem(Message("in '{text}': {error}", text=formula, error=error))
    names.broken.add(name)


def _used_in(formula: str) -> set[str]:
    return set(_WORD.findall(formula))


def _of_others(value: Any, others: Collection[str]) -> str | None:
    """A formula of other parameters; None where it is none. `R: m` is a symbol with a unit, whatever else is called
    m."""
    given = cast("dict[str, Any]", value).get("value") if isinstance(value, dict) else value
    if not isinstance(given, str) or _is_read(parse_unit, given) or _is_read(parse_quantity, given):
        return None
    named, quantities = quantities_within(given, others)
    used = free_symbols(parse(named)) - quantities.keys() - {"pi"} if _is_read(parse, named) else set[str]()
    if not used <= set(others) and (_VALUE.match(given) or not any(sign in given for sign in "*(")):
        return None  # a unit that is not known: 5 Ns/m
    return given if used else None


def _is_read(read: Callable[[str], object], text: str) -> bool:
    try:
        read(text)
    except (InputError, ZeroDivisionError):
        return False
    return True


def read_parameter(names: Names, name: str, value: Any) -> Parameter:
    sign: Sign = "positive"
    unit: str | None = None
    given = cast("dict[str, Any]", value) if isinstance(value, dict) else {}
    if isinstance(value, dict):
        entry = given
        known_keys(names, entry, OF_PARAMETERS, Message("a parameter"))
        if entry.get("sign", "positive") not in ("positive", "nonnegative", "any"):
            names.problem(
                Message("sign is positive, nonnegative or any, not {value}", value=repr(entry["sign"])), "sign"
            )
        else:
            sign = entry.get("sign", "positive")
        unit, value = entry.get("unit"), entry.get("value")
    try:
        if value is None:
            used = None if unit else names.units_of_use.get(name)
            dimension = used or (parse_unit(unit).dimension if unit else DIMENSIONLESS)
            return Parameter(name, dimension, None, sign, unit=unit or str(used or ""))
        text = f"{value} {unit}" if unit else value
        quantity = parse_quantity(text)
    except (InputError, TypeError) as error:
        return _without_number(names, name, value, sign, error)
    if sign == "positive" and quantity.value < 0 and "sign" not in given and _has_two_senses(quantity):
        sign = "any"
        told = Message("{name} = {value} is negative, so that formulas let it have either sign", name=name, value=value)
        names.assumptions.append(told)
    if sign == "positive" and quantity.value <= 0:
        told = Message(
            "{name} = {value} is not positive; parameters are positive unless the model says otherwise: {example}",
            name=name,
            value=value,
            example=f"{name}: {{value: {value}, sign: any}}",
        )
        if quantity.value < 0 and quantity.dimension in _NEVER_NEGATIVE:
            told = Message(
                "{what} is never negative, {name} = {value} is",
                what=_NEVER_NEGATIVE[quantity.dimension],
                name=name,
                value=value,
            )
        names.problem(told)
    if sign == "nonnegative" and quantity.value < 0:
        names.problem(
            Message("{name} = {value} is negative, but its sign is given as nonnegative", name=name, value=value)
        )
    acute = quantity.is_angle and sign == "positive" and 0 < quantity.value < _RIGHT_ANGLE
    shown = str(text).split(maxsplit=1)[1] if " " in str(text).strip() else ""
    number = quantity.value if sign == "any" else abs(quantity.value)  # a wrong sign is told here, and nowhere else
    return Parameter(name, quantity.dimension, number, sign, acute, shown, quantity.is_angle)


def _has_two_senses(quantity: Quantity) -> bool:
    """Whether it is of a kind whose sign says which way: a speed, a force, an angle; a negative mass is a slip."""
    return quantity.is_angle or quantity.dimension in (VELOCITY, ANGULAR_VELOCITY, FORCE, TORQUE, IMPULSE)


def _without_number(names: Names, name: str, value: Any, sign: Sign, error: Exception) -> Parameter:
    """`m: kg` declares a symbol with a unit and no value."""
    if isinstance(value, str):
        try:
            unit = parse_unit(value)
        except InputError:
            pass
        else:
            return Parameter(
                name,
                unit.dimension,
                None,
                sign,
                unit.is_angle and sign == "positive",
                value,
                unit.is_angle,
            )
    if isinstance(error, UnitError) and not isinstance(error, NoQuantity):  # which says what is wrong with the unit
        names.problem(str(error))
        names.broken.add(name)
        return Parameter(name, DIMENSIONLESS, None, sign)
    names.problem(
        Message(
            "{error}. Write for example {name}: 3 kg, {name}: 0.5, or {name}: kg for a symbol", error=error, name=name
        )
    )
    names.broken.add(name)
    return Parameter(name, DIMENSIONLESS, None, sign)


def forms(names: Names) -> dict[str, Expr]:
    """What functions of time are, by name."""
    return {p.name: p.form for p in names.parameters.values() if p.form is not None}
