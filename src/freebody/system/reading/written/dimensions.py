"""Of which dimension a value of a file is: by its unit, or by the parameters in it."""

from __future__ import annotations

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


def is_one_number(w: Written, values: list[Any]) -> bool:
    """Whether values are all the same: as they are written, or as numbers."""
    if len({*map(str, values)}) <= 1:
        return True
    sizes = [value_said(w, value) for value in values]
    return None not in sizes and len({*sizes}) == 1
