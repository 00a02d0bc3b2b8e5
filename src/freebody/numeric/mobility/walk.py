"""The curve of poses followed by pseudo-arclength: a predictor along the tangent, bent as the curve was last, then
Newton steps in the plane across it.

The step is chosen by how far the tangent turns. Where the determinant of the curve changes its sign (see `curve`) on
the way, there is a change point, or the step went over a sharp bend onto another branch.
Source: Allgower & Georg, Numerical Continuation Methods, 1990, ch. 6.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from freebody.numeric.jets import Array
from freebody.numeric.mobility.crossings import ChangePoint, crossing, touching
from freebody.numeric.mobility.curve import Mechanism, Station, flip, overlap

FAR = 50.0  # sizes of the system, beyond which a motion counts as unbounded
_CLEAR = 1e-6  # the least singular value on the way, which steps pass no change point to reach
_SAME, _ALONG = 1e-6, 1e-4  # the start again, by its place and by its tangent [rad]
_LONGEST, _SHORTEST = 0.25, 1e-6  # steps, by the coordinate that moves most: sizes or radians
_TURN = 0.2  # what the tangent should turn in a step [rad]


@dataclass(frozen=True)
class Walk:
    """Stations in their order, the change points on the way to each next one, and how it ends at both ends."""

    stations: list[Station]
    changes: list[ChangePoint | None]
    ends: tuple[str, str]  # "closed", "far", "stuck", "long" or "" where it begins
    is_closed: bool = False


def joined(behind: Walk, ahead: Walk) -> Walk:
    stations = [station.reversed() for station in reversed(behind.stations[1:])] + ahead.stations
    return Walk(stations, behind.changes[::-1] + ahead.changes, (behind.ends[1], ahead.ends[1]))


def follow(mechanism: Mechanism, start: Station, n_steps: int) -> Walk:
    """From the start along its tangent, until the curve closes or goes no further."""
    here, stations, changes = start, [start], list[ChangePoint | None]()
    step, bend, end = 0.1, np.zeros_like(start.x), "long"
    for _ in range(8 * n_steps):
        if len(stations) > n_steps:
            break
        if step < _SHORTEST:
            end = "stuck"
            break
        length = step / float(np.abs(here.tangent).max())
        last = _closing(mechanism, start, here, length) if len(stations) > 3 else None
        there = last or _next(mechanism, here, length, bend)
        if there is None:
            step *= 0.5
            continue
        change = None
        if flip(here, there) < 0.0:
            change = crossing(mechanism, here, there)
            if change is None and step > 8.0 * _SHORTEST:
                step *= 0.25  # over a sharp bend onto another branch
                continue
        stations.append(there)
        changes.append(change)
        if last is not None:
            return Walk(stations, changes, ("", "closed"), is_closed=True)
        if float(np.abs(there.x - start.x)[~mechanism.chart.turning].max(initial=0.0)) > FAR:
            end = "far"
            break
        chord = float(np.linalg.norm(there.x - here.x))
        turned = _angle(here.tangent, there.tangent)
        bend = (there.tangent - here.tangent) / chord
        step = min(_LONGEST, step * min(1.6, max(0.5, _TURN / max(turned, 1e-9))))
        here = there
    return Walk(stations, changes, ("", end))


def _next(mechanism: Mechanism, here: Station, length: float, bend: Array) -> Station | None:
    """A step along the curve; None if it is too long, or ends too near to a singular pose."""
    guess = here.x + length * here.tangent + 0.5 * length**2 * bend
    found = mechanism.corrected(guess, here.tangent, here.near)
    if found is None or float(np.linalg.norm(found[0] - guess)) > 0.3 * length:
        return None
    there = mechanism.station(*found, here.tangent)
    is_smooth = _angle(here.tangent, there.tangent) <= 2.5 * _TURN and abs(overlap(here, there)) > 0.3
    return there if is_smooth and there.sigma > _CLEAR else None


def _closing(mechanism: Mechanism, start: Station, here: Station, length: float) -> Station | None:
    """The start again, up to full turns, if it lies within two steps ahead."""
    x, tangent = mechanism.chart.again(start.x, start.tangent, here.x)
    way = x - here.x
    ahead, distance = float(way @ here.tangent), float(np.linalg.norm(way))
    if not 0.0 < ahead <= 2.0 * length or distance > 1.1 * ahead or _angle(tangent, here.tangent) > 2.5 * _TURN:
        return None
    found = mechanism.corrected(x, tangent, here.near)
    if found is None or float(np.linalg.norm(found[0] - x)) > _SAME:
        return None
    there = mechanism.station(*found, here.tangent)
    return there if _angle(tangent, there.tangent) < _ALONG else None


def _angle(a: Array, b: Array) -> float:
    return 2.0 * math.asin(min(1.0, 0.5 * float(np.linalg.norm(a - b))))


def touches(mechanism: Mechanism, walk: Walk) -> Iterator[tuple[int, ChangePoint]]:
    """Change points where the determinant keeps its sign, with the station that they are near to."""
    stations, changes = list(walk.stations), list(walk.changes)
    if walk.is_closed:
        x, tangent = mechanism.chart.again(stations[1].x, stations[1].tangent, stations[-1].x)
        stations.append(replace(stations[1], x=x, tangent=tangent))
        changes.append(changes[0])
    low = 0.5 * max(station.sigma for station in stations)
    for i in range(1, len(stations) - 1):
        a, here, b = stations[i - 1 : i + 2]
        if here.sigma > min(a.sigma, b.sigma, low) or changes[i - 1] or changes[i]:
            continue
        change = touching(mechanism, a, b)
        if change is not None:
            yield i, change
