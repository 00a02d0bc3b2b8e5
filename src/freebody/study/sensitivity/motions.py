"""How what is recorded of a motion changes with parameters and start values, exactly where that is known."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from freebody.errors import FreebodyError
from freebody.numeric.options import SimulationOptions
from freebody.study.sensitivity.derivatives import AnswerGradient, Derivative
from freebody.study.simulation.simulate import with_steps
from freebody.study.simulation.tangents import MotionTangents
from freebody.study.sweeps.records import read_record
from freebody.study.sweeps.records.base import Followed, Record
from freebody.study.sweeps.varied import Varied, varied
from freebody.study.worded import FAILED
from freebody.system.system import System


def of_motion(
    system: System, record: Sequence[str], by: Sequence[str], until: float, options: SimulationOptions
) -> Iterator[AnswerGradient]:
    """The derivatives of what is recorded. by: parameters and named measures whose start is meant; all parameters with
    a value if there are none. Raises InputError for what cannot be read, CannotAnswer where there is no motion."""
    names = list(by) or [p.name for p in system.parameters.values() if p.form is None and p.value is not None]
    seen, wanted = varied(system, names)
    records = [read_record(seen, text) for text in record]
    events = tuple(dict.fromkeys(e for r in records for e in r.events))
    at = sorted({t for r in records for t in r.times if t <= until})
    motion = Followed(with_steps(seen, until, options, events=events, at=at))
    try:
        times = [t for r in records for t in r.instants(motion) if np.isfinite(t)]
        tangents = MotionTangents(motion.result, [v.parameter for v in wanted], until, options, times)
    except (FreebodyError, *FAILED) as error:
        yield from (_none(r, wanted, _value(r, motion), str(error)) for r in records)
        return
    for r in records:
        yield _of_record(r, motion, tangents, wanted, seen)


def _of_record(
    record: Record, motion: Followed, tangents: MotionTangents, names: Sequence[Varied], system: System
) -> AnswerGradient:
    value = _value(record, motion)
    if value is None:
        return AnswerGradient(record.text, _title(record), None, (), None, (), _missing(motion))
    try:
        slopes = record.change(motion, tangents)
    except (FreebodyError, *FAILED) as error:
        return _none(record, names, value, str(error))
    found = tuple(_derivative(record, v, float(x), value, system) for v, x in zip(names, slopes, strict=True))
    return AnswerGradient(record.text, _title(record), None, (), value, found, unit=record.unit)


def _derivative(record: Record, of: Varied, slope: float, value: float, system: System) -> Derivative:
    size = system.parameters[of.parameter].value
    relative = slope * size / value if size is not None and value else None
    return Derivative(of.name, None, slope, relative, _unit(record.unit, of.unit))


def _unit(of: str, by: str) -> str:
    """The unit of a derivative."""
    if by in ("1", "rad"):
        return of
    if of == by:
        return "1"
    return f"{of}/({by})" if {"/", " "} & set(by) else f"{of}/{by}"


def _none(record: Record, names: Sequence[Varied], value: float | None, why: str) -> AnswerGradient:
    return AnswerGradient(record.text, _title(record), None, (), value, (), why)


def _title(record: Record) -> str:
    return f"{record.text} of the motion"


def _missing(motion: Followed) -> str:
    return motion.result.message or "it has no number in this motion"


def _value(record: Record, motion: Followed) -> float | None:
    try:
        x = record.value(motion)
    except (FreebodyError, ValueError, *FAILED):
        return None
    return x if np.isfinite(x) else None
