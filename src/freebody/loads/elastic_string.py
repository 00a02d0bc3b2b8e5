"""Strings as loads: one that stretches, and one that is pulled with a given tension; from point to point, through
smooth rings, over small pulleys and round wheels, in the plane and in space.

With the length l of straight parts and arcs (see `connections.string.stretching`) the string pulls with one tension S
on all its way, and its work is -S dl:

    elastic      S = k (l - l_0), none where it is slack (l < l_0)
    tensioned    S as given, as of a long string with a weight at its far end, or of a winch that slips
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from itertools import pairwise
from typing import TYPE_CHECKING, Any, ClassVar

from pydantic import ConfigDict, Field

from freebody.connections.string.stretching import StretchedWay, stretched_way
from freebody.connections.string.way import is_round, is_way_given, place_named, places_given
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
    """A string from a point over others, or round wheels, to a last one."""

    start: str | None = Field(default=None, alias="from")
    to: str | None = None
    over: list[str] = Field(default_factory=list[str])
    under: list[str] = Field(default_factory=list[str])
    path: list[str] = Field(default_factory=list[str])

    model_config = ConfigDict(populate_by_name=True)
    pulling_sign = -1
    stores_energy = True

    def _grips(self) -> list[str] | None:
        """The wheels on which it does not slip, as the model names them; None: all that can turn."""
        return []

    def _is_of_points(self, names: Names) -> bool:
        """Whether it runs from point to point only, through rings and over small pulleys."""
        return not any(is_round(names, text) for text, _field in places_given(self))

    def _points(self, names: Names) -> list[Point]:
        if not is_way_given(names, self):
            return []
        places = ((text.removeprefix("over ").removeprefix("under "), field) for text, field in places_given(self))
        return [names.point(text, *field) for text, field in places]

    def _way(self, names: Names) -> StretchedWay | None:
        """How it lies round wheels; None with problems noted."""
        return stretched_way(names, self, self._grips())

    def _length(self, names: Names) -> Composed | None:
        """From end to end; None with problems noted, or where it is fast on a wheel."""
        if self._is_of_points(names):
            return _sum(tuple((f"@l{k}", Distance(a, b)) for k, (a, b) in enumerate(pairwise(self._points(names)), 1)))
        way = self._way(names)
        return None if way is None or way.has_marks else way.length()

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        if self._is_of_points(names):
            nodes = tuple(glyphs.Node(point, ZERO) for point in self._points(names))
            yield glyphs.Rope(nodes, tuple(glyphs.Lead(None) for _ in nodes[1:]), relaxed=self._relaxed(names))
            return
        way = self._way(names)
        if way is not None:
            nodes = tuple(node.drawn(arm) for node, arm in zip(way.run.way, way.run.arms, strict=True))
            leads = tuple(glyphs.Lead(along) for along in way.run.leads)
            yield glyphs.Rope(nodes, leads, relaxed=None if way.has_marks else self._relaxed(names))

    def _relaxed(self, names: Names) -> Expr | None:
        """The length below which it is slack, where that is stated."""
        return None


class ElasticString(_OverPoints, kind="elastic_string"):
    """`elastic_string: {from: ground.A, over: [ground.B], to: ball, stiffness: k, length: l0}`: a rubber band, a bungee
    cord: pulls with k (l - l0) along all its way, through smooth rings and over small pulleys (`over`), and is slack
    where it is shorter than l0. Without a length it is relaxed at the start. `taut: true` leaves the case of slackness
    out: it stays taut.

    It also runs round the rims of wheels, `over: [wheel]`, and its way may be a `path` with drums, as that of a
    `string`; in space a joint guides what is at an end in the plane of the wheel beside it. It does not slip on the
    wheels that it `grips` (default: all bodies that can turn), and over the others it slides without friction (`grips:
    []` for all). At the start it is evenly stretched; from then on a section between grips has a tension of its own and
    the stiffness k L/L_section, L the length of all of it at the start, as long as it stretches little: what comes on a
    wheel and leaves it is not counted. From a drum on, l0 is that of what is off it at the start."""

    called: ClassVar[tuple[str, ...]] = ("rubber band", "bungee cord", "elastic", "spring")

    stiffness: Formula
    length: Formula | None = None
    taut: bool = False
    grips: list[str] | None = None

    example = """
bodies: {ball: {particle: {mass: 1 kg}, at: [2 m, 0]}}
loads: {it: {elastic_string: {from: ground.A, to: ball, stiffness: 5 N/m, length: 1 m}}}
"""

    more_examples: ClassVar[dict[str, str]] = {
        "round a wheel that it grips": """
bodies:
  wheel: {disk: {mass: 1 kg, radius: 0.2 m}}
  ball: {particle: {mass: 1 kg}, at: [0.2 m, -1 m]}
connections: {p: {pin: [ground.A, wheel]}}
loads: {it: {elastic_string: {from: ground.B, over: [wheel], to: ball, stiffness: 5 N/m, length: 1 m}}}
"""
    }

    def _grips(self) -> list[str] | None:
        return self.grips

    def _relaxed(self, names: Names) -> Expr | None:
        return names.length_or(self, "length")

    def valid_where(self, names: Names) -> list[Validity]:
        natural = names.length_or(self, "length")
        length = self._length(names) if self.taut and natural is not None else None
        if length is None or natural is None:
            return []
        start = place_named(places_given(self)[0][0])
        return [Validity(length, natural, 1, Message("the elastic string from {start} is taut", start=start))]

    def applied_loads(self, names: Names) -> list[AppliedLoad]:
        if not self._is_of_points(names):
            way = self._way(names)
            if way is None:
                return []
            if way.has_marks:
                return self._by_sections(names, way)
        else:
            way = None
            if self.grips:
                names.problem(Message("it grips wheels only, and runs round none: over: [wheel]"), "grips")
        length = self._length(names)
        if length is None or not is_way_given(names, self):
            return []
        k = names.positive(self, "stiffness", STIFFNESS)
        natural = names.length_or(self, "length")
        if natural is None:
            terms = () if way is None else way.sections[0].terms
            stretch: Any = Combination(terms or tuple((ONE, part) for _name, part in length.measures), LENGTH)
        else:
            stretch = replace(length, expression=length.expression - natural)
        if self.taut:
            self._note_taut(names)
            return [AppliedLoad("", stretch, negate(multiply(k, VALUE)))]
        if natural is not None and self._starts_at_its_anchor(names):
            pushed, law = self._stretched(names, natural), negate(multiply(k, VALUE))
        else:
            pushed, law = stretch, negate(multiply(k, _where_positive(VALUE)))
        if natural is None:
            return [AppliedLoad("", pushed, law)]
        length, limit = self._as_far(names, length, natural)
        return [AppliedLoad("", pushed, law, one_sided=OneSided(length, limit, stretch, negate(multiply(k, VALUE))))]

    def _note_taut(self, names: Names) -> None:
        start = place_named(places_given(self)[0][0])
        names.assumptions.append(Message("the elastic string from {start} stays taut", start=start))

    def _by_sections(self, names: Names, way: StretchedWay) -> list[AppliedLoad]:
        """S_i = k (L - l_0) + k L/L_i (l_i - L_i), L_i and L as they are at the start."""
        k = names.positive(self, "stiffness", STIFFNESS)
        natural = names.length_or(self, "length")
        n_before, n = len(names.problems), len(way.sections)
        is_simple = n == 1 and natural is None
        free, whole = ([ONE], ONE) if is_simple else way.lengths_at_start() or ([ONE] * n, ONE)
        if len(names.problems) > n_before:
            return []
        if self.taut:
            self._note_taut(names)
        names.assumptions.append(
            Message(
                "the elastic string from {start} stretches little, so that what comes on a wheel that it grips, and "
                "leaves it, does not change its stiffness",
                start=place_named(places_given(self)[0][0]),
            )
        )
        found: list[AppliedLoad] = []
        for section, length in zip(way.sections, free, strict=True):
            stiffness = k if n == 1 else divide(multiply(k, whole), length)
            stretched = VALUE
            if natural is not None:  # e_i = l_i - L_i l_0/L
                stretched = VALUE + (whole - natural if n == 1 else length - divide(multiply(length, natural), whole))
            law = negate(multiply(stiffness, stretched if self.taut else _where_positive(stretched)))
            component = "" if n == 1 else section.component(n)
            found.append(AppliedLoad(component, Combination(section.terms, LENGTH), law))
        return found

    def _as_far(self, names: Names, length: Composed, natural: Expr) -> tuple[Composed, Expr]:
        """How long it is, and how long it is at least where it is taut: of a straight string by squares, which have a
        gradient also where the ends meet."""
        if len(length.measures) > 1:
            return length, natural
        square, sides = self._square(names)
        return Composed(square, sides, AREA), power(natural, number(2))

    def _starts_at_its_anchor(self, names: Names) -> bool:
        """Whether the model puts both ends in one place, where the string has no direction."""
        ends = self._points(names) if self._is_of_points(names) else []
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
        length = self._length(names)
        tension, used = law(names, self.tension, FORCE, "tension")
        return [] if length is None else [AppliedLoad("", length, negate(tension), used)]


def _where_positive(stretch: Expr) -> Expr:
    """(e + |e|)/2 is e where it is positive, and 0 elsewhere."""
    return divide(stretch + Call("abs", stretch), number(2))


def _sum(parts: tuple[tuple[str, Distance], ...]) -> Composed:
    """One length made of several."""
    total: Expr = ZERO
    for name, _part in parts:
        total = total + Symbol(name)
    return Composed(total, parts, LENGTH)
