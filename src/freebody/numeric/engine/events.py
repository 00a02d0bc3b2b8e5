"""Events: where something watched is zero, found in every step by `search` and mended by steps of their own.

Defined behaviour: something that is zero at the start is an event of kind "start" there, and no crossing until it has
been different from zero; something that is zero throughout a step is said once ("zero"); what comes to zero and goes
back, or crosses it so little that the resolution of the search hides it, is a "touch"; events at one instant are listed
in the order of the watches; a terminal event ends the motion at its time, and later ones are not reported. Touches
are not terminal.

The state at an event is that after a step of its own from where the step began, and the time is improved by Newton's
method on such steps, so that both are as exact as any step.

A long step may leap over all of a buffer, as where nothing else makes its error large; what lies between is seen by the
dense output alone, which is wrong then. It is found out by a step of its own to where a border is passed. The motion
then begins anew where that step began, with a short one.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from freebody.numeric.engine.course import Event
from freebody.numeric.engine.search import StepZero
from freebody.numeric.kernels import stepped_run
from freebody.numeric.kernels.arrays import Floats

if TYPE_CHECKING:
    from freebody.numeric.engine.evaluator import EngineWatch
    from freebody.numeric.engine.patrol import Violation
    from freebody.numeric.engine.underway import MotionUnderWay

N_MENDED = 4
OFF = 1e-4  # by the size of what is watched, that the dense output may be off; more is another count of turns
LEAPT = "leapt"  # the kind of what ends a motion where a step leapt over a border
PLACES = (0.2113, 0.5437, 0.8771)  # of a step, where what is zero at both ends is looked at


def found_in_step(motion: MotionUnderWay, violation: Violation | None = None) -> bool:
    """Adds the events of the last step, up to the violation of a guard in it; True if a terminal one ends the motion
    there. What is zero where the guard is violated (a measure at the limit at which a stop strikes) comes just then,
    whichever of the two searches is ahead of the other by round-off."""
    run = motion.run
    t0, h = float(run.clock[stepped_run.BEFORE]), float(run.clock[stepped_run.DONE_STEP])
    found: list[tuple[float, int, StepZero]] = []
    for k, (watch, search) in enumerate(zip(motion.engine.watches, motion.searches, strict=True)):
        zeros = list(search.in_step(run))
        if watch.is_border and zeros and _leaps(motion, watch, k, zeros[0], h):
            motion.add(Event(t0, watch.name, LEAPT, is_terminal=True), run.states[stepped_run.OLD].copy())
            return True
        if max(map(abs, search.ends)) <= search.zero and _is_zero_throughout(motion, k, t0, h):
            motion.say_zero(watch, t0)
            search.forget()
            continue
        if search.unsearched is not None:
            motion.say_unsearched(watch.name, search.unsearched)
        elif run.clock[stepped_run.NOW] >= motion.until and (last := search.at_end()) is not None:
            zeros.append(last)
        if violation is not None:
            zeros = _up_to(motion, k, zeros, violation, t0, h)
        for zero in zeros:
            if watch.direction == 0 or (zero.kind == "rising") == (watch.direction > 0) or zero.kind == "touch":
                found.append((round(zero.part, 13), k, zero))
    found.sort(key=lambda item: item[:2])
    for _part, k, zero in found:
        watch = motion.engine.watches[k]
        t, state = _mended(motion, watch, k, zero, t0, h)
        if violation is not None and t > violation.time:
            t, state = violation.time, violation.state.copy()
        happening = Event(t, watch.name, zero.kind, watch.is_terminal and zero.kind != "touch")
        motion.add(happening, state)
        if happening.is_terminal:
            return True
    return False


def _leaps(motion: MotionUnderWay, watch: EngineWatch, k: int, zero: StepZero, h: float) -> bool:
    """Whether a border is not where the dense output has it: nothing that this shows in the step can be relied on."""
    there = None if zero.kind == "touch" else motion.step_of(zero.part * h)
    return there is not None and abs(motion.derivatives_of(k)[0]) > OFF * watch.size


def _up_to(
    motion: MotionUnderWay, k: int, zeros: list[StepZero], violation: Violation, t0: float, h: float
) -> list[StepZero]:
    """The zeros of a watch that do not come after a violation."""
    before = [zero for zero in zeros if t0 + zero.part * h <= violation.time]
    if before or not zeros:
        return before
    value = motion.values_at(-1.0, violation.state.copy(), violation.time)[k]
    is_there = abs(value) <= motion.searches[k].zero
    return [StepZero((violation.time - t0) / h, zeros[0].kind)] if is_there else []


def _is_zero_throughout(motion: MotionUnderWay, k: int, t0: float, h: float) -> bool:
    """Whether something that is zero at both ends of a step is so within it, in states that hold what is held."""
    y, zero = np.zeros_like(motion.run.states[0]), motion.searches[k].zero
    return all(abs(motion.values_at(s, y, t0 + s * h)[k]) <= zero for s in PLACES)


def _mended(
    motion: MotionUnderWay, watch: EngineWatch, k: int, zero: StepZero, t0: float, h: float
) -> tuple[float, Floats]:
    """The time of an event and the state there. A touch is where the rate is zero."""
    order = watch.order + (zero.kind == "touch")
    at, least = zero.part * h, math.inf
    best: tuple[float, Floats] | None = None
    for _ in range(N_MENDED):
        state = motion.step_of(at)
        if state is None:
            break
        derivatives = motion.derivatives_of(k)
        size = abs(derivatives[order]) if order < 2 else 0.0
        if not size < least or size > OFF * watch.size:
            break
        best, least = (at, state), size
        if order > 1 or derivatives[order + 1] == 0.0:
            break
        correction = derivatives[order] / derivatives[order + 1]
        if not abs(correction) < 1e-3 * at or abs(correction) <= 4e-16 * max(abs(t0 + at), at):
            break
        at = min(at - correction, h)
    if best is None:
        state = np.zeros_like(motion.run.states[0])
        motion.values_at(zero.part, state, t0 + zero.part * h)
        best = zero.part * h, state
    return t0 + best[0], best[1]
