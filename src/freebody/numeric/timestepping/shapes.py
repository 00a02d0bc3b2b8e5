"""Outlines by class: those of one class differ in numbers only.

Of every class a stand-in is made whose numbers are symbols (`f.round0.x`). What the model says of two stand-ins, with
numbers put in, it says of every two outlines of their classes, so near pairs can be filled into arrays all at once.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from freebody.connections.outlines import Hollow, Outline, RoundPart, Straight
from freebody.connections.pairs import OutlinePair
from freebody.language.expression import ZERO, Expr, Symbol
from freebody.measures.geometry import GROUND, Components, Direction, Point
from freebody.model.elements import Line
from freebody.numeric.kernels.arrays import Floats
from freebody.numeric.numbers import Numbers

FIRST, SECOND = "first", "second"


@dataclass(frozen=True)
class OutlineShape:
    """What outlines of one class have in common: round parts with the edges of which they are corners, straight parts
    that end or do not, hollow ones; and whether their body is fixed."""

    is_fixed: bool
    rounds: tuple[tuple[int, ...], ...]
    straights: tuple[bool, ...]
    n_hollows: int

    @classmethod
    def of(cls, outline: Outline, *, is_fixed: bool) -> OutlineShape:
        places = {id(edge): k for k, edge in enumerate(outline.straights)}
        corners = tuple(tuple(places[id(edge)] for edge in r.edges) for r in outline.rounds)
        return cls(is_fixed, corners, tuple(s.length is not None for s in outline.straights), len(outline.hollows))

    def stand_in(self, role: str) -> Outline:
        """An outline of this class whose numbers are symbols; `role` is its body."""
        body = GROUND if self.is_fixed else role

        def point(part: str) -> Point:
            return Point(body, (Symbol(f"{role}.{part}.x"), Symbol(f"{role}.{part}.y")))

        straights: list[Straight] = []
        for k, ends in enumerate(self.straights):
            part = f"straight{k}"
            along = Direction(body, (Symbol(f"{role}.{part}.ex"), Symbol(f"{role}.{part}.ey")))
            length: Expr | None = Symbol(f"{role}.{part}.length") if ends else None
            straights.append(Straight(Line(point(part), along), length, f"{role}.{part}"))
        rounds = [
            RoundPart(
                point(f"round{k}"), Symbol(f"{role}.round{k}.r"), f"{role}.round{k}", tuple(straights[e] for e in edges)
            )
            for k, edges in enumerate(self.rounds)
        ]
        hollows = [
            Hollow(point(f"hollow{k}"), Symbol(f"{role}.hollow{k}.r"), f"{role}.hollow{k}")
            for k in range(self.n_hollows)
        ]
        return Outline(body, role, tuple(rounds), tuple(straights), tuple(hollows))

    def columns(self, role: str) -> list[str]:
        """The symbols of a stand-in."""
        found: list[str] = []
        for k in range(len(self.rounds)):
            found += [f"{role}.round{k}.{x}" for x in ("x", "y", "r")]
        for k in range(len(self.straights)):
            found += [f"{role}.straight{k}.{x}" for x in ("x", "y", "ex", "ey", "length")]
        for k in range(self.n_hollows):
            found += [f"{role}.hollow{k}.{x}" for x in ("x", "y", "r")]
        return found


@dataclass
class Outlines:
    """All outlines of a system in numbers. What is fixed is given in the ground."""

    shapes: list[OutlineShape] = field(default_factory=list[OutlineShape])
    outlines: list[Outline] = field(default_factory=list[Outline])
    shape: NDArray[np.intp] = field(default_factory=lambda: np.zeros(0, np.intp))  # of every outline
    place: NDArray[np.intp] = field(default_factory=lambda: np.zeros(0, np.intp))  # among those of its shape
    body: NDArray[np.intp] = field(default_factory=lambda: np.zeros(0, np.intp))
    values: list[Floats] = field(default_factory=list[Floats])  # per shape: (n_outlines, n_columns)
    center: Floats = field(default_factory=lambda: np.zeros((0, 2)))  # of a circle about each, on its body [m]
    radius: Floats = field(default_factory=lambda: np.zeros(0))  # of that circle; infinite for lines

    @classmethod
    def of(cls, pairs: Iterable[OutlinePair], numbers: Numbers, bodies: dict[str, int], n_bodies: int) -> Outlines:
        """bodies: places of those that move; all others are fixed, as body n_bodies."""
        known: dict[int, Outline] = {}
        for pair in pairs:
            known.setdefault(id(pair.first), pair.first)
            known.setdefault(id(pair.second), pair.second)
        shapes: dict[OutlineShape, int] = {}
        rows: list[list[list[float]]] = []
        found = cls(outlines=list(known.values()))
        shape: list[int] = []
        place: list[int] = []
        circles: list[tuple[float, float, float]] = []
        for outline in found.outlines:
            own = OutlineShape.of(outline, is_fixed=outline.body not in bodies)
            k = shapes.setdefault(own, len(shapes))
            if k == len(rows):
                rows.append([])
            row = list(_numbers(outline, numbers, is_fixed=own.is_fixed))
            shape.append(k)
            place.append(len(rows[k]))
            rows[k].append(row)
            circles.append(_circle(own, row))
        found.shapes = list(shapes)
        found.shape, found.place = np.array(shape, np.intp), np.array(place, np.intp)
        found.body = np.array([bodies.get(o.body, n_bodies) for o in found.outlines], np.intp)
        found.values = [np.array(r, dtype=np.float64) for r in rows]
        found.center = np.array([c[:2] for c in circles], dtype=np.float64).reshape(-1, 2)
        found.radius = np.array([c[2] for c in circles], dtype=np.float64)
        return found

    def number_of(self, outline: Outline) -> int:
        return self._numbers[id(outline)]

    def __post_init__(self) -> None:
        self._numbers = {id(outline): k for k, outline in enumerate(self.outlines)}


def _numbers(outline: Outline, numbers: Numbers, *, is_fixed: bool) -> Iterator[float]:
    """The numbers of an outline in the order of `Shape.columns`."""
    gx, gy, c, s = numbers.fixed_pose(outline.body) if is_fixed else (0.0, 0.0, 1.0, 0.0)

    def turned(components: Components) -> tuple[float, float]:
        x, y = (numbers.number(e) for e in components)
        return c * x - s * y, s * x + c * y

    def placed(point: Point) -> tuple[float, float]:
        x, y = turned(point.offset)
        return gx + x, gy + y

    for r in outline.rounds:
        yield from (*placed(r.center), 0.0 if r.radius == ZERO else numbers.number(r.radius))
    for line in outline.straights:
        yield from placed(line.line.through)
        yield from turned(line.line.direction.components)
        yield math.inf if line.length is None else numbers.number(line.length)
    for h in outline.hollows:
        yield from (*placed(h.center), numbers.number(h.radius))


def _circle(shape: OutlineShape, row: list[float]) -> tuple[float, float, float]:
    """Centre and radius of a circle about an outline; of a ring, the ring itself."""
    circles = np.array(row[: 3 * len(shape.rounds)]).reshape(-1, 3)
    if shape.n_hollows:
        x, y, r = row[-3:]
        return x, y, r
    if not len(circles):
        return 0.0, 0.0, math.inf
    x, y = circles[:, :2].mean(axis=0)
    reach = np.hypot(circles[:, 0] - x, circles[:, 1] - y) + circles[:, 2]
    return float(x), float(y), float(reach.max())
