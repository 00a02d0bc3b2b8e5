"""Curved rail: a point on a curve that is written, as a bead on a bent wire; its statement is that of all `rails`."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, ClassVar

from freebody.connections.curves import WrittenCurve
from freebody.connections.rails import Rail
from freebody.model import glyphs
from freebody.model.glyphs import Glyph

if TYPE_CHECKING:
    from freebody.model.names import Names


class CurvedRail(WrittenCurve, Rail, kind="curved_rail"):
    """`curved_rail: {point: bead, y: a*x^2}`: a point stays on the curve y = f(x) of another body (`on`, default the
    ground), x and y from its reference point along its axes (1 row, in space 2). f is a formula in x and parameters.
    `curved_rail: {point: bead, points: [[0 m, 2 m], [1 m, 1.2 m], ...]}`: through points with growing x, which a table
    in the folder of the model may hold (`points: track.csv`, with the head `x [m], y [m]`); `through: cubic` (a natural
    spline) or `pchip` (no overshoot, but the curvature jumps at the points); beyond them the curve goes on straight.
    `curved_rail: {point: bead, x: R*(s + sin(s)), y: R*(1 - cos(s))}`: on a curve in a parameter s, an angle or a
    length, in the plane; `parameter of rail` is it as a measure. The normal force is positive when it pushes to the
    left of the way of growing x or s, which is up where a curve to the right is level. `leaves: true`: the point lies
    on the curve and is not held from above. `friction`: mu, or {static: 0.5, kinetic: 0.4}. `ends: [x1, x2]`: from
    where to where the curve is drawn."""

    example = """
bodies: {bead: {particle: {mass: 1 kg}, near: {at: [0.5 m, 0.3 m]}}}
parameters: {a: 1 1/m}
connections: {it: {curved_rail: {point: bead, y: a*x^2}}}
"""
    more_examples: ClassVar[dict[str, str]] = {
        "points": """
bodies: {bead: {particle: {mass: 1 kg}, near: {at: [0.5 m, 0.3 m]}}}
connections: {it: {curved_rail: {point: bead, points: [[0 m, 0 m], [0.4 m, 0.2 m], [1 m, 0.9 m], [2 m, 1 m]]}}}
"""
    }

    def _is_sound(self, names: Names) -> bool:
        return self.is_written(names) and super()._is_sound(names)

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        yield from super().glyphs(names)
        if self.is_in_x and self.y is not None and self._is_sound(names):
            yield glyphs.Equation(self.moved_point(names), f"y = {self.y}")
