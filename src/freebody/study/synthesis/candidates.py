"""All candidates of a task, each put together from two dyads, or found by searches.

    motion     two dyads of the coupler's positions
    path       with given crank angles: a linkage whose coupler turns by these angles traces the points just as its
               cognates do, and their cranks turn as its coupler does. A slide leads through four positions, a bar
               through five: more points, and those without crank angles, are met or approached by searches
    function   two dyads of the crank as the output sees it (`functions`)

Sources: McCarthy & Soh, Geometric Design of Linkages, 2nd ed. 2011, ch. 5 and 6; Roberts, Proc. London Math. Soc. 7,
1875, 14-23 (cognates).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import permutations

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message, further
from freebody.numeric.jets import Array
from freebody.study.synthesis.families import bars, guides
from freebody.study.synthesis.fitting import Fits, fitted, most_met
from freebody.study.synthesis.functions import of_function
from freebody.study.synthesis.linkage import Linkage, cognates, driven_at_other_end
from freebody.study.synthesis.positions import Dyad, Position, places, size_of
from freebody.study.synthesis.tasks import MOST_EXACT, Task

_SAME = 1e-7  # in sizes: dyads with the same pivot
_ALIKE = 1e-3  # of the size: lengths of the same linkage


@dataclass(frozen=True)
class Found:
    """dyads: by which the candidates are put together, none of searches; about: in words, how complete they are."""

    dyads: tuple[Dyad, ...]
    linkages: tuple[Linkage, ...]
    about: str


def candidates(task: Task) -> Found:
    """Raises CannotAnswer where the task determines none."""
    if task.kind == "function":
        return Found(*of_function(task))
    if task.kind == "motion":
        return _of_positions(task)
    if task.points is not None or task.linkage == "inverted-slider-crank" or task.n > MOST_EXACT:
        return _searched(task)
    most = most_met(task.linkage, is_timed=True)
    try:
        found = _of_positions(task)
    except CannotAnswer:
        if task.n <= most:
            raise
        return _searched(task)
    return found if found.linkages or task.n <= most else _searched(task)


# -- searches ---------------------------------------------------------------------------------
def _searched(task: Task) -> Found:
    """A path without crank angles, or with more of them than dyads meet: exactly through few points, near many."""
    points, turns = task.points, None
    if points is None:
        points = np.array([(p.x, p.y) for p in task.positions])
        turns = np.array([p.angle - task.positions[0].angle for p in task.positions])
    fits = fitted(points, task.linkage, turns=turns, is_closed=task.is_closed, full_turn=task.full_turn)
    is_timed = turns is not None
    linkages = _with_cognates(task, fits.linkages) if fits.is_met and not is_timed else fits.linkages
    return Found((), linkages, _about_search(task, fits, len(linkages), is_timed=is_timed))


def _about_search(task: Task, fits: Fits, k: int, *, is_timed: bool) -> str:
    """How many points are met, and how far the list may be from complete."""
    n, m, most = task.n, fits.n_searches, most_met(task.linkage, is_timed=is_timed)
    if not fits.is_met:
        if n > most:
            return further(
                Message("in general at most {most} points are met; fitted to {n}", most=most, n=n),
                Message("the best of {m} local searches, not proved", m=m),
            )
        return further(
            Message("none of {m} local searches has come through all {n} points, so the nearest are shown", m=m, n=n),
            Message("the search is not complete"),
        )
    if is_timed or task.linkage == "inverted-slider-crank":
        found = Message("linkages through all {n} points: {k}, from {m} local searches", k=k, n=n, m=m)
    else:
        found = Message("linkages through all {n} points: {k}, from {m} local searches and by cognates", k=k, n=n, m=m)
    if n > most:
        return further(found, Message("that there are no others is not proved"))
    if fits.n_free > 0:
        found = further(found, Message("numbers that stay free: {free}", free=fits.n_free))
    return further(found, Message("the search is not complete"))


def _with_cognates(task: Task, found: Sequence[Linkage]) -> tuple[Linkage, ...]:
    """With those that trace the same curve and have no defect: cognates, a four-bar driven at either ground pivot."""
    every = list(found)
    for linkage in found:
        for c in cognates(linkage):
            for one in (c,) if c.is_slider else (c, driven_at_other_end(c)):
                is_new = all(_lengths_apart(one, other) > _ALIKE * one.size for other in every)
                if is_new and not any(one.defects(full_turn=task.full_turn)):
                    every.append(one)
    return tuple(every)


def _lengths_apart(a: Linkage, b: Linkage) -> float:
    return max(abs(abs(x) - abs(y)) for x, y in zip(a.lengths.values(), b.lengths.values(), strict=True))


# -- dyads ------------------------------------------------------------------------------------
def _of_positions(task: Task) -> Found:
    positions = task.positions
    first, about = bars(task)
    P = np.array([(p.x, p.y) for p in positions])
    if task.linkage == "four-bar":
        pairs = [(a, b) for a, b in permutations(first, 2) if _differ(a, b, positions)]
        if task.kind == "path":
            pairs = [(a, b) for a, b in pairs if _is_first(a, b)]
        made = [_four_bar(positions, a, b, P) for a, b in pairs]
        every = first
    else:
        second, told = guides(task)
        about += told
        make = _inverted if task.linkage == "inverted-slider-crank" else _slider_crank
        made = [make(positions, a, b, P) for a in first for b in second if _differ(a, b, positions)]
        every = (*first, *second)
    if task.kind == "path":
        made = [c for linkage in made for c in cognates(linkage)]
    return Found(every, tuple(made), further(*about))


def _is_first(a: Dyad, b: Dyad) -> bool:
    """One of the two orders in which the same dyads are put together: their cognates are the same."""
    return (*a.fixed, *a.moving) < (*b.fixed, *b.moving)


def _differ(a: Dyad, b: Dyad, positions: Sequence[Position]) -> bool:
    """Whether the pivots of a bar are not those of another dyad, as far as that has some."""
    size = size_of(positions)
    is_moving_apart = b.is_line or float(np.linalg.norm(a.moving - b.moving)) > _SAME * size
    return is_moving_apart and (b.is_slide or float(np.linalg.norm(a.fixed - b.fixed)) > _SAME * size)


def _four_bar(positions: Sequence[Position], a: Dyad, b: Dyad, P: Array) -> Linkage:
    return Linkage(a.fixed, places(positions, a.moving), places(positions, b.moving), b.fixed, P=P)


def _slider_crank(positions: Sequence[Position], a: Dyad, b: Dyad, P: Array) -> Linkage:
    return Linkage(a.fixed, places(positions, a.moving), places(positions, b.moving), None, b.fixed, P)


def _inverted(positions: Sequence[Position], a: Dyad, b: Dyad, P: Array) -> Linkage:
    return Linkage(a.fixed, places(positions, a.moving), places(positions, b.fixed), b.fixed, b.moving, P)
