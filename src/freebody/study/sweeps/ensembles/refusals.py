"""What an ensemble does not follow, by name."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message, in_turn, lines
from freebody.numeric.engine.motion import EXPLICIT
from freebody.numeric.options import SimulationOptions
from freebody.study.sweeps.ensembles.equations import series_of
from freebody.study.sweeps.records.base import Record
from freebody.system.system import System


def check_can_follow(system: System, records: Sequence[Record], options: SimulationOptions) -> None:
    """Raises CannotAnswer saying everything that needs the engine."""
    reasons = [*_of_model(system), *_of_records(system, records), *_of_options(options)]
    if reasons:
        raise CannotAnswer(refused(reasons))


def refused(reasons: Sequence[str]) -> str:
    """That an ensemble does not follow a model, and why."""
    return lines(
        [Message("the compiled equations cannot follow this motion; leave out --device to use the engine:"), *reasons]
    )


def _of_model(system: System) -> Iterator[str]:
    bounded = [bound.row for bound in system.bounds] + [rub.row for rub in system.dry_friction]
    bounded += [row for row in system.constraint_rows if row.unilateral]
    changing = list(dict.fromkeys(row.connection for row in bounded))
    if changing:
        yield Message("{names} may open, close, stick or slip", names=in_turn(changing))
    if system.blows:
        yield Message(
            "something is struck or closes on the way: {names}", names=in_turn([b.name for b in system.blows])
        )
    if system.is_struck:
        yield Message("the motion starts with a blow")


def _of_records(system: System, records: Sequence[Record]) -> Iterator[str]:
    for record in records:
        seen = record.seen
        series = None if seen is None else series_of(system, seen.series)
        if seen is None:
            yield Message(
                "'{text}': only values at an instant or at the end, and extremes, can be recorded", text=record.text
            )
        elif series is None:
            yield Message("'{text}': only measures, their rates and accelerations can be recorded", text=record.text)
        elif seen.side and series.order == 2:
            yield Message("'{text}': extremes of accelerations cannot be recorded", text=record.text)
    if not records:
        yield Message("nothing is recorded")


def _of_options(options: SimulationOptions) -> Iterator[str]:
    if options.method not in ("auto", EXPLICIT):
        yield Message("only the method {method} is available", method=EXPLICIT)
    for name in ("step", "max_step"):
        if getattr(options, name) is not None:
            yield Message("steps follow from the tolerance; {name} does not apply", name=name)
    if options.verify:
        yield Message("a second, finer run (verify) is not available")
    if math.isfinite(options.max_seconds):
        yield Message("a limit by the clock (max_seconds) is not available")
