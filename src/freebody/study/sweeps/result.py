"""What a sweep comes to: every case with its numbers and statuses, as a dataset, as files and in short."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from freebody.errors import InputError
from freebody.language.sentences import Message, in_turn
from freebody.numeric.jets import Array
from freebody.present.lines import number_text
from freebody.present.report.blocks import Block, Figure, Report, Section
from freebody.present.report.result import Result
from freebody.present.report.results import entries, entry, summary, table
from freebody.study.sweeps.evaluators import Column, Evaluator
from freebody.study.sweeps.plan import Plan
from freebody.study.sweeps.statistics import Statistics, statistics
from freebody.study.sweeps.statuses import CODES, GOOD, NOT_DONE, STATUSES
from freebody.study.sweeps.store import Store
from freebody.study.sweeps.swept import Variable

if TYPE_CHECKING:
    import xarray

    from freebody.present.picture.picture import Picture
    from freebody.system.system import System

MOST_SHOWN = 1_000_000  # cases of which a report has charts


def _slice(x: Array, start: int, stop: int) -> Array:
    return x[start:stop]


@dataclass(frozen=True)
class Failure:
    """Cases of one kind without a number: the first of them, with its values, says why."""

    of: str
    status: str
    count: int
    case: int
    values: Mapping[str, float]
    why: str


@dataclass(frozen=True, repr=False)
class Sweep(Result):
    """Many cases. system: as it was given; plan: which cases; evaluators: what of each; seconds: how long it took;
    threads: on how many, of this process or of a cluster; device: by what motions were followed."""

    system: System
    plan: Plan
    evaluators: tuple[Evaluator, ...]
    store: Store
    seconds: float
    threads: int
    cluster: str | None = None
    device: str = "engine"
    files: tuple[Path, ...] = ()

    @property
    def n(self) -> int:
        return self.plan.n

    @cached_property
    def n_done(self) -> int:
        return self.store.n_done

    @property
    def is_complete(self) -> bool:
        """Whether every case was looked at, whatever came of it."""
        return self.n_done == self.n

    @property
    def columns(self) -> tuple[Column, ...]:
        return tuple(column for evaluator in self.evaluators for column in evaluator.columns)

    @cached_property
    def digest(self) -> str:
        """64 hexadecimal digits of all results, the same wherever and however they were computed."""
        return self.store.digest()

    # -- numbers ------------------------------------------------------------------------------
    def values(self, name: str) -> Array:
        """The values of a column, or of a name that varies, in the shape of the sweep; NaN where there is none."""
        shape = tuple(self.plan.dimensions.values())
        return self._flat(name, 0, self.n).reshape(shape)

    def status(self, of: str) -> Any:
        """The statuses in words, in the shape of the sweep, of an answer or of the motion."""
        k = [e.name for e in self.evaluators].index(of)
        return np.array(STATUSES)[self._codes(k, 0, self.n)].reshape(tuple(self.plan.dimensions.values()))

    def _flat(self, name: str, start: int, stop: int) -> Array:
        names = [v.name for v in self.plan.names]
        if name in names:
            return self.plan.cases(start, stop)[:, names.index(name)]
        columns = [c.name for c in self.columns]
        if name not in columns:
            raise InputError(
                Message("the sweep has no {name}; it has {names}", name=name, names=", ".join([*names, *columns]))
            )
        found = np.array(self.store.numbers[start:stop, columns.index(name)])
        return np.where(self.store.done[start:stop] > 0, found, np.nan)

    def _codes(self, k: int, start: int, stop: int) -> Any:
        return np.where(self.store.done[start:stop] > 0, self.store.statuses[start:stop, k], CODES[NOT_DONE])

    def parameters(self) -> dict[str, Array]:
        """(n,) values of the parameters that vary."""
        cases = self.plan.cases(0, self.n)
        return {v.parameter: cases[:, k] for k, v in enumerate(self.plan.names)}

    @property
    def counts(self) -> dict[str, dict[str, int]]:
        """How many cases have which status, by answer or motion."""
        return self._counts

    @cached_property
    def _counts(self) -> dict[str, dict[str, int]]:
        found: dict[str, dict[str, int]] = {}
        for k, evaluator in enumerate(self.evaluators):
            sums = sum(np.bincount(self._codes(k, a, b), minlength=len(STATUSES)) for a, b in self.store.chunks())
            found[evaluator.name] = {word: int(x) for word, x in zip(STATUSES, np.atleast_1d(sums), strict=True) if x}
        return found

    @cached_property
    def failures(self) -> tuple[Failure, ...]:
        """Of each kind of case without a number the first one, looked at again for the reason."""
        found: list[Failure] = []
        for k, evaluator in enumerate(self.evaluators):
            for status, count in self.counts[evaluator.name].items():
                if status in GOOD or status == NOT_DONE:
                    continue
                case = next(
                    a + int(np.flatnonzero(here)[0])
                    for a, b in self.store.chunks()
                    if (here := self._codes(k, a, b) == CODES[status]).any()
                )
                values = self.plan.cases(case, case + 1)[0]
                by_parameter = {v.parameter: float(x) for v, x in zip(self.plan.names, values, strict=True)}
                by_name = {v.name: float(x) for v, x in zip(self.plan.names, values, strict=True)}
                why = evaluator.alone(by_parameter).why
                found.append(Failure(evaluator.name, status, count, case, by_name, why))
        return tuple(found)

    @property
    def statistics(self) -> dict[str, Statistics]:
        """Mean, spread and extremes of every column over the cases that have a number."""
        return self._statistics

    @cached_property
    def _statistics(self) -> dict[str, Statistics]:
        chunks = list(self.store.chunks())
        return {c.name: statistics(self._flat(c.name, a, b) for a, b in chunks) for c in self.columns}

    # -- as data ------------------------------------------------------------------------------
    @property
    def attributes(self) -> dict[str, Any]:
        """Of the dataset."""
        return {"title": self.system.title, "digest": self.digest, "convention": "SI units, angles in rad"}

    def variables(self) -> Iterator[Variable]:
        """Everything as arrays over the axes of the sweep."""
        dimensions, shape = tuple(self.plan.dimensions), tuple(self.plan.dimensions.values())
        for v in self.plan.names:
            about = {"units": v.unit, "long_name": v.name}
            axis = self.plan.axes.get(v.name)
            if axis is not None:
                yield Variable(v.name, (v.name,), axis.shape, "f8", about, partial(_slice, axis))
            else:
                yield Variable(v.name, dimensions[:1], shape[:1], "f8", about, partial(self._sampled, v.name))
        for c in self.columns:
            about = {"units": c.unit, "long_name": c.long_name}
            yield Variable(c.name, dimensions, shape, "f8", about, partial(self._flat, c.name))
        flags = {
            "flag_values": np.arange(len(STATUSES), dtype=np.int8),
            "flag_meanings": " ".join(word.replace(" ", "_") for word in STATUSES),
        }
        for k, e in enumerate(self.evaluators):
            about = {"long_name": f"what has come of {e.name}", **flags}
            yield Variable(f"{e.name}.status", dimensions, shape, "i1", about, partial(self._codes, k))

    def _sampled(self, name: str, start: int, stop: int) -> Array:
        """The values of a name that is drawn, of some of the sampled cases."""
        n = self.plan.over.n
        return self._flat(name, start * n, stop * n)[::n]

    @cached_property
    def dataset(self) -> xarray.Dataset:
        """All of it as an xarray dataset in memory (extra `data`)."""
        try:
            import xarray
        except ModuleNotFoundError:
            raise InputError(Message('datasets need xarray; pip install "freebody[data]"')) from None
        names = {v.name for v in self.plan.names}
        data: dict[str, Any] = {}
        for of in self.variables():
            values = np.concatenate([x for _part, x in of.parts()]) if of.shape[0] else np.zeros(of.shape)
            data[of.name] = (of.dimensions, values, of.attributes)
        coords = {name: x for name, x in data.items() if name in names}
        return xarray.Dataset({n: x for n, x in data.items() if n not in names}, coords=coords, attrs=self.attributes)

    def tables(self) -> Iterator[dict[str, Any]]:
        """All of it as parts of one table: what varies, what was found, statuses in words."""
        words = np.array(STATUSES, dtype=object)
        for a, b in self.store.chunks():
            part: dict[str, Any] = {}
            cases = self.plan.cases(a, b)
            for k, v in enumerate(self.plan.names):
                part[f"{v.name} [{v.unit}]"] = cases[:, k]
            for c in self.columns:
                part[f"{c.name} [{c.unit}]"] = self._flat(c.name, a, b)
            for k, e in enumerate(self.evaluators):
                part[f"{e.name}.status"] = words[self._codes(k, a, b)]
            yield part

    def write(self, path: str | Path) -> list[Path]:
        """Writes it as data (.nc, .zarr, .csv, .parquet) or as a report (.html, .md, .tex, .pdf, .ipynb, .txt), by the
        suffix; returns all files written."""
        from freebody.study.sweeps.formats import formats, write_data

        path = Path(path)
        if path.suffix in formats():
            write_data(self, path)
            return [path]
        return super().write(path)

    def chart(self, name: str = "", kind: str = "") -> Picture:
        """A picture of a column, of the first one without a name, that writes itself as .svg, .png, .pdf or .tex. kind:
        line, heat, parallel or regions (which formula or status holds); what fits the axes if nothing is said."""
        from freebody.study.sweeps.charts import chart

        return chart(self, name or self.columns[0].name, kind)

    def to_plain(self) -> dict[str, Any]:
        """Plain data: cases, statuses by answer, digest, seconds, formulas, statistics, failures."""
        return {
            "title": self.system.title,
            "cases": self.n,
            "done": self.n_done,
            "dimensions": dict(self.plan.dimensions),
            "varied": {v.name: v.unit for v in self.plan.names},
            "statuses": self.counts,
            "digest": self.digest,
            "seconds": self.seconds,
            "threads": self.threads,
            "cluster": self.cluster,
            "device": self.device,
            "found": {
                name: {**about, **self.statistics[name].to_plain(is_random=self.plan.sampled.is_random)}
                for e in self.evaluators
                for name, about in e.described().items()
            },
            "failures": [
                {
                    "of": f.of,
                    "status": f.status,
                    "count": f.count,
                    "case": f.case,
                    "values": dict(f.values),
                    "why": f.why,
                }
                for f in self.failures
            ],
            "files": [str(path) for path in self.files],
        }

    # -- in short -----------------------------------------------------------------------------
    @property
    def report(self) -> Report:
        return summary(self.system.title, self._blocks())

    def _blocks(self) -> Iterator[Block]:
        sizes = " x ".join(f"{n} {name}" for name, n in self.plan.dimensions.items() if name != "case")
        shape = f"{self.n:,}" + (f" ({sizes})" if sizes else "")
        done = shape if self.is_complete else Message("{cases}, {n:,} of them done", cases=shape, n=self.n_done)
        yield from entries(
            entry(Message("cases"), done),
            *(
                entry(Message("status"), Message("{name}: {counts}", name=name, counts=self._told(of)))
                for name, of in self.counts.items()
            ),
        )
        head: list[str] = ["", Message("unit"), Message("least"), Message("mean"), Message("greatest")]
        head.append(Message("std. deviation"))
        is_random = self.plan.sampled.is_random
        if is_random:
            head.append(Message("error of mean"))
        rows: list[Sequence[str]] = []
        for c in self.columns:
            s = self.statistics[c.name]
            numbers = [s.least, s.mean, s.greatest, s.deviation, *([s.error] if is_random else [])]
            rows.append([c.name, c.unit, *(number_text(x) if math.isfinite(x) else "" for x in numbers)])
        yield Section((Message("Results"),), tuple(table(rows, head)))
        if self.is_complete and self.n <= MOST_SHOWN:
            from freebody.study.sweeps.charts import charts

            yield from (Figure(picture, (picture.title,), k) for k, picture in enumerate(charts(self), 1))
        if self.failures:
            told = [
                [f.of, Message("{status}", status=f.status), f"{f.count:,}", self._case(f), f.why]
                for f in self.failures
            ]
            head = ["", Message("status"), Message("cases"), Message("first case"), Message("why")]
            yield Section((Message("Cases without a number"),), tuple(table(told, head)))

    @staticmethod
    def _told(of: Mapping[str, int]) -> str:
        return in_turn([Message("{n:,} {status}", n=count, status=word) for word, count in of.items()])

    def _case(self, f: Failure) -> str:
        return ", ".join(
            f"{v.name} = {number_text(f.values[v.name])} {v.unit.removeprefix('1')}".strip() for v in self.plan.names
        )
