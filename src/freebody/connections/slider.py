"""Slider (prismatic joint): a body moves along a straight guide and does not turn against it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from freebody.connections.base import Connection
from freebody.connections.standing import along_of, arm_on_ground, is_parallel, stands_at
from freebody.language.expression import Expr, add, multiply
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, LENGTH
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.combination import Combination
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, ONE, ZERO, Components, Direction, Point
from freebody.model import glyphs
from freebody.model.elements import ConstraintRow, DryFriction, RigidBody, UnilateralConstraint
from freebody.model.friction import read_friction
from freebody.model.glyphs import Glyph, Turning
from freebody.model.spec import Formula, Heading

if TYPE_CHECKING:
    from freebody.model.names import Names


@dataclass(frozen=True)
class Guide:
    """A straight guide of a point: the measure across it, and the one along it."""

    across: Measure
    travel: Displacement

    @property
    def direction(self) -> Direction:
        return self.travel.along

    def glyph(self, point: Point, turning: Turning) -> Glyph:
        """The rail of a point; it goes through a point of the line, where one is known."""
        through = self.across.origin if isinstance(self.across, Displacement) else None
        return glyphs.Rail(through, point, self.direction, turning)


def guide(
    names: Names,
    point: Point,
    along: Heading,
    on: str,
    through: str | None,
    *,
    keeps_angle: bool = False,
    seen: frozenset[str] = frozenset(),
) -> Guide:
    """A guide goes through the point that is named for it; one on the ground else through where the body is put
    (`at`); else through the line that it is named by; one on the ground else through where the body is said to be near,
    else where a string leads the body along it, else through the origin; one on a body through where the other one is
    put if both are, else through its reference point.
    keeps_angle: the body does not turn, so that its `at` is the place of all its points; seen: bodies whose places are
    being asked for."""
    line = names.edge_along(along)
    direction = names.direction(along, "along", body=names.body(on, "on").name)
    start = names.known(point.body).start
    origin, is_kept = Point(GROUND, (ZERO, ZERO), "ground.origin"), False
    if through is not None:
        origin = names.point(_of_slotted(names, through, direction.body), "through")
        _refuse_own_point(names, point, origin)
    elif line is not None:
        origin = line.through
        is_kept = direction.body == GROUND and _is_put(names, point, keeps_angle=keeps_angle)
    elif direction.body != GROUND:
        base = names.known(direction.body)
        origin = base.point()
        is_kept = base.start.at is not None and _is_put(names, point, keeps_angle=keeps_angle)
    elif start.at is not None or start.near is not None:
        is_kept = True
    else:
        level = _led(names, point, direction.normal(), seen | {point.body})
        if level is not None:
            on_line = Point(GROUND, tuple(multiply(level, c) for c in direction.normal().components), "ground.origin")
            return Guide(Displacement(point, on_line, direction.normal()), Displacement(point, origin, direction))
    across = Displacement(point, origin, direction.normal())
    kept = Combination(((ONE, across),), LENGTH) if is_kept else across
    return Guide(kept, Displacement(point, origin, direction))


def _of_slotted(names: Names, through: str, slotted: str) -> str:
    """A plain name is that of a point of the body with the slot, where it has one and neither a body nor a declared
    point of the ground is called so."""
    name = through.strip()
    on_ground = {p for p in names.known(GROUND).points if p != "origin"}
    is_plain = name not in names.bodies and name not in on_ground
    return f"{slotted}.{name}" if is_plain and name in names.known(slotted).points else through


def _refuse_own_point(names: Names, guided: Point, through: Point) -> None:
    """A line that goes along with what it guides holds nothing: the displacement of a point from itself is zero."""
    if through.body == guided.body:
        told = Message(
            "{point} moves with what is guided; name a point of the guide, or put the body there with at",
            point=through.name,
        )
        names.problem(told, "through")


def ground_guide(names: Names, body: str, guided: str, along: Heading, on: str) -> Direction | None:
    """The direction of a guide of this body, if it is one of the ground. guided: what the guide holds."""
    if guided.partition(".")[0] != body or on != GROUND:
        return None
    direction = names.direction(along, "along")
    return direction if direction.body == GROUND else None


def _is_put(names: Names, point: Point, *, keeps_angle: bool) -> bool:
    """Whether the model says where on the ground a point is at the start."""
    body = names.known(point.body)
    if body.start.at is None:
        return False
    return keeps_angle or body.start.angle is not None or body.points[body.start.at[0]] == point.offset


def _led(names: Names, point: Point, normal: Direction, seen: frozenset[str]) -> Expr | None:
    """Where other connections, such as strings, lead a point that is not placed, along the normal of its guide."""
    for connection in names.connections.values():
        if not isinstance(connection, Slider):
            place = connection.keeps_at(names, point, normal, seen)
            if place is not None:
                return place
    return None


EITHER_WAY = {  # a guide, or a line, runs both ways
    **dict.fromkeys(("horizontal", "waagerecht", "waagrecht"), "right"),
    **dict.fromkeys(("vertical", "vertikal", "senkrecht"), "up"),
}


class Slider(Connection, kind="slider"):
    """`slider: {body: block, along: right}`; `on` is the guiding body (default the ground), `through` a point
    of the guide. Holds the displacement across the guide and the angle (2 rows).
    `friction`: the force that resists is mu times the normal force."""

    called: ClassVar[tuple[str, ...]] = ("guide", "rail", "track")
    also: ClassVar[tuple[str, ...]] = ("guide", "Führung", "Schiebehülse", "Schubgelenk", "Schieber", "prismatic")

    elsewhere: ClassVar[Mapping[str, str]] = {
        "bodies": Message("it guides one body: write one for each of them, {{body: cart, along: right}}")
    }

    body: str
    along: Heading
    on: str = GROUND
    through: str | None = None
    friction: Formula | dict[str, Any] = 0

    in_plane = True
    in_space_take: ClassVar[Message | None] = Message(
        "a straight guide is prismatic: {{first: ground.A, second: block, along: x}}, and that of a particle or of one "
        "point of a body point_on_line: {{point: collar, through: ground.A, along: x}}"
    )
    has_contact_point = True
    example = """
bodies: {block: {rectangle: {mass: 1 kg, width: 1 m, height: 1 m}}}
connections: {it: {slider: {body: block, along: right}}}
"""

    @classmethod
    def from_plain(cls, value: object) -> dict[str, Any]:
        """`{body: block, on: wedge.slope}`: along the line that it is on."""
        given = super().from_plain(value)
        given["along"] = EITHER_WAY.get(str(given.get("along")), given.get("along"))
        if given["along"] is None:
            del given["along"]
        if "along" not in given and isinstance(line := given.get("on"), str) and line != GROUND:
            owner, dot, _name = line.partition(".")
            given |= {"along": line, "on": owner if dot else GROUND}
        return given

    def rows(self, names: Names) -> list[ConstraintRow]:
        point = names.point(self.body, "body")
        rail = self._guide(names, point)
        direction = rail.direction
        if point.body == direction.body:
            names.problem(Message("{body} cannot slide on itself; name another body with on", body=point.body))
            return []
        rows = [ConstraintRow("normal", "normal force", rail.across)]
        if names.known(point.body).turns and names.known(direction.body).turns:
            angle = Angle(point.body, direction.body)
            roller = Message("a slider does not let {body} turn; a roller is a slot for a point of it", body=point.body)
            rows.append(ConstraintRow("angle", "moment", Combination(((ONE, angle),), DIMENSIONLESS), instead=roller))
        return rows

    def _guide(self, names: Names, point: Point, seen: frozenset[str] = frozenset()) -> Guide:
        return guide(names, point, self.along, self.on, self.through, keeps_angle=True, seen=seen)

    def keeps_at(self, names: Names, point: Point, along: Direction, seen: frozenset[str]) -> Expr | None:
        if point.body != self.body.partition(".")[0]:
            return None
        with names.quietly():
            guided, body = names.point(self.body, "body"), names.known(point.body)
            normal = names.direction(self.along, "along", body=self.on).normal()
            beside = guided.offset != point.offset
            if not is_parallel(names, normal, along) or (names.space and beside):
                return None
            if self.through is None and body.start.at is not None:
                return _at_start(names, body, body.start.at, point, along)
            rail = self._guide(names, guided, seen)
        if not isinstance(rail.across, Displacement):
            return None
        level = stands_at(names, rail.across.origin, along, seen)
        if level is None or not beside:
            return level
        return add(level, along_of(arm_on_ground(body, guided.offset, point.offset), along))

    def guide_of(self, names: Names, body: str, *, turning: bool) -> Direction | None:
        return ground_guide(names, body, self.body, self.along, self.on)

    def bounds(self, names: Names, connection: str) -> tuple[list[UnilateralConstraint], list[DryFriction]]:
        friction = read_friction(names, self.friction, DIMENSIONLESS)
        if friction.is_none:
            return [], []
        point = names.point(self.body, "body")
        travel = self._guide(names, point).travel
        row = ConstraintRow("friction", "friction force", travel, connection=connection)
        return [], [DryFriction(row, friction.static, friction.kinetic, (f"{connection}.normal",))]

    def offers(self, names: Names) -> Iterable[tuple[str, Measure]]:
        point = names.point(self.body, "body")
        yield "travel", self._guide(names, point).travel

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        point = names.point(self.body)
        rail = self._guide(names, point)
        yield rail.glyph(point, "not")


def _at_start(names: Names, body: RigidBody, at: tuple[str, Components], point: Point, along: Direction) -> Expr | None:
    """Where a point of a body that does not turn starts, by where another one does."""
    name, place = at
    if body.points[name] == point.offset:
        return along_of(place, along)
    if names.space:
        return None
    arm = arm_on_ground(body, body.points[name], point.offset)
    return along_of(tuple(add(p, a) for p, a in zip(place, arm, strict=True)), along)
