"""What is large and what is small in a system: a typical length, and the metric of the masses.

A move dq costs twice the kinetic energy dq^T M dq at unit speed. With D = M^(-1/2) and dq = D y that is |y|^2,
so that "the smallest move" means the cheapest one. A massless body counts as one much lighter than the lightest of the
part that it belongs to, so that nothing in another part matters.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr
from freebody.language.sentences import Message
from freebody.language.units import LENGTH
from freebody.model.elements import RigidBody
from freebody.numeric.jets import Array
from freebody.system.system import System
from freebody.tolerances import LEAST

LIGHT = 1e-2  # what counts as the mass of a massless body where the smallest move is meant, by the lightest


@dataclass(frozen=True)
class Near:
    """What is typical of the part of a system that a body belongs to."""

    lightest: float  # mass [kg]; 1 where nothing has any
    heaviest: float
    arm: float  # of the body itself: how far from its mass centre it is touched [m]; of its part where it has none


def neighbours(
    system: System, number: Callable[[Expr], float], masses: Sequence[float], moments: Sequence[Sequence[float]]
) -> list[Near]:
    """By moving body. masses [kg] and moments of inertia [kg m^2] of these."""
    bodies = system.all_moving
    arms = [_arm(body, number) for body in bodies]
    found: dict[int, Near] = {}
    number_of = {body.name: k for k, body in enumerate(bodies)}
    for group in system.groups:
        part = sorted(number_of[name] for name in group)
        known = [masses[k] for k in part if masses[k] > 0.0] or [1.0]
        gyration = [math.sqrt(i / masses[k]) for k in part for i in moments[k] if i > 0.0 and masses[k] > 0.0]
        lengths = gyration or [arms[k] for k in part if arms[k] > 0.0] or [typical_length(system, number)]
        lightest, heaviest, shortest = min(known), max(known), min(lengths)
        found |= {k: Near(lightest, heaviest, arms[k] or shortest) for k in part}
    return [found[k] for k in range(len(bodies))]


def _arm(body: RigidBody, number: Callable[[Expr], float]) -> float:
    places = [math.hypot(*map(number, place)) for place in body.points.values()]
    return max([0.0, *places, abs(number(body.radius)) if body.radius is not None else 0.0])


@dataclass(frozen=True)
class Sizes:
    """Scales of one system in numbers, along its coordinates q."""

    length: float  # typical of the system [m]
    mass: float  # of the heaviest body [kg]
    unit_moves: Array  # a move by the typical length, a turn by a radian
    small_moves: Array  # D: 1/sqrt(mass) for every coordinate
    turning: NDArray[np.bool_]  # which coordinates are angles

    @classmethod
    def of(cls, masses: Array, turning: NDArray[np.bool_], length: float, near: Sequence[Near]) -> Sizes:
        """From the mass or moment of inertia at every coordinate, which of these are angles, and what is typical near
        the body that each belongs to. Raises CannotAnswer for negative masses."""
        return cls(
            length,
            float(masses[~turning].max(initial=0.0)) or 1.0,
            np.where(turning, 1.0, length),
            _small_moves(masses, turning, near),
            turning,
        )

    def only(self, columns: Sequence[int]) -> Sizes:
        """Those of some coordinates."""
        own = list(columns)
        return replace(
            self, unit_moves=self.unit_moves[own], small_moves=self.small_moves[own], turning=self.turning[own]
        )

    def clipped(self, step: Array, reach: float) -> Array:
        """A step shortened so that nothing moves by more than half of the size of the system, or half of `reach` sizes
        where that is more, and nothing turns by more than half a radian."""
        moved = self.relative(step)
        far = float(moved[~self.turning].max(initial=0.0)) / max(1.0, reach)
        return step * min(1.0, 0.5 / max(far, float(moved[self.turning].max(initial=0.0)), LEAST))

    def relative(self, step: Array) -> Array:
        """A move by the size of the system, a turn in radians."""
        return np.abs(step) / self.unit_moves


def typical_length(system: System, number: Callable[[Expr], float]) -> float:
    """How far points are from mass centres and from the origin, and how long held lengths are, at most [m]. Of what is
    fixed only those points count at which something is held, pushed or measured. Where none of these has a length, a
    start far away tells it, as that of a planet does."""
    moving = system.all_moving
    fixed = {point.body for point in system.touched} & {name for name, body in system.bodies.items() if body.fixed}
    places = [place for body in moving for place in body.points.values()]
    places += [point.offset for point in system.touched if point.body in fixed]
    placed = [*moving, *(system.bodies[name] for name in fixed)]
    places += [body.start.at[1] for body in placed if body.start.at]
    lengths = [0.0, *(math.hypot(*map(number, place)) for place in places)]
    lengths += [abs(number(body.radius)) for body in moving if body.radius is not None]
    for row in system.constraint_rows:
        if row.target is not None and row.measure.dimension == LENGTH and not row.is_driven:
            lengths.append(abs(number(row.target)))
    return max(lengths) or max([1.0, *_start_lengths(system, number)])


def _start_lengths(system: System, number: Callable[[Expr], float]) -> Iterator[float]:
    """What the start says of lengths [m]."""
    for key, value in system.all_start.items():
        if system.all_measures[key].dimension == LENGTH:
            yield abs(number(value))


def _small_moves(masses: Array, turning: NDArray[np.bool_], near: Sequence[Near]) -> Array:
    """1/sqrt(mass) for every coordinate: the move that costs a unit of (twice the) kinetic energy."""
    if (masses < 0.0).any():
        raise CannotAnswer(Message("with these parameters a mass or a moment of inertia is negative"))
    arms = np.where(turning, [n.arm for n in near], 1.0)
    light = LIGHT * np.array([n.lightest for n in near]) * arms**2
    return 1.0 / np.sqrt(np.where(masses == 0.0, light, masses))
