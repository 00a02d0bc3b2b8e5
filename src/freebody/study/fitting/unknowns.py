"""What is looked for: parameters, start values of each run, and offsets of series.

Each unknown has a size, by which it is counted: its value at the beginning, or 1 SI where that is zero. Bounds follow
from the sign that the model gives a parameter.
"""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass

from freebody.errors import InputError
from freebody.language.sentences import Message
from freebody.model.noting import did_you_mean
from freebody.study.fitting.data import Run
from freebody.study.sweeps.varied import varied
from freebody.system.system import System

_OFFSET = re.compile(r"offset\((?P<of>.+)\)")
_LEAST = 1e-9  # of its size: a positive parameter gets no smaller


@dataclass(frozen=True)
class Unknown:
    """name: as it is told; parameter: of the system, empty for an offset; series: that has the offset; run: the only
    one that it belongs to, -1 for all; low, high: bounds."""

    name: str
    unit: str
    start: float
    size: float
    low: float
    high: float
    parameter: str = ""
    series: str = ""
    run: int = -1


def unknowns(
    system: System, free: Sequence[str], runs: Sequence[Run], units: dict[str, str]
) -> tuple[System, list[Unknown]]:
    """The system in which each is a parameter, and these. Raises InputError for names that are not there, and for
    parameters without a value to begin with."""
    if not free:
        raise InputError(Message("nothing is free: say which parameters are looked for, as --free c,k"))
    offsets = [(text, m["of"].strip()) for text in free if (m := _OFFSET.fullmatch(text))]
    measured = {s.name for run in runs for s in run.series}
    for text, of in offsets:
        if of not in measured:
            told = Message(
                "{text}: nothing is measured of {name}.{hint}", text=text, name=of, hint=did_you_mean(of, measured)
            )
            raise InputError(told)
    system, names = varied(system, [text for text in free if not _OFFSET.fullmatch(text)])
    found: list[Unknown] = []
    for v in names:
        p = system.parameters[v.parameter]
        if p.value is None:
            raise InputError(Message("{name} needs a value to begin with, as --set '{name}=1'", name=v.name))
        size = abs(p.value) or 1.0
        low = -math.inf if p.sign == "any" else _LEAST * size if p.sign == "positive" else 0.0
        is_start = v.name != v.parameter
        for k in range(len(runs)) if is_start and len(runs) > 1 else (-1,):
            name = f"{v.name} of run {k + 1}" if k >= 0 else v.name
            found.append(Unknown(name, v.unit, p.value, size, low, math.inf, v.parameter, run=k))
    for text, of in offsets:
        size = max(float(abs(s.values).max()) for run in runs for s in run.series if s.name == of) or 1.0
        found.append(Unknown(text, units[of], 0.0, size, -math.inf, math.inf, series=of))
    return system, found
