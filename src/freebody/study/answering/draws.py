"""Random admissible numbers for a system: parameters, a start pose, a pose and motion in general position.

Parameters vary about the values in the file (about 1 where there are none), keep their declared signs, and are
drawn again, closer to the file, where the mechanism cannot be assembled. The seed is fixed: a run repeats.
"""

from __future__ import annotations

import math
import random
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, LENGTH
from freebody.measures.base import Measure
from freebody.measures.geometry import GROUND, Direction
from freebody.model.elements import NonholonomicForm
from freebody.model.rotations import UNIT
from freebody.model.spins import spin
from freebody.numeric.jets import Array
from freebody.numeric.reference import Reference
from freebody.numeric.rotation import matrix, rotation_vector
from freebody.numeric.snapshot import Snapshot
from freebody.symbolic.sample import Sample
from freebody.symbolic.spatial.tree import tree_of
from freebody.system.system import System

if TYPE_CHECKING:
    from freebody.numeric.engine.engine import Engine

SEED = 7
_TRIES = 12
_TURNED = 1.0  # rad
_NEARBY = 2  # disturbed guesses near the pose of the file, for a draw that shall be on its branch

_LEAST_REGULAR = 0.01  # of the pose of the file: speeds are found with round-off over the square of this

_AXES = tuple(Direction(GROUND, along) for along in UNIT)


@dataclass
class Draw:
    """One set of parameter values, with the numeric route set up for it and assembled at the start."""

    values: dict[str, float]
    reference: Reference
    q: Array
    # by the measure that turns: (angle from the start, pose) round a full turn, where somebody has gone round
    turns: dict[Measure, list[tuple[float, Array]]] = field(
        default_factory=dict["Measure", "list[tuple[float, Array]]"]
    )
    # whether its numbers stand for those that the file leaves open: others are drawn about them
    is_typical: bool = False

    @classmethod
    def of(cls, system: System, values: dict[str, float], **how: Any) -> Draw:
        """A system with these numbers. how: as for `Reference.assemble`. Raises CannotAnswer where it does not
        assemble."""
        reference = Reference(system, values)
        return cls(values, reference, _assembled(reference, **how))

    @cached_property
    def regularity(self) -> float:
        """The least singular value of the independent constraints at the start, relative to the largest: how far from a
        singular pose that is."""
        return self.reference.split_at(self.q, self.reference.branches).smallest

    def start(self) -> Snapshot:
        """The start, with its velocities."""
        return self.reference.snapshot(self.q, self.reference.velocities(self.q))

    def with_values(self, values: dict[str, float], system: System | None = None) -> Draw:
        """Another one near it. system: where it is not the same. Raises CannotAnswer where that does not assemble."""
        reference = Reference(self.reference.system if system is None else system, values)
        return Draw(values, reference, _assembled(reference, guess=self.guess_for(reference), n_starts=_NEARBY))

    def guess_for(self, reference: Reference) -> Array:
        """Its pose for other numbers of the parameters: bodies are turned as they are here, whatever principal axes
        they have there, which may change places from one mass to the next, and the points that are put somewhere are
        there."""
        q = self.q.copy()
        for body in reference.system.moving:
            columns = list(reference.columns(body.name))
            if reference.system.space:
                own = columns[3:]
                axes = matrix(q[own]) @ self.reference.frame.principal[body.name].T if own else np.eye(3)
                if own:
                    q[own] = rotation_vector(axes @ reference.frame.principal[body.name])
            else:
                c, s = (f(q[columns[2]]) if body.turns else f(0.0) for f in (math.cos, math.sin))
                axes = np.array([[c, -s], [s, c]])
            if body.start.at is not None:
                point, place = body.start.at
                arm, there = (np.array([reference.number(x) for x in of]) for of in (body.points[point], place))
                q[columns[: len(there)]] = there - axes @ arm
        return q

    def seen(self, snapshot: Snapshot) -> Snapshot:
        """The same instant, with accelerations and multipliers by the engine."""
        from freebody.study.answering.witness import NumericSnapshot

        return NumericSnapshot(snapshot, self._engine)

    @cached_property
    def _engine(self) -> Engine:
        from freebody.numeric.engine.engine import Engine

        return Engine(self.reference.numbers())

    def sample(self, snapshot: Snapshot | None = None, *, is_start: bool = True) -> Sample:
        """The same numbers for the symbolic route."""
        system = self.reference.system
        if system.space:
            return self._in_space(snapshot, is_start=is_start)
        q = self.q if snapshot is None else snapshot.q
        poses = {b.name: self.reference.pose(q, b.name) for b in system.all_moving}
        velocities: dict[str, tuple[float, float, float]] = {}
        if snapshot is not None:
            for body in system.all_moving:
                v = [float(snapshot.v[k]) for k in self.reference.columns(body.name)] + [0.0]
                velocities[body.name] = (v[0], v[1], v[2])
        time = 0.0 if snapshot is None else snapshot.t
        return Sample(self.values, poses, self._constants(), time, is_start, velocities)

    def _constants(self) -> dict[str, float]:
        """Start values of what is incremental."""
        constants: dict[str, float] = {}
        for item in (*self.reference.system.constraint_rows, *self.reference.system.applied_loads):
            measure: Any = item.measure
            if getattr(measure, "incremental", False):
                constants[item.name] = self.reference.start_value(measure)
        return constants

    def _in_space(self, snapshot: Snapshot | None, *, is_start: bool) -> Sample:
        system, reference = self.reference.system, self.reference
        here = reference.snapshot(self.q, np.zeros_like(self.q)) if snapshot is None else snapshot
        angles: dict[str, tuple[float, float]] = {}
        for name, measure in tree_of(system).angles.items():
            with suppress(CannotAnswer):
                angles[name] = here.value(measure), here.rate(measure)
        places = {b.name: tuple(map(float, here.q[list(reference.columns(b.name)[:3])])) for b in system.all_moving}
        rates = {b.name: tuple(map(float, here.v[list(reference.columns(b.name)[:3])])) for b in system.all_moving}
        velocities = rates if snapshot is not None else {}
        turning = {name: tuple(here.rate(spin(name, axis)) for axis in _AXES) for name in system.unfollowed}
        return Sample(self.values, places, self._constants(), here.t, is_start, velocities, angles, turning)

    def anywhere(self, seed: int, t: float, size: float) -> Snapshot:
        """A pose and motion near the start, otherwise arbitrary; as far as `size` of the system, or radians."""
        reference, t = self.reference, self._soon(t)
        for distance in (size, size / 3, size / 10):
            try:
                q, v = reference.wander(self.q, np.random.default_rng(seed), distance, t)
            except CannotAnswer:
                continue
            return reference.snapshot(q, v, t)
        return self.start()

    def _soon(self, t: float) -> float:
        """A time, not so late that in space a drive has turned a body beyond where the pose of the start leads: wheels
        that mesh on a carrier fit it half a turn away as well, which a pose found at once does not tell apart."""
        reference = self.reference
        if not (reference.system.space and t):
            return t
        v = reference.velocities(self.q, with_start=False)
        turning = [abs(float(v[k])) for b in reference.system.moving for k in reference.columns(b.name)[3:]]
        return min(t, _TURNED / fastest) if (fastest := max(turning, default=0.0)) else t


def _assembled(reference: Reference, **how: Any) -> Array:
    """The pose at the start. Raises CannotAnswer where it does not assemble, or what keeps the value it has there has
    none: a chain on sprockets that overlap."""
    q = reference.assemble(**how)
    for row in reference.system.constraint_rows:
        if not isinstance(row.measure, NonholonomicForm) and row.measure.incremental:
            reference.start_value(row.measure)
    return q


def draw_parameters(
    system: System,
    rng: random.Random,
    spread: float,
    *,
    lengths: bool = True,
    typical: Mapping[str, float] | None = None,
) -> dict[str, float]:
    """Random values of all parameters; spread 0 gives the file's values. Without `lengths`, lengths and angles
    keep theirs: a file that mixes symbols and numbers in its geometry fits together for these only. typical: about
    which those vary that the file leaves open."""
    values: dict[str, float] = {}
    for p in system.parameters.values():
        if p.form is not None:
            continue  # it follows from the others
        if p.value is None and typical is not None and p.name in typical:
            p = replace(p, value=typical[p.name])
        if not lengths and p.value is not None and p.dimension in (LENGTH, DIMENSIONLESS):
            values[p.name] = p.value
        elif p.acute:
            center = 0.6 if p.value is None else p.value
            room = min(center, math.pi / 2 - center)
            edge = 0.05 * room  # with a wide spread it stays between 0 and 90 degrees
            values[p.name] = min(max(center + spread * room * rng.uniform(-0.9, 0.9), edge), math.pi / 2 - edge)
        elif p.value is None:
            values[p.name] = math.exp(rng.uniform(-0.7, 0.7))
        else:
            values[p.name] = p.value * math.exp(spread * rng.uniform(-0.7, 0.7))
            if p.value == 0 and spread and p.sign != "positive":
                values[p.name] = spread * rng.uniform(0.2, 1.0)
        if p.is_share and values.get(p.name, 0.0) > 1.0:
            values[p.name] = 1.0 / values[p.name]
    return values


def draws(system: System, n: int, *, seed: int = SEED, widest: float = 1.0, near: Draw | None = None) -> list[Draw]:
    """n draws. Without a draw to be `near`, the first one has the file's own values where it gives them."""
    rng = random.Random(seed)
    found: list[Draw] = []
    first: CannotAnswer | None = None
    typical = near.values if near is not None and near.is_typical else None
    for k in range(n):
        spread = 0.0 if k == 0 and near is None else widest
        for attempt in range(_TRIES):
            lengths = attempt < _TRIES // 2
            if attempt == _TRIES // 2:
                spread = widest
            own = 0.0 if k == 0 and near is None else spread
            values = draw_parameters(system, rng, own, lengths=lengths, typical=typical)
            try:
                # on the same branch as the file's own numbers: near its pose, or not at all
                branch = near or (found[0] if found else None)
                is_random = not system.has_values and lengths  # lengths that do not fit are found out soon
                how = {"n_starts": _NEARBY} if is_random else {}
                draw = Draw.of(system, values, **how) if branch is None else branch.with_values(values, system)
                if found:
                    draw.start()  # where what is put in numbers only just fits, velocities do not
                if branch is not None and draw.regularity < _LEAST_REGULAR * branch.regularity:
                    raise CannotAnswer(Message("beside a singular pose numbers are too inaccurate to compare with"))
                found.append(draw)
                break
            except CannotAnswer as error:
                if k == 0 and near is None and system.has_values:
                    raise
                first = first or error
                spread *= 0.6
    if not found:
        raise first or CannotAnswer(Message("no admissible parameter values were found"))
    return found
