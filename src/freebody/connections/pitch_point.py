"""Teeth in space: a force that acts between two wheels at their pitch point, each of which turns in a bearing.

A force F d at P on a wheel does the work of F on the measure

    d . (r_Q - r_B) + ((P - Q) x d) . a  theta + ((P - Q) x d) . (small tilts of the axis),

with Q the point of the wheel that its bearing holds at B of the carrier, and theta its turn about its axis a there.
Only theta ever changes; the other terms are the forces and moments by which the teeth load the bearings. The difference
of the measures of two wheels is the way by which their flanks pass into each other along d: it is held. The carrier
feels nothing of the teeth but through the bearings. Source: Norton, Design of Machinery, 5th ed. 2012, sec. 9.7.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from freebody.connections.joints import AXES
from freebody.connections.shared_by_copies import gathered
from freebody.language.expression import ONE, ZERO, Expr, negate
from freebody.language.sentences import Message
from freebody.language.units import LENGTH
from freebody.measures.base import Measure
from freebody.measures.combination import Combination
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import Components, Direction, Point
from freebody.measures.turn import Alignment, Turn
from freebody.model.rotations import dot, perpendiculars, vector_product

if TYPE_CHECKING:
    from freebody.model.names import Names

Terms = list[tuple[Expr, Measure]]


@dataclass(frozen=True)
class BornWheel:
    """A wheel in its bearing: a point of each of both that coincide, and the axis, on the carrier and on the wheel."""

    held: Point
    bearing: Point
    axis: Direction
    own_axis: Direction

    @property
    def at(self) -> Components:
        return self.bearing.offset

    def outwards(self, *, reverse: bool) -> BornWheel:
        """The same with its axis the other way round, if wanted."""
        if not reverse:
            return self
        return BornWheel(self.held, self.bearing, _back(self.axis), _back(self.own_axis))

    def turn(self) -> Turn:
        """How far it has turned about its axis on the carrier."""
        b, c = (Direction(self.axis.body, v) for v in perpendiculars(self.axis.components))
        across, _ = perpendiculars(self.own_axis.components)
        return Turn(Direction(self.own_axis.body, across), b, c)

    def pushed(self, place: Components, along: Components) -> Terms:
        """The measure of a force along a direction at a place, both by components on the carrier."""
        carrier, a = self.axis.body, self.axis.components
        axes = [Direction(carrier, e.components) for e in AXES]
        terms: Terms = [(d, Displacement(self.held, self.bearing, e)) for d, e in zip(along, axes, strict=True)]
        moment = vector_product(tuple(p - q for p, q in zip(place, self.at, strict=True)), along)
        b, c = perpendiculars(a)
        # a tilting axis moves towards b with omega . c, towards c with -omega . b
        terms.append((dot(moment, a), self.turn()))
        terms.append((dot(moment, c), Alignment(self.own_axis, Direction(carrier, b))))
        terms.append((negate(dot(moment, b)), Alignment(self.own_axis, Direction(carrier, c))))
        return [(size, measure) for size, measure in terms if size != ZERO]


def _back(axis: Direction) -> Direction:
    return Direction(axis.body, tuple(negate(c) for c in axis.components))


def born_wheel(names: Names, wheel: str, carrier: str, field: str) -> BornWheel | None:
    """A wheel of a mesh by the joint that carries it; None after noting a problem at the field that names it."""
    for other in names.connections.values():
        with names.quietly():
            joint = other.bearing(names) if {wheel, carrier} <= other.mentions(names) else None
        if joint is not None:
            one, two, axis, axis2 = joint
            return BornWheel(two, one, axis, axis2) if one.body == carrier else BornWheel(one, two, axis2, axis)
    told = Message(
        "no bearing of {wheel} on {carrier}: teeth need a revolute joint there", wheel=wheel, carrier=carrier
    )
    names.problem(told, field)
    return None


def meshing(wheels: Sequence[BornWheel], place: Components, along: Components) -> Combination:
    """The way by which the flanks of two wheels would pass into each other along a direction at a place."""
    first, second = (wheel.pushed(place, along) for wheel in wheels)
    return Combination((*first, *((negate(size), measure) for size, measure in second)), LENGTH)


def shared(meshes: Sequence[Combination]) -> Combination:
    """What is held of the meshes of equal planets: the sum, so that its multiplier is the tooth force of each."""
    return Combination(gathered(term for mesh in meshes for term in mesh.terms), LENGTH)


def combined(*parts: tuple[Expr, Components]) -> Components:
    """A sum of multiples of vectors."""
    total: Components = (ZERO, ZERO, ZERO)
    for size, vector in parts:
        total = tuple(t + size * v for t, v in zip(total, vector, strict=True))
    return total


def between(first: Components, second: Components) -> Components:
    """From the second place to the first."""
    return combined((ONE, first), (negate(ONE), second))
