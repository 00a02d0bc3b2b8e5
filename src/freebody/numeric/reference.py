"""The reference route: a system in plain numbers, by the shortest way from the statements of its measures.

With J the gradients of the held measures, the accelerations a and the multipliers lambda solve

    M a = Q + J^T lambda,        J a = target'' - bias.

Every solution is rank-revealing in the metric of the masses, so redundant connections are allowed and
massless bodies too; what is then not unique is refused by name.
Source: Nikravesh, Computer-Aided Analysis of Mechanical Systems, 1988, ch. 7 and 8.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.measures.displacement import Displacement
from freebody.model.elements import NonholonomicForm
from freebody.numeric.blow import blow
from freebody.numeric.described import axes_of
from freebody.numeric.jets import Array
from freebody.numeric.linearised import frequencies, linearised
from freebody.numeric.snapshot import Snapshot, snapshot_of
from freebody.numeric.start import N_STARTS, assembled
from freebody.numeric.start_velocities import start_velocities
from freebody.numeric.system import NumericSystem
from freebody.numeric.trajectory import ReferenceTrajectory, integrate

HARDLY_APART = 1e-6  # of the size of a system: points that are to coincide are found to half the digits


class Reference(NumericSystem):
    """One system with a number for every parameter, its start and its motions."""

    def assemble(
        self,
        extra: Sequence[tuple[Measure | NonholonomicForm, float]] = (),
        guess: Array | None = None,
        n_starts: int = N_STARTS,
    ) -> Array:
        """The pose at t = 0: the held measures hold, the start of the model is as described, and the `extra`
        measures have the given values (which replace those of the model's start). What is left free is as near to zero,
        or to the `guess`, as small moves bring it, by the masses. From here on measures of which only
        changes mean something count from this pose. n_starts: disturbed guesses that are tried after the guess itself,
        the first of them near it.

        Returns q. Raises CannotAnswer naming the row with the largest gap if this is contradictory."""
        fit = assembled(self, extra, guess, n_starts)
        if self.system.mode is not None and guess is None and not extra:
            from freebody.numeric.mobility.modes import chosen

            self.remember_at(fit.geometry)
            fit = assembled(self, extra, chosen(self, fit.q, self.system.mode))
        self.remember_at(fit.geometry)
        if not extra:
            self._check_lines(fit.q)
        return fit.q

    def _check_lines(self, q: Array) -> None:
        """Raises CannotAnswer where something is held along a line that has no length at the start: a link, a belt or
        a mesh of wheels with one centre has no direction in which it could act."""
        g = self.at_rest(q)
        for row in self.system.constraint_rows:
            if isinstance(row.measure, NonholonomicForm) or not row.measure.incremental:
                continue
            for first, second in row.measure.lines():
                gaps = [self.jet(g, Displacement(second, first, axis)).value for axis in axes_of(self.system)]
                if math.hypot(*gaps) <= HARDLY_APART * self.sizes.length:
                    raise CannotAnswer(
                        Message(
                            "at the start {first} and {second} are in one place, and {connection} needs a line between "
                            "them, which has no direction: put them apart (at); a string leads along a slider without "
                            "that",
                            first=first,
                            second=second,
                            connection=row.connection,
                        )
                    )

    def wander(self, q: Array, rng: np.random.Generator, size: float, t: float = 0.0) -> tuple[Array, Array]:
        """A pose and velocities (q, v) near q that hold what q holds, otherwise arbitrary: the free
        directions are moved by about `size` (of the system's size, or radians) and run at about one size (or
        radian) a second. Raises CannotAnswer if there is none."""

        def along(free: Array, size: float) -> Array:
            # what a disturbance has along the free directions, so that it hangs on no basis of them
            scaled = free / self.sizes.unit_moves[:, None]
            step: Array = free @ np.linalg.lstsq(scaled, self.noise(rng), rcond=None)[0]
            return step * (size / (float(self.sizes.relative(step).max(initial=0.0)) or 1.0))

        free = self.split_at(q, self.branches).null
        here = self.placing.placed(self.frame.moved(q, along(free, size)), self.held_where(q, 0.0), t, self.branches).q
        n_free, free = free.shape[1], self.split_at(here, self.branches, t).null
        # rows of velocities hold no pose: where they say more a step away than here, no motion goes there
        if free.shape[1] < n_free and any(
            isinstance(row.measure, NonholonomicForm) for row in self.system.constraint_rows
        ):
            raise CannotAnswer(Message("the velocity constraints bind more a step away than at the pose itself"))
        return here, along(free, 1.0) + self.velocities(here, (), t, with_start=False)

    def velocities(
        self,
        q: Array,
        extra: Sequence[tuple[Measure | NonholonomicForm, float]] = (),
        t: float = 0.0,
        *,
        with_start: bool = True,
    ) -> Array:
        """Velocities of least kinetic energy [m/s, rad/s] that hold what is held and have the rates of the
        model's start; `extra` rates replace those. Where the start is a blow, those after it. Without `with_start` only
        the `extra` rates are asked for. Raises CannotAnswer naming a rate that contradicts."""
        g = self.at_rest(q, t)
        if with_start and self.system.is_struck:
            return blow(self, g, extra).after
        return start_velocities(self, g, extra, with_start=with_start)

    def snapshot(self, q: Array, v: Array, t: float = 0.0, near: Snapshot | None = None) -> Snapshot:
        """The system at one instant; its accelerations and reactions are found when they are first asked for.
        Angles of lines are counted on from those of `near`, or of the start."""
        return snapshot_of(self, q, v, t, near)

    def integrate(
        self,
        start: Snapshot | tuple[Array, Array],
        until: float,
        event: Callable[[Snapshot], float] | None = None,
    ) -> ReferenceTrajectory:
        """The motion from `start` (a snapshot, or (q, v) at t = 0) until the time `until` [s], or until the
        first later time at which `event` crosses zero. Raises CannotAnswer if the event does not happen."""
        now = start if isinstance(start, Snapshot) else self.snapshot(*start)
        return integrate(self, now, until, event)

    def start_value(self, measure: Measure) -> float:
        """See `NumericSystem`; the system is assembled if it was not."""
        if measure.incremental and not self.counts:
            self.assemble()
        return super().start_value(measure)

    def linearised(self, q: Array) -> tuple[Array, Array]:
        """(M, K) of the small undamped motions M z'' + K z = 0 about the equilibrium q, z along independent
        directions. Raises CannotAnswer if q is no equilibrium."""
        return linearised(self, q, self.branches)

    def frequencies(self, q: Array) -> Array:
        """Natural angular frequencies [rad/s] of the undamped system about the equilibrium pose q, ascending;
        0 for a direction without stiffness. Raises CannotAnswer if the equilibrium is unstable."""
        return frequencies(*self.linearised(q))
