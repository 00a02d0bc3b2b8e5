"""A picture of a motion in space, ready for any canvas: pieces, names, and what the picture has to hold."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

import numpy as np

from freebody.model.glyphs import Belt, Coil, Equation, Face, MomentArrow, Shoe, Surface, Toothed, Track, Wheels
from freebody.present.corner import round_length
from freebody.present.figures import Array, Heading, Place, Triple, box_round, places_in
from freebody.present.scene import Scene
from freebody.present.space.bodies import body_pieces, convex
from freebody.present.space.cuts import Cuts
from freebody.present.space.figures import Poses, poses_of
from freebody.present.space.joints import Joints
from freebody.present.space.loads import Loads
from freebody.present.space.pieces import Piece
from freebody.present.space.shells import Shells
from freebody.present.space.solids import basis, plate
from freebody.present.space.stands import Stands
from freebody.present.view import AZIMUTH, ELEVATION, STRENGTH, View

_SYMBOL = 0.026  # of the size of a scene
_ROOM = 0.2  # [m] to each side of a scene without size, beside which signs are small
_SEEN = 0.55  # the share of it that a picture shows at least
_BELOW = 0.35  # a plane reaches so far on either side, by how far bodies are above it
_TINY = 1e-9  # [m] a scene of less has no lengths at all
_N_KEYS = 40

Sheet = tuple[Place, Heading]  # a point and the normal of a plane


@dataclass(frozen=True)
class SpatialDrawing:
    """A scene on its way. symbol: [m] the size of symbols; low, high: (3,) [m] corners of a box round the motion."""

    scene: Scene
    poses: Poses
    symbol: float
    low: Array
    high: Array
    pieces: list[Piece] = field(default_factory=list[Piece])
    has_lengths: bool = True  # or all of them are made up
    room: Array = field(default_factory=lambda: np.zeros((0, 3)))  # [m] points round a lone particle, which has no size

    @classmethod
    def of(cls, scene: Scene, centers: Array, axes: Array) -> SpatialDrawing:
        """centers: (n_times, n_moving, 3) [m] of mass centres; axes: (n_times, n_moving, 3, 3), whose columns are the
        axes of the bodies, in the order of `scene.names`."""
        poses = poses_of(scene, np.asarray(centers, dtype=np.float64), np.asarray(axes, dtype=np.float64))
        low, high = _extent(scene, poses)
        size = _size(low, high)
        shells = Shells(scene, poses, size)
        for form in shells.forms.values():
            least, most = box_round(poses.centers[:, form.index])
            low, high = np.minimum(low, least - shells.radius), np.maximum(high, most + shells.radius)
        room = np.zeros((0, 3))
        if float(np.linalg.norm(high - low)) <= _TINY:
            low, high = low - _ROOM, high + _ROOM
            room = 0.5 * (low + high) + _SEEN * _ROOM * np.concatenate((np.eye(3), -np.eye(3)))
        u = _SYMBOL * float(np.linalg.norm(high - low))
        drawing = cls(scene, poses, u, low - u, high + u, has_lengths=size > 0.0, room=room)
        used = _used(scene)
        for form in scene.figures:
            if form.index in shells.forms:
                drawing.pieces.extend(shells.pieces(form, u))
                continue
            own = dict.fromkeys(place.at for place in used if place.body == form.index)
            drawing.pieces.extend(body_pieces(form, own, u, is_fixed=scene.is_fixed(form.index)))
        cuts, stands = Cuts(scene, poses, u), Stands(scene, poses, u)
        drawing.pieces.extend(Joints(scene, poses, u, cuts, stands, shells).pieces())
        drawing.pieces.extend(Loads(scene, poses, u, cuts, stands, shells).pieces())
        drawing._frame()
        sheets = [*scene.planes, *_flats(scene, poses)]
        drawing.pieces[:0] = [drawing._sheet(sheet) for sheet in _different(sheets, poses)]
        drawing._frame()
        return drawing

    @property
    def size(self) -> float:
        """[m] the diagonal of the box round the motion."""
        return float(np.linalg.norm(self.high - self.low))

    def view(self, angles: tuple[float, float] = (AZIMUTH, ELEVATION), *, perspective: bool = False) -> View:
        """A view of the middle of the motion from azimuth and elevation [deg]."""
        distance = STRENGTH * self.size if perspective else math.inf
        return View.of(self.scene.up, angles, (self.low + self.high) / 2, distance)

    def key_frames(self) -> Sequence[int]:
        """A few frames that stand for all."""
        n = self.poses.n_times
        return sorted({round(k * (n - 1) / _N_KEYS) for k in range(_N_KEYS + 1)})

    def bounds(self, view: View) -> tuple[Array, Array]:
        """(2,), (2,) [m] corners on paper of everything at any time."""
        seen = [view.seen(points) for points in self._points()]
        return box_round(np.concatenate(seen)[:, :2])

    def _points(self) -> Iterator[Array]:
        """(n, 3) [m] where pieces are, at the key frames."""
        yield self.room
        for piece in self.pieces:
            is_still = self.scene.is_fixed(piece.turn) and self.scene.is_fixed(piece.place.body) and piece.end is None
            for k in self.key_frames()[: 1 if is_still else None]:
                points, _lines = piece.placed(self.poses, k)
                yield points
                if piece.radius:
                    yield points + piece.radius * np.concatenate((np.eye(3), -np.eye(3)))

    def _frame(self) -> None:
        self.low[:], self.high[:] = box_round(np.concatenate([*self._points(), self.low[None], self.high[None]]))

    def _sheet(self, sheet: Sheet) -> Piece:
        """A plane as far as bodies move over it, with a grid of a round distance."""
        through, normal = sheet
        points = np.concatenate(list(self._points()))
        axes = basis(self.poses.heading(normal, 0))
        over = (points - self.poses.place(through, 0)) @ axes.T
        low, high = box_round(over[:, :2])
        middle, half = 0.5 * (low + high), 0.5 * (high - low)
        half = np.maximum(half, max(0.5 * float(half.max()), _BELOW * float(np.abs(over[:, 2]).max())))
        step = round_length((2.0 * float(half.max()) or self.size or 1.0) / 6)
        low, high = step * np.floor((middle - half) / step - 0.4), step * np.ceil((middle + half) / step + 0.4)
        corners = np.array([(low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1])])
        lines: list[Array] = []
        for k in (0, 1):
            for level in np.arange(low[k] + step, high[k] - 0.5 * step, step):
                line = np.zeros((2, 3))
                line[:, k], line[:, 1 - k] = level, (low[1 - k], high[1 - k])
                lines.append(line)
        body = normal.body
        back = axes @ self.poses.axes[0, body]
        flat = plate(np.column_stack((corners, np.zeros(4)))).moved(back)
        place = Place(body, *self.poses.back(body, self.poses.place(through, 0), 0))
        return Piece(flat, place, body, "plane", lines=tuple(line @ back for line in lines))


def shells_of(scene: Scene, poses: tuple[Array, Array]) -> Shells:
    """The bodies of a scene without extent. poses: (n_times, n_moving, 3) and (n_times, n_moving, 3, 3)."""
    every = poses_of(scene, *poses)
    return Shells(scene, every, _size(*_extent(scene, every)))


def _size(low: Array, high: Array) -> float:
    size = float(np.linalg.norm(high - low))
    return size if size > _TINY else 0.0


def _extent(scene: Scene, poses: Poses) -> tuple[Array, Array]:
    """(3,), (3,) corners of a box round all bodies and joined points on their way."""
    corners: list[Array] = [poses.way(place) for place in _used(scene)]
    for form in scene.figures:
        way = poses.centers[:, form.index]
        if form.solid.has_radius_from_center:
            middle = poses.way(form.center)
            corners += [middle + form.sizes[0] * s for s in (-1.0, 1.0)]
        solid = convex(form, 0.0)
        points = np.array([place.at for place in form.points.values()]) if solid is None else solid.points
        corners.append((way[:, None] + np.einsum("tij,nj->tni", poses.axes[:, form.index], points)).reshape(-1, 3))
    return box_round(np.concatenate(corners) if corners else np.zeros((1, 3)))


def _used(scene: Scene) -> list[Place]:
    """The places at which something is joined."""
    found: list[Place] = []
    for sign in scene.signs:
        match sign:
            case Face() | MomentArrow() | Coil() | Track() | Wheels() | Belt() | Toothed() | Equation() | Shoe():
                found += [sign.through, sign.point] if isinstance(sign, Face) and sign.turning != "rolls" else []
            case _:
                found += places_in(sign)
    return list(dict.fromkeys(found))


def _flats(scene: Scene, poses: Poses) -> Iterator[Sheet]:
    """The planes in which joints keep bodies, and those of lines that bodies of the plane roll on or touch."""
    for sign in scene.signs:
        match sign:
            case Face(through, _point, normal):
                yield through, normal
            case Surface(through, along):
                yield through, along.normal()
            case Track(center, along, radius):
                foot = poses.place(center, 0) - radius * poses.heading(along.normal(), 0)
                yield Place(along.body, *poses.back(along.body, foot, 0)), along.normal()
            case _:
                pass


def _different(sheets: Sequence[Sheet], poses: Poses) -> Iterator[Sheet]:
    """Each plane once."""
    seen: set[tuple[int, Triple, float]] = set()
    for through, heading in sheets:
        normal = poses.heading(heading, 0)
        x, y, z = (round(float(c), 6) + 0.0 for c in normal)
        key = heading.body, (x, y, z), round(float(normal @ poses.place(through, 0)), 6)
        if key not in seen:
            seen.add(key)
            yield through, heading
