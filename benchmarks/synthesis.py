"""Linkages to a task, beside pylinkage: found or not, how exactly, how fast.

    python benchmarks/synthesis.py            (with pylinkage in the same environment: pip install pylinkage)

Six four-bars at random (seeds 0 to 5) give positions, pairs and points; the task is to find them again. Found: a
solution with their four lengths to 1e-6. Error: of the best solution, in the task itself (m or rad). Time: the least of
three, of the search alone; that of freebody besides with every candidate checked for defects.
"""

from __future__ import annotations

import math
import time
import warnings
from collections.abc import Callable, Iterator
from importlib import import_module
from typing import Any

import numpy as np

import freebody as fb
from freebody.study.synthesis.candidates import candidates
from freebody.study.synthesis.positions import Position, places
from freebody.study.synthesis.tasks import Task

ANGLES = (0.2, 0.7, 1.3, 1.9, 2.8)
SEEDS = range(6)
Pair = tuple[float, float]


class FourBar:
    """Crank 1 on a frame along x, coupler and rocker at random; P on the coupler."""

    def __init__(self, seed: int) -> None:
        rng = np.random.default_rng(seed)
        self.b, self.c = (float(x) for x in rng.uniform(2.5, 3.5, 2))
        self.d = float(rng.uniform(2.0, 3.0))

    @property
    def lengths(self) -> tuple[float, ...]:
        return 1.0, self.b, self.c, self.d

    def at(self, theta: float, side: int = 1, lengths: Any = None) -> tuple[complex, complex, complex]:
        """B, C and P as complex numbers."""
        a, b, c, d = lengths or self.lengths
        B = a * np.exp(1j * theta)
        r = d - B
        cosine = (b * b + abs(r) ** 2 - c * c) / (2 * b * abs(r))
        if abs(cosine) > 1:
            return B, complex("nan"), complex("nan")
        turn = r / abs(r) * np.exp(1j * side * math.acos(cosine))
        return B, B + b * turn, B + (0.4 + 0.7j) * turn

    def pairs(self, n: int) -> list[Pair]:
        found: list[Pair] = []
        for theta in ANGLES[:n]:
            _B, C, _P = self.at(theta)
            found.append((theta, float(np.angle(C - self.d))))
        return found

    def positions(self) -> list[Position]:
        found: list[Position] = []
        for theta in ANGLES:
            B, C, P = self.at(theta)
            found.append(Position(float(P.real), float(P.imag), float(np.angle(C - B))))
        return found


def tasks(bar: FourBar) -> Iterator[tuple[str, Task, Callable[[Any], Any]]]:
    """By name: the task of freebody, and the call of pylinkage."""
    positions = bar.positions()
    poses = [(p.x, p.y, p.angle) for p in positions]
    yield (
        "motion, 5 positions",
        Task("", "motion", positions=tuple(positions)),
        lambda s: s.motion_generation([s.Pose(*p) for p in poses], max_solutions=None, require_grashof=False),
    )
    for n in (3, 4, 5):
        pairs = bar.pairs(n)
        yield (
            f"function, {n} pairs",
            Task("", "function", pairs=np.array(pairs), frame=bar.d),
            lambda s, p=pairs: s.function_generation(p, ground_length=bar.d, require_grashof=False),
        )
    timed = tuple(Position(p.x, p.y, theta) for p, theta in zip(positions, ANGLES, strict=True))
    points = [(p.x, p.y) for p in positions]
    yield (
        "path, 5 points with crank angles",
        Task("", "path", positions=timed),
        lambda s: s.path_generation_with_timing(points, list(ANGLES), require_grashof=False),
    )


def fastest(run: Callable[[], Any]) -> tuple[Any, float]:
    best, found = math.inf, None
    for _ in range(3):
        began = time.perf_counter()
        found = run()
        best = min(best, time.perf_counter() - began)
    return found, best


def ours(task: Task) -> tuple[list[tuple[float, ...]], float, float, float]:
    """Lengths of all candidates, the least error, seconds of the search, and with all defects told."""
    found, seconds = fastest(lambda: candidates(task))
    began = time.perf_counter()
    for linkage in found.linkages:
        list(linkage.defects(full_turn=True))
    told = seconds + time.perf_counter() - began
    error = min((linkage.residual * linkage.size for linkage in found.linkages), default=math.nan)
    return [tuple(linkage.lengths.values()) for linkage in found.linkages], error, seconds, told


def theirs(
    bar: FourBar, name: str, task: Task, call: Callable[[Any], Any]
) -> tuple[list[tuple[float, ...]], float, float]:
    synthesis = import_module("pylinkage.synthesis")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            result, seconds = fastest(lambda: call(synthesis))
        except Exception as error:  # what it cannot do is told
            print(f"  pylinkage, {name}: {type(error).__name__}: {error}")
            return [], math.nan, math.nan
    raw = list(result.raw_solutions)
    lengths = [(s.crank_length, s.coupler_length, s.rocker_length, s.ground_length) for s in raw]
    errors = [_error(bar, name, task, s) for s in raw]
    return lengths, min(errors, default=math.nan), seconds


def _error(bar: FourBar, name: str, task: Task, s: Any) -> float:
    """How far a solution of pylinkage is from the task."""
    if name.startswith("motion"):
        worst = 0.0
        for moving, fixed in ((s.crank_pivot_b, s.ground_pivot_a), (s.coupler_pivot_c, s.ground_pivot_d)):
            r = places(task.positions, np.array(moving)) - np.array(fixed)
            worst = max(worst, float(np.ptp(np.linalg.norm(r, axis=1))))
        return worst
    lengths = (s.crank_length, s.coupler_length, s.rocker_length, s.ground_length)
    if name.startswith("function"):
        assert task.pairs is not None
        sides = [
            [float(np.angle(bar.at(t, side, lengths)[1] - lengths[3])) - psi for t, psi in task.pairs]
            for side in (-1, 1)
        ]
        return min(float(np.abs(np.angle(np.exp(1j * np.array(x)))).max()) for x in sides)
    return _of_path(bar, task, s, lengths)


def _of_path(bar: FourBar, task: Task, s: Any, lengths: tuple[float, ...]) -> float:
    """The crank turns from its first place as it should; how far the traced point is then off."""
    if s.coupler_point is None:
        return math.nan
    A, D, B, C, P = (
        complex(*x) for x in (s.ground_pivot_a, s.ground_pivot_d, s.crank_pivot_b, s.coupler_pivot_c, s.coupler_point)
    )
    frame = (D - A) / abs(D - A)
    local = (P - B) / (C - B)
    errors: list[float] = []
    for side in (-1, 1):
        worst = 0.0
        for p in task.positions:
            theta = float(np.angle((B - A) / frame)) + p.angle - task.positions[0].angle
            b, c, _P = bar.at(theta, side, lengths)
            missed = abs(A + frame * (b + local * (c - b)) - complex(p.x, p.y))
            worst = max(worst, missed) if math.isfinite(missed) else math.inf
        errors.append(worst)
    finite = [x for x in errors if math.isfinite(x)]
    return min(finite, default=math.nan)


def is_among(wanted: tuple[float, ...], found: list[tuple[float, ...]]) -> bool:
    return any(np.abs(np.array(x) - wanted).max() < 1e-6 for x in found)


def main() -> None:
    rows: dict[str, list[list[float]]] = {}
    for seed in SEEDS:
        bar = FourBar(seed)
        for name, task, call in tasks(bar):
            own, error, seconds, told = ours(task)
            peer, peer_error, peer_seconds = theirs(bar, name, task, call)
            row = [is_among(bar.lengths, own), len(own), error, seconds, told]
            row += [is_among(bar.lengths, peer), len(peer), peer_error, peer_seconds]
            rows.setdefault(name, []).append([float(x) for x in row])
    head = ("found", "solutions", "worst error", "time", "with defects")
    print("| task | " + " | ".join((*head, *(f"pylinkage: {h}" for h in head[:4]))) + " |")
    print("|" + "---|" * 10)
    for name, every in rows.items():
        x = np.array(every)
        cells = [f"{x[:, 0].sum():.0f} of {len(x)}", f"{x[:, 1].mean():.1f}", f"{np.nanmax(x[:, 2]):.0e}"]
        cells += [f"{1e3 * x[:, k].mean():.1f} ms" for k in (3, 4)]
        errors = x[:, 7][np.isfinite(x[:, 7])]
        cells += [f"{x[:, 5].sum():.0f} of {len(x)}", f"{x[:, 6].mean():.1f}"]
        cells += [f"{errors.max():.0e}" if len(errors) else "-", f"{1e3 * np.nanmean(x[:, 8]):.1f} ms"]
        print(f"| {name} | {' | '.join(cells)} |")
    closed()


def closed() -> None:
    """24 points of a closed path, without crank angles."""
    found, seconds = 0, 0.0
    for seed in SEEDS:
        bar = FourBar(seed)
        points = [bar.at(float(t))[2] for t in np.linspace(0.0, math.tau, 24, endpoint=False)]
        if any(math.isnan(p.real) for p in points):
            continue
        began = time.perf_counter()
        best = fb.synthesise({"task": "path", "points": [[p.real, p.imag] for p in points]}, most=1).candidates[0]
        seconds += time.perf_counter() - began
        found += best.linkage.missed < 1e-6
        print(f"  closed path of 24 points, seed {seed}: missed by {best.linkage.missed:.1e} m")
    print(f"closed path of 24 points: {found} found exactly, {seconds / len(SEEDS):.1f} s each")


if __name__ == "__main__":
    main()
