"""Marks at the points where bodies touch, which show whether they press, stick or slip."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from freebody.language.expression import Expr
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Distance
from freebody.measures.geometry import Point
from freebody.messages import Message
from freebody.model.elements import UnilateralConstraint
from freebody.present.figures import Array, Heading, Place
from freebody.present.places import Places
from freebody.present.strokes import Path, Stretch
from freebody.present.symbols import circle
from freebody.system.system import System

if TYPE_CHECKING:
    from freebody.numeric.engine.course import ContactRecord

OPEN, PRESSES, STICKS, SLIPS = range(4)
STYLES = "", "presses", "sticks", "slips"  # of the states
MEANING = Message("Where bodies touch: a full dot sticks, an empty one slips, a small one has no friction.")
_SIZES = 0.0, 0.28, 0.4, 0.4
_MOST = 400  # places that ever touch; more would hide each other


@dataclass(frozen=True)
class Meeting:
    """Where a circle (or a point of radius 0) of a body touches something: at a distance `radius` from its centre
    along a direction (sense +1) or against it, or towards the centre of another circle, which is `apart` from it, or
    away from that."""

    center: Place
    radius: float
    toward: Heading | Place
    sense: int
    apart: float = 1.0

    def mark(self, size: float, style: str, surplus: float) -> Path | Stretch:
        """A small circle at the point; surplus: by how much the body is drawn thicker than it is."""
        points, reach = circle(size, 3), self.sense * (self.radius or surplus)
        if isinstance(self.toward, Heading):
            points = points + reach * np.array(self.toward.xy)
            return Path(self.center, self.toward.body, points, style, True)
        points = np.stack(((reach + points[:, 0]) / self.apart, points[:, 1]), axis=-1)
        return Stretch(self.center, self.toward, points, style, True)


@dataclass(frozen=True)
class ContactTrack:
    """Where bodies touch along a motion. states: (n_times, n_meetings) OPEN, PRESSES (without friction), STICKS or
    SLIPS."""

    meetings: tuple[Meeting, ...]
    states: NDArray[np.int8]

    @classmethod
    def of(cls, system: System, number: Callable[[Expr], float], record: ContactRecord | None) -> ContactTrack | None:
        """The places that touch at some time of a motion with this record; None if there are none, or too many to be
        told apart. number: of expressions, such as `Reference.number`."""
        if record is None or not 0 < record.states.any(axis=0).sum() <= _MOST:
            return None
        places = Places(system, number)
        bounds = {bound.name: bound for bound in system.bounds[len(system.limits) :]}
        dry_friction = {rub.of: rub.name for rub in system.dry_friction if rub.of}
        meetings: list[Meeting] = []
        columns: list[NDArray[np.int8]] = []
        for k, name in enumerate(record.bounds):
            meeting = _meeting(system, places, bounds[name]) if name in bounds and record.states[:, k].any() else None
            if meeting is None:
                continue
            slip = (
                record.slips[:, record.dry_friction.index(dry_friction[name])] if name in dry_friction else np.int8(2)
            )
            state = np.where(slip == 0, STICKS, np.where(np.abs(slip) == 1, SLIPS, PRESSES))
            meetings.append(meeting)
            columns.append(np.where(record.states[:, k] > 0, state, OPEN).astype(np.int8))
        return cls(tuple(meetings), np.stack(columns, axis=1)) if meetings else None

    def at(self, times: Array, shown: Array) -> ContactTrack:
        """The same at other times: the states of the last time before each."""
        last = np.searchsorted(times, shown * (1 + 1e-12), side="right") - 1
        return ContactTrack(self.meetings, self.states[np.clip(last, 0, len(times) - 1)])

    def marks(self, size: float, surplus: Mapping[int, float]) -> Iterator[tuple[int, int, Path | Stretch]]:
        """For every meeting and every state it has at some time: its number, the state, and the mark of that. size: of
        symbols [m]; surplus: of bodies, by index, how much thicker than they are they are drawn [m]."""
        for k, meeting in enumerate(self.meetings):
            for state in (PRESSES, STICKS, SLIPS):
                if (self.states[:, k] == state).any():
                    thicker = surplus.get(meeting.center.body, 0.0)
                    yield k, state, meeting.mark(_SIZES[state] * size, STYLES[state], thicker)


def _meeting(system: System, places: Places, bound: UnilateralConstraint) -> Meeting | None:
    measure, sign = bound.row.measure, bound.row.sign
    if isinstance(measure, Displacement):
        radius = _radius(system, places, measure.of)
        return Meeting(places.place(measure.of), radius, places.heading(measure.along), -sign)
    if isinstance(measure, Distance) and bound.row.target is not None:
        apart, radius = places.number(bound.row.target), _radius(system, places, measure.end)
        return Meeting(places.place(measure.end), radius, places.place(measure.start), sign, apart) if apart else None
    return None


def _radius(system: System, places: Places, point: Point) -> float:
    """Of the circle of which a point is the centre; 0 for other points."""
    body = system.bodies[point.body]
    if body.radius is None or point.offset != body.center.offset:
        return 0.0
    return places.number(body.radius)
