"""What all options of one question have in common: the answer, the names, and where numbers are tried."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Any

from freebody.assess.names import NameTable, named_in
from freebody.assess.points import BALL_FUNCTIONS, EvaluationPoint, drawn, is_free, real
from freebody.language.expression import Expr
from freebody.language.units import Dimension
from freebody.symbolic.functions import element
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio
from freebody.system.system import System

Answer = Ratio | tuple[Ratio, Ratio] | Fraction | None

N_TRIES = 60


class Setting:
    """One question's answer in its model."""

    def __init__(
        self,
        answer: Answer,
        dimension: Dimension,
        model: SymbolicModel,
        system: System,
        up_to_constant: bool,
        region: Sequence[Ratio] = (),
        *,
        is_typed: bool = False,
    ) -> None:
        """is_typed: what is judged is an answer that somebody gave, and no option of a question."""
        self.is_typed = is_typed
        self.region = tuple(region)  # positive wherever the answer is one
        self.field = model.field
        self.model = model
        self.dimension = dimension
        self.up_to_constant = up_to_constant
        self.names = NameTable(model, system)
        self.own_numbers: dict[int, Any] = {}
        self.angles = {c.index for c in model.coordinates if c.is_angle}
        for p in system.parameters.values():
            index = self.field.index(model.parameters[p.name])
            if p.value is not None:
                self.own_numbers[index] = real(p.value)
            if p.is_angle:
                self.angles.add(index)
        # where loops bind the coordinates, only poses of the mechanism are admissible
        self._poses = [
            {k: real(float(v)) for k, v in model.samples.numbers(sample).items()}
            for sample in (model.samples.points if model.loops else ())
        ]
        self.answers: tuple[Ratio, ...] | None = None
        if answer is not None:
            parts = answer if isinstance(answer, tuple) else (answer,)
            # in the independent speeds, as the names of options are, so that numbers for these fit each other
            self.answers = tuple(model.in_independent_speeds(self.field.element(part)) for part in parts)

    def points(
        self, conditions: Sequence[Ratio] = (), fixed: Callable[[EvaluationPoint], None] | None = None
    ) -> Iterator[EvaluationPoint]:
        """Random admissible points, every other one near the model's own numbers; the same in every run."""
        for seed in range(N_TRIES):
            point = EvaluationPoint(self.field, drawn(self.field, seed, self.own_numbers if seed % 2 else {}))
            if fixed is not None:
                fixed(point)
            if all(point.number(c) > 0 for c in (*conditions, *self.region)):
                yield point

    def poses(self) -> list[EvaluationPoint]:
        """Poses of a mechanism with loops, else none."""
        return [EvaluationPoint(self.field, drawn(self.field, 0, {}), pose) for pose in self._poses]

    def value_with(self, changed: Mapping[int, float]) -> tuple[float, ...] | None:
        """The answer in numbers at the model's own, with others for some parameters; None where it needs more."""
        numbers = {**self.own_numbers, **{g: real(Fraction(repr(float(x)))) for g, x in changed.items()}}
        assert self.answers is not None
        free = {g for x in self.answers for g in self.field.ingredients(x) if is_free(self.field, g)}
        pi = self.field.index(self.field.pi)
        if not free - {pi} <= numbers.keys() or not free & changed.keys():
            return None
        point = EvaluationPoint(self.field, lambda _g: real(0), {**numbers, pi: BALL_FUNCTIONS["pi"]})
        found = [point.number(x) for x in self.answers]
        return tuple(map(float, found)) if all(x.is_finite() for x in found) else None

    def difference(self, a: Expr, b: Expr) -> Ratio:
        """Of two expressions in the names of the problem. Raises CannotAnswer for what the field cannot say."""
        keys = {**named_in(a), **named_in(b)}
        values = {key: self.names.element(key) for key in keys}
        first, second = (element(self.field, x, values, lambda _x: False) for x in (a, b))
        return self.field.lowest_terms(self.model.in_independent_speeds(first - second))
