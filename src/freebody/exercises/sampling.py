"""States of a model at which formulas are compared in numbers by platforms that know no mechanics.

Names have values that fit each other: measures and rates are those of one motion, parameters have their signs, and the
answer is one there. Where only differences count (an energy), each state comes with a later one of the same motion.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass

from freebody.assess.points import EvaluationPoint, working_precision
from freebody.assess.setting import Setting
from freebody.errors import FreebodyError
from freebody.language.units import TIME, Dimension
from freebody.study.answering.answer import Answer

N_STATES = 4
_MOST_RATES = 2
_LATER = 1000  # added to the seed of a state

State = Mapping[str, float]  # by names; rates as "rate(x)"


@dataclass(frozen=True)
class Sampling:
    """units: of all names that have values, in SI, empty for none; states: the first one near the model's own numbers;
    later: one for each of them where only differences count."""

    units: Mapping[str, str]
    states: tuple[State, ...]
    later: tuple[State, ...] = ()


def sampling_of(answer: Answer) -> Sampling | None:
    """None where there is no formula to compare with."""
    solved = answer.solved
    if solved is None or answer.expression is None:
        return None
    with working_precision():
        setting = solved.setting(is_typed=True)
        if setting.answers is None:
            return None
        points = setting.poses() if setting.poses() else list(_first(setting, 2 * N_STATES))[::-1]
        units = _units(setting)
        states: list[State] = []
        later: list[State] = []
        for seed, point in enumerate(points):
            state = _state(setting, point, units)
            after = _state(setting, point.later(_LATER + seed), units) if solved.up_to_constant else state
            if state and after:
                states.append(state)
                later.append(after)
            if len(states) == N_STATES:
                break
    known = [name for name in units if all(name in state for state in (*states, *later))]
    return Sampling(
        {name: units[name] for name in known},
        tuple({name: state[name] for name in known} for state in states),
        tuple({name: state[name] for name in known} for state in later) if solved.up_to_constant else (),
    )


def _first(setting: Setting, n: int) -> Iterator[EvaluationPoint]:
    for _, point in zip(range(n), setting.points(), strict=False):
        yield point


def _units(setting: Setting) -> dict[str, str]:
    """Of all names and of the rates of what moves."""
    found = {name: _shown(dimension) for name, dimension in setting.names.dimensions.items()}
    for name, dimension in setting.names.dimensions.items():
        key, unit = f"rate({name})", dimension / TIME
        while key in setting.names and key.count("rate(") <= _MOST_RATES:
            found[key] = _shown(unit)
            key, unit = f"rate({key})", unit / TIME
    return found


def _shown(dimension: Dimension) -> str:
    return "" if str(dimension) == "1" else str(dimension)


def _state(setting: Setting, point: EvaluationPoint, names: Mapping[str, str]) -> State:
    """Values of the names that have one; none where the answer has none."""
    found: dict[str, float] = {}
    assert setting.answers is not None
    with suppress(FreebodyError, ArithmeticError, ValueError):
        if not all(math.isfinite(float(point.number(x))) for x in setting.answers):
            return {}
    for name in names:
        with suppress(FreebodyError, ArithmeticError, ValueError, KeyError, NotImplementedError):
            value = float(point.number(setting.names.element(name)))
            if math.isfinite(value):
                found[name] = value
    return found


__all__ = ["Sampling", "State", "sampling_of"]
