"""A number, or why there is none: every failure of floating-point arithmetic is told in the user's names."""

from __future__ import annotations

import math
from collections.abc import Callable, Generator
from contextlib import contextmanager
from typing import Any

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message


def finite(value: Any) -> float:
    """The number, if it is one. Raises ValueError for infinities and undefined values."""
    number = float(value)
    if not math.isfinite(number):
        raise ValueError(Message("the result is not finite"))
    return number


@contextmanager
def named(name: str | Callable[[], str]) -> Generator[None]:
    """Says in whose name something has no value; the name may be one that is looked up only then."""
    try:
        yield
    except CannotAnswer as error:
        raise CannotAnswer(
            Message("{what}: {why}", what=name if isinstance(name, str) else name(), why=error)
        ) from None
    except (ArithmeticError, ValueError) as error:
        raise CannotAnswer(
            Message("{x} has no value here: {why}", x=name if isinstance(name, str) else name(), why=error)
        ) from None
