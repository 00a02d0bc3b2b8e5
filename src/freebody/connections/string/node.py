"""A place on a string's way."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from freebody.language.expression import Expr, add, negate
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.geometry import ONE, ZERO, Direction, Point
from freebody.model import glyphs


@dataclass(frozen=True)
class WheelPlane:
    """In space: the plane in which a string runs round a wheel, by its normal, along which the axis of the wheel stays,
    and two directions in it with along x side = normal, all of the ground; by how much the wheel turns about it, and a
    point of what carries it."""

    normal: Direction
    along: Direction
    side: Direction
    turned: tuple[tuple[Expr, Measure], ...]
    carrier: Point

    def reversed(self) -> WheelPlane:
        """The same plane seen from behind."""
        turned = tuple((negate(share), angle) for share, angle in self.turned)
        return WheelPlane(self.normal.reversed(), self.side, self.along, turned, self.carrier)


@dataclass(frozen=True)
class StringNode:
    """A place on the string's way: an end, a pulley it runs over or under, or a drum it is wound on."""

    point: Point
    radius: Expr
    way: str  # "end", "over", "under", "around", "drum"
    side: str | None
    turn: str | None
    hangs: bool
    is_put: bool  # it would hang, but for its place, which the model gives
    guide: Direction | None  # the lead runs along it
    track: Direction | None  # of a body that is guided where the model puts it
    place: tuple[float, float] | None
    plane: WheelPlane | None = None  # of a wheel in space, where it need not be that of x and y
    falls: Expr = ONE  # how many times the string runs to it from the place before

    @property
    def body(self) -> str:
        return self.point.body

    @property
    def called(self) -> tuple[str, ...]:
        """Names by which people ask for the tension there: the body, the point where it is one of several."""
        return tuple(dict.fromkeys((str(self.point), self.body)))

    @property
    def turned(self) -> tuple[tuple[Expr, Measure], ...]:
        """By how much it turns counter-clockwise, as seen against its axis."""
        return ((ONE, Angle(self.body)),) if self.plane is None else self.plane.turned

    def drawn(self, arm: Expr) -> glyphs.Node[Point, Direction, Expr]:
        """The place as it is drawn. arm: at which the string pulls on its circle."""
        is_drum, plane = self.way == "drum", self.plane
        if plane is None:
            return glyphs.Node(self.point, arm, is_drum)
        return glyphs.Node(self.point, arm, is_drum, plane.normal, plane.carrier)


def aside(way: Sequence[StringNode], arms: Sequence[Expr], k: int) -> Expr:
    """rho of lead k, s_2 R_2 - s_1 R_1 (see `measures.lead`). The falls of a tackle run beside each other from sheaves
    on one axle to such ones of the same size, each with rho = 0."""
    return add(arms[k + 1], negate(arms[k])) if way[k + 1].falls == ONE else ZERO
