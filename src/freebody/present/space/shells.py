"""Bodies without extent: the model gives their inertia and the axes of their joints, all through one point.

Such bodies move as if on spheres. They are drawn with a made-up radius: an arc between the axes of two joints, a wheel
on the axis of a single one, a ball without any. Where two shafts that turn in bearings are joined by a body with two
axes at right angles, or by a universal joint, it is a cross and the shafts have forks.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise

import numpy as np

from freebody.model.glyphs import Toothed
from freebody.model.solids import NO_SOLID
from freebody.present.figures import Array, Figure, Heading, Place
from freebody.present.scene import Scene
from freebody.present.space.bodies import reach
from freebody.present.space.figures import DrawnJoint, Poses, joints_of
from freebody.present.space.pieces import Piece, ball
from freebody.present.space.solids import basis, marked, prism, tube

_SHARE = 0.16  # of the size of a scene that has one
_ROOM = 1.35  # round a solid at the same place
_WHEEL = 0.38  # of the radius of the sphere
_ASIDE = 0.62  # where wheels stand if there are several
_CLOSE = 0.7  # cosine of the angle within which two axes of the ground are drawn on different sides
_FARTHER = 0.22  # of the radius, for the next one on the same side
_N_ARC = 24
_N_TEETH = 36
_PARALLEL = 0.999  # cosine of the angle between axes
_NEAR = 0.01  # of the radius of a wheel, from where its axis meets another
_YOKE = 0.34  # half the width of a fork by the radius of the sphere
_DEEP = 0.42  # how far behind the cross a fork begins


class Shells:
    """The bodies of a scene without extent, and on which side of their middle each of their axes is drawn."""

    def __init__(self, scene: Scene, poses: Poses, size: float) -> None:
        """size: [m] of the scene, 0 if it has none."""
        self.scene, self.poses = scene, poses
        self.forms = {form.index: form for form in scene.figures if _is_thin(form, 1e-6 * size)}
        middles = [poses.centers[0, index] for index in self.forms]
        near = [
            reach(form)
            for form in scene.figures
            if any(np.linalg.norm(poses.centers[0, form.index] - middle) < 1e-6 * size for middle in middles)
        ]
        self._cones = {(a.body, b.body): radii for a, b, *radii in _cones(scene)}
        rims = [rim for pair, radii in self._cones.items() for rim in radii if self.forms.keys() & {*pair}]
        self.radius = max(_SHARE * size, _ROOM * max([*near, *rims], default=0.0)) or 1.0
        self.joints = tuple(joints_of(scene, poses))
        self.crosses, self.forks = self._universal()
        self._tips: dict[DrawnJoint, float] = {}
        taken: list[Array] = []
        for joint in self.joints:
            if joint.axis is None or not self._bodies(joint):
                continue
            along = poses.heading(joint.axis, 0)
            is_held = scene.ground in (joint.first.body, joint.second.body)
            n_same = sum(float(other @ along) > _CLOSE for other in taken)
            n_other = sum(float(other @ along) < -_CLOSE for other in taken)
            sign = -1.0 if is_held and n_same > n_other else 1.0
            level = min(n_same, n_other) if is_held else 0  # how many are on this side already
            far = _YOKE if self.is_in_fork(joint) else 1.0 + _FARTHER * level
            self._tips[joint] = sign * self.radius * far
            if is_held:
                taken.append(sign * along)
        single = [index for index in self.forms if len(self._axes(index)) == 1]
        self._places = {index: _ASIDE * self.radius if len(single) > 1 else 0.0 for index in single}
        self._rims = dict.fromkeys(single, _WHEEL * self.radius)
        for index in single:
            self._set_cone(index)

    def _set_cone(self, index: int) -> None:
        """The wheel of a bevel gear is its pitch circle: R_1 at d_1 = (R_2 + R_1 cos S)/sin S from where the axes meet,
        S the angle between them. Beyond it is the bearing of a wheel whose middle is not there."""
        partner = next((other for one, other in self._cones if one == index), index)
        mine, its = self._line(index), self._line(partner)
        if partner == index or mine is None or its is None or abs(float(mine[1] @ its[1])) > _PARALLEL:
            return
        own, other = self._cones[index, partner]
        (at, along), (there, across) = mine, its
        cosine = float(along @ across)
        to_apex = float((there - at) @ (along - cosine * across)) / (1.0 - cosine**2)
        apex = at + to_apex * along
        sense = -1.0 if to_apex > _NEAR * own else 1.0
        cosine *= sense * (-1.0 if float((there - apex) @ across) < -_NEAR * own else 1.0)
        far = (other + own * cosine) / math.sqrt(1.0 - cosine**2)
        self._places[index], self._rims[index] = to_apex + sense * far, own
        if abs(to_apex) > _NEAR * own:
            (joint,) = (joint for joint, _arm in self._arms_of(index))
            self._tips[joint] = math.copysign(abs(self._places[index]) + 0.5 * own, self._tips[joint])

    def _line(self, index: int) -> tuple[Array, Array] | None:
        """The middle of a body and the unit vector of its only axis, towards where its joint is drawn."""
        arms = list(self._arms_of(index)) if index in self.forms else []
        if len(arms) != 1:
            return None
        joint, arm = arms[0]
        along = math.copysign(1.0, self._tips.get(joint, 1.0)) * arm
        return self.poses.centers[0, index], self.poses.axes[0, index] @ along

    def _universal(self) -> tuple[set[int], dict[int, DrawnJoint]]:
        """Bodies that are a cross, and the joints that bear shafts with a fork, by shaft."""
        of: dict[int, list[DrawnJoint]] = {index: [] for index in self.forms}
        for joint in self.joints:
            for place in (joint.first, joint.second):
                if place.body in of:
                    of[place.body].append(joint)
        held = {index: [j for j in joints if self._is_held(j)] for index, joints in of.items()}
        shafts = {index: mine[0] for index, mine in held.items() if len(mine) == 1 and mine[0].axis is not None}
        crosses = {
            index
            for index, joints in of.items()
            if len(joints) == 2 and all(_other(joint, index) in shafts for joint in joints) and self._is_square(joints)
        }

        def is_yoke(joint: DrawnJoint, index: int) -> bool:
            other = _other(joint, index)
            return other in crosses or (joint.arms is not None and other in shafts)

        forks = {
            index: bearing
            for index, bearing in shafts.items()
            if len(of[index]) == 2 and any(is_yoke(joint, index) for joint in of[index])
        }
        return {index for index in crosses if all(_other(j, index) in forks for j in of[index])}, forks

    def _is_held(self, joint: DrawnJoint) -> bool:
        return self.scene.is_fixed(joint.first.body) or self.scene.is_fixed(joint.second.body)

    def _is_square(self, joints: Sequence[DrawnJoint]) -> bool:
        """Whether two joints have axes at right angles."""
        axes = [self.poses.heading(joint.axis, 0) for joint in joints if joint.axis is not None]
        return len(axes) == 2 and abs(float(axes[0] @ axes[1])) < 1e-6

    def is_in_fork(self, joint: DrawnJoint) -> bool:
        """Whether a joint is that of a cross in a fork."""
        return joint.first.body in self.crosses or joint.second.body in self.crosses

    def tip(self, joint: DrawnJoint) -> float:
        """[m] where along its axis a joint of a body without extent is drawn; 0 for other joints."""
        return self._tips.get(joint, 0.0)

    def _bodies(self, joint: DrawnJoint) -> list[int]:
        return [place.body for place in (joint.first, joint.second) if place.body in self.forms]

    def _axes(self, index: int) -> list[Array]:
        """Where the joints of a body are drawn (3,) [m], along its own axes."""
        return [arm * self._tips.get(joint, self.radius) for joint, arm in self._arms_of(index)]

    def pieces(self, form: Figure, u: float) -> Iterator[Piece]:
        """u: [m] the size of symbols."""
        is_fixed = self.scene.is_fixed(form.index)
        look, color = ("fixed body", -1) if is_fixed else ("body", form.number)
        middle = form.center
        axes = self._axes(form.index)
        if form.index in self.crosses:
            yield from self._cross(form, axes, u, look, color)
        elif form.index in self.forks:
            yield from self._fork(form, u, look, color)
        elif not axes:
            yield ball(middle, 0.3 * self.radius, look, color, has_circles=True)
        elif len(axes) == 1:
            far = float(np.linalg.norm(axes[0]))
            at = self._places[form.index] * axes[0] / far
            n_marks = _N_TEETH if form.is_toothed else 1
            rim = prism(self._rims[form.index], -0.5 * u, 0.5 * u)
            wheel = marked(rim, n_marks).moved(basis(axes[0]), at)
            yield Piece(wheel, middle, form.index, look, color)
            ends = self._places[form.index], far
            shaft = prism(0.3 * u, ends[0] + 0.5 * u, ends[1], 12).moved(basis(axes[0]))
            yield Piece(shaft, middle, form.index, look, color)
        if form.index in self.crosses or form.index in self.forks:
            return
        for a, b in pairwise(axes):
            for part in tube(_arc(a, b), 0.42 * u, 12):
                yield Piece(part, middle, form.index, "fixed hoop" if is_fixed else "hoop", color)

    def _cross(self, form: Figure, axes: Sequence[Array], u: float, look: str, color: int) -> Iterator[Piece]:
        """Two bars at right angles, from one arm of a fork to the other."""
        for axis in axes:
            half = float(np.linalg.norm(axis)) + 0.4 * u
            yield Piece(prism(0.34 * u, -half, half, 16).moved(basis(axis)), form.center, form.index, look, color)
        yield ball(form.center, 0.55 * u, look, color)

    def _fork(self, form: Figure, u: float, look: str, color: int) -> Iterator[Piece]:
        """A shaft along its bearing's axis that ends in a fork about the other axis."""
        bearing = self.forks[form.index]
        axes = dict(self._arms_of(form.index))
        shaft = axes.pop(bearing) * self.tip(bearing)
        (arm,) = axes.values()
        half, deep = _YOKE * self.radius * arm, _DEEP * self.radius * shaft / float(np.linalg.norm(shaft))
        turn = np.linspace(0.0, math.pi, _N_ARC + 1)[:, None]
        for part in tube(np.cos(turn) * half + np.sin(turn) * deep, 0.42 * u, 12):
            yield Piece(part, form.center, form.index, "fixed hoop" if look == "fixed body" else "hoop", color)
        length = float(np.linalg.norm(shaft - deep))
        bar = prism(0.5 * u, 0.0, length, 16).moved(basis(shaft), deep)
        yield Piece(bar, form.center, form.index, look, color)

    def _arms_of(self, index: int) -> Iterator[tuple[DrawnJoint, Array]]:
        """The joints of a body and their axes on its side, unit vectors along its own axes."""
        for joint in self.joints:
            if index in (joint.first.body, joint.second.body):
                arms = joint.arms if joint.arms is not None else (joint.axis, joint.axis)
                arm: Heading | None = arms[0] if joint.first.body == index else arms[1]
                if arm is not None:
                    yield joint, np.array(self.poses.turned_back(index, self.poses.heading(arm, 0), 0))


def _cones(scene: Scene) -> Iterator[tuple[Place, Place, float, float]]:
    """Bevel gears, each wheel with one of its partners, and the radii of their pitch circles."""
    for sign in scene.signs:
        match sign:
            case Toothed((first, second), (one, two)):
                yield first, second, one, two
                yield second, first, two, one
            case _:
                pass


def _other(joint: DrawnJoint, index: int) -> int:
    """The body on the other side of a joint."""
    return joint.second.body if joint.first.body == index else joint.first.body


def _is_thin(form: Figure, close: float) -> bool:
    """Whether a body has no form and all its points are one."""
    tips = [*(place.at for place in form.points.values()), (0.0, 0.0, 0.0)]
    far = max(float(np.linalg.norm(np.subtract(tip, form.center.at))) for tip in tips)
    return form.solid is NO_SOLID and not form.is_particle and far <= max(close, 1e-12)


def _arc(a: Array, b: Array) -> Array:
    """(n, 3) the shorter way round the origin from one point (3,) to another."""
    first, last = float(np.linalg.norm(a)), float(np.linalg.norm(b))
    start, cosine = a / first, max(-1.0, min(1.0, float(a @ b) / (first * last)))
    side = b / last - cosine * start
    length = float(np.linalg.norm(side))
    side = side / length if length > 1e-6 else basis(start)[0]
    share = np.linspace(0.0, 1.0, _N_ARC + 1)[:, None]
    turn = share * math.acos(cosine)
    return (first + share * (last - first)) * (np.cos(turn) * start + np.sin(turn) * side)
