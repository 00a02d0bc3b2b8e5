"""Pin (revolute joint): two points coincide, the bodies turn freely about them."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any, ClassVar, Literal, cast

from freebody.connections.base import Connection, coincidence
from freebody.connections.standing import begins_without_turning, ground_guide_of, stands_at
from freebody.language.expression import Expr
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, LENGTH
from freebody.measures.angle import Angle
from freebody.measures.geometry import GROUND, Direction, Point
from freebody.model import glyphs
from freebody.model.elements import ConstraintRow, DryFriction, UnilateralConstraint
from freebody.model.friction import read_friction
from freebody.model.glyphs import Glyph
from freebody.model.spec import Formula

if TYPE_CHECKING:
    from freebody.model.names import Names


_POINT = re.compile(r"\s*[^\W\d]\w*\.[^\W\d]\w*\s*")  # body.point, which no number or parameter is


class Pin(Connection, kind="pin"):
    """`pin: [ground.A, rod.start]`. Holds r_second - r_first = 0 (2 rows). `friction` with the `radius` of the journal:
    the torque that resists is mu r times the force in the pin. A node where several bodies meet is
    `pin: [ground.A, one.end, two.start, three.start]`: each of the `further` ones is pinned to the first by a pin of
    its own, called by the name of the node and its number (node_2, node_3)."""

    called: ClassVar[tuple[str, ...]] = ("hinge", "pivot", "axle", "bearing", "pin joint", "joint", "axis")
    also: ClassVar[tuple[str, ...]] = (
        "hinge",
        "revolute",
        "pivot",
        "axle",
        "bearing",
        "revolute",
        "pinned",
        "hinged",
        "pin_support",
        "Gelenk",
        "Lager",
        "Festlager",
        "Drehgelenk",
        "Scharnier",
    )

    meeting = ("first", "second")
    elsewhere: ClassVar[Mapping[str, str]] = dict.fromkeys(
        ("parent", "child"),
        Message("it names the points that meet, of the ground and of bodies: {{first: ground.A, second: arm.start}}"),
    )

    first: str
    second: str
    friction: Formula | dict[str, Any] = 0
    radius: Formula | None = None
    further: tuple[str, ...] = ()

    in_plane = True
    in_space_take: ClassVar[Message | None] = Message(
        "a hinge is revolute: {{first: ground.A, second: rod.start, about: z}}, and a ball joint is spherical"
    )
    lets_turn: ClassVar[bool] = True
    with_copies: ClassVar[Literal["", "each", "together"]] = "each"
    example = """
bodies: {rod: {rod: {mass: 1 kg, length: 1 m}}}
connections: {it: {pin: [ground.A, rod.start]}}
"""

    @classmethod
    def from_plain(cls, value: object) -> dict[str, Any]:
        items = cast("list[Any]", value) if isinstance(value, list) else []
        if len(items) > 2 and any(isinstance(each, str) and _POINT.fullmatch(each) for each in items[2:]):
            return {"first": items[0], "second": items[1], "further": tuple(items[2:])}
        return super().from_plain(value)

    def rows(self, names: Names) -> list[ConstraintRow]:
        first, second = names.point(self.first, "first"), names.point(self.second, "second")
        if first.body == second.body:
            names.problem(Message("pins {body} to itself; name points of two bodies", body=first.body))
            return []
        return coincidence(first, second)

    def keeps_as_one(self, names: Names) -> bool:
        """A particle in the middle of a wheel is where the wheel is."""
        with names.quietly():
            points = names.point(self.first, "first"), names.point(self.second, "second")
        bodies = [names.known(point.body) for point in points]
        is_middle = all(point.offset == body.center.offset for point, body in zip(points, bodies, strict=True))
        return is_middle and not all(body.turns for body in bodies) and all(body.name != GROUND for body in bodies)

    def joined_points(self, names: Names) -> tuple[Point, Point]:
        return names.point(self.first, "first"), names.point(self.second, "second")

    def keeps_at(self, names: Names, point: Point, along: Direction, seen: frozenset[str]) -> Expr | None:
        other = self._joined_to(names, point)
        return None if other is None else stands_at(names, other, along, seen)

    def carried_by(self, names: Names, point: Point) -> Point | None:
        other = self._joined_to(names, point)
        return None if other is None or ground_guide_of(names, other.body, turning=False) is None else other

    def bears_at(self, names: Names, point: Point, normal: Direction) -> Expr | None:
        """Where a guided body that does not turn carries it."""
        other = self.carried_by(names, point)
        return None if other is None else begins_without_turning(names, other, normal)

    def _joined_to(self, names: Names, point: Point) -> Point | None:
        """The point of the other body at one that it joins."""
        if point.body not in self.mentions(names):
            return None
        with names.quietly():
            first, second = self.joined_points(names)
        for own, other in ((first, second), (second, first)):
            if (own.body, own.offset) == (point.body, point.offset):
                return other
        return None

    def bounds(self, names: Names, connection: str) -> tuple[list[UnilateralConstraint], list[DryFriction]]:
        friction = read_friction(names, self.friction, DIMENSIONLESS)
        if friction.is_none:
            return [], []
        radius = names.optional(self, "radius", LENGTH)
        bodies = [names.point(text, key).body for key, text in (("first", self.first), ("second", self.second))]
        if radius is None:
            names.problem(Message("friction in a pin acts at the radius of its journal; give radius"), "friction")
            return [], []
        for key, body in zip(("first", "second"), bodies, strict=True):
            if not names.known(body).turns:
                names.problem(Message("{body} is a particle; friction in a pin needs bodies that turn", body=body), key)
        row = ConstraintRow("friction", "friction torque", Angle(bodies[1], bodies[0]), connection=connection)
        load = (f"{connection}.x", f"{connection}.y")
        return [], [DryFriction(row, friction.static * radius, friction.kinetic * radius, load)]

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        yield glyphs.Pin(names.point(self.first), names.point(self.second))
