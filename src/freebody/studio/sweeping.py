"""One name in many cases, for the page: what a question or a motion comes to in each, and why some have no number."""

from __future__ import annotations

import re
from collections.abc import Iterator

import numpy as np

from freebody.language.units import parse_quantity
from freebody.messages import Message
from freebody.numeric.jets import Array
from freebody.progress import busy_with
from freebody.studio.moving import rounded
from freebody.studio.reading import checked_system
from freebody.studio.telling import told
from freebody.studio.wire.motions import Line, Missing, SweepAnswer, SweepRequest
from freebody.study.sweeps.result import Sweep
from freebody.study.sweeps.statuses import GOOD, NO_VALUE
from freebody.study.sweeps.sweep import sweep

_NUMBER = re.compile(r"\s*[-+−]?[\d.]+(?:[eE][-+]?\d+)?")


def swept(request: SweepRequest) -> SweepAnswer:
    """Raises ModelError where the text is no model, InputError for a range, a question or a record that cannot be
    read. A case that fails is a gap with its reason."""
    found = sweep(
        checked_system(request.text),
        {request.name: f"{request.low}..{request.high}:{request.n}"},
        find=request.find or (),
        record=request.record or (),
        until=request.until if request.record else None,
        progress=lambda done, n: busy_with(f"{done} / {n}"),
    )
    [evaluator], [varied] = found.evaluators, found.plan.names
    unit = _unit(request, varied.unit)
    at = found.values(request.name) / (1.0 if unit == "1" else parse_quantity(f"1 {unit}").value)
    columns = {column.name: found.values(column.name) for column in found.columns}
    words = found.status(evaluator.name).tolist()
    return SweepAnswer(
        name=request.name,
        unit=unit,
        values=rounded(at),
        about=evaluator.columns[0].long_name if request.find else request.record,
        lines=[
            Line(name=c.name, label=c.long_name, unit=c.unit, values=rounded(columns[c.name])) for c in found.columns
        ],
        statuses=[_told(word, request) for word in words],
        missing=list(_missing(found, at, np.column_stack(list(columns.values())), request)),
    )


def _unit(request: SweepRequest, own: str) -> str:
    """In which the ends are written, or in which it is calculated."""
    written = (_NUMBER.sub("", end, count=1).strip() for end in (request.high, request.low))
    return next((unit for unit in written if unit), own)


def _missing(found: Sweep, at: Array, numbers: Array, request: SweepRequest) -> Iterator[Missing]:
    """What has no number, by its reason; the first of them says it."""
    for each in found.failures:
        yield Missing(
            status=_told(each.status, request),
            count=each.count,
            first=rounded(at[each.case : each.case + 1])[0],
            why=told(each.why, request.language),
        )
    is_good = np.isin(found.status(found.evaluators[0].name), sorted(GOOD))
    open_ = np.flatnonzero(is_good & ~np.isfinite(numbers).any(axis=1))
    if len(open_):
        why = Message("the motion is followed, but {what} has no value in it", what=request.record or request.find)
        yield Missing(
            status=_told(NO_VALUE, request),
            count=len(open_),
            first=rounded(at[open_[:1]])[0],
            why=told(why, request.language),
        )


def _told(status: str, request: SweepRequest) -> str:
    return told(Message("{status}", status=status), request.language)
