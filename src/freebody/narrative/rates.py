"""How fast a quantity changes, in numbers: by differences along the motion that the numeric route finds.

The curve q + h v + h^2 a/2, v + h a, t + h has the tangent of the motion, so that central differences along it, and
Richardson's extrapolation of these, tend to the rate of any quantity of position, velocity and time.
"""

from __future__ import annotations

from collections.abc import Callable

from freebody.narrative.glossary import World

STEP = 2e-3  # in the time that the fastest coordinate needs for a radian, or a metre
NOISE = 1e-8  # a rate below this, by the size of the quantity in that time, is none

Read = Callable[[World], float]


def rate_of(read: Read) -> Read:
    """Reads the rate of what `read` reads."""

    def rate(world: World) -> float:
        v = world.snapshot.v
        fastest = max(1.0, float(abs(v).max(initial=0.0)))
        wide, narrow = (_pair(read, world, factor * STEP / fastest) for factor in (1.0, 0.5))
        found = (4 * narrow[0] - wide[0]) / 3
        return 0.0 if abs(found) < NOISE * wide[1] * fastest else found

    return rate


def _pair(read: Read, world: World, h: float) -> tuple[float, float]:
    """The difference quotient, and the size of what is subtracted."""
    later, before = read(moved(world, h)), read(moved(world, -h))
    return (later - before) / (2 * h), max(abs(later), abs(before))


def moved(world: World, h: float) -> World:
    """The world a little later; positions and velocities only."""
    here, reference = world.snapshot, world.snapshot.reference
    a = here.accelerations
    q = reference.frame.moved(here.q, h * here.v + 0.5 * h * h * a)
    later = reference.snapshot(q, here.v + h * a, here.t + h, here)
    return World(world.glossary, world.draw, later)
