"""A number, or why there is none: every failure of floating-point arithmetic is told in the user's names."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message


def finite(value: Any) -> float:
    """The number, if it is one. Raises ValueError for infinities and undefined values."""
    number = float(value)
    if not math.isfinite(number):
        raise ValueError(Message("the result is not finite"))
    return number


_OF_PYTHON = {
    "math domain error": Message("a root of a negative number, or a function beyond its range"),
    "math range error": Message("a number is too large to calculate with"),
    "float division by zero": Message("it is divided by zero"),
}


class named:  # noqa: N801 - used as `with named(...)`, around every jet: a generator would cost more than many of them
    """Says in whose name something has no value; the name may be one that is looked up only then."""

    __slots__ = ("_name",)

    def __init__(self, name: str | Callable[[], str]) -> None:
        self._name = name

    def __enter__(self) -> None:
        pass

    def __exit__(self, _kind: type[BaseException] | None, error: BaseException | None, _trace: object) -> None:
        if not isinstance(error, (CannotAnswer, ArithmeticError, ValueError)):
            return
        name = self._name if isinstance(self._name, str) else self._name()
        if isinstance(error, CannotAnswer):
            raise CannotAnswer(Message("{what}: {why}", what=name, why=error)) from None
        why = _OF_PYTHON.get(str(error), error)
        raise CannotAnswer(Message("{x} has no value here: {why}", x=name, why=why)) from None
