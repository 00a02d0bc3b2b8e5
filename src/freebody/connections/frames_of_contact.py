"""What a place of contact comes to in axes of one of the bodies: slip and turning of the other one against it.

With d the place of a point C of the moving body by components along axes e of the other one, r the arm from C to where
they touch and t a direction, the material point there slips by t . (d' + w x r) = t . d' + w . (r x t). The angular
velocity of the one against the other is w . e_k = - sum_i (e_k+2 . a_i) d(e_k+1 . a_i)/dt, as in `model.spins`.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from freebody.language.expression import ZERO, Expr, Symbol, free_symbols
from freebody.language.units import DIMENSIONLESS, LENGTH, Dimension
from freebody.measures.combination import Composed
from freebody.measures.displacement import Displacement
from freebody.measures.turn import Alignment
from freebody.model.elements import NonholonomicForm
from freebody.model.rotations import vector_product
from freebody.model.spins import body_axes

if TYPE_CHECKING:
    from freebody.measures.base import Measure
    from freebody.measures.geometry import Components, Direction, Point

Axes = tuple["Direction", "Direction", "Direction"]


@dataclass(frozen=True)
class ContactFrame:
    """A body seen from axes of another one; seen: what formulas call d, and more."""

    mover: str
    axes: Axes
    moves: tuple[Displacement, ...]
    seen: tuple[tuple[str, Measure], ...]
    turns: bool = True

    @classmethod
    def of(
        cls, point: Point, origin: Point, axes: Axes, names: Components, *seen: tuple[str, Measure], turns: bool = True
    ) -> ContactFrame:
        """names: the symbols of d."""
        moves = tuple(Displacement(point, origin, along) for along in axes)
        called = ((s.name, move) for s, move in zip(names, moves, strict=True) if isinstance(s, Symbol))
        return cls(point.body, axes, moves, (*called, *seen), turns)

    def composed(self, expression: Expr, dimension: Dimension) -> Composed:
        """A measure of what occurs in it, so that places share what they have in common."""
        own = free_symbols(expression)
        return Composed(expression, tuple(item for item in self.seen if item[0] in own), dimension, here=True)

    def slip(self, along: Components, arm: Components | None = None) -> NonholonomicForm:
        """The velocity along a direction, of the point itself or at an arm from it."""
        return self.slip_by_moment(along, None if arm is None else vector_product(arm, along))

    def slip_by_moment(self, along: Components, moment: Components | None) -> NonholonomicForm:
        """With r x t already known."""
        terms: list[tuple[Measure, Measure]] = [
            (self.composed(c, DIMENSIONLESS), move) for c, move in zip(along, self.moves, strict=True) if c != ZERO
        ]
        terms += [] if moment is None else self._rotating(moment, LENGTH)
        return NonholonomicForm(tuple(terms), LENGTH)

    def turning(self, along: Components) -> NonholonomicForm:
        """The angular velocity along a direction."""
        return NonholonomicForm(tuple(self._rotating(along, DIMENSIONLESS)), DIMENSIONLESS)

    def _rotating(self, along: Components, dimension: Dimension) -> list[tuple[Measure, Measure]]:
        terms: list[tuple[Measure, Measure]] = []
        if not self.turns:
            return terms
        e = self.axes
        for k, c in enumerate(along):
            if c == ZERO:
                continue
            p, q = e[(k + 1) % 3], e[(k + 2) % 3]
            for a in body_axes(self.mover):
                expression = -c * Symbol("@c")
                own = free_symbols(expression)
                seen = (*(item for item in self.seen if item[0] in own), ("@c", Alignment(q, a)))
                terms.append((Composed(expression, seen, dimension, here=True), Alignment(p, a)))
        return terms
