"""Instant centres of all pairs of bodies, and velocity ratios, of a system that can move in one way only.

The centre of two bodies is the point of the plane where both have the same velocity; bodies without relative rotation
have it at infinity, across their relative velocity. With one freedom all velocities are in proportion to one
speed, so that centres and ratios belong to the pose, whether it moves or not.
Source: Norton, Design of Machinery, 5th ed. 2012, ch. 6 (Kennedy's theorem: sec. 6.3; mechanical advantage: sec. 6.4).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import combinations
from typing import Any

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr
from freebody.language.notation import to_python
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, LENGTH, Dimension
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.geometry import GROUND
from freebody.numeric.jets import Array
from freebody.numeric.snapshot import Snapshot, snapshot_of
from freebody.questions.base import Quantity
from freebody.questions.centres import motion_at_origin
from freebody.system.system import System

STILL = 1e-10  # a speed of this part of the largest one, by the size of the system, is zero


@dataclass(frozen=True)
class CentreOfPair:
    """Where a pair of bodies has its instant centre."""

    pair: tuple[str, str]
    at: tuple[float, float] | None = None  # [m]
    direction: tuple[float, float] | None = None  # towards a centre at infinity
    is_undetermined: bool = False  # the pair moves as one body
    formula: tuple[Expr, Expr] | None = None  # where the pose has one

    def to_plain(self) -> dict[str, Any]:
        found: dict[str, Any] = {"at": self.at, "direction": self.direction}
        if self.formula is not None:
            found["formula"] = tuple(map(to_python, self.formula))
        return {"pair": list(self.pair)} | {k: list(v) for k, v in found.items() if v is not None}


@dataclass(frozen=True)
class VelocityRatio:
    """Rate of a measure per unit rate of the input."""

    name: str
    value: float
    unit: str
    formula: Expr | None = None  # where the pose has one

    def to_plain(self) -> dict[str, Any]:
        formula = {} if self.formula is None else {"formula": to_python(self.formula)}
        return {"name": self.name, "value": self.value, "unit": self.unit} | formula


def in_motion(snapshot: Snapshot) -> Snapshot:
    """The snapshot, or where it is at rest and can move in one way only, the same pose moving in that way."""
    if np.abs(snapshot.v).max(initial=0.0) > 0.0:
        return snapshot
    free = snapshot.reference.split_at(snapshot.q, snapshot.branches, snapshot.t).null
    if free.shape[1] != 1:
        return snapshot
    return snapshot_of(snapshot.reference, snapshot.q, free[:, 0], snapshot.t, snapshot)


def moving_for(quantity: Quantity, snapshot: Snapshot) -> Snapshot:
    """The snapshot at which a quantity is asked: an instant centre needs some motion."""
    return in_motion(snapshot) if quantity.is_of_pose_in_motion else snapshot


def _along_freedom(system: System, snapshot: Snapshot) -> Snapshot:
    """The pose of a snapshot, moving in the one way in which it can: along its freedom, or as it is driven. Raises
    CannotAnswer otherwise."""
    reference = snapshot.reference
    free = reference.split_at(snapshot.q, snapshot.branches, snapshot.t).null
    # without a freedom of its own a pose moves as its drivers say, and in no other way
    is_driven = free.shape[1] == 0 and np.abs(snapshot.v).max(initial=0.0) > 0.0
    if free.shape[1] != 1 and not is_driven:
        raise CannotAnswer(
            Message(
                "the pose has {n} degrees of freedom; centres and ratios of the pose alone need exactly one. "
                "Drive the others, or ask for the instant centre of one body at given rates",
                n=free.shape[1],
            )
        )
    way = snapshot.v if is_driven else free[:, 0]
    v = way / (float(reference.sizes.relative(way).max()) or 1.0)
    return snapshot_of(reference, snapshot.q, v, snapshot.t, snapshot)


def instant_centres(system: System, snapshot: Snapshot) -> dict[tuple[str, str], CentreOfPair]:
    """The centres of all pairs of bodies that turn; fixed bodies count as the ground. Raises CannotAnswer unless the
    pose has exactly one freedom or is driven, and in space."""
    if system.space:
        raise CannotAnswer(
            Message("bodies have instant centres in the plane; in space they move about screws, see mobility")
        )
    moving = _along_freedom(system, snapshot)
    size = snapshot.reference.sizes.length
    bodies = [GROUND, *(b.name for b in system.moving if b.turns)]
    motions = {body: np.array(motion_at_origin(system, moving, body), dtype=float) for body in bodies}
    pairs = combinations(bodies, 2)
    return {(a, b): _centre((a, b), motions[a] - motions[b], size) for a, b in pairs}


def _centre(pair: tuple[str, str], motion: Array, size: float) -> CentreOfPair:
    """From d, the relative velocity at the origin, and w: r = (-d_y, d_x)/w. At most one size or radian a second."""
    dx, dy, w = (float(x) for x in motion)
    speed = math.hypot(dx, dy)
    if abs(w) > STILL * max(1.0, speed / size):
        return CentreOfPair(pair, (-dy / w + 0.0, dx / w + 0.0))
    if speed <= STILL * size:
        return CentreOfPair(pair, is_undetermined=True)
    x, y = (0.0 if abs(e) <= STILL else e for e in (-dy / speed, dx / speed))
    sign = (
        -1.0 if (x, y) < (0.0, 0.0) else 1.0
    )  # either end of the line across the motion is as far away: the right one
    return CentreOfPair(pair, direction=(sign * x + 0.0, sign * y + 0.0))


def velocity_ratios(system: System, snapshot: Snapshot, input: str | Measure) -> dict[str, VelocityRatio]:
    """Rates of all bodies' angles (by the body's name), and of the named measures, per unit rate of the input: a named
    measure, or a body whose angle is meant. Raises CannotAnswer unless the pose has exactly one freedom or is driven,
    or where the input stands still: a dead point."""
    moving = _along_freedom(system, snapshot)
    driving, name = _input(system, input)
    rate = moving.rate(driving)
    size = snapshot.reference.sizes.length if driving.dimension == LENGTH else 1.0
    if abs(rate) <= STILL * size:
        raise CannotAnswer(
            Message(
                "{name} stands still in this pose while others move (a dead point); choose another input", name=name
            )
        )
    measures: dict[str, Measure] = {b.name: Angle(b.name) for b in system.moving if b.turns and not system.space}
    measures |= system.measures
    return {
        key: VelocityRatio(key, moving.rate(m) / rate + 0.0, _unit(m.dimension / driving.dimension))
        for key, m in measures.items()
    }


def _input(system: System, input: str | Measure) -> tuple[Measure, str]:
    if not isinstance(input, str):
        return input, "the input"
    if input in system.measures:
        return system.measures[input], input
    if input in system.bodies and system.bodies[input].turns:
        return Angle(input), f"the angle of {input}"
    known = ", ".join([*system.measures, *(b.name for b in system.moving if b.turns)])
    raise CannotAnswer(
        Message("{name} is no named measure and no body that turns; there is {known}", name=input, known=known)
    )


def _unit(dimension: Dimension) -> str:
    return "1" if dimension == DIMENSIONLESS else str(dimension)
