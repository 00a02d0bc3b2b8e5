"""Joints as pieces, by what they hold."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import pairwise

import numpy as np

from freebody.model.solids import NO_SOLID
from freebody.present.figures import Array, Groove, Heading, Place, Roller
from freebody.present.scene import Scene
from freebody.present.space.cuts import DEEP, Cuts
from freebody.present.space.figures import DrawnJoint, Poses
from freebody.present.space.pieces import Piece, ball
from freebody.present.space.shells import Shells
from freebody.present.space.solids import Solid, basis, box, prism, tube
from freebody.present.space.stands import Stands
from freebody.present.space.symbols import AXLE, BALL, axle, thread

_N_RAIL = 24  # parts of a rail


class Joints:
    """The joints of a scene on its way; u: [m] the size of symbols."""

    def __init__(self, scene: Scene, poses: Poses, u: float, cuts: Cuts, stands: Stands, shells: Shells) -> None:
        self.scene, self.poses, self.u = scene, poses, u
        self.cuts, self.stands, self.shells = cuts, stands, shells

    def pieces(self) -> Iterator[Piece]:
        for joint in self.shells.joints:
            yield from self._joint(joint)
        for groove in self.scene.grooves:
            yield from self._groove(groove)
        for roller in self.scene.rollers:
            yield from self._roller(roller)

    def _joint(self, joint: DrawnJoint) -> Iterator[Piece]:
        """The sign of a joint by what it holds."""
        if joint.arms is not None:
            yield from self._cross(joint)
        elif joint.axis is None and joint.n_places == 3:
            if joint.n_turns < 3:
                radius = max((BALL if joint.n_turns == 0 else 1.3 * BALL) * self.u, 1.15 * self._thickness(joint))
                yield ball(joint.second, radius, "joint")
            yield from self.stands.held(joint.first, joint.second)
        elif joint.axis is not None and joint.n_places == 3:
            yield from self._hinge(joint, joint.axis)
        elif joint.axis is not None and joint.n_places == 2:
            if self.shells.tip(joint):
                yield from self._hinge(joint, joint.axis)
            else:
                yield from self._rail(joint, joint.axis)
        form = self.cuts.forms.get(joint.second.body)
        if joint.n_places < 3 and joint.n_turns == 0 and not (form is not None and form.is_particle):
            yield ball(joint.second, BALL * self.u, "joint")

    def _thickness(self, joint: DrawnJoint) -> float:
        """[m] the radius of a shaft that ends in a joint, unless it is much thicker than a symbol."""
        forms = [self.cuts.forms.get(place.body) for place in (joint.first, joint.second)]
        radii = [form.sizes[0] for form in forms if form is not None and form.solid.is_shaft]
        return max((radius for radius in radii if radius < 6 * self.u), default=0.0)

    def _cross(self, joint: DrawnJoint) -> Iterator[Piece]:
        """Two arms, one in each yoke."""
        assert joint.arms is not None
        for place, arm in zip((joint.first, joint.second), joint.arms, strict=True):
            along = self.poses.heading(arm, 0)
            low, high = self.cuts.inside((joint.first, joint.second), along)
            far = self.shells.radius if place.body in self.shells.forms else 0.0
            ends = [min(low, -far) - 0.8 * self.u, 0.0, max(high, far) + 0.8 * self.u]
            axis = np.array(self.poses.turned_back(place.body, along, 0))
            for part in axle(axis, ends, 0.36 * self.u):
                yield Piece(part, place, place.body, "joint")
        yield ball(joint.second, 0.6 * self.u, "joint")
        if self.scene.is_fixed(joint.first.body) or self.scene.is_fixed(joint.second.body):
            yield from self.stands.held(joint.first, joint.second)

    def _hinge(self, joint: DrawnJoint, axis: Heading) -> Iterator[Piece]:
        """An axle along the axis, out of both bodies; through the rim of a ring."""
        along = self.poses.heading(axis, 0)
        tip = self.shells.tip(joint)
        parts = [self._shell_part(joint, along, tip)] if tip else self._rim_parts(joint, along)
        if self.shells.is_in_fork(joint):  # in both arms of the fork
            parts += [[-end for end in reversed(ends)] for ends in parts]
        if not parts:
            low, high = self.cuts.inside((joint.first, joint.second), along)
            parts = [[low - 0.9 * self.u, 0.5 * (low + high), high + 0.9 * self.u]]
        own = np.array(self.poses.turned_back(joint.second.body, along, 0))
        for ends in parts:
            for part in axle(own, ends, AXLE * self.u):
                yield Piece(part, joint.second, joint.second.body, "joint")
        yield from self._bearing(joint, along, [end for ends in parts for end in (ends[0], ends[-1])])

    def _shell_part(self, joint: DrawnJoint, along: Array, tip: float) -> list[float]:
        """From where to where an axle runs on a sphere of bodies without extent: out of the body inside it, if any."""
        low, high = self.cuts.inside((joint.first, joint.second), along)
        others = {joint.first.body, joint.second.body} - self.shells.forms.keys()
        is_alone = low == high == 0.0 and all(self.scene.is_fixed(body) for body in others)
        start = tip - np.sign(tip) * 0.9 * self.u if is_alone else high if tip > 0 else low
        return sorted((float(start), tip + float(np.sign(tip)) * 0.9 * self.u))

    def _rim_parts(self, joint: DrawnJoint, along: Array) -> list[list[float]]:
        """From where to where an axle runs between a ring and what is inside it or outside; empty without a ring."""
        at = self.poses.place(joint.second, 0)
        radii: list[tuple[float, float]] = []  # where the middle is along the axis, and how far the rim is from there
        for place in (joint.first, joint.second):
            form = self.cuts.forms.get(place.body)
            if form is None or not form.solid.is_hoop or form.axis is None:
                continue
            middle = self.poses.place(form.center, 0) - at
            is_across = abs(self.poses.heading(Heading(form.index, *form.axis), 0) @ along) < 0.5
            if is_across and np.linalg.norm(middle - (middle @ along) * along) < 0.1 * form.sizes[0]:
                radii.append((float(middle @ along), form.sizes[0]))
        if not radii:
            return []
        middle = radii[0][0]
        reach = sorted(radius for _middle, radius in radii)
        if len(reach) == 1:
            _low, high = self.cuts.inside((joint.first, joint.second), along)
            is_held = self.scene.is_fixed(joint.first.body) or self.scene.is_fixed(joint.second.body)
            reach = [reach[0], reach[0] + 1.2 * self.u] if is_held else [max(high - middle, 0.0), reach[0]]
        inner, outer = reach[0], reach[-1] + 0.6 * self.u
        return [[middle + inner, middle + outer], [middle - outer, middle - inner]]

    def _bearing(self, joint: DrawnJoint, along: Array, ends: Iterable[float]) -> Iterator[Piece]:
        """A stand for an axle on the ground: under its lower end, or under the end away from the body."""
        fixed = [place for place in (joint.first, joint.second) if place.body == self.scene.ground]
        if len(fixed) != 1:
            return
        other = joint.second if fixed[0] is joint.first else joint.first
        at = self.poses.place(joint.second, 0)
        to_body = self.poses.centers[0, other.body] - at
        up = self.scene.up
        tips = [at + end * along for end in (min(ends), max(ends))]
        far = min(tips, key=lambda tip: (round(float((tip - at) @ to_body), 9), round(float(tip @ up), 9)))
        if self.shells.tip(joint):
            far = max(tips, key=lambda tip: float(np.linalg.norm(tip - at)))
        is_upright = abs(float(along @ up)) > 0.7
        down = np.sign(float((far - at) @ up)) * up if is_upright else -up * (1 if to_body @ up > -1.5 * self.u else -1)
        yield from self.stands.stand(far, down)

    def _groove(self, groove: Groove) -> Iterator[Piece]:
        """A ring along which a point runs."""
        yield from self._ring(groove.center, groove.radius)
        yield ball(groove.point, BALL * self.u, "joint")

    def _roller(self, roller: Roller) -> Iterator[Piece]:
        """Its rim, and the pin on which it turns."""
        yield from self._ring(roller.center, roller.radius)
        yield ball(roller.center, BALL * self.u, "joint")

    def _ring(self, center: Place, radius: float) -> Iterator[Piece]:
        """In the plane of x and y of its body."""
        a = np.linspace(0.0, 2 * np.pi, 49)
        way = radius * np.stack((np.cos(a), np.sin(a), np.zeros_like(a)), axis=-1)
        for part in tube(way, 0.3 * self.u):
            yield Piece(part, center, center.body, "rail")

    def _rail(self, joint: DrawnJoint, axis: Heading) -> Iterator[Piece]:
        """A bar along which the second body moves: square where it does not turn, with a thread on a screw."""
        u = self.u
        between = self.poses.way(joint.second) - self.poses.way(joint.first)
        travel = np.einsum("ti,ti->t", between, self.poses.headings(axis))
        low, high = self.cuts.inside((joint.second,), self.poses.heading(axis, 0), deep=float("inf"))
        # the end of a shaft slides in its bearing: no rail in the shaft
        is_free = [low > -DEEP * u or high > 0.2 * u, high < DEEP * u or low < -0.2 * u]
        start = min(0.0, float(travel.min()) + (low if is_free[0] else 0.0)) - 2.5 * u * is_free[0]
        end = max(0.0, float(travel.max()) + (high if is_free[1] else 0.0)) + 2.5 * u * is_free[1]
        cuts = np.linspace(start, end, _N_RAIL + 1)
        axes = basis(axis.along)
        at = joint.first
        for a, b in pairwise(cuts.tolist()):
            if joint.n_turns < 3:
                bar = prism(0.4 * u, a, b, 12, is_open=True)
            else:
                bar = box(0.7 * u, 0.7 * u, b - a).moved(np.eye(3), (0.0, 0.0, 0.5 * (a + b)))
                along = tuple(edge for edge in bar.edges if abs(edge.end - edge.start) == 4)
                bar = Solid(bar.points, bar.faces, along, frozenset((0, 1)))
            lines = (thread(0.4 * u, a, b, 0.9 * u) @ axes,) if joint.has_thread else ()
            yield Piece(bar.moved(axes), at, axis.body, "rail", lines=lines)
        form = self.cuts.forms.get(joint.second.body)
        if joint.n_turns and form is not None and form.solid is NO_SOLID and not form.is_particle:
            sleeve = prism(0.9 * u, -1.5 * u, 1.5 * u, 20) if joint.n_turns == 2 else box(1.6 * u, 1.6 * u, 3 * u)
            own = np.array(self.poses.turned_back(joint.second.body, self.poses.heading(axis, 0), 0))
            yield Piece(sleeve.moved(basis(own)), joint.second, joint.second.body, "joint")
        if axis.body == self.scene.ground:
            along, at0 = self.poses.heading(axis, 0), self.poses.place(joint.first, 0)
            steep = float(along @ self.scene.up)
            feet = [s for s, free in ((start + 0.3 * u, is_free[0]), (end - 0.3 * u, is_free[1])) if free]
            if abs(steep) > 0.7:
                feet = [start if steep > 0 else end]
            for s in feet:
                yield from self.stands.stand(at0 + s * along, -self.scene.up)
