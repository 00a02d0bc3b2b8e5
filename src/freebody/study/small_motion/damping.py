"""How small oscillations die away, in closed form."""

from __future__ import annotations

import math
from collections.abc import Callable

from freebody.errors import CannotAnswer, SaysNothing
from freebody.language.sentences import Message
from freebody.numeric.small_motion import SmallMotion
from freebody.numeric.vibration import natural_motions
from freebody.questions.reading import Question
from freebody.questions.small_motion import Damping
from freebody.study.answering.at_equilibrium import NOTHING_DRIVES_BACK
from freebody.study.answering.finding import Finding
from freebody.study.setup import Setup
from freebody.study.small_motion.resting import AtRest, beside, compared, oscillates
from freebody.symbolic.conditions import Condition, insisted
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.small_motion import free_oscillations


def damping(setup: Setup, question: Question, q: Damping, at_rest: AtRest) -> Finding:
    free = free_oscillations(setup.model, setup.start, setup.rest_of_small_motion)
    f, is_negative = setup.model.field, setup.model.samples.is_negative
    modes = [mode for mode in free.modes if not mode.square.is_zero()]
    if not modes:
        raise CannotAnswer(NOTHING_DRIVES_BACK)
    if len(modes) > 1 and not q.is_of_all:
        raise CannotAnswer(
            Message(
                "there are {n} modes that oscillate, each with its damping; ask for damping ratios, damped frequencies "
                "or logarithmic decrements",
                n=len(modes),
            )
        )
    conditions = [*at_rest(free.rest, ">"), *oscillates(free, modes)]
    parts: list[Ratio] = []
    for mode in modes:
        decay, omega = free.decay(mode), f.sqrt(mode.square, is_negative)
        if q.what in ("ratio", "ratios"):
            parts.append(f.lowest_terms(decay / (2 * omega)))
            continue
        if q.what == "quality":
            undamped = CannotAnswer(Message("nothing damps the motion, so it has no quality factor"))
            conditions += insisted([Condition(decay, ">", Message("damped"))], undamped)
            parts.append(f.lowest_terms(omega / decay))
            continue
        left = f.lowest_terms(mode.square - decay * decay / 4)
        creeps = CannotAnswer(Message("it is overdamped for all values: it creeps back without swinging"))
        conditions += insisted([Condition(left, ">", Message("underdamped"))], creeps)
        damped = f.sqrt(left, is_negative)
        parts.append(
            damped
            if q.what in ("frequency", "frequencies")
            else f.lowest_terms(2 * f.pi / damped)
            if q.what == "period"
            else f.lowest_terms(f.pi * decay / damped)
        )
    read = beside(lambda small: damped_values(small, q))
    evidence = compared(setup, question, parts, free.equilibrium, conditions, read)
    notes = list(free.notes)
    if not free.linear.is_damped:
        notes.append(Message("nothing damps the motion"))
    element = parts[0] if len(parts) == 1 else tuple(parts)
    return Finding(element, evidence, conditions, notes, may_be_complex=free.are_real_by_symmetry)


def damped_values(small: SmallMotion, q: Damping) -> list[float]:
    """By the exponents s: zeta = -Re s/|s| of a pair, -(s1 + s2)/(2 sqrt(s1 s2)) of two real ones."""
    rates = [m.rate for m in natural_motions(small) if m.kind != "rigid"]
    pairs = [s for s in rates if s.imag]
    alone = sorted((s.real for s in rates if not s.imag), reverse=True)
    if alone and (q.what not in ("ratio", "ratios", "quality") or len(alone) != 2 or pairs):
        raise SaysNothing(Message("a motion is overdamped"))
    if alone:
        ratio = -(alone[0] + alone[1]) / (2.0 * math.sqrt(alone[0] * alone[1]))
        return [1.0 / (2.0 * ratio) if q.what == "quality" else ratio]
    pairs.sort(key=abs)
    read: dict[str, Callable[[complex], float]] = {
        "ratio": lambda s: -s.real / abs(s),
        "quality": lambda s: abs(s) / (-2.0 * s.real),
        "freq": lambda s: abs(s.imag),
        "period": lambda s: math.tau / abs(s.imag),
        "decrement": lambda s: -s.real * math.tau / abs(s.imag),
    }
    by = next(value for key, value in read.items() if q.what.startswith(key))
    return [by(s) for s in pairs]
