"""What to draw of a system: its bodies, and the glyphs that its connections and loads declare, in numbers."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from freebody.language.expression import ZERO, Expr
from freebody.measures.geometry import GROUND as GROUND_NAME
from freebody.measures.geometry import Direction, Point
from freebody.model.elements import Edge, RigidBody, SolidPart
from freebody.model.glyphs import (
    Ball,
    Belt,
    Cross,
    Field,
    Groove,
    Halt,
    Pin,
    Rail,
    Relation,
    Rod,
    Roller,
    Rope,
    Spring,
    Surface,
    Tether,
    Toothed,
    Touch,
    Track,
    TurnHalt,
    Weld,
    Wheels,
    in_numbers,
)
from freebody.model.solids import DISK
from freebody.present import figures
from freebody.present.figures import GROUND, Array, Drawn, Figure, FigurePart, Heading, Pair, Place, ShownGlyph, Wall
from freebody.present.places import Places
from freebody.system.system import System

_THIN = 0.95  # a wheel whose inertia is more than this times m R^2 has its mass in its rim


@dataclass(frozen=True)
class Scene:
    """The bodies of a system and what joins and pushes them, in numbers [m, rad]; lengths that depend on time are those
    at t = 0."""

    title: str
    names: tuple[str, ...]  # of the moving bodies, in the order of the poses
    figures: tuple[Figure, ...]
    shown: tuple[ShownGlyph, ...]
    # of space: a point and the normal of each plane; the vertical (3,); centres (n, 3) and axes (n, 3, 3) of the bodies
    # that stand still, the ground last
    planes: tuple[tuple[Place, Heading], ...] = ()
    up: Array = field(default_factory=lambda: np.array((0.0, 1.0, 0.0)))
    fixed: tuple[Array, Array] = field(default_factory=lambda: (np.zeros((1, 3)), np.eye(3)[None]))

    @classmethod
    def of(cls, system: System, number: Callable[[Expr], float]) -> Scene:
        """What to draw of a system whose expressions have the values `number` (such as `Reference.number`)."""
        return _Reader(system, number).scene()

    def looks_like(self, other: Scene) -> bool:
        """Whether the same is drawn of another one of the plane."""
        return (self.names, self.figures, self.shown) == (other.names, other.figures, other.shown)

    @property
    def ground(self) -> int:
        """The index of the ground in space."""
        return len(self.names) + len(self.fixed[0]) - 1

    def is_fixed(self, index: int) -> bool:
        return index >= len(self.names) or index == GROUND

    def figure_of(self, body: int) -> Figure | None:
        """The body of an index that moves; None for the ground."""
        return next((figure for figure in self.figures if figure.index == body != GROUND), None)

    # -- glyphs by their kind -----------------------------------------------------------------
    @cached_property
    def signs(self) -> tuple[Drawn, ...]:
        return tuple(shown.sign for shown in self.shown)

    @cached_property
    def pins(self) -> tuple[tuple[Place, Place], ...]:
        """Pairs of places about which bodies turn; in the plane balls and crosses are pins too."""
        return tuple((s.first, s.second) for s in self.signs if isinstance(s, (Pin, Ball, Cross)))

    @cached_property
    def welds(self) -> tuple[tuple[Place, Place], ...]:
        return tuple((s.first, s.second) for s in self.signs if isinstance(s, Weld))

    @cached_property
    def rails(self) -> tuple[figures.Rail, ...]:
        return tuple(s for s in self.signs if isinstance(s, Rail))

    @cached_property
    def grooves(self) -> tuple[figures.Groove, ...]:
        return tuple(s for s in self.signs if isinstance(s, Groove))

    @cached_property
    def rollers(self) -> tuple[figures.Roller, ...]:
        return tuple(s for s in self.signs if isinstance(s, Roller))

    @cached_property
    def tracks(self) -> tuple[figures.Track, ...]:
        return tuple(s for s in self.signs if isinstance(s, Track))

    @cached_property
    def wheels(self) -> tuple[figures.Wheels, ...]:
        return tuple(s for s in self.signs if isinstance(s, Wheels))

    @cached_property
    def belts(self) -> tuple[figures.Belt, ...]:
        return tuple(s for s in self.signs if isinstance(s, Belt))

    @cached_property
    def rods(self) -> tuple[tuple[Place, Place], ...]:
        return tuple((s.first, s.second) for s in self.signs if isinstance(s, Rod))

    @cached_property
    def ropes(self) -> tuple[figures.Rope, ...]:
        return tuple(s for s in self.signs if isinstance(s, Rope))

    @cached_property
    def springs(self) -> tuple[figures.Spring, ...]:
        return tuple(s for s in self.signs if isinstance(s, Spring))

    @cached_property
    def halts(self) -> tuple[figures.Halt | figures.TurnHalt, ...]:
        return tuple(s for s in self.signs if isinstance(s, (Halt, TurnHalt)))

    @cached_property
    def tethers(self) -> tuple[figures.Tether, ...]:
        return tuple(s for s in self.signs if isinstance(s, Tether))

    @cached_property
    def touching(self) -> frozenset[tuple[int, int]]:
        """Bodies that may touch each other, or the ground, by index."""
        index = {name: k for k, name in enumerate(self.names)}
        pairs = ((s.first, s.second) for s in self.signs if isinstance(s, Touch))
        return frozenset((index.get(a, GROUND), index.get(b, GROUND)) for a, b in pairs)

    @cached_property
    def hanging(self) -> frozenset[int]:
        """Bodies whose place aside is not stated, by index."""
        return frozenset(self.names.index(body) for rope in self.ropes for body in rope.hanging)

    @cached_property
    def walls(self) -> tuple[Wall, ...]:
        """The surfaces, each line once."""
        found: dict[tuple[float, ...], Wall] = {}
        for surface in self.signs:
            if isinstance(surface, Surface):
                wall = Wall(surface.through, surface.along, surface.tips, self._edge(surface))
                key = _key(wall)
                if key in found:
                    wall = replace(found[key], tips=(*found[key].tips, *wall.tips))
                found[key] = wall
        return tuple(found.values())

    def _edge(self, surface: figures.Surface) -> Pair | None:
        """From where to where a line is an edge of the polygon, or the axis of the rod, that it is fixed in."""
        corners = next((figure.corners for figure in self.figures if figure.name == surface.body), ())
        if not corners:
            return None
        away = np.array([corner.xy for corner in corners]) - np.array(surface.through.xy)
        e = np.array(surface.along.xy)
        across = away @ np.array([-e[1], e[0]])
        on_it = np.abs(across) < 1e-6 * (float(np.ptp(away, axis=0).max()) or 1.0)
        if on_it.sum() < 2 or (across[~on_it] > 0).any():
            return None
        travel = away[on_it] @ e
        return float(travel.min()), float(travel.max())

    @cached_property
    def gravity(self) -> Array | None:
        """(3,) the direction of a field that pushes every body, if there is any."""
        along = next((s.along for s in self.signs if isinstance(s, Field)), None)
        return None if along is None else np.array(along.along)

    def lies(self, rope: figures.Rope) -> bool:
        """Whether the free first part of a rope is pressed by gravity on what ends at a point of the ground."""
        first, comes, out = rope.nodes[0], rope.comes, rope.leads[0].along
        if self.gravity is None or comes is None or out is None or first.place.body != GROUND or first.arm != 0:
            return False
        bend = comes.x * out.y - comes.y * out.x  # the table is on that side
        x, y = self.gravity[:2]
        return bool(bend * (comes.x * y - comes.y * x) > 1e-6)

    def joined(self) -> Iterator[tuple[Place, Place]]:
        """Pairs of places between which bodies are held together."""
        yield from (*self.pins, *self.welds, *self.rods)
        yield from ((groove.center, groove.point) for groove in self.grooves)


def _key(wall: Wall) -> tuple[float, ...]:
    """What is the same for two descriptions of one line."""
    e = wall.along
    level = wall.through.y * e.x - wall.through.x * e.y
    return (e.body, *(round(v, 9) for v in (e.x, e.y, level)))


class _Reader:
    """Turns the glyphs and bodies of a system into numbers."""

    def __init__(self, system: System, number: Callable[[Expr], float]) -> None:
        self.system, self.number = system, number
        self.places = Places(system, number)
        self.shown = tuple(self._shown())
        self.signs = [shown.sign for shown in self.shown]
        edges = [sign for sign in self.signs if isinstance(sign, Relation) and sign.is_edge]
        self.edges = {edge.points[0].body: Edge(edge.points, "area") for edge in edges}

    def scene(self) -> Scene:
        bodies = (body for body in self.system.material.values() if body.name != GROUND_NAME)
        found = tuple(self._figure(k, body) for k, body in enumerate(bodies))
        names = tuple(body.name for body in self.system.moving)
        planes = [plane for body in self.system.material.values() for plane in body.planes.values()]
        sheets = tuple((self.places.place(plane.through), self.places.heading(plane.normal)) for plane in planes)
        up = np.array(self.places.vector(self.system.up))
        formed = {figure.index for figure in found if any(edge in self.edges.values() for edge in figure.edges)}
        shown = tuple(s for s in self.shown if not (_is_edge(s.sign) and figures.owners(s.sign) <= formed))
        return Scene(self.system.title, names, found, shown, sheets, up, self.places.fixed)

    def _shown(self) -> Iterator[ShownGlyph]:
        """Without strings that are slack in the mode of the system, with rails that a particle cannot turn on, and with
        wheels on their road where the model says so, instead of pins in slots."""
        looks = self.system.looks
        wheels = {} if self.system.space else {at: self._roller(at, radius) for at, radius in looks.wheels.items()}
        yield from (ShownGlyph(at.body, roller) for at, roller in wheels.items())
        taut = {row.connection for row in self.system.constraint_rows}
        for glyph in self.system.glyphs:
            shown = in_numbers(glyph, self.places.place, self.places.heading, self.number)
            sign = shown.sign
            if isinstance(sign, Rope) and not shown.is_load and shown.owner not in taut:
                continue
            if isinstance(glyph.sign, Rail) and self._bears(glyph.sign):
                assert isinstance(sign, Rail)
                shown = replace(shown, sign=replace(sign, is_support=True))
            elif isinstance(glyph.sign, Rail) and not self.system.bodies[glyph.sign.point.body].turns:
                assert isinstance(sign, Rail)
                shown = replace(shown, sign=replace(sign, turning="not"))
            elif isinstance(glyph.sign, Rail) and glyph.sign.point in wheels:
                assert isinstance(sign, Rail)
                shown = replace(shown, sign=self._road(wheels[glyph.sign.point], sign.along))
            yield shown

    def _bears(self, rail: Rail[Point, Direction]) -> bool:
        """Whether a slot is the support on rollers of a beam or a truss: one of the ground under what cannot move."""
        on_ground = rail.along.body == GROUND_NAME != rail.point.body
        return on_ground and rail.turning != "not" and not self.system.space and self._is_structure

    @cached_property
    def _is_structure(self) -> bool:
        """Whether as much holds the bodies of the plane as they could move."""
        rows = self.system.constraint_rows
        freedoms = sum(3 if body.turns else 2 for body in self.system.moving)
        return len(rows) >= freedoms and not any(row.is_driven for row in rows)

    def _roller(self, at: Point, radius: Expr) -> figures.Roller:
        foot, r = self.places.place(at), self.number(radius)
        return Roller(foot._replace(y=foot.y + r), r)

    def _road(self, wheel: figures.Roller, along: Heading) -> figures.Track:
        """The road of a wheel that holds a slot: on the side of its line where the body's own y axis does not point."""
        left, own = self.places.at_start(along.normal()), self.places.at_start(Heading(wheel.center.body, 0.0, 1.0))
        return Track(wheel.center, along, math.copysign(wheel.radius, float(left @ own)))

    def _figure(self, k: int, body: RigidBody) -> Figure:
        points = {name: self.places.place(body.point(name)) for name in body.points}
        center = self.places.place(body.center)
        touched = [(s.second, s.within) for s in self.signs if isinstance(s, Touch) and s.first == body.name]
        plain = Figure(
            body.name,
            k,
            self.places.index.get(body.name, GROUND),
            self.places.place(body.mass_center),
            points,
            center,
            is_particle=not body.turns,
            has_mass=body.mass != ZERO,
            has_place=body.start.at is not None,
            corners=tuple(points[name] for name in body.corners),
            outside=tuple(dict.fromkeys(name for name, within in touched if not within)),
            inside=tuple(dict.fromkeys(name for name, within in touched if within)),
            edges=tuple(
                Edge(tuple(self.places.place(Point(body.name, at)) for at in edge.places), edge.look)
                for edge in body.edges
            ),
            path=tuple(points[name] for name in self.system.looks.paths.get(body.name, ())),
            scale=self.system.looks.scale.get(body.name, 1.0),
            solid=body.solid,
        )
        if self.system.space:
            return self._solid(plain, body)
        if body.radius is not None and not body.edges:
            return self._wheel(plain, body, self.number(body.radius))
        if not body.edges and not body.corners and (pitch := self._pitch_radius(plain.center)):
            return self._wheel(plain, body, pitch)
        edge = self.edges.get(plain.index)  # of a body without a form of its own, as a cam
        return plain if edge is None or body.edges or body.corners else replace(plain, edges=(edge,))

    def _solid(self, plain: Figure, body: RigidBody) -> Figure:
        """The form of a body of space, and whether it is a gear wheel."""
        toothed: set[int] = set()
        for sign in self.signs:
            if isinstance(sign, Toothed) or (isinstance(sign, Wheels) and sign.is_toothed):
                toothed |= figures.owners(sign)
        return replace(
            plain,
            sizes=tuple(self.number(size) for size in body.sizes),
            axis=self.places.vector(body.axis) if body.axis else None,
            faces=tuple(tuple(plain.points[name] for name in corners) for _name, corners in body.faces),
            is_toothed=plain.index in toothed,
            parts=tuple(self._part(plain, part) for part in body.solid_parts),
        )

    def _part(self, whole: Figure, part: SolidPart) -> FigurePart:
        """A part of a composite body, as a figure about its own reference point."""
        middle = Place(whole.index, 0.0, 0.0)
        form = Figure(
            whole.name,
            whole.number,
            whole.index,
            middle,
            {},
            middle,
            is_particle=part.is_particle,
            solid=part.kind,
            sizes=tuple(self.number(size) for size in part.sizes),
            axis=self.places.vector(part.axis) if part.axis else None,
        )
        x, y, z = (self.places.vector(column) for column in part.axes)
        return FigurePart(form, (x, y, z), self.places.vector(part.center))

    def _wheel(self, plain: Figure, body: RigidBody, rim: float) -> Figure:
        """A round body: with what touches its circles, and whether there is room inside."""
        center, mass = plain.center, self.number(body.mass)
        own = map(self.number, body.middle_circles.values())
        arms = {round(abs(arm), 12) for arm in (*self._arms_about(center), *own)}
        hubs = tuple(sorted((arm for arm in arms if arm and not math.isclose(arm, rim)), reverse=True))
        wheels = [s for s in self.signs if isinstance(s, Wheels)]
        rolling = [c for c in wheels if c.radii[1] < 0 < sum(c.radii) and _is_near(c.first, center)]
        index = self.places.index
        inside = plain.inside + tuple(name for c in rolling for name, k in index.items() if k == c.second.body)
        is_thin = not hubs and self.number(body.inertia) > _THIN * mass * rim**2 > 0
        bore = self.number(body.inner) if body.inner is not None and body.solid == DISK else 0.0
        is_hollow = bool(inside) or is_thin or body.is_ring or bore > 0.0
        return replace(plain, radius=rim, hubs=hubs, is_hollow=is_hollow, bore=bore, inside=inside)

    def _pitch_radius(self, center: Place) -> float:
        """Of a gear that says nothing of its size the greatest of its pitch circles; 0 of what is no gear."""
        gears = [s for s in self.signs if isinstance(s, Wheels) and s.is_toothed]
        ends = [end for gear in gears for end in zip((gear.first, gear.second), gear.radii, strict=True)]
        return max((abs(radius) for place, radius in ends if _is_near(place, center)), default=0.0)

    def _arms_about(self, center: Place) -> Iterable[float]:
        """Radii of the circles about a centre that strings, gears and surfaces touch."""
        for sign in self.signs:
            match sign:
                case Rope(nodes, is_fall=False):
                    yield from (node.arm for node in nodes if _is_near(node.place, center))
                case Wheels(first, second, radii) | Belt(first, second, radii):
                    ends = zip((first, second), radii, strict=True)
                    yield from (radius for place, radius in ends if _is_near(place, center))
                case Track(place, _along, radius) if _is_near(place, center):
                    yield radius
                case _:
                    pass


def _is_edge(sign: Drawn) -> bool:
    return isinstance(sign, Relation) and sign.is_edge


def _is_near(a: Place, b: Place) -> bool:
    return a.body == b.body and math.isclose(a.x, b.x, abs_tol=1e-9) and math.isclose(a.y, b.y, abs_tol=1e-9)
