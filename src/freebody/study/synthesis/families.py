"""The dyads of a task's positions: all of five positions; of fewer a choice of infinitely many, and what was chosen.

Free are, of a bar of 4, 3 and 2 positions, 1, 2 and 3 numbers: a line through a pole, the fixed pivot, and besides
where the moving pivot is on its line. Of a slide of 3 and 2 positions 1 and 2: its direction, and where its point is.
They are samples of Sobol's within a range round the positions, or as the task chooses them: `pivots`, `within`,
`slide`.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.numeric.jets import Array
from freebody.study.synthesis.fewer import by_pivot, by_pivot_near, by_point, curve, slides, turned_pair
from freebody.study.synthesis.five import five_positions
from freebody.study.synthesis.positions import Dyad, Position, inverted, lines_from, size_of
from freebody.study.synthesis.tasks import Task

_REACH = 50.0  # sizes: a family's dyads that reach farther are left out


def bars(task: Task) -> tuple[tuple[Dyad, ...], list[Message]]:
    """And in words, how complete they are."""
    n = task.n
    if n > 3 and turned_pair(task.positions) is None:
        return _translated(task)
    if n == 5:
        return _five(task)
    found = [d for d in _family(task) if d.is_bar and _is_near(d, task)]
    if n == 4:
        return tuple(found), [Message("bars of an infinite family, one number of which is sampled: {n}", n=len(found))]
    if task.pivots and n == 3:
        return tuple(found), [Message("bars at the chosen fixed pivots: {n}", n=len(found))]
    if task.pivots:
        return tuple(found), [
            Message("bars at the chosen fixed pivots, their moving pivots sampled: {n}", n=len(found))
        ]
    low, high = (_shown(x) for x in _range(task))
    told = (
        Message("bars with fixed pivots sampled from {low} to {high} m: {n}", n=len(found), low=low, high=high)
        if n == 3
        else Message(
            "bars with fixed pivots sampled from {low} to {high} m, and moving ones: {n}",
            n=len(found),
            low=low,
            high=high,
        )
    )
    return tuple(found), [told]


def guides(task: Task) -> tuple[list[Dyad], list[Message]]:
    """Slides, or of an inverted slider-crank lines of the coupler through fixed pivots; and in words what is free."""
    is_inverted = task.linkage == "inverted-slider-crank"
    seen = inverted(task.positions) if is_inverted else task.positions
    if task.n == 5 and turned_pair(seen) is not None:
        found = [d for d in five_positions(seen).dyads if d.is_slide]
    else:
        chosen = task.slide is not None
        angles = [task.slide] if task.slide is not None else _angles(task.samples)
        found = [d for d in slides(seen, angles, _near(task, seen), is_chosen=chosen) if _reach(d, seen) <= _REACH]
    found = [d for d in (lines_from(found) if is_inverted else found) if _is_within(d, task)]
    if not found:
        is_all = task.n == 5 or turned_pair(seen) is None
        return [], [_no_guide(is_all=is_all, is_inverted=is_inverted)]
    return found, [_about_guides(task, len(found), is_inverted=is_inverted)]


def _about_guides(task: Task, n: int, *, is_inverted: bool) -> Message:
    """What is free of them, and how it was chosen."""
    if task.n > 3:
        return Message("one line of the coupler goes through a fixed pivot") if is_inverted else Message("one slide")
    if task.slide is not None:
        return (
            Message("lines of the coupler through fixed pivots, in the chosen direction: {n}", n=n)
            if is_inverted
            else Message("slides in the chosen direction: {n}", n=n)
        )
    if is_inverted:
        return Message("lines of the coupler through fixed pivots, sampled: {n}", n=n)
    if task.n == 3:
        return Message("slides with sampled directions: {n}", n=n)
    return Message("slides of sampled points of the coupler: {n}", n=n)


def sobol(n: int, dimensions: int, seed: int = 0) -> Array:
    """(n, dimensions) numbers from 0 to 1."""
    from scipy.stats import qmc

    made: Any = qmc.Sobol(dimensions, scramble=True, rng=seed)
    return np.asarray(made.random(1 << (n - 1).bit_length())[:n], dtype=np.float64)


def _no_guide(*, is_all: bool, is_inverted: bool) -> Message:
    """is_all: whether all were looked at; else those within reach."""
    if not is_all:
        return Message("no slide was found within reach")
    if is_inverted:
        return Message("no line of the coupler goes through a fixed pivot")
    return Message("no point of the coupler stays on a straight line")


def _five(task: Task) -> tuple[tuple[Dyad, ...], list[Message]]:
    five = five_positions(task.positions)
    about = [Message("{n} real dyads, {k} complex", n=len(five.dyads), k=five.n_complex)]
    n = sum(d.is_slide for d in five.dyads)
    if n:
        about.append(Message("{n} of them with the fixed pivot at infinity, a slide", n=n))
    if five.n_infinite:
        about.append(
            Message("{n} with the moving pivot at infinity, a line of the coupler through a pivot", n=five.n_infinite)
        )
    if not n and not five.n_infinite:
        about.append(Message("none at infinity, so that no slide can take the place of a pin"))
    about.append(
        Message("proved: these are all") if five.is_proved else Message("not proved: some of them nearly coincide")
    )
    return tuple(d for d in five.dyads if d.is_bar and _is_within(d, task)), about


def _translated(task: Task) -> tuple[tuple[Dyad, ...], list[Message]]:
    """Of four or five positions that are all turned alike: the places of every point are on a circle, or of none."""
    moving = _spread(task.samples, *_range(task, moving=True))
    found = [d for W in moving if (d := by_point(task.positions, W)) is not None and _is_within(d, task)]
    if not found:
        raise CannotAnswer(
            Message("all positions are turned alike, and their places are on no circle: no bar leads through them")
        )
    return tuple(found), [Message("all positions are turned alike: bars of sampled moving pivots, {n}", n=len(found))]


def _family(task: Task) -> Iterator[Dyad]:
    positions, n = task.positions, task.n
    if n == 4:
        yield from curve(positions, task.samples)
        return
    fixed: Sequence[Array] = task.pivots or _spread(task.samples, *_range(task))
    if n == 3:
        yield from (d for G in fixed if (d := by_pivot(positions, G)) is not None)
        return
    moving = _spread(task.samples, *_range(task, moving=True), seed=1)
    each = [(G, moving) for G in fixed] if task.pivots else [(G, [W]) for G, W in zip(fixed, moving, strict=True)]
    for G, some in each:
        yield from (d for W in some if (d := by_pivot_near(positions, G, W)) is not None)


def _near(task: Task, seen: Sequence[Position]) -> Sequence[Array]:
    """Where points that move on straight lines are looked for; inverted these are the fixed pivots."""
    is_inverted = seen is not task.positions
    if is_inverted and task.pivots:
        return task.pivots
    return _spread(task.samples, *_range(task, moving=not is_inverted), seed=2)


def _angles(n: int) -> list[float]:
    return [math.pi * (k + 0.5) / n for k in range(n)]


def _range(task: Task, *, moving: bool = False) -> tuple[Array, Array]:
    """Corners: for fixed pivots those of the task, or a size round the positions; for moving ones round both."""
    if task.within and not moving:
        return task.within
    fixed = [*task.pivots, *(task.within or ())]
    size = size_of(task.positions)
    at = np.array([*((p.x, p.y) for p in task.positions), *fixed])
    return at.min(axis=0) - size, at.max(axis=0) + size


def _spread(n: int, low: Array, high: Array, seed: int = 0) -> list[Array]:
    return list(low + (high - low) * sobol(n, 2, seed))


def _shown(corner: Array) -> str:
    return f"({corner[0]:.3g}, {corner[1]:.3g})"


def _is_near(d: Dyad, task: Task) -> bool:
    return _reach(d, task.positions) <= _REACH and _is_within(d, task)


def _is_within(d: Dyad, task: Task) -> bool:
    """Whether a fixed pivot is where the task allows it."""
    if not task.within or d.is_slide:
        return True
    low, high = task.within
    return bool(((d.fixed >= low) & (d.fixed <= high)).all())


def _reach(d: Dyad, positions: Sequence[Position]) -> float:
    far = max(0.0 if d.is_line else np.abs(d.moving).max(), 0.0 if d.is_slide else np.abs(d.fixed).max())
    return float(far) / (size_of(positions) + max(abs(p.x) + abs(p.y) for p in positions))
