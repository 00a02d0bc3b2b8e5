"""Bodies without extent: the model gives their inertia and the axes of their joints, all through one point.

Such bodies move as if on spheres. They are drawn with a made-up radius: an arc between the axes of two joints, a wheel
on the axis of a single one, a ball without any.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from freebody.present.figures import Array, Figure, Heading
from freebody.present.scene import Scene
from freebody.present.space.bodies import reach
from freebody.present.space.figures import Joint, Poses, joints_of
from freebody.present.space.pieces import Piece, ball
from freebody.present.space.solids import basis, marked, prism, tube

_SHARE = 0.16  # of the size of a scene that has one
_ROOM = 1.35  # round a solid at the same place
_WHEEL = 0.38  # of the radius of the sphere
_ASIDE = 0.62  # where wheels stand if there are several
_CLOSE = 0.7  # cosine of the angle within which two axes of the ground are drawn on different sides
_FARTHER = 0.22  # of the radius, for the next one on the same side
_N_ARC = 24


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
        self.radius = max(_SHARE * size, _ROOM * max(near, default=0.0)) or 1.0
        self.joints = tuple(joints_of(scene, poses))
        self._tips: dict[Joint, float] = {}
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
            self._tips[joint] = sign * self.radius * (1.0 + _FARTHER * level)
            if is_held:
                taken.append(sign * along)
        single = [index for index in self.forms if len(self._axes(index)) == 1]
        self._places = {index: _ASIDE * self.radius if len(single) > 1 else 0.0 for index in single}

    def tip(self, joint: Joint) -> float:
        """[m] where along its axis a joint of a body without extent is drawn; 0 for other joints."""
        return self._tips.get(joint, 0.0)

    def _bodies(self, joint: Joint) -> list[int]:
        return [place.body for place in (joint.first, joint.second) if place.body in self.forms]

    def _axes(self, index: int) -> list[Array]:
        """Where the joints of a body are drawn (3,) [m], along its own axes."""
        found: list[Array] = []
        for joint in self.joints:
            if index not in (joint.first.body, joint.second.body):
                continue
            arms = joint.arms if joint.arms is not None else (joint.axis, joint.axis)
            arm: Heading | None = arms[0] if joint.first.body == index else arms[1]
            if arm is not None:
                along = self.poses.heading(arm, 0) * self._tips.get(joint, self.radius)
                found.append(np.array(self.poses.turned_back(index, along, 0)))
        return found

    def pieces(self, form: Figure, u: float) -> Iterator[Piece]:
        """u: [m] the size of symbols."""
        is_fixed = self.scene.is_fixed(form.index)
        look, color = ("fixed body", -1) if is_fixed else ("body", form.number)
        middle = form.center
        axes = self._axes(form.index)
        if not axes:
            yield ball(middle, 0.3 * self.radius, look, color, has_circles=True)
        elif len(axes) == 1:
            far = float(np.linalg.norm(axes[0]))
            at = self._places[form.index] * axes[0] / far
            wheel = marked(prism(_WHEEL * self.radius, -0.5 * u, 0.5 * u)).moved(basis(axes[0]), at)
            yield Piece(wheel, middle, form.index, look, color)
            ends = self._places[form.index], far
            shaft = prism(0.3 * u, ends[0] + 0.5 * u, ends[1], 12).moved(basis(axes[0]))
            yield Piece(shaft, middle, form.index, look, color)
        for a, b in pairwise(axes):
            for part in tube(_arc(a, b), 0.42 * u, 12):
                yield Piece(part, middle, form.index, "fixed hoop" if is_fixed else "hoop", color)


def _is_thin(form: Figure, close: float) -> bool:
    """Whether a body has no form and all its points are one."""
    tips = [*(place.at for place in form.points.values()), (0.0, 0.0, 0.0)]
    far = max(float(np.linalg.norm(np.subtract(tip, form.center.at))) for tip in tips)
    return not form.solid and not form.is_particle and far <= max(close, 1e-12)


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
