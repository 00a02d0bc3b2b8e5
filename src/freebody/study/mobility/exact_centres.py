"""Instant centres and velocity ratios in closed form, where the pose has one.

With one freedom all velocities are in proportion to one speed, which cancels. A pose given by the user (angles, places,
named measures) is put in; the angles of a closed loop follow from its equations,

    a cos(phi) + b sin(phi) + d = 0:   cos(phi) = (-a d -+ b w)/(a^2 + b^2),   w = sqrt(a^2 + b^2 - d^2),

two equations in two angles by that after the one angle is eliminated, as where two circles intersect. The branch
is the one of the pose in numbers. What has no such formula is left out, and every formula is compared with the numbers
before it is shown.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from itertools import combinations
from typing import Any

from freebody.errors import CannotAnswer
from freebody.language.expression import PI, Expr, Symbol
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.measures.geometry import GROUND
from freebody.questions.centres import InstantCentre
from freebody.study.mobility.centres import CentreOfPair
from freebody.study.setup import Setup
from freebody.symbolic.linear import RHS, Row, solve
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.state import SymbolicState
from freebody.symbolic.tidy import tidy
from freebody.system.system import System
from freebody.tolerances import ROUND_OFF

_MOST_TERMS = 40  # of a formula that is shown
_MOST_TERMS_OF_ANGLE = 6  # of what a loop makes of a cosine or sine

Exact = dict[tuple[str, str], tuple[Expr, Expr]]


class ExactPose:
    """The pose of a system with one freedom, in formulas."""

    def __init__(self, system: System) -> None:
        """Raises CannotAnswer, ModelError where the symbolic route does not come through."""
        self.system = system
        self.setup = Setup(system, 1)
        model, start = self.setup.model, self.setup.start
        if len(model.coordinates) != 1:
            raise CannotAnswer(Message("formulas of centres and ratios need exactly one freedom"))
        told = {c.index: start.values[c.index] for c in model.coordinates if c.index in start.values}
        self._numbers = model.samples.numbers(self.setup.draws[0].sample())
        self._state = SymbolicState(model, told)
        loops = [model.field.follow(loop.value, told).numerator() for loop in model.loops]
        angles = _LoopAngles(self, loops).solved()
        # what is longer than this makes formulas that nobody reads
        self._angles = angles if all(map(self._is_short, angles.values())) else {}

    def _is_short(self, x: Ratio) -> bool:
        """Whether what a loop makes of a cosine or sine is worth putting in: a few terms in parameters of the model,
        one root at most. Roots of roots, and numbers alone, make formulas that are long and slow."""
        f = self.setup.model.field
        if x.fraction() is not None:
            return True
        used = [f.generators[k] for k in f.ingredients(x)]
        roots = [g for g in used if g.kind == "root" and g.made_of]
        has_parameter = any(g.kind == "parameter" and g.display != PI for g in used)
        return has_parameter and len(roots) <= 1 and max(len(x.num), len(x.denominator().num)) <= _MOST_TERMS_OF_ANGLE

    def centres(self, known: Mapping[tuple[str, str], CentreOfPair]) -> Exact:
        """Formulas of those centres that lie in the finite and have one."""
        found: Exact = {}
        for pair in combinations([GROUND, *(b.name for b in self.system.moving if b.turns)], 2):
            number = known.get(pair)
            if number is None or number.at is None:
                continue
            with suppress(CannotAnswer, ZeroDivisionError):
                centre: Any = InstantCentre(pair[1], pair[0]).value(self.system, self._state)
                x, y = (self._shown(part, value) for part, value in zip(centre, number.at, strict=True))
                if x is not None and y is not None:
                    found[pair] = x, y
        return found

    def ratio(self, measure: Measure, driving: Measure, number: float) -> Expr | None:
        """Rate of a measure per unit rate of another one."""
        with suppress(CannotAnswer, ZeroDivisionError):
            return self._shown(self._state.rate(measure) / self._state.rate(driving), number)
        return None

    def number(self, x: Ratio) -> float:
        """The value of an element at the pose."""
        f = self.setup.model.field
        return float(f.evaluate(x, f.complete(self._numbers)))

    def is_told(self, index: int) -> bool:
        """Whether a generator is a parameter of the model, or made of these."""
        g = self.setup.model.field.generators[index]
        if g.kind == "parameter":
            return isinstance(g.display, Symbol) and (g.display.name in self.system.parameters or g.display == PI)
        if g.kind in ("cos", "sin"):  # of an angle of the model, not of some number of degrees
            return any(self.setup.model.field.generators[k].display != PI for k in g.made_of)
        return g.kind in ("root", "function")

    def _shown(self, x: Ratio | int, number: float) -> Expr | None:
        """The formula, if it is one in the parameters alone, short, and has this value."""
        f = self.setup.model.field
        plain = f.element(x)
        if max(len(plain.num), len(plain.denominator().num)) > _MOST_TERMS:
            return None
        element = f.substitute(plain, self._angles)
        if max(len(element.num), len(element.denominator().num)) > _MOST_TERMS:
            return None
        element = f.lowest_terms(element)
        if not all(map(self.is_told, f.ingredients(element))):
            return None
        try:
            value = self.number(element)
        except (KeyError, ValueError, ArithmeticError):
            return None
        if not math.isclose(value, number, rel_tol=ROUND_OFF, abs_tol=ROUND_OFF):
            return None
        return tidy(element)


class _LoopAngles:
    """Cosines and sines of the angles that closed loops bind, by their generators."""

    def __init__(self, pose: ExactPose, loops: Sequence[Ratio]) -> None:
        self.pose = pose
        self.field = pose.setup.model.field
        self.loops = list(loops)
        self.pairs: dict[int, tuple[int, int]] = {}  # angle -> cosine, sine
        for c in pose.setup.model.dependent:
            for cosine, angle in self.field.angles.items():
                if angle == self.field.variable(c.index):
                    self.pairs[c.index] = cosine, cosine + 1

    def solved(self) -> dict[int, Ratio]:
        known: dict[int, Ratio] = {}
        while True:
            with suppress(CannotAnswer, ZeroDivisionError, KeyError, ValueError):
                found = next(self._steps([self.field.substitute(x, known) for x in self.loops]), None)
                if found:
                    known |= found
                    continue
            return known

    def _steps(self, loops: Sequence[Ratio]) -> Iterator[dict[int, Ratio]]:
        open_ = [x.numerator() for x in loops if not x.is_zero()]
        for x in open_:
            angles = self._angles_in(x)
            if angles is not None and len(angles) == 1:
                yield self._from_one(x, *self.pairs[angles[0]])
        for x, y in combinations(open_, 2):
            angles = self._angles_in(x + y * self.field.pi)
            if angles is not None and len(angles) == 2:
                yield self._from_two(x, y, *(self.pairs[a] for a in angles))

    def _angles_in(self, x: Ratio) -> list[int] | None:
        """The loop angles that occur; None if anything else does that is not told."""
        used = self.field.ingredients(x)
        angles = [a for a, pair in self.pairs.items() if used & {a, *pair}]
        rest = used - {g for a in angles for g in (a, *self.pairs[a])}
        return angles if all(map(self.pose.is_told, rest)) else None

    def _from_one(self, x: Ratio, cosine: int, sine: int) -> dict[int, Ratio]:
        """a c + b s + d = 0"""
        f = self.field
        a, b = f.partial(x, cosine), f.partial(x, sine)
        d = x - a * f.variable(cosine) - b * f.variable(sine)
        if {cosine, sine} & (a.generators() | b.generators() | d.generators()):
            return {}
        square = a * a + b * b
        w = f.sqrt(square - d * d, lambda y: self.pose.number(y) < 0)
        for sign in (1, -1):
            c, s = (-a * d - b * w * sign) / square, (-b * d + a * w * sign) / square
            numbers = self.pose.number(f.variable(cosine)), self.pose.number(f.variable(sine))
            if all(
                math.isclose(self.pose.number(y), n, abs_tol=ROUND_OFF) for y, n in zip((c, s), numbers, strict=True)
            ):
                return {cosine: c, sine: s}
        return {}

    def _from_two(self, x: Ratio, y: Ratio, first: tuple[int, int], second: tuple[int, int]) -> dict[int, Ratio]:
        """The first angle is eliminated: c1^2 + s1^2 = 1 becomes an equation in the second one."""
        f = self.field
        rows: list[Row] = []
        for equation in (x, y):
            row: Row = {k: p for k in first if not (p := f.partial(equation, k)).is_zero()}
            rest = equation - sum((p * f.variable(k) for k, p in row.items()), start=f.zero)
            if any(set(first) & p.generators() for p in (*row.values(), rest)):
                return {}
            row[RHS] = -rest
            rows.append(row)
        found = solve(f, rows, list(first), lambda z: z.is_zero())
        if found.free:
            return {}
        c1, s1 = (found.pivots[k].get(RHS, f.zero) for k in first)
        return self._from_one((c1 * c1 + s1 * s1 - 1).numerator(), *second)
