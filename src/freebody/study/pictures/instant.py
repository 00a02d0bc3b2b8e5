"""A system at one instant of its motion, with what is known of it there."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from freebody.budgets import allowed
from freebody.errors import CannotAnswer, InputError, ModelError, Problem
from freebody.language.sentences import Message
from freebody.numeric.jets import Array
from freebody.numeric.reference import Reference
from freebody.numeric.snapshot import Snapshot
from freebody.system.system import System

if TYPE_CHECKING:
    from freebody.study.simulation.simulate import Simulation

_MOST_STEPS = 50_000  # to the instant that is drawn
_AT_ONCE = 1e-6  # [s] a motion of which only the start is wanted


@dataclass(frozen=True)
class Instant:
    """accelerations: [m/s^2] of mass centres by body; reactions: [N] or [N m] by the name of the row, without those
    that are not unique. Both are empty at a start that was not set in motion. other_sides: the rows that bear on
    another side than the one that the model states."""

    snapshot: Snapshot
    accelerations: Mapping[str, Array] = field(default_factory=dict[str, "Array"])
    reactions: Mapping[str, float] = field(default_factory=dict[str, float])
    other_sides: frozenset[str] = frozenset()


def start_of(system: System, *, at_rest: bool = False) -> Instant:
    """The start, with some values for parameters without one; at rest where only the pose is wanted. Raises ModelError
    where it cannot be assembled."""
    try:
        reference = _reference(system)
        assembled, velocities = _of_start(system)
        q = assembled(reference)
        v = np.zeros_like(q) if at_rest else velocities(reference, q)
    except CannotAnswer as error:
        raise ModelError([Problem((), str(error))], system.file) from error
    return Instant(reference.snapshot(q, v))


def _of_start(system: System) -> tuple[Callable[[Reference], Array], Callable[[Reference, Array], Array]]:
    """What finds the pose at the start, and the velocities in it."""
    if not system.bounds:
        return Reference.assemble, Reference.velocities
    from freebody.numeric.contact.start import assembled_touching, start_velocities  # a room that few models need

    return assembled_touching, start_velocities


def _reference(system: System) -> Reference:
    """With some values for parameters without one, as a sketch of what a model in symbols looks like."""
    missing = [name for name, p in system.parameters.items() if p.value is None and p.form is None]
    # what sliding friction is pressed with is a symbol of its own
    unknown = {name: 0.0 for name in missing if name.startswith("@")}
    if len(unknown) == len(missing):
        return Reference(system, unknown)
    from freebody.study.answering.draws import draws

    values = draws(system, 1)[0].values
    return Reference(system, {name: values[name] for name in missing} | unknown)


def _watched(now: float, steps: int) -> None:
    """Raises CannotAnswer once a motion takes more steps than a picture is worth."""
    if steps > allowed(_MOST_STEPS):
        raise CannotAnswer(
            Message(
                "the motion takes more than {n} steps, of which the last ended at t = {t:.4g} s; "
                "draw an earlier instant; freebody simulate goes further",
                n=allowed(_MOST_STEPS),
                t=now,
            )
        )


def instant_of(system: System, at: float | None, *, in_motion: bool = False, at_rest: bool = False) -> Instant:
    """The system at a time [s], by simulation, or at its start; in motion with accelerations and reactions. Raises
    CannotAnswer if the motion does not last so long."""
    if at is not None and not 0.0 <= at < float("inf"):
        raise InputError(Message("the motion begins at 0 s; there is no instant at {at:g} s", at=at))
    if not at and not in_motion:
        return start_of(system, at_rest=at_rest)
    from freebody.study.simulation.simulate import simulate

    result = simulate(system, at or _AT_ONCE, progress=_watched)
    _watched(result.t_end, result.course.n_steps)
    is_still = result.status.is_complete and len(result.course.times) == 1  # nothing can move
    if at and result.t_end < at * (1 - 1e-9) and not is_still:
        raise CannotAnswer(
            Message("the motion ends at t = {t:.6g} s: {why}", t=result.t_end, why=result.message or result.status)
        )
    return instant_along(result, -1 if at else 0)


def instant_along(result: Simulation, k: int) -> Instant:
    """The k-th output time of a motion."""
    from freebody.study.simulation.pressed_sides import left_sides

    course, reference, engine = result.course, result.simulator.reference, result.simulator.engine
    q, v = map(reference.by_column, engine.coordinates(engine.state_at(course, k)))
    n = 3 if result.system.space else 2
    return Instant(
        reference.snapshot(q, v, float(course.times[k])),
        {body.name: course.accelerations[k, j, :n] for j, body in enumerate(result.system.moving)},
        {
            row.name: row.sign * float(course.multipliers[k, j])
            for j, row in enumerate(result.rows)
            if course.unique[k, j]
        },
        frozenset(row.name for _j, row, away in left_sides(result) if k % len(course.times) in away)
        if result.follows_sides
        else frozenset(),
    )
