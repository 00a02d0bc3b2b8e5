"""Linkages to a task, beside pylinkage: found or not, how exactly, how fast.

    python benchmarks/synthesis.py            (with pylinkage in the same environment: pip install pylinkage)

Six four-bars at random (seeds 0 to 5) give positions, pairs and points; the task is to find them again. Found: a
solution with their four lengths to 1e-6. Error: of the best solution, in the task itself (m or rad). Time: of the
processor, the least of three, of the search alone; that of freebody besides with every candidate checked for defects.
Paths without crank angles are searched, and told is how far the best linkage is off the points. Slider-cranks pylinkage
does not synthesise.
"""

from __future__ import annotations

import math
import time
import warnings
from collections.abc import Callable, Iterator
from importlib import import_module
from typing import Any

import numpy as np

from freebody.study.synthesis.candidates import candidates
from freebody.study.synthesis.positions import Position, places
from freebody.study.synthesis.tasks import Task

ANGLES = (0.2, 0.7, 1.3, 1.9, 2.8)
SEEDS = range(6)
SEARCHED = range(3)  # where it takes seconds
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
        began = time.process_time()
        found = run()
        best = min(best, time.process_time() - began)
    return found, best


def ours(task: Task) -> tuple[list[tuple[float, ...]], float, float, float]:
    """Lengths of all candidates, the least error, seconds of the search, and with all defects told."""
    found, seconds = fastest(lambda: candidates(task))
    began = time.process_time()
    for linkage in found.linkages:
        list(linkage.defects(full_turn=True))
    told = seconds + time.process_time() - began
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
    sliders()
    free_paths()
    closed()


def closed() -> None:
    """24 points of a closed path, without crank angles."""
    for seed in SEARCHED:
        bar = FourBar(seed)
        points = [bar.at(float(t))[2] for t in np.linspace(0.0, math.tau, 24, endpoint=False)]
        if any(math.isnan(p.real) for p in points):
            continue
        missed, seconds, _n = searched("four-bar", points, closed=True)
        print(f"closed path of 24 points, seed {seed}: missed by {missed:.1e} m, {seconds:.1f} s")


def searched(linkage: str, points: list[complex], *, closed: bool) -> tuple[float, float, int]:
    """What the best linkage misses, seconds, and how many there are."""
    task = Task("", "path", linkage, points=np.array([(p.real, p.imag) for p in points]), is_closed=closed)
    began = time.process_time()
    found = candidates(task).linkages
    return min(x.missed for x in found), time.process_time() - began, len(found)


def free_paths() -> None:
    """Points of an arc of four-bars, without crank angles, beside pylinkage; and of slider-cranks."""
    synthesis = import_module("pylinkage.synthesis")
    for n in (4, 5):
        for seed in SEARCHED:
            bar = FourBar(seed)
            points = [bar.at(t)[2] for t in ANGLES[:n]]
            missed, seconds, k = searched("four-bar", points, closed=False)
            began = time.process_time()
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                peer = synthesis.path_generation([(p.real, p.imag) for p in points], require_grashof=False)
            took = time.process_time() - began
            off = min((off_curve(bar, s, points) for s in peer.raw_solutions), default=math.nan)
            print(f"path of {n} points, seed {seed}: {k} linkages, missed by {missed:.1e} m, {seconds:.1f} s; ", end="")
            print(f"pylinkage: {len(peer.raw_solutions)}, missed by {off:.1e} m, {took:.1f} s")


def off_curve(bar: FourBar, s: Any, points: list[complex]) -> float:
    """How far the points are at worst from the coupler curve of a solution of pylinkage, on both sides."""
    A, D, B, C, P = (
        complex(*x) for x in (s.ground_pivot_a, s.ground_pivot_d, s.crank_pivot_b, s.coupler_pivot_c, s.coupler_point)
    )
    lengths, frame = (abs(B - A), abs(C - B), abs(C - D), abs(D - A)), (D - A) / abs(D - A)

    def traced(theta: float, side: int) -> complex:
        b, c, _P = bar.at(theta, side, lengths)
        return A + frame * (b + (P - B) / (C - B) * (c - b))

    every = [(t, side) for t in np.linspace(0, math.tau, 1441).tolist() for side in (-1, 1)]
    at = np.array([traced(*one) for one in every])
    worst = 0.0
    for point in points:
        (theta, side), step = every[int(np.nanargmin(np.abs(at - point)))], math.tau / 1440
        for _ in range(40):  # thirds of an interval
            theta = min((theta - step, theta, theta + step), key=lambda t: _distance(traced(t, side), point))
            step *= 0.6
        worst = max(worst, _distance(traced(theta, side), point))
    return worst


def _distance(a: complex, b: complex) -> float:
    return abs(a - b) if math.isfinite(abs(a)) else math.inf


def sliders() -> None:
    """Crank 1, rod and offset at random: the tasks of slider-cranks, which give them back."""
    rows: dict[str, list[tuple[bool, int, float]]] = {}
    for seed in SEEDS:
        rng = np.random.default_rng(seed)
        rod, offset = float(rng.uniform(2.0, 3.5)), float(rng.uniform(-0.6, 0.6))
        for name, task in slider_tasks(rod, offset, is_searched=seed in SEARCHED):
            began = time.process_time()
            found = candidates(task).linkages
            took = time.process_time() - began
            own = [tuple(abs(x) for x in linkage.lengths.values()) for linkage in found]
            rows.setdefault(name, []).append((is_among((1.0, rod, abs(offset)), own), len(own), took))
    print("| slider-crank | found | solutions | time |")
    print("|---|---|---|---|")
    for name, every in rows.items():
        hits, n, took = (np.array(x, dtype=float) for x in zip(*every, strict=True))
        print(f"| {name} | {hits.sum():.0f} of {len(hits)} | {n.mean():.1f} | {1e3 * took.mean():.1f} ms |")


def slider_tasks(rod: float, offset: float, *, is_searched: bool) -> Iterator[tuple[str, Task]]:
    def at(theta: float) -> tuple[complex, float, float]:
        """P, the angle of the rod, where the slider is."""
        B = np.exp(1j * theta)
        phi = math.asin((offset - B.imag) / rod)
        return complex(B + (0.4 + 0.7j) * np.exp(1j * phi)), phi, float(B.real + rod * math.cos(phi))

    every = [(theta, *at(theta)) for theta in ANGLES]
    moved = tuple(Position(p.real, p.imag, phi) for _t, p, phi, _s in every)
    yield "motion, 5 positions", Task("", "motion", "slider-crank", positions=moved)
    for n in (3, 4, 5):
        pairs = np.array([(theta, s) for theta, _p, _phi, s in every[:n]])
        yield f"function, {n} pairs", Task("", "function", "slider-crank", pairs=pairs)
    timed = tuple(Position(p.real, p.imag, theta) for theta, p, _phi, _s in every)
    yield "path, 5 points with crank angles", Task("", "path", "slider-crank", positions=timed)
    if is_searched:
        for n, last, is_closed in ((8, 5.5, False), (24, math.tau * 23 / 24, True)):
            points = np.array([(p.real, p.imag) for t in np.linspace(0.0, last, n).tolist() for p in [at(t)[0]]])
            task = Task("", "path", "slider-crank", points=points, is_closed=is_closed)
            yield f"path, {n} points without crank angles", task


if __name__ == "__main__":
    main()
