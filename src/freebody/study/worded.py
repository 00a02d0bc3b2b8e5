"""The doors of the studies: arithmetic that fails on the way becomes a refusal in words.

A quotient by zero has a cause that the user can see: two points that coincide, a measure that is undefined where the
model starts. Inside, the error tells nothing of that; here the model is known, and the cause is looked for in it.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from contextlib import suppress
from functools import wraps
from typing import TYPE_CHECKING, Concatenate, ParamSpec, TypeVar

import numpy as np

from freebody.errors import CannotAnswer, FreebodyError
from freebody.language.notation import to_text
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.model.elements import NonholonomicForm
from freebody.numeric.reference import Reference
from freebody.system.system import System
from freebody.tolerances import SAME_PLACE

if TYPE_CHECKING:
    from freebody.symbolic.ratio import DivisorVanishes

P = ParamSpec("P")
T = TypeVar("T")
_MOST_TERMS = 12  # of a divisor that is shown
FAILED = (ArithmeticError, np.linalg.LinAlgError)


def in_words(study: Callable[Concatenate[System, P], T]) -> Callable[Concatenate[System, P], T]:
    """A study whose arithmetic errors are CannotAnswer with their cause in the model."""

    @wraps(study)
    def told(system: System, /, *args: P.args, **kwargs: P.kwargs) -> T:
        try:
            return study(system, *args, **kwargs)
        except FAILED as error:
            raise CannotAnswer(cause(system, error)) from error
        except RecursionError as error:
            raise CannotAnswer(
                Message("the formulas of this model are nested too deeply to be calculated with")
            ) from error

    return told


def cause(system: System, error: Exception) -> str:
    """Why the arithmetic of a study failed: the measure without a value at the start, if there is one."""
    undefined = next(without_value(system), "")
    if undefined:
        return Message("{what}, so that nothing can be said here; start the model where it has a value", what=undefined)
    from freebody.symbolic.ratio import DivisorVanishes  # studies in numbers alone do without it

    if isinstance(error, DivisorVanishes):
        return Message("the formulas divide by {x}, which is zero in the state that is asked about", x=_shown(error))
    what = (
        Message("divides by zero")
        if isinstance(error, ZeroDivisionError)
        else Message("leaves the range of floating point")
    )
    return Message(
        "the arithmetic of this study {what} for this model, and no measure of it is without a value at its start",
        what=what,
    )


def _shown(error: DivisorVanishes) -> str:
    """The divisor, if anybody would read it."""
    from freebody.symbolic.tidy import tidy

    divisor = error.divisor
    return to_text(tidy(divisor)) if len(divisor.num) <= _MOST_TERMS else Message("a long expression")


def without_value(system: System) -> Iterator[str]:
    """Measures of connections, loads and the user that have no value, or no gradient, at the start."""
    named: list[tuple[str, Measure | NonholonomicForm]] = [(row.name, row.measure) for row in system.rows]
    named += [(push.name, push.measure) for push in system.applied_loads]
    named += [*system.measures.items()]
    with suppress(FreebodyError, ArithmeticError, ValueError):
        reference = Reference(system)
        q = reference.assemble()
        geometry = reference.snapshot(q, np.zeros_like(q)).geometry
        geometry.least = SAME_PLACE * reference.sizes.length
        for name, measure in named:
            try:
                jet = reference.jet(geometry, measure, name)
            except FreebodyError as error:
                yield str(error)
            except (ArithmeticError, ValueError):
                yield Message("{x} has no value at the start", x=name)
            else:
                if not math.isfinite(jet.value) or not np.isfinite(jet.row(len(q))).all():
                    yield Message("{x} has no finite value at the start", x=name)
