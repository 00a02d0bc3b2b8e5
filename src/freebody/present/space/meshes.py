"""Triangles as solids: a convex mesh as one of them, another as many thin ones.

Between two triangles is an edge where the surface bends by more than a few degrees; where it bends less it stands for
something flat or round, of which only the outline is drawn.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from math import cos, radians

import numpy as np
from numpy.typing import NDArray

from freebody.present.figures import Array
from freebody.present.space.solids import Edge, Solid
from freebody.present.space.solids import solid as make_solid

_BEND = cos(radians(30.0))  # of what is drawn as an edge
_FLAT = 1e-5  # by the size of the whole


def mesh_hull(triangles: Array) -> Solid:
    """The convex hull of triangles (n, 3, 3)."""
    from scipy.spatial import ConvexHull  # takes longer to import than the motion of a model without meshes

    found = ConvexHull(triangles.reshape(-1, 3))
    order = {int(k): n for n, k in enumerate(found.vertices)}
    points = found.points[found.vertices]
    faces: list[tuple[int, ...]] = []
    for corners, outward in zip(found.simplices, found.equations[:, :3], strict=True):
        a, b, c = (order[int(k)] for k in corners)
        is_outward = float(np.cross(points[b] - points[a], points[c] - points[a]) @ outward) > 0.0
        faces.append((a, b, c) if is_outward else (a, c, b))
    return _bent(make_solid(points, faces))


def _bent(whole: Solid) -> Solid:
    """With edges only where it bends."""
    normals = _unit(whole.normals(whole.points))
    return replace(
        whole,
        edges=tuple(
            edge._replace(kind="crease" if float(normals[edge.left] @ normals[edge.right]) < _BEND else "smooth")
            for edge in whole.edges
        ),
    )


def is_on_hull(triangles: Array) -> bool:
    """Whether triangles (n, 3, 3), counter-clockwise from outside, have all their corners on one side."""
    points = triangles.reshape(-1, 3)
    size = float(np.ptp(points, axis=0).max())
    normals = _unit(np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]))
    return all(float(((points - a) @ n).max()) <= _FLAT * size for a, n in zip(triangles[:, 0], normals, strict=True))


def surface(triangles: Array) -> Iterator[Solid]:
    """Each of triangles (n, 3, 3) alone, seen from outside, with those of its sides at which the surface bends."""
    corners, places = np.unique(triangles.reshape(-1, 3), axis=0, return_inverse=True)
    faces: NDArray[np.intp] = places.reshape(-1, 3)
    normals = _unit(np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]))
    owner = {(int(f[i]), int(f[(i + 1) % 3])): k for k, f in enumerate(faces) for i in range(3)}
    for k, face in enumerate(faces):
        sides = [(i, (i + 1) % 3) for i in range(3)]
        beside = [owner.get((int(face[j]), int(face[i]))) for i, j in sides]
        edges = tuple(
            Edge(i, j, 0, 0, "crease")
            for (i, j), other in zip(sides, beside, strict=True)
            if other is None or float(normals[k] @ normals[other]) < _BEND
        )
        yield Solid(corners[face], ((0, 1, 2),), edges)


def _unit(normals: Array) -> Array:
    size = np.linalg.norm(normals, axis=1, keepdims=True)
    return normals / np.where(size > 0.0, size, 1.0)
