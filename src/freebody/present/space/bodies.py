"""Bodies as pieces: their solids, or lines from their reference points through their named points."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Collection, Iterator
from dataclasses import replace
from itertools import pairwise

import numpy as np

from freebody.model import solids
from freebody.model.solids import SolidKind
from freebody.present.figures import Array, Figure, Place, Triple
from freebody.present.space.meshes import is_on_hull, mesh_hull, surface
from freebody.present.space.pieces import Piece, ball
from freebody.present.space.solids import (
    Solid,
    band,
    basis,
    box,
    marked,
    marked_cone,
    plate,
    prism,
    tube,
    turned_on_axis,
)
from freebody.present.space.solids import (
    solid as make_solid,
)

THIN = 0.045  # half the thickness of a disk by its radius
HOOP = (0.07, 0.035)  # half the width and half the depth of a ring by its radius
GEAR = 0.08  # that of a gear wheel
_N_TEETH = 32
_N_RINGS = 8  # of half a ball


def convex(form: Figure, u: float) -> Solid | None:
    """The solid of a body about its mass centre, for what is convex and no ball; u: [m] the size of symbols."""
    build = _CONVEX.get(form.solid)
    return None if build is None else build(form, u)


def _box(form: Figure, u: float) -> Solid:
    thick = min(form.sizes) > 0.0
    return (box(*form.sizes) if thick else plate(_middle_sheet(form.sizes))).moved(np.eye(3), form.center.at)


def _convex(form: Figure, u: float) -> Solid:
    corners = list(dict.fromkeys(itertools.chain(*form.faces)))
    return make_solid(
        np.array([corner.at for corner in corners]),
        [tuple(corners.index(corner) for corner in face) for face in form.faces],
    )


def _mesh(form: Figure, u: float) -> Solid:
    """Its convex hull; the whole of it, where it is convex."""
    return mesh_hull(_triangles(form))


def _triangles(form: Figure) -> Array:
    """(n, 3, 3) the corners of triangles."""
    return np.array([[place.at for place in edge.places] for edge in form.edges])


def _plate(form: Figure, u: float) -> Solid | None:
    corners = form.edges[0].places if form.edges else form.corners
    if form.edges and form.edges[0].look == "wire":
        return None
    return plate(np.array([corner.at for corner in corners])) if len(corners) > 2 else None


def _cylinder(form: Figure, u: float) -> Solid:
    radius, length = form.sizes
    return marked(prism(radius, -0.5 * length, 0.5 * length)).moved(_own_axes(form), form.center.at)


def _cone(form: Figure, u: float) -> Solid:
    return marked_cone(*form.sizes).moved(_own_axes(form), form.center.at)


def _frustum(form: Figure, u: float) -> Solid:
    base, top, height = form.sizes
    return turned_on_axis(((base, 0.0), (top, height))).moved(_own_axes(form), form.center.at)


def _dome(form: Figure, u: float) -> Solid:
    (radius,) = form.sizes
    heights = np.linspace(0.0, 0.5 * np.pi, _N_RINGS, endpoint=False)
    profile = [(radius * float(np.cos(a)), radius * float(np.sin(a))) for a in heights]
    return turned_on_axis((*profile, (0.02 * radius, radius))).moved(basis((1.0, 0.0, 0.0)), form.center.at)


def _ellipsoid(form: Figure, u: float) -> Solid:
    heights = np.linspace(-0.5 * np.pi, 0.5 * np.pi, 2 * _N_RINGS + 1)
    unit = turned_on_axis(tuple((max(float(np.cos(a)), 0.02), float(np.sin(a))) for a in heights))
    return unit.moved(np.diag(form.sizes), form.center.at)


def _disk(form: Figure, u: float) -> Solid:
    """Thin; with teeth where it is a gear wheel."""
    (radius,) = form.sizes
    half = (GEAR if form.is_toothed else THIN) * radius
    rim = prism(radius, -half, half)
    return marked(rim, _N_TEETH if form.is_toothed else 1).moved(_own_axes(form), form.center.at)


def _rod(form: Figure, u: float) -> Solid:
    """Along its own x axis, thin beside its length and beside symbols."""
    (length,) = form.sizes
    radius = min(0.55 * u, 0.1 * length)
    return prism(radius, -0.5 * length, 0.5 * length, 12).moved(basis((1.0, 0.0, 0.0)), form.center.at)


_CONVEX: dict[SolidKind, Callable[[Figure, float], Solid | None]] = {
    solids.BOX: _box,
    solids.CONVEX: _convex,
    solids.MESH: _mesh,
    solids.HOLLOWED_MESH: _mesh,
    solids.PLATE: _plate,
    solids.CYLINDER: _cylinder,
    solids.CONE: _cone,
    solids.FRUSTUM: _frustum,
    solids.DOME: _dome,
    solids.ELLIPSOID: _ellipsoid,
    solids.DISK: _disk,
    solids.ROD: _rod,
}


def _own_axes(form: Figure) -> Array:
    """(3, 3) with the axis of a round body as the third."""
    return basis(form.axis or (0.0, 0.0, 1.0))


def _middle_sheet(sizes: tuple[float, ...]) -> Array:
    """(4, 3) the corners of a box one side of which is zero."""
    thin = int(np.argmin(sizes))
    i, j = sorted(((thin + 1) % 3, (thin + 2) % 3))
    corners = np.zeros((4, 3))
    corners[:, i] = 0.5 * sizes[i] * np.array((-1, 1, 1, -1))
    corners[:, j] = 0.5 * sizes[j] * np.array((-1, -1, 1, 1))
    return corners


def reach(form: Figure) -> float:
    """[m] how far a body goes from its mass centre at most, by its solid and its points."""
    solid = convex(form, 0.0)
    far = max((float(np.linalg.norm(p.at)) for p in form.points.values()), default=0.0)
    far = max([far, *(float(np.linalg.norm(part.at)) + reach(part.form) for part in form.parts)])
    if solid is not None:
        far = max(far, float(np.linalg.norm(solid.points, axis=1).max()))
    if form.solid.has_radius_from_center:
        far = max(far, float(np.linalg.norm(form.center.at)) + form.sizes[0])
    return far


def body_pieces(form: Figure, used: Collection[Triple], u: float, *, is_fixed: bool) -> Iterator[Piece]:
    """used: the points of the body at which something is joined to it."""
    look, color = ("fixed body", -1) if is_fixed else ("body", form.number)
    middle = Place(form.index, 0.0, 0.0, 0.0)
    solid = convex(form, u)
    if form.parts:
        yield from _composed(form, u, look, color, is_fixed=is_fixed)
    elif form.is_particle:
        yield ball(middle, 0.9 * u, "dot" if not is_fixed else look, color)
    elif form.solid.is_ball:
        yield ball(form.center, form.sizes[0], look, color, has_circles=True)
    elif form.solid.is_hoop:
        radius = form.sizes[0]
        axes = _own_axes(form)
        hoop = "fixed hoop" if is_fixed else "hoop"
        for part in band(radius, HOOP[0] * radius, HOOP[1] * radius):
            yield Piece(part.moved(axes, form.center.at), middle, form.index, hoop, color)
    elif form.solid.is_sheet and form.edges and solid is None:
        for part in tube(np.array([place.at for place in form.edges[0].places]), 0.4 * u):
            yield Piece(part, middle, form.index, look, color)
    elif form.solid.is_mesh and not is_on_hull(triangles := _triangles(form)):
        for part in surface(triangles):
            yield Piece(part, middle, form.index, "fixed skin" if is_fixed else "skin", color)
    elif solid is not None:
        yield Piece(solid, middle, form.index, look, color)
    else:
        yield from _skeleton(form, u, look, color)
        return
    yield from _arms(form, solid, used, u, look, color)


def _composed(form: Figure, u: float, look: str, color: int, *, is_fixed: bool) -> Iterator[Piece]:
    """The parts of a body at their places; balls alone have bars from one to the next, as a dumb-bell has."""
    for part in form.parts:
        axes, place = np.array(part.axes), Place(form.index, *part.at)
        for piece in body_pieces(part.form, (), u, is_fixed=is_fixed):
            lines = tuple(line @ axes for line in piece.lines)
            yield replace(piece, solid=piece.solid.moved(axes), lines=lines, place=place)
    if all(part.form.is_particle or part.form.solid.is_ball for part in form.parts):
        for first, second in pairwise(form.parts):
            if _apart(first.at, second.at) > u:
                yield _bar(form, first.at, second.at, 0.5 * u, look, color)


def _skeleton(form: Figure, u: float, look: str, color: int) -> Iterator[Piece]:
    """Lines from the reference point through the named points; three points in all make a sheet."""
    others = [name for name in form.points if name not in ("mass_center", "center", "origin")]
    tips = list(dict.fromkeys(form.points[name].at for name in others))
    tips = [tip for tip in tips if _apart(tip, form.center.at) > 1e-9]
    corners = np.array([form.center.at, *tips])
    if form.path:
        bars = [(a.at, b.at) for a, b in pairwise(form.path)]
    elif len(corners) == 3 and _is_sheet(corners):
        yield Piece(plate(corners), Place(form.index, 0.0, 0.0, 0.0), form.index, "web", color)
        bars = [(form.center.at, tips[0]), (form.center.at, tips[1]), (tips[0], tips[1])]
    else:
        bars = [(form.center.at, tip) for tip in tips]
    for a, b in bars:
        yield _bar(form, a, b, 0.34 * u, look, color)
    if form.has_mass or not tips:
        yield ball(Place(form.index, 0.0, 0.0, 0.0), 0.7 * u, "dot" if look == "body" else look, color)


def _is_sheet(corners: Array) -> bool:
    """Whether three corners lie on no line."""
    return float(np.linalg.norm(np.cross(corners[1] - corners[0], corners[2] - corners[0]))) > 1e-12


def _arms(
    form: Figure, solid: Solid | None, used: Collection[Triple], u: float, look: str, color: int
) -> Iterator[Piece]:
    """A bar from the middle of a body to what is joined to it outside its solid."""
    start = form.center.at if not form.solid.is_tapered else (0.0, 0.0, 0.0)
    if form.edges and form.edges[0].look == "wire":
        start = form.edges[0].places[len(form.edges[0].places) // 2].at
    for tip in used:
        gap = _gap(form, solid, np.array(tip))
        if gap > 0.5 * u and _apart(start, tip) > 0.5 * u:
            yield _bar(form, start, tip, 0.5 * u, look, color)


def _gap(form: Figure, solid: Solid | None, tip: Array) -> float:
    """[m] how far a point is outside a body, about."""
    if form.solid.is_hoop:
        return float(np.linalg.norm(tip - form.center.at)) - form.sizes[0] if form.sizes else 0.0
    if form.solid.is_ball:
        return float(np.linalg.norm(tip - form.center.at)) - form.sizes[0]
    if solid is None:
        return float(np.linalg.norm(tip))
    return max((float(n @ (tip - p)) for n, p in planes(solid)), default=0.0)


def planes(solid: Solid) -> Iterator[tuple[Array, Array]]:
    """Outward unit normals of the faces of a solid, and a point of each."""
    for face, normal in zip(solid.faces, solid.normals(solid.points), strict=True):
        size = float(np.linalg.norm(normal))
        if size > 1e-300:
            yield normal / size, solid.points[face[0]]


def _bar(form: Figure, a: Triple, b: Triple, radius: float, look: str, color: int) -> Piece:
    ends = np.array([a, b])
    length = float(np.linalg.norm(ends[1] - ends[0]))
    bar = prism(min(radius, 0.12 * length), 0.0, length, 12).moved(basis(ends[1] - ends[0]), a)
    return Piece(bar, Place(form.index, 0.0, 0.0, 0.0), form.index, look, color)


def _apart(a: Triple, b: Triple) -> float:
    return float(np.linalg.norm(np.subtract(a, b)))
