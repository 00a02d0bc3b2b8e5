"""Small numbers for which an option and the answer differ, as one would put in by hand: m = 1 kg, theta = 30°."""

from __future__ import annotations

import random
from typing import Any

from freebody.assess.comparing import ComponentPair
from freebody.assess.points import BALL_FUNCTIONS, EvaluationPoint, is_free, real
from freebody.assess.setting import N_TRIES
from freebody.assess.words import NOT_REAL, digits, unit_behind
from freebody.language.expression import Symbol
from freebody.language.notation import to_text
from freebody.language.sentences import Message
from freebody.language.units import ACCELERATION


def counterexample(pair: ComponentPair) -> str:
    """The first numbers that show a difference, and both values with them."""
    free = [g for g in pair.generators if is_free(pair.field, g)]
    if pair.is_looped:
        return _told_at(pair, pair.setting.poses()[0])
    if not free:
        mine, its = pair.numbers(EvaluationPoint(pair.field, real))
        return Message("is {mine}, the answer is {its}", mine=digits(mine), its=digits(its))
    undefined: str | None = None
    for attempt in range(N_TRIES):
        point, words = _small_point(pair, free, attempt)
        mine, its = pair.numbers(point)
        admissible = all(point.number(c) > 0 for c in (*pair.option.conditions, *pair.setting.region))
        if not its.is_finite() or not admissible or digits(mine) == digits(its):
            continue
        told = _told_at(pair, point, ", ".join(words))
        if mine.is_finite():
            return told
        undefined = undefined or told
    return undefined or Message("differs from the answer")


def _told_at(pair: ComponentPair, point: EvaluationPoint, numbers: str = "") -> str:
    """Both values at a point; numbers: what was put in, if not the model's own."""
    unit = unit_behind(pair.setting.dimension)
    mine, its = map(digits, pair.numbers(point))
    mine, its = mine if mine == NOT_REAL else f"{mine}{unit}", f"{its}{unit}"
    if pair.setting.is_typed:
        if numbers:
            told = Message("for {numbers}: this gives {mine}, right is {its}", numbers=numbers, mine=mine, its=its)
        else:
            told = Message("with the model's own numbers: this gives {mine}, right is {its}", mine=mine, its=its)
        return told
    if numbers:
        return Message("for {numbers}: option {mine}, answer {its}", numbers=numbers, mine=mine, its=its)
    return Message("with the model's own numbers: option {mine}, answer {its}", mine=mine, its=its)


def _small_point(pair: ComponentPair, free: list[int], attempt: int) -> tuple[EvaluationPoint, list[str]]:
    field, setting, rng = pair.field, pair.setting, random.Random(attempt)
    values: dict[int, Any] = {}
    words: list[str] = []
    for place, g in enumerate(free):
        shown = field.generators[g].display
        # when positive numbers have shown nothing, what may be negative is
        is_turned = attempt > N_TRIES // 2 and not field.generators[g].positive
        sign = -1 if is_turned else 1
        if field.acute(g) or g in setting.angles:
            degrees = sign * (30, 45, 60)[(place + attempt) % 3]
            values[g] = BALL_FUNCTIONS["pi"] * degrees / 180
            words.append(f"{to_text(shown)} = {degrees}°")
            continue
        own = setting.own_numbers.get(g)
        is_weight = shown == Symbol("g") and setting.names.dimensions.get("g") == ACCELERATION
        small = place % 9 + 1 if not attempt else rng.randint(1, 5)
        values[g] = own if is_weight and own is not None else real(sign * small)
        words.append(f"{to_text(shown)} = {digits(values[g])}{setting.names.unit(shown)}")
    return EvaluationPoint(field, real, values), words
