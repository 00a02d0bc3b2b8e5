"""The laws by which the coordinates of a model move from its start, and their ways by energy.

A coordinate whose acceleration depends on nothing that moves but itself has a law of its own (`laws/`), several that
are coupled linearly have one together; where energy is conserved M u^2/2 + V tells the speed at a place.
"""

from __future__ import annotations

from collections.abc import Generator
from contextlib import contextmanager
from functools import cached_property

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.symbolic.blocks import apart_from
from freebody.symbolic.coupled import CoupledMotion, accelerations_together, coupled_with
from freebody.symbolic.first_integrals import FirstIntegrals, is_driven
from freebody.symbolic.laws import Freely, MotionLaw, law_of
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.start import StartState
from freebody.symbolic.unknowns import Coordinate
from freebody.symbolic.way import EnergyPath


class MotionLaws:
    """How the coordinates of a model move from its start."""

    def __init__(self, model: SymbolicModel, start: StartState) -> None:
        self.model = model
        self.start = start
        self.field = model.field
        self.integrals = FirstIntegrals(model, start)
        self._integrals = dict[int, FirstIntegrals]()
        self._on_one_side = False

    def coupled(self, c: Coordinate) -> CoupledMotion | None:
        """How a coordinate moves with those to which it is coupled linearly."""
        return coupled_with(self.model, self.start, c, self.acceleration)

    @cached_property
    def stands_still(self) -> bool:
        """True where it is proved that nothing ever moves: no speed and no acceleration at the start, nothing that
        depends on time, and laws smooth enough for the motion to be unique (Lipschitz; no root or sign of zero)."""
        f, model = self.field, self.model
        if any(not self.start.of(c.speed).is_zero() for c in model.coordinates) or is_driven(model):
            return False
        now = {k: x for k, x in self.start.values.items() if k != f.index(f.time)}
        try:
            accelerations = [model.in_independent_speeds(a) for a in model.dynamics.solved_accelerations.values()]
            for a in accelerations:
                for g in a.generators():
                    kind, (name, argument) = f.generators[g].kind, f.arguments.get(g, ("", f.one))
                    if kind == "root" and f.follow(f.radicand(g), now).is_zero():
                        return False
                    if name == "sign" and f.follow(argument, now).is_zero():
                        return False
            return all(f.follow(a, now).is_zero() for a in accelerations)
        except (CannotAnswer, ZeroDivisionError):
            return False

    @property
    def _in_time(self) -> set[int]:
        """The generators of the time and of given functions of it."""
        return {g for g, generator in self.field.generators.items() if generator.kind == "time"}

    # -- laws of motion -----------------------------------------------------------------------
    def acceleration(self, c: Coordinate) -> Ratio:
        """Of a coordinate, as a function of coordinates, speeds and time."""
        k = self.model.coordinates.index(c)
        found = self.field.lowest_terms(self.model.dynamics.solved_accelerations[self.model.accelerations[k]])
        still = self.integrals.resting  # coordinates that stay where they start are no variables
        return self.integrals.on_its_line(self.field.lowest_terms(self.field.follow(found, still))) if still else found

    def law_of(self, c: Coordinate, *, takes_side: bool = False, keeps_sense: bool = False) -> MotionLaw | None:
        """How a coordinate moves by itself, where that is one of the laws that have closed forms. takes_side: whether
        what parameters decide may be as it is at the first sample; that is then assumed. keeps_sense: whether it is
        followed only as long as its rate keeps its sense; then it may be, too."""
        q0, u0 = self.start.of(c.index), self.start.of(c.speed)
        return law_of(Freely(self.model, c, self._by_itself(c), q0, u0, takes_side or keeps_sense, keeps_sense))

    def _by_itself(self, c: Coordinate) -> Ratio:
        """The acceleration of a coordinate, without the rates of others that are known by its place."""
        a = self.acceleration(c)
        others = {o.speed for o in (*self.model.coordinates, *self.model.dependent) if o != c}
        if not self.field.ingredients(a) & others:
            return a
        return accelerations_together(self.model, self.start, c, self.acceleration).get(c, a)

    def law_of_sum(self, value: Ratio) -> MotionLaw:
        """The law of a measure that is linear in several coordinates. Raises CannotAnswer where it has none."""
        inside = self.field.ingredients(value)
        law = self.law_together(value, [c for c in self.model.coordinates if c.index in inside])
        if law is None:
            raise CannotAnswer(Message("no closed form was found for that: it moves by no law of its own"))
        return law

    def law_together(self, value: Ratio, found: list[Coordinate]) -> MotionLaw | None:
        """The law of a measure that is linear in several coordinates, and whose acceleration depends on nothing that
        moves but itself: the way between bodies that fall, or between two masses on a spring."""
        f = self.field
        found = [c for c in found if not f.partial(value, c.index).is_zero()]
        slopes = [f.partial(value, c.index) for c in found]
        rest = value
        for slope, c in zip(slopes, found, strict=True):
            rest = rest - slope * f.variable(c.index)
        if not found or not all(x.is_constant() for x in (*slopes, rest)):
            return None
        q0, u0, a = rest, f.zero, f.zero
        for slope, c in zip(slopes, found, strict=True):
            q0, u0 = q0 + slope * self.start.of(c.index), u0 + slope * self.start.of(c.speed)
            a = a + slope * self.acceleration(c)
        # the measure takes the place of the first coordinate; its acceleration may depend on no other then
        first, others = found[0], range(1, len(found))
        own, rate = f.variable(first.index) - rest, f.variable(first.speed)
        for k in others:
            own = own - slopes[k] * f.variable(found[k].index)
            rate = rate - slopes[k] * f.variable(found[k].speed)
        a = f.lowest_terms(f.follow(a, {first.index: own / slopes[0], first.speed: rate / slopes[0]}))
        moving = Freely(self.model, first, a, f.lowest_terms(q0), f.lowest_terms(u0), self._takes_side)
        return law_of(moving) if moving.is_alone else None

    @cached_property
    def _takes_side(self) -> bool:
        """Whether laws may take a side: where no integral of energy serves for all of them."""
        try:
            self.integrals.potential({})
        except CannotAnswer:
            return True
        return False

    # -- first integral -----------------------------------------------------------------------
    def integrals_of(self, c: Coordinate) -> FirstIntegrals:
        """Those that give the speed of a coordinate: of all of the model, or where these do not suffice, and it has no
        law of its own, of what it moves together with."""
        if c.index not in self._integrals:
            is_told = self.integrals.suffice_for(c) or self.law_of(c) is not None
            apart = () if is_told else apart_from(self.model, c)
            self._integrals[c.index] = FirstIntegrals(self.model, self.start, apart) if apart else self.integrals
        return self._integrals[c.index]

    def way_of(self, c: Coordinate) -> EnergyPath:
        """The way of a coordinate by energy."""
        square = self.speed_squared(c, self.field.variable(c.index))
        a0 = self.field.follow(self.acceleration(c), self.start.values)
        start = self.start.of(c.index), self.start.of(c.speed), a0
        coasts = self.integrals_of(c).coasts(c)
        return EnergyPath(self.model, c, square, start, takes_side=self._on_one_side, coasts=coasts)

    @contextmanager
    def on_one_side(self) -> Generator[None]:
        """Ways by energy are told as they are at the first sample, where parameters decide."""
        self._on_one_side = True
        try:
            yield
        finally:
            self._on_one_side = False

    def is_told_as(self, other: MotionLaws) -> None:
        """Tells ways by energy on one side if the motion of another model is told so."""
        self._on_one_side = other._on_one_side

    def speed_squared(self, c: Coordinate, at: Ratio) -> Ratio:
        """u^2 at q = at."""
        return self.integrals_of(c).speed_squared(c, at)
