"""Where formulas are compared: admissible points, the same in every run.

Platforms compare formulas by numbers of their own, which know nothing of the mechanics: roots of negative numbers come
out, poses in which a loop does not close. So a package has its points with it: parameters within their signs, motions
that the constraints admit, every other one near the model's own numbers.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress

from freebody.assess.names import named_in
from freebody.assess.points import EvaluationPoint, working_precision
from freebody.assess.setting import Setting
from freebody.errors import FreebodyError
from freebody.study.answering.answer import Answer

N_POINTS = 6


def points_of(answer: Answer, names: Iterable[str]) -> tuple[Mapping[str, float], ...]:
    """Values of names and of their rates, as "rate(name)", and of all that stands in the answer, at points at which it
    has a value; none where it is no formula."""
    if answer.solved is None or answer.solved.element is None:
        return ()
    try:
        setting = answer.solved.setting(is_typed=True)
    except FreebodyError:
        return ()
    parts = answer.expression if isinstance(answer.expression, tuple) else (answer.expression,)
    inside = [key for part in parts if part is not None for key in named_in(part)]
    keys = dict.fromkeys([*(key for name in names for key in (name, f"rate({name})")), *inside])
    with working_precision():
        return tuple(_found(setting, tuple(key for key in keys if key in setting.names)))


def _found(setting: Setting, keys: tuple[str, ...]) -> Iterator[Mapping[str, float]]:
    left = N_POINTS
    for point in setting.poses() or setting.points():
        if left and all(_real(point.number(x)) is not None for x in setting.answers or ()):
            yield dict(_values(setting, point, keys))
            left -= 1


def _values(setting: Setting, point: EvaluationPoint, keys: tuple[str, ...]) -> Iterator[tuple[str, float]]:
    for key in keys:
        with suppress(FreebodyError, KeyError, ArithmeticError, ValueError):
            if (value := _real(point.number(setting.names.element(key)))) is not None:
                yield key, value


def _real(ball: object) -> float | None:
    """The middle of a ball; None where there is no finite one."""
    value = float(ball)  # type: ignore[arg-type]
    return value if math.isfinite(value) else None
