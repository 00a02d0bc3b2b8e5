"""What a fit has found: values with their errors, how they hang together, what is left over."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from freebody.errors import InputError
from freebody.language.sentences import Message
from freebody.numeric.jets import Array
from freebody.present.charts.lines import line_chart
from freebody.present.lines import number_text
from freebody.present.picture.picture import Picture
from freebody.present.report.blocks import Block, Figure, Report, Section
from freebody.present.report.result import Result
from freebody.present.report.results import entries, entry, notes, summary, table
from freebody.study.fitting.estimate import Estimate
from freebody.study.fitting.unknowns import Unknown
from freebody.system.system import System


@dataclass(frozen=True)
class Residuals:
    """One measured series beside the model: all (n,) in SI."""

    file: str
    series: str
    unit: str
    times: Array
    measured: Array
    modelled: Array

    @property
    def rms(self) -> float:
        return float(np.sqrt(np.mean((self.measured - self.modelled) ** 2)))


@dataclass(frozen=True)
class Fit(Result):
    """system: as it was given; unknowns with their values [SI] and what the data say of them."""

    system: System
    unknowns: tuple[Unknown, ...]
    found: Array
    estimate: Estimate
    residuals: tuple[Residuals, ...]
    has_converged: bool
    at_bound: tuple[str, ...]
    n_data: int
    n_motions: int
    n_tangents: int = 0  # motions that were followed with their derivatives
    why_differences: str = ""  # why derivatives are those of differences, where they are not exact

    @property
    def values(self) -> dict[str, float]:
        """By name, in SI."""
        return {u.name: float(x) for u, x in zip(self.unknowns, self.found, strict=True)}

    @property
    def errors(self) -> dict[str, float]:
        """Half of the intervals of 95 %, in SI; infinite where the data tell nothing."""
        return {u.name: float(x) for u, x in zip(self.unknowns, self.estimate.errors, strict=True)}

    @property
    def is_complete(self) -> bool:
        return self.has_converged and not self.estimate.combinations

    @property
    def fitted(self) -> System:
        """The system with the parameters that were found; start values and offsets are those of runs."""
        own = {
            u.parameter: x for u, x in zip(self.unknowns, self.found, strict=True) if u.name in self.system.parameters
        }
        return self.system.with_parameters(**{name: float(x) for name, x in own.items()})

    def chart(self, series: str = "", *, of_residuals: bool = True) -> Picture:
        """What is left over of a series (the first one without a name) over the time, run by run; else what was
        measured and modelled. Raises InputError for a series that was not measured."""
        names = [r.series for r in self.residuals]
        series = series or names[0]
        own = [r for r in self.residuals if r.series == series]
        if not own:
            raise InputError(
                Message("nothing is measured of {name}; there is {names}", name=series, names=", ".join(names))
            )
        times = np.concatenate([r.times for r in own])
        curves: list[tuple[str, Array]] = []
        for k, r in enumerate(own):
            shown = [(r.file, r.measured - r.modelled)]
            if not of_residuals:
                measured, model = Message("{file}: measured", file=r.file), Message("{file}: model", file=r.file)
                shown = [(self.in_language(measured), r.measured), (self.in_language(model), r.modelled)]
            before = sum(len(other.times) for other in own[:k])
            for name, y in shown:
                full = np.full(len(times), np.nan)
                full[before : before + len(y)] = y
                curves.append((name, full))
        residuals = Message("residuals of {series}", series=series)
        both = Message("{series}, measured and modelled", series=series)
        title = self.in_language(residuals if of_residuals else both)
        return line_chart(title, "t [s]", times, f"{title} [{own[0].unit}]", curves, is_joined=False)

    def to_plain(self) -> dict[str, Any]:
        """Plain data: values with errors, correlation, what the data cannot tell, residuals by series."""
        return {
            "title": self.system.title,
            "unknowns": {
                u.name: {"value": float(x), "error": _finite(e), "unit": u.unit, "at_bound": u.name in self.at_bound}
                for u, x, e in zip(self.unknowns, self.found, self.estimate.errors, strict=True)
            },
            "correlation": [[_finite(x) for x in row] for row in self.estimate.correlation],
            "not_identifiable": list(self.estimate.combinations),
            "noise": _finite(self.estimate.noise),
            "converged": self.has_converged,
            "data": self.n_data,
            "motions": self.n_motions,
            "motions_with_derivatives": self.n_tangents,
            "differences": self.why_differences or None,
            "series": [
                {"file": r.file, "series": r.series, "unit": r.unit, "n": len(r.times), "rms": r.rms}
                for r in self.residuals
            ],
        }

    @property
    def report(self) -> Report:
        return summary(self.system.title, self._blocks())

    def _blocks(self) -> Iterator[Block]:
        rows = [
            [
                u.name,
                number_text(float(x)),
                f"± {e:.2g}" if math.isfinite(e) else Message("not told by the data"),
                u.unit,
            ]
            for u, x, e in zip(self.unknowns, self.found, self.estimate.errors, strict=True)
        ]
        n = len(self.unknowns)
        yield from entries(
            entry(
                Message("data"),
                Message("{k} values, 1 unknown" if n == 1 else "{k} values, {n} unknowns", k=self.n_data, n=n),
            ),
            *(
                []
                if self.has_converged
                else notes([Message("the search ended before it came to rest: the values are the best so far")])
            ),
            *([entry(Message("differences"), self.why_differences)] if self.why_differences else []),
            *([entry(Message("at a bound"), ", ".join(self.at_bound))] if self.at_bound else []),
            *notes(self.estimate.combinations, Message("not identifiable")),
        )
        value, unit = Message("value"), Message("unit")
        yield Section((Message("Found, with intervals of 95 %"),), tuple(table(rows, ["", value, "", unit])))
        yield from self._correlation()
        left = [[r.file, r.series, str(len(r.times)), number_text(r.rms), r.unit] for r in self.residuals]
        head = [Message("file"), Message("series"), Message("values"), Message("root mean square"), unit]
        yield Section((Message("Left over"),), tuple(table(left, head)))
        for k, name in enumerate(dict.fromkeys(r.series for r in self.residuals), 1):
            picture = self.chart(name)
            yield Figure(picture, (picture.title,), k)

    def _correlation(self) -> Iterator[Block]:
        names = [u.name for u in self.unknowns]
        if len(names) > 1:
            cells = [
                [name, *(f"{x:.2f}" if math.isfinite(x) else "" for x in row)]
                for name, row in zip(names, self.estimate.correlation, strict=True)
            ]
            yield Section((Message("Correlation"),), tuple(table(cells, ["", *names])))


def _finite(x: float) -> float | None:
    return float(x) if math.isfinite(x) else None
