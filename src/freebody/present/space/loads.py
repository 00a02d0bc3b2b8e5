"""Links, strings, springs, forces and torques, as pieces."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby, pairwise

import numpy as np

from freebody.model.glyphs import Coil, ForceArrow, Halt, MomentArrow, Relation, Rod, Rope, Shoe, Spread, Spring, Tether
from freebody.present import figures
from freebody.present.figures import Array, Heading, Place
from freebody.present.pen import full_height
from freebody.present.scene import Scene
from freebody.present.space.cuts import Cuts
from freebody.present.space.figures import Poses, upright
from freebody.present.space.pieces import Piece, ball
from freebody.present.space.ropes import free_lead, is_wound, rope_pieces
from freebody.present.space.shells import Shells
from freebody.present.space.solids import basis, box, prism
from freebody.present.space.stands import Stands
from freebody.present.space.symbols import arrow, curved_arrow, damper, helix, spiral

_ORDER: dict[type, int] = {Rod: 1, Rope: 2, Spring: 3, ForceArrow: 4, Tether: 4, MomentArrow: 4, Coil: 5, Spread: 6}
_N_SIDE_BY_SIDE = 7  # arrows of a load along a line


class Loads:
    """What runs between points and what pushes bodies; u: [m] the size of symbols."""

    def __init__(self, scene: Scene, poses: Poses, u: float, cuts: Cuts, stands: Stands, shells: Shells) -> None:
        self.scene, self.poses, self.u = scene, poses, u
        self.cuts, self.stands, self.shells = cuts, stands, shells

    def pieces(self) -> Iterator[Piece]:
        for shown in sorted(self.scene.shown, key=lambda shown: _ORDER.get(type(shown.sign), 0)):
            yield from self.pieces_of(shown)

    def pieces_of(self, shown: figures.ShownGlyph) -> Iterator[Piece]:
        match shown.sign:
            case Rod(first, second):
                yield from self._rod(first, second)
            case Relation(points) as line:
                look, thick = ("net", 0.03) if line.is_of_net else ("string", 0.08)
                for a, b in pairwise(points):
                    yield Piece(prism(thick * self.u, 0.0, 1.0, 6), a, a.body, look, end=b)
            case Halt(point, origin, along, limit):
                yield self._wall(point, origin, along, limit)
            case Shoe(first, second):
                yield from self._shoe(first, second)
            case Rope(nodes) as rope if is_wound(rope):
                yield from rope_pieces(rope, self.poses, 0.1 * self.u)
                yield from self.stands.held(nodes[0].place, nodes[-1].place)
            case Rope(nodes):
                way = [place for place, _same in groupby(node.place for node in nodes)]
                yield from self._string(way)
                yield from free_lead(shown.sign, way, self.poses, 0.1 * self.u)
            case Spring(first, second, is_spring, is_damper):
                yield from self._spring(first, second, is_spring=is_spring, is_damper=is_damper)
            case ForceArrow(at, along) | Tether(at, along):
                yield from self._force(at, along)
            case Spread(first, second, along, sizes):
                yield from self._spread(first, second, along, sizes)
            case MomentArrow(body, axis):
                yield from self._moment(body.body, upright(self.scene, axis))
            case Coil(body, _base, axis):
                yield from self._coil(body.body, upright(self.scene, axis))
            case _:
                pass

    def _rod(self, a: Place, b: Place) -> Iterator[Piece]:
        yield Piece(prism(0.3 * self.u, 0.0, 1.0, 12), a, a.body, "link", end=b)
        yield from (ball(place, 0.55 * self.u, "joint") for place in (a, b) if not self._is_particle(place))
        yield from self.stands.held(a, b)

    def _string(self, way: Sequence[Place]) -> Iterator[Piece]:
        for a, b in pairwise(way):
            yield Piece(prism(0.1 * self.u, 0.0, 1.0, 6), a, a.body, "string", end=b)
        yield from self.stands.held(way[0], way[-1])

    def _wall(self, point: Place, origin: Place, along: Heading, limit: float) -> Piece:
        """A plate where a point stops, beside where it is at the start."""
        at, e = self.poses.place(point, 0), self.poses.heading(along, 0)
        stop = at + (limit - float((at - self.poses.place(origin, 0)) @ e)) * e
        plate = box(2.4 * self.u, 2.4 * self.u, 0.5 * self.u).moved(basis(along.along))
        return Piece(plate, Place(along.body, *self.poses.back(along.body, stop, 0)), along.body, "stand")

    def _shoe(self, first: Place, second: Place) -> Iterator[Piece]:
        """A block on the rim of a round body, at rest with the other one."""
        form, other = self.cuts.forms.get(first.body), second
        if form is None or form.axis is None:
            form, other = self.cuts.forms.get(second.body), first
        if form is not None and form.axis is not None:
            way = basis(form.axis)[0].tolist()
            out = np.array(self.poses.turned_back(other.body, self.poses.heading(Heading(form.index, *way), 0), 0))
            level = form.sizes[0] + 0.45 * self.u
            block = box(1.6 * self.u, 1.6 * self.u, 0.9 * self.u).moved(basis(out), level * out)
            yield Piece(block, form.center, other.body, "joint")

    def _is_particle(self, place: Place) -> bool:
        form = self.cuts.forms.get(place.body)
        return form is not None and form.is_particle

    def _spring(self, a: Place, b: Place, *, is_spring: bool, is_damper: bool) -> Iterator[Piece]:
        radius = 0.75 * self.u
        if is_spring or not is_damper:
            hint = prism(radius, 0.0, 1.0, 12)
            yield Piece(hint, a, a.body, "spring", end=b, lines=(helix(radius),), is_hint=True)
        if is_damper:
            pot = damper(0.6 * radius if is_spring else radius)
            yield from (Piece(part, a, a.body, "damper", end=b) for part in pot)
        yield from self.stands.held(a, b)

    def _force(self, at: Place, heading: Heading) -> Iterator[Piece]:
        _low, high = self.cuts.inside((at,), self.poses.heading(heading, 0), deep=float("inf"))
        for part in arrow(np.array(heading.along), max(0.0, high), 6.5 * self.u, self.u):
            yield Piece(part, at, heading.body, "force")

    def _spread(self, first: Place, second: Place, heading: Heading, sizes: tuple[float, float]) -> Iterator[Piece]:
        """Arrows side by side, as long as the load is large there."""
        one, other, largest = np.array(first.at), np.array(second.at), full_height(sizes, self._sizes())
        for share in np.linspace(0.0, 1.0, _N_SIDE_BY_SIDE):
            size = ((1.0 - share) * sizes[0] + share * sizes[1]) / largest
            place = Place(first.body, *((1.0 - share) * one + share * other).tolist())
            if abs(size) > 0.1:
                for part in arrow(np.sign(size) * np.array(heading.along), 0.0, 4.0 * abs(size) * self.u, 0.6 * self.u):
                    yield Piece(part, place, heading.body, "force")

    def _sizes(self) -> Iterator[tuple[float, float]]:
        yield from (sign.sizes for sign in self.scene.signs if isinstance(sign, Spread))

    def _moment(self, body: int, axis: Heading) -> Iterator[Piece]:
        place, radius = self._axle_of(body, self.poses.heading(axis, 0))
        top = np.array(self.poses.turned_back(axis.body, self.scene.up, 0))
        for part in curved_arrow(np.array(axis.along), top, radius, self.u):
            yield Piece(part, place, axis.body, "force")

    def _coil(self, body: int, axis: Heading) -> Iterator[Piece]:
        place, _radius = self._axle_of(body, self.poses.heading(axis, 0))
        for part in spiral(np.array(axis.along), self.u):
            yield Piece(part, place, axis.body, "spring")

    def _axle_of(self, index: int, along: Array) -> tuple[Place, float]:
        """Where to draw what turns a body about an axis, and how far from the axis: at its joint, else its middle."""
        for joint in self.shells.joints:
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
                place = Place(index, *self.poses.back(index, at + 0.8 * side * tip * along, 0))
                return place, 2.2 * self.u
            is_low = to_body > 1e-9 or (to_body > -1e-9 and float(along @ self.scene.up) < -0.1)
            s = low - 0.6 * self.u if is_low else high + 0.6 * self.u
            return Place(index, *self.poses.back(index, at + s * along, 0)), 2.2 * self.u
        form = self.cuts.forms.get(index)
        radius = 2.2 * self.u
        if form is not None and form.solid.is_thick and form.sizes[0] < 6 * self.u:
            radius = max(radius, 1.3 * form.sizes[0])
        return Place(index, 0.0, 0.0, 0.0), radius
