"""Lines through bodies: an axle has to come out of the bodies that it holds together."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from freebody.present.figures import Array, Figure, Place
from freebody.present.scene import Scene
from freebody.present.space.bodies import convex, planes
from freebody.present.space.figures import Poses
from freebody.present.space.solids import Solid

DEEP = 5.0  # an axle that would run farther than this inside a body ends in it


class Cuts:
    """The bodies of a scene at its first instant, to be cut by lines; u: [m] the size of symbols."""

    def __init__(self, scene: Scene, poses: Poses, u: float) -> None:
        self.poses, self.u = poses, u
        self.forms = {form.index: form for form in scene.figures}
        self.solids = {form.index: convex(form, u) for form in scene.figures}

    def inside(self, places: Iterable[Place], along: Array, deep: float | None = None) -> tuple[float, float]:
        """From where to where along a line (3,) through places of bodies it is inside one of them; a way of more than
        `deep` (a few symbols if nothing is said) counts as none."""
        limit = DEEP * self.u if deep is None else deep
        low = high = 0.0
        for place in places:
            form = self.forms.get(place.body)
            if form is None:
                continue
            ends = _span(form, self.solids[place.body], np.array(place.at), self.poses.axes[0, place.body].T @ along)
            low = min(low, ends[0] if ends[0] > -limit else 0.0)
            high = max(high, ends[1] if ends[1] < limit else 0.0)
        return low, high


def _span(form: Figure, solid: Solid | None, at: Array, along: Array) -> tuple[float, float]:
    """Where a line is inside a body; (0, 0) if it is not. Source: Cyrus & Beck, Computers & Graphics 3 (1978) 23."""
    if form.solid.is_ball:
        way = at - np.array(form.center.at)
        middle = -float(way @ along)
        square = form.sizes[0] ** 2 - float(way @ way) + middle**2
        return (middle - square**0.5, middle + square**0.5) if square > 0 else (0.0, 0.0)
    if solid is None or form.solid.is_sheet:
        return 0.0, 0.0
    low, high = -np.inf, np.inf
    for normal, point in planes(solid):
        slope, room = float(normal @ along), float(normal @ (point - at))
        if abs(slope) < 1e-9:
            if room < -1e-9:
                return 0.0, 0.0
        elif slope > 0:
            high = min(high, room / slope)
        else:
            low = max(low, room / slope)
    return (float(low), float(high)) if -np.inf < low < high < np.inf else (0.0, 0.0)
