"""Plain data: mappings with text keys, lists, texts, finite numbers, true, false, None, and nothing else."""

from __future__ import annotations

import math
import operator
import re
from collections.abc import Mapping
from typing import Any, cast

from freebody.errors import ModelError, Problem
from freebody.language.document.tree import MAX_DEPTH, MAX_KEY, MAX_VALUES, Place
from freebody.messages import Message

_SHORT = 200  # characters of a text that no line of a file is too long for
_LARGE = 10**18


def checked(data: Any, path: Place) -> Any:
    """The data in plain types. Raises ModelError with everything that is not plain."""
    problems: list[Problem] = []
    result = _as_plain(data, path, problems)
    if problems:
        raise ModelError(problems)
    return result


def _as_plain(value: Any, path: Place, problems: list[Problem]) -> Any:
    if len(path) > MAX_DEPTH:
        problems.append(
            Problem((), Message("lists and mappings stand more than {most} deep in each other", most=MAX_DEPTH))
        )
        return None
    if isinstance(value, Mapping):
        result: dict[str, Any] = {}
        for key, item in cast("Mapping[Any, Any]", value).items():
            name = _key_text(key, path, problems)
            if name in result:
                problems.append(Problem(path, Message("two keys are written {name}", name=name)))
            result[name] = _as_plain(item, (*path, name), problems)
        return result
    if isinstance(value, (list, tuple)):
        items = cast("list[Any] | tuple[Any, ...]", value)
        return [_as_plain(item, (*path, k), problems) for k, item in enumerate(items)]
    if value is None or isinstance(value, bool):
        return value
    if isinstance(value, str):
        if re.search("[\ud800-\udfff]", value):
            problems.append(Problem(path, Message("half a character (a surrogate) cannot be written")))
        return str.__str__(value)
    if hasattr(value, "__index__"):
        value = operator.index(value)
    elif not isinstance(value, float):
        if callable(value) and (name := getattr(value, "__name__", "")):
            problems.append(Problem(path, Message("{name} is a function: call it, as {name}()", name=name)))
            return None
        message = Message(
            "{kind} is not plain data; give a number, a text, a list or a mapping", kind=type(value).__name__
        )
        problems.append(Problem(path, message))
        return None
    try:
        finite = math.isfinite(value)
    except OverflowError:
        finite = False
    if not finite:
        problems.append(Problem(path, Message("is not a finite number")))
        return None
    return value if isinstance(value, int) else float(value)


def _key_text(key: Any, path: Place, problems: list[Problem]) -> str:
    if isinstance(key, bool) or not isinstance(key, (str, int)):
        problems.append(Problem(path, Message("the key {key} is not text", key=repr(key))))
    name = str.__str__(key) if isinstance(key, str) else str(key)
    if len(name) > MAX_KEY:
        problems.append(
            Problem(path, Message("a key of {n} characters; write at most {most}", n=len(name), most=MAX_KEY))
        )
    if re.search("[\ud800-\udfff]", name):
        problems.append(Problem(path, Message("a key with half a character (a surrogate) cannot be written")))
    return name


def is_ordinary(data: Any) -> bool:
    """Whether a text that is written of checked data is certainly within the limits of a file, so that it need not be
    read to know: not too many values, and every key and text short and of printable characters."""
    n_values, waiting = 0, [data]
    while waiting:
        value = waiting.pop()
        n_values += 1
        if isinstance(value, dict):
            entries = cast("dict[str, Any]", value)
            waiting += (*entries, *entries.values())
            n_values -= len(entries)  # keys are none
        elif isinstance(value, list):
            waiting += cast("list[Any]", value)
        elif isinstance(value, str):
            if len(value) > _SHORT or not value.isprintable():
                return False
        elif isinstance(value, int) and abs(value) > _LARGE:
            return False
    return n_values <= MAX_VALUES


def copied(data: Any) -> Any:
    """The same plain data, made anew."""
    if isinstance(data, dict):
        return {key: copied(value) for key, value in cast("dict[str, Any]", data).items()}
    if isinstance(data, list):
        return [copied(value) for value in cast("list[Any]", data)]
    return data


def with_value(data: Any, path: Place, value: Any) -> Any:
    """Plain data with one value exchanged; what is missing or None on the way becomes a mapping."""
    if not path:
        return value
    part, rest = path[0], path[1:]
    if isinstance(data, list):
        items = cast("list[Any]", data)
        return [with_value(v, rest, value) if k == part else v for k, v in enumerate(items)]
    entries = cast("dict[str, Any]", data or {})
    return {**entries, str(part): with_value(entries.get(str(part)), rest, value)}


def without_value(data: Any, path: Place) -> Any:
    """Plain data without one key."""
    part, rest = str(path[0]), path[1:]
    entries = cast("dict[str, Any]", data)
    if not rest:
        return {name: value for name, value in entries.items() if name != part}
    return {**entries, part: without_value(entries[part], rest)}
