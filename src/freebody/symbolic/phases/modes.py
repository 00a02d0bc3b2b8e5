"""The motion of a phase whose coordinates are coupled linearly: each by its modes in the time, and what is linear in
them by the law that it has itself, as the way between two carts on a spring has,

    m1 x1'' = k s,   m2 x2'' = -k s,   s = x2 - x1:    s'' = -k (1/m1 + 1/m2) s.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.symbolic.coupled import CoupledMotion
from freebody.symbolic.laws.base import Instants, MotionLaw
from freebody.symbolic.motion import SmoothMotion
from freebody.symbolic.phases.course import CourseZero, MotionInTime, units_of, within_a_period
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.unknowns import Coordinate


class ModalMotion(MotionInTime):
    """Coordinates by laws of their own, or several together by their modes. Raises CannotAnswer where one has none."""

    def __init__(self, smooth: SmoothMotion) -> None:
        super().__init__(smooth.model, smooth.start, smooth.integrals.resting)
        self.smooth = smooth
        self.laws: list[tuple[Coordinate, MotionLaw]] = []
        self.coupled: list[CoupledMotion] = []
        for c in self.model.coordinates:
            if c.index in self.still or any(c in group.coordinates for group in self.coupled):
                continue
            law = smooth.law_of(c)
            if law is not None and law.has_course:
                self.laws.append((c, law))
            elif (group := smooth.coupled(c)) is not None:
                self.coupled.append(group)
            else:
                raise CannotAnswer(Message("no law of motion was found for {x}", x=c.name))

    @property
    def kind(self) -> str:
        return "laws"

    @property
    def units_of_time(self) -> Sequence[Ratio]:
        of_modes = [1 / w for group in self.coupled for w in group.rates]
        return [*units_of([law for _c, law in self.laws]), *of_modes]

    def values(self, time: Ratio) -> dict[int, Ratio]:
        """Coordinates and speeds at a time."""
        f = self.model.field
        found: dict[int, Ratio] = {f.index(f.time): time, **self.still}
        for c, law in self.laws:
            found[c.index], found[c.speed] = map(f.lowest_terms, law.at(time))
        for group in self.coupled:
            found |= group.at(time)
        return found

    def along(self, x: Ratio) -> list[Ratio]:
        raise CannotAnswer(Message("it is no polynomial in the time"))

    def zeros(self, x: Ratio) -> list[CourseZero]:
        """Of factors that are linear in the coordinates, or in their rates, and move by laws of their own. Raises
        CannotAnswer for any other."""
        f = self.model.field
        found: list[CourseZero] = []
        for base, _exponent in f.factor(self.plain(x).num)[1]:
            if f.ingredients(base) & self.model.moving:
                found += self._zeros_of(base)
        return found

    def _zeros_of(self, base: Ratio) -> Iterator[CourseZero]:
        instants = self._instants(base)
        if instants is None:
            raise CannotAnswer(Message("it has no closed form in the time"))
        for time, _instant, needs in within_a_period(instants):
            yield CourseZero(time, self.values(time), needs=needs)

    def _instants(self, base: Ratio) -> Instants:
        """When a sum of coordinates and constants vanishes, or one of their rates."""
        f, inside = self.model.field, self.model.field.ingredients(base)
        places = [c for c in self.model.coordinates if c.index in inside]
        rates = [c for c in self.model.coordinates if c.speed in inside]
        if bool(places) == bool(rates):
            return None
        if places:
            law = self.smooth.law_together(base, places)
            return None if law is None else law.places(f.zero)
        slopes = [f.partial(base, c.speed) for c in rates]
        rest = f.follow(base, {c.speed: f.zero for c in rates})
        value = sum((slope * f.variable(c.index) for slope, c in zip(slopes, rates, strict=True)), f.zero)
        law = self.smooth.law_together(value, rates) if rest.is_constant() else None
        return None if law is None else law.rates(-rest)
