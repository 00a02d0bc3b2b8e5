"""Components of angular velocities and of velocities of points, as measures of rates.

With p, q fixed in a body E and p x q = e, the angular velocity of a body A against E along e is

    omega_AE . e = - sum_i (q . a_i) d(p . a_i)/dt,      a_i the axes of A,

since d(p . a_i)/dt = p . (omega x a_i) and sum_i (q . a_i) a_i = q.
"""

from __future__ import annotations

from freebody.language.expression import ONE, Expr, Symbol, number
from freebody.language.units import DIMENSIONLESS, LENGTH
from freebody.measures.base import Measure
from freebody.measures.combination import Composed
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, Direction, Point
from freebody.measures.turn import Alignment
from freebody.model.elements import NonholonomicForm
from freebody.model.rotations import UNIT, perpendiculars

Terms = list[tuple[Measure, Measure]]


def constant(value: Expr) -> Composed:
    """A number as the coefficient of a rate."""
    return Composed(value, (), DIMENSIONLESS)


def body_axes(body: str) -> tuple[Direction, Direction, Direction]:
    x, y, z = (Direction(body, along) for along in UNIT)
    return x, y, z


def spin(body: str, along: Direction, against: str = GROUND) -> NonholonomicForm:
    """The angular velocity of a body against another one along a direction, which may be fixed in any body."""
    return NonholonomicForm(tuple(spin_terms(body, along, against)), DIMENSIONLESS)


def spin_terms(body: str, along: Direction, against: str = GROUND) -> Terms:
    """That angular velocity as coefficients of rates."""
    terms: Terms = []
    if body != along.body:
        terms += _turning(body, along, -1)
    if against != along.body:
        terms += _turning(against, along, 1)
    return terms


def _turning(body: str, along: Direction, sign: int) -> Terms:
    b, c = perpendiculars(along.components)
    p, q = Direction(along.body, b), Direction(along.body, c)
    return [
        (Composed(number(sign) * Symbol("c"), (("c", Alignment(q, a)),), DIMENSIONLESS), Alignment(p, a))
        for a in body_axes(body)
    ]


def velocity_of_place(
    center: Point, arm: list[tuple[Measure, Direction]], along: Direction, origin: Point
) -> NonholonomicForm:
    """The velocity, seen from the body of the origin and of `along`, of the material point of a body that is now at
    center + sum of c_j b_j, b_j fixed in the body and c_j its components there at this instant."""
    terms: Terms = [(constant(ONE), Displacement(center, origin, along))]
    terms += [(coefficient, Alignment(b, along)) for coefficient, b in arm]
    return NonholonomicForm(tuple(terms), LENGTH)
