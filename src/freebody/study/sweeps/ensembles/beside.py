"""An ensemble beside the engine: some cases are followed on both ways, whose numbers have to agree.

Both run twice, once at the tolerance asked for and once a hundred times as exact; by how much their own numbers change
tells how exact they are, and they may differ by some times that. The state is looked at early in the motion as well:
late in a chaotic one nothing is left to compare, and where that is so, nothing is compared.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from freebody.errors import CannotAnswer, RoutesDisagree
from freebody.language.sentences import Message
from freebody.numeric.engine.course import Status
from freebody.numeric.jets import Array
from freebody.numeric.options import FINEST, SimulationOptions
from freebody.numeric.reference import Reference
from freebody.study.answering.spread import disagreement
from freebody.study.sweeps.ensembles.evaluator import EnsembleEvaluator
from freebody.study.sweeps.ensembles.refusals import refused
from freebody.study.sweeps.evaluators import Values
from freebody.study.sweeps.motions import MotionEvaluator
from freebody.study.sweeps.plan import Plan
from freebody.study.sweeps.records.at_time import AtTime
from freebody.study.sweeps.records.base import Record

EARLY = (1 / 4096, 1 / 64, 1 / 8)  # parts of the time at which the state is compared as well
N_CASES = 4
_TIMES = 10.0  # the estimated errors by which numbers may differ
_LEAST = 1e-11  # of the size of a number: less is round-off
_STILL = 1e-4  # of the size of the system: what moves less is compared as if it moved so far
_LOST = 1e-3  # of the size of a number: with larger errors an instant tells nothing


def check_beside(evaluator: EnsembleEvaluator, plan: Plan) -> None:
    """Raises RoutesDisagree where an ensemble and the engine tell different numbers of the same case, CannotAnswer
    where the engine has none."""
    chosen = sorted({round(k * (plan.n - 1) / (N_CASES - 1)) for k in range(N_CASES)})
    names = [v.parameter for v in plan.names]
    rows = [row for k in chosen for row in plan.cases(k, k + 1) if not evaluator.refused(_by_name(names, row))]
    if not rows:
        return
    given, has_start = evaluator.ensemble.begun(_by_name(names, np.array(rows).T), len(rows))
    cases = [_by_name(names, row) for row, is_good in zip(rows, has_start, strict=True) if is_good]
    records = [*_early(evaluator), *evaluator.records]
    seen = [record.seen for record in records if record.seen is not None]
    finer = replace(evaluator.options, tolerance=max(evaluator.options.tolerance / 100.0, FINEST))
    copies, is_done = evaluator.ensemble.follow(given[has_start], seen, evaluator.options.tolerance)
    exact, is_exact = evaluator.ensemble.follow(given[has_start], seen, finer.tolerance)
    coarse, engine = (_by_engine(evaluator, records, cases, options) for options in (evaluator.options, finer))

    own = np.abs(copies - exact) + np.abs(coarse - engine)
    sizes = np.fmax(np.abs(exact), np.abs(engine)).max(axis=0, initial=0.0, where=np.isfinite(own))
    sizes = np.array([max(sizes[[o.series == s.series for o in seen]]) for s in seen])  # a series has one all along
    sizes = np.maximum(sizes, [_STILL * evaluator.ensemble.size_of(s.series) for s in seen])
    allowed = _TIMES * own + max(100.0 * evaluator.options.tolerance, _LEAST) * sizes
    allowed[_lost(own > _LOST * sizes, len(evaluator.records))] = np.inf
    is_same = (np.abs(exact - engine) <= allowed) | (np.isnan(exact) & np.isnan(engine))
    for i, values in enumerate(cases):
        for k, record in enumerate(records):
            if is_done[i] and is_exact[i] and np.isnan(engine[i, k]) > np.isnan(exact[i, k]):
                raise CannotAnswer(refused([_no_value(record, values)]))
            if is_done[i] and is_exact[i] and not is_same[i, k]:
                raise _different(evaluator, record, (float(exact[i, k]), float(engine[i, k])), values)


def _lost(is_lost: NDArray[np.bool_], n_late: int) -> NDArray[np.bool_]:
    """(n_cases, n_records) what says nothing: all of an instant at which something does; of the records of the sweep,
    the last ones, all."""
    found, n_early = np.zeros_like(is_lost), is_lost.shape[1] - n_late
    for group in (*(slice(k, n_early, len(EARLY)) for k in range(len(EARLY))), slice(n_early, None)):
        found[:, group] = is_lost[:, group].any(axis=1, keepdims=True)
    return found


def _by_name(names: Sequence[str], rows: Array) -> dict[str, Any]:
    """What belongs to each name: a number of one case, or those of several."""
    return {name: np.ascontiguousarray(x) if x.ndim else float(x) for name, x in zip(names, rows, strict=True)}


def _early(evaluator: EnsembleEvaluator) -> list[Record]:
    """Everything that is recorded, early."""
    return [
        AtTime(f"{series} at {part * evaluator.until!r} s", "", series, part * evaluator.until)
        for series in evaluator.ensemble.watched
        for part in EARLY
    ]


def _by_engine(
    evaluator: EnsembleEvaluator, records: Sequence[Record], cases: Sequence[Values], options: SimulationOptions
) -> Array:
    """(n_cases, n_records) numbers; none of a case that the engine does not bring to its end."""
    texts = [record.text for record in records]
    engine = MotionEvaluator(evaluator.system, texts, evaluator.until, options, (), evaluator.read)
    found = [engine.alone(values) for values in cases]
    numbers = [f.numbers if f.status == str(Status.FINISHED) else [np.nan] * len(texts) for f in found]
    return np.array(numbers, dtype=np.float64).reshape(len(cases), len(texts))


def _no_value(record: Record, values: Values) -> str:
    return Message("'{record}' has no value by the engine at {values}", record=record.text, values=_told(values))


def _told(values: Values) -> str:
    return ", ".join(f"{name} = {x:.9g}" for name, x in values.items())


def _different(evaluator: EnsembleEvaluator, record: Record, found: tuple[float, float], at: Values) -> RoutesDisagree:
    told = Message(
        "'{record}' is {a:.9g} by the compiled equations and {b:.9g} by the engine at {values}",
        record=record.text,
        a=found[0],
        b=found[1],
        values=_told(at),
    )
    return disagreement(told, Reference(evaluator.system, at), Message("The sweep was not run"))
