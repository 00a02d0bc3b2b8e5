"""Directions and points that are worth writing a principle for: what differs between the plane and space.

A reaction drops out of a principle along a direction to which it is perpendicular, and out of one about a point on its
line of action. So directions are those of named measures, of the axes, along and across reactions; points are mass
centres and where lines of action meet: pins, contact points, the point above a ladder.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import combinations
from operator import attrgetter
from typing import Protocol

from freebody.language.expression import ZERO, Symbol
from freebody.language.sentences import Sentence
from freebody.measures.angle import Angle
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, Pose, position
from freebody.model.elements import ConstraintRow
from freebody.narrative.principles.acting import Acting
from freebody.narrative.principles.reactions import place_of
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio

Vector = tuple[Ratio, ...]  # by ground components: two in the plane
MOST_TOGETHER = 7  # bodies that are put together in every possible way
MOST_AIMS = 6  # directions for several bodies
MOST_MEETINGS = 12  # of lines of action
_LETTERS = 3  # of the name of a point that figures show


@dataclass(frozen=True)
class Aim:
    """A direction, and what it is called."""

    vector: Vector
    words: Sentence


@dataclass(frozen=True)
class MomentCentre:
    """A point about which moments are taken, by its ground coordinates; `is_fixed` on the ground."""

    place: Vector
    words: Sentence
    is_fixed: bool
    mass_center_of: str = ""


@dataclass(frozen=True)
class MomentAxis:
    """An axis through a centre; aim: its direction, where there is more than one."""

    vector: Vector
    aim: Aim | None = None


class PrinciplePlaces(Protocol):
    """Where principles are worth writing."""

    def sizes(self, n: int) -> Iterable[int]:
        """How many of n bodies are taken together."""
        ...

    def aims(self, bodies: tuple[str, ...]) -> list[Aim]:
        """Directions of momentum for some bodies together."""
        ...

    def centres(self, bodies: tuple[str, ...]) -> list[MomentCentre]:
        """Points about which moments of some bodies are worth taking."""
        ...

    def axes(self, bodies: tuple[str, ...]) -> list[MomentAxis]:
        """Axes through these."""
        ...

    def position(self, body: str) -> Vector:
        """Where a mass centre is."""
        ...

    def across(self, axis: MomentAxis, arm: Vector) -> Vector:
        """axis x arm: what a force there weighs in the moment, since axis . (arm x F) = (axis x arm) . F."""
        ...

    def turning(self, axis: MomentAxis, body: str) -> Vector:
        """What a moment on a body weighs in that about an axis, by its slots."""
        ...


def contact_point(acting: Acting, connection: str) -> Sentence:
    """The contact point of a connection, which needs no name where it is the only one."""
    connections = acting.system.connections
    acting_there = {row.connection for row in acting.rows.values()}
    if not any(connections[other].has_contact_point for other in acting_there - {connection}):
        return Sentence("point.only_contact")
    return Sentence("point.contact", {"connection": connection})


class PlanarPlaces:
    """Directions and points of the plane; moments are about the one axis that points at the reader."""

    def __init__(self, acting: Acting) -> None:
        self.acting = acting
        self.model, self.system = acting.model, acting.system
        self.field = acting.model.field
        self._aims: dict[str, list[Aim]] = {}

    def sizes(self, n: int) -> Iterable[int]:
        if n <= MOST_TOGETHER:
            return range(2, n + 1)
        return (n,) if self.acting.stands_still else ()

    def position(self, body: str) -> Vector:
        x, y = place_in_plane(self.model, body)
        return self.acting.here(x), self.acting.here(y)

    def axes(self, bodies: tuple[str, ...]) -> list[MomentAxis]:
        is_part = len(bodies) > 1 and self.acting.stands_still  # of a truss
        turn = is_part or any(self.system.bodies[body].turns for body in bodies)
        return [MomentAxis((self.field.one,))] if turn else []

    def across(self, axis: MomentAxis, arm: Vector) -> Vector:
        return -self.field.lowest_terms(arm[1]), self.field.lowest_terms(arm[0])

    def turning(self, axis: MomentAxis, body: str) -> Vector:
        return axis.vector

    # -- directions ---------------------------------------------------------------------------
    def aims(self, bodies: tuple[str, ...]) -> list[Aim]:
        found = _distinct([aim for body in bodies for aim in self._of_body(body)])
        return found[: MOST_AIMS if len(bodies) > 1 else None]

    def _of_body(self, body: str) -> list[Aim]:
        """Directions of named measures, the axes, and those along and across what acts on a body."""
        if body not in self._aims:
            # along a force is said rather than across another one
            self._aims[body] = _distinct([*self._measured(body), *self._axes(), *self._along_forces(body)])
        return self._aims[body]

    def _axes(self) -> list[Aim]:
        zero, one = self.field.zero, self.field.one
        return [Aim((one, zero), Sentence("direction.right")), Aim((zero, one), Sentence("direction.up"))]

    def _measured(self, body: str) -> list[Aim]:
        found: list[Aim] = []
        for name, measure in self.system.measures.items():
            slopes = self.acting.gradient(measure)
            vector = slopes.get((body, "x"), self.field.zero), slopes.get((body, "y"), self.field.zero)
            others = [b for b, _slot in slopes if b not in (body, GROUND)]
            if not others and (body, "angle") not in slopes and _is_unit(vector):
                found.append(Aim(vector, Sentence("direction.measure", {"name": Symbol(name)})))
        return found

    def _along_forces(self, body: str) -> list[Aim]:
        along: list[Aim] = []
        across: list[Aim] = []
        for row in self.acting.acting_on(body):
            slopes = self.acting.directions[row]
            vector = slopes.get((body, "x"), self.field.zero), slopes.get((body, "y"), self.field.zero)
            if _is_unit(vector):
                args = {"force": self.acting.symbol(row)}
                along.append(Aim(vector, Sentence("direction.along_force", args)))
                across.append(Aim((vector[1], -vector[0]), Sentence("direction.across_force", args)))
        return [*along, *across]

    # -- points -------------------------------------------------------------------------------
    def centres(self, bodies: tuple[str, ...]) -> list[MomentCentre]:
        """Mass centres, and where the lines of action of two reactions from outside meet. Of a body without mass it is
        the fixed pin there, or the centre of a round one."""
        f = self.field
        found: list[MomentCentre] = []
        has_mass = True
        if len(bodies) == 1:
            body, place = self.system.material[bodies[0]], self.position(bodies[0])
            has_mass = body.mass != ZERO
            key = "point.mass_center" if has_mass or body.radius is None else "point.center"
            found.append(MomentCentre(place, Sentence(key, {"body": body.name}), self._is_still(place), body.name))
        rows = self.acting.rows
        for (row_a, a), (row_b, b) in sorted(
            combinations(self._lines_of_action(bodies), 2),
            key=lambda p: tuple(of(rows[p[0][0]]) != of(rows[p[1][0]]) for of in (attrgetter("connection"), place_of)),
        )[:MOST_MEETINGS]:
            determinant = a[0] * b[1] - a[1] * b[0]
            if self.model.samples.vanishes(determinant):
                continue
            # r x F = m for both lines, about the origin
            x = f.lowest_terms((a[0] * b[2] - b[0] * a[2]) / determinant)
            y = f.lowest_terms((a[1] * b[2] - b[1] * a[2]) / determinant)
            words, is_still = self._point_words(row_a, row_b), self._is_still((x, y))
            if words.key == "point.meeting" and self.acting.stands_still and (name := self._named_at((x, y))):
                words = Sentence("point.named", {"point": name})
            if not any(c.place == (x, y) for c in found):
                found.append(MomentCentre((x, y), words, is_still))
            elif not has_mass and is_still and found[0].place == (x, y) and words.key == "point.named":
                found[0] = replace(found[0], words=words)
        if not has_mass and len(found) > 1 and found[0].words.key == "point.mass_center":
            del found[0]  # what has no mass has no mass centre
        return found

    def _is_still(self, place: Vector) -> bool:
        return self.acting.is_at_rest or all(self.model.samples.vanishes(self.model.rate(x)) for x in place)

    def _point_words(self, row_a: str, row_b: str) -> Sentence:
        acting = self.acting
        connection, other = acting.rows[row_a].connection, acting.rows[row_b].connection
        if connection == other:
            place, places = place_of(acting.rows[row_a]), {place_of(r) for r in self._rows_of(connection)}
            if len(places) > 1:  # the corners of a contact
                same = place == place_of(acting.rows[row_b])
                return Sentence("point.named", {"point": place}) if same else self._meeting(row_a, row_b)
            point = self._named_point(connection)
            if point:
                return Sentence("point.named", {"point": point})
            if acting.system.connections[connection].has_contact_point:
                return contact_point(acting, connection)
        return self._meeting(row_a, row_b)

    def _meeting(self, row_a: str, row_b: str) -> Sentence:
        return Sentence("point.meeting", {"first": self.acting.symbol(row_a), "second": self.acting.symbol(row_b)})

    @cached_property
    def _named_places(self) -> dict[str, Vector]:
        """Nodes of trusses, and the points of the ground with a name."""
        ground = self.system.bodies[GROUND]
        found = {
            body.name: self.position(body.name)
            for body in self.system.moving
            if not body.turns and len(body.name) <= _LETTERS
        }
        for name in ground.points:
            if len(name) > _LETTERS:  # no figure names it
                continue
            at = position(self.model.geometry, ground.point(name))
            found.setdefault(name, (self.acting.here(at.x), self.acting.here(at.y)))
        return found

    def _named_at(self, place: Vector) -> str:
        """The name of what is at a place, or nothing."""
        same = (
            name
            for name, at in self._named_places.items()
            if all((a - b).is_zero() for a, b in zip(at, place, strict=True))
        )
        return next(same, "")

    def _rows_of(self, connection: str) -> list[ConstraintRow]:
        return [row for row in self.acting.rows.values() if row.connection == connection]

    def _named_point(self, connection: str) -> str:
        """The name of the point that a pin or a clamp holds; the origin of a body is named only if nothing else is
        there."""
        own = [row for row in self.system.constraint_rows if row.connection == connection]
        rows = [row for row in own if not isinstance(row.measure, Angle)]  # the angle of a clamp has no place
        points = [
            p for row in rows if isinstance(row.measure, Displacement) for p in (row.measure.origin, row.measure.of)
        ]
        named = [str(p) for p in points if "." in str(p)]
        if len(points) != 2 * len(rows) or len(rows) < 2 or not named:
            return ""
        particles = [str(p) for p in points if str(p) in self.system.bodies and not self.system.bodies[str(p)].turns]
        telling = [name for name in named if not name.endswith(".origin")]
        return (telling or particles or named)[0].removeprefix(f"{GROUND}.")

    def _lines_of_action(self, bodies: tuple[str, ...]) -> list[tuple[str, Vector]]:
        """Force, and moment about the origin, of every reaction that acts on some bodies together from outside."""
        rows = dict.fromkeys(row for body in bodies for row in self.acting.acting_on(body))
        found = [(row, self._resultant(row, bodies)) for row in rows]
        return [(row, line) for row, line in found if any(not v.is_zero() for v in line[:2])]

    def _resultant(self, row: str, bodies: tuple[str, ...]) -> Vector:
        f = self.field
        fx = fy = moment = f.zero
        for body in bodies:
            gx, gy, gm = (self.acting.directions[row].get((body, slot), f.zero) for slot in ("x", "y", "angle"))
            x, y = self.position(body)
            fx, fy, moment = fx + gx, fy + gy, moment + gm + x * gy - y * gx
        return f.lowest_terms(fx), f.lowest_terms(fy), f.lowest_terms(moment)


def place_in_plane(model: SymbolicModel, body: str) -> tuple[Ratio, Ratio]:
    """Where a mass centre is."""
    pose = model.geometry.pose(body)
    assert isinstance(pose, Pose)
    return pose.x, pose.y


def _is_unit(v: Vector) -> bool:
    return (v[0] * v[0] + v[1] * v[1] - 1).is_zero()


def _distinct(aims: Sequence[Aim]) -> list[Aim]:
    """Without those that are parallel to an earlier one."""
    found: list[Aim] = []
    for aim in aims:
        x, y = aim.vector
        if not any((x * other.vector[1] - y * other.vector[0]).is_zero() for other in found):
            found.append(aim)
    return found
