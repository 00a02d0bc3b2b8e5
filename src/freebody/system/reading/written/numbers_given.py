"""Numbers that a figure in a few lines gives by words: what each of them is, and as parameters, so that answers are
formulas."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeAlias, cast

from freebody.language.folded import folded
from freebody.language.sentences import Message, in_turn
from freebody.language.units import Dimension
from freebody.system.reading.written.dimensions import dimension_said
from freebody.system.reading.written.form import Entry, Written

Words: TypeAlias = "dict[str, tuple[tuple[str, ...], Dimension]]"  # by symbols: words, and the dimension of the number

_GRAVITY, _WEIGHTS = "gravity", ("gravity", "g", "schwerkraft", "weight")


def refuse_strange(
    w: Written, place: tuple[Any, ...], what: Message, given: Entry, said: Mapping[str, str], known: tuple[str, ...]
) -> None:
    """Raises ModelError where a figure says what is not among the numbers that it has. said: the keys of those."""
    if strange := [str(key) for key in given if key not in said.values()]:
        told = Message("{what} has no {key}; it has {known}", what=what, key=in_turn(strange), known=in_turn(known))
        if strange[0] in known:
            value = str(given[strange[0]])
            told = Message("{key}: {value} has not the unit of {key}", key=strange[0], value=value)
        w.refuse(told, *place, strange[0])


def weigh(w: Written) -> None:
    """Weight, where a file says none of what moves by its weight alone: `gravity: 0` says that there is none."""
    loads = w.data.get("loads") or {}
    if any(folded(str(key)) in _WEIGHTS for key in w.data) or _GRAVITY in str(loads):
        return
    parameters = cast("Entry", w.data.get("parameters") or {})
    w.data["parameters"] = {"g": "9.81 m/s^2", **parameters}
    w.data["loads"] = {**cast("Entry", loads), "weight": {_GRAVITY: "g"}}
    if "g" not in parameters:
        w.assumed.append(Message("gravity acts downwards, g = 9.81 m/s^2"))


def quantities(w: Written, given: Entry, words: dict[str, tuple[tuple[str, ...], Dimension]]) -> dict[str, str] | None:
    """By the symbols: the keys that say a quantity of that dimension; None where two say one."""
    found: dict[str, str] = {}
    for key, value in given.items():
        for symbol, (called, dimension) in words.items():
            is_name = isinstance(value, str) and value.isidentifier()  # a parameter whose unit is that of its use
            known = dimension_said(w, value)
            if folded(str(key)) in called and (known == dimension or (known is None and is_name)):
                if symbol in found:
                    return None
                found[symbol] = key
    return found


def as_parameters(w: Written, said: dict[str, str], given: Entry, place: tuple[str, ...]) -> dict[str, Any]:
    """By the symbols what stands in formulas: a parameter that has the number, or what is written there."""
    there = cast("Entry", w.data.get("parameters") or {})
    own = {symbol: given[key] for symbol, key in said.items() if symbol not in there and _is_number(given[key])}
    w.data["parameters"] = {**there, **own}
    w.moved |= {("parameters", symbol): (*place, said[symbol]) for symbol in own}
    return {symbol: symbol if symbol in own else given[key] for symbol, key in said.items()}


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) or str(value).strip()[:1] in "0123456789."
