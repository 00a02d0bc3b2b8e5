"""Numbers that a figure in a few lines gives by words: what each of them is, and as parameters, so that answers are
formulas."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import Any, TypeAlias, cast

from freebody.errors import InputError
from freebody.language.expression import free_symbols
from freebody.language.folded import folded
from freebody.language.parser import parse
from freebody.language.sentences import Message, in_turn
from freebody.language.units import ANGULAR_VELOCITY, DIMENSIONLESS, Dimension, parse_quantity, unit_of
from freebody.model.formulas import unit_differs
from freebody.system.reading.written.dimensions import dimension_said, value_said
from freebody.system.reading.written.form import Entry, Written

Words: TypeAlias = "dict[str, tuple[tuple[str, ...], Dimension]]"  # by symbols: words, and the dimension of the number

_GRAVITY, _WEIGHTS = "gravity", ("gravity", "g", "schwerkraft", "weight")


def refuse_strange(
    w: Written, place: tuple[Any, ...], what: Message, given: Entry, said: Mapping[str, str], known: tuple[str, ...]
) -> None:
    """Raises ModelError where a figure says what is not among the numbers that it has. said: the keys of those."""
    if strange := [str(key) for key in given if key not in said.values()]:
        told = Message("{what} has no {key}; it has {known}", what=what, key=in_turn(strange), known=in_turn(known))
        w.refuse(told, *place, strange[0])


def says(given: Entry, words: tuple[str, ...]) -> bool:
    """Whether a figure says something of a number, in whatever unit."""
    return any(folded(str(key)) in words and not isinstance(each, dict | list) for key, each in given.items())


def refuse_misread(w: Written, place: tuple[Any, ...], given: Entry, words: Words) -> None:
    """Raises ModelError where a figure says one of its numbers twice, in words, without a unit or in a wrong one."""
    by_symbol: dict[str, str] = {}
    for key, value in given.items():
        own = [(symbol, dimension) for symbol, (called, dimension) in words.items() if folded(str(key)) in called]
        if len(own) != 1 or isinstance(value, dict | list):
            continue
        ((symbol, dimension),) = own
        if (first := by_symbol.setdefault(symbol, key)) != key:
            told = Message("{first} and {second} say the same: write one of the two", first=first, second=key)
            w.refuse(told, *place, key)
        if (why := wrong_unit(w, key, value, dimension)) is not None:
            w.refuse(why, *place, key)


def wrong_unit(w: Written, key: str, value: Any, wanted: Dimension, usual: str = "") -> Message | None:
    """What is wrong with a number that has another unit than that of what it is, or is none, and what to write; None
    where it is right, or where only its use can tell: of an angle, and of a name. usual: the unit of others of its
    kind."""
    found = dimension_said(w, value)
    if found == wanted or (isinstance(value, str) and value.isidentifier()):
        return None
    if found is None:
        return _no_quantity(w, value)
    unit = "rad/s" if wanted == ANGULAR_VELOCITY else "30 deg" if wanted == DIMENSIONLESS else usual or unit_of(wanted)
    entry = f"{value} {unit}" if found == DIMENSIONLESS else unit if wanted == DIMENSIONLESS else f"1 {unit}"
    return Message("{why}: write {key}: {entry}", why=unit_differs(key, found, wanted), key=key, entry=entry)


def _no_quantity(w: Written, value: Any) -> Message | None:
    """What is wrong with what is neither a quantity nor a formula in parameters of the file."""
    known = cast("Entry", w.data.get("parameters") or {})
    try:
        if any(name in known for name in free_symbols(parse(str(value)))):
            return None
    except InputError:
        pass
    try:
        parse_quantity(value)
    except InputError as error:
        return cast("Message", error.args[0])
    return None


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


def as_parameters(
    w: Written, said: dict[str, str], given: Entry, place: tuple[str, ...], either: Collection[str] = ()
) -> dict[str, Any]:
    """By the symbols what stands in formulas: a parameter that has the number, or what is written there, as of those
    that may have either sign (`either`) a zero: parameters are positive."""
    there = cast("Entry", w.data.get("parameters") or {})
    own = {
        symbol: given[key]
        for symbol, key in said.items()
        if symbol not in there and _is_number(given[key]) and not (symbol in either and value_said(w, given[key]) == 0)
    }
    w.data["parameters"] = {**there, **own}
    w.moved |= {("parameters", symbol): (*place, said[symbol]) for symbol in own}
    return {symbol: symbol if symbol in own else given[key] for symbol, key in said.items()}


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) or str(value).strip()[:1] in "0123456789."
