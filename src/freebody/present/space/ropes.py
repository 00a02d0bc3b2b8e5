"""Strings in space: straight leads along the common tangents of wheels, and arcs round these.

A string leaves a wheel with axis n, round which it runs with the arm s R, at C + s R e x n, with e its direction.
Where both ends of a lead are in one plane, d = C_2 - C_1 = l e + rho n x e with rho the difference of the arms.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

import numpy as np

from freebody.present.figures import Array, Node, Place, Rope
from freebody.present.space.figures import Poses
from freebody.present.space.pieces import Piece
from freebody.present.space.solids import prism

_PER_TURN = 36
_WOUND = 1.5 * np.pi  # of a drum


def is_wound(rope: Rope) -> bool:
    """Whether it is known about which axes its wheels turn."""
    return any(node.arm for node in rope.nodes) and all(not node.arm or node.axis is not None for node in rope.nodes)


def rope_pieces(rope: Rope, poses: Poses, radius: float) -> Iterator[Piece]:
    """Its leads, and its arcs in short pieces that stand still against what carries the wheel."""
    places = [list(_on_node(rope, k, poses)) for k in range(len(rope.nodes))]
    for arc in places:
        yield from (_piece(a, b, radius) for a, b in pairwise(arc))
    for one, other in pairwise(places):
        yield _piece(one[-1], other[0], radius)
    yield from free_lead(rope, [place for arc in places for place in arc], poses, radius)


def free_lead(rope: Rope, way: Sequence[Place], poses: Poses, radius: float) -> Iterator[Piece]:
    """Of a rope with a free first end what is left of its length before its way, in a still picture: in motion it grows
    shorter, which no piece that is fixed in a body does."""
    if rope.comes is None or rope.whole is None or poses.n_times > 1:
        return
    points = [poses.place(place, 0) for place in way]
    left = rope.whole - sum(float(np.linalg.norm(b - a)) for a, b in pairwise(points))
    if left > 0.0:
        end = points[0] - left * poses.heading(rope.comes, 0)
        yield _piece(Place(way[0].body, *poses.back(way[0].body, end, 0)), way[0], radius)


def _piece(a: Place, b: Place, radius: float) -> Piece:
    return Piece(prism(radius, 0.0, 1.0, 6), a, a.body, "string", end=b)


def _on_node(rope: Rope, k: int, poses: Poses) -> Iterator[Place]:
    """The places at which it touches a node: one of a point, an arc of a wheel."""
    node = rope.nodes[k]
    if not node.arm or node.axis is None or node.carrier is None:
        yield node.place
        return
    n, center = poses.heading(node.axis, 0), poses.place(node.place, 0)
    into = _heading(rope, k - 1, poses) if k else None if rope.comes is None else poses.heading(rope.comes, 0)
    out = None if k == len(rope.leads) else _heading(rope, k, poses)
    sense = np.sign(node.arm)
    if into is None or out is None:
        known = out if into is None else into
        assert known is not None
        angle = _WOUND if node.is_drum else 0.0
        into = _turned(n, known, -sense * angle) if out is known else known
    else:
        angle = float(np.arctan2(sense * n @ np.cross(into, out), into @ out)) % (2 * np.pi)
        angle = 0.0 if angle > 1.8 * np.pi else angle  # leads that have swung a little past each other
    body = node.carrier.body
    for a in np.linspace(0.0, angle, max(2, round(_PER_TURN * angle / (2 * np.pi)) + 1)):
        at = center + node.arm * np.cross(_turned(n, into, sense * float(a)), n)
        yield Place(body, *poses.back(body, at, 0))


def _heading(rope: Rope, k: int, poses: Poses) -> Array:
    """(3,) the direction of a lead: its own, or along the common tangent."""
    along, (a, b) = rope.leads[k].along, rope.nodes[k : k + 2]
    if along is not None:
        return poses.heading(along, 0)
    between = poses.place(b.place, 0) - poses.place(a.place, 0)
    n, rho = _normal(a, b, poses), b.arm - a.arm
    length = float(np.sqrt(max(float(between @ between) - rho**2, 0.0)))
    e = length * between - rho * np.cross(n, between)
    size = float(np.linalg.norm(e))
    return e / size if size > 0.0 else between


def _normal(a: Node, b: Node, poses: Poses) -> Array:
    axis = a.axis if a.axis is not None else b.axis
    return np.zeros(3) if axis is None else poses.heading(axis, 0)


def _turned(axis: Array, v: Array, angle: float) -> Array:
    """A vector perpendicular to an axis, turned about it."""
    turned: Array = np.cos(angle) * v + np.sin(angle) * np.cross(axis, v)
    return turned
