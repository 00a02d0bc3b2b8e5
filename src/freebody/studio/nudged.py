"""The system of a text that differs in numbers of its start from one that was read before, as it does while a slider is
moved or a body is dragged: nothing else is read again.

What else is read hangs on a start by whether it is zero alone (what is "let go", the natural length of an elastic
string), so numbers that are zero, or become it, are read with the rest.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any, cast

from freebody.language.document import Document
from freebody.language.expression import ZERO, Expr, Number, ProductOf, Symbol
from freebody.language.units import TIME
from freebody.system.reading.start import rate_of
from freebody.system.system import System


def nudged(before: System, document: Document) -> System | None:
    """None where more differs, or a number of the start cannot be read. Questions keep the meaning that they had."""
    was, now = before.document.data, document.data
    old, new = was.pop("start", None), now.pop("start", None)
    if was != now or not isinstance(old, dict) or not isinstance(new, dict):
        return None
    old, new = cast("dict[str, Any]", old), cast("dict[str, Any]", new)
    if old.keys() != new.keys():
        return None
    start, rates = dict(before.start), dict(before.start_rates)
    for key in (key for key in new if new[key] != old[key]):
        name = rate_of(key, before.measures)
        into = start if key in start else rates
        read = _read(before, name, new[key], is_rate=into is rates)
        if name not in into or read is None or not (_is_number(into[name]) and _is_number(read)):
            return None
        into[name] = read
    return replace(before, start=start, start_rates=rates, document=document)


def _read(system: System, name: str, value: Any, *, is_rate: bool) -> Expr | None:
    """A value of the start as the reader understands it, None where it does not."""
    if name not in system.measures:
        return None
    names, measure = system.names.for_questions(), system.measures[name]
    if measure.is_angle and not is_rate:
        read = names.angle(value, "start", name)
    else:
        read = names.formula(value, measure.dimension / TIME if is_rate else measure.dimension, "start", name)
    return None if names.problems else read


def _is_number(expr: Expr) -> bool:
    """A number that is not zero, as 2 or 30 pi/180."""
    parts = expr.factors if isinstance(expr, ProductOf) else (expr,)
    return expr != ZERO and all(isinstance(part, Number) or part == Symbol("pi") for part in parts)
