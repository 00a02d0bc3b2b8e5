"""Pin in a slot: a point of one body moves along a straight slot of another; both may turn."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any, ClassVar

from freebody.connections.base import Connection
from freebody.connections.slider import EITHER_WAY, ground_guide, guide
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS
from freebody.measures.base import Measure
from freebody.measures.geometry import GROUND, Direction
from freebody.model.elements import ConstraintRow, DryFriction, UnilateralConstraint
from freebody.model.friction import read_friction
from freebody.model.glyphs import Glyph
from freebody.model.spec import Formula, Heading

if TYPE_CHECKING:
    from freebody.model.names import Names


_SLOTTED = ("slot_in", "slot_of", "slotted", "slotted_in", "in_slot_of")  # what people call the body with the slot


class Slot(Connection, kind="slot"):
    """`slot: {pin: rod.end, along: up}`; `on` is the slotted body (default the ground), `through` a point of
    the slot's centre line. Holds the displacement across the slot (1 row). `friction`: the force that resists is mu
    times the normal force. A support on rollers is `roller: {at: beam.end, on: floor}`, or `along: right`."""

    called: ClassVar[tuple[str, ...]] = ("guide", "groove", "roller")
    also: ClassVar[tuple[str, ...]] = ("guide", "groove", "roller", "roller_support", "Loslager", "slider")

    said_by_word: ClassVar[Mapping[str, Mapping[str, str]]] = {
        word: {"along": "right"} for word in ("roller", "roller_support", "Loslager")
    }
    more_words: ClassVar[Mapping[str, tuple[str, ...]]] = {
        "of": ("pin",),
        **dict.fromkeys(_SLOTTED, ("on",)),
    }

    meeting = ("through", "pin")

    pin: str
    along: Heading
    on: str = GROUND
    through: str | None = None
    friction: Formula | dict[str, Any] = 0

    in_plane = True
    in_space_take: ClassVar[Message | None] = Message(
        "the guide of a point is point_on_line: {{point: rod.end, through: ground.A, along: x}}"
    )
    has_contact_point = True
    example = """
bodies: {rod: {rod: {mass: 1 kg, length: 1 m}}}
connections: {it: {slot: {pin: rod.end, along: right}}}
"""

    @classmethod
    def from_plain(cls, value: object) -> dict[str, Any]:
        """A support on rollers is `{at: beam.end, on: floor}`: what it is on is the direction in which it is free."""
        given = super().from_plain(value)
        slotted = next((word for word in _SLOTTED if isinstance(given.get(word), str)), None)
        if slotted is not None and "on" not in given:
            given["on"] = given.pop(slotted)
        if "of" in given and "pin" not in given:
            given["pin"] = given.pop("of")
        if "along" not in given and given.get("on", GROUND) != GROUND:
            given["along"] = given.pop("on")
        if str(given.get("along")) in EITHER_WAY:
            given["along"] = EITHER_WAY[str(given["along"])]
        return given

    def rows(self, names: Names) -> list[ConstraintRow]:
        point = names.point(self.pin, "pin")
        rail = guide(names, point, self.along, self.on, self.through)
        if point.body == rail.direction.body:
            names.problem(Message("the pin and the slot are both on {body}", body=point.body))
            return []
        return [ConstraintRow("normal", "normal force", rail.across)]

    def guide_of(self, names: Names, body: str, *, turning: bool) -> Direction | None:
        return ground_guide(names, body, self.pin, self.along, self.on) if turning else None

    def bounds(self, names: Names, connection: str) -> tuple[list[UnilateralConstraint], list[DryFriction]]:
        friction = read_friction(names, self.friction, DIMENSIONLESS)
        if friction.is_none:
            return [], []
        point = names.point(self.pin, "pin")
        travel = guide(names, point, self.along, self.on, self.through).travel
        row = ConstraintRow("friction", "friction force", travel, connection=connection)
        return [], [DryFriction(row, friction.static, friction.kinetic, (f"{connection}.normal",))]

    def offers(self, names: Names) -> Iterable[tuple[str, Measure]]:
        point = names.point(self.pin, "pin")
        yield "travel", guide(names, point, self.along, self.on, self.through).travel

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        point = names.point(self.pin)
        yield guide(names, point, self.along, self.on, self.through).glyph(point, "about")
