"""Events: where something watched is zero, found on the dense output of a step and mended by a step of its own.

The last step is looked at in `N_PARTS` parts. Between points of unlike sign there is a crossing, found by bisection
and secants (Brent); where the absolute value has its least between points of like sign there may be a touch, which
counts if it comes within round-off of zero. The state at an event is then computed by a step that ends there, and its
time improved by Newton's method, so that it is as exact as any step.

Defined behaviour: something that is zero at the start is an event of kind "start" there, and no crossing until it has
been different from zero; something that is zero throughout a step is said once ("zero"); events at one instant are
listed in the order of the watches; a terminal event ends the motion at its time, and later ones are not reported.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np
import scipy.optimize

from freebody.numeric.engine import stepping
from freebody.numeric.engine.course import Happening
from freebody.numeric.engine.layout import Floats

if TYPE_CHECKING:
    from freebody.numeric.engine.engine import Watch
    from freebody.numeric.engine.motion import Motion

_optimize: Any = scipy.optimize
N_PARTS = 4
ZERO = 1e-12  # by the size of what is watched
TOUCH = 1e-9


def found_in_step(motion: Motion, until: float | None = None) -> bool:
    """Adds the events of the last step, up to a time in it; True if a terminal one ends the motion there."""
    run, watches = motion.run, motion.engine.watches
    t0, h = float(run.clock[stepping.BEFORE]), float(run.clock[stepping.DONE_STEP])
    y = np.zeros_like(run.states[0])

    def values(s: float) -> list[float]:
        return motion.values_at(s, y, t0 + s * h)

    def one(k: int, s: float) -> float:
        return values(s)[k]

    parts = [k / N_PARTS for k in range(N_PARTS + 1)]
    table = np.array([motion.values_before, *(values(s) for s in parts[1:])])
    motion.values_before = table[-1].tolist()
    found: list[tuple[float, int, str]] = []
    for k, watch in enumerate(watches):
        column = table[:, k]
        if np.abs(column).max() <= ZERO * watch.size:
            motion.say_zero(watch, t0)
            continue
        for s, kind in _zeros(column, parts, partial(one, k), watch):
            if watch.direction == 0 or (kind == "rising") == (watch.direction > 0) or kind == "touch":
                found.append((s, k, kind))
    found.sort(key=lambda item: (item[0], item[1]))
    for s, k, kind in found:
        watch = watches[k]
        if until is not None and t0 + s * h > until:
            break
        t, state = _mended(motion, watch, k, t0, s * h) if kind != "touch" else (t0 + s * h, None)
        happening = Happening(t, watch.name, kind, watch.is_terminal and kind != "touch")
        motion.add(happening, state)
        if happening.is_terminal:
            return True
    return False


def _zeros(
    column: Floats, parts: list[float], value: Callable[[float], float], watch: Watch
) -> list[tuple[float, str]]:
    """Where one watch is zero along the step, and how."""
    zero = ZERO * watch.size
    found: list[tuple[float, str]] = []
    for i in range(len(parts) - 1):
        a, b = float(column[i]), float(column[i + 1])
        if abs(a) <= zero:
            continue  # it was found as the end of the part before, or is the start
        kind = "rising" if a < 0.0 else "falling"
        if abs(b) <= zero:
            after = float(column[i + 2]) if i + 2 < len(parts) else 0.0
            if after * a <= 0.0:
                found.append((parts[i + 1], kind))
            elif watch.measure is not None:
                found.append((parts[i + 1], "touch"))
        elif a * b < 0.0:
            found.append((_root(value, parts[i], parts[i + 1]), kind))
    if found or watch.measure is None:
        return found
    # no crossing between the points: the least value may touch zero, or cross it twice
    k = int(np.abs(column).argmin())
    if k == 0 and abs(column[0]) <= zero:
        return found  # it leaves the zero at which it started
    low, high = parts[max(0, k - 1)], parts[min(len(parts) - 1, k + 1)]
    scale = float(np.abs(column).max())
    if 0 < k < len(parts) - 1 or abs(column[k]) < 0.2 * scale:
        side = 1.0 if column[k] > 0.0 else -1.0

        def height(s: float) -> float:
            return side * value(float(s))

        least = _optimize.minimize_scalar(height, bounds=(low, high), method="bounded", options={"xatol": 1e-10})
        s, x = float(least.x), float(least.fun)
        inside = low + 1e-7 < s < high - 1e-7
        if inside and x < -zero:
            kind = "falling" if side > 0.0 else "rising"
            back = "rising" if side > 0.0 else "falling"
            found.append((_root(value, low, s), kind))
            found.append((_root(value, s, high), back))
        elif inside and x <= TOUCH * watch.size:
            found.append((s, "touch"))
    return found


def _root(value: Callable[[float], float], low: float, high: float) -> float:
    return float(_optimize.brentq(value, low, high, xtol=1e-15, rtol=1e-14))


def _mended(motion: Motion, watch: Watch, k: int, t0: float, h: float) -> tuple[float, Floats | None]:
    """The time of a crossing and the state there, by steps of their own from the start of the last step."""
    state: Floats | None = None
    for _ in range(3):
        step = motion.step_of(h)
        if step is None:
            return t0 + h, state
        state, values, rates = step
        if watch.measure is None or watch.order != 0 or rates[k] == 0.0:
            break
        correction = values[k] / rates[k]
        if not abs(correction) < 1e-3 * h:
            break
        h -= correction
        if abs(correction) <= 4e-16 * max(abs(t0 + h), h):
            break
    return t0 + h, state
