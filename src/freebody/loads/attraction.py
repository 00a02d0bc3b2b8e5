"""Attraction by a centre: Newton's law of gravitation.

    F = m mu/r^2,   V = -m mu/r,   mu = G M of the centre

A circular orbit has the speed sqrt(mu/r), and what leaves for ever sqrt(2 mu/r). Source: Newton, Principia, book III;
Beer, Johnston & Cornwell, Vector Mechanics for Engineers: Dynamics, sec. 12.10.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, ClassVar

from freebody.language.expression import divide, multiply, negate
from freebody.language.units import TIME, VOLUME
from freebody.loads.base import Load
from freebody.measures.distance import Distance
from freebody.measures.geometry import ZERO
from freebody.model import glyphs
from freebody.model.elements import VALUE, AppliedLoad, RigidBody
from freebody.model.glyphs import Glyph
from freebody.model.spec import Formula

if TYPE_CHECKING:
    from freebody.model.names import Names

_STRENGTH = VOLUME / TIME**2


class Attraction(Load, kind="attraction"):
    """`attraction: {center: ground.O, strength: mu}`: pulls the mass centre of every body of mass m to a point with
    m mu/r^2; mu = G M [m^3/s^2] of what is there. A body that carries the point feels the opposite force; `on: [moon]`
    names the bodies that are pulled."""

    called: ClassVar[tuple[str, ...]] = ("gravitation", "central gravity")
    also: ClassVar[tuple[str, ...]] = ("gravitation", "central_gravity")

    center: str
    strength: Formula
    on: list[str] | None = None

    pulling_sign = -1
    stores_energy = True
    spread_over = "whole"
    example = """
bodies: {ball: {particle: {mass: 1 kg}, at: [2 m, 1 m]}}
loads: {it: {attraction: {center: ground.O, strength: 8 m^3/s^2}}}
"""

    def applied_loads(self, names: Names) -> list[AppliedLoad]:
        center = names.point(self.center, "center")
        mu = names.positive(self, "strength", _STRENGTH)
        return [
            AppliedLoad(
                body.name,
                Distance(center, body.mass_center),
                negate(divide(multiply(body.mass, mu), VALUE * VALUE)),
            )
            for body in self._pulled(names)
        ]

    def _pulled(self, names: Names) -> list[RigidBody]:
        center = names.point(self.center, "center")
        chosen = names.bodies.values() if self.on is None else [names.body(n, "on", k) for k, n in enumerate(self.on)]
        return [body for body in chosen if body.mass != ZERO and not body.fixed and body.name != center.body]

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        center = names.point(self.center)
        yield from (glyphs.Relation((center, body.mass_center)) for body in self._pulled(names))
        yield glyphs.Center(center)
