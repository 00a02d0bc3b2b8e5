"""Forces and couples at bodies as arrows with their symbols, none on top of another.

An arrow begins at its point of action; one that would run into the body ends there instead, coming from outside.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from freebody.language.notation.parts import with_sign
from freebody.present.figures import Array
from freebody.present.picture.forces import ShownForce
from freebody.present.picture.label import Label, Run, beside
from freebody.present.picture.placer import Wish, around
from freebody.present.picture.shapes import Ink, Shape
from freebody.present.picture.signs import HEAD, across, arc, arrow, cross, curved_arrow, head
from freebody.present.picture.sketch import Sketch

LENGTH = 40.0  # [points]
_LONGER = 1.5  # an arrow whose place is taken
_INTO = 0.3  # cosine from which on a force points into its body
_RADIUS, _WIDER = 14.0, 6.5  # [points] of the arc of a couple, of another one there
_TURN = 1.25 * math.pi
_HEAD_ON, _SHORTEST = 0.2, 0.45  # shares of its length that an arrow of space is seen with
INKS = {"weight": Ink("force"), "load": Ink("force"), "reaction": Ink("reaction")}

Where = Callable[[ShownForce], tuple[Array, Array]]  # the point of action and the middle of the body, in points


@dataclass(frozen=True)
class Drawn:
    """An arrow as it is drawn. start, end: (2,) [points]."""

    force: ShownForce
    start: Array
    end: Array


class Arrows:
    """Draws forces into a sketch. where: on paper; lengths: [points] by the force, else all alike."""

    def __init__(self, sketch: Sketch, where: Where, lengths: Callable[[ShownForce], float] | None = None) -> None:
        self.sketch, self.where = sketch, where
        self.lengths = lengths or _usual_length
        self.taken: list[tuple[Array, Array]] = []  # points and ways of arrows
        self.wanted: list[tuple[Array, Array]] = []  # the same of those that are still to be drawn
        self.couples: list[Array] = []
        self.drawn: list[Drawn] = []

    def draw(self, forces: Sequence[ShownForce]) -> None:
        ordered = sorted(forces, key=lambda force: force.kind != "weight")
        ways = [self._seen(force) for force in ordered]
        self.wanted = [
            (self.where(force)[0], -way[:2] if self._is_into(force, way[:2]) else way[:2])
            for force, way in zip(ordered, ways, strict=True)
        ]
        for force, seen in zip(ordered, ways, strict=True):
            self.wanted.pop(0)
            with self.sketch.about(f"force {force.name}"):
                if float(np.hypot(*seen[:2])) > _HEAD_ON:
                    self._arrow(force, seen[:2])
                elif force.is_couple:
                    self._couple(force, float(seen[2]))
                else:
                    self._head_on(force, float(seen[2]))

    def _seen(self, force: ShownForce) -> Array:
        """(3,) of a unit vector on paper, and towards the reader."""
        vector = np.array(force.moment if force.is_couple else force.force)
        return self.sketch.vector(vector / float(np.linalg.norm(vector)))

    def _is_into(self, force: ShownForce, way: Array) -> bool:
        """Whether a force points into its body from where it acts. way: (2,) on paper, of any length."""
        at, middle = self.where(force)
        inwards, size = middle - at, float(np.hypot(*way))
        depth = float(np.hypot(*inwards))
        return depth > 1.0 and float(way @ inwards) > _INTO * depth * size and not force.is_couple

    # -- forces -------------------------------------------------------------------------------
    def _arrow(self, force: ShownForce, seen: Array) -> None:
        """seen: (2,) of a unit vector."""
        at, _middle = self.where(force)
        share = float(np.hypot(*seen))
        way = seen / share
        is_into = self._is_into(force, way)
        length = self.lengths(force) * max(share, _SHORTEST)
        from_outside, is_free = self._side(at, way, is_into)
        length *= 1.0 if is_free else _LONGER
        self.taken.append((at, -way if from_outside else way))
        start, end = (at - length * way, at) if from_outside else (at, at + length * way)
        ink = INKS[force.kind]
        self.sketch.add(arrow(start, end, ink))
        if force.is_couple:  # two heads: about that axis, right-handed
            self.sketch.add(head(end - 0.85 * HEAD * way, way, ink))
        self.drawn.append(Drawn(force, start, end))
        far, out = (start, -way) if from_outside else (end, way)
        half = np.array((8.0, 0.0))
        self.sketch.reserved.append(Shape(far + 8.0 * out + np.array((-half, half))))
        aside = across(way)
        middle_of = 0.5 * (start + end)
        places = (
            *((far, turn) for turn in (out, out + aside, out - aside, aside, -aside)),
            *((far - 0.35 * length * out, turn) for turn in (aside, -aside)),
            *((middle_of, turn) for turn in (aside, -aside)),
        )
        unit = tuple((a, w / float(np.hypot(*w))) for a, w in places)
        self.sketch.wish(Wish(labelled(force), unit, 11.0, ink, weight=5.0))

    def _head_on(self, force: ShownForce, towards: float) -> None:
        """An arrow along the view: a circle with a dot where it comes, with a cross where it goes."""
        at, _middle = self.where(force)
        at = at + 6.0 * sum(float(np.hypot(*(at - other))) < 3.0 for other in self.couples) * np.array((1.0, 1.0))
        self.couples.append(at)
        ink = INKS[force.kind]
        self.sketch.add(Shape(arc(at, 5.0, 0.0, math.tau), ink, 1.3, Ink("paper"), is_closed=True))
        inner = Shape(arc(at, 1.3, 0.0, math.tau), None, 0.0, ink, is_closed=True)
        self.sketch.add(inner) if towards > 0 else self.sketch.add(cross(at, ink))
        self.sketch.wish(Wish(labelled(force), tuple((at + 5.0 * w, w) for _a, w in around(at)), 11.0, ink, weight=5.0))

    def _side(self, at: Array, way: Array, is_into: bool) -> tuple[bool, bool]:
        """Whether an arrow comes from outside, and whether that side is free. The other side than its own is left to
        those that are drawn later and whose own it is."""
        for from_outside in (is_into, not is_into):
            own = -way if from_outside else way
            others = self.taken if from_outside is is_into else [*self.taken, *self.wanted]
            if not any(np.hypot(*(at - o)) < 3.0 and own @ w > 0.96 * np.hypot(*w) > 0 for o, w in others):
                return from_outside, True
        return is_into, False

    # -- couples ------------------------------------------------------------------------------
    def _couple(self, force: ShownForce, towards: float) -> None:
        """An arc about an axis along the view, counter-clockwise where it comes."""
        at, _middle = self.where(force)
        others = sum(float(np.hypot(*(at - other))) < 3.0 for other in self.couples)
        self.couples.append(at)
        radius = _RADIUS + _WIDER * others
        sense = math.copysign(1.0, towards)
        begin = math.pi / 2 - sense * (0.62 * _TURN + 0.5 * others)
        ink = INKS[force.kind]
        self.sketch.add(curved_arrow(at, radius, begin, sense * _TURN, ink))
        spots = arc(at, radius, begin + sense * 0.5 * _TURN, sense * 0.5 * _TURN)[::3]
        spots = np.concatenate((spots, arc(at, radius, begin, sense * 0.5 * _TURN)[::3]))
        places = tuple((spot, (spot - at) / radius) for spot in spots)
        self.sketch.wish(Wish(labelled(force), places, 11.0, ink, weight=5.0))


def acting_at(sketch: Sketch, centers: Mapping[str, Array]) -> Where:
    """Forces at their points. centers: (2 or 3,) [m] of the bodies as they are drawn."""

    def where(force: ShownForce) -> tuple[Array, Array]:
        center = centers[force.body]
        return sketch.seen(center + np.array(force.at)), sketch.seen(center)

    return where


def _usual_length(_force: ShownForce) -> float:
    return LENGTH


def labelled(force: ShownForce) -> Label:
    """Its symbol, and its value where that is known."""
    if force.value is None:
        return force.label
    unit = "N m" if force.is_couple else "N"
    size = math.copysign(force.size, force.value)
    return beside(
        force.label,
        Label(
            (Run(f"{shown(size)} {unit}"),),
            rf"{shown(size, comma='{,}')}\,\mathrm{{{unit.replace(' ', chr(92) + ',')}}}",
        ),
        " = ",
    )


def shown(value: float, comma: str = ",") -> str:
    """In the decimals of the picture. comma: how a format writes one."""
    return with_sign(f"{value:.3g}", comma=comma).replace("-", "\u2212")


def axes_cross(at: Array, size: float = 20.0) -> Iterator[Shape | Wish]:
    """x to the right, y up, and the sense in which angles are positive."""
    from freebody.present.picture.label import name

    ink = Ink("muted")
    yield from arrow(at, at + np.array((size, 0.0)), ink, 1.0, 5.0)
    yield from arrow(at, at + np.array((0.0, size)), ink, 1.0, 5.0)
    yield from curved_arrow(at, 0.62 * size, 0.3, 1.1, ink, 0.9, 4.5)
    yield Wish(name("x"), ((at + np.array((size, 0.0)), np.array((1.0, 0.0))),), 9.0, ink, weight=9.0)
    yield Wish(name("y"), ((at + np.array((0.0, size)), np.array((0.0, 1.0))),), 9.0, ink, weight=9.0)
