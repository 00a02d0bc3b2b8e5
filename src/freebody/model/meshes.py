"""Triangulated bodies: a file of triangles beside the model, read by trimesh, as exact numbers in SI.

trimesh reads the formats and integrates over the volume by the divergence theorem; what the symbolic route gets are
decimals of it, and no arrays. The mesh is moved to its middle and divided by its size first, so that no digits are lost
where it lies far from the origin of its file, and so that what is small there is not small in itself.
Source of the integrals: Eberly, Polyhedral mass properties (revisited), 2002, as trimesh has them.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache, partial
from importlib import import_module
from io import BytesIO
from typing import TYPE_CHECKING, Any, TypeVar, cast
from warnings import catch_warnings, simplefilter

from freebody.language.sentences import Message
from freebody.model.hulls import MOST_POINTS, faces_of_hull, outline_of_hull
from freebody.model.silhouettes import is_hole, silhouette
from freebody.model.tables import bytes_beside

if TYPE_CHECKING:
    from freebody.model.names import Names

FORMATS = (".stl", ".obj", ".ply", ".off")
MOST_BYTES = 50_000_000
MOST_DRAWN = 1300  # triangles of a picture
_FLAT = 1e-12  # of the third power of the size: volumes that are none
_ALIKE = 1e-6  # relative: what single precision leaves of flat faces and of convexity
_DIGITS = 13  # of the largest of numbers of one kind: what is left of double precision in sums over triangles
_SIMPLE = 9999  # the largest divisor of a fraction that is seen in rounded digits
_LUCK = 3  # digits: one number in a thousand may be near a simple fraction by chance
_N_DIRECTIONS = 160  # of the corners that stand for a finer mesh in pictures
_GOLDEN = math.pi * (3.0 - math.sqrt(5.0))

Exact = tuple[Fraction, Fraction, Fraction]
Flat = tuple[Fraction, Fraction]
Found = TypeVar("Found")
Triangle = tuple[int, ...]


@dataclass(frozen=True)
class Triangulated:
    """A homogeneous body, from the origin of its file. volume: [m^3]; center: [m] its mass centre; spread: [m^2] the
    inertia tensor about that by the mass: xx, yy, zz, xy, xz, yz; hull: [m] the corners of its convex hull, and its
    faces by the numbers of their corners, both empty where there are more than contacts can have; drawn: [m] the
    triangles of pictures."""

    volume: Fraction
    center: Exact
    spread: tuple[Fraction, ...]
    is_convex: bool
    hull: tuple[tuple[Exact, ...], tuple[tuple[int, ...], ...]]
    drawn: tuple[tuple[Exact, ...], ...]
    is_drawn_coarsely: bool


@dataclass(frozen=True)
class Silhouette:
    """A homogeneous body in the plane that its normal axis leaves, from the origin of its file. volume: [m^3]; center:
    [m]; spread: [m^2] the moment of inertia about the mass centre by the mass; hull: [m] the corners of its convex
    hull, empty where there are more than contacts can have; drawn: [m] the edges of areas and holes; leans: whether
    turning about the normal alone takes moments from outside."""

    volume: Fraction
    center: Flat
    spread: Fraction
    hull: tuple[Flat, ...]
    drawn: tuple[tuple[tuple[Flat, ...], bool], ...]
    leans: bool


def read_mesh(names: Names, file: str, unit: Fraction) -> Triangulated | None:
    """The body in a file of the folder of the model; None with a problem noted at `file`. unit: [m] of the file."""
    return _found(names, file, lambda data: _measured(file, data, unit))


def read_silhouette(names: Names, file: str, unit: Fraction, normal: int) -> Silhouette | None:
    """The same, as it is seen against the axis of the file with this number."""
    return _found(names, file, lambda data: _seen(file, data, unit, normal))


def _found(names: Names, file: str, read: Callable[[bytes], Found]) -> Found | None:
    data = bytes_beside(names, file, "file", MOST_BYTES)
    if data is None:
        return None
    try:
        return read(data)
    except ValueError as error:
        names.problem(error.args[0], "file")
        return None


@dataclass(frozen=True)
class _Closed:
    """A closed surface about the middle of its file, by its size. mesh: trimesh's; scale: [unit of the file]"""

    mesh: Any
    volume: float
    middle: list[float]
    scale: Fraction

    def place(self, v: Sequence[float], unit: Fraction) -> Exact:
        """[m], rounded in the unit of the file, in which its numbers are short."""
        scale = self.scale
        x, y, z = (
            _rounded(Fraction(m) + scale * Fraction(c), float(scale)) for m, c in zip(self.middle, v, strict=True)
        )
        return x * unit, y * unit, z * unit

    def measured(self, unit: Fraction) -> tuple[Fraction, Exact, tuple[Fraction, ...]]:
        """Volume, mass centre and inertia tensor as `Triangulated` has them."""
        rows, scale = self.mesh.moment_inertia.tolist(), self.scale
        places = ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))
        spread = [Fraction(rows[i][j] / self.volume) * scale**2 for i, j in places]
        largest = float(max(map(abs, spread)))
        volume = _rounded(Fraction(self.volume) * scale**3, self.volume * float(scale) ** 3)
        center = self.place(self.mesh.center_mass.tolist(), unit)
        return volume * unit**3, center, tuple(_rounded(s, largest) * unit**2 for s in spread)


def _closed(file: str, data: bytes) -> _Closed:
    """Raises ValueError with a Message for what is no closed surface."""
    trimesh = _library()
    given = _loaded(trimesh, file, data)
    low, high = given.bounds.tolist()
    size = max(b - a for a, b in zip(low, high, strict=True))
    if size <= 0.0:
        raise ValueError(Message("{file}: all its triangles are at one point", file=file))
    middle, scale = [0.5 * (a + b) for a, b in zip(low, high, strict=True)], 2.0 ** math.ceil(math.log2(size))
    mesh = trimesh.Trimesh((given.vertices - middle) / scale, given.faces, process=False)
    mesh.merge_vertices()
    a, b, c = mesh.faces.T
    mesh.update_faces((a != b) & (b != c) & (c != a))
    _check_closed(file, mesh, middle, scale)
    with catch_warnings():
        simplefilter("ignore")  # it divides by the volume
        volume = float(mesh.volume)
    if volume <= _FLAT:
        told = Message("{file}: it has no volume", file=file)
        if volume < -_FLAT:
            told = Message(
                "{file}: its triangles go clockwise as seen from outside, so its volume is negative: turn the "
                "order of their corners round",
                file=file,
            )
        raise ValueError(told)
    return _Closed(mesh, volume, middle, Fraction(scale))


def _library() -> Any:
    try:
        return import_module("trimesh")
    except ModuleNotFoundError:
        raise ValueError(Message('meshes are read by trimesh; pip install "freebody[mesh]"')) from None


def _loaded(trimesh: Any, file: str, data: bytes) -> Any:
    """The mesh as it stands in the file."""
    suffix = file[file.rfind(".") :].lower() if "." in file else ""
    if suffix not in FORMATS:
        told = Message("{file}: a mesh is one of {names}", file=file, names=", ".join(FORMATS))
        raise ValueError(told)
    try:
        found = trimesh.load_mesh(BytesIO(data), file_type=suffix[1:], process=False)
        n_triangles = len(found.faces)
        is_finite = all(map(math.isfinite, found.bounds.ravel().tolist())) if n_triangles else True
    except Exception as error:  # a library's readers fail in any way on what is no such file
        told = Message("{file} is no {format} file that can be read: {why}", file=file, format=suffix[1:], why=error)
        raise ValueError(told) from error
    if not n_triangles:
        raise ValueError(Message("{file}: there are no triangles in it", file=file))
    if not is_finite:
        raise ValueError(Message("{file}: some of its coordinates are no numbers", file=file))
    return found


def _check_closed(file: str, mesh: Any, middle: list[float], scale: float) -> None:
    """Each edge belongs to two triangles, which go along it in opposite directions."""
    way = [tuple(edge) for edge in mesh.edges.tolist()]
    n_of = Counter((min(edge), max(edge)) for edge in way)
    directed = Counter(way)

    def place(k: int) -> str:
        found = [m + scale * c for m, c in zip(middle, mesh.vertices[k].tolist(), strict=True)]
        return f"({', '.join(f'{c:.6g}' for c in found)})"

    if open_ := [edge for edge, n in n_of.items() if n != 2]:
        told = Message(
            "{file} is not closed: {n} edges belong to one triangle alone, or to more than two; the first goes from "
            "{start} to {end}",
            file=file,
            n=len(open_),
            start=place(open_[0][0]),
            end=place(open_[0][1]),
        )
        raise ValueError(told)
    if turned := [edge for edge, n in directed.items() if n != 1]:
        told = Message(
            "{file}: neighbouring triangles go round in different senses, {n} times; the first time along the edge "
            "from {start} to {end}. Let all go counter-clockwise as seen from outside",
            file=file,
            n=len(turned),
            start=place(turned[0][0]),
            end=place(turned[0][1]),
        )
        raise ValueError(told)


@lru_cache(maxsize=4)  # a sweep reads its model again and again
def _measured(file: str, data: bytes, unit: Fraction) -> Triangulated:
    closed = _closed(file, data)
    mesh = closed.mesh
    hull = mesh.convex_hull
    is_convex = float(hull.volume) - closed.volume <= _ALIKE * closed.volume
    is_coarse = len(mesh.faces) > MOST_DRAWN
    seen = _coarse(mesh) if is_coarse else mesh
    places = [closed.place(v, unit) for v in seen.vertices.tolist()]
    triangles = cast("list[Triangle]", seen.faces.tolist())
    return Triangulated(
        *closed.measured(unit),
        is_convex,
        _hull_of([tuple(v) for v in hull.vertices.tolist()], partial(closed.place, unit=unit)),
        tuple(tuple(places[k] for k in triangle) for triangle in triangles),
        is_coarse,
    )


@lru_cache(maxsize=4)
def _seen(file: str, data: bytes, unit: Fraction, normal: int) -> Silhouette:
    closed = _closed(file, data)
    axes = [(normal + k) % 3 for k in (1, 2, 3)]
    volume, center, spread = closed.measured(unit)
    corners = [[v[k] for k in axes] for v in closed.mesh.vertices.tolist()]
    places = [[closed.place(v, unit)[k] for k in axes[:2]] for v in closed.mesh.vertices.tolist()]

    def flat(loop: Iterable[int]) -> tuple[Flat, ...]:
        return tuple((places[k][0], places[k][1]) for k in loop)

    loops = silhouette(corners, closed.mesh.faces.tolist())
    hull = outline_of_hull([(x, y, 0.0) for x, y, _z in corners], _ALIKE)
    crossed = [spread[3 + i + j - 1] for i, j in (sorted((normal, other)) for other in axes[:2])]
    return Silhouette(
        volume,
        (center[axes[0]], center[axes[1]]),
        spread[normal],
        flat(hull) if len(hull) <= MOST_POINTS else (),
        tuple((flat(loop), is_hole([(corners[k][0], corners[k][1]) for k in loop])) for loop in loops),
        any(crossed),
    )


def _hull_of(corners: list[Any], place: Any) -> tuple[tuple[Exact, ...], tuple[tuple[int, ...], ...]]:
    if len(corners) > MOST_POINTS:
        return (), ()
    faces = faces_of_hull(corners, _ALIKE)
    return tuple(place(list(corner)) for corner in corners), tuple(faces)


def _coarse(mesh: Any) -> Any:
    """The hull of the corners that are the outermost ones in directions all round (a Fibonacci lattice)."""
    kept: list[int] = []
    for k in range(_N_DIRECTIONS):
        z = 1.0 - (2 * k + 1) / _N_DIRECTIONS
        r = math.sqrt(1.0 - z * z)
        kept.append(int((mesh.vertices @ (r * math.cos(k * _GOLDEN), r * math.sin(k * _GOLDEN), z)).argmax()))
    return type(mesh)(mesh.vertices[sorted(set(kept))], process=False).convex_hull


def _rounded(value: Fraction, largest: float) -> Fraction:
    """To the digits that numbers of this size have: what is zero but for rounding becomes zero, and what is a simple
    fraction but for rounding becomes that: 2/3 of a cube, not 0.6666666666667."""
    n_decimals = _DIGITS - math.ceil(math.log10(largest))
    rounded = round(value, n_decimals)
    # there are some d^2 fractions with divisors up to d in every unit: so few that none is near by chance
    largest_divisor = min(_SIMPLE, max(1, math.isqrt(10 ** max(0, n_decimals - _LUCK))))
    simple = rounded.limit_denominator(largest_divisor)
    return simple if abs(simple - rounded) < Fraction(1, 10) ** n_decimals else rounded
