"""Draws a scene on its way: which strokes, in which order.

What stands still comes first, then bodies, the larger behind the smaller, then what joins them.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise

import numpy as np

from freebody.model import glyphs
from freebody.present.edges import Edges
from freebody.present.figures import (
    GROUND,
    Array,
    Figure,
    Heading,
    Place,
    Spread,
    Spring,
    angles,
    is_within,
    positions,
    turned,
)
from freebody.present.guides import Guides
from freebody.present.layout import Layout, headings, placed_in
from freebody.present.picture.label import equation
from freebody.present.scene import Scene
from freebody.present.strokes import Caption, Path, Strand, Stretch, Stroke
from freebody.present.surfaces import surplus
from freebody.present.symbols import (
    DASHPOT,
    ZIGZAG,
    aside,
    box,
    capsule,
    circle,
    hatched,
    hatched_ring,
    spiral,
    support,
    vane,
)

_END = 0.16  # the end of a rope, in sizes of symbols


_LEAST_SPREAD = 0.4  # height of the lowest one, to the highest one
SPREAD = 2.6  # height of a load along a line where it is largest, in sizes of symbols
_WAVE = 0.6  # height of the waves of a slack string, in sizes of symbols
_HUB = 1.8  # radius of a hub, in sizes of symbols
_STEEP = 0.3  # sine of the angle of two surfaces between which something is drawn higher along one of them


def full_height(sizes: Sequence[float], all_sizes: Iterable[Sequence[float]]) -> float:
    """The size that is drawn in full height beside a load of these sizes: the largest of the picture, so that loads
    compare by their heights; a load is never so low that nothing is seen of it."""
    own = max(map(abs, sizes))
    return min(max(max(map(abs, sizes)) for sizes in all_sizes), own / _LEAST_SPREAD) or 1.0


class Pen:
    """Draws a scene in the order of its layers: what stands still, bodies, what joins them, names."""

    def __init__(self, scene: Scene, layout: Layout) -> None:
        self.scene = scene
        self.poses, self.ropes, self.u = layout.poses, layout.ropes, layout.symbol
        self.guides = Guides(self.scene, self.poses, self.u)

    def strokes(self) -> Iterator[Stroke]:
        yield from self.guides.strokes()
        yield from self._supports()
        bodies = sorted(self.scene.figures, key=self._layer)
        for figure in bodies:
            if not figure.is_particle:
                yield from self._body(figure)
        for a, b in self.scene.rods:
            yield Stretch(a, b, np.array([(0.0, 0.0), (1.0, 0.0)]), "link")
        for roller in self.scene.rollers:
            yield Path(roller.center, roller.center.body, circle(roller.radius, 24), "roller", True)
        for spring in self.scene.springs:
            yield from self._spring(spring)
        for sign in self.scene.signs:
            if isinstance(sign, glyphs.Relation) and len({place.body for place in sign.points}) == 1 < len(sign.points):
                first = sign.points[0]  # a line fixed in a body
                line = np.array([place.xy for place in sign.points]) - np.array(first.xy)
                yield Path(first, first.body, line, "surface", sign.is_edge)
            elif isinstance(sign, glyphs.Center):
                yield Path(sign.at, sign.at.body, circle(0.5 * self.u), "center", is_closed=True)
            elif isinstance(sign, glyphs.Relation):
                for a, b in pairwise(sign.points):
                    yield Stretch(a, b, np.array([(0.0, 0.0), (1.0, 0.0)]), "pull")
        lead, edges = 0, Edges(self.scene, self.poses, self.u)
        for rope in self.ropes:
            yield Strand(rope, lead, wave=_WAVE * self.u)
            yield from edges.strokes(rope)
            lead += len(rope.leads)
        for figure in bodies:
            if figure.is_particle:
                yield from self._body(figure)
        yield from self._joints()
        for sign in self.scene.signs:
            if isinstance(sign, glyphs.Coil):
                yield from self._coil(sign.body, sign.base, is_spring=sign.is_spring)
            elif isinstance(sign, glyphs.Shoe):
                yield from self._shoe(sign.first, sign.second)
            elif isinstance(sign, glyphs.Spread):
                yield from self._spread(sign)

    def _layer(self, figure: Figure) -> tuple[bool, float]:
        """Rings first, then the larger bodies behind the smaller ones."""
        size = figure.radius or float(np.ptp(figure.outline, axis=0).max())
        return not figure.is_hollow, -size

    # -- ground -------------------------------------------------------------------------------
    def _supports(self) -> Iterator[Stroke]:
        """What holds points of the ground: a triangle for pins and links, a hatched line for springs and strings."""
        stands: dict[Place, list[Place]] = {}
        for a, b in (*self.scene.pins, *self.scene.rods):
            for ground, other in ((a, b), (b, a)):
                if ground.body == GROUND != other.body:
                    stands.setdefault(ground, []).append(other)
        for ground, others in stands.items():
            up = self._is_below(ground, others)
            for points, style, is_closed in support(self._support_size(others), upside_down=up):
                yield Path(ground, GROUND, points, style, is_closed)
        held = [(s.first, self._bearing(s.first, s.second)) for s in self.scene.springs]
        held += [(s.second, self._bearing(s.second, s.first)) for s in self.scene.springs]
        for rope in self.ropes:
            lead = headings(rope, self.poses)[0]
            ends = (
                ()
                if rope.is_closed or self.scene.lies(rope)
                else ((rope.nodes[0], lead[0]), (rope.nodes[-1], lead[-1] + np.pi))
            )
            held += [(node.place, float(bearing)) for node, bearing in ends if not node.is_drum]
        held += [(a, self._bearing(a, self._center(b))) for weld in self.scene.welds for a, b in (weld, weld[::-1])]
        for place, bearing in held:
            if place.body == GROUND and place not in stands:
                across = bearing + np.pi / 2
                wall = np.array([(-1.5 * self.u, 0.0), (1.5 * self.u, 0.0)])
                yield Path(place, GROUND, turned(across, *wall.T), "surface")
                strokes = hatched(-1.5 * self.u, 1.5 * self.u, 0.8 * self.u, 0.75 * self.u)
                yield Path(place, GROUND, turned(across, *strokes.T), "hatch")

    def _support_size(self, others: Sequence[Place]) -> float:
        """A support is not larger than the wheel on it."""
        figures = [self.scene.figure_of(p.body) for p in others]
        return min([self.u, *(0.5 * f.radius for f in figures if f and f.radius)])

    def _center(self, place: Place) -> Place:
        figure = self.scene.figure_of(place.body)
        return figure.mass_center if figure else place

    def _bearing(self, a: Place, b: Place) -> float:
        x, y = positions(self.poses, b)[0] - positions(self.poses, a)[0]
        return float(np.arctan2(y, x))

    def _is_below(self, ground: Place, others: Sequence[Place]) -> bool:
        """Whether what is joined to a point hangs below it most of the time."""
        heights = [positions(self.poses, self._center(p))[:, 1].mean() - ground.y for p in others]
        return float(np.mean(heights)) < -0.2 * self.u

    # -- bodies -------------------------------------------------------------------------------
    def _body(self, figure: Figure) -> Iterator[Stroke]:
        turn, color = figure.index, figure.number
        fill = "dot" if figure.is_particle else "body" if turn != GROUND else "fixed body"
        if figure.radius is not None:
            yield from self._wheel(figure, fill)
            return
        outline = figure.outline
        rest = Place(turn, 0.0, 0.0) if turn != GROUND else figure.mass_center
        if turn == GROUND:
            outline = outline - np.array(figure.mass_center.xy)
        size = float(np.ptp(outline, axis=0).max())
        if size < 1e-9:
            yield self._dot(figure, fill)
        elif figure.path:
            for a, b in pairwise(figure.path):
                points = capsule(a.xy, b.xy, 0.35 * self.u)
                yield Path(Place(turn, 0.0, 0.0), turn, points, fill, True, color)
        elif len(outline) == 2:
            points = capsule(tuple(outline[0]), tuple(outline[1]), surplus(figure, self.u))
            yield Path(rest, turn, points, fill, True, color)
        elif figure.edges:
            yield from self._edges(figure, rest, fill)
            yield from self._arms(figure)
            yield from self._hub(figure)
        else:
            yield Path(rest, turn, outline, fill, True, color)
            yield from self._arms(figure)
        if figure.has_mass and turn != GROUND and size > 4 * self.u:
            yield Path(figure.mass_center, turn, circle(0.22 * self.u), "mass center", True, color)

    def _edges(self, figure: Figure, rest: Place, fill: str) -> Iterator[Path]:
        """The parts of a flat body, and the holes in them."""
        turn, color = figure.index, figure.number
        at = np.array(figure.mass_center.xy if turn == GROUND else (0.0, 0.0))
        looks = {"area": fill, "hole": "hole", "wire": "hoop" if turn != GROUND else "fixed rim"}
        for edge in sorted(figure.edges, key=lambda edge: edge.look == "hole"):
            points = np.array([place.xy for place in edge.places]) - at
            if len(points) == 1:
                points = points + circle(0.7 * self.u)
                yield Path(rest, turn, points, "dot" if turn != GROUND else fill, True, color)
            else:
                yield Path(rest, turn, points, looks[edge.look], edge.look != "wire", color)

    def _hub(self, figure: Figure) -> Iterator[Path]:
        """A circle round the pin of a body with an edge all round it."""
        around = [np.array([place.xy for place in edge.places]) for edge in figure.edges if edge.look == "area"]
        if len(figure.edges) != 1 or not around:
            return
        for place in (a for pin in self.scene.pins for a in pin if a.body == figure.index != GROUND):
            least = float(np.hypot(*(around[0] - place.xy).T).min())
            if least > _HUB * self.u:
                yield Path(place, place.body, circle(min(_HUB * self.u, 0.4 * least), 24), "rim", True, figure.number)

    def _arms(self, figure: Figure) -> Iterator[Path]:
        """A line from the mass centre to what is joined to a body outside its edges."""
        scene, center = self.scene, figure.mass_center
        pairs = [*scene.pins, *scene.welds, *scene.rods, *((s.first, s.second) for s in scene.springs)]
        used = {place for pair in pairs for place in pair} | {n.place for rope in self.ropes for n in rope.nodes}
        for place in [p for p in dict.fromkeys(figure.points.values()) if p in used]:
            if not is_within(figure.outline, (place.x, place.y)):
                points = np.array([(0.0, 0.0), (place.x - center.x, place.y - center.y)])
                yield Path(center, figure.index, points, "rim", False, figure.number)

    def _dot(self, figure: Figure, fill: str) -> Path:
        """A point mass as a dot; as a block on its rail, on rough ground, or at the end of a straight string. Of a rope
        its end as a small dot."""
        if figure.solid.is_end:
            return Path(figure.mass_center, figure.index, circle(_END * self.u), fill, True, figure.number)
        rails = (rail for rail in self.scene.rails if rail.point.body == figure.index != GROUND)
        along, size = next(((rail.along, (1.5, 0.8)) for rail in rails if rail.turning == "not"), (None, (1.1, 0.7)))
        if along is None:
            rough = (s for s in self.scene.signs if isinstance(s, glyphs.Surface) and s.is_rough)
            along = next((s.along for s in rough if any(tip.body == figure.name for tip in s.tips)), None)
        if along is None:
            along, size = self._hung_along(figure), (0.9, 0.9)
        long, tall = (side * figure.scale * self.u for side in size)
        half = figure.scale * surplus(figure, self.u)
        carrying, higher = self._carried(figure, (half, half) if along is None else (long, tall))
        if along is None:
            points = circle(half)
        else:
            along = along if carrying is None else carrying
            points = turned(along.angle, *box(long, tall).T)
        turn = along.body if along is not None else figure.index if carrying is None else carrying.body
        return Path(figure.mass_center, turn, points + higher, fill, True, figure.number)

    def _carried(self, figure: Figure, half: tuple[float, float]) -> tuple[Heading | None, Array]:
        """The direction along which what lies on a moving body is turned, and (2,) [m] by how much higher it is drawn,
        in the axes of that: the edge that carries it cannot be drawn lower. Beside a wall it keeps away from that.
        half: [m] of its drawn length and height."""
        walls = [wall for wall in self.scene.walls if any(tip.body == figure.name for tip in wall.tips)]
        carrying = next((wall.along for wall in walls if wall.through.body != GROUND), None)
        carrying = self._edge_under(figure) if carrying is None else carrying
        if carrying is None:
            return None, np.zeros(2)
        normal = turned(float(angles(self.poses, carrying)[0]) + np.pi / 2, 1.0, 0.0)
        for wall in (wall for wall in walls if wall.is_endless):
            rise = float(normal @ np.array(wall.along.xy))
            if abs(rise) > _STEEP:
                return wall.along, half[0] / rise * np.array(wall.along.xy)
        return carrying, half[1] * np.array(carrying.normal().xy)

    def _edge_under(self, figure: Figure) -> Heading | None:
        """The edge, with what is free on its left, of a polygon on which a particle lies."""
        for other in self.scene.figures:
            if other.index == GROUND or (figure.index, other.index) not in self.scene.touching or not other.corners:
                continue
            corners = np.array([corner.xy for corner in other.corners])
            at = placed_in(self.poses[:1], other.index, figure.mass_center)[0]
            for a, b in pairwise([*corners, corners[0]]):
                e = (b - a) / (float(np.hypot(*(b - a))) or 1.0)
                ahead, aside = (at - a) @ e, (at - a) @ np.array([-e[1], e[0]])
                if abs(aside) < 0.5 * self.u and 0.0 <= ahead <= float((b - a) @ e):
                    inside = (corners.mean(axis=0) - a) @ np.array([-e[1], e[0]])
                    return Heading(other.index, *map(float, -np.sign(inside) * e))
        return None

    def _hung_along(self, figure: Figure) -> Heading | None:
        """The direction of the straight lead of a string at whose end a point mass hangs."""
        for rope in self.ropes:
            for node, lead in ((rope.nodes[0], rope.leads[0]), (rope.nodes[-1], rope.leads[-1])):
                if node.place.body == figure.index != GROUND and lead.along and lead.along.body == GROUND:
                    return lead.along
        return None

    def _wheel(self, figure: Figure, fill: str) -> Iterator[Path]:
        """A rim and a spoke, so that its turning is seen."""
        place, turn, color = figure.center, figure.index, figure.number
        rim = (figure.radius or 0.0) + self._room(figure)
        edge = "rim" if turn != GROUND else "fixed rim"
        if figure.is_hollow:
            yield from self._ring(figure, rim, fill, edge)
        else:
            pitch = self._is_pitch(figure, figure.radius or 0.0) and turn != GROUND
            yield Path(place, turn, self.guides.edge(figure, rim), "gear" if pitch else fill, True, color)
            if pitch:
                yield Path(place, turn, circle(rim, 24), "pitch circle", True, color)
            if turn != GROUND:
                yield Path(place, turn, np.array([(0.0, 0.0), (rim, 0.0)]), "spoke", False, color)
        for hub in figure.hubs:
            style = "pitch circle" if self._is_pitch(figure, hub) and turn != GROUND else edge
            yield Path(place, turn, circle(hub, 24), style, True, color)

    def _is_pitch(self, figure: Figure, radius: float) -> bool:
        """Whether a circle is the pitch circle of a gear."""
        if any(isinstance(s, glyphs.Toothed) and figure.center in s.wheels for s in self.scene.signs):
            return radius == figure.radius
        for gears in (wheels for wheels in self.scene.wheels if wheels.is_toothed):
            ends = zip((gears.first, gears.second), gears.radii, strict=True)
            if any(place == figure.center and abs(abs(arm) - radius) < 1e-9 * radius for place, arm in ends):
                return True
        return False

    def _ring(self, figure: Figure, rim: float, fill: str, edge: str) -> Iterator[Path]:
        """A wall on the side of the rim that nothing touches, and a mark on it; hatching round a fixed ring."""
        place, turn, color = figure.center, figure.index, figure.number
        if turn == GROUND and figure.inside and not figure.outside:
            yield Path(place, turn, hatched_ring(rim, self.u, self.u), "hatch")
            yield Path(place, turn, circle(rim, 24), "surface", True, color)
            return
        width = min(0.12 * rim, 1.2 * self.u) * (1.0 if figure.inside else -1.0)
        if figure.bore:  # an annulus, as thick as it is
            width = figure.bore - rim
        mark = np.array([(rim, 0.0), (rim + width, 0.0)])
        if figure.inside and figure.outside and not figure.bore:
            yield Path(place, turn, circle(rim, 24), "hoop" if turn != GROUND else edge, True, color)
            mark = np.array([(rim, 0.0), (rim - width, 0.0)])
        else:
            outer, inner = circle(rim + width, 24), circle(rim, 24)[::-1]
            seam = np.concatenate((outer, outer[:1], inner, inner[:1]))
            yield Path(place, turn, seam, f"{fill} ring", True, color)
            yield Path(place, turn, outer, edge, True, color)
            yield Path(place, turn, circle(rim, 24), edge, True, color)
        if turn != GROUND:
            yield Path(place, turn, mark, "spoke", False, color)

    def _room(self, figure: Figure) -> float:
        """How much wider or narrower a circle is drawn on which nothing but particles and rods lie, so that they do
        not sink in."""
        names = figure.inside or figure.outside
        if not names or (figure.inside and figure.outside):
            return 0.0
        others = [f for f in self.scene.figures if f.name in names]
        least = min((surplus(f, self.u) for f in others), default=0.0) if len(others) == len(names) else 0.0
        return least if figure.inside else -min(least, 0.1 * (figure.radius or 0.0))

    # -- joints -------------------------------------------------------------------------------
    def _spring(self, spring: Spring) -> Iterator[Stretch]:
        """A zigzag, a dashpot, or both side by side."""
        a, b = spring.first, spring.second
        others = [s for s in self.scene.springs if {s.first, s.second} == {a, b}]
        n = sum(s.is_spring + s.is_damper for s in others)
        k = sum(s.is_spring + s.is_damper for s in others[: others.index(spring)])
        for symbol in [ZIGZAG] * spring.is_spring + [DASHPOT] * spring.is_damper:
            left = (k - (n - 1) / 2) * 2.4
            lines = (line * (1.0, self.u) for line in aside(symbol, left))
            yield from (Stretch(a, b, line, "spring", longest=spring.longest) for line in lines)
            k += 1
        if spring.longest is not None:  # the plate of a buffer
            plate = np.array([(1.0, -0.9), (1.0, 0.9)]) * (1.0, self.u)
            yield Stretch(a, b, plate, "spring", longest=spring.longest)
        if not (spring.is_spring or spring.is_damper):
            yield Stretch(a, b, np.array([(0.0, 0.0), (1.0, 0.0)]), "pull")

    def _spread(self, load: Spread) -> Iterator[Stretch]:
        """Arrows side by side onto the body, under the line of their tails."""
        length = float(np.hypot(*np.subtract(load.second.xy, load.first.xy)))
        largest = full_height(load.sizes, (s.sizes for s in self.scene.signs if isinstance(s, glyphs.Spread)))
        n = max(3, round(length / (1.4 * self.u)))
        figure = self.scene.figure_of(load.first.body)
        near = surplus(figure, self.u) if figure is not None and len(figure.outline) == 2 else 0.0

        def line(points: Sequence[tuple[float, float]], style: str, *, is_closed: bool = False) -> Stretch:
            return Stretch(load.first, load.second, np.array(points), style, is_closed, against=load.along)

        tails: list[tuple[float, float]] = []
        for share in np.linspace(0.0, 1.0, n + 1):
            size = ((1.0 - share) * load.sizes[0] + share * load.sizes[1]) / largest
            tall, side = SPREAD * self.u * abs(size), 1.0 if size >= 0 else -1.0
            tails.append((share, side * (near + tall)))
            if tall < 0.2 * self.u:
                continue
            head, half = min(0.7 * self.u, 0.6 * tall), 0.28 * self.u / length
            yield line([(share, side * (near + head)), tails[-1]], "load line")
            tip = [(share, side * near), *((share + way, side * (near + head)) for way in (-half, half))]
            yield line(tip, "load tip", is_closed=True)
        yield line(tails, "load line")

    def _joints(self) -> Iterator[Path]:
        """A small circle where bodies turn about each other, a square where they do not."""
        squares = [second for _first, second in self.scene.welds]
        circles = [first for first, _second in self.scene.pins] + [place for rod in self.scene.rods for place in rod]
        circles += [rail.point for rail in self.scene.rails if rail.turning != "not"]
        circles += [groove.point for groove in self.scene.grooves] + [roller.center for roller in self.scene.rollers]
        dots = {f.mass_center for f in self.scene.figures if f.is_particle}
        size = 0.4 * self.u
        for place in dict.fromkeys(squares):
            if place not in dots:
                yield Path(place, place.body, box(size, size), "joint", True)
        for place in dict.fromkeys(circles):
            if place not in dots:
                yield Path(place, place.body, circle(size), "joint", True)

    def _coil(self, body: Place, base: Place, *, is_spring: bool) -> Iterator[Path]:
        """A spiral or a rotary damper about the pin of two bodies, else about the middle of the one."""
        pins = (pair for pin in self.scene.pins for pair in (pin, pin[::-1]))
        at = next((a for a, b in pins if (a.body, b.body) == (body.body, base.body)), body)
        for line in (spiral(self.u),) if is_spring else vane(self.u):
            yield Path(at, base.body, line, "spring")

    def _shoe(self, first: Place, second: Place) -> Iterator[Path]:
        """A block on the rim of a round body, or about the middle of another one; hatched where it stands still."""
        place, other, rim = first, second, None
        for a, b in ((first, second), (second, first)):
            figure = self.scene.figure_of(a.body)
            if rim is None and figure is not None and figure.radius is not None:
                place, other, rim = a, b, figure.radius
        level = (rim or 0.0) + 0.45 * self.u
        yield Path(place, other.body, box(1.2 * self.u, 0.45 * self.u) + np.array((0.0, level)), "shoe", True)
        if other.body == GROUND:
            strokes = hatched(-1.2 * self.u, 1.2 * self.u, 0.75 * self.u, 0.6 * self.u)
            yield Path(place, GROUND, strokes + np.array((0.0, level + 0.45 * self.u)), "hatch")

    # -- words --------------------------------------------------------------------------------
    def words(self) -> Iterator[Caption]:
        """What has no sign, as it is written."""
        for n, sign in enumerate(sign for sign in self.scene.signs if isinstance(sign, glyphs.Equation)):
            yield Caption(sign.at, equation(sign.text).text, 1.2, -3.4 - 1.8 * n)
