"""Driver: a measure follows a prescribed function of time."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, ClassVar

from freebody.connections.base import Connection, as_written
from freebody.connections.standing import begun_by
from freebody.language.expression import ZERO, Expr, substitute
from freebody.language.units import DIMENSIONLESS, LENGTH, TIME
from freebody.measures.geometry import Direction, Point
from freebody.model import glyphs
from freebody.model.elements import ConstraintRow
from freebody.model.glyphs import Glyph
from freebody.model.phrases import measure_of
from freebody.model.spec import Formula

if TYPE_CHECKING:
    from freebody.model.names import Names


class Driver(Connection, kind="driver"):
    """`driver: {measure: theta, follows: omega*t}`. The driving force or torque does positive work when it pushes
    the measure up (1 row)."""

    called: ClassVar[tuple[str, ...]] = ("drive", "motor")
    also: ClassVar[tuple[str, ...]] = ("drive", "motor")

    measure: str | dict[str, Any]
    follows: Formula

    is_chosen = True
    example = """
bodies: {rod: {rod: {mass: 1 kg, length: 1 m}}}
connections: {p: {pin: [ground.A, rod.start]}, it: {driver: {measure: angle of rod, follows: w*t}}}
parameters: {w: 2 rad/s}
"""

    def rows(self, names: Names) -> list[ConstraintRow]:
        measure = measure_of(names, self.measure, "measure")
        if measure is None:
            return []
        target = names.formula(self.follows, measure.dimension, "follows", extra={"t": TIME})
        what = {LENGTH: "driving force", DIMENSIONLESS: "driving torque"}
        return [ConstraintRow("drive", what.get(measure.dimension, "driving force"), measure, target)]

    def bears_at(self, names: Names, point: Point, normal: Direction) -> Expr | None:
        """Where what it leads starts, at t = 0."""
        with names.quietly():
            measure = measure_of(names, self.measure)
            if measure is None or point.body not in set(measure.bodies()):
                return None
            target = names.formula(self.follows, measure.dimension, extra={"t": TIME})
        return begun_by(names, measure, substitute(target, {"t": ZERO}), point, normal)

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        measure = measure_of(names, self.measure)
        for body in list(measure.bodies())[:1] if measure is not None else ():
            yield glyphs.Equation(names.known(body).center, f"{as_written(self.measure)} = {self.follows}")
