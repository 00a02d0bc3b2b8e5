"""Of which dimension a value of a file is: by its unit, or by the parameters in it."""

from __future__ import annotations

from typing import Any, cast

from freebody.errors import InputError
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
    """The number of a quantity or of a parameter in SI units, with its sign; None where the file gives none."""
    if isinstance(value, bool) or not isinstance(value, str | int | float):
        return None
    given = w.data.get("parameters")
    parameters = cast("Entry", given) if isinstance(given, dict) else {}
    sign, name = (-1.0, str(value)[1:].strip()) if str(value).startswith("-") else (1.0, str(value))
    said: Any = parameters.get(name, name)
    try:
        return sign * float(parse_quantity(said["value"] if isinstance(said, dict) else said).value)
    except (InputError, TypeError, ValueError, KeyError):
        return None
