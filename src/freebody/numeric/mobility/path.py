"""The way of a mechanism with one freedom along an input: its limits, and the poses where it is singular.

The poses are a curve (`curve`), which is followed both ways (`walk`); branches of it meet at change points
(`crossings`). The input m has a dead point where m' = grad m . t changes sign, with t the unit tangent.
Source: Gosselin & Angeles, IEEE Trans. Robotics and Automation 6, 1990, 281-290; and those of the modules named.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Literal

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message, further
from freebody.language.units import DIMENSIONLESS, LENGTH
from freebody.measures.base import Measure
from freebody.numeric.jets import Array
from freebody.numeric.mobility.crossings import other_branch
from freebody.numeric.mobility.curve import Mechanism, Station, regular_start
from freebody.numeric.mobility.walk import FAR, Walk, follow, joined, touches
from freebody.numeric.reference import Reference
from freebody.tolerances import ROUND_OFF

_LAST_DIGIT = 1e-15  # of a way, and of a rate: no search comes nearer

Kind = Literal["dead point", "change point", "output dead point"]


@dataclass(frozen=True)
class PathPoint:
    """A pose of interest on a path."""

    kind: Kind
    input: float
    q: Array
    what: str
    value: float | None = None  # of the output, where that has its dead point
    branch: Array | None = None  # at a change point: the direction (by speeds) of the branch that is not followed


@dataclass(frozen=True)
class MotionPath:
    """Poses along the motion of one freedom; the input counts on through full turns."""

    inputs: Array  # (n,)
    poses: Array  # (n, n_q)
    is_closed: bool
    is_unbounded: bool
    full_turn: bool  # the input turns through whole turns without a dead point
    period: float | None  # of the input, after which the poses repeat, if it has no dead point
    reach: tuple[float, float] | None  # limits of the input, infinite where there is none; None: unlimited
    points: tuple[PathPoint, ...]  # in the order of the path
    note: str = ""

    def of_kind(self, kind: Kind) -> list[PathPoint]:
        return [point for point in self.points if point.kind == kind]


def trace(
    reference: Reference,
    q: Array,
    measure: Measure,
    released: Sequence[str] = (),
    t: float = 0.0,
    outputs: Mapping[str, Measure] | None = None,
    n_steps: int = 2000,
) -> MotionPath:
    """The whole motion through the pose q (n_q,) in which everything is held but the connections `released`, by the
    input `measure`; dead points of the `outputs` are named by their keys. Drivers that stay are at the time t [s].

    At most `n_steps` poses each way. Raises CannotAnswer, if what remains has not exactly one freedom, if the input
    does not move with it, and for velocity constraints. Source: see the module."""
    outputs = outputs or {}
    mechanism = Mechanism(reference, q, (measure, *outputs.values()), released, t)
    x, note = regular_start(mechanism, mechanism.chart.x(q))
    start = mechanism.first(x)
    walk = follow(mechanism, start, n_steps)
    if not walk.is_closed:
        walk = joined(follow(mechanism, start.reversed(), n_steps), walk)
    return _surveyed(mechanism, walk, outputs, note)


def singular_at(
    reference: Reference, q: Array, measure: Measure, released: Sequence[str] = (), t: float = 0.0
) -> list[Kind]:
    """What the pose q itself is, with the connections `released` left out.

    A change point: the rows have a smaller rank than nearby. A dead point: with the input held as well a motion is
    left to first order that is not left nearby; at a change point this may be so too. Raises CannotAnswer for
    velocity constraints."""
    mechanism = Mechanism(reference, q, (measure,), released, t)
    x = mechanism.chart.x(q)
    poses = mechanism.nearby(x)
    if not poses:
        return []
    with_input: dict[Kind, bool] = {"dead point": True, "change point": False}
    return [
        kind
        for kind, also in with_input.items()
        if mechanism.nullity(x, also) > min(mechanism.nullity(y, also) for y in poses)
    ]


# -- what is found on it ----------------------------------------------------------------------
_Placed = tuple[float, PathPoint]  # where on the path, in stations


def _surveyed(mechanism: Mechanism, walk: Walk, outputs: Mapping[str, Measure], note: str) -> MotionPath:
    stations = walk.stations
    inputs = np.array([station.values[0] for station in stations])
    _must_move(mechanism, stations)
    dead = list(_dead_points(mechanism, stations, 0, mechanism.name))
    found = dead + list(_change_points(mechanism, walk))
    for k, name in enumerate(outputs, start=1):
        found += _dead_points(mechanism, stations, k, name)
    limits = [point.input for _place, point in dead]
    is_angle = mechanism.measures[0].dimension == DIMENSIONLESS
    full_turn = is_angle and not dead and (walk.is_closed or float(np.ptp(inputs)) >= math.tau)
    notes = [note, *(_ending(mechanism, stations[-k], walk.ends[k]) for k in (0, 1))]
    return MotionPath(
        inputs=inputs,
        poses=np.array([mechanism.chart.q(station.x) for station in stations]),
        is_closed=walk.is_closed,
        is_unbounded="far" in walk.ends,
        full_turn=full_turn,
        period=abs(float(inputs[-1] - inputs[0])) if full_turn and walk.is_closed else None,
        reach=None if full_turn else _reach(walk, limits),
        points=tuple(point for _place, point in sorted(found, key=lambda placed: placed[0])),
        note=further(*dict.fromkeys(text for text in notes if text)),
    )


def _must_move(mechanism: Mechanism, stations: Sequence[Station]) -> None:
    size = mechanism.reference.sizes.length if mechanism.measures[0].dimension == LENGTH else 1.0
    if max(abs(float(station.rates[0])) for station in stations) < ROUND_OFF * size:
        raise CannotAnswer(
            Message(
                "{x} stays at {value:.6g} while the rest moves, so it is no input of this "
                "motion. Name a measure that moves",
                x=mechanism.name,
                value=stations[0].values[0],
            )
        )


def _dead_points(mechanism: Mechanism, stations: Sequence[Station], k: int, name: str) -> Iterator[_Placed]:
    """Where the rate of the k-th measure changes its sign."""
    rates = np.array([station.rates[k] for station in stations])
    size = mechanism.reference.sizes.length if mechanism.measures[k].dimension == LENGTH else 1.0
    if float(np.abs(rates).max()) < ROUND_OFF * size:
        return
    # a rate that is zero but for round-off at a station has no sign of its own: those around it decide
    clear = [i for i in range(len(stations)) if abs(rates[i]) > ROUND_OFF * size]
    for i, j in pairwise(clear):
        a, b = stations[i], stations[j]
        if (rates[i] >= 0.0) == (rates[j] >= 0.0):
            continue
        here, part = _still(mechanism, a, b, k)
        is_upper = a.rates[k] >= 0.0
        kind: Kind = "dead point" if k == 0 else "output dead point"
        what = Message("upper limit of {x}" if is_upper else "lower limit of {x}", x=name)
        if k:
            what = Message("{x} is largest" if is_upper else "{x} is smallest", x=name)
        value = float(here.values[k]) if k else None
        yield i + part * (j - i), PathPoint(kind, float(here.values[0]), mechanism.chart.q(here.x), what, value)


def _still(mechanism: Mechanism, a: Station, b: Station, k: int) -> tuple[Station, float]:
    """The station between two at which the rate of the k-th measure is zero, and how far on the way it is.
    Source of the secant that does not stall: Dowell & Jarratt, BIT 11, 1971, 168-174 (Illinois)."""
    length = float(np.linalg.norm(b.x - a.x))
    low, high, at_low, at_high = 0.0, length, float(a.rates[k]), float(b.rates[k])
    best, tiny = (a, low) if abs(at_low) < abs(at_high) else (b, high), _LAST_DIGIT * length
    for _ in range(60):
        if high - low <= tiny or at_low == at_high:
            break
        place = (low * at_high - high * at_low) / (at_high - at_low)
        station = mechanism.between(a, b, place)
        if station is None:
            break
        rate = float(station.rates[k])
        if abs(rate) < abs(float(best[0].rates[k])):
            best = station, place
        if abs(rate) <= _LAST_DIGIT * (abs(a.rates[k]) + abs(b.rates[k])):
            break
        if (rate >= 0.0) == (at_high >= 0.0):
            high, at_high, at_low = place, rate, 0.5 * at_low
        else:
            low, at_low, at_high = place, rate, 0.5 * at_high
    return best[0], best[1] / length


def _change_points(mechanism: Mechanism, walk: Walk) -> Iterator[_Placed]:
    found = [(i + 0.5, change) for i, change in enumerate(walk.changes) if change is not None]
    for place, change in [*found, *touches(mechanism, walk)]:
        q = mechanism.chart.q(change.x)
        g = mechanism.reference.geometry(q, np.zeros_like(q), mechanism.t, walk.stations[int(place)].near)
        value = mechanism.reference.jet(g, mechanism.measures[0], mechanism.name).value
        branch = other_branch(mechanism, change)
        n_free = mechanism.nullity(change.x)
        what = Message("another branch leaves" if branch is not None else "to second order no other branch leaves")
        if n_free > 2:
            what = Message("{n} motions to first order; which of them go on is not worked out", n=n_free)
        yield place, PathPoint("change point", value, q, what, branch=branch)


def _reach(walk: Walk, limits: Sequence[float]) -> tuple[float, float] | None:
    """The least and the largest input; infinite where it goes on growing as the motion goes beyond every bound."""
    marks = list(limits)
    for k, sense in ((0, -1.0), (-1, 1.0)):
        if walk.is_closed:
            break
        station = walk.stations[k]
        rate = sense * float(station.rates[0])
        goes_on = walk.ends[k] == "far" and abs(rate) > 1e-2 * float(np.abs(station.slopes[0]).max())
        marks.append(math.copysign(math.inf, rate) if goes_on else float(station.values[0]))
    reach = min(marks), max(marks)
    return None if reach == (-math.inf, math.inf) else reach


def _ending(mechanism: Mechanism, station: Station, end: str) -> str:
    x, value = mechanism.name, float(station.values[0])
    match end:
        case "far":
            return Message("the motion goes on beyond {n:g} sizes of the system", n=FAR)
        case "stuck":
            return Message(
                "no way on was found at {x} = {value:.6g}: the poses beyond are singular, or a measure has no value "
                "there",
                x=x,
                value=value,
            )
        case "long":
            return Message(
                "the path was left at {x} = {value:.6g} before it closed; more n_steps follow it further",
                x=x,
                value=value,
            )
        case _:
            return ""
