"""A motion that repeats itself: after which time, and how far it gets to each side.

By the law of the coordinate where it has one, else by the first integral of energy (`way`): the period is the integral
of dq/u there and back, the farthest places are the zeros of u(q)^2 next to the start.
"""

from __future__ import annotations

from freebody.errors import CannotAnswer, NeverHappens, NotReached
from freebody.language.sentences import Message
from freebody.symbolic.law_ranges import extent_by_law, period_by_law
from freebody.symbolic.laws import LawInstant, first
from freebody.symbolic.motion_laws import MotionLaws
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.reached import HoldsOnce, Reached
from freebody.symbolic.signs import Sign, sign_of
from freebody.symbolic.unknowns import Coordinate


class MotionCycles(MotionLaws):
    """The period and the extent of a motion, and the first of the instants at which a law has a value."""

    def period(self, c: Coordinate) -> Reached:
        """After which time a coordinate is where it was at the start, and as fast. Raises NeverHappens where it does
        not come back, CannotAnswer where no closed form is found."""
        q0, u0 = self.start.of(c.index), self.start.of(c.speed)
        if self.stands_still:
            raise NeverHappens(Message("it starts at rest in an equilibrium, and stays there"))
        law = self.law_of(c, takes_side=self._takes_side)
        if law is not None:
            return period_by_law(law, c.name, c)
        way = self.way_of(c)
        found = way.period()
        if found is None:
            raise CannotAnswer(
                Message(
                    "no closed form was found for the period: the time is neither elementary nor an elliptic integral "
                    "of the first kind"
                )
            )
        time, needs, says = found
        return Reached(time, c, q0, u0, [], needs, says=says, integral=way.integral)

    def period_of_sum(self, value: Ratio, name: str) -> Reached:
        """The same of a measure that is linear in several coordinates and moves by a law of its own."""
        return period_by_law(self.law_of_sum(value), name)

    def extent(self, c: Coordinate, side: int) -> Reached:
        """The farthest place of a coordinate above (side > 0) or below."""
        q0 = self.start.of(c.index)
        if self.stands_still:
            return Reached(self.field.zero, c, q0, self.field.zero)
        try:
            self.speed_squared(c, self.field.variable(c.index))
        except CannotAnswer:
            law = self.law_of(c, takes_side=True)
            if law is None:
                raise CannotAnswer(Message("no closed form was found for how far it gets")) from None
            return extent_by_law(law, c.name, side, c)
        at, needs, says = self.way_of(c).extent(side)
        return Reached(None, c, at, self.field.zero, [], needs, says=says)

    def ends(self, c: Coordinate) -> tuple[Ratio, Ratio]:
        """The least and the greatest place of a coordinate. Raises CannotAnswer, NeverHappens or NotReached where it
        has none, or none in closed form."""
        low, high = (self.extent(c, side).at for side in (-1, 1))
        return low, high

    def extent_of_sum(self, value: Ratio, name: str, side: int) -> Reached:
        """The same of a measure that is linear in several coordinates and moves by a law of its own."""
        return extent_by_law(self.law_of_sum(value), name, side)

    def _first(
        self, c: Coordinate | None, name: str, instants: list[LawInstant], needs: list[tuple[Ratio, str]]
    ) -> Reached:
        """The first instant after the start. Raises NeverHappens where it is proved that there is none."""
        found = first(self.model, instants)
        if found is None:
            if any(sign_of(x) is Sign.NEGATIVE for x, _relation in needs):
                raise NeverHappens(Message("{x} does not get that far", x=name))
            if instants and all(i.period is None and _is_past(i) for i in instants):
                raise NeverHappens(Message("{x} does not get there after the start", x=name))
            if all(i.time.is_zero() and i.period is None for i in instants):
                raise HoldsOnce if instants else NeverHappens(Message("{x} only tends to that", x=name))
            raise NotReached(Message("{x} does not get there at any of the parameter values that were tried", x=name))
        i = found.instant
        lowest = self.field.lowest_terms
        return Reached(lowest(i.time), c, lowest(i.place), lowest(i.rate), [], [*needs, *found.conditions])


def _is_past(instant: LawInstant) -> bool:
    """Whether an instant is proved to be before the start."""
    return instant.key is not None and not instant.key.is_zero() and sign_of(instant.key) is Sign.NEGATIVE
