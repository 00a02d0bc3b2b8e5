"""Forced oscillations: the steady motion of M x'' + C x' + K x = Re((f_c - i f_s) e^(i Omega t)).

With F = F_0 + f_c cos(Omega t) + f_s sin(Omega t) at the equilibrium of the mean, x = Re(X e^(i Omega t)) and

    D X = f_c - i f_s,        D = K - Omega^2 M + i Omega C,

by Cramer's rule. A quantity Q(x, x', t), to first order in the motion, swings as Re(A e^(i Omega t)) with

    A = (dQ/dx + i Omega dQ/dx') X + Q_c - i Q_s,

its amplitude is |A|, and it lags behind another one, B, by the angle of B/A. Source: Rao, Mechanical Vibrations, 5th
ed. 2011, ch. 3 and sec. 5.6; Meirovitch, Elements of Vibration Analysis, 2nd ed. 1986, sec. 2.2.
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import cached_property

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, free_symbols
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, ENERGY, Dimension
from freebody.model.elements import NonholonomicForm
from freebody.symbolic.linearised import Linearised, Swing, swing_of, timed_in
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.state import SymbolicState

TIME = "t"


@dataclass(frozen=True)
class Phasor:
    """re + i im: the swing re cos(Omega t) - im sin(Omega t)."""

    re: Ratio
    im: Ratio

    def __add__(self, other: Phasor) -> Phasor:
        return Phasor(self.re + other.re, self.im + other.im)

    def __sub__(self, other: Phasor) -> Phasor:
        return Phasor(self.re - other.re, self.im - other.im)

    def __mul__(self, other: Phasor) -> Phasor:
        return Phasor(self.re * other.re - self.im * other.im, self.re * other.im + self.im * other.re)

    @property
    def conjugate(self) -> Phasor:
        return Phasor(self.re, -self.im)

    @property
    def square(self) -> Ratio:
        """|z|^2"""
        return self.re.field.lowest_terms(self.re * self.re + self.im * self.im)

    @property
    def is_zero(self) -> bool:
        return self.re.is_zero() and self.im.is_zero()


@dataclass(frozen=True)
class ForcedOscillation:
    """The steady motion about an equilibrium. What is asked of it is N/D with one D for all."""

    linear: Linearised
    swing: Swing

    @property
    def model(self) -> SymbolicModel:
        return self.linear.model

    @cached_property
    def matrix(self) -> list[list[Phasor]]:
        """D = K - Omega^2 M + i Omega C."""
        w, linear = self.swing.frequency, self.linear
        rows = zip(linear.stiffness, linear.mass, linear.damping, strict=True)
        return [[Phasor(k - w * w * m, w * c) for k, m, c in zip(*row, strict=True)] for row in rows]

    @cached_property
    def force(self) -> list[Phasor]:
        """f_c - i f_s, along the coordinates."""
        return [self.phasor_of(F) for F in self.model.dynamics.forcing]

    @cached_property
    def determinant(self) -> Phasor:
        return _determinant(self.matrix)

    @cached_property
    def response(self) -> list[Phasor]:
        """X, multiplied by the determinant of D. Raises CannotAnswer where nothing is forced."""
        if all(x.is_zero for x in self.force):
            raise CannotAnswer(
                Message(
                    "the harmonic loads and drives do not force the motion about the equilibrium: there, to first "
                    "order, they do no work on it"
                )
            )
        if self.determinant.is_zero:
            raise CannotAnswer(
                Message(
                    "nothing limits the motion: resonance without damping, or a direction without stiffness and mass"
                )
            )
        n, found = len(self.force), list[Phasor]()
        for k in range(n):
            replaced = [
                [self.force[j] if i == k else x for i, x in enumerate(row)] for j, row in enumerate(self.matrix)
            ]
            found.append(_determinant(replaced))
        return found

    def here(self, x: Ratio) -> Ratio:
        return self.linear.here(x)

    def phasor_of(self, x: Ratio) -> Phasor:
        """What an element swings by itself, all coordinates at rest. Raises CannotAnswer where it is not harmonic."""
        f = self.model.field
        still = {g: value for g, value in self.linear.still.items() if g not in self.swing.mean}
        resting = f.lowest_terms(f.follow(x, still))
        parts = self.swing.parts(resting)
        if parts is None or any(timed_in(self.model, p) for p in parts):
            raise CannotAnswer(Message("it does not swing harmonically about the equilibrium"))
        return Phasor(self.here(parts[1]), -self.here(parts[2]))

    def of(self, x: Ratio) -> Phasor:
        """The swing of a quantity, multiplied by the determinant of D."""
        w, m = self.swing.frequency, self.model
        total = self.phasor_of(x) * self.determinant
        for c, motion in zip(m.coordinates, self.response, strict=True):
            slope = Phasor(self.linear.slope(x, c), w * self.linear.speed_slope(x, c))
            if not slope.is_zero:
                total = total + slope * motion
        return total

    def is_even(self, x: Ratio) -> bool:
        """Whether a quantity varies with the motion, but not to first order, as an energy or a speed."""
        moving = {k for c in self.model.coordinates for k in (c.index, c.speed)}
        return bool(moving & x.field.ingredients(x)) and all(
            self.linear.slope(x, c).is_zero() and self.linear.speed_slope(x, c).is_zero()
            for c in self.model.coordinates
        )

    @cached_property
    def _excitations(self) -> list[tuple[Phasor, Dimension]]:
        """Of loads and drives that are harmonic by themselves, with their dimensions."""
        system, state, found = self.model.system, SymbolicState(self.model), list[tuple[Phasor, Dimension]]()
        named = [(state.law(p), ENERGY / p.measure.dimension) for p in system.applied_loads if _is_timed(p.law)]
        for row in system.constraint_rows:
            if _is_timed(row.target) and not isinstance(row.measure, NonholonomicForm):
                named.append((state.value(row.measure), row.measure.dimension))
        for x, dimension in named:
            with suppress(CannotAnswer):
                swing = self.phasor_of(x)
                if not swing.is_zero:
                    found.append((swing, dimension))
        return found

    def excitation(self) -> Phasor:
        """The one load or drive that excites the motion; where there is none, as of a rotor out of balance, the force
        along the one coordinate. Raises CannotAnswer where there are several."""
        if len(self._excitations) == 1:
            return self._excitations[0][0]
        if not self._excitations and len(self.force) == 1:
            return self.force[0]
        n = len(self._excitations)
        raise CannotAnswer(Message("{n} loads or drives excite the motion; say from which quantity it is counted", n=n))

    @property
    def excitation_dimension(self) -> Dimension:
        if self._excitations:
            return self._excitations[0][1]
        measure = self.model.measure_of(self.model.coordinates[0])
        return ENERGY / (DIMENSIONLESS if measure is None else measure.dimension)


def _is_timed(e: Expr | None) -> bool:
    return e is not None and TIME in free_symbols(e)


def _determinant(A: Sequence[Sequence[Phasor]]) -> Phasor:
    """Laplace expansion; systems here are small."""
    if len(A) == 1:
        return A[0][0]
    total: Phasor | None = None
    for k, entry in enumerate(A[0]):
        if entry.is_zero:
            continue
        term = entry * _determinant([[*row[:k], *row[k + 1 :]] for row in A[1:]])
        signed = term if k % 2 == 0 else Phasor(-term.re, -term.im)
        total = signed if total is None else total + signed
    zero = A[0][0].re.field.zero
    return Phasor(zero, zero) if total is None else total


def forced_oscillation(model: SymbolicModel, linear: Linearised) -> ForcedOscillation:
    """Raises CannotAnswer where nothing swings harmonically."""
    swing = swing_of(model)
    if swing is None:
        raise CannotAnswer(
            Message(
                "forced oscillation needs loads or drives that swing harmonically with one frequency, such as "
                "F0*cos(Omega*t) or Y*sin(Omega*t)"
            )
        )
    return ForcedOscillation(linear, swing)
