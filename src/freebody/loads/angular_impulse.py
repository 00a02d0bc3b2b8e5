"""An angular impulse on a body: the time integral of a torque that is great for no time."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from freebody.language.units import ANGULAR_MOMENTUM
from freebody.loads.torque import Couple, turned_about
from freebody.measures.geometry import GROUND
from freebody.model import glyphs
from freebody.model.elements import AppliedLoad
from freebody.model.glyphs import Glyph
from freebody.model.spec import Formula, Heading

if TYPE_CHECKING:
    from freebody.model.names import Names


class AngularImpulse(Couple, kind="angular_impulse"):
    """`angular_impulse: {on: wheel, magnitude: H}`, counter-clockwise positive, at the start or with `when: x = d` in
    mid-motion; `reacts_on`, `about` and `clockwise` as of a torque."""

    on: str
    magnitude: Formula
    reacts_on: str = GROUND
    about: Heading | None = None
    when: str = ""
    clockwise: bool = False

    example = """
bodies: {wheel: {disk: {mass: 1 kg, radius: 1 m}}}
loads: {it: {angular_impulse: {on: wheel, magnitude: 2 N m s}}}
"""

    @property
    def strikes_when(self) -> str:
        return self.when

    def impulses(self, names: Names) -> list[AppliedLoad]:
        turned = turned_about(names, self.on, self.reacts_on, self.about)
        magnitude = names.formula(self.magnitude, ANGULAR_MOMENTUM, "magnitude")
        magnitude = self.signed(names, magnitude, clockwise=self.clockwise)
        return [] if turned is None else [AppliedLoad("", turned, magnitude)]

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        axis = names.direction(self.about, "about") if names.space and self.about is not None else None
        yield glyphs.MomentArrow(names.body(self.on).mass_center, axis)
