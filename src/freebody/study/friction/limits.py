"""Up to which value of a parameter a system stays at rest, in numbers."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.numeric.friction_branches import margin, pieces
from freebody.numeric.friction_limits import Optimum, at, ray
from freebody.numeric.reference import Reference
from freebody.numeric.rest_problem import RestProblem, rest_problem
from freebody.study.answering.draws import Draw
from freebody.study.friction.touching import TouchingAtRest
from freebody.tolerances import ROUND_OFF

_CLOSE = 1e-13  # ends are found to this, by their size
_BEYOND = 1e-11  # a margin that is surely negative
_BEYOND_GUESS = 4.0  # of the way to a guess, at most, that an end may lie beyond
_FAR = 1e7  # a parameter that so much of its size does not bring to an end is not limited
_NOTHING = 1e-7  # a coefficient of friction that is none: friction is needed, however little
N_STEPS = 80
N_TRIED = 24  # values among which one that holds is looked for
N_HALVED = 12  # how often the least of these angles is halved


@dataclass(frozen=True)
class HoldingEnd:
    """One end of the values with which a system holds, infinite where there is none. The forces and the motion are
    those at the end, or just beyond it; `problem` is what they belong to."""

    value: float
    problem: RestProblem
    optimum: Optimum


@dataclass(frozen=True)
class Parametric:
    """How a parameter enters: linearly in the loads, only in coefficients of friction, or in any other way."""

    name: str
    is_linear: bool
    is_friction: bool
    is_angle: bool
    is_acute: bool
    low: float  # values below this mean nothing
    is_in_pose: bool  # whether where things are, and what touches there, may depend on it

    def edge(self, touching: TouchingAtRest, draw: Draw, sign: int, near: float | None = None) -> HoldingEnd | None:
        """The largest (sign +1) or the smallest value with which the system holds; None if no value does. near: a value
        that may be it."""
        if self.is_linear:
            return self._linear(touching, draw, sign)
        if near is not None:
            found = self._around(touching, draw, sign, near)
            if found is not None:
                return found
        return self._followed(touching, draw, sign)

    def _around(self, touching: TouchingAtRest, draw: Draw, sign: int, near: float) -> HoldingEnd | None:
        """The end between two values close to an expected one, if it is there."""
        step = sign * 1e-3 * (abs(near) or 1.0)
        problems = [self.problem(touching, draw, near + k * step) for k in (-1, 1)]
        found = [None if p is None else margin(p) for p in problems]
        (inner, outer), (_p, beyond) = found, problems
        if inner is None or outer is None or beyond is None:
            return None
        if inner.value < -ROUND_OFF or outer.value >= -ROUND_OFF:
            return None
        return self._between(touching, draw, near - step, near + step, (beyond, outer))

    def problem(self, touching: TouchingAtRest, draw: Draw, value: float) -> RestProblem | None:
        """The system at rest at another value of the parameter; None where it cannot be assembled or something else
        touches."""
        try:
            reference = Reference(touching.held, {**draw.values, self.name: value})
            q = reference.assemble(guess=draw.q)
            if self.is_in_pose and not touching.is_admissible(reference, q):
                return None
            return rest_problem(reference, q, touching.dry_friction)
        except (CannotAnswer, ArithmeticError, ValueError):
            return None

    def _linear(self, touching: TouchingAtRest, draw: Draw, sign: int) -> HoldingEnd | None:
        unit = abs(draw.values.get(self.name, 0.0)) or 1.0
        first, second = (self.problem(touching, draw, k * unit) for k in (1.0, 2.0))
        if first is None or second is None:
            raise CannotAnswer(Message("the start cannot be assembled with other values of {x}", x=self.name))
        path = ray(first, second, unit)
        meant = [ends for ends in pieces(path, unit=unit) if ends[1].value > self.low + ROUND_OFF * unit]
        if not meant:
            return None  # what holds lies outside of the values that mean something
        own = draw.values.get(self.name, unit)

        def away(ends: tuple[Optimum, Optimum]) -> tuple[bool, float]:
            return ends[1].value <= 0.0, max(ends[0].value - own, own - ends[1].value, 0.0)

        found = min(meant, key=away)[0 if sign < 0 else 1]  # of the values about the model's own, positive if any are
        value = found.value
        return HoldingEnd(value, path.problem if math.isinf(value) else at(path, value), found)

    # -- following the margin -----------------------------------------------------------------
    def _followed(self, touching: TouchingAtRest, draw: Draw, sign: int) -> HoldingEnd | None:
        inside = self._holding(touching, draw)
        if inside is None:
            return None
        outside: float | None = None
        last: tuple[RestProblem, Optimum] | None = None
        for value in self._outwards(inside, sign):
            problem = self.problem(touching, draw, value)
            found = None if problem is None else margin(problem)
            if problem is None:
                break
            if found is None and self.is_friction and sign > 0:
                break  # round a drum its factor exp(mu*wrap) has no digits left; what holds with less holds with it
            if found is None:
                return None
            if found.value < -ROUND_OFF:
                outside, last = value, (problem, found)
                break
            inside = value
        if outside is None or last is None:
            problem = self.problem(touching, draw, inside)
            assert problem is not None
            found = margin(problem)
            assert found is not None
            is_end = sign < 0 and inside == self.low
            return HoldingEnd(self.low if is_end else sign * math.inf, problem, found)
        found = self._between(touching, draw, inside, outside, last)
        is_nothing = sign < 0 and self.is_friction and found.value < _NOTHING
        return HoldingEnd(0.0, found.problem, found.optimum) if is_nothing else found

    def _between(
        self, touching: TouchingAtRest, draw: Draw, inside: float, outside: float, last: tuple[RestProblem, Optimum]
    ) -> HoldingEnd:
        """The end between a value that holds and one that does not, by secants through the margins outside, which are
        smooth where inside they may vanish."""
        margins = [(outside, last[1].value)]
        for _ in range(N_STEPS):
            width = inside - outside
            if abs(width) <= _CLOSE * max(abs(inside), abs(outside)):
                break
            guess = outside + 0.5 * width
            if len(margins) > 1:
                (a, fa), (b, fb) = margins[-2:]
                secant = b - fb * (b - a) / (fb - fa) if fb != fa else guess
                share = (secant - outside) / width
                if 0.0 < share <= 1.0:
                    guess = outside + min(max(share, 1e-3), 1.0 - ROUND_OFF) * width
            problem = self.problem(touching, draw, guess)
            found = None if problem is None else margin(problem)
            if problem is None or found is None:
                break
            if found.value < -_BEYOND:
                outside, last = guess, (problem, found)
                margins.append((guess, found.value))
            else:
                inside = guess
                if len(margins) > 1 and abs(found.value) <= _BEYOND:
                    inside = _crossing(margins, guess) if found.value < 0.0 else guess
                    break
        return HoldingEnd(inside, *last)

    def _holding(self, touching: TouchingAtRest, draw: Draw) -> float | None:
        """A value with which the system holds: that of the draw, else one of several."""
        for value in [draw.values[self.name], *self._tried(draw.values[self.name])]:
            problem = self.problem(touching, draw, value)
            found = None if problem is None else margin(problem)
            if found is not None and found.value >= -ROUND_OFF:
                return value
        return None

    def _tried(self, value: float) -> Iterator[float]:
        if self.is_friction:
            yield from (value * 4.0**k for k in range(1, 13))
        elif self.is_angle:
            top = math.pi / 2 if self.is_acute else math.pi
            yield from ((k + 0.5) / N_TRIED * top for k in range(N_TRIED))
            yield from (top / N_TRIED * 2.0**-k for k in range(2, N_HALVED))  # rolling resistance holds by small ones
        else:
            yield from (value * 2.0 ** (sign * k / 2) for k in range(1, N_TRIED // 2) for sign in (1, -1))

    def _outwards(self, inside: float, sign: int) -> Iterator[float]:
        """Ever further values."""
        if self.is_angle:
            top = math.pi / 2 if self.is_acute else 2 * math.pi
            limit = top * (1 - ROUND_OFF) if sign > 0 else (ROUND_OFF if self.is_acute else -top)
            yield from (inside + (limit - inside) * k / N_TRIED for k in range(1, N_TRIED + 1))
        elif sign > 0:
            value = inside or 1.0
            while value < _FAR * (abs(inside) or 1.0):
                value *= 1.5
                yield value
        else:
            value = inside
            while value > self.low + (abs(inside) or 1.0) / _FAR:
                value = self.low + 0.6 * (value - self.low)
                yield value
            yield self.low


def _crossing(margins: Sequence[tuple[float, float]], guess: float) -> float:
    """Where the last margins outside come to nothing, if that is a little beyond a guess whose own margin is less than
    counts: a margin that hardly changes with the parameter is that small well outside."""
    (a, fa), (b, fb) = margins[-2:]
    if fa == fb:
        return guess
    end = b - fb * (b - a) / (fb - fa)
    return end if 1.0 <= (end - b) / (guess - b) <= _BEYOND_GUESS else guess
