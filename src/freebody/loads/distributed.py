"""A load spread along a straight line of a body: a beam's floor, snow on a rafter, water against a gate.

With the force per length q_0 at the first end of a line of length L and q_1 at the other, linear between them,

    F = (q_0 + q_1) L/2,    at    L/3 (q_0 + 2 q_1)/(q_0 + q_1)    from the first end.

It pushes a rigid body as an even part, through the middle of the line, and one that rises from zero or falls to it,
through the third of the line at its larger end. Source: Beer & Johnston, Vector Mechanics for Engineers: Statics,
sec. 5.3; Meriam & Kraige, Statics, sec. 5/6.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, Any, ClassVar

from freebody.language.expression import ZERO, Call, Expr, add, divide, multiply, negate, number
from freebody.language.sentences import Message
from freebody.language.units import STIFFNESS
from freebody.loads.base import Load
from freebody.loads.force import WAYS, pushed_along, with_way
from freebody.loads.law import Used, law
from freebody.measures.geometry import Point
from freebody.model import glyphs
from freebody.model.elements import AppliedLoad, Spread
from freebody.model.glyphs import Glyph
from freebody.model.polynomials import dot, polynomial, root
from freebody.model.spec import Formula, Heading

if TYPE_CHECKING:
    from freebody.model.names import Names

FORCE_PER_LENGTH = STIFFNESS
_SPANS = ("on", "from", "to")


class Distributed(Load, kind="distributed"):
    """`distributed: {between: [beam.start, beam.B], along: down, intensity: q}`: a force per length along the line from
    one point of a body to another; `intensity: [q0, q1]` rises or falls evenly from the first point to the second.
    `on: beam` is all of a rod, `on: beam, from: start, to: B` a part of it."""

    called: ClassVar[tuple[str, ...]] = ("distributed_load", "line_load", "uniform_load")

    instead: ClassVar[Mapping[str, str]] = dict.fromkeys(
        ("triangular", "trapezoidal", "linear", "Dreieckslast", "Trapezlast"),
        Message("a load that rises evenly is distributed with both values: {{..., intensity: [0, q]}}"),
    )

    more_words: ClassVar[Mapping[str, tuple[str, ...]]] = {
        **dict.fromkeys(_SPANS, ("between",)),
        **dict.fromkeys(WAYS, ("along", "intensity")),
    }

    between: tuple[str, str]
    intensity: Formula | list[Formula]
    along: Heading = "down"

    example = """
bodies: {beam: {rod: {mass: 3 kg, length: 2 m}}}
loads: {it: {distributed: {between: [beam.start, beam.end], along: down, intensity: [0 N/m, 5 N/m]}}}
"""

    @classmethod
    def from_plain(cls, value: object) -> dict[str, Any]:
        """`{on: beam}` is all of a rod, `{on: beam, from: start, to: B}` a part of it, `{from: beam.start, to: beam.B}`
        as well."""
        if isinstance(value, str | int | float):
            return {"intensity": value}
        given = with_way(super().from_plain(value), "intensity")
        body, *ends = (given.get(word) for word in _SPANS)
        is_whole = isinstance(body, str) and ends == [None, None]
        first, second = ("start", "end") if is_whole else ends
        if "between" in given or not (isinstance(first, str) and isinstance(second, str)):
            return given
        owner = f"{body}." if isinstance(body, str) else ""
        between = [end if "." in end else f"{owner}{end}" for end in (first, second)]
        return {"between": between, **{key: each for key, each in given.items() if key not in _SPANS}}

    def applied_loads(self, names: Names) -> list[AppliedLoad]:
        first, second = self._ends(names)
        if first.body != second.body or first.offset == second.offset:
            told = Message("a load is spread along a line from one point of a body to another point of it")
            names.problem(told, "between")
            return []
        return list(self._parts(names, first, second))

    def _parts(self, names: Names, first: Point, second: Point) -> Iterator[AppliedLoad]:
        length = _distance(names, first, second)
        (start, used), (end, _) = self._intensities(names)
        sloped = ZERO if start == end else add(end, negate(start))
        if start != ZERO and end != ZERO:
            yield self._part(names, "even" if sloped != ZERO else "", Spread(first, second), start, used, length)
        if sloped == ZERO:
            return
        if end == ZERO:
            yield self._part(names, "", Spread(second, first, rises=True), divide(start, number(2)), used, length)
        else:
            called = "" if start == ZERO else "rising"
            yield self._part(names, called, Spread(first, second, rises=True), divide(sloped, number(2)), used, length)

    def _part(self, names: Names, component: str, spread: Spread, mean: Expr, used: Used, length: Expr) -> AppliedLoad:
        pushed = pushed_along(names, spread.middle, self.along)
        return AppliedLoad(component, pushed, multiply(mean, length), used, spread=spread)

    def _ends(self, names: Names) -> tuple[Point, Point]:
        return names.point(self.between[0], "between", 0), names.point(self.between[1], "between", 1)

    def _intensities(self, names: Names) -> tuple[tuple[Expr, Used], tuple[Expr, Used]]:
        values = self.intensity if isinstance(self.intensity, list) else [self.intensity] * 2
        if len(values) != 2:
            names.problem(Message("give the force per length, or that at each of the two points"), "intensity")
            return (ZERO, ()), (ZERO, ())
        path = ("intensity",) if not isinstance(self.intensity, list) else None
        found = [law(names, value, FORCE_PER_LENGTH, *(path or ("intensity", k))) for k, value in enumerate(values)]
        used = tuple(dict.fromkeys(item for _, own in found for item in own))
        return (found[0][0], used), (found[1][0], used)

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        first, second = self._ends(names)
        (start, _), (end, _) = self._intensities(names)
        yield glyphs.Spread(first, second, names.direction(self.along, "along"), (start, end))


def _distance(names: Names, first: Point, second: Point) -> Expr:
    ways = [polynomial(add(b, negate(a))) for a, b in zip(first.offset, second.offset, strict=True)]
    ways = [way for way in ways if not way.is_zero]
    if len(ways) == 1:
        both = (ways[0].expression(), (-ways[0]).expression())
        return next((way for way in both if names.is_never_negative(way)), Call("abs", both[0]))
    square = dot(ways, ways)
    found = root(square).expression()
    return found if names.is_never_negative(found) else Call("sqrt", square.expression())
