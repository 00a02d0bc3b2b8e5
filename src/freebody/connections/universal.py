"""Universal joint (cardan, Hooke's joint): two points coincide, two axes through them stay perpendicular."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from freebody.connections.base import Connection
from freebody.connections.joints import meeting, own_direction
from freebody.language.expression import Symbol
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.measures.geometry import ZERO
from freebody.measures.turn import Alignment
from freebody.model import glyphs
from freebody.model.elements import Attitude, ConstraintRow, Rotation
from freebody.model.glyphs import Glyph
from freebody.model.named_angles import angles_of
from freebody.model.rotations import UNIT, dot
from freebody.model.spec import Heading

if TYPE_CHECKING:
    from freebody.model.names import Names


class Universal(Connection, kind="universal"):
    """`universal: {first: ground.A, second: shaft.start, arm: x, second_arm: y}`: a cross with two perpendicular arms,
    one in each yoke: `arm` by components on the first body, `second_arm` on the second. Holds the points and the right
    angle between the arms (4 rows)."""

    space_only = True
    in_plane_take = "pin"

    meeting = ("first", "second")

    first: str
    second: str
    arm: Heading
    second_arm: Heading

    example = """
space: true
bodies: {shaft: {cylinder: {mass: 1 kg, radius: 0.1 m, length: 1 m}}}
connections: {it: {universal: {first: ground.A, second: shaft.start, arm: x, second_arm: y}}}
"""

    def rows(self, names: Names) -> list[ConstraintRow]:
        first, second = names.point(self.first, "first"), names.point(self.second, "second")
        if first.body == second.body:
            names.problem(Message("joins {body} to itself; name points of two bodies", body=first.body))
            return []
        arms = [
            own_direction(names, arm, point.body, key)
            for arm, point, key in ((self.arm, first, "arm"), (self.second_arm, second, "second_arm"))
        ]
        for arm, point, key in zip(arms, (first, second), ("arm", "second_arm"), strict=True):
            if arm.body != point.body:
                names.problem(Message("{key} must be fixed in {body}", key=key, body=point.body), key)
        return [*meeting(first, second), ConstraintRow("cross", "cross moment", Alignment(arms[1], arms[0]))]

    def attitude(self, names: Names) -> Attitude | None:
        if not names.space:
            return None
        first, second = names.point(self.first, "first"), names.point(self.second, "second")
        arm = own_direction(names, self.arm, first.body, "arm").components
        other = own_direction(names, self.second_arm, second.body, "second_arm").components
        if dot(arm, other) != ZERO:
            return None  # the bodies are not parallel at zero
        chain = [Rotation(arm, Symbol("1"), "1"), Rotation(other, Symbol("2"), "2")]
        measures = angles_of(names, chain, second.body, first.body)
        turns = tuple((turn.axis, turn.name, measures[turn.name]) for turn in chain)
        return Attitude(first.body, second.body, UNIT, UNIT, turns, ("cross",))

    def offers(self, names: Names) -> Iterable[tuple[str, Measure]]:
        found = self.attitude(names)
        for _axis, name, measure in found.turns if found is not None else ():
            yield name, measure

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        first, second = names.point(self.first), names.point(self.second)
        arms = own_direction(names, self.arm, first.body), own_direction(names, self.second_arm, second.body)
        yield glyphs.Cross(first, second, arms)
