"""What all options of one question have in common: the answer, the names, and where numbers are tried."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from typing import Any

from freebody.assess.names import NameTable
from freebody.assess.points import EvaluationPoint, drawn, real
from freebody.language.units import Dimension
from freebody.symbolic.field import Ratio
from freebody.symbolic.model import SymbolicModel
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
    ) -> None:
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
