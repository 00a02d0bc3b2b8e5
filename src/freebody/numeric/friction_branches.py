"""Limits of rest where friction depends on the size of a force whose direction is open: pins, two-sided guides.

|T| <= c |r| with r = (lambda_i, lambda_j) is no convex condition. Cut into sectors of directions it is, up to what a
sector leaves open: with e the middle of a sector of half width d,

    e . r <= |r| <= e . r / cos d.

The right side is a bound, from which the best sector is cut further until both agree at the force that it found (branch
and bound). The bound is exact on the edges of a sector, so it is cut beside the force: next to the cut at a distance d
the bound is too large by d^2/2 at most. A force along one line has two sectors of width zero, and nothing is left open.
The walls of a sector that narrow are nearer to each other than a linear program tells apart, so that one may seem to
decide where friction does. From the force found there the load is e . r with e along it, which is |r| there and less
beside it, in a wide sector, until the force stays the same.
Source: Land & Doig, Econometrica 28, 1960, 497-520.
"""

from __future__ import annotations

import heapq
import itertools
import math
from collections.abc import Callable
from dataclasses import dataclass, replace

from freebody.numeric import friction_limits as limits
from freebody.numeric.friction_limits import Optimum, Ray
from freebody.numeric.rest_problem import FrictionCone, RestProblem
from freebody.tolerances import ROUND_OFF

N_SECTORS = 8
_NARROW = 2e-7  # half a sector's width at which its bound is the value
_EXCESS = 2e-14  # what a bound at an angle of that width is too large by
_WIDE, _N_ALONG, _SAME = (
    1e-2,
    6,
    1e-6,
)  # half a sector about the force; how often; a value that is the same but for walls
MOST = 4000

Solve = Callable[[RestProblem], Optimum | None]


@dataclass(frozen=True)
class Sector:
    """Directions of the force that loads a cone, about the middle angle."""

    middle: float
    half: float
    share: float = 0.0  # of e . r that is taken for the size of the force; 0: as much as bounds it

    @property
    def taken(self) -> float:
        return self.share or 1.0 / math.cos(self.half)

    def excess(self, x: float, y: float) -> float:
        """By what part of it the bound exceeds the size of the force (x, y)."""
        size = math.hypot(x, y)
        if self.half == 0.0 or size == 0.0:
            return 0.0
        e = x * math.cos(self.middle) + y * math.sin(self.middle)
        return max(0.0, e / math.cos(self.half) / size - 1.0)

    def cut(self, x: float, y: float) -> tuple[Sector, Sector]:
        """Two parts, with the force (x, y) close to an edge of its part: halves, unless it is nearer to an edge than to
        the middle; then its part is twice as wide as it is away from that edge."""
        away = math.remainder(math.atan2(y, x) - self.middle, 2 * math.pi)
        near = max(self.half - abs(away), _NARROW)
        cut = 0.0 if near > self.half / 2 else math.copysign(self.half - 2 * near, away)
        low, high = (self.half + cut) / 2, (self.half - cut) / 2
        return Sector(self.middle - self.half + low, low), Sector(self.middle + self.half - high, high)


def margin(problem: RestProblem) -> Optimum | None:
    """`friction_limits.margin` for all loads of friction."""
    return _best(problem, limits.margin)


def extreme(ray: Ray, sign: int, *, unit: float = 1.0) -> Optimum | None:
    """`friction_limits.extreme` for all loads of friction."""

    def solve(problem: RestProblem) -> Optimum | None:
        return limits.extreme(replace(ray, problem=problem), sign, unit=unit)

    return _best(ray.problem, solve, sign)


def pieces(ray: Ray, *, unit: float = 1.0) -> list[tuple[Optimum, Optimum]]:
    """The intervals of the parameter with which the system can be held, as their ends: a force along one line that
    presses either way with friction (a screw that locks itself) leaves values between two of them that do not hold."""
    lines = [k for k, cone in enumerate(ray.problem.cones) if len(cone.size) == 1]
    found: list[tuple[Optimum, Optimum]] = []
    for sectors in itertools.product(*(_all_sectors(ray.problem.cones[k]) for k in lines)):
        one = replace(ray, problem=_in_sectors(ray.problem, dict(zip(lines, sectors, strict=True))))
        low, high = (extreme(one, sign, unit=unit) for sign in (-1, 1))
        if low is not None and high is not None:
            found.append((low, high))
    joined: list[tuple[Optimum, Optimum]] = []
    for low, high in sorted(found, key=lambda ends: ends[0].value):
        if joined and low.value <= joined[-1][1].value + ROUND_OFF * unit:
            start, end = joined.pop()
            joined.append((start, max(end, high, key=lambda o: o.value)))
        else:
            joined.append((low, high))
    return joined


def spread(problem: RestProblem, row: int) -> tuple[Optimum, Optimum] | None:
    """`friction_limits.spread` for all loads of friction."""
    ends: list[Optimum] = []
    for k, sign in enumerate((-1, 1)):

        def solve(p: RestProblem, k: int = k) -> Optimum | None:
            found = limits.spread(p, row)
            return None if found is None else found[k]

        best = _best(problem, solve, sign)
        if best is None:
            return None
        ends.append(best)
    return ends[0], ends[1]


def _best(problem: RestProblem, solve: Solve, sign: int = 1) -> Optimum | None:
    """The optimum over all sectors of all loads of open direction."""
    sized = [k for k, cone in enumerate(problem.cones) if cone.size]
    if not sized:
        return solve(problem)
    count = itertools.count()
    heap: list[tuple[float, int, tuple[Sector, ...], Optimum]] = []

    def offer(sectors: tuple[Sector, ...]) -> None:
        found = solve(_in_sectors(problem, dict(zip(sized, sectors, strict=True))))
        if found is not None:
            heapq.heappush(heap, (-sign * found.value, next(count), sectors, found))

    for sectors in itertools.product(*(_all_sectors(problem.cones[k]) for k in sized)):
        offer(sectors)
    for _ in range(MOST):
        if not heap:
            return None
        _key, _n, sectors, found = heapq.heappop(heap)
        if math.isinf(found.value):
            return found
        loads = [_load(problem.cones[k], found) for k in sized]
        excess = [sector.excess(*load) for sector, load in zip(sectors, loads, strict=True)]
        worst = max(range(len(sectors)), key=excess.__getitem__)
        if excess[worst] <= _EXCESS or sectors[worst].half <= _NARROW:
            return _along_the_force(problem, solve, dict(zip(sized, sectors, strict=True)), found)
        for part in sectors[worst].cut(*loads[worst]):
            offer((*sectors[:worst], part, *sectors[worst + 1 :]))
    return heap[0][3] if heap else None


def _along_the_force(problem: RestProblem, solve: Solve, sectors: dict[int, Sector], found: Optimum) -> Optimum:
    """The optimum with the loads as they are at the force that it finds; what was found, where that is another one."""
    last = found
    for _ in range(_N_ALONG):
        along: dict[int, Sector] = {}
        for k, sector in sectors.items():
            x, y = _load(problem.cones[k], last)
            has_direction = sector.half > 0.0 and math.hypot(x, y) > 0.0
            along[k] = Sector(math.atan2(y, x), _WIDE, 1.0) if has_direction else sector
        better = solve(_in_sectors(problem, along))
        if better is None or not abs(better.value - found.value) <= _SAME * max(1.0, abs(found.value)):
            return found
        if better.value == last.value:
            break
        last = better
    return last


def _load(cone: FrictionCone, found: Optimum) -> tuple[float, float]:
    """The force that loads a cone, where its direction is open in the plane."""
    return (0.0, 0.0) if len(cone.size) == 1 else (found.forces[cone.size[0]], found.forces[cone.size[1]])


def _all_sectors(cone: FrictionCone) -> list[Sector]:
    if len(cone.size) == 1:
        return [Sector(0.0, 0.0), Sector(math.pi, 0.0)]
    half = math.pi / N_SECTORS
    return [Sector((2 * k + 1) * half, half) for k in range(N_SECTORS)]


def _in_sectors(problem: RestProblem, sectors: dict[int, Sector]) -> RestProblem:
    """The problem with linear loads: each at its upper bound in a sector, the force kept inside it."""
    cones: list[FrictionCone] = []
    walls: list[tuple[tuple[int, float], ...]] = []
    for k, cone in enumerate(problem.cones):
        sector = sectors.get(k)
        if sector is None:
            cones.append(cone)
            continue
        if len(cone.size) == 1:
            sign = math.copysign(1.0, math.cos(sector.middle))
            cones.append(replace(cone, load=((cone.size[0], sign),), size=()))
            walls.append(((cone.size[0], sign),))
            continue
        i, j = cone.size
        c, s = math.cos(sector.middle), math.sin(sector.middle)
        wide = sector.taken
        cones.append(replace(cone, load=((i, c * wide), (j, s * wide)), size=()))
        for side in (-1.0, 1.0):
            # n . r >= 0 with n turned a quarter towards the middle from the edge of the sector
            edge = sector.middle + side * sector.half
            walls.append(((i, side * math.sin(edge)), (j, -side * math.cos(edge))))
    return replace(problem, cones=tuple(cones), walls=(*problem.walls, *walls))
