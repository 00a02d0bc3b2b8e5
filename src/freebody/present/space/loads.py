"""Links, strings, springs, forces and torques, as pieces."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from freebody.present.figures import Array
from freebody.present.space.cuts import Cuts
from freebody.present.space.figures import Arrow, Coil, Place, Poses, Spring
from freebody.present.space.pieces import Piece, ball
from freebody.present.space.scene import Scene
from freebody.present.space.shells import Shells
from freebody.present.space.solids import prism
from freebody.present.space.stands import Stands
from freebody.present.space.symbols import arrow, curved_arrow, damper, helix, spiral


class Loads:
    """What runs between points and what pushes bodies; u: [m] the size of symbols."""

    def __init__(self, scene: Scene, poses: Poses, u: float, cuts: Cuts, stands: Stands, shells: Shells) -> None:
        self.scene, self.ties, self.poses, self.u = scene, scene.ties, poses, u
        self.cuts, self.stands, self.shells = cuts, stands, shells

    def pieces(self) -> Iterator[Piece]:
        for a, b in self.ties.links:
            yield Piece(prism(0.3 * self.u, 0.0, 1.0, 12), a, a.body, "link", end=b)
            yield from (ball(place, 0.55 * self.u, "joint") for place in (a, b) if not self._is_particle(place))
            yield from self.stands.held(a, b)
        for string in self.ties.strings:
            for a, b in pairwise(string):
                yield Piece(prism(0.1 * self.u, 0.0, 1.0, 6), a, a.body, "string", end=b)
            yield from self.stands.held(string[0], string[-1])
        for spring in self.ties.springs:
            yield from self._spring(spring)
        for load in self.ties.arrows:
            yield from self._arrow(load)
        for coil in self.ties.coils:
            yield from self._coil(coil)

    def _is_particle(self, place: Place) -> bool:
        form = self.cuts.forms.get(place.body)
        return form is not None and form.is_particle

    def _spring(self, spring: Spring) -> Iterator[Piece]:
        a, b, radius = spring.first, spring.second, 0.75 * self.u
        if spring.is_spring or not spring.is_damper:
            hint = prism(radius, 0.0, 1.0, 12)
            yield Piece(hint, a, a.body, "spring", end=b, lines=(helix(radius),), is_hint=True)
        if spring.is_damper:
            pot = damper(0.6 * radius if spring.is_spring else radius)
            yield from (Piece(part, a, a.body, "damper", end=b) for part in pot)
        yield from self.stands.held(a, b)

    def _arrow(self, load: Arrow) -> Iterator[Piece]:
        along = np.array(load.along.along)
        now = self.poses.heading(load.along, 0)
        if not load.turns:
            _low, high = self.cuts.inside((load.place,), now, deep=float("inf"))
            for part in arrow(along, max(0.0, high), 6.5 * self.u, self.u):
                yield Piece(part, load.place, load.along.body, "force")
            return
        place, radius = self._axle_of(load.place.body, now)
        top = np.array(self.poses.turned_back(load.along.body, self.scene.up, 0))
        for part in curved_arrow(along, top, radius, self.u):
            yield Piece(part, place, load.along.body, "force")

    def _coil(self, coil: Coil) -> Iterator[Piece]:
        place, _radius = self._axle_of(coil.body, self.poses.heading(coil.axis, 0))
        for part in spiral(np.array(coil.axis.along), self.u):
            yield Piece(part, place, coil.axis.body, "spring")

    def _axle_of(self, index: int, along: Array) -> tuple[Place, float]:
        """Where to draw what turns a body about an axis, and how far from the axis: at its joint, else its middle."""
        for joint in self.ties.joints:
            if joint.axis is None or index not in (joint.first.body, joint.second.body):
                continue
            if abs(self.poses.heading(joint.axis, 0) @ along) < 0.99:
                continue
            at = self.poses.place(joint.second, 0)
            low, high = self.cuts.inside((joint.first, joint.second), along)
            to_body = (self.poses.centers[0, index] - at) @ along
            tip = self.shells.tip(joint)
            if tip:
                side = float(np.sign(self.poses.heading(joint.axis, 0) @ along))
                place = Place(index, self.poses.back(index, at + 0.8 * side * tip * along, 0))
                return place, 2.2 * self.u
            is_low = to_body > 1e-9 or (to_body > -1e-9 and float(along @ self.scene.up) < -0.1)
            s = low - 0.6 * self.u if is_low else high + 0.6 * self.u
            return Place(index, self.poses.back(index, at + s * along, 0)), 2.2 * self.u
        form = self.cuts.forms.get(index)
        radius = 2.2 * self.u
        if form is not None and form.solid in ("cylinder", "sphere") and form.sizes[0] < 6 * self.u:
            radius = max(radius, 1.3 * form.sizes[0])
        return Place(index, (0.0, 0.0, 0.0)), radius
