"""Linkages whose crank and output have given pairs of angles, or of an angle and a place of the slider.

The crank as it is seen from the output link: B moves on a circle about C, which is a dyad of these relative positions.
The crank's pivot, which goes round the output's pivot, is one that says nothing.

    5   only differences count: at most three linkages, all of them
    4   the direction of the crank at the first pair is taken as given: at most two
    3   that of the output as well; r and s in B = r (cos, sin) phi_1, C = D + s (cos, sin) psi_1 follow linearly in 1/r
        and 1/s, as by Freudenstein's equation
    2   one equation in r and s: the crank's length is free

Sources: McCarthy & Soh, Geometric Design of Linkages, 2nd ed. 2011, ch. 6; Freudenstein, Trans. ASME 77, 1955, 853-861.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.numeric.jets import Array
from freebody.study.synthesis.fewer import on_lines
from freebody.study.synthesis.five import five_positions
from freebody.study.synthesis.linkage import Linkage
from freebody.study.synthesis.positions import Dyad, Position, bar, rotation, rows_of, size_of
from freebody.study.synthesis.tasks import Task

_SAME = 1e-7  # in sizes: a dyad that says nothing
_FAR = 50.0  # cranks: rockers that are longer are left out
_CRANKS = (0.1, 3.0)  # of the frame, or of the slider's way: the lengths that are tried where one is free


def of_function(task: Task) -> tuple[tuple[Dyad, ...], tuple[Linkage, ...], str]:
    """Dyads, linkages, and how complete they are. Raises CannotAnswer where the pairs determine none."""
    positions = _relative(task)
    dyads, about = _dyads(task, positions)
    size = size_of(positions)
    good = [d for d in dyads if not d.is_slide and float(np.linalg.norm(d.moving)) > _SAME * size]
    return tuple(good), tuple(_generator(task, d) for d in good), about


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


def _dyads(task: Task, positions: Sequence[Position]) -> tuple[Sequence[Dyad], str]:
    assert task.pairs is not None
    if task.n == 5:
        five = five_positions(positions)
        n = sum(not d.is_slide and float(np.linalg.norm(d.moving)) > _SAME * size_of(positions) for d in five.dyads)
        proof = (
            Message("proved: these are all") if five.is_proved else Message("not proved: some of them nearly coincide")
        )
        return five.dyads, Message(
            "only differences of the angles count; real solutions: {n}; {proof}", n=n, proof=proof
        )
    if task.n == 4:
        (found,) = on_lines(positions, np.zeros(2), [float(task.pairs[0, 0])])
        return found, Message("the crank's angle at the first pair as given; of the output differences count")
    if task.n == 3:
        return _freudenstein(task, positions), Message("angles as given, from the frame; the only solution")
    low, high = _range(task)
    found = _cranks(task, positions)
    return found, Message(
        "angles as given, from the frame; the crank's length is free: {n} from {low:.3g} to {high:.3g} m",
        n=len(found),
        low=low,
        high=high,
    )


def _directions(task: Task) -> tuple[Array, Array, Array]:
    """Of B from the crank's pivot; C's base and the direction in which it is from there: along the rocker, or across
    the slide."""
    assert task.pairs is not None
    phi, out = (float(x) for x in task.pairs[0])
    e = np.array((math.cos(phi), math.sin(phi)))
    if task.linkage == "slider-crank":
        return e, np.array((out, 0.0)), np.array((0.0, 1.0))
    return e, np.array((task.frame, 0.0)), np.array((math.cos(out), math.sin(out)))


def _conditions(task: Task, positions: Sequence[Position]) -> tuple[Array, Array, Array, Array]:
    """alpha, beta, gamma, delta (n - 1,) of  alpha r s + beta r + gamma s + delta = 0  for the pairs but the first,
    read off; gamma is zero for a slider (s is then its offset), delta for a rocker."""
    e, base, along = _directions(task)

    def f(r: float, s: float) -> Array:
        return rows_of(positions, r * e) @ np.append(base + s * along, 1.0)

    delta = f(0.0, 0.0)
    beta, gamma = f(1.0, 0.0) - delta, f(0.0, 1.0) - delta
    return f(1.0, 1.0) - delta - beta - gamma, beta, gamma, delta


def _freudenstein(task: Task, positions: Sequence[Position]) -> list[Dyad]:
    """Of three pairs, linear in 1/r and s of a slider, in 1/r and 1/s of a rocker."""
    is_slider = task.linkage == "slider-crank"
    alpha, beta, gamma, delta = _conditions(task, positions)
    M = np.column_stack((alpha, delta) if is_slider else (beta, gamma))
    if abs(np.linalg.det(M)) <= 1e-14 * float(np.abs(M).max()) ** 2:
        raise CannotAnswer(Message("these three pairs determine no linkage: their equations depend on each other"))
    first, second = np.linalg.solve(M, -beta if is_slider else -alpha)
    if second == 0.0 or (first == 0.0 and not is_slider):
        raise CannotAnswer(Message("these three pairs determine no linkage: their equations depend on each other"))
    return [_dyad(task, positions, 1.0 / second, first if is_slider else 1.0 / first)]


def _cranks(task: Task, positions: Sequence[Position]) -> list[Dyad]:
    """Of two pairs: s by the crank's length r, whose logarithms are evenly spread."""
    (alpha,), (beta,), (gamma,), (delta,) = _conditions(task, positions)
    found: list[Dyad] = []
    for r in np.geomspace(*_range(task), task.samples):
        down, up = alpha * r + gamma, -(beta * r + delta)
        if abs(up) < _FAR * abs(down) * float(r):
            found.append(_dyad(task, positions, float(r), up / down))
    return found


def _range(task: Task) -> tuple[float, float]:
    """The least and the greatest crank that is tried."""
    assert task.pairs is not None
    size = task.frame
    if task.linkage == "slider-crank":  # a long rod moves its slider by no more than the chord of the crank
        (a, s), (b, t) = task.pairs[:2].tolist()
        size = (abs(t - s) or abs(s) or 1.0) / max(2 * abs(math.sin(0.5 * (b - a))), 1e-3)
    return _CRANKS[0] * size, _CRANKS[1] * size


def _dyad(task: Task, positions: Sequence[Position], r: float, s: float) -> Dyad:
    e, base, along = _directions(task)
    return bar(positions, r * e, base + s * along)


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
