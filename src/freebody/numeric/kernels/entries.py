"""The entries of the library: what Python calls, with which arguments."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

Function = Callable[..., Any]

# how many words of eight bytes an argument takes: where an array begins and its sizes; a number; where a bundle begins
N_DIMENSIONS = {"Floats": 1, "Floats2": 2, "Ints": 1, "Ints2": 2, "Floats2 | None": 2}


@dataclass(frozen=True)
class Entry:
    """A function that is called from Python, as it stands in the library."""

    name: str
    function: Function
    arguments: tuple[Any, ...]  # the names of kinds above, or the class of a bundle
    result: str  # int, bool, float or None
    is_spatial: bool = False


ENTRIES: dict[str, Entry] = {}
RUNNING: dict[str, Function] = {}  # what runs the entries that were called


def fields_of(bundle: Any) -> list[tuple[str, str]]:
    """Names and kinds of what a bundle holds, in order."""
    return [(name, kind.__forward_arg__) for name, kind in bundle.__annotations__.items()]
