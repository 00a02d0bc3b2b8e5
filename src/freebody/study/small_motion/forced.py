"""Forced oscillations in closed form: amplitude, phase, transmissibility, resonance."""

from __future__ import annotations

import math
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from functools import cached_property, singledispatch

import numpy as np

from freebody.errors import CannotAnswer, FormulaTooLong, SaysNothing
from freebody.language.notation import to_python
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.questions.base import Quantity
from freebody.questions.forced_motion import (
    MagnificationFactor,
    PhaseLag,
    ResonanceFrequency,
    SteadyAmplitude,
    Transmissibility,
)
from freebody.questions.reading import Question
from freebody.study.answering.answer import Evidence
from freebody.study.answering.at_equilibrium import AT_REST, frequencies_at, insist_on_rest, places_at, unrest
from freebody.study.answering.crosscheck import CrossCheck, element_at, holds
from freebody.study.answering.draws import Draw
from freebody.study.answering.finding import Finding
from freebody.study.setup import Setup
from freebody.study.small_motion.forced_numbers import ForcedNumbers
from freebody.study.small_motion.resting import TOLERANCE, AtRest
from freebody.symbolic.conditions import Condition, insisted, require
from freebody.symbolic.equilibrium import find_equilibrium
from freebody.symbolic.forced import ForcedOscillation, Phasor, forced_oscillation
from freebody.symbolic.functions import functions
from freebody.symbolic.linear import determinant
from freebody.symbolic.linearised import Linearised
from freebody.symbolic.quadratic import roots
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign, sign_of

FORCED = Message("frequency response of the full system, linearised in numbers")
NO_DEFLECTION = Message(
    "the excitation vanishes with its frequency, so there is no deflection to compare with; ask for the steady "
    "amplitude, or for the transmissibility"
)
SMALL = Message(
    "the forces are not proportional to what is driven: this is the motion to the first order in its amplitude"
)
_VERTICES = 12  # steps to a maximum in numbers, each the square of the last
_SLOW = 1e-5  # of the frequencies: their squares are below the tolerance
_APART = 1e-3  # of the frequency: where amplitudes beside a maximum are read


def forced(setup: Setup, question: Question, q: Quantity, at_rest: AtRest) -> Finding:
    """The closed form with its evidence. Raises CannotAnswer where nothing swings harmonically."""
    return _asked(q, _Forced(setup, at_rest), question)


def forced_number(setup: Setup, question: Question, draw: Draw) -> float:
    """The value of the numeric route alone, about the equilibrium that formulas give."""
    told = _Forced(setup, lambda _rest, _clear: [])
    needed = (*told.rest.exists, *told.rest.stable)
    if not all(holds(setup, c, draw, draw.start()) for c in needed) or unrest(setup, draw, told.places(draw)) > AT_REST:
        raise CannotAnswer(Message("the equilibrium that formulas give is none at the model's own values"))
    of: Quantity | None = getattr(question.quantity, "of", None)
    if of is not None:
        with suppress(FormulaTooLong):
            told.of(of)  # raises where it does not swing to first order, which no number shows
    return _number(question.quantity, told, told.numbers(draw))


@singledispatch
def _number(q: Quantity, told: _Forced, numbers: ForcedNumbers) -> float:
    raise CannotAnswer(Message("this is no question about small motion"))


@singledispatch
def _asked(q: Quantity, told: _Forced, question: Question) -> Finding:
    raise CannotAnswer(Message("this is no question about small motion"))


class _Forced:
    """The forced oscillation of a system, and what it needs."""

    def __init__(self, setup: Setup, at_rest: AtRest) -> None:
        self.setup, self.model = setup, setup.model
        if not self.model.coordinates:
            raise CannotAnswer(Message("nothing can move, so nothing oscillates"))
        self.rest = find_equilibrium(self.model, setup.start)
        self.linear = Linearised(self.model, self.rest.values)
        self.linear.check_is_steady()
        self.forced: ForcedOscillation = forced_oscillation(self.model, self.linear)
        if self.rest.is_stable is False and not self.rest.stable:
            raise CannotAnswer(Message("the equilibrium is not stable: the motion runs away from it"))
        self.conditions = [*at_rest(self.rest, ">"), *(replace(c, purpose=Message("stable")) for c in self.rest.stable)]
        self.conditions += self._dissipates()
        self.notes: list[str] = []
        if self.forced.swing.size is not None:
            self.notes.append(SMALL)
        if not self.linear.is_damped:
            self.notes.append(
                Message("without damping free oscillations do not die away: this is the forced part of the motion")
            )

    def _dissipates(self) -> list[Condition]:
        """That damping takes energy: the leading minors of C are not negative."""
        C = self.linear.damping
        minors = (determinant([row[:size] for row in C[:size]]) for size in range(1, len(C) + 1))
        grows = CannotAnswer(Message("the damping feeds energy into the motion, which grows"))
        return insisted((Condition(x, ">=", Message("damps")) for x in minors), grows)

    def of(self, q: Quantity) -> Phasor:
        """The swing of a quantity, multiplied by the determinant of D."""
        value = q.value(self.setup.system, self.setup.state)
        if isinstance(value, tuple):
            raise CannotAnswer(Message("a vector has no one amplitude; ask along a direction"))
        x = self.model.field.element(value)
        swing = self.forced.of(x)
        if swing.is_zero and self.forced.is_even(x):
            raise CannotAnswer(
                Message(
                    "to first order it does not swing as the motion does, no more than an energy or a speed: ask for a "
                    "place, for a velocity along a direction or for a force"
                )
            )
        return swing

    def root(self, x: Ratio) -> Ratio:
        """Of a square, out of which only factors come whose sign is known."""

        def is_negative(factor: Ratio) -> bool | None:
            sign = sign_of(factor)
            return None if sign in (Sign.UNKNOWN, Sign.ZERO) else sign in (Sign.NEGATIVE, Sign.NONPOSITIVE)

        return self.model.field.sqrt(x, is_negative)

    def amplitude(self, swing: Phasor, by: Phasor) -> Ratio:
        f = self.model.field
        top, below = self.root(swing.square), self.root(by.square)
        return f.lowest_terms(top / below)

    @cached_property
    def paced_by(self) -> tuple[int, Ratio]:
        """The parameter P to which the frequency of the excitation is proportional, as the speed of a car on a wavy
        road is, and Omega/P: what varies where the frequency does, rather than what the motion depends on besides, as
        the stiffness of what turns does on the rate of turning."""
        f, frequency, linear = self.model.field, self.forced.swing.frequency, self.linear
        own = {
            g
            for A in (linear.mass, linear.damping, linear.stiffness)
            for row in A
            for x in row
            for g in f.ingredients(x)
        }
        for g in sorted(frequency.generators(), key=lambda g: (g in own, g)):
            factor = f.lowest_terms(frequency / f.variable(g))
            if f.generators[g].kind == "parameter" and g not in f.ingredients(factor):
                return g, factor
        raise CannotAnswer(Message("the frequency of the excitation is no parameter of its own; write cos(Omega*t)"))

    @property
    def omega(self) -> int:
        return self.paced_by[0]

    def with_frequency(self, draw: Draw, frequency: float) -> Draw:
        """A draw with another frequency of the excitation."""
        g, factor = self.paced_by
        (by,) = element_at(self.setup, (factor,), draw, draw.start())
        name = to_python(self.model.field.generators[g].display)
        return Draw.of(draw.reference.system, {**draw.values, name: frequency / by})

    def finite(self, by: Phasor) -> list[Condition]:
        """That a divisor does not vanish: without damping it does where the excitation meets a natural frequency."""
        condition, _possible = require(by.re if by.im.is_zero() else by.square, "!=", Message("no resonance"))
        return [] if condition is None else [condition]

    def numbers(self, draw: Draw) -> ForcedNumbers:
        start = draw.start()
        (frequency,) = element_at(self.setup, (self.forced.swing.frequency,), draw, start)
        return ForcedNumbers(self.setup.system, draw, self.places(draw), abs(frequency))

    def places(self, draw: Draw) -> list[tuple[Measure, float]]:
        """Where the measures rest, of one draw."""
        return places_at(self.setup, self.rest.values, draw)

    def evidence(self, question: Question, x: Ratio, read: Callable[[ForcedNumbers], float]) -> Evidence:
        check = CrossCheck(question.text, FORCED, TOLERANCE)

        def compare(draw: Draw) -> None:
            start = draw.start()
            if all(holds(self.setup, c, draw, start) for c in self.conditions):
                check.compare(draw, element_at(self.setup, x, draw, start), read(self.numbers(draw)))

        insist_on_rest(self.setup, check.gather(self.setup.draw_stream(), compare), self.conditions)
        return check.evidence()


@_asked.register(SteadyAmplitude)
def _amplitude(q: SteadyAmplitude, told: _Forced, question: Question) -> Finding:
    x = told.amplitude(told.of(q.of), told.forced.determinant)
    told.conditions += told.finite(told.forced.determinant)
    evidence = told.evidence(question, x, lambda numbers: _number(q, told, numbers))
    return Finding(x, evidence, told.conditions, told.notes, may_be_complex=True)


@_asked.register(Transmissibility)
def _transmissibility(q: Transmissibility, told: _Forced, question: Question) -> Finding:
    source = told.forced.excitation() * told.forced.determinant if q.source is None else told.of(q.source)
    if source.is_zero:
        raise CannotAnswer(Message("what it is compared with does not swing"))
    x = told.amplitude(told.of(q.of), source)
    told.conditions += told.finite(source)
    evidence = told.evidence(question, x, lambda numbers: _number(q, told, numbers))
    compared = told.forced.excitation_dimension if q.source is None else q.source.dimension
    unit = str(q.of.dimension / compared)
    return Finding(x, evidence, told.conditions, told.notes, may_be_complex=True, unit=unit)


@_asked.register(MagnificationFactor)
def _magnification(q: MagnificationFactor, told: _Forced, question: Question) -> Finding:
    """|A(Omega)| over |A(0)|, the loads and drives having the same amplitudes."""
    f, omega, swing = told.model.field, told.omega, told.of(q.of)
    still = {omega: f.zero}
    size = f.lowest_terms(f.follow(swing.square, still) / f.follow(told.forced.determinant.square, still))
    if size.is_zero():
        raise CannotAnswer(NO_DEFLECTION)
    x = f.lowest_terms(told.amplitude(swing, told.forced.determinant) / told.root(size))
    told.conditions += told.finite(told.forced.determinant)
    evidence = told.evidence(question, x, lambda numbers: _number(q, told, numbers))
    return Finding(x, evidence, told.conditions, told.notes, may_be_complex=True)


@_number.register(SteadyAmplitude)
def _amplitude_number(q: SteadyAmplitude, told: _Forced, numbers: ForcedNumbers) -> float:
    return abs(numbers.of(q.of))


@_number.register(MagnificationFactor)
def _magnification_number(q: MagnificationFactor, told: _Forced, numbers: ForcedNumbers) -> float:
    """The amplitude over that at a frequency that is slow beside all others."""
    natural = min(frequencies_at(told.setup, numbers.draw, numbers.places), default=numbers.frequency)
    slow = _SLOW * min(natural, numbers.frequency)
    sizes = [_size_at(told, q.of, numbers.draw, x) for x in (slow, slow / 2)]
    if abs(sizes[0] - sizes[1]) > TOLERANCE * sizes[0]:
        raise CannotAnswer(NO_DEFLECTION)
    return abs(numbers.of(q.of)) / sizes[0]


@_number.register(Transmissibility)
def _transmissibility_number(q: Transmissibility, told: _Forced, numbers: ForcedNumbers) -> float:
    return abs(numbers.of(q.of)) / abs(_source(told, numbers, q.source))


@_number.register(PhaseLag)
def _lag_number(q: PhaseLag, told: _Forced, numbers: ForcedNumbers) -> float:
    """Without damping it is 0 or pi, but for round-off of the imaginary part."""
    ratio = _source(told, numbers, q.behind) / numbers.of(q.of)
    is_in_step = abs(ratio.imag) <= TOLERANCE * abs(ratio) and not told.linear.is_damped
    return (0.0 if ratio.real > 0 else math.pi) if is_in_step else float(np.angle(ratio))


def _source(told: _Forced, numbers: ForcedNumbers, source: Quantity | None) -> complex:
    """In numbers what a phase or a ratio is counted from."""
    if source is not None:
        return numbers.of(source)
    swing, start = told.forced.excitation(), numbers.draw.start()
    re, im = element_at(told.setup, (swing.re, swing.im), numbers.draw, start)
    return complex(re, im)


@_asked.register(PhaseLag)
def _lag(q: PhaseLag, told: _Forced, question: Question) -> Finding:
    """The angle of B/A, by its cosine: B conj(A) is its cosine and its sine but for a positive factor."""
    source = told.forced.excitation() * told.forced.determinant if q.behind is None else told.of(q.behind)
    swing = told.of(q.of)
    if swing.is_zero or source.is_zero:
        raise CannotAnswer(Message("what does not swing has no phase"))
    turned = source * swing.conjugate
    arc, conditions = _in_step(told, turned.re) if turned.im.is_zero() else _turned(told, turned)
    told.conditions += conditions

    evidence = told.evidence(question, arc, lambda numbers: _number(q, told, numbers))
    return Finding(arc, evidence, told.conditions, told.notes, may_be_complex=True)


def _turned(told: _Forced, turned: Phasor) -> tuple[Ratio, list[Condition]]:
    """The angle between -pi and pi, the sign of the sine being known or that of the model's own values."""
    f, samples = told.model.field, told.model.samples
    cos = f.lowest_terms(turned.re / told.root(turned.square))
    angle = functions(f, samples.is_negative)["acos"](cos)
    sign = sign_of(turned.im)
    if sign in (Sign.POSITIVE, Sign.NONNEGATIVE):
        return angle, []
    if sign in (Sign.NEGATIVE, Sign.NONPOSITIVE):
        return -angle, []
    is_ahead = (samples.at_starts(turned.im) or [0.0])[0] < 0
    purpose = Message("runs ahead") if is_ahead else Message("lags behind")
    condition, _possible = require(-turned.im if is_ahead else turned.im, ">", purpose)
    return -angle if is_ahead else angle, [] if condition is None else [condition]


def _in_step(told: _Forced, re: Ratio) -> tuple[Ratio, list[Condition]]:
    """Without damping: in phase, or in opposite phase, by a sign."""
    f = told.model.field
    is_opposite = (told.model.samples.at_starts(re) or [0.0])[0] < 0
    purpose = Message("in opposite phase") if is_opposite else Message("in phase")
    condition, _possible = require(-re if is_opposite else re, ">", purpose)
    return f.pi if is_opposite else f.zero, [] if condition is None else [condition]


@_asked.register(ResonanceFrequency)
def _resonance(q: ResonanceFrequency, told: _Forced, question: Question) -> Finding:
    """Where the derivative of the squared amplitude by the frequency vanishes; without damping, where the amplitude is
    without bound."""
    f, omega = told.model.field, told.omega
    square = f.lowest_terms(told.of(q.of).square / told.forced.determinant.square)
    is_bounded = told.linear.is_damped
    sought = f.lowest_terms(f.partial(square, omega)).numerator() if is_bounded else square.denominator()
    places = [x for base, _times in f.factor(sought.num)[1] for x in _squares_of(base, omega)]
    best = _largest(told, places, square, omega) if is_bounded else _positive(told, places)
    none = CannotAnswer(Message("the amplitude has no maximum at any frequency above zero"))
    told.conditions += insisted([Condition(x, ">", Message("there is a resonance")) for x in best], none)
    roots = tuple(f.sqrt(x, told.model.samples.is_negative) for x in best)
    if not is_bounded:
        told.notes.append(Message("without damping the amplitude grows without bound there"))
    there = [
        replace(c, element=f.lowest_terms(f.follow(c.element, {omega: x}))) for x in roots for c in told.conditions
    ]
    told.conditions[:] = dict.fromkeys(insisted(there, none))
    roots = tuple(f.lowest_terms(told.paced_by[1] * x) for x in roots)
    evidence = _at_resonance(told, question, q, roots, is_bounded=is_bounded)
    return Finding(roots[0] if len(roots) == 1 else roots, evidence, told.conditions, told.notes)


def _positive(told: _Forced, places: list[Ratio]) -> list[Ratio]:
    """Those that are positive at the model's own values, ascending."""
    values = [(told.model.samples.at_starts(x) or [math.nan])[0] for x in places]
    found = [(value, x) for value, x in zip(values, places, strict=True) if value > 0]
    if not found:
        raise CannotAnswer(Message("the amplitude has no maximum at any frequency above zero"))
    return [x for _value, x in sorted(found, key=lambda pair: pair[0])]


def _largest(told: _Forced, places: list[Ratio], square: Ratio, omega: int) -> list[Ratio]:
    """The one with the largest amplitude at the model's own values."""
    samples = told.model.samples

    def size(x: Ratio) -> float:
        value = (samples.at_starts(x) or [math.nan])[0]
        return samples.at_start_with(square, 0, {omega: math.sqrt(value)})

    return [max(_positive(told, places), key=size)]


def _at_resonance(
    told: _Forced, question: Question, q: ResonanceFrequency, roots: tuple[Ratio, ...], *, is_bounded: bool
) -> Evidence:
    """Newton's step from there in numbers, which is none; without damping, the natural frequencies."""
    setup = told.setup
    check = CrossCheck(question.text, FORCED, 10 * TOLERANCE)

    def compare(draw: Draw) -> None:
        start = draw.start()
        if not all(holds(setup, c, draw, start) for c in told.conditions):
            return
        exact = element_at(setup, roots, draw, start)
        if not is_bounded:
            check.compare(draw, exact, tuple(_nearest_natural(told, told.with_frequency(draw, x), x) for x in exact))
            return
        step = _to_vertex(told, q, draw, exact[0])
        if step is None:
            raise SaysNothing(Message("the maximum is too flat for numbers"))
        check.compare(draw, exact, exact[0] * (1.0 + step))

    insist_on_rest(setup, check.gather(setup.draw_stream(), compare), told.conditions)
    return check.evidence()


@_number.register(ResonanceFrequency)
def _resonance_number(q: ResonanceFrequency, told: _Forced, numbers: ForcedNumbers) -> float:
    """From the natural frequency nearest to the excitation on, step after step of Newton's method."""
    draw = numbers.draw
    x = _nearest_natural(told, draw, numbers.frequency)
    if not told.linear.is_damped:
        with suppress(CannotAnswer):  # where it is no parameter nothing varies with it
            there = told.with_frequency(draw, x)
            if abs(_nearest_natural(told, there, x) - x) > TOLERANCE * x:
                raise SaysNothing(Message("the natural frequencies vary with that of the excitation"))
        return x
    for _ in range(_VERTICES):
        step = _to_vertex(told, q, draw, x)
        if step is None:
            raise CannotAnswer(Message("no maximum of the amplitude was found near a natural frequency"))
        x *= 1.0 + max(-0.3, min(0.3, step))
        if abs(step) < TOLERANCE * _APART:
            break
    return x


def _nearest_natural(told: _Forced, draw: Draw, x: float) -> float:
    natural = np.array(frequencies_at(told.setup, draw, told.places(draw)))
    return float(natural[np.argmin(np.abs(natural - x))])


def _to_vertex(told: _Forced, q: ResonanceFrequency, draw: Draw, x: float) -> float | None:
    """Newton's step towards the maximum of the amplitude, as a part of x, from differences of fourth order; None where
    the amplitude does not bend downwards."""
    a, b, c, d, e = (_size_at(told, q.of, draw, x * (1.0 + k * _APART)) for k in (-2, -1, 0, 1, 2))
    slope = (8.0 * (d - b) - (e - a)) / (12.0 * _APART)
    bend = (16.0 * (b + d) - (a + e) - 30.0 * c) / (12.0 * _APART**2)
    return -slope / bend if bend < -1e-3 * c else None


def _size_at(told: _Forced, of: Quantity, draw: Draw, frequency: float) -> float:
    """The amplitude in numbers at another frequency."""
    other = told.with_frequency(draw, frequency)
    return abs(ForcedNumbers(told.setup.system, other, told.numbers(draw).places, frequency).of(of))


def _squares_of(base: Ratio, omega: int) -> list[Ratio]:
    """The values of Omega^2 for which an even factor of degree 2 or 4 in Omega vanishes."""
    if omega not in base.generators():
        return []
    c = base.coefficients(omega)
    if len(c) == 2 and c[0].is_zero():
        return []
    if any(not x.is_zero() for x in c[1::2]) or len(c) > 5:
        raise CannotAnswer(
            Message(
                "the maximum follows from a polynomial of degree {n} in the frequency that does not factor",
                n=len(c) - 1,
            )
        )
    return roots(c[::2]) or []
