"""Loops that no pose can close: one side of a closed chain is longer than all others together.

Points that joints keep in one place are one corner. Two corners of one body, or of a link, are at a known distance d;
two corners that are known to be on two lines of the ground, or on a line and in a place, at least at the distance of
these. However the bodies are turned, a chain of sides from one corner to the other reaches no farther than their sum
(the triangle inequality), so that d > sum of a chain proves that there is no pose. The shortest chain is found by
Dijkstra's algorithm. It is looked for first by the connections alone, then with what the start gives.
"""

from __future__ import annotations

import heapq
import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field

from freebody.language.expression import Expr, evaluate, free_symbols
from freebody.language.sentences import Message, listed
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Distance
from freebody.measures.geometry import GROUND, Direction, Point
from freebody.model.elements import ConstraintRow, NonholonomicForm
from freebody.numeric.system import NumericSystem

MOST_CORNERS = 60  # of a system in which sides are looked at: their number grows with the square
_CLEARLY = 1e-7  # of a length: what is less is round-off
_STRETCH = 0.037  # by which parameters are changed to see whether a length is one of them

Corner = int
Place = tuple[float, ...]


@dataclass(frozen=True)
class _Side:
    """Two corners at a distance [m]: of a body, or that of a line from a place (`is_least`)."""

    first: Corner
    second: Corner
    length: float
    told: str  # what it is called
    formula: str = ""  # the parameter that it is
    is_least: bool = False


@dataclass
class _Corners:
    """Points by the corner in which they are kept together."""

    number: dict[tuple[str, tuple[Expr, ...]], Corner] = field(default_factory=dict)
    points: list[list[Point]] = field(default_factory=list)

    def of(self, point: Point) -> Corner:
        key = (point.body, point.offset)
        if key not in self.number:
            self.number[key] = len(self.points)
            self.points.append([point])
        return self.number[key]

    def named(self, corner: Corner) -> Point:
        """One of its points, of the ground if it can be."""
        return min(self.points[corner], key=lambda point: point.body != GROUND)

    def merge(self, first: Point, second: Point) -> None:
        a, b = self.of(first), self.of(second)
        if a == b:
            return
        self.points[a] += self.points[b]
        self.points[b] = []
        self.number = {key: a if corner == b else corner for key, corner in self.number.items()}


def cannot_close(reference: NumericSystem, wanted: Iterable[tuple[Measure | NonholonomicForm, float]]) -> str | None:
    """Which side of which loop is too long, with the inequality that does not hold; None where no loop tells it.
    wanted: values of measures at the start."""
    system = reference.system
    corners, lines = _kept_together(reference)
    if not 2 < len(corners.points) <= MOST_CORNERS:
        return None
    held = [(m, 0.0 if row.target is None else reference.number(row.target)) for row, m in _places(reference)]
    angles = [(m, x) for m, x in held if isinstance(m, Angle)]
    begun = [(m, x) for m, x in wanted if isinstance(m, Angle)]
    begun += [
        (Angle(body.name), reference.number(body.start.angle))
        for body in system.all_moving
        if body.start.angle is not None and body.turns
    ]
    driven = {m for row, m in _places(reference) if row.is_driven}
    alone = [(m, x) for m, x in angles if m not in driven]
    for known, with_start in ((alone, False), ([*angles, *begun], True)):
        places = {} if system.space else _placed(reference, corners, known)
        found = _too_long([*_sides(reference, corners, places), *_off_lines(reference, lines, places, corners)])
        if found is not None:
            return _told(corners, *found, with_start=with_start)
    return None


def _places(reference: NumericSystem) -> list[tuple[ConstraintRow, Measure]]:
    """The rows that hold a place, each with its measure."""
    rows = reference.system.constraint_rows
    return [(row, row.measure) for row in rows if not isinstance(row.measure, NonholonomicForm)]


def _kept_together(reference: NumericSystem) -> tuple[_Corners, list[tuple[Point, Displacement, float]]]:
    """The corners, and points that a row keeps on a line of the ground."""
    corners = _Corners()
    kept: dict[tuple[Point, Point], list[tuple[ConstraintRow, Displacement]]] = {}
    n_axes = 3 if reference.system.space else 2
    for row, m in _places(reference):
        if isinstance(m, Distance) and row.target is not None:
            corners.of(m.start), corners.of(m.end)
        if isinstance(m, Displacement) and m.along.body == GROUND:
            kept.setdefault((m.of, m.origin), []).append((row, m))
    lines: list[tuple[Point, Displacement, float]] = []
    for (of, origin), rows in kept.items():
        at = [0.0 if row.target is None else reference.number(row.target) for row, _m in rows]
        if len(rows) == n_axes and not any(at):
            corners.merge(of, origin)
        elif len(rows) == 1 and origin.body == GROUND and not rows[0][0].is_driven:
            corners.of(of)
            lines.append((of, rows[0][1], at[0]))
    return corners, lines


def _number(reference: NumericSystem, components: Sequence[Expr]) -> Place:
    return tuple(reference.number(c) for c in components)


def _placed(reference: NumericSystem, corners: _Corners, angles: Sequence[tuple[Angle, float]]) -> dict[Corner, Place]:
    """Where corners are on the ground by what is known of angles."""
    turned = dict(reference.frame.fixed) | {GROUND: (0.0, 0.0, 0.0)}
    theta: dict[str, float] = {body: float(pose[2]) for body, pose in turned.items()}
    for _ in angles:  # one may count from another
        for m, x in angles:
            if m.origin in theta and m.of not in theta:
                theta[m.of] = theta[m.origin] + reference.number(m.reference) + x
    places: dict[Corner, Place] = {}
    for body, pose in turned.items():
        for point, corner in _points_of(corners, body):
            x, y = _turned(_number(reference, point.offset), theta[body])
            places[corner] = (float(pose[0]) + x, float(pose[1]) + y)
    while True:
        n = len(places)
        for body in theta.keys() - turned.keys():
            own = list(_points_of(corners, body))
            known = next(((point, corner) for point, corner in own if corner in places), None)
            if known is None:
                continue
            base, at = _turned(_number(reference, known[0].offset), theta[body]), places[known[1]]
            for point, corner in own:
                x, y = _turned(_number(reference, point.offset), theta[body])
                places.setdefault(corner, (at[0] + x - base[0], at[1] + y - base[1]))
        if len(places) == n:
            return places


def _points_of(corners: _Corners, body: str) -> Iterator[tuple[Point, Corner]]:
    for corner, points in enumerate(corners.points):
        yield from ((point, corner) for point in points if point.body == body)


def _turned(at: Place, angle: float) -> Place:
    c, s = math.cos(angle), math.sin(angle)
    return c * at[0] - s * at[1], s * at[0] + c * at[1]


# -- sides ------------------------------------------------------------------------------------
def _sides(reference: NumericSystem, corners: _Corners, places: dict[Corner, Place]) -> Iterator[_Side]:
    """Of all bodies and links, and between places that are known."""
    bodies = dict.fromkeys(point.body for points in corners.points for point in points)
    for body in bodies:
        own = list(_points_of(corners, body))
        for k, (first, a) in enumerate(own):
            for second, b in own[:k]:
                length = _between(reference, first, second)
                told = _from_to(first, second) if body == GROUND or len(own) > 2 else body
                yield _Side(a, b, length(0.0), told, _as_parameter(reference, (first, second), length))
    for row, m in _places(reference):
        if isinstance(m, Distance) and row.target is not None and not row.is_driven:
            a, b = corners.of(m.start), corners.of(m.end)
            target = row.target
            length = lambda stretch, target=target: _stretched(reference, target, stretch)  # noqa: E731
            yield _Side(a, b, length(0.0), row.connection, _parameter(reference, free_symbols(target), length))
    known = list(places.items())
    for k, (a, at) in enumerate(known):
        for b, other in known[:k]:
            if not any(point.body == GROUND for point in corners.points[a]) or not any(
                point.body == GROUND for point in corners.points[b]
            ):
                yield _Side(a, b, math.dist(at, other), _from_to(corners.named(a), corners.named(b)))


def _from_to(first: Point, second: Point) -> str:
    return Message("the way from {first} to {second}", first=first, second=second)


def _off_lines(
    reference: NumericSystem,
    lines: Sequence[tuple[Point, Displacement, float]],
    places: dict[Corner, Place],
    corners: _Corners,
) -> Iterator[_Side]:
    """How far places that are known are from lines on which corners are kept."""
    for point, m, at in lines:
        along, origin = _unit(reference, m.along), _number(reference, m.origin.offset)
        here = corners.of(point)
        for corner, place in places.items():
            if corner != here:
                off = sum(e * (x - o) for e, x, o in zip(along, place, origin, strict=True)) - at
                told = Message(
                    "the way from {point} to the line of {follower}", point=corners.named(corner), follower=point
                )
                yield _Side(corner, here, abs(off), told, is_least=True)


def _unit(reference: NumericSystem, along: Direction) -> Place:
    components = _number(reference, along.components)
    size = math.hypot(*components)
    return tuple(c / size for c in components)


def _between(reference: NumericSystem, first: Point, second: Point) -> Callable[[float], float]:
    """The distance of two points of a body, at parameters that are stretched by different shares."""

    def length(stretch: float) -> float:
        pairs = zip(first.offset, second.offset, strict=True)
        return math.hypot(*(_stretched(reference, a, stretch) - _stretched(reference, b, stretch) for a, b in pairs))

    return length


def _stretched(reference: NumericSystem, x: Expr, stretch: float) -> float:
    if stretch == 0.0:
        return reference.number(x)
    values = {n: v * (1.0 + stretch * (k + 1)) for k, (n, v) in enumerate(sorted(reference.frame.values.items()))}
    return float(evaluate(x, {**values, "t": 0.0}))


def _as_parameter(reference: NumericSystem, points: Sequence[Point], length: Callable[[float], float]) -> str:
    return _parameter(reference, {n for point in points for c in point.offset for n in free_symbols(c)}, length)


def _parameter(reference: NumericSystem, names: Iterable[str], length: Callable[[float], float]) -> str:
    """The parameter that a length is, whatever its value; nothing where it is none."""
    for name in sorted(names):
        order = sorted(reference.frame.values)
        if name in order:
            value, k = reference.frame.values[name], order.index(name)
            is_it = all(
                math.isclose(length(s), abs(value) * (1.0 + s * (k + 1)), rel_tol=1e-9) for s in (0.0, _STRETCH)
            )
            if is_it:
                return name
    return ""


# -- the loop ---------------------------------------------------------------------------------
def _too_long(sides: Sequence[_Side]) -> tuple[_Side, list[_Side]] | None:
    """A side and the chain that is shorter than it; of several one with few sides, and that by the greatest part."""
    found: list[tuple[int, float, int, _Side, list[_Side]]] = []
    for k, side in enumerate(sides):
        chain = _shortest(sides, side)
        reach = None if chain is None else sum(other.length for other in chain)
        if chain is not None and reach is not None and side.length > reach * (1.0 + _CLEARLY) + 1e-12:
            found.append((len(chain), reach - side.length, k, side, chain))
    return min(found, key=lambda one: one[:3])[3:] if found else None


def _shortest(sides: Sequence[_Side], without: _Side) -> list[_Side] | None:
    """The shortest chain of other sides between the ends of one (Dijkstra)."""
    meeting: dict[Corner, list[_Side]] = {}
    for side in sides:
        if side is not without and not side.is_least:
            meeting.setdefault(side.first, []).append(side)
            meeting.setdefault(side.second, []).append(side)
    queue: list[tuple[float, int, Corner, tuple[_Side, ...]]] = [(0.0, 0, without.first, ())]
    done: set[Corner] = set()
    n = 0
    while queue:
        reach, _order, corner, chain = heapq.heappop(queue)
        if corner == without.second:
            return list(chain)
        if corner in done:
            continue
        done.add(corner)
        for side in meeting.get(corner, []):
            other = side.second if side.first == corner else side.first
            n += 1
            heapq.heappush(queue, (reach + side.length, n, other, (*chain, side)))
    return None


def _told(corners: _Corners, side: _Side, chain: Sequence[_Side], *, with_start: bool) -> str:
    """The side, the chain, and the inequality between them; of no chain, that both ends are one place."""
    begun = Message("with the start that is given ") if with_start else ""
    if not chain:
        return Message(
            "{begun}no pose closes the loop: {side} is {length:.4g} m long, and what joins its ends holds them in one "
            "place. The name of a body alone means one point of it, of a rod its middle: name the points that are "
            "joined, as in rod.start",
            begun=begun,
            side=side.told,
            length=side.length,
        )
    reach = sum(other.length for other in chain)
    written = [part.formula or f"{part.length:.4g} m" for part in (side, *chain)]
    return Message(
        "{begun}no pose closes the loop: {side} is {length:.4g} m long, and all that goes from one end of it to the "
        "other is {chain}, together {reach:.4g} m. It closes only where {inequality}"
        if len(chain) > 1
        else "{begun}no pose closes the loop: {side} is {length:.4g} m long, and all that goes from one end of it to "
        "the other is {chain}. It closes only where {inequality}",
        begun=begun,
        side=side.told,
        length=side.length,
        chain=listed([f"{part.told} ({part.length:.4g} m)" for part in chain]),
        reach=reach,
        inequality=f"{written[0]} <= {' + '.join(written[1:])}",
    )
