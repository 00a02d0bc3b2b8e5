"""Draws what ropes and strings run over at points of the ground: the edge of a table, a peg."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from freebody.present.figures import GROUND, Array, Heading, Rope, positions, turned
from freebody.present.scene import Scene
from freebody.present.strokes import Path, Stroke
from freebody.present.symbols import circle, hatched

_UNDER, _BESIDE, _DOWN, _PEG = 0.2, 1.5, 4.0, 0.45  # in sizes of symbols: below a rope, behind its end, the side, a peg


class Edges:
    """The edges of a scene on its way. poses: (n_times, n_bodies, 3); u: [m] the size of symbols."""

    def __init__(self, scene: Scene, poses: Array, u: float) -> None:
        self.scene, self.poses, self.u = scene, poses, u

    def strokes(self, rope: Rope) -> Iterator[Stroke]:
        """The table on which a rope lies, and pegs at the points where a string is bent."""
        if self.scene.lies(rope):
            yield from self._table(rope)
            return
        first = 0 if rope.comes is not None or rope.is_closed else 1
        last = len(rope.nodes) if rope.is_closed else -1
        for node in rope.nodes[first:last]:
            if node.place.body == GROUND and node.arm == 0:
                yield Path(node.place, GROUND, circle(_PEG * self.u), "joint", True)

    def _table(self, rope: Rope) -> Iterator[Stroke]:
        """Its top as far as the rope lies at first, and its side below the edge, along the next lead."""
        comes, out = rope.comes, rope.leads[0].along
        if comes is None or out is None or rope.whole is None:
            return
        side = np.sign(comes.x * out.y - comes.y * out.x)
        laid = [positions(self.poses, node.place) for node in rope.nodes]
        between = sum(np.hypot(*(b - a).T) for a, b in pairwise(laid))
        left = max(0.0, float(np.max(rope.whole - between)))
        yield from self._line(rope, comes, -left - _BESIDE * self.u, 0.0, side)
        yield from self._line(rope, out, 0.0, _DOWN * self.u, side)

    def _line(self, rope: Rope, along: Heading, low: float, high: float, side: float) -> Iterator[Path]:
        """A line of the edge, a little inside of the rope and of the other one, hatched on the inside."""
        inside = side * _UNDER * self.u
        low, high = (low, high - _UNDER * self.u) if high == 0.0 else (low + _UNDER * self.u, high)
        edge = np.array([(low, inside), (high, inside)])
        hatch = hatched(low, high, side * self.u, self.u) + np.array((0.0, inside))
        for points, style in ((edge, "surface"), (hatch, "hatch")):
            yield Path(rope.nodes[0].place, GROUND, turned(along.angle, *points.T), style)
