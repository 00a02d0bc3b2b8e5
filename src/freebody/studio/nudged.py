"""The system of a text that differs in numbers of its parameters or of its start from one that was read before, as it
does while a slider is moved or a body is dragged: nothing else is read again.

A parameter is a symbol in all that is read, unless the reader asks for its number: whether a body fits into a guide,
on which side of a wheel a string runs. The names of a model keep what was asked for (`hangs_on`); with another number
of one of these the text is read as a whole. Of a start what else is read hangs by whether it is zero alone (what is
"let go", the natural length of an elastic string), so numbers that are zero, or become it, are read with the rest.
"""

from __future__ import annotations

from copy import copy
from dataclasses import replace
from typing import Any, cast

from freebody.language.document import Document
from freebody.language.expression import ZERO, Expr, Number, ProductOf, Symbol
from freebody.language.units import TIME
from freebody.model.elements import Parameter
from freebody.model.names import Names
from freebody.system.reading.parameters import read_parameter
from freebody.system.reading.start import rate_of
from freebody.system.system import System

_NUDGED = ("parameters", "start")
# what a system finds out about itself from its bodies, connections and loads alone, whatever the numbers are
_LASTING = (
    *("_moving", "material", "all_moving", "all_measures", "all_loads"),
    *("bounds", "dry_friction", "_rows", "borders", "glyphs", "_sites", "groups", "touched"),
)


def nudged(before: System, document: Document) -> System | None:
    """None where more differs, a number cannot be read, or what else is read hangs on it. Questions keep the meaning
    that they had."""
    was, now = before.document.data, document.data
    if {key: was[key] for key in was if key not in _NUDGED} != {key: now[key] for key in now if key not in _NUDGED}:
        return None
    parameters, start = (_changes(was.get(key), now.get(key)) for key in _NUDGED)
    if parameters is None or start is None:
        return None
    names = before.names.for_questions()
    found = {name: _parameter(names, before.parameters.get(name), value) for name, value in parameters.items()}
    read = {key: parameter for key, parameter in found.items() if parameter is not None}
    if len(read) < len(found) or _asked_for(before) & read.keys():
        return None
    starts = _starts(before, names, start)
    if starts is None:
        return None
    given = {**before.parameters, **read}
    own = copy(before.names)
    own.parameters = given
    system = replace(before, parameters=given, start=starts[0], start_rates=starts[1], document=document, names=own)
    vars(system).update({name: vars(before)[name] for name in _LASTING if name in vars(before)})
    return system


def _changes(old: Any, new: Any) -> dict[str, Any] | None:
    """The entries of a section that have another value; None where it has other entries."""
    if old == new:
        return {}
    if not isinstance(old, dict) or not isinstance(new, dict):
        return None
    old, new = cast("dict[str, Any]", old), cast("dict[str, Any]", new)
    return None if old.keys() != new.keys() else {key: new[key] for key in new if new[key] != old[key]}


def _parameter(names: Names, old: Parameter | None, value: Any) -> Parameter | None:
    """A parameter as the reader understands it; None where it does not, or where more than its number is another."""
    if old is None or old.form is not None or (isinstance(value, dict) and "function" in value):
        return None
    new = read_parameter(names, old.name, value)
    is_number = not names.problems and old.value is not None and new.value is not None
    return new if is_number and replace(new, value=old.value) == old else None


def _asked_for(system: System) -> set[str]:
    """Of which parameters the number was asked for, by what is found once it is wanted as well."""
    _ = system.bounds, system.glyphs
    return system.names.hangs_on


def _starts(before: System, names: Names, changes: dict[str, Any]) -> tuple[dict[str, Expr], dict[str, Expr]] | None:
    """The start of measures and of their rates with changed entries; None where one is no other number."""
    start, rates = dict(before.start), dict(before.start_rates)
    for key, value in changes.items():
        name = rate_of(key, before.measures)
        into = start if key in start else rates
        read = _read(before, names, name, value, is_rate=into is rates)
        if name not in into or read is None or not (_is_number(into[name]) and _is_number(read)):
            return None
        into[name] = read
    return start, rates


def _read(system: System, names: Names, name: str, value: Any, *, is_rate: bool) -> Expr | None:
    """A value of the start as the reader understands it, None where it does not."""
    if name not in system.measures:
        return None
    measure = system.measures[name]
    if measure.is_angle and not is_rate:
        read = names.angle(value, "start", name)
    else:
        read = names.formula(value, measure.dimension / TIME if is_rate else measure.dimension, "start", name)
    return None if names.problems else read


def _is_number(expr: Expr) -> bool:
    """A number that is not zero, as 2 or 30 pi/180."""
    parts = expr.factors if isinstance(expr, ProductOf) else (expr,)
    return expr != ZERO and all(isinstance(part, Number) or part == Symbol("pi") for part in parts)
