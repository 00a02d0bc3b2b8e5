"""A pose in which angles can be seen: in a textbook no pendulum is drawn along the line its angle is counted from.

A file has to say where a motion starts, and says zero where that does not matter. It does not if every question is
about any instant, or about small motions; then angles that start at zero, at rest, are drawn as if they did not.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from freebody.errors import FreebodyError
from freebody.language.expression import ZERO, number
from freebody.questions.reading import Question
from freebody.study.pictures.instant import Instant, start_of
from freebody.system.system import System

_FIRST, _APART = 25.0, 20.0  # [deg] the first of several angles, and how much larger each further one is
_MISSED = 1e-3  # [rad]


def general_position(system: System) -> Instant | None:
    """The system with its angles opened; None where it has to be drawn at its start, or has no such pose."""
    angles = [name for name in system.start if _is_free(system, name)]
    if system.space or not angles or not system.questions or any(map(_is_of_start, system.questions)):
        return None
    opened = {name: _FIRST + k * _APART for k, name in enumerate(angles)}
    start = {**system.start, **{name: number(round(math.radians(x), 4)) for name, x in opened.items()}}
    try:
        found = start_of(replace(system, start=start), at_rest=True)
    except FreebodyError:
        return None
    return found if _is_there(found, system, opened) else None


def _is_free(system: System, name: str) -> bool:
    """Whether an angle starts at zero and at rest."""
    measure = system.measures.get(name)
    is_still = system.start_rates.get(name, ZERO) == ZERO
    return measure is not None and measure.is_angle and system.start[name] == ZERO and is_still


def _is_of_start(question: Question) -> bool:
    """Whether an answer depends on where the motion starts."""
    is_later = question.event is not None or question.transition is not None
    return question.at_start or is_later or question.quantity.scope not in ("instant", "small motion", "every motion")


def _is_there(found: Instant, system: System, opened: dict[str, float]) -> bool:
    values = ((found.snapshot.value(system.measures[name]), math.radians(x)) for name, x in opened.items())
    return all(abs(float(value) - x) < _MISSED for value, x in values)


__all__: Sequence[str] = ["general_position"]
