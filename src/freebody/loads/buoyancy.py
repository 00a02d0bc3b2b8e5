"""Buoyancy: the weight of the liquid that a body displaces (Archimedes).

    wholly immersed      F = rho g V
    partly immersed      F = rho g A d,   d the depth of its bottom, A its level cross-section

An upright floating body bobs with the period 2 pi sqrt(m/(rho g A)). Source: Archimedes, On floating bodies; White,
Fluid Mechanics, sec. 2.8; French, Vibrations and Waves, ch. 3.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from freebody.language.expression import Call, divide, multiply, number
from freebody.language.sentences import Message
from freebody.language.units import ACCELERATION, AREA, DENSITY, LENGTH, VOLUME
from freebody.loads.base import Load
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, ZERO, Direction, Point
from freebody.model import glyphs
from freebody.model.elements import VALUE, AppliedLoad, Validity
from freebody.model.glyphs import Glyph
from freebody.model.spec import Formula

if TYPE_CHECKING:
    from freebody.model.names import Names


class Buoyancy(Load, kind="buoyancy"):
    """`buoyancy: {at: buoy.bottom, density: rho, strength: g, area: A}`: pushes up with rho g A d, d how far the point
    is below the surface, which is level with `surface` (a point, default the origin of the ground); of what stays
    upright and floats. With `height: h` it may also dive (d more than h) or leave the water (d < 0). `volume: V` in
    place of area: wholly immersed, rho g V; with `surface` the answers say until when the point is in the water."""

    at: str
    density: Formula
    strength: Formula
    area: Formula | None = None
    height: Formula | None = None
    volume: Formula | None = None
    surface: str | None = None

    stores_energy = True
    spread_over = "whole"
    example = """
bodies: {buoy: {rectangle: {mass: 1 kg, width: 0.1 m, height: 0.4 m}}}
loads: {it: {buoyancy: {at: buoy.bottom, density: 1000 kg/m^3, strength: 9.81 m/s^2, area: 0.01 m^2}}}
"""

    def applied_loads(self, names: Names) -> list[AppliedLoad]:
        point = names.point(self.at, "at")
        if (self.area is None) == (self.volume is None):
            names.problem(Message("give area, the level cross-section of what floats, or volume, of what is immersed"))
            return []
        weight = names.positive(self, "density", DENSITY) * names.positive(self, "strength", ACCELERATION)
        if self.volume is not None:
            if self.height is not None:
                names.problem(Message("height goes with area; a volume is wholly immersed"), "height")
            lifted = multiply(weight, names.positive(self, "volume", VOLUME))
            return [AppliedLoad("", Displacement(point, names.ground_origin, self._up(names)), lifted)]
        height = self._height(names, point)
        by_depth = multiply(weight, names.positive(self, "area", AREA))
        if self.height is None:
            names.assumptions.append(self._assumed(names, point))
            return [AppliedLoad("", height, -(by_depth * VALUE))]
        h = names.positive(self, "height", LENGTH)
        # |d| - |d - h| + h is twice the depth between 0 and h: 0 above the water, 2 h below it
        within = divide(Call("abs", VALUE) - Call("abs", VALUE + h) + h, number(2))
        return [AppliedLoad("", height, by_depth * within)]

    def valid_where(self, names: Names) -> list[Validity]:
        """Without a height it is partly immersed, with one it is where it is; a volume is immersed as long as the point
        is below the surface, where one is named."""
        if self.height is not None or (self.area is None and self.surface is None):
            return []
        point = names.point(self.at, "at")
        in_water = Message("{point} is in the water", point=self.at)
        return [Validity(self._height(names, point), ZERO, -1, in_water)]

    def _height(self, names: Names, point: Point) -> Displacement:
        """Of a point above the surface."""
        surface = names.ground_origin if self.surface is None else names.point(self.surface, "surface")
        return Displacement(point, surface, self._up(names))

    def _up(self, names: Names) -> Direction:
        return names.compass["up"]

    def _assumed(self, names: Names, point: Point) -> Message:
        return Message("{body} floats upright and does not dive", body=point.body)

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        yield glyphs.ForceArrow(names.point(self.at), self._up(names))
        if self.area is not None and not names.space:
            surface = names.ground_origin if self.surface is None else names.point(self.surface)
            if surface.body == GROUND:
                yield glyphs.Relation(tuple(self._beside(names, surface, side) for side in (-1, 1)))

    def _beside(self, names: Names, surface: Point, side: int) -> Point:
        """A point of the surface of the water, beside the body at rest in the middle of its picture."""
        x, y, *_z = surface.offset
        reach = multiply(number(side), number(2), Call("sqrt", names.positive(self, "area", AREA)))
        return Point(GROUND, (x + reach, y))
