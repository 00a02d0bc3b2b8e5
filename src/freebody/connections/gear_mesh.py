"""Gear mesh: pitch circles roll on each other, outside or inside a ring gear, on fixed or moving centres."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, ClassVar

from freebody.connections.base import Connection
from freebody.connections.circles import own_radius, touching
from freebody.language.expression import Expr, negate
from freebody.language.sentences import Message
from freebody.model import glyphs
from freebody.model.elements import ConstraintRow
from freebody.model.glyphs import Glyph
from freebody.model.spec import Formula

if TYPE_CHECKING:
    from freebody.model.names import Names


class GearMesh(Connection, kind="gear_mesh"):
    """`gear_mesh: [sun, planet]`, `gear_mesh: {first: ring, second: planet, internal: true}` with the ring gear
    first. The tooth force acts along the common tangent of the pitch circles (pressure angle 0) and is positive
    when it resists a counter-clockwise turn of the first gear. The distance of the centres is held too where no
    carrier or bearing holds it already (1 or 2 rows). `first_radius`, `second_radius` for a wheel with several
    gears on it."""

    called: ClassVar[tuple[str, ...]] = ("mesh", "gear")

    first: str
    second: str
    internal: bool = False
    first_radius: Formula | None = None
    second_radius: Formula | None = None

    in_plane = True
    example = """
bodies: {a: {disk: {mass: 1 kg, radius: 1 m}}, b: {disk: {mass: 1 kg, radius: 1 m}, at: [2 m, 0]}}
ground: {points: {A: [0, 0], B: [2 m, 0]}}
connections: {p: {pin: [ground.A, a]}, q: {pin: [ground.B, b]}, it: {gear_mesh: [a, b]}}
"""

    def rows(self, names: Names) -> list[ConstraintRow]:
        first, second = names.body(self.first, "first"), names.body(self.second, "second")
        if first.name == second.name:
            names.problem(Message("{first} cannot mesh with itself", first=first.name))
            return []
        r1, r2 = self._radii(names)
        distance, total, rolled = touching(first.center, r1, second.center, r2, internal=self.internal)
        return [
            ConstraintRow("teeth", "tooth force", rolled, sign=-1),
            ConstraintRow("centers", "radial force", distance, total, if_needed=True),
        ]

    def _radii(self, names: Names) -> tuple[Expr, Expr]:
        return own_radius(names, self, "first"), own_radius(names, self, "second")

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        r1, r2 = self._radii(names)
        radii = (r1, negate(r2) if self.internal else r2)
        yield glyphs.Wheels(names.body(self.first).center, names.body(self.second).center, radii, is_toothed=True)
