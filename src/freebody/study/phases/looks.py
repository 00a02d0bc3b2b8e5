"""Where events are looked for on a motion that is followed in numbers: short pieces of it, and zeros in them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from freebody.numeric.brent import least_between, zero_between
from freebody.numeric.jets import Array

Watcher = Callable[[Array, Array, float], float]

_RTOL, _ATOL = 1e-12, 1e-13  # of the integrated motions, relative and [SI]
_OF_TIMES = 1e-14  # of roots, relative and [s]
_OF_DIPS = 1e-5  # [s] of the time at which something is least
_N_HALVINGS = 24  # of a look, towards its beginning
_N_LOOKS = 6  # places in a step at which events are looked for
_SLOPE = 1e-4  # of the time between two looks: over that slopes are taken


def looked_at(
    derivative: Callable[[float, Array], Array], y: Array, start: float, until: float
) -> Iterator[tuple[float, float, Callable[[float], Array]]]:
    """Short pieces of a motion, each with its state as a function of time."""
    for begin, end, state in steps(derivative, y, start, until):
        looks = [float(t) for t in np.linspace(begin, end, _N_LOOKS)]
        for a, b in pairwise(looks):
            yield a, b, state


def steps(
    derivative: Callable[[float, Array], Array], y: Array, start: float, until: float
) -> Iterator[tuple[float, float, Callable[[float], Array]]]:
    """The steps in which a motion is integrated."""
    from scipy.integrate import DOP853

    solver: Any = DOP853(derivative, start, y, until, rtol=_RTOL, atol=_ATOL)
    while solver.status == "running":
        solver.step()
        state: Callable[[float], Array] = solver.dense_output()
        yield float(solver.t_old), float(solver.t), state


@dataclass(frozen=True)
class Watched:
    """What falls through zero where an event is. may_pass: it may fall and come back between two looks. rate: its own,
    where it is an event too that it only comes to zero and turns; least: what it may then miss zero by."""

    value: Watcher
    may_pass: bool = False
    rate: Watcher | None = None
    least: float = 0.0

    def __call__(self, q: Array, v: Array, t: float) -> float:
        return self.value(q, v, t)


def zero_in(
    watched: Watched, state: Callable[[float], Array], n: int, a: float, b: float, *, is_below: bool
) -> float | None:
    """The time in a look at which a watched function comes to zero; it is positive at a, and at b unless `is_below`."""

    def along(watch: Watcher) -> Callable[[float], float]:
        def at(t: float) -> float:
            y = state(t)
            return watch(y[:n], y[n:], t)

        return at

    value = along(watched)
    turn = None if watched.rate is None else _turn(along(watched.rate), a, b)
    if turn is not None and abs(value(turn)) <= watched.least:
        return turn
    end = b if is_below else _dip(value, a, b) if watched.may_pass else None
    return None if end is None else zero_between(value, a, end, xtol=_OF_TIMES, rtol=_OF_TIMES)


def begins_in(
    watched: Sequence[Watched],
    armed: NDArray[np.bool_],
    now: Array,
    state: Callable[[float], Array],
    n: int,
    a: float,
    b: float,
    least: float,
) -> dict[int, float]:
    """From when in a look on each event may come: from a where it is armed; else, where it was zero at a and is below
    zero at b, from when it had risen."""
    found = dict.fromkeys(map(int, np.flatnonzero(armed)), a)
    for k in map(int, np.flatnonzero(~armed & (now < -least))):
        if (place := _risen_in(watched[k], state, n, a, b, least)) is not None:
            found[k] = place
    return found


def _risen_in(
    watched: Watched, state: Callable[[float], Array], n: int, a: float, b: float, least: float
) -> float | None:
    """A time in a look at which a watched function is above `least`, of one that is zero at a and below zero at b: a
    body that has just been thrown back may land again before the look ends. None where it has not risen."""
    for k in range(1, _N_HALVINGS):
        t = a + (b - a) * 0.5**k
        y = state(t)
        if watched(y[:n], y[n:], t) > least:
            return t
    return None


def _turn(rate: Callable[[float], float], a: float, b: float) -> float | None:
    """Where what has this rate turns from falling to rising."""
    return zero_between(rate, a, b, xtol=_OF_TIMES, rtol=_OF_TIMES) if rate(a) < 0.0 < rate(b) else None


def _dip(value: Callable[[float], float], a: float, b: float) -> float | None:
    """Where what is positive at both ends has fallen below zero between them: what moves freely passes through another
    body in one look."""
    h = _SLOPE * (b - a)
    if value(a + h) >= value(a) or value(b - h) >= value(b):
        return None
    place, least = least_between(value, a, b, xtol=_OF_DIPS)
    return place if least < 0.0 else None
