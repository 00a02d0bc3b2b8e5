"""How much work a search may do before it gives up.

Every budget counts work: steps, terms, evaluations, never seconds, so that a slow machine prints what a fast one
prints, and compiling costs nothing. A budget is stated where it is spent, for the ordinary effort, and asked for by
`allowed`; `effort(4)` lets everything inside the block spend four times as much. Where a budget is exhausted it is
said that nothing was found within it, which is not the same as that there is nothing.
"""

from __future__ import annotations

import math
from collections.abc import Generator
from contextlib import contextmanager
from contextvars import ContextVar, Token

from freebody.errors import InputError
from freebody.messages import Message

_FACTOR: ContextVar[float] = ContextVar("effort", default=1.0)


@contextmanager
def effort(factor: float) -> Generator[None]:
    """Searches inside the block may do `factor` times the ordinary work. Raises InputError for a factor that is not
    positive and finite."""
    token = raise_effort(factor)
    try:
        yield
    finally:
        _FACTOR.reset(token)


def raise_effort(factor: float) -> Token[float]:
    """The same from here on, for a command. Raises InputError likewise."""
    if not (math.isfinite(factor) and factor > 0.0):
        raise InputError(Message("the effort is a positive number, 1 the ordinary one, not {factor:g}", factor=factor))
    return _FACTOR.set(factor)


def allowed(budget: int) -> int:
    """A budget under the effort that is in force."""
    return max(1, round(budget * _FACTOR.get()))
