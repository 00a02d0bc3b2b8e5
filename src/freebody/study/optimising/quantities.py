"""What a goal or a limit is about: a number of each case, as `sweep` has it, with its slopes.

b + 2*c                            a formula in the parameters
tension, force of spring at start  a question, by its id or in words
maximum of Q over theta            the greatest value of a question while something runs through a range
final x, maximum of x              of the motion up to a time
"""

from __future__ import annotations

import re
from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass

import numpy as np

from freebody.errors import CannotAnswer, ExpressionError, InputError, UnitError
from freebody.language.expression import Expr, free_symbols
from freebody.language.parser import parse
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, Dimension, dimension_of, parse_quantity, unit_of
from freebody.numeric.jets import Array
from freebody.numeric.vectorised import VectorFunction
from freebody.study.sweeps.answers import AnswerEvaluator
from freebody.study.sweeps.evaluators import Evaluator
from freebody.study.sweeps.motions import MotionEvaluator
from freebody.study.sweeps.statuses import GOOD, NO_VALUE, NOT_DONE, STATUSES
from freebody.symbolic.gradients import derivative
from freebody.system.system import System

_OVER = re.compile(r"(?P<side>maximum|minimum) of (?P<what>.+) over (?P<name>[^\s=]+)(?:\s*=\s*(?P<range>.+))?")
STEP = 1e-6  # of its range, by which a name is moved for a difference


@dataclass(frozen=True)
class Failed:
    """A case without a number."""

    of: str
    status: str
    why: str


@dataclass(frozen=True)
class Over:
    """`maximum of Q over theta=0..180 deg`, read apart."""

    side: int  # 1 for the greatest, -1 for the least
    what: str
    name: str
    range: str | None

    @classmethod
    def read(cls, text: str) -> Over | None:
        found = _OVER.fullmatch(" ".join(text.split()))
        if found is None:
            return None
        return cls(1 if found["side"] == "maximum" else -1, found["what"], found["name"], found["range"])


class Quantity(ABC):
    """text: as it was asked for; dimension: of its values in SI; n_places: how many values one case has, of which the
    greatest (side 1) or the least (-1) counts; is_exact: slopes are formulas; is_smooth: slopes mean something."""

    text: str
    dimension: Dimension
    is_angle = False
    n_places = 1
    side = 1
    is_exact = True
    is_smooth = True

    @property
    def unit(self) -> str:
        """Of its values, empty for a plain number."""
        plain = "rad" if self.is_angle else ""
        return plain if self.dimension == DIMENSIONLESS else unit_of(self.dimension)

    @abstractmethod
    def places(self, values: Mapping[str, Array], n: int) -> tuple[Array, list[Failed | None]]:
        """(n, n_places) numbers of cases, NaN with the reason where one has none."""

    @abstractmethod
    def slopes(self, values: Mapping[str, Array], n: int, by: Sequence[str]) -> Array:
        """(n, n_places, n_by) exact derivatives by parameters; NaN where no formula gives them."""

    @abstractmethod
    def depends_on(self, name: str) -> bool | None:
        """Whether a parameter matters; None where that is not told by a formula."""

    def is_linear_in(self, names: Sequence[str]) -> bool:
        """Whether it is proved to be linear in parameters, in every case."""
        return not names

    def chosen(self, places: Array) -> Array:
        """(n,) the one value that counts."""
        return self.side * np.max(self.side * places, axis=-1)


class Formula(Quantity):
    """An expression in the parameters."""

    def __init__(self, system: System, text: str, expr: Expr, dimension: Dimension) -> None:
        self.text, self.system, self.expr, self.dimension = text, system, expr, dimension
        self.function = VectorFunction([expr])
        self.own = {p.name: p.value for p in system.parameters.values() if p.value is not None}
        self._derivatives: dict[str, VectorFunction] = {}

    def places(self, values: Mapping[str, Array], n: int) -> tuple[Array, list[Failed | None]]:
        known = {**self.own, **values}
        if missing := sorted(self.function.names - known.keys()):
            raise InputError(Message("{name} needs a value, as --set '{name}=1'", name=missing[0]))
        found = self.function.at(known, n)[0]
        why = Message("the formula has no real value there")
        return found[:, None], [None if np.isfinite(x) else Failed(self.text, NO_VALUE, why) for x in found]

    def slopes(self, values: Mapping[str, Array], n: int, by: Sequence[str]) -> Array:
        known = {**self.own, **values}
        return np.stack([self._derivative(name).at(known, n)[0][:, None] for name in by], axis=-1)

    def _derivative(self, name: str) -> VectorFunction:
        if name not in self._derivatives:
            self._derivatives[name] = VectorFunction([derivative(self.expr, name, self.system.parameters)])
        return self._derivatives[name]

    def depends_on(self, name: str) -> bool | None:
        return name in self.function.names

    def is_linear_in(self, names: Sequence[str]) -> bool:
        return all(not free_symbols(derivative(self.expr, name, self.system.parameters)) & {*names} for name in names)


class Asked(Quantity):
    """A number of an answer, or of the motion."""

    def __init__(self, text: str, evaluator: Evaluator) -> None:
        self.text, self.evaluator = text, evaluator
        if len(evaluator.columns) > 1:
            names = ", ".join(c.name for c in evaluator.columns)
            raise InputError(
                Message(
                    "{text} has several components ({names}); a goal or a limit is one number", text=text, names=names
                )
            )
        unit = next(iter(evaluator.columns)).unit
        self.is_exact = isinstance(evaluator, AnswerEvaluator) and bool(evaluator.forms)
        self.is_smooth = not isinstance(evaluator, MotionEvaluator)
        self.dimension = DIMENSIONLESS if unit in ("", "1", "rad") else parse_quantity(f"1 {unit}").dimension
        self.is_angle = unit == "rad"

    def places(self, values: Mapping[str, Array], n: int) -> tuple[Array, list[Failed | None]]:
        numbers, codes = self.evaluator.together(values, n)
        failed: list[Failed | None] = [None] * n
        for i in range(n):
            own = {name: float(x[i]) for name, x in values.items()}
            status, why = STATUSES[int(codes[i])], ""
            if status == NOT_DONE:
                found = self.evaluator.alone(own)
                numbers[i], status, why = found.numbers, found.status, found.why
            if status not in GOOD or not np.isfinite(numbers[i, 0]):
                numbers[i] = np.nan
                failed[i] = Failed(self.text, status, why or self.evaluator.refused(own))
        return numbers, failed

    def slopes(self, values: Mapping[str, Array], n: int, by: Sequence[str]) -> Array:
        if not isinstance(self.evaluator, AnswerEvaluator):
            return np.full((n, 1, len(by)), np.nan)
        return self.evaluator.slopes(values, n, by)

    def depends_on(self, name: str) -> bool | None:
        if not self.is_exact or not isinstance(self.evaluator, AnswerEvaluator):
            return None
        forms = self.evaluator.forms
        said = [c for form in forms for c, _words in form.conditions or ()]
        return any(name in form.parts.names for form in forms) or any(name in c.names for c in said)

    def is_linear_in(self, names: Sequence[str]) -> bool:
        if not isinstance(self.evaluator, AnswerEvaluator):
            return False
        forms, system = self.evaluator.forms, self.evaluator.system
        if len(forms) != 1 or forms[0].conditions != ():
            return False
        with suppress(CannotAnswer):
            return Formula(system, self.text, forms[0].expressions[0], self.dimension).is_linear_in(names)
        return False


class Through(Quantity):
    """The greatest (side 1) or the least value of another quantity while a parameter runs through values."""

    def __init__(self, text: str, of: Quantity, name: str, grid: Array, side: int) -> None:
        self.text, self.of, self.name, self.grid, self.side = text, of, name, grid, side
        self.n_places, self.dimension, self.is_angle = len(grid), of.dimension, of.is_angle
        self.is_exact, self.is_smooth = of.is_exact, of.is_smooth

    def _all(self, values: Mapping[str, Array], n: int) -> tuple[dict[str, Array], int]:
        """The cases, each with all the places."""
        every = {key: np.repeat(x, self.n_places) for key, x in values.items()}
        return {**every, self.name: np.tile(self.grid, n)}, n * self.n_places

    def places(self, values: Mapping[str, Array], n: int) -> tuple[Array, list[Failed | None]]:
        numbers, failed = self.of.places(*self._all(values, n))
        own = [failed[k * self.n_places : (k + 1) * self.n_places] for k in range(n)]
        return numbers.reshape(n, self.n_places), [next(filter(None, each), None) for each in own]

    def slopes(self, values: Mapping[str, Array], n: int, by: Sequence[str]) -> Array:
        every, n_all = self._all(values, n)
        return self.of.slopes(every, n_all, by).reshape(n, self.n_places, len(by))

    def depends_on(self, name: str) -> bool | None:
        return self.of.depends_on(name)


def read_formula(system: System, text: str) -> Formula | None:
    """An expression in the parameters; None where it is none. Raises InputError for lengths added to masses."""
    try:
        expr = parse(text)
    except ExpressionError:
        return None
    known = {p.name: p.dimension for p in system.parameters.values() if p.form is None}
    if not free_symbols(expr) or not free_symbols(expr) - {"pi"} <= known.keys():
        return None
    try:
        return Formula(system, text, expr, dimension_of(expr, known))
    except UnitError as error:
        raise InputError(Message("in '{text}': {error}", text=text, error=error)) from error
