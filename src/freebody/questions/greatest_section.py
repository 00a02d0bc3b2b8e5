"""Questions about where a rod is loaded most, and how much: the greatest bending moment, shear force or axial force.

What acts on the rod parts it into spans, in each of which all of these are polynomials in the place x, with dM/dx = V.
On 0 <= s = x/l <= 1 of a span of length l

    V = b_0 (1 - s)^2 + 2 b_1 s (1 - s) + b_2 s^2,    M = M_0 + integral of V dx,

at most, for loads along lines, weight and inertia are linear in x. b_0 and b_2 are its values at both ends, and b_1
follows from M_1 - M_0 = l (b_0 + b_1 + b_2)/3. So the greatest size stands at the end of a span, or where V = 0 for M,
and where V' = 0 for V. Source: Gere & Goodno, Mechanics of Materials, sec. 4.4 and 4.5; for polynomials by Bernstein's
base Farin, Curves and Surfaces for CAGD, ch. 6.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from math import copysign, sqrt
from typing import TYPE_CHECKING, Any, Literal

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, add, divide, negate, number
from freebody.language.sentences import Message, Sentence
from freebody.language.units import FORCE, LENGTH, TORQUE, Dimension
from freebody.model.elements import RigidBody
from freebody.model.state import State
from freebody.questions.base import Described, Path, Quantity
from freebody.questions.forms import NAME, Found, asked
from freebody.questions.section import (
    PARTS,
    Field,
    Order,
    Part,
    SectionForce,
    Side,
    fields_of,
    in_order,
    places_on,
    rod_named,
    rods_of,
)
from freebody.tolerances import LEAST, ROUNDED

if TYPE_CHECKING:
    from freebody.model.names import Names

_LETTERS = {"axial": "N_max", "shear": "V_max", "bending": "M_max"}


@dataclass(frozen=True)
class Span:
    """A part of a rod between two neighbouring places at which something acts. start: from the start of the rod; ends:
    the quantity at both ends; bernstein: what decides where it is extreme within, b_0 to b_2 of the shear force for a
    bending moment, of itself for another one."""

    start: Any
    length: Any
    ends: tuple[Any, Any]
    bernstein: tuple[Any, Any, Any]
    is_moment: bool

    @property
    def moments(self) -> tuple[Any, Any, Any]:
        """The bending moment by Bernstein's base, where the shear force is linear. Raises CannotAnswer elsewhere."""
        b_0, b_1, b_2 = self.bernstein
        if not is_nothing(b_0 + b_2 - 2 * b_1, b_0, b_2):
            raise CannotAnswer(Message("where the load changes along the rod the bending moment is zero is not told"))
        return self.ends[0], self.ends[0] + self.length * b_0 / 2, self.ends[1]

    @property
    def slopes(self) -> tuple[Any, ...]:
        """Of the quantity, by Bernstein's base, but for a positive factor: within the span it is extreme where these
        change sign."""
        b = self.bernstein
        return b if self.is_moment else (b[1] - b[0], b[2] - b[1])

    def extreme(self, root: Any) -> tuple[Any, Any]:
        """How much it is where its slope vanishes, and where that is. root: s there."""
        b_0, b_1, b_2 = self.bernstein
        at = self.start + self.length * root
        if not self.is_moment:
            return b_0 + (b_1 - b_0) * root, at  # b_0 + 2 d_0 s + (d_1 - d_0) s^2 with (d_1 - d_0) s = -d_0
        c = (b_0, 2 * (b_1 - b_0), b_0 - 2 * b_1 + b_2)
        area = root * (c[0] + root * (c[1] / 2 + root * c[2] / 3))
        return self.ends[0] + self.length * area, at


def is_nothing(x: Any, *beside: Any) -> bool:
    """Whether an element is zero, or a number beside others."""
    return x.is_zero() if hasattr(x, "is_zero") else abs(x) <= ROUNDED * max(map(abs, beside))


def root_of(slopes: Sequence[Any], side: int, sqrt_of: Callable[[Any], Any]) -> Any:
    """The one s at which a slope changes its sign, two or three coefficients of which are given. side: its sign before
    it."""
    d = slopes
    if len(d) == 2:
        return d[0] / (d[0] - d[1])
    c = (d[0], 2 * (d[1] - d[0]), d[0] - 2 * d[1] + d[2])
    return 2 * c[0] / (-c[1] + side * sqrt_of(c[1] * c[1] - 4 * c[0] * c[2]))


@dataclass(frozen=True)
class GreatestInRod(Quantity, kind="greatest section force"):
    """The greatest size of a section force along a rod, or the place of it, measured from the start of the rod; or the
    one place at which the shear force, as the slope of the bending moment, or the bending moment goes through zero."""

    body: str
    part: Part
    fields: tuple[Field, ...]
    asks: Literal["size", "place", "zero"] = "size"

    is_reaction = True
    derived_by = "greatest_section"
    example = """
bodies: {beam: {rod: {mass: 3 kg, length: 2 m}, angle: 0, at: {start: [0, 0]}}}
connections: {clamp: {weld: [ground.A, beam.start]}}
loads: {weight: {gravity: 9.81 m/s^2}}
questions: {it: greatest bending moment of beam}
"""

    @property
    def dimension(self) -> Dimension:
        if self.asks != "size":
            return LENGTH
        return TORQUE if self.part == "bending" else FORCE

    @property
    def letter(self) -> str:
        return _LETTERS[self.part] if self.asks == "size" else "x"

    @property
    def may_jump(self) -> bool:
        return True

    @property
    def has_finder(self) -> bool:
        return True

    def places(self, system: Described, state: State[Any]) -> Order:
        """The places along the rod at which something acts, in turn, with both ends; the state tells their order."""
        rod = system.bodies[self.body]
        return in_order(rod, state, places_on(system, state, rod, self._looked_at))

    @property
    def _looked_at(self) -> Part:
        """What spans are made for: the moment, with its slope, where a zero is asked for."""
        return "bending" if self.asks == "zero" else self.part

    def spans(self, system: Described, state: State[Any], order: Order) -> Iterator[Span]:
        """Those of the rod between places that follow one another."""
        rod = system.bodies[self.body]

        def at(place: Expr, part: Part, side: Side, order: Order = order) -> Any:
            cut = SectionForce(rod.name, part, place, str(place), self.fields, side=side, order=order)
            return cut.value(system, state)

        for k in range(len(order) - 1):
            begin, end = order[k][0], order[k + 1][0]
            length = state.scalar(add(end, negate(begin)))
            part: Part = "axial" if self.part == "axial" else "shear"
            first, last = at(begin, part, "behind"), at(end, part, "before")
            if self.part == "axial":
                middle = divide(add(begin, end), number(2))
                within = at(middle, part, "", (*order[: k + 1], (middle,), *order[k + 1 :]))
                ends, between = (first, last), 2 * within - (first + last) / 2
            else:
                moments = at(begin, "bending", "behind"), at(end, "bending", "before")
                between = 3 * (moments[1] - moments[0]) / length - first - last
                ends = moments if self._looked_at == "bending" else (first, last)
            start = state.scalar(add(begin, negate(rod.points["start"][0])))
            yield Span(start, length, ends, (first, between, last), self._looked_at == "bending")

    def value(self, system: Described, state: State[Any]) -> float:
        """In numbers; where the sizes in two places are the same the first one is told."""
        found: list[tuple[float, float]] = []
        spans = [*self.spans(system, state, self.places(system, state))]
        if self.asks == "zero":
            return only_zero(self, [*self._zeros(spans)])
        for span in spans:
            found.append((span.ends[0], span.start))
            found += [span.extreme(root) for root in _roots(span.slopes)]
            found.append((span.ends[1], span.start + span.length))
        size = max(abs(value) for value, _at in found)
        if self.asks == "size":
            return size
        return next(at for value, at in found if abs(value) >= size * (1.0 - ROUNDED))

    def _zeros(self, spans: Sequence[Span]) -> Iterator[float]:
        """Where it goes through zero, within spans and between them."""
        for k, span in enumerate(spans):
            before, behind = self.at_border(spans[k - 1], span) if k else (0.0, 0.0)
            if before * behind < 0.0:
                yield span.start
            yield from (span.start + span.length * root for root in _roots(self.along(span)))

    def along(self, span: Span) -> tuple[Any, ...]:
        """What goes through zero, by Bernstein's base."""
        return span.bernstein if self.part == "shear" else span.moments

    def at_border(self, before: Span, behind: Span) -> tuple[Any, Any]:
        """What goes through zero, on both sides of the place between two spans."""
        return self.along(before)[-1], self.along(behind)[0]

    def sentence(self, system: Described) -> Sentence:
        return Sentence(f"what.greatest_section.{self.asks}.{self.part}", {"body": self.body})


def only_zero(q: GreatestInRod, places: Sequence[Any]) -> Any:
    """The place where that is one. Raises CannotAnswer where there is none, or are several."""
    is_shear = q.part == "shear"
    if not places and is_shear:
        raise CannotAnswer(Message("the shear force goes through zero nowhere along the rod"))
    if not places:
        raise CannotAnswer(Message("the bending moment goes through zero nowhere between the ends of the rod"))
    if len(places) > 1 and is_shear:
        raise CannotAnswer(Message("the shear force goes through zero at {n} places", n=len(places)))
    if len(places) > 1:
        raise CannotAnswer(Message("the bending moment goes through zero at {n} places", n=len(places)))
    return places[0]


def _roots(d: Sequence[float]) -> list[float]:
    """Where between 0 and 1 a polynomial by Bernstein's base is zero; at an end round-off hides that it is."""
    most = max(map(abs, d))
    d = [0.0 if abs(x) <= ROUNDED * most else x for x in d]
    if len(d) == 3 and 0.0 in (d[0], d[2]):
        d = [d[0], 2.0 * d[1]] if d[2] == 0.0 else [2.0 * d[1], d[2]]
    if len(d) == 2:
        return [d[0] / (d[0] - d[1])] if d[0] * d[1] < 0.0 else []
    c = (d[0], 2.0 * (d[1] - d[0]), d[0] - 2.0 * d[1] + d[2])
    square = c[1] * c[1] - 4.0 * c[0] * c[2]
    if square < 0.0:
        return []
    half = -(c[1] + copysign(sqrt(square), c[1])) / 2.0  # Numerical Recipes, sec. 5.6: no difference of near numbers
    found = [top / bottom for top, bottom in ((half, c[2]), (c[0], half)) if abs(bottom) > LEAST]
    return sorted(s for s in found if 0.0 < s < 1.0)


# -- how it is asked ------------------------------------------------------------------------------
_WHAT = r"(?P<part>(?:axial|shear|shearing) force|bending moment)"
_ALONE = """
bodies: {beam: {rod: {mass: 3 kg, length: 2 m}, angle: 0, at: {start: [0, 0]}}}
connections: {clamp: {weld: [ground.A, beam.start]}}
loads: {weight: {gravity: 9.81 m/s^2}}
"""


def _is_of_one_rod(names: Names, found: Found) -> bool:
    return found["of"] is not None or len(rods_of(names)) == 1


@asked(
    "greatest axial force | shear force | bending moment [of ROD]",
    rf"(?:greatest|largest|maximum) {_WHAT}(?: (?:of|in) (?:the )?(?P<of>{NAME}))?",
    rank=62,
    fits=_is_of_one_rod,
)
def _greatest(names: Names, found: Found, path: Path) -> Quantity | None:
    return _read(names, found, path, "size")


@asked(
    "place of the greatest axial force | shear force | bending moment [of ROD]",
    rf"(?:place|position|location) of (?:the )?(?:greatest|largest|maximum) {_WHAT}"
    rf"(?: (?:of|in) (?:the )?(?P<of>{NAME}))?",
    rank=62,
    example=f"{_ALONE}questions: {{it: place of the greatest bending moment of beam}}\n",
    fits=_is_of_one_rod,
)
def _place(names: Names, found: Found, path: Path) -> Quantity | None:
    return _read(names, found, path, "place")


@asked(
    "place of zero shear force | bending moment [of ROD]",
    r"(?:place|position|location) of (?:the )?(?:zero|vanishing) (?P<part>(?:shear|shearing) force|bending moment)"
    rf"(?: (?:of|in) (?:the )?(?P<of>{NAME}))?",
    rank=62,
    example=f"{_ALONE}questions: {{it: place of zero shear force of beam}}\n",
    fits=_is_of_one_rod,
)
def _zero(names: Names, found: Found, path: Path) -> Quantity | None:
    return _read(names, found, path, "zero")


def _read(names: Names, found: Found, path: Path, asks: Literal["size", "place", "zero"]) -> Quantity | None:
    rod: RigidBody | None = rod_named(names, str(found["of"] or rods_of(names)[0]), path)
    part = PARTS.get(re.split(" ", str(found["part"]))[0], "axial")
    if rod is None or rod.is_placeholder:
        return None if rod is None else GreatestInRod(rod.name, part, (), asks)
    if names.space:
        names.problem(Message("shear forces and bending moments are told in models of the plane"), *path)
        return None
    return GreatestInRod(rod.name, part, fields_of(names), asks)
