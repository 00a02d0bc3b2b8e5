"""Vehicles of the plane whose axles run along one straight line of the ground: they stand on wheels on a road.

Pins of one body in slots along one line hold it as wheels do that keep on the road. Where gravity presses them on the
line, and the body is above it, the slots are drawn as wheels that touch the road at the pins.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace

import numpy as np

from freebody.model.glyphs import Field, Rail, Roller, Track
from freebody.present.figures import GROUND, Array, Heading, Place, ShownGlyph

Wheel = Roller[Place, float]
Road = Track[Place, Heading, float]

# radius of a wheel, by the distance of the axles and by the height of the mass centre
_OF_WHEELBASE, _OF_HEIGHT = 0.12, 0.8
_STEEPEST = 0.3  # sine of the angle of the road to the vertical


def on_wheels(shown: Iterable[ShownGlyph]) -> Iterator[ShownGlyph]:
    """The glyphs, with a wheel and its road instead of the slot of each axle of a vehicle. The axes of the body and of
    the ground are parallel where the axles lie in the direction of the slots, which is looked at."""
    every = tuple(shown)
    gravity = next((s.sign.along for s in every if isinstance(s.sign, Field)), None)
    wheels: Mapping[int, tuple[Wheel, Road]] = {} if gravity is None else _wheels(every, gravity)
    for k, item in enumerate(every):
        if k not in wheels:
            yield item
        else:
            yield from (replace(item, sign=sign) for sign in wheels[k])


def _wheels(shown: tuple[ShownGlyph, ...], gravity: Heading) -> Mapping[int, tuple[Wheel, Road]]:
    """A wheel and its road, by the number of the glyph of its slot."""
    slots = {
        k: item.sign
        for k, item in enumerate(shown)
        if isinstance(item.sign, Rail) and item.sign.turning != "not" and item.sign.along.body == GROUND
    }
    found: dict[int, tuple[Wheel, Road]] = {}
    for k, slot in slots.items():
        along = np.array(slot.along.xy)
        side = -1.0 if float(np.array(slot.along.normal().xy) @ np.array(gravity.xy)) > 0.0 else 1.0
        up = side * np.array(slot.along.normal().xy)
        others = [other.point for other in slots.values() if _is_beside(slot, other, along)]
        height = -float(np.array(slot.point.xy) @ up)
        if slot.point.body == GROUND or not others or height <= 0.0 or -float(up @ np.array(gravity.xy)) < _STEEPEST:
            continue
        base = max(abs(float((np.array(at.xy) - np.array(slot.point.xy)) @ along)) for at in others)
        radius = min(_OF_WHEELBASE * base, _OF_HEIGHT * height)
        center = Place(slot.point.body, *map(float, np.array(slot.point.xy) + radius * up))
        found[k] = Roller(center, radius), Track(center, slot.along, side * radius)
    return found


def _is_beside(slot: Rail[Place, Heading], other: Rail[Place, Heading], along: Array) -> bool:
    """Whether another slot of the same body lies on the same line, with the body's axes parallel to those of the
    ground."""
    arm = np.array(other.point.xy) - np.array(slot.point.xy)
    length = float(np.hypot(*arm))
    if other.point.body != slot.point.body or length < 1e-9:
        return False
    turns = (float(arm[0] * along[1] - arm[1] * along[0]), slot.along.x * other.along.y - slot.along.y * other.along.x)
    return max(abs(turns[0]) / length, abs(turns[1])) < 1e-9
