"""Spherical joint (ball and socket): two points coincide, the bodies turn freely about them."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, ClassVar

from freebody.connections.base import Connection
from freebody.connections.joints import meeting
from freebody.language.sentences import Message
from freebody.model import glyphs
from freebody.model.elements import ConstraintRow
from freebody.model.glyphs import Glyph

if TYPE_CHECKING:
    from freebody.model.names import Names


class Spherical(Connection, kind="spherical"):
    """`spherical: [ground.A, rod.start]`. Holds r_second - r_first = 0 (3 rows)."""

    space_only = True
    in_plane_take = "pin"

    called: ClassVar[tuple[str, ...]] = ("ball joint", "ball", "ball and socket", "joint", "socket")
    also: ClassVar[tuple[str, ...]] = ("ball_joint", "ball_and_socket", "ball_socket", "Kugelgelenk")

    meeting = ("first", "second")

    first: str
    second: str

    example = """
space: true
bodies: {rod: {box: {mass: 1 kg, size: [1 m, 0.1 m, 0.2 m]}}}
connections: {it: {spherical: [ground.A, rod.left]}}
"""

    def rows(self, names: Names) -> list[ConstraintRow]:
        first, second = names.point(self.first, "first"), names.point(self.second, "second")
        if first.body == second.body:
            names.problem(Message("joins {body} to itself; name points of two bodies", body=first.body))
            return []
        return meeting(first, second)

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        yield glyphs.Ball(names.point(self.first), names.point(self.second))
