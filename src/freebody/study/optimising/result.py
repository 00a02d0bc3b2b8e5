"""What an optimisation has found: the best case, or a Pareto front, and how sure it is."""

from __future__ import annotations

import csv
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from freebody.language.sentences import Message
from freebody.numeric.jets import Array
from freebody.present.charts.lines import line_chart
from freebody.present.files import check_writable, replaced
from freebody.present.lines import amount_text, number_text
from freebody.present.picture.picture import Picture
from freebody.present.report.blocks import Block, Figure, Report, Section
from freebody.present.report.result import Result
from freebody.present.report.results import entries, entry, notes, summary, table
from freebody.study.optimising.conditions import Conditions
from freebody.study.optimising.problem import Problem
from freebody.study.optimising.quantities import Quantity
from freebody.study.optimising.slopes import KEPT, Run

if TYPE_CHECKING:
    from freebody.system.system import System

_MOST_SHOWN = 15  # cases of a front in a table


@dataclass(frozen=True, repr=False)
class Optimum(Result):
    """u: (m, n) cases in parts of ranges, of which there is one for one goal; goal_values: (m, n_goals) in SI; missed:
    by how much limits are missed in their sizes, 0 where they are kept; known: of a local optimum; runs: by start."""

    problem: Problem
    method: str
    u: Array
    goal_values: Array
    missed: float
    known: Conditions | None = None
    runs: tuple[Run, ...] = ()
    n_starts: int = 0
    n_same: int = 0
    generations: int = 0
    files: tuple[Path, ...] = ()

    @property
    def system(self) -> System:
        return self.problem.given

    @property
    def is_front(self) -> bool:
        return len(self.problem.goals) > 1

    @property
    def is_complete(self) -> bool:
        """Whether a case keeps all limits."""
        return self.missed <= KEPT

    @property
    def values(self) -> dict[str, float]:
        """By name, in SI; of a front that of its first case."""
        return self._case(0)

    @property
    def value(self) -> float:
        """Of the goal, in SI."""
        return float(self.goal_values[0, 0])

    @property
    def front(self) -> list[tuple[dict[str, float], tuple[float, ...]]]:
        """Cases of the Pareto front: values by name, and goals in SI."""
        return [(self._case(k), tuple(map(float, goals))) for k, goals in enumerate(self.goal_values)]

    @property
    def optimised(self) -> System:
        """The system with the parameters that were found; start values are those of `values`."""
        own = {name: x for name, x in self.values.items() if name in self.system.parameters}
        return self.system.with_parameters(**own)

    def _case(self, k: int) -> dict[str, float]:
        x = self.problem.values(self.u[k])
        return {v.name: float(x[i]) for i, v in enumerate(self.problem.names)}

    # -- words --------------------------------------------------------------------------------
    @property
    def local(self) -> str:
        """What is known of it as a local optimum."""
        if self.known is None:
            return Message("not examined: an evolution compares cases with each other only")
        how = "" if self.problem.is_exact else Message(" (slopes by differences)")
        if self.known.order == "not shown":
            return Message(
                "not shown: the first-order conditions are missed by {x:.1e}{how}", x=self.known.residual, how=how
            )
        if self.known.order == "stationary":
            return Message(
                "the first-order conditions hold (to {x:.1e}); the second-order ones do not decide{how}",
                x=self.known.residual,
                how=how,
            )
        return Message(
            "strict local optimum: first-order (to {x:.1e}) and second-order conditions hold in numbers{how}",
            x=self.known.residual,
            how=how,
        )

    @property
    def globally(self) -> str:
        """What is known of it among all cases."""
        if self.runs and self.problem.is_linear and self.known is not None and self.known.order != "not shown":
            return Message("goal and limits are linear: no case within the bounds is better")
        if self.runs:
            return Message(
                "not proved: the best of {n} starts, to which {k} of them led", n=self.n_starts, k=self.n_same
            )
        return Message("not proved: the best of {n:,} cases that were looked at", n=self.problem.n_cases)

    @property
    def failures(self) -> list[tuple[str, str, int, str]]:
        """Cases on the way that had no number: of what, their status, how many, and why the first of them."""
        found: dict[tuple[str, str], tuple[int, str]] = {}
        for one, count in self.problem.failed.items():
            n, why = found.get((one.of, one.status), (0, one.why))
            found[one.of, one.status] = n + count, why
        return [(of, status, n, why) for (of, status), (n, why) in found.items()]

    # -- plain data and files -----------------------------------------------------------------
    def to_plain(self) -> dict[str, Any]:
        """Plain data: values with units, limits with their multipliers, what is known; all cases of a front."""
        goals = [g.words for g in self.problem.goals]
        cases = [{"values": values, "goals": dict(zip(goals, reached, strict=True))} for values, reached in self.front]
        return {
            "title": self.system.title,
            "method": self.method,
            "units": self._units(),
            **({"front": cases} if self.is_front else cases[0]),
            "feasible": self.is_complete,
            "missed": self.missed,
            "local": None if self.is_front else str(self.local),
            "global": str(self.globally),
            "active": [
                {"limit": a.text, "multiplier": a.multiplier, "sensitivity": a.cost, "unit": a.unit}
                for a in (self.known.active if self.known else ())
            ],
            "starts": {"n": self.n_starts, "same": self.n_same} if self.runs else None,
            "cases": self.problem.n_cases,
            "failed": [{"of": of, "status": status, "count": n, "reason": why} for of, status, n, why in self.failures],
        }

    def _units(self) -> dict[str, str]:
        return {v.name: v.unit for v in self.problem.names} | {g.words: g.quantity.unit for g in self.problem.goals}

    def write(self, path: str | Path) -> list[Path]:
        """Writes a report, or, as .csv, the cases: of the front, or where each start led."""
        path = Path(path)
        if path.suffix != ".csv":
            return super().write(path)
        u = self.u if self.is_front or not self.runs else np.array([run.u for run in self.runs])
        goals = self.goal_values if len(u) == len(self.u) else np.array([[run.value] for run in self.runs])
        head = [f"{v.name} [{v.unit}]" for v in self.problem.names]
        head += [f"{g.words} [{g.quantity.unit or '1'}]" for g in self.problem.goals]
        missed = [run.missed for run in self.runs] if len(u) != len(self.u) else []
        with replaced(path) as file, file.open("w", encoding="utf-8", newline="") as out:
            writer = csv.writer(out)
            writer.writerow([*head, *(["limits missed by"] if missed else [])])
            for k, row in enumerate(np.hstack((self.problem.values(u), goals))):
                writer.writerow([*(repr(float(x)) for x in row), *([repr(missed[k])] if missed else [])])
        return [path]

    # -- report -------------------------------------------------------------------------------
    @property
    def report(self) -> Report:
        return summary(self.system.title, self._blocks())

    def _blocks(self) -> Iterator[Block]:
        yield from entries(
            *(
                entry(Message("goal"), _goal(g.words, g.quantity, None if self.is_front else self.value))
                for g in self.problem.goals
            ),
            *(entry(Message("limit"), limit.text) for limit in self.problem.limits),
            *(
                []
                if self.is_complete
                else [
                    entry(
                        Message("note"),
                        Message(
                            "no case was found that keeps all limits: the nearest misses them by {x:.2g} of their size",
                            x=self.missed,
                        ),
                    )
                ]
            ),
            *([] if self.is_front else [entry(Message("local"), str(self.local))]),
            entry(Message("global"), str(self.globally)),
            *notes(
                (
                    Message(
                        "{cases}: {name}: {why}",
                        cases=Message("1 case") if n == 1 else Message("{n} cases", n=n),
                        name=of,
                        why=Message("{status}: {why}", status=status, why=why)
                        if why
                        else Message("{status}", status=status),
                    )
                    for of, status, n, why in self.failures
                ),
                Message("failed"),
            ),
        )
        if self.is_front:
            yield from self._front()
            return
        rows = [[v.name, number_text(self.values[v.name]), v.unit] for v in self.problem.names]
        unit = Message("unit")
        yield Section((Message("Found"),), tuple(table(rows, ["", Message("value"), unit])))
        if self.known is not None and self.known.active:
            costs = [[a.text, number_text(a.cost, 1e-12), a.unit] for a in self.known.active]
            head = [Message("active"), Message("goal per bound"), unit]
            note = Message("more limits are active than needed: what each of them costs is not unique")
            said = [] if self.known.are_unique else entries(*notes([note]))
            yield Section((Message("Limits that hold it"),), (*table(costs, head), *said))

    def _front(self) -> Iterator[Block]:
        chosen = np.unique(np.linspace(0, len(self.u) - 1, min(len(self.u), _MOST_SHOWN)).round().astype(int))
        names = [
            *(f"{v.name} [{v.unit}]" for v in self.problem.names),
            *(_label(g.quantity) for g in self.problem.goals),
        ]
        every = np.hstack((self.problem.values(self.u), self.goal_values))
        rows = [[number_text(float(x)) for x in every[k]] for k in chosen]
        title = Message("Pareto front, {k} of {n} cases", k=len(chosen), n=len(self.u))
        yield Section((title,), tuple(table(rows, names)))
        if len(self.problem.goals) == 2:
            picture = self.chart()
            yield Figure(picture, (picture.title,), 1)

    def chart(self) -> Picture:
        """The front: the second goal over the first one; of one goal its value by start."""
        if self.is_front:
            first, second = (g.quantity for g in self.problem.goals[:2])
            x, y = self.goal_values[:, 0], self.goal_values[:, 1]
            title = self.in_language(Message("Pareto front"))
            return line_chart(title, _label(first), x, _label(second), [(title, y)], is_joined=False)
        goal = self.problem.goals[0].quantity
        values = np.array([run.value if run.is_good else np.nan for run in self.runs] or [self.value])
        counts = np.arange(1, len(values) + 1, dtype=np.float64)
        title, start = self.in_language(Message("value by start")), self.in_language(Message("number of the start"))
        return line_chart(title, start, counts, _label(goal), [(title, values)], is_joined=False)


def _label(quantity: Quantity) -> str:
    return f"{quantity.text} [{quantity.unit}]" if quantity.unit else quantity.text


def _goal(words: str, quantity: Quantity, value: float | None) -> str:
    return words if value is None else f"{words} = {amount_text(value, quantity.unit)}"


def check_path(path: Path) -> None:
    """Raises InputError if the result cannot be written there."""
    if path.suffix == ".csv":
        check_writable(path)
        return
    from freebody.present.report.write import check_report_path

    check_report_path(path)
