"""Where along a slider something begins or ceases to happen, where no formula says it: an event of the motion within
the time that is shown, a question that the numeric route can answer, the start itself. The motion is followed at some
values of one name, all others as they are; where what happens differs between two of them, the place is halved down to
what a slider can be set to. What comes and goes between two of these values is not found.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import pairwise

import numpy as np

from freebody.budgets import allowed
from freebody.errors import FreebodyError
from freebody.language.units import parse_quantity
from freebody.messages import Message
from freebody.progress import busy_with
from freebody.studio.reading import checked_system
from freebody.studio.telling import told
from freebody.studio.wire.motions import Mark, MarksAnswer, MarksRequest, Range
from freebody.study.simulation.simulate import Simulation, simulate
from freebody.study.simulation.simulator import has_phases
from freebody.study.sweeps.answers import AnswerEvaluator
from freebody.study.sweeps.evaluators import not_admissible, refused_by_reader
from freebody.study.sweeps.statuses import NUMBERS
from freebody.study.sweeps.varied import varied, with_values
from freebody.system.system import System

_MOTIONS = 240  # of all sliders together
_ROWS = 12_000  # of the constraints and bounds in all of them
_FEWEST, _MOST = 5, 17  # values along a slider
_HALVED = 12  # times, which leaves less than a slider can be set to
_TOLERANCE = 1e-6  # of these motions
_REFUSED, _NONE = Message("the model does not allow the value"), Message("the motion cannot begin")
_ALWAYS = frozenset(("start", "zero"))  # kinds of events that say how a motion begins


def changes(request: MarksRequest) -> MarksAnswer:
    """Raises ModelError where the text is no model."""
    system = checked_system(request.text)
    # a motion that cannot change its law has no events of its own
    without_formula = _without_formula(system)
    if not request.ranges or not system.has_values or not (has_phases(system) or without_formula):
        return MarksAnswer(marks=[])
    n = min(allowed(_MOTIONS), allowed(_ROWS) // max(1, len(system.rows) + len(system.bounds)))
    marks: list[Mark] = []
    for k, each in enumerate(request.ranges):
        busy_with(f"{k + 1} / {len(request.ranges)}")
        try:
            along = _Along.of(system, without_formula, each, request.until, n // len(request.ranges))
        except FreebodyError:  # it cannot be varied: a function of time
            continue
        found = [(at, told(said, request.language)) for at, said in along.changes()]
        marks += [
            Mark(name=each.name, at=at, words=[said for other, said in found if other == at])
            for at in sorted({at for at, _said in found})
        ]
    return MarksAnswer(marks=marks)


def _without_formula(system: System) -> list[AnswerEvaluator]:
    found = (AnswerEvaluator(system, question) for question in system.questions)
    return [evaluator for evaluator in found if not evaluator.forms]


@dataclass
class _Along:
    """One name along its slider. read: the system of the text, system: that in which the name is a parameter;
    evaluators: of the questions without a formula; most: values that are looked at"""

    read: System
    system: System
    parameter: str
    unit: float
    range: Range
    until: float
    evaluators: Sequence[AnswerEvaluator]
    most: int
    _known: dict[float, frozenset[str]] = field(default_factory=dict[float, frozenset[str]])
    _looked: set[float] = field(default_factory=set[float])
    _last: tuple[dict[str, float], Simulation | None] | None = None

    @classmethod
    def of(cls, own: System, evaluators: Sequence[AnswerEvaluator], along: Range, until: float, most: int) -> _Along:
        """evaluators: of the system as it is. Raises InputError for a name that cannot be varied."""
        system, [one] = varied(own, [along.name])
        unit = parse_quantity(f"1 {along.unit}".strip()).value
        found = (
            evaluators if system is own else _without_formula(system)
        )  # a start value is a parameter of its own there
        return cls(own, system, one.parameter, unit, along, until, found, most)

    def happens(self, at: float) -> frozenset[str]:
        """All that can be said of a motion with this value."""
        if at not in self._known:
            self._looked.add(at)
            self._known[at] = frozenset(self._happens(self._values(at)))
        return self._known[at]

    def _values(self, at: float) -> dict[str, float]:
        return {self.parameter: self.unit * at}

    def _happens(self, values: dict[str, float]) -> Iterator[str]:
        if impossible := self._impossible(values):
            yield impossible
            return
        yield from self._events(values)
        for said, evaluator in self._asked.items():
            if evaluator.alone(values).status == NUMBERS:
                yield said

    def _is_said(self, said: str, at: float) -> bool:
        """Whether one thing can be said of a motion: nothing else of it is looked at."""
        if at in self._known:
            return said in self._known[at]
        self._looked.add(at)
        values = self._values(at)
        impossible = self._impossible(values)
        if impossible or said in (_REFUSED, _NONE):
            return said == impossible
        if said in self._asked:
            return self._asked[said].alone(values).status == NUMBERS
        return said in self._events(values)

    def _impossible(self, values: dict[str, float]) -> str:
        """Why there is no motion; nothing where there is one."""
        if not_admissible(self.system, values) or refused_by_reader(self.read, values):
            return _REFUSED
        return _NONE if self._motion(values) is None else ""

    def _motion(self, values: dict[str, float]) -> Simulation | None:
        """None where it cannot begin. The last one is kept: what it is asked for comes one after the other."""
        if self._last is None or self._last[0] != values:
            try:
                found = simulate(with_values(self.system, values), self.until, tolerance=_TOLERANCE)
            except (FreebodyError, ArithmeticError):
                found = None
            self._last = (values, found)
        return self._last[1]

    def _events(self, values: dict[str, float]) -> set[str]:
        found = self._motion(values)
        names = {event.name for event in found.events if event.kind not in _ALWAYS} if found is not None else set[str]()
        return {Message("{event}, within {until:g} s", event=name, until=self.until) for name in names}

    @cached_property
    def _asked(self) -> dict[str, AnswerEvaluator]:
        return {Message("{question} has a value", question=each.name): each for each in self.evaluators}

    def changes(self) -> Iterator[tuple[float, str]]:
        """Where what happens is not the same on both sides, with what that is."""
        n = max(_FEWEST, min(_MOST, self.most // 2))
        values = np.linspace(self.range.low, self.range.high, n).tolist()
        for low, high in pairwise(values):
            differs = self.happens(low) ^ self.happens(high)
            for said in sorted(differs & {_REFUSED, _NONE} or differs):  # without a motion nothing happens in it
                yield self._between(low, high, said), said

    def _between(self, low: float, high: float, said: str) -> float:
        """Where it changes between two values."""
        is_low = said in self.happens(low)
        for _ in range(_HALVED):
            middle = 0.5 * (low + high)
            if middle not in self._looked and len(self._looked) >= self.most:
                break
            low, high = (middle, high) if self._is_said(said, middle) == is_low else (low, middle)
        return 0.5 * (low + high)
