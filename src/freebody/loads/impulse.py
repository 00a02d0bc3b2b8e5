"""A blow at a point: an impulse, the time integral of a force that is great for no time."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from freebody.language.units import IMPULSE
from freebody.loads.base import Load
from freebody.loads.force import pushed_along
from freebody.model import glyphs
from freebody.model.elements import AppliedLoad
from freebody.model.glyphs import Glyph
from freebody.model.spec import Formula, Heading

if TYPE_CHECKING:
    from freebody.model.names import Names


class Impulse(Load, kind="impulse"):
    """`impulse: {at: rod.end, along: right, magnitude: J}`: at the start the point is struck. The section `start` says
    how everything moves just before; what is asked at the start is so just after. With `when: x = d` it is struck in
    mid-motion, the first time that x reaches d."""

    at: str
    along: Heading
    magnitude: Formula
    when: str = ""

    example = """
bodies: {ball: {particle: {mass: 1 kg}}}
loads: {it: {impulse: {at: ball, along: right, magnitude: 2 N s}}}
"""

    @property
    def strikes_when(self) -> str:
        return self.when

    def impulses(self, names: Names) -> list[AppliedLoad]:
        pushed = pushed_along(names, names.point(self.at, "at"), self.along)
        return [AppliedLoad("", pushed, names.formula(self.magnitude, IMPULSE, "magnitude"))]

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        yield glyphs.ForceArrow(names.point(self.at), names.direction(self.along, "along"))
