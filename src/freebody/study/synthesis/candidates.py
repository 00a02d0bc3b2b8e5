"""All candidates of a task, each put together from two dyads.

    motion     two dyads of the coupler's positions
    path       with given crank angles: a four-bar whose coupler turns by these angles traces the points just as its
               cognates do, and their cranks turn as its coupler does
    function   the crank as it is seen from the output link: B moves on a circle about C, which is a dyad of these
               relative positions. The crank's pivot, which goes round the output's pivot, is one that says nothing.

With three pairs the directions of crank and output at the first pair are taken as given; then r and s in B = r (cos,
sin) phi_1, C = D + s (cos, sin) psi_1 follow linearly in 1/r and 1/s, as by Freudenstein's equation.
Sources: McCarthy & Soh, Geometric Design of Linkages, 2nd ed. 2011, ch. 5 and 6; Freudenstein, Trans. ASME 77, 1955,
853-861; Roberts, Proc. London Math. Soc. 7, 1875, 14-23 (cognates).
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import permutations
from typing import Any

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.numeric.jets import Array
from freebody.study.synthesis.fewer import by_pivot, by_points, curve, on_lines, slides
from freebody.study.synthesis.fitting import MOST_EXACT, fitted
from freebody.study.synthesis.five import five_positions
from freebody.study.synthesis.linkage import Linkage, cognates, driven_at_other_end
from freebody.study.synthesis.positions import (
    Dyad,
    Position,
    bar,
    inverted,
    lines_from,
    places,
    rotation,
    rows_of,
    size_of,
)
from freebody.study.synthesis.tasks import Task

_SAME = 1e-7  # in sizes: a dyad that says nothing
_ALIKE = 1e-3  # of the size: lengths of the same linkage
_REACH = 50.0  # sizes: a family's dyads that reach farther are left out


@dataclass(frozen=True)
class Found:
    """dyads: by which the candidates are put together; about: in words, how complete they are."""

    dyads: tuple[Dyad, ...]
    linkages: tuple[Linkage, ...]
    about: str


def candidates(task: Task) -> Found:
    """Raises CannotAnswer where the task determines none."""
    if task.points is not None:
        return _of_points(task, task.points)
    return _of_function(task) if task.kind == "function" else _of_positions(task)


def _of_points(task: Task, points: Array) -> Found:
    """A path without crank angles: exactly through few points, near many."""
    fits = fitted(points, is_closed=task.is_closed, full_turn=task.full_turn)
    linkages = _with_cognates(task, fits.linkages) if fits.is_met and task.n <= MOST_EXACT else fits.linkages
    if task.n > MOST_EXACT:
        about = Message("fitted to {n} points: the best of local searches, not proved", n=task.n)
    elif fits.is_met:
        about = Message(
            "{k} linkages through all {n} points, from {m} local searches and by cognates; the search is not complete",
            k=len(linkages),
            n=task.n,
            m=fits.n_searches,
        )
    else:
        about = Message(
            "none of {m} local searches has come through all {n} points, so the nearest are shown; the search is not "
            "complete",
            n=task.n,
            m=fits.n_searches,
        )
    return Found((), linkages, about)


def _with_cognates(task: Task, found: Sequence[Linkage]) -> tuple[Linkage, ...]:
    """With those that trace the same curve and have no defect: cognates, each driven at either ground pivot."""
    every = list(found)
    for linkage in found:
        for c in cognates(linkage):
            for one in (c, driven_at_other_end(c)):
                is_new = all(_lengths_apart(one, other) > _ALIKE * one.size for other in every)
                if is_new and not any(one.defects(full_turn=task.full_turn)):
                    every.append(one)
    return tuple(every)


def _lengths_apart(a: Linkage, b: Linkage) -> float:
    return max(abs(x - y) for x, y in zip(a.lengths.values(), b.lengths.values(), strict=True))


# -- motion and path --------------------------------------------------------------------------
def _of_positions(task: Task) -> Found:
    positions = task.positions
    if task.linkage != "four-bar" and len(positions) == 2:
        raise CannotAnswer(Message("two positions leave a slide free: give at least three"))
    bars, about = _bars(task, positions)
    P = np.array([(p.x, p.y) for p in positions])
    if task.linkage != "four-bar":
        is_inverted = task.linkage == "inverted-slider-crank"
        guides = _lines(task, positions) if is_inverted else _slides(task, positions)
        if not guides:
            about = "; ".join((about, _no_guide(len(positions), is_inverted=is_inverted)))
        make = _inverted if is_inverted else _slider_crank
        made = [make(positions, a, b, P) for a in bars for b in guides if _differ(a, b, positions)]
        return Found((*bars, *guides), tuple(made), about)
    pairs = [(a, b) for a, b in permutations(bars, 2) if _differ(a, b, positions)]
    four = [_four_bar(positions, a, b, P) for a, b in pairs]
    if task.kind == "path":
        four = [c for linkage in four if _is_first(linkage) for c in cognates(linkage)]
    return Found(bars, tuple(four), about)


def _no_guide(n: int, *, is_inverted: bool) -> str:
    """Of five positions all are found; of fewer those within reach."""
    if n < 5:
        return Message("no slide was found within reach")
    if is_inverted:
        return Message("no line of the coupler goes through a fixed pivot")
    return Message("no point of the coupler stays on a straight line")


def _is_first(linkage: Linkage) -> bool:
    """One of the two orders in which the same dyads are put together: their cognates are the same."""
    assert linkage.D is not None
    return (
        tuple(linkage.A) < tuple(linkage.D)
        if tuple(linkage.A) != tuple(linkage.D)
        else tuple(linkage.B[0]) < tuple(linkage.C[0])
    )


def _bars(task: Task, positions: Sequence[Position]) -> tuple[tuple[Dyad, ...], str]:
    n = len(positions)
    if n == 5:
        five = five_positions(positions)
        about = [Message("{n} real dyads, {k} complex", n=len(five.dyads), k=five.n_complex)]
        if n := sum(d.is_slide for d in five.dyads):
            about.append(Message("{n} of them with the fixed pivot at infinity, a slide", n=n))
        if five.n_infinite:
            about.append(
                Message(
                    "{n} with the moving pivot at infinity, a line of the coupler through a pivot", n=five.n_infinite
                )
            )
        if not n and not five.n_infinite:
            about.append(Message("none at infinity, so that no slide can take the place of a pin"))
        about.append(
            Message("proved: these are all") if five.is_proved else Message("not proved: some of them nearly coincide")
        )
        return tuple(d for d in five.dyads if d.is_bar), "; ".join(about)
    if task.pivots and n <= 3:
        found = [_at_pivot(positions, G) for G in task.pivots]
        return tuple(d for d in found if d is not None), Message("fixed pivots as chosen")
    family = [d for d in _family(task, positions) if not d.is_slide and _reach(d, positions) <= _REACH]
    return tuple(family), Message("{n} dyads of an infinite family, sampled", n=len(family))


def _at_pivot(positions: Sequence[Position], G: Array) -> Dyad | None:
    if len(positions) == 2:
        W = _moving_pivot(positions, G)
        return None if W is None else bar(positions, W, G)
    return by_pivot(positions, G)


def _moving_pivot(positions: Sequence[Position], G: Array) -> Array | None:
    """Of two positions: the nearest of the points that stay at one distance from G, which are on a line."""
    g = np.append(G, 1.0)
    at = [float(rows_of(positions, W)[0] @ g) for W in (np.zeros(2), np.array((1.0, 0)), np.array((0, 1.0)))]
    a = np.array((at[1] - at[0], at[2] - at[0]))
    return None if not float(a @ a) > 0.0 else G - a * float(a @ G + at[0]) / float(a @ a)


def _family(task: Task, positions: Sequence[Position]) -> Iterable[Dyad]:
    if len(positions) == 4:
        return curve(positions, task.samples)
    points = _sobol(task.samples, 3)
    at = np.array([(p.x, p.y) for p in positions])
    low, size = at.min(axis=0), size_of(positions)
    spread = low - size + (np.ptp(at, axis=0) + 2 * size) * points[:, :2]
    if len(positions) == 3:
        return [d for G in spread if (d := by_pivot(positions, G)) is not None]
    return [by_points(positions, W, 4.0 * float(part) - 2.0) for W, part in zip(spread, points[:, 2], strict=True)]


def _sobol(n: int, dimensions: int) -> Array:
    from scipy.stats import qmc

    made: Any = qmc.Sobol(dimensions, scramble=True, rng=0)
    return np.asarray(made.random(1 << (n - 1).bit_length())[:n], dtype=np.float64)


def _slides(task: Task, positions: Sequence[Position]) -> list[Dyad]:
    if len(positions) == 5:
        return [d for d in five_positions(positions).dyads if d.is_slide]
    angles = [math.pi * (k + 0.5) / task.samples for k in range(task.samples)]
    return [d for d in slides(positions, angles) if _reach(d, positions) <= _REACH]


def _lines(task: Task, positions: Sequence[Position]) -> list[Dyad]:
    """Lines of the coupler through fixed points: slides of the fixed plane, as the coupler sees it."""
    return lines_from(_slides(task, inverted(positions)))


def _reach(d: Dyad, positions: Sequence[Position]) -> float:
    far = max(0.0 if d.is_line else np.abs(d.moving).max(), 0.0 if d.is_slide else np.abs(d.fixed).max())
    return float(far) / (size_of(positions) + max(abs(p.x) + abs(p.y) for p in positions))


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


# -- function ---------------------------------------------------------------------------------
def _of_function(task: Task) -> Found:
    assert task.pairs is not None
    if len(task.pairs) > 5:
        raise CannotAnswer(
            Message("no linkage of four links is led exactly through {n} of them; at most 5", n=len(task.pairs))
        )
    positions = _relative(task)
    dyads, about = _function_dyads(task, positions)
    size = size_of(positions)
    good = [d for d in dyads if not d.is_slide and float(np.linalg.norm(d.moving)) > _SAME * size]
    return Found(tuple(good), tuple(_generator(task, d) for d in good), about)


def _relative(task: Task) -> tuple[Position, ...]:
    """The crank as it is seen from the output link, whose pivot is the frame's length to the right of the crank's."""
    assert task.pairs is not None
    phi, out = (task.pairs - task.pairs[0]).T
    if task.linkage == "slider-crank":
        return tuple(Position(float(-s), 0.0, float(a)) for a, s in zip(phi, out, strict=True))
    D = np.array((task.frame, 0.0))
    found: list[Position] = []
    for a, b in zip(phi, out, strict=True):
        x, y = D - rotation(-b) @ D
        found.append(Position(float(x), float(y), float(a - b)))
    return tuple(found)


def _function_dyads(task: Task, positions: Sequence[Position]) -> tuple[Sequence[Dyad], str]:
    assert task.pairs is not None
    phi, out = task.pairs[0]
    if task.n == 5:
        five = five_positions(positions)
        n = sum(not d.is_slide and float(np.linalg.norm(d.moving)) > _SAME * size_of(positions) for d in five.dyads)
        proof = (
            Message("proved: these are all") if five.is_proved else Message("not proved: some of them nearly coincide")
        )
        return five.dyads, Message(
            "only differences of the angles count; {n} real solutions; {proof}", n=n, proof=proof
        )
    if task.n == 4:
        (found,) = on_lines(positions, np.zeros(2), [float(phi)])
        return found, Message("the crank's angle at the first pair as given; of the output differences count")
    return _freudenstein(task, positions, float(phi), float(out)), Message(
        "angles as given, from the frame; the only solution"
    )


def _freudenstein(task: Task, positions: Sequence[Position], phi: float, out: float) -> list[Dyad]:
    """f_j(r, s) = alpha r s + beta r + gamma s + delta = 0 for j = 2, 3, whose numbers are read off; gamma is zero
    for a slider (s is then its offset), delta for a rocker."""
    e = np.array((math.cos(phi), math.sin(phi)))
    if task.linkage == "slider-crank":
        base, along = np.array((out, 0.0)), np.array((0.0, 1.0))
    else:
        base, along = np.array((task.frame, 0.0)), np.array((math.cos(out), math.sin(out)))

    def f(r: float, s: float) -> Array:
        return rows_of(positions, r * e) @ np.append(base + s * along, 1.0)

    delta = f(0.0, 0.0)
    beta, gamma = f(1.0, 0.0) - delta, f(0.0, 1.0) - delta
    alpha = f(1.0, 1.0) - delta - beta - gamma
    M = np.column_stack((alpha, delta)) if task.linkage == "slider-crank" else np.column_stack((beta, gamma))
    right = -beta if task.linkage == "slider-crank" else -alpha
    if abs(np.linalg.det(M)) <= 1e-14 * float(np.abs(M).max()) ** 2:
        raise CannotAnswer(Message("these three pairs determine no linkage: their equations depend on each other"))
    first, second = np.linalg.solve(M, right)  # of a slider s and 1/r, of a rocker 1/s and 1/r
    if second == 0.0 or (first == 0.0 and task.linkage != "slider-crank"):
        raise CannotAnswer(Message("these three pairs determine no linkage: their equations depend on each other"))
    s = first if task.linkage == "slider-crank" else 1.0 / first
    return [bar(positions, e / second, base + s * along)]


def _generator(task: Task, d: Dyad) -> Linkage:
    """The linkage in the fixed plane: the crank's pivot is the origin."""
    assert task.pairs is not None
    phi, out = (task.pairs - task.pairs[0]).T
    B = np.array([rotation(a) @ d.moving for a in phi])
    if task.linkage == "slider-crank":
        right = np.array((1.0, 0.0))
        return Linkage(np.zeros(2), B, np.array([d.fixed + s * right for s in out]), None, right)
    D = np.array((task.frame, 0.0))
    C = np.array([D + rotation(b) @ (d.fixed - D) for b in out])
    return Linkage(np.zeros(2), B, C, D)
