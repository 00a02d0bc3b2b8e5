"""Measured series: a table for each run, `t [s]` and a column for each series, whose name and unit stand in its head.

    t [s], x [mm], theta [deg], sigma(x) [mm]
    0.00,  12.1,   30.2,        0.1
    0.05,  11.7,   ,            0.1

An empty cell is a value that is missing; `sigma(x)` is the standard deviation of x, a value as good as another where
there is none. Times are those since the start of the motion, in any order.
"""

from __future__ import annotations

import csv
import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from freebody.errors import InputError
from freebody.language.sentences import Message
from freebody.language.units import TIME, parse_quantity, parse_unit
from freebody.model.noting import did_you_mean
from freebody.numeric.jets import Array

_TIMES = ("t", "time")
_HEAD = re.compile(r"(?P<name>[^\[]*?)\s*(?:\[(?P<unit>[^\]]*)\])?\s*")
_SPREAD = re.compile(r"sigma\((?P<of>.+)\)")


@dataclass(frozen=True)
class Series:
    """What was measured of one quantity: times [s], values and their standard deviations in SI, all (n,)."""

    name: str
    times: Array
    values: Array
    spreads: Array


@dataclass(frozen=True)
class Run:
    """One motion that was measured."""

    file: str
    series: tuple[Series, ...]

    @property
    def end(self) -> float:
        return max(float(s.times.max()) for s in self.series)

    @property
    def times(self) -> tuple[float, ...]:
        """All times at which something was measured."""
        return tuple(sorted({float(t) for s in self.series for t in s.times}))


def read_run(path: Path, units: Mapping[str, str]) -> Run:
    """A table of measurements. units: of what a motion of the model has, by name. Raises InputError for what cannot be
    read, and for columns that the model does not have or that have other units."""
    head, body = _table(path)
    columns = {name: _column(path, name, unit, [row[k] for row in body]) for k, (name, unit) in enumerate(head)}
    time = next((name for name in _TIMES if name in columns), None)
    if time is None:
        raise InputError(Message("{file} has no column t [s] with the times", file=path))
    _check_unit(path, time, dict(head)[time], "s")
    times = columns.pop(time)
    if not np.isfinite(times).all() or (times < 0.0).any():
        raise InputError(Message("{file}: each row needs a time, from the start of the motion on", file=path))
    spreads = {m["of"].strip(): x for name, x in columns.items() if (m := _SPREAD.fullmatch(name))}
    found: list[Series] = []
    for name, values in columns.items():
        if of := _SPREAD.fullmatch(name):
            name = of["of"].strip()
        if name not in units:
            told = Message(
                "{file}: the motion has no {name}.{hint}", file=path, name=name, hint=did_you_mean(name, units)
            )
            raise InputError(told)
        _check_unit(path, name, next(unit for other, unit in head if name in (other, _inner(other))), units[name])
        if of:
            continue
        known = np.isfinite(values)
        spread = spreads.get(name, np.ones(len(values)))
        if not (spread[known] > 0.0).all():
            raise InputError(Message("{file}: sigma({name}) must be positive at each value", file=path, name=name))
        if known.any():
            found.append(Series(name, times[known], values[known], spread[known]))
    if not found:
        raise InputError(Message("{file} has no measured values", file=path))
    return Run(str(path), tuple(found))


def _inner(name: str) -> str:
    found = _SPREAD.fullmatch(name)
    return found["of"].strip() if found else name


def _table(path: Path) -> tuple[list[tuple[str, str]], list[list[str]]]:
    """Names and units of the head, and the cells below."""
    try:
        with path.open(encoding="utf-8-sig", newline="") as file:
            rows = [[cell.strip() for cell in row] for row in csv.reader(file) if any(cell.strip() for cell in row)]
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise InputError(Message("the table {file} cannot be read: {why}", file=path, why=error)) from error
    if len(rows) < 2:
        raise InputError(Message("{file} has no measured values", file=path))
    head = [(m["name"].strip(), (m["unit"] or "").strip()) for cell in rows[0] if (m := _HEAD.fullmatch(cell))]
    for k, row in enumerate(rows[1:], 2):
        if len(row) != len(rows[0]) or len(head) != len(rows[0]):
            raise InputError(
                Message("{file}, row {k}: {n} values for {m} names", file=path, k=k, n=len(row), m=len(rows[0]))
            )
    if len(dict(head)) < len(head):
        raise InputError(Message("the table {file} has a name twice", file=path))
    return head, rows[1:]


def _column(path: Path, name: str, unit: str, cells: list[str]) -> Array:
    """The values in SI, NaN where a cell is empty."""
    factor = parse_quantity(f"1 {unit}").value if unit else 1.0
    found: list[float] = []
    for k, cell in enumerate(cells, 2):
        try:
            found.append(float(cell) * factor if cell else math.nan)
        except ValueError:
            told = Message("{file}, row {k}: '{cell}' is no number of {name}", file=path, k=k, cell=cell, name=name)
            raise InputError(told) from None
    return np.array(found)


def _check_unit(path: Path, name: str, unit: str, wanted: str) -> None:
    """Raises InputError for a unit of another dimension; without one, values are in SI."""
    if not unit:
        return
    expected = TIME if wanted == "s" else parse_unit("" if wanted == "1" else wanted).dimension
    if parse_unit(unit).dimension != expected:
        raise InputError(
            Message("{file}: {name} is in {wanted}, not in {unit}", file=path, name=name, wanted=wanted, unit=unit)
        )
