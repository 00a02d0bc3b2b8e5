"""Of which dimension a value of a file is: by its unit, or by the parameters in it."""

from __future__ import annotations

import re
from typing import Any, cast

from freebody.errors import InputError
from freebody.language.expression import evaluate
from freebody.language.parser import parse
from freebody.language.units import Dimension, dimension_of, parse_quantity
from freebody.system.reading.written.form import Entry, Written


def dimension_said(w: Written, value: Any) -> Dimension | None:
    """The dimension of a scalar, a number without a unit being dimensionless; None where it is no quantity and no
    formula of parameters with units."""
    if isinstance(value, bool) or not isinstance(value, str | int | float):
        return None
    try:
        return parse_quantity(value).dimension
    except (InputError, TypeError, ValueError):
        pass
    given = w.data.get("parameters")
    parameters = cast("Entry", given) if isinstance(given, dict) else {}
    known: dict[str, Dimension] = {}
    for name, each in parameters.items():
        try:
            known[name] = parse_quantity(each).dimension
        except (InputError, TypeError, ValueError):
            continue
    try:
        return dimension_of(parse(str(value)), known)
    except (InputError, TypeError, ValueError, KeyError):
        return None


def value_said(w: Written, value: Any) -> float | None:
    """The number of a quantity, a parameter or a formula of parameters in SI units; None where the file gives none."""
    if isinstance(value, bool) or not isinstance(value, str | int | float):
        return None
    given = w.data.get("parameters")
    parameters = cast("Entry", given) if isinstance(given, dict) else {}
    if (size := None if value in parameters else _size(value)) is not None:
        return size
    known = {name: size for name, each in parameters.items() if (size := _size(each)) is not None}
    try:
        return float(evaluate(parse(str(value)), known))
    except (InputError, TypeError, ValueError, ArithmeticError):
        return None


def _size(said: Any) -> float | None:
    """The number of a quantity in SI units, also of one that is `{value: ...}`."""
    try:
        return float(parse_quantity(said["value"] if isinstance(said, dict) else said).value)
    except (InputError, TypeError, ValueError, KeyError):
        return None


_NUMBER = re.compile(r"[-+]?\d+(\.\d*)?")
_RPM, _NAMED = "rpm", ("parameters", "start", "measures", "questions")  # what holds names


def with_units_of_words(value: Any) -> Any:
    """`rpm: 120`, `sun_rpm: 120` with the unit that the word says, where it says none itself. Beside sections that hold
    names."""
    if isinstance(value, list):
        return [with_units_of_words(each) for each in cast("list[Any]", value)]
    if not isinstance(value, dict):
        return value
    read: Entry = {}
    for key, each in cast("Entry", value).items():
        is_rate = str(key).lower().split("_")[-1] == _RPM and not isinstance(each, bool | dict | list | None)
        is_bare = is_rate and _NUMBER.fullmatch(str(each).strip()) is not None
        read[key] = f"{each} {_RPM}" if is_bare else each if key in _NAMED else with_units_of_words(each)
    return read


def is_one_number(w: Written, values: list[Any]) -> bool:
    """Whether values are all the same: as they are written, or as numbers."""
    if len({*map(str, values)}) <= 1:
        return True
    sizes = [value_said(w, value) for value in values]
    return None not in sizes and len({*sizes}) == 1
