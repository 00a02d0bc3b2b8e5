"""How much of the scatter of a result is due to which name: Sobol' indices, beside the gradient at the model's numbers.

S_i = V(E(y | x_i))/V(y) is the share of the variance that x_i has by itself, T_i = E(V(y | x_~i))/V(y) that with all
its interactions; both are estimated with their errors (SALib).
Sources: Sobol', Math. Comput. Simul. 55, 2001, 271-280; Saltelli et al., Comput. Phys. Commun. 181, 2010, 259-270.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from importlib import import_module
from typing import Any

import numpy as np

from freebody.errors import CannotAnswer, InputError
from freebody.language.sentences import Message
from freebody.present.lines import number_text
from freebody.present.report.blocks import Block, Report, Section
from freebody.present.report.result import Result
from freebody.present.report.results import entries, entry, summary, table
from freebody.study.sensitivity.local import Gradient, gradient
from freebody.study.sweeps.plan import Given
from freebody.study.sweeps.result import Sweep
from freebody.study.sweeps.samplings import saltelli
from freebody.study.sweeps.sweep import sweep
from freebody.study.worded import in_words
from freebody.system.system import System

SAMPLE = "saltelli:1024"
_CONFIDENCE = 0.95


@dataclass(frozen=True)
class Index:
    """The shares of one name in the variance of one result; errors: half of the interval of 95 %."""

    name: str
    first: float
    first_error: float
    total: float
    total_error: float


@dataclass(frozen=True)
class Sensitivity(Result):
    """gradient: at the model's numbers, of answers; indices: by result, where something was varied."""

    system: System
    gradient: Gradient
    indices: Mapping[str, tuple[Index, ...]]
    cases: Sweep | None = None

    @property
    def is_complete(self) -> bool:
        return self.cases is not None or self.gradient.is_complete

    def to_plain(self) -> dict[str, Any]:
        """Plain data: the gradient, and the indices by result and name."""
        shares = {
            of: {
                i.name: {
                    "first": i.first,
                    "first_error": i.first_error,
                    "total": i.total,
                    "total_error": i.total_error,
                }
                for i in found
            }
            for of, found in self.indices.items()
        }
        return {**self.gradient.to_plain(), "indices": shares}

    @property
    def report(self) -> Report:
        return summary(self.system.title, self._blocks())

    def _blocks(self) -> Iterator[Block]:
        if self.cases is not None:
            yield from entries(entry(Message("cases"), f"{self.cases.n:,}"))
        for of, found in self.indices.items():
            rows = [
                [i.name, number_text(i.first), f"± {i.first_error:.2g}", number_text(i.total), f"± {i.total_error:.2g}"]
                for i in sorted(found, key=lambda i: -i.total)
            ]
            head = ["", Message("by itself"), "", Message("with interactions"), ""]
            yield Section((Message("Shares in the variance of {name}", name=of),), tuple(table(rows, head)))
        yield from self.gradient.blocks()


@in_words
def sensitivity(
    system: System,
    vary: Mapping[str, Given] | None = None,
    *,
    sample: str = SAMPLE,
    seed: int = 0,
    find: str | Sequence[str] = (),
    by: str | Sequence[str] = (),
    record: str | Sequence[str] = (),
    until: float | None = None,
    threads: int | None = None,
    **given: Any,
) -> Sensitivity:
    """How much answers, and what is recorded of motions, hang on parameters and start values.

    vary: with which distributions; without any there is the gradient alone. find, record, until, threads, given: as of
    `sweep`; by: names by which answers are differentiated; sample: `saltelli:n`, which takes n times two more cases
    than there are names. Raises InputError for what cannot be read, CannotAnswer where cases without a number leave the
    variance unknown."""
    local = gradient(system, find, by, record=record, until=until, **given)
    if not vary:
        return Sensitivity(system, local, {})
    if not sample.startswith("saltelli:"):
        raise InputError(Message("indices need cases by {form}, not {text}", form=saltelli.FORM, text=sample))
    cases = sweep(
        system, vary, sample=sample, seed=seed, find=find, record=record, until=until, threads=threads, **given
    )
    names = [v.name for v in cases.plan.names]
    return Sensitivity(
        system, local, {c.name: _indices(names, c.name, cases.values(c.name), seed) for c in cases.columns}, cases
    )


def _indices(names: list[str], of: str, values: Any, seed: int) -> tuple[Index, ...]:
    missing = int(np.isnan(values).sum())
    if missing:
        raise CannotAnswer(
            Message(
                "{n} of {all} cases of {name} have no number, so that its variance is unknown: vary less",
                n=missing,
                all=len(values),
                name=of,
            )
        )
    if np.ptp(values) <= 1e-12 * np.abs(values).max(initial=0.0):
        return tuple(Index(name, 0.0, 0.0, 0.0, 0.0) for name in names)  # it hangs on none of them
    analysis: Any = import_module("SALib.analyze.sobol")
    found = analysis.analyze(
        saltelli.problem(names),
        np.asarray(values),
        calc_second_order=False,
        conf_level=_CONFIDENCE,
        seed=seed,
        print_to_console=False,
    )
    columns = [np.asarray(found[key], dtype=np.float64) for key in ("S1", "S1_conf", "ST", "ST_conf")]
    return tuple(Index(name, *map(float, row)) for name, row in zip(names, np.column_stack(columns), strict=True))
