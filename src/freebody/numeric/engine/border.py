"""The border between the states of the engine and what others know: poses and velocities of bodies.

A state is y = (q, v, W, r); see `cells` for q and v, `stepping` for the rest. In the plane there are no quaternions r.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple, Protocol

import numpy as np

from freebody.numeric.engine.cells import Floats
from freebody.numeric.engine.course import RotationHistory, Trajectory
from freebody.numeric.numbers import Numbers
from freebody.numeric.rotation import (
    from_quaternion,
    inverse,
    product,
    quaternion,
    quaternion_of_vector,
    rotation_vector,
    turned,
)

ALL = slice(None)
STILL = np.array([1.0, 0.0, 0.0, 0.0])  # the quaternion of no turn


class BodyTrack(NamedTuple):
    """Bodies along a motion, as a `Trajectory` has them."""

    poses: Floats
    velocities: Floats
    accelerations: Floats
    rotation: RotationHistory | None


class Border(Protocol):
    """What is known of the states of a system."""

    @property
    def n_coordinates(self) -> int:
        """How many entries q has, and v."""
        ...

    @property
    def n_y(self) -> int:
        """How many entries a state has."""
        ...

    @property
    def unit(self) -> Floats:
        """(n_coordinates,) the size of every entry of q: the length of the system, or a radian."""
        ...

    def state(self, poses: Floats, velocities: Floats) -> Floats:
        """A state; see `Packed.state`."""
        ...

    def coordinates(self, y: Floats) -> tuple[Floats, Floats]:
        """Poses and velocities of a state; the inverse of `state`."""
        ...

    def states(self, course: Trajectory, part: slice = ALL) -> Floats:
        """(n_times, n_y) states along a motion, without the work done."""
        ...

    def accelerations(self, course: Trajectory) -> Floats:
        """(n_times, n_coordinates) accelerations along a motion."""
        ...

    def track(self, states: Floats, accelerations: Floats) -> BodyTrack:
        """States (n_times, n_y) and accelerations (n_times, n_coordinates) as a course has them."""
        ...

    def largest_turn(self, before: Floats, after: Floats, bodies: Sequence[int] | None = None) -> Floats:
        """(...) the largest angle by which one of some bodies, or of all, turns between two states (..., n_y) [rad]."""
        ...

    def pose_rates(self) -> Floats:
        """(n_coordinates, n_coordinates) derivatives of q' by v."""
        ...

    def by_state(self, slopes: Floats, y: Floats) -> Floats:
        """(n, n_y) derivatives by the state, from those by small displacements and turns (n, n_coordinates)."""
        ...


class PlaneBorder:
    """States of the plane: x, y [m] and angle [rad] of every body."""

    def __init__(self, n_bodies: int, length: float) -> None:
        self.n_coordinates = 3 * (n_bodies + 1)
        self.n_y = 2 * self.n_coordinates + 1
        self.unit = np.tile([length, length, 1.0], n_bodies + 1)

    def state(self, poses: Floats, velocities: Floats) -> Floats:
        y, n = np.zeros(self.n_y), self.n_coordinates
        y[: n - 3], y[n : 2 * n - 3] = np.ravel(poses), np.ravel(velocities)
        return y

    def coordinates(self, y: Floats) -> tuple[Floats, Floats]:
        n = self.n_coordinates
        return y[: n - 3].reshape(-1, 3).copy(), y[n : 2 * n - 3].reshape(-1, 3).copy()

    def states(self, course: Trajectory, part: slice = ALL) -> Floats:
        n = self.n_coordinates
        n_times = len(course.times[part])
        states = np.zeros((n_times, self.n_y))
        states[:, :n] = course.poses[part].reshape(n_times, n)
        states[:, n : 2 * n] = course.velocities[part].reshape(n_times, n)
        return states

    def accelerations(self, course: Trajectory) -> Floats:
        return np.ascontiguousarray(course.accelerations.reshape(len(course.times), self.n_coordinates))

    def track(self, states: Floats, accelerations: Floats) -> BodyTrack:
        n = self.n_coordinates
        shape = (len(states), n // 3, 3)
        return BodyTrack(
            states[:, :n].reshape(shape), states[:, n : 2 * n].reshape(shape), accelerations.reshape(shape), None
        )

    def largest_turn(self, before: Floats, after: Floats, bodies: Sequence[int] | None = None) -> Floats:
        at = slice(2, self.n_coordinates, 3) if bodies is None else [3 * k + 2 for k in bodies]
        return np.abs(after[..., at] - before[..., at]).max(axis=-1, initial=0.0)

    def pose_rates(self) -> Floats:
        return np.eye(self.n_coordinates)

    def by_state(self, slopes: Floats, y: Floats) -> Floats:
        found = np.zeros((len(slopes), self.n_y))
        found[:, : self.n_coordinates] = slopes
        return found


class SpaceBorder:
    """States of space. Frames are the principal axes of inertia; users know the body's own axes."""

    def __init__(self, principal: Sequence[Floats], length: float) -> None:
        """principal: (3, 3) of every moving body, its principal axes as columns by components along its own axes."""
        self.n_bodies = len(principal)
        self.n_coordinates = 6 * (self.n_bodies + 1)
        self.n_y = 2 * self.n_coordinates + 1 + 4 * self.n_bodies
        self.unit = np.tile([length] * 3 + [1.0] * 3, self.n_bodies + 1)
        self._own = np.array([quaternion(P) for P in principal] + [STILL])  # from own axes to principal ones

    def state(self, poses: Floats, velocities: Floats) -> Floats:
        y, n = np.zeros(self.n_y), self.n_coordinates
        y[: n - 6].reshape(-1, 6)[:, :3] = poses[:, :3]
        y[n : 2 * n - 6] = np.ravel(velocities)
        for k, phi in enumerate(poses[:, 3:]):
            y[2 * n + 1 + 4 * k : 2 * n + 5 + 4 * k] = quaternion_of_vector(phi)
        return y

    def coordinates(self, y: Floats) -> tuple[Floats, Floats]:
        n = self.n_coordinates
        poses, velocities = y[: n - 6].reshape(-1, 6).copy(), y[n : 2 * n - 6].reshape(-1, 6).copy()
        for k, q in enumerate(y[2 * n + 1 :].reshape(-1, 4)):
            poses[k, 3:] = rotation_vector(from_quaternion(q))
        return poses, velocities

    def states(self, course: Trajectory, part: slice = ALL) -> Floats:
        assert course.rotation is not None
        n, rotation = self.n_coordinates, course.rotation
        n_times = len(course.times[part])
        states = np.zeros((n_times, self.n_y))
        q = states[:, :n].reshape(n_times, -1, 6)
        v = states[:, n : 2 * n].reshape(n_times, -1, 6)
        q[:, :, :3], v[:, :, :3] = course.poses[part], course.velocities[part]
        v[:, :, 3:] = turned(inverse(self._own), rotation.velocities_in_body[part])
        frames = product(rotation.quaternions[part], self._own)
        states[:, 2 * n + 1 :] = frames[:, :-1].reshape(n_times, -1)
        return states

    def accelerations(self, course: Trajectory) -> Floats:
        assert course.rotation is not None
        frames = product(course.rotation.quaternions, self._own)
        turning = turned(inverse(frames), course.rotation.accelerations)
        both = np.concatenate([course.accelerations, turning], axis=2)
        return np.ascontiguousarray(both.reshape(len(course.times), self.n_coordinates))

    def track(self, states: Floats, accelerations: Floats) -> BodyTrack:
        n, n_times = self.n_coordinates, len(states)
        q, v = (x.reshape(n_times, -1, 6) for x in (states[:, :n], states[:, n : 2 * n]))
        a = accelerations.reshape(n_times, -1, 6)
        frames = np.empty((n_times, self.n_bodies + 1, 4))
        frames[:, :-1], frames[:, -1] = states[:, 2 * n + 1 :].reshape(n_times, -1, 4), STILL
        rotation = RotationHistory(
            quaternions=product(frames, inverse(self._own)),
            velocities=turned(frames, v[:, :, 3:]),
            accelerations=turned(frames, a[:, :, 3:]),
            velocities_in_body=turned(self._own, v[:, :, 3:]),
        )
        return BodyTrack(q[:, :, :3].copy(), v[:, :, :3].copy(), a[:, :, :3].copy(), rotation)

    def largest_turn(self, before: Floats, after: Floats, bodies: Sequence[int] | None = None) -> Floats:
        change = (after - before)[..., 2 * self.n_coordinates + 1 :]
        change = change.reshape(*change.shape[:-1], -1, 4)
        change = change if bodies is None else change[..., list(bodies), :]
        return 2.0 * np.sqrt((change**2).sum(axis=-1).max(axis=-1, initial=0.0))

    def pose_rates(self) -> Floats:
        return np.diag(np.tile([1.0] * 3 + [0.0] * 3, self.n_bodies + 1))

    def by_state(self, slopes: Floats, y: Floats) -> Floats:
        """A change dr of the quaternion r is the turn 2 (r^-1 o dr) of its frame."""
        n = self.n_coordinates
        found = np.zeros((len(slopes), self.n_y))
        found[:, :n] = slopes @ self.pose_rates()
        for k, r in enumerate(y[2 * n + 1 :].reshape(-1, 4)):
            turns = 2.0 * product(inverse(r), np.eye(4))[:, 1:]  # (of dr, by component)
            at = 2 * n + 1 + 4 * k
            found[:, at : at + 4] = slopes[:, 6 * k + 3 : 6 * k + 6] @ turns.T
        return found


def border_of(numbers: Numbers) -> Border:
    """The border of a system's states."""
    if numbers.system.space:
        return SpaceBorder([np.asarray(numbers.principal(b.name)) for b in numbers.system.all_moving], numbers.length)
    return PlaneBorder(len(numbers.system.all_moving), numbers.length)
