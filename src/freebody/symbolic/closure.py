"""Closed loops solved for what they bind, and where they close at all.

An equation a cos q + b sin q + d = 0 has w^2 = a^2 + b^2 - d^2 with w = b cos q - a sin q, the sign that of the branch:

    cos q = (b w - a d)/(a^2 + b^2),    sin q = -(a w + b d)/(a^2 + b^2),    real if and only if a^2 + b^2 >= d^2.

Where b = 0, at a pose with values put in, cos q = -d/a and the sign of sin q is the branch, whatever the sign of a.

Two equations in two angles are such an equation where both are linear in the cosine and sine of one of them with
coefficients that the other does not enter: these follow, and their squares add to 1 (the dyad of a four-bar linkage).
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from functools import cached_property
from itertools import combinations

from freebody.errors import CannotAnswer, FormulaTooLong
from freebody.language.sentences import Message
from freebody.symbolic.atoms import Arc, angle_with
from freebody.symbolic.conditions import Condition, require
from freebody.symbolic.field import Field
from freebody.symbolic.functions import functions
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.reduced import without_square_roots
from freebody.symbolic.signs import Sign, sign_of
from freebody.symbolic.unknowns import Coordinate
from freebody.tolerances import ROUND_OFF

_MOST_TERMS = 400  # of an angle's cosine
_TO_THE_LEFT = -0.9  # the cosine of an angle that the tangent of its half jumps at soon
_MOST_PRODUCTS = 20_000  # of the terms of its numerator and denominator: its rate has those of them all


class Closure:
    """The closed loops of a model, as far as they can be solved one angle after the other. given: values of independent
    coordinates at the start, put in before that: the loops of a pose have solutions where those of the motion have
    none, or others on either side of a change of the dimensions."""

    def __init__(self, model: SymbolicModel, given: Mapping[int, Ratio] | None = None) -> None:
        self.model, self.field = model, model.field
        self._given = dict(given or {})
        self.sides: list[Ratio] = []  # positive on the branch on which the loops are assembled
        # of the angles: whether they are counted from the left, and the whole turns beside their principal values
        self._turned: dict[int, tuple[bool, Ratio]] = {}

    @cached_property
    def _solved(self) -> tuple[dict[int, Ratio], list[Ratio], list[Coordinate]]:
        """Values of bound angles with their cosines and sines, what must not be negative, and what stays bound."""
        values: dict[int, Ratio] = dict(self._given)
        needs: list[Ratio] = []
        left: list[Coordinate] = [
            d for d in self.model.dependent if any(d.index in self.inside(e.value) for e in self.model.loops)
        ]
        while left:
            step = next(self._steps(values, left), None)
            if step is None:
                break
            solved, found, need = step
            values = {g: self.field.lowest_terms(self.field.follow(x, found)) for g, x in values.items()} | found
            needs.append(need)
            left = [d for d in left if all(d is not k for k in solved)]
        return values, needs, left

    def take_sides(self) -> None:
        """Take the branches of the first start, where others are on other ones, so that those can be replaced."""
        with suppress(CannotAnswer):
            self._solved  # noqa: B018

    def inside(self, x: Ratio) -> frozenset[int]:
        return self.field.ingredients(x)

    def _steps(
        self, values: dict[int, Ratio], left: list[Coordinate]
    ) -> Iterator[tuple[list[Coordinate], dict[int, Ratio], Ratio]]:
        """(angles, their values, what must not be negative) for what can be solved for next."""
        bound = {d.index: d for d in left}
        loops = [self.field.follow(e.value, values).numerator() for e in self.model.loops]
        single: list[tuple[Coordinate, Ratio]] = []
        pairs: list[tuple[tuple[Ratio, Ratio], list[Coordinate]]] = []
        for x in loops:
            inside = [d for k, d in bound.items() if k in self.inside(x)]
            if len(inside) == 1:
                single.append((inside[0], x))
        for x, y in combinations(loops, 2):
            inside = [d for k, d in bound.items() if k in self.inside(x) | self.inside(y)]
            if len(inside) == 2:
                pairs.append(((x, y), inside))
        for d, x in single:
            parts = self.linear_in(x, d.index)
            if parts is not None:
                found, room = self._angle(d, *parts)
                yield [d], found, room
            elif (length := self._length(x, d)) is not None:
                yield [d], {d.index: length}, self.field.one
            elif (root := self._root(x, d)) is not None:
                yield [d], {d.index: root[0]}, root[1]
        for both, inside in pairs:
            for d, gone in (inside, inside[::-1]):
                equation = self.without(both, gone.index, d.index)
                parts = None if equation is None else self.linear_in(equation, d.index)
                if parts is not None:
                    found, room = self._angle(d, *parts)
                    yield [d, gone], found | self._other(both, gone, d, found), room
            for d, gone in (inside, inside[::-1]):
                equation = self.without(both, gone.index, d.index, anywhere=True)
                root = None if equation is None else self._root(equation, d)
                if root is not None:
                    found = {d.index: root[0]}
                    yield [d, gone], found | self._other(both, gone, d, found), root[1]

    def linear_in(self, x: Ratio, index: int) -> tuple[Ratio, Ratio, Ratio] | None:
        """a, b, d of a cos q + b sin q + d."""
        pair = self.field.pair_of(index)
        if pair is None or index in x.generators():
            return None
        if any(index in self.field.generators[g].made_of for g in x.generators() - set(pair)):
            return None
        in_cos = x.coefficients(pair[0])
        in_sin = in_cos[0].coefficients(pair[1])
        a = in_cos[1] if len(in_cos) > 1 else self.field.zero
        b = in_sin[1] if len(in_sin) > 1 else self.field.zero
        if len(in_cos) > 2 or len(in_sin) > 2 or pair[1] in a.generators():
            return None
        return a, b, in_sin[0]

    def _length(self, x: Ratio, d: Coordinate) -> Ratio | None:
        """l by a l + b = 0, as that of what a slot of a turning lever leads along a line."""
        parts = self._in_length(x, d)
        return self.field.lowest_terms(-parts[0] / parts[1]) if parts is not None and len(parts) == 2 else None

    def _root(self, x: Ratio, d: Coordinate) -> tuple[Ratio, Ratio] | None:
        """l by a l^2 + b l + c = 0 on its branch, and the square of a l + b/2: what goes round an axis on a sphere, or
        a rope between what drives off and what it draws."""
        parts = self._in_length(x, d)
        if parts is None or len(parts) != 3:
            return None
        f, (c, half, a) = self.field, (parts[0], parts[1] / 2, parts[2])
        if c.is_zero() and (is_zero := self._starts_at_zero(d)) is not None:
            return (f.zero if is_zero else f.lowest_terms(-parts[1] / a)), f.one
        if half.is_zero():
            square = f.lowest_terms(-c / a)
            return self.side(f.variable(d.index)) * f.sqrt(square), square
        square = f.lowest_terms(half * half - a * c)
        root = self.side(a * f.variable(d.index) + half) * f.sqrt(square)
        return f.lowest_terms((root - half) / a), square

    def _starts_at_zero(self, d: Coordinate) -> bool | None:
        """Which factor of l (a l + b) = 0 vanishes, by where a length starts; None where starts differ."""
        found = {abs(v) < ROUND_OFF for v in self.model.samples.start_numbers(d.index) if not math.isnan(v)}
        return found.pop() if len(found) == 1 else None

    def _in_length(self, x: Ratio, d: Coordinate) -> list[Ratio] | None:
        """The coefficients of a polynomial in a length, from the constant one up."""
        f, index = self.field, d.index
        if f.pair_of(index) is not None or any(index in f.generators[g].made_of for g in x.generators()):
            return None
        return x.coefficients(index)

    def put(self, angle: Coordinate, at: Ratio) -> dict[int, Ratio]:
        """An angle that has a value, with its cosine and sine."""
        fn = functions(self.field, self.model.samples.is_negative)
        c, s = self.field.pair_of(angle.index) or (-1, -1)
        return {angle.index: at, c: fn["cos"](at), s: fn["sin"](at)}

    def without_others(self, kept: int, given: Coordinate, at: Ratio) -> Iterator[Ratio]:
        """Equations between the variable `kept` and a bound angle that has the value `at`, without the other bound
        ones: those of the loops that contain no other, and those of two loops with one other."""
        put = self.put(given, at)
        loops = [self.field.follow(e.value, put).numerator() for e in self.model.loops]
        others = {d.index for d in self.model.dependent} - {given.index}
        for x in loops:
            if kept in self.inside(x) and not others & self.inside(x):
                yield x
        for x, y in combinations(loops, 2):
            inside = self.inside(x) | self.inside(y)
            gone = others & inside
            if kept in inside and len(gone) == 1:
                equation = self.without((x, y), gone.pop(), kept, anywhere=True)
                if equation is not None:
                    yield equation

    def _other(
        self, both: tuple[Ratio, Ratio], q: Coordinate, known: Coordinate, found: dict[int, Ratio]
    ) -> dict[int, Ratio]:
        """The second angle of a pair: as the first, where it can be solved for so, else by both equations."""
        f = self.field
        equation = self.without(both, known.index, q.index)
        parts = None if equation is None else self.linear_in(equation, q.index)
        if parts is not None:
            return self._angle(q, *parts)[0]
        first, second = (self.linear_in(f.follow(x, found), q.index) for x in both)
        assert first is not None
        assert second is not None
        (a, b, d), (A, B, D) = first, second
        det = a * B - A * b
        return self._values(q, f.lowest_terms((b * D - B * d) / det), f.lowest_terms((A * d - a * D) / det))

    def without(self, both: tuple[Ratio, Ratio], gone: int, kept: int, *, anywhere: bool = False) -> Ratio | None:
        """cos^2 + sin^2 = 1 of one angle, with its cosine and sine by the two equations. anywhere: also where these
        are divided by what is kept, as the direction of a ram by its length."""
        f = self.field
        first, second = (self.linear_in(x, gone) for x in both)
        if first is None or second is None:
            return None
        (a, b, d), (A, B, D) = first, second
        det = f.lowest_terms(a * B - A * b)
        is_kept_within = kept in f.ingredients(det)
        if det.is_zero() or (is_kept_within and not anywhere):
            return None
        cos, sin = b * D - B * d, A * d - a * D  # times det
        equation = cos * cos + sin * sin - det * det
        return (f.lowest_terms(equation / det) if is_kept_within else equation).numerator()

    def _angle(self, q: Coordinate, a: Ratio, b: Ratio, d: Ratio) -> tuple[dict[int, Ratio], Ratio]:
        """Its values, and what must not be negative."""
        f = self.field
        c, s = f.pair_of(q.index) or (-1, -1)
        square = f.lowest_terms(a * a + b * b)
        room = f.lowest_terms(square - d * d)
        if self._given and b.is_zero() and not a.is_zero() and not sign_of(a).is_strict:
            cos = f.lowest_terms(-d / a)
            return self._values(q, cos, self.side(f.variable(s)) * f.sqrt(f.lowest_terms(1 - cos * cos))), room
        w = f.sqrt(room) * self.side(b * f.variable(c) - a * f.variable(s))
        cos, sin = (b * w - a * d) / square, -(a * w + b * d) / square
        # F(q) (1 + T^2) = (d - a) T^2 + 2 b T + (d + a) with T = tan(q/2), of which the slope is 2 w
        half = None if (d - a).is_zero() else f.lowest_terms((w - b) / (d - a))
        return self._values(q, f.lowest_terms(cos), f.lowest_terms(sin), half), room

    def _values(self, q: Coordinate, cos: Ratio, sin: Ratio, half: Ratio | None = None) -> dict[int, Ratio]:
        """half: the tangent of half the angle, where that is shorter than by these."""
        f = self.field
        if any(len(x.num) > _MOST_TERMS or len(x.num) * _below(x) > _MOST_PRODUCTS for x in (cos, sin)):
            raise FormulaTooLong(Message("the formula of {x} would be too long", x=q.name))
        c, s = f.pair_of(q.index) or (-1, -1)
        ways = list(enumerate(_principals(f, cos, sin, half)))
        if any(x < _TO_THE_LEFT for x in self.model.samples.at_starts(cos)):  # the first one jumps near by
            ways.reverse()
        for is_left, principal in ways:
            turns = self._turns(q, principal)
            if len(turns) <= 1:
                self._turned[q.index] = bool(is_left), 2 * (turns.pop() if turns else 0) * f.pi
                return {c: cos, s: sin, q.index: principal + self._turned[q.index][1]}
        raise CannotAnswer(Message("which way the loop is assembled depends on the parameter values"))

    def _turns(self, q: Coordinate, value: Ratio) -> set[int]:
        """The whole turns by which an angle differs at the starts from a value with the same cosine and sine: a spring
        that twists with it feels them."""
        samples = self.model.samples
        pairs = zip(samples.start_numbers(q.index), samples.at_starts(value), strict=True)
        return {round((own - other) / math.tau) for own, other in pairs if not math.isnan(own - other)}

    def side(self, x: Ratio) -> int:
        """The sign of an element that is the branch on which the loop is assembled; where that depends on the
        parameters it is that of the first start, which the formulas take then."""
        signs = [v > 0 for v in self.model.samples.at_starts(x) if not math.isnan(v) and abs(v) > ROUND_OFF]
        if not signs:
            raise CannotAnswer(Message("which way the loop is assembled depends on the parameter values"))
        is_positive = signs[0] if all(s == signs[0] for s in signs) else not self.model.samples.is_negative(x)
        sign = 1 if is_positive else -1
        if all(sign * x != known for known in self.sides):
            self.sides.append(self.field.lowest_terms(sign * x))
        return sign

    # -- what it is for -----------------------------------------------------------------------
    def explicit(self, x: Ratio) -> Ratio:
        """The element by independent coordinates. Raises CannotAnswer where a loop has no short solution."""
        bound = {d.index for d in self.model.dependent}
        if not self.inside(x) & bound:
            return x
        values, _needs, _left = self._solved
        x = self.field.lowest_terms(self.field.follow(x, values))
        self._must_be_solved([d for d in self.model.dependent if d.index in self.inside(x)])
        return x

    def _must_be_solved(self, left: Sequence[Coordinate]) -> None:
        if left:
            raise CannotAnswer(
                Message(
                    "it depends on {names}, which follow only through closed loops that have no short solution",
                    names=", ".join(d.name for d in left),
                )
            )

    def at(self, values: Mapping[int, Ratio], known: Mapping[int, Ratio] | None = None) -> dict[int, Ratio]:
        """The angles that loops bind, with their cosines and sines, where the independent coordinates have values;
        some of them may be known. Raises CannotAnswer where a loop has no short solution."""
        found, _needs, left = self._solved
        self._must_be_solved(left)
        f, there = self.field, dict(known or {})
        for g, x in found.items():
            if g in there:
                continue
            try:
                there[g] = without_square_roots(self.model, f.lowest_terms(f.follow(x, values)))
            except ZeroDivisionError:  # the tangent of half an angle has no value there, the angle has
                pair = f.pair_of(g)
                if pair is None or not set(pair) <= there.keys():
                    raise
                cos, sin = there[pair[0]], there[pair[1]]
                is_left, turns = self._turned[g]
                there[g] = turns + (
                    _from_the_left(f, cos, sin, None) if is_left else _from_the_right(f, cos, sin, None)
                )
        return there

    def closes(self) -> list[Condition]:
        """Where the loops close, as far as that is known. Raises CannotAnswer where they have no short solution."""
        found: list[Condition] = []
        for x in self._solved[1]:
            condition, _possible = require(x, ">=", Message("can be assembled"))
            if condition is not None:
                found.append(condition)
        return found


def _below(x: Ratio) -> int:
    """The terms of a denominator."""
    return 1 if x.den is None else len(x.den)


def _principals(f: Field, cos: Ratio, sin: Ratio, half: Ratio | None) -> Iterator[Ratio]:
    """An angle by its cosine and sine, up to whole turns. Where the sign of one of them is known it is written by the
    other one, without a jump wherever the sign holds; the tangent of half the angle jumps where that points to the
    left, and that of half of what it lacks to half a turn where it points to the right."""
    if sign_of(cos) in (Sign.NEGATIVE, Sign.NONPOSITIVE):
        yield f.pi - angle_with(f, -cos, sin, ("asin", sin))
    elif sign_of(sin) in (Sign.NEGATIVE, Sign.NONPOSITIVE):
        yield -angle_with(f, cos, -sin, ("acos", cos))
    else:
        yield _from_the_right(f, cos, sin, half)
        if half is not None and not half.is_zero():
            yield _from_the_left(f, cos, sin, f.lowest_terms(1 / half))


def _from_the_right(f: Field, cos: Ratio, sin: Ratio, half: Ratio | None) -> Ratio:
    return angle_with(f, cos, sin, _arc(cos, sin, half))


def _from_the_left(f: Field, cos: Ratio, sin: Ratio, half: Ratio | None) -> Ratio:
    """half: the tangent of half of what the angle lacks to half a turn."""
    return f.pi - angle_with(f, -cos, sin, _arc(-cos, sin, half))


def _arc(cos: Ratio, sin: Ratio, half: Ratio | None) -> Arc | None:
    """How an angle is written: by its sine or cosine alone, where the sign of the other is known."""
    if sign_of(cos) in (Sign.POSITIVE, Sign.NONNEGATIVE):
        return "asin", sin
    if sign_of(sin) in (Sign.POSITIVE, Sign.NONNEGATIVE):
        return "acos", cos
    return None if half is None else ("half", half)


def explicit(model: SymbolicModel, x: Ratio) -> Ratio:
    """The element by independent coordinates. Raises CannotAnswer where a loop has no short solution."""
    return Closure(model).explicit(x)
