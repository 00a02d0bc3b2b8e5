"""A system in numbers at one instant: measures and their rates, accelerations, reactions, loads.

Reactions are the multipliers of the held measures. Where rows of these depend on each other only some
combinations are determined: a multiplier is unique if no combination of rows that vanishes contains its row.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from contextlib import suppress
from functools import cached_property
from typing import Any

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.model.elements import AppliedLoad, ConstraintRow, NonholonomicForm
from freebody.model.state import JustBefore, direction_of_numbers, function_of_number, not_beside
from freebody.numeric.blow import Blow, blow, impulse
from freebody.numeric.instant import Dynamics, dynamics, held, law
from freebody.numeric.jet_geometry import Branch, JetGeometry
from freebody.numeric.jets import Array, Jet
from freebody.numeric.potential import potential
from freebody.numeric.rotation import matrix
from freebody.numeric.system import NumericSystem


class Snapshot:
    """A system in numbers at one instant: a `State[float]`. Everything raises CannotAnswer where there is no
    finite or no unique value."""

    def __init__(self, reference: NumericSystem, geometry: JetGeometry, q: Array, v: Array, t: float) -> None:
        self.reference = reference
        self.q, self.v, self.t = q, v, t
        self.geometry = geometry

    @property
    def branches(self) -> Mapping[Branch, float]:
        """The angles of lines met so far, by which later ones are counted on."""
        return self.geometry.angles

    def counted_on(self) -> Snapshot:
        """The same instant, when the angles of all lines met before it have been looked at here."""
        for measure in self.geometry.frame.measures(tuple(self.branches)):
            with suppress(CannotAnswer):  # of a line that is a point here
                self.value(measure)
        return self

    @cached_property
    def _dynamics(self) -> Dynamics:
        return dynamics(self.reference, self.geometry)

    @property
    def accelerations(self) -> Array:
        """Second derivatives of q [m/s^2, rad/s^2]."""
        return self._dynamics.accelerations

    @property
    def kinetic_energy(self) -> float:
        """[J]"""
        return 0.5 * float(self.v @ (self.reference.masses * self.v))

    # -- State[float] -------------------------------------------------------------------------
    def scalar(self, expr: Expr) -> float:
        return self.reference.number(expr, self.t)

    def value(self, measure: Measure) -> float:
        return self._jet(measure).value

    def rate(self, measure: Measure | NonholonomicForm) -> float:
        return self._jet(measure).rate

    def rate_size(self, measure: Measure | NonholonomicForm) -> float:
        """[SI/s] How large a rate may be at these speeds, |J| |v| for J v, in coordinates by the size of the system.
        Its round-off is a part of that, also where J v cancels, as in the rate of an angle to a body that turns."""
        moves = self.reference.sizes.unit_moves
        slope: Array = self._jet(measure).row(len(self.q)) * moves
        return float(np.linalg.norm(slope) * np.linalg.norm(self.v / moves))

    def acceleration(self, measure: Measure | NonholonomicForm) -> float:
        jet = self._jet(measure)
        return float(jet.row(len(self.q)) @ self.accelerations) + jet.bias

    def gradient(self, measure: Measure | NonholonomicForm, body: str) -> tuple[float, ...]:
        frame, g, q = self.reference.frame, self.geometry, self.q
        if body in frame.fixed:
            # it feels the reaction too: for the derivative it may move
            q = np.append(q, frame.fixed[body])
            frame = frame.released(body)
            g = JetGeometry(frame, q, np.append(self.v, np.zeros(len(q) - len(self.v))), self.t, self.branches)
        row = self.reference.jet(g, measure).row(len(q))
        if frame.space:
            own = list(frame.columns[body])
            moment = matrix(q[own[3:]]) @ row[own[3:]] if len(own) == 6 else np.zeros(3)
            return (*map(float, row[own[:3]]), *map(float, moment))
        x, y, *theta = (float(row[k]) for k in frame.columns[body])
        return x, y, theta[0] if theta else 0.0

    def multiplier(self, row: ConstraintRow) -> float:
        return held(self.reference, self._dynamics.split, self._dynamics.multipliers, row)

    def impulse(self, row: ConstraintRow) -> float:
        return impulse(self.reference, self._blow, row)

    @property
    def energy_before(self) -> float:
        v = self._blow.before
        return 0.5 * float(v @ (self.reference.masses * v))

    def rate_before(self, measure: Measure | NonholonomicForm) -> float:
        return float(self._jet(measure).row(len(self.q)) @ self._blow.before)

    def beside_blow(self, quantity: Any, side: str) -> Any:
        if side == "start":
            raise not_beside(side)
        return quantity.value(self.reference.system, JustBefore(self))

    @cached_property
    def _blow(self) -> Blow:
        """The blow in this pose."""
        still = np.zeros_like(self.q)
        return blow(self.reference, self.reference.geometry(self.q, still, 0.0, dict(self.branches)))

    def law(self, push: AppliedLoad) -> float:
        return law(self.reference, self.geometry, push)

    def potential(self, push: AppliedLoad) -> float:
        """[J]"""
        return potential(self.reference, push, self.value)

    def sqrt(self, x: Any) -> float:
        value = float(x)
        if not value >= 0.0:
            raise CannotAnswer(Message("there is no real root of {x:.6g}", x=value))
        return math.sqrt(value)

    def size(self, vector: tuple[Any, ...]) -> float:
        return self.sqrt(sum(x * x for x in vector))

    def absolute(self, x: Any) -> float:
        return abs(float(x))

    def function(self, name: str, x: Any) -> float:
        return function_of_number(name, x)

    def direction(self, y: Any, x: Any) -> float:
        return direction_of_numbers(y, x)

    def _jet(self, measure: Measure | NonholonomicForm) -> Jet:
        return self.reference.jet(self.geometry, measure)


def snapshot_of(system: NumericSystem, q: Array, v: Array, t: float = 0.0, near: Snapshot | None = None) -> Snapshot:
    """A system at one instant; its accelerations and reactions are found when they are first asked for. Angles of
    lines are counted on from those of `near`, or of the start."""
    if not (np.isfinite(q).all() and np.isfinite(v).all() and math.isfinite(t)):
        raise CannotAnswer(Message("the state at t = {t:.6g} s is not finite", t=t))
    counted = None if near is None else system.frame.counted(near.branches, near.geometry.frame)
    return Snapshot(system, system.geometry(q, v, t, counted), q, v, t)
