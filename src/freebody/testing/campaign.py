"""Many random models, each put through every study in a forked process of its own.

What a model leaves in memory ends with its process, and a crash of compiled code is one more outcome. A process tells
what it begins and what came of it line by line; where it ends without having told all, the study that it was in
has crashed, and another process takes the rest.
"""

from __future__ import annotations

import gc
import json
import math
import os
import signal
import sys
import time
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import IO, Any

from freebody.api import System
from freebody.errors import InputError
from freebody.testing.models import maker
from freebody.testing.outcomes import End, Outcome, OutOfWork, limited, run, untyped

READ = "read"  # the study before all others: the model is drawn and read
_MEMORY = 4 << 30  # bytes, of one process
_GRACE = 3.0  # times the limit, for compiled code that hears no alarm
_FIRST = """
parameters: {m: 1 kg}
ground: {lines: {floor: {along: right}}}
bodies: {p: {disk: {mass: m, radius: 1 m}}}
connections: {c: {contact: {between: [p, floor], friction: 0.1}}}
loads: {g: {gravity: 9.81 m/s^2}}
questions: [{find: acceleration of p}]
"""


@dataclass(frozen=True)
class TimedOutcome:
    """An outcome with the seed of its model and the processor time of its study [s]."""

    seed: int
    outcome: Outcome
    seconds: float

    @property
    def study(self) -> str:
        return self.outcome.study.partition(":")[0]

    def to_plain(self) -> dict[str, Any]:
        o = self.outcome
        plain: dict[str, Any] = {"seed": self.seed, "study": o.study, "end": o.end.value, "message": o.message}
        return plain | {"place": o.place, "seconds": round(self.seconds, 3)}


def campaign(seeds: Iterable[int], names: Sequence[str], seconds: float) -> Iterator[TimedOutcome]:
    """What comes of the studies of these names for the models of these seeds, each study with a limit of processor time
    [s]. Raises InputError where processes cannot be forked."""
    if not hasattr(os, "fork"):
        raise InputError("random models are studied in forked processes, which this system does not have")
    for name in names:  # what every process needs is loaded once
        run(name, System.from_text(_FIRST))
    gc.collect()
    gc.freeze()
    try:
        for seed in seeds:
            left = [READ, *names]
            while left:
                found, left = _in_child(seed, left, seconds)
                yield from found
    finally:
        gc.unfreeze()


def _in_child(seed: int, names: list[str], seconds: float) -> tuple[list[TimedOutcome], list[str]]:
    """The studies in a process of their own, as far as it survives them; and the names of those that are left."""
    reading, writing = os.pipe()
    sys.stdout.flush()
    child = os.fork()
    if child == 0:
        try:
            os.close(reading)
            with os.fdopen(writing, "w", encoding="utf-8") as out:
                _tell(seed, names, seconds, out)
        finally:
            os._exit(0)
    os.close(writing)
    found: list[TimedOutcome] = []
    begun = names[0]
    with os.fdopen(reading, encoding="utf-8") as lines:
        for line in lines:
            begun, plain = json.loads(line)
            if plain:
                outcome = Outcome(plain["study"], End(plain["end"]), plain["message"], plain["place"])
                found.append(TimedOutcome(seed, outcome, plain["seconds"]))
    _pid, status = os.waitpid(child, 0)
    if not begun:
        return found, []
    found.append(TimedOutcome(seed, _of_death(begun, os.waitstatus_to_exitcode(status), seconds), 0.0))
    return found, [] if begun == READ else names[names.index(begun) + 1 :]


def _of_death(study: str, code: int, seconds: float) -> Outcome:
    """What became of a study in which its process ended."""
    if code == -signal.SIGXCPU:
        return Outcome(study, End.TOO_LONG, f"no end after {_GRACE:g} times {seconds:g} s in a call without an alarm")
    return Outcome(
        study, End.CRASHED, signal.strsignal(-code) or f"signal {-code}" if code < 0 else f"exit code {code}"
    )


def _tell(seed: int, names: Sequence[str], seconds: float, out: IO[str]) -> None:
    """Runs the studies, and tells what begins, what came of it, and the end, a line of JSON each: the study that is
    under way, and an outcome."""

    def tell(study: str, outcome: dict[str, Any] | None = None) -> None:
        out.write(json.dumps([study, outcome]) + "\n")
        out.flush()

    system: System | None = None
    found: list[Outcome] = []
    for name in names:
        tell(name)
        _limit_process(seconds)
        before = time.process_time()
        if system is None:
            system, found = _read(seed, seconds)
        if name != READ and system is not None:
            found = run(name, system, seconds)
        for outcome in found:  # of reading, where that is what ends here
            tell(name, TimedOutcome(seed, outcome, time.process_time() - before).to_plain())
        if system is None:
            break
    tell("")


def _read(seed: int, seconds: float) -> tuple[System | None, list[Outcome]]:
    """The model of a seed, and what came of drawing it: elements that could be neither read nor refused."""
    one = maker(seed)
    try:
        with limited(_GRACE * seconds):
            system = System.from_data(one.model())
    except OutOfWork:
        return None, [Outcome(READ, End.TOO_LONG, f"no end after {_GRACE * seconds:g} s of processor time")]
    except Exception as error:
        return None, [untyped(READ, error)]
    return system, [untyped(READ, error) for _data, error in one.faults] or [Outcome(READ, End.ANSWERED)]


def _limit_process(seconds: float) -> None:
    """The study that follows is killed where it uses far more than the limit, or more memory than a model may."""
    import resource

    until = math.ceil(time.process_time() + _GRACE * seconds) + 1
    resource.setrlimit(resource.RLIMIT_CPU, (until, resource.getrlimit(resource.RLIMIT_CPU)[1]))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_AS, (_MEMORY, resource.getrlimit(resource.RLIMIT_AS)[1]))


# -- the command ------------------------------------------------------------------------------
def report(told: Iterable[TimedOutcome], file: IO[str] | None = None) -> Iterator[str]:
    """A line for each defect as it comes, at the end a table of counts: studies by ends."""
    counts: Counter[tuple[str, End]] = Counter()
    n_models = 0
    for one in told:
        o = one.outcome
        if file is not None:
            file.write(json.dumps(one.to_plain()) + "\n")
            file.flush()
        n_models += one.study == READ
        counts[one.study, o.end] += 1
        if o.end.is_defect:
            yield f"seed {one.seed}  {o.study}  {o.end.value}: {o.message}" + (f" ({o.place})" if o.place else "")
    yield from table(counts, n_models)


def table(counts: Mapping[tuple[str, End], int], n_models: int) -> Iterator[str]:
    """How often each study ended how."""
    ends = [end for end in End if any(e is end for _study, e in counts)]
    yield f"{n_models} models"
    yield "".join([f"{'':<12}", *(f"{end.value:>{len(end.value) + 3}}" for end in ends)]).rstrip()
    for study in dict.fromkeys(study for study, _end in counts):
        yield "".join([f"{study:<12}", *(f"{counts.get((study, end), 0):>{len(end.value) + 3}}" for end in ends)])
