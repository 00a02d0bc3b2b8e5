"""Chain on two sprockets: by its pitch and their teeth.

The teeth take the links one by one, so that in the mean the sprockets turn as z_2 : z_1, as a belt would turn pulleys
of the radii p z/(2 pi). (The hinges of the links run on circles of the radius p/(2 sin(pi/z)); the unevenness within a
tooth, some (pi/z)^2/2 of the speed, is left out.) The tight run is at the angle gamma to the line of centres,
sin(gamma) = (r_1 - r_2)/d, and pulls the sprockets together by F cos(gamma): what is held is the way of that run,

    r_1 theta_1 - r_2 theta_2 - (r_1 - r_2) a + s cos(gamma) d,        a the bearing of the second from the first,

s the sign of F. As d is constant, the motion is that without the last term. Source: Shigley, Mechanical Engineering
Design, sec. 17-5.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, ClassVar

from freebody.connections.base import Connection
from freebody.connections.belt_in_space import BeltInSpace, belt_in_space, lies_flat, own_plane
from freebody.connections.belt_loop import BeltLoop, distance_of_centers
from freebody.connections.circles import touching
from freebody.connections.teeth import read_teeth
from freebody.language.expression import PI, Expr, divide
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, LENGTH
from freebody.measures.combination import Combination
from freebody.measures.distance import Distance
from freebody.model import glyphs
from freebody.model.elements import ConstraintRow
from freebody.model.glyphs import Glyph
from freebody.model.pressed_side import TightRun
from freebody.model.spec import Formula
from freebody.model.transmitted import Transmitted

if TYPE_CHECKING:
    from freebody.model.names import Names

_LEAST_TEETH = 3


class Chain(Connection, kind="chain"):
    """`chain: {first: crank, second: hub, pitch: 12.7 mm, teeth: [44, 16]}`: both sprockets turn the same way, with the
    ratio of their teeth; bearings keep the centres apart. The chain force is the tension of the tight run, as the other
    one is slack; it is positive when it resists a counter-clockwise turn of the first sprocket (1 row), or negative
    with `other_run: true`, where the other run is the tight one. It pulls at the bearings, too. In space it runs over
    sprockets with parallel axes whose bearings are on one body."""

    first: str
    second: str
    pitch: Formula
    teeth: list[Formula]
    length: Formula | None = None
    other_run: bool = False

    in_plane = True
    follows_joints: ClassVar[bool] = True
    example = """
bodies: {a: {body: {inertia: 1 kg m^2}}, b: {body: {inertia: 1 kg m^2}, at: [0.4 m, 0]}}
ground: {points: {A: [0, 0], B: [0.4 m, 0]}}
connections: {p: {pin: [ground.A, a]}, q: {pin: [ground.B, b]}, it: {chain: {first: a, second: b, pitch: 12.7 mm,
  teeth: [44, 16]}}}
"""

    def is_in_plane(self, names: Names) -> bool:
        return lies_flat(names, (self.first, self.second))

    def rows(self, names: Names) -> list[ConstraintRow]:
        first, second = names.body(self.first, "first"), names.body(self.second, "second")
        if first.name == second.name:
            names.problem(Message("a chain needs two sprockets, not {first} twice", first=first.name))
            return []
        r1, r2 = self._radii(names)
        self._loop(names).look(names, names.optional(self, "length", LENGTH))
        if self.is_in_plane(names):
            distance, _total, rolled = touching(first.center, r1, second.center, r2, internal=True)
        elif (spatial := belt_in_space(names, (first, second), (r1, r2), crossed=False)) is not None:
            distance, rolled = Distance(first.center, second.center), spatial.rolled
        else:
            return []
        lean = self._loop(names).lean
        if lean is None:
            return [ConstraintRow("chain", "chain force", rolled, sign=-1)]
        side = -1 if self.other_run else 1
        tight, other = (Combination((*rolled.terms, (s * lean, distance)), LENGTH) for s in (side, -side))
        return [ConstraintRow("chain", "chain force", tight, sign=-1, pressed=TightRun(side, other))]

    def loads_bearings(self, names: Names) -> Mapping[str, str]:
        if self._loop(names).lean is not None:
            return {}
        told = Message(
            "{chain} pulls at it as well, and the model does not say where its sprockets are",
            chain=self.own_name(names),
        )
        return {self.first: told, self.second: told}

    def _radii(self, names: Names) -> tuple[Expr, Expr]:
        pitch = names.above_zero(self, "pitch", LENGTH)
        r1, r2 = (divide(pitch * z, 2 * PI) for z in read_teeth(names, self.teeth, _LEAST_TEETH))
        return r1, r2

    def _in_space(self, names: Names) -> BeltInSpace | None:
        with names.quietly():
            return own_plane(names, (self.first, self.second), self._radii(names))

    def _loop(self, names: Names) -> BeltLoop:
        first, second = names.known(self.first), names.known(self.second)
        if (spatial := self._in_space(names)) is not None:
            return BeltLoop(self._radii(names), spatial.distance)
        return BeltLoop(self._radii(names), distance_of_centers(names, first, second))

    def transmitted(self, names: Names) -> Mapping[str, Transmitted]:
        length = self._loop(names).length
        if length is None:
            return {}
        links = divide(length, names.positive(self, "pitch", LENGTH))
        return {"length": Transmitted(length, LENGTH), "links": Transmitted(links, DIMENSIONLESS)}

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        if (spatial := self._in_space(names)) is not None:
            yield from spatial.glyphs()
            return
        centers = names.body(self.first).center, names.body(self.second).center
        yield glyphs.Belt(*centers, self._radii(names))
