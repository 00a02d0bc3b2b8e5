"""Strings as loads: one that stretches, and one that is pulled with a given tension; from point to point, through
smooth rings and over small pulleys, in the plane and in space.

With the length l = sum of |r_k+1 - r_k| the string pulls with one tension S on all its way, and its work is -S dl:

    elastic      S = k (l - l_0), none where it is slack (l < l_0)
    tensioned    S as given, as of a long string with a weight at its far end, or of a winch that slips
"""

from __future__ import annotations

from collections.abc import Iterable
from itertools import pairwise
from typing import TYPE_CHECKING, Any, ClassVar

from pydantic import ConfigDict, Field

from freebody.language.expression import Call, Expr, Symbol, divide, multiply, negate, number, power
from freebody.language.sentences import Message
from freebody.language.units import AREA, FORCE, LENGTH, STIFFNESS
from freebody.loads.base import Load
from freebody.loads.law import law
from freebody.measures.combination import Combination, Composed
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Distance
from freebody.measures.geometry import AXES, GROUND, ONE, ZERO, Point
from freebody.model import glyphs
from freebody.model.elements import VALUE, AppliedLoad, Validity
from freebody.model.glyphs import Glyph
from freebody.model.one_sided import OneSided
from freebody.model.spec import Formula

if TYPE_CHECKING:
    from freebody.model.names import Names


class _OverPoints(Load):
    """A string from a point over others to a last one."""

    start: str = Field(alias="from")
    to: str
    over: list[str] = Field(default_factory=list[str])

    model_config = ConfigDict(populate_by_name=True)
    pulling_sign = -1
    stores_energy = True

    def _points(self, names: Names) -> list[Point]:
        between = [names.point(text, "over", k) for k, text in enumerate(self.over)]
        return [names.point(self.start, "from"), *between, names.point(self.to, "to")]

    def _length(self, names: Names) -> tuple[tuple[str, Distance], ...]:
        return tuple((f"@l{k}", Distance(a, b)) for k, (a, b) in enumerate(pairwise(self._points(names)), 1))

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        nodes = tuple(glyphs.Node(point, ZERO) for point in self._points(names))
        yield glyphs.Rope(nodes, tuple(glyphs.Lead(None) for _ in nodes[1:]))


class ElasticString(_OverPoints, kind="elastic_string"):
    """`elastic_string: {from: ground.A, over: [ground.B], to: ball, stiffness: k, length: l0}`: a rubber band, a bungee
    cord: pulls with k (l - l0) along all its way, through smooth rings and over small pulleys (`over`), and is slack
    where it is shorter than l0. Without a length it is relaxed at the start. `taut: true` leaves the case of slackness
    out: it stays taut."""

    called: ClassVar[tuple[str, ...]] = ("rubber band", "bungee cord", "elastic", "spring")

    stiffness: Formula
    length: Formula | None = None
    taut: bool = False

    example = """
bodies: {ball: {particle: {mass: 1 kg}, at: [2 m, 0]}}
loads: {it: {elastic_string: {from: ground.A, to: ball, stiffness: 5 N/m, length: 1 m}}}
"""

    def valid_where(self, names: Names) -> list[Validity]:
        natural = names.length_or(self, "length")
        if not self.taut or natural is None:
            return []
        parts = self._length(names)
        length = Composed(_sum(parts), parts, LENGTH)
        return [Validity(length, natural, 1, Message("the elastic string from {start} is taut", start=self.start))]

    def applied_loads(self, names: Names) -> list[AppliedLoad]:
        parts = self._length(names)
        k = names.positive(self, "stiffness", STIFFNESS)
        natural = names.length_or(self, "length")
        if natural is None:
            stretch: Any = Combination(tuple((ONE, part) for _name, part in parts), LENGTH)
        else:
            stretch = Composed(_sum(parts) - natural, parts, LENGTH)
        if self.taut:
            names.assumptions.append(Message("the elastic string from {start} stays taut", start=self.start))
            return [AppliedLoad("", stretch, negate(multiply(k, VALUE)))]
        if natural is not None and self._starts_at_its_anchor(names):
            pushed, law = self._stretched(names, natural), negate(multiply(k, VALUE))
        else:  # (e + |e|)/2 is e where it is positive, and 0 elsewhere
            pushed, law = stretch, negate(divide(multiply(k, VALUE + Call("abs", VALUE)), number(2)))
        if natural is None:
            return [AppliedLoad("", pushed, law)]
        length, limit = self._as_far(names, natural)
        return [AppliedLoad("", pushed, law, one_sided=OneSided(length, limit, stretch, negate(multiply(k, VALUE))))]

    def _as_far(self, names: Names, natural: Expr) -> tuple[Composed, Expr]:
        """How long it is, and how long it is at least where it is taut: of a straight string by squares, which have a
        gradient also where the ends meet."""
        parts = self._length(names)
        if len(parts) > 1:
            return Composed(_sum(parts), parts, LENGTH), natural
        square, sides = self._square(names)
        return Composed(square, sides, AREA), power(natural, number(2))

    def _starts_at_its_anchor(self, names: Names) -> bool:
        """Whether the model puts both ends in one place, where the string has no direction."""
        ends = self._points(names)
        if len(ends) != 2:
            return False
        for held, moved in (ends, ends[::-1]):
            body = names.known(moved.body)
            if held.body == GROUND and body.start.at is not None and body.points[body.start.at[0]] == moved.offset:
                gaps = [names.numeric(a - b) for a, b in zip(body.start.at[1], held.offset, strict=False)]
                return all(gap == 0.0 for gap in gaps)
        started = (names.measures[name] for name in names.started_at_zero if name in names.measures)
        between = {(p.body, p.offset) for p in ends}
        return any(
            isinstance(m, Displacement) and {(p.body, p.offset) for p in (m.of, m.origin)} == between for m in started
        )

    def _stretched(self, names: Names, natural: Expr) -> Composed:
        """max(l, l_0) - l_0, with max(a, b) = (a + b + |a - b|)/2 of the squares: it has a gradient also where the ends
        meet, which is zero."""
        square, parts = self._square(names)
        relaxed = natural * natural
        larger = divide(square + relaxed + Call("abs", square - relaxed), number(2))
        return Composed(Call("sqrt", larger) - natural, parts, LENGTH)

    def _square(self, names: Names) -> tuple[Expr, tuple[tuple[str, Displacement], ...]]:
        """The square of the length of a straight string, and what it is made of."""
        first, last = self._points(names)
        axes = zip(("@x", "@y", "@z") if names.space else ("@x", "@y"), AXES, strict=False)
        parts = tuple((name, Displacement(last, first, axis)) for name, axis in axes)
        square: Expr = ZERO
        for name, _part in parts:
            square = square + Symbol(name) * Symbol(name)
        return square, parts


class TensionedString(_OverPoints, kind="tensioned_string"):
    """`tensioned_string: {from: ground.winch, over: [ground.B], to: block, tension: S}`: pulls with the tension S along
    all its way, through smooth rings and over small pulleys (`over`). The tension may depend on time `t` and on named
    measures and their rates."""

    called: ClassVar[tuple[str, ...]] = ("string", "rope", "cord", "cable")

    tension: Formula

    example = """
bodies: {ball: {particle: {mass: 1 kg}, at: [2 m, 0]}}
loads: {it: {tensioned_string: {from: ground.A, to: ball, tension: 5 N}}}
"""

    def applied_loads(self, names: Names) -> list[AppliedLoad]:
        parts = self._length(names)
        tension, used = law(names, self.tension, FORCE, "tension")
        return [AppliedLoad("", Composed(_sum(parts), parts, LENGTH), negate(tension), used)]


def _sum(parts: tuple[tuple[str, Distance], ...]) -> Expr:
    total: Expr = ZERO
    for name, _part in parts:
        total = total + Symbol(name)
    return total
