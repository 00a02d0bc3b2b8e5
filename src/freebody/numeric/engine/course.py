"""What a run of the engine comes to: how it ended, and the states on its way."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Any

import numpy as np
from numpy.typing import NDArray

from freebody.numeric.engine.steps import Steps
from freebody.numeric.kernels.arrays import Floats


class Status(StrEnum):
    """How a motion ended."""

    FINISHED = "finished"
    EVENT = "event"  # a terminal event
    UNREACHABLE = "unreachable"  # a driver, or a loop, cannot go on
    SINGULAR = "singular"  # a dead point: accelerations grow without bound
    NOT_FINITE = "not finite"  # a load or a measure has no finite value
    STEP_TOO_SMALL = "step too small"
    TOO_LONG = "too long"
    INTERRUPTED = "interrupted"
    INCONSISTENT = "no consistent force"  # Painleve: contact and friction contradict each other
    CHATTER = "chatter"  # events without end at one instant, or too many of them

    @property
    def is_complete(self) -> bool:
        """True if the motion went as far as was asked."""
        return self in (Status.FINISHED, Status.EVENT)


@dataclass(frozen=True)
class Event:
    """An event of a motion. kind: "rising", "falling", "touch" (zero without a crossing), "start" (zero when the motion
    begins) or "zero" (zero all along, said once); of contacts and friction what happens to them: "touches", "rebounds",
    "comes to rest", "parts", "starts to slip", "stops slipping", "slips back", "goes taut", "goes slack"; "starts to
    roll", "stops rolling", "rolls back" where rolling is resisted, "starts to spin", "stops spinning", "spins back"
    where spinning about the normal is; "blow"."""

    time: float
    name: str
    kind: str
    is_terminal: bool = False


@dataclass(frozen=True)
class Tracks:
    """Bearings after every step of a motion, by which turns are counted."""

    keys: Mapping[Any, int]  # of measures, with their column
    times: Floats
    bearings: Floats  # (n_steps, n_measures)

    def column(self, key: Any) -> Floats:
        """(n_steps,) bearings of a measure."""
        return self.bearings[:, self.keys[key]]

    def until(self, end: float) -> Tracks:
        """Those up to a time, the first one at least."""
        n = max(1, int(np.searchsorted(self.times, end, side="right")))
        return Tracks(self.keys, self.times[:n], self.bearings[:n])

    def nearest(self, times: Floats) -> list[int]:
        """For every time the step whose end is nearest."""
        after = np.clip(np.searchsorted(self.times, times), 1, max(1, len(self.times) - 1))
        before = after - 1
        after = np.minimum(after, len(self.times) - 1)
        is_before = times - self.times[before] < self.times[after] - times
        return [int(i) for i in np.where(is_before, before, after)]


NO_TRACKS = Tracks({}, np.zeros(0), np.zeros((0, 0)))  # of a motion in which nothing is counted


@dataclass(frozen=True)
class Collision:
    """Impacts at one instant: impulses [N s] and rates of gaps [m/s] by name, and the kinetic energy they take [J].
    joints: impulses with which what holds answers, by row, with the sign of its reaction; not_unique: rows whose
    impulses are not.
    energy_grew: the law of impact made energy, as Newton's may with friction."""

    time: float
    impulses: Mapping[str, float]
    friction: Mapping[str, float]
    before: Mapping[str, float]
    after: Mapping[str, float]
    energy_change: float
    energy_grew: bool
    joints: Mapping[str, float] = field(default_factory=dict[str, float])
    not_unique: tuple[str, ...] = ()


@dataclass(frozen=True)
class BlowRecord:
    """A blow: what closes and strikes at once. impulses: of what holds, by row, with the sign of its reaction [N s,
    N m s]; not_unique: rows whose impulses are not; energy_change: of the kinetic energy [J]."""

    time: float
    name: str
    impulses: Mapping[str, float]
    not_unique: tuple[str, ...]
    energy_change: float


@dataclass(frozen=True)
class ContactRecord:
    """Contact along a motion. states: (n_times, n_bounds) 1 where closed; slips: (n_times, n_frictions) 0 where it
    sticks, +1 or -1 where it slides, 2 where there is none. past: the blows that have happened at the end, those before
    the motion began included."""

    bounds: tuple[str, ...]
    dry_friction: tuple[str, ...]
    states: NDArray[np.int8]
    slips: NDArray[np.int8]
    collisions: tuple[Collision, ...]
    n_phases: int
    blows: tuple[BlowRecord, ...] = ()
    past: frozenset[str] = frozenset()


@dataclass(frozen=True)
class RotationHistory:
    """How bodies are turned and turn along a motion in space, the fixed one last."""

    quaternions: Floats  # (n_times, n_bodies + 1, 4): (w, x, y, z) of the body's own axes, continuous in time
    velocities: Floats  # (n_times, n_bodies + 1, 3) angular velocity along the axes of the ground [rad/s]
    accelerations: Floats  # (n_times, n_bodies + 1, 3) along the axes of the ground [rad/s^2]
    velocities_in_body: Floats  # (n_times, n_bodies + 1, 3) angular velocity along the body's own axes [rad/s]

    def first(self) -> RotationHistory:
        """At the first instant alone."""
        return RotationHistory(
            self.quaternions[:1], self.velocities[:1], self.accelerations[:1], self.velocities_in_body[:1]
        )


@dataclass(frozen=True)
class Trajectory:
    """A motion in arrays. The last body is the fixed one. SI units, angles in rad. In space poses, velocities and
    accelerations are x, y, z of the mass centres, and `rotation` has the rest."""

    status: Status
    message: str
    times: Floats  # (n_times,), strictly increasing
    poses: Floats  # (n_times, n_bodies + 1, 3)
    velocities: Floats
    accelerations: Floats
    multipliers: Floats  # (n_times, n_held), in the order of the model
    unique: NDArray[np.bool_]  # (n_times, n_held)
    work: Floats  # (n_times,): by loads without a potential and by drivers, since the start [J]
    events: tuple[Event, ...]
    n_steps: int
    n_evaluations: int
    n_rejected: int
    n_regularised: int
    wall_time: float
    place_gap: float  # the largest violation of a held position [m or rad]
    motion_gap: float
    last_step: float
    method: str
    tracks: Tracks
    near: Floats  # bearings at the end, from which a continued motion counts on
    violated: int = -1  # the guard whose violation ended the motion
    contact: ContactRecord | None = None  # of a system with bounds or dry friction
    rotation: RotationHistory | None = None  # in space
    steps: Steps | None = None  # where they are kept

    @property
    def t_end(self) -> float:
        return float(self.times[-1])

    def ends_at(self, events: Collection[str]) -> bool:
        """Whether it ends with a terminal event of one of these names."""
        last = self.events[-1] if self.events and self.status is Status.EVENT else None
        return last is not None and last.is_terminal and last.name in events
