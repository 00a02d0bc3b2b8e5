"""What is one-sided, or resists by friction, apart from outlines: stops, strings, ideal contacts, brakes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from freebody.language.expression import Expr
from freebody.measures.base import Measure
from freebody.model.elements import ConstraintRow, DryFriction, NonholonomicForm, UnilateralConstraint
from freebody.numeric.engine.packing import Packing
from freebody.numeric.engine.tapes import Tapes
from freebody.numeric.kernels.arrays import floats, ints
from freebody.numeric.kernels.rows import NO_LIMIT, Fixtures
from freebody.numeric.numbers import Numbers

_NONE = -1


@dataclass(frozen=True)
class SystemParts:
    """A system by what time stepping does with it."""

    joints: tuple[ConstraintRow, ...]  # always held
    bounds: tuple[UnilateralConstraint, ...]
    dry_friction: tuple[DryFriction, ...]

    @classmethod
    def of(
        cls, held: Sequence[ConstraintRow], limits: Sequence[UnilateralConstraint], brakes: Sequence[DryFriction]
    ) -> SystemParts:
        """Ideal strings and contacts are bounds; a row that needs one holds as long as that one presses, like friction
        without a limit."""
        joints = tuple(row for row in held if not row.unilateral and not row.needs)
        bounds = tuple(UnilateralConstraint(row) for row in held if row.unilateral)
        grips = tuple(_grip(row) for row in held if row.needs and not row.unilateral)
        return cls(joints, (*bounds, *limits), (*grips, *brakes))

    def enter(self, packing: Packing) -> None:
        """Enters all measures of which rows are needed."""
        for row in self.joints:
            packing.hold(row)
        for bound in self.bounds:
            packing.watch(bound.row.measure)
            for span in bound.within:
                packing.watch(span.measure)
        for friction in self.dry_friction:
            packing.watch(friction.row.measure)
            for _name, measure in friction.measures:
                packing.watch(measure)

    def fixtures(
        self, numbers: Numbers, rows: Mapping[Measure | NonholonomicForm, int], place_of: Sequence[int]
    ) -> Fixtures:
        """rows: of measures in the layout; place_of: of the joints among its held rows."""
        tapes = Tapes(numbers.values)
        places = {bound.name: k for k, bound in enumerate(self.bounds)}
        places |= {row.name: -2 - int(place_of[k]) for k, row in enumerate(self.joints)}
        bounds = [self._bound(bound, numbers, rows, tapes) for bound in self.bounds]
        dry_friction = [self._friction(friction, numbers, rows, tapes, places) for friction in self.dry_friction]
        return Fixtures(
            bound=ints([b[0] for b in bounds], 2, 6),
            bound_number=floats(np.array([b[1] for b in bounds]).reshape(-1, 6)),
            bound_memory=np.zeros(len(bounds)),
            friction=ints([r[0] for r in dry_friction], 2, 6),
            friction_number=floats(np.array([r[1] for r in dry_friction]).reshape(-1, 4)),
            friction_memory=np.zeros(len(dry_friction)),
            tape_ptr=ints(tapes.ptr),
            tape=ints(list(zip(tapes.ops, tapes.left, tapes.right, strict=True)), 2, 3),
            tape_number=floats(tapes.constants),
            registers=np.zeros((max(1, len(tapes.ops)), 4)),
            row_of_bound=np.full(len(bounds), _NONE, np.int32),
        )

    def _bound(
        self,
        bound: UnilateralConstraint,
        numbers: Numbers,
        rows: Mapping[Measure | NonholonomicForm, int],
        tapes: Tapes,
    ) -> tuple[tuple[int, ...], tuple[float, ...]]:
        target, row, tape, value = bound.row.target, bound.row, _NONE, 0.0
        if target is None:
            value = 0.0 if isinstance(row.measure, NonholonomicForm) else numbers.start_value(row.measure)
        elif row.is_driven:
            tape = tapes.write(target, {})
        else:
            value = numbers.number(target)
        spans = [rows[span.measure] for span in bound.within]

        def ends(limits: list[Expr | None], otherwise: float) -> list[float]:
            found = [otherwise if x is None else numbers.number(x) for x in limits]
            return [*found, *(otherwise,) * (2 - len(found))]

        lows, highs = ends([s.low for s in bound.within], -np.inf), ends([s.high for s in bound.within], np.inf)
        return (
            (rows[row.measure], row.sign, tape, *spans, *(_NONE,) * (2 - len(spans)), 0),
            (value, numbers.number(bound.restitution), *lows, *highs),
        )

    def _friction(
        self,
        friction: DryFriction,
        numbers: Numbers,
        rows: Mapping[Measure | NonholonomicForm, int],
        tapes: Tapes,
        places: Mapping[str, int],
    ) -> tuple[tuple[int, ...], tuple[float, ...]]:
        row = rows[friction.row.measure]
        if not friction.load:
            inputs = {name: (rows[measure], 0.0) for name, measure in friction.measures}
            laws = [tapes.write(law, inputs) for law in (friction.static, friction.kinetic)]
            return (row, _NONE, _NONE, *laws, 0), (1.0,) * 4
        loads = [places[name] for name in friction.load]
        coefficients = [
            numbers.number(friction.coefficient(direction, at_rest=at_rest))
            for direction in (1, -1)
            for at_rest in (True, False)
        ]
        return (row, *loads, *(_NONE,) * (2 - len(loads)), _NONE, _NONE, 0), tuple(coefficients)


def _grip(row: ConstraintRow) -> DryFriction:
    from freebody.language.expression import number

    limit = number(int(NO_LIMIT))
    return DryFriction(row, limit, limit, (f"{row.connection}.{row.needs}",))
