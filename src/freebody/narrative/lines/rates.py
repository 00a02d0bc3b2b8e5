"""How fast a quantity changes, in numbers: by differences along the motion that the numeric route finds.

The curve q + h v + h^2 a/2, v + h a, t + h has the tangent of the motion, so that central differences along it, and
Richardson's extrapolation of these, tend to the rate of any quantity of position, velocity and time.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from freebody.narrative.lines.glossary import World
from freebody.numeric.snapshot import snapshot_of

STEP = 2e-3  # in the time that the fastest coordinate needs for a radian, or a metre
NOISE = 1e-8  # a rate below this, by the size of the quantity in that time, is none

Read = Callable[[World], float]
ReadVector = Callable[[World], Sequence[float]]


def rate_of(read: Read) -> Read:
    """Reads the rate of what `read` reads."""
    rates = rates_of_vector(lambda world: (read(world),))
    return lambda world: rates(world)[0]


def rates_of_vector(read: ReadVector) -> ReadVector:
    """The same for several quantities that are read together."""

    def rates(world: World) -> tuple[float, ...]:
        fastest = max(1.0, float(abs(world.snapshot.v).max(initial=0.0)))
        h = STEP / fastest
        far = tuple(tuple(map(float, read(moved(world, e)))) for e in (-h, h))
        near = tuple(tuple(map(float, read(moved(world, e)))) for e in (-h / 2, h / 2))
        found: list[float] = []
        for k in range(len(far[0])):
            coarse, fine = (far[1][k] - far[0][k]) / (2 * h), (near[1][k] - near[0][k]) / h
            rate, size = (4 * fine - coarse) / 3, max(abs(far[0][k]), abs(far[1][k]))
            found.append(0.0 if abs(rate) < NOISE * size * fastest else rate)
        return tuple(found)

    return rates


def moved(world: World, h: float) -> World:
    """The world a little later; positions and velocities only."""
    here, reference = world.snapshot, world.snapshot.reference
    a = here.accelerations
    q = reference.frame.moved(here.q, h * here.v + 0.5 * h * h * a)
    later = snapshot_of(reference, q, here.v + h * a, here.t + h, here)
    return World(world.glossary, world.draw, later)
