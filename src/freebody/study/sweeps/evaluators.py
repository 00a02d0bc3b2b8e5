"""What is asked of every case, by where it comes from: closed forms of `solve`, or motions.

An evaluator gives some columns of numbers and, for all of them together, a status. What is the same for all cases it
finds out once; then it tells what many cases come to at once (`together`), as far as it can, and the others one by one
(`alone`), in any order and from any thread: a case hangs on its own values alone.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from freebody.errors import ModelError
from freebody.language.sentences import Message, further
from freebody.numeric.jets import Array
from freebody.study.sweeps.statuses import CODES, NOT_ADMISSIBLE, NOT_DONE
from freebody.system.system import System

Codes = NDArray[np.int8]
Values = Mapping[str, float]  # of parameters, in SI


@dataclass(frozen=True)
class Column:
    """One number of every case."""

    name: str
    unit: str
    long_name: str


@dataclass(frozen=True)
class Found:
    """What one case has come to; `why` where that is no number."""

    numbers: tuple[float, ...]
    status: str
    why: str = ""


class Evaluator(ABC):
    """name: of its status; columns: what it gives."""

    name: str
    columns: tuple[Column, ...]

    def __init__(self, system: System, read: System | None = None) -> None:
        """read: the model as it was given, where its reader may refuse some of the values: then it reads every case."""
        self.system, self.read = system, read

    def together(self, values: Mapping[str, Array], n: int) -> tuple[Array, Codes]:
        """(n, n_columns) numbers and (n,) codes of statuses, NOT_DONE where a case has to be looked at by itself;
        values: (n,) of the parameters that vary."""
        codes = np.full(n, CODES[NOT_DONE], dtype=np.int8)
        is_good = admissible(self.system, values, n)
        if self.read is not None:
            for i in np.flatnonzero(is_good):
                is_good[i] = not self.refused({name: float(x[i]) for name, x in values.items()})
        codes[~is_good] = CODES[NOT_ADMISSIBLE]
        return np.full((n, len(self.columns)), np.nan), codes

    def refused(self, values: Values) -> str:
        """Why the model does not allow the values of a case; nothing if it does."""
        why = not_admissible(self.system, values)
        return why if why or self.read is None else refused_by_reader(self.read, values)

    @abstractmethod
    def alone(self, values: Values) -> Found:
        """One case by itself. Raises nothing: what fails is a status with its reason."""

    def kinds(self, values: Mapping[str, Array], n: int) -> tuple[NDArray[np.int64], list[str]]:
        """(n,) which of several formulas tells each case, -1 for none, and where each of them holds in words."""
        return np.full(n, -1), []

    def described(self) -> dict[str, Any]:
        """What it is, as plain data."""
        return {column.name: {"unit": column.unit, "what": column.long_name} for column in self.columns}


def admissible(system: System, values: Mapping[str, Array], n: int) -> NDArray[np.bool_]:
    """(n,) where all parameters have the signs that the model gives them and are numbers."""
    found = np.ones(n, dtype=bool)
    for name, x in values.items():
        sign = system.parameters[name].sign
        found &= np.isfinite(x)
        if sign != "any":
            found &= x > 0.0 if sign == "positive" else x >= 0.0
    return found


def refused_by_reader(system: System, values: Values) -> str:
    """What the reader of the model finds wrong with other values of its parameters; nothing if all is well."""
    own = {name: x for name, x in values.items() if name in system.parameters}
    try:
        system.with_parameters(**own)
    except ModelError as error:
        return further(*(problem.message for problem in error.problems))
    return ""


def not_admissible(system: System, values: Values) -> str:
    """Why the values of a case are not admissible; nothing if they are."""
    one = {name: np.array([x]) for name, x in values.items()}
    wrong = [name for name, x in one.items() if not admissible(system, {name: x}, 1)[0]]
    return further(
        *(
            Message(
                "{name} = {value:g}; the model says that it is {sign}",
                name=name,
                value=values[name],
                sign=system.parameters[name].sign,
            )
            for name in wrong
        )
    )
