"""What the program is busy with, for whoever shows it.

A study says `busy_with("checking q1 against numbers")`; that costs nothing where nobody looks, and answers never depend
on it. `announced` is for what a user should know even where no one looks on, such as kernels that are compiled once.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass


@dataclass
class _Desk:
    """What is being done now, and who hears of it."""

    now: str = ""
    listener: Callable[[str], None] | None = None


_desk = _Desk()


def busy_with(what: str) -> None:
    """From now on the program does this, in a few words."""
    _desk.now = what


def now() -> str:
    return _desk.now


def announced(what: str) -> None:
    """The same, told at once to the listener if there is one."""
    busy_with(what)
    if _desk.listener is not None:
        _desk.listener(what)


def listen(listener: Callable[[str], None] | None) -> None:
    """Who is told what is announced; None for nobody."""
    _desk.listener = listener
