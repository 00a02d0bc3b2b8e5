"""From where most of a system in space is seen: from the side where its axes lie in one plane, else from above.

A plane that holds every joint and at least two axes that are not parallel is the plane of the drawing in a textbook:
seen along its normal, lengths and angles have their true size. Couples are arcs only from elsewhere, and a plane that
does not hold the vertical is seen from above too.
"""

from __future__ import annotations

import math

import numpy as np

from freebody.model.glyphs import MomentArrow
from freebody.present.figures import Array, Place
from freebody.present.scene import Scene
from freebody.present.space.figures import Poses, joints_of, poses_of
from freebody.present.view import AZIMUTH, ELEVATION, horizontals

_PARALLEL = 1e-3  # sine of the angle between axes that are one
_FLAT = 1e-6  # of the size of what lies in the plane


def best_angles(scene: Scene, centers: Array, axes: Array) -> tuple[float, float]:
    """Azimuth and elevation [deg]. centers: (1, n_moving, 3); axes: (1, n_moving, 3, 3)."""
    poses = poses_of(scene, centers, axes)
    normal = None if any(isinstance(sign, MomentArrow) for sign in scene.signs) else _normal(scene, poses)
    if normal is None or abs(float(normal @ scene.up)) > _FLAT:
        return AZIMUTH, ELEVATION
    # from the positive side of the axis that is nearest
    normal = normal * float(np.sign(normal[int(np.abs(normal).argmax())]))
    front, right = horizontals(scene.up)
    return round(math.degrees(math.atan2(float(normal @ right), float(normal @ front))), 6), 0.0


def _normal(scene: Scene, poses: Poses) -> Array | None:
    """(3,) that of the plane in which all joints, bodies and axes lie."""
    joints = list(joints_of(scene, poses))
    turned = [poses.heading(joint.axis, 0) for joint in joints if joint.axis is not None]
    turned += [poses.heading(arm, 0) for joint in joints for arm in joint.arms or ()]
    own = [form for form in scene.figures if form.solid.is_round and form.axis is not None]
    turned += [poses.axes[0, form.index] @ np.array(form.axis) for form in own]
    places = [poses.place(place, 0) for joint in joints for place in (joint.first, joint.second)]
    places += [poses.place(place, 0) for form in scene.figures for place in (form.center, *form.path)]
    places += [poses.place(end, 0) for form in scene.figures if len(form.corners) == 2 for end in form.corners]
    parts = [(form, part) for form in scene.figures for part in form.parts]
    places += [poses.place(Place(form.index, *part.at), 0) for form, part in parts]
    if len(turned) < 2 or len(joints) < 2:
        return None
    across = np.cross(turned[0], np.array(turned[1:]))
    widest = across[int(np.linalg.norm(across, axis=1).argmax())]
    size = float(np.linalg.norm(widest))
    if size < _PARALLEL:
        return None
    normal = widest / size
    away = np.array(places) - places[0]
    reach = float(np.abs(away).max()) or 1.0
    is_flat = np.abs(np.array(turned) @ normal).max() < _FLAT and np.abs(away @ normal).max() < _FLAT * reach
    return normal if is_flat else None
