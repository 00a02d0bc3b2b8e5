"""How a string lies in space, over wheels whose axes keep their directions.

With n_i the axis of wheel i, s_i = +1 where the string runs round it right-handed about n_i (-1: left-handed) and e the
direction of a lead, the string leaves a wheel or comes to it at C_i + s_i R_i e x n_i, so that with l the length of the
lead

    C_2 - C_1 = l e + s_1 R_1 e x n_1 - s_2 R_2 e x n_2.

Between wheels with parallel axes, or a wheel and a point, that is the plane's common tangent (see `measures.lead`) in
the plane across n. Between axes that are not parallel the lead is perpendicular to both,
e = +- n_1 x n_2 / |n_1 x n_2|: it keeps its direction, and the wheels have to stand so that it is in the plane of each,

    n_1 . (C_2 - C_1) = s_2 R_2 e . (n_1 x n_2),      n_2 . (C_2 - C_1) = s_1 R_1 e . (n_1 x n_2).

Wheels on what turns, as on the jib of a crane, have their planes there, and all of this holds as the jib sees it; from
the ground to the jib see `swivel`.

What is at an end has to be kept in the plane of the wheel to which its lead runs: otherwise it would draw the string
off the wheel. A body that nothing else holds hangs straight down from it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

from freebody.connections.standing import is_zero, number_of, vanishes
from freebody.connections.standing_in_space import StandingInSpace, opposite
from freebody.connections.string.laying import StringRun
from freebody.connections.string.node import StringNode, WheelPlane
from freebody.connections.string.swivel import SwivelLeads
from freebody.connections.string.way_in_space import dot_product
from freebody.language.expression import Call, Expr, add, multiply, negate, number
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, ONE, ZERO, Direction, Point
from freebody.measures.turn import Alignment
from freebody.model.elements import ConstraintRow
from freebody.model.rotations import UNIT, dot, perpendiculars, vector_product
from freebody.tolerances import ROUND_OFF

if TYPE_CHECKING:
    from freebody.model.names import Names


@dataclass(frozen=True)
class SpatialRun(StringRun):
    """A string on its way in space. hung: of what hangs on it, its number on the way, and the directions across the
    lead with the point from which it is held along each, and how far. swivels: see `SwivelLeads`."""

    hung: tuple[tuple[int, tuple[tuple[Direction, Point, Expr], ...]], ...] = ()
    swivels: Mapping[int, Direction] = field(default_factory=dict)

    def held_turn(self, k: int) -> tuple[tuple[Expr, Measure], ...]:
        lead, beyond, plane = self.leads[k], self.swivels.get(k), self.way[k + 1].plane
        if lead is None or beyond is None or plane is None:
            return ()
        aside = Direction(beyond.body, vector_product(plane.normal.components, beyond.components))
        return ((negate(self.arms[k + 1]), Alignment(aside, lead)),)

    @property
    def hooks(self) -> dict[str, Any]:
        """Nothing else asks in space where strings place what hangs on them."""
        return {}

    def carried(self) -> Iterator[tuple[str, str]]:
        """What hangs straight below a wheel that may move aside, and that wheel."""
        for k, sides in self.hung:
            others = [origin.body for _normal, origin, _far in sides if origin.body != GROUND]
            yield from ((self.way[k].body, other) for other in others[:1])

    def hanging(self) -> Iterator[ConstraintRow]:
        """Rows that keep what hangs straight below."""
        for k, sides in self.hung:
            point = self.way[k].point
            for (normal, origin, far), name in zip(sides, ("hangs", "hangs across"), strict=True):
                across, target = Displacement(point, origin, normal), None if far == ZERO else far
                yield ConstraintRow(
                    f"{point.body} {name}", "sideways force", across, target, ends=(point.body,), if_needed=True
                )


def _in_planes(space: StandingInSpace, way: Sequence[StringNode]) -> list[StringNode] | None:
    """The places on a way with the planes of their wheels; None with a problem noted."""
    found: list[StringNode] = []
    for node in way:
        plane = None if node.radius == ZERO else wheel_plane(space, node.body)
        if node.radius != ZERO and plane is None:
            return None
        found.append(replace(node, plane=plane))
    return found


def wheel_plane(space: StandingInSpace, wheel: str) -> WheelPlane | None:
    """The plane across the axis of a wheel: that of its bearing, or its own; None with a problem noted."""
    names = space.names
    body = names.known(wheel)
    axles: list[Direction] = []
    carrier = names.ground_origin
    for connection in names.connections.values():
        bearing = connection.bearing(names) if body.name in connection.mentions(names) else None
        if bearing is not None:
            first, second, axis, other = bearing
            axles.append(axis if axis.body == body.name else other)
            carrier = second if first.body == body.name else first
    flat = {b for c in names.connections.values() if c.keeps_flat(names) for b in c.mentions(names)}
    if body.name in flat:
        axles.append(Direction(body.name, UNIT[2]))
    if body.axis:
        axles.append(Direction(body.name, body.axis))
    frames = {axle: space.lowest(axle) for axle in axles}
    for axle, frame in sorted(frames.items(), key=lambda found: found[1] != GROUND):
        still = None if frame is None else space.on(frame, axle)
        if frame is not None and still is not None and frame != body.name:
            normal, turned = still
            along, side = (Direction(frame, v) for v in perpendiculars(normal.components))
            return WheelPlane(normal, along, side, turned, carrier)
    names.problem(_not_carried(wheel) if axles else _without_axle(wheel))
    return None


def _without_axle(wheel: str) -> Message:
    return Message("nothing says about which axis {wheel} turns: hold it by a revolute joint", wheel=wheel)


def _not_carried(wheel: str) -> Message:
    """What is told of a wheel whose axis tilts."""
    return Message(
        "the axis of {wheel} does not keep its direction: a string in space runs over wheels that turn about axes "
        "fixed on the ground, or on bodies that do not tilt them (revolute, prismatic)",
        wheel=wheel,
    )


def lie_in_space(
    names: Names, way: Sequence[StringNode], still: StandingInSpace | None = None, *, may_hang: bool = True
) -> SpatialRun | None:
    """How a string runs over the wheels of its way; None with a problem noted. still: as it has been read; may_hang:
    whether it can keep what hangs on it below a wheel."""
    still = still or StandingInSpace(names)
    placed = _in_planes(still, way)
    if placed is None:
        return None
    laying = _Laying(still, placed, may_hang=may_hang)
    for k in range(len(way) - 1):
        if not laying.lead(k):
            return None
    for k in range(len(way)):
        if not laying.sense(k):
            return None
    return laying.run()


class _Laying(SwivelLeads):
    """A string in the making: its leads, and in which sense it runs round each wheel."""

    def __init__(self, still: StandingInSpace, way: list[StringNode], *, may_hang: bool) -> None:
        super().__init__(still, way)
        self.may_hang = may_hang
        self.fits: dict[int, list[tuple[int, int]]] = {}  # senses with which leads keep their directions

    def run(self) -> SpatialRun:
        turns = [0 if n.plane is None else s or 1 for n, s in zip(self.way, self.senses, strict=True)]
        arms = [multiply(number(s), n.radius) if s else ZERO for s, n in zip(turns, self.way, strict=True)]
        for k, fits in self.fits.items():
            if (turns[k], turns[k + 1]) not in fits:
                self.leads[k] = None
        hung = tuple((k, self._sides(k, j, arms)) for k, j in self.hanging.items())
        return SpatialRun(self.way, self.leads, turns, arms, hung, self.swivels)

    def _sides(self, k: int, j: int, arms: list[Expr]) -> tuple[tuple[Direction, Point, Expr], ...]:
        """Of what hangs at one place P from a wheel at C: by n . (C_2 - C_1) = s_2 R_2 - s_1 R_1 across the lead in the
        plane, n . (P - C) = -s R with the wheel at either end of it, and nothing across the plane; counted from the
        ground where the wheel has its place there."""
        plane, lead, other = self.way[j].plane, self.leads[min(j, k)], self.way[j].point
        assert plane is not None
        assert lead is not None
        frame = plane.normal.body
        normal = Direction(frame, vector_product(plane.normal.components, lead.components))
        found: list[tuple[Direction, Point, Expr]] = []
        aside = negate(arms[j]) if self.way[max(j, k)].falls == ONE else ZERO
        for along, offset in ((normal, aside), (plane.normal, ZERO)):
            place = self.still.standing(other, along)
            if place.body == frame == GROUND:
                found.append((along, self.names.ground_origin, add(place.far, offset)))
            else:
                found.append((along, other, offset))
        return tuple(found)

    # -- leads ------------------------------------------------------------------------------------
    def lead(self, k: int) -> bool:
        """Finds how a lead runs; False with a problem noted."""
        a, b = self.way[k], self.way[k + 1]
        if a.plane is None and b.plane is None:
            if not (a.hangs or b.hangs):
                return True
            told = Message(
                "{body} would hang on {other}, which is no wheel: in space put it somewhere (at)",
                body=a.body if a.hangs else b.body,
                other=b.point if a.hangs else a.point,
            )
            self.names.problem(told)
            return False
        if a.plane is not None and b.plane is not None and a.plane.normal.body != b.plane.normal.body:
            return self.along_swivel(k, a.plane, b.plane)
        if a.plane is not None and b.plane is not None and not self._are_parallel(a.plane, b.plane):
            return self._crossing(k, a.plane, b.plane)
        plane = a.plane or b.plane
        assert plane is not None
        if a.plane is not None and b.plane is not None and dot_of(self.names, a.plane.normal, b.plane.normal) < 0.0:
            self.way[k + 1] = replace(b, plane=b.plane.reversed())
            if self.senses[k + 1] is not None:
                told = Message(
                    "the axes of {first} and {second} point against each other: name both the same way",
                    first=a.body,
                    second=b.body,
                )
                self.names.problem(told)
                return False
        if a.hangs or b.hangs or self._is_put_below(k, plane):
            return self._hung(k, plane)
        aside = self.still.distance_along(a.point, b.point, plane.normal)
        if aside is None or not is_zero(self.names, aside):
            self._note_off_plane(k, None if aside is None else number_of(self.names, aside))
            return False
        return self._guided(k, plane)

    def _are_parallel(self, a: WheelPlane, b: WheelPlane) -> bool:
        return all(is_zero(self.names, c) for c in vector_product(a.normal.components, b.normal.components))

    def _note_off_plane(self, k: int, aside: float | None) -> None:
        a, b = self.way[k], self.way[k + 1]
        wheel, other = (a, b) if a.plane is not None else (b, a)
        if aside is None and self.may_hang:
            told = Message(
                "nothing keeps {other} in the plane of {wheel}, across its axis, where the string runs onto it: guide "
                "it there (prismatic, revolute, planar), or let it hang on the string alone",
                other=other.point,
                wheel=wheel.body,
            )
        elif aside is None:
            told = Message(
                "nothing keeps {other} in the plane of {wheel}, across its axis, where the string runs onto it: guide "
                "it there (prismatic, revolute, planar)",
                other=other.point,
                wheel=wheel.body,
            )
        else:
            told = Message(
                "{other} is {aside:.6g} m beside the plane of {wheel}, across its axis, and would draw the string off "
                "it: put it into that plane",
                other=other.point,
                wheel=wheel.body,
                aside=abs(aside),
            )
        self.names.problem(told)

    def _hung(self, k: int, plane: WheelPlane) -> bool:
        """A lead straight down to what hangs."""
        names, up = self.names, self.up_on(plane.normal.body)
        first_hangs = self.way[k].hangs or (self.way[k].is_put and not self.way[k + 1].hangs)
        hung, wheel = (k, k + 1) if first_hangs else (k + 1, k)
        is_level = up is not None and is_zero(names, dot(up.components, plane.normal.components))
        if self.way[hung].plane is not None or up is None or not is_level:
            told = Message(
                "{body} cannot hang on {wheel}, whose axis is not level: guide it by a joint",
                body=self.way[hung].body,
                wheel=self.way[wheel].body,
            )
            if self.way[hung].plane is not None:
                told = Message(
                    "in space a wheel that hangs on a string is held by a joint: {body}", body=self.way[hung].body
                )
            names.problem(told if up is not None else _not_carried(self.way[wheel].body))
            return False
        self.leads[k] = up if first_hangs else opposite(up)
        self.hanging.setdefault(hung, wheel)
        return True

    def _is_put_below(self, k: int, plane: WheelPlane) -> bool:
        """Whether an end that nothing else holds is put where it would hang, and says so in which sense the string goes
        round the wheel."""
        hung, wheel = (k, k + 1) if self.way[k].is_put else (k + 1, k)
        frame = plane.normal.body
        level, here, center = self.level(plane), self.where(hung, frame), self.where(wheel, frame)
        if not self.way[hung].is_put or level is None or here is None or center is None:
            return False
        away = [p - q for p, q in zip(here, center, strict=True)]
        n = [number_of(self.names, c) for c in plane.normal.components]
        aside, above, beside = (dot_product(away, e) for e in (*level, n))
        radius = number_of(self.names, self.way[wheel].radius)
        if abs(abs(aside) - radius) > ROUND_OFF or abs(beside) > ROUND_OFF or above >= 0.0:
            return False
        # it runs down on the right of the wheel, or comes up on the left
        is_clockwise = (aside > 0.0) == (hung > wheel)
        return self._turns(wheel, -1 if is_clockwise else 1)

    def _turns(self, k: int, sense: int) -> bool:
        """Takes a sense for a wheel, unless it has another one."""
        if self.senses[k] is None:
            self.senses[k] = sense
        return self.senses[k] == sense

    def _guided(self, k: int, plane: WheelPlane) -> bool:
        """A lead along the line on which one of its ends is guided, if it runs along that whatever the parameters are;
        else the common tangent."""
        a, b = self.way[k], self.way[k + 1]
        for end in (b, a):
            line = self.still.line_of(end.point, plane.normal)
            if line is None:
                continue
            normal = Direction(line.body, vector_product(plane.normal.components, line.components))
            across = self.still.distance_along(a.point, b.point, normal)
            if across is None:
                continue
            forward = self._is_ahead(k, line, end is b)
            if forward is None:
                return False
            along, sign = (line, 1) if forward else (opposite(line), -1)
            fits = [s for s in self._senses_of(k) if vanishes(self.names, _gap(across, sign, s, (a.radius, b.radius)))]
            if fits:
                self.leads[k], self.fits[k] = along, fits
                return len(fits) > 1 or self.agree(k, fits[0])
        return True

    def _senses_of(self, k: int) -> list[tuple[int, int]]:
        """The senses in which the string may run round both ends of a lead."""
        options = [
            (0,) if n.plane is None else (s,) if s else (1, -1)
            for n, s in zip(self.way[k : k + 2], self.senses[k : k + 2], strict=True)
        ]
        return [(s, t) for s in options[0] for t in options[1]]

    def _is_ahead(self, k: int, line: Direction, is_last: bool) -> bool | None:
        """Whether a lead runs along the line of an end, seen from its start; None with a problem noted where nothing
        tells on which side of the wheel the end is."""
        names = self.names
        first, last = (self.where(j, line.body) for j in (k, k + 1))
        if first is not None and last is not None:
            ahead = sum((q - p) * number_of(names, e) for p, q, e in zip(first, last, line.components, strict=True))
            if abs(ahead) > ROUND_OFF:
                return ahead > 0.0
        up = self.up_on(line.body)
        rise = 0.0 if up is None else number_of(names, dot(line.components, up.components))
        if abs(rise) > ROUND_OFF:  # what is guided up and down is below
            return (rise < 0.0) == is_last
        end, wheel = (k + 1, k) if is_last else (k, k + 1)
        told = Message(
            "on which side of {wheel} is {body}? Say where it is at the start (at, near, or start)",
            body=self.way[end].body,
            wheel=self.way[wheel].body,
        )
        names.problem(told)
        return None

    def _crossing(self, k: int, first: WheelPlane, second: WheelPlane) -> bool:
        """A lead between wheels whose axes are not parallel."""
        names, (a, b) = self.names, self.way[k : k + 2]
        n1, n2 = first.normal.components, second.normal.components
        cross = vector_product(n1, n2)
        size = Call("sqrt", dot(cross, cross)) if not is_zero(names, dot(cross, cross) - number(1)) else number(1)
        e = Direction(first.normal.body, tuple(c / size for c in cross))
        asides = [self.still.distance_along(a.point, b.point, p.normal) for p in (first, second)]
        places = self.where(k, e.body), self.where(k + 1, e.body)
        if asides[0] is None or asides[1] is None or places[0] is None or places[1] is None:
            told = Message(
                "the common tangent of {first} and {second}, whose axes are not parallel, would not stay one: hold "
                "both wheels so that neither moves along the axis of the other",
                first=a.body,
                second=b.body,
            )
            names.problem(told)
            return False
        ahead = sum((q - p) * number_of(names, c) for p, q, c in zip(places[0], places[1], e.components, strict=True))
        sign = 1 if ahead > 0.0 else -1
        offsets = [number_of(names, x) for x in asides if x is not None]
        senses = tuple(sign if x > 0.0 else -sign for x in reversed(offsets))
        wanted = [multiply(number(sign * s), size, r) for s, r in zip(senses, (a.radius, b.radius), strict=True)]
        misses = [number_of(names, x - w) for x, w in zip(asides, reversed(wanted), strict=True) if x is not None]
        if abs(ahead) <= ROUND_OFF or any(abs(m) > ROUND_OFF for m in misses):
            told = Message(
                "the string from {first} to {second} runs along the line in which their planes meet: put {second} "
                "{own:.6g} m from {first} along the axis of {first} (now {own_now:.6g} m), and {other:.6g} m along the "
                "axis of {second} (now {other_now:.6g} m)",
                first=a.body,
                second=b.body,
                own=number_of(names, wanted[1]),
                own_now=offsets[0],
                other=number_of(names, wanted[0]),
                other_now=offsets[1],
            )
            names.problem(told)
            return False
        self.leads[k] = e if sign > 0 else opposite(e)
        return self.agree(k, (senses[0], senses[1]))

    # -- senses -----------------------------------------------------------------------------------
    def sense(self, k: int) -> bool:
        """Finds in which sense the string runs round a wheel; False with a problem noted."""
        node = self.way[k]
        if node.plane is None or self.senses[k] is not None:
            return True
        self.senses[k] = self.of_drum(k) if node.way == "drum" else self.of_wheel(k)
        if self.senses[k] is None:
            told = Message(
                "in which sense does the string go round {wheel}? Write '{way} clockwise' or '{way} counterclockwise', "
                "as seen against its axis",
                wheel=node.body,
                way=f"wound on {node.body}" if node.way == "drum" else f"{node.way} {node.body}",
            )
            self.names.problem(told)
        return self.senses[k] is not None


def _gap(across: Expr, sign: int, senses: tuple[int, int], radii: tuple[Expr, Expr]) -> Expr:
    """sign n . (C_2 - C_1) - (s_2 R_2 - s_1 R_1), n the line turned by a quarter turn."""
    (s, t), (r1, r2) = senses, radii
    return multiply(number(sign), across) - multiply(number(t), r2) + multiply(number(s), r1)


def dot_of(names: Names, a: Direction, b: Direction) -> float:
    """The cosine between two directions of the ground in numbers."""
    return number_of(names, dot(a.components, b.components))
