"""Motions in many cases: each is followed by the engine, which lets other threads go on meanwhile."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from freebody.errors import CannotAnswer, FreebodyError, InputError
from freebody.language.sentences import Message
from freebody.numeric.contact.words import event_names
from freebody.numeric.options import SimulationOptions
from freebody.study.simulation.simulate import simulate
from freebody.study.simulation.simulator import Simulator
from freebody.study.sweeps.evaluators import Column, Evaluator, Found, Values
from freebody.study.sweeps.records import read_record
from freebody.study.sweeps.records.base import Followed, Record
from freebody.study.sweeps.statuses import NO_VALUE, NOT_ADMISSIBLE, NOT_ASSEMBLED
from freebody.study.worded import FAILED
from freebody.system.system import System


class MotionEvaluator(Evaluator):
    """What is recorded of the motion up to a time, in every case."""

    def __init__(
        self,
        system: System,
        records: Sequence[str],
        until: float,
        options: SimulationOptions,
        events: Sequence[str] = (),
        read: System | None = None,
    ) -> None:
        """events: what to look for besides, as "stop when y = 0". Raises InputError for records and events that cannot
        be read."""
        super().__init__(system, read)
        options.check_asked(until)
        self.name = "motion"
        self.records: tuple[Record, ...] = tuple(read_record(system, text) for text in records)
        self.columns = tuple(Column(r.text, r.unit, f"{r.text} of the motion") for r in self.records)
        self.until = until
        self.events = tuple(dict.fromkeys([*events, *(e for r in self.records for e in r.events)]))
        self.at = tuple(sorted({t for r in self.records for t in r.times if t <= until}))
        is_looked_at = any(r.needs_course for r in self.records)
        self.options = options if is_looked_at or options.every else replace(options, every=until)
        self._check_events()

    def _check_events(self) -> None:
        """Raises InputError for events that cannot be read or that no contact has; what else is wrong with the model's
        own numbers is no matter of the sweep."""
        try:
            simulator = Simulator(self.system, {}, self.events, by_steps=self.options.by_steps)
        except InputError:
            raise
        except (FreebodyError, *FAILED):
            return
        known = [] if simulator.bounded is None else event_names(simulator.bounded)
        known += [str(blow.event.text) for blow in self.system.blows]
        for record in self.records:
            if record.named and record.named not in known:
                raise InputError(
                    Message(
                        "'{text}': no contact does that. A measure reaches a value, as time when x = 1 m, and at "
                        "contacts there is: {names}",
                        text=record.text,
                        names=", ".join(known) or "nothing",
                    )
                )

    def alone(self, values: Values) -> Found:
        nothing = (math.nan,) * len(self.columns)
        if why := self.refused(values):
            return Found(nothing, NOT_ADMISSIBLE, why)
        try:
            result = simulate(
                self.system, self.until, options=self.options, values=values, events=self.events, at=self.at
            )
        except CannotAnswer as error:
            return Found(nothing, NOT_ASSEMBLED, str(error))
        except (FreebodyError, ValueError, *FAILED) as error:
            return Found(nothing, NO_VALUE, str(error))
        motion = Followed(result)
        try:
            numbers = tuple(_number(record, motion) for record in self.records)
        except (FreebodyError, ValueError, *FAILED) as error:
            return Found(nothing, NO_VALUE, str(error))
        return Found(numbers, str(result.status), "" if result.is_complete else result.message)


def _number(record: Record, motion: Followed) -> float:
    x = record.value(motion)
    return x if math.isfinite(x) else math.nan
