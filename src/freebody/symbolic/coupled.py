"""Coordinates that are coupled linearly, together in time:  q'' = alpha - A q  with constant A and alpha.

An acceleration that is a sum of rates is integrated at once, so that what gyroscopic forces couple comes to this form.

With the different eigenvalues l_k of A and the projectors on their spaces (Sylvester's formula),

    P_k = prod_(j != k) (A - l_j)/(l_k - l_j),     q(t) = sum_k P_k (q0 c_k + u0 s_k + alpha (1 - c_k)/l_k),

where c_k = cos(w t), s_k = sin(w t)/w for l_k = w^2 (cosh and sinh for l_k < 0); for l_k = 0: 1, t, and t^2/2 behind
alpha. The modes are found where the characteristic polynomial has factors of the second degree at most.
Source: Gantmacher, Applications of the Theory of Matrices, 1959, ch. I; Landau & Lifshitz, Mechanics, sec. 23.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.symbolic.field import Field
from freebody.symbolic.functions import functions
from freebody.symbolic.linear import determinant
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.quadratic import roots
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign, sign_of
from freebody.symbolic.start import StartState
from freebody.symbolic.unknowns import Coordinate

Matrix = list[list[Ratio]]
_MOST = 6  # coordinates that are coupled


@dataclass(frozen=True)
class ModalWave:
    """mean + cosine cos(w t) + sine/w sin(w t), with w^2 = square > 0."""

    mean: Ratio
    square: Ratio
    cosine: Ratio
    sine: Ratio


@dataclass(frozen=True)
class CoupledMotion:
    """Coordinates that move with each other, and with no others."""

    model: SymbolicModel
    coordinates: tuple[Coordinate, ...]
    alpha: tuple[Ratio, ...]
    squares: tuple[Ratio, ...]  # the eigenvalues of A, each once
    projectors: tuple[Matrix, ...]
    begin: tuple[tuple[Ratio, Ratio], ...]  # values and rates at the start

    @property
    def rates(self) -> list[Ratio]:
        """With which the modes swing, or grow; those that drift have none."""
        return [self._rate(square)[0] for square in self.squares if not square.is_zero()]

    def at(self, time: Ratio) -> dict[int, Ratio]:
        """Coordinates and their rates at a time, by generator."""
        f = self.model.field
        places, rates = ([f.zero] * len(self.coordinates) for _ in range(2))
        q0, u0 = ([b[k] for b in self.begin] for k in range(2))
        for square, projector in zip(self.squares, self.projectors, strict=True):
            c, s, w = self._waves(square, time)
            x, v, a = (_times(projector, column) for column in (q0, u0, self.alpha))
            for k in range(len(self.coordinates)):
                places[k] = places[k] + x[k] * c + v[k] * s + a[k] * w
                rates[k] = rates[k] - square * x[k] * s + v[k] * c + a[k] * s
        found = dict[int, Ratio]()
        for coordinate, place, rate in zip(self.coordinates, places, rates, strict=True):
            found[coordinate.index], found[coordinate.speed] = f.lowest_terms(place), f.lowest_terms(rate)
        return found

    def wave_of(self, x: Ratio) -> ModalWave | None:
        """What is linear in these coordinates and their rates, as mean + A cos(w t) + B sin(w t). None where it is not
        linear, or drifts. Raises CannotAnswer where several modes have a part in it, whose periods need not fit."""
        f = self.model.field
        of_place, of_rate = (
            [f.lowest_terms(f.derivative(x, index)) for index in indices]
            for indices in zip(*((c.index, c.speed) for c in self.coordinates), strict=True)
        )
        mean = x
        for c, r, s in zip(self.coordinates, of_place, of_rate, strict=True):
            mean = mean - r * f.variable(c.index) - s * f.variable(c.speed)
        mean = f.lowest_terms(mean)
        if not all(part.is_constant() for part in (*of_place, *of_rate, mean)):
            return None
        waves: list[tuple[Ratio, Ratio, Ratio]] = []
        q0, u0 = ([b[k] for b in self.begin] for k in range(2))
        for square, projector in zip(self.squares, self.projectors, strict=True):
            place, rate, push = (_times(projector, column) for column in (q0, u0, self.alpha))

            def along(row: Sequence[Ratio], column: Sequence[Ratio]) -> Ratio:
                return f.lowest_terms(sum((a * b for a, b in zip(row, column, strict=True)), f.zero))

            if square.is_zero():
                mean = mean + along(of_place, place) + along(of_rate, rate)
                if not all(
                    part.is_zero() for part in (along(of_place, rate), along(of_place, push), along(of_rate, push))
                ):
                    return None
                continue
            offset = along(of_place, push) / square
            mean = mean + offset
            cosine = f.lowest_terms(along(of_place, place) - offset + along(of_rate, rate))
            sine = f.lowest_terms(along(of_place, rate) + along(of_rate, push) - square * along(of_rate, place))
            if not (cosine.is_zero() and sine.is_zero()):
                waves.append((square, cosine, sine))
        if len(waves) > 1:
            raise CannotAnswer(
                Message(
                    "{n} modes have a part in it, whose periods need not fit: it comes as near as one likes to the sum "
                    "of their amplitudes, and need not reach it",
                    n=len(waves),
                )
            )
        if not waves or sign_of(waves[0][0]) is not Sign.POSITIVE:
            return None
        return ModalWave(f.lowest_terms(mean), *waves[0])

    def _waves(self, square: Ratio, t: Ratio) -> tuple[Ratio, Ratio, Ratio]:
        """c, s = int c dt, and int s dt."""
        f = self.model.field
        of = functions(f, self.model.samples.is_negative)
        if square.is_zero():
            return f.one, t, t * t / 2
        w, falls = self._rate(square)
        c, s = (of[name](w * t) for name in (("cosh", "sinh") if falls else ("cos", "sin")))
        return c, s / w, (1 - c) / square

    def _rate(self, square: Ratio) -> tuple[Ratio, bool]:
        """w with w^2 = l, or w^2 = -l where it grows, which is said, too."""
        known = sign_of(square)
        falls = known is Sign.NEGATIVE if known.is_strict else self.model.samples.is_negative(square)
        return self.model.field.sqrt(-square if falls else square, self.model.samples.is_negative), falls


def coupled_with(
    model: SymbolicModel, start: StartState, c: Coordinate, acceleration: Callable[[Coordinate], Ratio]
) -> CoupledMotion | None:
    """How a coordinate moves with those with which it is coupled; None where that is not linear, or where its modes
    have no closed form."""
    f = model.field
    moving = accelerations_together(model, start, c, acceleration)
    chosen = sorted(moving, key=lambda k: k.index)
    if not 1 < len(chosen) <= _MOST:
        return None
    rows = list[tuple[list[Ratio], Ratio]]()
    for k in chosen:
        row = _linear(f, moving[k], chosen)
        if row is None:
            return None
        rows.append(row)
    A, alpha = [row for row, _rest in rows], tuple(rest for _row, rest in rows)
    try:
        squares = _eigenvalues(model, A)
    except CannotAnswer:
        return None
    projectors = None if squares is None else _projectors(f, A, squares)
    if squares is None or projectors is None:
        return None
    begin = tuple((start.of(k.index), start.of(k.speed)) for k in chosen)
    return CoupledMotion(model, tuple(chosen), alpha, tuple(squares), projectors, begin)


def accelerations_together(
    model: SymbolicModel, start: StartState, c: Coordinate, acceleration: Callable[[Coordinate], Ratio]
) -> dict[Coordinate, Ratio]:
    """The accelerations of a coordinate and of those with which it is coupled, with the rates put in that are known by
    the places; none where they depend on what a closed loop or rolling binds."""
    f = model.field
    bound = {g for o in model.dependent for g in (o.index, o.speed)}
    chosen, moving = [c], dict[Coordinate, Ratio]()
    for k in chosen:  # grows while it is gone through
        moving[k] = f.lowest_terms(model.in_independent_speeds(acceleration(k)))
        inside = f.ingredients(moving[k])
        if inside & bound:
            return {}
        chosen += [o for o in model.coordinates if {o.index, o.speed} & inside and o not in chosen]
    rates = _rates_by_places(f, start, moving)
    return {k: f.lowest_terms(f.follow(a, rates)) for k, a in moving.items()} if rates else moving


def _rates_by_places(f: Field, start: StartState, moving: Mapping[Coordinate, Ratio]) -> dict[int, Ratio]:
    """The rates of coordinates whose accelerations are sums of rates of others, as those of a ball on a turntable: with
    q'' = sum g_k q_k' the rate is u0 + sum g_k (q_k - q_k0)."""
    found = dict[int, Ratio]()
    for c, acceleration in moving.items():
        slopes = {k: f.lowest_terms(f.derivative(acceleration, k.speed)) for k in moving}
        if not slopes[c].is_zero() or not all(slope.is_constant() for slope in slopes.values()):
            continue
        rest, rate = acceleration, start.of(c.speed)
        for k, slope in slopes.items():
            rest = rest - slope * f.variable(k.speed)
            rate = rate + slope * (f.variable(k.index) - start.of(k.index))
        if not acceleration.is_zero() and f.lowest_terms(rest).is_zero():
            found[c.speed] = f.lowest_terms(rate)
    return found


def _linear(f: Field, a: Ratio, chosen: Sequence[Coordinate]) -> tuple[list[Ratio], Ratio] | None:
    """Row of A, and alpha, of a = alpha - row q with constants."""
    row = list[Ratio]()
    for k in chosen:
        row.append(f.lowest_terms(-f.derivative(a, k.index)))
        if not row[-1].is_constant():
            return None
    rest = a
    for slope, k in zip(row, chosen, strict=True):
        rest = rest + slope * f.variable(k.index)
    rest = f.lowest_terms(rest)
    return (row, rest) if rest.is_constant() else None


def _eigenvalues(model: SymbolicModel, A: Matrix) -> list[Ratio] | None:
    f, n = model.field, len(A)
    s = f.parameter("@s")
    index, found = f.index(s), list[Ratio]()
    polynomial = determinant([[A[j][k] - (s if j == k else 0) for k in range(n)] for j in range(n)])
    for base, _exponent in f.factor(polynomial.num)[1]:
        if index not in base.generators():
            continue
        c = base.coefficients(index)
        own = roots(c, model.samples.is_negative)
        if own is None:
            return None
        found += [f.lowest_terms(x) for x in own]
    return found


def _projectors(f: Field, A: Matrix, squares: Sequence[Ratio]) -> tuple[Matrix, ...] | None:
    """None unless they add up to one and A is the sum of its eigenvalues times them: where it has not enough modes."""
    n = range(len(A))
    found: list[Matrix] = []
    for own in squares:
        product: Matrix = [[f.one if j == k else f.zero for k in n] for j in n]
        for other in squares:
            if other != own:
                factor = [[(A[j][k] - (other if j == k else 0)) / (own - other) for k in n] for j in n]
                product = [
                    [f.lowest_terms(sum((product[j][i] * factor[i][k] for i in n), f.zero)) for k in n] for j in n
                ]
        found.append(product)
    for j in n:
        for k in n:
            total = sum((square * p[j][k] for square, p in zip(squares, found, strict=True)), f.zero)
            if not f.lowest_terms(total - A[j][k]).is_zero():
                return None
    return tuple(found)


def _times(A: Matrix, x: Sequence[Ratio]) -> list[Ratio]:
    return [sum((a * b for a, b in zip(row, x, strict=True)), x[0].field.zero) for row in A]
