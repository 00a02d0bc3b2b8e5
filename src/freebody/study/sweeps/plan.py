"""Which cases there are: what is chosen by a sampling, each with all values of what is gone over.

Case k is the sampled one k // n_over at the place k % n_over; both are computed from k alone, so that nothing hangs on
how the cases are divided.
"""

from __future__ import annotations

import csv
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from freebody.errors import InputError
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, parse_quantity
from freebody.numeric.jets import Array
from freebody.study.sweeps.ranges import read_range
from freebody.study.sweeps.ranges.base import Range, Read
from freebody.study.sweeps.ranges.span import Span
from freebody.study.sweeps.ranges.values import Values
from freebody.study.sweeps.samplings import sampling
from freebody.study.sweeps.samplings.base import MOST, Sampling
from freebody.study.sweeps.samplings.grid import Grid
from freebody.study.sweeps.varied import Varied, varied, wide
from freebody.system.system import System

N_OVER = 73  # places of what is gone over, where nothing else is said: every five degrees of a turn
Given = str | float | Sequence[float | str] | Array


@dataclass(frozen=True)
class Plan:
    """The cases of a sweep. system: in which every name is a parameter; names: in the order of the columns, those
    sampled first."""

    system: System
    names: tuple[Varied, ...]
    sampled: Sampling
    over: Grid

    @property
    def extents(self) -> dict[str, tuple[float, float]]:
        """The least and the greatest value of each name."""
        return {name: of.extent for name, of in {**self.sampled.ranges, **self.over.ranges}.items()}

    @property
    def n(self) -> int:
        return self.sampled.n * self.over.n

    @property
    def dimensions(self) -> Mapping[str, int]:
        """The axes of what is found, the last one running fastest."""
        return {**self.sampled.dimensions, **self.over.dimensions}

    @cached_property
    def axes(self) -> Mapping[str, Array]:
        """The values of names that are axes themselves, by name."""
        return {**(self.sampled.axes if isinstance(self.sampled, Grid) else {}), **self.over.axes}

    def cases(self, start: int, stop: int) -> Array:
        """(stop - start, n_names) values in SI."""
        n = self.over.n
        chosen = np.arange(start, stop)
        first = start // n
        sampled = self.sampled.cases(first, -(-stop // n))[chosen // n - first]
        here = chosen % n
        low, high = (int(here.min()), int(here.max()) + 1) if len(here) else (0, 0)
        return np.hstack((sampled, self.over.cases(low, high)[here - low]))


def plan(system: System, vary: Mapping[str, Given], over: Mapping[str, Given], sample: str | None, seed: int) -> Plan:
    """The cases that are asked for. Raises InputError for unknown names, other units, and where there are no cases."""
    word, _, rest = (sample or "").strip().partition(":")
    if word.endswith(".csv"):  # a table may be given by its name alone
        word, rest = "table", (sample or "").strip()
    if word == "table":
        if vary:
            raise InputError(Message("{text}: a table is given alone, without other names that vary", text=sample))
        vary = _columns(Path(rest))
    if not vary and not over:
        raise InputError(Message("nothing varies: give a range, as m1=1..3 kg:50, or a table of cases"))
    for name in vary.keys() & over.keys():
        raise InputError(Message("{name} is varied twice", name=name))
    system, names = varied(system, [*vary, *over])
    ranges = {v.name: _range(v, {**vary, **over}[v.name]) for v in names}
    going_over = {name: _counted(ranges[name]) for name in over}
    sampled = {name: ranges[name] for name in vary}
    text = f"table:{rest}" if word == "table" else sample or "grid"
    found = Plan(
        wide(system, [(v.parameter, *ranges[v.name].extent) for v in names]),
        tuple(names),
        sampling(text if sampled else "grid", sampled, seed),
        Grid(
            going_over,
            int(np.prod([len(x) for of in going_over.values() if (x := of.grid) is not None], dtype=np.int64)),
        ),
    )
    if found.n == 0:
        raise InputError(Message("there are no cases: a range is empty"))
    if found.n > MOST:
        raise InputError(Message("there are {n:,} cases; at most {most:,} are taken", n=found.n, most=MOST))
    return found


def _counted(of: Range) -> Range:
    return Span(of.low, of.high, N_OVER) if isinstance(of, Span) and of.n is None else of


def _range(of: Varied, given: Given) -> Range:
    """How a name varies, of a text or of numbers in SI. Raises InputError."""
    if isinstance(given, str):
        if not given.strip():
            raise InputError(Message("{name}: there are no values", name=of.name))
        return read_range(of.name, given, _reader(of))
    parts: list[Any] = list(given) if isinstance(given, Sequence | np.ndarray) else [given]
    if not parts:
        raise InputError(Message("{name}: there are no values", name=of.name))
    read = _reader(of)
    return Values(tuple(read(part) if isinstance(part, str) else float(part) for part in parts))


def _reader(of: Varied) -> Read:
    def read(text: str) -> float:
        quantity = parse_quantity(text)
        is_other_angle = quantity.is_angle and not of.is_angle and of.dimension != DIMENSIONLESS
        if quantity.dimension != of.dimension or is_other_angle:
            told = Message("{name} is in {unit}; {text} is not", name=of.name, unit=of.unit, text=text)
            raise InputError(told)
        if of.is_angle and not quantity.is_angle and abs(quantity.value) > math.tau:
            told = Message("the angle {value} has no unit: write {value} deg, or {value} rad", value=text)
            raise InputError(told)
        return quantity.value

    return read


def _columns(path: Path) -> dict[str, Given]:
    """The columns of a table as texts with units. Raises InputError for a file that cannot be read."""
    try:
        with path.open(encoding="utf-8-sig", newline="") as file:
            rows = [row for row in csv.reader(file) if any(cell.strip() for cell in row)]
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise InputError(Message("the table {file} cannot be read: {why}", file=path, why=error)) from error
    if len(rows) < 2:
        raise InputError(Message("the table {file} has no cases: a line of names, then a line for each", file=path))
    head, *body = rows
    for k, row in enumerate(body, 2):
        if len(row) != len(head):
            raise InputError(
                Message("{file}, row {k}: {n} values for {m} names", file=path, k=k, n=len(row), m=len(head))
            )
    columns: dict[str, Given] = {}
    for k, title in enumerate(head):
        name, _, unit = title.strip().partition("[")
        cells = [f"{row[k].strip()} {unit.rstrip(' ]')}".strip() for row in body]
        columns[name.strip()] = cells if unit else [_in_si(cell) for cell in cells]
    if len(columns) < len(head):
        raise InputError(Message("the table {file} has a name twice", file=path))
    return columns


def _in_si(cell: str) -> float | str:
    """A bare number is in SI; else it has a unit of its own."""
    try:
        return float(cell)
    except ValueError:
        return cell
