"""The motion of one phase by its first integral, and the choice of the closed form that a phase has.

    u^2 = (M0 u0^2 + 2 V0 - 2 V(q))/M(q)

What is even in u is a function of q; speeds of other coordinates follow by their momenta.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence, Set
from contextlib import suppress
from functools import cached_property

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.symbolic.blocks import apart_from
from freebody.symbolic.field import Field
from freebody.symbolic.first_integrals import FirstIntegrals, is_driven, staying_of
from freebody.symbolic.laws.base import MotionLaw
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.motion import SmoothMotion
from freebody.symbolic.phases.course import ClosedFormMotion, CourseZero, LawMotion, UniformMotion
from freebody.symbolic.phases.modes import ModalMotion
from freebody.symbolic.quadratic import has_no_real_root, roots
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.start import StartState
from freebody.symbolic.unknowns import Coordinate
from freebody.symbolic.zeros import reals, without_root, zeros_of


class EnergyMotion(ClosedFormMotion):
    """One coordinate by the first integral of energy; the speeds of others, on which nothing depends, by momenta.
    beside: the laws of coordinates that move apart from it (`blocks.py`), whose energy is no part of the integral."""

    @property
    def kind(self) -> str:
        return "energy"

    def __init__(
        self,
        model: SymbolicModel,
        start: StartState,
        coordinate: Coordinate,
        beside: Mapping[Coordinate, MotionLaw] | None = None,
    ) -> None:
        super().__init__(model, start, {})
        self.coordinate, self.beside = coordinate, dict(beside or {})
        self.integrals, f = FirstIntegrals(model, start, tuple(self.beside)), model.field
        self.integrals.keeps_side = True
        integrals = self.integrals
        # u^2 as a function of q
        self.square = f.lowest_terms(integrals.speed_squared(coordinate, f.variable(coordinate.index)))
        not_told = {coordinate.speed, *(k.speed for k in self.beside)}
        self._others = {k: x for k, x in integrals.speeds(coordinate).items() if k not in not_told}

    @property
    def cyclic(self) -> tuple[Coordinate, ...]:
        """The coordinates whose speeds momenta give."""
        others = (k for k in self.model.coordinates if k is not self.coordinate)
        return tuple(k for k in others if k.index not in {*self.integrals.resting, *self.integrals.apart})

    def reduced(self, x: Ratio) -> Ratio:
        """With the speeds that momenta give put in. Raises CannotAnswer where it depends on another coordinate."""
        x = self._with_momenta(x)
        if others := self._met(x):
            raise CannotAnswer(Message("it depends on {names} as well", names=", ".join(c.name for c in others)))
        return x

    def _with_momenta(self, x: Ratio) -> Ratio:
        x = self.model.in_independent_speeds(x)
        if not self._others:
            return x
        return self.integrals.on_its_line(self.model.field.follow(x, {**self._others, **self.integrals.resting}))

    def _met(self, x: Ratio) -> list[Coordinate]:
        if not self._others and not self.beside:
            return []
        inside = self.model.field.ingredients(self.model.field.lowest_terms(x))
        others = [c for c in self.model.coordinates if c is not self.coordinate]
        return [c for c in others if inside & {c.index, c.speed}]

    def depends_on_others(self, x: Ratio) -> bool:
        """Whether a function of the state depends on coordinates of which the integral does not give the places."""
        return bool(self._met(self._with_momenta(x)))

    def rate_of(self, k: Coordinate) -> Ratio:
        """The speed of a cyclic coordinate, as a function of the coordinate and its speed."""
        return self._others[k.speed]

    def in_course(self, x: Ratio, tau: Ratio) -> Ratio:
        """A function of the state as one of the coordinate, its speed, the places of cyclic coordinates and the time
        since the phase began."""
        own = {g: x for c, law in self.beside.items() for g, x in zip((c.index, c.speed), law.at(tau), strict=True)}
        return self.model.field.follow(self._with_momenta(x), own)

    def is_odd(self, x: Ratio) -> bool:
        """Whether a function of the state changes its sign with the direction of the motion."""
        parts = self.reduced(x).numerator().coefficients(self.coordinate.speed)
        return all(part.is_zero() for part in parts[::2])

    def is_even_or_odd(self, x: Ratio) -> bool:
        """Whether the direction of the motion changes nothing of a function of the state but its sign: then the energy
        tells where it vanishes."""
        parts = self.reduced(x).numerator().coefficients(self.coordinate.speed)
        return any(all(part.is_zero() for part in parts[k::2]) for k in (0, 1))

    def as_function(self, x: Ratio) -> Ratio:
        """A function of the state as one of the coordinate; one that is odd in the speed times the speed. Raises
        CannotAnswer where it is neither odd nor even."""
        f, speed = self.model.field, self.coordinate.speed
        odd = int(self.is_odd(x))
        x = self.reduced(x)
        total = f.zero
        for k, part in enumerate(x.numerator().coefficients(speed)):
            if (k + odd) % 2 and not part.is_zero():
                raise CannotAnswer(Message("it depends on the direction of the motion"))
            if not part.is_zero():
                total = total + part * self.square ** ((k + odd) // 2)
        if speed in x.denominator().generators():
            raise CannotAnswer(Message("it has the speed in a divisor"))
        return f.lowest_terms(total / x.denominator())

    def along(self, x: Ratio) -> list[Ratio]:
        return [self.as_function(x)]

    def zeros(self, x: Ratio) -> list[CourseZero]:
        return [self.at(value, 1) for value in self.places(x)]

    def places(self, x: Ratio) -> list[Ratio]:
        """Values of the coordinate at which a function of the state vanishes. One that is odd in the speed is the speed
        times another, and vanishes with either: where sines and cosines stand in it, their product has no factors."""
        if x.is_zero() or not self.is_odd(x):
            return self.zeros_of(self.as_function(x))
        beside = self.zeros_of(self.as_function(x / self.model.field.variable(self.coordinate.speed)))
        return [*beside, *(at for at in self.zeros_of(self.square) if at not in beside)]

    def zeros_of(self, x: Ratio) -> list[Ratio]:
        """Values of the coordinate at which a function of it vanishes; of a polynomial up to the second degree."""
        f, index = self.model.field, self.coordinate.index
        x = without_root(x, index)
        _unit, factors = f.factor(x.num)
        found: list[Ratio] = []
        for base, _exponent in factors:
            parts = base.coefficients(index) if index in base.generators() else []
            if has_no_real_root(parts):
                continue
            if len(parts) == 3 and not any(index in f.ingredients(p) for p in parts):
                found += roots(parts, self.model.samples.is_negative) or []
            elif index in f.ingredients(base):
                found += zeros_of(self.model, base, self.coordinate)
        return found

    def at(self, value: Ratio, way: int) -> CourseZero:
        """The state at a value of the coordinate, on a way on which it grows (+1) or falls (-1); not when."""
        f, c = self.model.field, self.coordinate
        if any(f.arguments[g][0] == "atan" for g in value.generators() if g in f.arguments):
            return CourseZero(
                None, {c.index: value}, value
            )  # its cosine is made of nested roots: no form to go on from
        square = f.lowest_terms(f.follow(self.square, {c.index: value}))
        own = {c.index: value, c.speed: way * f.sqrt(square, self.model.samples.is_negative)}
        others = {k: f.follow(x, own) for k, x in self._others.items()}
        if self._others:
            others |= self.integrals.places_at(c, value, None)
        return CourseZero(None, {**others, **own}, value)

    def reachable(self, zero: CourseZero) -> tuple[Ratio, ...]:
        """What must be positive for the coordinate to get there, as far as it has a short form: the speed squared, and
        what makes the place a real number."""
        assert zero.at is not None
        speed = zero.values.get(self.coordinate.speed)
        found = (*reals(zero.at), *(() if speed is None else (speed**2,)))
        return tuple(x for x in found if not x.is_zero())

    @cached_property
    def _law(self) -> MotionLaw | None:
        return _followed(self.model, self.start).law_of(self.coordinate)

    def instants(self, place: Ratio) -> list[tuple[Ratio, Ratio]]:
        """Times at which the coordinate is at a place, with its rate then, as far as its own law tells them: all of
        them within a period from the start on, and others. Without such a law none."""
        law, found = self._law, list[tuple[Ratio, Ratio]]()
        known = None if law is None else law.places(place)
        for i in () if known is None else known[0]:
            found.append((i.time, i.rate))
            if i.period is not None:
                found.append((i.time + i.period, i.rate))
            if i.period is not None and law is not None and law.u0.is_zero():  # from rest it is even in the time
                found.append((i.period - i.time, -i.rate))
        return found


def _followed(model: SymbolicModel, start: StartState) -> SmoothMotion:
    """The motion of a phase, which ends where a length along a line changes its side."""
    motion = SmoothMotion(model, start)
    motion.integrals.keeps_side = True
    return motion


def course_of(model: SymbolicModel, start: StartState, slips: Sequence[Ratio] = ()) -> ClosedFormMotion:
    """The motion of a model in closed form, followed until one of the slips ends. Raises CannotAnswer where there is
    none."""
    f = model.field
    bound = [c for c in model.dependent if c.index not in model.unfollowed]  # nothing depends on the others' places
    staying = staying_of(model, start)
    resting = [c for c in bound if _is_kept(model, c, staying)]
    unknown = [c.name for c in resting if c.index not in start.values]
    if unknown:
        raise CannotAnswer(
            Message("{name} at the start has no closed form: a loop decides it", name=", ".join(unknown))
        )
    still = {c.index: start.values[c.index] for c in resting}
    moving = [c.name for c in bound if c.index not in still]
    if moving:
        raise CannotAnswer(
            Message("{names} follow from the others only through a closed loop", names=", ".join(moving))
        )
    still |= {c.speed: f.zero for c in bound}
    accelerations = [
        f.lowest_terms(f.follow(model.dynamics.solved_accelerations[a], still)) for a in model.accelerations
    ]
    if all(_is_steady(f, a) for a in accelerations):
        return UniformMotion(model, start, still)
    if staying and not model.dependent:  # a block on a spring that rests until it is struck
        at_rest = [f.lowest_terms(f.follow(a, staying)) for a in accelerations]
        if all(_is_steady(f, a) for a in at_rest):
            return UniformMotion(model, start, {**still, **staying})
    smooth = _followed(model, start)
    # what is driven goes on by the time since the start of the model, not of the phase
    is_timed = is_driven(model) and any(f.index(f.time) in f.ingredients(a) for a in accelerations)
    free = not model.dependent and not is_timed
    laws, sides = _laws(smooth, _one_way(model, slips)) if free else ([], ())
    has_laws = len(laws) == len(model.coordinates)
    if free and not has_laws and not _has_energy(model, start):
        # which law it is the parameters decide, as of a damper that lets swing or does not
        laws, sides = _laws(smooth, _one_way(model, slips), takes_side=True)
        has_laws = len(laws) == len(model.coordinates)
    in_time = LawMotion(model, start, laws, smooth.integrals.resting, sides)
    if len(model.coordinates) == 1:
        try:
            by_energy = EnergyMotion(model, start, model.coordinates[0])
            return by_energy if not has_laws or all(map(by_energy.is_even_or_odd, slips)) else in_time
        except CannotAnswer:
            if not has_laws:
                raise
    if has_laws:
        return in_time
    for c in model.coordinates:
        with suppress(CannotAnswer):
            return EnergyMotion(model, start, c)
    if free:
        with suppress(CannotAnswer):
            return ModalMotion(smooth)
        if (of_block := _by_energy_of_a_block(smooth)) is not None:
            return of_block
    names = ", ".join(c.name for c in model.coordinates)
    raise CannotAnswer(
        Message(
            "the accelerations of {names} are not constant, and energy alone gives the speed of one only", names=names
        )
    )


def _by_energy_of_a_block(smooth: SmoothMotion) -> EnergyMotion | None:
    """One coordinate by the energy of its block, where all others move apart from it by laws of their own."""
    for c in smooth.model.coordinates:
        laws = {k: smooth.law_of(k) for k in apart_from(smooth.model, c)}
        known = {k: law for k, law in laws.items() if law is not None and law.has_course}
        if laws and len(known) == len(laws):
            with suppress(CannotAnswer):
                return EnergyMotion(smooth.model, smooth.start, c, known)
    return None


def _is_steady(f: Field, acceleration: Ratio) -> bool:
    return acceleration.is_constant() and f.index(f.time) not in f.ingredients(acceleration)


def _is_kept(model: SymbolicModel, c: Coordinate, staying: Mapping[int, Ratio]) -> bool:
    """Whether a dependent coordinate stays where it is: always, or as long as those stay that do (a ball that rolls
    straight on does not leave its line)."""
    speed = model.dependent_speed(c)
    return model.samples.vanishes(speed) or model.field.lowest_terms(model.field.follow(speed, staying)).is_zero()


def _one_way(model: SymbolicModel, slips: Sequence[Ratio]) -> set[int]:
    """The speeds to which a slip is proportional: they keep their sense until it ends."""
    f, found = model.field, set[int]()
    for slip in map(model.in_independent_speeds, slips):
        found |= {c.speed for c in model.coordinates if f.lowest_terms(slip / f.variable(c.speed)).is_constant()}
    return found


def _has_energy(model: SymbolicModel, start: StartState) -> bool:
    """Whether energy gives the speed of a coordinate."""
    for c in model.coordinates:
        with suppress(CannotAnswer):
            EnergyMotion(model, start, c)
            return True
    return False


def _laws(
    motion: SmoothMotion, one_way: Set[int], *, takes_side: bool = False
) -> tuple[list[MotionLaw], tuple[Ratio, ...]]:
    """The laws of the coordinates that have one, and what is positive on the side of a sign that they are for."""
    samples = motion.model.samples
    before, samples.assumed = samples.assumed, []
    found: list[MotionLaw] = []
    for c in motion.model.coordinates:
        law = motion.law_of(c, takes_side=takes_side, keeps_sense=c.speed in one_way)
        if law is not None and law.has_course:
            found.append(law)
    taken, samples.assumed = samples.assumed, before
    changing = {g for c in motion.model.coordinates for g in (c.index, c.speed)}
    sides = [x for x in taken if not motion.model.field.ingredients(x) & changing]
    samples.assumed += [x for x in taken if x not in sides and x not in before]  # looked at along the motion
    return found, tuple(sides)
