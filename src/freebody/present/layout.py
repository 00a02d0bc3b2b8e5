"""Where things stand in the picture, if the model does not say.

A string with leads of constant direction fixes how far bodies travel, not where they hang. Such a body is drawn
moved, by the same amount at all times, so that its string runs straight off the pulley and stays visible.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

import numpy as np

from freebody.model import glyphs
from freebody.present.figures import (
    GROUND,
    Array,
    Figure,
    Heading,
    Node,
    Place,
    Rope,
    Tip,
    Wall,
    angles,
    box_round,
    positions,
    turned,
    with_ground,
)
from freebody.present.scene import Scene

_TO_SYMBOL = 0.02  # size of symbols by that of the picture
_SMALLEST, _ROUND_OFF = 1e-12, 1e-9  # size of a picture [m], and beside how far it is from the origin
_APART = 14.0  # bodies on one rail, in sizes of symbols
_SHORTEST = 5.0  # a lead, in sizes of symbols
_FARTHEST = 30.0  # a surface is in the picture that comes this near to what may touch it, in sizes of what moves
_STEEP = 0.3  # cosine of an incline onto which nothing is seen to fall
_PAST = 1.3  # an incline goes on past the place below what falls, by the way to it

_BESIDE = 1.8  # a surface reaches so far on either side of a round body, by its radius


@dataclass(frozen=True)
class Layout:
    """Poses as they are drawn (n_times, n_bodies, 3), the strings, and the size of symbols [m]."""

    poses: Array
    ropes: tuple[Rope, ...]
    symbol: float
    moved: tuple[str, ...]  # names of the bodies that are not drawn where they are
    apart: tuple[str, ...] = ()  # those of them that are drawn beside what stands where they do, on one rail

    @classmethod
    def of(cls, scene: Scene, poses: Array, symbol: float | None = None) -> Layout:
        """Puts the bodies of a scene where their strings lead them. symbol: [m] the size of symbols, by that of the
        picture if nothing is said."""
        settling = _Settling(scene, poses, symbol)
        for _ in scene.ropes:
            settling.hang()
        settling.mesh()
        apart = tuple(scene.names[k] for k in settling.spread())
        moved = tuple(n for n, s in zip(scene.names, settling.shifts, strict=True) if np.abs(s).max() > 1e-9)
        return cls(settling.poses, tuple(settling.ropes), symbol or _symbol(scene, settling.poses), moved, apart)


class _Settling:
    """Poses that are being shifted, and which bodies have their places already."""

    def __init__(self, scene: Scene, poses: Array, symbol: float | None = None) -> None:
        self.scene = scene
        self.poses = poses.copy()
        self.shifts = np.zeros((len(scene.names), 2))
        self.group = _groups(scene)
        self.ropes = [*scene.ropes, *_belts(scene)]
        self.shortest = _SHORTEST * (symbol or _symbol(scene, poses))
        self.settled = {self.group[k] for k in range(len(scene.names)) if not self._is_free(self.group[k])}

    def _is_free(self, group: int) -> bool:
        """Whether only strings and straight rails say where the bodies of a group are."""
        members = {k for k, g in enumerate(self.group) if g == group}
        scene = self.scene
        if any(f.has_place for f in scene.figures if f.index in members):
            return False
        if any({a, b} & members and GROUND in (a, b) for a, b in _pairs(scene)):
            return False
        if any(track.center.body in members and track.along.body == GROUND for track in scene.tracks):
            return False
        rails = [rail for rail in scene.rails if rail.point.body in members and rail.along.body == GROUND]
        return all(rail.turning == "not" for rail in rails) and bool(rails or scene.hanging & members)

    # -- strings ------------------------------------------------------------------------------
    def hang(self) -> None:
        """Moves what hangs on a string whose other end has its place, and ends of strings on the ground."""
        for i, rope in enumerate(self.ropes):
            for k, lead in enumerate(rope.leads):
                heading = lead.along
                if heading is None or heading.body != GROUND:
                    continue
                a, b = rope.nodes[k], rope.nodes[k + 1]
                if self._has_place(a) and not self._has_place(b):
                    self._move(b, self._shift(heading, a, b), heading)
                elif self._has_place(b) and not self._has_place(a):
                    self._move(a, -self._shift(heading, a, b), heading)
                elif self._has_place(a) and self._has_place(b):
                    rope = self._with_end(rope, k, heading)
                    self.ropes[i] = rope

    def _has_place(self, node: Node) -> bool:
        return node.place.body == GROUND or self.group[node.place.body] in self.settled

    def _shift(self, heading: Heading, a: Node, b: Node) -> Array:
        """(2,) what moves the end of a lead onto its line and makes it long enough, along and across."""
        e = np.array([heading.x, heading.y])
        n = np.array([-heading.y, heading.x])
        lead = positions(self.poses, b.place) - positions(self.poses, a.place) - (b.arm - a.arm) * n
        wanted = max(self.shortest, 1.5 * max(abs(a.arm), abs(b.arm)), 1.25 * (self._reach(a) + self._reach(b)))
        return (wanted - float((lead @ e).min())) * e - float((lead @ n)[0]) * n

    def _reach(self, node: Node) -> float:
        """[m] the radius of the round body in whose middle a string ends, or round which it runs."""
        figures = (f for f in self.scene.figures if f.center == node.place and f.index != GROUND)
        return max((f.radius or 0.0 for f in figures), default=0.0)

    def _move(self, node: Node, shift: Array, heading: Heading) -> None:
        group = self.group[node.place.body]
        members = [k for k, g in enumerate(self.group) if g == group]
        rails = [rail.along for rail in self.scene.rails if rail.point.body in members]
        rails += [track.along for track in self.scene.tracks if track.center.body in members]
        if any(abs(along.x * heading.y - along.y * heading.x) > 1e-9 for along in rails):
            return  # it would leave the direction of its rail
        self.shifts[members] += shift
        self.poses[:, members, :2] += shift
        self.settled.add(group)

    def _with_end(self, rope: Rope, k: int, heading: Heading) -> Rope:
        """The rope with its end on the ground moved onto the line of the lead."""
        e, n = np.array([heading.x, heading.y]), np.array([-heading.y, heading.x])
        nodes = list(rope.nodes)
        for j, other, sign in ((k, k + 1, 1), (k + 1, k, -1)):
            node = nodes[j]
            if j not in (0, len(nodes) - 1) or node.place.body != GROUND or node.arm:
                continue
            lead = positions(self.poses, nodes[other].place) - positions(self.poses, node.place)
            across = float((lead @ n)[0]) - nodes[other].arm
            short = min(0.0, float((sign * (lead @ e)).min()) - self.shortest)
            x, y = np.array(node.place.xy) + across * n + sign * short * e
            nodes[j] = replace(node, place=Place(GROUND, float(x), float(y)))
            break
        return replace(rope, nodes=tuple(nodes))

    # -- racks --------------------------------------------------------------------------------
    def mesh(self) -> None:
        """Moves a body that slides without a stated place, so that its edge lies where a wheel rolls on it."""
        for track in self.scene.tracks:
            rack = track.along.body
            if not track.radius or rack == GROUND or self.group[rack] in self.settled:
                continue
            figure = next(f for f in self.scene.figures if f.index == rack)
            across = np.array(track.along.normal().xy)
            edge = (figure.outline @ across) * np.sign(track.radius)
            center = positions(self.poses, track.center)[0] - self.poses[0, rack, :2]
            n = turned(self.poses[0, rack, 2], *across)
            gap = float(center @ n) - track.radius - np.sign(track.radius) * float(edge.max())
            members = [k for k, g in enumerate(self.group) if g == self.group[rack]]
            self.shifts[members] += gap * n
            self.poses[:, members, :2] += gap * n
            self.settled.add(self.group[rack])

    # -- bodies on one rail -------------------------------------------------------------------
    def spread(self) -> Iterator[int]:
        """Moves bodies apart along their rail that only it places, and that begin in one point; those that moved."""
        straight = (rail for rail in self.scene.rails if rail.turning == "not" and rail.along.body == GROUND)
        rails = {rail.point.body: rail.along for rail in straight}
        free = [k for k in rails if k != GROUND and self.group[k] not in self.settled]
        span = float(np.ptp(self.poses[:, free, :2], axis=0).max(initial=0.0)) if free else 0.0
        step = max(_APART * self.shortest / _SHORTEST, span)
        taken: list[tuple[Array, int]] = []
        for k in free:
            place = self.poses[0, k, :2].copy()
            n = sum(np.hypot(*(place - other)) < 1e-9 + 0.01 * step for other, _k in taken)
            taken.append((place, k))
            if n:
                shift = n * step * np.array(rails[k].xy)
                members = [j for j, group in enumerate(self.group) if group == self.group[k]]
                self.shifts[members] += shift
                self.poses[:, members, :2] += shift
                yield from members


def _groups(scene: Scene) -> list[int]:
    """Which moving bodies keep together by pins, links and contacts: the least index of their group."""
    group = list(range(len(scene.names)))
    rails = ((rail.point.body, rail.along.body) for rail in scene.rails)
    for a, b in (*_pairs(scene), *rails):
        if GROUND not in (a, b):
            low, high = sorted((group[a], group[b]))
            group = [low if g == high else g for g in group]
    return group


def _pairs(scene: Scene) -> Iterator[tuple[int, int]]:
    """Bodies that pins, rods, wheels and contacts keep together."""
    yield from ((a.body, b.body) for a, b in scene.joined())
    yield from ((c.first.body, c.second.body) for c in (*scene.wheels, *scene.belts))
    yield from scene.touching


def _belts(scene: Scene) -> Iterator[Rope]:
    """The ropes that belts are: round both circles and back."""
    for belt in scene.belts:
        r1, r2 = belt.radii
        first, second = glyphs.Node(belt.first, r1), glyphs.Node(belt.second, -r2 if belt.is_crossed else r2)
        free = glyphs.Lead[Heading](None)
        yield glyphs.Rope((first, second, first), (free, free), is_closed=True)


def _symbol(scene: Scene, poses: Array) -> float:
    low, high = bounds(scene, poses)
    size, far = float((high - low).max()), float(np.abs([low, high]).max())
    # what is left where a particle rests is round-off, and no size
    return _TO_SYMBOL * (size if size > _SMALLEST + _ROUND_OFF * far else 1.0)


def bounds(scene: Scene, poses: Array) -> tuple[Array, Array]:
    """(2,), (2,) [m] lower left and upper right corner of everything on the whole way."""
    round_ones = [(f.center, f.radius or 0.0) for f in scene.figures]
    round_ones += [(s.center, s.radius) for s in (*scene.grooves, *scene.rollers)]
    reach = {(center, sign * radius) for center, radius in round_ones for sign in (-1.0, 1.0)}
    for figure in scene.figures:
        reach.update((place, 0.0) for place in figure.points.values())
        reach.update((place, 0.0) for edge in figure.edges for place in edge.places)
    ends = [*((s.first, s.second) for s in scene.springs), *scene.pins, *scene.welds, *scene.rods]
    reach.update((place, 0.0) for pair in ends for place in pair)
    reach.update((node.place, 0.0) for rope in scene.ropes for node in rope.nodes)
    reach.update((at, 0.0) for s in scene.signs if isinstance(s, glyphs.Relation) for at in s.points)
    everything = _ways(poses, reach) if reach else np.zeros((1, 2))
    low, high = box_round(everything)
    feet = list(_feet(scene, poses, float((high - low).max())))
    return box_round(np.concatenate([low[None], high[None], *feet]))


def _ways(poses: Array, reach: Iterable[tuple[Place, float]]) -> Array:
    """(n, 2) [m] places on the whole way, each moved by a length along both axes."""
    x, y, more = np.array([(place.x, place.y, more) for place, more in reach]).T
    of = with_ground(poses)[:, [place.body for place, _more in reach]]
    return ((of[..., :2] + turned(of[..., 2], x, y)) + more[:, None]).reshape(-1, 2)


def _feet(scene: Scene, poses: Array, size: float) -> Iterator[Array]:
    """(n, 2) [m] where bodies come nearest to endless surfaces, unless that is far from all that moves; on inclined
    ones as far beside it as a round body needs to be seen to lie on a line longer than itself, and on as far as what is
    above them may fall."""
    for wall in scene.walls:
        for tip in wall.tips if wall.is_endless else ():
            s, gap = along_wall(wall, tip, poses)
            k = int(np.abs(gap).argmin())
            if abs(gap[k]) < _FARTHEST * size:
                is_inclined = min(abs(wall.along.x), abs(wall.along.y)) > 1e-9
                beside = np.array((-1.0, 0.0, 1.0)) * _BESIDE * tip.radius * is_inclined
                if is_inclined and gap[k] > 1e-6 * size and abs(wall.along.x) > _STEEP:
                    away = float(gap[k]) + tip.radius
                    beside = np.append(beside, -_PAST * away * wall.along.y / wall.along.x)
                yield np.array([wall.through.xy]) + (s[k] + beside)[:, None] * np.array(wall.along.xy)


def headings(rope: Rope, poses: Array) -> Array:
    """(n_times, n_leads) [rad] direction of each lead, continuous in time.

    A lead without a constant direction is the common tangent of two circles, d = l e(a) + rho n(a), so
    a = angle of d - asin(rho/|d|); inside each other's reach circles have none, and the line of centres is taken."""
    found: list[Array] = []
    for a, b, lead in zip(rope.nodes, rope.nodes[1:], rope.leads, strict=False):
        heading = lead.along
        line = positions(poses, b.place) - positions(poses, a.place)
        if heading is not None:
            line = line - (b.arm - a.arm) * turned(angles(poses, heading) + np.pi / 2, 1.0, 0.0)
            far = np.hypot(line[:, 0], line[:, 1]) > 1e-9
            found.append(np.where(far, np.arctan2(line[:, 1], line[:, 0]), angles(poses, heading)))
            continue
        length = np.hypot(line[:, 0], line[:, 1])
        share = np.divide(b.arm - a.arm, length, out=np.zeros_like(length), where=length > abs(b.arm - a.arm))
        found.append(np.arctan2(line[:, 1], line[:, 0]) - np.arcsin(share))
    return np.unwrap(np.array(found).T, axis=0)


def sweep(arm: float, before: Array | float, after: Array | float) -> Array:
    """[rad] how far a string runs round a circle between two leads, in the sense of its arm. Leads that have swung
    a little past each other run round by nothing."""
    sense = np.sign(arm)
    around = np.mod(sense * (np.asarray(after) - np.asarray(before)), 2 * np.pi)
    return sense * np.where(around > 1.8 * np.pi, 0.0, around)


def placed_in(poses: Array, body: int, place: Place) -> Array:
    """(n_times, 2) [m] of a place on the way, by components in a body (from its mass centre)."""
    at = positions(poses, place)
    if body == GROUND:
        return at
    pose = poses[:, body]
    c, s = np.cos(pose[:, 2]), np.sin(pose[:, 2])
    d = at - pose[:, :2]
    return np.stack((c * d[:, 0] + s * d[:, 1], -s * d[:, 0] + c * d[:, 1]), axis=-1)


def travel(point: Place, heading: Heading, poses: Array) -> tuple[Array, Array]:
    """(n_times,), (n_times,) [m]: how far a guided point is along its line and to the left of it, by components in the
    body of the line (from its mass centre)."""
    at = placed_in(poses, heading.body, point)
    along = np.array(heading.xy)
    return at @ along, at @ np.array([-along[1], along[0]])


def along_wall(wall: Wall, tip: Tip, poses: Array) -> tuple[Array, Array]:
    """(n_times,), (n_times,) [m]: how far a tip is along a surface, and the gap between them."""
    away = placed_in(poses, wall.through.body, tip.place) - np.array(wall.through.xy)
    return away @ np.array(wall.along.xy), away @ np.array(wall.along.normal().xy) - tip.radius


def extent_across(figure: Figure, point: Place, along: Heading, poses: Array) -> tuple[float, float]:
    """[m] how far a body reaches to the right and to the left of its guided point, across the guide at the start."""
    n = turned(float(angles(poses, along)[0]) + np.pi / 2, 1.0, 0.0)
    at = positions(poses, point)[0]
    reach = [float((positions(poses, p)[0] - at) @ n) for p in figure.points.values()]
    return min(reach, default=0.0), max(reach, default=0.0)
