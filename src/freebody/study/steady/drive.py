"""A turn that is driven, as one that is free: the poses are the same, and the rates in them those of the drive.

With theta' = w constant, what geometry tells of a mechanism with one freedom is, over the turn of theta, a function of
theta alone: x = x(theta), x' = x_theta w, x'' = x_theta_theta w^2. Forces follow from these by Newton-Euler of every
body, in which the drive is the reaction that keeps theta'' = 0 (d'Alembert's principle).
Source: Norton, Design of Machinery, 5th ed. 2012, sec. 11.2 to 11.4.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any, cast

from freebody.errors import CannotAnswer
from freebody.language.expression import ZERO, Expr, differentiate, substitute
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS
from freebody.model.elements import ConstraintRow, NonholonomicForm
from freebody.questions.base import Quantity
from freebody.study.answering.draws import Draw
from freebody.study.setup import Setup
from freebody.symbolic.state import SymbolicState
from freebody.symbolic.unknowns import Coordinate
from freebody.system.system import System


class FreeToTurn(Setup):
    """A system whose one drive, that of an angle at a constant rate, is left out: the angle is the one measure, and so
    the coordinate. It starts where the drive does: springs are preloaded there. driven: the system with it; rate: of
    the angle [rad/s]."""

    def __init__(self, driven: System, drive: ConstraintRow, rate: Expr, first: Draw | None = None) -> None:
        assert not isinstance(drive.measure, NonholonomicForm)
        name = next((n for n, m in driven.measures.items() if m == drive.measure), "turn")
        rows = tuple(row for row in driven.constraint_rows if row is not drive)
        measures = {name: drive.measure}
        begin = {name: substitute(drive.target or ZERO, {"t": ZERO})}
        free = replace(driven, constraint_rows=rows, measures=measures, start=begin, start_rates={})
        super().__init__(free, first=first)
        self.driven, self.drive, self.rate = driven, drive, rate

    def beginning_with(self, first: Draw) -> FreeToTurn:
        return FreeToTurn(self.driven, self.drive, self.rate, first)


def without_drive(setup: Setup) -> Setup:
    """Free to turn, where an angle is driven at a constant rate; else as it is."""
    system = setup.system
    drives = [row for row in system.constraint_rows if row.is_driven]
    if len(drives) != 1 or drives[0].target is None or drives[0].measure.dimension != DIMENSIONLESS:
        return setup
    rate = differentiate(drives[0].target, "t")
    return FreeToTurn(system, drives[0], rate) if differentiate(rate, "t") == ZERO else setup


def turned_by_drive(setup: FreeToTurn) -> Coordinate:
    """The angle that the drive turns. Raises CannotAnswer where it is not the only freedom."""
    model = setup.model
    if len(model.coordinates) > 1:
        raise CannotAnswer(Message("beside the drive something else is free to move, which has a motion of its own"))
    return next(c for c in model.coordinates if model.measure_of(c) == setup.drive.measure)


def followed(setup: Setup, of: Quantity) -> Any:
    """The quantity over the turn: its rates are those of the drive, where that is left out."""
    model, system = setup.model, setup.system
    if not isinstance(setup, FreeToTurn) or of.kinematic_order == 0:
        return of.value(system, setup.state)
    rate, turned = model.geometry.scalar(setup.rate), turned_by_drive(setup)
    state = SymbolicState(model.kept_going(setup.driven), {turned.speed: rate})
    value: Any = of.value(setup.driven, state)
    for x in map(model.field.element, components(value)):
        if any(model.field.generators[g].kind == "time" for g in model.field.ingredients(x)):
            raise CannotAnswer(
                Message("a load depends on the time as well as on the angle: no turn is as the one before")
            )
    return value


def components(value: Any) -> tuple[Any, ...]:
    """The components of a vector, or a number alone."""
    return cast("tuple[Any, ...]", value) if isinstance(value, tuple) else (value,)
