"""Balls whose orientation nothing looks at, in numbers: a motion is followed with their axes K as they are at its
beginning, and these are turned afterwards.

With the same moment about every axis, I omega' = M holds along K as along axes of the ball, and nothing else hangs on
where these point. What they turn by follows from omega(t) along K, which is known then:

    s' = (0, omega) s / 2,        R = K S(s),        S^T omega along the axes of the ball.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any, cast

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.numeric.jets import Array
from freebody.numeric.reference import Reference
from freebody.numeric.rotation import from_quaternion, matrix, product, rotation_vector

_RTOL = 1e-12
_SAME = 1e-9  # of accelerations, relative and [SI]: in two orientations
AT_FIRST: Array = np.array([1.0, 0.0, 0.0, 0.0])


class TurnedAlong:
    """The balls of a reference that are followed without their orientation."""

    def __init__(self, reference: Reference, names: Iterable[str]) -> None:
        self._columns = [list(reference.columns(name)[3:]) for name in sorted(names)]

    def at_first(self) -> Array:
        """(n_balls, 4) no turns yet."""
        return np.tile(AT_FIRST, (len(self._columns), 1))

    def without(self, slope: Array) -> Array:
        """dq/dt with the axes of the balls as they are."""
        for own in self._columns:
            slope[own] = 0.0
        return slope

    def on(self, turns: Array, state: Callable[[float], Array], a: float, b: float) -> Array:
        """(n_balls, 4) what they have turned by at b, of what they had at a; (q, v) by the time."""
        if not self._columns or b <= a:
            return turns
        from scipy import integrate

        n = len(state(a)) // 2

        def slope(t: float, s: Array) -> Array:
            v = state(t)[n:]
            spins = np.array([[0.0, *v[own]] for own in self._columns])
            return 0.5 * product(spins, s.reshape(-1, 4)).ravel()

        solve_ivp: Callable[..., Any] = cast("Any", integrate).solve_ivp
        found = solve_ivp(slope, (a, b), turns.ravel(), method="DOP853", rtol=_RTOL, atol=_RTOL)
        s: Array = found.y[:, -1].reshape(-1, 4)
        return s / np.linalg.norm(s, axis=1, keepdims=True)

    def turned(self, q: Array, v: Array, turns: Array) -> tuple[Array, Array]:
        """The pose and the velocities with the axes of the balls where they have turned to."""
        q, v = q.copy(), v.copy()
        for own, s in zip(self._columns, turns, strict=True):
            S = from_quaternion(s)
            q[own], v[own] = rotation_vector(matrix(q[own]) @ S), S.T @ v[own]
        return q, v

    def check(self, before: Array, after: Array, turns: Array) -> None:
        """Raises CannotAnswer where accelerations differ before and after the axes were turned."""
        same = before.copy()
        for own, s in zip(self._columns, turns, strict=True):
            same[own] = from_quaternion(s).T @ before[own]
        if not np.allclose(same, after, rtol=_SAME, atol=_SAME * max(1.0, float(np.abs(before).max(initial=0.0)))):
            raise CannotAnswer(Message("in numbers the motion depends on the orientation of a ball"))
