"""The way of a belt or a chain round two wheels: its length, and over what angle it wraps the smaller one.

With the distance d of the centres, an open belt leaves both wheels at sin(gamma) = (R - r)/d from across the line of
centres, a crossed one at (R + r)/d:

    open       2 d cos(gamma) + pi (R + r) + 2 gamma (R - r)          wraps the smaller wheel by pi - 2 gamma
    crossed    2 d cos(gamma) + (pi + 2 gamma) (R + r)                wraps both by pi + 2 gamma

Source: Shigley, Mechanical Engineering Design, sec. 17-1.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from freebody.connections.standing import number_of, stands_at
from freebody.language.expression import ONE, PI, ZERO, Call, Expr, add, negate
from freebody.language.sentences import Message
from freebody.measures.geometry import RIGHT, UP
from freebody.model.elements import RigidBody
from freebody.tolerances import ROUND_OFF

if TYPE_CHECKING:
    from freebody.model.names import Names

_SHORT = 1e-2  # of the length of a belt: what it lacks beyond that is no round-off of what is written


@dataclass(frozen=True)
class BeltLoop:
    """Two wheels with a belt round them; distance: of their centres, where the model tells."""

    radii: tuple[Expr, Expr]
    distance: Expr | None
    is_crossed: bool = False

    @property
    def _lift(self) -> Expr | None:
        """gamma, where it is told: of equal wheels it is zero."""
        r1, r2 = self.radii
        if not self.is_crossed and add(r1, negate(r2)) == ZERO:
            return ZERO
        return None if self.distance is None else Call("asin", self._step / self.distance)

    @property
    def _step(self) -> Expr:
        r1, r2 = self.radii
        return r1 + r2 if self.is_crossed else r1 - r2

    @property
    def lean(self) -> Expr | None:
        """cos(gamma): the part of the tension of a run along the line of centres."""
        lift, d = self._lift, self.distance
        if lift is None or lift == ZERO:
            return None if lift is None else ONE
        return None if d is None else Call("sqrt", d * d - self._step * self._step) / d

    def wrap(self, names: Names) -> Expr | None:
        """The angle of the wheel that slips first."""
        lift = self._lift
        if lift is None or self.is_crossed:
            return None if lift is None else PI + 2 * lift
        is_first_smaller = number_of(names, self._step) < 0
        return PI + 2 * lift if is_first_smaller else PI - 2 * lift

    @property
    def length(self) -> Expr | None:
        """Of the belt."""
        lift, d = self._lift, self.distance
        if lift is None or d is None:
            return None
        r1, r2 = self.radii
        straight = 2 * d if lift == ZERO else 2 * Call("sqrt", d * d - self._step * self._step)
        bent = 2 * lift * self._step
        return straight + PI * (r1 + r2) + (ZERO if lift == ZERO else bent)

    def look(self, names: Names, given: Expr | None) -> None:
        """Notes wheels that overlap, and a belt whose length is not that of its way. given: its length."""
        d = None if self.distance is None else names.numeric(self.distance)
        reach = names.numeric(self.radii[0] + self.radii[1])
        if d is not None and reach is not None and d < reach * (1.0 - ROUND_OFF):
            told = Message(
                "the wheels overlap: their centres are {d:.4g} m apart, and their radii need more than {reach:.4g} m",
                d=d,
                reach=reach,
            )
            names.problem(told)
            return
        needed, has = (None if x is None else names.numeric(x) for x in (self.length, given))
        if needed is not None and has is not None and abs(has - needed) > _SHORT * needed:
            told = Message(
                "the belt is {has:.5g} m long, and its way round the wheels {needed:.5g} m: change its length, or the "
                "distance of the centres",
                has=has,
                needed=needed,
            )
            names.problem(told, "length")


def distance_of_centers(names: Names, first: RigidBody, second: RigidBody) -> Expr | None:
    """How far two wheels are apart, where bearings hold both and the model says where."""
    places = [[stands_at(names, wheel.center, along) for along in (RIGHT, UP)] for wheel in (first, second)]
    if any(x is None for place in places for x in place):
        return None
    (x1, y1), (x2, y2) = places
    dx, dy = add(x2, negate(x1)), add(y2, negate(y1))  # pyrefly: ignore[bad-argument-type]
    if dy == ZERO or dx == ZERO:
        along = dx if dy == ZERO else dy
        return along if number_of(names, along) >= 0 else negate(along)
    return Call("sqrt", dx * dx + dy * dy)
