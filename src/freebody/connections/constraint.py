"""A user's own constraints: an expression in measures that stays zero, and one linear in their rates."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from freebody.connections.base import Connection
from freebody.errors import ExpressionError, UnitError
from freebody.language.expression import Symbol, differentiate, free_symbols, number, replace_rates, substitute
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, TIME, dimension_of
from freebody.measures.combination import Composed
from freebody.measures.geometry import GROUND
from freebody.model import glyphs
from freebody.model.elements import ConstraintRow, NonholonomicForm
from freebody.model.glyphs import Glyph
from freebody.model.phrases import composed

if TYPE_CHECKING:
    from freebody.model.names import Names


class Constraint(Connection, kind="constraint"):
    """`constraint: x - 2*y`: an expression in named measures, held at zero (1 row, holonomic)."""

    expression: str

    example = """
bodies: {bead: {particle: {mass: 1 kg}}}
measures: {x: x of bead, y: y of bead}
connections: {it: {constraint: x - 2*y}}
"""

    def rows(self, names: Names) -> list[ConstraintRow]:
        measure = composed(names, self.expression, "expression")
        return [] if measure is None else [ConstraintRow("constraint", "constraint force", measure)]

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        return _equation(names, self)


class VelocityConstraint(Connection, kind="velocity_constraint"):
    """`velocity_constraint: rate(y)*cos(theta) - rate(x)*sin(theta)`: an expression linear in the rates of
    named measures, held at zero (1 row; nonholonomic unless it can be integrated)."""

    expression: str

    example = """
bodies: {skate: {rod: {mass: 1 kg, length: 1 m}}}
measures: {x: x of skate, y: y of skate, theta: angle of skate}
connections: {it: {velocity_constraint: rate(y)*cos(theta) - rate(x)*sin(theta)}}
"""

    def rows(self, names: Names) -> list[ConstraintRow]:
        try:
            expr = names.parsed(self.expression)
            if free_symbols(expr) & names.broken:
                return []
            known = names.dimensions() | {n: m.dimension for n, m in names.measures.items()}
            dimension = dimension_of(expr, known)
        except (ExpressionError, UnitError) as error:
            names.problem(str(error), "expression")
            return []
        swapped = replace_rates(expr, {n: Symbol(f"@{n}") for n in names.measures})
        rated = sorted(n for n in names.measures if f"@{n}" in free_symbols(swapped))
        terms: list[tuple[Composed, Composed]] = []
        rest = swapped
        for name in rated:
            coefficient = differentiate(swapped, f"@{name}")
            rest = substitute(rest, {f"@{name}": number(0)})
            if any(symbol.startswith("@") for symbol in free_symbols(coefficient)):
                names.problem(Message("the expression is not linear in rate({name})", name=name), "expression")
                return []
            used = sorted(free_symbols(coefficient) & set(names.measures))
            parts = tuple((n, names.measures[n]) for n in used)
            own = names.measures[name]
            terms.append(
                (
                    Composed(coefficient, parts, DIMENSIONLESS),
                    Composed(Symbol(name), ((name, own),), own.dimension),
                )
            )
        if not terms:
            names.problem(Message("there is no rate in it; write rate(x) for the rate of x"), "expression")
            return []
        if rest != number(0):
            names.problem(
                Message("every term needs a rate: freebody holds sums of coefficient*rate(measure) at zero"),
                "expression",
            )
            return []
        measure = NonholonomicForm(tuple(terms), (dimension or DIMENSIONLESS / TIME) * TIME)
        return [ConstraintRow("constraint", "constraint force", measure)]

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        return _equation(names, self)


def _equation(names: Names, held: Constraint | VelocityConstraint) -> Iterable[Glyph]:
    """A line through the bodies that an expression speaks of, and the expression at the first one."""
    bodies = dict.fromkeys(body for row in held.rows(names) for body in row.measure.bodies())
    points = tuple(names.known(body).center for body in bodies if body != GROUND)
    yield glyphs.Relation(points)
    yield from (glyphs.Equation(point, f"{held.expression} = 0") for point in points[:1])
