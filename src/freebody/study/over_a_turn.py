"""The driving torque over a turn: an angle is turned once round evenly, or slowly, and what drives it is found.

With the angle psi = psi0 + w t prescribed the torque is the multiplier of that constraint (`inverse_dynamics`): what
the motor must supply beside all loads of the model. w = 0 leaves out what inertia needs: the torque at rest in every
pose.
Its mean is the work of a turn over 2 pi, as a flywheel sees it.
Source: Norton, Design of Machinery, 5th ed. 2012, sec. 11.2 to 11.11 (driving torque, flywheel).
"""

from __future__ import annotations

import csv as tables
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from freebody.connections.driver import Driver
from freebody.errors import CannotAnswer, InputError
from freebody.language.expression import Expr, differentiate, number, substitute
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS
from freebody.measures.base import Measure
from freebody.model.elements import NonholonomicForm
from freebody.numeric.jets import Array
from freebody.numeric.reference import Reference
from freebody.present.files import replaced
from freebody.present.lines import number_text
from freebody.present.plots import Curve, figure_over, save
from freebody.present.report.blocks import Block, Report, Section
from freebody.present.report.result import Result
from freebody.present.report.results import entries, entry, summary, table
from freebody.study.given import named_measure
from freebody.study.inverse_dynamics import InverseDynamics, inverse_dynamics
from freebody.study.small_motion.found import unit_of
from freebody.study.worded import in_words
from freebody.system.system import System

N_POSES = 72
_N_SHOWN = 12  # rows of a report
_FEWEST = 8
_ROUND_OFF = 1e-13  # of the largest value of a turn


@dataclass(frozen=True)
class OverTurn(Result):
    """What drives an angle once round. along: the angle; rate: how fast it turns [rad/s], 0: slowly; angles: (n,) [rad]
    from the start on, the last one a turn later; torque: (n,) [N m], positive where it drives the angle on."""

    system: System
    along: str
    rate: float
    angles: Array
    torque: Array
    found: InverseDynamics

    @property
    def mean(self) -> float:
        """The work of a turn over 2 pi: the mean of evenly spaced values is that of a periodic function."""
        mean = float(np.mean(self.torque[:-1]))
        return mean if abs(mean) > _ROUND_OFF * float(np.abs(self.torque).max()) else 0.0

    @property
    def columns(self) -> dict[str, tuple[str, Array]]:
        """Everything that was found, by name: unit and values."""
        measures = self.system.measures
        columns = {self.along: ("rad", self.angles), f"torque of {self.along}": ("N m", self.torque)}
        if self.rate:
            columns[f"power of {self.along}"] = ("W", self.torque * self.rate)
        for name in measures:
            if name != self.along:
                unit = unit_of(measures[name])
                columns[name] = (unit, self.found.values[name])
                if self.rate:
                    columns[f"rate({name})"] = (f"{unit}/s", self.found.rates[name])
                    columns[f"rate(rate({name}))"] = (f"{unit}/s^2", self.found.accelerations[name])
        units = {row.name: "N m" if _is_angle(row.measure) else "N" for row in self.system.constraint_rows}
        for name, values in self.found.reactions.items():
            columns[name] = (units[name], values)
        return {name: (unit, _without_round_off(x)) for name, (unit, x) in columns.items()}

    def write_csv(self, path: str | Path) -> Path:
        """A row for each pose, with units in the head."""
        path, columns = Path(path), self.columns
        with replaced(path) as file, file.open("w", encoding="utf-8", newline="") as out:
            writer = tables.writer(out)
            writer.writerow([f"{name} [{unit}]" for name, (unit, _values) in columns.items()])
            writer.writerows(
                zip(*([repr(float(x)) for x in values] for _unit, values in columns.values()), strict=True)
            )
        return path

    def plot(self, path: str | Path | None = None, *, dark: bool = False) -> Any:
        """The torque over the angle, with its mean; saved if a path is given."""
        degrees = np.degrees(self.angles)
        curves = [
            Curve("torque", self.in_language(Message("torque of {name}", name=self.along)), "N m", self.torque),
            Curve("mean", self.in_language(Message("mean")), "N m", np.full_like(self.torque, self.mean)),
        ]
        figure: Any = figure_over(degrees, {"N m": curves}, f"{self.along} [deg]", dark=dark)
        for axes in figure.axes:
            axes.set_xticks(np.arange(60 * math.ceil(degrees.min() / 60 - 1e-9), degrees.max() + 1e-6, 60))
        if path is not None:
            save(figure, Path(path))
        return figure

    def to_plain(self) -> dict[str, Any]:
        """Plain data: along, rate, columns {name: {unit, values}}, mean, least and greatest torque."""
        return {
            "title": self.system.title,
            "along": self.along,
            "rate": self.rate,
            "mean": self.mean,
            "least": float(self.torque.min()),
            "greatest": float(self.torque.max()),
            "columns": {name: {"unit": unit, "values": _plain(x)} for name, (unit, x) in self.columns.items()},
        }

    @property
    def report(self) -> Report:
        """Mean, least and greatest torque, and some of the poses."""
        return summary(self.system.title, self._blocks())

    def _blocks(self) -> Iterator[Block]:
        low, high = int(np.argmin(self.torque)), int(np.argmax(self.torque))
        turn = (
            Message("of {name}, at {rate} rad/s", name=self.along, rate=number_text(self.rate))
            if self.rate
            else Message("of {name}, turned slowly: without inertia", name=self.along)
        )
        yield from entries(
            entry(Message("turn"), turn),
            entry(Message("mean"), f"{number_text(self.mean)} N m"),
            entry(Message("least"), self._at(low)),
            entry(Message("greatest"), self._at(high)),
        )
        n = len(self.angles) - 1
        shown = sorted({round(k * n / _N_SHOWN) for k in range(_N_SHOWN + 1)})
        named = {k: v for k, v in self.columns.items() if k in self.system.measures or k.startswith("torque")}
        head = [
            f"{name} [{'deg' if name == self.along else unit}]"
            if name in self.system.measures
            else Message("torque of {name} [N m]", name=self.along)
            for name, (unit, _x) in named.items()
        ]
        values = [np.degrees(x) if name == self.along else x for name, (_unit, x) in named.items()]
        rows = [[number_text(float(x[k])) for x in values] for k in shown]
        title = Message("Driving torque over a turn, at {k} of {n} poses", k=len(shown), n=n + 1)
        yield Section((title,), tuple(table(rows, head)))

    def _at(self, k: int) -> str:
        where = number_text(float(np.degrees(self.angles[k])))
        return Message(
            "{torque} N m at {name} = {angle} deg, of the poses looked at",
            torque=number_text(float(self.torque[k])),
            name=self.along,
            angle=where,
        )


def _without_round_off(x: Array) -> Array:
    return np.where(np.abs(x) <= _ROUND_OFF * np.nanmax(np.abs(x), initial=0.0), 0.0, x)


def _plain(x: Array) -> list[float | None]:
    return [None if np.isnan(value) else float(value) for value in x]


def _is_angle(measure: Measure | NonholonomicForm) -> bool:
    return not isinstance(measure, NonholonomicForm) and measure.dimension == DIMENSIONLESS


@in_words
def over_a_turn(
    system: System,
    along: str | None = None,
    *,
    rate: float | None = None,
    n: int = N_POSES,
    csv: str | Path | None = None,
    plot: str | Path | None = None,
) -> OverTurn:
    """The torque that turns an angle once round, and what else is so on the way.

    along: a named angle (the one that is driven, else the first); rate: how fast it turns evenly [rad/s] (that of the
    driver or of the start; 0: slowly, without inertia); n: poses of the turn; csv, plot: files to write.

    Raises InputError for a name that is no angle, CannotAnswer where the mechanism cannot be turned all round."""
    if n < _FEWEST:
        raise InputError(Message("a turn is looked at in {n} poses at least", n=_FEWEST))
    name = _angle_of(system) if along is None else along
    measure = named_measure(system, name)
    if measure.dimension != DIMENSIONLESS:
        raise InputError(Message("{name} is no angle of the model.{hint}", name=name, hint=""))
    driven = [row for row in system.constraint_rows if _drives(system, row.connection) and row.measure == measure]
    own = _own_rate(system, name, [row.target for row in driven if row.target is not None])
    w = own if rate is None else rate
    loose = replace(system, constraint_rows=tuple(row for row in system.constraint_rows if row not in driven))
    reference = Reference(loose)
    q = reference.assemble()
    begin = reference.snapshot(q, 0.0 * q).value(measure)
    way = math.copysign(math.tau, w) if w else math.tau
    duration = abs(way / w) if w else 1.0

    def course(t: float) -> Sequence[float]:
        return begin + way * t / duration, w, 0.0

    motion: Mapping[str, Any] = {name: course}
    times = [k * duration / n for k in range(n + 1)]
    found = inverse_dynamics(loose, motion, times)
    torque = found.forces[name]
    if np.isnan(torque).any():
        raise CannotAnswer(Message("the torque that drives {name} is not unique", name=name))
    result = OverTurn(loose, name, w, begin + way * np.arange(n + 1) / n, torque, found)
    if csv is not None:
        result.write_csv(csv)
    if plot is not None:
        result.plot(plot)
    return result


def _drives(system: System, connection: str) -> bool:
    return isinstance(system.connections.get(connection), Driver)


def _angle_of(system: System) -> str:
    """The angle that is driven, else the first that is named."""
    angles = {name: m for name, m in system.measures.items() if m.dimension == DIMENSIONLESS}
    driven = [row.measure for row in system.constraint_rows if _drives(system, row.connection)]
    found = [name for name, m in angles.items() if m in driven] or list(angles)
    if not found:
        raise InputError(Message("the model names no angle; write for example measures: {{psi: angle of crank}}"))
    return found[0]


def _own_rate(system: System, name: str, laws: Sequence[Expr]) -> float:
    """How fast the model turns the angle: by its driver at the start, or as the start says; 0 where it does not."""
    reference = Reference(system)
    for law in laws:
        return reference.number(substitute(differentiate(law, "t"), {"t": number(0)}))
    given = system.start_rates.get(name)
    return 0.0 if given is None else reference.number(given)
