"""A motion that starts at rest in an unstable equilibrium stays there; in numbers only round-off would make it leave.

The start is an equilibrium within round-off if no acceleration is more than some roundings of what the loads alone
would give. A small motion beside it, M z'' + K z = 0 (`numeric.linearised`), grows if M^-1 K has a negative eigenvalue.
Source: Meirovitch, Methods of Analytical Dynamics, 1970, sec. 5.4.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any, TypeVar, cast

import numpy as np
from numpy.typing import NDArray

from freebody.errors import CannotAnswer
from freebody.language.expression import free_symbols
from freebody.measures.combination import Composed
from freebody.numeric.engine.course import Event, RotationHistory, Status, Trajectory
from freebody.numeric.jets import Array

if TYPE_CHECKING:
    from freebody.study.simulation.simulator import Simulator

Kept = TypeVar("Kept", bound=NDArray[Any])

ROUNDINGS = 256.0 * float(np.finfo(float).eps)
NEGATIVE = 1e-9  # a stiffness that is negative by this part of the largest
NOTE = (
    "starts at rest, within round-off of an unstable equilibrium, and stays there; the smallest disturbance would make "
    "it leave, when and to which side is not determined. To see it leave, start it a little beside"
)


def is_unstable_rest(simulator: Simulator, y: Array, t: float) -> bool:
    """Whether a state is one of rest, within round-off, that a small disturbance leaves."""
    engine = simulator.engine
    n = engine.n_coordinates
    if simulator.bounded is not None or np.abs(y[n : 2 * n]).max(initial=0.0) > 0.0 or _knows_time(simulator):
        return False
    try:
        accelerations, _multipliers = engine.evaluate(y, t)
    except CannotAnswer:
        return False
    loads = np.abs(engine.room.force) * engine.layout.inverse_mass / engine.unit
    largest = float((np.abs(accelerations.ravel()) / engine.unit).max(initial=0.0))
    if largest > ROUNDINGS * float(loads.max(initial=0.0)):
        return False
    reference = simulator.reference
    try:
        mass, K = reference.linearised(reference.by_column(engine.coordinates(y)[0]))
        root = np.linalg.inv(np.linalg.cholesky(mass))
    except (CannotAnswer, np.linalg.LinAlgError):
        return False
    squares = np.linalg.eigvals(root @ K @ root.T)
    return bool(len(squares)) and float(squares.real.min()) < -NEGATIVE * float(np.abs(squares).max())


def _knows_time(simulator: Simulator) -> bool:
    """Whether time itself is in a load, in what is held, or in a measure."""
    system = simulator.system
    said = [push.law for push in system.applied_loads]
    said += [row.target for row in system.constraint_rows if row.target is not None]
    measures = [*(push.measure for push in system.applied_loads), *(row.measure for row in system.constraint_rows)]
    said += [measure.expression for measure in measures if isinstance(measure, Composed)]
    return any("t" in free_symbols(expr) for expr in said)


def staying(course: Trajectory, times: Array, events: tuple[Event, ...]) -> Trajectory:
    """The first instant of a course at all of some times."""
    n = len(times)

    def kept(array: Kept) -> Kept:
        return cast("Kept", np.repeat(array[:1], n, axis=0))

    rotation = course.rotation
    if rotation is not None:
        parts = (rotation.quaternions, rotation.velocities, rotation.accelerations, rotation.velocities_in_body)
        rotation = RotationHistory(*map(kept, parts))
    return replace(
        course,
        status=Status.FINISHED,
        message=NOTE,
        times=times,
        events=events,
        rotation=rotation,
        poses=kept(course.poses),
        velocities=kept(course.velocities),
        accelerations=kept(course.accelerations),
        multipliers=kept(course.multipliers),
        unique=kept(course.unique),
        work=kept(course.work),
    )
