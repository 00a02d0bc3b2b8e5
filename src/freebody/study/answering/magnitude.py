"""How large the parts of a quantity are in a motion, by its dimension: its round-off is a part of them, also where they
cancel.

With L the size of the system, M its heaviest mass, V and A the largest speed and acceleration in it and F the largest
force (of loads, of connections, of inertia), the parts of a quantity of the dimension mass^a length^b time^c are up to

    F L^(b - 1) T^(c + 2)   and   M L^b T^c   for a = 1,        L^b T^c   for a = 0,        T = L/V and sqrt(L/A).

A mass or a moment of inertia (c = 0) is made of masses and lengths alone. A speed or an acceleration that is itself
round-off beside sqrt(L F/M) and F/M sets no time: a pendulum that hangs at rest has none.
"""

from __future__ import annotations

import math
from contextlib import suppress

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.expression import evaluate, free_symbols
from freebody.language.units import DIMENSIONLESS, Dimension
from freebody.model.elements import RATE, VALUE, AppliedLoad
from freebody.numeric.snapshot import Snapshot
from freebody.tolerances import ROUNDED


def magnitude(dimension: Dimension, seen: Snapshot) -> float:
    """[SI] The size of the parts of a quantity at an instant; zero where nothing sets one."""
    L, M = seen.reference.sizes.length, seen.reference.sizes.mass
    a, b, c = float(dimension.mass), float(dimension.length), float(dimension.time)
    if a not in (0.0, 1.0):
        return 0.0
    F, V, A = _force(seen), _speed(seen), _acceleration(seen)
    usual = F / M if M > 0.0 else 0.0
    times = [L / V] if math.sqrt(L * usual) * ROUNDED < V else []
    times += [math.sqrt(L / A)] if usual * ROUNDED < A else []

    def most(scale: float, length: float, time: float) -> float:
        if time == 0.0:
            return scale * L**length
        return max((scale * L**length * T**time for T in times), default=0.0)

    if a == 0.0:
        return most(1.0, b, c)
    return most(M, b, c) if c == 0.0 else max(most(M, b, c), most(F, b - 1, c + 2))


def power_size(of: str, seen: Snapshot) -> float:
    """[W] The size of the parts of the power of a load or a driver: each force by the fastest motion there is, whatever
    moves along it."""
    system, length, speed = seen.reference.system, seen.reference.sizes.length, _speed(seen)
    forces = [(_law(push, seen), push.measure) for push in system.applied_loads if push.load == of]
    forces += [(abs(seen.multiplier(row)), row.measure) for row in system.constraint_rows if row.connection == of]
    return sum(force / _per_length(measure.dimension, length) * speed for force, measure in forces)


def _speed(seen: Snapshot) -> float:
    """[m/s] The largest, that of a turn by the size of the system."""
    return float(np.abs(seen.v * _arms(seen)).max(initial=0.0))


def _acceleration(seen: Snapshot) -> float:
    with suppress(CannotAnswer):
        return float(np.abs(seen.accelerations * _arms(seen)).max(initial=0.0))
    return 0.0


def _arms(seen: Snapshot) -> np.ndarray:
    sizes = seen.reference.sizes
    return np.where(sizes.turning, sizes.length, 1.0)


def _force(seen: Snapshot) -> float:
    """[N] The largest of inertia, of the connections and of the loads; a moment by the size of the system."""
    sizes = seen.reference.sizes
    forces = [sizes.mass * _acceleration(seen)]
    for row in seen.reference.system.constraint_rows:
        with suppress(CannotAnswer):
            forces.append(abs(seen.multiplier(row)) / _per_length(row.measure.dimension, sizes.length))
    for push in seen.reference.system.applied_loads:
        with suppress(CannotAnswer, ArithmeticError, ValueError):
            forces.append(_law(push, seen) / _per_length(push.measure.dimension, sizes.length))
    return max(forces, default=0.0)


def _per_length(dimension: Dimension, length: float) -> float:
    return length if dimension == DIMENSIONLESS else 1.0


def _law(push: AppliedLoad, seen: Snapshot) -> float:
    """The law of a load, or, where it is one of its own measure, what a measure as large as the system makes of it."""
    found = abs(seen.law(push))
    needed = free_symbols(push.law)
    if push.measures or VALUE.name not in needed:
        return found
    is_angle = push.measure.dimension == DIMENSIONLESS
    values = {**seen.reference.frame.values, "t": seen.t, RATE.name: 0.0}
    values[VALUE.name] = 1.0 if is_angle else seen.reference.sizes.length
    return max(found, abs(float(evaluate(push.law, values))))
