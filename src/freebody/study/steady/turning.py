"""Zeros of an element round a turn of an angle, on which it depends through cosine c and sine s (and roots of these).

A factor of its numerator is solved where it is

    c or s                                  at quarters of the turn
    a polynomial in c, or in s, of degree 1 or 2
    a c + b s + d                           c = (-a d -+ b w)/n,  s = (-b d +- a w)/n,  n = a^2 + b^2,  w^2 = n - d^2
    one with a root                         by its norm, whose zeros contain its own

Any other factor must have no zero: its sign is followed round the turn in ball arithmetic at random admissible values.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import flint

from freebody.budgets import allowed
from freebody.errors import CannotAnswer
from freebody.language.expression import ZERO, Call, Expr, Symbol, evaluate
from freebody.language.notation import Stated, compared, joined, reworded, to_python, to_text
from freebody.language.sentences import Message
from freebody.symbolic.functions import functions
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.reduced import without_square_roots
from freebody.symbolic.signs import Sign, sign_of
from freebody.symbolic.tidy import tidy
from freebody.symbolic.unknowns import Coordinate
from freebody.symbolic.waves import sine_form
from freebody.tolerances import ROUND_OFF

_NEVER = (Sign.NEGATIVE, Sign.NONPOSITIVE)  # of what is under a root: at most in single cases of the parameters
_MOST_TERMS = 12  # of an expression that is shown
_DEEPEST = 14  # halvings of a sixteenth of a turn
_N_LOOKS = 48  # points at which a change of sign is looked for first
_MOST_WORK = 2_000_000  # terms that are computed until a sum is shown to keep its sign
_flint: Any = flint
_EIGHTHS_AND_TWELFTHS = {Fraction(n, 4) for n in range(5)}  # squares of cosines at multiples of 30 and of 45 degrees


@dataclass(frozen=True)
class TurnPose:
    """A pose of the turn by cosine and sine; real while some elements are not negative."""

    cos: Ratio
    sin: Ratio
    must_be_positive: tuple[Ratio, ...] = ()

    def text(self, angle: Expr) -> str:
        if (degrees := self._degrees()) is not None:
            turns = Fraction(degrees, 180)
            over = "" if turns.denominator == 1 else f"/{turns.denominator}"
            machine = {-1: "-pi", 0: "0", 1: "pi"}.get(turns.numerator, f"{turns.numerator}*pi") + over * bool(turns)
            return Stated(f"{to_text(angle)} = {degrees}{'°' * bool(degrees)}", f"{to_python(angle)} == {machine}")
        cos, sin = Call("cos", angle), Call("sin", angle)
        return joined((compared(cos, "=", tidy(self.cos)), compared(sin, "=", tidy(self.sin))), ", ")

    def _degrees(self) -> int | None:
        """The angle where it is a multiple of 30 or 45 degrees, in (-180, 180]."""
        squares = (self.cos * self.cos).fraction(), (self.sin * self.sin).fraction()
        if not {*squares} <= _EIGHTHS_AND_TWELFTHS or sum(x for x in squares if x is not None) != 1:
            return None
        cos, sin = (float(evaluate(tidy(x), {})) for x in (self.cos, self.sin))
        return 180 if cos == -1.0 else round(math.degrees(math.atan2(sin, cos)))


@dataclass(frozen=True)
class Extremum:
    """A stationary value, and where it is reached."""

    value: Ratio
    places: tuple[TurnPose, ...]


def _shown(x: Ratio) -> str:
    """An expression, or that it is a long one."""
    return to_text(tidy(x)) if len(x.num) <= _MOST_TERMS else Message("a sum of {n} terms", n=len(x.num))


class TurningAngle:
    """One angle of a model on its way round. others: more admissible values, beside the samples of the model; shown: as
    what it is told."""

    def __init__(self, model: SymbolicModel, angle: Coordinate, others: Sequence[dict[int, Any]] = ()) -> None:
        self.model, self.angle, self.field = model, angle, model.field
        self.others = tuple(others)
        self.notes: list[str] = []
        self.shown: Expr = Symbol(angle.name)
        self.cos, self.sin = self._pair()

    def _pair(self) -> tuple[int, int]:
        """The generators of its cosine and sine."""
        pair = self.field.pair_of(self.angle.index)
        if pair is None:
            raise CannotAnswer(
                Message("it depends on {angle} in another way than by its cosine and sine", angle=self.angle.name)
            )
        return pair

    def moves(self, index: int) -> bool:
        return self.angle.index in {index} | self.field.generators[index].made_of

    def occurs_in(self, x: Ratio) -> bool:
        return any(map(self.moves, x.generators()))

    def check(self, x: Ratio) -> None:
        """Raises CannotAnswer where the angle occurs outside of its cosine, its sine and what is made of these."""
        for index in sorted(self.field.ingredients(x)):
            kind = self.field.generators[index].kind
            if index == self.angle.index and index in x.generators():
                raise CannotAnswer(Message("it grows with every turn of {x}", x=self.angle.name))
            if self.moves(index) and kind in ("cos", "sin") and index not in (self.cos, self.sin):
                raise CannotAnswer(
                    Message("it depends on a part or a multiple of {x}, and has no closed form here", x=self.angle.name)
                )

    def at(self, x: Ratio, place: TurnPose) -> Ratio:
        """The element in a place. Raises CannotAnswer where it has no finite value."""
        try:
            value = self.field.follow(x, {self.cos: place.cos, self.sin: place.sin})
        except ZeroDivisionError:
            raise CannotAnswer(Message("it grows without bound near {place}", place=place.text(self.shown))) from None
        return self._with_arcs(without_square_roots(self.model, self.field.lowest_terms(value)))

    def _with_arcs(self, x: Ratio) -> Ratio:
        """Angles of known cosine and sine by the arc of a cosine without roots, or acute ones by that of their sine."""
        arcs: dict[int, Ratio] = {}
        fn = functions(self.field, self.model.samples.is_negative)
        for index in x.generators() & self.field.known_pairs.keys():
            cos, sin = (self._plain(part) for part in self.field.known_pairs[index])
            signs = {v > 0 for v in self.model.samples.at_starts(sin) if not math.isnan(v)}
            if not self._has_roots(cos) and self._has_roots(sin) and len(signs) == 1:
                arcs[index] = fn["acos"](cos) if signs == {True} else -fn["acos"](cos)
            elif all(v > 0 for v in self.model.samples.at_starts(cos)):
                sign = -1 if sign_of(sin) is Sign.NEGATIVE else 1
                arcs[index] = sign * fn["asin"](sign * sin)
        return self.field.substitute(x, arcs)

    def _plain(self, x: Ratio) -> Ratio:
        return self.field.lowest_terms(without_square_roots(self.model, self.field.lowest_terms(x)))

    def _has_roots(self, x: Ratio) -> bool:
        return any(self.field.generators[g].kind == "root" for g in x.generators())

    # -- zeros --------------------------------------------------------------------------------
    def zeros(self, x: Ratio) -> list[TurnPose]:
        """Places in which a numerator vanishes."""
        found: list[TurnPose] = []
        for base, _exponent in self.field.factor(x.num)[1]:
            if self.occurs_in(base):
                found += [p for p in self._factor(base) if all(p.cos != k.cos or p.sin != k.sin for k in found)]
        return found

    def roots_in(self, x: Ratio) -> list[int]:
        """The roots in it that move, the inner ones first."""
        return [i for i in sorted(x.generators()) if self.field.generators[i].kind == "root" and self.moves(i)]

    def norm(self, x: Ratio) -> Ratio:
        """The product over both signs of every root in it that moves."""
        for index in reversed(self.roots_in(x)):
            p, q = (*x.coefficients(index), self.field.zero)[:2]
            x = p * p - q * q * self.field.radicand(index)
        return x

    def _factor(self, base: Ratio) -> list[TurnPose]:
        if self.roots_in(base):
            return self._with_root(base)
        own = [i for i in base.generators() if self.moves(i)]
        if any(i not in (self.cos, self.sin) for i in own):
            raise CannotAnswer(Message("where {x} vanishes has no closed form", x=_shown(base)))
        if own == [self.cos]:
            return self._in_one(base, base.coefficients(self.cos), lambda u, w: ((u, w), (u, -w)))
        in_sin = self._in_sine(base)
        if in_sin is not None:
            return in_sin
        linear = self._linear(base)
        if linear is None:
            self._prove_no_zero(base)
            return []
        return linear

    def _with_root(self, base: Ratio) -> list[TurnPose]:
        if len(base.generators()) == 1:
            return []  # the root itself: there it ends, and `must_exist` sees to it
        norm = self.norm(base)
        if not self.occurs_in(norm):
            return []
        return [p for p in self.zeros(norm.numerator()) if self._vanishes(base, p)]

    def _vanishes(self, base: Ratio, place: TurnPose) -> bool:
        value = self.at(base, place)
        if value.is_zero() or any(sign_of(x) in (Sign.NEGATIVE,) for x in place.must_be_positive):
            return value.is_zero()
        numbers = [v for v in self.model.samples.at_starts(value) if not math.isnan(v)]
        return bool(numbers) and all(abs(v) < ROUND_OFF for v in numbers)

    def _in_sine(self, base: Ratio) -> list[TurnPose] | None:
        """Zeros of a polynomial that is one in s alone, with c^2 = 1 - s^2; None where it is not."""
        f = self.field
        terms = sine_form(f.terms(base.num), self.cos, self.sin)
        if any(g == self.cos for m in terms for g, _e in m):
            return None
        found: list[TurnPose] = []
        for coefficients in f.factors_in(terms, self.sin):
            found += self._in_one(base, coefficients, lambda u, w: ((w, u), (-w, u)))
        return found

    def _in_one(
        self, base: Ratio, c: list[Ratio], both: Callable[[Ratio, Ratio], tuple[tuple[Ratio, Ratio], ...]]
    ) -> list[TurnPose]:
        """Zeros of a polynomial in the cosine, or in the sine, alone, by its coefficients."""
        f = self.field
        if len(c) > 3:
            self._prove_no_zero(base)
            return []
        if len(c) == 2:
            values, real = [-c[0] / c[1]], ()
        else:
            inside = c[1] * c[1] - 4 * c[0] * c[2]
            if sign_of(inside) in _NEVER:
                return []
            root = f.sqrt(inside)
            values, real = [(-c[1] - root) / (2 * c[2]), (-c[1] + root) / (2 * c[2])], (inside,)
        found: list[TurnPose] = []
        for u in values:
            room = 1 - u * u
            if room.is_zero():
                found.append(TurnPose(*both(u, f.zero)[0], real))
            elif sign_of(room) not in _NEVER:
                found += [TurnPose(cos, sin, (*real, room)) for cos, sin in both(u, f.sqrt(room))]
        return found

    def _linear(self, base: Ratio) -> list[TurnPose] | None:
        """a c + b s + d = 0."""
        f = self.field
        in_cos = base.coefficients(self.cos)
        if len(in_cos) > 2:
            return None
        a, in_sin = in_cos[1], in_cos[0].coefficients(self.sin)
        if self.sin in a.generators() or len(in_sin) > 2:
            return None
        d, b = in_sin[0], in_sin[1]
        square = a * a + b * b
        room = square - d * d
        if sign_of(room) in _NEVER and not room.is_zero():
            return []
        w = f.sqrt(room)
        must = () if d.is_zero() else (room,)
        return [
            TurnPose(f.lowest_terms((-a * d - e * b * w) / square), f.lowest_terms((-b * d + e * a * w) / square), must)
            for e in (1, -1)
        ]

    # -- proofs -------------------------------------------------------------------------------
    def _prove_no_zero(self, base: Ratio) -> None:
        """Raises CannotAnswer unless the factor keeps its sign round the turn at all samples."""
        samples = self.model.samples
        shown, starts = _shown(base), [samples.numbers(s) for s in samples.points if s.is_start]
        starts += self.others
        for numbers in starts:
            if not self._keeps_its_sign(base, numbers):
                raise CannotAnswer(Message("where {x} = 0 has no closed form", x=shown))
        words = Message(
            "{x} does not vanish on the way: shown in ball arithmetic for {n} sets of parameter values",
            x=shown,
            n=len(starts),
        )
        self.notes.append(reworded(words, compared(tidy(base), "!=", ZERO)))

    def _keeps_its_sign(self, base: Ratio, values: dict[int, Any]) -> bool:
        arb = _flint.arb
        fixed = {i: arb(float(values[i])) for i in base.generators() if not self.moves(i)}

        def at(middle: Any, half: Any) -> Any:
            angle = arb(middle, half)
            return self.field.evaluate(base, fixed | {self.cos: angle.cos(), self.sin: angle.sin()})

        # a zero is seen sooner than it is not excluded
        signs = {bool(at(math.tau * k / _N_LOOKS, 0.0) > 0) for k in range(_N_LOOKS)}
        if len(signs) > 1:
            return False
        left = allowed(_MOST_WORK) // len(base.num)

        def excludes_zero(middle: Any, half: Any, depth: int) -> bool:
            nonlocal left
            left -= 1
            if left < 0:
                return False
            x = at(middle, half)
            if not x.contains(0):
                return True
            if depth == 0:
                return False
            return excludes_zero(middle - half / 2, half / 2, depth - 1) and excludes_zero(
                middle + half / 2, half / 2, depth - 1
            )

        width = math.pi / 8
        return all(excludes_zero((k + 0.5) * width, 0.51 * width, _DEEPEST) for k in range(16))
