"""A loop of four links in formulas: lengths, what turns fully, dead points, transmission angle.

The four vectors of a loop with pins add up to zero in whatever order they are taken. Of two links x and y, of which the
directions are told, the sum is between |x - y| and x + y long, and that of the other two, z and w, between |z - w| and
z + w; so

    x turns fully against y      x + y <= z + w  and  |x - y| >= |z - w|

which is Grashof's rule link by link. With a guide, crank r, rod l and the offset e of the pivot from the guide's line,

    crank against guide      r + |e| <= l            (the end of the rod must reach the line in every pose)
    rod against guide        l + |e| <= r
    crank against rod        |r - l| >= |e|          (the line must pass the pivot at the distance e)

Dead points: the output reverses where crank and coupler are in line, rho = a + b or a - b, so with the frame d and the
output c        cos beta = (rho^2 + d^2 - c^2)/(2 rho d)        at the crank, from the frame,
                cos gamma = (rho^2 - c^2 - d^2)/(2 c d)         at the output, from the frame;
on a guide      sin beta = e/rho,  x = rho cos beta.
A lever with a slot reverses where the crank (a) stands across the slot: with the pivots d apart and the offset e of the
slot from the pivot      sin gamma = (+-a - e)/d.
Transmission angle: cos mu = (b^2 + c^2 - D^2)/(2 b c) with the diagonal D^2 = a^2 + d^2 - 2 a d cos beta; on a guide
cos mu = y/l with y = e - r sin beta, by which the crankpin is off the line.
Sources: Grashof, Theoretische Maschinenlehre II, 1883; Norton, Design of Machinery, 5th ed. 2012, sec. 2.13 to 2.15,
3.2 and 4.10; Uicker, Pennock, Shigley, Theory of Machines and Mechanisms, 4th ed. 2011, sec. 1.9 and 1.10.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

from freebody.errors import CannotAnswer
from freebody.language.expression import Call, Expr, add
from freebody.language.notation import compared, joined
from freebody.language.sentences import Message
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Distance
from freebody.measures.geometry import GROUND
from freebody.model.elements import NonholonomicForm
from freebody.study.answering.crosscheck import element_at
from freebody.study.answering.draws import Draw
from freebody.study.mobility.grashof import FourBarNumbers, dimensions
from freebody.study.mobility.linkages import FourBar, Linkage, LoopJoint, SliderCrank, inner_measure
from freebody.study.setup import Setup
from freebody.symbolic.conditions import Condition
from freebody.symbolic.functions import atan2, functions
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign, sign_of
from freebody.symbolic.state import SymbolicState
from freebody.symbolic.tidy import tidy
from freebody.tolerances import ROUND_OFF

_SAME = 1e-8  # of the size: a length by formula and by number


@dataclass(frozen=True)
class Rotatable:
    """That a link turns fully. needs: what must not be negative; says: the same in words."""

    link: str
    needs: tuple[Ratio, ...]
    says: str

    @property
    def conditions(self) -> tuple[Condition, ...]:
        return tuple(Condition(x, ">=", Message("{link} turns fully", link=self.link)) for x in self.needs)


def rotatable(f: Linkage, lengths: dict[str, Ratio], link: str, frame: str = GROUND) -> Rotatable:
    """When a link turns fully against another one of its loop."""
    if isinstance(f, FourBar):
        z, w = (lengths[name] for name in f.links if name not in (link, frame))
        return _of_bars(link, lengths[link], lengths[frame], z, w)
    r, rod, e = lengths[f.crank], lengths[f.rod], lengths[f.guide]
    pair = {link, frame}
    if pair == {f.crank, f.rod}:
        size = _size(e)
        needs = () if e.is_zero() else ((r - rod) ** 2 - e * e,)
        told = Message("for every length") if e.is_zero() else compared(Call("abs", tidy(r - rod)), ">=", size)
        return Rotatable(link, tuple(x.field.lowest_terms(x) for x in needs), told)
    short, long = (r, rod) if f.crank in pair else (rod, r)
    needs = tuple(e.field.lowest_terms(long - short - side) for side in sides_of(e))
    return Rotatable(link, needs, compared(tidy(long), ">=", add(tidy(short), _size(e))))


def _of_bars(link: str, x: Ratio, y: Ratio, z: Ratio, w: Ratio) -> Rotatable:
    f = x.field
    together, apart = f.lowest_terms(z + w - x - y), f.lowest_terms((x - y) ** 2 - (z - w) ** 2)
    told: list[str] = []
    if not together.is_zero():
        told.append(compared(add(tidy(x), tidy(y)), "<=", add(tidy(z), tidy(w))))
    if not apart.is_zero():
        told.append(compared(Call("abs", tidy(x - y)), ">=", Call("abs", tidy(z - w))))
    return Rotatable(link, (together, apart), joined(told) if told else Message("for every length"))


def sides_of(e: Ratio) -> list[Ratio]:
    """The values of which |e| is the greatest: e and -e, or the one that is known to be."""
    sign = sign_of(e)
    if e.is_zero() or sign in (Sign.POSITIVE, Sign.NONNEGATIVE):
        return [e]
    return [-e] if sign in (Sign.NEGATIVE, Sign.NONPOSITIVE) else [e, -e]


def _size(e: Ratio) -> Expr:
    """|e|"""
    sign = sign_of(e)
    if e.is_zero() or sign in (Sign.POSITIVE, Sign.NONNEGATIVE):
        return tidy(e)
    return tidy(-e) if sign in (Sign.NEGATIVE, Sign.NONPOSITIVE) else Call("abs", tidy(e))


class FourLinks:
    """A four-link loop on the ground, in formulas. Raises CannotAnswer where its dimensions have none."""

    def __init__(self, setup: Setup, loop: Linkage) -> None:
        self.setup, self.loop = setup, loop
        self.model, self.field = setup.model, setup.model.field
        self.fn = functions(self.field, self.model.samples.is_negative)
        if GROUND not in loop.links:
            raise CannotAnswer(Message("none of the links of the loop is fixed"))

    # -- dimensions ---------------------------------------------------------------------------
    @cached_property
    def lengths(self) -> dict[str, Ratio]:
        """Of the links by their names; of a guide the offset of its line from the pivot."""
        loop = self.loop
        if isinstance(loop, FourBar):
            A, B, C, D = loop.joints
            ends = ((D, A), (A, B), (B, C), (C, D))
            return self._checked({link: self._length(link, *pair) for link, pair in zip(loop.links, ends, strict=True)})
        pivot, pin, end = loop.joints
        bars = {loop.crank: self._length(loop.crank, pivot, pin), loop.rod: self._length(loop.rod, pin, end)}
        for offset in self._offsets(loop):
            try:
                return self._checked({**bars, loop.guide: offset})
            except CannotAnswer:
                continue
        raise CannotAnswer(Message("the offset of the guide {guide} has no formula here", guide=loop.sliding))

    def between(self, link: str, a: LoopJoint, b: LoopJoint) -> tuple[Ratio, Ratio]:
        """The vector from one joint to another one in axes of a link."""
        start, end = a.on(link), b.on(link)
        if start is None or end is None:
            raise CannotAnswer(Message("the length of {link} has no formula here", link=link))
        scalar = self.model.geometry.scalar
        x, y = (scalar(p) - scalar(q) for p, q in zip(end.offset, start.offset, strict=True))
        return self.field.lowest_terms(x), self.field.lowest_terms(y)

    def _length(self, link: str, a: LoopJoint, b: LoopJoint) -> Ratio:
        for row in self.setup.system.constraint_rows:
            if row.connection != link or isinstance(row.measure, NonholonomicForm):
                continue
            if isinstance(own := inner_measure(row.measure), Distance):
                if row.target is not None:
                    return self.model.geometry.scalar(row.target)
                return self.setup.start_instant.value(own)  # as long as it is drawn
        x, y = self.between(link, a, b)
        return self.root(x * x + y * y)

    def root(self, x: Ratio) -> Ratio:
        return self.field.sqrt(self.field.lowest_terms(x), self.model.samples.is_negative)

    def angle_in(self, link: str, a: LoopJoint, b: LoopJoint) -> Ratio:
        """The angle of the vector between two joints in axes of a link."""
        x, y = self.between(link, a, b)
        return atan2(self.field, y, x, self.root(x * x + y * y))

    def along(self) -> tuple[Ratio, Ratio]:
        """The direction of the guide in its own axes."""
        assert isinstance(self.loop, SliderCrank)
        x, y = (self.model.geometry.scalar(c) for c in self.loop.along.components)
        return x, y

    def _offsets(self, loop: SliderCrank) -> Iterator[Ratio]:
        """What the offset may be: of the guide's own line, or of a line through where something is put."""
        pivot = loop.joints[0].on(loop.guide)
        if pivot is None:
            raise CannotAnswer(Message("the length of {link} has no formula here", link=loop.guide))
        gx, gy = self.along()
        if loop.through.body == loop.guide:
            x, y = self.between(loop.guide, loop.joints[0], LoopJoint("", loop.through, (loop.through,)))
            yield self.field.lowest_terms(gx * y - gy * x)
        across = Displacement(loop.joints[2].point, pivot, loop.along.normal())
        yield SymbolicState(self.model).value(across)

    def _checked(self, found: dict[str, Ratio]) -> dict[str, Ratio]:
        """Raises CannotAnswer where a length is none of parameters alone, or is not as the numeric route has it."""
        for link, x in found.items():
            if not all(map(self.field.is_constant_generator, self.field.ingredients(x))):
                raise CannotAnswer(Message("the length of {link} has no formula here", link=link))
        for draw in self.setup.draws:
            wanted = self._in_numbers(draw)
            for link, x in found.items():
                (value,) = element_at(self.setup, x, draw, draw.start())
                if abs(value - wanted[link]) > _SAME * max(map(abs, wanted.values())):
                    raise CannotAnswer(Message("the length of {link} has no formula here", link=link))
        return found

    def _in_numbers(self, draw: Draw) -> dict[str, float]:
        numbers = dimensions(self.loop, draw.reference, draw.q)
        if isinstance(numbers, FourBarNumbers):
            return dict(
                zip(self.loop.links, (numbers.frame, numbers.input, numbers.coupler, numbers.output), strict=True)
            )
        assert isinstance(self.loop, SliderCrank)
        return {self.loop.crank: numbers.crank, self.loop.rod: numbers.rod, self.loop.guide: numbers.offset}

    def number(self, x: Ratio) -> float:
        """At the first of the draws, the model's own numbers where it has them."""
        draw = self.setup.draws[0]
        return element_at(self.setup, x, draw, draw.start())[0]

    # -- what turns ---------------------------------------------------------------------------
    def turning(self, link: str) -> Rotatable:
        """When a link turns fully against the ground."""
        if link not in self.loop.links or link == GROUND:
            raise CannotAnswer(Message("{link} is no moving link of the loop", link=link))
        return rotatable(self.loop, self.lengths, link)

    def does_turn(self, link: str) -> bool:
        """At the model's own numbers, on the border too, whatever round-off makes of it."""
        size = max(abs(self.number(x)) for x in self.lengths.values())
        return all(self.number(x) >= -ROUND_OFF * size * min(size, 1.0) for x in self.turning(link).needs)

    @cached_property
    def crank(self) -> str:
        """The link at the ground that turns fully, else the one that is driven."""
        loop = self.loop
        if isinstance(loop, FourBar):
            turning = [link for link in (loop.input, loop.output) if self.does_turn(link)]
            return turning[0] if turning else loop.input
        return {loop.guide: loop.crank, loop.crank: loop.rod, loop.rod: loop.crank}[GROUND]

    def assembles(self) -> tuple[tuple[Ratio, ...], str]:
        """When the loop closes at all: what must not be negative, and the same in words."""
        loop, f = self.loop, self.field
        if isinstance(loop, FourBar):
            total = sum((self.lengths[link] for link in loop.links), f.zero)
            needs = tuple(f.lowest_terms(total - 2 * self.lengths[link]) for link in loop.links)
            told = [compared(tidy(self.lengths[link]), "<=", tidy(total - self.lengths[link])) for link in loop.links]
            return needs, joined(told)
        r, rod, e = (self.lengths[link] for link in (loop.crank, loop.rod, loop.guide))
        needs = tuple(f.lowest_terms(r + rod - side) for side in sides_of(e))
        return needs, compared(tidy(f.lowest_terms(r + rod)), ">=", _size(e))
