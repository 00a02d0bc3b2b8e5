"""Every exception of freebody.

FreebodyError
+-- InputError            the user's text, file or model is at fault (exit code 2)
|   +-- ExpressionError   one expression cannot be read: message and column
|   +-- UnitError         a unit is unknown or does not fit
|   |   +-- NoQuantity        a text is too long for a number with a unit
|   +-- ModelError        a model file or System: all its problems, each with its place
+-- CannotAnswer          the model is fine, the question has no answer here (exit code 1)
|   +-- BudgetExhausted   a search did all the work it was allowed: more effort may find it
|   +-- FormulaTooLong    a formula with more terms than anybody reads, or the memory holds
|   |   +-- FormulaTooDear   the same for the work that it takes
|   +-- NoRealRoot        a root of a number that is negative
|   +-- NeverHappens      an event that is proved never to happen after the start
+-- SelfTestFailed        an exported package does not mark known answers as it must: it is not written
+-- RoutesDisagree        the two routes give different numbers: a defect, never an answer
BrokenInstallation        freebody itself is not whole here (exit code 1); no case, question or picture stands for it
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from freebody.messages import Message, lines


class FreebodyError(Exception):
    """Base of all freebody errors."""


class BrokenInstallation(Exception):
    """freebody is not whole on this machine. It is no FreebodyError, as it ends everything: where many cases run, one
    without a number is a result, and this must not be taken for that."""


class InputError(FreebodyError):
    """What the user wrote is at fault; the message says what, where and what to do."""


class ExpressionError(InputError):
    """An expression that cannot be read. `column` counts from 1 within the expression's text."""

    def __init__(self, message: str, column: int = 1) -> None:
        super().__init__(Message("{message} (column {column})", message=message, column=column))
        self.message = message
        self.column = column

    def __reduce__(self) -> tuple[type[ExpressionError], tuple[str, int]]:
        return type(self), (self.message, self.column)


class UnitError(InputError):
    """A unit that is unknown, or dimensions that do not fit together."""


class NoQuantity(UnitError):
    """A text that is too long for a number with a unit."""


@dataclass(frozen=True)
class Problem:
    """One mistake in a model: where it stands, what is wrong, what to do about it."""

    path: tuple[str | int, ...]
    message: str
    line: int | None = None
    column: int | None = None

    def text(self, file: str | None) -> str:
        place = ".".join(str(part) for part in self.path)
        spot = ":".join(str(part) for part in (file, self.line, self.column) if part is not None)
        where = ": ".join(part for part in (spot, place) if part)
        return Message("{where}: {what}", where=where, what=self.message) if where else self.message


class ModelError(InputError):
    """All problems of one model, in one message."""

    def __init__(self, problems: Sequence[Problem], file: str | None = None) -> None:
        self.problems = tuple(problems)
        self.file = file
        super().__init__(lines([problem.text(file) for problem in self.problems]))

    def __reduce__(self) -> tuple[type[ModelError], tuple[tuple[Problem, ...], str | None]]:
        return type(self), (self.problems, self.file)


class CannotAnswer(FreebodyError):
    """The question has no answer here; the message says why and what to do instead."""


class SaysNothing(CannotAnswer):
    """The routes cannot be compared at the given numbers; that is no difference."""


class BudgetExhausted(CannotAnswer):
    """A search that has done all the work it was allowed; what it looked for may still be there."""


class FormulaTooLong(CannotAnswer):
    """The closed form would be too long to be made in one piece; named parts of it may be short."""


class FormulaTooDear(FormulaTooLong):
    """Making the closed form in one piece took more work than it was allowed; it need not be long."""


class NoRealRoot(CannotAnswer):
    """A formula has no real value where something is put in: a number below its root is negative."""


class NeverHappens(CannotAnswer):
    """The event that a question is about does not happen after the start, and that is proved."""


class NotReached(CannotAnswer):
    """The event that a question is about does not come at any parameter values that were tried."""


class SelfTestFailed(FreebodyError):
    """A package for a learning platform marks answers otherwise than it must; the message names them."""


class RoutesDisagree(FreebodyError):
    """The symbolic and the numeric route give different values; no result is shown."""


class RoutesUntold(RoutesDisagree):
    """They do, in numbers so far apart that round-off alone may be the reason."""
