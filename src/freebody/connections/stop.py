"""Stop: a measure stays between limits, at which it is stopped or bounces back."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, ClassVar

from freebody.connections.base import Connection, as_written
from freebody.language.expression import add
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, LENGTH
from freebody.measures.angle import Angle
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import ONE, ZERO, Direction
from freebody.model import glyphs
from freebody.model.elements import ConstraintRow, DryFriction, UnilateralConstraint
from freebody.model.friction import read_restitution
from freebody.model.glyphs import Glyph
from freebody.model.phrases import measure_of
from freebody.model.spec import Formula

if TYPE_CHECKING:
    from freebody.model.names import Names


class Stop(Connection, kind="stop"):
    """`stop: {measure: theta, min: 0, max: 60 deg, restitution: 0.3}`: min <= measure <= max; one of the two may be
    left out."""

    called: ClassVar[tuple[str, ...]] = ("buffer",)

    measure: str | dict[str, Any]
    min: Formula | None = None
    max: Formula | None = None
    restitution: Formula = 0

    example = """
bodies: {cart: {particle: {mass: 1 kg}, at: [0, 0]}}
measures: {x: x of cart}
connections: {rail: {slider: {body: cart, along: right}}, it: {stop: {measure: x, min: 0, restitution: 0.5}}}
"""

    def bounds(self, names: Names, connection: str) -> tuple[list[UnilateralConstraint], list[DryFriction]]:
        measure = measure_of(names, self.measure, "measure")
        if self.min is None and self.max is None:
            names.problem(Message("a stop needs min or max"))
        if measure is None:
            return [], []
        restitution = read_restitution(names, self.restitution)
        reaction = {LENGTH: "stop force", DIMENSIONLESS: "stop torque"}.get(measure.dimension, "stop force")
        found: list[UnilateralConstraint] = []
        for key, sign in (("min", 1), ("max", -1)):
            value = getattr(self, key)
            if value is not None:
                limit = names.formula(value, measure.dimension, key)
                row = ConstraintRow(key, reaction, measure, limit, sign, unilateral=True, connection=connection)
                found.append(UnilateralConstraint(row, restitution))
        if not found:
            return [], []
        low, high = (names.numeric(b.row.target) if b.row.target is not None else None for b in (found[0], found[-1]))
        if len(found) == 2 and low is not None and high is not None and low > high:
            names.problem(Message("min ({low:g}) is above max ({high:g})", low=low, high=high))
        return found, []

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        measure = measure_of(names, self.measure)
        for key, side in (("min", 1), ("max", -1)):
            value = getattr(self, key)
            if value is None or measure is None:
                continue
            limit = names.formula(value, measure.dimension, key)
            match measure:
                case Displacement(of, origin, along) if origin.body == along.body != of.body:
                    yield glyphs.Halt(of, origin, along, limit, side)
                case Angle(of, origin, reference):
                    axes = Direction(of, (ONE, ZERO)), Direction(origin, (ONE, ZERO))
                    yield glyphs.TurnHalt(*axes, add(limit, reference), side)
                case _:
                    body = names.known(next(iter(measure.bodies())))
                    text = f"{as_written(self.measure)} {'>=' if side > 0 else '<='} {value}"
                    yield glyphs.Equation(body.center, text)
