"""What to draw of a system, from the measures that it holds and pushes.

Nothing here asks for the kind of a connection. Two displacements between the same points are a pin, one across a
direction is a guide, a distance is a massless link, angles with a bearing are circles that roll on each other, a
row that runs between ends is a string. A measure that is none of these is not drawn.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from itertools import groupby

from freebody.language.expression import ZERO, Expr, free_symbols
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.combination import Combination, Composed
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Bearing, Distance
from freebody.model.elements import RATE, VALUE, Held, Push, RateMeasure, RigidBody
from freebody.present.figures import GROUND, Contact, Figure, Guide, Heading, Joints, Pin, Place, Spring
from freebody.present.places import Places
from freebody.present.ropes import is_rope, rope
from freebody.present.touching import Touching
from freebody.system.system import System

_THIN = 0.95  # a wheel whose inertia is more than this times m R^2 has its mass in its rim


@dataclass(frozen=True)
class Scene:
    """The bodies and joints of a system, in numbers [m, rad]; lengths that depend on time are those at t = 0."""

    title: str
    names: tuple[str, ...]  # of the moving bodies, in the order of the poses
    figures: tuple[Figure, ...]
    joints: Joints

    @classmethod
    def of(cls, system: System, number: Callable[[Expr], float]) -> Scene:
        """What to draw of a system whose expressions have the values `number` (such as `Reference.number`)."""
        reader = _Reader(system, number)
        joints = reader.joints()
        names = tuple(body.name for body in system.moving)
        return cls(system.title, names, tuple(reader.figures(joints)), joints)


class _Reader:
    """Turns expressions and names into numbers and indices."""

    def __init__(self, system: System, number: Callable[[Expr], float]) -> None:
        places = Places(system, number)
        self.system = system
        self.number = number
        self.index = places.index
        self.place, self.heading = places.place, places.heading
        self.touching = Touching(system, places)

    # -- joints -------------------------------------------------------------------------------
    def joints(self) -> Joints:
        found = Joints()
        for _name, group in groupby(self.system.held, key=lambda row: row.connection):
            self._connection(list(group), found)
        for push in self.system.pushes:
            self._load(push, found)
        touching = self.touching
        found.surfaces.extend(touching.surfaces())
        found.halts.extend(touching.halts())
        found.touching.update(touching.pairs())
        return found

    def _connection(self, rows: Sequence[Held], found: Joints) -> None:
        """What the rows of one connection show."""
        strings = [row for row in rows if is_rope(row)]
        if strings:
            way = rope(strings, self.place, self.heading, self.number, self._rim)
            found.ropes.extend([way] if way else [])
        rest = [(row, _plain(row.measure)) for row in rows if row not in strings]
        keeps_angle = any(isinstance(m, Angle) for _row, m in rest)
        if strings:
            sideways = [m for _row, m in rest if isinstance(m, Displacement)]
            found.hanging.update(self.index[m.of.body] for m in sideways if m.of.body in self.index)
            return
        rolls = [self._rolling(m) for _row, m in rest if isinstance(m, Combination)]
        is_toothed = not any(row.unilateral for row in rows)
        found.contacts.extend(replace(c, is_toothed=is_toothed) for c in rolls if isinstance(c, Contact))
        found.guides.extend(g for g in rolls if isinstance(g, Guide))
        if any(rolls):
            return
        across = [(row, m) for row, m in rest if isinstance(m, Displacement) and not _is_driven(row)]
        if len(across) == 2 and (across[0][1].of, across[0][1].origin) == (across[1][1].of, across[1][1].origin):
            pin = across[0][1]
            found.pins.append(Pin(self.place(pin.origin), self.place(pin.of), keeps_angle))
        else:
            found.guides.extend(self._guide(row, m, keeps_angle) for row, m in across)
        for row, m in rest:
            if isinstance(m, Distance) and not _is_driven(row):
                found.links.append((self.place(m.start), self.place(m.end)))

    def _guide(self, row: Held, across: Displacement, keeps_angle: bool) -> Guide:
        """A displacement across a line; its direction is the line's, turned counter-clockwise."""
        normal = self.heading(across.along)
        body = self.system.bodies[across.of.body]
        offset = 0.0 if row.target is None else self.number(row.target)
        along = Heading(normal.body, normal.y, -normal.x)
        return Guide(self.place(across.of), along, offset, turns=body.turns and not keeps_angle)

    def _rolling(self, measure: Combination) -> Contact | Guide | None:
        """Arcs that roll off: r1 theta1 + r2 theta2 - (r1 + r2) bearing of two circles, s + R theta on a line."""
        parts = [part for _coefficient, part in measure.terms]
        factors = [coefficient for coefficient, _part in measure.terms]
        bearing = next((m for m in parts if isinstance(m, Bearing)), None)
        if bearing is not None and len(parts) == 3 and sum(isinstance(m, Angle) for m in parts) == 2:
            first, second = (f for f, m in zip(factors, parts, strict=True) if isinstance(m, Angle))
            radii = self.number(first), self.number(second)
            return Contact(self.place(bearing.start), self.place(bearing.end), radii)
        if len(parts) == 2 and isinstance(parts[0], Displacement) and isinstance(parts[1], Angle):
            center = self.place(parts[0].of)
            return Guide(center, self.heading(parts[0].along), self.number(factors[1]), turns=True)
        return None

    def _load(self, push: Push, found: Joints) -> None:
        inner = inside(push.measure)
        if isinstance(inner, Distance):
            used = free_symbols(push.law)
            ends = self.place(inner.start), self.place(inner.end)
            found.springs.append(Spring(*ends, VALUE.name in used, RATE.name in used))

    # -- bodies -------------------------------------------------------------------------------
    def _rim(self, place: Place) -> float | None:
        """The radius of the round body of which a place is the centre."""
        for body in self.system.bodies.values():
            if body.radius is not None and _is_near(self.place(body.center), place):
                return self.number(body.radius)
        return None

    def figures(self, joints: Joints) -> Iterable[Figure]:
        for k, body in enumerate(b for b in self.system.bodies.values() if b.name not in ("ground",)):
            yield self._figure(k, body, joints)

    def _figure(self, k: int, body: RigidBody, joints: Joints) -> Figure:
        points = {name: self.place(body.point(name)) for name in body.points}
        center = self.place(body.center)
        plain = Figure(
            body.name,
            k,
            self.place(body.mass_center),
            points,
            center,
            self.index.get(body.name, GROUND),
            is_particle=not body.turns,
            has_mass=body.mass != ZERO,
            has_place=body.start.at is not None,
            corners=tuple(points[name] for name in body.corners),
            outside=self.touching.outside(body.name),
            inside=self.touching.inside(body.name),
        )
        if body.radius is None:
            return plain
        rim, mass = self.number(body.radius), self.number(body.mass)
        arms = {round(abs(arm), 12) for arm in _arms_about(center, joints)}
        hubs = tuple(sorted((arm for arm in arms if arm and not math.isclose(arm, rim)), reverse=True))
        rolling = [c for c in joints.contacts if c.radii[1] < 0 < sum(c.radii) and _is_near(c.first, center)]
        inside = plain.inside + tuple(name for c in rolling for name, k in self.index.items() if k == c.second.body)
        is_thin = not hubs and self.number(body.inertia) > _THIN * mass * rim**2 > 0
        return replace(plain, radius=rim, hubs=hubs, is_hollow=bool(inside) or is_thin or body.is_ring, inside=inside)


def _arms_about(center: Place, joints: Joints) -> Iterable[float]:
    """Radii of the circles about a centre that strings, gears and surfaces touch."""
    for way in joints.ropes:
        yield from (node.arm for node in way.nodes if _is_near(node.place, center))
    for contact in joints.contacts:
        ends = zip((contact.first, contact.second), contact.radii, strict=True)
        yield from (radius for place, radius in ends if _is_near(place, center))
    yield from (guide.offset for guide in joints.guides if _is_near(guide.point, center))


def _is_near(a: Place, b: Place) -> bool:
    return a.body == b.body and math.isclose(a.x, b.x, abs_tol=1e-9) and math.isclose(a.y, b.y, abs_tol=1e-9)


def _is_driven(row: Held) -> bool:
    """Whether the target of a row changes with time: it moves something along rather than guides it."""
    return row.target is not None and "t" in free_symbols(row.target)


def _plain(measure: Measure | RateMeasure) -> Measure | RateMeasure:
    """The measure of which only changes are held."""
    if isinstance(measure, Combination) and len(measure.terms) == 1:
        return measure.terms[0][1]
    return measure


def inside(measure: Measure | RateMeasure) -> Measure | RateMeasure:
    """The only measure in an expression of one measure."""
    measure = _plain(measure)
    return measure.measures[0][1] if isinstance(measure, Composed) and len(measure.measures) == 1 else measure
