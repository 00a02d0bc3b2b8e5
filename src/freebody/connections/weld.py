"""Weld: two bodies keep their relative pose."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, ClassVar

from freebody.connections.base import Connection, coincidence
from freebody.connections.joints import meeting
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS
from freebody.measures.angle import Angle
from freebody.measures.combination import Combination
from freebody.measures.geometry import ONE, Direction, Point
from freebody.measures.turn import Alignment
from freebody.model import glyphs
from freebody.model.chains import read_chain
from freebody.model.elements import Attitude, ConstraintRow, RigidBody
from freebody.model.glyphs import Glyph
from freebody.model.rotations import UNIT, Columns, columns_of, product, transposed

if TYPE_CHECKING:
    from freebody.model.names import Names


class Weld(Connection, kind="weld"):
    """`weld: [ground.A, beam.start]`. Two points coincide and the angle between the bodies stays as it is at
    the start (3 rows). In space the second body is `turned` from the first by known rotations, such as [30 deg about
    x]; without any it stays as both are `turned` at the start, else parallel to the first (6 rows)."""

    called: ClassVar[tuple[str, ...]] = ("clamp", "fixed support", "wall")
    also: ClassVar[tuple[str, ...]] = (
        *("clamp", "clamped", "fixed", "rigid", "welded", "glued", "built_in", "fixed_support", "cantilever"),
        *("Einspannung", "eingespannt", "starr"),
    )

    instead: ClassVar[Mapping[str, str]] = dict.fromkeys(
        ("sticks", "stick", "sticks_to", "embeds", "embedded", "lodges", "stays_in", "inelastic", "bleibt_stecken"),
        Message(
            "what strikes and stays is a weld that closes: weld: [bullet, rod.end], closes: at start, which also says "
            "where it is then"
        ),
    )
    meeting = ("first", "second")

    first: str
    second: str
    turned: str | list[str] | None = None

    is_rigid: ClassVar[bool] = True
    example = """
bodies: {beam: {rod: {mass: 1 kg, length: 1 m}}}
connections: {it: {weld: [ground.A, beam.start]}}
"""

    def rows(self, names: Names) -> list[ConstraintRow]:
        first, second = names.point(self.first, "first"), names.point(self.second, "second")
        if first.body == second.body:
            names.problem(Message("welds {body} to itself; name points of two bodies", body=first.body))
            return []
        if names.space:
            return self._in_space(names, first, second)
        if self.turned is not None:
            names.problem(Message("turned is for models in space; in the plane the bodies keep the angle of the start"))
        rows = coincidence(first, second)
        if names.known(first.body).turns and names.known(second.body).turns:
            angle = Angle(second.body, first.body)
            rows.append(ConstraintRow("angle", "moment", Combination(((ONE, angle),), DIMENSIONLESS)))
        return rows

    def _in_space(self, names: Names, first: Point, second: Point) -> list[ConstraintRow]:
        rows = meeting(first, second)
        if not (names.known(first.body).turns and names.known(second.body).turns):
            return rows
        x, y, _z = (Direction(first.body, column) for column in self._turned(names, first.body, second.body))
        own_y, own_z = (Direction(second.body, UNIT[k]) for k in (1, 2))
        # a multiplier of w . u, w on the second body, is a moment on it along w x u
        return [
            *rows,
            ConstraintRow("moment x", "moment", Alignment(own_z, y), sign=-1),
            ConstraintRow("moment y", "moment", Alignment(own_z, x)),
            ConstraintRow("moment z", "moment", Alignment(own_y, x), sign=-1),
        ]

    def _turned(self, names: Names, first: str, second: str) -> Columns:
        """How the second body is turned from the first: as is said here, else as both stand at the start."""
        if self.turned is not None:
            return columns_of(read_chain(names, self.turned, "turned", named=False))
        one, other = (_at_start(names.known(body)) for body in (first, second))
        return UNIT if one is None or other is None else product(transposed(one), other)

    def attitude(self, names: Names) -> Attitude | None:
        if not names.space:
            return None
        first, second = names.point(self.first, "first"), names.point(self.second, "second")
        rows = ("moment x", "moment y", "moment z")
        return Attitude(first.body, second.body, self._turned(names, first.body, second.body), UNIT, (), rows)

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        yield glyphs.Weld(names.point(self.first), names.point(self.second))


def _at_start(body: RigidBody) -> Columns | None:
    """The axes of a body at the start, where they are known."""
    if body.start.turned is None:
        return UNIT if body.fixed else None
    return None if any(turn.name for turn in body.start.turned) else columns_of(body.start.turned)
