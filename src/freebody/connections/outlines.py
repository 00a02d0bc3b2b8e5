"""Outlines: the parts of bodies that can touch others.

Every outline is made of round parts (a circle, or a point as a circle of radius 0), straight parts (a line, or an edge
of a polygon) and hollow ones (the inside of a ring). Straight parts are solid on the right of their direction.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from freebody.language.expression import ZERO, Call, Expr, negate
from freebody.language.sentences import Message
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, Direction, Point
from freebody.model.elements import Line, RigidBody, Span
from freebody.model.noting import did_you_mean
from freebody.tolerances import ROUNDED

if TYPE_CHECKING:
    from freebody.model.names import Names


@dataclass(frozen=True)
class RoundPart:
    """A circle about a point of a body; radius 0 for a point. `where` limits the directions from which a corner can be
    touched to those between its edges."""

    center: Point
    radius: Expr
    label: str
    edges: tuple[Straight, ...] = ()  # of which it is a corner: the one before and the one after
    neighbours: tuple[Point, ...] = ()  # the corners before and after

    @property
    def body(self) -> str:
        return self.center.body

    def beside(self, point: Point) -> tuple[Span, ...]:
        """Where a point must be to be nearest to this corner: beyond the ends of both its edges."""
        if not self.edges:
            return ()
        before, after = self.edges
        return Span(before.travel(point), high=ZERO), Span(after.travel(point), low=after.length)


@dataclass(frozen=True)
class Straight:
    """A line, or an edge of a given length that begins at the line's point."""

    line: Line
    length: Expr | None
    label: str

    @property
    def body(self) -> str:
        return self.line.direction.body

    def travel(self, point: Point) -> Displacement:
        """How far along the line a point is."""
        return Displacement(point, self.line.through, self.line.direction)

    def height(self, point: Point) -> Displacement:
        """How far on the free side of the line a point is."""
        return Displacement(point, self.line.through, self.line.direction.normal())

    def beside(self, point: Point) -> tuple[Span, ...]:
        """Where a point must be to be nearest to the edge and not to its ends."""
        return () if self.length is None else (Span(self.travel(point), ZERO, self.length),)


@dataclass(frozen=True)
class Hollow:
    """The inside of a ring."""

    center: Point
    radius: Expr
    label: str

    @property
    def body(self) -> str:
        return self.center.body


@dataclass(frozen=True)
class Outline:
    """What of a body, or of the ground, can touch."""

    body: str
    label: str
    rounds: tuple[RoundPart, ...] = ()
    straights: tuple[Straight, ...] = ()
    hollows: tuple[Hollow, ...] = ()

    @property
    def is_line(self) -> bool:
        """Whether it is a line that has no ends."""
        return bool(self.straights) and not (self.rounds or self.hollows)

    @property
    def is_polygon(self) -> bool:
        return bool(self.rounds and self.straights)


KINDS = Message(
    "a circle, a point (a particle, a corner), a line, a polygon (rectangle, polygon, rod), the inside of a ring"
)


def read_outline(names: Names, text: str, *path: str | int, below: bool = False) -> Outline | None:
    """`ball`, `rod.end`, `ground.floor`, `inside bowl`; None with a problem noted if it cannot touch anything."""
    words = " ".join(str(text).split())
    for prefix in ("inside of ", "inside "):
        if words.startswith(prefix):
            body = names.body(words.removeprefix(prefix), *path)
            radius = names.radius(body.name, *path, inside=True)
            return Outline(body.name, words, hollows=(Hollow(body.center, radius, words),))
    line = names.line(words)
    if line is not None:
        if below:
            line = Line(line.through, line.direction.reversed(), line.name)
        label = line.name or words
        return Outline(line.direction.body, label, straights=(Straight(line, None, label),))
    body_name, _, point_name = words.partition(".")
    side = names.edge(words)
    if side is not None:
        return _of_side(names, side, point_name, *path)
    if not point_name and words not in names.bodies and words in names.bodies[GROUND].points:
        body_name, point_name = GROUND, words
    if point_name:
        point = names.point(f"{body_name}.{point_name}", *path)
        radius = names.known(point.body).circles.get(point_name, ZERO)
        return Outline(point.body, words, (RoundPart(point, radius, words),))
    if body_name not in names.bodies and body_name not in names.broken:
        told = Message(
            "there is no body or line {name}.{hint} What does not move is a line of the ground, e.g. "
            "ground: {{lines: {{{name}: {{along: right}}}}}}",
            name=body_name,
            hint=did_you_mean(body_name, [*names.bodies, *names.bodies[GROUND].lines]),
        )
        if "wall" in body_name.lower() or "wand" in body_name.lower():
            told = Message(
                "there is no body or line {name}: a wall on the right is {right}, one on the left {left}, as a line is "
                "solid on its right",
                name=body_name,
                right=f"ground: {{lines: {{{body_name}: {{along: up}}}}}}",
                left="{along: down}",
            )
        names.unknown(body_name, told, *path)
        return None
    body = names.body(body_name, *path)
    if body.is_placeholder or body_name not in names.bodies:
        return None
    return _of_body(names, body, *path)


def _of_body(names: Names, body: RigidBody, *path: str | int) -> Outline | None:
    if body.radius is not None:
        return Outline(body.name, body.name, (RoundPart(body.center, body.radius, body.name),))
    if body.corners:
        return _polygon(names, body, *path)
    if not body.turns:
        return Outline(body.name, body.name, (RoundPart(body.center, ZERO, body.name),))
    if body.circles:
        circles = " or ".join(f"{body.name}.{part}" for part in body.circles)
        names.problem(
            Message(
                "{body} has no outline as a whole: write the circle that touches, {circles}",
                body=body.name,
                circles=circles,
            ),
            *path,
        )
        return None
    lines = [f"{b.name}.{name}" for b in names.bodies.values() for name in b.lines]
    is_lined = body.name == GROUND and lines
    what = Message("; name one of its lines: {names}", names=", ".join(lines)) if is_lined else ""
    if body.name == GROUND and not lines:
        names.problem(
            Message(
                "the ground has no outline: give it a line, ground: {{lines: {{floor: {{along: right}}}}}}, and write "
                "floor here"
            ),
            *path,
        )
        return None
    names.problem(
        Message(
            "{body} has no outline that could touch{what}. What can: {kinds}. Give {body} a radius, or "
            "outline: [P, Q, R] with points of its own, or name one of its points",
            body=body.name,
            what=what,
            kinds=KINDS,
        ),
        *path,
    )
    return None


def _of_side(names: Names, side: Line, name: str, *path: str | int) -> Outline | None:
    """One edge of a polygon, with the corners at its ends; a line where nobody says how long it is."""
    body = names.body(side.direction.body, *path)
    whole, k = _polygon(names, body, *path), list(body.sides).index(name)
    if whole is None:
        return None
    first, last, edge = whole.rounds[k], whole.rounds[(k + 1) % len(whole.rounds)], whole.straights[k]
    if first.center.offset == last.center.offset:
        return Outline(body.name, side.name, straights=(Straight(side, None, side.name),))
    return Outline(body.name, side.name, (first, last), (edge,))


def _polygon(names: Names, body: RigidBody, *path: str | int) -> Outline | None:
    """Edges and corners of a convex polygon, counter-clockwise; a rod has two corners, and an edge either way."""
    corners = list(body.corners)
    turning = _turns(names, body, corners)
    if turning and len({turn > 0 for turn in turning}) > 1:
        names.problem(
            Message("the outline of {body} is not convex; weld convex bodies together instead", body=body.name),
            *path,
        )
        return None
    if turning and turning[0] < 0:
        corners.reverse()
    edges: list[Straight] = []
    for start, end in zip(corners, corners[1:] + corners[:1], strict=True):
        (px, py, *_), (qx, qy, *_) = body.points[start], body.points[end]
        dx, dy = px + negate(qx), py + negate(qy)
        length = Call("sqrt", dx * dx + dy * dy)
        label = f"{body.name} {start}-{end}"
        along = Direction(body.name, (dx / length, dy / length), label)
        edges.append(Straight(Line(body.point(end), along, label), length, label))
    rounds = [
        RoundPart(
            body.point(corner),
            ZERO,
            f"{body.name}.{corner}",
            (edges[k - 1], edges[k]),
            tuple(body.point(c) for c in (corners[k - 1], corners[(k + 1) % len(corners)])),
        )
        for k, corner in enumerate(corners)
    ]
    return Outline(body.name, body.name, tuple(rounds), tuple(edges))


def _turns(names: Names, body: RigidBody, corners: list[str]) -> list[float]:
    """Twice the area of the triangle at every corner, positive where the outline turns counter-clockwise; empty where
    numbers are missing, and for a rod."""
    if len(corners) < 3:
        return []
    numbers = [(names.numeric(x), names.numeric(y)) for x, y, *_ in (body.points[c] for c in corners)]
    points = [(x, y) for x, y in numbers if x is not None and y is not None]
    if len(points) < len(corners):
        return []
    found: list[float] = []
    for k, (bx, by) in enumerate(points):
        (ax, ay), (cx, cy) = points[k - 1], points[(k + 1) % len(points)]
        found.append((bx - ax) * (cy - by) - (by - ay) * (cx - bx))
    return [turn for turn in found if abs(turn) > ROUNDED * max(map(abs, found))]


__all__ = ["KINDS", "Hollow", "Outline", "RoundPart", "Straight", "read_outline"]
