"""The phases of a hybrid motion, concatenated to one trajectory."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from dataclasses import dataclass, fields, replace
from typing import Any

import numpy as np

from freebody.language.units import LENGTH
from freebody.numeric.contact.bounded import Bounded
from freebody.numeric.contact.rows import FrictionRow, ModeOf
from freebody.numeric.contact.stillness import STILL
from freebody.numeric.engine.course import (
    BlowRecord,
    Collision,
    ContactRecord,
    Event,
    RotationHistory,
    Status,
    Tracks,
    Trajectory,
)
from freebody.numeric.engine.engine import Engine
from freebody.numeric.kernels import kinematics, stepping
from freebody.numeric.kernels.arrays import Floats

BESIDE = 1e-6  # of a radius: so far from a line is beside it
ABSENT = 2  # in `ContactRecord.slips`: no friction


@dataclass(frozen=True)
class PhaseRecord:
    """A part of a motion in one mode."""

    course: Trajectory
    engine: Engine
    mode: ModeOf


def merged(
    bounded: Bounded,
    phases: list[PhaseRecord],
    status: Status,
    message: str,
    wall: float,
    events: tuple[Event, ...],
    collisions: tuple[Collision, ...],
    blows: tuple[BlowRecord, ...] = (),
    borders: Collection[str] = (),
) -> Trajectory:
    """One course of all phases. At an instant between two phases it has the state after it; multipliers are those of
    all rows that may be held, zero where they are not, and friction forces where friction slides."""
    courses = [phase.course for phase in phases]
    parts = _parts(courses, borders)
    kept = {k for k, (_course, part) in enumerate(parts) if part.stop > part.start}

    # (n_times, n_rows) of all rows that may be held, and (n_times, n_barriers), (n_times, n_drags) of the modes
    multipliers, unique, states, slips = (
        np.concatenate([table[parts[k][1]] for k, table in enumerate(tables) if k in kept])
        for tables in zip(*(_rows(bounded, phase) for phase in phases), strict=True)
    )
    whole = _joined(courses, parts, multipliers, unique.astype(bool))
    return replace(
        whole,
        status=status,
        message=message,
        events=tuple(e for e in events if e.time <= whole.times[-1] or e.kind == "comes to rest"),
        wall_time=wall,
        contact=ContactRecord(
            tuple(b.name for k, b in enumerate(bounded.barriers) if k not in bounded.ends.stands_for),
            tuple(d.name for k, d in enumerate(bounded.drags) if k not in bounded.ends.rubs_for),
            states.astype(np.int8),
            slips.astype(np.int8),
            collisions,
            len(phases),
            blows,
            frozenset(bounded.blows[k].name for k in bounded.past),
        ),
    )


def in_one(courses: Sequence[Trajectory], borders: Collection[str]) -> Trajectory:
    """One course of parts in which the same rows are held. borders: events at which parts end."""
    if len(courses) == 1:
        return courses[0]
    parts = _parts(courses, borders)
    multipliers, unique = (
        np.concatenate([getattr(course, name)[part] for course, part in parts]) for name in ("multipliers", "unique")
    )
    return _joined(courses, parts, multipliers, unique)


def _parts(courses: Sequence[Trajectory], borders: Collection[str]) -> list[tuple[Trajectory, slice]]:
    """Of every course the outputs before the next one begins: at the instant between them the state after it counts. On
    a border, where a law has a corner, there is no output."""
    following = [*(course.times[0] for course in courses[1:]), np.inf]
    begins = [0, *(int(course.ends_at(borders)) for course in courses[:-1])]
    return [
        (course, slice(begin, int(np.searchsorted(course.times, then, side="left"))))
        for course, begin, then in zip(courses, begins, following, strict=True)
    ]


def _joined(
    courses: Sequence[Trajectory], parts: list[tuple[Trajectory, slice]], multipliers: Floats, unique: Any
) -> Trajectory:
    """What courses that follow each other are together, of which these parts count. multipliers, unique: (n_times,
    n_rows) of all of them."""
    last, filled = courses[-1], [(course, part) for course, part in parts if part.stop > part.start]

    def joined(name: str) -> Floats:
        return np.concatenate([getattr(course, name)[part] for course, part in filled])

    with_tracks = [c.tracks for c in courses if len(c.tracks.times)]
    return replace(
        last,
        times=joined("times"),
        poses=joined("poses"),
        velocities=joined("velocities"),
        accelerations=joined("accelerations"),
        multipliers=multipliers,
        unique=unique,
        work=joined("work"),
        events=tuple(event for course in courses for event in course.events),
        n_steps=sum(c.n_steps for c in courses),
        n_evaluations=sum(c.n_evaluations for c in courses),
        n_rejected=sum(c.n_rejected for c in courses),
        n_regularised=sum(c.n_regularised for c in courses),
        wall_time=sum(c.wall_time for c in courses),
        place_gap=max(c.place_gap for c in courses),
        motion_gap=max(c.motion_gap for c in courses),
        tracks=Tracks(
            with_tracks[0].keys,
            np.concatenate([t.times for t in with_tracks]),
            np.concatenate([t.bearings for t in with_tracks]),
        )
        if with_tracks
        else last.tracks,
        violated=-1,
        rotation=_rotation(filled),
        steps=None,
    )


def beside_its_way(bounded: Bounded, phase: PhaseRecord) -> tuple[int, int] | None:
    """The first output of a phase at which a flat end slides with its pressure beside the line through its middle along
    which it does, and that end, by its barrier. The pressure N at c from the middle has the moment M = c x N m about
    it, m the normal, and friction along u there the moment -mu N m . (c x u) = mu M . u about m."""
    held = {place: column for column, place in enumerate(bounded.held_in(phase.mode))}
    found: list[tuple[int, int]] = []
    for end in bounded.ends.ends:
        if end.flat not in phase.mode.closed:
            continue
        moment = bounded.drags[end.moment]
        for k, drag in enumerate(bounded.drags):
            state = phase.mode.drags[k]
            if drag.of != end.flat or not state or drag.rub.row.measure.dimension != LENGTH:
                continue
            M = phase.course.multipliers[:, [held[moment.keeps], held[moment.keeps_across]]]
            (_p, one), (_q, other) = _components(bounded, phase, k, state)
            pressed = np.abs(phase.course.multipliers[:, held[bounded.barriers[end.flat].place]])
            beside = np.abs(M[:, 0] * one + M[:, 1] * other) > BESIDE * end.radius * pressed
            found += [(int(np.argmax(beside)), end.flat)] if beside.any() else []
    return min(found, default=None)


def cut(course: Trajectory, n: int) -> Trajectory:
    """The first outputs of a course."""
    names = ("times", "poses", "velocities", "work", "accelerations", "multipliers", "unique")
    rotation = course.rotation
    if rotation is not None:
        rotation = RotationHistory(**{f.name: getattr(rotation, f.name)[:n] for f in fields(RotationHistory)})
    return replace(course, rotation=rotation, **{name: getattr(course, name)[:n] for name in names})


def _rotation(parts: list[tuple[Trajectory, slice]]) -> RotationHistory | None:
    """How bodies turn along all phases, in space."""
    known = [(course.rotation, part) for course, part in parts if course.rotation is not None and part.stop > 0]
    if not known:
        return None
    return RotationHistory(
        **{f.name: np.concatenate([getattr(r, f.name)[part] for r, part in known]) for f in fields(RotationHistory)}
    )


def _rows(bounded: Bounded, phase: PhaseRecord) -> tuple[Floats, Floats, Floats, Floats]:
    """(n_times, n_rows) multipliers and whether they are unique; (n_times, n_barriers), (n_times, n_drags) states. What
    is of a pivot is told of the rim for which it stands."""
    bounded.ends.set(phase.mode.pivots)
    course, mode = phase.course, phase.mode
    n = len(course.times)
    multipliers, unique = np.zeros((n, len(bounded.rows))), np.ones((n, len(bounded.rows)))
    held = list(bounded.held_in(mode))
    multipliers[:, held], unique[:, held] = course.multipliers, course.unique
    states = np.zeros((n, len(bounded.barriers)))
    states[:, list(mode.closed)] = 1.0
    slips = np.full((n, len(bounded.drags)), float(ABSENT))
    for k, (drag, state) in enumerate(zip(bounded.drags, mode.drags, strict=True)):
        if state is not None:
            slips[:, k] = state
        if k in mode.followers:
            continue
        if state:
            load = _load(bounded, phase, drag, state, multipliers)
            is_unique = unique[:, list(drag.loads)].min(axis=1, initial=1.0)
            for place, share in _components(bounded, phase, k, state):
                multipliers[:, place], unique[:, place] = -share * load, is_unique
    for group in mode.groups:
        _share(bounded, group, multipliers, unique)
    ends = bounded.ends
    for place, rim in ends.rows_for.items():
        if place in held:
            multipliers[:, rim], unique[:, rim] = multipliers[:, place], unique[:, place]
    for k, rim in ends.stands_for.items():
        states[:, rim] += states[:, k]
    for k, rim in ends.rubs_for.items():
        if phase.mode.drags[k] is not None:
            slips[:, rim] = slips[:, k]
            if phase.mode.drags[k]:
                for place in (bounded.drags[k].keeps, bounded.drags[k].keeps_across):
                    if place >= 0:
                        to = ends.rows_for[place]
                        multipliers[:, to], unique[:, to] = multipliers[:, place], unique[:, place]
    n_rows = bounded.n_rows
    return (
        multipliers[:, :n_rows],
        unique[:, :n_rows],
        np.delete(states, list(ends.stands_for), axis=1),
        np.delete(slips, list(ends.rubs_for), axis=1),
    )


def _components(bounded: Bounded, phase: PhaseRecord, k: int, state: int) -> list[tuple[int, Floats | float]]:
    """Of the direction of a slip: its components, each with the place of its row."""
    drag = bounded.drags[k]
    if drag.across < 0:
        return [(drag.keeps, float(state))]
    course, engine = phase.course, phase.engine
    angle = dict(phase.mode.ways)[k]
    last = np.array((math.cos(angle), math.sin(angle)))
    rates, out = np.zeros((len(course.times), 2)), np.zeros(engine.n_y)
    for i, t in enumerate(course.times):
        stepping.visit(engine.layout, engine.room, engine.idle, -1.0, engine.state_at(course, i), float(t), out, 1)
        rates[i] = engine.room.rows[[drag.row, drag.across], kinematics.RATE]
    speeds = np.linalg.norm(rates, axis=1)
    goes = speeds > STILL * speeds.max(initial=0.0)
    ahead = np.where(rates @ last < 0.0, -1.0, 1.0)[:, None]
    found = np.where(goes[:, None], ahead * rates / np.where(goes, speeds, 1.0)[:, None], last)
    return [(drag.keeps, found[:, 0]), (drag.keeps_across, found[:, 1])]


def _share(bounded: Bounded, group: tuple[int, ...], multipliers: Floats, unique: Floats) -> None:
    """Friction along one slip is not unique: each place carries in proportion to what it can."""
    total = multipliers[:, bounded.drags[group[0]].keeps].copy()
    limits = np.zeros((len(total), len(group)))
    for n, k in enumerate(group):
        drag = bounded.drags[k]
        pressed = np.linalg.norm(multipliers[:, list(drag.loads)], axis=1) if drag.loads else np.ones(len(total))
        up, down = (
            bounded.numbers.number(drag.rub.coefficient(d, at_rest=True)) if drag.loads else 1.0 for d in (1, -1)
        )
        limits[:, n] = np.where(total > 0.0, down, up) * pressed
    size = limits.sum(axis=1)
    for n, k in enumerate(group):
        part = np.divide(limits[:, n], size, out=np.full(len(total), 1.0 / len(group)), where=size > 0.0)
        multipliers[:, bounded.drags[k].keeps] = part * total
        unique[:, bounded.drags[k].keeps] = 0.0


def _load(bounded: Bounded, phase: PhaseRecord, drag: FrictionRow, state: int, multipliers: Floats) -> Floats:
    """(n_times,) size of the force of a friction that slides in a direction."""
    if drag.loads:
        c = bounded.numbers.number(drag.rub.coefficient(state))
        pressed = multipliers[:, list(drag.loads)]
        return c * (drag.load_sign * pressed[:, 0] if drag.load_sign else np.linalg.norm(pressed, axis=1))
    course, engine = phase.course, phase.engine
    tape = bounded.written.limit_tapes(drag.packed)[1]
    found = np.zeros(len(course.times))
    out = np.zeros(engine.n_y)
    for i, t in enumerate(course.times):
        y = engine.state_at(course, i)
        stepping.visit(engine.layout, engine.room, engine.idle, -1.0, y, float(t), out, 1)
        found[i] = engine.tape_value(tape, float(t))
    return found
